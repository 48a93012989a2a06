"""Friction against the cutoff of the filter: at which scale a map tells the friction of its surface."""

from __future__ import annotations

import math
import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..model import Model
from ..params import Params
from ..results import Warnings
from ..tools import caller, checks
from ..tools.progress import LARGE, Progress, teller
from ..tools.style import saved, style
from . import map_warnings
from .filter import filter
from .input import checked
from .instrument_files import HeightMap
from .summit_search import without_polynomial
from .summit_statistics import summits
from .summits import Summits

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from typing_extensions import Unpack

    from ..params import OfTopography

Array = npt.NDArray[np.float64]

# Cutoffs looked at, in points; a wave of six points gives density and sigma to 6 %, R to 8 % (docs/height-maps.md).
_POINTS = (2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128)
POINTS_PER_WAVE = 6
# Fewer summits say little; the map must have so many at a cutoff.
_SUMMITS = 30
# What `Model.check` says of the interface, and of the extent of the contact, which no cutoff changes.
_WHATEVER_CUTOFF = Warnings.UNCALIBRATED | Warnings.STRONG | Warnings.FEW | Warnings.FEW_WAVES
# A filter that leaves less of the variance of the heights takes away what makes the surface rough.
_LEAST_VARIANCE = 0.5


@dataclass(frozen=True, eq=False)
class Cutoffs:
    """Friction at one load for the summits that filters of several cutoffs leave; arrays have the shape (cutoffs,).

    Attributes:
        load: the load [force].
        cutoff: of the filters [length], ascending.
        friction: friction coefficient; NaN, as the other arrays, where it could not be computed.
        contact_radius: mean radius of the contacts [length].
        contacting: number of contacts.
        rms_slope: root mean square slope of what the filter leaves, on which friction and area depend.
        area_fraction: real area over nominal area.
        count: summits of the map; 0 where they were not found.
        summits: what was found at each cutoff; None where nothing was.
        params: the surfaces made of them; None likewise.
        reasons: why each cutoff is not recommended, in words; "" for those that may be.
        step: distance of the points [length].
        recommended: the shortest of the cutoffs that may be: its waves have 6 points, contacts are 4 points wide, half of the variance
            of the heights is left, it has 30 summits, and `Model.check` finds nothing against the surface; None if there is none.
    """

    load: float
    cutoff: Array
    friction: Array
    contact_radius: Array
    contacting: Array
    rms_slope: Array
    area_fraction: Array
    count: npt.NDArray[np.intp]
    summits: tuple[Summits | None, ...]
    params: tuple[Params | None, ...]
    reasons: tuple[str, ...]
    step: float
    recommended: float | None

    @property
    def at(self) -> int:
        """Index of the recommended cutoff; without, of the one that comes nearest: the last with friction of those that the map
        resolves, else the last with friction."""
        if self.recommended is not None:
            return int(np.argmax(self.cutoff >= self.recommended))
        known = np.isfinite(self.friction)
        fine = known & (self.cutoff >= POINTS_PER_WAVE * self.step)
        return int(np.argmax(fine) if fine.any() else np.nonzero(known)[0][-1])

    @property
    def spread(self) -> tuple[float, float]:
        """The least and the greatest friction coefficient, of cutoffs up to twice as short and as long as the one at `at`."""
        return self._range(self.friction)

    @property
    def area_spread(self) -> tuple[float, float]:
        """The same of the real area over the nominal."""
        return self._range(self.area_fraction)

    def _range(self, of: Array) -> tuple[float, float]:
        near = (self.cutoff >= 0.49 * self.cutoff[self.at]) & (self.cutoff <= 2.01 * self.cutoff[self.at])
        return float(np.nanmin(of[near])), float(np.nanmax(of[near]))

    @property
    def message(self) -> str:
        """What follows, in words."""
        if self.recommended is None:
            return f"no cutoff is recommended, the nearest is {self.cutoff[self.at]:.3g}: {self.reasons[self.at]}"
        low, high = self.spread
        return f"recommended: {self.recommended:.3g}, mu = {self.friction[self.at]:.4f} ({low:.4f} to {high:.4f} from half to twice it)"

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws friction and contact radius against the cutoff, the recommended one marked.

        Args:
            file: its ending is its format, for example "cutoffs.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        return _draw(self, file)

    def __str__(self) -> str:
        lines = ["cutoff  points  rms slope  contacts  points/contact  area  mu"]
        for i, cutoff in enumerate(self.cutoff):
            line = f"{cutoff:.3g}  {cutoff / self.step:.3g}"
            if np.isfinite(self.friction[i]):
                width = 2 * self.contact_radius[i] / self.step
                line += f"  {self.rms_slope[i]:.3g}  {self.contacting[i]:.3g}  {width:.2g}  {self.area_fraction[i]:.3g}  {self.friction[i]:.4f}"
            lines.append(line + (f"  {self.reasons[i]}" if self.reasons[i] else ""))
        return "\n".join([*lines, self.message])


def cutoffs(
    height_map: Any,
    load: float,
    dx: float | None = None,
    dy: float | None = None,
    *,
    cutoff: npt.ArrayLike | None = None,
    progress: Progress = None,
    **contact: Unpack[OfTopography],
) -> Cutoffs:
    """Filters a map with several cutoffs and computes the friction of what each leaves, at one load.

    Waves shorter than a contact is wide are pressed flat in it and are no summits; waves that the map does not resolve are
    drawn wrongly. So the recommended cutoff is the shortest whose waves have 6 points and at which contacts are 4 points wide
    on average, if it leaves half of the variance of the heights and the model finds nothing against the surface. Where friction
    hardly depends on the cutoff around there, the choice does not matter; elsewhere `spread` is the uncertainty of the result.
    Cutoffs that fail stay in the table, with the reason.

    Args:
        height_map: as for `summits`; `clean` it first.
        load: normal load > 0 [force], of the nominal area.
        dx: distance of columns, where the map has none.
        dy: distance of rows; by default dx.
        cutoff: the cutoffs [length]; by default 2 to 128 points, up to a fourth of the side of the map.
        progress: as for `summits`.
        **contact: what `Params.from_topography` takes: materials, adhesion, `nominal_area`, options.

    Raises:
        Error: none of the cutoffs gives friction: what the first that the map has says, as `filter`, `summits` and the library.
        TypeError: as `Params.from_topography`.
        ImportError: SciPy is not installed.

    Warns:
        MapWarning: a direction of the surface, which no filter takes away; no cutoff that is recommended.
    """
    result = table(checked(height_map, dx, dy), load, cutoff, lambda left: Params.from_topography(left, **contact), progress)
    if result.recommended is None:
        caller.warn(result.message, map_warnings.MapWarning)
    left = result.summits[result.at]
    for warning in left.warnings if left else ():
        caller.warn(warning, map_warnings.MapWarning)
    return result


def table(
    given: HeightMap, load: float, cutoff: npt.ArrayLike | None, make: Callable[[Summits], Params], progress: Progress, *, brief: bool = False
) -> Cutoffs:
    """As `cutoffs`, without its warnings, with the surfaces that `make` makes; none longer than twice the recommended one, if `brief`."""
    step, load = max(given.dx, given.dy), checks.positive("load", load, "N")
    longest = min(given.height_map.shape[0] * given.dy, given.height_map.shape[1] * given.dx) / 4
    chosen = step * np.array(_POINTS) if cutoff is None else _ascending(cutoff, given.unit)
    if cutoff is None:
        chosen = chosen[chosen <= longest]
    if chosen.size == 0:
        raise Error(
            f"height_map: {given.height_map.shape[0]} x {given.height_map.shape[1]} points, dx = {given.dx:g}, dy = {given.dy:g}: "
            "too small for the shortest cutoff, 2 points, which a map must be 4 times as wide and as high as"
        )
    tell = teller(progress, given.height_map.size > LARGE)
    least = _LEAST_VARIANCE * float(np.var(without_polynomial(given.height_map, 1)))
    numbers, left, surfaces, reasons, errors = [], [], [], [], []
    good: list[float] = []
    for i, one in enumerate(map(float, chosen)):
        if brief and good and one > 2.01 * good[0]:
            break
        tell(i / chosen.size, f"filtering with the cutoff {one:.3g}")
        found = params = None
        numbers.append([math.nan] * 5)
        try:
            found = _summits(given, one)
            params = make(found)
            with Model(params) as model:
                state = model.state_at_load(load)
                failing = model.check(load, load) & ~_WHATEVER_CUTOFF
        except ValueError as error:
            errors.append(error)
            reasons.append(str(error).removeprefix("height_map: "))
        else:
            width = 2 * state.mean_contact_radius / step
            reasons.append(_reason(one / step, width, found, least, [kind.description for kind in failing.kinds]))
            numbers[-1] = [
                state.friction_coefficient, state.mean_contact_radius, state.contacting, found.iso.Sdq, state.real_area / params.nominal_area
            ]  # fmt: skip
            good += [] if reasons[-1] else [one]
        left.append(found)
        surfaces.append(params)
    if len(errors) == len(reasons):
        raise errors[0]
    mu, radius, contacting, slope, area = np.array(numbers).T
    counts = np.array([0 if one is None else one.count for one in left])
    result = Cutoffs(
        load, chosen[: len(reasons)], mu, radius, contacting, slope, area, counts, tuple(left), tuple(surfaces), tuple(reasons), step,
        good[0] if good else None,
    )  # fmt: skip
    tell(1.0, result.message)
    return result


def _reason(points: float, width: float, left: Summits, least: float, failing: list[str]) -> str:
    """Why a cutoff is not recommended."""
    if points < POINTS_PER_WAVE:
        return f"waves of less than {POINTS_PER_WAVE} points"
    if width < map_warnings.POINTS_PER_CONTACT:
        return f"contacts under this load are {width:.2g} points wide: measure a finer map, or take a heavier load"
    if left.moments.m0 < least:
        return "less than half of the variance is left"
    if left.count < _SUMMITS:
        return f"{left.count} summits"
    return failing[0] if failing else ""


def _summits(given: HeightMap, cutoff: float) -> Summits:
    """The summits of a filtered map, without its warnings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", map_warnings.MapWarning)
        return summits(filter(given, cutoff), progress=False)


def _ascending(cutoff: npt.ArrayLike, unit: str) -> Array:
    array = checks.column("cutoff", cutoff, unit)
    return np.unique(np.array([checks.positive(f"cutoff[{i}]", float(one)) for i, one in enumerate(array)]))


def _draw(found: Cutoffs, file: str | os.PathLike[str] | None) -> Figure:
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.5, 6), layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True)
        above.semilogx(found.cutoff, found.friction, "o-", ms=4, color="C0", label=f"friction at the load {found.load:.3g}")
        above.set(ylabel="friction coefficient $F/P$", ylim=(0, 1.1 * float(np.nanmax(found.friction))))
        below.loglog(found.cutoff, 2 * found.contact_radius, "o-", ms=4, color="C1", label="mean diameter of the contacts")
        width = map_warnings.POINTS_PER_CONTACT * found.step
        below.axhline(width, color="black", ls=":", label=f"{map_warnings.POINTS_PER_CONTACT} points of the map")
        below.set(xlabel="cutoff of the filter, in the unit of the map", ylabel="length, in that unit")
        for axes in (above, below):
            if found.recommended is not None:
                axes.axvline(found.recommended, color="black", ls="--", lw=1, label=f"recommended: {found.recommended:.3g}")
            axes.legend()
        return saved(figure, file)
