"""Friction laws from contact physics: friction as a function of normal load for two rough, adhesive surfaces.

    from asperity import Model, Params

    model = Model(Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001))
    mu = model.friction_at_load(77.4)

The Rust library `libasperity` does the work; it is inside the package, unless ASPERITY_LIBRARY names another.
"""

from . import materials, surface
from ._header import ASPERITY_VERSION as __version__
from .errors import Error, Status
from .fit import Fit, fit
from .model import Model
from .params import Params
from .results import Hysteresis, State, Summary, ValidityWarning, Warnings

__all__ = [
    "Error",
    "Fit",
    "Hysteresis",
    "Model",
    "Params",
    "State",
    "Status",
    "Summary",
    "ValidityWarning",
    "Warnings",
    "__version__",
    "fit",
    "materials",
    "surface",
]
