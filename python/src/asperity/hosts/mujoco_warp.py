"""The law at the contacts of MuJoCo Warp; `asperity.mujoco_warp` has the names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from ..errors import Error
from ..model import Model
from .warp import Law32, friction, law

try:
    import mujoco
    import mujoco_warp
    import warp as wp

    from .mujoco_pairs import Attached, Geoms, lag_rule
except ImportError as error:
    raise ImportError(f"asperity.mujoco_warp needs MuJoCo Warp ({error}): pip install mujoco-warp") from None

__all__ = ["Friction", "attach"]

_lag_rule = wp.func(lag_rule(wp.where, wp.min, wp.max))
_vec5 = wp.types.vector(length=5, dtype=wp.float32)


@wp.kernel
def _add_loads(
    contacts: wp.array(dtype=int), geom: wp.array(dtype=wp.vec2i), address: wp.array2d(dtype=int), world: wp.array(dtype=int),
    dim: wp.array(dtype=int), pair_of: wp.array2d(dtype=int), force: wp.array2d(dtype=float), load: wp.array2d(dtype=float),
):  # fmt: skip
    contact = wp.tid()
    if contact >= contacts[0] or dim[contact] < 3 or address[contact, 0] < 0:
        return
    a, b = geom[contact][0], geom[contact][1]
    if a >= 0 and b >= 0 and pair_of[a, b] >= 0:
        wp.atomic_add(load, world[contact], pair_of[a, b], force[world[contact], address[contact, 0]])


@wp.kernel
def _take_loads(
    time: wp.array(dtype=float), timestep: wp.array(dtype=float), time_constant: float, load: wp.array2d(dtype=float),
    before: wp.array(dtype=float), mean: wp.array2d(dtype=float), age: wp.array2d(dtype=float), apart: wp.array2d(dtype=float),
):  # fmt: skip
    world, pair = wp.tid()
    step = timestep[world % timestep.shape[0]]
    constant = time_constant
    if constant < 0.0:
        constant = wp.max(0.05, 40.0 * step)
    taken, average, had, since = _lag_rule(
        time[world], before[world], step, constant, load[world, pair], mean[world, pair], age[world, pair], apart[world, pair]
    )
    load[world, pair] = taken
    mean[world, pair] = average
    age[world, pair] = had
    apart[world, pair] = since


@wp.kernel
def _set_friction(
    contacts: wp.array(dtype=int), geom: wp.array(dtype=wp.vec2i), address: wp.array2d(dtype=int), world: wp.array(dtype=int),
    dim: wp.array(dtype=int), pair_of: wp.array2d(dtype=int), surface_of: wp.array(dtype=int), surface: int, law: Law32,
    mean: wp.array2d(dtype=float), coefficients: wp.array(dtype=_vec5),
):  # fmt: skip
    contact = wp.tid()
    if contact >= contacts[0] or dim[contact] < 3 or address[contact, 0] < 0:
        return
    a, b = geom[contact][0], geom[contact][1]
    if a < 0 or b < 0 or pair_of[a, b] < 0 or surface_of[pair_of[a, b]] != surface:
        return
    load = mean[world[contact], pair_of[a, b]]
    if load > 0.0:
        # The coefficients keep their ratios, on which the regularisation of the contact rests.
        given = coefficients[contact]
        coefficients[contact] = given * (wp.max(friction(law, load), 1e-5) / given[0])


class Friction(Attached):
    """What `attach` adds to a model: the loads of pairs in each world, which it keeps from step to step."""

    def __init__(
        self, model: mujoco.MjModel, m: Any, d: Any, laws: Mapping[Geoms, Model], time_constant: float | None, passes: int
    ) -> None:
        super().__init__(model, m, laws, time_constant, passes)
        if int(m.opt.disableflags) & int(mujoco.mjtDisableBit.mjDSBL_ACTUATION):
            raise Error('needs <flag actuation="enable"/>: MuJoCo Warp calls no control callback without it')
        pairs = self._pairs
        device, shape = d.qpos.device, (d.nworld, max(1, pairs.count))
        self._laws = [law(each, np.float32, device) for each in pairs.laws]
        self._pair_of = wp.array(pairs.number, dtype=int, device=device)
        self._surface_of = wp.array(pairs.law_of, dtype=int, device=device)
        self._load, self._mean, self._age, self._apart = (wp.zeros(shape, dtype=float, device=device) for _ in range(4))
        self._before = wp.full(d.nworld, -1.0, dtype=float, device=device)

    def __call__(self, m: Any, d: Any) -> None:
        """Sets the friction of the contacts of a step, before it is solved."""
        contact, device = d.contact, d.qpos.device
        ours = [d.nacon, contact.geom, contact.efc_address, contact.worldid, contact.dim, self._pair_of]

        def set_friction(load: Any) -> None:
            for surface, of_surface in enumerate(self._laws):
                given = [*ours, self._surface_of, surface, of_surface, load, contact.friction]
                wp.launch(_set_friction, d.naconmax, given, device=device)

        load = self._mean
        for _ in range(self.passes):
            set_friction(load)
            mujoco_warp.fwd_actuation(m, d)
            mujoco_warp.fwd_acceleration(m, d, factorize=True)
            mujoco_warp.solve(m, d)
            load = self._load
            load.zero_()
            wp.launch(_add_loads, d.naconmax, [*ours, d.efc.force, load], device=device)
        constant = -1.0 if self.time_constant is None else self.time_constant
        loads = [d.time, m.opt.timestep, constant, load, self._before, self._mean, self._age, self._apart]
        wp.launch(_take_loads, load.shape, loads, device=device)
        wp.copy(self._before, d.time)
        set_friction(load)


def attach(
    model: mujoco.MjModel, m: Any, d: Any, laws: Mapping[Geoms, Model], time_constant: float | None = None, passes: int = 2
) -> Friction:
    """Gives pairs of geoms the friction of laws, in every step from now on, of `d`, a `mujoco_warp.Data`. Arguments and errors are those
    of `asperity.hosts.mujoco_pairs.Attached`; disabled actuation is an `Error` too. A control callback of `m` is called first.
    """
    made = Friction(model, m, d, laws, time_constant, passes)
    own = m.callback.control
    if isinstance(own, _Chain):  # attached before
        own = own.own
    m.callback.control = _Chain(own, made)
    return made


class _Chain:
    """The user's control callback, then the law."""

    def __init__(self, own: Any, law: Friction) -> None:
        self.own, self.law = own, law

    def __call__(self, m: Any, d: Any) -> None:
        if self.own:
            self.own(m, d)
        self.law(m, d)
