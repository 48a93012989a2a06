"""The model calibrated at one load against measurements that it did not see: two pictures.

One is that of the front page, a measurement over its loads; the other has the residuals of all comparisons of `calibrated`,
those that fail too.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.tools.style import BLUE, GREY, ORANGE
from .calibrated import COMPARISONS, FILM_LOADS, film_predicted, film_measured

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_LOADS = np.geomspace(FILM_LOADS[0], FILM_LOADS[-1], 41)


def pictures() -> dict[str, Figure]:
    """By the name of the file, with large letters: they are read on phones."""
    from matplotlib.figure import Figure

    film, residuals = Figure(figsize=(5.0, 3.6)), Figure(figsize=(5.0, 3.6))
    _film(film.add_axes((0.15, 0.15, 0.81, 0.74)))
    _residuals(residuals.add_axes((0.05, 0.15, 0.91, 0.74)))
    return {"measured-points": film, "comparisons": residuals}


def _film(axes: Axes) -> None:
    axes.set_title("One measurement at 1 N predicts friction up to 50 N", loc="left", x=-0.14, weight="bold", fontsize=11.5)
    axes.set(xscale="log", yscale="log", xlim=(0.9, 56), ylim=(0.0125, 0.085))
    axes.set_xlabel("normal load [N]", fontsize=11)
    axes.set_ylabel("friction coefficient [–]", fontsize=11)
    axes.set_xticks([1, 2, 5, 10, 20, 50], ["1", "2", "5", "10", "20", "50"], fontsize=11)
    axes.set_yticks([0.02, 0.04, 0.08], ["0.02", "0.04", "0.08"], fontsize=11)
    axes.minorticks_off()
    amid, low, high = film_measured(_LOADS)
    axes.fill_between(_LOADS, low, high, color=ORANGE, alpha=0.3, lw=0)
    (measured,) = axes.plot(_LOADS, amid, color=ORANGE, lw=2, dashes=(5, 2))
    (predicted,) = axes.plot(_LOADS, film_predicted(_LOADS), color=BLUE, lw=2.2)
    axes.plot(_LOADS[0], amid[0], "o", color=BLUE, ms=10, markeredgecolor="white", clip_on=False, zorder=5)
    for number, line in enumerate((measured, predicted)):
        line.set_gid(f"curve-{number}")
    axes.annotate("calibrated here", (1.15, 0.067), fontsize=11, color=BLUE, weight="bold")
    axes.annotate("predicted", (2.4, 0.0245), fontsize=11, color=BLUE, weight="bold")
    axes.annotate("measured: ball on MoS₂ film,\nSinger and others 1990", (5.2, 0.056), fontsize=11, color=ORANGE, weight="bold",
                  va="center")  # fmt: skip


def _residuals(axes: Axes) -> None:
    """Predicted over measured, at the reading of each comparison that the model misses most."""
    axes.set_title("Calibrated once, the model meets two of six", loc="left", weight="bold", fontsize=11)
    axes.set(xscale="log", xlim=(0.4, 2.5), ylim=(len(COMPARISONS) - 0.45, -0.75))
    axes.set_xlabel("predicted / measured [–]", fontsize=11)
    axes.set_xticks([0.5, 0.7, 1, 1.4, 2], ["0.5", "0.7", "1", "1.4", "2"], fontsize=11)
    axes.minorticks_off()
    axes.set_yticks([])
    for side in ("left", "right", "top"):
        axes.spines[side].set_visible(False)
    axes.grid(axis="y", visible=False)
    axes.axvline(1, color=GREY, lw=1.2)
    for number, one in enumerate(COMPARISONS):
        reading, residual = one.worst()
        low, high = (1 + end for end in residual)
        colour = BLUE if one.agrees else ORANGE
        # A single value is drawn as wide as 4 %, to be seen.
        amid = float(np.sqrt(low * high))
        ends = (low, high) if high > 1.04 * low else (amid / 1.02, amid * 1.02)
        (bar,) = axes.plot(ends, (number + 0.18,) * 2, lw=9, color=colour, solid_capstyle="butt")
        bar.set_gid(f"curve-{number}")
        axes.annotate(f"{one.name}, {reading.at}", (0.41, number - 0.28), fontsize=9.5, color=colour, va="center",
                      bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0})  # fmt: skip


