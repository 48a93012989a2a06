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

#[cfg(test)]
mod tests {
    use super::reach;
    use crate::estimate::known::REACH_95;

    #[test]
    fn reaches_are_those_of_tables() {
        for (probability, expected) in [(0.95, REACH_95), (0.5, 0.674_489_750_196_081_7), (0.99, 2.575_829_303_548_901)]
        {
            assert!((reach(probability) - expected).abs() < 1e-13, "{probability}: {}", reach(probability));
        }
        assert!(reach(1e-300) < 1e-15 && reach(1.0 - f64::EPSILON / 2.0) < 40.0);
    }
}
