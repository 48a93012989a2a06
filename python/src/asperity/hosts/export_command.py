"""`python -m asperity export`: friction against pressure for hosts that read a table."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any, Optional

import numpy as np

from .. import _header
from ..estimate import estimate
from ..model import Model
from ..params import Params
from ..tools import output
from .export_formats import FORMATS, Contact, written
from .pressure_table import (
    Bands,
    Stiffness,
    Table,
    conductance_at_pressure,
    friction_at_pressure,
    overclosure_table,
    pressure_table,
    stiffness_at_pressure,
    unloaded_from,
)

# Far from the small numbers that a model uses, and short enough that all IDs have five digits, which older LS-DYNA allow.
_TABLE_ID = 90000


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "export",
        help="write friction against pressure for a host that reads a table",
        description="Writes friction coefficients against pressure in the language of a host. Rows are chosen so that "
        "straight lines between them keep to a relative tolerance.",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("surface", metavar="SURFACE.toml", help="the surface, with its nominal_area")
    command.add_argument("--format", required=True, choices=sorted(FORMATS), help="language of the host")
    command.add_argument("--range", required=True, metavar="LOW:HIGH", help="lowest and highest pressure, in units of --pressure-unit")
    command.add_argument(
        "--friction-at",
        type=float,
        metavar="P",
        help="pressure of the one friction coefficient of calculix, as --range; without it the geometric mean of the range",
    )
    command.add_argument("--tolerance", type=float, default=1e-3, metavar="X", help="1e-6 to 0.1 (%(default)g)")
    command.add_argument(
        "--pressure-unit", type=float, default=1.0, metavar="PA", help="unit of the table in Pa: 1e6 for MPa (%(default)g)"
    )
    command.add_argument(
        "--length-unit", type=float, default=1.0, metavar="M", help="unit of lengths in m: 1e-3 for mm (%(default)g)"
    )
    command.add_argument(
        "--stiffness",
        action="store_true",
        help="also elastic slip and stiffness per area, with bands: abaqus (and pressure against overclosure), ansys; calculix always",
    )
    command.add_argument(
        "--unloaded-from",
        type=float,
        metavar="P",
        help="largest pressure that the contact has borne, in units of --pressure-unit: the tables are those of a joint that was tightened",
    )
    command.add_argument(
        "--conductivity",
        metavar="K[:K]",
        help="also gap conductance, between bodies of this conductivity [W/(m K)], or of these two: abaqus, calculix",
    )
    command.add_argument(
        "--table-id", type=int, metavar="ID", help=f"ID of the table for lsdyna; its curves take the next ones ({_TABLE_ID})"
    )
    command.add_argument("-o", "--output", metavar="FILE", help="where to (standard output)")


def _bands(surface: str, middle: Stiffness, load: float) -> Bands:
    """The bands of an estimate about the values of the model; that of F/K_t has friction and stiffness as independent."""
    found = estimate(Path(surface).read_text(encoding="utf-8-sig"), load)
    below, above = (0.0, 0.0) if found.low is None else (math.log(found.value / found.low), math.log(found.high / found.value))
    low = math.hypot(below, math.log(found.stiffness.high / found.stiffness.value))
    high = math.hypot(above, math.log(found.stiffness.value / found.stiffness.low))
    slip = (middle.slip * math.exp(-low), middle.slip * math.exp(high))
    shear, normal, unloading = (
        (value * band.low / band.value, value * band.high / band.value)
        for value, band in (
            (middle.shear, found.stiffness),
            (middle.normal, found.normal_stiffness),
            (middle.unloading, found.unloading_stiffness),
        )
    )
    return Bands(slip, shear, normal, unloading)


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if not 1e-6 <= options.tolerance <= 0.1:
        parser.error(f"--tolerance {options.tolerance:g}: must be 1e-6 to 0.1")
    for name in ("pressure_unit", "length_unit"):
        unit = getattr(options, name)
        if not (math.isfinite(unit) and unit > 0):
            parser.error(f"--{name.replace('_', '-')} {unit:g}: must be finite and > 0")
    unit = options.pressure_unit
    lowest, highest = (unit * end for end in _range(parser, options.range))
    conductivity = _conductivity(parser, options.conductivity)
    for name, given, formats in (
        ("stiffness", options.stiffness, ("abaqus", "ansys", "calculix")),
        ("conductivity", conductivity, ("abaqus", "calculix")),
    ):
        if given and options.format not in formats:
            parser.error(f"--{name}: only --format {', '.join(formats[:-1])} and {formats[-1]} have it")
    if options.friction_at is not None and options.format != "calculix":
        parser.error(f"--friction-at {options.friction_at:g}: only --format calculix has one coefficient for all pressures")
    largest = 0.0 if options.unloaded_from is None else unit * options.unloaded_from
    if options.unloaded_from is not None and not highest <= largest < math.inf:
        parser.error(f"--unloaded-from {options.unloaded_from:g}: must not be below the highest pressure of --range {options.range}")
    middle = math.sqrt(lowest * highest) if options.friction_at is None else unit * options.friction_at
    if not lowest <= middle <= highest:
        parser.error(f"--friction-at {options.friction_at:g}: must be a pressure of --range {options.range}")
    if options.table_id is not None and options.format != "lsdyna":
        parser.error(f"--table-id {options.table_id}: only --format lsdyna has IDs")
    table_id = _TABLE_ID if options.table_id is None else options.table_id
    if not 1 <= table_id <= 99_999_999:
        parser.error(f"--table-id {table_id}: must be 1 to 99999999")
    with unloaded_from(Model(Params.from_toml(options.surface)), largest) as model:
        if not highest < model.params.composite_modulus:
            parser.error(
                f"--range {options.range}: {highest:.4g} Pa is more than the modulus of the bodies; it is in units of --pressure-unit, "
                f"{unit:g} Pa"
            )
        table = pressure_table(friction_at_pressure(model), lowest, highest, options.tolerance)
        contact = Contact()
        if options.stiffness or options.format == "calculix":
            at = [stiffness_at_pressure(model, pressure) for pressure in (lowest, middle, highest)]
            bands = _bands(options.surface, at[1], middle * model.params.nominal_area)
            contact = Contact((at[0], at[1], at[2]), bands, overclosure_table(model, lowest, highest, options.tolerance))
        if conductivity:
            law = conductance_at_pressure(model, conductivity)
            rows = pressure_table(law, lowest, highest, options.tolerance)
            # Hosts begin at no pressure.
            rows = Table(np.append(0.0, rows.at), np.append(law(np.zeros(1)), rows.value), rows.error)
            contact = contact._replace(conductance=rows)
        area = model.params.nominal_area
        warnings = model.check(lowest * area, highest * area)
    name = Path(options.output).stem if options.output else "Friction"
    lengths = f", lengths in {options.length_unit:g} m" if contact != Contact() else ""
    title = (
        f"Friction coefficient of {Path(options.surface).name} against pressure in "
        f"{'Pa' if unit == 1 else f'{unit:g} Pa'}{f', unloaded from {options.unloaded_from:g}' if largest else ''}{lengths}, asperity {_header.ASPERITY_VERSION}, tolerance {options.tolerance:g}"
    )
    text = written(
        options.format,
        table,
        pascal=unit,
        metre=options.length_unit,
        name=name,
        title=title,
        table_id=table_id,
        contact=contact,
    )
    if options.output:
        output.write(options.output, text)
    else:
        sys.stdout.write(text)
        sys.stdout.flush()
    between = f"from {lowest:g} to {highest:g} Pa"
    if options.format == "calculix":
        assert contact.stiffness and contact.overclosure
        rows, off = contact.overclosure.table, max(abs(contact.stiffness[1].friction / table.value - 1))
        print(
            f"asperity: {len(rows.at)} rows of overclosure {between}, largest error between them {rows.error:.1e}; one friction "
            f"coefficient, {contact.stiffness[1].friction:.4g} of {middle:g} Pa, up to {off:.1%} off at the other pressures",
            file=sys.stderr,
        )
    else:
        print(f"asperity: {len(table.at)} rows {between}, largest error between them {table.error:.1e}", file=sys.stderr)
    for kind in warnings.kinds:
        print(f"asperity: between {lowest:g} and {highest:g} Pa: {kind}", file=sys.stderr)


def _conductivity(parser: argparse.ArgumentParser, text: Optional[str]) -> Optional[float]:
    """The harmonic mean of both bodies."""
    if text is None:
        return None
    try:
        bodies = list(map(float, text.split(":")))
    except ValueError:
        bodies = []
    if not (len(bodies) in (1, 2) and all(0 < body < math.inf for body in bodies)):
        parser.error(f"--conductivity {text}: must be one or two numbers > 0 in W/(m K), as 16.2 or 16.2:390")
    return len(bodies) / sum(1 / body for body in bodies)


def _range(parser: argparse.ArgumentParser, text: str) -> tuple[float, float]:
    try:
        lowest, highest = map(float, text.split(":"))
    except ValueError:
        parser.error(f"--range {text}: must be two pressures, as 0.1e6:1e9")
    if not (0 < lowest < highest < math.inf):
        parser.error(f"--range {text}: must be two pressures > 0, the lower first, as 0.1e6:1e9")
    return lowest, highest
