"""What a contact does as tables that are linear between their rows, with no more rows than a tolerance needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable, NamedTuple

import numpy as np
import numpy.typing as npt

from ..errors import Error, Status
from ..model import Model

Array = npt.NDArray[np.float64]
Law = Callable[[Array], Array]

# Samples between two rows: the largest error is missed by less than the margin, as it is quadratic about its place.
_SAMPLES = np.linspace(0.0, 1.0, 67)[1:-1]
_MARGIN = 0.99


@dataclass(frozen=True)
class Table:
    """Rows of a quantity and what the law gives there, and the largest relative error between them that was found."""

    at: Array
    value: Array
    error: float


class Overclosure(NamedTuple):
    """Pressure [Pa] against overclosure [m], and the gap between the mean planes [m] at which the overclosure is 0."""

    table: Table
    gap: float


class Stiffness(NamedTuple):
    """Friction coefficient, stiffnesses before slip and along the normal, of loading and unloading [Pa/m], and elastic slip [m] at a
    pressure [Pa]."""

    pressure: float
    friction: float
    shear: float
    normal: float
    unloading: float

    @property
    def slip(self) -> float:
        return self.friction * self.pressure / self.shear


class Bands(NamedTuple):
    """The ends of the 95 % bands of what `Stiffness` has of the same names."""

    slip: tuple[float, float]
    shear: tuple[float, float]
    normal: tuple[float, float]
    unloading: tuple[float, float]


def _area(model: Model) -> float:
    area = model.params.nominal_area
    if area == 0:
        message = "nominal_area = 0: must be set for a table of pressures, which are loads over it"
        raise Error(message)
    return area


def unloaded_from(model: Model, pressure: float) -> Model:
    """The model after a largest pressure; itself after none."""
    return model.unloaded(pressure * _area(model)) if pressure else model


def friction_at_pressure(model: Model) -> Law:
    """The friction coefficient of a model whose loads are pressures on its nominal area."""
    area = _area(model)
    return lambda pressure: model.friction_at_load(pressure * area)


def conductance_at_pressure(model: Model, conductivity: float) -> Law:
    """Conductance of the interface by area, between bodies of this conductivity, the harmonic mean of both."""
    area = _area(model)
    by_stiffness = 2 * conductivity / area / model.summary().stiffness_per_radius
    return lambda pressure: by_stiffness * model.tangential_stiffness_at_load(pressure * area)


def stiffness_at_pressure(model: Model, pressure: float) -> Stiffness:
    """How stiff the interface is at a pressure, from the exact state."""
    area = _area(model)
    state = model.state_at_load(pressure * area)
    stiffness = (state.tangential_stiffness, -state.dload_dgap, state.unloading_stiffness)
    return Stiffness(pressure, state.friction_coefficient, *(value / area for value in stiffness))


def overclosure_table(model: Model, lowest: float, highest: float, tolerance: float) -> Overclosure:
    """Pressure against overclosure from the lowest pressure on. Below it a straight line leads to no pressure at overclosure 0."""
    area = _area(model)
    first, last = (model.state_at_load(pressure * area) for pressure in (lowest, highest))
    depth = lowest * area / -first.dload_dgap
    gap = first.gap + depth
    return Overclosure(pressure_table(lambda depth: model.load_at_gap(gap - depth) / area, depth, gap - last.gap, tolerance), gap)


def pressure_table(law: Law, lowest: float, highest: float, tolerance: float) -> Table:
    """The rows from the lowest on, each as far from the one before as the tolerance lets it be."""
    rows, errors, highest = [_rounded(lowest)], [0.0], _rounded(highest)
    while rows[-1] < highest:
        row = _next(law, rows[-1], highest, _MARGIN * tolerance)
        errors.append(_error(law, rows[-1], row))
        rows.append(row)
    at = np.array(rows)
    return Table(at, np.array([_rounded(value) for value in law(at)]), max(errors))


def _next(law: Law, row: float, highest: float, tolerance: float) -> float:
    """The farthest next row, found by bisection in the logarithm."""
    if _error(law, row, highest) <= tolerance:
        return highest
    near, far = 0.0, np.log(highest / row)
    for _ in range(30):
        middle = 0.5 * (near + far)
        if _error(law, row, row * float(np.exp(middle))) <= tolerance:
            near = middle
        else:
            far = middle
    found = _rounded(row * float(np.exp(near)))
    if found <= row:
        raise Error(f"tolerance = {tolerance:g}: needs rows closer than nine digits resolve", Status.OUT_OF_RANGE)
    return min(found, highest)


def _error(law: Law, first: float, last: float) -> float:
    """The largest relative error of the straight line between two rows."""
    share = _SAMPLES
    exact = law(first + share * (last - first))
    ends = law(np.array([first, last]))
    # Where the law falls like a power, the largest error is near the first row: look there as closely.
    near = law(first * (last / first) ** share)
    line = np.interp(first * (last / first) ** share, [first, last], ends)
    return float(max(np.max(abs((1 - share) * ends[0] + share * ends[1] - exact) / exact), np.max(abs(line - near) / near)))


def _rounded(number: float) -> float:
    """To nine digits, which are what a file has."""
    return float(f"{number:.9g}")
