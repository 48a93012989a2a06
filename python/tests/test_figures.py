"""The committed gallery is what the library computes: the page to the letter, the pictures curve by curve."""

from __future__ import annotations

import math
import re
import subprocess
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest

from asperity import Model, Params
from asperity.figures import calibrated, curves, drawing, page

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
    "sensitivities.svg": [6],
}


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What the command writes."""
    directory = tmp_path_factory.mktemp("docs")
    command = [sys.executable, "-m", "asperity", "figures", "--out", str(directory)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert (done.returncode, done.stdout) == (0, "")
    count = len(PICTURES | ELSEWHERE) + 1
    assert done.stderr == f"asperity: wrote {count} files, the last is {directory / 'dev' / 'gallery.md'}\n"
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


def test_the_page_is_what_the_command_writes(root: Path, written: Path) -> None:
    committed, now = ((place / "dev" / "gallery.md").read_text(encoding="utf-8") for place in (root / "docs", written))
    assert committed == now, "run 'python -m asperity figures' in the root of the repository, and read what changed"


def test_the_page_shows_every_picture(root: Path) -> None:
    shown = re.findall(r"\]\(\.\./figures/(.+?)\)", (root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8"))
    assert sorted(shown) == sorted(PICTURES)
    pages = "".join(page.read_text(encoding="utf-8") for page in (root / "docs").rglob("*.md"))
    unseen = {file.name for file in (root / "docs" / "figures").iterdir()} - set(re.findall(r"\]\((?:\.\./)?figures/(.+?)\)", pages))
    assert not unseen, "no page shows these"


@pytest.mark.parametrize("name", PICTURES | ELSEWHERE)
def test_the_pictures_show_the_same_curves(root: Path, written: Path, name: str) -> None:
    """Their letters and ticks may differ from one matplotlib to the next."""
    committed, now = lines(root / "docs" / "figures" / name), lines(written / "figures" / name)
    assert len(committed) == sum((PICTURES | ELSEWHERE)[name]) and committed.keys() == now.keys()
    for curve, drawn in committed.items():
        (_, old), (_, new) = drawn[0], now[curve][0]
        is_bar = name in ("measurements.svg", "comparisons.svg")
        assert len(old) == len(new) >= (2 if is_bar else 20)
        assert np.array(old) == pytest.approx(np.array(new), abs=0.02), curve


@pytest.mark.parametrize("name", PICTURES | ELSEWHERE)
def test_a_telephone_shows_a_picture_with_readable_letters(root: Path, name: str) -> None:
    """As wide as a telephone's page, about 360 points, so that letters of 9 points stay so."""
    picture = ElementTree.parse(root / "docs" / "figures" / name).getroot()
    assert float(picture.get("width", "").removesuffix("pt")) == WIDTH


@pytest.mark.parametrize("name", PICTURES)
def test_lines_of_a_picture_differ_in_more_than_colour(root: Path, name: str) -> None:
    styles = [drawn[0][0] for drawn in lines(root / "docs" / "figures" / name).values()]
    for curves_of_panel in PICTURES[name]:
        panel, styles = styles[:curves_of_panel], styles[curves_of_panel:]
        assert len(set(panel)) == len(panel)


def test_a_curve_is_drawn_where_its_numbers_are(written: Path) -> None:
    """Figure 8, whose axis of friction is linear from 0: heights on paper are in the ratio of the coefficients."""
    drawn = lines(written / "figures" / "figure-8.svg")
    heavy = [np.array(drawn[f"curve-{i}"][0][1])[-1] for i in range(5)]
    light = [np.array(drawn[f"curve-{i}"][0][1])[0] for i in range(5)]
    expected = []
    for amplitude in (1.0, 0.5, 0.0, -0.5, -0.95):
        with Model(Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001, radius_amplitude=amplitude)) as model:
            expected.append([model.state_at_load(load).friction_coefficient for load in (1.0, 1e4)])
    measured = np.array([[left[1], right[1]] for left, right in zip(light, heavy)])
    slope, origin = np.polyfit(np.array(expected).ravel(), measured.ravel(), 1)
    assert measured == pytest.approx(slope * np.array(expected) + origin, abs=0.01)
    ends = (light[0][0], heavy[0][0])
    assert ends == pytest.approx((0.14 * WIDTH, 0.82 * WIDTH), abs=0.01)


def test_bars_are_where_the_residuals_are(written: Path) -> None:
    """The axis of ratios is logarithmic from 0.4 to 2.5; a single value is drawn as a short bar around it."""
    drawn = lines(written / "figures" / "comparisons.svg")
    left, right = (place * WIDTH for place in (0.05, 0.96))
    for number, one in enumerate(calibrated.COMPARISONS):
        ends = [point[0] for point in drawn[f"curve-{number}"][0][1]]
        _, (low, high) = one.worst()
        at = [math.log(ratio / 0.4) / math.log(2.5 / 0.4) * (right - left) + left for ratio in (1 + low, 1 + high)]
        assert sum(ends) == pytest.approx(sum(at), abs=0.1), one.name
        assert ends == pytest.approx(at, abs=5.0), one.name


def test_drawing_twice_gives_the_same_bytes(written: Path, tmp_path: Path) -> None:
    for file in drawing.draw_all(tmp_path):
        assert file.read_bytes() == (written / "figures" / file.name).read_bytes(), file.name


# ---- The page against computations of its own, without the compiled law ----


def section(text: str, number: int) -> str:
    return text.split(f"## Figure {number}:")[1].split("\n## ")[0]


def rows(text: str) -> dict[str, list[float]]:
    """The table of numbers of a section: first cell to the numbers behind it."""
    found = {}
    for line in text.splitlines():
        head, *cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells and all(re.fullmatch(r"[\d.]+", cell) for cell in cells):
            found[head] = [float(cell) for cell in cells]
    return found


@pytest.mark.parametrize(
    "number, groups",
    [(4, (0.01, 1000, 0.001)), (5, (0.006, 1000, 0.001)), (6, (0.01, 500, 0.001)), (7, (0.01, 1000, 0.002)),
     (8, (0.01, 1000, 0.001)), (9, (0.01, 5000, 0.001)), (10, (0.03, 1000, 0.001))],
)  # fmt: skip
def test_tables_of_friction_are_right(root: Path, number: int, groups: tuple[float, float, float]) -> None:
    found = rows(section((root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8"), number))
    assert len(found) == (6 if number < 8 else 5)
    alpha, beta, gamma = groups
    for name, numbers in found.items():
        words = name.replace("−", "-").split()
        option = "skew" if "skew" in words else "radius_amplitude"
        options = {} if name == "Gaussian" else {option: float(words[-1])}
        exact = exact_friction(alpha=alpha, beta=beta, gamma=gamma, **options)
        assert numbers == pytest.approx(exact, rel=5.1e-4), name


def test_the_effect_of_attraction_is_right(root: Path) -> None:
    text = section((root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8"), 3)
    loads = re.search(r"2\.1 % at load ([\d.]+) and 3\.8 % at load ([\d.]+)", text)
    assert loads is not None
    for beta, load, percent in ((1000, loads[1], 2.1), (500, loads[2], 3.8)):
        assert effect(beta, float(load)) == pytest.approx(percent, abs=0.01)
    for name, (found_lambda, *numbers) in rows(text).items():
        assert numbers == pytest.approx([effect(float(name), load) for load in (1, 10, 100, 1e3, 1e4)], abs=0.0051)
        with Model(Params.dimensionless(alpha=0.01, beta=float(name), gamma=0.001)) as model:
            assert found_lambda == pytest.approx(model.summary().lambda_, abs=5.1e-4)


def test_the_effect_of_kurtosis_is_right(root: Path) -> None:
    text = (root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8").split("## Kurtosis")[1].split("\n## ")[0]
    friction, difference = text.split("| Skew |")
    found = rows(friction)
    assert len(found) == 6
    for name, numbers in found.items():
        family, _, skew, *rest = name.replace(",", "").split()
        options = {"skew": float(skew)} | ({"kurtosis": float(rest[1])} if family == "Johnson" else {})
        assert numbers == pytest.approx(exact_friction(**options), rel=5.1e-4), name
    lines = [line.strip("|").split("|") for line in difference.replace("−", "-").splitlines()[2:] if line[:1] == "|"]
    assert len(lines) == 5
    for skew, kurtosis, *cells in lines:
        weibull = exact_friction(skew=float(skew))
        with Model(Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001, skew=float(skew))) as model:
            found_kurtosis = model.summary().kurtosis
        assert float(kurtosis) == pytest.approx(found_kurtosis, abs=5.1e-4)
        johnson = exact_friction(skew=float(skew), kurtosis=found_kurtosis)
        expected = 100 * (np.array(johnson) / np.array(weibull) - 1)
        assert [float(cell) for cell in cells] == pytest.approx(expected.tolist(), abs=0.051)


def test_the_kink_of_johnsons_system_is_where_the_page_says(root: Path) -> None:
    found = re.search(r"kink at kurtosis (\d+\.\d+)", (root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8"))
    assert found is not None
    at, step = float(found[1]), 0.02
    logs = [math.log(exact_friction(skew=-0.5, kurtosis=at + i * step)[1]) for i in (-2, -1, 0, 1, 2)]
    slopes = np.diff(logs)
    assert abs(slopes[2] - slopes[1]) > 5 * max(abs(slopes[1] - slopes[0]), abs(slopes[3] - slopes[2]))


def exact_friction(**options: Any) -> list[float]:
    """At the loads of the tables, by default with alpha = 0.01, beta = 1000, gamma = 0.001."""
    groups = {"alpha": 0.01, "beta": 1000, "gamma": 0.001}
    with Model(Params.dimensionless(**(groups | options), max_friction_coefficient=math.inf)) as model:
        return [model.state_at_load(load).friction_coefficient for load in (1, 10, 100, 1e3, 1e4)]


def test_the_regimes_are_right(root: Path) -> None:
    text = (root / "docs" / "dev" / "gallery.md").read_text(encoding="utf-8").split("## Regimes")[1]
    found = [line.strip("|").split("|") for line in text.splitlines() if "a₁ |" in line or "a₂ |" in line]
    assert len(found) == 9
    for i in range(0, 9, 3):
        beta = float(found[i][0])
        fractions = np.array([[float(cell) for cell in line[3:]] for line in found[i : i + 3]])
        assert fractions.sum(axis=0) == pytest.approx(np.ones(5), abs=2e-4)
        with Model(Params.dimensionless(alpha=0.01, beta=beta, gamma=1e-4)) as model:
            for load, (below, between, above) in zip((1e-6, 1e-4, 1e-2, 1.0, 10.0), fractions.T):
                state = model.state_at_load(load * 0.01 * beta**2)
                assert below == pytest.approx(state.fraction_below_slip_radius_1, abs=5.1e-5)
                assert between == pytest.approx(state.fraction_between_slip_radii, abs=5.1e-5)
                assert above == pytest.approx(state.fraction_above_slip_radius_2, abs=5.1e-5)


def effect(beta: float, load: float) -> float:
    """Per cent by which attraction raises friction, with alpha = 0.01 and gamma = 0.001."""
    forces = []
    for attraction in (True, False):
        with Model(Params.dimensionless(alpha=0.01, beta=beta, gamma=0.001, attraction=attraction)) as model:
            forces.append(model.state_at_load(load).friction_force)
    return 100 * (forces[0] / forces[1] - 1)


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


def test_without_matplotlib_it_says_so(tmp_path: Path) -> None:
    (tmp_path / "matplotlib.py").write_text("raise ImportError('No module named matplotlib')")
    command = [sys.executable, "-m", "asperity", "figures", "--out", str(tmp_path / "out")]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 1 and done.stderr.startswith("asperity: drawing needs matplotlib")
    assert not (tmp_path / "out" / "dev" / "gallery.md").exists()


def test_a_directory_that_cannot_be_written_is_named(tmp_path: Path) -> None:
    (tmp_path / "figures").write_text("")
    command = [sys.executable, "-m", "asperity", "figures", "--out", str(tmp_path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 1 and str(tmp_path / "figures") in done.stderr and "Traceback" not in done.stderr
