"""What Hurtado and Kim's default slip stresses predict for interfaces whose friction was measured: the table of
`docs/when-to-use.md`.

Of the surfaces only the process is told in the sources, so that sigma and R are round numbers.
"""

from __future__ import annotations

from dataclasses import dataclass

from asperity.model import Model
from asperity.params import Params
from .contacts import CONTACTS
from .measured import MEASUREMENTS, Band, Measurement


@dataclass(frozen=True)
class Rough:
    """A friction coefficient that was measured on rough surfaces that yield.

    Attributes:
        name: what slid on what.
        measured: friction coefficient, from lowest to highest.
        surfaces: that it is predicted for.
        loads: lightest and heaviest [N].
    """

    name: str
    measured: Band
    surfaces: tuple[Params, ...]
    loads: Band

    def predicted(self) -> Band:
        """Friction coefficients with the default slip stresses."""
        found = [Model(params).friction_at_load(load) for params in self.surfaces for load in self.loads]
        return min(found), max(found)

    def ratio(self) -> Band:
        """Predicted over measured."""
        (low, high), (least, most) = self.predicted(), self.measured
        return low / most, high / least


def _steels() -> tuple[Params, ...]:
    """Ground steel of the map, annealed and hardened, yielding."""
    (ground,) = [contact.params for contact in CONTACTS if contact.name == "ground steel"]
    return ground.elastic_plastic(2e9), ground.elastic_plastic(ground.hardness)


ROUGH = (Rough("steel on steel in air, dry", (0.56, 0.58), _steels(), (12.0, 50.0)),)

# Of docs/validation.md, rows whose strength is that of one contact or of a tip.
_SINGLE = ("gold pillar on mica, AFM", "rough gold tip on mica, AFM", "mica on mica in air, SFA", "Si₃N₄ tip on silicon, AFM")


def error() -> Band:
    """How many times too low and too high friction with the default strength is at most: of the rows whose source was read."""
    ratios = [row.ratio() for row in _singles() if row.measured is not None] + [row.ratio() for row in ROUGH]
    return 1 / min(low for low, _ in ratios), max(high for _, high in ratios)


def _singles() -> list[Measurement]:
    return [row for row in MEASUREMENTS if row.name in _SINGLE]


def table() -> str:
    """Predicted with the defaults over measured, as a table of Markdown."""
    rows = ["| Interface | Measured | With the defaults | Default over measured |", "|---|---|---|---|"]
    for single in _singles():
        unit = " MPa" if "MPa" in single.quantity else ""
        measured = "not given" if single.measured is None else _band(single.measured) + unit
        rows.append(_row(single.name, measured, _band(single.predicted()) + unit, single.ratio()))
    for rough in ROUGH:
        measured, predicted = f"μ = {_band(rough.measured)}", f"μ = {_band(rough.predicted())}"
        rows.append(_row(rough.name, measured, predicted, rough.ratio()))
    return "\n".join(rows)


def _row(name: str, measured: str, predicted: str, ratio: Band) -> str:
    return f"| {name} | {measured} | {predicted} | {_times(ratio)} |"


def _band(band: Band) -> str:
    low, high = (f"{value:.2g}" if value < 1 else f"{value:.3g}" for value in band)
    return low if low == high else f"{low} to {high}"


def _times(ratio: Band) -> str:
    """A factor as engineers say it: 1/12 or 5."""
    low, high = (f"1/{1 / value:.2g}" if value < 0.95 else f"{value:.2g}" for value in ratio)
    return low if low == high else f"{low} to {high}"
