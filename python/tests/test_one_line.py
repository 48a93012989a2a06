"""`asperity.friction`: the library's estimate of the text that the arguments make, in what Python has."""

from __future__ import annotations

import math
import re
import sys
from itertools import chain
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pandas
import pytest

import asperity
from asperity import Error, Estimate, Model, Params, ValidityWarning, friction
from asperity._surface_text import KEYS, Roughness, Surface, text_of
from asperity.materials import PAIRS, contact

# Nobody measured the strength of these interfaces, and they say so.
pytestmark = pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
KNOWN: dict[str, Any] = {"work_of_adhesion": 0.063, "known_to": {"slope": 1}}
ROUGH: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.05, "Sds": 1e13}
# Hurtado and Kim's strength, as the parameters have it.
CLEAN: dict[str, Any] = {"slip_stress_1": 1 / 43, "slip_stress_2": 1 / 1290}
LOADS = np.geomspace(1e-2, 1.0, 5)
MEASURED: dict[str, Any] = {"calibration_load": 1e5, "calibration_friction_coefficient": 0.3}
GROUND: dict[str, Any] = {"pair": "steel/steel", "process": "ground", "nominal_area": 1e-4}


def test_ground_steel_at_another_load_than_the_measured_one() -> None:
    found = friction("steel/steel", Ra=0.8e-6, process="ground", nominal_area=1e-4, load=10.0, measured=(1000, 0.16))
    assert f"{found:.3f}" == "0.173 (0.108 to 0.279)" and found.strength == "measured"
    assert found.rests_on[0] == "strength of the interface: measured here, 0.16 at 1000 N to 5 %"
    assert found.narrow[0].startswith("a second measured point at 10 N (9")
    assert sum(found.shares.values()) == pytest.approx(1) and found.shares["model"] > 0.85 and found.error_growth == 1.0
    assert 0.25 < found.constant_odds < 0.4 and found.curve == pytest.approx(found.value, rel=2e-3)
    # Of the stiffness nothing was measured.
    for band in (found.stiffness, found.normal_stiffness, found.contact_radius_sum):
        assert 1.5 * band.low < band.value < band.high / 1.5
    assert found.stiffness.value == pytest.approx(Model(found.params).tangential_stiffness_at_load(10.0), rel=1e-6)
    assert found.force == pytest.approx(10 * found.value)


def test_it_is_the_friction_of_the_model() -> None:
    with Model(Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1e-6)) as model:
        assert friction("Si/Si", **ROUGH, **CLEAN, load=1e-2, nominal_area=1e-6).curve == pytest.approx(model.friction_at_load(1e-2), rel=3e-6)
        found = friction(PAIRS["Si/Si"], **ROUGH, **CLEAN, load=LOADS, nominal_area=1e-6).curve
        assert found == pytest.approx(model.friction_at_load(LOADS), rel=3e-6)


def test_without_an_area_loads_are_pressures() -> None:
    by_pressure = friction("Si/Si", **ROUGH, load=1e5).value
    assert by_pressure == pytest.approx(friction("Si/Si", **ROUGH, load=1e-1, nominal_area=1e-6).value, rel=1e-9)
    # ... and are called so.
    found = friction("steel/steel", process="ground", Ra=0.8e-6, load=1e5, measured=(1e7, 0.16))
    assert found.unit == "Pa" and str(found).startswith("mu(100000 Pa) = 0.173") and " N" not in str(found)
    assert found.rests_on[1] == "loads are nominal pressures in Pa: no nominal_area was given"
    assert found.plot().axes[0].get_xlabel() == "nominal pressure $p$ [Pa]" and math.isnan(found.contacts)
    assert friction("Si/Si", **ROUGH, load=0.1, nominal_area=1.0).unit == "N"


@pytest.mark.parametrize("pair", sorted(set(PAIRS) - {"PDMS/PDMS"}))
def test_a_model_of_an_estimate_has_its_friction_its_strength_and_its_law(pair: str) -> None:
    for given in ({"Ra": 0.8e-6}, {"measured": (1.0, 0.2)}, {"measured": [(1.0, 0.2), (100.0, 0.17)]}):
        found = friction(pair, process="ground", nominal_area=1e-4, load=[0.5, 50.0], **given)
        params = Params.from_text(found.surface)
        assert params == found.params
        with Model(params) as model:
            assert model.friction_at_load([0.5, 50.0]) == pytest.approx(found.curve, rel=3e-6)
        yields = any(line.startswith("asperities yield") for line in found.rests_on)
        assert (params.contact_law == "elastic-plastic") == yields
        assert (params.calibration_load == 1.0) == (given.get("measured") == (1.0, 0.2))


def test_roughness_is_taken_in_several_forms() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0)
    m2 = ROUGH["Sdq"] ** 2 / 2
    moments = {"m0": ROUGH["Sq"] ** 2, "m2": m2, "m4": 6 * math.pi * 3**0.5 * m2 * ROUGH["Sds"]}
    expected = friction("Si/Si", **ROUGH, load=1e5).value
    assert friction("Si/Si", **moments, load=1e5).value == pytest.approx(expected, rel=1e-9)
    mean = {**ROUGH, "Ra": ROUGH["Sq"] * math.sqrt(2 / math.pi)}
    del mean["Sq"]
    assert friction("Si/Si", **mean, load=1e5).value == pytest.approx(expected, rel=1e-9)
    summits: dict[str, Any] = {"height_std": params.height_std, "summit_radius": params.summit_radius, "summit_density": params.asperity_count}
    radii: dict[str, Any] = {"radius_amplitude": params.radius_amplitude, "radius_rate": params.radius_rate}
    assert friction("Si/Si", **summits, **radii, load=1e5).value == pytest.approx(expected, rel=1e-6)
    two = friction("Si/Si", Rq=np.array([5e-9, 4e-9]), RSm=[600e-9, 900e-9], load=1e5)
    assert two.value != friction("Si/Si", Rq=5e-9, RSm=600e-9, load=1e5).value


def model_of(contact_of: dict[str, Any]) -> Params:
    return Params.from_iso25178(**contact_of, **ROUGH, nominal_area=1.0)


def model_friction(params: Params) -> float:
    with Model(params) as model:
        found: float = model.friction_at_load(1e5)
    return found


def test_moduli_of_ones_own_replace_those_of_a_pair_or_stand_alone() -> None:
    rough: dict[str, Any] = {"Ra": 0.8e-6, "process": "ground", "nominal_area": 1e-4, "measured": (1000, 0.16), "load": [10.0, 100.0]}
    steel = friction("steel/steel", **rough)
    alike: dict[str, Any] = {"E1": 205e9, "nu1": 0.3, "E2": 205e9, "nu2": 0.3}
    assert (friction("steel/steel", **rough, **alike).value == steel.value).all()
    soft = friction("steel/steel", **rough, E1=100e9, E2=100e9, hardness=2e9)
    assert soft.params.composite_modulus == pytest.approx(100e9 / 0.91 / 2) and (soft.value != steel.value).all()
    assert not [line for line in soft.rests_on if line.startswith(("E = ", "hardness = "))]
    known = {name: value for name, value in PAIRS["steel/steel"].contact.items() if name in ("burgers_vector", "adhesion_range", "hardness")}
    alone = friction(**rough, **alike, **known, work_of_adhesion=0.0)
    assert alone.value == pytest.approx(steel.value, rel=1e-5) and alone.params.contact_law == "elastic-plastic"
    moduli = {name: getattr(steel.params, name) for name in ("composite_modulus", "effective_shear_modulus")}
    assert friction(**rough, **moduli, **known, work_of_adhesion=0.0).value == pytest.approx(steel.value, rel=1e-5)
    # The same text has the same law, whoever reads it.
    params = Params.from_text(steel._text)
    assert params.contact_law == steel.params.contact_law and Model(params).friction_at_load(10.0) == pytest.approx(steel.curve[0], rel=3e-6)


def test_two_bodies_without_a_pair_adhere_as_bodies_do() -> None:
    found = friction("SiC/WC", **ROUGH, **CLEAN, load=1e5)
    assert found.params.work_of_adhesion == 0.05 and "none is known of SiC/WC, or none" in found.text
    expected = model_friction(model_of(contact("SiC", "WC", work_of_adhesion=0.05)))
    assert friction("SiC/WC", **ROUGH, **CLEAN, load=1e5, work_of_adhesion=0.05).curve == pytest.approx(expected, rel=3e-6)
    # Metal that yields asks for none, whether by name or by number.
    rough: dict[str, Any] = {"Ra": 0.8e-6, "process": "ground", "nominal_area": 1e-4, "load": 100.0}
    for pair, value in (("Al-6061/steel", 0.61), ("Al-6061/Al-6061", 1.05), ("stainless/steel", 0.49)):
        found = friction(pair, **rough)
        assert found.value == pytest.approx(value, rel=0.05) and found.strength == "table", pair
        assert "the alloy itself was not measured" in found.text
    bodies: dict[str, Any] = {"E1": 70e9, "nu1": 0.33, "E2": 205e9, "nu2": 0.3, "hardness": 1e9, "burgers_vector": 0.286e-9}
    assert friction(**bodies, **rough, measured=(100, 0.6)).params.work_of_adhesion == 0.0


def test_an_interface_brings_its_strength() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5, interface="Al2O3/Si in air", work_of_adhesion=0.063, known_to={"slope": 1}, model_error=0)
    expected = model_friction(model_of(PAIRS["Si/Si"].contact).with_interface("Al2O3/Si in air"))
    assert found.value == pytest.approx(expected, rel=1e-5) and found.strength == "table"
    assert found.high / found.value == pytest.approx(3.0, rel=1e-4)
    assert found.rests_on[0].startswith("strength of the interface: from Al2O3/Si in air of the table of interfaces")
    dry = friction(**GROUND, Ra=0.8e-6, load=12.0, interface="steel/steel dry")
    assert dry.value == pytest.approx(0.57, rel=1e-6)


def test_another_roughness_keeps_the_strength_in_pascal() -> None:
    """A steeper surface has less area and so less friction; without the specimen's roughness nothing would change."""
    rough: dict[str, Any] = {"pair": "steel/steel", "nominal_area": 1e-4, "measured": (1000, 0.16), "load": 1000.0, "hardness": 20e9}
    same: Any = {"Ra": 0.2e-6, "RSm": 80e-6}
    plain = friction(**rough, **same)
    assert plain.value == pytest.approx(0.16, rel=1e-3)
    assert friction(**rough, **same, measured_on=same).value == pytest.approx(0.16, rel=1e-3)
    other = friction(**rough, Ra=0.1e-6, RSm=80e-6, measured_on=same)
    assert other.value > 0.25 and other.high / other.low > plain.high / plain.low and other.shares["slope"] > 0.1 and other.shares["model"] > 0.5
    assert other.curve == pytest.approx(other.value, rel=0.1)
    with Model(Params.from_text(other.surface)) as model:
        assert model.friction_at_load(1000.0) == pytest.approx(other.curve, rel=3e-6)


def test_a_pair_that_was_measured_elsewhere_begins_with_that() -> None:
    found = friction(**GROUND, Ra=0.8e-6, load=10.0)
    assert str(found).startswith("measured on other specimens: steel/steel dry 0.57 at 12 N; ")
    assert 0.3 < found.value < 0.8 and found.low < 0.27 and 0.78 < found.high


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        ({"pair": "steel/wood"}, Error, "steel/wood: no pair has this name; wood: no material has this name; docs/materials.md lists them"),
        ({"pair": "Si/Auu"}, Error, "Si/Auu: no pair has this name; the nearest is Si/Au"),
        ({"pair": 'Si/"\\Au'}, Error, r'Si/\\"\\\\Au: no pair has this name'),
        ({"pair": 5}, TypeError, "pair = 5: must be a name"),
        ({"load": math.nan}, Error, "element 0: load = NaN: must be finite"),
        ({"Sq": -1e-9}, Error, "Sq = -1e-9: must be finite and > 0"),
        ({"Sq": None}, TypeError, "Sq = None: must be a real number"),
        ({"a b": 1.0}, TypeError, "a b: no such key"),
        ({"pair": "PDMS/PDMS"}, Error, "burgers_vector: none is known of a body of PDMS/PDMS: give one"),
        ({"measured": 0.3}, Error, r"measured = 0.3: must be points \[load, coefficient\]"),
    ],
)
def test_bad_input_is_refused(arguments: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        friction(**{**ROUGH, "pair": "Si/Si", "load": 1e5, **arguments})


def test_the_names_that_types_know_are_those_of_the_library() -> None:
    """And mypy refuses others: it complains of an ignored error that is none."""
    with pytest.raises(TypeError, match="RSmm: no such key; the nearest is RSm"):
        friction("steel/steel", Ra=1e-6, RSmm=1e-4, load=1.0)  # type: ignore[call-arg]
    with pytest.raises(Error, match="must be one of ") as refused:
        friction("steel/steel", process="grund", load=1.0)  # type: ignore[arg-type]
    told = str(refused.value).partition("must be one of ")[2].split(", ")
    assert told == list(get_args(get_type_hints(Roughness)["process"]))
    known = set(chain(*KEYS.values()))
    assert known | {"known_to", "measured_on"} == Surface.__annotations__.keys() | {"pair", "nominal_area", "coverage"} and sum(map(len, KEYS.values())) == len(known)
    for name in known - {"pair", "known_to", "measured_on"}:
        with pytest.raises(Error) as caught:
            Params.from_text(text_of([(name, "[[]]")]))
        assert "no such key" not in str(caught.value), name


def test_what_does_not_hold_is_warned_of() -> None:
    with pytest.warns(ValidityWarning, match="between the loads 100000 and 1e.06: UNCALIBRATED: "):
        friction("Si/Si", **ROUGH, load=[1e5, 1e6])


def test_one_measured_point_narrows_the_band() -> None:
    found = friction("Si/Si", **ROUGH, load=[1e4, 1e5, 1e6], **MEASURED, calibration_error=0.1)
    unmeasured = friction("Si/Si", **ROUGH, load=[1e4, 1e5, 1e6])
    assert found.value[1] == pytest.approx(0.3, rel=1e-6) and (found.high / found.low < unmeasured.high / unmeasured.low).all()
    assert np.log(found.high / found.low)[1] == pytest.approx(2 * 1.96 * 0.1, rel=0.02)
    assert friction("Si/Si", **ROUGH, load=1e5, measured=(1e5, 0.3, 0.1)).value == pytest.approx(0.3, rel=1e-6)
    several = friction("Si/Si", **ROUGH, load=1e5, measured=[(1e5, 0.3), (1e6, 0.28, 0.02)])
    assert several.high / several.low < friction("Si/Si", **ROUGH, load=1e5, measured=(1e5, 0.3)).high / 0.3 * 1.1


def test_a_strength_that_is_given_has_the_band_of_all_else_or_none() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5, slip_stress_1=0.02)
    assert found.rests_on[0] == "strength of the interface: as given" and found.shares["model"] > 0.5
    exact = friction("Si/Si", **ROUGH, load=1e5, slip_stress_1=0.02, model_error=0)
    assert exact.shares["slope"] > 0.5 and exact.shares["model"] == 0.0
    found = friction("Si/Si", **ROUGH, **KNOWN, load=1e5, slip_stress_1=0.02, model_error=0)
    assert (found.low, found.high, found.coverage, found.narrow) == (None, None, None, ()) and "no band" in repr(found)


def test_an_estimate_is_a_number_with_its_band() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5)
    assert isinstance(found, Estimate) and float(found) == found.value and np.asarray(found) == found.value
    assert 2.0 * np.asarray(found, dtype=np.float32) == pytest.approx(2 * found.value, rel=1e-6)
    assert f"{found:.2f}" == f"{found.value:.2f} ({found.low:.2f} to {found.high:.2f})" and f"{found}" == repr(found)
    assert re.fullmatch(r"0\.\d\d\d", f"{friction('Si/Si', **ROUGH, **KNOWN, load=1e5, slip_stress_1=0.02, model_error=0):.3f}")
    assert f"{friction('Si/Si', **ROUGH, load=0.0):.3f}" == "no limit"
    many = friction("Si/Si", **ROUGH, load=pandas.Series([1e4, 0.0, -1e20], index=list("abc")))
    assert many.high.index.tolist() == list("abc") and 5 < many.high["a"] / many.value["a"] < 12
    assert many.low["b"] == many.value["b"] == math.inf and many.low["c"] == many.value["c"] == 0.0
    assert "mu(0 N) has no limit" in friction("Si/Si", **ROUGH, load=0.0, nominal_area=1e-8).text
    assert "mu(0 Pa) has no limit" in repr(many)
    with pytest.raises(TypeError):
        float(many)
    # The same text as the library and the command line have.
    assert repr(many) == asperity.estimate.estimate(many._text, [1e4, 0.0, -1e20]).text
    assert repr(friction("Si/Si", **ROUGH, load=np.full(9, 1e5))).count("mu(") == 2


def test_an_estimate_is_drawn_with_its_band_its_loads_and_what_was_measured(tmp_path: Path) -> None:
    several = [[1000, 0.16], [100, 0.17, 0.1]]
    for given, loads, points in (
        ({"measured": (1000, 0.16)}, [10.0, 5.0, 0.0], [[1000, 0.16]]),
        ({"measured": several}, 10.0, [row[:2] for row in several]),
        ({"calibration_load": 1000, "calibration_friction_coefficient": 0.16}, [10.0], [[1000, 0.16]]),
        ({"calibration_load": 1000, "calibration_friction_force": 160}, [10.0], [[1000, 0.16]]),
    ):
        found = friction(**GROUND, Ra=0.8e-6, load=loads, **given)
        (axes,) = found.plot(tmp_path / "friction.svg").axes
        line, marked, measured = axes.lines
        assert axes.get_xlabel() == "normal load $P$ [N]" and len(axes.collections) == 1
        asked = np.atleast_1d(loads)
        at = np.asarray(marked.get_xydata())
        assert at[:, 0].tolist() == asked[asked > 0].tolist() and (at[:, 1] == np.atleast_1d(found.value)[asked > 0]).all()
        assert np.asarray(measured.get_xydata()).tolist() == points
        x, y = np.asarray(line.get_xydata()).T
        assert np.interp(math.log(at[0, 0]), np.log(x), y) == pytest.approx(at[0, 1], rel=1e-3)
        assert (tmp_path / "friction.svg").stat().st_size > 0
    (axes,) = friction(**GROUND, Ra=0.8e-6, load=10.0).plot().axes
    legend = axes.get_legend()
    lines = [line for text in legend.get_texts() for line in text.get_text().splitlines()] if legend else []
    assert "E = 205 GPa and nu = 0.3 of steel" in lines and max(map(len, lines)) < 80
    x, _ = np.asarray(axes.lines[0].get_xydata()).T
    assert (x[0], x[-1]) == pytest.approx((1.0, 100.0)) and axes.get_yscale() == "log" and len(axes.lines) == 2
    assert friction(**GROUND, Ra=0.8e-6, load=20.0).plot(axes=axes) is axes.figure
    with pytest.raises(Error, match="load: must be > 0 to be drawn"):
        friction(**GROUND, Ra=0.8e-6, load=0.0).plot()


def test_without_matplotlib_a_plot_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    found = friction(**GROUND, Ra=0.8e-6, load=10.0)
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="drawing needs matplotlib .*: pip install matplotlib"):
        found.plot()
