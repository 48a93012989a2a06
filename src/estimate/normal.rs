//! The normal distribution.

use libm::erfc;
use std::f64::consts::FRAC_1_SQRT_2;

/// Within so many standard deviations either way a normal distribution has this probability, between 0 and 1.
pub fn reach(probability: f64) -> f64 {
    let outside = |reach: f64| erfc(reach * FRAC_1_SQRT_2);
    let (mut low, mut high) = (0.0, 40.0);
    // Halved until no number is between.
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if outside(middle) > 1.0 - probability {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}
