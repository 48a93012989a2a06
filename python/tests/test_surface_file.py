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
from asperity.materials import MATERIALS, PAIRS

SurfaceFile = Callable[[str], Path]

# Hard carbon on hard carbon, as in docs/solvers.md.
CONTACT: dict[str, Any] = {
    "work_of_adhesion": 0.06,
    "adhesion_range": 0.25e-9,
    "burgers_vector": 0.25e-9,
    "hardness": 51e9,
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


def test_iso_values_are_those_of_from_iso25178(surface_file: SurfaceFile) -> None:
    iso: dict[str, Any] = {"Sq": 9.8e-9, "Sdq": 0.06, "Sds": 6e12, "Ssk": 0.1, "Sku": 3.2}
    text = f"nominal_area = 1e-6\n{toml(CONTACT)}[materials]\n{toml(BODIES)}[roughness]\n{toml(iso)}"
    expected = Params.from_iso25178(**iso, **BODIES, **CONTACT, nominal_area=1e-6)
    assert Params.from_toml(surface_file(text)) == expected
    assert expected.height_distribution == "johnson"


def test_named_materials_bring_what_is_known_of_the_pair(surface_file: SurfaceFile) -> None:
    rough = f"[roughness]\n{toml(MOMENTS)}"
    found = Params.from_toml(surface_file(f'nominal_area = 1e-6\n[materials]\nfirst = "Si"\nsecond = "Si"\n{rough}'))
    assert found == Params.from_spectral_moments(**MOMENTS, **PAIRS["Si/Si"].contact, nominal_area=1e-6)
    text = f'nominal_area = 1e-6\nwork_of_adhesion = 0.1\n[materials]\nfirst = "Si3N4"\nsecond = "mica"\n{rough}'
    found = Params.from_toml(surface_file(text))  # either order; the file has the last word
    assert (found.work_of_adhesion, found.burgers_vector) == (0.1, MATERIALS["mica"].burgers_vector)
    # No such pair is in the table: the bodies are known, their adhesion is not.
    text = f'nominal_area = 1e-6\nwork_of_adhesion = 0\n[materials]\nfirst = "Si"\nsecond = "Au"\n{rough}'
    found = Params.from_toml(surface_file(text))
    assert found.hardness == min(MATERIALS[name].hardness or 0 for name in ("Si", "Au"))
    assert found.burgers_vector == max(MATERIALS[name].need("burgers_vector") for name in ("Si", "Au"))
    with pytest.raises(Error, match="work_of_adhesion: none is known for Si/Au: give that of your surfaces, 0 for none"):
        Params.from_toml(surface_file(text.replace("work_of_adhesion = 0\n", "")))
    # A name for one body, numbers for the other, which is rigid.
    text = f'nominal_area = 1e-6\n{toml(CONTACT)}[materials]\nfirst = "Si"\nE2 = inf\nnu2 = 0.3\n{rough}'
    silicon = MATERIALS["Si"]
    assert Params.from_toml(surface_file(text)) == Params.from_spectral_moments(
        **MOMENTS, **CONTACT, E1=silicon.young, nu1=silicon.poisson, E2=math.inf, nu2=0.3, nominal_area=1e-6
    )


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


def test_heights_are_chosen_as_in_si(surface_file: SurfaceFile) -> None:
    assert Params.from_toml(surface_file("skew = -0.5\n" + WHOLE)) == FIELDS.replace(skew=-0.5)
    both = "skew = -0.5\nkurtosis = 4\n"
    assert Params.from_toml(surface_file(both + WHOLE)) == FIELDS.replace(skew=-0.5, kurtosis=4.0)
    with pytest.raises(Error, match="line 2: skew = -0.5: must be 0 unless heights are Johnson's"):
        Params.from_toml(surface_file('height_distribution = "gaussian"\n' + both + WHOLE))


@pytest.mark.parametrize(
    "text, message",
    [
        (WHOLE.replace("hardness", "hardnes"), "hardnes: no such key; the nearest is hardness"),
        (WHOLE.replace("E2", "e2"), r"\[materials\] e2: no such key; the nearest is E2"),
        (WHOLE.replace("m4", "M_4"), r"\[roughness\] M_4: no such key; the nearest is m4"),
        (WHOLE.replace("[roughness]", "[roughnes]"), r"line 11: \[roughnes\]: no such table; there are \[materials\] and \[roughness\]"),
        (WHOLE.replace("nominal_area = 1e-6\n", ""), "nominal_area: must be set"),
        (WHOLE.replace("m4", "Sq"), r"\[roughness\] Sq: is not for spectral moments, as m0 is"),
        (WHOLE.replace("m2 = ", "# "), r"\[roughness\] m2: must be set"),
        (WHOLE.replace("nu2 = 0.25\n", ""), "so nu2 must be set there"),
        (WHOLE.replace("nu2 = 0.25", "nu2 = 0.6"), "nu2 = 0.6: must be > -1 and <= 0.5"),
        (WHOLE.replace("51000000000.0", "true"), "hardness = true: must be a number"),
        (WHOLE.replace("51000000000.0", '"hard"'), 'hardness = "hard": must be a number'),
        ("height_std = 1e-9\n" + WHOLE, r"height_std: \[roughness\] sets it already"),
        ("composite_modulus = 1e11\n" + WHOLE, r"composite_modulus: \[materials\] sets it already"),
        ("contact_law = \"plastic\"\n" + WHOLE, 'contact_law = "plastic": must be "maugis" or "elastic-plastic"'),
        (WHOLE.replace("E1 = 493000000000.0\n", 'first = "Stahl"\n').replace("nu1", "# "), "Stahl: no material has this name; the nearest is steel"),
        (WHOLE.replace("E1 =", 'first = "Si"\nE1 ='), "E1: first sets it already"),
        ("materials = 3\n", r"materials = 3: must be a table, \[materials\]"),
        ("height_std = 1e-9\n", "composite_modulus: must be set"),
        ("height_std = \n", "line 1: height_std: has no value"),
    ],
)
def test_what_is_wrong_is_named_with_the_file(surface_file: SurfaceFile, text: str, message: str) -> None:
    path = surface_file(text)
    with pytest.raises(Error, match=message) as caught:
        Params.from_toml(path)
    assert str(caught.value).startswith(f"{path}: ")


def test_a_file_in_another_encoding_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "surface.toml"
    path.write_bytes(b'height_distribution = "gau\xdfian"\n')
    with pytest.raises(Error, match="UTF-8"):
        Params.from_toml(path)


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


def test_a_measurement_on_another_surface_is_a_comment(tmp_path: Path) -> None:
    changed = FIELDS.calibrated(1e-3, 0.4).replace(height_std=2 * FIELDS.height_std)
    assert "# The strength was calibrated on other surfaces" in changed.to_text()
    changed.to_toml(tmp_path / "surface.toml")
    assert Params.from_toml(tmp_path / "surface.toml") == changed.replace(slip_stress_1=changed.slip_stress_1)


def test_one_measured_point_sets_the_strength(surface_file: SurfaceFile) -> None:
    head, tables = WHOLE.split("[", 1)
    for measured in ("calibration_friction_coefficient = 0.4", "calibration_friction_force = 4e-4"):
        params = Params.from_toml(surface_file(f"{head}calibration_load = 1e-3\n{measured}\n[{tables}"))
        with Model(params) as model:
            assert model.state_at_load(1e-3).friction_force == pytest.approx(4e-4, rel=1e-12)
            assert not model.state_at_load(1e-3).warnings & Warnings.UNCALIBRATED
    for alone in ("calibration_load = 1.0", "calibration_friction_force = 1.0"):
        with pytest.raises(Error, match="calibration_load: must be given together with calibration_friction_coefficient or"):
            Params.from_toml(surface_file(f"{head}{alone}\n[{tables}"))
    weak = "pressure_coefficient = 0.5\ncalibration_load = 1e-3\ncalibration_friction_coefficient = 0.4"
    with pytest.raises(Error, match="must be above 0.0005.*, which pressure_coefficient alone gives"):
        Params.from_toml(surface_file(f"{head}{weak}\n[{tables}"))


def test_the_mean_deviation_stands_for_the_standard_one(surface_file: SurfaceFile) -> None:
    ra = 0.8e-9
    m0 = math.pi / 2 * ra**2
    head = f"nominal_area = 1e-6\n{toml(CONTACT)}[materials]\n{toml(BODIES)}[roughness]\nRa = {ra}\n"
    rest: dict[str, Any] = {"m2": 1e-4, "m4": 5e10}
    expected = Params.from_spectral_moments(m0=m0, **rest, **BODIES, **CONTACT, nominal_area=1e-6)
    found = Params.from_toml(surface_file(head + toml(rest)))
    assert found.height_std == pytest.approx(expected.height_std, rel=1e-14)
    assert found.summit_radius == pytest.approx(expected.summit_radius, rel=1e-14)
    iso: dict[str, Any] = {"Sdq": 0.01, "Sds": 5e12}
    expected = Params.from_iso25178(Sq=math.sqrt(m0), **iso, **BODIES, **CONTACT, nominal_area=1e-6)
    assert Params.from_toml(surface_file(head + toml(iso))).height_std == pytest.approx(expected.height_std, rel=1e-14)
    for name, value in {"Sq": 1e-9, "Ssk": 0.1}.items():
        with pytest.raises(Error, match=f"Ra: must not be given together with {name}, "):
            Params.from_toml(surface_file(head + toml(iso | {name: value})))
    with pytest.raises(Error, match="Ra = -1: must be finite and > 0"):
        Params.from_toml(surface_file(head.replace(f"Ra = {ra}", "Ra = -1") + toml(iso)))


def test_a_file_without_end_is_refused(surface_file: SurfaceFile) -> None:
    with pytest.raises(Error, match="/dev/zero: must be a file with a surface"):
        Params.from_toml("/dev/zero")
    longest = WHOLE.replace("[materials]", f"#{(2**20 - len(WHOLE.encode()) - 2) * 'x'}\n[materials]")
    assert Params.from_toml(surface_file(longest)) == FIELDS
    with pytest.raises(Error, match="longer than 1 MiB"):
        Params.from_toml(surface_file(longest + "\n"))


def test_an_interface_is_taken_by_its_name(surface_file: SurfaceFile) -> None:
    plain = Params.from_toml(surface_file(WHOLE))
    named = 'interface = "KCl film on iron in vacuum"\n'
    found = Params.from_toml(surface_file(named + WHOLE))
    assert found == plain.with_interface("KCl film on iron in vacuum") and found.pressure_coefficient == 0.14
    # A measured point scales the strength, and kappa is that of the interface.
    point = "calibration_load = 1e-3\ncalibration_friction_coefficient = 0.4\n"
    assert Params.from_toml(surface_file(point + named + WHOLE)) == found.calibrated(1e-3, 0.4)
    for text, message in (
        (named + "slip_stress_1 = 0.01\n", "slip_stress_1: interface sets it already, leave one out"),
        ('interface = "KCl"\n', "KCl: no interface has this name; docs/materials.md lists them"),
        ("interface = 3\n", "interface = 3: must be the name of an interface"),
        ('interface = "Al/Al clean"\n', "Al/Al clean: its shear strength is not known, only a friction coefficient of 1.05 "),
    ):
        with pytest.raises(Error, match=message):
            Params.from_toml(surface_file(text + WHOLE))
