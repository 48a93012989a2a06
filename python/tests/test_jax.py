"""`asperity.jax` against the library: values, slopes and their derivatives, on the processor."""

from __future__ import annotations

from typing import Any

import jax
import numpy as np
import pytest
from arrays_common import SURFACES, Array, digits_lost, exact, loads_of

import asperity.jax
from asperity import Model

jax.config.update("jax_enable_x64", True)


CASES = [("friction_force", surface) for surface in SURFACES] + [("friction", "adhesive"), ("friction", "silicon")]


def evaluated(model: Model, quantity: str, dtype: Any) -> tuple[Array, Array, Array, Array, Array]:
    """Value and slope, those of the library, and how many digits of the slope are lost."""
    loads = loads_of(model, dtype)
    law = getattr(asperity.jax, quantity)(model, dtype=dtype)
    value, slope = jax.jit(jax.vmap(jax.value_and_grad(law)))(loads)
    assert value.dtype == slope.dtype == dtype
    loads = loads.astype(np.float64)
    lost = digits_lost(model, quantity, loads)
    return (np.asarray(value), np.asarray(slope), *exact(model, quantity, loads), lost)


@pytest.mark.parametrize(("quantity", "surface"), CASES)
def test_values_and_slopes_in_doubles_are_the_librarys(quantity: str, surface: str) -> None:
    value, slope, exact_value, exact_slope, lost = evaluated(Model(SURFACES[surface]), quantity, np.float64)
    np.testing.assert_allclose(value, exact_value, rtol=1e-15)
    assert np.all(np.abs(slope - exact_slope) <= 2e-15 * lost * np.abs(exact_slope))


@pytest.mark.parametrize(("quantity", "surface"), CASES)
def test_values_and_slopes_in_floats_are_near_the_librarys(quantity: str, surface: str) -> None:
    value, slope, exact_value, exact_slope, lost = evaluated(Model(SURFACES[surface]), quantity, np.float32)
    np.testing.assert_allclose(value, exact_value, rtol=2e-7)
    # Kinks, where the slope of floats is rounded off, are met by some loads in ten thousand.
    assert np.mean(np.abs(slope - exact_slope) > 2e-7 * lost * np.abs(exact_slope)) < 5e-4


@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_loads_beside_the_table_have_the_rules_of_the_header(dtype: str) -> None:
    model = Model(SURFACES["adhesive"])
    table = model.table(dtype)
    loads = np.array([2 * table.pull_off_load, 0.0, 1e37, np.nan, np.inf], dtype)
    laws = (getattr(asperity.jax, name)(model, dtype=dtype) for name in ("friction_force", "friction"))
    (force, slope), (mu, mu_slope) = (map(np.asarray, jax.jit(jax.vmap(jax.value_and_grad(law)))(loads)) for law in laws)
    assert force[:3].tolist() == [0, table.zero_force, table.heavy_force]
    assert slope[:3].tolist() == [table.separated_slope, table.zero_slope, 0]
    assert mu[:2].tolist() == [0, table.max_friction_coefficient] and mu_slope[:2].tolist() == [0, 0]
    assert np.isnan(force[3:]).all() and np.isnan(mu[3:]).all()


def test_higher_derivatives_are_those_of_the_law_and_not_0() -> None:
    model = Model(SURFACES["adhesive"])
    law: Any = asperity.jax.friction_force(model)
    loads = np.geomspace(1.0, 1e4, 50)
    step = 1e-4 * loads
    _, slopes = exact(model, "friction_force", np.stack([loads + step, loads - step]))
    second = jax.jit(jax.vmap(jax.grad(jax.grad(law))))(loads)
    np.testing.assert_allclose(second, (slopes[0] - slopes[1]) / (2 * step), rtol=1e-4)
    mu: Any = asperity.jax.friction(model)
    _, slopes = exact(model, "friction", np.stack([loads + step, loads - step]))
    np.testing.assert_allclose(jax.jit(jax.vmap(jax.hessian(mu)))(loads), (slopes[0] - slopes[1]) / (2 * step), rtol=1e-4)


def test_doubles_without_x64_are_refused() -> None:
    model = Model(SURFACES["adhesive"])
    try:
        jax.config.update("jax_enable_x64", False)
        with pytest.raises(ValueError, match="jax_enable_x64"):
            asperity.jax.friction(model)
        assert jax.jit(asperity.jax.friction(model, dtype="float32"))(5.0).dtype == np.float32
    finally:
        jax.config.update("jax_enable_x64", True)
