"""Surfaces that are not Gaussian, made and measured, against boundary elements: by their heights and slopes at scores, and by Sq and Sdq.

tests/reference/nongaussian.csv and measured_maps.csv have the surfaces, their units in their first lines.

usage: shapes.py [FILE]        draws docs/figures/shapes.svg
"""

from __future__ import annotations

import csv
import math
import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache
from pathlib import Path

from asperity import Model, Params, State, Warnings
from asperity.estimate import estimate
from asperity.tools.style import BLUE, GREY, saved, style

ROOT = Path(__file__).resolve().parents[2]
FILE = ROOT / "docs" / "figures" / "shapes.svg"

# Friction is calibrated at one pressure over E* and slope and predicted at the other.
CALIBRATED, PREDICTED = 0.03, 0.0025
# A lay of half of this is no other than that of chance; Ssk up to this is that of Gaussian surfaces.
LAY, SKEW = 1.2, 0.15
KINDS = (
    "Gaussian", "lay 1.5 to 3", "lay 5 to 12", "ground (lay 4)", "skew −1.6 to −0.4", "skew 1.0 to 1.6", "honed, worn", "rough patches", "pits in a flat",
    "measured maps",
)  # fmt: skip
# What may be known of a surface, and the keys of `[roughness]` that say it.
KNOWN = {
    "a height map": "`heights_at_scores`, `slopes_at_scores`, `lay`: `surface.analyse` writes them",
    "a bearing curve, Sdq of all and of the top 16 %": "`heights_at_scores`, `Sdq`, `Sdq_top`",
    "a bearing curve and Sdq": "`heights_at_scores`, `Sdq`",
    "skew and kurtosis": "`Sq`, `Sdq`, `Ssk`, `Sku`",
    "plateaus and valleys (ISO 13565-3)": "`Spq`, `Svq`, `Smq`, `Sdq`",
    "nothing more": "`Sq`, `Sdq`",
}


@dataclass(frozen=True)
class Surface:
    """A surface at all its loads.

    Attributes:
        name: as in the file; of a map, what it is of.
        rows: numbers by column, of each load.
        is_measured: whether it is of a map.
    """

    name: str
    rows: tuple[dict[str, float], ...]
    is_measured: bool

    @property
    def kind(self) -> str:
        """One of `KINDS`."""
        if self.is_measured:
            return KINDS[-1]
        named = {"ground": 3, "pits": 8, "patches": 7, "plateau": 6, "plat2": 6, "wornground": 6}
        whole = self.name.partition("_")[0]
        lay = math.sqrt(self.rows[0]["m2x"] / self.rows[0]["m2y"])
        if whole in named:
            return KINDS[named[whole]]
        if abs(self.rows[0]["skew"]) > SKEW:
            return KINDS[4 if self.rows[0]["skew"] < 0 else 5]
        return KINDS[0 if lay < LAY else 1 if lay < 4 else 2]

    @property
    def slope(self) -> float:
        """Sdq."""
        return math.sqrt(self.rows[0]["m2x"] + self.rows[0]["m2y"])

    @property
    def area(self) -> float:
        """Nominal, in points."""
        return self.rows[0].get("cell", 512.0) ** 2

    @property
    def table(self) -> str:
        """Heights and slopes at scores and the lay, as a text has them."""
        row, column = self.rows[0], "cabs" if self.is_measured else "c"
        heights, slopes = ([row[f"{name}{k / 2:+.1f}"] for k in range(-6, 7)] for name in ("T", column))
        heights, slopes = [one * math.sqrt(row["m0"]) for one in heights], [math.sqrt(one) * self.slope for one in slopes]
        return self.rough(heights_at_scores=heights, slopes_at_scores=slopes)

    def rough(self, **given: float | list[float]) -> str:
        """These keys of the roughness, with the lay and the bandwidth."""
        row = self.rows[0]
        keys = given | {"lay": math.sqrt(row["m2x"] / row["m2y"])}
        bandwidth = f"bandwidth = {4 * row['m4'] * row['m0'] / self.slope**4}\n[roughness]\n"
        return bandwidth + "".join(f"{key} = {value}\n" for key, value in keys.items())

    def from_known(self, known: str) -> list[Ratios]:
        """The library from one of `KNOWN`."""
        row, height = self.rows[0], math.sqrt(self.rows[0]["m0"])
        heights = [row[f"T{k / 2:+.1f}"] * height for k in range(-6, 7)]
        top = math.sqrt(row["c_above_score_1"]) * self.slope
        ways: dict[str, Callable[[], list[Ratios]]] = {
            "a height map": lambda: self.by_table,
            "nothing more": lambda: self.by_two,
            "a bearing curve, Sdq of all and of the top 16 %": lambda: self.ratios(self.rough(heights_at_scores=heights, Sdq=self.slope, Sdq_top=top)),
            "a bearing curve and Sdq": lambda: self.ratios(self.rough(heights_at_scores=heights, Sdq=self.slope)),
            "skew and kurtosis": lambda: self.ratios(self.rough(Sq=height, Sdq=self.slope, Ssk=row["skew"], Sku=row["kurtosis"])),
            "plateaus and valleys (ISO 13565-3)": lambda: self.ratios(
                self.rough(Spq=row["Spq"] * height, Svq=row["Svq"] * height, Smq=row["Smq"], Sdq=self.slope)
            ),
        }
        return ways[known]()

    @cached_property
    def by_table(self) -> list[Ratios]:
        """The library from heights and slopes at scores and the lay."""
        return self.ratios(self.table)

    @cached_property
    def by_two(self) -> list[Ratios]:
        """The library from Sq and Sdq."""
        return self.ratios(f"[roughness]\nSq = {math.sqrt(self.rows[0]['m0'])}\nSdq = {self.slope}\n")

    def text(self, rough: str) -> str:
        """Of a surface, in the units of the file."""
        return (
            "composite_modulus = 1\neffective_shear_modulus = 1\nwork_of_adhesion = 0\nadhesion_range = 0.01\nburgers_vector = 0.01\n"
            f"slip_stress_1 = {1 / 43}\nslip_stress_2 = {1 / 1290}\nnominal_area = {self.area}\n{rough}"
        )

    def ratios(self, rough: str) -> list[Ratios]:
        """Of a model over boundary elements."""
        with Model(Params.from_text(self.text(rough))) as model:
            loads = [row["x"] * self.slope * self.area for row in self.rows]
            return [Ratios.of(model.state_at_load(load), model.state_at_load(1.1 * load), row, self.area) for load, row in zip(loads, self.rows)]

    @property
    def is_in_the_band(self) -> bool:
        """Whether an estimate that has friction of boundary elements at one load has theirs at the other in its band, from the table."""
        friction = {row["x"]: row["friction_hk"] / (row["x"] * self.slope) for row in self.rows}
        unit = self.slope * self.area
        found = estimate(self.text(f"measured = [{CALIBRATED * unit}, {friction[CALIBRATED]}]\n{self.table}"), PREDICTED * unit)
        return bool(found.low <= friction[PREDICTED] <= found.high)

    def calibrated(self, ratios: list[Ratios]) -> float:
        """Friction that was calibrated, over boundary elements."""
        at = {row["x"]: one.friction for row, one in zip(self.rows, ratios)}
        return at[PREDICTED] / at[CALIBRATED]


@dataclass(frozen=True)
class Ratios:
    """Of the library over boundary elements, at one load: area, friction and normal stiffness, where that is known; whether it warns of
    flat tops."""

    area: float
    friction: float
    stiffness: float
    has_flat_top: bool

    @classmethod
    def of(cls, state: State, greater: State, row: dict[str, float], area: float) -> Ratios:
        """Of states at the load and at 1.1 of it over a row of the file; stiffness is a secant over the load between."""
        stiffness = 0.1 / 1.05 * math.sqrt(row["m0"]) / (state.gap - greater.gap)
        area, friction = (one / area / row[name] for one, name in ((state.real_area, "area"), (state.friction_force, "friction_hk")))
        return cls(area, friction, stiffness / row["stiffness"], Warnings.FLAT_TOP in state.warnings)


@lru_cache(maxsize=None)
def frozen() -> tuple[Surface, ...]:
    """All surfaces that were made, and the first crop of each measured map, without its spikes."""
    found: dict[tuple[str, ...], list[dict[str, float]]] = {}
    for file in ("nongaussian", "measured_maps"):
        with (ROOT / "tests" / "reference" / f"{file}.csv").open(encoding="utf-8", newline="") as text:
            for row in csv.DictReader(line for line in text if not line.startswith("#")):
                if file == "measured_maps" and (row["seed"], row["spikes_kept"]) != ("0", "0") or row["name"].endswith("_full"):
                    continue
                words = {"name", "kind", "source", "licence"}
                numbers = {name: float(value) for name, value in row.items() if name not in words}
                found.setdefault((file, row["name"], row["seed"], row.get("kind", row["name"])), []).append(numbers)
    return tuple(Surface(name, tuple(rows), file == "measured_maps") for (file, *_, name), rows in found.items())


def within(surfaces: list[Surface], factor: float, of: Callable[[Surface], list[float]]) -> int:
    """How many have all of these ratios within 1 - factor to 1 + factor."""
    return sum(all(abs(ratio - 1) <= factor for ratio in of(one)) for one in surfaces)


def table() -> str:
    """Ranges by kind of surface, before and after."""
    rows = [
        "| Surfaces | | Area from Sq and Sdq | from the table | Calibrated friction from Sq and Sdq | from the table | Stiffness from the table |",
        "|---|---|---|---|---|---|---|",
    ]
    for kind in KINDS:
        some = [one for one in frozen() if one.kind == kind]
        cells = [kind, str(len(some))]
        for values in (
            [ratio.area for one in some for ratio in one.by_two], [ratio.area for one in some for ratio in one.by_table],
            [one.calibrated(one.by_two) for one in some], [one.calibrated(one.by_table) for one in some],
            [ratio.stiffness for one in some for ratio in one.by_table if math.isfinite(ratio.stiffness)],
        ):  # fmt: skip
            cells.append(f"{min(values):.2f} to {max(values):.2f}" if values else "not known")
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


def inputs() -> str:
    """How near area is to that of the surfaces that were made, by what is known of them."""
    some = [one for one in frozen() if not one.is_measured]
    rows = [f"| What you know | In `[roughness]` | Area within 15 %, of {len(some)} | rms of ln A |", "|---|---|---|---|"]
    for known, keys in KNOWN.items():
        found = [[ratio.area for ratio in one.from_known(known)] for one in some]
        near = sum(all(abs(area - 1) <= 0.15 for area in areas) for areas in found)
        squares = [math.log(area) ** 2 for areas in found for area in areas]
        rows.append(f"| {known} | {keys} | {near} | {math.sqrt(sum(squares) / len(squares)):.2f} |")
    return "\n".join(rows)


def counts() -> str:
    """How many are within 15 and 10 %."""
    lines = []
    for called, some in (("made", [one for one in frozen() if not one.is_measured]), ("measured", [one for one in frozen() if one.is_measured])):
        before, after = (
            (within(some, 0.15, lambda one: [ratio.area for ratio in way(one)]), within(some, 0.1, lambda one: [one.calibrated(way(one))]))
            for way in (lambda one: one.by_two, lambda one: one.by_table)
        )
        lines.append(
            f"- **{len(some)} surfaces that were {called}**: area is within 15 % at all loads on {after[0]} from the table and on {before[0]} "
            f"from Sq and Sdq; calibrated friction, at a twelfth of the load, is within 10 % on {after[1]} and {before[1]}. The 95 % band of an estimate "
            f"that was calibrated has it on {sum(one.is_in_the_band for one in some)}."
        )
    return "\n".join(lines)


def misses() -> str:
    """Where calibrated friction errs by more than a tenth: the errors of area and of strength whose product it is, and the patches
    of boundary elements."""
    rows = [
        "| Surface | Calibrated friction | that of area | that of strength | Patches, light and heavy | Points a patch |",
        "|---|---|---|---|---|---|",
    ]
    for one in frozen():
        if abs(one.calibrated(one.by_table) - 1) > 0.1:
            at = {row["x"]: (row, ratio) for row, ratio in zip(one.rows, one.by_table)}
            (light, ours), (heavy, our_heavy) = at[PREDICTED], at[CALIBRATED]
            area, friction = ours.area / our_heavy.area, ours.friction / our_heavy.friction
            points = [f"{row['area'] * one.area / row['patches']:.0f}" for row in (light, heavy)]
            cells = [one.name, *(f"{ratio:.2f}" for ratio in (friction, area, friction / area))]
            rows.append(f"| {' | '.join(cells)} | {light['patches']:.0f}, {heavy['patches']:.0f} | {', '.join(points)} |")
    return "\n".join(rows)


def draw(file: str) -> None:
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.5, 4.6), layout="constrained")
        figure.suptitle("Heights and slopes at scores describe surfaces that are not Gaussian", weight="bold", fontsize=11)
        areas, frictions = figure.subplots(1, 2, sharey=True)
        for place, kind in enumerate(KINDS):
            some = [one for one in frozen() if one.kind == kind]
            for shift, colour, marker, way in ((-0.15, GREY, "o", "by_two"), (0.15, BLUE, "D", "by_table")):
                for axes, values in (
                    (areas, [ratio.area for one in some for ratio in getattr(one, way)]),
                    (frictions, [one.calibrated(getattr(one, way)) for one in some]),
                ):
                    label = {"by_two": "from Sq and Sdq", "by_table": "from heights and slopes at scores"}[way] if place == 0 else None
                    axes.plot(values, [place + shift] * len(values), marker, color=colour, mfc="none", markersize=4, label=label)
        for axes, title, near in ((areas, "real area, library over boundary elements", 0.15), (frictions, "calibrated friction, the same", 0.1)):
            axes.axvspan(1 - near, 1 + near, color=BLUE, alpha=0.12, lw=0)
            axes.set(xscale="log", xlabel=title, xticks=(0.2, 0.5, 1, 2, 4), xticklabels=("0.2", "0.5", "1", "2", "4"))
            axes.minorticks_off()
        areas.set(yticks=range(len(KINDS)), yticklabels=KINDS, ylim=(len(KINDS) - 0.5, -0.5))
        figure.legend(*areas.get_legend_handles_labels(), loc="outside lower center", ncols=2, fontsize=8)
        saved(figure, file)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else str(FILE))
