//! What holds for heights of every family, from one end of the domain to the other.

use super::*;
use crate::numerics::elementary::exp;

/// Families and shapes, next to each other where the domain ends.
pub fn families() -> Vec<Arc<dyn HeightDistribution>> {
    let mut families = vec![HeightFamily::Gaussian];
    for shape in [1.0, 1.001, 1.1, 1.5, 2.0, 2.5, 3.602, 5.0, 7.3, 10.0, 20.0, 50.0, 100.0, 200.0] {
        families.push(HeightFamily::Weibull { shape });
    }
    for skew in [0.0_f64, 0.001, 0.1, 0.5, 1.0, 2.0, 3.0] {
        let least = 1.87 + 1.25 * skew * skew;
        for kurtosis in [0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0].map(|part| least + (100.0 - least) * part) {
            families.extend([skew, -skew].map(|skew| HeightFamily::Johnson { skew, kurtosis }));
        }
    }
    for density in [[1.0, 3.0, 1.0, 0.0, 0.0, 2.0], [0.0, 0.1, 4.0, 5.0, 1.0, 0.0]] {
        let height = [0.0, 1.0, 2.0, 2.5, 3.0, 4.0];
        families.push(HeightFamily::Tabulated { height: height.into(), density: density.into() });
    }
    for rate in [-0.6_f64, 0.3] {
        let height = (0..at_scores::SCORES).map(|i| (rate * at_scores::table_score(i)).exp() * rate.signum()).collect();
        let slope = (0..at_scores::SCORES).map(|i| 1.2 + (i as f64).sin()).collect();
        families.push(HeightFamily::AtScores { height, slope });
    }
    families.iter().map(|family| heights(family).expect("heights")).collect()
}

/// Heights from the lower tail to the upper one, within the support and off its breakpoints.
fn places(heights: &dyn HeightDistribution) -> Vec<f64> {
    let (lowest, highest) = heights.outline().support;
    let bulk = (0..60).map(|i| -heights.outline().origin - 3.03 + 0.1 * f64::from(i));
    bulk.filter(|&z| z > lowest + 1e-3 && z < highest - 1e-3 && heights.log_density(z) > -200.0).collect()
}

#[test]
fn slopes_are_those_of_secants_and_turn_at_the_last_mode() {
    for heights in families() {
        for z in places(&*heights) {
            let step = 1e-6 * heights.distance_to_singularity(z).min(1.0);
            let secant = (heights.log_density(z + step) - heights.log_density(z - step)) / (2.0 * step);
            let (slope, known) = (heights.log_density_slope(z), 1e-15 * (200.0 + z.abs()) / step);
            assert!((slope - secant).abs() < 1e-5 * (1.0 + secant.abs()) + known, "{slope}, not {secant}, {heights:?}");
            assert!(slope <= 0.0 || z < heights.outline().last_mode, "{slope} at {z} of {heights:?}");
        }
    }
}

#[test]
fn densities_side_by_side_are_those_of_each_height_and_none_lies_outside_the_support() {
    for heights in families() {
        let (lowest, highest) = heights.outline().support;
        let beyond = [lowest - 1e-9 * (1.0 + lowest.abs()), highest + 1e-9 * (1.0 + highest.abs())];
        for z in beyond.into_iter().filter(|z| z.is_finite()) {
            assert_eq!(heights.log_density(z), f64::NEG_INFINITY, "{z} of {heights:?}");
        }
        for length in [0.1, 9.0] {
            let z: [f64; POINTS] = std::array::from_fn(|i| length * (i as f64 / 15.0 - 0.9) - heights.outline().origin);
            for (density, z) in heights.densities(z).into_iter().zip(z) {
                let alone = exp(heights.log_density(z));
                assert!((density - alone).abs() <= 4e-15 * alone, "{density:e}, not {alone:e} at {z} of {heights:?}");
            }
        }
    }
}
