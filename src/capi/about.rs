//! What the library says of itself: its versions, and its statuses in words.

use super::status::*;
use super::version::ASPERITY_ABI_VERSION;
use std::ffi::c_char;

/// Returns a status in a few words; `asperity_last_error` says more of the last failure.
///
/// @param status  one of the constants `ASPERITY_OK` to `ASPERITY_INTERNAL`
/// @return a constant string, never NULL; "unknown status" for any other number
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
        ASPERITY_INTERNAL => c"internal error: a bug in asperity",
        _ => c"unknown status",
    }
    .as_ptr()
}

/// Returns the version of the binary interface of the library loaded; compare it with `ASPERITY_ABI_VERSION`.
///
/// It changes only when compiled callers must be compiled again.
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
