//! A panel of the curve read the other way: its coordinate s against separation, by Hermite interpolation through the same
//! exact states. From s follows the load.

use super::non_integer_power::NonIntegerPower;
use super::panel::{hermite, hermite_at, integrals, larger, Sample, NODES};
use super::position::Positions;
use super::CONDITIONS;

/// The largest error of s, and of its slope relative to the slope, at which it is good: the load's is twice as large.
const VALUE_TOLERANCE: f64 = 1e-10;
const SLOPE_TOLERANCE: f64 = 1e-8;
/// A panel shorter than this is measured in separations: positions have too few digits.
const SHORT: f64 = 0.1;
/// So near to an end, as a part of the panel, slopes have lost digits where s is a non-integer power of the distance.
const NEAR_NON_INTEGER_POWER: f64 = 1e-6;

/// s against separation.
#[derive(Debug, Clone)]
pub struct BySeparation {
    /// The separations at its ends.
    pub begin: f64,
    pub end: f64,
    length: Length,
    /// The length of all of it.
    whole: f64,
    non_integer_power: NonIntegerPower,
    /// s at the first node.
    reference: f64,
    nodes: [f64; NODES],
    /// s less the reference, in Newton's form, each node twice.
    coefficients: [f64; CONDITIONS],
}

/// What lengths on a panel are measured in.
#[derive(Debug, Clone, Copy)]
enum Length {
    Separation,
    Position(Positions),
}

impl Length {
    /// From one separation to another, and its slope by the latter.
    fn between(self, from: f64, to: f64) -> (f64, f64) {
        match self {
            Self::Separation => (to - from, 1.0),
            Self::Position(positions) => (positions.position(to) - positions.position(from), positions.density(to)),
        }
    }
}

impl BySeparation {
    /// Of a panel between two separations with these exact states.
    pub fn new(
        (begin, end): (f64, f64),
        positions: Positions,
        non_integer_power: NonIntegerPower,
        samples: &[Sample; NODES],
        is_narrow: bool,
    ) -> Self {
        let length = match (end - begin) * positions.density(begin) < SHORT {
            true => Length::Separation,
            false => Length::Position(positions),
        };
        let mut panel = Self {
            begin,
            end,
            length,
            whole: length.between(begin, end).0,
            non_integer_power,
            reference: samples[0].s,
            nodes: [0.0; NODES],
            coefficients: [0.0; CONDITIONS],
        };
        let places = samples.each_ref().map(|sample| panel.place(sample.separation));
        panel.nodes = places.map(|(place, _)| place);
        let slopes = std::array::from_fn(|i| samples[i].s_by_separation / places[i].1);
        let values = match is_narrow {
            true => integrals(&panel.nodes, slopes),
            false => samples.each_ref().map(|sample| sample.s - samples[0].s),
        };
        panel.coefficients = hermite(&panel.nodes, values, slopes);
        panel
    }

    /// The cubic between two states.
    pub fn bridge(from: &Sample, to: &Sample) -> Self {
        let width = to.separation - from.separation;
        let (start, end, rise) = (from.s_by_separation, to.s_by_separation, to.s - from.s);
        let mut nodes = [-width; NODES];
        nodes[0] = 0.0;
        // Newton's form, the first node twice and then the last, in minus the separation.
        let mut coefficients = [0.0; CONDITIONS];
        coefficients[1] = -start;
        coefficients[2] = (rise - start * width) / (width * width);
        coefficients[3] = -(start + end - 2.0 * rise / width) / (width * width);
        Self {
            begin: from.separation,
            end: to.separation,
            length: Length::Separation,
            whole: width,
            non_integer_power: NonIntegerPower::Nowhere,
            reference: from.s,
            nodes,
            coefficients,
        }
    }

    /// Where a separation lies among the nodes, and d(that)/d(separation). Lengths run from minus the whole at its end to 0.
    fn place(&self, separation: f64) -> (f64, f64) {
        let (length, density) = self.length.between(self.begin, separation);
        let (place, rate) = self.non_integer_power.place((-self.whole, 0.0), -length);
        (place, -density * rate)
    }

    /// s and ds/d(separation).
    pub fn at(&self, separation: f64) -> (f64, f64) {
        let (place, rate) = self.place(separation);
        let (value, slope) = hermite_at(&self.nodes, &self.coefficients, place);
        (self.reference + value, slope * rate)
    }

    /// The largest error at exact states over its tolerance, of slopes over so many times theirs.
    pub fn error_over_tolerance(&self, samples: &[(&Sample, f64)]) -> f64 {
        samples.iter().map(|(sample, slack)| self.error_at(sample, *slack)).fold(0.0, larger)
    }

    fn error_at(&self, sample: &Sample, slope_slack: f64) -> f64 {
        let (s, slope) = self.at(sample.separation);
        let value_error = (s - sample.s).abs() / VALUE_TOLERANCE;
        let exact = sample.s_by_separation;
        let near = NEAR_NON_INTEGER_POWER * (self.end - self.begin);
        let is_near = (sample.separation - self.begin).min(self.end - sample.separation) <= near;
        // Slopes are known neither at pull-off itself nor at a non-integer power.
        if exact.is_nan() || (is_near && self.non_integer_power != NonIntegerPower::Nowhere) {
            return value_error;
        }
        larger(value_error, (slope / exact - 1.0).abs() / (slope_slack * SLOPE_TOLERANCE))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::law::Quantity;

    /// s = 40 - d - d^2/8 at separations d.
    fn sample(separation: f64) -> Sample {
        let none = [f64::NAN; Quantity::COUNT];
        Sample {
            separation,
            position: f64::NAN,
            log_excess: f64::NAN,
            s: 40.0 - separation - separation * separation / 8.0,
            s_by_separation: -1.0 - separation / 4.0,
            log_value: none,
            value: none,
            slope: none,
            log_slope: none,
        }
    }

    fn nodes(begin: f64, end: f64, power: NonIntegerPower) -> [Sample; NODES] {
        std::array::from_fn(|j| {
            let part = -(std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64).cos();
            sample(begin + (end - begin) * (0.5 + 0.5 * power.part(part)))
        })
    }

    #[test]
    fn the_coordinate_and_its_slope_are_those_of_exact_states() {
        let positions = Positions { middle: 0.0 };
        for (begin, end, narrow) in [(0.5, 2.5, &[false][..]), (0.5, 0.500_1, &[false, true])] {
            for power in [NonIntegerPower::Nowhere, NonIntegerPower::AtBegin, NonIntegerPower::AtEnd] {
                for &is_narrow in narrow {
                    let samples = nodes(begin, end, power);
                    let panel = BySeparation::new((begin, end), positions, power, &samples, is_narrow);
                    for part in [0.01, 0.3, 0.77, 0.99] {
                        let exact = sample(begin + part * (end - begin));
                        let (s, slope) = panel.at(exact.separation);
                        assert!((s - exact.s).abs() < 0.3 * VALUE_TOLERANCE, "{power:?}: {s}, not {}", exact.s);
                        assert!((slope / exact.s_by_separation - 1.0).abs() < 1e-8, "{power:?}, {part}: {slope}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_bridge_has_the_values_and_slopes_of_its_ends() {
        let (from, to) = (sample(0.5), sample(0.51));
        let bridge = BySeparation::bridge(&from, &to);
        for exact in [from, sample(0.503), to] {
            let (s, slope) = bridge.at(exact.separation);
            assert!((s - exact.s).abs() < 1e-13, "{s}, not {}", exact.s);
            assert!((slope / exact.s_by_separation - 1.0).abs() < 1e-10, "{slope}");
        }
    }

    #[test]
    fn a_panel_says_how_far_exact_states_lie_from_it() {
        let power = NonIntegerPower::Nowhere;
        let panel = BySeparation::new((0.5, 2.5), Positions { middle: 0.0 }, power, &nodes(0.5, 2.5, power), false);
        let exact = sample(1.3);
        for (s, slope, expected) in [(2.0, 0.0, 2.0), (-2.0, 0.0, 2.0), (0.0, 11.0, 2.2)] {
            let moved = Sample {
                s: exact.s + s * VALUE_TOLERANCE,
                s_by_separation: exact.s_by_separation * (1.0 + slope * SLOPE_TOLERANCE),
                ..exact
            };
            let error = panel.error_over_tolerance(&[(&exact, 5.0), (&moved, 5.0)]);
            assert!((error - expected).abs() < 0.4, "{s}, {slope}: {error}");
        }
    }
}
