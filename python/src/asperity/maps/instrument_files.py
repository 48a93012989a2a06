"""Height maps from the files of instruments, read by the package SurfaceTopography; here only units, sizes and errors."""

from __future__ import annotations

import gzip
import os
import re
import warnings
import zipfile
import zlib
from dataclasses import dataclass, field
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import checks
from . import text_maps

Array = npt.NDArray[np.float64]

# What no map has: a side or heights of this many metres, root mean square differences of neighbours over their distance.
_SIDE, _HEIGHTS, _SLOPES = (1e-9, 1.0), 0.1, (1e-7, 100.0)
_MOST_BYTES = 2**32
# Channels that files of some formats give as heights.
_OTHER = re.compile("phase|error|deflection|amplitude|current|friction|lateral|potential|adhesion", re.IGNORECASE)


@dataclass(frozen=True, eq=False)
class HeightMap:
    """Heights on a grid, in metres; `heights, dx, dy = read(file)` takes it apart.

    Attributes:
        height_map: heights [m], shape (rows along y, columns along x); NaN where the instrument saw nothing.
        dx: distance of columns [m].
        dy: distance of rows [m].
        recorded: heights before they were levelled, of which equal neighbours are one plateau; None if they are `height_map`.
        channel: name of the channel that was read.
        channels: names of all channels of the file.
        unit: "m"; "length" of a map that was made of plain numbers, in a unit of the caller's.
        noise: mean square gradient of the noise that a filter left.
    """

    height_map: Array
    dx: float
    dy: float
    recorded: Array | None = field(default=None, repr=False)
    channel: str = ""
    channels: tuple[str, ...] = ()
    unit: str = "m"
    noise: float = 0.0

    def __iter__(self) -> Iterator[Any]:
        return iter((self.height_map, self.dx, self.dy))


def read(
    path: str | os.PathLike[str],
    *,
    channel: int | str | None = None,
    unit: str | tuple[str, str] | None = None,
    physical_sizes: Any = None,
) -> HeightMap:
    """Reads a height map of an AFM, profilometer or interferometer, in any format that SurfaceTopography knows.

    Some forty formats, among them X3P (ISO 25178-72), SDF (ISO 25178-71), Gwyddion, Bruker/Digital Instruments, WSxM,
    Igor, Zygo MetroPro, Sensofar, Keyence, NetCDF and text; compressed by gzip too. Text may have decimal commas and words or
    dashes for missing points; three columns are x, y and z of points on a grid. Needs the extra `topography`.

    Args:
        path: of the file; its format is found from its content.
        channel: number or name of the channel; without, the only one that is a map of heights.
        unit: of lengths, where the file names none: "m", "mm", "µm", "nm", ...; of heights and sizes alike, or two, as ("mm", "µm"):
            of x and y, and of the heights.
        physical_sizes: two numbers, of the map along x and y, in that unit, where the file has none; in metres, where those of the file are
            such as no map has.

    Raises:
        ImportError: SurfaceTopography is not installed.
        OSError: there is no such file, or it cannot be opened.
        Error: no known format, or a damaged file; several maps of heights and no `channel`, or no such channel; a profile, or no
            heights; a unit or size missing, or given although the file has it; sizes or slopes that no map has.
    """
    library = _library()
    name = os.fspath(path)
    with open(name, "rb") as file:
        first = file.read(2)  # an OSError says what is wrong with the path, in the system's words
    if not first:
        raise Error(f"{name}: is empty: copy it again")
    if physical_sizes is not None:
        physical_sizes = tuple(checks.array("physical_sizes", physical_sizes, _lateral(unit) or "length").tolist())
    given = channel, unit, physical_sizes
    if first != b"\x1f\x8b":
        return _read(library, name, name, *given)
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        inside = os.path.join(folder, os.path.basename(name).removesuffix(".gz"))
        try:
            with gzip.open(name) as packed, open(inside, "wb") as plain:
                while some := packed.read(2**20):
                    plain.write(some)
                    if plain.tell() > _MOST_BYTES:
                        raise Error(f"{name}: has more than {_MOST_BYTES} bytes unpacked: unpack it, and crop the map")
        except (OSError, EOFError) as error:
            raise Error(f"{name}: damaged gzip file ({error}): copy it again") from None
        return _read(library, name, inside, *given)


def _read(library: Any, name: str, file: str, channel: Any, unit: Any, sizes: Any) -> HeightMap:
    """Of a file that is called `name`."""
    table = text_maps.table(file)
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        files = [file]
        if table is not None:  # what the library reads wrongly, or cannot read
            plain = os.path.join(folder, "table.txt")
            table.write(plain)
            files = [plain, file] if table.odd else [file, plain]
        for one in files:
            try:
                return _opened(library, name, one, table, channel, unit, sizes)
            except library.Exceptions.CannotDetectFileFormat:
                pass
    if why := _why_no_x3p(library, file):
        raise Error(f"{name}: an X3P that SurfaceTopography does not read: {why}; save it anew by another program, or as SDF")
    raise Error(
        f"{name}: no format that SurfaceTopography knows: export it as X3P, SDF or Gwyddion's format, unpack it if it is an archive, or "
        "give surface.summits the array with the distances dx and dy in its unit"
    )


def _lateral(unit: Any) -> Any:
    """The unit of x and y."""
    return unit if unit is None or isinstance(unit, str) else unit[0]


def _of_heights(unit: Any) -> Any:
    return unit if unit is None or isinstance(unit, str) else unit[1]


def _why_no_x3p(library: Any, file: str) -> str | None:
    """Why an archive with the index of an X3P is not read, in the words of the reader; None for other files."""
    if not zipfile.is_zipfile(file):
        return None
    with zipfile.ZipFile(file) as archive:
        inside = next((one for one in archive.namelist() if one.rsplit("/", 1)[-1] == "main.xml"), None)
        if inside is None:
            return None
        if "/" in inside:
            return f"its index is {inside}, in a folder, and must be at the top of the archive: pack the contents of the folder"
        try:
            index = archive.read(inside).decode("utf-8", "replace")
        except (OSError, zipfile.BadZipFile, zlib.error) as error:
            return f"{inside}: {error}"
    try:
        library.IO.X3P.X3PReader(file)
    except Exception as error:  # whatever it says
        known = isinstance(error, library.Exceptions.ReadFileError)
        told = [str(error) if known else f"{type(error).__name__}: {error}"]
        told += [f"its {tag} is '{found[1].strip()}'" for tag in ("Revision", "FeatureType") if tag in told[0] and (found := re.search(f"<{tag}[^>]*>([^<]*)<", index))]
        told += [says for tag, says in _NO_MAP.items() if re.search(rf"<(?:\w+:)?{tag}\b", index)]
        return "; ".join(told)
    return None


# What an index may have in place of a link to the heights on a grid.
_NO_MAP = {
    "DataList": "its heights are in the index itself (DataList)",
    "ListDimension": "it is a cloud of points (ListDimension), no heights on a grid",
}


def _opened(library: Any, name: str, file: str, table: Any, channel: Any, unit: Any, sizes: Any) -> HeightMap:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            with library.open_topography(file) as reader:
                found = list(reader.channels)
                sized = any(one.dim == 2 and one.physical_sizes is not None for one in found)
                if table is not None and table.points is not None and (table.units or not isinstance(unit, str) and unit or not sized and reader.format() != "xyz"):
                    return _of_points(name, table.points, table.units or unit)
                chosen = _channel(name, found, channel)
                return _in_metres(name, chosen, found, unit, sizes)
    except (library.Exceptions.CannotDetectFileFormat, MemoryError):
        raise
    except _Said as said:
        raise Error(str(said)) from None
    except library.Exceptions.MetadataAlreadyFixedByFile as error:
        raise Error(f"{name}: {error}: leave it out") from None
    except Exception as error:  # readers of forty formats, and files that may be damaged
        says = str(error) if isinstance(error, library.Exceptions.ReadFileError) else f"cannot be read ({type(error).__name__}: {error})"
        raise Error(f"{name}: {says}; if the file is whole, export it as X3P, SDF or Gwyddion's format") from None


class _Said(ValueError):
    """What is wrong with a file, in full."""


def _library() -> Any:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ImportWarning)  # that mpi4py is missing, which is of no use here
            import SurfaceTopography
    except ImportError as error:
        raise ImportError(
            f"reading a file of an instrument needs SurfaceTopography ({error}): pip install SurfaceTopography, "
            "with Python 3.10 or later"
        ) from None
    return SurfaceTopography


def _channel(name: str, channels: list[Any], wanted: int | str | None) -> Any:
    listed = ", ".join(f"{index} '{one.name}'" for index, one in enumerate(channels))
    if wanted is not None:
        for index, channel in enumerate(channels):
            if wanted in (index, channel.name):
                return channel
        raise _Said(f"{name}: channel = {wanted!r}: must be one of {listed or 'none: the file has no channels'}")
    maps = [one for one in channels if one.dim == 2 and _kind(one) == "height" and not _OTHER.search(str(one.name))]
    if len(maps) > 1:
        heights = ", ".join(f"{channels.index(one)} '{one.name}'" for one in maps)
        raise _Said(f"{name}: has {len(maps)} maps of heights: give channel = one of {heights}")
    if not channels:
        raise _Said(f"{name}: holds no channel with data: save the map itself with it, or export it as X3P or SDF")
    if not maps and len(channels) > 1 and not any(channel.dim == 1 for channel in channels):
        raise _Said(f"{name}: no channel holds heights: it has {listed}")
    return (maps or channels)[0]


def _kind(channel: Any) -> str:
    return str(channel.data_kind.value)


def _in_metres(name: str, channel: Any, channels: list[Any], units: Any, sizes: tuple[float, float] | None) -> HeightMap:
    from SurfaceTopography.Support.UnitConversion import get_unit_conversion_factor

    unit = _of_heights(units)
    if sizes is not None and unit != _lateral(units):
        sizes = tuple(get_unit_conversion_factor(_lateral(units), unit) * one for one in sizes)
    if _kind(channel) != "height":
        raise _Said(f"{name}: channel '{channel.name}' holds {_kind(channel)}: must hold heights")
    if channel.unit is None and unit is None:
        raise _Said(f"{name}: the file names no unit of length: give unit='nm' or the like")
    if channel.dim != 2:
        raise _Said(f"{name}: channel '{channel.name}' is a profile: must be a map{_profile(channel, unit)}")
    if channel.physical_sizes is None and sizes is None:
        raise _Said(f"{name}: the file has no size: give physical_sizes=(along x, along y)")
    if sizes is not None and not (np.shape(sizes) == (2,) and np.all(np.isfinite(sizes)) and np.min(sizes) > 0):
        raise _Said(f"physical_sizes = {sizes}: must be two finite numbers > 0, along x and y")
    wrong = None
    if channel.physical_sizes is not None and sizes is not None:  # which the library refuses, unless those of the file are wrong
        found = of_topography(channel.topography(**({} if unit is None else {"unit": unit})))
        wrong = implausible(found)
    if wrong is not None and sizes is not None:
        rows, columns = found.height_map.shape
        heights, dx, dy = found.height_map, sizes[0] / columns, sizes[1] / rows
    else:
        given = {"unit": unit, "physical_sizes": sizes}
        heights, dx, dy = of_topography(channel.topography(**{key: value for key, value in given.items() if value is not None}))
    if sizes is None and unit != _lateral(units):  # the file has sizes without a unit
        dx, dy = (get_unit_conversion_factor(_lateral(units), unit) * one for one in (dx, dy))
    result = HeightMap(heights, dx, dy, None, str(channel.name), tuple(str(one.name) for one in channels))
    if (wrong := implausible(result)) is not None:
        raise _Said(f"{name}: {wrong}")
    return result


def implausible(found: HeightMap) -> str | None:
    """What of the sizes of a map no map has, in words."""
    rows, columns = found.height_map.shape
    for axis, side in (("x", columns * found.dx), ("y", rows * found.dy)):
        if not _SIDE[0] <= side <= _SIDE[1]:
            return f"the map is {side:.3g} m long along {axis}, as no map is: give physical_sizes=(along x, along y) in metres"
    known = found.height_map[np.isfinite(found.height_map)]
    if known.size == 0 or np.ptp(known) == 0:
        return None
    if np.ptp(known) > _HEIGHTS:
        return f"heights range over {np.ptp(known):.3g} m, as those of no map: the unit is wrong; correct it in the file"
    steps = np.diff(found.height_map, axis=1) / found.dx
    slope = float(np.sqrt(np.nanmean(steps**2))) if np.isfinite(steps).any() else 1.0
    return None if slope == 0 or _SLOPES[0] <= slope <= _SLOPES[1] else (
        f"slopes are {slope:.2g}, as those of no map: a unit is wrong; give physical_sizes=(along x, along y) in metres, or correct it"
    )


def _profile(channel: Any, unit: str | None) -> str:
    """What to do with a profile."""
    line = channel.topography(**({} if channel.unit is not None else {"unit": unit})).to_unit("m")
    x, z = (np.asarray(one, dtype=np.float64) for one in line.positions_and_heights())
    good = np.isfinite(x) & np.isfinite(z)
    x, z = x[good], z[good]
    if x.size < 3 or not np.all(np.diff(x) > 0):
        return ""
    z = z - np.polyval(np.polyfit(x, z, 1), x)
    slope = np.sqrt(np.mean((np.diff(z) / np.diff(x)) ** 2))
    return f"; of a profile give Params.from_profile(Rq={z.std():.4g}, Rdq={slope:.4g}, ...), in metres, which are those of this one"


def _of_points(name: str, points: Array, unit: Any) -> HeightMap:
    """The map of points x, y, z, on a grid of which some may be missing."""
    from SurfaceTopography.Support.UnitConversion import get_unit_conversion_factor

    if unit is None:
        raise _Said(f"{name}: three columns are x, y and z of points, and the file names no unit of length: give unit='nm' or the like")
    units = unit if len(unit) == 3 and not isinstance(unit, str) else (_lateral(unit), _lateral(unit), _of_heights(unit))
    x, y, z = (get_unit_conversion_factor(one, "m") * column for one, column in zip(units, points.T))
    places = []
    for along in (x, y):
        values = np.unique(along)
        apart = np.diff(values)
        apart = apart[apart > 1e-6 * np.ptp(values)]
        step = float(np.median(apart)) if apart.size else 0.0
        place = np.round((along - values[0]) / step) if step > 0 else along
        if step == 0 or np.max(np.abs((along - values[0]) / step - place)) > 0.1:
            raise _Said(f"{name}: its points x, y, z are not on a grid: interpolate them, as scipy.interpolate.griddata does")
        places.append((place.astype(np.intp), step))
    (column, dx), (row, dy) = places
    if (row.max() + 1) * (column.max() + 1) > 4 * x.size:
        raise _Said(f"{name}: its points x, y, z fill less than a fourth of their grid: interpolate them")
    heights = np.full((row.max() + 1, column.max() + 1), np.nan)
    heights[row, column] = z
    found = HeightMap(heights, dx, dy, None, "points", ("points",))
    if (wrong := implausible(found)) is not None:
        raise _Said(f"{name}: {wrong}")
    return found


def of_topography(topography: Any) -> HeightMap:
    """The map of a `SurfaceTopography.Topography`, in metres if it has a unit, else in its own."""
    if getattr(topography, "dim", None) != 2:
        raise Error("height_map: this topography is no map of heights over x and y")
    if topography.unit is not None:
        topography = topography.to_unit("m")
    # SurfaceTopography's first axis is x.
    masked: Any = topography.heights()
    heights: Array = np.ma.filled(np.ma.asarray(masked, dtype=np.float64), np.nan)
    dx, dy = map(float, topography.pixel_size)
    return HeightMap(np.ascontiguousarray(heights.T), dx, dy)
