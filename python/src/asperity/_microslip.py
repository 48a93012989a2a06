"""Contacts that remember: their states, and the steps that they take."""

from __future__ import annotations

import ctypes
import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from . import _header, units
from ._handle import Handle
from ._library import LIBRARY
from .errors import Error, Status, check
from .params import Params
from .tools import checks

Array = npt.NDArray[np.float64]

_DOUBLES = ctypes.POINTER(ctypes.c_double)


@dataclass(frozen=True)
class MicroslipStep:
    """What resists a step of contacts, in the units of the parameters; `...` is the shape of the contacts, none for one.

    Attributes:
        force: T, (..., 2) [force]: positive where it resists a positive displacement.
        stiffness: dT/d(increment), (..., 2, 2) [force/length], symmetric.
        dforce_dload: dT/d(load), (..., 2); only where `details` are asked for, as what follows.
        dissipated: energy lost in the step, (...) [force length], >= 0: heat of slip, and what parts held that separated.
        slipping: fraction of the strength that slips, (...), 0 to 1; 1 is gross slip.
    """

    force: Array
    stiffness: Array
    dforce_dload: Array | None = None
    dissipated: Array | None = None
    slipping: Array | None = None


class Microslip:
    """Contacts of one law that remember how they were displaced; made by `Model.microslip`.

        contact = model.microslip()
        for increment in increments:
            force = contact.step(load, increment).force

    The law is that of the model when this was made. Pickled and copied, they go with their law and their states.

    Attributes:
        state: of the contacts, (..., length), all 0 where a contact has just closed. Copy it to keep it, assign to it to go back,
            `turn` it with the contacts.
    """

    state: Array

    def __init__(self, handle: Handle, shape: tuple[int, ...]) -> None:
        self._handle = handle
        self.state = np.zeros((*shape, LIBRARY.asperity_microslip_length(handle.pointer)))

    def __getstate__(self) -> tuple[Params, float, Array]:
        return self._handle.params, self._handle.largest_load, self.state

    def __setstate__(self, saved: tuple[Params, float, Array]) -> None:
        params, largest_load, self.state = saved
        self._handle = Handle(params, largest_load)

    def turn(self, angle: npt.ArrayLike) -> None:
        """Turns the states with the directions of the contacts.

        Args:
            angle: by which a force turns from the first direction to the second [rad]; a number, or one for each contact.

        Raises:
            Error: an angle or a state that is not finite; the contacts are then as before.
            Error: angles that do not have the shape of the contacts.
        """
        shape = self.state.shape[:-1]
        length = LIBRARY.asperity_microslip_length(self._handle.pointer)
        angles = _like("angle", angle, shape, "rad").ravel()
        turned = _like("state", self.state, (*shape, length)).copy()
        for state, by in zip(turned.reshape(-1, length), angles):
            cosine, sine = (math.cos(by), math.sin(by)) if math.isfinite(by) else (math.nan, math.nan)
            check(LIBRARY.asperity_microslip_turn(_data(state), cosine, sine))
        self.state = turned

    def step(
        self, load: npt.ArrayLike, increment: npt.ArrayLike, *, keep: bool = True, details: bool = False
    ) -> MicroslipStep:
        """Displaces the contacts under loads.

        Args:
            load: normal load of each contact in this step [force]; a number, or an array of the shape of the contacts. Below the
                pull-off load a contact is open: force and stiffness are 0 and it forgets.
            increment: displacement of one surface along the other since the last step that was kept, (..., 2) [length].
            keep: whether the contacts are displaced for good; an iteration tries with `keep=False`.
            details: whether `dforce_dload`, `dissipated` and `slipping` are asked for too, at one call for each contact.

        Raises:
            Error: a load that is NaN, infinite or too heavy, an increment or a state that is not finite. The message names the
                element; the contacts are then as before.
            Error: arrays that do not have the shape of the contacts.
        """
        shape = self.state.shape[:-1]
        in_si = self._handle.params.in_si
        loads = _like("load", load, shape, units.unit("force", in_si))
        increments = _like("increment", increment, (*shape, 2), units.unit("length", in_si))
        length = LIBRARY.asperity_microslip_length(self._handle.pointer)
        before = _like("state", self.state, (*shape, length))
        after = np.empty_like(before)
        force, stiffness = np.empty((*shape, 2)), np.empty((*shape, 2, 2))
        arrays = [_data(one) for one in (loads, increments, before, after, force, stiffness)]
        status = LIBRARY.asperity_microslip_steps(self._handle.pointer, loads.size, *arrays)
        if status == Status.SEPARATED and np.isnan(force).any():
            # An open contact that is reported first hides one that has no answer.
            bad = np.isnan(force[..., 0]).ravel()
            first = int(np.flatnonzero(bad)[0])
            self._one(loads.ravel()[first], increments.reshape(-1, 2)[first], before.reshape(-1, length)[first])
        if status != Status.SEPARATED:
            check(status)
        more: dict[str, Array] = {}
        if details:
            found = [
                self._one(*each) for each in zip(loads.ravel(), increments.reshape(-1, 2), before.reshape(-1, length))
            ]
            more["dforce_dload"] = np.array([list(one.dforce_dload) for one in found]).reshape(*shape, 2)
            more["dissipated"] = np.array([one.dissipated for one in found]).reshape(shape)
            more["slipping"] = np.array([one.slipping for one in found]).reshape(shape)
        if keep:
            self.state = after
        return MicroslipStep(force, stiffness, **more)

    def _one(self, load: float, increment: Array, before: Array) -> Any:
        struct = _header.asperity_microslip(struct_size=ctypes.sizeof(_header.asperity_microslip))
        data = [_data(np.ascontiguousarray(one)) for one in (increment, before)]
        status = LIBRARY.asperity_microslip_step(self._handle.pointer, load, *data, None, ctypes.byref(struct))
        if status != Status.SEPARATED:
            check(status)
        return struct


def _like(name: str, given: npt.ArrayLike, shape: tuple[int, ...], unit: str = "") -> Array:
    array = checks.array(name, given, unit)
    try:
        return np.ascontiguousarray(np.broadcast_to(array, shape))
    except ValueError:
        raise Error(f"{name} of shape {array.shape}: must have the shape of the contacts, {shape}") from None


def _data(array: Array) -> Any:
    return array.ctypes.data_as(_DOUBLES)
