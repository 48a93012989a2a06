//! The strength of an interface from one measured point, as C asks for it.

use super::boundary::{self, Failure};
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::error::Error;
use crate::params::Params;

impl asperity_params {
    /// Sets the strength to a measured one.
    ///
    /// # Safety
    /// As that of `to_params`.
    pub(super) unsafe fn calibrate(
        &mut self,
        set: impl FnOnce(&mut Params) -> Result<(), Error>,
    ) -> Result<(), Failure> {
        let mut draft = self.whole_draft()?;
        let mut params = draft.clone().into_params()?;
        set(&mut params)?;
        draft.params = params;
        self.take(draft);
        Ok(())
    }
}

/// Sets the strength of the interface from one measured point: scales `slip_stress_1` and `slip_stress_2` by one factor, so
/// that the friction coefficient at this load is the measured one.
///
/// The model does not predict the shear strength of an interface: films and oxides govern it. Measure the friction of your
/// pair once, on surfaces and at a load that you know. Set the parameters of these surfaces, and call this function last, which
/// takes milliseconds. The model then predicts how friction changes with load, area, roughness and adhesion. The measurement is
/// kept in `calibration_load` and `calibration_friction_force`.
///
/// @param params                all parameters of the surfaces that were measured
/// @param load                  normal load of the measurement [force], > 0, a total over `asperity_count`
/// @param friction_coefficient  measured at that load [-], > 0 and at most 20
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (a coefficient that no strength
///         gives: the message has the numbers; a parameter that `asperity_create` refuses), `ASPERITY_INVALID_LOAD`,
///         `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_calibrate(
    params: *mut asperity_params,
    load: f64,
    friction_coefficient: f64,
) -> asperity_status {
    boundary::status(|| {
        change(params, |params| params.calibrate(|surfaces| surfaces.calibrate(load, friction_coefficient)))
    })
}

/// Sets the strength of the interface from a measured friction force, as `asperity_params_calibrate` does from a coefficient: for
/// measurements at zero load, or where the load pulls.
///
/// @param params          all parameters of the surfaces that were measured
/// @param load            normal load of the measurement [force], a total over `asperity_count`; from the pull-off load upwards
/// @param friction_force  measured at that load [force], > 0
/// @return as `asperity_params_calibrate`, and `ASPERITY_SEPARATED`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_calibrate_force(
    params: *mut asperity_params,
    load: f64,
    friction_force: f64,
) -> asperity_status {
    boundary::status(|| {
        change(params, |params| params.calibrate(|surfaces| surfaces.calibrate_force(load, friction_force)))
    })
}
