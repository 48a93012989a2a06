"""Judges what the runs of hosts/lammps/run.sh left behind: against the exact states of the law, which use no table, against
mechanics, and against each other. usage: check.py FOLDER
"""

import math
import sys
import warnings
from pathlib import Path

import asperity
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import surface  # of hosts/
import verdict

LAW_LIMIT, ENERGY_LIMIT, RANK_LIMIT = 1e-6, 5e-3, 1e-6
# Limits of microslip, over the friction force, the work, the force and the friction force. The plugin takes the last correction of the
# summits' displacement from the tangent, which leaves 1e-3 at most; ranks may ask the library at other steps.
CURVE_LIMIT, WORK_LIMIT, TURN_LIMIT, STEP_LIMIT, MICROSLIP_RANK_LIMIT = 0.02, 0.15, 1e-3, 1e-3, 1e-5
GAIN_LIMIT = 1e-9  # of the energy of grains that bounce, beyond the least before
REAL_MODULUS, POISSON = 1.7531556e9, 0.38
LEAST_HELD = 0.99
MANY = 60  # summits, from which the friction of a contact is the mean of the surface


def tables(log):
    """The tables of a LAMMPS log, as lists of rows by column name; rows keep their text."""
    result, header = [], None
    for line in log.read_text().splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            header = words
            result.append([])
        elif header and words and words[0].isdigit() and len(words) == len(header):
            result[-1].append(dict(zip(header, words)))
        elif words[:1] == ["Loop"]:
            header = None
    return result


def column(rows, name):
    return np.array([float(row[name]) for row in rows])


def area_of(model, load, radius):
    """Nominal area of a contact of two rough grains (docs/device-or-bead.md)."""
    return math.pi * ((0.75 * load * radius / REAL_MODULUS) ** (2 / 3) + 1.5 * model.params.height_std / 0.92 * radius)


class RealContact:
    """Limit and stick stiffness of a contact of softened grains, by the equations of hosts/lammps/README.md and exact states."""

    def __init__(self, model, modulus, radius, poisson=POISSON):
        self.model, self.modulus, self.radius, self.poisson = model, modulus, radius, poisson

    def at(self, load, overlap):
        area = area_of(self.model, load, self.radius)
        state = self.model.state_at_load(load / area)
        bulk = self.grains(overlap)
        summits = (self.modulus / REAL_MODULUS) ** (2 / 3) * area * state.tangential_stiffness
        return area * state.friction_force, 1 / (1 / bulk + 1 / summits)

    def grains(self, overlap):
        """Mindlin's stiffness."""
        return 2 * (1 - self.poisson) / (2 - self.poisson) * 2 * self.modulus * math.sqrt(self.radius * overlap)


def slide_error(folder, model):
    """Largest error of friction of the two grains, relative to the limit: it rises by the stick stiffness to the law."""
    log = folder / "slide.log"
    moduli = [float(line.split()[2]) for line in log.read_text().splitlines() if line.startswith("slide modulus")]
    there_and_back = tables(log)
    worst, stuck, slid = 0.0, 0, 0
    for modulus, there, back in zip(moduli, there_and_back[::2], there_and_back[1::2]):
        rows = [[float(word) for word in row.values()] for row in there + back[1:]]
        contact = RealContact(model, modulus, 0.0025)
        friction = stiffness = 0.0
        previous = rows[0]
        for row in rows[1:]:
            _, place, overlap, size, load = row
            elastic = 4 / 3 * modulus * math.sqrt(0.0025 * overlap) * overlap
            limit, now = contact.at(elastic, overlap)
            friction *= min(1.0, now / stiffness) if stiffness else 1.0
            along = math.sqrt(1 - (place / (0.01 - overlap)) ** 2)  # of the motion, in the tangent plane
            trial = friction - now * (place - previous[1]) * along
            friction, stiffness, previous = max(-limit, min(limit, trial)), now, row
            lost = 1 - now / contact.grains(overlap)
            stuck, slid = stuck + (abs(trial) < limit), slid + (abs(trial) > limit)
            worst = np.max([worst, abs(size - abs(friction)) / limit, abs(load / elastic - 1)])
        print(f"  {elastic:.3g} N: of Mindlin's stiffness the summits take {lost:.1%}; mu = {limit / elastic:.3f}")
    if len(there_and_back) != 10 or stuck < 300 or slid < 300:
        raise RuntimeError(f"{len(there_and_back)} slides, {stuck} steps of sticking and {slid} of slipping: not the run that was meant")
    return worst


class Cycle:
    """Two grains with microslip that one log of cycle.in moved to and fro and turned, against the law's own curve: its summits
    are behind the grain's spring, whose part of the displacement is taken off."""

    def __init__(self, model, modulus, radius, there, back, again, turned):
        rows = np.array([[float(word) for word in row.values()] for row in there + back[1:] + again[1:]])
        place, force, load = rows[:, 1], rows[:, 2], rows[0, 6]
        area = area_of(model, load, radius)
        overlap = (0.75 * load / (modulus * math.sqrt(radius))) ** (2 / 3)
        grain = RealContact(model, modulus, radius).grains(overlap)
        softened = (modulus / REAL_MODULUS) ** (2 / 3)
        self.limit = area * model.state_at_load(load / area).friction_force
        self.summits, self.force = place - force / grain, force
        def first(displacement):
            force, _ = model.tangential(load / area, softened * np.abs(displacement))
            return area * np.sign(displacement) * force

        ends = self.summits[[100, 300]]
        reached = first(ends[0])
        back = reached - 2 * first((ends[0] - self.summits[101:301]) / 2)
        self.exact = np.concatenate([first(self.summits[:101]), back,
                                     back[-1] + 2 * first((self.summits[301:] - ends[1]) / 2)])
        self.steps = self.off_steps(model, modulus, radius, rows)
        self.turned = np.array([[float(row[f"c_force[{a}]"]) for a in (1, 2, 3)] for row in turned])

    def off_steps(self, model, modulus, radius, rows):
        """How far each step is from one of the library that begins where the one before ended, relative to the friction force."""
        softened = (modulus / REAL_MODULUS) ** (2 / 3)
        contact = model.microslip()
        worst = force = had = 0.0
        for before, row in zip(rows, rows[1:]):
            load = row[6]
            area = area_of(model, load, radius)
            grain = RealContact(model, modulus, radius).grains((0.75 * load / (modulus * math.sqrt(radius))) ** (2 / 3))
            now = 1 / (1 / grain + 1 / (softened * area * model.tangential_stiffness_at_load(load / area)))
            kept = min(1.0, now / had) if had else 1.0
            moved = row[1] - before[1] - (row[2] - kept * force) / grain
            contact.state[-3:-1] /= area  # stiffnesses; before them are displacements, behind them the largest pressure
            expected = area * contact.step(load / area, [softened * moved, 0.0]).force[0]
            contact.state[-3:-1] *= area
            worst = np.max([worst, abs(row[2] - expected) / self.limit])
            force, had = row[2], now
        return worst

    def off(self):
        """From the curve, relative to the friction force."""
        return np.max(np.abs(self.force - self.exact)) / self.limit

    def work(self, force):
        loop = slice(100, 501)
        return np.sum(np.diff(self.summits[loop]) * (force[loop][1:] + force[loop][:-1]) / 2)

    def turning(self):
        """How far the force is from one that turned as the grains did."""
        size, angle = self.force[-1], np.arange(len(self.turned)) * math.pi / 1000
        expected = size * np.stack([np.cos(angle), 0 * angle, -np.sin(angle)], axis=1)
        return np.max(np.abs(self.turned - expected)) / abs(size)


def cycles(folder, model):
    """The grains of cycle.in: how far forces are from the curve, the work of a cycle, a force that turns, and steps."""
    runs = tables(folder / "cycle.log")
    if len(runs) != 16:
        raise RuntimeError(f"{len(runs)} runs in cycle.log: not the cycles that were meant")
    worst = []
    for k in range(0, 16, 4):
        cycle = Cycle(model, 5e6, 0.0025, *runs[k : k + 4])
        work, exact = cycle.work(cycle.force), cycle.work(cycle.exact)
        print(f"  cycle to {np.max(np.abs(cycle.force)) / cycle.limit:.2f} F: within {cycle.off():.4f} F of Masing's loop, "
              f"work {work:.3g} J, that of the loop {exact:.3g} J")
        worst.append([cycle.off(), abs(work / exact - 1), cycle.turning(), cycle.steps])
    return np.max(worst, axis=0)


def energy_gap(rows, springs=True):
    """Largest gap of the balance of energy, relative to what was turned over; heat of friction must only grow, where it is
    known: summits store more than one spring with their force."""
    values = {name: column(rows, f"v_{name}") for name in
              ("kinetic", "height", "elastic", "stick", "friction", "damping", "driving")}
    total = sum(values[name] for name in ("kinetic", "height", "elastic", "friction", "damping")) - values["driving"]
    heat = values["friction"] - values["stick"]
    if springs and np.any(np.diff(heat) < -1e-9 * heat.max()):
        raise RuntimeError("friction gives back more than was put into its springs")
    return np.max(np.abs(total - total[0])) / (values["friction"][-1] + values["damping"][-1])


def bouncing(folder):
    """The grains of bounce.in: how much energy friction took, and by how much more than before there ever was, while none touch: those that
    do keep some in their springs."""
    rows, = tables(folder / "bounce.log")
    contacts = column(rows, "v_contacts")
    energy = column(rows, "v_kinetic")[contacts == 0]
    # A contact lasts for some twelve of the steps that are printed.
    if contacts.sum() < 12 * 1000 or len(energy) < 10:
        raise RuntimeError(f"some {contacts.sum() / 12:.0f} grains bounced, and at {len(energy)} times none: not the run that was meant")
    return 1 - energy[-1] / energy[0], np.max(energy / np.minimum.accumulate(energy) - 1)


def disagreement(one, other):
    """Largest relative difference of the sums of two runs, at the steps that both printed."""
    steps = {row["Step"]: row for row in one}
    common = [row for row in other if row["Step"] in steps]
    if len(common) < 2:
        raise RuntimeError("runs without a common step")
    return np.max([abs(float(row[name]) / float(steps[row["Step"]][name]) - 1)
                   for row in common for name in row if name != "Step" and float(steps[row["Step"]][name]) != 0])


def contacts(folder, ranks):
    """Identifiers, friction, load, pressure, limit and stiffness of the contacts that were sampled."""
    rows = []
    for line in (folder / f"contacts{ranks}.txt").read_text().splitlines():
        words = line.split()
        if len(words) == 7 and words[0].isdigit() and float(words[3]) > 0:
            rows.append([float(word) for word in words])
    if len(rows) < 1000:
        raise RuntimeError(f"{len(rows)} contacts sampled on {ranks} ranks")
    return np.array(rows)


def law_error(model, rows):
    """How far limits are from the exact law, and how far friction is above it; demands that the model holds."""
    sizes = 0.005 * (1 + 0.08 * np.sin(0.7 * rows[:, :2] ** 2))
    radius = sizes[:, 0] * sizes[:, 1] / sizes.sum(axis=1)
    friction, load, limit = rows[:, 2], rows[:, 3], rows[:, 5]
    area = area_of(model, load, radius)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", asperity.ValidityWarning)
        states = [model.state_at_load(p) for p in load / area]
    exact = area * [state.friction_force for state in states]
    many = area * [state.contacting for state in states] > 1.01 * MANY  # alter.py compares those of few summits
    heavy = np.argsort(-load)[: np.searchsorted(np.cumsum(np.sort(load)[::-1]), LEAST_HELD * load.sum()) + 1]
    pressure, lightest = load / area, heavy[-1]
    summits = model.params.asperity_count * area[lightest]
    surface.demand(model, pressure[heavy].min(), pressure[heavy].max(), fewest_summits=summits)
    slipping = np.mean(friction > limit * (1 - 1e-9))
    if not 0.1 < slipping < 0.9:
        raise RuntimeError(f"{slipping:.0%} of the contacts slip: not both kinds")
    if not 0.5 < np.mean(many):
        raise RuntimeError(f"{np.mean(many):.0%} of the contacts are of many summits")
    return np.max([np.abs(limit / exact - 1)[many], (friction / exact - 1)[many]])


def demand_no_warning(folder):
    """The plugin itself says at the end of a run where the model does not hold."""
    for log in folder.glob("*.log"):
        for line in log.read_text().splitlines():
            # That the strength of this interface was not measured is said too, and no reason to stop.
            if line.startswith("WARNING: pair_style asperity/hertz: the model holds for"):
                raise RuntimeError(f"{log.name}: {line}")


def main(folder):
    demand_no_warning(folder)
    model = asperity.Model(surface.surface(nominal_area=1.0))
    slide = slide_error(folder, model)
    if "the strength of the interface is the default" not in (folder / "slide.log").read_text():
        raise RuntimeError("slide.log: that the surface is not calibrated is not said")
    settle, = tables(folder / "settle.log")
    runs = {ranks: tables(folder / f"shear{ranks}.log") for ranks in (1, 2, 4)}
    energy = np.max([energy_gap(rows) for rows in [settle, *runs[1], *runs[2]]])
    # Built-in max leaves out what is no number; NumPy's does not.
    slipping = {ranks: tables(folder / f"microslip{ranks}.log") for ranks in (1, 2)}
    energy = np.max([energy, *(energy_gap(rows, springs=False) for rows in slipping[1] + slipping[2])])
    ranks = np.max([disagreement(runs[1][0], runs[2][0]), disagreement(runs[1][0], runs[4][0]),
                    disagreement(runs[1][1], runs[2][1])])
    slipping_ranks = np.max([disagreement(*pair) for pair in zip(slipping[1], slipping[2])])
    law = np.max([law_error(model, contacts(folder, n)) for n in (1, 2)])
    held = np.min([np.min(column(rows, "v_held") / column(rows, "v_load")) for n in (1, 2) for rows in runs[n]])
    continued, = tables(folder / "continued.log")
    microslip_continued, forgetful = tables(folder / "microslip_continued.log")
    if "all contacts forget what they carried" not in (folder / "microslip_continued.log").read_text():
        raise RuntimeError("microslip is turned off between two runs without a warning")
    if not column(forgetful, "v_load")[-1] > 0:
        raise RuntimeError("grains fly apart where microslip is turned off")
    same = continued == runs[2][1] and microslip_continued == slipping[2][1]
    curve, work, turn, steps = cycles(folder, model)
    taken, gained = bouncing(folder)
    print(f"  two grains: friction within {slide:.1e} of the law (limit {LAW_LIMIT:.0e})")
    print(f"  column: limits within {law:.1e} of the law (limit {LAW_LIMIT:.0e}), energy within {energy:.1e} "
          f"(limit {ENERGY_LIMIT:.0e}); the model holds for {held:.4f} of the load (at least {LEAST_HELD})")
    print(f"  the runs continued from restart files have {'the same digits' if same else 'OTHER digits'}")
    print(f"  microslip: within {curve:.4f} F of Masing's loops (limit {CURVE_LIMIT}), work of a cycle within {work:.3f} "
          f"(limit {WORK_LIMIT}), steps within {steps:.1e} F of the library's (limit {STEP_LIMIT:.0e}); a force that turns with "
          f"its grains is within {turn:.1e} (limit {TURN_LIMIT:.0e}); ranks differ by {slipping_ranks:.1e} "
          f"(limit {MICROSLIP_RANK_LIMIT:.0e})")
    print(f"  a gas of grains with microslip: {taken:.0%} of its energy taken, {gained:.1e} gained (limit {GAIN_LIMIT:.0e})")
    passed = slide <= LAW_LIMIT and law <= LAW_LIMIT and energy <= ENERGY_LIMIT and ranks <= RANK_LIMIT
    passed = passed and taken > 0.2 and gained <= GAIN_LIMIT
    passed = passed and held >= LEAST_HELD and same
    passed = passed and curve <= CURVE_LIMIT and work <= WORK_LIMIT and turn <= TURN_LIMIT and steps <= STEP_LIMIT
    passed = passed and slipping_ranks <= MICROSLIP_RANK_LIMIT
    return passed, f"one, two and four ranks differ by {ranks:.1e} (limit {RANK_LIMIT:.0e})"


if __name__ == "__main__":
    verdict.run("lammps", main, Path(sys.argv[1]))
