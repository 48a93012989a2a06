//! Versions of the library and its binary interface.

use std::ffi::c_char;

/// Major version of the header.
pub const ASPERITY_VERSION_MAJOR: i32 = 0;
/// Minor version of the header.
pub const ASPERITY_VERSION_MINOR: i32 = 1;
/// Patch version of the header.
pub const ASPERITY_VERSION_PATCH: i32 = 0;
/// Version of the binary interface the header describes; compare with `asperity_abi_version()` of the library loaded.
pub const ASPERITY_ABI_VERSION: u32 = 1;

// The header's version is the package's.
const _: () = assert!(
    matches!(i32::from_str_radix(env!("CARGO_PKG_VERSION_MAJOR"), 10), Ok(ASPERITY_VERSION_MAJOR))
        && matches!(i32::from_str_radix(env!("CARGO_PKG_VERSION_MINOR"), 10), Ok(ASPERITY_VERSION_MINOR))
        && matches!(i32::from_str_radix(env!("CARGO_PKG_VERSION_PATCH"), 10), Ok(ASPERITY_VERSION_PATCH))
);

/// The binary interface of the library loaded: it changes only when compiled callers must be compiled again.
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_abi_version() -> u32 {
    ASPERITY_ABI_VERSION
}

/// The version of the library loaded, "major.minor.patch".
///
/// @return a constant string, never NULL
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_version() -> *const c_char {
    concat!(env!("CARGO_PKG_VERSION"), "\0").as_ptr().cast()
}
