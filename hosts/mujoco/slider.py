"""A ball and a box drawn over a plane in MuJoCo, with the plugin asperity.friction: friction over normal force of each
pair of geometries against the exact law, under plain mj_step and with asperity.mujoco.solve; what MuJoCo copies, saves
and restores; what the plugin refuses; what it costs. SI units.
"""

import math
import pickle
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import mujoco
import numpy as np
from mujoco import rollout

import asperity
import asperity.mujoco

sys.path.insert(0, str(Path(__file__).parents[1]))
import verdict  # noqa: E402
from surface import demand, surface  # noqa: E402

XML = Path(__file__).with_name("slider.xml").read_text(encoding="utf-8")
PLAIN_LIMIT, SOLVED_LIMIT = 1e-5, 1e-8  # that of the compiled law
BALL_SERVO, BOX_SERVO = 0.035, 0.016  # they slip slower, by the friction over kv
MASS, GRAVITY = 20, 9.81
AREAS = {"ball": 1e-4, "box": 4e-4}
SURFACE = Path(__file__).parents[1] / "surface.toml"
TEXT = '<config key="text"'
LINE = '<config key="time_constant" value="0"/>'  # the loads are smooth
SUMMITS = XML[XML.index("[roughness]") : XML.index('"/>', XML.index("[roughness]"))]
SIZE = "height_std = 9.4e-9\nsummit_radius = 1.1e-6"


def changed(changes):
    """The model with the first of each text replaced."""
    xml = XML
    for old, new in changes.items():
        if old not in xml:
            raise RuntimeError(f"slider.xml has no {old!r}")
        xml = xml.replace(old, new, 1)
    return xml


def lines(values):
    """The lines of a surface file before its hardness."""
    return "".join(f"{name} = {value!r}\n" for name, value in values.items()) + "hardness"


def measured(load, name, value):
    return lines({"calibration_load": load, name: value})


def added_load(seconds):
    """On the ball, beside its weight."""
    return 600 + 400 * math.sin(math.pi * seconds)


def forces(model, data):
    """Normal and friction force of each of the two, summed over the contacts that they have with the plane."""
    found = {name: np.zeros(2) for name in AREAS}
    for contact in data.contact:
        name = next(name for name in AREAS if model.geom(name).id in contact.geom)
        normal, *tangential = data.efc_force[contact.efc_address : contact.efc_address + 3]
        found[name] += normal, math.hypot(*tangential)
    return found


def drive(data):
    data.ctrl[:] = BALL_SERVO, BOX_SERVO
    data.qfrc_applied[2] = -added_load(data.time)


def plain_step(model, data):
    drive(data)
    mujoco.mj_step(model, data)


def solved_step(model, data):
    drive(data)
    mujoco.mj_step1(model, data)
    asperity.mujoco.solve(model, data)
    mujoco.mj_step2(model, data)


def deviation(laws, step, seconds=3.0, xml=XML, **options):
    """The greatest relative deviation of friction over normal force from the exact law, after a second to settle, that
    of the pull of the ball's servo over what the ball carries, and the least and the greatest load of each."""
    model = mujoco.MjModel.from_xml_string(xml.replace("</instance>", f"{LINE}</instance>"))
    for name, value in options.items():
        setattr(model.opt, name, value)
    data = mujoco.MjData(model)
    worst = of_servo = 0.0
    ranges = {name: (math.inf, 0.0) for name in AREAS}
    while data.time < seconds:
        begin, (vx, _, vz) = data.time, data.qvel[:3].copy()
        step(model, data)
        if begin < 1:
            continue
        if data.ncon != 5 or data.qvel[0] < 0.01 or data.qvel[3] < 0.002:
            raise RuntimeError(f"at t = {begin:g} s there are {data.ncon} contacts, not 5, or ball or box is stuck: {data.qvel}")
        for name, (normal, friction) in forces(model, data).items():
            mu = laws[name].state_at_load(normal).friction_coefficient
            worst = np.maximum(worst, abs(friction / normal / mu - 1))  # what is no number stays, as it would not in max
            ranges[name] = min(ranges[name][0], normal), max(ranges[name][1], normal)
        # The momentum of the ball, with the servo's force, knows nothing of what MuJoCo says of the contact.
        dt = model.opt.timestep
        carried = MASS * GRAVITY + added_load(begin) + MASS * (data.qvel[2] - vz) / dt
        pull = data.qfrc_actuator[0] - MASS * (data.qvel[0] - vx) / dt
        of_servo = np.maximum(of_servo, abs(pull / carried / laws["ball"].state_at_load(carried).friction_coefficient - 1))
    return worst, of_servo, ranges


def check_state(model):
    """Copied, and saved and restored, a run goes on with the same bits, with a pickled model and state too; without the plugin's
    state it does not."""
    data = mujoco.MjData(model)
    while data.time < 0.5:
        plain_step(model, data)
    copy = mujoco.MjData(model)
    mujoco.mj_copyData(copy, model, data)
    restored, forgetful = mujoco.MjData(pickle.loads(pickle.dumps(model))), mujoco.MjData(model)
    whole = int(mujoco.mjtState.mjSTATE_INTEGRATION)
    for other, part in ((restored, whole), (forgetful, whole & ~int(mujoco.mjtState.mjSTATE_PLUGIN))):
        state = np.empty(mujoco.mj_stateSize(model, part))
        mujoco.mj_getState(model, data, state, part)
        mujoco.mj_setState(model, other, pickle.loads(pickle.dumps(state)), part)
    for _ in range(50):
        for each in (data, copy, restored, forgetful):
            plain_step(model, each)
    for name, other in (("copied", copy), ("restored", restored)):
        if other.qvel.tobytes() != data.qvel.tobytes():
            raise RuntimeError(f"the {name} run goes on otherwise: {other.qvel} in place of {data.qvel}")
    if forgetful.qvel.tobytes() == data.qvel.tobytes():
        raise RuntimeError("the plugin's state plays no part")


def check_refusals():
    """Each slip of a user's, and what must stand in the message."""
    for changes, words in (
        ({'cone="elliptic"': 'cone="pyramidal"'}, ['cone="elliptic"', "carbon, 1 cm2"]),
        ({"hardness": "hardnes"}, ["carbon, 1 cm2", "line 6", "hardnes", "the nearest is hardness"]),
        ({"work_of_adhesion = 0.06": ""}, ["carbon, 1 cm2", "work_of_adhesion: must be set"]),
        ({"hardness": measured(100, "calibration_friction_coefficient", 25)}, ["line 7", "coefficient = 25", "is it a force?"]),
        ({SUMMITS: "", "hardness": f"{SIZE}\nasperity_count = 1e3\nhardness", "= 1e-4": "= 100"}, ["nominal_area in mm^2"]),
        ({TEXT: f'<config key="surface" value="missing.toml"/>{TEXT}'}, ["carbon, 1 cm2", "missing.toml"]),
        ({TEXT: f'<config key="pairs" value="ball floor"/>{TEXT}'}, ["carbon, 1 cm2", "'floor'", "geom1 geom2"]),
        ({TEXT: f'<config key="most_pairs" value="0"/>{TEXT}'}, ["carbon, 1 cm2", "most_pairs"]),
        ({TEXT: f'<config key="time_constant" value="-1"/>{TEXT}'}, ["carbon, 1 cm2", "time_constant"]),
    ):
        try:
            mujoco.MjModel.from_xml_string(changed(changes))
        except ValueError as error:
            if not all(word in str(error) for word in words):
                raise RuntimeError(f"{changes}: the message lacks one of {words}: {error}")
        else:
            raise RuntimeError(f"{changes}: taken")
    boxes = XML.replace("</worldbody>", '<body pos="0 .3 .15"><freejoint/><plugin instance="carbon, 1 cm2"/>'
                        '<geom name="upper" type="box" size=".1 .05 .05" mass="1"/></body></worldbody>')
    model = mujoco.MjModel.from_xml_string(boxes)
    try:
        mujoco.mj_step(model, mujoco.MjData(model), 5)
    except mujoco.FatalError as error:
        if not all(word in str(error) for word in ["'box'", "'upper'", '"pairs"']):
            raise RuntimeError(f"the message lacks a geom: {error}")
    else:
        raise RuntimeError("a run goes on with two surfaces for one pair")


def check_named_pair(laws):
    """A pair that is named has that friction, whatever its bodies have: here the box that of the ball's surface. One that finds no place
    has the law at its current load, which is told."""
    named = '<config key="pairs" value="plane box, ball plane"/>' + TEXT
    for more, limit in (("", PLAIN_LIMIT), ('<config key="most_pairs" value="1"/>', 0.01)):
        model = mujoco.MjModel.from_xml_string(XML.replace(TEXT, more + named, 1))
        data = mujoco.MjData(model)
        while data.time < 0.3:
            plain_step(model, data)
        normal, friction = forces(model, data)["box"]
        if not abs(friction / normal / laws["ball"].friction_at_load(normal) - 1) < limit:
            raise RuntimeError(f"{more}: the pair 'plane box' has mu = {friction / normal}")
    if 'give <config key="most_pairs" value="2"/>' not in Path("MUJOCO_LOG.TXT").read_text():
        raise RuntimeError("that pairs find no place is not told")


def check_measured_point_and_warnings(laws):
    """A point that was measured at half the ball's weight is met there, and what is not calibrated is told once in a program,
    whatever the number of runs: also if there is one summit, and if only slip radii were set."""
    program = """if True:
        import sys, mujoco
        import asperity.mujoco
        model = mujoco.MjModel.from_xml_string(sys.stdin.read())
        data = mujoco.MjData(model)
        data.ctrl[:] = 0.035, 0.016
        mujoco.mj_step(model, data, 1000)
        mujoco.mj_step(model, mujoco.MjData(model), 1000)
        contacts = [c for c in data.contact if model.geom("ball").id in c.geom]
        normal = sum(data.efc_force[c.efc_address] for c in contacts)
        print(normal, contacts[0].friction[0])
    """
    load, mu = 0.5 * MASS * GRAVITY, 0.15
    default = laws["ball"]
    given = changed({"hardness": measured(load, "calibration_friction_coefficient", mu)})
    point = asperity.Model(asperity.Params.from_text(re.search(f'{TEXT} value="([^"]*)"', given)[1]))
    one = {"height_std": 1e-6, "summit_radius": 0.02, "asperity_count": 1.0}
    moments = dict(radius_amplitude=0.0, radius_rate=0.5, summit_mean_height=0.0, rms_slope=0.0)  # set with Sq and Sdq
    radii = {"slip_radius_1": 30.0, "slip_radius_2": 9e4}
    for changes, law, said in (
        ({}, default, ["1 cm2", "4 cm2"]),
        ({"hardness": measured(load, "calibration_friction_coefficient", mu)}, point, ["4 cm2"]),
        ({"hardness": measured(load, "calibration_friction_force", mu * load)}, point, ["4 cm2"]),
        ({SUMMITS: "", "hardness": lines(one)}, asperity.Model(default.params.replace(**one, **moments)), ["1 cm2", "4 cm2"]),
        ({"hardness": lines(radii)}, asperity.Model(default.params.replace(**radii)), ["1 cm2", "4 cm2"]),
    ):
        with tempfile.TemporaryDirectory() as folder:
            command = [sys.executable, "-c", program]
            done = subprocess.run(command, input=changed(changes), check=True, capture_output=True, text=True, cwd=folder)
            log = Path(folder, "MUJOCO_LOG.TXT").read_text(encoding="utf-8")
        normal, friction = map(float, done.stdout.split()[-2:])
        if not abs(friction / law.friction_at_load(normal) - 1) < PLAIN_LIMIT:
            raise RuntimeError(f"{changes}: mu = {friction} at {normal} N, not {law.friction_at_load(normal)}")
        told = [line for line in log.splitlines() if "the strength of the interface is the default" in line]
        if sorted(line.split("cm2")[0][-2:] + "cm2" for line in told) != said:
            raise RuntimeError(f"{changes}: {said} are not calibrated, and the log must say so once of each: {log}")


def check_surface_file():
    """A surface file with what a text changes of it, a text, and what Python writes give the same bits, also if saved as XML."""
    own = XML[XML.index("<instance") : XML.index("</instance>") + len("</instance>")]
    text = own.replace("work_of_adhesion = 0.06", "work_of_adhesion = 0.05")
    of_file = f'<config key="surface" value="{SURFACE}"/><config key="text" value="work_of_adhesion = 0.05"/>'
    of_python = asperity.mujoco.instance("carbon, 1 cm2", asperity.Params.from_toml(SURFACE).replace(work_of_adhesion=0.05))
    specs = [mujoco.MjSpec.from_string(XML.replace(own, instance)) for instance in
             (text, f'<instance name="carbon, 1 cm2">{of_file}</instance>', of_python)]  # fmt: skip
    models = [spec.compile() for spec in specs]
    models += [mujoco.MjModel.from_xml_string(spec.to_xml()) for spec in specs]
    bits = set()
    for model in models:
        data = mujoco.MjData(model)
        while data.time < 0.1:
            plain_step(model, data)
        bits.add(data.qvel.tobytes())
    if len(bits) != 1:
        raise RuntimeError("a surface file, the same text and the text that Python writes do not have the same friction")


def check_built(plugins):
    """The plugins that hosts/mujoco/build.sh made for C, with the library inside, give the same bits."""
    program = """if True:
        import sys, mujoco
        mujoco.mj_loadPluginLibrary(sys.argv[1])
        model = mujoco.MjModel.from_xml_path(sys.argv[2])
        data = mujoco.MjData(model)
        data.ctrl[:] = 0.035, 0.016
        mujoco.mj_step(model, data, 500)
        print(data.qvel.tobytes().hex())
    """
    bits = set()
    for file in (asperity.mujoco.PLUGIN, *plugins):
        command = [sys.executable, "-c", program, file, str(Path(__file__).with_name("slider.xml"))]
        bits.add(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    if len(bits) != 1:
        raise RuntimeError(f"{plugins} do not give what {asperity.mujoco.PLUGIN} gives")


def cost():
    """The time of a step with a constant coefficient, and that with the law over it; both are rolled out by MuJoCo
    itself. Medians of runs that alternate."""
    constant = re.sub(r"<extension>.*</extension>|<plugin instance=.*?/>", "", XML, flags=re.DOTALL)
    constant = constant.replace("<geom ", '<geom friction="0.24" ')
    steps, inputs = 2000, mujoco.mjtState.mjSTATE_CTRL | mujoco.mjtState.mjSTATE_QFRC_APPLIED
    seconds = {"constant": [], "law": []}
    runs = {}
    for name, xml in (("constant", constant), ("law", XML)):
        model = mujoco.MjModel.from_xml_string(xml)
        data = mujoco.MjData(model)
        for _ in range(200):
            plain_step(model, data)
        kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
        state = np.empty((1, mujoco.mj_stateSize(model, kind)))
        mujoco.mj_getState(model, data, state[0], kind)
        given = np.zeros((1, steps, mujoco.mj_stateSize(model, inputs)))
        given[0, :, :2] = BALL_SERVO, BOX_SERVO
        given[0, :, 4] = [-added_load(data.time + k * model.opt.timestep) for k in range(steps)]
        runs[name] = model, data, state, given, np.empty((1, steps, state.size))
    for _ in range(11):
        for name, (model, data, state, given, out) in runs.items():
            begin = time.process_time()
            rollout.rollout(model, data, initial_state=state, control=given, control_spec=inputs, state=out)
            seconds[name].append(time.process_time() - begin)
    law, constant = (np.median(seconds[name]) for name in ("law", "constant"))
    return constant / steps, law / constant


def solved_cost():
    """The same for steps that are solved until they settle, called from Python both."""
    model = mujoco.MjModel.from_xml_string(XML)
    seconds = []
    for step in (plain_step, solved_step):
        data = mujoco.MjData(model)
        begin = time.process_time()
        while data.time < 1:
            step(model, data)
        seconds.append(time.process_time() - begin)
    return seconds[1] / seconds[0]


def main():
    laws = {name: asperity.Model(surface(area)) for name, area in AREAS.items()}
    plain, plain_servo, ranges = deviation(laws, plain_step)
    solved, solved_servo, _ = deviation(laws, solved_step)
    print(f"plain mj_step: |F/N - mu(N)|/mu {plain:.1e}, of the servo over the weight {plain_servo:.1e}")
    print(f"solved: {solved:.1e}, of the servo over the weight {solved_servo:.1e}")
    for name, (lightest, heaviest) in ranges.items():
        demand(laws[name], lightest, heaviest)
    worst = np.maximum(plain, plain_servo)
    for option, value in (
        ("integrator", mujoco.mjtIntegrator.mjINT_RK4),
        ("integrator", mujoco.mjtIntegrator.mjINT_IMPLICITFAST),
        ("solver", mujoco.mjtSolver.mjSOL_PGS),
        ("solver", mujoco.mjtSolver.mjSOL_CG),
        ("disableflags", mujoco.mjtDisableBit.mjDSBL_ISLAND),
    ):
        # Without the servo's pull: the momentum balance above is that of an explicit step.
        found = deviation(laws, plain_step, 1.3, **{option: value})[0]
        print(f"  {option} {value.name}: {found:.1e}")
        worst = np.maximum(worst, found)
    microslip = XML.replace(TEXT, '<config key="microslip" value="true"/>' + TEXT)
    found = np.max(deviation(laws, plain_step, 1.3, microslip)[:2])
    print(f"  with microslip: {found:.1e}")
    worst = np.maximum(worst, found)
    if not worst <= PLAIN_LIMIT:
        raise RuntimeError(f"under plain mj_step |F/N - mu(N)|/mu = {worst:.1e} (limit {PLAIN_LIMIT:.0e})")
    settled = np.maximum(solved, solved_servo)
    if not settled <= SOLVED_LIMIT:
        raise RuntimeError(f"solved, |F/N - mu(N)|/mu = {settled:.1e} (limit {SOLVED_LIMIT:.0e})")
    for xml in (XML, microslip):
        check_state(mujoco.MjModel.from_xml_string(xml))
    check_named_pair(laws)
    check_refusals()
    check_surface_file()
    check_measured_point_and_warnings(laws)
    check_built(sys.argv[1:])
    constant, ratio = cost()
    print(f"mujoco  cost  constant mu {1e6 * constant:.1f} us a step; the law at the expected force x {ratio:.2f}, "
          f"at the current force x {ratio * solved_cost():.2f}")
    return True, (
        f"max |F/N - mu(N)|/mu = {worst:.1e} under mj_step (limit {PLAIN_LIMIT:.0e}), "
        f"{settled:.1e} solved (limit {SOLVED_LIMIT:.0e})"
    )


if __name__ == "__main__":
    verdict.run("mujoco", main)
