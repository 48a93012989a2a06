"""The dimensions of what parameters and answers are, for people: every number is in the caller's one system of units."""

from __future__ import annotations

from dataclasses import fields
from html import escape
from typing import Any

DIMENSIONS = {
    "composite_modulus": "stress",
    "effective_shear_modulus": "stress",
    "tangential_modulus": "stress",
    "hardness": "stress",
    "mean_asperity_pressure": "stress",
    "work_of_adhesion": "force/length",
    "tangential_stiffness": "force/length",
    "dload_dseparation": "force/length",
    "adhesion_range": "length",
    "burgers_vector": "length",
    "height_std": "length",
    "summit_radius": "length",
    "separation": "length",
    "mean_contact_radius": "length",
    "max_contact_radius": "length",
    "contact_radius_sum": "length",
    "nominal_area": "length^2",
    "real_area": "length^2",
    "load": "force",
    "friction_force": "force",
    "attraction_load": "force",
    "hertz_load": "force",
    "pull_off_load": "force",
    "pull_off_friction_force": "force",
    "zero_load_friction_force": "force",
    "min_table_load": "force",
    "max_table_load": "force",
    "dmu_dload": "1/force",
}


def rows(of: Any) -> list[tuple[str, str, str]]:
    """Name, value and dimension of each field of a dataclass that is not at its default."""
    shown = [field for field in fields(of) if getattr(of, field.name) != field.default]
    return [(field.name, _value(getattr(of, field.name)), DIMENSIONS.get(field.name, "")) for field in shown]


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
