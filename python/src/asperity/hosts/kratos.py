"""A process of Kratos; `asperity.kratos` has the names."""

from __future__ import annotations

from typing import Any

import numpy as np

try:
    import KratosMultiphysics
    from KratosMultiphysics import FRICTION_COEFFICIENT, ContactStructuralMechanicsApplication
    from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import (
        StructuralMechanicsAnalysis,
    )
except ImportError as error:
    raise ImportError(
        f"asperity.kratos needs Kratos ({error}): pip install KratosContactStructuralMechanicsApplication"
    ) from None

from ..errors import Error
from ..model import Model
from ..params import Params

__all__ = ["Analysis", "Factory", "FrictionProcess"]

_DEFAULTS = """{"model_part_name": "Structure", "pair": "0", "surface": "", "pascal": 1.0}"""


def Factory(settings: Any, model: Any) -> FrictionProcess:
    """Kratos makes the process of its project file by this."""
    return FrictionProcess(model, settings["Parameters"])


class FrictionProcess(KratosMultiphysics.Process):  # type: ignore[misc]
    """Gives the slave nodes of a pair the coefficients of friction of the law at their pressures."""

    def __init__(self, model: Any, settings: Any) -> None:
        super().__init__()
        settings.ValidateAndAssignDefaults(KratosMultiphysics.Parameters(_DEFAULTS))
        self._main = model[settings["model_part_name"].GetString()]
        self._pair = settings["pair"].GetString()
        self._pascal = settings["pascal"].GetDouble()
        if not self._pascal > 0:
            raise self._error(f"pascal = {self._pascal:g}: must be the model's stress for 1 Pa, 1e-6 for MPa")
        surface = settings["surface"].GetString()
        if not surface:
            raise self._error('"surface" must name a surface file')
        try:
            params = Params.from_toml(surface)
        except (Error, OSError) as error:  # which name the file
            raise self._error(str(error)) from None
        if not params.nominal_area > 0:
            raise self._error(f"{surface}: nominal_area must be given: loads are pressures")
        try:
            self.law = Model(params)
        except Error as error:
            raise self._error(f"{surface}: {error}") from None
        self.pressures: tuple[float, float] | None = None

    def _error(self, text: str) -> RuntimeError:
        return RuntimeError(f"asperity.kratos, pair {self._pair} of {self._main.Name}: {text}")

    def ExecuteBeforeSolutionLoop(self) -> None:
        """Moves the coefficient of the pair from its properties, which win over nodes, to its nodes."""
        part = f"Contact.ContactSub{self._pair}"
        if not self._main.HasSubModelPart(part):
            raise self._error("there is no such pair in contact_model_part, or no contact process before this one")
        self._part = self._main.GetSubModelPart(part)
        first = 0.0
        for properties in self._part.Properties:
            if properties.Has(FRICTION_COEFFICIENT):
                first = properties[FRICTION_COEFFICIENT]
                properties.Erase(FRICTION_COEFFICIENT)
        if not first > 0:
            raise self._error(
                "friction_coefficients of the contact process must be > 0: they hold until pressures are known, and "
                'contact_type must be "Frictional"'
            )
        for node in self._part.Nodes:
            node.SetValue(FRICTION_COEFFICIENT, first)

    def ExecuteInitializeSolutionStep(self) -> None:
        """Takes the law at the pressures that the step before left."""
        self.update()

    def ExecuteFinalize(self) -> None:
        """Warns if the model does not hold at the pressures that were met."""
        if self.pressures is None:
            return
        area = self.law.params.nominal_area
        warnings = self.law.check(*(pressure * area for pressure in self.pressures))
        if warnings:
            lightest, heaviest = self.pressures
            KratosMultiphysics.Logger.PrintWarning(
                "asperity.kratos", f"pair {self._pair}, from {lightest:.3g} to {heaviest:.3g} Pa: {warnings}"
            )

    def update(self) -> float:
        """Gives the nodes in contact the coefficients at their present pressures; the largest relative change."""
        nodes = [node for node in self._part.Nodes if node.Is(KratosMultiphysics.SLAVE)]
        nodes = [node for node in nodes if node.Is(KratosMultiphysics.ACTIVE) and self._pressure(node) > 0]
        if not nodes:
            return 0.0
        pressures = np.array([self._pressure(node) for node in nodes])
        try:
            friction = self.law.friction_at_load(pressures * self.law.params.nominal_area)
        except Error as error:
            raise self._error(f"at pressures up to {pressures.max():.3g} Pa: {error}") from None
        before = np.array([node.GetValue(FRICTION_COEFFICIENT) for node in nodes])
        for node, coefficient in zip(nodes, friction):
            node.SetValue(FRICTION_COEFFICIENT, float(coefficient))
        known = self.pressures or (np.inf, 0.0)
        self.pressures = min(known[0], float(pressures.min())), max(known[1], float(pressures.max()))
        return float(np.max(np.abs(friction / before - 1)))

    def _pressure(self, node: Any) -> float:
        """In Pa, positive in compression."""
        augmented = node.GetValue(ContactStructuralMechanicsApplication.AUGMENTED_NORMAL_CONTACT_PRESSURE)
        return float(-augmented / self._pascal)


class Analysis(StructuralMechanicsAnalysis):  # type: ignore[misc]
    """`StructuralMechanicsAnalysis` that solves each step again until friction is the law at the pressures of the step.

    In the place of `StructuralMechanicsAnalysis` in a MainKratos.py.
    """

    tolerance = 1e-9
    """Largest relative change of a coefficient from one solution of a step to the next."""
    most_solutions = 30
    """A step that needs more ends the analysis: take shorter steps."""

    def _CreateSolver(self) -> Any:
        solver = super()._CreateSolver()
        solve = solver.SolveSolutionStep

        def solve_until_settled() -> bool:
            processes = [p for p in self._GetListOfProcesses() if isinstance(p, FrictionProcess)]
            for _ in range(self.most_solutions):
                if not solve():
                    return False
                changes = [process.update() for process in processes]
                if max(changes, default=0.0) <= self.tolerance:
                    return True
            raise RuntimeError(
                f"asperity.kratos: friction and pressures do not settle in {self.most_solutions} solutions of a step "
                f"(change {max(changes):.1e}): take shorter steps"
            )

        solver.SolveSolutionStep = solve_until_settled
        return solver
