"""The least-squares problem of a fit: checked measurements, residuals and their Jacobian over the free parameters."""

from __future__ import annotations

import numbers
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Any, Callable, Mapping

import numpy as np
import numpy.typing as npt

from .._friction_law import FrictionLaw
from ..errors import Error, Status
from ..params import Params
from ..sensitivity import LINEAR, NAMES
from ..tools import checks
from .names import PRESSURE, FreeName, put_all

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# Of central differences: the compiled law is smooth to 1e-10, so that (1e-10)^(1/3) about balances its error against
# that of the difference; the derivative is then right to some 1e-7 of the friction.
STEP = 1e-3
# Of the differences of the parameters along a coordinate. All but the shape of Weibull heights of a skew, which is smooth,
# are powers or the coordinate itself, so that any step serves.
_SHORT = 1e-4
# Further starts of a search lie within this factor of the first.
_SPREAD = 10.0
# What friction is linear in: the strength of the interface, and what pressure adds.
_LINEAR = {"slip_stress", PRESSURE}


@dataclass(frozen=True, eq=False)
class Data:
    """Measurements, checked."""

    load: Array
    measured: Array
    sigma: Array | None
    quantity: str

    @classmethod
    def of(
        cls, load: npt.ArrayLike, mu: npt.ArrayLike | None, force: npt.ArrayLike | None, sigma: npt.ArrayLike | None
    ) -> Data:
        if (mu is None) == (force is None):
            raise Error("give either mu or force")
        quantity = "mu" if force is None else "force"
        loads, measured = checks.column("load", load), checks.column(quantity, force if mu is None else mu)
        _same_length(quantity, measured, loads)
        if quantity == "mu":
            _each("load", loads, loads > 0, "must be > 0, for F/P has no finite value there; fit the force instead")
            _each("mu", measured, measured > 0, "must be > 0")
        else:
            _each("force", measured, measured >= 0, "must be >= 0")
        return cls(loads, measured, _errors(sigma, loads), quantity)

    @property
    def weight(self) -> Array | float:
        return 1.0 if self.sigma is None else 1 / self.sigma


def _errors(sigma: npt.ArrayLike | None, load: Array) -> Array | None:
    if sigma is None:
        return None
    errors = checks.column("sigma", np.full(load.shape, sigma) if isinstance(sigma, numbers.Real) else sigma)
    _same_length("sigma", errors, load)
    _each("sigma", errors, errors > 0, "must be > 0")
    return errors


def _same_length(name: str, values: Array, load: Array) -> None:
    if values.size != load.size:
        raise Error(f"{name} has {values.size} values, load {load.size}: must be as many")


def _each(name: str, values: Array, good: Mask, allowed: str) -> None:
    if not good.all():
        index = int(np.argmin(good))
        raise Error(f"{name}[{index}] = {values[index]:g}: {allowed}")


@dataclass(frozen=True, eq=False)
class Search:
    """The least-squares problem in its own coordinates: log(value/start) for positive names, the value for others."""

    names: tuple[FreeName, ...]
    params: Params
    data: Data
    origin: Array  # values at the start
    start: Array
    low: Array
    high: Array

    @classmethod
    def of(
        cls, names: tuple[FreeName, ...], params: Params, data: Data, bounds: Mapping[str, tuple[float, float]]
    ) -> Search:
        origin = np.array([name.start(params) for name in names])
        unknown = sorted(set(map(str, bounds)) - {name.given for name in names})
        if unknown:
            raise Error(f"bounds of {', '.join(unknown)}: must be of free names")
        limits = [name.limits(value, bounds.get(name.given)) for name, value in zip(names, origin)]
        ends = [
            [name.coordinate(end, value) for name, end, value in zip(names, side, origin)] for side in zip(*limits)
        ]
        start = np.array([name.coordinate(value, value) for name, value in zip(names, origin)])
        return cls(names, params, data, origin, start, np.array(ends[0]), np.array(ends[1]))

    def values(self, x: Array) -> list[float]:
        return [name.value(float(at), float(origin)) for name, at, origin in zip(self.names, x, self.origin)]

    def surfaces(self, x: Array) -> Params:
        """Parameters at a point of the search."""
        return put_all(self.names, self.params, self.values(x))

    def friction(self, x: Array) -> Array:
        """What the model has for the data; raises what the library refuses."""
        found = self._linear(x)
        if found is None:
            with FrictionLaw(self.surfaces(x)) as law:
                force = law.friction_force_at_load(self.data.load)
        else:
            force = found.sum(axis=0)
        return force / self.data.load if self.data.quantity == "mu" else force

    def _linear(self, x: Array) -> Array | None:
        """The parts of the force by the strength and by pressure, (2, loads), where nothing else is free: models are then the same
        for all x. None for other names, or for a strength that the library refuses."""
        if not {name.field for name in self.names} <= _LINEAR:
            return None
        surface = self.surfaces(x)
        if not max(surface.slip_stress_1, surface.slip_stress_2) <= 1:
            return None
        factor, kappa = surface.slip_stress_1 / self.params.slip_stress_1, surface.pressure_coefficient
        strength = self._with_pressure(0.0)
        return np.stack([factor * strength, kappa * (self._with_pressure(1.0) - strength) if kappa > 0 else 0 * strength])

    def _with_pressure(self, kappa: float) -> Array:
        """The force at the loads, with a pressure coefficient and the strength of the start."""
        return _forces(self.params.replace(pressure_coefficient=kappa), tuple(self.data.load.tolist()))

    def at_loads(self, load: Array) -> Search:
        """The same at other loads, where nothing was measured: its residuals are the friction, its Jacobian that of it."""
        return replace(self, data=Data(load, np.zeros_like(load), None, self.data.quantity))

    def random_start(self, random: np.random.Generator) -> Array:
        """Another start: within a factor of `_SPREAD` for positive names, for others within a tenth of their bounds."""
        positive = np.array([name.positive for name in self.names])
        span = np.where(positive, np.log(_SPREAD), 0.1 * (self.high - self.low))
        return np.clip(self.start + random.uniform(-1, 1, self.start.size) * span, self.low, self.high)

    def residuals(self, x: Array) -> Array:
        """NaN for surfaces that the library refuses: the search then shortens its step."""
        try:
            return (self.friction(x) - self.data.measured) * self.data.weight
        except Error as error:
            if error.status == Status.INTERNAL:
                raise
            return np.full(self.data.load.shape, np.nan)

    def jacobian(self, x: Array) -> Array:
        if self._linear(x) is not None:
            return self.exact_jacobian(x)
        return np.stack([self._derivative(x, i) for i in range(x.size)], axis=1)

    def exact_jacobian(self, x: Array) -> Array:
        """The same by the library's sensitivities. Up to the pull-off load, where they are infinite, data do not count."""
        load = self.data.load
        slopes = np.zeros((load.size, x.size))
        if (parts := self._linear(x)) is not None:
            unit = self.data.weight / (load if self.data.quantity == "mu" else 1.0)
            for i, name in enumerate(self.names):
                slopes[:, i] = unit * (self._with_pressure(1.0) - self._with_pressure(0.0) if name.field == PRESSURE else parts[0])
            return slopes
        with FrictionLaw(self.surfaces(x)) as law:
            counts = load > law.summary().pull_off_load
            slopes[counts] = log_slopes(self.surfaces, x, self.low, self.high, law, load[counts])
        return slopes * (self.friction(x) * self.data.weight)[:, None]

    def _derivative(self, x: Array, i: int) -> Array:
        """By central differences; beside a bound or surfaces that are refused, of the same order to one side."""
        below, above = self._beside(x, i, -1), self._beside(x, i, 1)
        if below is not None and above is not None:
            return (above - below) / (2 * STEP)
        side, near = (1, above) if above is not None else (-1, below)
        far = self._beside(x, i, 2 * side)
        if near is None or far is None:
            name, value = self.names[i].given, self.values(x)[i]
            raise Error(f"{name} = {value:g}: the library refuses surfaces on both sides of it", Status.OUT_OF_RANGE)
        return side * (4 * near - 3 * self.residuals(x) - far) / (2 * STEP)

    def _beside(self, x: Array, i: int, steps: int) -> Array | None:
        at = x.copy()
        at[i] += steps * STEP
        if not self.low[i] <= at[i] <= self.high[i]:
            return None
        residuals = self.residuals(at)
        return residuals if np.isfinite(residuals).all() else None


@lru_cache(maxsize=8)
def _forces(params: Params, loads: tuple[float, ...]) -> Array:
    """Friction forces, kept for the next step, and for the next fit to the same loads, as those of a bootstrap."""
    with FrictionLaw(params) as law:
        return law.friction_force_at_load(np.array(loads))


def log_slopes(
    surfaces: Callable[[Array], Params], x: Array, low: Array, high: Array, law: FrictionLaw, loads: Array
) -> Array:
    """d(ln F)/dx, (loads, coordinates), of `law`, which is that of `surfaces(x)`; `low` and `high` are its bounds."""
    changes = np.stack([_changes(surfaces, x, i, low, high) for i in range(x.size)], axis=1)
    found = [law.sensitivities(load) for load in loads.tolist()]
    by_parameters = np.array([[getattr(one, name) for name in NAMES] for one in found]).reshape(-1, len(NAMES))
    slopes: Array = by_parameters @ changes
    return slopes


def _changes(surfaces: Callable[[Array], Params], x: Array, i: int, low: Array, high: Array) -> Array:
    """How fast the parameters, those of `LINEAR` apart in their logarithms, change along a coordinate."""
    ends = []
    for end in (max(x[i] - _SHORT, low[i]), min(x[i] + _SHORT, high[i])):
        at = x.copy()
        at[i] = end
        ends.append((end, surfaces(at)))
    (start, below), (stop, above) = ends
    changes: Array = np.array([_change(name, below, above) for name in NAMES]) / (stop - start)
    return changes


def _change(name: str, below: Params, above: Params) -> float:
    before, after = getattr(below, name), getattr(above, name)
    if before is None or before == after:
        return 0.0
    return float(after - before if name in LINEAR else np.log(after / before))
