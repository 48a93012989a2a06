//! The law of single summits, as C sees it.

use super::boundary::{self, not_null, write, Failure};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::error::Error;
use crate::model::{Model, SummitState};

/// Computes load, friction force and contact radius of single summits, by the law that the model sums over all summits.
///
/// Use it for contacts of so few summits that each one counts. A summit stays in contact down to the overlap at which it
/// breaks away, which is negative with adhesion; below that it may attract without contact.
///
/// @param overlap  n overlaps [length]: how far the summit would reach beyond the flat, negative for a gap unless n = 0
/// @param height   n heights from the mean of the summit heights [length], on which radii of summits depend where
///                 `radius_amplitude` is not 0; NULL: all summits have the mean height
/// @param load     receives n loads [force], negative where a summit pulls
/// @param force    receives n friction forces [force], 0 out of contact
/// @param radius   receives n contact radii [length], 0 out of contact
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (an overlap or height that is not
///         finite), `ASPERITY_OUT_OF_RANGE` (one beyond 1e50 `height_std`); the three numbers of such a summit are
///         NaN
#[no_mangle]
pub unsafe extern "C" fn asperity_summits_at_overlaps(
    model: *const asperity_model,
    n: usize,
    overlap: *const f64,
    height: *const f64,
    load: *mut f64,
    force: *mut f64,
    radius: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(overlap, "overlap")?;
        }
        let mut first_invalid = None;
        for i in 0..n {
            let z = if height.is_null() { 0.0 } else { height.add(i).read_unaligned() };
            let summit = one(model, overlap.add(i).read_unaligned(), z, i, &mut first_invalid);
            write(load, i, summit.load);
            write(force, i, summit.friction_force);
            write(radius, i, summit.contact_radius);
        }
        first_invalid.map_or(Ok(()), |(index, error)| Err(Failure::of_element(index, &error)))
    })
}

/// A summit, or no numbers and what is wrong with the first such one.
fn one(model: &Model, overlap: f64, height: f64, i: usize, first_invalid: &mut Option<(usize, Error)>) -> SummitState {
    model.summit_at_overlap(overlap, height).unwrap_or_else(|error| {
        first_invalid.get_or_insert((i, error));
        SummitState { load: f64::NAN, friction_force: f64::NAN, contact_radius: f64::NAN }
    })
}
