"""The contract of a model: shapes, slopes, loads that are refused, memory, lifetime."""

from __future__ import annotations

import copy
import ctypes
import gc
import math
import pickle
import re
import tracemalloc
import warnings
from pathlib import Path
from typing import Any, Callable

import numpy as np
import numpy.typing as npt
import pytest

from asperity import Error, Model, Params, State, Status, Summary, ValidityWarning, Warnings
from asperity._library import LIBRARY

METHODS = ["friction_at_load", "friction_force_at_load"]


def call(model: Model, method: str) -> Callable[..., Any]:
    return getattr(model, method)  # type: ignore[no-any-return]


# ---- Shapes ----


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("number", [10.0, 10, np.float64(10), np.float32(10), np.int64(10)])
def test_a_number_gives_a_float(model: Model, method: str, number: Any) -> None:
    value = call(model, method)(number)
    assert type(value) is float and value == call(model, method)(10.0)
    value_again, slope = call(model, method)(number, slope=True)
    assert type(value_again) is float and type(slope) is float and value_again == value


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("shape", [(), (0,), (7,), (3, 4), (2, 0, 3), (2, 3, 4)])
def test_an_array_gives_an_array_of_its_shape(model: Model, method: str, shape: tuple[int, ...]) -> None:
    loads = np.geomspace(1e-3, 1e3, math.prod(shape)).reshape(shape)
    values, slopes = call(model, method)(loads, slope=True)
    assert type(values) is np.ndarray and values.shape == slopes.shape == shape
    assert values.dtype == slopes.dtype == np.float64
    assert np.array_equal(values, call(model, method)(loads))
    assert values.ravel().tolist() == [call(model, method)(load) for load in loads.ravel()]


@pytest.mark.parametrize(
    "loads",
    [
        [1.0, 2.0, 4.0],
        (1, 2, 4),
        np.array([1, 2, 4], dtype=np.int16),
        np.array([1, 2, 4], dtype=np.float32),
        np.array([1, 2, 4], dtype=">f8"),
        np.array([4.0, 2.0, 1.0])[::-1],
        np.frombuffer(b"\0" + np.array([1.0, 2.0, 4.0]).tobytes(), dtype=np.uint8)[1:].view(np.float64),
    ],
    ids=["list", "tuple", "int16", "float32", "big-endian", "reversed", "unaligned"],
)
def test_any_real_sequence_serves(model: Model, loads: Any) -> None:
    assert model.friction_at_load(loads).tolist() == [model.friction_at_load(x) for x in (1.0, 2.0, 4.0)]


# ---- No copies ----


def test_a_contiguous_float64_array_is_read_where_it_is(model: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    loads = np.geomspace(1e-3, 1e3, 1000)
    loads.flags.writeable = False
    before = loads.tobytes()
    seen = []
    batch = LIBRARY.asperity_friction_at_loads

    def spy(pointer: Any, n: int, load: Any, *rest: Any) -> int:
        seen.append(ctypes.cast(load, ctypes.c_void_p).value)
        return int(batch(pointer, n, load, *rest))

    monkeypatch.setattr(LIBRARY, "asperity_friction_at_loads", spy)
    model.friction_at_load(loads)
    model.friction_at_load(loads.reshape(10, 100))
    model.friction_at_load(loads[::2])
    assert seen[:2] == 2 * [loads.ctypes.data]
    assert seen[2] != loads.ctypes.data
    assert loads.tobytes() == before


def test_memory_is_that_of_the_answer(model: Model) -> None:
    loads = np.linspace(1, 2, 1_000_000)
    tracemalloc.start()
    try:
        model.friction_at_load(loads)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert loads.nbytes <= peak < 1.25 * loads.nbytes


# ---- Slopes ----


# ---- Loads at the edge of contact ----


@pytest.mark.parametrize("method", METHODS)
def test_below_pull_off_friction_is_zero_and_no_error(sticky: Params, method: str) -> None:
    with Model(sticky) as model:
        below = 1.001 * model.summary().pull_off_load
        assert call(model, method)(below) == 0
        assert call(model, method)(below, slope=True) == (0, 0)
        values, slopes = call(model, method)(np.array([below, 1.0, -1e300]), slope=True)
        assert values[[0, 2]].tolist() == slopes[[0, 2]].tolist() == [0, 0] and values[1] > 0
        with pytest.raises(Error, match="below the pull-off load") as caught:
            model.state_at_load(below)
        assert caught.value.status is Status.SEPARATED


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("load, status", [(math.nan, 3), (math.inf, 3), (-math.inf, 3), (1e300, 5)])
def test_loads_without_an_answer_raise_and_name_their_index(
    model: Model, method: str, load: float, status: int
) -> None:
    friction = call(model, method)
    cases: list[tuple[Any, str]] = [
        (load, "load = "),
        ([1.0, load, 2.0, math.nan], "element 1: load = "),
        ([-1e9, 1.0, load], "element 2: load = "),  # a separated element comes first
        ([[1.0, 2.0], [3.0, load]], r"element \(1, 1\): load = "),
        (np.array(load), "load = "),
    ]
    for loads, message in cases:
        for slope in (False, True):
            with pytest.raises(Error, match=f"^{message}") as caught:
                friction(loads, slope=slope)
            assert caught.value.status == status


def test_a_state_takes_single_precision(model: Model) -> None:
    single: Any = np.float32(1.0)
    assert model.state_at_load(single) == model.state_at_load(1)


def test_warnings_say_what_fails_and_what_to_do(params: Params) -> None:
    soft_and_weak = params.replace(hardness=0.001, slip_stress_1=1e-5, slip_stress_2=1e-5)
    with Model(soft_and_weak) as soft, Model(params.replace(slip_stress_1=0.02)) as model:
        warnings = soft.state_at_load(10.0).warnings
        assert f"{warnings}" == str(warnings) and f"{warnings:d}" == "1"
        assert str(warnings).startswith("PLASTIC: asperities yield: ") and "; use the elastic-plastic" in str(warnings)
        assert str(model.state_at_load(10.0).warnings) == "none"
    several = Warnings(0x1012)
    assert several.kinds == [Warnings.CROWDED, Warnings.FEW, Warnings(0x1000)]
    lines = str(several).split("\n")
    assert [line.split(":")[0] for line in lines] == ["CROWDED", "FEW", "bit 0x1000"]
    assert all(re.search("; (use|measure|filter|calibrate|give) ", kind.description) for kind in Warnings)


def test_a_strength_that_nobody_measured_is_warned_of(params: Params) -> None:
    rough = params.replace(asperity_count=1e5, work_of_adhesion=0.0)
    with Model(rough) as default, Model(rough.calibrated(1e6, 0.3)) as measured:
        assert default.check(1e6, 2e6) == Warnings.UNCALIBRATED and measured.check(1e6, 2e6) == 0
        assert measured.friction_at_load(1e6) == pytest.approx(0.3, rel=1e-6)
        with pytest.warns(ValidityWarning, match="UNCALIBRATED: the strength of the interface is the default"):
            default.warn(1e6, 2e6)


def test_a_range_of_loads_is_checked_as_a_whole(params: Params) -> None:
    with Model(params.replace(asperity_count=1e5, work_of_adhesion=0.0, slip_stress_1=0.02)) as model:
        assert model.check(1e6, 2e6) == 0 and not model.check(1e6, 2e6)
        assert model.check(1e-2, 1e9) == Warnings.FEW | Warnings.CROWDED
        seen = Warnings(0)
        for load in np.geomspace(1e-2, 1e9, 30):
            seen |= model.state_at_load(load).warnings
        assert seen == model.check(1e-2, 1e9)
        with pytest.raises(Error, match="^lightest = 2: must not be above heaviest$"):
            model.check(2.0, 1.0)
        with pytest.raises(Error, match="^lightest = NaN: must be finite$"):
            model.check(math.nan, 1.0)


def test_each_kind_of_warning_is_issued_once_per_model(params: Params) -> None:
    few = params.replace(asperity_count=1e5, work_of_adhesion=0.0, slip_stress_1=0.02)
    for _ in range(2):
        with Model(few) as model:
            model.warn(1e6, 2e6)  # which warns of nothing: warnings are errors here
            with pytest.warns(ValidityWarning, match="between the loads 0.01 and 1e\\+06: FEW: fewer than 20") as issued:
                model.warn(1e-2, 1e6)
                model.warn(1e-2, 1e6)
            with pytest.warns(ValidityWarning, match="CROWDED") as more:
                model.warn(1e-2, 1e9)
            assert len(issued) == len(more) == 1


# ---- Results ----


def test_results_are_frozen_dataclasses(model: Model) -> None:
    state, summary = model.state_at_load(10.0), model.summary()
    assert isinstance(state, State) and isinstance(summary, Summary)
    assert state == model.state_at_load(10.0)
    assert state.load == 10.0 and summary.alpha == pytest.approx(0.01, rel=1e-14)
    for result in (state, summary):
        with pytest.raises(AttributeError):
            result.load = 1.0  # type: ignore[union-attr, misc]
        assert all(type(value) is (Warnings if name == "warnings" else float) for name, value in vars(result).items())
        assert pickle.loads(pickle.dumps(result)) == result


# ---- Parameters ----


@pytest.mark.parametrize(
    "change, message, status",
    [
        ({"summit_radius": -1.0}, "summit_radius = -1: must be finite and > 0", Status.INVALID_PARAMETER),
        ({"weibull_shape": -2.0}, "weibull_shape = -2: must be finite and > 0", Status.INVALID_PARAMETER),
        ({"radius_amplitude": 1.5}, "radius_amplitude = 1.5: must be between -1 and 1", Status.INVALID_PARAMETER),
        ({"height_std": math.nan}, "height_std = NaN: must be finite", Status.INVALID_PARAMETER),
        ({"height_std": 1e30}, "alpha = .* must be between", Status.OUT_OF_RANGE),
    ],
)
def test_a_model_refuses_parameters_with_the_librarys_message(
    params: Params, model: Model, change: dict[str, float], message: str, status: Status
) -> None:
    bad = params.replace(**change)
    with pytest.raises(Error, match=message) as caught:
        Model(bad)
    assert caught.value.status is status
    assert isinstance(caught.value, ValueError)
    before = model.friction_at_load(10.0)
    with pytest.raises(Error, match=message):
        model.set_params(bad)
    assert model.friction_at_load(10.0) == before and model.params == params


def test_other_parameters_are_another_law(params: Params, model: Model) -> None:
    other = params.replace(asperity_count=2)
    half = model.friction_at_load(5.0)
    model.set_params(other)
    assert model.params == other
    assert model.friction_at_load(10.0) == pytest.approx(half, rel=1e-10)  # twice the summits carry twice the load


def test_one_asperity_springs_back_as_the_page_of_joints_says_beside_other_laws(root: Path) -> None:
    radius, modulus, hardness = 1e-3, 115e9, 0.5e9
    shape = {"asperity_count": 1, "summit_radius": radius, "height_std": 1e-11, "composite_modulus": modulus, "effective_shear_modulus": 8e10}
    law = {"hardness": hardness, "contact_law": "elastic-plastic", "burgers_vector": 0.25e-9, "adhesion_range": 0.25e-9}
    summit = Model(Params.from_text("\n".join(f"{key} = {value!r}".replace("'", '"') for key, value in (shape | law).items())))
    rows = []
    for ratio in (3, 10, 30, 100):
        overlap = ratio * (0.3 * np.pi * hardness / modulus) ** 2 * radius
        top = summit.state_at_load(summit.state_at_gap(-overlap).load)
        after = summit.unloaded(top.load)
        stays = -after.state_at_load(1e-9 * top.load).gap / overlap
        half = after.state_at_gap(-overlap * 0.5 * (1 + stays))
        etsion = ((1 - ratio**-0.28) * (1 - ratio**-0.69), 0.5 ** (1.5 * ratio**-0.0331), 0.5 ** ratio**-0.12)
        brake = (1 - top.load / (4 / 3 * modulus * np.sqrt(radius * overlap) * overlap), np.pi * radius * overlap * 0.5 / top.real_area)
        rows.append((stays, *etsion, half.load / top.load, half.real_area / top.real_area, *brake))
    column = np.array(rows).T
    ends = [f"{column[i, 0]:.2f} to {column[i, -1]:.2f}" for i in range(8)]
    apart = np.max(np.abs(column[0] - column[1]))
    page = " ".join((root / "docs" / "joint.md").read_text(encoding="utf-8").split())
    for told in (
        f"stays is {ends[0]} of the largest, theirs {ends[1]}, at most {apart:.2f} apart",
        f"the load is {column[4, 0]:.2f} of the largest, theirs {ends[2]}, and the area {column[5, 0]:.2f}, theirs {ends[3]}",
        f"{ends[6]} of the overlap stays, and half way back {ends[7]} of the area",
    ):
        assert told in page
    assert np.ptp(column[4]) < 0.01 and np.ptp(column[5]) < 0.01


def test_the_joint_of_its_page_has_the_exponents_that_stand_there(root: Path) -> None:
    page = (root / "docs" / "joint.md").read_text(encoding="utf-8")
    first = Model(Params.from_text(page.split("```toml\n")[1].split("```")[0]))
    load = 70e6 * first.params.nominal_area
    top, columns = first.state_at_load(load), []
    for law in (first, first.unloaded(load)):
        low, high = law.state_at_load(0.3 * load), law.state_at_load(0.9 * load)
        columns.append((f"{math.log(high.contact_radius_sum / low.contact_radius_sum) / math.log(3):.2f}", f"{-high.tangential_stiffness / high.dload_dgap:.2f}"))
    (exponent, ratio), (exponent_after, ratio_after) = columns
    assert f"| unloading stiffness over that of loading, at 70 MPa | {top.unloading_stiffness / -top.dload_dgap:.2f} | |" in page
    assert all(f"| {of} as p^n | {exponent} | {exponent_after} |" in page for of in ("conductance", "K_t"))
    assert f"| K_t/K_n | {ratio} | {ratio_after} |" in page


def test_a_joint_that_was_tightened_springs_back(params: Params) -> None:
    first = Model(params.replace(work_of_adhesion=0.0).elastic_plastic(0.002 * params.composite_modulus))
    joint = first.unloaded(10.0)
    assert (first.summary().largest_load, joint.summary().largest_load) == (0.0, 10.0)
    assert joint.friction_at_load(3.0) > 1.05 * first.friction_at_load(3.0)
    assert joint.friction_at_load(30.0) == pytest.approx(first.friction_at_load(30.0), rel=1e-6)
    top, under = first.state_at_load(10.0), joint.state_at_load(10.0 * (1 - 1e-9))
    assert -under.dload_dgap == pytest.approx(top.unloading_stiffness, rel=1e-6)
    assert top.unloading_stiffness > -top.dload_dgap
    contact, twin = joint.microslip(), pickle.loads(pickle.dumps(joint))
    copied = pickle.loads(pickle.dumps(contact))
    assert twin.friction_at_load(3.0) == joint.friction_at_load(3.0)
    assert joint.unloaded(10.0).friction_at_load(3.0) == pytest.approx(joint.friction_at_load(3.0), rel=1e-6)
    assert copied.step(3.0, [1.0, 0.0]).force[0] == contact.step(3.0, [1.0, 0.0]).force[0] > 0
    assert Model(joint.params).friction_at_load(3.0) == first.friction_at_load(3.0)
    assert repr(joint) == f"Model({first.params!r}).unloaded(10)"
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # of few summits
        curve = Model(first.params.calibrated(load=10.0, friction_coefficient=1.0)).unloaded(10.0).curve([0.1, 1.0, 5.0])
    assert curve.low is not None and curve.high is not None
    assert np.all(curve.low < curve.friction_coefficient) and np.all(curve.friction_coefficient < curve.high)


@pytest.mark.parametrize("load", [0.0, -1.0, np.nan, np.inf, 1e300])
def test_a_largest_load_that_cannot_be_is_refused(params: Params, load: float) -> None:
    first = Model(params.replace(work_of_adhesion=0.0).elastic_plastic(0.002 * params.composite_modulus))
    with pytest.raises(Error, match="largest_load"):
        first.unloaded(load)
    with pytest.raises(Error, match="largest_load = 9: must not be below the largest load that this model has borne"):
        first.unloaded(10.0).unloaded(9.0)
    with pytest.raises(Error, match="unloading of surfaces with adhesion is not modelled"):
        Model(params).unloaded(1.0)


# ---- Lifetime ----


class Freed:
    """Counts how often each handle is freed, and frees it."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.count = 0
        self.free = LIBRARY.asperity_free
        monkeypatch.setattr(LIBRARY, "asperity_free", self)

    def __call__(self, pointer: Any) -> None:
        self.count += 1
        self.free(pointer)


def test_a_handle_is_freed_once(params: Params, monkeypatch: pytest.MonkeyPatch) -> None:
    freed = Freed(monkeypatch)
    with Model(params) as model:
        assert freed.count == 0
    assert freed.count == 1
    model.close()
    del model
    gc.collect()
    assert freed.count == 1

    model = Model(params)
    model.set_params(params.replace(asperity_count=2))
    assert freed.count == 2
    del model
    gc.collect()
    assert freed.count == 3

    with pytest.raises(Error):
        Model(params.replace(height_std=-1))
    gc.collect()
    assert freed.count == 3


def test_a_closed_model_raises(params: Params) -> None:
    model = Model(params)
    model.close()
    uses: list[Callable[[], Any]] = [
        lambda: model.friction_at_load(1.0), lambda: model.friction_at_load([1.0]), lambda: model.state_at_load(1.0),
        lambda: model.summary(), lambda: model.params, lambda: pickle.dumps(model), model.__enter__,
    ]  # fmt: skip
    for use in uses:
        with pytest.raises(Error, match="the model is closed"):
            use()
    assert repr(model) == "<closed Model>"
    model.set_params(params)
    assert model.friction_at_load(1.0) > 0


def test_a_model_pickles_and_copies_through_its_parameters(model: Model) -> None:
    for twin in (pickle.loads(pickle.dumps(model)), copy.copy(model), copy.deepcopy(model)):
        assert twin.params == model.params
        assert twin._handle is not model._handle
        assert twin.friction_at_load(3.0) == model.friction_at_load(3.0)
    assert repr(model) == f"Model({model.params!r})"


def test_an_error_pickles_with_its_status() -> None:
    error = pickle.loads(pickle.dumps(Error("load = NaN: must be finite", Status.INVALID_LOAD)))
    assert (str(error), error.status) == ("load = NaN: must be finite", Status.INVALID_LOAD)
    assert "pull-off" in Status.SEPARATED.description


def as_array(model: Model, loads: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Read by mypy: the types of both forms."""
    number: float = model.friction_at_load(1.0)
    pair: tuple[float, float] = model.friction_force_at_load(1.0, slope=True)
    values, slopes = model.friction_at_load(loads, slope=True)
    return values * number + slopes * pair[1]
