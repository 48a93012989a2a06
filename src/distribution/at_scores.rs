//! Asperities of a surface whose heights are not Gaussian, by the heights and slopes of the surface at normal scores.
//!
//! At each normal score g of its heights the surface is a Gaussian one of its own, with the standard deviation t(g) = dT/dg, T
//! the height at the score, and the mean square slope s(g) there. Its asperities lie at the scores g = 1.23 + 0.92 u, with u
//! normal, in a density that goes with s/t^2, and their radii go with t/s: `crate::params::spectrum` has what all of this is
//! for a Gaussian surface, where T = Sq g and s = Sdq^2.
//!
//! Between two heights of the table the score is a monotone cubic of height, and ln t and ln s are monotone cubics of the score;
//! beyond both ends T is straight, and t and s are constant. All of them have continuous slopes.

use super::gaussian::GAUSSIAN;
use super::{HeightDistribution, Outline, LN_SQRT_2_PI};
use crate::error::Error;
use crate::numerics::elementary::{exp, exp_each, log};
use crate::numerics::float_bits::finite;
use crate::numerics::hermite::{monotone_slope, Cubic};
use crate::numerics::quadrature::{nodes, POINTS};
use std::array::from_fn;
use std::sync::Arc;

/// How many scores there are, from -3 to 3.
pub const SCORES: usize = 13;
const LOWEST: f64 = -3.0;
const STEP: f64 = 0.5;
/// Mean and standard deviation of the scores of asperities: those of a Gaussian surface, over Sq.
pub const MEAN: f64 = 1.23;
pub const SPREAD: f64 = 0.92;
/// A surface is nowhere so flat that the standard deviation of its own is smaller, in Sq: it goes with the fourth power.
const FLATTEST: f64 = 0.15;
/// How far beyond the table, in scores, moments are summed.
const REACH: u32 = 12;
/// A height differs from the one before by at least this part of their range.
const NEAREST: f64 = 1e-6;
/// Slopes differ by no larger factor.
const LARGEST_SLOPE_RATIO: f64 = 1e4;
/// Cubics of cubics are summed in panels that are shorter by this.
const PART_OF_PANEL: f64 = 0.6;
/// Heights between two of the table at which the density is looked at.
const LOOKS: u32 = 64;

/// Monotone cubics from each score of the table to the next.
type Spline = [Cubic; SCORES - 1];

/// Standardised heights of such asperities, and their radii.
#[derive(Debug, Clone)]
pub struct AtScores {
    /// The heights of the table.
    knots: [f64; SCORES],
    /// The score between each and the next, and how it grows with height below and above all.
    scores: Spline,
    beyond: [f64; 2],
    /// ln s, the ln (t/s) of radii, and the ln (s/t^2) of the density of asperities.
    log_square_slope: Spline,
    log_ratio: Spline,
    log_count: Spline,
    /// The surface is flat where ln (t/s) and ln (s/t^2) together, which are -ln t but for a constant, are more than this.
    flat: f64,
    changes: [f64; SCORES + 1],
    /// The largest slope of the table, over which ln s is.
    steepest: f64,
    outline: Outline,
}

/// What a table says of its surface, in the units of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Whole {
    /// Root mean square height and gradient.
    pub height: f64,
    pub slope: f64,
    /// Mean above the mean plane, and standard deviation, of the heights of its asperities.
    pub mean: f64,
    pub deviation: f64,
    /// How many there are for one of a Gaussian surface of the same height and gradient.
    pub count: f64,
}

/// What the radius of an asperity follows from.
#[derive(Debug, Clone, Copy)]
pub struct Place {
    /// Its normal score u, and du/dz.
    pub score: f64,
    pub rate: f64,
    /// ln (t/s), and its slope by height.
    pub log_ratio: f64,
    pub log_ratio_rate: f64,
}

impl AtScores {
    /// The asperities of a surface with these heights, in any unit and from any origin, and root mean square gradients at the
    /// scores, with what they say of it.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for another number of scores, [`Error::InvalidEntry`] for heights that do not rise and slopes
    /// that are not positive.
    pub fn new(height: &[f64], slope: &[f64]) -> Result<(Self, Whole), Error> {
        let (height, slope) = checked(height, slope)?;
        // Heights as parts of the range, slopes as parts of the largest.
        let range = height[SCORES - 1] - height[0];
        let part = height.map(|h| (h - height[0]) / range);
        let steepest = slope.iter().fold(0.0_f64, |largest, &s| largest.max(s));
        let log_squares = slope.map(|s| 2.0 * log(s / steepest));
        let mut found = Self::joined(part, deviations(&part), log_squares);
        let [_, mean, square, square_slope] = found.surface_moments();
        let whole_height = (square - mean * mean).sqrt();
        let (log_height, log_square) = (log(whole_height), log(square_slope));
        found.log_ratio = found.log_ratio.map(|cubic| cubic.raised(log_square - log_height));
        found.log_count = found.log_count.map(|cubic| cubic.raised(2.0 * log_height - log_square));
        let [count, first, second] = found.moments(|z| [1.0, z, z * z]);
        let centre = first / count;
        let deviation = (second / count - centre * centre).sqrt();
        let whole = Whole {
            height: whole_height * range,
            slope: square_slope.sqrt() * steepest,
            mean: (centre - mean) * range,
            deviation: deviation * range,
            count,
        };
        found.knots = part.map(|z| (z - centre) / deviation);
        found.beyond = found.beyond.map(|rate| rate * deviation);
        found.scores = scores(&found.knots, found.beyond);
        found.log_count = found.log_count.map(|cubic| cubic.raised(-log(count)));
        found.flat = -log(count * FLATTEST * 2.0_f64.sqrt().sqrt());
        found.steepest = steepest;
        let [skew, kurtosis] = found.moments(|z| [z * z * z, z * z * z * z]);
        found.outline = Outline { last_mode: found.highest_rise(), skew, kurtosis, ..found.outline };
        found.changes = found.each_change();
        Ok((found, whole))
    }

    /// The root mean square slope of what is higher than a score.
    pub fn slope_above(&self, score: f64) -> f64 {
        let [share, square] = self.integrals(|z| {
            let [g, rate, _] = self.score(z);
            let density = if g > score { rate * exp(-0.5 * g * g) } else { 0.0 };
            [density, density * exp(at(&self.log_square_slope, g)[0])]
        });
        self.steepest * (square / share).sqrt()
    }

    /// The table joined by cubics, not yet standardised.
    fn joined(knots: [f64; SCORES], deviations: [f64; SCORES], log_square_slopes: [f64; SCORES]) -> Self {
        let beyond = [deviations[0], deviations[SCORES - 1]].map(|deviation| 1.0 / deviation);
        let log_deviation = spline(deviations.map(log));
        let log_square_slope = spline(log_square_slopes);
        let combined =
            |times: f64, plus: f64| from_fn(|i| log_deviation[i].combined(times, &log_square_slope[i], plus));
        Self {
            knots,
            scores: scores(&knots, beyond),
            beyond,
            log_square_slope,
            log_ratio: combined(1.0, -1.0),
            log_count: combined(-2.0, 1.0),
            flat: f64::INFINITY,
            steepest: 1.0,
            changes: [0.0; SCORES + 1],
            outline: Outline { is_log_concave: false, part_of_panel: PART_OF_PANEL, ..GAUSSIAN },
        }
    }

    /// How many heights of the table are below one.
    #[inline]
    fn below(&self, z: f64) -> usize {
        // Steps of a search without branches.
        [8, 4, 2, 1].into_iter().fold(0, |below, step| match self.knots.get(below + step - 1) {
            Some(&knot) if knot < z => below + step,
            _ => below,
        })
    }

    /// The score g at a height, and its first and second derivative.
    #[inline]
    pub fn score(&self, z: f64) -> [f64; 3] {
        let straight = |i: usize, rate: f64| [table_score(i) + rate * (z - self.knots[i]), rate, 0.0];
        match self.below(z) {
            0 => straight(0, self.beyond[0]),
            SCORES => straight(SCORES - 1, self.beyond[1]),
            next => self.scores[next - 1].rates(z),
        }
    }

    /// What the radius at a height follows from.
    #[inline]
    pub fn place(&self, z: f64) -> Place {
        let [g, rate, _] = self.score(z);
        let [log_ratio, by_score, _] = at(&self.log_ratio, g);
        Place { score: (g - MEAN) / SPREAD, rate: rate / SPREAD, log_ratio, log_ratio_rate: by_score * rate }
    }

    /// Whether the surface is as flat there as [`FLATTEST`] says, with which its own heights are no longer those of the table.
    pub fn is_flat(&self, z: f64) -> bool {
        let [g, ..] = self.score(z);
        at(&self.log_count, g)[0] + at(&self.log_ratio, g)[0] > self.flat
    }

    /// The logarithm of the density by u at a height, and du/dz.
    #[inline]
    fn log_count(&self, z: f64) -> (f64, f64) {
        let [g, rate, _] = self.score(z);
        let u = (g - MEAN) / SPREAD;
        (at(&self.log_count, g)[0] - 0.5 * u * u - LN_SQRT_2_PI, rate / SPREAD)
    }

    /// How far it is from one height of the table to the next around z; below all of them to the first, or between the first two if that is
    /// more, and infinite above.
    pub fn width(&self, z: f64) -> f64 {
        match self.knots.partition_point(|&knot| knot <= z) {
            0 => (self.knots[0] - z).max(self.knots[1] - self.knots[0]),
            SCORES => f64::INFINITY,
            next => self.knots[next] - self.knots[next - 1],
        }
    }

    /// By how many e-folds radii, density and du/dz change, one way and back, between the heights of the table around z.
    pub fn change(&self, z: f64) -> f64 {
        self.changes[self.below(z)]
    }

    /// The same of each stretch between two, and beyond the ends.
    fn each_change(&self) -> [f64; SCORES + 1] {
        from_fn(|i| match i {
            0 | SCORES => 0.0,
            _ => {
                let rates = [0.0, 0.5, 1.0].map(|part| {
                    let z = self.knots[i - 1] + part * (self.knots[i] - self.knots[i - 1]);
                    log(self.scores[i - 1].rates(z)[1])
                });
                let turn = (rates[1] - rates[0]).abs() + (rates[2] - rates[1]).abs();
                turn + self.log_ratio[i - 1].change() + self.log_count[i - 1].change()
            }
        })
    }

    /// The largest du/dz at a height of the table.
    pub fn steepest(&self) -> f64 {
        self.knots.iter().map(|&z| self.score(z)[1] / SPREAD).fold(0.0, f64::max)
    }

    /// The integrals of the density of asperities times functions of height.
    fn moments<const N: usize>(&self, of: impl Fn(f64) -> [f64; N]) -> [f64; N] {
        self.integrals(|z| {
            let density = exp(self.log_density(z));
            of(z).map(|value| density * value)
        })
    }

    /// The mean over the surface of 1, height, its square, and the square of the slope.
    fn surface_moments(&self) -> [f64; 4] {
        self.integrals(|z| {
            let [g, rate, _] = self.score(z);
            let density = rate * exp(-0.5 * g * g - LN_SQRT_2_PI);
            [density, density * z, density * z * z, density * exp(at(&self.log_square_slope, g)[0])]
        })
    }

    fn integrals<const N: usize>(&self, of: impl Fn(f64) -> [f64; N]) -> [f64; N] {
        let [below, above] = self.beyond.map(|rate| 1.0 / rate);
        let last = self.knots[SCORES - 1];
        let lower = (0..REACH).map(|i| self.knots[0] - below * f64::from(REACH - i));
        let upper = (0..=REACH).map(|i| last + above * f64::from(i));
        let ends: Vec<f64> = lower.chain(self.knots[..SCORES - 1].iter().copied()).chain(upper).collect();
        let mut sums = [0.0; N];
        for ends in ends.windows(2) {
            let middle = 0.5 * (ends[0] + ends[1]);
            for (z, weight) in nodes(ends[0], middle).chain(nodes(middle, ends[1])) {
                sums.iter_mut().zip(of(z)).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        sums
    }

    /// A height above which the density only falls.
    fn highest_rise(&self) -> f64 {
        let looks = |i: usize| {
            let (from, to) = (self.knots[i], self.knots[i + 1]);
            (0..LOOKS).rev().map(move |look| from + (to - from) * f64::from(look) / f64::from(LOOKS))
        };
        let mut above = self.knots[SCORES - 1];
        if self.log_density_slope(above) >= 0.0 {
            // The scores of asperities are normal there.
            return above + (MEAN - table_score(SCORES - 1)).max(0.0) / self.beyond[1];
        }
        for z in (0..SCORES - 1).rev().flat_map(looks) {
            if self.log_density_slope(z) >= 0.0 {
                return above;
            }
            above = z;
        }
        // Where scores are straight they are those of a normal density.
        self.knots[0]
    }
}

/// The standard deviation at each score, of heights that rise: by the heights before and after it.
pub fn deviations(height: &[f64; SCORES]) -> [f64; SCORES] {
    let rises: [f64; SCORES] = from_fn(|i| {
        let (below, above) = (i.saturating_sub(1), (i + 1).min(SCORES - 1));
        (height[above] - height[below]) / (STEP * (above - below) as f64)
    });
    // How flat a surface may be depends on its root mean square height, which that hardly changes.
    let [_, mean, square, _] = AtScores::joined(*height, rises, [0.0; SCORES]).surface_moments();
    let least = FLATTEST * (square - mean * mean).sqrt();
    rises.map(|rise| (rise.powi(4) + least.powi(4)).sqrt().sqrt())
}

/// The score of an entry of the table.
pub fn table_score(index: usize) -> f64 {
    LOWEST + STEP * index as f64
}

/// Scores between heights.
fn scores(knots: &[f64; SCORES], beyond: [f64; 2]) -> Spline {
    let secant = |i: usize| (knots[i + 1] - knots[i], STEP / (knots[i + 1] - knots[i]));
    let slope = |i: usize| match i {
        0 => beyond[0],
        _ if i == SCORES - 1 => beyond[1],
        _ => monotone_slope(secant(i - 1), secant(i)),
    };
    let point = |i: usize| (knots[i], table_score(i), slope(i));
    from_fn(|i| Cubic::new(point(i), point(i + 1)))
}

/// Values at the scores, joined by cubics that are level at the ends.
fn spline(values: [f64; SCORES]) -> Spline {
    let secant = |i: usize| (STEP, (values[i + 1] - values[i]) / STEP);
    let slope = |i: usize| if i == 0 || i == SCORES - 1 { 0.0 } else { monotone_slope(secant(i - 1), secant(i)) };
    let point = |i: usize| (table_score(i), values[i], slope(i));
    from_fn(|i| Cubic::new(point(i), point(i + 1)))
}

/// A spline at a score, with its derivatives; as at the nearest end beyond them.
#[inline]
fn at(spline: &Spline, g: f64) -> [f64; 3] {
    let place = (g - LOWEST) / STEP;
    match place {
        _ if place <= 0.0 => [spline[0].at(LOWEST), 0.0, 0.0],
        _ if place >= (SCORES - 1) as f64 => [spline[SCORES - 2].at(table_score(SCORES - 1)), 0.0, 0.0],
        _ => spline[place as usize].rates(g),
    }
}

impl HeightDistribution for AtScores {
    fn outline(&self) -> &Outline {
        &self.outline
    }

    fn log_density(&self, z: f64) -> f64 {
        let (log_count, rate) = self.log_count(z);
        log_count + log(rate)
    }

    fn log_density_slope(&self, z: f64) -> f64 {
        let [g, rate, bend] = self.score(z);
        rate * (at(&self.log_count, g)[1] - (g - MEAN) / (SPREAD * SPREAD)) + bend / rate
    }

    /// Nodes beyond those that are needed repeat one.
    fn densities(&self, z: [f64; POINTS]) -> [f64; POINTS] {
        let (mut logs, mut rates) = ([f64::NEG_INFINITY; POINTS], [0.0; POINTS]);
        for i in 0..POINTS {
            let is_repeated = i > 0 && z[i] == z[i - 1];
            (logs[i], rates[i]) = if is_repeated { (logs[i - 1], rates[i - 1]) } else { self.log_count(z[i]) };
        }
        let densities = exp_each(logs);
        from_fn(|i| densities[i] * rates[i])
    }

    /// Where dg/dz is 0.
    fn distance_to_singularity(&self, z: f64) -> f64 {
        match self.below(z) {
            0 | SCORES => f64::INFINITY,
            next => self.scores[next - 1].distance_to_turn(z),
        }
    }

    fn breakpoints(&self) -> &[f64] {
        &self.knots
    }

    fn at_scores(self: Arc<Self>) -> Option<Arc<AtScores>> {
        Some(self)
    }
}

/// A table that has a meaning.
fn checked(height: &[f64], slope: &[f64]) -> Result<([f64; SCORES], [f64; SCORES]), Error> {
    let table = |name, numbers: &[f64]| {
        let allowed = "must have 13 numbers, one for each normal score from -3 to 3 in steps of 0.5";
        numbers.try_into().map_err(|_| Error::invalid(name, numbers.len() as f64, allowed))
    };
    let (height, slope): ([f64; SCORES], [f64; SCORES]) =
        (table("heights_at_scores", height)?, table("slopes_at_scores", slope)?);
    let range = height[SCORES - 1] - height[0];
    let steepest = slope.iter().fold(0.0_f64, |largest, &s| largest.max(s));
    for index in 0..SCORES {
        let entry = |name, value: f64, allowed| Err(Error::InvalidEntry { name, index, value, allowed });
        let (h, s) = (height[index], slope[index]);
        if !finite(h) || !finite(range) {
            return entry("heights_at_scores", h, "must be finite");
        }
        if index > 0 && (h - height[index - 1] < NEAREST * range || h <= height[index - 1]) {
            return entry("heights_at_scores", h, "must be greater than the height before it, by 1e-6 of their range");
        }
        if !finite(s) || s <= 0.0 || s * LARGEST_SLOPE_RATIO < steepest {
            return entry("slopes_at_scores", s, "must be finite, > 0, and at least 1e-4 of the largest");
        }
    }
    Ok((height, slope))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gaussian() -> ([f64; SCORES], [f64; SCORES]) {
        (from_fn(|i| 7.0 + 2.0 * table_score(i)), [0.1; SCORES])
    }

    /// But for how flat a surface may be at most: t/Sq is (1 + 0.15^4)^(1/4), and that is 1.00013.
    #[test]
    fn straight_heights_and_equal_slopes_are_those_of_a_gaussian_surface() {
        let (height, slope) = gaussian();
        let (table, whole) = AtScores::new(&height, &slope).expect("a table");
        let flat = (1.0 + FLATTEST.powi(4)).sqrt().sqrt();
        let expected = [2.0, 0.1, 2.0 * MEAN, 2.0 * SPREAD, 1.0];
        for (found, expected) in
            [whole.height, whole.slope, whole.mean, whole.deviation, whole.count].into_iter().zip(expected)
        {
            assert!((found / expected - 1.0).abs() < 2.1 * (flat - 1.0), "{found}, not {expected}");
        }
        for z in [-6.0, -1.0, 0.0, 0.3, 2.0, 5.0] {
            let place = table.place(z);
            assert!(
                (place.score - z).abs() < 1e-3 * (1.0 + z.abs()) && place.log_ratio.abs() < 1e-3,
                "{place:?} at {z}"
            );
            assert!((table.log_density(z) + 0.5 * z * z + LN_SQRT_2_PI).abs() < 2e-3 * (1.0 + z * z));
        }
    }

    #[test]
    fn a_table_without_a_meaning_is_refused_by_its_entry() {
        let (height, slope) = gaussian();
        let refused = |change: fn(&mut Vec<f64>, &mut Vec<f64>)| {
            let (mut height, mut slope) = (height.to_vec(), slope.to_vec());
            change(&mut height, &mut slope);
            AtScores::new(&height, &slope).map(|_| ()).expect_err("no table").to_string()
        };
        for (change, says) in [
            ((|h, _| h.swap(3, 4)) as fn(&mut Vec<f64>, &mut Vec<f64>), "heights_at_scores[4]"),
            (|h, _| h[12] = f64::NAN, "heights_at_scores"),
            (|h, _| h.truncate(12), "13 numbers"),
            (|_, s| s[2] = 0.0, "slopes_at_scores[2]"),
            (|_, s| s.push(0.1), "13 numbers"),
        ] {
            let message = refused(change);
            assert!(message.contains(says), "{message}");
        }
    }
}
