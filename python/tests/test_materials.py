"""The data of materials: complete, plausible, usable, and the same as the tables of docs/materials.md."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from asperity import Error, Model, Params, Warnings
from asperity.materials import INTERFACES, MATERIALS, PAIRS, Interface, Material, Pair, Range, contact


def within(value: float, bounds: Range) -> bool:
    return bounds[0] <= value <= bounds[1]


@pytest.mark.parametrize("material", MATERIALS.values(), ids=lambda material: material.name)
def test_values_lie_in_their_ranges_and_have_a_reference(material: Material) -> None:
    assert MATERIALS[material.name] is material and len(material.reference) > 40
    assert material.young_range is None or within(material.young, material.young_range)
    assert within(material.poisson, (0.05, 0.5))
    assert material.burgers_vector is None or within(material.burgers_vector, (0.2e-9, 0.6e-9))
    assert material.hardness is not None or material.hardness_range is None
    if material.hardness is not None:
        assert material.hardness < material.young / 5
        assert material.hardness_range is None or within(material.hardness, material.hardness_range)


def test_there_are_some_thirty_materials_and_most_pairs_have_a_hamaker_constant() -> None:
    assert len(MATERIALS) == 30 and len(PAIRS) == 26
    assert sum(pair.hamaker is not None for pair in PAIRS.values()) > 20


@pytest.mark.parametrize("pair", PAIRS.values(), ids=lambda pair: pair.name)
def test_works_of_adhesion_lie_in_their_ranges_and_are_what_they_are_estimated_from(pair: Pair) -> None:
    assert PAIRS[pair.name] is pair and len(pair.reference) > 40
    assert PAIRS[f"{pair.second.name}/{pair.first.name}"] is pair
    assert pair.work_of_adhesion_range is None or within(pair.work_of_adhesion, pair.work_of_adhesion_range)
    if pair.hamaker is not None:
        assert pair.work_of_adhesion == pytest.approx(pair.hamaker / (12 * math.pi * 0.165e-9**2), rel=0.02)


def test_constants_of_unlike_bodies_are_geometric_means() -> None:
    own = {"Si": 6.5, "SiO2": 6.5, "Si3N4": 16.7, "Al2O3": 15.2, "mica": 9.86, "steel": 5.0}
    for name in ("Si/Si3N4", "SiO2/Si3N4", "SiO2/Al2O3", "mica/SiO2", "mica/Si3N4", "steel/Al2O3", "steel/Si3N4"):
        pair = PAIRS[name]
        expected = math.sqrt(own[pair.first.name] * own[pair.second.name])
        assert pair.need("hamaker") / 1e-20 == pytest.approx(expected, rel=5e-3), name
    for name in ("steel/DLC", "Si/DLC"):
        pair = PAIRS[name]
        both = [PAIRS[f"{body.name}/{body.name}"].work_of_adhesion for body in (pair.first, pair.second)]
        assert pair.work_of_adhesion == pytest.approx(math.sqrt(both[0] * both[1]), rel=5e-3), name


def test_gallium_arsenide_is_the_mean_of_voigt_and_reuss() -> None:
    c11, c12, c44 = 119.0, 53.4, 59.6
    bulk = (c11 + 2 * c12) / 3
    voigt = (c11 - c12 + 3 * c44) / 5
    reuss = 5 * (c11 - c12) * c44 / (4 * c44 + 3 * (c11 - c12))
    shear = (voigt + reuss) / 2
    assert MATERIALS["GaAs"].young / 1e9 == pytest.approx(9 * bulk * shear / (3 * bulk + shear), rel=2e-3)
    assert MATERIALS["GaAs"].poisson == pytest.approx((3 * bulk - 2 * shear) / (6 * bulk + 2 * shear), rel=5e-3)


def test_what_needs_a_number_without_a_source_says_so() -> None:
    with pytest.raises(Error, match="burgers_vector: none is known of a body of PDMS/PDMS: give one"):
        PAIRS["PDMS/PDMS"].contact
    with pytest.raises(Error, match="work_of_adhesion: none is known for WC/steel: give that of your surfaces, 0 for none"):
        contact("WC", "steel")
    with pytest.raises(Error, match="hardness of WC: no source"):
        MATERIALS["WC"].need("hardness")
    assert "hardness" not in contact("WC", "steel", work_of_adhesion=0.05)


def test_a_name_that_is_not_there_is_answered_with_the_nearest() -> None:
    with pytest.raises(KeyError, match="work_of_adhesion: none is known for steel/Si: give .*; all: .*SiO2"):
        PAIRS["steel/Si"]
    with pytest.raises(KeyError, match="Stel: no material has this name; the nearest is steel; all: Si, "):
        MATERIALS["Stel"]
    with pytest.raises(KeyError, match="Au/mika: no pair has this name; the nearest is Au/mica; "):
        PAIRS["Au/mika"]
    assert MATERIALS["Gold"] is MATERIALS["Au"] and PAIRS["mica/gold"] is PAIRS["Au/mica"]
    assert contact("silica", "polysilicon", work_of_adhesion=0.1) == contact("SiO2", "Si", work_of_adhesion=0.1)
    assert PAIRS.get("steel/Si") is None and "steel/Si" not in PAIRS


def test_crystals_have_the_burgers_vectors_of_their_lattices() -> None:
    cubic = {"Si": 0.5431, "Au": 0.4078, "Al": 0.405, "Cu": 0.361, "Ag": 0.409, "Ni": 0.352, "Pt": 0.392, "Pb": 0.495,
             "diamond": 0.357, "GaAs": 0.5653}  # fmt: skip
    centred = {"steel": 0.2866, "W": 0.316, "Mo": 0.315, "Cr": 0.288, "Fe": 0.287, "Ta": 0.331}
    lattices = {name: 1e-9 * a / math.sqrt(2) for name, a in cubic.items()}
    lattices |= {name: 1e-9 * a * math.sqrt(3) / 2 for name, a in centred.items()}
    for name, length in lattices.items():
        assert MATERIALS[name].burgers_vector == pytest.approx(length, rel=3e-3)


def test_mica_follows_from_its_stiffnesses() -> None:
    # Vaughan and Guggenheim, in GPa; means over the two directions of the plane.
    c11, c33, c12, c13 = (181.0 + 178.4) / 2, 58.6, 48.8, (25.6 + 21.2) / 2
    mica = MATERIALS["mica"]
    assert mica.young / 1e9 == pytest.approx(c33 - 2 * c13**2 / (c11 + c12), rel=0.01)
    assert mica.poisson == pytest.approx(c13 / (c11 + c12), rel=0.03)


WITH_CONTACT = [pair for pair in PAIRS.values() if pair.name != "PDMS/PDMS"]


def test_a_pair_of_ones_own_keeps_its_numbers_but_not_other_bodies() -> None:
    own = replace(PAIRS["Si/Si"], work_of_adhesion=0.1, slip_stress_1=0.01)
    assert own.contact == PAIRS["Si/Si"].contact | {"work_of_adhesion": 0.1, "slip_stress_1": 0.01}
    with pytest.raises(Error, match="Si: is none of asperity.materials.MATERIALS: give E1, nu1, E2, nu2"):
        replace(own, first=replace(own.first, young=1e9)).contact


def test_a_measured_slip_stress_takes_the_place_of_the_default() -> None:
    measured = {name: Params.si(**pair.contact, height_std=2e-9, summit_radius=2e-6, asperity_count=1e5).slip_stress_1
                for name, pair in ((pair.name, pair) for pair in WITH_CONTACT)}  # fmt: skip
    assert measured.pop("mica/Au") == 0.0108
    assert set(measured.values()) == {1 / 43}


STRONG = [one for one in INTERFACES.values() if one.shear_strength is not None]


@pytest.mark.parametrize("interface", INTERFACES.values(), ids=lambda interface: interface.name)
def test_an_interface_has_a_strength_or_a_friction_coefficient_and_a_source(interface: Interface) -> None:
    assert INTERFACES[interface.name] is interface and len(interface.name) < 48
    assert (interface.shear_strength is None) != (interface.friction_coefficient is None)
    assert within(interface.shear_strength or 1e6, (1e4, 1e9)) and within(interface.friction_coefficient or 0.1, (1e-3, 10.0))
    assert interface.pressure_coefficient is None or interface.shear_strength is not None
    assert interface.load is None or interface.friction_coefficient is not None
    assert interface.source in ("read", "quoted") and interface.conditions and len(interface.reference) > 20


@pytest.mark.parametrize("interface", STRONG, ids=lambda interface: interface.name)
def test_an_interface_gives_its_strength_times_the_area(interface: Interface) -> None:
    rough: dict[str, Any] = {"height_std": 0.4e-6, "summit_radius": 20e-6, "asperity_count": 5e5}
    params = Params.si(**contact("steel", "steel", work_of_adhesion=0.0), **rough)
    found = params.with_interface(interface.name)
    strength_of = {name: getattr(params, name) for name in ("slip_stress_1", "slip_stress_2", "pressure_coefficient")}
    assert found.replace(**strength_of) == params
    with Model(found) as model:
        state = model.state_at_load(10.0)
    kappa = interface.pressure_coefficient or 0.0
    strength = interface.shear_strength or 0.0
    assert state.friction_force == pytest.approx(strength * state.real_area + kappa * 10.0, rel=1e-12)
    assert not state.warnings & Warnings.UNCALIBRATED


def test_an_interface_that_cannot_be_taken_says_what_to_do() -> None:
    params = Params.dimensionless(alpha=0.01, beta=1000, gamma=0)
    with pytest.raises(Error, match="effective_shear_modulus = 2: must be in Pa and above the strength of the interface"):
        params.with_interface("graphite layers")
    steel = Params.si(**PAIRS["steel/steel"].contact, height_std=1e-7, summit_radius=1e-5, asperity_count=1e5)
    told = "only a friction coefficient of 0.57 at 12 N .*: for surfaces like these calibrate with a friction force of 0.57 times the load"
    with pytest.raises(Error, match=told):
        steel.with_interface("steel/steel dry")
    with pytest.raises(Error, match="graphite: no interface has this name; the nearest is graphi"):
        steel.with_interface("graphite")
    with pytest.raises(KeyError, match="graphite: no interface has this name; the nearest is .*; all: MoS2 film in dry air, "):
        INTERFACES["graphite"]


def test_data_cannot_be_changed() -> None:
    with pytest.raises(TypeError):
        MATERIALS["wood"] = MATERIALS["Si"]  # type: ignore[index]
    contact = PAIRS["Si/Si"].contact
    contact["E1"] = -1.0
    with pytest.raises(Error, match="E1 = -1"):
        Params.si(**contact, height_std=2e-9, summit_radius=2e-6, asperity_count=1e5)
    assert PAIRS["Si/Si"].contact["E1"] == MATERIALS["Si"].young


# ---- The page ----


def scaled(value: float | None, bounds: Range | None, unit: float) -> str:
    if value is None:
        return ""
    if bounds is None:
        return f"{value / unit:.4g}"
    low, high = (f"{bound / unit:.4g}" for bound in bounds)
    return f"{value / unit:.4g} ({low}–{high})"


def material_row(material: Material) -> str:
    cells = [
        material.name,
        scaled(material.young, material.young_range, 1e9),
        f"{material.poisson:g}",
        scaled(material.hardness, material.hardness_range, 1e9),
        "" if material.burgers_vector is None else f"{material.burgers_vector / 1e-9:.4g}",
    ]
    return f"| {' | '.join(cells)} |"


def pair_row(pair: Pair) -> str:
    return f"| {pair.name} | {scaled(pair.work_of_adhesion, pair.work_of_adhesion_range, 1e-3)} |"


def interface_row(interface: Interface) -> str:
    strength, kappa, load = interface.shear_strength, interface.pressure_coefficient, interface.load
    if strength is None:
        measured = f"μ = {interface.friction_coefficient:.4g}" + ("" if load is None else f" at {load:.4g} N")
    else:
        measured = f"{strength / 1e6:.4g} MPa" + ("" if kappa is None else f", κ = {kappa:.4g}")
    return f"| {interface.name} | {measured} |"


def test_the_page_has_the_numbers_of_the_data(root: Path) -> None:
    tables = (root / "docs" / "materials.md").read_text(encoding="utf-8").partition("\n## Materials\n")[2]
    rows = [line for line in tables.splitlines() if line.startswith("| ")]
    found = [row for row in rows if not row.startswith(("| Material ", "| Pair ", "| Interface "))]
    expected = [*map(material_row, MATERIALS.values()), *map(pair_row, PAIRS.values()), *map(interface_row, INTERFACES.values())]
    assert found == expected
