"""`python -m asperity fit`: parameters from a file of measured friction."""

from __future__ import annotations

import argparse
import sys
from typing import Any

import numpy as np

from .. import _surface_options
from ..errors import Error
from .fit import fit


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "fit",
        help="find parameters from measured friction",
        description="Reads measurements, one line for each: load, friction coefficient and, optionally, its standard "
        "error, separated by spaces or commas; # begins a comment. Prints one line for each free name: name, value, "
        "standard error. Then it says what the data do not determine.",
        epilog="The other parameters are where the search starts. Without any: the paper's case, alpha = 0.01, beta = "
        "1000, gamma = 0.001. The free names are those of asperity.fit_names.",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("file", metavar="FILE", help="the measurements; '-' for standard input")
    command.add_argument("--free", required=True, metavar="NAME,...", help="names of the parameters to find")
    command.add_argument(
        "--bounds",
        nargs=3,
        action="append",
        default=[],
        metavar=("NAME", "LOW", "HIGH"),
        help="lowest and highest value of a free name; may be repeated",
    )
    command.add_argument("--force", action="store_true", help="the second column is the friction force, not F/P")
    command.add_argument("--figure", metavar="FILE", help="file to draw data, fit and residuals in")
    _surface_options.add(command)


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Fits, prints and draws."""
    params = _surface_options.params(parser, options)
    try:
        bounds = {name: (float(low), float(high)) for name, low, high in options.bounds}
    except ValueError as error:
        parser.error(f"--bounds: {error}")
    load, friction, sigma = _read(options.file)
    mu, force = (None, friction) if options.force else (friction, None)
    found = fit(load, mu, sigma, options.free.split(","), params=params, force=force, bounds=bounds)
    if options.figure is not None:
        found.plot(options.figure)
    print("# name, value, standard error")
    for name in found.free:
        print(f"{name} {found.values[name]:.9e} {found.errors[name]:.3e}")
    for line in found.message.splitlines():
        print(f"# {line}")


def _read(file: str) -> tuple[Any, Any, Any]:
    """Loads, friction, and its standard errors or None."""
    rows: list[list[float]] = []
    with sys.stdin if file == "-" else open(file, encoding="utf-8") as lines:
        for number, line in enumerate(lines, 1):
            if not (words := line.partition("#")[0].replace(",", " ").split()):
                continue
            try:
                rows.append([float(word) for word in words])
            except ValueError as error:
                raise Error(f"{file}, line {number}: {error}; # makes a heading a comment") from None
    counts = {len(row) for row in rows}
    if counts not in ({2}, {3}):
        found = " or ".join(map(str, sorted(counts))) or "none"
        raise Error(f"{file}: must have 2 or 3 columns, load, friction and its standard error; it has {found}")
    columns = np.array(rows).T
    return columns[0], columns[1], columns[2] if len(columns) == 3 else None
