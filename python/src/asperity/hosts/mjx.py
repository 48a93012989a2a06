"""The law at the contacts of MuJoCo XLA; `asperity.mjx` has the names."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from ..errors import Error
from ..model import Model

try:
    import jax
    import jax.numpy as jnp
    import mujoco
    from mujoco import mjx
except ImportError as error:
    raise ImportError(f"asperity.mjx needs MuJoCo XLA ({error}): pip install mujoco-mjx") from None

from .jax import friction
from .mujoco_pairs import Attached, Geoms, lag_rule

__all__ = ["Friction", "Loads", "attach"]

_lag_rule = lag_rule(jnp.where, jnp.minimum, jnp.maximum)


class Loads(NamedTuple):
    """What a world remembers from step to step: the time [s], and of each pair its load or mean load [force], for how long it has
    touched and for how long it has been apart [s]."""

    time: Any
    mean: Any
    age: Any
    apart: Any


class Friction(Attached):
    """What `attach` returns: the step that has the friction of laws. Its methods are pure functions of their arguments, so that
    `jax.jit`, `jax.vmap`, `jax.lax.scan` and `jax.grad` apply to them."""

    def __init__(
        self, model: mujoco.MjModel, m: Any, d: Any, laws: Mapping[Geoms, Model], time_constant: float | None, passes: int
    ) -> None:
        if not hasattr(d._impl, "efc_J"):
            raise Error("needs mjx.put_model(model, impl='jax'): for Warp there is asperity.mujoco_warp, with MuJoCo Warp's own step")
        super().__init__(model, m, laws, time_constant, passes)
        own = np.maximum(model.geom_friction[:, None, 0], model.geom_friction[None, :, 0])
        for a, b in np.argwhere((self._pairs.number >= 0) & (own < mujoco.mjMINMU)):
            names = f"{model.geom(a).name!r} and {model.geom(b).name!r}"
            raise Error(f"geoms {names}: need a friction above 0, which the law replaces: of 0 MJX makes contacts that are not numbers")
        self._dtype = d.qpos.dtype
        self._laws = [friction(each, self._dtype) for each in self._pairs.laws]

    def loads(self, *worlds: int) -> Loads:
        """What is remembered at the start, where no pair has touched: of one world, or of so many for `jax.vmap`."""
        zeros = jnp.zeros((*worlds, self._pairs.count), self._dtype)
        return Loads(jnp.full(worlds, -jnp.inf, self._dtype), zeros, zeros, zeros)

    def step(self, m: Any, d: Any, loads: Loads) -> tuple[Any, Loads]:
        """One step, in place of `mjx.step(m, d)`: the data and the loads after it."""
        d = mjx.fwd_position(m, d)
        d = mjx.fwd_velocity(m, mjx.sensor_pos(m, d))
        d = mjx.fwd_actuation(m, mjx.sensor_vel(m, d))
        d = mjx.fwd_acceleration(m, d)
        if d._impl.efc_J.size == 0:
            d = d.replace(qacc=d.qacc_smooth)
        else:
            d, loads = self._solve(m, d, loads)
            d = mjx.sensor_acc(m, d)
        euler = int(m.opt.integrator) == int(mujoco.mjtIntegrator.mjINT_EULER)
        return (mjx.euler if euler else mjx.implicit)(m, d), loads

    def _solve(self, m: Any, d: Any, loads: Loads) -> tuple[Any, Loads]:
        step, load = m.opt.timestep, loads.mean
        constant = jnp.maximum(0.05, 40 * step) if self.time_constant is None else self.time_constant

        def solved(_: int, worlds: tuple[Any, Any]) -> tuple[Any, Any]:
            d = mjx.solve(m, self._with_friction(*worlds))
            return d.replace(qacc_warmstart=d.qacc), self._load(d)

        d, load = jax.lax.fori_loop(0, self.passes, solved, (d, load))  # compiled once for all passes
        load, *kept = _lag_rule(d.time, loads.time, step, constant, load, loads.mean, loads.age, loads.apart)
        d = mjx.solve(m, self._with_friction(d, load))
        return d, Loads(*(jnp.asarray(value, self._dtype) for value in (d.time, *kept)))

    def _pair_of(self, contact: Any) -> Any:
        """The number of the pair of each contact; one more than the last for none."""
        number = jnp.asarray(self._pairs.number)[contact.geom[:, 0], contact.geom[:, 1]]
        return jnp.where((number >= 0) & (np.asarray(contact.dim) >= 3), number, self._pairs.count)

    def _load(self, d: Any) -> Any:
        """The sum of the normal forces of the points of each pair."""
        contact = d._impl.contact
        force = d._impl.efc_force[np.asarray(contact.efc_address)]
        return jnp.zeros(self._pairs.count + 1, self._dtype).at[self._pair_of(contact)].add(force)[:-1]

    def _with_friction(self, d: Any, load: Any) -> Any:
        """The data with the coefficients of the laws at loads. The coefficients of a contact keep their ratios, on which its
        regularisation rests."""
        law = jnp.zeros(self._pairs.count + 1, self._dtype)
        for number, of_law in enumerate(self._laws):
            (ours,) = np.nonzero(self._pairs.law_of == number)
            touching = load[ours] > 0
            coefficient = jnp.maximum(of_law(jnp.where(touching, load[ours], 1)), mujoco.mjMINMU)
            law = law.at[ours].set(jnp.where(touching, coefficient, 0))
        contact = d._impl.contact
        given, wanted = contact.friction, law[self._pair_of(contact)]
        ratio = jnp.where(wanted > 0, wanted / jnp.maximum(given[:, 0], mujoco.mjMINMU), 1)
        return d.tree_replace({"_impl.contact.friction": given * ratio[:, None]})


def attach(
    model: mujoco.MjModel, m: Any, d: Any, laws: Mapping[Geoms, Model], time_constant: float | None = None, passes: int = 2
) -> Friction:
    """The step of a model with which pairs of geoms have the friction of laws. Arguments and errors are those of
    `asperity.hosts.mujoco_pairs.Attached`; `d`, an `mjx.Data` of MJX's back end JAX, has the type of the law: float32, or float64 with
    `jax_enable_x64`.
    """
    return Friction(model, m, d, laws, time_constant, passes)
