"""`python -m asperity`: the table, the figure, and what it says of bad input."""

from __future__ import annotations

import shlex
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from processes import run_main


from asperity import Model, Params, __version__
from asperity._surface_text import KEYS

POLYSILICON = (
    "--E1 160e9 --nu1 0.22 --E2 160e9 --nu2 0.22 --work-of-adhesion 0.063 --adhesion-range 0.384e-9 "
    "--burgers-vector 0.384e-9 --height-std 5e-9 --summit-radius 1e-6 --summit-density 1e13 --nominal-area 1e-8"
)


def started(arguments: str, **options: Any) -> subprocess.CompletedProcess[str]:
    """The command as a process of its own."""
    command = [sys.executable, "-m", "asperity", *arguments.split()]
    return subprocess.run(command, capture_output=True, text=True, timeout=600, check=False, **options)


def asperity(arguments: str) -> subprocess.CompletedProcess[str]:
    """The command in this process."""
    return run_main(*shlex.split(arguments))


def table(text: str) -> list[list[float]]:
    head, *lines = text.splitlines()
    assert head == "# load, friction coefficient, friction force, real area, contacts"
    return [[float(word) for word in line.split()] for line in lines]


def test_version() -> None:
    assert started("--version").stdout == f"asperity {__version__} (library {__version__}, ABI 1)\n"


def test_the_table_is_that_of_the_model(params: Params) -> None:
    done = asperity("curve --figure - --slip-stress-1 0.02 --lowest 0.01 --highest 100 --count 5")
    assert (done.returncode, done.stderr) == (0, "")
    rows = table(done.stdout)
    assert [row[0] for row in rows] == pytest.approx([0.01, 0.1, 1, 10, 100], rel=1e-9)
    with Model(params.replace(slip_stress_1=0.02)) as model:
        for load, *found in rows:
            state = model.state_at_load(load)
            expected = [state.friction_coefficient, state.friction_force, state.real_area, state.contacting]
            assert found == pytest.approx(expected, rel=1e-6)


def test_a_surface_file_stands_for_the_options(tmp_path: Path) -> None:
    params = Params.si(
        E1=205e9, nu1=0.3, E2=205e9, nu2=0.3, work_of_adhesion=0.0, adhesion_range=0.248e-9, burgers_vector=0.248e-9,
        height_std=0.4e-6, summit_radius=20e-6, asperity_count=5e5, hardness=2e9, contact_law="elastic-plastic",
    )  # fmt: skip
    params.to_toml(tmp_path / "steel.toml")
    (load, mu, *_), _ = table(
        asperity(f"curve --figure - --surface {tmp_path / 'steel.toml'} --lowest 1 --highest 10 --count 2").stdout
    )
    with Model(params) as model:
        assert load == 1.0 and mu == pytest.approx(model.friction_at_load(1.0), rel=1e-9)


@pytest.mark.parametrize("ending, start", [("svg", b"<?xml"), ("png", b"\x89PNG"), ("pdf", b"%PDF")])
def test_the_figure_is_drawn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str, start: bytes) -> None:
    monkeypatch.chdir(tmp_path)
    done = asperity(f"curve --slip-stress-1 0.02 --count 5 --figure curve.{ending}")
    assert (done.returncode, done.stderr) == (0, f"asperity: the curve is drawn in curve.{ending}\n")
    assert (tmp_path / f"curve.{ending}").read_bytes().startswith(start)
    assert len(table(done.stdout)) == 5


def test_loads_at_which_the_model_does_not_hold_are_warned_of() -> None:
    done = asperity("curve --figure - --highest 1e9 --count 3")
    assert done.returncode == 0 and len(table(done.stdout)) == 3
    assert done.stderr.startswith("asperity: warning: between the loads 0.000285714 and 1e+09: STEEP: the surface is too steep")


def test_without_matplotlib_it_says_so_and_prints_nothing(tmp_path: Path) -> None:
    (tmp_path / "matplotlib.py").write_text("raise ImportError('No module named matplotlib')")
    done = started("curve", cwd=tmp_path)  # -m puts the working directory first
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("asperity: drawing needs matplotlib") and "pip install matplotlib" in done.stderr
    assert started("curve --figure - --count 2", cwd=tmp_path).returncode == 0


@pytest.mark.parametrize(
    "arguments, status, message",
    [
        ("", 2, "COMMAND"),
        ("draw", 2, "invalid choice: 'draw'"),
        ("curve --alph 1", 2, "unrecognized arguments: --alph"),
        ("curve --alpha x", 2, "--alpha: invalid float value: 'x'"),
        ("curve --alpha 1 --E1 3", 2, "--alpha is dimensionless, --E1 physical: choose one"),
        ("curve --E1 3", 1, "asperity: [materials] gives no name as first, so nu1 must be set there"),
        (f"curve {POLYSILICON} --asperity-count 3", 1, "asperity: summit_density: must not be given together with asperity_count"),
        ("curve --surface x.toml --skew 1", 2, "--surface is the whole surface: leave out --skew, and change the file"),
        ("curve --surface x.toml --attraction false", 2, "leave out --attraction, and change the file"),
        ("curve steel/steel", 1, "asperity: height_std: must be set"),
        ("curve --surface nowhere.toml", 1, "nowhere.toml"),
        ("curve nowhere.toml", 1, "asperity: nowhere.toml: No such file"),
        ("curve a.toml --surface b.toml", 2, "b.toml: the surface is already a.toml"),
        ("curve a.toml --skew 1", 2, "--surface is the whole surface: leave out --skew"),
        ("curve --count 1", 2, "--count 1: must be 2 or more"),
        ("curve --lowest 0", 2, "--lowest 0: must be finite and > 0"),
        ("curve --lowest 3 --highest 2", 2, "--highest 2: must be finite and above the lowest load, 3"),
        ("curve --figure no/such/directory/curve.svg", 1, "No such file or directory"),
        ("curve --figure curve.xyz", 1, "'xyz' is not supported"),
    ],
)
def test_bad_input_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: str, status: int, message: str
) -> None:
    monkeypatch.chdir(tmp_path)
    done = asperity(arguments)
    assert done.returncode == status
    assert message in done.stderr and "Traceback" not in done.stderr


def test_a_reader_may_leave_early() -> None:
    command = f"'{sys.executable}' -m asperity curve --figure - --count 5000 | head -n 1"
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=600, check=True)
    assert done.stderr == "" and done.stdout.startswith("# load")


def test_a_measured_point_is_met() -> None:
    curve = f"curve --figure - --lowest 1e-3 --highest 1e-2 --count 2 {POLYSILICON}"
    for measured in ("--calibration-friction-coefficient 0.4", "--calibration-friction-force 4e-4"):
        done = asperity(f"{curve} --calibration-load 1e-3 {measured}")
        assert table(done.stdout)[0][1] == pytest.approx(0.4, rel=1e-9)
        assert "UNCALIBRATED" not in done.stderr
    assert "UNCALIBRATED" in asperity(curve).stderr
    done = asperity(f"{curve} --interface 'Al2O3/Si in air'")
    assert done.returncode == 0 and "UNCALIBRATED" not in done.stderr
    assert table(done.stdout)[0][1] < table(asperity(curve).stdout)[0][1] / 100
    unknown = asperity(f"{curve} --interface 'Al2O3'")
    assert unknown.returncode == 1 and "Al2O3: no interface has this name; the nearest is " in unknown.stderr
    alone = asperity(f"{curve} --calibration-load 1e-3")
    assert alone.returncode == 1 and "calibration_load: must be given together with" in alone.stderr


def test_friction_is_told_with_its_band(tmp_path: Path, root: Path) -> None:
    ground = "steel/steel --nominal-area 1e-4 --Ra 0.8e-6 --process ground --measured 1000 0.16"
    done = asperity(f"friction {ground} --load 10 1000")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("mu(10 N) = 0.173, 95 % band 0.108 to 0.279\nmu(1000 N) = 0.16, ")
    file = root / "tests" / "examples" / "ground.toml"
    assert "measured here, " in asperity(f"friction --surface {file} --load 10").stdout
    # A curve of the same surface has the same law.
    for surface in (ground, f"--surface {file}"):
        curve = table(asperity(f"curve {surface} --figure - --lowest 10 --highest 1000 --count 2").stdout)
        lines = asperity(f"friction {surface} --load 10 1000").stdout.splitlines()
        for row in curve:
            says = (f"mu({row[0]:g} N) = {row[1]:.3g}, 95 % band", f"a solver's curve has {row[1]:.3g} at {row[0]:g} N, ")
            assert any(line.startswith(says) for line in lines), (row, lines)
    assert asperity(f"friction {file} --load 10").stdout == asperity(f"friction --surface {file} --load 10").stdout
    # What is refused is named, with the line of a file.
    assert "asperity: [roughness] process = \"grund\": must be one of" in asperity(f"friction {ground.replace('ground', 'grund')} --load 1").stderr
    wrong = tmp_path / "wrong.toml"
    wrong.write_text("measured = 0.16\n", encoding="utf-8")
    assert asperity(f"friction --surface {wrong} --load 1").stderr.startswith(f"asperity: {wrong}: line 1: measured = 0.16: must be points")
    assert asperity(f"friction Si/Si --surface {file} --load 1").returncode == 2
    assert asperity(f"friction {ground}").returncode == 2  # no load
    assert asperity(f"friction --surface {tmp_path / 'none.toml'} --load 1").returncode == 1


def test_friction_of_one_line_with_units_in_the_help_and_a_figure(tmp_path: Path) -> None:
    line = "friction steel/steel --Ra 0.8e-6 --process ground --nominal-area 1e-4 --measured 1000 0.16 --load 10 100 1000"
    done = asperity(f"{line} --figure {tmp_path / 'friction.svg'}")
    assert done.returncode == 0 and "mu(1000 N) = 0.16, " in done.stdout and (tmp_path / "friction.svg").stat().st_size > 0
    several = asperity(f"{line} --measured 100 0.17 0.1")
    assert several.returncode == 0 and "0.16 at 1000 N to 5 %, 0.17 at 100 N to 10 %" in several.stdout
    said = asperity("friction -h").stdout
    for option in ("--Ra m [m ...]", "--hardness Pa", "--nominal-area m^2", "--load N", "--Sds 1/m^2", "asperity friction \"steel/steel\""):
        assert option in said, option
    for name in (*KEYS["materials"], *KEYS["roughness"], *KEYS[""][1:]):
        assert f"--{name.replace('_', '-')} " in said, name
