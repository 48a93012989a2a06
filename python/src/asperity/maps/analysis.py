"""From a measured map to a friction coefficient and a verdict on the map, in one call."""

from __future__ import annotations

import math
import warnings
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any, Iterable, Literal, NamedTuple

import numpy as np

from .._surface_text import text_of_values, without_line
from ..errors import Error
from ..estimate import Estimate, estimate
from ..materials import Pair
from ..one_line import of_pair
from ..model import Model
from ..params import Params, roughness_of
from ..results import Warnings
from ..tools import checks
from ..tools.progress import Progress
from . import boundary_elements, map_warnings
from .cleaning import Cleaned, clean, holes
from .cutoffs import Cutoffs, table
from .filter import filter, noise_slope
from .input import MOST_DEGREE, checked, degree
from .instrument_files import HeightMap, implausible
from .at_scores import AtScores, sloped
from .rows import offsets
from .spikes import particles, spikes as spikes_of
from .summit_search import without_polynomial
from .summit_statistics import summits
from .summits import Summits
from .tile_errors import jackknife

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .._surface_text import Joint

# A polynomial that takes this part of the mean square away is the form of the specimen. On pieces of self-affine surfaces of Hurst
# exponents 0.8 and 1 one of degree 2 takes at most 0.74 (40 surfaces each), and one of degree 5 at most 0.93, so that is not tried.
_FORM, _FORM_DEGREE = 0.9, 2
# Filtered with 6 points a wave, maps of which fewer neighbours have one height have slopes within 3 %; at 0.9 they are 15 % off.
_EQUAL = 0.8
_MISSING = 0.05
# Heights that rounding leaves of others.
_FLAT = 1e-12
# Noise with this part of the mean square slope; with a third of it friction is 9 % too low.
_NOISE, _MOST_NOISE = 0.1, 0.9
# Boundary elements were computed up to here (docs/validation.md).
_BANDWIDTH = 300.0
# Fewer waves a side are no statistics.
_WAVES = 8.0
# With a longer lay the friction of each long patch is 1.1 to 1.4 times too large, which a measurement takes away.
_LAY = 8.0
# More than this either way, at 95 %, is no number.
_LOST = 3.0
# What `check` says of the interface, which the band has; and what the map's own findings say better.
_SAID = Warnings.UNCALIBRATED | Warnings.STRONG | Warnings.FEW_WAVES


class Finding(NamedTuple):
    """What speaks against a map.

    Attributes:
        kind: "form", "rows", "spikes", "missing", "steps", "dust", "noise", "direction", "waves", "bandwidth", "cutoff",
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
        spread: standard deviations of ln(mu) of the map alone, by "sampling" (one map of the surface) and "cutoffs".
        area_spread: the same of the real area.
        findings: what speaks against the map, each with its remedy; empty if it is usable.
        steps: what was done, in order.
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
    area_spread: dict[str, float] = field(default_factory=dict)
    findings: tuple[Finding, ...] = ()
    steps: tuple[str, ...] = ()
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
            if self.cutoffs is not None:
                at, factor = self.cutoffs.at, math.exp(1.96 * math.hypot(*self.area_spread.values()))
                area = self.cutoffs.area_fraction[at]
                lines.append(f"area: {area:.3g} of the nominal, to a factor of {factor:.3g}, with the cutoff {self.cutoffs.cutoff[at]:.3g} m")
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
    check: Literal["boundary elements"] | None = None,
    coverage: float = 0.95,
    progress: Progress = None,
    **surface: Unpack[Joint],
) -> Analysis:
    """A friction coefficient with its band, and a verdict: from a map as the instrument gave it, in SI units.

    >>> analysis = surface.analyse(surface.read("scan.gwy"), 1e-3, pair="Si/Si")
    >>> print(analysis)

    In this order: form is removed (`detrend`), lines of the scan aligned, spikes replaced until there are none, missing points filled,
    steps of the heights looked for, waves longer than `longest` and shorter than the recommended cutoff filtered away, and friction
    computed from the heights and slopes at normal scores and the lay that are left, so that the surface need not be Gaussian. Where
    asperities yield, the contact law is elastic-plastic, as in `asperity.friction`. The band has the strength of the interface, what another
    map of the surface would give, and cutoffs from half to twice the one taken.

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
        check: "boundary elements" presses a mirror image of the filtered map, or of 512 x 512 points of its middle, against a flat by tamaas,
            elastic and without adhesion, and says how much of that area the model has; this may take a minute.
        coverage: probability of the band, between 0 and 1.
        progress: as for `summits`.
        **surface: keys of surface files but for the roughness: `measured`, `interface`, `hardness`, `work_of_adhesion`, ...

    Raises:
        Error: a load, degree or coverage that cannot be, or what the library refuses of `surface`. What is wrong with the map is
            in the findings.
        TypeError: no real numbers; distances missing, or given twice; a keyword that surface files do not have.
        ImportError: SciPy is not installed, or tamaas, to check.
    """
    if check is not None:
        boundary_elements.ready(checks.word("check", check, ("boundary elements",)))
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
        return case.stopped(error, "map" if str(error).startswith("height_map") else "friction", cleaned=cleaned)
    left = found.summits[found.at]
    assert left is not None
    waves = math.sqrt(extent) / (2 * math.pi * math.sqrt(left.moments.m0 / left.moments.m2))
    _judged(case, left, found, waves, cleaned)
    known = {"cleaned": cleaned, "cutoffs": found, "summits": left}
    try:
        number = case.at(load, roughness_of(left))
    except ValueError as error:
        return case.stopped(error, "friction", **known)
    case.steps += [
        f"surface: heights and slopes at 13 scores, bandwidth {left.moments.bandwidth:.3g}, {waves:.2g} waves a side",
        "contact: elastic-plastic" if number.params.contact_law == "elastic-plastic" else "contact: elastic, with adhesion",
    ]
    level = filter(map_, float(found.cutoff[found.at]))
    if check is not None:
        pressure = load / (case.joint["nominal_area"] * number.params.composite_modulus)
        case.steps.append(f"boundary elements: area of the model over that of the map {boundary_elements.ratio(level, pressure):.3g}")
    spread, area_spread = _spread(case, number.params, level, left, found)
    _judged_contact(case, number, found, chosen=cutoff is not None, extended=nominal_area is not None)
    _judged_friction(case, float(number), math.hypot(*spread.values()))
    return case.answered(number, spread=spread, area_spread=area_spread, **known)


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

    @property
    def is_measured(self) -> bool:
        """Whether friction was measured."""
        return bool({"measured", "calibration_load"} & self.joint.keys())

    def measure(self, other: str, how: str = "once") -> str:
        """The remedy of a measurement; another one where friction was measured."""
        if self.is_measured:
            return other
        return f"measure friction {how}, and give measured=(load, coefficient); or {other}"

    def at(self, load: float, rough: dict[str, Any], keywords: Iterable[str] = ()) -> Estimate:
        """The estimate of a roughness at a load; an unknown key is a wrong argument if it is one of the keywords."""
        try:
            return estimate(text_of_values(self.joint | rough), load, self.coverage)
        except Error as error:
            raise without_line(error, keywords) from None

    def params(self, rough: dict[str, Any]) -> Params:
        """The surface of a roughness."""
        try:
            return Params.from_text(text_of_values(self.joint | rough))
        except Error as error:
            raise without_line(error) from None

    def stopped(self, error: Exception, kind: str = "map", **known: Any) -> Analysis:
        """The answer where no friction can be had."""
        says, _, remedy = str(error).removeprefix("height_map: ").partition(": ")
        self.found(kind, says, remedy or "measure a larger or finer map", True)
        return Analysis(self.load, coverage=self.coverage, findings=tuple(self.findings), steps=tuple(self.steps), **known)

    def answered(self, number: Estimate, *, spread: dict[str, float], **known: Any) -> Analysis:
        """The answer, whose band has the spread of the map beside that of the strength."""
        from statistics import NormalDist

        reach = NormalDist().inv_cdf((1 + self.coverage) / 2)
        strength = 0.0 if number.low is None else math.log(number.high / number.low) / 2
        value, factor = float(number), math.exp(math.hypot(strength, reach * math.hypot(*spread.values())))
        return Analysis(
            self.load, value, value / factor, value * factor, self.coverage, spread=spread, findings=tuple(self.findings),
            steps=tuple(self.steps), estimate=number, params=number.params, **known,
        )  # fmt: skip


def _filtered(case: _Case, map_: HeightMap, cutoff: float | None, longest: float | None, progress: Progress) -> Cutoffs:
    """The map within its cutoffs, with what friction is at each of the shorter one."""
    if longest is not None:
        map_ = filter(map_, longest=longest)
        case.steps.append(f"L-filter: waves longer than {longest:.3g} m removed")

    found = table(map_, case.load, None if cutoff is None else [cutoff], lambda left: case.params(roughness_of(left)), progress, brief=True)
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
    if np.ptp(level) <= _FLAT * np.nanmax(np.abs(raw.height_map)):
        raise Error("height_map: flat but for its form and the offsets of its lines: give rows=False, if these are the surface")
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
    case.steps.append(f"lay: {left.at_scores.lay:.3g}; Sq {left.rms_height} m, Sdq {left.rms_slope}, Ssk {left.iso.Ssk:.2g}")
    cutoff = float(found.cutoff[found.at])
    deviation = map_warnings.noise(map_warnings.differences(cleaned.map.height_map))
    if deviation is not None:
        case.steps.append(f"noise: of {deviation:.2g} m before the filter")
        part = noise_slope(deviation, cutoff, left.dx, left.dy) / left.iso.Sdq**2
        if part > _NOISE:
            longer = cutoff * (part / _NOISE) ** 0.25
            says = f"of {deviation:.2g} m, has {min(part, 1.0):.0%} of the mean square slope after the filter"
            case.found("noise", says, f"give cutoff={longer:.2g}, or average several scans", part > _MOST_NOISE)
    if left.at_scores.lay > _LAY and not case.is_measured:
        says = f"lay {left.at_scores.lay:.3g}: patches of contact are long, and friction up to 1.4 times too large"
        case.found("direction", says, case.measure("take it for that"))
    if waves < _WAVES:
        case.found("waves", f"only {waves:.2g} mean waves a side: one place is not like another", "measure a larger map")
    if left.moments.bandwidth > _BANDWIDTH:
        says = f"bandwidth {left.moments.bandwidth:.4g}, where boundary elements reach {_BANDWIDTH:g}"
        about = 20 * cutoff
        case.found("bandwidth", says, f"give longest={about:.2g} if waves longer than the contact do not matter, or detrend=2")


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


def _spread(
    case: _Case, params: Params, map_: HeightMap, left: Summits, found: Cutoffs
) -> tuple[dict[str, float], dict[str, float]]:
    """Standard deviations of ln(mu) and of ln(area), by a jackknife over the tiles of the filtered map, and rectangular over cutoffs."""
    with Model(params) as model:
        measured = params.calibration_load
        # Friction that was measured on this surface is what it is, whichever tiles the map has.
        fixed = measured > 0 and math.isclose(model.friction_at_load(measured) * measured, params.calibration_friction_force, rel_tol=1e-3)

    def answers(tile: AtScores) -> tuple[float, float]:
        text = text_of_values({"bandwidth": roughness_of(left)["bandwidth"], **tile.keys})
        try:
            with Model(Params.from_text(text, start=params)) as model:
                state = model.state_at_load(case.load)
                return state.friction_coefficient / (model.friction_at_load(measured) if fixed else 1.0), state.real_area
        except ValueError:
            return math.nan, math.nan

    tiles = sloped(without_polynomial(map_.height_map, 1), map_.dx, map_.dy, map_.noise).without_each_tile()
    each = np.array([answers(one) for one in tiles])
    each = each[np.isfinite(each).all(axis=1)]
    # What half of the tiles do not tell, half of the value stands for.
    sampling = jackknife(np.log(each).T) if 2 * len(each) >= len(tiles) else np.full(2, 0.5)
    cutoffs = (math.log(high / low) / math.sqrt(12) for low, high in (found.spread, found.area_spread))
    mu, area = ({"sampling": float(one), "cutoffs": other} for one, other in zip(sampling, cutoffs))
    return mu, area
