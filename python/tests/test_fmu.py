"""Mock-up units of FMI 2.0 and 3.0: valid for FMPy, run by FMPy and (2.0) libcosim, and their outputs are the law's."""

from __future__ import annotations

import ctypes
import re
import shutil
import struct
import subprocess
import zipfile
from pathlib import Path
from typing import Any, Iterator

import fmpy
import numpy as np
import pytest
from conftest import HARD_CARBON
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi2 import FMU2Model, FMU2Slave, fmi2CallbackFunctions, fmi2CallbackLoggerTYPE
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.logging import addLoggerProxy
from fmpy.validation import validate_fmu
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

from asperity import Error, Model, Params, _header
from asperity.__main__ import main

PARAMS = Params.from_toml(HARD_CARBON)
LOAD, FORCE, COEFFICIENT, SLOPE = range(4)
DISPLACEMENT, RESISTANCE, STIFFNESS = range(4, 7)  # of units with microslip
# FMPy has one logger for all units of FMI 2.0, the last one given: it must live as long as the tests.
LOGGERS: list[fmi2CallbackFunctions] = []


def made(params: Params, directory: Path, fmi: str, *options: str) -> Path:
    params.to_toml(directory / "surface.toml")
    unit = directory / "hard_carbon.fmu"
    assert main(["fmu", str(directory / "surface.toml"), "-o", str(unit), "--load", "0.5", "--fmi", fmi, *options]) == 0
    return unit


@pytest.fixture(scope="module")
def units(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return {fmi: made(PARAMS, tmp_path_factory.mktemp("fmu"), fmi) for fmi in ("2.0", "3.0")}


@pytest.fixture(scope="module")
def microslip_units(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return {fmi: made(PARAMS, tmp_path_factory.mktemp("microslip"), fmi, "--microslip") for fmi in ("2.0", "3.0")}


@pytest.fixture(params=["2.0", "3.0"])
def unit(units: dict[str, Path], request: pytest.FixtureRequest) -> Path:
    return units[request.param]


@pytest.fixture(scope="module")
def references(units: dict[str, Path]) -> dict[str, int]:
    """The same in both versions but for the time."""
    two, three = (
        {variable.name: variable.valueReference for variable in read_model_description(units[fmi]).modelVariables}
        for fmi in ("2.0", "3.0")
    )
    assert three.pop("time") == len(two) and two == three
    return two


def instantiated(unit: Path, kind: type[Any], directory: Path) -> Any:
    """A new instance, and what was logged, with the names of FMI 2.0."""
    description = read_model_description(unit)
    made = kind(
        guid=description.guid,
        modelIdentifier=description.coSimulation.modelIdentifier,
        unzipDirectory=extract(unit, str(directory)),
        instanceName="pad",
    )
    made.log = []
    if kind in (FMU2Model, FMU2Slave):
        calls = fmi2CallbackFunctions()
        calls.logger = fmi2CallbackLoggerTYPE(lambda *said: made.log.append(said[4].decode()))
        LOGGERS.append(calls)
        addLoggerProxy(ctypes.byref(calls))
        made.instantiate(callbacks=calls)
        made.setupExperiment()
    else:
        made.getReal, made.setReal = made.getFloat64, made.setFloat64
        made.getFMUstate, made.setFMUstate, made.freeFMUstate = made.getFMUState, made.setFMUState, made.freeFMUState
        made.serializeFMUstate, made.deSerializeFMUstate = made.serializeFMUState, made.deserializeFMUState
        made.instantiate(logMessage=lambda *said: made.log.append(said[3].decode()))
    return made


KINDS = [FMU2Model, FMU2Slave, FMU3Model, FMU3Slave]


def version_of(kind: type[Any]) -> str:
    return "2.0" if kind in (FMU2Model, FMU2Slave) else "3.0"


@pytest.fixture(params=KINDS)
def instance(units: dict[str, Path], tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Any]:
    made = instantiated(units[version_of(request.param)], request.param, tmp_path / "unit")
    yield made
    made.freeInstance()


@pytest.fixture(params=KINDS)
def contact(microslip_units: dict[str, Path], tmp_path: Path, request: pytest.FixtureRequest) -> Iterator[Any]:
    """An instance with microslip; `move` sets displacement and load and accepts the step, and gives the tangential force."""
    made = instantiated(microslip_units[version_of(request.param)], request.param, tmp_path / "unit")

    def move(displacement: float, load: float = 0.5) -> float:
        made.setReal([DISPLACEMENT, LOAD], [displacement, load])
        made.completedIntegratorStep() if request.param in (FMU2Model, FMU3Model) else made.doStep(0.0, 0.1)
        return float(made.getReal([RESISTANCE])[0])

    def begin() -> None:
        made.enterInitializationMode()
        made.exitInitializationMode()
        if request.param in (FMU2Model, FMU3Model):
            made.enterContinuousTimeMode()

    made.move, made.begin = move, begin
    yield made
    made.freeInstance()


def law(load: float, **changes: float) -> list[float]:
    """Force, coefficient and slope."""
    with Model(PARAMS.replace(**changes)) as model:
        force, slope = model.friction_force_at_load(load, slope=True)
        return [force, model.friction_at_load(load), slope]


def test_the_validator_finds_no_problem(unit: Path) -> None:
    assert validate_fmu(str(unit)) == []


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_all_kinds_of_heights_make_valid_units(tmp_path: Path, fmi: str) -> None:
    kinds: dict[str, tuple[dict[str, Any], set[str]]] = {
        "weibull": ({"skew": -0.5}, {"weibull_shape"}),
        "johnson": ({"skew": -0.5, "kurtosis": 4.0, "max_friction_coefficient": float("inf")}, {"skew", "kurtosis"}),
        "tabulated": ({"table_height": (-2.0, 0.0, 2.0), "table_density": (0.0, 1.0, 0.0)}, set()),
    }
    for kind, (changes, names) in kinds.items():
        directory = tmp_path / kind
        directory.mkdir()
        found = made(PARAMS.replace(**changes), directory, fmi)
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
    instance.terminate()
    instance.reset()
    assert instance.getReal([LOAD, FORCE, references["height_std"]]) == [0.5, law(0.5)[0], PARAMS.height_std]


def test_each_parameter_altered_once_gives_the_law_that_it_makes(instance: Any, units: dict[str, Path], tmp_path: Path) -> None:
    instance.enterInitializationMode()
    beside = instantiated(units["2.0"], FMU2Model, tmp_path / "beside")
    beside.enterInitializationMode()
    altered = 0
    for variable in read_model_description(units["2.0"]).modelVariables:
        if variable.causality != "parameter":
            continue
        (given,) = instance.getReal([variable.valueReference])
        value = 1.01 * given if given else 1e-3
        instance.setReal([variable.valueReference], [value])
        try:
            expected = law(0.5, **{variable.name: value})
        except Error:
            with pytest.raises(Exception, match="status 3"):
                instance.getReal([FORCE])
        else:
            assert instance.getReal([FORCE, COEFFICIENT, SLOPE]) == expected, variable.name
            altered += expected != law(0.5)
        instance.setReal([variable.valueReference], [given])
        assert instance.getReal([FORCE, COEFFICIENT, SLOPE]) == beside.getReal([FORCE, COEFFICIENT, SLOPE]) == law(0.5)
    assert altered >= 8
    beside.freeInstance()


def test_a_parameter_that_is_refused_is_an_error_and_mends(instance: Any, references: dict[str, int]) -> None:
    instance.enterInitializationMode()
    instance.setReal([references["height_std"]], [-1.0])
    with pytest.raises(Exception, match="status 3"):
        instance.getReal([FORCE])
    assert "height_std = -1: must be" in instance.log[-1]
    instance.setReal([references["height_std"]], [PARAMS.height_std])
    assert instance.getReal([FORCE]) == law(0.5)[:1]
    instance.setReal([LOAD], [-1e3])  # apart: no friction, no error
    assert instance.getReal([FORCE, COEFFICIENT]) == [0.0, 0.0]
    instance.setReal([LOAD], [float("nan")])
    with pytest.raises(Exception, match="status 2"):
        instance.getReal([FORCE])
    with pytest.raises(Exception, match="status 3"):
        instance.setReal([FORCE], [1.0])
    with pytest.raises(Exception, match="status 3"):
        instance.getReal([10**9])
    assert instance.log[-1] == "a value reference that no variable has"


def test_each_warning_is_logged_once_in_a_run(instance: Any, references: dict[str, int]) -> None:
    uncalibrated = "at a load of 0.5: the strength of the interface is the default or that of other materials"
    instance.enterInitializationMode()
    for load in (0.5, 0.6, 1e-6, 0.5, 1e-6):
        instance.setReal([LOAD], [load])
        instance.getReal([FORCE, COEFFICIENT, SLOPE])
    assert [line.startswith(uncalibrated) for line in instance.log].count(True) == 1
    assert ["at a load of 1e-06: fewer than 20 asperities" in line for line in instance.log].count(True) == 1
    assert len(set(line.split(": ")[1] for line in instance.log)) == len(instance.log)
    instance.exitInitializationMode()
    instance.terminate()
    instance.reset()
    instance.log.clear()
    # The strength is given: nothing of it is told.
    instance.setReal([references["slip_stress_1"], references["slip_stress_2"]], [0.01, 0.001])
    instance.getReal([FORCE])
    assert not any("strength of the interface is the default" in line for line in instance.log)


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_a_measured_point_of_the_file_is_met(tmp_path: Path, capsys: pytest.CaptureFixture[str], fmi: str) -> None:
    made(PARAMS, tmp_path, fmi)
    assert "asperity: at a load of 0.5: UNCALIBRATED: the strength of the interface is the default" in capsys.readouterr().err
    text = (tmp_path / "surface.toml").read_text(encoding="utf-8")
    file = tmp_path / "measured.toml"
    file.write_text(f"calibration_load = 2.0\ncalibration_friction_coefficient = 0.15\n{text}", encoding="utf-8")
    unit = tmp_path / "measured.fmu"
    assert main(["fmu", str(file), "-o", str(unit), "--fmi", fmi]) == 0
    assert "UNCALIBRATED" not in capsys.readouterr().err
    found = simulate_fmu(str(unit), stop_time=1.0, step_size=0.5, start_values={"load": 2.0}, output=["friction_coefficient"])
    assert found["friction_coefficient"] == pytest.approx(0.15, rel=1e-6)


def test_functions_called_in_the_wrong_mode_are_refused(instance: Any) -> None:
    """And do nothing: the next call in order goes well."""
    exchange = isinstance(instance, (FMU2Model, FMU3Model))
    step = instance.completedIntegratorStep if exchange else lambda: instance.doStep(0.0, 0.1)
    refusals = []

    def refused(*calls: Any) -> None:
        for call in calls:
            with pytest.raises(Exception, match="status 3"):
                call()
            refusals.append(instance.log[-1])

    refused(instance.exitInitializationMode, step, instance.terminate)
    instance.enterInitializationMode()
    refused(instance.enterInitializationMode, step, instance.terminate)
    instance.exitInitializationMode()
    if exchange:
        refused(instance.exitInitializationMode, step)
        instance.enterContinuousTimeMode()
        refused(instance.enterContinuousTimeMode)
    step()
    if exchange:
        instance.enterEventMode()
    instance.terminate()
    refused(step, instance.terminate)
    assert re.fullmatch(r"fmi\dExitInitializationMode must not be called before initialization mode", refusals[0])
    assert refusals[-1].endswith("Terminate must not be called after the end")


def test_arrays_that_differ_in_length_are_refused(units: dict[str, Path], tmp_path: Path) -> None:
    """And what a unit of FMI 3.0 cannot be: one with an event mode in co-simulation, or for scheduled execution."""
    description = read_model_description(units["3.0"])
    found: list[str] = []
    slave = FMU3Slave(
        guid=description.guid,
        modelIdentifier="hard_carbon",
        unzipDirectory=extract(units["3.0"], str(tmp_path)),
        instanceName="pad",
    )

    def log(*said: Any) -> None:
        found.append(said[3].decode())

    with pytest.raises(Exception, match="instantiate"):
        slave.instantiate(eventModeUsed=True, logMessage=log)
    assert "no event mode" in found[-1]
    slave.guid = "another"
    with pytest.raises(Exception, match="instantiate"):
        slave.instantiate(logMessage=log)
    assert "not that of this unit" in found[-1]
    slave.guid = description.guid
    slave.instantiate(logMessage=log)
    slave.enterInitializationMode(startTime=2.0)
    time = next(variable.valueReference for variable in description.modelVariables if variable.name == "time")
    assert slave.getFloat64([time, LOAD]) == [2.0, 0.5]
    with pytest.raises(Exception, match="status 3"):
        slave.getFloat64([LOAD], 2)
    with pytest.raises(Exception, match="status 3"):
        slave.getDirectionalDerivative([FORCE], [LOAD], [1.0, 1.0])
    assert len(found) == 4 and all("differ in length" in message for message in found[2:])
    slave.exitInitializationMode()
    assert slave.doStep(2.0, 0.5) == (False, False, False, 2.5) and slave.getFloat64([time]) == [2.5]
    slave.freeInstance()


def test_directional_derivatives_are_the_slopes_of_the_law(instance: Any) -> None:
    instance.enterInitializationMode()
    with Model(PARAMS) as model:
        slopes = [model.friction_force_at_load(0.5, slope=True)[1], model.friction_at_load(0.5, slope=True)[1]]
        below, above = (model.friction_force_at_load(0.5 + step, slope=True)[1] for step in (-1e-3, 1e-3))
    assert instance.getDirectionalDerivative([FORCE, COEFFICIENT], [LOAD], [2.0]) == [2 * slope for slope in slopes]
    curvature = instance.getDirectionalDerivative([SLOPE], [LOAD], [1.0])[0]
    assert curvature == pytest.approx((above - below) / 2e-3, rel=1e-4)


def slip_length(load: float = 0.5) -> float:
    """Friction force over tangential stiffness."""
    with Model(PARAMS) as model:
        return float(model.friction_force_at_load(load) / model.tangential_stiffness_at_load(load))


def test_units_with_microslip_are_valid(microslip_units: dict[str, Path]) -> None:
    for unit in microslip_units.values():
        assert validate_fmu(str(unit)) == []
        variables = [variable.name for variable in read_model_description(unit).modelVariables]
        assert variables[DISPLACEMENT:8] == ["displacement", "tangential_force", "tangential_stiffness", "composite_modulus"]


def test_a_contact_resists_as_the_law_says_and_remembers(contact: Any) -> None:
    length = slip_length()
    with Model(PARAMS) as model:
        friction, stiffness = model.friction_force_at_load(0.5), model.tangential_stiffness_at_load(0.5)

        def curve(displacement: float) -> float:
            return float(model.tangential(0.5, displacement)[0])

        contact.begin()
        assert contact.getReal([RESISTANCE, STIFFNESS]) == [0.0, pytest.approx(stiffness, rel=1e-12)]
        for part in np.linspace(0.05, 0.8, 16):
            assert contact.move(part * length) == pytest.approx(curve(part * length), abs=0.02 * friction)
        top = contact.getReal([RESISTANCE])[0]
        for part in np.linspace(0.75, -0.8, 32):  # Masing's rule
            expected = curve(0.8 * length) - 2 * curve((0.8 - part) / 2 * length)
            assert contact.move(part * length) == pytest.approx(expected, abs=0.03 * friction)
        assert contact.getReal([RESISTANCE])[0] == pytest.approx(-top, rel=1e-3)
        assert contact.move(100 * length) == pytest.approx(friction, rel=1e-12)
        assert contact.getReal([FORCE, COEFFICIENT, SLOPE]) == law(0.5)
        assert contact.move(100 * length, load=-1e3) == 0.0  # apart: nothing is remembered
        assert contact.move(100 * length) == 0.0
        assert contact.move(100.01 * length) == pytest.approx(0.01 * friction, rel=1e-2)


def test_what_a_solver_tries_is_not_remembered(contact: Any) -> None:
    length = slip_length()
    contact.begin()
    contact.move(0.3 * length)
    force = contact.move(0.6 * length)
    for displacement, load in ((2.0, 0.5), (-3.0, 0.4), (0.1, 2.0)):
        contact.setReal([DISPLACEMENT, LOAD], [displacement * length, load])
        assert contact.getReal([RESISTANCE]) != [force]
    contact.setReal([DISPLACEMENT, LOAD], [0.6 * length, 0.5])
    assert contact.getReal([RESISTANCE]) == [force]
    contact.setReal([DISPLACEMENT], [float("nan")])
    with pytest.raises(Exception, match="status 2"):
        contact.getReal([RESISTANCE])


def test_a_contact_is_saved_and_brought_back(contact: Any) -> None:
    length = slip_length()
    contact.begin()
    path = [(0.7, 0.5), (0.2, 0.45), (0.9, 0.8)]
    contact.move(0.5 * length)
    saved = contact.getFMUstate()
    forces = [contact.move(displacement * length, load) for displacement, load in path]
    data = contact.serializeFMUstate(saved)
    contact.setFMUstate(saved)
    contact.freeFMUstate(saved)
    assert [contact.move(displacement * length, load) for displacement, load in path] == forces
    contact.setFMUstate(contact.deSerializeFMUstate(data))
    assert contact.getReal([DISPLACEMENT, LOAD]) == [0.5 * length, 0.5]
    assert [contact.move(displacement * length, load) for displacement, load in path] == forces
    for wrong in (data[:-1], b"x" + data[1:]):
        with pytest.raises(Exception, match="status 3"):
            contact.deSerializeFMUstate(wrong)
    assert "not those of a saved unit" in contact.log[-1]


def test_a_saved_unit_brings_its_parameters_back(instance: Any, references: dict[str, int]) -> None:
    instance.enterInitializationMode()
    saved = instance.getFMUstate()
    instance.setReal([LOAD, references["height_std"]], [3.0, 8e-9])
    assert instance.getReal([FORCE]) == law(3.0, height_std=8e-9)[:1]
    instance.setFMUstate(saved)
    assert instance.getReal([LOAD, FORCE]) == [0.5, law(0.5)[0]]
    instance.freeFMUstate(saved)


@pytest.mark.parametrize("kind", KINDS)
def test_damaged_bytes_of_a_saved_unit_are_refused(tmp_path: Path, kind: type[Any]) -> None:
    """A length that the unit does not have would be read past the end of its table."""
    table = PARAMS.replace(table_height=(-2.0, 0.0, 2.0), table_density=(0.0, 1.0, 0.0))
    instance = instantiated(made(table, tmp_path, version_of(kind)), kind, tmp_path / "unit")
    instance.enterInitializationMode()
    force = instance.getReal([FORCE])
    data = bytes(instance.serializeFMUstate(instance.getFMUstate()))
    size = ctypes.sizeof(_header.asperity_params)
    start = data.index(struct.pack("<Qd", size, PARAMS.composite_modulus))
    length = start + _header.asperity_params.table_length.offset
    assert struct.unpack_from("<Q", data, length) == (3,)
    forged = [(length, "<Q", wrong) for wrong in (0, 2, 4, 256, 2**63)]
    forged += [(start, "<Q", wrong) for wrong in (0, size + 8, 2**40)]
    forged += [(start + size, "<i", wrong) for wrong in (0, 3, 64, -1, 16 if kind in (FMU2Model, FMU3Model) else 4)]
    for place, form, wrong in forged:
        changed = bytearray(data)
        struct.pack_into(form, changed, place, wrong)
        with pytest.raises(Exception, match="status 3"):
            instance.deSerializeFMUstate(bytes(changed))
        assert "damaged" in instance.log[-1]
    for other in (bytes([data[0] ^ 1]) + data[1:], data[:-1], data + b"0", b""):
        with pytest.raises(Exception, match="status 3"):
            instance.deSerializeFMUstate(other)
        assert "not those of a saved unit of this kind" in instance.log[-1]
    # Where a table lay in another process means nothing in this one.
    moved = bytearray(data)
    struct.pack_into("<QQ", moved, start + _header.asperity_params.table_height.offset, 8, 8)
    instance.setReal([LOAD], [3.0])
    instance.setFMUstate(instance.deSerializeFMUstate(bytes(moved)))
    assert instance.getReal([FORCE]) == force
    instance.freeInstance()


def test_directional_derivatives_of_microslip_are_those_of_the_step(contact: Any) -> None:
    """Against central differences, where some of the contact sticks and some slips."""
    length = slip_length()
    contact.begin()
    contact.move(0.9 * length)
    contact.move(0.35 * length, load=0.45)
    here, load = 0.21 * length, 0.437

    def force(displacement: float, load: float) -> float:
        contact.setReal([DISPLACEMENT, LOAD], [displacement, load])
        return float(contact.getReal([RESISTANCE])[0])

    step = 1e-5 * length
    along = (force(here + step, load) - force(here - step, load)) / (2 * step)
    by_load = (force(here, load * (1 + 1e-5)) - force(here, load * (1 - 1e-5))) / (2e-5 * load)
    force(here, load)
    stiffness, friction_force = contact.getReal([STIFFNESS, FORCE])
    assert stiffness == pytest.approx(along, rel=1e-6) and along > 0 and abs(by_load) > 1e-3 * friction_force / load
    derivatives = contact.getDirectionalDerivative
    assert derivatives([RESISTANCE], [DISPLACEMENT], [1.0])[0] == stiffness
    assert derivatives([RESISTANCE], [LOAD], [1.0])[0] == pytest.approx(by_load, rel=1e-5)
    both = derivatives([RESISTANCE, FORCE], [LOAD, DISPLACEMENT], [2.0, 3 * length])
    assert both == [
        pytest.approx(2 * by_load + 3 * length * along, rel=1e-5),
        pytest.approx(2 * law(load)[2], rel=1e-12),
    ]
    assert derivatives([STIFFNESS, FORCE], [DISPLACEMENT], [1.0]) == [0.0, 0.0]
    # What sticks stiffens as all of the contact does, also in a state whose parts are about to slip.
    with Model(PARAMS) as model:
        low, middle, high = (model.tangential_stiffness_at_load(load * (1 + part)) for part in (-1e-4, 0, 1e-4))
    assert derivatives([STIFFNESS], [LOAD], [1.0])[0] == pytest.approx(stiffness / middle * (high - low) / (2e-4 * load), rel=1e-3)
    contact.move(here, load)
    stiffness = contact.getReal([STIFFNESS])[0]
    assert derivatives([STIFFNESS], [LOAD], [1.0])[0] == pytest.approx(stiffness / middle * (high - low) / (2e-4 * load), rel=1e-3)


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_a_simulation_of_both_kinds_dissipates_the_same_work(microslip_units: dict[str, Path], fmi: str) -> None:
    """Two cycles of displacement: the second closes, and both kinds of unit give the same loop, the one a step later."""
    times = np.linspace(0, 2, 81)
    path = slip_length() * 0.8 * np.sin(2 * np.pi * times)
    given = np.array(list(zip(times, path)), dtype=[("time", float), ("displacement", float)])
    loops = {}
    for kind, lag in (("ModelExchange", 0), ("CoSimulation", 1)):
        found = simulate_fmu(
            str(microslip_units[fmi]), stop_time=2, step_size=0.025, output_interval=0.025, fmi_type=kind, input=given,
            output=["displacement", "tangential_force"],
        )  # fmt: skip
        where, force = (np.array(found[name][lag:]) for name in ("displacement", "tangential_force"))
        assert where == pytest.approx(path[: len(where)], abs=1e-6 * slip_length())
        loops[kind] = force[:80]
        assert force[50] == pytest.approx(-force[70], rel=2e-3)  # quarter periods of the second cycle
    assert loops["ModelExchange"] == pytest.approx(loops["CoSimulation"], abs=1e-6 * np.max(loops["CoSimulation"]))
    second = slice(40, 80)
    with Model(PARAMS) as model:
        amplitude = 0.8 * slip_length()
        steps = np.linspace(0, 2 * amplitude, 401)
        half = 2 * np.array([model.tangential(0.5, step / 2)[0] for step in steps])
        top = model.tangential(0.5, amplitude)[0]
        exact = 2 * np.trapezoid(half - top, steps)
    closed = np.append(loops["ModelExchange"][second], loops["ModelExchange"][40])
    work = np.trapezoid(closed, np.append(path[second], path[40]))
    assert work == pytest.approx(exact, rel=0.15)


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


def test_libcosim_runs_the_unit(units: dict[str, Path]) -> None:
    execution = CosimExecution.from_step_size(int(1e8))
    slave = execution.add_local_slave(CosimLocalSlave(fmu_path=str(units["2.0"]), instance_name="pad"))
    manipulator, observer = CosimManipulator.create_override(), CosimObserver.create_last_value()
    assert execution.add_manipulator(manipulator) and execution.add_observer(observer)
    for load in (0.5, 7.0, 60.0):
        assert manipulator.slave_real_values(slave, [LOAD], [load])
        assert execution.step()
        assert observer.last_real_values(slave, [FORCE, COEFFICIENT, SLOPE]) == law(load)


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
@pytest.mark.parametrize("kind", ["units", "microslip_units"])
def test_the_sources_inside_are_those_of_the_binary(request: pytest.FixtureRequest, tmp_path: Path, kind: str, fmi: str) -> None:
    """They compile without a warning, also with the prefix of a static unit, and have every function of the standard."""
    with zipfile.ZipFile(request.getfixturevalue(kind)[fmi]) as archive:
        archive.extractall(tmp_path)
    if shutil.which("cc") is None:
        pytest.fail("this test needs a C compiler named cc: apt-get install gcc libc6-dev")
    command = ["cc", "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Werror", "-I.", "-c", "asperity_fmu.c"]
    subprocess.run([*command, f"-DFMI{fmi[0]}_FUNCTION_PREFIX=pad_"], cwd=tmp_path / "sources", check=True, timeout=600)
    symbols = subprocess.run(
        ["nm", "-g", "--defined-only", "asperity_fmu.o"], cwd=tmp_path / "sources", capture_output=True, text=True, check=True
    )
    names = [line.split()[-1] for line in symbols.stdout.splitlines()]
    header = Path(fmpy.__file__).with_name("c-code") / f"fmi{fmi[0]}Functions.h"
    declared = rf"FMI{fmi[0]}_Export\s+fmi{fmi[0]}\w+TYPE\s+(fmi{fmi[0]}\w+);"
    standard = set(re.findall(declared, header.read_text(encoding="utf-8")))
    assert {name.removeprefix("pad_") for name in names} == standard and len(standard) > 40


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
