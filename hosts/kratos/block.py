"""A steel block in Kratos that is pressed on a plate and pulled over it. Its ProjectParameters.json names the surface; here
are the mesh and the check: every node must bear the tangential traction mu(p) p of the exact law at its own pressure, and the
plate's supports what the nodes bear. usage: block.py
"""

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
import surface  # noqa: E402
import verdict  # noqa: E402

SURFACE = HERE.parent / "surface.toml"
AREA = 1e-4  # its nominal area
WIDTH, CELLS = 0.02, 10  # of the block; it is 1 m thick, as plane strain is
PRESSURE = 1e7  # LINE_LOAD
LAGGED_LIMIT, LIMIT = 1e-3, 1e-6
EQUILIBRIUM_LIMIT = 1e-4  # the shares of the nodes and the normals are those of the undeformed block


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


def build(part):
    plate_properties, block_properties = part.CreateNewProperties(1), part.CreateNewProperties(2)
    # The meshes of the two faces do not match.
    plate = grid(part, "Plate", plate_properties, (-WIDTH, -WIDTH / 2), (2 * WIDTH, WIDTH / 2), (16, 4))
    block = grid(part, "Block", block_properties, (-WIDTH / 2, 0), (WIDTH, WIDTH / 4), (CELLS, 3))
    for name, nodes in (("Bottom", plate[0]), ("Top", block[-1]), ("Faces", [*plate[-1], *block[0]])):
        part.CreateSubModelPart(name).AddNodes([int(node) for node in nodes])
    top = part.GetSubModelPart("Top")
    for count, (left, right) in enumerate(zip(block[-1], block[-1][1:])):
        top.CreateNewCondition("LineLoadCondition2D2N", count + 1, [int(right), int(left)], block_properties)


def analysis_of(kind, change=lambda parameters: None):
    parameters = KratosMultiphysics.Parameters((HERE / "ProjectParameters.json").read_text())
    change(parameters)
    analysis = kind(KratosMultiphysics.Model(), parameters)
    build(analysis.model["Structure"])
    return analysis


def nodal(part):
    """Pressures and tangential tractions of the block's lower face, and the nodes' shares of it."""
    nodes = sorted((node for node in part.GetSubModelPart("Block").Nodes if node.Y0 == 0), key=lambda node: node.X0)
    pressure = [-node.GetValue(Contact.AUGMENTED_NORMAL_CONTACT_PRESSURE) for node in nodes]
    traction = [node.GetValue(Contact.AUGMENTED_TANGENT_CONTACT_PRESSURE)[0] for node in nodes]
    share = np.full(len(nodes), WIDTH / CELLS)
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


def process_of(parameters, number):
    return parameters["processes"]["contact"][number]["Parameters"]


def check_altered(folder):
    """Each input changed once, and the project as it is before and after: a node's traction is that of the law at its pressure."""
    files = {name: str(folder / f"{name}.toml") for name in ("slippery", "stiffer")}
    as_it_is, slippery = surface.surface(AREA), surface.surface(AREA).replace(work_of_adhesion=0.02)
    slippery.to_toml(files["slippery"])
    surface.surface(AREA, force=1e-2).replace(in_si=True, length_unit=1.0, force_unit=1.0).to_toml(files["stiffer"])  # all its stresses are 100 times as great

    def in_hectopascal(parameters):
        process_of(parameters, 1)["surface"].SetString(files["stiffer"])
        process_of(parameters, 1).AddDouble("pascal", 1e-2)

    alterations = {
        "as it is": (lambda p: None, as_it_is),
        "half the load": (lambda p: p["processes"]["loads"][0]["Parameters"]["modulus"].SetDouble(PRESSURE / 2), as_it_is),
        "twice as far": (
            lambda p: p["processes"]["constraints"][1]["Parameters"]["value"][0].SetString("2e-4*t"), as_it_is,
        ),
        "another surface": (lambda p: process_of(p, 1)["surface"].SetString(files["slippery"]), slippery),
        "stresses in 100 Pa": (in_hectopascal, as_it_is),
        "another first coefficient": (lambda p: process_of(p, 0)["friction_coefficients"]["0"].SetDouble(0.1), as_it_is),
        "as it is, again": (lambda p: None, as_it_is),
    }  # fmt: skip
    pressures = {}
    for name, (change, params) in alterations.items():
        analysis = analysis_of(Analysis, change)
        analysis.Run()
        pressure, traction, _ = nodal(analysis.model["Structure"])
        law, pressures[name] = asperity.Model(params), pressure.tobytes()
        exact = np.array([law.state_at_load(p * AREA).friction_force / AREA for p in pressure])
        error = np.max(np.abs(-traction / exact - 1))
        print(f"  {name}: {pressure.min():.3g} to {pressure.max():.3g} Pa, error of a node's traction {error:.1e}")
        if not error <= LIMIT:
            raise RuntimeError(f"{name}: error of a node's traction {error:.1e}")
    if pressures["as it is, again"] != pressures["as it is"]:
        raise RuntimeError("after the others the project does not give the same bits again")


def check_measured_point_and_warnings(folder):
    """A point that was measured at the mean pressure, in the surface file, is met at each node; and each run says once, in
    Kratos' log, what holds of the model and what not: of the file without the point that it is not calibrated."""
    text = SURFACE.read_text(encoding="utf-8")
    file = folder / "measured.toml"
    load, mu = PRESSURE * AREA, 0.15
    uncalibrated = "the strength of the interface is the default or that of other materials, not a measured one"
    for key, value in ((None, None), ("calibration_friction_coefficient", mu), ("calibration_friction_force", mu * load)):
        file.write_text((f"calibration_load = {load!r}\n{key} = {value!r}\n" if key else "") + text, encoding="utf-8")
        log = folder / f"{key}.log"
        output = KratosMultiphysics.FileLoggerOutput(str(log))
        KratosMultiphysics.Logger.AddOutput(output)
        analysis = analysis_of(Analysis, lambda p: process_of(p, 1)["surface"].SetString(str(file)))
        analysis.Run()
        KratosMultiphysics.Logger.Flush()
        KratosMultiphysics.Logger.RemoveOutput(output)
        pressure, traction, _ = nodal(analysis.model["Structure"])
        law = asperity.Model(asperity.Params.from_toml(file))
        error = np.max(np.abs(-traction / (law.friction_at_load(pressure * AREA) * pressure) - 1))
        if not error <= LIMIT:
            raise RuntimeError(f"{key}: error of a node's traction {error:.1e}")
        said = log.read_text(encoding="utf-8").count(uncalibrated)
        if said != (0 if key else 1):
            raise RuntimeError(f"{key}: the log says {said} times that the surface is not calibrated")
    print("  a measured point in the surface file is met; without one the log says once that there is none")


def check_refusals(folder):
    """What cannot work must be refused, in words that name Kratos' own element."""
    bad = str(folder / "bad.toml")
    surface.surface(AREA).replace(height_std=-1.0).to_toml(bad)
    measured = str(folder / "measured_without_area.toml")
    surface.surface(AREA).calibrated(10, 0.2).replace(nominal_area=0.0).to_toml(measured)
    wrong = {
        "there is no such pair in contact_model_part": lambda p: process_of(p, 1)["pair"].SetString("3"),
        "friction_coefficients of the contact process": lambda p: process_of(p, 0)["friction_coefficients"]["0"].SetDouble(0),
        "pascal = 0: must be": lambda p: process_of(p, 1).AddDouble("pascal", 0),
        "at pressures up to 1.": lambda p: process_of(p, 1).AddDouble("pascal", 1e-200),
        "missing.toml": lambda p: process_of(p, 1)["surface"].SetString("missing.toml"),
        f"{measured}: nominal_area must be given": lambda p: process_of(p, 1)["surface"].SetString(measured),
        "height_std = -1: must be": lambda p: process_of(p, 1)["surface"].SetString(bad),
        '"surface" must name a surface file': lambda p: process_of(p, 1).RemoveValue("surface"),
    }
    for message, change in wrong.items():
        try:
            analysis_of(StructuralMechanicsAnalysis, change).Run()
        except RuntimeError as error:
            if message not in str(error) or "asperity.kratos, pair " not in str(error):
                raise RuntimeError(f"refused without saying '{message}': {error}") from None
        else:
            raise RuntimeError(f"not refused: {message}")
    print(f"  {len(wrong)} projects that cannot work are refused")


def main():
    os.chdir(HERE)
    KratosMultiphysics.Logger.GetDefaultOutput().SetSeverity(KratosMultiphysics.Logger.Severity.WARNING)
    lagged, imbalance, met = drag(StructuralMechanicsAnalysis)
    current, imbalance_current, met_current = drag(Analysis)
    met += met_current
    surface.demand(asperity.Model(surface.surface(AREA)), min(met) * AREA, max(met) * AREA)
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(Path(folder))
        check_measured_point_and_warnings(Path(folder))
        check_altered(Path(folder))
    imbalance = np.max([imbalance, imbalance_current])
    # The first step has the coefficient of the project file: else this would not see which one Kratos uses.
    good = lagged[0] > LAGGED_LIMIT and lagged[-1] <= LAGGED_LIMIT and np.max(current) <= LIMIT
    good = good and imbalance <= EQUILIBRIUM_LIMIT
    return good, (
        f"max |t/p - mu(p)|/mu = {lagged[-1]:.1e} of the step before (limit {LAGGED_LIMIT:g}), "
        f"{np.max(current):.1e} of the step (limit {LIMIT:g}); equilibrium {imbalance:.1e}"
    )


if __name__ == "__main__":
    verdict.run("kratos", main)
