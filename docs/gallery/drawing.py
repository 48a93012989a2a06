"""The pictures, as SVG whose bytes depend on nothing but the curves and matplotlib's version.

Each says one thing in its title, and is so narrow that its letters are readable on a telephone. Axes have fixed places and
limits and every curve carries an id, `curve-0` and so on, so that the curves can be read back from the file and compared.
Lines differ in their dashes, not in colour alone.
"""

from __future__ import annotations

import csv
import re
from io import StringIO
from itertools import zip_longest
from pathlib import Path
from typing import TYPE_CHECKING, Iterable

import numpy as np

from asperity.tools.style import COLOURS, DASHES, label_ends, saved, style
from . import curves, damping, front, validity
from .curves import Array, Curve, CurveFigure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LOAD = r"normal load $P/(N\,G\,b^2)$ [–]"
_FRICTION = r"friction coefficient $\mu = F/P$ [–]"
# Of every picture [inch].
_WIDTH = 5.0


def draw_all(directory: Path) -> list[Path]:
    """Draws every figure into a directory, those of the gallery with their curves as CSV; returns the files.

    Raises:
        ImportError: matplotlib is missing.
    """
    with style():
        pictures = {"figure-3": _figure_3()}
        for figure in (*curves.SKEW_FIGURES, *curves.RADIUS_FIGURES):
            pictures[f"figure-{figure.number}"] = _curve_figure(figure)
        pictures |= {"kurtosis": _kurtosis(), "regimes": _regimes(), "yield": _yield(), "microslip": _microslip()}
        for name, picture in pictures.items():
            (directory / f"{name}.csv").write_text(_numbers(picture), encoding="utf-8", newline="\n")
        pictures |= {**validity.pictures(), **front.pictures()}
        pictures |= {"joint-damping": damping.picture(), "remembered": _remembered()}
        files = [directory / f"{name}.svg" for name in pictures]
        for picture, file in zip(pictures.values(), files):
            saved(picture, file)
        return files


def _numbers(picture: Figure) -> str:
    """The curves of a picture as CSV: a column each, after that of their abscissa if it is not the one before."""
    columns: list[list[str]] = []
    before = np.empty(0)
    for axes in picture.axes:
        for line in axes.get_lines():
            if (line.get_gid() or "").startswith("curve-"):
                x, y = np.asarray(line.get_xdata()), np.asarray(line.get_ydata())
                if not np.array_equal(x, before):
                    columns.append([_plain(axes.get_xlabel() or picture.axes[-1].get_xlabel()), *map("{:.6g}".format, x)])
                    before = x
                columns.append([_plain(f"{axes.get_ylabel()}: {str(line.get_label()).lstrip('_')}"), *map("{:.6g}".format, y)])
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows(zip_longest(*columns, fillvalue=""))
    return text.getvalue()


def _plain(label: str) -> str:
    """Words without the marks of formulas."""
    return " ".join(re.sub(r"[$\\{}]|\[–\]", "", label.replace(r"\,", " ").replace(r"\pm ", "+-")).split()).replace(" :", ":")


def _curve_figure(figure: CurveFigure) -> Figure:
    alpha, beta, gamma = figure.groups
    picture, (axes,) = _picture(4.2, [(0.14, 0.13, 0.82 if figure.logarithmic else 0.68, 0.73)])
    _entitle(axes, figure.title, rf"$\alpha = {alpha:g}$, $\beta = {beta:g}$, $\gamma = {gamma:g}$")
    _draw(axes, figure.curves)
    if figure.logarithmic:
        axes.set_yscale("log")
        axes.legend(handlelength=3.5, fontsize=9)
    else:
        axes.set_ylim(bottom=0)
        label_ends(axes)
    axes.set(xlabel=_LOAD, ylabel=_FRICTION)
    return picture


def _figure_3() -> Figure:
    picture, (above, below) = _picture(6.2, [(0.14, 0.5, 0.82, 0.4), (0.14, 0.085, 0.82, 0.34)])
    _entitle(above, "Attraction out of contact raises friction", r"$\alpha = 0.01$, $\gamma = 0.001$")
    _draw(above, curves.FIGURE_3)
    above.set_ylim(bottom=0)
    above.set(ylabel=_FRICTION)
    above.legend(handlelength=3.5, fontsize=9)
    for number, (beta, paper) in enumerate(((500, 3.8), (1000, 2.1))):
        style = 2 * number  # that of the curve above it
        effect = curves.attraction_effect(beta)
        _line(below, len(curves.FIGURE_3) + number, style, curves.LOADS, effect, rf"$\beta = {beta}$")
        below.axhline(paper, linewidth=0.8, linestyle=DASHES[style], color=COLOURS[style])
        below.annotate(f"the paper's {paper} %", (curves.HEAVIEST / 1.3, paper), ha="right", va="bottom",
                       color=COLOURS[style], fontsize=9)  # fmt: skip
    below.set_yscale("log")
    below.set_ylim(0.05, 50)
    below.set(xlabel=_LOAD, ylabel=r"increase of $\mu$ by attraction [%]")
    below.legend(handlelength=3.5, fontsize=9)
    return picture


def _kurtosis() -> Figure:
    """Friction over the load at skew 0, and over the kurtosis at one load."""
    picture, (above, below) = _picture(8.2, [(0.14, 0.57, 0.82, 0.36), (0.14, 0.065, 0.82, 0.36)])
    _entitle(above, "Light loads depend on the kurtosis most", r"$\alpha = 0.01$, $\beta = 1000$, $\gamma = 0.001$")
    _draw(above, curves.KURTOSIS_CURVES)
    above.set_yscale("log")
    above.set(xlabel=_LOAD, ylabel=_FRICTION)
    above.legend(handlelength=3.5, fontsize=9)

    _entitle(below, "More kurtosis lowers friction", rf"at $P/(N\,G\,b^2) = {curves.KURTOSIS_LOAD:g}$")
    below.set_xscale("linear")
    below.set_xlim(1, 8)
    below.set_yscale("log")
    for number, skew in enumerate(curves.KURTOSIS_SKEWS):
        kurtosis, values = curves.kurtoses(skew), curves.friction_over_kurtosis(skew)
        _line(below, len(curves.KURTOSIS_CURVES) + number, number, kurtosis, values, rf"Johnson, $S = {skew:g}$")
        weibull = curves.surface(*curves.DEFAULT, skew=skew)
        value = curves.friction(weibull, np.array([curves.KURTOSIS_LOAD]))
        at = curves.model(weibull).summary().kurtosis
        below.plot([at], value, "os^"[number], color=COLOURS[number], label=rf"Weibull, $S = {skew:g}$")
    below.set(xlabel=r"kurtosis $K$ [–]", ylabel=_FRICTION)
    below.legend(handlelength=3.5, fontsize=9)
    return picture


def _regimes() -> Figure:
    """How the contacts divide into the three regimes of slip, for three friction regime parameters."""
    labels = ("$a < a_1$: strongest", "between: weaker", "$a > a_2$: weakest")
    panels = [
        (rf"$\beta = {beta:g}$, $\alpha = 0.01$, $\gamma = {curves.REGIME_GAMMA:g}$", curves.regimes(beta))
        for beta in curves.REGIME_BETAS
    ]
    return _shares("β decides in which regime contacts slip", panels, labels)


def _yield() -> Figure:
    """How the contacts divide into elastic, elastic-plastic and flowing ones, for three plasticity indices."""
    alpha, beta, _ = curves.DEFAULT
    panels = [
        (rf"$\psi = {index:g}$, $\alpha = {alpha:g}$, $\beta = {beta:g}$", curves.yields(index))
        for index in curves.YIELD_INDICES
    ]
    return _shares("A high plasticity index makes contacts yield", panels, ("elastic", "elastic-plastic", "flowing"))


def _microslip() -> Figure:
    """Tangential force over the displacement: from rest, and in loops of hysteresis."""
    picture, (above, below) = _picture(8.0, [(0.16, 0.58, 0.8, 0.375), (0.16, 0.065, 0.8, 0.4)])
    above.set_title("Contacts slip one by one before gross slip", loc="left", weight="bold", fontsize=11)
    below.set_title("Small cycles dissipate little", loc="left", weight="bold", fontsize=11)
    for axes in (above, below):
        axes.set_xscale("linear")
    displacements = np.linspace(0, 3, 121)
    for number, curve in enumerate(curves.MICROSLIP_SURFACES):
        _line(above, number, number, displacements, curves.microslip(curve.params, displacements), curve.label)
    above.set(xlabel=r"displacement $\delta K_t/F$ [–]", ylabel=r"tangential force $T/F$ [–]", xlim=(0, 3), ylim=(0, 1.05))
    first, *_ = curves.MICROSLIP_SURFACES
    for number, amplitude in enumerate(curves.MICROSLIP_AMPLITUDES):
        displacement, force, _ = curves.loop(first.params, amplitude)
        gid = len(curves.MICROSLIP_SURFACES) + number
        _line(below, gid, number, displacement, force, rf"$\pm {amplitude:g}\,F/K_t$")
    below.set(xlabel=r"displacement $\delta K_t/F$ [–]", ylabel=r"tangential force $T/F$ [–]")
    below.set(xlim=(-2.2, 2.2), ylim=(-1.1, 1.1))
    for axes in (above, below):
        axes.legend(handlelength=3.5, fontsize=9, loc="lower right")
    return picture


def _remembered() -> Figure:
    """A loop of a contact that remembers next to the exact one, and the loop that follows when the load falls."""
    picture, (axes,) = _picture(4.6, [(0.16, 0.12, 0.8, 0.75)])
    _entitle(axes, "Remembered slip follows the exact loop", "and the next loop when the load falls")
    axes.set_xscale("linear")
    first, *_ = curves.MICROSLIP_SURFACES
    amplitude = 1.5
    displacement, force, _ = curves.loop(first.params, amplitude)
    _line(axes, 0, 0, displacement, force, "summed over the contacts, constant load")
    labels = ("a contact that remembers", "the same, at 0.3 times the load")
    for number, ((displacement, force), label) in enumerate(zip(curves.remembered(first.params, amplitude), labels), 1):
        _line(axes, number, number, displacement, force, label)
    axes.set(
        xlabel=r"displacement $\delta K_t/F$ [–]", ylabel=r"tangential force $T/F$ [–]", xlim=(-1.7, 1.7), ylim=(-1.1, 1.6)
    )
    axes.legend(handlelength=4, loc="upper left", fontsize=9)
    return picture


def _shares(title: str, shares: list[tuple[str, Array]], labels: tuple[str, str, str]) -> Figure:
    """Panels of three fractions that add up to 1, over the load."""
    picture, panels = _picture(7.6, [(0.12, 0.625 - 0.28 * i, 0.84, 0.225) for i in range(3)])
    picture.text(0.12, 0.975, title, weight="bold", fontsize=11, va="center")
    for panel, ((condition, (below, between, _)), axes) in enumerate(zip(shares, panels)):
        axes.set_title(condition, loc="left")
        axes.set_xlim(curves.REGIME_LOADS[0], curves.REGIME_LOADS[-1])
        axes.set_ylim(0, 1)
        edges = (0 * below, below, below + between, 1 + 0 * below)
        for number, label in enumerate(labels):
            low, high = edges[number], edges[number + 1]
            axes.fill_between(curves.REGIME_LOADS, low, high, color=COLOURS[number], alpha=0.45, lw=0, label=label)
        for number in (0, 1):
            # Not in the legend, by its first letter.
            name = f"_{condition}, {' + '.join(labels[: number + 1])}"
            _line(axes, 2 * panel + number, number, curves.REGIME_LOADS, edges[number + 1], name)
        axes.set_ylabel("fraction [–]")
        if panel < 2:
            axes.tick_params(labelbottom=False)
    panels[2].set_xlabel(r"normal load $P/(N\,G\,b^2\,\alpha\beta^2)$ [–]")
    picture.legend(
        *panels[0].get_legend_handles_labels(), loc="center left", bbox_to_anchor=(0.1, 0.93), ncol=3, frameon=False,
        fontsize=8.5, columnspacing=1.0, handlelength=1.5,
    )  # fmt: skip
    return picture


def _entitle(axes: Axes, title: str, condition: str) -> None:
    """What the axes show, and below it for which surfaces."""
    axes.set_title(title, loc="left", weight="bold", fontsize=11, pad=22)
    axes.annotate(condition, (0, 1), (0, 7), xycoords="axes fraction", textcoords="offset points", fontsize=9.5)


def _picture(height: float, places: Iterable[tuple[float, float, float, float]]) -> tuple[Figure, list[Axes]]:
    """An empty picture of a height [inch] with axes over the load at some places (left, bottom, width, height)."""
    from matplotlib.figure import Figure

    picture = Figure(figsize=(_WIDTH, height))
    all_axes = [picture.add_axes(place) for place in places]
    for axes in all_axes:
        axes.set_xscale("log")
        axes.set_xlim(curves.LIGHTEST, curves.HEAVIEST)
    return picture, all_axes


def _draw(axes: Axes, lines: Iterable[Curve]) -> None:
    for number, curve in enumerate(lines):
        _line(axes, number, number, curves.LOADS, curves.friction(curve.params), curve.label)


def _line(axes: Axes, number: int, style: int, x: Array, y: Array, label: str) -> None:
    """Draws the curve of this number in the picture."""
    (line,) = axes.plot(x, y, linestyle=DASHES[style], color=COLOURS[style], label=label)
    line.set_gid(f"curve-{number}")
