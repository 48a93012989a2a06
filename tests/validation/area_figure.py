"""docs/figures/area.svg: real area against load, by boundary elements, by the library and by theories in closed form.

usage: area_figure.py [FILE]
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np

import boundary_elements
from asperity._style import AMBER, BLACK, BLUE, GREEN, GREY, ORANGE, PURPLE, saved, style

FILE = Path(__file__).resolve().parents[2] / "docs" / "figures" / "area.svg"

# Bandwidths up to these, with their markers.
BANDWIDTHS = ((3, "o", BLUE), (10, "s", GREEN), (30, "^", ORANGE), (100, "D", PURPLE), (math.inf, "v", AMBER))


def draw(file: str) -> None:
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(6, 4.6), layout="constrained")
        figure.suptitle("Real area follows load over slope, whatever the bandwidth", weight="bold", fontsize=11)
        axes = figure.subplots()
        rows = boundary_elements.frozen()
        least = 1.0
        for greatest, marker, colour in BANDWIDTHS:
            found = [row for row in rows if least <= row.bandwidth < greatest]
            label = f"bandwidth {least:.2g} to {greatest:g}" if least > 1 else f"bandwidth up to {greatest:g}"
            axes.plot(
                [row.pressure for row in found], [row.area for row in found], marker, color=colour, mfc="none", markersize=5,
                label=label if math.isfinite(greatest) else f"bandwidth above {least:g}",
            )  # fmt: skip
            least = greatest
        x = np.geomspace(4e-4, 0.1, 60)
        params = rows[0].from_moments()
        unit = boundary_elements.SLOPE * rows[0].grid ** 2
        ours = [boundary_elements.state(params, load * unit).real_area / rows[0].grid ** 2 for load in x]
        axes.plot(x, ours, color=BLACK, label="the library, from m₀ and m₂")
        axes.plot(x, [math.erf(math.sqrt(2) * load) for load in x], "--", color=GREY, label="Persson")
        axes.plot(x, math.sqrt(2 * math.pi) * x, ":", color=GREY, label="Bush, Gibson and Thomas")
        axes.set(xscale="log", yscale="log", xlabel="x = p/(E* h′): pressure over modulus and root mean square gradient [–]")
        axes.set_ylabel("real area over nominal area [–]")
        axes.legend(loc="upper left", fontsize=8)
        saved(figure, file)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else str(FILE))
