"""The drawing of friction with its band over loads, of a curve and of an estimate."""

from __future__ import annotations

import os
import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .sparkline import is_wide
from .style import BLACK, saved, style

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

# Characters that fit a line of the legend.
_WIDTH = 76


def drawn(
    file: str | os.PathLike[str] | None, axes: Axes | None, unit: str, load: Array, value: Array, low: Array | None, high: Array | None,
    label: str, marked: tuple[Array, Array] | None = None, measured: Array | None = None,
) -> Figure:  # fmt: skip
    """Draws the coefficient over loads > 0 with the band, and writes the figure if a file is named.

    The axis of the coefficient is logarithmic if the band spans more than a factor of 10.

    Args:
        file: its ending is its format.
        axes: of a figure of the caller; otherwise one is made.
        unit: of the loads.
        load: where the line is drawn, ascending.
        value: the coefficients there.
        low: lower end of the band; None if there is none.
        high: upper end.
        label: of the band.
        marked: loads and coefficients to mark with points.
        measured: measured points, rows of load and coefficient.

    Raises:
        ImportError: matplotlib is missing.
    """
    with style():
        from matplotlib.figure import Figure

        if axes is None:
            axes = Figure(figsize=(6.4, 4.4), layout="constrained").add_subplot()
        (line,) = axes.semilogx(load, value)
        if low is not None and high is not None:
            wrapped = "\n".join(textwrap.fill(one, _WIDTH, subsequent_indent="    ") for one in label.splitlines())
            axes.fill_between(load, low, high, color=line.get_color(), alpha=0.2, lw=0, label=wrapped)
        if marked is not None:
            axes.plot(*marked, "o", ms=5, color=line.get_color())
        if measured is not None and len(measured):
            axes.plot(*measured.T, "D", ms=6, color=BLACK, label="measured")
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize="small", loc="lower left", bbox_to_anchor=(0, 1))
        axes.set(xlabel=f"{'nominal pressure $p$' if unit == 'Pa' else 'normal load $P$'} [{unit}]", ylabel="friction coefficient $F/P$ [–]")
        if is_wide(low, high):
            axes.set_yscale("log")
        else:
            axes.set_ylim(bottom=0)
        figure: Any = axes.figure
        return saved(figure, file)
