"""The pages say what the library computes: tables, and what they say of them."""

from __future__ import annotations

import pytest

import tables
from gallery import defaults, measured


@pytest.mark.parametrize("page, mark", tables.TABLES)
def test_tables_are_what_the_script_writes(page: str, mark: str) -> None:
    text = (tables.DOCS / page).read_text(encoding="utf-8")
    found = tables.block(mark, tables.TABLES[page, mark]())
    assert found in text, "run tests/validation/tables.py where the package is installed, and read what changed"


def test_predictions_fail_where_the_page_says_so() -> None:
    """Gold on mica is met, and what open inputs allow; rough gold, mica in air and oxide come out 5 times too high and more."""
    ratios = {row.name: row.ratio() for row in measured.MEASUREMENTS}
    for name in ("polysilicon, static", "Si₃N₄ on polysilicon, static"):
        assert ratios[name][0] < 1 < ratios[name][1]
    low, high = ratios["gold pillar on mica, AFM"]
    assert 0.9 < low < 1.1 and 2 < high < 2.5
    for name in ("rough gold tip on mica, AFM", "mica on mica in air, SFA", "Si₃N₄ tip on silicon, AFM"):
        assert ratios[name][0] > 5


def test_the_defaults_are_no_upper_estimate() -> None:
    (low, high), *_ = (row.ratio() for row in defaults.ROUGH)
    assert 1 / 15 < low < high < 1 / 6
