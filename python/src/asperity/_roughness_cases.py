"""The roughness as `asperity.friction` takes it: all of it, or what is known, with cases for what is not."""

from __future__ import annotations

import math
from itertools import product
from statistics import NormalDist
from typing import Any, Callable, NamedTuple

import numpy as np
import numpy.typing as npt

from . import _caller
from ._typical_roughness import PROCESSES, SLOPE_FACTOR, Known, deviation_of, machined_slope
from .errors import Error, Status
from .params import Params, both_of, refuse_peaks
from .results import ValidityWarning

Array = npt.NDArray[np.float64]

HEIGHTS = ("Ra", "Rq", "Sq")
_AREAL = {"Sq", "Sdq", "Sds", "Ssc"}
_MOMENTS = {"m0", "m2", "m4"}
_SUMMITS = {"height_std", "summit_radius", "summit_density", "asperity_count"}
_MISSING = (
    "the roughness is missing: give Sq and Sdq; or m0 and m2; or height_std, summit_radius and summit_density; "
    f"or Ra or Rq with RSm or Rdq of a profile; or process, one of {', '.join(PROCESSES)}, with Ra or Rq if that is known"
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
    refuse_peaks(surface)
    if process is not None or surface.keys() & {"Rq", "RSm", "Rdq"}:
        return _of_profile(process, surface)
    kinds: tuple[tuple[Any, set[str], set[str], set[str]], ...] = (
        (Params.from_spectral_moments, _MOMENTS, {"m2"}, {"m0", "Ra"}),
        (Params.from_iso25178, _AREAL, {"Sdq"}, {"Sq", "Ra"}),
        (Params.si, _SUMMITS, {"height_std"}, {"height_std"}),
    )
    for make, names, needed, height in kinds:
        if surface.keys() & names:
            if not (needed <= surface.keys() and height & surface.keys()):
                break
            names = names | height
            return Roughness(make, [{name: surface[name] for name in surface if name in names}], np.ones(1))
    raise TypeError(_MISSING)


def _of_profile(process: str | None, surface: dict[str, Any]) -> Roughness:
    """Cases of a surface of which less than three numbers are known; Gauss's nodes of what is not, log-normally."""
    if process is not None and process not in PROCESSES:
        raise Error(f"process = {process!r}: must be one of {', '.join(PROCESSES)}", Status.INVALID_PARAMETER)
    heights = [name for name in HEIGHTS if name in surface]
    each: list[float] = []
    if len(heights) > 1:
        raise TypeError(f"{' and '.join(heights)} both give the height of the roughness: leave one out")
    other = sorted(surface.keys() & ((_AREAL | _MOMENTS | _SUMMITS) - {"Sq"}))
    if other:
        raise TypeError(f"{other[0]}: is not for a profile or a process; give all of the roughness, or Ra or Rq alone with those")
    if process is None and not (heights and surface.keys() & {"RSm", "Rdq"}):
        raise TypeError(_MISSING)
    rests_on, narrow = [], []
    if heights:
        (name,) = heights
        each = [deviation_of(one) if name == "Ra" else one for one in both_of(name, surface[name])]
        deviation = Known(math.hypot(*each))
    else:
        deviation = Known.between(*map(deviation_of, PROCESSES[str(process)]))
        narrow.append("the height of its roughness: Ra or Rq")
    if process is not None:
        least, most = PROCESSES[process]
        left = f"{process} surfaces have an Ra of {least * 1e6:g} to {most * 1e6:g} um"
        if not heights:
            rests_on.append(left)
        elif not all(deviation_of(least) <= one <= deviation_of(most) for one in each):
            _caller.warn(f"{heights[0]} = {surface[heights[0]]}: {left}: is it of this process, and in m?", ValidityWarning)
    slope: Callable[[float], float]
    told = [name for name in ("RSm", "Rdq") if name in surface]
    if len(told) > 1:
        raise TypeError("RSm and Rdq both give the slope of a profile: leave one out")
    if told:
        numbers = both_of(told[0], surface[told[0]])
        if len(numbers) != max(len(each), 1):
            of = heights[0] if heights else "the roughness"
            raise TypeError(f"{told[0]}: must be as many numbers as {of} has, one of each surface")
        if told == ["Rdq"]:
            slope, times = (lambda Rq: math.hypot(*numbers)), Known(1.0)
        else:
            slope = lambda Rq: 2 * math.pi * math.hypot(*(one / width for one, width in zip(each or [Rq], numbers)))
            times = Known(1.0)
    else:
        slope, times = (lambda Rq: math.hypot(*map(machined_slope, each or [Rq]))), Known(1.0, SLOPE_FACTOR)
        assumed = f"{slope(deviation.middle):.2g} to a factor {SLOPE_FACTOR:g}"
        rests_on.append(f"slope of its profile: {assumed}, as assumed of machined surfaces")
        narrow.append("the mean width of its profile's elements: RSm")
    bandwidth = {name: surface[name] for name in surface if name == "bandwidth"}
    cases, probability = [], []
    for (Rq, first), (steeper, second) in product(_nodes(deviation), _nodes(times)):
        cases.append({"Rq": Rq, "RSm": None, "Rdq": steeper * slope(Rq), **bandwidth})
        probability.append(first * second)
    return Roughness(Params.from_profile, cases, np.array(probability), tuple(rests_on), tuple(narrow))


def _nodes(known: Known) -> list[tuple[float, float]]:
    """Values with their probabilities, the middle first: Gauss's three for a log-normal distribution."""
    if known.factor == 1.0:
        return [(known.middle, 1.0)]
    reach = math.sqrt(3.0) * math.log(known.factor) / NormalDist().inv_cdf(0.975)
    return [(known.middle * math.exp(at * reach), part) for at, part in ((0, 2 / 3), (-1, 1 / 6), (1, 1 / 6))]
