"""A block on a base in CalculiX, with the contact that `python -m asperity export` writes: pressed, dragged and heated, against
the exact states of the law. Then each input is changed once. usage: block.py FOLDER
"""

import contextlib
import io
import subprocess
import sys
from pathlib import Path

import asperity.__main__
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import habits  # of hosts/
import surface
import verdict

TOLERANCE = 1e-3  # of the tables
LIMIT = 2e-3
FACES = 3
# In CalculiX 2.20 a table of overclosure works with nodes on surfaces only, and conductance by pressure with surfaces on surfaces
# and linear overclosure. In SI: edge and height of the block, conductivity of both bodies, warmth of the block's upper face.
EDGE, HEIGHT, CONDUCTIVITY, WARMTH = 10e-3, 1e-3, 50.0, 10.0
BASE = {"surface": "", "load": 8e6, "length": 1e-3, "pressure": 1e6}
ALTERED = {
    "m, Pa": {"length": 1.0, "pressure": 1.0},
    "mm, Pa": {"pressure": 1.0},
    "a tenth of the load": {"load": 0.8e6},
    "four times the load": {"load": 32e6},
    "a rougher surface": {"surface": "Sq = 20e-9"},
    "a calibrated surface": {"surface": "calibration_load = 100\ncalibration_friction_coefficient = 0.3"},
}


def altered_film(words):
    """The surface of all hosts, with other words in place of its own or before them."""
    film, key = surface.SURFACE.read_text(), words.split(" ")[0]
    lines = [words if line.startswith(f"{key} =") else line for line in film.splitlines()]
    return "\n".join(lines if words in lines else [words, *lines]) + "\n"


def body(name, first, half, low, high, length):
    """Nodes and elements of a layer of FACES x FACES bricks: the nodes of its lower side, and as many above."""
    side = np.linspace(-half, half, FACES + 1) / length
    count = len(side) ** 2
    lines = []
    for k, (plane, z) in enumerate((("LOWER", low), ("UPPER", high))):
        lines.append(f"*NODE, NSET={name}{plane}")
        lines += [f"{first + k * count + m}, {x:.10g}, {y:.10g}, {z / length:.10g}" for m, (y, x) in
                  enumerate((float(y), float(x)) for y in side for x in side)]
    lines.append(f"*ELEMENT, TYPE=C3D8, ELSET={name}")
    for m in (row * len(side) + column for row in range(FACES) for column in range(FACES)):
        corners = [first + m + offset for offset in (0, 1, len(side) + 1, len(side))]
        lines.append(f"{first + m}, {', '.join(str(c) for c in corners + [c + count for c in corners])}")
    return "\n".join([*lines, f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL"])


def deck(case, slip):
    """Pressed in the first step; dragged in the second to half of the elastic slip, and in the third to three times."""
    length, pressure = case["length"], case["pressure"]
    pressed = f"*DLOAD\nBLOCK, P2, {case['load'] / pressure:.10g}\n*NODE PRINT, NSET=BLOCKLOWER, FREQUENCY=1000\nU\n"
    dragged = "".join(
        f"""*END STEP
*STEP, INC=1000
*STATIC
0.1, 1., , 0.1
*BOUNDARY
BLOCKLOWER, 1, 1, {share * slip / length:.10g}
BLOCKUPPER, 1, 1, {share * slip / length:.10g}
*NODE PRINT, NSET=BLOCKLOWER, TOTALS=ONLY, FREQUENCY=1000
RF
""" for share in (0.5, 3))
    bodies = f"""{body("BLOCK", 1, EDGE / 2, 0.0, HEIGHT, length)}
{body("BASE", 101, EDGE, -HEIGHT, 0.0, length)}
*MATERIAL, NAME=STEEL
*ELASTIC
{200e9 / pressure:.10g}, 0.
*CONDUCTIVITY
{CONDUCTIVITY / pressure / length**2:.10g}
*SURFACE, NAME=SLIDER
BLOCK, S1
*SURFACE, NAME=TABLE
BASE, S2
*SURFACE INTERACTION, NAME=ROUGH
*INCLUDE, INPUT={{name}}.contact
*CONTACT PAIR, INTERACTION=ROUGH, TYPE={{type}} TO SURFACE
SLIDER, TABLE
*BOUNDARY
BASELOWER, 1, 3
BASEUPPER, 1, 3
BLOCKLOWER, 1, 2
BLOCKUPPER, 1, 2
"""
    heated = f"""*INITIAL CONDITIONS, TYPE=TEMPERATURE
ALL, 0.
*STEP, INC=1000, NLGEOM
*COUPLED TEMPERATURE-DISPLACEMENT, STEADY STATE
0.1, 1., , 0.1
*BOUNDARY
BASEUPPER, 11, 11, 0.
BLOCKUPPER, 11, 11, {WARMTH}
{pressed}*NODE PRINT, NSET=BLOCKUPPER, TOTALS=ONLY, FREQUENCY=1000
RFL
*END STEP
"""
    everything = "*NSET, NSET=ALL\nBLOCKLOWER, BLOCKUPPER, BASELOWER, BASEUPPER\n"
    return {
        "dragged": bodies.format(name="dragged", type="NODE")
        + f"*STEP, INC=1000\n*STATIC\n0.1, 1., , 0.1\n{pressed}{dragged}*END STEP\n",
        "heated": bodies.format(name="heated", type="SURFACE") + everything + heated,
    }


def computed(folder, name, text):
    """What CalculiX printed, by headline: rows of numbers."""
    (folder / f"{name}.inp").write_text(text)
    (folder / f"{name}.dat").unlink(missing_ok=True)
    done = subprocess.run(["ccx", "-i", name], cwd=folder, capture_output=True, text=True, check=False)
    said = done.stdout + done.stderr
    if done.returncode != 0 or "*ERROR" in said or "best solution" in said:
        raise RuntimeError(f"{folder / name}.inp: ccx ended with status {done.returncode}: {said[-400:]}")
    printed = []
    for line in (folder / f"{name}.dat").read_text().splitlines():
        words = line.split()
        if words and words[0][0].isalpha():
            printed.append([])
        elif words:
            printed[-1].append([float(word) for word in words])
    return printed


def errors(folder, case):
    """The errors of overclosure, stick, friction and heat, relative to what the law says."""
    folder.mkdir(parents=True, exist_ok=True)
    film = folder / "film.toml"
    film.write_text(altered_film(case["surface"]))
    load, length, pressure = case["load"], case["length"], case["pressure"]
    options = ["--range", f"{load / 8 / pressure!r}:{load * 8 / pressure!r}", "--tolerance", f"{TOLERANCE}", "--pressure-unit", f"{pressure!r}",
               "--length-unit", f"{length!r}"]
    for name, more in (("dragged", []), ("heated", ["--conductivity", f"{CONDUCTIVITY}"])):
        to = ["--format", "calculix", "-o", str(folder / f"{name}.contact")]
        if asperity.__main__.main(["export", str(film), *to, *options, *more]) != 0:
            raise RuntimeError("no table is exported")
    with asperity.Model(asperity.Params.from_toml(film)) as model:
        area = model.params.nominal_area
        lightest, state = (model.state_at_load(p * area) for p in (load / 8, load))
        zero = lightest.gap - load / 8 * area / lightest.dload_dgap
        slip = state.friction_force / state.tangential_stiffness
        conductance = 2 * CONDUCTIVITY * state.contact_radius_sum / area
    decks = deck(case, slip)
    lower, stick, friction = computed(folder, "dragged", decks["dragged"])
    flux = computed(folder, "heated", decks["heated"])[-1][0][0]
    newton, side = pressure * length**2, EDGE**2
    # In series: the block and the contact; the base's upper face is held at 0.
    heat = WARMTH * side / (HEIGHT / CONDUCTIVITY + 1 / conductance)
    expected = state.friction_coefficient * load * side
    return np.array([
        np.max(np.abs(np.array(lower)[:, 3] * length / (state.gap - zero) - 1)), abs(stick[0][0] * newton / (0.5 * expected) - 1),
        abs(friction[0][0] * newton / expected - 1), abs(flux * newton * length / heat - 1)])


def loose_deck(push, slip):
    """Bodies of steel with a Poisson's ratio whose sides are free, so that edges carry more than the middle: pushed together by the
    upper face, then dragged far beyond slip. In N and mm."""
    return f"""{body("BLOCK", 1, EDGE / 2, 0.0, HEIGHT, 1e-3)}
{body("BASE", 101, EDGE, -HEIGHT, 0.0, 1e-3)}
*MATERIAL, NAME=STEEL
*ELASTIC
210000., 0.3
*SURFACE, NAME=SLIDER
BLOCK, S1
*SURFACE, NAME=TABLE
BASE, S2
*SURFACE INTERACTION, NAME=ROUGH
*INCLUDE, INPUT=loose.contact
*CONTACT PAIR, INTERACTION=ROUGH, TYPE=NODE TO SURFACE
SLIDER, TABLE
*BOUNDARY
BASELOWER, 1, 3
BLOCKUPPER, 1, 2
*STEP, INC=1000
*STATIC
0.1, 1., , 0.1
*BOUNDARY
BLOCKUPPER, 3, 3, {-push}
*END STEP
*STEP, INC=1000
*STATIC
0.1, 1., , 0.1
*BOUNDARY
BLOCKUPPER, 1, 1, {slip}
*NODE PRINT, NSET=BASELOWER, TOTALS=ONLY, FREQUENCY=1000
RF
*END STEP
"""


def loose_friction(folder, options, push=4.4e-4):
    """Friction over load of the loose bodies and the mean pressure [MPa]."""
    folder.mkdir(parents=True, exist_ok=True)
    command = ["export", str(surface.SURFACE), "--format", "calculix", "-o", str(folder / "loose.contact"), "--pressure-unit", "1e6"]
    if asperity.__main__.main([*command, "--length-unit", "1e-3", *options]) != 0:
        raise RuntimeError("no table is exported")
    (force,) = computed(folder, "loose", loose_deck(push, 10 * push))[0]
    return abs(force[0] / force[2]), abs(force[2]) / EDGE**2 / 1e6


def loose(folder):
    """The coefficient of --friction-at, whatever the range: also one that edges go beyond. Its error, and the pressures."""
    worst, pressures = 0.0, []
    with asperity.Model(surface.surface(EDGE**2)) as model:
        for number, range_ in enumerate(("1:64", "20:64", "1:640", "0.1:60")):
            found, pressure = loose_friction(folder / f"loose{number}", ["--range", range_, "--friction-at", "58"])
            right = model.state_at_load(58e6 * EDGE**2).friction_coefficient
            worst = np.maximum(worst, abs(found / right - 1))
            pressures.append(pressure)
    print(f"  loose bodies under {min(pressures):.1f} to {max(pressures):.1f} MPa: friction is off by {worst:.1e} in four ranges")
    return worst


PAGE = Path(__file__).resolve().parents[2] / "docs" / "joint.md"
# Of the page: more lines of the surface, options beside its own, factors of lengths, stresses and the load, and words of a refusal.
JOINTS = {
    "m, Pa": {"length": 1e-3, "stress": 1e6},
    "twice the load": {"load": 2.0, "options": ["--range", "2:60"]},
    "a tightened joint": {"options": ["--unloaded-from", "50"]},
    "a wavy face": {"surface": 'waviness_height = 1e-6\nwaviness_width = 4e-3\nwaviness_shape = "hills"\n'},
    "waves without a shape": {"surface": "waviness_height = 1e-6\nwaviness_width = 4e-3\n", "refused": "measure the waves along two directions"},
    "waves in um": {"surface": 'waviness_height = 1\nwaviness_width = 4e-3\nwaviness_shape = "hills"\n', "refused": "are both in one unit?"},
    "the range in the other order": {"options": ["--range", "50:2"], "refused": "range"},
    "the range in Pa": {"options": ["--range", "2e6:5e7"], "refused": "range"},
}


def joint_deck(text, length=1.0, stress=1.0, load=1.0):
    """The deck of the page with its numbers in other units, and another load."""
    scaled = []
    for line in text.splitlines():
        words = line.split(", ")
        if not line.startswith("*") and len(words) == 4 and words[0].isdigit():
            line = ", ".join([words[0], *(f"{float(word) * length:.10g}" for word in words[1:])])
        elif words[0] in ("BLOCK", "205000") and words[1] in ("P2", "0"):
            line = f"BLOCK, P2, {float(words[2]) * stress * load:.10g}" if words[1] == "P2" else f"{205000 * stress:.10g}, 0"
        scaled.append(line)
    return "\n".join(scaled) + "\n"


def joint(folder, surface="", options=(), length=1.0, stress=1.0, load=1.0):
    """The errors of overclosure of the joint of docs/joint.md, relative to the law."""
    folder.mkdir(parents=True, exist_ok=True)
    page = PAGE.read_text()
    film, contact = folder / "joint.toml", folder / "joint.contact"
    film.write_text(surface + page.split("```toml\n")[1].split("```")[0])
    command = next(line for line in page.splitlines() if "--format calculix" in line).split()[3:]
    command[command.index("joint.toml")], command[command.index("joint.contact")] = str(film), str(contact)
    units = ["--pressure-unit", f"{1e6 / stress!r}", "--length-unit", f"{1e-3 / length!r}"]
    if "--range" not in options and stress != 1.0:
        units += ["--range", f"{2 * stress!r}:{50 * stress!r}", "--friction-at", f"{25 * stress!r}"]
    with contextlib.redirect_stderr(io.StringIO()) as told:
        try:
            status = asperity.__main__.main([*command, *units, *options])
        except SystemExit as stopped:
            status = stopped.code
    if status != 0:
        raise RuntimeError(told.getvalue())
    printed = computed(folder, "joint", joint_deck(page.split("```text joint.inp\n")[1].split("```")[0], length, stress, load))
    with asperity.Model(asperity.Params.from_toml(film)) as first:
        law = first.unloaded(50e6 * first.params.nominal_area) if "--unloaded-from" in options else first
        area = law.params.nominal_area
        lightest = law.state_at_load(2e6 * area)
        zero = lightest.gap - 2e6 * area / lightest.dload_dgap
        closures = [law.state_at_load(load * p * 1e6 * area).gap - zero for p in (24.5, 25.5)]
    return [abs(rows[0][3] * 1e-3 / length / closure - 1) for rows, closure in zip(printed, closures)]


def main(folder):
    worst = max(loose(folder), *habits.worst(JOINTS, lambda **change: joint(folder / "joint", **change)))
    print("  errors of overclosure, stick, friction and heat:")
    worst = np.max([worst, *habits.worst(ALTERED, lambda **change: errors(folder / "block", {**BASE, **change}))])
    return worst <= LIMIT, f"{len(ALTERED)} blocks pressed, dragged and heated, four loose ones and the joint of docs/joint.md, within {worst:.1e} of the law (limit {LIMIT:.0e})"


if __name__ == "__main__":
    verdict.run("calculix", main, Path(sys.argv[1]))
