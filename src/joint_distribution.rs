//! Heights and curvatures of the summits of an isotropic Gaussian surface together: Nayak's joint distribution.
//!
//! Nayak, J. Lubr. Technol. 93 (1971) 398-407. With the mean curvature t of a summit in (2 m4/3)^(1/2) and its height z
//! in m0^(1/2), t has the density (t^2 - 1 + e^(-t^2)) e^(-t^2/2), t > 0, and z given t is Gaussian with the mean r t and
//! the variance 1 - r^2, r^2 = 3/(2 bandwidth). What one radius and Gaussian heights leave out follows from r alone.

use crate::elementary::{exp, log1p};
use crate::numerics::quadrature;
use std::f64::consts::{PI, SQRT_2};

/// Beyond it radii change by less than 0.1 % in a standard deviation of height; differences of radii would lose digits.
const WIDEST: f64 = 1e6;

/// Eq (3) is right at the mean height and at one and two of these steps above, in standard deviations: most contacts lie there.
const STEP: f64 = 1.5;

/// Where a Gaussian is cut, in standard deviations: it is 1e-18 there.
const TAIL: f64 = 9.0;

/// What the joint distribution adds to density, mean curvature and standard deviation of height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SummitShape {
    /// Radius at the mean height over the inverse of the mean curvature of all summits.
    pub radius_ratio: f64,
    /// epsilon of eq (3).
    pub radius_amplitude: f64,
    /// rho of eq (3).
    pub radius_rate: f64,
    /// Third standardised moment of the heights.
    pub skew: f64,
    /// Fourth standardised moment of the heights.
    pub kurtosis: f64,
}

impl SummitShape {
    /// Of a surface of this bandwidth, at least 1.5.
    ///
    /// The radius at a height is the inverse of the mean curvature of the summits there. Eq (3), R (1 + epsilon
    /// tanh(rho z/sigma)), has its values at the mean height and 1.5 and 3 standard deviations above; between -0.5 and 3.5
    /// it is within 7 % of all others, from 0 within 3 %.
    pub fn of_bandwidth(bandwidth: f64) -> Self {
        // Rounding may leave the least bandwidth a little below 1.5.
        let correlation = (1.5 / bandwidth.min(WIDEST)).min(1.0).sqrt();
        let curvature = Moments::of_curvature();
        let (square, rest) = (correlation * correlation, (1.0 - correlation) * (1.0 + correlation));
        let variance = rest + square * curvature.variance;
        let curvature_at = |height: f64| {
            mean_curvature(correlation, rest.sqrt(), correlation * curvature.mean + height * variance.sqrt())
        };
        let at_mean = curvature_at(0.0);
        // How far the radius has fallen at one and two steps; tanh 2x = 2 tanh x/(1 + tanh^2 x).
        let [one, two] = [STEP, 2.0 * STEP].map(|height| 1.0 - at_mean / curvature_at(height));
        let tanh = (2.0 * one / two - 1.0).sqrt();
        Self {
            radius_ratio: curvature.mean / at_mean,
            radius_amplitude: -one / tanh,
            radius_rate: 0.5 * (log1p(tanh) - log1p(-tanh)) / STEP,
            skew: curvature.third * square * correlation / (variance * variance.sqrt()),
            kurtosis: 3.0 + curvature.fourth_cumulant * (square / variance) * (square / variance),
        }
    }
}

/// Of the curvatures t of summits.
struct Moments {
    mean: f64,
    variance: f64,
    third: f64,
    fourth_cumulant: f64,
}

impl Moments {
    /// In closed form: the density is three half Gaussians times powers.
    fn of_curvature() -> Self {
        let root = 3.0_f64.sqrt();
        let count = PI.sqrt() / (SQRT_2 * root);
        let [first, second, third, fourth] =
            [4.0 / (3.0 * count), 2.0 * root + 1.0 / 3.0, 56.0 / (9.0 * count), 12.0 * root + 1.0 / 3.0];
        let variance = second - first * first;
        let central_fourth =
            fourth - 4.0 * first * third + 6.0 * first * first * second - 3.0 * (first * first) * (first * first);
        Self {
            mean: first,
            variance,
            third: third - 3.0 * first * second + 2.0 * first * first * first,
            fourth_cumulant: central_fourth - 3.0 * variance * variance,
        }
    }
}

/// Mean curvature of the summits of a height: the Gaussian factors leave one of t with the mean r z and the variance
/// 1 - r^2 = spread^2, so that t = r z + spread y.
fn mean_curvature(correlation: f64, spread: f64, height: f64) -> f64 {
    // 1.5 standard deviations wide or less: 16 points then give a product of Gaussians to rounding.
    const PANELS: u32 = 12;
    let middle = correlation * height;
    let begin = if middle >= TAIL * spread { -TAIL } else { -middle / spread };
    let width = (TAIL - begin) / f64::from(PANELS);
    let (mut count, mut sum) = (0.0, 0.0);
    for panel in 0..PANELS {
        let from = begin + width * f64::from(panel);
        for (y, weight) in quadrature::nodes(from, from + width) {
            let t = middle + spread * y;
            let density = weight * (t * t - 1.0 + exp(-t * t)) * exp(-0.5 * y * y);
            count += density;
            sum += density * t;
        }
    }
    sum / count
}

#[cfg(test)]
mod tests {
    use super::*;

    const BANDWIDTHS: [f64; 7] = [1.5, 1.500001, 1.76, 3.0, 10.0, 100.0, 1e6];

    /// Height, curvature and density of summits on a grid, from the joint density as Nayak has it before anything is
    /// integrated: three second derivatives and the height, Gaussian, weighted by the determinant.
    ///
    /// With x = (zxx + zyy)/2, y = (zxx - zyy)/2 and w = zxy: <x^2> = 2 m4/3, <y^2> = <w^2> = m4/3, <z x> = -m2, and
    /// the determinant is x^2 - y^2 - w^2, for p^2 = y^2 + w^2 < x^2; here m0 = 1, 2 m4/3 = 1, so that m2 = r.
    fn on_a_grid(correlation: f64, mut visit: impl FnMut(f64, f64, f64)) {
        let spread = (1.0 - correlation * correlation).sqrt();
        let (step, fine) = (0.02, 40);
        for i in 1..450 {
            let t = step * f64::from(i);
            // Over p by the rule of midpoints; <p^2> = 1, of two components.
            let part = t / f64::from(fine);
            let of_curvature: f64 = (0..fine)
                .map(|j| part * (f64::from(j) + 0.5))
                .map(|p| part * 2.0 * p * (t * t - p * p) * (-p * p).exp())
                .sum();
            for j in -45..=45 {
                let u = 0.2 * f64::from(j);
                visit(correlation * t + spread * u, t, of_curvature * (-0.5 * (t * t + u * u)).exp());
            }
        }
    }

    #[test]
    fn skew_and_kurtosis_are_those_of_the_joint_density() {
        for bandwidth in [1.5, 1.76, 3.0, 10.0] {
            let correlation = (1.5_f64 / bandwidth).sqrt();
            let mut raw = [0.0; 5];
            on_a_grid(correlation, |z, _, density| {
                for (power, sum) in raw.iter_mut().enumerate() {
                    *sum += density * z.powi(power as i32);
                }
            });
            let [mean, second, third, fourth] = [1, 2, 3, 4].map(|power| raw[power] / raw[0]);
            let variance = second - mean * mean;
            let skew = (third - 3.0 * mean * second + 2.0 * mean.powi(3)) / variance.powf(1.5);
            let kurtosis =
                (fourth - 4.0 * mean * third + 6.0 * mean * mean * second - 3.0 * mean.powi(4)) / (variance * variance);
            let shape = SummitShape::of_bandwidth(bandwidth);
            assert!((shape.skew - skew).abs() < 2e-3, "{bandwidth}: {} {skew}", shape.skew);
            assert!((shape.kurtosis - kurtosis).abs() < 2e-3, "{bandwidth}: {} {kurtosis}", shape.kurtosis);
        }
    }

    #[test]
    fn radii_are_those_of_the_joint_density() {
        for bandwidth in [1.76, 3.0, 10.0] {
            let (correlation, shape) = ((1.5_f64 / bandwidth).sqrt(), SummitShape::of_bandwidth(bandwidth));
            let mut all = [0.0; 3];
            on_a_grid(correlation, |z, _, density| {
                for (sum, value) in all.iter_mut().zip([1.0, z, z * z]) {
                    *sum += density * value;
                }
            });
            let (mean, deviation) = (all[1] / all[0], (all[2] / all[0] - (all[1] / all[0]).powi(2)).sqrt());
            let (mut total, mut bins) = ([0.0; 2], [[0.0; 3]; 9]);
            on_a_grid(correlation, |z, t, density| {
                total[0] += density;
                total[1] += density * t;
                let place = ((z - mean) / deviation / 0.5 + 0.5).floor();
                if (0.0..9.0).contains(&place) {
                    let [count, curvature, height] = &mut bins[place as usize];
                    *count += density;
                    *curvature += density * t;
                    *height += density * (z - mean) / deviation;
                }
            });
            for [count, curvature, height] in bins.iter().take(8) {
                let seen = (total[1] / total[0]) / (curvature / count);
                let height = height / count;
                let tanh = (shape.radius_rate * height).tanh();
                let found = shape.radius_ratio * (1.0 + shape.radius_amplitude * tanh);
                assert!((found / seen - 1.0).abs() < 0.03, "bandwidth {bandwidth} at {height}: {found} for {seen}");
            }
        }
    }

    #[test]
    fn eq_3_meets_the_mean_curvature_at_three_heights() {
        let mean = Moments::of_curvature().mean;
        for bandwidth in BANDWIDTHS {
            let shape = SummitShape::of_bandwidth(bandwidth);
            let correlation = (1.5 / bandwidth).sqrt();
            let rest = (1.0 - correlation * correlation).max(0.0);
            let deviation = (rest + correlation * correlation * Moments::of_curvature().variance).sqrt();
            for height in [0.0, STEP, 2.0 * STEP] {
                let curvature = mean_curvature(correlation, rest.sqrt(), correlation * mean + height * deviation);
                let tanh = (shape.radius_rate * height).tanh();
                let found = shape.radius_ratio * (1.0 + shape.radius_amplitude * tanh);
                assert!((found * curvature / mean - 1.0).abs() < 1e-12, "{bandwidth} at {height}");
            }
        }
    }

    /// One wavelength: height is curvature, so the heights have the density of t, and radius is its inverse.
    #[test]
    fn one_wavelength_has_the_heights_of_its_curvatures() {
        let shape = SummitShape::of_bandwidth(1.5);
        let moments = Moments::of_curvature();
        assert!((shape.radius_ratio - 1.0).abs() < 1e-12);
        assert!((shape.skew - moments.third / moments.variance.powf(1.5)).abs() < 1e-12);
        let radius = 1.0 + shape.radius_amplitude * (shape.radius_rate * STEP).tanh();
        let expected = moments.mean / (moments.mean + STEP * moments.variance.sqrt());
        assert!((radius / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn broad_spectra_have_gaussian_heights_and_one_radius() {
        for bandwidth in [1e6, 1e20, 1e300] {
            let shape = SummitShape::of_bandwidth(bandwidth);
            assert!(shape.skew.abs() < 1e-6 && (shape.kurtosis - 3.0).abs() < 1e-6, "{shape:?}");
            assert!((shape.radius_ratio - 1.0).abs() < 1e-6, "{shape:?}");
            assert!((shape.radius_amplitude * shape.radius_rate).abs() < 1e-3, "{shape:?}");
        }
    }
}
