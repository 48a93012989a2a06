"""The surfaces behind each figure, and their friction over the load. Loads are in N G b^2."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import numpy.typing as npt

from asperity.model import Model
from asperity.params import Params

Array = npt.NDArray[np.float64]

# The paper names no load. Between these the text's orderings hold in every figure.
LIGHTEST, HEAVIEST = 1.0, 1e4
LOADS: Array = np.geomspace(LIGHTEST, HEAVIEST, 61)

SKEWS = (-1.0, -0.5, 0.0, 0.5, 1.0)
AMPLITUDES = (1.0, 0.5, 0.0, -0.5, -0.95)


@dataclass(frozen=True)
class Curve:
    """One line of a figure: what the legend calls it, and the surfaces."""

    label: str
    params: Params


@dataclass(frozen=True)
class CurveFigure:
    """A figure of friction coefficients over the load.

    Attributes:
        number: of the figure in the paper.
        title: the one thing that it shows.
        groups: alpha, beta and gamma.
        curves: its lines.
        logarithmic: whether the coefficients span so much that their axis is logarithmic.
    """

    number: int
    title: str
    groups: tuple[float, float, float]
    curves: tuple[Curve, ...]
    logarithmic: bool


def surface(alpha: float, beta: float, gamma: float, **options: Any) -> Params:
    """Surfaces in the paper's units. The paper does not tell its Poisson's ratio: 0.3. No cap on the coefficient."""
    return Params.dimensionless(
        alpha=alpha, beta=beta, gamma=gamma, poisson=0.3, max_friction_coefficient=math.inf, **options
    )


@lru_cache(maxsize=None)
def model(params: Params) -> Model:
    """The model of some surfaces, made once."""
    return Model(params)


def friction(params: Params, loads: Array = LOADS) -> Array:
    """Friction coefficients at loads > 0."""
    return model(params).friction_at_load(loads)


def attraction_effect(beta: float, loads: Array = LOADS, gamma: float = 0.001) -> Array:
    """Figure 3: by how many per cent summits out of contact raise the coefficient, with alpha = 0.01."""
    without = friction(surface(0.01, beta, gamma, attraction=False), loads)
    return 100 * (friction(surface(0.01, beta, gamma), loads) / without - 1)


def _skewed(number: int, title: str, alpha: float, beta: float, gamma: float) -> CurveFigure:
    weibull = [Curve(f"Weibull, $S = {skew:g}$", surface(alpha, beta, gamma, skew=skew)) for skew in SKEWS]
    curves = (*weibull, Curve("Gaussian", surface(alpha, beta, gamma)))
    return CurveFigure(number, title, (alpha, beta, gamma), curves, logarithmic=True)


def _varying(number: int, title: str, alpha: float, beta: float, gamma: float) -> CurveFigure:
    curves = [
        Curve(f"$\\varepsilon = {amplitude:g}$", surface(alpha, beta, gamma, radius_amplitude=amplitude))
        for amplitude in AMPLITUDES
    ]
    return CurveFigure(number, title, (alpha, beta, gamma), tuple(curves), logarithmic=False)


FIGURE_3 = tuple(
    Curve(f"$\\beta = {beta}$, {word} attraction", surface(0.01, beta, 0.001, attraction=word == "with"))
    for beta in (500, 1000)
    for word in ("with", "without")
)
SKEW_FIGURES = (
    _skewed(4, "Negative skew of the heights raises friction", 0.01, 1000, 0.001),
    _skewed(5, "Skew matters more on a smoother surface", 0.006, 1000, 0.001),
    _skewed(6, "A smaller β raises friction at light loads", 0.01, 500, 0.001),
    _skewed(7, "More surface energy raises friction", 0.01, 1000, 0.002),
)
RADIUS_FIGURES = (
    _varying(8, "Radii that grow with height raise friction", 0.01, 1000, 0.001),
    _varying(9, "Radii matter less where β is larger", 0.01, 5000, 0.001),
    _varying(10, "Radii matter less on a rougher surface", 0.03, 1000, 0.001),
)


# ---- Beyond the paper ----

DEFAULT = (0.01, 1000.0, 0.001)
KURTOSES = (2.0, 2.5, 3.0, 4.0, 6.0)
KURTOSIS_SKEWS = (-0.5, 0.0, 0.5)
KURTOSIS_LOAD = 10.0

KURTOSIS_CURVES = (
    *(Curve(f"Johnson, $S = 0$, $K = {k:g}$", surface(*DEFAULT, skew=0.0, kurtosis=k)) for k in KURTOSES),
    Curve("Weibull, $S = 0$", surface(*DEFAULT, skew=0.0)),
)


def kurtoses(skew: float) -> Array:
    """Of the axis over kurtosis, from near the least that Johnson's heights are evaluated for."""
    return np.linspace(1.9 + 1.25 * skew**2, 8, 27)


def friction_over_kurtosis(skew: float) -> Array:
    """Friction coefficients at KURTOSIS_LOAD and `kurtoses(skew)`."""
    load = np.array([KURTOSIS_LOAD])
    surfaces = [surface(*DEFAULT, skew=skew, kurtosis=float(kurtosis)) for kurtosis in kurtoses(skew)]
    return np.array([friction(params, load)[0] for params in surfaces])


REGIME_BETAS = (30.0, 1000.0, 1e5)
REGIME_GAMMA = 1e-4
REGIME_LOADS: Array = np.geomspace(1e-6, 10, 57)


def regimes(beta: float, loads: Array = REGIME_LOADS) -> Array:
    """Fractions of the contacts below, between and above the radii of slip, (3, loads).

    Loads are in N G b^2 alpha beta^2, about what summits carry that overlap by sigma.
    """
    law = model(surface(0.01, beta, REGIME_GAMMA))
    states = [law.state_at_load(float(load) * 0.01 * beta**2) for load in loads]
    return np.array(
        [
            (state.fraction_below_slip_radius_1, state.fraction_between_slip_radii, state.fraction_above_slip_radius_2)
            for state in states
        ]
    ).T


YIELD_INDICES = (0.5, 2.0, 8.0)


def yielding(index: float) -> Params:
    """Summits that yield, of a plasticity index; without adhesion."""
    elastic = surface(*DEFAULT[:2], 0.0)
    return elastic.elastic_plastic(elastic.composite_modulus * DEFAULT[0] / index)


def yields(index: float, loads: Array = REGIME_LOADS) -> Array:
    """Fractions of the contacts that are elastic, elastic-plastic and flowing, (3, loads), in loads as of `regimes`."""
    law = model(yielding(index))
    states = [law.state_at_load(float(load) * DEFAULT[0] * DEFAULT[1] ** 2) for load in loads]
    elastic, flowing = np.array([(state.fraction_elastic, state.fraction_flowing) for state in states]).T
    return np.array([elastic, 1 - elastic - flowing, flowing])


MICROSLIP_LOAD = 1000.0
MICROSLIP_SURFACES = (
    Curve("elastic, $\\beta = 1000$", surface(0.01, 1000, 0.0)),
    Curve("elastic, $\\beta = 30$", surface(0.01, 30, 0.0)),
    Curve("yielding, $\\psi = 8$", yielding(8.0)),
)
MICROSLIP_AMPLITUDES = (0.5, 1.0, 2.0)


def microslip_length(params: Params) -> float:
    """F/K_t at the load of the figure."""
    law = model(params)
    friction_force, stiffness = law.friction_force_at_load(MICROSLIP_LOAD), law.tangential_stiffness_at_load(MICROSLIP_LOAD)
    return friction_force / stiffness


def microslip(params: Params, displacements: Array) -> Array:
    """T/F over the displacement in F/K_t."""
    forces = model(params).tangential(MICROSLIP_LOAD, displacements * microslip_length(params))[0]
    return np.asarray(forces / model(params).friction_force_at_load(MICROSLIP_LOAD))


def loop(params: Params, amplitude: float) -> tuple[Array, Array, float]:
    """Displacement in F/K_t, force over F, and the work of a cycle over F^2/K_t, of a loop of hysteresis."""
    law, length = model(params), microslip_length(params)
    force = law.friction_force_at_load(MICROSLIP_LOAD)
    found = law.hysteresis(MICROSLIP_LOAD, amplitude * length)
    return found.displacement / length, found.force / force, found.work / (force * length)


REMEMBERED_LOADS = (MICROSLIP_LOAD, 0.3 * MICROSLIP_LOAD)


def remembered(params: Params, amplitude: float) -> list[tuple[Array, Array]]:
    """Displacement in F/K_t and force over F, both at the first load, of a contact that remembers: loops at each of the loads, one
    after the other."""
    law, length = model(params), microslip_length(params)
    force = law.friction_force_at_load(MICROSLIP_LOAD)
    contact = law.microslip()
    way = amplitude * np.concatenate([np.linspace(0, 1, 61), np.linspace(1, -1, 121)[1:], np.linspace(-1, 1, 121)[1:]])
    found = []
    last = 0.0
    for load in REMEMBERED_LOADS:
        steps = np.diff(way, prepend=last)
        last = way[-1]
        forces = [contact.step(load, [float(step) * length, 0.0]).force[0] / force for step in steps]
        found.append((way, np.array(forces)))
        way = way[60:]
    return found
