"""Two blocks with a rough interface in GetFEM: the pressure between them is the library's load at the gap (normal
compliance), with its slope in Newton's method. Under uniform pressure the displacement has a closed form. Units: mm, N, MPa. The law
is made for 1 mm2, so that its load is a pressure.
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
WIDTH, POISSON = 10.0, 0.3  # half of each block, the rest being its mirror image; thickness 1 mm, plane strain
LOWER, UPPER = 4.0, 3.0  # heights
YOUNG = 2.1e5, 0.7e5  # of the lower and the upper block
BETWEEN = 1.0  # drawn between the faces, so that they are not one
PRESSURES = 0.2 * 1.5 ** np.arange(11)  # 0.2 to 11.5 MPa, each from the one before
SETTLED = 1e-13  # a change of the opening, over that between the first and the last pressure
ORDER = 1.9  # of the convergence at least; Newton's method has 2


class Blocks:
    """The upper block on the lower one. Displacements are 0 where the interface has the first pressure and the blocks none."""

    def __init__(self, law):
        self.law = law
        self.at_rest = law.state_at_load(PRESSURES[0]).gap
        heights = np.concatenate([np.linspace(0, LOWER, 5), LOWER + BETWEEN + np.linspace(0, UPPER, 7)])
        self.mesh = getfem.Mesh("cartesian", np.linspace(0, WIDTH, 5), heights)
        self.mesh.del_convex([cv for cv in self.mesh.cvid() if LOWER < self.height(cv) < LOWER + BETWEEN])
        self.name_faces()
        self.integration = getfem.MeshIm(self.mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)"))
        self.points = getfem.MeshImData(self.integration, 4)
        self.model = self.linearised_model()

    def height(self, cv):
        """The height of the middle of an element."""
        return np.mean(self.mesh.pts_from_cvid(int(cv))[0][1])

    def name_faces(self):
        """1: the plane of symmetry, 2: the bottom, 3: the top, 4: the upper block's face on the interface."""
        down, up = (self.mesh.outer_faces_with_direction([0, way], 0.01) for way in (-1, 1))
        of_upper = [np.array([self.height(cv) > LOWER for cv in faces[0]]) for faces in (down, up)]
        self.mesh.set_region(1, self.mesh.outer_faces_with_direction([-1, 0], 0.01))
        self.mesh.set_region(2, down[:, ~of_upper[0]])
        self.mesh.set_region(3, up[:, of_upper[1]])
        self.mesh.set_region(4, down[:, of_upper[0]])

    def linearised_model(self):
        """Elastic, with the pressure of each point linear about the opening of the iteration before."""
        displacements, moduli, reactions = (getfem.MeshFem(self.mesh, size) for size in (2, 1, 1))
        displacements.set_fem(getfem.Fem("FEM_QK(2,2)"))
        moduli.set_fem(getfem.Fem("FEM_QK(2,0)"))
        reactions.set_fem(getfem.Fem("FEM_QK(2,2)"))
        model = getfem.Model("real")
        model.add_fem_variable("u", displacements)
        model.add_initialized_fem_data("E", moduli, np.where(moduli.basic_dof_nodes()[1] < LOWER, *YOUNG))
        model.add_initialized_data("nu", [POISSON])
        model.add_initialized_data("load", [0.0])
        model.add_initialized_data("lean", [0.0])
        for name in ("pressure", "slope", "opened"):
            model.add_im_data(name, self.points)
        model.add_interpolate_transformation_from_expression("below", self.mesh, self.mesh, f"X-[0;{BETWEEN!r}]")
        self.opening = "(u(2)-Interpolate(u,below)(2))"
        mim = self.integration
        model.add_linear_term(mim, "(E*nu/((1+nu)*(1-2*nu))*Div_u*Id(2)+E/(1+nu)*Sym(Grad_u)):Grad_Test_u")
        test = "(Test_u(2)-Interpolate(Test_u,below)(2))"
        model.add_linear_term(mim, f"-slope*{self.opening}*{test}", 4)
        model.add_source_term_generic_assembly_brick(mim, f"(pressure-slope*opened)*{test}", 4)
        model.add_source_term_generic_assembly_brick(mim, f"-load*(1+lean*(2*X(1)/{WIDTH!r}-1))*Test_u(2)", 3)
        for region in (1, 2):
            model.add_normal_Dirichlet_condition_with_multipliers(mim, "u", reactions, region)
        return model

    def openings(self):
        return self.model.interpolation(self.opening, self.points, 4)

    def solve(self, load):
        """Newton's method: the change of the openings in each iteration."""
        self.model.set_variable("load", [load])
        changes = []
        opened = self.openings()
        for _ in range(20):
            pressure, slope = self.law.load_at_gap(self.at_rest + opened, slope=True)
            for name, values in (("pressure", pressure), ("slope", slope), ("opened", opened)):
                self.model.set_variable(name, values)
            self.model.solve("lsolver", "mumps")
            before, opened = opened, self.openings()
            changes.append(np.max(np.abs(opened - before)))
            if changes[-1] <= SETTLED * self.at_rest:
                return changes
        raise RuntimeError(f"Newton's method has not converged at {load:g} MPa: {changes}")

    def top(self):
        """By how much the top has moved, at three places."""
        return self.model.interpolation("u(2)", [[0.0, WIDTH / 2, WIDTH], [LOWER + BETWEEN + UPPER] * 3], self.mesh)

    def exact_pressures(self):
        """From the integrals at the openings, not from the compiled law that the solution used; from the middle outwards."""
        order = np.argsort(self.model.interpolation("X(1)", self.points, 4))
        return np.array([self.law.state_at_gap(self.at_rest + opened).load for opened in self.openings()[order]])


def bars(load):
    """By how much both blocks together become shorter."""
    return load * (1 - POISSON**2) * (LOWER / YOUNG[0] + UPPER / YOUNG[1])


def order(changes):
    """The order of the convergence, from the last changes above rounding."""
    logs = np.log([change for change in changes if change > 1e-12 * changes[0]])
    return (logs[-1] - logs[-2]) / (logs[-2] - logs[-3])


def uniform(blocks):
    """Errors of the displacement of the top, over what the interface yields; orders of the convergence; iterations."""
    errors, orders, iterations = [], [], []
    blocks.solve(PRESSURES[0])
    for load in PRESSURES[1:]:
        changes = blocks.solve(load)
        interface = blocks.at_rest - blocks.law.state_at_load(load).gap
        errors.append(np.max(np.abs(blocks.top() + bars(load) + interface)) / interface)
        orders.append(order(changes))
        iterations.append(len(changes))
    print(f"  the interface yields {1e6 * interface:.1f} nm from {PRESSURES[0]:g} to {load:.3g} MPa, the blocks {1e3 * bars(load):.3g} um")
    return errors, orders, iterations


def leaning(blocks):
    """The load at the outer edge is 19 times that in the middle: does the interface carry all of it?"""
    blocks.model.set_variable("lean", [0.9])
    changes = blocks.solve(PRESSURES[-1])
    pressures = blocks.exact_pressures()
    weights = np.tile([5, 8, 5], len(pressures) // 3) / 18 * WIDTH / (len(pressures) // 3)  # of Gauss' points
    print(f"  under a load that leans the pressure is {pressures.min():.2f} to {pressures.max():.2f} MPa")
    if not pressures.max() > 2 * pressures.min():
        raise RuntimeError("the pressure of the load that leans is uniform")
    return abs(pressures @ weights / (PRESSURES[-1] * WIDTH) - 1), len(changes)


def main():
    law = asperity.Model(surface.surface(nominal_area=1.0, length=1e-3))
    surface.demand(law, PRESSURES[0], 2 * PRESSURES[-1])
    blocks = Blocks(law)
    errors, orders, iterations = uniform(blocks)
    imbalance, of_leaning = leaning(blocks)
    error, least = np.max(errors), np.min(orders)  # np.max keeps NaN
    print(f"  Newton's method converges with order {least:.3f} or more, in {max(*iterations, of_leaning)} iterations at most")
    good = error <= LIMIT and least >= ORDER and imbalance <= LIMIT
    return good, (
        f"load against gap: error of the displacement {error:.1e}, imbalance {imbalance:.1e} (limit {LIMIT:.0e}), order of "
        f"convergence {least:.2f} (limit {ORDER:g})"
    )


if __name__ == "__main__":
    verdict.run("getfem", main)
