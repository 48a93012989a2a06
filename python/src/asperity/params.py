"""Two rough elastic surfaces, as parameters: an immutable value in one consistent system of units."""

from __future__ import annotations

import ctypes
import math
import numbers
import os
from dataclasses import MISSING, dataclass, fields, replace
from typing import TYPE_CHECKING, Any, Literal, Sequence, cast

from . import _bandwidth_bias, _header, _surface_file, _units
from ._library import LIBRARY
from ._typical_roughness import BANDWIDTH
from .errors import Error, Status, check, nearest

if TYPE_CHECKING:
    from typing_extensions import TypedDict, Unpack

    from ._summits import Summits

    class Options(TypedDict, total=False):
        """What every way to make parameters takes beside its own: the fields with a default."""

        height_distribution: Literal["gaussian", "weibull", "johnson", "tabulated"]
        attraction: bool
        weibull_shape: float
        skew: float
        kurtosis: float
        hardness: float
        table_height: Sequence[float]
        table_density: Sequence[float]
        radius_amplitude: float
        radius_rate: float
        slip_radius_1: float
        slip_stress_1: float
        slip_radius_2: float
        slip_stress_2: float
        max_friction_coefficient: float
        tangential_modulus: float
        contact_law: Literal["maugis", "elastic-plastic"]
        slip_onset: Literal["partial", "whole"]
        pressure_coefficient: float
        bandwidth: float
        calibration_load: float
        calibration_friction_coefficient: float
        calibration_friction_force: float
        calibration_error: float

    class Contact(Options, total=False):
        """What `si` takes beside the roughness."""

        work_of_adhesion: float
        adhesion_range: float
        burgers_vector: float
        composite_modulus: float
        effective_shear_modulus: float
        E1: float
        nu1: float
        E2: float
        nu2: float


_DISTRIBUTIONS = {
    "gaussian": _header.ASPERITY_HEIGHTS_GAUSSIAN,
    "weibull": _header.ASPERITY_HEIGHTS_WEIBULL,
    "johnson": _header.ASPERITY_HEIGHTS_JOHNSON,
    "tabulated": _header.ASPERITY_HEIGHTS_TABULATED,
}
_CONTACT_LAWS = {
    "maugis": _header.ASPERITY_CONTACT_MAUGIS,
    "elastic-plastic": _header.ASPERITY_CONTACT_ELASTIC_PLASTIC,
}
_SLIP_ONSETS = {"partial": _header.ASPERITY_SLIP_PARTIAL, "whole": _header.ASPERITY_SLIP_WHOLE}
# What a field means for the heights, where no height_distribution is given with it. A skew alone is one of Weibull's.
_CHOOSES = {"weibull_shape": "weibull", "kurtosis": "johnson", "table_height": "tabulated", "table_density": "tabulated"}
_HEIGHTS = {"height_distribution", "skew", *_CHOOSES}

# What the ways to make parameters take beside fields.
_NOT_FIELDS = ("E1", "nu1", "E2", "nu2", "summit_density", "m0", "m2", "m4", "Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku", "Ra", "Rq", "RSm")
# Heights from a peak to a valley.
_PEAKS = ("Rz", "Rt", "Rmax", "Sz")
# One measured point: the load, and either of the others.
CALIBRATION = ("calibration_load", "calibration_friction_coefficient", "calibration_friction_force")
# What an interface by its name sets, and a measured point with it.
STRENGTH = ("slip_stress_1", "slip_stress_2", "pressure_coefficient")

# How the summits of moments are known: what sets them, and the fields that it sets. A kurtosis means Johnson's heights.
_MOMENTS = ("height_std", "summit_radius", "asperity_count", "nominal_area", "bandwidth")
_SETTERS: dict[str, tuple[Any, tuple[str, ...]]] = {
    "equal": (LIBRARY.asperity_params_set_spectral_moments, _MOMENTS),
    "nayak": (
        LIBRARY.asperity_params_set_nayak_summits,
        (*_MOMENTS, "skew", "kurtosis", "radius_amplitude", "radius_rate"),
    ),
}


def _initialised() -> _header.asperity_params:
    struct = _header.asperity_params()
    check(LIBRARY.asperity_params_init(ctypes.byref(struct), ctypes.sizeof(struct)))
    return struct


_DEFAULT: Any = _initialised()


@dataclass(frozen=True, repr=False)
class Params:
    """Two rough elastic surfaces, as the equivalent rough surface against a flat.

    All quantities are in one consistent system of units of your choice: SI, mm-N-MPa, or the paper's b = G = 1.
    Loads, forces and areas are totals over `asperity_count` summits. Make one with
    `Params.from_iso25178`, `Params.from_profile`, `Params.si` or another of its class methods. `replace` returns a changed
    copy. `Model` checks the numbers.

    Attributes:
        composite_modulus: E* [stress] > 0: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
        effective_shear_modulus: G* [stress] > 0: 2 G1 G2/(G1 + G2).
        work_of_adhesion: w [force/length] >= 0; 0 is Hertzian contact.
        adhesion_range: h [length] > 0: range of adhesion, within which surfaces attract with the stress w/h.
        burgers_vector: b [length] > 0: Burgers vector, the length in which the slip radii are given.
        height_std: sigma [length] > 0: standard deviation of summit heights.
        summit_radius: R [length] > 0: mean radius of curvature of the summits.
        asperity_count: N > 0: summit density times nominal area; need not be an integer.
        height_distribution: "gaussian", "weibull", "johnson" or "tabulated".
        attraction: whether summits out of contact attract.
        weibull_shape: omega, 1 to 200; 3.602 has no skew. Read only for "weibull".
        radius_amplitude: epsilon, -1 to 1: the radius grows with height z as R (1 + epsilon tanh(rho z/sigma)).
        radius_rate: rho > 0.
        slip_radius_1: a_1/b >= 1: up to this contact radius the shear strength is slip_stress_1.
        slip_stress_1: tau_1/G* > 0, at most 1.
        slip_radius_2: a_2/b > a_1/b: from this contact radius on the shear strength is slip_stress_2.
        slip_stress_2: tau_2/G* > 0, at most 1; tau_2 a_2^2 must not be below tau_1 a_1^2.
        max_friction_coefficient: cap > 0 on every friction coefficient returned; may be infinite.
        skew: of "johnson" heights, -3 to 3; 0 for others.
        kurtosis: of "johnson" heights, 1.87 + 1.25 skew^2 to 100; 3 for others.
        hardness: H [stress] >= 0, indentation hardness of the softer body, with which warnings compare contact pressures;
            0 where it is not known.
        table_height: summit heights, increasing, in any unit and from any origin; read only for "tabulated".
        table_density: as many densities >= 0, of any scale.
        tangential_modulus: G^ [stress] >= 0: 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2, for contacts that stick; 0 stands for
            E* G* / (2 (E* + G*)), which is exact for two bodies of one material and for one rigid body.
        nominal_area: [length^2] >= 0, what warnings compare the real area with; 0 where it is not known.
        contact_law: "maugis", elastic with adhesion, or "elastic-plastic", which needs a hardness and no adhesion.
        slip_onset: how a contact begins to slip, "partial", from its rim inwards (Cattaneo and Mindlin), or "whole", all at once: for
            the tangential force before gross slip.
        pressure_coefficient: kappa >= 0, the part of a contact's strength that grows with pressure, over its Hertz load.
        bandwidth: Nayak's m0 m4/m2^2 >= 1.5, by which warnings judge whether summits act independently; 0 where it is not known.
        calibration_load: load of the measurement that set the strength [force]; `calibrated` sets it.
        calibration_friction_force: friction force measured at it [force]; 0 if the strength was not calibrated.
        calibration_error: relative standard error of the measurement, > 0, at most 1.
    """

    composite_modulus: float
    effective_shear_modulus: float
    work_of_adhesion: float
    adhesion_range: float
    burgers_vector: float
    height_std: float
    summit_radius: float
    asperity_count: float
    height_distribution: Literal["gaussian", "weibull", "johnson", "tabulated"] = "gaussian"
    attraction: bool = True
    weibull_shape: float = _DEFAULT.weibull_shape
    radius_amplitude: float = _DEFAULT.radius_amplitude
    radius_rate: float = _DEFAULT.radius_rate
    slip_radius_1: float = _DEFAULT.slip_radius_1
    slip_stress_1: float = _DEFAULT.slip_stress_1
    slip_radius_2: float = _DEFAULT.slip_radius_2
    slip_stress_2: float = _DEFAULT.slip_stress_2
    max_friction_coefficient: float = _DEFAULT.max_friction_coefficient
    skew: float = _DEFAULT.skew
    kurtosis: float = _DEFAULT.kurtosis
    hardness: float = _DEFAULT.hardness
    table_height: Sequence[float] = ()
    table_density: Sequence[float] = ()
    tangential_modulus: float = _DEFAULT.tangential_modulus
    nominal_area: float = _DEFAULT.nominal_area
    contact_law: Literal["maugis", "elastic-plastic"] = "maugis"
    slip_onset: Literal["partial", "whole"] = "partial"
    pressure_coefficient: float = _DEFAULT.pressure_coefficient
    bandwidth: float = _DEFAULT.bandwidth
    calibration_load: float = _DEFAULT.calibration_load
    calibration_friction_force: float = _DEFAULT.calibration_friction_force
    calibration_error: float = _DEFAULT.calibration_error

    def __post_init__(self) -> None:
        for field in fields(self):
            value = getattr(self, field.name)
            object.__setattr__(self, field.name, _CHECKS.get(field.name, _real)(field.name, value))
        heights, densities = len(self.table_height), len(self.table_density)
        if heights != densities:
            raise Error(f"table_density: {densities} numbers for {heights} heights", Status.INVALID_PARAMETER)

    @classmethod
    def paper(cls) -> Params:
        """The case of Adams and Müftü (2005): alpha = 0.01, beta = 1000, gamma = 0.001, poisson = 0.3, in units b = G = 1."""
        return cls.dimensionless(alpha=0.01, beta=1000, gamma=0.001)

    @classmethod
    def dimensionless(
        cls,
        *,
        alpha: float,
        beta: float,
        gamma: float,
        b_over_h: float = 1.0,
        poisson: float = 0.3,
        **options: Unpack[Options],
    ) -> Params:
        """The paper's dimensionless case: b = 1, G = 1, N = 1, so that loads are P/(N G b^2).

        Args:
            alpha: (sigma/R)^(1/2) > 0, surface roughness.
            beta: (R sigma)^(1/2)/b > 0, friction regime.
            gamma: w/(E* b) >= 0, surface energy.
            b_over_h: Burgers vector over range of adhesion > 0.
            poisson: Poisson's ratio, above -1, at most 0.5.
            **options: any field with a default. `kurtosis` means Johnson's heights, `skew` without it Weibull heights of
                this skew, -1.11 to 2; `weibull_shape` and a table mean their heights too.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, or names that exclude each other.
        """
        struct = _initialised()
        groups = {"alpha": alpha, "beta": beta, "gamma": gamma, "b_over_h": b_over_h, "poisson": poisson}
        values = [_real(name, value) for name, value in groups.items()]
        check(LIBRARY.asperity_params_set_dimensionless(ctypes.byref(struct), *values))
        return cls._made(_physical(struct), options)

    @classmethod
    def si(
        cls,
        *,
        work_of_adhesion: float,
        adhesion_range: float,
        burgers_vector: float,
        height_std: float,
        summit_radius: float,
        composite_modulus: float | None = None,
        effective_shear_modulus: float | None = None,
        E1: float | None = None,
        nu1: float | None = None,
        E2: float | None = None,
        nu2: float | None = None,
        asperity_count: float | None = None,
        summit_density: float | None = None,
        nominal_area: float | None = None,
        **options: Unpack[Options],
    ) -> Params:
        """Parameters from numbers of the summits, in SI units or any other consistent system.

        Stiffness is either `composite_modulus` and `effective_shear_modulus`, or the two bodies `E1`, `nu1`, `E2`,
        `nu2`. The number of summits is either `asperity_count`, with `nominal_area` if that is known, or
        `summit_density` and `nominal_area`.

        Args:
            work_of_adhesion: w [J/m^2] >= 0.
            adhesion_range: h [m] > 0.
            burgers_vector: b [m] > 0.
            height_std: sigma [m] > 0.
            summit_radius: R [m] > 0.
            composite_modulus: E* [Pa] > 0.
            effective_shear_modulus: G* [Pa] > 0.
            E1: Young's modulus of the first body [Pa] > 0; `math.inf` is a rigid one, which one of the two may be.
            nu1: its Poisson's ratio, above -1, at most 0.5.
            E2: Young's modulus of the second body [Pa].
            nu2: its Poisson's ratio.
            asperity_count: N > 0.
            summit_density: summits per area [1/m^2] > 0.
            nominal_area: [m^2] > 0.
            **options: any field with a default. `kurtosis` means Johnson's heights, `skew` without it Weibull heights of
                this skew, -1.11 to 2; `weibull_shape` and a table mean their heights too.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, one missing, or names that exclude each other.
        """
        moduli = {"composite_modulus": composite_modulus, "effective_shear_modulus": effective_shear_modulus}
        bodies = {"E1": E1, "nu1": nu1, "E2": E2, "nu2": nu2}
        if _one_of(moduli, bodies) is bodies:
            moduli = _moduli(bodies)
        if asperity_count is not None and summit_density is None:
            summits = {"asperity_count": asperity_count} | ({} if nominal_area is None else {"nominal_area": nominal_area})
        else:
            surface = {"summit_density": summit_density, "nominal_area": nominal_area}
            _one_of({"asperity_count": asperity_count}, surface)
            density, area = (_positive(name, value) for name, value in surface.items())
            summits = {"asperity_count": density * area, "nominal_area": area}
        named: dict[str, Any] = {
            "work_of_adhesion": work_of_adhesion,
            "adhesion_range": adhesion_range,
            "burgers_vector": burgers_vector,
            "height_std": height_std,
            "summit_radius": summit_radius,
        }
        return cls._made(moduli | named | summits, options)

    @classmethod
    def _made(cls, fields: dict[str, Any], options: Any) -> Params:
        """With options, of which a measured point comes last."""
        given = dict(options)
        point = _popped(given, CALIBRATION)
        return cls(**(fields | _options(given)))._at_point(point)

    def _at_point(self, point: dict[str, Any]) -> Params:
        """Calibrated by the names of `CALIBRATION`, if any is given."""
        if not point:
            return self
        load, coefficient, force = (point.get(name) for name in CALIBRATION)
        if load is None or (coefficient is None) == (force is None):
            says = f"{CALIBRATION[0]} goes with one of {CALIBRATION[1]} and {CALIBRATION[2]}"
            raise TypeError(f"{next(iter(point))}: {says}")
        if coefficient is not None:
            return self.calibrated(load, coefficient, error=self.calibration_error)
        return self.calibrated_force(load, point[CALIBRATION[2]], error=self.calibration_error)

    @classmethod
    def from_spectral_moments(
        cls,
        *,
        m0: float | None = None,
        Ra: float | Sequence[float] | None = None,
        m2: float,
        m4: float,
        nominal_area: float,
        summits: Literal["equal", "nayak"] = "equal",
        **contact: Unpack[Contact],
    ) -> Params:
        """Parameters from the spectral moments of profiles of an isotropic Gaussian surface, in SI units.

        Summit density, radius and height deviation are those of Nayak (1971), with the variance of Bush, Gibson and
        Keogh (1976), as McCool (1987) collects them. Two rough surfaces: add their moments.

        Args:
            m0: variance of the heights [m^2] > 0; or
            Ra: mean deviation of Gaussian heights [m] > 0; of two rough surfaces both, whose mean squares add.
            m2: variance of the slopes dz/dx > 0.
            m4: variance of the curvatures d2z/dx2 [1/m^2] > 0; the bandwidth m0 m4/m2^2 is at least 1.5.
            nominal_area: [m^2] > 0.
            summits: "equal" for one radius and the heights that `contact` tells, Gaussian without; "nayak" for Johnson's
                heights and radii that fall with height, both from Nayak's joint distribution of height and curvature,
                which the bandwidth determines; `contact` must not tell heights or radii then.
            **contact: materials, adhesion and options, as `si` takes them.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, one missing, or names that exclude each other.

        Warns:
            ValidityWarning: a bandwidth for which friction is off by more than 10 %: the message has the expected bias.
        """
        if summits not in _SETTERS:
            raise Error(f"summits = {summits!r}: must be 'equal' or 'nayak'", Status.INVALID_PARAMETER)
        struct: Any = _initialised()
        variance = _variance(contact, m0=m0, Ra=Ra)
        moments = {"m0": variance, "m2": m2, "m4": m4, "nominal_area": nominal_area}
        values = [_real(name, value) for name, value in moments.items()]
        setter, names = _SETTERS[summits]
        check(setter(ctypes.byref(struct), *values))
        surface: dict[str, Any] = {name: getattr(struct, name) for name in names}
        twice = sorted((surface.keys() | _HEIGHTS) & contact.keys()) if summits == "nayak" else []
        if twice:
            raise TypeError(f'{twice[0]}: summits="nayak" sets heights and radii, leave one out')
        params = cls.si(**surface, **contact)
        _bandwidth_bias.warn(variance / m2 * (m4 / m2), summits)
        return params

    @classmethod
    def from_profile(
        cls,
        *,
        Rq: float | Sequence[float] | None = None,
        Ra: float | Sequence[float] | None = None,
        RSm: float,
        nominal_area: float,
        summits: Literal["equal", "nayak"] = "equal",
        **contact: Unpack[Contact],
    ) -> Params:
        """Parameters from Rq or Ra and RSm of a profile of an isotropic Gaussian surface, in SI units: lengths in m.

        >>> params = asperity.Params.from_profile(
        ...     Ra=[8e-9, 4e-9], RSm=1e-6, nominal_area=1e-8, **asperity.materials.PAIRS["Si/Si"].contact)

        m0 = Rq^2 and m2 = (2 pi Rq/RSm)^2, since a Gaussian profile crosses its mean line upwards once in RSm. Rq and RSm do
        not determine how sharp the summits are: m4 = bandwidth m2^2/m0.

        Args:
            Rq: standard deviation of the profile [m] > 0; or
            Ra: its mean deviation [m] > 0, 0.8 Rq of Gaussian heights. Of two rough surfaces a list of both: their mean squares
                add.
            RSm: mean width of the profile's elements [m] > 0, with every crossing of the mean line counted.
            nominal_area: [m^2] > 0.
            summits: "equal" or "nayak", as for `from_spectral_moments`.
            **contact: materials, adhesion and options, as `si` takes them. Of these `bandwidth` is Nayak's m0 m4/m2^2 >= 1.5;
                without it the library takes the middle of 3 to 30, the range of most surfaces. `asperity.friction` returns the
                band of friction that follows from that range.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, one missing, or names that exclude each other.

        Warns:
            ValidityWarning: a bandwidth for which friction is off by more than 10 %: the message has the expected bias.
        """
        m0 = _variance(contact, Rq=Rq, Ra=Ra)
        m2 = m0 * (2 * math.pi / _positive("RSm", RSm)) ** 2
        m4 = _positive("bandwidth", contact.pop("bandwidth", BANDWIDTH.middle)) * m2 * (m2 / m0)
        return cls.from_spectral_moments(m0=m0, m2=m2, m4=m4, nominal_area=nominal_area, summits=summits, **contact)

    @classmethod
    def from_iso25178(
        cls,
        *,
        Sq: float | Sequence[float] | None = None,
        Ra: float | Sequence[float] | None = None,
        Sdq: float | Sequence[float],
        Ssc: float | Sequence[float] | None = None,
        Sds: float | None = None,
        Ssk: float | None = None,
        Sku: float | None = None,
        nominal_area: float,
        summits: Literal["equal", "nayak"] = "equal",
        **contact: Unpack[Contact],
    ) -> Params:
        """Parameters from areal roughness parameters (ISO 25178) of an isotropic surface, in SI units: lengths in m, not in um.

        >>> params = asperity.Params.from_iso25178(
        ...     Sq=5e-9, Sdq=0.08, Sds=2e13, nominal_area=1e-8, **asperity.materials.PAIRS["Si/Si"].contact)
        >>> print(f"{params.asperity_count:.3g} summits of radius {params.summit_radius:.3g} m")
        2e+05 summits of radius 4.6e-07 m

        m0 = Sq^2 and m2 = Sdq^2/2. m4 is that of a Gaussian surface whose summits have the curvature `Ssc` or, without it,
        the density `Sds`. With both, `Sds` gives the number of summits. `Ssk` and `Sku` describe all heights of the
        surface; here they are taken for those of the summits, which is an approximation.

        Args:
            Sq: standard deviation of the heights [m] > 0; or
            Ra: mean deviation of Gaussian heights [m] > 0. Of two rough surfaces a list of both, also for Sdq and Ssc: their
                mean squares add.
            Sdq: root mean square gradient > 0.
            Ssc: mean curvature of the summits [1/m] > 0.
            Sds: summits per area [1/m^2] > 0; every local maximum counts, unlike for Spd.
            Ssk: skew of the heights, together with `Sku`; heights are Gaussian without them.
            Sku: kurtosis of the heights.
            nominal_area: [m^2] > 0.
            summits: "equal" or "nayak", as for `from_spectral_moments`; "nayak" excludes `Ssk` and `Sku`.
            **contact: materials, adhesion and options, as `si` takes them.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, one missing, or names that exclude each other.
        """
        if Ssc is None and Sds is None:
            raise TypeError("give Ssc, Sds or both: Sq and Sdq do not determine how sharp the summits are")
        if (Ssk is None) != (Sku is None):
            raise TypeError("give both Ssk and Sku, or neither")
        if Ra is not None and Sku is not None:
            raise TypeError("Ra: is understood as that of Gaussian heights: give Sq with Ssk and Sku")
        shape: dict[str, Any] = {} if Sku is None else {"skew": Ssk, "kurtosis": Sku}
        m0, m2 = _variance(contact, Sq=Sq, Ra=Ra), _mean_square("Sdq", Sdq) / 2
        density = 0.0 if Sds is None else _positive("Sds", Sds)
        m4 = 6 * math.pi * 3**0.5 * m2 * density if Ssc is None else 9 * math.pi / 64 * _mean_square("Ssc", Ssc)
        both = Ssc is not None and Sds is not None
        point = _popped(cast("dict[str, Any]", contact), CALIBRATION) if both else {}
        params = cls.from_spectral_moments(m0=m0, m2=m2, m4=m4, nominal_area=nominal_area, summits=summits, **shape, **contact)
        return params.replace(asperity_count=density * nominal_area, **point) if both else params

    @classmethod
    def from_topography(
        cls,
        summits: Summits,
        *,
        heights: Literal["gaussian", "weibull", "johnson", "tabulated"] = "gaussian",
        trend: bool = True,
        nominal_area: float | None = None,
        **contact: Unpack[Contact],
    ) -> Params:
        """Parameters of the surface in which `asperity.surface.summits` found summits, of a material given here.

        Summit heights, radius and density are those of the map; lengths here are in the unit of the map.

        Args:
            summits: of the map; of the sum of both maps, if both surfaces are rough.
            heights: how the summit heights are represented: "gaussian" by their standard deviation, "weibull" by
                their skew too, which must be between -1.11 and 2, "johnson" by skew and kurtosis,
                "tabulated" by their histogram, which ends at the highest summit of the map.
            trend: whether radius may depend on height: R, epsilon and rho are then those of `summits.radius_trend`,
                if that is significant. Otherwise epsilon is 0, and R `summits.radius`.
            nominal_area: [length^2] > 0; without, that of the map.
            **contact: materials, adhesion and options, as `si` takes them.

        Raises:
            Error: a value that the library refuses.
            TypeError: an unknown name, one missing, or one that the map tells.

        Warns:
            ValidityWarning: a bandwidth for which friction is off by more than 10 %: the message has the expected bias.
        """
        if not hasattr(summits, "radius_trend"):
            raise TypeError(f"summits = {summits!r}: must be what asperity.surface.summits returns")
        law = summits.radius_trend
        trending = trend and law.significant
        surface: dict[str, Any] = {
            "height_std": summits.height_std.value,
            "summit_radius": law.radius if trending else summits.radius.value,
            "summit_density": summits.density.value,
            "nominal_area": summits.nominal_area if nominal_area is None else nominal_area,
            "radius_amplitude": law.amplitude if trending else 0.0,
        }
        if trending:
            surface["radius_rate"] = law.rate
        params = cls.si(**surface, **_heights_of(summits, heights), **contact)
        _bandwidth_bias.warn(summits.moments.bandwidth, "map")
        return params

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Params:
        """The parameters that a TOML file describes, in SI units: docs/surface-file.md lists its keys.

        Raises:
            Error: a key or a value that is not allowed; the message names the file, the key and what is allowed.
            OSError: a file that cannot be read.
        """
        return _surface_file.read(path, cls)

    def to_toml(self, path: str | os.PathLike[str]) -> None:
        """Writes a file of which `from_toml` makes equal parameters; fields that have their defaults are left out."""
        _surface_file.write(self, path)

    def by_name(self) -> dict[str, float]:
        """All parameters as single numbers, by the names and in the order in which `asperity_params_set_value` takes them in C.

        Raises:
            ValueError: tabulated heights, which are no single numbers.
        """
        if self.table_height:
            raise ValueError("table_height: tabulated heights cannot be handed on by name, which takes single numbers")
        struct = self._as_struct()
        values: dict[str, float] = {}
        while (name := LIBRARY.asperity_params_name(len(values))) is not None:
            value = ctypes.c_double()
            check(LIBRARY.asperity_params_get_value(struct, name, value))
            values[name.decode()] = value.value
        return values

    def replace(self, **changes: Any) -> Params:
        """A copy with some fields changed, as the options of `si`; Johnson's heights stay Johnson's with a new `skew`.

        A new strength of the interface, one of `slip_stress_1`, `slip_stress_2` and `pressure_coefficient`, is not the one that
        was calibrated: the copy has no measurement then.
        """
        kept = {field.name: getattr(self, field.name) for field in fields(self)}
        point = _popped(changes, CALIBRATION)
        if changes.keys() & set(STRENGTH):
            kept |= {"calibration_load": 0.0, "calibration_friction_force": 0.0}
        if "skew" in changes and self.height_distribution == "johnson":
            changes.setdefault("height_distribution", "johnson")
        options = _options(changes)
        if options.get("height_distribution", "johnson") != "johnson":
            kept |= {"skew": _DEFAULT.skew, "kurtosis": _DEFAULT.kurtosis}
        return type(self)(**(kept | options))._at_point(point)

    def calibrated(self, load: float, friction_coefficient: float, *, error: float = _DEFAULT.calibration_error) -> Params:
        """A copy whose strength of the interface is set from one measured friction coefficient.

        >>> params = asperity.Params.paper().calibrated(load=100.0, friction_coefficient=0.3)
        >>> print(f"{asperity.Model(params).friction_at_load(100.0):.3f}")
        0.300

        The library scales both slip stresses by one factor, so that the friction coefficient at this load is the measured one.
        Use the parameters of the surfaces that were measured. The model then predicts how friction changes with load, area,
        roughness and adhesion.

        The parameters keep the measurement: `uncertainty`, `Model.curve` and studies take it and its error into account, as long
        as the model still has this friction at this load. Changed surfaces keep the strength; it is then known from a measurement
        on another surface. Another slip stress or pressure coefficient, set by `replace`, is not calibrated any more.

        Args:
            load: normal load of the measurement [force] > 0, a total over `asperity_count`.
            friction_coefficient: measured at that load, > 0 and at most 20.
            error: relative standard error of the measurement, > 0 and at most 1.

        Raises:
            Error: no strength gives that friction; the message has the numbers.
        """
        return self._calibrated(LIBRARY.asperity_params_calibrate, load, "friction_coefficient", friction_coefficient, error)

    def calibrated_force(self, load: float, friction_force: float, *, error: float = _DEFAULT.calibration_error) -> Params:
        """As `calibrated`, from a measured friction force: for measurements at zero load, or where the load pulls.

        Args:
            load: normal load of the measurement [force], a total over `asperity_count`; from the pull-off load upwards.
            friction_force: measured at that load [force], > 0.
            error: relative standard error of the measurement, > 0 and at most 1.

        Raises:
            Error: no strength gives that force; the message has the numbers.
        """
        return self._calibrated(LIBRARY.asperity_params_calibrate_force, load, "friction_force", friction_force, error)

    def _calibrated(self, call: Any, load: float, name: str, value: float, error: float) -> Params:
        struct: Any = self._as_struct()
        struct.calibration_error = _real("error", error)
        check(call(ctypes.byref(struct), _real("load", load), _real(name, value)))
        changed = ("slip_stress_1", "slip_stress_2", "calibration_load", "calibration_friction_force", "calibration_error")
        return replace(self, **{field: getattr(struct, field) for field in changed})

    def elastic_plastic(self, hardness: float) -> Params:
        """A copy whose summits yield: contact law "elastic-plastic", with this hardness of the softer body [stress], no adhesion.

        Raises:
            Error: a hardness that is not finite and > 0.
        """
        struct: Any = self._as_struct()
        check(LIBRARY.asperity_params_set_elastic_plastic(ctypes.byref(struct), _real("hardness", hardness)))
        return self.replace(
            contact_law="elastic-plastic", hardness=struct.hardness, work_of_adhesion=struct.work_of_adhesion
        )

    def with_interface(self, name: str) -> Params:
        """A copy whose strength of the interface was measured on other specimens, by the name of the interface.

        Both slip stresses become the shear strength over G*, which must be in Pa, and `pressure_coefficient` that of the interface,
        0 where none is known. Use it to start from; `calibrated` takes your own measurement.

        Args:
            name: one of `asperity.materials.INTERFACES`.

        Raises:
            Error: a name that is not known, or an interface of which only a friction coefficient is known; the message has the
                nearest name, or what to give to `calibrated`.
        """
        struct: Any = self._as_struct()
        check(LIBRARY.asperity_params_set_interface(ctypes.byref(struct), name.encode()))
        return self.replace(**{field: getattr(struct, field) for field in STRENGTH})

    def __repr__(self) -> str:
        shown = [field for field in fields(self) if getattr(self, field.name) != field.default]
        return f"Params({', '.join(f'{field.name}={_literal(getattr(self, field.name))}' for field in shown)})"

    def __str__(self) -> str:
        return _units.text(self)

    def _repr_html_(self) -> str:
        return _units.table(self)

    def _as_struct(self) -> _header.asperity_params:
        struct: Any = _initialised()
        for field in fields(self):
            value = getattr(self, field.name)
            if field.name == "height_distribution":
                value = _DISTRIBUTIONS[value]
            elif field.name == "contact_law":
                value = _CONTACT_LAWS[value]
            elif field.name == "slip_onset":
                value = _SLIP_ONSETS[value]
            elif isinstance(value, tuple):
                value = (ctypes.c_double * len(value))(*value)  # the struct keeps it alive
            setattr(struct, field.name, value)
        struct.table_length = len(self.table_height)
        return struct  # type: ignore[no-any-return]


def _popped(given: dict[str, Any], names: Sequence[str]) -> dict[str, Any]:
    return {name: given.pop(name) for name in names if name in given}


def _physical(struct: _header.asperity_params) -> dict[str, Any]:
    """The fields that have no default."""
    required = [field.name for field in fields(Params) if field.default is MISSING]
    return {name: getattr(struct, name) for name in required}


def _heights_of(summits: Summits, family: Any) -> dict[str, Any]:
    """The options of a family of heights, from the summits of a map."""
    if family == "weibull":
        return {"skew": summits.skew.value}
    if family == "johnson":
        return {"skew": summits.skew.value, "kurtosis": summits.kurtosis.value}
    if family == "tabulated":
        height, density = summits.histogram()
        return {"table_height": height, "table_density": density}
    return {"height_distribution": family}


def _options(given: Any) -> dict[str, Any]:
    """Fields to set, with the height distribution that they mean."""
    changes = dict(given)
    refuse_peaks(changes)
    known = [field.name for field in fields(Params)]
    for name in changes:
        if name not in known:
            raise TypeError(f"{name}: no parameter has this name; the nearest is {nearest(name, [*known, *_NOT_FIELDS])}")
    meant = {_CHOOSES[name]: name for name in _CHOOSES if name in changes}
    if len(meant) > 1:
        raise TypeError(f"{' and '.join(meant.values())} mean different height distributions: give one of them")
    if "skew" in changes and "johnson" not in (changes.get("height_distribution"), *meant):
        excluded = {"weibull_shape", "height_distribution", "table_height", "table_density"} & changes.keys()
        if excluded:
            raise TypeError(f"skew chooses the height distribution: do not give {' or '.join(sorted(excluded))} too")
        struct = _initialised()
        check(LIBRARY.asperity_params_set_skew(ctypes.byref(struct), _real("skew", changes.pop("skew"))))
        return changes | {"height_distribution": "weibull", "weibull_shape": getattr(struct, "weibull_shape")}
    for distribution in meant:
        changes.setdefault("height_distribution", distribution)
    return changes


def _moduli(bodies: dict[str, Any]) -> dict[str, float | None]:
    struct: Any = _initialised()
    values = [_real(name, value) for name, value in bodies.items()]
    check(LIBRARY.asperity_params_set_materials(ctypes.byref(struct), *values))
    return {
        "composite_modulus": struct.composite_modulus,
        "effective_shear_modulus": struct.effective_shear_modulus,
        "tangential_modulus": struct.tangential_modulus,
    }


def _one_of(first: dict[str, Any], second: dict[str, Any]) -> dict[str, Any]:
    """The one of two groups of arguments that is given: all of it, and nothing of the other."""
    given = [group for group in (first, second) if any(value is not None for value in group.values())]
    if len(given) != 1 or any(value is None for value in given[0].values()):
        raise TypeError(f"give either {_listed(first)}, or {_listed(second)}")
    return given[0]


def _listed(names: Any) -> str:
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else str(last)


def _real(name: str, value: Any) -> float:
    if not isinstance(value, numbers.Real):
        raise TypeError(f"{name} = {value!r}: must be a real number")
    try:
        return float(value)
    except OverflowError:
        raise Error(f"{name}: a whole number of more than 308 digits; must be finite", Status.INVALID_PARAMETER) from None


def _positive(name: str, value: Any) -> float:
    number = _real(name, value)
    if not (math.isfinite(number) and number > 0):
        raise Error(f"{name} = {number}: must be finite and > 0", Status.INVALID_PARAMETER)
    return number


def both_of(name: str, value: Any) -> list[float]:
    """The number of one rough surface, or those of two."""
    both = [value] if isinstance(value, numbers.Real) or not hasattr(value, "__iter__") else list(value)
    if not 1 <= len(both) <= 2:
        raise TypeError(f"{name} = {value!r}: must be one number, or a list of two if both surfaces are rough")
    return [_positive(name, one) for one in both]


def _mean_square(name: str, value: Any) -> float:
    """Of one surface, or the sum over two."""
    return sum(one**2 for one in both_of(name, value))


def refuse_peaks(given: Any) -> None:
    """`TypeError` for a height from a peak to a valley, which says too little of a roughness."""
    for name in _PEAKS:
        if name in given:
            raise TypeError(f"{name}: is a peak-to-valley height, which does not determine friction: give Ra or Rq (Sq)")


def _variance(others: Any, **given: Any) -> float:
    """m0 from the one of these names that is given."""
    refuse_peaks(others)
    told = {name: value for name, value in given.items() if value is not None}
    if len(told) != 1:
        raise TypeError(f"give one of {' and '.join(given)}, as the height of the roughness")
    ((name, value),) = told.items()
    if name == "m0":
        return _positive(name, value)
    return (math.pi / 2 if name == "Ra" else 1.0) * _mean_square(name, value)


def _distribution(name: str, value: Any) -> str:
    return _one_word_of(_DISTRIBUTIONS, name, value)


def _contact_law(name: str, value: Any) -> str:
    return _one_word_of(_CONTACT_LAWS, name, value)


def _slip_onset(name: str, value: Any) -> str:
    return _one_word_of(_SLIP_ONSETS, name, value)


def _one_word_of(words: dict[str, int], name: str, value: Any) -> str:
    if value not in words:
        raise Error(f"{name} = {value!r}: must be one of {', '.join(map(repr, words))}", Status.INVALID_PARAMETER)
    return str(value)


def _flag(name: str, value: Any) -> bool:
    if value not in (False, True):
        raise Error(f"{name} = {value!r}: must be True or False", Status.INVALID_PARAMETER)
    return bool(value)


def _column(name: str, value: Any) -> tuple[float, ...]:
    return tuple(_real(f"{name}[{i}]", number) for i, number in enumerate(value))


_CHECKS: dict[str, Any] = {
    "height_distribution": _distribution,
    "attraction": _flag,
    "table_height": _column,
    "table_density": _column,
    "contact_law": _contact_law,
    "slip_onset": _slip_onset,
}


def _literal(value: Any) -> str:
    """As Python reads it back."""
    return f'float("{value}")' if isinstance(value, float) and not math.isfinite(value) else repr(value)
