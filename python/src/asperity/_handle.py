"""A model of the library: made, kept while a call uses it, freed once.

Every call holds the `Handle` that it uses. So `set_params` and `close` of a `Model` may come at any time, also from
another thread: they only let go of the handle, and it is freed when its last call is over. That is why `set_params` makes
a new handle instead of changing the old one.
"""

from __future__ import annotations

import ctypes
import weakref

from . import _header
from ._library import LIBRARY
from .errors import check
from .params import Params
from .results import Warnings


class Handle:
    """A model of the library, the parameters it was made from and the largest load that it is unloaded from, 0 at first loading; freed
    once, with the last reference."""

    def __init__(self, params: Params, largest_load: float = 0.0, before: Handle | None = None) -> None:
        self.params, self.largest_load = params, largest_load
        self.warned = Warnings(0)
        self.pointer = ctypes.POINTER(_header.asperity_model)()
        if largest_load == 0:
            check(LIBRARY.asperity_create(ctypes.byref(params._as_struct()), ctypes.byref(self.pointer)))
        else:
            before = before or Handle(params)
            check(LIBRARY.asperity_unloaded(before.pointer, largest_load, ctypes.byref(self.pointer)))
        # At exit a daemon thread may still be inside a call: the system takes the memory then.
        weakref.finalize(self, LIBRARY.asperity_free, self.pointer).atexit = False  # type: ignore[misc, unused-ignore]
