"""Heights in steps: what a converter of few bits, or a file of few digits, left of a map."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

# So many rows and columns tell the step; a part of equal neighbours below this says that steps are fine. With 0.15, slopes are
# 1 % too steep, with 0.3 5 %, with 0.5 15 %.
_LINES, _FINE = 64, 0.1


class Steps(NamedTuple):
    """Of heights.

    Attributes:
        step: between neighbouring heights [length].
        equal: part of the pairs of neighbouring points that have one height.
    """

    step: float
    equal: float


def steps(recorded: Array) -> Steps | None:
    """The steps of heights as they were recorded; None if they are fine beside the differences of neighbours."""
    pairs = equal = 0
    heights = []
    for lines in (recorded, recorded.T):
        some = lines[:: max(len(lines) // _LINES, 1)]
        difference = np.diff(some, axis=1)
        known = np.isfinite(difference)
        pairs, equal = pairs + int(known.sum()), equal + int((difference[known] == 0).sum())
        heights.append(np.unique(some[np.isfinite(some)]))
    if equal <= _FINE * pairs:
        return None
    apart = np.diff(np.unique(np.concatenate(heights)))
    apart = apart[apart > 1e-9 * apart.sum()]  # steps of numbers that were scaled differ by rounding
    if apart.size == 0:
        return None
    step = float(np.median(apart[apart < 1.5 * apart.min()]))
    off = np.abs(apart / step - np.round(apart / step))
    # A flat part of a map of any heights is no step.
    return None if np.mean(off[apart < 20 * step] < 0.1) < 0.9 or apart.size < 2 else Steps(step, equal / pairs)
