//! More of the summits in contact at a separation than their sums: the mean of their contact radii, the largest, and how many
//! there are in each regime of slip and of yield.
//!
//! For exact states only: the sums that a law is compiled from need none of this.

use super::sums::Summit;
use super::walk::Visitor;
use super::{Point, Population};
use crate::distribution::panel;
use crate::error::Error;
use crate::numerics::elementary::{exp, log};
use crate::numerics::quadrature;
use crate::numerics::root;

/// Contact radii, in b, and their share of the regimes of slip.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Statistics {
    /// Mean contact radius.
    pub mean_radius: f64,
    /// Mean of the contact radius over g, that of the summit over the mean one.
    pub mean_steepness: f64,
    /// Contact radius of the tallest of so many summits as there are; not below the mean.
    pub largest_radius: f64,
    /// Fractions of the contacts up to the first kink of the slip law, between the two, and from the second on.
    pub by_regime: [f64; 3],
    /// Fraction of the contacts below first yield.
    pub elastic: f64,
    /// Fraction of the contacts that are fully plastic.
    pub flowing: f64,
    /// Share of what contacts bear on flat parts of the surface, of a table of heights at scores.
    pub on_flats: f64,
}

impl Statistics {
    /// Adds those of a part of all contacts; the largest is the largest of all parts.
    pub fn add(&mut self, other: &Self, part: f64) {
        self.mean_radius += part * other.mean_radius;
        self.mean_steepness += part * other.mean_steepness;
        // The mean is no larger, rounding apart.
        self.largest_radius = self.largest_radius.max(other.largest_radius).max(self.mean_radius);
        self.by_regime = std::array::from_fn(|i| self.by_regime[i] + part * other.by_regime[i]);
        self.elastic += part * other.elastic;
        self.flowing += part * other.flowing;
        self.on_flats += part * other.on_flats;
    }
}

/// Counts contacts, and keeps every contact radius that it sees with its height.
struct Counting<'a> {
    population: &'a Population,
    count: f64,
    load: f64,
    /// Sums in place of means and fractions.
    sums: Statistics,
    seen: Vec<(f64, f64)>,
}

impl Visitor for Counting<'_> {
    fn summits(&mut self, z: f64, fraction: f64, summit: &Summit) {
        let [first, second] = self.population.slip.kinks();
        let regime = usize::from(summit.radius > first) + usize::from(summit.radius >= second);
        let g = self.population.radius.factor(z);
        let [yields, flows] = self.population.yields.map(|overlap| overlap * g - self.population.lost);
        self.count += fraction;
        let sums = &mut self.sums;
        sums.mean_radius += fraction * summit.radius;
        sums.mean_steepness += fraction * summit.radius / g;
        sums.by_regime[regime] += fraction;
        sums.elastic += if summit.overlap <= yields { fraction } else { 0.0 };
        sums.flowing += if summit.overlap >= flows { fraction } else { 0.0 };
        // Forces by adhesion have both signs: what Hertz' contacts of the same radii bear has not.
        let load = fraction * summit.hertz_load;
        self.load += load;
        sums.on_flats += if self.population.radius.is_flat(z) { load } else { 0.0 };
        self.seen.push((z, summit.radius));
    }

    fn end_of_panel(&mut self, end: &Point) {
        self.seen.push((end.z, end.contact.radius));
    }
}

impl Population {
    /// The contacts at a separation, of which `number` are expected on the surface; all 0 if there are none.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if they cannot be counted in as many panels as there may be.
    pub fn statistics(&self, separation: f64, number: f64) -> Result<Statistics, Error> {
        let population = &*self.as_at(separation);
        let edge = population.edge(separation);
        let mut counting =
            Counting { population, count: 0.0, load: 0.0, sums: Statistics::default(), seen: Vec::new() };
        if self.radius.is_constant() && self.yields == self.kinks_of_contact {
            population.visit(separation, &edge, &mut counting)?;
        } else {
            let other = Self { ends_at_extrema: true, ..population.with_kinks(self.radius_kinks, self.yields) };
            other.visit(separation, &edge, &mut counting)?;
        }
        let Counting { count, load, sums, seen, .. } = counting;
        if count == 0.0 {
            return Ok(Statistics::default());
        }
        let mean_radius = sums.mean_radius / count;
        let mut largest_radius = mean_radius;
        if number > 1.0 {
            let lowest = edge.point.z.max(self.lower_cut);
            let tallest = self.height_exceeded_by(lowest, count / (number + 1.0));
            let guess = population.law.guess(tallest - separation, self.radius.factor(tallest));
            let there = population.at_height(separation, tallest, guess).contact.radius;
            let below = seen.iter().filter(|(z, _)| *z <= tallest).map(|(_, radius)| *radius);
            largest_radius = below.chain([there]).fold(mean_radius, f64::max);
        }
        Ok(Statistics {
            mean_radius,
            mean_steepness: sums.mean_steepness / count,
            largest_radius,
            by_regime: sums.by_regime.map(|fraction| fraction / count),
            elastic: sums.elastic / count,
            flowing: sums.flowing / count,
            on_flats: if load > 0.0 { sums.on_flats / load } else { 0.0 },
        })
    }

    /// The height above another that this fraction of all summits exceeds.
    fn height_exceeded_by(&self, lowest: f64, fraction: f64) -> f64 {
        let residual = |z: f64| log((self.exceedance(z) / fraction).max(1e-100));
        root::beyond(residual, lowest, 1.0, self.highest)
    }

    /// The fraction of all summits that are higher.
    fn exceedance(&self, z: f64) -> f64 {
        let mut fraction = 0.0;
        for (from, to) in panel::panels(&*self.heights, z, self.highest) {
            let part: f64 =
                quadrature::nodes(from, to).map(|(x, weight)| weight * exp(self.heights.log_density(x))).sum();
            fraction += part;
            if from >= self.heights.outline().last_mode && part <= f64::EPSILON * fraction {
                break;
            }
        }
        fraction
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{of, surface, HERTZ, WEAK};
    use crate::asperity::contact::Contact;
    use crate::params::{HeightFamily, Params};
    use crate::population::Population;

    /// The contacts at a separation, at equal steps of height from the first: their fraction of all summits, and the contact.
    fn contacts(population: &Population, separation: f64) -> Vec<(f64, Contact)> {
        const STEPS: u32 = 20_000;
        let lowest = population.edge(separation).point.z.max(population.lower_cut);
        let step = (population.highest - lowest) / f64::from(STEPS);
        let at = |i: u32| {
            let z = lowest + (f64::from(i) + 0.5) * step;
            let guess = population.law.guess(z - separation, population.radius.factor(z));
            let contact = population.at_height(separation, z, guess).contact;
            (step * population.heights.log_density(z).exp(), contact)
        };
        (0..STEPS).map(at).collect()
    }

    #[test]
    fn means_are_those_of_a_sum_over_heights() {
        for (groups, radii) in [(HERTZ, [0.0, 1.0]), (WEAK, [0.0, 1.0]), (WEAK, [0.4, 0.7])] {
            let params = Params { hardness: 0.15, ..surface(groups, HeightFamily::Weibull { shape: 3.0 }, radii) };
            let population = of(&params);
            for separation in [-0.5, 1.5] {
                let found = population.statistics(separation, 1.0).expect("statistics");
                let contacts = contacts(&population, separation);
                let sum = |of: &dyn Fn(&Contact) -> f64| -> f64 {
                    contacts.iter().map(|(fraction, contact)| fraction * of(contact)).sum()
                };
                let count = sum(&|_| 1.0);
                let [first, _] = population.yields;
                let near = |what: &str, found: f64, expected: f64| {
                    assert!(
                        (found - expected).abs() < 2e-4 * expected,
                        "{what} at {separation}: {found}, not {expected}"
                    );
                };
                near("mean radius", found.mean_radius, sum(&|contact| contact.radius) / count);
                if radii[0] == 0.0 {
                    let elastic = sum(&|contact| if contact.overlap <= first { 1.0 } else { 0.0 }) / count;
                    near("elastic", found.elastic, elastic);
                }
            }
        }
    }
}
