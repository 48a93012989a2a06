"""A box that slides down an incline and a ball that bounces off a floor in MuJoCo, with each input of the model changed once and
run again in the same process. Sliding, the box hops, so that its load jitters: its acceleration is that of the law at the mean
load. The ball's friction impulse is that of the law at the load of each step, also if the geom's own friction is 1. SI units.
"""

import math
import sys
from pathlib import Path

import mujoco
import numpy as np

import asperity.mujoco

sys.path.insert(0, str(Path(__file__).parents[1]))
import habits  # noqa: E402
import incline  # noqa: E402
import verdict  # noqa: E402
from surface import SURFACE, demand, surface  # noqa: E402

SLIDE_LIMIT, BOUNCE_LIMIT = 0.02, 0.1
ALTERED_SLIDE_LIMIT = 0.05  # hops of another surface, mass or step
FILM = surface(1e-6)
FLAT = '<geom type="box" size="0.1 0.05 0.05" mass="{mass}"/>'
BALL = '<geom type="sphere" size="0.05" mass="{mass}"/>'
GIVEN = dict(text=FILM._as_text().replace('"', "'"), config="", mass=1.0, solref="0.02 1", timestep=0.002, integrator="Euler", solver="Newton",
             impratio=10, friction=1, cone="elliptic", other="")  # fmt: skip


def model_of(body, gravity, **changes):
    """`body` on a floor; `other` is a second instance, with a body of its own."""
    given = GIVEN | changes
    text = f'<config key="text" value="{given["text"]}"/>' if given["text"] else ""
    second = f'<instance name="other"><config key="text" value="{given["other"]}"/></instance>' if given["other"] else ""
    beside = f'<body pos="0 9 0.0499"><plugin instance="other"/><freejoint/>{FLAT}</body>' if given["other"] else ""
    return mujoco.MjModel.from_xml_string(f"""
    <mujoco>
      <extension>
        <plugin plugin="asperity.friction"><instance name="film">{text}{given["config"]}</instance>{second}</plugin>
      </extension>
      <option cone="{given["cone"]}" timestep="{given["timestep"]}" integrator="{given["integrator"]}" solver="{given["solver"]}"
        impratio="{given["impratio"]}" gravity="{gravity[0]!r} 0 {gravity[1]!r}"/>
      <default><geom friction="{given["friction"]}" solref="{given["solref"]}"/></default>
      <worldbody>
        <geom name="floor" type="plane" size="50 50 0.1"/>
        <body pos="0 0 0.0501"><plugin instance="film"/>{body}</body>{beside}
      </worldbody>
    </mujoco>""".format(mass=given["mass"]))


def slide(law, degrees=30, **changes):
    """The acceleration of the box over that of the law at the load of its weight, less 1."""
    angle = math.radians(degrees)
    downhill, normal = incline.GRAVITY * math.sin(angle), incline.GRAVITY * math.cos(angle)
    model = model_of(f"<freejoint/>{FLAT}", (downhill, -normal), **changes)
    data = mujoco.MjData(model)
    times, speeds = [], []
    while data.time < 1.5:
        mujoco.mj_step(model, data)
        times.append(data.time)
        speeds.append(data.qvel[0])
    mass = changes.get("mass", GIVEN["mass"])
    right = downhill - law.state_at_load(mass * normal).friction_force / mass
    return incline.acceleration(times, speeds) / right - 1


def bounce(law, speed=2, **changes):
    """The friction impulse of a ball from its impact until it is free, over that of the law at the loads met; less 1."""
    body = f'<joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/>{BALL}'
    model = model_of(body, (0.0, -incline.GRAVITY), **changes)
    data = mujoco.MjData(model)
    data.qvel[:2] = 20, -speed
    expected = touched = 0.0
    while not (touched and data.qvel[1] > 0 and load == 0):
        mujoco.mj_step(model, data)
        load = sum(data.efc_force[c.efc_address] for c in data.contact if c.efc_address >= 0 and abs(c.pos[1]) < 1)
        expected += law.friction_force_at_load(load) * model.opt.timestep if load > 0 else 0
        touched += load > 0
    return changes.get("mass", GIVEN["mass"]) * (20 - data.qvel[0]) / expected - 1


def key(name, value):
    return f'<config key="{name}" value="{value}"/>'


def quoted(params):
    return params._as_text().replace('"', "'")


def changed(film=FILM, **changes):
    """The errors of a box that hops down an incline, and of an impact, against the law of the film."""
    law = asperity.Model(film)
    return slide(law, **changes), bounce(law, **changes)


SLIPPERY, MEASURED, OF_FILE = FILM.replace(work_of_adhesion=0.02), FILM.calibrated(100, 0.1), asperity.Params.from_toml(SURFACE)
HABITS = {
    "0.1 kg": dict(mass=0.1), "10 kg": dict(mass=10.0), "stiff": dict(solref="0.005 1"), "soft": dict(solref="0.05 1"),
    "springs": dict(solref="-40000 -200"), "a step of 0.5 ms": dict(timestep=0.0005), "a step of 5 ms": dict(timestep=0.005),
    "RK4": dict(integrator="RK4", timestep=0.0005), "implicit": dict(integrator="implicit"), "implicitfast": dict(integrator="implicitfast"),
    "PGS": dict(solver="PGS"), "CG": dict(solver="CG"), "impratio 1": dict(impratio=1), "another friction": dict(friction=0.01),
    "time_constant": dict(config=key("time_constant", 0.04)), "most_pairs": dict(config=key("most_pairs", 1)), "pairs": dict(config=key("pairs", "")),
    "microslip no": dict(config=key("microslip", "no")), "microslip yes": dict(config=key("microslip", "yes")),
    "microslip true": dict(config=key("microslip", "true")), "a second instance": dict(other=quoted(SLIPPERY)),
    "another surface": dict(text=quoted(SLIPPERY), film=SLIPPERY), "calibrated": dict(text=quoted(MEASURED), film=MEASURED),
    "a file": dict(text="", config=key("surface", SURFACE), film=OF_FILE),
    "a file and a text": dict(text="work_of_adhesion = 0.02", config=key("surface", SURFACE), film=OF_FILE.replace(work_of_adhesion=0.02)),
    "no surface": dict(text="", refused="must be set"), "surfase": dict(config=key("surfase", "x"), refused="surfase"),
    "pyramidal": dict(cone="pyramidal", refused='cone="elliptic"'),
    "microslip maybe": dict(config=key("microslip", "maybe"), refused="microslip = 'maybe': must be true or false"),
    "time_constant in s": dict(config=key("time_constant", "0.02 s"), refused="time_constant = '0.02 s' is not a number"),
}  # fmt: skip


def shared_incline():
    """What the step before, the line and the mean give on the incline of all hosts [m/s2]."""
    law = incline.law()
    right = incline.right_acceleration(law)
    cases = {"right": None, "the load of the step before": 1e-9, "the line": 0, "the mean": 0.02, "default": ""}
    for name, time_constant in cases.items():
        error = 0 if time_constant is None else slide(
            law, math.degrees(incline.ANGLE), text=law.params._as_text().replace('"', "'"), impratio=1, config=key("time_constant", time_constant)
        )  # fmt: skip
        print(f"  the incline of all hosts, {name}: {right * (1 + error):.3f} m/s2")


def check_floors():
    """One body that many others touch at a time has room for all of them, without `most_pairs`."""
    instance = asperity.mujoco.instance("film", FILM)
    boxes = lambda count, more="": "".join(  # noqa: E731
        f'<body pos="{0.3 * (i % 10) - 1.5} {0.3 * (i // 10) - 1.5} 0.05">{more}<freejoint/>{FLAT.format(mass=1)}</body>'
        for i in range(count)
    )
    table = '<geom type="box" size="2 2 0.1" pos="0 0 -0.1"/>'
    ours = '<plugin instance="film"/>'
    floors = {
        "20 boxes on a table": f'<body>{table}{ours}</body>{boxes(20)}',
        "90 boxes on a table": f'<body>{table}{ours}</body>{boxes(90)}',
        "a table of two geoms": f'<body>{table}{table.replace("-0.1", "-0.1001")}{ours}</body>{boxes(60)}',
        "boxes with the surface on two floors": f'{table}<geom type="plane" size="9 9 0.1"/>{boxes(40, ours)}',
        "22 bars across 22": "".join(f'<geom type="box" size="1.5 .02 .05" pos="0 {0.1 * i - 1.1} -.05"/>' for i in range(22))
        + "".join(f'<body pos="{0.1 * i - 1.1} 0 .02">{ours}<freejoint/><geom type="box" size=".02 1.5 .02"/></body>' for i in range(22)),
    }  # fmt: skip
    for name, bodies in floors.items():
        model = mujoco.MjModel.from_xml_string(
            f'<mujoco><size memory="200M"/><extension><plugin plugin="asperity.friction">{instance}</plugin></extension><option cone="elliptic"/>'
            f"<worldbody>{bodies}</worldbody></mujoco>"
        )
        data = mujoco.MjData(model)
        for _ in range(100):
            mujoco.mj_step(model, data)
        print(f"  {name}: {data.ncon} contacts, {model.npluginstate} numbers of state")


def main():
    film = asperity.Model(FILM)
    demand(film, 0.5, 150)
    first = abs(slide(film, mass=10.0))
    print(f"altered: as it comes: acceleration of 10 kg off by {first:.1e}, impulse of an impact by {bounce(film):.1e}")
    shared_incline()
    altered, impulse = habits.worst(HABITS, changed)
    impulse = np.maximum(impulse, abs(bounce(film, solref="0.005 0.2")))
    check_floors()
    lagged = abs(slide(film, mass=10.0, config=key("time_constant", 1e-9)))
    good = first <= SLIDE_LIMIT < lagged and altered <= ALTERED_SLIDE_LIMIT and impulse <= BOUNCE_LIMIT
    return good, (
        f"acceleration of a box that hops {first:.1e} (limit {SLIDE_LIMIT:g}; {lagged:.1e} at the load of the step before), {len(HABITS)} habits, "
        f"altered {altered:.1e} (limit {ALTERED_SLIDE_LIMIT:g}), impulse of an impact {impulse:.1e} (limit {BOUNCE_LIMIT:g})"
    )


if __name__ == "__main__":
    verdict.run("mujoco", main)
