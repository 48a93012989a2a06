//! The caller's floating-point environment: hosts run with traps on, round in other directions, flush small numbers to
//! zero, and read the flags.
//!
//! The compiler may evaluate ahead of a condition what the condition would have kept from dividing by zero. Everything
//! but the few operations of the table therefore runs in the environment that a program starts with, in which nothing traps
//! and all processors give the same bits; then the caller's is put back, flags included.
//!
//! Where Rust knows the processor's registers they are read and written directly: the C library's functions take many times
//! as long, and some of them leave the vector registers' traps on.

/// Puts the caller's environment back, also when the body panics.
struct Held(Environment);

impl Drop for Held {
    fn drop(&mut self) {
        self.0.restore();
    }
}

/// Runs the body with floating-point exceptions held, rounding to nearest.
pub fn held<T>(body: impl FnOnce() -> T) -> T {
    let _held = Held(Environment::replace());
    apart(body)
}

/// A call of its own, so that the compiler moves none of the body's arithmetic out of it.
#[inline(never)]
fn apart<T>(body: impl FnOnce() -> T) -> T {
    body()
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
mod registers {
    use std::arch::asm;

    /// MXCSR, which governs all arithmetic of the library; the x87 unit, which some callers' own arithmetic uses, only
    /// carries results to them where pointers have 32 bits.
    pub struct Environment(u32);

    /// As a program starts: exceptions masked, rounding to nearest, no flag set.
    const DEFAULT: u32 = 0x1f80;
    const FLAGS: u32 = 0x3f;

    impl Environment {
        #[inline]
        pub fn replace() -> Self {
            let callers = read();
            // Writing the register takes far longer than reading it. Flags that are set already do no harm.
            if callers & !FLAGS != DEFAULT {
                write(DEFAULT);
            }
            Self(callers)
        }

        #[inline]
        pub fn restore(&self) {
            if read() != self.0 {
                write(self.0);
            }
        }
    }

    #[inline]
    fn read() -> u32 {
        let mut value = 0_u32;
        // SAFETY: it writes four bytes to where there are four.
        unsafe { asm!("stmxcsr [{}]", in(reg) &mut value, options(nostack, preserves_flags)) };
        value
    }

    #[inline]
    fn write(value: u32) {
        // SAFETY: the value is the default one, or what was read from the register.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &value, options(nostack, preserves_flags, readonly)) };
    }
}

#[cfg(target_arch = "aarch64")]
mod registers {
    use std::arch::asm;

    /// FPCR and FPSR.
    pub struct Environment {
        control: u64,
        status: u64,
    }

    impl Environment {
        #[inline]
        pub fn replace() -> Self {
            let callers = read();
            // 0: as a program starts. Writing the register takes longer than reading it.
            if callers.control != 0 {
                write_control(0);
            }
            callers
        }

        #[inline]
        pub fn restore(&self) {
            if self.control != 0 {
                write_control(self.control);
            }
            if read().status != self.status {
                // SAFETY: the value was read from the register.
                unsafe { asm!("msr fpsr, {}", in(reg) self.status, options(nostack, preserves_flags)) };
            }
        }
    }

    #[inline]
    fn read() -> Environment {
        let (control, status);
        // SAFETY: it only reads registers.
        unsafe {
            asm!("mrs {}, fpcr", "mrs {}, fpsr", out(reg) control, out(reg) status, options(nostack, preserves_flags))
        };
        Environment { control, status }
    }

    #[inline]
    fn write_control(value: u64) {
        // SAFETY: the value is the default one, or what was read from the register.
        unsafe { asm!("msr fpcr, {}", in(reg) value, options(nostack, preserves_flags)) };
    }
}

#[cfg(target_family = "wasm")]
mod registers {
    /// Nothing traps, and there is only rounding to nearest.
    pub struct Environment;

    impl Environment {
        #[inline]
        pub fn replace() -> Self {
            Self
        }

        #[inline]
        pub fn restore(&self) {}
    }
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86", target_arch = "aarch64", target_family = "wasm")))]
mod registers {
    use std::ffi::c_int;

    /// Room for the platform's `fenv_t`, which takes 32 bytes or less on the common ones.
    #[repr(C, align(16))]
    pub struct Environment([u64; 32]);

    extern "C" {
        fn feholdexcept(environment: *mut Environment) -> c_int;
        fn fesetround(rounding: c_int) -> c_int;
        fn fesetenv(environment: *const Environment) -> c_int;
    }

    impl Environment {
        pub fn replace() -> Self {
            let mut callers = Self([0; 32]);
            // SAFETY: the environment has room for any fenv_t.
            unsafe { feholdexcept(&mut callers) };
            // SAFETY: it takes a number. 0 is FE_TONEAREST on every system that has it.
            unsafe { fesetround(0) };
            callers
        }

        pub fn restore(&self) {
            // SAFETY: the environment is the one that feholdexcept saved.
            unsafe { fesetenv(self) };
        }
    }
}

use registers::Environment;
