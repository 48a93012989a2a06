//! The C functions, and what tests of them share: parameters in short, models that free themselves, messages, the flags
//! of the floating-point unit.

#![allow(unsafe_code)]

pub use asperity::capi::{
    ASPERITY_INVALID_LOAD as INVALID_LOAD, ASPERITY_INVALID_PARAMETER as INVALID_PARAMETER,
    ASPERITY_NOT_CONVERGED as NOT_CONVERGED, ASPERITY_NULL_POINTER as NULL_POINTER, ASPERITY_OK as OK,
    ASPERITY_OUT_OF_RANGE as OUT_OF_RANGE, ASPERITY_SEPARATED as SEPARATED, *,
};
use std::mem::size_of;

/// Parameters, made and changed in few words.
pub trait TestParams: Sized {
    /// As they are initialised: without the physical inputs.
    fn unset() -> Self;
    /// The paper's case.
    fn initial() -> Self;
    /// The parameters of a model.
    fn of(handle: &Handle) -> Self;
    /// The paper's case of these groups, with Poisson's ratio 0.3.
    fn dimensionless(alpha: f64, beta: f64, gamma: f64, b_over_h: f64) -> Self;
    /// With Weibull heights.
    fn weibull(self, shape: f64) -> Self;
    /// With heights of Johnson's system.
    fn johnson(self, skew: f64, kurtosis: f64) -> Self;
    /// With heights of a measured density.
    fn table(self, height: &'static [f64], density: &'static [f64]) -> Self;
    /// With radii that vary with height.
    fn radii(self, amplitude: f64, rate: f64) -> Self;
    /// With a cap on friction coefficients.
    fn cap(self, cap: f64) -> Self;
    /// Those with a unit, and the number of summits.
    fn quantities(&mut self) -> [&mut f64; 8];
}

impl TestParams for asperity_params {
    fn unset() -> Self {
        // SAFETY: zero bits are a value of every field.
        let mut params: Self = unsafe { std::mem::zeroed() };
        // SAFETY: a struct to write to.
        assert_eq!(unsafe { asperity_params_init(&mut params, size_of::<Self>()) }, OK);
        assert_eq!(params.struct_size as usize, size_of::<Self>());
        params
    }

    fn initial() -> Self {
        Self::dimensionless(0.01, 1000.0, 0.001, 1.0)
    }

    fn of(handle: &Handle) -> Self {
        let mut params = Self::unset();
        // SAFETY: the model lives.
        assert_eq!(unsafe { asperity_get_params(handle.0, &mut params) }, OK);
        params
    }

    fn dimensionless(alpha: f64, beta: f64, gamma: f64, b_over_h: f64) -> Self {
        let mut params = Self::unset();
        // SAFETY: an initialised struct.
        let status = unsafe { asperity_params_set_dimensionless(&mut params, alpha, beta, gamma, b_over_h, 0.3) };
        assert_eq!(status, OK, "{}", message());
        params
    }

    fn weibull(self, weibull_shape: f64) -> Self {
        Self { height_distribution: ASPERITY_HEIGHTS_WEIBULL, weibull_shape, ..self }
    }

    fn johnson(self, skew: f64, kurtosis: f64) -> Self {
        Self { height_distribution: ASPERITY_HEIGHTS_JOHNSON, skew, kurtosis, ..self }
    }

    fn table(self, height: &'static [f64], density: &'static [f64]) -> Self {
        Self {
            height_distribution: ASPERITY_HEIGHTS_TABULATED,
            table_height: height.as_ptr(),
            table_density: density.as_ptr(),
            table_length: height.len() as u64,
            ..self
        }
    }

    fn radii(self, radius_amplitude: f64, radius_rate: f64) -> Self {
        Self { radius_amplitude, radius_rate, ..self }
    }

    fn cap(self, max_friction_coefficient: f64) -> Self {
        Self { max_friction_coefficient, ..self }
    }

    fn quantities(&mut self) -> [&mut f64; 8] {
        [
            &mut self.composite_modulus,
            &mut self.effective_shear_modulus,
            &mut self.work_of_adhesion,
            &mut self.adhesion_range,
            &mut self.burgers_vector,
            &mut self.height_std,
            &mut self.summit_radius,
            &mut self.asperity_count,
        ]
    }
}

/// A struct to fill.
pub trait Output {
    /// With its size set.
    fn empty() -> Self;
}

macro_rules! output {
    ($($name:ident)*) => {$(
        impl Output for $name {
            fn empty() -> Self {
                // SAFETY: zero bits are a value of every field.
                Self { struct_size: size_of::<Self>() as u64, ..unsafe { std::mem::zeroed() } }
            }
        }
    )*};
}
output!(asperity_estimate asperity_state asperity_summary asperity_table asperity_microslip);

/// A model, freed when dropped.
#[derive(Debug)]
pub struct Handle(pub *mut asperity_model);

// SAFETY: calls that take a const model may share it.
unsafe impl Sync for Handle {}

impl Handle {
    /// The model of valid parameters.
    pub fn new(params: &asperity_params) -> Self {
        let mut model = std::ptr::null_mut();
        // SAFETY: both live as long as the call.
        let status = unsafe { asperity_create(params, &mut model) };
        assert_eq!(status, OK, "{params:?}: {}", message());
        Self(model)
    }

    /// Its constants.
    pub fn summary(&self) -> asperity_summary {
        let mut summary = asperity_summary::empty();
        // SAFETY: the model lives, the struct has its size set.
        assert_eq!(unsafe { asperity_summary_of(self.0, &mut summary) }, OK);
        summary
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        // SAFETY: the model is freed once.
        unsafe { asperity_free(self.0) }
    }
}

/// This thread's last message.
pub fn message() -> String {
    let mut buffer = [0_u8; 1024];
    // SAFETY: the buffer has the length it says.
    let length = unsafe { asperity_last_error(buffer.as_mut_ptr().cast(), buffer.len()) };
    String::from_utf8(buffer[..length].to_vec()).expect("a message in UTF-8")
}

/// Makes the message of this thread's last failure a known one.
pub fn reset_message() {
    // SAFETY: NULL is refused.
    assert_eq!(unsafe { asperity_set_params(std::ptr::null_mut(), std::ptr::null()) }, NULL_POINTER);
}

/// The bytes of a struct, to compare NaN as well.
pub fn bytes<T>(value: &T) -> &[u8] {
    // SAFETY: the structs of the interface have no padding.
    unsafe { std::slice::from_raw_parts(std::ptr::from_ref(value).cast(), size_of::<T>()) }
}

/// The flags that hosts trap: invalid operation, division by zero, overflow.
#[cfg(all(target_arch = "x86_64", not(miri)))]
pub mod flags {
    use std::arch::asm;

    const TRAPPED: u32 = 0x01 | 0x04 | 0x08;
    const ALL: u32 = 0x3f;

    fn control_and_status() -> u32 {
        let mut register = 0_u32;
        // SAFETY: stores MXCSR in four bytes.
        unsafe { asm!("stmxcsr [{}]", in(reg) &mut register, options(nostack)) };
        register
    }

    /// Clears the flags and runs a call, which must not be inlined here; tells which flags it raised, and whether it
    /// changed how the processor rounds or traps.
    pub fn watch<T>(call: impl FnOnce() -> T) -> (T, Option<String>) {
        let before = control_and_status() & !ALL;
        // SAFETY: the control bits stay as they are.
        unsafe { asm!("ldmxcsr [{}]", in(reg) &before, options(nostack)) };
        let answer = call();
        let after = control_and_status();
        let complaint = if after & TRAPPED != 0 {
            let raised = after & TRAPPED;
            Some(format!("raised floating-point flags {raised} (1 invalid, 4 division by zero, 8 overflow)"))
        } else {
            (after & !ALL != before).then(|| "changed the floating-point environment".to_string())
        };
        (answer, complaint)
    }
}

/// Elsewhere the flags have no portable name, and Miri has none: the call alone.
#[cfg(any(not(target_arch = "x86_64"), miri))]
pub mod flags {
    /// Runs a call.
    pub fn watch<T>(call: impl FnOnce() -> T) -> (T, Option<String>) {
        (call(), None)
    }
}

/// Miri calls no C: the two functions of libm that hold the floating-point environment, of which it has none.
#[cfg(miri)]
mod environment {
    use std::ffi::{c_int, c_void};

    #[no_mangle]
    extern "C" fn feholdexcept(_: *mut c_void) -> c_int {
        0
    }

    #[no_mangle]
    extern "C" fn fesetenv(_: *const c_void) -> c_int {
        0
    }
}
