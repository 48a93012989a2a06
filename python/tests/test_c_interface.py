"""Every function of the header, called through ctypes with arguments made from its prototype: plausible ones, NULL and NaN."""

from __future__ import annotations

import ctypes
import math
from typing import Any

import pytest

from asperity import Model, Params, Status, _header, _library, errors

SURFACE = b"pair = 'Si/Si'\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n"
NAMES = {"asperity_params_get_value": b"hardness", "asperity_params_set_pair": b"Si/Si", "asperity_describe": b"hardness"}
# What else than OK these arguments give: there is no such file, no surface has three equal moments, and a sphere needs an area.
REFUSED = ("asperity_params_read", "asperity_params_set_spectral_moments", "asperity_each_specimen_at_loads")
# Adhesion is not modelled in unloading.
ELSE = dict.fromkeys(REFUSED, Status.INVALID_PARAMETER) | {"asperity_unloaded": Status.OUT_OF_RANGE}
# Their only pointer may be NULL, or there is none.
WITHOUT_POINTERS = {"asperity_estimate_text", "asperity_params_text", "asperity_describe", "asperity_last_error", "asperity_warnings_text"}


def made(name: str, value: float) -> list[Any]:
    """One contact at the load `value`, and whatever else a function takes."""
    arguments: list[Any] = []
    for kind in _header.PROTOTYPES[name][1]:
        if kind is ctypes.c_char_p:
            arguments.append(NAMES.get(name, SURFACE))
        elif kind is ctypes.c_size_t:
            text = bool(arguments) and isinstance(arguments[-1], bytes)
            arguments.append(len(SURFACE) if text else ctypes.sizeof(_header.asperity_params) if name == "asperity_params_init" else 1)
        elif kind is ctypes.c_double:
            arguments.append(value)
        elif kind in (ctypes.c_int32, ctypes.c_uint64):
            arguments.append(0)
        elif kind is _header._model:
            arguments.append(model_of(PAPER))
        elif kind is _header._params:
            arguments.append(PAPER._as_struct())
        elif kind is ctypes.POINTER(ctypes.c_char_p):
            arguments.append((ctypes.c_char_p * 1)(b"hardness"))
        elif kind is ctypes.POINTER(_header._model):
            arguments.append((_header._model * 1)(model_of(PAPER)))
        elif kind is _header._double:
            arguments.append((ctypes.c_double * 64)(*[value] * 64))
        else:
            pointed = kind._type_
            fields = {"struct_size": ctypes.sizeof(pointed)} if hasattr(pointed, "_fields_") else {}
            arguments.append((pointed * 64)() if not fields else pointed(**fields))
    return arguments


PAPER = Params.paper().replace(calibration_error=0.05)
_KEPT: list[Model] = []


def model_of(params: Params) -> Any:
    if not _KEPT:
        _KEPT.append(Model(params))
    return _KEPT[0]._open().pointer


CALLED = sorted(set(_header.PROTOTYPES) - {"asperity_free"})
STATUSES = [name for name in CALLED if _header.PROTOTYPES[name][0] is ctypes.c_int32]


@pytest.mark.parametrize("name", CALLED)
def test_a_function_works(name: str) -> None:
    assert _library.LIBRARY.asperity_params_init(None, 0) == Status.NULL_POINTER  # for a message
    found = getattr(_library.LIBRARY, name)(*made(name, 0.5))
    if name in STATUSES:
        assert found == ELSE.get(name, Status.OK), _library.last_error()
    else:
        assert found and not (isinstance(found, float) and math.isnan(found))


@pytest.mark.parametrize("name", CALLED)
def test_a_function_refuses_null(name: str) -> None:
    kinds = _header.PROTOTYPES[name][1]
    pointers = [kind for kind in kinds if hasattr(kind, "_type_") and not isinstance(kind._type_, str) or kind is ctypes.c_char_p]
    arguments = [None if kind in pointers else one for kind, one in zip(kinds, made(name, 0.5))]
    found = getattr(_library.LIBRARY, name)(*arguments)
    if pointers and name in STATUSES:
        assert found == Status.NULL_POINTER
    elif pointers and name not in WITHOUT_POINTERS:
        assert not found or math.isnan(found)


@pytest.mark.parametrize("name", CALLED)
def test_a_function_answers_nan(name: str) -> None:
    kinds, arguments = _header.PROTOTYPES[name][1], made(name, math.nan)
    found = getattr(_library.LIBRARY, name)(*arguments)
    if ctypes.c_double in kinds and name in STATUSES:
        assert found in (Status.INVALID_PARAMETER, Status.INVALID_LOAD)
    elif ctypes.c_double in kinds:
        assert math.isnan(found)


def test_parameters_reach_the_library_unchanged() -> None:
    params = Params.si(
        composite_modulus=1.1e11, effective_shear_modulus=6.5e10, work_of_adhesion=0.06, adhesion_range=4e-10,
        burgers_vector=3e-10, height_std=5e-9, summit_radius=1e-6, asperity_count=1.5e5, attraction=False,
        height_distribution="weibull", weibull_shape=2.5, radius_amplitude=-0.3, radius_rate=0.7, slip_radius_1=30.0,
        slip_stress_1=0.02, slip_radius_2=7e4, slip_stress_2=8e-4, max_friction_coefficient=12.0, hardness=9e9, nominal_area=2e-8,
            tangential_modulus=3e10,
    )  # fmt: skip
    with Model(params) as model:
        back = parameters_of(model)
    found = {field[0]: getattr(back, field[0]) for field in back._fields_[1:]}
    assert not found.pop("table_height") and not found.pop("table_density") and found.pop("table_length") == 0
    words = {"height_distribution": _header.ASPERITY_HEIGHTS_WEIBULL, "attraction": 0, "contact_law": 0, "slip_onset": 0, "waviness_shape": 0, "taken_as_gaussian": 0}
    expected = vars(params) | words
    del expected["table_height"], expected["table_density"], expected["in_si"]
    assert found == expected


def parameters_of(model: Model) -> Any:
    back = _header.asperity_params(struct_size=ctypes.sizeof(_header.asperity_params))
    errors.check(_library.LIBRARY.asperity_get_params(model._open().pointer, back))
    return back
