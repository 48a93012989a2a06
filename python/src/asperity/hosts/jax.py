"""The law inside JAX; `asperity.jax` has the names."""

from __future__ import annotations

import functools
import math
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..model import Model
from ..table import Table
from ..tools import checks
from ..units import unit

try:
    import jax
    import jax.numpy as jnp
    from jax import lax
except ImportError as error:
    raise ImportError(f"asperity.jax needs JAX ({error}): pip install jax") from None

__all__ = ["friction", "friction_force", "load_at_gap"]

Law = Callable[[Any], Any]


def friction_force(model: Model, dtype: npt.DTypeLike = np.float64) -> Law:
    """Friction force F [force] as a function of load [force], a scalar or an array of any shape.

    Args:
        model: the law; later changes of the model do not change what is returned.
        dtype: float64, which needs `jax_enable_x64`, or float32; loads are converted to it.

    Raises:
        Error: another type; float64 without `jax_enable_x64`.
    """
    table, of = _table(model, dtype), unit("force", model.params.in_si)
    law = _Law(table).derivative(0)
    return lambda load: law(_numbers("load", load, of, table.dtype))


def load_at_gap(model: Model) -> Law:
    """Load [force] as a function of gap [length], a scalar or an array of any shape; 0 at pull-off and beyond.

    In float64, with the derivatives of the table: minus the first one is the normal stiffness.

    Raises:
        Error: without `jax_enable_x64`.
    """
    _check_doubles()
    law, of = _Law(model.load_table()).derivative(0), unit("length", model.params.in_si)
    return lambda gap: law(-_numbers("gap", gap, of, np.float64))


def friction(model: Model, dtype: npt.DTypeLike = np.float64) -> Law:
    """Friction coefficient as a function of load, capped as that of the model; arguments are those of `friction_force`.

    Its slope is 0 where it is capped, at and below zero load, and below pull-off, where it is 0 itself.
    """
    table, of = _table(model, dtype), unit("force", model.params.in_si)
    force = _Law(table)

    def state(load: Any) -> tuple[Any, Any, Any, Any]:
        value = force.derivative(0)(load)
        capped = load <= value * table.dtype.type(table.inverse_cap)
        apart = _excess(table, load)[0] < 0
        return value, capped, apart, jnp.where(capped | apart, 1, load)

    @jax.custom_jvp
    def law(load: Any) -> Any:
        value, capped, apart, divisor = state(load)
        cap = table.dtype.type(table.max_friction_coefficient)
        return jnp.where(apart, 0, jnp.where(capped, cap, value / divisor))

    @law.defjvp
    def tangent(primals: Any, tangents: Any) -> tuple[Any, Any]:
        (load,), (change,) = primals, tangents
        _, capped, apart, divisor = state(load)
        mu = law(load)
        slope = jnp.where(capped | apart, 0, (force.derivative(1)(load) - mu) / divisor)
        return mu, slope * change

    return lambda load: law(_numbers("load", load, of, table.dtype))


def _numbers(name: str, given: Any, of: str, dtype: Any) -> Any:
    """Real numbers as an array of JAX, whether they are traced or come from another library."""
    if not isinstance(given, jax.Array) and not hasattr(given, "__jax_array__"):
        given = checks.array(name, given, of)
    elif not (jnp.issubdtype(given.dtype, np.integer) or jnp.issubdtype(given.dtype, np.floating)):
        raise TypeError(f"{name}: must be real numbers, not an array of {given.dtype}")
    return jnp.asarray(given, dtype)


def _table(model: Model, dtype: npt.DTypeLike) -> Table:
    if np.dtype(dtype) == np.float64:
        _check_doubles()
    return model.table(dtype)


def _check_doubles() -> None:
    if not jax.config.read("jax_enable_x64"):
        how = 'jax.config.update("jax_enable_x64", True) at the start of the program'
        raise Error(f'float64 needs {how}; or take dtype="float32"')


class _Law:
    """F and its derivatives by load, from the rows of a table."""

    def __init__(self, table: Table) -> None:
        self._table = table
        self.derivative = functools.lru_cache(maxsize=None)(self._derivative)

    def _derivative(self, order: int) -> Law:
        @jax.custom_jvp
        def law(load: Any) -> Any:
            return _evaluated(self._table, jnp.asarray(load, self._table.dtype), order)

        @law.defjvp
        def tangent(primals: Any, tangents: Any) -> tuple[Any, Any]:
            return law(*primals), self.derivative(order + 1)(*primals) * tangents[0]

        return lambda load: law(jnp.asarray(load, self._table.dtype))


def _evaluated(table: Table, load: Any, order: int) -> Any:
    x, lost = _excess(table, load)
    single = table.dtype == np.float32
    word, mantissa, bias = (np.uint32, 23, 127) if single else (np.uint64, 52, 1023)
    bits = lax.bitcast_convert_type(x, word)
    index = (bits >> word(table.shift)) - word(table.base)
    inside = index < word(table.row_count)
    rows = jnp.asarray(table.rows)
    row = rows[jnp.where(inside, index, 0).astype(np.int32)]
    exponent = jnp.where(inside, bits & word((2 * bias + 1) << mantissa), word(bias << mantissa))
    inverse_binade = lax.bitcast_convert_type(word(2 * bias << mantissa) - exponent, x.dtype)
    if single:
        row, within = _part_of_floats(table, rows, row, bits)
        t = lax.bitcast_convert_type(within | word(bias << mantissa), x.dtype) - 1 + lost * inverse_binade
    else:
        within = bits & word((1 << table.shift) - 1)
        t = lax.bitcast_convert_type(within | word(bias << mantissa), x.dtype) - 1
        row, t = _part_of_doubles(table, rows, row, t)
    found = (_float_polynomial if single else _polynomial)(row, t, order) * inverse_binade**order
    return jnp.where(jnp.isfinite(load), jnp.where(inside, found, _beside(table, load, x, order)), jnp.nan)


def _excess(table: Table, load: Any) -> tuple[Any, Any]:
    """load - pull-off load, and what it loses by rounding: nothing that matters for doubles."""
    minus = table.dtype.type(-table.pull_off_load)
    total = load + minus
    if table.dtype == np.float64:
        return total, jnp.zeros_like(total)
    # A compiler must not take (load + minus) - load for minus.
    total, kept = lax.optimization_barrier((total, load))
    added = lax.optimization_barrier(total - kept)
    rest = (kept - (total - added)) + (minus - added) - table.dtype.type(table.pull_off_rest)
    x = lax.optimization_barrier(total + rest)
    return x, rest - (x - total)


def _part_of_doubles(table: Table, rows: Any, row: Any, t: Any) -> tuple[Any, Any]:
    begin = jnp.zeros_like(t)
    for _ in range(table.depth):
        offset = lax.bitcast_convert_type(row[..., 0], np.uint64) & np.uint64((1 << 51) - 1)
        link = jnp.isnan(row[..., 0]) & (offset > 0)
        before = (t[..., None] >= row[..., 2:]).sum(axis=-1)
        division = jnp.take_along_axis(row, 1 + before[..., None], axis=-1)[..., 0]
        begin = jnp.where(link & (before > 0), division, begin)
        part = (offset // np.uint64(64)).astype(np.int32) + before.astype(np.int32)
        row = jnp.where(link[..., None], rows[jnp.where(link, part, 0)], row)
    return row, t - begin


def _part_of_floats(table: Table, rows: Any, row: Any, bits: Any) -> tuple[Any, Any]:
    shift = jnp.full_like(bits, table.shift)
    for _ in range(table.depth):
        first = lax.bitcast_convert_type(row[..., 0], np.uint32) & np.uint32((1 << 22) - 1)
        link = jnp.isnan(row[..., 0]) & (first > 0)
        shift = jnp.where(link, shift - np.uint32(3), shift)
        part = first + ((bits >> shift) & np.uint32(7))
        row = jnp.where(link[..., None], rows[jnp.where(link, part, 0).astype(np.int32)], row)
    return row, bits & ((np.uint32(1) << shift) - np.uint32(1))


def _polynomial(c: Any, t: Any, order: int) -> Any:
    """A derivative by t; the operations of the library, and for slopes too."""
    t2 = t * t
    t4 = t2 * t2
    k = [c[..., i] * math.perm(i, order) for i in range(order, 8)]
    k += [jnp.zeros_like(t)] * (8 - len(k))
    return ((k[0] + k[1] * t) + (k[2] + k[3] * t) * t2) + ((k[4] + k[5] * t) + (k[6] + k[7] * t) * t2) * t4


def _float_polynomial(c: Any, t: Any, order: int) -> Any:
    k = [c[..., i] * math.perm(i, order) for i in range(order, 6)]
    value = jnp.zeros_like(t)
    for coefficient in k[:0:-1]:
        value = coefficient + value * t
    lost = c[..., 6 + order] if order < 2 else jnp.zeros_like(t)
    return k[0] + (lost + value * t) if k else value


def _beside(table: Table, load: Any, x: Any, order: int) -> Any:
    """The rules of asperity_eval.h for loads beside the rows."""
    number = table.dtype.type
    if order > 1:
        return jnp.zeros_like(x)
    heaviest = np.array((table.base + table.row_count) << table.shift, f"u{table.dtype.itemsize}").view(table.dtype)
    line = number(table.pull_off_force) + number(table.light_slope) * x if order == 0 else number(table.light_slope)
    heavy = number(table.heavy_force) if order == 0 else number(0)
    zero = number(table.zero_force if order == 0 else table.zero_slope)
    apart = number(0 if order == 0 else table.separated_slope)
    pushed = jnp.where(x >= heaviest, heavy, line)
    return jnp.where(x < 0, apart, jnp.where(load == 0, zero, pushed))
