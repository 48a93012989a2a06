"""How far the summits of a map are off theory, against how finely the map is sampled.

usage: sampling_bias.py [FIGURE [SEEDS]]
  FIGURE   file to draw in, its ending is its format; "-" or nothing for none
  SEEDS    surfaces of each kind, 2 to 1000 (8)

Isotropic Gaussian surfaces with waves down to a length L, of two spectra: narrow (equal power at all waves longer than
L, alpha = 2) and broad (self-affine, Hurst exponent 0.8, waves up to 16 L). Each is sampled at several intervals dx,
`asperity.surface` finds the summits, and the table tells what it finds over what Nayak's theory says, with the
standard error of the mean over the surfaces. Exit status: 0, 1 if a file or a package stands in the way, 2 for a wrong
command line.
"""

from __future__ import annotations

import sys

import numpy as np
import numpy.typing as npt
from random_surfaces import GaussianSurface, Nayak

from asperity import surface
from asperity.tools.style import BLACK, saved, style

Array = npt.NDArray[np.float64]

QUANTITIES = ("density", "height_mean", "height_std", "radius")
SPECTRA = {"narrow": (0.0, 0.0), "broad": (1 / 16, 3.6)}
POINTS_PER_WAVE = (2, 2.5, 3, 4, 6, 8, 12, 16, 24, 32)


def compare(kind: str, points_per_wave: float, seeds: int) -> tuple[Array, Array]:
    """Means over surfaces of found over expected, one for each of QUANTITIES, and their standard errors."""
    lowest, fall = SPECTRA[kind]
    random = GaussianSurface(512 if points_per_wave < 8 else 1024, points_per_wave, lowest, fall)
    theory = Nayak(*random.moments())
    ratios = np.empty((seeds, len(QUANTITIES)))
    for seed in range(seeds):
        summits = surface.summits(random.map(seed), 1.0, 1.0, detrend=0)
        ratios[seed] = [float(getattr(summits, name)) / getattr(theory, name) for name in QUANTITIES]
    return ratios.mean(axis=0), ratios.std(axis=0, ddof=1) / np.sqrt(seeds)


def draw(file: str, results: dict[str, list[tuple[Array, Array]]]) -> None:
    with style():
        from matplotlib.figure import Figure

        labels = ("density $\\eta$", "mean height", "standard deviation $\\sigma$", "radius $R$")
        figure = Figure(figsize=(5, 7), layout="constrained")
        figure.suptitle("Coarse maps overestimate the radius of summits", weight="bold", fontsize=11)
        panels = figure.subplots(2, 1, sharex=True)
        intervals = 1 / np.array(POINTS_PER_WAVE)
        for axes, (kind, found) in zip(panels, results.items()):
            for index, (label, marker) in enumerate(zip(labels, "os^D")):
                means, errors = ([part[which][index] for part in found] for which in (0, 1))
                axes.errorbar(intervals, means, errors, marker=marker, markersize=4, linewidth=1, label=label)
            axes.axhline(1, color=BLACK, linewidth=0.8)
            axes.set_xscale("log")
            axes.set_xticks(intervals, [f"1/{points}" if points != 2.5 else "" for points in POINTS_PER_WAVE], fontsize=8)
            axes.minorticks_off()
            axes.set(title=f"{kind} spectrum", ylabel="map / Nayak's theory [–]", ylim=(0.5, 1.9))
        panels[1].set_xlabel("sampling interval over shortest wavelength, $dx/L$ [–]")
        panels[0].legend(loc="upper left")
        saved(figure, file)


def read_arguments(arguments: list[str]) -> tuple[str, int]:
    given = dict(zip(("figure", "seeds"), arguments))
    seeds = int(given.get("seeds", 8))
    if len(arguments) > 2 or not 2 <= seeds <= 1000:
        raise ValueError("2 to 1000 surfaces are needed")
    return given.get("figure", "-"), seeds


def main(arguments: list[str]) -> int:
    try:
        figure, seeds = read_arguments(arguments)
    except ValueError as error:
        print(f"sampling_bias: {error}\nusage: sampling_bias.py [FIGURE [SEEDS]]", file=sys.stderr)
        return 2
    try:
        results: dict[str, list[tuple[Array, Array]]] = {}
        for kind in SPECTRA:
            print(f"# {kind}: L/dx, found/expected: {', '.join(QUANTITIES)}")
            results[kind] = []
            for points in POINTS_PER_WAVE:
                means, errors = compare(kind, points, seeds)
                results[kind].append((means, errors))
                print(f"{points:4g}  " + "  ".join(f"{a:.4f} +- {b:.4f}" for a, b in zip(means, errors)), flush=True)
        if figure != "-":
            draw(figure, results)
    except (ImportError, OSError, ValueError) as error:
        print(f"sampling_bias: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
