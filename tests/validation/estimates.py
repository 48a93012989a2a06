"""Bands of estimates against published measurements: one point of a study predicts the others, and so do simpler rules.

usage: estimates.py        prints the tables of scores
"""

from __future__ import annotations

import csv
import math
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure

from asperity.estimate import estimate
from asperity.tools.style import BLUE, GREY, ORANGE, saved, style

REACH = 1.959964


# Of the sets, in the picture.
NAMES = {
    "A": "silicon wafers", "B": "steel on worn steel", "C1": "quartz grains", "C2": "sand grains", "D100s": "sapphire, soft DLC",
    "D100d": "diamond, soft DLC", "D260s": "sapphire, hard DLC", "D260d": "diamond, hard DLC", "F": "steel, MoS₂ film",
    **{f"I{i}": f"steel ball, sample {i}" for i in range(1, 5)}, "J": "steel, light grease",
}  # fmt: skip


class Point(NamedTuple):
    load: float
    coefficient: float
    error: float


class Study(NamedTuple):
    name: str
    kind: str
    surface: str
    points: list[Point]


class Prediction(NamedTuple):
    """ln F/P: its middle, and its standard deviations below and above."""

    middle: float
    below: float
    above: float

    def score(self, point: Point) -> float:
        """The logarithm of the density at what was measured."""
        off = math.log(point.coefficient) - self.middle
        below, above = (math.hypot(self.below, point.error), math.hypot(self.above, point.error))
        deviation = below if off < 0 else above
        return -0.5 * (off / deviation) ** 2 - math.log(0.5 * (below + above) * math.sqrt(2 * math.pi))

    def covers(self, point: Point) -> bool:
        off = math.log(point.coefficient) - self.middle
        return abs(off) <= REACH * math.hypot(self.below if off < 0 else self.above, point.error)


def studies() -> list[Study]:
    found: dict[str, Study] = {}
    with open(Path(__file__).with_name("friction_loads.csv"), encoding="utf-8") as file:
        for row in csv.DictReader(file):
            study = found.setdefault(row["set"], Study(row["set"], row["kind"], row["surface"].replace(" | ", "\n"), []))
            study.points.append(Point(float(row["load"]), float(row["coefficient"]), float(row["error"])))
    return list(found.values())


def banded(study: Study, seen: Point, asked: Point, more: str = "") -> Prediction:
    """The estimate of the library."""
    measured = f"measured = [{seen.load}, {seen.coefficient}, {seen.error}]\n"
    found = estimate(f"{more}{measured}{study.surface}", asked.load)
    low, middle, high = (math.log(x) for x in (found.low, found.value, found.high))
    return Prediction(middle, (middle - low) / REACH, (high - middle) / REACH)


def power(exponent: float, deviation: float) -> Callable[[Study, Point, Point], Prediction]:
    """A coefficient that goes with a power of the load, to this standard deviation of its logarithm."""

    def predicted(_: Study, seen: Point, asked: Point) -> Prediction:
        middle = math.log(seen.coefficient) + exponent * math.log(asked.load / seen.load)
        return Prediction(middle, deviation, deviation)

    return predicted


RULES: dict[str, Callable[[Study, Point, Point], Prediction]] = {
    "this library": banded,
    "the law alone ± 5 %": lambda study, seen, asked: banded(study, seen, asked, "model_error = 0\nsize_effect = 1\npressure_coefficient = 0\n")._replace(
        below=math.log(1.05), above=math.log(1.05)
    ),
    "constant ± 5 %": power(0, math.log(1.05)),
    "constant ± 50 %": power(0, math.log(1.5)),
    "P^(−1/3) ± 50 %": power(-1 / 3, math.log(1.5)),
    "P^(−1/6) ± 50 %": power(-1 / 6, math.log(1.5)),
}


# What else might have been taken of what the priors choose; the first is what is taken.
CHOICES: dict[str, dict[str, str]] = {
    "how far real interfaces leave the law": {name: f"model_error = {name}\n" for name in ("1", "0.5", "0.7", "1.4", "2")},
    "size effect": {"open": "", **{name: f"size_effect = {name}\n" for name in ("0", "0.25", "0.5", "1")}},
    "pressure coefficient": {"open": "", "0": "pressure_coefficient = 0\n"},
}


def of_study(study: Study, predict: Callable[[Study, Point, Point], Prediction]) -> tuple[float, float]:
    """Mean score and coverage over all ordered pairs of points."""
    pairs = [(seen, asked) for seen in study.points for asked in study.points if seen is not asked]
    predictions = [(predict(study, *pair), pair[1]) for pair in pairs]
    return (
        float(np.mean([prediction.score(asked) for prediction, asked in predictions])),
        float(np.mean([prediction.covers(asked) for prediction, asked in predictions])),
    )


def scored(rule: str, kind: str | None = None) -> tuple[float, float, int]:
    """Mean score and coverage over the studies, and how many studies."""
    found = [of_study(study, RULES[rule]) for study in studies() if kind in (None, study.kind)]
    score, covers = np.mean(found, axis=0)
    return float(score), float(covers), len(found)


def left_out(choice: str) -> tuple[float, float, str]:
    """Score and coverage of each study with the value that does best on all others, averaged; and which values were taken so."""
    values = CHOICES[choice]
    found = np.array([[of_study(study, lambda *of, more=more: banded(*of, more)) for study in studies()] for more in values.values()])
    others = found[:, :, 0].sum(axis=1, keepdims=True) - found[:, :, 0]
    best = others.argmax(axis=0)
    score, covers = found[best, np.arange(len(best))].mean(axis=0)
    return float(score), float(covers), ", ".join(name for i, name in enumerate(values) if i in best)


def choices() -> str:
    """What each choice of the priors would score if it were made without the study that is scored."""
    score, covers, _ = scored("this library")
    rows = ["| Chosen on the other studies | score / in the band | taken then |", "|---|---|---|", f"| nothing: as it is | {score:.2f} / {100 * covers:.0f} % | |"]
    for choice in CHOICES:
        score, covers, taken = left_out(choice)
        rows.append(f"| {choice} | {score:.2f} / {100 * covers:.0f} % | {taken} |".replace("| -", "| −"))
    return "\n".join(rows)


def picture(file: Path) -> None:
    """Predicted over measured at the last point of each study, from its first: this library with its band, and a constant."""
    with style():
        figure = Figure(figsize=(5.0, 4.6))
        axes = figure.add_axes((0.36, 0.18, 0.61, 0.75))
        axes.set_title("A constant fails on balls, and does well on many asperities", loc="right", weight="bold", fontsize=10)
        found = studies()
        for place, study in enumerate(found):
            seen, asked = min(study.points), max(study.points)
            predicted = banded(study, seen, asked)
            ends = (predicted.middle - REACH * predicted.below, predicted.middle, predicted.middle + REACH * predicted.above)
            low, middle, high = (math.exp(end) / asked.coefficient for end in ends)
            axes.plot((low, high), (place, place), color=BLUE, lw=5, alpha=0.3, solid_capstyle="butt")
            axes.plot(middle, place, "o", color=BLUE, ms=5, label="" if place else "this library, 95 % band")
            axes.plot(seen.coefficient / asked.coefficient, place, "D", color=ORANGE, ms=5, label="" if place else "a constant")
        axes.axvline(1, color=GREY, lw=1.2)
        axes.set(xscale="log", xlim=(0.04, 14), ylim=(len(found) - 0.4, -0.6), xlabel="predicted / measured [–]")
        axes.set_yticks(range(len(found)), [NAMES.get(study.name, study.name) for study in found], fontsize=8.5)
        axes.set_xticks([0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10], ["0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10"])
        axes.minorticks_off()
        figure.legend(fontsize=9, loc="lower center", ncols=2, frameon=False)
        saved(figure, file)


def table() -> str:
    """Score and coverage of each rule."""
    kinds = {"all": None, "many asperities": "many", "one smooth ball": "ball"}
    counts = {name: scored("constant ± 5 %", kind)[2] for name, kind in kinds.items()}
    rows = [f"| One point predicts the others by | {' | '.join(f'{name} ({count})' for name, count in counts.items())} |"]
    rows.append("|---" * (len(kinds) + 1) + "|")
    for rule in RULES:
        cells = (f"{score:.2f} / {100 * cover:.0f} %" for score, cover, _ in (scored(rule, kind) for kind in kinds.values()))
        rows.append(f"| {rule} | {' | '.join(cells)} |".replace("-", "−"))
    return "\n".join([rows[0], "|---" * (len(kinds) + 1) + "|", *rows[2:]])


if __name__ == "__main__":
    print(table(), choices(), sep="\n\n")
