"""Surfaces as TOML files: fields of `Params` in SI units, or the materials and the roughness that they are made from.

`Params` hands itself to these functions, which therefore need not import it.
"""

from __future__ import annotations

import math
import os
import sys
from contextlib import contextmanager
from dataclasses import MISSING, fields, replace
from pathlib import Path
from typing import Any, Iterable, Iterator, TypeVar, Union

from .errors import Error, Status, nearest
from .materials import MATERIALS, Material
from .materials import contact as contact_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

FileName = Union[str, "os.PathLike[str]"]
Params = TypeVar("Params")

_ARRAYS = ("table_height", "table_density")
_MODULI = ("composite_modulus", "effective_shear_modulus")
_ROUGHNESS = ("height_std", "summit_radius", "asperity_count")
# One measured point: the load, and either of the others.
CALIBRATION = ("calibration_load", "calibration_friction_coefficient", "calibration_friction_force")
# What an interface by its name sets.
STRENGTH = ("slip_stress_1", "slip_stress_2", "pressure_coefficient")
_MATERIALS = ("first", "second", "E1", "nu1", "E2", "nu2")
_MOMENTS = ("m0", "m2", "m4")
_ISO = ("Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku")
# No surface needs more, not even one with tables of heights; a device such as /dev/zero has no end.
_LONGEST = 1 << 20


def read(file: FileName, params: type[Params]) -> Params:
    """The surface that a file describes; `Error` names the file, the key and what is allowed."""
    with named(file):
        made: Params = from_tables(tables(file, "surface file, whose keys docs/surface-file.md has"), params)
        return made


def tables(file: FileName, kind: str) -> dict[str, Any]:
    """The keys and tables of a TOML file, as they are; for use within `named`."""
    with open(file, "rb") as stream:
        text = stream.read(_LONGEST + 1)
    if len(text) > _LONGEST:
        raise Error(f"longer than 1 MiB: must be a {kind}", Status.INVALID_PARAMETER)
    return tomllib.loads(text.decode().replace("\r\n", "\n"))


@contextmanager
def named(file: FileName) -> Iterator[None]:
    """What is wrong with a file that is read within, as an `Error` that names it."""
    try:
        yield
    except tomllib.TOMLDecodeError as error:
        raise Error(f"{file}: no TOML: {error}", Status.INVALID_PARAMETER) from None
    except UnicodeDecodeError as error:
        raise Error(f"{file}: must be UTF-8: {error}", Status.INVALID_PARAMETER) from None
    except RecursionError:
        raise Error(f"{file}: must not have arrays or tables so deep inside each other", Status.INVALID_PARAMETER) from None
    except Error as error:
        raise Error(f"{file}: {error}", error.status) from None
    except (TypeError, KeyError, ValueError, OverflowError) as error:
        raise Error(f"{file}: {error.args[0]}", Status.INVALID_PARAMETER) from None


def write(params: Any, file: FileName) -> None:
    """Writes the fields that are not defaults; `read` makes equal parameters of them."""
    lines = ["# Two rough surfaces in contact, for asperity: SI units, names as in asperity_params."]
    chosen = {"height_distribution"} if params.height_distribution != "gaussian" or _chooses(params) else set()
    for field in fields(params):
        value = getattr(params, field.name)
        if value != field.default or field.name in chosen:
            lines.append(f"{field.name} = {_literal(value)}")
    Path(file).write_text("\n".join(lines) + "\n", encoding="utf-8")


def _chooses(params: Any) -> bool:
    """Whether a field of heights is set that would choose a family of them."""
    names = ("weibull_shape", "skew", "kurtosis", "table_height")
    return any(getattr(params, field.name) != field.default for field in fields(params) if field.name in names)


def _literal(value: Any) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, tuple):
        return f"[{', '.join(map(_literal, value))}]"
    return repr(value)  # of a float: TOML reads all that Python writes, inf and nan too


def from_tables(found: dict[str, Any], params: Any) -> Any:
    """The surface that keys and tables describe."""
    materials = _table(found, "materials", _MATERIALS)
    roughness = _table(found, "roughness", (*_MOMENTS, *_ISO, "Ra", "summits"))
    _check(found, (*(field.name for field in fields(params)), "materials", "roughness", "interface", *CALIBRATION), "")
    measured = {name: found[name] for name in CALIBRATION if name in found}
    others = ("materials", "roughness", "interface", *CALIBRATION)
    given = {name: value for name, value in found.items() if name not in others}
    if materials:
        _exclude(given, (*_MODULI, "tangential_modulus"), "materials")
        given = _contact(materials, given) | given
    if roughness:
        _exclude(given, _ROUGHNESS, "roughness")
        if "nominal_area" not in given:
            raise Error("nominal_area: must be set, since [roughness] gives the summits per area", Status.INVALID_PARAMETER)
        roughness = from_mean_deviation(roughness)
        _one_kind(roughness)
        make = params.from_iso25178 if roughness.keys() & set(_ISO) else params.from_spectral_moments
    else:
        make = params.si
    told = (_ROUGHNESS if roughness else ()) + (_MODULI if "E1" in given else ())
    _demand(given, [field.name for field in fields(params) if field.default is MISSING and field.name not in told])
    # Heights that the file names are taken with all their fields; else those fields choose them, as in Params.si.
    named = {name: given.pop(name) for name in _heights() if name in given and "height_distribution" in given}
    tangential = {name: given.pop(name) for name in ("tangential_modulus",) if name in given}
    made = replace(make(**given, **roughness), **named, **tangential)
    return calibrated(with_interface(made, found.get("interface"), given), measured)


def with_interface(params: Any, name: Any, given: dict[str, Any]) -> Any:
    """With the strength of an interface by its name, where there is one, which excludes what it sets among what is given."""
    if name is None:
        return params
    if not isinstance(name, str):
        raise Error(f"interface = {name!r}: must be the name of an interface", Status.INVALID_PARAMETER)
    _exclude(given, STRENGTH, "interface")
    return params.with_interface(name)


def calibrated(params: Any, measured: dict[str, Any]) -> Any:
    """With the strength of one measured point, by the names of `CALIBRATION`, where there is one."""
    if not measured:
        return params
    return params.replace(**measured)


def from_mean_deviation(roughness: dict[str, Any]) -> dict[str, Any]:
    """The same roughness with the standard deviation of the heights for their mean one, as Gaussian heights have it.

    Rq = Ra (pi/2)^(1/2): `Ra` replaces `m0` where `m2` and `m4` are given, otherwise `Sq`.
    """
    if "Ra" not in roughness:
        return roughness
    for name in ("m0", "Sq", "Ssk", "Sku"):
        if name in roughness:
            says = "which it replaces" if name in ("m0", "Sq") else "it is understood as that of Gaussian heights: give Sq"
            raise Error(f"Ra: must not be given together with {name}, {says}", Status.INVALID_PARAMETER)
    given = roughness["Ra"]
    if not isinstance(given, (int, float)) or not (math.isfinite(given) and given > 0):
        raise Error(f"Ra = {given!r}: must be finite and > 0", Status.INVALID_PARAMETER)
    rest = {name: value for name, value in roughness.items() if name != "Ra"}
    if rest.keys() & set(_MOMENTS):
        return {"m0": math.pi / 2 * given**2} | rest
    return {"Sq": math.sqrt(math.pi / 2) * given} | rest


def _heights() -> tuple[str, ...]:
    return ("weibull_shape", "skew", "kurtosis", *_ARRAYS, "height_distribution")


def _contact(materials: dict[str, Any], given: dict[str, Any]) -> dict[str, Any]:
    """Two bodies, by name or by their elasticity; what is known of a named pair comes with it."""
    bodies: list[Material | None] = []
    contact: dict[str, Any] = {}
    for body, name in enumerate(("first", "second"), 1):
        young, poisson = f"E{body}", f"nu{body}"
        if name not in materials:
            _demand(materials, (young, poisson), f"[materials] gives no name as `{name}`, so {{}} must be set there")
            contact |= {young: materials[young], poisson: materials[poisson]}
            bodies.append(None)
            continue
        _exclude(materials, (young, poisson), name)
        if not isinstance(materials[name], str):
            raise Error(f"{name} = {materials[name]!r}: must be the name of a material", Status.INVALID_PARAMETER)
        material = MATERIALS[materials[name]]
        contact |= {young: material.young, poisson: material.poisson}
        bodies.append(material)
    one, other = bodies
    if one and other:
        lengths = {name: given[name] for name in ("work_of_adhesion", "burgers_vector") if name in given}
        return contact_of(one.name, other.name, **lengths)
    return contact


def _table(found: dict[str, Any], name: str, known: Iterable[str]) -> dict[str, Any]:
    table = found.get(name, {})
    if not isinstance(table, dict):
        raise Error(f"{name} = {table!r}: must be a table, [{name}]", Status.INVALID_PARAMETER)
    _check(table, known, f"[{name}] ")
    return table


def _check(table: dict[str, Any], known: Iterable[str], where: str) -> None:
    """Refuses names that are none, and numbers that are none: TOML's true is one of Python's."""
    known = tuple(known)
    for name, value in table.items():
        if name not in known:
            message = f"{where}{name}: no such key; the nearest is {nearest(name, known)}"
            raise Error(message, Status.INVALID_PARAMETER)
        if isinstance(value, bool) and name != "attraction":
            raise Error(f"{where}{name} = {str(value).lower()}: must be a number", Status.INVALID_PARAMETER)


def _one_kind(roughness: dict[str, Any]) -> None:
    moments, iso = (sorted(roughness.keys() & set(kind)) for kind in (_MOMENTS, _ISO))
    if moments and iso:
        raise Error(f"[roughness] {iso[0]}: is not for spectral moments, as {moments[0]} is", Status.INVALID_PARAMETER)
    _demand(roughness, ("Sq", "Sdq") if iso else _MOMENTS, "[roughness] {}: must be set")


def _exclude(given: dict[str, Any], names: Iterable[str], by: str) -> None:
    for name in names:
        if name in given:
            raise Error(f"{name}: {by} sets it already, leave one out", Status.INVALID_PARAMETER)


def _demand(given: dict[str, Any], names: Iterable[str], message: str = "{}: must be set") -> None:
    for name in names:
        if name not in given:
            raise Error(message.format(name), Status.INVALID_PARAMETER)
