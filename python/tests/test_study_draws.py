"""What studies draw: spreads, distributions, lists and functions, how they are combined, and what is refused."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy import stats
from study_workers import LOADS, PARAMS

from asperity import Params
from asperity.studies.draws import Draws, drawn
from asperity.study import study


def draw(vary: Any, samples: Any = 512, sampling: str = "sobol", seed: int = 1, params: Params = PARAMS) -> Draws:
    return drawn(params, vary, samples, seed, sampling)


@pytest.mark.parametrize("sampling", ["sobol", "latin", "random"])
def test_a_number_is_a_relative_log_normal_spread(sampling: str) -> None:
    logs = np.log(draw({"height_std": 0.2}, sampling=sampling).values[:, 0] / PARAMS.height_std)
    tolerance = 4 / 512**0.5
    assert abs(logs.mean()) < 0.2 * tolerance and logs.std() == pytest.approx(0.2, rel=tolerance)
    assert stats.kstest(logs / 0.2, "norm").pvalue > 1e-3


def test_a_spread_of_what_may_be_negative_is_absolute() -> None:
    values = draw({"radius_amplitude": 0.1}, params=PARAMS.replace(radius_amplitude=-0.2)).values[:, 0]
    assert values.mean() == pytest.approx(-0.2, abs=0.01) and values.std() == pytest.approx(0.1, rel=0.03)


@pytest.mark.parametrize("distribution", [stats.uniform(2.0, 3.0), stats.lognorm(0.5, scale=4.0), stats.weibull_min(2.0)])
def test_distributions_of_scipy_are_followed(distribution: Any) -> None:
    found = draw({"height_std": distribution})
    assert stats.kstest(found.values[:, 0], distribution.cdf).statistic < 0.01  # Sobol' points
    assert found.told["height_std"].startswith("scipy.stats.")


def test_lists_make_a_grid_and_each_point_gets_all_samples() -> None:
    found = draw({"height_std": [1, 2.0], "summit_radius": 0.1, "w": np.array([0.0, 3.0, 4.0])}, 8)
    assert found.names == ("height_std", "summit_radius", "w") and found.values.shape == (48, 3)
    assert found.values[::8, [0, 2]].tolist() == [[1, 0], [1, 3], [1, 4], [2, 0], [2, 3], [2, 4]]
    assert all(np.array_equal(found.values[:8, 1], found.values[first : first + 8, 1]) for first in range(8, 48, 8))
    assert len(draw({"height_std": range(1, 4)}, None).values) == 3


def test_functions_draw_one_name_or_all_of_them() -> None:
    one = draw({"height_std": lambda random, count: random.uniform(1, 2, count), "w": 0.1}, 100)
    assert (1 <= one.values[:, 0]).all() and (one.values[:, 0] <= 2).all()

    def both(random: np.random.Generator, count: int) -> dict[str, Any]:
        heights = random.uniform(1, 2, count)
        return {"height_std": heights, "summit_radius": 100 / heights}

    found = draw(both, 100)
    assert np.allclose(found.values[:, 0] * found.values[:, 1], 100) and found.names == ("height_std", "summit_radius")


def test_the_matrices_for_indices_differ_from_the_first_in_one_column_each() -> None:
    sheets = draw({"height_std": 0.1, "w": lambda random, n: random.random(n), "hardness": stats.norm(5, 1)}, 16, "saltelli").values
    a, b, *mixed = sheets.reshape(5, 16, 3)
    assert not (a == b).any()
    for j, sheet in enumerate(mixed):
        assert np.array_equal(sheet[:, j], b[:, j]) and np.array_equal(np.delete(sheet, j, 1), np.delete(a, j, 1))


@pytest.mark.parametrize("sampling", ["sobol", "latin", "random", "saltelli"])
def test_a_seed_draws_the_same_and_another_one_others(sampling: str) -> None:
    vary = {"height_std": 0.1, "w": lambda random, n: random.random(n), "R": stats.norm(9.0)}
    first, again, other = (draw(vary, 16, sampling, seed).values for seed in (1, 1, 2))
    assert np.array_equal(first, again) and not (first == other).all(axis=0).any()


REFUSED = [
    ({}, 8, "vary = {}: must name one parameter or more"),
    (0.1, 8, "vary = 0.1: must be a mapping"),
    ({"heigth_std": 0.1}, 8, "'heigth_std': no parameter has this name; the nearest is height_std"),
    ({3: 0.1}, 8, "3: no parameter has this name"),
    ({"height_std": 20}, 8, "vary height_std = 20: is a spread relative to the value, .*; 20 % are 0.2"),
    ({"height_std": 0.0}, 8, "must be from 1e-06 to 2"),
    ({"height_std": math.nan}, 8, "must be from 1e-06 to 2"),
    ({"height_std": True}, 8, "vary height_std = True: must be a relative spread"),
    ({"height_std": "wide"}, 8, "vary height_std = 'wide': must be a relative spread"),
    ({"height_std": []}, None, "vary height_std: must be a one-dimensional array of one or more real numbers"),
    ({"height_std": [1, math.inf]}, None, r"vary height_std\[1\] = inf: must be finite"),
    ({"height_std": [1.0]}, 8, "samples = 8: all of vary are lists"),
    ({"height_std": stats.lognorm(-1)}, 8, "vary height_std: scipy.stats.lognorm.* has no values"),
    ({"height_std": lambda random, n: [1.0]}, 8, r"vary height_std: the function returned numbers of shape \(1,\)"),
    ({"height_std": lambda random, n: ["a"] * n}, 8, "the function returned: must be real numbers, not an array of <U1"),
    (lambda random, n: 3, 8, "the function returned int; must be a mapping"),
    ({"hardness": 0.1}, 8, "hardness = 0 in params: to be free it must start finite and > 0"),
    ({"height_std": 0.1, "sigma": 0.1}, 8, "both vary height_std"),
    ({"height_std": 0.1}, 0, "samples = 0: must be from 1 to 10000000"),
    ({"height_std": 0.1}, 10**400, "samples = a number of more than 300 digits: must be from 1"),
    ({"height_std": 0.1}, 1.5, "samples = 1.5: must be a whole number"),
    ({"height_std": [1.0] * 9, "w": 0.1}, 10**7, "samples = 10000000: make 90000000 surfaces; must make at most 10000000"),
]  # fmt: skip


@pytest.mark.parametrize("vary, samples, message", REFUSED)
def test_what_cannot_be_drawn_is_named(vary: Any, samples: Any, message: str) -> None:
    with pytest.raises((ValueError, TypeError), match=message):
        draw(vary, samples)


@pytest.mark.parametrize(
    "vary, message",
    [
        ({"height_std": 0.1}, "two or more parameters that vary independently at random"),
        ({"height_std": 0.1, "w": 0.1, "R": [1.0]}, "two or more parameters that vary independently at random"),
        (lambda random, n: {}, "needs a mapping of parameters"),
    ],
)
def test_indices_need_independent_parameters(vary: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        draw(vary, 8, "saltelli")


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"loads": []}, "loads: must be a real number or a one-dimensional array of one or more"),
        ({"loads": ["heavy"]}, "loads: must be real numbers"),
        ({"loads": [1.0, math.nan]}, r"loads\[1\] = nan: must be finite"),
        ({"loads": np.ones(2000), "samples": 10**7}, "2000 of them for 10000000 surfaces; must be at most 1e.10 states"),
        ({"seed": -1}, "seed = -1: must be from 0"),
        ({"seed": 10**400}, "seed = a number of more than 300 digits: must be from 0"),
        ({"seed": 0.5}, "seed = 0.5: must be a whole number"),
        ({"sampling": "monte carlo"}, "sampling = 'monte carlo': must be one of 'sobol'"),
        ({"block": 0}, "block = 0: must be from 1 to 8"),
        ({"workers": 0}, "workers = 0: must be from 1 to 1024"),
        ({"workers": 1.5}, "workers = 1.5: must be a whole number"),
        ({"params": "steel"}, "params = 'steel': must be a Params"),
        ({"executor": "dask"}, "executor = 'dask': must have the interface of concurrent.futures.Executor"),
    ],
)
def test_what_a_study_cannot_use_is_named(changes: dict[str, Any], message: str) -> None:
    given: dict[str, Any] = {"params": PARAMS, "vary": {"height_std": 0.1}, "loads": LOADS, "samples": 8, "progress": False}
    with pytest.raises((ValueError, TypeError), match=message):
        study(**{**given, **changes})
