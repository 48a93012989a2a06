//! Versions of the header and of the binary interface that it describes.

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
