"""Friction in one line: a pair of materials, the roughness, the load; a number with its band.

    import asperity

    mu = asperity.friction("steel/steel", Ra=0.8e-6, process="ground", load=20.0, nominal_area=1e-4)
"""

from __future__ import annotations

import math
import numbers
import warnings
from functools import lru_cache
from statistics import NormalDist
from typing import Any

import numpy as np
import numpy.typing as npt

from ._friction_law import FrictionLaw, as_array
from ._labelled import like
from ._roughness_cases import HEIGHTS, roughness_cases
from .errors import Error, Status
from .estimate import Estimate
from .materials import MATERIALS, PAIRS, Pair, contact
from .model import Model
from .params import CALIBRATION, STRENGTH, Params
from .results import ValidityWarning
from .uncertainty import AS_GIVEN, Strength, strength_of

Array = npt.NDArray[np.float64]

# Surfaces whose models are kept: enough for a comparison in a loop, some megabytes in all.
_KEPT = 8
# Above this plasticity index summits yield (`Warnings.PLASTIC`).
_PLASTIC_INDEX = 1.0


def friction(
    pair: str | Pair,
    *,
    load: Any,
    nominal_area: float = 1.0,
    process: str | None = None,
    interface: str | None = None,
    coverage: float = 0.95,
    **surface: Any,
) -> Estimate:
    """The friction coefficient of two materials with a roughness, at a load or at many, with its band. SI units.

    >>> estimate = asperity.friction("Si/Si", Sq=5e-9, Sdq=0.08, load=1e-3, nominal_area=1e-8)
    >>> print(f"{estimate:.1g}")
    0.4 (0.04 to 4)

    `print(estimate)` says what the number rests on and what would narrow its band. For more than the coefficient make
    `Params` and a `Model`. The models of the last surfaces are kept, so that the next call for them is fast.

    Two things widen the band:

    - The strength of the interface was not measured: a factor of 10 either way, as for `asperity.uncertainty`. Give
      `calibration_load` with `calibration_friction_coefficient`.
    - The slopes of a machined surface are assumed: the slope along a profile is 0.14 (Rq/um)^(1/2) to a factor of 4.
      Without Ra or Rq, the roughness is the usual one of the process.

    The band is log-normal, with the mean and variance of ln(mu) from both. Heights are Gaussian.

    Where summits yield (a plasticity index above 1) the contact law is elastic-plastic, without adhesion, unless you give a
    `contact_law` or a `work_of_adhesion`.

    Args:
        pair: a name in `asperity.materials.PAIRS`, as "steel/steel", in either order; or two names in `MATERIALS`, as
            "SiC/SiC", with a `work_of_adhesion`.
        load: normal load [N] on `nominal_area`; a number, an array, a pandas Series or an xarray DataArray.
        nominal_area: [m^2]; without it loads are those of a square metre: nominal pressures [Pa].
        process: how a surface of metal was machined, if its slopes were not measured: "superfinished", "lapped", "honed",
            "ground", "turned", "bored" or "milled". Give Ra or Rq of both surfaces as a list, if both are rough.
        interface: a name in `asperity.materials.INTERFACES`, whose shear strength replaces the default: `Params.with_interface`.
        coverage: probability of the band, between 0 and 1.
        **surface: the roughness, as `Params.from_iso25178` (`Sq`, `Sdq`), `Params.from_spectral_moments` (`m0`, `m2`; `Ra` of
            Gaussian heights may replace `Sq` or `m0`), `Params.from_profile` (`Ra` or `Rq`, `RSm` or `Rdq`) or `Params.si` (`height_std`, `summit_radius`, `summit_density`) take it, with a `process` `Ra`, `Rq`
            or neither; one friction measured on these surfaces, `calibration_load` [N] with `calibration_friction_coefficient`
            or `calibration_friction_force` [N], and its relative standard error `calibration_error`, 0.05 by default; and what
            is to replace the numbers of the pair or a default: `work_of_adhesion`, `slip_stress_1`, `kurtosis`, ...

    Returns:
        F/P with its band, what it rests on and what would narrow it: `Estimate`. At loads of 0 and below, where F/P is not
        finite, the band has no width.

    Raises:
        KeyError: materials that are not known; the message names the nearest.
        Error: a value that the library refuses.
        TypeError: a name that is unknown or missing.

    Warns:
        ValidityWarning: an assumption of the model that fails at one of the loads > 0, once for a surface; an Ra that the
            process does not leave.
    """
    if not isinstance(pair, Pair) and not isinstance(pair, str):
        raise TypeError(f"pair = {pair!r}: must be a name, as 'steel/steel', or one of asperity.materials.PAIRS")
    if not 0 < coverage < 1:
        raise ValueError(f"coverage = {coverage!r}: must be between 0 and 1")
    point = {name: surface.pop(name) for name in CALIBRATION if name in surface}
    roughness = roughness_cases(process, surface)
    given = _contact(pair, surface) | {name: value for name, value in surface.items() if name not in roughness.cases[0]}
    given = {name: value for name, value in given.items() if name not in HEIGHTS}
    middle = _made(roughness.make, given | roughness.cases[0], nominal_area)
    told: tuple[str, ...] = ()
    if _yields(middle) and "contact_law" not in surface and not surface.get("work_of_adhesion"):
        given |= {"contact_law": "elastic-plastic", "work_of_adhesion": 0.0}
        told = (f"summits yield, plasticity index {_plasticity_index(middle):.2g}: elastic-plastic, without adhesion",)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # said of the middle case
        cases = [_made(roughness.make, given | case, nominal_area) for case in roughness.cases]
    models = _models(tuple(_with_interface(params, interface, surface).replace(**point) for params in cases))
    value = models[0].friction_at_load(load)
    strength, narrow = strength_of(models[0]), roughness.narrow
    rests_on = strength.told
    if interface is not None and not point:
        rests_on = f"strength of the interface: that of {interface}, measured on other specimens and taken as known"
    if not point and rests_on != AS_GIVEN:
        narrow = ("one measured friction: calibration_load with calibration_friction_coefficient", *narrow)
    low = high = None
    if strength.deviation > 0 or len(models) > 1:
        low, high = _band(models, roughness.probability, load, strength, coverage)
    pressing = np.asarray(load, dtype=np.float64)
    pressing = pressing[pressing > 0]
    if pressing.size:
        models[0].warn(float(pressing.min()), float(pressing.max()))
    return Estimate(value, low, high, None if low is None else coverage, (rests_on, *roughness.rests_on, *told), narrow)


def _band(
    models: tuple[Model, ...],
    probability: Array,
    load: Any,
    strength: Strength,
    coverage: float,
) -> tuple[Any, Any]:
    """The ends of the band: log-normal, with mean and variance of ln(mu) over the cases and the strength in each.

    If friction was measured, the models meet it, and Bayes' rule gives each case a new probability and its strength a new
    distribution.
    """
    loads = as_array("load", load)
    there = loads > 0
    at = loads[there]
    spread, params = strength.deviation, models[0].params
    shift, variance = np.zeros(len(models)), np.full(len(models), spread**2)
    if strength.measured:
        error = params.calibration_error
        by_strength = np.array([_by_strength(model, np.array([params.calibration_load]))[0] for model in models])
        stresses = [model.params.slip_stress_1 for model in models]
        off = np.log(np.array(stresses) / stresses[0])  # of the middle of the strengths before
        total = by_strength**2 * spread**2 + error**2
        probability = probability * np.exp(-0.5 * (by_strength * off) ** 2 / total) / np.sqrt(total)
        probability = probability / probability.sum()
        variance = spread**2 * error**2 / total
        shift = -off * variance / spread**2
    slopes = np.array([_by_strength(model, at) for model in models])
    values = np.array([np.log(model.friction_force_at_load(at) / at) for model in models]) + slopes * shift[:, None]
    middle = probability @ values
    deviation = np.sqrt(probability @ ((values - middle) ** 2 + slopes**2 * variance[:, None]))
    reach = NormalDist().inv_cdf(0.5 + 0.5 * coverage) * deviation
    ends = []
    for end, name in ((middle - reach, "low"), (middle + reach, "high")):
        band = np.array(models[0].friction_at_load(loads), dtype=np.float64)
        band[there] = np.minimum(np.exp(end), params.max_friction_coefficient)
        ends.append(float(band) if isinstance(load, numbers.Real) else like(load, band, name))
    return ends[0], ends[1]


def _by_strength(model: Model, loads: Array) -> Array:
    """d(ln F)/d(ln c) where both slip stresses are c times theirs: F is a linear function of c, in proportion without kappa."""
    params = model.params
    if params.pressure_coefficient == 0.0:
        return np.ones(loads.shape)
    half = params.replace(slip_stress_1=params.slip_stress_1 / 2, slip_stress_2=params.slip_stress_2 / 2)
    with FrictionLaw(half) as law:
        found: Array = 2.0 * (1.0 - law.friction_force_at_load(loads) / model.friction_force_at_load(loads))
    return found


def _plasticity_index(params: Params) -> float:
    return params.composite_modulus * math.sqrt(params.height_std / params.summit_radius) / params.hardness


def _yields(params: Params) -> bool:
    return params.hardness > 0 and _plasticity_index(params) > _PLASTIC_INDEX


def _with_interface(params: Params, name: Any, surface: dict[str, Any]) -> Params:
    if name is None:
        return params
    if not isinstance(name, str):
        raise Error(f"interface = {name!r}: must be the name of an interface", Status.INVALID_PARAMETER)
    for twice in STRENGTH:
        if twice in surface:
            raise Error(f"{twice}: interface sets it already, leave one out", Status.INVALID_PARAMETER)
    return params.with_interface(name)


def _made(make: Any, given: dict[str, Any], nominal_area: float) -> Params:
    try:
        params: Params = make(**given, nominal_area=nominal_area)
    except TypeError as error:
        raise TypeError(str(error).replace(f"{make.__qualname__}()", "friction()")) from None
    return params


def _contact(pair: str | Pair, surface: dict[str, Any]) -> dict[str, Any]:
    """What the materials tell: of a pair, or of two bodies with a work of adhesion that is given."""
    given = {name: surface[name] for name in ("work_of_adhesion", "burgers_vector") if name in surface}
    names = pair.split("/") if isinstance(pair, str) else []
    if len(names) == 2 and all(name in MATERIALS for name in names):
        return contact(*names, **given)
    known = PAIRS[pair] if isinstance(pair, str) else pair
    return known.contact_with(**given)


@lru_cache(maxsize=_KEPT)
def _models(cases: tuple[Params, ...]) -> tuple[Model, ...]:
    return tuple(Model(params) for params in cases)
