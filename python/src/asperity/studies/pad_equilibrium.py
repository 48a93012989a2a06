"""The equilibrium of one pad: its summits at the separations at which they carry given loads."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from ..model import Model

Array = npt.NDArray[np.float64]
Counts = npt.NDArray[np.intp]
Mask = npt.NDArray[np.bool_]

# The law of one summit is looked at for so many heights where radii vary.
_HEIGHTS = 129
# The least load of a summit is taken as this part lower, since it is read between those heights.
_MARGIN = 0.01
# The search for the first crossing steps no shorter than this part of the range of adhesion: a pad whose load falls below
# the one wanted for less than that, and rises again, is taken to hold.
_SHORTEST = 0.01
# Separations are found to this part of the last step, in some eight steps of regula falsi.
_TOLERANCE = 1e-9
_MOST_STEPS = 100


class OneSummitLaw:
    """The load of summits, and bounds of it: with falling overlap it falls to its least and rises from there to 0."""

    def __init__(self, model: Model, highest: float) -> None:
        self._model, params = model, model.params
        self._varies = params.radius_amplitude != 0
        self._heights = np.linspace(-highest, highest, _HEIGHTS if self._varies else 1)
        nothing = np.zeros_like(self._heights)
        self._least_at, self._least, self.farthest = nothing, nothing, 0.0
        if params.work_of_adhesion > 0:
            apart = self._apart(params.adhesion_range)
            self.farthest = float(-apart.min())
            self._least_at = self._minimum(apart)
            self._least = (1 + _MARGIN) * self.loads(self._least_at, self._heights)

    @property
    def adhesive(self) -> bool:
        """Whether summits pull."""
        return self.farthest > 0

    @property
    def least(self) -> float:
        """The pull-off force of a summit [force], of the one that is hardest to part."""
        return float(-self._least.min())

    def loads(self, overlap: Array, height: Array) -> Array:
        """The load of each summit."""
        return self._model.summits_at_overlaps(overlap, height if self._varies else None).load

    def friction(self, overlap: Array, height: Array) -> tuple[float, int]:
        """Friction force of summits, and how many touch."""
        found = self._model.summits_at_overlaps(overlap, height if self._varies else None)
        return float(found.friction_force.sum()), int(np.count_nonzero(found.contact_radius))

    def excess(self, height: Array, separation: float, load: float) -> float:
        """The load of summits at a separation, less this one."""
        return float(self.loads(height - separation, height).sum()) - load

    def bound(self, height: Array, separation: float, step: float) -> float:
        """A load that summits do not fall below between a separation and one a step farther."""
        near = height - separation
        least_at = np.interp(height, self._heights, self._least_at)
        least = np.interp(height, self._heights, self._least)
        loads = self.loads(np.where(near > least_at, near - step, near), height)
        return float(np.where((near > least_at) & (near - step < least_at), least, loads).sum())

    def least_nearer(self, height: Array, separation: float) -> float:
        """A load that summits do not fall below at a separation and at all nearer ones."""
        overlap = height - separation
        falls = overlap > np.interp(height, self._heights, self._least_at)
        least = np.interp(height, self._heights, self._least)
        return float(np.where(falls, self.loads(overlap, height), least).sum())

    def _apart(self, reach: float) -> Array:
        """Overlaps at which the summits just do not pull any more."""
        lower = np.full_like(self._heights, -reach)
        while np.any(self.loads(lower, self._heights) != 0):
            lower *= 2
        upper = np.zeros_like(lower)
        for _ in range(60):
            middle = (lower + upper) / 2
            pulls = self.loads(middle, self._heights) != 0
            lower, upper = np.where(pulls, lower, middle), np.where(pulls, middle, upper)
        return lower

    def _minimum(self, apart: Array) -> Array:
        """Overlaps of the least loads, by golden sections."""
        lower, upper = apart, -apart
        while np.any(self.loads(upper, self._heights) <= 0):
            upper = 2 * upper
        for _ in range(60):
            left, right = lower + 0.382 * (upper - lower), lower + 0.618 * (upper - lower)
            rises = self.loads(left, self._heights) < self.loads(right, self._heights)
            lower, upper = np.where(rises, lower, left), np.where(rises, right, upper)
        return np.asarray((lower + upper) / 2)


def descend(law: OneSummitLaw, heights: Array, start: float, loads: Array) -> tuple[Array, Counts, Mask]:
    """Unloads a pad: friction force, number of contacts and whether it is apart, for loads in falling order.

    Args:
        heights: of its tallest summits, in falling order.
        start: a separation at which the pad carries more than all loads.
    """
    force, contacting = np.zeros(loads.size), np.zeros(loads.size, dtype=np.intp)
    apart = np.ones(loads.size, dtype=bool)
    separation = start
    for i, load in enumerate(loads):
        found = _first_crossing(law, heights, separation, float(load))
        if found is None:
            break  # lighter loads are below pull-off too
        separation = found
        near = _near(law, heights, separation)
        force[i], contacting[i] = law.friction(near - separation, near)
        apart[i] = False
    return force, contacting, apart


def _near(law: OneSummitLaw, heights: Array, separation: float) -> Array:
    """The summits that touch or pull at a separation, or farther off."""
    return heights[: np.searchsorted(-heights, law.farthest - separation)]


def _first_crossing(law: OneSummitLaw, heights: Array, separation: float, load: float) -> float | None:
    """The least separation, from one on at which the pad carries more, at which its load falls to this one."""
    end = float(heights[0]) + law.farthest
    # Without adhesion the bound is the load itself at the end of the step.
    shortest = _SHORTEST * law.farthest if law.adhesive else math.inf
    step = (end - separation) / 8
    while separation < end:
        near = _near(law, heights, separation)
        if law.bound(near, separation, step) <= load:
            if step > shortest:
                step /= 4
                continue
            if law.excess(near, separation + step, load) < 0:
                return _root(law, near, load, separation, separation + step)
        separation, step = separation + step, 2 * step
    return None


def _root(law: OneSummitLaw, heights: Array, load: float, lower: float, upper: float) -> float:
    """Where summits carry a load, between separations where they carry more and less.

    Regula falsi after Anderson and Björck (BIT 13 (1973), 253).
    """
    at_lower, at_upper = (law.excess(heights, separation, load) for separation in (lower, upper))
    closest = _TOLERANCE * (upper - lower)
    for _ in range(_MOST_STEPS):
        at = (lower * at_upper - upper * at_lower) / (at_upper - at_lower)
        value = law.excess(heights, at, load)
        if value == 0 or min(at - lower, upper - at) < closest:
            return at
        if (value < 0) == (at_upper < 0):
            part = 1 - value / at_upper
            at_lower *= part if part > 0 else 0.5
            upper, at_upper = at, value
        else:
            part = 1 - value / at_lower
            at_upper *= part if part > 0 else 0.5
            lower, at_lower = at, value
    return (lower + upper) / 2
