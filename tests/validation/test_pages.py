"""docs/when-to-use.md and docs/validation.md say what the library computes."""

from __future__ import annotations

import pytest

import tables
from asperity.figures import defaults, measured


@pytest.mark.parametrize("page, mark", tables.TABLES)
def test_tables_are_what_the_script_writes(page: str, mark: str) -> None:
    text = (tables.DOCS / page).read_text(encoding="utf-8")
    found = tables.block(mark, tables.TABLES[page, mark]())
    assert found in text, "run tests/validation/tables.py where the package is installed, and read what changed"


@pytest.mark.parametrize("row", measured.MEASUREMENTS, ids=lambda row: row.name)
def test_the_page_says_why_a_prediction_fits_or_fails(row: measured.Measurement) -> None:
    text = " ".join((tables.DOCS / "validation.md").read_text(encoding="utf-8").split())
    assert f"**{row.name}**: {row.reason}" in text


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
    """They are too low for steel and rock, and most for the roughest: in the model friction falls with roughness."""
    steel, ground, rough = (row.ratio() for row in defaults.ROUGH)
    assert 1 / 15 < steel[0] < steel[1] < 1 / 6
    assert rough[1] < 1 / 50 < 1 / 6 < ground[0] < ground[1] < 1 / 4


def test_how_wrong_the_default_is_has_one_answer() -> None:
    low, high = (f"{factor:.2g}" for factor in defaults.error())
    root = tables.DOCS.parent
    for place in ("README.md", "docs/site/index.md", "docs/c.md", "src/capi/validity.rs", "python/src/asperity/results.py"):
        text = " ".join((root / place).read_text(encoding="utf-8").replace("///", "").split())
        words = (f"{low} times too {less} or {high} times too {more}" for less, more in (("low", "high"), ("little", "much")))
        assert any(word in text for word in words), place
