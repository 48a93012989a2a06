//! Gaussian heights, eq (17).

use super::{HeightDistribution, Outline, LN_SQRT_2_PI};

/// That of the standard normal distribution.
pub const GAUSSIAN: Outline = Outline {
    origin: 0.0,
    support: (f64::NEG_INFINITY, f64::INFINITY),
    last_mode: 0.0,
    skew: 0.0,
    kurtosis: 3.0,
    is_log_concave: true,
    is_piecewise_polynomial: false,
    power_at_lower_end: None,
    part_of_panel: 1.0,
};

/// The standard normal distribution.
#[derive(Debug)]
pub struct Gaussian;

impl HeightDistribution for Gaussian {
    fn outline(&self) -> &Outline {
        &GAUSSIAN
    }

    fn log_density(&self, z: f64) -> f64 {
        -0.5 * z * z - LN_SQRT_2_PI
    }

    fn log_density_slope(&self, z: f64) -> f64 {
        -z
    }

    fn distance_to_singularity(&self, _z: f64) -> f64 {
        f64::INFINITY
    }
}
