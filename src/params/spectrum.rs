//! The summits of an isotropic Gaussian surface, from the spectral moments of its profiles.
//!
//! Two ways. `asperities` are those that make the sums of this library follow boundary elements, whatever the bandwidth: area,
//! patches, gap and stiffness of a rough surface depend on m0 and m2 alone (B. N. J. Persson, J. Chem. Phys. 115 (2001) 3840),
//! so that it behaves as one of narrow spectrum. `mccool_summits` are its local maxima, all with their mean curvature: Nayak,
//! J. Lubr. Technol. 93 (1971) 398-407, derived them; Bush, Gibson and Keogh, Mech. Res. Commun. 3 (1976) 169-174, gave the
//! variance of their heights; McCool, J. Tribol. 109 (1987) 264-270, writes them as they are used here.

use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

/// The bandwidth of a surface with one wavelength, below which no isotropic surface is.
pub const LEAST_BANDWIDTH: f64 = 1.5;

/// What was fitted to boundary elements (docs/validation.md): the asperities of a surface with m0 = 2 m2 = 1. All else follows
/// from dimensions.
struct Fitted {
    height_std: f64,
    /// At the bandwidth 5; it goes with a power of the bandwidth.
    radius: f64,
    bandwidth_power: f64,
    density: f64,
    radius_amplitude: f64,
    radius_rate: f64,
    /// Mean height of the asperities above the mean plane.
    mean_height: f64,
    /// Taken where none is known.
    bandwidth: f64,
}

const FITTED: Fitted = Fitted {
    height_std: 0.92,
    radius: 1.63,
    bandwidth_power: -0.043,
    density: 0.026,
    radius_amplitude: -0.61,
    radius_rate: 0.90,
    mean_height: 1.23,
    bandwidth: 8.0,
};

/// What a lay changes: 1 where the mean square slopes along and across it are equal. Fitted to boundary elements of surfaces whose
/// slopes differ by factors from 1.5 to 12 (docs/validation.md); elliptical contacts give 0.21 for 0.17.
const LAY: f64 = 0.17;

/// The factor of the radius of a contact with a lay, the ratio of the root mean square slopes across it and along it.
pub fn lay_factor(lay: f64) -> f64 {
    1.0 + LAY * log(0.5 * (lay + 1.0 / lay))
}

/// Summits as the sums take them. Their heights are Gaussian.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summits {
    /// Standard deviation of the heights [length].
    pub height_std: f64,
    /// Radius at the mean height [length].
    pub radius: f64,
    /// Per area [1/length^2].
    pub density: f64,
    /// epsilon of eq (3).
    pub radius_amplitude: f64,
    /// rho of eq (3), where epsilon is not 0.
    pub radius_rate: f64,
    /// Mean of the heights, above the mean plane of the surface [length].
    pub mean_height: f64,
}

/// Variances of height z, slope dz/dx and curvature d2z/dx2 along any profile of an isotropic surface. Those of the sum
/// of two independent surfaces are the sums.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralMoments {
    /// Variance of height [length^2].
    pub m0: f64,
    /// Variance of slope.
    pub m2: f64,
    /// Variance of curvature [1/length^2]; 0 if not known.
    pub m4: f64,
}

impl SpectralMoments {
    /// Nayak's bandwidth parameter m0 m4/m2^2; 0 if m4 is not known.
    pub fn bandwidth(&self) -> f64 {
        self.m0 / self.m2 * (self.m4 / self.m2)
    }

    /// Whether an isotropic surface can have these moments, the rounding of its bandwidth apart.
    pub fn exist(&self) -> bool {
        self.m4 == 0.0 || self.bandwidth() >= LEAST_BANDWIDTH * (1.0 - 4.0 * f64::EPSILON)
    }

    /// Root mean square slope in two dimensions, Sdq = (2 m2)^(1/2).
    pub fn rms_slope(&self) -> f64 {
        (2.0 * self.m2).sqrt()
    }

    /// The asperities that stand for a surface rough on however many scales.
    pub fn asperities(&self) -> Summits {
        let (height, square_slope) = (self.m0.sqrt(), 2.0 * self.m2);
        let bandwidth = if self.m4 == 0.0 { FITTED.bandwidth } else { self.bandwidth() };
        Summits {
            height_std: FITTED.height_std * height,
            radius: FITTED.radius * exp(FITTED.bandwidth_power * log(bandwidth / 5.0)) * (height / square_slope),
            density: FITTED.density * (square_slope / self.m0),
            radius_amplitude: FITTED.radius_amplitude,
            radius_rate: FITTED.radius_rate,
            mean_height: FITTED.mean_height * height,
        }
    }

    /// McCool's summits: m4/(6 pi 3^(1/2) m2) per area, with the radius 3 pi^(1/2)/(8 m4^(1/2)), the inverse of their mean
    /// curvature, heights of the variance (1 - 0.8968/bandwidth) m0 and the mean 4 (m0/(pi bandwidth))^(1/2). m4 must be known.
    ///
    /// A height is correlated with the curvature s of its summit, in units of its own standard deviation, and s has the
    /// density (s^2 - 1 + e^(-s^2)) e^(-s^2/2) among summits: its variance makes 0.8968 of 3 (1 - var s)/2, exactly
    /// 1 + 16/pi - 3^(3/2).
    pub fn mccool_summits(&self) -> Summits {
        let reduction = 1.0 + 16.0 / PI - 27.0_f64.sqrt();
        Summits {
            height_std: ((1.0 - reduction / self.bandwidth()) * self.m0).sqrt(),
            radius: 3.0 * PI.sqrt() / (8.0 * self.m4.sqrt()),
            density: self.m4 / (6.0 * PI * 3.0_f64.sqrt() * self.m2),
            radius_amplitude: 0.0,
            radius_rate: FITTED.radius_rate,
            mean_height: 4.0 * (self.m0 / (PI * self.bandwidth())).sqrt(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Integrals over the curvatures of summits, of which all three formulas are made.
    fn summit_integral(f: impl Fn(f64) -> f64) -> f64 {
        const STEPS: u32 = 200_000;
        let step = 14.0 / f64::from(STEPS);
        let weight = |s: f64| (s * s - 1.0 + (-s * s).exp()) * (-0.5 * s * s).exp() * f(s);
        (1..STEPS).map(|i| step * weight(step * f64::from(i))).sum()
    }

    /// Curvature s in units of (2 m4/3)^(1/2), its standard deviation at any point; its covariance with height is m2.
    #[test]
    fn formulas_follow_from_the_curvatures_of_summits() {
        let moments = SpectralMoments { m0: 3.0, m2: 0.5, m4: 0.7 };
        let summits = moments.mccool_summits();
        let spread = (2.0 * moments.m4 / 3.0).sqrt();
        let (count, mean) = (summit_integral(|_| 1.0), summit_integral(|s| s));
        let mean = mean / count;
        let variance = summit_integral(|s| (s - mean) * (s - mean)) / count;
        // Kac-Rice: the mean determinant of the second derivatives where they are those of a summit, times the density
        // 1/(2 pi m2) of no slope.
        let density = spread * spread * count / (2.0 * PI).sqrt() / (2.0 * PI * moments.m2);
        assert!((summits.density / density - 1.0).abs() < 1e-9, "{density}");
        assert!((summits.radius * spread * mean - 1.0).abs() < 1e-9);
        let regression = moments.m2 / spread;
        let height_variance = moments.m0 - regression * regression * (1.0 - variance);
        assert!((summits.height_std.powi(2) / height_variance - 1.0).abs() < 1e-9);
    }

    /// 0.8968 is printed for the variance (Bush, Gibson and Keogh), 4/(pi bandwidth)^(1/2) for the mean (McCool).
    #[test]
    fn heights_of_summits_are_those_published() {
        let summits = SpectralMoments { m0: 1.0, m2: 1.0, m4: 10.0 }.mccool_summits();
        let reduction = 10.0 * (1.0 - summits.height_std.powi(2));
        assert!((reduction - 0.8968).abs() < 5e-5, "{reduction}");
        let mean = summit_integral(|s| s) / summit_integral(|_| 1.0) * (3.0_f64 / 20.0).sqrt();
        assert!((mean - summits.mean_height).abs() < 1e-9, "{mean}");
    }

    /// Waves of one length in all directions: height is curvature, but for its sign and scale.
    #[test]
    fn one_wavelength_has_the_least_bandwidth() {
        let wave_number = 3.0_f64;
        // Averages of cos^2 and cos^4 of the direction.
        let moments = SpectralMoments { m0: 1.0, m2: wave_number.powi(2) / 2.0, m4: wave_number.powi(4) * 3.0 / 8.0 };
        assert!((moments.bandwidth() / LEAST_BANDWIDTH - 1.0).abs() < 1e-15);
        assert!(moments.exist());
        assert!(!SpectralMoments { m4: moments.m4 * (1.0 - 1e-9), ..moments }.exist());
    }
}
