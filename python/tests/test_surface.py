"""Summits of maps whose summits are known: Gaussian surfaces against theory, paraboloids against what was put in."""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from random_surfaces import GaussianSurface, Nayak

from asperity import Error, Params, surface

Array = npt.NDArray[np.float64]

QUANTITIES = ("density", "height_mean", "height_std", "skew", "kurtosis", "radius")
MATERIAL: dict[str, Any] = dict(
    E1=160e9, nu1=0.22, E2=160e9, nu2=0.22, work_of_adhesion=0.063, adhesion_range=0.384e-9, burgers_vector=0.384e-9
)


def paraboloids(heights: Array, radii: Array, pitch: int = 13) -> Array:
    """The highest of paraboloids on a square lattice: each is a summit, if heights differ little beside their falls."""
    rows, columns = heights.shape
    result = np.full((rows * pitch, columns * pitch), -np.inf)
    for row in range(rows):
        for column in range(columns):
            places = (row, rows), (column, columns)
            near = tuple(slice(max(0, i - 1) * pitch, min(n, i + 2) * pitch) for i, n in places)
            y, x = np.ogrid[near]
            square = (y - row * pitch - pitch // 2) ** 2 + (x - column * pitch - pitch // 2) ** 2
            result[near] = np.maximum(result[near], heights[row, column] - square / (2 * radii[row, column]))
    return result


# Of maps of a few bumps or grooves, and of such as count points along y in another unit.
unlike_a_surface = pytest.mark.filterwarnings("ignore::asperity.surface.MapWarning")


# ---- Gaussian surfaces ----


@pytest.fixture(scope="module")
def gaussian() -> GaussianSurface:
    return GaussianSurface(points=512, shortest=12)


@pytest.fixture(scope="module")
def found(gaussian: GaussianSurface) -> list[surface.Summits]:
    return [surface.summits(gaussian.map(seed), 1.0, 1.0, detrend=0) for seed in range(40)]


def test_summits_of_a_gaussian_surface_are_those_of_nayak(
    gaussian: GaussianSurface, found: list[surface.Summits]
) -> None:
    # At 12 points a wave the curvature that differences see is lower, by a known amount. Elongated summits have more than one point
    # that is higher than its neighbours, 0.7 % too many in all.
    theory, seen = Nayak(*gaussian.moments()), Nayak(1.0, *gaussian.moments_by_differences())
    mean, std, skew, kurtosis = theory.height_moments()
    expected = dict(zip(QUANTITIES, (theory.density, mean, std, skew, kurtosis, seen.radius)))
    systematic = {"skew": 0.1}
    for name, value in expected.items():
        values = np.array([getattr(summits, name).value for summits in found])
        sampling = values.std(ddof=1) / math.sqrt(values.size)
        assert abs(values.mean() - value) < 3 * sampling + systematic.get(name, 0.01) * value, name
        assert 3 * sampling < 0.25 * value, name  # so that the test means something


def test_standard_errors_are_those_of_the_spread_between_surfaces(found: list[surface.Summits]) -> None:
    for name in QUANTITIES:
        estimates = [getattr(summits, name) for summits in found]
        spread = np.std([one.value for one in estimates], ddof=1)
        stated = np.mean([one.error for one in estimates])
        assert 0.7 < spread / stated < 1.4, name  # 40 surfaces tell a spread to 11 %


def test_spectral_moments_are_those_that_differences_see(
    gaussian: GaussianSurface, found: list[surface.Summits]
) -> None:
    for name, expected in zip(("m0", "m2", "m4"), (1.0, *gaussian.moments_by_differences())):
        values = np.array([getattr(summits.moments, name) for summits in found]) / expected
        assert abs(values.mean() - 1) < 3 * values.std(ddof=1) / math.sqrt(values.size), name
    bandwidth = Nayak(*gaussian.moments()).bandwidth
    assert np.mean([summits.moments.bandwidth for summits in found]) == pytest.approx(bandwidth, rel=0.02)
    assert min(summits.isotropy for summits in found) > 0.85


def test_iso_names_are_the_same_numbers(gaussian: GaussianSurface, found: list[surface.Summits]) -> None:
    heights, summits = gaussian.map(0), found[0]
    heights = heights - heights.mean()
    iso = summits.iso
    assert iso.Sq == pytest.approx(heights.std(), rel=1e-12) == pytest.approx(math.sqrt(summits.moments.m0), rel=1e-12)
    assert iso.Ssk == pytest.approx((heights**3).mean() / heights.std() ** 3, rel=1e-10)
    assert iso.Sku == pytest.approx((heights**4).mean() / heights.std() ** 4, rel=1e-10)
    assert iso.Sdq == pytest.approx(math.sqrt(2 * summits.moments.m2), rel=1e-12)
    assert iso.Sds == summits.density.value == pytest.approx(summits.count / 510**2, rel=1e-12)
    assert iso.Ssc == pytest.approx(summits.curvatures.mean(), rel=1e-12)


# ---- Paraboloids ----


@pytest.fixture(scope="module")
def lattice() -> tuple[Array, Array]:
    """Heights and radii of summits."""
    random = np.random.default_rng(4)
    return 0.1 * random.normal(size=(30, 40)), random.uniform(4, 8, size=(30, 40))


def test_each_paraboloid_is_found_where_and_as_it_is(lattice: tuple[Array, Array]) -> None:
    heights, radii = lattice
    nm = 1e-9
    unequal = paraboloids(heights, radii)
    summits = surface.summits(nm * unequal, 3 * nm, 3 * nm, detrend=0)
    assert summits.count == heights.size
    order = np.lexsort((summits.x, summits.y))
    np.testing.assert_allclose(summits.heights[order], nm * (heights.ravel() - unequal.mean()), rtol=1e-9)
    np.testing.assert_allclose(summits.radii[order], 9 * nm * radii.ravel(), rtol=1e-9)
    np.testing.assert_allclose(summits.curvatures[order, 0], summits.curvatures[order, 1], rtol=1e-9)
    np.testing.assert_allclose(summits.x[order].reshape(30, 40)[7], 3 * nm * (13 * np.arange(40) + 6))
    np.testing.assert_allclose(summits.y[order].reshape(30, 40)[:, 7], 3 * nm * (13 * np.arange(30) + 6))
    assert summits.radius.value == pytest.approx(9 * nm / np.mean(1 / radii), rel=1e-9)
    assert summits.height_std.value == pytest.approx(nm * heights.std(ddof=1), rel=1e-9)
    assert summits.density.value == pytest.approx(1200 / (388 * 518 * 9 * nm**2), rel=1e-12)
    assert summits.nominal_area == pytest.approx(390 * 520 * 9 * nm**2, rel=1e-12)


@unlike_a_surface
def test_principal_curvatures_are_those_of_the_surface_in_any_direction() -> None:
    x, y = np.meshgrid(0.5 * np.arange(-30, 31), 0.8 * np.arange(-30, 31))
    for angle in np.linspace(0, np.pi, 7):
        along, across = x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)
        one = -(0.5 * along**2 + 0.2 * across**2)
        tiled = np.tile(one, (4, 5)) + 0.01 * np.kron(np.arange(20).reshape(4, 5), np.ones_like(one))
        summits = surface.summits(tiled, 0.5, 0.8, detrend=0)
        middle = np.isclose(summits.x % (61 * 0.5), 15) & np.isclose(summits.y % (61 * 0.8), 24)
        assert middle.sum() == 20
        np.testing.assert_allclose(summits.curvatures[middle], np.tile([1.0, 0.4], (20, 1)), rtol=1e-9)


def test_tilt_and_form_are_taken_away(lattice: tuple[Array, Array]) -> None:
    flat = paraboloids(*lattice)
    y, x = np.mgrid[-1:1:390j, -1:1:520j]
    plain = surface.summits(flat, 1.0, 1.0, detrend=2)
    formed = surface.summits(flat + 3 + 20 * x - 30 * y + 5 * x**2 - 4 * x * y + 7 * y**2, 1.0, 1.0, detrend=2)
    np.testing.assert_allclose(formed.heights, plain.heights, atol=1e-11)
    np.testing.assert_allclose(formed.curvatures, plain.curvatures, atol=1e-11)
    tilted = surface.summits(flat + 3 + 20 * x - 30 * y, 1.0, 1.0)
    np.testing.assert_allclose(tilted.heights, surface.summits(flat, 1.0, 1.0).heights, atol=1e-11)
    assert surface.summits(flat + 3 * x, 1.0, 1.0, detrend=0).height_std.value > 1.5


# ---- Plateaus and edges ----


def bumps() -> Array:
    """Sixteen summits, at 6, 19, 32 and 45 along each side of 52."""
    return np.maximum(paraboloids(np.linspace(0.05, 0.1, 16).reshape(4, 4), np.full((4, 4), 6.0)), -1.5)


@unlike_a_surface
def test_a_plateau_is_one_summit() -> None:
    height = bumps()
    for place in ((18, 19), (19, 19), (20, 19), (18, 20), (20, 20)):  # bent: a fork whose ends do not touch
        height[place] = 5.0
    summits = surface.summits(height, 1.0, 1.0, detrend=0)
    assert summits.count == 16
    top = np.argmax(summits.heights)
    assert summits.heights[top] == pytest.approx(5.0 - height.mean(), rel=1e-12)
    assert (summits.x[top], summits.y[top]) == pytest.approx((19.4, 19.0))
    assert summits.curvatures[top].sum() > 0


@unlike_a_surface
def test_terraces_and_plateaus_at_the_edge_are_no_summits() -> None:
    height = bumps()
    height[18:21, 15:19] = 0.05  # all around it is lower, but for the summit at its end
    height[0:3, 30:34] = 5.0
    assert height[19, 19] > 0.05
    assert surface.summits(height, 1.0, 1.0, detrend=0).count == 16


@unlike_a_surface
def test_levelling_makes_no_summits_of_the_corners_of_terraces() -> None:
    height = bumps()
    height[18:21, 15:19] = 0.05
    height[:, 26:] = np.maximum(height[:, 26:], -1.0)  # so that the mean plane is tilted
    tilt = 0.01 * np.arange(52.0)
    # What a tilted sample and an instrument of coarse steps give: steps are flat, the surface is not.
    assert surface.summits(height - tilt, 1.0, 1.0, detrend=0).count > 16
    assert surface.summits(height, 1.0, 1.0, detrend=1).count == 16
    assert abs(np.polyfit(np.arange(52), height.mean(axis=0), 1)[0]) > 5e-3


@unlike_a_surface
def test_the_edge_has_no_summits() -> None:
    height = bumps()
    height[0, 25] = height[25, -1] = height[-1, -1] = 5.0
    assert surface.summits(height, 1.0, 1.0, detrend=0).count == 16


def test_a_quantised_map_has_the_summits_of_the_map(gaussian: GaussianSurface, found: list[surface.Summits]) -> None:
    quantised = surface.summits(np.round(gaussian.map(0) / 0.005).astype(np.int32), 1.0, 1.0)
    assert quantised.count == pytest.approx(found[0].count, rel=0.02)
    assert 0.005 * quantised.height_std.value == pytest.approx(found[0].height_std.value, rel=0.01)
    assert quantised.radius.value / 0.005 == pytest.approx(found[0].radius.value, rel=0.02)


# ---- What a map may be ----


def good() -> Array:
    return GaussianSurface(64, 8).map(0)


def with_bad(value: float) -> Array:
    height = good()
    height[3, 17] = height[40, 2] = value
    return height


@pytest.mark.parametrize(
    "height, dx, dy, message",
    [
        (with_bad(math.nan), 1, 1, r"2 of 4096 heights are masked or not finite, the first is nan at \[3, 17\]: all must"),
        (with_bad(-math.inf), 1, 1, r"the first is -inf at \[3, 17\]"),
        (np.ma.masked_greater(good(), 2.0), 1, 1, r"heights are masked or not finite, .*: all must be known; surface.clean fills them"),
        (np.zeros(100), 1, 1, r"has shape \(100,\): must be 2-D"),
        (np.zeros((4, 4, 4)), 1, 1, r"has shape \(4, 4, 4\): must be 2-D"),
        (np.zeros((2, 400)), 1, 1, r"has shape \(2, 400\): must be 2-D, with at least 3 rows and 3 columns"),
        (np.zeros((0, 0)), 1, 1, r"has shape \(0, 0\)"),
        (np.full((64, 64), 7.0), 1, 1, "constant at 7.0: must be rough"),
        (np.add.outer(np.arange(64.0), 0.3 * np.arange(64.0)), 1, 1, "flat but for rounding: must be rough"),
        (GaussianSurface(64, 40).map(0), 1, 1, r"has \d summits on 64 x 64 points: must have at least 10"),
        (np.pad(np.ones((1, 1)), 3), 1, 1, "has 1 summits on 7 x 7 points: must have at least 10"),
        (np.tile(np.pad(np.ones((1, 1)), 3), (5, 5)), 1, 1, "all summits have one height: heights must vary"),
        (good(), 0.0, 1, "dx = 0.0: must be finite and > 0"),
        (good(), -1, 1, "dx = -1.0: must be finite and > 0"),
        (good(), 1, math.nan, "dy = nan: must be finite and > 0"),
        (good(), 1, math.inf, "dy = inf: must be finite and > 0"),
        (good(), 1e-200, 1, "curvatures are out of the range of floating point"),
        (1e300 * good(), 1, 1, "out of the range of floating point"),
    ],
)
def test_what_a_map_may_not_be(height: Any, dx: float, dy: float, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        surface.summits(height, dx, dy, detrend=0 if "one height" in message else 1)


def test_a_degree_is_a_whole_number() -> None:
    for degree, kind, says in ((-1, Error, "from 0 to 8"), (9, Error, "from 0 to 8"), (True, TypeError, "a whole"), (0.5, TypeError, "a whole")):
        with pytest.raises(kind, match=f"detrend = {degree}: must be {says}"):
            surface.summits(good(), 1.0, 1.0, detrend=degree)  # type: ignore[arg-type]


def test_ten_summits_are_enough_and_a_map_is_not_changed() -> None:
    random = np.random.default_rng(0)
    height = paraboloids(0.1 * random.normal(size=(2, 5)), random.uniform(4, 8, size=(2, 5)))
    before = height.copy()
    summits = surface.summits(height, 1.0, 1.0, detrend=0)
    assert summits.count == 10 and np.array_equal(height, before)
    assert all(math.isfinite(getattr(summits, name).value) for name in QUANTITIES)
    with pytest.raises(ValueError, match="read-only"):
        summits.heights[0] = 0.0


def test_summits_that_all_are_in_one_tile_tell_no_errors() -> None:
    height = np.pad(np.random.default_rng(0).normal(5, 1, size=(12, 12)), ((0, 500), (0, 500)))
    summits = surface.summits(height, 1.0, 1.0, detrend=0)
    assert summits.count >= 10 and all(math.isnan(getattr(summits, name).error) for name in QUANTITIES[1:])


@unlike_a_surface
@pytest.mark.parametrize("power", [-100, -9, 9, 100])
def test_units_only_scale(power: int) -> None:
    unit, plain = 10.0**power, surface.summits(good(), 1.0, 2.0)
    summits = surface.summits(unit * good(), unit, 2 * unit)
    assert summits.radius.value == pytest.approx(unit * plain.radius.value, rel=1e-9)
    assert summits.density.error == pytest.approx(plain.density.error / unit**2, rel=1e-9)
    assert summits.kurtosis.value == pytest.approx(plain.kurtosis.value, rel=1e-9)
    assert summits.at_scores.slopes == pytest.approx(plain.at_scores.slopes, rel=1e-6)


def test_without_scipy_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scipy.special", None)
    with pytest.raises(ImportError, match=r"needs SciPy .*pip install scipy"):
        surface.summits(good(), 1.0, 1.0)


# ---- Parameters ----


def test_what_the_map_tells_cannot_be_given_too() -> None:
    measured = surface.summits(5e-9 * GaussianSurface(512, 12).map(3), 50e-9, 50e-9)
    for name in ("height_std", "asperity_count", "radius_amplitude", "skew"):
        given: dict[str, Any] = MATERIAL | {name: 1.0}
        with pytest.raises((TypeError, Error)):
            Params.from_topography(measured, **given)
    with pytest.raises(TypeError, match="summits = 5: must be what asperity.surface.summits returns"):
        Params.from_topography(5, **MATERIAL)  # type: ignore[arg-type]
