"""The picture of a joint's damping: loops of hysteresis above, the work of a cycle over the pull below, each with Iwan's model."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.tools.style import BLUE, GREY, ORANGE
from . import joint
from .curves import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

LOOPS = (0.5, 0.9)  # pulls of the loops, over that of gross slip
SHOWN = (0.05, 1.0)  # of the powers


def picture() -> Figure:
    """As tall as wide, with large letters: it is read on phones."""
    from matplotlib.figure import Figure

    drawn = Figure(figsize=(5.0, 6.25))
    loops, powers = (drawn.add_axes(place) for place in ((0.15, 0.57, 0.81, 0.34), (0.15, 0.085, 0.81, 0.35)))
    exponent = joint.slope(joint.first_loading(), *joint.FITTED)
    drawn.text(0.02, 0.965, f"This bolted joint's loss per cycle grows as force$^{{{exponent:.1f}}}$", weight="bold", fontsize=11)
    _loops(loops)
    _powers(powers)
    return drawn


def _loops(axes: Axes) -> None:
    axes.set_xlabel("displacement of the ends [µm]", fontsize=9.5)
    axes.set_ylabel("pull [kN]", fontsize=9.5)
    axes.tick_params(labelsize=9.5)
    loading, model = joint.first_loading(), joint.iwan()
    for number, part in enumerate(LOOPS):
        pull = np.linspace(0.0, part * loading.slip_pull, 60)
        known = np.concatenate([[0.0], loading.pull]), np.concatenate([[0.0], loading.displacement])
        for curve, displacement in enumerate((np.interp(pull, *known), model.displacement(pull))):
            _line(axes, 2 * number + curve, *joint.loop(1e6 * displacement, 1e-3 * pull), curve == 1)
    axes.annotate("this library,\n40 cells", (0.04, 0.78), xycoords="axes fraction", color=BLUE, fontsize=9.5, weight="bold")
    axes.annotate("Iwan's model,\n4 parameters", (0.62, 0.12), xycoords="axes fraction", color=ORANGE, fontsize=9.5,
                  weight="bold")  # fmt: skip


def _powers(axes: Axes) -> None:
    loading, model = joint.first_loading(), joint.iwan()
    low, high = (1e-3 * part * loading.slip_pull for part in SHOWN)
    axes.set(xscale="log", yscale="log", xlim=(low, 1.1 * high), ylim=(1e-3, 40))
    axes.set_xlabel("amplitude of the pull [kN]", fontsize=9.5)
    axes.set_ylabel("work of a cycle [mJ]", fontsize=9.5)
    axes.set_xticks([0.2, 0.5, 1, 2, 4], ["0.2", "0.5", "1", "2", "4"], fontsize=9.5)
    axes.set_yticks([1e-3, 1e-2, 1e-1, 1, 10], ["0.001", "0.01", "0.1", "1", "10"], fontsize=9.5)
    axes.minorticks_off()
    shown = loading.pull >= 0.9e3 * low
    pull = loading.pull[shown]
    number = 2 * len(LOOPS)
    _line(axes, number, 1e-3 * pull, 1e3 * loading.work[shown], False)
    _line(axes, number + 1, 1e-3 * pull, 1e3 * model.work(pull), True)
    for exponent, at, where in ((2, 26.0, (0.24, 0.33)), (3, 11.0, (0.42, 0.006))):
        (line,) = axes.plot(1e-3 * pull, at * (pull / loading.slip_pull) ** exponent, color=GREY, lw=1.0)
        line.set_gid(f"curve-{number + exponent}")
        axes.annotate(f"slope {exponent}", where, color=GREY, fontsize=9.5)


def _line(axes: Axes, number: int, x: Array, y: Array, dashed: bool) -> None:
    style = (0, (5, 2)) if dashed else "-"
    (line,) = axes.plot(x, y, color=ORANGE if dashed else BLUE, lw=2.0, linestyle=style)
    line.set_gid(f"curve-{number}")
