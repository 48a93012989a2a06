"""The constants of src/spectrum.rs, fitted to boundary elements: the asperities that stand for a surface of m0 and m2.

Half of the surfaces are fitted, the other half tell the errors. The sums over asperities are written out here, without the
library, in units of root mean square height and gradient: then a law depends on its constants alone.

usage: fit_asperities.py

Prints the constants, the constants if one kind of spectrum is left out, and the errors of each on what it was not fitted to.
"""

from __future__ import annotations

import math
from dataclasses import astuple, dataclass, replace
from typing import Any, Callable

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
    radius: float = 1.65
    density: float = 0.0235
    radius_amplitude: float = -0.61
    radius_rate: float = 0.9
    mean_height: float = 1.34
    crowding_power: float = 1.8
    bandwidth_power: float = -0.03


class Law:
    """Area, friction and gap over loads."""

    def __init__(self, constants: Constants, bandwidth: float) -> None:
        radius = constants.radius * (bandwidth / 5) ** constants.bandwidth_power
        # Overlap u = t^2, in deviations of the heights.
        longest = np.sqrt(9 - SEPARATIONS)[:, None]
        t = longest * (PLACES + 1) / 2
        z = SEPARATIONS[:, None] + t * t
        heights = np.exp(-z * z / 2) / math.sqrt(2 * math.pi) * t * WEIGHTS * longest
        g = 1 + constants.radius_amplitude * np.tanh(constants.radius_rate * z)
        overlap = constants.height_std * t * t
        square = radius * g * overlap  # of the contact radius
        self.load = constants.density * 4 / 3 * (heights * np.sqrt(square) * overlap).sum(1)
        self.area = constants.density * math.pi * (heights * square).sum(1)
        self.friction = constants.density * math.pi * (heights * square ** (1 + EXPONENT / 2)).sum(1)
        crowding = 1 - (1 - np.sqrt(np.minimum(self.area, 0.5))) ** constants.crowding_power
        steps = -np.diff(SEPARATIONS) * constants.height_std
        neighbours = np.concatenate([[0], np.cumsum((crowding[1:] + crowding[:-1]) / 2 * steps)])
        self.gap = SEPARATIONS * constants.height_std + constants.mean_height + neighbours

    def at(self, load: float) -> tuple[float, float, float, float]:
        """Area, friction, gap at a greater load less that here, gap."""
        where = np.log(load), np.log(self.load)
        area, friction = (float(np.exp(np.interp(*where, np.log(values)))) for values in (self.area, self.friction))
        gap, greater = (float(np.interp(at, where[1], self.gap)) for at in (where[0], where[0] + math.log(GREATER)))
        return area, friction, gap - greater, gap


def of_row(row: Row) -> tuple[float, float, float, float]:
    """The same by boundary elements."""
    height, gradient = math.sqrt(row.m0), math.sqrt(2 * row.m2)
    friction = row.friction * 43 / (height / gradient / 28 / BURGERS_VECTOR) ** EXPONENT
    return row.area, friction, (row.gap - row.greater_gap) / height, row.gap / height


def errors(constants: Constants, rows: list[Row]) -> Array:
    """Of area, friction and stiffness: logarithms of their ratios; of the gap: a difference."""
    laws: dict[float, Law] = {}
    found = []
    for row in rows:
        bandwidth = round(row.bandwidth, 1)
        law = laws.setdefault(bandwidth, Law(constants, bandwidth))
        ours, theirs = law.at(row.pressure), of_row(row)
        area, friction, compliance = (math.log(one / other) for one, other in zip(ours[:3], theirs[:3]))
        found.append((area, friction, -compliance, ours[3] - theirs[3]))
    return np.array(found)


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
    """Mean and deviation of the errors, by load, for surfaces with four waves a side and more."""
    print(name, " ".join(f"{value:.3g}" for value in astuple(constants)))
    many = [row for row in rows if row.waves >= 4]
    for pressure in boundary_elements.PRESSURES:
        at = [row for row in many if row.pressure == pressure]
        found = errors(constants, at)
        cells = [f"{mean:+.3f} ± {scatter:.3f}" for mean, scatter in zip(found.mean(0), found.std(0))]
        print(f"  x = {pressure:g}: {len(at)} surfaces, area, friction, stiffness, gap {', '.join(cells)}")


def main() -> None:
    rows = boundary_elements.frozen()
    fitted = [row for row in rows if row.fitted]
    rest = [row for row in rows if not row.fitted]
    print("                ", " ".join(vars(Constants())))
    report("as in the library", Constants(), rest)
    report("fitted", fit(fitted), rest)
    report("equal radii", fit(fitted, Constants(1.1, 0.92, 0.05, 0.0), ("radius_amplitude", "radius_rate")), rest)
    for kind in sorted({row.kind for row in rows}):
        report(f"without {kind}", fit([row for row in fitted if row.kind != kind]), [row for row in rows if row.kind == kind])


if __name__ == "__main__":
    main()
