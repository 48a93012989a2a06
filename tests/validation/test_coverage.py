"""Bands called 95 % have the truth in 95 % of cases: the frozen thousand of each kind, and the cheap kinds anew, fewer times."""

from __future__ import annotations

import math

import coverage
import pytest
from coverage import Kind, Row

# 95 % of so many repeats, by three standard deviations and the 2 % that linear bands may be off.
SHORT = 200
ALLOWED = 0.02 + 3 * math.sqrt(0.05 * 0.95 / SHORT)
# A row of each function that is made in seconds.
CHEAP = [
    Kind("fit of slip_stress", "friction at another load", 2, "from the scatter"),
    Kind("fit of slip_stress", "friction at another load", 6, "known"),
    Kind("fit of slip_stress and pressure_coefficient", "friction at another load", 3, "from the scatter"),
    Kind("summits of a map", "Sq", 4),
    Kind("summits of a map", "Sdq", 4),
]


def test_the_frozen_kinds_are_those_of_today() -> None:
    known = [(kind.call, kind.what, kind.points, kind.errors) for kind, _ in coverage.kinds()]
    assert [(row.call, row.what, row.points, row.errors) for row in coverage.frozen()] == known


@pytest.mark.parametrize("row", coverage.frozen(), ids=lambda row: f"{row.call}, {row.what}, {row.points} {row.errors}")
def test_bands_have_the_truth_as_often_as_they_say(row: Row) -> None:
    """In 93 to 97 % of cases, but for what the page tells: a linear band of wide spreads, maps of one or two waves a side."""
    assert row.repeats == coverage.REPEATS
    is_linear = row.call == "uncertainty of spreads, linear"
    has_few_waves = row.call == "summits of a map" and row.points < 4
    # Of fewer bands than these nothing can be counted.
    if row.repeats - row.refused >= 100:
        assert (0.90 if is_linear else 0.92 if has_few_waves else 0.93) <= row.part <= 0.972


@pytest.mark.parametrize("kind", CHEAP, ids=lambda kind: f"{kind.call}, {kind.what}, {kind.points}")
def test_they_do_so_today(kind: Kind) -> None:
    (draw,) = (draw for one, draw in coverage.kinds() if one == kind)
    found = coverage.row(kind, draw, SHORT)
    assert abs(found.part - 0.95) <= ALLOWED, found
