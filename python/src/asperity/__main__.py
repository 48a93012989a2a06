"""The command line: `python -m asperity friction` prints friction at loads with its band, `curve` prints friction over a range of
loads and draws the curve, `fit` finds parameters from measured friction, `study` computes friction of thousands of surfaces,
`export` and `fmu` write tables and mock-up units for hosts.

Exit status: 0; 1 if the library, a file or a missing package stands in the way; 2 for a wrong command line.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
import warnings

import numpy as np

from . import Model, Params, __version__, _friction_command, _header, _library, _surface_options, units
from .fits import fit_command
from .hosts import export_command, fmu_command
from .studies import study_command
from .tools.band_figure import drawn
from .tools.style import style


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="asperity", description="Friction laws from contact physics.")
    version = f"asperity {__version__} (library {_library.version()}, ABI {_header.ASPERITY_ABI_VERSION})"
    parser.add_argument("--version", action="version", version=version)
    commands = parser.add_subparsers(dest="command", metavar="COMMAND", required=True)
    curve = commands.add_parser(
        "curve",
        help="print friction over a range of loads and draw the curve",
        description="Prints one line for each load: load, friction coefficient, friction force, real area, contacting "
        "summits; and draws the friction coefficient over the load.",
        epilog="Without any parameter: the paper's case, alpha = 0.01, beta = 1000, gamma = 0.001.",
        allow_abbrev=False,
    )
    _surface_options.add(curve)
    _add_loads(curve)
    curve.set_defaults(run=_curve)
    _friction_command.add(commands)
    fit_command.add(commands)
    study_command.add(commands)
    export_command.add(commands)
    fmu_command.add(commands)
    return parser


def _add_loads(curve: argparse.ArgumentParser) -> None:
    loads = curve.add_argument_group("loads, evenly spaced in the logarithm, and the figure")
    loads.add_argument("--lowest", type=float, metavar="P", help="lowest load [force] > 0 (1e-4 N E* b^2)")
    loads.add_argument("--highest", type=float, metavar="P", help="highest load [force] (1e2 N E* b^2)")
    loads.add_argument("--count", type=int, default=33, metavar="K", help="number of loads, 2 or more (33)")
    loads.add_argument(
        "--figure",
        default="friction_curve.svg",
        metavar="FILE",
        help="file to draw in, its ending is its format; '-' for none (%(default)s)",
    )


def _loads(parser: argparse.ArgumentParser, options: argparse.Namespace, params: Params) -> list[float]:
    unit = params.asperity_count * params.composite_modulus * params.burgers_vector**2
    lowest = 1e-4 * unit if options.lowest is None else options.lowest
    highest = 1e2 * unit if options.highest is None else options.highest
    if options.count < 2:
        parser.error(f"--count {options.count}: must be 2 or more")
    if not (math.isfinite(lowest) and lowest > 0):
        parser.error(f"--lowest {lowest:g}: must be finite and > 0, the loads are spaced in the logarithm")
    if not (math.isfinite(highest) and highest > lowest):
        parser.error(f"--highest {highest:g}: must be finite and above the lowest load, {lowest:g}")
    steps = options.count - 1
    return [math.exp(math.log(lowest) + i / steps * (math.log(highest) - math.log(lowest))) for i in range(steps + 1)]


def _print_table(model: Model, loads: list[float]) -> list[float]:
    """Prints friction by the compiled law, area and contacts by the exact one; returns the friction coefficients."""
    coefficients = [model.friction_at_load(load) for load in loads]
    print("# load, friction coefficient, friction force, real area, contacts")
    for load, mu in zip(loads, coefficients):
        state = model.state_at_load(load)
        force = model.friction_force_at_load(load)
        print(f"{load:.9e} {mu:.9e} {force:.9e} {state.real_area:.9e} {state.contacting:.9e}")
    sys.stdout.flush()
    return coefficients


def _require_matplotlib() -> None:
    try:
        with style():
            pass
    except ImportError as error:
        raise ImportError(f"{error}, or give '--figure -' for the table alone") from None


def _curve(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.figure != "-":
        _require_matplotlib()
    params = _surface_options.params(parser, options)
    loads = _loads(parser, options, params)
    with Model(params) as model:
        coefficients = _print_table(model, loads)
        model.warn(loads[0], loads[-1])
    if options.figure != "-":
        drawn(options.figure, None, units.unit("force", params.in_si), np.array(loads), np.array(coefficients), None, None, "")
        print(f"asperity: the curve is drawn in {options.figure}", file=sys.stderr)


def main(arguments: list[str] | None = None) -> int:
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        with warnings.catch_warnings():
            warnings.showwarning = lambda message, *_: print(f"asperity: warning: {message}", file=sys.stderr)
            options.run(parser, options)
    except BrokenPipeError:
        # The reader of the output has seen enough; what is still buffered must not fail at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except (ImportError, OSError, ValueError) as error:
        said = f"{error.filename}: {error.strerror}" if isinstance(error, OSError) and error.filename is not None else error
        print(f"asperity: {said}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
