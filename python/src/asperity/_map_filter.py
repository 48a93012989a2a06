"""The Gaussian filter of ISO 16610-61 for maps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt

from ._instrument_files import HeightMap
from ._map_input import checked, length
from ._summit_search import without_polynomial

Array = npt.NDArray[np.float64]

# Half of a wave as long as the cutoff passes.
_ALPHA = math.sqrt(math.log(2) / math.pi)


def filter(height_map: Any, cutoff: float, dx: float | None = None, dy: float | None = None) -> HeightMap:
    """Takes away what is shorter than a cutoff: the areal Gaussian filter of ISO 16610-61, as its S-filter.

    Of a wave of length L exp(-pi (alpha cutoff/L)^2) passes, with alpha^2 = ln 2/pi: half where L is the cutoff. The plane
    that fits best is taken away first. At the edge the points inside the map alone count.

    Args:
        height_map: as for `summits`; all heights must be known.
        cutoff: wavelength [length], at least two points.
        dx: distance of columns, where the map has none.
        dy: distance of rows; by default dx.

    Raises:
        ValueError: a cutoff shorter than two points, which no map has waves of, or longer than the map; as `summits`.
        TypeError: no real numbers.
        ImportError: SciPy is not installed.
    """
    from scipy.ndimage import gaussian_filter1d

    heights, dx, dy = checked(height_map, dx, dy)
    cutoff = length("cutoff", cutoff)
    rows, columns = heights.shape
    if not 2 * max(dx, dy) <= cutoff <= min(rows * dy, columns * dx):
        raise ValueError(
            f"cutoff = {cutoff:g}: must be from two points, {2 * max(dx, dy):g}, to the side of the map, "
            f"{min(rows * dy, columns * dx):g}"
        )
    filtered = without_polynomial(heights, 1)
    for axis, step in enumerate((dy, dx)):
        deviation = _ALPHA * cutoff / step / math.sqrt(2 * math.pi)
        inside = gaussian_filter1d(np.ones(heights.shape[axis]), deviation, mode="constant")
        filtered = gaussian_filter1d(filtered, deviation, axis=axis, mode="constant")
        filtered /= inside[:, None] if axis == 0 else inside
    return HeightMap(filtered, dx, dy)
