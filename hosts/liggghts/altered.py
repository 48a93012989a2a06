"""Two grains in LIGGGHTS, or one on a wall, of which one is moved across the other and back: friction at every step against exact
states, with each input changed once, and the restitution of an impact. usage: altered.py PLUGIN FOLDER
"""

import math
import os
import re
import subprocess
import sys
from pathlib import Path

import asperity
import numpy as np

HOSTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(HOSTS), str(HOSTS / "lammps")]
import check  # of hosts/lammps
import habits  # of hosts/
import surface
import verdict

PLUGIN, FOLDER = (Path(argument).resolve() for argument in sys.argv[1:])
LIMIT, RESTITUTION_LIMIT = 1e-6, 2e-3
UNITS = {"si": (1, 1, 1), "cgs": (1e2, 1e3, 1), "micro": (1e6, 1e15, 1e6), "nano": (1e9, 1e21, 1e9)}  # of 1 m, kg and s
STEPS, OVERLAP, DENSITY = 200, 2e-5, 1190
SOFT = 8.556e6  # Young's modulus that grains are computed with
TEXT = surface.SURFACE.read_text()
SURFACES = {"film": TEXT, "rougher": TEXT.replace("Sq = 9.8e-9", "Sq = 12e-9"),
            "elsewhere": 'interface_kind = "film"\n' + re.sub("slip_stress", "# ", TEXT), "whole": 'slip_onset = "whole"\n' + TEXT,
            "dry": re.sub("work_of_adhesion = .*", "work_of_adhesion = 0", TEXT),
            "calibrated": "calibration_load = 100\ncalibration_friction_coefficient = 0.16\n" + TEXT}  # fmt: skip
HABITS = {
    **{name: dict(units=name) for name in UNITS if name != "si"}, "half the step": dict(step=5e-7), "unequal grains": dict(size=(0.01, 0.007)),
    "harder grains": dict(young=(2 * SOFT, 2 * SOFT)), "unlike grains": dict(young=(SOFT, 5 * SOFT), poisson=(0.3, 0.2)),
    "the other first": dict(first=2), "a deeper contact": dict(overlap=1e-4), "a wall": dict(wall=True), "two ranks": dict(ranks=2),
    "rolling friction": dict(style="rolling_friction epsd2"), "restart elsewhere": dict(restart=True), "another surface": dict(law="rougher"),
    "calibrated": dict(law="calibrated"), "an interface": dict(law="elsewhere"), "no partial slip": dict(law="whole"), "of a pair": dict(others="mu 0.2"), "mu": dict(law="mu 0.3"),
    "a wrong word": dict(more="hardnes 1e9", refused="hardness"), "no surface": dict(law="", refused="must be set"),
    "microslip": dict(more="microslip yes", refused="microslip"),
}  # fmt: skip
IMPACTS = [dict(restitution=e, speed=speed, wall=wall) for e in (0.1, 0.4, 0.9, 1.0) for speed, wall in ((1.0, False), (0.01, True))]
# Where damping takes all of the load while they still overlap, nothing touches.
IMPACTS += [dict(restitution=0.5, speed=1.0, wall=wall, law="dry") for wall in (False, True)]


def liggghts(script, folder, ranks=1):
    """What a script printed, and its log; in a folder of its own."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "in.script").write_text("\n".join(script) + "\n")
    ranked = ["mpirun", "--oversubscribe", "-n", str(ranks)] if ranks > 1 else []
    command = [*ranked, "env", f"LD_PRELOAD={PLUGIN}", "liggghts", "-in", "in.script"]
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", timeout=300,
                         env={**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"})  # fmt: skip
    if run.returncode or "ERROR" in run.stdout + run.stderr:
        raise RuntimeError(" ".join(line for line in (run.stdout + run.stderr).splitlines() if "ERROR" in line) or run.stderr[-500:])
    return run.stdout, (folder / "log.liggghts").read_text()


def rows(text):
    """The numbers of all tables, one after the other."""
    lines = [line.split() for line in text.splitlines()]
    return np.array([[float(word) for word in words] for words in lines if len(words) == 5 and re.fullmatch(r"[-+.\de]+", "".join(words))])


def script(units="si", size=(0.01, 0.01), young=(SOFT, SOFT), poisson=(0.38, 0.38), gap=0.0, step=1e-6, first=1, wall=False, style="",
           restitution=1.0, law="film", more="", others=""):  # fmt: skip
    """Grains one above the other, the lower one of type 1, or a wall; all numbers in SI. Their part of a script, and that after it or a
    restart file."""
    m, kg, s = UNITS[units]
    always = "atom_style granular\natom_modify map array\nnewton off\ncommunicate single vel yes"
    height = (size[1] if wall else sum(size)) / 2 + gap
    grains = [f"create_atoms {kind} single 0 0 {z * m!r} units box" for kind, z in ((1, 0.0), (2, height)) if not (wall and kind == 1)]
    box = f"{-0.04 * m!r} {0.04 * m!r}"
    words = f"surface ../{law}.toml" if law in SURFACES else law
    style = f"model asperity {style}"

    def each(values):
        return " ".join(repr(float(value)) for value in values)

    return [f"units {units}", always, "boundary f f f", f"region box block {box} {box} {box} units box", "create_box 2 box",
            *grains[:: 1 if first == 1 else -1],
            *(f"set type {kind} diameter {size[kind - 1] * m!r} density {DENSITY * kg / m**3!r}" for kind in (1, 2))], [always], f"""
        neighbor {0.001 * m!r} bin
        group lower type 1
        group upper type 2
        timestep {step * s!r}
        variable asperity string "{others or words} real_modulus {check.REAL_MODULUS * kg / m / s**2!r} {more}"
        {f'variable asperity_1_2 string "{words}"' if others else ""}
        fix p1 all property/global youngsModulus peratomtype {each(value * kg / m / s**2 for value in young)}
        fix p2 all property/global poissonsRatio peratomtype {each(poisson)}
        fix p3 all property/global coefficientRestitution peratomtypepair 2 {each([restitution] * 4)}
        fix p4 all property/global coefficientRollingFriction peratomtypepair 2 {each([0.1] * 4)}
        fix p5 all property/global coefficientRollingViscousDamping peratomtypepair 2 {each([0.1] * 4)}
        pair_style gran {style}
        pair_coeff * *
        {f"fix floor all wall/gran {style} primitive type 1 zplane 0" if wall else ""}
        compute force upper reduce sum fx fz
        compute place upper reduce sum x vz
        thermo_style custom step c_place[1] c_place[2] c_force[1] c_force[2]
        thermo_modify format float %.17g norm no
        thermo 1"""


def moved(overlap=OVERLAP, ranks=1, restart=False, **change):
    """The largest error of friction and load of a grain that is moved there and back, over the limit of friction."""
    made = {**dict(units="si", step=1e-6, law="film", wall=False, size=(0.01, 0.01), young=(SOFT, SOFT), poisson=(0.38, 0.38)), **change}
    m, kg, s = UNITS[made["units"]]
    begin, again, laws = script(gap=-overlap, **change)
    there, back = (f"fix {name} upper move linear {sign * 0.8 * overlap / STEPS / made['step'] * m / s!r} 0 0\nrun {STEPS}" for name, sign in (("there", 1), ("back", -1)))
    if restart:
        printed, log = liggghts([*begin, laws, there, "write_restart ../half"], FOLDER / "one")
        log += liggghts([*again, "read_restart ../half", laws, back], FOLDER / "two")[1]
    else:
        printed, log = liggghts([*begin, laws, there, "unfix there", back], FOLDER / "one", ranks)
    table = rows(log) / [1, m, m / s, kg * m / s**2, kg * m / s**2]
    if len(table) != 2 * STEPS + 2:
        raise RuntimeError(f"{len(table)} rows of a table: not the run that was meant")
    lower, upper = (size / 2 for size in made["size"])
    first, second = ((1 - nu**2) / young for nu, young in zip(made["poisson"], made["young"]))
    shear = sum(2 * (2 - nu) * (1 + nu) / young for nu, young in zip(made["poisson"], made["young"]))  # 1/G* of Mindlin
    ratio = 4 * (first + second) / shear
    radius, apart = (upper, upper) if made["wall"] else (lower * upper / (lower + upper), upper + lower)
    contact = Contact(made["law"], 1 / (first + second), radius, (2 - 2 * ratio) / (2 - ratio))
    default = bool(contact.model and contact.model.check(1e3, 1e6) & asperity.Warnings.UNCALIBRATED)
    if ("the strength of the interface is the default" in printed) != default:
        raise RuntimeError("it is said wrongly whether the surface is calibrated")
    return contact.error(np.delete(table, STEPS + 1, axis=0), apart, overlap, made["wall"])


class Contact(check.RealContact):
    """Limit and stick stiffness by exact states, or with a constant coefficient."""

    def __init__(self, law, modulus, radius, poisson):
        self.mu = None if law in SURFACES else float(law.split()[1])
        model = None
        if not self.mu:
            params = asperity.Params.from_toml(FOLDER / f"{law}.toml")
            totals = ("asperity_count", "calibration_load", "calibration_friction_force", "nominal_area")
            model = asperity.Model(params.replace(**{name: getattr(params, name) / params.nominal_area for name in totals if getattr(params, name)}))
        super().__init__(model, modulus, radius, poisson)

    def at(self, load, overlap):
        return (self.mu * load, self.grains(overlap)) if self.mu else super().at(load, overlap)

    def error(self, table, apart, overlap, wall):
        """The spring of the contact, step by step."""
        worst, stuck, slid, friction, had, before = 0.0, 0, 0, 0.0, 0.0, table[0, 1]
        for _, place, _, along, up in table[1:]:
            x, z = (0.0, apart - overlap) if wall else (place, apart - overlap)
            distance = math.hypot(x, z)
            now_overlap = apart - distance
            load, tangential = (along * x + up * z) / distance, (along * z - up * x) / distance
            elastic = 4 / 3 * self.modulus * math.sqrt(self.radius * now_overlap) * now_overlap
            limit, now = self.at(elastic, now_overlap)
            friction *= min(1.0, now / had) if had else 1.0
            trial = friction - now * (place - before) * z / distance
            friction, had, before = max(-limit, min(limit, trial)), now, place
            stuck, slid = stuck + (abs(trial) < limit), slid + (abs(trial) > limit)
            worst = np.max([worst, abs(tangential - friction) / limit, abs(load / elastic - 1)])
        if stuck < 40 or slid < 40:
            raise RuntimeError(f"{stuck} steps of sticking and {slid} of slipping: not the run that was meant")
        return worst


def rebound(restitution, speed, wall, law="mu 0"):
    """The speed after an impact over the one before."""
    begin, _, laws = script(gap=1e-6, wall=wall, restitution=restitution, step=2e-7 * speed**-0.2, law=law)
    _, log = liggghts([*begin, laws, "thermo 10000", f"velocity upper set 0 0 {-speed}", "fix move upper nve/sphere",
                        "fix hold lower freeze", "run 100000"], FOLDER / "one")  # fmt: skip
    table = rows(log)
    if table[-1, 4] != 0 or not table[-1, 2] > 0:
        raise RuntimeError("the grains do not part")
    return table[-1, 2] / speed


def main():
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, text in SURFACES.items():
        (FOLDER / f"{name}.toml").write_text(text)
    (error,) = habits.worst(HABITS, moved)
    off = max(abs(rebound(**impact) / impact["restitution"] - 1) for impact in IMPACTS)
    found = f"friction within {error:.1e} of the law (limit {LIMIT:.0e}), {len(HABITS)} habits; "
    found += f"restitution within {off:.1e} (limit {RESTITUTION_LIMIT:.0e})"
    return error <= LIMIT and off <= RESTITUTION_LIMIT, found


if __name__ == "__main__":
    verdict.run("liggghts", main)
