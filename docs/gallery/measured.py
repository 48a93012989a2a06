"""Measured friction next to what the model predicts with nothing fitted: the rows of `docs/validation.md`.

Inputs that a paper does not give are varied over a range, so that a prediction is a band. Measured values were read in
their source; those that were only quoted elsewhere are marked.
"""

from __future__ import annotations

import itertools
import math
from dataclasses import dataclass
from typing import Callable

from asperity.materials import MATERIALS, PAIRS, Material
from asperity.model import Model
from asperity.params import Params
from asperity.results import State

Band = tuple[float, float]

# What the load on the rough contacts may have been [N].
ROUGH_LOADS = (1e-6, 1e-4)


@dataclass(frozen=True)
class Measurement:
    """A measured quantity and its prediction.

    Attributes:
        name: of the contact.
        quantity: what is measured, with the unit of `measured` and `predicted`.
        measured: lowest and highest value; None where only a ratio was quoted.
        predicted: computes the band.
        open_inputs: what the source does not tell, and the range that it is varied over.
        label: who measured it, in short.
        source: of the measured value.
        reason: why they agree or differ.
        read: whether the value was read in its source.
        quoted_ratio: predicted over measured, where only that was quoted.
    """

    name: str
    quantity: str
    measured: Band | None
    predicted: Callable[[], Band]
    open_inputs: str
    label: str
    source: str
    reason: str
    read: bool = True
    quoted_ratio: Band | None = None

    def ratio(self) -> Band:
        """Predicted over measured, the least and the most."""
        if self.measured is None:
            assert self.quoted_ratio is not None
            return self.quoted_ratio
        low, high = self.predicted()
        return low / self.measured[1], high / self.measured[0]


def single_contact(first: Material, second: Material, burgers_vector: float, radius: float) -> tuple[float, float]:
    """Friction force over area of one contact with a radius [m], by Hurtado and Kim's constants; and G*. Both in Pa."""
    params = Params.si(
        E1=first.young, nu1=first.poisson, E2=second.young, nu2=second.poisson, work_of_adhesion=0.0,
        adhesion_range=burgers_vector, burgers_vector=burgers_vector, height_std=1e-5 * radius,
        summit_radius=100 * radius, asperity_count=1.0,
    )  # fmt: skip
    state = Model(params).state_at_load(4 / 3 * params.composite_modulus * radius**2 / 100)
    return state.friction_force / state.real_area, params.effective_shear_modulus


def slip_stress(first: Material, second: Material, burgers_vectors: Band, radii: Band) -> Band:
    """The stress of single contacts with radii in a range [m], in MPa."""
    pairs = itertools.product(burgers_vectors, radii)
    stresses = [single_contact(first, second, *pair)[0] / 1e6 for pair in pairs]
    return min(stresses), max(stresses)


def rough_model(first: Material, second: Material, sigma: float, work: float) -> Model:
    """Rough polysilicon, 100 um x 100 um of it, with a spread of heights [m] and a work of adhesion [J/m^2]."""
    burgers_vector = max(first.need("burgers_vector"), second.need("burgers_vector"))
    params = Params.si(
        E1=first.young, nu1=first.poisson, E2=second.young, nu2=second.poisson, work_of_adhesion=work,
        adhesion_range=burgers_vector, burgers_vector=burgers_vector, nominal_area=1e-8, summit_density=1e13,
        height_std=sigma, summit_radius=0.05 / (1e13 * sigma), max_friction_coefficient=math.inf,
    )  # fmt: skip
    return Model(params)


def rough_models(first: Material, second: Material) -> list[Model]:
    """At the ends of the ranges of what is open: see the rows that use it."""
    works = PAIRS["Si/Si"].need("work_of_adhesion_range")
    return [rough_model(first, second, sigma, work) for sigma, work in itertools.product((2e-9, 10e-9), works)]


def rough_coefficient(first: Material, second: Material) -> Band:
    """Friction coefficients of rough polysilicon over the inputs that are open, the load among them."""
    found = [model.friction_at_load(load) for model in rough_models(first, second) for load in ROUGH_LOADS]
    return min(found), max(found)


def tip_states() -> list[State]:
    """A Si3N4 tip on Si, radius 20 to 100 nm, at 10 and 100 nN: the ends of what is open."""
    burgers_vector = MATERIALS["Si"].need("burgers_vector")
    first, second = MATERIALS["Si3N4"], MATERIALS["Si"]
    found = []
    for radius, work in itertools.product((20e-9, 100e-9), PAIRS["Si/Si"].need("work_of_adhesion_range")):
        params = Params.si(
            E1=first.young, nu1=first.poisson, E2=second.young, nu2=second.poisson, work_of_adhesion=work,
            adhesion_range=burgers_vector, burgers_vector=burgers_vector, height_std=1e-3 * burgers_vector,
            summit_radius=radius, asperity_count=1.0, max_friction_coefficient=math.inf,
        )  # fmt: skip
        model = Model(params)
        found += [model.state_at_load(load) for load in (1e-8, 1e-7)]
    return found


def tip_coefficient() -> Band:
    """Friction coefficients of these."""
    found = [state.friction_coefficient for state in tip_states()]
    return min(found), max(found)


_GOLD, _MICA, _SILICON, _NITRIDE = (MATERIALS[name] for name in ("Au", "mica", "Si", "Si3N4"))
_LI_AND_KIM = "Li and Kim, Proc. R. Soc. A 464 (2008) 1319, abstract"
_LIM = "Lim et al., Polysilicon microstructures to characterize static friction, IEEE MEMS 1990, abstract"

MEASUREMENTS = (
    Measurement(
        "polysilicon, static",
        "friction coefficient",
        (3.9, 5.9),
        lambda: rough_coefficient(_SILICON, _SILICON),
        "σ 2 to 10 nm, density times R times σ = 0.05 at 10/µm², w 30 to 144 mJ/m², 1 to 100 µN on 100 µm × 100 µm",
        "Lim et al. 1990",
        _LIM,
        "the band is too wide to prove anything; the source gives neither roughness nor load, and with adhesion both decide",
    ),
    Measurement(
        "Si₃N₄ on polysilicon, static",
        "friction coefficient",
        (2.0, 3.0),
        lambda: rough_coefficient(_NITRIDE, _SILICON),
        "as above",
        "Lim et al. 1990",
        _LIM,
        "as above",
    ),
    Measurement(
        "gold pillar on mica, AFM",
        "stress [MPa]",
        (264.0, 264.0),
        lambda: slip_stress(_GOLD, _MICA, (_GOLD.need("burgers_vector"), _MICA.need("burgers_vector")), (5e-9, 50e-9)),
        "contact radius 5 to 50 nm, b 0.288 nm (gold) to 0.52 nm (mica)",
        "Li and Kim 2008",
        _LI_AND_KIM,
        "the band ends at Hurtado and Kim's τ₁ = G*/43; the measured strength is 0.46 of it",
    ),
    Measurement(
        "rough gold tip on mica, AFM",
        "stress on the apparent area [MPa]",
        (40.5, 40.5),
        lambda: (208.0, 245.0),
        "none: predicted in the paper with the same strengths, for a smooth tip",
        "Li and Kim 2008",
        _LI_AND_KIM,
        "too high: with nanometre roughness only a part of the apparent area is in contact",
    ),
    Measurement(
        "mica on mica in air, SFA",
        "stress [MPa]",
        (1.0, 1.0),
        lambda: slip_stress(_MICA, _MICA, 2 * (_MICA.need("burgers_vector"),), (20e-6, 100e-6)),
        "contact radius 20 to 100 µm",
        "Tribol. Trans. 1989",
        "Friction measured with a surface forces apparatus, Tribol. Trans. 32 (1989) 246, abstract: about 1 MPa, in ambient air",
        "too high: water and other films from the air shear more easily than the clean faces",
    ),
    Measurement(
        "Si₃N₄ tip on silicon, AFM",
        "friction coefficient",
        None,
        tip_coefficient,
        "tip radius 20 to 100 nm, w 30 to 144 mJ/m², 10 to 100 nN",
        "quoted",
        "ratio quoted by others",
        "too high: oxide, water and contamination shear more easily than two clean crystals",
        read=False,
        quoted_ratio=(10.0, 40.0),
    ),
)


def table() -> str:
    """The measurements as a table of Markdown."""
    rows = ["| Contact | Quantity | Measured | Predicted | Predicted over measured | Source |", "|---|---|---|---|---|---|"]
    for row in MEASUREMENTS:
        measured = "" if row.measured is None else _band(row.measured)
        bands = (measured, _band(row.predicted()), _band(row.ratio()))
        rows.append(f"| {' | '.join((row.name, row.quantity, *bands, row.label))} |")
    return "\n".join(rows)


def inputs() -> str:
    """Why the prediction is off, what was varied for it, and the source of the measured value, as a list of Markdown."""
    return "\n".join(f"- **{row.name}**, {_band(row.ratio())}: {row.reason}. Inputs: {row.open_inputs}. Source: {row.source}." for row in MEASUREMENTS)


def _band(band: Band) -> str:
    low, high = (f"{value:.3g}" for value in band)
    return low if low == high else f"{low} to {high}"
