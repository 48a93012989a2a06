"""A ball that bounces off a floor and slides on it in three worlds of MuJoCo Warp, with each input changed once and run again in the
same process: the friction impulse of the impact against the law at the loads met, and friction afterwards against the law at the
ball's weight. SI units.
"""

import sys
from pathlib import Path

import mujoco
import mujoco_warp
import numpy as np
import warp

import asperity
import asperity.mujoco_warp

sys.path.insert(0, str(Path(__file__).parents[1]))
import verdict  # noqa: E402
from surface import demand, surface  # noqa: E402

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


def attached(laws, time_constant=None, passes=2, **changes):
    model = model_of(GIVEN | changes)
    data = mujoco.MjData(model)
    data.qvel[0] = SPEED
    m = mujoco_warp.put_model(model)
    d = mujoco_warp.put_data(model, data, nworld=len(FALL), nconmax=8, njmax=8)
    asperity.mujoco_warp.attach(model, m, d, laws, time_constant, passes)
    return m, d


def throw(m, d, fall):
    mujoco_warp.reset_data(m, d)
    d.qvel.assign(np.column_stack([SPEED * (1 + FALL), -fall]).astype(np.float32))


def normal_forces(d):
    """The normal force in each world."""
    found, force = np.zeros(len(FALL)), d.efc.force.numpy()
    count = int(d.nacon.numpy()[0])
    for world, address in zip(d.contact.worldid.numpy()[:count], d.contact.efc_address.numpy()[:count, 0]):
        found[world] += force[world, address] if address >= 0 else 0
    return found


def run(m, d, law, mass, timestep):
    """The errors of the impact and of the sliding in each world. Sliding, the ball hops: its impulse of friction is that of the law
    at its weight, over what the floor carries by the ball's momentum."""
    throw(m, d, FALL)
    start = d.qvel.numpy().astype(float)
    expected, impulse, bounced = np.zeros(len(FALL)), np.zeros(len(FALL)), np.zeros(len(FALL), bool)
    while not bounced.all():
        mujoco_warp.step(m, d)
        loads = normal_forces(d)
        bounced |= (expected > 0) & (loads == 0)
        forces = [law.friction_force_at_load(load) if load > 0 else 0 for load in loads]
        expected += np.where(bounced, 0, forces) * timestep
        impulse = np.where(bounced, impulse, mass * (start - d.qvel.numpy())[:, 0])
    throw(m, d, 0 * FALL)
    while (begin := d.time.numpy()[0]) < 0.15:
        mujoco_warp.step(m, d)
    start = d.qvel.numpy().astype(float)
    while d.time.numpy()[0] < begin + 0.2:
        mujoco_warp.step(m, d)
    slowed, lifted = mass * (d.qvel.numpy() - start).T * [[-1], [1]]
    carried = lifted + mass * GRAVITY * (d.time.numpy() - begin)
    return np.abs(impulse / expected - 1), np.abs(slowed / carried / law.state_at_load(mass * GRAVITY).friction_coefficient - 1)


def alterations():
    slippery = FILM.replace(work_of_adhesion=0.02)
    yield from ((change, FILM) for change in (
        dict(mass=0.1), dict(mass=10.0), dict(solref="0.01 1"), dict(timestep=0.001), dict(friction=0.2), dict(impratio=1),
        dict(time_constant=0.04), dict(passes=4),
    ))  # fmt: skip
    yield dict(), slippery
    yield dict(), FILM.calibrated(10, 0.1)


def check_refusals(law):
    for laws, changes, words in (
        ({PAIR: law}, dict(cone="pyramidal"), 'cone="elliptic"'), ({PAIR: law}, dict(integrator="RK4"), "RK4"),
        ({("bal", "floor"): law}, {}, "bal"), ({PAIR: law}, dict(time_constant=0), "time_constant = 0"),
        ({PAIR: law}, dict(passes=0), "passes = 0"),
        ({"ball": law, "floor": asperity.Model(FILM)}, {}, "different surfaces"),
    ):  # fmt: skip
        try:
            attached(laws, **changes)
        except (ValueError, KeyError) as error:
            if words not in str(error):
                raise RuntimeError(f"{changes}: the message lacks {words!r}: {error}") from None
        else:
            raise RuntimeError(f"{laws}, {changes}: taken")


def main():
    warp.config.quiet = True
    law = asperity.Model(FILM)
    demand(law, 0.5, 900)
    m, d = attached({PAIR: law})
    first = run(m, d, law, GIVEN["mass"], GIVEN["timestep"])
    print(f"as it comes: impulse {first[0]}, sliding {first[1]}")
    worst = [np.max(error) for error in first]
    for changes, params in alterations():
        altered = asperity.Model(params)
        given = GIVEN | changes
        # One geom for all pairs in which it is, in every second run.
        name = "ball" if "mass" in changes else PAIR
        found = run(*attached({name: altered}, **changes), altered, given["mass"], given["timestep"])
        print(f"  {changes}: impulse {np.max(found[0]):.1e}, sliding {np.max(found[1]):.1e}")
        worst = [np.maximum(old, np.max(new)) for old, new in zip(worst, found)]
    check_refusals(law)
    if not np.array_equal(run(m, d, law, GIVEN["mass"], GIVEN["timestep"]), first):
        raise RuntimeError("reset, the first run does not give the same bits again")
    good = worst[0] <= BOUNCE_LIMIT and worst[1] <= SLIDE_LIMIT
    return good, (
        f"impulse of an impact {worst[0]:.1e} (limit {BOUNCE_LIMIT:g}), sliding {worst[1]:.1e} (limit {SLIDE_LIMIT:g}), "
        f"{len(FALL)} worlds"
    )


if __name__ == "__main__":
    verdict.run("mujoco_warp", main)
