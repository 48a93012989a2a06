"""`python -m asperity friction`: friction at loads from a surface file, with its band, as the library writes it."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from . import _surface_options
from ._surface_text import without_line
from .errors import Error
from .estimate import Estimate, estimate


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "friction",
        help="print friction at loads with its band, from what is known of a surface",
        description="Prints the friction coefficient at each load with its band, what the numbers rest on, and what would narrow "
        "the band. SI units.",
        epilog='For example: asperity friction "steel/steel" --Ra 0.8e-6 --process ground --measured 1000 0.16 --load 10 100 1000',
        usage="%(prog)s [PAIR | FILE.toml] --load N [N ...] [OPTION VALUE ...]",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("--load", type=float, nargs="+", required=True, metavar="N", help="normal loads")
    command.add_argument("--figure", metavar="FILE", help="file to draw friction in; its ending is its format")
    _surface_options.add(command, has_groups=False)


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    text = _surface_options.text(options)
    if options.surface is None:
        try:
            _tell(estimate(text, options.load), options.figure)
        except Error as error:
            raise without_line(error) from None
        return
    if text:
        parser.error("--surface is the whole surface: leave out the other options, and change the file")
    try:
        found = estimate(Path(options.surface).read_text(encoding="utf-8-sig"), options.load)
    except Error as error:
        raise Error(f"{options.surface}: {error}", error.status) from None
    _tell(found, options.figure)


def _tell(found: Estimate, figure: str | None) -> None:
    print(found.text)
    if figure is not None:
        found.plot(figure)
