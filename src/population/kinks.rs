//! The separations at which the sums are not smooth.
//!
//! A summit has kinks: where its contact begins, where its attraction does, at the contact radii of the slip law, at the overlaps of
//! the law of contact. The height of the summits that are at one moves with the separation. The sums have a kink where that height
//! passes one at which the density of heights is not smooth; and, where radii vary with height, where it turns back, since there
//! two heights meet, and where the contact that begins has a radius of the slip law's.

use super::break_away::Edge;
use super::{Point, Population};
use crate::asperity::contact::Contact;
use crate::numerics::{ascending, root};

/// Hardly any heights are below this, in sigma from their mean: where they begin is then no kink.
const LOWEST_END: f64 = -8.0;
/// Nor is one where so few heights only bend.
const LOWEST_BEND: f64 = -2.5;
/// Kinks nearer to each other than this, relative to 1 or to the separation, are one.
const SAME_KINK: f64 = 1e-8;

impl Population {
    /// The separations at which the sums are not smooth, in ascending order.
    pub fn kinks(&self) -> Vec<f64> {
        let (lower_end, _) = self.heights.outline().support;
        let is_power = self.heights.outline().power_at_lower_end.is_some();
        let lower_end = (is_power && lower_end + self.heights.outline().origin > LOWEST_END).then_some(lower_end);
        let breakpoints = if self.heights.outline().is_piecewise_polynomial { self.heights.breakpoints() } else { &[] };
        let heights: Vec<f64> = breakpoints.iter().copied().chain(lower_end).collect();
        let mut kinks: Vec<f64> = heights.iter().flat_map(|&z| self.kinks_of_height(z)).collect();
        if !self.heights.outline().is_piecewise_polynomial {
            let edge = |&z: &f64| z - self.law.break_away(self.radius.factor(z)).overlap;
            // Few heights are below the others: what their slopes do there hardly shows in what all bear.
            kinks.extend(self.heights.breakpoints().iter().filter(|&&z| z > LOWEST_BEND).map(edge));
        }
        if !self.radius.is_constant() {
            for radius in self.slip.kinks() {
                kinks.extend(self.separations_where(&|z| {
                    let (g, g_rate) = self.radius.at(z);
                    let contact = self.contact_of_radius(radius, g)?;
                    Some((Point { z, g_rate, contact }.radius_change(), z - contact.overlap))
                }));
                kinks.extend(self.separations_where(&|z| {
                    let edge = Edge::at(&*self.law, &self.radius, z).point.contact;
                    Some((edge.radius - radius, z - edge.overlap))
                }));
            }
            for overlap in self.kinks_of_contact.into_iter().filter(|kink| kink.is_finite()) {
                kinks.extend(self.separations_where(&|z| {
                    let (g, g_rate) = self.radius.at(z);
                    Some((1.0 - overlap * g_rate, z - overlap * g))
                }));
            }
        }
        if self.largest < f64::INFINITY {
            kinks.retain(|&kink| kink < self.largest);
            kinks.extend(self.kinks_of_unloading(&heights));
        }
        let mut kinks: Vec<f64> = ascending(&kinks).into_iter().map(|i| kinks[i]).collect();
        kinks.dedup_by(|next, kink| *next - *kink < SAME_KINK * (1.0 + kink.abs()));
        kinks
    }

    /// The separations at which a height passes what a summit has a kink at.
    fn kinks_of_height(&self, z: f64) -> Vec<f64> {
        let g = self.radius.factor(z);
        let mut kinks = vec![z - self.law.break_away(g).overlap];
        kinks.extend(self.attraction.as_ref().map(|law| z + law.reach));
        kinks.extend(
            self.slip.kinks().iter().filter_map(|&radius| Some(z - self.contact_of_radius(radius, g)?.overlap)),
        );
        kinks.extend(self.kinks_of_contact.iter().map(|overlap| z - overlap * g).filter(|kink| kink.is_finite()));
        kinks
    }

    /// The separations, which `at` gives as its second, at the heights where its first changes sign.
    pub(super) fn separations_where(&self, at: &dyn Fn(f64) -> Option<(f64, f64)>) -> Vec<f64> {
        let value = |z: f64| at(z).map(|(value, _)| value);
        let looks: Vec<_> = self.radius.looks(self.lower_cut, self.highest).map(|z| (z, value(z))).collect();
        let passed = looks.windows(2).filter_map(|between| {
            let [(lower, before), (upper, after)] = [between[0], between[1]];
            ((before? < 0.0) != (after? < 0.0)).then_some((lower, upper))
        });
        let at_root =
            passed.filter_map(|(lower, upper)| at(root::bracketed(|z| value(z).unwrap_or(f64::NAN), lower, upper)));
        at_root.map(|(_, separation)| separation).collect()
    }

    /// The contact of a radius; `None` if it breaks before it is as small.
    pub(super) fn contact_of_radius(&self, radius: f64, g: f64) -> Option<Contact> {
        let edge = self.law.break_away(g);
        if radius <= edge.radius {
            return None;
        }
        let residual = |s: f64| self.law.at(s, g).radius - radius;
        Some(self.law.at(root::beyond(residual, edge.parameter, 1.0, f64::INFINITY), g))
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{of, surface, table, yielding, FOLD, HERTZ};
    use super::*;
    use crate::params::HeightFamily;

    /// Radii that fall with height, so that at each separation there is a largest contact, on which smaller ones may follow and
    /// larger ones again.
    #[test]
    fn where_the_largest_contact_has_a_radius_of_the_slip_law_there_is_a_kink() {
        let falling = surface(
            [2.030_566e-3, 9.363_442e4, 2.050_705e-2, 5.229_844],
            HeightFamily::Gaussian,
            [-0.971_68, 1.257_087],
        );
        let turning = surface(
            [0.231_864_6, 101.472_3, 5.499_749e-3, 0.132_452_1],
            HeightFamily::Weibull { shape: 35.716_55 },
            [-0.482_421_9, 29.526_7],
        );
        for (params, near, distances) in [
            (falling, -0.1934, [-1e-3, -1e-5, -1e-6, -1e-7, 1e-7, 1e-6, 1e-5, 1e-3]),
            (turning, -0.0826, [-1e-3, -1e-4, -1e-5, -1e-6, 1e-6, 1e-5, 2e-5, 5e-5]),
        ] {
            let population = of(&params);
            let kinks = population.kinks();
            let kink = kinks.iter().find(|kink| (*kink - near).abs() < 1e-3);
            let kink = kink.unwrap_or_else(|| panic!("no kink near {near}: {kinks:?}"));
            let friction = |separation: f64| population.at_separation(separation).friction;
            for distance in distances {
                let (separation, step) = (kink + distance, 2e-2 * f64::abs(distance));
                let secant = (friction(separation + step) - friction(separation - step)) / (2.0 * step);
                let slope = population.at_separation(separation).friction_slope;
                let error = (slope / secant - 1.0).abs();
                assert!(error < 3e-6, "{distance:e} from {kink}: {slope:e}, {error:e}");
            }
        }
    }

    /// Where a function of height changes sign, from a fine grid.
    fn roots(population: &Population, f: impl Fn(f64) -> f64) -> Vec<f64> {
        let at = |i: u32| {
            let (lowest, highest) = (population.lower_cut, population.highest);
            lowest + (highest - lowest) * f64::from(i) / 3000.0
        };
        let changes = (0..3000).map(|i| (at(i), at(i + 1))).filter(|&(a, b)| (f(a) < 0.0) != (f(b) < 0.0));
        changes.map(|(a, b)| root::bracketed(&f, a, b)).collect()
    }

    #[test]
    fn kinks_of_contact_are_passed_at_breakpoints_and_where_a_summit_is_nearest_to_one() {
        for radii in [[0.0, 1.0], [0.9, 2.0], [-0.9, 2.0]] {
            let population = of(&yielding([0.05, 100.0, 0.0, 1.0], table(), radii));
            let kinks = population.kinks();
            let mut expected = Vec::new();
            for overlap in population.kinks_of_contact {
                assert!(overlap.is_finite() && overlap > 0.0);
                let distance = |z: f64| z - overlap * population.radius.factor(z);
                let slope = |z: f64| (distance(z + 1e-5) - distance(z - 1e-5)) / 2e-5;
                expected.extend(population.heights.breakpoints().iter().map(|&z| distance(z)));
                expected.extend(roots(&population, slope).into_iter().map(distance));
            }
            // And where contact begins, and the slip law has its radii.
            expected.extend(population.heights.breakpoints().iter().copied());
            for separation in &expected {
                let nearest = kinks.iter().map(|kink| (kink - separation).abs()).fold(f64::MAX, f64::min);
                assert!(nearest < 1e-7, "{radii:?}: none at {separation} in {kinks:?}");
            }
        }
    }

    #[test]
    fn where_the_edge_of_contact_has_a_radius_of_the_slip_law_there_is_a_kink() {
        let mut params = surface(FOLD, HeightFamily::Gaussian, [0.9, 0.7]);
        let plain = of(&params);
        let edge = |z: f64| Edge::at(&*plain.law, &plain.radius, z).point.contact;
        params.slip.radius_1 = edge(0.4).radius;
        let population = of(&params);
        let expected = 0.4 - edge(0.4).overlap;
        let nearest = population.kinks().iter().map(|kink| (kink - expected).abs()).fold(f64::MAX, f64::min);
        assert!(nearest < 1e-9, "{nearest:e}");
    }

    #[test]
    fn a_lower_end_that_is_a_power_is_a_kink_and_no_two_are_one() {
        let population = of(&surface(HERTZ, HeightFamily::Weibull { shape: 2.2 }, [0.0, 1.0]));
        let kinks = population.kinks();
        let (lower_end, _) = population.heights.outline().support;
        assert!(kinks.iter().any(|kink| (kink - lower_end).abs() < 1e-12), "{lower_end} is not in {kinks:?}");
        assert!(kinks.windows(2).all(|pair| pair[1] - pair[0] > SAME_KINK), "{kinks:?}");
        // Heights without ends and breakpoints have none where radii are equal.
        assert!(of(&surface(HERTZ, HeightFamily::Gaussian, [0.0, 1.0])).kinks().is_empty());
    }
}
