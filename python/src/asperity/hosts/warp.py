"""The law inside Warp kernels; `asperity.warp` has the names."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from ..model import Model
from ..table import Table

try:
    import warp as wp
except ImportError as error:
    raise ImportError(f"asperity.warp needs Warp ({error}): pip install warp-lang") from None

__all__ = ["Law32", "Law64", "friction", "friction_force", "law", "load_at_gap", "load_law"]


@wp.struct
class Law64:
    """The compiled law in doubles: the attributes of `asperity.table.Table`."""

    rows: wp.array2d(dtype=wp.float64)
    row_count: wp.uint64
    base: wp.uint64
    shift: wp.uint64
    pull_off_load: wp.float64
    max_friction_coefficient: wp.float64
    inverse_cap: wp.float64
    pull_off_force: wp.float64
    light_slope: wp.float64
    zero_force: wp.float64
    zero_slope: wp.float64
    separated_slope: wp.float64
    heavy_force: wp.float64


@wp.struct
class Law32:
    """The compiled law in floats: the attributes of `asperity.table.Table`."""

    rows: wp.array2d(dtype=wp.float32)
    row_count: wp.uint32
    base: wp.uint32
    shift: wp.uint32
    pull_off_load: wp.float32
    pull_off_rest: wp.float32
    max_friction_coefficient: wp.float32
    inverse_cap: wp.float32
    pull_off_force: wp.float32
    light_slope: wp.float32
    zero_force: wp.float32
    zero_slope: wp.float32
    separated_slope: wp.float32
    heavy_force: wp.float32


def law(model: Model, dtype: npt.DTypeLike = np.float64, device: Any = None) -> Any:
    """The law of a model for kernels: a `Law64`, or a `Law32` for float32.

    Args:
        model: the law; later changes of the model do not change what is returned.
        dtype: float64 or float32.
        device: of the kernels, as Warp names it; Warp's default without.

    Raises:
        Error: another type.
    """
    return _made(model.table(dtype), device)


def load_law(model: Model, device: Any = None) -> Any:
    """Load against gap of a model for kernels: a `Law64` for `load_at_gap` alone.

    Args:
        model: the law; later changes of the model do not change what is returned.
        device: of the kernels, as Warp names it; Warp's default without.
    """
    return _made(model.load_table(), device)


def _made(table: Table, device: Any) -> Any:
    single = table.dtype == np.float32
    kind: Any = Law32 if single else Law64
    made = kind()
    for name in kind.vars:
        if name == "rows":
            made.rows = wp.array(table.rows, dtype=wp.float32 if single else wp.float64, device=device)
        else:
            setattr(made, name, getattr(table, name))
    return made


@wp.func
def _evaluated(law: Law64, load: wp.float64) -> wp.vec2d:
    """F and dF/d(load)."""
    nan = wp.float64(wp.nan)
    if not wp.isfinite(load):
        return wp.vec2d(nan, nan)
    if load < law.pull_off_load:
        return wp.vec2d(wp.float64(0.0), law.separated_slope)
    x = load - law.pull_off_load
    bits = wp.cast(x, wp.uint64)
    index = (bits >> law.shift) - law.base
    if index >= law.row_count:
        if load == wp.float64(0.0):
            return wp.vec2d(law.zero_force, law.zero_slope)
        if (bits >> law.shift) > law.base:
            return wp.vec2d(law.heavy_force, wp.float64(0.0))
        return wp.vec2d(law.pull_off_force + law.light_slope * x, law.light_slope)
    one = wp.uint64(1023) << wp.uint64(52)
    t = wp.cast((bits & ((wp.uint64(1) << law.shift) - wp.uint64(1))) | one, wp.float64) - wp.float64(1.0)
    row = wp.int32(index)
    begin = wp.float64(0.0)
    while wp.isnan(law.rows[row, 0]):
        offset = wp.cast(law.rows[row, 0], wp.uint64) & ((wp.uint64(1) << wp.uint64(51)) - wp.uint64(1))
        if offset == wp.uint64(0):
            return wp.vec2d(nan, nan)
        part = wp.int32(offset / wp.uint64(64))
        for i in range(2, 8):
            if t >= law.rows[row, i]:
                begin = law.rows[row, i]
                part += 1
        row = part
    t = t - begin
    t2 = t * t
    t4 = t2 * t2
    c0, c1, c2, c3 = law.rows[row, 0], law.rows[row, 1], law.rows[row, 2], law.rows[row, 3]
    c4, c5, c6, c7 = law.rows[row, 4], law.rows[row, 5], law.rows[row, 6], law.rows[row, 7]
    force = ((c0 + c1 * t) + (c2 + c3 * t) * t2) + ((c4 + c5 * t) + (c6 + c7 * t) * t2) * t4
    k2, k3, k4 = wp.float64(2.0) * c2, wp.float64(3.0) * c3, wp.float64(4.0) * c4
    k5, k6, k7 = wp.float64(5.0) * c5, wp.float64(6.0) * c6, wp.float64(7.0) * c7
    rate = ((c1 + k2 * t) + (k3 + k4 * t) * t2) + ((k5 + k6 * t) + k7 * t2) * t4
    exponent = (bits >> wp.uint64(52)) << wp.uint64(52)
    return wp.vec2d(force, rate * wp.cast((wp.uint64(2046) << wp.uint64(52)) - exponent, wp.float64))


@wp.func
def _excess(law: Law32, load: wp.float32) -> wp.vec2f:
    """load - pull-off load, and what it loses by rounding."""
    minus = -law.pull_off_load
    total = load + minus
    added = total - load
    rest = ((load - (total - added)) + (minus - added)) - law.pull_off_rest
    x = total + rest
    return wp.vec2f(x, rest - (x - total))


@wp.func
def _evaluated(law: Law32, load: wp.float32) -> wp.vec2f:
    if not wp.isfinite(load):
        return wp.vec2f(wp.nan, wp.nan)
    excess = _excess(law, load)
    x = excess[0]
    if x < 0.0:
        return wp.vec2f(0.0, law.separated_slope)
    bits = wp.cast(x, wp.uint32)
    index = (bits >> law.shift) - law.base
    if index >= law.row_count:
        if load == 0.0:
            return wp.vec2f(law.zero_force, law.zero_slope)
        if (bits >> law.shift) > law.base:
            return wp.vec2f(law.heavy_force, 0.0)
        return wp.vec2f(law.pull_off_force + law.light_slope * x, law.light_slope)
    row = wp.int32(index)
    shift = law.shift + wp.uint32(0)
    while wp.isnan(law.rows[row, 0]):
        first = wp.cast(law.rows[row, 0], wp.uint32) & ((wp.uint32(1) << wp.uint32(22)) - wp.uint32(1))
        if first == wp.uint32(0):
            return wp.vec2f(wp.nan, wp.nan)
        shift = shift - wp.uint32(3)
        row = wp.int32(first + ((bits >> shift) & wp.uint32(7)))
    exponent = (bits >> wp.uint32(23)) << wp.uint32(23)
    inverse_binade = wp.cast((wp.uint32(254) << wp.uint32(23)) - exponent, wp.float32)
    within = bits & ((wp.uint32(1) << shift) - wp.uint32(1))
    t = (wp.cast(within | (wp.uint32(127) << wp.uint32(23)), wp.float32) - 1.0) + excess[1] * inverse_binade
    c0, c1, c2, c3 = law.rows[row, 0], law.rows[row, 1], law.rows[row, 2], law.rows[row, 3]
    c4, c5, c6, c7 = law.rows[row, 4], law.rows[row, 5], law.rows[row, 6], law.rows[row, 7]
    force = c0 + (c6 + t * (c1 + t * (c2 + t * (c3 + t * (c4 + t * c5)))))
    rate = c1 + (c7 + t * (2.0 * c2 + t * (3.0 * c3 + t * (4.0 * c4 + t * (5.0 * c5)))))
    return wp.vec2f(force, rate * inverse_binade)


@wp.func
def friction_force(law: Law64, load: wp.float64) -> wp.float64:
    """Friction force [force] at a load [force]."""
    return _evaluated(law, load)[0]


@wp.func_grad(friction_force)
def _adjoint(law: Law64, load: wp.float64, adjoint: wp.float64) -> None:
    wp.adjoint[load] += adjoint * _evaluated(law, load)[1]


@wp.func
def load_at_gap(law: Law64, gap: wp.float64) -> wp.float64:
    """Load [force] at a gap [length], by a law of `load_law`; 0 at pull-off and beyond."""
    return _evaluated(law, -gap)[0]


@wp.func_grad(load_at_gap)
def _adjoint_of_load(law: Law64, gap: wp.float64, adjoint: wp.float64) -> None:
    wp.adjoint[gap] += -adjoint * _evaluated(law, -gap)[1]


@wp.func
def friction_force(law: Law32, load: wp.float32) -> wp.float32:
    """Friction force [force] at a load [force]."""
    return _evaluated(law, load)[0]


@wp.func_grad(friction_force)
def _adjoint32(law: Law32, load: wp.float32, adjoint: wp.float32) -> None:
    wp.adjoint[load] += adjoint * _evaluated(law, load)[1]


@wp.func
def _coefficient(law: Law64, load: wp.float64) -> wp.vec2d:
    """mu and its slope; both are 0 below pull-off, and the slope is where mu is capped."""
    found = _evaluated(law, load)
    if load < law.pull_off_load or not wp.isfinite(found[0]):
        return wp.vec2d(found[0], found[0])
    if load <= found[0] * law.inverse_cap:
        return wp.vec2d(law.max_friction_coefficient, wp.float64(0.0))
    mu = found[0] / load
    return wp.vec2d(mu, (found[1] - mu) / load)


@wp.func
def _coefficient(law: Law32, load: wp.float32) -> wp.vec2f:
    found = _evaluated(law, load)
    if _excess(law, load)[0] < 0.0 or not wp.isfinite(found[0]):
        return wp.vec2f(found[0], found[0])
    if load <= found[0] * law.inverse_cap:
        return wp.vec2f(law.max_friction_coefficient, 0.0)
    mu = found[0] / load
    return wp.vec2f(mu, (found[1] - mu) / load)


@wp.func
def friction(law: Law64, load: wp.float64) -> wp.float64:
    """Friction coefficient at a load [force], capped as that of the model."""
    return _coefficient(law, load)[0]


@wp.func_grad(friction)
def _adjoint_of_friction(law: Law64, load: wp.float64, adjoint: wp.float64) -> None:
    wp.adjoint[load] += adjoint * _coefficient(law, load)[1]


@wp.func
def friction(law: Law32, load: wp.float32) -> wp.float32:
    """Friction coefficient at a load [force], capped as that of the model."""
    return _coefficient(law, load)[0]


@wp.func_grad(friction)
def _adjoint_of_friction32(law: Law32, load: wp.float32, adjoint: wp.float32) -> None:
    wp.adjoint[load] += adjoint * _coefficient(law, load)[1]
