//! The sums at separations far below the heights, with equal radii: there the law of contact is so smooth across all heights
//! that its values at few of them, weighted with the density, give the sums.
//!
//! Friction has kinks where the contact radius is one of the slip law's. It is summed as if the regime of the lowest summit
//! held for all; to this comes, above each kink, what the next regime adds.

use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::contact::{Contact, KINKS};
use crate::distribution::panel::{self, LowerEndPanel};
use crate::distribution::HeightDistribution;
use crate::numerics::quadrature;

/// How far above break-away the lowest summit is, over the range of heights: a polynomial through [`MANY`] points then
/// follows the law of contact to rounding.
const LEAST_CLEARANCE: f64 = 0.7;
const MANY: usize = quadrature::POINTS;
/// And so far above, through [`FEW`].
const FAR_CLEARANCE: f64 = 60.0;
const FEW: usize = 6;
/// Heights above which less than this part of all lies are left out.
const NEGLIGIBLE: f64 = 1e-17;

/// Points among the heights with their weights.
#[derive(Debug, Clone)]
pub struct DeepRule {
    /// Where the panels of the density begin and end, over the range of the heights that count.
    ends: Vec<f64>,
    many: Points<MANY>,
    few: Points<FEW>,
    /// The smallest overlap at which a contact holds, and those at the radii of the slip law.
    break_away: f64,
    kinks: [f64; 2],
    /// Those at which the law of contact itself is not smooth.
    kinks_of_contact: [f64; KINKS],
}

/// So many Gauss points of the range of heights.
#[derive(Debug, Clone)]
struct Points<const N: usize> {
    heights: [f64; N],
    /// The product of the distances of each from the others.
    scales: [f64; N],
    /// For each panel, the integrals over the density from where it begins up, times the polynomials.
    weights: Vec<[f64; N]>,
}

impl DeepRule {
    /// The rule of a population of equal radii.
    pub fn new(population: &Population) -> Self {
        let (ends, samples) = sampled(&*population.heights, population.lower_cut, population.highest);
        let (many, few) = (Points::new(&ends, &samples, 1.0), Points::new(&ends, &samples, 0.0));
        let break_away = population.law.break_away(1.0).overlap;
        let kinks = population
            .slip
            .kinks()
            .map(|radius| population.contact_of_radius(radius, 1.0).map_or(break_away, |contact| contact.overlap));
        Self { ends, many, few, break_away, kinks, kinks_of_contact: population.kinks_of_contact }
    }

    /// The lowest and the highest of the heights that count.
    fn range(&self) -> (f64, f64) {
        (self.ends[0], self.ends[self.ends.len() - 1])
    }

    /// How far above break-away the lowest summit is at a separation, over the range of heights.
    fn clearance(&self, separation: f64) -> f64 {
        let (lowest, highest) = self.range();
        (lowest - separation - self.break_away) / (highest - lowest)
    }

    /// Whether the rule is good at a separation.
    pub fn covers(&self, separation: f64) -> bool {
        let (lowest, highest) = self.range();
        let is_within = |kink: &f64| (lowest..highest).contains(&(separation + kink));
        self.clearance(separation) > LEAST_CLEARANCE && !self.kinks_of_contact.iter().any(is_within)
    }

    /// The sums at a separation that the rule covers.
    pub fn sums(&self, population: &Population, separation: f64) -> Sums {
        match self.clearance(separation) > FAR_CLEARANCE {
            true => self.sums_over(&self.few, population, separation),
            false => self.sums_over(&self.many, population, separation),
        }
    }

    fn sums_over<const N: usize>(&self, points: &Points<N>, population: &Population, separation: f64) -> Sums {
        let (lowest, highest) = self.range();
        let contacts = points.contacts(population, separation);
        let kinks = self.kinks.map(|overlap| separation + overlap);
        let summits = |regime: usize| {
            contacts.map(|contact| Summit::new(&contact, population.slip.friction_in_regime(regime, &contact)))
        };
        let lowest_regime = kinks.iter().filter(|&&kink| kink <= lowest).count();
        let mut sums = Sums::default();
        for (summit, weight) in summits(lowest_regime).iter().zip(points.weights[0]) {
            sums.add_contact(weight, summit);
        }
        for (regime, &kink) in kinks.iter().enumerate().skip(lowest_regime).filter(|(_, &kink)| kink < highest) {
            let (before, after) = (summits(regime), summits(regime + 1));
            for (i, weight) in self.weights_above(kink, points, &*population.heights).into_iter().enumerate() {
                sums.friction += weight * (after[i].friction - before[i].friction);
                sums.friction_slope -= weight * (after[i].friction_by_overlap - before[i].friction_by_overlap);
            }
        }
        sums
    }

    /// The integrals over the density above a kink, times the polynomials.
    fn weights_above<const N: usize>(
        &self,
        kink: f64,
        points: &Points<N>,
        heights: &dyn HeightDistribution,
    ) -> [f64; N] {
        // The panel that begins above it, and what is left of the one before.
        let next = self.ends.partition_point(|&end| end <= kink);
        let mut weights = points.weights.get(next).copied().unwrap_or([0.0; N]);
        for (from, to) in panel::panels(heights, kink, self.ends[next]) {
            points.weigh(&mut weights, &samples(heights, from, to));
        }
        weights
    }
}

impl<const N: usize> Points<N> {
    /// Of a density sampled panel by panel, with the rule for this part of a long panel.
    fn new(ends: &[f64], panels: &[Samples], part: f64) -> Self {
        let mut nodes = quadrature::nodes_of_part(part, ends[0], ends[ends.len() - 1]);
        let heights: [f64; N] = std::array::from_fn(|_| nodes.next().unwrap_or_default().0);
        let scales = std::array::from_fn(|i| {
            let others = heights.iter().enumerate().filter(|&(other, _)| other != i);
            others.map(|(_, other)| heights[i] - other).product()
        });
        let mut points = Self { heights, scales, weights: Vec::new() };
        let mut above = [0.0; N];
        for panel in panels.iter().rev() {
            points.weigh(&mut above, panel);
            points.weights.push(above);
        }
        points.weights.reverse();
        points
    }

    /// Adds the fractions of a panel, each times the polynomials.
    fn weigh(&self, weights: &mut [f64; N], panel: &Samples) {
        for &(z, fraction) in panel {
            for (weight, polynomial) in weights.iter_mut().zip(self.polynomials(z)) {
                *weight += fraction * polynomial;
            }
        }
    }

    /// The polynomials that are 1 at one of the points and 0 at the others, at one place.
    fn polynomials(&self, z: f64) -> [f64; N] {
        let mut values = self.scales.map(|scale| 1.0 / scale);
        let (mut below, mut above) = (1.0, 1.0);
        for i in 0..N {
            values[i] *= below;
            below *= z - self.heights[i];
            let last = N - 1 - i;
            values[last] *= above;
            above *= z - self.heights[last];
        }
        values
    }

    /// The contacts at the points.
    fn contacts(&self, population: &Population, separation: f64) -> [Contact; N] {
        let law = &*population.law;
        let mut guess = law.guess(self.heights[0] - separation, 1.0);
        let mut last: Option<(f64, Contact)> = None;
        self.heights.map(|z| {
            if let Some((before, contact)) = last {
                guess = contact.parameter + (z - before) / contact.by_s.overlap;
            }
            let contact = law.at_overlap(z - separation, 1.0, guess);
            last = Some((z, contact));
            contact
        })
    }
}

/// The fractions of all summits at the nodes of one panel.
type Samples = [(f64, f64); quadrature::POINTS];

/// Those of an ordinary panel.
fn samples(heights: &dyn HeightDistribution, from: f64, to: f64) -> Samples {
    let nodes = quadrature::panel(from, to);
    let densities = heights.densities(nodes.map(|(z, _)| z));
    std::array::from_fn(|i| (nodes[i].0, nodes[i].1 * densities[i]))
}

/// Panels over all heights that count: where they begin and end, and the density at their nodes, times the weights.
fn sampled(heights: &dyn HeightDistribution, lowest: f64, highest: f64) -> (Vec<f64>, Vec<Samples>) {
    let (mut ends, mut panels, mut total) = (vec![lowest], Vec::new(), 0.0);
    let mut start = lowest;
    if let Some(panel) = LowerEndPanel::new(heights, lowest, 1.0) {
        panels.push(panel.nodes(heights).map(|(rise, fraction)| (lowest + rise, fraction)));
        start += panel.length;
        ends.push(start);
    }
    for (from, to) in panel::panels(heights, start, highest) {
        let samples = samples(heights, from, to);
        let mass: f64 = samples.iter().map(|(_, fraction)| fraction).sum();
        panels.push(samples);
        ends.push(to);
        total += mass;
        if to > heights.last_mode() && mass <= NEGLIGIBLE * total {
            break;
        }
    }
    (ends, panels)
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
            let (lowest, highest) = rule.range();
            let range = highest - lowest;
            let at = |distance: f64| lowest - rule.break_away - distance;
            assert!(!rule.covers(at(0.999 * LEAST_CLEARANCE * range)));
            let to_kink = lowest - rule.break_away - (0.5 * (lowest + highest) - rule.kinks[1]);
            let clearances = [1.001 * LEAST_CLEARANCE, 3.0, 0.999 * FAR_CLEARANCE, 1.001 * FAR_CLEARANCE];
            for distance in clearances.map(|part| part * range).into_iter().chain([to_kink.abs(), 1e5]) {
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
