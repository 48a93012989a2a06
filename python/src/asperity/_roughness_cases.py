"""The roughness as `asperity.friction` takes it: all of it, or what is known, with cases for what is not."""

from __future__ import annotations

import math
import numbers
from itertools import product
from statistics import NormalDist
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _caller
from ._surface_file import from_mean_deviation
from ._typical_roughness import BANDWIDTH, PROCESSES, Known, deviation_of, slope_of
from .errors import Error, Status
from .params import Params
from .results import ValidityWarning

Array = npt.NDArray[np.float64]

HEIGHTS = ("Ra", "Rq", "Sq")
_AREAL = {"Sq", "Sdq", "Sds", "Ssc"}
_MOMENTS = {"m0", "m2", "m4"}
_SUMMITS = {"height_std", "summit_radius", "summit_density", "asperity_count"}
_MISSING = (
    "the roughness is missing: give Sq, Sdq and Sds or Ssc; or m0, m2 and m4; or height_std, summit_radius and summit_density; "
    f"or Ra or Rq with RSm of a profile; or process, one of {', '.join(PROCESSES)}, with Ra or Rq if that is known"
)


class Roughness(NamedTuple):
    """What is known of the roughness: how parameters are made of it, and cases with their probabilities, the middle first."""

    make: Any
    cases: list[dict[str, Any]]
    probability: Array
    rests_on: tuple[str, ...] = ()
    narrow: tuple[str, ...] = ()


def roughness_cases(process: str | None, surface: dict[str, Any]) -> Roughness:
    """Of what was given by name; `TypeError` where that is not enough, with all that would be."""
    if process is not None or surface.keys() & {"Rq", "RSm"}:
        return _of_profile(process, surface)
    surface = from_mean_deviation(surface)
    for make, names, needed in (
        (Params.from_iso25178, _AREAL, {"Sq", "Sdq"}),
        (Params.from_spectral_moments, _MOMENTS, _MOMENTS),
        (Params.si, _SUMMITS, {"height_std"}),
    ):
        if surface.keys() & names:
            if not needed <= surface.keys():
                break
            return Roughness(make, [{name: surface[name] for name in surface if name in names}], np.ones(1))
    raise TypeError(_MISSING)


def _of_profile(process: str | None, surface: dict[str, Any]) -> Roughness:
    """Cases of a surface of which less than three numbers are known; Gauss's nodes of what is not, log-normally."""
    if process is not None and process not in PROCESSES:
        raise Error(f"process = {process!r}: must be one of {', '.join(PROCESSES)}", Status.INVALID_PARAMETER)
    heights = [name for name in HEIGHTS if name in surface]
    if len(heights) > 1:
        raise TypeError(f"{' and '.join(heights)} both tell the height of the roughness: give one of them")
    other = sorted(surface.keys() & ((_AREAL | _MOMENTS | _SUMMITS) - {"Sq"}))
    if other:
        raise TypeError(f"{other[0]}: is not for a profile or a process; give all of the roughness, or Ra or Rq alone with those")
    if (not heights and process is None) or ("RSm" not in surface and process is None):
        raise TypeError(_MISSING)
    rests_on, narrow = [], []
    if heights:
        deviation = Known(_positive(heights[0], surface[heights[0]]))
        if heights[0] == "Ra":
            deviation = Known(deviation_of(deviation.middle))
    else:
        deviation = Known.between(*map(deviation_of, PROCESSES[str(process)]))
    if process is not None:
        least, most = PROCESSES[process]
        if not heights:
            rests_on.append(f"Ra: {process} surfaces have {least * 1e6:g} to {most * 1e6:g} um")
            narrow.append("the height of its roughness: Ra or Rq")
        elif not deviation_of(least) <= deviation.middle <= deviation_of(most):
            says = f"{process} surfaces have an Ra of {least * 1e6:g} to {most * 1e6:g} um: is it of this process, and in m?"
            _caller.warn(f"{heights[0]} = {surface[heights[0]]:g}: {says}", ValidityWarning)
    width = Known(_positive("RSm", surface["RSm"])) if "RSm" in surface else None
    if width is None:
        slope = slope_of(deviation.middle)
        rests_on.append(f"slope of its profile: {slope.middle:.2g} to a factor {slope.factor:g}, as assumed of machined surfaces")
        narrow.append("the mean width of its profile's elements: RSm")
    bandwidth = BANDWIDTH
    if "bandwidth" in surface:
        bandwidth = Known(_positive("bandwidth", surface["bandwidth"]))
    else:
        ends = (bandwidth.middle / bandwidth.factor, bandwidth.middle * bandwidth.factor)
        rests_on.append(f"bandwidth: not measured, {ends[0]:.0f} to {ends[1]:.0f}")
        narrow.append("how sharp its summits are: Sq, Sdq and Sds or Ssc, or a height map (asperity.surface)")
    cases, probability = [], []
    for (Rq, first), (slope_over, second), (alpha, third) in product(
        _nodes(deviation), _nodes(Known(1.0, 1.0 if width else slope_of(1e-6).factor)), _nodes(bandwidth)
    ):
        RSm = width.middle if width else 2 * math.pi * Rq / (slope_over * slope_of(Rq).middle)
        cases.append({"Rq": Rq, "RSm": RSm, "bandwidth": alpha})
        probability.append(first * second * third)
    return Roughness(Params.from_profile, cases, np.array(probability), tuple(rests_on), tuple(narrow))


def _nodes(known: Known) -> list[tuple[float, float]]:
    """Values with their probabilities, the middle first: Gauss's three for a log-normal distribution."""
    if known.factor == 1.0:
        return [(known.middle, 1.0)]
    reach = math.sqrt(3.0) * math.log(known.factor) / NormalDist().inv_cdf(0.975)
    return [(known.middle * math.exp(at * reach), part) for at, part in ((0, 2 / 3), (-1, 1 / 6), (1, 1 / 6))]


def _positive(name: str, value: Any) -> float:
    if not (isinstance(value, numbers.Real) and math.isfinite(value) and value > 0):
        raise Error(f"{name} = {value!r}: must be finite and > 0", Status.INVALID_PARAMETER)
    return float(value)
