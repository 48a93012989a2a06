"""What surfaces are like whose roughness was measured by one or two numbers: the rest, with how well it is known.

Ra by machining process has a source. For slopes of machined surfaces none was found that names its sampling length, so that
these are assumptions, with wide bands; docs/domain.md tells what they are held against.
"""

from __future__ import annotations

import math
from typing import NamedTuple


class Known(NamedTuple):
    """A positive number that is known to a factor: log-normal, with 95 % of its probability within `factor` either way."""

    middle: float
    factor: float = 1.0

    @classmethod
    def between(cls, low: float, high: float) -> Known:
        """With 95 % of its probability between two numbers."""
        return cls(math.sqrt(low * high), math.sqrt(high / low))

    @property
    def low(self) -> float:
        return self.middle / self.factor

    @property
    def high(self) -> float:
        return self.middle * self.factor


# Ra [m] of machined metal: CalQlata, Surface Finish (machining); Machinery's Handbook (25th edition, p. 708) has the same as
# a chart (quoted).
PROCESSES: dict[str, tuple[float, float]] = {
    "superfinished": (0.05e-6, 0.2e-6),
    "lapped": (0.05e-6, 0.4e-6),
    "honed": (0.1e-6, 0.8e-6),
    "ground": (0.1e-6, 1.6e-6),
    "turned": (0.4e-6, 6.3e-6),
    "bored": (0.4e-6, 6.3e-6),
    "milled": (0.8e-6, 6.3e-6),
}

def deviation_of(mean_deviation: float) -> float:
    """Rq from Ra, of Gaussian heights."""
    return math.sqrt(math.pi / 2) * mean_deviation


def machined_slope(deviation: float) -> float:
    """The root mean square slope along a profile of a machined surface with this Rq [m]: assumed, to `SLOPE_FACTOR`."""
    return 0.14 * math.sqrt(deviation / 1e-6)


# 95 % of the slopes are taken to lie within this factor either way.
SLOPE_FACTOR = 4.0
