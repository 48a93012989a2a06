"""A spring-slider whose motion is differentiated through time: which load gives the motion that was measured?

A block of silicon on silicon, pulled back by a spring, is let go and slides under friction F(load) tanh(v/v0).
Newton's method finds the load from where the block is after 60 us: the derivative of the whole motion by the load is JAX's,
through every time step and the law. Needs the extra `jax`.
"""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp

import asperity.jax
from asperity import Model, Params

jax.config.update("jax_enable_x64", True)

MASS, STIFFNESS, PULLED_BACK = 1e-9, 10.0, 2e-4  # kg, N/m, m
STEP, STEPS, CREEP = 1e-7, 600, 0.1  # s, -, m/s: at this slip rate friction has three quarters of its size
SURFACE = Params.si(
    E1=160e9, nu1=0.22, E2=160e9, nu2=0.22, work_of_adhesion=0.063, adhesion_range=0.384e-9, burgers_vector=0.384e-9,
    height_std=2.7e-9, summit_radius=1.7e-7, summit_density=1.2e14, nominal_area=1e-10,
)  # fmt: skip


def slide(friction_force: Any, load: Any) -> Any:
    """Where the block is after STEPS steps of symplectic Euler [m], from the middle of the spring."""
    force = friction_force(load)

    def advance(state: tuple[Any, Any], _: None) -> tuple[tuple[Any, Any], None]:
        place, rate = state
        rate = rate - STEP / MASS * (STIFFNESS * place + force * jnp.tanh(rate / CREEP))
        return (place + STEP * rate, rate), None

    (place, _), _ = jax.lax.scan(advance, (-PULLED_BACK, 0.0), None, length=STEPS)
    return place


def load_from_place(friction_force: Any, place: float, load: float) -> list[float]:
    """Newton's method for the load with which the block gets there: its iterations."""
    place_and_slope = jax.jit(jax.value_and_grad(lambda load: slide(friction_force, load)))
    iterations = [load]
    while len(iterations) < 20:
        reached, slope = place_and_slope(iterations[-1])
        iterations.append(float(iterations[-1] - (reached - place) / slope))
        if abs(iterations[-1] / iterations[-2] - 1) < 1e-10:
            break
    return iterations


def main() -> None:
    model = Model(SURFACE)
    friction_force = asperity.jax.friction_force(model)
    load = 1e-3
    place = float(slide(friction_force, load))
    print(f"with {load * 1e3:.3f} mN the block is {place * 1e6:.3f} um from the middle after {STEP * STEPS * 1e6:.0f} us")
    for found in load_from_place(friction_force, place, 0.6 * load):
        print(f"  load {found * 1e3:.9f} mN")
    print(model.check(0.6 * load, load))  # the strength of this interface was not measured


if __name__ == "__main__":
    main()
