"""The model calibrated at one load, or one size, against measurements at others that it did not see.

How strong an interface is comes from the first measurement; how friction, or what goes with it, changes from there is
the model's. All measured values were read in the text or the data file that `source` names. If a source gives an exponent
instead of points, the measurement is the ratio that the exponent means.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Callable

import numpy as np

from asperity.materials import MATERIALS, Material
from asperity.model import Model
from asperity.params import Params
from asperity.results import State
from .contacts import CONTACTS
from .curves import Array
from .measured import Band, single_contact


@dataclass(frozen=True)
class Reading:
    """A measurement that the model did not see: at what, and the value with its bounds."""

    at: str
    value: float
    bounds: Band


@dataclass(frozen=True)
class Comparison:
    """A set of measurements, and what the model calibrated with the first of them predicts.

    Attributes:
        name: of the contact.
        tests: the part of the model that the measurements test.
        quantity: what is measured.
        calibrated_at: the load or the size of the measurement that calibrates the model.
        readings: the others.
        predicted: at each reading, the least and the most over what the source does not give.
        inputs: of the prediction, and what of them the source does not give.
        source: with what of it was read.
        label: the source, in short.
        agrees: whether the model meets the measurements.
        reason: why it does or does not.
    """

    name: str
    tests: str
    quantity: str
    calibrated_at: str
    readings: tuple[Reading, ...]
    predicted: Callable[[], list[Band]]
    inputs: str
    source: str
    label: str
    agrees: bool
    reason: str

    def residuals(self) -> list[Band]:
        """Predicted over measured, less 1: at each reading, the least and the most."""
        pairs = zip(self.readings, self.predicted())
        return [(low / reading.value - 1, high / reading.value - 1) for reading, (low, high) in pairs]

    def worst(self) -> tuple[Reading, Band]:
        """The reading that the model misses most, and the residual there."""
        return max(zip(self.readings, self.residuals()), key=lambda pair: max(map(abs, pair[1])))


def one_summit(first: Material, second: Material, radius: float) -> Params:
    """A smooth ball on a flat without adhesion."""
    burgers_vector = max(first.need("burgers_vector"), second.need("burgers_vector"))
    return Params.si(
        E1=first.young, nu1=first.poisson, E2=second.young, nu2=second.poisson, work_of_adhesion=0.0,
        adhesion_range=burgers_vector, burgers_vector=burgers_vector, height_std=max(1e-9 * radius, 1e-3 * burgers_vector), summit_radius=radius,
        asperity_count=1.0,
    )  # fmt: skip


# ---- A ball on a film of MoS2 ----

# Shear strength [MPa] and its growth with pressure, of the regression over more than 600 measurements, each with its error.
_STRENGTH, _STRENGTH_ERROR = 24.8, 0.5
_PRESSURE_COEFFICIENT, _PRESSURE_COEFFICIENT_ERROR = 0.001, 0.001
_BALL_RADIUS = 3.175e-3
FILM_LOADS = np.array([1.0, 2.0, 5.0, 10.0, 20.0, 50.0])


def film_pressures(loads: Array) -> Array:
    """Hertz' mean pressure [MPa] under a steel ball of 6.35 mm on steel, by closed form."""
    steel = MATERIALS["steel"]
    modulus = steel.young / (2 * (1 - steel.poisson**2))
    radius = np.cbrt(0.75 * loads * _BALL_RADIUS / modulus)
    return np.asarray(loads / (np.pi * radius**2) / 1e6)


def film_measured(loads: Array) -> tuple[Array, Array, Array]:
    """Measured friction coefficients: of the regression, and with its errors the least and the most."""
    pressures = film_pressures(loads)
    amid = _STRENGTH / pressures + _PRESSURE_COEFFICIENT
    spread = _STRENGTH_ERROR / pressures + _PRESSURE_COEFFICIENT_ERROR
    return amid, amid - spread, amid + spread


def film_predicted(loads: Array) -> Array:
    """Friction coefficients of the model calibrated at the lightest load."""
    lightest = float(FILM_LOADS[0])
    at_lightest = float(film_measured(FILM_LOADS[:1])[0][0])
    params = one_summit(MATERIALS["steel"], MATERIALS["steel"], _BALL_RADIUS)
    return _coefficients(params.calibrated(lightest, at_lightest), loads)


def _coefficients(params: Params, loads: Array) -> Array:
    return np.array([state.friction_coefficient for state in _states(params, loads)])


def _states(params: Params, loads: Array) -> list[State]:
    model = Model(params)
    return [model.state_at_load(float(load)) for load in loads]


def _film_readings() -> tuple[Reading, ...]:
    loads = FILM_LOADS[1:]
    return tuple(Reading(f"{load:g} N", float(m), (float(a), float(b))) for load, m, a, b in zip(loads, *film_measured(loads)))


# ---- A lubricated pair at two loads ----

# Lubricant, speed [mm/s], friction coefficient at 10 N and at 20 N: means over a test.
OIL_TESTS = (
    ("PAO4", 20, 0.1761, 0.1572), ("PAO4", 100, 0.1385, 0.1443),
    ("PAO4, OA 1", 20, 0.1313, 0.1508), ("PAO4, OA 1", 100, 0.1089, 0.1145),
    ("PAO4, OA 10", 20, 0.1081, 0.1034), ("PAO4, OA 10", 100, 0.1060, 0.1018),
    ("PAO4, OA 20", 20, 0.1462, 0.1049), ("PAO4, OA 20", 100, 0.1487, 0.1070),
    ("C20A 20", 10, 0.1362, 0.1584), ("C20A 20", 100, 0.1248, 0.1576),
    ("C20A 20, OA 2", 10, 0.1161, 0.1395), ("C20A 20, OA 2", 100, 0.1232, 0.1573),
    ("TOCN 10, C20A 1, OA 7.5", 10, 0.1175, 0.1278), ("TOCN 10, C20A 1, OA 7.5", 100, 0.1300, 0.1414),
)  # fmt: skip


def oil_ratios() -> Array:
    """The coefficient at 20 N over that at 10 N, of each test."""
    return np.array([heavy / light for _, _, light, heavy in OIL_TESTS])


def _oil_readings() -> tuple[Reading, ...]:
    ratios = oil_ratios()
    error = float(ratios.std(ddof=1) / np.sqrt(ratios.size))
    mean = float(ratios.mean())
    return (Reading(f"20 N, mean of {ratios.size} tests", mean, (mean - error, mean + error)),)


# Areas that the ground steel may have [m^2].
_OIL_AREAS = (1e-6, 1e-4)


def _oil_predicted() -> list[Band]:
    ratios = []
    for params in _ground_steels(_OIL_AREAS):
        light, heavy = _coefficients(params, np.array([10.0, 20.0]))
        ratios.append(float(heavy / light))
    return [(min(ratios), max(ratios))]


def _ground_steels(areas: Band) -> list[Params]:
    """Ground steel of the map, elastic and elastic-plastic, on areas [m^2]."""
    (ground,) = [contact.params for contact in CONTACTS if contact.name == "ground steel"]
    density = ground.asperity_count / ground.nominal_area
    found = []
    for area in areas:
        elastic = ground.replace(nominal_area=area, asperity_count=density * area, work_of_adhesion=0.0)
        found += [elastic, elastic.elastic_plastic(elastic.hardness)]
    return found


# ---- Heat through joints in vacuum ----

_HEAT_EXPONENT = 0.73
# Pressures that a decade begins at, over the hardness: light to heavy joints.
_HEAT_PRESSURES = (1e-5, 1e-4, 1e-3)


def _heat_predicted() -> list[Band]:
    """Conductance goes with the sum of the radii, and so does the tangential stiffness."""
    ratios = []
    for params in _ground_steels((1e-4, 1e-4)):
        for pressure in _HEAT_PRESSURES:
            load = pressure * params.hardness * params.nominal_area
            light, heavy = (state.tangential_stiffness for state in _states(params, np.array([load, 10 * load])))
            ratios.append(heavy / light)
    return [(min(ratios), max(ratios))]


# ---- A diamond tip on silicon oxide ----

_TIP_RADIUS, _TIP_LOAD = 0.1e-6, 0.4e-6


def _tip_predicted() -> list[Band]:
    """Friction over that at 0.4 uN; the load has the attraction in it, so that the model needs no adhesion."""
    params = one_summit(MATERIALS["diamond"], MATERIALS["SiO2"], _TIP_RADIUS)
    half, amid, twice = (state.friction_force for state in _states(params, _TIP_LOAD * np.array([0.5, 1.0, 2.0])))
    return [(half / amid, half / amid), (twice / amid, twice / amid)]


# ---- Antimony particles on graphite ----

_PARTICLE_AREA = 310_000e-18


def _particle_predicted() -> list[Band]:
    """Friction of a contact a tenth as large; of any crystals, Burgers vectors of graphite (0.246 nm) to those of antimony
    (0.431 nm)."""
    silicon = MATERIALS["Si"]
    ratios = []
    for length in (0.246e-9, 0.431e-9):
        large, small = (single_contact(silicon, silicon, length, float(np.sqrt(_PARTICLE_AREA * part / np.pi)))[0] * part
                        for part in (1.0, 0.1))  # fmt: skip
        ratios.append(small / large)
    return [(min(ratios), max(ratios))]


def _exactly(at: str, value: float) -> Reading:
    return Reading(at, value, (value, value))


COMPARISONS = (
    Comparison(
        "ball on a film of MoS₂",
        "one elastic contact of constant strength, for which μ falls as P^(−1/3)",
        "friction coefficient",
        "1 N",
        _film_readings(),
        lambda: [(float(mu), float(mu)) for mu in film_predicted(FILM_LOADS[1:])],
        "measured coefficients are those of the authors' regression, not its points, at the mean pressure of Hertz under a steel ball "
        "of 6.35 mm on steel; they used balls of 1.6 to 12.7 mm and moduli of 70 to 615 GPa",
        "I. L. Singer, R. N. Bolster, J. Wegand, S. Fayeulle and B. C. Stupp, Appl. Phys. Lett. 57 (1990) 995, abstract: sputtered "
        "MoS₂ in dry air, 1 to 50 N, μ = S₀/P_H + α over more than 600 points, S₀ = 24.8 ± 0.5 MPa, α = 0.001 ± 0.001",
        "Singer and others 1990",
        True,
        "Within the errors of the regression at all loads. The exponent is −1/3, the measured one −0.32: the strength of the film grows a "
        "little with pressure",
    ),
    Comparison(
        "lubricated pair",
        "many contacts, for which μ hardly changes with load",
        "μ over μ at 10 N",
        "10 N",
        _oil_readings(),
        _oil_predicted,
        "bodies, shape and roughness are not given; predicted for the ground steel of [the map](#contacts-on-the-map) on 1 mm² "
        "and 1 cm², elastic and elastic-plastic",
        "nanotribology laboratory of P. Egberts, Calgary, 2024, data file: github.com/liampond/EgbertsTribometer, "
        "AverageFrictionCoefficientData.csv; seven lubricants at two speeds, each at 10 N and at 20 N",
        "P. Egberts' laboratory 2024",
        True,
        "A weak test: single tests scatter by 18 %. One smooth ball would give 0.79, five standard errors away",
    ),
    Comparison(
        "heat through metal joints",
        "the sum of contact radii, to which thermal conductance and tangential stiffness are proportional",
        "conductance over its value at a tenth of the load",
        "a tenth of the load",
        (_exactly("ten times the load", 10**_HEAT_EXPONENT),),
        _heat_predicted,
        "loads and roughness are not given; predicted for the ground steel of [the map](#contacts-on-the-map), elastic and "
        "elastic-plastic, from nominal pressures of 10⁻⁵, 10⁻⁴ and 10⁻³ of the hardness",
        "T. R. Thomas and S. D. Probert, J. Heat Transfer 94 (1972) 276, abstract: aluminium and stainless steel in vacuum, "
        "conductance proportional to load^0.73 over 350 points from the literature",
        "Thomas and Probert 1972",
        False,
        "Joints that are not flat touch in a part of their area that grows with load; the model assumes flat surfaces",
    ),
    Comparison(
        "diamond tip on silicon oxide",
        "one small contact, for which F grows as P^(2/3) or a little less",
        "F over F at 0.4 µN",
        "0.4 µN",
        (_exactly("0.2 µN", 1.0), _exactly("0.8 µN", 2.0)),
        _tip_predicted,
        "a tip of radius 0.1 µm; the load includes the attraction",
        "Load-dependency of friction coefficient between silicon-oxides and diamond under ultra-low contact load, abstract; "
        "authors and journal not known: in air, μ inversely proportional to load below 0.4 µN, about 0.1 above",
        "authors not known",
        False,
        "Measured friction is constant below 0.4 µN and proportional to load above, as of a pressure coefficient of 0.1; the model has one "
        "exponent in between",
    ),
    Comparison(
        "antimony particles on graphite",
        "the size of one contact: between the slip radii strength falls as a^(−0.43)",
        "F over F at 310 000 nm²",
        "310 000 nm²",
        (_exactly("31 000 nm²", 0.1),),
        _particle_predicted,
        "the smallest particle is not given; Burgers vectors of 0.246 nm (graphite) to 0.431 nm (antimony)",
        "D. Dietzel and others, Phys. Rev. Lett. 101 (2008) 125505, abstract: F proportional to area up to 310 000 nm² where "
        "particles have friction at all",
        "Dietzel and others 2008",
        False,
        "The strength of these particles does not depend on their size, as that of films; Hurtado and Kim's decrease belongs to clean "
        "crystals",
    ),
    Comparison(
        "amorphous antimony particles on graphite",
        "the same as above",
        "F over F at 310 000 nm²",
        "310 000 nm²",
        (_exactly("31 000 nm²", 10**-0.5),),
        _particle_predicted,
        "sizes are not given; those of the row above are taken",
        "D. Dietzel and others, Phys. Rev. Lett. 111 (2013) 235502, abstract: F proportional to the square root of the area",
        "Dietzel and others 2013",
        False,
        "Lattices that do not match cancel each other's forces (structural lubricity), a term that the model lacks",
    ),
)


def table() -> str:
    """The comparisons as a table of Markdown, a row for each reading."""
    rows = [
        "| Contact | Quantity | Calibrated at | Predicted at | Measured | Predicted | Residual |",
        "|---|---|---|---|---|---|---|",
    ]
    for one in COMPARISONS:
        for reading, predicted, residual in zip(one.readings, one.predicted(), one.residuals()):
            percent = 100 * residual[0], 100 * residual[1]
            numbers = (_measured(reading), _band(predicted, "{:.3g}"), _band(percent, "{:+.1f}") + " %")
            rows.append(f"| {' | '.join((one.name, one.quantity, one.calibrated_at, reading.at, *numbers))} |")
    return "\n".join(rows)


def verdicts() -> str:
    """Why each comparison agrees or fails, with the range of its residuals, as a list of Markdown."""
    lines = []
    for one in COMPARISONS:
        percents = [100 * end for residual in one.residuals() for end in residual]
        residuals = _band((min(percents), max(percents)), "{:+.1f}")
        lines.append(f"- **{one.name}: {'agrees' if one.agrees else 'fails'}**, {residuals} % ({one.label}). {one.reason}.")
    return "\n".join(lines)


def inputs() -> str:
    """What each comparison tests, its inputs and its source, as a list of Markdown."""
    return "\n".join(f"- **{one.name}** tests {one.tests}. Inputs: {one.inputs}. Source: {one.source}." for one in COMPARISONS)


def _measured(reading: Reading) -> str:
    half = (reading.bounds[1] - reading.bounds[0]) / 2
    return f"{reading.value:.3g}" + (f" ± {half:.2g}" if half > 0 else "")


def _band(band: Band, form: str) -> str:
    low, high = (form.format(value).replace("-", "−") for value in band)
    return low if low == high else f"{low} to {high}"
