"""Parameters from a measured friction curve: least squares, with errors and with what the data cannot tell.

`fit` varies some parameters of a `Params` until the model's friction comes closest to the measured one. It needs SciPy
(extra `fit`), `Fit.plot` matplotlib (extra `plot`). The names that can be varied are in `fits.names`.
"""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import combinations
from typing import Any, Mapping, Sequence

import numpy as np
import numpy.typing as npt

from .._friction_law import FrictionLaw
from ..errors import Error
from ..params import Params
from ..tools import checks
from . import robust
from .differences import STEP
from .names import PRESSURE, free_names
from .result import End, Estimate, Fit
from .search import Data, Search
from .trend import trends

Array = npt.NDArray[np.float64]

# Correlations above this are named: the data fix a combination of the two far better than either.
_CORRELATED = 0.99
# A fit with sigma this improbable is called a bad one.
_IMPROBABLE = 1e-3
# Standard errors to either end of a 95 % band of the normal distribution; one that is so many times wider is told.
_NORMAL_REACH = 1.96
_WIDER = 1.1
# Trial steps of the search at most; a narrow, curved valley of chi-square takes some fifty.
_STEPS = 200
# So far from its bounds a search starts: at a bound its first steps would be too short to change anything.
_INSIDE = 0.01

# Ends of searches whose losses differ by less than this part are one minimum.
_SAME = 1e-3
# Scales of residuals that a robust fit goes through at most, and the least: those of a perfect fit have none.
_SCALES, _LEAST_SCALE = 30, 1e-300


def fit(
    load: npt.ArrayLike,
    mu: npt.ArrayLike | None = None,
    sigma: npt.ArrayLike | None = None,
    free: Sequence[str] = ("gamma", "sigma"),
    *,
    params: Params,
    force: npt.ArrayLike | None = None,
    bounds: Mapping[str, tuple[float, float]] | None = None,
    loss: str = "linear",
    starts: int = 1,
    seed: int = 0,
) -> Fit:
    """Parameters of two surfaces, fitted to measured friction by weighted least squares, with their errors: a `Fit`.

    >>> params = asperity.Params.paper()
    >>> load = [10.0, 30.0, 100.0, 300.0]
    >>> measured = 0.5 * asperity.Model(params).friction_at_load(load)  # half the default strength
    >>> found = asperity.fit(load, measured, free=["slip_stress"], params=params)
    >>> print(f"{found.params.slip_stress_1 / params.slip_stress_1:.3f}")
    0.500

    The search starts at `params` and uses trust regions (SciPy's `least_squares`), in the logarithm of all positive
    parameters. It steps back from trial surfaces that the library refuses. It finds the minimum near the start. Where there
    may be several minima, start from what is known of the surface, or set `starts`.

    A name counts as not identifiable if a change of it, alone or compensated by others, does not change the friction. It
    also does if its standard error is at least its value (names searched in the logarithm), or at least the standard
    deviation of a uniform distribution between its bounds: the data then say no more than the bounds.

    Args:
        load: normal loads [force], one-dimensional; points of which a number is masked are left out. For `mu` they must be > 0; friction forces may be given at zero
            and negative loads too. There a trial surface whose pull-off load lies above has no friction.
        mu: measured friction coefficients F/P > 0 at them; `max_friction_coefficient` plays no part.
        sigma: standard errors > 0 of the measured friction, one for all or one for each. Without, all points weigh
            the same, and the errors of the parameters are scaled by the scatter of the residuals: of few points bands are
            Student's then (`Fit.reach`).
        free: names of the parameters to be found, at least one. Each may be a field of `Params` or a symbol of the
            paper: see `asperity.fits.names`. All others stay as they are in `params`.
        params: where the search starts, and the parameters that are known.
        force: measured friction forces F >= 0 [force], instead of `mu`.
        bounds: lowest and highest value for some of the free names. By default a positive name stays within a factor
            of 1000 of its start, the others in their domains.
        loss: "linear" for least squares; "soft_l1", "huber" or "cauchy" where some points are
            outliers: residuals beyond about one sigma then count less and less, in this order. Without sigma that of most
            residuals is taken. Errors are those of the loss.
        starts: number of starting points: `params`, and others at random, within a factor of 10 of it for
            positive names. The best end is taken; the message says how many came to it.
        seed: of the random starting points.

    Returns:
        The fit. Read its `message`, or print it: it says what the data do not determine.

    Raises:
        Error: data, names or bounds that cannot be used, or a start that the library refuses (`Error`); the
            message says what is allowed.
        ImportError: SciPy is missing.
    """
    try:
        from scipy.optimize import least_squares
    except ImportError as error:
        raise ImportError(f"fit needs SciPy ({error}): pip install scipy") from None

    checks.instance("params", params, Params)
    starts, seed = checks.whole("starts", starts, 1), checks.whole("seed", seed, 0)
    names = free_names(free, params)
    data = Data.of(load, mu, force, sigma, params.in_si)
    if data.load.size <= len(names):
        raise Error(
            f"{data.load.size} points for {len(names)} free names: there must be more points than free names"
        )
    search = Search.of(names, params, data, checks.instance("bounds", {} if bounds is None else bounds, Mapping))
    search.friction(search.start)  # the library's own message if it refuses the start
    checks.word("loss", loss, robust.LOSSES)

    def minimum(start: Array, loss: str, unit: float) -> Any:
        ends = (search.low, search.high)
        inside = np.minimum(_INSIDE, 0.1 * (search.high - search.low))
        return least_squares(
            search.residuals, np.clip(start, search.low + inside, search.high - inside), search.jacobian, ends, method="trf", loss=loss, f_scale=unit, max_nfev=_STEPS
        )

    found, tried = _best(minimum, search, starts, np.random.default_rng(seed))
    unit = 1.0
    if loss != "linear" and data.sigma is not None:
        found = minimum(found.x, loss, unit)
    elif loss != "linear":
        # The scale is that of most residuals, which a better fit makes smaller: in turns, until it stays.
        for _ in range(_SCALES):
            last, unit = unit, max(robust.scale(search.residuals(found.x)), _LEAST_SCALE)
            if abs(unit - last) < 0.01 * unit:
                break
            found = minimum(found.x, loss, unit)
    return _judge(search, found.x, bool(found.success), loss, unit, tried)


def _best(minimum: Any, search: Search, starts: int, random: np.random.Generator) -> tuple[Any, list[float]]:
    """The best end of searches from several places, and the sums of squares of all ends."""
    best, ends = None, []
    for i in range(starts):
        try:
            found = minimum(search.start if i == 0 else search.random_start(random), "linear", 1.0)
        except ValueError:  # a random place of surfaces that the library refuses
            if i == 0:
                raise
            ends.append(math.inf)
            continue
        ends.append(2 * float(found.cost))
        if best is None or found.cost < best.cost:
            best = found
    return best, ends


def _judge(search: Search, x: Array, success: bool, loss: str, scale: float, ends: list[float]) -> Fit:
    """Values, errors and what is to be said against them, at the end of a search."""
    data, names = search.data, search.names
    fitted, residuals = search.friction(x), search.residuals(x)
    chi_square, freedom = float(residuals @ residuals), residuals.size - x.size
    if loss == "linear":
        scatter, student = (1.0, None) if data.sigma is not None else (chi_square / freedom, float(freedom))
    else:
        scatter = robust.variance(loss, residuals, scale, x.size)
        student = robust.freedom(loss, residuals, scale, x.size)
    estimate = Estimate.of(search.exact_jacobian(x), float(np.linalg.norm(fitted * data.weight)), scatter)

    values = search.values(x)
    unit = np.array([name.per_coordinate(value) for name, value in zip(names, values)])
    deviation = np.sqrt(np.diag(estimate.covariance))
    # Past these a linear estimate in the coordinates of the search says nothing any more.
    useful = np.minimum([1.0 if name.positive else math.inf for name in names], (search.high - search.low) / 12**0.5)
    given = tuple(name.given for name in names)
    fit = Fit(
        params=search.surfaces(x),
        free=given,
        values=dict(zip(given, values)),
        errors=dict(zip(given, (deviation * unit).tolist())),
        covariance=estimate.covariance * np.outer(unit, unit),
        chi_square=chi_square,
        degrees_of_freedom=freedom,
        unidentifiable=tuple(name for name, good in zip(given, deviation < useful) if not good),
        at_bound=tuple(
            name for name, at, low, high in zip(given, x, search.low, search.high) if min(at - low, high - at) < STEP
        ),
        success=success,
        message="",
        load=data.load,
        measured=data.measured,
        fitted=fitted,
        sigma=data.sigma,
        quantity=data.quantity,
        loss=loss,
        dimensions={name.given: name.dimension for name in names},
        _end=End(search, x, estimate, student),
    )
    far = int(np.count_nonzero(np.abs(residuals) > robust.FAR * scale)) if loss != "linear" else 0
    return replace(fit, message="\n".join([*_remarks(fit, estimate), *_remarks_on_search(loss, far, ends)]))


def _remarks_on_search(loss: str, far: int, ends: list[float]) -> list[str]:
    """Of points far off, and of several starts."""
    remarks = []
    if loss != "linear":
        remarks.append(f"loss {loss}: {far} points are more than {robust.FAR:g} standard errors off and count little")
    if len(ends) > 1:
        best = min(ends)
        reached = sum(end <= best * (1 + _SAME) + 1e-300 for end in ends)
        others = sorted({f"{end:.3g}" for end in ends if end > best * (1 + _SAME) + 1e-300 and math.isfinite(end)}, key=float)
        remarks.append(
            f"{reached} of {len(ends)} starts end here"
            + (f"; others at minima that fit worse, with sums of squares {', '.join(others[:5])} for {best:.3g}" if others else "")
        )
    return remarks


def _remarks(fit: Fit, estimate: Estimate) -> list[str]:
    """How the search ended, and then what is to be said against the result."""
    varied = {field for name in free_names(fit.free, fit.params) for field in name.varies}
    reduced = fit.reduced_chi_square
    spread = f"residuals scatter by {fit.scatter:.3g}" if reduced is None else f"reduced chi-square {reduced:.3g}"
    spread += f", {fit.degrees_of_freedom} degrees of freedom"
    remarks = [f"{'converged' if fit.success else f'not converged in {_STEPS} steps'}; {spread}"]
    for name in fit.unidentifiable:
        others = estimate.partners(fit.free, name)
        if others:
            why = f"a change of it is made up for by {others}"
        elif math.isinf(fit.errors[name]):
            why = "it does not change the friction here"
        else:
            why = "it hardly changes the friction here"
        remarks.append(f"not identifiable: {name}; {why}")
    for i, j in combinations(range(len(fit.free)), 2):
        one, other, correlation = fit.free[i], fit.free[j], fit.correlation[i, j]
        if abs(correlation) > _CORRELATED and not {one, other} & set(fit.unidentifiable):
            remarks.append(f"correlated by {correlation:.4f}: {one} and {other}; a combination of them is known better")
    for name in fit.at_bound:
        remarks.append(f"at a bound: {name} = {fit.values[name]:.6g}; the data would have it beyond")
    if fit.sigma is not None and fit.loss == "linear" and _improbable(fit):
        remarks.append("the residuals are larger than sigma explains: the model, or sigma, is wrong")
    if fit.reach() > _WIDER * _NORMAL_REACH:
        remarks.append(f"errors are from the scatter of few points: a 95 % band has {fit.reach():.3g} of them to either side")
    remarks += trends(fit.load, fit.residuals, fit.measured if fit.sigma is None else fit.measured / fit.sigma, PRESSURE in varied)
    remarks += _remark_on_strength(fit)
    if (fit.load <= 0).any():
        with FrictionLaw(fit.params) as law:
            pull_off = law.summary().pull_off_load
        apart = int(np.count_nonzero(fit.load < pull_off))
        if not apart:
            return remarks
        remarks.append(f"{apart} loads are below the fitted pull-off load, {pull_off:.4g}: no friction there")
    return remarks


def _remark_on_strength(fit: Fit) -> list[str]:
    """What the data say about the strength of the interface, or that it was not measured."""
    if fit.calibrated:
        now = [f"{name} = {getattr(fit.params, name):.6g}" for name in ("slip_stress_1", "slip_stress_2")]
        return [f"calibrated by the data: {', '.join(fit.calibrated)}; {', '.join(now)} of G*"]
    says = "not calibrated: the strength of the interface is the default, not a measured one; free slip_stress to fit it"
    with FrictionLaw(fit.params) as law:
        return [says] if law.uncalibrated else []


def _improbable(fit: Fit) -> bool:
    from scipy.stats import chi2

    return bool(chi2.sf(fit.chi_square, fit.degrees_of_freedom) < _IMPROBABLE)
