//! What the library says of itself: its versions, and its statuses in words.

use super::status::*;
use super::version::ASPERITY_ABI_VERSION;
use std::ffi::{c_char, CStr};

/// The statuses: their names, and what each means in a few words.
pub(super) static STATUSES: [(&CStr, asperity_status, &CStr); 8] = [
    (c"OK", ASPERITY_OK, c"success"),
    (c"NULL_POINTER", ASPERITY_NULL_POINTER, c"a pointer is NULL"),
    (c"INVALID_PARAMETER", ASPERITY_INVALID_PARAMETER, c"invalid parameter"),
    (c"INVALID_LOAD", ASPERITY_INVALID_LOAD, c"load is NaN or infinite"),
    (c"SEPARATED", ASPERITY_SEPARATED, c"load below pull-off: the surfaces are apart"),
    (c"OUT_OF_RANGE", ASPERITY_OUT_OF_RANGE, c"outside the range the model can be evaluated for"),
    (c"NOT_CONVERGED", ASPERITY_NOT_CONVERGED, c"an iteration did not converge"),
    (c"INTERNAL", ASPERITY_INTERNAL, c"internal error: a bug in asperity"),
];

/// Returns a status in a few words; `asperity_last_error` says more of the last failure.
///
/// @param status  one of the constants `ASPERITY_OK` to `ASPERITY_INTERNAL`
/// @return a constant string, never NULL; "unknown status" for any other number
#[no_mangle]
pub extern "C" fn asperity_status_string(status: asperity_status) -> *const c_char {
    let found = STATUSES.iter().find(|(_, other, _)| *other == status);
    found.map_or(c"unknown status", |(.., says)| says).as_ptr()
}

/// Returns the version of the binary interface of the library loaded: callers compiled with another `ASPERITY_ABI_VERSION` do not fit.
#[no_mangle]
pub extern "C" fn asperity_abi_version() -> u32 {
    ASPERITY_ABI_VERSION
}

/// Returns the version of the library loaded, "major.minor.patch".
///
/// @return a constant string, never NULL
#[no_mangle]
pub extern "C" fn asperity_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}
