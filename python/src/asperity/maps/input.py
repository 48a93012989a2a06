"""What a height map may be given as, and what it may not be."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import checks
from .instrument_files import HeightMap, of_topography

Array = npt.NDArray[np.float64]

MOST_DEGREE = 8
# So many heights of one number, this part of the range of 98 % of the others away from them, and so many of their steps.
_MANY, _GAP, _STEPS = 30, 0.2, 3.0
# Heights that tell this range and these steps.
_SOME = 20_000
# Within their range: so many times as often as each of so many numbers next to it on either side, of so many numbers; so many are counted.
_OFTEN, _BESIDE, _LEVELS, _COUNTED = 5, 4, 50, 2**20
# No more than this part of the map, and so many times as far from its neighbours in the map as these are from theirs, in the median.
_MOST, _APART = 0.25, 1.5


def checked(height_map: Any, dx: Any, dy: Any, *, missing: bool = False) -> HeightMap:
    """A map of real numbers with its distances; NaN where heights are unknown, if `missing` ones may be."""
    given, recorded, noise = None, None, 0.0
    if isinstance(getattr(height_map, "map", None), HeightMap):  # what `clean` returns
        height_map = height_map.map
    if isinstance(height_map, HeightMap) or hasattr(height_map, "physical_sizes"):
        if dx is not None or dy is not None:
            raise TypeError("dx, dy: must not be given with a map that has them")
        given = height_map if isinstance(height_map, HeightMap) else of_topography(height_map)
        height_map, dx, dy, recorded, noise = given.height_map, given.dx, given.dy, given.recorded, given.noise
    elif dx is None:
        raise TypeError("give dx, the distance of columns, and dy, that of rows, in the unit of the heights")
    mine = isinstance(given, HeightMap) and given.unit == "length"
    measured = given is not None and not mine or checks.has_unit(height_map)
    for name, step in (("dx", dx), ("dy", dx if dy is None else dy)):
        if given is None and measured != checks.has_unit(step):
            raise TypeError(f"{name} = {step!r}: must have a unit if the heights have one, and none if they have none")
    unit = "m" if measured else "length"
    array, _ = checks.known("height_map", height_map, unit)
    if array.ndim != 2 or min(array.shape) < 3:
        raise Error(f"height_map: has shape {array.shape}: must be 2-D, with at least 3 rows and 3 columns")
    unknown = ~np.isfinite(array)
    unknown |= _stand_ins(array, unknown)
    if unknown.any():
        if not missing:
            _refuse(array, unknown)
        array = np.where(unknown, np.nan, array)
    known = array[~unknown] if unknown.any() else array
    if known.size == 0 or known.min() == known.max():
        found = f"constant at {known[0] if known.ndim == 1 else known[0, 0]}" if known.size else "without a known height"
        raise Error(f"height_map: {found}: must be rough")
    steps = checks.positive("dx", dx, unit), checks.positive("dy", dx if dy is None else dy, unit)
    return HeightMap(array, *steps, recorded, unit=unit, noise=noise)


def _stand_ins(array: Array, unknown: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """Where a number stands for points that the instrument did not see, as -9999 or 0: many heights are this very number, it is the
    least or the greatest, and it is far from all others."""
    found = np.zeros_like(unknown)
    for end in (np.min, np.max, np.min):
        left = ~unknown & ~found
        if not left.any():
            break
        same = left & (array == end(array[left]))
        rest = array[left & ~same]
        if not _MANY <= np.count_nonzero(same) < rest.size:
            continue
        some = np.sort(rest[:: max(rest.size // _SOME, 1)])
        some = some[some.size // 100 : some.size - some.size // 100]
        gap = float(np.abs(rest - array[same][0]).min())
        if np.ptp(some) > 0 and gap > max(_GAP * np.ptp(some), _STEPS * np.diff(some).max()):
            found |= same
    return found | _repeated(array, ~unknown & ~found)


def _repeated(array: Array, known: npt.NDArray[np.bool_]) -> npt.NDArray[np.bool_]:
    """The same where this number is one that heights may have: it is far more frequent than those next to it, and its places stand out of
    the map. The zeros of lines that were set to their median do not, nor do those of a sine."""
    heights = array[known]
    levels, counts = np.unique(heights[:: max(heights.size // _COUNTED, 1)], return_counts=True)
    at = int(np.argmax(counts)) if levels.size >= _LEVELS else 0
    if not _BESIDE <= at < levels.size - _BESIDE:
        return np.zeros_like(known)
    beside = max(counts[at - _BESIDE : at].max(), counts[at + 1 : at + 1 + _BESIDE].max())
    same = known & (array == levels[at])
    is_frequent = counts[at] >= _MANY and _OFTEN * beside < counts[at] < _MOST * counts.sum()
    return same if is_frequent and _stands_out(array, known, same) else np.zeros_like(known)


def _stands_out(array: Array, known: npt.NDArray[np.bool_], same: npt.NDArray[np.bool_]) -> bool:
    """Whether points are farther from their neighbours than other points from theirs, and not between them."""
    jumps, usual, bends, bent = (
        np.concatenate([part[0], part[1]])
        for part in zip(*(_neighbours(*both) for both in ((array, known, same), (array.T, known.T, same.T))))
    )
    if min(bends.size, bent.size) < _MANY:
        return False
    return bool(np.median(jumps) > _APART * np.median(usual) and np.median(bends) > np.median(bent))


def _neighbours(array: Array, known: npt.NDArray[np.bool_], same: npt.NDArray[np.bool_]) -> tuple[Array, ...]:
    """First differences over rows from the points to others, and between others; second differences likewise."""
    first, second = np.abs(np.diff(array, axis=0)), np.abs(np.diff(array, 2, axis=0))
    pair, triple = known[1:] & known[:-1], known[2:] & known[1:-1] & known[:-2]
    other, others = pair & ~(same[1:] | same[:-1]), triple & ~(same[2:] | same[1:-1] | same[:-2])
    ends = triple & same[1:-1] & ~(same[2:] & same[:-2])
    return first[pair & (same[1:] ^ same[:-1])], first[other], second[ends], second[others]


def _refuse(array: Array, unknown: npt.NDArray[np.bool_]) -> None:
    row, column = (int(index) for index in np.unravel_index(int(np.argmax(unknown)), unknown.shape))
    kind = "one number that stands for missing ones" if np.isfinite(array[row, column]) else "masked or not finite"
    raise Error(
        f"height_map: {int(unknown.sum())} of {unknown.size} heights are {kind}, the first is "
        f"{array[row, column]} at [{row}, {column}]: all must be known; surface.clean fills them, or crop the map"
    )


def degree(detrend: Any, shape: tuple[int, ...] = (MOST_DEGREE + 2,)) -> int:
    """The degree of the polynomial that is taken away from a map."""
    if checks.whole("detrend", detrend, 0, MOST_DEGREE) > min(shape) - 2:
        raise Error(f"detrend = {detrend}: is too high for a map of {' x '.join(map(str, shape))} points")
    return int(detrend)
