"""`asperity.friction`: the same as parameters and a model, with what it says of bad input."""

from __future__ import annotations

import math
import warnings
from typing import Any

import numpy as np
import pytest

from asperity import Error, Model, Params, ValidityWarning, friction
from asperity.materials import MATERIALS, PAIRS, contact

# Nobody measured the strength of these interfaces, and they say so.
pytestmark = pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
ROUGH: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.05, "Sds": 1e13}
LOADS = np.geomspace(1e-2, 1.0, 5)


def test_it_is_the_friction_of_the_model() -> None:
    with Model(Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1e-6)) as model:
        assert friction("Si/Si", **ROUGH, load=1e-2, nominal_area=1e-6) == model.friction_at_load(1e-2)
        found = friction(PAIRS["Si/Si"], **ROUGH, load=LOADS, nominal_area=1e-6)
        assert found.tolist() == model.friction_at_load(LOADS).tolist()


def test_without_an_area_loads_are_pressures() -> None:
    by_pressure = friction("Si/Si", **ROUGH, load=1e5)
    assert by_pressure == pytest.approx(friction("Si/Si", **ROUGH, load=1e-1, nominal_area=1e-6), rel=1e-9)


def test_roughness_is_taken_in_three_forms() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0)
    m2 = ROUGH["Sdq"] ** 2 / 2
    moments = {"m0": ROUGH["Sq"] ** 2, "m2": m2, "m4": 6 * math.pi * 3**0.5 * m2 * ROUGH["Sds"]}
    summits = {"height_std": params.height_std, "summit_radius": params.summit_radius, "summit_density": params.asperity_count}
    expected = friction("Si/Si", **ROUGH, load=1e5)
    for rough in (moments, summits):
        assert friction("Si/Si", **rough, load=1e5) == pytest.approx(expected, rel=1e-12)


def test_numbers_that_are_given_replace_those_of_the_pair() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact | {"work_of_adhesion": 0.1}, **ROUGH, nominal_area=1.0)
    with Model(params) as model:
        assert friction("Si/Si", **ROUGH, load=1e5, work_of_adhesion=0.1) == model.friction_at_load(1e5)


def test_an_interface_brings_its_strength() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0).with_interface("Al2O3/Si in air")
    with Model(params) as model:
        assert friction("Si/Si", **ROUGH, load=1e5, interface="Al2O3/Si in air") == model.friction_at_load(1e5)
    with pytest.raises(Error, match="slip_stress_2: is told by interface already, leave one out"):
        friction("Si/Si", **ROUGH, load=1e5, interface="Al2O3/Si in air", slip_stress_2=0.01)
    with pytest.raises(Error, match="interface = 5: must be the name of an interface"):
        friction("Si/Si", **ROUGH, load=1e5, interface=5)  # type: ignore[arg-type]


def test_a_burgers_vector_that_is_given_stands_for_one_that_is_not_known() -> None:
    contact_of = contact("PDMS", "PDMS", burgers_vector=50e-9)
    with Model(Params.from_iso25178(**contact_of, **ROUGH, nominal_area=1.0)) as model:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # rubber is crowded at any load
            found = friction("PDMS/PDMS", **ROUGH, load=1.0, burgers_vector=50e-9)
        assert found == model.friction_at_load(1.0)


def test_two_bodies_without_a_pair_need_a_work_of_adhesion() -> None:
    with pytest.raises(Error, match="work_of_adhesion: none is known for SiC/WC: give that of your surfaces, 0 for none"):
        friction("SiC/WC", **ROUGH, load=1e5)
    params = Params.from_iso25178(**contact("SiC", "WC", work_of_adhesion=0.05), **ROUGH, nominal_area=1.0)
    with Model(params) as model:
        assert friction("SiC/WC", **ROUGH, load=1e5, work_of_adhesion=0.05) == model.friction_at_load(1e5)


def test_a_surface_that_does_not_hold_is_warned_of_once() -> None:
    ground: dict[str, Any] = {"Sq": 0.4e-6, "Sdq": 0.1, "Sds": 1e10}
    with pytest.warns(ValidityWarning, match="PLASTIC: summits yield"):
        first = friction("steel/steel", **ground, load=[1e5, 1e6])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert friction("steel/steel", **ground, load=[1e5, 1e6]).tolist() == first.tolist()
        assert friction("Si/Si", **ROUGH, load=-1e20) == 0.0  # apart: nothing to warn of


@pytest.mark.parametrize(
    "arguments, error, message",
    [
        ({"pair": "steel/wood"}, KeyError, "steel/wood: no pair has this name; the nearest is steel/"),
        ({"pair": "steel"}, KeyError, "steel: no pair has this name; the nearest is steel/"),
        ({"pair": "Si/gold"}, KeyError, "Si/gold: no pair has this name; the nearest is Si/Au"),
        ({"pair": 5}, TypeError, "pair = 5: must be a name"),
        ({"load": math.nan}, Error, "load = NaN: must be finite"),
        ({"load": [1.0, math.inf]}, Error, "element 1: load = inf"),
        ({"load": "heavy"}, TypeError, "load: must be real numbers"),
        ({"Sq": -1e-9}, Error, "Sq = -1e-09: must be finite and > 0"),
        ({"Sdqx": 1.0}, TypeError, "Sdqx: no parameter has this name; the nearest is Sdq"),
        ({"nominal_area": 0.0}, Error, "nominal_area = 0"),
        ({"pair": "PDMS/PDMS"}, Error, "burgers_vector: none is known of a body of PDMS/PDMS: give one"),
    ],
)
def test_bad_input_is_refused(arguments: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        friction(**{**ROUGH, "pair": "Si/Si", "load": 1e5, **arguments})


def test_a_roughness_is_asked_for() -> None:
    with pytest.raises(TypeError, match="the roughness is missing: give Sq, Sdq and Sds or Ssc"):
        friction("Si/Si", load=1e5)
    with pytest.raises(TypeError, match="Sdq"):
        friction("Si/Si", load=1e5, Sq=5e-9, Sds=1e13)


def test_the_mean_deviation_stands_for_the_standard_one() -> None:
    expected = friction("Si/Si", **ROUGH, load=1e5)
    given = {"Ra": ROUGH["Sq"] * math.sqrt(2 / math.pi), "Sdq": ROUGH["Sdq"], "Sds": ROUGH["Sds"]}
    assert friction("Si/Si", **given, load=1e5) == pytest.approx(expected, rel=1e-12)
    with pytest.raises(Error, match="Ra: must not be given beside Sq, which it stands for"):
        friction("Si/Si", **given, Sq=5e-9, load=1e5)
