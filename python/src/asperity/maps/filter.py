"""The Gaussian filter of ISO 16610-61 for maps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import checks
from . import map_warnings
from .input import checked
from .instrument_files import HeightMap
from .summit_search import without_polynomial

Array = npt.NDArray[np.float64]

# Half of a wave as long as the cutoff passes.
_ALPHA = math.sqrt(math.log(2) / math.pi)


def filter(
    height_map: Any, cutoff: float | None = None, dx: float | None = None, dy: float | None = None, *, longest: float | None = None
) -> HeightMap:
    """Takes away what is shorter than a cutoff, and what is longer than another: the areal Gaussian filter of ISO 16610-61, as its
    S-filter and its L-filter.

    Of a wave of length L exp(-pi (alpha cutoff/L)^2) passes, with alpha^2 = ln 2/pi: half where L is the cutoff. The plane
    that fits best is taken away first. At the edge the points inside the map alone count.

    Args:
        height_map: as for `summits`; all heights must be known.
        cutoff: wavelength [length] below which waves are taken away, at least two points.
        dx: distance of columns, where the map has none.
        dy: distance of rows; by default dx.
        longest: wavelength above which waves are taken away.

    Raises:
        Error: a cutoff shorter than two points, which no map has waves of, or longer than the map; as `summits`.
        TypeError: no real numbers; neither cutoff.
        ImportError: SciPy is not installed.
    """
    given = checked(height_map, dx, dy)
    if cutoff is None and longest is None:
        raise TypeError("give cutoff, the shortest wave that is left, or longest, the longest one, or both")
    heights, noise = without_polynomial(given.height_map, 1), 0.0
    if longest is not None:
        heights = heights - _smooth(heights, given, "longest", longest)
    if cutoff is not None:
        deviation = map_warnings.noise(map_warnings.differences(heights))
        heights = _smooth(heights, given, "cutoff", cutoff)
        noise = 0.0 if deviation is None else noise_slope(deviation, cutoff, given.dx, given.dy)
    return HeightMap(heights, given.dx, given.dy, unit=given.unit, noise=noise)


def noise_slope(deviation: float, cutoff: float, dx: float, dy: float) -> float:
    """The mean square gradient of white noise of this standard deviation, filtered with a cutoff."""
    width = _ALPHA * cutoff / math.sqrt(2 * math.pi)
    return deviation**2 * dx * dy / (4 * math.pi * width**4)


def _smooth(heights: Array, given: HeightMap, name: str, cutoff: float) -> Array:
    from scipy.ndimage import gaussian_filter1d

    cutoff = checks.positive(name, cutoff, given.unit)
    rows, columns = heights.shape
    least, most = 2 * max(given.dx, given.dy), min(rows * given.dy, columns * given.dx)
    if not least <= cutoff <= most:
        raise Error(f"{name} = {cutoff:g}: must be from two points, {least:g}, to the side of the map, {most:g}")
    for axis, step in enumerate((given.dy, given.dx)):
        deviation = _ALPHA * cutoff / step / math.sqrt(2 * math.pi)
        inside = gaussian_filter1d(np.ones(heights.shape[axis]), deviation, mode="constant")
        heights = gaussian_filter1d(heights, deviation, axis=axis, mode="constant")
        heights /= inside[:, None] if axis == 0 else inside
    return heights
