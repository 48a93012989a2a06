//! Where the model holds, as C asks: warnings of a range of loads, and what they mean.

use super::boundary::{self, reference_mut};
use super::model::{self, asperity_model};
use super::reserve;
use super::status::asperity_status;
use crate::model::validity;
use std::ffi::c_char;

/// Bit of `warnings`: summits yield, but the contact law is elastic. Set if the mean asperity pressure is above 0.4 of the
/// hardness (yield sets in below the contact) or the plasticity index above 1 (contacts flow at any load). Never set if no
/// hardness is given, nor for `ASPERITY_CONTACT_ELASTIC_PLASTIC`, which models yielding.
pub const ASPERITY_WARNING_PLASTIC: u64 = 1;
/// Bit of `warnings`: summits do not act alone. Set if more than 10 % of them touch, or if the real area is more than 10 %
/// of `nominal_area`, where that is given.
pub const ASPERITY_WARNING_CROWDED: u64 = 2;
/// Bit of `warnings`: contacts are not small. Set if their radii are more than a tenth of those of their summits, on
/// average.
pub const ASPERITY_WARNING_STEEP: u64 = 4;
/// Bit of `warnings`: contacts have few atoms. Set if their mean radius is below `burgers_vector`.
pub const ASPERITY_WARNING_ATOMIC: u64 = 8;
/// Bit of `warnings`: the sums are no means over surfaces at this load. Set if fewer than 20 summits touch; never if
/// `asperity_count` is 1, whose loads are those of a mean summit.
pub const ASPERITY_WARNING_FEW: u64 = 16;
/// Bit of `warnings`: adhesion presses the surfaces together with more than the load. Set if the load is below the magnitude
/// of the pull-off load; never if `asperity_count` is 1, as for single summits.
pub const ASPERITY_WARNING_ADHESIVE: u64 = 32;

const _: () = {
    assert!(ASPERITY_WARNING_PLASTIC == validity::WARNING_PLASTIC);
    assert!(ASPERITY_WARNING_CROWDED == validity::WARNING_CROWDED);
    assert!(ASPERITY_WARNING_STEEP == validity::WARNING_STEEP);
    assert!(ASPERITY_WARNING_ATOMIC == validity::WARNING_ATOMIC);
    assert!(ASPERITY_WARNING_FEW == validity::WARNING_FEW);
    assert!(ASPERITY_WARNING_ADHESIVE == validity::WARNING_ADHESIVE);
};

/// The warnings of all states from one load to another: whether the law holds for a contact that meets these loads.
///
/// It looks at some hundred exact states, in milliseconds: for the start of a run, not for its inner loop.
///
/// @param model     must not be NULL
/// @param lightest  normal load [force], from the pull-off load upwards; without adhesion above 0, where nothing touches
/// @param heaviest  normal load [force], not below `lightest`
/// @param warnings  receives every bit `ASPERITY_WARNING_...` that is set in a state between; 0 if nothing is known to
///                  fail; must not be NULL; untouched on failure
/// @return `ASPERITY_OK`, also if there are warnings; `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`lightest` is
///         above `heaviest`), `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE`,
///         `ASPERITY_NOT_CONVERGED`, `ASPERITY_OUT_OF_MEMORY`
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_check_loads(
    model: *const asperity_model,
    lightest: f64,
    heaviest: f64,
    warnings: *mut u64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        let warnings = reference_mut(warnings, "warnings")?;
        *warnings = reserve::held(|| Ok(model.check_loads(lightest, heaviest)?))?;
        Ok(())
    })
}

/// Says of one warning what fails and what to do about it.
///
/// @param warning  one bit `ASPERITY_WARNING_...`
/// @return a constant string, never NULL; "no warning" for 0, "unknown warning" for a number that is not one known bit
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_warning_string(warning: u64) -> *const c_char {
    match warning {
        0 => c"no warning",
        ASPERITY_WARNING_PLASTIC => {
            c"summits yield: the mean asperity pressure is above 0.4 of the hardness, or the plasticity index above 1; use \
              the elastic-plastic contact law (contact_law 1, by name elastic-plastic) with work_of_adhesion 0, or lighter \
              loads if only the pressure is too high"
        }
        ASPERITY_WARNING_CROWDED => {
            c"summits do not act alone: more than 10 % of them touch, or more than 10 % of nominal_area; use \
              lighter loads, or check height_std and asperity_count: surfaces that are taken too smooth or too small are \
              the usual cause"
        }
        ASPERITY_WARNING_STEEP => {
            c"contacts are too large for their summits: a/R is above 0.1 on average; use lighter loads, or check \
              summit_radius: maps that are noisy or finer than the contacts give too small a radius"
        }
        ASPERITY_WARNING_ATOMIC => {
            c"contacts are too small for continuum mechanics: their mean radius is below burgers_vector; use heavier loads, \
              or summits of a map that is filtered at the size of the contacts"
        }
        ASPERITY_WARNING_FEW => {
            c"fewer than 20 summits touch: friction differs from one pair of surfaces to another, and its mean at this load \
              is higher than the law; use heavier loads or a larger area (asperity_count)"
        }
        ASPERITY_WARNING_ADHESIVE => {
            c"adhesion presses the surfaces together with more than the load, which is below the pull-off force: models of \
              single summits are quantitatively wrong there; use heavier loads, or check work_of_adhesion, height_std and \
              summit_radius: surfaces that are taken too smooth or too clean are the usual cause"
        }
        _ => c"unknown warning",
    }
    .as_ptr()
}
