//! Value and slope of one contact in one call.

use super::batch::Quantity;
use super::boundary::{self, write};
use super::model::asperity_model;

/// Returns the friction coefficient at a load, and writes its slope.
///
/// @param model      a model
/// @param load       normal load [force]
/// @param dmu_dload  receives d(mu)/d(load) [1/force]: 0 where mu is capped and below pull-off, NaN where mu is NaN
/// @return as `asperity_friction_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dmu_dload: *mut f64,
) -> f64 {
    boundary::contained_value(|| {
        let (mu, slope) = at(model, Quantity::Coefficient, load);
        write(dmu_dload, 0, slope);
        mu
    })
}

/// Returns the friction force at a load, and writes its slope: what an implicit solver needs in one call.
///
/// @param model         a model
/// @param load          normal load [force]
/// @param dforce_dload  receives dF/d(load) [-]. With adhesion: finite at zero load, INFINITY at the pull-off load
///                      itself, 0 below it. Without adhesion F has no slope at zero load: at zero load and below, the
///                      library writes the slope at the lightest load of the table, `min_table_load`. NaN where F is
///                      NaN
/// @return as `asperity_friction_force_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dforce_dload: *mut f64,
) -> f64 {
    boundary::contained_value(|| {
        let (force, slope) = at(model, Quantity::Force, load);
        write(dforce_dload, 0, slope);
        force
    })
}

unsafe fn at(model: *const asperity_model, quantity: Quantity, load: f64) -> (f64, f64) {
    model.as_ref().map_or((f64::NAN, f64::NAN), |handle| quantity.at(&handle.model, load))
}
