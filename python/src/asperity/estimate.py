"""A friction coefficient with the band that it is known within, as `asperity.friction` returns it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np


@dataclass(frozen=True, eq=False, repr=False)
class Estimate:
    """A friction coefficient, or many, with a band: a number that says how far it can be trusted.

    `float(estimate)` and `numpy.asarray(estimate)` are the coefficient alone.

    Attributes:
        value: F/P: a float for one load, else what the loads came in, with the same shape and labels.
        low: lower end of the band, like `value`; None where all inputs count as known.
        high: upper end; None with it.
        coverage: the probability that the coefficient lies between `low` and `high`; None with them.
        rests_on: what was taken for granted, a line each; first the strength of the interface.
        narrow: what would make the band narrower, a line each.
    """

    value: Any
    low: Any
    high: Any
    coverage: float | None
    rests_on: tuple[str, ...]
    narrow: tuple[str, ...]

    def __float__(self) -> float:
        return float(self.value)

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.array(self.value, dtype=dtype)

    def __format__(self, spec: str) -> str:
        """With a format of numbers, as in f"{estimate:.3f}": the coefficient and its band; else all of it."""
        if not spec:
            return repr(self)
        ends = zip(*(np.ravel(end) for end in (self.low, self.high))) if self.low is not None else None
        shown = []
        for value in np.ravel(self.value):
            low_high = f" ({' to '.join(format(float(end), spec) for end in next(ends))})" if ends else ""
            shown.append(format(float(value), spec) + low_high)
        return ", ".join(shown)

    def __repr__(self) -> str:
        band = "no band: all inputs count as known" if self.coverage is None else f"{100 * self.coverage:g} % band"
        shown = f"{self:.3g}" if np.size(self.value) <= 8 else f"friction coefficients at {np.size(self.value)} loads"
        lines = [f"{shown}; {band}", *(f"rests on: {line}" for line in self.rests_on)]
        return "\n".join([*lines, *(f"to narrow it: {line}" for line in self.narrow)])
