"""Two surfaces as options of a command: a file, or the dimensionless groups and the keys of surface files."""

from __future__ import annotations

import argparse
import re
from typing import Any

from ._header import WORDS
from ._surface_text import KEYS, REQUIRED, quoted, text_of, without_line
from .errors import Error
from .params import Params
from .units import DIMENSIONS, SI

_GROUPS = {
    "alpha": (0.01, "(sigma/R)^(1/2), surface roughness"),
    "beta": (1000.0, "(R sigma)^(1/2)/b, friction regime"),
    "gamma": (0.001, "w/(E* b), surface energy"),
    "b_over_h": (1.0, "Burgers vector over range of adhesion"),
    "poisson": (0.3, "Poisson's ratio"),
}
# Those that replace the dimensionless groups.
_PHYSICAL = {"pair", *REQUIRED, "summit_density", *KEYS["materials"], *KEYS["roughness"]}
_LITERAL = re.compile(r"true|false|[-+]?(inf|nan|\.?\d.*)")
# What an option is, where that is not a number alone: its unit, or what stands for its words.
_METAVARS = {name: SI[dimension] for name, dimension in DIMENSIONS.items() if dimension in SI and not name.startswith("table_")} | {
    "pair": "PAIR", "interface": "NAME", "calibration_friction_coefficient": "MU", "measured": "N MU ERROR", "coverage": "P", "interface_kind": "KIND",
    "specimens": "COUNT", "first": "BODY", "second": "BODY", "summits": "KIND", "process": "NAME", **dict.fromkeys(WORDS, "WORD"),
}  # fmt: skip
# What may be more than one number.
_SEVERAL = {"measured", "table_height", "table_density", *KEYS["roughness"]} - {"summits", "process"}
_HELP = {
    "pair": "two materials, as steel/steel, or FILE.toml; before all options",
    "nominal_area": "without it loads are pressures",
    "interface": "strength of an interface that is known, as in asperity.materials.INTERFACES",
    "interface_kind": "film (oxide or film, the default), clean (crystals), dry metal, or rock (glass and grains too)",
    "size_effect": "0 of a film to 1 of clean crystals, where it is known",
    "model_error": "how far real interfaces leave the law, over what is usual",
    "measured": "load, friction coefficient and, if known, its relative error; may be given several times",
    "specimens": "on how many it was measured: give it where fewer than 20 asperities touch",
    "coverage": "probability of the band (0.95)",
    "Ra": "mean deviation of the profile; here and below two numbers if both surfaces are rough",
    "Rq": "standard deviation of the profile",
    "RSm": "mean width of its elements",
    "Rdq": "its root mean square slope",
    "Sq": "standard deviation of the heights of a map",
    "Sdq": "root mean square gradient of a map",
    "process": "instead of slopes, or alone: superfinished, lapped, honed, ground, turned, bored or milled",
}


class _PairOrFile(argparse.Action):
    """The first argument: a pair, or a surface file as of --surface, of which there may be one."""

    def __call__(self, parser: argparse.ArgumentParser, namespace: argparse.Namespace, value: Any, option: str | None = None) -> None:
        if option is None and not (value or "").lower().endswith(".toml"):
            namespace.pair = value
        elif namespace.surface is None:
            namespace.surface = value
        else:
            parser.error(f"{value}: the surface is already {namespace.surface}")


def add(command: argparse.ArgumentParser, *, has_groups: bool = True) -> None:
    """Adds the options, with or without the dimensionless groups."""
    command.add_argument(
        "--surface", action=_PairOrFile, metavar="FILE.toml", help="the surfaces as a file (docs/solvers.md), instead of all that follows"
    )
    if has_groups:
        _add_groups(command)
    for table, names in KEYS.items():
        says = f"[{table}] of surface files" if table else "keys of surface files, which docs/solvers.md explains"
        group = command.add_argument_group(says)
        for name in names:
            more: dict[str, Any] = {"nargs": "?", "action": _PairOrFile} if name == "pair" else {"nargs": "+"} if name in _SEVERAL else {}
            if name == "measured":
                more["action"] = "append"
            group.add_argument(_flag(name), metavar=_METAVARS.get(name, "X"), help=_HELP.get(name), **more)


def _add_groups(command: argparse.ArgumentParser) -> None:
    dimensionless = command.add_argument_group("the paper's dimensionless groups: b = G = 1, loads are P/(N G b^2)")
    for name, (default, text) in _GROUPS.items():
        dimensionless.add_argument(_flag(name), type=float, metavar="X", help=f"{text} ({default:g})")


def _flag(name: str) -> str:
    return name if name == "pair" else "--" + name.replace("_", "-")


def params(parser: argparse.ArgumentParser, options: argparse.Namespace) -> Params:
    """The surfaces that the options name; ends the program if they exclude each other."""
    groups = {name: getattr(options, name) for name in _GROUPS if getattr(options, name) is not None}
    given = [name for names in KEYS.values() for name in names if getattr(options, name) is not None]
    if options.surface is not None:
        if beside := [*groups, *given]:
            parser.error(f"--surface is the whole surface: leave out {_flag(beside[0])}, and change the file")
        return Params.from_toml(options.surface)
    physical = [name for name in given if name in _PHYSICAL]
    if groups and physical:
        parser.error(f"{_flag(next(iter(groups)))} is dimensionless, {_flag(physical[0])} physical: choose one")
    start: Any = {name: default for name, (default, _) in _GROUPS.items()} | groups
    try:
        return Params.from_text(text(options), start=None if physical else Params.dimensionless(**start))
    except Error as error:
        raise without_line(error) from None


def text(options: argparse.Namespace) -> str:
    """What the options give, as a surface file has it."""
    names = (name for names in KEYS.values() for name in names if getattr(options, name) is not None)
    return text_of((name, _literal(getattr(options, name))) for name in names)


def _literal(given: Any) -> str:
    """As TOML has it: words in quotation marks, several values in brackets."""
    if isinstance(given, str):
        return given if _LITERAL.fullmatch(given) else quoted(given)
    values = [_literal(one) for one in given]
    return values[0] if len(values) == 1 else f"[{', '.join(values)}]"
