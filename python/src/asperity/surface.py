"""From a measured height map to the statistics of its summits, which a friction law is made of.

    from asperity import Params, surface

    summits = surface.summits(*surface.read("scan.x3p"))
    params = Params.from_topography(summits, E1=160e9, ...)

The search is in `_summit_search`, standard errors in `_tile_errors`, eq (3) in `_radius_trend`, files in
`_instrument_files`. Needs the extra `topography`, for SciPy and for the files.
"""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from ._instrument_files import HeightMap, read
from ._radius_trend import RadiusTrend, fit
from ._summit_search import Found, find, without_polynomial
from ._tile_errors import Estimate, estimates, tiles

__all__ = ["Estimate", "HeightMap", "Iso25178", "RadiusTrend", "SpectralMoments", "Summits", "read", "summits"]

Array = npt.NDArray[np.float64]

MIN_SUMMITS = 10
MIN_BINS, MAX_BINS = 4, 254


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


def summits(height_map: npt.ArrayLike, dx: float, dy: float, *, detrend: int = 1) -> Summits:
    """Finds the summits of a height map: the points higher than their 8 neighbours.

    Neighbours of equal height are one summit, with the mean of their places and curvatures, if all around is lower.
    The outermost rows and columns have no summits, nor has a plateau that reaches them. Curvatures are central second
    differences over 3 x 3 points.

    Two rough surfaces are one rough surface against a flat: add their maps.

    Args:
        height_map: heights in one unit of length, shape (rows along y, columns along x), each at least 3; float64 or
            what becomes it. All must be finite: crop the map, or fill what the instrument did not see.
        dx: distance of columns > 0, in the same unit.
        dy: distance of rows > 0.
        detrend: degree of the polynomial in x and y that is subtracted, by least squares: 0 the mean, 1 a plane (tilt
            of the sample), 2 a paraboloid (its form).

    Raises:
        ValueError: what the map, its distances or the degree may not be; fewer than 10 summits.
        TypeError: no real numbers.
        ImportError: SciPy is not installed.

    Source of the definitions: Greenwood and Williamson, Proc. R. Soc. A 295 (1966), 300; Nayak (1971).
    """
    _require_scipy()
    raw = _checked_map(height_map)
    dx, dy = _checked_length("dx", dx), _checked_length("dy", dy)
    if isinstance(detrend, bool) or detrend not in (0, 1, 2):
        raise ValueError(f"detrend = {detrend!r}: must be 0, 1 or 2")
    with np.errstate(over="ignore", invalid="ignore", divide="ignore", under="ignore"):
        level = without_polynomial(raw, detrend)
        if np.ptp(level) <= 1e4 * np.finfo(float).eps * np.abs(raw).max():
            raise ValueError("height_map: flat but for rounding: must be rough, beyond what detrend takes away")
        found = find(raw, level, dx, dy)
        if found.height.size < MIN_SUMMITS:
            raise ValueError(
                f"height_map: has {found.height.size} summits on {raw.shape[0]} x {raw.shape[1]} points: "
                f"must have at least {MIN_SUMMITS}"
            )
        return _statistics(found, level, dx, dy)


def _statistics(found: Found, level: Array, dx: float, dy: float) -> Summits:
    ny, nx = level.shape
    curvature = (found.first_curvature + found.second_curvature) / 2
    moments, sdq, gradient_moments = _of_slopes(level, dx, dy)
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
    surface = level / math.sqrt(moments.m0)
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
            Ssk=float((surface**3).mean()),
            Sku=float((surface**4).mean()),
            Sdq=sdq,
            Sds=density.value,
            Ssc=1 / radius.value,
        ),
        isotropy=max(float(lesser / greater), 0.0),
        nominal_area=area,
    )


def _of_slopes(level: Array, dx: float, dy: float) -> tuple[SpectralMoments, float, Array]:
    """Spectral moments, root mean square gradient, mean of the gradient times itself (2 x 2)."""
    along_x, along_y = np.diff(level, axis=1) / dx, np.diff(level, axis=0) / dy
    m2_x, m2_y = float((along_x**2).mean()), float((along_y**2).mean())
    m4_x = float(((np.diff(along_x, axis=1) / dx) ** 2).mean())
    m4_y = float(((np.diff(along_y, axis=0) / dy) ** 2).mean())
    moments = SpectralMoments(float((level**2).mean()), (m2_x + m2_y) / 2, (m4_x + m4_y) / 2)
    # In the middle of four points, where both slopes are known.
    gradient = np.stack([(along_x[1:] + along_x[:-1]).ravel(), (along_y[:, 1:] + along_y[:, :-1]).ravel()]) / 2
    return moments, math.sqrt(m2_x + m2_y), np.asarray(gradient @ gradient.T) / gradient.shape[1]


def _checked_map(height_map: Any) -> Array:
    if np.ma.is_masked(height_map):
        missing = int(np.ma.getmaskarray(height_map).sum())
        raise ValueError(f"height_map: {missing} heights are masked: all must be known; crop the map or fill them")
    array = np.asarray(height_map)
    if array.dtype.kind not in "iuf":
        raise TypeError(f"height_map: must be real numbers, not an array of {array.dtype}")
    if array.ndim != 2 or min(array.shape) < 3:
        raise ValueError(f"height_map: has shape {array.shape}: must be 2-D, with at least 3 rows and 3 columns")
    array = np.asarray(array, dtype=np.float64)
    bad = ~np.isfinite(array)
    if bad.any():
        row, column = (int(index) for index in np.unravel_index(int(np.argmax(bad)), bad.shape))
        raise ValueError(
            f"height_map: {int(bad.sum())} of {bad.size} heights are not finite, the first is "
            f"{array[row, column]} at [{row}, {column}]: all must be; crop the map or fill them"
        )
    if array.min() == array.max():
        raise ValueError(f"height_map: constant at {array[0, 0]}: must be rough")
    return array


def _checked_length(name: str, value: Any) -> float:
    if not isinstance(value, numbers.Real):
        raise TypeError(f"{name} = {value!r}: must be a real number")
    length = float(value)
    if not (math.isfinite(length) and length > 0):
        raise ValueError(f"{name} = {length}: must be finite and > 0")
    return length


def _require_scipy() -> None:
    try:
        import scipy.optimize  # noqa: F401
    except ImportError as error:
        raise ImportError(f"finding summits needs SciPy ({error}): pip install 'asperity[topography]'") from None
