"""What the library refuses, as an exception; and for its message, which name was meant."""

from __future__ import annotations

import difflib
from enum import IntEnum
from typing import Iterable

from . import _header
from ._library import LIBRARY, last_error


class Status(IntEnum):
    """Why a call failed; the numbers are those of the C interface."""

    OK = _header.ASPERITY_OK
    NULL_POINTER = _header.ASPERITY_NULL_POINTER
    INVALID_PARAMETER = _header.ASPERITY_INVALID_PARAMETER
    INVALID_LOAD = _header.ASPERITY_INVALID_LOAD
    SEPARATED = _header.ASPERITY_SEPARATED
    OUT_OF_RANGE = _header.ASPERITY_OUT_OF_RANGE
    NOT_CONVERGED = _header.ASPERITY_NOT_CONVERGED
    OUT_OF_MEMORY = _header.ASPERITY_OUT_OF_MEMORY
    INTERNAL = _header.ASPERITY_INTERNAL

    @property
    def description(self) -> str:
        """What the status means, in the library's words."""
        text: bytes = LIBRARY.asperity_status_string(self)
        return text.decode()


class Error(ValueError):
    """A value that the library refuses. The message names the quantity, its value and what is allowed.

    Attributes:
        status: why, as a `Status`.
    """

    status: Status

    def __init__(self, message: str, status: Status) -> None:
        super().__init__(message)
        self.status = status

    def __reduce__(self) -> tuple[type[Error], tuple[str, Status]]:
        return type(self), (str(self), self.status)


def check(status: int) -> None:
    """Raises the library's message unless it reports success."""
    if status != _header.ASPERITY_OK:
        raise Error(last_error(), Status(status))


def nearest(name: str, known: Iterable[str]) -> str:
    """The known name that looks most like a name."""
    spelled = {one.lower(): one for one in known}
    return spelled[difflib.get_close_matches(name.lower(), spelled, n=1, cutoff=0.0)[0]]
