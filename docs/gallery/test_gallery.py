"""The committed gallery is what the library computes: the page to the letter, the pictures curve by curve."""

from __future__ import annotations

import csv
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from gallery import curves, page

DOCS = Path(__file__).resolve().parents[1]

# Of other pages than the gallery: the contacts of the map, the rows of the measurements, a film measured and predicted, a bar
# for each comparison, loops and powers of a joint, loops of a contact that remembers.
ELSEWHERE = {
    "contacts.svg": [7],
    "measurements.svg": [6],
    "measured-points.svg": [2],
    "comparisons.svg": [6],
    "joint-damping.svg": [4, 4],
    "remembered.svg": [3],
}
# The width of every picture [pt].
WIDTH = 5.0 * 72

SVG = "{http://www.w3.org/2000/svg}"
# Each picture with the number of curves in each of its panels.
PICTURES = {
    "figure-3.svg": [4, 2],
    **{f"figure-{number}.svg": [6] for number in range(4, 8)},
    **{f"figure-{number}.svg": [5] for number in range(8, 11)},
    "kurtosis.svg": [6, 3],
    "regimes.svg": [2, 2, 2],
    "yield.svg": [2, 2, 2],
    "microslip.svg": [3, 3],
}


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the program writes."""
    directory = tmp_path_factory.mktemp("docs")
    subprocess.run([sys.executable, str(DOCS / "gallery"), str(directory)], timeout=600, check=True)
    return directory


def lines(picture: Path) -> dict[str, list[tuple[str, list[list[float]]]]]:
    """The curves of a picture: by id, the dashes and the points [pt] of each line of it."""
    found = {}
    for group in ElementTree.parse(picture).iter(f"{SVG}g"):
        if re.fullmatch(r"curve-\d+", group.get("id", "")):
            paths = group.findall(f"{SVG}path")
            found[group.get("id", "")] = [(dashes(path), points(path)) for path in paths]
    return found


def dashes(path: ElementTree.Element) -> str:
    match = re.search(r"stroke-dasharray: ([^;]+)", path.get("style", ""))
    return match[1] if match else ""


def points(path: ElementTree.Element) -> list[list[float]]:
    return [[float(number) for number in point.split()] for point in re.findall(r"[ML] ([^ML]+)", path.get("d", ""))]


def test_the_page_is_what_the_program_writes(written: Path) -> None:
    committed, now = ((place / "dev" / "gallery.md").read_text(encoding="utf-8") for place in (DOCS, written))
    assert committed == now, "run 'python docs/gallery', and read what changed"


def test_the_page_shows_every_picture() -> None:
    shown = re.findall(r"\]\(\.\./figures/(.+?)\)", (DOCS / "dev" / "gallery.md").read_text(encoding="utf-8"))
    assert sorted(shown) == sorted(name.replace(".svg", ending) for name in PICTURES for ending in (".svg", ".csv"))
    pages = "".join(page.read_text(encoding="utf-8") for page in DOCS.rglob("*.md"))
    unseen = {file.name for file in (DOCS / "figures").iterdir()} - set(re.findall(r"\]\((?:\.\./)?figures/(.+?)\)", pages))
    assert not unseen, "no page shows these"


@pytest.mark.parametrize("name", PICTURES | ELSEWHERE)
def test_the_pictures_show_the_same_curves(written: Path, name: str) -> None:
    """Their letters and ticks may differ from one matplotlib to the next."""
    committed, now = lines(DOCS / "figures" / name), lines(written / "figures" / name)
    assert len(committed) == sum((PICTURES | ELSEWHERE)[name]) and committed.keys() == now.keys()
    for curve, drawn in committed.items():
        (_, old), (_, new) = drawn[0], now[curve][0]
        is_bar = name in ("measurements.svg", "comparisons.svg")
        assert len(old) == len(new) >= (2 if is_bar else 20)
        assert np.array(old) == pytest.approx(np.array(new), abs=0.02), curve


@pytest.mark.parametrize("name", PICTURES)
def test_the_curves_are_there_as_numbers(written: Path, name: str) -> None:
    """A column for each, and what they are drawn over."""
    (heads, *rows), (again, *now) = (
        list(csv.reader((place / "figures" / name.replace(".svg", ".csv")).read_text(encoding="utf-8").splitlines())) for place in (DOCS, written)
    )
    assert heads == again and len(set(heads)) > sum(PICTURES[name]) and all(heads) and len(rows) == len(now) >= 20
    assert sum(": " in head for head in heads) == sum(PICTURES[name])
    for old, new in zip(rows, now):
        assert [float(one or 0) for one in old] == pytest.approx([float(one or 0) for one in new], rel=1e-4, abs=1e-6)


@pytest.mark.parametrize("name", PICTURES | ELSEWHERE)
def test_a_telephone_shows_a_picture_with_readable_letters(name: str) -> None:
    """As wide as a telephone's page, about 360 points, so that letters of 9 points stay so."""
    picture = ElementTree.parse(DOCS / "figures" / name).getroot()
    assert float(picture.get("width", "").removesuffix("pt")) == WIDTH


def test_a_claim_that_does_not_hold_is_not_printed_as_one() -> None:
    holds = np.ones(curves.LOADS.size, dtype=bool)
    assert page._where(holds, "it is") == "at all loads it is"
    assert page._where(~holds, "it is") == "at no load it is"
    holds[:15] = False
    assert page._where(holds, "it is") == "from load 10 to 10000 it is"
    holds[30] = False
    assert page._where(holds, "it is") == "at some loads only it is"
    assert page._falls(np.array([3.0, 2.0, 2.5])) == "does not fall at all loads"
    assert not page._descending([np.array([1.0, 2.0]), np.array([0.5, 3.0])]).all()
