"""A surface file makes the parameters that its keys say, and says by name what is wrong with it."""

from __future__ import annotations

import math
import re
import subprocess
from pathlib import Path
from typing import Any, Callable

import pytest
from test_docs import blocks, shows

from asperity import Error, Model, Params, Warnings, _library

SurfaceFile = Callable[[str], Path]

# Hard carbon on hard carbon, as in docs/solvers.md.
CONTACT: dict[str, Any] = {
    "work_of_adhesion": 0.06,
    "adhesion_range": 0.25e-9,
    "burgers_vector": 0.25e-9,
    "hardness": 51e9,
    "slip_stress_1": 0.023255814,
    "slip_stress_2": 0.00077519380,
}
BODIES: dict[str, Any] = {"E1": 493e9, "nu1": 0.25, "E2": 493e9, "nu2": 0.25}
MOMENTS: dict[str, Any] = {"m0": 9.604e-17, "m2": 1.8e-3, "m4": 3.3736e11}
ROUGH: dict[str, Any] = {"Sq": 9.8e-9, "Sdq": 0.06}


def toml(table: dict[str, Any]) -> str:
    return "".join(f"{name} = {value!r}\n" for name, value in table.items())


WHOLE = f"nominal_area = 1e-6\n{toml(CONTACT)}[materials]\n{toml(BODIES)}[roughness]\n{toml(MOMENTS)}"
FIELDS = Params.from_spectral_moments(**MOMENTS, **BODIES, **CONTACT, nominal_area=1e-6)
# As on docs/solvers.md.
PAGE = Params.from_iso25178(**ROUGH, **BODIES, **CONTACT, nominal_area=1e-6)


@pytest.fixture
def surface_file(tmp_path: Path) -> SurfaceFile:
    def written(text: str) -> Path:
        path = tmp_path / "surface.toml"
        path.write_text(text, encoding="utf-8")
        return path

    return written


def test_materials_and_moments_are_those_of_the_setters(surface_file: SurfaceFile) -> None:
    path = surface_file(WHOLE)
    assert Params.from_toml(path) == Params.from_toml(str(path)) == FIELDS


@pytest.mark.parametrize(
    "params",
    [
        FIELDS,
        FIELDS.replace(skew=-0.5),
        FIELDS.replace(skew=-0.5, kurtosis=4.0),
        FIELDS.replace(table_height=(-1.0, 0.0, 2.0), table_density=(0.0, 1.0, 0.25)),
        FIELDS.replace(skew=-0.5).replace(height_distribution="gaussian"),
        FIELDS.replace(max_friction_coefficient=math.inf, attraction=False, radius_amplitude=0.1 + 0.2),
        FIELDS.replace(work_of_adhesion=0.0, contact_law="elastic-plastic", tangential_modulus=1e11),
        FIELDS.calibrated(1e-3, 0.4, error=0.1),
    ],
)
def test_a_file_that_was_written_reads_as_equal_parameters(params: Params, tmp_path: Path) -> None:
    path = tmp_path / "surface.toml"
    params.to_toml(path)
    assert Params.from_toml(path) == params


@pytest.mark.parametrize(
    "text, message",
    [
        (WHOLE.replace("hardness", "hardnes"), "hardnes: no such key; the nearest is hardness"),
        ("height_std = \n", "line 1: height_std: has no value"),
    ],
)
def test_what_is_wrong_is_named_with_the_file(surface_file: SurfaceFile, text: str, message: str) -> None:
    path = surface_file(text)
    with pytest.raises(Error, match=message) as caught:
        Params.from_toml(path)
    assert str(caught.value).startswith(f"{path}: ")


def test_the_page_has_this_surface(surface_file: SurfaceFile, root: Path) -> None:
    blocks = re.findall(r"```toml\n(.*?)```", (root / "docs" / "solvers.md").read_text(encoding="utf-8"), re.DOTALL)
    assert [Params.from_toml(surface_file(block)) for block in blocks] == [PAGE]


def test_the_example_is_in_the_domain_of_the_model(surface_file: SurfaceFile) -> None:
    with Model(Params.from_toml(surface_file(WHOLE))) as model:
        for pressure in (2e3, 70e6):
            state = model.state_at_load(pressure * 1e-6)
            assert state.contacting >= 20 and not state.warnings & ~Warnings.UNCALIBRATED


@pytest.fixture
def reader(root: Path, compile_c: Callable[..., None], tmp_path: Path) -> Callable[[], subprocess.CompletedProcess[str]]:
    """The program in C of the page, which reads surface.toml."""
    (source,) = re.findall(r"```c\n(.*?)```", (root / "docs" / "solvers.md").read_text(encoding="utf-8"), re.DOTALL)
    (tmp_path / "reader.c").write_text(source, encoding="utf-8")
    library = Path(_library.PATH)
    strict = ("-std=c11", "-Wall", "-Wextra", "-Werror")
    compile_c(*strict, tmp_path / "reader.c", "-I", root / "include", "-o", tmp_path / "reader", library,
              f"-Wl,-rpath,{library.parent}")  # fmt: skip
    return lambda: subprocess.run([tmp_path / "reader"], cwd=tmp_path, capture_output=True, text=True, timeout=600, check=False)


def test_a_program_in_c_has_the_surface_of_the_file(
    reader: Callable[[], subprocess.CompletedProcess[str]], root: Path, tmp_path: Path
) -> None:
    page = root / "docs" / "solvers.md"
    ((before, printed),) = ((i, text) for i, (kind, text) in enumerate(blocks(page)) if kind == "text")
    mccool = Params.from_spectral_moments(**MOMENTS, **BODIES, **CONTACT, nominal_area=1e-6, summits="mccool")
    table = FIELDS.replace(table_height=(0.0, 1.0, 2.0), table_density=(0.0, 1.0, 0.0))
    for params in (PAGE, FIELDS.elastic_plastic(30e9), mccool, FIELDS.replace(skew=0.4), FIELDS.replace(attraction=False), table):
        params.to_toml(tmp_path / "surface.toml")
        with Model(params) as model:
            expected = [f"{load:.0e} N: mu = {model.friction_at_load(load):.4f}" for load in (1e-3, 1e-2, 1e-1, 1.0)]
        assert reader().stdout.splitlines() == expected
        if params is PAGE:
            shows(page, before, printed, "\n".join([*expected, ""]))
    (tmp_path / "surface.toml").write_text("hight_std = 3\n", encoding="utf-8")
    done = reader()
    assert done.returncode == 1 and done.stderr == "surface.toml: line 1: hight_std: no such key; the nearest is height_std\n"


def test_a_text_changes_what_it_gives(surface_file: SurfaceFile) -> None:
    assert Params.from_text(WHOLE) == FIELDS and Params.from_text(FIELDS.to_text()) == FIELDS
    assert Params.from_text('height_std = 2e-9\ncontact_law = "maugis"\n', start=FIELDS) == FIELDS.replace(height_std=2e-9)
    with pytest.raises(Error, match="^composite_modulus: must be set; two materials set it"):
        Params.from_text("height_std = 2e-9\n")
    with pytest.raises(Error, match=r"surface.toml: composite_modulus: must be set; two materials set it"):
        Params.from_toml(surface_file("height_std = 2e-9\n"))


def test_a_file_without_end_is_refused(surface_file: SurfaceFile) -> None:
    with pytest.raises(Error, match="/dev/zero: must be a file with a surface"):
        Params.from_toml("/dev/zero")
    longest = WHOLE.replace("[materials]", f"#{(2**20 - len(WHOLE.encode()) - 2) * 'x'}\n[materials]")
    assert Params.from_toml(surface_file(longest)) == FIELDS
    with pytest.raises(Error, match="longer than 1 MiB"):
        Params.from_toml(surface_file(longest + "\n"))


def test_an_interface_is_taken_by_its_name(surface_file: SurfaceFile) -> None:
    plain = Params.from_toml(surface_file(WHOLE))
    without = re.sub("slip_stress.*\n", "", WHOLE)
    named = 'interface = "KCl film on iron in vacuum"\n'
    found = Params.from_toml(surface_file(named + without))
    assert found == plain.with_interface("KCl film on iron in vacuum") and found.pressure_coefficient == 0.14
    # A measured point scales the strength, and kappa is that of the interface.
    point = "calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4\n"
    assert Params.from_toml(surface_file(point + named + without)) == found.calibrated(1e-3, 0.4)
    for text, message in (
        (named + "pressure_coefficient = 0.01\n", "pressure_coefficient: interface sets it already, leave one out"),
        ('interface = "KCl"\n', "KCl: no interface has this name; docs/materials.md lists them"),
        ("interface = 3\n", "interface = 3: must be the name of an interface"),
    ):
        with pytest.raises(Error, match=message):
            Params.from_toml(surface_file(text + without))
