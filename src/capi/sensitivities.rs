//! Sensitivities of the friction force, as C sees them.

use super::boundary;
use super::model::{self, asperity_model};
use super::output::{fill, same_fields};
use super::status::asperity_status;

/// Logarithmic derivatives of the friction force F with respect to each parameter p, at constant load.
///
/// Each is d(ln F)/d(ln p): the percentage by which F changes for each percent of p, with the other parameters held. For
/// `radius_amplitude`, `skew` and `pressure_coefficient`, which may be 0, it is d(ln F)/dp. It is 0 for a parameter that the
/// model does not read. A friction coefficient has the same sensitivities, since the load is constant. All are numbers
/// without a unit.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_sensitivities {
    /// Set it to `sizeof(asperity_sensitivities)` before the call; the library writes no more than that.
    pub struct_size: u64,
    /// With respect to E*.
    pub composite_modulus: f64,
    /// With respect to G*: the share of F that does not come from `pressure_coefficient`, 1 where that is 0.
    pub effective_shear_modulus: f64,
    /// With respect to w; 0 where w is 0.
    pub work_of_adhesion: f64,
    /// With respect to h; 0 where w is 0.
    pub adhesion_range: f64,
    /// With respect to b; the slip radii grow with it.
    pub burgers_vector: f64,
    /// With respect to sigma.
    pub height_std: f64,
    /// With respect to R.
    pub summit_radius: f64,
    /// With respect to N.
    pub asperity_count: f64,
    /// With respect to omega; 0 unless heights are Weibull's.
    pub weibull_shape: f64,
    /// With respect to epsilon, d(ln F)/d(epsilon), also where epsilon is 0; at -1 and 1 the limit from within. 0 where
    /// epsilon must be 0, since `radius_rate` is not between 1e-6 and 1000.
    pub radius_amplitude: f64,
    /// With respect to rho; 0 where epsilon is 0.
    pub radius_rate: f64,
    /// With respect to a_1/b.
    pub slip_radius_1: f64,
    /// With respect to tau_1/G*.
    pub slip_stress_1: f64,
    /// With respect to a_2/b.
    pub slip_radius_2: f64,
    /// With respect to tau_2/G*.
    pub slip_stress_2: f64,
    /// With respect to the skew at this kurtosis, d(ln F)/d(skew); 0 unless heights are Johnson's.
    pub skew: f64,
    /// With respect to the kurtosis at this skew; 0 unless heights are Johnson's.
    pub kurtosis: f64,
    /// With respect to H; 0 where contacts are elastic.
    pub hardness: f64,
    /// With respect to kappa, d(ln F)/d(kappa), also where kappa is 0.
    pub pressure_coefficient: f64,
}

/// Computes the sensitivities of the friction force at a load: which parameter is worth measuring.
///
/// The library integrates over the summits, without the table. That takes longer than an exact state, but far less than
/// making a model. Next to the pull-off load sensitivities grow without limit, as dF/dP does. They do not exist at the
/// pull-off load itself and, without adhesion, at zero load.
///
/// ```c
/// asperity_sensitivities found;
/// found.struct_size = sizeof found;
/// if (asperity_sensitivities_at_load(model, 1e-3, &found) == ASPERITY_OK) {
///     printf("1 %% more of w changes friction by %g %%\n", found.work_of_adhesion);
/// }
/// ```
///
/// @param model          a model
/// @param load           normal load [force], above the pull-off load
/// @param sensitivities  receives them
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE` (too heavy, or none at this load),
///         `ASPERITY_NOT_CONVERGED`, `ASPERITY_OUT_OF_MEMORY`
#[no_mangle]
pub unsafe extern "C" fn asperity_sensitivities_at_load(
    model: *const asperity_model,
    load: f64,
    sensitivities: *mut asperity_sensitivities,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        fill(sensitivities, "sensitivities", || {
            let found = model::exact(model, |model| model.sensitivities_at_load(load))?;
            Ok(same_fields! { asperity_sensitivities of found;
                composite_modulus effective_shear_modulus work_of_adhesion adhesion_range burgers_vector height_std
                summit_radius asperity_count weibull_shape radius_amplitude radius_rate slip_radius_1 slip_stress_1
                slip_radius_2 slip_stress_2 skew kurtosis hardness pressure_coefficient
            })
        })
    })
}
