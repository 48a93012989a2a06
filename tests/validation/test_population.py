"""The law against boundary elements on the same surfaces: live at one load, the rest frozen."""

from __future__ import annotations

import math
from collections import defaultdict

import numpy as np
import pytest

import adhesion
import area_figure
import boundary_elements
from boundary_elements import PRESSURES, SLOPE, Row, falling

FROZEN = boundary_elements.frozen()
# Those that the constants of the library were not fitted to.
OTHERS = [row for row in FROZEN if not row.fitted]
# From 1 to 10 % of the nominal area in contact.
LOADS = PRESSURES[1:4]
# For speed: a bandwidth of 6.
LIVE = falling(256, 8, 64, 0.8, 1)


def test_a_surface_pressed_now_is_as_the_frozen_ones() -> None:
    """At 3.5 % of the nominal area."""
    (row,) = boundary_elements.compare(LIVE, 0, ratios=(1.5e-2,))
    answer = row.by_moments
    assert 4 < row.bandwidth < 8 and 0.03 < row.area < 0.04
    for ratio in (answer.area, answer.friction, answer.stiffness):
        assert ratio == pytest.approx(1, abs=0.12)
    assert answer.gap == pytest.approx(0, abs=0.12)


def test_four_points_for_the_shortest_wave_are_enough() -> None:
    """The same surface on a grid twice as fine: its waves between the points are known."""
    heights, _ = boundary_elements.surface(falling(128, 4, 32, 0.8, 1), 1)
    n = len(heights)
    waves = np.zeros((2 * n, 2 * n), complex)
    inner = slice(n // 2, n // 2 + n)
    waves[inner, inner] = np.fft.fftshift(np.fft.fft2(heights))
    # In the unit of the finer grid all lengths are twice as many, and so is the Burgers vector; friction goes with its power.
    fine = np.fft.ifft2(np.fft.ifftshift(waves)).real * 4 * 2
    load = (1.5e-2 * SLOPE,)
    (coarse_answer,), (fine_answer,) = (list(boundary_elements.press(one, load)) for one in (heights, fine))
    exponent = -math.log(1290 / 43) / math.log(8e4 / 28)
    area, friction, count, radius, gap, greater_gap = coarse_answer
    assert fine_answer[0] == pytest.approx(area, rel=0.03)
    assert fine_answer[1] / 2**exponent == pytest.approx(friction, rel=0.03)
    assert fine_answer[4] / 2 == pytest.approx(gap, rel=0.01)
    assert (fine_answer[4] - fine_answer[5]) / 2 == pytest.approx(gap - greater_gap, rel=0.05)


def test_the_frozen_rows_are_complete() -> None:
    expected = [
        (spectrum.grid, spectrum.lowest, spectrum.corner, spectrum.highest, spectrum.hurst, spectrum.bands, seed, pressure)
        for spectrum, seed in boundary_elements.surfaces()
        for pressure in PRESSURES
    ]
    found = [
        (row.grid, row.lowest, row.corner, row.highest, row.hurst, row.bands, row.seed, row.pressure) for row in FROZEN
    ]  # fmt: skip
    assert found == expected


def test_the_frozen_surfaces_are_those_of_the_script() -> None:
    """Moments of the first surface of each spectrum on 512 points, made anew."""
    for spectrum in boundary_elements.SPECTRA:
        if spectrum.grid == 512:
            heights, moments = boundary_elements.surface(spectrum, 0)
            key = (spectrum.lowest, spectrum.corner, spectrum.highest, spectrum.hurst, spectrum.bands)
            (row,) = [
                row for row in FROZEN
                if row.seed == 0 and row.pressure == PRESSURES[0] and row.grid == 512
                and (row.lowest, row.corner, row.highest, row.hurst, row.bands) == key
            ]  # fmt: skip
            assert (row.m0, row.m2, row.m4) == pytest.approx((moments.m0, moments.m2, moments.m4), rel=1e-6)
            assert heights.std() ** 2 == pytest.approx(row.m0, rel=1e-6)


def means(rows: list[Row], quantity: str) -> dict[tuple[str, float], float]:
    """Of the library over boundary elements, by kind of spectrum and load."""
    groups = defaultdict(list)
    for row in rows:
        groups[row.kind, row.pressure].append(getattr(row.by_moments, quantity))
    return {key: float(np.mean(values)) for key, values in groups.items()}
