"""Tables of friction against pressure in the input languages of hosts; docs/export.md says how each is used."""

from __future__ import annotations

import re
import textwrap
from typing import Callable, List, NamedTuple, Tuple

from ._pressure_table import PressureTable


class _Table(NamedTuple):
    """What a format may tell: rows of pressure and coefficient, the pascals of the pressure's unit, a number for the table."""

    name: str
    title: str
    rows: List[Tuple[str, str]]
    pascal: float
    table_id: int


def _csv(table: _Table) -> str:
    return "pressure,friction_coefficient\n" + "".join(f"{pressure},{mu}\n" for pressure, mu in table.rows)


def _abaqus(table: _Table) -> str:
    """Data lines of *FRICTION: coefficient, slip rate (left out), contact pressure."""
    return f"** {table.title}\n*FRICTION\n" + "".join(f"{mu}, , {pressure}\n" for pressure, mu in table.rows)


def _ansys(table: _Table) -> str:
    """TBFIELD,NPRES sets the pressure of the TBDATA after it; ARG1 is the number of the contact's material."""
    lines = [f"! {table.title}", "TB,FRIC,ARG1,,,ISO"]
    for pressure, mu in table.rows:
        lines += [f"TBFIELD,NPRES,{pressure}", f"TBDATA,1,{mu}"]
    return "\n".join(lines) + "\n"


# Sets of units whose unit of stress is so many pascal.
_LSDYNA_UNITS = {1.0: "kg, m, s", 1e6: "t, mm, s", 1e9: "kg, mm, ms"}
# The coefficient does not depend on the velocity: a curve ends beyond any, in mm/s too, so that nothing is extrapolated.
_LSDYNA_FASTEST = "1e+09"


def _lsdyna(table: _Table) -> str:
    """A table whose values are pressures; for each follows, in the same order, the curve of the coefficient over velocity."""
    number = table.table_id
    curves = range(number + 1, number + 1 + len(table.rows))
    units = _LSDYNA_UNITS.get(table.pascal)
    lines = [f"$ {line}" for line in textwrap.wrap(table.title, 76)]
    lines += [f"$ Pressures are stresses of a model in {units}."] if units else []
    lines += [
        f"$ IDs in use: table {number}, curves {curves[0]} to {curves[-1]}.",
        "$ In the second card of *CONTACT_AUTOMATIC_SURFACE_TO_SURFACE:",
        "$#      fs        fd",
        f"${2.0:9.1f}{number:9d}.",
        "*DEFINE_TABLE",
        f"{number:10d}",
    ]
    lines += [f"{pressure:>20}" for pressure, _ in table.rows]
    for curve, (_, mu) in zip(curves, table.rows):
        lines += ["*DEFINE_CURVE", f"{curve:10d}", f"{'0.0':>20}{mu:>20}", f"{_LSDYNA_FASTEST:>20}{mu:>20}"]
    return "\n".join(lines) + "\n"


def _moose(table: _Table) -> str:
    """A function of x, which the constraints of mortar contact give the contact pressure as."""
    pressures, coefficients = (" ".join(column) for column in zip(*table.rows))
    return (
        f"# {table.title}\n[Functions]\n  [{table.name}]\n    type = PiecewiseLinear\n    axis = x\n    x = '{pressures}'\n"
        f"    y = '{coefficients}'\n  []\n[]\n"
    )


def _modelica(table: _Table) -> str:
    rows = ";\n      ".join(f"{pressure}, {mu}" for pressure, mu in table.rows)
    comment = table.title.replace("\\", "\\\\").replace('"', '\\"')
    return f"""block {table.name} "{comment}"
  extends Modelica.Blocks.Tables.CombiTable1Ds(
    columns={{2}},
    smoothness=Modelica.Blocks.Types.Smoothness.LinearSegments,
    extrapolation=Modelica.Blocks.Types.Extrapolation.HoldLastPoint,
    table=[
      {rows}]);
end {table.name};
"""


FORMATS: dict[str, Callable[[_Table], str]] = {
    "abaqus": _abaqus,
    "ansys": _ansys,
    "csv": _csv,
    "lsdyna": _lsdyna,
    "modelica": _modelica,
    "moose": _moose,
}


def written(kind: str, table: PressureTable, *, pascal: float, name: str, title: str, table_id: int) -> str:
    """The text of a table, its pressures in units of so many pascal."""
    name = name if re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII) else "Friction"
    rows = [(f"{pressure / pascal:.9e}", f"{mu:.9g}") for pressure, mu in zip(table.pressure, table.friction)]
    return FORMATS[kind](_Table(name, " ".join(title.split()), rows, pascal, table_id))
