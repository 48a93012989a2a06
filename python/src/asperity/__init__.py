"""Friction laws from contact physics: friction as a function of normal load for two rough, adhesive surfaces.

    from asperity import Model, Params

    model = Model(Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001))
    mu = model.friction_at_load(77.4)

The Rust library `libasperity` does the work; it is inside the package, unless ASPERITY_LIBRARY names another.
"""

from . import materials, surface
from ._header import ASPERITY_VERSION as __version__
from ._pad_results import Pads
from ._microslip import Microslip, MicroslipStep
from .curve import Curve
from .errors import Error, Status
from .estimate import Estimate
from .fit import fit
from .fit_result import Fit, Prediction
from .model import Model
from .one_line import friction
from .pads import pads
from .params import Params
from .results import Hysteresis, State, States, Summary, SummitStates, ValidityWarning, Warnings
from .sensitivity import Sensitivities
from .uncertainty import Uncertainty, uncertainty

__all__ = [
    "Curve",
    "Error",
    "Estimate",
    "Fit",
    "Hysteresis",
    "Microslip",
    "MicroslipStep",
    "Model",
    "Pads",
    "Params",
    "Prediction",
    "Sensitivities",
    "State",
    "States",
    "Status",
    "Summary",
    "SummitStates",
    "Uncertainty",
    "ValidityWarning",
    "Warnings",
    "__version__",
    "fit",
    "friction",
    "materials",
    "pads",
    "surface",
    "uncertainty",
]
