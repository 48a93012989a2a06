//! Parameters in other units.

use super::{positive, Params};
use crate::error::Error;
use crate::numerics::float_bits::nan;

impl Params {
    /// Converts all quantities into units of which one is so many of the present units of length and of force: from SI into
    /// N, mm and MPa with 1e-3 and 1. What is unset stays so; numbers without a unit and tables of heights stay as they are.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`] of a unit; the parameters are then as before.
    pub fn set_units(&mut self, length: f64, force: f64) -> Result<(), Error> {
        positive("length", length)?;
        positive("force", force)?;
        let area = length * length;
        let stresses = [
            &mut self.composite_modulus,
            &mut self.effective_shear_modulus,
            &mut self.tangential_modulus,
            &mut self.hardness,
        ];
        let lengths = [
            &mut self.adhesion_range,
            &mut self.burgers_vector,
            &mut self.height_std,
            &mut self.summit_radius,
            &mut self.summit_mean_height,
        ];
        let forces = [&mut self.calibration_load, &mut self.calibration_friction_force];
        let all = (stresses.into_iter().map(|stress| (stress, force / area)))
            .chain(lengths.into_iter().map(|length_of| (length_of, length)))
            .chain(forces.into_iter().map(|force_of| (force_of, force)))
            .chain([(&mut self.work_of_adhesion, force / length), (&mut self.nominal_area, area)]);
        for (quantity, unit) in all.filter(|(quantity, _)| !nan(**quantity)) {
            *quantity /= unit;
        }
        Ok(())
    }
}
