"""What was found of the summits of a height map: values, from which parameters are made."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

from ..results import State
from .at_scores import AtScores
from .map_warnings import unresolved
from .tile_errors import Estimate

Array = npt.NDArray[np.float64]


@dataclass(frozen=True)
class SpectralMoments:
    """Moments of the spectrum of profiles, means over x and y, from differences between neighbouring heights.

    Differences damp waves: one of length L counts sinc(dx/L)^2 of its m2 and sinc(dx/L)^4 of its m4, with sinc(x) =
    sin(pi x)/(pi x), so both are low on a coarse grid.

    Attributes:
        m0: mean square height [length^2].
        m2: mean square slope of a profile [1].
        m4: mean square second derivative of a profile [1/length^2].
    """

    m0: float
    m2: float
    m4: float

    @property
    def bandwidth(self) -> float:
        """Nayak's alpha = m0 m4/m2^2 (J. Lubr. Technol. 93 (1971), 398): at least 1.5 for isotropic random surfaces."""
        return self.m0 * self.m4 / self.m2**2


@dataclass(frozen=True)
class Iso25178:
    """The map in the names of ISO 25178-2, and of EUR 15178 EN for the two of summits.

    Attributes:
        Sq: root mean square height [length].
        Ssk: skewness of the heights of the surface, not of its summits.
        Sku: kurtosis of the heights of the surface; 3 for Gaussian.
        Sdq: root mean square gradient [1].
        Sds: summits per area [1/length^2].
        Ssc: mean summit curvature [1/length]. ISO 25178-2 has Spd and Spc instead of Sds and Ssc: those count only the
            summits left after small hills are merged, and are lower.
    """

    Sq: float
    Ssk: float
    Sku: float
    Sdq: float
    Sds: float
    Ssc: float


@dataclass(frozen=True, eq=False)
class Summits:
    """The summits of a height map and their statistics, in the units of the map.

    Attributes:
        x: places of the summits along a row, from the first column [length], shape (count,).
        y: along a column, from the first row [length], shape (count,).
        heights: from the mean plane of the map (or what `detrend` took away) [length], shape (count,).
        curvatures: principal curvatures [1/length], the greater first, shape (count, 2). The second may be negative
            on a coarse grid: higher than 8 neighbours is not convex in all directions.
        density: summits per area [1/length^2].
        height_mean: of the summit heights [length].
        height_std: sigma of the summit heights [length].
        skew: of the summit heights.
        kurtosis: of the summit heights; 3 for Gaussian. At most count, so low for few summits.
        radius: R [length]: one over the mean of the mean curvatures, as of Nayak, McCool and Greenwood-Williamson.
        rms_height: Sq of the map [length].
        rms_slope: Sdq of the map.
        moments: spectral moments of the map.
        iso: the map in the names of ISO 25178.
        isotropy: lesser over greater principal mean square slope, 1 for isotropic, 0 for grooves.
        at_scores: heights and slopes of the map at normal scores, and its lay: what `Params.from_topography` takes.
        nominal_area: of the map [length^2].
        dx: distance of columns [length].
        dy: distance of rows [length].
        warnings: what of the map speaks against these numbers, in words; `summits` warns of them too.
    """

    x: Array = field(repr=False)
    y: Array = field(repr=False)
    heights: Array = field(repr=False)
    curvatures: Array = field(repr=False)
    density: Estimate
    height_mean: Estimate
    height_std: Estimate
    skew: Estimate
    kurtosis: Estimate
    radius: Estimate
    rms_height: Estimate
    rms_slope: Estimate
    moments: SpectralMoments
    iso: Iso25178
    isotropy: float
    at_scores: AtScores
    nominal_area: float
    dx: float
    dy: float
    warnings: tuple[str, ...]

    def warnings_at(self, state: State) -> tuple[str, ...]:
        """What speaks against friction in a state, in words: `warnings`, and contacts that the map does not resolve.

        Args:
            state: of a model made of these summits, in the same unit of length: `model.state_at_load(load)`.
        """
        return self.warnings + unresolved(state.mean_contact_radius, max(self.dx, self.dy))

    @property
    def count(self) -> int:
        """How many summits the map has."""
        return self.heights.size

    @property
    def radii(self) -> Array:
        """One over the mean of both curvatures of each summit [length], shape (count,)."""
        return np.asarray(2 / self.curvatures.sum(axis=1))
