"""Friction coefficient of a polysilicon MEMS contact against normal load, in SI units.

usage: friction_curve.py [FIGURE [LOADS [LOWEST [HIGHEST]]]]
  FIGURE   file to draw the curve in, its ending is its format; "-" or nothing for none
  LOADS    number of loads, 2 to 100000 (33)
  LOWEST   lowest load [N], > 0 (2e-4)
  HIGHEST  highest load [N], > LOWEST (0.1)

The table is that of c_examples/friction_curve.c, where the sources of the parameters are, to the last digit. It goes
to standard output; warnings go to standard error if the model does not hold somewhere between the two loads. Exit status: 0, 1 if the library or a file refuses, 2 for a wrong command line.
"""

from __future__ import annotations

import math
import sys

from asperity import Model, Params

# Two polysilicon surfaces that touch over a nominal area of 100 um x 100 um.
POLYSILICON = Params.si(
    E1=160e9,  # [Pa]
    nu1=0.22,
    E2=160e9,
    nu2=0.22,
    burgers_vector=0.384e-9,  # [m]
    adhesion_range=0.384e-9,  # [m]
    work_of_adhesion=0.063,  # [J/m^2]
    height_std=5e-9,  # [m]
    summit_radius=1e-6,  # [m]
    summit_density=1e13,  # [1/m^2]
    nominal_area=1e-8,  # [m^2]
    hardness=12e9,  # [Pa]
)


def loads_between(lowest: float, highest: float, count: int) -> list[float]:
    """Loads evenly spaced in the logarithm."""
    return [lowest * math.pow(highest / lowest, i / (count - 1)) for i in range(count)]


def print_table(model: Model, loads: list[float]) -> None:
    print("# load [N], mu, friction force [N], real area [m^2], contacts")
    for load in loads:
        state = model.state_at_load(load)
        row = (
            load,
            model.friction_at_load(load),
            model.friction_force_at_load(load),
            state.real_area,
            state.contacting,
        )
        print(" ".join(f"{number:.9e}" for number in row))


def print_warnings(model: Model, lowest: float, highest: float) -> None:
    """Says what of the model does not hold at these loads, and what to do about it."""
    for warning in model.check(lowest, highest).kinds:
        print(f"friction_curve: warning: {warning.description}", file=sys.stderr)


def draw(file: str, model: Model, loads: list[float]) -> None:
    """Beside the law, the one number that a solver takes today: the law's own at the middle of the loads."""
    from matplotlib.figure import Figure

    constant = model.friction_at_load(math.sqrt(loads[0]) * math.sqrt(loads[-1]))
    figure = Figure(figsize=(7.5, 5), layout="constrained")
    axes = figure.add_subplot(title="Friction falls with load: polysilicon on polysilicon")
    axes.semilogx(loads, [model.friction_at_load(load) for load in loads], label="contact physics (asperity)")
    axes.axhline(constant, color="C3", linestyle="--", label=f"constant µ = {constant:.3f}")
    axes.set(xlabel="normal load $P$ [N]", ylabel="friction coefficient $F/P$ [–]")
    axes.set_ylim(bottom=0)
    axes.legend()
    figure.savefig(file)


def read_arguments(arguments: list[str]) -> tuple[str, int, float, float]:
    given = dict(zip(("figure", "loads", "lowest", "highest"), arguments))
    figure, count = given.get("figure", "-"), int(given.get("loads", 33))
    lowest, highest = float(given.get("lowest", 2e-4)), float(given.get("highest", 0.1))
    if len(arguments) > 4 or not (2 <= count <= 100000 and 0 < lowest < highest and math.isfinite(highest / lowest)):
        raise ValueError("2 to 100000 loads, LOWEST > 0 and HIGHEST > LOWEST are needed")
    return figure, count, lowest, highest


def main(arguments: list[str]) -> int:
    try:
        figure, count, lowest, highest = read_arguments(arguments)
    except ValueError as error:
        print(f"friction_curve: {error}\nusage: friction_curve.py [FIGURE [LOADS [LOWEST [HIGHEST]]]]", file=sys.stderr)
        return 2
    try:
        model = Model(POLYSILICON)
        loads = loads_between(lowest, highest, count)
        print_table(model, loads)
        print_warnings(model, lowest, highest)
        if figure != "-":
            draw(figure, model, loads)
    except (ImportError, OSError, ValueError) as error:
        print(f"friction_curve: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
