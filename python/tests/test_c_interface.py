"""Every function of the header, called through the ctypes layer as a C program would."""

from __future__ import annotations

import ctypes
import math
import struct
from typing import Any

import numpy as np

from asperity import Model, Params, Status, _header, _library, errors


class Recorder:
    """The library, and which of its functions were asked for."""

    def __init__(self) -> None:
        self.called: set[str] = set()

    def __getattr__(self, name: str) -> Any:
        self.called.add(f"asperity_{name}")
        return getattr(_library.LIBRARY, f"asperity_{name}")


def doubles(*numbers: float) -> Any:
    return (ctypes.c_double * len(numbers))(*numbers)


def table_force(table: Any, load: float) -> float:
    """F by the rows of a table, as the header describes them."""
    (bits,) = struct.unpack("<Q", struct.pack("<d", load - table.pull_off_load))
    index = (bits >> table.shift) - table.base
    assert 0 <= index < table.row_count
    below = bits & ((1 << table.shift) - 1)
    (t,) = struct.unpack("<d", struct.pack("<Q", below | 0x3FF0000000000000))
    row: list[float] = table.rows[8 * index : 8 * index + 8]
    return float(sum(c * (t - 1.0) ** k for k, c in enumerate(row)))


def test_every_function_of_the_header_works() -> None:
    lib = Recorder()
    params, back = _header.asperity_params(), _header.asperity_params()
    model = ctypes.POINTER(_header.asperity_model)()

    assert lib.abi_version() == _header.ASPERITY_ABI_VERSION
    assert lib.version().decode() == _header.ASPERITY_VERSION
    assert lib.status_string(Status.SEPARATED) != lib.status_string(Status.OK) != b""

    assert lib.params_init(params, ctypes.sizeof(params) + 8) == Status.INVALID_PARAMETER
    assert lib.params_init(params, ctypes.sizeof(params)) == Status.OK
    assert params.struct_size == ctypes.sizeof(params) and math.isnan(params.asperity_count) and params.kurtosis == 3.0
    assert lib.params_set_dimensionless(params, 0.02, 500.0, 0.002, 2.0, 0.25) == Status.OK
    assert (params.height_std, params.summit_radius) == (10.0, 25000.0)
    assert lib.params_set_materials(params, 3.0, 0.5, math.inf, 0.0) == Status.OK
    assert math.isclose(params.composite_modulus, 4.0, rel_tol=1e-15)
    summits = _header.asperity_params.from_buffer_copy(params)
    assert lib.params_set_spectral_moments(summits, 3.0, 0.5, 0.0, 11.0) == Status.OK
    assert summits.rms_slope == 1.0 and summits.radius_amplitude < 0
    assert lib.params_set_mccool_summits(params, 3.0, 0.5, 0.7, 11.0) == Status.OK
    assert math.isclose(params.summit_radius, 0.375 * math.sqrt(math.pi / 0.7), rel_tol=1e-14)
    params.nominal_area = 0.0  # most of it would touch below
    assert lib.params_set_skew(params, 0.0) == Status.OK
    assert params.height_distribution == _header.ASPERITY_HEIGHTS_WEIBULL
    assert abs(params.weibull_shape - 3.602) < 5e-4  # Table 1 of the paper

    assert lib.params_name(0) == b"composite_modulus"
    assert lib.params_set_value(params, b"hardness", 3.0) == Status.OK
    name = ctypes.cast(ctypes.create_string_buffer(b"hardness"), ctypes.POINTER(ctypes.c_char))
    names = (ctypes.POINTER(ctypes.c_char) * 1)(name)
    assert lib.params_set_values(params, 1, names, (ctypes.c_double * 1)(0.0)) == Status.OK
    found = ctypes.c_double(-1.0)
    assert lib.params_get_value(params, b"hardness", found) == Status.OK and found.value == 0.0

    # As a text, and in other units.
    length = lib.params_text(params, None, 0)
    written = ctypes.create_string_buffer(length + 1)
    assert lib.params_text(params, written, length + 1) == length == len(written.value)
    assert lib.params_init(back, ctypes.sizeof(back)) == Status.OK
    assert lib.params_set_text(back, written, length) == Status.OK and bytes(back) == bytes(params)
    surface = b"pair = 'Si/Si'\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n"
    estimates = (_header.asperity_estimate * 2)()
    estimates[0].struct_size = ctypes.sizeof(_header.asperity_estimate)
    loads = (ctypes.c_double * 2)(1e-3, 1e-2)
    assert lib.estimate_at_loads(surface, len(surface), 2, loads, estimates) == Status.OK and estimates[1].load == 1e-2
    assert estimates[0].low < estimates[0].friction_coefficient < estimates[0].high and estimates[1].strength_source == 0
    length = lib.estimate_text(surface, len(surface), 2, loads, None, 0)
    told = ctypes.create_string_buffer(length + 1)
    assert lib.estimate_text(surface, len(surface), 2, loads, told, length + 1) == length and told.value.startswith(b"mu(0.001 N)")
    taken = _header.asperity_params.from_buffer_copy(back)
    assert lib.params_set_estimate(taken, surface, len(surface)) == Status.OK and taken.asperity_count == 1e5
    assert lib.params_set_units(back, 1e-3, 1.0) == Status.OK and math.isclose(back.height_std, 1e3 * params.height_std)
    assert lib.params_read(back, b"nowhere.toml") == Status.INVALID_PARAMETER

    assert lib.params_set_skew(params, -2.0) == Status.INVALID_PARAMETER
    text = ctypes.create_string_buffer(200)
    assert lib.last_error(text, 200) == len(text.value)
    assert text.value.startswith(b"skew = -2:")

    assert lib.create(params, model) == Status.OK
    back.struct_size = ctypes.sizeof(back)
    assert lib.get_params(model, back) == Status.OK
    assert bytes(back) == bytes(params)
    params.asperity_count = 7.0
    assert lib.set_params(model, params) == Status.OK
    assert lib.get_params(model, back) == Status.OK
    assert back.asperity_count == 7.0

    mu, force, slope = doubles(0.0), doubles(0.0), doubles(0.0)
    assert lib.friction_at_loads(model, 1, doubles(50.0), mu, None) == Status.OK
    assert lib.friction_force_at_loads(model, 1, doubles(50.0), force, slope) == Status.OK
    assert lib.friction_at_load(model, 50.0) == mu[0]
    assert lib.friction_force_at_load(model, 50.0) == force[0]
    assert math.isclose(force[0], 50.0 * mu[0], rel_tol=1e-15)

    # Value and slope together, by pressure on an area of 5, and with a smooth sign of the slip rate.
    one, other = doubles(0.0), doubles(0.0)
    assert lib.friction_force_and_slope_at_load(model, 50.0, one) == force[0] and one[0] == slope[0]
    assert lib.friction_and_slope_at_load(model, 50.0, one) == mu[0]
    assert math.isclose(lib.friction_at_pressure(model, 10.0, 5.0, other), mu[0], rel_tol=1e-14)
    assert math.isclose(other[0], 5.0 * one[0], rel_tol=1e-12)
    assert math.isclose(lib.shear_stress_at_pressure(model, 10.0, 5.0, other), force[0] / 5.0, rel_tol=1e-14)
    assert math.isclose(other[0], slope[0], rel_tol=1e-12)
    assert math.isclose(lib.slip_force(model, 50.0, -0.3, 0.2, one, other), force[0] * math.tanh(-1.5), rel_tol=1e-14)
    assert math.isclose(one[0], slope[0] * math.tanh(-1.5), rel_tol=1e-14)
    assert math.isclose(other[0], force[0] / (0.2 * math.cosh(1.5) ** 2), rel_tol=1e-13)

    # The same for many, and for contacts of several models.
    assert lib.friction_at_pressures(model, 1, doubles(10.0), 5.0, one, None) == Status.OK
    assert one[0] == lib.friction_at_pressure(model, 10.0, 5.0, None)
    assert lib.shear_stresses_at_pressures(model, 1, doubles(10.0), 5.0, one, None) == Status.OK
    assert one[0] == lib.shear_stress_at_pressure(model, 10.0, 5.0, None)
    assert lib.slip_forces(model, 1, doubles(50.0), doubles(-0.3), 0.2, one, None, None) == Status.OK
    assert one[0] == lib.slip_force(model, 50.0, -0.3, 0.2, None, None)
    models, which = (ctypes.POINTER(_header.asperity_model) * 1)(model), (ctypes.c_uint32 * 1)(0)
    assert lib.friction_force_at_loads_of(models, 1, 1, which, doubles(50.0), one, None) == Status.OK and one[0] == force[0]

    # Before it slips.
    stiffness = lib.tangential_stiffness_at_load(model, 50.0)
    assert lib.tangential_stiffness_at_loads(model, 1, doubles(50.0), one) == Status.OK and one[0] == stiffness
    radii = lib.contact_radius_sum_at_load(model, 50.0)
    assert lib.contact_radius_sum_at_loads(model, 1, doubles(50.0), one, other) == Status.OK and one[0] == radii and other[0] > 0
    assert lib.tangential_at_load(model, 50.0, 1e-9 * force[0] / stiffness, one, other) == Status.OK
    assert math.isclose(one[0], 1e-9 * force[0], rel_tol=1e-6) and math.isclose(other[0], stiffness, rel_tol=1e-6)

    # A contact that remembers.
    slipped = _header.asperity_microslip(struct_size=ctypes.sizeof(_header.asperity_microslip))
    memory, by = (ctypes.c_double * lib.microslip_length(model))(), doubles(1e9, 0.0)
    assert lib.microslip_step(model, 50.0, by, memory, memory, slipped) == Status.OK and slipped.slipping == 1.0
    assert math.isclose(slipped.force[0], force[0], rel_tol=1e-12)
    assert lib.microslip_steps(model, 1, doubles(50.0), by, memory, None, both := doubles(0.0, 0.0), None) == Status.OK
    assert math.isclose(both[0], slipped.force[0], rel_tol=1e-14) and both[1] == 0.0
    assert lib.microslip_turn(memory, 0.0, 1.0) == Status.OK

    state = _header.asperity_state(struct_size=ctypes.sizeof(_header.asperity_state))
    assert lib.state_at_load(model, 50.0, state) == Status.OK
    assert math.isclose(state.friction_force, force[0], rel_tol=1e-9)
    assert math.isclose(state.dforce_dload, slope[0], rel_tol=1e-6)
    gap = state.gap
    assert lib.state_at_gap(model, gap, state) == Status.OK
    assert math.isclose(state.load, 50.0, rel_tol=1e-9)
    assert math.isclose(lib.load_at_gap(model, gap), 50.0, rel_tol=1e-9)
    assert lib.load_and_slope_at_gap(model, gap, one) == lib.load_at_gap(model, gap)
    assert math.isclose(one[0], state.dload_dgap, rel_tol=1e-7)
    assert lib.loads_at_gaps(model, 1, doubles(gap), other, None) == Status.OK
    assert other[0] == lib.load_at_gap(model, gap)

    # What friction depends on, and whether the law holds at these loads.
    by = _header.asperity_sensitivities(struct_size=ctypes.sizeof(_header.asperity_sensitivities))
    assert lib.sensitivities_at_load(model, 50.0, by) == Status.OK and by.effective_shear_modulus == 1.0
    bits = ctypes.c_uint64()
    assert lib.check_loads(model, 1.0, 50.0, ctypes.byref(bits)) == Status.OK
    assert lib.warning_string(0) == b"no warning"
    assert lib.warnings_text(0, None, 0) == len(b"no warning")
    assert lib.warning_loads(model, _header.ASPERITY_WARNING_FEW, light := doubles(1.0), heavy := doubles(1.0)) == Status.OK
    assert light[0] <= heavy[0]

    # Two summits at overlaps, pressed and far apart.
    assert lib.summits_at_overlaps(model, 2, doubles(5.0, -1e6), None, load := doubles(0.0, 1.0), None, None) == Status.OK
    assert load[0] > 0 and load[1] == 0

    summary = _header.asperity_summary(struct_size=ctypes.sizeof(_header.asperity_summary))
    assert lib.summary_of(model, summary) == Status.OK
    assert abs(summary.skew) < 1e-9

    # Materials, and all that a pair tells.
    material = _header.asperity_material_data(struct_size=ctypes.sizeof(_header.asperity_material_data))
    assert lib.material(lib.material_name(3), material) == Status.OK and material.name == b"steel" and material.young == 205e9
    pair = _header.asperity_pair_data(struct_size=ctypes.sizeof(_header.asperity_pair_data))
    assert lib.pair(b"Au/mica", pair) == Status.OK and pair.name == b"mica/Au" and lib.pair_name(10**6) is None
    assert lib.params_calibrate(params, 50.0, -1.0) == Status.INVALID_PARAMETER
    assert lib.params_calibrate_force(params, 50.0, 5.0) == Status.OK and params.calibration_friction_force == 5.0
    assert lib.params_set_elastic_plastic(params, 0.1) == Status.OK and params.work_of_adhesion == 0.0
    assert lib.params_set_pair(params, b"mica/Au") == Status.OK and params.slip_stress_1 == pair.slip_stress_1
    film = _header.asperity_interface_data(struct_size=ctypes.sizeof(_header.asperity_interface_data))
    assert lib.interface(lib.interface_name(0), film) == Status.OK and film.shear_strength == 24.8e6 and film.source == b"read"
    assert lib.params_set_interface(params, film.name) == Status.OK and params.pressure_coefficient == 0.001

    table = _header.asperity_table(struct_size=ctypes.sizeof(_header.asperity_table))
    assert lib.table_of(model, table) == Status.OK
    assert table.layout_version == _header.ASPERITY_TABLE_LAYOUT
    assert table.pull_off_load == summary.pull_off_load
    assert math.isclose(table_force(table, 50.0), force[0], rel_tol=1e-14)
    assert lib.load_table_of(model, table) == Status.OK
    # A row of NaN is a link.
    by_row = [(table_force(table, -at), lib.load_at_gap(model, at)) for at in (gap - 2.0, gap - 1.0, gap, gap + 1.0)]
    assert any(math.isclose(found, load, rel_tol=1e-14) for found, load in by_row), by_row
    lib.free(model)
    lib.free(None)

    assert lib.called == set(_header.PROTOTYPES)


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
    expected = dict(vars(params), height_distribution=_header.ASPERITY_HEIGHTS_WEIBULL, attraction=0, contact_law=0, slip_onset=0)
    del expected["table_height"], expected["table_density"], expected["in_si"]
    assert found == expected


def parameters_of(model: Model) -> Any:
    back = _header.asperity_params(struct_size=ctypes.sizeof(_header.asperity_params))
    errors.check(_library.LIBRARY.asperity_get_params(model._open().pointer, back))
    return back


def test_the_message_reads_whole() -> None:
    _library.LIBRARY.asperity_params_set_skew(Params.dimensionless(alpha=1, beta=1, gamma=0)._as_struct(), np.nan)
    assert _library.last_error() == "skew = NaN: must be finite and > -1.13955, the limit of the Weibull family; Johnson heights have any skew from -3 to 3"
