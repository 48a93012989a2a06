//! Load against the gap between mean planes: the compiled law of a host that knows the gap of a contact.

use super::batch::{self, Arrays, Asked, FirstInvalid};
use super::boundary::{self, not_null, write};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::model::{by_gap, Model};

/// How many gaps are turned into arguments of the table at a time.
const GAP_BLOCK: usize = 128;

/// Returns the load at a gap, from the compiled law, and writes its slope.
///
/// The gap is the distance between the mean planes of the two surfaces, on the branch of load control: from deep compression to
/// pull-off, where the surfaces part. Without a `summit_mean_height` it counts from the mean of the asperity heights. Without adhesion
/// the load goes to 0 at the highest asperity, or smoothly below about 1e-15 of the load at which half of the asperities touch. Values
/// are within 1e-6 of exact ones, slopes within 1e-4, relative to the larger of the load and the pull-off load, or within what the
/// rounding of the gap changes them by.
///
/// @param gap         between the mean planes [length]; negative in deep compression
/// @param dload_dgap  receives d(load)/d(gap) [force/length], <= 0: minus the normal stiffness; 0 at pull-off and
///                    beyond; NaN where the load is
/// @return the load [force], negative where adhesion pulls; 0 at pull-off and beyond; a quiet NaN for a gap that is NaN,
///         infinite or below -1e50 `height_std`, or a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_load_and_slope_at_gap(
    model: *const asperity_model,
    gap: f64,
    dload_dgap: *mut f64,
) -> f64 {
    if dload_dgap.is_null() {
        return model::value_at(model, Asked::Load, -gap);
    }
    model::with_slope(model, Asked::Load, -gap, dload_dgap)
}

/// Loads at many gaps, and their slopes.
///
/// @param gap         n gaps [length]
/// @param load        receives n loads [force]
/// @param dload_dgap  receives n slopes d(load)/d(gap) [force/length], <= 0: minus the normal stiffness; 0 at pull-off and beyond
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (a gap that is NaN or infinite), `ASPERITY_SEPARATED`
///         (the surfaces are apart, and the load is 0), `ASPERITY_OUT_OF_RANGE` (one below -1e50 `height_std`)
#[no_mangle]
pub unsafe extern "C" fn asperity_loads_at_gaps(
    model: *const asperity_model,
    n: usize,
    gap: *const f64,
    load: *mut f64,
    dload_dgap: *mut f64,
) -> asperity_status {
    boundary::contained_status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(gap, "gap")?;
        }
        let mut first_invalid = None;
        for begin in (0..n).step_by(GAP_BLOCK) {
            let count = GAP_BLOCK.min(n - begin);
            let found = block(model, gap, load, dload_dgap, begin, count);
            first_invalid = first_invalid.or(found.map(|(index, argument)| (begin + index, argument)));
        }
        first_invalid.map_or(Ok(()), |(index, argument)| Err(Asked::Load.failure(model, index, argument)))
    })
}

/// The elements of a block: its input is read before an output that may be the same array is written.
unsafe fn block(
    model: &Model,
    gap: *const f64,
    load: *mut f64,
    slope: *mut f64,
    begin: usize,
    count: usize,
) -> FirstInvalid {
    let mut argument = [0.0; GAP_BLOCK];
    for (i, argument) in argument[..count].iter_mut().enumerate() {
        *argument = -gap.add(begin + i).read_unaligned();
    }
    let mut slopes = [0.0; GAP_BLOCK];
    let arrays = Arrays {
        n: count,
        load: argument.as_ptr(),
        value: if load.is_null() { load } else { load.add(begin) },
        slope: if slope.is_null() { slope } else { slopes.as_mut_ptr() },
    };
    let first_invalid = batch::fill(model, Asked::Load, arrays);
    for (i, slope_by_argument) in slopes[..count].iter().enumerate() {
        write(slope, begin + i, by_gap(*slope_by_argument));
    }
    first_invalid
}
