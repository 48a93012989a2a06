//! What every entry point passes through: no panic crosses it, and every failure leaves a message.

use super::given::Given;
use super::status::{
    asperity_status, ASPERITY_INTERNAL, ASPERITY_INVALID_PARAMETER, ASPERITY_NULL_POINTER, ASPERITY_OK,
    ASPERITY_OUT_OF_MEMORY,
};
use super::{fp_environment, last_error};
use crate::error::{Error, Value};
use std::panic::{catch_unwind, AssertUnwindSafe};

/// Why an entry point fails.
pub enum Failure {
    /// An argument that must not be NULL is.
    Null(&'static str),
    /// The library refuses.
    Error(Error),
    /// It refuses one element of an array.
    Element(usize, Error),
    /// The system refuses memory.
    OutOfMemory,
    /// What is wrong about a parameter that is named.
    Name { name: &'static str, says: &'static str },
    /// A name that no such thing has, and the nearest that one has.
    UnknownName { of: &'static str, name: Given, nearest: &'static str },
    /// The name of a pair whose halves are not both materials, and the materials nearest to them.
    UnknownBodies { name: Given, nearest: [&'static str; 2] },
    /// The name of two materials that are no pair.
    UnlistedPair(Given),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Failure::Error(error)
    }
}

impl std::fmt::Display for Failure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Failure::Null(name) => write!(f, "{name} is NULL: pass a valid pointer"),
            Failure::Error(error) => write!(f, "{error}"),
            Failure::Element(index, error) => write!(f, "element {index}: {error}"),
            Failure::OutOfMemory => write!(f, "out of memory: nothing was made or changed; free some and call again"),
            Failure::Name { name, says } => write!(f, "{name}: {says}"),
            Failure::UnknownName { of, name, nearest } => {
                write!(f, "{name}: no {of} has this name; the nearest is {nearest}")
            }
            Failure::UnknownBodies { name, nearest: [first, second] } => {
                write!(f, "{name}: no pair has this name; the nearest is {first}/{second}")
            }
            Failure::UnlistedPair(name) => {
                write!(f, "work_of_adhesion: none is known for {name}: give that of your surfaces, 0 for none")
            }
        }
    }
}

impl Failure {
    fn status(&self) -> asperity_status {
        match self {
            Failure::Null(_) => ASPERITY_NULL_POINTER,
            Failure::Error(error) | Failure::Element(_, error) => error.status(),
            Failure::OutOfMemory => ASPERITY_OUT_OF_MEMORY,
            Failure::Name { .. }
            | Failure::UnknownName { .. }
            | Failure::UnknownBodies { .. }
            | Failure::UnlistedPair(_) => ASPERITY_INVALID_PARAMETER,
        }
    }
}

/// Runs the body of an entry point that returns a status, in the library's floating-point environment.
pub fn status(body: impl FnOnce() -> Result<(), Failure>) -> asperity_status {
    fp_environment::held(|| contained_status(body))
}

/// An entry point of a solver's inner loop, `contained_status` or `contained_value`, whose body itself sees to what may
/// raise an exception: in the caller's environment where that rounds to nearest. A macro, as a function would keep the
/// body from being inlined.
macro_rules! fast {
    ($contained:ident, $body:expr) => {
        if $crate::capi::fp_environment::rounds_to_nearest() {
            $crate::capi::boundary::$contained(|| $body)
        } else {
            $crate::capi::fp_environment::held(move || $crate::capi::boundary::$contained(|| $body))
        }
    };
}
pub(super) use fast;

/// A status, whatever the body does.
pub fn contained_status(body: impl FnOnce() -> Result<(), Failure>) -> asperity_status {
    match catch_unwind(AssertUnwindSafe(body)) {
        Ok(Ok(())) => ASPERITY_OK,
        Ok(Err(failure)) => {
            last_error::set(&failure);
            failure.status()
        }
        Err(_) => {
            last_error::set(&"internal error: a bug in asperity; please report the call and its arguments");
            ASPERITY_INTERNAL
        }
    }
}

/// A number, whatever the body does: NaN if it panics.
pub fn contained_value(body: impl FnOnce() -> f64) -> f64 {
    catch_unwind(AssertUnwindSafe(body)).unwrap_or(f64::NAN)
}

/// Reads through a pointer of the caller.
///
/// # Safety
/// `pointer` is NULL or points to a `T` that lives as long as the call.
pub unsafe fn reference<'a, T>(pointer: *const T, name: &'static str) -> Result<&'a T, Failure> {
    pointer.as_ref().ok_or(Failure::Null(name))
}

/// Writes through a pointer of the caller.
///
/// # Safety
/// `pointer` is NULL or points to a `T` that lives as long as the call and that nobody else uses.
pub unsafe fn reference_mut<'a, T>(pointer: *mut T, name: &'static str) -> Result<&'a mut T, Failure> {
    pointer.as_mut().ok_or(Failure::Null(name))
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
pub fn wrong_struct_size(size: u64, allowed: &'static str) -> Failure {
    let value = Value::Integer(i64::try_from(size).unwrap_or(i64::MAX));
    Failure::Error(Error::invalid("struct_size", value, allowed))
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

    #[test]
    fn every_failure_has_its_status() {
        let value = Value::Integer(0);
        let errors = [
            (Error::InvalidParameter { name: "", value, allowed: "" }, 2),
            (Error::Unset { name: "" }, 2),
            (Error::InvalidEntry { name: "", index: 0, value: 0.0, allowed: "" }, 2),
            (Error::InvalidLoad { value: f64::NAN }, 3),
            (Error::Separated { load: -2.0, pull_off: -1.0 }, 4),
            (Error::OutOfRange { name: "", value, allowed: "" }, 5),
            (Error::NotConverged { what: "", value: 0.0 }, 6),
        ];
        for (error, expected) in errors {
            assert_eq!(contained_status(|| Err(error.clone().into())), expected, "{error:?}");
            assert_eq!(contained_status(|| Err(Failure::Element(7, error.clone()))), expected, "{error:?}");
        }
        assert_eq!(contained_status(|| Err(Failure::Null(""))), 1);
        assert_eq!(contained_status(|| Err(Failure::OutOfMemory)), 7);
        assert_eq!(contained_status(|| Err(Failure::Name { name: "", says: "" })), 2);
        assert_eq!(contained_status(|| Ok(())), 0);
    }
}
