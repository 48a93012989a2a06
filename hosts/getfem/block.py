"""Block in GetFEM: pressed on a rough floor and sheared, with a friction coefficient that follows the pressure node by
node. The contact brick takes the coefficients as given, so each load step is a fixed point of pressure and coefficient.
Units: mm, N, MPa.
"""

import sys
from pathlib import Path

import asperity
import getfem
import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import surface  # of hosts/
import verdict

getfem.util_trace_level(0)

LIMIT = 1e-6
LENGTH, HEIGHT = 40.0, 20.0  # thickness 1 mm, plane strain
YOUNG, POISSON = 2.1e5, 0.3
PRESS = 0.002  # what the top is pushed down by
SHEAR = 0.0003 * np.arange(1, 9)  # how far the top has gone sideways after each step
PARTIAL = 4  # a step before all has slipped
ELEMENTS = (32, 16)


class Block:
    """The elastic block, its nodes on the floor and the contact conditions there."""

    def __init__(self):
        x, y = (np.linspace(0, size, n + 1) for size, n in zip((LENGTH, HEIGHT), ELEMENTS))
        mesh = getfem.Mesh("cartesian", x, y)
        mesh.set_region(1, mesh.outer_faces_with_direction([0, -1], 0.01))
        mesh.set_region(2, mesh.outer_faces_with_direction([0, 1], 0.01))
        self.displacements = getfem.MeshFem(mesh, 2)
        self.displacements.set_fem(getfem.Fem("FEM_QK(2,2)"))
        self.integration = getfem.MeshIm(mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)"))
        self.find_contact_nodes(mesh)
        self.top = self.displacements.basic_dof_on_region(2)
        self.elasticity = [YOUNG * POISSON / (1 + POISSON) / (1 - 2 * POISSON)], [YOUNG / 2 / (1 + POISSON)]
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
            "r": [YOUNG / HEIGHT],
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
            "max_res", 1e-9, "max_iter", 60, "lsolver", "mumps", "lsearch", "simplest", "alpha min", 0.8
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


def shear(law, guess):
    """Presses the block, then shears it; returns the state after each step and the solutions per step."""
    block, states = Block(), []
    mu = np.full(len(block.x), guess)
    for top in [0.0, *SHEAR]:
        block.move_top(top, -PRESS)
        mu, rounds = settle(block, mu, law)
        states.append(
            dict(
                x=block.x, area=block.area, mu=mu, rounds=rounds, pressure=block.pressure(), traction=block.traction(),
                slip=block.slip(), reaction=block.reaction(),
            )
        )
    return states


def exact_traction(model, pressure):
    """From the integrals, not from the compiled law that the solution used."""
    return np.array([model.state_at_load(p).friction_force for p in pressure])


def state_error(state, exact):
    """How far one state is from Coulomb's conditions with the exact traction, and from equilibrium."""
    slipping = np.abs(state["slip"]) > 1e-9
    ratio = np.abs(state["traction"]) / exact
    errors = [
        np.max(np.abs(ratio[slipping] - 1), initial=0.0),  # slips at the traction of the law,
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
    if not 0 < slipping[PARTIAL] < nodes or slipping[-1] != nodes:
        raise RuntimeError(f"slipping nodes of {nodes} are {slipping}: expected some, then all")
    print(f"  slipping nodes of {nodes} after each step: {slipping}")
    print(f"  solutions that each step took: {[s['rounds'] for s in states]}")
    pressures = np.concatenate([s["pressure"] for s in states])
    smallest = states[0]["area"].min()  # mm^2, of which the model has one
    surface.demand(model, pressures.min(), pressures.max(), model.params.asperity_count * smallest)
    return float(np.max([error for error, _ in results]))


def main():
    mean = YOUNG / (1 - POISSON**2) * PRESS / HEIGHT  # pressure of the block without friction
    carbon = surface.surface(nominal_area=1.0, length=1e-3)  # a hard film on block and floor, per mm2
    error = 0.0
    for params in (carbon, carbon.replace(work_of_adhesion=carbon.work_of_adhesion / 3)):
        model = asperity.Model(params)
        states = shear(model.friction_at_load, model.state_at_load(mean).friction_coefficient)
        error = np.maximum(error, check(model, states))
    return error <= LIMIT, f"max |traction / mu(p) p - 1|, imbalance = {error:.1e} (limit {LIMIT:.0e})"


if __name__ == "__main__":
    verdict.run("getfem", main)
