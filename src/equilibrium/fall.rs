//! The load minus the pull-off load next to pull-off, where the difference of two loads has too few digits: integrated from the slope
//! of the load, in pieces that are measured.

use super::{PullOff, FARTHEST_FALL};
use crate::numerics::quadrature::integrate_short;
use crate::population::Population;

/// Where the difference is this part of the pull-off load it is first compared with the integral.
const FIRST_COMPARED: f64 = 1e-3;
/// The difference and the integral agree to this, rounding apart; and a piece with its halves, relative to the fall from where it begins.
const AGREEMENT: f64 = 3e-8;
/// How well a load is known at worst, relative to what presses and what pulls. A larger difference is a layer next to pull-off, so thin
/// that all points of the pieces lie beyond it.
const NOISE: f64 = 1e-10;
/// A stretch that takes more pieces is not smooth: a shorter one is tried.
const MOST_PIECES_OF_FALL: usize = 40;

/// The fall of the load from separations near pull-off, in descending order, to pull-off.
#[derive(Debug, Clone)]
pub struct Fall {
    known: Vec<(f64, f64)>,
    /// Smaller parts of it are not resolved.
    resolution: f64,
}

impl Fall {
    /// As far from pull-off as the fall is not simply the difference of the loads.
    pub fn new(population: &Population, kinks: &[f64], pull_off: &PullOff) -> Self {
        let size = pull_off.sums.hertz_load - pull_off.sums.load_attracted - pull_off.load;
        let excess_at = |step: f64| population.at_separation(pull_off.separation - step).load() - pull_off.load;
        let mut step = population.range_of_adhesion().max(1.0);
        loop {
            step *= 0.5;
            let mut excess = excess_at(step);
            if excess > FIRST_COMPARED * -pull_off.load {
                continue;
            }
            let mut fall = Self { known: vec![(pull_off.separation, 0.0)], resolution: f64::EPSILON * size };
            if !fall.extend(population, kinks, pull_off.separation - step) {
                continue;
            }
            if fall.distance_from(excess) > AGREEMENT * excess + NOISE * size {
                continue;
            }
            // From a layer outwards again: with twice the distance the fall is four times as large at most.
            while 4.0 * excess < FIRST_COMPARED * -pull_off.load
                || fall.distance_from(excess) > AGREEMENT * excess && 4.0 * excess < FARTHEST_FALL * -pull_off.load
            {
                step *= 2.0;
                excess = excess_at(step);
                if !fall.extend(population, kinks, pull_off.separation - step) {
                    break;
                }
            }
            // Farther out the difference of the loads is as good, and takes one sum.
            let off = |&(known, fall): &(f64, f64)| (excess_at(pull_off.separation - known) - fall).abs();
            let noise = fall.known.iter().map(off).fold(0.0, f64::max);
            let needed = fall.known.partition_point(|(_, fall)| AGREEMENT * fall < noise);
            fall.known.truncate(needed + 1);
            return fall;
        }
    }

    /// How far the fall, as far as it is known, is from this.
    fn distance_from(&self, excess: f64) -> f64 {
        (self.known[self.known.len() - 1].1 - excess).abs()
    }

    /// The fall from a separation, if that is so near to pull-off that it is known.
    pub fn from(&self, population: &Population, separation: f64) -> Option<f64> {
        let before = self.known.partition_point(|&(known, _)| known > separation);
        let (known, fall) = self.known[before.saturating_sub(1)];
        (before < self.known.len()).then(|| fall + of_load(population, separation, known))
    }

    /// Makes it known as far as a separation; whether the load is so smooth that it takes few pieces.
    fn extend(&mut self, population: &Population, kinks: &[f64], to: f64) -> bool {
        let count = self.known.len();
        let nearest = self.known[count - 1].0;
        let kinks = kinks.iter().copied().filter(|&kink| kink > to && kink < nearest);
        // What is left of it, the nearest to pull-off last, each with what the load falls by.
        let mut ends: Vec<(f64, Option<f64>)> = std::iter::once(to).chain(kinks).map(|end| (end, None)).collect();
        while let Some((end, whole)) = ends.pop() {
            let (begin, fall) = self.known[self.known.len() - 1];
            let middle = 0.5 * (begin + end);
            let whole = whole.unwrap_or_else(|| of_load(population, end, begin));
            let near = of_load(population, middle, begin);
            let halves = near + of_load(population, end, middle);
            if (halves - whole).abs() <= AGREEMENT * (fall + halves).abs() + self.resolution {
                self.known.extend([(middle, fall + near), (end, fall + halves)]);
            } else if self.known.len() + ends.len() < count + MOST_PIECES_OF_FALL {
                ends.extend([(end, Some(halves - near)), (middle, Some(near))]);
            } else {
                self.known.truncate(count);
                return false;
            }
        }
        true
    }
}

/// By how much the load falls from one separation to another, between which its slope is smooth.
fn of_load(population: &Population, from: f64, to: f64) -> f64 {
    integrate_short(from, to, |separation| -population.at_separation(separation).load_slope)
}
