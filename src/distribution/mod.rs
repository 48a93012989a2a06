//! The distribution of summit heights, standardised: standard deviation 1, height z in sigma above an origin.
//!
//! One family is one file that implements [`HeightDistribution`], and one arm of [`heights`]. `panel` turns what a family
//! says of its density into panels for quadrature.

pub mod at_scores;
pub mod gaussian;
pub mod johnson;
pub mod panel;
pub mod tabulated;
pub mod weibull;

use crate::error::Error;
use crate::numerics::elementary::exp_each;
use crate::numerics::quadrature::POINTS;
use at_scores::AtScores;
use gaussian::Gaussian;
use std::sync::Arc;
use tabulated::Tabulated;
use weibull::Weibull;

/// ln (2 pi)^(1/2).
const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;

/// What of a distribution does not depend on height.
#[derive(Debug, Clone)]
pub struct Outline {
    /// The height above the mean from which heights are measured: 0, or the upper end of the support where light loads
    /// depend on the distance to it.
    pub origin: f64,
    /// The ends of the support, infinite where it has none.
    pub support: (f64, f64),
    /// The height above which the density only falls.
    pub last_mode: f64,
    /// Third standardised moment.
    pub skew: f64,
    /// Fourth standardised moment.
    pub kurtosis: f64,
    /// Whether ln phi is concave: then the load of equal summits has one minimum.
    pub is_log_concave: bool,
    /// Whether the density is a polynomial of low degree between two breakpoints: then one panel reaches from one to the
    /// next, however steep ln phi is where the density vanishes.
    pub is_piecewise_polynomial: bool,
    /// The exponent p of phi ~ (z - lower end)^p, where the density is such a power at the lower end.
    pub power_at_lower_end: Option<f64>,
    /// What part of a panel serves that would serve if the logarithm of the density were a polynomial of low degree.
    pub part_of_panel: f64,
}

/// A standardised distribution of summit heights. One family is one file; the sums over the population need nothing else.
pub trait HeightDistribution: std::fmt::Debug + Send + Sync {
    /// What of it does not depend on height.
    fn outline(&self) -> &Outline;

    /// ln phi(z); minus infinity outside the support. At an end of the support it is the limit from within.
    fn log_density(&self, z: f64) -> f64;

    /// d(ln phi)/dz within the support.
    fn log_density_slope(&self, z: f64) -> f64;

    /// phi at the nodes of one panel, side by side.
    fn densities(&self, z: [f64; POINTS]) -> [f64; POINTS] {
        exp_each(z.map(|z| self.log_density(z)))
    }

    /// Distance from z to the nearest point, real or complex, where the density is not analytic, breakpoints apart; infinite
    /// if there is none.
    fn distance_to_singularity(&self, z: f64) -> f64;

    /// Heights, ascending, at which the density or a derivative of it jumps; the ends of the support included where the
    /// density does not vanish smoothly.
    fn breakpoints(&self) -> &[f64] {
        &[]
    }

    /// The table of the surface where radii follow from it too.
    fn at_scores(self: Arc<Self>) -> Option<Arc<AtScores>> {
        None
    }
}

/// Variance, skew and kurtosis of what is at these distances from its mean, with their weights.
fn moments(distances: impl Iterator<Item = (f64, f64)>) -> [f64; 3] {
    let (mut all, mut sums) = (0.0, [0.0; 3]);
    for (weight, distance) in distances {
        all += weight;
        let mut term = weight * distance;
        for sum in &mut sums {
            term *= distance;
            *sum += term;
        }
    }
    let [second, third, fourth] = sums.map(|sum| sum / all);
    [second, third / (second * second.sqrt()), fourth / (second * second)]
}

/// The family of the distribution of summit heights.
#[derive(Debug, Clone, PartialEq)]
pub enum HeightFamily {
    /// Eq (17).
    Gaussian,
    /// Eqs (18)-(21), with its shape omega.
    Weibull {
        /// omega from 1 to 200; 3.602 has no skew, more is negative skew.
        shape: f64,
    },
    /// Johnson's system: skew and kurtosis chosen independently.
    Johnson {
        /// Third standardised moment, -3 to 3.
        skew: f64,
        /// Fourth standardised moment, 1.87 + 1.25 skew^2 to 100; 3 with skew 0 is Gaussian.
        kurtosis: f64,
    },
    /// A measured density of summit heights, in any unit and of any origin; it need not be normalised.
    Tabulated {
        /// Heights, 3 to 256, increasing by 1e-12 of their range at least.
        height: Arc<[f64]>,
        /// The density at each height, >= 0.
        density: Arc<[f64]>,
    },
    /// The surface at the normal scores -3, -2.5 to 3 of its heights, of which those of the asperities and their radii follow.
    AtScores {
        /// Heights of the surface, increasing, in any unit and of any origin.
        height: Arc<[f64]>,
        /// Root mean square gradients where the surface is so high, > 0.
        slope: Arc<[f64]>,
    },
}

/// Heights, and what is known at each.
type Table<'a> = (&'a Arc<[f64]>, &'a Arc<[f64]>);

impl HeightFamily {
    /// The heights of a table: at scores with slopes, or else with their density.
    pub(crate) fn of_table(is_at_scores: bool, height: Arc<[f64]>, values: Arc<[f64]>) -> Self {
        match is_at_scores {
            true => Self::AtScores { height, slope: values },
            false => Self::Tabulated { height, density: values },
        }
    }

    /// The table of those that have one: its heights, and densities or slopes.
    pub fn table(&self) -> Option<Table<'_>> {
        match self {
            Self::Tabulated { height, density: values } | Self::AtScores { height, slope: values } => {
                Some((height, values))
            }
            _ => None,
        }
    }
}

/// The distribution of a family, of which every number is checked.
///
/// # Errors
/// [`Error::InvalidParameter`] or [`Error::InvalidEntry`] for what no distribution has, [`Error::OutOfRange`] for what is
/// not evaluated.
pub fn heights(family: &HeightFamily) -> Result<Arc<dyn HeightDistribution>, Error> {
    Ok(match family {
        HeightFamily::Gaussian => Arc::new(Gaussian),
        &HeightFamily::Weibull { shape } => Arc::new(Weibull::new(shape)?),
        &HeightFamily::Johnson { skew, kurtosis } => johnson::heights(skew, kurtosis)?,
        HeightFamily::Tabulated { height, density } => Arc::new(Tabulated::new(height, density)?),
        HeightFamily::AtScores { height, slope } => Arc::new(AtScores::new(height, slope)?.0),
    })
}

#[cfg(test)]
mod tests;
