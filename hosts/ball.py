"""A ball that bounces off a floor and slides on it in three worlds of a back end of MuJoCo, with each input changed once and run
again in the same process: the friction impulse of the impact against the law at the loads met, and friction afterwards against the
law at the ball's weight, also under a load that swings. SI units. The back end is a class `Worlds`, as in mujoco_warp/altered.py.
"""

import math

import asperity
import habits
import mujoco
import numpy as np
import verdict
from surface import demand, surface

LIMITS = 0.1, 0.02, 0.1  # of the impact, of sliding, and under a load that swings
AT_ONCE = 10  # steps
SWING, FREQUENCY = 0.8, 5.0  # of the load that swings, over the weight and in Hz
GRAVITY, SPEED, FALL = 9.81, 1.0, np.array([0.5, 1.0, 2.0])  # of three worlds [m/s]
FILM = surface(1e-5)
PAIR = ("ball", "floor")
GIVEN = dict(mass=1.0, solref="0.02 1", timestep=0.002, friction=1, impratio=10, cone="elliptic", integrator="Euler", solver="Newton")


def model_of(given):
    return mujoco.MjModel.from_xml_string("""
    <mujoco>
      <option cone="{cone}" timestep="{timestep}" impratio="{impratio}" integrator="{integrator}" solver="{solver}"/>
      <default><geom friction="{friction}" solref="{solref}"/></default>
      <worldbody>
        <geom name="floor" type="plane" size="90 90 0.1"/>
        <body pos="0 0 0.0501">
          <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><geom name="ball" type="sphere" size="0.05" mass="{mass}"/>
        </body>
      </worldbody>
    </mujoco>""".format(**given))


def slides(worlds, law, mass, timestep, swing):
    """The error of the impulse of friction in each world. The ball hops: that of the law at its load is over what the floor carries by the
    ball's momentum."""
    worlds.throw((2 if swing else 1) * SPEED * (1 + FALL), 0 * FALL)
    settled, end = steps_of(max(0.15, 50 * timestep), timestep), steps_of(0.4 if swing else 0.2, timestep)
    load = mass * GRAVITY * (1 + swing * np.sin(2 * np.pi * FREQUENCY * timestep * np.arange(settled + end)))
    velocities = worlds.steps(mass * GRAVITY - load)[1]
    slowed, lifted = mass * (velocities[-1] - velocities[settled - 1]).T * [[-1], [1]]
    expected, pressing = law.friction_force_at_load(load[settled:]).sum() * timestep, load[settled:].sum() * timestep
    return np.abs(slowed / (expected * (1 + lifted / pressing)) - 1)


def steps_of(time, timestep):
    """A whole number of those that `Worlds.steps` takes at once."""
    return AT_ONCE * math.ceil(time / timestep / AT_ONCE - 1e-9)


def run(worlds, law, mass, timestep):
    """The errors of the impact, of sliding and of sliding under a load that swings, in each world."""
    worlds.throw(SPEED * (1 + FALL), -FALL)
    loads, velocities = worlds.steps(np.zeros(steps_of(0.2, timestep)))
    bounced = np.logical_or.accumulate((np.cumsum(loads, axis=0) > 0) & (loads == 0))
    forces = np.where(bounced | (loads == 0), 0, law.friction_force_at_load(np.where(loads > 0, loads, 1)))
    after = velocities[np.argmax(bounced, axis=0), np.arange(len(FALL)), 0]
    impact = mass * (SPEED * (1 + FALL) - after) / (forces.sum(axis=0) * timestep) - 1
    return np.abs(np.where(bounced[-1], impact, np.inf)), *(slides(worlds, law, mass, timestep, swing) for swing in (0.0, SWING))


HABITS = {
    "a ball of 0.1 kg": dict(mass=0.1), "a ball of 10 kg": dict(mass=10.0), "stiffer": dict(solref="0.01 1"), "a step of 1 ms": dict(timestep=0.001),
    "a step of 5 ms": dict(timestep=0.005), "another friction": dict(friction=0.2), "no friction": dict(friction="0 0 0"), "impratio 1": dict(impratio=1),
    "another time constant": dict(time_constant=0.04), "four passes": dict(passes=4), "one geom": dict(pair="ball"),
    "another surface": dict(params=FILM.replace(work_of_adhesion=0.02)), "calibrated": dict(params=FILM.calibrated(10, 0.1)),
    "pyramidal": dict(cone="pyramidal", refused='cone="elliptic"'), "RK4": dict(integrator="RK4", refused="RK4"),
    "no such geom": dict(laws={("bal", "floor"): asperity.Model(FILM)}, refused="bal"),
    "two surfaces": dict(laws={"ball": asperity.Model(FILM), "floor": asperity.Model(FILM)}, refused="different surfaces"),
    "no time constant": dict(time_constant=0, refused="time_constant = 0"),
    "no passes": dict(passes=0, refused="passes = 0"),
}  # fmt: skip


def main(worlds):
    def ball(pair=PAIR, params=FILM, laws=None, time_constant=None, passes=2, **changes):
        law, given = asperity.Model(params), GIVEN | changes
        return run(worlds(model_of(given), laws or {pair: law}, time_constant, passes), law, given["mass"], given["timestep"])

    demand(asperity.Model(FILM), 0.5, 900)
    worst = habits.worst(HABITS, ball)
    return all(found <= limit for found, limit in zip(worst, LIMITS)), (
        f"impulse of an impact {worst[0]:.1e} (limit {LIMITS[0]:g}), sliding {worst[1]:.1e} (limit {LIMITS[1]:g}), under a load that swings "
        f"{worst[2]:.1e} (limit {LIMITS[2]:g}), {len(FALL)} worlds, {len(HABITS)} habits"
    )
