"""A block in FEniCSx that is pressed on a rough floor and pushed along it. The floor is a penalty along the normal and regularised Coulomb
friction across it, of which Newton's method has force and slope from the law at each node. Each input is changed once. Units: mm, N, MPa,
unless a habit has others.
"""

import sys
from pathlib import Path

import asperity
import numpy as np
import ufl
from dolfinx import fem, mesh
from mpi4py import MPI
from petsc4py import PETSc

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import habits  # of hosts/
import surface
import verdict

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


class Block:
    """The elastic block on its floor. `law` is of one unit of area: its loads are pressures."""

    def __init__(self, law, young, poisson, size, elements, penalty, onset):
        corner = np.array([size * LENGTH, size * HEIGHT])
        self.law, self.lightest = law, 1e-6 * young
        domain = mesh.create_rectangle(MPI.COMM_SELF, [[0, 0], corner], elements, mesh.CellType.quadrilateral)
        space, scalars = fem.VectorFunctionSpace(domain, ("Lagrange", 1)), fem.FunctionSpace(domain, ("Lagrange", 1))
        self.u, self.before, v = fem.Function(space), fem.Function(space), ufl.TestFunction(space)
        self.force, self.slope, self.at = (fem.Function(scalars) for _ in range(3))
        floor, top = (mesh.locate_entities_boundary(domain, 1, lambda x, y=y: np.isclose(x[1], y)) for y in (0, corner[1]))
        self.nodes = fem.locate_dofs_topological(scalars, 1, floor)
        self.top = fem.locate_dofs_topological(space, 1, top)
        tags = mesh.meshtags(domain, 1, np.sort(floor), np.ones(len(floor), np.int32))
        # At the nodes, so that each has its own pressure.
        on_floor = ufl.Measure("ds", domain, subdomain_data=tags, metadata={"quadrature_rule": "GLL", "quadrature_degree": 1})(1)
        lame, shear, self.penalty, self.onset = (fem.Constant(domain, PETSc.ScalarType(value)) for value in (
            young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson), penalty * young / corner[1], onset))  # fmt: skip

        strain = ufl.sym(ufl.grad(self.u))
        stress = lame * ufl.tr(strain) * ufl.Identity(2) + 2 * shear * strain
        elastic = ufl.inner(stress, ufl.sym(ufl.grad(v))) * ufl.dx
        pressure = ufl.conditional(self.u[1] < 0, -self.penalty * self.u[1], 0)
        slip = self.u[0] - self.before[0]
        # The law at the pressure of the iteration before, and on from there with its slope: Newton's method has the whole tangent.
        friction = (self.force + self.slope * (pressure - self.at)) * slip / ufl.sqrt(slip**2 + self.onset**2)
        residual = elastic + (friction * v[0] - pressure * v[1]) * on_floor
        self.residual, self.tangent = fem.form(residual), fem.form(ufl.derivative(residual, self.u))
        self.elastic, self.shares = fem.form(elastic), fem.form(ufl.TestFunction(scalars) * on_floor)
        self.moved = fem.Constant(domain, PETSc.ScalarType((0, 0)))
        self.held = [fem.dirichletbc(self.moved, self.top, space)]
        self.area = fem.petsc.assemble_vector(self.shares).array[self.nodes]
        self.solver = PETSc.KSP().create(MPI.COMM_SELF)
        self.solver.setType("preonly")
        self.solver.getPC().setType("lu")

    def displacements(self):
        return self.u.x.array.reshape(-1, 2)

    def pressures(self):
        return np.maximum(-self.penalty.value * self.displacements()[self.nodes, 1], 0)

    def missing(self):
        """The residual, with force and slope of the law at the pressures that the nodes have."""
        found = self.pressures()
        touching = np.maximum(found, 1e-12 * found.max() or self.lightest)
        force, slope = self.law.friction_force_at_load(touching, slope=True)
        for one, values in ((self.force, force), (self.slope, slope), (self.at, touching)):
            one.x.array[self.nodes] = values
        rest = fem.petsc.assemble_vector(self.residual)
        fem.petsc.apply_lifting(rest, [self.tangent], [self.held], [self.u.vector], -1.0)
        fem.petsc.set_bc(rest, self.held, self.u.vector, -1.0)
        return rest

    def push(self, moved):
        """One step, the top to where it must be, by Newton's method with a line search."""
        self.before.x.array[:] = self.u.x.array
        self.moved.value = moved
        rest = self.missing()
        for iteration in range(100):
            matrix = fem.petsc.assemble_matrix(self.tangent, self.held)
            matrix.assemble()
            self.solver.setOperators(matrix)
            step, from_here, had = rest.duplicate(), self.u.x.array.copy(), rest.norm()
            self.solver.solve(rest, step)
            for part in 0.5 ** np.arange(8):
                self.u.x.array[:] = from_here - part * step.array
                rest = self.missing()
                if not iteration or rest.norm() < had:
                    break
            if iteration and not self.pressures().any():
                raise RuntimeError("no node touches")
            if np.max(np.abs(step.array)) < 1e-10 * np.max(np.abs(self.u.x.array)):
                return
        raise RuntimeError("Newton's method does not converge")

    def reaction(self):
        """On the top, by the elastic stiffness alone."""
        return fem.petsc.assemble_vector(self.elastic).array.reshape(-1, 2)[self.top].sum(axis=0)


def pushed(young=210e9, poisson=0.3, elements=(32, 16), press=PRESS, path=PUSH, length=1e-3, force=1.0, penalty=10.0, onset=1e-5,
           change=None, measured=None):  # fmt: skip
    """The worst error of friction and load of a block whose numbers have other units of length and force, relative to the load."""
    stress, area = length**2 / force, 1e-6 / length**2  # 1 Pa, and 1 mm2
    params = surface.surface(area, length, force).replace(**change or {})
    model = asperity.Model(params.calibrated(measured[0] * stress * area, measured[1]) if measured else params)
    down = press * HEIGHT * 1e-3 / length
    law = PerArea(model, area)
    block = Block(law, young * stress, poisson, 1e-3 / length, elements, penalty, abs(onset * down))
    errors = []
    for sideways in (0.0, *path):
        block.push((sideways * down, -down))
        pressure, slip = block.pressures(), (block.displacements() - block.before.x.array.reshape(-1, 2))[block.nodes, 0]
        exact = np.array([model.state_at_load(p * area).friction_force if p > 0 else 0.0 for p in pressure]) / area
        carried = np.sum(block.area * pressure)
        friction = np.sum(block.area * exact * slip / np.hypot(slip, block.onset.value))
        errors.append(np.max(np.abs(block.reaction() - [friction, -carried])) / carried)
    if not np.min(np.abs(slip)) > 10 * block.onset.value:
        raise RuntimeError("the block does not slide at the end")
    touching = pressure[pressure > 0.02 * np.mean(pressure)] * area
    surface.demand(model, touching.min(), touching.max(), block.area.min() * params.asperity_count / area**0.5)
    return max(errors)


class PerArea:
    """A law of which loads and forces are pressures."""

    def __init__(self, model, area):
        self.model, self.area = model, area

    def friction_force_at_load(self, pressure, slope):
        force, slopes = self.model.friction_force_at_load(pressure * self.area, slope=slope)
        return force / self.area, slopes


def main():
    (error,) = habits.worst(HABITS, pushed)
    return error <= LIMIT, f"friction and load of the block within {error:.1e} of the law at the nodes (limit {LIMIT:.0e}), {len(HABITS)} habits"


if __name__ == "__main__":
    verdict.run("fenicsx", main)
