//! A panel of the curve: polynomials through exact states with their slopes, of friction and stiffness against s, and of s against
//! position, by which the curve is read the other way.

use super::newton::newton;
use super::tolerance::{self, larger};
use super::Quantity;
use crate::numerics::root;

/// Exact states per panel, at equal distances of position, its ends among them; where fewer are enough the last is repeated.
pub const PANEL_NODES: usize = 5;
/// Interpolation conditions per panel: value and slope at each of them.
const CONDITIONS: usize = 2 * PANEL_NODES;

/// A panel that ends at pull-off is farther off next to that than where it is compared, by up to so many times more than others.
const FARTHER_AT_PULL_OFF: f64 = 2.0;

/// A number for each quantity.
pub type PerQuantity = [f64; Quantity::COUNT];

/// An exact state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub separation: f64,
    pub position: f64,
    /// Where it is known without an integral.
    pub gap: Option<f64>,
    /// d(gap)/d(position).
    pub gap_rate: f64,
    /// 1 - psi, and its slope by position.
    pub crowding: (f64, f64),
    /// ln(load - pull-off load).
    pub log_excess: f64,
    pub s: f64,
    /// ds/d(position); no number at pull-off.
    pub s_by_position: f64,
    /// What the load changes by with s, relative to it or to the pull-off load, whichever is larger.
    pub load_by_s: f64,
    /// ln of the quantities.
    pub log_value: PerQuantity,
    /// Slopes of these by s; no numbers at pull-off.
    pub slope: PerQuantity,
}

/// A stretch of the curve, with s falling as position grows.
#[derive(Debug, Clone)]
pub struct CurvePanel {
    /// s at its ends.
    pub lowest: f64,
    pub highest: f64,
    /// The positions there.
    pub begin: f64,
    pub end: f64,
    log_value: [Hermite; Quantity::COUNT],
    s: Hermite,
}

impl CurvePanel {
    /// Through the states at its nodes.
    pub fn new(nodes: &[Sample; PANEL_NODES]) -> Self {
        let of = |number: fn(&Sample) -> f64| nodes.each_ref().map(number);
        let (position, s) = (of(|node| node.position), of(|node| node.s));
        let log_value = std::array::from_fn(|quantity| {
            let [values, slopes] = [
                nodes.each_ref().map(|node| node.log_value[quantity]),
                nodes.each_ref().map(|node| node.slope[quantity]),
            ];
            Hermite::new(s, values, slopes)
        });
        let (from, to) = (&nodes[0], &nodes[PANEL_NODES - 1]);
        let s = Hermite::new(position, s, of(|node| node.s_by_position));
        Self { lowest: to.s, highest: from.s, begin: from.position, end: to.position, log_value, s }
    }

    pub fn holds(&self, s: f64) -> bool {
        s >= self.lowest && s <= self.highest
    }

    /// The logarithm of a quantity and its derivative by s.
    #[inline(always)] // so that several are worked out side by side
    pub fn log_value_at<const N: usize>(&self, quantity: Quantity, s: [f64; N]) -> [(f64, f64); N] {
        s.map(|s| self.log_value[quantity as usize].at(s))
    }

    /// s and ds/d(position) at a position.
    pub fn s_at(&self, position: f64) -> (f64, f64) {
        self.s.at(position)
    }

    /// The position at s.
    pub fn position_at(&self, s: f64) -> f64 {
        root::bracketed(|position| self.s_at(position).0 - s, self.begin, self.end)
    }

    /// The error of the logarithm of each quantity at a state that is not a node, and the largest of all that is compared over its
    /// tolerance, which is so many times larger for slopes.
    pub fn error_at(&self, state: &Sample, slack: f64) -> (PerQuantity, f64) {
        let more = if self.lowest == 0.0 { FARTHER_AT_PULL_OFF } else { 1.0 };
        let mut worst = more * self.error_of_load(state, slack);
        let errors = Quantity::ALL.map(|quantity| {
            let [(value, slope)] = self.log_value_at(quantity, [state.s]);
            let error = more * (value - state.log_value[quantity as usize]).abs();
            let slope_error = more * (slope / state.slope[quantity as usize] - 1.0).abs();
            worst = larger(worst, larger(error / tolerance::VALUE, slope_error / (slack * tolerance::SLOPE)));
            error
        });
        (errors, worst)
    }

    /// How far the load at the position of a state lies from its load, relative to that or the pull-off load, over the tolerance.
    fn error_of_load(&self, state: &Sample, slack: f64) -> f64 {
        let (s, slope) = self.s_at(state.position);
        let error = state.load_by_s * (s - state.s).abs();
        let slope_error = state.load_by_s.min(1.0) * (slope / state.s_by_position - 1.0).abs();
        larger(error / tolerance::VALUE, slope_error / (slack * tolerance::SLOPE))
    }
}

/// A polynomial with given values and slopes at its nodes.
#[derive(Debug, Clone)]
pub struct Hermite {
    nodes: [f64; PANEL_NODES],
    /// The coefficients of Newton's form, each node twice; 0 of nodes that it has not.
    coefficients: [f64; CONDITIONS],
}

impl Hermite {
    /// With these values and slopes. A slope at the last node that is no number is left to the polynomial, of a degree less.
    pub fn new(nodes: [f64; PANEL_NODES], values: [f64; PANEL_NODES], slopes: [f64; PANEL_NODES]) -> Self {
        let end = nodes.iter().take_while(|&&node| node != nodes[PANEL_NODES - 1]).count();
        let count = 2 * end + if slopes[end].is_nan() { 1 } else { 2 };
        let twice = |of: [f64; PANEL_NODES]| -> [f64; CONDITIONS] { std::array::from_fn(|i| of[i / 2]) };
        let mut coefficients = newton(&twice(nodes), twice(values), &twice(slopes));
        coefficients[count..].fill(0.0);
        Self { nodes, coefficients }
    }

    /// The value and the slope.
    #[inline(always)] // so that several are worked out side by side
    pub fn at(&self, x: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        for (node, pair) in self.nodes.iter().zip(self.coefficients.chunks_exact(2)).rev() {
            let distance = x - node;
            for coefficient in [pair[1], pair[0]] {
                slope = slope * distance + value;
                value = value * distance + coefficient;
            }
        }
        (value, slope)
    }
}
