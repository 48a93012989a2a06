"""Statistics of the summits of a map, and their standard errors: from what they are without one tile at a time, and from the
waves that are longer than a tile."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Index = npt.NDArray[np.intp]

_ALONG_A_SIDE = 4
# Student's 0.975 quantile, of 15 degrees of freedom, over that of the normal distribution: 95 % lie within 1.96 errors then.
_STUDENT = 2.131 / 1.960
# Blocks along a side that show the waves longer than a tile.
_BLOCKS = 128
# A mean square of fewer independent parts than these depends on waves that the map has once or twice, and tells no error.
_FEWEST = 150.0


@dataclass(frozen=True)
class Estimate:
    """A number from a map, and its standard error.

    The error is from a jackknife over the 4 x 4 tiles of the map, so summits near each other may be correlated; those of
    heights and slopes see waves up to half of the map, too, by its spectrum. 95 % of maps of one surface lie within 1.96 errors
    of the truth. It is NaN where leaving a tile out leaves too few summits, and of heights where the longest waves are as long as
    the map: no map tells then how far it is off.

    Attributes:
        value: the number.
        error: its standard error, in the same unit.
    """

    value: float
    error: float

    def scaled(self, unit: float, origin: float = 0.0) -> Estimate:
        """The same in another unit, from another origin."""
        return Estimate(origin + unit * self.value, abs(unit) * self.error)

    def __float__(self) -> float:
        return self.value

    def __str__(self) -> str:
        return f"{self.value:.4g} +- {self.error:.2g}"


def tiles(row: Array, column: Array, shape: tuple[int, ...]) -> tuple[Index, Array]:
    """The tile that each summit is in, and the part of the inner points of the map that is in each tile."""
    found, parts = [], []
    for place, length in zip((row, column), shape):
        tile_of = np.arange(length - 2) * _ALONG_A_SIDE // (length - 2)
        found.append(tile_of[place.astype(int) - 1])
        parts.append(np.bincount(tile_of, minlength=_ALONG_A_SIDE) / (length - 2))
    return np.asarray(found[0] * _ALONG_A_SIDE + found[1]), np.outer(*parts).ravel()


def estimates(height: Array, curvature: Array, tile: npt.NDArray[np.intp], areas: Array) -> list[Estimate]:
    """Density, mean, standard deviation, skew and kurtosis of heights, and radius, each with its standard error.

    Args:
        height: of the summits, of order 1, shape (n,).
        curvature: mean of the two principal ones, shape (n,).
        tile: that each is in, shape (n,).
        areas: of the tiles, in units that the density is wanted in.
    """
    powers = [np.ones_like(height), height, height**2, height**3, height**4, curvature]
    sums = np.stack([np.bincount(tile, weights=values, minlength=areas.size) for values in powers] + [areas])
    total = sums.sum(axis=1, keepdims=True)
    values = _from_sums(total)[:, 0]
    errors = jackknife(_from_sums(total - sums[:, areas > 0]))
    return [Estimate(float(value), float(error)) for value, error in zip(values, errors)]


def jackknife(without: Array) -> Array:
    """Standard errors of numbers, from what they are without one tile at a time, shape (numbers, tiles)."""
    count = without.shape[1]
    variance = (count - 1) / count * ((without - without.mean(axis=1, keepdims=True)) ** 2).sum(axis=1)
    return np.asarray(_STUDENT * np.sqrt(variance))


def height_and_slope(level: Array, dx: float, dy: float) -> list[Estimate]:
    """Root mean square height and gradient of a map, each with its standard error."""
    cuts = [np.arange(_ALONG_A_SIDE + 1) * (length - 1) // _ALONG_A_SIDE for length in level.shape]
    sums = []
    for top, bottom in zip(cuts[0], cuts[0][1:]):
        for left, right in zip(cuts[1], cuts[1][1:]):
            part = level[top : bottom + 1, left : right + 1]  # one more, for differences
            slopes = np.square(np.diff(part, axis=1)[:-1] / dx) + np.square(np.diff(part, axis=0)[:, :-1] / dy)
            sums.append((np.square(part[:-1, :-1]).sum(), slopes.sum(), slopes.size))
    found = np.array(sums, dtype=np.float64).T
    total = found.sum(axis=1, keepdims=True)
    values, without = (np.sqrt(some[:2] / some[2]) for some in (total, total - found[:, found[2] > 0]))
    errors = np.maximum(jackknife(without), [_by_waves(fields, value) for fields, value in zip(_fields(level, dx, dy), values[:, 0])])
    return [Estimate(float(value), float(error)) for value, error in zip(values[:, 0], errors)]


def with_waves(height_std: Estimate, rms_height: Estimate) -> Estimate:
    """The standard deviation of the summits with the error that the long waves, on which they stand, give it."""
    return Estimate(height_std.value, float(np.maximum(height_std.error, rms_height.error * rms_height.value / height_std.value)))


def _fields(level: Array, dx: float, dy: float) -> tuple[list[Array], list[Array]]:
    """Long waves of the heights, and of the two slopes."""
    rows, columns = (max(length // _BLOCKS, 1) for length in level.shape)
    down, along = level.shape[0] // rows, level.shape[1] // columns
    blocks = level[: down * rows, : along * columns].reshape(down, rows, along, columns).mean(axis=(1, 3))
    return [blocks], [np.diff(blocks, axis=1)[:-1] / (columns * dx), np.diff(blocks, axis=0)[:, :-1] / (rows * dy)]


def _by_waves(fields: list[Array], value: float) -> float:
    """The standard error of a root mean square of Gaussian fields, by the powers of their waves: the variance of their mean square is
    twice the sum of the squared powers, and a power as it is found has twice the square of what it is in the mean."""
    powers = sum(np.square(np.abs(np.fft.fft2(field) / field.size)) for field in fields)
    variance = float(np.square(powers).sum()) / value**4 if value > 0 else 0.0
    return 0.5 * math.sqrt(variance) * value if variance * _FEWEST < 2 else math.nan


def _from_sums(sums: Array) -> Array:
    count, s1, s2, s3, s4, curvature, area = sums
    count = np.where(count < 2, np.nan, count)
    mean, s2, s3, s4 = s1 / count, s2 / count, s3 / count, s4 / count
    square = s2 - mean**2
    cube = s3 - 3 * mean * s2 + 2 * mean**3
    fourth = s4 - 4 * mean * s3 + 6 * mean**2 * s2 - 3 * mean**4
    std = np.sqrt(square * count / (count - 1))
    return np.stack([count / area, mean, std, cube / square**1.5, fourth / square**2, count / curvature])
