"""What `include/asperity.h` declares, for ctypes: its constants, structs and prototypes, in the header's order.

Nothing is loaded here; a test compares every line with the header and with what a C compiler makes of it.
"""

from __future__ import annotations

from ctypes import POINTER, Structure, c_char, c_char_p, c_double, c_int32, c_size_t, c_uint32, c_uint64
from typing import Any

ASPERITY_VERSION = "0.1.0"
ASPERITY_VERSION_MAJOR = 0
ASPERITY_VERSION_MINOR = 1
ASPERITY_VERSION_PATCH = 0
ASPERITY_ABI_VERSION = 1

ASPERITY_OK = 0
ASPERITY_NULL_POINTER = 1
ASPERITY_INVALID_PARAMETER = 2
ASPERITY_INVALID_LOAD = 3
ASPERITY_SEPARATED = 4
ASPERITY_OUT_OF_RANGE = 5
ASPERITY_NOT_CONVERGED = 6
ASPERITY_OUT_OF_MEMORY = 7
ASPERITY_INTERNAL = 255

ASPERITY_HEIGHTS_GAUSSIAN = 0
ASPERITY_HEIGHTS_WEIBULL = 1
ASPERITY_HEIGHTS_JOHNSON = 2
ASPERITY_HEIGHTS_TABULATED = 3

ASPERITY_CONTACT_MAUGIS = 0
ASPERITY_CONTACT_ELASTIC_PLASTIC = 1

ASPERITY_SLIP_PARTIAL = 0
ASPERITY_SLIP_WHOLE = 1

ASPERITY_WARNING_PLASTIC = 1
ASPERITY_WARNING_CROWDED = 2
ASPERITY_WARNING_STEEP = 4
ASPERITY_WARNING_ATOMIC = 8
ASPERITY_WARNING_FEW = 16
ASPERITY_WARNING_ADHESIVE = 32
ASPERITY_WARNING_UNCALIBRATED = 64
ASPERITY_WARNING_BROAD = 128
ASPERITY_WARNING_STRONG = 256

ASPERITY_TABLE_LAYOUT = 1


class asperity_model(Structure):
    """Opaque."""


asperity_status = c_int32


class asperity_params(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("composite_modulus", c_double),
        ("effective_shear_modulus", c_double),
        ("work_of_adhesion", c_double),
        ("adhesion_range", c_double),
        ("burgers_vector", c_double),
        ("height_std", c_double),
        ("summit_radius", c_double),
        ("asperity_count", c_double),
        ("height_distribution", c_int32),
        ("attraction", c_int32),
        ("weibull_shape", c_double),
        ("radius_amplitude", c_double),
        ("radius_rate", c_double),
        ("slip_radius_1", c_double),
        ("slip_stress_1", c_double),
        ("slip_radius_2", c_double),
        ("slip_stress_2", c_double),
        ("max_friction_coefficient", c_double),
        ("skew", c_double),
        ("kurtosis", c_double),
        ("hardness", c_double),
        ("table_height", POINTER(c_double)),
        ("table_density", POINTER(c_double)),
        ("table_length", c_uint64),
        ("tangential_modulus", c_double),
        ("nominal_area", c_double),
        ("contact_law", c_int32),
        ("slip_onset", c_int32),
        ("pressure_coefficient", c_double),
        ("bandwidth", c_double),
        ("calibration_load", c_double),
        ("calibration_friction_force", c_double),
        ("calibration_error", c_double),
    ]


class asperity_state(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("load", c_double),
        ("separation", c_double),
        ("friction_force", c_double),
        ("friction_coefficient", c_double),
        ("dforce_dload", c_double),
        ("dmu_dload", c_double),
        ("dload_dseparation", c_double),
        ("real_area", c_double),
        ("contacting", c_double),
        ("attracted", c_double),
        ("attraction_load", c_double),
        ("mean_contact_radius", c_double),
        ("max_contact_radius", c_double),
        ("fraction_below_slip_radius_1", c_double),
        ("fraction_between_slip_radii", c_double),
        ("fraction_above_slip_radius_2", c_double),
        ("fraction_in_contact", c_double),
        ("mean_asperity_pressure", c_double),
        ("plasticity_index", c_double),
        ("warnings", c_uint64),
        ("tangential_stiffness", c_double),
        ("fraction_elastic", c_double),
        ("fraction_flowing", c_double),
        ("contact_radius_sum", c_double),
        ("hertz_load", c_double),
        ("friction_scatter", c_double),
        ("friction_bias", c_double),
    ]


class asperity_summary(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("alpha", c_double),
        ("beta", c_double),
        ("gamma", c_double),
        ("lambda", c_double),
        ("skew", c_double),
        ("kurtosis", c_double),
        ("pull_off_load", c_double),
        ("pull_off_friction_force", c_double),
        ("zero_load_friction_force", c_double),
        ("min_table_load", c_double),
        ("max_table_load", c_double),
        ("table_error", c_double),
    ]


class asperity_table(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("rows", POINTER(c_double)),
        ("row_count", c_uint64),
        ("base", c_uint64),
        ("shift", c_uint32),
        ("layout_version", c_uint32),
        ("pull_off_load", c_double),
        ("max_friction_coefficient", c_double),
        ("inverse_cap", c_double),
        ("total_count", c_uint64),
        ("pull_off_force", c_double),
        ("light_slope", c_double),
        ("zero_force", c_double),
        ("zero_slope", c_double),
        ("separated_slope", c_double),
        ("heavy_force", c_double),
    ]


class asperity_sensitivities(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("composite_modulus", c_double),
        ("effective_shear_modulus", c_double),
        ("work_of_adhesion", c_double),
        ("adhesion_range", c_double),
        ("burgers_vector", c_double),
        ("height_std", c_double),
        ("summit_radius", c_double),
        ("asperity_count", c_double),
        ("weibull_shape", c_double),
        ("radius_amplitude", c_double),
        ("radius_rate", c_double),
        ("slip_radius_1", c_double),
        ("slip_stress_1", c_double),
        ("slip_radius_2", c_double),
        ("slip_stress_2", c_double),
        ("skew", c_double),
        ("kurtosis", c_double),
        ("hardness", c_double),
        ("pressure_coefficient", c_double),
    ]


class asperity_microslip(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("force", c_double * 2),
        ("stiffness", c_double * 4),
        ("dforce_dload", c_double * 2),
        ("dissipated", c_double),
        ("slipping", c_double),
    ]


class asperity_material_data(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("young", c_double),
        ("young_low", c_double),
        ("young_high", c_double),
        ("poisson", c_double),
        ("hardness", c_double),
        ("hardness_low", c_double),
        ("hardness_high", c_double),
        ("burgers_vector", c_double),
        ("name", c_char_p),
        ("reference", c_char_p),
    ]


class asperity_pair_data(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("work_of_adhesion", c_double),
        ("work_of_adhesion_low", c_double),
        ("work_of_adhesion_high", c_double),
        ("hamaker", c_double),
        ("slip_stress_1", c_double),
        ("name", c_char_p),
        ("reference", c_char_p),
    ]


class asperity_interface_data(Structure):
    _fields_ = [
        ("struct_size", c_uint64),
        ("shear_strength", c_double),
        ("pressure_coefficient", c_double),
        ("friction_coefficient", c_double),
        ("load", c_double),
        ("name", c_char_p),
        ("conditions", c_char_p),
        ("source", c_char_p),
        ("reference", c_char_p),
    ]


_model = POINTER(asperity_model)
_params = POINTER(asperity_params)
_state = POINTER(asperity_state)
_summary = POINTER(asperity_summary)
_table = POINTER(asperity_table)
_sensitivities = POINTER(asperity_sensitivities)
_microslip = POINTER(asperity_microslip)
_material = POINTER(asperity_material_data)
_pair = POINTER(asperity_pair_data)
_interface = POINTER(asperity_interface_data)
_doubles = POINTER(c_double)

# name: (what it returns, what it takes)
PROTOTYPES: dict[str, tuple[Any, list[Any]]] = {
    "asperity_params_init": (asperity_status, [_params, c_size_t]),
    "asperity_params_set_dimensionless": (asperity_status, [_params, *5 * [c_double]]),
    "asperity_params_set_materials": (asperity_status, [_params, *4 * [c_double]]),
    "asperity_params_set_spectral_moments": (asperity_status, [_params, *4 * [c_double]]),
    "asperity_params_set_nayak_summits": (asperity_status, [_params, *4 * [c_double]]),
    "asperity_params_set_skew": (asperity_status, [_params, c_double]),
    "asperity_params_set_value": (asperity_status, [_params, c_char_p, c_double]),
    "asperity_params_set_values": (asperity_status, [_params, c_size_t, POINTER(POINTER(c_char)), _doubles]),
    "asperity_params_get_value": (asperity_status, [_params, c_char_p, _doubles]),
    "asperity_params_name": (c_char_p, [c_size_t]),
    "asperity_material": (asperity_status, [c_char_p, _material]),
    "asperity_material_name": (c_char_p, [c_size_t]),
    "asperity_pair": (asperity_status, [c_char_p, _pair]),
    "asperity_pair_name": (c_char_p, [c_size_t]),
    "asperity_params_set_pair": (asperity_status, [_params, c_char_p]),
    "asperity_interface": (asperity_status, [c_char_p, _interface]),
    "asperity_interface_name": (c_char_p, [c_size_t]),
    "asperity_params_set_interface": (asperity_status, [_params, c_char_p]),
    "asperity_params_calibrate": (asperity_status, [_params, c_double, c_double]),
    "asperity_params_calibrate_force": (asperity_status, [_params, c_double, c_double]),
    "asperity_params_set_elastic_plastic": (asperity_status, [_params, c_double]),
    "asperity_create": (asperity_status, [_params, POINTER(_model)]),
    "asperity_set_params": (asperity_status, [_model, _params]),
    "asperity_get_params": (asperity_status, [_model, _params]),
    "asperity_free": (None, [_model]),
    "asperity_friction_at_load": (c_double, [_model, c_double]),
    "asperity_friction_force_at_load": (c_double, [_model, c_double]),
    "asperity_friction_at_loads": (asperity_status, [_model, c_size_t, _doubles, _doubles, _doubles]),
    "asperity_friction_force_at_loads": (asperity_status, [_model, c_size_t, _doubles, _doubles, _doubles]),
    "asperity_friction_and_slope_at_load": (c_double, [_model, c_double, _doubles]),
    "asperity_friction_force_and_slope_at_load": (c_double, [_model, c_double, _doubles]),
    "asperity_friction_at_pressure": (c_double, [_model, c_double, c_double, _doubles]),
    "asperity_shear_stress_at_pressure": (c_double, [_model, c_double, c_double, _doubles]),
    "asperity_slip_force": (c_double, [_model, c_double, c_double, c_double, _doubles, _doubles]),
    "asperity_friction_at_pressures": (asperity_status, [_model, c_size_t, _doubles, c_double, _doubles, _doubles]),
    "asperity_shear_stresses_at_pressures": (asperity_status, [_model, c_size_t, _doubles, c_double, _doubles, _doubles]),
    "asperity_slip_forces": (asperity_status, [_model, c_size_t, _doubles, _doubles, c_double, _doubles, _doubles, _doubles]),
    "asperity_friction_force_at_loads_of": (
        asperity_status,
        [POINTER(_model), c_size_t, c_size_t, POINTER(c_uint32), _doubles, _doubles, _doubles],
    ),
    "asperity_tangential_stiffness_at_load": (c_double, [_model, c_double]),
    "asperity_tangential_stiffness_at_loads": (asperity_status, [_model, c_size_t, _doubles, _doubles]),
    "asperity_tangential_at_load": (asperity_status, [_model, c_double, c_double, _doubles, _doubles]),
    "asperity_microslip_length": (c_size_t, [_model]),
    "asperity_microslip_step": (asperity_status, [_model, c_double, _doubles, _doubles, _doubles, _microslip]),
    "asperity_microslip_steps": (asperity_status, [_model, c_size_t, *6 * [_doubles]]),
    "asperity_load_at_separation": (c_double, [_model, c_double]),
    "asperity_load_and_slope_at_separation": (c_double, [_model, c_double, _doubles]),
    "asperity_loads_at_separations": (asperity_status, [_model, c_size_t, _doubles, _doubles, _doubles]),
    "asperity_summits_at_overlaps": (asperity_status, [_model, c_size_t, *5 * [_doubles]]),
    "asperity_state_at_load": (asperity_status, [_model, c_double, _state]),
    "asperity_state_at_separation": (asperity_status, [_model, c_double, _state]),
    "asperity_summary_of": (asperity_status, [_model, _summary]),
    "asperity_sensitivities_at_load": (asperity_status, [_model, c_double, _sensitivities]),
    "asperity_check_loads": (asperity_status, [_model, c_double, c_double, POINTER(c_uint64)]),
    "asperity_warning_string": (c_char_p, [c_uint64]),
    "asperity_warning_loads": (asperity_status, [_model, c_uint64, _doubles, _doubles]),
    "asperity_warnings_text": (c_size_t, [c_uint64, POINTER(c_char), c_size_t]),
    "asperity_last_error": (c_size_t, [POINTER(c_char), c_size_t]),
    "asperity_status_string": (c_char_p, [asperity_status]),
    "asperity_abi_version": (c_uint32, []),
    "asperity_version": (c_char_p, []),
    "asperity_table_of": (asperity_status, [_model, _table]),
    "asperity_load_table_of": (asperity_status, [_model, _table]),
}
