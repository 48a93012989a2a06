"""Pads of few contacts: friction of single pads of N summits, their mean and how they scatter.

    from asperity import Params, pads

    found = pads(params, loads, 200)
    found.plot("pads.svg")

The sums of the model are means over summits at a given separation. At a given load a pad stands on the summits that it
happens to have: where few touch, its friction differs from that of the model, and from that of the next pad.
Heights at random are in `studies.pad_heights`, the equilibrium of a pad in `studies.pad_equilibrium`, what is found of them in
`studies.pad_results`.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import TYPE_CHECKING, Iterator, NamedTuple

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..model import Model
from ..params import Params
from ..tools import checks
from ..tools.progress import Progress, teller
from .pad_equilibrium import Counts, Mask, OneSummitLaw, descend
from .pad_heights import TailHeights, counted_from_summits
from .pad_results import Pads

if TYPE_CHECKING:
    from concurrent.futures import Executor

Array = npt.NDArray[np.float64]

# Of up to so many summits all are drawn: however near the surfaces, the load of few summits scatters so much that no
# separation serves for all pads.
_DRAWN_WHOLE = 1000
# Of more summits, the search for the separation of a pad begins where at least so many touch on average, and where the load
# is above the heaviest one by this many of its standard deviations, or by what those would be if all summits pressed alike.
_FIRST_CONTACTS, _DEVIATIONS = 40, 8.0
# States of pads; more take more than some seconds.
_MANY = 5000
# Pads that a worker is given at a time, some tenths of a second of work.
_BLOCK = 16


class _Pads(NamedTuple):
    """Pads to be unloaded: the heights of each, the tallest first, and the separation to begin at, NaN to search for one."""

    params: Params
    highest: float
    heights: list[Array]
    start: float
    loads: Array


def pads(
    params: Params,
    loads: npt.ArrayLike,
    count: int = 100,
    *,
    seed: int = 0,
    progress: Progress = None,
    executor: Executor | None = None,
) -> Pads:
    """Friction of pads whose summits are drawn at random from the heights of the surface.

    Each pad has `asperity_count` summits, of which only the tallest are drawn where there are many; each obeys the exact
    law of one summit, in contact and out of it. A pad is unloaded from heavy load: at each load it stands at the nearest
    separation at which its load has fallen to that, so that it jumps over states that could not hold. Below the least load of
    all it is apart.

    Args:
        params: the surface, with its true number of summits.
        loads: normal loads [force], one or a one-dimensional array, in any order; also 0 and, with adhesion, negative ones.
        count: number of pads, 2 or more. The mean is known to its scatter over the root of this.
        seed: of the random numbers, >= 0: the same pads for the same seed and the same loads.
        progress: whether to tell how far it is, on the error stream, or a function of the part done, 0 to 1, and of what is
            being done; by default for more than about a thousand states.
        executor: where the pads are unloaded, by default here: anything with the interface of
            `concurrent.futures.Executor`, with the same result (docs/studies.md).

    Raises:
        Error: what loads, count, seed or the number of summits may not be, or what the library refuses.
        TypeError: no `Params`, or no whole numbers.
    """
    checks.instance("params", params, Params)
    load = checks.one_or_more("loads", loads)
    count, seed = checks.whole("count", count, 2), checks.whole("seed", seed, 0)
    if params.asperity_count < 2:
        raise Error(
            f"asperity_count = {params.asperity_count:g}: pads need the true number of summits, 2 or more: "
            "params.replace(asperity_count=...)"
        )
    order = np.argsort(-load)
    force, contacting = np.zeros((count, load.size)), np.zeros((count, load.size), dtype=np.intp)
    apart = np.zeros((count, load.size), dtype=bool)
    random = np.random.default_rng(seed)
    heights = TailHeights(params)
    with Model(counted_from_summits(params)) as model:
        model_force = model.friction_force_at_load(load)
        law = _law(params, heights.highest)
        heaviest, whole = float(load.max()), heights.count <= _DRAWN_WHOLE
        start = math.nan if whole else _start(model, law, heights, heaviest)
        lowest = -math.inf if whole else start - law.farthest
    tell = teller(progress, count * load.size > _MANY, "asperity.pads")

    def blocks() -> Iterator[tuple[int, _Pads]]:
        for first in range(0, count, _BLOCK):
            drawn = [heights.sample(random, lowest) for _ in range(min(_BLOCK, count - first))]
            yield first, _Pads(params, heights.highest, drawn, start, load[order])

    done = 0
    tell(0.0, "pads")
    from ..tools.blocks import completed

    for first, found in completed(_unloaded, blocks(), executor):
        for pad, one in enumerate(found, first):
            force[pad, order], contacting[pad, order], apart[pad, order] = one
        done += len(found)
        tell(done / count, "pads")
    for array in (load, force, contacting, apart, model_force):
        array.setflags(write=False)
    return Pads(params, load, force, contacting, apart, model_force, seed)


def _unloaded(block: _Pads) -> list[tuple[Array, Counts, Mask]]:
    """Friction force, contacts and whether it is apart, of each pad at each load."""
    law, heaviest, found = _law(block.params, block.highest), float(block.loads[0]), []
    for heights in block.heights:
        whole = math.isnan(block.start)
        start = _start_of(law, heights, heaviest, block.params.height_std) if whole else block.start
        found.append(descend(law, heights, start, block.loads))
    return found


@lru_cache(maxsize=1)
def _law(params: Params, highest: float) -> OneSummitLaw:
    """Made once in each process: it takes as long as some pads."""
    return OneSummitLaw(Model(params), highest)


def _start(model: Model, law: OneSummitLaw, heights: TailHeights, heaviest: float) -> float:
    """A separation at which the load of any pad is above the heaviest one, in all likelihood."""
    separation, step = heights.exceeded_by(_FIRST_CONTACTS), model.params.height_std / 16
    while True:
        state = model.state_at_gap(separation)
        summits = state.contacting + state.attracted
        one = law.least + (state.load - state.attraction_load) / max(state.contacting, 1.0)
        if state.load - max(heaviest, 0.0) > _DEVIATIONS * one * math.sqrt(summits):
            return separation
        separation -= step


def _start_of(law: OneSummitLaw, heights: Array, heaviest: float, step: float) -> float:
    """A separation at which, and at all nearer ones, a pad of these summits carries more than the heaviest load."""
    separation = float(heights[0])
    while law.least_nearer(heights, separation) <= heaviest:
        separation, step = separation - step, 2 * step
    return separation
