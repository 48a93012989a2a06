//! The strength of an interface from one measured friction force.
//!
//! The friction force is linear in the slip stresses: with both times c it is c F0(P) + kappa P_H(P), F0 that of the stresses
//! as they are. A measured force F at the load P gives c = (F - kappa P_H)/F0. All else, how F changes with load, area, roughness
//! and adhesion, is the model's.

use super::Model;
use crate::error::{CalibrationFailure as Reason, Error};
use crate::float_bits::finite;
use crate::params::{Params, LARGEST};

/// Above it surfaces have seized, or a force was given.
const LARGEST_COEFFICIENT: f64 = 20.0;
/// Strengths so close to the measured one are it.
const ROUNDING: f64 = 1e-12;

impl Params {
    /// Scales both slip stresses so that the friction coefficient at a load is the one measured there, and keeps the measurement.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a load that does not press, or a coefficient that is not above 0 and at most 20; those of
    /// [`Params::calibrate_force`]. The parameters are then as before.
    pub fn calibrate(&mut self, load: f64, friction_coefficient: f64) -> Result<(), Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: "calibration_load", value: load });
        }
        if load <= 0.0 {
            let allowed = "must be > 0; at zero load, or where the load pulls, calibrate with the friction force";
            return Err(Error::invalid("calibration_load", load, allowed));
        }
        if !finite(friction_coefficient) || friction_coefficient <= 0.0 || friction_coefficient > LARGEST_COEFFICIENT {
            let allowed = "must be > 0 and at most 20; is it a force? Calibrate with the friction force then";
            return Err(Error::invalid("calibration_friction_coefficient", friction_coefficient, allowed));
        }
        self.calibrate_force(load, friction_coefficient * load)
    }

    /// Scales both slip stresses so that the friction force at a load is the one measured there, and keeps the measurement: for
    /// loads that are 0 or pull.
    ///
    /// # Errors
    /// [`Error::Uncalibrated`], with the numbers, for a force that no stresses give: not positive, not above what the pressure
    /// coefficient gives alone, or so large that a stress exceeds G*; and those of [`Model::new`] and
    /// [`Model::state_at_load`]. The parameters are then as before.
    pub fn calibrate_force(&mut self, load: f64, friction_force: f64) -> Result<(), Error> {
        let refused = |reason: Reason, number: f64| Err(Error::Uncalibrated { load, friction_force, reason, number });
        if !finite(friction_force) || friction_force <= 0.0 {
            return refused(Reason::NotPositive, 0.0);
        }
        if self.slip.stress_1 == 0.0 && self.slip.stress_2 == 0.0 {
            return refused(Reason::NoStress, 0.0);
        }
        let without_pressure = Self { pressure_coefficient: 0.0, ..self.clone() };
        let state = Model::new(&without_pressure)?.state_at_load(load)?;
        let of_pressure = self.pressure_coefficient * state.hertz_load;
        if friction_force <= of_pressure {
            return refused(Reason::Pressure, of_pressure);
        }
        // Of a load that hardly presses the force may be too small for a number.
        if state.friction_force < f64::MIN_POSITIVE {
            return refused(Reason::NoFriction, state.friction_force);
        }
        let factor = (friction_force - of_pressure) / state.friction_force;
        let largest = self.slip.stress_1.max(self.slip.stress_2);
        if factor > 1.0 / largest {
            return refused(Reason::Strength, state.friction_force / largest + of_pressure);
        }
        let least = 1.0 / (LARGEST * self.slip.stress_1.min(self.slip.stress_2));
        if factor < least {
            return refused(Reason::Weakness, state.friction_force * least + of_pressure);
        }
        if (factor - 1.0).abs() > ROUNDING {
            self.slip.stress_1 *= factor;
            self.slip.stress_2 *= factor;
        }
        (self.calibration_load, self.calibration_friction_force) = (load, friction_force);
        Ok(())
    }
}
