"""Alters each input of the plugin once, as a user does, and runs again in the same process: what comes out must be what a fresh
process gives, to the last digit, and what is wrong must be refused and forgotten. usage: alter.py PLUGIN FOLDER
"""

import math
import multiprocessing
import os
import sys
import tempfile
from pathlib import Path

import asperity
import check
import lammps

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import verdict  # of hosts/

PLUGIN = Path(sys.argv[1]).resolve()
FILM = (Path(__file__).resolve().parent.parent / "surface.toml").read_text()
# The units of LAMMPS: of length, mass and time in a metre, a kilogram and a second.
UNITS = {"si": (1, 1, 1), "cgs": (1e2, 1e3, 1), "micro": (1e6, 1e15, 1e6), "nano": (1e9, 1e21, 1e9)}
BEADS = "modulus 5e6 real_modulus 1.7531556e9 poisson 0.38 restitution 0.4 "
WORDS = "E1 493e9 nu1 0.25 E2 493e9 nu2 0.25 m0 9.604e-17 m2 1.8e-3 work_of_adhesion 0.06 adhesion_range 0.25e-9 " \
    "burgers_vector 0.25e-9 hardness 51e9"
MOMENTS = "m0 9.604e-17 m2 1.8e-3"
CALIBRATION = "calibration_load 100 calibration_friction_coefficient 0.2"
WHOLE = 'slip_onset = "whole"\n'
CALIBRATED = "calibration_load = 100.0\ncalibration_friction_coefficient = {}\n"
FEW_LIMIT, PULL_LIMIT = 0.06, 0.03
# One file for all, written anew for each run: words, and what the file says before its film.
BASE = {"units": "si", "file": "", "style": f"asperity/hertz {BEADS} surface film.toml", "coeff": ["* *"],
        "wall": f"zplane m:-0.00499 NULL shear x m/s:0.3 {BEADS} surface film.toml"}


def words(said):
    """Style and wall with other words behind those of the grains."""
    return {name: BASE[name].replace("surface film.toml", said) for name in ("style", "wall")}


def behind(name, more):
    return {name: f"{BASE[name]} {more}"}


# What is altered: what must make no difference to the base, and what must.
SAME = {"nothing": {}, "another order of words": {"style": f"asperity/hertz surface film.toml {BEADS}"},
        "a word twice, the last counts": {"style": f"asperity/hertz modulus 1e9 {BEADS} surface film.toml"},
        "a file twice, the last counts": {"style": f"asperity/hertz {BEADS} surface missing.toml surface film.toml"},
        "pair_coeff twice": {"coeff": ["* * mu 0.3", "* *"]},
        "all words in pair_coeff": {"style": "asperity/hertz modulus 1", "coeff": [f"* * {BEADS} surface film.toml"]},
        "types one by one": {"coeff": ["1 1", "2 2", "1 2"]}, "types in another order": {"coeff": ["2 2", "2 1", "1 1"]},
        "mu replaced by a file": {"style": f"asperity/hertz {BEADS} mu 0.3", "coeff": ["* * surface film.toml"]},
        "hybrid": {"style": f"hybrid {BASE['style']}", "coeff": ["* * asperity/hertz"]},
        "hybrid, twice": {"style": f"hybrid {BASE['style']} asperity/hertz modulus 1e7",
                          "coeff": ["1 1 asperity/hertz 2 mu 0.1", "2 2 asperity/hertz 2 mu 0.1", "1 2 asperity/hertz 1"]},
        "shear behind the words": {"wall": f"zplane m:-0.00499 NULL {BEADS} surface film.toml shear x m/s:0.3"},
        "the surface in words": words(WORDS), "roughness as measured": words(WORDS.replace(MOMENTS, "Sq 9.8e-9 Sdq 0.06")),
        "roughness of a profile": words(WORDS.replace(MOMENTS, f"Rq 9.8e-9 Rdq {0.06 / 2**0.5!r}")), "what the file says, again": behind("style", "work_of_adhesion 0.06")}
SAME.update({f"units {units}": {"units": units} for units in UNITS})
UNLIKE = {f"{where}: {more}": {"coeff": [f"* * {more}"]} if where == "coeff" else behind(where, more)
          for where in ("style", "wall", "coeff")
          for more in ("modulus 1e7", "real_modulus 3e9", "poisson 0.2", "restitution 0.9", "microslip yes", "pull_off yes",
                       "work_of_adhesion 0.03", "calibration_load 100 calibration_friction_coefficient 0.3")}
UNLIKE.update({
    "mu": words("mu 0.3"), "mu in pair_coeff": {"coeff": ["* * mu 0.3"]},
    "mu in pair_coeff of one pair": {"coeff": ["* *", "1 2 mu 0.3"]},
    "mu in pair_coeff after microslip": {**behind("style", "microslip yes"), "coeff": ["* * mu 0.3"]},
    "a surface of words, calibrated": words(f"{WORDS} nominal_area 1e-4 {CALIBRATION}"),
    "another file": words("surface other.toml"),
    "another file in pair_coeff": {"coeff": ["* * surface other.toml"]}, "file: calibrated": {"file": CALIBRATED.format(0.2)},
    "file: calibrated higher": {"file": CALIBRATED.format(0.4)},
    **{f"file: calibrated, {units}": {"file": CALIBRATED.format(0.2), "units": units} for units in UNITS},
    "file: whole": {"file": WHOLE, **behind("style", "microslip yes")},
    "hybrid, the second": {"style": f"hybrid {BASE['style']} asperity/hertz modulus 1e7",
                           "coeff": ["1 1 asperity/hertz 1", "2 2 asperity/hertz 1", "1 2 asperity/hertz 2 mu 0.1"]},
    "wall: another direction": {"wall": BASE["wall"].replace("shear x", "shear y")},
    "wall: another place": {"wall": BASE["wall"].replace("0.00499", "0.004995")},
    "wall: two": {"wall": BASE["wall"].replace("zplane", "xplane").replace("NULL", "m:0.00499").replace("shear x", "shear z")},
    "wall: another plane": {"wall": BASE["wall"].replace("zplane", "xplane").replace("shear x", "shear z")}})
UNKNOWN = "no parameter has this name; the nearest is "
# What is wrong, and what must be said of it.
WRONG = {
    "moduls": (behind("style", "moduls 5e6"), f"pair_style asperity/hertz: moduls: {UNKNOWN}modulus"),
    "surfce": (behind("style", "surfce film.toml"), f"pair_style asperity/hertz: surfce: {UNKNOWN}surface"),
    "micro_slip": ({"coeff": ["* * micro_slip yes"]}, f"pair_coeff asperity/hertz: micro_slip: {UNKNOWN}microslip"),
    "sheer": ({"wall": BASE["wall"].replace("shear", "sheer")}, f"sheer: {UNKNOWN}shear"),
    "Rz": (behind("style", "Rz 1e-6"), "Rz: no parameter has this name"),
    "shear along the normal": ({"wall": BASE["wall"].replace("shear x", "shear z")}, "shear: needs a direction along the wall"),
    "shear without a speed": ({"wall": "zplane 0 NULL shear x"}, "shear: needs a direction along the wall and a speed"),
    "no plane": ({"wall": BEADS}, "must be xplane, yplane or zplane with two places"),
    "no places": ({"wall": f"zplane NULL NULL {BEADS}"}, "must be xplane, yplane or zplane with two places"),
    "no words": ({"style": "asperity/hertz"}, "pair_style asperity/hertz: modulus: must be set"),
    "no words of a wall": ({"wall": "zplane 0 NULL"}, "fix floor wall/asperity/hertz: modulus: must be set"),
    "no surface": ({"style": f"asperity/hertz {BEADS}"}, "pair_style asperity/hertz: "),
    "no pair_coeff": ({"coeff": []}, "All pair coeffs are not set"),
    "no pair_coeff of the contact": ({"coeff": ["1 1", "2 2"]}, "no pair_coeff for types 1 and 2"),
    "no file": (words("surface missing.toml"), "missing.toml: "),
    "a file with a wrong key": ({"file": "hardnes = 51e9\n"}, "film.toml: line 1: hardnes: no such key; the nearest is hardness"),
    "an empty file": ({"file": None}, "film.toml: is empty: must be a file with a surface"),
    "no value": (behind("style", "hardness"), "hardness: its value is missing"),
    "no number": (behind("style", "hardness hard"), "hardness: 'hard' is not a number"),
    "mu beside a surface": (behind("style", "mu 0.3"), "mu: stands in place of a surface"),
    "mu below 0": (words("mu -1"), "mu = -1: must be 0 or more"),
    "mu with microslip": ({"coeff": ["* * mu 0.3 microslip yes"]}, "microslip: needs a surface, not mu"),
    "pull_off with mu": ({"coeff": ["* * mu 0.3 pull_off yes"]}, "pull_off: needs a surface, not mu"),
    "pull_off without adhesion": ({"coeff": ["* * pull_off yes work_of_adhesion 0"]}, "pull_off: needs a surface with a work_of_adhesion"),
    "calibration without an area": (words(WORDS + " calibration_load 0.01 calibration_friction_coefficient 0.2"),
                                    "nominal_area: must be given with calibration_load"),
    "a file after its words": ({"coeff": ["* * hardness 50e9 surface film.toml"]},
                               "film.toml: must stand before the words that change it"),
    "half a surface": (words(WORDS.replace("m2 1.8e-3", "")), "m2: must be given"),
    "a height below 0": (words(WORDS.replace(MOMENTS, "Sq -9.8e-9 Sdq 0.06")), "Sq = -9.8e-9: must not be negative"),
    "other units": ({"units": "metal"}, "is in SI units, so 'units metal' must be si, cgs, micro or nano")}
for word, value in (("modulus", "0"), ("modulus", "inf"), ("real_modulus", "1"), ("poisson", "0.6"), ("poisson", "nan"),
                    ("restitution", "1.1"), ("restitution", "0"), ("microslip", "true"), ("pull_off", "1"), ("hardness", "-1"),
                    ("height_std", "inf")):
    WRONG[f"{word} {value}"] = ({"coeff": [f"* * {word} {value}"]}, f"pair_coeff asperity/hertz: {word}")


# What the sums of a contact are in, and those of the wall and of all contacts: in newton, metre, second.
CONTACT = ["N"] * 5 + ["Pa", "N", "N/m", ""]
SUMS = ["J"] * 4 + ["", "", "N", "N"]
WALL = ["N"] * 3 + SUMS + ["J"]


class Grains:
    """Two grains on a wall, in a process of LAMMPS that goes on from one measurement to the next."""

    def __init__(self):
        self.lammps = lammps.lammps(cmdargs=["-screen", "none", "-log", "alter.log"])
        self.lammps.command(f"plugin load {PLUGIN}")
        self.units, self.scale = None, {}
        Path("other.toml").write_text(FILM.replace("Sq = 9.8e-9", "Sq = 12e-9"))

    def say(self, text):
        """Commands, whose words of stress, length and speed are SI; they are said in the units of the script."""
        for line in text.strip().splitlines():
            said = line.split()
            for place, word in enumerate(said):
                kind, _, number = word.partition(":")
                if number and kind in self.scale:
                    said[place] = repr(float(number) * self.scale[kind])
                if word in ("modulus", "real_modulus") and place + 1 < len(said):
                    said[place + 1] = repr(float(said[place + 1]) * self.scale["Pa"])
            self.lammps.command(" ".join(said))

    def begin(self, units):
        """Grains of two types, apart."""
        m, kg, s = UNITS.get(units, UNITS["si"])
        self.units = units
        self.scale = {"m": m, "m/s": m / s, "s": s, "kg/m3": kg / m**3, "Pa": kg / m / s**2, "N": kg * m / s**2, "N/m": kg / s**2,
                      "J": kg * m**2 / s**2, "": 1}
        self.say(f"""clear
            units {units}
            atom_style sphere
            boundary f f f
            comm_modify vel yes
            region box block m:-0.04 m:0.04 m:-0.04 m:0.04 m:-0.04 m:0.04
            create_box 2 box
            create_atoms 1 single 0 0 0
            create_atoms 2 single 0 0 m:0.02
            group lower id 1
            group upper id 2
            set type 1 diameter m:0.01
            set type 2 diameter m:0.006
            set group all density kg/m3:1190
            velocity lower set 0 0 m/s:-0.001
            neighbor m:0.001 bin
            timestep s:1e-6""")

    def measure(self, altered, restarted=False):
        """What contact and wall feel before they slip, when they do, and at the first step of the next run, in SI units."""
        made = {**BASE, **altered}
        Path("film.toml").write_text("" if made["file"] is None else made["file"] + FILM)
        if self.units != made["units"]:
            self.begin(made["units"])
        self.say("thermo_style one")
        for kind, name in (("fix", "hold"), ("fix", "floor"), ("compute", "sums"), ("compute", "force"), ("compute", "contact")):
            if self.lammps.has_id(kind, name):
                self.say(f"un{kind} {name}")
        if not restarted:
            self.say(f"pair_style {made['style']}")
            for coeff in made["coeff"]:
                self.say(f"pair_coeff {coeff}")
        # Apart, where contacts forget, and together again.
        self.say(f"""fix floor all wall/asperity/hertz {made["wall"]}
            reset_timestep 0
            set atom 2 x 0 y 0 z m:0.02
            run 0
            set atom 2 x 0 y 0 z m:0.00799
            fix hold upper move linear m/s:0.05 0 0
            compute contact all pair/local p1 p2 p3 p4 p5 p6 p7 p8 p9
            compute force all reduce sum c_contact[*] inputs local""")
        units, names = CONTACT + WALL, [f"c_force[{k}]" for k in range(1, 10)] + [f"f_floor[{k}]" for k in range(1, 13)]
        if not made["style"].startswith("hybrid"):
            self.say("compute sums all pair asperity/hertz")
            units, names = units + SUMS, names + [f"c_sums[{k}]" for k in range(1, 9)]
        self.say(f"thermo_style custom step {' '.join(names)}")
        rows = []
        for steps in (5, 145, 0):
            self.say(f"run {steps}")
            values = self.lammps.last_thermo()
            rows.append([values[name] / self.scale[unit] for name, unit in zip(names, units)])
        return rows

    def rebound(self, restitution, speed, wall, law="mu 0"):
        """The speed after an impact over the one before, of two grains or of one and a wall."""
        self.begin("si")
        words = f"asperity/hertz {BEADS} restitution {restitution} {law}"
        self.say(f"pair_style {words}\npair_coeff * *\nfix move all nve/sphere\ntimestep {2e-7 * speed**-0.2}")
        if wall:
            self.say(f"fix floor all wall/{words.replace('hertz', 'hertz zplane -0.0051 NULL')}")
        self.say(f"set atom 2 x 0 y 0 z {0.02 if wall else 0.00801}\nvelocity all set 0 0 0\n"
                 f"velocity {'lower' if wall else 'upper'} set 0 0 {-speed}\nthermo_style custom step\nrun 0")
        speeds = lambda: self.lammps.numpy.extract_atom("v")[:, 2]  # noqa: E731
        relative = lambda: speeds()[0] if wall else speeds()[1] - speeds()[0]  # noqa: E731
        for _ in range(50):
            self.say("run 2000")
            if relative() > 0 and self.lammps.numpy.extract_atom("f")[0, 2] == 0:
                return relative() / speed
        raise RuntimeError(f"restitution {restitution}: the grains do not part")

    def bead(self, diameter, overlap, words):
        """Load and largest friction of two alike grains at rest."""
        self.begin("si")
        self.say(f"""set group all diameter {diameter}
            set atom 2 x 0 y 0 z {diameter - overlap!r}
            pair_style asperity/hertz modulus 40e9 surface film.toml {words}
            pair_coeff * *
            compute contact all pair/local p5 p7
            compute force all reduce sum c_contact[*] inputs local
            thermo_style custom step c_force[*] pe
            log bead.log
            run 0
            log none""")
        values = self.lammps.last_thermo()
        return values["c_force[1]"], values["c_force[2]"]

    def refused(self, altered):
        """The message with which LAMMPS refuses what is wrong."""
        try:
            self.measure(altered)
        except Exception as error:  # LAMMPS' own, which is a plain Exception
            return str(error)
        return "nothing"


def fresh(altered):
    """The same in a process of its own, and in a folder of its own."""
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        return Grains().measure(altered)


def apart(one, other):
    """The largest relative difference of what two measurements found."""
    return max(abs(a - b) / max(abs(a), abs(b), 1e-30) for row, same in zip(one, other) for a, b in zip(row, same))


def limit_error(rows, file):
    """The error of the largest friction, against exact states."""
    Path("exact.toml").write_text(file + FILM)
    model = asperity.Model(asperity.Params.from_toml("exact.toml"))
    load, limit, nominal = rows[-1][4], rows[-1][6], model.params.nominal_area
    area = check.area_of(model, load, 0.005 * 0.003 / 0.008)
    return abs(limit / (area / nominal * model.state_at_load(load / area * nominal).friction_force) - 1)


# Surfaces of beads, and the overlaps at which they touch on .001 to 30 summits.
GLASS = """nominal_area = 1e-6
work_of_adhesion = {}
[materials]
first = "glass"
second = "glass"
[roughness]
Sq = {}
Sdq = {}
"""
BEADS_OF_FEW = ((GLASS.format(0, 1.4e-7, 0.3), 1e-3), (GLASS.format(0, 3e-7, 0.1), 4e-3), (GLASS.format(0.05, 1e-8, 0.2), 4e-4), (FILM, 2e-3))


def few_summits(ball, claim):
    """Friction of contacts on few summits against single specimens of the library, and the pull-off force of rough spheres."""
    for text, diameter in BEADS_OF_FEW:
        Path("film.toml").write_text(text)
        params, radius = asperity.Params.from_text(text), diameter / 4
        density = params.asperity_count / params.nominal_area
        for overlap in (1e-4, 1e-3, 1e-2, 0.1, 1):
            load, limit = ball.bead(diameter, overlap * params.height_std, "")
            area = math.pi * ((0.75 * load * radius / 40e9) ** (2 / 3) + 1.5 * params.height_std / 0.92 * radius)
            count = round(density * area)
            single = asperity.pads(params.replace(asperity_count=count, nominal_area=count / density), [load], 400)
            name = f"{text.splitlines()[1]}, {count} summits, {single.contacting.mean():.3g} in contact"
            claim(name, abs(limit / single.mean_force[0] - 1) < FEW_LIMIT, f"friction over that of specimens is {limit / single.mean_force[0]:.4f}")
            few = asperity.Model(params).state_at_load(load / area * params.nominal_area).contacting * area / params.nominal_area < 20
            claim(name, ("touch on fewer than 20 asperities" in Path("bead.log").read_text()) == few, "few summits are told wrongly")
        if params.work_of_adhesion == 0:
            continue
        sphere = asperity.pads(params, [0.0], 400, sphere_radius=radius).pull_off_force.mean()
        pulled = ball.bead(diameter, overlap * params.height_std, "")[0] - ball.bead(diameter, overlap * params.height_std, "pull_off yes")[0]
        claim(text.splitlines()[1], abs(pulled / sphere - 1) < PULL_LIMIT, f"pull-off force over that of spheres is {pulled / sphere:.3f}")
    tiny = ball.bead(1e-6, 1e-10, "")[0] - ball.bead(1e-6, 1e-10, "pull_off yes")[0]
    claim("one smooth hill", 0.5 < tiny / (2 * math.pi * 0.06 * 0.25e-6) <= 1, f"has {tiny} N of pull-off")


def main(folder):
    altered = {**SAME, **UNLIKE}
    with multiprocessing.get_context("fork").Pool(2, maxtasksperchild=1) as pool:
        alone = dict(zip(altered, pool.map(fresh, altered.values(), chunksize=1)))
    os.makedirs(folder, exist_ok=True)
    os.chdir(folder)
    grains, base, wrong = Grains(), alone["nothing"], []

    def claim(name, holds, what):
        if not holds:
            wrong.append(f"{name}: {what}")

    for name, change in altered.items():
        claim(name, grains.measure(change) == alone[name], "not what a fresh process gives")
        claim(name, grains.measure({}) == base, "is not forgotten")
    for name, (change, says) in WRONG.items():
        message = grains.refused(change)
        claim(name, says in message, f"is not refused with '{says}', but: {message}")
        claim(name, grains.measure({}) == base, "is not forgotten")
    grains.say("comm_modify vel no")
    claim("no speeds of ghosts", "say 'comm_modify vel yes'" in grains.refused({}), "is not refused")
    grains.say("comm_modify vel yes")
    for name, rows in alone.items():
        off = apart(rows, base)
        claim(name, off < 1e-9 if name in SAME else off > 1e-6, f"is off the base by {off:.1e}")
        # Work is counted from the beginning of a run; all else is as at the step before.
        last, first = ([value for value, unit in zip(row, CONTACT + WALL + SUMS) if unit != "J"] for row in rows[1:])
        claim(name, apart([first], [last]) < 1e-12, "the first step of a run is not as the step before")
    for name in ("nothing", "file: calibrated", "file: calibrated higher", "file: whole", *(f"file: calibrated, {units}" for units in UNITS)):
        error = limit_error(alone[name], altered[name].get("file", ""))
        claim(name, error < check.LAW_LIMIT, f"friction is off the law by {error:.1e}")
    claim("mu", abs(alone["mu"][-1][6] / alone["mu"][-1][4] - 0.3) < 1e-12, "is not the coefficient")
    ball = Grains()
    for restitution in (0.05, 0.1, 0.3, 0.5, 0.7, 0.9, 1.0):
        for speed, wall in ((0.01, False), (1.0, False), (1.0, True)):
            found = ball.rebound(restitution, speed, wall)
            claim(f"restitution {restitution} at {speed} m/s", abs(found / restitution - 1) < 2e-3, f"is {found:.4f}")
    # Where damping takes all of the load while they still overlap, nothing touches.
    Path("film.toml").write_text(GLASS.format(0, 1e-7, 0.1))
    for wall, law in ((wall, law) for wall in (False, True) for law in ("surface film.toml", "surface film.toml microslip yes")):
        found = ball.rebound(0.5, 1.0, wall, law)
        claim(f"{law}, without adhesion", abs(found / 0.5 - 1) < 2e-3, f"restitution is {found:.4f}")
    few_summits(ball, claim)
    # A restart file brings back the words. What they name is read anew, and a surface that is not as it was is told.
    grains.say("write_restart grains.restart")
    for name in ("nothing", "file: calibrated"):
        Path("film.toml").write_text(altered[name].get("file", "") + FILM)
        grains.say(f"""log restart.log
            thermo_modify warn reset
            clear
            comm_modify vel yes
            read_restart grains.restart
            neighbor m:0.001 bin
            log none""")
        told = "is not as it was when the restart file was written" in Path("restart.log").read_text()
        claim(name, told == (name != "nothing"), "after a restart it is told wrongly whether the surface is as it was")
        contact, same = ([row[:9] for row in rows] for rows in (grains.measure(altered[name], restarted=True), alone[name]))
        claim(name, apart(contact, same) < 1e-9, "is not the same after a restart")
    # In another folder, where the surface file is not, the law that the restart file keeps goes on.
    os.makedirs("elsewhere", exist_ok=True)
    os.chdir("elsewhere")
    Path("film.toml").unlink(missing_ok=True)
    grains.say(f"""log restart.log
        clear
        comm_modify vel yes
        read_restart ../grains.restart
        neighbor m:0.001 bin
        log none""")
    told = "film.toml: " in (log := Path("restart.log").read_text()) and "have the law that the restart file keeps" in log
    claim("elsewhere", told, "a missing surface file is not told")
    contact, same = ([row[:9] for row in rows] for rows in (grains.measure({}, restarted=True), base))
    claim("elsewhere", apart(contact, same) < 1e-9, "is not the same after a restart")
    same = f"{len(altered)} alterations in one process as each in a fresh one, {len(WRONG)} refused"
    return not wrong, "\n  ".join([same, *wrong])


if __name__ == "__main__":
    verdict.run("lammps", main, sys.argv[2])
