"""The text of a surface, of numbers and words by name: what Python and the command line hand to the library."""

from __future__ import annotations

import re
from dataclasses import MISSING, fields
from typing import Any, Iterable

import numpy as np

from .errors import Error
from .params import CALIBRATION, Params

REQUIRED = tuple(field.name for field in fields(Params) if field.default is MISSING)
OPTIONAL = tuple(
    field.name for field in fields(Params) if field.default is not MISSING and field.name not in (*CALIBRATION, "nominal_area")
)
# The keys of surface files, by their table.
KEYS = {
    "": ("pair", *REQUIRED, "summit_density", "nominal_area", *OPTIONAL, "interface", *CALIBRATION, "measured", "coverage"),
    "materials": ("first", "second", "E1", "nu1", "E2", "nu2"),
    "roughness": ("m0", "m2", "m4", "Ra", "Rq", "RSm", "Rdq", "Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku", "summits", "process"),
}


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
        raise TypeError(f"{name} = {value!r}: must be a number, a word or a list of numbers") from None


def quoted(word: str) -> str:
    """A word in quotation marks."""
    escaped = word.replace("\\", "\\\\").replace('"', '\\"')
    return '"' + re.sub(r"[\x00-\x1f\x7f]", lambda found: f"\\u{ord(found[0]):04x}", escaped) + '"'


def without_line(error: Error) -> Error:
    """The same of a text that the caller did not write."""
    return Error(re.sub(r"^line \d+: ", "", str(error)), error.status)
