"""The tables of measurements and boundary elements, written between marks in the pages of `TABLES`; a test compares them.

usage: tables.py        writes the tables into the pages
"""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import adhesion
import beads
import boundary_elements
import coverage
import estimates
import shaped
import shapes
import yielding
from boundary_elements import PRESSURES, AnyRow

DOCS = Path(__file__).resolve().parents[2] / "docs"
sys.path.insert(0, str(DOCS))

from gallery import calibrated, contacts, defaults, measured  # noqa: E402


def areas() -> str:
    """Real area over nominal area by load: boundary elements, the library, and theories in closed form."""
    rows = [
        "| x | Boundary elements | Library | Persson, erf(√2 x) | Bush, Gibson and Thomas, √(2π) x |",
        "|---|---|---|---|---|",
    ]
    frozen = [row for row in boundary_elements.frozen() if row.waves >= 4]
    for pressure in PRESSURES:
        at_load = [row for row in frozen if row.pressure == pressure]
        found = [100 * row.area for row in at_load]
        ours = 100 * np.mean([row.area * row.by_moments.area for row in at_load])
        persson, bush = 100 * math.erf(math.sqrt(2) * pressure), 100 * math.sqrt(2 * math.pi) * pressure
        cells = [f"{pressure:g}", f"{np.mean(found):.3g} ± {np.std(found, ddof=1):.1g} %"]
        rows.append(f"| {' | '.join(cells)} | {ours:.3g} % | {persson:.3g} % | {bush:.3g} % |")
    return "\n".join(rows)


# The loads of the table of spectra.
SHOWN = (PRESSURES[0], PRESSURES[1], PRESSURES[3])


def population() -> str:
    """Library over boundary elements by spectrum: means over the surfaces."""
    rows = [
        "| Bandwidth | Waves a side | Spectrum | Surfaces | Area | Friction | Normal stiffness | Gap, difference over Sq "
        "| Area, McCool |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    groups = _groups(boundary_elements.frozen())
    for group in sorted(groups, key=lambda rows: (rows[0].waves < 4, rows[0].bandwidth)):
        loads = [[row for row in group if row.pressure == pressure] for pressure in SHOWN]
        ours = [[row.by_moments for row in at_load] for at_load in loads]
        mccool = [[row.by_mccool for row in at_load] for at_load in loads]
        cells = [
            f"{np.mean([row.bandwidth for row in group]):.2g}", f"{group[0].waves:g}", group[0].kind, str(len(loads[0])),
            *(_means(ours, name) for name in ("area", "friction", "stiffness")), _means(ours, "gap", "+.2f"),
            _means(mccool, "area"),
        ]  # fmt: skip
        rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


def _means(answers: list[list[Any]], name: str, form: str = ".2f") -> str:
    means = (np.mean([getattr(answer, name) for answer in at_load]) for at_load in answers)
    return ", ".join(f"{mean:{form}}".replace("-", "−") for mean in means)


def errors() -> str:
    """Library over boundary elements on the surfaces that the constants were not fitted to, by load."""
    rows = [
        "| Waves a side | x | Surfaces | Area | Friction | Normal stiffness | Gap, difference over Sq |",
        "|---|---|---|---|---|---|---|",
    ]
    others = [row for row in boundary_elements.frozen() if not row.fitted]
    for waves, many in (("4 and more", True), ("1 or 2", False)):
        for pressure in PRESSURES:
            found = [row.by_moments for row in others if row.pressure == pressure and (row.waves >= 4) == many]
            cells = [waves, f"{pressure:g}", str(len(found))]
            cells += [_spread([getattr(answer, name) for answer in found]) for name in ("area", "friction", "stiffness", "gap")]
            rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


# The adhesive shares of the load that divide the table.
SHARES = (0.01, 0.06, 0.15, 0.5, 2.0, math.inf)


def sticky() -> str:
    """Library over boundary elements if surfaces stick, over the same without adhesion at the same mean gap."""
    frozen = adhesion.frozen()
    dry = {(row.grid, row.lowest, row.seed, row.dry_pressure): row.by_moments for row in frozen if not row.work}
    rows = [
        "| Adhesive share of the load | Bandwidth | States | Area | Friction | Area if adhesion is neglected | Friction, the same |",
        "|---|---|---|---|---|---|---|",
    ]
    groups = _groups(frozen)
    for least, greatest in zip(SHARES, SHARES[1:]):
        for group in groups:
            found = [row for row in group if row.work and least <= row.share < greatest]
            if not found:
                continue
            cells = [f"{least:g} to {greatest:g}" if greatest < math.inf else f"above {least:g}"]
            cells += [f"{np.mean([row.bandwidth for row in group]):.2g}", str(len(found))]
            for answer in ("by_moments", "without_adhesion"):
                for name in ("area", "friction"):
                    ratios = [
                        getattr(getattr(row, answer), name)
                        / getattr(dry[row.grid, row.lowest, row.seed, row.dry_pressure], name)
                        for row in found
                    ]
                    cells.append(f"{min(ratios):.2f} to {max(ratios):.2f}")
            rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


def yields() -> str:
    """Library over boundary elements whose pressure is cut at the hardness, by bandwidth and plasticity index."""
    rows = [
        "| Bandwidth | ψ | Real area | At the hardness | A H/P | A | F | A, elastic law | F, elastic law |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for group in _groups(yielding.frozen()):
        for index in yielding.INDICES:
            for pressure in yielding.PRESSURES:
                found = [row for row in group if (row.index, row.pressure) == (index, pressure)]
                laws = [[getattr(row, law) for row in found] for law in ("by_moments", "by_elastic")]
                cells = [
                    f"{np.mean([row.bandwidth for row in found]):.2g}",
                    f"{np.mean([row.plasticity_index for row in found]):.2g}",
                    f"{100 * np.mean([row.area for row in found]):.2g} %",
                    f"{100 * np.mean([row.saturated for row in found]):.0f} %",
                    f"{np.mean([row.area_at_the_hardness for row in found]):.2f}",
                    *(_spread([getattr(answer, name) for answer in answers])
                      for answers in laws for name in ("area", "friction")),
                ]  # fmt: skip
                rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


# Of fewer bands no part is told.
FEWEST = 100


def covered() -> str:
    """How many of the bands called 95 % have the truth, by kind."""
    rows = ["| Call | Of | Errors of the points | Points, or waves a side: bands with the truth |", "|---|---|---|---|"]
    kinds: dict[tuple[str, str, str], list[str]] = {}
    for row in coverage.frozen():
        part = f"{100 * row.part:.1f} %" if row.repeats - row.refused >= FEWEST else "no band"
        refused = f" (of {100 * row.refused / row.repeats:.0f} % it says that there is none)" if 0 < row.refused < row.repeats else ""
        fewer = f" of {row.repeats}" if row.repeats < coverage.REPEATS else ""
        kinds.setdefault((row.call, row.what, row.errors or "–"), []).append(f"{row.points}: {part}{fewer}{refused}")
    return "\n".join([*rows, *(f"| {' | '.join(kind)} | {'; '.join(cells)} |" for kind, cells in kinds.items())])


def _groups(frozen: list[AnyRow]) -> list[list[AnyRow]]:
    """The frozen rows by spectrum, in the order of the file."""
    groups: dict[tuple[float, ...], list[AnyRow]] = {}
    for row in frozen:
        groups.setdefault((row.grid, row.lowest, row.corner, row.highest, row.hurst, row.bands), []).append(row)
    return list(groups.values())


def _spread(values: list[float]) -> str:
    return f"{np.mean(values):.2f} ± {np.std(values, ddof=1):.2f}".replace("-", "−")


def scores() -> str:
    """What the front page says of the estimates, and of the comparisons that have no band."""
    rows = []
    for kind, what in (("ball", "one smooth ball touches"), ("many", "many asperities touch")):
        score, covers, count = estimates.scored("this library", kind)
        best = max((f"constant ± {error} %" for error in (5, 50)), key=lambda rule: estimates.scored(rule, kind)[0])
        other = estimates.scored(best, kind)
        claim = "It wins" if score > other[0] else "A constant is closer"
        rows.append(f"- **{claim} where {what}** ({count} sets): our 95 % band contains {100 * covers:.0f} % of the other points, "
                    f"a {best} {100 * other[1]:.0f} %.")  # fmt: skip
    failed = [one for one in calibrated.COMPARISONS if not one.agrees]
    off = sorted(math.exp(abs(math.log1p(max(one.worst()[1], key=abs)))) for one in failed)
    rows.append(
        f"- **It fails in {len(failed)} of {len(calibrated.COMPARISONS)} other comparisons**, without a band, by factors of {off[0]:.1f} to {off[-1]:.1f}: "
        f"{', '.join(one.name for one in failed)} ([why](docs/validation.md#measurements-calibrated-at-one-load))."
    )
    return "\n".join(rows)


# By page and mark.
TABLES: dict[tuple[str, str], Callable[[], str]] = {
    ("model.md", "areas"): areas,
    ("dev/validation-data.md", "contacts"): contacts.table,
    ("when-to-use.md", "defaults"): defaults.table,
    ("validation.md", "calibrated"): calibrated.verdicts,
    ("validation.md", "estimates"): estimates.table,
    ("dev/validation-data.md", "choices"): estimates.choices,
    ("../README.md", "scores"): scores,
    ("dev/validation-data.md", "errors"): errors,
    ("dev/validation-data.md", "shapes"): shapes.table,
    ("dev/validation-data.md", "misses"): shapes.misses,
    ("dev/validation-data.md", "shaped"): shaped.table,
    ("validation.md", "counts"): shapes.counts,
    ("roughness.md", "inputs"): shapes.inputs,
    ("dev/validation-data.md", "beads"): beads.table,
    ("dev/validation-data.md", "calibrated-table"): calibrated.table,
    ("dev/validation-data.md", "calibrated-inputs"): calibrated.inputs,
    ("dev/validation-data.md", "measurements-table"): measured.table,
    ("dev/validation-data.md", "measurements-inputs"): measured.inputs,
    ("dev/validation-data.md", "population"): population,
    ("dev/validation-data.md", "sticky"): sticky,
    ("dev/validation-data.md", "yielding"): yields,
    ("dev/validation-data.md", "coverage"): covered,
}


def block(mark: str, text: str) -> str:
    return f"<!-- {mark}: tests/validation/tables.py -->\n{text}\n<!-- end of {mark} -->"


def main() -> None:
    for (page, mark), table in TABLES.items():
        file = DOCS / page
        old = file.read_text(encoding="utf-8")
        pattern = re.compile(rf"<!-- {mark}: .*?<!-- end of {mark} -->", re.DOTALL)
        if len(pattern.findall(old)) != 1:
            raise ValueError(f"{file}: needs one place between '<!-- {mark}: ... -->' and '<!-- end of {mark} -->'")
        text = block(mark, table())
        file.write_text(pattern.sub(lambda _: text, old), encoding="utf-8")
    estimates.picture(DOCS / "figures" / "scored.svg")


if __name__ == "__main__":
    main()
