"""What surfaces answer whose parameters differ in a few numbers, a block of them at a time, in whatever process.

A surface that the library refuses has no numbers, but a status and a reason; so has a load that is too heavy for it.
"""

from __future__ import annotations

import ctypes
import math
from typing import Any, NamedTuple, Sequence

import numpy as np
import numpy.typing as npt

from .. import _header
from .._friction_law import FrictionLaw
from .._handle import Handle
from .._library import LIBRARY
from ..errors import Error, Status, check, instead
from ..params import Params
from .names import KNOWN, FreeName, free_names, put_all

Array = npt.NDArray[np.float64]

# Fields that a fit does not search, but whose values matter to friction or to what the model warns of.
_OTHERS = ("hardness", "tangential_modulus", "nominal_area", "bandwidth", "max_friction_coefficient")
# Names that choose the heights, which are put one after the other.
_HEIGHTS = ("skew", "kurtosis", "weibull_shape")
# No verdict on a surface, but on the library.
_FAILURES = (Status.INTERNAL,)
_DOUBLES = ctypes.POINTER(ctypes.c_double)


class Block(NamedTuple):
    """Surfaces to be evaluated.

    Attributes:
        params: the surface that the others are variations of.
        names: what varies, as in `names_of`.
        values: (surfaces, names).
        loads: normal loads [force].
        warnings: whether to find the warnings of each state, exactly.
        calibrated: friction forces [force], (surfaces,), that they are calibrated with at the load of the calibration of `params`;
            None if they are not.
    """

    params: Params
    names: tuple[str, ...]
    values: Array
    loads: Array
    warnings: bool = False
    calibrated: Array | None = None


class Answers(NamedTuple):
    """What a block answers: arrays (surfaces, loads), NaN for what is refused; status and reason (surfaces,).

    Attributes:
        friction_coefficient: F/P.
        friction_force: F [force].
        tangential_stiffness: K_t [force/length].
        warnings: bits of `Warnings`, 0 where there is no state; None if they were not asked for.
        status: of the surface, or of the first load that it refuses; 0 where nothing is refused.
        reason: the message that goes with it.
    """

    friction_coefficient: Array
    friction_force: Array
    tangential_stiffness: Array
    warnings: npt.NDArray[np.uint32] | None
    status: npt.NDArray[np.uint8]
    reason: list[str]


def names_of(given: Sequence[str], params: Params) -> tuple[FreeName, ...]:
    """The names of a fit, `asperity.fits.names`, and those of some fields more; `Error` for any other."""
    for name in given:
        if name not in (*KNOWN, *_OTHERS):
            raise Error(f"{name!r}: no parameter has this name; {instead(str(name), [*KNOWN, *_OTHERS])}")
    known = tuple(name for name in given if name not in _OTHERS)
    found = {name.given: name for name in (free_names(known, params) if known else ())}
    return tuple(found[name] if name in found else _other(name) for name in given)


def _other(field: str) -> FreeName:
    def get(params: Params) -> float:
        return float(getattr(params, field))

    return FreeName(field, field, (field,), get, lambda params, value: params.replace(**{field: value}), (0.0, math.inf))


def evaluate(block: Block) -> Answers:
    """Friction, stiffness and warnings of each surface at each load."""
    names = names_of(block.names, block.params)
    shape = len(block.values), block.loads.size
    found = np.full((3, *shape), math.nan)
    warnings = np.zeros(shape, dtype=np.uint32) if block.warnings else None
    status, reason = np.zeros(len(block.values), dtype=np.uint8), [""] * len(block.values)
    for i, row in enumerate(block.values):
        try:
            handle = Handle(_surface(block.params, names, row))
            found[:, i] = _friction(handle, block.loads)
            if warnings is not None:
                warnings[i] = _warnings(handle, block.loads)
            if (refused := np.isnan(found[:, i]).any(axis=0)).any():
                at = float(block.loads[refused.argmax()])
                found[:, i, refused] = math.nan
                check(LIBRARY.asperity_state_at_load(handle.pointer, at, ctypes.byref(_state())))
                raise Error(f"load = {at:g}: no friction was found; a bug in asperity, please report it", Status.INTERNAL)
        except Error as error:
            if error.status in _FAILURES:
                raise
            status[i], reason[i] = error.status, str(error)
    return Answers(found[0], found[1], found[2], warnings, status, reason)


class Drawn(NamedTuple):
    """A surface that was drawn: its friction forces at the loads, and how many times its strength is that before it was
    calibrated, with d(ln strength)/d(ln force) there."""

    force: Array
    strength: float = 1.0
    rate: float = 1.0


def forces(block: Block) -> list[Drawn | None]:
    """The friction of each surface; None for one that the library refuses, or that refuses a load."""
    names = names_of(block.names, block.params)
    load = block.params.calibration_load
    found: list[Drawn | None] = []
    for i, row in enumerate(block.values):
        try:
            surface = _surface(block.params, names, row)
            if block.calibrated is None:
                with FrictionLaw(surface) as law:
                    found.append(Drawn(law.friction_force_at_load(block.loads)))
                continue
            force, before = float(block.calibrated[i]), surface
            surface = before.calibrated_force(load, force)
            strength = max(surface.slip_stress_1, surface.slip_stress_2) / max(before.slip_stress_1, before.slip_stress_2)
            with FrictionLaw(surface) as law:
                # What pressure adds to friction has no strength.
                kappa = surface.pressure_coefficient
                rate = 1 / (1 - kappa * law.state_at_load(load).hertz_load / force) if kappa > 0 else 1.0
                found.append(Drawn(law.friction_force_at_load(block.loads), strength, rate))
        except Error as error:
            if error.status in _FAILURES:
                raise
            found.append(None)
    return found


def _surface(params: Params, names: tuple[FreeName, ...], row: Array) -> Params:
    """One of the surfaces. Plain fields are set together, since each `replace` takes a tenth of what a model takes."""
    values = list(zip(names, map(float, row)))
    plain = {name.field: value for name, value in values if name.varies == (name.field,) and name.field not in _HEIGHTS}
    rest = [(name, value) for name, value in values if name.field not in plain]
    params = params.replace(**plain) if plain else params
    return put_all([name for name, _ in rest], params, [value for _, value in rest]) if rest else params


def _friction(handle: Handle, loads: Array) -> Array:
    """Coefficient, force and stiffness, (3, loads); NaN at loads that are refused."""
    found = np.full((3, loads.size), math.nan)
    at = _data(loads)
    calls = (
        LIBRARY.asperity_friction_at_loads(handle.pointer, loads.size, at, _data(found[0]), None),
        LIBRARY.asperity_friction_force_at_loads(handle.pointer, loads.size, at, _data(found[1]), None),
        LIBRARY.asperity_tangential_stiffness_at_loads(handle.pointer, loads.size, at, _data(found[2])),
    )
    for status in calls:
        if status in _FAILURES:
            check(status)
    return found


def _warnings(handle: Handle, loads: Array) -> npt.NDArray[np.uint32]:
    struct: Any = _state()
    pointer, bits = ctypes.byref(struct), np.zeros(loads.size, dtype=np.uint32)
    for i, load in enumerate(loads.tolist()):
        if LIBRARY.asperity_state_at_load(handle.pointer, load, pointer) == _header.ASPERITY_OK:
            bits[i] = struct.warnings
    return bits


def _state() -> _header.asperity_state:
    return _header.asperity_state(struct_size=ctypes.sizeof(_header.asperity_state))


def _data(array: Array) -> Any:
    return array.ctypes.data_as(_DOUBLES)
