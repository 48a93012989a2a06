//! The calls of a solver's inner loop.

use super::batch::{self, Arrays, Quantity};
use super::boundary::{self, not_null};
use super::model::{self, asperity_model};
use super::status::asperity_status;

/// Friction coefficient F/P at a load.
///
/// @param model  a model
/// @param load   normal load [force]
/// @return F/load for load > 0, at most `max_friction_coefficient`; for pull-off <= load <= 0, where F is finite and
///         F/load is not, `max_friction_coefficient`; 0 below pull-off (a separated contact has no friction); a quiet
///         NaN for a NaN or infinite load, for one that cannot be evaluated (1e300), or a NULL model
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_load(model: *const asperity_model, load: f64) -> f64 {
    model::value_at(model, Quantity::Coefficient, load)
}

/// Friction force F at a load.
///
/// @param model  a model
/// @param load   normal load [force]
/// @return F [force], finite and positive also at zero and negative load down to pull-off; 0 below pull-off; a quiet
///         NaN for a NaN or infinite load, for one that cannot be evaluated (1e300), or a NULL model
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_load(model: *const asperity_model, load: f64) -> f64 {
    model::value_at(model, Quantity::Force, load)
}

/// Friction coefficients at many loads, and their slopes.
///
/// Every element has the bits that the call for one load gives. All elements are filled; then the first load that is not
/// in order, if any, is reported, and `asperity_last_error` names its index.
///
/// @param model      must not be NULL
/// @param n          number of loads; may be 0
/// @param load       n loads [force]; must not be NULL unless n = 0
/// @param mu         receives n coefficients; NULL to skip; may be `load` itself
/// @param dmu_dload  receives n slopes d(mu)/d(load) [1/force], 0 where mu is capped; NULL to skip; may be `load`
///                   itself
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`,
///         `ASPERITY_OUT_OF_RANGE` (a finite load that cannot be evaluated, where the answer is NaN)
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    mu: *mut f64,
    dmu_dload: *mut f64,
) -> asperity_status {
    evaluate(model, Quantity::Coefficient, n, load, mu, dmu_dload)
}

/// Friction forces at many loads, and their slopes, filled and reported as by `asperity_friction_at_loads`.
///
/// @param model         must not be NULL
/// @param n             number of loads; may be 0
/// @param load          n loads [force]; must not be NULL unless n = 0
/// @param force         receives n forces [force]; NULL to skip; may be `load` itself
/// @param dforce_dload  receives n slopes dF/d(load): INFINITY at the pull-off load itself, 0 below it; without
///                      adhesion, where F has no slope at zero load, there and below that of the lightest load of the
///                      table, finite; NULL to skip; may be `load` itself
/// @return as `asperity_friction_at_loads`
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
#[no_mangle]
pub unsafe extern "C" fn asperity_friction_force_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    force: *mut f64,
    dforce_dload: *mut f64,
) -> asperity_status {
    evaluate(model, Quantity::Force, n, load, force, dforce_dload)
}

pub(super) unsafe fn evaluate(
    model: *const asperity_model,
    quantity: Quantity,
    n: usize,
    load: *const f64,
    value: *mut f64,
    slope: *mut f64,
) -> asperity_status {
    boundary::fast!(contained_status, {
        let model = model::of(model)?;
        if n > 0 {
            not_null(load, "load")?;
        }
        batch::evaluate(model, quantity, Arrays { n, load, value, slope })
    })
}
