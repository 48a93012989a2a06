"""Load against gap in Python, JAX and Warp: the exact state's, with its slope."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
import warp as wp

import asperity
import asperity.warp

wp.config.quiet = True

MODELS = {
    name: asperity.Params.dimensionless(alpha=0.01, beta=1000, gamma=gamma)
    for name, gamma in (("default", 0.001), ("no adhesion", 0.0))
}


@wp.kernel
def loads(law: asperity.warp.Law64, at: wp.array(dtype=wp.float64), load: wp.array(dtype=wp.float64)) -> None:
    i = wp.tid()
    load[i] = asperity.warp.load_at_gap(law, at[i])


@pytest.fixture(params=MODELS)
def model(request: pytest.FixtureRequest) -> asperity.Model:
    return asperity.Model(MODELS[request.param])


def gaps(model: asperity.Model) -> npt.NDArray[Any]:
    """From heavy load to one that is 1e-12 of it, or to pull-off."""
    pull_off = model.summary().pull_off_load
    nearest = model.state_at_load(1e3).gap
    farthest = model.state_at_load(pull_off if pull_off < 0 else 1e-9).gap
    return np.linspace(nearest, farthest, 40)[:-1]


def test_load_and_slope_are_those_of_the_exact_state(model: asperity.Model) -> None:
    at = gaps(model)
    load, slope = model.load_at_gap(at, slope=True)
    exact = model.state_at_gap(at)
    size = np.maximum(np.abs(exact.load), -model.summary().pull_off_load)
    assert np.max(np.abs(load - exact.load) / size) < 1e-6
    assert np.max(np.abs(slope / exact.dload_dgap - 1)) < 1e-6
    one, one_slope = model.load_at_gap(float(at[7]), slope=True)
    assert (one, one_slope) == (load[7], slope[7]) and model.load_at_gap(float(at[7])) == one
    np.testing.assert_array_equal(model.load_at_gap(at.reshape(3, 13)), load.reshape(3, 13))


def test_surfaces_apart_carry_nothing(model: asperity.Model) -> None:
    far = 1e3 * model.params.height_std
    assert model.load_at_gap(far, slope=True) == (0.0, 0.0)
    assert list(model.load_at_gap([far, -10.0])) == [0.0, model.load_at_gap(-10.0)]


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -1e300])
def test_a_gap_without_an_answer_is_named(model: asperity.Model, wrong: float) -> None:
    for given, says in ((wrong, "gap = "), ([1.0, wrong], "element 1: gap = "), ([1e9, wrong], "element 1")):
        with pytest.raises(asperity.Error, match=says):
            model.load_at_gap(given)


def test_in_jax_with_derivatives(model: asperity.Model) -> None:
    import asperity.jax
    import jax

    jax.config.update("jax_enable_x64", True)
    at = gaps(model)
    load = asperity.jax.load_at_gap(model)
    expected, slope = model.load_at_gap(at, slope=True)
    size = np.maximum(np.abs(expected), -model.summary().pull_off_load)
    assert np.max(np.abs(np.asarray(jax.jit(load)(at)) - expected) / size) < 1e-14
    np.testing.assert_allclose(np.asarray(jax.vmap(jax.grad(load))(at)), slope, rtol=1e-13)
    curvature = jax.grad(jax.grad(load))(at[20])
    step = 1e-4 * model.params.height_std
    ends = [model.load_at_gap(float(at[20] + s), slope=True)[1] for s in (step, -step)]
    assert curvature == pytest.approx((ends[0] - ends[1]) / (2 * step), rel=1e-6)
    assert float(load(1e9)) == 0.0 and np.isnan(float(load(np.nan)))


def test_in_warp_with_a_gradient(model: asperity.Model) -> None:
    law = asperity.warp.load_law(model, device="cpu")
    places = np.append(gaps(model), 1e9)
    at = wp.array(places, dtype=wp.float64, device="cpu", requires_grad=True)
    load = wp.zeros(len(places), dtype=wp.float64, device="cpu", requires_grad=True)
    with wp.Tape() as tape:
        wp.launch(loads, dim=len(places), inputs=[law, at], outputs=[load], device="cpu")
    tape.backward(grads={load: wp.array(np.ones(len(places)), dtype=wp.float64, device="cpu")})
    expected, slope = model.load_at_gap(places, slope=True)
    size = np.maximum(np.abs(expected), max(-model.summary().pull_off_load, 1e-300))
    assert np.max(np.abs(load.numpy() - expected) / size) < 1e-14
    np.testing.assert_allclose(at.grad.numpy(), slope, rtol=1e-13, atol=0)


def test_the_sum_of_contact_radii_is_that_of_the_exact_state(model: asperity.Model) -> None:
    load = np.geomspace(1e-2, 1e3, 7)
    radii = model.tangential_stiffness_at_load(load) / model.summary().stiffness_per_radius
    assert radii == pytest.approx(model.state_at_load(load).contact_radius_sum, rel=1e-6)
