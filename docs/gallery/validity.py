"""The pictures of where the model is valid: the map of real contacts and the measurements next to their predictions.

Each can be read alone and without colour: labels stand at what they name.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from asperity.tools.style import BLUE, GREY, ORANGE
from . import contacts, measured

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def pictures() -> dict[str, Figure]:
    """By the name of the file."""
    return {"contacts": _contacts(), "measurements": _measurements()}


# ---- The map ----

# Where the name of a contact stands: the end of its track that it belongs to, and the shift from there [pt].
_LABELS = {
    "AFM tip": (-1, (10, 0), "left"),
    "fine powder": (0, (0, 7), "left"),
    "MEMS polysilicon": (-1, (8, -12), "left"),
    "wafer on chuck": (-1, (8, -4), "left"),
    "DLC on steel": (0, (-8, -4), "right"),
    "ground steel": (-1, (6, 9), "center"),
    "rubber": (0, (-10, 12), "right"),
}


def _contacts() -> Figure:
    picture, axes = _empty((5.0, 5.4), (0.145, 0.15, 0.835, 0.78))
    axes.set_title("Ground steel yields, MEMS and wafers do not", loc="left", x=-0.15, weight="bold", fontsize=11)
    picture.text(0.03, 0.02, "from the lightest load to the heaviest (dot)", fontsize=9, color=GREY)
    axes.set(xscale="log", yscale="log", xlim=(3e-4, 4), ylim=(1, 1e6))
    axes.set_xlabel("mean pressure of the contacts / hardness [–]")
    axes.set_ylabel("mean contact radius / Burgers vector [–]")
    axes.axvspan(contacts.YIELD, 4, color=ORANGE, alpha=0.13, lw=0)
    axes.axhspan(1, contacts.CONTINUUM, color=GREY, alpha=0.18, lw=0)
    _region(axes, 1.26, 4e5, "yielding:\nelastic-plastic\nasperities", ORANGE)
    _region(axes, 8e-3, 4e5, "elastic asperities", BLUE)
    _region(axes, 1.2e-2, 1.7, "few atoms: no continuum", GREY)
    for radius, text in ((28, "$a_1$: larger contacts are weaker"), (8e4, "$a_2$: lowest strength")):
        axes.plot((3e-4, 4), (radius, radius), color=GREY, lw=0.8, dashes=(4, 3))
        axes.annotate(text, (3.4e-4, radius), (0, 3), textcoords="offset points", color=GREY, fontsize=9)
    for number, contact in enumerate(contacts.CONTACTS):
        _track(axes, number, contact)
    return picture


def _track(axes: Axes, number: int, contact: contacts.Contact) -> None:
    """A contact over its loads, with a dot at the heaviest; dashed if it is outside the model."""
    pressure, radius, share = contact.track()
    held = share.max() < contacts.CROWDED
    colour = BLUE if held and (pressure < contacts.YIELD).any() else ORANGE
    (line,) = axes.plot(pressure, radius, color=colour, lw=3, dashes=(1, 0) if held else (2, 1))
    line.set_gid(f"curve-{number}")
    axes.plot(pressure[-1:], radius[-1:], "o", color=colour, ms=6)
    end, shift, side = _LABELS[contact.name]
    text = contact.name if held else f"{contact.name}: outside the model,\nviscoelastic, crowded"
    place = (float(pressure[end]), float(radius[end]))
    axes.annotate(text, place, shift, textcoords="offset points", ha=side, fontsize=10, color=colour, weight="bold")


def _region(axes: Axes, x: float, y: float, text: str, colour: str) -> None:
    axes.annotate(text, (x, y), ha="center", va="center", fontsize=9.5, color=colour, style="italic")


# ---- The measurements ----


def _measurements() -> Figure:
    rows = measured.MEASUREMENTS
    picture, axes = _empty((5.0, 0.72 * len(rows) + 1.1), (0.04, 0.12, 0.92, 0.81))
    axes.set_title("Default strength: an order of magnitude", loc="left", weight="bold", fontsize=11)
    axes.set(xscale="log", xlim=(0.02, 1000), ylim=(len(rows) - 0.4, -0.9))
    axes.set_xlabel("predicted / measured [–]; bands: inputs not given")
    axes.set_yticks([])
    axes.grid(axis="y", visible=False)
    axes.plot((1, 1), (-0.5, len(rows) - 0.4), color=GREY, lw=1.2)
    axes.annotate("predicted = measured", (1, -0.62), ha="center", va="center", fontsize=9, color=GREY)
    for number, row in enumerate(rows):
        low, high = row.ratio()
        # A single value is drawn as wide as 8 %, to be seen.
        ends = np.array([low, high] if high > 1.08 * low else [low / 1.04, low * 1.04])
        colour = BLUE if low <= 1.05 and high >= 0.95 else ORANGE
        alpha = 1.0 if row.read else 0.45
        (line,) = axes.plot(ends, (number + 0.27,) * 2, lw=9, color=colour, solid_capstyle="butt", alpha=alpha)
        line.set_gid(f"curve-{number}")
        text = _ratio(low, high)
        axes.annotate(text, (ends[1], number + 0.27), (6, 0), textcoords="offset points", va="center", fontsize=9)
        axes.annotate(
            _caption(row), (0, number - 0.18), (2, 0), xycoords=("axes fraction", "data"), textcoords="offset points",
            va="center", fontsize=9, bbox={"facecolor": "white", "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip
    axes.annotate("pale: quoted, papers not read", (0.0, 0.01), xycoords="axes fraction", va="bottom", fontsize=9, color=GREY)
    return picture


def _caption(row: measured.Measurement) -> str:
    quantity, _, unit = row.quantity.partition(" [")
    value = "ratio quoted"
    if row.measured is not None:
        low, high = row.measured
        value = f"{low:g}" if low == high else f"{(low + high) / 2:.2g} ± {(high - low) / 2:g}"
    return f"{row.name}: {quantity} {value} {unit.rstrip(']')}".rstrip()


def _ratio(low: float, high: float) -> str:
    first, last = f"{low:.2g}", f"{high:.2g}" if high < 100 else f"{high:.0f}"
    return first if first == last else f"{first} to {last}"


def _empty(size: tuple[float, float], place: tuple[float, float, float, float]) -> tuple[Figure, Axes]:
    """An empty picture [inch] with axes without a frame at a place (left, bottom, width, height)."""
    from matplotlib.figure import Figure

    picture = Figure(figsize=size)
    axes = picture.add_axes(place)
    for side in ("top", "right", "left", "bottom"):
        axes.spines[side].set_visible(False)
    axes.tick_params(which="both", length=0)
    axes.grid(which="minor", visible=False)
    return picture, axes
