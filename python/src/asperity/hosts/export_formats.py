"""Tables of friction against pressure, and of stiffness and conductance, in the input languages of hosts; docs/solvers.md says how
each is used."""

from __future__ import annotations

import re
import textwrap
from typing import Callable, List, NamedTuple, Optional, Tuple

from .pressure_table import Bands, Overclosure, Stiffness, Table

Rows = List[Tuple[str, str]]


class Contact(NamedTuple):
    """What a finite-element contact may need beside friction, in SI units: stiffness at the lowest pressure, between and at the
    highest; its 95 % bands between; normal compliance; conductance."""

    stiffness: Optional[Tuple[Stiffness, Stiffness, Stiffness]] = None
    bands: Optional[Bands] = None
    overclosure: Optional[Overclosure] = None
    conductance: Optional[Table] = None


class _Table(NamedTuple):
    """What a format may tell: rows of pressure and coefficient, units of pressure and length in Pa and m, the table's number."""

    name: str
    title: str
    rows: Rows
    pascal: float
    metre: float
    table_id: int
    contact: Contact

    def normal(self, beyond: str = "") -> str:
        """Pressure against overclosure, whose data lines are the same in Abaqus and CalculiX; `beyond` is a last one."""
        text = ""
        if self.contact.overclosure:
            table, gap = self.contact.overclosure
            rows = _rows(table, self.metre, self.pascal)
            text += f"** Overclosure 0 is a gap of {gap / self.metre:.9g} between the mean planes.\n"
            text += "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR\n0., 0.\n" + "".join(f"{p}, {depth}\n" for depth, p in rows) + beyond
        return text

    def conductance(self, keyword: str) -> str:
        """Data lines of *GAP CONDUCTANCE: conductance, pressure."""
        if not self.contact.conductance:
            return ""
        rows = _rows(self.contact.conductance, self.pascal, self.pascal * self.metre)
        return f"{keyword}\n" + "".join(f"{conductance}, {pressure}\n" for pressure, conductance in rows)

    def stiffness(self, comment: str) -> str:
        """A comment: stiffness per area and elastic slip, with their bands."""
        if not (self.contact.stiffness and self.contact.bands):
            return ""
        low, one, high = ((at.slip / self.metre, at.pressure / self.pascal) for at in self.contact.stiffness)
        by_area, middle, bands = self.pascal / self.metre, self.contact.stiffness[1], self.contact.bands

        def of(value: float, ends: Tuple[float, float], unit: float) -> str:
            return f"{value / unit:.3g} ({ends[0] / unit:.3g} to {ends[1] / unit:.3g})"

        lines = [
            f"Elastic slip F/K_t: {low[0]:.3g} at the pressure {low[1]:.3g}, {one[0]:.3g} at {one[1]:.3g}, {high[0]:.3g} at {high[1]:.3g}.",
            f"At the pressure {one[1]:.3g}, with 95 % bands, since the slope of the surface is hardly known:",
            f"elastic slip {of(middle.slip, bands.slip, self.metre)}",
            f"tangential stiffness per area {of(middle.shear, bands.shear, by_area)}",
            f"normal stiffness per area of first loading {of(middle.normal, bands.normal, by_area)}",
            f"normal stiffness per area of unloading and vibration {of(middle.unloading, bands.unloading, by_area)}",
        ]
        return "".join(f"{comment} {line}\n" for line in lines)


def _rows(table: Table, of_at: float, of_value: float) -> Rows:
    return [(f"{at / of_at:.9e}", f"{value / of_value:.9g}") for at, value in zip(table.at, table.value)]


def _csv(table: _Table) -> str:
    return "pressure,friction_coefficient\n" + "".join(f"{pressure},{mu}\n" for pressure, mu in table.rows)


def _abaqus(table: _Table) -> str:
    """Data lines of *FRICTION: coefficient, slip rate (left out), contact pressure."""
    stiffness = table.contact.stiffness
    elastic = f", ELASTIC SLIP={stiffness[1].slip / table.metre:.9g}" if stiffness else ""
    rows = "".join(f"{mu}, , {pressure}\n" for pressure, mu in table.rows)
    friction = f"** {table.title}\n{table.stiffness('**')}*FRICTION{elastic}\n{rows}"
    return friction + table.normal() + table.conductance("*GAP CONDUCTANCE, PRESSURE")


# CalculiX keeps the last pressure of a table, and does not converge where a node would need more: a last row goes on as stiff up to so
# many times the pressure.
_CALCULIX_BEYOND = 1e3


def _calculix(table: _Table) -> str:
    """Has one coefficient and one stick slope, those at one pressure. Its conductance knows the pressure of linear overclosure, not
    of a table."""
    assert table.contact.stiffness and table.contact.overclosure
    low, one, high = table.contact.stiffness
    pressure = high.pressure * _CALCULIX_BEYOND
    depth = table.contact.overclosure.table.at[-1] + (pressure - high.pressure) / high.normal
    normal = table.normal(f"{pressure / table.pascal:.9g}, {depth / table.metre:.9e}\n")
    if table.contact.conductance:
        normal = f"*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n{one.normal / table.pascal * table.metre:.9g}\n"
    return (
        f"** {table.title}\n"
        f"** Friction coefficient: {low.friction:.4g} at the lowest pressure, {one.friction:.4g} at {one.pressure / table.pascal:.4g}, "
        f"{high.friction:.4g} at the highest.\n{table.stiffness('**')}{normal}*FRICTION\n"
        f"{one.friction:.9g}, {one.shear / table.pascal * table.metre:.9g}\n{table.conductance('*GAP CONDUCTANCE')}"
    )


def _ansys(table: _Table) -> str:
    """TBFIELD,NPRES sets the pressure of the TBDATA after it; ARG1 is the number of the contact's material, ARG2 that of its real
    constants, of which 3 is FKN and 12 FKT: absolute where negative."""
    lines = [f"! {table.title}"]
    if table.contact.stiffness:
        one, by_area = table.contact.stiffness[1], table.pascal / table.metre
        lines = (lines[0] + "\n" + table.stiffness("!")).splitlines()
        lines += [f"RMODIF,ARG2,{at},{-value / by_area:.9g}" for at, value in ((3, one.unloading), (12, one.shear))]
    lines.append("TB,FRIC,ARG1,,,ISO")
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
    "calculix": _calculix,
    "csv": _csv,
    "lsdyna": _lsdyna,
    "modelica": _modelica,
    "moose": _moose,
}


def written(
    kind: str, table: Table, *, pascal: float, metre: float, name: str, title: str, table_id: int, contact: Contact = Contact()
) -> str:
    """The text of a table, in units of so many pascal and metres."""
    name = name if re.fullmatch(r"[A-Za-z]\w*", name, re.ASCII) else "Friction"
    return FORMATS[kind](_Table(name, " ".join(title.split()), _rows(table, pascal, 1.0), pascal, metre, table_id, contact))
