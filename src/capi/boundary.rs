//! What every entry point passes through: no panic crosses it, and every failure leaves a message.

use super::status::{
    asperity_status, ASPERITY_INTERNAL, ASPERITY_INVALID_PARAMETER, ASPERITY_NULL_POINTER, ASPERITY_OK,
};
use super::text::write_text;
use super::{fp_environment, last_error};
use crate::error::Error;
use std::ffi::c_char;
use std::fmt::{Arguments, Display};
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::path::Path;

/// Longer paths are shown by their file's name [bytes].
const LONGEST_PATH: usize = 200;

/// Why an entry point fails: its status. The caller's message is set where the failure is found, from what is known there.
#[derive(Debug, PartialEq)]
pub struct Failure(asperity_status);

impl Failure {
    #[cold]
    fn new(status: asperity_status, message: &dyn Display) -> Self {
        last_error::set(message);
        Self(status)
    }

    /// A file is refused, for what it has or what the system says of it.
    pub fn of_file(path: &Path, error: &Error) -> Self {
        // Only the end of a long path is told, so that what is wrong fits into the message.
        let name = path.file_name().filter(|_| path.as_os_str().len() > LONGEST_PATH).map_or(path, Path::new);
        Self::new(error.status(), &format_args!("{}: {error}", name.display()))
    }

    /// One element of an array is refused.
    pub fn of_element(index: usize, error: &Error) -> Self {
        Self::new(error.status(), &format_args!("element {index}: {error}"))
    }

    /// A pointer is NULL.
    #[cold]
    #[inline(never)] // There are hundreds of calls.
    fn null(name: &'static str) -> Self {
        Self::new(ASPERITY_NULL_POINTER, &format_args!("{name} is NULL: pass a valid pointer"))
    }

    /// One pointer of an array is NULL.
    pub fn null_element(name: &'static str, index: usize) -> Self {
        Self::new(ASPERITY_NULL_POINTER, &format_args!("{name}[{index}] is NULL: pass a valid pointer"))
    }

    /// A parameter is invalid, in words of its own.
    pub fn invalid(message: Arguments) -> Self {
        Self::new(ASPERITY_INVALID_PARAMETER, &message)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::new(error.status(), &error)
    }
}

/// Runs the body of an entry point that returns a status, in the library's floating-point environment.
pub fn status(mut body: impl FnMut() -> Result<(), Failure>) -> asperity_status {
    held_status(&mut body)
}

/// Once for all bodies, since all that is done around a body takes half a kilobyte.
#[inline(never)]
fn held_status(body: &mut dyn FnMut() -> Result<(), Failure>) -> asperity_status {
    fp_environment::held(|| contained_status(body))
}

/// Copies a text that is made now into a caller's buffer; returns its whole length, 0 where it cannot be made.
///
/// # Safety
/// `buffer` is NULL or has `length` bytes.
pub unsafe fn written(buffer: *mut c_char, length: usize, mut make: impl FnMut() -> Result<String, Failure>) -> usize {
    let mut text = String::new();
    status(|| {
        text = make()?;
        Ok(())
    });
    write_text(buffer, length, [text.as_bytes()])
}

/// A status, whatever the body does: of a call in a solver's inner loop, whose body itself sees to what may raise an exception.
pub fn contained_status(body: impl FnOnce() -> Result<(), Failure>) -> asperity_status {
    let message = "internal error: a bug in asperity; please report the call and its arguments";
    let ended = catch_unwind(AssertUnwindSafe(body)).unwrap_or_else(|_| Err(Failure::new(ASPERITY_INTERNAL, &message)));
    ended.map_or_else(|Failure(status)| status, |()| ASPERITY_OK)
}

/// A number, likewise: NaN if the body panics.
pub fn contained_value(body: impl FnOnce() -> f64) -> f64 {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or(f64::NAN)
}

/// Refuses a pointer that is NULL.
pub fn not_null<T>(pointer: *const T, name: &'static str) -> Result<(), Failure> {
    if pointer.is_null() {
        Err(Failure::null(name))
    } else {
        Ok(())
    }
}

/// Reads through a pointer of the caller.
///
/// # Safety
/// `pointer` is NULL or points to a `T` that lives as long as the call.
pub unsafe fn reference<'a, T>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    not_null(pointer, name).map(|()| &*pointer)
}

/// Writes through a pointer of the caller.
///
/// # Safety
/// `pointer` is NULL or points to a `T` that lives as long as the call and that nobody else uses.
pub unsafe fn reference_mut<'a, T>(pointer: *mut T, name: &'static str) -> Result<&'a mut T, Failure> {
    not_null(pointer, name).map(|()| &mut *pointer)
}

/// Writes an element of an output of the caller, which may be NULL and need not be aligned.
///
/// # Safety
/// `out` is NULL or has more than `index` elements.
pub unsafe fn write(out: *mut f64, index: usize, value: f64) {
    if !out.is_null() {
        out.add(index).write_unaligned(value);
    }
}

/// The error of a struct whose `struct_size` is not one this library knows.
pub fn wrong_struct_size(size: u64, allowed: impl Display) -> Failure {
    Failure::invalid(format_args!("struct_size = {size}: {allowed}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_a_status_with_a_message_or_nan() {
        let hook = std::panic::take_hook();
        std::panic::set_hook(Box::new(|_| {}));
        let (stopped, value) = (status(|| panic!("a bug")), contained_value(|| panic!("a bug")));
        std::panic::set_hook(hook);
        let mut message = [0_u8; 200];
        // SAFETY: a buffer of the length that is given.
        let length = unsafe { last_error::asperity_last_error(message.as_mut_ptr().cast(), message.len()) };
        let message = String::from_utf8_lossy(&message[..length]);
        assert_eq!(stopped, ASPERITY_INTERNAL);
        assert!(value.is_nan());
        assert!(message.starts_with("internal error: a bug in asperity"), "{message}");
    }
}
