"""Isotropic Gaussian surfaces of a given spectrum, and what theory says of their summits: to check `asperity.surface`.

Lengths are in points of the map.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class GaussianSurface:
    """Periodic Gaussian surface of variance 1: power q^-fall at wave numbers q from `lowest` to 1 times 2 pi/shortest.

    Attributes:
        points: of the square map along a side.
        shortest: wavelength, at least 2.
        lowest: least wave number, in units of the greatest; 0 takes all but the mean.
        fall: 0 for equal power, 2 + 2H for a self-affine surface of Hurst exponent H.
    """

    points: int
    shortest: float
    lowest: float = 0.0
    fall: float = 0.0

    def map(self, seed: int) -> Array:
        """Heights, shape (points, points): white noise, filtered."""
        shape = self.points, self.points
        noise = np.fft.rfft2(np.random.default_rng(seed).normal(size=shape))
        half = self._power[:, : self.points // 2 + 1]
        heights: Array = np.fft.irfft2(noise * np.sqrt(half / self._power.mean()), s=shape)
        return heights

    def moments(self) -> tuple[float, float, float]:
        """m0, m2 and m4: sums over the waves that the map has."""
        return 1.0, self._mean(self._squares) / 2, self._mean(self._squares**2) * 3 / 8

    def moments_by_differences(self) -> tuple[float, float]:
        """m2 and m4 as neighbouring points tell them: of a wave k along x they see (2 sin(k/2))^2, not k^2."""
        seen = np.broadcast_to((2 * np.sin(self._along / 2)) ** 2, self._power.shape)
        return self._mean(seen), self._mean(seen**2)

    @cached_property
    def _along(self) -> Array:
        waves: Array = np.asarray(2 * np.pi * np.fft.fftfreq(self.points), dtype=np.float64)
        return waves

    @cached_property
    def _squares(self) -> Array:
        squares: Array = self._along[:, None] ** 2 + self._along**2
        return squares

    @cached_property
    def _power(self) -> Array:
        waves, greatest = np.sqrt(self._squares), 2 * np.pi / self.shortest
        inside = (waves <= greatest) & (waves > self.lowest * greatest) & (waves > 0)
        power: Array = np.where(inside, np.where(inside, waves, 1.0) ** -self.fall, 0.0)
        return power

    def _mean(self, values: Array) -> float:
        return float((self._power * values).sum() / self._power.sum())


@dataclass(frozen=True)
class Nayak:
    """The summits of an isotropic Gaussian surface of these spectral moments (J. Lubr. Technol. 93 (1971), 398)."""

    m0: float
    m2: float
    m4: float

    @property
    def bandwidth(self) -> float:
        """alpha."""
        return self.m0 * self.m4 / self.m2**2

    @property
    def density(self) -> float:
        """Summits per area."""
        return self.m4 / (6 * math.pi * math.sqrt(3) * self.m2)

    @property
    def radius(self) -> float:
        """One over the mean of the mean summit curvature, which is 8/3 (m4/pi)^(1/2)."""
        return 3 / 8 * math.sqrt(math.pi / self.m4)

    def height_moments(self) -> tuple[float, float, float, float]:
        """Mean, standard deviation, skew and kurtosis of the summit heights, integrated."""
        z, joint = self._joint()
        weights = joint.sum(axis=1) / joint.sum()
        mean = float(z @ weights)
        square, cube, fourth = (float((z - mean) ** power @ weights) for power in (2, 3, 4))
        return mean, math.sqrt(square), cube / square**1.5, fourth / square**2

    def _joint(self) -> tuple[Array, Array]:
        """Heights z, and their joint density with mean curvatures t on the grid of both.

        With t in (2 m4/3)^(1/2): the two curvatures of a Gaussian surface weighted by their product, over the
        directions, leave exp(-t^2/2) (t^2 - 1 + exp(-t^2)). Heights are Gaussian given t, their correlation with t
        over all points is (3/(2 alpha))^(1/2).
        """
        correlation = math.sqrt(1.5 / self.bandwidth)
        t, z = np.linspace(0, 8, 801), np.linspace(-5, 7, 1201)
        density = np.exp(-(t**2) / 2) * (t**2 - 1 + np.exp(-(t**2)))
        density = density * np.exp(-((z[:, None] - correlation * t) ** 2) / (2 * (1 - correlation**2)))
        return z * math.sqrt(self.m0), density
