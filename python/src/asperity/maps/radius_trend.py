"""How the radius of summits depends on their height: eq (3) of the paper, fitted to measured curvatures."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# What the fit looks for: at |epsilon| = 1 some radius would be zero, and steeper or flatter rates are a step or a line.
_AMPLITUDES = (-0.99, 0.99)
_RATES = (0.02, 20.0)
# The library's own rate, where the map does not tell one.
_UNTOLD_RATE = 0.5
# Chance of three standard deviations of a normal distribution.
_SIGNIFICANT = 0.0027


@dataclass(frozen=True, eq=False)
class RadiusTrend:
    """R(z) = R (1 + epsilon tanh(rho z/sigma)), eq (3), with z from the mean and sigma of the summit heights.

    Least squares in curvature: 1/R(z) follows the mean curvature of the summits of height z, so that epsilon = 0 gives
    the radius of `Summits`. Radii themselves would not do: those of nearly flat summits would outweigh all others.

    Attributes:
        radius: R [length].
        amplitude: epsilon, sought from -0.99 to 0.99.
        rate: rho, sought from 0.02 to 20; 0.5 where its standard error would exceed it: with a weak trend a map
            tells the product of epsilon and rho, but not both.
        covariance: of (radius, amplitude, rate), 3 x 3; summits within one of the 4 x 4 tiles of the map may be
            correlated. NaN for a rate that the map does not tell, and for what stands at an end of its range.
        slope_ratio: slope of curvature over height, in its standard errors; NaN if all summits are in one tile.
        significant: whether chance gives so large a ratio in less than 0.27 % of maps without a trend, by Student's t
            for the tiles that have summits: beyond +-3.6 for all 16. If not, use epsilon = 0.
    """

    radius: float
    amplitude: float
    rate: float
    covariance: Array = field(repr=False)
    slope_ratio: float
    significant: bool

    @property
    def errors(self) -> tuple[float, float, float]:
        """Standard errors of radius, amplitude and rate."""
        radius, amplitude, rate = np.sqrt(np.diag(self.covariance))
        return float(radius), float(amplitude), float(rate)


def fit(height: Array, curvature: Array, tile: npt.NDArray[np.intp]) -> RadiusTrend:
    """Fits eq (3).

    Args:
        height: of the summits, from their mean, in their standard deviation; shape (n,).
        curvature: mean of the two principal ones [1/length], shape (n,).
        tile: the part of the map that each is in, shape (n,).
    """
    from scipy.special import stdtr

    unit = float(curvature.mean())
    relative = curvature / unit
    slope_ratio = _slope_ratio(height, relative, tile)
    amplitude = -0.3 if slope_ratio > 0 else 0.3
    found = min((_solve(height, relative, [1.0, amplitude, rate]) for rate in (0.3, 2.0)), key=lambda one: one.cost)
    free = found.active_mask == 0
    covariance = _covariance(found.jac, found.fun, tile, free)
    if not np.sqrt(covariance[2, 2]) < found.x[2]:
        found = _solve(height, relative, [1.0, amplitude, _UNTOLD_RATE], hold_rate=True)
        free = (found.active_mask == 0) & [True, True, False]
        covariance = _covariance(found.jac, found.fun, tile, free)
    scale = np.array([1 / unit, 1.0, 1.0])
    covariance *= scale[:, None] * scale
    covariance.setflags(write=False)
    radius, amplitude, rate = map(float, found.x * scale)
    chance = 2 * stdtr(np.unique(tile).size - 1, -abs(slope_ratio))
    return RadiusTrend(radius, amplitude, rate, covariance, slope_ratio, bool(chance < _SIGNIFICANT))


def _solve(height: Array, relative: Array, start: list[float], hold_rate: bool = False) -> Any:
    """Least squares in 1/R(z) for radius, amplitude and rate, the radius in that of the mean curvature."""
    from scipy.optimize import least_squares

    def residuals(x: Array) -> Array:
        return np.asarray(1 / (x[0] * (1 + x[1] * np.tanh(x[2] * height))) - relative)

    def jacobian(x: Array) -> Array:
        tanh = np.tanh(x[2] * height)
        growth = 1 + x[1] * tanh
        by_rate = np.zeros_like(tanh) if hold_rate else x[1] * height * (1 - tanh**2) / growth
        relative_slopes = [np.full_like(tanh, 1 / x[0]), tanh / growth, by_rate]
        return np.stack([-slope / (x[0] * growth) for slope in relative_slopes], axis=1)

    bounds = np.array([(1e-3, 1e3), _AMPLITUDES, _RATES]).T
    return least_squares(residuals, start, jac=jacobian, bounds=bounds)


def _slope_ratio(height: Array, relative: Array, tile: npt.NDArray[np.intp]) -> float:
    slope = height @ relative / (height @ height)
    residual = relative - relative.mean() - slope * height
    free = np.ones(1, dtype=bool)
    variance = _covariance(height[:, None], residual, tile, free)[0, 0]
    return float(np.divide(slope, np.sqrt(variance)))


def _covariance(jacobian: Array, residual: Array, tile: npt.NDArray[np.intp], free: npt.NDArray[np.bool_]) -> Array:
    """Of parameters from least squares, where residuals of one tile may be correlated (cluster-robust sandwich)."""
    result = np.full((free.size, free.size), np.nan)
    columns = jacobian[:, free]
    tiles = np.unique(tile).size
    if tiles > 1:
        scores = np.stack([np.bincount(tile, weights=column * residual) for column in columns.T])
        bread = np.linalg.pinv(columns.T @ columns)
        few = tiles / (tiles - 1) * (residual.size - 1) / (residual.size - free.sum())
        result[np.ix_(free, free)] = few * bread @ (scores @ scores.T) @ bread
    return result
