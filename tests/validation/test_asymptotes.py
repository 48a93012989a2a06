"""Limits that have a closed form: what the sums over summits must become where one term outgrows all others."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import minimize_scalar
from scipy.stats import norm

from asperity import Model, Params

# E* = G* = R = 1 unless a test says otherwise.
SURFACE: dict[str, Any] = dict(
    composite_modulus=1.0, effective_shear_modulus=1.0, adhesion_range=1e-3, burgers_vector=1e-3, height_std=0.01,
    summit_radius=1.0, asperity_count=1e6, max_friction_coefficient=math.inf,
)  # fmt: skip
# Of the slip stress between two radii a factor of 1000 apart: 1/43 and 1/1290.
EXPONENT = -math.log(1290 / 43) / math.log(1e3)


@pytest.mark.parametrize(
    "slip_radii, expected", [((1e3, 1e6), -1 / 3), ((10, 1e4), (2 + EXPONENT) / 3 - 1), ((1, 10), -1 / 3)],
    ids=["below a_1", "between", "above a_2"],
)  # fmt: skip
def test_friction_of_equal_summits_falls_with_a_power_of_the_load(
    slip_radii: tuple[float, float], expected: float
) -> None:
    """F is tau a^2, P is a^3, and tau is constant or a power of a. Contacts of 50 to 400 b, summits of one height."""
    surface = SURFACE | dict(height_std=1e-7, summit_radius=100.0, work_of_adhesion=0.0)
    surface |= dict(zip(("slip_radius_1", "slip_radius_2"), slip_radii))
    model = Model(Params.si(**surface))
    for radius in (0.05, 0.1, 0.2, 0.4):
        state = model.state_at_load(1e6 * 4 / 3 * radius**3 / 100)
        assert state.mean_contact_radius == pytest.approx(radius, rel=1e-4)
        slope = state.dmu_dload * state.load / state.friction_coefficient
        assert slope == pytest.approx(expected, rel=1e-4)


def test_area_over_load_of_gaussian_heights_far_apart() -> None:
    """A/P goes to (pi R t/sigma)^(1/2)/E*, t = d/sigma: the tail is an exponential of decay sigma/t. The next term is
    (15/4 + 5/8 - 3)/t^2: the integrals of x e^(-tx - x^2/2) and x^(3/2) e^(-tx - x^2/2) to second order in 1/t."""
    model = Model(Params.si(**SURFACE, work_of_adhesion=0.0))
    for t in (10.0, 20.0, 34.0):
        state = model.state_at_gap(t * 0.01)
        ratio = state.real_area / state.load / math.sqrt(math.pi * t / 0.01)
        assert ratio == pytest.approx(1 + 1.375 / t**2, abs=20 / t**4)


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
@pytest.mark.parametrize("bandwidth", [1.6, 3.0, 10.0, 100.0])
def test_area_of_mccools_summits_leaves_that_of_bush_gibson_and_thomas(bandwidth: float) -> None:
    """Their A/P goes to (pi/m2)^(1/2)/E* (Wear 35 (1975), 87), that of spheres of one radius grows beyond it: by
    (0.665 t)^(1/2)/(bandwidth - 0.897)^(1/4), with the same next term in t = d/sigma as above."""
    m0, m2 = 1e-4, 0.01
    contact = {name: SURFACE[name] for name in ("composite_modulus", "effective_shear_modulus", "burgers_vector")}
    params = Params.from_spectral_moments(
        m0=m0, m2=m2, m4=bandwidth * m2**2 / m0, nominal_area=1e6, summits="mccool", work_of_adhesion=0.0,
        adhesion_range=1e-3, **contact,
    )  # fmt: skip
    t = 30.0
    state = Model(params).state_at_gap(params.summit_mean_height + t * params.height_std)
    ratio = state.real_area / state.load / math.sqrt(math.pi / m2)
    assert ratio == pytest.approx(math.sqrt(0.6647 * t) / (bandwidth - 0.8968) ** 0.25 * (1 + 1.375 / t**2), rel=1e-4)


@pytest.mark.parametrize("roughness", [0.1, 0.3, 0.5])
def test_pull_off_of_rough_surfaces_is_that_of_dmt(roughness: float) -> None:
    """As lambda goes to 0 a summit in contact is Hertz's, less 2 pi w R; one out of contact pulls 2 pi w R (1 - gap/h).
    Here sigma/h is `roughness`; the pull-off load is from two thirds of that of equal summits to a ten thousandth."""
    h, radius, work = 1.0, 100.0, 2e-6
    sigma = roughness * h
    options = SURFACE | dict(height_std=sigma, summit_radius=radius, adhesion_range=h, burgers_vector=h)
    options["asperity_count"] = 1.0
    summary = Model(Params.si(**options, work_of_adhesion=work)).summary()
    assert summary.lambda_ < 1e-3

    def load(separation: float) -> float:
        def summit(z: float) -> float:
            overlap = z - separation
            hertz = 4 / 3 * math.sqrt(radius) * max(overlap, 0.0) ** 1.5
            return float((hertz - 2 * math.pi * work * radius * min(1.0, 1 + overlap / h)) * norm.pdf(z, scale=sigma))

        kinks = [separation - h, separation, separation + sigma / 2, separation + 2 * sigma, separation + 10 * sigma]
        return sum(quad(summit, low, high, epsabs=0, epsrel=1e-10, limit=200)[0] for low, high in zip(kinks, kinks[1:]))

    coarse = sigma * np.linspace(1, 8, 36)
    least = int(np.argmin([load(float(separation)) for separation in coarse]))
    bounds = (float(coarse[least - 1]), float(coarse[least + 1]))
    best = minimize_scalar(load, bounds=bounds, method="bounded", options=dict(xatol=1e-9))
    assert summary.pull_off_load == pytest.approx(best.fun, rel=1e-3)


@pytest.mark.parametrize("work, radius, expected", [(1e-6, 1e2, -2.0), (1.0, 1e4, -1.5)], ids=["DMT", "JKR"])
def test_equal_summits_let_go_as_one(work: float, radius: float, expected: float) -> None:
    """sigma going to 0: -2 pi w R where lambda is small (here 0.0005), -3/2 pi w R where it is large (here 23)."""
    options = SURFACE | dict(height_std=1e-5, summit_radius=radius, adhesion_range=1.0, burgers_vector=0.1)
    summary = Model(Params.si(**options, work_of_adhesion=work)).summary()
    assert summary.pull_off_load / (1e6 * math.pi * work * radius) == pytest.approx(expected, rel=2e-3)
