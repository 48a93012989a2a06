"""Tables of friction against pressure in the input languages of hosts; docs/export.md says how each is used."""

from __future__ import annotations

import re
from typing import Callable, List, Tuple

from ._pressure_table import PressureTable

Rows = List[Tuple[str, str]]


def _csv(name: str, title: str, rows: Rows) -> str:
    return "pressure,friction_coefficient\n" + "".join(f"{pressure},{mu}\n" for pressure, mu in rows)


def _abaqus(name: str, title: str, rows: Rows) -> str:
    """Data lines of *FRICTION: coefficient, slip rate (left out), contact pressure."""
    return f"** {title}\n*FRICTION\n" + "".join(f"{mu}, , {pressure}\n" for pressure, mu in rows)


def _ansys(name: str, title: str, rows: Rows) -> str:
    """TBFIELD,NPRES sets the pressure of the TBDATA after it; ARG1 is the number of the contact's material."""
    lines = [f"! {title}", "TB,FRIC,ARG1,,,ISO"]
    for pressure, mu in rows:
        lines += [f"TBFIELD,NPRES,{pressure}", f"TBDATA,1,{mu}"]
    return "\n".join(lines) + "\n"


def _moose(name: str, title: str, rows: Rows) -> str:
    """A function of x, which the constraints of mortar contact give the contact pressure as."""
    pressures, coefficients = (" ".join(column) for column in zip(*rows))
    return (
        f"# {title}\n[Functions]\n  [{name}]\n    type = PiecewiseLinear\n    axis = x\n    x = '{pressures}'\n"
        f"    y = '{coefficients}'\n  []\n[]\n"
    )


def _modelica(name: str, title: str, rows: Rows) -> str:
    table = ";\n      ".join(f"{pressure}, {mu}" for pressure, mu in rows)
    comment = title.replace("\\", "\\\\").replace('"', '\\"')
    return f"""block {name} "{comment}"
  extends Modelica.Blocks.Tables.CombiTable1Ds(
    columns={{2}},
    smoothness=Modelica.Blocks.Types.Smoothness.LinearSegments,
    extrapolation=Modelica.Blocks.Types.Extrapolation.HoldLastPoint,
    table=[
      {table}]);
end {name};
"""


FORMATS: dict[str, Callable[[str, str, Rows], str]] = {
    "abaqus": _abaqus,
    "ansys": _ansys,
    "csv": _csv,
    "modelica": _modelica,
    "moose": _moose,
}


def written(kind: str, table: PressureTable, *, pascal: float, name: str, title: str) -> str:
    """The text of a table, its pressures in units of so many pascal."""
    name = name if re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII) else "Friction"
    rows = [(f"{pressure / pascal:.9e}", f"{mu:.9g}") for pressure, mu in zip(table.pressure, table.friction)]
    return FORMATS[kind](name, " ".join(title.split()), rows)
