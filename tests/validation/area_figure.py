"""docs/figures/area.svg: real area over load, by boundary elements, by the library and by theories in closed form.

The markers of one load stand side by side.

usage: area_figure.py [FILE]
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

import boundary_elements
from asperity.tools.style import AMBER, BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, saved, style

FILE = Path(__file__).resolve().parents[2] / "docs" / "figures" / "area.svg"

# Bandwidths of McCool's summits.
MCCOOL = (30.0, 300.0)
# Bandwidths up to these, with their markers.
BANDWIDTHS = ((3, "o", BLUE), (10, "s", GREEN), (30, "^", ORANGE), (100, "D", PURPLE), (math.inf, "v", AMBER))


def draw(file: str) -> None:
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(6, 4.6), layout="constrained")
        figure.suptitle("Real area over load hardly depends on the bandwidth", weight="bold", fontsize=11)
        axes = figure.subplots()
        rows = boundary_elements.frozen()
        least = 1.0
        for place, (greatest, marker, colour) in enumerate(BANDWIDTHS):
            found = [row for row in rows if least <= row.bandwidth < greatest]
            label = f"bandwidth {least:g} to {greatest:g}" if math.isfinite(greatest) else f"bandwidth above {least:g}"
            axes.plot(
                [row.pressure * 1.07 ** (place - 2) for row in found], [row.area / row.pressure for row in found], marker,
                color=colour, mfc="none", markersize=4, label=label,
            )  # fmt: skip
            least = greatest
        x = np.geomspace(3.5e-4, 0.1, 60)
        row = rows[0]
        axes.plot(x, row.areas(row.from_moments(), x) / x, color=BLACK, label="the library, from m₀ and m₂")
        for bandwidth in MCCOOL:
            areas = row.areas(row.from_mccool(bandwidth), x) / x
            axes.plot(x, areas, color=GREY, lw=1)
            axes.annotate(f"McCool, bandwidth {bandwidth:g}", (x[0], areas[0] - 0.12), va="top", fontsize=8, color=GREY)
        axes.plot(x, [math.erf(math.sqrt(2) * load) / load for load in x], "--", color=GREY, label="Persson")
        axes.plot(x, np.full_like(x, math.sqrt(2 * math.pi)), ":", color=GREY, label="Bush, Gibson and Thomas")
        axes.set(xscale="log", ylim=(0, 4.4), xlabel="x = p/(E* h′): pressure over modulus and root mean square gradient [–]")
        axes.set_ylabel("real area over nominal area and x [–]")
        axes.legend(loc="upper center", ncols=2, fontsize=8)
        saved(figure, file)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else str(FILE))
