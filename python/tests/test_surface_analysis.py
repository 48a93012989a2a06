"""One call from a map to a verdict: each fault on a map whose friction is known, and the clean map."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from random_surfaces import GaussianSurface

import asperity
from asperity import Error, Model, surface
from asperity.maps import analysis
from asperity.params import roughness_of

Array = npt.NDArray[np.float64]

# `asperity.friction`, to compare with, says that its strength is a default.
pytestmark = pytest.mark.filterwarnings("ignore::asperity.results.ValidityWarning")

POINTS, PIXEL, SIGMA, LOAD = 256, 20e-9, 5e-9, 3e-3
Y, X = np.mgrid[:POINTS, :POINTS]
ROUND = (X / POINTS - 0.5) ** 2 + (Y / POINTS - 0.5) ** 2


@pytest.fixture(scope="module")
def plain() -> Array:
    """A surface whose shortest waves have 12 points."""
    return SIGMA * GaussianSurface(POINTS, 12).map(3)


@pytest.fixture(scope="module")
def truth(plain: Array) -> surface.Analysis:
    return analysed(plain)


def analysed(height: Any, **given: Any) -> surface.Analysis:
    arguments: dict[str, Any] = {"load": LOAD, "dx": PIXEL, "pair": "Si/Si"} | given
    return surface.analyse(height, **arguments)


def random() -> np.random.Generator:
    return np.random.default_rng(0)


def with_points(height: Array, count: int) -> Array:
    height = height.copy()
    height.ravel()[random().choice(height.size, count, replace=False)] += 20 * SIGMA
    return height


def dusty(height: Array) -> Array:
    places = random().integers(20, POINTS - 20, (8, 2))
    for row, column in places:
        far = np.hypot(X - column, Y - row) / 5
        height = height + 30 * SIGMA * np.sqrt(np.maximum(1 - far**2, 0))
    return height


def test_a_clean_map_is_usable_and_gives_friction_and_its_surface(plain: Array, truth: surface.Analysis) -> None:
    assert truth.usable and truth.verdict == "usable" and truth.findings == ()
    found = surface.summits(surface.filter(plain, 6 * PIXEL, PIXEL))
    expected = asperity.friction("Si/Si", load=LOAD, nominal_area=found.nominal_area, **roughness_of(found))
    assert truth.value == float(truth) == pytest.approx(float(expected), rel=1e-9)
    assert truth.low < expected.low < expected.high < truth.high  # the map's own spread beside the strength's
    assert truth.params is not None and truth.cutoffs is not None and truth.cutoffs.recommended == pytest.approx(6 * PIXEL)
    assert truth.estimate is not None and truth.estimate.curve == pytest.approx(truth.value, rel=0.03)
    with Model(truth.params) as model:
        assert model.friction_at_load(LOAD) == pytest.approx(truth.estimate.curve, rel=1e-6)
    assert f"; Model(params) has {truth.estimate.curve:.3g}\n" in str(truth)
    assert truth.spread.keys() == truth.area_spread.keys() == {"sampling", "cutoffs"}
    assert truth.spread["cutoffs"] == pytest.approx(math.log(np.divide(*truth.cutoffs.spread[::-1])) / math.sqrt(12))
    text = str(truth)
    order = ["form", "spikes", "missing", "S-filter", "lay", "surface", "contact", "area", "friction", "verdict"]
    assert [line.split(":")[0] for line in text.splitlines()] == order
    assert "with the cutoff 1.2e-07 m" in text


def test_a_gaussian_map_has_the_friction_of_its_height_and_slope() -> None:
    random = GaussianSurface(512, 12)
    found = surface.summits(surface.filter(SIGMA * random.map(3), 6 * PIXEL, PIXEL))
    moments = dict(m0=found.moments.m0, m2=found.moments.m2)
    for load in (3e-4, 3e-2):
        table, gaussian = (
            asperity.friction("Si/Si", load=load, nominal_area=found.nominal_area, measured=(3e-3, 0.3), **rough)
            for rough in (roughness_of(found), moments)
        )
        assert float(table) == pytest.approx(float(gaussian), rel=0.06)


FAULTS: dict[str, Any] = {
    # name: (spoilt, kind, part of the remedy, what follows it, whether friction then is the truth to 5 %)
    "bow": (lambda z: z + 400e-9 * ROUND, "form", "give detrend=2", {"detrend": 2}),
    "polynomial": (lambda z: z + 3200e-9 * (X / POINTS - 0.5) ** 3, "form", "give detrend=3", {"detrend": 3}),
    "dust": (dusty, "dust", "give dust=True", {"dust": True}),
    "spikes": (lambda z: with_points(z, 30), "spikes", "give spikes=True", {"spikes": True}),
    "rows": (lambda z: z + 0.5 * SIGMA * random().normal(size=(POINTS, 1)), "rows", "give rows=True", {"rows": True}),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_named_with_the_remedy_that_fits_it(name: str, plain: Array, truth: surface.Analysis) -> None:
    spoil, kind, remedy, follows = FAULTS[name]
    left_alone = {"spikes": {"spikes": False}, "rows": {"rows": False}}.get(name, {})
    found = analysed(spoil(plain), **left_alone)
    assert found.findings[0].kind == kind and remedy in found.findings[0].remedy and not found.usable
    assert found.verdict.startswith(f"usable if {kind}: ") and remedy in found.verdict
    mended = analysed(spoil(plain), **follows)
    assert mended.value == pytest.approx(truth.value, rel=0.05) and mended.verdict == "usable"
    # Lines that are offset are noise, whose slope is taken away.
    assert name == "rows" or abs(math.log(found.value / truth.value)) > abs(math.log(mended.value / truth.value)) + 0.02


@pytest.mark.parametrize(
    "spoil",
    [
        lambda z: z + 1e-9 * X,
        lambda z: with_points(z, 30),
        lambda z: z + 0.5 * SIGMA * random().normal(size=(POINTS, 1)),
        lambda z: (z + 0.5 * SIGMA * random().normal(size=(POINTS, 1))).T,
        lambda z: np.where(random().random(z.shape) < 0.2, np.nan, z),
        lambda z: np.ma.masked_where(random().random(z.shape) < 0.01, z),
        lambda z: np.round(z / (0.2 * SIGMA)) * 0.2 * SIGMA,
        lambda z: z.astype(np.float32),
    ],
    ids=["tilt", "spikes", "rows", "transposed rows", "dropouts", "masked", "fine steps", "float32"],
)
def test_what_one_call_mends_leaves_friction_as_it_is(spoil: Any, plain: Array, truth: surface.Analysis) -> None:
    found = analysed(spoil(plain))
    assert found.value == pytest.approx(truth.value, rel=0.05) and found.verdict == "usable"


@pytest.mark.parametrize(
    "spoil, given, kind, says",
    [
        (lambda z: with_points(z, 3000), {}, "spikes", "3000 of 65536 points stand out"),
        (lambda z: np.where(X < 60, np.nan, z), {}, "missing", "23% of the points are missing, in holes: crop the map"),
        (lambda z: np.round(z / (1.5 * SIGMA)) * 1.5 * SIGMA, {}, "steps", "in steps of 7.5e-09 m, coarser than the surface: measure"),
        (lambda z: z + SIGMA * random().normal(size=z.shape), {}, "noise", r"of 5e-09 m, has \d+% of the mean square slope .*: give cutoff=1.6e-07"),
        (lambda z: 0.05 * z + 3 * SIGMA * np.sin(Y / 16), {}, "direction", r"lay \d.*: patches of contact are long, and friction up to 1.4 times too large"),
        (lambda z: SIGMA * GaussianSurface(POINTS, 60).map(3), {}, "waves", "mean waves a side: one place is not like another: measure a larger map"),
        (lambda z: z, {"load": 1e-6}, "cutoff", r"none is recommended, contacts under this load are .* points wide: measure a finer map, or take a heavier load"),
        (lambda z: z, {"load": 0.2}, "contact", "asperities yield"),
    ],
    ids=["many spikes", "holes", "steps", "noise", "grooves", "few waves", "light load", "heavy load"],
)
def test_what_only_another_measurement_mends_is_said(spoil: Any, given: dict[str, Any], kind: str, says: str, plain: Array) -> None:
    import re

    found = analysed(spoil(plain), **given)
    assert math.isfinite(found.value) and found.low < found.value < found.high
    saying = [str(one) for one in found.findings if one.kind == kind]
    assert saying and any(re.search(says, one) for one in saying), found.verdict
    assert found.verdict.startswith("usable if ")


def test_a_bandwidth_beyond_the_validation_is_said(plain: Array, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(analysis, "_BANDWIDTH", 1.9)
    found = analysed(plain)
    assert "bandwidth 2" in found.verdict and "where boundary elements reach 1.9: give longest=2.4e-06" in found.verdict


@pytest.mark.parametrize(
    "height, given, verdict",
    [
        (np.ones((64, 64)), {}, "not usable because map: constant at 1.0: must be rough"),
        (np.where(np.arange(4096).reshape(64, 64) % 3, np.nan, 1e-9 * np.arange(64)), {}, "not usable because map: .* are missing: at most half"),
        (1e-9 * np.arange(25.0).reshape(5, 5) ** 2, {}, "not usable because map: 5 x 5 points, .*too small for the shortest cutoff"),
        (1e-9 * np.random.default_rng(0).normal(size=(4, 60)), {}, "not usable because map: 4 x 60 points, .*too small"),
        (1e-9 * np.random.default_rng(0).normal(size=(4, 60)), {"detrend": 3}, "not usable because map: detrend = 3"),
        (np.ones((1, 400)), {}, r"not usable because map: has shape \(1, 400\): must be 2-D, with at least 3 rows"),
        (np.full((64, 64), np.nan), {}, "not usable because map: without a known height"),
        (5 * GaussianSurface(64, 8).map(0), {"dx": 20.0}, "not usable because units: the map is .* m long .*: give heights and distances in metres"),
        ((1e3 * GaussianSurface(64, 8).map(0)).astype(np.int16), {}, "not usable because units: heights range over .* m"),
    ],
    ids=["constant", "missing", "tiny", "few rows", "degree", "one row", "nothing", "nanometres", "counts"],
)
def test_a_map_that_is_none_is_not_usable(height: Array, given: dict[str, Any], verdict: str) -> None:
    import re

    found = analysed(height, **given)
    assert re.match(verdict, found.verdict) and math.isnan(found.value) and not found.usable
    assert "verdict: not usable" in str(found)


def test_distances_of_rows_and_columns_count_each_for_itself(plain: Array, truth: surface.Analysis) -> None:
    fine = 0.5 * SIGMA * GaussianSurface(512, 24).map(3)
    one = analysed(fine[:, ::2], dx=PIXEL, dy=PIXEL / 2, load=LOAD / 4)
    other = analysed(fine[:, ::2].T, dx=PIXEL / 2, dy=PIXEL, load=LOAD / 4)
    assert one.value == pytest.approx(other.value, rel=1e-6)
    given = analysed(surface.HeightMap(plain, PIXEL, PIXEL), dx=None)
    assert given.value == truth.value and analysed(surface.clean(plain, PIXEL), dx=None).value == pytest.approx(truth.value, rel=1e-6)


def test_friction_that_was_measured_narrows_the_band(plain: Array, truth: surface.Analysis) -> None:
    found = analysed(plain, measured=(LOAD, 0.3))
    assert found.value == pytest.approx(0.3, rel=1e-3) and found.high / found.low < 2 < truth.high / truth.low
    assert found.spread["cutoffs"] < 1e-3  # it was measured at this load
    steel = analysed(100 * plain, dx=30 * PIXEL, load=10.0, pair="steel/steel", measured=(10.0, 0.3))
    assert "contact: elastic-plastic" in str(steel) and steel.params is not None and steel.params.contact_law == "elastic-plastic"
    for params, load in ((found.params, LOAD), (steel.params, 10.0)):
        assert params is not None
        with Model(params) as model:
            assert model.friction_at_load(load) == pytest.approx(0.3, rel=1e-6)  # calibrated too


@pytest.mark.parametrize("interface", ["steel/steel dry", "MoS2 film in dry air"])
def test_an_interface_of_the_table_is_that_of_its_surface_too(plain: Array, interface: str) -> None:
    """Also one of which the table has a friction coefficient alone."""
    found = analysed(100 * plain, dx=30 * PIXEL, load=10.0, pair="steel/steel", interface=interface)
    assert found.estimate is not None and found.estimate.strength == "table" and found.params == found.estimate.params
    with Model(found.params) as model:
        assert model.friction_at_load(10.0) == pytest.approx(found.estimate.curve, rel=1e-6)


def test_long_waves_are_removed_and_what_is_asked_for_wrongly_is_refused(plain: Array, truth: surface.Analysis) -> None:
    wavy = plain + 3 * SIGMA * np.cos(2 * np.pi * 2.5 * X / POINTS) * np.cos(2 * np.pi * 2.5 * Y / POINTS)
    found = analysed(wavy, longest=1e-6)
    assert found.value == pytest.approx(truth.value, rel=0.05) and "L-filter: waves longer than 1e-06 m removed" in str(found)
    for given, says in (({"load": 0.0}, "load"), ({"coverage": 95}, "coverage"), ({"detrend": 9}, "detrend")):
        with pytest.raises(ValueError, match=says):
            analysed(plain, **given)
    with pytest.raises(Error, match="pair"):
        analysed(plain, pair="steal/steel")
    with pytest.raises(TypeError, match="give dx, the distance of columns"):
        analysed(plain, dx=None)
    with pytest.raises(TypeError, match="give cutoff, the shortest wave"):
        surface.filter(plain, dx=PIXEL)
