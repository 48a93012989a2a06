"""Surfaces that are not Gaussian, and yield or adhere, against boundary elements: heights of a Gaussian surface that are bent.

Pressures are cut at the hardness as in yielding.py, and surfaces are held together as in adhesion.py. The library knows heights and
slopes at scores and the lay of the map, as `surface.analyse` makes them.

usage: shaped.py [FILE.csv]

Computes every surface anew, for some ten minutes, and writes shaped.csv.
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, Callable, Iterator

import numpy as np

import adhesion
import boundary_elements
import yielding
from asperity import Params
from asperity.maps.at_scores import sloped
from boundary_elements import BURGERS_VECTOR, SLOPE, falling, state

FILE = Path(__file__).with_name("shaped.csv")

Field = np.ndarray[Any, Any]

SPECTRUM = falling(512, 6, 24, 0.8, 2)
# Heights by normal score: skews of about -1.2 and 1, and plateaus above the score 0.5.
BENDS: tuple[tuple[str, Callable[[Field], Field]], ...] = (
    ("valleys", lambda g: -np.exp(-0.42 * g)),
    ("plateaus", lambda g: g - 0.85 * np.logaddexp(0, 4 * (g - 0.5)) / 4),
    ("hills", lambda g: np.exp(0.36 * g)),
)
# Nominal pressures over E* and root mean square gradient.
PRESSURES = (2e-3, 1e-2)
# Hardnesses over E* and that gradient; elastic contacts of a Gaussian surface have a mean pressure of 0.5.
HARDNESSES = (0.3, 0.1)
# Works of adhesion over E*, root mean square height and gradient, and their range over root mean square height.
WORKS, REACH = (0.001, 0.004), 0.3


@dataclass(frozen=True)
class Row:
    """A bent surface at one pressure; hardness and work of adhesion are 0 where there are none.

    Attributes:
        bend: place in `BENDS`.
        pressure: nominal, over E* and root mean square gradient.
        area, friction: over the nominal area, and over it and G*.
    """

    bend: int
    seed: int
    hardness: float
    work: float
    pressure: float
    area: float
    friction: float

    @property
    def law(self) -> str:
        """In words."""
        if self.work:
            return f"adhesion, w = {self.work:g} E\\* Sq Sdq"
        return f"yield, H = {self.hardness:g} E\\* Sdq" if self.hardness else "elastic"

    @property
    def found(self) -> boundary_elements.Prediction:
        """The library over the boundary elements."""
        heights = bent(self.bend, self.seed)
        at = state(params(self.bend, self.seed, self.hardness, self.work), self.pressure * SLOPE * heights.size)
        return boundary_elements.Prediction(at.real_area / heights.size / self.area, at.friction_force / heights.size / self.friction)


@lru_cache(maxsize=None)
def bent(bend: int, seed: int) -> Field:
    """Heights whose root mean square gradient is `SLOPE`."""
    level, _ = boundary_elements.surface(SPECTRUM, seed)
    level = BENDS[bend][1](level / level.std())
    level -= level.mean()
    waves = np.fft.fft2(level)
    q = 2 * math.pi * np.hypot(np.fft.fftfreq(len(level))[:, None], np.fft.fftfreq(len(level))[None, :])
    return np.asarray(level * SLOPE / (np.linalg.norm(q * waves) / level.size))


@lru_cache(maxsize=None)
def params(bend: int, seed: int, hardness: float, work: float) -> Params:
    """Of the table of a map."""
    heights = bent(bend, seed)
    table = "".join(f"{key} = {value}\n" for key, value in sloped(heights, 1.0, 1.0).at_scores.keys.items())
    law = f"hardness = {hardness * SLOPE}\ncontact_law = 'elastic-plastic'\n" if hardness else ""
    height = heights.std()
    return Params.from_text(
        f"composite_modulus = 1\neffective_shear_modulus = 1\nburgers_vector = {BURGERS_VECTOR}\nnominal_area = {heights.size}\n"
        f"slip_stress_1 = {1 / 43}\nslip_stress_2 = {1 / 1290}\nwork_of_adhesion = {work * height * SLOPE}\n"
        f"adhesion_range = {REACH * height}\n{law}[roughness]\n{table}"
    )


def compare(bend: int, seed: int) -> Iterator[Row]:
    """One surface by all laws."""
    heights = bent(bend, seed)
    height = heights.std()
    elastic = list(boundary_elements.press(heights, tuple(ratio * SLOPE for ratio in PRESSURES)))
    for ratio, found in zip(PRESSURES, elastic):
        yield Row(bend, seed, 0.0, 0.0, ratio, *found[:2])
        for hardness in HARDNESSES:
            pressure, _ = yielding.press(heights, hardness * SLOPE, ratio * SLOPE)
            yield Row(bend, seed, hardness, 0.0, ratio, *boundary_elements.patches(pressure, hardness * SLOPE)[:2])
        for work in WORKS:
            net, area, friction, _, _ = adhesion.stick(heights, work * height * SLOPE, REACH * height, found[-2])
            yield Row(bend, seed, 0.0, work, float(net), area, friction)


def frozen(file: Path = FILE) -> list[Row]:
    """The rows of shaped.csv."""
    return boundary_elements.read(file, Row)


def table() -> str:
    """Area and friction over boundary elements, by law and bend."""
    lines = [f"| Law | {' | '.join(f'{bend}: area | friction' for bend, _ in BENDS)} |", "|---" * (1 + 2 * len(BENDS)) + "|"]
    for law in dict.fromkeys(row.law for row in frozen()):
        cells = []
        for bend in range(len(BENDS)):
            found = [row.found for row in frozen() if (row.bend, row.law) == (bend, law)]
            for values in ([one.area for one in found], [one.friction for one in found]):
                cells.append(f"{min(values):.2f} to {max(values):.2f}")
        lines.append(f"| {law} | {' | '.join(cells)} |")
    return "\n".join(lines)


def rows() -> Iterator[Row]:
    """All of shaped.csv, anew."""
    for bend in range(len(BENDS)):
        for seed in range(SPECTRUM.seeds):
            yield from compare(bend, seed)


if __name__ == "__main__":
    boundary_elements.write(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE, Row, rows(), "tests/validation/shaped.py")
