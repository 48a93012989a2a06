"""The constants of src/params/spectrum.rs, fitted to boundary elements: the asperities that stand for a surface of m0 and m2.

Half of the surfaces are fitted, the other half tell the errors; all have four waves a side and more, in one band. The sums over
asperities are written out here, without the library, in units of root mean square height and gradient: then a law depends on
its constants alone.

usage: fit_asperities.py

Prints several sets of constants, with their errors on the surfaces that they were not fitted to.
"""

from __future__ import annotations

import math
from dataclasses import astuple, dataclass, fields, replace
from typing import Any

import numpy as np
from scipy.optimize import least_squares

import boundary_elements
from boundary_elements import BURGERS_VECTOR, GREATER, Row

Array = np.ndarray[Any, Any]

# Of Hurtado and Kim's stress between the slip radii, by contact radius.
EXPONENT = -math.log(1290 / 43) / math.log(8e4 / 28)
# Separations over the deviation of the heights, and places of a sum over heights.
SEPARATIONS = np.linspace(8, -4, 481)
PLACES, WEIGHTS = np.polynomial.legendre.leggauss(64)


@dataclass(frozen=True)
class Constants:
    """Of a surface with m0 = 2 m2 = 1; the radius at a bandwidth of 5, of which it has the power `bandwidth_power`."""

    height_std: float = 0.92
    radius: float = 1.63
    density: float = 0.026
    radius_amplitude: float = -0.61
    radius_rate: float = 0.9
    mean_height: float = 1.23
    crowding_power: float = 1.8
    bandwidth_power: float = -0.043


class Law:
    """Area, friction and gap over loads, with the radius of a bandwidth of 5."""

    def __init__(self, constants: Constants) -> None:
        self.constants = constants
        # Overlap u = t^2, in deviations of the heights.
        longest = np.sqrt(9 - SEPARATIONS)[:, None]
        t = longest * (PLACES + 1) / 2
        z = SEPARATIONS[:, None] + t * t
        heights = constants.density * np.exp(-z * z / 2) / math.sqrt(2 * math.pi) * t * WEIGHTS * longest
        overlap = constants.height_std * t * t
        square = constants.radius * (1 + constants.radius_amplitude * np.tanh(constants.radius_rate * z)) * overlap
        self.load = np.log(4 / 3 * (heights * np.sqrt(square) * overlap).sum(1))
        self.area = np.log(math.pi * (heights * square).sum(1))
        self.friction = np.log(math.pi * (heights * square ** (1 + EXPONENT / 2)).sum(1))

    def at(self, loads: Array, bandwidth: float) -> Array:
        """At loads: logarithms of area, friction, and of the gap at a greater load less that here; gap."""
        wider = self.constants.bandwidth_power * math.log(bandwidth / 5)  # of the radius, a logarithm
        load, area, friction = self.load + wider / 2, self.area + wider, self.friction + (1 + EXPONENT / 2) * wider
        crowding = 1 - (1 - np.sqrt(np.minimum(np.exp(area), 0.5))) ** self.constants.crowding_power
        steps = -np.diff(SEPARATIONS) * self.constants.height_std
        neighbours = np.concatenate([[0], np.cumsum((crowding[1:] + crowding[:-1]) / 2 * steps)])
        gaps = SEPARATIONS * self.constants.height_std + self.constants.mean_height + neighbours
        here = np.log(loads)
        gap, greater = np.interp(here, load, gaps), np.interp(here + math.log(GREATER), load, gaps)
        return np.array([np.interp(here, load, area), np.interp(here, load, friction), np.log(gap - greater), gap]).T


def of_row(row: Row) -> tuple[float, ...]:
    """The same by boundary elements."""
    height, gradient = math.sqrt(row.m0), math.sqrt(2 * row.m2)
    friction = row.friction * 43 / (height / gradient / 28 / BURGERS_VECTOR) ** EXPONENT
    gaps = row.gap / height, (row.gap - row.greater_gap) / height
    return math.log(row.area), math.log(friction), math.log(gaps[1]), gaps[0]


def errors(constants: Constants, rows: list[Row]) -> Array:
    """Of area, friction and stiffness: logarithms of their ratios; of the gap: a difference."""
    law = Law(constants)
    found = np.array([law.at(np.array([row.pressure]), row.bandwidth)[0] for row in rows])
    return (found - np.array([of_row(row) for row in rows])) * (1, 1, -1, 1)


def weights(rows: list[Row]) -> Array:
    """Kinds of spectrum and loads count alike; few patches count less."""
    kinds = [(row.kind, row.pressure) for row in rows]
    alike = np.array([1 / math.sqrt(kinds.count(kind)) for kind in kinds])
    return alike / np.sqrt(1 + 150 / np.array([row.patches for row in rows]))


def fit(rows: list[Row], start: Constants = Constants(), held: tuple[str, ...] = ()) -> Constants:
    """Constants by least squares, but for those that are held."""
    names = [name for name in vars(start) if name not in held]
    weight = weights(rows)[:, None]

    def residuals(values: Array) -> Array:
        return (errors(replace(start, **dict(zip(names, values))), rows) * weight).ravel()

    first = [getattr(start, name) for name in names]
    best = least_squares(residuals, first, x_scale=[max(abs(value), 0.05) for value in first], diff_step=1e-3)
    return replace(start, **{name: float(value) for name, value in zip(names, best.x)})


def report(name: str, constants: Constants, rows: list[Row]) -> None:
    """Mean and deviation of the errors, by load."""
    print(f"{name}: {' '.join(f'{value:.3g}' for value in astuple(constants))}")
    for pressure in boundary_elements.PRESSURES:
        at = [row for row in rows if row.pressure == pressure]
        found = errors(constants, at)
        cells = [f"{mean:+.3f} ± {scatter:.3f}" for mean, scatter in zip(found.mean(0), found.std(0))]
        print(f"  x = {pressure:g}: {len(at)} surfaces, area, friction, stiffness, gap {', '.join(cells)}")


def main() -> None:
    rows = [row for row in boundary_elements.frozen() if row.waves >= 4]
    single = [row for row in rows if row.bands == 1]
    fitted, others = [row for row in single if row.fitted], [row for row in single if not row.fitted]
    print(*(field.name for field in fields(Constants)))
    report("as in the library", Constants(), others)
    radius_alone = tuple(name for name in vars(Constants()) if name not in ("radius", "bandwidth_power"))
    report("radius fitted", fit(fitted, held=radius_alone), others)
    report("all fitted", fit(fitted), others)
    report("without the bandwidth", fit(fitted, replace(Constants(), bandwidth_power=0.0), ("bandwidth_power",)), others)
    equal = Constants(1.1, 0.92, 0.05, radius_amplitude=0.0)
    report("equal radii", fit(fitted, equal, ("radius_amplitude", "radius_rate")), others)
    for kind in sorted({row.kind for row in single}):
        without = fit([row for row in fitted if row.kind != kind], held=radius_alone)
        report(f"radius without {kind}", without, [row for row in single if row.kind == kind])
    report("two bands, as in the library", Constants(), [row for row in rows if row.bands == 2])


if __name__ == "__main__":
    main()
