"""The style of every figure, in one place: fonts, colours that the colour-blind can tell, grid, and how a file is written."""

from __future__ import annotations

import os
from contextlib import contextmanager
from functools import partial
from io import BytesIO
from typing import TYPE_CHECKING, Any, Iterator

if TYPE_CHECKING:
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
        svg = os.fspath(file).lower().endswith(".svg")
        figure.savefig(file, metadata={"Date": None, "Creator": None} if svg else None)
    return figure


def _png(figure: Figure) -> bytes:
    picture = BytesIO()
    figure.savefig(picture, format="png", dpi=100)
    return picture.getvalue()
