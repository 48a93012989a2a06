"""The keys of a surface, and its text: what Python and the command line hand to the library."""

from __future__ import annotations

import numbers
import re
from dataclasses import MISSING, fields
from itertools import chain
from typing import Any, Iterable, Literal, Mapping, Sequence, TypedDict, Union

import numpy as np
import numpy.typing as npt

from .errors import Error
from .params import Bodies, Contact, Params, Process, literal_of
from .tools import checks
from .units import DIMENSIONS, of

Numbers = Union[float, Sequence[float], npt.NDArray[Any]]


class Joint(Contact, total=False):
    """Two materials, what is between them, and what was measured of them."""

    first: str
    second: str
    interface: str
    measured: Union[Sequence[float], Sequence[Sequence[float]], npt.NDArray[Any]]


class Roughness(TypedDict, total=False):
    """The roughness of one surface, or of two as two numbers."""

    m0: Numbers
    m2: Numbers
    m4: Numbers
    Ra: Numbers
    Rq: Numbers
    RSm: Numbers
    Rdq: Numbers
    Sq: Numbers
    Sdq: Numbers
    Ssc: Numbers
    Sds: Numbers
    Ssk: float
    Sku: float
    heights_at_scores: Numbers
    slopes_at_scores: Numbers
    lay: float
    summits: Literal["moments", "mccool"]
    process: Process


class KnownTo(TypedDict, total=False):
    """Factors within which 95 % of the true inputs are."""

    slope: float
    hardness: float
    work_of_adhesion: float
    E: float


class MeasuredOn(Roughness, Bodies, total=False):
    """The specimen that was measured, where it is not the surface asked for."""

    nominal_area: float
    hardness: float


class Surface(Joint, Roughness, total=False):
    """All that surface files have beside the pair, the nominal area and the coverage."""

    interface_kind: Literal["film", "clean", "dry metal", "rock"]
    specimens: int
    size_effect: float
    model_error: float
    known_to: KnownTo
    measured_on: MeasuredOn
    height_std: float
    summit_radius: float
    asperity_count: float
    summit_density: float


REQUIRED = tuple(field.name for field in fields(Params) if field.default is MISSING)
_IN_TABLES = {"materials": ("first", "second", *Bodies.__annotations__), "roughness": tuple(Roughness.__annotations__)}
_TABLES = ("known_to", "measured_on")
_APART = [*REQUIRED, "summit_density", *_TABLES, *chain(*_IN_TABLES.values())]
# The keys of surface files, by their table, in the order of the help.
KEYS = {
    "": (
        "pair", *REQUIRED, "summit_density", "nominal_area", *(name for name in Surface.__annotations__ if name not in _APART), "coverage",
    ),
    **_IN_TABLES,
}  # fmt: skip


def text_of(given: Iterable[tuple[str, str]]) -> str:
    """The text that gives keys these values, which are written as TOML has them."""
    lines: dict[str, list[str]] = {table: [] for table in KEYS}
    for name, value in given:
        # What is no key is for the library to refuse.
        table = next((table for table, names in KEYS.items() if name in names), "")
        lines[table].append(f"{name if name.isidentifier() else quoted(name)} = {value}")
    return "\n".join(line for table, found in lines.items() if found for line in ([f"[{table}]"] if table else []) + found)


def load_unit(given: Iterable[str]) -> str:
    """The unit of the loads of a surface with these keys: without a nominal area they are pressures."""
    return "N" if "nominal_area" in given else "Pa"


def text_of_values(given: Mapping[str, Any]) -> str:
    """The same of values in SI units, or with units of their own."""
    load = load_unit(given)
    return text_of((name, literal(name, value, load)) for name, value in given.items())


def literal(name: str, value: Any, load: str) -> str:
    """A value as TOML has it, where loads have this unit.

    Raises:
        TypeError: it is neither a number nor a word, nor a sequence of numbers.
    """
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if name in _TABLES:
        return _table(name, value)
    if name == "measured":
        return _points(value, load)
    return literal_of(name, value, load if DIMENSIONS.get(name) == "force" else of(name))


def _table(name: str, given: Any) -> str:
    """A table within the text; what is known to a factor has no unit."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{name} = {given!r}: must be a mapping of keys to values")
    parts = []
    for key, value in given.items():
        written = key if f"{key}".isidentifier() else quoted(f"{key}")
        number = quoted(value) if isinstance(value, str) else literal_of(f"{name} {key}", value, "" if name == "known_to" else of(key))
        parts.append(f"{written} = {number}")
    return "{" + ", ".join(parts) + "}"


def _points(given: Any, load: str) -> str:
    """Measured points, without those of which a number is masked."""
    if isinstance(given, numbers.Real):
        return repr(float(given))  # which the library refuses
    if not (isinstance(given, (list, tuple)) or hasattr(given, "__array__")):
        raise TypeError(f"measured = {given!r}: must be (load, coefficient), (load, coefficient, error) or a list of these")
    if not isinstance(given, (list, tuple)):
        found, masked = checks.known("measured", given)
        if found.ndim == 0:
            return repr(checks.real("measured", given))
        given = np.ma.masked_array(found, masked).tolist(None)
    alone = not any(map(_is_row, given))
    points = [_point(one, load) for one in ([given] if alone else given)]
    left = [one for one in points if one is not None]
    if points and not left:
        raise Error("measured: all points are masked")
    return left[0] if alone else f"[{', '.join(left)}]"


def _point(given: Any, load: str) -> str | None:
    """The numbers of a point; None where one of them is masked."""
    if not _is_row(given):
        raise TypeError(f"measured: {given!r}: must be (load, coefficient) or (load, coefficient, error)")
    units = [load, *[""] * (len(given) - 1)]
    parts = [None if one is None else checks.known("measured", one, unit) for one, unit in zip(given, units)]
    known = [part[0].tolist() for part in parts if part is not None and not part[1].any()]
    return str(known) if len(known) == len(given) else None


def _is_row(given: Any) -> bool:
    """Whether there are several numbers; what no array can be made of is told by `known`."""
    try:
        return isinstance(given, (list, tuple)) or np.ndim(given) > 0
    except Exception:  # whatever a library raises
        return False


def quoted(word: str) -> str:
    """A word in quotation marks."""
    escaped = word.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + re.sub(r"[\x00-\x1f\x7f]", lambda found: f"\\u{ord(found[0]):04x}", escaped) + '"'


def without_line(error: Error, keywords: Iterable[str] = ()) -> Error | TypeError:
    """The same of a text that the caller did not write, or `TypeError` if one of the keywords that made it is no key."""
    says = re.sub(r"^line \d+: ", "", str(error))
    known = {"nominal_area", "coverage", *Surface.__annotations__}
    return Error(says, error.status) if known.issuperset(keywords) else TypeError(says)
