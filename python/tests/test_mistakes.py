"""One kind of mistake raises one kind of exception, in every public function: `Error` for what a value, a word or a name may not be,
`TypeError` for another type and for a keyword that the function does not have, `OSError` for a file that cannot be opened."""

from __future__ import annotations

import inspect
import math
from functools import lru_cache
from typing import Any, Callable, Iterator

import numpy as np
import pytest

import asperity
from asperity import Error, Model, Params, loads, materials, study, surface
from asperity.errors import UnknownKey

SILICON = materials.PAIRS["Si/Si"].contact
PAPER = Params.paper().replace(in_si=True)
LOADS = [1.0, 3.0, 10.0, 30.0]
STEEL: dict[str, Any] = {"pair": "steel/steel", "Ra": 0.8e-6, "process": "ground", "nominal_area": 1e-4, "load": 10.0, "coverage": 0.95}
ROUGH: dict[str, Any] = {"nominal_area": 1e-8, "summits": "moments", **SILICON}


@lru_cache(maxsize=None)
def model() -> Model:
    return Model(PAPER)


@lru_cache(maxsize=None)
def height_map() -> dict[str, Any]:
    waves = np.random.default_rng(1).normal(size=(40, 40))
    for axis in (0, 1):
        waves = np.sum([np.roll(waves, shift, axis) for shift in range(9)], axis=0)
    return {"height_map": 5e-9 * waves / waves.std(), "dx": 2e-8, "dy": 2e-8}


@lru_cache(maxsize=None)
def summits() -> surface.Summits:
    return surface.summits(**height_map())


@lru_cache(maxsize=None)
def fitted() -> asperity.Fit:
    return asperity.fit(LOADS, model().friction_at_load(np.array(LOADS)), free=["slip_stress"], params=PAPER)


@lru_cache(maxsize=None)
def studied() -> Any:
    varied = {"gamma": 0.1, "slip_stress": 0.1}
    return study.study(PAPER, varied, LOADS, 16, progress=False, warnings=False, sampling="saltelli")


# Of each public function, by its name: the object that has it, and arguments that are right.
RIGHT: dict[str, tuple[Callable[[], Any], Callable[[], dict[str, Any]]]] = {
    "friction": (lambda: asperity, lambda: STEEL | {"measured": (1000.0, 0.16)}),
    "fit": (
        lambda: asperity,
        lambda: {"load": LOADS, "mu": [0.4, 0.3, 0.25, 0.2], "sigma": None, "free": ["slip_stress"], "params": PAPER, "bounds": None}
        | {"loss": "linear", "starts": 1, "seed": 0},
    ),
    "uncertainty": (
        lambda: asperity,
        lambda: {"params": PAPER, "spread": {"gamma": 0.1}, "loads": LOADS, "quantity": "mu", "samples": 0, "seed": 0, "coverage": 0.95},
    ),
    "pads": (lambda: asperity, lambda: {"params": PAPER.replace(asperity_count=100.0), "loads": [10.0], "count": 2, "sphere_radius": 0.0, "seed": 0}),
    "study.study": (
        lambda: study,
        lambda: {"params": PAPER, "vary": {"gamma": 0.1}, "loads": LOADS, "samples": 2, "seed": 0, "sampling": "sobol", "progress": False}
        | {"executor": None, "workers": None, "block": None},
    ),
    "study.sobol_indices": (
        lambda: study,
        lambda: {"found": studied(), "quantity": "friction_force", "coverage": 0.95, "resamples": 9, "seed": 0},
    ),
    "surface.summits": (lambda: surface, lambda: height_map() | {"detrend": 1}),
    "surface.clean": (lambda: surface, lambda: height_map() | {"detrend": 1}),
    "surface.filter": (lambda: surface, lambda: height_map() | {"cutoff": 1e-7, "longest": None}),
    "surface.cutoffs": (lambda: surface, lambda: height_map() | {"load": 1e-4, "cutoff": [1e-7], **SILICON}),
    "surface.analyse": (
        lambda: surface,
        lambda: height_map() | {"load": 1e-4, "pair": "Si/Si", "nominal_area": 1e-10, "detrend": 1, "coverage": 0.95},
    ),
    "surface.read": (lambda: surface, lambda: {"path": __file__}),
    "materials.contact": (lambda: materials, lambda: {"first": "Si", "second": "Si"}),
    "materials.Material.need": (lambda: materials.MATERIALS["PDMS"], lambda: {"name": "young"}),
    "materials.Pair.need": (lambda: materials.PAIRS["Si/Si"], lambda: {"name": "hamaker"}),
    "materials.Pair.contact_with": (lambda: materials.PAIRS["Si/Si"], lambda: {}),
    "loads.PairLoads.add": (lambda: loads.PairLoads(), lambda: {"first": 1, "second": 2, "load": 3.0}),
    "loads.PairLoads.expected": (lambda: loads.PairLoads(), lambda: {"first": 1, "second": 2, "time": 3.0}),
    "loads.PairLoads.end_step": (lambda: loads.PairLoads(), lambda: {"time": 3.0}),
    "Params.si": (
        lambda: Params,
        lambda: {"height_std": 5e-9, "summit_radius": 1e-6, "summit_density": 1e13, "nominal_area": 1e-8, **SILICON},
    ),
    "Params.dimensionless": (lambda: Params, lambda: {"alpha": 0.01, "beta": 1000, "gamma": 0.001, "b_over_h": 1.0, "poisson": 0.3}),
    "Params.from_iso25178": (lambda: Params, lambda: {"Sq": 5e-9, "Sdq": 0.08} | ROUGH),
    "Params.from_profile": (lambda: Params, lambda: {"Ra": 5e-9, "Rdq": 0.08} | ROUGH),
    "Params.from_spectral_moments": (lambda: Params, lambda: {"m0": 25e-18, "m2": 0.0032} | ROUGH),
    "Params.from_topography": (lambda: Params, lambda: {"summits": summits(), "nominal_area": 1e-8, **SILICON}),
    "Params.from_text": (lambda: Params, lambda: {"text": PAPER.replace(in_si=True).to_text(), "start": None}),
    "Params.from_toml": (lambda: Params, lambda: {"path": __file__}),
    "Params.to_toml": (lambda: Params.paper(), lambda: {"path": __file__}),
    "Params.replace": (lambda: PAPER, lambda: {"height_std": 10.0, "attraction": True, "table_height": (), "contact_law": "maugis"}),
    "Params.calibrated": (lambda: PAPER, lambda: {"load": 100.0, "friction_coefficient": 0.3, "error": 0.05}),
    "Params.calibrated_force": (lambda: PAPER, lambda: {"load": 100.0, "friction_force": 30.0, "error": 0.05}),
    "Params.elastic_plastic": (lambda: PAPER, lambda: {"hardness": 0.1}),
    "Params.with_interface": (lambda: Params.from_iso25178(Sq=5e-9, Sdq=0.08, **ROUGH), lambda: {"name": "DLC/sapphire"}),
    "Params.in_units": (lambda: PAPER, lambda: {"length": 1.0, "force": 1.0}),
    "Model.check": (model, lambda: {"lightest": 1.0, "heaviest": 10.0}),
    "Model.warn": (model, lambda: {"lightest": 1.0, "heaviest": 10.0}),
    "Model.curve": (model, lambda: {"loads": LOADS, "spread": None, "coverage": 0.95, "samples": 0, "seed": 0}),
    "Model.hysteresis": (model, lambda: {"load": 1.0, "amplitude": 0.1, "points": 11}),
    "Model.load_at_gap": (model, lambda: {"gap": 1.0}),
    "Model.state_at_gap": (model, lambda: {"gap": 1.0}),
    "Model.microslip": (model, lambda: {"shape": 2}),
    "Microslip.step": (lambda: model().microslip(2), lambda: {"load": 1.0, "increment": 0.1}),
    "Microslip.turn": (lambda: model().microslip(2), lambda: {"angle": 0.1}),
    "Model.set_params": (lambda: Model(PAPER), lambda: {"params": PAPER}),
    "Model.each_specimen_at_loads": (model, lambda: {"load": 10.0, "specimens": 2, "sphere_radius": 0.0, "seed": 0, "first": 0}),
    "Model.table": (model, lambda: {"dtype": np.float64}),
    "Model.tangential": (model, lambda: {"load": 1.0, "displacement": 0.1}),
    "Fit.predict": (fitted, lambda: {"load": LOADS}),
    "Fit.reach": (fitted, lambda: {"coverage": 0.95}),
    "Model.unloaded": (model, lambda: {"largest_load": 1.0}),
    **{
        f"Model.{name}": (model, lambda: {"load": 1.0})
        for name in ("friction_at_load", "friction_force_at_load", "tangential_stiffness_at_load", "state_at_load")
    },
}
# Functions that are given nothing but a file or axes to draw on, or what only the package gives them.
DRAWS = {"plot", "plot_sobol_indices"}
INNER = {"States.of", "surface.Estimate.scaled", "surface.Summits.warnings_at"}
# Arguments that Python or NumPy checks in words of their own, or that may be anything.
OWN_WORDS = {"path", "dtype", "shape", "progress", "first", "second"}

# The function, what is changed in its right arguments, the exception, and the words of its message.
MISTAKES: list[tuple[str, dict[str, Any], type[Exception], str]] = [
    ("friction", {"pair": None}, Error, "composite_modulus: must be set; two materials set it, by their names or by E1, nu1, E2 and nu2"),
    ("friction", {"coverage": 95}, Error, r"coverage = 95: must be between 0 and 1: is it in per cent\?"),
    ("friction", {"load": math.nan}, Error, "load = NaN: must be finite"),
    ("friction", {"Rz": 5e-6}, TypeError, "Rz: no such key; a height from peak to valley"),
    ("friction", {"known_to": 1.2}, TypeError, "known_to = 1.2: must be a mapping of keys to values"),
    ("friction", {"measured": {1000: 0.16}}, TypeError, r"measured = {1000: 0.16}: must be \(load, coefficient\)"),
    ("fit", {"free": ["gama"]}, Error, "name 'gama': must be one of .*gamma"),
    ("uncertainty", {"spread": {"gama": 0.1}}, Error, "name 'gama': must be one of"),
    ("uncertainty", {"loads": "heavy"}, TypeError, "loads: must be real numbers"),
    ("pads", {"count": 1}, Error, "count = 1: must be 2 or more"),
    ("pads", {"loads": []}, Error, "loads: must be a real number or a one-dimensional array of one or more"),
    ("study.study", {"vary": {"gama": 0.1}}, Error, "'gama': no parameter has this name; the nearest is gamma"),
    ("study.study", {"vary": {}}, Error, "vary = {}: must name one parameter or more"),
    ("study.study", {"sampling": "monte carlo"}, Error, "sampling = 'monte carlo': must be one of 'sobol'"),
    ("study.study", {"seed": -1}, Error, "seed = -1: must be from 0"),
    ("study.sobol_indices", {"quantity": "mu"}, Error, "quantity = 'mu': must be one of 'friction_coefficient'"),
    ("surface.summits", {"dx": -1.0}, Error, "dx = -1.0: must be finite and > 0"),
    ("surface.summits", {"detrend": 9}, Error, "detrend = 9: must be from 0 to 8"),
    ("surface.summits", {"dx": None}, TypeError, "give dx, the distance of columns"),
    ("surface.clean", {"height_map": np.ones((9, 9))}, Error, "height_map: constant at 1.0: must be rough"),
    ("surface.filter", {"cutoff": 1.0}, Error, "cutoff = 1: must be from two points"),
    ("surface.cutoffs", {"load": 0.0}, Error, "load = 0.0: must be finite and > 0"),
    ("surface.analyse", {"pair": "steal/steel"}, Error, "steal/steel: no pair has this name; the nearest is steel/steel"),
    ("surface.analyse", {"dx": -1.0}, Error, "dx = -1.0: must be finite and > 0"),
    ("surface.analyse", {"cutoff": math.nan}, Error, "cutoff = nan: must be finite and > 0"),
    ("surface.analyse", {"longest": 0.0}, Error, "longest = 0.0: must be finite and > 0"),
    ("surface.analyse", {"coverage": 95}, Error, "coverage = 95: must be between 0 and 1"),
    ("surface.read", {"path": "no such file"}, FileNotFoundError, "no such file"),
    ("materials.contact", {"first": "unobtainium"}, Error, "unobtainium: no material has this name; docs/materials.md lists them"),
    ("materials.Material.need", {"name": "hardness"}, Error, "hardness of PDMS: no source is known here"),
    ("materials.Material.need", {"name": "yung"}, Error, "name = 'yung': must be one of 'name', 'young'"),
    ("materials.Pair.need", {"name": "yung"}, Error, "name = 'yung': must be one of 'first'"),
    ("loads.PairLoads.add", {"load": -1.0}, Error, "load = -1.0 of 1 on 2: must be finite and not negative"),
    ("Params.si", {"hardnes": 1e9}, TypeError, "hardnes: no parameter has this name; the nearest is hardness"),
    ("Params.si", {"Sq": 1e-9}, TypeError, "Sq: is an argument of Params.from_iso25178"),
    ("Params.si", {"mu": 0.3}, TypeError, "mu: no parameter has this name; give calibration_friction_coefficient"),
    ("Params.si", {"interface": "DLC/sapphire"}, TypeError, "interface: is an argument of asperity.friction"),
    ("Params.si", {"asperity_count": 5.0}, Error, "give either asperity_count, or summit_density and nominal_area"),
    ("Params.si", {"skew": 0.1, "weibull_shape": 2.0}, Error, "do not give weibull_shape too"),
    ("Params.calibrated", {"load": 0.3, "friction_coefficient": 1e-5}, Error, "are the two swapped"),
    ("Params.from_iso25178", {"Sdq": 3.0}, Error, r"Sdq: makes a slope of 2.12.* is it in degrees or per cent\?"),
    ("Params.from_text", {"text": ""}, Error, "composite_modulus: must be set; two materials set it"),
    ("Params.si", {"calibration_load": 5.0}, Error, "calibration_load goes with one of"),
    ("Params.dimensionless", {"alpha": -1.0}, Error, "alpha = -1"),
    ("Params.from_iso25178", {"summits": "all"}, Error, "summits = 'all': must be one of 'moments', 'mccool'"),
    ("Params.from_iso25178", {"Rz": 1e-6}, TypeError, "Rz: no parameter has this name; a height from peak to valley"),
    ("Params.from_profile", {"Rq": 1e-9}, Error, "Ra: must not be given together with Rq, which it replaces"),
    ("Params.from_spectral_moments", {"m2": -1.0}, Error, "m2 = -1: must be finite and > 0"),
    ("Params.from_topography", {"nominal_area": 0.0}, Error, "nominal_area"),
    ("Params.from_text", {"text": "height = 1"}, Error, "line 1: height: no such key"),
    ("Params.from_toml", {"path": "no such file"}, FileNotFoundError, "no such file"),
    ("Params.from_toml", {"path": "."}, IsADirectoryError, "."),
    ("Params.to_toml", {}, Error, "in_si = False: must be True"),
    ("Params.replace", {"contact_law": "hertz"}, Error, "contact_law = 'hertz': must be one of 'maugis', 'elastic-plastic'"),
    ("Params.replace", {"attraction": "yes"}, TypeError, "attraction = 'yes': must be True or False"),
    ("Params.replace", {"table_density": [1.0]}, Error, "table_density: 1 numbers for 0 heights"),
    ("Params.calibrated", {"friction_coefficient": 30.0}, Error, r"friction_coefficient = 30: must be > 0 and at most 20; is it a force\?"),
    ("Params.calibrated", {"error": 5.0}, Error, "calibration_error = 5: must be at most 1"),
    ("Params.calibrated_force", {"friction_force": -1.0}, Error, "friction_force = -1 at load = 100: must be finite and above 0"),
    ("Params.elastic_plastic", {"hardness": 0.0}, Error, "hardness = 0.0: must be finite and > 0"),
    ("Params.with_interface", {"name": "graphite"}, Error, "graphite: no interface has this name; the nearest is "),
    ("Params.in_units", {"length": 0.0}, Error, "length = 0: must be finite and > 0"),
    ("Model.check", {"lightest": math.nan}, Error, "lightest = NaN: must be finite"),
    ("Model.warn", {"heaviest": math.nan}, Error, "heaviest = NaN: must be finite"),
    ("Model.curve", {"loads": [-1.0]}, Error, "loads: must be > 0, since their axis is logarithmic"),
    ("Model.hysteresis", {"amplitude": 0.0}, Error, "amplitude = 0.0: must be finite and > 0"),
    ("Model.load_at_gap", {"gap": math.nan}, Error, "gap = NaN: must be finite"),
    ("Microslip.step", {"load": [1.0, 2.0, 3.0]}, Error, r"load of shape \(3,\): must have the shape of the contacts, \(2,\)"),
    ("Microslip.turn", {"angle": [1.0, 2.0, 3.0]}, Error, r"angle of shape \(3,\): must have the shape of the contacts"),
    ("Model.table", {"dtype": "float16"}, Error, "dtype = float16: must be float64 or float32"),
    ("Model.friction_at_load", {"load": math.nan}, Error, "load = NaN: must be finite"),
    ("Model.state_at_load", {"load": math.inf}, Error, "load = inf: must be finite"),
    ("Model.unloaded", {"largest_load": math.nan}, Error, "largest_load = NaN: must be finite"),
    ("Fit.predict", {"load": 1.0}, Error, "load: must be a one-dimensional array of one or more real numbers"),
    ("Fit.reach", {"coverage": 1.0}, Error, "coverage = 1.0: must be between 0 and 1"),
]


def called(name: str, changes: dict[str, Any]) -> Any:
    owner, arguments = RIGHT[name]
    return getattr(owner(), name.rpartition(".")[2])(**arguments() | changes)


def public() -> Iterator[tuple[str, Any]]:
    """All functions and methods that take arguments, by their names."""
    for prefix, module in (("", asperity), ("study.", study), ("surface.", surface), ("materials.", materials), ("loads.", loads)):
        own = [name for name, value in vars(module).items() if getattr(value, "__module__", "") == module.__name__ and name[0] != "_"]
        for name in getattr(module, "__all__", own):
            value = getattr(module, name)
            if inspect.isfunction(value):
                yield prefix + name, value
            elif inspect.isclass(value):
                for method, found in inspect.getmembers(value, inspect.isroutine):
                    if method[0] != "_" and (getattr(found, "__module__", None) or "").startswith("asperity"):
                        yield f"{prefix}{name}.{method}", found


def test_every_public_function_is_in_the_table() -> None:
    names = {name for name, function in public() if set(inspect.signature(function).parameters) - {"self"}}
    assert {name for name in names - INNER if name.rpartition(".")[2] not in DRAWS} == RIGHT.keys()
    assert {name for name, *_ in MISTAKES} <= RIGHT.keys()


@pytest.mark.parametrize("name, changes, error, words", MISTAKES, ids=[f"{name} {list(changes)}" for name, changes, *_ in MISTAKES])
def test_a_mistake_raises_what_its_kind_does(name: str, changes: dict[str, Any], error: type[Exception], words: str) -> None:
    with pytest.raises(error, match=words) as caught:
        called(name, changes)
    assert error is not Error or not isinstance(caught.value, TypeError)


@pytest.mark.parametrize("name", RIGHT)
def test_another_type_and_an_unknown_keyword_are_type_errors(name: str) -> None:
    """Each argument in turn; all others are right."""
    for argument in RIGHT[name][1]().keys() - OWN_WORDS:
        with pytest.raises(TypeError, match=argument):
            called(name, {argument: object()})
    if "materials" not in name:  # which hands on what is given
        with pytest.raises(TypeError, match="no_such_keyword"):
            called(name, {"no_such_keyword": 1.0})


@pytest.mark.parametrize("table", [materials.MATERIALS, materials.PAIRS, materials.INTERFACES])
def test_a_name_that_a_table_does_not_have_is_a_key_error_too(table: Any) -> None:
    for kind in (Error, KeyError, UnknownKey):
        with pytest.raises(kind, match="^unobtainium: no .* has this name; "):
            table["unobtainium"]
