//! Names that callers give: how much of them is read.

use super::boundary::{not_null, Failure};
use crate::materials::names::LONGEST;
use std::ffi::c_char;

/// A caller's name, as far as it is read.
///
/// # Safety
/// `name` is NULL or points to a string that ends in NUL or has `LONGEST` bytes, and lives as long as the call.
pub unsafe fn read<'a>(name: *const c_char) -> Result<&'a [u8], Failure> {
    not_null(name, "name")?;
    let length = (0..LONGEST).find(|&i| *name.add(i) == 0).unwrap_or(LONGEST);
    Ok(std::slice::from_raw_parts(name.cast(), length))
}
