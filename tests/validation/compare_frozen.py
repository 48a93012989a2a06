"""Whether boundary elements computed anew are those of boundary_elements.csv to 1e-4; versions of tamaas may differ.

usage: compare_frozen.py FILE.csv
"""

from __future__ import annotations

import sys
from dataclasses import astuple, fields
from pathlib import Path

import boundary_elements
from boundary_elements import Row


def main(file: Path) -> None:
    old, new = boundary_elements.frozen(), boundary_elements.frozen(file)
    if len(old) != len(new):
        sys.exit(f"{file}: {len(new)} rows instead of {len(old)}")
    for number, (then, now) in enumerate(zip(old, new)):
        for field, before, after in zip(fields(Row), astuple(then), astuple(now)):
            # A patch more or less is a pixel that touches or does not.
            allowed = 2 if field.name == "patches" else 1e-4 * abs(before)
            if abs(after - before) > allowed:
                sys.exit(f"{file}, row {number + 1}: {field.name} is {after} instead of {before}")
    print(f"{len(new)} rows as frozen")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
