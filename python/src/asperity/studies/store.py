"""Where a study is kept: in memory, or in a NetCDF file, beside which each block is written as it is done.

A block is a file of its own, written under another name, flushed to the disk and then renamed: after whatever end of the
process it is there whole or not at all. It ends with a checksum over all of it: a block that the disk damaged is computed anew.
When all are there, they become one file in the same way, a block at a time, and their folder goes.
"""

from __future__ import annotations

import contextlib
import errno
import hashlib
import json
import os
import shutil
from pathlib import Path
from typing import Any, Iterable, Iterator

import numpy as np
import numpy.typing as npt

from ..errors import Error, Status
from ..fits.many_surfaces import Answers
from ..results import Warnings
from ..tools import caller, output
from ..units import SI
from .draws import digest
from .lock import locked

Array = npt.NDArray[np.float64]

_BOTH, _EACH = ("sample", "load"), ("sample",)
_FLAGS = [kind for kind in Warnings]
# Name to dimensions, type, and attributes; the dimension of a quantity stands for its unit.
_VARIABLES: dict[str, tuple[tuple[str, ...], Any, dict[str, Any]]] = {
    "friction_coefficient": (_BOTH, np.float64, {"long_name": "friction coefficient F/P", "units": "1"}),
    "friction_force": (_BOTH, np.float64, {"long_name": "friction force F", "units": "force"}),
    "tangential_stiffness": (_BOTH, np.float64, {"long_name": "tangential stiffness K_t", "units": "force/length"}),
    "warnings": (
        _BOTH,
        np.uint32,
        {
            "long_name": "what of the model does not hold in this state; 0 where nothing is known to fail",
            "flag_masks": np.array(_FLAGS, dtype=np.uint32),
            "flag_meanings": " ".join(str(kind.name) for kind in _FLAGS),
        },
    ),
    "status": (
        _EACH,
        np.uint8,
        {
            "long_name": "0, or why the library refuses this surface or one of its loads",
            "flag_values": np.array(Status, dtype=np.uint8),
            "flag_meanings": " ".join(status.name for status in Status),
        },
    ),
    "reason": (_EACH, str, {"long_name": "the message that goes with the status"}),
}
# What of the identity changes with the number of samples.
_DRAWN = "bits of the parameters drawn"
_OF_SAMPLES = ("samples", "block", _DRAWN)
_SI = SI | {"length^2": "m2"}  # as CF has them


class Layout:
    """What a study consists of beside its answers.

    Attributes:
        parameters: name to (values, dimension).
        load: normal loads [force].
        attributes: of the whole, text and numbers.
        identity: what another study must agree in for one to go on with the other's blocks.
        block: surfaces in a block.
        names: of the variables.
    """

    def __init__(
        self, parameters: dict[str, tuple[Array, str]], load: Array, attributes: dict[str, Any], identity: dict[str, Any],
        block: int, warnings: bool, in_si: bool,
    ) -> None:  # fmt: skip
        self.parameters, self.load, self.block = parameters, load, block
        self.attributes, self.identity = attributes, identity
        self.names = [name for name in _VARIABLES if warnings or name != "warnings"]
        self._in_si = in_si

    @property
    def surfaces(self) -> int:
        return len(next(iter(self.parameters.values()))[0])

    def unit(self, dimension: str) -> str:
        """The unit of a dimension: the dimension itself where the system of units is the caller's own."""
        return _SI.get(dimension, dimension or "1") if self._in_si else dimension or "1"

    def described(self, name: str) -> dict[str, Any]:
        """The attributes of a variable."""
        attributes = dict(_VARIABLES[name][2])
        return attributes | ({"units": self.unit(attributes["units"])} if "units" in attributes else {})

    def coordinates(self) -> dict[str, tuple[tuple[str, ...], Array, dict[str, Any]]]:
        """Loads and parameters."""
        found: dict[str, Any] = {"load": (("load",), self.load, {"long_name": "normal load P", "units": self.unit("force")})}
        for name, (values, dimension) in self.parameters.items():
            found[name] = (_EACH, values, {"units": self.unit(dimension)})
        return found


class Memory:
    """A study in memory."""

    def __init__(self, layout: Layout) -> None:
        self._layout, surfaces = layout, layout.surfaces
        sizes = {"sample": surfaces, "load": layout.load.size}
        self._arrays: dict[str, Any] = {
            name: np.empty([sizes[one] for one in _VARIABLES[name][0]], dtype=object if name == "reason" else _VARIABLES[name][1])
            for name in layout.names
        }

    def missing(self) -> list[int]:
        """The first surfaces of blocks that are not done."""
        return list(range(0, self._layout.surfaces, self._layout.block))

    def put(self, first: int, answers: Answers) -> None:
        for name, array in self._arrays.items():
            array[first : first + len(answers.status)] = getattr(answers, name)

    def dataset(self) -> Any:
        """The `xarray.Dataset` of it all."""
        import xarray

        layout = self._layout
        data = {name: (_VARIABLES[name][0], array, layout.described(name)) for name, array in self._arrays.items()}
        data["reason"] = (_EACH, self._arrays["reason"].astype(str), layout.described("reason"))
        refused = int(np.count_nonzero(self._arrays["status"]))
        return xarray.Dataset(data, layout.coordinates(), {**layout.attributes, "refused": refused})


@contextlib.contextmanager
def checkpoint(file: str | os.PathLike[str], layout: Layout) -> Iterator[Checkpoint]:
    """A `Checkpoint` that no other process works on meanwhile; one that is whole is only read, by as many as like."""
    path = Path(file)
    with contextlib.ExitStack() as stack:
        if not (whole := _holds(path, layout)):
            stack.enter_context(locked(path.with_name(path.name + ".lock"), f"checkpoint = {str(path)!r}"))
        yield Checkpoint(path, layout, whole)


def _holds(file: Path, layout: Layout) -> bool:
    """Whether a file has all of a study, as it was written: NetCDF may find a damaged byte only as it is read."""
    return file.exists() and _intact(file) and _identity_of(file) == json.dumps(layout.identity, sort_keys=True)


class Checkpoint:
    """A study in a file, and in blocks beside it until all are done. The file may have fewer samples until then.

    Raises:
        Error: the file or the blocks are of another study, or no study.
    """

    def __init__(self, file: Path, layout: Layout, whole: bool = False) -> None:
        self._file, self._layout = file, layout
        self._folder = self._file.with_name(self._file.name + ".blocks")
        self._identity = json.dumps(layout.identity, sort_keys=True)
        self._whole, self._before = whole or _holds(file, layout), 0
        if self._whole:
            return
        if self._file.exists():
            self._before = self._answered(_identity_of(self._file))
        self._folder.mkdir(exist_ok=True)
        told = self._folder / "study.json"
        if told.exists():
            self._agree(self._folder, told.read_text(encoding="utf-8"))
        else:
            _replaced(told, lambda part: part.write_text(self._identity, encoding="utf-8"))

    def missing(self) -> list[int]:
        """The first surfaces of blocks that are not done."""
        return [] if self._whole else [first for first in self._starts() if not self._done(first)]

    def _starts(self) -> range:
        """The first surfaces of all blocks: those before are in the file."""
        return range(self._before, self._layout.surfaces, self._layout.block)

    def put(self, first: int, answers: Answers) -> None:
        def write(part: Path) -> None:
            count = len(answers.status)
            with _Writer(part, self._layout, slice(first, first + count), self._of_block(first)) as writer:
                writer.put(0, {name: getattr(answers, name) for name in self._layout.names})
            _seal(part)

        _replaced(self._block(first), write)

    def dataset(self) -> Any:
        """The `xarray.Dataset`, read from the file as it is used; the blocks are put together first."""
        import xarray

        if not self._whole:
            _replaced(self._file, self._join)
            self._whole = True
        with contextlib.suppress(FileNotFoundError):  # the folder may be of another process, which enlarges this study
            if (self._folder / "study.json").read_text(encoding="utf-8") == self._identity:
                shutil.rmtree(self._folder, ignore_errors=True)
        return xarray.open_dataset(self._file, engine="netcdf4")

    def _join(self, part: Path) -> None:
        names, block = self._layout.names, self._layout.block
        with _Writer(part, self._layout, slice(0, self._layout.surfaces), self._identity) as writer:
            refused = 0
            for first in (*range(0, self._before, block), *self._starts()):
                if first < self._before:
                    arrays = _read(self._file, names, slice(first, first + block))
                elif _intact(file := self._block(first)):
                    arrays = _read(file, names)
                else:
                    raise OSError(f"{file}: damaged since the study began; call again, and this block alone is computed anew")
                refused += int(np.count_nonzero(arrays["status"]))
                writer.put(first, arrays)
            writer.file.setncattr("refused", refused)
        _seal(part)

    def _block(self, first: int) -> Path:
        return self._folder / f"block-{first // self._layout.block:07}.nc"

    def _of_block(self, first: int) -> str:
        """The identity of a block."""
        return json.dumps({**self._layout.identity, "first surface": first}, sort_keys=True)

    def _done(self, first: int) -> bool:
        """Whether a block is there and as it was written: any other is computed anew."""
        file = self._block(first)
        if not file.exists():
            return False
        try:
            # What is damaged is kept from HDF, which need not survive it.
            if _intact(file) and _identity_of(file) == self._of_block(first):
                return True
        except OSError:
            pass
        caller.warn(f"{file}: damaged, this block is computed anew", RuntimeWarning)
        return False

    def _answered(self, found: str) -> int:
        """How many of the first surfaces are in the file, which is of fewer samples of the same study."""
        try:
            fewer = json.loads(found)["samples"] < self._layout.identity["samples"]
        except (ValueError, TypeError, KeyError):
            fewer = False
        other = self._agree(self._file, found, _OF_SAMPLES if fewer else ())
        if not _intact(self._file):
            caller.warn(f"{self._file}: damaged or changed, all of it is computed anew", RuntimeWarning)
            return 0
        surfaces = len(_read(self._file, ["status"])["status"])
        drawn = np.column_stack([values[:surfaces] for values, _ in self._layout.parameters.values()])
        if other[_DRAWN] != digest(drawn):
            raise Error(
                f"checkpoint = {str(self._file)!r}: has {other['samples']} samples, which are not the first of "
                f"{self._layout.identity['samples']}; a Latin hypercube, Sobol' indices and a grid cannot be enlarged: "
                "give another name, or remove it"
            )
        return surfaces

    def _agree(self, where: Path, found: str, but: Iterable[str] = ()) -> dict[str, Any]:
        try:
            other = json.loads(found)
        except json.JSONDecodeError:
            other = None
        if not isinstance(other, dict):
            raise Error(f"checkpoint = {str(self._file)!r}: {where} is no study, or damaged; give another name, or remove it")
        for name, value in self._layout.identity.items():
            if name not in but and other.get(name) != value:
                raise Error(
                    f"checkpoint = {str(self._file)!r}: {where} is of another study, with {name} = {_shown(other.get(name))} "
                    f"where this one has {_shown(value)}; give another name, or remove it"
                )
        return other


class _Writer:
    """A NetCDF file with the surfaces of a slice; `with` closes it."""

    def __init__(self, path: Path, layout: Layout, surfaces: slice, identity: str) -> None:
        import netCDF4

        self.file: Any = netCDF4.Dataset(os.fspath(path), "w", format="NETCDF4")
        self.file.createDimension("sample", surfaces.stop - surfaces.start)
        self.file.createDimension("load", layout.load.size)
        for name, (dims, values, attributes) in layout.coordinates().items():
            made = self.file.createVariable(name, np.float64, dims, fletcher32=True)
            made[:] = values if name == "load" else values[surfaces]
            made.setncatts(attributes)
        for name in layout.names:
            dims, kind, _ = _VARIABLES[name]
            how: dict[str, Any] = {"zlib": True, "complevel": 1} if name == "warnings" else {}
            if dims == _BOTH:  # in parts of a block, each of which is written once: larger ones take memory
                how["chunksizes"] = min(layout.block, surfaces.stop - surfaces.start), layout.load.size
            made = self.file.createVariable(name, kind, dims, fletcher32=kind is not str, **how)
            made.setncatts(layout.described(name) | {"coordinates": " ".join(layout.parameters)})
        self.file.setncatts({**layout.attributes, "study": identity})

    def put(self, first: int, arrays: dict[str, Any]) -> None:
        for name, values in arrays.items():
            stop = first + len(values)
            self.file[name][first:stop] = np.array(values, dtype=object) if name == "reason" else values

    def __enter__(self) -> _Writer:
        return self

    def __exit__(self, *_: object) -> None:
        self.file.close()


def _read(file: Path, names: Iterable[str], surfaces: slice = slice(None)) -> dict[str, Any]:
    import netCDF4

    with netCDF4.Dataset(os.fspath(file)) as opened:
        opened.set_auto_mask(False)
        return {name: opened[name][surfaces] for name in names}


def _identity_of(file: Path) -> str:
    """What a file says of its study; "" if it says nothing or is none of NetCDF."""
    import netCDF4

    try:
        with netCDF4.Dataset(os.fspath(file)) as opened:
            return str(getattr(opened, "study", ""))
    except (OSError, RuntimeError):  # of damaged files NetCDF raises either
        return ""


def _checksum(file: Path, size: int) -> bytes:
    """Of the first bytes of a file."""
    found = hashlib.sha256()
    with open(file, "rb") as stream:
        while part := stream.read(min(size, 1 << 20)):
            found.update(part)
            size -= len(part)
    return found.digest()


def _seal(file: Path) -> None:
    """Ends a file with a checksum over all of it, which readers of NetCDF pass over."""
    checksum = _checksum(file, file.stat().st_size)
    with open(file, "ab") as stream:
        stream.write(checksum)


def _intact(file: Path) -> bool:
    """Whether a file ends with the checksum of all before it."""
    size = max(0, file.stat().st_size - hashlib.sha256().digest_size)
    with open(file, "rb") as stream:
        stream.seek(size)
        return stream.read() == _checksum(file, size)


def _replaced(file: Path, write: Any) -> None:
    """Writes a file beside its place, and puts it there once it is on the disk."""
    with output.replacing(file) as part:
        try:
            write(part)
        except (OSError, RuntimeError) as error:
            # NetCDF calls a full disk an "HDF error" or "Permission denied": the system itself says what it is.
            with open(part, "ab") as again:
                again.write(bytes(1 << 16))
            raise OSError(errno.EIO, f"cannot be written ({error})", str(file)) from None


def _shown(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 200 else f"{text[:197]}..."
