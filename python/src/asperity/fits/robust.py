"""Losses of a fit that let single points be far off, and what they do to its errors."""

from __future__ import annotations

from typing import Callable

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# Name: psi(r), half the slope of the loss in r^2 by r, and its derivative. The names are those of SciPy's least_squares.
LOSSES: dict[str, tuple[Callable[[Array], Array], Callable[[Array], Array]]] = {
    "linear": (lambda r: r, np.ones_like),
    "huber": (lambda r: np.clip(r, -1, 1), lambda r: (np.abs(r) <= 1).astype(np.float64)),
    "soft_l1": (lambda r: r / np.sqrt(1 + r**2), lambda r: (1 + r**2) ** -1.5),
    "cauchy": (lambda r: r / (1 + r**2), lambda r: (1 - r**2) / (1 + r**2) ** 2),
}
# Of a normal distribution: its standard deviation over the median of the magnitude.
_NORMAL = 1.4826
# A point this many scales off is called far off; of normally distributed ones it is one in 16,000.
FAR = 4.0


def scale(residuals: Array) -> float:
    """The standard deviation of residuals, of which some may be far off."""
    return _NORMAL * float(np.median(np.abs(residuals)))


def freedom(loss: str, residuals: Array, unit: float, free: int) -> float:
    """Degrees of freedom of the scatter: points that count little are no whole points."""
    return max(float(LOSSES[loss][1](residuals / unit).sum()) - free, 1.0)


def variance(loss: str, residuals: Array, unit: float, free: int) -> float:
    """What the inverse of J^T J is multiplied by to get the covariance of `free` parameters (Huber, Robust Statistics, 1981,
    eq (6.6)): sum psi^2/(n - free) over the square of the mean of psi', in units of `unit`^2."""
    psi, slope = (one(residuals / unit) for one in LOSSES[loss])
    mean = max(float(slope.mean()), 1e-6)
    return unit**2 * float(psi @ psi) / (residuals.size - free) / mean**2
