"""A measured map made ready for the search of summits: levelled, without spikes, with missing points filled."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import caller
from ..tools.progress import LARGE, Progress, teller
from . import rows as _rows, spikes as _spikes
from .input import checked, degree
from .instrument_files import HeightMap
from .map_warnings import MapWarning
from .steps import Steps, steps
from .summit_search import basis, products_of

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# A density that is wrong by this part matters beside the standard errors of maps with some hundred summits.
_MUCH = 0.05


class Cleaned(NamedTuple):
    """What `clean` made of a map.

    Attributes:
        map: the levelled map with its distances; `summits` and `filter` take it as it is.
        missing: how many points were not known.
        spikes: how many points stood out and were taken for spikes.
        particles: how many places stood out and were taken for dust.
        filled: where heights were replaced, of the shape of the map.
        offsets: of the lines that were aligned, their standard deviation [length]; 0 if none were.
        steps: of the heights as recorded; None if they are fine.
    """

    map: HeightMap
    missing: int
    spikes: int
    particles: int
    filled: Mask
    offsets: float
    steps: Steps | None

    def __str__(self) -> str:
        rows, columns = self.filled.shape
        said = [f"{rows} x {columns} points, {self.missing} missing and {self.spikes} spikes filled, {self.filled.mean():.2g} of all"]
        if self.particles:
            said.append(f"{self.particles} particles filled")
        if self.offsets:
            said.append(f"lines aligned, offsets {self.offsets:.2g}")
        if self.steps:
            said.append(f"heights in steps of {self.steps.step:.2g}")
        return ", ".join(said)


def clean(
    height_map: Any,
    dx: float | None = None,
    dy: float | None = None,
    *,
    detrend: int = 1,
    rows: bool = False,
    spikes: bool = True,
    dust: bool = False,
    progress: Progress = None,
) -> Cleaned:
    """Levels a map, replaces spikes and fills missing points.

    A spike is a point that differs from the median of the 5 x 5 points around it by more than 10 times what is usual in
    the map, and by more than 5 times what is usual among these (1.4826 times the median of such differences). Spikes are
    looked for again until there are none: a cleaned map has none. Missing points, spikes and dust are filled with the heights
    of a stretched membrane, each the mean of its 4 neighbours. Points of one height beside each other stay one plateau.

    Args:
        height_map: as for `summits`; points that the instrument did not see are NaN, infinite or masked.
        dx: distance of columns, where the map has none.
        dy: distance of rows; by default dx.
        detrend: degree of the polynomial that is subtracted, 0 to 8, fitted to the points that are neither missing nor spikes.
        rows: whether lines of the scan that are offset from each other are aligned, by the medians of differences between them.
        spikes: whether spikes are replaced.
        dust: whether particles are replaced: places where some points are higher than 8 times what is usual in the map.
        progress: as for `summits`.

    Raises:
        Error: as `summits`; more than half of the points missing; more than 1 % of them stand out, which are no
            spikes but what the surface is: `spikes=False` leaves them.
        TypeError: no real numbers.
        ImportError: SciPy is not installed.

    Warns:
        MapWarning: more than 5 % of the map is filled.
    """
    given = checked(height_map, dx, dy, missing=True)
    raw, recorded = given.height_map, given.height_map if given.recorded is None else given.recorded
    degree(detrend, raw.shape)
    tell = teller(progress, raw.size > LARGE)
    bad = np.isnan(raw)
    missing = int(bad.sum())
    if 2 * missing > raw.size:
        raise Error(f"height_map: {missing} of {raw.size} heights are missing: at most half may be; crop the map")
    tell(0.0, "levelling the known points")
    level = _level(raw, bad, detrend)
    found = steps(recorded)
    lines = _rows.offsets(level) if rows else None
    if lines is not None:
        offsets = np.expand_dims(lines[1], 1 - lines[0])
        if found is None:
            recorded = raw = raw - offsets
        else:  # by whole steps, which leave plateaus as they are
            raw = raw - found.step * np.round(offsets / found.step)
            recorded = found.step * np.round((raw - np.nanmin(raw)) / found.step)
        level = _level(raw, bad, detrend)
    tell(0.2, "looking for spikes and dust")
    particles = 0
    if dust:
        places, particles = _spikes.particles(level)
        bad |= places
    tell(0.3, f"filling {int(bad.sum())} points")
    known = raw.size - int(bad.sum())
    while True:
        level = _level(raw, bad, detrend)
        level[bad] = _membrane(level, bad)
        more = _spikes.spikes(level) & ~bad if spikes else np.zeros_like(bad)
        bad |= more
        count = known - (raw.size - int(bad.sum()))
        if count > _spikes.MOST * raw.size:
            raise Error(
                f"height_map: {count} of {raw.size} points stand out from those around them: too many for spikes, so the surface "
                "is like that, or the map is mostly noise: give spikes=False to leave them, and filter the map"
            )
        if not more.any():
            break
        tell(0.5, f"filled {count} spikes")
    tell(1.0, "cleaned")
    if (part := bad.mean()) > _MUCH:
        caller.warn(f"{part:.0%} of the map is filled: {_filling(bad)}", MapWarning)
    deviation = 0.0 if lines is None else float(lines[1].std())
    return Cleaned(
        HeightMap(level, given.dx, given.dy, np.where(bad, np.nan, recorded), unit=given.unit), missing, count, particles, bad, deviation, found
    )


def holes(bad: Mask) -> bool:
    """Whether points that are filled are mostly in holes: have no known neighbour along rows and columns."""
    whole = np.pad(bad, 1)
    inner = bad & whole[:-2, 1:-1] & whole[2:, 1:-1] & whole[1:-1, :-2] & whole[1:-1, 2:]
    return bool(2 * inner.sum() > bad.sum())


def _filling(bad: Mask) -> str:
    """What filling does to the summits."""
    if holes(bad):
        return "holes have no summits, so the density is low by as much; crop the map to what was measured"
    return (
        "single points beside known ones make summits of their neighbours, so the density may be high by as much; filter the map "
        "with a cutoff of 6 points or more"
    )


def _level(raw: Array, bad: Mask, detrend: int) -> Array:
    """Heights less the polynomial that fits best those that are not bad."""
    rows, columns = (basis(length, detrend) for length in raw.shape)
    good = ~bad
    heights = np.where(good, raw, 0.0)
    powers = [(i, j) for i in range(detrend + 1) for j in range(detrend + 1 - i)]
    # Sums over the points of products of two of the polynomials.
    weights = products_of(rows).T @ good @ products_of(columns)
    size = detrend + 1
    gram = np.array([[weights[i * size + k, j * size + m] for k, m in powers] for i, j in powers])
    found = rows.T @ heights @ columns
    values = np.linalg.lstsq(gram, np.array([found[i, j] for i, j in powers]), rcond=None)[0]
    coefficients = np.zeros((size, size))
    for (i, j), value in zip(powers, values):
        coefficients[i, j] = value
    level: Array = raw - rows @ coefficients @ columns.T
    return level


def _membrane(level: Array, bad: Mask) -> Array:
    """Heights at the bad points, each the mean of its neighbours along rows and columns (Laplace's equation)."""
    from scipy.sparse import coo_array
    from scipy.sparse.linalg import spsolve

    count = int(bad.sum())
    if count == 0:
        return np.empty(0)
    number = np.full(level.shape, -1, dtype=np.intp)
    number[bad] = np.arange(count)
    row, column = np.nonzero(bad)
    own, other, known, neighbours = [], [], np.zeros(count), np.zeros(count)
    for i, j in ((-1, 0), (1, 0), (0, -1), (0, 1)):
        inside = (row + i >= 0) & (row + i < level.shape[0]) & (column + j >= 0) & (column + j < level.shape[1])
        here, there = np.nonzero(inside)[0], (row[inside] + i, column[inside] + j)
        neighbours[here] += 1
        unknown = bad[there]
        own.append(here[unknown])
        other.append(number[there][unknown])
        known[here[~unknown]] += level[there][~unknown]
    places = np.concatenate([np.arange(count), *own]), np.concatenate([np.arange(count), *other])
    values = np.concatenate([neighbours, -np.ones(places[0].size - count)])
    matrix = coo_array((values, places), shape=(count, count)).tocsc()
    return np.asarray(spsolve(matrix, known), dtype=np.float64).reshape(count)
