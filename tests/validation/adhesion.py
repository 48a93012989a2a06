"""The law against boundary elements where surfaces stick: the same surfaces, held together by Maugis' attraction.

The surfaces are those of boundary_elements.py. tamaas minimises the energy of the elastic half-space and of an attraction
of w/h up to a gap of h (Maugis' law, which the library has for each asperity) at a given mean gap: that is stable where
surfaces jump under load. The mean gaps are those of the same surfaces without adhesion at two loads.

usage: adhesion.py [FILE.csv]

Computes every surface anew, for some ten minutes, and writes adhesion.csv.
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import tamaas

import boundary_elements
from asperity import Params
from boundary_elements import SLOPE, TOLERANCE, Known, Prediction, Spectrum, falling, known, state, surface

FILE = Path(__file__).with_name("adhesion.csv")

# Bandwidths of about 5, 30 and 80.
SPECTRA = (falling(256, 4, 32, 0.8, 2), falling(512, 4, 128, 0.8, 1), falling(512, 2, 128, 0.8, 1))
# Work of adhesion over E*, root mean square height and root mean square gradient: silicon of 80 GPa with heights of 5 nm and a
# gradient of 0.1 has 1 mJ/m^2 to 2 J/m^2.
WORKS = (0.001, 0.004, 0.012, 0.04)
# Range of adhesion over root mean square height: 0.5 and 1.5 nm.
REACHES = (0.1, 0.3)
# Nominal pressures over E* and gradient without adhesion.
PRESSURES = (2e-3, 1e-2)
# A gap over that of adhesion below which points touch.
TOUCHES = 1e-9


@dataclass(frozen=True)
class Row(Known):
    """A sticky surface at one mean gap. Its pressure is the net one.

    Attributes:
        work: of adhesion, over E*, root mean square height and gradient; 0 for none.
        reach: of adhesion, over root mean square height.
        attraction: load of the points that attract without contact, over the net load.
        dry_pressure: of the same surface at the same mean gap, without adhesion.
    """

    work: float
    reach: float
    attraction: float
    dry_pressure: float

    @property
    def share(self) -> float:
        """Adhesive share of the load in the library: loads of Hertz' contacts of the same radii over the load, less 1; infinite
        if the surfaces are pulled."""
        if self.load <= 0:
            return math.inf
        found = state(self._params, self.load)
        return found.hertz_load / found.load - 1

    @property
    def by_moments(self) -> Prediction:
        """By the library, from m0 and m2."""
        return self.predicted(self._params)

    @property
    def without_adhesion(self) -> Prediction:
        """By the library, from m0 and m2, with adhesion neglected."""
        return self.predicted(self.from_moments())

    @property
    def _params(self) -> Params:
        height = math.sqrt(self.m0)
        adhesion = dict(work_of_adhesion=self.work * height * SLOPE, adhesion_range=self.reach * height)
        return self.from_moments(**adhesion if self.work else {})


def compare(spectrum: Spectrum, seed: int) -> Iterator[Row]:
    """One surface of all works and ranges of adhesion."""
    heights, moments = surface(spectrum, seed)
    height = math.sqrt(moments.m0)
    surface_known = known(spectrum, seed, moments)
    gaps = []
    for ratio, found in zip(PRESSURES, boundary_elements.press(heights, tuple(ratio * SLOPE for ratio in PRESSURES))):
        gaps.append(found[-2])
        yield Row(*surface_known, ratio, *found[:3], 0.0, 0.0, 0.0, ratio)
    for work in WORKS:
        for reach in REACHES:
            for dry, gap in zip(PRESSURES, gaps):
                found = stick(heights, work * height * SLOPE, reach * height, gap)
                yield Row(*surface_known, *found[:4], work, reach, found[4], dry)


def stick(heights: np.ndarray[Any, Any], work: float, reach: float, mean_gap: float) -> tuple[float, float, float, int, float]:
    """At a mean gap: nominal pressure over E* and gradient, real area and friction force over the nominal area, number of
    patches, and the part of the load that the points out of contact pull."""
    n = len(heights)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [float(n)] * 2, [n] * 2)
    model.E, model.nu = 1.0, 0.0
    by_gap = tamaas.PolonskyKeerRey.gap
    solver = tamaas.PolonskyKeerRey(model, heights, TOLERANCE, by_gap, by_gap)
    attraction = tamaas.MaugisAdhesionFunctional(heights)
    attraction.parameters = {"rho": reach, "surface_energy": work}
    solver.addFunctionalTerm(attraction)
    solver.max_iter = 3000
    reached = solver.solve(mean_gap)
    if not reached <= TOLERANCE:
        raise RuntimeError(f"the solver reaches {reached:g} at a mean gap of {mean_gap:g}, not {TOLERANCE:g}")
    traction = np.array(model.traction)
    touches = np.array(model.displacement) - heights <= TOUCHES * reach
    area, friction, count, _ = boundary_elements.patches(np.where(touches, 1.0, 0.0))
    return traction.mean() / SLOPE, area, friction, count, -traction[~touches].sum() / traction.sum()


def frozen(file: Path = FILE) -> list[Row]:
    """The rows of adhesion.csv."""
    return boundary_elements.read(file, Row)


def rows() -> Iterator[Row]:
    """All of adhesion.csv, anew."""
    for spectrum in SPECTRA:
        for seed in range(spectrum.seeds):
            yield from compare(spectrum, seed)


if __name__ == "__main__":
    boundary_elements.write(
        Path(sys.argv[1]) if len(sys.argv) > 1 else FILE, Row, rows(), "tests/validation/adhesion.py"
    )
