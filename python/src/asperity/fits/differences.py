"""Slopes of what models answer, by central differences along the coordinates of fits and bands."""

from __future__ import annotations

from typing import Callable, Union

import numpy as np
import numpy.typing as npt

from .._friction_law import FrictionLaw
from ..errors import Error, Status
from ..params import Params

Array = npt.NDArray[np.float64]
# What is asked at a place; None where the library refuses its surfaces.
Answer = Callable[[Array], Union[Array, None]]

# The compiled law is smooth to 1e-10, so that (1e-10)^(1/3) about balances its error against that of the difference; the
# derivative is then right to some 1e-7 of the friction.
STEP = 1e-3


def slopes(answer: Answer, x: Array, low: Array, high: Array, named: Callable[[int], str]) -> Array:
    """d(answer)/dx, (answers, coordinates); beside a bound, or surfaces that are refused, of the same order to one side."""

    def beside(i: int, steps: int) -> Array | None:
        at = x.copy()
        at[i] += steps * STEP
        return answer(at) if low[i] <= at[i] <= high[i] else None

    def along(i: int) -> Array:
        below, above = beside(i, -1), beside(i, 1)
        if below is not None and above is not None:
            return (above - below) / (2 * STEP)
        side, near = (1, above) if above is not None else (-1, below)
        far, here = beside(i, 2 * side), answer(x)
        if near is None or far is None or here is None:
            raise Error(f"{named(i)}: the library refuses surfaces on both sides of it", Status.OUT_OF_RANGE)
        return side * (4 * near - 3 * here - far) / (2 * STEP)

    return np.stack([along(i) for i in range(x.size)], axis=1)


def log_slopes(surfaces: Callable[[Array], Params], x: Array, low: Array, high: Array, named: Callable[[int], str], load: Array) -> Array:
    """d(ln F)/dx of exact states, (loads, coordinates): a direction along which friction stays has none but for rounding."""

    def forces(at: Array) -> Array | None:
        try:
            with FrictionLaw(surfaces(at)) as law:
                logarithms: Array = np.log(law.state_at_load(load).friction_force)
                return logarithms
        except Error as error:
            if error.status == Status.INTERNAL or at is x:
                raise
            return None

    return slopes(forces, x, low, high, named)
