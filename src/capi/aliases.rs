//! Second names of functions whose first name is not of the pattern that the header tells. Both are exported, for callers that look
//! functions up by name.

use super::interfaces::{asperity_interface, asperity_interface_data};
use super::materials::{asperity_material, asperity_material_data, asperity_pair, asperity_pair_data};
use super::model::asperity_model;
use super::slope::asperity_slip_force;
use super::state::{asperity_summary, asperity_summary_of};
use super::status::asperity_status;
use super::table::{asperity_table, asperity_table_of};
use super::tangential::asperity_tangential_at_load;
use std::ffi::c_char;

/// Fills the constants of a model: the same as `asperity_summary_of`.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_summary(
    model: *const asperity_model,
    summary: *mut asperity_summary,
) -> asperity_status {
    asperity_summary_of(model, summary)
}

/// Fills a view of the compiled law of a model: the same as `asperity_table_of`.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_table(
    model: *const asperity_model,
    table: *mut asperity_table,
) -> asperity_status {
    asperity_table_of(model, table)
}

/// Fills the data of a material: the same as `asperity_material`.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_material(
    name: *const c_char,
    material: *mut asperity_material_data,
) -> asperity_status {
    asperity_material(name, material)
}

/// Fills the data of a pair of materials: the same as `asperity_pair`.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_pair(name: *const c_char, pair: *mut asperity_pair_data) -> asperity_status {
    asperity_pair(name, pair)
}

/// Fills the data of an interface: the same as `asperity_interface`.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_interface(
    name: *const c_char,
    data: *mut asperity_interface_data,
) -> asperity_status {
    asperity_interface(name, data)
}

/// Returns the friction force at a load and a slip rate, with a smooth sign: the same as `asperity_slip_force`.
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_slip_rate(
    model: *const asperity_model,
    load: f64,
    slip_rate: f64,
    transition_rate: f64,
    dforce_dload: *mut f64,
    dforce_dslip_rate: *mut f64,
) -> f64 {
    asperity_slip_force(model, load, slip_rate, transition_rate, dforce_dload, dforce_dslip_rate)
}

/// Computes the tangential force at a load and a displacement, exactly: the same as `asperity_tangential_at_load`.
#[no_mangle]
pub unsafe extern "C" fn asperity_tangential_force_at_displacement(
    model: *const asperity_model,
    load: f64,
    displacement: f64,
    force: *mut f64,
    stiffness: *mut f64,
) -> asperity_status {
    asperity_tangential_at_load(model, load, displacement, force, stiffness)
}
