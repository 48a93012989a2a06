"""Materials, pairs of them and interfaces, with sources: what the contact parameters of a surface are made from, in SI units.

    from asperity import Params
    from asperity.materials import PAIRS

    params = Params.si(**PAIRS["Si/Si"].contact, height_std=5e-9, summit_radius=1e-6, asperity_count=1e5)

`INTERFACES` has shear strengths of interfaces that were measured, and friction coefficients; `Params.with_interface` takes a
strength by its name.

Values are typical ones, to start from. Films, alloys and treatments differ within the ranges and beyond; the work of
adhesion depends on what covers the surfaces more than on the bodies. `docs/materials.md` shows all of it as tables.

The numbers are those of the library, which C, C++ and Fortran read too; none stands here.
"""

from __future__ import annotations

import ctypes
import json
import math
from dataclasses import dataclass, fields
from itertools import count, takewhile
from typing import Any, Callable, Iterator, Mapping, Tuple, TypeVar

from . import _header
from ._library import LIBRARY, last_error, text_of
from .errors import Error, UnknownKey, check
from .tools import checks

Range = Tuple[float, float]


_Entry = TypeVar("_Entry")


class _Known(Mapping[str, _Entry]):
    """What the library knows of a kind, by name, each read once; it finds a pair in either order, and of an unknown name it says
    what the library does."""

    def __init__(self, kind: int, made: Callable[[dict[str, Any]], _Entry]) -> None:
        found = takewhile(lambda name: name is not None, (LIBRARY.asperity_name(kind, i) for i in count()))
        self._kind, self._made = kind, made
        self._entries: dict[str, _Entry | None] = {name.decode(): None for name in found}

    def __getitem__(self, name: str) -> _Entry:
        entry: _Entry | None = self._entries.get(name)
        if entry is not None:
            return entry
        try:
            values = _described(self._kind, str(name))
        except Error as error:
            raise UnknownKey(f"{error}; all: {', '.join(self)}") from None
        found = self._entries[values["name"]] or self._made(values)
        self._entries[values["name"]] = found
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self._entries)

    def __len__(self) -> int:
        return len(self._entries)


class _Sourced:
    """What has numbers of which some may lack a source."""

    name: Any

    def need(self, name: str) -> Any:
        """A number or a range that must be there.

        Raises:
            Error: no source is known for it here.
        """
        checks.word("name", name, [field.name for field in fields(self)])  # type: ignore[arg-type]
        value = getattr(self, name)
        if value is None:
            says = "no source is known here for it; give a number of your own"
            raise Error(f"{name} of {self.name}: {says}")
        return value


@dataclass(frozen=True)
class Material(_Sourced):
    """An isotropic elastic body.

    Attributes:
        name: of the material, the key in `MATERIALS`.
        young: Young's modulus [Pa].
        young_range: of published values [Pa]; None where none is known here.
        poisson: Poisson's ratio.
        hardness: indentation hardness [Pa]; None where no source is known here.
        hardness_range: of published values [Pa]; None where none is known here.
        burgers_vector: [m]; of a glass, which has none, the distance of like atoms; None for an elastomer.
        reference: where the numbers are from.
    """

    name: str
    young: float
    young_range: Range | None
    poisson: float
    hardness: float | None
    hardness_range: Range | None
    burgers_vector: float | None
    reference: str


@dataclass(frozen=True)
class Pair(_Sourced):
    """Two bodies and what holds them together.

    Attributes:
        first: one body.
        second: the other.
        work_of_adhesion: w [J/m^2].
        work_of_adhesion_range: of measurements and estimates [J/m^2]; None where none is known here.
        hamaker: the Hamaker constant [J] that w is estimated from, A/(12 pi D^2) with D = 0.165 nm; None if it is not.
        slip_stress_1: measured shear strength of small contacts over G*, in place of Hurtado and Kim's 1/43; None where
            no measurement is known here.
        reference: where w and its range, and the strength, are from.
    """

    first: Material
    second: Material
    work_of_adhesion: float
    work_of_adhesion_range: Range | None
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

        Raises:
            Error: a body has no Burgers vector, or is none of `MATERIALS`.
        """
        return self.contact_with()

    def contact_with(self, **given: float) -> dict[str, Any]:
        """`contact`, with numbers that stand for those of the pair, as the `burgers_vector` of a body that has none.

        Raises:
            Error: a body has no Burgers vector and none is given, or it is none of `MATERIALS`.
        """
        for body in (self.first, self.second):
            if MATERIALS.get(body.name) != body:
                says = "is none of asperity.materials.MATERIALS: give E1, nu1, E2, nu2 and the rest by themselves"
                raise Error(f"{body.name}: {says}")
        own = {} if self.slip_stress_1 is None else {"slip_stress_1": self.slip_stress_1}
        own["work_of_adhesion"] = self.work_of_adhesion
        return contact(self.first.name, self.second.name, **(own | given))


@dataclass(frozen=True)
class Interface:
    """What was measured of the strength of an interface, under its own conditions: a start for one like it.

    Attributes:
        name: what touches, and the film or the surroundings: the key in `INTERFACES`.
        shear_strength: tau_0 [Pa], what a contact resists over its area, at no pressure; None where only a friction coefficient
            is known.
        pressure_coefficient: kappa, what the strength grows by with the pressure; None where it is not known.
        friction_coefficient: measured over many contacts, where the strength of one is not known; else None.
        load: the lightest load [N] of that measurement; None where it is not known.
        conditions: bodies, film, humidity, vacuum, temperature and loads, as far as they are known.
        source: "read" if the numbers were seen in the text that the reference names, else "quoted".
        reference: where the numbers are from.
    """

    name: str
    shear_strength: float | None
    pressure_coefficient: float | None
    friction_coefficient: float | None
    load: float | None
    conditions: str
    source: str
    reference: str


def contact(first: str, second: str, **given: float) -> dict[str, Any]:
    """What `Params.si` takes beside the roughness, of any two materials by their names; `Pair.contact` tells how it follows.

    Numbers that are `given` stand for those of the library. Of two materials that are no pair of `PAIRS`, and of a
    material without a Burgers vector, the `work_of_adhesion` and the `burgers_vector` must be among them. A range of
    adhesion that is not known is taken equal to such a Burgers vector.

    Raises:
        Error: a material that is not known, with the nearest (a `KeyError` too); or what is not known here and is not given.
    """
    struct: Any = _header.asperity_params()
    check(LIBRARY.asperity_params_init(ctypes.byref(struct), ctypes.sizeof(struct)))
    struct.slip_stress_1 = math.nan  # set only where it is measured
    one, other = MATERIALS[first], MATERIALS[second]
    check(LIBRARY.asperity_params_set_pair(ctypes.byref(struct), f"{first}/{second}".encode()))
    bodies = {"E1": one.young, "nu1": one.poisson, "E2": other.young, "nu2": other.poisson}
    fields = ("work_of_adhesion", "adhesion_range", "burgers_vector", "slip_stress_1")
    found = {name: getattr(struct, name) for name in fields if not math.isnan(getattr(struct, name))}
    if struct.hardness > 0:
        found["hardness"] = struct.hardness
    if "work_of_adhesion" not in found | given:
        _described(_header.ASPERITY_NAMES_PAIRS, f"{first}/{second}")  # which the library refuses
    if "burgers_vector" not in found | given:
        says = f"burgers_vector: none is known of a body of {first}/{second}: give one"
        raise Error(says)
    if "adhesion_range" not in found:
        found["adhesion_range"] = given["burgers_vector"]
    return bodies | found | given


def _described(kind: int, name: str) -> dict[str, Any]:
    """What the library says of a name: lines `key = value`, whose texts and numbers JSON reads too."""
    text = text_of(LIBRARY.asperity_describe, kind, name.encode())
    if not text:
        raise Error(last_error())
    lines = (line.partition(" = ") for line in text.splitlines())
    return {key: _DECODER.raw_decode(value)[0] for key, _, value in lines}


_DECODER = json.JSONDecoder()


def _with_ranges(values: dict[str, Any], made: type[Any], **others: Any) -> Any:
    """An entry, in which two ends are one range, and None what is not known."""
    values.update(others)
    for name in [name[:-4] for name in values if name.endswith("_low")]:
        values[f"{name}_range"] = values.pop(f"{name}_low"), values.pop(f"{name}_high")
    return made(**{field.name: values.get(field.name) for field in fields(made)})


def _pair(values: dict[str, Any]) -> Pair:
    first, second = values["name"].split("/")
    return _with_ranges(values, Pair, first=MATERIALS[first], second=MATERIALS[second])  # type: ignore[no-any-return]


MATERIALS: Mapping[str, Material] = _Known(_header.ASPERITY_NAMES_MATERIALS, lambda values: _with_ranges(values, Material))
PAIRS: Mapping[str, Pair] = _Known(_header.ASPERITY_NAMES_PAIRS, _pair)
INTERFACES: Mapping[str, Interface] = _Known(_header.ASPERITY_NAMES_INTERFACES, lambda values: _with_ranges(values, Interface))
