"""Whatever kind of array or number comes in at whatever public argument, its meaning is kept or it is refused by the name of the
argument: units are converted, masked numbers never count."""

from __future__ import annotations

import inspect
import math
import re
import warnings
from datetime import datetime
from decimal import Decimal
from pathlib import Path
from typing import Any, Callable, Iterator

import astropy.units
import numpy as np
import pandas
import pint
import pytest
import xarray
from astropy.utils.masked import Masked
from test_mistakes import DRAWS, INNER, PAPER, RIGHT, called, public, summits

import asperity
from asperity import Error, Model, Params, surface
from asperity._surface_text import Surface
from asperity.tools.checks import has_unit
from asperity.units import of

REGISTRY: Any = pint.UnitRegistry()
# Another unit of each, and how many of it are one of the first.
OTHERS = {"N": ("kN", 1e-3), "m": ("nm", 1e9), "Pa": ("MPa", 1e-6), "m^2": ("mm^2", 1e6), "N/m": ("kN/m", 1e-3), "": ("percent", 100.0)}
OTHERS |= {"1/m": ("1/mm", 1e-3), "1/m^2": ("1/mm^2", 1e-6), "rad": ("deg", 180 / math.pi), "s": ("ms", 1e3)}
# The units of arguments; those of keys and fields are told by `units.of`.
UNITS: dict[str, str] = {
    **dict.fromkeys(("load", "loads", "lightest", "heaviest", "force", "friction_force"), "N"),
    **dict.fromkeys(("gap", "displacement", "amplitude", "increment", "sphere_radius", "length", "cutoff", "longest", "dx", "dy"), "m"),
    "height_map": "m", "angle": "rad", "time": "s",
}  # fmt: skip
WHOLE = {"samples", "specimens", "seed", "count", "starts", "points", "detrend", "resamples", "block", "workers"}
# Arguments that are no numbers; that this is so is a test below.
NO_NUMBERS = {
    "pair", "free", "params", "loss", "quantity", "progress", "executor", "sampling", "checkpoint", "warnings", "rows", "spikes", "dust", "check",
    "path", "channel", "unit", "physical_sizes", "name", "first", "second", "text", "start", "summits", "process", "slope",
    "height_distribution", "attraction", "contact_law", "slip_onset", "waviness_shape", "taken_as_gaussian", "interface", "interface_kind", "found", "dtype", "shape", "keep", "details",
}  # fmt: skip
# Beside the arguments of `RIGHT`, one at a time: others that are right.
MORE: dict[str, dict[str, Any]] = {
    "fit": {"sigma": [0.01] * 4, "bounds": {"slip_stress": [1e-3, 0.9]}, "force": [0.4, 0.9, 2.5, 6.0]},
    "surface.filter": {"longest": 4e-7, "dy": 2e-8},
    "surface.cutoffs": {"cutoff": [8e-8, 1e-7], "dy": 2e-8},
    "surface.analyse": {"cutoff": 1.2e-7, "longest": 6e-7, "nominal_area": 1e-8, "dy": 2e-8},
    "surface.clean": {"dy": 2e-8},
    "surface.summits": {"dy": 2e-8},
    "study.study": {"vary": {"height_std": [5.0, 6.0]}, "block": 1, "workers": 1},
    "Model.curve": {"spread": {"gamma": 0.1}},
    "Params.si": {
        "composite_modulus": 8e10, "effective_shear_modulus": 6e10, "asperity_count": 1e5, "E1": 1e11, "nu1": 0.2, "E2": 1e11, "nu2": 0.2,
    },
    "Params.from_iso25178": {"Ra": 5e-9, "Ssc": 1e6, "Sds": 1e13, "Ssk": 0.1, "Sku": 3.2},
    "Params.from_profile": {"Rq": 5e-9, "RSm": 1e-6},
    "Params.from_spectral_moments": {"Ra": 5e-9, "m4": 1e12},
}  # fmt: skip
# With nothing left open an analysis takes a tenth of the time, and its friction is that of this map.
CLOSED: dict[str, Any] = {
    "cutoff": 1.2e-7, "contact_law": "maugis", "slip_stress_1": 0.02, "slip_stress_2": 0.02, "work_of_adhesion": 0.063, "known_to": {"slope": 1.0},
}  # fmt: skip
STEEL: dict[str, Any] = dict(pair="steel/steel", Ra=0.8e-6, process="ground", nominal_area=1e-4, load=10.0)
# Right values of the keys of a surface.
KEYS = {name: getattr(PAPER, name) for name in (field for field in Surface.__annotations__ if hasattr(PAPER, field))} | {
    "E1": 2e11, "nu1": 0.3, "E2": 2e11, "nu2": 0.3, "m0": 1e-14, "m2": 1e-2, "m4": 1e12, "Ra": 1e-7, "Rq": 1e-7, "RSm": 1e-5, "Rdq": 0.1, "Sq": 1e-7,
    "Sdq": 0.1, "Ssc": 1e5, "Sds": 1e12, "Ssk": 0.1, "Sku": 3.2, "summit_density": 1e12, "slip_stress_1": 0.02, "slip_stress_2": 0.001, "max_friction_coefficient": 10.0, "hardness": 1e9, "calibration_load": 10.0,
    "calibration_friction_coefficient": 0.2, "table_height": [0.0, 1.0, 2.0], "table_density": [0.1, 1.0, 0.1], "measured": [1000.0, 0.16],
    "size_effect": 0.5, "model_error": 0.1, "known_to": {"hardness": 1.2}, "measured_on": {"hardness": 3e9}, "specimens": 2,
    "heights_at_scores": [1e-7 * (score - 6) for score in range(13)], "slopes_at_scores": [0.1] * 13, "lay": 2.0,
}  # fmt: skip


def unaligned(values: Any, unit: str) -> Any:
    memory = np.zeros(values.nbytes + 1, dtype=np.uint8)
    array = memory[1:].view(np.float64).reshape(values.shape)
    array[...] = values
    return array


def read_only(values: Any, unit: str) -> Any:
    values = values.copy()
    values.setflags(write=False)
    return values


def strided(values: Any, unit: str) -> Any:
    return np.repeat(values, 2, axis=-1)[..., ::2] if values.ndim else values


def pint_of(values: Any, unit: str) -> Any:
    name, factor = OTHERS[unit]
    return REGISTRY.Quantity(values * factor, name)


def astropy_of(values: Any, unit: str) -> Any:
    name, factor = OTHERS[unit]
    return astropy.units.Quantity(values * factor, name)


def labelled(values: Any, **attributes: str) -> Any:
    return xarray.DataArray(values, dims=[f"axis{i}" for i in range(values.ndim)], attrs=attributes)


def each(make: Callable[[Any, str], Any]) -> Callable[[Any, str], Any]:
    """A list of numbers of a kind."""
    return lambda values, unit: [make(one, unit) for one in values] if values.ndim == 1 else make(values, unit)


def hidden(values: Any, secret: float) -> Any:
    """Masked at its first number."""
    mask = np.zeros(values.shape, dtype=bool)
    mask[(0,) * values.ndim] = True
    return np.ma.masked_array(np.where(mask, secret, values), mask)


def series(values: Any, dtype: str) -> Any:
    return pandas.Series(values, dtype=dtype) if values.ndim == 1 else values


def with_na(values: Any, unit: str) -> Any:
    return pandas.Series([pandas.NA, *values.tolist()[1:]], dtype="Float64") if values.ndim == 1 else pandas.NA


class Unreadable:
    def __array__(self, *_: Any, **__: Any) -> Any:
        raise RuntimeError("on another device")


# Kinds that mean the same numbers.
SAME: dict[str, Callable[[Any, str], Any]] = {
    "array": lambda values, unit: values,
    "big-endian": lambda values, unit: values.astype(">f8"),
    "unaligned": unaligned,
    "read-only": read_only,
    "strided": strided,
    "Fortran's order": lambda values, unit: np.array(values, order="F"),
    "long double": lambda values, unit: values.astype(np.longdouble),
    "nothing masked": lambda values, unit: np.ma.masked_array(values, False),
    "Series": lambda values, unit: series(values, "float64"),
    "nullable Series": lambda values, unit: series(values, "Float64"),
    "DataArray": lambda values, unit: labelled(values),
    "DataArray in its unit": lambda values, unit: labelled(values, units=unit),
    "DataArray in another unit": lambda values, unit: labelled(values * OTHERS[unit][1], units=OTHERS[unit][0]),
    "pint": pint_of,
    "astropy": astropy_of,
    "list of pint": each(pint_of),
    "tuple of astropy": lambda values, unit: tuple(each(astropy_of)(values, unit)) if values.ndim == 1 else astropy_of(values, unit),
    "pint in DataArray": lambda values, unit: labelled(pint_of(values, unit)),
    "pint without a mask": lambda values, unit: REGISTRY.Quantity(np.ma.masked_array(values, False), unit),
}
# Kinds that mean no numbers, or others.
REFUSED: dict[str, Callable[[Any, str], Any]] = {
    "complex": lambda values, unit: values.astype(complex),
    "bool": lambda values, unit: values.astype(bool),
    "True": lambda values, unit: True,
    "strings": lambda values, unit: values.astype(str),
    "text": lambda values, unit: "ten",
    "bytes": lambda values, unit: values.astype("S"),
    "dates": lambda values, unit: values.astype("datetime64[s]"),
    "spans of time": lambda values, unit: values.astype("timedelta64[s]"),
    "a date": lambda values, unit: datetime(2020, 1, 1),
    "object": lambda values, unit: values.astype(object) if values.ndim else object(),
    "Decimal": lambda values, unit: each(lambda one, _: Decimal(float(one)))(values, unit) if values.ndim < 2 else object(),
    "ragged": lambda values, unit: [[1.0], [1.0, 2.0]],
    "mapping": lambda values, unit: {1.0: 2.0},
    "structured": lambda values, unit: np.zeros(3, dtype=[("load", float)]),
    "unreadable": lambda values, unit: Unreadable(),
    "wrong pint": lambda values, unit: REGISTRY.Quantity(values, "kelvin"),
    "wrong astropy": lambda values, unit: astropy.units.Quantity(values, "K"),
    "list of wrong pint": each(lambda values, unit: REGISTRY.Quantity(values, "kelvin")),
    "wrong unit in DataArray": lambda values, unit: labelled(values, units="K"),
    "no such unit in DataArray": lambda values, unit: labelled(values, units="wug"),
    "categories": lambda values, unit: pandas.Series(["a", "b"], dtype="category"),
}
# Kinds with a number that is not known, and might be this.
HIDDEN: dict[str, Callable[[Any, str, float], Any]] = {
    "masked": lambda values, unit, secret: hidden(values, secret),
    "pandas' NA": lambda values, unit, secret: with_na(values, unit),
    "numpy's masked": lambda values, unit, secret: [np.ma.masked, *values.tolist()[1:]] if values.ndim == 1 else np.ma.masked,
    "masked pint": lambda values, unit, secret: REGISTRY.Quantity(hidden(values, secret), unit),
    "astropy's masked": lambda values, unit, secret: Masked(hidden(values, secret).data, mask=hidden(values, secret).mask) * astropy.units.Unit(unit),
}
# These leave masked numbers out; all others refuse them.
LEAVE_OUT = {("fit", name) for name in ("load", "mu", "sigma", "force")} | {(f"surface.{name}", "height_map") for name in ("clean", "analyse")}
LEAVE_OUT |= {("friction", "measured")}
# No parameters tell what these loads are in.
OWN_SYSTEM = {("loads.PairLoads.add", "load")}


def cases() -> Iterator[tuple[str, str, Any]]:
    """Each function, argument of numbers and right value."""
    for name, (_, arguments) in RIGHT.items():
        for argument, value in {**arguments(), **MORE.get(name, {})}.items():
            if argument in NO_NUMBERS or value is None or (isinstance(value, tuple) and not value) or isinstance(value, (str, bool)):
                continue
            yield name, argument, value
    yield from (("friction", key, value) for key, value in KEYS.items() if not isinstance(value, (str, bool)))
    yield from (("Params.replace", key, value) for key, value in KEYS.items() if hasattr(PAPER, key) and not isinstance(value, (str, bool)))


def at(value: Any, made: Callable[[Any], Any]) -> Any:
    """What is made of numbers, in the mapping that they are the only value of, if it is one."""
    if isinstance(value, dict):
        ((key, inner),) = value.items()
        return {key: made(np.asarray(inner, dtype=np.float64))}
    return made(np.asarray(value, dtype=None if isinstance(value, int) else np.float64))


def unit_of(name: str, argument: str, value: Any) -> str:
    if argument == "vary" and isinstance(value["height_std" if "height_std" in value else "gamma"], list):
        return "m"
    if argument == "measured_on":
        return "Pa"
    if argument in ("measured", "spread", "vary", "bounds", "mu", "sigma"):
        return ""
    return UNITS.get(argument, of(argument))


def answer(name: str, argument: str, value: Any) -> Any:
    """What a call answers, or the words of its refusal, and whether it is one."""
    given = dict({"friction": STEEL, "surface.analyse": CLOSED}.get(name, {}))
    if argument == "measured_on" or (name, argument) == ("friction", "specimens"):
        given["measured"] = (1000.0, 0.16)
    if name == "fit" and argument == "force":
        given["mu"] = None
    if name == "Params.si" and argument in ("composite_modulus", "effective_shear_modulus", "asperity_count"):
        given |= {"E1": 1e11}
    if name.startswith("surface.") and argument in ("height_map", "dx", "dy") + ("cutoff", "longest") * (name != "surface.analyse"):
        if has_unit(value) or isinstance(value, (list, tuple)) and has_unit(value[0]):  # heights and distances have units, or none of them has
            right = RIGHT[name][1]()
            given |= {"height_map": right["height_map"] * astropy.units.m, "dx": 20 * astropy.units.nm, "dy": None}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", asperity.ValidityWarning)
        warnings.simplefilter("ignore", surface.MapWarning)
        try:
            found = called(name, given | {argument: value})
        except (TypeError, Error) as error:
            return f"{error}", True
        if isinstance(found, asperity.Estimate):
            found = found._text
        if isinstance(found, asperity.States):
            found = list(found)
        return plain(found), False


def plain(found: Any) -> Any:
    """Without labels, and in full."""
    if isinstance(found, tuple) and type(found) is tuple or isinstance(found, list):
        return [plain(one) for one in found]
    if isinstance(found, (xarray.DataArray, pandas.Series)):
        found = found.to_numpy()
    return found.tolist() if isinstance(found, np.ndarray) else found


NUMBER = re.compile(r"-?\d+\.?\d*(?:e[-+]?\d+)?")


def is_like(one: Any, other: Any) -> bool:
    """Whether two answers are the same but for rounding."""
    texts = [re.sub(r" at 0x\w+|<xarray.Dataset>.*", "", f"{found}") for found in (one, other)]
    one, other = ([float(number) for number in NUMBER.findall(text)] for text in texts)
    return len(one) == len(other) and bool(np.allclose(one, other, rtol=1e-3, atol=0))


IDS = [f"{name} {argument}" for name, argument, _ in cases()]


def parameters() -> Iterator[tuple[str, str, str]]:
    """Each public function, argument and annotation, those of keywords too."""
    for name, function in public():
        for argument, told in inspect.signature(function).parameters.items():
            if argument != "self" and told.kind is not told.VAR_KEYWORD and name.rpartition(".")[2] not in DRAWS and name not in INNER:
                yield name, argument, str(told.annotation)
    for key, annotation in Surface.__annotations__.items():
        yield "friction", key, getattr(annotation, "__forward_arg__", str(annotation))


def test_every_argument_of_numbers_is_tried_and_no_other_takes_any() -> None:
    tried = {(name, argument) for name, argument, _ in cases()}
    left = {(name, argument): annotation for name, argument, annotation in parameters() if (name, argument) not in tried}
    others = {argument for _, argument in left} - {"first", "second"}
    assert {one for one in left if one[1] not in NO_NUMBERS} == set()
    assert others | {"first", "second"} == NO_NUMBERS
    numbers = {one for one, annotation in left.items() if re.search(r"float|ArrayLike|Numbers|\bint\b", annotation)}
    assert numbers == {("Model.microslip", "shape"), ("Model.each_specimen_at_loads", "first"), ("surface.read", "channel")}
    assert LEAVE_OUT | OWN_SYSTEM <= tried


@pytest.mark.parametrize("name, argument, value", list(cases()), ids=IDS)
def test_numbers_of_every_kind_are_understood_or_refused(name: str, argument: str, value: Any) -> None:
    unit = unit_of(name, argument, value)
    right, refused = answer(name, argument, value)
    for kind, make in SAME.items():
        if argument in WHOLE and kind != "array" or argument == "measured" and kind in ("list of pint", "tuple of astropy"):
            continue  # a point has numbers of several units
        given = at(value, lambda values: make(values, unit))
        found, is_refused = answer(name, argument, given)
        if (name, argument) in OWN_SYSTEM and has_unit(given):
            assert is_refused and f"{argument}: has the unit" in found, f"{kind}: {found}"
            continue
        assert is_refused == refused and is_like(found, right), f"{kind}: {found}, not {right}"
    for kind, make in REFUSED.items():
        found, is_refused = answer(name, argument, at(value, lambda values: make(values, unit)))
        assert is_refused and argument in str(found), f"{kind}: {found}"
    for kind, make_hidden in HIDDEN.items():
        several = [answer(name, argument, at(value, lambda values: make_hidden(values, unit, secret))) for secret in (1e9, 7.0)]
        assert str(several[0]) == str(several[1]), f"{kind}: {several}"
        if (name, argument) not in LEAVE_OUT:
            assert several[0][1] and argument in several[0][0], f"{kind}: {several[0]}"


@pytest.mark.parametrize("make", [pint_of, astropy_of], ids=["pint", "astropy"])
def test_a_unit_is_refused_where_the_system_of_units_is_the_callers_own(make: Any) -> None:
    own, load = Model(Params.paper()), make(np.asarray(10.0), "N")
    calls: list[Callable[[], Any]] = [
        lambda: own.friction_at_load(load),
        lambda: own.state_at_load([load]),
        lambda: own.curve(load),
        lambda: own.params.calibrated(load, 0.3),
        lambda: own.params.replace(height_std=make(np.asarray(5.0), "m")),
        lambda: asperity.uncertainty(own.params, None, load),
        lambda: asperity.fit([load, load, load], [0.1, 0.1, 0.1], params=own.params),
        lambda: surface.summits(summits().heights.reshape(1, -1), make(np.asarray(1.0), "m")),
    ]
    for call in calls:
        with pytest.raises(TypeError, match="has the unit .* system of units is your own|must have a unit if the heights"):
            call()


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_points_of_which_a_number_is_masked_are_left_out() -> None:
    load, mu = np.array([10.0, 100.0, 1000.0, 1e4]), np.array([0.2, 0.19, 0.17, 5.0])
    free, masked = ["slip_stress"], np.array([False, False, False, True])
    surfaces = asperity.friction(**STEEL).params
    right = asperity.fit(load[:3], mu[:3], [0.01] * 3, free, params=surfaces)
    cases: list[tuple[Any, Any, Any]] = [
        (np.ma.masked_array(load, masked), mu, [0.01] * 4),
        (load, np.ma.masked_array(mu, masked), 0.01),
        (load, pandas.Series([0.2, 0.19, 0.17, None], dtype="Float64"), [0.01] * 4),
        (load, mu, np.ma.masked_array([0.01] * 4, masked)),
    ]
    for given in cases:
        assert asperity.fit(*given, free, params=surfaces).values == right.values
    points = np.ma.masked_array(np.stack([load, mu], axis=1), np.stack([masked, ~masked & masked], axis=1))
    found = asperity.friction(**STEEL, measured=points)
    assert found.value == asperity.friction(**STEEL, measured=np.stack([load, mu], axis=1)[:3]).value
    with pytest.raises(Error, match="measured: all points are masked"):
        asperity.friction(**STEEL, measured=np.ma.masked_array(points, True))
    for nothing, error in ((np.ma.masked, Error), (np.array(5.0), Error), (REGISTRY.Quantity(5.0, "N"), TypeError), ([points[0], 5.0], TypeError),
                           ([points[0], [Unreadable(), 0.2]], TypeError)):
        with pytest.raises(error, match="^measured"):
            asperity.friction(**STEEL, measured=nothing)


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_a_quantity_is_converted_and_answered_with_plain_numbers() -> None:
    surfaces = asperity.friction(**STEEL | {"load": 1.0}, measured=(REGISTRY.Quantity(1.0, "kN"), 0.16)).params
    law = Model(surfaces)
    for one in (REGISTRY.Quantity(1.0, "kN"), 1 * astropy.units.kN):
        assert law.friction_at_load(one) == law.friction_at_load(1000.0) and type(law.friction_at_load(one)) is float
        assert law.state_at_load(one).gap == law.state_at_load(1000.0).gap
    assert law.load_at_gap(1 * astropy.units.um) == law.load_at_gap(1e-6)
    assert asperity.friction(**{**STEEL, "nominal_area": REGISTRY.Quantity(1, "cm^2")}).value == pytest.approx(asperity.friction(**STEEL).value)
    pressed = {name: value for name, value in STEEL.items() if name not in ("nominal_area", "load")}
    assert asperity.friction(**pressed, load=1 * astropy.units.MPa).value == asperity.friction(**pressed, load=1e6).value
    with pytest.raises(TypeError, match="load: has the unit N, must be in Pa"):
        asperity.friction(**pressed, load=1 * astropy.units.N)
    with pytest.raises(TypeError, match="load: has the unit MPa, must be in N"):
        law.friction_at_load(1 * astropy.units.MPa)


def test_sizes_of_a_file_may_have_a_unit(tmp_path: Path) -> None:
    np.save(tmp_path / "map.npy", np.random.default_rng(1).normal(size=(16, 16)))
    sizes = surface.read(tmp_path / "map.npy", unit="nm", physical_sizes=(1600.0, 1600.0))
    found = surface.read(tmp_path / "map.npy", unit="nm", physical_sizes=(1.6 * astropy.units.um, 1.6 * astropy.units.um))
    assert found.dx == pytest.approx(sizes.dx)
    with pytest.raises(TypeError, match="physical_sizes: has the unit"):
        surface.read(tmp_path / "map.npy", physical_sizes=REGISTRY.Quantity([1.6, 1.6], "um"))
