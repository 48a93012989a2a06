"""How often a band called 95 % has the truth: truths drawn as they are said to be known, and measured with the errors that are said.

usage: coverage.py [FILE.csv [REPEATS]]

Repeats every kind a thousand times, for some ten minutes, and writes coverage.csv.
"""

from __future__ import annotations

import csv
import math
import sys
import warnings
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import asperity
from asperity import Fit, Model, Params, ValidityWarning, fit, uncertainty
from asperity.fits.names import free_names, put_all

FILE = Path(__file__).with_name("coverage.csv")
REPEATS = 1000

Array = np.ndarray[Any, Any]
Random = np.random.Generator
# Whether a band has its truth; None where it is said that there is none.
Bands = Iterator["bool | None"]


@dataclass(frozen=True)
class Kind:
    """A kind of band.

    Attributes:
        call: what made it.
        what: of what it is the band.
        points: measured, or waves along a side of a map.
        errors: of the points: "known", "from the scatter", or "".
    """

    call: str
    what: str
    points: int
    errors: str = ""


@dataclass(frozen=True)
class Row(Kind):
    """How many of the bands had the truth, and of how many it was said that there is none."""

    repeats: int = 0
    covered: int = 0
    refused: int = 0

    @property
    def part(self) -> float:
        return self.covered / (self.repeats - self.refused) if self.repeats > self.refused else math.nan


# ---- Fits ----

PAPER = Params.paper()
# Of what is measured.
SCATTER = 0.05


@cache
def law(params: Params, loads: tuple[float, ...]) -> Array:
    with Model(params) as model:
        return np.asarray(model.friction_at_load(np.array(loads)))


def of_fits(random: Random, repeats: int, points: int, known: bool, free: tuple[str, ...], loss: str = "linear") -> Bands:
    """Friction at a load that was not measured."""
    loads, at = np.geomspace(1.0, 1e4, points), 300.0
    start = PAPER.replace(pressure_coefficient=0.2) if "pressure_coefficient" in free else PAPER
    for _ in range(repeats):
        if "gamma" in free:
            names = free_names(free, start)
            truth = put_all(names, start, [name.start(start) * math.exp(0.2 * random.standard_normal()) for name in names])
            with Model(truth) as model:
                exact, expected = model.friction_at_load(loads), model.friction_at_load(at)
        else:
            strength, kappa = math.exp(0.5 * random.standard_normal()), random.uniform(0.1, 0.4) * (len(free) > 1)
            exact, expected = (strength * law(PAPER, tuple(some)) + kappa for some in (loads.tolist(), [at]))
        sigma = SCATTER * (exact if known else np.full(points, exact.mean()))
        measured = np.maximum(exact + sigma * random.standard_normal(points), 1e-3)
        found: Fit = fit(loads, measured, sigma if known else None, free, params=start, loss=loss)
        friction, error = found.predict([at])
        yield bool(abs(friction[0] - expected) <= found.reach() * error[0])


def of_bands_of_fits(random: Random, repeats: int, points: int) -> Bands:
    """The same by `uncertainty` of the fit."""
    loads, at = np.geomspace(1.0, 1e4, points), (300.0,)
    for _ in range(repeats):
        strength = math.exp(0.5 * random.standard_normal())
        exact, (expected,) = (strength * law(PAPER, some) for some in (tuple(loads.tolist()), at))
        measured = exact + SCATTER * exact.mean() * random.standard_normal(points)
        band = uncertainty(fit(loads, np.maximum(measured, 1e-3), None, ("slip_stress",), params=PAPER), loads=at)
        yield bool(band.low[0] <= expected <= band.high[0])


# ---- Estimates ----

GROUND: dict[str, Any] = dict(nominal_area=1e-4, Ra=0.8e-6, contact_law="elastic-plastic", work_of_adhesion=0.0)
LOADS = (10.0, 1.0, 30.0, 1000.0)


@cache
def surfaces(repeats: int, seed: int) -> tuple[Array, Array]:
    """Friction at the loads of ground surfaces whose slope and strength are drawn, with a slip stress of at most that of the bodies."""
    random = np.random.default_rng(seed)
    deviation = lambda factor: math.log(factor) / 1.959964  # noqa: E731
    # Of the profile, in um: Rq of Ra, and the slope that is assumed of it.
    slope = 0.14 * math.sqrt(0.8 * math.sqrt(math.pi / 2))
    found = []
    for _ in range(repeats):
        strength = min(math.exp(deviation(10) * random.standard_normal()), 20.0)
        given = GROUND | {"Rdq": slope * math.exp(deviation(4) * random.standard_normal())}
        stresses = {"slip_stress_1": strength / 43, "slip_stress_2": strength / 1290}
        found.append(asperity.friction("stainless/stainless", load=np.array(LOADS), **given, **stresses).value)
    return np.array(found), np.abs(0.1 * random.standard_normal(repeats))


def of_estimates(random: Random, repeats: int, loads: tuple[float, ...], pressed: bool = False) -> Bands:
    """Friction at 10 N of surfaces measured at these loads, to 5 %."""
    found, kappa = surfaces(repeats, 1)
    truths = found + pressed * kappa[:, None]
    without = None if loads else asperity.friction("stainless/stainless", load=LOADS[0], process="ground", **GROUND)
    for truth in truths:
        seen = [(load, truth[LOADS.index(load)] * math.exp(0.05 * random.standard_normal())) for load in loads]
        given = GROUND | ({"measured": seen} if pressed else {"measured": seen, "pressure_coefficient": 0.0})
        band = without or asperity.friction("stainless/stainless", load=LOADS[0], process="ground", **given)
        yield bool(band.low <= truth[0] <= band.high)


# ---- Uncertainty ----

SPREAD = {"work_of_adhesion": 0.3, "height_std": 0.1, "summit_radius": 0.2}


def of_spreads(random: Random, repeats: int, measured: bool, samples: int) -> Bands:
    """Friction of surfaces whose parameters are drawn, measured at another load or not."""
    at, there = 1.0, 100.0
    params = PAPER.calibrated(there, law(PAPER, (there,))[0]) if measured else PAPER
    band = uncertainty(params, SPREAD if measured else SPREAD | {"slip_stress": 0.1}, loads=[at], samples=samples)
    names = free_names(tuple(SPREAD), PAPER)
    for _ in range(repeats):
        drawn = [name.start(PAPER) * math.exp(SPREAD[name.given] * random.standard_normal()) for name in names]
        truth = law.__wrapped__(put_all(names, PAPER, drawn), (at, there)) * math.exp((0.5 if measured else 0.1) * random.standard_normal())
        # Friction is in proportion to the strength, and so the band to what was measured.
        seen = truth[1] * math.exp(0.05 * random.standard_normal()) / law(PAPER, (there,))[0] if measured else 1.0
        yield bool(seen * band.low[0] <= truth[0] <= seen * band.high[0])


# ---- Maps ----


def heights(random: Random, size: int, lowest: int) -> tuple[Array, float]:
    """A part of a Gaussian self-affine surface with so many of its longest waves along a side, of root mean square height 1, and
    its slope over the whole."""
    whole = 2 * size
    along, down = np.fft.rfftfreq(whole), np.fft.fftfreq(whole)[:, None]
    wave = size * np.hypot(along, down)
    power = np.where((wave >= lowest) & (wave <= size / 4), np.maximum(wave, 1e-9) ** -3.6, 0.0)
    found = np.fft.irfft2(np.fft.rfft2(random.standard_normal((whole, whole))) * np.sqrt(power), s=(whole, whole))
    twice = power * np.where((along == 0) | (along == 0.5), 1, 2)
    height = twice.sum()
    slope = (twice * (4 - 2 * np.cos(2 * np.pi * along) - 2 * np.cos(2 * np.pi * down))).sum()
    return found[:size, :size] / math.sqrt(height / whole**2), math.sqrt(slope / height)


@cache
def maps(repeats: int, lowest: int) -> list[tuple[Any, float]]:
    random = np.random.default_rng(lowest)
    drawn = (heights(random, 96, lowest) for _ in range(repeats))
    return [(asperity.surface.summits(height - height.mean(), 1.0), slope) for height, slope in drawn]


def of_maps(random: Random, repeats: int, lowest: int, name: str) -> Bands:
    """A number of a map, with the error that the map itself gives it."""
    found = maps(repeats, lowest)
    numbers = [getattr(one, name) for one, _ in found]
    truth = {"rms_height": 1.0, "rms_slope": found[0][1]}.get(name, float(np.mean([one.value for one in numbers])))
    for one in numbers:
        yield None if math.isnan(one.error) else bool(abs(one.value - truth) <= 1.96 * one.error)


def kinds() -> Iterator[tuple[Kind, Callable[[Random, int], Bands]]]:
    """All kinds, and what draws their bands."""

    def of(function: Callable[..., Bands], *given: Any) -> Callable[[Random, int], Bands]:
        return lambda random, repeats: function(random, repeats, *given)

    frees = {("slip_stress",): (2, 3, 6, 20), ("slip_stress", "pressure_coefficient"): (3, 6, 20), ("gamma", "sigma"): (6, 20)}
    for free, counts in frees.items():
        for known in (True, False):
            for points in counts:
                errors = "known" if known else "from the scatter"
                yield Kind(f"fit of {' and '.join(free)}", "friction at another load", points, errors), of(of_fits, points, known, free)
    for points in (6, 20):
        kind = Kind("fit of slip_stress, loss huber", "friction at another load", points, "from the scatter")
        yield kind, of(of_fits, points, False, ("slip_stress",), "huber")
    for points in (2, 3, 6, 20):
        kind = Kind("uncertainty of a fit of slip_stress", "friction at another load", points, "from the scatter")
        yield kind, of(of_bands_of_fits, points)
    for loads in ((), (1000.0,), (1.0, 30.0, 1000.0)):
        kind = Kind("friction, ground stainless steel", "friction at another load", len(loads), "known" if loads else "")
        yield kind, of(of_estimates, loads)
    kind = Kind("the same, strength grows with pressure", "friction at another load", 3, "known")
    yield kind, of(of_estimates, (1.0, 30.0, 1000.0), True)
    for measured in (False, True):
        for samples in (0, 2000):
            by = "samples" if samples else "linear"
            kind = Kind(f"uncertainty of spreads, {by}", "friction at another load", int(measured), "known" if measured else "")
            yield kind, of(of_spreads, measured, samples)
    for name, what in (("rms_height", "Sq"), ("rms_slope", "Sdq"), ("height_std", "sigma of summits"), ("density", "their density"),
                       ("radius", "their radius")):  # fmt: skip
        for lowest in (1, 2, 4, 8):
            yield Kind("summits of a map", what, lowest), of(of_maps, lowest, name)


def row(kind: Kind, draw: Callable[[Random, int], Bands], repeats: int) -> Row:
    random = np.random.default_rng(20261127)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ValidityWarning)
        warnings.simplefilter("ignore", UserWarning)
        found = list(draw(random, repeats))
    return Row(kind.call, kind.what, kind.points, kind.errors, len(found), found.count(True), found.count(None))


def frozen() -> list[Row]:
    with FILE.open(encoding="utf-8", newline="") as file:
        return [Row(one[0], one[1], int(one[2]), one[3], *map(int, one[4:])) for one in list(csv.reader(file))[1:]]


def main(file: Path, repeats: int) -> None:
    with file.open("w", encoding="utf-8", newline="") as out:
        rows = csv.writer(out, lineterminator="\n")
        rows.writerow(["call", "what", "points", "errors", "repeats", "covered", "refused"])
        for kind, draw in kinds():
            found = row(kind, draw, repeats)
            rows.writerow([found.call, found.what, found.points, found.errors, found.repeats, found.covered, found.refused])
            out.flush()
            print(f"{found}: {100 * found.part:.1f} %", file=sys.stderr)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else FILE, int(sys.argv[2]) if sys.argv[2:] else REPEATS)
