"""Friction laws from contact physics: friction as a function of normal load for two rough, adhesive surfaces.

    import asperity

    print(asperity.friction("Si/Si", Sq=5e-9, Sdq=0.08, Sds=2e13, load=1e-3, nominal_area=1e-8))

`friction` returns a coefficient with its band in one call. `Params` and `Model` give all the rest: forces, slopes, stiffness,
exact states, warnings. The Rust library `libasperity` computes; it is inside the package, unless ASPERITY_LIBRARY names
another.
"""

from . import materials, study, surface
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
    "study",
    "surface",
    "uncertainty",
]
