"""`python -m asperity fmu`: a surface as a functional mock-up unit."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any

from ._fmu import build
from .params import Params


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "fmu",
        help="write a functional mock-up unit (FMI 2.0)",
        description="Writes a unit for model exchange and co-simulation: input load, outputs friction_force, "
        "friction_coefficient and slope, tunable parameters. Needs Linux on x86-64 and a C compiler.",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("surface", metavar="SURFACE.toml", help="the surface")
    command.add_argument("-o", "--output", required=True, type=Path, metavar="NAME.fmu", help="where to")
    command.add_argument("--load", type=float, default=1.0, metavar="P", help="start value of the load (%(default)g)")


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.output.suffix != ".fmu":
        parser.error(f"--output {options.output}: must end in .fmu")
    if not math.isfinite(options.load):
        parser.error(f"--load {options.load:g}: must be finite")
    build(Params.from_toml(options.surface), options.output, start_load=options.load)
    print(f"asperity: wrote {options.output}", file=sys.stderr)
