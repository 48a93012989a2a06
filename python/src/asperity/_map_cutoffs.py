"""Friction against the cutoff of the filter: at which scale a map tells the friction of its surface."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable

import numpy as np
import numpy.typing as npt

from . import _caller, _map_warnings
from ._map_filter import filter
from ._map_input import checked, length
from ._progress import LARGE, Progress, teller
from ._style import saved, style
from ._summit_search import without_polynomial
from ._summit_statistics import summits
from ._summits import Summits
from .model import Model
from .params import Params

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

# Cutoffs looked at, in points; a wave of six points gives density and sigma to 6 %, R to 8 % (docs/topography.md).
_POINTS = (2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128)
POINTS_PER_WAVE = 6
# Fewer summits say little; the map must have so many at a cutoff.
_SUMMITS = 30
# A filter that leaves less of the variance of the heights takes away what makes the surface rough.
_LEAST_VARIANCE = 0.5


@dataclass(frozen=True, eq=False)
class Cutoffs:
    """Friction at one load for the summits that filters of several cutoffs leave; arrays have the shape (cutoffs,).

    Attributes:
        load: the load [force].
        cutoff: of the filters [length], ascending.
        friction: friction coefficient.
        contact_radius: mean radius of the contacts [length].
        contacting: number of contacts.
        rms_slope: root mean square slope of what the filter leaves, on which friction and area depend.
        area_fraction: real area over nominal area.
        count: summits of the map.
        summits: what was found at each cutoff.
        params: the surfaces made of them.
        step: distance of the points [length].
        recommended: the shortest of the cutoffs that the map resolves: its waves have 6 points, contacts are 4 points wide,
            and half of the variance of the heights is left; None if there is none.
    """

    load: float
    cutoff: Array
    friction: Array
    contact_radius: Array
    contacting: Array
    rms_slope: Array
    area_fraction: Array
    count: npt.NDArray[np.intp]
    summits: tuple[Summits, ...]
    params: tuple[Params, ...]
    step: float
    recommended: float | None

    @property
    def message(self) -> str:
        """What follows, in words."""
        if self.recommended is None:
            return (
                f"no cutoff is recommended: contacts under this load are {_map_warnings.POINTS_PER_CONTACT} points wide at none "
                "that leaves the surface rough; measure a finer map, or take a heavier load"
            )
        at = int(np.argmax(self.cutoff >= self.recommended))
        return f"recommended: {self.recommended:.3g}, mu = {self.friction[at]:.4f}"

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
        for row in zip(self.cutoff, self.rms_slope, self.contacting, self.contact_radius, self.area_fraction, self.friction):
            cutoff, slope, contacting, radius, area, friction = row
            points, width = cutoff / self.step, 2 * radius / self.step
            lines.append(f"{cutoff:.3g}  {points:.3g}  {slope:.3g}  {contacting:.3g}  {width:.2g}  {area:.3g}  {friction:.4f}")
        return "\n".join([*lines, self.message])


def cutoffs(
    height_map: Any,
    load: float,
    dx: float | None = None,
    dy: float | None = None,
    *,
    cutoff: npt.ArrayLike | None = None,
    progress: Progress = None,
    **contact: Any,
) -> Cutoffs:
    """Filters a map with several cutoffs and computes the friction of what each leaves, at one load.

    Waves shorter than a contact is wide are pressed flat in it and are no summits; waves that the map does not resolve are
    drawn wrongly. So the recommended cutoff is the shortest whose waves have 6 points and at which contacts are 4 points wide
    on average, if it leaves half of the variance of the heights. Where friction hardly depends on the cutoff around there,
    the choice does not matter; elsewhere it does, and the spread is the uncertainty of the result.

    Args:
        height_map: as for `summits`; `clean` it first.
        load: normal load > 0 [force], of the nominal area.
        dx: distance of columns, where the map has none.
        dy: distance of rows; by default dx.
        cutoff: the cutoffs [length]; by default 2 to 128 points, as far as 30 summits are left.
        progress: as for `summits`.
        **contact: what `Params.from_topography` takes: materials, adhesion, `nominal_area`, `heights`, options.

    Raises:
        ValueError: as `filter` and `summits`; `Error` for what the library refuses.
        TypeError: as `Params.from_topography`.
        ImportError: SciPy is not installed.

    Warns:
        MapWarning: a direction of the surface, which no filter takes away; no cutoff that is recommended.
    """
    given = checked(height_map, dx, dy)
    step, load = max(given.dx, given.dy), length("load", load)
    chosen, least = (step * np.array(_POINTS), _SUMMITS) if cutoff is None else (_ascending(cutoff), 0)
    longest = min(given.height_map.shape[0] * given.dy, given.height_map.shape[1] * given.dx) / 4
    if cutoff is None:
        chosen = chosen[chosen <= longest]
    if chosen.size == 0:
        raise ValueError(
            f"height_map: {given.height_map.shape[0]} x {given.height_map.shape[1]} points, dx = {given.dx:g}, dy = {given.dy:g}: "
            "too small for the shortest cutoff, 2 points, which a map must be 4 times as wide and as high as"
        )
    tell = teller(progress, given.height_map.size > LARGE)
    found: list[tuple[Summits, Params, Any]] = []
    for i, one in enumerate(chosen):
        tell(i / chosen.size, f"filtering with the cutoff {one:.3g}")
        left = _summits(lambda: filter(given, float(one)), fewer_may_end=bool(found) and cutoff is None)
        if left is None or (found and left.count < least):
            break
        params = Params.from_topography(left, **contact)
        with Model(params) as model:
            found.append((left, params, model.state_at_load(load)))
    states = [state for _, _, state in found]
    radius = np.array([state.mean_contact_radius for state in states])
    taken = chosen[: len(found)]
    variance = np.array([summits.moments.m0 for summits, _, _ in found])
    rough = variance >= _LEAST_VARIANCE * np.var(without_polynomial(given.height_map, 1))
    resolved = rough & (taken >= POINTS_PER_WAVE * step) & (2 * radius >= _map_warnings.POINTS_PER_CONTACT * step)
    result = Cutoffs(
        load,
        taken,
        np.array([state.friction_coefficient for state in states]),
        radius,
        np.array([state.contacting for state in states]),
        np.array([summits.iso.Sdq for summits, _, _ in found]),
        np.array([state.real_area / params.nominal_area for _, params, state in found]),
        np.array([summits.count for summits, _, _ in found]),
        tuple(summits for summits, _, _ in found),
        tuple(params for _, params, _ in found),
        step,
        float(taken[np.argmax(resolved)]) if resolved.any() else None,
    )
    tell(1.0, result.message)
    _warn(result)
    return result


def _summits(filtered: Callable[[], Any], fewer_may_end: bool) -> Summits | None:
    """The summits of a filtered map, without its warnings; None where too few are left and that may be the end."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", _map_warnings.MapWarning)
            return summits(filtered(), progress=False)
    except ValueError:
        if fewer_may_end:
            return None
        raise


def _warn(found: Cutoffs) -> None:
    """Of what remains to be said at the recommended cutoff, or if there is none."""
    if found.recommended is None:
        _caller.warn(found.message, _map_warnings.MapWarning)
    at = found.cutoff.size - 1 if found.recommended is None else int(np.argmax(found.cutoff >= found.recommended))
    for warning in found.summits[at].warnings:
        _caller.warn(warning, _map_warnings.MapWarning)


def _ascending(cutoff: npt.ArrayLike) -> Array:
    array = np.asarray(cutoff)
    if array.ndim != 1 or array.size == 0 or array.dtype.kind not in "iuf":
        raise ValueError("cutoff: must be a one-dimensional array of one or more lengths")
    return np.unique(np.array([length(f"cutoff[{i}]", float(one)) for i, one in enumerate(array)]))


def _draw(found: Cutoffs, file: str | os.PathLike[str] | None) -> Figure:
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(7.5, 6), layout="constrained")
        above, below = figure.subplots(2, 1, sharex=True)
        above.semilogx(found.cutoff, found.friction, "o-", ms=4, color="C0", label=f"friction at the load {found.load:.3g}")
        above.set(ylabel="friction coefficient $F/P$", ylim=(0, 1.1 * float(found.friction.max())))
        below.loglog(found.cutoff, 2 * found.contact_radius, "o-", ms=4, color="C1", label="mean diameter of the contacts")
        width = _map_warnings.POINTS_PER_CONTACT * found.step
        below.axhline(width, color="black", ls=":", label=f"{_map_warnings.POINTS_PER_CONTACT} points of the map")
        below.set(xlabel="cutoff of the filter, in the unit of the map", ylabel="length, in that unit")
        for axes in (above, below):
            if found.recommended is not None:
                axes.axvline(found.recommended, color="black", ls="--", lw=1, label=f"recommended: {found.recommended:.3g}")
            axes.legend()
        return saved(figure, file)
