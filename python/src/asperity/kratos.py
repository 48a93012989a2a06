"""The friction of contact in Kratos Multiphysics (ContactStructuralMechanicsApplication), as a process of its project file.

    {
        "python_module": "asperity.kratos",
        "Parameters": {"model_part_name": "Structure", "pair": "0", "surface": "surface.toml"}
    }

stands after the `alm_contact_process` whose pair it is. Every slave node has the coefficient of the law at its own
contact pressure: that of the step before, or with `asperity.kratos.Analysis` that of the step itself. In the first step the
`friction_coefficients` of the pair hold.
"""

from .hosts.kratos import Analysis, Factory, FrictionProcess

__all__ = ["Analysis", "Factory", "FrictionProcess"]
