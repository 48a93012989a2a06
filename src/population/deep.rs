//! The sums at separations far below the heights, with equal radii: there the law of contact is so smooth across all heights
//! that its values at few of them, weighted with the density, give the sums.
//!
//! Friction has kinks where the contact radius is one of the slip law's. It is summed as if the regime of the lowest summit
//! held for all; to this comes, above each kink, what the next regime adds.

use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::contact::{Contact, KINKS};
use crate::asperity::slip::Slip;
use crate::distribution::panel::{self, FootPanel};
use crate::distribution::HeightDistribution;
use crate::elementary::exp;
use crate::numerics::quadrature::{self, POINTS};

/// How far above break-away the lowest summit is, over the range of heights: a polynomial through the points then follows
/// the law of contact to rounding.
const LEAST_CLEARANCE: f64 = 2.0;
/// Heights above which less than this part of all lies are left out.
const NEGLIGIBLE: f64 = 1e-19;
/// No distribution needs as many panels.
const MOST_PANELS: usize = 6000;

/// Points among the heights with their weights.
#[derive(Debug, Clone)]
pub struct DeepRule {
    /// The range of the heights that count.
    lowest: f64,
    highest: f64,
    /// Gauss points of the range.
    heights: [f64; POINTS],
    /// The integrals of the density times the polynomial that is 1 at one point and 0 at the others.
    weights: [f64; POINTS],
    /// The smallest overlap at which a contact holds, and those at the radii of the slip law.
    break_away: f64,
    kinks: [f64; 2],
    /// Those at which the law of contact itself is not smooth.
    kinks_of_contact: [f64; KINKS],
}

impl DeepRule {
    /// The rule of a population of equal radii.
    pub fn new(population: &Population) -> Self {
        let density = sampled(&*population.heights, population.lower_cut, population.highest);
        let lowest = population.lower_cut;
        let highest = density.last().map_or(lowest, |&(z, _)| z);
        let heights: [f64; POINTS] = {
            let mut nodes = quadrature::nodes(lowest, highest);
            std::array::from_fn(|_| nodes.next().unwrap_or_default().0)
        };
        let weight = |point: usize| {
            let polynomial = |z: f64| -> f64 {
                let others = heights.iter().enumerate().filter(|&(other, _)| other != point);
                others.map(|(_, other)| (z - other) / (heights[point] - other)).product()
            };
            density.iter().map(|&(z, fraction)| fraction * polynomial(z)).sum()
        };
        let break_away = population.law.break_away(1.0).overlap;
        let kinks =
            population.slip.kinks().map(|radius| population.overlap_at_radius(radius, 1.0).unwrap_or(break_away));
        let kinks_of_contact = population.kinks_of_contact;
        Self { lowest, highest, heights, weights: std::array::from_fn(weight), break_away, kinks, kinks_of_contact }
    }

    /// Whether the rule is good at a separation.
    pub fn covers(&self, separation: f64) -> bool {
        let clearance = self.lowest - separation - self.break_away;
        let is_within = |kink: &f64| (self.lowest..self.highest).contains(&(separation + kink));
        clearance > LEAST_CLEARANCE * (self.highest - self.lowest) && !self.kinks_of_contact.iter().any(is_within)
    }

    /// The sums at a separation that the rule covers.
    pub fn sums(&self, population: &Population, separation: f64) -> Sums {
        let law = &*population.law;
        let mut guess = law.guess(self.heights[0] - separation, 1.0);
        let mut last: Option<(f64, Contact)> = None;
        let contacts: [Contact; POINTS] = std::array::from_fn(|i| {
            let z = self.heights[i];
            if let Some((before, contact)) = last {
                guess = contact.parameter + (z - before) / contact.overlap_rate;
            }
            let contact = law.at_overlap(z - separation, 1.0, guess);
            last = Some((z, contact));
            contact
        });
        let kinks = self.kinks.map(|overlap| separation + overlap);
        let regime = kinks.iter().filter(|&&kink| kink <= self.lowest).count();
        let mut sums = Sums::default();
        for (contact, weight) in contacts.iter().zip(self.weights) {
            sums.add_contact(weight, &Summit::in_regime(contact, &population.slip, regime));
        }
        if kinks[regime.min(1)] < self.highest && regime < kinks.len() {
            let radius = Interpolation::new(&self.heights, contacts.map(|contact| contact.radius));
            for (index, &kink) in kinks.iter().enumerate().skip(regime).filter(|(_, &kink)| kink < self.highest) {
                self.add_next_regime(&mut sums, population, &radius, (index, kink));
            }
        }
        sums
    }

    /// Adds what friction above a kink of the slip law has more than if its regime went on.
    fn add_next_regime(&self, sums: &mut Sums, population: &Population, radius: &Interpolation, kink: (usize, f64)) {
        let (regime, mut z) = kink;
        let heights = &*population.heights;
        while z < self.highest {
            let stop = population.stop_above(z).min(self.highest);
            let end = (z + panel::panel_length(heights, z)).min(stop);
            let mut nodes = quadrature::nodes(z, end);
            let nodes: [(f64, f64); POINTS] = std::array::from_fn(|_| nodes.next().unwrap_or_default());
            let densities = heights.densities(nodes.map(|(z, _)| z));
            for ((z, weight), density) in nodes.into_iter().zip(densities) {
                let (a, a_rate) = radius.at(z);
                let change = |slip: &Slip| {
                    let (before, after) = (slip.force_in_regime(regime, a), slip.force_in_regime(regime + 1, a));
                    (after.0 - before.0, (after.1 - before.1) * a_rate)
                };
                let (friction, friction_by_overlap) = change(&population.slip);
                sums.friction += weight * density * friction;
                sums.friction_slope -= weight * density * friction_by_overlap;
            }
            z = end;
        }
    }
}

/// The density at the nodes of panels over all heights that count, times their weights; the last is the end of the range.
fn sampled(heights: &dyn HeightDistribution, lowest: f64, highest: f64) -> Vec<(f64, f64)> {
    let (mut samples, mut total, mut z) = (Vec::new(), 0.0, lowest);
    if let Some(panel) = FootPanel::new(heights, 1.0).filter(|_| z <= heights.support().0) {
        for (v, weight) in quadrature::nodes(0.0, 1.0) {
            let (rise, rate) = panel.at(v);
            samples.push((z + rise, weight * rate * exp(heights.log_density(z + rise))));
        }
        z += panel.length;
    }
    for _ in 0..MOST_PANELS {
        let end = (z + panel::panel_length(heights, z)).min(highest);
        let before = samples.len();
        samples.extend(quadrature::nodes(z, end).map(|(x, weight)| (x, weight * exp(heights.log_density(x)))));
        let mass: f64 = samples[before..].iter().map(|(_, fraction)| fraction).sum();
        total += mass;
        let is_tail = end > heights.last_mode() && mass <= NEGLIGIBLE * total;
        z = end;
        if is_tail || z >= highest {
            break;
        }
    }
    samples.push((z, 0.0));
    samples
}

/// The polynomial through points, in Newton's form.
struct Interpolation<'a> {
    points: &'a [f64; POINTS],
    differences: [f64; POINTS],
}

impl<'a> Interpolation<'a> {
    fn new(points: &'a [f64; POINTS], values: [f64; POINTS]) -> Self {
        let mut differences = values;
        for order in 1..POINTS {
            for i in (order..POINTS).rev() {
                differences[i] = (differences[i] - differences[i - 1]) / (points[i] - points[i - order]);
            }
        }
        Self { points, differences }
    }

    /// The value and the slope.
    fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut slope) = (self.differences[POINTS - 1], 0.0);
        for i in (0..POINTS - 1).rev() {
            let distance = x - self.points[i];
            slope = slope * distance + value;
            value = value * distance + self.differences[i];
        }
        (value, slope)
    }
}
