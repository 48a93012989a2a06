"""Height maps from the files of instruments, read by the package SurfaceTopography; here only units and errors."""

from __future__ import annotations

import os
import warnings
from dataclasses import dataclass, field
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class HeightMap:
    """Heights on a grid, in metres; `heights, dx, dy = read(file)` takes it apart.

    Attributes:
        height_map: heights [m], shape (rows along y, columns along x); NaN where the instrument saw nothing.
        dx: distance of columns [m].
        dy: distance of rows [m].
        recorded: heights before they were levelled, of which equal neighbours are one plateau; None if they are `height_map`.
    """

    height_map: Array
    dx: float
    dy: float
    recorded: Array | None = field(default=None, repr=False)

    def __iter__(self) -> Iterator[Any]:
        return iter((self.height_map, self.dx, self.dy))


def read(
    path: str | os.PathLike[str],
    *,
    channel: int | str | None = None,
    unit: str | None = None,
    physical_sizes: tuple[float, float] | None = None,
) -> HeightMap:
    """Reads a height map of an AFM, profilometer or interferometer, in any format that SurfaceTopography knows.

    Some forty formats, among them X3P (ISO 25178-72), SDF (ISO 25178-71), Gwyddion, Bruker/Digital Instruments, WSxM,
    Igor, Zygo MetroPro, Sensofar, Keyence, NetCDF and text. Needs the extra `topography`.

    Args:
        path: of the file; its format is found from its content.
        channel: number or name of the channel; without, the default one of the format.
        unit: of lengths, where the file names none: "m", "mm", "µm", "nm", ...; heights and sizes alike.
        physical_sizes: of the map along x and y, in that unit, where the file has none.

    Raises:
        ImportError: SurfaceTopography is not installed.
        OSError: there is no such file, or it cannot be opened.
        ValueError: no known format; no such channel; a profile, or no heights; a unit or size missing, or given
            although the file has it.
    """
    library = _library()
    name = os.fspath(path)
    with open(name, "rb"):
        pass  # says what is wrong with the path, in the system's words
    try:
        with library.open_topography(name) as reader:
            chosen = _channel(name, reader, channel)
            return _in_metres(name, chosen, unit, physical_sizes)
    except library.Exceptions.CannotDetectFileFormat:
        raise ValueError(
            f"{name}: no format that SurfaceTopography knows; of a table of numbers give surface.summits the array, as "
            "numpy.loadtxt(file, delimiter=',') reads it, with the distances dx and dy in its unit"
        ) from None
    except library.Exceptions.ReadFileError as error:
        raise ValueError(f"{name}: {error}") from None


def _library() -> Any:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ImportWarning)  # that mpi4py is missing, which is of no use here
            import SurfaceTopography
    except ImportError as error:
        raise ImportError(
            f"reading a file of an instrument needs SurfaceTopography ({error}): pip install 'asperity[topography]', "
            "with Python 3.10 or later"
        ) from None
    return SurfaceTopography


def _channel(name: str, reader: Any, wanted: int | str | None) -> Any:
    if wanted is None:
        return reader.default_channel
    for index, channel in enumerate(reader.channels):
        if wanted in (index, channel.name):
            return channel
    names = ", ".join(f"{index} '{channel.name}'" for index, channel in enumerate(reader.channels))
    raise ValueError(f"{name}: channel = {wanted!r}: must be one of {names}")


def _in_metres(name: str, channel: Any, unit: str | None, sizes: tuple[float, float] | None) -> HeightMap:
    if channel.dim != 2:
        raise ValueError(f"{name}: channel '{channel.name}' is a profile: must be a map")
    if channel.data_kind.value != "height":
        raise ValueError(f"{name}: channel '{channel.name}' holds {channel.data_kind.value}: must hold heights")
    if channel.unit is None and unit is None:
        raise ValueError(f"{name}: the file names no unit of length: give unit='nm' or the like")
    if channel.physical_sizes is None and sizes is None:
        raise ValueError(f"{name}: the file has no size: give physical_sizes=(along x, along y)")
    if sizes is not None and not (np.shape(sizes) == (2,) and np.all(np.isfinite(sizes)) and np.min(sizes) > 0):
        raise ValueError(f"physical_sizes = {sizes}: must be two finite numbers > 0, along x and y")
    given = {"unit": unit, "physical_sizes": sizes}
    topography = channel.topography(**{key: value for key, value in given.items() if value is not None})
    return of_topography(topography)


def of_topography(topography: Any) -> HeightMap:
    """The map of a `SurfaceTopography.Topography`, in metres if it has a unit, else in its own."""
    if getattr(topography, "dim", None) != 2:
        raise ValueError("height_map: this topography is no map of heights over x and y")
    if topography.unit is not None:
        topography = topography.to_unit("m")
    # SurfaceTopography's first axis is x.
    masked: Any = topography.heights()
    heights: Array = np.ma.filled(np.ma.asarray(masked, dtype=np.float64), np.nan)
    dx, dy = map(float, topography.pixel_size)
    return HeightMap(np.ascontiguousarray(heights.T), dx, dy)
