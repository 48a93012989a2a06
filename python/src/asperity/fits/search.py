"""The least-squares problem of a fit: checked measurements, residuals and their Jacobian over the free parameters."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache, partial
from typing import Any, Mapping

import numpy as np
import numpy.typing as npt

from .. import units
from .._friction_law import FrictionLaw
from ..errors import Error, Status
from ..params import Params
from ..tools import checks
from .differences import log_slopes, slopes
from .names import PRESSURE, FreeName, put_all

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

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
        cls, load: Any, mu: Any, force: Any, sigma: Any, in_si: bool
    ) -> Data:
        """Points of which a number is masked are left out."""
        if (mu is None) == (force is None):
            raise Error("give either mu or force")
        quantity = "mu" if force is None else "force"
        of_load = units.unit("force", in_si)
        of_friction = "" if force is None else of_load
        given = {"load": (load, of_load), quantity: (force if mu is None else mu, of_friction)}
        if sigma is not None:
            one, masked = checks.known("sigma", sigma, of_friction)
            given["sigma"] = np.ma.masked_array(one, masked) if one.ndim else np.full(np.shape(load), checks.real("sigma", sigma, of_friction)), ""
        loads, measured, *errors = checks.columns(**given)
        if quantity == "mu":
            _each("load", loads, loads > 0, "must be > 0, for F/P has no finite value there; fit the force instead")
            _each("mu", measured, measured > 0, "must be > 0")
        else:
            _each("force", measured, measured >= 0, "must be >= 0")
        for each in errors:
            _each("sigma", each, each > 0, "must be > 0")
        return cls(loads, measured, errors[0] if errors else None, quantity)

    @property
    def weight(self) -> Array | float:
        return 1.0 if self.sigma is None else 1 / self.sigma


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
        limits = [name.limits(value, bounds.get(name.given), units.unit(name.dimension, params.in_si)) for name, value in zip(names, origin)]
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

        def answer(at: Array) -> Array | None:
            residuals = self.residuals(at)
            return residuals if np.isfinite(residuals).all() else None

        return slopes(answer, x, self.low, self.high, partial(self._named, x))

    def exact_jacobian(self, x: Array) -> Array:
        """The same of exact states. Up to the pull-off load, where slopes are infinite, data do not count."""
        load = self.data.load
        found = np.zeros((load.size, x.size))
        if (parts := self._linear(x)) is not None:
            unit = self.data.weight / (load if self.data.quantity == "mu" else 1.0)
            for i, name in enumerate(self.names):
                found[:, i] = unit * (self._with_pressure(1.0) - self._with_pressure(0.0) if name.field == PRESSURE else parts[0])
            return found
        with FrictionLaw(self.surfaces(x)) as law:
            counts = load > law.summary().pull_off_load
        if counts.any():
            found[counts] = log_slopes(self.surfaces, x, self.low, self.high, partial(self._named, x), load[counts])
        return found * (self.friction(x) * self.data.weight)[:, None]

    def _named(self, x: Array, i: int) -> str:
        return f"{self.names[i].given} = {self.values(x)[i]:g}"


@lru_cache(maxsize=8)
def _forces(params: Params, loads: tuple[float, ...]) -> Array:
    """Friction forces, kept for the next step, and for the next fit to the same loads, as those of a bootstrap."""
    with FrictionLaw(params) as law:
        return law.friction_force_at_load(np.array(loads))
