//! The caller's floating-point environment: hosts run with traps on and read the flags.
//!
//! The compiler may evaluate ahead of a condition what the condition would have kept from dividing by zero. Everything but
//! the few operations of the table, and of the powers beyond it where no number can overflow or underflow, therefore runs in
//! [`held`]: in the environment with which a program starts, where nothing traps. It puts the caller's back, flags included.
//! Those operations raise nothing but "inexact" and run as the caller rounds.
//!
//! Registers are written directly on common processors: the C library's functions take ten times as long, and those of MinGW
//! and musl leave the traps of MXCSR on.

use registers::{exchange, Registers, OWN};

/// Puts the caller's environment back, also when the body panics.
struct Held(Registers);

impl Drop for Held {
    #[inline]
    fn drop(&mut self) {
        exchange(&self.0);
    }
}

/// Runs the body in the library's environment.
#[inline(never)]
pub fn held<T>(body: impl FnOnce() -> T) -> T {
    let _held = Held(exchange(&OWN));
    apart(body)
}

/// A call of its own, so that the compiler moves none of the body's arithmetic out of it.
#[inline(never)]
fn apart<T>(body: impl FnOnce() -> T) -> T {
    body()
}

#[cfg(all(any(target_arch = "x86_64", target_arch = "x86"), not(miri)))]
mod registers {
    use std::arch::asm;

    #[cfg(not(target_feature = "sse2"))]
    compile_error!("asperity needs SSE2: x87 arithmetic gives other bits; build for i686, not i586");

    /// MXCSR. The x87 unit does none of the library's arithmetic.
    pub type Registers = u32;
    /// Exceptions masked, rounding to nearest, no flag set.
    pub const OWN: Registers = 0x1f80;

    #[inline]
    pub fn exchange(new: &Registers) -> Registers {
        let mut old = 0;
        // SAFETY: it writes four bytes to where there are four; the new value is the library's, or was read there.
        unsafe {
            asm!("stmxcsr [{old}]", "ldmxcsr [{new}]", old = in(reg) &raw mut old, new = in(reg) new,
                 options(nostack, preserves_flags));
        }
        old
    }
}

#[cfg(all(target_arch = "aarch64", not(miri)))]
mod registers {
    use std::arch::asm;

    /// FPCR and FPSR.
    pub type Registers = [u64; 2];
    /// With which a program starts.
    pub const OWN: Registers = [0; 2];

    #[inline]
    pub fn exchange(&[control, status]: &Registers) -> Registers {
        let mut old = OWN;
        // SAFETY: the new values are the library's, or were read from the registers.
        unsafe {
            asm!("mrs {0}, fpcr", "mrs {1}, fpsr", "msr fpcr, {2}", "msr fpsr, {3}", out(reg) old[0], out(reg) old[1],
                 in(reg) control, in(reg) status, options(nostack, preserves_flags));
        }
        old
    }
}

#[cfg(any(target_family = "wasm", miri))]
mod registers {
    /// Nothing traps, no flag is set, and there is only rounding to nearest. So it is in Miri, which runs no assembly.
    pub struct Registers;
    pub const OWN: Registers = Registers;

    pub fn exchange(_: &Registers) -> Registers {
        OWN
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86", target_arch = "aarch64", target_family = "wasm", miri)))]
mod registers {
    use std::ffi::c_int;

    /// Room for the platform's `fenv_t`, which takes 32 bytes or less on the common ones.
    #[repr(C, align(16))]
    pub struct Saved([u64; 32]);
    /// What the C library saved of the caller's environment; none is the library's own.
    pub type Registers = Option<Saved>;
    pub const OWN: Registers = None;

    extern "C" {
        fn feholdexcept(environment: *mut Saved) -> c_int;
        fn fesetround(rounding: c_int) -> c_int;
        fn fesetenv(environment: *const Saved) -> c_int;
    }

    pub fn exchange(new: &Registers) -> Registers {
        let Some(callers) = new else {
            let mut callers = Saved([0; 32]);
            // SAFETY: there is room for any fenv_t. 0 is FE_TONEAREST on every system that has it.
            unsafe { (feholdexcept(&mut callers), fesetround(0)) };
            return Some(callers);
        };
        // SAFETY: the environment is the one that feholdexcept saved.
        unsafe { fesetenv(callers) };
        None
    }
}
