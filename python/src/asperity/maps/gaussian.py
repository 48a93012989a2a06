"""Whether heights are those of a Gaussian surface, as far as a map with few independent heights can tell."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt


def from_gaussian(heights: npt.NDArray[np.float64]) -> float:
    """How many standard errors the skew or the kurtosis of a map is off that of a Gaussian surface, whichever is more.

    Of a Gaussian field with the autocorrelation rho the variance of the skew of n heights is 6 sum(rho^3)/n, of the kurtosis
    24 sum(rho^4)/n, over all lags: neighbouring heights count once.
    """
    scaled = (heights - heights.mean()) / heights.std()
    power = np.square(np.abs(np.fft.rfft2(scaled)))
    rho = np.fft.irfft2(power, scaled.shape) / scaled.size
    off = np.abs([(scaled**3).mean(), (scaled**4).mean() - 3.0])
    independent = [np.abs((rho**3).sum()), (rho**4).sum()]
    return float(np.max(off / np.sqrt(np.array([6.0, 24.0]) * np.maximum(independent, 1.0) / scaled.size)))
