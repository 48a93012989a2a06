"""The model calibrated at one load against measurements at others: bounds that it keeps, and that a wrong exponent does not."""

from __future__ import annotations

import numpy as np
import pytest

from asperity import Model
from gallery import calibrated
from gallery.calibrated import COMPARISONS, FILM_LOADS, Comparison
from asperity.materials import MATERIALS

BY_NAME = {one.name: one for one in COMPARISONS}
# The residuals lie within these, as docs/validation.md says.
BOUNDS = {
    "ball on a film of MoS₂": (-0.05, 0.0),
    "lubricated pair": (-0.1, -0.05),
    "heat through metal joints": (0.57, 0.69),
    "diamond tip on silicon oxide": (-0.38, -0.23),
    "antimony particles on graphite": (0.6, 0.66),
    "amorphous antimony particles on graphite": (-0.5, -0.46),
}


@pytest.mark.parametrize("one", COMPARISONS, ids=lambda one: one.name)
def test_residuals_are_within_the_stated_bounds(one: Comparison) -> None:
    least, most = BOUNDS[one.name]
    assert len(one.readings) == len(one.residuals())
    for low, high in one.residuals():
        assert least <= low <= high <= most


def test_all_comparisons_have_bounds() -> None:
    assert list(BOUNDS) == list(BY_NAME)


def test_a_prediction_that_agrees_is_within_the_errors_of_the_measurement_and_one_that_fails_is_not() -> None:
    """Within two standard errors; where a source states none, 10 % is a failure."""
    for one in COMPARISONS:
        held = []
        for reading, (low, high) in zip(one.readings, one.predicted()):
            error = max((reading.bounds[1] - reading.bounds[0]) / 2, 0.05 * reading.value)
            held.append(low >= reading.value - 2 * error and high <= reading.value + 2 * error)
        assert all(held) if one.agrees else not any(held), one.name


# ---- MoS2 ----


def test_the_film_is_predicted_as_a_closed_form_says() -> None:
    """One elastic contact of constant strength: mu falls as the cube root of the load."""
    at_lightest = calibrated.film_measured(FILM_LOADS[:1])[0][0]
    expected = at_lightest * (FILM_LOADS / FILM_LOADS[0]) ** (-1 / 3)
    assert calibrated.film_predicted(FILM_LOADS) == pytest.approx(expected, rel=1e-6)


def test_the_measured_film_has_the_exponent_that_its_authors_give() -> None:
    loads = np.geomspace(1, 50, 30)
    exponent = np.polyfit(np.log(loads), np.log(calibrated.film_measured(loads)[0]), 1)[0]
    assert round(float(exponent), 2) == -0.32
    pressures = calibrated.film_pressures(FILM_LOADS)
    with Model(calibrated.one_summit(MATERIALS["steel"], MATERIALS["steel"], 3.175e-3)) as model:
        found = [model.state_at_load(float(load)).mean_asperity_pressure / 1e6 for load in FILM_LOADS]
    assert pressures == pytest.approx(found, rel=1e-6)
    # The pressures of the source's measurements.
    assert 200 < pressures.min() and pressures.max() < 1550


@pytest.mark.parametrize("exponent", [-0.38, -0.28, 0.0])
def test_a_wrong_exponent_fails(exponent: float) -> None:
    """By the bounds above, as would a constant coefficient."""
    film = BY_NAME["ball on a film of MoS₂"]
    start = calibrated.film_measured(FILM_LOADS[:1])[0][0]
    wrong = start * FILM_LOADS[1:] ** exponent
    residuals = [value / reading.value - 1 for value, reading in zip(wrong, film.readings)]
    least, most = BOUNDS[film.name]
    assert not all(least <= residual <= most for residual in residuals)


# ---- The others ----


def test_one_ball_would_fail_in_place_of_many_contacts() -> None:
    (reading,) = BY_NAME["lubricated pair"].readings
    error = (reading.bounds[1] - reading.bounds[0]) / 2
    assert round(2 ** (-1 / 3), 2) == 0.79
    assert 5 < (reading.value - 2 ** (-1 / 3)) / error < 6
    assert round(100 * float(calibrated.oil_ratios().std(ddof=1))) == 18
    assert len(calibrated.OIL_TESTS) == 14 and len({oil for oil, *_ in calibrated.OIL_TESTS}) == 7


def test_particles_are_between_the_slip_radii_so_that_the_exponent_is_hurtado_and_kims() -> None:
    """ln F over ln A is (2 + M)/2 there, M = ln(1290/43)/ln(28/8e4)."""
    slope = -np.log(1290 / 43) / np.log(8e4 / 28)
    (low, high), *_ = BY_NAME["antimony particles on graphite"].predicted()
    assert (low, high) == pytest.approx((0.1 ** (1 + slope / 2),) * 2, rel=1e-4)
    radii = np.sqrt(np.array([31_000e-18, 310_000e-18]) / np.pi)
    assert 28 < radii.min() / 0.431e-9 and radii.max() / 0.246e-9 < 8e4
