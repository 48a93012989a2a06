"""Whether boundary elements computed anew are those of boundary_elements.csv, adhesion.csv, joints.csv, shaped.csv or
yielding.csv to 1e-3; versions of tamaas may differ, and half of the first file is by another program of the same algorithm.

usage: compare_frozen.py elastic|joints|shaped|sticky|yielding FILE.csv
"""

from __future__ import annotations

import sys
from dataclasses import astuple, fields
from pathlib import Path
from typing import Any

import adhesion
import boundary_elements
import joints
import shaped
import yielding

FROZEN: dict[str, tuple[Path, type[Any]]] = {
    "elastic": (boundary_elements.FILE, boundary_elements.Row),
    "shaped": (shaped.FILE, shaped.Row),
    "sticky": (adhesion.FILE, adhesion.Row),
    "joints": (joints.FILE, joints.Row),
    "yielding": (yielding.FILE, yielding.Row),
}
TOLERANCE = 1e-3
# What one pixel that touches or not, or the last step of the solver, changes.
COUNTS = {"patches": 4, "steps": 20}


def main(what: str, file: Path) -> None:
    was, row = FROZEN[what]
    old, new = boundary_elements.read(was, row), boundary_elements.read(file, row)
    if len(old) != len(new):
        sys.exit(f"{file}: {len(new)} rows instead of {len(old)}")
    for number, (then, now) in enumerate(zip(old, new)):
        for field, before, after in zip(fields(row), astuple(then), astuple(now)):
            allowed = COUNTS.get(field.name, TOLERANCE * abs(before))
            if not abs(after - before) <= allowed:  # a NaN too
                sys.exit(f"{file}, row {number + 1}: {field.name} is {after} instead of {before}")
    print(f"{len(new)} rows as frozen")


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
