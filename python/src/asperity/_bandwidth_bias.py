"""What to expect of summits that stand alone, by the bandwidth of their surface: against boundary elements.

The numbers are those of docs/validation.md, from tests/validation/boundary_elements.csv; test_population.py there compares.
"""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from . import _caller
from .results import ValidityWarning

Kind = Literal["equal", "nayak", "map"]


class Bias(NamedTuple):
    """Library over boundary elements where 0.1 to 10 % of the nominal area touch: least and greatest of the means over
    surfaces; and whether friction at some load is off by more than 10 % and the scatter of the surfaces."""

    area: tuple[float, float]
    friction: tuple[float, float]
    doubtful: bool


# By bandwidth.
BIAS: dict[float, dict[Kind, Bias]] = {
    1.8: {
        "equal": Bias((0.87, 1.34), (0.94, 1.24), True),
        "nayak": Bias((0.83, 0.94), (0.92, 0.96), False),
        "map": Bias((0.85, 1.02), (0.93, 1.06), False),
    },
    2.8: {
        "equal": Bias((0.83, 1.11), (0.96, 1.06), False),
        "nayak": Bias((0.78, 0.87), (0.90, 0.94), False),
        "map": Bias((0.79, 0.90), (0.94, 0.97), False),
    },
    5.6: {
        "equal": Bias((0.74, 0.87), (0.87, 0.97), False),
        "nayak": Bias((0.70, 0.77), (0.78, 0.92), False),
        "map": Bias((0.71, 0.79), (0.81, 0.93), False),
    },
    27.0: {
        "equal": Bias((0.60, 0.70), (0.79, 0.93), True),
        "nayak": Bias((0.57, 0.65), (0.76, 0.91), True),
        "map": Bias((0.59, 0.68), (0.78, 0.93), True),
    },
}
# Of a fractal dimension of 2.2, 4e3 goes with three decades of wavelengths, 2e5 with four: no map has more.
_BROADEST = 1e6
_FROM: dict[Kind, str] = {
    "equal": "spectral moments with equal radii",
    "nayak": "spectral moments with Nayak's radii and heights",
    "map": "the summits of a map",
}


def warn(bandwidth: float, kind: Kind) -> None:
    """A `ValidityWarning` with the expected bias and what to do, if friction at the nearest bandwidth is doubtful."""
    tried = min(BIAS, key=lambda one: abs(math.log(one / bandwidth)))
    area, friction, doubtful = BIAS[tried][kind]
    if not doubtful:
        return
    if bandwidth > _BROADEST:
        _caller.warn(
            f"bandwidth m0 m4/m2^2 = {bandwidth:.3g}: no map resolves so broad a spectrum; is a length in another unit, "
            "as Sq in nm or um? In SI units Sq is in m, Sds in 1/m^2, m0 in m^2, m4 in 1/m^2",
            ValidityWarning,
        )
        return
    if tried == min(BIAS):
        what = 'take account of high summits being sharper, summits="nayak"'
    else:
        what = "filter the surface to the scale of its contacts (docs/roughness.md), or use boundary elements"
    _caller.warn(
        f"bandwidth m0 m4/m2^2 = {bandwidth:.3g}: from {_FROM[kind]} at a bandwidth of {tried:g} real area is "
        f"{area[0]:.2f} to {area[1]:.2f} and friction {friction[0]:.2f} to {friction[1]:.2f} of that of boundary "
        f"elements, where 0.1 to 10 % of the nominal area touch: {what}",
        ValidityWarning,
    )
