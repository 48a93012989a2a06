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

/// A slope of friction by load, as large as next to pull-off, of which squares are still numbers.
const LARGEST_FRICTION_SLOPE: f64 = 1e40;

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
    /// Mean of (f - F' p)^2 over the contacts, of their friction f and load p, over the square of their mean friction: the
    /// variance of the friction force under a constant load, times the number of contacts, to first order.
    pub friction_variance: f64,
    /// Mean square over the square of the mean of the loads of Hertz' contacts of the same radii.
    pub hertz_spread: f64,
    /// Sums over the contacts, as those of `Sums`, of the load times itself and times its slope and that of friction by overlap.
    pub products: [f64; 3],
}

/// Counts contacts, and keeps every contact radius that it sees with its height.
struct Counting<'a> {
    population: &'a Population,
    count: f64,
    /// Sums in place of means and fractions.
    sums: Statistics,
    /// F', the slope of friction by load.
    slope: f64,
    friction: f64,
    /// The sums of Hertz' loads and of their squares.
    hertz: [f64; 2],
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
        let excess = summit.friction - self.slope * summit.load;
        sums.friction_variance += fraction * excess * excess;
        self.friction += fraction * summit.friction;
        self.hertz[0] += fraction * summit.hertz_load;
        self.hertz[1] += fraction * summit.hertz_load * summit.hertz_load;
        let factors = [summit.load, summit.load_by_overlap, summit.friction_by_overlap];
        for (sum, factor) in sums.products.iter_mut().zip(factors) {
            *sum += fraction * summit.load * factor;
        }
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
    pub fn statistics(&self, separation: f64, number: f64, slope: f64) -> Result<Statistics, Error> {
        let population = &*self.as_at(separation);
        let edge = population.edge(separation);
        let mut counting = Counting {
            population,
            count: 0.0,
            sums: Statistics::default(),
            slope: slope.clamp(-LARGEST_FRICTION_SLOPE, LARGEST_FRICTION_SLOPE),
            friction: 0.0,
            hertz: [0.0; 2],
            seen: Vec::new(),
        };
        if self.yields == self.kinks_of_contact {
            population.visit(separation, &edge, &mut counting)?;
        } else {
            population.with_kinks(self.radius_kinks, self.yields).visit(separation, &edge, &mut counting)?;
        }
        let Counting { count, sums, friction, hertz, seen, .. } = counting;
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
            // Squares of the lightest contacts are no numbers.
            friction_variance: match friction * friction > f64::MIN_POSITIVE {
                true => sums.friction_variance / friction * (count / friction),
                false => 0.0,
            },
            hertz_spread: hertz[1] / hertz[0] * (count / hertz[0]),
            products: sums.products,
        })
    }

    /// The height above another that this fraction of all summits exceeds.
    fn height_exceeded_by(&self, lowest: f64, fraction: f64) -> f64 {
        let mut upper = lowest + 1.0;
        while upper < self.highest && self.exceedance(upper) > fraction {
            upper += upper - lowest;
        }
        let upper = upper.min(self.highest);
        let residual = |z: f64| log((self.exceedance(z) / fraction).max(1e-100));
        root::bracketed(residual, lowest, upper)
    }

    /// The fraction of all summits that are higher.
    fn exceedance(&self, z: f64) -> f64 {
        let mut fraction = 0.0;
        for (from, to) in panel::panels(&*self.heights, z, self.highest) {
            let part: f64 =
                quadrature::nodes(from, to).map(|(x, weight)| weight * exp(self.heights.log_density(x))).sum();
            fraction += part;
            if from >= self.heights.last_mode() && part <= f64::EPSILON * fraction {
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

    /// The contacts at a separation, at equal steps of height from the first: their fraction of all summits, the contact, and
    /// its friction.
    fn contacts(population: &Population, separation: f64) -> Vec<(f64, Contact, f64)> {
        const STEPS: u32 = 20_000;
        let lowest = population.edge(separation).point.z.max(population.lower_cut);
        let step = (population.highest - lowest) / f64::from(STEPS);
        let at = |i: u32| {
            let z = lowest + (f64::from(i) + 0.5) * step;
            let guess = population.law.guess(z - separation, population.radius.factor(z));
            let contact = population.at_height(separation, z, guess).contact;
            (step * population.heights.log_density(z).exp(), contact, population.slip.friction(&contact).force)
        };
        (0..STEPS).map(at).collect()
    }

    #[test]
    fn means_and_variances_are_those_of_a_sum_over_heights() {
        for (groups, radii) in [(HERTZ, [0.0, 1.0]), (WEAK, [0.0, 1.0]), (WEAK, [0.4, 0.7])] {
            let params = Params { hardness: 0.15, ..surface(groups, HeightFamily::Weibull { shape: 3.0 }, radii) };
            let population = of(&params);
            for separation in [-0.5, 1.5] {
                let slope = 0.01;
                let found = population.statistics(separation, 1.0, slope).expect("statistics");
                let contacts = contacts(&population, separation);
                let sum = |of: &dyn Fn(&Contact, f64) -> f64| -> f64 {
                    contacts.iter().map(|(fraction, contact, friction)| fraction * of(contact, *friction)).sum()
                };
                let count = sum(&|_, _| 1.0);
                let mean_friction = sum(&|_, friction| friction) / count;
                let excess = |load: f64, friction: f64| (friction - slope * load).powi(2);
                let variance = sum(&|contact, friction| excess(contact.load, friction)) / count;
                let [first, _] = population.yields;
                let near = |what: &str, found: f64, expected: f64| {
                    assert!(
                        (found - expected).abs() < 2e-4 * expected,
                        "{what} at {separation}: {found}, not {expected}"
                    );
                };
                near("mean radius", found.mean_radius, sum(&|contact, _| contact.radius) / count);
                near("variance", found.friction_variance, variance / (mean_friction * mean_friction));
                if radii[0] == 0.0 {
                    let elastic = sum(&|contact, _| if contact.overlap <= first { 1.0 } else { 0.0 }) / count;
                    near("elastic", found.elastic, elastic);
                }
            }
        }
    }
}
