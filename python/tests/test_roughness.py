"""Parameters from what instruments and spectra tell of a surface: Nayak's summits and areal parameters."""

from __future__ import annotations

import math
from typing import Any

import pytest

from asperity import Error, Params, Status

CONTACT: dict[str, Any] = dict(
    work_of_adhesion=0.06, adhesion_range=4e-10, burgers_vector=4e-10, E1=160e9, nu1=0.22, E2=160e9, nu2=0.22
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
        nominal_area=AREA, hardness=9e9, **CONTACT,
    )  # fmt: skip
    assert params == same


def test_moments_that_no_surface_has_are_refused() -> None:
    with pytest.raises(Error, match=r"bandwidth m0 m4/m2\^2 = 1.25: must be at least 1.5") as caught:
        Params.from_spectral_moments(m0=1, m2=1, m4=1.25, nominal_area=1, **CONTACT)
    assert caught.value.status is Status.INVALID_PARAMETER
    with pytest.raises(Error, match="m4 = NaN: must be finite and > 0"):
        Params.from_spectral_moments(m0=1, m2=1, m4=math.nan, nominal_area=1, **CONTACT)
    twice: dict[str, Any] = {"height_std": 1}
    with pytest.raises(TypeError, match="height_std"):
        Params.from_spectral_moments(m0=1, m2=1, m4=2, nominal_area=1, **CONTACT, **twice)


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
        ({}, "give Ssc, Sds or both"),
        ({"Ssc": 5e6, "Ssk": 0.1}, "give both Ssk and Sku, or neither"),
        ({"Ssc": 5e6, "Ssk": 0.1, "Sku": 4, "skew": 0.2}, "skew"),
        ({"Ssc": 5e6, "Sa": 1e-9}, "Sa"),
    ],
)
def test_areal_parameters_that_do_not_fit_together_are_refused(given: dict[str, Any], message: str) -> None:
    with pytest.raises(TypeError, match=message):
        Params.from_iso25178(Sq=5e-9, Sdq=0.1, nominal_area=AREA, **CONTACT, **given)


@pytest.mark.parametrize("name", ["Sq", "Sdq", "Ssc", "Sds"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan])
def test_areal_parameters_must_be_positive(name: str, value: float) -> None:
    areal: dict[str, Any] = {"Sq": 5e-9, "Sdq": 0.1, "Ssc": 5e6, "Sds": 1e13, name: value}
    with pytest.raises(Error, match=f"{name} = "):
        Params.from_iso25178(nominal_area=AREA, **CONTACT, **areal)
