"""Tables of numbers in text files: their encoding, decimal commas, and what stands for missing points."""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from ..tools import output

Array = npt.NDArray[np.float64]

_NUMBER = r"[-+]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?"
# What stands for a missing point; SurfaceTopography takes the first three.
_MISSING = r"bad|nan|inf|-{2,}|\*+|n/?a|null|none|missing|#n/a|masked"
_FIELD = re.compile(rf"(?:{_NUMBER}|[-+]?(?:{_MISSING}))", re.IGNORECASE)
_ODD = re.compile(r"(?<![^\s;])(?:-{2,}|\*+|n/?a|null|none|missing|#n/a|masked)(?![^\s;])", re.IGNORECASE)
_COMMA = re.compile(r"(?<![^\s;])[-+]?\d+,\d+(?:[eE][-+]?\d+)?(?![^\s;])")
_HEAD, _LINES = 4096, 100


class Table(NamedTuple):
    """A text that is mostly a table of numbers.

    Attributes:
        lines: of the text, as SurfaceTopography reads them.
        odd: whether it reads the file itself wrongly.
        points: x, y and z of points, if the table has three columns.
    """

    lines: list[str]
    odd: bool
    points: Array | None

    def write(self, path: str) -> None:
        output.write(path, "\n".join(self.lines) + "\n")


def table(path: str) -> Table | None:
    """The table that a file is; None if it is none."""
    with open(path, "rb") as file:
        if b"\0" in file.read(_HEAD).removeprefix(b"\xff\xfe") and not _is_wide(path):
            return None
        file.seek(0)
        content = file.read()
    text, strange = _text(content)
    lines = text.splitlines()
    comma = _has_commas(lines)
    separator = re.compile(r"[\s;]+" if comma else r"[\s;,]+")

    def fields(line: str) -> list[str]:
        """The numbers of a line; none if it has anything else."""
        found = [one for one in separator.split(line.strip()) if one]
        numbers = all(_FIELD.fullmatch(one) for one in found) and (len(found) > 3 or any(re.search(r"\d", one) for one in found))
        return found if numbers else []

    some = [found for found in map(fields, lines[:_LINES]) if found]
    columns = max(map(len, some), default=0)
    separated = columns > 3 and any(re.search(r"[;,]", line) for line in lines[:_LINES] if fields(line))
    odd = comma or strange or any(_ODD.search(line) for line in lines if not line.startswith("#"))
    if columns == 0 or not (odd or separated or columns == 3):
        return None
    rows = [fields(line) for line in lines]
    if comma:
        rows = [[one.replace(",", ".") for one in row] for row in rows]
    rows = [["nan" if _ODD.fullmatch(one) else one for one in row] for row in rows]
    known = [row for row in rows if row]
    if 2 * len(known) < len(lines):
        return None
    points = None
    if len(known) >= 10 and {len(row) for row in known} == {3}:
        points = np.array([[float("nan" if one.lower() == "bad" else one) for one in row] for row in known])
        points = points[np.isfinite(points[:, :2]).all(axis=1)]
    return Table([" ".join(row) if row else line for row, line in zip(rows, lines)], odd, points)


def _is_wide(path: str) -> bool:
    with open(path, "rb") as file:
        return file.read(2) in (b"\xff\xfe", b"\xfe\xff")


def _text(content: bytes) -> tuple[str, bool]:
    """The text, and whether it is not in UTF-8."""
    if content[:2] in (b"\xff\xfe", b"\xfe\xff"):
        return content.decode("utf-16", errors="replace"), True
    try:
        return content.decode("utf-8-sig"), content.startswith(b"\xef\xbb\xbf")
    except UnicodeDecodeError:
        return content.decode("latin-1"), True


def _has_commas(lines: list[str]) -> bool:
    """Whether decimals follow commas: in the numbers, and no points."""
    some = [line for line in lines[: 50 + len(lines) // 2] if not line.startswith("#")][-50:]
    return sum(bool(_COMMA.search(line)) for line in some) > len(some) / 2 and not any(re.search(r"\d\.\d", line) for line in some)
