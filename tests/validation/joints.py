"""Normal stiffness of surfaces that yield, of first loading and of unloading, by boundary elements whose pressure is cut at the hardness.

The solver is that of yielding.py. After the load the heights that flowed are where it left them; on these the half-space is elastic.

usage: joints.py [FILE.csv]

Computes every surface anew, for some twenty minutes, and writes joints.csv.
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Iterator

import numpy as np
import scipy.fft

import boundary_elements
import yielding
from asperity import Params
from boundary_elements import GREATER, SLOPE, Known, Spectrum, known, state, surface
from yielding import SPECTRA, Field

FILE = Path(__file__).with_name("joints.csv")

# E* (sigma/R)^1/2/H of the asperities that follow from m0 and m2.
INDICES = (1.5, 3.0, 6.0)
# Nominal pressures over E* and root mean square gradient.
PRESSURES = (5e-3, 2e-2)
SEEDS = 2
# Of the load: at which the area is compared after unloading.
PART = 0.4
_ELASTIC = 1e6


@dataclass(frozen=True)
class Row(Known):
    """One surface of one hardness at one load.

    Attributes:
        index: plasticity index, as the library says it from m0 and m2.
        hardness: over E*.
        stiffness: -dp/du over E* up to GREATER times the pressure, per the unit of the grid.
        unloading: the same down to the pressure over GREATER.
        left_area: real area over that under the load, at PART of it.
        left_gap: by how much the mean planes move apart until then.
    """

    index: float
    hardness: float
    stiffness: float
    unloading: float
    left_area: float
    left_gap: float

    @property
    def params(self) -> Params:
        """From m0 and m2, of asperities that yield."""
        return self.from_moments(hardness=self.hardness, contact_law="elastic-plastic")

    @property
    def of_loading(self) -> float:
        """The library's normal stiffness over that of boundary elements."""
        here, more = (state(self.params, part * self.load).gap for part in (1.0, GREATER))
        return (GREATER - 1) * self.pressure * SLOPE / (here - more) / self.stiffness

    @property
    def of_unloading(self) -> float:
        """The same when the load begins to fall."""
        return state(self.params, self.load).unloading_stiffness / self.grid**2 / self.unloading


    def at_part_of_load(self) -> tuple[float, float]:
        """At PART of the load, after all of it: real area over that under the load, and the gap that the planes have gained over theirs."""
        first = boundary_elements.model(self.params)
        top, left = first.state_at_load(self.load), first.unloaded(self.load).state_at_load(PART * self.load)
        return left.real_area / top.real_area, (left.gap - top.gap) / self.left_gap


def gap_of(heights: Field, pressure: Field, hardness: float) -> Field:
    """Between the surfaces: 0 on average where they touch and do not flow."""
    waves = scipy.fft.rfft2(pressure, workers=2)
    gap = scipy.fft.irfft2(yielding.kernel(len(heights)) * waves, s=pressure.shape, workers=2) - heights
    free = (pressure > 1e-12 * hardness) & (pressure < hardness * (1 - 1e-12))
    return np.asarray(gap - gap[free].mean())


def compare(spectrum: Spectrum, seed: int, index: float, ratios: tuple[float, ...] = PRESSURES) -> Iterator[Row]:
    """One surface of one plasticity index."""
    heights, moments = surface(spectrum, seed)
    probe = Params.from_spectral_moments(m0=moments.m0, m2=moments.m2, nominal_area=1.0, **boundary_elements.CONTACT)
    hardness = math.sqrt(probe.height_std / probe.summit_radius) / index
    for ratio in ratios:
        mean = ratio * SLOPE
        pressure, _ = yielding.press(heights, hardness, mean)
        area, friction, count, _ = boundary_elements.patches(pressure, hardness)
        gap = gap_of(heights, pressure, hardness)
        more = gap_of(heights, yielding.press(heights, hardness, GREATER * mean)[0], hardness)
        flat = heights + np.where(pressure >= hardness * (1 - 1e-12), gap, 0.0)
        less, left = (yielding.press(flat, _ELASTIC, part * mean)[0] for part in (1 / GREATER, PART))
        gaps = [gap_of(flat, found, _ELASTIC).mean() - gap_of(flat, pressure, _ELASTIC).mean() for found in (less, left)]
        yield Row(
            *known(spectrum, seed, moments), ratio, area, friction, count, index, hardness,
            float((GREATER - 1) * mean / (gap.mean() - more.mean())), float((1 - 1 / GREATER) * mean / gaps[0]),
            float(np.count_nonzero(left > 0) / np.count_nonzero(pressure > 0)), float(gaps[1]),
        )  # fmt: skip


def frozen(file: Path = FILE) -> list[Row]:
    """The rows of joints.csv."""
    return boundary_elements.read(file, Row)


def rows() -> Iterator[Row]:
    """All of joints.csv, anew."""
    for spectrum in SPECTRA:
        for seed in range(SEEDS):
            for index in INDICES:
                yield from compare(spectrum, seed, index)


if __name__ == "__main__":
    boundary_elements.write(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE, Row, rows(), "tests/validation/joints.py")
