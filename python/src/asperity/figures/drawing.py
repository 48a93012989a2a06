"""The pictures, as SVG whose bytes depend on nothing but the curves and matplotlib's version.

Axes have fixed places and limits and every curve carries an id, `curve-0` and so on, so that the curves can be read
back from the file and compared. Lines differ in their dashes, not in colour alone.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Iterable

import numpy as np

from .._style import COLOURS, DASHES, label_ends, saved, style
from . import curves, front, validity
from .curves import Array, Curve, CurveFigure

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LOAD = r"normal load $P/(N\,G\,b^2)$ [–]"
_FRICTION = r"friction coefficient $\mu = F/P$ [–]"


def draw_all(directory: Path) -> list[Path]:
    """Draws every figure into a directory; returns the files.

    Raises:
        ImportError: matplotlib is missing.
    """
    with style():
        pictures = {"figure-3": _figure_3()}
        for figure in (*curves.SKEW_FIGURES, *curves.RADIUS_FIGURES):
            pictures[f"figure-{figure.number}"] = _curve_figure(figure)
        pictures |= {"kurtosis": _kurtosis(), "regimes": _regimes(), "yield": _yield(), "microslip": _microslip(), "remembered": _remembered()}
        pictures |= {"sensitivities": _sensitivities(), **validity.pictures(), "measured-points": front.picture()}
        files = [directory / f"{name}.svg" for name in pictures]
        for picture, file in zip(pictures.values(), files):
            saved(picture, file)
        return files


def _curve_figure(figure: CurveFigure) -> Figure:
    alpha, beta, gamma = figure.groups
    picture, (axes,) = _picture((6.4, 4.4), [(0.12, 0.13, 0.84 if figure.logarithmic else 0.7, 0.79)])
    axes.set_title(rf"$\alpha = {alpha:g}$, $\beta = {beta:g}$, $\gamma = {gamma:g}$")
    _draw(axes, figure.curves)
    if figure.logarithmic:
        axes.set_yscale("log")
        axes.legend(handlelength=4)
    else:
        axes.set_ylim(bottom=0)
        label_ends(axes)
    axes.set(xlabel=_LOAD, ylabel=_FRICTION)
    return picture


def _figure_3() -> Figure:
    picture, (above, below) = _picture((6.4, 6.4), [(0.12, 0.5, 0.84, 0.44), (0.12, 0.09, 0.84, 0.34)])
    above.set_title(r"$\alpha = 0.01$, $\gamma = 0.001$")
    _draw(above, curves.FIGURE_3)
    above.set_ylim(bottom=0)
    above.set(ylabel=_FRICTION)
    above.legend(handlelength=4)
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
    below.legend(handlelength=4)
    return picture


def _kurtosis() -> Figure:
    """Friction over the load at skew 0, and over the kurtosis at one load."""
    picture, (left, right) = _picture((9.6, 4.4), [(0.08, 0.13, 0.40, 0.79), (0.57, 0.13, 0.40, 0.79)])
    left.set_title(r"$\alpha = 0.01$, $\beta = 1000$, $\gamma = 0.001$")
    _draw(left, curves.KURTOSIS_CURVES)
    left.set_yscale("log")
    left.set(xlabel=_LOAD, ylabel=_FRICTION)
    left.legend(handlelength=4)

    right.set_title(rf"at $P/(N\,G\,b^2) = {curves.KURTOSIS_LOAD:g}$")
    right.set_xscale("linear")
    right.set_xlim(1, 8)
    right.set_yscale("log")
    for number, skew in enumerate(curves.KURTOSIS_SKEWS):
        kurtosis, values = curves.kurtoses(skew), curves.friction_over_kurtosis(skew)
        _line(right, len(curves.KURTOSIS_CURVES) + number, number, kurtosis, values, rf"Johnson, $S = {skew:g}$")
        weibull = curves.surface(*curves.DEFAULT, skew=skew)
        value = curves.friction(weibull, np.array([curves.KURTOSIS_LOAD]))
        at = curves.model(weibull).summary().kurtosis
        right.plot([at], value, "os^"[number], color=COLOURS[number], label=rf"Weibull, $S = {skew:g}$")
    right.set(xlabel=r"kurtosis $K$ [–]", ylabel=_FRICTION)
    right.legend(handlelength=4)
    return picture


def _regimes() -> Figure:
    """How the contacts divide into the three regimes of slip, for three friction regime parameters."""
    labels = ("$a < a_1$: slips as a whole", "$a_1 < a < a_2$: strength falls", "$a > a_2$: low strength")
    panels = [
        (rf"$\alpha = 0.01$, $\beta = {beta:g}$, $\gamma = {curves.REGIME_GAMMA:g}$", curves.regimes(beta))
        for beta in curves.REGIME_BETAS
    ]
    return _shares(panels, labels)


def _yield() -> Figure:
    """How the contacts divide into elastic, elastic-plastic and flowing ones, for three plasticity indices."""
    alpha, beta, _ = curves.DEFAULT
    panels = [
        (rf"$\psi = {index:g}$, $\alpha = {alpha:g}$, $\beta = {beta:g}$", curves.yields(index))
        for index in curves.YIELD_INDICES
    ]
    return _shares(panels, ("elastic", "elastic-plastic", "flowing"))


def _microslip() -> Figure:
    """Tangential force over the displacement: from rest, and in loops of hysteresis."""
    picture, (left, right) = _picture((9.6, 4.4), [(0.08, 0.13, 0.40, 0.79), (0.57, 0.13, 0.40, 0.79)])
    for axes in (left, right):
        axes.set_xscale("linear")
    displacements = np.linspace(0, 3, 121)
    for number, curve in enumerate(curves.MICROSLIP_SURFACES):
        _line(left, number, number, displacements, curves.microslip(curve.params, displacements), curve.label)
    left.set(xlabel=r"displacement $\delta K_t/F$ [–]", ylabel=r"tangential force $T/F$ [–]", xlim=(0, 3), ylim=(0, 1.05))
    first, *_ = curves.MICROSLIP_SURFACES
    for number, amplitude in enumerate(curves.MICROSLIP_AMPLITUDES):
        displacement, force, _ = curves.loop(first.params, amplitude)
        gid = len(curves.MICROSLIP_SURFACES) + number
        _line(right, gid, number, displacement, force, rf"$\pm {amplitude:g}\,F/K_t$")
    right.set(xlabel=r"displacement $\delta K_t/F$ [–]", xlim=(-2.2, 2.2), ylim=(-1.1, 1.1))
    for axes in (left, right):
        axes.legend(handlelength=4, loc="lower right")
    return picture


def _remembered() -> Figure:
    """A loop of a contact that remembers beside the exact one, and the loop that follows when the load falls."""
    picture, (axes,) = _picture((6.4, 4.4), [(0.12, 0.13, 0.84, 0.79)])
    axes.set_xscale("linear")
    first, *_ = curves.MICROSLIP_SURFACES
    amplitude = 1.5
    displacement, force, _ = curves.loop(first.params, amplitude)
    _line(axes, 0, 0, displacement, force, "summed over the contacts, constant load")
    labels = ("a contact that remembers", "the same, at 0.3 times the load")
    for number, ((displacement, force), label) in enumerate(zip(curves.remembered(first.params, amplitude), labels), 1):
        _line(axes, number, number, displacement, force, label)
    axes.set(xlabel=r"displacement $\delta K_t/F$ [–]", ylabel=r"tangential force $T/F$ [–]", xlim=(-1.7, 1.7), ylim=(-1.1, 1.1))
    axes.legend(handlelength=4, loc="lower right")
    return picture


def _shares(shares: list[tuple[str, Array]], labels: tuple[str, str, str]) -> Figure:
    """Panels of three fractions that add up to 1, over the load."""
    places = [(0.075 + 0.31 * i, 0.15, 0.285, 0.67) for i in range(3)]
    picture, panels = _picture((9.6, 4.2), places)
    for panel, ((title, (below, between, _)), axes) in enumerate(zip(shares, panels)):
        axes.set_title(title)
        axes.set_xlim(curves.REGIME_LOADS[0], curves.REGIME_LOADS[-1])
        axes.set_ylim(0, 1)
        edges = (0 * below, below, below + between, 1 + 0 * below)
        for number, label in enumerate(labels):
            low, high = edges[number], edges[number + 1]
            axes.fill_between(curves.REGIME_LOADS, low, high, color=COLOURS[number], alpha=0.45, lw=0, label=label)
        for number in (0, 1):
            _line(axes, 2 * panel + number, number, curves.REGIME_LOADS, edges[number + 1], "_nolegend_")
        axes.set_xlabel(r"$P/(N\,G\,b^2\,\alpha\beta^2)$ [–]")
        if panel > 0:
            axes.tick_params(labelleft=False)
    panels[0].set_ylabel("fraction of the contacts [–]")
    picture.legend(*panels[0].get_legend_handles_labels(), loc="upper center", ncol=3, frameon=False)
    return picture


def _sensitivities() -> Figure:
    """What friction changes by with each parameter, over the load."""
    picture, (axes,) = _picture((6.4, 4.4), [(0.12, 0.13, 0.78, 0.79)])
    axes.set_title(r"$\alpha = 0.01$, $\beta = 1000$, $\gamma = 0.001$")
    for number, (symbol, values) in enumerate(zip(curves.SENSITIVE.values(), curves.sensitivities())):
        _line(axes, number, number, curves.LOADS, values, symbol)
    axes.set(xlabel=_LOAD, ylabel="sensitivity of the friction [% per %]")
    label_ends(axes)
    return picture


def _picture(
    size: tuple[float, float], places: Iterable[tuple[float, float, float, float]]
) -> tuple[Figure, list[Axes]]:
    """An empty picture [inch] with axes over the load at some places (left, bottom, width, height)."""
    from matplotlib.figure import Figure

    picture = Figure(figsize=size)
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
