"""The pull-off force of rough glass spheres beside estimates of the literature, for docs/dev/validation-data.md."""

from __future__ import annotations

import math

import numpy as np
from asperity import Error, Params, pads

RADIUS, WORK, RANGE, WAVE = 10e-6, 0.05, 0.3e-9, 250e-9  # of the sphere, of adhesion (2), of the waves on it [SI]
PACKED = math.pi / math.sqrt(12)  # part of a plane that closely packed circles cover
HEIGHTS = (20e-9, 10e-9, 5e-9, 2e-9, 0.5e-9)  # Sq


def bead(rms_height: float, work: float = WORK) -> Params:
    """Glass whose waves have one length and this height."""
    m0, wave = rms_height**2, 2 * math.pi / WAVE
    return Params.from_spectral_moments(
        m0=m0, m2=m0 * wave**2 / 2, m4=0.3825 * m0 * wave**4, E1=70e9, nu1=0.2, E2=70e9, nu2=0.2,
        work_of_adhesion=work, adhesion_range=RANGE, burgers_vector=0.3e-9, nominal_area=1e-10,
    )  # fmt: skip


def rabinovich(rms_height: float) -> float:
    """Rabinovich et al. (2000): hills of the length of the waves, and the body behind them. A hill is so high that closely packed ones have
    this rms height from the plane of their feet: (3/PACKED)^1/2 of it for parabolas, 1.819; 1.817 for their caps."""
    height = 1.817 * rms_height
    return 1 / (1 + 32 * RADIUS * height / WAVE**2) + 1 / (1 + height / RANGE) ** 2


def rumpf(rms_height: float) -> float:
    """Rumpf (1990), with the rms height for the radius as in Rabinovich et al. (2000): one hemisphere of closely packed ones, whose rms height
    from the plane of their centres is (PACKED/2)^1/2 of their radius."""
    hill = math.sqrt(2 / PACKED) * rms_height
    return hill / (hill + RADIUS) + 1 / (1 + hill / RANGE) ** 2


def pull_offs(rms_height: float) -> np.ndarray | None:
    """Of 400 spheres, over that of a smooth one; None where fewer than three hills stand at the lowest point."""
    try:
        found = pads(bead(rms_height), [0.0], 400, sphere_radius=RADIUS).pull_off_force
    except Error:
        return None
    return np.asarray(found / (2 * math.pi * WORK * RADIUS))


def table() -> str:
    rows = ["| Sq | Library: median | 95 % of the spheres | Rabinovich | Rumpf |", "|---|---|---|---|---|"]
    for height in HEIGHTS:
        found = pull_offs(height)
        ours = "refused | " if found is None else "{1:.2g} | {0:.2g} to {2:.2g}".format(*np.quantile(found, [0.025, 0.5, 0.975]))
        rows.append(f"| {1e9 * height:g} nm | {ours} | {rabinovich(height):.2g} | {rumpf(height):.2g} |")
    return "\n".join(rows)
