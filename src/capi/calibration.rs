//! The strength of an interface from one measured point, as C asks for it.

use super::boundary::{self, Failure};
use super::params::asperity_params;
use super::reserve;
use super::setters::change;
use super::status::asperity_status;

impl asperity_params {
    /// Scales both slip stresses to a measured friction force.
    ///
    /// # Safety
    /// As that of `to_params`.
    pub(super) unsafe fn calibrate(&mut self, load: f64, friction_force: f64) -> Result<(), Failure> {
        let mut params = self.to_params()?;
        reserve::held(|| Ok(params.calibrate(load, friction_force)?))?;
        (self.slip_stress_1, self.slip_stress_2) = (params.slip.stress_1, params.slip.stress_2);
        Ok(())
    }
}

/// Sets the strength of the interface from one measured point: scales `slip_stress_1` and `slip_stress_2` by one factor, so
/// that the friction force at this load is the measured one.
///
/// The model does not predict the shear strength of an interface: films and oxides govern it. Measure the friction of your
/// pair once, on surfaces and at a load that you know. Set the parameters of these surfaces, and call this function last. The
/// model then predicts how friction changes with load, area, roughness and adhesion. `pressure_coefficient` stays as it is.
/// The call makes one model and one exact state: milliseconds.
///
/// With a coefficient measured at 1 mN, in SI units:
///
/// ```c
/// double load = 1e-3, measured_coefficient = 0.4;
/// asperity_params_calibrate(&params, load, measured_coefficient * load);
/// ```
///
/// @param params          all parameters of the surfaces that were measured; must not be NULL; untouched on failure
/// @param load            normal load of the measurement [force], a total over `asperity_count`
/// @param friction_force  friction force measured at that load [force], > 0: the friction coefficient times the load
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (a force that no strength gives: the message
///         has the numbers; a parameter that `asperity_create` refuses), `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`,
///         `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`, `ASPERITY_OUT_OF_MEMORY`
///
/// Threads: any, on different structs.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_calibrate(
    params: *mut asperity_params,
    load: f64,
    friction_force: f64,
) -> asperity_status {
    boundary::status(|| change(params, |params| params.calibrate(load, friction_force)))
}
