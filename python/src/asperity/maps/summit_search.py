"""Where the summits of a height map are, how high, and how curved: the search and the differences, no statistics."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Index = npt.NDArray[np.intp]

_AROUND = [(i, j) for i in (-1, 0, 1) for j in (-1, 0, 1) if (i, j) != (0, 0)]


class Found(NamedTuple):
    """One entry a summit.

    row, column are indices into the map, not whole for a plateau; the rest is in the units of the map. Curvatures are
    the principal ones, positive where the surface falls away, first >= second.
    """

    row: Array
    column: Array
    height: Array
    first_curvature: Array
    second_curvature: Array


def without_polynomial(heights: Array, degree: int) -> Array:
    """Heights less the polynomial in x and y of this total degree that fits them best (least squares)."""
    # On a grid, products of polynomials that are orthonormal along each axis are orthonormal.
    rows, columns = (basis(length, degree) for length in heights.shape)
    coefficients = rows.T @ heights @ columns
    powers = np.arange(degree + 1)
    coefficients[powers[:, None] + powers > degree] = 0.0
    fitted: Array = rows @ coefficients @ columns.T
    np.subtract(heights, fitted, out=fitted)
    return fitted


def basis(length: int, degree: int) -> Array:
    """Polynomials up to a degree, orthonormal over so many points: shape (length, degree + 1)."""
    return np.linalg.qr(np.polynomial.legendre.legvander(np.linspace(-1.0, 1.0, length), degree))[0]


def products_of(polynomials: Array) -> Array:
    """The products of each two columns: shape (length, count^2)."""
    return np.asarray((polynomials[:, :, None] * polynomials[:, None, :]).reshape(len(polynomials), -1))


def find(raw: Array, level: Array, dx: float, dy: float) -> Found:
    """The summits of `level`: inner pixels higher than their 8 neighbours.

    Neighbours that are equal in `raw`, the map as it was recorded, count as equal in `level` too: subtracting a plane
    tilts the plateaus of a quantised map, which must not make summits of their corners. Pixels of one plateau make
    one summit, if all around the plateau is lower and the plateau does not reach the edge of the map. Its height,
    place and second derivatives are the means over its pixels.
    """
    ny, nx = level.shape
    inner = np.s_[1:-1, 1:-1]
    highest = np.ones((ny - 2, nx - 2), dtype=bool)
    tied = np.zeros_like(highest)
    for i, j in _AROUND:
        beside = np.s_[1 + i : ny - 1 + i, 1 + j : nx - 1 + j]
        same = raw[beside] == raw[inner]
        highest &= same | (level[beside] < level[inner])
        tied |= same
    row, column = (index + 1 for index in np.nonzero(highest))
    summit = _joined(raw, row, column, tied[row - 1, column - 1])
    row, column, summit = row[summit >= 0], column[summit >= 0], summit[summit >= 0]

    members = np.bincount(summit)

    def mean(values: npt.NDArray[np.floating] | Index) -> Array:
        return np.bincount(summit, weights=values) / members

    around = {(i, j): level[row + i, column + j] for i, j in _AROUND}
    top = level[row, column]
    along_x = mean((around[0, 1] - 2 * top + around[0, -1]) / dx / dx)
    along_y = mean((around[1, 0] - 2 * top + around[-1, 0]) / dy / dy)
    mixed = mean((around[1, 1] - around[1, -1] - around[-1, 1] + around[-1, -1]) / 4 / dx / dy)
    centre, deviation = -(along_x + along_y) / 2, np.hypot((along_x - along_y) / 2, mixed)
    return Found(mean(row), mean(column), mean(top), centre + deviation, centre - deviation)


def _joined(raw: Array, row: Index, column: Index, tied: npt.NDArray[np.bool_]) -> Index:
    """The number of the summit that each candidate belongs to, from 0 on; -1 for those of plateaus that are none."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components

    count = row.size
    candidate = np.full(raw.shape, -1, dtype=np.intp)
    candidate[row, column] = np.arange(count)
    flat = np.nonzero(tied)[0]
    first, second, spoilt = [], [], np.zeros(count, dtype=bool)
    for i, j in _AROUND:
        there = row[flat] + i, column[flat] + j
        same = raw[there] == raw[row[flat], column[flat]]
        other = candidate[there]
        spoilt[flat[same & (other < 0)]] = True  # the plateau goes on, and has something higher or the edge beside it
        linked = same & (other >= 0)
        first.append(flat[linked])
        second.append(other[linked])
    a, b = np.concatenate(first), np.concatenate(second)
    _, plateau = connected_components(coo_array((np.ones(a.size, dtype=np.int8), (a, b)), shape=(count, count)))
    good = np.bincount(plateau, weights=spoilt) == 0
    number = np.where(good, np.cumsum(good) - 1, -1)
    return np.asarray(number[plateau], dtype=np.intp)
