"""Materials and pairs of them, with sources: what the contact parameters of a surface are made from, in SI units.

    from asperity import Params
    from asperity.materials import PAIRS

    params = Params.si(**PAIRS["Si/Si"].contact, height_std=5e-9, summit_radius=1e-6, asperity_count=1e5)

Values are typical ones, to start from. Films, alloys and treatments differ within the ranges and beyond; the work of
adhesion depends on what covers the surfaces more than on the bodies. `docs/materials.md` shows all of it as tables.
"""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any, Dict, Mapping, Tuple, TypeVar

Range = Tuple[float, float]


_Entry = TypeVar("_Entry")


class _Named(Dict[str, _Entry]):
    """A dictionary whose `KeyError` names what it has."""

    def __missing__(self, name: object) -> _Entry:
        raise KeyError(f"{name!r} is not known; nearest: {', '.join(self._nearest(str(name)))}; all: {', '.join(self)}")

    def _nearest(self, name: str) -> list[str]:
        def likeness(other: str) -> float:
            ratio = difflib.SequenceMatcher(None, name.lower(), other.lower()).ratio()
            return ratio + len(set(name.lower().split("/")) & set(other.lower().split("/")))

        return sorted(self, key=likeness, reverse=True)[:3]


@dataclass(frozen=True)
class Material:
    """An isotropic elastic body.

    Attributes:
        name: of the material, the key in `MATERIALS`.
        young: Young's modulus [Pa].
        young_range: of published values [Pa].
        poisson: Poisson's ratio.
        hardness: indentation hardness [Pa]; None if no value is trusted here.
        hardness_range: of published values [Pa]; None with it.
        burgers_vector: [m]; of a glass, which has none, the distance of like atoms.
        reference: where the numbers are from.
    """

    name: str
    young: float
    young_range: Range
    poisson: float
    hardness: float | None
    hardness_range: Range | None
    burgers_vector: float
    reference: str


@dataclass(frozen=True)
class Pair:
    """Two bodies and what holds them together.

    Attributes:
        first: one body.
        second: the other.
        work_of_adhesion: w [J/m^2].
        work_of_adhesion_range: of measurements and estimates [J/m^2].
        hamaker: the Hamaker constant [J] that w is estimated from, A/(12 pi D^2) with D = 0.165 nm; None if it is not.
        slip_stress_1: measured shear strength of small contacts over G*, in place of Hurtado and Kim's 1/43; None where
            no measurement is known here.
        reference: where w and its range, and the strength, are from.
    """

    first: Material
    second: Material
    work_of_adhesion: float
    work_of_adhesion_range: Range
    hamaker: float | None
    reference: str
    slip_stress_1: float | None = None

    @property
    def name(self) -> str:
        """The key in `PAIRS`."""
        return f"{self.first.name}/{self.second.name}"

    @property
    def contact(self) -> dict[str, Any]:
        """What `Params.si` and the other ways to make parameters take beside the roughness.

        The Burgers vector is the longer of the two, the range of adhesion is taken equal to it as in the paper, and the
        hardness is that of the softer body, left out if one of them has none here. The range that goes with a work of
        adhesion A/(12 pi D^2) is shorter, 0.97 D = 0.16 nm, by Maugis' rule of the same largest stress: docs/materials.md.
        A measured `slip_stress_1` is among it.
        """
        burgers_vector = max(self.first.burgers_vector, self.second.burgers_vector)
        contact: dict[str, Any] = {
            "E1": self.first.young,
            "nu1": self.first.poisson,
            "E2": self.second.young,
            "nu2": self.second.poisson,
            "work_of_adhesion": self.work_of_adhesion,
            "adhesion_range": burgers_vector,
            "burgers_vector": burgers_vector,
        }
        if self.first.hardness is not None and self.second.hardness is not None:
            contact["hardness"] = min(self.first.hardness, self.second.hardness)
        if self.slip_stress_1 is not None:
            contact["slip_stress_1"] = self.slip_stress_1
        return contact


_SILICON = Material(
    name="Si",
    young=160e9,
    young_range=(152e9, 170e9),
    poisson=0.22,
    hardness=12e9,
    hardness_range=(10e9, 13e9),
    burgers_vector=0.384e-9,
    reference=(
        "polysilicon films: Sharpe et al., IMECE 2000, MEMS, 255-259, and J. Microelectromech. Syst. 6 (1997) 193; "
        "hardness limited by a change of phase: Domnich et al., Rev. Adv. Mater. Sci. 17 (2008) 33; "
        "<110>/2 with a = 0.5431 nm: Hirth and Lothe, Theory of Dislocations"
    ),
)
_SILICA = Material(
    name="SiO2",
    young=72e9,
    young_range=(70e9, 74e9),
    poisson=0.17,
    hardness=9e9,
    hardness_range=(8e9, 10e9),
    burgers_vector=0.31e-9,
    reference=(
        "fused silica: Oliver and Pharr, J. Mater. Res. 7 (1992) 1564; a glass: Si to Si across an oxygen atom, "
        "twice 0.162 nm at some 144 degrees: Mozzi and Warren, J. Appl. Crystallogr. 2 (1969) 164"
    ),
)
_GOLD = Material(
    name="Au",
    young=78e9,
    young_range=(77e9, 80e9),
    poisson=0.44,
    hardness=1.3e9,
    hardness_range=(0.2e9, 2e9),
    burgers_vector=0.288e-9,
    reference=(
        "bulk, with the lower hardness: Kaye and Laby, Tables of Physical and Chemical Constants; film on glass: Zhou et "
        "al., Mater. Sci. Forum 561-565 (2007) 2005; <110>/2 with a = 0.4078 nm"
    ),
)
_STEEL = Material(
    name="steel",
    young=205e9,
    young_range=(190e9, 210e9),
    poisson=0.3,
    hardness=7.5e9,
    hardness_range=(2e9, 9e9),
    burgers_vector=0.248e-9,
    reference=(
        "AISI 52100, hardened to 60-64 HRC, the lower end annealed: ASTM A295 and makers' data sheets; <111>/2 of iron "
        "with a = 0.2866 nm"
    ),
)
_DLC = Material(
    name="DLC",
    young=260e9,
    young_range=(100e9, 630e9),
    poisson=0.25,
    hardness=27e9,
    hardness_range=(10e9, 80e9),
    burgers_vector=0.25e-9,
    reference=(
        "a-C:H, the upper end ta-C: Nature Commun. 12 (2021), doi 10.1038/s41467-021-24766-6, table 1; the range from "
        "soft to ta-C: Robertson, Mater. Sci. Eng. R 37 (2002) 129; Poisson's ratio is assumed; a glass: second neighbours"
    ),
)
_MICA = Material(
    name="mica",
    young=54e9,
    young_range=(50e9, 60e9),
    poisson=0.10,
    hardness=None,
    hardness_range=None,
    burgers_vector=0.52e-9,
    reference=(
        "muscovite, normal to its layers, from the stiffnesses of Vaughan and Guggenheim, J. Geophys. Res. 91 (1986) "
        "4657: C33 - 2 C13^2/(C11 + C12) and C13/(C11 + C12), with means over the plane; repeat of the surface lattice"
    ),
)
_NITRIDE = Material(
    name="Si3N4",
    young=222e9,
    young_range=(150e9, 310e9),
    poisson=0.28,
    hardness=21e9,
    hardness_range=(15e9, 30e9),
    burgers_vector=0.29e-9,
    reference=(
        "LPCVD film: Vlassak and Nix, J. Mater. Res. 7 (1992) 3242; the range is that used for cantilever tips and of "
        "dense nitride; a glass: second neighbours"
    ),
)

MATERIALS: Mapping[str, Material] = MappingProxyType(
    _Named({material.name: material for material in (_SILICON, _SILICA, _GOLD, _STEEL, _DLC, _MICA, _NITRIDE)})
)

_PAIRS = (
    Pair(
        first=_SILICON,
        second=_SILICON,
        work_of_adhesion=0.063,
        work_of_adhesion_range=(0.03, 0.144),
        hamaker=6.5e-20,
        reference=(
            "oxide skins, van der Waals: Israelachvili, Intermolecular and Surface Forces; measured to hold such surfaces "
            "together: DelRio et al., Nature Mater. 4 (2005) 629; with water up to 0.144 J/m^2: DelRio et al., IMECE "
            "2006, MEMS, 21-26"
        ),
    ),
    Pair(
        first=_SILICA,
        second=_SILICA,
        work_of_adhesion=0.063,
        work_of_adhesion_range=(0.03, 0.5),
        hamaker=6.5e-20,
        reference=(
            "van der Waals: Israelachvili; microspheres in air at the lower end: Heim et al., Phys. Rev. Lett. 83 (1999) "
            "3328; in vacuum some ten times as much: Kimura et al., Astrophys. J. 812 (2015) 67"
        ),
    ),
    Pair(
        first=_GOLD,
        second=_GOLD,
        work_of_adhesion=0.3,
        work_of_adhesion_range=(0.1, 3.0),
        hamaker=31e-20,
        reference=(
            "van der Waals, 25 to 40e-20 J: Israelachvili; clean metal welds, 3 J/m^2: Tyson and Miller, Surf. Sci. 62 "
            "(1977) 267; adsorbed films in air lower it"
        ),
    ),
    Pair(
        first=_STEEL,
        second=_STEEL,
        work_of_adhesion=0.049,
        work_of_adhesion_range=(0.04, 0.2),
        hamaker=5e-20,
        reference=(
            "what adsorbs in air, as hydrocarbons, van der Waals: Israelachvili; the upper end is bare iron oxide, 21e-20 J"
        ),
    ),
    Pair(
        first=_DLC,
        second=_DLC,
        work_of_adhesion=0.06,
        work_of_adhesion_range=(0.05, 0.09),
        hamaker=None,
        reference=(
            "2 gamma, from contact angles on hydrogenated films: Piazza and Morell, Diamond Relat. Mater. 18 (2009) 43"
        ),
    ),
    Pair(
        first=_MICA,
        second=_NITRIDE,
        work_of_adhesion=0.124,
        work_of_adhesion_range=(0.02, 0.13),
        hamaker=12.8e-20,
        reference=(
            "van der Waals: Bergstrom, Adv. Colloid Interface Sci. 70 (1997) 125; a tip in humid air at the lower end: "
            "Carpick, Ogletree and Salmeron, Appl. Phys. Lett. 70 (1997) 1548"
        ),
    ),
    Pair(
        first=_MICA,
        second=_GOLD,
        work_of_adhesion=0.172,
        work_of_adhesion_range=(0.02, 0.18),
        hamaker=17.6e-20,
        reference=(
            "van der Waals, the geometric mean of gold, 31e-20 J, and mica, 10e-20 J: Israelachvili; humid air at the "
            "lower end, as for mica/Si3N4; slip stress of a gold pillar, 264 MPa: Li and Kim, Proc. R. Soc. A 464 (2008) "
            "1319"
        ),
        slip_stress_1=0.0108,
    ),
)

PAIRS: Mapping[str, Pair] = MappingProxyType(_Named({pair.name: pair for pair in _PAIRS}))
