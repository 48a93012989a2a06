"""How well friction is known where the parameters are known with an error: a curve with a band.

Linear from differences of models, or by as many models as are asked for with parameters drawn at random. The strength of the
interface is such a parameter, also if `spread` does not name it: by default, or by the error of the measurement that the
parameters were calibrated with.
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, NamedTuple

import numpy as np
import numpy.typing as npt

from .. import units
from .._friction_law import FrictionLaw
from ..errors import Error
from ..params import Params
from ..tools import checks
from ..tools.progress import Progress, teller
from ..tools.sparkline import is_wide
from ..tools.style import BLACK, saved, style
from .differences import log_slopes
from .many_surfaces import Block, Drawn, forces
from .names import STRENGTHS, FreeName, free_names, put_all
from .result import Fit

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

_LABELS = {"mu": "friction coefficient $F/P$", "force": "friction force $F$"}
# Surfaces drawn in vain for each one asked for, at most: more are refused where the spread leaves the domain.
_REFUSED = 2
# And drawn at all, for each one that the measurement leaves.
_UNLIKELY = 100
# A relative deviation of 2 is a factor of 7 either way, and with 95 % one of 50: what is known less is not known.
_WIDEST = 2.0
# No parameter is known to a millionth: 5e-10 is an error in metres.
_NARROWEST = 1e-6
# More surfaces than these take more than some seconds.
_MANY = 1000
# Surfaces that are drawn together, between two tellings of progress, and those of them that a worker is given at a time.
_TOGETHER, _BLOCK = 512, 16
# Of the logarithm of a default strength, of which 95 % lie within a factor of 10.
STRENGTH_DEVIATION = math.log(10) / 1.959963984540054
# What bands say that they rest on.
NOT_MEASURED = "strength of the interface: not measured, a factor 10 either way"
AS_GIVEN = "strength of the interface: as given"
ALL_ELSE = "all else: taken as known"
# Friction of which the strength makes less is hardly in doubt.
_LEAST_PART = 1e-6
# The name of the strength that a measurement sets.
_STRENGTH = "slip_stress"
# A calibrated model has the friction of the measurement to rounding; one whose surface was changed afterwards has not.
_SAME = 1e-8


@dataclass(frozen=True, eq=False)
class Uncertainty:
    """Friction with its band. Arrays are over the loads.

    Attributes:
        load: normal loads [force].
        value: friction coefficient or friction force [force] with the parameters as they are.
        low: lower end of the band.
        high: upper end of the band.
        deviation: standard deviation, relative to `value`.
        parts: name to the relative standard deviation that it causes alone, by the slopes of ln F.
        coverage: the probability that friction lies between `low` and `high`.
        quantity: "mu" or "force".
        samples: friction of the surfaces drawn, (surfaces, loads); None for the linear band.
        refused: surfaces that were drawn and that the library refused; others were drawn in their place.
        rests_on: what the band takes as known, and how well: the strength of the interface, each name, and that all else is known.
    """

    load: Array
    value: Array
    low: Array
    high: Array
    deviation: Array
    parts: dict[str, Array]
    coverage: float
    quantity: str
    samples: Array | None
    refused: int
    rests_on: tuple[str, ...]

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws curve and band over the load, with what the band rests on, below what each parameter contributes, and
        writes the figure if a file is named.

        The upper axis is logarithmic where the band spans more than a factor of 10.

        Args:
            file: its ending is its format, for example "band.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        with style():
            from matplotlib.figure import Figure

            figure = Figure(figsize=(7, 6), layout="constrained")
            above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (2, 1)})
            if (self.load > 0).all():
                above.set_xscale("log")
            above.fill_between(
                self.load, self.low, self.high, alpha=0.3, label="\n".join((f"{100 * self.coverage:g} %", *self.rests_on))
            )
            above.plot(self.load, self.value, color="C0")
            above.set_ylabel(_LABELS[self.quantity])
            above.legend(fontsize="small", loc="lower left", bbox_to_anchor=(0, 1))
            if is_wide(self.low, self.high):
                above.set_yscale("log")
            for name, part in self.parts.items():
                below.plot(self.load, 100 * part, label=name)
            below.plot(self.load, 100 * self.deviation, color=BLACK, label="all")
            below.set(xlabel="normal load $P$ [force]", ylabel="standard deviation [%]")
            below.legend(fontsize="small")
            return saved(figure, file)


def uncertainty(
    params: Params | Fit,
    spread: Mapping[str, float] | None = None,
    loads: npt.ArrayLike | None = None,
    *,
    quantity: str = "mu",
    samples: int = 0,
    seed: int = 0,
    coverage: float = 0.95,
    progress: Progress = None,
    executor: Executor | None = None,
) -> Uncertainty:
    """Friction at loads, with the band that follows from the spread of the parameters.

    >>> params = asperity.Params.paper()
    >>> band = asperity.uncertainty(params, {"slip_stress": 0.1}, loads=[100.0])
    >>> print(f"{band.high[0] / band.value[0]:.3f}")
    1.217

    What has no spread counts as known, also a slope that was assumed of a `process`, the hardness of a named material, and which
    specimen it is: the band of `asperity.friction` has the first, and what it prints the others.

    Positive parameters are distributed log-normally, the others normally, each by itself. The linear band
    follows from the slopes of ln F, and holds where the spread is small. For a wide spread set `samples`: 200 take
    about a second.

    A default strength of the interface (`Model.uncalibrated`) is taken as known to a factor of 10 either way, with a
    probability of 95 %: `slip_stress` then has a spread of 1.17 in its logarithm, unless `spread` names it.

    One measured point narrows the band by Bayes' rule: calibrate the parameters with it (`Params.calibrated`). The parameters are
    correlated afterwards, so that all of them together are known better than each. The linear band has the rule linearised; samples
    have it as it is: surfaces are drawn as they were known before the measurement, each is calibrated with a friction force within
    its error, and kept with the probability that the strength then has. If `spread` takes the strength as known, surfaces are kept
    with the probability that they give to the measurement.

    Surfaces that were changed after they were calibrated keep the strength. It then counts as known to the error of the
    measurement, independently of the roughness here: the roughness of the surface that was measured counts as known.

    Args:
        params: the surfaces; or a fit, which brings the spread of its parameters with it, correlations included: Student's where
            the scatter of its residuals gave their errors.
        spread: name to standard deviation, relative to the value for names that are positive (0.1 is 10 %; 1e-6 to 2, or 0),
            absolute for skew, radius_amplitude and pressure_coefficient. The names are those of `fit`, see `asperity.fits.names`. For calibrated
            parameters, how well they were known before the measurement. May be left out unless the strength of the interface
            is given without a measurement; `{"slip_stress": 0}` takes the strength as known.
        loads: normal loads [force], one-dimensional; > 0 for coefficients. By default those of the fit.
        quantity: "mu", the friction coefficient, or "force".
        samples: how many surfaces to draw; 0 for the linear band.
        seed: of the random numbers.
        coverage: probability of the band, between 0 and 1.
        progress: whether to tell how far the samples are, on the error stream, or a function of the part done, 0 to 1, and
            of what is being done; by default for more than a thousand.
        executor: where the samples are evaluated, by default here: anything with the interface of
            `concurrent.futures.Executor`, with the same result (docs/studies.md).

    Raises:
        Error: names, numbers or loads that cannot be used, or a surface that the library refuses (`Error`).
        TypeError: params is neither.
    """
    names, params, covariance, fit, measured, rests_on = _distribution(params, spread)
    loads = fit.load if fit is not None and loads is None else loads
    if loads is None:
        raise Error("loads: must be given")
    load = checks.one_or_more("loads", loads, units.unit("force", params.in_si))
    samples, seed = checks.whole("samples", samples, 0), checks.whole("seed", seed, 0)
    coverage = checks.share("coverage", coverage)
    _check(load, quantity, samples)

    values = np.array([name.start(params) for name in names])
    x = np.array([name.coordinate(value, value) for name, value in zip(names, values)])
    limits = [name.limits(value, None) for name, value in zip(names, values)]
    ends = [[name.coordinate(end, v) for name, end, v in zip(names, side, values)] for side in zip(*limits)]
    low, high = np.array(ends[0]), np.array(ends[1])

    def surfaces(at: Array) -> Params:
        return put_all(names, params, [name.value(float(a), float(v)) for name, a, v in zip(names, at, values)])

    with FrictionLaw(surfaces(x)) as law:
        force = law.friction_force_at_load(load)
    with_measured = np.append(load, params.calibration_load) if measured else load
    slopes = log_slopes(surfaces, x, low, high, lambda i: f"{names[i].given} = {values[i]:g}", with_measured)
    before = covariance
    if measured:
        slopes, at_measured = slopes[:-1], slopes[-1]
        covariance = _narrowed(covariance, at_measured, params.calibration_error)
    unit = load if quantity == "mu" else np.ones(load.shape)
    parts = {name.given: np.abs(slopes[:, i]) * math.sqrt(covariance[i, i]) for i, name in enumerate(names)}
    drawn, refused = None, 0
    if samples:
        from ..tools.blocks import completed

        random = np.random.default_rng(seed)
        varied = tuple(name.given for name in names)
        strengths = (i for i, name in enumerate(names) if measured and name.field == _STRENGTH and before[i, i] > 0)
        strength = next(strengths, None)

        def draw() -> Array | None:
            at = random.multivariate_normal(x, before)
            if fit is not None and fit.student is not None:
                at = x + (at - x) * math.sqrt(fit.student / random.chisquare(fit.student))
            by_measurement, luck = random.normal(0, params.calibration_error), random.random()
            if strength is not None:
                at[strength] = x[strength]
            if not ((low <= at) & (at <= high)).all():
                return None
            row = [name.value(float(a), float(v)) for name, a, v in zip(names, at, values)]
            return np.array([*row, params.calibration_friction_force * math.exp(by_measurement), luck])

        def is_kept(one: Drawn, luck: float) -> bool:
            """Whether a surface is left by the measurement."""
            if strength is not None:
                # Half, so that next to no rate is larger.
                part = 0.5 * one.rate / rate if rate > 1 else 1.0
                return luck < part * math.exp(-0.5 * math.log(one.strength) ** 2 / before[strength, strength])
            off = math.log(one.force[-1] / params.calibration_friction_force) / params.calibration_error if measured else 0.0
            return luck < math.exp(-0.5 * off**2)

        def evaluated(rows: list[Array]) -> tuple[list[Array], int]:
            table = np.array(rows)
            at = with_measured if strength is None else load
            parts = [(i, table[i : i + _BLOCK]) for i in range(0, len(rows), _BLOCK)]
            forced = [None if strength is None else part[:, -2] for _, part in parts]
            blocks = [(i, Block(params, varied, part[:, :-2], at, False, force)) for (i, part), force in zip(parts, forced)]
            by_first = dict(completed(forces, blocks, executor))
            answers = [one for first, _ in blocks for one in by_first[first]]
            kept = [one.force[: load.size] for one, row in zip(answers, rows) if one is not None and is_kept(one, float(row[-1]))]
            return kept, answers.count(None)

        rate = 1.0
        if strength is not None and params.pressure_coefficient > 0:
            (as_it_is,) = forces(Block(params, (), np.empty((1, 0)), load, False, np.array([params.calibration_friction_force])))
            rate = 1.0 if as_it_is is None else as_it_is.rate
        found, refused = _draw(draw, evaluated, samples, teller(progress, samples > _MANY, "asperity.uncertainty"))
        drawn = found / unit
        band = np.quantile(drawn, [0.5 - 0.5 * coverage, 0.5 + 0.5 * coverage], axis=0)
        deviation = np.std(drawn, axis=0) / np.where(force > 0, force / unit, 1)
    else:
        deviation = np.sqrt(np.einsum("li,ij,lj->l", slopes, covariance, slopes))
        from statistics import NormalDist

        reach = (NormalDist().inv_cdf(0.5 + 0.5 * coverage) if fit is None else fit.reach(coverage)) * deviation
        # What pressure adds is known: a strength that nobody measured scales the rest.
        by_strength = [slopes[:, i] for i, name in enumerate(names) if name.field == _STRENGTH and not measured and fit is None]
        part = np.clip(by_strength[0], _LEAST_PART, 1.0) if by_strength else np.ones(load.shape)
        band = force / unit * (1 - part + part * np.exp([-reach / part, reach / part]))
    return Uncertainty(load, force / unit, band[0], band[1], deviation, parts, coverage, quantity, drawn, refused, rests_on)


def _distribution(
    params: Params | Fit, spread: Mapping[str, float] | None
) -> tuple[tuple[FreeName, ...], Params, Array, Fit | None, bool, tuple[str, ...]]:
    """Names, parameters and the covariance of their coordinates before a measurement; the fit, if it is one; whether there is a
    measurement on these surfaces; in words."""
    if isinstance(params, Fit):
        if spread is not None:
            raise Error("spread: a fit brings its own; give fit.params for another")
        names = free_names(params.free, params.params)
        unit = np.array([name.per_coordinate(params.values[name.given]) for name in names])
        covariance = params.covariance / np.outer(unit, unit)
        if not np.isfinite(covariance).all():
            lost = ", ".join(name for name in params.free if math.isinf(params.errors[name]))
            raise Error(f"the fit does not determine {lost}: friction has no band; fit it without")
        fitted = f"a fit of {', '.join(params.free)} to {params.load.size} points"
        return names, params.params, covariance, params, False, (fitted,)
    if not isinstance(params, Params):
        raise TypeError(f"params = {params!r}: must be a Params or a Fit")
    given: Any = {} if spread is None else spread
    if not isinstance(given, Mapping):
        raise TypeError(f"spread = {given!r}: must be a mapping, {{name: standard deviation}}")
    try:
        given = {name: checks.real(f"spread of {name}", deviation) for name, deviation in given.items()}
    except TypeError as error:
        raise TypeError(f"{error}; 10 % are 0.1") from None
    for name, deviation in given.items():
        if not 0 <= deviation < math.inf:
            raise Error(f"spread of {name} = {deviation!r}: must be finite and >= 0")
    with FrictionLaw(params) as law:
        strength = strength_of(law)
    by_default = {} if given.keys() & set(STRENGTHS) or strength.deviation == 0 else {"slip_stress": strength.deviation}
    if not given and not by_default:
        raise Error(
            "spread: must name at least one parameter, {name: standard deviation}, since the strength of this interface is "
            "given; if it was measured, calibrate with the measurement: params.calibrated(load, friction_coefficient)"
        )
    known = {**given, **by_default}
    names = free_names(tuple(known), params)
    for one in names:
        deviation = given.get(one.given, 0)
        if one.positive and deviation != 0 and not _NARROWEST <= deviation <= _WIDEST:
            meant = f"{deviation:g} % are {deviation / 100:g}" if 1 < deviation <= 100 else "divide an error in units by the value"
            raise Error(
                f"spread of {one.given} = {deviation!r}: is relative to the value and must be at most {_WIDEST:g}, and 0 or at "
                f"least {_NARROWEST:g}; {meant}"
            )
    told = tuple(
        f"{one.given}: {100 * given[one.given]:.3g} %" if one.positive else f"{one.given}: {given[one.given]:.3g}"
        for one in names
        if one.given in given
    )
    covariance = np.diag([float(deviation) ** 2 for deviation in known.values()])
    rests_on = AS_GIVEN if strength.told == NOT_MEASURED and not by_default else strength.told
    return names, params, covariance, None, strength.measured, (rests_on, *told, ALL_ELSE)


class Strength(NamedTuple):
    """How well the strength of an interface is known.

    Attributes:
        deviation: standard deviation of its logarithm, before a measurement on these surfaces if there is one.
        measured: whether friction was measured on these surfaces, which narrows it.
        told: the same in words.
    """

    deviation: float
    measured: bool
    told: str


def strength_of(law: FrictionLaw) -> Strength:
    """How well the strength of a law is known without more ado."""
    params = law.params
    load, force, error = params.calibration_load, params.calibration_friction_force, 100 * params.calibration_error
    if force > 0:
        at = f"{load:g} {'N' if params.in_si else '[force]'} to {error:.3g} %"
        if abs(law.friction_force_at_load(load) - force) <= _SAME * force:
            return Strength(STRENGTH_DEVIATION, True, f"strength of the interface: measured at {at}")
        return Strength(params.calibration_error, False, f"strength of the interface: measured on another surface, at {at}")
    return Strength(STRENGTH_DEVIATION, False, NOT_MEASURED) if law.uncalibrated else Strength(0.0, False, AS_GIVEN)


def _narrowed(covariance: Array, slopes: Array, error: float) -> Array:
    """The covariance after a force was measured whose logarithm has these slopes and this standard deviation."""
    together = covariance @ slopes
    narrowed: Array = covariance - np.outer(together, together) / (slopes @ together + error**2)
    return narrowed


def _check(load: Array, quantity: str, samples: int) -> None:
    if checks.word("quantity", quantity, _LABELS) == "mu" and not (load > 0).all():
        raise Error('loads: must be > 0 for coefficients, since F/P has no finite value there; quantity="force" has')
    if samples == 1:
        raise Error(f"samples = {samples!r}: must be 0, for the linear band, or a whole number from 2 on")


def _draw(
    draw: Callable[[], Array | None],
    evaluated: Callable[[list[Array]], tuple[list[Array], int]],
    samples: int,
    tell: Callable[[float, str], None],
) -> tuple[Array, int]:
    """Forces of so many surfaces, and how many were refused on the way.

    No more are drawn at a time than are still wanted, so that the surfaces are the same however many are evaluated together.
    """
    found: list[Array] = []
    refused = tried = 0
    while len(found) < samples:
        tell(len(found) / samples, "surfaces drawn")
        wanted = min(samples - len(found), _TOGETHER)
        rows = [row for row in (draw() for _ in range(wanted)) if row is not None]
        kept, not_evaluated = evaluated(rows) if rows else ([], 0)
        found += kept
        tried += wanted
        refused += wanted - len(rows) + not_evaluated
        if refused > _REFUSED * samples:
            raise Error(f"spread: {refused} of {tried} surfaces drawn are refused; make it smaller")
        if tried > _UNLIKELY * samples:
            raise Error(
                f"spread: of {tried} surfaces drawn {len(found)} have the friction that was measured; make it smaller, or leave the "
                "strength of the interface free"
            )
    tell(1.0, "surfaces drawn")
    return np.array(found), refused
