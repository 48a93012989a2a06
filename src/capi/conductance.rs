//! The sum of contact radii, of which thermal and electrical contact conductance is made.

use super::batch::{self, Arrays, Quantity};
use super::boundary::{self, not_null, write};
use super::fp_environment;
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::float_bits::moderate;

/// Contacts that are answered at a time.
const BLOCK: usize = 128;

/// Returns the sum of the radii of all contacts at a load, from which follows the thermal or electrical contact conductance.
///
/// The conductance is 2 k times the sum, with k = 2 k1 k2/(k1 + k2) of the conductivities of the two bodies. The sum is
/// K_t/(8 G^), of `asperity_tangential_stiffness_at_load`: over psi, where `nominal_area` is known.
///
/// @param model  a model
/// @param load   normal load [force]
/// @return the sum [length], positive also at zero and negative load down to pull-off; 0 below pull-off and, without
///         adhesion, at zero load; a quiet NaN for a NaN or infinite load, for one that cannot be evaluated (1e300), or a
///         NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_contact_radius_sum_at_load(model: *const asperity_model, load: f64) -> f64 {
    boundary::fast!(contained_value, {
        let stiffness = model::value_at(model, Quantity::Stiffness, load);
        let by_stiffness = model.as_ref().map_or(f64::NAN, |handle| handle.model.radius_sum_by_stiffness());
        if moderate(stiffness) {
            stiffness * by_stiffness
        } else {
            fp_environment::held(|| stiffness * by_stiffness)
        }
    })
}

/// Computes the sums of contact radii at many loads, and their slopes.
///
/// With the slope, Newton's method solves for temperatures and loads together. At 1 mN, of silicon with 148 W/(m K):
///
/// ```c
/// double load = 1e-3, sum, slope, k = 148;
/// if (asperity_contact_radius_sum_at_loads(model, 1, &load, &sum, &slope) == ASPERITY_OK) {
///     printf("conductance %g W/K, slope %g W/(K N)\n", 2 * k * sum, 2 * k * slope);
/// }
/// ```
///
/// @param model       a model
/// @param n           number of loads
/// @param load        n loads [force]
/// @param sum         receives n sums [length]
/// @param dsum_dload  receives n slopes d(sum)/d(load) [length/force]. They are within 1e-6 of the exact ones, relative, and
///                    within 1e-3 where load - pull-off is within 1 % of that of a kink: where an end of the heights or a
///                    height of their table begins to touch. At zero load, at the pull-off load and below it: as
///                    `dforce_dload` of `asperity_friction_force_at_loads`
/// @return as `asperity_friction_at_loads`
#[no_mangle]
pub unsafe extern "C" fn asperity_contact_radius_sum_at_loads(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    sum: *mut f64,
    dsum_dload: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(load, "load")?;
        }
        let by_stiffness = model.radius_sum_by_stiffness();
        let mut first_invalid = None;
        for begin in (0..n).step_by(BLOCK) {
            let count = BLOCK.min(n - begin);
            let (mut values, mut slopes) = ([0.0; BLOCK], [0.0; BLOCK]);
            let slope = if dsum_dload.is_null() { std::ptr::null_mut() } else { slopes.as_mut_ptr() };
            let arrays = Arrays { n: count, load: load.add(begin), value: values.as_mut_ptr(), slope };
            let found = batch::fill(model, Quantity::Stiffness, arrays);
            first_invalid = first_invalid.or(found.map(|(i, load)| (begin + i, load)));
            for i in 0..count {
                write(sum, begin + i, values[i] * by_stiffness);
                write(dsum_dload, begin + i, slopes[i] * by_stiffness);
            }
        }
        first_invalid.map_or(Ok(()), |(index, load)| Err(Quantity::Stiffness.failure(model, index, load)))
    })
}
