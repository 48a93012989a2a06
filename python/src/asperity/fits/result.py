"""What a fit found: values, errors, the band around its curve, its figure."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from .. import units
from .._friction_law import FrictionLaw
from ..params import Params
from ..tools import checks
from ..tools.style import saved, style
from .names import STRENGTHS
from .search import Data, Search

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

# A direction that changes no friction by more than this part of it per unit of the search has no effect to be measured.
_NO_EFFECT = 1e-6
# A partner of a parameter that the data do not fix: correlation with it, or share of the direction without effect.
_PARTNER, _SHARE = 0.9, 0.02


@dataclass(frozen=True, eq=False)
class Estimate:
    """What the Jacobian at the minimum tells, in the coordinates of the search."""

    effective: Array  # the covariance without the directions that have no effect
    covariance: Array  # infinite for a name that has a part in a direction without effect
    ineffective: Array  # (directions, names): unit vectors along which the friction does not change

    @classmethod
    def of(cls, jacobian: Array, friction: float, scatter: float) -> Estimate:
        """From the Jacobian of residuals whose variance is `scatter`, of a friction of this norm."""
        _, sizes, directions = np.linalg.svd(jacobian, full_matrices=False)
        effective = sizes > _NO_EFFECT * friction
        scaled = directions[effective] / sizes[effective, None]
        covariance = scatter * (scaled.T @ scaled)
        ineffective = directions[~effective]
        lost = (np.abs(ineffective) > _SHARE).any(axis=0)
        covariance[lost, :] = covariance[:, lost] = np.nan
        covariance[lost, lost] = np.inf
        return cls(scatter * (scaled.T @ scaled), covariance, ineffective)

    def error_of(self, jacobian: Array, friction: Array) -> Array:
        """The standard error of friction with this Jacobian."""
        error: Array = np.sqrt(np.einsum("ki,ij,kj->k", jacobian, self.effective, jacobian))
        unknown = (np.abs(jacobian @ self.ineffective.T) > 10 * _NO_EFFECT * friction[:, None]).any(axis=1)
        return np.where(unknown, np.inf, error)

    def partners(self, names: tuple[str, ...], name: str) -> str:
        """The others that make up for a change of a name, in words."""
        i = names.index(name)
        if math.isinf(self.covariance[i, i]):
            part = np.abs(self.ineffective) > _SHARE
            one: Mask = part[part[:, i]].max(axis=0)
        else:
            one = np.abs(_correlation(self.covariance)[i]) > _PARTNER
        return _and(other for other, is_one in zip(names, one) if is_one and other != name)


@dataclass(frozen=True, eq=False)
class End:
    """Where a search ended."""

    search: Search
    x: Array
    estimate: Estimate
    student: float | None


class Prediction(NamedTuple):
    """Friction of a fit at loads, and how well the data fix it.

    Attributes:
        friction: coefficient or force, as was fitted.
        error: its standard error, from those of the parameters and their correlations; infinite where it depends on what
            the data do not determine.
    """

    friction: Array
    error: Array


@dataclass(frozen=True, eq=False)
class Fit:
    """What `fit` found. Arrays follow the order of `free`; `str` of it is a table.

    Attributes:
        params: the surfaces with the fitted values.
        free: names of the fitted parameters.
        values: their values, in the units of `params`.
        errors: their standard errors, in the same units; infinite where the data do not fix a parameter at all.
        covariance: of the values, (free, free); rows and columns of an infinite error are NaN off the diagonal.
        chi_square: sum of squared residuals over sigma; without sigma, of the plain residuals.
        degrees_of_freedom: measured points less fitted parameters.
        unidentifiable: names that the data do not determine, see `fit`.
        at_bound: names whose value is a bound: the data would have it beyond, and its error means little.
        success: whether the search converged.
        message: in words: how the search ended and all that there is to be said against the result.
        load: normal loads of the data [force].
        measured: friction coefficient or friction force [force] at them.
        fitted: the same of the model with `params`.
        sigma: standard errors of the data; None if they were not given.
        quantity: "mu" or "force": what was fitted.
        loss: of the residuals, see `fit`.
        dimensions: of the values: "length", "stress", "force/length", or "" for numbers.
    """

    params: Params
    free: tuple[str, ...]
    values: dict[str, float]
    errors: dict[str, float]
    covariance: Array
    chi_square: float
    degrees_of_freedom: int
    unidentifiable: tuple[str, ...]
    at_bound: tuple[str, ...]
    success: bool
    message: str
    load: Array
    measured: Array
    fitted: Array
    sigma: Array | None
    quantity: str
    loss: str
    dimensions: dict[str, str]
    _end: End = field(repr=False)

    @property
    def calibrated(self) -> tuple[str, ...]:
        """The free names that the strength of the interface was fitted by, without those that the data do not determine."""
        return tuple(name for name in self.free if name in STRENGTHS and name not in self.unidentifiable)

    @property
    def reduced_chi_square(self) -> float | None:
        """chi_square/degrees_of_freedom: about 1 for a good fit. None without sigma: nothing says then how good it can be."""
        return None if self.sigma is None else self.chi_square / self.degrees_of_freedom

    def reach(self, coverage: float = 0.95) -> float:
        """Standard errors from a value to either end of its band: of the normal distribution, or, where the scatter of the residuals
        gave the errors, of Student's with the degrees of freedom: 12.7 for two points and one free name.

        Args:
            coverage: probability of the band, between 0 and 1.
        """
        from scipy.stats import norm, t

        part = 0.5 + 0.5 * checks.share("coverage", coverage)
        return float(norm.ppf(part) if self.student is None else t.ppf(part, self.student))

    @property
    def student(self) -> float | None:
        """Degrees of freedom of Student's distribution, which the errors have if they are from the scatter of the residuals; None if
        the errors of the points were given."""
        return self._end.student

    @property
    def scatter(self) -> float:
        """Standard deviation of the measured friction from the fitted, in its unit."""
        difference = self.measured - self.fitted
        return math.sqrt(float(difference @ difference) / self.degrees_of_freedom)

    def predict(self, load: npt.ArrayLike) -> Prediction:
        """The fitted friction at loads, with its standard error: a band around the curve.

        The errors of the parameters are carried on linearly. They are those of the curve, not of a new measurement, whose own
        error comes on top; and they hold if the model does, the more so outside the loads that were measured.

        Args:
            load: normal loads [force], one-dimensional; > 0 for friction coefficients.

        Raises:
            Error: loads that cannot be used.
        """
        loads = checks.column("load", load, units.unit("force", self.params.in_si))
        some, in_si = np.ones(loads.shape), self.params.in_si
        mu, force = (some, None) if self.quantity == "mu" else (None, some)
        Data.of(loads, mu, force, None, in_si)  # refuses loads that a coefficient cannot be at
        search = self._end.search.at_loads(loads)
        friction = search.friction(self._end.x)
        return Prediction(friction, self._end.estimate.error_of(search.jacobian(self._end.x), friction))

    @property
    def correlation(self) -> Array:
        """Of the values, (free, free), -1 to 1; NaN with a parameter whose error is infinite."""
        return _correlation(self.covariance)

    @property
    def residuals(self) -> Array:
        """Measured less fitted, over sigma where that is given."""
        difference = self.measured - self.fitted
        return difference if self.sigma is None else difference / self.sigma

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws data and fit over the load with its band of 95 %, the residuals below.

        Legend and axes have the SI units if the parameters are `in_si`, and otherwise say of which dimension each number is.

        Args:
            file: to write the figure to; its ending is its format, for example "fit.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        return _draw(self, file)

    def __str__(self) -> str:
        lines = [f"{name} = {_with_error(self.values[name], self.errors[name])}" for name in self.free]
        return "\n".join([*lines, self.message])


def _draw(fit: Fit, file: str | os.PathLike[str] | None) -> Figure:
    """Draws it, and writes it if a file is named."""

    def unit(dimension: str) -> str:
        return f" [{units.unit(dimension, fit.params.in_si)}]" if dimension else ""

    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.5, 6), layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (3, 1)})
        linear_to = _linear_to(fit.load)
        if (fit.load > 0).all():
            above.set_xscale("log")
        else:
            above.set_xscale("symlog", linthresh=linear_to)
        if (fit.fitted > 0).all() and (fit.measured > 0).all():
            above.set_yscale("log" if fit.quantity == "force" else "linear")
        above.errorbar(fit.load, fit.measured, yerr=fit.sigma, fmt="o", ms=4, mfc="none", color="black", label="measured")
        load = _loads(fit.load, linear_to)
        named = "\n".join(
            f"  {name} = {fit.values[name]:.4g} ± {fit.errors[name]:.1g}{unit(fit.dimensions[name])}" for name in fit.free
        )
        pressing = load[load > 0]
        if pressing.size:
            with FrictionLaw(fit.params) as law:
                law.warn(float(pressing.min()), float(pressing.max()))
        curve, deviation = fit.predict(load)
        if np.isfinite(deviation).all():
            reach = fit.reach() * deviation
            above.fill_between(load, curve - reach, curve + reach, color="C0", alpha=0.25, lw=0, label="95 % band of the fit")
        above.plot(load, curve, color="C0", label=f"fitted\n{named}")
        above.set_ylabel("friction coefficient $F/P$" if fit.quantity == "mu" else f"friction force $F${unit('force')}")
        above.legend()

        below.axhline(0, color="C0")
        below.plot(fit.load, fit.residuals, "o", ms=4, mfc="none", color="black")
        below.set(xlabel=f"normal load $P${unit('force')}", ylabel="residual" if fit.sigma is None else r"residual/$\sigma$")
        return saved(figure, file)


def _linear_to(load: Array) -> float:
    """Up to which magnitude the axis of loads is linear where some of them are <= 0."""
    positive = load[load > 0]
    return max(-float(load.min()), float(positive.min()) if positive.size else 0.0) or 1.0


def _loads(measured: Array, linear_to: float) -> Array:
    """Where to draw the curve."""
    lowest, highest = float(measured.min()), float(measured.max())
    if lowest > 0:
        return np.geomspace(lowest, highest, 200)
    light = np.linspace(lowest, min(linear_to, highest), 200)
    return np.concatenate([light, np.geomspace(linear_to, highest, 200)]) if highest > linear_to else light


def _with_error(value: float, error: float) -> str:
    """A value to the digits that its error leaves it."""
    digits = 1 if math.isinf(error) else 6
    if value != 0 and 0 < error < math.inf:
        digits = max(math.floor(math.log10(abs(value))) - math.floor(math.log10(error)) + 2, 1)
    return f"{value:.{digits}g} +- {error:.2g}"


def _correlation(covariance: Array) -> Array:
    deviation = np.sqrt(np.diag(covariance))
    deviation[~np.isfinite(deviation) | (deviation == 0)] = np.nan
    correlation: Array = covariance / np.outer(deviation, deviation)
    return correlation


def _and(names: Iterable[str]) -> str:
    *most, last = list(names) or [""]
    return f"{', '.join(most)} and {last}" if most else last
