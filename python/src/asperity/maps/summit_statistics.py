"""From a height map to its summits and their statistics."""

from __future__ import annotations

import math
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import caller
from ..tools.progress import LARGE, Progress, teller
from . import map_warnings
from .at_scores import Sloped, sloped
from .input import checked, degree
from .spikes import spikes
from .steps import Steps, steps
from .summit_search import Found, find, without_polynomial
from .summits import Iso25178, SpectralMoments, Summits
from .tile_errors import estimates, height_and_slope, tiles, with_waves

Array = npt.NDArray[np.float64]

MIN_SUMMITS = 10
# Slopes are summed over so many rows at a time, which fit the processor's cache.
_BAND = 128


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
        Error: what the map, its distances or the degree may not be; fewer than 10 summits.
        TypeError: no real numbers; distances missing, or given twice.
        ImportError: SciPy is not installed.

    Warns:
        MapWarning: spikes, noise, steps: what `Summits.warnings` says.

    Source of the definitions: Greenwood and Williamson, Proc. R. Soc. A 295 (1966), 300; Nayak (1971).
    """
    _require_scipy()
    given = checked(height_map, dx, dy)
    raw, dx, dy, recorded = given.height_map, given.dx, given.dy, given.recorded
    tell = teller(progress, raw.size > LARGE)
    with np.errstate(over="ignore", invalid="ignore", divide="ignore", under="ignore"):
        tell(0.0, f"levelling {raw.shape[0]} x {raw.shape[1]} points")
        level = without_polynomial(raw, degree(detrend, raw.shape))
        if np.ptp(level) <= 1e4 * np.finfo(float).eps * max(abs(raw.min()), abs(raw.max())):
            raise Error("height_map: flat but for rounding: must be rough, beyond what detrend takes away")
        tell(0.2, "looking for summits")
        recorded = raw if recorded is None else recorded
        found = find(recorded, level, dx, dy)
        if found.height.size < MIN_SUMMITS:
            raise Error(
                f"height_map: has {found.height.size} summits on {raw.shape[0]} x {raw.shape[1]} points: "
                f"must have at least {MIN_SUMMITS}, and some hundred for good numbers; map a larger area, or with finer steps"
            )
        statistics = _statistics(found, level, sloped(level, dx, dy, given.noise), dx, dy, steps(recorded), tell)
    tell(1.0, f"found {statistics.count} summits")
    for warning in statistics.warnings:
        caller.warn(warning, map_warnings.MapWarning)
    return statistics


def _statistics(
    found: Found, level: Array, slopes: Sloped, dx: float, dy: float, stepped: Steps | None, tell: Callable[[float, str], None]
) -> Summits:
    ny, nx = level.shape
    curvature = (found.first_curvature + found.second_curvature) / 2
    tell(0.4, f"slopes and curvatures of {found.height.size} summits")
    moments, sdq, skewness, kurtosis_of_all = _of_heights(level, dx, dy)
    area = nx * dx * ny * dy
    for number in (area, moments.m0, moments.m2, moments.m4, curvature.min(), curvature.max()):
        if not 1e-300 < number < 1e300:
            raise Error(f"height_map, dx = {dx}, dy = {dy}: curvatures are out of the range of floating point")
    tile, areas = tiles(found.row, found.column, level.shape)
    mean, std = float(found.height.mean()), float(found.height.std())
    if not std > 1e-10 * float(np.ptp(level)):
        raise Error("height_map: all summits have one height: heights must vary")
    scaled = (found.height - mean) / std
    unit = float(curvature.mean())
    density, height_mean, height_std, skew, kurtosis, radius = estimates(scaled, curvature / unit, tile, areas)
    density = density.scaled(1 / ((ny - 2) * dy * (nx - 2) * dx))
    radius = radius.scaled(1 / unit)
    rms_height, rms_slope = height_and_slope(level, dx, dy)
    tell(0.6, "looking for spikes and noise")
    up = int(np.count_nonzero(spikes(level) & (level > 0)))
    sigma = height_std.scaled(std).value
    said = map_warnings.remarks(up, level.size, map_warnings.differences(level), sigma, stepped)
    arrays = (found.column * dx, found.row * dy, found.height)
    curvatures = np.stack([found.first_curvature, found.second_curvature], axis=1)
    for array in (*arrays, curvatures):
        array.setflags(write=False)
    return Summits(
        *arrays,
        curvatures,
        density=density,
        height_mean=height_mean.scaled(std, mean),
        height_std=with_waves(height_std.scaled(std), rms_height),
        skew=skew,
        kurtosis=kurtosis,
        radius=radius,
        rms_height=rms_height,
        rms_slope=rms_slope,
        moments=moments,
        iso=Iso25178(
            Sq=math.sqrt(moments.m0),
            Ssk=skewness,
            Sku=kurtosis_of_all,
            Sdq=sdq,
            Sds=density.value,
            Ssc=1 / radius.value,
        ),
        isotropy=slopes.isotropy,
        at_scores=slopes.at_scores,
        nominal_area=area,
        dx=dx,
        dy=dy,
        warnings=said,
    )


def _of_heights(level: Array, dx: float, dy: float) -> tuple[SpectralMoments, float, float, float]:
    """Spectral moments, root mean square gradient, skewness and kurtosis."""
    ny, nx = level.shape
    unit = np.abs([level.min(), level.max()]).max()
    sums = np.zeros(7)
    for first in range(0, ny, _BAND):
        heights = level[first : first + _BAND + 2] / unit  # two more rows, for differences along y
        band = heights[:_BAND]
        x, y, square = np.diff(band, axis=1), np.diff(heights[: _BAND + 1], axis=0), band * band
        parts = (band, x, y, np.diff(x, axis=1), np.diff(heights, 2, axis=0), square)
        sums += [*((one * one).sum() for one in parts), (square * band).sum()]
    counts = [ny * nx, ny * (nx - 1), (ny - 1) * nx, ny * (nx - 2), (ny - 2) * nx, ny * nx, ny * nx]
    m0, m2_x, m2_y, m4_x, m4_y, fourths, cubes = sums / counts
    m2_x, m2_y = m2_x * (unit / dx) ** 2, m2_y * (unit / dy) ** 2
    m4 = (m4_x * (unit / dx / dx) ** 2 + m4_y * (unit / dy / dy) ** 2) / 2
    moments = SpectralMoments(float(m0 * unit**2), float(m2_x + m2_y) / 2, float(m4))
    return moments, math.sqrt(m2_x + m2_y), float(cubes / m0**1.5), float(fourths / m0**2)


def _require_scipy() -> None:
    try:
        import scipy.special  # noqa: F401
    except ImportError as error:
        raise ImportError(f"finding summits needs SciPy ({error}): pip install scipy") from None
