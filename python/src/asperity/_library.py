"""Finds and loads the shared library.

The library is the one inside the package, or the file that the environment variable ASPERITY_LIBRARY names. One of
another binary interface is refused: its structs could not be trusted.
"""

from __future__ import annotations

import ctypes
import os
import sys
from pathlib import Path
from typing import Any

from . import _header

_NAMES = {"win32": "asperity.dll", "darwin": "libasperity.dylib"}


def find() -> str:
    """The file to load."""
    named = os.environ.get("ASPERITY_LIBRARY")
    if named:
        return named
    return str(Path(__file__).with_name(_NAMES.get(sys.platform, "libasperity.so")))


def load(path: str) -> ctypes.CDLL:
    """Loads a library and binds the functions of the header to it; `ImportError` says what is wrong with the file."""
    try:
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"asperity: cannot load the library: {error}{_HINT}", path=path) from None
    try:
        found = _bind(library, "asperity_abi_version")()
        if found != _header.ASPERITY_ABI_VERSION:
            raise ImportError(
                f"asperity: {path} has ABI version {found}, this package was written for version "
                f"{_header.ASPERITY_ABI_VERSION}; install a matching pair{_HINT}",
                path=path,
            )
        for name in _header.PROTOTYPES:
            _bind(library, name)
    except AttributeError as error:
        raise ImportError(f"asperity: {path} is not an asperity library: {error}{_HINT}", path=path) from None
    return library


_HINT = " (ASPERITY_LIBRARY names the library to load; unset it for the one inside the package)"


def _bind(library: ctypes.CDLL, name: str) -> ctypes._NamedFuncPointer:
    function = getattr(library, name)
    function.restype, function.argtypes = _header.PROTOTYPES[name]
    return function  # type: ignore[no-any-return]


PATH = find()
LIBRARY = load(PATH)


def version() -> str:
    """The version of the library loaded."""
    text: bytes = LIBRARY.asperity_version()
    return text.decode()


def text_of(call: Any, *arguments: Any) -> str:
    """What a call copies into a buffer, its last two arguments."""
    length: int = call(*arguments, None, 0)
    buffer = ctypes.create_string_buffer(length + 1)
    call(*arguments, buffer, len(buffer))
    return buffer.value.decode("utf-8", "replace")


def last_error() -> str:
    """This thread's last message."""
    return text_of(LIBRARY.asperity_last_error)
