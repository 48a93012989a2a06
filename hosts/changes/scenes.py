"""The scenes of docs/what-changes.md: the same program with a constant friction coefficient and with the law. Draws a picture of each, and
holds the page's tables to what the programs find. SI units.
"""

import math
import os
import re
import subprocess
import sys
from pathlib import Path

import asperity
import asperity.mujoco
import mujoco
import numpy as np
from asperity.estimate import estimate
from asperity.tools.style import BLUE, ORANGE, GREY, saved, style

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "hosts"))
import verdict  # noqa: E402
from incline import GRAVITY, acceleration  # noqa: E402
from surface import surface  # noqa: E402

PAGE = ROOT / "docs" / "what-changes.md"
BUILD = Path(os.environ["XDG_CACHE_HOME"])
# Of a number of the page: a bed of grains is chaotic, so that the last digits of the law move it, most where contacts have few asperities.
TOLERANCE, SMALLEST_GRAINS = 0.03, 0.1
AREA, LOAD = 1e-6, GRAVITY * math.cos(math.radians(30))  # where the coefficient was measured, once: 1 kg on the incline
FILM = surface(AREA)
FILM = FILM.calibrated(LOAD, asperity.Model(FILM).friction_at_load(LOAD))
LAW = asperity.Model(FILM)
CONSTANT = LAW.friction_at_load(LOAD)


def slide(mass, text=None):
    """The acceleration [m/s2] of a box of so many kg that slides down 30 degrees in MuJoCo; with the constant unless a surface is given."""
    plugin = f'<plugin plugin="asperity.friction">{asperity.mujoco.instance("film", text)}</plugin>' if text else ""
    ours = '<plugin instance="film"/>' if text else ""
    model = mujoco.MjModel.from_xml_string(f"""
    <mujoco><extension>{plugin}</extension>
      <option cone="elliptic" impratio="10" gravity="{GRAVITY / 2} 0 {-GRAVITY * math.cos(math.radians(30))}"/>
      <default><geom friction="{CONSTANT}"/></default>
      <worldbody><geom type="plane" size="50 50 0.1"/>
        <body pos="0 0 0.0501">{ours}<freejoint/><geom type="box" size="0.1 0.05 0.05" mass="{mass}"/></body></worldbody>
    </mujoco>""")
    data = mujoco.MjData(model)
    path = []
    while data.time < 1.5:
        mujoco.mj_step(model, data)
        path.append((data.time, data.qvel[0]))
    return acceleration(*zip(*path))


def incline(axes):
    """Three masses on an incline."""
    masses, line = np.array([0.1, 1, 10]), np.geomspace(0.05, 20, 41)
    found = [[slide(mass, given) for mass in masses] for given in (FILM, None)]
    band = estimate(FILM._as_text(), LOAD * line)
    level = GRAVITY / 2 - LOAD * np.array([band.value, band.high, band.low])
    axes.fill_between(line, level[1], level[2], color=BLUE, alpha=0.2, lw=0)
    axes.plot(line, level[0], color=BLUE)
    axes.plot(masses, found[0], "o", color=BLUE, label="the law, with its band")
    axes.plot(masses, found[1], "s--", color=ORANGE, label=f"constant {CONSTANT:.3f}")
    axes.set(xscale="log", xlabel="mass [kg]", ylabel="acceleration [m/s²]")
    return {f"{mass:g} kg": values for mass, *values in zip(masses, *found)}


def bed(diameter, layers, words):
    """Drag over weight of a belt under a bed of grains in LAMMPS, and the mean load [N] of a grain on it."""
    log = BUILD / "bed.log"
    given = dict(plugin=BUILD / "libasperity_lammps.so", d=diameter, layers=layers, words=words)
    subprocess.run([os.environ["LAMMPS"], "-in", ROOT / "hosts/changes/bed.in", "-log", log, "-screen", "none",
                    *(word for name, value in given.items() for word in ("-var", name, str(value)))], check=True)  # fmt: skip
    text = log.read_text()
    if ("surface" in words and diameter < 5e-3) != bool(re.search(r"fix floor wall/asperity/hertz: .* fewer than 20 asperities", text)):
        raise RuntimeError(f"grains of {diameter} m, {words}: few summits on the belt are told wrongly")
    drag, carried, grains = map(float, re.findall(r"^ +16000 +(\S+) +(\S+) +(\S+)", text, re.M)[-1])
    return drag / carried, carried / grains


def belt(axes):
    """Beds of grains of four sizes on a belt, and one of half the depth."""
    path = BUILD / "film.toml"
    path.write_text(FILM._as_text())
    law, constant = f"real_modulus 1.7531556e9 poisson 0.38 surface {path}", f"poisson 0.38 mu {CONSTANT}"
    sizes = [1e-3, 3e-3, 1e-2, 3e-2]
    found = [bed(size, 8, law) for size in sizes]
    plain = [bed(size, 8, constant)[0] for size in (sizes[0], sizes[-1])]
    bands = []
    for size, (_, load) in zip(sizes, found):  # of one grain on its own area
        radius = size / 2
        area = math.pi * ((0.75 * load * radius / 1.7531556e9) ** (2 / 3) + 1.5 / 0.92 * radius * FILM.height_std)
        grain = FILM.replace(asperity_count=FILM.asperity_count * area / AREA, nominal_area=area)
        bands.append(estimate(grain._as_text(), load))
    drags = np.array([drag for drag, _ in found])
    part = [np.array([getattr(band, end) / band.value for band in bands]) for end in ("low", "high")]
    sizes = 1e3 * np.array(sizes)
    axes.fill_between(sizes, drags * part[0], drags * part[1], color=BLUE, alpha=0.2, lw=0)
    axes.plot(sizes, drags, "o-", color=BLUE, label="the law, with one grain's band")
    axes.plot(sizes[[0, -1]], plain, "s--", color=ORANGE, label=f"constant {CONSTANT:.3f}")
    axes.set(xscale="log", xlabel="diameter of the grains [mm]", ylabel="drag of the belt / weight [–]", ylim=(0, None))
    axes.set_xticks([1, 3, 10, 30], ["1", "3", "10", "30"])
    shallow = bed(1e-2, 4, law)[0], bed(1e-2, 4, constant)[0]
    rows = {f"{size:g} mm": [drag] for size, drag in zip(sizes, drags)}
    rows["1 mm"].append(plain[0])
    rows["30 mm"].append(plain[1])
    return rows | {"10 mm, half as deep": shallow}


# A pad of 10 g on a belt, its springs and contact: it flutters, as brakes squeal, where friction grows by more than this with load (N.
# Hoffmann and others, Int. J. Vehicle Design 28 (2002): coupling of two modes).
MASS, CONTACT, CRITICAL, SPEED = 0.01, 1e6, 0.235, 0.001


def pad(friction, loads):
    """The largest speed of pads in the end, over that of the belt: about 1 where they stick and slip, next to 0 where they slide."""
    couples = CRITICAL * CONTACT
    direct, rest = CONTACT + couples, friction(loads)
    x, u, w, fastest = (np.zeros(loads.size) for _ in range(4))
    y = 1e-3 * loads / CONTACT
    step = 0.05 / math.sqrt(direct / MASS)
    for number in range(24_000):
        pressed = np.maximum(loads + CONTACT * y, 0)
        limit = np.where(pressed > 0, friction(np.maximum(pressed, 1e-9)), 0)
        u += (-rest - direct * x - couples * y) / MASS * step
        u += np.clip(SPEED - u, -limit / MASS * step, limit / MASS * step)
        w += (-couples * x - direct * y) / MASS * step
        x, y = x + u * step, y + w * step
        if number > 20_000:
            fastest = np.maximum(fastest, u / SPEED)
    return fastest


def onset(axes):
    """The slope of friction by load decides whether a pad sticks and slips."""
    loads, line = np.array([1, 2, 5, 10]), np.geomspace(0.7, 15, 41)
    slope = LAW.friction_force_at_load(line, slope=True)[1]
    band = estimate(FILM._as_text(), line)
    axes.fill_between(line, slope * np.array(band.low) / band.value, slope * np.array(band.high) / band.value, color=BLUE, alpha=0.2, lw=0)
    rows = {f"{load} N": [] for load in loads}
    cases = [("the law, with its band", LAW.friction_force_at_load, slope, BLUE, "o")]
    for at in (loads[0], loads[-1]):
        mu = LAW.friction_at_load(at)
        cases.append((f"constant {mu:.3f}, measured at {at} N", lambda load, mu=mu: mu * load, np.full(line.size, mu), ORANGE, "s"))
    for name, friction, of_line, colour, mark in cases:
        axes.plot(line, of_line, color=colour)
        for load, speed in zip(loads, pad(friction, loads.astype(float))):
            at = np.interp(load, line, of_line)
            axes.plot(load, at, mark, color=colour, markerfacecolor=colour if speed > 0.5 else "white", label=name if load == 1 else None)
            rows[f"{load} N"].append("sticks and slips" if speed > 0.5 else "slides")
    axes.axhline(CRITICAL, color=GREY, lw=1, ls=":")
    axes.set(xscale="log", xlabel="load [N]", ylabel="dF/dN [–]; filled: sticks and slips")
    axes.set_xticks([1, 2, 5, 10], ["1", "2", "5", "10"])
    axes.minorticks_off()
    return rows


JOINT = """pair = "steel/steel"
nominal_area = 4e-4
measured = [10000, 0.16]
[roughness]
Ra = [0.8e-6, 0.8e-6]
process = "ground"
"""


def joint(axes):
    """Two cycles of ground faces under 10 kN, below the friction force."""
    law, load, band = asperity.Model(asperity.Params.from_text(JOINT)), 10e3, estimate(JOINT, 10e3)
    force, stiffness, rows = law.friction_force_at_load(load), law.tangential_stiffness_at_load(load), {}
    for reach in (0.6, 1.8):  # F/K_t
        loop = law.hysteresis(load, reach * force / stiffness, points=61)
        rows[f"{loop.force.max() / force:.2f} F"] = [1e3 * loop.work, 0.0]
        for scale, width in ((1, 1.6), (stiffness / band.stiffness.low, 0.5), (stiffness / band.stiffness.high, 0.5)):
            name = "the law, with its band" if reach > 1 and scale == 1 else None
            axes.plot(1e6 * scale * loop.displacement, 1e-3 * loop.force, color=BLUE, lw=width, label=name)
    axes.plot([0, 0], [-9.4e-4 * force, 9.4e-4 * force], "--", color=ORANGE, label="constant 0.16")
    axes.set(xlabel="displacement of the faces [µm]", ylabel="tangential force [kN]")
    return rows


TITLES = {incline: "Heavy boxes slide faster", belt: "Small grains drag a belt more", onset: "A pad sticks and slips at light loads only",
          joint: "A joint loses work before it slides"}  # fmt: skip


def wrong(page, rows):
    """The rows of the page's tables that are not as found."""
    told = {cells[0]: cells[1:] for line in page.splitlines() if line.startswith("| ") for cells in [[c.strip() for c in line[2:-1].split("|")]]}
    missed = []
    for name, values in rows.items():
        print(f"  | {name} | " + " | ".join(value if isinstance(value, str) else f"{value:.3g}" for value in values) + " |")
        cells = [cell for cell in told.get(name, []) if cell]
        tolerance = SMALLEST_GRAINS if name == "1 mm" else TOLERANCE
        same = len(cells) == len(values) and all(
            cell == value if isinstance(value, str) else abs(float(cell) - value) <= tolerance * abs(value) for cell, value in zip(cells, values))  # fmt: skip
        missed += [] if same else [name]
    return missed


def main():
    from matplotlib.figure import Figure

    rows = {}
    with style():
        for scene, title in TITLES.items():
            figure = Figure(figsize=(5.0, 3.4))
            axes = figure.add_axes((0.15, 0.16, 0.81, 0.72))
            rows |= scene(axes)
            axes.set_title(title, loc="left", weight="bold", fontsize=11)
            axes.legend(fontsize=9)
            saved(figure, BUILD / f"changes-{scene.__name__}.svg")
    missed = wrong(PAGE.read_text(encoding="utf-8"), rows)
    return not missed, f"{len(rows) - len(missed)} of {len(rows)} rows of the page are as found{'; not ' if missed else ''}{', '.join(missed)}"


if __name__ == "__main__":
    verdict.run("changes", main)
