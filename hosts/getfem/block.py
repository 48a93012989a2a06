"""Block in GetFEM: pressed on a rough floor and sheared, with a friction coefficient that follows the pressure node by
node. The contact brick takes the coefficients as given, so each load step is a fixed point of pressure and coefficient.
Each input is changed once. Units: mm, N, MPa, unless a habit has others.
"""

import sys
from pathlib import Path

import asperity
import getfem
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import habits  # of hosts/
import surface
import verdict

getfem.util_trace_level(0)

LIMIT = 1e-6
LENGTH, HEIGHT = 40.0, 20.0  # thickness 1 mm, plane strain
PRESS = 1e-4  # what the top is pushed down by, over the height
SHEAR = 0.15 * np.arange(1, 9)  # how far the top has gone sideways after each step, over that
HABITS = {
    "m, Pa": dict(length=1.0), "um, N": dict(length=1e-6), "cm, kN": dict(length=1e-2, force=1e3), "Poisson's ratio 0": dict(poisson=0.0),
    "Poisson's ratio 0.45": dict(poisson=0.45, measured=(20e6, 0.1)), "aluminium": dict(young=70e9), "half the mesh": dict(elements=(16, 8)),
    "uneven elements": dict(elements=(48, 8)), "half the load": dict(press=PRESS / 2), "twice the load": dict(press=2 * PRESS),
    "two steps": dict(path=SHEAR[[3, 7]]), "twice the steps": dict(path=0.075 * np.arange(1, 17)), "to and fro": dict(path=np.array([0.6, 1.2, 0.6, 0, -1.2])),
    "the other way": dict(path=-SHEAR), "another first guess": dict(guess=0.05), "another penalty": dict(penalty=0.2),
    "another surface": dict(change=dict(work_of_adhesion=2e-5)), "calibrated": dict(measured=(20e6, 0.15)),
    "a film under pressure": dict(change=dict(pressure_coefficient=0.05), path=1.4 * SHEAR),
}  # fmt: skip


class Block:
    """The elastic block, its nodes on the floor and the contact conditions there."""

    def __init__(self, young, poisson, unit, elements, penalty):
        height = HEIGHT * unit
        x, y = (np.linspace(0, size * unit, n + 1) for size, n in zip((LENGTH, HEIGHT), elements))
        self.penalty = penalty * young / height
        self.forces = young * LENGTH * unit  # of the size that is met, by the strain; Newton's method ends at a force
        mesh = getfem.Mesh("cartesian", x, y)
        mesh.set_region(1, mesh.outer_faces_with_direction([0, -1], 0.01))
        mesh.set_region(2, mesh.outer_faces_with_direction([0, 1], 0.01))
        self.displacements = getfem.MeshFem(mesh, 2)
        self.displacements.set_fem(getfem.Fem("FEM_QK(2,2)"))
        self.integration = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)"))
        self.find_contact_nodes(mesh)
        self.top = self.displacements.basic_dof_on_region(2)
        self.elasticity = [young * poisson / (1 + poisson) / (1 - 2 * poisson)], [young / 2 / (1 + poisson)]
        self.stiffness = self.assembled_stiffness(mesh)
        self.model = self.contact_model()

    def find_contact_nodes(self, mesh):
        """Degrees of freedom along and across the floor, from left to right, and the area that each node stands for."""
        dofs = np.array(self.displacements.basic_dof_on_region(1))
        where = self.displacements.basic_dof_nodes()[0]
        self.along, self.across = (d[np.argsort(where[d])] for d in (dofs[0::2], dofs[1::2]))
        self.x = where[self.along]
        scalar = getfem.MeshFem(mesh, 1)
        scalar.set_fem(getfem.Fem("FEM_QK(2,2)"))
        weights = getfem.asm_boundary_source(1, self.integration, scalar, scalar, np.ones((1, scalar.nbdof()))).ravel()
        nodes = np.array(scalar.basic_dof_on_region(1))
        self.area = weights[nodes[np.argsort(scalar.basic_dof_nodes()[0, nodes])]]

    def assembled_stiffness(self, mesh):
        """For the reaction at the top, without the contact brick."""
        constant = getfem.MeshFem(mesh, 1)
        constant.set_fem(getfem.Fem("FEM_QK(2,0)"))
        lame, shear = (value * np.ones(constant.nbdof()) for value in map(np.array, self.elasticity))
        return getfem.asm_linear_elasticity(self.integration, self.displacements, constant, lame, shear)

    def contact_model(self):
        n, dofs = len(self.x), self.displacements.nbdof()
        normal, tangential = getfem.Spmat("empty", n, dofs), getfem.Spmat("empty", n, dofs)
        for i in range(n):
            normal.add(i, int(self.across[i]), -1.0)
            tangential.add(i, int(self.along[i]), 1.0)
        model = getfem.Model("real")
        model.add_fem_variable("u", self.displacements)
        model.add_variable("normal_force", n)
        model.add_variable("friction_force", n)
        data = {
            "lame": self.elasticity[0],
            "shear": self.elasticity[1],
            "top": [0.0, 0.0],
            "r": [self.penalty],
            "mu": np.zeros(n),
            "gap": np.zeros(n),
            "area": self.area,
            "minus_one": [-1.0],  # the brick takes u + gamma w as the slip: here w is u at the end of the step before
            "before": np.zeros(dofs),
        }
        for name, value in data.items():
            model.add_initialized_data(name, value)
        model.add_isotropic_linearized_elasticity_brick(self.integration, "u", "lame", "shear")
        model.add_Dirichlet_condition_with_multipliers(self.integration, "u", self.displacements, 2, "top")
        model.add_basic_contact_brick(
            "u", "normal_force", "friction_force", "r", normal, tangential, "mu", "gap", "area", 1, "minus_one",
            "before",
        )
        return model

    def solve(self, mu):
        self.model.set_variable("mu", mu)
        iterations, converged = self.model.solve(
            "max_res", 1e-17 * self.forces, "max_iter", 60, "lsolver", "mumps", "lsearch", "simplest", "alpha min", 0.8
        )
        if not converged:
            raise RuntimeError(f"Newton's method has not converged after {iterations} iterations")

    def move_top(self, x, y):
        self.model.set_variable("before", self.model.variable("u"))
        self.model.set_variable("top", [x, y])

    def pressure(self):
        return -self.model.variable("normal_force") / self.area

    def traction(self):
        return self.model.variable("friction_force") / self.area

    def slip(self):
        return (self.model.variable("u") - self.model.variable("before"))[self.along]

    def reaction(self):
        """Force of the block on what holds its top, (x, y), from the elastic forces there."""
        force = self.stiffness.mult(self.model.variable("u"))
        top = np.array(self.top)
        return -np.array([force[top[0::2]].sum(), force[top[1::2]].sum()])


def settle(block, mu, law):
    """Solves until the coefficients belong to the pressures; returns them and how often it solved."""
    for rounds in range(1, 40):
        block.solve(mu)
        pressure = np.maximum(block.pressure(), 0.0)
        new = law(pressure)
        change, mu = np.max(np.abs(new - mu) * pressure) / np.max(pressure), new  # of mu alone is nothing at p = 0
        if change < 1e-11:
            return mu, rounds
    raise RuntimeError(f"friction still changes by {change:.1e} of the pressure after {rounds} solutions")


def shear(law, block, guess, press, path):
    """Presses the block, then shears it; returns the state after each step and the solutions per step."""
    states, mu = [], np.full(len(block.x), guess)
    for top in [0.0, *path]:
        block.move_top(top, -press)
        mu, rounds = settle(block, mu, law)
        states.append(
            dict(
                x=block.x, area=block.area, mu=mu, rounds=rounds, pressure=block.pressure(), traction=block.traction(),
                slip=block.slip(), reaction=block.reaction(), press=press,
            )
        )
    return states


def exact_traction(model, pressure):
    """From the integrals, not from the compiled law that the solution used; of nodes that have come off the floor, none."""
    area = model.params.nominal_area
    return np.array([model.state_at_load(p * area).friction_force if p > 0 else 0.0 for p in pressure]) / area


def state_error(state, exact):
    """How far one state is from Coulomb's conditions with the exact traction, and from equilibrium."""
    slipping, on_floor = np.abs(state["slip"]) > 5e-7 * state["press"], exact > 0
    ratio = np.abs(state["traction"]) / np.where(on_floor, exact, 1)
    errors = [
        np.max(np.abs(ratio[slipping & on_floor] - 1), initial=0.0),  # slips at the traction of the law,
        np.max(ratio[~slipping] - 1, initial=0.0),  # sticks below it,
        1.0 * np.any((state["traction"] * state["slip"])[slipping] > 0),  # and against the slip
    ]
    load = np.sum(state["pressure"] * state["area"])
    friction = np.sum(state["traction"] * state["area"])
    errors.append(np.max(np.abs(state["reaction"] - [friction, load])) / load)
    return float(np.max(errors)), int(np.sum(slipping))  # np.max keeps NaN


def check(model, states):
    """Worst error of all steps; demands that one step has stick and slip and that the last slips everywhere."""
    results = [state_error(s, exact_traction(model, s["pressure"])) for s in states]
    nodes = len(states[0]["x"])
    slipping = [n for _, n in results]
    if not any(0 < n < nodes for n in slipping) or slipping[-1] != nodes:
        raise RuntimeError(f"slipping nodes of {nodes} are {slipping}: expected some, then all")
    print(f"  slipping nodes of {nodes} after each step: {slipping}")
    print(f"  solutions that each step took: {[s['rounds'] for s in states]}")
    pressures = np.concatenate([s["pressure"] for s in states])
    pressures = pressures[pressures > 0.02 * np.mean(pressures)]  # what comes off the floor has few summits on it
    # A side of 1 mm2 is how thick the block is.
    smallest = states[0]["area"].min() * model.params.asperity_count / model.params.nominal_area**0.5
    surface.demand(model, pressures.min() * model.params.nominal_area, pressures.max() * model.params.nominal_area, smallest)
    return float(np.max([error for error, _ in results]))


def sheared(young=210e9, poisson=0.3, elements=(32, 16), press=PRESS, path=SHEAR, length=1e-3, force=1.0, guess=None, penalty=1.0,
            change=None, measured=None):  # fmt: skip
    """The worst error of a block whose numbers have other units of length and force. A hard film is on block and floor."""
    stress = length**2 / force  # of 1 Pa
    area = 1e-6 / length**2  # 1 mm2
    params = surface.surface(area, length, force).replace(**change or {})
    model = asperity.Model(params.calibrated(measured[0] * stress * area, measured[1]) if measured else params)
    pushed = press * HEIGHT * 1e-3 / length
    block = Block(young * stress, poisson, 1e-3 / length, elements, penalty)
    mean = young * stress / (1 - poisson**2) * press  # pressure of the block without friction
    first = model.state_at_load(mean * area).friction_coefficient if guess is None else guess
    return check(model, shear(lambda pressure: model.friction_at_load(pressure * area), block, first, pushed, path * pushed))


def main():
    (error,) = habits.worst(HABITS, sheared)
    return error <= LIMIT, f"max |traction / mu(p) p - 1|, imbalance = {error:.1e} (limit {LIMIT:.0e}), {len(HABITS)} habits"


if __name__ == "__main__":
    verdict.run("getfem", main)
