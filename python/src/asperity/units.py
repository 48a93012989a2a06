"""The dimensions of what parameters and answers are, for people: every number is in the caller's one system of units."""

from __future__ import annotations

from dataclasses import fields
from html import escape
from typing import Any

from ._header import UNITS

# The SI units of dimensions.
SI = {
    "force": "N", "force/length": "N/m", "stress": "Pa", "length": "m", "length^2": "m^2", "1/length": "1/m", "1/length^2": "1/m^2",
}  # fmt: skip
# The dimensions of fields, and of the other keys of surfaces; what is not here is a plain number.
DIMENSIONS = UNITS | {
    **dict.fromkeys(("E1", "E2"), "stress"),
    **dict.fromkeys(("Ra", "Rq", "RSm", "Sq", "table_height", "heights_at_scores"), "length"),
    **dict.fromkeys(("Ssc", "table_density"), "1/length"),
    **dict.fromkeys(("m4", "Sds", "summit_density"), "1/length^2"),
    "m0": "length^2",
}


def unit(dimension: str, in_si: bool) -> str:
    """The SI unit of a dimension; the dimension itself if the system of units is the caller's own."""
    return SI.get(dimension, dimension) if in_si else dimension


def of(name: str, in_si: bool = True) -> str:
    """The same of a field or key."""
    return unit(DIMENSIONS.get(name, ""), in_si)


def rows(of: Any) -> list[tuple[str, str, str]]:
    """Name, value and unit of each field of a dataclass that is not at its default."""
    in_si = getattr(of, "in_si", False)
    shown = [field.name for field in fields(of) if getattr(of, field.name) != field.default and field.name != "in_si"]
    return [(name, _value(getattr(of, name)), unit(UNITS.get(name, ""), in_si)) for name in shown]


def text(of: Any) -> str:
    """A dataclass with its units, a line for each field."""
    lines = [f"  {name:28} {value}{f' [{of_it}]' if of_it else ''}" for name, value, of_it in rows(of)]
    return "\n".join([type(of).__name__, *lines])


def table(of: Any) -> str:
    """The same as a table of HTML."""
    cells = (f"<tr><td>{name}</td><td>{escape(value)}</td><td>{escape(of_it)}</td></tr>" for name, value, of_it in rows(of))
    return f"<table><caption>{type(of).__name__}</caption>{''.join(cells)}</table>"


def _value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, tuple):
        return f"{len(value)} numbers"
    return str(value).splitlines()[0] if str(value) else ""
