//! Load against separation: the compiled law of a host that knows the gap of a contact.

use super::batch::{self, Arrays, FirstInvalid, Quantity};
use super::boundary::{self, not_null, write};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use crate::model::{by_separation, Model};

/// So many separations are turned into arguments of the table at a time.
const BLOCK: usize = 128;

/// Load at a separation of the mean planes, from the compiled law.
///
/// The separation is that of `asperity_state_at_separation`, on the branch of load control: from deep compression to
/// pull-off, where the surfaces part. Without adhesion it goes to 0 at the highest asperity; if heights have no end, it is taken
/// to 0 smoothly below about 1e-24 of the load at which half of the asperities touch. A pull-off load weaker than 1e-30 of that
/// counts as none. Values are within 1e-9 of exact ones, slopes within 1e-7, relative to the load or to the pull-off load,
/// whichever is larger, or within what the rounding of the separation changes them by. In compression beyond that of 1e6 times
/// the load at which half of the asperities touch, the load goes on as a power of the compression.
///
/// @param model       a model
/// @param separation  of the mean planes of asperity heights and flat [length]; negative in deep compression
/// @return the load [force], negative where adhesion pulls; 0 at pull-off and beyond; a quiet NaN for a separation
///         that is NaN, infinite or below -1e50 `height_std`, or a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_load_at_separation(model: *const asperity_model, separation: f64) -> f64 {
    model::value_at(model, Quantity::Load, -separation)
}

/// Load at a separation, with its slope.
///
/// @param model              a model
/// @param separation         as for `asperity_load_at_separation`
/// @param dload_dseparation  receives d(load)/d(separation) [force/length], <= 0: minus the normal stiffness; 0 at
///                           pull-off and beyond; NaN where the load is
/// @return as `asperity_load_at_separation`
#[no_mangle]
pub unsafe extern "C" fn asperity_load_and_slope_at_separation(
    model: *const asperity_model,
    separation: f64,
    dload_dseparation: *mut f64,
) -> f64 {
    boundary::fast!(contained_value, {
        let at = |handle: &asperity_model| Quantity::Load.at(&handle.model, -separation);
        let (load, slope) = model.as_ref().map_or((f64::NAN, f64::NAN), at);
        write(dload_dseparation, 0, by_separation(slope));
        load
    })
}

/// Loads at many separations, and their slopes.
///
/// @param model             a model
/// @param n                 number of separations
/// @param separation        n separations [length]
/// @param load              receives n loads [force]
/// @param dload_dseparation receives n slopes d(load)/d(separation) [force/length], <= 0: minus the normal stiffness;
///                          0 at pull-off and beyond
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (a separation that is NaN or
///         infinite), `ASPERITY_SEPARATED` (the surfaces are apart, and the load is 0), `ASPERITY_OUT_OF_RANGE` (one
///         below -1e50 `height_std`)
#[no_mangle]
pub unsafe extern "C" fn asperity_loads_at_separations(
    model: *const asperity_model,
    n: usize,
    separation: *const f64,
    load: *mut f64,
    dload_dseparation: *mut f64,
) -> asperity_status {
    boundary::fast!(contained_status, {
        let model = model::of(model)?;
        if n > 0 {
            not_null(separation, "separation")?;
        }
        let mut first_invalid = None;
        for begin in (0..n).step_by(BLOCK) {
            let count = BLOCK.min(n - begin);
            let found = block(model, separation, load, dload_dseparation, begin, count);
            first_invalid = first_invalid.or(found.map(|(index, argument)| (begin + index, argument)));
        }
        first_invalid.map_or(Ok(()), |(index, argument)| Err(Quantity::Load.failure(model, index, argument)))
    })
}

/// The elements of a block: its input is read before an output that may be the same array is written.
unsafe fn block(
    model: &Model,
    separation: *const f64,
    load: *mut f64,
    slope: *mut f64,
    begin: usize,
    count: usize,
) -> FirstInvalid {
    let mut argument = [0.0; BLOCK];
    for (i, argument) in argument[..count].iter_mut().enumerate() {
        *argument = -separation.add(begin + i).read_unaligned();
    }
    let mut slopes = [0.0; BLOCK];
    let arrays = Arrays {
        n: count,
        load: argument.as_ptr(),
        value: if load.is_null() { load } else { load.add(begin) },
        slope: if slope.is_null() { slope } else { slopes.as_mut_ptr() },
    };
    let first_invalid = batch::fill(model, Quantity::Load, arrays);
    for (i, slope_by_argument) in slopes[..count].iter().enumerate() {
        write(slope, begin + i, by_separation(*slope_by_argument));
    }
    first_invalid
}
