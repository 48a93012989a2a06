"""Arguments checked before any work, with a message that names them: whole numbers, and loads of a study or of many specimens."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np
import numpy.typing as npt


def whole(name: str, value: Any) -> int:
    """A whole number.

    Raises:
        TypeError: it is none.
    """
    try:
        return operator.index(value)
    except TypeError:
        raise TypeError(f"{name} = {value!r}: must be a whole number") from None


def one_or_more_loads(loads: npt.ArrayLike, allowed: str) -> npt.NDArray[np.float64]:
    """A copy of finite loads, as a one-dimensional array.

    Args:
        loads: a number or a one-dimensional array of one or more.
        allowed: what the message says of others.

    Raises:
        ValueError: they are others, or one is not finite.
    """
    array = np.atleast_1d(np.asarray(loads))
    if array.ndim != 1 or array.size == 0 or array.dtype.kind not in "iuf":
        raise ValueError(f"loads: must be {allowed}")
    load = np.array(array, dtype=np.float64)
    if not np.isfinite(load).all():
        index = int(np.argmin(np.isfinite(load)))
        raise ValueError(f"loads[{index}] = {load[index]}: must be finite")
    return load
