"""Heights of the tallest of many summits, at random, for any distribution of heights."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from ..model import Model
from ..params import Params

Array = npt.NDArray[np.float64]

# Between neighbouring heights of the table ln(Q/(1 - Q)) changes by no more than this, which puts a Gaussian height that is
# read between them in error by some 1e-5 sigma; or they are as close as this many sigma, as at the ends of the heights.
_STEP, _CLOSEST = 0.1, 1e-9
# The table ends where so much of one summit of a pad is higher: next to no pad has one.
_NONE = 1e-9


def counted_from_summits(params: Params) -> Params:
    """The same summits, of which a gap is what they are apart."""
    return params.replace(nominal_area=0.0, summit_mean_height=0.0)


class TailHeights:
    """The heights of a surface as a function of Q, the fraction of summits above."""

    def __init__(self, params: Params) -> None:
        self._sigma, self.count = params.height_std, round(params.asperity_count)
        # Without adhesion the summits in contact are those above the separation.
        with Model(counted_from_summits(params).replace(work_of_adhesion=0.0)) as model:

            def logits(heights: Array) -> Array:
                states = [model.state_at_gap(z * self._sigma) for z in heights]
                return self._logit(np.array([state.fraction_in_contact for state in states]))

            farthest = 8.0
            while logits(np.array([farthest]))[0] > self._logit(np.zeros(1))[0]:
                farthest *= 1.5
            grid = np.linspace(-farthest, farthest, 65)
            logit = logits(grid)
            while (wide := (np.abs(np.diff(logit)) > _STEP) & (np.diff(grid) > _CLOSEST)).any():
                between = (grid[1:][wide] + grid[:-1][wide]) / 2
                grid, logit = np.append(grid, between), np.append(logit, logits(between))
                order = np.argsort(grid)
                grid, logit = grid[order], logit[order]
        self._heights, self._logits = self._sigma * grid[::-1], np.maximum.accumulate(logit[::-1])

    def _logit(self, fraction: Array) -> Array:
        """ln(Q/(1 - Q)), within what matters."""
        fraction = np.clip(fraction, _NONE / self.count, 1 - 1e-13)
        return np.asarray(np.log(fraction) - np.log1p(-fraction))

    @property
    def highest(self) -> float:
        """A height [length] that no summit of a pad exceeds, nor one below the mean falls short of."""
        return float(max(self._heights[0], -self._heights[-1]))

    def number_above(self, height: float) -> float:
        """The number of summits above a height [length], on average over pads."""
        logit = np.interp(-height, -self._heights, self._logits)
        return self.count / (1 + math.exp(-float(logit)))

    def exceeded_by(self, number: float) -> float:
        """The height [length] that so many summits exceed, on average over pads."""
        return float(self._at(self._logit(np.array(number / self.count))))

    def _at(self, logit: Array) -> Array:
        return np.asarray(np.interp(logit, self._logits, self._heights))

    def sample(self, random: np.random.Generator, lowest: float) -> Array:
        """The heights [length] of a pad above the lowest one asked for, the tallest first, and a few below.

        By Rényi's representation of order statistics (Acta Math. Acad. Sci. Hung. 4 (1953), 191): with E_j exponentially
        distributed, -ln(1 - Q) of the k-th tallest of N summits is the sum of E_j/(N - j + 1) for j up to k.
        """
        expected = self.number_above(lowest)
        hazard, heights = np.empty(0), np.empty(0)
        while heights.size < self.count and not (heights.size and heights[-1] < lowest):
            first = hazard.size
            size = min(int(expected / 4 if first else expected + 3 * expected**0.5) + 10, self.count - first)
            step = random.standard_exponential(size) / (self.count - first - np.arange(size))
            more = (hazard[-1] if first else 0.0) + np.cumsum(step)
            hazard = np.concatenate([hazard, more])
            logit = np.log(-np.expm1(-more)) + more
            heights = np.concatenate([heights, self._at(logit)])
        return heights
