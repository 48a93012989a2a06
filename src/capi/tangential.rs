//! Contacts before they slip: tangential stiffness, and the exact force at constant load.

use super::batch::Asked;
use super::boundary::{self, write};
use super::evaluate::evaluate;
use super::model::{self, asperity_model};
use super::status::asperity_status;

/// Tangential stiffness K_t at a load: tangential force by displacement of the surfaces while all contacts stick.
///
/// K_t = 8 G^ times the sum of the contact radii (`stiffness_per_radius` of `asperity_summary_of`). The friction force over K_t is the
/// length before gross slip: what solvers call bristle deflection or elastic slip.
///
/// @param load   normal load [force]
/// @return K_t [force/length], positive also at zero and negative load down to pull-off; 0 below pull-off and, without adhesion, at
///         zero load; a quiet NaN for a NaN or infinite load, for one that cannot be evaluated (1e300), or a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_tangential_stiffness_at_load(model: *const asperity_model, load: f64) -> f64 {
    model::value_at(model, Asked::Stiffness, load)
}

/// Tangential stiffnesses at many loads.
///
/// @param load       n loads [force]
/// @param stiffness  receives n stiffnesses [force/length]
/// @return as `asperity_friction_at_loads`
#[no_mangle]
pub unsafe extern "C" fn asperity_tangential_stiffness_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    stiffness: *mut f64,
) -> asperity_status {
    evaluate(model, Asked::Stiffness, n, load, stiffness, std::ptr::null_mut())
}

/// The tangential force T at a load and a displacement, by integration over the asperities, without the table.
///
/// Each contact slips from its rim inwards, or as a whole (`slip_onset`), until its force is its strength: T rises from K_t
/// times the displacement to the friction force F, with small contacts slipping first. From a surface pair without
/// tangential force, at constant load. After a reversal at displacement r, where the force is T_r, Masing's rule gives
/// T = T_r - 2 T((r - displacement)/2). Any path under changing load: `asperity_microslip_step`.
///
/// @param load          normal load [force], from the pull-off load upwards
/// @param displacement  of the surfaces along each other [length]; T is an odd function of it
/// @param force         receives T [force]
/// @param stiffness     receives dT/d(displacement) [force/length]
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (a displacement that is not finite),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`
#[no_mangle]
pub unsafe extern "C" fn asperity_tangential_at_load(
    model: *const asperity_model,
    load: f64,
    displacement: f64,
    force: *mut f64,
    stiffness: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        let found = model.tangential_at_load(load, displacement)?;
        write(force, 0, found.0);
        write(stiffness, 0, found.1);
        Ok(())
    })
}
