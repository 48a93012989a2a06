"""Parameters from what instruments and spectra tell of a surface: Nayak's summits and areal parameters."""

from __future__ import annotations

import math
import re
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from random_surfaces import GaussianSurface, Nayak

from asperity import Error, Model, Params, Status, ValidityWarning, friction, surface

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


def test_spectral_moments_give_the_summits_of_nayak_and_mccool() -> None:
    params = Params.from_spectral_moments(m0=M0, m2=M2, m4=M4, nominal_area=AREA, **CONTACT, hardness=9e9)
    assert params.height_std == pytest.approx(math.sqrt((1 - 0.8968 / 5) * M0), rel=1e-5)
    assert params.summit_radius == pytest.approx(0.375 * math.sqrt(math.pi / M4), rel=1e-14)
    assert params.asperity_count == pytest.approx(M4 / M2 / (6 * math.pi * math.sqrt(3)) * AREA, rel=1e-14)
    same = Params.si(
        height_std=params.height_std, summit_radius=params.summit_radius, asperity_count=params.asperity_count,
        nominal_area=AREA, hardness=9e9, bandwidth=params.bandwidth, **CONTACT,
    )  # fmt: skip
    assert params == same and params.bandwidth == pytest.approx(5, rel=1e-14)


def test_two_numbers_of_a_profile_and_a_bandwidth_are_three_moments() -> None:
    """M2 is (2 pi Rq/RSm)^2, since a Gaussian profile crosses its mean line upwards once in RSm: counted below."""
    expected = Params.from_spectral_moments(m0=M0, m2=M2, m4=M4, nominal_area=AREA, **CONTACT)
    profile: dict[str, Any] = dict(Rq=math.sqrt(M0), RSm=2 * math.pi * math.sqrt(M0 / M2), nominal_area=AREA, **CONTACT)
    found = Params.from_profile(**profile, bandwidth=5.0)
    for name in ("height_std", "summit_radius", "asperity_count", "bandwidth"):
        assert getattr(found, name) == pytest.approx(getattr(expected, name), rel=1e-12)
    assert Params.from_profile(**profile).bandwidth == pytest.approx(math.sqrt(3 * 30), rel=1e-12)
    assert Params.from_profile(**profile, summits="nayak").radius_amplitude < 0
    with pytest.raises(Error, match="RSm = 0: must be finite and > 0"):
        Params.from_profile(**{**profile, "RSm": 0})
    with pytest.raises(Error, match="bandwidth m0 m4/m2.2 = 1.2.*: must be at least 1.5"):
        Params.from_profile(**profile, bandwidth=1.2)


def test_moments_that_no_surface_has_are_refused() -> None:
    with pytest.raises(Error, match=r"bandwidth m0 m4/m2\^2 = 1.25: must be at least 1.5") as caught:
        Params.from_spectral_moments(m0=1, m2=1, m4=1.25, nominal_area=1, **CONTACT)
    assert caught.value.status is Status.INVALID_PARAMETER
    with pytest.raises(Error, match="m4 = NaN: must be finite and > 0"):
        Params.from_spectral_moments(m0=1, m2=1, m4=math.nan, nominal_area=1, **CONTACT)
    twice: dict[str, Any] = {"height_std": 1}
    with pytest.raises(TypeError, match="height_std"):
        Params.from_spectral_moments(m0=1, m2=1, m4=2, nominal_area=1, **CONTACT, **twice)


def test_profile_parameters_give_the_moments_that_the_page_says() -> None:
    """A long Gaussian profile with the autocorrelation function exp(-x^2): what an instrument counts on it."""
    count, dx = 2**20, 0.05
    q = 2 * np.pi * np.fft.rfftfreq(count, dx)
    random = np.random.default_rng(4)
    waves = np.exp(-(q**2) / 8) * (random.standard_normal(q.size) + 1j * random.standard_normal(q.size))
    profile = np.fft.irfft(waves, count)
    profile /= profile.std()
    slope, length = np.diff(profile), count * dx
    RSm = length / np.count_nonzero((profile[:-1] < 0) & (profile[1:] >= 0))
    D = np.count_nonzero((slope[:-1] > 0) & (slope[1:] <= 0)) / length
    m2, m4 = (slope**2).mean() / dx**2, (np.diff(slope) ** 2).mean() / dx**4
    assert m2 == pytest.approx(2, rel=0.02) and m4 == pytest.approx(12, rel=0.02)
    assert (2 * np.pi / RSm) ** 2 == pytest.approx(m2, rel=0.03)
    assert (2 * np.pi * D) ** 2 * m2 == pytest.approx(m4, rel=0.03)
    correlation = [1.0, *(float(np.mean(profile[k:] * profile[:-k])) for k in (4, 8))]
    spacing = 4 * dx
    over_spacing = profile[::4]
    assert 2 * (1 - correlation[1]) / spacing**2 == pytest.approx((np.diff(over_spacing) ** 2).mean() / spacing**2, rel=0.01)
    curvature = (np.diff(over_spacing, 2) ** 2).mean() / spacing**4
    assert (6 - 8 * correlation[1] + 2 * correlation[2]) / spacing**4 == pytest.approx(curvature, rel=0.02)


def test_areal_parameters_of_a_gaussian_surface_agree_with_its_moments() -> None:
    expected = Params.from_spectral_moments(m0=M0, m2=M2, m4=M4, nominal_area=AREA, **CONTACT)
    areal: dict[str, Any] = dict(Sq=math.sqrt(M0), Sdq=math.sqrt(2 * M2), nominal_area=AREA, **CONTACT)
    curvature, density = 1 / expected.summit_radius, expected.asperity_count / AREA
    by_curvature = Params.from_iso25178(Ssc=curvature, **areal)
    by_density = Params.from_iso25178(Sds=density, **areal)
    for params in (by_curvature, by_density):
        for name in ("height_std", "summit_radius", "asperity_count"):
            assert getattr(params, name) == pytest.approx(getattr(expected, name), rel=1e-13)
        assert params.height_distribution == "gaussian"
    # Fewer summits than a Gaussian surface has: counted, with the radius that was measured.
    both = Params.from_iso25178(Ssc=curvature, Sds=density / 2, **areal)
    assert both.asperity_count == pytest.approx(expected.asperity_count / 2, rel=1e-13)
    assert both.summit_radius == by_curvature.summit_radius

    skewed = Params.from_iso25178(Ssc=curvature, Ssk=-0.4, Sku=3.5, **areal)
    assert (skewed.height_distribution, skewed.skew, skewed.kurtosis) == ("johnson", -0.4, 3.5)


@pytest.mark.parametrize(
    "given, message",
    [
        ({}, "^Ssc: must be set, or Sds"),
        ({"Ssc": 5e6, "Ssk": 0.1}, "^Sku: must be set: Ssk and Sku go together"),
        ({"Ssc": 5e6, "Ssk": 0.1, "Sku": 4, "skew": 0.2}, "skew"),
        ({"Ssc": 5e6, "Sa": 1e-9}, "Sa"),
    ],
)
def test_areal_parameters_that_do_not_fit_together_are_refused(given: dict[str, Any], message: str) -> None:
    with pytest.raises((TypeError, Error), match=message):
        Params.from_iso25178(Sq=5e-9, Sdq=0.1, nominal_area=AREA, **CONTACT, **given)


@pytest.mark.parametrize("name", ["Sq", "Sdq", "Ssc", "Sds"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan])
def test_areal_parameters_must_be_positive(name: str, value: float) -> None:
    areal: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.1, "Ssc": 5e6, "Sds": 1e13, name: value}
    with pytest.raises(Error, match=f"{name} = "):
        Params.from_iso25178(nominal_area=AREA, **CONTACT, **areal)


@pytest.mark.parametrize("bandwidth", [1.6, 1.8, 2.8, 5.6, 11.0])
def test_nayaks_summits_have_the_heights_and_radii_of_the_joint_density(bandwidth: float) -> None:
    """Against that density summed on a grid of heights and curvatures."""
    m0, m2 = 4e-18, 2e-3
    theory = Nayak(m0, m2, bandwidth * m2**2 / m0)
    moments: dict[str, Any] = dict(m0=theory.m0, m2=theory.m2, m4=theory.m4, nominal_area=AREA)
    params = Params.from_spectral_moments(**moments, summits="nayak", **CONTACT)
    mean, std, skew, kurtosis = theory.height_moments()
    assert params.height_distribution == "johnson"
    assert (params.height_std, params.skew) == pytest.approx((std, skew), rel=2e-4)
    assert params.kurtosis == pytest.approx(kurtosis, abs=1e-4)
    for height, allowed in ((-0.5, 0.07), (0.0, 1e-4), (0.7, 0.03), (1.5, 1e-4), (2.2, 0.03), (3.0, 1e-4), (3.5, 0.03)):
        radius = params.summit_radius * (1 + params.radius_amplitude * math.tanh(params.radius_rate * height))
        curvature = float(theory.curvature_at(np.array([mean + height * std]))[0])
        assert radius * curvature == pytest.approx(1, rel=allowed), height


def test_nayaks_summits_are_those_found_on_gaussian_surfaces() -> None:
    """On maps whose shortest wave is 14 points long, so that a grid tells their summits: skew and eq (3), fitted."""
    random = GaussianSurface(points=700, shortest=14.0, lowest=0.4)
    found = [surface.summits(random.map(seed), 1.0, detrend=0) for seed in range(4)]
    moments: dict[str, Any] = dict(zip(("m0", "m2", "m4"), random.moments()))
    theory = Params.from_spectral_moments(**moments, nominal_area=1.0, summits="nayak", **CONTACT_OF_POINTS)
    assert np.mean([one.skew.value for one in found]) == pytest.approx(theory.skew, abs=0.06)
    assert np.mean([one.kurtosis.value for one in found]) == pytest.approx(theory.kurtosis, abs=0.12)
    for height in (0.0, 1.0, 2.0):
        grown = 1 + theory.radius_amplitude * math.tanh(theory.radius_rate * height)
        trends = [one.radius_trend for one in found]
        seen = [trend.radius * (1 + trend.amplitude * math.tanh(trend.rate * height)) for trend in trends]
        # A grid rounds the sharpest summits off and takes a few saddles for summits: 4 % at this wavelength.
        assert np.mean(seen) == pytest.approx(theory.summit_radius * grown, rel=0.06), height


def test_the_table_of_nayaks_summits_in_the_docs_is_that_of_the_library() -> None:
    page = (Path(__file__).parents[2] / "docs" / "roughness.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([\d.]+) \| ([\d.]+) \| ([\d.]+) \| (-[\d.]+) \| ([\d.]+) \| ([\d.]+) \|$", page, re.MULTILINE)
    assert len(rows) == 6
    for row in rows:
        bandwidth, *printed = map(float, row)
        moments: dict[str, Any] = dict(m0=4e-18, m2=2e-3, m4=bandwidth * 2e-3**2 / 4e-18, nominal_area=AREA)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)
            equal = Params.from_spectral_moments(**moments, **CONTACT)
            nayak = Params.from_spectral_moments(**moments, summits="nayak", **CONTACT)
        ratio = nayak.summit_radius / equal.summit_radius
        numbers = (nayak.skew, nayak.kurtosis, nayak.radius_amplitude, nayak.radius_rate, ratio)
        for shown, number, digit in zip(printed, numbers, (1e-3, 1e-3, 1e-2, 1e-2, 1e-3)):
            assert shown == pytest.approx(number, abs=0.51 * digit)


def test_nayaks_summits_leave_heights_and_radii_to_no_one_else() -> None:
    moments: dict[str, Any] = dict(m0=M0, m2=M2, m4=M4, nominal_area=AREA, **CONTACT)
    given: dict[str, Any] = {"skew": 0.1, "weibull_shape": 3.0, "radius_amplitude": 0.1, "height_distribution": "gaussian"}
    for name, value in given.items():
        with pytest.raises(TypeError, match=f'^{name}: summits="nayak" sets heights and radii'):
            Params.from_spectral_moments(**moments, summits="nayak", **{name: value})
    with pytest.raises(Error, match='^summits = "round": must be "equal" or "nayak"$'):
        Params.from_spectral_moments(**moments, summits="round")  # type: ignore[arg-type]
    with pytest.raises(Error, match='^Ssk: summits = "nayak" sets it already'):
        Params.from_iso25178(Sq=1e-9, Sdq=0.05, Ssc=1e7, Ssk=0, Sku=3, nominal_area=AREA, summits="nayak", **CONTACT)


def test_doubtful_bandwidths_are_told_with_the_bias_to_expect() -> None:
    def said(bandwidth: float, **options: Any) -> list[str]:
        moments: dict[str, Any] = dict(m0=4e-18, m2=2e-3, m4=bandwidth * 2e-3**2 / 4e-18)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            Params.from_spectral_moments(**moments, nominal_area=AREA, **options, **CONTACT)
        assert all(one.category is ValidityWarning and one.filename == __file__ for one in caught)
        return [str(one.message) for one in caught]

    assert [said(bandwidth) for bandwidth in (2.5, 5.6, 12.0)] == [[], [], []]
    assert said(1.8, summits="nayak") == []
    (narrow,) = said(1.8)
    assert "friction 0.94 to 1.24" in narrow and narrow.endswith('summits="nayak"')
    for options in ({}, {"summits": "nayak"}):
        (broad,) = said(31.0, **options)
        assert broad.startswith("bandwidth m0 m4/m2^2 = 31: from spectral moments") and "boundary elements" in broad


def test_warnings_name_the_line_that_called_the_package_however_deep() -> None:
    rough: dict[str, Any] = dict(Sq=5e-9, Sdq=0.05, Sds=1e14)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        Params.from_iso25178(**rough, nominal_area=AREA, **CONTACT)
        friction("Si/Si", **rough, load=1e5)
        Model(Params.from_iso25178(**rough, nominal_area=AREA, **CONTACT)).curve([1e-9, 1e-7]).plot()
    assert {one.category for one in caught} == {ValidityWarning}
    assert {one.filename for one in caught} == {__file__} and len(caught) >= 4


def test_slips_of_units_are_told_before_the_bias_of_a_bandwidth_that_no_surface_has() -> None:
    with pytest.warns(ValidityWarning, match="is a length in another unit, as Sq in nm or um?") as caught:
        with pytest.raises(Error, match="is height_std in um or nm?"):
            friction("Si/Si", Sq=5, Sdq=0.05, Sds=1e13, load=1e5)
    assert len(caught) == 1


def test_doubtful_bandwidths_of_maps_are_told() -> None:
    random = GaussianSurface(points=512, shortest=6.0, fall=3.0)
    found = surface.summits(random.map(1), 1.0)
    assert found.moments.bandwidth > 15
    with pytest.warns(ValidityWarning, match="from the summits of a map at a bandwidth of 27"):
        Params.from_topography(found, **CONTACT_OF_POINTS)
