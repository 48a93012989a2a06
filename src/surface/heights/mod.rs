//! The distribution of summit heights, standardised: standard deviation 1, height z in sigma above an origin.
//!
//! A family gives its log density, its support, what of it may be left out, and how long a piece of the height axis
//! one quadrature panel may cover; the sums over the population need nothing else. The origin is the mean, but the
//! highest summit where sums in the upper tail depend on the distance to it.

pub mod johnson;
pub mod tabulated;
pub mod weibull;

use crate::elementary::{exp, exp_each, hypot, log};
use johnson::{ends::Ends, Johnson};
use tabulated::Tabulated;
use weibull::Weibull;

/// Contributions below exp(-NEGLIGIBLE) of the largest are left out of the sums.
const NEGLIGIBLE: f64 = 46.0;
/// Densities below exp of this are taken as zero.
pub const UNDERFLOW: f64 = -2000.0;
/// The largest change of ln phi over one panel: of a parabola, and of what may fall doubly exponentially.
const STEEPEST_GAUSSIAN_PANEL: f64 = 14.0;
const STEEPEST_PANEL: f64 = 10.0;
/// A cumulative hazard far out in the tail of Weibull heights.
const TAIL_HAZARD: f64 = 25.0;
/// How much more the latter may change where it is small beside the sum.
const MOST_ALLOWANCE: f64 = 10.0;
/// Beside this many e-folds of density, what load gains on the way to smaller densities is nothing.
const GROWTH_OF_LOAD: f64 = 5.0;

/// A height, with ln phi and the size of its slope there where the family's roughness depends on them.
#[derive(Debug, Clone, Copy)]
pub struct Steepness {
    z: f64,
    log_density: f64,
    slope: f64,
}

impl Steepness {
    /// Whether it is this height.
    pub fn is_at(&self, z: f64) -> bool {
        self.z == z
    }
}

/// A standardised height distribution.
#[derive(Debug, Clone, PartialEq)]
pub enum Heights {
    /// Eq (17).
    Gaussian,
    /// Eqs (18)-(21).
    ///
    /// Boxed, so that the compiler cannot evaluate ahead of the match what only Weibull heights have.
    Weibull(Box<Weibull>),
    /// Johnson's system.
    Johnson(Box<Johnson>),
    /// The part of it next to its edge, where summits gather at two heights.
    Ends(Box<Ends>),
    /// A measured density.
    Tabulated(Box<Tabulated>),
}

impl Heights {
    /// The height above the mean from which heights are measured.
    pub fn origin(&self) -> f64 {
        match self {
            Heights::Gaussian | Heights::Weibull(_) => 0.0,
            Heights::Johnson(johnson) => johnson.origin(),
            Heights::Ends(ends) => ends.origin(),
            Heights::Tabulated(table) => table.origin(),
        }
    }

    /// ln phi(z); minus infinity outside the support.
    #[inline]
    pub fn log_density(&self, z: f64) -> f64 {
        match self {
            Heights::Gaussian => {
                const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;
                -0.5 * z * z - LN_SQRT_2_PI
            }
            Heights::Weibull(weibull) => {
                if z > -weibull.mean() {
                    weibull.log_density(z).0
                } else {
                    f64::NEG_INFINITY
                }
            }
            Heights::Johnson(johnson) => johnson.log_density(z),
            Heights::Ends(ends) => ends.log_density(z),
            Heights::Tabulated(table) => log(table.density(z)),
        }
    }

    /// phi(z) exp(-log_scale) at z = `from` + `rise`, where ln phi(`from`) is `log_scale`, or that is 0.
    ///
    /// It has as many digits as `rise`, which may be a number of more digits than z.
    #[inline]
    pub fn relative_density(&self, from: f64, rise: f64, log_scale: f64) -> f64 {
        self.relative_density_each(from, [rise], log_scale)[0]
    }

    /// The same for each rise, side by side.
    #[inline]
    pub fn relative_density_each<const N: usize>(&self, from: f64, rises: [f64; N], log_scale: f64) -> [f64; N] {
        exp_each(match self {
            Heights::Gaussian => rises.map(|rise| -rise * (from + 0.5 * rise)),
            Heights::Weibull(weibull) if rises.iter().all(|rise| from + rise > -weibull.mean()) => {
                let (log_density, _) = weibull.log_density_and_hazard(rises.map(|rise| from + rise));
                log_density.map(|log_density| log_density - log_scale)
            }
            _ => rises.map(|rise| self.log_density(from + rise) - log_scale),
        })
    }

    /// Where the support begins; minus infinity if it is endless.
    pub fn foot(&self) -> f64 {
        match self {
            Heights::Gaussian => f64::NEG_INFINITY,
            Heights::Weibull(weibull) => -weibull.mean(),
            Heights::Johnson(johnson) => johnson.support().0,
            Heights::Ends(ends) => ends.ends()[0],
            Heights::Tabulated(table) => table.support().0,
        }
    }

    /// Where the support ends; infinity if it is endless.
    pub fn head(&self) -> f64 {
        match self {
            Heights::Gaussian | Heights::Weibull(_) => f64::INFINITY,
            Heights::Johnson(johnson) => johnson.support().1,
            Heights::Ends(ends) => ends.ends()[1],
            Heights::Tabulated(table) => table.support().1,
        }
    }

    /// The exponent p of phi ~ (z - foot)^p at the foot, where it is a power.
    pub fn power_at_foot(&self) -> Option<f64> {
        match self {
            Heights::Gaussian | Heights::Johnson(_) | Heights::Ends(_) | Heights::Tabulated(_) => None,
            Heights::Weibull(weibull) => Some(weibull.shape() - 1.0),
        }
    }

    /// What densities are taken relative to where this height is the reference: ln phi there, but for a spike.
    pub fn log_scale(&self, z: f64) -> f64 {
        match self {
            Heights::Ends(ends) => ends.log_scale(z),
            _ => self.log_density(z),
        }
    }

    /// The part of a range of heights that is not negligible beside the rest of it.
    pub fn worth_summing(&self, lower: f64, upper: f64) -> (f64, f64) {
        match self {
            Heights::Gaussian => {
                let (near_lower, near_upper) = (lower.max(0.0), upper.min(0.0));
                (
                    lower.max(-hypot(near_upper, (2.0 * NEGLIGIBLE).sqrt())),
                    upper.min(hypot(near_lower, (2.0 * NEGLIGIBLE).sqrt())),
                )
            }
            Heights::Weibull(weibull) => {
                // Load grows as height^(3/2), which for a heavy tail competes with the density.
                let growth = 2.0 / weibull.shape() * log(NEGLIGIBLE);
                let highest = weibull.height_of_hazard(weibull.hazard(lower) + NEGLIGIBLE + growth);
                let hazard = weibull.hazard(upper).min(1.0) * exp(-NEGLIGIBLE);
                let lowest = weibull.height_of_hazard(hazard.max(f64::MIN_POSITIVE));
                // Where a power-law foot holds a part that is not negligible, the range begins there.
                let is_foot = lowest + weibull.mean() < 0.01;
                (if is_foot { lower } else { lower.max(lowest) }, upper.min(highest))
            }
            Heights::Johnson(johnson) => johnson.worth_summing(lower, upper, NEGLIGIBLE),
            Heights::Ends(_) | Heights::Tabulated(_) => (lower.max(self.foot()), upper.min(self.head())),
        }
    }

    /// The foot, or a height below which the density cannot be represented.
    pub fn far_foot(&self) -> f64 {
        match self {
            Heights::Gaussian => -self.far_tail(),
            Heights::Weibull(weibull) => -weibull.mean(),
            Heights::Johnson(johnson) => johnson.height(-(-2.0 * UNDERFLOW).sqrt()),
            Heights::Ends(ends) => ends.ends()[0],
            Heights::Tabulated(table) => table.support().0,
        }
    }

    /// A height above which the density cannot be represented.
    pub fn far_tail(&self) -> f64 {
        match self {
            Heights::Gaussian => (-2.0 * UNDERFLOW).sqrt(),
            Heights::Weibull(weibull) => weibull.height_of_hazard(-UNDERFLOW),
            Heights::Johnson(johnson) => johnson.height((-2.0 * UNDERFLOW).sqrt()),
            Heights::Ends(ends) => ends.ends()[1],
            Heights::Tabulated(table) => table.support().1,
        }
    }

    /// The height at or above another where the density is largest, to the order of magnitude.
    pub fn peak_above(&self, start: f64) -> f64 {
        match self {
            Heights::Gaussian => start.max(0.0),
            Heights::Weibull(weibull) => {
                // The mode; the foot where the shape is 1.
                start.max(weibull.height_of_hazard(1.0 - 1.0 / weibull.shape()))
            }
            Heights::Johnson(johnson) => johnson.peak_above(start),
            Heights::Ends(ends) => ends.peak_above(start),
            Heights::Tabulated(table) => table.peak_above(start),
        }
    }

    /// Whether ln phi is concave.
    pub fn is_log_concave(&self) -> bool {
        matches!(self, Heights::Gaussian | Heights::Weibull(_))
    }

    /// The heights at which the density is not smooth, none or many.
    pub fn knots(&self) -> &[f64] {
        match self {
            Heights::Tabulated(table) => table.knots(),
            Heights::Ends(ends) => ends.ends(),
            _ => &[],
        }
    }

    /// How far above z one quadrature panel may reach, in a sum whose largest ln phi is `log_scale`.
    pub fn smooth_length(&self, z: f64, log_scale: f64) -> f64 {
        let mut length = self.longest_panel();
        match self {
            Heights::Johnson(johnson) => return johnson.smooth_length(z),
            Heights::Tabulated(table) => return table.smooth_length(z),
            // Panels in another variable.
            Heights::Ends(_) => return f64::MAX,
            Heights::Gaussian | Heights::Weibull(_) => {}
        }
        let from = self.steepness(z);
        if let Heights::Weibull(_) = self {
            // Longer ones are too steep at their beginning.
            let longest = SHORTEST_PANEL.max((STEEPEST_PANEL + MOST_ALLOWANCE) / from.slope);
            while length > longest {
                length *= 0.75;
            }
        }
        while length > SHORTEST_PANEL && self.roughness(&from, &self.steepness(z + length), log_scale) > 1.0 {
            length *= 0.75;
        }
        length
    }

    /// No panel that reaches down from z need be tried that is longer than this.
    pub fn longest_below(&self, z: f64) -> f64 {
        match self {
            Heights::Gaussian | Heights::Weibull(_) | Heights::Ends(_) => 1.0,
            Heights::Johnson(johnson) => johnson.smooth_length(z).max(1.0),
            Heights::Tabulated(table) => table.smooth_length_below(z),
        }
    }

    /// What [`Heights::roughness`] needs to know of a height.
    pub fn steepness(&self, z: f64) -> Steepness {
        #[cfg(test)]
        tests::EVALUATIONS.set(tests::EVALUATIONS.get() + 1);
        let (log_density, slope) = match self {
            Heights::Gaussian => (self.log_density(z), z),
            Heights::Weibull(weibull) => weibull.log_density(z),
            _ => (f64::NAN, f64::NAN),
        };
        Steepness { z, log_density, slope: slope.abs() }
    }

    /// How much the density changes from one height to another, in such a sum; up to 1 one quadrature panel may reach
    /// from the one to the other.
    pub fn roughness(&self, from: &Steepness, to: &Steepness, log_scale: f64) -> f64 {
        let length = to.z - from.z;
        let change = length * from.slope.max(to.slope);
        // What is small beside the sum needs fewer digits; but load grows with height where the density falls.
        let drop = (log_scale - from.log_density.max(to.log_density) - GROWTH_OF_LOAD).max(0.0);
        match self {
            Heights::Gaussian => change / (STEEPEST_GAUSSIAN_PANEL + drop),
            Heights::Weibull(weibull) if length > 2.0 * (from.z + weibull.mean()) => f64::MAX,
            Heights::Weibull(_) => change / (STEEPEST_PANEL + (0.5 * drop).min(MOST_ALLOWANCE)),
            Heights::Johnson(johnson) if !johnson.is_smooth(from.z, to.z) => f64::MAX,
            Heights::Tabulated(table) if !table.is_smooth(from.z, to.z) => f64::MAX,
            _ => (length / self.smooth_length(from.z, log_scale)).min(1.0),
        }
    }

    /// The longest panel, in sigma, on which the density is a polynomial to rounding where it is not steep.
    pub fn longest_panel(&self) -> f64 {
        match self {
            Heights::Gaussian => 3.0,
            Heights::Weibull(_) => 2.5,
            _ => 1.5,
        }
    }

    /// A panel that is short enough wherever it lies, steep tails included.
    pub fn tail_panel(&self) -> f64 {
        match self {
            Heights::Weibull(weibull) => {
                let (_, slope) = weibull.log_density(weibull.height_of_hazard(TAIL_HAZARD));
                self.longest_panel().min(STEEPEST_PANEL / slope.abs())
            }
            _ => 0.5 * self.longest_panel(),
        }
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        match self {
            Heights::Gaussian => 0.0,
            Heights::Weibull(weibull) => weibull.skew(),
            Heights::Johnson(johnson) => johnson.skew(),
            Heights::Ends(ends) => ends.skew(),
            Heights::Tabulated(table) => table.skew(),
        }
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        match self {
            Heights::Gaussian => 3.0,
            Heights::Weibull(weibull) => weibull.kurtosis(),
            Heights::Johnson(johnson) => johnson.kurtosis(),
            Heights::Ends(ends) => ends.kurtosis(),
            Heights::Tabulated(table) => table.kurtosis(),
        }
    }
}

/// The shortest panel, in sigma: what lies within it of a singular point is negligible.
pub const SHORTEST_PANEL: f64 = 1e-8;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gauss_legendre::nodes;
    use std::cell::Cell;

    thread_local! {
        /// Of steepness, by this thread.
        pub static EVALUATIONS: Cell<usize> = const { Cell::new(0) };
    }

    fn weibull(shape: f64) -> Heights {
        Heights::Weibull(Box::new(Weibull::new(shape)))
    }

    fn table() -> Heights {
        Heights::Tabulated(Box::new(Tabulated::new(&[0.0, 1.0, 2.0, 4.0], &[1.0, 3.0, 1.0, 2.0]).expect("a table")))
    }

    /// Panels from a height to another in a sum of this scale: how many, and the density's integral, times z, times z^2.
    fn march(heights: &Heights, (from, to): (f64, f64), log_scale: f64) -> (usize, [f64; 3]) {
        let (mut z, mut count, mut sums) = (from, 0, [0.0; 3]);
        while z < to {
            let length = heights.smooth_length(z, log_scale).min(to - z);
            for (x, weight) in nodes(z, z + length) {
                let mut term = weight * heights.log_density(x).exp();
                for sum in &mut sums {
                    *sum += term;
                    term *= x + heights.origin();
                }
            }
            z += length;
            count += 1;
        }
        (count, sums)
    }

    /// With all digits everywhere, and with those that a sum of all heights needs.
    #[test]
    fn panels_give_the_moments_of_heights_to_rounding_and_are_few() {
        for (heights, most) in [
            (Heights::Gaussian, [11, 7]),
            (weibull(3.0), [22, 20]),
            (weibull(40.0), [16, 14]),
            (johnson::heights(0.8, 6.0), [24, 24]),
            (johnson::heights(-0.9, 30.0), [37, 37]),
            (johnson::heights(0.5, 3.3), [18, 18]),
            (johnson::heights(-0.8, 3.2), [33, 33]),
        ] {
            let largest = heights.log_density(heights.peak_above(-1.0 - heights.origin()));
            for (log_scale, most) in [f64::NEG_INFINITY, largest].into_iter().zip(most) {
                let (lower, upper) = heights.worth_summing(-1e4, 1e4);
                let range = (lower.max(heights.foot() + 1e-6), upper);
                let (count, [mass, mean, square]) = march(&heights, range, log_scale);
                assert!(count <= most, "{count} panels of {heights:?}");
                let error = (mass - 1.0).abs().max(mean.abs()).max((square - 1.0).abs());
                assert!(error < 2e-14, "{error:e} of {heights:?}");
            }
        }
    }

    /// Of a load that grows as height^(3/2): 1e-18, and no panels are wasted on much less.
    #[test]
    fn what_is_left_out_is_negligible_and_little_else_is_summed() {
        for heights in [
            Heights::Gaussian,
            weibull(1.0),
            weibull(1.2),
            weibull(3.0),
            weibull(40.0),
            johnson::heights(0.8, 6.0),
            johnson::heights(0.0, 2.75),
            johnson::heights(0.5, 3.3),
            johnson::heights(1.0, 3.9),
            johnson::heights(20.0, 900.0),
            johnson::heights(100.0, 1.5e5),
        ] {
            for z in [-1.2, -0.5, 0.0, 1.0, 3.0] {
                let lower = (z - heights.origin()).max(heights.foot());
                let (_, upper) = heights.worth_summing(lower, f64::MAX);
                let (mut whole, mut beyond) = (0.0, 0.0);
                for i in 1..20_000 {
                    // By the cumulative hazard or by the normal score.
                    let (height, logarithm) = match &heights {
                        Heights::Weibull(weibull) => {
                            let rise = 0.01 * f64::from(i);
                            (weibull.height_of_hazard(weibull.hazard(lower) + rise), -rise)
                        }
                        _ => {
                            let u = 0.002 * f64::from(i) - 5.0;
                            let height = if let Heights::Johnson(johnson) = &heights { johnson.height(u) } else { u };
                            (height, -0.5 * u * u)
                        }
                    };
                    let load = (height - lower).max(0.0).powf(1.5) * logarithm.exp();
                    whole += load;
                    beyond += if height > upper { load } else { 0.0 };
                }
                let left = beyond / whole;
                assert!(left < 1e-18 && left > 1e-27, "{left:e} above {z} of {heights:?}");
            }
        }
    }

    #[test]
    fn the_length_of_a_panel_takes_few_evaluations() {
        for heights in [Heights::Gaussian, weibull(1.2), weibull(3.0), weibull(40.0), weibull(1e4)] {
            for z in [4.0, 5.0, 6.0, 8.0] {
                EVALUATIONS.set(0);
                heights.smooth_length(z, f64::NEG_INFINITY);
                assert!(EVALUATIONS.get() <= 6, "{} at {z} of {heights:?}", EVALUATIONS.get());
            }
        }
    }

    /// Far out it spans about as many e-folds as a panel may, if that is not longer than any.
    #[test]
    fn a_panel_of_the_tail_is_no_shorter_than_it_need_be() {
        for heights in [Heights::Gaussian, weibull(1.2), weibull(3.0), weibull(40.0)] {
            let z = match &heights {
                Heights::Weibull(weibull) => weibull.height_of_hazard(TAIL_HAZARD),
                _ => (2.0 * TAIL_HAZARD).sqrt(),
            };
            let length = heights.tail_panel();
            let change = length * heights.steepness(z).slope;
            assert!(change < 1.1 * STEEPEST_PANEL, "{change} of {heights:?}");
            assert!(length == heights.longest_panel() || change > 0.9 * STEEPEST_PANEL, "{change} of {heights:?}");
        }
    }

    /// Wherever it lies, beside all that is above.
    #[test]
    fn a_panel_of_the_tail_is_short_enough() {
        for heights in [Heights::Gaussian, weibull(1.2), weibull(3.0), weibull(40.0)] {
            let length = heights.tail_panel();
            assert!(length > 0.1 && length <= heights.longest_panel(), "{length} of {heights:?}");
            for z in [0.0, 1.0, 3.0, 6.0, 9.0] {
                let (_, upper) = heights.worth_summing(z, 1e4);
                if z + length > upper {
                    continue;
                }
                let density = |x: f64| heights.relative_density(z, x - z, heights.log_density(z));
                let whole: f64 = nodes(z, z + length).map(|(x, weight)| weight * density(x)).sum();
                let halves: f64 = [z, z + 0.5 * length]
                    .into_iter()
                    .flat_map(|from| nodes(from, from + 0.5 * length))
                    .map(|(x, weight)| weight * density(x))
                    .sum();
                assert!((whole / halves - 1.0).abs() < 1e-13, "{:e} at {z} of {heights:?}", whole / halves - 1.0);
            }
        }
    }

    #[test]
    fn roughness_says_how_far_a_panel_may_reach() {
        for heights in [Heights::Gaussian, weibull(1.2), weibull(3.0), weibull(40.0)] {
            for z in [-1.0, 0.0, 2.0, 5.0] {
                let from = heights.steepness(z);
                let length = heights.smooth_length(z, f64::NEG_INFINITY);
                let at = |part: f64| heights.roughness(&from, &heights.steepness(z + part * length), f64::NEG_INFINITY);
                assert!(from.is_at(z) && !from.is_at(z + 1e-9) && at(0.0) == 0.0, "{z} of {heights:?}");
                assert!(at(1.0) <= 1.0 && at(0.5) < at(1.0), "{z} of {heights:?}");
                let limit = length == heights.longest_panel();
                assert!(limit || at(1.4) > 1.0, "{z} of {heights:?}: {}", at(1.4));
            }
        }
        for heights in [johnson::heights(0.8, 6.0), table()] {
            let from = heights.steepness(0.2 - heights.origin());
            let length = heights.smooth_length(from.z, f64::NEG_INFINITY);
            let at =
                |part: f64| heights.roughness(&from, &heights.steepness(from.z + part * length), f64::NEG_INFINITY);
            assert!((at(0.25) - 0.25).abs() < 1e-12 && at(1.0 - 1e-9) <= 1.0, "{heights:?}");
            assert!(at(2.0) > 1.0, "{heights:?}");
        }
        let gathered = johnson::heights(0.3, 1.3);
        assert_eq!(gathered.smooth_length(-0.1, 0.0), f64::MAX);
        assert_eq!(gathered.longest_below(-0.1), 1.0);
        let middle = 0.5 * table().knots()[2];
        assert!((table().longest_below(middle) + middle).abs() < 1e-13);
        assert_eq!(Heights::Gaussian.longest_below(0.0), 1.0);
        assert!(johnson::heights(0.8, 6.0).longest_below(30.0) > 5.0);
    }

    #[test]
    fn densities_have_the_shapes_that_are_said() {
        let gathered = johnson::heights(0.3, 1.3);
        assert_eq!(gathered.knots(), [gathered.foot(), gathered.head()]);
        let reference = gathered.log_scale(-1e-9);
        assert!(reference < -1.0 && reference > -600.0 && gathered.log_scale(gathered.foot()) == 0.0, "{reference}");
        assert_eq!(Heights::Gaussian.log_scale(1.0), Heights::Gaussian.log_density(1.0));
        assert_eq!(weibull(1.0).peak_above(-9.0), weibull(1.0).foot());
        assert_eq!(johnson::heights(0.0, 3.0), Heights::Gaussian);
        assert!(Heights::Gaussian.knots().is_empty() && table().knots().len() == 4);
        for heights in [Heights::Gaussian, weibull(1.2), weibull(3.0), table(), johnson::heights(0.8, 6.0), gathered] {
            let at = |z: f64| heights.log_density(z);
            let gathers = matches!(heights, Heights::Ends(_));
            // The largest density above, but of spikes.
            let peak = heights.peak_above(-0.5 - heights.origin());
            let highest = (1..=100).map(|i| at(-0.5 - heights.origin() + 0.05 * f64::from(i))).fold(at(peak), f64::max);
            assert!(gathers || at(peak) > highest - 1e-2, "{} and {highest} of {heights:?}", at(peak));
            // Nowhere convex.
            let width = heights.head().min(8.0) - heights.foot().max(-8.0);
            let bends = |i: i32| {
                let z = heights.foot().max(-8.0) + width * f64::from(i) / 500.0;
                at(z - 0.01 * width) + at(z + 0.01 * width) - 2.0 * at(z) > 1e-9
            };
            assert_eq!(heights.is_log_concave(), !(10..490).any(bends), "{heights:?}");
            if let Some(power) = heights.power_at_foot() {
                let (near, far) = (at(heights.foot() + 1e-7), at(heights.foot() + 1e-5));
                assert!(((far - near) / 100.0_f64.ln() - power).abs() < 1e-3, "{power} of {heights:?}");
            } else {
                assert!(!matches!(heights, Heights::Weibull(_)));
            }
            let (from, rise) = (-0.4, 0.3);
            let quotient = (at(from + rise) - at(from)).exp();
            assert!((heights.relative_density(from, rise, at(from)) / quotient - 1.0).abs() < 1e-14, "{heights:?}");
        }
    }
}
