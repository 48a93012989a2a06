"""What the library answers for two surfaces, one load or many: the calls of `Model`."""

from __future__ import annotations

import ctypes
import math
from types import TracebackType
from typing import TYPE_CHECKING, Any, Literal, Union, overload

import numpy as np
import numpy.typing as npt

from . import _header, units
from . import table as _table
from ._handle import Handle
from ._library import LIBRARY
from ._microslip import Microslip
from .errors import Error, Status, check
from .params import Params
from .results import Hysteresis, State, States, Summary, ValidityWarning, Warnings
from .tools import caller, checks
from .tools.labelled import HasLabels, Labelled, like
from .tools.progress import Progress, teller

if TYPE_CHECKING:
    from typing_extensions import Self

Loads = Union["npt.NDArray[Any]", "list[Any]", "tuple[Any, ...]"]
Array = npt.NDArray[np.float64]

_DOUBLES = ctypes.POINTER(ctypes.c_double)
# More exact states than these take more than some seconds.
_MANY = 20_000


class FrictionLaw:
    """A `Model` without its curve, whose band is made of laws with other parameters. Fits and bands are made with this."""

    _handle: Handle | None = None

    def __init__(self, params: Params) -> None:
        self.set_params(params)

    @property
    def params(self) -> Params:
        """The parameters of the model."""
        return self._open().params

    def set_params(self, params: Params) -> None:
        """Gives the model other parameters; if that raises, the model is as before."""
        if not isinstance(params, Params):
            raise TypeError(f"params = {params!r}: must be a Params")
        self._handle = Handle(params)

    def unloaded(self, largest_load: float) -> Self:
        """The same surfaces after a largest load [force]: a joint that was tightened, and now vibrates.

        Up to the largest load, summits that yielded spring back elastically, and every call answers for that; above it first loading
        goes on. Contacts that do not yield are as before.

        Contacts of its `microslip` that have borne more unload each from its own largest load, the last number of its state; to 2 %. For
        a joint whose loads are not known yet, pass the smallest.

        Raises:
            Error: a load that is not > 0 and below `max_table_load` of the summary, or smaller than one that the model was unloaded
                from; adhesion and waviness, of which unloading is not modelled.
        """
        handle, load = self._open(), checks.real("largest_load", largest_load, self._unit())
        if load == 0:
            raise Error("largest_load = 0: must be > 0", Status.OUT_OF_RANGE)
        return self._of(handle.params, load, handle)

    @classmethod
    def _of(cls, params: Params, largest_load: float, before: Handle | None = None) -> Self:
        found = cls.__new__(cls)
        found._handle = Handle(params, largest_load, before)
        return found

    @overload
    def friction_at_load(self, load: float, *, slope: Literal[False] = ...) -> float: ...
    @overload
    def friction_at_load(self, load: float, *, slope: Literal[True]) -> tuple[float, float]: ...
    @overload
    def friction_at_load(self, load: Loads, *, slope: Literal[False] = ...) -> Array: ...
    @overload
    def friction_at_load(self, load: Loads, *, slope: Literal[True]) -> tuple[Array, Array]: ...
    @overload
    def friction_at_load(self, load: Labelled, *, slope: Literal[False] = ...) -> Labelled: ...
    @overload
    def friction_at_load(self, load: Labelled, *, slope: Literal[True]) -> tuple[Labelled, Labelled]: ...

    def friction_at_load(self, load: Any, *, slope: bool = False) -> Any:
        """Friction coefficient F/P [-] at a load, or at many.

        >>> model = asperity.Model(asperity.Params.paper())
        >>> mu, slope = model.friction_at_load([10.0, 100.0], slope=True)
        >>> print(mu.round(4))
        [2.5279 1.9827]

        Args:
            load: normal load [force]: a number, or an array (or nested sequence) of any shape. Contiguous arrays of
                float64 are read where they are.
            slope: whether to return d(mu)/d(load) [1/force] too, 0 where mu is capped.

        Returns:
            mu, or (mu, slope): a float for a number, an array of the same shape for an array.

        Raises:
            Error: a load that is NaN, infinite, or too heavy; the class tells more.
        """
        one, one_with_slope = LIBRARY.asperity_friction_at_load, LIBRARY.asperity_friction_and_slope_at_load
        return self._evaluate("friction_coefficient", one, one_with_slope, LIBRARY.asperity_friction_at_loads, load, slope)

    @overload
    def friction_force_at_load(self, load: float, *, slope: Literal[False] = ...) -> float: ...
    @overload
    def friction_force_at_load(self, load: float, *, slope: Literal[True]) -> tuple[float, float]: ...
    @overload
    def friction_force_at_load(self, load: Loads, *, slope: Literal[False] = ...) -> Array: ...
    @overload
    def friction_force_at_load(self, load: Loads, *, slope: Literal[True]) -> tuple[Array, Array]: ...
    @overload
    def friction_force_at_load(self, load: Labelled, *, slope: Literal[False] = ...) -> Labelled: ...
    @overload
    def friction_force_at_load(self, load: Labelled, *, slope: Literal[True]) -> tuple[Labelled, Labelled]: ...

    def friction_force_at_load(self, load: Any, *, slope: bool = False) -> Any:
        """Friction force F [force] at a load, or at many; also where the load is 0 or pulls.

        Args:
            load: normal load [force], as for `friction_at_load`.
            slope: whether to return dF/d(load) too, infinite at the pull-off load itself.

        Returns:
            F [force], or (F, slope): a float for a number, an array of the same shape for an array.

        Raises:
            Error: a load that is NaN, infinite, or too heavy; the class tells more.
        """
        one, one_with_slope = LIBRARY.asperity_friction_force_at_load, LIBRARY.asperity_friction_force_and_slope_at_load
        return self._evaluate("friction_force", one, one_with_slope, LIBRARY.asperity_friction_force_at_loads, load, slope)

    @overload
    def load_at_gap(self, gap: float, *, slope: Literal[False] = ...) -> float: ...
    @overload
    def load_at_gap(self, gap: float, *, slope: Literal[True]) -> tuple[float, float]: ...
    @overload
    def load_at_gap(self, gap: Loads, *, slope: Literal[False] = ...) -> Array: ...
    @overload
    def load_at_gap(self, gap: Loads, *, slope: Literal[True]) -> tuple[Array, Array]: ...
    @overload
    def load_at_gap(self, gap: Labelled, *, slope: Literal[False] = ...) -> Labelled: ...
    @overload
    def load_at_gap(self, gap: Labelled, *, slope: Literal[True]) -> tuple[Labelled, Labelled]: ...

    def load_at_gap(self, gap: Any, *, slope: bool = False) -> Any:
        """Normal load at a gap between the mean planes, or at many, from the compiled law.

        Args:
            gap: between the mean planes of the surfaces [length], as `state_at_gap` has it: a number, or an array of any shape.
            slope: whether to return d(load)/d(gap) [force/length] too: minus the normal stiffness.

        Returns:
            The load [force], or (load, slope): negative where adhesion pulls, 0 at pull-off and beyond; a float for a number,
            an array of the same shape for an array.

        Raises:
            Error: a gap that is NaN, infinite, or out of range; the message names it.
        """
        one = LIBRARY.asperity_load_and_slope_at_gap
        return self._evaluate("load", lambda model, at: one(model, at, None), one, LIBRARY.asperity_loads_at_gaps, gap, slope, "gap")

    @overload
    def tangential_stiffness_at_load(self, load: float) -> float: ...
    @overload
    def tangential_stiffness_at_load(self, load: Loads) -> Array: ...
    @overload
    def tangential_stiffness_at_load(self, load: Labelled) -> Labelled: ...

    def tangential_stiffness_at_load(self, load: Any) -> Any:
        """Tangential stiffness K_t [force/length] at a load, or at many: force by displacement while all contacts stick.

        F/K_t is the length before gross slip, which solvers ask for as bristle deflection or elastic slip.

        Args:
            load: normal load [force], as for `friction_at_load`.

        Returns:
            K_t [force/length], 0 below the pull-off load: a float for a number, an array of the same shape for an array.

        Raises:
            Error: a load that is NaN, infinite, or too heavy; the class tells more.
        """

        def many(model: Any, n: int, loads: Any, values: Any, _slopes: None) -> int:
            return int(LIBRARY.asperity_tangential_stiffness_at_loads(model, n, loads, values))

        return self._evaluate("tangential_stiffness", LIBRARY.asperity_tangential_stiffness_at_load, None, many, load, False)

    def tangential(self, load: npt.ArrayLike, displacement: npt.ArrayLike) -> tuple[Any, Any]:
        """The tangential force T [force] at a load and a displacement, and its slope, integrated without the compiled law.

        Each contact slips from its rim inwards, or as a whole (`Params.slip_onset`), until its force is its strength. T therefore
        rises from K_t times the displacement to the friction force. It is odd in the displacement.

        Args:
            load: normal load [force]; a number or an array.
            displacement: of the surfaces along each other [length]; a number or an array. The two are broadcast.

        Returns:
            (T [force], slope [force/length]): floats for two numbers, else arrays.

        Raises:
            Error: a load as for `state_at_load`, or a displacement that is not finite.
        """
        pointer = self._open().pointer
        pairs = np.broadcast(self._numbers("load", load), self._numbers("displacement", displacement, "length"))
        found = np.empty((2, pairs.size))
        force, slope = ctypes.c_double(), ctypes.c_double()
        for i, (at, by) in enumerate(pairs):
            check(LIBRARY.asperity_tangential_at_load(pointer, at, by, ctypes.byref(force), ctypes.byref(slope)))
            found[:, i] = force.value, slope.value
        given = load if np.ndim(load) >= np.ndim(displacement) else displacement
        names = ("tangential_force", "tangential_stiffness")
        force_there, slope_there = (checks.shaped(given, row.reshape(pairs.shape), name) for row, name in zip(found, names))
        return force_there, slope_there

    def microslip(self, shape: int | tuple[int, ...] = ()) -> Microslip:
        """A contact that remembers how it was displaced, or many: its force under changing load along any path.

        The force rises from K_t times the displacement to the friction force F, follows Masing's rule after a reversal, and keeps
        what was before, also where the load changes: `asperity_microslip_step` of the C interface. `tangential` and `hysteresis` are
        exact where the load is constant; this is within 1 % of F of them, at the price of a few friction calls.

        Args:
            shape: of the array of contacts; one contact by default.
        """
        return Microslip(self._open(), (shape,) if isinstance(shape, int) else tuple(shape))

    def hysteresis(self, load: float, amplitude: float, *, points: int = 201) -> Hysteresis:
        """The loop of tangential force against displacement between -amplitude and amplitude, at a constant load.

        After the first loading, T, Masing's rule gives both branches: from a reversal at displacement r, where the force is
        T_r, the force is T_r - 2 T((r - displacement)/2).

        Args:
            load: normal load [force].
            amplitude: of the displacement [length], > 0.
            points: of each branch; the work is that of the polygon through them.

        Raises:
            Error: a load as for `state_at_load`.
            Error: an amplitude that is not finite and > 0, or fewer than two points.
        """
        amplitude, points = checks.positive("amplitude", amplitude, self._unit("length")), checks.whole("points", points, 2)
        first = np.linspace(0.0, amplitude, points)
        loading = self.tangential(load, first)[0]
        back = amplitude - 2.0 * first
        returning = loading[-1] - 2.0 * loading
        work = float(np.sum((loading[1:] + loading[:-1]) * np.diff(first)) * 4.0 - 4.0 * amplitude * loading[-1])
        return Hysteresis(np.concatenate([back, -back]), np.concatenate([returning, -returning]), max(work, 0.0))

    @overload
    def state_at_load(self, load: float) -> State: ...
    @overload
    def state_at_load(self, load: Loads | HasLabels, *, progress: Progress = ...) -> States: ...

    def state_at_load(self, load: Any, *, progress: Progress = None) -> Any:
        """The exact state at a load [force], or at many, integrated without the compiled law.

        Args:
            load: a number, or an array (or nested sequence, Series, DataArray) of any shape.
            progress: whether to tell how far it is, on the error stream, or a function of the part done, 0 to 1, and of
                what is being done; by default for more than about ten thousand loads.

        Returns:
            `State` for a number, `States` for an array.

        Raises:
            Error: a load below the pull-off load (status SEPARATED), not finite, or out of range; for arrays with its index.
            TypeError: no numbers.
        """
        return self._states(LIBRARY.asperity_state_at_load, "load", load, progress)

    @overload
    def state_at_gap(self, gap: float) -> State: ...
    @overload
    def state_at_gap(self, gap: Loads | HasLabels, *, progress: Progress = ...) -> States: ...

    def state_at_gap(self, gap: Any, *, progress: Progress = None) -> Any:
        """The exact state at a gap [length], or at many, also beyond the pull-off point, where no load could hold it.

        Args:
            gap: between the mean planes of the surfaces; may be negative. As the loads of `state_at_load`.
            progress: as for `state_at_load`.

        Raises:
            Error: a gap that is not finite, or out of range; for arrays with its index.
        """
        return self._states(LIBRARY.asperity_state_at_gap, "gap", gap, progress)

    def check(self, lightest: float, heaviest: float) -> Warnings:
        """Warnings of all states between two loads: whether the model holds for a contact that meets these loads.

        >>> model = asperity.Model(asperity.Params.paper().calibrated(100.0, 0.3))
        >>> print(model.check(10.0, 100.0))
        none

        It evaluates hundreds of exact states, in milliseconds: call it once for a run, not for each load.

        Args:
            lightest: normal load [force], from the pull-off load upwards; without adhesion above 0.
            heaviest: normal load [force], not below `lightest`.

        Returns:
            `Warnings`, false if nothing is known to fail. `print` says what fails and what to do about it.

        Raises:
            Error: `lightest` is above `heaviest`, or one of them has no state, as in `state_at_load`.
        """
        bits = ctypes.c_uint64()
        handle = self._open()
        ends = (checks.real(name, load, self._unit()) for name, load in (("lightest", lightest), ("heaviest", heaviest)))
        check(LIBRARY.asperity_check_loads(handle.pointer, *ends, ctypes.byref(bits)))
        return Warnings(bits.value)

    @property
    def uncalibrated(self) -> bool:
        """Whether the strength of the interface is the default, not a measured one: `Warnings.UNCALIBRATED` of any state."""
        return bool(self.state_at_gap(0.0).warnings & Warnings.UNCALIBRATED)

    def table(self, dtype: npt.DTypeLike = np.float64) -> _table.Table:
        """The compiled law as arrays, for code that cannot call the library; `asperity.table` has the indexing rule.

        Args:
            dtype: float64 for a view of the library's table, or float32 for one made of it, for processors that are slow
                at doubles.

        Raises:
            Error: another type.
        """
        found = _table.of_doubles(self._open())
        if np.dtype(dtype) == np.float64:
            return found
        if np.dtype(dtype) == np.float32:
            return _table.of_floats(found)
        raise Error(f"dtype = {np.dtype(dtype)}: must be float64 or float32")

    def load_table(self) -> _table.Table:
        """Load against gap as arrays: minus the gap stands in place of a load, and the load in place of F."""
        return _table.of_doubles(self._open(), _header.ASPERITY_TABLE_LOAD_AT_GAP)

    def warn(self, lightest: float, heaviest: float) -> None:
        """Issues a `ValidityWarning` for each assumption that fails between two loads, once per model and assumption.

        For code that draws or tabulates the law; arguments and errors are those of `check`.
        """
        handle = self._open()
        for kind in self.check(lightest, heaviest).kinds:
            if not kind & handle.warned:
                handle.warned |= kind
                where = f"between the loads {lightest:g} and {heaviest:g}" if lightest < heaviest else f"at the load {lightest:g}"
                caller.warn(f"{where}: {kind}", ValidityWarning)

    def each_specimen_at_loads(
        self, load: npt.ArrayLike, specimens: int, *, sphere_radius: float = 0.0, seed: int = 0, first: int = 0
    ) -> Array:
        """Single specimens with the summits that they happen to have, one by one; `asperity.pads` is the way to ask for them.

        Args:
            load: normal loads [force], a number or a one-dimensional array; also 0 and, with adhesion, negative ones.
            specimens: how many.
            sphere_radius: of rough spheres [length]; 0: they are flat.
            seed: of the random numbers.
            first: the first of them: ranges of specimens may be asked for in threads.

        Returns:
            Array of shape (6, specimens, loads): friction force, tangential and normal stiffness, gap, contacts and pull-off force;
            the gap is NaN where the specimen is apart.

        Raises:
            Error: a load that cannot be, more than 1e7 summits that would have to be drawn, or a sphere that flattens.
        """
        loads = checks.one_or_more("load", load, self._unit())
        most = 2**64 - 1
        specimens, seed, first = (
            checks.whole("specimens", specimens, 1, 10**7), checks.whole("seed", seed, 0, most), checks.whole("first", first, 0, most)
        )  # fmt: skip
        radius, found = checks.real("sphere_radius", sphere_radius, self._unit("length")), np.empty((6, specimens, loads.size))
        pointer, outputs = self._open().pointer, [_data(one) for one in found]
        check(LIBRARY.asperity_each_specimen_at_loads(pointer, radius, first, specimens, seed, loads.size, _data(loads), *outputs))
        return found

    def summary(self) -> Summary:
        """The constants of the model: dimensionless groups, pull-off load, range and error of the compiled law."""
        handle = self._open()
        struct = _header.asperity_summary(struct_size=ctypes.sizeof(_header.asperity_summary))
        check(LIBRARY.asperity_summary_of(handle.pointer, ctypes.byref(struct)))
        return Summary(*_values(struct))

    def close(self) -> None:
        """Frees the model, once no call uses it; afterwards every call raises. Closing twice is fine."""
        self._handle = None

    def __enter__(self) -> Self:
        self._open()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.close()

    def __reduce__(self) -> tuple[Any, tuple[Params, float]]:
        handle = self._open()
        return self._of, (handle.params, handle.largest_load)

    def __repr__(self) -> str:
        name = type(self).__name__
        if self._handle is None:
            return f"<closed {name}>"
        unloaded = f".unloaded({self._handle.largest_load:g})" if self._handle.largest_load else ""
        return f"{name}({self._handle.params!r}){unloaded}"

    def _open(self) -> Handle:
        handle = self._handle
        if handle is None:
            raise Error("the model is closed", Status.NULL_POINTER)
        return handle

    def _unit(self, dimension: str = "force") -> str:
        return units.unit(dimension, self.params.in_si)

    def _numbers(self, name: str, given: Any, dimension: str = "force") -> Array:
        return checks.array(name, given, self._unit(dimension))

    def _states(self, call: Any, name: str, at: Any, progress: Progress) -> State | States:
        handle = self._open()
        places = self._numbers(name, at, units.DIMENSIONS[name])
        if checks.is_number(at, places):
            return _state(handle, call, float(places))
        tell = teller(progress, places.size > _MANY, "asperity")
        found = []
        for i, one in enumerate(places.ravel().tolist()):
            if i % 1000 == 0:
                tell(i / places.size, "exact states")
            try:
                found.append(_state(handle, call, one))
            except Error as error:
                index = tuple(int(k) for k in np.unravel_index(i, places.shape))
                raise Error(f"element {_place(index)}: {error}", error.status) from None
        tell(1.0, "exact states")
        return States.of(found, at, places.shape)

    def _evaluate(
        self, name: str, one: Any, one_with_slope: Any, many: Any, load: Any, slope: bool, argument: str = "load"
    ) -> Any:
        handle = self._open()
        if type(load) is not float:
            loads = self._numbers(argument, load, units.DIMENSIONS[argument])
            if not checks.is_number(load, loads):
                arrays = _evaluate_array(handle, many, loads, slope, argument)
                found_there = tuple(like(load, array, name) for array in arrays)
                return found_there if slope else found_there[0]
            load = float(loads)
        found = ctypes.c_double()
        value: float
        if slope:
            value = one_with_slope(handle.pointer, load, ctypes.byref(found))
        else:
            value = one(handle.pointer, load)
        if math.isnan(value):  # quiet, where a comparison of Python's may raise a floating-point exception
            _refuse(handle, load, (), argument)
        return (value, found.value) if slope else value


def _evaluate_array(
    handle: Handle, many: Any, load: Array, slope: bool, argument: str = "load"
) -> tuple[Array, ...]:
    values = np.empty(load.shape)
    slopes = np.empty(load.shape) if slope else None
    status = many(handle.pointer, load.size, _data(load), _data(values), None if slopes is None else _data(slopes))
    # The library reports the first invalid load of any kind; loads below pull-off are none here, NaN answers always are.
    if status not in (
        _header.ASPERITY_OK,
        _header.ASPERITY_SEPARATED,
        _header.ASPERITY_INVALID_LOAD,
        _header.ASPERITY_OUT_OF_RANGE,
    ):
        check(status)
    refused = np.isnan(values)
    if refused.any():
        index = np.unravel_index(int(np.argmax(refused)), load.shape)
        _refuse(handle, float(load[index]), index, argument)
    return (values,) if slopes is None else (values, slopes)


def _refuse(handle: Handle, load: float, index: tuple[Any, ...] = (), argument: str = "load") -> None:
    """Raises the library's own message about a load, or a gap, that it answered with NaN."""
    by_load = argument == "load"
    try:
        _state(handle, LIBRARY.asperity_state_at_load if by_load else LIBRARY.asperity_state_at_gap, load)
    except Error as error:
        if not index:
            raise
        raise Error(f"element {_place(index)}: {error}", error.status) from None
    raise Error(f"{argument} = {load}: no answer was found; a bug in asperity, please report it", Status.INTERNAL)


def _place(index: tuple[Any, ...]) -> Any:
    return int(index[0]) if len(index) == 1 else tuple(map(int, index))


def _state(handle: Handle, call: Any, at: float) -> State:
    struct = _header.asperity_state(struct_size=ctypes.sizeof(_header.asperity_state))
    check(call(handle.pointer, at, ctypes.byref(struct)))
    values = {field[0]: getattr(struct, field[0]) for field in struct._fields_[1:]}
    return State(**{**values, "warnings": Warnings(values["warnings"])})


def _values(struct: ctypes.Structure) -> list[Any]:
    """The fields of a struct after its size."""
    return [getattr(struct, field[0]) for field in struct._fields_[1:]]


def _data(array: Array) -> Any:
    return array.ctypes.data_as(_DOUBLES)
