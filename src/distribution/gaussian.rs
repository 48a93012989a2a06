//! Gaussian heights, eq (17).

use super::{HeightDistribution, LN_SQRT_2_PI};

/// The standard normal distribution.
#[derive(Debug)]
pub struct Gaussian;

impl HeightDistribution for Gaussian {
    fn support(&self) -> (f64, f64) {
        (f64::NEG_INFINITY, f64::INFINITY)
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

    fn last_mode(&self) -> f64 {
        0.0
    }

    fn is_log_concave(&self) -> bool {
        true
    }

    fn skew(&self) -> f64 {
        0.0
    }

    fn kurtosis(&self) -> f64 {
        3.0
    }
}
