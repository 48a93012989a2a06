"""`python -m asperity fmu`: a surface as a functional mock-up unit."""

from __future__ import annotations

import argparse
import math
import sys
from pathlib import Path
from typing import Any

from ..model import Model
from ..params import Params
from .fmu import build
from .fmu_binaries import PLATFORMS, native


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "fmu",
        help="write a functional mock-up unit (FMI 2.0 or 3.0)",
        description="Writes a unit for model exchange and co-simulation: input load, outputs friction_force, "
        "friction_coefficient and slope, tunable parameters. Needs a C compiler for each platform.",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("surface", metavar="SURFACE.toml", help="the surface")
    command.add_argument("-o", "--output", required=True, type=Path, metavar="NAME.fmu", help="where to")
    command.add_argument("--fmi", choices=["2.0", "3.0"], default="2.0", help="version of the standard (%(default)s)")
    command.add_argument(
        "--platform", metavar="NAMES", help="of linux64 and win64, with a comma between: systems to run on (that of this machine)"
    )
    command.add_argument(
        "--library", action="append", default=[], metavar="NAME=FILE",
        help="for another platform than this machine's: its library, or a wheel or zip with it; may be given again",
    )  # fmt: skip
    command.add_argument(
        "--microslip", action="store_true",
        help="what resists before gross slip, too: input displacement, outputs tangential_force and tangential_stiffness",
    )  # fmt: skip
    command.add_argument("--load", type=float, default=1.0, metavar="P", help="start value of the load (%(default)g)")


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.output.suffix != ".fmu":
        parser.error(f"--output {options.output}: must end in .fmu")
    if not math.isfinite(options.load):
        parser.error(f"--load {options.load:g}: must be finite")
    platforms, libraries = _platforms(parser, options.platform), _libraries(parser, options.library)
    for name in libraries:
        if name not in platforms:
            parser.error(f"--library {name}=...: the unit is not for {name}; add it to --platform")
    params = Params.from_toml(options.surface)
    build(
        params, options.output, fmi=options.fmi, start_load=options.load, platforms=platforms, libraries=libraries,
        microslip=options.microslip,
    )  # fmt: skip
    print(f"asperity: wrote {options.output}", file=sys.stderr)
    if options.load > 0:
        with Model(params) as model:
            for kind in model.check(options.load, options.load).kinds:
                print(f"asperity: at a load of {options.load:g}: {kind}", file=sys.stderr)


def _platforms(parser: argparse.ArgumentParser, names: str | None) -> list[str]:
    if names is None:
        own = native()
        if own is None:
            parser.error(f"this machine is none of {' and '.join(PLATFORMS)}: say with --platform which the unit is for")
        return [own]
    platforms = names.split(",")
    for name in platforms:
        if name not in PLATFORMS:
            parser.error(f"--platform {names}: {name!r} is none of {' and '.join(PLATFORMS)}")
    return list(dict.fromkeys(platforms))


def _libraries(parser: argparse.ArgumentParser, given: list[str]) -> dict[str, Path]:
    libraries = {}
    for text in given:
        name, equals, file = text.partition("=")
        if name not in PLATFORMS or not (equals and file):
            parser.error(f"--library {text}: must be {' or '.join(f'{known}=FILE' for known in PLATFORMS)}")
        if not Path(file).is_file():
            parser.error(f"--library {text}: there is no such file")
        libraries[name] = Path(file)
    return libraries
