"""Every exported table, read and interpolated as its host does, is the exact state to the tolerance."""

from __future__ import annotations

import os
import re
import shutil
from pathlib import Path
from typing import Callable

import numpy as np
import numpy.typing as npt
import pytest
from conftest import HARD_CARBON

from asperity import Model, Params
from asperity.__main__ import main
from asperity.estimate import estimate
from asperity.hosts.export_formats import FORMATS

AREA = 1e-4  # of HARD_CARBON
Array = npt.NDArray[np.float64]
Rows = list[tuple[float, float]]


@pytest.fixture
def surface(tmp_path: Path) -> Path:
    path = tmp_path / "hard carbon.toml"
    shutil.copy(HARD_CARBON, path)
    return path


def read_csv(text: str) -> Rows:
    head, *lines = text.splitlines()
    assert head == "pressure,friction_coefficient"
    return [(float(p), float(mu)) for p, mu in (line.split(",") for line in lines)]


def read_keywords(text: str) -> dict[str, list[list[str]]]:
    """Comments begin with **, a keyword with *; fields are separated by commas, and one may be blank."""
    keywords: dict[str, list[list[str]]] = {}
    for line in text.splitlines():
        if line.startswith("*") and not line.startswith("**"):
            lines = keywords.setdefault(line, [])
        elif not line.startswith("**"):
            lines.append([field.strip() for field in line.split(",")])
    return keywords


def read_abaqus(text: str) -> Rows:
    lines = next(lines for keyword, lines in read_keywords(text).items() if keyword.startswith("*FRICTION"))
    assert all(len(line) == 3 and line[1] == "" for line in lines)
    return [(float(pressure), float(mu)) for mu, _, pressure in lines]


def read_calculix(text: str) -> Rows:
    """One coefficient, which holds at all pressures."""
    ((mu, _),) = read_keywords(text)["*FRICTION"]
    return [(0.0, float(mu)), (1e12, float(mu))]


def read_ansys(text: str) -> Rows:
    """TBFIELD keeps the value for the TBDATA that follow."""
    commands = [line.split(",") for line in text.splitlines() if not line.startswith("!")]
    assert commands.pop(0) == ["TB", "FRIC", "ARG1", "", "", "ISO"]
    rows = []
    for field, data in zip(commands[::2], commands[1::2]):
        assert field[:2] == ["TBFIELD", "NPRES"] and data[:2] == ["TBDATA", "1"]
        rows.append((float(field[2]), float(data[2])))
    return rows


def read_lsdyna(text: str) -> Rows:
    """Columns of fixed width: fields of ten characters in a first card, of twenty in tables and curves.

    The curves of a table follow it at once, in the order of its values.
    """
    assert all(len(line) <= 80 for line in text.splitlines())
    keywords: list[tuple[str, list[str]]] = []
    for line in text.splitlines():
        if line.startswith("*"):
            keywords.append((line, []))
        elif not line.startswith("$"):
            keywords[-1][1].append(line)
    (keyword, (head, *values)), *curves = keywords
    assert keyword == "*DEFINE_TABLE" and len(values) == len(curves)
    identities, rows = [int(head[:10])], []
    for value, (keyword, (head, *points)) in zip(values, curves):
        assert keyword == "*DEFINE_CURVE" and len(points) >= 2
        velocities, coefficients = zip(*((float(point[:20]), float(point[20:40])) for point in points))
        assert velocities[0] == 0 and velocities[-1] >= 1e6 and len(set(coefficients)) == 1
        identities.append(int(head[:10]))
        rows.append((float(value[:20]), coefficients[0]))
    contact = re.search(r"^\$#      fs        fd\n\$(.*)$", text, re.MULTILINE)
    assert contact and float(contact[1][:9]) == 2 and float(contact[1][9:19]) == identities[0]
    assert identities == list(range(identities[0], identities[0] + len(identities)))
    assert f"table {identities[0]}, curves {identities[1]} to {identities[-1]}." in text
    return rows


def read_moose(text: str) -> Rows:
    assert re.search(r"^\[Functions\]\n  \[table\]\n    type = PiecewiseLinear\n    axis = x$", text, re.MULTILINE)
    columns = [re.search(rf"^    {axis} = '(.*)'$", text, re.MULTILINE) for axis in "xy"]
    x, y = (list(map(float, column[1].split())) for column in columns if column)
    assert len(x) == len(y)
    return list(zip(x, y))


def read_modelica(text: str) -> Rows:
    table = re.search(r"table=\[([^]]*)\]\);\nend table;\n$", text)
    assert table and text.startswith('block table "')
    return [(float(p), float(mu)) for p, mu in (row.split(",") for row in table[1].split(";"))]


# Interpolated linearly in the pressure, as by these hosts; the documents of LS-DYNA say so of other tables.
READERS: dict[str, Callable[[str], Rows]] = {
    "abaqus": read_abaqus,
    "ansys": read_ansys,
    "calculix": read_calculix,
    "csv": read_csv,
    "lsdyna": read_lsdyna,
    "modelica": read_modelica,
    "moose": read_moose,
}


def test_every_format_is_read_here() -> None:
    assert READERS.keys() == FORMATS.keys()


def exported(surface: Path, kind: str, *options: str) -> Rows:
    file = surface.with_name("table.txt")
    assert main(["export", str(surface), "--format", kind, "-o", str(file), *options]) == 0
    return READERS[kind](file.read_text(encoding="utf-8"))


def largest_error(surface: Path, rows: Rows, pascal: float) -> float:
    """Against exact states, between all rows."""
    pressures = np.concatenate([np.linspace(p, q, 7) for (p, _), (q, _) in zip(rows, rows[1:])])
    found = np.interp(pressures, *np.array(rows).T)
    with Model(Params.from_toml(surface)) as model:
        exact = np.array([model.state_at_load(p * pascal * AREA).friction_coefficient for p in pressures])
    return float(np.max(abs(found / exact - 1)))


@pytest.mark.parametrize("kind", sorted(READERS.keys() - {"calculix"}))
def test_a_table_read_back_is_the_exact_state_to_the_tolerance(surface: Path, kind: str) -> None:
    rows = exported(surface, kind, "--range", "1e3:70e6", "--tolerance", "1e-3")
    assert (rows[0][0], rows[-1][0]) == (1e3, 70e6)
    assert all(p < q for (p, _), (q, _) in zip(rows, rows[1:]))
    # No finer than the tolerance asks for: each stretch uses it up.
    assert 5e-4 < largest_error(surface, rows, 1.0) <= 1e-3
    assert 20 < len(rows) < 60


@pytest.mark.parametrize("tolerance, most", [("1e-2", 15), ("1e-4", 110)])
def test_the_number_of_rows_goes_with_the_tolerance(surface: Path, tolerance: str, most: int) -> None:
    rows = exported(surface, "csv", "--range", "1e3:70e6", "--tolerance", tolerance)
    assert largest_error(surface, rows, 1.0) <= float(tolerance)
    assert len(rows) <= most


def test_the_page_tells_the_numbers_of_rows(surface: Path, root: Path) -> None:
    counts = [len(exported(surface, "csv", "--range", "1e3:70e6", "--tolerance", x)) for x in ("1e-2", "1e-3")]
    page = root / "docs" / "solvers.md"
    text = page.read_text(encoding="utf-8")
    told, now = re.search(r"\d+ rows at 1e-2,\s\d+ at 1e-3", text), f"{counts[0]} rows at 1e-2, {counts[1]} at 1e-3"
    assert told is not None
    if "ASPERITY_WRITE_PAGES" in os.environ:
        page.write_text(text.replace(told[0], now), encoding="utf-8")
    else:
        assert " ".join(told[0].split()) == now


def test_pressures_are_in_the_unit_that_is_asked_for(surface: Path) -> None:
    """The range too is in that unit."""
    rows = exported(surface, "abaqus", "--range", "1e-3:70", "--pressure-unit", "1e6")
    assert (rows[0][0], rows[-1][0]) == (1e-3, 70.0)
    assert largest_error(surface, rows, 1e6) <= 1e-3


def test_ls_dyna_gets_its_identities_and_units(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    command = ["export", str(surface), "--format", "lsdyna"]
    for unit, words in ((1.0, "kg, m, s"), (1e6, "t, mm, s"), (1e9, "kg, mm, ms")):
        pressures = ["--range", f"{1e6 / unit}:{2e6 / unit}", "--pressure-unit", str(unit)]
        assert main([*command, *pressures, "--table-id", "712"]) == 0
        text = capsys.readouterr().out
        assert f"model in {words}.\n" in text and "*DEFINE_TABLE\n       712\n" in text
        assert read_lsdyna(text)[0][0] == pytest.approx(1e6 / unit, rel=1e-9)
    assert main([*command, "--range", "145:290", "--pressure-unit", "6894.76"]) == 0
    text = capsys.readouterr().out
    assert "model in" not in text and "pressure in 6894.76 Pa" in " ".join(text.replace("$", "").split())
    assert "*DEFINE_TABLE\n     90000\n" in text


MM = ["--range", "0.1:70", "--pressure-unit", "1e6", "--length-unit", "1e-3"]


@pytest.mark.parametrize("kind, options", [("abaqus", ["--stiffness"]), ("calculix", [])])
def test_stiffness_and_conductance_read_back_are_the_exact_states(surface: Path, kind: str, options: list[str]) -> None:
    """Between the rows, linearly, in N, mm, MPa and mW; no pressure at overclosure 0, and a straight line from there."""
    exported(surface, kind, *MM, *options, "--conductivity", "16.2:390")
    heated = read_keywords(surface.with_name("table.txt").read_text(encoding="utf-8"))
    rows = exported(surface, kind, *MM, *options)
    text = surface.with_name("table.txt").read_text(encoding="utf-8")
    keywords = read_keywords(text)
    behaviour = np.array(keywords["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR"], dtype=float)
    assert np.all(behaviour[0] == 0) and np.all(np.diff(behaviour, axis=0) > 0)
    zero = re.search(r"Overclosure 0 is a gap of (\S+) between the mean planes", text)
    assert zero
    conductance = np.array(heated["*GAP CONDUCTANCE, PRESSURE" if kind == "abaqus" else "*GAP CONDUCTANCE"], dtype=float)
    assert conductance[0, 1] == 0 and np.all(np.diff(conductance[:, 1]) > 0)
    k = 2 / (1 / 16.2 + 1 / 390)
    with Model(Params.from_toml(surface)) as model:
        if kind == "calculix":
            # Which keeps the last pressure: a last row goes on as stiff.
            (p, depth), stiffest = behaviour[-1] - behaviour[-2], model.state_at_load(70e6 * AREA)
            assert behaviour[-1, 0] == pytest.approx(70e3, rel=1e-6)
            assert p / depth == pytest.approx(-stiffest.dload_dgap / AREA * 1e-9, rel=1e-6)
            behaviour = behaviour[:-1]
        depths = np.concatenate([np.linspace(a, b, 7) for a, b in zip(behaviour[1:, 1], behaviour[2:, 1])])
        exact = [model.state_at_gap(1e-3 * (float(zero[1]) - depth)).load / AREA / 1e6 for depth in depths]
        assert np.max(abs(np.interp(depths, behaviour[:, 1], behaviour[:, 0]) / exact - 1)) <= 1.01e-3
        assert (behaviour[1, 0], behaviour[-1, 0]) == pytest.approx((0.1, 70), rel=1e-6)
        pressures = np.geomspace(0.1, 70, 500)
        exact = [2 * k * model.state_at_load(p * 1e6 * AREA).contact_radius_sum / AREA / 1e3 for p in pressures]
        assert np.max(abs(np.interp(pressures, conductance[:, 1], conductance[:, 0]) / exact - 1)) <= 1.01e-3
        middle = model.state_at_load(np.sqrt(0.1e6 * 70e6) * AREA)
    if kind == "abaqus":
        (keyword,) = (keyword for keyword in keywords if keyword.startswith("*FRICTION, ELASTIC SLIP="))
        slip = float(keyword.split("=")[1])
        assert slip == pytest.approx(1e3 * middle.friction_force / middle.tangential_stiffness, rel=1e-6)
        assert largest_error(surface, rows, 1e6) <= 1e-3
    else:
        ((mu, slope),) = keywords["*FRICTION"]
        assert float(mu) == pytest.approx(middle.friction_coefficient, rel=1e-6)
        assert float(slope) == pytest.approx(middle.tangential_stiffness / AREA * 1e-9, rel=1e-6)
        # Whose gap conductance knows no pressure by a table.
        (linear,) = heated["*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"]
        assert float(linear[0]) == pytest.approx(-middle.dload_dgap / AREA * 1e-9, rel=1e-6)


@pytest.mark.parametrize("kind", ["abaqus", "ansys", "calculix"])
@pytest.mark.parametrize("units", [["--range", "0.1:70", "--pressure-unit", "1e6", "--length-unit", "1e-3"], ["--range", "1e5:70e6"]])
def test_stiffness_per_area_has_the_bands_of_the_estimate(surface: Path, kind: str, units: list[str]) -> None:
    """About the values of the exact state; absolute real constants of Ansys are negative."""
    text = surface.with_name("table.txt")
    assert main(["export", str(surface), "--format", kind, "--stiffness", *units, "-o", str(text)]) == 0
    written = text.read_text(encoding="utf-8")
    told = {
        name: [float(number) for number in numbers]
        for name, *numbers in re.findall(r"^(?:\*\*|!) (.*) (\S+) \((\S+) to (\S+)\)$", written, re.MULTILINE)
    }
    load, unit = np.sqrt(0.1e6 * 70e6) * AREA, 1e9 if len(units) > 2 else 1.0
    with Model(Params.from_toml(surface)) as model:
        state = model.state_at_load(load)
    bands = estimate(surface.read_text(encoding="utf-8"), load)
    normal = "normal stiffness per area of "
    for name, value, band in (
        ("tangential stiffness per area", state.tangential_stiffness, bands.stiffness),
        (normal + "first loading", -state.dload_dgap, bands.normal_stiffness),
        (normal + "unloading and vibration", state.unloading_stiffness, bands.unloading_stiffness),
    ):
        ends = [value, value * band.low / band.value, value * band.high / band.value]
        assert told[name] == pytest.approx([end / AREA / unit for end in ends], rel=6e-3)
    assert told["elastic slip"][1] < told["elastic slip"][0] < told["elastic slip"][2]
    if kind == "ansys":
        constants = {at: -float(value) for at, value in re.findall(r"^RMODIF,ARG2,(\d+),(\S+)$", written, re.MULTILINE)}
        expected = {"3": state.unloading_stiffness, "12": state.tangential_stiffness}
        assert constants == pytest.approx({at: value / AREA / unit for at, value in expected.items()}, rel=1e-6)


def test_a_joint_that_was_tightened_has_the_tables_of_unloading(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """With a surface that yields, at half of the largest pressure; a range beyond it is refused."""
    params = Params.from_toml(surface).replace(work_of_adhesion=0.0).elastic_plastic(2e9)
    params.to_toml(surface)
    options = ["--range", "1:50", "--pressure-unit", "1e6", "--unloaded-from"]
    rows = dict(exported(surface, "csv", *options, "100"))
    with Model(params) as first, first.unloaded(100e6 * params.nominal_area) as joint:
        for pressure, mu in rows.items():
            assert mu == pytest.approx(joint.friction_at_load(pressure * 1e6 * params.nominal_area), rel=1e-6)
            assert mu > first.friction_at_load(pressure * 1e6 * params.nominal_area)
    for wrong in ("20", "-1", "nan", "inf"):
        with pytest.raises(SystemExit):
            exported(surface, "csv", *options, wrong)
        assert "must not be below the highest pressure of --range 1:50" in capsys.readouterr().err


def test_calculix_has_the_coefficient_of_the_pressure_that_is_asked_for(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Whatever the range; how far the coefficient is off at its ends is told."""
    at = ["--friction-at", "58", "--pressure-unit", "1e6"]
    for pressures in ("1:64", "20:64", "0.1:600"):
        ((_, mu), _) = exported(surface, "calculix", "--range", pressures, *at)
        told = re.search(r"coefficient, \S+ of 5\.8e\+07 Pa, up to (\S+)% off", capsys.readouterr().err)
        with Model(Params.from_toml(surface)) as model:
            of = [model.state_at_load(float(p) * 1e6 * AREA).friction_coefficient for p in ("58", *pressures.split(":"))]
        assert mu == pytest.approx(of[0], rel=1e-6)
        assert told and float(told[1]) == pytest.approx(100 * max(abs(mu / end - 1) for end in of[1:]), abs=0.1)


def test_units_of_pressure_and_length_scale_all_columns(surface: Path) -> None:
    """The same file in m and Pa, number by number."""
    options = ["--conductivity", "50", "--stiffness"]
    files = []
    for units in (["--range", "0.1:70", "--pressure-unit", "1e6", "--length-unit", "1e-3"], ["--range", "1e5:70e6"]):
        exported(surface, "abaqus", *options, *units)
        files.append(list(read_keywords(surface.with_name("table.txt").read_text(encoding="utf-8")).values()))
    for (mm, si), factors in zip(zip(*files), ([1, 0, 1e6], [1e6, 1e-3], [1e3, 1e6])):
        for one, other in zip(mm, si):
            for a, b, factor in zip(one, other, factors):
                assert factor == 0 or float(a) * factor == pytest.approx(float(b), rel=3e-9)


def test_without_a_file_the_table_is_printed(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["export", str(surface), "--format", "csv", "--range", "1e6:2e6"]) == 0
    printed = capsys.readouterr()
    assert read_csv(printed.out)[0][0] == 1e6
    assert re.match(r"asperity: \d+ rows from 1e\+06 to 2e\+06 Pa, largest error between them \d\.\de-0\d\n", printed.err)
    assert "UNCALIBRATED: the strength of the interface is the default" in printed.err


def test_a_measured_point_of_the_file_is_met(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    area = Params.from_toml(surface).nominal_area
    text = surface.read_text(encoding="utf-8")
    surface.write_text(f"calibration_load = {1e7 * area!r}\ncalibration_friction_force = {1.5e6 * area!r}\n{text}", encoding="utf-8")
    assert main(["export", str(surface), "--format", "csv", "--range", "1e7:2e7"]) == 0
    printed = capsys.readouterr()
    assert read_csv(printed.out)[0] == pytest.approx((1e7, 0.15), rel=1e-8)
    assert "UNCALIBRATED" not in printed.err and "rows" in printed.err


def test_pressures_that_the_surface_does_not_bear_are_told(surface: Path, capsys: pytest.CaptureFixture[str]) -> None:
    Params.from_toml(surface).replace(hardness=5e9).to_toml(surface)
    assert main(["export", str(surface), "--format", "csv", "--range", "1e6:1e9"]) == 0
    assert "asperity: between 1e+06 and 1e+09 Pa: " in capsys.readouterr().err


@pytest.mark.parametrize(
    "options, message",
    [
        (["--range", "1e6"], "--range 1e6: must be two pressures"),
        (["--range", "2e6:1e6"], "the lower first"),
        (["--range", "0:1e6"], "must be two pressures > 0"),
        (["--range", "1:nan"], "must be two pressures > 0"),
        (["--range", "1e6:64e6", "--pressure-unit", "1e6"], "more than the modulus of the bodies; it is in units of --pressure-unit"),
        (["--range", "1:2", "--friction-at", "1.5"], "only --format calculix has one coefficient"),
        (["--range", "1:2", "--friction-at", "3", "--format", "calculix"], "--friction-at 3: must be a pressure of --range 1:2"),
        (["--range", "1:2", "--friction-at", "nan", "--format", "calculix"], "--friction-at nan: must be a pressure of --range 1:2"),
        (["--range", "1:2", "--tolerance", "1e-9"], "--tolerance 1e-09: must be 1e-6 to 0.1"),
        (["--range", "1:2", "--pressure-unit", "0"], "--pressure-unit 0: must be finite"),
        (["--range", "1:2", "--length-unit", "inf"], "--length-unit inf: must be finite"),
        (["--range", "1:2", "--stiffness"], "--stiffness: only --format abaqus, ansys and calculix have it"),
        (["--range", "1:2", "--conductivity", "50"], "--conductivity: only --format abaqus and calculix have it"),
        (["--range", "1:2", "--conductivity", "50:", "--format", "abaqus"], "--conductivity 50:: must be one or two numbers > 0"),
        (["--range", "1:2", "--conductivity", "0", "--format", "abaqus"], "--conductivity 0: must be one or two numbers > 0"),
        (["--range", "1:2", "--table-id", "7"], "--table-id 7: only --format lsdyna has IDs"),
        (["--range", "1:2", "--format", "lsdyna", "--table-id", "0"], "--table-id 0: must be 1 to 99999999"),
    ],
)
def test_a_wrong_command_line_is_refused(
    surface: Path, capsys: pytest.CaptureFixture[str], options: list[str], message: str
) -> None:
    with pytest.raises(SystemExit):
        main(["export", str(surface), "--format", "csv", *options])
    assert message in capsys.readouterr().err


def test_a_surface_without_an_area_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "surface.toml"
    Params.from_toml(HARD_CARBON).replace(nominal_area=0.0).to_toml(path)
    assert main(["export", str(path), "--format", "csv", "--range", "1e6:2e6"]) == 1
    assert "nominal_area = 0: must be set" in capsys.readouterr().err
