"""Bands: their slopes against sums over the summits, samples and Bayes' rule."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from asperity import Error, Model, Params, fit, uncertainty
from asperity.fits import differences

LOADS = np.geomspace(0.1, 1e4, 9)
PAPER = Params.paper()

# What a spread of 0.1 of each name causes at the loads 1, 30 and 1000, by derivatives of the sums over the summits that the library
# once had: analytic, and right to 1e-7.
ANALYTIC = {
    PAPER: {
        "composite_modulus": (0.159541, 0.136521, 0.113537), "effective_shear_modulus": (0.1, 0.1, 0.1),
        "work_of_adhesion": (0.0687897, 0.0470014, 0.02778), "burgers_vector": (0.0427411, 0.0427413, 0.0427415),
        "height_std": (0.155907, 0.118219, 0.0835814), "summit_radius": (0.0676488, 0.05737, 0.0496408),
        "slip_radius_1": (0.0263484, 0.0257919, 0.0248691), "slip_stress_2": (0.0383531, 0.0396554, 0.0418148),
        "radius_amplitude": (0.0637804, 0.0502794, 0.034309), "radius_rate": (0.0, 0.0, 0.0),
        "pressure_coefficient": (0.0656829, 0.0757984, 0.0957555),  # from 0, to one side
    },
    PAPER.replace(skew=-0.5, radius_amplitude=0.3): {"skew": (0.294484, 0.10865, 0.0400834), "radius_rate": (0.0162091, 0.00948773, 0.00668783)},
    PAPER.replace(skew=-0.5): {"omega": (0.138676, 0.0544173, 0.0213435), "gamma": (0.2076775, 0.0856045, 0.0350928)},
    PAPER.replace(skew=0.3, kurtosis=4.0): {"kurtosis": (0.226824, 0.163379, 0.0690531), "alpha": (0.133063, 0.137474, 0.134392)},
    PAPER.replace(slip_radius_1=1.0): {"slip_radius_1": (0.0130366, 0.0127617, 0.0123073)},  # the least that is allowed
}  # fmt: skip


@pytest.mark.parametrize("params", ANALYTIC, ids=[" ".join(names) for names in ANALYTIC.values()])
@pytest.mark.parametrize("step", [1e-3, 5e-4])
def test_slopes_are_those_of_the_sums_over_the_summits(params: Params, step: float, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(differences, "STEP", step)
    expected = ANALYTIC[params]
    parts = uncertainty(params, dict.fromkeys(expected, 0.1), [1.0, 30.0, 1000.0]).parts
    for name, one in expected.items():
        assert parts[name] == pytest.approx(one, rel=3e-5, abs=1e-9), name


def test_a_fit_has_the_errors_of_the_sums_over_the_summits() -> None:
    load = np.geomspace(0.5, 500, 14)
    with Model(PAPER.replace(work_of_adhesion=1.3 * PAPER.work_of_adhesion, height_std=0.8 * PAPER.height_std)) as model:
        mu = model.friction_at_load(load) * (1 + 0.01 * np.random.default_rng(1).standard_normal(14))
    found = fit(load, mu, 0.01 * mu, ["gamma", "sigma"], params=PAPER)
    assert list(found.values.values()) == pytest.approx([0.00133262, 8.09267], rel=1e-5)
    assert list(found.errors.values()) == pytest.approx([0.000112542, 0.339642], rel=1e-4)
    # Nothing of four names is fixed where only their combinations change friction.
    lost = ("E*", "w", "slip_stress", "N")
    assert fit(load, mu, 0.01 * mu, lost, params=PAPER).unidentifiable == lost


# ---- Bands ----


@pytest.fixture(scope="module")
def given() -> Params:
    """The paper's case with a strength that is given: bands have no part of it."""
    return Params.paper().replace(slip_stress_1=0.02)


def test_a_narrow_band_is_the_same_by_slopes_and_by_samples(given: Params) -> None:
    spread = {"sigma": 0.01, "w": 0.02, "epsilon": 0.01}
    linear = uncertainty(given, spread, LOADS)
    drawn = uncertainty(given, spread, LOADS, samples=200, seed=1)
    assert drawn.samples is not None and drawn.samples.shape == (200, LOADS.size) and drawn.refused == 0
    # The standard error of a standard deviation of 200 is 5 %.
    assert drawn.deviation == pytest.approx(linear.deviation, rel=0.15)
    with Model(given) as model:
        assert linear.value.tolist() == model.friction_at_load(LOADS).tolist()
    assert ((linear.low < linear.value) & (linear.value < linear.high)).all()
    width = np.log(linear.high / linear.low)
    assert width == pytest.approx(2 * 1.959964 * linear.deviation, rel=1e-6)
    assert np.log(drawn.high / drawn.low) == pytest.approx(width, rel=0.25)
    squares = sum(part**2 for part in linear.parts.values())
    assert np.sqrt(squares) == pytest.approx(linear.deviation, rel=1e-12)


def test_forces_have_a_band_where_coefficients_have_none(sticky: Params) -> None:
    with Model(sticky) as model:
        loads = [0.5 * model.summary().pull_off_load, 0.0, 1.0]
    found = uncertainty(sticky, {"gamma": 0.05}, loads, quantity="force", coverage=0.68)
    assert (found.low > 0).all() and found.deviation[0] > found.deviation[1] > found.deviation[2]
    with pytest.raises(ValueError, match="must be > 0 for coefficients"):
        uncertainty(sticky, {"gamma": 0.05}, loads)
    with pytest.raises(Error, match="below the pull-off load"):
        uncertainty(sticky, {"gamma": 0.05}, [2.1 * loads[0]], quantity="force")


# ---- The strength of the interface ----


@pytest.fixture(scope="module")
def rough(params: Params) -> Params:
    """As many summits as make a surface, whose strength nobody measured."""
    return params.replace(asperity_count=1e5)


def test_a_strength_that_nobody_measured_is_known_to_a_factor_of_10(rough: Params) -> None:
    loads = 1e5 * LOADS[2:5]
    band = uncertainty(rough, loads=loads)
    assert band.high == pytest.approx(10 * band.value, rel=1e-9) and band.low == pytest.approx(band.value / 10, rel=1e-9)
    assert list(band.parts) == ["slip_stress"] and band.deviation == pytest.approx(math.log(10) / 1.959964, rel=1e-6)
    assert band.rests_on == ("strength of the interface: not measured, a factor 10 either way", "all else: taken as known")
    assert uncertainty(rough, {}, loads).high.tolist() == band.high.tolist()
    with_others = uncertainty(rough, {"sigma": 0.1}, loads)
    assert (with_others.deviation > band.deviation).all() and with_others.rests_on[1] == "sigma: 10 %"
    drawn = uncertainty(rough, loads=loads, samples=400, seed=3)
    assert drawn.deviation.shape == loads.shape and drawn.samples is not None
    assert np.std(np.log(drawn.samples), axis=0) == pytest.approx(band.deviation, rel=0.15)


def test_a_strength_that_is_named_or_given_has_no_band_of_its_own(rough: Params) -> None:
    loads = [1e6]
    for name in ("slip_stress", "slip_stress_1", "slip_stress_2"):
        known = uncertainty(rough, {"sigma": 0.1, name: 0.0}, loads)
        assert known.deviation[0] < 0.2 and known.rests_on[0] == "strength of the interface: as given"
    for given in (rough.replace(slip_stress_1=0.02), rough.replace(pressure_coefficient=0.1)):
        assert uncertainty(given, {"sigma": 0.1}, loads).deviation[0] < 0.2
        with pytest.raises(ValueError, match="the strength of this interface is given; if it was measured, calibrate with"):
            uncertainty(given, loads=loads)


def test_one_measured_point_narrows_as_weights_of_monte_carlo_do(rough: Params) -> None:
    """Against surfaces drawn from what was known before, each with the probability that it gives to the measurement."""
    load, mu, error = 1e6, 0.3, 0.2
    spread = {"sigma": 0.1, "R": 0.1}
    known = rough.calibrated(load, mu, error=error)
    loads = np.array([1e5, load, 1e8])
    band = uncertainty(known, spread, loads)

    random = np.random.default_rng(4)
    logs = []
    for sigma, radius in np.exp(0.1 * random.standard_normal((300, 2))):
        changed = known.replace(height_std=sigma * known.height_std, summit_radius=radius * known.summit_radius)
        with Model(changed) as model:
            logs.append(np.log(model.friction_force_at_load(loads)))
    # Friction is in proportion to the strength.
    strength = math.log(10) / 1.959964 * random.standard_normal((300, 200, 1))
    drawn = np.array(logs)[:, None, :] + strength
    weight = np.exp(-0.5 * ((drawn[..., 1] - math.log(mu * load)) / error) ** 2).ravel()
    drawn = drawn.reshape(-1, 3)
    mean = np.average(drawn, weights=weight, axis=0)
    deviation = np.sqrt(np.average((drawn - mean) ** 2, weights=weight, axis=0))
    assert band.deviation == pytest.approx(deviation, rel=0.03)
    assert np.log(band.value * loads) == pytest.approx(mean, abs=0.02)
    # At the load of the measurement the band is that of the measurement; farther away it is wider.
    assert band.deviation[1] == pytest.approx(error, rel=0.02) and (band.deviation[[0, 2]] > band.deviation[1]).all()
    assert band.rests_on[0] == "strength of the interface: measured at 1e+06 [force] to 20 %"
    # The parameters are correlated afterwards: all together are known better than each alone.
    alone = np.sqrt(sum(part**2 for part in band.parts.values()))
    assert (band.deviation < alone).all()
    sampled = uncertainty(known, spread, loads, samples=300, seed=5)
    assert sampled.samples is not None
    assert np.std(np.log(sampled.samples), axis=0) == pytest.approx(deviation, rel=0.15)


def test_a_measurement_tells_of_every_parameter_that_it_depends_on(rough: Params) -> None:
    """Where the strength is known, a measured force narrows what else decides on it."""
    known = rough.calibrated(1e6, 0.3, error=0.02)
    spread = {"sigma": 0.2, "slip_stress": 0.0}
    before = uncertainty(known.replace(calibration_error=1.0), spread, [1e6]).deviation[0]
    before = 1 / math.sqrt(1 / before**2 - 1)
    after = uncertainty(known, spread, [1e6])
    expected = 1 / math.sqrt(1 / before**2 + 1 / 0.02**2)
    assert after.deviation[0] == pytest.approx(expected, rel=1e-9) == pytest.approx(after.parts["sigma"][0], rel=1e-9)


@pytest.fixture(scope="module")
def carbon() -> Params:
    carbon = Params.si(
        E1=493e9, nu1=0.25, E2=493e9, nu2=0.25, hardness=51e9, work_of_adhesion=0.06, adhesion_range=0.25e-9, burgers_vector=0.25e-9,
        height_std=0.8e-9, summit_radius=200e-9, summit_density=5e12, nominal_area=1e-6,
    )  # fmt: skip
    return carbon.calibrated(1e-3, 0.3)


@pytest.mark.parametrize("wide", [0.05, 0.15, 0.3])
def test_the_band_at_the_load_of_the_measurement_is_that_of_the_measurement(carbon: Params, wide: float) -> None:
    """Within 5 %, one standard deviation, however little is known of the roughness: 1.103 is exp(1.96 0.05)."""
    loads = np.array([1e-5, 1e-3, 1e-1])
    spread = {"height_std": wide, "work_of_adhesion": 2 * wide, "summit_radius": 2 * wide}
    linear = uncertainty(carbon, spread, loads)
    assert linear.high[1] / linear.value[1] == pytest.approx(1.103, abs=1e-3) == linear.value[1] / linear.low[1]
    drawn = uncertainty(carbon, spread, loads, samples=300, seed=1)
    assert drawn.samples is not None
    assert drawn.deviation[1] == pytest.approx(0.05, rel=0.15)
    assert (drawn.high / drawn.low)[1] < min((drawn.high / drawn.low)[[0, 2]])

    # Elsewhere it is that of surfaces drawn as they were known before, with the probability that each gives to the measurement.
    random = np.random.default_rng(2)
    logs = []
    for sigma, work, radius in np.exp(wide * np.array([1, 2, 2]) * random.standard_normal((300, 3))):
        changed = carbon.replace(
            height_std=sigma * carbon.height_std, work_of_adhesion=work * carbon.work_of_adhesion,
            summit_radius=radius * carbon.summit_radius,
        )  # fmt: skip
        with Model(changed) as model:
            logs.append(np.log(model.friction_force_at_load(loads)))
    strength = math.log(10) / 1.959964 * random.standard_normal((300, 2000, 1))
    before = (np.array(logs)[:, None, :] + strength).reshape(-1, 3)
    weight = np.exp(-0.5 * ((before[:, 1] - math.log(0.3e-3)) / 0.05) ** 2)
    for i in (0, 2):
        order = np.argsort(before[:, i])
        part = np.cumsum(weight[order]) / weight.sum()
        for at in (0.1, 0.5, 0.9):
            share = (np.log(drawn.samples[:, i] * loads[i]) <= before[order, i][np.searchsorted(part, at)]).mean()
            assert share == pytest.approx(at, abs=0.09)


def test_a_measurement_where_the_strength_is_known_leaves_surfaces_that_have_its_friction(carbon: Params) -> None:
    """As many as that is likely; too few if it is next to impossible."""
    spread = {"height_std": 0.2, "slip_stress": 0.0}
    drawn = uncertainty(carbon, spread, [1e-3], samples=200)
    linear = uncertainty(carbon, spread, [1e-3])
    assert drawn.deviation == pytest.approx(linear.deviation, rel=0.15)
    with pytest.raises(ValueError, match="have the friction that was measured"):
        uncertainty(carbon.replace(calibration_error=1e-5), {"summit_radius": 1.0, "slip_stress": 0.0}, [1e-3], samples=2)


def test_a_pressure_coefficient_has_its_part_of_the_measurement_in_each_surface_drawn(rough: Params) -> None:
    known = rough.replace(pressure_coefficient=0.1).calibrated(1e6, 0.3)
    drawn = uncertainty(known, {"sigma": 0.3}, [1e6], samples=100)
    assert drawn.deviation[0] == pytest.approx(0.05, rel=0.2)


def test_a_surface_changed_after_calibration_has_the_strength_of_another(rough: Params) -> None:
    """To the error of the measurement, independently of this roughness."""
    known = rough.calibrated(1e6, 0.3, error=0.1)
    changed = known.replace(height_std=1.5 * known.height_std)
    band = uncertainty(changed, {"sigma": 0.05}, [1e6])
    assert band.rests_on[0] == "strength of the interface: measured on another surface, at 1e+06 [force] to 10 %"
    assert band.parts["slip_stress"][0] == pytest.approx(0.1, rel=1e-6)
    assert band.deviation[0] == pytest.approx(math.hypot(band.parts["sigma"][0], 0.1), rel=1e-6)
    assert uncertainty(changed, loads=[1e4, 1e6]).deviation == pytest.approx([0.1, 0.1], rel=1e-6)
    named = uncertainty(changed, {"slip_stress": 0.3}, [1e6])
    assert named.deviation[0] == pytest.approx(0.3, rel=1e-6)


def test_the_library_says_whether_a_strength_is_measured(rough: Params) -> None:
    for one, expected in (
        (rough, True),
        (rough.replace(asperity_count=1), True),
        (rough.replace(slip_radius_1=20.0), True),
        (rough.calibrated(1e6, 0.2), False),
    ):
        with Model(one) as model:
            assert model.uncalibrated is expected


def test_a_fit_brings_its_spread_and_correlations_with_it(params: Params) -> None:
    with Model(params) as model:
        mu = model.friction_at_load(LOADS)
    found = fit(LOADS, mu * (1 + 0.003 * np.random.default_rng(2).standard_normal(LOADS.size)), 0.003 * mu,
                ("gamma", "sigma"), params=params)  # fmt: skip
    band = uncertainty(found)
    assert band.load.tolist() == LOADS.tolist() and band.value == pytest.approx(found.fitted, rel=1e-12)
    # Better known than a point of the data, and than by the two errors alone.
    assert band.deviation.max() < 0.003
    alone = np.sqrt(sum(part**2 for part in band.parts.values()))
    assert (band.deviation < alone).all()
    assert band.rests_on == ("a fit of gamma, sigma to 9 points",)
    with pytest.raises(ValueError, match="spread: a fit brings its own"):
        uncertainty(found, {"sigma": 0.1})


def test_spreads_that_leave_the_domain_are_drawn_anew_or_refused(params: Params) -> None:
    found = uncertainty(params.replace(radius_amplitude=0.9), {"epsilon": 0.1}, [1.0], samples=20)
    assert found.refused > 0 and found.samples is not None and np.isfinite(found.samples).all()
    with pytest.raises(ValueError, match="are refused; make it smaller"):
        uncertainty(params, {"epsilon": 100.0}, [1.0], samples=2)


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({"spread": {}}, "must name at least one"),
        ({"spread": {"nonsense": 0.1}}, "name 'nonsense'"),
        ({"spread": {"sigma": -0.1}}, "spread of sigma = -0.1"),
        ({"spread": {"w": 30}}, "spread of w = 30.0: is relative to the value and must be at most 2.*; 30 % are 0.3"),
        ({"spread": {"R": 4e-8}}, "spread of R = 4e-08: is relative .* at least 1e-06; divide an error in units by the value"),
        ({"spread": {"N": 2e11}}, "divide an error in units by the value"),
        ({"spread": {"sigma": 0.1, "height_std": 0.1}}, "both vary"),
        ({"loads": None}, "loads: must be given"),
        ({"loads": [[1.0]]}, "one-dimensional"),
        ({"quantity": "stress"}, "quantity = 'stress': must be one of 'mu', 'force'"),
        ({"samples": 1}, "from 2 on"),
        ({"coverage": 1.0}, "between 0 and 1"),
    ],
)
def test_what_cannot_be_used_is_refused(given: Params, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        uncertainty(given, **({"spread": {"sigma": 0.1}, "loads": [1.0]} | arguments))


def test_a_band_is_drawn(given: Params, tmp_path: Path) -> None:
    figure = uncertainty(given, {"sigma": 0.1, "w": 0.2}, LOADS).plot(tmp_path / "band.svg")
    legend = figure.axes[1].get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["sigma", "w", "all"]
    legend = figure.axes[0].get_legend()
    assert legend is not None
    assert [text.get_text() for text in legend.get_texts()] == ["95 %\nstrength of the interface: as given\nsigma: 10 %\nw: 20 %\nall else: taken as known"]
    assert (tmp_path / "band.svg").stat().st_size > 1000


@pytest.mark.parametrize(
    "spread, message",
    [({"sigma": "10%"}, "spread of sigma = '10%': must be a real number; 10 % are 0.1"), (["sigma"], "must be a mapping")],
)
def test_what_is_no_number_is_refused_by_name(params: Params, spread: Any, message: str) -> None:
    with pytest.raises(TypeError, match=message):
        uncertainty(params, spread, [1.0])
