"""Parameters are immutable values; each way to make them gives what the definitions of the quantities say."""

from __future__ import annotations

import copy
import math
import pickle
from dataclasses import FrozenInstanceError, dataclass
from pathlib import Path
from typing import Any

import pytest
from conftest import HARD_CARBON

from asperity import Error, Model, Params, Status, Warnings, units
from asperity.materials import PAIRS

SURFACE: dict[str, Any] = dict(
    work_of_adhesion=0.06, adhesion_range=4e-10, burgers_vector=4e-10, height_std=5e-9, summit_radius=1e-6
)
STIFFNESS: dict[str, Any] = dict(composite_modulus=8e10, effective_shear_modulus=6e10)


def test_dimensionless_is_the_papers_case() -> None:
    params = Params.dimensionless(alpha=0.02, beta=500, gamma=0.002, b_over_h=2, poisson=0.25)
    assert params.composite_modulus == pytest.approx(2 / (1 - 0.25), rel=1e-15)
    assert params.effective_shear_modulus == 2
    assert params.burgers_vector == params.asperity_count == 1
    assert math.sqrt(params.height_std / params.summit_radius) == pytest.approx(0.02, rel=1e-15)
    assert math.sqrt(params.height_std * params.summit_radius) == pytest.approx(500, rel=1e-15)
    assert params.work_of_adhesion == pytest.approx(0.002 * params.composite_modulus, rel=1e-15)
    assert params.adhesion_range == 0.5


def test_two_bodies_give_the_moduli_of_their_definitions() -> None:
    params = Params.si(**SURFACE, E1=200e9, nu1=0.3, E2=70e9, nu2=0.2, asperity_count=1)
    assert params.composite_modulus == pytest.approx(1 / ((1 - 0.3**2) / 200e9 + (1 - 0.2**2) / 70e9), rel=1e-14)
    first, second = 200e9 / 2 / 1.3, 70e9 / 2 / 1.2
    assert params.effective_shear_modulus == pytest.approx(2 * first * second / (first + second), rel=1e-14)


def test_one_body_may_be_rigid() -> None:
    params = Params.si(**SURFACE, E1=70e9, nu1=0.2, E2=math.inf, nu2=0.0, asperity_count=1)
    assert params.composite_modulus == pytest.approx(70e9 / (1 - 0.2**2), rel=1e-14)
    assert params.effective_shear_modulus == pytest.approx(2 * 70e9 / 2.4, rel=1e-14)
    with pytest.raises(Error, match="at least one of the two bodies must be elastic"):
        Params.si(**SURFACE, E1=math.inf, nu1=0.2, E2=math.inf, nu2=0.0, asperity_count=1)


def test_summits_are_counted_or_density_times_area() -> None:
    made = Params.si(**SURFACE, **STIFFNESS, summit_density=1e13, nominal_area=2e-8)
    assert made.asperity_count == 1e13 * 2e-8 and made.nominal_area == 2e-8


@pytest.mark.parametrize(
    "arguments, message",
    [
        ({}, "composite_modulus and effective_shear_modulus, or E1, nu1, E2 and nu2"),
        ({"composite_modulus": 1e9}, "composite_modulus and effective_shear_modulus, or E1, nu1, E2 and nu2"),
        (STIFFNESS | {"nu1": 0.3}, "composite_modulus and effective_shear_modulus, or E1, nu1, E2 and nu2"),
        ({"E1": 1e9, "nu1": 0.3, "E2": 1e9}, "or E1, nu1, E2 and nu2"),
        (STIFFNESS, "asperity_count, or summit_density and nominal_area"),
        (STIFFNESS | {"summit_density": 1e13}, "asperity_count, or summit_density and nominal_area"),
        (STIFFNESS | {"summit_density": 1e13, "nominal_area": 1.0, "asperity_count": 5}, "asperity_count, or summit"),
        (STIFFNESS | {"asperity_count": 5, "skew": 0, "weibull_shape": 2}, "do not give weibull_shape too"),
        (STIFFNESS | {"asperity_count": 5, "skew": 0, "height_distribution": "gaussian"}, "height_distribution too"),
        (STIFFNESS | {"asperity_count": 5, "hardnes": 5}, "hardnes: no parameter has this name; the nearest is hardness"),
        (STIFFNESS | {"asperity_count": "5"}, "asperity_count = '5': must be a real number"),
        (STIFFNESS | {"asperity_count": 5, "skew": None}, "skew = None: must be a real number"),
    ],
)
def test_arguments_that_do_not_fit_together_are_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(TypeError if "hardnes" in message or "real number" in message else Error, match=message):
        Params.si(**SURFACE, **arguments)


@pytest.mark.parametrize("name", ["summit_density", "nominal_area"])
@pytest.mark.parametrize("value", [-1.0, 0.0, math.nan, math.inf])
def test_density_and_area_must_be_positive_each(name: str, value: float) -> None:
    surface: dict[str, Any] = {"summit_density": 1.0, "nominal_area": 1.0, name: value}
    with pytest.raises(Error, match=f"{name} = {value}: must be finite and > 0"):
        Params.si(**SURFACE, **STIFFNESS, **surface)


@pytest.mark.parametrize(
    "change, message",
    [
        ({"height_distribution": "lognormal"}, "height_distribution = 'lognormal': must be one of 'gaussian', 'weibull'"),
        ({"skew": -1.2}, "skew = -1.2: must be finite and > -1.13955"),
    ],
)
def test_values_outside_a_set_are_refused_at_once(params: Params, change: dict[str, Any], message: str) -> None:
    with pytest.raises(Error, match=message) as caught:
        params.replace(**change)
    assert caught.value.status is Status.INVALID_PARAMETER


def test_one_measured_point_gives_the_strength(params: Params) -> None:
    for measured in (params.calibrated(5.0, 0.4), params.calibrated_force(5.0, 2.0)):
        with Model(measured) as model:
            assert model.state_at_load(5.0).friction_force == pytest.approx(2.0, rel=1e-12)
        assert measured.slip_stress_1 / params.slip_stress_1 == pytest.approx(measured.slip_stress_2 / params.slip_stress_2)
    for load, coefficient, message in (
        (5.0, 0.0, "calibration_friction_coefficient = 0: must be > 0 and at most 20; is it a force?"),
        (5.0, 25.0, "calibration_friction_coefficient = 25: must be > 0 and at most 20; is it a force?"),
        (0.0, 0.3, "calibration_load = 0: must be > 0; at zero load"),
    ):
        with pytest.raises(Error, match=f"^{message}"):
            params.calibrated(load, coefficient)
    with pytest.raises(Error, match="^friction_force = -1 at load = 5: must be finite and above 0"):
        params.calibrated_force(5.0, -1.0)
    with pytest.raises(Error, match="^calibration_error = 5: must be at most 1: .* per cent"):
        params.calibrated(5.0, 0.4, error=5)


def test_a_measurement_is_kept_until_the_strength_is_another(params: Params, tmp_path: Path) -> None:
    measured = params.calibrated(5.0, 0.4, error=0.1)
    assert (measured.calibration_load, measured.calibration_friction_force, measured.calibration_error) == (5.0, 2.0, 0.1)
    measured.replace(in_si=True).to_toml(tmp_path / "surface.toml")
    assert Params.from_toml(tmp_path / "surface.toml") == measured.replace(in_si=True)
    for same in (pickle.loads(pickle.dumps(measured)), eval(repr(measured))):
        assert same == measured
    assert measured.replace(height_std=9.0).calibration_friction_force == 2.0
    with Model(measured) as model:
        assert model.params == measured
    for strength in ("slip_stress_1", "slip_stress_2", "pressure_coefficient"):
        other = measured.replace(**{strength: 1.1 * getattr(measured, strength)})
        assert (other.calibration_load, other.calibration_friction_force) == (0.0, 0.0)


def test_names_calibrate_too(params: Params) -> None:
    """Last of all, on the surface that the others make."""
    groups: dict[str, Any] = {"alpha": 0.01, "beta": 1000, "gamma": 0.001, "skew": 0.3}
    by_name: dict[str, Any] = {"calibration_load": 5.0, "calibration_friction_coefficient": 0.4, "calibration_error": 0.1}
    expected = Params.dimensionless(**groups).calibrated(5.0, 0.4, error=0.1)
    assert Params.dimensionless(**groups, **by_name) == params.replace(skew=0.3, **by_name) == expected
    by_force = {"calibration_load": 5.0, "calibration_friction_force": 2.0}
    assert params.replace(**by_force) == params.calibrated_force(5.0, 2.0)
    iso: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.08, "Ssc": 3e6, "Sds": 2e13, "nominal_area": 1e-8}
    silicon = PAIRS["Si/Si"].contact
    expected = Params.from_iso25178(**iso, **silicon).calibrated(1e-3, 0.3)
    assert Params.from_iso25178(**iso, **silicon, calibration_load=1e-3, calibration_friction_coefficient=0.3) == expected
    for alone in ({"calibration_load": 5.0}, {"calibration_friction_force": 2.0}, {"calibration_friction_coefficient": 0.4}):
        with pytest.raises(Error, match="calibration_load goes with one of calibration_friction_coefficient and"):
            params.replace(**alone)


def test_the_inputs_that_no_default_can_stand_for_are_asked_for() -> None:
    with pytest.raises(TypeError, match="'composite_modulus', .* and 'asperity_count'"):
        Params()  # type: ignore[call-arg]
    assert Params.paper() == Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001)


def test_what_a_new_user_gets_wrong_is_refused_or_told() -> None:
    summits: dict[str, Any] = {"height_std": 0.3e-6, "summit_radius": 1e-5, "asperity_count": 1.7e6, "nominal_area": 1e-4}
    steel = Params.si(**PAIRS["steel/steel"].contact, **summits)
    measured = steel.calibrated(20.0, 0.16)
    assert Model(measured).friction_at_load(20.0) == pytest.approx(0.16, rel=1e-6)
    assert not Model(measured).uncalibrated
    for not_measured in (steel, steel.replace(asperity_count=1.0, nominal_area=0.0), steel.replace(slip_radius_1=20.0)):
        assert Model(not_measured).uncalibrated
    for wrong, message in (
        (lambda: Model(steel.replace(slip_radius_1=10.75e-9)), "is it a length\\? It is a ratio to burgers_vector"),
        (lambda: steel.calibrated(20.0, 47.0), "must be > 0 and at most 20; is it a force\\?"),
        (lambda: steel.calibrated(0.0, 0.16), "calibration_load = 0: must be > 0"),
        (lambda: Model(steel.replace(nominal_area=100.0)), "is nominal_area in mm\\^2"),
        (lambda: Model(steel.replace(asperity_count=1.7e10)), "a number of asperities and not a density"),
    ):
        with pytest.raises(Error, match=message):
            wrong()


def test_other_units_change_numbers_and_no_friction(params: Params) -> None:
    params = params.replace(nominal_area=1e8).calibrated(2.0, 0.4)
    other = params.in_units(length=1e-3, force=10.0)
    assert other.height_std == pytest.approx(1e3 * params.height_std, rel=1e-15)
    assert other.nominal_area == pytest.approx(1e6 * params.nominal_area, rel=1e-15)
    assert other.calibration_load == pytest.approx(0.2, rel=1e-15)
    assert Model(other).friction_at_load(0.2) == pytest.approx(Model(params).friction_at_load(2.0), rel=1e-6)
    with pytest.raises(Error, match="^length = 0: must be"):
        params.in_units(length=0.0, force=1.0)


def test_parameters_remember_that_they_are_in_si_units(params: Params, tmp_path: Path) -> None:
    steel = Params.si(**PAIRS["steel/steel"].contact, height_std=0.3e-6, summit_radius=1e-5, asperity_count=1.7e6)
    profile = Params.from_profile(Rq=5e-9, RSm=600e-9, nominal_area=1e-8, **PAIRS["Si/Si"].contact)
    of_files = (Params.from_toml(HARD_CARBON), Params.from_text(steel.to_text()))
    for metric in (steel, profile, *of_files, steel.calibrated(20.0, 0.16), steel.calibrated_force(20.0, 3.2), steel.elastic_plastic(3e9)):
        same = (metric, copy.deepcopy(metric), pickle.loads(pickle.dumps(metric)), eval(repr(metric)), metric.replace(height_std=1e-7))
        assert all(one.in_si for one in (*same, metric.in_units(length=1, force=1.0), Model(metric).params))
        assert metric.replace(in_si=False) != metric
        assert "[N/m]" in str(metric) and "[Pa]" in str(metric) and "in_si" not in str(metric) + metric._repr_html_()
    assert Params.from_text("height_std = 2e-9", start=steel).in_si and steel.with_interface("MoS2 film in dry air").in_si
    for other in (steel.replace(in_si=False), params.in_units(length=1e-3, force=1.0), params, params.replace(skew=0.1), Params.from_text("skew = 0.1", start=params)):
        assert not other.in_si
        with pytest.raises(Error, match=r"^in_si = False: .*says its units: convert to SI by in_units, then replace\(in_si=True\)"):
            other.to_toml(tmp_path / "surface.toml")
    assert not (tmp_path / "surface.toml").exists()
    millimetres = steel.in_units(length=1e-3, force=1.0)
    with pytest.raises(Error, match="^length_unit = 0.001: must be 1 for this"):
        millimetres.in_units(length=1e-3, force=1.0)
    millimetres.to_toml(tmp_path / "surface.toml")
    for again in (Params.from_text(millimetres.to_text()), Params.from_toml(tmp_path / "surface.toml")):
        assert again == millimetres and not again.in_si and again.length_unit == 1e-3
    for of, change in ((millimetres, {"in_si": True}), (steel, {"length_unit": 1e-3})):
        with pytest.raises(Error, match="^length_unit = 0.001 and force_unit = 1.0: must be 1 where in_si is True; in_units"):
            of.replace(**change)
    with pytest.raises(Error, match="length_unit = 1: must be 0.001"):
        Params.from_text("skew = 0.1", start=millimetres)
    with pytest.raises(TypeError, match="^in_si = 'SI': must be True or False"):
        params.replace(in_si="SI")


def test_summits_that_yield_have_a_hardness_and_no_adhesion(params: Params) -> None:
    yielding = params.elastic_plastic(0.01)
    assert yielding == params.replace(contact_law="elastic-plastic", hardness=0.01, work_of_adhesion=0.0)
    with pytest.raises(Error, match="^hardness = 0.0: must be finite and > 0"):
        params.elastic_plastic(0.0)


def test_of_two_rough_surfaces_mean_squares_add() -> None:
    silicon: dict[str, Any] = {**PAIRS["Si/Si"].contact, "nominal_area": 1e-8}
    both = Params.from_profile(Rq=[4e-9, 3e-9], RSm=[600e-9, 600e-9], **silicon)
    assert both.height_std == pytest.approx(Params.from_profile(Rq=5e-9, RSm=600e-9, **silicon).height_std, rel=1e-14)
    mean = Params.from_profile(Ra=[4e-9, 3e-9], RSm=[600e-9, 600e-9], **silicon)
    assert mean.height_std == pytest.approx(math.sqrt(math.pi / 2) * both.height_std, rel=1e-14)
    expected = Params.from_iso25178(Sq=5e-9, Sdq=0.1, Ssc=5e6, **silicon)
    found = Params.from_iso25178(Sq=[4e-9, 3e-9], Sdq=[0.08, 0.06], Ssc=[4e6, 3e6], **silicon)
    assert (found.height_std, found.summit_radius) == pytest.approx((expected.height_std, expected.summit_radius), rel=1e-14)
    for given, message in (
        ({"Rq": [1, 2, 3]}, "^Rq: must be a number, or two in brackets, one of each surface"),
        ({"Rq": [1e-9, 2e-9]}, "^RSm: must be as many numbers as Rq has"),
        ({}, "^Rq: must be set, or Ra"),
    ):
        with pytest.raises(Error, match=message):
            Params.from_profile(**given, RSm=600e-9, **silicon)
    with pytest.raises(TypeError, match="^Rq = '5': must be a real number"):
        Params.from_profile(Rq="5", RSm=600e-9, **silicon)  # type: ignore[arg-type]
    peak: dict[str, Any] = {"nominal_area": 1.0, "asperity_count": 1.0, "Rz": 1e-6}
    for make, rest in ((Params.from_profile, {"RSm": 1e-6}), (Params.from_iso25178, {"Sdq": 0.1}), (Params.si, SURFACE)):
        with pytest.raises(TypeError, match="Rz: no parameter has this name; a height from peak to valley, .*: give Ra or Rq"):
            make(**STIFFNESS, **rest, **peak)


def test_skew_chooses_weibull_heights_of_that_skew(params: Params) -> None:
    # Table 1 of the paper: skew, shape.
    for skew, shape in [(-1, 40.74), (-0.5, 7.493), (0, 3.602), (0.5, 2.216), (1, 1.564)]:
        skewed = params.replace(skew=skew)
        assert skewed.height_distribution == "weibull"
        assert skewed.weibull_shape == pytest.approx(shape, rel=2e-4)
        assert skewed == Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001, skew=skew)
        with Model(skewed) as model:
            assert model.summary().skew == pytest.approx(skew, abs=1e-9)


def test_a_shape_alone_means_weibull_heights(params: Params) -> None:
    assert params.replace(weibull_shape=2.0).height_distribution == "weibull"
    assert params.replace(weibull_shape=2.0, height_distribution="gaussian").height_distribution == "gaussian"


def test_a_kurtosis_means_johnson_heights_of_that_skew(params: Params) -> None:
    johnson = params.replace(skew=0.4, kurtosis=3.8)
    assert (johnson.height_distribution, johnson.skew, johnson.kurtosis) == ("johnson", 0.4, 3.8)
    assert params.replace(kurtosis=4).skew == 0
    # Of Johnson's heights a new skew is a Johnson skew; elsewhere it is one of Weibull's.
    assert johnson.replace(skew=-0.2).height_distribution == "johnson"
    assert params.replace(skew=-0.2).height_distribution == "weibull"
    with Model(johnson) as model:
        summary = model.summary()
        assert summary.skew == pytest.approx(0.4, abs=1e-9) and summary.kurtosis == pytest.approx(3.8, abs=1e-9)
        assert model.params == johnson
    with pytest.raises(Error, match="kurtosis = 1"):
        Model(params.replace(skew=1, kurtosis=1))
    with pytest.raises(Error, match="mean different height distributions"):
        params.replace(kurtosis=4, weibull_shape=2)


def test_a_table_means_tabulated_heights(params: Params) -> None:
    table = params.replace(table_height=[0, 1, 2, 3], table_density=(0, 1, 1, 0))
    assert table.height_distribution == "tabulated"
    assert table.table_height == (0.0, 1.0, 2.0, 3.0)
    assert hash(table) != hash(params) and pickle.loads(pickle.dumps(table)) == table and eval(repr(table)) == table
    with Model(params.replace(table_height=[1, 2, 3, 4, 5], table_density=[0, 1, 2, 1, 0])) as model:
        assert abs(model.summary().skew) < 1e-12
        assert model.friction_at_load(10.0) > 0
        assert pickle.loads(pickle.dumps(model)).friction_at_load(10.0) == model.friction_at_load(10.0)
    with pytest.raises(Error, match=r"table_height\[2\] = 1: must be greater than the height before it"):
        Model(params.replace(table_height=[0, 1, 1, 3], table_density=[0, 1, 1, 0]))
    with pytest.raises(Error, match="table_density: 2 numbers for 0 heights"):
        params.replace(table_density=[1, 2])
    with pytest.raises(Error, match="table_density: 3 numbers for 4 heights"):  # which the library would read beyond
        params.replace(table_height=[0, 1, 2, 3], table_density=[0, 1, 1])
    with pytest.raises(TypeError, match="table_height: must be real numbers, not an array of <U"):
        params.replace(table_height=[0, "1"], table_density=[1, 2])
    with pytest.raises(Error, match="do not give table_density or table_height too"):
        params.replace(skew=0.5, table_height=[0, 1], table_density=[1, 2])


def test_parameters_are_immutable_values(params: Params) -> None:
    same = Params.paper()
    other = params.replace(asperity_count=2)
    assert params == same and hash(params) == hash(same)
    assert params != other and params.asperity_count == 1 and other.asperity_count == 2
    assert other.replace(asperity_count=1) == params
    assert pickle.loads(pickle.dumps(other)) == other
    with pytest.raises(FrozenInstanceError):
        params.asperity_count = 3.0  # type: ignore[misc]


def test_numbers_are_shown_with_their_units_as_text_and_as_a_table(params: Params) -> None:
    shown = {line.split()[0]: line.split()[2:] for line in str(params).splitlines()[1:]}
    assert shown["composite_modulus"] == ["[stress]"] and shown["work_of_adhesion"] == ["[force/length]"]
    assert shown["height_std"] == ["[length]"] and shown["asperity_count"] == []
    table = params._repr_html_()
    assert "<td>composite_modulus</td>" in table and "<td>stress</td>" in table and table.count("<tr>") == len(shown)

    @dataclass
    class Named:
        name: str

    assert "<td>a &lt; b</td>" in units.table(Named("a < b"))


def test_the_repr_shows_what_is_not_default_and_reads_back(params: Params) -> None:
    changed = params.replace(skew=1, attraction=False, max_friction_coefficient=math.inf)
    for one in (params, changed):
        assert eval(repr(one)) == one
    assert "slip_radius_1" not in repr(changed)
    assert 'max_friction_coefficient=float("inf")' in repr(changed)


def test_a_roughness_in_another_unit_is_named_as_it_was_given() -> None:
    """Not as a number that was made of it."""
    area: dict[str, Any] = {"nominal_area": 1e-4, **PAIRS["Si/Si"].contact}
    cases: tuple[tuple[Any, dict[str, float], str], ...] = (
        (Params.from_profile, {"Ra": 0.8, "RSm": 80e-6}, "^Ra = 0.8: must be in m, and at most 1e-3; is it in um or nm\\?"),
        (Params.from_profile, {"Rq": 1e-6, "RSm": 80.0}, "^RSm = 80: must be in m, and at most 4e-3; is it in um or nm\\?"),
        (Params.from_iso25178, {"Sq": 5.0, "Sdq": 0.08}, "^Sq = 5: must be in m, and at most 1e-3; is it in um or nm\\?"),
    )
    for make, given, message in cases:
        with pytest.raises(Error, match=message):
            make(**given, **area)


def test_messages_name_no_function_of_another_language() -> None:
    assert not any("asperity_params" in kind.description for kind in Warnings if kind)
