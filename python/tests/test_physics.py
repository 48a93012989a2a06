"""Numbers from elsewhere: an independent integration of the model, closed forms of mechanics, change of units."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest

from asperity import Error, Model, Params, Status

from conftest import ROOT

CASES = json.loads((ROOT / "tests" / "reference" / "cases.json").read_text(encoding="utf-8"))


def reference_params(case: dict[str, Any]) -> Params:
    """In the units of the file: E* = G* = b = N = 1."""
    given = case["params"]
    shape = {} if given["weibull_shape"] is None else {"weibull_shape": given["weibull_shape"]}
    return Params.si(
        composite_modulus=1, effective_shear_modulus=1, burgers_vector=1, asperity_count=1,
        adhesion_range=1 / given["b_over_h"], work_of_adhesion=given["gamma"],
        height_std=given["alpha"] * given["beta"], summit_radius=given["beta"] / given["alpha"],
        attraction=given["noncontacting"], radius_amplitude=given["epsilon"], radius_rate=given["rho"],
        slip_radius_1=given["a1"], slip_stress_1=given["tau1"],
        slip_radius_2=given["a2"], slip_stress_2=given["tau2"], **shape,
    )  # fmt: skip


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_an_independent_integration_gives_the_same_numbers(case: dict[str, Any]) -> None:
    params = reference_params(case)
    sigma = params.height_std
    with Model(params) as model:
        pull_off = model.summary().pull_off_load
        for row in case["rows"]:
            state = model.state_at_gap(row["separation"] * sigma)
            assert state.load == pytest.approx(row["load"], rel=2e-10)
            assert state.friction_force == pytest.approx(row["friction"], rel=1e-11)
            assert state.contacting == pytest.approx(row["contacting"], rel=1e-11)
            assert state.real_area == pytest.approx(row["area"], rel=1e-11)
            assert state.attraction_load == pytest.approx(row["load_attracted"], abs=2e-10 * abs(row["load"]))
            # The slopes of the file are differences, good to about seven digits.
            assert state.dload_dgap * sigma == pytest.approx(row["dload_dseparation"], rel=1e-6)
            assert state.dforce_dload == pytest.approx(row["dfriction_dload"], rel=1e-6)
            if row["load"] > pull_off and row["dload_dseparation"] < 0:
                force, slope = model.friction_force_at_load(row["load"], slope=True)
                assert force == pytest.approx(row["friction"], rel=1e-8)
                assert slope == pytest.approx(row["dfriction_dload"], rel=1e-6)
                if row["load"] > 0:
                    expected = row["friction"] / row["load"]
                    assert model.friction_at_load(row["load"]) == pytest.approx(expected, rel=1e-8)


# Integrals of (z - h)^(3/2) over the Gaussian density for z > h, at h = 0, 1, 2, 3 (Greenwood and Williamson 1966).
GREENWOOD_WILLIAMSON = [0.43001999, 0.075668177, 0.0066481776, 0.00026396755]


@pytest.mark.parametrize("height, integral", list(enumerate(GREENWOOD_WILLIAMSON)))
def test_without_adhesion_it_is_greenwood_and_williamson(height: int, integral: float) -> None:
    modulus, sigma, radius, count = 3.0, 2.0, 5e4, 7.0
    params = Params.si(
        composite_modulus=modulus, effective_shear_modulus=2, work_of_adhesion=0, adhesion_range=1, burgers_vector=1,
        height_std=sigma, summit_radius=radius, asperity_count=count,
    )  # fmt: skip
    density, above = math.exp(-(height**2) / 2) / math.sqrt(2 * math.pi), math.erfc(height / math.sqrt(2)) / 2
    with Model(params) as model:
        state = model.state_at_gap(height * sigma)
    assert state.load == pytest.approx(count * 4 / 3 * modulus * radius**0.5 * sigma**1.5 * integral, rel=3e-8)
    assert state.real_area == pytest.approx(count * math.pi * radius * sigma * (density - height * above), rel=1e-10)
    assert state.contacting == pytest.approx(count * above, rel=1e-11)
    assert state.attraction_load == 0 == state.attracted


def test_constant_shear_strength_makes_friction_stress_times_area() -> None:
    # Equal slip stresses leave no scale: F = tau A.
    params = Params.dimensionless(
        alpha=0.01, beta=1000, gamma=0.001, slip_radius_1=1.0, slip_stress_1=0.01, slip_radius_2=2.0, slip_stress_2=0.01
    )
    with Model(params) as model:
        for load in (1e-2, 1.0, 1e3):
            state = model.state_at_load(load)
            stress = 0.01 * params.effective_shear_modulus
            assert state.friction_force == pytest.approx(stress * state.real_area, rel=1e-11)
            assert model.friction_force_at_load(load) == pytest.approx(state.friction_force, rel=1e-8)


def test_without_adhesion_the_surfaces_part_at_zero_load(params: Params) -> None:
    with Model(params.replace(work_of_adhesion=0)) as model:
        assert model.summary().pull_off_load == 0 == model.friction_force_at_load(0.0)
        assert model.friction_force_at_load(-1e-9) == 0 == model.friction_at_load(-1e-9)
        with pytest.raises(Error, match="must be > 0") as caught:
            model.state_at_load(0.0)
        assert caught.value.status is Status.OUT_OF_RANGE


def test_units_do_not_matter() -> None:
    common: dict[str, Any] = dict(nu1=0.22, nu2=0.3, skew=-0.5)
    metres = Params.si(
        E1=160e9, E2=200e9, work_of_adhesion=0.063, adhesion_range=4e-10, burgers_vector=3.84e-10, height_std=5e-9,
        summit_radius=1e-6, summit_density=1e13, nominal_area=1e-8, **common,
    )  # fmt: skip
    millimetres = Params.si(
        E1=160e3, E2=200e3, work_of_adhesion=0.063e-3, adhesion_range=4e-7, burgers_vector=3.84e-7, height_std=5e-6,
        summit_radius=1e-3, summit_density=1e7, nominal_area=1e-2, **common,
    )  # fmt: skip
    loads = np.geomspace(1e-8, 1, 30)  # [N] in both
    with Model(metres) as one, Model(millimetres) as other:
        assert other.friction_at_load(loads) == pytest.approx(one.friction_at_load(loads), rel=1e-11)
        area, same_area = one.state_at_load(1e-3).real_area, other.state_at_load(1e-3).real_area
        assert same_area == pytest.approx(1e6 * area, rel=1e-9)


def test_the_papers_claims_hold(params: Params) -> None:
    loads = np.geomspace(0.1, 1e3, 9)

    def friction(**changes: Any) -> Any:
        with Model(params.replace(**changes)) as model:
            return model.friction_at_load(loads)

    plain = friction()
    assert (np.diff(plain) < 0).all()  # friction falls with load
    assert (plain > friction(attraction=False)).all()  # attraction without contact raises it
    assert (friction(skew=1) < friction(skew=0)).all() and (friction(skew=0) < friction(skew=-1)).all()
    assert (friction(radius_amplitude=-0.95) < plain).all() and (plain < friction(radius_amplitude=1)).all()
