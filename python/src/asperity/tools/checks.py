"""Arguments checked before any work, with a message that names them: of another type `TypeError`, of a value that cannot be `Error`.

Every number that enters the package goes through `known`, alone or in an array of whatever library. What it is in is told by a
`unit`: an SI unit, "" for a plain number, or a dimension, as "force", where the system of units is the caller's own. A quantity of
pint, astropy or unyt, or an array whose attributes name a unit, is converted by its own `to`.
"""

from __future__ import annotations

import math
import numbers
import operator
from collections.abc import Mapping
from typing import Any, Iterable

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..units import SI
from .labelled import like

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]


def instance(name: str, value: Any, kind: Any) -> Any:
    """What is of a class."""
    if not isinstance(value, kind):
        raise TypeError(f"{name} = {value!r}: must be a {kind.__name__}")
    return value


def real(name: str, value: Any, unit: str = "") -> float:
    """A number."""
    if type(value) is not bool and isinstance(value, numbers.Real):
        try:
            return float(value)
        except OverflowError:
            raise Error(f"{name}: a whole number of more than 308 digits; must be finite") from None
    if not hasattr(value, "__array__"):
        raise TypeError(f"{name} = {value!r}: must be a real number")
    found = array(name, value, unit)
    if found.ndim > 0:
        raise TypeError(f"{name}: must be a real number, not an array of shape {found.shape}")
    return float(found)


def positive(name: str, value: Any, unit: str = "") -> float:
    """A finite number > 0."""
    number = real(name, value, unit)
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
    try:
        number = operator.index(array(name, value).astype(object)[()] if hasattr(value, "mask") else value)
    except TypeError:
        number = None
    if number is None or isinstance(value, (bool, np.bool_)):
        raise TypeError(f"{name} = {value!r}: must be a whole number")
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


def array(name: str, values: Any, unit: str = "") -> Array:
    """Real numbers, as an array of whatever shape that the library can read; masked ones are refused."""
    found, masked = known(name, values, unit)
    if masked.any():
        at = tuple(map(int, np.argwhere(masked)[0]))
        raise Error(f"{name}: {int(masked.sum())} of {found.size} numbers are masked, the first at {list(at)}: leave them out")
    return found


def known(name: str, values: Any, unit: str = "") -> tuple[Array, Mask]:
    """Real numbers as an array in the order and alignment of C, and which of them are masked or pandas' NA: NaN in the array."""
    plain = _in_unit(name, values, unit)
    masked: Any = getattr(plain, "mask", False)
    dtype: Any = getattr(plain, "dtype", None)
    if hasattr(dtype, "na_value") and dtype.kind in "iuf":  # an extension array of pandas
        plain, masked = plain.to_numpy(dtype=np.float64, na_value=math.nan), np.asarray(plain.isna())
    try:
        found = np.asarray(plain)
    except Exception as error:  # whatever a library raises for what is no array, as rows of several lengths
        raise TypeError(f"{name}: must be real numbers ({error})") from None
    if found.dtype.kind not in "iuf" and (found.size > 0 or found.dtype.kind != "O"):
        raise TypeError(f"{name}: must be real numbers, not an array of {found.dtype}")
    with np.errstate(over="ignore"):
        found = np.require(found, np.float64, ["C", "A"])
    where = np.broadcast_to(masked, found.shape) if isinstance(masked, (np.ndarray, np.bool_)) else np.zeros(found.shape, dtype=bool)
    return (np.where(where, np.nan, found) if where.any() else found), where


def column(name: str, values: Any, unit: str = "") -> Array:
    """A copy of finite numbers, as a one-dimensional array of one or more."""
    return _column(name, array(name, values, unit))


def one_or_more(name: str, values: Any, unit: str = "") -> Array:
    """As `column`; also of one number."""
    found = array(name, values, unit)
    return _column(name, found.reshape(1) if found.ndim == 0 else found, "a real number or a one-dimensional array of one or more")


def columns(**given: tuple[Any, str]) -> list[Array]:
    """Columns that belong together, each with its unit, as many numbers each: without those of which one is masked."""
    parts = {name: known(name, values, unit) for name, (values, unit) in given.items()}
    first, (leading, left) = next(iter(parts.items()))
    for name, (found, masked) in parts.items():
        _shaped(name, found)
        if found.size != leading.size:
            raise Error(f"{name} has {found.size} values, {first} {leading.size}: must be as many")
        left = left | masked
    if left.all():
        raise Error(f"{' and '.join(given)}: all numbers are masked")
    return [_column(name, found[~left]) for name, (found, _) in parts.items()]


def _shaped(name: str, found: Array, allowed: str = "a one-dimensional array of one or more real numbers") -> None:
    if found.ndim != 1 or found.size == 0:
        raise Error(f"{name}: must be {allowed}, not of shape {found.shape}")


def _column(name: str, found: Array, *allowed: str) -> Array:
    _shaped(name, found, *allowed)
    if not np.isfinite(found).all():
        index = int(np.argmin(np.isfinite(found)))
        raise Error(f"{name}[{index}] = {found[index]}: must be finite")
    return found.copy()


def is_number(given: Any, found: Array) -> bool:
    """Whether what was given is one number, which is answered with one, and no array without dimensions."""
    return found.ndim == 0 and type(given) is not np.ndarray and not hasattr(given, "dims")


def shaped(given: Any, values: Array, name: str) -> Any:
    """A float for one number, else an array with the labels of what was given."""
    if is_number(given, values):
        return float(values)
    return like(given, values, name) if np.shape(given) == values.shape else values


def has_unit(values: Any) -> bool:
    """Whether numbers come with a unit of their own."""
    return _unit_of(values) is not None


def _unit_of(values: Any) -> Any:
    """The unit that a quantity has, or that the attributes of an array name; None for plain numbers."""
    labelled, attributes = hasattr(values, "dims"), getattr(values, "attrs", None)
    holder = values.data if labelled else getattr(values, "array", None) if hasattr(values, "iloc") else values
    for name in ("units", "unit"):
        found = getattr(holder, name, None)
        if found is None and isinstance(attributes, Mapping):
            found = attributes.get(name)
        if found is not None and not callable(found):
            return found
    return None


def _in_unit(name: str, values: Any, unit: str) -> Any:
    """The numbers of a quantity, or of a list of some, in a unit; what has no unit as it is."""
    if isinstance(values, (list, tuple)):
        examples = {type(one): one for one in values}.values()
        if any(isinstance(one, (list, tuple)) or has_unit(one) for one in examples):
            parts = [known(name, one, unit) for one in values]
            values = [np.ma.masked_array(*part) if part[1].any() else part[0] for part in parts]
            examples = values
        return np.ma.stack(values) if any(isinstance(getattr(one, "mask", None), (np.ndarray, np.bool_)) for one in examples) else values
    own = _unit_of(values)
    if own is None:
        return values
    if unit in SI:
        if own == unit:  # what a study writes
            return np.asarray(values)
        raise TypeError(f"{name}: has the unit {own}, where the system of units is your own: give plain numbers in it, or parameters in_si")
    try:
        quantity = next((one for one in (values, *_inside(values)) if hasattr(one, "to") and not isinstance(own, str)), None)
        found = (_quantity(np.asarray(values), own) if quantity is None else quantity).to(unit)
    except Exception as error:  # of whatever library: another kind of unit, or a unit that it does not know
        raise TypeError(f"{name}: has the unit {own}, must be in {unit or 'no unit'} or what converts to it ({error})") from None
    return found.magnitude if hasattr(found, "magnitude") else found.value


def _inside(values: Any) -> Iterable[Any]:
    """What an array with labels holds."""
    held = getattr(values, "array", None) if hasattr(values, "iloc") else getattr(values, "data", None)
    return held, getattr(held, "quantity", None)


def _quantity(values: Array, unit: str) -> Any:
    """A quantity of a unit that is named in words, by a library that is there."""
    try:
        from astropy.units import Quantity
    except ImportError:
        from pint import application_registry

        Quantity = application_registry.Quantity
    return Quantity(values, unit)
