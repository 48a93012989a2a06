"""From a measured map to a friction coefficient and a verdict on the map, in one call."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Iterable, NamedTuple

import numpy as np
import numpy.typing as npt

from .._surface_text import text_of_values, without_line
from ..errors import Error
from ..estimate import Estimate, estimate
from ..materials import Pair
from ..one_line import of_pair
from ..params import Params, counted_of, moments_of
from ..results import Warnings
from ..tools import checks
from ..tools.progress import Progress
from . import map_warnings
from .cleaning import Cleaned, clean, holes
from .cutoffs import Cutoffs, table
from .filter import filter, noise_slope
from .gaussian import from_gaussian
from .input import MOST_DEGREE, checked, degree
from .instrument_files import HeightMap, implausible
from .rows import offsets
from .spikes import particles, spikes as spikes_of
from .summit_search import without_polynomial
from .summit_statistics import summits
from .summits import Summits

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .._surface_text import Joint

FAMILIES = ("gaussian", "weibull", "johnson", "tabulated")

# A polynomial that takes this part of the mean square away is the form of the specimen. On pieces of self-affine surfaces of Hurst
# exponents 0.8 and 1 one of degree 2 takes at most 0.74 (40 surfaces each), and one of degree 5 at most 0.93, so that is not tried.
_FORM, _FORM_DEGREE = 0.9, 2
# Filtered with 6 points a wave, maps of which fewer neighbours have one height have slopes within 3 %; at 0.9 they are 15 % off.
_EQUAL = 0.8
_MISSING = 0.05
# Noise with this part of the mean square slope; with a third of it friction is 9 % too low.
_NOISE = 0.1
# Boundary elements were computed up to here (docs/validation.md).
_BANDWIDTH = 300.0
# Spectra as narrow as this have summits that theory of moments does not know; fewer waves a side are no statistics.
_NARROW, _WAVES = 3.0, 8.0
# Counted summits of broader spectra stand on each other, and have too little area.
_BROAD = 6.0
# Summits whose families of heights give friction that differs by more than this factor are not described by any of them.
_FAMILY = 1.4
# So many standard errors of skew or kurtosis are no chance.
_SIGNIFICANT = 3.0
# More than this either way, at 95 %, is no number.
_LOST = 3.0
# What `check` says of the interface, which the band has; and what the map's own findings say better.
_SAID = Warnings.UNCALIBRATED | Warnings.STRONG | Warnings.FEW_WAVES


class Finding(NamedTuple):
    """What speaks against a map.

    Attributes:
        kind: "form", "rows", "spikes", "missing", "steps", "dust", "noise", "direction", "waves", "bandwidth", "heights", "cutoff",
            "contact", "friction" or "map".
        says: what is wrong.
        remedy: what to do about it.
        fatal: whether no friction coefficient of this map can be used.
    """

    kind: str
    says: str
    remedy: str
    fatal: bool = False

    def __str__(self) -> str:
        return f"{self.kind}: {self.says}: {self.remedy}"


@dataclass(frozen=True, eq=False, repr=False)
class Analysis:
    """What a map says of friction, and whether to believe it. `print(analysis)` says all of it.

    Attributes:
        load: the load [N].
        value: friction coefficient; NaN if none could be computed.
        low: lower end of the band: strength of the interface, and `spread` of the map.
        high: upper end.
        coverage: probability of the band.
        spread: standard deviations of ln(mu) of the map alone, by "sampling" (one map of the surface), "cutoffs" and "heights".
        findings: what speaks against the map, each with its remedy; empty if it is usable.
        steps: what was done, in order.
        families: friction coefficient by the family of the heights of counted summits; NaN where the family has none such.
        counted: whether friction is that of the counted summits, not of the moments.
        cleaned: the map without form, offsets of lines, spikes and holes; None if it could not be.
        cutoffs: friction against the cutoff of the S-filter; None likewise.
        summits: of the filtered map; None likewise.
        estimate: friction as `asperity.friction` gives it, whose band has only the strength of the interface; None likewise.
        params: the surface, for `Model`, whose friction is `estimate.curve`; None likewise.
    """

    load: float
    value: float = math.nan
    low: float = math.nan
    high: float = math.nan
    coverage: float = 0.95
    spread: dict[str, float] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    steps: tuple[str, ...] = ()
    families: dict[str, float] = field(default_factory=dict)
    counted: bool = False
    cleaned: Cleaned | None = None
    cutoffs: Cutoffs | None = None
    summits: Summits | None = None
    estimate: Estimate | None = None
    params: Params | None = None

    @property
    def usable(self) -> bool:
        """Whether nothing speaks against the map."""
        return not self.findings

    @property
    def verdict(self) -> str:
        """ "usable", "usable if ..." or "not usable because ...", each with remedies."""
        if not self.findings:
            return "usable"
        fatal = [one for one in self.findings if one.fatal]
        if fatal:
            return f"not usable because {'; and '.join(map(str, fatal))}"
        return f"usable if {'; and if '.join(map(str, self.findings))}"

    def __float__(self) -> float:
        return self.value

    def __repr__(self) -> str:
        lines = [*self.steps]
        if math.isfinite(self.value):
            band = f"{self.coverage:.0%} band {self.low:.3g} to {self.high:.3g}"
            parts = ", ".join(f"{name} {deviation:.0%}" for name, deviation in self.spread.items())
            law = math.nan if self.estimate is None else float(self.estimate.curve)
            off = "" if f"{law:.3g}" in (f"{self.value:.3g}", "nan") else f"; Model(params) has {law:.3g}"
            lines.append(f"friction: mu({self.load:g} N) = {self.value:.3g}, {band}; of the map: {parts}{off}")
        return "\n".join([*lines, f"verdict: {self.verdict}"])


def analyse(
    height_map: Any,
    load: float,
    dx: float | None = None,
    dy: float | None = None,
    *,
    pair: str | Pair | None = None,
    nominal_area: float | None = None,
    detrend: int = 1,
    rows: bool | None = None,
    spikes: bool = True,
    dust: bool = False,
    cutoff: float | None = None,
    longest: float | None = None,
    counted: bool | None = None,
    coverage: float = 0.95,
    progress: Progress = None,
    **surface: Unpack[Joint],
) -> Analysis:
    """A friction coefficient with its band, and a verdict: from a map as the instrument gave it, in SI units.

    >>> analysis = surface.analyse(surface.read("scan.gwy"), 1e-3, pair="Si/Si")
    >>> print(analysis)

    In this order: form is removed (`detrend`), lines of the scan aligned, spikes replaced until there are none, missing points filled,
    steps of the heights looked for, waves longer than `longest` and shorter than the recommended cutoff filtered away, isotropy
    looked at, and friction computed: from the mean squares of heights and slopes, or from the summits, one by one, where the spectrum is
    narrow, with a bandwidth below 3, or below 6 with less than 8 waves a side. Where summits yield, the contact law is elastic-plastic, as in `asperity.friction`. The band has the
    strength of the interface, what another map of the surface would give, cutoffs from half to twice the one taken, and the
    families of the heights of summits.

    Args:
        height_map: as for `clean`, in metres.
        load: normal load > 0 [N], of the nominal area.
        dx: distance of columns [m], where the map has none.
        dy: distance of rows; by default dx.
        pair: of materials, as for `asperity.friction`; or their numbers in `surface`: `E1`, `nu1`, ...
        nominal_area: of the contact [m^2]; by default that of the map.
        detrend: degree of the polynomial that is taken for the form, 0 to 8.
        rows: whether lines of the scan are aligned; by default if they are offset.
        spikes: whether spikes are replaced.
        dust: whether particles are replaced.
        cutoff: of the S-filter [m]; by default the recommended one.
        longest: of the L-filter [m]: longer waves are removed; by default none.
        counted: whether friction is that of the counted summits.
        coverage: probability of the band, between 0 and 1.
        progress: as for `summits`.
        **surface: keys of surface files but for the roughness: `measured`, `interface`, `hardness`, `work_of_adhesion`, ...

    Raises:
        Error: a load, degree or coverage that cannot be, or what the library refuses of `surface`. What is wrong with the map is
            in the findings.
        TypeError: no real numbers; distances missing, or given twice; a keyword that surface files do not have.
        ImportError: SciPy is not installed.
    """
    load = checks.positive("load", load, "N")
    degree(detrend)
    coverage = checks.share("coverage", coverage)
    cutoff, longest = (None if one is None else checks.positive(name, one, "m") for name, one in (("cutoff", cutoff), ("longest", longest)))
    case = _Case(load, coverage, ({} if pair is None else dict(of_pair(pair))) | {"coverage": coverage} | dict(surface))
    # What the map cannot be blamed for is refused at once, of a plain surface.
    case.at(1e5, {"nominal_area": 1.0, "m0": 1e-16, "m2": 1e-2, "m4": 1e13}, surface)
    try:
        raw = replace(checked(height_map, dx, dy, missing=True), unit="m")
    except Error as error:
        if not f"{error}".startswith("height_map"):
            raise
        return case.stopped(error)
    try:
        if (wrong := implausible(raw)) is not None:
            return case.stopped(Error(wrong.partition(": ")[0] + ": give heights and distances in metres"), "units")
        cleaned = _cleaned(case, raw, detrend, rows, spikes, dust, progress)
    except ValueError as error:
        return case.stopped(error)
    map_ = cleaned.map
    extent = map_.height_map.size * map_.dx * map_.dy
    case.joint["nominal_area"] = extent if nominal_area is None else checks.real("nominal_area", nominal_area, "m^2")
    try:
        found = _filtered(case, map_, cutoff, longest, progress)
    except ValueError as error:
        return case.stopped(error, cleaned=cleaned)
    left = found.summits[found.at]
    assert left is not None
    waves = math.sqrt(extent) / (2 * math.pi * math.sqrt(left.moments.m0 / left.moments.m2))
    _judged(case, left, found, waves, cleaned)
    bandwidth = left.moments.bandwidth
    taken = bandwidth < _NARROW or (waves < _WAVES and bandwidth < _BROAD) if counted is None else counted
    families = {name: case.friction_of(counted_of(left, name)) for name in FAMILIES}
    known = {"cleaned": cleaned, "cutoffs": found, "summits": left, "families": families, "counted": taken}
    try:
        number = case.at(load, counted_of(left, "gaussian") if taken else moments_of(left))
    except ValueError as error:
        return case.stopped(error, "friction", **known)
    case.steps += [
        f"by {'counted summits' if taken else 'moments'}: bandwidth {bandwidth:.3g}, {waves:.2g} waves a side",
        "heights: " + ", ".join(f"{name} {mu:.3g}" for name, mu in families.items()),
        "contact: elastic-plastic" if number.params.contact_law == "elastic-plastic" else "contact: elastic, with adhesion",
    ]
    spread = _spread(case, left, found, families)
    if not any(one.kind == "dust" for one in case.findings):
        _judged_heights(case, left, families, filter(map_, found.cutoff[found.at]).height_map)
    _judged_contact(case, number, found, chosen=cutoff is not None, extended=nominal_area is not None)
    _judged_friction(case, float(number), math.hypot(*spread.values()))
    return case.answered(number, spread, **known)


@dataclass
class _Case:
    """What is asked of a map, and what was done and found so far.

    Attributes:
        load: [N].
        coverage: of the band.
        joint: the keys of a surface file but for the roughness.
        steps: what was done.
        findings: what speaks against the map.
    """

    load: float
    coverage: float
    joint: dict[str, Any]
    steps: list[str] = field(default_factory=list)
    findings: list[Finding] = field(default_factory=list)

    def found(self, kind: str, says: str, remedy: str, fatal: bool = False) -> None:
        """Adds a finding."""
        self.findings.append(Finding(kind, says, remedy, fatal))

    def measure(self, other: str, how: str = "once") -> str:
        """The remedy of a measurement; another one where friction was measured."""
        if {"measured", "calibration_load"} & self.joint.keys():
            return other
        return f"measure friction {how}, and give measured=(load, coefficient); or {other}"

    def at(self, load: float, rough: dict[str, Any], keywords: Iterable[str] = ()) -> Estimate:
        """The estimate of a roughness at a load; an unknown key is a wrong argument if it is one of the keywords."""
        try:
            return estimate(text_of_values(self.joint | rough), load, self.coverage)
        except Error as error:
            raise without_line(error, keywords) from None

    def friction_of(self, rough: dict[str, Any]) -> float:
        """That of a model, the mean of many specimens; NaN where the library has none."""
        try:
            return float(self.at(self.load, rough).curve)
        except ValueError:
            return math.nan

    def stopped(self, error: Exception, kind: str = "map", **known: Any) -> Analysis:
        """The answer where no friction can be had."""
        says, _, remedy = str(error).removeprefix("height_map: ").partition(": ")
        self.found(kind, says, remedy or "measure a larger or finer map", True)
        return Analysis(self.load, coverage=self.coverage, findings=tuple(self.findings), steps=tuple(self.steps), **known)

    def answered(self, number: Estimate, spread: dict[str, float], **known: Any) -> Analysis:
        """The answer, whose band has the spread of the map beside that of the strength."""
        from statistics import NormalDist

        reach = NormalDist().inv_cdf((1 + self.coverage) / 2)
        strength = 0.0 if number.low is None else math.log(number.high / number.low) / 2
        value, factor = float(number), math.exp(math.hypot(strength, reach * math.hypot(*spread.values())))
        return Analysis(
            self.load, value, value / factor, value * factor, self.coverage, spread, tuple(self.findings), tuple(self.steps),
            estimate=number, params=number.params, **known,
        )  # fmt: skip


def _filtered(case: _Case, map_: HeightMap, cutoff: float | None, longest: float | None, progress: Progress) -> Cutoffs:
    """The map within its cutoffs, with what friction is at each of the shorter one."""
    if longest is not None:
        map_ = filter(map_, longest=longest)
        case.steps.append(f"L-filter: waves longer than {longest:.3g} m removed")

    def of_moments(left: Summits) -> tuple[Params, float]:
        number = case.at(case.load, moments_of(left))
        return number.params, float(number)

    found = table(map_, case.load, None if cutoff is None else [cutoff], of_moments, progress)
    at, left = found.cutoff[found.at], found.summits[found.at]
    assert left is not None
    case.steps.append(f"S-filter: cutoff {at:.3g} m, {at / found.step:.3g} points, {left.count} summits")
    return found


def _cleaned(
    case: _Case, raw: HeightMap, detrend: int, rows: bool | None, spikes: bool, dust: bool, progress: Progress
) -> Cleaned:
    """The map without form, offsets, spikes and holes."""

    def cleaned(spikes: bool) -> Cleaned:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", map_warnings.MapWarning)
            return clean(raw, detrend=detrend, rows=rows is not False, spikes=spikes, dust=dust, progress=progress)

    try:
        found = cleaned(spikes)
    except ValueError as error:
        if "too many for spikes" not in str(error):
            raise
        says = str(error).removeprefix("height_map: ").partition(":")[0]
        case.found("spikes", says, "if the surface is like that, give spikes=False; if not, measure again")
        found = cleaned(False)
    level = found.map.height_map
    ny, nx = level.shape
    case.steps.append(f"form: polynomial of degree {detrend} removed from {ny} x {nx} points")
    m0 = float(np.var(level))
    for higher in range(detrend + 1, min(detrend + _FORM_DEGREE, MOST_DEGREE, min(level.shape) - 2) + 1):
        rest = without_polynomial(level, higher)
        if np.var(rest) < (1 - _FORM) * m0:
            height = float(np.ptp(level - rest))
            share = 1 - float(np.var(rest)) / m0
            says = f"a polynomial of degree {higher}, {height:.2g} m high, has {share:.1%} of the mean square of the heights"
            case.found("form", says, f"give detrend={higher}")
            break
    if found.offsets:
        case.steps.append(f"rows: lines aligned, offsets of {found.offsets:.2g} m; if these are grooves give rows=False")
    elif rows is False and offsets(level) is not None:
        case.found("rows", "lines of the scan are offset from each other", "give rows=True, unless these are grooves")
    case.steps.append(f"spikes: {found.spikes} replaced" if spikes else "spikes: left")
    if not spikes and (count := int(spikes_of(level).sum())):
        case.found("spikes", f"{count} points stand out like spikes of an instrument", "give spikes=True")
    case.steps.append(f"missing: {found.missing} points filled")
    if found.missing > _MISSING * level.size and holes(found.filled):
        part = found.missing / level.size
        case.found("missing", f"{part:.0%} of the points are missing, in holes", "crop the map to what was measured")
    if dust:
        case.steps.append(f"dust: {found.particles} particles replaced")
    elif spikes and (count := particles(level)[1]) > 0:
        says = f"places higher than 8 times what is usual in the map, {count} of them, carry the load"
        case.found("dust", says, f"if they are dust, give dust=True; if not, {case.measure('measure a larger map')}")
    if found.steps is not None:
        case.steps.append(f"steps: heights are in steps of {found.steps.step:.2g} m, {found.steps.equal:.0%} of neighbours have one height")
        if found.steps.equal > _EQUAL:
            says = f"heights are in steps of {found.steps.step:.2g} m, coarser than the surface"
            case.findings[:] = [one for one in case.findings if one.kind != "spikes"]  # the edges of steps
            case.found("steps", says, "measure with a finer range of heights")
    return found


def _judged(case: _Case, left: Summits, found: Cutoffs, waves: float, cleaned: Cleaned) -> None:
    """What speaks against a filtered map."""
    case.steps.append(f"isotropy: {left.isotropy:.2f}; Sq {left.rms_height} m, Sdq {left.rms_slope}")
    cutoff = float(found.cutoff[found.at])
    deviation = map_warnings.noise(map_warnings.differences(cleaned.map.height_map))
    if deviation is not None:
        case.steps.append(f"noise: of {deviation:.2g} m before the filter")
        part = noise_slope(deviation, cutoff, left.dx, left.dy) / left.iso.Sdq**2
        if part > _NOISE:
            longer = cutoff * (part / _NOISE) ** 0.25
            says = f"of {deviation:.2g} m, has {min(part, 1.0):.0%} of the mean square slope after the filter"
            case.found("noise", says, f"give cutoff={longer:.2g}, or average several scans")
    if left.isotropy < map_warnings.ISOTROPIC:
        says = f"isotropy {left.isotropy:.2f}: the surface has grooves, and the model one radius for a summit"
        case.found("direction", says, case.measure("compare with counted=True", "once in the direction of sliding"))
    if waves < _WAVES:
        case.found("waves", f"only {waves:.2g} mean waves a side: one place is not like another", "measure a larger map")
    if left.moments.bandwidth > _BANDWIDTH:
        says = f"bandwidth {left.moments.bandwidth:.4g}, where boundary elements reach {_BANDWIDTH:g}"
        about = 20 * cutoff
        case.found("bandwidth", says, f"give longest={about:.2g} if waves longer than the contact do not matter, or detrend=2")


def _judged_heights(case: _Case, left: Summits, families: dict[str, float], level: npt.NDArray[np.float64]) -> None:
    """Whether the heights of the summits are of a family, beyond what chance makes of those of a Gaussian surface."""
    known = [mu for mu in families.values() if math.isfinite(mu)]
    if len(known) > 1 and max(known) < _FAMILY * min(known) or from_gaussian(level) < _SIGNIFICANT:
        return
    among = f"mu is {', '.join(f'{mu:.2g} ({name})' for name, mu in families.items())}"
    says = f"summits are not Gaussian, skew {left.skew.value:.2g}, kurtosis {left.kurtosis.value:.3g}, and {among}"
    case.found("heights", says, case.measure("look for dust and scratches"))


def _judged_contact(case: _Case, number: Estimate, found: Cutoffs, *, chosen: bool, extended: bool) -> None:
    """What the model lacks, of a cutoff that was chosen or not, and an area that was given or is the map's."""
    failing = (number.warnings & ~(_SAID & ~Warnings.FEW_WAVES if extended else _SAID)).kinds
    reason = found.reasons[found.at]
    if found.recommended is None and not chosen and reason not in [kind.description for kind in failing]:
        says, _, remedy = reason.partition(": ")
        case.found("cutoff", f"none is recommended, {says}", remedy or "take another load or map")
    for kind in failing:
        says, _, remedy = kind.description.partition("; ")
        case.found("contact", says, remedy or "take another load")


def _judged_friction(case: _Case, mu: float, deviation: float) -> None:
    """Whether the map tells friction at all, with its standard deviation of ln(mu)."""
    reach = math.exp(1.96 * deviation)
    if not reach < _LOST:
        # What can be mended comes first.
        says = f"the map alone leaves mu within {mu / reach:.2g} to {mu * reach:.2g}"
        case.found("friction", says, case.measure("measure a better map"), not case.findings)


def _spread(case: _Case, left: Summits, found: Cutoffs, families: dict[str, float]) -> dict[str, float]:
    """Standard deviations of ln(mu): rectangular over cutoffs and families."""
    moments = moments_of(left)
    parts = []
    # Of a map with few waves the errors cannot be known: half of the value stands for them.
    errors = [min(float(np.nan_to_num(one.error / one.value, nan=0.5)), 0.5) for one in (left.rms_height, left.rms_slope)]
    for height, slope in ((errors[0], 0.0), (0.0, errors[1])):
        other = {
            "m0": moments["m0"] * (1 + height) ** 2,
            "m2": moments["m2"] * (1 + slope) ** 2,
            "m4": moments["m4"] * (1 + slope) ** 4 / (1 + height) ** 2,
        }
        parts.append(math.log(case.friction_of(other) / found.friction[found.at]))
    known = [one for one in families.values() if math.isfinite(one) and one > 0]
    low, high = found.spread
    return {
        "sampling": float(np.hypot(*np.nan_to_num(parts, nan=0.5))),
        "cutoffs": math.log(high / low) / math.sqrt(12),
        "heights": math.log(max(known) / min(known)) / math.sqrt(12) if known else 0.5,
    }
