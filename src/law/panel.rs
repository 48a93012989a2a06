//! A panel of the curve: the polynomial through exact states, with their slopes.

use super::non_integer_power::NonIntegerPower;
use super::Quantity;
use super::CONDITIONS;
use crate::elementary::log;
use crate::numerics::quadrature;

/// Exact states per panel.
pub const NODES: usize = CONDITIONS / 2;
/// Largest error of a logarithm, and of its slope relative to the slope, at which a panel is good.
const VALUE_TOLERANCE: f64 = 1e-10;
const SLOPE_TOLERANCE: f64 = 1e-8;
/// Up to this s the slope of the load is a difference of integrals that nearly cancel, and so many times the tolerance is
/// what slopes are known to.
const NEAR_PULL_OFF: f64 = 1.0;
const NOISE: f64 = 4.0;
/// In panels that span less than this of s, differences of logarithms have lost the digits that its slopes have.
const NARROW: f64 = 2e-4;

/// A number for each quantity.
pub type PerQuantity = [f64; Quantity::COUNT];

/// An exact state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub separation: f64,
    /// As [`Positions`](super::position::Positions) has it.
    pub position: f64,
    /// ln(load - pull-off load).
    pub log_excess: f64,
    pub s: f64,
    pub s_by_separation: f64,
    /// ln of the quantities over the references of the curve.
    pub log_value: PerQuantity,
    /// The quantities themselves: differences of logarithms lose fewer digits with them.
    pub value: PerQuantity,
    /// Slopes of the logarithms by s.
    pub slope: PerQuantity,
    /// By ln x.
    pub log_slope: PerQuantity,
}

/// A stretch of the curve, with s falling as separation grows.
#[derive(Debug, Clone)]
pub struct Panel {
    /// s at its ends.
    pub lowest: f64,
    pub highest: f64,
    non_integer_power: NonIntegerPower,
    /// The logarithms at the first node, to which the others are relative.
    reference: PerQuantity,
    /// In s, or in the root of the distance from the non-integer power.
    nodes: [f64; NODES],
    /// The logarithms in Newton's form, each node twice.
    log_value: [[f64; CONDITIONS]; Quantity::COUNT],
    /// The position of the separation in Newton's form, each node once.
    pub position: [f64; NODES],
}

impl Panel {
    pub fn new((lowest, highest): (f64, f64), non_integer_power: NonIntegerPower, samples: &[Sample; NODES]) -> Self {
        let places = samples.map(|sample| non_integer_power.place((lowest, highest), sample.s));
        let nodes = places.map(|(place, _)| place);
        let is_narrow = highest - lowest < NARROW;
        let log_value = std::array::from_fn(|quantity| {
            let slopes = std::array::from_fn(|i| samples[i].slope[quantity] / places[i].1);
            let values = match is_narrow {
                true => integrals(&nodes, slopes),
                false => samples.map(|sample| log(sample.value[quantity] / samples[0].value[quantity])),
            };
            hermite(&nodes, values, slopes)
        });
        let position = differences(&nodes, samples.map(|sample| sample.position));
        let reference = samples[0].log_value;
        Self { lowest, highest, non_integer_power, reference, nodes, log_value, position }
    }

    /// The cubic between two states.
    pub fn bridge(from: &Sample, to: &Sample) -> Self {
        let width = to.s - from.s;
        let mut nodes = [to.s; NODES];
        nodes[0] = from.s;
        let log_value = std::array::from_fn(|quantity| {
            let (start, end) = (from.slope[quantity], to.slope[quantity]);
            let mut log_value = [0.0; CONDITIONS];
            (log_value[1], log_value[2]) = (start, (0.5 * (start + end) - start) / width);
            log_value
        });
        let mut line = [0.0; NODES];
        (line[0], line[1]) = (from.position, (to.position - from.position) / width);
        Self {
            lowest: to.s,
            highest: from.s,
            non_integer_power: NonIntegerPower::Nowhere,
            reference: from.log_value,
            nodes,
            log_value,
            position: line,
        }
    }

    pub fn holds(&self, s: f64) -> bool {
        s >= self.lowest && s <= self.highest
    }

    /// The logarithm of a quantity and its derivative by s.
    pub fn log_value_at<const N: usize>(&self, quantity: Quantity, s: [f64; N]) -> [(f64, f64); N] {
        s.map(|s| self.place(s)).map(|(place, rate)| {
            let (value, slope) = self.polynomial(quantity, place);
            (value, slope * rate)
        })
    }

    #[inline(always)] // so that several are worked out side by side
    fn polynomial(&self, quantity: Quantity, place: f64) -> (f64, f64) {
        let (value, slope) = hermite_at(&self.nodes, &self.log_value[quantity as usize], place);
        (self.reference[quantity as usize] + value, slope)
    }

    /// Where s lies among the nodes, and d(that)/ds.
    fn place(&self, s: f64) -> (f64, f64) {
        self.non_integer_power.place((self.lowest, self.highest), s)
    }

    pub fn position_at(&self, s: f64) -> f64 {
        newton(&self.nodes, &self.position, self.place(s).0)
    }

    pub fn is_narrow(&self) -> bool {
        self.highest - self.lowest < NARROW
    }

    /// The middle of the widest gap between neighbouring nodes.
    pub fn sparsest(&self) -> f64 {
        let gap = |pair: &[f64]| (pair[1] - pair[0]).abs();
        let widest = self.nodes.windows(2).max_by(|a, b| gap(a).total_cmp(&gap(b)));
        let place = widest.map_or(self.nodes[0], |pair| 0.5 * (pair[0] + pair[1]));
        self.non_integer_power.s_at((self.lowest, self.highest), place)
    }

    /// How far an exact state lies from the curve, over the tolerance; infinite where either is not a number. The
    /// slope may miss by so many times its tolerance.
    pub fn error_over_tolerance(&self, quantity: Quantity, sample: &Sample, slope_slack: f64) -> f64 {
        let [(value, slope)] = self.log_value_at(quantity, [sample.s]);
        let exact = sample.slope[quantity as usize];
        let value_error = (value - sample.log_value[quantity as usize]).abs() / VALUE_TOLERANCE;
        // Slopes are known neither at pull-off itself nor at a non-integer power.
        if exact.is_nan() || self.non_integer_power.is_at((self.lowest, self.highest), sample.s) {
            return value_error;
        }
        let tolerance = if sample.s < NEAR_PULL_OFF { NOISE * SLOPE_TOLERANCE } else { SLOPE_TOLERANCE };
        larger(value_error, (slope / exact - 1.0).abs() / (slope_slack * tolerance))
    }
}

/// The coefficients of Newton's form of the polynomial with these values and slopes at the nodes.
pub fn hermite(nodes: &[f64; NODES], values: [f64; NODES], slopes: [f64; NODES]) -> [f64; CONDITIONS] {
    // Divided differences; between the two copies of a node they are the slope.
    let mut coefficients: [f64; CONDITIONS] = std::array::from_fn(|i| values[i / 2]);
    for order in 1..CONDITIONS {
        for i in (order..CONDITIONS).rev() {
            let (a, b) = (nodes[(i - order) / 2], nodes[i / 2]);
            coefficients[i] = match order == 1 && i % 2 == 1 {
                true => slopes[i / 2],
                false => (coefficients[i] - coefficients[i - 1]) / (b - a),
            };
        }
    }
    coefficients
}

/// That polynomial and its derivative.
#[inline(always)] // so that several are worked out side by side
pub fn hermite_at(nodes: &[f64; NODES], coefficients: &[f64; CONDITIONS], at: f64) -> (f64, f64) {
    let (mut value, mut slope) = (0.0, 0.0);
    for (node, pair) in nodes.iter().zip(coefficients.chunks_exact(2)).rev() {
        let distance = at - node;
        for coefficient in [pair[1], pair[0]] {
            slope = slope * distance + value;
            value = value * distance + coefficient;
        }
    }
    (value, slope)
}

/// The coefficients of Newton's form of the polynomial with these values at the nodes.
fn differences(nodes: &[f64; NODES], mut values: [f64; NODES]) -> [f64; NODES] {
    for order in 1..NODES {
        for i in (order..NODES).rev() {
            values[i] = (values[i] - values[i - 1]) / (nodes[i] - nodes[i - order]);
        }
    }
    values
}

fn newton(nodes: &[f64; NODES], coefficients: &[f64; NODES], at: f64) -> f64 {
    let higher = coefficients[..NODES - 1].iter().zip(nodes).rev();
    higher.fold(coefficients[NODES - 1], |value, (coefficient, node)| value * (at - node) + coefficient)
}

/// What a function rises by from the first node to each, of which these are the slopes.
pub fn integrals(nodes: &[f64; NODES], slopes: [f64; NODES]) -> [f64; NODES] {
    let slopes = differences(nodes, slopes);
    let mut sum = 0.0;
    std::array::from_fn(|i| {
        if i > 0 {
            let points = quadrature::nodes(nodes[i - 1], nodes[i]);
            let rise = points.map(|(s, weight)| weight * newton(nodes, &slopes, s)).sum::<f64>();
            sum += rise * (nodes[i] - nodes[i - 1]).signum();
        }
        sum
    })
}

/// The larger of two numbers, infinite if either is not one.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}

#[cfg(test)]
impl Sample {
    /// Another force and slope at the same load.
    pub fn moved(self, log_value: f64, log_slope: f64) -> Self {
        let log_value = self.log_value.map(|value| value + log_value);
        Self { log_value, log_slope: self.log_slope.map(|slope| slope * (1.0 + log_slope)), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

    /// The logarithms are 2 + 3 s + s^2/2 and s^2 at positions 1 - s.
    fn sample(s: f64) -> Sample {
        let (log_value, slope) = ([2.0 + 3.0 * s + 0.5 * s * s, s * s], [3.0 + s, 2.0 * s]);
        Sample {
            separation: 1.0 - s,
            position: 1.0 - s,
            log_excess: 2.0 * s,
            s,
            s_by_separation: -1.0,
            log_value,
            value: log_value.map(f64::exp),
            slope,
            log_slope: [f64::NAN; 2],
        }
    }

    fn parabola() -> Panel {
        let node = |j: usize| 0.1 + (1.0 + (std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64).cos()).powf(1.2);
        Panel::new((0.1, 2.5), NonIntegerPower::Nowhere, &std::array::from_fn(|j| sample(node(j))))
    }

    #[test]
    fn rises_are_the_integrals_of_slopes() {
        let nodes: [f64; NODES] = std::array::from_fn(|i| 3.0 - 1e-4 * i as f64);
        let rises = integrals(&nodes, nodes.map(|s| s * s));
        for (rise, s) in rises.into_iter().zip(nodes) {
            assert!((rise - (s.powi(3) - 27.0) / 3.0).abs() < 1e-15, "{rise} at {s}");
        }
    }

    #[test]
    fn a_panel_has_the_values_and_slopes_it_is_made_from() {
        let (panel, exact) = (parabola(), sample(1.2));
        assert!(near(panel.position_at(1.2), -0.2, 1e-13));
        for quantity in Quantity::ALL {
            let [(value, slope)] = panel.log_value_at(quantity, [1.2]);
            let (expected, expected_slope) = (exact.log_value[quantity as usize], exact.slope[quantity as usize]);
            assert!(near(value, expected, 1e-13) && near(slope, expected_slope, 1e-11), "{value}, {slope}");
        }
        let gaps = panel.nodes.windows(2).map(|pair| (pair[0] - pair[1], 0.5 * (pair[0] + pair[1])));
        let widest = gaps.max_by(|a, b| a.0.total_cmp(&b.0)).expect("gaps");
        assert!(near(panel.sparsest(), widest.1, 1e-15), "{}, not {widest:?}", panel.sparsest());
    }

    #[test]
    fn a_panel_says_how_far_exact_states_lie_from_it() {
        let (panel, exact) = (parabola(), sample(1.2));
        for quantity in Quantity::ALL {
            let off = |value: f64, slope: f64| {
                let mut off = exact;
                off.log_value[quantity as usize] += value * VALUE_TOLERANCE;
                off.slope[quantity as usize] *= 1.0 + 5.0 * slope * SLOPE_TOLERANCE;
                panel.error_over_tolerance(quantity, &off, 5.0)
            };
            for error in [[20.0, 0.0], [-20.0, 0.0], [0.0, 20.0], [0.0, -20.0]].map(|[value, slope]| off(value, slope))
            {
                assert!(near(error, 20.0, 0.1), "{error}");
            }
            assert!(off(0.0, 0.0) < 0.1 && off(f64::NAN, 0.0) == f64::INFINITY);
            // At pull-off itself there is no slope.
            let log_value = exact.log_value.map(|value| value + 5.0 * VALUE_TOLERANCE);
            let at_pull_off = Sample { slope: [f64::NAN; 2], log_value, ..exact };
            assert!(near(panel.error_over_tolerance(quantity, &at_pull_off, 1.0), 5.0, 0.1));
        }
        assert_eq!(
            [larger(1.0, f64::NAN), larger(f64::NAN, 1.0), larger(1.0, 2.0)],
            [f64::INFINITY, f64::INFINITY, 2.0]
        );
    }
}
