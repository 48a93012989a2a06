//! Logarithmic derivatives of the friction force with respect to each parameter, at constant load.
//!
//! At constant load dF/dp = dF/dp|_d - (dF/dd)/(dP/dd) dP/dp|_d. The changes at fixed separation d are those of the population
//! by the groups; the parameters in the caller's units act through groups and units alone.

use crate::error::Error;
use crate::float_bits::finite;
use crate::params::{HeightFamily, Params, RADIUS_RATES};
use crate::population::{Change, Changes, Population, Sums};

/// Logarithmic derivatives d(ln F)/d(ln p) of the friction force F with respect to the parameters p of the same names, at constant
/// load. For `radius_amplitude`, `skew` and `pressure_coefficient`, which may be 0, they are d(ln F)/dp. They are 0 for parameters
/// that the model does not read. The slip radii are ratios, and constant while `burgers_vector` changes. The kurtosis is constant
/// while the skew changes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
#[allow(missing_docs)] // said above, of all
pub struct Sensitivities {
    pub composite_modulus: f64,
    pub effective_shear_modulus: f64,
    pub work_of_adhesion: f64,
    pub adhesion_range: f64,
    pub burgers_vector: f64,
    pub height_std: f64,
    pub summit_radius: f64,
    pub asperity_count: f64,
    pub weibull_shape: f64,
    pub radius_amplitude: f64,
    pub radius_rate: f64,
    pub slip_radius_1: f64,
    pub slip_stress_1: f64,
    pub slip_radius_2: f64,
    pub slip_stress_2: f64,
    pub skew: f64,
    pub kurtosis: f64,
    pub hardness: f64,
    pub pressure_coefficient: f64,
}

impl Sensitivities {
    /// Of a population at a separation with these sums, where the load falls with separation and there is friction.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub(crate) fn of(params: &Params, population: &Population, separation: f64, sums: &Sums) -> Result<Self, Error> {
        let (weibull, johnson) = match params.heights {
            HeightFamily::Weibull { shape } => (shape, None),
            HeightFamily::Johnson { kurtosis, .. } => (0.0, Some(kurtosis)),
            HeightFamily::Gaussian | HeightFamily::Tabulated { .. } => (0.0, None),
        };
        // That of equal radii need not be one that others may have.
        let with_radius = RADIUS_RATES.contains(&params.radius_rate);
        let with_heights = weibull > 0.0 || johnson.is_some();
        let changes = population.changes(separation, with_radius, with_heights)?;
        let Changes { by_groups, by_radius, by_heights, friction_by_slip } = changes;

        let force_per_load = sums.friction_slope / sums.load_slope;
        let at_load = |change: Change| (change.friction - force_per_load * change.load) / sums.friction;
        let by_load = force_per_load * sums.load() / sums.friction;
        let [alpha, beta, gamma, b_over_h, hardness] = by_groups.map(at_load);
        let [amplitude, rate] = by_radius.map(at_load);
        let [first, second] = by_heights.map(at_load);
        let [slip_radius_1, slip_stress_1, slip_radius_2, slip_stress_2] =
            friction_by_slip.map(|change| change / sums.friction);
        // By kappa E*/G*, and the part of the friction that is proportional to it: to E*, and not to G*.
        let by_pressure = sums.hertz_load / sums.friction;
        let modulus_ratio = params.composite_modulus / params.effective_shear_modulus;
        let of_pressure = params.pressure_coefficient * modulus_ratio * by_pressure;
        Ok(Self {
            composite_modulus: of_pressure - by_load - gamma - hardness,
            effective_shear_modulus: 1.0 - of_pressure,
            work_of_adhesion: gamma,
            adhesion_range: -b_over_h,
            burgers_vector: 2.0 * (1.0 - by_load) - beta - gamma + b_over_h,
            height_std: 0.5 * (beta + alpha),
            summit_radius: 0.5 * (beta - alpha),
            asperity_count: 1.0 - by_load,
            weibull_shape: weibull * first,
            radius_amplitude: if with_radius { amplitude } else { 0.0 },
            radius_rate: if params.radius_amplitude == 0.0 { 0.0 } else { rate },
            slip_radius_1,
            slip_stress_1,
            slip_radius_2,
            slip_stress_2,
            skew: johnson.map_or(0.0, |_| first),
            kurtosis: johnson.map_or(0.0, |kurtosis| kurtosis * second),
            hardness,
            pressure_coefficient: modulus_ratio * by_pressure,
        })
    }

    /// Whether all are numbers; the others are parts of one.
    pub(crate) fn are_finite(&self) -> bool {
        let of_groups = [self.composite_modulus, self.work_of_adhesion, self.adhesion_range, self.burgers_vector];
        let of_surface = [self.height_std, self.summit_radius, self.asperity_count, self.radius_amplitude];
        let of_shape = [self.weibull_shape, self.radius_rate, self.skew, self.kurtosis];
        let of_strength =
            [self.effective_shear_modulus, self.slip_stress_1, self.slip_stress_2, self.pressure_coefficient];
        [of_groups, of_surface, of_shape, of_strength, [self.hardness; 4]].iter().flatten().all(|&value| finite(value))
    }
}
