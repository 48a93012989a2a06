"""From a measured height map to the statistics of its summits, which a friction law is made of.

    from asperity import Params, surface

    cleaned = surface.clean(surface.read("scan.x3p"))
    summits = surface.summits(surface.filter(cleaned.map, cutoff=0.2e-6))
    params = Params.from_topography(summits, E1=160e9, ...)

The search is in `_summit_search`, standard errors in `_tile_errors`, eq (3) in `_radius_trend`, files in
`_instrument_files`, what speaks against a map in `_map_warnings`, friction against the cutoff in `_map_cutoffs`. Needs the
extra `topography`, for SciPy and for the files.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Callable

import numpy as np
import numpy.typing as npt

from . import _caller, _map_warnings
from ._instrument_files import HeightMap, read
from ._map_cleaning import Cleaned, clean
from ._map_cutoffs import Cutoffs, cutoffs
from ._map_filter import filter
from ._map_input import checked, degree
from ._map_spikes import spikes
from ._map_warnings import MapWarning, unresolved
from ._progress import LARGE, Progress, teller
from ._radius_trend import RadiusTrend, fit
from ._summit_search import Found, find, without_polynomial
from ._tile_errors import Estimate, estimates, tiles

if TYPE_CHECKING:
    from .results import State

__all__ = [
    "Cleaned",
    "Cutoffs",
    "Estimate",
    "HeightMap",
    "Iso25178",
    "MapWarning",
    "RadiusTrend",
    "SpectralMoments",
    "Summits",
    "clean",
    "cutoffs",
    "filter",
    "read",
    "summits",
]

Array = npt.NDArray[np.float64]

MIN_SUMMITS = 10
MIN_BINS, MAX_BINS = 4, 254
# Slopes are summed over so many rows at a time, which fit the processor's cache.
_BAND = 128


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
        radius_trend: radius against height, eq (3) of the paper.
        moments: spectral moments of the map.
        iso: the map in the names of ISO 25178.
        isotropy: lesser over greater principal mean square slope, 1 for isotropic, 0 for grooves. The model, as all
            that take one radius for a summit, is of isotropic surfaces.
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
    radius_trend: RadiusTrend
    moments: SpectralMoments
    iso: Iso25178
    isotropy: float
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

    def histogram(self) -> tuple[Array, Array]:
        """Heights [length] and their density [1/length], as `Params` tabulates it.

        Bins of the width of Freedman and Diaconis (1981), 2 IQR/count^(1/3), at least 4 and at most 254, so that the
        table is no longer than a law can resolve: their middles, and at both ends an edge, where the density is 0.
        """
        bins = np.histogram_bin_edges(self.heights, "fd").size - 1
        bins = min(max(bins, MIN_BINS), MAX_BINS)
        density, edges = np.histogram(self.heights, bins=bins, density=True)
        height = np.concatenate([edges[:1], (edges[1:] + edges[:-1]) / 2, edges[-1:]])
        return height, np.concatenate([[0.0], density, [0.0]])


def summits(
    height_map: Any, dx: float | None = None, dy: float | None = None, *, detrend: int = 1, progress: Progress = None
) -> Summits:
    """Finds the summits of a height map: the points higher than their 8 neighbours.

    Neighbours of equal height are one summit, with the mean of their places and curvatures, if all around is lower.
    The outermost rows and columns have no summits, nor has a plateau that reaches them. Curvatures are central second
    differences over 3 x 3 points.

    Two rough surfaces are one rough surface against a flat: add their maps.

    Args:
        height_map: a `HeightMap` as `read`, `filter` and `clean(...).map` give it; a `SurfaceTopography.Topography`, which
            counts in metres; or heights in one unit of length, shape (rows along y, columns along x), each at least 3;
            float64 or what becomes it. All must be known: `clean` fills what the instrument did not see.
        dx: distance of columns > 0, in the same unit; not for maps that have it.
        dy: distance of rows > 0; by default dx.
        detrend: degree of the polynomial in x and y that is subtracted, by least squares: 0 the mean, 1 a plane (tilt
            of the sample), 2 a paraboloid (its form).
        progress: whether to tell what is being done, on the error stream, or a function of the part done, 0 to 1, and of
            what is being done; by default it is told for maps of more than 2 million points.

    Raises:
        ValueError: what the map, its distances or the degree may not be; fewer than 10 summits.
        TypeError: no real numbers; distances missing, or given twice.
        ImportError: SciPy is not installed.

    Warns:
        MapWarning: spikes, noise, a direction: what `Summits.warnings` says.

    Source of the definitions: Greenwood and Williamson, Proc. R. Soc. A 295 (1966), 300; Nayak (1971).
    """
    _require_scipy()
    raw, dx, dy = checked(height_map, dx, dy)
    tell = teller(progress, raw.size > LARGE)
    with np.errstate(over="ignore", invalid="ignore", divide="ignore", under="ignore"):
        tell(0.0, f"levelling {raw.shape[0]} x {raw.shape[1]} points")
        level = without_polynomial(raw, degree(detrend))
        if np.ptp(level) <= 1e4 * np.finfo(float).eps * max(abs(raw.min()), abs(raw.max())):
            raise ValueError("height_map: flat but for rounding: must be rough, beyond what detrend takes away")
        tell(0.2, "looking for summits")
        found = find(raw, level, dx, dy)
        if found.height.size < MIN_SUMMITS:
            raise ValueError(
                f"height_map: has {found.height.size} summits on {raw.shape[0]} x {raw.shape[1]} points: "
                f"must have at least {MIN_SUMMITS}, and some hundred for good numbers; map a larger area, or with finer steps"
            )
        statistics = _statistics(found, level, dx, dy, tell)
    tell(1.0, f"found {statistics.count} summits")
    for warning in statistics.warnings:
        _caller.warn(warning, MapWarning)
    return statistics


def _statistics(found: Found, level: Array, dx: float, dy: float, tell: Callable[[float, str], None]) -> Summits:
    ny, nx = level.shape
    curvature = (found.first_curvature + found.second_curvature) / 2
    tell(0.4, f"slopes and curvatures beside {found.height.size} summits")
    moments, sdq, gradient_moments, skewness, kurtosis_of_all = _of_heights(level, dx, dy)
    area = nx * dx * ny * dy
    for number in (area, moments.m0, moments.m2, moments.m4, curvature.min(), curvature.max()):
        if not 1e-300 < number < 1e300:
            raise ValueError(f"height_map, dx = {dx}, dy = {dy}: curvatures are out of the range of floating point")
    lesser, greater = np.linalg.eigvalsh(gradient_moments / moments.m2)
    tile, areas = tiles(found.row, found.column, level.shape)
    mean, std = float(found.height.mean()), float(found.height.std())
    if not std > 1e-10 * float(np.ptp(level)):
        raise ValueError("height_map: all summits have one height: heights must vary")
    scaled = (found.height - mean) / std
    unit = float(curvature.mean())
    density, height_mean, height_std, skew, kurtosis, radius = estimates(scaled, curvature / unit, tile, areas)
    density = density.scaled(1 / ((ny - 2) * dy * (nx - 2) * dx))
    radius = radius.scaled(1 / unit)
    isotropy = max(float(lesser / greater), 0.0)
    tell(0.6, "looking for spikes and noise")
    up = int(np.count_nonzero(spikes(level) & (level > 0)))
    said = _map_warnings.remarks(up, level.size, _map_warnings.differences(level), isotropy, height_std.scaled(std).value)
    tell(0.9, "fitting radius against height")
    arrays = (found.column * dx, found.row * dy, found.height)
    curvatures = np.stack([found.first_curvature, found.second_curvature], axis=1)
    for array in (*arrays, curvatures):
        array.setflags(write=False)
    return Summits(
        *arrays,
        curvatures,
        density=density,
        height_mean=height_mean.scaled(std, mean),
        height_std=height_std.scaled(std),
        skew=skew,
        kurtosis=kurtosis,
        radius=radius,
        radius_trend=fit(scaled, curvature, tile),
        moments=moments,
        iso=Iso25178(
            Sq=math.sqrt(moments.m0),
            Ssk=skewness,
            Sku=kurtosis_of_all,
            Sdq=sdq,
            Sds=density.value,
            Ssc=1 / radius.value,
        ),
        isotropy=isotropy,
        nominal_area=area,
        dx=dx,
        dy=dy,
        warnings=said,
    )


def _of_heights(level: Array, dx: float, dy: float) -> tuple[SpectralMoments, float, Array, float, float]:
    """Spectral moments, root mean square gradient, mean of the gradient times itself (2 x 2), skewness and kurtosis."""
    ny, nx = level.shape
    unit = np.abs([level.min(), level.max()]).max()
    sums, slopes = np.zeros(7), np.zeros((2, 2))
    for first in range(0, ny, _BAND):
        heights = level[first : first + _BAND + 2] / unit  # two more rows, for differences along y
        band = heights[:_BAND]
        x, y, square = np.diff(heights[: _BAND + 1], axis=1), np.diff(heights[: _BAND + 1], axis=0), band * band
        parts = (band, x[: len(band)], y, np.diff(x[: len(band)], axis=1), np.diff(heights, 2, axis=0), square)
        sums += [*((one * one).sum() for one in parts), (square * band).sum()]
        # In the middle of four points, where both slopes are known.
        middle = x[1:] + x[:-1], y[:, 1:] + y[:, :-1]
        slopes += [[(one * other).sum() / 4 for other in middle] for one in middle]
    counts = [ny * nx, ny * (nx - 1), (ny - 1) * nx, ny * (nx - 2), (ny - 2) * nx, ny * nx, ny * nx]
    m0, m2_x, m2_y, m4_x, m4_y, fourths, cubes = sums / counts
    m2_x, m2_y = m2_x * (unit / dx) ** 2, m2_y * (unit / dy) ** 2
    m4 = (m4_x * (unit / dx / dx) ** 2 + m4_y * (unit / dy / dy) ** 2) / 2
    moments = SpectralMoments(float(m0 * unit**2), float(m2_x + m2_y) / 2, float(m4))
    steps = np.array([unit / dx, unit / dy])
    gradients = slopes * np.outer(steps, steps) / ((ny - 1) * (nx - 1))
    return moments, math.sqrt(m2_x + m2_y), gradients, float(cubes / m0**1.5), float(fourths / m0**2)


def _require_scipy() -> None:
    try:
        import scipy.optimize  # noqa: F401
    except ImportError as error:
        raise ImportError(f"finding summits needs SciPy ({error}): pip install 'asperity[topography]'") from None
