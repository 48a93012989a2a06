//! A summit in contact at its height, how its contact changes with height, and guesses at those between two.

use super::break_edges::Edge;
use super::Population;
use crate::asperity::maugis::Contact;

/// A summit in contact, at its height.
#[derive(Debug, Clone, Copy)]
pub struct Point {
    pub z: f64,
    pub g: f64,
    pub g_rate: f64,
    pub contact: Contact,
}

impl Population {
    /// The contact of a summit `rise` above another, from a starting theta.
    pub(super) fn point(&self, from: &Point, rise: f64, guess: f64) -> Point {
        let z = from.z + rise;
        let (g, g_rate) = self.radius.at(z);
        Point { z, g, g_rate, contact: self.maugis.at_overlap(from.contact.overlap + rise, g, guess) }
    }

    /// The contact of a summit of height z, from nothing.
    pub(super) fn point_cold(&self, separation: f64, z: f64) -> Point {
        let (g, g_rate) = self.radius.at(z);
        let overlap = z - separation;
        Point { z, g, g_rate, contact: self.maugis.at_overlap(overlap, g, self.maugis.guess(overlap, g)) }
    }

    pub(super) fn edge_point(&self, edge: &Edge) -> Point {
        let (g, g_rate) = self.radius.at(edge.z);
        Point { z: edge.z, g, g_rate, contact: edge.contact }
    }
}

impl Point {
    /// The same contact of a higher summit at a larger separation.
    pub fn raised(&self, separation: f64) -> Self {
        Point { z: self.z + separation, ..*self }
    }

    /// A starting theta on the way to a contact of smaller theta, when `part` of the overlap between is gone.
    pub fn guess_towards(&self, theta_far: f64, part: f64) -> f64 {
        let (from, to) = (inverse_square(self.contact.theta), inverse_square(theta_far));
        1.0 / (from + part * (to - from)).sqrt()
    }

    /// How much higher it is than another: from overlaps where these are known to more digits.
    pub fn rise_above(&self, other: &Self) -> f64 {
        if self.contact.overlap.abs() < self.z.abs() {
            self.contact.overlap - other.contact.overlap
        } else {
            self.z - other.z
        }
    }

    /// Whether it is on the way from one to another, beyond rounding.
    pub fn is_on_the_way(&self, here: &Self, end: &Self) -> bool {
        let known = self.contact.overlap.abs().min(self.z.abs());
        self.rise_above(here) * (end.z - here.z).signum() > 4.0 * f64::EPSILON * known
    }

    /// dtheta/dz at fixed separation.
    pub fn theta_slope(&self) -> f64 {
        let rate = self.contact.overlap_rate;
        if rate < -f64::MIN_POSITIVE {
            (1.0 - self.contact.overlap_by_g * self.g_rate) / rate
        } else {
            0.0 // at break-away it is infinite
        }
    }

    /// da/dz at fixed separation.
    pub fn radius_slope(&self) -> f64 {
        self.contact.radius_rate * self.theta_slope() + self.contact.radius_by_g * self.g_rate
    }

    /// da/dz times a positive factor that makes it smooth also at break-away.
    pub fn radius_rise(&self) -> f64 {
        let c = &self.contact;
        -(c.radius_rate * (1.0 - c.overlap_by_g * self.g_rate) + c.radius_by_g * self.g_rate * c.overlap_rate)
    }
}

/// Starting values of theta from one point to another, by theta^-2, which is smooth in overlap under load.
///
/// A cubic from values and slopes at both points, corrected by what is known of its error from the values solved for
/// on the way: over part^2 (1 - part)^2 that is smooth.
pub struct Guess {
    cubic: [f64; 4],
    /// Where the cubic may not leave.
    range: (f64, f64),
    /// The last errors over part^2 (1 - part)^2, at which parts.
    errors: [(f64, f64); 3],
    known: usize,
}

impl Guess {
    /// From values and slopes at two points `rise` apart.
    pub fn new(from: &Point, to: &Point, rise: f64) -> Self {
        let slope = |point: &Point| {
            -2.0 * rise * point.theta_slope() * inverse_square(point.contact.theta) / point.contact.theta
        };
        let (start, start_slope, end_slope) = (inverse_square(from.contact.theta), slope(from), slope(to));
        let end = inverse_square(to.contact.theta);
        let change = end - start;
        let cubic =
            [start, start_slope, 3.0 * change - 2.0 * start_slope - end_slope, start_slope + end_slope - 2.0 * change];
        Self { cubic, range: (0.5 * start.min(end), 2.0 * start.max(end)), errors: [(0.0, 0.0); 3], known: 0 }
    }

    /// theta where `part` of the rise is done.
    pub fn at(&self, part: f64) -> f64 {
        let [(a, at_a), (b, at_b), (c, at_c)] = self.errors;
        let error = match self.known {
            0 => 0.0,
            1 => at_a,
            2 => at_a + (at_b - at_a) * (part - a) / (b - a),
            _ => {
                let (ab, bc) = ((at_b - at_a) / (b - a), (at_c - at_b) / (c - b));
                at_a + (part - a) * (ab + (part - b) * (bc - ab) / (c - a))
            }
        };
        let value = self.cubic(part) + error * bubble(part);
        1.0 / value.max(self.range.0).min(self.range.1).sqrt()
    }

    /// Takes in the value found at a part.
    pub fn learn(&mut self, part: f64, theta: f64) {
        let error = (part, (inverse_square(theta) - self.cubic(part)) / bubble(part));
        if self.known < 3 {
            self.errors[self.known] = error;
            self.known += 1;
        } else {
            self.errors = [self.errors[1], self.errors[2], error];
        }
    }

    fn cubic(&self, part: f64) -> f64 {
        let [a, b, c, d] = self.cubic;
        a + part * (b + part * (c + part * d))
    }
}

fn inverse_square(theta: f64) -> f64 {
    1.0 / (theta * theta)
}

/// part^2 (1 - part)^2.
fn bubble(part: f64) -> f64 {
    let x = part * (1.0 - part);
    x * x
}

#[cfg(test)]
pub mod tests {
    use super::super::tests::{population, unequal};
    use super::*;
    use crate::params::HeightFamily;

    /// A summit at a height, whose contact has a radius with a slope.
    pub fn summit(z: f64, radius: f64, slope: f64) -> Point {
        let mut point = population(HeightFamily::Gaussian).point_cold(-2.0, 0.0);
        (point.z, point.g_rate) = (z, 1.0);
        (point.contact.radius, point.contact.radius_rate, point.contact.radius_by_g) = (radius, 0.0, slope);
        point
    }

    /// The slopes of theta and of the contact radius with height.
    #[test]
    fn slopes_at_a_separation_are_those_of_secants() {
        for population in [unequal(0.6, 1.5), unequal(-0.9, 4.0)] {
            for z in [-1.5, -0.2, 0.1, 0.9] {
                let here = population.point_cold(-2.0, z);
                let step = 1e-5;
                let [before, after] = [-step, step].map(|rise| population.point(&here, rise, here.contact.theta));
                let secant = |of: fn(&Point) -> f64| (of(&after) - of(&before)) / (2.0 * step);
                let (theta, radius) = (secant(|point| point.contact.theta), secant(|point| point.contact.radius));
                assert!((here.theta_slope() / theta - 1.0).abs() < 1e-7, "{} not {theta} at {z}", here.theta_slope());
                assert!(
                    (here.radius_slope() / radius - 1.0).abs() < 1e-7,
                    "{} not {radius} at {z}",
                    here.radius_slope()
                );
                let rise = -radius * here.contact.overlap_rate;
                assert!((here.radius_rise() / rise - 1.0).abs() < 1e-7, "{} not {rise} at {z}", here.radius_rise());
            }
        }
    }

    #[test]
    fn nothing_is_on_the_way_to_itself() {
        let mut here = summit(0.3, 5.0, 1.0);
        let there = summit(0.8, 5.0, 1.0);
        for overlap in [0.0, 0.7] {
            here.contact.overlap = overlap;
            let higher = Point { z: 0.5, contact: Contact { overlap: overlap + 0.2, ..here.contact }, ..here };
            assert!(!here.is_on_the_way(&here, &there) && higher.is_on_the_way(&here, &there));
            let lower = Point { z: -0.2, ..there };
            assert!(!here.is_on_the_way(&here, &lower) && !higher.is_on_the_way(&here, &lower));
        }
    }
}
