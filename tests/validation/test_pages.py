"""The pages say what the library computes, and the same everywhere: tables, and numbers that several places repeat."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Iterator

import pytest

import tables
from gallery import defaults, measured

ROOT = tables.DOCS.parent


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


# ---- One number for one claim ----


def said(pattern: str) -> Iterator[tuple[str, tuple[str, ...]]]:
    """What the groups of a pattern are, wherever it stands: pages, header, sources' comments and docstrings; powers as 1e-8."""
    folders = ("docs/*.md", "docs/*/*.md", "*.md", "python/*.md", "js/*.md", "hosts/*/*.md", "include/*.h*", "src/**/*.rs", "python/src/**/*.py",
               "js/src/*.js", "fortran/*.f90")  # fmt: skip
    powers = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
    for file in (file for folder in folders for file in ROOT.glob(folder) if file.name != "CHANGELOG.md"):
        text = re.sub(r"10(⁻[⁰¹²³⁴⁵⁶⁷⁸⁹]+)", lambda power: "1e" + power[1].translate(powers), file.read_text(encoding="utf-8"))
        text = re.sub(r"\s+(?:(?:///|//!|\*|!)\s|\\\s)?\s*", " ", text)
        yield from ((str(file.relative_to(ROOT)), found.groups()) for found in re.finditer(pattern, text))


def constant(file: str, pattern: str) -> str:
    (found,) = set(re.findall(pattern, Path(ROOT / file).read_text(encoding="utf-8")))
    return str(found)


def agree(pattern: str, expected: tuple[str, ...], *places: str) -> None:
    found = list(said(pattern))
    assert [(place, words) for place, words in found if words != expected] == [], f"not {expected}"
    assert {place for place, _ in found} >= set(places), "says it no more"


def test_how_wrong_the_default_is_has_one_answer() -> None:
    low, high = (f"{factor:.2g}" for factor in defaults.error())
    places = ("README.md", "docs/site/index.md", "docs/c.md", "docs/when-to-use.md", "src/capi/validity.rs", "include/asperity.h", "python/src/asperity/results.py")
    agree(r"(\d+) times too (?:low|little) (?:or|to) (\d+) times too (?:high|much)", (low, high), *places)


def test_exact_states_have_one_accuracy() -> None:
    ordinary = constant("tests/physics/reference.rs", r"ordinary\.row\(&case, row, &state, &Tolerance \{ value: (1e-\d+), slope")
    agree(r"80-bit integration (?:to|within) (1e-\d+)", (ordinary,), "README.md")


def test_the_compiled_table_has_one_accuracy() -> None:
    """No less than the tests of the table ask for."""
    tested = constant("tests/law/compiled.rs", r"failures\.claim\(error <= (1e-\d+), ")
    stated = {words[0] for _, words in said(r"within (1e-\d+) of exact (?:states|ones)")}
    assert len(stated) == 1 and float(tested) <= float(stated.pop()), "docs/model.md, include/asperity.h"


def test_speed_is_what_was_measured() -> None:
    """Costs in calls of exp: each place has those of the summary that `make bench` writes, to its digits."""
    summary = constant("docs/dev/performance.md", r"(?s)<!-- summary: begin.*?-->(.*?)\n## ")
    known = [float(number) for number in re.findall(r"(\d\.\d+)", summary)]
    for place, (number,) in said(r"(\d\.\d+)(?: to \d\.\d+)?(?: times as long as| calls? of|) `exp`"):
        digits = len(number.partition(".")[2])
        assert place == "docs/dev/performance.md" or float(number) in {round(one, digits) for one in known}, f"{place}: {number} exp"
