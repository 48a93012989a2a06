"""Two blocks with a rough interface in GetFEM: the pressure between them is the library's load at the gap (normal
compliance), with its slope in Newton's method. Under uniform pressure the displacement has a closed form. Each input is changed once.
Units: mm, N, MPa, unless a habit has others. The law is made for 1 mm2, so that in mm its load is a pressure.
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
WIDTH = 10.0  # half of each block, the rest being its mirror image; thickness 1 mm, plane strain
LOWER, UPPER = 4.0, 3.0  # heights
YOUNG = 210e9, 70e9  # of the lower and the upper block [Pa]
BETWEEN = 1.0  # drawn between the faces, so that they are not one
PRESSURES = 0.2 * 1.5 ** np.arange(11)  # 0.2 to 11.5 MPa, each from the one before
SETTLED = 1e-13  # a change of the opening, over that between the first and the last pressure
ORDER = 1.9  # of the convergence at least; Newton's method has 2
HABITS = {
    "m, Pa": dict(length=1.0), "um, N": dict(length=1e-6), "cm, kN": dict(length=1e-2, force=1e3), "Poisson's ratio 0": dict(poisson=0.0),
    "Poisson's ratio 0.45": dict(poisson=0.45), "two soft blocks": dict(young=(70e9, 70e9)), "half the mesh": dict(cells=(2, 2, 3)),
    "a fine mesh": dict(cells=(12, 6, 4)), "a tenth of the load": dict(pressures=PRESSURES / 10), "steps of 1.2": dict(pressures=0.2 * 1.2 ** np.arange(23)),
    "unloaded": dict(pressures=PRESSURES[::-1]), "fewer summits": dict(summits=0.8), "no adhesion": dict(adhesion=0.0),
}  # fmt: skip


class Blocks:
    """The upper block on the lower one. Displacements are 0 where the interface has the first pressure and the blocks none."""

    def __init__(self, law, first, young, poisson, cells, unit):
        self.law, self.young, self.poisson, self.unit = law, young, poisson, unit
        self.area = law.params.nominal_area
        self.at_rest = law.state_at_load(first * self.area).gap
        heights = np.concatenate([np.linspace(0, LOWER, cells[1] + 1), LOWER + BETWEEN + np.linspace(0, UPPER, cells[2] + 1)])
        self.mesh = getfem.Mesh("cartesian", np.linspace(0, WIDTH, cells[0] + 1) * unit, heights * unit)
        self.mesh.del_convex([cv for cv in self.mesh.cvid() if LOWER < self.height(cv) < LOWER + BETWEEN])
        self.name_faces()
        self.integration = getfem.MeshIm(self.mesh, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)"))
        self.points = getfem.MeshImData(self.integration, 4)
        self.model = self.linearised_model()

    def height(self, cv):
        """The height of the middle of an element [mm]."""
        return np.mean(self.mesh.pts_from_cvid(int(cv))[0][1]) / self.unit

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
        model.add_initialized_fem_data("E", moduli, np.where(moduli.basic_dof_nodes()[1] < LOWER * self.unit, *self.young))
        model.add_initialized_data("nu", [self.poisson])
        model.add_initialized_data("load", [0.0])
        model.add_initialized_data("lean", [0.0])
        for name in ("pressure", "slope", "opened"):
            model.add_im_data(name, self.points)
        model.add_interpolate_transformation_from_expression("below", self.mesh, self.mesh, f"X-[0;{BETWEEN * self.unit!r}]")
        self.opening = "(u(2)-Interpolate(u,below)(2))"
        mim = self.integration
        model.add_linear_term(mim, "(E*nu/((1+nu)*(1-2*nu))*Div_u*Id(2)+E/(1+nu)*Sym(Grad_u)):Grad_Test_u")
        test = "(Test_u(2)-Interpolate(Test_u,below)(2))"
        model.add_linear_term(mim, f"-slope*{self.opening}*{test}", 4)
        model.add_source_term_generic_assembly_brick(mim, f"(pressure-slope*opened)*{test}", 4)
        model.add_source_term_generic_assembly_brick(mim, f"-load*(1+lean*(2*X(1)/{WIDTH * self.unit!r}-1))*Test_u(2)", 3)
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
            load_of_points, slope = self.law.load_at_gap(self.at_rest + opened, slope=True)
            for name, values in (("pressure", load_of_points / self.area), ("slope", slope / self.area), ("opened", opened)):
                self.model.set_variable(name, values)
            self.model.solve("lsolver", "mumps")
            before, opened = opened, self.openings()
            changes.append(np.max(np.abs(opened - before)))
            if changes[-1] <= SETTLED * self.at_rest:
                return changes
        raise RuntimeError(f"Newton's method has not converged at a pressure of {load:g}: {changes}")

    def top(self):
        """By how much the top has moved, at three places."""
        return self.model.interpolation("u(2)", self.unit * np.array([[0.0, WIDTH / 2, WIDTH], [LOWER + BETWEEN + UPPER] * 3]), self.mesh)

    def exact_pressures(self):
        """From the integrals at the openings, not from the compiled law that the solution used; from the middle outwards."""
        order = np.argsort(self.model.interpolation("X(1)", self.points, 4))
        return np.array([self.law.state_at_gap(self.at_rest + opened).load for opened in self.openings()[order]]) / self.area


def order(changes):
    """The order of the convergence, from the last changes above rounding."""
    logs = np.log([change for change in changes if change > 1e-12 * changes[0]])
    return (logs[-1] - logs[-2]) / (logs[-2] - logs[-3])


def uniform(blocks, pressures):
    """Errors of the displacement of the top, over what the interface yields; orders of the convergence; iterations."""
    errors, orders, iterations = [], [], []
    blocks.solve(pressures[0])
    bars = blocks.unit * (1 - blocks.poisson**2) * (LOWER / blocks.young[0] + UPPER / blocks.young[1])  # both together, under a pressure of 1
    for load in pressures[1:]:
        changes = blocks.solve(load)
        interface = blocks.at_rest - blocks.law.state_at_load(load * blocks.area).gap
        errors.append(np.max(np.abs(blocks.top() + bars * load + interface)) / abs(interface))
        orders.append(order(changes))
        iterations.append(len(changes))
    print(f"  the interface yields {1e6 * interface / blocks.unit:.1f} nm from {pressures[0]:g} to {load:.3g}, the blocks {1e3 * bars * load / blocks.unit:.3g} um")
    return errors, orders, iterations


def leaning(blocks, load):
    """The load at the outer edge is 19 times that in the middle: does the interface carry all of it?"""
    blocks.model.set_variable("lean", [0.9])
    changes = blocks.solve(load)
    pressures = blocks.exact_pressures()
    weights = np.tile([5, 8, 5], len(pressures) // 3) / 18 / (len(pressures) // 3)  # of Gauss' points
    print(f"  under a load that leans the pressure is {pressures.min():.3g} to {pressures.max():.3g}")
    if not pressures.max() > 2 * pressures.min():
        raise RuntimeError("the pressure of the load that leans is uniform")
    return abs(pressures @ weights / load - 1), len(changes)


def pressed(young=YOUNG, poisson=0.3, cells=(4, 4, 6), pressures=PRESSURES, length=1e-3, force=1.0, summits=1.0, adhesion=None):
    """Errors of displacement and of equilibrium, and what the order of convergence lacks, in units of length and force."""
    megapascal = 1e6 * length**2 / force
    params = surface.surface(1e-6 / length**2, length, force)
    params = params.replace(asperity_count=summits * params.asperity_count, work_of_adhesion=params.work_of_adhesion if adhesion is None else adhesion)
    law, pressures = asperity.Model(params), pressures * megapascal
    surface.demand(law, pressures.min() * params.nominal_area, 2 * pressures.max() * params.nominal_area)
    blocks = Blocks(law, pressures[0], np.array(young) * 1e-6 * megapascal, poisson, cells, 1e-3 / length)
    errors, orders, iterations = uniform(blocks, pressures)
    imbalance, of_leaning = leaning(blocks, pressures[-1])
    print(f"  Newton's method converges with order {np.min(orders):.3f} or more, in {max(*iterations, of_leaning)} iterations at most")
    return np.max(errors), imbalance, 2 - np.min(orders)  # np.max keeps NaN


def main():
    error, imbalance, lacks = habits.worst(HABITS, pressed)
    return max(error, imbalance) <= LIMIT and 2 - lacks >= ORDER, (
        f"load against gap: error of the displacement {error:.1e}, imbalance {imbalance:.1e} (limit {LIMIT:.0e}), order of convergence "
        f"{2 - lacks:.2f} (limit {ORDER:g}), {len(HABITS)} habits"
    )


if __name__ == "__main__":
    verdict.run("getfem", main)
