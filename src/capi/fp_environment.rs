//! The caller's floating-point environment: hosts run with traps on, and read the flags.
//!
//! The compiler may evaluate ahead of a condition what the condition would have kept from dividing by zero. Everything
//! but the few operations of the table therefore runs with exceptions held and rounding to nearest, whatever the host's is, and
//! the caller's environment is put back, flags included.

use std::ffi::c_int;

/// Room for the platform's `fenv_t`, which takes 32 bytes or less on the common ones.
#[repr(C, align(16))]
struct Environment([u64; 32]);

extern "C" {
    fn feholdexcept(environment: *mut Environment) -> c_int;
    fn fesetround(rounding: c_int) -> c_int;
    fn fesetenv(environment: *const Environment) -> c_int;
}

/// Puts the environment back also when the body panics.
struct Held(Environment);

impl Drop for Held {
    fn drop(&mut self) {
        // SAFETY: the environment is the one that feholdexcept saved.
        unsafe { fesetenv(&self.0) };
    }
}

/// Runs the body with floating-point exceptions held, rounding to nearest.
pub fn held<T>(body: impl FnOnce() -> T) -> T {
    let mut held = Held(Environment([0; 32]));
    // SAFETY: the environment has room for any fenv_t.
    unsafe { feholdexcept(&mut held.0) };
    // SAFETY: it takes a number. 0 is FE_TONEAREST on every system that has it.
    unsafe { fesetround(0) };
    body()
}
