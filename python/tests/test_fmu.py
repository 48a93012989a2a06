"""The mock-up unit: valid for FMPy, run by FMPy and libcosim, and its outputs are the law's."""

from __future__ import annotations

import re
import shutil
import subprocess
import zipfile
from pathlib import Path
from typing import Any, Iterator

import fmpy
import numpy as np
import pytest
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.validation import validate_fmu
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

from asperity import Model, Params
from asperity.__main__ import main
from asperity._fmu_binaries import _soname

# Hard carbon on hard carbon, as in docs/hosts.md, on a square millimetre.
PARAMS = Params.from_spectral_moments(
    m0=9.604e-17, m2=1.8e-3, m4=3.3736e11, nominal_area=1e-6, E1=493e9, nu1=0.25, E2=493e9, nu2=0.25,
    work_of_adhesion=0.06, adhesion_range=0.25e-9, burgers_vector=0.25e-9, hardness=51e9,
)  # fmt: skip
LOAD, FORCE, COEFFICIENT, SLOPE = range(4)


def made(params: Params, directory: Path) -> Path:
    params.to_toml(directory / "surface.toml")
    unit = directory / "hard_carbon.fmu"
    assert main(["fmu", str(directory / "surface.toml"), "-o", str(unit), "--load", "0.5"]) == 0
    return unit


@pytest.fixture(scope="module")
def unit(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return made(PARAMS, tmp_path_factory.mktemp("fmu"))


@pytest.fixture(scope="module")
def references(unit: Path) -> dict[str, int]:
    return {variable.name: variable.valueReference for variable in read_model_description(unit).modelVariables}


@pytest.fixture(params=[FMU2Model, FMU2Slave])
def instance(unit: Path, tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Any]:
    description = read_model_description(unit)
    made = request.param(
        guid=description.guid,
        modelIdentifier=description.coSimulation.modelIdentifier,
        unzipDirectory=extract(unit, str(tmp_path / "unit")),
        instanceName="pad",
    )
    made.instantiate()
    made.setupExperiment()
    yield made
    made.freeInstance()


def law(load: float, **changes: float) -> list[float]:
    """Force, coefficient and slope."""
    with Model(PARAMS.replace(**changes)) as model:
        force, slope = model.friction_force_at_load(load, slope=True)
        return [force, model.friction_at_load(load), slope]


def test_the_validator_finds_no_problem(unit: Path) -> None:
    assert validate_fmu(str(unit)) == []


def test_all_kinds_of_heights_make_valid_units(tmp_path: Path) -> None:
    kinds: dict[str, tuple[dict[str, Any], set[str]]] = {
        "weibull": ({"skew": -0.5}, {"weibull_shape"}),
        "johnson": ({"skew": -0.5, "kurtosis": 4.0, "max_friction_coefficient": float("inf")}, {"skew", "kurtosis"}),
        "tabulated": ({"table_height": (-2.0, 0.0, 2.0), "table_density": (0.0, 1.0, 0.0)}, set()),
    }
    for kind, (changes, names) in kinds.items():
        directory = tmp_path / kind
        directory.mkdir()
        found = made(PARAMS.replace(**changes), directory)
        assert validate_fmu(str(found)) == []
        variables = {variable.name for variable in read_model_description(found).modelVariables}
        assert variables & {"weibull_shape", "skew", "kurtosis"} == names
        result = simulate_fmu(str(found), stop_time=0.1, output_interval=0.1, output=["friction_force"])
        with Model(PARAMS.replace(**changes)) as model:
            assert result["friction_force"][0] == model.friction_force_at_load(0.5)


def test_outputs_are_read_in_initialization_mode(instance: Any, references: dict[str, int]) -> None:
    instance.enterInitializationMode()
    assert instance.getReal([FORCE, COEFFICIENT, SLOPE]) == law(0.5)
    instance.setReal([LOAD, references["work_of_adhesion"]], [2.0, 0.03])
    assert instance.getReal([FORCE, COEFFICIENT, SLOPE]) == law(2.0, work_of_adhesion=0.03)
    instance.exitInitializationMode()
    instance.setReal([LOAD, references["height_std"]], [3.0, 8e-9])  # tuned
    assert instance.getReal([FORCE, COEFFICIENT, SLOPE]) == law(3.0, work_of_adhesion=0.03, height_std=8e-9)
    assert instance.getReal([references["height_std"]]) == [8e-9]
    instance.reset()
    assert instance.getReal([LOAD, FORCE, references["height_std"]]) == [0.5, law(0.5)[0], PARAMS.height_std]


def test_a_parameter_that_is_refused_is_an_error_and_mends(instance: Any, references: dict[str, int]) -> None:
    instance.enterInitializationMode()
    instance.setReal([references["height_std"]], [-1.0])
    with pytest.raises(Exception, match="fmi2GetReal failed with status 3"):
        instance.getReal([FORCE])
    instance.setReal([references["height_std"]], [PARAMS.height_std])
    assert instance.getReal([FORCE]) == law(0.5)[:1]
    instance.setReal([LOAD], [-1e3])  # apart: no friction, no error
    assert instance.getReal([FORCE, COEFFICIENT]) == [0.0, 0.0]
    instance.setReal([LOAD], [float("nan")])
    with pytest.raises(Exception, match="status 2"):
        instance.getReal([FORCE])
    with pytest.raises(Exception, match="status 3"):
        instance.setReal([FORCE], [1.0])


def test_directional_derivatives_are_the_slopes_of_the_law(instance: Any) -> None:
    instance.enterInitializationMode()
    with Model(PARAMS) as model:
        slopes = [model.friction_force_at_load(0.5, slope=True)[1], model.friction_at_load(0.5, slope=True)[1]]
        below, above = (model.friction_force_at_load(0.5 + step, slope=True)[1] for step in (-1e-3, 1e-3))
    assert instance.getDirectionalDerivative([FORCE, COEFFICIENT], [LOAD], [2.0]) == [2 * slope for slope in slopes]
    curvature = instance.getDirectionalDerivative([SLOPE], [LOAD], [1.0])[0]
    assert curvature == pytest.approx((above - below) / 2e-3, rel=1e-4)


@pytest.mark.parametrize("kind", ["ModelExchange", "CoSimulation"])
def test_a_simulation_follows_the_law(unit: Path, kind: str) -> None:
    times = np.linspace(0, 1, 11)
    loads = np.array(list(zip(times, 1 + 20 * times)), dtype=[("time", float), ("load", float)])
    found = simulate_fmu(
        str(unit), stop_time=1, step_size=0.1, output_interval=0.1, fmi_type=kind, input=loads,
        output=["friction_force", "load"],
    )  # fmt: skip
    with Model(PARAMS) as model:
        expected = np.array([model.friction_force_at_load(load) for load in found["load"]])
    assert found["friction_force"] == pytest.approx(expected, rel=1e-14)
    # In co-simulation a step has the load that it began with: it lags.
    lag = 0.1 if kind == "CoSimulation" else 0.0
    assert found["load"][1:] == pytest.approx(1 + 20 * (found["time"][1:] - lag), rel=1e-9)


def test_newtons_method_closes_the_loop_of_a_leading_shoe(instance: Any) -> None:
    """N l = M + F(N) H, not far from jamming, from the load that holds without friction."""
    instance.enterInitializationMode()
    arm, moment = 1.0, 1.0
    height = 0.7 * arm / law(10.0)[1]
    load, iterations = moment / arm, 0
    while True:
        instance.setReal([LOAD], [load])
        residual = load * arm - moment - instance.getReal([FORCE])[0] * height
        if abs(residual) < 1e-12 * load * arm:
            break
        slope = instance.getDirectionalDerivative([FORCE], [LOAD], [1.0])[0]
        load -= residual / (arm - slope * height)
        iterations += 1
        assert iterations < 20
    assert 3 <= iterations <= 5
    with Model(PARAMS) as model:
        exact = model.state_at_load(load)
    assert load * arm == pytest.approx(moment + exact.friction_force * height, rel=1e-7)


def test_libcosim_runs_the_unit(unit: Path, references: dict[str, int]) -> None:
    execution = CosimExecution.from_step_size(int(1e8))
    slave = execution.add_local_slave(CosimLocalSlave(fmu_path=str(unit), instance_name="pad"))
    manipulator, observer = CosimManipulator.create_override(), CosimObserver.create_last_value()
    assert execution.add_manipulator(manipulator) and execution.add_observer(observer)
    for load in (0.5, 7.0, 60.0):
        assert manipulator.slave_real_values(slave, [LOAD], [load])
        assert execution.step()
        assert observer.last_real_values(slave, [FORCE, COEFFICIENT, SLOPE]) == law(load)


def test_the_sources_inside_are_those_of_the_binary(unit: Path, tmp_path: Path) -> None:
    """They compile without a warning, also with the prefix of a static unit, and have every function of the standard."""
    with zipfile.ZipFile(unit) as archive:
        archive.extractall(tmp_path)
    if shutil.which("cc") is None:
        pytest.fail("this test needs a C compiler named cc: apt-get install gcc libc6-dev")
    command = ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I.", "-c", "asperity_fmu.c"]
    subprocess.run([*command, "-DFMI2_FUNCTION_PREFIX=pad_"], cwd=tmp_path / "sources", check=True, timeout=60)
    symbols = subprocess.run(
        ["nm", "-g", "--defined-only", "asperity_fmu.o"], cwd=tmp_path / "sources", capture_output=True, text=True, check=True
    )
    names = [line.split()[-1] for line in symbols.stdout.splitlines()]
    declarations = Path(fmpy.__file__).with_name("c-code").joinpath("fmi2Functions.h").read_text(encoding="utf-8")
    standard = set(re.findall(r"FMI2_Export\s+fmi2\w+TYPE\s+(fmi2\w+);", declarations))
    assert {name.removeprefix("pad_") for name in names} == standard and len(standard) > 40


def test_a_library_with_a_soname_lies_under_it(tmp_path: Path) -> None:
    """As those of releases do, which tests/dist/fmu.sh runs: a unit looks for no other name."""
    (tmp_path / "empty.c").write_text("int nothing;\n", encoding="utf-8")
    for name, wanted in (("libasperity.so.12", "libasperity.so.12"), ("", None)):
        soname = [f"-Wl,-soname,{name}"] if name else []
        subprocess.run(["cc", "-shared", *soname, "empty.c", "-o", "library.so"], cwd=tmp_path, check=True, timeout=60)
        assert _soname((tmp_path / "library.so").read_bytes()) == wanted


def test_what_cannot_be_a_unit_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    surface = tmp_path / "surface.toml"
    PARAMS.replace(height_std=-1.0).to_toml(surface)
    assert main(["fmu", str(surface), "-o", str(tmp_path / "pad.fmu")]) == 1
    assert "height_std = -1: must be" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        main(["fmu", str(surface), "-o", str(tmp_path / "pad.zip")])
    assert "must end in .fmu" in capsys.readouterr().err
    assert not list(tmp_path.glob("pad.*"))


def test_another_platform_needs_its_library(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """tests/dist/fmu.sh makes such a unit and runs it."""
    command = ["fmu", str(tmp_path / "surface.toml"), "-o", str(tmp_path / "pad.fmu"), "--platform", "linux64,win64"]
    PARAMS.to_toml(tmp_path / "surface.toml")
    assert main(command) == 1
    message = capsys.readouterr().err
    assert "--library win64=FILE" in message and "-py3-none-win_amd64.whl" in message
    script = tmp_path / "asperity.dll"
    script.write_text("MZ is how a program begins", encoding="utf-8")
    assert main([*command, "--library", f"win64={script}"]) == 1
    assert "asperity.dll: is not a library for Windows on x86-64" in capsys.readouterr().err
    wheel = tmp_path / "asperity.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("asperity/libasperity.so", b"")
    assert main([*command, "--library", f"win64={wheel}"]) == 1
    assert "has 0 files named asperity.dll; it must have one" in capsys.readouterr().err
    assert not list(tmp_path.glob("pad.*"))


def test_a_missing_cross_compiler_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    PARAMS.to_toml(tmp_path / "surface.toml")
    library = tmp_path / "asperity.dll"
    library.write_bytes(b"MZ" + bytes(58) + (64).to_bytes(4, "little") + b"PE\0\0\x64\x86")
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    command = ["fmu", str(tmp_path / "surface.toml"), "-o", str(tmp_path / "pad.fmu"), "--platform", "win64"]
    assert main([*command, "--library", f"win64={library}"]) == 1
    message = capsys.readouterr().err
    assert "there is no x86_64-w64-mingw32-gcc: pip install ziglang" in message and "gcc-mingw-w64-x86-64" in message


@pytest.mark.parametrize(
    "options, message",
    [
        (["--platform", "linux64,win32"], "--platform linux64,win32: 'win32' is none of linux64 and win64"),
        (["--platform", "linux64", "--library", "win64=no.dll"], "--library win64=no.dll: there is no such file"),
        (["--platform", "linux64", "--library", "no.dll"], "--library no.dll: must be linux64=FILE or win64=FILE"),
        (["--library", f"win64={__file__}"], "the unit is not for win64; add it to --platform"),
    ],
)
def test_wrong_platforms_are_refused(capsys: pytest.CaptureFixture[str], options: list[str], message: str) -> None:
    with pytest.raises(SystemExit):
        main(["fmu", "surface.toml", "-o", "pad.fmu", *options])
    assert message in capsys.readouterr().err


def test_a_missing_compiler_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    PARAMS.to_toml(tmp_path / "surface.toml")
    monkeypatch.setenv("CC", "no-such-compiler")
    assert main(["fmu", str(tmp_path / "surface.toml"), "-o", str(tmp_path / "pad.fmu")]) == 1
    assert "there is no no-such-compiler" in capsys.readouterr().err
