//! A panel of the curve: polynomials through exact states with their slopes, of friction and stiffness against s, and of s against
//! separation, by which the curve is read the other way.

use super::position::Positions;
use super::tolerance::{self, larger};
use super::Quantity;
use crate::numerics::elementary::{cos, log};
use crate::numerics::quadrature;
use crate::numerics::root;

/// Exact states per panel.
pub const PANEL_NODES: usize = 10;
/// Where its node j lies, from -1 to 1.
pub fn chebyshev(j: usize) -> f64 {
    -cos(std::f64::consts::PI * (j as f64 + 0.5) / PANEL_NODES as f64)
}

/// Interpolation conditions per panel: value and slope at each of them.
const CONDITIONS: usize = 2 * PANEL_NODES;
/// Where a panel is compared between its nodes, from -1 to 1.
pub const PANEL_CHECKS: [f64; 2] = [0.1, 0.8];
/// Next to a kink the slope of the stiffness is harder to resolve than that of friction: it need only be as good as values ask for, which
/// leaves it within 1e-3 where the load is within 1 % of a kink, and within 1e-6 elsewhere.
const SLACK: f64 = 2.0;
/// In panels that span less than this of s, differences of logarithms have lost the digits that its slopes have.
const NARROW: f64 = 2e-4;

/// A number for each quantity.
pub type PerQuantity = [f64; Quantity::COUNT];

/// An exact state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub separation: f64,
    /// 1 - psi, and its slope by separation.
    pub crowding: (f64, f64),
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
}

/// A stretch of the curve, with s falling as separation grows.
#[derive(Debug, Clone)]
pub struct CurvePanel {
    /// s at its ends.
    pub lowest: f64,
    pub highest: f64,
    /// The separations there.
    pub begin: f64,
    pub end: f64,
    log_value: [Hermite; Quantity::COUNT],
    length: Length,
    s: Hermite,
}

/// What lengths in separation are measured in.
#[derive(Debug, Clone, Copy)]
pub enum Length {
    Separation,
    Position(Positions),
}

impl Length {
    /// The length of a panel from one separation to another.
    pub fn of(positions: Positions, from: f64, to: f64) -> Self {
        match positions.is_short(from, to) {
            true => Self::Separation,
            false => Self::Position(positions),
        }
    }

    /// The separation at a place.
    pub fn beyond(self, from: f64, place: f64) -> f64 {
        match self {
            Self::Separation => from + place,
            Self::Position(positions) => positions.separation(positions.position(from) + place),
        }
    }

    /// The second derivative of a separation by its place.
    pub fn bend(self, separation: f64) -> f64 {
        match self {
            Self::Separation => 0.0,
            Self::Position(positions) => positions.bend(separation),
        }
    }

    /// From one separation to another, and its slope by the latter.
    pub fn between(self, from: f64, to: f64) -> (f64, f64) {
        match self {
            Self::Separation => (to - from, 1.0),
            Self::Position(positions) => (positions.position(to) - positions.position(from), positions.density(to)),
        }
    }
}

impl CurvePanel {
    /// From one state to another, through the states at its nodes.
    pub fn new(from: &Sample, to: &Sample, positions: Positions, nodes: &[Sample; PANEL_NODES]) -> Self {
        let is_narrow = from.s - to.s < NARROW;
        let length = Length::of(positions, from.separation, to.separation);
        let log_value = std::array::from_fn(|quantity| {
            let rise = |node: &Sample| log(node.value[quantity] / nodes[0].value[quantity]);
            let (places, slopes) =
                (nodes.each_ref().map(|node| node.s), nodes.each_ref().map(|node| node.slope[quantity]));
            let values = if is_narrow { integrals(&places, slopes) } else { nodes.each_ref().map(rise) };
            Hermite::new(nodes[0].log_value[quantity], places, values, slopes)
        });
        let places = nodes.each_ref().map(|node| length.between(from.separation, node.separation));
        let slopes = std::array::from_fn(|i| nodes[i].s_by_separation / places[i].1);
        let places = places.map(|(place, _)| place);
        let values = match is_narrow {
            true => integrals(&places, slopes),
            false => nodes.each_ref().map(|node| node.s - nodes[0].s),
        };
        let s = Hermite::new(nodes[0].s, places, values, slopes);
        let (begin, end) = (from.separation, to.separation);
        Self { lowest: to.s, highest: from.s, begin, end, log_value, length, s }
    }

    pub fn holds(&self, s: f64) -> bool {
        s >= self.lowest && s <= self.highest
    }

    /// The logarithm of a quantity and its derivative by s.
    #[inline(always)] // so that several are worked out side by side
    pub fn log_value_at<const N: usize>(&self, quantity: Quantity, s: [f64; N]) -> [(f64, f64); N] {
        s.map(|s| self.log_value[quantity as usize].at(s))
    }

    /// s and ds/d(separation) at a separation.
    pub fn s_at(&self, separation: f64) -> (f64, f64) {
        let (place, density) = self.length.between(self.begin, separation);
        let (s, slope) = self.s.at(place);
        (s, slope * density)
    }

    /// s at a place, and its slope by that.
    pub fn s_at_place(&self, place: f64) -> (f64, f64) {
        self.s.at(place)
    }

    /// The separation at s.
    pub fn separation_at(&self, s: f64) -> f64 {
        root::bracketed(|separation| self.s_at(separation).0 - s, self.begin, self.end)
    }

    /// How far exact states that are not its nodes lie from it, over the tolerance, which is so many times larger for slopes.
    pub fn error_over_tolerance(&self, slope_slack: f64, states: &[&Sample]) -> f64 {
        let errors = states.iter().flat_map(|state| {
            let friction = self.error_at(Quantity::Friction, state, slope_slack);
            [friction, self.error_at(Quantity::Radius, state, SLACK * slope_slack), self.error_of_s(state, slope_slack)]
        });
        errors.fold(0.0, larger)
    }

    /// How far a quantity of a state lies from the curve, over the tolerance, which is so many times larger for slopes.
    fn error_at(&self, quantity: Quantity, state: &Sample, slack: f64) -> f64 {
        let [(value, slope)] = self.log_value_at(quantity, [state.s]);
        let exact = (state.log_value[quantity as usize], state.slope[quantity as usize]);
        error_over_tolerance((value, slope), exact, slack)
    }

    fn error_of_s(&self, state: &Sample, slack: f64) -> f64 {
        error_over_tolerance(self.s_at(state.separation), (state.s, state.s_by_separation), slack)
    }
}

/// The error of a value and of its slope over the tolerance, whichever is larger; infinite where either is not a number. Slopes are not
/// known at pull-off itself.
fn error_over_tolerance((value, slope): (f64, f64), exact: (f64, f64), slack: f64) -> f64 {
    let error = (value - exact.0).abs() / tolerance::VALUE;
    let slope_error = if exact.1.is_nan() { 0.0 } else { (slope / exact.1 - 1.0).abs() / (slack * tolerance::SLOPE) };
    larger(error, slope_error)
}

/// A polynomial with given values and slopes at its nodes.
#[derive(Debug, Clone)]
pub struct Hermite {
    /// The value at the first node, to which the others are relative.
    reference: f64,
    nodes: [f64; PANEL_NODES],
    /// The coefficients of Newton's form, each node twice.
    coefficients: [f64; CONDITIONS],
}

impl Hermite {
    /// With these values, relative to a reference, and slopes.
    pub fn new(
        reference: f64,
        nodes: [f64; PANEL_NODES],
        values: [f64; PANEL_NODES],
        slopes: [f64; PANEL_NODES],
    ) -> Self {
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
        Self { reference, nodes, coefficients }
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
        (self.reference + value, slope)
    }
}

/// What a function rises by from the first node to each, of which these are the slopes.
fn integrals(nodes: &[f64; PANEL_NODES], mut slopes: [f64; PANEL_NODES]) -> [f64; PANEL_NODES] {
    // Newton's form of the polynomial through the slopes.
    for order in 1..PANEL_NODES {
        for i in (order..PANEL_NODES).rev() {
            slopes[i] = (slopes[i] - slopes[i - 1]) / (nodes[i] - nodes[i - order]);
        }
    }
    let slope = |at: f64| {
        let higher = slopes[..PANEL_NODES - 1].iter().zip(nodes).rev();
        higher.fold(slopes[PANEL_NODES - 1], |value, (coefficient, node)| value * (at - node) + coefficient)
    };
    let mut sum = 0.0;
    std::array::from_fn(|i| {
        if i > 0 {
            let rise: f64 = quadrature::nodes(nodes[i - 1], nodes[i]).map(|(at, weight)| weight * slope(at)).sum();
            sum += rise * (nodes[i] - nodes[i - 1]).signum();
        }
        sum
    })
}
