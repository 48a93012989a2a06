//! The sums at separations far below the heights, with equal radii: there the law of contact is so smooth across all heights
//! that its values at few of them, weighted with the density, give the sums.
//!
//! Friction has kinks where the contact radius is one of the slip law's. It is summed as if the regime of the lowest summit
//! held for all; to this comes, above each kink, what the next regime adds.

use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::contact::{Contact, KINKS};
use crate::distribution::panel::{self, FootPanel};
use crate::distribution::HeightDistribution;
use crate::elementary::exp;
use crate::numerics::quadrature::{self, POINTS};

/// How far above break-away the lowest summit is, over the range of heights: a polynomial through the points then follows
/// the law of contact to rounding.
const LEAST_CLEARANCE: f64 = 0.7;
/// Heights above which less than this part of all lies are left out.
const NEGLIGIBLE: f64 = 1e-17;

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
        let basis = Basis::new(&heights);
        let mut weights = [0.0; POINTS];
        for &(z, fraction) in &density {
            for (weight, polynomial) in weights.iter_mut().zip(basis.at(z)) {
                *weight += fraction * polynomial;
            }
        }
        let break_away = population.law.break_away(1.0).overlap;
        let kinks =
            population.slip.kinks().map(|radius| population.overlap_at_radius(radius, 1.0).unwrap_or(break_away));
        let kinks_of_contact = population.kinks_of_contact;
        Self { lowest, highest, heights, weights, break_away, kinks, kinks_of_contact }
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
        for (regime, &kink) in kinks.iter().enumerate().skip(regime).filter(|(_, &kink)| kink < self.highest) {
            self.add_next_regime(&mut sums, population, &contacts, (regime, kink));
        }
        sums
    }

    /// Adds what friction above a kink of the slip law has more than if its regime went on.
    fn add_next_regime(
        &self,
        sums: &mut Sums,
        population: &Population,
        contacts: &[Contact; POINTS],
        (regime, kink): (usize, f64),
    ) {
        let [before, after] =
            [regime, regime + 1].map(|regime| contacts.map(|c| Summit::in_regime(&c, &population.slip, regime)));
        let change = |of: fn(&Summit) -> f64| {
            Interpolation::new(&self.heights, std::array::from_fn(|i| of(&after[i]) - of(&before[i])))
        };
        let (force, slope) = (change(|summit| summit.friction), change(|summit| summit.friction_by_overlap));
        for (from, to) in panel::panels(&*population.heights, kink, self.highest) {
            let mut nodes = quadrature::nodes(from, to);
            let nodes: [(f64, f64); POINTS] = std::array::from_fn(|_| nodes.next().unwrap_or_default());
            let heights = nodes.map(|(z, _)| z);
            let (force, slope) = (force.at(heights), slope.at(heights));
            for (i, density) in population.heights.densities(heights).into_iter().enumerate() {
                sums.friction += nodes[i].1 * density * force[i];
                sums.friction_slope -= nodes[i].1 * density * slope[i];
            }
        }
    }
}

/// The density at the nodes of panels over all heights that count, times their weights; the last is the end of the range.
fn sampled(heights: &dyn HeightDistribution, lowest: f64, highest: f64) -> Vec<(f64, f64)> {
    let (mut samples, mut total, mut end) = (Vec::new(), 0.0, lowest);
    if let Some(panel) = FootPanel::new(heights, 1.0).filter(|_| lowest <= heights.support().0) {
        for (v, weight) in quadrature::nodes(0.0, 1.0) {
            let (rise, rate) = panel.at(v);
            samples.push((lowest + rise, weight * rate * exp(heights.log_density(lowest + rise))));
        }
        end += panel.length;
    }
    for (from, to) in panel::panels(heights, end, highest) {
        let before = samples.len();
        samples.extend(quadrature::nodes(from, to).map(|(x, weight)| (x, weight * exp(heights.log_density(x)))));
        let mass: f64 = samples[before..].iter().map(|(_, fraction)| fraction).sum();
        total += mass;
        end = to;
        if end > heights.last_mode() && mass <= NEGLIGIBLE * total {
            break;
        }
    }
    samples.push((end, 0.0));
    samples
}

/// The polynomials that are 1 at one of the points and 0 at the others.
struct Basis<'a> {
    points: &'a [f64; POINTS],
    /// What the products of the distances from the other points are divided by.
    scales: [f64; POINTS],
}

impl<'a> Basis<'a> {
    fn new(points: &'a [f64; POINTS]) -> Self {
        let scales = std::array::from_fn(|i| {
            let others = points.iter().enumerate().filter(|&(other, _)| other != i);
            others.map(|(_, other)| points[i] - other).product()
        });
        Self { points, scales }
    }

    /// All of them at one place.
    fn at(&self, z: f64) -> [f64; POINTS] {
        let mut values = self.scales.map(|scale| 1.0 / scale);
        let (mut below, mut above) = (1.0, 1.0);
        for i in 0..POINTS {
            values[i] *= below;
            below *= z - self.points[i];
            let last = POINTS - 1 - i;
            values[last] *= above;
            above *= z - self.points[last];
        }
        values
    }
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

    /// At several places, side by side.
    fn at<const N: usize>(&self, x: [f64; N]) -> [f64; N] {
        let mut values = [self.differences[POINTS - 1]; N];
        for i in (0..POINTS - 1).rev() {
            for (value, x) in values.iter_mut().zip(x) {
                *value = *value * (x - self.points[i]) + self.differences[i];
            }
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{of, surface, table, FOLD, HERTZ, WEAK};
    use super::*;
    use crate::params::HeightFamily;

    /// From next to where the rule serves to where all summits pass the slip law's second radius, and beyond.
    #[test]
    fn the_rule_gives_the_sums_of_a_walk_over_the_panels() {
        let johnson = |skew, kurtosis| HeightFamily::Johnson { skew, kurtosis };
        let weibull = |shape| HeightFamily::Weibull { shape };
        let families =
            [HeightFamily::Gaussian, weibull(1.5), weibull(20.0), johnson(1.0, 5.0), johnson(0.0, 9.0), table()];
        for (groups, heights) in families.iter().flat_map(|heights| [WEAK, FOLD, HERTZ].map(|groups| (groups, heights)))
        {
            let population = of(&surface(groups, heights.clone(), [0.0, 1.0]));
            let rule = population.deep.clone().expect("radii are equal");
            let walked = Population { nodes: None, deep: None, ..population.clone() };
            let range = rule.highest - rule.lowest;
            let at = |distance: f64| rule.lowest - rule.break_away - distance;
            assert!(!rule.covers(at(0.999 * LEAST_CLEARANCE * range)));
            let passing = rule.lowest - rule.break_away - (0.5 * (rule.lowest + rule.highest) - rule.kinks[1]);
            for distance in [1.001 * LEAST_CLEARANCE * range, 3.0 * range, 100.0 * range, passing.abs(), 1e5] {
                let separation = at(distance);
                assert!(rule.covers(separation));
                let (a, b) = (population.at_separation(separation), walked.at_separation(separation));
                for (name, a, b, tolerance) in [
                    ("load", a.load(), b.load(), 3e-13),
                    ("friction", a.friction, b.friction, 3e-13),
                    ("area", a.area, b.area, 3e-13),
                    ("contacting", a.contacting, b.contacting, 3e-13),
                    ("dP/dd", a.load_slope, b.load_slope, 3e-12),
                    ("dF/dd", a.friction_slope, b.friction_slope, 3e-12),
                ] {
                    let error = (a / b - 1.0).abs();
                    assert!(error < tolerance, "{name} of {heights:?}, {distance}: {error:e}");
                }
            }
        }
    }
}
