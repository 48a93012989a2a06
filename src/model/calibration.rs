//! The strength of an interface from measured friction forces.
//!
//! The friction force is linear in the slip stresses: with both times c it is c F0(P) + kappa P_H(P), F0 that of the stresses
//! as they are. A measured force F at the load P gives c = (F - kappa P_H)/F0. All else, how F changes with load, area, roughness
//! and adhesion, is the model's.

use super::Surfaces;
use crate::error::{CalibrationFailure as Reason, Error};
use crate::numerics::float_bits::finite;
use crate::params::{Params, LARGEST_QUANTITY};
use std::ops::RangeInclusive;

/// Above it surfaces have seized, or a force was given.
const SEIZED_COEFFICIENT: f64 = 20.0;
/// What most coefficients lie between: of a load within beside a coefficient without, the two are swapped.
const USUAL: RangeInclusive<f64> = 1e-3..=10.0;
/// A lighter load looks like a coefficient.
const LARGEST_USUAL_LOAD: f64 = 2.0;
/// Strengths so close to the measured one are it.
const SAME_STRENGTH: f64 = 1e-12;

/// A friction force measured at a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredPoint {
    /// [force]
    pub load: f64,
    /// [force]
    pub force: f64,
    /// Relative standard error.
    pub error: f64,
}

impl Params {
    /// Scales both slip stresses so that the friction coefficient at a load is the one measured there, and keeps the measurement.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a load that does not press, a coefficient that is not above 0 and at most 20, or one below
    /// 0.001 or above 10 with a load that looks like a coefficient; those of
    /// [`Params::calibrate_force`]. The parameters are then as before.
    pub fn calibrate(&mut self, load: f64, friction_coefficient: f64) -> Result<(), Error> {
        self.calibrate_force(load, Self::measured_force(load, friction_coefficient)?)
    }

    /// The force of a measured coefficient.
    pub(crate) fn measured_force(load: f64, friction_coefficient: f64) -> Result<f64, Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: "calibration_load", value: load });
        }
        if load <= 0.0 {
            let allowed = "must be > 0; at zero load, or where the load pulls, calibrate with the friction force";
            return Err(Error::invalid("calibration_load", load, allowed));
        }
        if !finite(friction_coefficient) || friction_coefficient <= 0.0 || friction_coefficient > SEIZED_COEFFICIENT {
            let allowed =
                "must be > 0 and at most 20; is it a force? Calibrate with the friction force then; or is it in per cent? Or is \
                 it the load, which comes first?";
            return Err(Error::invalid("calibration_friction_coefficient", friction_coefficient, allowed));
        }
        if !USUAL.contains(&friction_coefficient) && (*USUAL.start()..=LARGEST_USUAL_LOAD).contains(&load) {
            let allowed =
                "most are between 0.001 and 10, as the load is here: are the two swapped? The load comes first; \
                           where they are not, calibrate with the friction force";
            return Err(Error::invalid("calibration_friction_coefficient", friction_coefficient, allowed));
        }
        Ok(friction_coefficient * load)
    }

    /// Scales both slip stresses so that the friction force at a load is the one measured there, and keeps the measurement: for
    /// loads that are 0 or pull.
    ///
    /// # Errors
    /// [`Error::Uncalibrated`], with the numbers, for a force that no stresses give: not positive, not above what the pressure
    /// coefficient gives alone, or so large that a stress exceeds G*; and those of [`Model::new`] and
    /// [`Model::state_at_load`]. The parameters are then as before.
    pub fn calibrate_force(&mut self, load: f64, friction_force: f64) -> Result<(), Error> {
        self.check_measured(load, friction_force)?;
        let surfaces = Surfaces::new(&Self { pressure_coefficient: 0.0, ..self.clone() })?;
        self.strengthen(&surfaces, load, friction_force)
    }

    /// Refuses what can be no measurement of these parameters.
    pub(crate) fn check_measured(&self, load: f64, friction_force: f64) -> Result<(), Error> {
        let refused = |reason| Err(Error::Uncalibrated { load, friction_force, reason, number: 0.0 });
        if !finite(friction_force) || friction_force <= 0.0 {
            return refused(Reason::NotPositive);
        }
        if self.slip.stress_1 == 0.0 && self.slip.stress_2 == 0.0 {
            return refused(Reason::NoStress);
        }
        Ok(())
    }

    /// The same with surfaces that have all of these parameters but the pressure coefficient.
    pub(crate) fn strengthen(&mut self, surfaces: &Surfaces, load: f64, friction_force: f64) -> Result<(), Error> {
        let borne = surfaces.borne_at_load(load)?;
        let refused = |reason, number| Err(Error::Uncalibrated { load, friction_force, reason, number });
        let of_pressure = self.pressure_coefficient * borne.hertz_load;
        if friction_force <= of_pressure {
            return refused(Reason::Pressure, of_pressure);
        }
        // Where the load hardly presses, the force may be too small for a number.
        if borne.friction_force < f64::MIN_POSITIVE {
            return refused(Reason::NoFriction, borne.friction_force);
        }
        let factor = (friction_force - of_pressure) / borne.friction_force;
        let most = 1.0 / self.slip.stress_1.max(self.slip.stress_2);
        let least = 1.0 / (LARGEST_QUANTITY * self.slip.stress_1.min(self.slip.stress_2));
        if factor > most {
            return refused(Reason::Strength, most * borne.friction_force + of_pressure);
        }
        if factor < least {
            return refused(Reason::Weakness, least * borne.friction_force + of_pressure);
        }
        if (factor - 1.0).abs() > SAME_STRENGTH {
            self.slip.stress_1 *= factor;
            self.slip.stress_2 *= factor;
        }
        self.calibration_error = self.error_of_point();
        (self.calibration_load, self.calibration_friction_force) = (load, friction_force);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_that_is_no_number_has_no_strength() {
        let mut params = Params { work_of_adhesion: 0.0, ..Params::paper() };
        let refused = params.calibrate_force(5e-324, 1e-300);
        assert!(matches!(refused, Err(Error::Uncalibrated { reason: Reason::NoFriction, .. })), "{refused:?}");
    }

    #[test]
    fn there_is_a_stress_to_scale() {
        let of = |stress_1: f64, stress_2: f64| {
            let slip = crate::asperity::slip::SlipConstants { stress_1, stress_2, ..Default::default() };
            Params { slip, pressure_coefficient: 0.1, ..Params::paper() }.calibrate_force(10.0, 5.0)
        };
        assert!(matches!(of(0.0, 0.0), Err(Error::Uncalibrated { reason: Reason::NoStress, .. })));
        assert!(matches!(of(0.0, 0.02), Err(Error::InvalidParameter { .. })) && of(0.02, 0.02).is_ok());
    }
}
