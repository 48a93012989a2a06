"""Offsets of the lines that an instrument scans one after the other, as raw maps of AFMs have them."""

from __future__ import annotations

import warnings

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# Medians of the steps between lines are so many times those across them; 1.4 at most on isotropic surfaces, 2.1 to 17 on raw
# AFM maps. Of waves across the lines of 6 points and more, steps of neighbouring lines are correlated by 0.5.
_LARGER, _CORRELATED = 2.0, 0.4


def offsets(level: Array) -> tuple[int, Array] | None:
    """The axis along which lines follow each other, and the offset of each line; None if the lines have none of their own.

    Offsets are sums of the medians of differences between neighbouring lines. Waves of the surface that are as long as the map
    across the lines go with them.
    """
    steps = [_steps(level), _steps(level.T)]
    spread = [float(one.std()) for one in steps]
    axis = int(spread[1] > spread[0])
    if not spread[axis] > _LARGER * spread[1 - axis] or _correlation(steps[axis]) > _CORRELATED:
        return None
    found = np.concatenate([[0.0], np.cumsum(steps[axis])])
    return axis, found - found.mean()


def _steps(level: Array) -> Array:
    """Medians of the differences between neighbouring rows; 0 if no two points beside each other are known."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of rows without a known point
        return np.asarray(np.nan_to_num(np.nanmedian(np.diff(level, axis=0), axis=1)))


def _correlation(steps: Array) -> float:
    about = steps - steps.mean()
    return float(about[1:] @ about[:-1] / (about @ about))
