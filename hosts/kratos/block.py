"""A steel block in Kratos that is pressed on a plate and pulled over it. Its ProjectParameters.json names the surface; here
are the mesh and the check: every node must bear the tangential traction mu(p) p of the exact law at its own pressure, and the
plate's supports what the nodes bear. usage: block.py
"""

import json
import os
import sys
import tempfile
from pathlib import Path

import KratosMultiphysics
import numpy as np
from KratosMultiphysics import ContactStructuralMechanicsApplication as Contact
from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import StructuralMechanicsAnalysis

import asperity
from asperity.kratos import Analysis

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import habits  # noqa: E402
import surface  # noqa: E402
import verdict  # noqa: E402

SURFACE = HERE.parent / "surface.toml"
AREA = 1e-4  # its nominal area
WIDTH, CELLS = 0.02, 10  # of the block; it is 1 m thick, as plane strain is
PRESSURE = 1e7  # LINE_LOAD
LAGGED_LIMIT, LIMIT = 1e-3, 1e-6
EQUILIBRIUM_LIMIT = 1e-4  # the shares of the nodes and the normals are those of the undeformed block


FIRST, PROCESS = "processes/contact/0/Parameters/friction_coefficients/0", "processes/contact/1/Parameters"
# What is changed: the project file by path, materials, the mesh of block and plate, and a line before the surface file or in place of one.
HABITS = {
    "half the load": dict(project={"processes/loads/0/Parameters/modulus": PRESSURE / 2}),
    "three times the load": dict(project={"processes/loads/0/Parameters/modulus": 3 * PRESSURE}),
    "twice as far": dict(project={"processes/constraints/1/Parameters/value/0": "2e-4*t"}),
    "the other way": dict(project={"processes/constraints/1/Parameters/value/0": "-1e-4*t"}),
    "half the step": dict(project={"solver_settings/time_stepping/time_step": 0.5}),
    "another first coefficient": dict(project={FIRST: 0.1}),
    "another surface": dict(words="work_of_adhesion = 0.02"), "calibrated": dict(words="calibration_friction_coefficient = 0.15\ncalibration_load = 1000"),
    "roughness of a profile": dict(words="Sdq = 0.05"),
    "Poisson's ratio 0": dict(material={"POISSON_RATIO": 0.0}), "Poisson's ratio 0.45": dict(material={"POISSON_RATIO": 0.45}),
    "aluminium": dict(material={"YOUNG_MODULUS": 70e9}), "a fine mesh": dict(cells=(20, 32)), "meshes that match": dict(cells=(10, 20)),
    "stresses in 100 Pa": dict(project={f"{PROCESS}/pascal": 1e-2}, stiffer=100.0),
    "no such pair": dict(project={f"{PROCESS}/pair": "3"}, refused="pair 3 of Structure: there is no such pair in contact_model_part"),
    "no first coefficient": dict(project={FIRST: 0.0}, refused="pair 0 of Structure: friction_coefficients of the contact process"),
    "pascal 0": dict(project={f"{PROCESS}/pascal": 0.0}, refused="pascal = 0: must be"),
    "pascal 1e-200": dict(project={f"{PROCESS}/pascal": 1e-200}, refused="at pressures up to 1."),
    "no file": dict(project={f"{PROCESS}/surface": "missing.toml"}, refused="missing.toml"),
    "a file without its area": dict(words="nominal_area = 0", refused="nominal_area"),
    "a height below 0": dict(words="Sq = -1", refused="Sq = -1: must be"),
    "no surface": dict(project={f"{PROCESS}/surface": ""}, refused='"surface" must name a surface file'),
    "a word of its own": dict(project={f"{PROCESS}/surfaces": "a.toml"}, refused="surfaces"),
}  # fmt: skip


def grid(part, name, properties, corner, size, cells):
    """A rectangle of elements; returns the numbers of its nodes by row and column."""
    sub = part.CreateSubModelPart(name)
    first = part.NumberOfNodes() + 1
    columns, rows = cells
    numbers = first + np.arange((rows + 1) * (columns + 1)).reshape(rows + 1, columns + 1)
    for (row, column), number in np.ndenumerate(numbers):
        place = corner[0] + size[0] * column / columns, corner[1] + size[1] * row / rows
        sub.CreateNewNode(int(number), *place, 0.0)
    for row in range(rows):
        for column in range(columns):
            square = [*numbers[row, column : column + 2], *numbers[row + 1, column : column + 2][::-1]]
            element = part.NumberOfElements() + 1
            sub.CreateNewElement("SmallDisplacementElement2D4N", element, [int(n) for n in square], properties)
    return numbers


def build(part, cells):
    plate_properties, block_properties = part.CreateNewProperties(1), part.CreateNewProperties(2)
    # The meshes of the two faces do not match.
    plate = grid(part, "Plate", plate_properties, (-WIDTH, -WIDTH / 2), (2 * WIDTH, WIDTH / 2), (cells[1], 4))
    block = grid(part, "Block", block_properties, (-WIDTH / 2, 0), (WIDTH, WIDTH / 4), (cells[0], 3))
    for name, nodes in (("Bottom", plate[0]), ("Top", block[-1]), ("Faces", [*plate[-1], *block[0]])):
        part.CreateSubModelPart(name).AddNodes([int(node) for node in nodes])
    top = part.GetSubModelPart("Top")
    for count, (left, right) in enumerate(zip(block[-1], block[-1][1:])):
        top.CreateNewCondition("LineLoadCondition2D2N", count + 1, [int(right), int(left)], block_properties)


def analysis_of(kind, changes=None, cells=(CELLS, 16)):
    """The project, with values by their paths changed."""
    project = json.loads((HERE / "ProjectParameters.json").read_text())
    for path, value in (changes or {}).items():
        *place, last = path.split("/")
        part = project
        for key in place:
            part = part[int(key) if isinstance(part, list) else key]
        part[int(last) if isinstance(part, list) else last] = value
    analysis = kind(KratosMultiphysics.Model(), KratosMultiphysics.Parameters(json.dumps(project)))
    build(analysis.model["Structure"], cells)
    return analysis


def nodal(part):
    """Pressures and tangential tractions of the block's lower face, and the nodes' shares of it."""
    nodes = sorted((node for node in part.GetSubModelPart("Block").Nodes if node.Y0 == 0), key=lambda node: node.X0)
    pressure = [-node.GetValue(Contact.AUGMENTED_NORMAL_CONTACT_PRESSURE) for node in nodes]
    traction = [node.GetValue(Contact.AUGMENTED_TANGENT_CONTACT_PRESSURE)[0] for node in nodes]
    share = np.full(len(nodes), WIDTH / (len(nodes) - 1))
    share[[0, -1]] /= 2
    return np.array(pressure), np.array(traction), share


def drag(kind):
    """Largest error of a node's traction in each step, of equilibrium in the last, and the pressures met."""
    law = asperity.Model(surface.surface(AREA))
    errors, met = [], []
    base = kind.FinalizeSolutionStep

    class Watched(kind):
        def FinalizeSolutionStep(self):
            base(self)
            self.pressure, self.traction, self.share = nodal(self.model["Structure"])
            exact = np.array([law.state_at_load(p * AREA).friction_force / AREA for p in self.pressure])
            # The block is pulled to the right: friction on it points to the left.
            errors.append(np.max(np.abs(-self.traction / exact - 1)))
            met.extend(self.pressure)

    analysis = analysis_of(Watched)
    analysis.Run()
    supports = analysis.model["Structure"].GetSubModelPart("Bottom").Nodes
    pull, weight = (
        sum(node.GetSolutionStepValue(reaction) for node in supports)
        for reaction in (KratosMultiphysics.REACTION_X, KratosMultiphysics.REACTION_Y)
    )
    borne = -analysis.traction @ analysis.share
    imbalance = np.max([abs(borne / -pull - 1), abs(weight / (PRESSURE * WIDTH) - 1)])
    imbalance = np.max([imbalance, abs(analysis.pressure @ analysis.share / weight - 1)])
    print(f"  {kind.__name__}: error of a node's traction, step by step: {', '.join(f'{e:.1e}' for e in errors)}")
    print(f"  pulled with {-pull:.0f} N, pressed with {weight:.0f} N: {-pull / weight:.4f}; equilibrium {imbalance:.1e}")
    return errors, imbalance, met


def altered(project=None, words="", material=None, cells=(CELLS, 16), stiffer=1.0):
    """The error of a node's traction, with what is changed; and of what the log says, once, of a surface that is not calibrated."""
    with tempfile.TemporaryDirectory() as folder:
        film, materials, log = (Path(folder) / name for name in ("film.toml", "materials.json", "log"))
        keys = [line.split(" =")[0] for line in words.splitlines()]
        kept = [line for line in SURFACE.read_text(encoding="utf-8").splitlines() if line.split(" =")[0] not in keys]
        place = kept.index("[roughness]") + 1 if keys and keys[0].startswith("S") else 0
        film.write_text("\n".join([*kept[:place], words, *kept[place:]]) + "\n", encoding="utf-8")
        if stiffer != 1:  # all its stresses are so many times as great
            surface.surface(AREA, force=1 / stiffer).replace(in_si=True, length_unit=1.0, force_unit=1.0).to_toml(film)
        of_materials = json.loads((HERE / "Materials.json").read_text())
        for each in of_materials["properties"]:
            each["Material"]["Variables"].update(material or {})
        materials.write_text(json.dumps(of_materials))
        given = {"solver_settings/material_import_settings/materials_filename": str(materials), f"{PROCESS}/surface": str(film), **(project or {})}
        output = KratosMultiphysics.FileLoggerOutput(str(log))
        KratosMultiphysics.Logger.AddOutput(output)
        try:
            analysis = analysis_of(Analysis, given, cells)
            analysis.Run()
        finally:
            KratosMultiphysics.Logger.Flush()
            KratosMultiphysics.Logger.RemoveOutput(output)
        pressure, traction, _ = nodal(analysis.model["Structure"])
        law, scale = asperity.Model(asperity.Params.from_toml(film)), AREA * stiffer
        exact = np.array([law.state_at_load(p * scale).friction_force / scale for p in pressure])
        to_the_left = "-1e-4*t" in given.values()  # friction on the block is against its motion
        said = log.read_text(encoding="utf-8").count("the strength of the interface is the default or that of other materials")
        return np.max(np.abs((1 if to_the_left else -1) * traction / exact - 1)), abs(said - ("calibration" not in words))


def main():
    os.chdir(HERE)
    KratosMultiphysics.Logger.GetDefaultOutput().SetSeverity(KratosMultiphysics.Logger.Severity.WARNING)
    lagged, imbalance, met = drag(StructuralMechanicsAnalysis)
    current, imbalance_current, met_current = drag(Analysis)
    met += met_current
    surface.demand(asperity.Model(surface.surface(AREA)), min(met) * AREA, max(met) * AREA)
    worst, untold = habits.worst(HABITS, altered)
    imbalance = np.max([imbalance, imbalance_current])
    # The first step has the coefficient of the project file: else this would not see which one Kratos uses.
    good = lagged[0] > LAGGED_LIMIT and lagged[-1] <= LAGGED_LIMIT and np.max(current) <= LIMIT
    good = good and imbalance <= EQUILIBRIUM_LIMIT and worst <= LIMIT and untold == 0
    return good, (
        f"max |t/p - mu(p)|/mu = {lagged[-1]:.1e} of the step before (limit {LAGGED_LIMIT:g}), "
        f"{np.maximum(worst, np.max(current)):.1e} of the step (limit {LIMIT:g}), {len(HABITS)} habits; equilibrium {imbalance:.1e}"
    )


if __name__ == "__main__":
    verdict.run("kratos", main)
