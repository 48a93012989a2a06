"""Real contacts, with round numbers for each: where they lie on the map of `docs/when-to-use.md`.

A contact is followed over its loads: the mean pressure of its summits over the hardness of the softer body, which tells
whether they yield, and the mean contact radius over the Burgers vector, which tells the regime of slip.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from asperity.materials import MATERIALS, PAIRS, contact
from asperity.model import Model
from asperity.params import Params
from .curves import Array

# The mean pressure over the hardness at which a summit begins to yield: docs/model.md.
YIELD = 0.4
# Below about three atoms' distances a contact is a number of atoms and no continuum.
CONTINUUM = 3.0
# Of the real area over the nominal one, above which summits press each other down.
CROWDED = 0.1
# Contacts below which specimens differ from each other by more than a fifth: the warning FEW.
FEW = 20


@dataclass(frozen=True)
class Contact:
    """A contact of the map.

    Attributes:
        name: on the map.
        params: of the surfaces, with the hardness of the softer body; of one summit, without a nominal area, for a single
            contact.
        loads: lightest and heaviest load [N].
        basis: what the numbers rest on.
        verdict: whether the model is valid, and what to use if not.
    """

    name: str
    params: Params
    loads: tuple[float, float]
    basis: str
    verdict: str

    def track(self, count: int = 41) -> tuple[Array, Array, Array]:
        """Over the loads: mean pressure over hardness, mean contact radius over Burgers vector, real over nominal area."""
        model, area = Model(self.params), self.params.nominal_area
        states = [model.state_at_load(float(load)) for load in np.geomspace(*self.loads, count)]
        pressure = np.array([state.mean_asperity_pressure / self.params.hardness for state in states])
        radius = np.array([state.mean_contact_radius / self.params.burgers_vector for state in states])
        share = np.array([state.real_area / area if area else 0.0 for state in states])
        return pressure, radius, share

    def holds(self) -> str:
        """The verdict, with the nominal pressure from which on enough summits touch, if that is within the loads."""
        model, area = Model(self.params), self.params.nominal_area
        lightest, heaviest = np.log(self.loads)
        if area == 0 or model.state_at_load(self.loads[0]).contacting >= FEW:
            return self.verdict
        for _ in range(50):
            middle = 0.5 * (lightest + heaviest)
            few = model.state_at_load(math.exp(middle)).contacting < FEW
            lightest, heaviest = (middle, heaviest) if few else (lightest, middle)
        return f"{self.verdict} from {math.exp(heaviest) / area / 1e3:.2g} kPa, with {FEW} contacts"


def _bodies(first: str, second: str, work_of_adhesion: float) -> dict[str, Any]:
    return contact(first, second, work_of_adhesion=work_of_adhesion)


def _single(bodies: dict[str, Any], radius: float) -> Params:
    """One summit: heights that differ by a thousandth of the range of adhesion."""
    return Params.si(**bodies, height_std=1e-3 * bodies["adhesion_range"], summit_radius=radius, asperity_count=1.0)


def _rough(bodies: dict[str, Any], sigma: float, radius: float, area: float, product: float = 0.05) -> Params:
    """Density times radius times sigma is 0.05, as on the surfaces of Greenwood and Williamson (1966), or another product."""
    return Params.si(
        **bodies, height_std=sigma, summit_radius=radius, summit_density=product / (radius * sigma), nominal_area=area
    )


_ADHESION_OF_OXIDES = PAIRS["Si/Si"].work_of_adhesion
_SILICA = MATERIALS["SiO2"]
# A round number for a soft elastomer, whose modulus stands in for its hardness.
_RUBBER_ON_GLASS = dict(
    E1=2e6, nu1=0.5, E2=_SILICA.young, nu2=_SILICA.poisson, work_of_adhesion=0.0, adhesion_range=0.5e-9,
    burgers_vector=0.5e-9, hardness=2e6,
)  # fmt: skip

CONTACTS = tuple(
    Contact(*row)
    for row in (
        ("AFM tip", _single(_bodies("Si3N4", "Si", _ADHESION_OF_OXIDES), 30e-9), (1e-9, 1e-7),
         "Si₃N₄ on Si, radius 30 nm, 1 to 100 nN", "valid; measure the strength of the film"),
        ("fine powder", _single(PAIRS["SiO2/SiO2"].contact, 1e-6), (1e-8, 1e-5),
         "smooth silica spheres of 2 µm, 10 nN to 10 µN", "valid"),
        ("MEMS polysilicon", _rough(PAIRS["Si/Si"].contact, 5e-9, 1e-6, 1e-8), (1e-6, 1e-2),
         "Si/Si, σ = 5 nm, R = 1 µm, 100 Pa to 1 MPa", "valid"),
        ("wafer on chuck", _rough(_bodies("Si", "DLC", _ADHESION_OF_OXIDES), 10e-9, 10e-6, 1e-6), (1e-3, 1.0),
         "Si on DLC, σ = 10 nm, R = 10 µm, 1 kPa to 1 MPa", "valid"),
        ("DLC on steel", _rough(_bodies("DLC", "steel", 0.05), 50e-9, 20e-6, 1e-6), (1e-1, 1e2),
         "σ = 50 nm, R = 20 µm, 0.1 to 100 MPa", "near the limit: heed the warnings"),
        ("ground steel", _rough(PAIRS["steel/steel"].contact, 0.4e-6, 20e-6, 1e-4, 0.04), (1.0, 2e3),
         "σ = 0.4 µm, R = 20 µm, 10 kPa to 20 MPa ([metals](../materials.md#metals-yield))", "yields: elastic-plastic law"),
        ("rubber", _rough(_RUBBER_ON_GLASS, 1e-6, 20e-6, 1e-4), (1e-2, 1e2),
         "E = H = 2 MPa, σ = 1 µm, R = 20 µm, 100 Pa to 1 MPa", "not valid: viscoelastic, crowded"),
    )
)  # fmt: skip


def table() -> str:
    """The contacts as a table of Markdown; the map has their numbers."""
    rows = ["| Contact | Assumed | Model |", "|---|---|---|"]
    return "\n".join(rows + [f"| {one.name} | {one.basis} | {one.holds()} |" for one in CONTACTS])
