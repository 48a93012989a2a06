"""Arguments checked before any work, with a message that names them: of another type `TypeError`, of a value that cannot be `Error`."""

from __future__ import annotations

import math
import numbers
import operator
from typing import Any, Iterable

import numpy as np
import numpy.typing as npt

from ..errors import Error

def instance(name: str, value: Any, kind: Any) -> Any:
    """What is of a class."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} = {value!r}: must be a {kind.__name__}")
    return value


def real(name: str, value: Any) -> float:
    """A number."""
    if not isinstance(value, numbers.Real):
        raise TypeError(f"{name} = {value!r}: must be a real number")
    try:
        return float(value)
    except OverflowError:
        raise Error(f"{name}: a whole number of more than 308 digits; must be finite") from None


def positive(name: str, value: Any) -> float:
    """A finite number > 0."""
    number = real(name, value)
    if not (math.isfinite(number) and number > 0):
        raise Error(f"{name} = {number}: must be finite and > 0")
    return number


def share(name: str, value: Any) -> float:
    """A number between 0 and 1."""
    number = real(name, value)
    if not 0 < number < 1:
        raise Error(f"{name} = {value!r}: must be between 0 and 1{': is it in per cent?' if 1 <= number < 100 else ''}")
    return number


def whole(name: str, value: Any, least: int | None = None, most: int | None = None) -> int:
    """A whole number, within bounds."""
    if isinstance(value, bool) or not hasattr(value, "__index__"):
        raise TypeError(f"{name} = {value!r}: must be a whole number")
    number = operator.index(value)
    if least is not None and not least <= number <= (number if most is None else most):
        raise Error(f"{name} = {short(number)}: must be {f'{least} or more' if most is None else f'from {least} to {most}'}")
    return number


def short(number: Any) -> str:
    """A number as text, however many digits it has: Python refuses to write more than some thousand."""
    return f"{float(number):g}" if abs(number) < 1e300 else "a number of more than 300 digits"


def word(name: str, value: Any, words: Iterable[str]) -> str:
    """One of some words."""
    if instance(name, value, str) not in (known := tuple(words)):
        raise Error(f"{name} = {value!r}: must be one of {', '.join(map(repr, known))}")
    return str(value)


def words(name: str, values: Any) -> tuple[str, ...]:
    """A sequence of one or more words."""
    given = () if isinstance(values, (str, bytes)) or not isinstance(values, Iterable) else tuple(values)
    if not all(isinstance(one, str) for one in given) or (not given and values not in ((), [])):
        raise TypeError(f"{name} = {values!r}: must be a sequence of names")
    if not given:
        raise Error(f"{name} = {values!r}: must have one or more names")
    return given


def flag(name: str, value: Any) -> bool:
    """True or False."""
    if not isinstance(value, (numbers.Real, np.bool_)) or value not in (False, True):
        raise TypeError(f"{name} = {value!r}: must be True or False")
    return bool(value)


def array(name: str, values: Any) -> npt.NDArray[np.float64]:
    """Real numbers, as an array of whatever shape."""
    array = np.asarray(values)
    if array.dtype.kind not in "iuf" and array.size > 0:
        raise TypeError(f"{name}: must be real numbers, not an array of {array.dtype}")
    return np.asarray(array, dtype=np.float64, order="C")


def column(name: str, values: Any, allowed: str = "a one-dimensional array of one or more real numbers") -> npt.NDArray[np.float64]:
    """A copy of finite numbers, as a one-dimensional array of one or more."""
    found = array(name, values).copy()
    if found.ndim != 1 or found.size == 0:
        raise Error(f"{name}: must be {allowed}, not of shape {found.shape}")
    if not np.isfinite(found).all():
        index = int(np.argmin(np.isfinite(found)))
        raise Error(f"{name}[{index}] = {found[index]}: must be finite")
    return found


def one_or_more(name: str, values: Any) -> npt.NDArray[np.float64]:
    """As `column`; also of one number."""
    allowed = "a real number or a one-dimensional array of one or more"
    return column(name, [values] if isinstance(values, numbers.Real) else values, allowed)
