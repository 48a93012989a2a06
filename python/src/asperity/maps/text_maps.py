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
# What a header says of the number that stands for a missing point, and a number of it with a decimal comma, before a unit.
_NO_DATA = re.compile(rf"^\W*(?:no[ _-]?data|missing|bad|void|undefined)(?:[ _-]?values?)?\s*[:=,;]?\s*({_NUMBER})\s*$", re.IGNORECASE)
_COMMA_IN_HEADER = re.compile(r"^(.*[:=\s]\d+),(\d+\s*[^\W\d]+\s*)$")
_UNITS = re.compile(r"[\[(]\s*([^\W\d]+)\s*[\])]")
# Rows and columns of so many numbers may be axes.
_AXIS = 5


class Table(NamedTuple):
    """A text that is mostly a table of numbers.

    Attributes:
        lines: of the text, as SurfaceTopography reads them.
        odd: whether it reads the file itself wrongly.
        points: x, y and z of points, if the table has three columns.
        units: of these three, where the header names them.
    """

    lines: list[str]
    odd: bool
    points: Array | None
    units: tuple[str, ...] = ()

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
    rows = [fields(line) for line in lines]
    words = [line for line, row in zip(lines[:_LINES], rows) if not row]
    missing = {float(found[1].replace(",", ".")) for line in words if (found := _NO_DATA.match(line))}
    lines = [line if row else _COMMA_IN_HEADER.sub(r"\1.\2", line) for line, row in zip(lines, rows)]
    odd = comma or strange or bool(missing) or any(_ODD.search(line) for line in lines if not line.startswith("#"))
    odd |= words != [line for line, row in zip(lines[:_LINES], rows) if not row]
    if comma:
        rows = [[one.replace(",", ".") for one in row] for row in rows]
    odd |= _drop_axes(rows)
    if columns == 0 or not (odd or separated or columns == 3):
        return None
    rows = [["nan" if _ODD.fullmatch(one) or missing and _number(one) in missing else one for one in row] for row in rows]
    known = [row for row in rows if row]
    if 2 * len(known) < len(lines):
        return None
    units: tuple[str, ...] = next((tuple(three) for line in words if len(three := _UNITS.findall(line)) == 3), ())
    points = None
    if len(known) >= 10 and {len(row) for row in known} == {3}:
        points = np.array([[float("nan" if one.lower() == "bad" else one) for one in row] for row in known])
        points = points[np.isfinite(points[:, :2]).all(axis=1)]
    return Table([" ".join(row) if row else line for row, line in zip(rows, lines)], odd, points, units)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        return float("nan")


def _drop_axes(rows: list[list[str]]) -> bool:
    """Empties a first row, and takes away a first column, that counts or has places: evenly spaced, as no heights are."""
    known = [row for row in rows if row]
    if len(known) < _AXIS or len(known[1]) < _AXIS or len({len(row) for row in known[1:]}) > 1:
        return False
    first, columns = known[0], len(known[1])
    named = len(first) >= columns - 1 and _is_axis(first[-columns + 1 :]) and not _is_axis(known[1][1:])
    body = known[1:] if named or len(first) != columns else known
    counted = _is_axis([row[0] for row in body]) and not _is_axis([row[1] for row in body])
    if named:
        first.clear()
    for row in body if counted else ():
        del row[0]
    return named or counted


def _is_axis(texts: list[str]) -> bool:
    apart = np.diff([_number(one) for one in texts])
    return bool(apart[0] != 0 and (np.abs(apart - apart[0]) <= 1e-2 * abs(apart[0])).all())


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
