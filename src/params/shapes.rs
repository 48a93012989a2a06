//! Heights and slopes at normal scores of surfaces of which only parameters are known.
//!
//! The heights follow from skew and kurtosis, from the two straight parts that a plateau surface has on a probability plot, or are a
//! bearing curve. The mean square slope is taken to go with a power of the standard deviation t = dT/dg of the heights at a score: no
//! power is that of all surfaces, and docs/validation.md has what that costs.

use crate::distribution::at_scores::{deviations, table_score, AtScores, SCORES};
use crate::distribution::johnson;
use crate::error::Error;
use crate::numerics::elementary::{exp, log};
use crate::numerics::root;
use std::array::from_fn;
use std::f64::consts::FRAC_1_SQRT_2;

/// The powers of t, where heights are those of skew and kurtosis, and where they are measured.
pub const POWER_OF_SKEW: f64 = 2.0;
pub const POWER_OF_HEIGHTS: f64 = 1.5;
/// Slopes change by no more than this power of e a score.
const STEEPEST_TILT: f64 = 1.0;
/// A slope of the top is found to this, relative.
const FOUND: f64 = 1e-6;
/// The top: what is higher than the mean by a score of 1, 16 % of the surface.
pub const TOP: f64 = 1.0;

/// No part of a surface has a score as high.
const HIGHEST_SCORE: f64 = 38.0;

/// Heights of a surface at the scores.
pub type Heights = [f64; SCORES];

/// Standard heights of a skew and a kurtosis: Johnson's, but for negative skew those of lognormal depths where the kurtosis is less,
/// as that of plateaus is.
///
/// # Errors
/// Those of [`johnson::heights`].
pub fn skewed(skew: f64, kurtosis: f64) -> Result<Heights, Error> {
    johnson::check_exists(skew, kurtosis)?;
    let kurtosis = if skew < 0.0 { kurtosis.max(johnson::kurtosis_of_lognormal(skew)) } else { kurtosis };
    johnson::heights_at(skew, kurtosis, from_fn(table_score))
}

/// Heights of a plateau surface: straight on a probability plot above and below the material ratio `smq`, with the standard deviations
/// `spq` and `svq` (ISO 25178-2).
pub fn plateau(spq: f64, svq: f64, smq: f64) -> Heights {
    let turn = root::bracketed(|g| 0.5 * libm::erfc(g * FRAC_1_SQRT_2) - smq, -HIGHEST_SCORE, HIGHEST_SCORE);
    from_fn(|i| table_score(i) - turn).map(|g| if g > 0.0 { spq * g } else { svq * g })
}

/// Root mean square slopes at the scores, of which the whole surface has that mean, with a power of t.
pub fn slopes(height: &Heights, slope: f64, power: f64) -> Heights {
    let by_deviation = deviations(height).map(|deviation| exp(0.5 * power * log(deviation / height_range(height))));
    match AtScores::new(height, &by_deviation) {
        Ok((_, whole)) => by_deviation.map(|one| one * (slope / whole.slope)),
        // What is wrong with the heights is told where they are used.
        Err(_) => [slope; SCORES],
    }
}

/// The same with [`POWER_OF_HEIGHTS`], tilted: times a power of e that goes with the score, such that the top has its slope.
///
/// # Errors
/// [`Error::InvalidParameter`] of a slope of the top that no surface has beside that of the whole.
pub fn slopes_of_top(height: &Heights, slope: f64, top: f64) -> Result<Heights, Error> {
    let level = slopes(height, slope, POWER_OF_HEIGHTS);
    let tilted = |tilt: f64| from_fn(|i| level[i] * exp(tilt * table_score(i)));
    let excess = |tilt: f64| {
        let found = AtScores::new(height, &tilted(tilt));
        found.map_or(f64::NAN, |(table, whole)| log(table.slope_above(TOP) / whole.slope * (slope / top)))
    };
    let tilt = root::bracketed(excess, -STEEPEST_TILT, STEEPEST_TILT);
    match AtScores::new(height, &tilted(tilt)) {
        Ok((_, whole)) if excess(tilt).abs() < FOUND => Ok(tilted(tilt).map(|one| one * (slope / whole.slope))),
        _ => {
            let allowed = "must be a slope that 16 % of a surface can have beside Sdq: is it Sdq of the points above the score 1?";
            Err(Error::invalid("Sdq_top", top, allowed))
        }
    }
}

fn height_range(height: &Heights) -> f64 {
    height[SCORES - 1] - height[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn whole(height: &Heights, slope: &Heights) -> crate::distribution::at_scores::Whole {
        AtScores::new(height, slope).expect("a table").1
    }

    #[test]
    fn slopes_have_the_mean_and_the_top_that_are_given() {
        let height = plateau(0.3, 2.0, 0.8);
        let slope = slopes(&height, 0.1, POWER_OF_HEIGHTS);
        assert!((whole(&height, &slope).slope / 0.1 - 1.0).abs() < 1e-12);
        let slope = slopes_of_top(&height, 0.1, 0.04).expect("slopes");
        let (table, whole) = AtScores::new(&height, &slope).expect("a table");
        assert!((whole.slope / 0.1 - 1.0).abs() < 1e-9 && (table.slope_above(TOP) / 0.04 - 1.0).abs() < 1e-5);
        assert!(slopes_of_top(&height, 0.1, 40.0).is_err());
        // Heights that are Gaussian have a top of their own slope too.
        let gaussian: Heights = from_fn(table_score);
        for top in [0.05, 0.09, 0.1, 0.13, 0.2] {
            let slope = slopes_of_top(&gaussian, 0.1, top).expect("slopes");
            let (table, whole) = AtScores::new(&gaussian, &slope).expect("a table");
            assert!(
                (whole.slope / 0.1 - 1.0).abs() < 1e-9 && (table.slope_above(TOP) / top - 1.0).abs() < 1e-5,
                "{top}"
            );
        }
    }

    #[test]
    fn skew_and_kurtosis_of_three_are_gaussian_and_negative_skew_is_lognormal() {
        for (found, g) in skewed(0.0, 3.0).expect("heights").into_iter().zip(0..) {
            assert!((found - table_score(g)).abs() < 1e-12);
        }
        let [flat, same] = [5.0, 3.0 + 6.0].map(|kurtosis| skewed(-1.5, kurtosis).expect("heights"));
        assert!(flat[12] < 1.7 && same[12] > flat[12], "{flat:?} {same:?}");
        assert!(skewed(1.0, 1.9).is_err() && skewed(-1.0, 1.9).is_err());
    }
}
