//! Exact states and the summary, as C sees them.

use super::boundary::{self, reference, wrong_struct_size, Failure};
use super::model::asperity_model;
use super::reserve;
use super::status::asperity_status;
use crate::error::Error;
use crate::model::{State, Summary};
use std::mem::{align_of, size_of};

/// The exact state of the contact; all quantities in the units of the parameters.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_state {
    /// Set by the caller to `sizeof(asperity_state)`; the library writes no more than that.
    pub struct_size: u64,
    /// Normal load P [force]; negative pulls.
    pub load: f64,
    /// Separation d of the flat from the mean of the summit heights [length].
    pub separation: f64,
    /// Friction force F [force].
    pub friction_force: f64,
    /// Friction coefficient F/P, capped, as `asperity_friction_at_load` gives it.
    pub friction_coefficient: f64,
    /// dF/dP; INFINITY at the pull-off load itself.
    pub dforce_dload: f64,
    /// d(F/P)/dP [1/force]; 0 where the coefficient is capped.
    pub dmu_dload: f64,
    /// dP/dd [force/length]: minus the contact stiffness.
    pub dload_dseparation: f64,
    /// Real area of contact [length^2].
    pub real_area: f64,
    /// Number of summits in contact.
    pub contacting: f64,
    /// Number of summits that attract without contact.
    pub attracted: f64,
    /// Load of the summits that attract without contact, <= 0 [force].
    pub attraction_load: f64,
    /// Mean radius of the contacts [length]; 0 if nothing touches; likewise for the fields below, except
    /// `plasticity_index`.
    pub mean_contact_radius: f64,
    /// Expected radius of the largest of n = `contacting` contacts [length]: the largest radius up to the height that
    /// 1/(n + 1) of the contacts exceed. At least the mean radius, and equal to it for n <= 1, hence always if
    /// `asperity_count` is 1: give the true number of summits.
    pub max_contact_radius: f64,
    /// Fraction of the contacts with radii up to `slip_radius_1`, which slip as a whole.
    pub fraction_below_slip_radius_1: f64,
    /// Fraction of the contacts with radii between `slip_radius_1` and `slip_radius_2`.
    pub fraction_between_slip_radii: f64,
    /// Fraction of the contacts with radii of at least `slip_radius_2`.
    pub fraction_above_slip_radius_2: f64,
    /// Fraction of all summits that are in contact.
    pub fraction_in_contact: f64,
    /// Load of the summits in contact over their real area [stress]; negative where adhesion pulls more than they push.
    pub mean_asperity_pressure: f64,
    /// Greenwood and Williamson's plasticity index, E* (sigma/R)^(1/2)/H; 0 where the hardness H is not given.
    pub plasticity_index: f64,
    /// Bits `ASPERITY_WARNING_...`: assumptions of the model that fail in this state; 0 if none is known to fail.
    pub warnings: u64,
    /// K_t [force/length]: tangential force by displacement while all contacts stick.
    pub tangential_stiffness: f64,
    /// Fraction of the contacts below first yield; 1 for `ASPERITY_CONTACT_MAUGIS` without a hardness.
    pub fraction_elastic: f64,
    /// Fraction of the contacts that are fully plastic.
    pub fraction_flowing: f64,
}

/// Constants of a model, in the units of the parameters.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_summary {
    /// Set by the caller to `sizeof(asperity_summary)`; the library writes no more than that.
    pub struct_size: u64,
    /// Surface roughness parameter (sigma/R)^(1/2).
    pub alpha: f64,
    /// Friction regime parameter (R sigma)^(1/2)/b.
    pub beta: f64,
    /// Surface energy parameter w/(E* b).
    pub gamma: f64,
    /// Maugis' adhesion parameter: small is DMT, large is JKR.
    pub lambda: f64,
    /// Skew of the summit heights.
    pub skew: f64,
    /// Kurtosis of the summit heights; 3 for Gaussian.
    pub kurtosis: f64,
    /// The pull-off load, the smallest load at which the surfaces hold together, <= 0 [force].
    pub pull_off_load: f64,
    /// Friction force at the pull-off load [force].
    pub pull_off_friction_force: f64,
    /// Friction force at zero load [force].
    pub zero_load_friction_force: f64,
    /// The lightest load of the compiled table [force]; lighter ones are interpolated or evaluated exactly.
    pub min_table_load: f64,
    /// The heaviest load of the compiled table [force]; heavier ones are evaluated exactly.
    pub max_table_load: f64,
    /// Largest relative error of the compiled friction force at the samples that were compared when the model was made;
    /// between samples it may be four times as large.
    pub table_error: f64,
}

impl asperity_state {
    fn new(state: &State, struct_size: u64) -> Self {
        Self {
            struct_size,
            load: state.load,
            separation: state.separation,
            friction_force: state.friction_force,
            friction_coefficient: state.friction_coefficient,
            dforce_dload: state.dforce_dload,
            dmu_dload: state.dmu_dload,
            dload_dseparation: state.dload_dseparation,
            real_area: state.real_area,
            contacting: state.contacting,
            attracted: state.attracted,
            attraction_load: state.attraction_load,
            mean_contact_radius: state.mean_contact_radius,
            max_contact_radius: state.max_contact_radius,
            fraction_below_slip_radius_1: state.fraction_below_slip_radius_1,
            fraction_between_slip_radii: state.fraction_between_slip_radii,
            fraction_above_slip_radius_2: state.fraction_above_slip_radius_2,
            fraction_in_contact: state.fraction_in_contact,
            mean_asperity_pressure: state.mean_asperity_pressure,
            plasticity_index: state.plasticity_index,
            warnings: state.warnings,
            tangential_stiffness: state.tangential_stiffness,
            fraction_elastic: state.fraction_elastic,
            fraction_flowing: state.fraction_flowing,
        }
    }
}

impl asperity_summary {
    fn new(summary: &Summary, struct_size: u64) -> Self {
        Self {
            struct_size,
            alpha: summary.alpha,
            beta: summary.beta,
            gamma: summary.gamma,
            lambda: summary.lambda,
            skew: summary.skew,
            kurtosis: summary.kurtosis,
            pull_off_load: summary.pull_off_load,
            pull_off_friction_force: summary.pull_off_friction_force,
            zero_load_friction_force: summary.zero_load_friction_force,
            min_table_load: summary.min_table_load,
            max_table_load: summary.max_table_load,
            table_error: summary.table_error,
        }
    }
}

/// Fills an output struct, no further than the caller's `struct_size`.
///
/// # Safety
/// `out` is NULL or points to a struct of the size its first field says.
pub(super) unsafe fn fill<T>(
    out: *mut T,
    name: &'static str,
    make: impl FnOnce(u64) -> Result<T, Error>,
) -> Result<(), Failure> {
    if out.is_null() {
        return Err(Failure::Null(name));
    }
    // SAFETY: struct_size is the first field of every such struct, and the caller has set it.
    let size = out.cast::<u64>().read();
    if size < 16 || size % align_of::<T>() as u64 != 0 {
        return Err(wrong_struct_size(size, "must be set to sizeof of the output struct before the call"));
    }
    let value = make(size)?;
    let count = size_of::<T>().min(usize::try_from(size).unwrap_or(usize::MAX));
    // SAFETY: the caller says that `size` bytes may be written.
    std::ptr::copy_nonoverlapping((&raw const value).cast::<u8>(), out.cast::<u8>(), count);
    Ok(())
}

/// The exact state at a load, by integration over the summits, without the table.
///
/// @param model  must not be NULL
/// @param load   normal load [force], from the pull-off load upwards
/// @param state  receives the state; must not be NULL; its `struct_size` must be set; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`,
///         `ASPERITY_OUT_OF_MEMORY`
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_state_at_load(
    model: *const asperity_model,
    load: f64,
    state: *mut asperity_state,
) -> asperity_status {
    boundary::status(|| {
        let model = &reference(model, "model")?.model;
        reserve::held(|| fill(state, "state", |size| Ok(asperity_state::new(&model.state_at_load(load)?, size))))
    })
}

/// The exact state at a separation, also beyond the pull-off point, where no load holds the surfaces in equilibrium.
///
/// @param model       must not be NULL
/// @param separation  of the flat from the mean of the summit heights [length]; may be negative
/// @param state       receives the state; must not be NULL; its `struct_size` must be set; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`, or a separation that
///         is not finite), `ASPERITY_OUT_OF_RANGE`, `ASPERITY_OUT_OF_MEMORY`
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_state_at_separation(
    model: *const asperity_model,
    separation: f64,
    state: *mut asperity_state,
) -> asperity_status {
    boundary::status(|| {
        let model = &reference(model, "model")?.model;
        reserve::held(|| {
            fill(state, "state", |size| Ok(asperity_state::new(&model.state_at_separation(separation)?, size)))
        })
    })
}

/// The constants of a model.
///
/// @param model    must not be NULL
/// @param summary  receives the constants; must not be NULL; its `struct_size` must be set; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`)
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_summary_of(
    model: *const asperity_model,
    summary: *mut asperity_summary,
) -> asperity_status {
    boundary::status(|| {
        let model = &reference(model, "model")?.model;
        fill(summary, "summary", |size| Ok(asperity_summary::new(&model.summary(), size)))
    })
}
