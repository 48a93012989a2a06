"""A bolted lap joint of two elastic plates whose contacts slip in part, and the four-parameter Iwan model fitted to it.

The plates carry tension only: EA/2 delta'' = W tau(delta), with the slip delta(x), the width W and the traction tau of the
library at the pressure there. The pull Q at both ends gives delta' = Q/EA at the right end and -Q/EA at the left one. Loads are
constant, so that loops follow Masing's rule; the work of a cycle comes from the first loading. SI units.

Iwan's model is that of D. J. Segalman, J. Appl. Mech. 72 (2005) 752: sliders with the strengths rho(phi) = R phi^chi up to phi_max
and those of S at phi_max, given by F_S, K_T, chi and beta.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from asperity.materials import PAIRS
from asperity.model import Model
from asperity.params import Params
from .curves import Array

# Two plates of steel, 22 mm by 4 mm, that overlap by 80 mm; bolts press them together with 20 kN, most in the middle.
WIDTH, THICKNESS, HALF_LENGTH, CLAMP = 22e-3, 4e-3, 40e-3, 20e3
YOUNG = 205e9
CELLS = 40  # of half the overlap, the other half being its mirror image
# The surfaces are ground, hardened steel calibrated with an assumed friction coefficient.
FRICTION_COEFFICIENT, CALIBRATION_PRESSURE = 0.2, 10e6
# Slips over F/K_t at which each cell has its curve, a polygon between them.
_SLIPS = np.concatenate([[0.0], np.geomspace(1e-3, 8.0, 120)])
# The pull over that of gross slip, from the lightest of the picture.
PULLS = np.geomspace(0.02, 0.98, 45)
FITTED = (0.1, 1.0)  # where Iwan's model is fitted


@dataclass(frozen=True)
class Loading:
    """The first loading of a joint: pull, end displacement, and work of a cycle of that amplitude."""

    pull: Array
    displacement: Array
    work: Array
    slip_pull: float  # F_S
    stiffness: float  # K_T


@dataclass(frozen=True)
class Iwan:
    slip_force: float
    stiffness: float
    chi: float
    beta: float

    @property
    def slip_displacement(self) -> float:
        """phi_max."""
        of_chi = (self.chi + 1) / (self.chi + 2)
        return self.slip_force * (1 + self.beta) / (self.stiffness * (self.beta + of_chi))

    @property
    def _r(self) -> float:
        of_chi = (self.chi + 1) / (self.chi + 2)
        return self.slip_force * (self.chi + 1) / (float(self.slip_displacement ** (self.chi + 2)) * (self.beta + of_chi))

    def force(self, displacement: Array) -> Array:
        """Of the first loading, up to the slip displacement."""
        chi = self.chi
        return self.stiffness * displacement - self._r * displacement ** (chi + 2) / ((chi + 1) * (chi + 2))

    def displacement(self, force: Array) -> Array:
        grid = np.linspace(0.0, 1.0, 4001) ** 2 * self.slip_displacement
        return np.interp(force, self.force(grid), grid)

    def work(self, force: Array) -> Array:
        """Of a cycle between these forces."""
        chi = self.chi
        return 4 * self._r * self.displacement(force) ** (chi + 3) / ((chi + 2) * (chi + 3))


@lru_cache(maxsize=1)
def contact() -> Model:
    """Of 1 m2: its load is the pressure, its friction force the traction."""
    params = Params.si(
        **PAIRS["steel/steel"].contact, height_std=0.4e-6, summit_radius=20e-6, summit_density=5e9, nominal_area=1.0
    ).elastic_plastic(7.5e9)
    return Model(params.calibrated(CALIBRATION_PRESSURE, FRICTION_COEFFICIENT))


def pressures() -> Array:
    """Of the cells, from the middle of the overlap to its end: a parabola that ends at 0."""
    place = (np.arange(CELLS) + 0.5) / CELLS
    shape = 1 - place**2
    return np.asarray(shape * CLAMP / (2 * WIDTH * HALF_LENGTH / CELLS * np.sum(shape)))


class _Cells:
    """Traction of every cell over its slip, from the exact curve at its pressure."""

    def __init__(self) -> None:
        law = contact()
        self.strength = law.friction_force_at_load(pressures())
        self.length = self.strength / law.tangential_stiffness_at_load(pressures())
        self.slips = _SLIPS * self.length[:, None]
        self.tractions = np.array([law.tangential(p, slips)[0] for p, slips in zip(pressures(), self.slips)])
        steps = 0.5 * (self.tractions[:, 1:] + self.tractions[:, :-1]) * np.diff(self.slips)
        self.energies = np.concatenate([np.zeros((CELLS, 1)), np.cumsum(steps, axis=1)], axis=1)

    def at(self, slip: Array) -> tuple[Array, Array, Array]:
        """Traction, its slope, and the work of a cycle by area, of each cell."""
        places = np.clip(np.searchsorted(_SLIPS, slip / self.length) - 1, 0, _SLIPS.size - 2)
        cells = np.arange(CELLS)
        low, high = self.tractions[cells, places], self.tractions[cells, places + 1]
        past = slip - self.slips[cells, places]
        slope = (high - low) / (self.slips[cells, places + 1] - self.slips[cells, places])
        traction = low + slope * past
        # Masing: 8 times the energy of the first loading less 4 times force by displacement.
        return traction, slope, 8 * (self.energies[cells, places] + 0.5 * (low + traction) * past) - 4 * traction * slip


@lru_cache(maxsize=1)
def _cells() -> _Cells:
    return _Cells()


@lru_cache(maxsize=1)
def first_loading() -> Loading:
    cells, size = _cells(), HALF_LENGTH / CELLS
    area, tension = WIDTH * size, YOUNG * WIDTH * THICKNESS  # EA
    spring = tension / 2 / size
    plates = spring * (2 * np.eye(CELLS) - np.eye(CELLS, k=1) - np.eye(CELLS, k=-1))
    plates[0, 0] = plates[-1, -1] = spring
    slip_pull = 2 * area * float(np.sum(cells.strength))
    slip, found = np.zeros(CELLS), []
    pulls = slip_pull * np.concatenate([[1e-4], PULLS])
    for pull in pulls:
        ends = np.zeros(CELLS)
        ends[-1] = pull / 2
        for _ in range(60):
            traction, slope, work = cells.at(slip)
            rest = plates @ slip + area * traction - ends
            if np.max(np.abs(rest)) <= 1e-10 * pull:
                break
            slip = slip - np.linalg.solve(plates + np.diag(area * slope), rest)
        else:
            raise RuntimeError(f"Newton's method has not converged at a pull of {pull:g} N")
        found.append((slip[-1] + pull / tension * (size / 2 + HALF_LENGTH), 2 * area * float(np.sum(work))))
    displacement, of_cycle = np.array(found).T
    return Loading(pulls[1:], displacement[1:], of_cycle[1:], slip_pull, float(pulls[0] / displacement[0]))


@lru_cache(maxsize=1)
def rigid_loading() -> Loading:
    """The same contacts between plates that do not stretch: all slip by the same displacement."""
    cells, area = _cells(), WIDTH * HALF_LENGTH / CELLS
    slip_pull = 2 * area * float(np.sum(cells.strength))
    displacement = np.geomspace(1e-2, 2.0, 60) * float(np.mean(cells.length))
    found = [[2 * area * float(np.sum(part)) for part in cells.at(np.full(CELLS, slip))] for slip in displacement]
    pull, stiffness, work = np.array(found).T
    return Loading(pull, displacement, work, slip_pull, float(stiffness[0]))


def slope(loading: Loading, low: float, high: float) -> float:
    """The exponent of the work against the pull, between two pulls over that of gross slip."""
    chosen = (loading.pull >= low * loading.slip_pull) & (loading.pull <= high * loading.slip_pull)
    return float(np.polyfit(np.log(loading.pull[chosen]), np.log(loading.work[chosen]), 1)[0])


@lru_cache(maxsize=1)
def iwan() -> Iwan:
    """F_S and K_T are those of the joint; chi and beta fit the logarithm of its work, by Gauss and Newton."""
    joint = first_loading()
    low, high = (part * joint.slip_pull for part in FITTED)
    chosen = (joint.pull >= low) & (joint.pull <= high)

    def misfit(chi: float, log_beta: float) -> Array:
        made = Iwan(joint.slip_pull, joint.stiffness, chi, float(np.exp(log_beta)))
        return np.asarray(np.log(made.work(joint.pull[chosen]) / joint.work[chosen]))

    found = np.array([-0.4, 0.0])
    for _ in range(30):
        now = misfit(*found)
        slopes = np.array([(misfit(*(found + step)) - now) / 1e-5 for step in 1e-5 * np.eye(2)]).T
        change = np.linalg.lstsq(slopes, -now, rcond=None)[0]
        found = np.clip(found + change, (-0.9, -5.0), (1.0, 5.0))
        if np.max(np.abs(change)) < 1e-9:
            break
    return Iwan(joint.slip_pull, joint.stiffness, float(found[0]), float(np.exp(found[1])))


def loop(displacement: Array, force: Array) -> tuple[Array, Array]:
    """The loop that follows by Masing's rule from a first loading up to its last point, from there and back."""
    back = displacement[-1] - 2 * displacement, force[-1] - 2 * force
    return np.concatenate([back[0], -back[0]]), np.concatenate([back[1], -back[1]])
