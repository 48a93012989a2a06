"""A study as a TOML file: a surface file with the tables [vary], [loads] and [study]. It names no files: what is written, and
where, is said on the command line."""

from __future__ import annotations

import math
import os
import re
import sys
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from ..errors import Error, instead
from ..params import Params
from ..tools.checks import short
from .draws import SAMPLINGS

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

# How a table begins, and whether it is one of a study.
_HEADER = re.compile(r"[ \t]*\[[ \t]*(?:(vary|loads|study)(?=[ \t.\]])|[A-Za-z\"'\[])")
# No study needs more; a device such as /dev/zero has no end.
_LONGEST = 1 << 20
_LOADS = ("values", "lowest", "highest", "count")
_STUDY = ("samples", "seed", "sampling", "warnings", "block")
# A grid of more loads says no more, and would not fit in memory with more than a few surfaces.
_MOST_LOADS = 100_000


class StudyFile(NamedTuple):
    """What a file says, as arguments of `study`."""

    params: Params
    vary: dict[str, Any]
    loads: npt.NDArray[np.float64]
    options: dict[str, Any]


def read(file: str | os.PathLike[str]) -> StudyFile:
    """The study that a file describes; `Error` names the file, the key and what is allowed."""
    try:
        return _study(_text(file))
    except tomllib.TOMLDecodeError as error:
        raise Error(f"{file}: no TOML: {error}") from None
    except UnicodeDecodeError as error:
        raise Error(f"{file}: must be UTF-8: {error}") from None
    except RecursionError:
        raise Error(f"{file}: must not have arrays or tables so deep inside each other") from None
    except Error as error:
        raise Error(f"{file}: {error}", error.status) from None
    except (TypeError, ValueError, OverflowError) as error:
        raise Error(f"{file}: {error.args[0]}") from None


def _text(file: str | os.PathLike[str]) -> str:
    with open(file, "rb") as stream:
        text = stream.read(_LONGEST + 1)
    if len(text) > _LONGEST:
        raise Error("longer than 1 MiB: must be a study, whose keys docs/studies.md has")
    return text.decode("utf-8-sig").replace("\r\n", "\n")


def _study(text: str) -> StudyFile:
    surface, own = _parted(text)
    found = tomllib.loads(own)
    parts = {name: _table(found, name) for name in ("vary", "loads", "study")}
    vary = {name: _varied(name, value) for name, value in parts["vary"].items()}
    if not vary:
        raise Error("[vary]: must have one parameter or more, as height_std = 0.1")
    return StudyFile(Params.from_text(surface), vary, _loads(parts["loads"]), _options(parts["study"]))


def _parted(text: str) -> tuple[str, str]:
    """The lines of the surface, which the library reads, and those of the tables of a study; the others are empty."""
    parts: tuple[list[str], list[str]] = [], []
    is_own = False
    for line in text.split("\n"):
        if header := _HEADER.match(line):
            is_own = header[1] is not None
        parts[is_own].append(line)
        parts[not is_own].append("")
    return "\n".join(parts[0]), "\n".join(parts[1])


def _table(found: dict[str, Any], name: str) -> dict[str, Any]:
    if name not in found and name != "study":
        raise Error(f"[{name}]: must be there; docs/studies.md has its keys")
    table = found.get(name, {})
    if not isinstance(table, dict):
        raise Error(f"{name} = {_shown(table)}: must be a table, [{name}]")
    return table


def _varied(name: str, given: Any) -> Any:
    """A spread, a list, or a distribution of SciPy by its name."""
    if isinstance(given, dict):
        return _distribution(name, given)
    values = given if isinstance(given, list) else [given]
    for value in values:
        _number(f"[vary] {name}", value, given)
    return [float(value) for value in given] if isinstance(given, list) else float(given)


def _distribution(name: str, given: dict[str, Any]) -> Any:
    from scipy import stats

    kind = given.get("distribution")
    family = getattr(stats, kind, None) if isinstance(kind, str) and kind.isidentifier() else None
    if not isinstance(family, (stats.rv_continuous, stats.rv_discrete)):
        raise Error(
            f"[vary] {name}: distribution = {_shown(kind)}: must be the name of one of scipy.stats, as \"norm\" or \"uniform\""
        )
    arguments = {key: value for key, value in given.items() if key != "distribution"}
    for key, value in arguments.items():
        _number(f"[vary] {name}: {key}", value, value)
    known = [*(family.shapes.split(", ") if family.shapes else []), "loc", "scale"]
    for key in arguments:
        if key not in known:
            raise Error(f"[vary] {name}: {key}: no such key; {instead(key, ['distribution', *known])}")
    for key in known[:-2]:
        if key not in arguments:
            raise Error(f"[vary] {name}: {key}: must be set for distribution = {_shown(kind)}")
    return family(**{key: float(value) for key, value in arguments.items()})


def _loads(table: dict[str, Any]) -> npt.NDArray[np.float64]:
    """Loads one by one, or evenly spaced in the logarithm."""
    _known("loads", table, _LOADS)
    if "values" in table:
        if len(table) > 1:
            raise Error(f"[loads] values: excludes {next(name for name in table if name != 'values')}, leave one out")
        values = table["values"]
        if not isinstance(values, list) or not values:
            raise Error(f"[loads] values = {_shown(values)}: must be a list of one or more numbers")
        for value in values:
            _number("[loads] values", value, values)
        return np.array([float(value) for value in values])
    for name in ("lowest", "highest"):
        if name not in table:
            raise Error(f"[loads] {name}: must be set, or values")
    lowest, highest = (_number(f"[loads] {name}", table[name], table[name]) for name in ("lowest", "highest"))
    if not 0 < lowest < highest < math.inf:
        raise Error(f"[loads] lowest = {lowest:g} and highest = {highest:g}: must be > 0, finite, and ascend")
    count = _whole("[loads] count", table.get("count", 33), 2, _MOST_LOADS)
    return np.geomspace(lowest, highest, count)


def _options(table: dict[str, Any]) -> dict[str, Any]:
    _known("study", table, _STUDY)
    for name in ("samples", "seed", "block"):
        if name in table:
            _whole(f"[study] {name}", table[name], 0 if name == "seed" else 1, 2**63 - 1)
    if not isinstance(table.get("warnings", True), bool):
        raise Error(f"[study] warnings = {_shown(table['warnings'])}: must be true or false")
    if table.get("sampling", "sobol") not in SAMPLINGS:
        raise Error(f"[study] sampling = {_shown(table['sampling'])}: must be one of {', '.join(map(repr, SAMPLINGS))}")
    return dict(table)


def _known(name: str, table: dict[str, Any], known: tuple[str, ...]) -> None:
    for key in table:
        if key not in known:
            raise Error(f"[{name}] {key}: no such key; {instead(key, known)}")


def _number(name: str, value: Any, shown: Any) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        raise Error(f"{name} = {_shown(shown)}: must be a number, or a list of them where one is allowed")
    if isinstance(value, int) and abs(value) > 1e300:
        raise Error(f"{name} = {short(value)}: must be finite")
    return float(value)


def _whole(name: str, value: Any, least: int, most: int) -> int:
    if isinstance(value, bool) or not isinstance(value, int):
        raise Error(f"{name} = {_shown(value)}: must be a whole number")
    if not least <= value <= most:
        raise Error(f"{name} = {short(value)}: must be from {least} to {most}")
    return value


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 80 else f"{text[:77]}..."
