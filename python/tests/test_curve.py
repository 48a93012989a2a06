"""Curves, arrays of states, labels in and out, progress, and how things show themselves."""

from __future__ import annotations

import math
import sys
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pandas
import pytest
import xarray

from asperity import Error, Model, Params, ValidityWarning, Warnings, friction, materials, pads, uncertainty
from asperity.estimate import estimate
from asperity.fits.uncertainty import ALL_ELSE

LOADS = np.geomspace(1.0, 100.0, 7)


@pytest.fixture(scope="module")
def params() -> Params:
    """The paper's case with a strength that is given: bands have no part of it."""
    return Params.paper().replace(slip_stress_1=0.02)


# ---- Curves ----


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_a_band_of_the_strength_is_that_of_the_estimate(tmp_path: Path) -> None:
    """Of the file that the parameters write, where all but the strength counts as known there too. Before a measurement the estimate takes
    a strength as known to a factor of 100, the curve to one of 10."""
    loads, file = np.geomspace(0.1, 10.0, 5), tmp_path / "surface.toml"
    alone = ("model_error = 0\n", "[known_to]\nslope = 1\nwork_of_adhesion = 1\n")
    silicon = Params.from_iso25178(Sq=5e-9, Sdq=0.08, nominal_area=1e-6, **materials.PAIRS["Si/Si"].contact)
    of_others = friction(pair="Si/Si", Sq=5e-9, Sdq=0.08, nominal_area=1e-6, pressure_coefficient=0, load=1.0).params
    for params, is_measured in ((silicon, False), (of_others, False), (silicon.calibrated(1.0, 0.4), True)):
        params.to_toml(file)
        text = alone[0] + file.read_text(encoding="utf-8") + alone[1]
        found, expected = Model(params).curve(loads), estimate(text, loads)
        assert expected.strength == ("measured" if is_measured else "default") and expected.params == params
        for name, of_estimate in (("friction_coefficient", "value"), ("low", "low"), ("high", "high")):
            assert getattr(found, name) == pytest.approx(getattr(expected, of_estimate), rel=1e-4 if is_measured else 3e-5), name


def test_a_curve_is_the_friction_of_the_model_with_the_band_of_its_spread(model: Model) -> None:
    curve = model.curve(LOADS[::-1], spread={"w": 0.2}, coverage=0.9)
    assert curve.load.tolist() == LOADS.tolist()
    assert curve.friction_coefficient.tolist() == model.friction_at_load(LOADS).tolist()
    assert curve.friction_force.tolist() == model.friction_force_at_load(LOADS).tolist()
    band = uncertainty(model.params, {"w": 0.2}, LOADS, coverage=0.9)
    assert curve.low is not None and curve.high is not None
    assert (curve.low.tolist(), curve.high.tolist()) == (band.low.tolist(), band.high.tolist())
    assert curve.coverage == 0.9 and curve.warnings == model.check(1.0, 100.0)


def test_a_curve_has_loads_and_warns_by_itself(model: Model) -> None:
    with Model(model.params.replace(asperity_count=1e5, slip_stress_1=0.02)) as many:
        with pytest.warns(ValidityWarning, match=r"between the loads 1e\+07 and 1e\+09: CROWDED"):
            assert many.curve([1e7, 1e9]).warnings == Warnings.CROWDED
    curve = model.curve()
    unit = model.params.composite_modulus
    assert curve.load.size == 61 and curve.low is None and not curve.warnings
    assert (curve.load[0], curve.load[-1]) == pytest.approx((1e-4 * unit, 1e2 * unit))
    assert repr(curve).startswith("<Curve: friction coefficient ") and repr(curve).endswith(f"; strength of the interface: as given; {ALL_ELSE}>")


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_a_curve_has_a_band_where_nobody_measured_the_strength(tmp_path: Path) -> None:
    rough, loads = Params.paper().replace(asperity_count=1e5), 1e5 * LOADS
    with Model(rough) as model:
        curve = model.curve(loads)
        known = model.curve(loads, spread={"slip_stress": 0.0, "w": 0.1})
        html = model._repr_html_()
    assert curve.low is not None and curve.high is not None and known.high is not None
    assert curve.high == pytest.approx(10 * curve.friction_coefficient, rel=1e-9)
    assert curve.low == pytest.approx(curve.friction_coefficient / 10, rel=1e-9)
    assert (known.high < 1.5 * known.friction_coefficient).all()
    assert repr(curve).endswith("; 95 % band; strength of the interface: not measured, a factor 10 either way; all else: taken as known>")
    (axes,) = curve.plot(tmp_path / "curve.svg").axes
    assert axes.get_yscale() == "log"
    (polygon,) = ElementTree.fromstring(html[html.index("<svg") :]).iter("{http://www.w3.org/2000/svg}polygon")
    heights = [float(pair.split(",")[1]) for pair in polygon.get("points", "").split()]
    assert min(heights) > 0 and max(heights) < 140

    with Model(rough.calibrated(1e6, 0.3, error=0.1)) as model:
        measured = model.curve(loads)
    assert measured.high is not None and measured.rests_on == ("strength of the interface: measured at 1e+06 [force] to 10 %", ALL_ELSE)
    assert measured.high == pytest.approx(math.exp(0.1 * 1.96) * measured.friction_coefficient, rel=0.01)


@pytest.mark.parametrize("loads", [[], [0.0, 1.0], [[1.0, 2.0]], [-1.0], [math.nan]])
def test_loads_that_a_curve_cannot_have_are_refused(model: Model, loads: Any) -> None:
    with pytest.raises(Error, match="^loads"):
        model.curve(loads)


def test_a_curve_is_drawn_with_its_band_and_units(model: Model, tmp_path: Path) -> None:
    assert model.curve(LOADS).plot().axes[0].get_xlabel() == "normal load $P$ [force]"
    curve = Model(model.params.replace(in_si=True)).curve(LOADS, spread={"w": 0.2})
    assert "from 1 to 100 [N]; " in repr(curve)
    figure = curve.plot(tmp_path / "curve.svg")
    (axes,) = figure.axes
    assert axes.get_xlabel() == "normal load $P$ [N]" and axes.get_xscale() == "log"
    assert np.array_equal(axes.lines[0].get_xydata(), np.column_stack([LOADS, curve.friction_coefficient]))
    legend = axes.get_legend()
    assert len(axes.collections) == 1 and legend is not None
    assert [text.get_text() for text in legend.get_texts()] == [f"95 % band\nstrength of the interface: as given\nw: 20 %\n{ALL_ELSE}"]
    again = tmp_path / "again.svg"
    curve.plot(again)
    assert again.read_bytes() == (tmp_path / "curve.svg").read_bytes()
    assert curve.plot(axes=axes) is figure and len(axes.lines) == 2


def test_figures_have_one_style_whatever_the_caller_set(model: Model) -> None:
    import matplotlib

    with matplotlib.rc_context({"font.size": 33, "lines.linewidth": 9}):
        (axes,) = model.curve(LOADS).plot().axes
    assert axes.lines[0].get_linewidth() == 1.6 and axes.xaxis.label.get_fontsize() == 10
    assert axes.lines[0].get_color() == "#0072b2"


def test_without_matplotlib_every_figure_says_so(model: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    for draw in (model.curve(LOADS).plot, uncertainty(model.params, {"w": 0.1}, LOADS).plot):
        with pytest.raises(ImportError, match="drawing needs matplotlib .*: pip install matplotlib"):
            draw()


# ---- How things show themselves ----


def test_states_and_summaries_show_their_units(model: Model) -> None:
    text = repr(model.state_at_load(10.0))
    assert text.startswith("State\n  load                         10 [force]\n")
    assert f"\n  friction_coefficient         {model.state_at_load(10.0).friction_coefficient:.6g}\n" in text and "[length^2]" in text
    assert "\n  pull_off_load                " in repr(model.summary())
    assert "  composite_modulus            2.85714 [stress]\n" in str(model.params)
    assert "<td>[" not in model.params._repr_html_() and "<td>stress</td>" in model.params._repr_html_()


def test_a_model_shows_a_small_curve_in_a_notebook(model: Model) -> None:
    """With numbers that can be read back: the line falls as friction does."""
    html = model._repr_html_()
    svg = ElementTree.fromstring(html[html.index("<svg") :])
    (line,) = svg.iter("{http://www.w3.org/2000/svg}polyline")
    points = np.array([[float(x) for x in pair.split(",")] for pair in line.get("points", "").split()])
    assert (np.diff(points[:, 0]) > 0).all() and points.shape == (61, 2)
    unit = model.params.composite_modulus
    friction = model.friction_at_load(np.geomspace(1e-4 * unit, 1e2 * unit, 61))
    fall = np.corrcoef(points[:, 1], friction)[0, 1]
    assert fall == pytest.approx(-1.0, abs=1e-4)
    assert svg.get("aria-label", "").startswith("friction coefficient ")
    closed = Model(model.params)
    closed.close()
    assert closed._repr_html_() == "<p>closed Model</p>"


# ---- Arrays of states ----


def test_states_of_an_array_are_those_of_its_loads(model: Model) -> None:
    loads = LOADS[:6].reshape(2, 3)
    states = model.state_at_load(loads)
    assert len(states) == 6 and states.real_area.shape == (2, 3)
    for i, load in enumerate(loads.ravel()):
        one = model.state_at_load(load)
        assert states[i] == one and states.friction_force.ravel()[i] == one.friction_force
        assert states.warning_bits.ravel()[i] == one.warnings
    assert states.warnings == states[0].warnings | states[5].warnings
    assert [state.load for state in states] == loads.ravel().tolist()
    gaps = model.state_at_gap([one.gap for one in states])
    assert gaps.load == pytest.approx(loads.ravel(), rel=1e-9)
    assert "real_area" in dir(states) and "6 of them" in repr(states)
    frame = states.to_pandas()
    assert frame.shape[0] == 6 and frame["load"].tolist() == loads.ravel().tolist()


def test_states_are_refused_with_their_index(model: Model) -> None:
    with pytest.raises(Error, match=r"element \(1, 0\): load = inf"):
        model.state_at_load([[1.0, 2.0], [math.inf, 3.0]])
    with pytest.raises(AttributeError, match="'area': states have load, gap"):
        model.state_at_load([1.0]).area
    assert len(model.state_at_load([])) == 0


# ---- Labels ----


def test_a_series_comes_back_as_a_series(model: Model) -> None:
    loads = pandas.Series([1.0, 10.0, 100.0], index=["a", "b", "c"], name="load")
    for found, name in (
        (model.friction_at_load(loads), "friction_coefficient"),
        (model.friction_force_at_load(loads), "friction_force"),
        (model.tangential_stiffness_at_load(loads), "tangential_stiffness"),
        (model.state_at_load(loads).real_area, "real_area"),
        (model.tangential(loads, 1.0)[0], "tangential_force"),
    ):
        assert isinstance(found, pandas.Series) and found.index.tolist() == ["a", "b", "c"] and found.name == name
    mu, slope = model.friction_at_load(loads, slope=True)
    assert mu["b"] == model.friction_at_load(10.0) and slope["b"] == model.friction_at_load(10.0, slope=True)[1]
    frame = model.friction_at_load(pandas.DataFrame({"x": [1.0, 2.0], "y": [3.0, 4.0]}))
    assert frame["y"][1] == model.friction_at_load(4.0)
    with pytest.raises(Error, match="element 1: load = inf"):
        model.friction_at_load(pandas.Series([1.0, math.inf]))


def test_a_data_array_comes_back_as_a_data_array(model: Model) -> None:
    loads = xarray.DataArray(LOADS[:6].reshape(2, 3), dims=("x", "y"), coords={"y": [1, 2, 3]}, attrs={"long_name": "load"})
    found = model.friction_at_load(loads)
    assert isinstance(found, xarray.DataArray) and found.dims == ("x", "y") and found.attrs == {}
    assert found.name == "friction_coefficient" and found.sel(y=2)[1].item() == model.friction_at_load(loads[1, 1].item())
    assert model.state_at_load(loads).real_area.dims == ("x", "y")
    assert loads.attrs == {"long_name": "load"}


def test_a_curve_is_a_table_of_pandas_too(model: Model) -> None:
    frame = model.curve(LOADS, spread={"w": 0.1}).to_pandas()
    assert frame.columns.tolist() == ["load", "friction_coefficient", "friction_force", "low", "high"]
    assert model.curve(LOADS).to_pandas().columns.tolist() == ["load", "friction_coefficient", "friction_force"]


# ---- Progress ----


@pytest.mark.parametrize("work", ["states", "samples", "pads"])
def test_progress_is_told_to_a_function(params: Params, model: Model, work: str) -> None:
    told: list[float] = []

    def tell(part: float, doing: str) -> None:
        told.append(part)

    if work == "states":
        model.state_at_load(LOADS, progress=tell)
    elif work == "samples":
        uncertainty(params, {"w": 0.1}, LOADS, samples=2, progress=tell)
    else:
        pads(params.replace(asperity_count=200.0), [1.0], 2, progress=tell)
    assert told[0] == 0.0 and told[-1] == 1.0 and told == sorted(told)


def test_progress_is_a_bar_of_tqdm_or_lines(
    model: Model, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    model.state_at_load(LOADS, progress=True)
    assert "asperity: 100%|" in capsys.readouterr().err
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    model.state_at_load(LOADS, progress=True)
    assert capsys.readouterr().err == "asperity:   0% exact states\nasperity: 100% exact states\n"
    model.state_at_load(LOADS)
    assert capsys.readouterr().err == ""


