"""Tangential stiffness, microslip and hysteresis, and summits that yield."""

from __future__ import annotations

import math
import pickle
from dataclasses import replace

import numpy as np
import pytest

from asperity import Error, Model, Params, Status

ELASTIC = Params.paper()
YIELDING = replace(ELASTIC, work_of_adhesion=0.0, hardness=0.005 * ELASTIC.composite_modulus, contact_law="elastic-plastic")


@pytest.fixture(params=[ELASTIC, YIELDING], ids=["elastic", "yielding"])
def law(request: pytest.FixtureRequest) -> Model:
    return Model(request.param)


def test_the_stiffness_is_that_of_the_state(law: Model) -> None:
    loads = np.geomspace(1e-2, 1e4, 12).reshape(3, 4)
    stiffness = law.tangential_stiffness_at_load(loads)
    assert stiffness.shape == loads.shape
    for load, found in zip(loads.flat, stiffness.flat):
        assert type(law.tangential_stiffness_at_load(float(load))) is float
        assert law.tangential_stiffness_at_load(float(load)) == found
        assert math.isclose(law.state_at_load(float(load)).tangential_stiffness, found, rel_tol=1e-6)
    assert law.tangential_stiffness_at_load(-1e9) == 0.0
    with pytest.raises(Error, match="element 1: load = nan|element 1: load = NaN") as refusal:
        law.tangential_stiffness_at_load([1.0, math.nan])
    assert refusal.value.status is Status.INVALID_LOAD


def test_force_and_slope_of_numbers_and_arrays(law: Model) -> None:
    length = law.friction_force_at_load(100.0) / law.tangential_stiffness_at_load(100.0)
    displacements = np.array([-2.0, -0.3, 0.0, 0.3, 2.0, 1e4]) * length
    force, slope = law.tangential(100.0, displacements)
    assert force.shape == slope.shape == displacements.shape
    assert force[:5].tolist() == (-force[4::-1]).tolist() and slope[:5].tolist() == slope[4::-1].tolist()
    assert math.isclose(slope[2], law.tangential_stiffness_at_load(100.0), rel_tol=1e-6) and slope[5] == 0.0
    assert math.isclose(force[5], law.friction_force_at_load(100.0), rel_tol=1e-6)
    one = law.tangential(100.0, displacements[3])
    assert [type(x) for x in one] == [float, float] and one == (force[3], slope[3])
    table, _ = law.tangential([[10.0], [100.0]], displacements)
    assert table.shape == (2, 6) and table[1].tolist() == force.tolist()
    for load, displacement, status in [
        (-1e9, 1.0, Status.SEPARATED), (math.nan, 1.0, Status.INVALID_LOAD), (1.0, math.inf, Status.INVALID_PARAMETER),
    ]:  # fmt: skip
        with pytest.raises(Error) as refusal:
            law.tangential(load, displacement)
        assert refusal.value.status is status


def test_a_loop_is_closed_and_its_work_is_the_area(law: Model) -> None:
    length = law.friction_force_at_load(100.0) / law.tangential_stiffness_at_load(100.0)
    last = 0.0
    for amplitude in (0.3 * length, length, 4.0 * length):
        loop = law.hysteresis(100.0, amplitude, points=801)
        assert loop.displacement[0] == loop.displacement[-1] == amplitude == -loop.displacement[800]
        top = law.tangential(100.0, amplitude)[0]
        ends = loop.force[[0, 800, 801, -1]]
        assert ends == pytest.approx([top, -top, -top, top], rel=1e-13)
        area = float(np.sum(0.5 * (loop.force[1:] + loop.force[:-1]) * np.diff(loop.displacement)))
        assert math.isclose(loop.work, area, rel_tol=1e-9, abs_tol=1e-9 * top * amplitude) and loop.work > last
        # Half way back from the top: two halves of the first loading.
        half = law.tangential(100.0, 0.5 * amplitude)[0]
        assert math.isclose(loop.force[400], top - 2.0 * half, rel_tol=1e-9, abs_tol=1e-12 * top)
        last = loop.work


def test_equal_summits_dissipate_four_times_the_force_times_the_slip() -> None:
    """Far below the heights all summits are of one size, to the 80th part of their overlap."""
    model = Model(replace(ELASTIC, work_of_adhesion=0.0, slip_onset="whole"))
    load = model.state_at_gap(-80 * ELASTIC.height_std).load
    force, stiffness = model.friction_force_at_load(load), model.tangential_stiffness_at_load(load)
    for part in (0.5, 1.0, 1.5, 3.0):
        loop = model.hysteresis(load, part * force / stiffness, points=2001)
        slip = max(0.0, part - 1.0) * force / stiffness
        assert loop.work == pytest.approx(4.0 * force * slip, rel=5e-3, abs=2e-2 * force * force / stiffness)


def test_contacts_that_remember_follow_the_exact_loop(law: Model) -> None:
    load = 100.0
    strength, stiffness = law.friction_force_at_load(load), law.tangential_stiffness_at_load(load)
    length = strength / stiffness
    contact = law.microslip()
    loop = law.hysteresis(load, 1.5 * length, points=101)
    path = np.concatenate([np.linspace(0.0, 1.5 * length, 101), loop.displacement[1:]])
    exact = np.concatenate([law.tangential(load, path[:101])[0], loop.force[1:]])
    steps = [contact.step(load, [by, 0.0], details=True) for by in np.diff(path, prepend=0.0)]
    found = np.array([step.force[0] for step in steps])
    assert np.abs(found - exact).max() < 0.02 * strength  # a loop has twice the error of the first loading
    assert all(step.dissipated is not None and step.dissipated >= 0.0 for step in steps)
    work = sum(float(step.dissipated or 0.0) for step in steps[101:])
    assert work == pytest.approx(loop.work, rel=0.05)
    # The first parts slip at once.
    assert steps[1].stiffness[0, 0] == pytest.approx(stiffness, rel=0.01) and steps[0].force.tolist() == [0.0, 0.0]
    assert steps[0].slipping == 0.0 and steps[-1].dforce_dload is not None and steps[-1].dforce_dload.shape == (2,)


def test_many_contacts_step_at_once_and_only_for_good_if_they_are_told_to(law: Model) -> None:
    loads = np.geomspace(1.0, 1e3, 6).reshape(2, 3)
    length = law.friction_force_at_load(loads) / law.tangential_stiffness_at_load(loads)
    contacts = law.microslip((2, 3))
    increment = np.stack([0.5 * length, -0.2 * length], axis=-1)
    trial = contacts.step(loads, increment, keep=False, details=True)
    assert not contacts.state.any() and trial.force.shape == (2, 3, 2) and trial.stiffness.shape == (2, 3, 2, 2)
    kept = contacts.step(loads, increment)
    assert kept.force.tolist() == trial.force.tolist() and contacts.state.any() and kept.slipping is None
    assert trial.slipping is not None and trial.slipping.shape == (2, 3) and (trial.slipping > 0.0).all()
    one = law.microslip(1)
    assert one.step(loads[1, 2], increment[1, 2]).force[0].tolist() == kept.force[1, 2].tolist()
    # An open contact forgets; what has no answer leaves all as it was.
    loads[0, 0] = -1e9
    assert contacts.step(loads, np.zeros(2)).force[0, 0].tolist() == [0.0, 0.0] and not contacts.state[0, 0].any()
    before = contacts.state.copy()
    for load, by, status in [
        (math.nan, 0.0, Status.INVALID_LOAD), (1e300, 0.0, Status.OUT_OF_RANGE), (1.0, math.inf, Status.INVALID_PARAMETER),
    ]:  # fmt: skip
        loads[1, 1] = load
        with pytest.raises(Error) as refusal:
            contacts.step(loads, [by, 0.0])
        assert refusal.value.status is status and contacts.state.tolist() == before.tolist()
    with pytest.raises(ValueError, match="increment of shape"):
        contacts.step(1.0, [0.0, 0.0, 0.0])


def test_states_turn_and_are_pickled(law: Model) -> None:
    load = 100.0
    length = law.friction_force_at_load(load) / law.tangential_stiffness_at_load(load)
    contacts = law.microslip(2)
    contacts.step(load, [0.8 * length, 0.1 * length])
    saved = pickle.loads(pickle.dumps(contacts))
    before = contacts.step(load, [0.0, 0.0], keep=False).force
    contacts.turn([0.0, math.pi / 2])
    turned = contacts.step(load, [0.0, 0.0], keep=False).force
    assert turned[0].tolist() == before[0].tolist()
    assert turned[1] == pytest.approx([-before[1, 1], before[1, 0]], rel=1e-12)
    assert saved.step(load, [0.0, 0.0]).force.tolist() == before.tolist()
    kept = contacts.state.copy()
    with pytest.raises(Error, match="cosine = nan: must be finite|cosine = NaN: must be finite"):
        contacts.turn(math.inf)
    with pytest.raises(ValueError, match="angle of shape"):
        contacts.turn([0.0, 0.0, 0.0])
    assert contacts.state.tolist() == kept.tolist()


def test_contacts_whose_load_changes_give_no_energy(law: Model) -> None:
    load = 100.0
    length = law.friction_force_at_load(load) / law.tangential_stiffness_at_load(load)
    contact = law.microslip()
    work = lost = force = 0.0
    for now, by in [(load, 0.3), (0.3 * load, 0.0), (0.3 * load, -0.3), (load, 0.0)]:
        for _ in range(100):
            step = contact.step(now, [by * length / 100, 0.0], details=True)
            work += 0.5 * (force + float(step.force[0])) * by * length / 100
            force, lost = float(step.force[0]), lost + float(step.dissipated if step.dissipated is not None else 0.0)
    assert 0.0 < lost <= work * (1.0 + 1e-3)


def test_contacts_that_slip_as_a_whole_dissipate_less_at_small_amplitude(law: Model) -> None:
    whole = Model(replace(law.params, slip_onset="whole"))
    amplitude = 0.25 * law.friction_force_at_load(100.0) / law.tangential_stiffness_at_load(100.0)
    assert whole.friction_force_at_load(100.0) == law.friction_force_at_load(100.0)
    assert whole.hysteresis(100.0, amplitude).work < 0.1 * law.hysteresis(100.0, amplitude).work
    with pytest.raises(Error, match="slip_onset = 'half': must be one of 'partial', 'whole'"):
        replace(law.params, slip_onset="half")  # type: ignore[arg-type]


def test_bad_amplitudes_are_refused(law: Model) -> None:
    for amplitude in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(ValueError, match="amplitude = .*: must be finite and > 0"):
            law.hysteresis(1.0, amplitude)
    with pytest.raises(ValueError, match="points = 1: must be 2 or more"):
        law.hysteresis(1.0, 1.0, points=1)


def test_summits_that_yield_need_a_hardness_and_no_adhesion() -> None:
    for params, message in [
        (replace(YIELDING, hardness=0.0), "hardness = 0: must be > 0 where contact_law is"),
        (replace(YIELDING, work_of_adhesion=1e-3), "work_of_adhesion = 0.001: must be 0 where contact_law is"),
    ]:
        with pytest.raises(Error, match=message) as refusal:
            Model(params)
        assert refusal.value.status is Status.INVALID_PARAMETER
    state = Model(YIELDING).state_at_load(100.0)
    assert 0.0 < state.fraction_elastic < 1.0 and 0.0 <= state.fraction_flowing < 1.0
    assert state.real_area > Model(replace(YIELDING, contact_law="maugis")).state_at_load(100.0).real_area
