"""The parameters of a study, drawn: relative spreads, distributions of SciPy, lists, functions, and how they are combined.

Random numbers become values by the inverse of each distribution function, so that points of low discrepancy
(`scipy.stats.qmc`) serve all distributions. Lists make a grid, whose points each get all of the samples.
"""

from __future__ import annotations

import hashlib
import itertools
import math
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from .. import units
from ..errors import Error
from ..fits.many_surfaces import names_of
from ..fits.names import FreeName
from ..params import Params
from ..tools import checks

Array = npt.NDArray[np.float64]
Quantile = Callable[[Array], Array]

SAMPLINGS = ("sobol", "latin", "random", "saltelli")
# More surfaces take days on a hundred cores.
MOST = 10_000_000
# A relative deviation of 2 is a factor of 7 either way; 5e-10 is an error in metres (the limits of `uncertainty`).
_NARROWEST, _WIDEST = 1e-6, 2.0
# Sobol' points are multiples of 2^-30: the first lies in the middle of its cell then, not at 0.
_LEAST = 2.0**-31


@dataclass(frozen=True)
class Draws:
    """The parameters of all surfaces.

    Attributes:
        names: what varies.
        values: (surfaces, names).
        told: name to what it was drawn from, in words.
        base: the samples asked for: at each point of the grid, or rows of each matrix of "saltelli".
    """

    names: tuple[str, ...]
    values: Array
    told: dict[str, str]
    base: int


def digest(values: Array) -> str:
    """Tells values from all others, to the bit."""
    return hashlib.sha256(np.ascontiguousarray(values).tobytes()).hexdigest()


def drawn(params: Params, vary: Any, samples: Any, seed: int, sampling: str) -> Draws:
    """Draws; `Error` and `TypeError` name what cannot be used."""
    checks.word("sampling", sampling, SAMPLINGS)
    if callable(vary):
        return _joint(params, vary, samples, seed, sampling)
    if not isinstance(vary, Mapping):
        raise TypeError(f"vary = {vary!r}: must be a mapping, {{name: spread, distribution, list or function}}, or a function")
    if not vary:
        raise Error("vary = {}: must name one parameter or more, {name: spread, distribution, list or function}")
    names = names_of(tuple(vary), params)
    grids = {
        name.given: checks.column(f"vary {name.given}", vary[name.given], _unit(name, params))
        for name in names
        if _is_grid(vary[name.given])
    }
    points = math.prod(len(values) for values in grids.values())
    chance = [name for name in names if name.given not in grids]
    if sampling == "saltelli" and (grids or len(chance) < 2):
        raise Error(
            "sampling = 'saltelli': Sobol' indices are of two or more parameters that vary independently at random, not of lists"
        )
    count = _count(samples, bool(chance))
    surfaces = points * count * (len(chance) + 2 if sampling == "saltelli" else 1)
    if surfaces > MOST:
        raise Error(f"samples = {count}: make {surfaces} surfaces; must make at most {MOST}")
    columns, told = _columns(params, chance, vary, count, seed, sampling)
    told |= {name: f"{len(values)} values, {values.min():g} to {values.max():g}" for name, values in grids.items()}
    by_name = dict(zip(grids, zip(*itertools.product(*grids.values())))) if grids else {}
    rows = np.empty((surfaces, len(names)))
    for j, name in enumerate(names):
        if name.given in grids:
            rows[:, j] = np.repeat(np.array(by_name[name.given]), count)
        else:
            rows[:, j] = np.tile(columns[name.given], points)
    return Draws(tuple(vary), rows, {name.given: told[name.given] for name in names}, count)


def _columns(
    params: Params, chance: list[FreeName], vary: Mapping[str, Any], count: int, seed: int, sampling: str
) -> tuple[dict[str, Array], dict[str, str]]:
    """The values of what varies at random, and what they are drawn from."""
    sides = 2 if sampling == "saltelli" else 1
    functions = {name.given: _unit(name, params) for name in chance if _is_function(vary[name.given])}
    quantiles, told = {}, {}
    for name in chance:
        if name.given in functions:
            told[name.given] = f"function {getattr(vary[name.given], '__name__', type(vary[name.given]).__name__)}"
        else:
            quantiles[name.given], told[name.given] = _quantile(params, name, vary[name.given])
    unit = _points(len(quantiles) * sides, count, seed, sampling)
    sheets: list[dict[str, Array]] = []
    for side in range(sides):
        first = side * len(quantiles)
        sheets.append({name: quantile(unit[:, first + j]) for j, (name, quantile) in enumerate(quantiles.items())})
    for j, asked in enumerate(sorted(functions)):
        values = _column(asked, vary[asked](np.random.default_rng([seed, j]), count * sides), count * sides, functions[asked])
        for side in range(sides):
            sheets[side][asked] = values[side * count : (side + 1) * count]
    if sampling != "saltelli":
        return sheets[0], told
    # A, B, and for each name A with the column of B.
    return {
        name.given: np.concatenate(
            [sheets[0][name.given], sheets[1][name.given], *(sheets[int(other is name)][name.given] for other in chance)]
        )
        for name in chance
    }, told


def _points(dimensions: int, count: int, seed: int, sampling: str) -> Array:
    """Points of the unit cube, none on its faces."""
    random = np.random.default_rng(seed)
    if dimensions == 0:
        return np.empty((count, 0))
    if sampling == "random":
        points = random.random((count, dimensions))
    else:
        from scipy.stats import qmc

        kind = qmc.LatinHypercube if sampling == "latin" else qmc.Sobol
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # of numbers of samples that are no powers of 2: the caller's choice
            points = kind(dimensions, seed=random).random(count)
    return np.clip(points, _LEAST, 1 - 2.0**-53)


def _quantile(params: Params, name: FreeName, given: Any) -> tuple[Quantile, str]:
    """The inverse of a distribution function, and what it is in words."""
    inverse = getattr(given, "ppf", None) or getattr(given, "icdf", None)
    if callable(inverse):
        try:
            middle = float(inverse(0.5))
        except (TypeError, ValueError) as error:
            raise Error(f"vary {name.given} = {given!r}: is no distribution of one number ({error})") from None
        if math.isnan(middle):
            raise Error(f"vary {name.given}: {_told(given)} has no values: its own parameters are out of bounds")
        return lambda unit: np.asarray(inverse(unit), dtype=np.float64), _told(given)
    try:
        spread, value = checks.real(f"vary {name.given}", given), name.start(params)
    except TypeError as error:
        says = "must be a relative spread, a distribution of SciPy, a list of values or a function"
        raise TypeError(f"vary {name.given} = {given!r}: {says} ({error})") from None
    if name.positive and not _NARROWEST <= spread <= _WIDEST:
        meant = f"; {spread:g} % are {spread / 100:g}" if _WIDEST < spread <= 100 else ""
        raise Error(
            f"vary {name.given} = {given!r}: is a spread relative to the value, and must be from {_NARROWEST:g} to {_WIDEST:g}"
            f"{meant}; a list or a distribution gives values"
        )
    if not name.positive and not 0 < spread < math.inf:
        raise Error(f"vary {name.given} = {given!r}: is a standard deviation, and must be finite and > 0")
    from scipy.special import ndtri

    if name.positive:
        return lambda unit: value * np.exp(spread * ndtri(unit)), f"log-normal about {value!r}, relative spread {spread!r}"
    return lambda unit: value + spread * ndtri(unit), f"normal about {value!r}, standard deviation {spread!r}"


def _told(distribution: Any) -> str:
    """A distribution in words that are the same for equal ones."""
    frozen = getattr(distribution, "dist", None)
    if frozen is None:
        return str(distribution)
    inside = [*map(repr, distribution.args), *(f"{name}={value!r}" for name, value in distribution.kwds.items())]
    return f"scipy.stats.{frozen.name}({', '.join(inside)})"


def _joint(params: Params, vary: Callable[..., Any], samples: Any, seed: int, sampling: str) -> Draws:
    """Parameters that one function draws together, correlated as it likes."""
    if sampling == "saltelli":
        raise Error("sampling = 'saltelli': needs a mapping of parameters, which vary independently, not one function")
    count = _count(samples, True)
    found = vary(np.random.default_rng(seed), count)
    if not isinstance(found, Mapping) or not found:
        raise TypeError(f"vary: the function returned {type(found).__name__}; must be a mapping, {{name: array of values}}")
    names = names_of(tuple(found), params)
    values = np.column_stack([_column(name.given, found[name.given], count, _unit(name, params)) for name in names])
    told = f"function {getattr(vary, '__name__', type(vary).__name__)} of all names"
    return Draws(tuple(found), values, dict.fromkeys(found, told), count)


def _column(name: str, values: Any, count: int, unit: str) -> Array:
    found = checks.array(f"vary {name}: what the function returned", values, unit)
    if found.shape != (count,):
        raise Error(f"vary {name}: the function returned numbers of shape {found.shape}; must be of shape ({count},)")
    return found


def _is_grid(given: Any) -> bool:
    """A list or an array, with or without labels; but neither a number nor a distribution."""
    return isinstance(given, (list, tuple, range)) or getattr(given, "ndim", 0) > 0


def _is_function(given: Any) -> bool:
    return callable(given) and not hasattr(given, "ppf") and not hasattr(given, "icdf")


def _unit(name: FreeName, params: Params) -> str:
    return units.unit(units.DIMENSIONS.get(name.field, name.dimension), params.in_si)


def _count(samples: int | None, chance: bool) -> int:
    if samples is None:
        return 1024 if chance else 1
    samples = checks.whole("samples", samples, 1, MOST)
    if not chance and samples != 1:
        raise Error(f"samples = {samples}: all of vary are lists, whose grid has each point once; leave samples out")
    return samples
