"""The starting points' pages print what they say, in Python; their programs in C are for tests/install/readme.rs."""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from processes import outside
from test_docs import blocks, check_page

PAGES = ("ra", "rq-rsm", "height-map", "friction-data", "materials")


@pytest.mark.parametrize("name", PAGES)
def test_a_starting_point_runs_and_prints_what_it_says(root: Path, tmp_path: Path, name: str) -> None:
    page = root / "docs" / f"start-{name}.md"
    assert [kind for kind, _ in blocks(page)] == ["c", "text", "python", "text", "fortran", "text"]
    found = blocks(page)
    assert all(code.count("\n") <= 20 for kind, code in found if kind in ("c", "fortran"))
    # The same in every language; Python's may say more before.
    assert found[1] == found[5] and found[3][1].endswith(found[1][1].split("mu(")[0] if name == "height-map" else found[1][1])
    here = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    check_page(page, tmp_path, outside(PATH=here))


def test_front_pages_lead_to_every_starting_point(root: Path) -> None:
    for page, folder in (("README.md", "docs/"), ("docs/site/index.md", "guide/docs/")):
        text = (root / page).read_text(encoding="utf-8")
        assert [name for name in PAGES if f"({folder}start-{name}.md)" not in text] == [], page


@pytest.mark.parametrize("name", PAGES)
def test_a_starting_point_ends_with_a_number_its_band_and_what_narrows_it(root: Path, name: str) -> None:
    text = (root / "docs" / f"start-{name}.md").read_text(encoding="utf-8")
    head, _, rest = text.partition("## In C")
    assert all(f"**{words}**" in head for words in ("At the end", "You need", "It takes"))
    assert "## The number, its band, and what narrows it" in rest and "## Limits" in rest
