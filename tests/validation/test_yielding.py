"""The law of summits that yield against boundary elements whose pressure is cut at the hardness: live at one load, the rest
frozen."""

from __future__ import annotations

import numpy as np
import pytest
import tamaas

import boundary_elements
import joints
import yielding
from boundary_elements import SLOPE, falling
from yielding import INDICES, PRESSURES, TOLERANCE, Field

FROZEN = yielding.frozen()
# A quarter of the area of the frozen surfaces, for speed.
SMALL = falling(256, 6.5, 16, -1.0, 1)
TINY = falling(128, 3.25, 8, -1.0, 1)


def solved(name: str, heights: Field, pressure: float, *hardness: float) -> Field:
    """Pressures by a solver of tamaas, on the square of side 1 that the saturated one needs."""
    tamaas.set_log_level(tamaas.LogLevel.error)
    n = len(heights)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [1.0] * 2, [n] * 2)
    model.E, model.nu = 1.0, 0.0
    solver = getattr(tamaas, name)(model, (heights - heights.max()) / n, 1e-9, *hardness)
    solver.max_iter = 60
    solver.solve(pressure)
    return np.array(model.traction)


def test_pressures_are_those_of_tamaas() -> None:
    """Of its elastic solver where the hardness is out of reach, and of its saturated one where most of the area flows."""
    heights, _ = boundary_elements.surface(TINY, 0)
    pressure = PRESSURES[1] * SLOPE
    for hardness, tamaas_says, tolerance in (
        (10.0, solved("PolonskyKeerRey", heights, pressure), 1e-5),
        (0.02, solved("KatoSaturated", heights, pressure, 0.02), 1e-3),
    ):
        ours, _ = yielding.press(heights, hardness, pressure)
        assert ours.mean() == pytest.approx(pressure, rel=1e-9) and ours.max() <= hardness
        assert np.abs(ours - tamaas_says).sum() < tolerance * ours.sum()


def test_what_the_hardness_does_not_allow_is_seen() -> None:
    """The measure of the fault that ends the search: large where pressures are cut but not borne elsewhere."""
    heights, _ = boundary_elements.surface(SMALL, 0)
    pressure, hardness = PRESSURES[1] * SLOPE, 0.04
    ours, _ = yielding.press(heights, hardness, pressure)
    elastic, _ = yielding.press(heights, 10.0, pressure)
    cut = np.minimum(elastic, hardness)
    cut *= pressure / cut.mean()
    modes = yielding.kernel(len(heights))

    def error(found: Field) -> float:
        gap = np.fft.irfft2(modes * np.fft.rfft2(found)) - heights
        return yielding.error(np.minimum(found, hardness), gap, hardness)

    assert error(ours) <= 2 * TOLERANCE
    assert error(cut) > 1e-3


def test_area_and_friction_are_those_of_saturated_boundary_elements_where_all_flows() -> None:
    """At a plasticity index of 8, where 5 % of the nominal area touch, and the elastic law has a third of the area."""
    (row,) = yielding.compare(SMALL, 0, 8.0, ratios=(PRESSURES[1],))
    assert 1.6 < row.bandwidth < 1.9 and 0.03 < row.area < 0.07 and row.saturated > 0.85
    assert row.by_moments.area == pytest.approx(1, abs=0.1)
    assert row.by_moments.friction == pytest.approx(1, abs=0.15)
    assert row.by_elastic.area < 0.4


def test_the_frozen_rows_are_complete() -> None:
    expected = [
        (spectrum.grid, spectrum.lowest, spectrum.highest, spectrum.hurst, seed, index, pressure)
        for spectrum in yielding.SPECTRA
        for seed in range(spectrum.seeds)
        for index in INDICES
        for pressure in PRESSURES
    ]
    found = [
        (row.grid, row.lowest, row.highest, row.hurst, row.seed, row.index, row.pressure) for row in FROZEN
    ]  # fmt: skip
    assert found == expected


def test_a_frozen_row_is_what_the_script_computes() -> None:
    frozen = next(row for row in FROZEN if row.index == 8 and row.pressure == PRESSURES[1])
    (row,) = yielding.compare(yielding.SPECTRA[0], 0, 8.0, ratios=(PRESSURES[1],))
    assert (row.area, row.friction) == pytest.approx((frozen.area, frozen.friction), rel=1e-4)


def mean(narrow: bool, index: float, pressure: float, quantity: str, law: str) -> float:
    """Over the surfaces: the law over the boundary elements."""
    found = [row for row in FROZEN if (row.bandwidth < 3) == narrow and (row.index, row.pressure) == (index, pressure)]
    assert len(found) == 4
    return float(np.mean([getattr(getattr(row, law), quantity) for row in found]))


@pytest.mark.parametrize("pressure", PRESSURES)
@pytest.mark.parametrize("narrow", [True, False])
def test_area_is_load_over_hardness_where_all_flows(narrow: bool, pressure: float) -> None:
    """By both. At large areas friction is higher by the law, since patches that merge are larger, and weaker."""
    rows = [row for row in FROZEN if row.index == 8 and row.pressure == pressure]
    assert all(1 <= row.area_at_the_hardness < 1.03 for row in rows)
    assert mean(narrow, 8, pressure, "area", "by_moments") == pytest.approx(1, abs=0.06)
    assert 0.95 < mean(narrow, 8, pressure, "friction", "by_moments") < 1.12
    assert mean(narrow, 8, pressure, "area", "by_elastic") < 0.4


@pytest.mark.parametrize("pressure", PRESSURES)
@pytest.mark.parametrize("narrow", [True, False])
def test_summits_of_little_plasticity_are_elastic_by_both(narrow: bool, pressure: float) -> None:
    for quantity in ("area", "friction"):
        yielding_law = mean(narrow, 0.5, pressure, quantity, "by_moments")
        assert yielding_law == pytest.approx(mean(narrow, 0.5, pressure, quantity, "by_elastic"), rel=0.02)


@pytest.mark.parametrize("pressure", PRESSURES)
@pytest.mark.parametrize("narrow", [True, False])
def test_between_the_law_yields_before_pressures_are_cut(narrow: bool, pressure: float) -> None:
    """So that it and the elastic law have the boundary elements between them at a plasticity index of 2."""
    assert mean(narrow, 2, pressure, "area", "by_elastic") < 0.96
    assert 1 < mean(narrow, 2, pressure, "area", "by_moments") < 1.35
    assert 1 < mean(narrow, 2, pressure, "friction", "by_moments") < 1.4


def test_stiffness_is_that_of_boundary_elements_in_loading_and_unloading() -> None:
    """At plasticity indices of 1.5 to 6, where 1 to 18 % of the nominal area touch."""
    rows = joints.frozen()
    assert len(rows) == len(yielding.SPECTRA) * joints.SEEDS * len(joints.INDICES) * len(joints.PRESSURES)
    loading, unloading = (np.array([getattr(row, name) for row in rows]) for name in ("of_loading", "of_unloading"))
    assert np.all((loading > 0.8) & (loading < 1.08)) and loading.mean() == pytest.approx(0.9, abs=0.01)
    assert np.all((unloading > 1.05) & (unloading < 1.51)) and unloading.mean() == pytest.approx(1.25, abs=0.01)


def test_a_frozen_row_of_joints_is_what_the_script_computes() -> None:
    (row,) = joints.compare(yielding.SPECTRA[0], 0, joints.INDICES[2], joints.PRESSURES[:1])
    frozen = next(one for one in joints.frozen() if one.index == row.index and one.pressure == row.pressure)
    found, expected = ((one.stiffness, one.unloading, one.left_area, one.left_gap) for one in (row, frozen))
    assert found == pytest.approx(expected, rel=1e-3)


def test_unloading_moves_the_planes_as_boundary_elements_do_and_loses_more_area() -> None:
    """At 0.4 of the largest load."""
    area, gap = np.array([row.at_part_of_load() for row in joints.frozen()]).T
    left = np.array([row.left_area for row in joints.frozen()])
    assert np.all((area > 0.46) & (area < 0.53) & (area < left)) and np.all((left > 0.49) & (left < 0.78))
    assert np.all((gap > 0.69) & (gap < 1.13)) and gap.mean() == pytest.approx(0.9, abs=0.05)
