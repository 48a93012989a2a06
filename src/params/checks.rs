//! What parameters may be together, and the groups, heights and radii that they amount to.

use super::numbers::{magnitude, not_negative, positive, POSITIVE};
use super::{is_unset, unit_slips, ContactLawKind, Params, LEAST_BANDWIDTH, RADIUS_RATES};
use crate::asperity::groups::Groups;
use crate::asperity::slip::SlipConstants;
use crate::distribution::{self, HeightDistribution};
use crate::error::Error;
use crate::numerics::float_bits::{finite, infinite, nan};
use crate::population::radius::RadiusProfile;
use std::sync::Arc;

/// No surface is steeper on average; it is the slope in another unit.
pub const STEEPEST_SURFACE: f64 = 5.0;
/// Means of summits are no higher, in height_std: gaps between mean planes would have few digits.
const HIGHEST_SUMMITS: f64 = 1e4;

const NO_STRESS: &str =
    "must be finite and > 0; both slip stresses may be 0 where pressure_coefficient is > 0 (Amontons' law)";

/// Larger ones are another quantity; friction forces stay in range.
pub const LARGEST_PRESSURE_COEFFICIENT: f64 = 1e3;

impl Params {
    /// The groups of eqs (7) and (8), heights and radii; every number is checked on the way.
    ///
    /// # Errors
    /// [`Error::Unset`], [`Error::InvalidParameter`] or [`Error::OutOfRange`], naming the first parameter that is refused.
    pub(crate) fn surface(&self) -> Result<(Groups, Arc<dyn HeightDistribution>, RadiusProfile), Error> {
        if let Some(name) = self.unset() {
            return Err(Error::Unset { name });
        }
        let (heights, radius) = self.check_each()?;
        if self.summit_mean_height > HIGHEST_SUMMITS * self.height_std {
            let allowed = "must be at most 1e4 height_std; are both in one unit?";
            return Err(Error::invalid("summit_mean_height", self.summit_mean_height, allowed));
        }
        self.check_slip_grows()?;
        self.check_contact_law()?;
        unit_slips::check(self)?;
        self.waviness.check_on(self)?;
        let groups = self.groups();
        check_groups(&groups)?;
        Ok((groups, heights, radius))
    }

    /// What [`Self::surface`] refuses; while some inputs are unset each number by itself, and the groups of those that are set.
    ///
    /// # Errors
    /// Those of [`Self::surface`], but for [`Error::Unset`].
    pub(crate) fn check(&self) -> Result<(), Error> {
        if self.unset().is_none() {
            return self.surface().map(drop);
        }
        self.check_each()?;
        check_groups(&self.groups())
    }

    /// Each number by itself, whichever are set: the heights and radii.
    fn check_each(&self) -> Result<(Arc<dyn HeightDistribution>, RadiusProfile), Error> {
        positive("length_unit", self.length_unit)?;
        positive("force_unit", self.force_unit)?;
        for (name, value) in self.clone().physical().into_iter().filter(|(_, value)| !is_unset(**value)) {
            match name {
                "work_of_adhesion" => not_negative(name, *value, "must be finite and >= 0")?,
                _ => positive(name, *value)?,
            }
        }
        let heights = distribution::heights(&self.heights)?;
        let radius = self.checked_radius(&heights)?;
        self.check_slip()?;
        if !infinite(self.max_friction_coefficient) {
            magnitude(
                "max_friction_coefficient",
                self.max_friction_coefficient,
                "must be > 0; use INFINITY for no upper bound",
            )?;
        }
        not_negative("hardness", self.hardness, "must be finite and >= 0; 0 means not known")?;
        let default_modulus = "must be finite and >= 0; 0 stands for E* G* / (2 (E* + G*))";
        not_negative("tangential_modulus", self.tangential_modulus, default_modulus)?;
        not_negative("nominal_area", self.nominal_area, "must be finite and >= 0; 0 means not known")?;
        not_negative("summit_mean_height", self.summit_mean_height, "must be finite and >= 0; 0 means not known")?;
        check_rms_slope(self.rms_slope)?;
        let no_bandwidth = "must be at least 1.5, the least of isotropic surfaces; 0 means not known";
        not_negative("bandwidth", self.bandwidth, no_bandwidth)?;
        if self.bandwidth != 0.0 && self.bandwidth < LEAST_BANDWIDTH {
            return Err(Error::invalid("bandwidth", self.bandwidth, no_bandwidth));
        }
        self.check_calibration()?;
        self.waviness.check()?;
        Ok((heights, radius))
    }

    fn groups(&self) -> Groups {
        Groups {
            alpha: (self.height_std / self.summit_radius).sqrt(),
            beta: (self.height_std * self.summit_radius).sqrt() / self.burgers_vector,
            gamma: self.work_of_adhesion / (self.composite_modulus * self.burgers_vector),
            b_over_h: self.burgers_vector / self.adhesion_range,
            hardness: if self.hardness > 0.0 { self.hardness / self.composite_modulus } else { f64::INFINITY },
            yields: self.contact_law == ContactLawKind::ElasticPlastic,
            nominal_area: self.nominal_area / (self.burgers_vector * self.burgers_vector) / self.asperity_count,
        }
    }

    fn checked_radius(&self, heights: &Arc<dyn HeightDistribution>) -> Result<RadiusProfile, Error> {
        let (amplitude, rate) = (self.radius_amplitude, self.radius_rate);
        if nan(amplitude) || !(-1.0..=1.0).contains(&amplitude) {
            return Err(Error::invalid("radius_amplitude", amplitude, "must be between -1 and 1"));
        }
        if !finite(rate) || rate <= 0.0 {
            return Err(Error::invalid("radius_rate", rate, POSITIVE));
        }
        if amplitude != 0.0 && !RADIUS_RATES.contains(&rate) {
            let allowed = "must be between 1e-6 and 1000 where radius_amplitude is not 0";
            return Err(Error::out_of_range("radius_rate", rate, allowed));
        }
        Ok(RadiusProfile { amplitude, rate, origin: heights.outline().origin, scores: heights.clone().at_scores() })
    }

    /// What is remembered of a measurement.
    fn check_calibration(&self) -> Result<(), Error> {
        if !finite(self.calibration_load) {
            return Err(Error::invalid("calibration_load", self.calibration_load, "must be finite"));
        }
        let not_calibrated = "must be finite and >= 0; 0 means not calibrated";
        not_negative("calibration_friction_force", self.calibration_friction_force, not_calibrated)?;
        magnitude("calibration_error", self.calibration_error, POSITIVE)?;
        if self.calibration_error > 1.0 {
            let allowed = "must be at most 1: it is a fraction of the measured value; is it in per cent?";
            return Err(Error::out_of_range("calibration_error", self.calibration_error, allowed));
        }
        Ok(())
    }

    /// What summits that yield need.
    fn check_contact_law(&self) -> Result<(), Error> {
        let yields = self.contact_law == ContactLawKind::ElasticPlastic;
        if yields && self.hardness == 0.0 {
            let allowed = "must be > 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1): give the \
                           hardness of the softer body";
            return Err(Error::invalid("hardness", self.hardness, allowed));
        }
        if yields && self.work_of_adhesion != 0.0 {
            let allowed =
                "must be 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1): adhesion of asperities \
                           that yield is not modelled; set it to 0, or contact_law to ASPERITY_CONTACT_MAUGIS (0)";
            return Err(Error::invalid("work_of_adhesion", self.work_of_adhesion, allowed));
        }
        Ok(())
    }

    fn check_slip(&self) -> Result<(), Error> {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.slip;
        let kappa = self.pressure_coefficient;
        not_negative(
            "pressure_coefficient",
            kappa,
            "must be finite and >= 0; 0 means that the strength does not grow with pressure",
        )?;
        if kappa > LARGEST_PRESSURE_COEFFICIENT {
            let allowed = "must be at most 1000: it is a number without unit, about 0.01 to 1";
            return Err(Error::out_of_range("pressure_coefficient", kappa, allowed));
        }
        for (name, radius) in [("slip_radius_1", radius_1), ("slip_radius_2", radius_2)] {
            positive(name, radius)?;
            if radius < 1.0 {
                return Err(Error::invalid(
                    name,
                    radius,
                    "must be at least 1; is it a length? It is a ratio to burgers_vector",
                ));
            }
        }
        for (name, stress) in [("slip_stress_1", stress_1), ("slip_stress_2", stress_2)] {
            not_negative(name, stress, NO_STRESS)?;
            if stress > 1.0 {
                let allowed = "must be at most 1: it is a fraction of effective_shear_modulus; is it in Pa?";
                return Err(Error::out_of_range(name, stress, allowed));
            }
        }
        Ok(())
    }

    /// Slip constants together.
    fn check_slip_grows(&self) -> Result<(), Error> {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.slip;
        if !(stress_1 == 0.0 && stress_2 == 0.0 && self.pressure_coefficient > 0.0) {
            magnitude("slip_stress_1", stress_1, NO_STRESS)?;
            magnitude("slip_stress_2", stress_2, NO_STRESS)?;
        }
        // A relative distance, so that the exponent of the power law between the radii stays finite.
        if radius_2 <= radius_1 * (1.0 + 1e-9) {
            return Err(Error::invalid("slip_radius_2", radius_2, "must be greater than slip_radius_1"));
        }
        if stress_2 * radius_2 * radius_2 < stress_1 * radius_1 * radius_1 * (1.0 - 1e-12) {
            let allowed = "must be at least slip_stress_1 (slip_radius_1/slip_radius_2)^2, so that the friction force \
                           of an asperity does not fall as its contact grows";
            return Err(Error::invalid("slip_stress_2", stress_2, allowed));
        }
        Ok(())
    }
}

/// A slope of a surface, or 0.
///
/// # Errors
/// [`Error::InvalidParameter`] or [`Error::OutOfRange`].
pub(super) fn check_rms_slope(slope: f64) -> Result<(), Error> {
    not_negative("rms_slope", slope, "must be finite and >= 0; 0 means not known")?;
    if slope > STEEPEST_SURFACE {
        let allowed = "must be at most 5, a slope of 79 degrees; is it in degrees or per cent? A slope is the tangent of its angle";
        return Err(Error::out_of_range("rms_slope", slope, allowed));
    }
    Ok(())
}

/// The limits of the groups that are of numbers that are set, with the slip of units that most likely leads beyond each.
fn check_groups(groups: &Groups) -> Result<(), Error> {
    macro_rules! within {
        ($($name:literal $(where $condition:expr)?, $value:expr, $limits:expr, $allowed:literal,
           below $below:literal, above $above:literal;)*) => {$(
            if !nan($value) && !$limits.contains(&$value) $(&& $condition)? {
                let above = $value > *$limits.end();
                let allowed = if above { concat!($allowed, $above) } else { concat!($allowed, $below) };
                return Err(Error::out_of_range($name, $value, allowed));
            }
        )*};
    }
    let adheres = groups.gamma != 0.0;
    within! {
        "alpha", groups.alpha, 1e-5..=10.0, "(height_std/summit_radius)^(1/2) must be between 1e-5 and 10; ",
            below "is summit_radius in um?", above "is height_std in um or nm?";
        "beta", groups.beta, 0.1..=1e8, "(height_std summit_radius)^(1/2)/burgers_vector must be between 0.1 and 1e8; ",
            below "is burgers_vector in nm? For a smooth tip, take a height_std of 0.01 adhesion_range",
            above "are height_std and summit_radius in um?";
        "gamma" where adheres, groups.gamma, 1e-9..=10.0,
            "work_of_adhesion/(composite_modulus burgers_vector) must be 0 or between 1e-9 and 10; ",
            below "are work_of_adhesion and the moduli in one system of units?",
            above "is work_of_adhesion in mJ/m^2, or in J/m^2 with lengths in mm, or are the moduli in MPa or GPa? An elastomer has no Burgers \
                vector: set slip_stress_1 = slip_stress_2, and burgers_vector to a length above \
                work_of_adhesion/(10 composite_modulus); the answers then do not depend on it";
        "h/sigma" where adheres, groups.reach(), 0.0..=1e6, "adhesion_range/height_std must be at most 1e6; ",
            below "", above "is adhesion_range in nm? Otherwise take a larger height_std, or no adhesion";
        "b/h", groups.b_over_h, 1e-3..=100.0, "burgers_vector/adhesion_range must be between 1e-3 and 100; ",
            below "is adhesion_range in nm?", above "is burgers_vector in nm?";
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a change of the default case is refused for, if it is: whether it has a meaning, and the name in the message.
    fn refused(change: impl FnOnce(&mut Params)) -> Option<(bool, &'static str)> {
        let mut params = Params::paper();
        change(&mut params);
        params.surface().err().map(|error| match error {
            Error::InvalidParameter { name, .. } | Error::Unset { name } => (false, name),
            Error::OutOfRange { name, .. } => (true, name),
            other => panic!("{other:?}"),
        })
    }

    #[test]
    fn groups_are_taken_up_to_the_limits_and_no_further() {
        fn roughness(params: &mut Params, alpha: f64, beta: f64) {
            (params.height_std, params.summit_radius) = (alpha * beta, beta / alpha);
        }
        type Change = fn(&mut Params, f64);
        let groups: [(_, [f64; 2], Change); 5] = [
            ("alpha", [1e-5, 10.0], |params, alpha| roughness(params, alpha, 1e3)),
            ("beta", [0.1, 1e8], |params, beta| roughness(params, 0.01, beta)),
            ("gamma", [1e-9, 10.0], |params, gamma| params.work_of_adhesion = gamma * params.composite_modulus),
            ("b/h", [1e-3, 100.0], |params, b_over_h| params.adhesion_range = 1.0 / b_over_h),
            ("h/sigma", [0.0, 1e6], |params, reach| {
                params.adhesion_range = 100.0;
                roughness(params, 1e-4, 1e6 / reach); // alpha beta is sigma/b
            }),
        ];
        for (name, limits, set) in groups {
            for (limit, outwards) in limits.into_iter().zip([-1.0, 1.0]).filter(|&(limit, _)| limit > 0.0) {
                let at = |off: f64| refused(|params| set(params, limit * (1.0 + off * outwards)));
                assert_eq!(at(-1e-12), None, "{name} = {limit}");
                assert_eq!(at(1e-12), Some((true, name)), "{name} = {limit}");
            }
        }
        // Without adhesion its range does not matter.
        let far = |params: &mut Params, work: f64| {
            roughness(params, 1e-5, 1.0);
            (params.work_of_adhesion, params.adhesion_range) = (work, 100.0);
        };
        assert_eq!(refused(|params| far(params, 0.0)), None);
        assert_eq!(refused(|params| far(params, 1e-3)), Some((true, "h/sigma")));
    }

    /// Both together, and only where something else resists: Amontons' law.
    #[test]
    fn slip_stresses_may_be_0_where_there_is_a_pressure_coefficient() {
        let with = |stress_1: f64, stress_2: f64, pressure_coefficient: f64| {
            refused(|params| {
                params.slip = SlipConstants { stress_1, stress_2, ..params.slip };
                params.pressure_coefficient = pressure_coefficient;
            })
        };
        assert_eq!(with(0.0, 0.0, 0.1), None);
        assert_eq!(with(-0.0, 0.0, 0.1), None);
        assert_eq!(with(0.0, 0.0, 0.0), Some((false, "slip_stress_1")));
        assert_eq!(with(0.0, 0.1, 0.1), Some((false, "slip_stress_1")));
        assert_eq!(with(1e-4, 0.0, 0.1), Some((false, "slip_stress_2")));
        assert_eq!(with(6.5e7, 6.5e7, 0.1), Some((true, "slip_stress_1")));
    }

    #[test]
    fn slip_constants_are_taken_where_force_grows_with_radius() {
        let with = |radius_2: f64, stress_2: f64| {
            let slip = SlipConstants { radius_1: 3.0, stress_1: 0.02, radius_2, stress_2 };
            refused(|params| params.slip = slip)
        };
        // A force that does not grow between the two radii.
        let least = |radius_2: f64| 0.02 * 3.0 * 3.0 / (radius_2 * radius_2);
        for radius in [3.0 * (1.0 + 2e-9), 5.0, 1e3] {
            assert_eq!(with(radius, least(radius)), None, "{radius}");
            assert_eq!(with(radius, 1.0), None, "{radius}");
            assert_eq!(with(radius, least(radius) * (1.0 - 1e-10)), Some((false, "slip_stress_2")), "{radius}");
        }
        for radius in [3.0 * (1.0 + 1e-10), 3.0, 2.0] {
            assert_eq!(with(radius, 1.0), Some((false, "slip_radius_2")), "{radius}");
        }
    }
}
