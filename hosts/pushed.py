"""A block that is pressed on a rough floor and pushed along it, in a finite-element program whose friction follows the law at each node: the
problem, its check against exact states, and what its users alter. Units: mm, N, MPa, unless a habit has others.
"""

import functools

import asperity
import habits  # of hosts/
import numpy as np
import surface

LIMIT = 1e-6
LENGTH, HEIGHT = 40.0, 20.0  # plane strain
PRESS = 1e-4  # what the top is pushed down by, over the height
PUSH = (0.3, 1.0, 2.0)  # how far the top has gone sideways after each step, over that
HABITS = {
    "m, Pa": dict(length=1.0), "um, N": dict(length=1e-6), "cm, kN": dict(length=1e-2, force=1e3), "Poisson's ratio 0": dict(poisson=0.0),
    "Poisson's ratio 0.45": dict(poisson=0.45), "aluminium": dict(young=70e9), "half the mesh": dict(elements=(16, 8)),
    "uneven elements": dict(elements=(48, 8)), "half the load": dict(press=PRESS / 2), "twice the load": dict(press=2 * PRESS),
    "one step": dict(path=(2.0,)), "to and fro": dict(path=(0.6, 1.2, 0.6, 0.0, -1.2)), "the other way": dict(path=(-0.3, -1.0, -2.0)),
    "another penalty": dict(penalty=100.0), "a softer onset": dict(onset=1e-2), "another surface": dict(change=dict(work_of_adhesion=2e-5)),
    "calibrated": dict(measured=(20e6, 0.15)), "pushed apart": dict(press=-PRESS, refused="no node touches"),
}  # fmt: skip


def pushed(steps, young=210e9, poisson=0.3, elements=(32, 16), press=PRESS, path=PUSH, length=1e-3, force=1.0, penalty=10.0, onset=1e-5,
           change=None, measured=None):  # fmt: skip
    """The worst error of friction and load of a block whose numbers have other units of length and force, relative to the load."""
    stress, area = length**2 / force, 1e-6 / length**2  # 1 Pa, and 1 mm2
    params = surface.surface(area, length, force).replace(**change or {})
    model = asperity.Model(params.calibrated(measured[0] * stress * area, measured[1]) if measured else params)
    down = press * HEIGHT * 1e-3 / length
    onset, moves = abs(onset * down), [(sideways * down, -down) for sideways in (0.0, *path)]
    errors = []
    for reaction, areas, pressure, slip in steps(model, area, young * stress, poisson, 1e-3 / length, elements, penalty, onset, moves):
        exact = np.array([model.state_at_load(p * area).friction_force if p > 0 else 0.0 for p in pressure]) / area
        carried = np.sum(areas * pressure)
        friction = np.sum(areas * exact * slip / np.hypot(slip, onset))
        errors.append(np.max(np.abs(reaction - [friction, -carried])) / carried)
    if not np.min(np.abs(slip)) > 10 * onset:
        raise RuntimeError("the block does not slide at the end")
    touching = pressure[pressure > 0.02 * np.mean(pressure)] * area
    surface.demand(model, touching.min(), touching.max(), areas.min() * params.asperity_count / area**0.5)
    return max(errors)


def main(steps):
    """`steps` of a host: reaction of the top, areas, pressures and slips of the nodes after each of the moves of the top."""
    (error,) = habits.worst(HABITS, functools.partial(pushed, steps))
    return error <= LIMIT, f"friction and load of the block within {error:.1e} of the law at the nodes (limit {LIMIT:.0e}), {len(HABITS)} habits"
