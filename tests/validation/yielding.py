"""The law of summits that yield against boundary elements whose pressure is cut at the hardness, on the same surfaces.

An elastic half-space is pressed by a rough surface, and no point bears more than the hardness H: gap 0 where the pressure is
between 0 and H, no overlap where it is 0, overlap (what has flowed) where it is H (Almqvist, Sahlin, Larsson and Glavatskih,
Tribol. Int. 40 (2007), 574). That is a quadratic function of the pressures with bounds, and a mean that is given; it is
brought to its minimum by projected gradients. tamaas' own solver of the same equations, KatoSaturated, needs a hundred
times as long, and a square of side 1: with another side it stops far from the answer. A test holds the two against each other.

usage: yielding.py [FILE.csv]

Computes every surface anew, for some twenty minutes, and writes yielding.csv.
"""

from __future__ import annotations

import math
import sys
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import scipy.fft

import boundary_elements
from asperity import Params, ValidityWarning
from boundary_elements import CONTACT, SLOPE, Known, Prediction, Spectrum, known, state, surface

FILE = Path(__file__).with_name("yielding.csv")

Field = np.ndarray[Any, Any]

# (E*/H)(sigma/R)^1/2 of McCool's summits, of which H follows.
INDICES = (0.5, 1.0, 2.0, 4.0, 8.0)
# Nominal pressures over E* and root mean square gradient: at an index of 8 a fifth of the nominal area touches at the last one.
PRESSURES = (5e-4, 5e-3, 2e-2)
# The shortest wave has 16 points.
SPECTRA = boundary_elements.RESOLVED[0], boundary_elements.RESOLVED[2]
# Of the fault of the gap.
TOLERANCE = 1e-7
# Some hundred steps are enough; what needs ten times as many does not converge.
MOST_STEPS = 3000


@dataclass(frozen=True)
class Row(Known):
    """One surface of one hardness at one load.

    Attributes:
        index: plasticity index, with sigma and R of McCool's summits.
        hardness: over E*.
        saturated: part of the real area that bears the hardness.
        steps: of the solver.
    """

    index: float
    hardness: float
    saturated: float
    steps: int

    @property
    def area_at_the_hardness(self) -> float:
        """Real area over load/H: 1 where all of it flows."""
        return self.area * self.hardness / (self.pressure * SLOPE)

    @property
    def plasticity_index(self) -> float:
        """As the library says it, from m0 and m2."""
        return state(self.from_moments(**self._yielding), self.load).plasticity_index

    @property
    def by_moments(self) -> Prediction:
        """By the law of summits that yield, from m0 and m2."""
        return self.predicted(self.from_moments(**self._yielding))

    @property
    def by_elastic(self) -> Prediction:
        """By the elastic law, from m0 and m2."""
        return self.predicted(self.from_moments())

    @property
    def _yielding(self) -> dict[str, Any]:
        return dict(hardness=self.hardness, contact_law="elastic-plastic")


def kernel(n: int) -> Field:
    """Of the elastic half-space on a periodic square of side n: displacement over pressure over E* is 2/q."""
    wave = 2 * math.pi / n * np.hypot(np.fft.fftfreq(n, 1 / n)[:, None], np.fft.rfftfreq(n, 1 / n)[None, :])
    return np.divide(2.0, wave, out=np.zeros_like(wave), where=wave > 0)


def project(field: Field, hardness: float, mean: float) -> Field:
    """The nearest pressures between 0 and the hardness with this mean: a shift of the field, cut. By Newton's method
    within brackets."""
    low, high = mean - field.max(), mean - field.min()
    shift = 0.0
    while high - low > 1e-16 * (abs(high) + abs(low)):
        shifted = field + shift
        excess = np.clip(shifted, 0, hardness).mean() - mean
        if abs(excess) <= 1e-13 * mean:
            break
        low, high = (low, shift) if excess > 0 else (shift, high)
        slope = np.count_nonzero((shifted > 0) & (shifted < hardness)) / field.size
        step = shift - excess / slope if slope else low
        shift = step if low < step < high else 0.5 * (low + high)
    return np.clip(field + shift, 0, hardness)


def press(heights: Field, hardness: float, mean: float) -> tuple[Field, int]:
    """Pressures over E* of this mean, none above the hardness, and the steps that it took."""
    modes = kernel(len(heights))

    def displacement(pressure: Field) -> Field:
        return np.asarray(scipy.fft.irfft2(modes * scipy.fft.rfft2(pressure, workers=2), s=pressure.shape, workers=2))

    pressure = np.full_like(heights, mean)
    gap = displacement(pressure) - heights
    length = math.pi / len(heights)
    for steps in range(1, MOST_STEPS):
        change = project(pressure - length * gap, hardness, mean) - pressure
        rise = displacement(change)
        # Down to the minimum along the change, or to its end; the next length is that of Barzilai and Borwein.
        curvature = float((change * rise).sum())
        part = min(1.0, -float((gap * change).sum()) / curvature)
        pressure, gap = pressure + part * change, gap + part * rise
        length = float((change * change).sum()) / curvature
        if steps % 10 == 0 and error(pressure, gap, hardness) <= TOLERANCE:
            return np.clip(pressure, 0, hardness), steps
    raise RuntimeError(f"no answer after {MOST_STEPS} steps at a hardness of {hardness:g} and a pressure of {mean:g}")


def error(pressure: Field, gap: Field, hardness: float) -> float:
    """How far gap and pressure are from what the hardness allows: the mean fault of the gap, weighted by pressure, over the
    scatter of the gap. The gap is known but for a constant, by which its mean is 0 where it has to be 0."""
    edge = 1e-12 * hardness
    bears, flows = pressure > edge, pressure >= hardness - edge
    free = bears & ~flows
    if not free.any():
        return math.inf
    gap = gap - gap[free].mean()
    # Weighted by the mean pressure where there is none.
    weight = np.where(bears, pressure, pressure.mean())
    fault = np.where(free, np.abs(gap), np.maximum(np.where(flows, gap, -gap), 0))
    return float((weight * fault).sum() / (weight.sum() * gap.std()))


def compare(spectrum: Spectrum, seed: int, index: float, ratios: tuple[float, ...] = PRESSURES) -> Iterator[Row]:
    """One surface of one plasticity index at pressures over E* and slope."""
    heights, moments = surface(spectrum, seed)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)  # of the bias that is measured here
        mccool = Params.from_spectral_moments(
            m0=moments.m0, m2=moments.m2, m4=moments.m4, nominal_area=1.0, summits="mccool", **CONTACT
        )
    hardness = math.sqrt(mccool.height_std / mccool.summit_radius) / index
    for ratio in ratios:
        pressure, steps = press(heights, hardness, ratio * SLOPE)
        area, friction, count, _ = boundary_elements.patches(pressure, hardness)
        saturated = np.count_nonzero(pressure >= hardness * (1 - 1e-12)) / np.count_nonzero(pressure)
        yield Row(
            *known(spectrum, seed, moments), ratio, area, friction, count, index, hardness, float(saturated), steps,
        )  # fmt: skip


def frozen(file: Path = FILE) -> list[Row]:
    """The rows of yielding.csv."""
    return boundary_elements.read(file, Row)


def rows() -> Iterator[Row]:
    """All of yielding.csv, anew."""
    for spectrum in SPECTRA:
        for seed in range(spectrum.seeds):
            for index in INDICES:
                yield from compare(spectrum, seed, index)


if __name__ == "__main__":
    boundary_elements.write(
        Path(sys.argv[1]) if len(sys.argv) > 1 else FILE, Row, rows(), "tests/validation/yielding.py"
    )
