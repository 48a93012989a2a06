"""The pushed block of hosts/pushed.py in FEniCSx. The floor is a penalty along the normal and regularised Coulomb friction across it, of which
Newton's method has force and slope from the law at each node.
"""

import sys
from pathlib import Path

import numpy as np
import ufl
from dolfinx import fem, mesh
from mpi4py import MPI
from petsc4py import PETSc

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import pushed  # of hosts/
import verdict


class Block:
    """The elastic block on its floor. `law` is of one unit of area: its loads are pressures."""

    def __init__(self, law, young, poisson, size, elements, penalty, onset):
        corner = np.array([size * pushed.LENGTH, size * pushed.HEIGHT])
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


class PerArea:
    """A law of which loads and forces are pressures."""

    def __init__(self, model, area):
        self.model, self.area = model, area

    def friction_force_at_load(self, pressure, slope):
        force, slopes = self.model.friction_force_at_load(pressure * self.area, slope=slope)
        return force / self.area, slopes


def steps(model, area, young, poisson, size, elements, penalty, onset, moves):
    block = Block(PerArea(model, area), young, poisson, size, elements, penalty, onset)
    for move in moves:
        block.push(move)
        slip = (block.displacements() - block.before.x.array.reshape(-1, 2))[block.nodes, 0]
        yield block.reaction(), block.area, block.pressures(), slip


if __name__ == "__main__":
    verdict.run("fenicsx", pushed.main, steps)
