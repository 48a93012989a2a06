"""The keys of a surface, and its text: what Python and the command line hand to the library."""

from __future__ import annotations

import re
from dataclasses import MISSING, fields
from itertools import chain
from typing import Any, Iterable, Literal, Sequence, TypedDict, Union

import numpy as np
import numpy.typing as npt

from .errors import Error
from .params import Bodies, Contact, Params, Process

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
    summits: Literal["moments", "mccool"]
    process: Process


class Surface(Joint, Roughness, total=False):
    """All that surface files have beside the pair, the nominal area and the coverage."""

    height_std: float
    summit_radius: float
    asperity_count: float
    summit_density: float


REQUIRED = tuple(field.name for field in fields(Params) if field.default is MISSING)
_IN_TABLES = {"materials": ("first", "second", *Bodies.__annotations__), "roughness": tuple(Roughness.__annotations__)}
_APART = [*REQUIRED, "summit_density", *chain(*_IN_TABLES.values())]
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


def literal(name: str, value: Any) -> str:
    """A value as TOML has it.

    Raises:
        TypeError: it is neither a number nor a word, nor a sequence of numbers.
    """
    if isinstance(value, str):
        return quoted(value)
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (list, tuple, np.ndarray)):
        return f"[{', '.join(literal(name, one) for one in value)}]"
    try:
        return repr(float(value))
    except (TypeError, ValueError):
        what = "(load, coefficient), (load, coefficient, error) or a list of these" if name == "measured" else "a number, a word or a list of numbers"
        raise TypeError(f"{name} = {value!r}: must be {what}") from None


def quoted(word: str) -> str:
    """A word in quotation marks."""
    escaped = word.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + re.sub(r"[\x00-\x1f\x7f]", lambda found: f"\\u{ord(found[0]):04x}", escaped) + '"'


def without_line(error: Error, keywords: Iterable[str] = ()) -> Error | TypeError:
    """The same of a text that the caller did not write, or `TypeError` if one of the keywords that made it is no key."""
    says = re.sub(r"^line \d+: ", "", str(error))
    known = {"nominal_area", "coverage", *Surface.__annotations__}
    return Error(says, error.status) if known.issuperset(keywords) else TypeError(says)
