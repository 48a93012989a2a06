//! Exact states and the summary, as C sees them.

use super::boundary;
use super::model::{self, asperity_model};
use super::output::{fill, same_fields};
use super::status::asperity_status;
use crate::error::Error;
use crate::model::{Model, State};

/// The exact state of a contact, in the units of the parameters.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_state {
    /// Set it to `sizeof(asperity_state)`; no more is written.
    pub struct_size: u64,
    /// Normal load P [force]; negative pulls.
    pub load: f64,
    /// Gap between the mean planes of the surfaces [length], as for `asperity_load_and_slope_at_gap`.
    pub gap: f64,
    /// Friction force F [force], >= 0.
    pub friction_force: f64,
    /// Friction coefficient F/P [-], at most `max_friction_coefficient`, as `asperity_friction_at_load` returns it.
    pub friction_coefficient: f64,
    /// dF/dP [-]; INFINITY at the pull-off load itself.
    pub dforce_dload: f64,
    /// d(F/P)/dP [1/force]; 0 where the coefficient is capped.
    pub dmu_dload: f64,
    /// d(load)/d(gap) [force/length]: minus the normal contact stiffness.
    pub dload_dgap: f64,
    /// Real area of contact [length^2].
    pub real_area: f64,
    /// Number of asperities in contact [-]; need not be an integer.
    pub contacting: f64,
    /// Number of asperities that attract without contact [-].
    pub attracted: f64,
    /// Load of the asperities that attract without contact [force], <= 0.
    pub attraction_load: f64,
    /// Mean radius of the contacts [length]; 0 if nothing touches. The same holds for the fields below, except `plasticity_index`.
    pub mean_contact_radius: f64,
    /// Expected radius of the largest of n = `contacting` contacts [length]: the largest radius up to the height that
    /// 1/(n + 1) of the contacts exceed. Equal to the mean radius for n <= 1.
    pub max_contact_radius: f64,
    /// Fraction of the contacts with radii up to `slip_radius_1` [-].
    pub fraction_below_slip_radius_1: f64,
    /// Fraction of the contacts with radii between `slip_radius_1` and `slip_radius_2` [-].
    pub fraction_between_slip_radii: f64,
    /// Fraction of the contacts with radii of at least `slip_radius_2` [-].
    pub fraction_above_slip_radius_2: f64,
    /// Fraction of all asperities that are in contact [-].
    pub fraction_in_contact: f64,
    /// Load of the asperities in contact over their real area [stress]; negative where adhesion pulls more than they push.
    pub mean_asperity_pressure: f64,
    /// Greenwood and Williamson's plasticity index, E* (sigma/R)^(1/2)/H [-]; 0 if the hardness H is not given.
    pub plasticity_index: f64,
    /// Bits `ASPERITY_WARNING_...`: assumptions of the model that fail in this state; 0 if none is known to fail.
    /// `asperity_warnings_text` says what to do.
    pub warnings: u64,
    /// K_t [force/length]: tangential force by displacement while all contacts stick.
    pub tangential_stiffness: f64,
    /// Fraction of the contacts below first yield [-]; 1 without a hardness.
    pub fraction_elastic: f64,
    /// Fraction of the contacts that are fully plastic [-].
    pub fraction_flowing: f64,
    /// Sum of the radii of all contacts over chi (see `nominal_area`) [length]. The constriction conductance, thermal or
    /// electrical, is 2 k times it, with 1/k = (1/k1 + 1/k2)/2 of the conductivities of both bodies.
    pub contact_radius_sum: f64,
    /// Sum of the loads of Hertz' contacts of the same radii [force]: the load and what adhesion adds to it.
    pub hertz_load: f64,
    /// -d(load)/d(gap) when the load begins to fall [force/length]. Asperities that yielded spring back elastically, so that it exceeds
    /// -`dload_dgap`; elastic contacts have one stiffness.
    pub unloading_stiffness: f64,
}

/// Constants of a model, in the units of the parameters.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_summary {
    /// Set it to `sizeof(asperity_summary)`; no more is written.
    pub struct_size: u64,
    /// Surface roughness parameter (sigma/R)^(1/2) [-].
    pub alpha: f64,
    /// Friction regime parameter (R sigma)^(1/2)/b [-].
    pub beta: f64,
    /// Surface energy parameter w/(E* b) [-].
    pub gamma: f64,
    /// Maugis' adhesion parameter [-]: small values are the DMT limit, large ones the JKR limit.
    pub lambda: f64,
    /// Skew of the asperity heights [-].
    pub skew: f64,
    /// Kurtosis of the asperity heights [-]; 3 for Gaussian.
    pub kurtosis: f64,
    /// Pull-off load [force], <= 0: the smallest load at which the surfaces hold together. It is that of the mean over
    /// many asperities, far below that of one rough specimen: `asperity_specimens_at_loads`.
    pub pull_off_load: f64,
    /// Friction force at the pull-off load [force].
    pub pull_off_friction_force: f64,
    /// Friction force at zero load [force]. For a surface that hardly adheres, where `min_table_load` is above zero, it is a
    /// continuation of the law.
    pub zero_load_friction_force: f64,
    /// 8 G^ [stress]: K_t over the sum of the contact radii over chi (see `nominal_area`). The thermal or
    /// electrical conductance is 2 k K_t/stiffness_per_radius.
    pub stiffness_per_radius: f64,
    /// Lightest load of the compiled table [force]. Below it the law continues with its slope.
    pub min_table_load: f64,
    /// Heaviest load of the compiled table [force]. Above it friction continues with its slope: up to 11 % below exact
    /// states at ten times the load.
    pub max_table_load: f64,
    /// Largest relative error of the compiled friction force [-] at the samples that were compared when the model was
    /// made, times what errors between samples are larger by.
    pub table_error: f64,
    /// Largest load that the surfaces have borne [force]: of `asperity_unloaded`; 0 of a model of first loading.
    pub largest_load: f64,
}

/// An exact state for the caller.
///
/// # Safety
/// As every entry point's.
unsafe fn exact(
    model: *const asperity_model,
    out: *mut asperity_state,
    state: &dyn Fn(&Model) -> Result<State, Error>,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        fill(out, "state", || {
            let state = state(model)?;
            Ok(same_fields! { asperity_state of state;
                load gap friction_force friction_coefficient dforce_dload dmu_dload dload_dgap real_area
                contacting attracted attraction_load mean_contact_radius max_contact_radius fraction_below_slip_radius_1
                fraction_between_slip_radii fraction_above_slip_radius_2 fraction_in_contact mean_asperity_pressure
                plasticity_index warnings tangential_stiffness fraction_elastic fraction_flowing contact_radius_sum
                hertz_load unloading_stiffness
            })
        })
    })
}

/// Computes the exact state at a load, by integration over the asperities, without the table.
///
/// @param load   normal load [force], from the pull-off load upwards
/// @param state  receives the state
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`
#[no_mangle]
pub unsafe extern "C" fn asperity_state_at_load(
    model: *const asperity_model,
    load: f64,
    state: *mut asperity_state,
) -> asperity_status {
    exact(model, state, &|model| model.state_at_load(load))
}

/// Computes the exact state at a gap, also beyond the pull-off point, where no load holds the surfaces in equilibrium.
///
/// @param gap    as for `asperity_load_and_slope_at_gap` [length]; may be negative
/// @param state  receives the state
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`, or a gap that is not
///         finite), `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_state_at_gap(
    model: *const asperity_model,
    gap: f64,
    state: *mut asperity_state,
) -> asperity_status {
    exact(model, state, &|model| model.state_at_gap(gap))
}

/// Fills the constants of a model: dimensionless groups, pull-off, extent and error of the table.
///
/// @param summary  receives the constants
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_summary_of(
    model: *const asperity_model,
    summary: *mut asperity_summary,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        fill(summary, "summary", || {
            Ok(same_fields! { asperity_summary of model.summary();
                alpha beta gamma lambda skew kurtosis pull_off_load pull_off_friction_force zero_load_friction_force
                stiffness_per_radius min_table_load max_table_load table_error largest_load
            })
        })
    })
}
