"""Names that `asperity.fit` can vary: fields of `Params`, the paper's symbols for them, and its dimensionless groups.

| name | symbol | what is varied |
|---|---|---|
| composite_modulus | E* | [stress] > 0 |
| effective_shear_modulus | G* | [stress] > 0 |
| work_of_adhesion | w | [force/length] > 0 |
| adhesion_range | h | [length] > 0 |
| burgers_vector | b | [length] > 0 |
| height_std | sigma | [length] > 0 |
| summit_radius | R | [length] > 0 |
| asperity_count | N | > 0 |
| skew | | of Johnson's heights, -3 to 3; of others -1.11 to 2, and they become Weibull heights |
| kurtosis | | > 0, of Johnson's heights: start from `params` with a kurtosis |
| weibull_shape | omega | > 0; heights of other families become Weibull heights |
| radius_amplitude | epsilon | -1 to 1 |
| radius_rate | rho | > 0 |
| slip_radius_1, slip_stress_1, slip_radius_2, slip_stress_2 | | > 0 |
| slip_stress | | slip_stress_1 > 0, and slip_stress_2 in proportion: the strength of the interface |
| pressure_coefficient | kappa | 0 to 1000: what pressure adds to friction, which may start at 0 |
| alpha | | (sigma/R)^(1/2) > 0: height_std and summit_radius, their product fixed |
| beta | | (R sigma)^(1/2)/b > 0: height_std and summit_radius, their ratio fixed |
| gamma | | w/(E* b) > 0: work_of_adhesion |
| b_over_h | | b/h > 0: adhesion_range |
| Sq | | [length] > 0, of parameters made from m0 and m2: the surface stretched in height, its slope fixed |
| Sdq | | > 0, of parameters made from m0 and m2: the slope of the surface, its height fixed |

All of them but skew, radius_amplitude and pressure_coefficient are positive and searched in their logarithm. A group keeps its value in the
result also where E* or b are free. Two names that vary the same field exclude each other, alpha and beta, Sq and Sdq excepted.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Callable, Sequence

from .._friction_law import FrictionLaw
from ..errors import Error
from ..params import Params
from ..tools import checks

_FACTOR = 1000.0  # between the start of a positive name and its bounds, by default

Get = Callable[[Params], float]
Put = Callable[[Params, float], Params]


@dataclass(frozen=True)
class FreeName:
    """One name that a fit varies.

    Attributes:
        given: the name as the caller wrote it.
        field: the field or group that it stands for.
        varies: the fields of `Params` that change with it.
        get: its value in some parameters.
        put: parameters with another value of it, the rest as it was.
        domain: between which values it must stay; (0, inf) is searched in the logarithm.
    """

    given: str
    field: str
    varies: tuple[str, ...]
    get: Get
    put: Put
    domain: tuple[float, float]

    @property
    def positive(self) -> bool:
        return self.domain == _POSITIVE

    @property
    def dimension(self) -> str:
        """Of its value: "stress", "force/length", "length", or "" for a number."""
        return _DIMENSIONS.get(self.field, "")

    @property
    def is_group(self) -> bool:
        return self.field in _GROUPS

    def start(self, params: Params) -> float:
        """Where the search begins; `Error` if it cannot begin there."""
        value = self.get(params)
        low, high = self.domain
        if not (math.isfinite(value) and (value > 0 if self.positive else low <= value <= high)):
            raise Error(f"{self.given} = {value:g} in params: to be free it must start {self._allowed()}")
        return value

    def limits(self, start: float, bounds: Any, unit: str = "") -> tuple[float, float]:
        """The bounds given, checked, or those by default."""
        if bounds is None:
            return (start / _FACTOR, start * _FACTOR) if self.positive else self.domain
        found = checks.array(f"bounds of {self.given}", bounds, unit)
        if found.shape != (2,):
            raise TypeError(f"bounds of {self.given} = {bounds!r}: must be two numbers")
        low, high = found.tolist()
        inside = low > 0 and math.isfinite(high) if self.positive else self.domain[0] <= low and high <= self.domain[1]
        if not (inside and low < high):
            raise Error(f"bounds of {self.given} = ({low:g}, {high:g}): must ascend and be {self._allowed()}")
        if not low <= start <= high:
            raise Error(f"{self.given} = {start:g} in params: must start between its bounds, {low:g} and {high:g}")
        return low, high

    def coordinate(self, value: float, start: float) -> float:
        """Where the search has a value."""
        return math.log(value / start) if self.positive else value

    def value(self, coordinate: float, start: float) -> float:
        """The value at a place of the search."""
        return start * math.exp(coordinate) if self.positive else coordinate

    def per_coordinate(self, value: float) -> float:
        """d(value)/d(coordinate)."""
        return value if self.positive else 1.0

    def _allowed(self) -> str:
        return "finite and > 0" if self.positive else f"within {self.domain[0]:g} to {self.domain[1]:g}"


def free_names(given: Sequence[str], params: Params) -> tuple[FreeName, ...]:
    """Looks names up for a start; `Error` for none, an unknown one, or two that vary the same field."""
    names = tuple(_look_up(name, params) for name in checks.words("free", given))
    for i, one in enumerate(names):
        for other in names[:i]:
            both = set(one.varies) & set(other.varies)
            if both and {one.field, other.field} not in ({"alpha", "beta"}, {"Sq", "Sdq"}):
                listed = " and ".join(sorted(both))
                raise Error(f"free names {other.given} and {one.given} both vary {listed}: choose one of them")
    return names


def put_all(names: Sequence[FreeName], params: Params, values: Sequence[float]) -> Params:
    """Parameters with other values of some names; fields are set before the groups that are made of them."""
    for name, value in sorted(zip(names, values), key=lambda pair: pair[0].is_group):
        params = name.put(params, value)
    return params


def _look_up(name: Any, params: Params) -> FreeName:
    field = _SYMBOLS.get(name, name)
    if field not in _KINDS:
        symbols = {field: f"{field} or {symbol}" for symbol, field in _SYMBOLS.items()}
        allowed = ", ".join(symbols.get(field, field) for field in _KINDS)
        raise Error(f"name {name!r}: must be one of {allowed}")
    if params.height_distribution == "johnson" and field == "skew":
        return FreeName(name, field, (field,), _get_field(field), _put_field(field), (-3.0, 3.0))
    if field in ("Sq", "Sdq") and not (params.rms_slope > 0 and params.summit_mean_height > 0 and params.bandwidth == 0):
        raise Error(f"name {name!r}: is of parameters made from m0 and m2, as by Params.from_spectral_moments")
    if params.height_distribution != "johnson" and field == "kurtosis":
        raise Error("name 'kurtosis': is of Johnson's heights; give params a kurtosis to start from")
    return FreeName(name, field, *_KINDS[field])


def _put_field(name: str) -> Put:
    return lambda params, value: params.replace(**{name: value})


def _get_field(name: str) -> Get:
    return lambda params: float(getattr(params, name))


def _get_skew(params: Params) -> float:
    with FrictionLaw(params) as law:
        return law.summary().skew


def _alpha(params: Params) -> float:
    return math.sqrt(params.height_std / params.summit_radius)


def _contact_radius(params: Params) -> float:
    """beta b."""
    return math.sqrt(params.height_std * params.summit_radius)


def _put_alpha(params: Params, alpha: float) -> Params:
    radius = _contact_radius(params)
    return params.replace(height_std=alpha * radius, summit_radius=radius / alpha)


def _put_beta(params: Params, beta: float) -> Params:
    alpha, radius = _alpha(params), beta * params.burgers_vector
    return params.replace(height_std=alpha * radius, summit_radius=radius / alpha)


def _get_rms_height(params: Params) -> float:
    """The asperities of a surface with m0 = 1 are so many times as high."""
    return params.summit_mean_height / _of_one().summit_mean_height


def _of_one() -> Params:
    return Params.from_spectral_moments(m0=1, m2=0.5, nominal_area=1, composite_modulus=1, effective_shear_modulus=1,
                                        work_of_adhesion=0, adhesion_range=1, burgers_vector=1)


def _put_rms_height(params: Params, height: float) -> Params:
    return _stretched(params, height / _get_rms_height(params), 1.0)


def _put_rms_slope(params: Params, slope: float) -> Params:
    return _stretched(params, 1.0, slope / params.rms_slope)


def _stretched(params: Params, height: float, slope: float) -> Params:
    """Of a surface this many times as high and as steep, by dimensions: m0 and m2 are all that its asperities follow from."""
    along = height / slope
    return params.replace(
        height_std=params.height_std * height,
        summit_mean_height=params.summit_mean_height * height,
        summit_radius=params.summit_radius * along / slope,
        asperity_count=params.asperity_count / along**2,
        rms_slope=params.rms_slope * slope,
    )


def _put_slip_stress(params: Params, stress: float) -> Params:
    scale = stress / params.slip_stress_1
    return params.replace(slip_stress_1=stress, slip_stress_2=scale * params.slip_stress_2)


def _stress(params: Params) -> float:
    """E* b, the unit of w."""
    return params.composite_modulus * params.burgers_vector


_POSITIVE = (0.0, math.inf)
_EPSILON = "radius_amplitude"
# What pressure adds to friction.
PRESSURE = "pressure_coefficient"
_SYMBOLS = {
    "E*": "composite_modulus",
    "G*": "effective_shear_modulus",
    "w": "work_of_adhesion",
    "h": "adhesion_range",
    "b": "burgers_vector",
    "sigma": "height_std",
    "R": "summit_radius",
    "N": "asperity_count",
    "omega": "weibull_shape",
    "epsilon": _EPSILON,
    "rho": "radius_rate",
    "kappa": PRESSURE,
}
_DIMENSIONS = {
    **dict.fromkeys(("composite_modulus", "effective_shear_modulus"), "stress"),
    "work_of_adhesion": "force/length",
    **dict.fromkeys(("adhesion_range", "burgers_vector", "height_std", "summit_radius", "Sq"), "length"),
}
_SLIP = ("slip_radius_1", "slip_stress_1", "slip_radius_2", "slip_stress_2")
_FIELDS = (*_SYMBOLS.values(), *_SLIP)
_LARGEST_PRESSURE = 1000.0
_ROUGHNESS = ("height_std", "summit_radius")
_MOMENTS = (*_ROUGHNESS, "asperity_count", "summit_mean_height", "rms_slope")

_KINDS: dict[str, tuple[tuple[str, ...], Get, Put, tuple[float, float]]] = {
    **{name: ((name,), _get_field(name), _put_field(name), _POSITIVE) for name in _FIELDS},
    _EPSILON: ((_EPSILON,), _get_field(_EPSILON), _put_field(_EPSILON), (-1.0, 1.0)),
    PRESSURE: ((PRESSURE,), _get_field(PRESSURE), _put_field(PRESSURE), (0.0, _LARGEST_PRESSURE)),
    "kurtosis": (("kurtosis",), _get_field("kurtosis"), _put_field("kurtosis"), _POSITIVE),
    "skew": (("weibull_shape",), _get_skew, _put_field("skew"), (-1.11, 2.0)),
    "slip_stress": (("slip_stress_1", "slip_stress_2"), _get_field("slip_stress_1"), _put_slip_stress, _POSITIVE),
    "alpha": (_ROUGHNESS, _alpha, _put_alpha, _POSITIVE),
    "beta": (_ROUGHNESS, lambda params: _contact_radius(params) / params.burgers_vector, _put_beta, _POSITIVE),
    "gamma": (
        ("work_of_adhesion",),
        lambda params: params.work_of_adhesion / _stress(params),
        lambda params, gamma: params.replace(work_of_adhesion=gamma * _stress(params)),
        _POSITIVE,
    ),
    "Sq": (_MOMENTS, _get_rms_height, _put_rms_height, _POSITIVE),
    "Sdq": (_MOMENTS, _get_field("rms_slope"), _put_rms_slope, _POSITIVE),
    "b_over_h": (
        ("adhesion_range",),
        lambda params: params.burgers_vector / params.adhesion_range,
        lambda params, ratio: params.replace(adhesion_range=params.burgers_vector / ratio),
        _POSITIVE,
    ),
}
# All names and symbols.
KNOWN = (*_KINDS, *_SYMBOLS)
# What sets the strength of the interface.
STRENGTHS = ("slip_stress", "slip_stress_1", "slip_stress_2")
_GROUPS = ("slip_stress", "alpha", "beta", "gamma", "b_over_h", "Sq", "Sdq")
