"""A ball that bounces off a floor and slides on it in three worlds of a back end of MuJoCo, with each input changed once and run
again in the same process: the friction impulse of the impact against the law at the loads met, and friction afterwards against the
law at the ball's weight. SI units. The back end is a class `Worlds`, as in mujoco_warp/altered.py.
"""

import asperity
import mujoco
import numpy as np
import verdict
from surface import demand, surface

BOUNCE_LIMIT, SLIDE_LIMIT = 0.1, 0.02
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


def attached(worlds, laws, time_constant=None, passes=2, **changes):
    model = model_of(GIVEN | changes)
    return worlds(model, laws, time_constant, passes)


def run(worlds, law, mass, timestep):
    """The errors of the impact and of the sliding in each world. Sliding, the ball hops: its impulse of friction is that of the law
    at its weight, over what the floor carries by the ball's momentum."""
    worlds.throw(SPEED * (1 + FALL), -FALL)
    start = worlds.velocities()
    expected, impulse, bounced = np.zeros(len(FALL)), np.zeros(len(FALL)), np.zeros(len(FALL), bool)
    while not bounced.all():
        loads = worlds.step()
        bounced |= (expected > 0) & (loads == 0)
        forces = [law.friction_force_at_load(load) if load > 0 else 0 for load in loads]
        expected += np.where(bounced, 0, forces) * timestep
        impulse = np.where(bounced, impulse, mass * (start - worlds.velocities())[:, 0])
    worlds.throw(SPEED * (1 + FALL), 0 * FALL)
    settled = max(0.15, 50 * timestep)
    while (begin := worlds.time()) < settled:
        worlds.step()
    start = worlds.velocities()
    while worlds.time() < begin + 0.2:
        worlds.step()
    slowed, lifted = mass * (worlds.velocities() - start).T * [[-1], [1]]
    carried = lifted + mass * GRAVITY * (worlds.time() - begin)
    return np.abs(impulse / expected - 1), np.abs(slowed / carried / law.state_at_load(mass * GRAVITY).friction_coefficient - 1)


def alterations():
    slippery = FILM.replace(work_of_adhesion=0.02)
    yield from ((change, FILM) for change in (
        dict(mass=0.1), dict(mass=10.0), dict(solref="0.01 1"), dict(timestep=0.001), dict(timestep=0.005), dict(friction=0.2), dict(impratio=1),
        dict(time_constant=0.04), dict(passes=4),
    ))  # fmt: skip
    yield dict(), slippery
    yield dict(), FILM.calibrated(10, 0.1)


def check_refusals(worlds, law):
    for laws, changes, words in (
        ({PAIR: law}, dict(cone="pyramidal"), 'cone="elliptic"'), ({PAIR: law}, dict(integrator="RK4"), "RK4"),
        ({("bal", "floor"): law}, {}, "bal"), ({PAIR: law}, dict(time_constant=0), "time_constant = 0"),
        ({PAIR: law}, dict(passes=0), "passes = 0"),
        ({"ball": law, "floor": asperity.Model(FILM)}, {}, "different surfaces"),
    ):  # fmt: skip
        try:
            attached(worlds, laws, **changes)
        except (ValueError, KeyError) as error:
            if words not in str(error):
                raise RuntimeError(f"{changes}: the message lacks {words!r}: {error}") from None
        else:
            raise RuntimeError(f"{laws}, {changes}: taken")


def main(worlds):
    law = asperity.Model(FILM)
    demand(law, 0.5, 900)
    ball = attached(worlds, {PAIR: law})
    first = run(ball, law, GIVEN["mass"], GIVEN["timestep"])
    print(f"as it comes: impulse {first[0]}, sliding {first[1]}")
    worst = [np.max(error) for error in first]
    for changes, params in alterations():
        altered = asperity.Model(params)
        given = GIVEN | changes
        # One geom for all pairs in which it is, in every second run.
        name = "ball" if "mass" in changes else PAIR
        found = run(attached(worlds, {name: altered}, **changes), altered, given["mass"], given["timestep"])
        print(f"  {changes}: impulse {np.max(found[0]):.1e}, sliding {np.max(found[1]):.1e}", flush=True)
        worst = [np.maximum(old, np.max(new)) for old, new in zip(worst, found)]
    check_refusals(worlds, law)
    if not np.array_equal(run(ball, law, GIVEN["mass"], GIVEN["timestep"]), first):
        raise RuntimeError("reset, the first run does not give the same bits again")
    good = worst[0] <= BOUNCE_LIMIT and worst[1] <= SLIDE_LIMIT
    return good, (
        f"impulse of an impact {worst[0]:.1e} (limit {BOUNCE_LIMIT:g}), sliding {worst[1]:.1e} (limit {SLIDE_LIMIT:g}), "
        f"{len(FALL)} worlds"
    )
