//! The C interface as a C caller sees it: its structs and functions, the flags of the floating-point unit, messages.

#![allow(dead_code, unsafe_code, non_camel_case_types)]

use asperity as _;
use std::ffi::c_char;
use std::mem::size_of;

/// The handle.
pub enum asperity_model {}

/// The parameters of the header.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct asperity_params {
    pub struct_size: u64,
    /// From `composite_modulus` to `asperity_count`.
    pub quantities: [f64; 8],
    pub height_distribution: i32,
    pub attraction: i32,
    /// From `weibull_shape` to `max_friction_coefficient`.
    pub constants: [f64; 8],
    /// `skew`, `kurtosis`, `hardness`.
    pub appended: [f64; 3],
    /// `table_height` and `table_density`.
    pub table: [*const f64; 2],
    pub table_length: u64,
}

// SAFETY: the table that it leads to is static.
unsafe impl Send for asperity_params {}

/// The exact state of the header, field by field in `values`.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_state {
    pub struct_size: u64,
    pub load: f64,
    pub separation: f64,
    pub friction_force: f64,
    pub friction_coefficient: f64,
    pub dforce_dload: f64,
    pub dmu_dload: f64,
    pub dload_dseparation: f64,
    pub real_area: f64,
    pub contacting: f64,
    pub attracted: f64,
    pub attraction_load: f64,
    pub mean_contact_radius: f64,
    pub max_contact_radius: f64,
    /// Below `slip_radius_1`, between, above `slip_radius_2`.
    pub fractions: [f64; 3],
    pub fraction_in_contact: f64,
    pub mean_asperity_pressure: f64,
    pub plasticity_index: f64,
    pub warnings: u64,
}

/// The summary of the header.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_summary {
    pub struct_size: u64,
    pub alpha: f64,
    pub beta: f64,
    pub gamma: f64,
    pub lambda: f64,
    pub skew: f64,
    pub kurtosis: f64,
    pub pull_off_load: f64,
    pub pull_off_friction_force: f64,
    pub zero_load_friction_force: f64,
    pub min_table_load: f64,
    pub max_table_load: f64,
    pub table_error: f64,
}

/// The view of the compiled law of the header.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_table {
    pub struct_size: u64,
    pub rows: *const f64,
    pub row_count: u64,
    pub base: u64,
    pub shift: u32,
    pub layout_version: u32,
    pub pull_off_load: f64,
    pub max_friction_coefficient: f64,
    pub inverse_cap: f64,
    pub total_count: u64,
    pub pull_off_force: f64,
    pub light_slope: f64,
    pub zero_force: f64,
    pub zero_slope: f64,
    pub separated_slope: f64,
    pub heavy_force: f64,
}

pub const OK: i32 = 0;
pub const NULL_POINTER: i32 = 1;
pub const INVALID_PARAMETER: i32 = 2;
pub const INVALID_LOAD: i32 = 3;
pub const SEPARATED: i32 = 4;
pub const OUT_OF_RANGE: i32 = 5;
pub const NOT_CONVERGED: i32 = 6;

type Model = *const asperity_model;

extern "C" {
    pub fn asperity_abi_version() -> u32;
    pub fn asperity_version() -> *const c_char;
    pub fn asperity_status_string(status: i32) -> *const c_char;
    pub fn asperity_params_init(params: *mut asperity_params) -> i32;
    pub fn asperity_params_init_sized(params: *mut asperity_params, struct_size: u64) -> i32;
    pub fn asperity_params_set_dimensionless(
        params: *mut asperity_params,
        alpha: f64,
        beta: f64,
        gamma: f64,
        b_over_h: f64,
        poisson: f64,
    ) -> i32;
    pub fn asperity_params_set_materials(params: *mut asperity_params, e1: f64, nu1: f64, e2: f64, nu2: f64) -> i32;
    pub fn asperity_params_set_spectral_moments(
        params: *mut asperity_params,
        m0: f64,
        m2: f64,
        m4: f64,
        nominal_area: f64,
    ) -> i32;
    pub fn asperity_params_set_skew(params: *mut asperity_params, skew: f64) -> i32;
    pub fn asperity_create(params: *const asperity_params, model: *mut *mut asperity_model) -> i32;
    pub fn asperity_set_params(model: *mut asperity_model, params: *const asperity_params) -> i32;
    pub fn asperity_get_params(model: Model, params: *mut asperity_params) -> i32;
    pub fn asperity_get_params_sized(model: Model, params: *mut asperity_params, struct_size: u64) -> i32;
    pub fn asperity_free(model: *mut asperity_model);
    pub fn asperity_friction_at_load(model: Model, load: f64) -> f64;
    pub fn asperity_friction_force_at_load(model: Model, load: f64) -> f64;
    pub fn asperity_friction_at_loads(
        model: Model,
        n: usize,
        load: *const f64,
        mu: *mut f64,
        dmu_dload: *mut f64,
    ) -> i32;
    pub fn asperity_friction_force_at_loads(
        model: Model,
        n: usize,
        load: *const f64,
        force: *mut f64,
        dforce_dload: *mut f64,
    ) -> i32;
    pub fn asperity_friction_and_slope_at_load(model: Model, load: f64, slope: *mut f64) -> f64;
    pub fn asperity_friction_force_and_slope_at_load(model: Model, load: f64, slope: *mut f64) -> f64;
    pub fn asperity_friction_at_pressure(model: Model, pressure: f64, area: f64, slope: *mut f64) -> f64;
    pub fn asperity_shear_stress_at_pressure(model: Model, pressure: f64, area: f64, slope: *mut f64) -> f64;
    pub fn asperity_slip_force(
        model: Model,
        load: f64,
        slip_rate: f64,
        transition_rate: f64,
        dforce_dload: *mut f64,
        dforce_dslip_rate: *mut f64,
    ) -> f64;
    pub fn asperity_state_at_load(model: Model, load: f64, state: *mut asperity_state) -> i32;
    pub fn asperity_state_at_separation(model: Model, separation: f64, state: *mut asperity_state) -> i32;
    pub fn asperity_summary_of(model: Model, summary: *mut asperity_summary) -> i32;
    pub fn asperity_table_of(model: Model, table: *mut asperity_table) -> i32;
    pub fn asperity_last_error(buffer: *mut c_char, length: usize) -> usize;
}

impl asperity_params {
    /// The paper's default case.
    pub fn initial() -> Self {
        // SAFETY: zero bits are a value of every field.
        let mut params: Self = unsafe { std::mem::zeroed() };
        // SAFETY: a struct to write to.
        assert_eq!(unsafe { asperity_params_init_sized(&mut params, size_of::<Self>() as u64) }, OK);
        assert_eq!(params.struct_size as usize, size_of::<Self>());
        params
    }

    /// The parameters of a model.
    pub fn of(handle: &Handle) -> Self {
        let mut params = Self::initial();
        // SAFETY: the model lives.
        assert_eq!(unsafe { asperity_get_params_sized(handle.0, &mut params, size_of::<Self>() as u64) }, OK);
        params
    }

    /// The paper's case of these groups, with Poisson's ratio 0.3.
    pub fn dimensionless(alpha: f64, beta: f64, gamma: f64, b_over_h: f64) -> Self {
        let mut params = Self::initial();
        // SAFETY: an initialised struct.
        let status = unsafe { asperity_params_set_dimensionless(&mut params, alpha, beta, gamma, b_over_h, 0.3) };
        assert_eq!(status, OK, "{}", message());
        params
    }

    /// With Weibull heights.
    pub fn weibull(mut self, shape: f64) -> Self {
        self.height_distribution = 1;
        self.constants[0] = shape;
        self
    }

    /// With heights of Johnson's system.
    pub fn johnson(mut self, skew: f64, kurtosis: f64) -> Self {
        self.height_distribution = 2;
        self.appended[..2].copy_from_slice(&[skew, kurtosis]);
        self
    }

    /// With heights of a measured density.
    pub fn table(mut self, height: &'static [f64], density: &'static [f64]) -> Self {
        self.height_distribution = 3;
        self.table = [height.as_ptr(), density.as_ptr()];
        self.table_length = height.len() as u64;
        self
    }

    /// With radii that vary with height.
    pub fn radii(mut self, amplitude: f64, rate: f64) -> Self {
        self.constants[1] = amplitude;
        self.constants[2] = rate;
        self
    }

    /// With a cap on friction coefficients.
    pub fn cap(mut self, cap: f64) -> Self {
        self.constants[7] = cap;
        self
    }
}

impl asperity_state {
    /// A state to fill.
    pub fn empty() -> Self {
        // SAFETY: zero bits are a value of every field.
        Self { struct_size: size_of::<Self>() as u64, ..unsafe { std::mem::zeroed() } }
    }
}

impl asperity_summary {
    /// A summary to fill.
    pub fn empty() -> Self {
        // SAFETY: zero bits are a value of every field.
        Self { struct_size: size_of::<Self>() as u64, ..unsafe { std::mem::zeroed() } }
    }
}

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
