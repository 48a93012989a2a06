//! Status codes.

use crate::error::Error;

/// What a call returns: 0, or why it failed. A plain integer, never an enum type.
pub type asperity_status = i32;

/// Success.
pub const ASPERITY_OK: i32 = 0;
/// A pointer is NULL that must not be.
pub const ASPERITY_NULL_POINTER: i32 = 1;
/// A parameter has no meaning; the message says which, its value and what is allowed.
pub const ASPERITY_INVALID_PARAMETER: i32 = 2;
/// A load is NaN or infinite.
pub const ASPERITY_INVALID_LOAD: i32 = 3;
/// A load lies below the pull-off load: the surfaces are apart. Batch calls return it after they filled every element.
pub const ASPERITY_SEPARATED: i32 = 4;
/// A quantity is finite, but outside the domain of the library; the message says the bound and what to use instead.
pub const ASPERITY_OUT_OF_RANGE: i32 = 5;
/// An iteration did not converge: please report the parameters.
pub const ASPERITY_NOT_CONVERGED: i32 = 6;
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
            | Error::Missing { .. }
            | Error::Meaningless(_)
            | Error::Uncalibrated { .. } => ASPERITY_INVALID_PARAMETER,
            Error::InText { error, .. } => error.status(),
            Error::InvalidLoad { .. } => ASPERITY_INVALID_LOAD,
            Error::Separated { .. } | Error::Open { .. } => ASPERITY_SEPARATED,
            Error::OutOfRange { .. } => ASPERITY_OUT_OF_RANGE,
            Error::NotConverged { .. } => ASPERITY_NOT_CONVERGED,
        }
    }
}
