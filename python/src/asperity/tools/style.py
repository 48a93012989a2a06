"""The style of every figure, in one place: fonts, colours that the colour-blind can tell, labels, how a file is written."""

from __future__ import annotations

import os
from contextlib import contextmanager
from functools import partial
from io import BytesIO
from typing import TYPE_CHECKING, Any, Iterator

import numpy as np

from . import output

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

# Okabe and Ito's, which also differ in lightness; the yellow and the sky-blue, too light for lines, are left out.
BLACK, BLUE, ORANGE, GREEN, PURPLE, AMBER = "#1b1b1b", "#0072b2", "#d55e00", "#009e73", "#aa4499", "#b37f00"
GREY = "#595959"
COLOURS = (BLUE, ORANGE, GREEN, PURPLE, AMBER, BLACK)
# Lines differ in their dashes too, not in colour alone.
DASHES: tuple[Any, ...] = ("-", (0, (6, 2)), (0, (6, 2, 1, 2)), (0, (1, 1.5)), (0, (3, 1)), (0, (9, 2, 1, 2, 1, 2)))

_SETTINGS: Any = {
    "svg.hashsalt": "asperity",
    "svg.fonttype": "path",
    "path.simplify": False,
    "font.family": "DejaVu Sans",
    "font.size": 10,
    "mathtext.fontset": "dejavusans",
    "axes.titlesize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.alpha": 0.3,
    "grid.linewidth": 0.6,
    "legend.frameon": True,
    "legend.framealpha": 0.9,
    "legend.edgecolor": "none",
    "lines.linewidth": 1.6,
    "savefig.dpi": 150,
}


# Between the lines of labels, and from the end of a curve to its label [part of the axes].
_LABEL_GAP, _LEADER = 0.062, 0.035


def label_ends(axes: Axes) -> None:
    """Writes the label of each line where it ends, at the right of the axes, in its colour: no legend to look up.

    Labels that would lie on each other are moved apart, with a thin line to where they belong. For curves that end apart;
    where they run together a legend tells more.
    """
    from matplotlib.lines import Line2D

    axes.autoscale_view()
    ends = []
    for line in axes.lines:
        last = np.asarray(line.get_xydata(), dtype=np.float64)[-1]
        at = axes.transAxes.inverted().transform(axes.transData.transform(last))
        ends.append((float(at[1]), str(line.get_label()), line.get_color()))
    ends.sort()
    places = [end for end, _, _ in ends]
    for _ in range(100):  # each pair too near is moved apart, until none is
        for i in range(len(places) - 1):
            lack = max(_LABEL_GAP - (places[i + 1] - places[i]), 0.0)
            places[i] -= lack / 2
            places[i + 1] += lack / 2
    for (end, label, colour), place in zip(ends, places):
        leader = Line2D((1.005, 1.0 + _LEADER), (end, place), color=colour, lw=0.6, transform=axes.transAxes, clip_on=False)
        axes.add_artist(leader)
        axes.annotate(
            label, (1.01 + _LEADER, place), xycoords="axes fraction", color=colour, va="center", fontsize=9,
            annotation_clip=False,
        )  # fmt: skip


@contextmanager
def style() -> Iterator[None]:
    """What is made and saved within has the style, whatever the settings of the caller's matplotlib.

    Raises:
        ImportError: matplotlib is missing.
    """
    try:
        import matplotlib
        from cycler import cycler
    except ImportError as error:
        raise ImportError(f"drawing needs matplotlib ({error}): pip install matplotlib") from None
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_SETTINGS | {"axes.prop_cycle": cycler(color=COLOURS)})
        yield


def saved(figure: Figure, file: str | os.PathLike[str] | None) -> Figure:
    """The figure, written too if a file is named: its ending is its format. An SVG has no date and no chance in it.

    A notebook shows it.
    """
    setattr(figure, "_repr_png_", partial(_png, figure))
    if file is not None:
        name = os.fspath(file)
        ending = os.path.splitext(name)[1][1:]
        if not ending:
            ending = "png"
            name = f"{name.rstrip('.')}.png"
        picture = BytesIO()
        svg = ending.lower() == "svg"
        figure.savefig(picture, format=ending, metadata={"Date": None, "Creator": None} if svg else None)
        output.write(name, picture.getvalue())
    return figure


def _png(figure: Figure) -> bytes:
    picture = BytesIO()
    figure.savefig(picture, format="png", dpi=100)
    return picture.getvalue()
