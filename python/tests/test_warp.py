"""`asperity.warp` against the library: values and gradients on a tape, on the processor."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import warp as wp
from arrays_common import SURFACES, Array, digits_lost, exact, loads_of

import asperity.warp
from asperity import Model

wp.config.quiet = True


@wp.kernel
def force_64(law: asperity.warp.Law64, load: wp.array(dtype=wp.float64), out: wp.array(dtype=wp.float64)) -> None:
    i = wp.tid()
    out[i] = asperity.warp.friction_force(law, load[i])


@wp.kernel
def force_32(law: asperity.warp.Law32, load: wp.array(dtype=wp.float32), out: wp.array(dtype=wp.float32)) -> None:
    i = wp.tid()
    out[i] = asperity.warp.friction_force(law, load[i])


@wp.kernel
def coefficient_64(law: asperity.warp.Law64, load: wp.array(dtype=wp.float64), out: wp.array(dtype=wp.float64)) -> None:
    i = wp.tid()
    out[i] = asperity.warp.friction(law, load[i])


@wp.kernel
def coefficient_32(law: asperity.warp.Law32, load: wp.array(dtype=wp.float32), out: wp.array(dtype=wp.float32)) -> None:
    i = wp.tid()
    out[i] = asperity.warp.friction(law, load[i])


KERNELS = {
    ("friction_force", np.float64): force_64,
    ("friction_force", np.float32): force_32,
    ("friction", np.float64): coefficient_64,
    ("friction", np.float32): coefficient_32,
}


def evaluated(model: Model, quantity: str, loads: Array) -> tuple[Array, Array]:
    """Values, and gradients of their sum on a tape."""
    dtype = loads.dtype.type
    kind: Any = wp.float64 if dtype == np.float64 else wp.float32
    law = asperity.warp.law(model, dtype, device="cpu")
    load = wp.array(loads, dtype=kind, requires_grad=True, device="cpu")
    out = wp.zeros(loads.size, dtype=kind, requires_grad=True, device="cpu")
    tape = wp.Tape()
    with tape:
        wp.launch(KERNELS[quantity, dtype], dim=loads.size, inputs=[law, load], outputs=[out], device="cpu")
    tape.backward(grads={out: wp.array(np.ones(loads.size, dtype), dtype=kind, device="cpu")})
    return out.numpy(), load.grad.numpy()


@pytest.mark.parametrize("surface", SURFACES)
@pytest.mark.parametrize(("dtype", "value_error", "slope_error"), [(np.float64, 1e-15, 2e-15), (np.float32, 2e-7, 2e-7)])
@pytest.mark.parametrize("quantity", ["friction_force", "friction"])
def test_values_and_gradients_are_the_librarys(
    surface: str, quantity: str, dtype: Any, value_error: float, slope_error: float
) -> None:
    model = Model(SURFACES[surface])
    loads = loads_of(model, dtype)
    value, slope = evaluated(model, quantity, loads)
    exact_value, exact_slope = exact(model, quantity, loads.astype(np.float64))
    np.testing.assert_allclose(value, exact_value, rtol=value_error)
    allowed = slope_error * digits_lost(model, quantity, loads.astype(np.float64)) * np.abs(exact_slope)
    # Kinks, where the slope of floats is rounded off, are met by some loads in ten thousand.
    assert np.mean(np.abs(slope - exact_slope) > allowed) <= (0 if dtype == np.float64 else 5e-4)
    # The others are capped: all loads of the table of a sticky surface.
    assert np.count_nonzero(slope) > 0.005 * slope.size or (surface, quantity) == ("sticky", "friction")


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_loads_beside_the_table_have_the_rules_of_the_header(dtype: Any) -> None:
    model = Model(SURFACES["adhesive"])
    table = model.table(dtype)
    loads = np.array([2 * table.pull_off_load, 0.0, 1e37, np.nan, np.inf], dtype)
    force, slope = evaluated(model, "friction_force", loads)
    mu, mu_slope = evaluated(model, "friction", loads)
    assert force[:3].tolist() == [0, table.zero_force, table.heavy_force]
    assert slope[:3].tolist() == [table.separated_slope, table.zero_slope, 0]
    assert mu[:2].tolist() == [0, table.max_friction_coefficient] and mu_slope[:2].tolist() == [0, 0]
    assert np.isnan(force[3:]).all() and np.isnan(mu[3:]).all()
