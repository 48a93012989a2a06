"""Fits to synthetic measurements: known parameters come back within their errors, and what is not known is said."""

from __future__ import annotations

import dataclasses
import math
import re
import subprocess
import sys
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from processes import run_main
from scipy.stats import chi2

from asperity import Error, Fit, Model, Params, fit, uncertainty
from asperity.fits import names as fit_names
from asperity.fits import trend as fit_trend

LOADS = np.geomspace(0.1, 1e4, 25)
SEEDS = range(6)


def friction(params: Params) -> Any:
    with Model(params) as model:
        return model.friction_at_load(LOADS)


def measured(params: Params, seed: int, noise: float) -> tuple[Any, Any]:
    """Friction with normal noise of a relative size, and the standard errors."""
    mu = friction(params)
    return mu * (1 + noise * np.random.default_rng(seed).standard_normal(mu.size)), noise * mu


# ---- Known parameters come back ----

CASES: list[Any] = [
    (("gamma",), {"gamma": 0.001}, {"gamma": 0.02}),
    (("sigma", "R"), {"sigma": 10.0, "R": 1e5}, {"alpha": 0.02, "beta": 600.0}),
    (("alpha", "beta", "gamma"), {"alpha": 0.01, "beta": 1000.0, "gamma": 0.001},
     {"alpha": 0.02, "beta": 600.0, "gamma": 0.003}),
    (("gamma", "h"), {"gamma": 0.001, "h": 1.0}, {"gamma": 0.002, "b_over_h": 2.0}),
]  # fmt: skip


@pytest.mark.parametrize("free, truth, start, weighted", [*((*case, True) for case in CASES), (*CASES[1], False)])
def test_known_parameters_come_back_within_their_errors(
    params: Params, free: tuple[str, ...], truth: dict[str, float], start: dict[str, Any], weighted: bool
) -> None:
    """The squared deviations over the covariance are chi-square distributed, for noise small enough to be linear in."""
    begin = Params.dimensionless(**({"alpha": 0.01, "beta": 1000.0, "gamma": 0.001} | start))
    known = np.array([truth[name] for name in free])
    deviations, squares = 0.0, 0.0
    for seed in SEEDS:
        mu, sigma = measured(params, seed, 0.003)
        if not weighted:  # the same noise at all loads
            mu, sigma = friction(params) + 0.002 * (mu - friction(params)) / sigma, None
        found = fit(LOADS, mu, sigma, free, params=begin)
        assert found.success and not found.unidentifiable and not found.at_bound
        off = np.array([found.values[name] for name in free]) - known
        deviations += float(off @ np.linalg.solve(found.covariance, off))
        squares += found.chi_square if weighted else found.chi_square / 0.002**2
    freedom = LOADS.size - len(free)
    assert 0.001 < chi2.sf(squares, len(SEEDS) * freedom) < 0.999
    # Scaled by the scatter of the residuals, the deviations are F distributed, whose mean is a little larger.
    mean = 1.0 if weighted else freedom / (freedom - 2)
    assert 0.001 < chi2.sf(deviations / mean, len(SEEDS) * len(free)) < 0.999


# ---- Bands, outliers, several starts ----


def test_the_band_of_a_prediction_is_that_of_the_spread_between_fits(params: Params) -> None:
    """Between the loads measured and beyond them."""
    loads = np.array([0.3, 30.0, 3e3, 1e6])
    fits = [fit(LOADS, *measured(params, seed, 0.003), ("gamma", "sigma"), params=params) for seed in range(20)]
    found = [one.predict(loads) for one in fits]
    with Model(params) as model:
        off = np.array([one.friction for one in found]) - model.friction_at_load(loads)
    scores = off / np.array([one.error for one in found])
    for k in range(loads.size):
        assert 0.001 < chi2.sf(float(scores[:, k] @ scores[:, k]), 20) < 0.999, loads[k]
    assert fits[0].predict(LOADS).friction == pytest.approx(fits[0].fitted, rel=1e-12)
    with pytest.raises(ValueError, match=r"load\[1\] = 0: must be > 0"):
        fits[0].predict([1.0, 0.0])


@pytest.mark.parametrize("loss", ["huber", "soft_l1", "cauchy"])
@pytest.mark.parametrize("weighted", [True, False])
def test_points_far_off_do_not_move_a_robust_fit(params: Params, loss: str, weighted: bool) -> None:
    deviations, plain = [], []
    for seed in range(4):
        mu, sigma = measured(params, seed, 0.003)
        if not weighted:  # the same noise at all loads
            mu = friction(params) + 0.005 * (mu - friction(params)) / sigma
        mu[[3, 12, 20]] *= 1.3
        errors = sigma if weighted else None
        one = fit(LOADS, mu, errors, ("sigma",), params=params, loss=loss)
        deviations.append((one.values["sigma"] - 10) / one.errors["sigma"])
        plain.append(fit(LOADS, mu, errors, ("sigma",), params=params).values["sigma"] - 10)
        far = re.search(f"loss {loss}: (\\d) points are more than 4 standard errors off", one.message)
        assert far is not None and 3 <= int(far[1]) <= (3 if weighted else 5)
        assert one.errors["sigma"] < 0.02
    assert np.mean(np.square(deviations)) < 4 and np.abs(plain).min() > 0.05


def test_several_starts_are_searched_from_and_the_best_end_is_taken(params: Params) -> None:
    mu, sigma = measured(params, 3, 0.003)
    far = params.replace(work_of_adhesion=40 * params.work_of_adhesion, height_std=80.0)
    found = fit(LOADS, mu, sigma, ("gamma", "sigma"), params=far, starts=4, seed=2)
    best = fit(LOADS, mu, sigma, ("gamma", "sigma"), params=params)
    assert found.chi_square == pytest.approx(best.chi_square, rel=1e-4)
    assert " of 4 starts end here" in found.message
    with pytest.raises(ValueError, match="starts = 0: must be 1 or more"):
        fit(LOADS, mu, sigma, ("gamma",), params=params, starts=0)
    with pytest.raises(ValueError, match="loss = 'l2': must be one of 'linear', 'huber', 'soft_l1', 'cauchy'"):
        fit(LOADS, mu, sigma, ("gamma",), params=params, loss="l2")


def test_weibull_heights_come_back_from_a_gaussian_start(params: Params) -> None:
    mu, sigma = measured(params.replace(skew=0.6), 3, 0.003)
    found = fit(LOADS, mu, sigma, ("skew",), params=params)
    assert found.params.height_distribution == "weibull"
    assert abs(found.values["skew"] - 0.6) < 4 * found.errors["skew"] < 0.05


def test_skew_and_kurtosis_of_johnsons_heights_come_back(params: Params) -> None:
    mu, sigma = measured(params.replace(skew=0.3, kurtosis=3.5), 3, 0.003)
    found = fit(LOADS, mu, sigma, ("skew", "kurtosis"), params=params.replace(skew=0.0, kurtosis=3.0))
    off = np.array([found.values["skew"] - 0.3, found.values["kurtosis"] - 3.5])
    assert off @ np.linalg.solve(found.covariance, off) < chi2.isf(0.001, 2)
    assert max(found.errors.values()) < 0.01 and found.params.height_distribution == "johnson"


def test_forces_are_fitted_at_negative_loads_too(sticky: Params) -> None:
    """Also from a start that does not hold the surfaces together at all of them."""
    with Model(sticky) as model:
        pull_off = model.summary().pull_off_load
        load = np.concatenate([np.linspace(0.9 * pull_off, 0, 8), np.geomspace(0.1, 1e3, 12) * -pull_off])
        force = model.friction_force_at_load(load)
    sigma = 0.003 * force
    force = force + sigma * np.random.default_rng(4).standard_normal(load.size)
    begin = sticky.replace(work_of_adhesion=sticky.work_of_adhesion / 4)
    with Model(begin) as model:
        assert model.summary().pull_off_load > 0.9 * pull_off
    found = fit(load, sigma=sigma, free=("gamma", "sigma"), params=begin, force=force)
    off = np.array([found.values["gamma"] - 0.02, found.values["sigma"] - 10])
    assert off @ np.linalg.solve(found.covariance, off) < chi2.isf(0.001, 2)
    assert "pull-off" not in found.message
    stiff = fit(load, sigma=sigma, free=("G*",), params=begin, force=force)
    assert "below the fitted pull-off load" in stiff.message


# ---- Bands of few points, trends of residuals ----


def test_bands_of_few_points_are_students(params: Params) -> None:
    load = LOADS[[3, 12]]
    with Model(params) as model:
        exact = model.friction_at_load(load)
    two = fit(load, exact * [1.02, 0.99], None, ("slip_stress",), params=params)
    assert two.reach() == pytest.approx(12.706, abs=1e-3)
    assert "a 95 % band has 12.7 of them to either side" in two.message
    known = fit(load, exact * [1.02, 0.99], 0.03 * exact, ("slip_stress",), params=params)
    assert known.reach() == pytest.approx(1.95996, abs=1e-5) and "of them to either side" not in known.message
    assert known.reach(0.5) == pytest.approx(0.67449, abs=1e-5)
    for one in (two, known):
        band = uncertainty(one, loads=[10.0])
        assert math.log(band.high[0] / band.value[0]) == pytest.approx(one.reach() * float(band.deviation[0]), rel=1e-9)
        drawn = uncertainty(one, loads=[10.0], samples=400, coverage=0.5)
        wide = math.log(drawn.high[0] / drawn.low[0]) / (2 * one.reach(0.5) * float(band.deviation[0]))
        assert 0.8 < wide < 1.25
    with pytest.raises(ValueError, match="coverage = 95: must be between 0 and 1"):
        two.reach(95)


def test_a_pressure_coefficient_is_found_and_asked_for(params: Params) -> None:
    """Residuals that follow the load say that it is missing."""
    random = np.random.default_rng(5)
    truth = params.replace(pressure_coefficient=0.3)
    mu = friction(truth) * (1 + 0.01 * random.standard_normal(LOADS.size))
    without = fit(LOADS, mu, 0.01 * mu, ("slip_stress",), params=params)
    assert "the residuals follow load" in without.message and "law: free pressure_coefficient" in without.message
    found = fit(LOADS, mu, 0.01 * mu, ("slip_stress", "pressure_coefficient"), params=params)
    assert "the residuals" not in found.message and not found.at_bound and (found.reduced_chi_square or 9) < 2
    assert abs(found.values["pressure_coefficient"] - 0.3) < 4 * found.errors["pressure_coefficient"] < 0.1
    # By the search that serves other names too.
    also = fit(LOADS, mu, 0.01 * mu, ("slip_stress_1", "slip_stress_2", "kappa"), params=params)
    assert also.success and abs(also.values["kappa"] - 0.3) < 4 * also.errors["kappa"]
    # Friction that falls faster has another cause.
    falls = fit(LOADS, friction(params) * LOADS**-0.1, None, ("slip_stress",), params=params)
    assert "the residuals follow load" in falls.message and "pressure_coefficient" not in falls.message.split("calibrated")[0]
    # What the data would have below 0 stays there.
    assert fit(LOADS, friction(params) * LOADS**-0.1, None, ("slip_stress", "kappa"), params=params).at_bound == ("kappa",)


def test_residuals_that_turn_are_told() -> None:
    load = np.geomspace(1.0, 100.0, 12)
    runs = fit_trend.runs
    turning = np.array([-1.0] * 3 + [1.0] * 6 + [-1.0] * 3) + np.linspace(0, 1e-3, 12)
    assert runs(load, turning) == pytest.approx((3, (2 + 10) / math.comb(12, 6)))
    long = np.array([-1.0] * 6 + [1.0] * 12 + [-1.0] * 6)
    (told,) = fit_trend.trends(np.geomspace(1, 100, 24), long + np.tile([0.1, -0.1], 12), np.ones(24), False)
    assert "turn with load (3 runs of one sign" in told and told.endswith("free pressure_coefficient, or what sets light loads")
    # All orders of signs, counted.
    for up in range(1, 6):
        for down in range(1, 6):
            orders = [np.isin(np.arange(up + down), at) for at in combinations(range(up + down), up)]
            counts = np.array([1 + int(np.count_nonzero(one[1:] != one[:-1])) for one in orders])
            for one, count in zip(orders, counts):
                found = runs(np.arange(float(up + down)), np.where(one, 1.0, -1.0))
                assert found == pytest.approx((count, float(np.mean(counts <= count))))
    assert runs(np.ones(5), np.ones(5)) == (1, 1.0)
    assert not fit_trend.trends(load, np.zeros(12), np.ones(12), False)


# ---- The search ----


def test_surfaces_that_are_refused_are_stepped_back_from(params: Params) -> None:
    """slip_radius_1 must stay below slip_radius_2, and the first step goes beyond."""
    truth = params.replace(slip_radius_2=300.0, slip_radius_1=200.0, slip_stress_2=0.02)
    begin = truth.replace(slip_radius_1=30.0)
    with pytest.raises(Error):
        Model(truth.replace(slip_radius_1=310.0))
    found = fit(LOADS, friction(truth), None, ("slip_radius_1",), params=begin)
    assert found.values["slip_radius_1"] == pytest.approx(200.0, rel=1e-5)


def test_a_value_at_its_bound_is_named(params: Params) -> None:
    bounds = {"gamma": (0.0001, 0.0005)}
    begin = params.replace(work_of_adhesion=params.work_of_adhesion / 4)
    found = fit(LOADS, *measured(params, 5, 0.01), ("gamma", "sigma"), params=begin, bounds=bounds)
    assert found.at_bound == ("gamma",) and "at a bound: gamma = 0.0005" in found.message
    assert found.values["gamma"] == pytest.approx(0.0005)


# ---- What the data do not tell ----


@pytest.mark.parametrize(
    "free, why",
    [
        (("G*", "slip_stress_1", "slip_stress_2"),
         "G*; a change of it is made up for by slip_stress_1 and slip_stress_2"),
        (("E*", "G*", "w", "N"), "w; a change of it is made up for by E*, G* and N"),
        (("gamma", "rho"), "rho; it does not change the friction here"),
        (("gamma", "slip_radius_2", "slip_stress_2"), "slip_radius_2; a change of it is made up for by slip_stress_2"),
    ],
)  # fmt: skip
def test_what_is_degenerate_is_not_identifiable(params: Params, free: tuple[str, ...], why: str) -> None:
    found = fit(LOADS, *measured(params, 6, 0.003), free, params=params)
    name = why.partition(";")[0]
    assert name in found.unidentifiable and math.isinf(found.errors[name])
    assert f"not identifiable: {why}" in found.message
    if "gamma" in free:
        assert "gamma" not in found.unidentifiable and found.errors["gamma"] < 0.0001


def test_a_parameter_that_hardly_matters_is_not_identifiable(params: Params) -> None:
    """At heavy loads adhesion changes friction by less than the noise."""
    load = np.geomspace(1e6, 1e7, 25)
    with Model(params) as model:
        mu = model.friction_at_load(load)
    mu *= 1 + 0.03 * np.random.default_rng(7).standard_normal(load.size)
    found = fit(load, mu, 0.03 * mu, ("gamma",), params=params)
    assert found.unidentifiable == ("gamma",)
    assert "gamma; it hardly changes the friction here" in found.message


def test_a_strong_correlation_is_named(params: Params) -> None:
    found = fit(LOADS, *measured(params, 8, 0.003), ("gamma", "sigma"), params=params)
    assert not found.unidentifiable and found.correlation[0, 1] > 0.99
    assert f"correlated by {found.correlation[0, 1]:.4f}: gamma and sigma" in found.message


# ---- Names ----


def test_every_name_is_documented() -> None:
    rows = [row.split("|") for row in (fit_names.__doc__ or "").split("\n| ")[2:]]
    assert {name.strip() for row in rows for name in row[0].split(",")} == set(fit_names._KINDS)
    assert {row[1].strip() for row in rows} - {""} == set(fit_names._SYMBOLS)


@pytest.mark.parametrize("name", sorted({*fit_names._KINDS, *fit_names._SYMBOLS}))
def test_a_name_varies_its_fields_and_no_other(name: str) -> None:
    params = Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001, skew=0.3, radius_amplitude=0.2)
    if name == "kurtosis":
        params = params.replace(kurtosis=3.0)
    if name in ("pressure_coefficient", "kappa"):
        params = params.replace(pressure_coefficient=0.1)
    if name in ("Sq", "Sdq"):
        bodies = ("composite_modulus", "effective_shear_modulus", "adhesion_range", "burgers_vector")
        given: dict[str, Any] = dict.fromkeys(bodies, 1.0) | {"work_of_adhesion": 0.0}
        params = Params.from_spectral_moments(m0=100.0, m2=0.01, nominal_area=1e6, **given)
    (chosen,) = fit_names.free_names([name], params)
    value = chosen.start(params)
    changed = chosen.put(params, 1.25 * value)
    assert chosen.get(changed) == pytest.approx(1.25 * value, rel=1e-9)
    before, after = vars(params), vars(changed)
    varied = {field for field in before if before[field] != pytest.approx(after[field])}
    # Height and slope make the same fields together, and each leaves that of the other as it is.
    own = {"Sq": {"rms_slope"}, "Sdq": {"height_std", "summit_mean_height"}}.get(name, set())
    assert varied == set(chosen.varies) - own


def test_groups_keep_to_what_the_library_says(params: Params) -> None:
    """Also where the Burgers vector, which they contain, is free."""
    names = fit_names.free_names(["b", "E*", "alpha", "beta", "gamma", "b_over_h"], params)
    changed = params
    for name, value in zip(names, (2.0, 5.0, 0.02, 700.0, 0.003, 1.5)):
        changed = name.put(changed, value)
    with Model(changed) as model:
        summary = model.summary()
    assert (summary.alpha, summary.beta, summary.gamma) == pytest.approx((0.02, 700, 0.003))
    assert changed.burgers_vector / changed.adhesion_range == pytest.approx(1.5)


# ---- Bad input ----

GOOD: dict[str, Any] = {"load": [1.0, 2.0, 3.0, 4.0], "mu": [1.0, 0.9, 0.8, 0.7], "free": ("gamma", "sigma")}


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"mu": [1.0, 2.0]}, "mu has 2 values, load 4: must be as many"),
        ({"sigma": [0.1, 0.1]}, "sigma has 2 values, load 4: must be as many"),
        ({"mu": [1.0, math.nan, 1.0, 1.0]}, r"mu\[1\] = nan: must be finite"),
        ({"load": [1.0, 2.0, math.inf, 4.0]}, r"load\[2\] = inf: must be finite"),
        ({"load": [1.0, 0.0, 3.0, 4.0]}, r"load\[1\] = 0: must be > 0, for F/P has no finite value there"),
        ({"mu": [1.0, 1.0, 1.0, -1.0]}, r"mu\[3\] = -1: must be > 0"),
        ({"sigma": 0.0}, r"sigma\[0\] = 0: must be > 0"),
        ({"sigma": [0.1, 0.1, -0.1, 0.1]}, r"sigma\[2\] = -0.1: must be > 0"),
        ({"sigma": math.nan}, r"sigma\[0\] = nan: must be finite"),
        ({"load": [[1.0, 2.0], [3.0, 4.0]]}, "load: must be a one-dimensional array of one or more real numbers"),
        ({"force": [1.0, 2.0, 3.0, 4.0]}, "give either mu or force"),
        ({"mu": None}, "give either mu or force"),
        ({"mu": None, "force": [1.0, 2.0, -3.0, 4.0]}, r"force\[2\] = -3: must be >= 0"),
        ({"free": ()}, "must have one or more names"),
        ({"free": "gamma"}, "must be a sequence of names"),
        ({"free": ("kurtosis",)}, "'kurtosis': is of Johnson's heights; give params a kurtosis to start from"),
        ({"free": ("gama",)}, "name 'gama': must be one of composite_modulus or E.*, gamma"),
        ({"free": ("gamma", "w")}, "free names gamma and w both vary work_of_adhesion"),
        ({"free": ("alpha", "R")}, "free names alpha and R both vary summit_radius"),
        ({"free": ("gamma", "gamma")}, "both vary work_of_adhesion"),
        ({"free": ("alpha", "alpha")}, "both vary height_std and summit_radius"),
        ({"free": ("gamma", "sigma", "rho", "N")}, "4 points for 4 free names: there must be more points"),
        ({"bounds": {"rho": (1, 2)}}, "bounds of rho: must be of free names"),
        ({"bounds": {"gamma": 0.01}}, "bounds of gamma = 0.01: must be two numbers"),
        ({"bounds": {"gamma": (0.01, math.nan)}}, "must ascend and be finite and > 0"),
        ({"bounds": {"gamma": (0.01, 0.001)}}, "bounds of gamma = .*: must ascend and be finite and > 0"),
        ({"bounds": {"gamma": (0.0, 1.0)}}, "must ascend and be finite and > 0"),
        ({"bounds": {"gamma": (0.1, 1.0)}}, "gamma = 0.001 in params: must start between its bounds, 0.1 and 1"),
        ({"free": ("epsilon",), "bounds": {"epsilon": (-2, 1)}}, "must ascend and be within -1 to 1"),
        ({"start": {"work_of_adhesion": 0.0}}, "gamma = 0 in params: to be free it must start finite and > 0"),
        ({"free": ("skew",), "start": {"skew": -1.11001}}, "skew = -1.1100.* in params: .* within -1.11 to 2"),
        ({"start": {"slip_radius_1": 1e6}}, "slip_radius"),
    ],
)  # fmt: skip
def test_bad_input_is_refused(params: Params, changes: dict[str, Any], message: str) -> None:
    arguments = GOOD | {"params": params.replace(**changes.get("start", {}))} | changes
    arguments.pop("start", None)
    with pytest.raises((Error, TypeError), match=message):
        fit(**arguments)


# ---- The figure ----


@pytest.fixture(scope="module")
def found(params: Params) -> Fit:
    return fit(LOADS, *measured(params, 9, 0.01), ("gamma", "sigma"), params=params)


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_the_figure_shows_data_fit_and_residuals(found: Fit, tmp_path: Path) -> None:
    figure = found.plot(tmp_path / "fit.svg")
    assert (tmp_path / "fit.svg").read_text(encoding="utf-8").startswith("<?xml")
    above, below = figure.axes
    points, curve = above.lines[0], above.lines[-1]
    assert points.get_ydata() == pytest.approx(found.measured)
    with Model(found.params) as model:
        assert curve.get_ydata() == pytest.approx(model.friction_at_load(np.asarray(curve.get_xdata())))
    assert below.lines[-1].get_ydata() == pytest.approx(found.residuals)
    legend = above.get_legend()
    texts = "\n".join(text.get_text() for text in legend.get_texts()) if legend is not None else ""
    assert "gamma = " in texts and "95 % band of the fit" in texts and f"sigma = {found.values['sigma']:.4g}" in texts
    assert texts.count("[length]") == 1 and below.get_xlabel() == "normal load $P$ [force]"
    above, below = dataclasses.replace(found, params=found.params.replace(in_si=True)).plot().axes
    legend = above.get_legend()
    assert legend is not None and any("[m]" in text.get_text() for text in legend.get_texts()) and below.get_xlabel().endswith("[N]")


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_the_figure_of_forces_reaches_negative_loads(sticky: Params) -> None:
    with Model(sticky) as model:
        load = np.linspace(model.summary().pull_off_load, 1e4, 12)
        force = model.friction_force_at_load(load)
    figure = fit(load, force=force, free=("N",), params=sticky).plot()
    above = figure.axes[0]
    assert above.get_ylabel() == "friction force $F$ [force]"
    assert above.get_xscale() == "symlog" and np.min(np.asarray(above.lines[-1].get_xdata())) == load[0]


@pytest.mark.parametrize("package, call", [("scipy", "f()"), ("matplotlib", "f().plot()")])
def test_a_missing_package_is_named(tmp_path: Path, package: str, call: str) -> None:
    (tmp_path / f"{package}.py").write_text(f"raise ImportError('No module named {package}')")
    program = f"""
from asperity import Params, fit
params = Params.paper()
f = lambda: fit([1, 2, 3], [3, 2.8, 2.7], free=["gamma"], params=params)
{call}"""
    done = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 1 and f"pip install {package}" in done.stderr


# ---- The command line ----


def table(*columns: Any) -> str:
    return "# measured\n" + "".join(" ".join(f"{number:.17g}" for number in row) + "\n" for row in zip(*columns))


def test_the_command_finds_what_the_function_finds(params: Params, found: Fit, tmp_path: Path) -> None:
    file, figure = tmp_path / "friction.txt", tmp_path / "fit.png"
    file.write_text(table(found.load, found.measured, found.sigma))
    command = [sys.executable, "-m", "asperity", "fit", str(file), "--free", "gamma,sigma", "--figure", str(figure)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0 and figure.read_bytes().startswith(b"\x89PNG")
    assert done.stderr.startswith("asperity: warning: between the loads 0.1 and 10000: UNCALIBRATED") and done.stderr.count("\n") == 1
    head, gamma, sigma, *remarks = done.stdout.splitlines()
    assert head == "# name, value, standard error"
    for line, name in ((gamma, "gamma"), (sigma, "sigma")):
        assert line.split() == [name, f"{found.values[name]:.9e}", f"{found.errors[name]:.3e}"]
    assert remarks == [f"# {line}" for line in found.message.splitlines()]


def test_the_command_reads_commas_forces_bounds_and_a_start(params: Params) -> None:
    start = params.replace(radius_amplitude=0.5)
    force = LOADS * friction(start.replace(asperity_count=3.0))
    text = table(LOADS, force).replace(" ", ",").replace("#,", "# ")
    done = run_main("fit", "-", "--free=N", "--force", "--bounds", "N", 0.5, 5, "--radius-amplitude", 0.5, text=text)
    assert float(done.stdout.split()[5 + 1]) == pytest.approx(3.0, rel=1e-6)


@pytest.mark.parametrize(
    "arguments, text, status, message",
    [
        (["-"], "", 2, "the following arguments are required: --free"),
        (["-", "--free=gamma", "--bounds", "gamma", "x", "1"], "", 2, "--bounds: could not convert string to float"),
        (["no-such-file", "--free=gamma"], "", 1, "No such file"),
        (["-", "--free=gamma"], "", 1, "-: must have 2 or 3 columns, load, friction and its standard error; it"),
        (["-", "--free=gamma"], "1 2\n3 4 5\n", 1, "it has 2 or 3"),
        (["-", "--free=gamma"], "# N\n1 x\n3 4\n", 1, "-, line 2: could not convert string to float: 'x'; # makes"),
        (["-", "--free=gama"], "1 2\n3 4\n", 1, "name 'gama': must be one of"),
        (["-", "--free=gamma"], "1 2\n-3 4\n", 1, "load[1] = -3: must be > 0"),
    ],
)  # fmt: skip
def test_the_command_refuses_bad_input(arguments: list[str], text: str, status: int, message: str) -> None:
    done = run_main("fit", *arguments, text=text)
    assert (done.returncode, done.stdout) == (status, "") and message in done.stderr and "Traceback" not in done.stderr


def test_it_says_what_it_calibrated(params: Params) -> None:
    many = params.replace(asperity_count=1e6)
    truth = many.replace(slip_stress_1=3 * many.slip_stress_1, slip_stress_2=3 * many.slip_stress_2)
    load = 1e6 * LOADS
    with Model(truth) as model:
        mu = model.friction_at_load(load)
    found = fit(load, mu, free=("slip_stress",), params=many)
    assert found.calibrated == ("slip_stress",)
    assert found.values["slip_stress"] == pytest.approx(truth.slip_stress_1, rel=1e-6)
    assert found.params.slip_stress_2 == pytest.approx(truth.slip_stress_2, rel=1e-6)
    assert f"calibrated by the data: slip_stress; slip_stress_1 = {truth.slip_stress_1:.6g}" in found.message
    other = fit(load, mu, free=("gamma",), params=many)
    assert other.calibrated == () and "not calibrated: the strength of the interface is the default" in other.message
    with pytest.raises(ValueError, match="slip_stress and slip_stress_2 both vary slip_stress_2"):
        fit(load, mu, free=("slip_stress", "slip_stress_2"), params=many)
