//! Heights of Johnson's system of curves (Biometrika 36, 1949, 149-176): skew and kurtosis chosen independently.
//!
//! A function u(z) of height is normal: u = gamma + delta arsinh((z - xi)/lambda) for S_U, which has no end, and
//! u = gamma + delta ln((z - xi)/(xi + lambda - z)) for S_B, which has two; lognormal curves lie between them, and
//! the Gaussian is the limit of all. `fit` finds the curve; here it is standardised to mean 0 and standard deviation 1.

pub mod ends;
mod fit;

use super::Heights;
use crate::elementary::{exp, expm1, hypot, log, log1p};
use ends::Ends;
use fit::{Curve, Fit, Kind};

pub use fit::above_least;

/// The largest kurtosis that is evaluated: loads on heavier tails could not be represented.
pub const LARGEST_KURTOSIS: f64 = 1e10;

/// The upper end of the support is made the origin of heights where sums in the tail depend on the distance to it: where
/// less than this part of the distance from the mean is left at this u. The same goes for S_U where it nearly ends: it is
/// singular at y = -tau +- i (1 - tau^2)^(1/2). An origin farther than this many widths of the bulk would blur it.
const LEFT_AT_END: f64 = 0.1;
const FAR_UP: f64 = 12.0;
const FARTHEST_ORIGIN: f64 = 300.0;
/// exp of more is not needed.
const LARGEST_EXPONENT: f64 = 700.0;
/// The longest panel in u, and its largest change of ln phi, on which a normal density is a polynomial to rounding.
const LONGEST_PANEL: f64 = 1.5;
const STEEPEST_PANEL: f64 = 12.0;
/// The longest panel over its distance to where S_U and S_B are singular.
const FARTHEST_OF_POLE: f64 = 1.2;
const FARTHEST_OF_END: f64 = 1.0;

/// Heights beyond this have no normal score in any number that can be represented.
const FARTHEST: f64 = 1e100;
const MOST_HALVINGS: u32 = 60;

const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;

/// A standardised curve of Johnson's system.
#[derive(Debug, Clone, PartialEq)]
pub struct Johnson {
    skew: f64,
    kurtosis: f64,
    epsilon: f64,
    /// dv/dz, with v of `fit`.
    deviation: f64,
    kind: Kind,
    /// dy/dz, with y = epsilon v.
    rate: f64,
    /// Height of the median.
    median: f64,
    /// What is subtracted from heights above their mean.
    origin: f64,
    /// Where the density is largest; twice the same where it has one maximum.
    modes: [f64; 2],
}

/// The heights of a skew and a kurtosis within the range.
pub fn heights(skew: f64, kurtosis: f64) -> Heights {
    match fit::fit(skew, kurtosis) {
        Curve::Median(fit) if fit.epsilon == 0.0 => Heights::Gaussian,
        Curve::Median(fit) => Heights::Johnson(Box::new(Johnson::new(skew, kurtosis, fit))),
        Curve::Ends(fit) => Heights::Ends(Box::new(Ends::new(skew, kurtosis, &fit))),
    }
}

impl Johnson {
    fn new(skew: f64, kurtosis: f64, fit: Fit) -> Self {
        let Fit { epsilon, kind, mean, deviation } = fit;
        let rate = epsilon * deviation;
        let median = -mean / deviation;
        let mut curve =
            Self { skew, kurtosis, epsilon, deviation, kind, rate, median, origin: 0.0, modes: [median; 2] };
        let (end, away) = match kind {
            Kind::Unbounded { below, above } => (median + (below - 1.0) / rate, (below * above).sqrt() / rate),
            Kind::Bounded { .. } => (curve.support().1, 0.0),
        };
        if (end - curve.height(FAR_UP)).max(away) < LEFT_AT_END * end && end * deviation < FARTHEST_ORIGIN {
            curve.origin = end;
            curve.median -= end;
        }
        curve.modes = curve.find_modes();
        curve
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        self.skew
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// The height above the mean from which heights are measured.
    pub fn origin(&self) -> f64 {
        self.origin
    }

    /// The ends of the support.
    pub fn support(&self) -> (f64, f64) {
        match self.kind {
            Kind::Unbounded { .. } => (f64::NEG_INFINITY, f64::INFINITY),
            Kind::Bounded { share, rest } => {
                let head = if self.origin == 0.0 { self.median + 1.0 / (share * self.rate) } else { 0.0 };
                (self.median - 1.0 / (rest * self.rate), head)
            }
        }
    }

    /// ln phi.
    #[inline]
    pub fn log_density(&self, z: f64) -> f64 {
        match self.at(z) {
            Some(at) => -0.5 * at.u * at.u - LN_SQRT_2_PI + log(at.rate),
            None => f64::NEG_INFINITY,
        }
    }

    /// u at a height; infinite beyond the support.
    pub fn normal_score(&self, z: f64) -> f64 {
        match self.at(z.clamp(-FARTHEST, FARTHEST)) {
            Some(at) => at.u,
            None => f64::INFINITY.copysign(z - self.median),
        }
    }

    /// The height of a u.
    pub fn height(&self, u: f64) -> f64 {
        let t = (self.epsilon * u).clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT);
        match self.kind {
            Kind::Unbounded { below, above } if self.origin == 0.0 => {
                self.median + 0.5 * (above * expm1(t) - below * expm1(-t)) / self.rate
            }
            Kind::Unbounded { below, above } => 0.5 * (above * exp(t) - below * exp(-t)) / self.rate,
            Kind::Bounded { share, .. } if self.origin == 0.0 => {
                let rise = expm1(t);
                self.median + rise / (1.0 + share * rise) / self.rate
            }
            Kind::Bounded { share, .. } => -1.0 / (1.0 + share * expm1(t)) / (share * self.rate),
        }
    }

    /// The height at or above another where the density is largest, to the order of magnitude.
    pub fn peak_above(&self, start: f64) -> f64 {
        let higher = |a: f64, b: f64| if self.log_density(b) > self.log_density(a) { b } else { a };
        self.modes.iter().filter(|&&mode| mode > start).fold(start.max(-FARTHEST), |peak, &mode| higher(peak, mode))
    }

    /// u and what else the density takes; `None` beyond the support.
    #[inline]
    fn at(&self, z: f64) -> Option<At> {
        let (t, rate, slope) = match self.kind {
            Kind::Unbounded { below, above } => {
                // y + tau and its distance from where the curve is singular, as a complex number.
                let tau = 0.5 * (above - below);
                let y = self.rate * (z - self.median);
                let height = if self.origin == 0.0 { y + tau } else { self.rate * z };
                let distance = (height * height + below * above).sqrt();
                let t = match (self.origin == 0.0, height >= 0.0) {
                    (true, true) => log1p(y * (above + distance + height) / ((1.0 + distance) * above)),
                    (true, false) => -log1p(-y * (below + distance - height) / ((1.0 + distance) * below)),
                    (false, true) => log((height + distance) / above),
                    (false, false) => -log((distance - height) / below),
                };
                (t, 1.0 / distance, -height / (distance * distance))
            }
            Kind::Bounded { share, rest } => {
                let y = self.rate * (z - self.median);
                // The distances to the two ends over those of the median.
                let (above_foot, below_head) = (1.0 + rest * y, 1.0 - share * y);
                if self.origin == 0.0 {
                    if above_foot <= 0.0 || below_head <= 0.0 {
                        return None;
                    }
                    let t = log1p(rest * y) - log1p(-share * y);
                    (t, 1.0 / (above_foot * below_head), share / below_head - rest / above_foot)
                } else {
                    let below_head = -share * self.rate * z;
                    if above_foot <= 0.0 || below_head <= 0.0 {
                        return None;
                    }
                    let t = log(above_foot) - log(below_head);
                    (t, 1.0 / (above_foot * below_head), share / below_head - rest / above_foot)
                }
            }
        };
        let u = t / self.epsilon;
        let rate = self.deviation * rate;
        Some(At { u, rate, slope: self.rate * slope - u * rate })
    }

    /// Two maxima at most lie within epsilon of the median in u.
    fn find_modes(&self) -> [f64; 2] {
        const PARTS: i32 = 64;
        let at = |part: i32| {
            let z = self.height(self.epsilon * f64::from(part) / f64::from(PARTS));
            (z, self.log_density(z))
        };
        let mut modes = (-PARTS..=PARTS).filter_map(|part| {
            let (z, here) = at(part);
            (here >= at(part - 1).1 && here > at(part + 1).1).then_some(z)
        });
        let first = modes.next().unwrap_or(self.median);
        [first, modes.next().unwrap_or(first)]
    }

    /// The part of a range of heights whose contribution is above exp(-negligible) of the whole.
    pub fn worth_summing(&self, lower: f64, upper: f64, negligible: f64) -> (f64, f64) {
        let lowest = -hypot(self.normal_score(upper).min(0.0), (2.0 * negligible).sqrt());
        // Load grows as height^(3/2): as exp(1.5 epsilon u), or as far as the head.
        let growth = 2.0 * self.epsilon;
        let from = self.normal_score(lower).max(0.0);
        let mut highest = growth + hypot((from - growth).max(0.0), (2.0 * negligible).sqrt());
        if let Kind::Bounded { share, .. } = self.kind {
            let whole = 2.0 * log1p(1.0 / (self.epsilon * share));
            highest = highest.min(hypot(from, (2.0 * (negligible + whole)).sqrt()));
        }
        (lower.max(self.height(lowest)), upper.min(self.height(highest)))
    }

    /// How far above z one quadrature panel may reach.
    pub fn smooth_length(&self, z: f64) -> f64 {
        let mut length = self.height(self.normal_score(z) + LONGEST_PANEL) - z;
        for _ in 0..MOST_HALVINGS {
            if self.is_smooth(z, z + length) {
                break;
            }
            length *= 0.5;
        }
        length
    }

    /// Whether the density is a polynomial to rounding between two heights.
    pub fn is_smooth(&self, from: f64, to: f64) -> bool {
        let (Some(start), Some(end)) = (self.at(from), self.at(to)) else {
            return false;
        };
        let length = to - from;
        if end.u - start.u > LONGEST_PANEL * (1.0 + 1e-6)
            || length * start.slope.abs().max(end.slope.abs()) > STEEPEST_PANEL
        {
            return false;
        }
        match self.kind {
            Kind::Unbounded { below, above } => {
                let centre = if self.origin == 0.0 { self.median - 0.5 * (above - below) / self.rate } else { 0.0 };
                // The distance from the nearest point of the panel.
                let nearest = if from > centre { from - centre } else { (centre - to).max(0.0) };
                length <= FARTHEST_OF_POLE * hypot(nearest, (below * above).sqrt() / self.rate)
            }
            Kind::Bounded { .. } => {
                let (foot, head) = self.support();
                length <= FARTHEST_OF_END * (from - foot).min(head - to)
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
    use crate::gauss_legendre::nodes;

    fn curve(skew: f64, kurtosis: f64) -> Johnson {
        match heights(skew, kurtosis) {
            Heights::Johnson(curve) => *curve,
            other => panic!("{other:?}"),
        }
    }

    /// S_U, S_B and the lognormal curve, with the mean and with their end as the origin.
    fn curves() -> Vec<Johnson> {
        let [lognormal, steep] = [0.4, 3.0].map(|skew| 3.0 + fit::excess_of_lognormal(skew));
        let moments = [(0.8, 6.0), (-0.9, 30.0), (-1.2, 5.8), (3.0, 22.0), (0.5, 3.3), (-0.8, 3.2), (0.2, 1.75)];
        moments
            .into_iter()
            .chain([(0.4, lognormal), (-0.4, lognormal), (-3.0, 1.0001 * steep)])
            .map(|(s, k)| curve(s, k))
            .collect()
    }

    #[test]
    fn scores_densities_and_slopes_belong_together() {
        let mut kinds = [false; 4];
        for curve in curves() {
            let is_bounded = matches!(curve.kind, Kind::Bounded { .. });
            kinds[2 * usize::from(is_bounded) + usize::from(curve.origin == 0.0)] = true;
            let (foot, head) = curve.support();
            assert_eq!(is_bounded, foot.is_finite() || head.is_finite(), "{curve:?}");
            for u in [-4.0, -2.0, -0.3, 0.0, 0.3, 2.0, 4.0] {
                let z = curve.height(u);
                assert!(z > foot && z < head, "{z} of {curve:?}");
                let (at, step) = (curve.at(z).expect("a height"), 1e-5);
                assert!((at.u - u).abs() < 1e-9 && curve.normal_score(z) == at.u, "{}, not {u}, of {curve:?}", at.u);
                let width = curve.height(u + step) - curve.height(u - step);
                assert!((at.rate * width / (2.0 * step) - 1.0).abs() < 1e-6, "{} at {u} of {curve:?}", at.rate);
                let rise = curve.log_density(z + 0.5 * width) - curve.log_density(z - 0.5 * width);
                assert!((at.slope - rise / width).abs() < 1e-4 * at.rate, "{} at {u} of {curve:?}", at.slope);
                let normal = -0.5 * u * u - 0.5 * (2.0 * std::f64::consts::PI).ln();
                assert!((curve.log_density(z) - normal - at.rate.ln()).abs() < 1e-8, "{u} of {curve:?}");
            }
            // Next to the end that is the origin, all digits.
            for u in [6.0, 12.0, 20.0].into_iter().filter(|_| curve.origin != 0.0) {
                let score = curve.normal_score(curve.height(u));
                assert!((score - u).abs() < 1e-12 * u, "{score}, not {u}, of {curve:?}");
            }
            for (end, score) in
                [(foot, f64::NEG_INFINITY), (head, f64::INFINITY)].into_iter().filter(|(z, _)| z.abs() < 1e6)
            {
                let beyond = end + 1e-9 * score.signum();
                assert!(
                    curve.normal_score(beyond) == score && curve.log_density(beyond) == f64::NEG_INFINITY,
                    "{curve:?}"
                );
            }
        }
        assert_eq!(kinds, [true; 4]);
        // And to all digits where the curve is nearly Gaussian.
        for kurtosis in [3.0 + 1e-12, 3.0 - 1e-12] {
            let curve = curve(0.0, kurtosis);
            for u in [-3.0, -0.1, 0.1, 2.0] {
                let score = curve.normal_score(curve.height(u));
                assert!((score - u).abs() < 1e-14, "{score}, not {u}, of {curve:?}");
            }
        }
    }

    /// Only where little is left of it far up, and not where it is so far away that it would blur the bulk.
    #[test]
    fn the_end_is_the_origin_where_the_tail_depends_on_it() {
        let nearly_lognormal = |skew: f64, part: f64| (skew, (3.0 + fit::excess_of_lognormal(skew)) * (1.0 + part));
        for ((skew, kurtosis), is_end) in [
            ((0.8, 6.0), false),
            ((0.98, 4.63), false),
            ((11.62, 360.4), false),
            ((-0.5, 17.46), false),
            ((0.5, 3.3), true),
            ((-0.8, 3.2), true),
            ((9.77, 145.0), true),
            (nearly_lognormal(-1.0, 1e-3), true),
            (nearly_lognormal(-1.0, 1e-2), false),
            (nearly_lognormal(-3.0, 1e-10), true),
            (nearly_lognormal(-20.0, 1e-3), true),
            (nearly_lognormal(-20.0, 1e-2), false),
        ] {
            let curve = curve(skew, kurtosis);
            assert_eq!(curve.origin != 0.0, is_end, "{curve:?}");
            if is_end && matches!(curve.kind, Kind::Bounded { .. }) {
                assert_eq!(curve.support().1, 0.0, "{curve:?}");
            }
            if skew > -3.0 {
                let [total, mean, ..] = moments(&curve);
                assert!((total - 1.0).abs() < 5e-14 && mean.abs() < 5e-14, "{total}, {mean:e} of {curve:?}");
            }
            // Heights of u, and u of heights, also next to where S_U nearly ends.
            for u in [3.0, 6.0, 9.0, 12.0, 16.0].into_iter().filter(|_| curve.origin != 0.0) {
                let score = curve.normal_score(curve.height(u));
                assert!((score - u).abs() < 1e-13 * u, "{score}, not {u}, of {curve:?}");
            }
        }
    }

    /// Panels reach as far as they give the integral, are as steep and as near to where the curve is singular as they may,
    /// and no farther.
    #[test]
    fn panels_end_where_the_density_is_not_smooth() {
        for curve in curves() {
            let (foot, head) = curve.support();
            // Of S_U, how far from a height it is singular, which is where 1/rate vanishes.
            let distance = |z: f64| match curve.kind {
                Kind::Unbounded { .. } => {
                    FARTHEST_OF_POLE * curve.deviation / (curve.rate * curve.at(z).expect("a height").rate)
                }
                Kind::Bounded { .. } => FARTHEST_OF_END * (z - foot).min(head - z),
            };
            let is_smooth = |from: f64, to: f64| {
                let [start, end] = [from, to].map(|z| curve.at(z).expect("a height"));
                let nearest =
                    (0..=100).map(|i| distance(from + (to - from) * 0.01 * f64::from(i))).fold(f64::MAX, f64::min);
                end.u - start.u <= LONGEST_PANEL * (1.0 + 1e-6)
                    && (to - from) * start.slope.abs().max(end.slope.abs()) <= STEEPEST_PANEL
                    && to - from <= nearest
            };
            for i in -30..30 {
                let z = curve.height(0.25 * f64::from(i));
                let length = curve.smooth_length(z);
                assert!(is_smooth(z, z + 0.999 * length), "{z} of {curve:?}");
                for part in [0.1, 0.3, 0.5, 0.7, 1.0, 1.4, 1.9] {
                    let to = curve.height(0.25 * f64::from(i) + 0.8 * part * LONGEST_PANEL);
                    let found = curve.is_smooth(z, to);
                    let tells = is_smooth(z, to - 1e-3 * (to - z)) == is_smooth(z, to + 1e-3 * (to - z));
                    assert!(!tells || found == is_smooth(z, to), "{z} to {to}: {found} of {curve:?}");
                }
                let density = |x: f64| (curve.log_density(x) - curve.log_density(z)).exp();
                let sum = |from: f64, to: f64| nodes(from, to).map(|(x, weight)| weight * density(x)).sum::<f64>();
                let middle = z + 0.5 * length;
                let error = sum(z, z + length) / (sum(z, middle) + sum(middle, z + length)) - 1.0;
                assert!(error.abs() < 1e-10, "{error:e} from {z} of {curve:?}");
            }
        }
    }

    #[test]
    fn modes_are_where_the_density_is_largest() {
        for curve in curves() {
            let at = |u: f64| curve.log_density(curve.height(u));
            // All local maxima, on a finer grid.
            let maxima: Vec<f64> = (-4000..4000)
                .map(|i| 0.001 * f64::from(i))
                .filter(|&u| at(u) >= at(u - 0.001) && at(u) > at(u + 0.001))
                .collect();
            let scores = curve.modes.map(|mode| curve.normal_score(mode));
            assert_eq!(scores[0] == scores[1], maxima.len() == 1, "{scores:?}, {maxima:?}");
            for (score, maximum) in scores.iter().zip([maxima[0], maxima[maxima.len() - 1]]) {
                assert!((score - maximum).abs() < 0.02 * curve.epsilon + 0.001, "{scores:?}, {maxima:?} of {curve:?}");
            }
            let [first, last] = curve.modes;
            for start in [first - 0.1, 0.5 * (first + last), last, last + 0.1] {
                let above: Vec<f64> = [start, first, last].into_iter().filter(|&z| z >= start).collect();
                let best =
                    above.iter().copied().fold(
                        start,
                        |a, b| {
                            if curve.log_density(b) > curve.log_density(a) {
                                b
                            } else {
                                a
                            }
                        },
                    );
                assert_eq!(curve.peak_above(start), best, "{curve:?}");
            }
        }
        let two = curve(0.2, 1.75);
        assert!(two.modes[0] < two.modes[1]);
        assert_eq!((two.skew(), two.kurtosis()), (0.2, 1.75));
    }

    /// Moments of the density itself about its mean, on panels that are short in u.
    fn moments(curve: &Johnson) -> [f64; 5] {
        const PARTS: i32 = 4;
        let farthest = PARTS * (12.0 + 4.0 * curve.epsilon) as i32;
        let mut moments = [0.0; 5];
        for part in -farthest..farthest {
            let [from, to] = [part, part + 1].map(|i| curve.height(f64::from(i) / f64::from(PARTS)));
            for (z, weight) in nodes(from, to) {
                let mut term = weight * curve.log_density(z).exp();
                for moment in &mut moments {
                    *moment += term;
                    term *= z + curve.origin();
                }
            }
        }
        moments
    }

    /// The same of a curve about its ends, by masses; mean over skew^2 + 1 in what is above the least kurtosis.
    fn moments_about_ends(curve: &Ends) -> ([f64; 4], f64) {
        let (lower, upper) = (curve.logit_of_score(-12.0), curve.logit_of_score(12.0));
        let (first, last) = (lower.max(-80.0), upper.min(80.0));
        let skew = curve.skew();
        let (mut moments, mut above_least) = ([0.0; 4], 0.0);
        // Next to an end the place does not change.
        for (from, to, count) in [(lower, first, 100), (first, last, 1000), (last, upper, 100)] {
            let at = |i: i32| from + (to - from) * f64::from(i) / f64::from(count);
            for (logit, weight) in (0..count).flat_map(|i| nodes(at(i), at(i + 1))) {
                let z = curve.height(&curve.place(logit)) + curve.origin();
                let mass = weight * curve.mass(logit, 0.0);
                above_least += mass * (z * z - skew * z - 1.0).powi(2);
                let mut term = mass;
                for moment in &mut moments {
                    *moment += term;
                    term *= z;
                }
            }
        }
        (moments, above_least)
    }

    #[test]
    fn curves_about_their_ends_have_the_moments_they_were_made_from() {
        assert_moments_about_ends(&[1.0, -30.0]);
    }

    #[test]
    fn and_those_of_less_and_more_skew() {
        assert_moments_about_ends(&[0.0, 1e-6, -0.1, -3.0, 1e3, -3e4]);
    }

    /// Up to what rounds to skew^2 + 1. kurtosis - skew^2 - 1 is the mean square of z^2 - skew z - 1.
    fn assert_moments_about_ends(skews: &[f64]) {
        let mut worst = [0.0_f64; 2];
        for &skew in skews {
            let least: f64 = skew * skew + 1.0;
            for part in [1e-13, 1e-10, 1e-6, 1e-3, 0.02, 0.1, 0.25, 0.3, 0.35, 0.4, 0.45] {
                let kurtosis = f64::next_up(least * (1.0 + part));
                let Heights::Ends(curve) = heights(skew, kurtosis) else { continue };
                let ([total, mean, second, third], above_least) = moments_about_ends(&curve);
                let errors = [total - 1.0, mean, second - 1.0, (third - skew) / (1.0 + skew.abs())];
                let error = errors.iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
                // The heights of a double lose what is below 1e-16 of least.
                let excess = above_least / super::above_least(skew, kurtosis) - 1.0;
                worst = [worst[0].max(error), worst[1].max(excess.abs())];
                println!("{skew} {part} {errors:?} {excess:e}");
                assert!(
                    error < 1e-12 && excess.abs() < 1e-9,
                    "skew {skew}, kurtosis {kurtosis}: {errors:?}, {excess:e} of {curve:?}"
                );
            }
        }
        println!("worst {worst:?}");
    }

    #[test]
    fn the_density_has_the_moments_it_was_made_from() {
        assert_moments(&[-2.0, 0.3]);
    }

    #[test]
    fn and_that_of_less_and_more_skew() {
        assert_moments(&[-20.0, -5.0, -1.0, -0.1, -1e-4, 0.0, 1e-9, 1e-3, 1.0, 3.0, 8.0, 25.0]);
    }

    fn assert_moments(skews: &[f64]) {
        let mut worst = 0.0_f64;
        for &skew in skews {
            let smallest = 1.4 + 1.3 * skew * skew;
            let lognormal = 3.0 + fit::excess_of_lognormal(skew);
            let mut kurtoses = vec![smallest, 1000.0, lognormal, lognormal.next_down(), lognormal.next_up(), 3.0];
            for part in [1e-12, 1e-6, 1e-3, 0.1, 0.5, 0.9] {
                kurtoses.push(smallest + (lognormal - smallest) * part);
                kurtoses.push(lognormal - (lognormal - smallest) * part);
                kurtoses.push(lognormal * (1.0 + part));
                kurtoses.push(lognormal * (1000.0 / lognormal).powf(part));
            }
            for kurtosis in kurtoses {
                if kurtosis < smallest || kurtosis > 1000.0 {
                    continue;
                }
                let Heights::Johnson(curve) = heights(skew, kurtosis) else { continue };
                let [total, mean, second, third, fourth] = moments(&curve);
                let errors = [
                    total - 1.0,
                    mean,
                    second - 1.0,
                    (third - skew) / (1.0 + skew.abs()),
                    (fourth - kurtosis) / kurtosis,
                ];
                let error = errors.iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
                assert!(error < 5e-14, "skew {skew}, kurtosis {kurtosis}: {errors:?} of {curve:?}");
                worst = worst.max(error);
            }
        }
        println!("worst {worst:e}");
    }
}
