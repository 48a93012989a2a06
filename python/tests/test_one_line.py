"""`asperity.friction`: the same as parameters and a model, with its band and what it says of bad input."""

from __future__ import annotations

import math
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pandas
import pytest

from asperity import Error, Estimate, Model, Params, ValidityWarning, Warnings, friction, uncertainty
from asperity._typical_roughness import PROCESSES, SLOPE_FACTOR, machined_slope
from asperity.materials import MATERIALS, PAIRS, contact

# Nobody measured the strength of these interfaces, and they say so.
pytestmark = pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
ROUGH: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.05, "Sds": 1e13}
LOADS = np.geomspace(1e-2, 1.0, 5)
MEASURED: dict[str, Any] = {"calibration_load": 1e5, "calibration_friction_coefficient": 0.3}


def test_it_is_the_friction_of_the_model() -> None:
    with Model(Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1e-6)) as model:
        assert friction("Si/Si", **ROUGH, load=1e-2, nominal_area=1e-6).value == model.friction_at_load(1e-2)
        found = friction(PAIRS["Si/Si"], **ROUGH, load=LOADS, nominal_area=1e-6).value
        assert found.tolist() == model.friction_at_load(LOADS).tolist()


def test_without_an_area_loads_are_pressures() -> None:
    by_pressure = friction("Si/Si", **ROUGH, load=1e5).value
    assert by_pressure == pytest.approx(friction("Si/Si", **ROUGH, load=1e-1, nominal_area=1e-6).value, rel=1e-9)


def test_roughness_is_taken_in_three_forms() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0)
    m2 = ROUGH["Sdq"] ** 2 / 2
    moments = {"m0": ROUGH["Sq"] ** 2, "m2": m2, "m4": 6 * math.pi * 3**0.5 * m2 * ROUGH["Sds"]}
    summits = {"height_std": params.height_std, "summit_radius": params.summit_radius, "summit_density": params.asperity_count,
               "radius_amplitude": params.radius_amplitude, "radius_rate": params.radius_rate}
    expected = friction("Si/Si", **ROUGH, load=1e5).value
    for rough in (moments, summits):
        assert friction("Si/Si", **rough, load=1e5).value == pytest.approx(expected, rel=1e-12)


def test_numbers_that_are_given_replace_those_of_the_pair() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact | {"work_of_adhesion": 0.1}, **ROUGH, nominal_area=1.0)
    with Model(params) as model:
        assert friction("Si/Si", **ROUGH, load=1e5, work_of_adhesion=0.1).value == model.friction_at_load(1e5)


def test_an_interface_brings_its_strength() -> None:
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0).with_interface("Al2O3/Si in air")
    with Model(params) as model:
        found = friction("Si/Si", **ROUGH, load=1e5, interface="Al2O3/Si in air")
        assert found.value == model.friction_at_load(1e5)
    # The band has no part of it, and the answer says so.
    told = "strength of the interface: that of Al2O3/Si in air, measured on other specimens and taken as known"
    assert found.rests_on == (told,) and found.narrow == ("one measured friction: calibration_load with calibration_friction_coefficient",)
    with pytest.raises(Error, match="slip_stress_2: interface sets it already, leave one out"):
        friction("Si/Si", **ROUGH, load=1e5, interface="Al2O3/Si in air", slip_stress_2=0.01)
    with pytest.raises(Error, match="interface = 5: must be the name of an interface"):
        friction("Si/Si", **ROUGH, load=1e5, interface=5)  # type: ignore[arg-type]


def test_a_burgers_vector_that_is_given_stands_for_one_that_is_not_known() -> None:
    contact_of = contact("PDMS", "PDMS", burgers_vector=50e-9)
    rough: dict[str, Any] = {"Sq": 10e-6, "Sdq": 0.2}
    with Model(Params.from_iso25178(**contact_of, **rough, nominal_area=1.0)) as model:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # rubber sticks at any load
            found = friction("PDMS/PDMS", **rough, load=1.0, burgers_vector=50e-9)
        assert found.value == model.friction_at_load(1.0)


def test_two_bodies_without_a_pair_need_a_work_of_adhesion() -> None:
    with pytest.raises(Error, match="work_of_adhesion: none is known for SiC/WC: give that of your surfaces, 0 for none"):
        friction("SiC/WC", **ROUGH, load=1e5)
    params = Params.from_iso25178(**contact("SiC", "WC", work_of_adhesion=0.05), **ROUGH, nominal_area=1.0)
    with Model(params) as model:
        assert friction("SiC/WC", **ROUGH, load=1e5, work_of_adhesion=0.05).value == model.friction_at_load(1e5)


def test_a_surface_that_does_not_hold_is_warned_of_once() -> None:
    ground: dict[str, Any] = {"Sq": 0.4e-6, "Sdq": 0.1, "Sds": 1e10, "contact_law": "maugis"}
    with pytest.warns(ValidityWarning, match="PLASTIC: summits yield"):
        first = friction("steel/steel", **ground, load=[1e5, 1e6]).value
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert friction("steel/steel", **ground, load=[1e5, 1e6]).value.tolist() == first.tolist()
        assert friction("Si/Si", **ROUGH, load=-1e20).value == 0.0  # apart: nothing to warn of


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
        ({"Sq": -1e-9}, Error, "Sq = -1e-9: must be finite and > 0"),
        ({"Sdqx": 1.0}, TypeError, "Sdqx: no parameter has this name; the nearest is Sdq"),
        ({"nominal_area": 0.0}, Error, "nominal_area = 0"),
        ({"pair": "PDMS/PDMS"}, Error, "burgers_vector: none is known of a body of PDMS/PDMS: give one"),
        ({"process": "ground"}, TypeError, "Sdq: is not for a profile or a process; give all of the roughness, or Ra or Rq alone"),
        ({"calibration_load": 1e5}, TypeError, "calibration_load: calibration_load goes with one of calibration_friction_coefficient and"),
        (MEASURED | {"calibration_friction_coefficient": -0.3}, Error, "calibration_friction_coefficient = -0.3: must be > 0 and at most 20"),
        (MEASURED | {"calibration_error": 5}, Error, "calibration_error = 5: must be at most 1: .* is it in per cent?"),
        ({"Rz": 5e-9}, TypeError, "Rz: is a peak-to-valley height, which does not determine friction: give Ra or Rq"),
        ({"coverage": 95}, ValueError, "coverage = 95: must be between 0 and 1"),
    ],
)
def test_bad_input_is_refused(arguments: dict[str, Any], error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        friction(**{**ROUGH, "pair": "Si/Si", "load": 1e5, **arguments})


@pytest.mark.parametrize("given", [{}, {"Sq": 5e-9, "Sds": 1e13}, {"Ra": 4e-9}, {"Rq": 4e-9}, {"RSm": 1e-6}, {"m0": 1e-17}])
def test_a_roughness_is_asked_for_by_all_names_that_tell_it(given: dict[str, Any]) -> None:
    with pytest.raises(TypeError) as refused:
        friction("Si/Si", load=1e5, **given)
    for name in ("Sq and Sdq", "m0 and m2", "Ra or Rq with RSm or Rdq of a profile", "process, one of superfinished, "):
        assert name in str(refused.value)


def test_the_mean_deviation_stands_for_the_standard_one() -> None:
    expected = friction("Si/Si", **ROUGH, load=1e5).value
    given = {"Ra": ROUGH["Sq"] * math.sqrt(2 / math.pi), "Sdq": ROUGH["Sdq"], "Sds": ROUGH["Sds"]}
    assert friction("Si/Si", **given, load=1e5).value == pytest.approx(expected, rel=1e-12)
    m2 = ROUGH["Sdq"] ** 2 / 2
    moments = {"Ra": given["Ra"], "m2": m2, "m4": 6 * math.pi * 3**0.5 * m2 * ROUGH["Sds"]}
    assert friction("Si/Si", **moments, load=1e5).value == pytest.approx(expected, rel=1e-12)
    with pytest.raises(Error, match="^Ra: must not be given together with Sq, which it replaces"):
        friction("Si/Si", **given, Sq=5e-9, load=1e5)


# ---- Bands ----

GROUND: dict[str, Any] = {"pair": "steel/steel", "process": "ground", "nominal_area": 1e-4}
NORMAL = 1.959964


def test_a_strength_that_nobody_measured_is_a_factor_of_10_either_way() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5)
    assert (found.low, found.high) == (pytest.approx(found.value / 10), pytest.approx(10 * found.value))
    assert found.coverage == 0.95 and found.rests_on[0] == "strength of the interface: not measured, a factor 10 either way"
    assert found.narrow == ("one measured friction: calibration_load with calibration_friction_coefficient",)
    half = friction("Si/Si", **ROUGH, load=1e5, coverage=0.5)
    assert half.high / half.value == pytest.approx(10 ** (0.67449 / NORMAL), rel=1e-5)


def test_one_measured_point_narrows_the_band() -> None:
    found = friction("Si/Si", **ROUGH, load=[1e4, 1e5, 1e6], **MEASURED, calibration_error=0.1)
    params = Params.from_iso25178(**PAIRS["Si/Si"].contact, **ROUGH, nominal_area=1.0).calibrated(1e5, 0.3, error=0.1)
    band = uncertainty(params, loads=[1e4, 1e5, 1e6])
    assert found.value == pytest.approx(band.value, rel=1e-9) and found.value[1] == pytest.approx(0.3, rel=1e-9)
    assert found.low == pytest.approx(band.low, rel=1e-9) and found.high == pytest.approx(band.high, rel=1e-9)
    assert found.rests_on == band.rests_on and found.narrow == ()


def test_a_strength_that_is_given_has_no_band() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5, slip_stress_1=0.02)
    assert (found.low, found.high, found.coverage, found.narrow) == (None, None, None, ())
    assert found.rests_on == ("strength of the interface: as given",) and "no band" in repr(found)


def test_ground_steel_is_a_band_that_says_what_would_narrow_it() -> None:
    found = friction(**GROUND, Ra=0.8e-6, load=20.0)
    assert found.low < found.value / 9 and found.high > 9 * found.value
    lines = repr(found).splitlines()
    assert re.fullmatch(r"0\.0\d+ \(0\.00\d+ to 0\.\d+\); 95 % band", lines[0])
    assert [line for line in lines if line.startswith("rests on: ")] == [
        "rests on: strength of the interface: not measured, a factor 10 either way",
        "rests on: slope of its profile: 0.14 to a factor 4, as assumed of machined surfaces",
        next(line for line in lines if re.fullmatch(r"rests on: summits yield, plasticity index 2\.\d: elastic-plastic, without adhesion", line)),
    ]
    assert [line[:24] for line in lines[4:]] == ["to narrow it: one measur", "to narrow it: the mean w"]
    without = friction(**GROUND, load=20.0)
    assert "rests on: ground surfaces have an Ra of 0.1 to 1.6 um" in repr(without)
    assert math.log(without.high / without.low) > math.log(found.high / found.low)
    # What is known of it makes it narrower.
    with_width = friction(**GROUND, Ra=0.8e-6, RSm=40e-6, load=20.0)
    ratios = [found.high / found.low for found in (found, with_width)]
    assert ratios == sorted(ratios, reverse=True) and ratios[-1] == pytest.approx(100)


@pytest.mark.parametrize("measured", [None, (20.0, 0.3)])
def test_the_band_is_that_of_a_monte_carlo(measured: tuple[float, float] | None) -> None:
    """Of strengths and slopes drawn at random, each with the probability that it gives to the measurement."""
    loads, error = np.array([2.0, 20.0, 2000.0]), 0.1
    point: dict[str, Any] = {} if measured is None else dict(zip(MEASURED, measured))
    found = friction(**GROUND, Ra=0.8e-6, load=loads, **point, calibration_error=error)
    random = np.random.default_rng(6)
    Rq = math.sqrt(math.pi / 2) * 0.8e-6
    bodies = {**PAIRS["steel/steel"].contact, "work_of_adhesion": 0.0}

    def logs(slope: float) -> Any:
        params = Params.from_spectral_moments(m0=Rq**2, m2=slope**2, nominal_area=1e-4, contact_law="elastic-plastic", **bodies)
        with Model(params) as model:
            return np.log(model.friction_at_load(loads))

    usual = 0.14 * math.sqrt(Rq / 1e-6)
    middle = logs(usual)
    drawn = np.array([logs(usual * 4 ** (one / NORMAL)) for one in random.standard_normal(250)])
    strength = math.log(10) / NORMAL * random.standard_normal((250, 400, 1))
    if measured is not None:
        strength = strength + math.log(measured[1]) - middle[1]
    drawn = (drawn[:, None, :] + strength).reshape(-1, 3)
    weight = np.ones(len(drawn)) if measured is None else np.exp(-0.5 * ((drawn[:, 1] - math.log(measured[1])) / error) ** 2)
    for i in range(3):
        order = np.argsort(drawn[:, i])
        share = np.cumsum(weight[order]) / weight.sum()
        ends = np.interp([0.025, 0.975], share, drawn[order, i])
        width = ends[1] - ends[0]
        assert math.log(found.low[i]) == pytest.approx(ends[0], abs=0.04 * width)
        assert math.log(found.high[i]) == pytest.approx(ends[1], abs=0.04 * width)


def test_a_pressure_coefficient_takes_its_part_of_a_measurement() -> None:
    """Without adhesion it is a constant on top of the rest, of which alone the strength is in question."""
    given: dict[str, Any] = {**GROUND, "Ra": 0.8e-6, "RSm": 40e-6, "pressure_coefficient": 0.1}
    point: dict[str, Any] = dict(zip(MEASURED, (20.0, 0.15)))
    found = friction(**given, load=20.0, **point, calibration_error=0.1)
    assert found.value == pytest.approx(0.15, rel=1e-9)
    # 0.15 = 0.1 + 0.05 c, so that ln F has a third of the spread of ln c before the measurement.
    before = math.log(10) / NORMAL / 3
    deviation = 1 / math.sqrt(1 / before**2 + 1 / 0.1**2)
    assert math.log(found.high / found.low) == pytest.approx(2 * NORMAL * deviation, rel=1e-3)


def test_where_summits_yield_the_law_is_one_that_knows_it() -> None:
    ground: dict[str, Any] = {"Sq": 0.4e-6, "Sdq": 0.1, "Sds": 1e10}
    found = friction("steel/steel", **ground, load=1e5)
    contact_of = {**PAIRS["steel/steel"].contact, "work_of_adhesion": 0.0}
    params = Params.from_iso25178(**contact_of, **ground, nominal_area=1.0, contact_law="elastic-plastic")
    with Model(params) as model:
        assert found.value == model.friction_at_load(1e5)
        index = model.state_at_load(1e5).plasticity_index
    assert found.rests_on[1] == f"summits yield, plasticity index {index:.2g}: elastic-plastic, without adhesion"
    for own in ({"contact_law": "maugis"}, {"work_of_adhesion": 0.1}):
        assert len(friction("steel/steel", **ground, load=1e5, **own).rests_on) == 1


def test_roughness_that_a_process_does_not_leave_is_warned_of() -> None:
    with pytest.warns(ValidityWarning, match=r"Ra = 1e-05: ground surfaces have an Ra of 0.1 to 1.6 um: is it of this process"):
        friction(**GROUND, Ra=1e-5, load=20.0)
    with pytest.raises(Error, match="process = 'gorund': must be one of superfinished, lapped, honed, ground"):
        friction("steel/steel", process="gorund", load=20.0)
    with pytest.raises(Error, match="Rq = -1.0: must be finite and > 0"):
        friction(**GROUND, Rq=-1, load=20.0)
    with pytest.raises(TypeError, match="Ra and Rq both give the height"):
        friction(**GROUND, Ra=1e-6, Rq=1e-6, load=20.0)


def test_both_surfaces_may_be_rough() -> None:
    """Mean squares of heights and of slopes add."""
    Rq = 1e-6 * np.array([0.8, 0.4])
    found = friction(**GROUND, Rq=Rq.tolist(), load=20.0)
    slope = 0.14 * math.sqrt(1.2)
    assert f"rests on: slope of its profile: {slope:.2g} to a factor 4" in repr(found)
    total = float(np.hypot(*Rq))
    known = friction(**GROUND, Rq=total, RSm=2 * math.pi * total / slope, load=20.0)
    assert found.value == pytest.approx(known.value, rel=1e-9)
    both: dict[str, Any] = {"Rq": [5e-9, 4e-9], "RSm": [600e-9, 900e-9]}
    params = Params.from_profile(**both, **PAIRS["Si/Si"].contact, nominal_area=1.0)
    with Model(params) as model:
        assert friction("Si/Si", **both, load=1e5).value == pytest.approx(model.friction_at_load(1e5), rel=1e-9)
    with pytest.raises(TypeError, match="RSm: must be as many numbers as Rq has"):
        friction("Si/Si", Rq=5e-9, RSm=[600e-9, 900e-9], load=1e5)


def test_the_page_has_the_roughness_that_processes_leave(root: Path) -> None:
    page = (root / "docs" / "domain.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([^|]*) \| ([\d.]+) to ([\d.]+) µm \| – \| ", page, re.MULTILINE)
    for process, ends in PROCESSES.items():
        (told,) = [(float(low), float(high)) for name, low, high in rows if process in name]
        assert told == pytest.approx([1.25e6 * end for end in ends], rel=0.05)
    assert f"0.14 (Rq/µm)^½, with 95 % of its probability within a factor of {SLOPE_FACTOR:g}" in page
    assert machined_slope(1e-6) == pytest.approx(0.14)


def test_an_estimate_is_a_number_with_its_band() -> None:
    found = friction("Si/Si", **ROUGH, load=1e5)
    assert isinstance(found, Estimate) and float(found) == found.value and np.asarray(found) == found.value
    assert 2.0 * np.asarray(found, dtype=np.float32) == pytest.approx(2 * found.value, rel=1e-6)
    assert f"{found:.2f}" == f"{found.value:.2f} ({found.low:.2f} to {found.high:.2f})" and f"{found}" == repr(found)
    given = friction("Si/Si", **ROUGH, load=1e5, slip_stress_1=0.02)  # has no band
    assert f"{given:.3f}" == f"{given.value:.3f}"
    many = friction("Si/Si", **ROUGH, load=pandas.Series([1e4, 0.0, -1e20], index=list("abc")))
    assert many.high.index.tolist() == list("abc") and many.high["a"] == pytest.approx(10 * many.value["a"])
    assert many.low["b"] == many.value["b"] and many.low["c"] == many.value["c"] == 0.0
    assert repr(many).startswith(f"{many.value['a']:.3g} ({many.low['a']:.3g} to {many.high['a']:.3g}), ")
    with pytest.raises(TypeError):
        float(many)
    assert repr(friction("Si/Si", **ROUGH, load=np.full(9, 1e5))).startswith("friction coefficients at 9 loads; 95 % band\n")


def test_what_a_profile_does_not_tell_is_told() -> None:
    found = friction("Si/Si", Rq=5e-9, RSm=600e-9, load=1e5)
    with Model(Params.from_profile(**PAIRS["Si/Si"].contact, Rq=5e-9, RSm=600e-9, nominal_area=1.0)) as model:
        assert found.value == pytest.approx(model.friction_at_load(1e5), rel=1e-12) and Warnings.BROAD not in model.check(1e5, 1e5)
    assert found.rests_on == ("strength of the interface: not measured, a factor 10 either way",)
    slope = friction("Si/Si", Rq=5e-9, Rdq=2 * math.pi * 5 / 600, load=1e5)
    assert slope.value == pytest.approx(found.value, rel=1e-12)
    with pytest.raises(TypeError, match="RSm and Rdq both give the slope"):
        friction("Si/Si", Rq=5e-9, RSm=600e-9, Rdq=0.05, load=1e5)
    by_mean = friction("Si/Si", Ra=math.sqrt(2 / math.pi) * 5e-9, RSm=600e-9, load=1e5)
    assert by_mean.value == pytest.approx(found.value, rel=1e-12)
