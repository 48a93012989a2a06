//! The calls of a solver's inner loop.

use super::batch::{self, Arrays, Asked};
use super::boundary::{self, not_null};
use super::model::{self, asperity_model};
use super::status::asperity_status;

/// Returns the friction coefficient F/P at a normal load.
///
/// @param load   normal load P [force], a total over `asperity_count`
/// @return the coefficient [-]: F/load for load > 0, at most `max_friction_coefficient`; `max_friction_coefficient`
///         for pull-off <= load <= 0, where F is finite and F/load is not; 0 below pull-off, where the surfaces are
///         apart; a quiet NaN for a NaN or infinite load, for one that cannot be evaluated (1e300), or a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_load(model: *const asperity_model, load: f64) -> f64 {
    model::value_at(model, Asked::Coefficient, load)
}

/// Returns the friction force F at a normal load.
///
/// Prefer it to the coefficient where loads reach zero: with adhesion the force is finite there, and the coefficient is not.
///
/// @param load   normal load [force], a total over `asperity_count`
/// @return F [force]. With adhesion it is positive also at zero load, and at negative load down to pull-off; without
///         adhesion it is 0 at zero load. 0 below pull-off; a quiet NaN for a NaN or infinite load, for one that
///         cannot be evaluated (1e300), or a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_load(model: *const asperity_model, load: f64) -> f64 {
    model::value_at(model, Asked::Force, load)
}

/// Computes the friction coefficients at many loads, and their slopes. An open contact is often no error of your solver: check
/// for `ASPERITY_SEPARATED` first.
///
/// @param load       n loads [force]
/// @param mu         receives n coefficients [-]
/// @param dmu_dload  receives n slopes d(mu)/d(load) [1/force], 0 where mu is capped
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_LOAD` (a NaN or infinite load: the answer is
///         NaN), `ASPERITY_SEPARATED` (a load below pull-off: the answer is 0), `ASPERITY_OUT_OF_RANGE` (a finite
///         load that cannot be evaluated: the answer is NaN)
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    mu: *mut f64,
    dmu_dload: *mut f64,
) -> asperity_status {
    evaluate(model, Asked::Coefficient, n, load, mu, dmu_dload)
}

/// Computes the friction forces at many loads, and their slopes.
///
/// @param load          n loads [force]
/// @param force         receives n forces [force]
/// @param dforce_dload  receives n slopes dF/d(load) [-]. With adhesion: finite at zero load, INFINITY at the
///                      pull-off load itself, 0 below it. Without adhesion F has no slope at zero load: there the
///                      library writes the slope at the lightest load of the table, `min_table_load`, and 0 below
/// @return as `asperity_friction_at_loads`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    force: *mut f64,
    dforce_dload: *mut f64,
) -> asperity_status {
    evaluate(model, Asked::Force, n, load, force, dforce_dload)
}

/// Returns the friction coefficient at a load, and writes its slope.
///
/// @param load       normal load [force]
/// @param dmu_dload  receives d(mu)/d(load) [1/force]: 0 where mu is capped and below pull-off, NaN where mu is NaN
/// @return as `asperity_friction_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dmu_dload: *mut f64,
) -> f64 {
    model::with_slope(model, Asked::Coefficient, load, dmu_dload)
}

/// Returns the friction force at a load, and writes its slope: what an implicit solver needs in one call.
///
/// @param load          normal load [force]
/// @param dforce_dload  receives dF/d(load) [-], as `asperity_friction_force_at_loads` has it; NaN where F is NaN
/// @return as `asperity_friction_force_at_load`
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_and_slope_at_load(
    model: *const asperity_model,
    load: f64,
    dforce_dload: *mut f64,
) -> f64 {
    model::with_slope(model, Asked::Force, load, dforce_dload)
}

pub(super) unsafe fn evaluate(
    model: *const asperity_model,
    quantity: Asked,
    n: usize,
    load: *const f64,
    value: *mut f64,
    slope: *mut f64,
) -> asperity_status {
    boundary::contained_status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(load, "load")?;
        }
        batch::evaluate(model, quantity, Arrays { n, load, value, slope })
    })
}
