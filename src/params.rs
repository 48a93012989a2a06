//! A surface pair in the user's own consistent units, validated, and turned into dimensionless groups.

// Brackets hold units here, not links.
#![allow(rustdoc::broken_intra_doc_links)]

use crate::asperity::slip::SlipConstants;
use crate::distribution::weibull::Weibull;
use crate::distribution::{self, HeightDistribution};
use crate::error::Error;
use crate::float_bits::{finite, infinite, nan};
use crate::groups::Groups;
use crate::joint_distribution::SummitShape;
use crate::population::radius::RadiusProfile;
use crate::spectrum::SpectralMoments;
use crate::unit_slips;
use std::sync::Arc;

/// The family of the distribution of summit heights.
#[derive(Debug, Clone, PartialEq)]
pub enum HeightFamily {
    /// Eq (17).
    Gaussian,
    /// Eqs (18)-(21), with its shape omega.
    Weibull {
        /// omega from 1 to 200; 3.602 has no skew, more is negative skew.
        shape: f64,
    },
    /// Johnson's system: skew and kurtosis chosen independently.
    Johnson {
        /// Third standardised moment, -3 to 3.
        skew: f64,
        /// Fourth standardised moment, 1.87 + 1.25 skew^2 to 100; 3 with skew 0 is Gaussian.
        kurtosis: f64,
    },
    /// A measured density of summit heights, in any unit and of any origin; it need not be normalised.
    Tabulated {
        /// Heights, 3 to 256, increasing by 1e-12 of their range at least.
        height: Arc<[f64]>,
        /// The density at each height, >= 0.
        density: Arc<[f64]>,
    },
}

/// The law of one summit in contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactLawKind {
    /// Elastic, with adhesion after Maugis; without adhesion Hertz' law. Eqs (4)-(10).
    Maugis,
    /// Summits that yield, after Zhao, Maietta and Chang (2000): needs a hardness, and no adhesion.
    ElasticPlastic,
}

/// Two rough elastic surfaces, as the equivalent rough surface against a flat.
///
/// All quantities are in one consistent system of units. Loads, forces and areas are totals over
/// `asperity_count` summits.
#[derive(Debug, Clone, PartialEq)]
pub struct Params {
    /// E* [stress]: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
    pub composite_modulus: f64,
    /// G* = 2 G1 G2/(G1 + G2) [stress].
    pub effective_shear_modulus: f64,
    /// w [force/length]; 0 is Hertzian contact.
    pub work_of_adhesion: f64,
    /// h [length], the range of the adhesive stress w/h.
    pub adhesion_range: f64,
    /// b [length], Burgers vector.
    pub burgers_vector: f64,
    /// sigma [length], standard deviation of summit heights.
    pub height_std: f64,
    /// R [length], mean radius of summit curvature.
    pub summit_radius: f64,
    /// N, summit density times nominal area; need not be whole.
    pub asperity_count: f64,
    /// How summit heights are distributed.
    pub heights: HeightFamily,
    /// Whether summits out of contact attract.
    pub attraction: bool,
    /// epsilon of eq (3), in [-1, 1].
    pub radius_amplitude: f64,
    /// rho of eq (3), > 0; read only where epsilon is not 0.
    pub radius_rate: f64,
    /// Constants of the shear strength, eq (13).
    pub slip: SlipConstants,
    /// Cap on every friction coefficient returned; may be infinite.
    pub max_friction_coefficient: f64,
    /// H [stress], indentation hardness of the softer body, to judge whether contacts are elastic; 0 if not known.
    pub hardness: f64,
    /// G^ [stress]: 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2, for the stiffness of contacts that stick; 0 stands for
    /// E* G* / (2 (E* + G*)), which is exact for two bodies of one material and for one rigid body.
    pub tangential_modulus: f64,
    /// Nominal area of contact [length^2], to judge whether summits crowd; 0 if not known.
    pub nominal_area: f64,
    /// The law of one summit in contact.
    pub contact_law: ContactLawKind,
}

impl Default for Params {
    /// The paper's default case: alpha = 0.01, beta = 1000, gamma = 0.001, nu = 0.3 in units b = G = 1, N = 1.
    fn default() -> Self {
        let mut params = Self {
            composite_modulus: 1.0,
            effective_shear_modulus: 1.0,
            work_of_adhesion: 0.0,
            adhesion_range: 1.0,
            burgers_vector: 1.0,
            height_std: 1.0,
            summit_radius: 1.0,
            asperity_count: 1.0,
            heights: HeightFamily::Gaussian,
            attraction: true,
            radius_amplitude: 0.0,
            radius_rate: 0.5,
            slip: SlipConstants::default(),
            max_friction_coefficient: 1000.0,
            hardness: 0.0,
            tangential_modulus: 0.0,
            nominal_area: 0.0,
            contact_law: ContactLawKind::Maugis,
        };
        params.write_dimensionless(0.01, 1000.0, 0.001, 1.0, 0.3);
        params
    }
}

/// What the physical inputs are until they are set: a quiet NaN that no arithmetic makes.
pub(crate) const UNSET: f64 = f64::from_bits(0x7ff8_0000_756e_7365);

/// The radius_rate of radii that vary with height.
pub(crate) const RADIUS_RATES: std::ops::RangeInclusive<f64> = 1e-6..=1e3;

/// Raw quantities beyond this, or below its inverse, could overflow when combined.
const LARGEST: f64 = 1e40;

const POSITIVE: &str = "must be finite and > 0";
const MAGNITUDE: &str = "must be between 1e-40 and 1e40; choose other units";

impl Params {
    /// The default case without its eight physical inputs, `composite_modulus` to `asperity_count`, which are NaN: a model
    /// is refused until all are set.
    pub fn unset() -> Self {
        let mut params = Self::default();
        for (_, value) in params.physical() {
            *value = UNSET;
        }
        params
    }

    /// The inputs that no default can stand for, in their order.
    fn physical(&mut self) -> [(&'static str, &mut f64); 8] {
        [
            ("composite_modulus", &mut self.composite_modulus),
            ("effective_shear_modulus", &mut self.effective_shear_modulus),
            ("work_of_adhesion", &mut self.work_of_adhesion),
            ("adhesion_range", &mut self.adhesion_range),
            ("burgers_vector", &mut self.burgers_vector),
            ("height_std", &mut self.height_std),
            ("summit_radius", &mut self.summit_radius),
            ("asperity_count", &mut self.asperity_count),
        ]
    }

    /// The paper's dimensionless case: b = 1, G = 1, N = 1, E* = 2/(1 - nu), G* = 2; see eqs (7), (8). The tangential
    /// modulus becomes its default, which is that of this case.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`]; the parameters are then as before.
    pub fn set_dimensionless(
        &mut self,
        alpha: f64,
        beta: f64,
        gamma: f64,
        b_over_h: f64,
        poisson: f64,
    ) -> Result<(), Error> {
        positive("alpha", alpha)?;
        positive("beta", beta)?;
        if gamma.to_bits() << 1 != 0 {
            magnitude("gamma", gamma, "must be finite and >= 0")?;
        }
        positive("b_over_h", b_over_h)?;
        poisson_ratio("poisson", poisson)?;
        self.write_dimensionless(alpha, beta, gamma, b_over_h, poisson);
        Ok(())
    }

    fn write_dimensionless(&mut self, alpha: f64, beta: f64, gamma: f64, b_over_h: f64, poisson: f64) {
        self.composite_modulus = 2.0 / (1.0 - poisson);
        self.effective_shear_modulus = 2.0;
        self.tangential_modulus = 0.0;
        self.burgers_vector = 1.0;
        self.asperity_count = 1.0;
        self.height_std = alpha * beta;
        self.summit_radius = beta / alpha;
        self.work_of_adhesion = gamma * self.composite_modulus;
        self.adhesion_range = 1.0 / b_over_h;
    }

    /// E*, G* and the tangential modulus of two isotropic bodies; an infinite Young's modulus is a rigid body.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`]; the parameters are then as before.
    pub fn set_materials(&mut self, young_1: f64, poisson_1: f64, young_2: f64, poisson_2: f64) -> Result<(), Error> {
        const YOUNG: &str = "must be > 0; INFINITY is a rigid body";
        let rigid = infinite;
        for (name, young) in [("E1", young_1), ("E2", young_2)] {
            if !rigid(young) {
                magnitude(name, young, YOUNG)?;
            }
        }
        poisson_ratio("nu1", poisson_1)?;
        poisson_ratio("nu2", poisson_2)?;
        if rigid(young_1) && rigid(young_2) {
            return Err(Error::InvalidParameter {
                name: "E2",
                value: young_2.into(),
                allowed: "at least one of the two bodies must be elastic (finite)",
            });
        }
        // Compliances: those of a rigid body are 0.
        let compliance = |young: f64, factor: f64| if rigid(young) { 0.0 } else { factor / young };
        self.composite_modulus =
            1.0 / (compliance(young_1, 1.0 - poisson_1 * poisson_1) + compliance(young_2, 1.0 - poisson_2 * poisson_2));
        self.effective_shear_modulus =
            1.0 / (compliance(young_1, 1.0 + poisson_1) + compliance(young_2, 1.0 + poisson_2));
        let tangential = |poisson: f64| 2.0 * (1.0 + poisson) * (2.0 - poisson);
        self.tangential_modulus =
            1.0 / (compliance(young_1, tangential(poisson_1)) + compliance(young_2, tangential(poisson_2)));
        Ok(())
    }

    /// Summits of an isotropic Gaussian surface: `height_std`, `summit_radius`, `asperity_count` and `nominal_area` from
    /// the spectral moments of its profiles and its area.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`], also for moments that no such surface has, or [`Error::OutOfRange`]; the parameters
    /// are then as before.
    pub fn set_spectral_moments(&mut self, moments: SpectralMoments, nominal_area: f64) -> Result<(), Error> {
        let SpectralMoments { m0, m2, m4 } = moments;
        for (name, value) in [("m0", m0), ("m2", m2), ("m4", m4), ("nominal_area", nominal_area)] {
            positive(name, value)?;
        }
        if !moments.exist() {
            return Err(Error::InvalidParameter {
                name: "bandwidth m0 m4/m2^2",
                value: moments.bandwidth().into(),
                allowed: "must be at least 1.5, as that of every isotropic surface is; are all lengths in one unit?",
            });
        }
        self.height_std = moments.summit_height_std();
        self.summit_radius = moments.summit_radius();
        self.asperity_count = moments.summit_density() * nominal_area;
        self.nominal_area = nominal_area;
        Ok(())
    }

    /// The same summits with the heights and radii of Nayak's joint distribution: also sets Johnson's heights,
    /// `radius_amplitude` and `radius_rate`, and `summit_radius` is that at the mean height.
    ///
    /// # Errors
    /// As [`Params::set_spectral_moments`].
    pub fn set_nayak_summits(&mut self, moments: SpectralMoments, nominal_area: f64) -> Result<(), Error> {
        self.set_spectral_moments(moments, nominal_area)?;
        let shape = SummitShape::of_bandwidth(moments.bandwidth());
        self.summit_radius *= shape.radius_ratio;
        self.radius_amplitude = shape.radius_amplitude;
        self.radius_rate = shape.radius_rate;
        self.heights = HeightFamily::Johnson { skew: shape.skew, kurtosis: shape.kurtosis };
        Ok(())
    }

    /// Weibull heights of this skew.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] at or below -1.13955, the limit of the family; [`Error::OutOfRange`] outside -1.1100 to
    /// 2, the skews of the shapes from 200 to 1. The parameters are then as before.
    pub fn set_skew(&mut self, skew: f64) -> Result<(), Error> {
        self.heights = HeightFamily::Weibull { shape: Weibull::shape_of_skew(skew)? };
        Ok(())
    }

    /// The groups of eqs (7) and (8), heights and radii; every number is checked on the way.
    ///
    /// # Errors
    /// [`Error::Unset`], [`Error::InvalidParameter`] or [`Error::OutOfRange`], naming the first offence.
    pub(crate) fn surface(&self) -> Result<(Groups, Arc<dyn HeightDistribution>, RadiusProfile), Error> {
        if let Some((name, _)) =
            self.clone().physical().into_iter().find(|(_, value)| value.to_bits() == UNSET.to_bits())
        {
            return Err(Error::Unset { name });
        }
        positive("composite_modulus", self.composite_modulus)?;
        positive("effective_shear_modulus", self.effective_shear_modulus)?;
        if self.work_of_adhesion.to_bits() << 1 != 0 {
            magnitude("work_of_adhesion", self.work_of_adhesion, "must be finite and >= 0")?;
        }
        positive("adhesion_range", self.adhesion_range)?;
        positive("burgers_vector", self.burgers_vector)?;
        positive("height_std", self.height_std)?;
        positive("summit_radius", self.summit_radius)?;
        positive("asperity_count", self.asperity_count)?;
        let heights = distribution::heights(&self.heights)?;
        let radius = self.checked_radius(heights.origin())?;
        self.check_slip()?;
        if !infinite(self.max_friction_coefficient) {
            magnitude("max_friction_coefficient", self.max_friction_coefficient, "must be > 0; INFINITY is no cap")?;
        }
        for (name, value, allowed) in [
            ("hardness", self.hardness, "must be finite and >= 0; 0 is not known"),
            ("tangential_modulus", self.tangential_modulus, "must be finite and >= 0; 0 is E* G* / (2 (E* + G*))"),
            ("nominal_area", self.nominal_area, "must be finite and >= 0; 0 is not known"),
        ] {
            if value.to_bits() << 1 != 0 {
                magnitude(name, value, allowed)?;
            }
        }
        self.check_contact_law()?;

        let groups = Groups {
            alpha: (self.height_std / self.summit_radius).sqrt(),
            beta: (self.height_std * self.summit_radius).sqrt() / self.burgers_vector,
            gamma: self.work_of_adhesion / (self.composite_modulus * self.burgers_vector),
            b_over_h: self.burgers_vector / self.adhesion_range,
            hardness: if self.hardness > 0.0 { self.hardness / self.composite_modulus } else { f64::INFINITY },
            yields: self.contact_law == ContactLawKind::ElasticPlastic,
        };
        check_groups(&groups)?;
        unit_slips::check(self)?;
        Ok((groups, heights, radius))
    }

    fn checked_radius(&self, origin: f64) -> Result<RadiusProfile, Error> {
        let (amplitude, rate) = (self.radius_amplitude, self.radius_rate);
        if nan(amplitude) || !(-1.0..=1.0).contains(&amplitude) {
            return Err(Error::InvalidParameter {
                name: "radius_amplitude",
                value: amplitude.into(),
                allowed: "must be between -1 and 1",
            });
        }
        if !finite(rate) || rate <= 0.0 {
            return Err(Error::InvalidParameter { name: "radius_rate", value: rate.into(), allowed: POSITIVE });
        }
        if amplitude != 0.0 && !RADIUS_RATES.contains(&rate) {
            return Err(Error::OutOfRange {
                name: "radius_rate",
                value: rate.into(),
                allowed: "must be between 1e-6 and 1000 where radius_amplitude is not 0",
            });
        }
        Ok(RadiusProfile { amplitude, rate, origin })
    }

    /// What summits that yield need.
    fn check_contact_law(&self) -> Result<(), Error> {
        let yields = self.contact_law == ContactLawKind::ElasticPlastic;
        if yields && self.hardness == 0.0 {
            return Err(Error::InvalidParameter {
                name: "hardness",
                value: self.hardness.into(),
                allowed: "must be > 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1): summits yield at a \
                          part of it",
            });
        }
        if yields && self.work_of_adhesion != 0.0 {
            return Err(Error::InvalidParameter {
                name: "work_of_adhesion",
                value: self.work_of_adhesion.into(),
                allowed:
                    "must be 0 where contact_law is ASPERITY_CONTACT_ELASTIC_PLASTIC (1): adhesion of summits that \
                          yield is not modelled; set it to 0, or contact_law to ASPERITY_CONTACT_MAUGIS (0)",
            });
        }
        Ok(())
    }

    /// G^: that given, or its default E* G*/(2 (E* + G*)).
    pub(crate) fn effective_tangential_modulus(&self) -> f64 {
        let (composite, shear) = (self.composite_modulus, self.effective_shear_modulus);
        if self.tangential_modulus > 0.0 {
            self.tangential_modulus
        } else {
            0.5 * composite * shear / (composite + shear)
        }
    }

    fn check_slip(&self) -> Result<(), Error> {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.slip;
        positive("slip_radius_1", radius_1)?;
        positive("slip_stress_1", stress_1)?;
        positive("slip_radius_2", radius_2)?;
        positive("slip_stress_2", stress_2)?;
        // A relative distance, so that the exponent of the power law between the radii stays finite.
        if radius_2 <= radius_1 * (1.0 + 1e-9) {
            return Err(Error::InvalidParameter {
                name: "slip_radius_2",
                value: radius_2.into(),
                allowed: "must be greater than slip_radius_1",
            });
        }
        if stress_2 * radius_2 * radius_2 < stress_1 * radius_1 * radius_1 * (1.0 - 1e-12) {
            return Err(Error::InvalidParameter {
                name: "slip_stress_2",
                value: stress_2.into(),
                allowed: "must be at least slip_stress_1 (slip_radius_1/slip_radius_2)^2, so that the friction force \
                          of a summit does not fall as its contact grows",
            });
        }
        Ok(())
    }
}

/// The limits of the groups, with the slip of units that most likely leads beyond each.
fn check_groups(groups: &Groups) -> Result<(), Error> {
    macro_rules! within {
        ($name:literal, $value:expr, $limits:expr, $allowed:literal, $below:literal, $above:literal) => {
            if !$limits.contains(&$value) {
                let above = $value > *$limits.end();
                let allowed = if above { concat!($allowed, "; ", $above) } else { concat!($allowed, "; ", $below) };
                return Err(Error::OutOfRange { name: $name, value: $value.into(), allowed });
            }
        };
    }
    within!(
        "alpha",
        groups.alpha,
        1e-5..=10.0,
        "(height_std/summit_radius)^(1/2) must be between 1e-5 and 10",
        "is summit_radius in um?",
        "is height_std in um or nm?"
    );
    within!(
        "beta",
        groups.beta,
        0.1..=1e8,
        "(height_std summit_radius)^(1/2)/burgers_vector must be between 0.1 and 1e8",
        "is burgers_vector in nm? Of a smooth tip, a height_std of 1e-2 adhesion_range is small enough",
        "are height_std and summit_radius in um?"
    );
    if groups.gamma != 0.0 {
        within!(
            "gamma",
            groups.gamma,
            1e-9..=10.0,
            "work_of_adhesion/(composite_modulus burgers_vector) must be 0 or between 1e-9 and 10",
            "are work_of_adhesion and the moduli in one system of units?",
            "is work_of_adhesion in mJ/m^2, or are the moduli in GPa? Rubber and gels are outside of the law; to try them, set \
             work_of_adhesion to 0"
        );
        within!(
            "h/sigma",
            groups.reach(),
            0.0..=1e6,
            "adhesion_range/height_std must be at most 1e6",
            "",
            "is adhesion_range in nm? Else take a rougher surface, or no adhesion"
        );
    }
    within!(
        "b/h",
        groups.b_over_h,
        1e-3..=100.0,
        "burgers_vector/adhesion_range must be between 1e-3 and 100",
        "is adhesion_range in nm?",
        "is burgers_vector in nm?"
    );
    Ok(())
}

fn positive(name: &'static str, value: f64) -> Result<(), Error> {
    magnitude(name, value, POSITIVE)
}

fn magnitude(name: &'static str, value: f64, allowed: &'static str) -> Result<(), Error> {
    if !finite(value) || value <= 0.0 {
        return Err(Error::InvalidParameter { name, value: value.into(), allowed });
    }
    if !(1.0 / LARGEST..=LARGEST).contains(&value) {
        return Err(Error::OutOfRange { name, value: value.into(), allowed: MAGNITUDE });
    }
    Ok(())
}

fn poisson_ratio(name: &'static str, value: f64) -> Result<(), Error> {
    if nan(value) || !(value > -1.0 && value <= 0.5) {
        return Err(Error::InvalidParameter { name, value: value.into(), allowed: "must be > -1 and <= 0.5" });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbours::Neighbours;

    /// What a change of the default case is refused for, if it is: whether it has a meaning, and the offence's name.
    fn refused(change: impl FnOnce(&mut Params)) -> Option<(bool, &'static str)> {
        let mut params = Params::default();
        change(&mut params);
        params.surface().err().map(offence)
    }

    fn offence(error: Error) -> (bool, &'static str) {
        match error {
            Error::InvalidParameter { name, .. } | Error::InvalidEntry { name, .. } => (false, name),
            Error::OutOfRange { name, .. } => (true, name),
            Error::Unset { name } => (false, name),
            other => panic!("{other:?}"),
        }
    }

    /// Refused next to an interval and taken at its ends, by a change of the default case.
    fn assert_interval(name: &'static str, has_meaning: bool, [from, to]: [f64; 2], change: impl Fn(&mut Params, f64)) {
        for (value, next) in [(from, from.below()), (to, to.above())] {
            assert_eq!(refused(|params| change(params, value)), None, "{name} = {value:e}");
            assert_eq!(refused(|params| change(params, next)), Some((has_meaning, name)), "{name} = {next:e}");
        }
    }

    /// Any unit does: the paper's groups stay as they are.
    fn scaled(params: &mut Params, stress: f64, length: f64) {
        for modulus in [&mut params.composite_modulus, &mut params.effective_shear_modulus] {
            *modulus *= stress;
        }
        params.work_of_adhesion *= stress * length;
        for quantity in
            [&mut params.adhesion_range, &mut params.burgers_vector, &mut params.height_std, &mut params.summit_radius]
        {
            *quantity *= length;
        }
    }

    #[test]
    fn quantities_are_taken_up_to_the_limits_and_no_further() {
        let magnitudes = [1.0 / LARGEST, LARGEST];
        assert_interval("max_friction_coefficient", true, magnitudes, |params, x| params.max_friction_coefficient = x);
        assert_interval("asperity_count", true, magnitudes, |params, x| params.asperity_count = x);
        assert_interval("effective_shear_modulus", true, magnitudes, |params, x| params.effective_shear_modulus = x);
        assert_interval("slip_stress_1", true, magnitudes, |params, x| {
            params.slip = SlipConstants { stress_1: x, stress_2: x.clamp(magnitudes[0], magnitudes[1]), ..params.slip }
        });
        assert_eq!(refused(|params| params.hardness = 0.0), None);
        assert_eq!(refused(|params| params.hardness = -0.0), None);
        assert_eq!(refused(|params| params.max_friction_coefficient = f64::INFINITY), None);
        assert_eq!(refused(|params| params.work_of_adhesion = 0.0), None);
        for (stress, length) in [(1e30, 1e-30), (1e-30, 1e30)] {
            assert_eq!(refused(|params| scaled(params, stress, length)), None);
        }
        let interval = [-1.0, 1.0];
        assert_interval("radius_amplitude", false, interval, |params, x| params.radius_amplitude = x);
        let interval = [1e-6, 1e3];
        assert_interval("radius_rate", true, interval, |params, x| {
            (params.radius_amplitude, params.radius_rate) = (0.5, x);
        });
        // It is not read for equal radii.
        for rate in interval.map(|rate| 10.0 * rate * rate) {
            assert_eq!(refused(|params| params.radius_rate = rate), None, "{rate}");
        }
        assert_eq!(refused(|params| params.radius_rate = 0.0), Some((false, "radius_rate")));
    }

    #[test]
    fn the_first_input_that_was_never_set_is_named() {
        let mut params = Params::unset();
        let mut set = Params::default();
        let names = set.physical().map(|(name, _)| name);
        for (i, name) in names.into_iter().enumerate() {
            assert_eq!(params.surface().err(), Some(Error::Unset { name }));
            assert_eq!(params.surface().unwrap_err().to_string(), format!("{name}: must be set"));
            *params.physical()[i].1 = *set.physical()[i].1;
        }
        assert_eq!(params, set);
        // A NaN that was computed is told as what it is.
        let message = Params { height_std: f64::NAN, ..set }.surface().unwrap_err().to_string();
        assert_eq!(message, "height_std = NaN: must be finite and > 0");
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
            assert_eq!(with(radius, 1e3), None, "{radius}");
            assert_eq!(with(radius, least(radius) * (1.0 - 1e-10)), Some((false, "slip_stress_2")), "{radius}");
        }
        for radius in [3.0 * (1.0 + 1e-10), 3.0, 2.0] {
            assert_eq!(with(radius, 1.0), Some((false, "slip_radius_2")), "{radius}");
        }
    }

    #[test]
    fn poissons_ratios_are_taken_above_minus_1_up_to_a_half() {
        let allowed = |nu: f64| {
            let mut params = Params::default();
            let outcomes = [
                params.set_dimensionless(0.01, 1e3, 0.0, 1.0, nu),
                params.set_materials(1.0, nu, 1.0, 0.0),
                params.set_materials(1.0, 0.0, 1.0, nu),
            ];
            outcomes.map(|outcome| outcome.is_ok())
        };
        for (nu, outcome) in [(-1.0, false), ((-1.0_f64).above(), true), (0.5, true), (0.5_f64.above(), false)] {
            assert_eq!(allowed(nu), [outcome; 3], "{nu}");
        }
        assert_eq!(allowed(f64::NAN), [false; 3]);
    }

    #[test]
    fn moduli_are_those_of_two_bodies_in_series() {
        let moduli = |young_1: f64, nu_1: f64, young_2: f64, nu_2: f64| {
            let mut params = Params::default();
            params.set_materials(young_1, nu_1, young_2, nu_2).expect("materials");
            (params.composite_modulus, params.effective_shear_modulus)
        };
        let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-14;
        // 1/E* = 0.91/200 + 0.96/70, 1/G* = 1.3/200 + 1.2/70.
        let (composite, shear) = moduli(200.0, 0.3, 70.0, 0.2);
        assert!(near(composite, 1.0 / (0.00455 + 0.96 / 70.0)) && near(shear, 1.0 / (0.0065 + 1.2 / 70.0)));
        assert_eq!(moduli(70.0, 0.2, 200.0, 0.3), (composite, shear));
        // On a rigid body that of the other alone.
        let (composite, shear) = moduli(200.0, 0.3, f64::INFINITY, 0.1);
        assert!(near(composite, 200.0 / 0.91) && near(shear, 200.0 / 1.3));
        assert_eq!(moduli(f64::INFINITY, 0.1, 200.0, 0.3), (composite, shear));
        let both = Params::default().set_materials(f64::INFINITY, 0.3, f64::INFINITY, 0.3).err().map(offence);
        assert_eq!(both, Some((false, "E2")));
    }

    #[test]
    fn summits_of_an_area_are_their_density_times_it() {
        let moments = SpectralMoments { m0: 2.0, m2: 0.01, m4: 3e-4 };
        let mut params = Params::default();
        params.set_spectral_moments(moments, 250.0).expect("summits");
        assert_eq!(params.height_std, moments.summit_height_std());
        assert_eq!(params.summit_radius, moments.summit_radius());
        assert!((params.asperity_count / (250.0 * moments.summit_density()) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn nayaks_summits_are_taken_at_every_bandwidth() {
        for bandwidth in [1.5, 1.6, 2.0, 4.0, 20.0, 1e3, 1e6, 1e9] {
            let mut params = Params { work_of_adhesion: 0.0, ..Params::default() };
            let moments = SpectralMoments { m0: 1e4, m2: 0.01 / f64::sqrt(bandwidth), m4: 1e-8 };
            params.set_nayak_summits(moments, 250.0).expect("summits");
            assert!(params.radius_amplitude < 0.0 && params.radius_amplitude > -0.6, "{params:?}");
            params.surface().unwrap_or_else(|error| panic!("{bandwidth}: {error}"));
        }
    }
}
