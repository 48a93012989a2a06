"""The bolted joint of docs/stiffness-and-microslip.md: its numbers, Iwan's model, and the same joint stepped with the contact that remembers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from asperity import Warnings
from gallery import joint

Array = NDArray[np.float64]
DOCS = Path(__file__).resolve().parents[1]


class Stepped:
    """The plates of `joint`, solved by Newton's method with the tangents of the contacts."""

    def __init__(self) -> None:
        self.contacts = joint.contact().microslip(joint.CELLS)
        self.slip, self.iterations = np.zeros(joint.CELLS), 0
        size = joint.HALF_LENGTH / joint.CELLS
        self.tension, self.area = joint.YOUNG * joint.WIDTH * joint.THICKNESS, joint.WIDTH * size
        chain = 2 * np.eye(joint.CELLS) - np.eye(joint.CELLS, k=1) - np.eye(joint.CELLS, k=-1)
        chain[0, 0] = chain[-1, -1] = 1
        self.plates = self.tension / 2 / size * chain
        self.arm = size / 2 + joint.HALF_LENGTH

    def displacement(self, pull: float) -> float:
        slip, ends = self.slip.copy(), np.zeros(joint.CELLS)
        ends[-1] = pull / 2
        for iteration in range(20):
            increment = np.stack([slip - self.slip, np.zeros(joint.CELLS)], axis=1)
            step = self.contacts.step(joint.pressures(), increment, keep=False)
            rest = self.plates @ slip + self.area * step.force[:, 0] - ends
            if np.max(np.abs(rest)) <= 1e-9 * joint.first_loading().slip_pull:
                break
            slip -= np.linalg.solve(self.plates + np.diag(self.area * step.stiffness[:, 0, 0]), rest)
        else:
            pytest.fail(f"Newton's method has not converged at {pull:g} N")
        self.iterations = max(self.iterations, iteration)
        self.contacts.step(joint.pressures(), increment)
        self.slip = slip
        return float(slip[-1] + pull / self.tension * self.arm)


def test_the_page_has_the_numbers_of_the_joint() -> None:
    page = (DOCS / "dev" / "validation-data.md").read_text(encoding="utf-8")
    loading, model, rigid = joint.first_loading(), joint.iwan(), joint.rigid_loading()
    share = loading.pull / loading.slip_pull
    fitted = share >= joint.FITTED[0]
    ratio = (model.work(loading.pull) / loading.work)[fitted]
    apart = model.displacement(loading.pull)[fitted] / loading.displacement[fitted]
    said = [
        f"F_S = {1e-3 * model.slip_force:.2f} kN, K_T = {1e-6 * model.stiffness:.0f} N/µm, "
        f"χ = {model.chi:.2f} and β = {model.beta:.2f}".replace("-", "−"),
        f"to the power {joint.slope(loading, *joint.FITTED):.2f}",
        f"{joint.slope(loading, 0.02, 0.05):.1f} below a twentieth",
        f"to the power {joint.slope(rigid, 0.02, 0.1):.2f}",
        f"{100 * (ratio.min() - 1):.0f} % to +{100 * (ratio.max() - 1):.0f} %".replace("-", "−"),
        f"{100 * (apart.max() - 1):.0f} % too far",
    ]
    for part in (0.1, 0.2, 0.5, 0.9):
        at = [np.exp(np.interp(np.log(part), np.log(share), np.log(values))) for values in (
            loading.pull, loading.displacement, loading.work, model.work(loading.pull))]  # fmt: skip
        said.append(f"| {1e-3 * at[0]:.2f} | {1e6 * at[1]:.2f} | {1e3 * at[2]:.3g} | {1e3 * at[3]:.3g} |")
    missing = [words for words in said if words not in page]
    assert not missing
    guide = " ".join((DOCS / "stiffness-and-microslip.md").read_text(encoding="utf-8").split())
    assert f"to the power {joint.slope(loading, *joint.FITTED):.2f}, because" in guide
    assert f"within {100 * np.abs(ratio - 1).max():.0f} % from a tenth of the slip load up" in guide


def test_the_law_holds_for_the_joint() -> None:
    law, pressures = joint.contact(), joint.pressures()
    assert law.check(float(pressures[-1]), float(pressures[0])) == Warnings(0)
    assert joint.WIDTH * joint.HALF_LENGTH / joint.CELLS * np.sum(pressures) == pytest.approx(joint.CLAMP / 2)


def test_between_rigid_plates_the_work_of_small_amplitudes_is_cubic() -> None:
    """Of contacts that slip from their rims, whatever their shape: Putignano, Ciavarella and Barber (2011)."""
    assert joint.slope(joint.rigid_loading(), 0.01, 0.03) == pytest.approx(3.0, abs=0.03)


@pytest.mark.parametrize("chi, beta", [(-0.5, 1.0), (0.0, 0.2), (-0.8, 3.0)])
def test_the_closed_form_of_iwan_is_that_of_its_sliders(chi: float, beta: float) -> None:
    """The definition in Segalman (2005): the distribution of strengths, summed slider by slider."""
    model = joint.Iwan(3.0, 7.0, chi, beta)
    edges = np.linspace(0.0, 1.0, 200_001) ** 4 * model.slip_displacement
    strengths, density = 0.5 * (edges[1:] + edges[:-1]), np.diff(edges)
    density = density * strengths**chi
    ends = model.slip_displacement ** (chi + 1) / (chi + 1) * beta / np.sum(density)
    sliders, shares = np.append(strengths, model.slip_displacement), np.append(density, ends * np.sum(density))
    shares *= model.stiffness / np.sum(shares)
    assert np.sum(shares * sliders) == pytest.approx(model.slip_force, rel=1e-3)
    for part in (0.05, 0.3, 0.9):
        slip = part * model.slip_displacement
        force = np.sum(shares * np.minimum(slip, sliders))
        work = 4 * np.sum(shares * sliders * np.maximum(slip - sliders, 0.0))
        assert model.force(np.array(slip)) == pytest.approx(force, rel=1e-3)
        assert model.work(np.array([force]))[0] == pytest.approx(work, rel=5e-3)


@pytest.mark.parametrize("chi, beta, slip, force, work", [
    (-0.5, 1.0, 0.0642857143, 0.402566, 0.00243954), (-0.5, 1.0, 0.321428571, 1.71967, 0.136371),
    (-0.5, 1.0, 0.578571429, 2.76928, 0.592792), (0.0, 0.2, 0.0734693878, 0.492857, 0.00209913),
    (0.0, 0.2, 0.367346939, 2.03571, 0.262391), (0.0, 0.2, 0.66122449, 2.89286, 1.53026),
    (-0.5, 0.0, 0.128571429, 0.710264, 0.0195163), (-0.5, 0.0, 0.642857143, 2.37868, 1.09097),
    (-0.5, 0.0, 1.15714286, 2.97711, 4.74234),
])  # fmt: skip
def test_iwan_is_that_of_tmdsimpy(chi: float, beta: float, slip: float, force: float, work: float) -> None:
    """`Iwan4Force` of github.com/tmd-lab/tmdsimpy, commit 17d5fc3, with F_S = 3, K_T = 7 and 4000 sliders: the force of the first
    loading, and the area of a loop in 4000 steps."""
    model = joint.Iwan(3.0, 7.0, chi, beta)
    assert model.force(np.array(slip)) == pytest.approx(force, rel=5e-6)
    assert model.work(model.force(np.array([slip])))[0] == pytest.approx(work, rel=1e-4)


def test_steps_with_the_contact_that_remembers_close_the_same_loops() -> None:
    """Elements in place of the exact curve, steps in place of Masing's rule: the same joint, as a solver sees it."""
    loading = joint.first_loading()
    for part in (0.9, 0.5, 0.2, 0.1):
        stepped, points = Stepped(), []
        for begin, end in ((0.0, part), (part, -part), (-part, part)):
            for share in np.linspace(begin, end, 25)[1:]:
                pull = share * loading.slip_pull
                points.append((stepped.displacement(pull), pull))
        displacement, pull = np.array(points[23:]).T
        work = float(np.sum(0.5 * (pull[1:] + pull[:-1]) * np.diff(displacement)))
        expected = np.exp(np.interp(np.log(part * loading.slip_pull), np.log(loading.pull), np.log(loading.work)))
        assert abs(work) == pytest.approx(expected, rel=3e-3)
        assert displacement[-1] == pytest.approx(displacement[0], rel=1e-9)
        assert stepped.iterations <= 6
