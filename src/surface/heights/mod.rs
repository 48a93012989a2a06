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
/// The largest change of ln phi over one panel: of a parabola, and of what may fall doubly exponentially.
const STEEPEST_GAUSSIAN_PANEL: f64 = 14.0;
const STEEPEST_PANEL: f64 = 10.0;
/// Beside this many e-folds of density, what load gains on the way to smaller densities is nothing.
const GROWTH_OF_LOAD: f64 = 5.0;

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

    /// How far above z one quadrature panel may reach, in a sum whose largest ln phi is `log_scale`.
    pub fn smooth_length(&self, z: f64, log_scale: f64) -> f64 {
        let mut length = self.longest_panel();
        while length > SHORTEST_PANEL && self.roughness(z, z + length, log_scale) > 1.0 {
            length *= 0.75;
        }
        length
    }

    /// How much the density changes from one height to another, in such a sum; up to 1 one quadrature panel may reach
    /// from the one to the other.
    pub fn roughness(&self, from: f64, to: f64, log_scale: f64) -> f64 {
        let length = to - from;
        if self.foot().is_some_and(|(foot, _)| length > 2.0 * (from - foot)) {
            return f64::MAX;
        }
        let (at_from, at_to) = (self.log_density(from), self.log_density(to));
        let steepest = at_from.1.abs().max(at_to.1.abs());
        // What is small beside the sum needs fewer digits; but load grows with height where the density falls.
        let drop = (log_scale - at_from.0.max(at_to.0) - GROWTH_OF_LOAD).max(0.0);
        let allowed = match self {
            Heights::Gaussian => STEEPEST_GAUSSIAN_PANEL + drop,
            Heights::Weibull(_) => STEEPEST_PANEL + 0.5 * drop.min(20.0),
        };
        length * steepest / allowed
    }

    /// The longest panel, in sigma, on which the density is a polynomial to rounding.
    pub fn longest_panel(&self) -> f64 {
        match self {
            Heights::Gaussian => 3.0,
            Heights::Weibull(_) => 1.5,
        }
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
