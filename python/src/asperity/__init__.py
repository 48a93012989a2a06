"""Friction laws from contact physics: friction as a function of normal load for two rough, adhesive surfaces.

    import asperity

    print(asperity.friction("Si/Si", Sq=5e-9, Sdq=0.08, Sds=2e13, load=1e-3, nominal_area=1e-8))

It prints the friction coefficient of two materials with its band, from what is known of the surfaces. What people use:

    friction(pair, load=..., ...)   a coefficient with its band, at a load or many; .plot() draws it
    Params.si, .from_profile, ...   two surfaces as numbers: from summits, a profile, a map, a file
    Model(params)                   friction, stiffness, exact states and warnings at any load
    Model(params).curve().plot()    friction over a range of loads
    params.calibrated(load, mu)     the strength of the interface from one measurement
    fit(load, mu, params=params)    parameters from several measurements
    surface.analyse(map, load, ...) from a measured height map to friction and a verdict on the map
    uncertainty, study, pads        bands, many surfaces, few contacts
    materials                       MATERIALS, PAIRS, INTERFACES

The same at the command line: python -m asperity friction -h. Units are SI in `friction`; a `Model` takes any consistent system.
The Rust library `libasperity` computes. It is inside the package, unless the environment variable ASPERITY_LIBRARY names another.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import materials
from ._header import ASPERITY_VERSION as __version__
from ._microslip import Microslip, MicroslipStep
from .curve import Curve
from .errors import Error, Status
from .estimate import Estimate
from .fits.fit import fit
from .fits.result import Fit, Prediction
from .fits.uncertainty import Uncertainty, uncertainty
from .model import Model
from .one_line import friction
from .params import Params
from .results import Hysteresis, State, States, Summary, ValidityWarning, Warnings
from .studies.pads import Pads, pads

if TYPE_CHECKING:
    from . import study, surface

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
    "State",
    "States",
    "Status",
    "Summary",
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


def __getattr__(name: str) -> Any:
    """Modules that are imported when they are first asked for: with them the import of the package takes half as long again."""
    if name in ("study", "surface"):
        from importlib import import_module

        return import_module(f".{name}", __name__)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
