"""Heights and slopes of a map at the normal scores of its heights: what makes asperities of a surface that is not Gaussian."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

_STEP, _LAST = 0.5, 3.0
SCORES = np.arange(-_LAST, _LAST + _STEP / 2, _STEP)
# Nowhere is the mean square slope taken for less than this part of that of the map.
_LEAST = 0.02
# The longest lay for which the library has asperities.
_LONGEST = 20.0
# Tiles along a side, and so many points of the map along a side tell how it is without one of them.
_TILES, _POINTS = 4, 256


class AtScores(NamedTuple):
    """A surface at the normal scores -3, -2.5 to 3 of its heights. A Gaussian one has Sq times the scores as heights, and Sdq as slopes.

    Attributes:
        heights: above the mean plane [length].
        slopes: root mean square gradients where the surface has these heights: of normal slopes that have the mean magnitudes of the slopes
            across and along the lay, so that a few steep places do not decide.
        lay: root mean square slope across the lay over that along it, 1 to 20.
    """

    heights: tuple[float, ...]
    slopes: tuple[float, ...]
    lay: float

    @property
    def keys(self) -> dict[str, Any]:
        """What [roughness] of a surface file has of it."""
        return {"heights_at_scores": list(self.heights), "slopes_at_scores": list(self.slopes), "lay": self.lay}


class Sloped(NamedTuple):
    """Inner points of a map.

    Attributes:
        height: from the mean plane.
        across, along: magnitudes of the slopes across the lay and along it, means over the four triangles of neighbours.
        principal: mean squares of both.
        noise: mean square gradient of the noise in them.
    """

    height: Array
    across: Array
    along: Array
    principal: tuple[float, float]
    noise: float

    @property
    def isotropy(self) -> float:
        """Mean square slope along the lay over that across it."""
        greater, lesser = (one - self.noise / 2 for one in self.principal)
        return min(max(lesser, 0.0) / greater, 1.0) if greater > 0 else 1.0

    @property
    def at_scores(self) -> AtScores:
        """Heights and slopes at the scores; equal heights have one score."""
        from scipy.special import ndtri

        order = np.argsort(self.height, axis=None)
        height, across, along = (one.ravel()[order] for one in self[:3])
        level = np.concatenate([[0], np.cumsum(np.diff(height) > 0)])
        count = np.bincount(level)
        score = ndtri((np.cumsum(count) - count / 2) / height.size)[level]
        square = math.pi / 2 * (_means(score, across) ** 2 + _means(score, along) ** 2) - self.noise
        slopes = np.sqrt(np.maximum(square, _LEAST * sum(self.principal)))
        return AtScores(tuple(_heights(score, height).tolist()), tuple(slopes.tolist()), max(self.isotropy, _LONGEST**-2) ** -0.5)

    def without_each_tile(self) -> list[AtScores]:
        """The same without one of the 4 x 4 tiles of the map at a time."""
        rows, columns = (np.arange(0, length, -(-length // _POINTS)) for length in self.height.shape)
        tile = (rows * _TILES // self.height.shape[0])[:, None] * _TILES + columns * _TILES // self.height.shape[1]
        thin = [one[np.ix_(rows, columns)] for one in self[:3]]
        return [self._replace(**dict(zip(self._fields, (one[tile != i] for one in thin)))).at_scores for i in range(_TILES**2)]


def sloped(level: Array, dx: float, dy: float, noise: float = 0.0) -> Sloped:
    """The inner points of a level map, with noise of this mean square gradient."""
    x, y = np.diff(level, axis=1)[1:-1] / dx, np.diff(level, axis=0)[:, 1:-1] / dy
    beside, above = (x[:, 1:], x[:, :-1]), (y[1:], y[:-1])
    corners = [(one, other) for one in beside for other in above]
    squares = [np.mean([np.mean(one * one) for one in both]) for both in (beside, above)]
    mixed = np.mean([np.mean(one * other) for one, other in corners])
    principal, axes = np.linalg.eigh([[squares[0], mixed], [mixed, squares[1]]])
    along, across = (np.mean([np.abs(axis[0] * one + axis[1] * other) for one, other in corners], axis=0) for axis in axes.T)
    return Sloped(level[1:-1, 1:-1], across, along, (float(principal[1]), float(max(principal[0], 0.0))), noise)


def _means(score: Array, slope: Array) -> Array:
    """Means of slopes at the scores, each of those from the score before to the one after."""
    place = np.clip((score + _LAST) / _STEP, 0.0, SCORES.size - 1.0)
    below = np.minimum(place.astype(np.intp), SCORES.size - 2)
    share = place - below
    weight, total = (
        np.bincount(below, (1 - share) * one, SCORES.size) + np.bincount(below + 1, share * one, SCORES.size) for one in (1.0, slope)
    )
    known = weight > 0
    return np.asarray(np.interp(SCORES, SCORES[known], total[known] / weight[known]))


def _heights(score: Array, height: Array) -> Array:
    """Ascending heights at the scores; straight beyond those that the map has."""
    found = np.asarray(np.interp(SCORES, score, height))
    for end, beyond in ((0, SCORES < score[0]), (-1, SCORES > score[-1])):
        inward = np.copysign(_STEP, -score[end])
        rate = (np.interp(score[end] + inward, score, height) - height[end]) / inward
        found[beyond] = height[end] + rate * (SCORES[beyond] - score[end])
    return found
