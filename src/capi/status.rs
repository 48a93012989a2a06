//! Status codes.

use crate::error::Error;
use std::ffi::c_char;

/// What a call returns: 0, or why it failed. A plain integer, never an enum type.
pub type asperity_status = i32;

/// Success.
pub const ASPERITY_OK: i32 = 0;
/// A pointer is NULL that must not be.
pub const ASPERITY_NULL_POINTER: i32 = 1;
/// A parameter has no meaning; the message names it, its value and what is allowed.
pub const ASPERITY_INVALID_PARAMETER: i32 = 2;
/// A load is NaN or infinite.
pub const ASPERITY_INVALID_LOAD: i32 = 3;
/// A load lies below the pull-off load: nothing holds the surfaces together.
pub const ASPERITY_SEPARATED: i32 = 4;
/// A quantity is finite, but outside the domain of the library; the message tells the bound and what to use instead.
pub const ASPERITY_OUT_OF_RANGE: i32 = 5;
/// An iteration did not converge.
pub const ASPERITY_NOT_CONVERGED: i32 = 6;
/// The system refused memory that the call needs; nothing was made or changed.
pub const ASPERITY_OUT_OF_MEMORY: i32 = 7;
/// A bug in the library: please report it.
pub const ASPERITY_INTERNAL: i32 = 255;

impl Error {
    /// The status of an error.
    pub(super) fn status(&self) -> asperity_status {
        match self {
            Error::InvalidParameter { .. }
            | Error::Unset { .. }
            | Error::InvalidEntry { .. }
            | Error::NoStrength { .. }
            | Error::Uncalibrated { .. } => ASPERITY_INVALID_PARAMETER,
            Error::InvalidLoad { .. } => ASPERITY_INVALID_LOAD,
            Error::Separated { .. } | Error::Open { .. } => ASPERITY_SEPARATED,
            Error::OutOfRange { .. } => ASPERITY_OUT_OF_RANGE,
            Error::NotConverged { .. } => ASPERITY_NOT_CONVERGED,
        }
    }
}

/// Says what a status means, in a few words.
///
/// @return a constant string, never NULL; "unknown status" for a number that is none
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_status_string(status: asperity_status) -> *const c_char {
    match status {
        ASPERITY_OK => c"success",
        ASPERITY_NULL_POINTER => c"a pointer is NULL",
        ASPERITY_INVALID_PARAMETER => c"invalid parameter",
        ASPERITY_INVALID_LOAD => c"load is NaN or infinite",
        ASPERITY_SEPARATED => c"load below pull-off: the surfaces are apart",
        ASPERITY_OUT_OF_RANGE => c"outside the range the model can be evaluated for",
        ASPERITY_NOT_CONVERGED => c"an iteration did not converge",
        ASPERITY_OUT_OF_MEMORY => c"out of memory",
        ASPERITY_INTERNAL => c"internal error: a bug in asperity",
        _ => c"unknown status",
    }
    .as_ptr()
}
