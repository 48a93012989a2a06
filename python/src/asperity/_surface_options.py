"""Two surfaces as options of a command: a file, or the dimensionless groups and the keys of surface files."""

from __future__ import annotations

import argparse
import re
from typing import Any

from .errors import Error
from .params import Params
from ._surface_text import KEYS, REQUIRED, quoted, text_of, without_line

_GROUPS = {
    "alpha": (0.01, "(sigma/R)^(1/2), surface roughness"),
    "beta": (1000.0, "(R sigma)^(1/2)/b, friction regime"),
    "gamma": (0.001, "w/(E* b), surface energy"),
    "b_over_h": (1.0, "Burgers vector over range of adhesion"),
    "poisson": (0.3, "Poisson's ratio"),
}
# Those that replace the dimensionless groups.
_PHYSICAL = {"pair", *REQUIRED, "summit_density", *KEYS["materials"], *KEYS["roughness"]}
_LITERAL = re.compile(r"true|false|[-+]?(inf|nan|\.?\d.*)|\[.*")


def add(command: argparse.ArgumentParser, *, has_groups: bool = True) -> None:
    """Adds the options, with or without the dimensionless groups."""
    command.add_argument(
        "--surface", metavar="FILE.toml", help="the surfaces as a file (docs/solvers.md), instead of all that follows"
    )
    if has_groups:
        _add_groups(command)
    for table, names in KEYS.items():
        says = f"[{table}] of surface files" if table else "keys of surface files, which docs/solvers.md explains"
        group = command.add_argument_group(says)
        for name in names:
            group.add_argument(_flag(name), metavar="X")


def _add_groups(command: argparse.ArgumentParser) -> None:
    dimensionless = command.add_argument_group("the paper's dimensionless groups: b = G = 1, loads are P/(N G b^2)")
    for name, (default, text) in _GROUPS.items():
        dimensionless.add_argument(_flag(name), type=float, metavar="X", help=f"{text} ({default:g})")


def _flag(name: str) -> str:
    return "--" + name.replace("_", "-")


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


def _literal(text: str) -> str:
    """As TOML has it: words in quotation marks."""
    return text if _LITERAL.fullmatch(text) else quoted(text)
