"""The tables of docs/domain.md and docs/validation.md, written between marks in these pages; a test holds them to it.

usage: tables.py        writes the tables into the pages
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import numpy as np

import boundary_elements
import yielding
from asperity.figures import calibrated, contacts, defaults, measured
from boundary_elements import PRESSURES, AnyRow

DOCS = Path(__file__).resolve().parents[2] / "docs"


def population() -> str:
    """Library over boundary elements, by bandwidth: means over the surfaces, and their standard deviation."""
    rows = [
        "| Bandwidth | Surfaces | Real area | Summits in contact | A, from moments | F, from moments "
        "| A, with Nayak's radii and heights | F, with them | A, from the map | F, from the map |",
        "|---|---|---|---|---|---|---|---|---|---|",
    ]
    for group in _groups(boundary_elements.frozen()):
        for pressure in PRESSURES:
            at_load = [row for row in group if row.pressure == pressure]
            moments, maps = [row.by_moments for row in at_load], [row.by_map for row in at_load]
            nayak = [row.by_nayak for row in at_load]
            cells = [
                f"{np.mean([row.bandwidth for row in at_load]):.2g}",
                str(len(at_load)),
                f"{100 * np.mean([row.area for row in at_load]):.2g} %",
                f"{100 * np.mean([answer.fraction_in_contact for answer in moments]):.2g} %",
                *(_spread([getattr(answer, name) for answer in answers])
                  for answers in (moments, nayak, maps) for name in ("area", "friction")),
            ]  # fmt: skip
            rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


def yields() -> str:
    """Library over boundary elements whose pressure is cut at the hardness, by bandwidth and plasticity index."""
    rows = [
        "| Bandwidth | ψ | Real area | At the hardness | A H/P | A, from the map | F, from the map | A, from moments "
        "| F, from moments | A, elastic law | F, elastic law |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for group in _groups(yielding.frozen()):
        for index in yielding.INDICES:
            for pressure in yielding.PRESSURES:
                found = [row for row in group if (row.index, row.pressure) == (index, pressure)]
                laws = [[getattr(row, law) for row in found] for law in ("by_map", "by_moments", "by_elastic")]
                cells = [
                    f"{np.mean([row.bandwidth for row in found]):.2g}",
                    f"{index:g}",
                    f"{100 * np.mean([row.area for row in found]):.2g} %",
                    f"{100 * np.mean([row.saturated for row in found]):.0f} %",
                    f"{np.mean([row.area_at_the_hardness for row in found]):.2f}",
                    *(_spread([getattr(answer, name) for answer in answers])
                      for answers in laws for name in ("area", "friction")),
                ]  # fmt: skip
                rows.append(f"| {' | '.join(cells)} |")
    return "\n".join(rows)


def _groups(frozen: list[AnyRow]) -> list[list[AnyRow]]:
    """The frozen rows by spectrum, in the order of the file."""
    groups: dict[tuple[float, ...], list[AnyRow]] = {}
    for row in frozen:
        groups.setdefault((row.grid, row.lowest, row.highest, row.hurst), []).append(row)
    return list(groups.values())


def _spread(values: list[float]) -> str:
    return f"{np.mean(values):.2f} ± {np.std(values, ddof=1):.2f}"


# By page and mark.
TABLES: dict[tuple[str, str], Callable[[], str]] = {
    ("domain.md", "contacts"): contacts.table,
    ("domain.md", "roughness"): contacts.roughness,
    ("domain.md", "defaults"): defaults.table,
    ("validation.md", "population"): population,
    ("validation.md", "yielding"): yields,
    ("validation.md", "calibrated"): calibrated.table,
    ("validation.md", "measurements"): measured.table,
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


if __name__ == "__main__":
    main()
