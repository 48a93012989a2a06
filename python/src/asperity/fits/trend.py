"""Whether the residuals of a fit follow the load, or turn with it: then the law does not have the trend of the data."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# Residuals that chance would order so in fewer fits than this part are told.
_IMPROBABLE = 0.01
# Smaller residuals, by the friction, are the rounding of the law.
_ROUNDING = 1e-6


def trends(load: Array, residuals: Array, measured: Array, pressure_is_free: bool) -> list[str]:
    """Remarks on residuals, measured less fitted, in the unit of what was measured."""
    if np.abs(residuals).max() <= _ROUNDING * np.abs(measured).max():
        return []
    from scipy.stats import kendalltau

    told = []
    rank, chance = kendalltau(load, residuals)
    if chance < _IMPROBABLE:
        if rank < 0:
            why = "friction falls faster with load than the law: is adhesion free, is there wear?"
        elif pressure_is_free:
            why = "friction rises faster with load than the law, with its pressure_coefficient: does the strength change otherwise?"
        else:
            why = "friction falls more slowly with load than the law: free pressure_coefficient"
        told.append(f"the residuals follow load (rank correlation {rank:+.2f}, by chance in one fit of {1 / chance:.0f}): {why}")
    counted, chance = runs(load, residuals)
    if chance < _IMPROBABLE:
        is_its = not pressure_is_free and not (told and rank < 0)
        remedy = "free pressure_coefficient, or what sets light loads" if is_its else "the form of the law is not that of the data"
        told.append(f"the residuals turn with load ({counted} runs of one sign, by chance in one fit of {1 / chance:.0f}): {remedy}")
    return told


def runs(load: Array, residuals: Array) -> tuple[int, float]:
    """Runs of one sign by ascending load, and how probable so few are (Wald and Wolfowitz). Points at one load are one."""
    loads, place = np.unique(load, return_inverse=True)
    above = np.bincount(place, residuals) > 0
    found = 1 + int(np.count_nonzero(above[1:] != above[:-1]))
    up, down = int(above.sum()), int(loads.size - above.sum())
    if not (up and down):
        return found, 1.0
    ways = sum(_ways(up, down, count) for count in range(2, found + 1))
    return found, ways / math.comb(up + down, up)


def _ways(up: int, down: int, count: int) -> int:
    """To order so many signs in this many runs."""
    half = count // 2
    if count % 2 == 0:
        return 2 * math.comb(up - 1, half - 1) * math.comb(down - 1, half - 1)
    return math.comb(up - 1, half) * math.comb(down - 1, half - 1) + math.comb(up - 1, half - 1) * math.comb(down - 1, half)
