//! A surface pair in the user's own consistent units, and the ways to set its parameters.
//!
//! `checks` says what they may be together, and what they amount to; `numbers` what one of them may be; `spectrum` has the
//! asperities of a rough surface.

mod checks;
mod numbers;
pub(crate) mod shapes;
pub(crate) mod spectrum;
mod unit_slips;
mod waviness;

use crate::asperity::slip::{Slip, SlipConstants, SlipOnset};
use crate::distribution::at_scores::AtScores;
use crate::distribution::weibull::Weibull;
pub use crate::distribution::HeightFamily;
use crate::error::Error;
use crate::materials::{Bodies, Interface};
use crate::numerics::float_bits::infinite;
pub(crate) use checks::STEEPEST_SURFACE;
pub(crate) use numbers::positive;
pub(crate) use numbers::LARGEST_QUANTITY;
use numbers::{magnitude, not_negative, poisson_ratio};
pub(crate) use spectrum::LEAST_BANDWIDTH;
use spectrum::{SpectralMoments, Summits};
use std::f64::consts::PI;
use std::sync::Arc;
use unit_slips::BROADEST;
pub use waviness::{Waviness, WavinessShape};

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
    /// Nominal area of contact [length^2], to judge whether summits crowd and how neighbours stiffen contacts; 0 if not known.
    pub nominal_area: f64,
    /// The law of one summit in contact.
    pub contact_law: ContactLawKind,
    /// How a contact begins to slip: before all of it does, this is what it resists.
    pub slip_onset: SlipOnset,
    /// kappa >= 0: a contact's friction force is pi a^2 tau(a) + kappa P_H, P_H the load of Hertz' contact of its radius. 0, the
    /// default, is a strength that does not depend on pressure.
    pub pressure_coefficient: f64,
    /// Nayak's bandwidth m0 m4/m2^2 of the surface, at least 1.5, to judge whether summits act alone; 0 if not known.
    pub bandwidth: f64,
    /// The load of the measurement that set the strength of the interface [force]; 0 if there was none.
    pub calibration_load: f64,
    /// The friction force measured at it [force]; 0 if the strength was not calibrated.
    pub calibration_friction_force: f64,
    /// The relative standard error of that measurement; 1 without one where an estimate took the strength of other materials.
    pub calibration_error: f64,
    /// Height of the mean of the summits above the mean plane of the surface [length]; 0 if not known: gaps then count from the
    /// mean of the summits.
    pub summit_mean_height: f64,
    /// Root mean square slope of the surface, Sdq = (2 m2)^(1/2), to judge slopes and waves on the nominal area; 0 if not known.
    pub rms_slope: f64,
    /// Whether Gaussian heights stand for those of a surface that is known not to have them, of which states then warn.
    pub taken_as_gaussian: bool,
    /// Waves on which the roughness stands. A solver whose mesh carries the waves leaves them out here.
    pub waviness: Waviness,
    /// The unit of all lengths [m]: 1, or what [`Params::set_units`] has converted them into.
    pub length_unit: f64,
    /// The unit of all forces [N]: 1, or what [`Params::set_units`] has converted them into.
    pub force_unit: f64,
}

impl Default for Params {
    /// Defaults for all but the eight physical inputs, `composite_modulus` to `asperity_count`, which are unset: NaN, and
    /// [`Model::new`](crate::Model::new) refuses the first that is.
    fn default() -> Self {
        let mut params = Self::paper();
        for (_, value) in params.physical() {
            *value = UNSET;
        }
        params
    }
}

/// What the physical inputs are until they are set: a quiet NaN that no arithmetic makes.
pub(crate) const UNSET: f64 = f64::from_bits(0x7ff8_0000_756e_7365);

fn is_unset(value: f64) -> bool {
    value.to_bits() == UNSET.to_bits()
}

/// The error of a measurement where nothing else is said, and what says that there was none.
const USUAL_ERROR: f64 = 0.05;
pub(crate) const OF_OTHER_MATERIALS: f64 = 1.0;

/// The bandwidth of summits of a Gaussian surface is 0.897 + (eta sigma R/0.02036)^2.
const NARROWEST_BANDWIDTH: f64 = 0.8968;
const BANDWIDTH_PRODUCT: f64 = 0.02036;

/// The ratios of slopes that a lay may have: boundary elements were made up to 12.
const LAYS: std::ops::RangeInclusive<f64> = 0.05..=20.0;

/// Refuses a lay that no boundary elements have been made of.
pub(crate) fn check_lay(lay: f64) -> Result<(), Error> {
    positive("lay", lay)?;
    if LAYS.contains(&lay) {
        return Ok(());
    }
    let allowed = "must be between 1/20 and 20: the ratio of the slopes, Rdq across the lay over Rdq along it; of longer grooves \
                   nothing is known";
    Err(Error::out_of_range("lay", lay, allowed))
}

/// The radius_rate of radii that vary with height.
pub(crate) const RADIUS_RATES: std::ops::RangeInclusive<f64> = 1e-6..=1e3;

impl Params {
    /// The paper's case: alpha = 0.01, beta = 1000, gamma = 0.001, nu = 0.3 in units b = G = 1, N = 1.
    pub fn paper() -> Self {
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
            slip_onset: SlipOnset::Partial,
            pressure_coefficient: 0.0,
            bandwidth: 0.0,
            calibration_load: 0.0,
            calibration_friction_force: 0.0,
            calibration_error: USUAL_ERROR,
            summit_mean_height: 0.0,
            rms_slope: 0.0,
            taken_as_gaussian: false,
            waviness: Waviness::default(),
            length_unit: 1.0,
            force_unit: 1.0,
        };
        params.write_dimensionless(0.01, 1000.0, 0.001, 1.0, 0.3);
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

    /// The first of them that was never set.
    pub(crate) fn unset(&self) -> Option<&'static str> {
        self.clone().physical().into_iter().find(|(_, value)| is_unset(**value)).map(|(name, _)| name)
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
        not_negative("gamma", gamma, "must be finite and >= 0")?;
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
        (self.length_unit, self.force_unit) = (1.0, 1.0);
    }

    /// E*, G* and the tangential modulus of two isotropic bodies; an infinite Young's modulus is a rigid body.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`]; the parameters are then as before.
    pub fn set_materials(&mut self, young_1: f64, poisson_1: f64, young_2: f64, poisson_2: f64) -> Result<(), Error> {
        const YOUNG: &str = "must be > 0; INFINITY is a rigid body";
        for (name, young) in [("E1", young_1), ("E2", young_2)] {
            if !infinite(young) {
                magnitude(name, young, YOUNG)?;
            }
        }
        poisson_ratio("nu1", poisson_1)?;
        poisson_ratio("nu2", poisson_2)?;
        if infinite(young_1) && infinite(young_2) {
            return Err(Error::invalid("E2", young_2, "at least one of the two bodies must be elastic (finite)"));
        }
        // Compliances: those of a rigid body are 0.
        let compliance = |young: f64, factor: f64| if infinite(young) { 0.0 } else { factor / young };
        self.composite_modulus =
            1.0 / (compliance(young_1, 1.0 - poisson_1 * poisson_1) + compliance(young_2, 1.0 - poisson_2 * poisson_2));
        self.effective_shear_modulus =
            1.0 / (compliance(young_1, 1.0 + poisson_1) + compliance(young_2, 1.0 + poisson_2));
        let tangential = |poisson: f64| 2.0 * (1.0 + poisson) * (2.0 - poisson);
        self.tangential_modulus =
            1.0 / (compliance(young_1, tangential(poisson_1)) + compliance(young_2, tangential(poisson_2)));
        Ok(())
    }

    /// All that is known of two bodies in contact, in SI units: the moduli, the work of adhesion, the longer Burgers vector, the
    /// range of adhesion, equal to it as in the paper, the hardness of the softer body, and the slip stress where it is measured.
    /// What is not known is left to set, as by [`Params::default`], and so is the roughness.
    ///
    /// # Errors
    /// As [`Params::set_materials`], and [`Error::InvalidParameter`] of parameters that were converted into other units.
    pub fn set_bodies(&mut self, bodies: &Bodies) -> Result<(), Error> {
        let Bodies { first, second } = bodies;
        self.check_not_converted()?;
        self.set_materials(first.young, first.poisson, second.young, second.poisson)?;
        self.burgers_vector = bodies.burgers_vector().unwrap_or(UNSET);
        self.adhesion_range = self.burgers_vector;
        self.hardness = bodies.hardness();
        self.work_of_adhesion = bodies.pair().map_or(UNSET, |pair| pair.work_of_adhesion);
        if let Some(measured) = bodies.pair().map(|pair| pair.slip_stress_1).filter(|&stress| stress > 0.0) {
            self.slip.stress_1 = measured;
        }
        Ok(())
    }

    /// The measured strength of an interface, which does not depend on the size of a contact: both slip stresses, over the
    /// `effective_shear_modulus` of the bodies, which must be set before and in Pa, and the pressure coefficient, 0 where none is
    /// known. It is a start: calibrate with a measurement of your own where you can.
    ///
    /// # Errors
    /// [`Error::NoStrength`] of an interface of which only a friction coefficient is known: calibrate with it.
    /// [`Error::InvalidParameter`] of a shear modulus that is not set or not above the strength.
    pub fn set_interface(&mut self, interface: &'static Interface) -> Result<(), Error> {
        const MODULUS: &str = "effective_shear_modulus";
        const ALLOWED: &str =
            "must be in Pa and above the strength of the interface: set the bodies first, in SI units";
        self.check_not_converted()?;
        let strength = interface.shear_strength;
        if strength == 0.0 {
            return Err(Error::NoStrength { interface });
        }
        magnitude(MODULUS, self.effective_shear_modulus, ALLOWED)?;
        if self.effective_shear_modulus < strength {
            return Err(Error::invalid(MODULUS, self.effective_shear_modulus, ALLOWED));
        }
        self.slip.stress_1 = strength / self.effective_shear_modulus;
        self.slip.stress_2 = self.slip.stress_1;
        self.pressure_coefficient = interface.pressure_coefficient;
        self.calibration_error = self.error_of_point();
        (self.calibration_load, self.calibration_friction_force) = (0.0, 0.0);
        Ok(())
    }

    /// Summits that yield, of a body of this hardness, in contacts without adhesion: contact law, hardness and work of adhesion.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`]; the parameters are then as before.
    pub fn set_elastic_plastic(&mut self, hardness: f64) -> Result<(), Error> {
        magnitude("hardness", hardness, "must be finite and > 0: the indentation hardness of the softer body")?;
        self.hardness = hardness;
        self.work_of_adhesion = 0.0;
        self.contact_law = ContactLawKind::ElasticPlastic;
        Ok(())
    }

    /// The asperities that follow from the spectral moments of a surface, rough on however many scales, and its area:
    /// `height_std`, `summit_radius`, `asperity_count`, `nominal_area`, `radius_amplitude`, `radius_rate`, `summit_mean_height`
    /// and `rms_slope`. `bandwidth` becomes 0: that of these asperities is not that of the surface. m4 may be 0, not known.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`], also for moments that no such surface has, or [`Error::OutOfRange`]; the parameters
    /// are then as before.
    pub fn set_spectral_moments(&mut self, moments: SpectralMoments, nominal_area: f64) -> Result<(), Error> {
        not_negative("m4", moments.m4, "must be finite and >= 0; 0 means not known")?;
        self.set_summits(SpectralMoments::asperities, moments, nominal_area)?;
        self.bandwidth = 0.0;
        Ok(())
    }

    /// The asperities of a surface of any heights: those of the surface, above its mean plane or any other, and its root mean square
    /// gradients, at its normal scores -3, -2.5 to 3. A bandwidth of 0 is not known. Sets what [`Params::set_spectral_moments`] does, and `heights`.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`], [`Error::InvalidEntry`] or [`Error::OutOfRange`]; the parameters are then as before.
    pub fn set_heights_at_scores(
        &mut self,
        [height, slope]: &[shapes::Heights; 2],
        bandwidth: f64,
        nominal_area: f64,
    ) -> Result<(), Error> {
        let (_, whole) = AtScores::new(height, slope)?;
        let (m0, m2) = (whole.height * whole.height, whole.slope * whole.slope / 2.0);
        let m4 = bandwidth * m2 * (m2 / m0);
        self.set_spectral_moments(SpectralMoments { m0, m2, m4 }, nominal_area)?;
        self.height_std = whole.deviation;
        self.summit_mean_height = whole.mean.max(0.0);
        self.asperity_count *= whole.count;
        self.heights = HeightFamily::AtScores { height: Arc::from(*height), slope: Arc::from(*slope) };
        Ok(())
    }

    /// Gives asperities of an isotropic surface a lay: the ratio of the root mean square slopes across it and along it, of either
    /// order.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`]; the parameters are then as before.
    pub fn set_lay(&mut self, lay: f64) -> Result<(), Error> {
        check_lay(lay)?;
        let factor = spectrum::lay_factor(lay);
        self.asperity_count /= factor;
        self.summit_radius *= factor * factor;
        Ok(())
    }

    /// McCool's summits of the surface instead, all with one radius: the same parameters, and `bandwidth`.
    ///
    /// # Errors
    /// As [`Params::set_spectral_moments`]; m4 must be known.
    pub fn set_mccool_summits(&mut self, moments: SpectralMoments, nominal_area: f64) -> Result<(), Error> {
        positive("m4", moments.m4)?;
        self.set_summits(SpectralMoments::mccool_summits, moments, nominal_area)?;
        // That of a narrow spectrum is 1.5 but for rounding.
        self.bandwidth = moments.bandwidth().max(LEAST_BANDWIDTH);
        Ok(())
    }

    fn set_summits(
        &mut self,
        of: fn(&SpectralMoments) -> Summits,
        moments: SpectralMoments,
        nominal_area: f64,
    ) -> Result<(), Error> {
        for (name, value) in [("m0", moments.m0), ("m2", moments.m2), ("nominal_area", nominal_area)] {
            positive(name, value)?;
        }
        checks::check_rms_slope(moments.rms_slope())?;
        if !moments.exist() {
            let allowed = "must be at least 1.5, the least of isotropic surfaces; are all lengths in one unit, Ssc per m and Sds per m^2?";
            return Err(Error::invalid("bandwidth m0 m4/m2^2", moments.bandwidth(), allowed));
        }
        if moments.bandwidth() > BROADEST.0 {
            return Err(Error::out_of_range("bandwidth m0 m4/m2^2", moments.bandwidth(), BROADEST.1));
        }
        let summits = of(&moments);
        self.height_std = summits.height_std;
        self.summit_radius = summits.radius;
        self.asperity_count = summits.density * nominal_area;
        self.nominal_area = nominal_area;
        self.radius_amplitude = summits.radius_amplitude;
        self.radius_rate = summits.radius_rate;
        self.summit_mean_height = summits.mean_height;
        self.rms_slope = moments.rms_slope();
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

    /// Whether loads are those of a surface: with a count of 1, as in the paper, they are those of a mean summit.
    pub(crate) fn is_of_many(&self) -> bool {
        self.asperity_count != 1.0
    }

    /// Whether the strength of the interface is the default, or what an estimate took of other materials, and not a measured one.
    pub(crate) fn has_default_strength(&self) -> bool {
        let SlipConstants { stress_1, stress_2, .. } = SlipConstants::default();
        let is_default =
            self.slip.stress_1 == stress_1 && self.slip.stress_2 == stress_2 && self.pressure_coefficient == 0.0;
        self.calibration_friction_force == 0.0 && (is_default || self.calibration_error == OF_OTHER_MATERIALS)
    }

    /// The error of a measurement that is made on these surfaces.
    pub(crate) fn error_of_point(&self) -> f64 {
        let is_marked = self.calibration_friction_force == 0.0 && self.calibration_error == OF_OTHER_MATERIALS;
        if is_marked {
            USUAL_ERROR
        } else {
            self.calibration_error
        }
    }

    /// E* (sigma/R)^(1/2)/H; 0 if the hardness is not known.
    pub(crate) fn plasticity_index(&self) -> f64 {
        match self.hardness > 0.0 {
            true => self.composite_modulus * (self.height_std / self.summit_radius).sqrt() / self.hardness,
            false => 0.0,
        }
    }

    /// Nayak's bandwidth: that given, or that of a Gaussian surface with this number of summits on the nominal area (P. R. Nayak,
    /// J. Lubr. Technol. 93 (1971) 398; eta sigma R as J. I. McCool, J. Tribol. 109 (1987) 264, has it); 0 if neither is known.
    pub(crate) fn known_bandwidth(&self) -> f64 {
        if self.bandwidth > 0.0 {
            self.bandwidth
        } else {
            self.bandwidth_of_density()
        }
    }

    /// That of the summits on the nominal area; 0 if the area is not known, and of asperities at scores, which were not counted.
    fn bandwidth_of_density(&self) -> f64 {
        if self.nominal_area <= 0.0 || matches!(self.heights, HeightFamily::AtScores { .. }) {
            return 0.0;
        }
        // Beyond, no number is needed.
        let product = (self.summit_product() / BANDWIDTH_PRODUCT).min(LARGEST_QUANTITY);
        NARROWEST_BANDWIDTH + product * product
    }

    /// eta sigma R, eta the summits per `nominal_area`, which must be known.
    fn summit_product(&self) -> f64 {
        self.asperity_count / self.nominal_area * self.height_std * self.summit_radius
    }

    /// How many waves of the mean length 2 pi height_std/rms_slope fit a side of the nominal area; 0 if not known.
    pub(crate) fn waves_a_side(&self) -> f64 {
        self.nominal_area.sqrt() * self.rms_slope / (2.0 * PI * self.height_std)
    }

    /// The law of friction of one contact, in dimensionless units.
    pub(crate) fn slip_law(&self) -> Slip {
        let by_hertz_load = self.pressure_coefficient * self.composite_modulus / self.effective_shear_modulus;
        Slip::new(self.slip, by_hertz_load, self.slip_onset)
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::neighbours::Neighbours;

    #[test]
    fn poissons_ratios_are_taken_above_minus_1_up_to_a_half() {
        let allowed = |nu: f64| {
            let mut params = Params::paper();
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

    /// Each of m4 = 0 and m4 of the least bandwidth is taken, by the setter that it is for.
    #[test]
    fn m4_may_be_unknown_but_for_mccools_summits() {
        let moments = |m4: f64| SpectralMoments { m0: 2.0, m2: 0.01, m4 };
        let mut params = Params::paper();
        for m4 in [0.0, -0.0, 7.5e-5] {
            params.set_spectral_moments(moments(m4), 250.0).expect("asperities");
        }
        for m4 in [-1e-4, f64::NAN, f64::INFINITY, 7.4e-5, 51.0] {
            assert!(params.set_spectral_moments(moments(m4), 250.0).is_err(), "{m4}");
            assert!(params.set_mccool_summits(moments(m4), 250.0).is_err(), "{m4}");
        }
        let unknown = params.set_mccool_summits(moments(0.0), 250.0);
        assert!(matches!(unknown, Err(Error::InvalidParameter { name: "m4", .. })), "{unknown:?}");
    }
}
