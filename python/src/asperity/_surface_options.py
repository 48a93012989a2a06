"""Two surfaces as options of a command: a file, or the dimensionless groups or physical parameters and what goes with either."""

from __future__ import annotations

import argparse
from dataclasses import MISSING, fields
from typing import Any

from ._surface_file import CALIBRATION, calibrated, with_interface
from .params import Params

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
    "pressure_coefficient": "kappa: the part of the strength that grows with pressure",
    "bandwidth": "Nayak's m0 m4/m2^2, by which warnings judge; 0 where it is not known",
    "max_friction_coefficient": "cap on the friction coefficient",
}
_MEASURED = (
    "normal load of a measurement, at which the strength of the interface is set so that friction is the one measured",
    "friction coefficient measured at it",
    "friction force measured at it, instead of the coefficient",
)
# Options that choose the heights: their defaults are those of heights not chosen.
_CHOOSING = ("skew", "kurtosis")


def add(command: argparse.ArgumentParser) -> None:
    """Adds the options."""
    command.add_argument(
        "--surface", metavar="FILE.toml", help="the surfaces as a file (docs/surface-file.md), instead of all that follows"
    )
    dimensionless = command.add_argument_group("the paper's dimensionless groups: b = G = 1, loads are P/(N G b^2)")
    for name, (default, text) in _GROUPS.items():
        dimensionless.add_argument(_flag(name), type=float, metavar="X", help=f"{text} ({default:g})")
    physical = command.add_argument_group("or physical parameters, all in one consistent system of units")
    for name, text in _PHYSICAL.items():
        physical.add_argument(_flag(name), type=float, metavar="X", help=text)
    optional = command.add_argument_group("and, with either")
    defaults = {field.name: field.default for field in fields(Params) if field.default is not MISSING}
    for name, text in _OPTIONS.items():
        shown = f" ({defaults[name]:g})" if name in defaults and name not in _CHOOSING else ""
        optional.add_argument(_flag(name), type=float, metavar="X", help=text + shown)
    optional.add_argument("--interface", metavar="NAME", help="strength of an interface of docs/materials.md; SI units")
    for name, text in zip(CALIBRATION, _MEASURED):
        optional.add_argument(_flag(name), type=float, metavar="X", help=text)
    optional.add_argument("--no-attraction", action="store_true", help="summits out of contact do not attract")


def _flag(name: str) -> str:
    return "--" + name.replace("_", "-")


def _given(options: argparse.Namespace, names: Any) -> dict[str, Any]:
    return {name: getattr(options, name) for name in names if getattr(options, name) is not None}


def params(parser: argparse.ArgumentParser, options: argparse.Namespace) -> Params:
    """The surfaces that the options name; ends the program if they exclude each other."""
    groups, physical = _given(options, _GROUPS), _given(options, _PHYSICAL)
    others, measured = _given(options, _OPTIONS), _given(options, CALIBRATION)
    if options.surface is not None:
        named = [name for name in ("interface", "no_attraction") if getattr(options, name)]
        if beside := [*groups, *physical, *others, *measured, *named]:
            parser.error(f"--surface is the whole surface: leave out {_flag(beside[0])}, and change the file")
        return Params.from_toml(options.surface)
    others["attraction"] = not options.no_attraction
    if groups and physical:
        one, other = _flag(next(iter(groups))), _flag(next(iter(physical)))
        parser.error(f"{one} is dimensionless, {other} physical: choose one")
    if physical:
        missing = [_flag(name) for name in _REQUIRED if name not in physical]
        if missing:
            parser.error(f"physical parameters need {', '.join(missing)} too")
    try:
        values = {name: default for name, (default, _) in _GROUPS.items()} | groups | others
        made = Params.si(**physical, **others) if physical else Params.dimensionless(**values)
        return calibrated(with_interface(made, options.interface, others), measured)  # type: ignore[no-any-return]
    except TypeError as error:
        parser.error(str(error))
