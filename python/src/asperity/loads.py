"""Which load to ask the law for where a solver wants the coefficient before it knows the normal force of the step.

The load of the step before is late, and where it jitters it biases friction. `PairLoads` keeps, for each pair of
bodies, what the past steps tell of its load. The same in C, with the same numbers, is `asperity_loads.h`.
"""

from __future__ import annotations

import math
from collections.abc import Hashable
from dataclasses import dataclass

from .errors import Error
from .tools import checks


@dataclass
class _Load:
    """What is known of the load of a pair: the last one or the mean, its change by time, and when it was taken."""

    load: float
    time: float
    slope: float = 0.0
    count: int = 1


class PairLoads:
    """Loads of pairs of bodies, from step to step.

        loads = PairLoads(time_constant=0.02)
        before a step   load = loads.expected(a, b, time)
                        mu = model.friction_at_load(load) if load > 0 else first_guess
        after a step    loads.add(a, b, normal_force)     for each contact
                        loads.end_step(time)              once

    time_constant: 0 for the straight line through the last two loads, where loads vary smoothly; more for the mean over
    about that time, where loads are right on average only. Steps without contact count as load 0, until the pair has
    been apart for the time constant. A contact that is younger than that has the line: it may be an impact. Bodies are named by whatever is hashable; (a, b) is the same pair as (b, a). Times
    are those at which a load is or will be found; a time that does not grow begins anew.
    """

    def __init__(self, time_constant: float = 0.0) -> None:
        time_constant = checks.real("time_constant", time_constant, "s")
        if not (math.isfinite(time_constant) and time_constant >= 0):
            raise Error(f"time_constant = {time_constant!r}: must be finite and not negative")
        self.time_constant = time_constant
        self._sums: dict[frozenset[Hashable], float] = {}
        self._touched: dict[frozenset[Hashable], float] = {}
        self._known: dict[frozenset[Hashable], _Load] = {}

    def add(self, first: Hashable, second: Hashable, load: float) -> None:
        """Adds the load of a contact point to those of its pair in this step."""
        load = checks.real("load", load, "force")
        if not (math.isfinite(load) and load >= 0):
            raise Error(f"load = {load!r} of {first!r} on {second!r}: must be finite and not negative")
        pair = frozenset((first, second))
        if load > 0:
            self._sums[pair] = self._sums.get(pair, 0.0) + load

    def end_step(self, time: float) -> None:
        """Ends a step, whose loads were added and belong to this time."""
        time = checks.real("time", time, "s")
        for pair in self._sums:
            self._touched[pair] = time
        for pair, touched in list(self._touched.items()):
            if touched != time and not time - touched < self.time_constant:
                del self._touched[pair], self._known[pair]
            else:
                self._take(pair, self._sums.get(pair, 0.0), time)
        self._sums.clear()

    def expected(self, first: Hashable, second: Hashable, time: float) -> float:
        """The load to be expected on a pair at a time, over all its points; 0 if nothing is known.

        A line is followed to half the last load and to twice it: what changes faster within a step is not resolved by
        the steps.
        """
        time = checks.real("time", time, "s")
        known = self._known.get(frozenset((first, second)))
        if known is None:
            return 0.0
        line = known.load + known.slope * (time - known.time)
        return min(max(line, 0.5 * known.load), 2.0 * known.load)

    def _take(self, pair: frozenset[Hashable], load: float, time: float) -> None:
        known = self._known.get(pair)
        if known is None or not time - known.time > 0:
            self._known[pair] = _Load(load, time)
            return
        step = time - known.time
        share = step / self.time_constant if self.time_constant > 0 else 0.0
        if share * known.count >= 1.0:
            known.load += (load - known.load) * min(share, 1.0)
            known.slope = 0.0
        else:  # the line until the time constant has passed: a young contact may be an impact
            known.slope = (load - known.load) / step
            known.load = load
        known.count += 1
        known.time = time
