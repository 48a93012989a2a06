"""Surfaces and loads for the tests of `asperity.table`, `asperity.jax` and `asperity.warp`."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from asperity import Model, Params

Array = npt.NDArray[Any]

_LENGTHS: dict[str, Any] = dict(adhesion_range=0.384e-9, burgers_vector=0.384e-9, height_std=5e-9, summit_radius=1e-6)
SURFACES = {
    "adhesive": Params.paper(),
    "sticky": Params.dimensionless(alpha=0.003, beta=3000, gamma=0.01),
    "without adhesion": Params.dimensionless(alpha=0.01, beta=1000, gamma=0),
    "silicon": Params.si(
        E1=160e9, nu1=0.22, E2=160e9, nu2=0.22, work_of_adhesion=0.063, asperity_count=1e5, **_LENGTHS
    ),
    "yielding": Params.si(
        E1=160e9, nu1=0.22, E2=160e9, nu2=0.22, work_of_adhesion=0, asperity_count=1e5, hardness=12e9,
        contact_law="elastic-plastic", **_LENGTHS,
    ),
}  # fmt: skip


def loads_of(model: Model, dtype: npt.DTypeLike) -> Array:
    """Loads within the table, pulling too, that are numbers of a type: 10,000 over the decades that solvers meet."""
    summary = model.summary()
    rng = np.random.default_rng(1)
    heavy = summary.max_table_load * 1e-8
    light = max(summary.min_table_load, heavy * 1e-24, 1e-20)
    loads = light * (heavy / light) ** rng.random(9000)
    if summary.pull_off_load < -1e-12 * heavy:
        loads = np.concatenate([loads, summary.pull_off_load * (1 - rng.random(1000) ** 2 * 0.999)])
        loads = loads[loads - summary.pull_off_load > 2e-6 * -summary.pull_off_load]
    return np.asarray(loads.astype(dtype))


def exact(model: Model, quantity: str, loads: Array) -> tuple[Array, Array]:
    """Value and slope by the library."""
    found: tuple[Array, Array] = getattr(model, quantity + "_at_load")(loads, slope=True)
    return found


def digits_lost(model: Model, quantity: str, loads: Array) -> Array:
    """By how much an error of the slope is greater than those of what it is made from: that of the coefficient is a
    difference, small where friction is nearly in proportion to load."""
    if quantity == "friction_force":
        return np.ones(loads.shape)
    force, slope = exact(model, "friction_force", loads)
    return (np.abs(force / loads) + slope) / np.abs(force / loads - slope)
