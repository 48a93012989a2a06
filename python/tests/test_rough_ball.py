"""The nominal area of a rough ball, on docs/device-or-bead.md: against a contact solved ring by ring, as Greenwood and Tripp do
(J. Appl. Mech. 34 (1967) 153). The asperities are a layer whose pressure depends on the gap of the mean planes alone, on an
elastic ball."""

from __future__ import annotations

import re
from math import pi
from pathlib import Path

import numpy as np
import pytest
from asperity import Model, Params
from asperity.estimate import Estimate, estimate
from asperity.materials import PAIRS

STEEL = PAIRS["steel/steel"].contact
AREA, SLOPE = 1e-6, 0.1  # m^2, -
SURFACES = {
    "elastic": Params.from_iso25178(Sq=20e-9, Sdq=SLOPE, nominal_area=AREA, **STEEL).replace(work_of_adhesion=0.0),
    "yielding": Params.from_iso25178(Sq=0.4e-6, Sdq=SLOPE, nominal_area=AREA, **STEEL).elastic_plastic(STEEL["hardness"]),
}
HEIGHT = {"elastic": 20e-9, "yielding": 0.4e-6}  # Sq [m]
# Hertz' mean pressure over E* Sdq: the real area is 0.7 to 7 % of the nominal one in the smooth limit.
PRESSURES = (0.003, 0.03)
ROUGHNESSES = (0.01, 0.05, 0.2, 1.0, 30.0)  # Sq R/a^2, with Hertz' radius a


def hertz(r: np.ndarray, a: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pressure of a Hertz contact with the radius a, over its maximum, and the displacement of the surface, times E*."""
    out = np.maximum(r / a, 1.0)
    inside = pi / (4 * a) * (2 * a**2 - r**2)
    outside = ((2 * a**2 - r**2) * np.arcsin(1 / out) + r * a * np.sqrt(1 - 1 / out**2)) / (2 * a)
    return np.sqrt(np.clip(1 - (r / a) ** 2, 0, None)), np.where(r <= a, inside, outside)


def stress(model: Model, pressure: np.ndarray | float) -> np.ndarray:
    """Friction by nominal area."""
    return np.asarray(model.friction_force_at_load(AREA * np.asarray(pressure))) / AREA


def rough_ball(model: Model, height: float, radius: float, load: float, rings: int = 80) -> tuple[float, float]:
    """Friction force, summed over the rings, and the pressure in the middle over Hertz' one."""
    modulus = model.params.composite_modulus
    a = (0.75 * load * radius / modulus) ** (1 / 3)
    # Any pressure is a sum of Hertz contacts, of which each ring is the rim of one.
    rim = 1.2 * np.sqrt(a**2 + 16 * radius * height) * np.arange(1, rings + 1) / rings
    r = rim - rim[0]
    unit, displacement = hertz(r[:, None], rim[None, :])
    compliance = np.linalg.solve(unit.T, displacement.T).T / modulus
    weight = np.linalg.solve(unit.T, 2 * pi / 3 * rim**2)  # of the pressures in their integral over the area
    gap, approach = 3 * height + np.clip((r**2 - a**2) / (2 * radius), 0, None), -(a**2) / radius
    jacobian = np.zeros((rings + 1, rings + 1))
    for _ in range(200):
        pressure, slope = (value / AREA for value in model.load_at_gap(gap, slope=True))
        wrong = np.append(gap - approach - r**2 / (2 * radius) - compliance @ pressure, (weight @ pressure / load - 1) * height)
        if np.abs(wrong).max() < 1e-9 * height:
            return float(weight @ stress(model, pressure)), pressure[0] * pi * a**2 / (1.5 * load)
        jacobian[:-1, :-1] = np.eye(rings) - compliance * slope
        jacobian[:-1, -1], jacobian[-1, :-1] = -1, weight * slope * height / load
        step = np.linalg.solve(jacobian, -wrong)
        step *= min(1.0, 0.5 * height / np.abs(step[:-1]).max())
        gap, approach = gap + step[:-1], approach + step[-1]
    raise AssertionError("no equilibrium")


def friction_of_mean(model: Model, load: float, area: float) -> float:
    return area * float(stress(model, load / area))


@pytest.fixture(scope="module")
def errors() -> dict[float, np.ndarray]:
    """Of friction at the mean pressure [%], for each roughness: on Hertz' area, and on the area of the page."""
    found: dict[float, list[tuple[float, float]]] = {roughness: [] for roughness in ROUGHNESSES}
    for kind, params in SURFACES.items():
        model, height = Model(params), HEIGHT[kind]
        for pressure in PRESSURES:
            for roughness, rows in found.items():
                opening = 0.75 * pi * pressure * SLOPE  # a/R
                radius = height / (roughness * opening**2)
                load = 4 / 3 * params.composite_modulus * opening**3 * radius**2
                friction, _ = rough_ball(model, height, radius, load)
                areas = (pi * (opening * radius) ** 2 * (1 + more * roughness) for more in (0.0, 1.5))
                rows.append(tuple(100 * (friction_of_mean(model, load, area) / friction - 1) for area in areas))  # type: ignore[arg-type]
    return {roughness: np.array(rows) for roughness, rows in found.items()}


def test_the_area_of_the_page_is_within_two_per_cent_of_friction(root: Path, errors: dict[float, np.ndarray]) -> None:
    text = (root / "docs" / "device-or-bead.md").read_text(encoding="utf-8")
    assert "A = π (a² + 1.5 Sq R)" in text
    first = (root / "docs" / "start.md").read_text(encoding="utf-8")
    ((friction, band),) = re.findall(r"glass beads of 4 mm \| (\S+) \((.*)\) at 0.01 N", first)
    assert f"mu(0.01 N) = {friction}, 95 % band {band}\n" in text
    assert max(np.abs(rows[:, 1]).max() for rows in errors.values()) < 2
    assert np.abs(errors[30.0][:, 0]).max() > 25


def test_flat_summits_on_a_small_ball_have_more_friction_as_the_page_says(root: Path) -> None:
    """On balls of 50 µm and 1 mm, of slopes from 0.03 to 0.2, by the summits' radius Sq/Sdq² over the ball's."""
    page = " ".join((root / "docs" / "device-or-bead.md").read_text(encoding="utf-8").split())
    told = re.findall(r"within ([\d.]+) % of .*? below R/(\d+)\. It is up to (\d+) % too low at R/(\d+), (\d+) % at R and (\d+) % at (\d) R", page)
    ((sharp, of_sharp, *blunt),) = ([float(number) for number in row] for row in told)
    least = {1 / of_sharp: sharp, 1 / blunt[1]: blunt[0], 1.0: blunt[2], blunt[4]: blunt[3]}
    found: dict[float, list[float]] = {share: [] for share in least}
    for share in least:
        for radius, slope in ((50e-6, 0.03), (50e-6, 0.1), (1e-3, 0.05), (1e-3, 0.2)):
            height = share * radius * slope**2
            if not 2e-9 < height < 0.5e-6:
                continue
            model = Model(Params.from_iso25178(Sq=height, Sdq=slope, nominal_area=AREA, **STEEL).replace(work_of_adhesion=0.0))
            for roughness in ROUGHNESSES:
                a = (height * radius / roughness) ** 0.5
                load = 4 / 3 * model.params.composite_modulus * a**3 / radius
                friction, _ = rough_ball(model, height, radius, load)
                found[share].append(100 * (friction_of_mean(model, load, pi * (a**2 + 1.5 * height * radius)) / friction - 1))
    for share, errors_of in found.items():
        assert -least[share] < min(errors_of) and max(errors_of) < sharp, (share, errors_of)
        assert share == 1 / of_sharp or min(errors_of) < 0.6 * -least[share], (share, errors_of)


def test_the_table_of_the_page_is_what_the_rings_give(root: Path, errors: dict[float, np.ndarray]) -> None:
    (row,) = re.findall(r"^\| Hertz' area alone \|(.*)\|$", (root / "docs" / "device-or-bead.md").read_text(encoding="utf-8"), re.MULTILINE)
    shown = [[float(number) for number in re.findall(r"-?\d+", cell)] for cell in row.replace("−", "-").split("|")]
    for ends, roughness in zip(shown, ROUGHNESSES):
        found = errors[roughness][:, 0]
        assert [ends[0], ends[-1]] == pytest.approx([found.min(), found.max()], abs=0.51)


def glass(root: Path) -> str:
    (surface,) = re.findall(r"```toml grain.toml\n(.*?)```", (root / "docs" / "device-or-bead.md").read_text("utf-8"), re.DOTALL)
    return str(surface)


def bead(text: str, load: float, measured_at: float = 1.0, mu: float = 0.15) -> Estimate:
    """What the page computes of the two glass beads of its surface file."""
    surface = Params.from_text(text)

    def area(load: float) -> float:
        return float(pi * ((0.75 * load * 1e-3 / surface.composite_modulus) ** (2 / 3) + 1.63 * surface.height_std * 1e-3))

    lines = f"nominal_area = {area(load)}\nmeasured = [{measured_at * area(load) / area(measured_at)}, {mu}]"
    return estimate(text.replace("nominal_area = 1e-6", lines), load)


def test_the_slope_of_a_grain_matters_as_the_page_says(root: Path) -> None:
    """For friction little, for the number of contacts much: with half and twice the slope, and other roughnesses and laws."""
    surface, page = glass(root), " ".join((root / "docs" / "device-or-bead.md").read_text(encoding="utf-8").split())
    shown = re.findall(r"here μ at 0.01 N is (\S+) and (\S+) instead of (\S+)\. .*? is (\S+) and (\S+) instead of (\S+)\. ", page)
    found = [bead(surface.replace("0.2, 0.2", f"{slope}, {slope}"), 0.01) for slope in (0.1, 0.4, 0.2)]
    numbers = [f"{one.value:.3f}" for one in found] + [f"{one.contacts:.1f}" for one in found]
    assert shown == [tuple(numbers)]
    for height in ("0.02e-6", "0.5e-6"):
        for law in ("elastic-plastic", "maugis"):
            other = surface.replace("0.1e-6", height).replace("elastic-plastic", law)
            flat, steep, middle = (bead(other.replace("0.2, 0.2", f"{s}, {s}"), 0.01).value for s in (0.1, 0.4, 0.2))
            # On rough grains so few summits touch that single ones differ.
            most, least = (1.12, 0.93) if height == "0.02e-6" else (1.7, 0.8)
            assert 1 < flat / middle < most and least < steep / middle < 1.05


def test_the_band_of_a_grain_counts_the_contacts_on_its_area(root: Path) -> None:
    """As many as the model has on its nominal area, times the share; its friction is that of the model; the measured point is met."""
    surface = glass(root)
    params = Params.from_text(surface)
    for load in (1e-3, 0.01, 0.1, 1.0):
        shares = [
            pi * ((0.75 * at * 1e-3 / params.composite_modulus) ** (2 / 3) + 1.5 * 2**0.5 * 0.1e-6 * 1e-3) / params.nominal_area
            for at in (load, 1.0)
        ]
        model, found = Model(params.calibrated(1.0 / shares[1], 0.15)), bead(surface, load)
        # The estimate leaves open how strength depends on size and pressure, which the model of the point alone does not.
        law = model.friction_at_load(load / shares[0])
        assert found.curve == pytest.approx(law, rel=3e-2) and 0.97 * law < found.value < (1.15 if found.contacts < 20 else 1.01) * law
        assert found.contacts == pytest.approx(shares[0] * model.state_at_load(load / shares[0]).contacting, rel=2e-3)
        assert (found.contacts < 20) == ("few contacts" in found.text)
    assert bead(surface, 1.0).value == pytest.approx(0.15, rel=1e-6)


def test_a_smooth_ball_has_hertz_pressure_and_a_rougher_one_less() -> None:
    """Also with twice the rings. Below 0.05 the pressure in the middle is within 4 % of Hertz', as in Greenwood and Tripp."""
    params, height = SURFACES["elastic"], HEIGHT["elastic"]
    model, middle = Model(params), {}
    for roughness in ROUGHNESSES:
        opening = 0.75 * pi * 0.03 * SLOPE
        radius = height / (roughness * opening**2)
        load = 4 / 3 * params.composite_modulus * opening**3 * radius**2
        (friction, middle[roughness]), (finer, _) = (rough_ball(model, height, radius, load, rings) for rings in (80, 160))
        assert friction == pytest.approx(finer, rel=1e-3)
    assert middle[0.01] == pytest.approx(1, abs=0.01) and middle[0.05] == pytest.approx(1, abs=0.04)
    assert list(middle.values()) == sorted(middle.values(), reverse=True) and middle[30.0] < 0.05


def test_the_mean_pressure_of_a_smooth_ball_gives_little_more_friction() -> None:
    """Than its pressures summed ring by ring: 0.5 to 1.7 %."""
    share = (np.arange(4000) + 0.5) / 4000  # of the area
    for params in SURFACES.values():
        model = Model(params)
        for pressure in np.array(PRESSURES) * params.composite_modulus * SLOPE:
            summed = np.mean(stress(model, 1.5 * pressure * np.sqrt(1 - share)))
            assert 1.004 < stress(model, pressure) / summed < 1.018
