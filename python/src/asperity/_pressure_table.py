"""Friction against pressure as a table that is linear between its rows, with no more rows than a tolerance needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np
import numpy.typing as npt

from .errors import Error, Status
from .model import Model

Array = npt.NDArray[np.float64]
Law = Callable[[Array], Array]

# Samples between two rows: the largest error is missed by less than the margin, as it is quadratic about its place.
_SAMPLES = np.linspace(0.0, 1.0, 67)[1:-1]
_MARGIN = 0.99


@dataclass(frozen=True)
class PressureTable:
    """Rows of pressure [Pa] and friction coefficient, and the largest relative error between them that was found."""

    pressure: Array
    friction: Array
    error: float


def friction_at_pressure(model: Model) -> Law:
    """The friction coefficient of a model whose loads are pressures on its nominal area."""
    area = model.params.nominal_area
    if area == 0:
        message = "nominal_area = 0: must be set for a table of pressures, which are loads over it"
        raise Error(message, Status.INVALID_PARAMETER)
    return lambda pressure: model.friction_at_load(pressure * area)


def pressure_table(law: Law, lowest: float, highest: float, tolerance: float) -> PressureTable:
    """The rows from the lowest pressure on, each as far from the one before as the tolerance lets it be."""
    rows, errors = [_rounded(lowest)], [0.0]
    while rows[-1] < highest:
        row = _next(law, rows[-1], _rounded(highest), _MARGIN * tolerance)
        errors.append(_error(law, rows[-1], row))
        rows.append(row)
    pressure = np.array(rows)
    friction = np.array([_rounded(mu) for mu in law(pressure)])
    return PressureTable(pressure, friction, max(errors))


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
    """The largest relative error of the straight line between two pressures."""
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
