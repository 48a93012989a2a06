"""Parameters from what instruments and spectra tell of a surface: moments, areal parameters, McCool's summits."""

from __future__ import annotations

import math
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from random_surfaces import GaussianSurface

from asperity import Error, Model, Params, ValidityWarning, Warnings, friction, surface, uncertainty
from asperity.materials import PAIRS

CONTACT: dict[str, Any] = dict(
    work_of_adhesion=0.06, adhesion_range=4e-10, burgers_vector=4e-10, E1=160e9, nu1=0.22, E2=160e9, nu2=0.22
)
# In the points of a map.
CONTACT_OF_POINTS: dict[str, Any] = dict(
    composite_modulus=1.0, effective_shear_modulus=0.8, work_of_adhesion=0, adhesion_range=1e-2, burgers_vector=1e-2
)
# A surface of bandwidth 5 with 5 nm, a slope of 0.1 and 1 um^2.
M0, M2 = 25e-18, 0.01
M4 = 5 * M2**2 / M0
AREA = 1e-12


def test_height_and_slope_are_enough() -> None:
    """The same surface by every pair of numbers, and one stretched along and across."""
    names = ("height_std", "summit_radius", "asperity_count", "summit_mean_height", "rms_slope", "radius_amplitude", "radius_rate")
    rest: dict[str, Any] = dict(nominal_area=AREA, **CONTACT)

    def numbers(params: Params) -> list[float]:
        return [getattr(params, name) for name in names]

    expected = Params.from_spectral_moments(m0=M0, m2=M2, **rest)
    Rq, slope = math.sqrt(M0), math.sqrt(M2)
    for found in (
        Params.from_spectral_moments(Ra=Rq * math.sqrt(2 / math.pi), m2=M2, **rest),
        Params.from_iso25178(Sq=Rq, Sdq=math.sqrt(2) * slope, **rest),
        Params.from_profile(Rq=Rq, Rdq=slope, **rest),
        Params.from_profile(Rq=Rq, RSm=2 * math.pi * Rq / slope, **rest),
        Params.from_profile(Rq=[0.6 * Rq, 0.8 * Rq], Rdq=[0.8 * slope, 0.6 * slope], **rest),
    ):
        assert numbers(found) == pytest.approx(numbers(expected), rel=1e-12) and found.bandwidth == 0
        assert found.height_distribution == "gaussian"
    assert expected.rms_slope == pytest.approx(math.sqrt(2) * slope, rel=1e-14)
    high = Params.from_spectral_moments(m0=4 * M0, m2=M2, **rest)
    assert high.height_std == pytest.approx(2 * expected.height_std, rel=1e-14)
    assert high.summit_radius == pytest.approx(2 * expected.summit_radius, rel=1e-14)
    assert high.asperity_count == pytest.approx(expected.asperity_count / 4, rel=1e-14)


def test_the_page_has_the_asperities_of_the_library() -> None:
    page = (Path(__file__).parents[2] / "docs" / "roughness.md").read_text(encoding="utf-8")
    number = r"([\d.]+)"
    told = re.search(
        rf"σ = {number} m₀\^½, Gaussian, with their mean {number} m₀\^½ .*?N = {number} A/L².*?"
        rf"R = {number} \(n/5\)\^−{number} L²/m₀\^½.*?ε = −{number}, ρ = {number}.*?takes n = {number}\.", page, re.DOTALL,
    )  # fmt: skip
    assert told is not None
    height, mean, density, radius, power, amplitude, rate, usual = map(float, told.groups())
    unit: dict[str, Any] = dict(m0=1e-18, m2=0.005, nominal_area=1e-12, **CONTACT)  # L = 10 nm
    made = Params.from_spectral_moments(**unit)
    assert (made.height_std, made.summit_mean_height) == pytest.approx((height * 1e-9, mean * 1e-9), rel=1e-12)
    assert (made.asperity_count, made.radius_amplitude, made.radius_rate) == pytest.approx((density * 1e4, -amplitude, rate), rel=1e-12)
    for bandwidth in (2.0, usual, 100.0):
        found = made if bandwidth == usual else Params.from_spectral_moments(**unit, bandwidth=bandwidth)
        assert found.summit_radius == pytest.approx(radius * (bandwidth / 5) ** -power * 1e-7, rel=1e-12)


def test_a_bandwidth_hardly_matters_and_may_be_given_in_three_ways() -> None:
    rest: dict[str, Any] = dict(nominal_area=AREA, **CONTACT)
    unknown = Params.from_spectral_moments(m0=M0, m2=M2, **rest)
    by_m4 = Params.from_spectral_moments(m0=M0, m2=M2, m4=M4, **rest)
    for found in (
        Params.from_spectral_moments(m0=M0, m2=M2, bandwidth=5.0, **rest),
        Params.from_iso25178(Sq=math.sqrt(M0), Sdq=math.sqrt(2 * M2), bandwidth=5.0, **rest),
        Params.from_profile(Rq=math.sqrt(M0), Rdq=math.sqrt(M2), bandwidth=5.0, **rest),
    ):
        assert found.summit_radius == pytest.approx(by_m4.summit_radius, rel=1e-12) and found.bandwidth == 0
    assert by_m4.summit_radius == pytest.approx(unknown.summit_radius, rel=0.1)
    assert by_m4.replace(summit_radius=unknown.summit_radius) == unknown
    with pytest.raises(Error, match="bandwidth m0 m4/m2.2 = 1.2.*: must be at least 1.5"):
        Params.from_profile(Rq=1e-9, Rdq=0.1, bandwidth=1.2, **rest)
    with pytest.raises(TypeError, match="bandwidth"):
        Params.from_spectral_moments(m0=M0, m2=M2, m4=M4, bandwidth=5.0, **rest)


def test_a_process_stands_for_the_slope_of_a_profile() -> None:
    rest: dict[str, Any] = dict(nominal_area=1e-4, **PAIRS["steel/steel"].contact)
    given = Params.from_profile(Ra=0.8e-6, process="ground", **rest)
    text = 'pair = "steel/steel"\nnominal_area = 1e-4\n[roughness]\nRa = 0.8e-6\nprocess = "ground"\n'
    # The strength of a text is that of its estimate.
    for params, law in ((given.elastic_plastic(given.hardness), ""), (given, 'contact_law = "maugis"\n')):
        read = Params.from_text(law + text)
        strength = {name: getattr(read, name) for name in ("slip_stress_1", "slip_stress_2", "pressure_coefficient", "calibration_error")}
        assert params.replace(**strength) == read
    assert Params.from_profile(process="ground", **rest).height_std > 0
    with pytest.raises(Error, match="process = \"grund\": must be one of superfinished"):
        Params.from_profile(Ra=0.8e-6, process="grund", **rest)  # type: ignore[arg-type]


def test_mccools_summits_are_those_of_the_literature() -> None:
    given: dict[str, Any] = dict(m0=M0, m2=M2, m4=M4, nominal_area=AREA, summits="mccool", hardness=9e9, **CONTACT)
    params = Params.from_spectral_moments(**given)
    assert params.height_std == pytest.approx(math.sqrt((1 - 0.8968 / 5) * M0), rel=1e-5)
    assert params.summit_radius == pytest.approx(0.375 * math.sqrt(math.pi / M4), rel=1e-14)
    assert params.asperity_count == pytest.approx(M4 / M2 / (6 * math.pi * math.sqrt(3)) * AREA, rel=1e-14)
    assert params.summit_mean_height == pytest.approx(4 * math.sqrt(M0 / (5 * math.pi)), rel=1e-14)
    assert params.radius_amplitude == 0 and params.bandwidth == pytest.approx(5, rel=1e-14)
    with pytest.raises(Error, match='^summits: "mccool" needs the curvature of the surface: give m4, Ssc, Sds or bandwidth'):
        Params.from_spectral_moments(**{**given, "m4": None})
    with pytest.raises(Error, match="^summits = 'round': must be one of 'moments', 'mccool'$"):
        Params.from_spectral_moments(**{**given, "summits": "round"})
    assert Params.from_spectral_moments(**{**given, "m4": None}, bandwidth=5.0).bandwidth == pytest.approx(5, rel=1e-14)


@pytest.mark.parametrize(
    "given, message",
    [
        ({"Ssc": 5e6, "Ssk": 0.1}, "^Sku: must be set: Ssk and Sku go together"),
        ({"Ssc": 5e6, "Ssk": 0.1, "Sku": 4, "skew": 0.2}, "skew"),
        ({"Ssc": 5e6, "Sa": 1e-9}, "Sa"),
    ],
)
def test_areal_parameters_that_do_not_fit_together_are_refused(given: dict[str, Any], message: str) -> None:
    with pytest.raises((TypeError, Error), match=message):
        Params.from_iso25178(Sq=5e-9, Sdq=0.1, nominal_area=AREA, **CONTACT, **given)


def test_warnings_name_the_line_that_called_the_package_however_deep() -> None:
    rough: dict[str, Any] = dict(Sq=5e-9, Sdq=0.5)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        friction("Si/Si", **rough, load=1e5)
        Model(Params.from_iso25178(**rough, nominal_area=AREA, **CONTACT)).curve([1e-9, 1e-7]).plot()
    assert {one.category for one in caught} == {ValidityWarning}
    assert {one.filename for one in caught} == {__file__} and len(caught) >= 2


def test_height_and_slope_of_a_map_have_errors_and_bands() -> None:
    """The error is what maps of one spectrum differ by, to a factor of two."""
    random = GaussianSurface(points=256, shortest=8.0, lowest=0.2, fall=2.0)
    maps = [surface.summits(random.map(seed), 1.0) for seed in range(12)]
    for name in ("rms_height", "rms_slope"):
        values = [getattr(one, name).value for one in maps]
        told = float(np.mean([getattr(one, name).error for one in maps]))
        assert 0.5 < told / float(np.std(values, ddof=1)) < 2, name
    one = maps[0]
    assert one.rms_height.value == pytest.approx(one.iso.Sq, rel=0.02)
    assert one.rms_slope.value == pytest.approx(one.iso.Sdq, rel=0.02)
    params = Params.from_topography(one, **CONTACT_OF_POINTS)
    load = 1e-3 * one.nominal_area
    band = uncertainty(params, {"Sq": 0.05, "Sdq": 0.1, "slip_stress": 0}, [load])

    def logs(height: float, slope: float) -> float:
        changed = Params.from_spectral_moments(
            m0=one.moments.m0 * height**2, m2=one.moments.m2 * slope**2, m4=one.moments.m4 * slope**4 / height**2,
            nominal_area=one.nominal_area, **CONTACT_OF_POINTS,
        )  # fmt: skip
        return math.log(Model(changed).friction_at_load(load))

    for name, deviation, by in (("Sq", 0.05, (1.001, 1.0)), ("Sdq", 0.1, (1.0, 1.001))):
        slope = (logs(*by) - logs(*(2 - one for one in by))) / 0.002
        assert band.parts[name][0] == pytest.approx(deviation * abs(slope), rel=0.03)
    with pytest.raises(ValueError, match="name 'Sdq': is of parameters made from m0 and m2"):
        uncertainty(Params.paper(), {"Sdq": 0.1}, [1.0])
