//! Structs that the library fills, no further than the caller's have room.

use super::boundary::{reference, wrong_struct_size, Failure};
use std::mem::{align_of, size_of};

/// A struct for the caller with what a struct of the library has in the fields of the same names.
macro_rules! same_fields {
    ($struct:ident of $from:expr; $($field:ident)*) => {{
        let from = $from;
        $struct { struct_size: std::mem::size_of::<$struct>() as u64, $($field: from.$field),* }
    }};
}
pub(super) use same_fields;

/// Fills an output struct but for `struct_size`, which stays as the caller has set it, and no further than that says.
///
/// # Safety
/// `out` is NULL or points to a struct of the size its first field says.
pub unsafe fn fill<T>(
    out: *mut T,
    name: &'static str,
    make: impl FnOnce() -> Result<T, Failure>,
) -> Result<(), Failure> {
    const FIRST: usize = size_of::<u64>();
    // SAFETY: struct_size is the first field of every such struct, and the caller has set it.
    let size = *reference(out.cast::<u64>(), name)?;
    if size < 16 || size % align_of::<T>() as u64 != 0 {
        return Err(wrong_struct_size(size, "must be set to sizeof of the output struct before the call"));
    }
    let value = make()?;
    let count = size_of::<T>().min(usize::try_from(size).unwrap_or(usize::MAX)) - FIRST;
    // SAFETY: the caller says that `size` bytes may be written.
    std::ptr::copy_nonoverlapping((&raw const value).cast::<u8>().add(FIRST), out.cast::<u8>().add(FIRST), count);
    Ok(())
}
