"""What of a map speaks against the summits found in it: spikes, noise, steps."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from .steps import Steps

Array = npt.NDArray[np.float64]

# Of white noise the mean square of second differences is the same over one point and over two; of waves of a few points it
# grows faster the longer the distance, of smooth surfaces 16-fold, of rough ones as a power. Noise on any of these grows
# less from one point to two than from two to four, by this factor, or not at all.
_BEND, _WHITE = 1.3, 1.5
# The median of the square of a normally distributed number of variance 1.
_MEDIAN_SQUARE = 0.454936

# A contact is seen in a map where it is at least so many points wide.
POINTS_PER_CONTACT = 4


class MapWarning(UserWarning):
    """Summits of a map that may not be those of the surface."""


class Differences(NamedTuple):
    """Squares of second differences of heights, over one point, two and four: medians, which spikes do not change, as means."""

    one: float
    two: float
    four: float


def differences(level: Array) -> Differences:
    """Of a map, means over both directions, from rows and columns that are evenly spread over it."""
    found = []
    for lag in (1, 2, 4):
        squares = []
        for heights in (level, level.T):
            lines = heights[:: max(len(heights) // 256, 1)]
            if lines.shape[1] > 2 * lag:
                second = lines[:, 2 * lag :] - 2 * lines[:, lag:-lag] + lines[:, : -2 * lag]
                squares.append(float(np.median(second**2)) / _MEDIAN_SQUARE)
        found.append(float(np.mean(squares)) if squares else 0.0)
    return Differences(*found)


def noise(found: Differences) -> float | None:
    """The standard deviation of noise in a map, if it has so much that it shows."""
    if not (found.one > 0 and found.two > 0):
        return None
    bends = found.four / found.two > _BEND * found.two / found.one or found.two < _WHITE * found.one
    # 16 for what is smooth, 1 for noise, whose second differences have 6 times its variance.
    variance = (16 * found.one - found.two) / 15 / 6
    return float(variance**0.5) if bends and variance > 0 else None


def remarks(
    spikes: int, points: int, found: Differences, height_std: float, steps: Steps | None
) -> tuple[str, ...]:
    """In words."""
    said = []
    if steps is not None:
        said.append(
            f"heights are in steps of {steps.step:.2g}, {steps.equal:.0%} of neighbouring points have one height: slopes are too "
            "steep and summits are merged: call surface.filter with a cutoff of 6 points or more"
        )
    if spikes:
        said.append(
            f"{spikes} points ({spikes / points:.2g} of all) stand out like spikes of an instrument, and determine the "
            "highest summits: call surface.clean, which replaces them"
        )
    deviation = noise(found)
    if deviation is not None:
        said.append(
            f"neighbouring points differ as by noise of {deviation:.2g} (summits: sigma {height_std:.2g}), which adds "
            "summits: call surface.filter to remove it, and surface.cutoffs to find the cutoff"
        )
    return tuple(said)


def unresolved(contact_radius: float, step: float) -> tuple[str, ...]:
    """Whether contacts of this mean radius are smaller than points this far apart, in words."""
    if contact_radius >= step:
        return ()
    return (
        f"the mean contact radius, {contact_radius:.2g}, is below the distance of the points, {step:.2g}: the map shows nothing "
        "of the size of a contact, and if the surface has finer waves than the map friction follows from its sampling; "
        "surface.cutoffs shows how much, or measure a finer map",
    )
