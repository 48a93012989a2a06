"""Bodies that stick in MuJoCo, with the plugin's `microslip`: a box on an incline below the slip angle does not creep, and comes back when it
is unloaded; a ball rolls as without microslip. MuJoCo's own contact creeps. SI units.
"""

import math
import sys
import time
from pathlib import Path

import mujoco
import numpy as np

import asperity.mujoco

sys.path.insert(0, str(Path(__file__).parents[1]))
import incline  # noqa: E402
import verdict  # noqa: E402

MASS, GRAVITY, HALF = incline.MASS, incline.GRAVITY, incline.HALF_LENGTHS[2]
TIMESTEP, IMPRATIO = 0.002, 10  # MuJoCo's own step; the ratio that its manual advises against slip
SHARE = 0.8  # of the slip load
TURN_RATIO_LIMIT = 5  # on a turntable; what is left is the integrator's
RATIO_LIMIT = 100  # of MuJoCo's own creep to that of microslip
LOOP_LIMIT, SLOW_LIMIT, ROLL_LIMIT = 0.01, 1e-3, 1e-4
BOX = f'<geom type="box" size="{" ".join(map(str, incline.HALF_LENGTHS))}" mass="{MASS}"/>'
SLIDES = '<joint name="x" type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>'  # a box that does not tilt
BALL = f'<geom type="sphere" size="{HALF}" mass="{MASS}"/>'


def model_of(law, angle, microslip, geom=BOX, friction=incline.FIRST_GUESS, impratio=IMPRATIO, config="", actuator="",
             joints="<freejoint/>"):  # fmt: skip
    """A body on a plane under inclined gravity; without `microslip` (None) the friction is MuJoCo's own."""
    extension = body = ""
    if microslip is not None:
        instance = asperity.mujoco.instance("carbon", law.params)
        instance = instance.replace("</instance>", f'<config key="microslip" value="{microslip}"/>{config}</instance>')
        extension = f'<extension><plugin plugin="asperity.friction">{instance}</plugin></extension>'
        body = '<plugin instance="carbon"/>'
    gravity = f"{GRAVITY * math.sin(angle)!r} 0 {-GRAVITY * math.cos(angle)!r}"
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      {extension}
      <option cone="elliptic" impratio="{impratio}" timestep="{TIMESTEP}" gravity="{gravity}"/>
      <default><geom friction="{friction!r}"/></default>
      <worldbody>
        <geom type="plane" size="5 5 0.1"/>
        <body pos="0 0 {HALF}">{body}{joints}{geom}</body>
      </worldbody>
      {actuator}
    </mujoco>""")


def run(model, data, seconds):
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)


def slip_angle(law):
    """The incline at which the law lets the box slip: tan(angle) = mu of the load there."""
    angle = 0.2
    for _ in range(50):
        angle = math.atan(law.friction_at_load(MASS * GRAVITY * math.cos(angle)))
    return angle


def angle_of(law, share):
    """The incline at which the weight pulls with this share of the slip load."""
    angle = slip_angle(law)
    for _ in range(50):
        force = law.friction_force_at_load(MASS * GRAVITY * math.cos(angle))
        angle = math.asin(share * force / (MASS * GRAVITY))
    return angle


def drift(law, microslip, **options):
    """The speed of a box that is pulled with SHARE of its slip load, between 1 s and 6 s, in the plane of the incline."""
    angle = angle_of(law, SHARE)
    model = model_of(law, angle, microslip, friction=law.friction_at_load(MASS * GRAVITY * math.cos(angle)))
    for name, value in options.items():
        setattr(model.opt, name, value)
    data = mujoco.MjData(model)
    run(model, data, 1)
    begin = data.qpos[:2].copy()
    run(model, data, 5)
    return float(np.linalg.norm(data.qpos[:2] - begin)) / 5


def check_creep(law):
    own, coefficient, held = (drift(law, microslip) for microslip in (None, "false", "true"))
    print(f"hold: at {SHARE:g} of the slip load MuJoCo's own contact creeps at {1e6 * own:.3g} um/s, with the law as its coefficient at "
          f"{1e6 * coefficient:.3g} um/s, with microslip at {1e6 * held:.2g} um/s")  # fmt: skip
    if not (own > 1e-6 and held * RATIO_LIMIT <= own):
        raise RuntimeError(f"the box creeps at {held} m/s with microslip, at {own} m/s with MuJoCo's own contact")
    for option, value in (
        ("integrator", mujoco.mjtIntegrator.mjINT_RK4),
        ("integrator", mujoco.mjtIntegrator.mjINT_IMPLICIT),
        ("integrator", mujoco.mjtIntegrator.mjINT_IMPLICITFAST),
        ("solver", mujoco.mjtSolver.mjSOL_PGS),
        ("solver", mujoco.mjtSolver.mjSOL_CG),
        ("disableflags", mujoco.mjtDisableBit.mjDSBL_ISLAND),
        ("noslip_iterations", 10),
    ):
        found = drift(law, "true", **{option: value})
        print(f"  {option} {value}: {1e6 * found:.2g} um/s")
        if not found * RATIO_LIMIT <= own:
            raise RuntimeError(f"the box creeps at {found} m/s with {option} {value}")
    return own, held


def pulled(model, forces):
    """Where the box comes to rest under each of these forces along the plane, one after the other, reached slowly."""
    data = mujoco.MjData(model)
    run(model, data, 1)
    begin, places = data.qpos[0], []
    for force in forces:
        for part in np.linspace(data.qfrc_applied[0], force, 200):
            data.qfrc_applied[0] = part
            mujoco.mj_step(model, data)
        run(model, data, 2)
        places.append(data.qpos[0] - begin)
    return np.array(places)


def check_loop(law):
    """Loaded to 0.8 of the slip load, unloaded, pulled back and loaded again: the displacements are those of the law's curve
    and of Masing's rule, in a length that is MuJoCo's."""
    load = MASS * GRAVITY
    friction, length = law.friction_force_at_load(load), law.friction_force_at_load(load) / law.tangential_stiffness_at_load(load)
    grid = np.linspace(0, 4, 4001)
    curve = law.tangential(load, grid * length)[0] / friction
    monotonic = np.interp([0.4, SHARE], curve, grid)
    half = np.interp(SHARE / 2, curve, grid)
    expected = np.array([*monotonic, monotonic[1] - 2 * half, -monotonic[1], monotonic[1]])
    places = pulled(model_of(law, 0.0, "true", joints=SLIDES), friction * np.array([0.4, SHARE, 0, -SHARE, SHARE]))
    scale = places[1] / expected[1]
    error = np.max(np.abs(places / scale - expected)) / expected[1]
    print(f"hold: a loop of {places[1]:.2e} m (the summits' own: {expected[1] * length:.2e} m) is that of the law within {error:.1e} "
          f"(limit {LOOP_LIMIT:g})")  # fmt: skip
    if not error <= LOOP_LIMIT:
        raise RuntimeError(f"the box stands at {places / scale}, the law says {expected}")


def check_slow_slip(law):
    """Drawn at 0.1 mm/s: friction is the law's, where MuJoCo's own contact is below its cone."""
    friction = law.friction_force_at_load(MASS * GRAVITY)
    errors = {}
    for microslip in ("false", "true"):
        model = model_of(law, 0.0, microslip, impratio=1, actuator='<actuator><velocity joint="x" kv="1e5"/></actuator>',
                         joints=SLIDES)  # fmt: skip
        model.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
        data = mujoco.MjData(model)
        data.ctrl[0] = 1e-4
        run(model, data, 5)
        errors[microslip] = abs(data.qfrc_actuator[0] / friction - 1)
    print(f"hold: drawn at 0.1 mm/s, impratio 1, the pull is the law's within {errors['true']:.1e} (limit {SLOW_LIMIT:g}); without "
          f"microslip within {errors['false']:.1e}")  # fmt: skip
    if not errors["true"] <= SLOW_LIMIT < errors["false"]:
        raise RuntimeError(f"slow slip: {errors}")


def check_twist(law):
    """A moment about the normal, half of what makes the box slip, does not turn it."""
    moment = 0.5 * law.friction_force_at_load(MASS * GRAVITY) * math.hypot(*incline.HALF_LENGTHS[:2])
    turns = []
    for microslip in ("false", "true"):
        data = mujoco.MjData(model := model_of(law, 0.0, microslip))
        data.qfrc_applied[5] = moment
        run(model, data, 1)
        begin = data.qpos[6]
        run(model, data, 4)
        turns.append(abs(data.qpos[6] - begin) * 2 / 4)
    without, held = turns
    print(f"hold: at half the moment at which it slips the box turns at {held:.1e} rad/s, without microslip at {without:.1e}")
    if not (without > 1e-5 and held * RATIO_LIMIT <= without):
        raise RuntimeError(f"the box turns at {held} rad/s with microslip, at {without} without")


def check_cost(law):
    """What microslip adds to a step of the box; printed, not judged: the machine is not idle."""
    seconds = {"false": [], "true": []}
    for _ in range(5):
        for microslip, found in seconds.items():
            data = mujoco.MjData(model := model_of(law, 0.1, microslip))
            begin = time.process_time()
            mujoco.mj_step(model, data, 2000)
            found.append((time.process_time() - begin) / 2000)
    without, held = (1e6 * float(np.median(found)) for found in seconds.values())
    print(f"hold: a step takes {held:.1f} us with microslip, {without:.1f} us without")


def turntable_drift(law, microslip):
    """How fast the box moves over a table that turns at 1 rad/s, 0.3 m from its axis."""
    instance = asperity.mujoco.instance("carbon", law.params)
    instance = instance.replace("</instance>", f'<config key="microslip" value="{microslip}"/></instance>')
    model = mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      <extension><plugin plugin="asperity.friction">{instance}</plugin></extension>
      <option cone="elliptic" impratio="{IMPRATIO}" timestep="{TIMESTEP}" integrator="implicitfast"/>
      <worldbody>
        <body name="table"><joint name="axis" type="hinge" axis="0 0 1"/><geom type="box" size="1 1 0.05" mass="50"/></body>
        <body name="box" pos="0.3 0 {0.05 + HALF}"><plugin instance="carbon"/><freejoint/>{BOX}</body>
      </worldbody>
      <actuator><velocity joint="axis" kv="1e5"/></actuator>
    </mujoco>""")
    data = mujoco.MjData(model)
    places = []
    for end in (3, 8):
        while data.time < end:
            data.ctrl[0] = min(1, data.time / 2)
            mujoco.mj_step(model, data)
        places.append(data.body("table").xmat.reshape(3, 3).T @ data.body("box").xpos)
    return float(np.linalg.norm(places[1] - places[0])) / 5


def check_turntable(law):
    """Friction gives the box the acceleration towards the axis, without the drift that MuJoCo has in bodies that turn together."""
    without, held = (turntable_drift(law, microslip) for microslip in ("false", "true"))
    print(f"hold: on a turntable the box drifts at {1e3 * held:.2g} mm/s, without microslip at {1e3 * without:.2g} mm/s")
    if not (without > 1e-3 and held * TURN_RATIO_LIMIT <= without):
        raise RuntimeError(f"on a turntable the box drifts at {held} m/s with microslip, at {without} without")


def check_rolling(law):
    """A ball rolls down as without microslip: its point of contact does not slip."""
    angle = math.radians(10)
    speeds = []
    for microslip in ("false", "true"):
        data = mujoco.MjData(model := model_of(law, angle, microslip, geom=BALL))
        run(model, data, 0.5)
        speeds.append(data.qvel[0])
    without, held = speeds
    right, difference = 5 / 7 * GRAVITY * math.sin(angle) * 0.5, abs(held / without - 1)
    print(f"hold: a ball rolls at {held / right:.4f} of 5/7 g sin(angle) t, as without microslip within {difference:.1e} "
          f"(limit {ROLL_LIMIT:g})")  # fmt: skip
    if not (difference <= ROLL_LIMIT and abs(held / right - 1) <= 0.01):
        raise RuntimeError(f"a ball rolls at {speeds} m/s, not {right}")


def main():
    law = incline.law()
    own, held = check_creep(law)
    for check in (check_loop, check_slow_slip, check_twist, check_turntable, check_rolling, check_cost):
        check(law)
    return True, f"creep at {SHARE:g} of the slip load: {held:.1e} m/s with microslip, {own:.1e} m/s without"


if __name__ == "__main__":
    verdict.run("mujoco", main)
