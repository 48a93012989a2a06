"""The picture of the front page: measured friction, as points, on the curves that the law predicts with nothing fitted.

The measurements are those of `measured`. What a source does not give is a band, where the law depends on it, or a bar
through the point. Rough gold is not in it, whose contact radius is not known.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from .._style import BLUE, GREY, ORANGE
from ..materials import MATERIALS, PAIRS
from .measured import MEASUREMENTS, ROUGH_LOADS, Band, Measurement, rough_model, rough_models, single_contact, tip_states

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.lines import Line2D

Array = npt.NDArray[np.float64]

_LOADS = np.geomspace(1e-6, 1e-3, 31)
_SIZES = np.geomspace(3.3, 1e6, 61)
_ROWS = {row.name: row for row in MEASUREMENTS}


@dataclass(frozen=True)
class Point:
    """A measurement: along the axis what it was measured at, upwards what was measured, each lowest and highest."""

    at: Band
    value: Band
    label: str
    read: bool


def rough_band() -> tuple[Array, Array, Array]:
    """Coefficients of polysilicon at `_LOADS`: lowest and highest over what is open, and amid that."""
    silicon = MATERIALS["Si"]
    ends = np.array([model.friction_at_load(_LOADS) for model in rough_models(silicon, silicon)])
    amid = rough_model(silicon, silicon, 5e-9, PAIRS["Si/Si"].work_of_adhesion)
    return ends.min(axis=0), ends.max(axis=0), np.asarray(amid.friction_at_load(_LOADS))


def strength(sizes: Array) -> Array:
    """Stress over G* of single contacts, by radius over Burgers vector: the same for all bodies."""
    silicon = MATERIALS["Si"]
    length = silicon.need("burgers_vector")
    stresses = [single_contact(silicon, silicon, length, float(size) * length) for size in sizes]
    return np.array([stress / modulus for stress, modulus in stresses])


def rough_points() -> list[Point]:
    """Measured coefficients, at loads that the source does not give."""
    rows = (_ROWS["polysilicon, static"], _ROWS["Si₃N₄ on polysilicon, static"])
    return [
        Point(ROUGH_LOADS, _measured(row), f"{row.name.partition(',')[0]}: {_value(row)}, {row.label}", row.read) for row in rows
    ]


def strength_points() -> list[Point]:
    """Measured stresses over G*, at radii over Burgers vectors that the source does not give."""
    gold, mica, silicon, nitride = (MATERIALS[name] for name in ("Au", "mica", "Si", "Si3N4"))
    short, long = gold.need("burgers_vector"), mica.need("burgers_vector")
    pillar, film = _ROWS["gold pillar on mica, AFM"], _ROWS["mica on mica in air, SFA"]
    tip = _ROWS["Si₃N₄ tip on silicon, AFM"]
    radii = [state.mean_contact_radius / silicon.need("burgers_vector") for state in tip_states()]
    sizes = min(radii), max(radii)
    least, most = tip.ratio()
    law = strength(np.array(sizes))
    return [
        Point((5e-9 / long, 50e-9 / short), _over(pillar, single_contact(gold, mica, short, 5e-9)[1]),
              f"gold pillar on mica\n{pillar.label}", pillar.read),
        Point((20e-6 / long, 100e-6 / long), _over(film, single_contact(mica, mica, long, 20e-6)[1]),
              f"mica on mica in air\n({film.label})", film.read),
        Point(sizes, (float(law.min()) / most, float(law.max()) / least), f"Si₃N₄ tip on silicon\nin air ({tip.label})", tip.read),
    ]  # fmt: skip


def _measured(row: Measurement) -> Band:
    assert row.measured is not None
    return row.measured


def _value(row: Measurement) -> str:
    low, high = _measured(row)
    return f"{(low + high) / 2:.1f} ± {(high - low) / 2:.1f}"


def _over(row: Measurement, modulus: float) -> Band:
    """A measured stress [MPa] over a modulus [Pa]."""
    low, high = _measured(row)
    return 1e6 * low / modulus, 1e6 * high / modulus


# ---- The picture ----


def picture() -> Figure:
    """Rough surfaces at the left, single contacts at the right."""
    from matplotlib.figure import Figure

    drawn = Figure(figsize=(9.6, 4.5))
    rough, single = (drawn.add_axes(place) for place in ((0.075, 0.13, 0.40, 0.78), (0.585, 0.13, 0.40, 0.78)))
    for number, curve in enumerate(_rough(rough) + _single(single)):
        curve.set_gid(f"curve-{number}")
    return drawn


def _rough(axes: Axes) -> list[Line2D]:
    axes.set_title("Rough polysilicon: friction falls with load", loc="left", weight="bold")
    axes.set(xscale="log", yscale="log", xlim=(_LOADS[0], _LOADS[-1]), ylim=(0.1, 1000))
    axes.set(xlabel="normal load [N], on 0.1 mm × 0.1 mm", ylabel="friction coefficient [–]")
    low, high, amid = rough_band()
    axes.fill_between(_LOADS, low, high, color=BLUE, alpha=0.15, lw=0)
    lines = [axes.plot(_LOADS, curve, color=BLUE, lw=width)[0] for curve, width in ((amid, 2.2), (low, 0.6), (high, 0.6))]
    axes.annotate("predicted for σ = 5 nm, w = 63 mJ/m²", (9e-4, 0.39), fontsize=9, color=BLUE, ha="right", va="center")
    axes.annotate(
        "and for what is not given:\nσ = 2 to 10 nm, w = 30 to 144 mJ/m²", (9e-4, 300), fontsize=9, color=BLUE, ha="right",
        va="center",
    )  # fmt: skip
    above, below = rough_points()
    _point(axes, above, (1.1e-6, 8.5))
    _point(axes, below, (1.1e-6, 1.4))
    return lines


def _single(axes: Axes) -> list[Line2D]:
    axes.set_title("One contact: the larger, the weaker", loc="left", weight="bold")
    axes.set(xscale="log", yscale="log", xlim=(2, _SIZES[-1]), ylim=(1e-5, 0.1))
    axes.set(xlabel="contact radius / Burgers vector [–]", ylabel="friction stress / shear modulus G* [–]")
    (line,) = axes.plot(_SIZES, strength(_SIZES), color=BLUE, lw=2.2)
    text = "predicted for clean crystals\n(Hurtado and Kim 1999)"
    axes.annotate(text, (8e5, 2e-2), fontsize=9, color=BLUE, ha="right", va="center")
    for point, place in zip(strength_points(), ((4, 4.3e-3), (1.5e3, 2e-5), (3.3, 3e-4))):
        _point(axes, point, place)
    return [line]


def _point(axes: Axes, point: Point, place: tuple[float, float]) -> None:
    """Amid its bars, of what is not given and of what was measured; grey where it is only quoted."""
    colour = ORANGE if point.read else GREY
    x, y = (float(np.sqrt(low * high)) for low, high in (point.at, point.value))
    axes.plot(point.at, (y, y), color=colour, lw=1.4, solid_capstyle="butt")
    axes.plot((x, x), point.value, color=colour, lw=1.4, solid_capstyle="butt")
    axes.plot(x, y, "o", color=colour, ms=8, markeredgecolor="white")
    axes.annotate(point.label, place, va="center", fontsize=9, color=colour, weight="bold")
