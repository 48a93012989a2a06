"""Measured maps made ready: levelling, spikes, missing points, the filter, friction against its cutoff, and warnings."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from random_surfaces import GaussianSurface

from asperity import Model, Params, Warnings, surface
from asperity.maps import instrument_files
from asperity.maps.cleaning import _membrane
from asperity.maps.spikes import spikes

Array = npt.NDArray[np.float64]

PIXEL, SIGMA = 20e-9, 5e-9
MATERIAL: dict[str, Any] = dict(
    E1=160e9, nu1=0.22, E2=160e9, nu2=0.22, work_of_adhesion=0.063, adhesion_range=0.384e-9, burgers_vector=0.384e-9
)


@pytest.fixture(scope="module")
def plain() -> Array:
    """A surface whose shortest waves have 12 points."""
    return SIGMA * GaussianSurface(256, 12).map(3)


@pytest.fixture(scope="module")
def self_affine() -> Array:
    """Of Hurst exponent 0.8, down to two points a wave."""
    return 50e-9 * GaussianSurface(256, 2, 0.02, 3.6).map(3)


def spiked(height: Array, count: int = 30) -> tuple[Array, npt.NDArray[np.bool_]]:
    """With spikes up and down, 20 times as high as the surface is rough."""
    random = np.random.default_rng(0)
    where = np.zeros(height.shape, dtype=bool)
    where.ravel()[random.choice(height.size, count, replace=False)] = True
    return height + np.where(where, random.choice([-1, 1], height.shape) * 20 * height.std(), 0.0), where


def friction(summits: surface.Summits) -> float:
    with Model(Params.from_topography(summits, nominal_area=1e-8, **MATERIAL)) as model:
        return model.friction_at_load(1e-3)


# ---- clean ----


def test_spikes_are_replaced_and_friction_is_that_of_the_surface(plain: Array) -> None:
    bad, where = spiked(plain)
    with pytest.warns(surface.MapWarning, match=r"points \(.* of all\) stand out .*: call surface.clean, which replaces them"):
        spoilt = surface.summits(bad, PIXEL)
    cleaned = surface.clean(bad, PIXEL)
    assert (cleaned.missing, cleaned.spikes) == (0, 30) and np.array_equal(cleaned.filled, where)
    expected = friction(surface.summits(plain, PIXEL))
    assert friction(surface.summits(cleaned.map)) == pytest.approx(expected, rel=0.01)
    assert friction(spoilt) < 0.5 * expected
    assert str(cleaned) == "256 x 256 points, 0 missing and 30 spikes filled, 0.00046 of all"


@pytest.mark.parametrize("fall, shortest", [(0.0, 12), (0.0, 4), (3.6, 2), (3.6, 8), (2.4, 2)])
def test_surfaces_without_spikes_have_none(fall: float, shortest: float) -> None:
    assert not any(spikes(GaussianSurface(256, shortest, 0.02 if fall else 0.0, fall).map(seed)).any() for seed in range(3))


def test_grooves_are_no_spikes() -> None:
    assert not spikes(np.sin(np.arange(256) / 8)[:, None] + 0.01 * GaussianSurface(256, 12).map(0)).any()


def test_missing_points_are_filled_like_a_membrane_and_make_no_summits(plain: Array) -> None:
    y, x = np.mgrid[0:256, 0:256]
    holes = plain + 3e-9 * x - 2e-9 * y + 7.0
    holes[100:110, 50:90], holes[0, 0:20], holes[200, 200] = np.nan, np.inf, np.nan
    cleaned = surface.clean(holes, PIXEL)
    assert cleaned.missing == 421 and cleaned.spikes == 0
    height = cleaned.map.height_map
    inner = height[101:109, 51:89]
    around = (height[100:108, 51:89] + height[102:110, 51:89] + height[101:109, 50:88] + height[101:109, 52:90]) / 4
    np.testing.assert_allclose(inner, around, atol=1e-6 * SIGMA)
    # Points of an edge have three neighbours, that of a corner two.
    edge, around = height[0, 1:20], (height[0, :19] + height[0, 2:21] + height[1, 1:20]) / 3
    np.testing.assert_allclose(edge, around, atol=1e-6 * SIGMA)
    assert height[0, 0] == pytest.approx((height[0, 1] + height[1, 0]) / 2, abs=1e-6 * SIGMA)
    # The plane is that of the known points.
    known = ~cleaned.filled
    planes = np.stack([np.ones(known.sum()), x[known], y[known]])
    np.testing.assert_allclose(planes @ height[known], 0, atol=1e-6)
    found, whole = surface.summits(cleaned.map), surface.summits(plain, PIXEL)
    assert whole.count - 5 <= found.count <= whole.count
    masked = np.ma.masked_invalid(holes)
    assert np.array_equal(surface.clean(masked, PIXEL).map.height_map, height)


def test_a_map_of_which_much_is_filled_is_warned_of(plain: Array) -> None:
    holes = plain.copy()
    holes[:, :100] = np.nan
    with pytest.warns(surface.MapWarning, match="39% of the map is filled: holes have no summits, so the density is low"):
        cleaned = surface.clean(holes, PIXEL)
    found, whole = surface.summits(cleaned.map), surface.summits(plain, PIXEL)
    assert found.density.value == pytest.approx(0.61 * whole.density.value, rel=0.15)


def test_single_points_that_are_filled_make_summits_which_a_filter_takes_away(plain: Array) -> None:
    scattered = np.where(np.random.default_rng(0).random(plain.shape) < 0.2, np.nan, plain)
    with pytest.warns(surface.MapWarning, match="20% of the map is filled: single points .* the density may be high by as much; filter"):
        cleaned = surface.clean(scattered, PIXEL)
    whole = surface.summits(plain, PIXEL)
    assert 1.05 < surface.summits(cleaned).density.value / whole.density.value < 1.2
    found, expected = (surface.summits(surface.filter(one, 6 * PIXEL)) for one in (cleaned, surface.HeightMap(plain, PIXEL, PIXEL)))
    assert found.density.value == pytest.approx(expected.density.value, rel=0.03)
    assert found.rms_slope.value == pytest.approx(expected.rms_slope.value, rel=0.02)


def test_spikes_are_looked_for_until_there_are_none_and_may_be_left(plain: Array) -> None:
    bad, where = spiked(plain, 300)
    once = surface.clean(bad, PIXEL)
    twice = surface.clean(once.map)
    assert once.spikes == where.sum() and twice.spikes == 0
    np.testing.assert_allclose(twice.map.height_map, once.map.height_map, atol=1e-2 * SIGMA)
    left = surface.clean(bad, PIXEL, spikes=False)
    assert left.spikes == 0 and np.ptp(left.map.height_map) > 30 * SIGMA


@pytest.mark.filterwarnings("ignore::asperity.surface.MapWarning")
def test_a_map_in_steps_keeps_its_plateaus_and_is_said_to_be_in_steps(plain: Array) -> None:
    """Steps merge some summits of the surface; levelling must make none of the corners of plateaus."""
    step = 0.1 * SIGMA
    counts = np.round((plain + 1e-3 * SIGMA * np.arange(256)) / step)
    before, whole = surface.summits(counts * step, PIXEL), surface.summits(plain, PIXEL)
    assert any("heights are in steps of 5e-10, 16% of neighbouring points have one height" in one for one in before.warnings)
    cleaned = surface.clean(counts * step, PIXEL)
    assert cleaned.steps is not None and cleaned.steps.step == pytest.approx(step, rel=1e-9)
    assert "heights in steps of 5e-10" in str(cleaned)
    after, again = surface.summits(cleaned), surface.summits(surface.clean(cleaned))
    assert after.count == again.count == pytest.approx(before.count, abs=1) and after.count == pytest.approx(whole.count, rel=0.15)
    assert any("in steps" in one for one in after.warnings)
    filtered, expected = (surface.filter(one, 6 * PIXEL) for one in (cleaned, surface.HeightMap(plain, PIXEL, PIXEL)))
    assert surface.summits(filtered).iso.Sdq == pytest.approx(surface.summits(expected).iso.Sdq, rel=0.01)
    assert surface.summits(plain, PIXEL).warnings == () and surface.clean(plain, PIXEL).steps is None
    lines = np.round(np.random.default_rng(0).normal(size=(256, 1)) * 20)
    aligned = surface.clean((counts + lines).astype(np.int16) * step, PIXEL, rows=True)
    assert surface.summits(aligned).count == pytest.approx(whole.count, rel=0.2)


@pytest.mark.parametrize("transposed", [False, True])
def test_lines_of_a_scan_are_aligned(plain: Array, transposed: bool) -> None:
    offset = 0.5 * SIGMA * np.random.default_rng(0).normal(size=(256, 1))
    raw = plain + offset
    aligned = surface.clean(raw.T if transposed else raw, PIXEL, rows=True)
    found, whole = surface.summits(aligned), surface.summits(plain, PIXEL)
    assert found.radius.value == pytest.approx(whole.radius.value, rel=0.03)
    assert found.rms_slope.value == pytest.approx(whole.rms_slope.value, rel=0.02)
    assert aligned.offsets == pytest.approx(offset.std(), rel=0.1) and "lines aligned" in str(aligned)
    assert surface.clean(plain, PIXEL, rows=True).offsets == 0
    grooves = plain + 10 * SIGMA * np.sin(np.arange(256) / 2)[:, None]
    assert surface.clean(grooves, PIXEL, rows=True).offsets == 0


def test_particles_are_replaced_where_asked(plain: Array) -> None:
    y, x = np.mgrid[:256, :256]
    dusty = plain.copy()
    for place in range(5):
        far = np.hypot(x - 40 * place - 30, y - 30 * place - 40) / 5
        dusty += np.where(far < 1, 20 * SIGMA * np.sqrt(np.maximum(1 - far**2, 0)), 0)
    assert surface.clean(dusty, PIXEL).particles == 0
    cleaned = surface.clean(dusty, PIXEL, dust=True)
    assert cleaned.particles == 5 and "5 particles filled" in str(cleaned)
    found, whole = surface.summits(cleaned), surface.summits(plain, PIXEL)
    assert found.rms_slope.value == pytest.approx(whole.rms_slope.value, rel=0.03)
    assert surface.clean(plain, PIXEL, dust=True).particles == 0


def test_what_clean_returns_is_taken_as_a_map(plain: Array) -> None:
    cleaned = surface.clean(plain, PIXEL)
    assert surface.summits(cleaned).radius == surface.summits(cleaned.map).radius


def test_what_cannot_be_cleaned_is_refused(plain: Array) -> None:
    missing = np.where(np.random.default_rng(0).random(plain.shape) < 0.6, np.nan, plain)
    with pytest.raises(ValueError, match="of 65536 heights are missing: at most half may be; crop the map"):
        surface.clean(missing, PIXEL)
    bad, _ = spiked(plain, 1000)
    with pytest.raises(ValueError, match="too many for spikes"):
        surface.clean(bad, PIXEL)
    with pytest.raises(ValueError, match="height_map: without a known height: must be rough"):
        surface.clean(np.full((9, 9), np.nan), 1.0)


# ---- filter ----


def test_half_of_a_wave_as_long_as_the_cutoff_passes() -> None:
    x = np.arange(400)
    for length, cutoff in ((40, 40), (80, 40), (20, 40)):
        wave = np.tile(np.cos(2 * np.pi * (x - 199.5) / length), (400, 1))
        filtered = surface.filter(wave, cutoff, 1.0)
        middle = np.s_[150:250, 160:240]
        expected = math.exp(-math.log(2) * (cutoff / length) ** 2)
        assert expected == pytest.approx({40: 0.5, 80: 0.5**0.25, 20: 0.5**4}[length])
        np.testing.assert_allclose(filtered.height_map[middle], expected * wave[middle], atol=2e-3)


def test_distances_of_rows_and_columns_count_each_for_itself(plain: Array) -> None:
    one = surface.filter(plain, 6 * PIXEL, PIXEL, 2 * PIXEL).height_map
    other = surface.filter(plain.T, 6 * PIXEL, 2 * PIXEL, PIXEL).height_map
    np.testing.assert_allclose(one, other.T, atol=1e-9 * SIGMA)


@pytest.mark.parametrize("cutoff", [1.9, 257.0, 0.0, math.nan])
def test_cutoffs_that_a_map_does_not_have_are_refused(plain: Array, cutoff: float) -> None:
    with pytest.raises(ValueError, match="cutoff = .*: must be (from two points, 2, to the side of the map, 256|finite)"):
        surface.filter(plain, cutoff, 1.0)


# ---- Warnings ----


def test_noise_is_warned_of_and_its_size_is_told(plain: Array) -> None:
    noisy = plain + 0.4e-9 * np.random.default_rng(0).standard_normal(plain.shape)
    with pytest.warns(surface.MapWarning, match="noise of 4.[0-3]e-10") as caught:
        found = surface.summits(noisy, PIXEL)
    assert len(caught) == 1 and len(found.warnings) == 1
    assert surface.summits(surface.filter(noisy, 8 * PIXEL, PIXEL)).warnings == ()
    with pytest.warns(surface.MapWarning, match="noise"):
        surface.summits(np.random.default_rng(0).standard_normal((128, 128)), 1.0)


def test_no_warning_where_none_is_due(plain: Array, self_affine: Array) -> None:
    assert surface.summits(plain, PIXEL).warnings == surface.summits(self_affine, PIXEL).warnings == ()


def test_contacts_smaller_than_a_point_are_warned_of(plain: Array) -> None:
    found = surface.summits(plain, PIXEL)
    with Model(Params.from_topography(found, nominal_area=1e-8, **MATERIAL)) as model:
        light, heavy = (found.warnings_at(model.state_at_load(load)) for load in (1e-6, 1.0))
    assert heavy == ()
    assert len(light) == 1 and "is below the distance of the points, 2e-08" in light[0]


# ---- Friction against the cutoff ----


def test_the_recommended_cutoff_is_the_shortest_that_the_map_resolves(self_affine: Array, tmp_path: Path) -> None:
    rough = 0.1 * self_affine
    found = surface.cutoffs(rough, 1e-4, 5e-9, **MATERIAL)
    width, points = 2 * found.contact_radius / 5e-9, found.cutoff / 5e-9
    good = (width >= 4) & (points >= 6)
    for i, (reason, left) in enumerate(zip(found.reasons, found.summits)):
        assert bool(reason) == (not good[i] or left is None or left.count < 30 or left.moments.m0 < 0.5 * np.var(rough)), reason
    assert found.recommended is not None and found.recommended == found.cutoff[good][0] and not good.all()
    assert f"recommended: {found.recommended:.3g}, mu = " in str(found) and len(str(found).splitlines()) == points.size + 2
    at = int(np.nonzero(good)[0][0])
    again = surface.summits(surface.filter(rough, found.recommended, 5e-9))
    with Model(Params.from_topography(again, **MATERIAL)) as model:
        assert found.friction[at] == pytest.approx(model.friction_at_load(1e-4), rel=1e-9)
    assert found.count[at] == again.count and np.all(np.diff(found.count[found.count > 0]) < 0)
    low, high = found.spread
    assert low < found.friction[at] < high and f"({low:.4f} to {high:.4f} from half to twice it)" in str(found)
    above, below = found.plot(tmp_path / "cutoffs.svg").axes
    assert (tmp_path / "cutoffs.svg").read_text(encoding="utf-8").startswith("<?xml")
    assert above.lines[0].get_ydata() == pytest.approx(found.friction)
    assert below.lines[0].get_ydata() == pytest.approx(2 * found.contact_radius)
    legend = above.get_legend()
    assert legend is not None and any("recommended" in text.get_text() for text in legend.get_texts())


def test_where_no_cutoff_will_do_none_is_recommended(plain: Array) -> None:
    with pytest.warns(surface.MapWarning, match="no cutoff is recommended, the nearest is 1.2e-07: contacts under this load are .* points wide: measure a finer map"):
        found = surface.cutoffs(plain, 1e-4, PIXEL, nominal_area=1e-8, cutoff=[6 * PIXEL, 4 * PIXEL], **MATERIAL)
    assert found.recommended is None and found.cutoff.tolist() == [4 * PIXEL, 6 * PIXEL]
    # The surface has no waves that these take away.
    assert found.friction[1] == pytest.approx(found.friction[0], rel=0.08)
    with pytest.raises(ValueError, match="load = 0.0: must be finite and > 0"):
        surface.cutoffs(plain, 0.0, PIXEL, **MATERIAL)
    with pytest.raises(TypeError, match="nominal_aera"):
        surface.cutoffs(plain, 1.0, PIXEL, nominal_aera=1e-8, **MATERIAL)  # type: ignore[call-arg]
    with pytest.raises(ValueError, match=r"cutoff\[0\] = -1.0: must be finite and > 0"):
        surface.cutoffs(plain, 1.0, PIXEL, cutoff=[-1.0], **MATERIAL)
    with pytest.raises(ValueError, match=r"256 x 256 points, dx = 5e-09, dy = 0.0001: too small for the shortest cutoff"):
        surface.cutoffs(plain, 5e-9, 5e-9, 1e-4, **MATERIAL)  # the load in the place of dy


def test_cutoffs_that_fail_stay_with_the_reason(plain: Array) -> None:
    found = surface.cutoffs(plain, 3e-3, PIXEL, cutoff=PIXEL * np.array([1.0, 6.0, 8.0, 250.0]), **MATERIAL)
    assert found.recommended == pytest.approx(6 * PIXEL) and found.reasons[1] == ""
    assert found.reasons[0].startswith("cutoff = 2e-08: must be from two points") and "summits on 256 x 256" in found.reasons[3]
    assert np.isnan(found.friction[[0, 3]]).all() and found.summits[0] is None and found.params[3] is None
    assert "2e-08  1  cutoff = 2e-08: must be" in str(found)
    steep = surface.cutoffs(5 * plain, 2e-2, PIXEL, **MATERIAL)
    assert any("too steep" in reason for reason in steep.reasons)
    for at, params in enumerate(found.params):
        if params is not None and not found.reasons[at]:
            with Model(params) as model:
                assert not model.check(3e-3, 3e-3) & (Warnings.STEEP | Warnings.CROWDED | Warnings.PLASTIC | Warnings.BROAD)
    with pytest.raises(ValueError, match="E1"):
        surface.cutoffs(plain, 1e-2, PIXEL, **(MATERIAL | {"E1": -1.0}))


# ---- What a map may be given as ----


def test_maps_bring_their_distances(plain: Array) -> None:
    given = surface.HeightMap(plain, PIXEL, 1.2 * PIXEL)
    found, same = surface.summits(given), surface.summits(plain, PIXEL, 1.2 * PIXEL)
    assert found.radius == same.radius and (found.dx, found.dy) == (PIXEL, 1.2 * PIXEL)
    with pytest.raises(TypeError, match="dx, dy: must not be given with a map that has them"):
        surface.summits(given, PIXEL)
    with pytest.raises(TypeError, match="give dx, the distance of columns, and dy"):
        surface.summits(plain)


def test_topographies_of_surfacetopography_are_taken(plain: Array) -> None:
    library = instrument_files._library()  # without its warning that mpi4py is missing
    Topography = library.Topography
    micrometres = Topography(plain.T * 1e6, (256 * PIXEL * 1e6, 0.9 * 256 * PIXEL * 1e6), unit="µm")
    found, same = surface.summits(micrometres), surface.summits(plain, PIXEL, 0.9 * PIXEL)
    assert found.radius.value == pytest.approx(same.radius.value, rel=1e-9)
    assert surface.clean(micrometres).map.dy == pytest.approx(0.9 * PIXEL)
    unitless = Topography(plain.T, (256 * PIXEL, 0.9 * 256 * PIXEL))
    assert surface.summits(unitless).count == same.count
    holes = np.ma.masked_greater(plain.T, 2 * SIGMA)
    assert surface.clean(Topography(holes, (1.0, 1.0))).missing == holes.mask.sum() > 0
    with pytest.raises(ValueError, match="this topography is no map of heights over x and y"):
        surface.summits(library.UniformLineScan(plain[0], 1.0))


# ---- Progress ----


def test_progress_is_told(
    plain: Array, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)  # lines of text, where there are no bars
    for call in (surface.summits, surface.clean):
        told: list[tuple[float, str]] = []
        call(plain, PIXEL, progress=lambda part, doing: told.append((part, doing)))
        parts = [part for part, _ in told]
        assert parts == sorted(parts) and parts[0] == 0 and parts[-1] == 1 and len(parts) >= 4
    assert capsys.readouterr().err == ""
    surface.summits(plain, PIXEL, progress=True)
    assert "asperity.surface:   0% levelling 256 x 256 points\n" in capsys.readouterr().err
    surface.summits(plain, PIXEL)
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("place, mean", [((0, 0), 3 / 2), ((0, 2), (1 + 3 + 7) / 3), ((2, 4), (9 + 13) / 2), ((1, 2), (6 + 8 + 2 + 12) / 4)])
def test_a_missing_point_is_the_mean_of_the_neighbours_that_it_has(place: tuple[int, int], mean: float) -> None:
    """At an edge of the map they are three, at a corner two."""
    level = np.arange(15.0).reshape(3, 5)
    level[1, 0] = 2.0
    bad = np.zeros(level.shape, dtype=bool)
    bad[place] = True
    assert _membrane(level, bad) == pytest.approx([mean], rel=1e-12)


@pytest.mark.parametrize("number, centre", [(-9999.0, 0.0), (0.0, 300.0), (0.0, -1000.0), (1e30, 0.0), (0.0, 0.0), (0.0, 60.0)])
def test_many_heights_of_one_number_that_are_none_are_missing(number: float, centre: float) -> None:
    """Holes of ten points a side, and 3 % of the points."""
    from scipy.ndimage import gaussian_filter

    random = np.random.default_rng(3)
    right = gaussian_filter(random.normal(size=(128, 128)), 3, mode="wrap")
    right = centre + 50 * right / right.std()
    hole = np.zeros(right.shape, dtype=bool)
    hole[20:30, 40:50] = True
    for lost in (hole, random.random(right.shape) < 0.03):
        found = surface.clean(np.where(lost, number, right), 10.0)
        assert found.missing == lost.sum() and found.spikes == 0
        assert found.map.height_map.std() == pytest.approx(50, rel=0.02)
    with pytest.raises(ValueError, match="100 of 16384 heights are one number that stands for missing ones, the first is "):
        surface.summits(np.where(hole, number, right), 10.0)


def test_heights_of_one_number_that_are_of_the_surface_are_heights() -> None:
    """A map in steps, one that an instrument cut off at the top, two levels, lines set to their median, and zeros of a sine."""
    from scipy.ndimage import gaussian_filter

    heights = 50 * np.random.default_rng(3).normal(size=(64, 64))
    smooth = gaussian_filter(heights[:, :63], 2)
    sine = np.sin(np.arange(-20, 21) * math.pi / 10)
    for kept in (np.round(heights / 40), np.minimum(heights, 60.0), np.where(heights > 0, 0.0, 1.0),
                 smooth - np.median(smooth, axis=1, keepdims=True), np.outer(sine, sine) + np.outer(sine**2, sine)):
        assert surface.clean(kept, 10.0, spikes=False).missing == 0
