"""The command line: `python -m asperity curve` prints friction over a range of loads and draws the curve.

Exit status: 0; 1 if the library, a file or a missing package stands in the way; 2 for a wrong command line.
"""

from __future__ import annotations

import argparse
import math
import os
import sys
from dataclasses import MISSING, fields
from typing import Any

from . import Model, Params, __version__, _header, _library

_GROUPS = {
    "alpha": (0.01, "(sigma/R)^(1/2), surface roughness"),
    "beta": (1000.0, "(R sigma)^(1/2)/b, friction regime"),
    "gamma": (0.001, "w/(E* b), surface energy"),
    "b_over_h": (1.0, "Burgers vector over range of adhesion"),
    "poisson": (0.3, "Poisson's ratio"),
}
_PHYSICAL = {
    "E1": "Young's modulus of the first body [stress]",
    "nu1": "its Poisson's ratio",
    "E2": "Young's modulus of the second body [stress]",
    "nu2": "its Poisson's ratio",
    "composite_modulus": "E* [stress], instead of two bodies",
    "effective_shear_modulus": "G* [stress], instead of two bodies",
    "work_of_adhesion": "w [force/length]",
    "adhesion_range": "h [length]",
    "burgers_vector": "b [length]",
    "height_std": "sigma [length]",
    "summit_radius": "R [length]",
    "summit_density": "summits per area [1/length^2]",
    "nominal_area": "[length^2]",
    "asperity_count": "N, instead of density and area",
}
_REQUIRED = ("work_of_adhesion", "adhesion_range", "burgers_vector", "height_std", "summit_radius")
_OPTIONS = {
    "skew": "Weibull heights of this skew; with a kurtosis, Johnson's",
    "kurtosis": "Johnson's heights of this kurtosis",
    "weibull_shape": "Weibull heights of this shape, instead of a skew",
    "radius_amplitude": "epsilon: growth of the radius with height, -1 to 1",
    "radius_rate": "rho: how fast it grows",
    "slip_radius_1": "a_1/b: shear strength is slip_stress_1 up to it",
    "slip_stress_1": "tau_1/G*",
    "slip_radius_2": "a_2/b: shear strength is slip_stress_2 from it on",
    "slip_stress_2": "tau_2/G*",
    "max_friction_coefficient": "cap on the friction coefficient",
}
# Options that choose the heights: their defaults are those of heights not chosen.
_CHOOSING = ("skew", "kurtosis")


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
    _add_options(curve)
    return parser


def _add_options(curve: argparse.ArgumentParser) -> None:
    dimensionless = curve.add_argument_group("the paper's dimensionless groups: b = G = 1, loads are P/(N G b^2)")
    for name, (default, text) in _GROUPS.items():
        dimensionless.add_argument(_flag(name), type=float, metavar="X", help=f"{text} ({default:g})")
    physical = curve.add_argument_group("or physical parameters, all in one consistent system of units")
    for name, text in _PHYSICAL.items():
        physical.add_argument(_flag(name), type=float, metavar="X", help=text)
    optional = curve.add_argument_group("and, with either")
    defaults = {field.name: field.default for field in fields(Params) if field.default is not MISSING}
    for name, text in _OPTIONS.items():
        shown = f" ({defaults[name]:g})" if name in defaults and name not in _CHOOSING else ""
        optional.add_argument(_flag(name), type=float, metavar="X", help=text + shown)
    optional.add_argument("--no-attraction", action="store_true", help="summits out of contact do not attract")
    loads = curve.add_argument_group("loads, evenly spaced in the logarithm, and the figure")
    loads.add_argument("--lowest", type=float, metavar="P", help="lowest load [force] > 0 (1e-4 N E* b^2)")
    loads.add_argument("--highest", type=float, metavar="P", help="highest load [force] (1e4 N E* b^2)")
    loads.add_argument("--count", type=int, default=33, metavar="K", help="number of loads, 2 or more (33)")
    loads.add_argument(
        "--figure",
        default="friction_curve.svg",
        metavar="FILE",
        help="file to draw in, its ending is its format; '-' for none (%(default)s)",
    )


def _flag(name: str) -> str:
    return "--" + name.replace("_", "-")


def _given(options: argparse.Namespace, names: Any) -> dict[str, Any]:
    return {name: getattr(options, name) for name in names if getattr(options, name) is not None}


def _params(parser: argparse.ArgumentParser, options: argparse.Namespace) -> Params:
    groups, physical = _given(options, _GROUPS), _given(options, _PHYSICAL)
    others = _given(options, _OPTIONS)
    others["attraction"] = not options.no_attraction
    if groups and physical:
        one, other = _flag(next(iter(groups))), _flag(next(iter(physical)))
        parser.error(f"{one} is dimensionless, {other} physical: choose one")
    if physical:
        missing = [_flag(name) for name in _REQUIRED if name not in physical]
        if missing:
            parser.error(f"physical parameters need {', '.join(missing)} too")
    try:
        if physical:
            return Params.si(**physical, **others)
        return Params.dimensionless(**({name: default for name, (default, _) in _GROUPS.items()} | groups | others))
    except TypeError as error:
        parser.error(str(error))


def _loads(parser: argparse.ArgumentParser, options: argparse.Namespace, params: Params) -> list[float]:
    unit = params.asperity_count * params.composite_modulus * params.burgers_vector**2
    lowest = 1e-4 * unit if options.lowest is None else options.lowest
    highest = 1e4 * unit if options.highest is None else options.highest
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
    print("# load, friction coefficient, friction force, real area, contacting summits")
    for load, mu in zip(loads, coefficients):
        state = model.state_at_load(load)
        force = model.friction_force_at_load(load)
        print(f"{load:.9e} {mu:.9e} {force:.9e} {state.real_area:.9e} {state.contacting:.9e}")
    sys.stdout.flush()
    return coefficients


def _draw(file: str, loads: list[float], coefficients: list[float]) -> None:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.5, 5), layout="constrained")
    axes = figure.add_subplot()
    axes.semilogx(loads, coefficients)
    axes.set(xlabel="normal load $P$ [force, in the units of the parameters]", ylabel="friction coefficient $F/P$")
    axes.set_ylim(bottom=0)
    axes.grid(True, alpha=0.3)
    figure.savefig(file)
    print(f"asperity: the curve is drawn in {file}", file=sys.stderr)


def _require_matplotlib() -> None:
    try:
        import matplotlib.figure  # noqa: F401
    except ImportError as error:
        raise ImportError(
            f"drawing needs matplotlib ({error}): pip install matplotlib, or give '--figure -' for the table alone"
        ) from None


def _curve(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    if options.figure != "-":
        _require_matplotlib()
    params = _params(parser, options)
    loads = _loads(parser, options, params)
    with Model(params) as model:
        coefficients = _print_table(model, loads)
    if options.figure != "-":
        _draw(options.figure, loads, coefficients)


def main(arguments: list[str] | None = None) -> int:
    parser = _parser()
    options = parser.parse_args(arguments)
    try:
        _curve(parser, options)
    except BrokenPipeError:
        # The reader of the table has seen enough; what is still buffered must not fail at exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except (ImportError, OSError, ValueError) as error:
        print(f"asperity: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
