//! The distribution of summit heights, standardised: mean 0, standard deviation 1, height z in sigma.
//!
//! A family gives its log density with its slope, its support, and how long a piece of the height axis
//! one quadrature panel may cover; the sums over the population need nothing else.

pub mod weibull;

use weibull::Weibull;

/// Contributions below exp(-NEGLIGIBLE) of the largest are left out of the sums.
const NEGLIGIBLE: f64 = 46.0;
/// Densities below exp of this are taken as zero.
pub const UNDERFLOW: f64 = -2000.0;
/// The longest panel, in sigma, on which a standardised density is a polynomial to rounding.
const LONGEST_PANEL: f64 = 1.5;
/// The largest change of ln phi over one panel: of a parabola, and of what may fall doubly exponentially.
const STEEPEST_GAUSSIAN_PANEL: f64 = 14.0;
const STEEPEST_PANEL: f64 = 10.0;

/// A standardised height distribution.
#[derive(Debug, Clone, PartialEq)]
pub enum Heights {
    /// Eq (17).
    Gaussian,
    /// Eqs (18)-(21).
    ///
    /// Boxed, so that the compiler cannot evaluate ahead of the match what only Weibull heights have.
    Weibull(Box<Weibull>),
}

impl Heights {
    /// ln phi(z) and its slope; minus infinity and 0 outside the support.
    #[inline]
    pub fn log_density(&self, z: f64) -> (f64, f64) {
        match self {
            Heights::Gaussian => {
                const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;
                (-0.5 * z * z - LN_SQRT_2_PI, -z)
            }
            Heights::Weibull(weibull) => {
                if z > -weibull.mean() {
                    weibull.log_density(z)
                } else {
                    (f64::NEG_INFINITY, 0.0)
                }
            }
        }
    }

    /// phi(z) exp(-log_scale) at z = `from` + `rise`, where ln phi(`from`) is `log_scale`, or that is 0.
    ///
    /// It has as many digits as `rise`, which may be a number of more digits than z.
    #[inline]
    pub fn relative_density(&self, from: f64, rise: f64, log_scale: f64) -> f64 {
        match self {
            Heights::Gaussian => (-rise * (from + 0.5 * rise)).exp(),
            Heights::Weibull(_) => (self.log_density(from + rise).0 - log_scale).exp(),
        }
    }

    /// Where the support begins, with the exponent p of phi ~ (z - foot)^p there; `None` if it is endless.
    pub fn foot(&self) -> Option<(f64, f64)> {
        match self {
            Heights::Gaussian => None,
            Heights::Weibull(weibull) => Some((-weibull.mean(), weibull.shape() - 1.0)),
        }
    }

    /// The part of a range of heights that is not negligible beside the rest of it.
    pub fn worth_summing(&self, lower: f64, upper: f64) -> (f64, f64) {
        match self {
            Heights::Gaussian => {
                let (near_lower, near_upper) = (lower.max(0.0), upper.min(0.0));
                (
                    lower.max(-near_upper.hypot((2.0 * NEGLIGIBLE).sqrt())),
                    upper.min(near_lower.hypot((2.0 * NEGLIGIBLE).sqrt())),
                )
            }
            Heights::Weibull(weibull) => {
                // Load grows as height^(3/2), which for a heavy tail competes with the density.
                let growth = 2.0 / weibull.shape() * NEGLIGIBLE.ln();
                let highest = weibull.height_of_hazard(weibull.hazard(lower) + NEGLIGIBLE + growth);
                let hazard = weibull.hazard(upper).min(1.0) * (-NEGLIGIBLE).exp();
                let lowest = weibull.height_of_hazard(hazard.max(f64::MIN_POSITIVE));
                // Where a power-law foot holds a part that is not negligible, the range begins there.
                let is_foot = lowest + weibull.mean() < 0.01;
                (if is_foot { lower } else { lower.max(lowest) }, upper.min(highest))
            }
        }
    }

    /// The foot, or a height below which the density cannot be represented.
    pub fn far_foot(&self) -> f64 {
        match self {
            Heights::Gaussian => -self.far_tail(),
            Heights::Weibull(weibull) => -weibull.mean(),
        }
    }

    /// A height above which the density cannot be represented.
    pub fn far_tail(&self) -> f64 {
        match self {
            Heights::Gaussian => (-2.0 * UNDERFLOW).sqrt(),
            Heights::Weibull(weibull) => weibull.height_of_hazard(-UNDERFLOW),
        }
    }

    /// Where the density is largest.
    pub fn mode(&self) -> f64 {
        match self {
            Heights::Gaussian => 0.0,
            Heights::Weibull(weibull) => {
                let shape = weibull.shape();
                if shape > 1.0 {
                    weibull.height_of_hazard(1.0 - 1.0 / shape)
                } else {
                    -weibull.mean()
                }
            }
        }
    }

    /// How far above z one quadrature panel may reach.
    pub fn smooth_length(&self, z: f64) -> f64 {
        let mut length = LONGEST_PANEL;
        while length > SHORTEST_PANEL && !self.is_smooth(z, z + length) {
            length *= 0.5;
        }
        length
    }

    /// Whether one quadrature panel may reach from one height to another.
    pub fn is_smooth(&self, from: f64, to: f64) -> bool {
        let length = to - from;
        if self.foot().is_some_and(|(foot, _)| length > 2.0 * (from - foot)) {
            return false;
        }
        let steepest = self.log_density(from).1.abs().max(self.log_density(to).1.abs());
        let limit = if matches!(self, Heights::Gaussian) { STEEPEST_GAUSSIAN_PANEL } else { STEEPEST_PANEL };
        length * steepest <= limit
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        match self {
            Heights::Gaussian => 0.0,
            Heights::Weibull(weibull) => weibull.skew(),
        }
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        match self {
            Heights::Gaussian => 3.0,
            Heights::Weibull(weibull) => weibull.kurtosis(),
        }
    }
}

/// The shortest panel, in sigma: what lies within it of a singular point is negligible.
pub const SHORTEST_PANEL: f64 = 1e-8;
