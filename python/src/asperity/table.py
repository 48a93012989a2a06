"""The compiled law as NumPy arrays, for array libraries and kernels that cannot call the library.

A row is a polynomial c[0] + c[1] t + ... for a fraction of a binade of x = load - pull_off_load. Its index is
(bits of x >> shift) - base, as unsigned integers; if that is not below `row_count`, `beside` has the answer. t is the
float of (bits of x below `shift` | bits of 1.0), less 1. The value is the friction force F; the derivative by t, times
2^-(exponent of x), is dF/d(load).

A row whose first number is NaN is a link to its parts; 0 for the index of its first part means that the row is left out.

- float64: the last 51 bits of that NaN are 64 times the index of the first part; row[2:] are the t at which the next ones
  begin, and the t of a part is less by where it begins. Layout of `asperity_table` in asperity.h.
- float32: the last 22 bits are the index of the first of eight parts, which the next three bits of x choose; t begins where
  the part does. c[0] to c[5] are coefficients, c[6] and c[7] what the first two lose by rounding. The pull-off load is
  pull_off_load + pull_off_rest. Layout of `asperity_float_table` in asperity_eval.h, which says how good it is.

`asperity.jax` and `asperity.warp` evaluate both.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _header
from ._handle import Handle
from ._library import LIBRARY
from .errors import check

Array = npt.NDArray[Any]

_FLOAT_SHIFT, _LEAST_SHIFT = 20, 11
# Force and slope of a row of floats are good to half the rounding of a float and to 1e-7: with the roundings of evaluating
# it, within the 2e-7 that asperity_eval.h tells.
_FORCE_ERROR, _SLOPE_ERROR = 10**-7.5, 1e-7
# A greater cap is none: its inverse would not be a normal float.
_LARGEST_CAP, _LEAST_INVERSE_CAP = 8e37, 1.25e-38
_LINK = 0x1FF << 22
_ONE, _EXPONENT = 127 << 23, 255 << 23
# The places of Chebyshev's points of degree 6, which a row of floats is made from, and where it is compared.
_NODES = 0.5 - 0.5 * np.cos((2 * np.arange(6) + 1) * np.pi / 12)
_BETWEEN = (np.arange(8) + 0.5) / 8


@dataclass(frozen=True, eq=False)
class Table:
    """The compiled law of a model, read-only; the head of this module has its indexing rule.

    Attributes:
        rows: shape (rows and parts, 8), float64 or float32; float64 is a view of the library's memory, which it keeps.
        row_count: number of rows found from x; parts follow them.
        base: shifted bits of x at which the first row begins.
        shift: how far the bits of x are shifted.
        depth: how many links follow one another at most.
        pull_off_load: [force]; with `pull_off_rest`, which is 0 for float64.
        pull_off_rest: what `pull_off_load` loses by rounding.
        max_friction_coefficient: cap on the coefficient.
        inverse_cap: loads up to this times F have the capped coefficient.
        pull_off_force: F at pull-off [force].
        light_slope: dF/d(load) of the line that stands for F between pull-off and the first row.
        zero_force: F at zero load [force].
        zero_slope: dF/d(load) there.
        separated_slope: dF/d(load) below pull-off, where F is 0.
        heavy_force: F for loads heavier than the table.
    """

    rows: Array = field(repr=False)
    row_count: int
    base: int
    shift: int
    depth: int
    pull_off_load: float
    pull_off_rest: float
    max_friction_coefficient: float
    inverse_cap: float
    pull_off_force: float
    light_slope: float
    zero_force: float
    zero_slope: float
    separated_slope: float
    heavy_force: float

    @property
    def dtype(self) -> np.dtype[Any]:
        """float64 or float32."""
        return self.rows.dtype


_SCALARS = (
    "max_friction_coefficient", "inverse_cap", "pull_off_force", "light_slope", "zero_force", "zero_slope",
    "separated_slope", "heavy_force",
)  # fmt: skip


def of_doubles(handle: Handle, kind: int = _header.ASPERITY_TABLE_FRICTION) -> Table:
    """A view of one of the library's tables; it keeps the model alive."""
    struct = _header.asperity_table(struct_size=ctypes.sizeof(_header.asperity_table))
    check(LIBRARY.asperity_table_of(handle.pointer, kind, ctypes.byref(struct)))
    found: Any = struct
    memory = (ctypes.c_double * (8 * found.total_count)).from_address(ctypes.addressof(found.rows.contents))
    setattr(memory, "model", handle)  # every view of the memory holds it
    rows = np.frombuffer(memory, dtype=np.float64).reshape(-1, 8)
    rows.setflags(write=False)
    scalars = {name: getattr(found, name) for name in _SCALARS}
    return Table(
        rows, int(found.row_count), int(found.base), int(found.shift), _depth(rows, int(found.row_count)),
        pull_off_load=found.pull_off_load, pull_off_rest=0.0, **scalars,
    )  # fmt: skip


def of_floats(table: Table) -> Table:
    """The table of floats of one of doubles, as `asperity_eval_make_float` makes it."""
    bias, least, most = (1023 - 127) << 3, (127 - 100) << 3, (127 + 100) << 3
    begin = max(((table.base << table.shift) + (1 << 49) - 1) >> 49, bias + least) - bias
    end = max(min(((table.base + table.row_count) << table.shift) >> 49, bias + most) - bias, begin)
    bits, shift = np.arange(begin, end, dtype=np.uint32) << _FLOAT_SHIFT, _FLOAT_SHIFT
    levels: list[Array] = []
    count = bits.size
    while bits.size:
        rows, divided = _fitted(table, bits, shift)
        if shift == _LEAST_SHIFT:
            divided[:] = False
        links = _LINK | (count + 8 * np.arange(divided.sum(), dtype=np.uint32))
        rows[divided, 0] = links.astype(np.uint32).view(np.float32)
        levels.append(rows)
        shift -= 3
        bits = (bits[divided, None] + (np.arange(8, dtype=np.uint32) << np.uint32(shift))).ravel()
        count += bits.size
    whole = np.concatenate(levels) if levels else np.empty((0, 8), np.float32)
    whole.setflags(write=False)
    ends = (np.array([begin, end], dtype=np.uint32) << _FLOAT_SHIFT).view(np.float32).astype(np.float64)
    (lightest, _), (heaviest, _) = (at_excess(table, ends[i : i + 1]) for i in range(2))
    largest = float(np.finfo(np.float32).max)
    scalars = {name: float(np.float32(min(max(getattr(table, name), -largest), largest))) for name in _SCALARS}
    scalars["light_slope"] = float(np.float32((lightest[0] - table.pull_off_force) / ends[0]))
    scalars["heavy_force"] = float(np.float32(heaviest[0] if np.isfinite(heaviest[0]) else table.heavy_force))
    scalars["max_friction_coefficient"] = (
        float("inf") if table.max_friction_coefficient > _LARGEST_CAP else scalars["max_friction_coefficient"]
    )
    scalars["inverse_cap"] = float(np.float32(max(table.inverse_cap, _LEAST_INVERSE_CAP)))
    pull_off = float(np.float32(table.pull_off_load))
    return Table(
        whole, end - begin, begin, _FLOAT_SHIFT, len(levels) - 1,
        pull_off_load=pull_off, pull_off_rest=float(np.float32(table.pull_off_load - pull_off)), **scalars,
    )  # fmt: skip


def at_excess(table: Table, x: Array) -> tuple[Array, Array]:
    """F and dF/d(load) at x = load - pull_off_load within the rows of doubles; NaN beside them and in what is left out."""
    bits = x.view(np.uint64)
    index = (bits >> np.uint64(table.shift)) - np.uint64(table.base)
    inside = index < table.row_count
    row = table.rows[np.where(inside, index, 0).astype(np.int64)]
    within = bits & np.uint64((1 << table.shift) - 1) | np.uint64(1023 << 52)
    t, begin = within.view(np.float64) - 1, np.zeros(x.shape)
    for _ in range(table.depth):
        link = np.isnan(row[:, 0])
        before = (t[:, None] >= row[:, 2:]).sum(axis=1)
        first = _first_parts(row)
        link &= first > 0
        later = np.take_along_axis(row, 1 + before[:, None], axis=1)[:, 0]
        begin = np.where(link & (before > 0), later, begin)
        row = np.where(link[:, None], table.rows[np.where(link, first + before, 0)], row)
    row = np.where(inside[:, None], row, np.nan)
    value, rate = np.zeros(x.shape), np.zeros(x.shape)
    for coefficient in row.T[::-1]:
        rate = rate * (t - begin) + value
        value = value * (t - begin) + coefficient
    return value, rate / _binade(bits)


def _first_parts(rows: Array) -> Array:
    """The indices of the first parts of rows of doubles that are links; 0 of one that is left out."""
    bits = np.ascontiguousarray(rows[:, 0]).view(np.uint64)
    return (bits & np.uint64((1 << 51) - 1)).astype(np.int64) // 64


def _binade(bits: Array) -> Array:
    return (bits & np.uint64(0x7FF << 52)).view(np.float64)


def _fitted(table: Table, bits: Array, shift: int) -> tuple[Array, Array]:
    """Rows of floats that begin at these bits, and which of them are to be divided."""
    length = 2.0 ** (shift - 23)
    start = bits.view(np.float32).astype(np.float64)
    binade = (bits & np.uint32(_EXPONENT)).view(np.float32).astype(np.float64)

    def force(part: Array) -> tuple[Array, Array]:
        values = at_excess(table, (start[:, None] + part * length * binade[:, None]).ravel())
        return values[0].reshape(-1, part.size), values[1].reshape(-1, part.size)

    c = _interpolated(force(_NODES)[0]) / length ** np.arange(6)
    rows = np.zeros((bits.size, 8), np.float32)
    rows[:, :6] = c
    rows[:, 6:] = c[:, :2] - rows[:, :2]
    rows[np.isnan(rows[:, 0])] = np.nan
    exact, slope = force(_BETWEEN)
    kept = rows[:, :6].astype(np.float64)
    kept[:, :2] += rows[:, 6:]
    powers = (_BETWEEN * length)[:, None] ** np.arange(6)
    value, rate = kept @ powers.T, kept[:, 1:] @ (powers[:, :5] * np.arange(1, 6)).T / binade[:, None]
    missing = np.isnan(value) | np.isnan(exact)
    with np.errstate(invalid="ignore"):
        bad = np.abs(value - exact) > _FORCE_ERROR * np.abs(exact)
        bad |= np.abs(rate - slope) > _SLOPE_ERROR * np.abs(slope)
    return rows, np.any(bad, axis=1) | np.any(missing, axis=1) & ~np.all(missing, axis=1)


def _interpolated(values: Array) -> Array:
    """Coefficients of the polynomials of degree 5 through values at the nodes, by Newton's divided differences: they lose
    no digits of small differences between large values, as solving for the coefficients would."""
    values = values.copy()
    for k in range(1, 6):
        values[:, k:] = (values[:, k:] - values[:, k - 1 : -1]) / (_NODES[k:] - _NODES[:-k])
    c = np.zeros_like(values)
    for k in range(5, -1, -1):
        c[:, 1:] = c[:, :-1] - _NODES[k] * c[:, 1:]
        c[:, 0] = values[:, k] - _NODES[k] * c[:, 0]
    return c


def _depth(rows: Array, row_count: int) -> int:
    """How many links follow one another at most."""
    depth, level = 0, np.arange(row_count)
    while level.size:
        links = rows[level]
        links = links[np.isnan(links[:, 0])]
        first = _first_parts(links)
        parts = 1 + (links[:, 2:] < 1).sum(axis=1)
        level = np.concatenate([np.arange(i, i + n) for i, n in zip(first[first > 0], parts[first > 0])] or [np.arange(0)])
        depth += level.size > 0
    return depth
