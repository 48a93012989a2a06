"""Points of a map that stand out from those around them: spikes of the instrument, and dust of its size."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# A point stands out by this many times what is usual in the map, and by this many times what is usual in the 5 x 5 points
# around it. The top of a hill stands out of the map, but not of the hill. Instruments' spikes are dozens of times as high.
_FACTOR, _LOCAL_FACTOR = 10.0, 5.0
# More than this part of the points are no spikes.
MOST = 0.01
# Heights over the median beside what is usual: of a particle's top and of its foot. The highest of 10^7 normal points is 5.3.
_PARTICLE, _FOOT = 8.0, 3.0
# More than this part of the map is no dust.
_MOST_DUST = 0.05
# The usual difference of a point from the median around it is that of so many points, which are looked at at a time.
_SAMPLES = 20_000
# Of a normal distribution: its standard deviation over the median of the magnitude.
_NORMAL = 1.4826


def spikes(level: Array) -> Mask:
    """Where a map has spikes, up or down; NaN is no height and no spike.

    Of the points that stand out from the mean of their 4 neighbours those that stand out from the median of the 5 x 5
    around them, beside the median of such differences in the map and among the 5 x 5.
    """
    found = np.zeros(level.shape, dtype=bool)
    difference = np.abs(_from_neighbours(level))
    usual = _NORMAL * float(np.nanmedian(difference))
    row, column = np.nonzero(difference > _FACTOR / 2 * usual)
    if row.size == 0 or usual == 0:
        return found
    around = np.pad(level, 2, mode="reflect")
    known = np.nonzero(np.isfinite(difference).ravel())[0]
    sample = known[np.linspace(0, known.size - 1, min(_SAMPLES, known.size)).astype(np.intp)]
    scale = _NORMAL * float(np.median(np.abs(_from_median(around, *np.unravel_index(sample, level.shape))[0])))
    for first in range(0, row.size, _SAMPLES):
        some = np.s_[first : first + _SAMPLES]
        off, spread = _from_median(around, row[some], column[some])
        high = np.abs(off) > np.maximum(_FACTOR * scale, _LOCAL_FACTOR * _NORMAL * spread)
        found[row[some][high], column[some][high]] = True
    return found


def particles(level: Array) -> tuple[Mask, int]:
    """Where particles lie on a map, and how many there are: places that are higher than anything a surface has by chance.

    None if the places are a part of the map that is no dust: the surface has two levels then.
    """
    from scipy.ndimage import binary_dilation, label

    centre = float(np.nanmedian(level))
    usual = _NORMAL * float(np.nanmedian(np.abs(level - centre)))
    nothing = np.zeros(level.shape, dtype=bool)
    number, count = label(level > centre + _FOOT * usual, np.ones((3, 3)))
    high = np.unique(number[level > centre + _PARTICLE * usual])
    if high.size == 0 or usual == 0:
        return nothing, 0
    # A point more on all sides, for the foot.
    found = binary_dilation(np.isin(number, high), np.ones((3, 3)))
    return (nothing, 0) if found.mean() > _MOST_DUST else (found, int(high.size))


def _from_neighbours(level: Array) -> Array:
    """Each height less the mean of its neighbours along rows and columns; NaN next to the unknown."""
    around = np.pad(level, 1, mode="reflect")
    difference = around[:-2, 1:-1] + around[2:, 1:-1]
    difference += around[1:-1, :-2]
    difference += around[1:-1, 2:]
    difference *= -0.25
    difference += level
    return difference


def _from_median(around: Array, row: npt.NDArray[np.intp], column: npt.NDArray[np.intp]) -> tuple[Array, Array]:
    """Heights at places less the median of the 5 x 5 points there, and the median of all 25 such differences, of a map that
    is padded by 2."""
    windows = np.lib.stride_tricks.sliding_window_view(around, (5, 5))[row, column].reshape(row.size, 25)
    middle = np.nanmedian(windows, axis=1)
    return around[row + 2, column + 2] - middle, np.nanmedian(np.abs(windows - middle[:, None]), axis=1)
