"""The dimensions of what parameters and answers are, for people: every number is in the caller's one system of units."""

from __future__ import annotations

from dataclasses import fields
from html import escape
from typing import Any

from ._header import UNITS

# The SI units of dimensions.
SI = {"force": "N", "force/length": "N/m", "stress": "Pa", "length": "m", "length^2": "m^2"}


def rows(of: Any) -> list[tuple[str, str, str]]:
    """Name, value and dimension of each field of a dataclass that is not at its default."""
    shown = [field for field in fields(of) if getattr(of, field.name) != field.default]
    return [(field.name, _value(getattr(of, field.name)), UNITS.get(field.name, "")) for field in shown]


def text(of: Any) -> str:
    """A dataclass with its units, a line for each field."""
    lines = [f"  {name:28} {value}{f' [{unit}]' if unit else ''}" for name, value, unit in rows(of)]
    return "\n".join([type(of).__name__, *lines])


def table(of: Any) -> str:
    """The same as a table of HTML."""
    cells = (f"<tr><td>{name}</td><td>{escape(value)}</td><td>{escape(unit)}</td></tr>" for name, value, unit in rows(of))
    return f"<table><caption>{type(of).__name__}</caption>{''.join(cells)}</table>"


def _value(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, tuple):
        return f"{len(value)} numbers"
    return str(value).splitlines()[0] if str(value) else ""
