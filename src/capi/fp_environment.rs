//! The caller's floating-point environment: hosts run with traps on, round in other directions, flush small numbers to
//! zero, and read the flags.
//!
//! The library's own is that with which a program starts: nothing traps, results are rounded to nearest, and small numbers
//! are kept, so that all processors give the same bits. The compiler may evaluate ahead of a condition what the condition
//! would have kept from dividing by zero. Everything but the few operations of the table, and of the powers beyond it
//! where no number can overflow or underflow, therefore runs in [`held`], which puts the caller's environment back, flags
//! included. Those operations raise nothing but "inexact" and run in the caller's environment where that
//! [`rounds_to_nearest`].
//!
//! Registers are written directly where Rust has their instructions: the C library's functions take ten times as long,
//! and those of MinGW and musl leave the traps of MXCSR on.

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

/// Whether the caller's environment rounds to nearest: found out by rounding 3/4 and 1/4 to whole numbers, which takes
/// less time than reading the register.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub fn rounds_to_nearest() -> bool {
    use std::arch::x86_64::{__m128, _mm_cvtps_epi32, _mm_cvtsi128_si64};
    #[repr(align(16))]
    struct Aligned<T>(T);
    static PARTS: Aligned<[f32; 4]> = Aligned([0.75, 0.25, 0.0, 0.0]);
    // SAFETY: the numbers are there. "Volatile" keeps the compiler from rounding them itself.
    let rounded = unsafe { _mm_cvtps_epi32((&raw const PARTS.0).cast::<__m128>().read_volatile()) };
    // SAFETY: every such processor has the instruction.
    (unsafe { _mm_cvtsi128_si64(rounded) }) == 1
}

/// Whether the caller's environment rounds to nearest: found out by adding to 1 a quarter and three quarters of the
/// distance to the next number.
#[cfg(not(any(target_arch = "x86_64", target_family = "wasm")))]
#[inline(always)]
pub fn rounds_to_nearest() -> bool {
    static PARTS: [f64; 2] = [0.25 * f64::EPSILON, 0.75 * f64::EPSILON];
    // SAFETY: the numbers are there. "Volatile" keeps the compiler from adding them itself.
    let [quarter, three_quarters] = [0, 1].map(|i| unsafe { (&raw const PARTS[i]).read_volatile() });
    1.0 + quarter < 1.0 + three_quarters
}

/// WebAssembly rounds to nearest.
#[cfg(target_family = "wasm")]
pub fn rounds_to_nearest() -> bool {
    true
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

#[cfg(all(target_arch = "riscv64", not(miri)))]
mod registers {
    use std::arch::asm;

    /// FCSR.
    pub type Registers = u64;
    /// With which a program starts.
    pub const OWN: Registers = 0;

    #[inline]
    pub fn exchange(new: &Registers) -> Registers {
        let old;
        // SAFETY: the new value is the library's, or was read from the register.
        unsafe { asm!("fscsr {}, {}", out(reg) old, in(reg) *new, options(nostack)) };
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

#[cfg(not(any(
    target_arch = "x86_64",
    target_arch = "x86",
    target_arch = "aarch64",
    target_arch = "riscv64",
    target_family = "wasm",
    miri
)))]
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
