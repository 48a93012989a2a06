"""Heights and slopes of maps at normal scores: of surfaces whose table is known, as users may give them, and of what is no surface."""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from random_surfaces import GaussianSurface

import asperity
from asperity import Model, Params, surface
from asperity.maps.at_scores import SCORES, AtScores, sloped

Array = npt.NDArray[np.float64]

pytestmark = [pytest.mark.filterwarnings(f"ignore::asperity.{name}") for name in ("results.ValidityWarning", "surface.MapWarning")]

PIXEL, SIGMA = 20e-9, 5e-9


@pytest.fixture(scope="module")
def plain() -> Array:
    """Of variance 1; the shortest waves have 12 points."""
    return GaussianSurface(512, 12).map(3)


def table(height: Any, dx: float = 1.0, dy: float | None = None) -> AtScores:
    return surface.summits(height, dx, dy).at_scores


def test_a_gaussian_surface_has_its_height_and_slope_at_all_scores(plain: Array) -> None:
    found = surface.summits(plain, 1.0)
    heights, slopes, lay = found.at_scores
    np.testing.assert_allclose(heights, SCORES * found.iso.Sq, atol=0.12 * found.iso.Sq)
    np.testing.assert_allclose(slopes[2:-2], found.iso.Sdq, rtol=0.06)
    np.testing.assert_allclose(slopes, found.iso.Sdq, rtol=0.2)
    assert 1 <= lay < 1.06 and found.isotropy == pytest.approx(lay**-2)


@pytest.mark.parametrize("skewed", [lambda g: -np.exp(-0.8 * g), lambda g: np.exp(0.8 * g), lambda g: np.where(g > 0, 0.2 * g, g)])
def test_heights_that_are_a_function_of_gaussian_ones_have_its_values_and_its_slopes(skewed: Any, plain: Array) -> None:
    heights, slopes, lay = table(skewed(plain))
    gaussian = surface.summits(plain, 1.0)
    np.testing.assert_allclose(heights, skewed(np.array(gaussian.at_scores.heights)) - skewed(plain).mean(), atol=0.02 * np.ptp(heights))
    sides = [np.abs(skewed(SCORES + step) - skewed(SCORES)) / 0.01 for step in (-0.01, 0.01)]
    least = math.sqrt(0.02) * surface.summits(skewed(plain), 1.0).iso.Sdq
    expected = np.maximum(np.mean(sides, axis=0) * gaussian.iso.Sdq, least)
    smooth = np.abs(SCORES) > 0.6  # at the edge of a plateau the slope is anything between
    np.testing.assert_allclose(np.array(slopes)[smooth][1:-1], expected[smooth][1:-1], rtol=0.15)
    assert lay < 1.06


def test_a_map_may_be_given_in_any_way(plain: Array) -> None:
    rough = np.exp(0.5 * plain[:300, :200])
    heights, slopes, lay = (np.array(one) for one in table(rough))

    def check(given: AtScores, by: float = 1.0, slope: float = 1.0) -> None:
        np.testing.assert_allclose(given.heights, by * heights, rtol=1e-4, atol=1e-4 * by)
        np.testing.assert_allclose(given.slopes, slope * slopes, rtol=1e-3)
        assert given.lay == pytest.approx(lay, rel=1e-3)

    check(table(1e-9 * rough, 1e-9), 1e-9)
    check(table(rough.T))
    check(table(rough[::-1, ::-1] + 7.0))
    check(table(2 * rough), 2, 2)
    check(table(rough, 2.0), 1, 0.5)
    check(table(rough.astype(np.float32)))
    check(table(np.round(1e5 * rough).astype(np.int32), 1e5), 1e5)
    check(table(np.ma.masked_array(rough, False)))
    check(table(surface.HeightMap(rough, 1.0, 1.0), dx=None))  # type: ignore[arg-type]
    worn = table(-rough)
    np.testing.assert_allclose(worn.heights, -heights[::-1], rtol=1e-9, atol=1e-9)
    np.testing.assert_allclose(worn.slopes, slopes[::-1], rtol=1e-6)
    with pytest.raises(ValueError, match="masked or not finite"):
        table(np.ma.masked_where(rough > rough.max() - 1e-9, rough))


@pytest.mark.parametrize("degrees", [0, 31, 90, 120])
def test_a_lay_is_found_in_any_direction_and_on_any_grid(degrees: float) -> None:
    random = np.random.default_rng(2)
    n, cos, sin = 256, math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    waves = np.meshgrid(*[2 * np.pi * np.fft.fftfreq(n)] * 2, indexing="ij")
    for dx, dy in ((1.0, 1.0), (1.0, 0.5)):
        ky, kx = waves[0] / dy, waves[1] / dx
        along, across = cos * kx + sin * ky, 3 * (cos * ky - sin * kx)
        height = np.fft.ifft2(np.fft.fft2(random.normal(size=(n, n))) * np.exp(-60 * (along**2 + across**2) / 9)).real
        found = table(height, dx, dy)
        assert found.lay == pytest.approx(3, rel=0.1)
        squares = np.square(np.diff(height, axis=1) / dx).mean() + np.square(np.diff(height, axis=0) / dy).mean()
        np.testing.assert_allclose(found.slopes[3:-3], math.sqrt(squares), rtol=0.2)


@pytest.mark.parametrize("noise", [0.05, 0.2])
def test_the_slope_of_noise_is_taken_away(noise: float, plain: Array) -> None:
    plateau = np.where(plain > 0, 0.1 * plain, plain)
    noisy = plateau + noise * plateau.std() * np.random.default_rng(0).normal(size=plain.shape)
    clean, spoilt = (surface.summits(surface.filter(one, 6.0, 1.0)).at_scores for one in (plateau, noisy))
    np.testing.assert_allclose(spoilt.slopes[:-1], clean.slopes[:-1], rtol=0.08)
    raw = sloped(surface.filter(noisy, 6.0, 1.0).height_map, 1.0, 1.0).at_scores
    assert noise < 0.1 or raw.slopes[-2] > 1.2 * clean.slopes[-2]


def test_levels_of_a_stepped_map_and_a_few_points_make_a_table_that_the_library_takes(plain: Array) -> None:
    for height in (np.round(plain / 0.5) * 0.5, np.round(plain), np.random.default_rng(0).normal(size=(16, 16))):
        found = table(height)
        assert (np.diff(found.heights) > 0).all() and min(found.slopes) > 0
        contact: dict[str, Any] = dict.fromkeys(("composite_modulus", "effective_shear_modulus", "adhesion_range", "burgers_vector"), 1.0)
        params = Params.from_topography(surface.summits(height, 1.0), work_of_adhesion=0.0, **contact)
        with Model(params) as model:
            assert 0 < model.state_at_load(1e-3 * params.nominal_area).real_area < params.nominal_area
    stepped, fine = table(np.round(plain / 0.25) * 0.25), table(plain)
    np.testing.assert_allclose(stepped.heights[1:-1], fine.heights[1:-1], atol=0.06)


def test_few_points_of_a_groove_have_the_longest_lay() -> None:
    groove = sloped(np.repeat(np.sin(np.arange(64.0))[:, None], 64, axis=1), 1.0, 1.0)
    assert groove.isotropy == 0 and groove.at_scores.lay == 20


def test_tiles_differ_as_maps_do() -> None:
    """The jackknife is what maps of one spectrum differ by, to a factor of two."""
    found, told = [], []
    for seed in range(10):
        parts = sloped(GaussianSurface(256, 8).map(seed), 1.0, 1.0)
        found.append(math.log(parts.at_scores.slopes[8]))
        without = np.log([one.slopes[8] for one in parts.without_each_tile()])
        told.append(math.sqrt(15 * np.var(without)))
    assert 0.5 < np.mean(told) / np.std(found, ddof=1) < 2


KINDS: dict[str, Any] = {
    # name: (map, what its verdict says)
    "spikes": (lambda z: with_spikes(z), "usable"),
    "missing": (lambda z: np.where(np.random.default_rng(0).random(z.shape) < 0.05, np.nan, z), "usable"),
    "steps": (lambda z: np.round(z / (SIGMA / 3)) * (SIGMA / 3), "usable"),
    "white noise": (lambda z: SIGMA * np.random.default_rng(0).normal(size=z.shape), "not usable because noise: .* has 100% of the mean square slope"),
    "16 x 16": (lambda z: z[:16, :16], "not usable because map: has . summits on 16 x 16 points"),
    "constant": (lambda z: 0 * z, "not usable because map: constant at 0.0: must be rough"),
    "a step": (lambda z: np.where(np.arange(256) < 100, 0, 50e-9) + 0 * z, "not usable because map: flat but for its form and the offsets of its lines"),
    "a wave": (lambda z: SIGMA * np.sin(np.arange(256) / 8) + 0 * z, "not usable because map: "),
}


def with_spikes(height: Array) -> Array:
    height = height.copy()
    height.ravel()[np.random.default_rng(0).choice(height.size, 30, replace=False)] += 20 * SIGMA
    return height


@pytest.mark.parametrize("kind", KINDS)
def test_a_map_has_the_right_table_or_a_clear_refusal(kind: str) -> None:
    import re

    spoil, says = KINDS[kind]
    plain = SIGMA * GaussianSurface(256, 12).map(3)
    found = surface.analyse(spoil(plain), 3e-3, PIXEL, pair="Si/Si", cutoff=6 * PIXEL if says == "usable" else None)
    assert re.match(says, found.verdict), found.verdict
    if says == "usable":
        assert found.summits is not None
        expected = surface.summits(surface.filter(plain, 6 * PIXEL, PIXEL)).at_scores
        np.testing.assert_allclose(found.summits.at_scores.heights, expected.heights, atol=0.05 * SIGMA)
        np.testing.assert_allclose(found.summits.at_scores.slopes, expected.slopes, rtol=0.06)


def test_the_text_of_a_map_is_read_again() -> None:
    found = surface.summits(SIGMA * np.exp(0.5 * GaussianSurface(256, 12).map(3)), PIXEL)
    contact = asperity.materials.PAIRS["Si/Si"].contact
    params = Params.from_topography(found, **contact)
    assert params.height_distribution == "at-scores" and params.table_height == pytest.approx(found.at_scores.heights)
    assert Params.from_text(params.to_text()) == params


def test_boundary_elements_press_the_map_itself(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(ValueError, match="check = 'fem': must be"):
        surface.analyse(np.ones((8, 8)), 1.0, 1.0, check="fem")  # type: ignore[arg-type]
    with monkeypatch.context() as patch:
        patch.setitem(sys.modules, "tamaas", None)
        with pytest.raises(ImportError, match="pip install tamaas"):
            surface.analyse(np.ones((8, 8)), 1.0, 1.0, check="boundary elements")
    pytest.importorskip("tamaas")
    from asperity.maps import boundary_elements

    gaussian = GaussianSurface(128, 8).map(1)
    for rough, dy in ((0.1 * gaussian, 1.0), (-0.1 * np.exp(-0.8 * gaussian), 1.0), (0.1 * np.exp(0.6 * gaussian), 0.5)):
        assert boundary_elements.ratio(surface.HeightMap(rough, 1.0, dy), 2e-3) == pytest.approx(1, abs=0.2)
