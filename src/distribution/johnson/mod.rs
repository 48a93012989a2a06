//! Heights of Johnson's system of curves (Biometrika 36, 1949, 149-176): skew and kurtosis chosen independently.
//!
//! A function u(z) of height is normal: u = gamma + delta arsinh((z - xi)/lambda) for S_U, which has no end, and
//! u = gamma + delta ln((z - xi)/(xi + lambda - z)) for S_B, which has two; lognormal curves lie between them, and
//! the Gaussian is the limit of all. `fit` finds the curve; here it is standardised to mean 0 and standard deviation 1.

mod fit;

use super::gaussian::{Gaussian, GAUSSIAN};
use super::{HeightDistribution, Outline, LN_SQRT_2_PI};
use crate::error::Error;
use crate::numerics::elementary::{exp, expm1, hypot, log, log1p};
use crate::numerics::float_bits::finite;
use crate::numerics::root;
use fit::{CurveKind, Fit};
use std::sync::Arc;

/// The largest skew, of either sign, and the largest kurtosis that are evaluated: in heavier tails loads are carried by
/// summits that no surface is large enough to have.
const LARGEST_SKEW: f64 = 3.0;
const LARGEST_KURTOSIS: f64 = 100.0;

/// The least kurtosis that is evaluated, for a skew. Above it densities have one maximum and vanish at their ends, with
/// delta of at least 1/2; S_B curves of less kurtosis may have two maxima, at their ends.
fn least_kurtosis(skew: f64) -> f64 {
    1.87 + 1.25 * skew * skew
}

/// The upper end of the support is made the origin of heights where sums in the tail depend on the distance to it: where
/// less than this part of the distance from the mean is left at u = FAR_UP, beyond which densities are no numbers. The same
/// goes for S_U where it nearly ends: it is singular at y = -tau +- i (1 - tau^2)^(1/2). An origin farther than this many
/// widths of the bulk would blur it.
const LEFT_AT_END: f64 = 0.1;
const FAR_UP: f64 = 38.0;
const FARTHEST_END: f64 = 300.0;

/// A standardised curve of Johnson's system.
#[derive(Debug)]
struct Johnson {
    epsilon: f64,
    /// dv/dz, with v of `fit`.
    deviation: f64,
    kind: CurveKind,
    /// dy/dz, with y = epsilon v.
    rate: f64,
    /// Height of the median.
    median: f64,
    /// Of which `origin` is what is subtracted from heights above their mean.
    outline: Outline,
}

/// The heights of a skew and a kurtosis.
///
/// # Errors
/// [`Error::InvalidParameter`] for what no distribution has: not finite, or a kurtosis that is not above skew^2 + 1;
/// [`Error::OutOfRange`] for skews and kurtoses that are not evaluated.
pub fn heights(skew: f64, kurtosis: f64) -> Result<Arc<dyn HeightDistribution>, Error> {
    check(skew, kurtosis)?;
    let fit = fit::fit(skew, kurtosis);
    if fit.epsilon == 0.0 {
        return Ok(Arc::new(Gaussian));
    }
    Ok(Arc::new(Johnson::new(skew, kurtosis, fit)))
}

/// The standard heights of the same at some scores.
///
/// # Errors
/// The same.
pub fn heights_at<const N: usize>(skew: f64, kurtosis: f64, scores: [f64; N]) -> Result<[f64; N], Error> {
    check(skew, kurtosis)?;
    let fit = fit::fit(skew, kurtosis);
    if fit.epsilon == 0.0 {
        return Ok(scores);
    }
    let curve = Johnson::new(skew, kurtosis, fit);
    Ok(scores.map(|score| curve.height(score) + curve.outline.origin))
}

/// The kurtosis of lognormal heights or depths of this skew.
pub fn kurtosis_of_lognormal(skew: f64) -> f64 {
    3.0 + fit::excess_of_lognormal(skew.clamp(-LARGEST_SKEW, LARGEST_SKEW).abs())
}

/// Refuses what no distribution has.
///
/// # Errors
/// [`Error::InvalidParameter`].
pub fn check_exists(skew: f64, kurtosis: f64) -> Result<(), Error> {
    match check(skew, kurtosis) {
        Err(error @ Error::InvalidParameter { .. }) => Err(error),
        _ => Ok(()),
    }
}

fn check(skew: f64, kurtosis: f64) -> Result<(), Error> {
    let impossible = |name, value: f64, allowed| Err(Error::InvalidParameter { name, value: value.into(), allowed });
    let out_of_range = |name, value: f64, allowed| Err(Error::OutOfRange { name, value: value.into(), allowed });
    // Squares stay finite.
    let bounded = skew.clamp(-1e150, 1e150);
    match () {
        () if !finite(skew) => impossible("skew", skew, "must be finite"),
        () if !finite(kurtosis) || kurtosis <= bounded * bounded + 1.0 => {
            impossible("kurtosis", kurtosis, "must be finite and > skew^2 + 1, as that of every distribution")
        }
        () if skew.abs() > LARGEST_SKEW => out_of_range(
            "skew",
            skew,
            "must be between -3 and 3; take a table of heights, without the few that are far from the rest",
        ),
        () if kurtosis > LARGEST_KURTOSIS => out_of_range(
            "kurtosis",
            kurtosis,
            "must be at most 100; take a table of heights, without the few that are far from the rest",
        ),
        () if kurtosis < least_kurtosis(skew) => out_of_range(
            "kurtosis",
            kurtosis,
            "must be at least 1.87 + 1.25 skew^2: with less, Johnson's heights may gather at two; take a table of heights",
        ),
        () => Ok(()),
    }
}

impl Johnson {
    fn new(skew: f64, kurtosis: f64, fit: Fit) -> Self {
        let Fit { epsilon, kind, mean, deviation } = fit;
        let rate = epsilon * deviation;
        let median = -mean / deviation;
        let outline = Outline { skew, kurtosis, is_log_concave: false, ..GAUSSIAN };
        let mut curve = Self { epsilon, deviation, kind, rate, median, outline };
        let (end, away) = match kind {
            CurveKind::Unbounded { below, above } => (median + (below - 1.0) / rate, (below * above).sqrt() / rate),
            CurveKind::Bounded { .. } => (curve.ends().1, 0.0),
        };
        if (end - curve.height(FAR_UP)).max(away) < LEFT_AT_END * end && end * deviation < FARTHEST_END {
            curve.outline.origin = end;
            curve.median -= end;
        }
        // The slope of ln(du/dz) by u is epsilon at most.
        let score = root::bracketed(|u| curve.log_density_slope(curve.height(u)), -1.01 * epsilon, 1.01 * epsilon);
        curve.outline.last_mode = curve.height(score);
        curve.outline.support = curve.ends();
        curve
    }

    /// The height of a u.
    pub fn height(&self, u: f64) -> f64 {
        let t = self.epsilon * u;
        match self.kind {
            CurveKind::Unbounded { below, above } if self.outline.origin == 0.0 => {
                self.median + 0.5 * (above * expm1(t) - below * expm1(-t)) / self.rate
            }
            CurveKind::Unbounded { below, above } => 0.5 * (above * exp(t) - below * exp(-t)) / self.rate,
            CurveKind::Bounded { share, .. } if self.outline.origin == 0.0 => {
                let rise = expm1(t);
                self.median + rise / (1.0 + share * rise) / self.rate
            }
            CurveKind::Bounded { share, .. } => -1.0 / (1.0 + share * expm1(t)) / (share * self.rate),
        }
    }

    /// The ends of the support.
    fn ends(&self) -> (f64, f64) {
        match self.kind {
            CurveKind::Unbounded { .. } => (f64::NEG_INFINITY, f64::INFINITY),
            CurveKind::Bounded { share, rest } => {
                let upper = if self.outline.origin == 0.0 { self.median + 1.0 / (share * self.rate) } else { 0.0 };
                (self.median - 1.0 / (rest * self.rate), upper)
            }
        }
    }

    /// u and what else the density takes; `None` beyond the support.
    #[inline]
    fn at(&self, z: f64) -> Option<At> {
        let (t, rate, slope) = match self.kind {
            CurveKind::Unbounded { below, above } => self.unbounded(z, below, above),
            CurveKind::Bounded { share, rest } => self.bounded(z, share, rest)?,
        };
        let u = t / self.epsilon;
        let rate = self.deviation * rate;
        Some(At { u, rate, slope: self.rate * slope - u * rate })
    }

    /// t, dt/dy and d(ln dt/dy)/dy of S_U.
    #[inline]
    fn unbounded(&self, z: f64, below: f64, above: f64) -> (f64, f64, f64) {
        // y + tau and its distance from where the curve is singular, as a complex number.
        let tau = 0.5 * (above - below);
        let y = self.rate * (z - self.median);
        let height = if self.outline.origin == 0.0 { y + tau } else { self.rate * z };
        let distance = (height * height + below * above).sqrt();
        let t = match (self.outline.origin == 0.0, height >= 0.0) {
            (true, true) => log1p(y * (above + distance + height) / ((1.0 + distance) * above)),
            (true, false) => -log1p(-y * (below + distance - height) / ((1.0 + distance) * below)),
            (false, true) => log((height + distance) / above),
            (false, false) => -log((distance - height) / below),
        };
        (t, 1.0 / distance, -height / (distance * distance))
    }

    /// The same of S_B; `None` beyond its ends.
    #[inline]
    fn bounded(&self, z: f64, share: f64, rest: f64) -> Option<(f64, f64, f64)> {
        let y = self.rate * (z - self.median);
        // The distances to the two ends over those of the median.
        let above_lower = 1.0 + rest * y;
        let below_upper = if self.outline.origin == 0.0 { 1.0 - share * y } else { -share * self.rate * z };
        if above_lower <= 0.0 || below_upper <= 0.0 {
            return None;
        }
        let t = if self.outline.origin == 0.0 {
            log1p(rest * y) - log1p(-share * y)
        } else {
            log(above_lower) - log(below_upper)
        };
        Some((t, 1.0 / (above_lower * below_upper), share / below_upper - rest / above_lower))
    }
}

impl HeightDistribution for Johnson {
    fn outline(&self) -> &Outline {
        &self.outline
    }

    fn log_density(&self, z: f64) -> f64 {
        match self.at(z) {
            Some(at) => -0.5 * at.u * at.u - LN_SQRT_2_PI + log(at.rate),
            None => f64::NEG_INFINITY,
        }
    }

    fn log_density_slope(&self, z: f64) -> f64 {
        self.at(z).map_or(0.0, |at| at.slope)
    }

    fn distance_to_singularity(&self, z: f64) -> f64 {
        match self.kind {
            CurveKind::Unbounded { below, above } => {
                let centre =
                    if self.outline.origin == 0.0 { self.median - 0.5 * (above - below) / self.rate } else { 0.0 };
                hypot(z - centre, (below * above).sqrt() / self.rate)
            }
            CurveKind::Bounded { .. } => {
                let (lower, upper) = self.outline.support;
                (z - lower).min(upper - z)
            }
        }
    }
}

/// A point of the curve.
struct At {
    u: f64,
    /// du/dz.
    rate: f64,
    /// d(ln phi)/dz.
    slope: f64,
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(skew: f64, kurtosis: f64) -> Johnson {
        check(skew, kurtosis).expect("a curve of the domain");
        Johnson::new(skew, kurtosis, fit::fit(skew, kurtosis))
    }

    /// S_U, S_B and the lognormal curve, with the mean and with their end as the origin.
    fn curves() -> Vec<Johnson> {
        let [lognormal, steep] = [0.4, 3.0].map(|skew| 3.0 + fit::excess_of_lognormal(skew));
        let moments = [(0.8, 6.0), (-0.9, 30.0), (-1.2, 5.8), (3.0, 22.0), (0.5, 3.3), (-0.8, 3.2), (0.2, 2.0)];
        moments
            .into_iter()
            .chain([(0.4, lognormal), (-0.4, lognormal), (-3.0, 1.0001 * steep)])
            .map(|(skew, kurtosis)| curve(skew, kurtosis))
            .collect()
    }

    /// They do to all digits next to the end that is the origin, and for nearly Gaussian heights.
    #[test]
    fn heights_and_scores_belong_together() {
        let nearly_gaussian = [3.0 + 1e-12, 3.0 - 1e-12].map(|kurtosis| (curve(0.0, kurtosis), 1e-14));
        for (curve, known) in curves().into_iter().map(|curve| (curve, 1e-9)).chain(nearly_gaussian) {
            let is_end = curve.outline.origin != 0.0;
            let far_up = [6.0, 12.0, 20.0].map(|u| (u, 1e-12 * u)).into_iter().filter(|_| is_end);
            for (u, known) in [-4.0, -2.0, -0.3, 0.0, 0.3, 2.0, 4.0].map(|u| (u, known)).into_iter().chain(far_up) {
                let at = curve.at(curve.height(u)).expect("a height");
                assert!((at.u - u).abs() < known, "{}, not {u}, of {curve:?}", at.u);
            }
        }
    }

    /// All over the domain, by a fine grid in the score, and at its corners.
    #[test]
    fn densities_have_one_maximum_and_vanish_at_their_ends() {
        for skew in [0.0, 0.1, 0.3, 0.6, 1.0, 1.5, 2.0, 2.5, 3.0] {
            for part in [0.0, 0.01, 0.1, 0.5, 1.0] {
                let curve = curve(skew, (1.0 - part) * least_kurtosis(skew) + part * LARGEST_KURTOSIS);
                let slope = |i: i32| curve.log_density_slope(curve.height(0.02 * f64::from(i)));
                let turns = (-300..300).filter(|&i| (slope(i) > 0.0) != (slope(i + 1) > 0.0)).count();
                assert!(turns == 1 && curve.epsilon <= 2.0, "{turns} of {curve:?}");
                let [below, above] = [-1e-6, 1e-6].map(|step| curve.log_density_slope(curve.outline.last_mode + step));
                assert!(below > 0.0 && above < 0.0, "{below} and {above} of {curve:?}");
            }
        }
    }
}
