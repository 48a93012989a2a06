//! Strings that C reads in place.

/// A constant string that ends in NUL.
macro_rules! c_string {
    ($text:expr) => {
        match std::ffi::CStr::from_bytes_with_nul(concat!($text, "\0").as_bytes()) {
            Ok(text) => text,
            Err(_) => panic!("a NUL inside"),
        }
    };
}
pub(crate) use c_string;
