//! Parameters in other units.

use super::{Draft, FIELDS};
use crate::error::Error;
use crate::numerics::float_bits::nan;
use crate::params::{positive, Params};

impl Params {
    /// Converts all quantities into units of which one is so many of the present units of length and of force: from SI into
    /// N, mm and MPa with 1e-3 and 1. What is unset stays so; numbers without a unit and tables of heights stay as they are.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`] of a unit, or of parameters that were converted before; the parameters are
    /// then as before.
    pub fn set_units(&mut self, length: f64, force: f64) -> Result<(), Error> {
        positive("length", length)?;
        positive("force", force)?;
        self.check_not_converted()?;
        let mut draft = Draft::of(self);
        for field in FIELDS {
            let unit = match field.unit {
                "length" => length,
                "length^2" => length * length,
                "stress" => force / (length * length),
                "force/length" => force / length,
                _ => continue,
            };
            let number = field.get(&mut draft);
            if !nan(number) {
                field.set(&mut draft, number / unit)?;
            }
        }
        *self = draft.params;
        for number in [&mut self.calibration_load, &mut self.calibration_friction_force] {
            if !nan(*number) {
                *number /= force;
            }
        }
        (self.length_unit, self.force_unit) = (length, force);
        Ok(())
    }

    /// Refuses to mix units: materials and interfaces are known in SI units, and a second conversion would begin from the first.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] of the unit that is not 1.
    pub(crate) fn check_not_converted(&self) -> Result<(), Error> {
        const ALLOWED: &str = "must be 1 for this, which needs SI units: these numbers are in others already; convert once, after all else";
        for (name, unit) in [("length_unit", self.length_unit), ("force_unit", self.force_unit)] {
            if unit.to_bits() != 1.0_f64.to_bits() {
                return Err(Error::invalid(name, unit, ALLOWED));
            }
        }
        Ok(())
    }
}
