//! The summits of an isotropic Gaussian surface, from the spectral moments of its profiles: Nayak's statistics.
//!
//! Nayak, J. Lubr. Technol. 93 (1971) 398-407, derived them; Bush, Gibson and Keogh, Mech. Res. Commun. 3 (1976) 169-174,
//! gave the variance of the summit heights; McCool, J. Tribol. 109 (1987) 264-270, writes them as they are used here.

use std::f64::consts::PI;

/// The bandwidth of a surface with one wavelength, below which no isotropic surface is.
pub const LEAST_BANDWIDTH: f64 = 1.5;

/// Variances of height z, slope dz/dx and curvature d2z/dx2 along any profile of an isotropic surface. Those of the sum
/// of two independent surfaces are the sums.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpectralMoments {
    /// Of height [length^2].
    pub m0: f64,
    /// Of slope.
    pub m2: f64,
    /// Of curvature [1/length^2].
    pub m4: f64,
}

impl SpectralMoments {
    /// Nayak's bandwidth parameter m0 m4/m2^2.
    pub fn bandwidth(&self) -> f64 {
        self.m0 / self.m2 * (self.m4 / self.m2)
    }

    /// Whether an isotropic surface can have these moments, the rounding of its bandwidth apart.
    pub fn exist(&self) -> bool {
        self.bandwidth() >= LEAST_BANDWIDTH * (1.0 - 4.0 * f64::EPSILON)
    }

    /// Summits per area, m4/(6 pi 3^(1/2) m2).
    pub fn summit_density(&self) -> f64 {
        self.m4 / (6.0 * PI * 3.0_f64.sqrt() * self.m2)
    }

    /// The inverse of the mean curvature of the summits, 3 pi^(1/2)/(8 m4^(1/2)).
    pub fn summit_radius(&self) -> f64 {
        3.0 * PI.sqrt() / (8.0 * self.m4.sqrt())
    }

    /// Standard deviation of the summit heights, ((1 - 0.8968/bandwidth) m0)^(1/2).
    ///
    /// A height is correlated with the curvature s of its summit, in units of its own standard deviation, and s has the
    /// density (s^2 - 1 + e^(-s^2)) e^(-s^2/2) among summits: its variance makes 0.8968 of 3 (1 - var s)/2, exactly
    /// 1 + 16/pi - 3^(3/2).
    pub fn summit_height_std(&self) -> f64 {
        let reduction = 1.0 + 16.0 / PI - 27.0_f64.sqrt();
        ((1.0 - reduction / self.bandwidth()) * self.m0).sqrt()
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
        let spread = (2.0 * moments.m4 / 3.0).sqrt();
        let (count, mean) = (summit_integral(|_| 1.0), summit_integral(|s| s));
        let mean = mean / count;
        let variance = summit_integral(|s| (s - mean) * (s - mean)) / count;
        // Kac-Rice: the mean determinant of the second derivatives where they are those of a summit, times the density
        // 1/(2 pi m2) of no slope.
        let density = spread * spread * count / (2.0 * PI).sqrt() / (2.0 * PI * moments.m2);
        assert!((moments.summit_density() / density - 1.0).abs() < 1e-9, "{density}");
        assert!((moments.summit_radius() * spread * mean - 1.0).abs() < 1e-9);
        let regression = moments.m2 / spread;
        let height_variance = moments.m0 - regression * regression * (1.0 - variance);
        assert!((moments.summit_height_std().powi(2) / height_variance - 1.0).abs() < 1e-9);
    }

    /// 0.8968 is printed for the variance (Bush, Gibson and Keogh), 4/(pi bandwidth)^(1/2) for the mean (McCool).
    #[test]
    fn heights_of_summits_are_those_published() {
        let moments = SpectralMoments { m0: 1.0, m2: 1.0, m4: 10.0 };
        let reduction = 10.0 * (1.0 - moments.summit_height_std().powi(2));
        assert!((reduction - 0.8968).abs() < 5e-5, "{reduction}");
        let mean = summit_integral(|s| s) / summit_integral(|_| 1.0) * (3.0_f64 / 20.0).sqrt();
        assert!((mean - 4.0 / (10.0 * PI).sqrt()).abs() < 1e-9, "{mean}");
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
