//! The branch of load control as a smooth curve through exact states, from which the table is filled.
//!
//! The coordinate is s = arsinh((x/|pull-off|)^(1/2)) with x = load - pull-off: near pull-off, where load has its
//! minimum over separation, it is linear in separation, far from it logarithmic in load; without adhesion it is
//! ln(x)/2. In it ln F is smooth between the kinks of the branch, and so is the logarithm of the stiffness. Panels of exact
//! states, each with its slopes, are joined by Hermite interpolation; a panel that misses the exact states between its nodes
//! is tried again shorter. Where the foot of a density that is a power passes an edge of contact, the curve is a
//! non-integer power of the distance: panels that begin or end there are in its fourth root, in which that is a high power.

use super::fill::Source;
use super::non_integer_power::NonIntegerPower;
use super::steps::{Steps, Stretch};
use super::{Quantity, CONDITIONS};
use crate::elementary::{cos, exp, exp_each, log, log1p, sinh};
use crate::equilibrium::{Branch, BranchPoint};
use std::f64::consts::LN_2;

/// Exact states per panel.
const NODES: usize = CONDITIONS / 2;
/// The branch is followed from this separation of the means, in sigma: heights with R and w as they may be carry less
/// than (1 sigma)^(3/2) when half of them touch, and 1e13 times that here.
const CLOSEST: f64 = -5e8;
/// The branch is followed from at least this much above the pull-off load, in ln(load).
const LOG_ABOVE_PULL_OFF: f64 = 9.0;
/// Largest error of a logarithm, and of its slope relative to the slope, at which a panel is good.
const VALUE_TOLERANCE: f64 = 1e-11;
const SLOPE_TOLERANCE: f64 = 1e-9;
/// Up to this s the slope of the load is a difference of integrals that nearly cancel, and so many times the tolerance is
/// what slopes are known to.
const NEAR_PULL_OFF: f64 = 1.0;
const NOISE: f64 = 4.0;
/// No more than about this many exact states are spent where kinks do not ask for more, and no more than half of them
/// to resolve loads so heavy that all summits are deep in contact; what they do not reach is evaluated exactly.
const MOST_SAMPLES: usize = 1000;
/// Where ln(sinh s) is larger, so many terms of the series of ln((1 + (1 + y)^(1/2))/2) give it to rounding.
const FAR: f64 = 3.0;
const SERIES: [f64; 5] = [1.0 / 4.0, -3.0 / 32.0, 5.0 / 96.0, -35.0 / 1024.0, 63.0 / 2560.0];
/// In panels that span less than this of s, differences of logarithms have lost the digits that its slopes have.
const NARROW: f64 = 2e-4;
/// Where a panel is compared next to a non-integer power. s has lost digits of the distance there, and slopes may miss by so
/// many times their tolerance.
const NEXT_TO_NON_INTEGER_POWER: f64 = 0.8;
const SLACK_AT_NON_INTEGER_POWER: f64 = 10.0;

/// At this separation the load rises already, or cannot be had: the branch ends before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unfollowed {
    pub separation: f64,
}

/// What s measures.
#[derive(Debug, Clone, Copy)]
struct Coordinate {
    /// ln |pull-off load|, if there is one.
    log_pull_off: Option<f64>,
    /// What logarithms are taken relative to: the quantities at pull-off, where small changes must be resolved.
    reference: PerQuantity,
}

/// A number for each quantity.
type PerQuantity = [f64; Quantity::COUNT];

/// An exact state on the branch.
#[derive(Debug, Clone, Copy)]
pub struct Sample {
    pub separation: f64,
    /// ln(load - pull-off load).
    pub log_excess: f64,
    pub s: f64,
    /// ln of the quantities over the references of the curve.
    log_value: PerQuantity,
    /// The quantities themselves: differences of logarithms lose fewer digits with them.
    value: PerQuantity,
    /// Slopes of the logarithms by s.
    slope: PerQuantity,
    /// By ln x.
    log_slope: PerQuantity,
}

/// A stretch of the curve, with s falling as separation grows.
#[derive(Debug, Clone)]
struct Panel {
    /// s at its ends.
    lowest: f64,
    highest: f64,
    non_integer_power: NonIntegerPower,
    /// The logarithms at the first node, to which the others are relative; no number where the panel misses exact states.
    reference: PerQuantity,
    /// In s, or in the root of the distance from the non-integer power.
    nodes: [f64; NODES],
    /// The logarithms in Newton's form, each node twice.
    log_value: [[f64; CONDITIONS]; Quantity::COUNT],
    /// The position of the separation, as [`Steps::position`], in Newton's form, each node once.
    position: [f64; NODES],
}

/// A panel with the exact states that it was compared with.
struct Attempt {
    panel: Panel,
    between: [Sample; 2],
    end: Sample,
    /// The largest error over its tolerance of any quantity.
    excess: f64,
}

/// The curve, from heavy to light load.
#[derive(Debug, Clone)]
pub struct Curve {
    coordinate: Coordinate,
    steps: Steps,
    panels: Vec<Panel>,
    /// Exact states spent.
    samples: usize,
}

impl Coordinate {
    /// s and ds/d(ln x) at ln x.
    fn at(self, log_excess: f64) -> (f64, f64) {
        self.at_each([log_excess])[0]
    }

    /// The same at each of several.
    fn at_each<const N: usize>(self, log_excess: [f64; N]) -> [(f64, f64); N] {
        let Some(log_pull_off) = self.log_pull_off else {
            return log_excess.map(|log_excess| (0.5 * log_excess, 0.5));
        };
        let log_sinh = log_excess.map(|log_excess| 0.5 * (log_excess - log_pull_off));
        if log_sinh.iter().all(|&log_sinh| log_sinh > FAR) {
            // s = ln 2 + ln(sinh s) + ln((1 + (1 + y)^(1/2))/2) with y = 1/sinh^2 s.
            let y = exp_each(log_sinh.map(|log_sinh| -2.0 * log_sinh));
            return std::array::from_fn(|i| {
                let y = y[i];
                let rest = y * (SERIES[0] + y * (SERIES[1] + y * (SERIES[2] + y * (SERIES[3] + y * SERIES[4]))));
                (LN_2 + log_sinh[i] + rest, 0.5 / (1.0 + y).sqrt())
            });
        }
        exp_each(log_sinh).map(|sinh| {
            let cosh = (1.0 + sinh * sinh).sqrt();
            let s = if sinh > 1.0 { log(sinh + cosh) } else { log1p(sinh + sinh * sinh / (1.0 + cosh)) };
            (s, 0.5 * sinh / cosh)
        })
    }

    /// ln x at s.
    fn log_excess(self, s: f64) -> f64 {
        match self.log_pull_off {
            Some(log_pull_off) if s > 20.0 => 2.0 * (s - LN_2) + log_pull_off,
            Some(log_pull_off) => 2.0 * log(sinh(s)) + log_pull_off,
            None => 2.0 * s,
        }
    }
}

impl Curve {
    /// Follows the branch from heavy load down to pull-off, but not farther than `log_range` of the heaviest ln(load -
    /// pull-off). Hands every exact state that is not a node to `check`.
    ///
    /// # Errors
    /// [`Unfollowed`].
    pub fn new(branch: &Branch, log_range: impl Fn(f64) -> f64, check: &mut Vec<Sample>) -> Result<Self, Unfollowed> {
        let log_pull_off = branch.pull_off().map(|point| log(-point.load));
        let reference =
            Quantity::ALL.map(|quantity| branch.pull_off().map_or(1.0, |point| quantity.at_pull_off(&point)));
        let mut steps = Steps::new(branch);
        let mut curve = Self {
            coordinate: Coordinate { log_pull_off, reference },
            steps: steps.clone(),
            panels: Vec::new(),
            samples: 0,
        };
        let closest = CLOSEST + steps.middle();
        let mut from = curve.sample(branch, closest.min(steps.end() - 10.0))?;
        // Adhesion that is strong beside the roughness: on to loads well above pull-off.
        while log_pull_off.is_some_and(|pull_off| from.log_excess < pull_off + LOG_ABOVE_PULL_OFF) {
            from = curve.sample(branch, 1.5 * from.separation.min(closest))?;
        }
        check.push(from);
        let lightest = from.log_excess - log_range(from.log_excess);
        let most_samples = MOST_SAMPLES + 2 * NODES * steps.kinks().len();
        while from.separation < steps.end() && from.log_excess > lightest && curve.samples < most_samples {
            let is_spent = steps.is_deep(from.separation) && curve.samples > most_samples / 2;
            let stretch = if is_spent && steps.has_failed() {
                steps.skip(from.separation)
            } else {
                steps.next(from.separation, from.s)
            };
            let attempt = if stretch.is_bridge {
                curve.bridge(branch, from, stretch)?
            } else {
                curve.attempt(branch, from, stretch)?
            };
            // So near to the end separations, of which nodes then coincide, have no digits left.
            if attempt.end.separation <= from.separation || attempt.panel.position.iter().any(|p| p.is_nan()) {
                break;
            }
            if !steps.keeps(&stretch, attempt.excess) {
                continue;
            }
            curve.panels.push(attempt.panel);
            check.extend(attempt.between);
            if attempt.end.slope[0].is_finite() {
                check.push(attempt.end);
            }
            from = attempt.end;
        }
        curve.panels.shrink_to_fit();
        Ok(curve)
    }

    /// A panel between two separations, and how well it meets the exact states that are not its nodes.
    fn attempt(&mut self, branch: &Branch, from: Sample, stretch: Stretch) -> Result<Attempt, Unfollowed> {
        let steps = self.steps.clone();
        // Where on the panel, from -1 to 1.
        let at = |part: f64| steps.between(from.separation, stretch.to, stretch.non_integer_power.part(part));
        let mut nodes = [from; NODES];
        for (j, node) in nodes.iter_mut().enumerate() {
            let angle = std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64;
            *node = self.sample(branch, at(-cos(angle)))?;
        }
        let end = self.end(branch, stretch.to)?;
        let position = |sample: &Sample| steps.position(sample.separation);
        let mut panel = Panel::new((end.s, from.s), stretch.non_integer_power, &nodes, position);
        // Between the nodes: in the middle of the panel, and where the nodes are farthest apart in s.
        let between = self.sample(branch, at(0.1))?;
        let (first, last) = (nodes[0].separation, nodes[NODES - 1].separation);
        let sparse = steps.separation(panel.position_at(panel.sparsest())).max(first).min(last);
        let sparse = self.sample(branch, sparse)?;
        // Slopes have fewer digits next to a non-integer power.
        let next_to_it = match stretch.non_integer_power {
            _ if panel.is_narrow() => between,
            NonIntegerPower::Nowhere => between,
            NonIntegerPower::AtBegin => self.sample(branch, at(-NEXT_TO_NON_INTEGER_POWER))?,
            NonIntegerPower::AtEnd => self.sample(branch, at(NEXT_TO_NON_INTEGER_POWER))?,
        };
        self.samples += NODES + 3;
        let excess = panel.keep_good(|panel, quantity| {
            // Where a panel ends there may be a kink; between the nodes it is slopes that tell how far values are off, but not
            // in a narrow one.
            let slack = quantity.slope_slack();
            let within = if panel.is_narrow() { slack } else { 1.0 };
            let next_to_it = (&next_to_it, slack * SLACK_AT_NON_INTEGER_POWER);
            let compared = [(&from, slack), (&between, within), (&sparse, within), next_to_it, (&end, slack)];
            compared.map(|(sample, slack)| panel.excess(quantity, sample, slack)).into_iter().fold(0.0, largest)
        });
        Ok(Attempt { panel, between: [between, sparse], end, excess })
    }

    /// A cubic between two kinks that are near to each other.
    fn bridge(&mut self, branch: &Branch, from: Sample, stretch: Stretch) -> Result<Attempt, Unfollowed> {
        let end = self.end(branch, stretch.to)?;
        let between = self.sample(branch, 0.5 * (from.separation + end.separation))?;
        let mut panel = Panel::bridge(&from, &end, |sample| self.steps.position(sample.separation));
        self.samples += 2;
        panel.keep_good(|panel, quantity| panel.excess(quantity, &between, quantity.slope_slack()));
        Ok(Attempt { panel, between: [between, between], end, excess: 0.0 })
    }

    /// The state where a panel ends, which may be pull-off itself.
    fn end(&self, branch: &Branch, to: f64) -> Result<Sample, Unfollowed> {
        if branch.pull_off().is_none_or(|point| point.separation != to) {
            return self.sample(branch, to);
        }
        let unknown = f64::NAN;
        Ok(Sample {
            separation: to,
            log_excess: f64::NEG_INFINITY,
            s: 0.0,
            log_value: [0.0; Quantity::COUNT],
            value: self.coordinate.reference,
            slope: [unknown; Quantity::COUNT],
            log_slope: [unknown; Quantity::COUNT],
        })
    }

    fn sample(&self, branch: &Branch, separation: f64) -> Result<Sample, Unfollowed> {
        let BranchPoint { log_excess, rate, sums } = branch.log_excess(separation);
        // A load below that of the end is as far above it as can be told.
        let below_end = match self.coordinate.log_pull_off {
            Some(_) => log_excess <= log(f64::MIN_POSITIVE),
            None => sums.load() <= 0.0,
        };
        if !(rate < 0.0 && sums.friction > 0.0) || below_end {
            return Err(Unfollowed { separation });
        }
        let (s, s_rate) = self.coordinate.at(log_excess);
        let sums = Quantity::ALL.map(|quantity| quantity.of(&sums));
        let log_slope = sums.map(|(value, slope)| slope / value / rate);
        Ok(Sample {
            separation,
            log_excess,
            s,
            log_value: std::array::from_fn(|i| log(sums[i].0 / self.coordinate.reference[i])),
            value: sums.map(|(value, _)| value),
            slope: log_slope.map(|log_slope| log_slope / s_rate),
            log_slope,
        })
    }

    /// The range of ln(load - pull-off) it covers; the lower end is minus infinity where it begins at pull-off.
    pub fn log_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        (self.coordinate.log_excess(last.lowest), self.coordinate.log_excess(first.highest))
    }

    /// Whether panels end at all kinks; if not, there are too many.
    pub fn is_resolved(&self) -> bool {
        self.steps.is_resolved()
    }

    /// A quantity and the slope of its logarithm by ln x at neighbouring ln x; NaN where the curve is not known to be good.
    fn at_each<const N: usize>(&self, quantity: Quantity, log_excess: [f64; N]) -> [(f64, f64); N] {
        let coordinates = self.coordinate.at_each(log_excess);
        let s = coordinates.map(|(s, _)| s);
        // Mostly one panel holds all: then they are evaluated side by side.
        let panel = self.panel(s[0]);
        let logs = match s.iter().all(|&s| panel.holds(s)) {
            true => panel.log_value_at(quantity, s),
            false => s.map(|s| self.panel(s).log_value_at(quantity, [s])[0]),
        };
        let value = exp_each(logs.map(|(log_value, _)| log_value));
        let reference = self.coordinate.reference[quantity as usize];
        std::array::from_fn(|i| (reference * value[i], logs[i].1 * coordinates[i].1))
    }

    /// The same at one ln x; `None` where the curve does not know it.
    pub fn within(&self, quantity: Quantity, log_excess: f64) -> Option<(f64, f64)> {
        let (s, rate) = self.coordinate.at(log_excess);
        let panel = self.panel(s);
        let [(log_value, slope)] = panel.log_value_at(quantity, [s]);
        let value = self.coordinate.reference[quantity as usize] * exp(log_value);
        (panel.holds(s) && !value.is_nan()).then_some((value, slope * rate))
    }

    /// A quantity of an exact state, and the slope of its logarithm by ln x.
    pub fn at_sample(&self, quantity: Quantity, sample: &Sample) -> (f64, f64) {
        let i = quantity as usize;
        (self.coordinate.reference[i] * exp(sample.log_value[i]), sample.log_slope[i])
    }

    /// The separation at ln x, to a few digits, where the curve covers it.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        let (s, _) = self.coordinate.at(log_excess);
        let panel = self.panel(s);
        panel.holds(s).then(|| self.steps.separation(panel.position_at(s)))
    }

    fn panel(&self, s: f64) -> &Panel {
        let index = self.panels.partition_point(|panel| panel.lowest > s);
        &self.panels[index.min(self.panels.len() - 1)]
    }
}

/// One quantity of a curve.
pub struct Along<'a>(pub &'a Curve, pub Quantity);

impl Source for Along<'_> {
    const IN_ANY_ORDER: bool = true;

    fn at<const N: usize>(&mut self, log_excess: [f64; N]) -> [(f64, f64); N] {
        self.0.at_each(self.1, log_excess)
    }

    fn joints(&mut self, lower: f64, upper: f64) -> Vec<f64> {
        let curve = self.0;
        let joints = curve.panels.iter().rev().map(|panel| curve.coordinate.log_excess(panel.lowest));
        joints.filter(|&joint| joint > lower && joint < upper).collect()
    }
}

impl Panel {
    fn new(
        (lowest, highest): (f64, f64),
        non_integer_power: NonIntegerPower,
        samples: &[Sample; NODES],
        position: impl Fn(&Sample) -> f64,
    ) -> Self {
        let places = samples.map(|sample| non_integer_power.place((lowest, highest), sample.s));
        let nodes = places.map(|(place, _)| place);
        let log_value = std::array::from_fn(|quantity| {
            let slopes = std::array::from_fn(|i| samples[i].slope[quantity] / places[i].1);
            let values = match highest - lowest < NARROW {
                true => integrals(&nodes, slopes),
                false => samples.map(|sample| log(sample.value[quantity] / samples[0].value[quantity])),
            };
            hermite(&nodes, values, slopes)
        });
        let position = differences(&nodes, std::array::from_fn(|i| position(&samples[i])));
        Self { lowest, highest, non_integer_power, reference: samples[0].log_value, nodes, log_value, position }
    }

    /// The cubic between two states.
    fn bridge(from: &Sample, to: &Sample, position: impl Fn(&Sample) -> f64) -> Self {
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
        (line[0], line[1]) = (position(from), (position(to) - position(from)) / width);
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

    /// Makes quantities no numbers that miss exact states by more than the tolerance; the largest error over it.
    fn keep_good(&mut self, excess: impl Fn(&Self, Quantity) -> f64) -> f64 {
        let excess = Quantity::ALL.map(|quantity| excess(self, quantity));
        for (reference, _) in self.reference.iter_mut().zip(excess).filter(|(_, excess)| *excess > 1.0) {
            *reference = f64::NAN;
        }
        excess.into_iter().fold(0.0, f64::max)
    }

    fn holds(&self, s: f64) -> bool {
        s >= self.lowest && s <= self.highest
    }

    /// The logarithm of a quantity and its derivative by s.
    fn log_value_at<const N: usize>(&self, quantity: Quantity, s: [f64; N]) -> [(f64, f64); N] {
        s.map(|s| self.place(s)).map(|(place, rate)| {
            let (value, slope) = self.polynomial(quantity, place);
            (value, slope * rate)
        })
    }

    #[inline(always)] // so that several are worked out side by side
    fn polynomial(&self, quantity: Quantity, place: f64) -> (f64, f64) {
        let (mut value, mut slope) = (0.0, 0.0);
        let coefficients = self.log_value[quantity as usize].chunks_exact(2);
        for (node, pair) in self.nodes.iter().zip(coefficients).rev() {
            let distance = place - node;
            for coefficient in [pair[1], pair[0]] {
                slope = slope * distance + value;
                value = value * distance + coefficient;
            }
        }
        (self.reference[quantity as usize] + value, slope)
    }

    /// Where s lies among the nodes, and d(that)/ds.
    fn place(&self, s: f64) -> (f64, f64) {
        self.non_integer_power.place((self.lowest, self.highest), s)
    }

    fn position_at(&self, s: f64) -> f64 {
        newton(&self.nodes, &self.position, self.place(s).0)
    }

    fn is_narrow(&self) -> bool {
        self.highest - self.lowest < NARROW
    }

    /// The middle of the widest gap between neighbouring nodes.
    fn sparsest(&self) -> f64 {
        let gap = |pair: &[f64]| (pair[1] - pair[0]).abs();
        let widest = self.nodes.windows(2).max_by(|a, b| gap(a).total_cmp(&gap(b)));
        let place = widest.map_or(self.nodes[0], |pair| 0.5 * (pair[0] + pair[1]));
        self.non_integer_power.s_at((self.lowest, self.highest), place)
    }

    /// How far an exact state lies from the curve, over the tolerance; infinite where either is not a number. The
    /// slope may miss by so many times its tolerance.
    fn excess(&self, quantity: Quantity, sample: &Sample, slope_slack: f64) -> f64 {
        let [(value, slope)] = self.log_value_at(quantity, [sample.s]);
        let exact = sample.slope[quantity as usize];
        let value_excess = (value - sample.log_value[quantity as usize]).abs() / VALUE_TOLERANCE;
        // Slopes are known neither at pull-off itself nor at a non-integer power.
        if exact.is_nan() || self.non_integer_power.is_at((self.lowest, self.highest), sample.s) {
            return value_excess;
        }
        let tolerance = if sample.s < NEAR_PULL_OFF { NOISE * SLOPE_TOLERANCE } else { SLOPE_TOLERANCE };
        largest(value_excess, (slope / exact - 1.0).abs() / (slope_slack * tolerance))
    }
}

/// The coefficients of Newton's form of the polynomial with these values and slopes at the nodes.
fn hermite(nodes: &[f64; NODES], values: [f64; NODES], slopes: [f64; NODES]) -> [f64; CONDITIONS] {
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
fn integrals(nodes: &[f64; NODES], slopes: [f64; NODES]) -> [f64; NODES] {
    let slopes = differences(nodes, slopes);
    let mut sum = 0.0;
    std::array::from_fn(|i| {
        if i > 0 {
            let points = crate::numerics::quadrature::nodes(nodes[i - 1], nodes[i]);
            let rise = points.map(|(s, weight)| weight * newton(nodes, &slopes, s)).sum::<f64>();
            sum += rise * (nodes[i] - nodes[i - 1]).signum();
        }
        sum
    })
}

/// The larger of two numbers, infinite if either is not one.
fn largest(a: f64, b: f64) -> f64 {
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
    use super::super::tests::branch;
    use super::*;
    use crate::numerics::near;
    use crate::params::{HeightFamily, Params};

    #[test]
    fn the_coordinate_is_arsinh_of_the_root_of_load_over_pull_off() {
        let pull_off = Coordinate { log_pull_off: Some(-7.0), reference: [1.0; 2] };
        for log_excess in [-40.0, -20.0, -7.0, -3.0, 10.0, 30.0, 34.4, 34.5, 60.0, 700.0] {
            let (s, rate) = pull_off.at(log_excess);
            let root = (0.5 * (log_excess + 7.0)).exp();
            assert!(near(s, root.asinh(), 1e-14), "{log_excess}: {s}");
            assert!(near(rate, 0.5 * root / root.hypot(1.0), 1e-14), "{log_excess}: {rate}");
        }
        // Of a pull-off load next to the smallest number and a load next to the largest.
        let (s, rate) = Coordinate { log_pull_off: Some(-640.0), reference: [1.0; 2] }.at(700.0);
        assert!(near(s, 670.0 + LN_2, 1e-15) && rate == 0.5, "{s}, {rate}");
        assert_eq!(Coordinate { log_pull_off: None, reference: [1.0; 2] }.at(-8.0), (-4.0, 0.5));
    }

    #[test]
    fn the_curve_reaches_from_its_heaviest_state_to_pull_off_or_as_light_as_asked_for() {
        for (gamma, range) in [(0.0, 20.0), (0.001, 20.0), (0.001, 1e3)] {
            let branch = branch(gamma);
            let mut states = Vec::new();
            let curve = Curve::new(&branch, |_| range, &mut states).expect("a curve");
            let (lower, upper) = curve.log_range();
            assert!(near(upper, states[0].log_excess, 1e-13), "{upper}");
            assert!(upper - lower >= range && curve.is_resolved(), "{lower} to {upper}");
            assert!(if range < 100.0 { upper - lower < 3.0 * range } else { lower == f64::NEG_INFINITY }, "{lower}");
            for state in &states {
                let found = curve.separation(state.log_excess).expect("a separation");
                assert!(
                    (found - state.separation).abs() < 1e-4 * (1.0 + state.separation.abs()),
                    "{found}, not {}",
                    state.separation
                );
                for quantity in Quantity::ALL {
                    let [(value, slope)] = curve.at_each(quantity, [state.log_excess]);
                    let (exact, exact_slope) = curve.at_sample(quantity, state);
                    assert!(
                        near(value, exact, 1e-10) && near(slope, exact_slope, 1e-8),
                        "{quantity:?}: {value}, {slope}"
                    );
                }
            }
            assert_eq!(curve.separation(upper + 1e-9), None);
            assert_eq!(curve.separation(lower.max(-1e3) - 1e-9).is_some(), lower == f64::NEG_INFINITY);
            // Side by side as one by one, also where panels meet.
            let several: [f64; 8] = std::array::from_fn(|i| lower.max(upper - 40.0) + 2.5 * i as f64 + 0.1);
            for quantity in Quantity::ALL {
                let one_by_one = several.map(|log_excess| curve.at_each(quantity, [log_excess])[0]);
                assert_eq!(curve.at_each(quantity, several), one_by_one);
            }
        }
    }

    fn of(params: &Params) -> Branch {
        Branch::new(crate::population::tests::of(params)).expect("a branch")
    }

    fn table(height: &[f64], density: &[f64]) -> HeightFamily {
        HeightFamily::Tabulated { height: height.into(), density: density.into() }
    }

    /// Far enough for loads 1e12 times as heavy as when half the summits touch, whatever the heights and radii.
    #[test]
    fn the_curve_begins_where_loads_are_as_heavy_as_no_solver_has_them() {
        for params in [
            Params::default(),
            Params { work_of_adhesion: 0.0, radius_amplitude: -1.0, radius_rate: 2.0, ..Params::default() },
            Params { radius_amplitude: 0.9, heights: table(&[7.0, 8.0, 9.0], &[0.0, 1.0, 0.0]), ..Params::default() },
            Params { heights: HeightFamily::Weibull { shape: 1.1 }, ..Params::default() },
        ] {
            let branch = of(&params);
            let mut states = Vec::new();
            Curve::new(&branch, |_| 5.0, &mut states).expect("a curve");
            let half = branch.population().at_separation(-branch.population().heights().origin());
            assert!((0.3..0.7).contains(&half.contacting), "{}", half.contacting);
            assert!(states[0].log_excess > half.load().ln() + 12.0 * 10_f64.ln(), "{params:?}");
        }
        // Strong adhesion beside little roughness.
        let mut strong = Params::default();
        strong.set_dimensionless(1e-5, 0.2, 1.0, 1.0, 0.3).expect("a surface");
        let (branch, mut states) = (of(&strong), Vec::new());
        Curve::new(&branch, |_| 5.0, &mut states).expect("a curve");
        let above = states[0].log_excess - (-branch.pull_off_load()).ln();
        assert!(above >= LOG_ABOVE_PULL_OFF, "{above}");
    }

    /// Without a pull-off load, of heights that end: down to where contacts have lost their digits.
    #[test]
    fn the_curve_of_heights_that_end_ends_next_to_them() {
        let branch = of(&Params {
            heights: table(&[0.0, 1.0, 2.0, 4.0], &[0.0, 2.0, 3.0, 0.0]),
            work_of_adhesion: 0.0,
            ..Params::default()
        });
        let curve = Curve::new(&branch, |_| 1e3, &mut Vec::new()).expect("a curve");
        let end = curve.separation(curve.log_range().0).expect("a separation");
        let highest = branch.population().heights().support().1;
        assert!((0.0..1e-3).contains(&(highest - end)), "{}", highest - end);
    }

    /// As many kinks as are resolved take more states than a smooth curve may.
    #[test]
    fn the_curve_of_a_table_with_many_kinks_is_followed_to_its_end() {
        let height: Vec<f64> = (0..55).map(f64::from).collect();
        let density: Vec<f64> = height.iter().map(|h| h * (54.0 - h)).collect();
        let branch = of(&Params { heights: table(&height, &density), ..Params::default() });
        let curve = Curve::new(&branch, |_| 200.0, &mut Vec::new()).expect("a curve");
        assert!(curve.is_resolved() && curve.samples > MOST_SAMPLES, "{} states", curve.samples);
        assert_eq!(curve.log_range().0, f64::NEG_INFINITY);
    }

    /// Far below the heights all summits pass the second radius of the slip law within a small part of the load.
    #[test]
    fn the_curve_is_exact_where_all_summits_pass_a_kink() {
        for params in [Params::default(), Params { heights: HeightFamily::Weibull { shape: 1.9 }, ..Params::default() }]
        {
            let branch = of(&params);
            let curve = Curve::new(&branch, |_| 200.0, &mut Vec::new()).expect("a curve");
            let mut covered = 0;
            for i in 0..300 {
                let state = curve.sample(&branch, -6410.0 + 0.1 * f64::from(i)).expect("a state");
                // But next to the foot of the second heights' density, so far below.
                let Some((force, slope)) = curve.within(Quantity::Friction, state.log_excess) else { continue };
                covered += 1;
                let (exact, exact_slope) = curve.at_sample(Quantity::Friction, &state);
                assert!(near(force, exact, 2e-11), "{state:?}: {force:e}");
                assert!(near(slope, exact_slope, 3e-9), "{state:?}: {slope}");
            }
            assert!(covered > 295, "{covered}");
        }
    }

    /// The logarithms are 2 + 3 s + s^2/2 and s^2 at separations 1 - s.
    fn parabola() -> Panel {
        let sample = |s: f64| {
            let log_value = [2.0 + 3.0 * s + 0.5 * s * s, s * s];
            Sample {
                separation: 1.0 - s,
                log_excess: 2.0 * s,
                s,
                log_value,
                value: log_value.map(f64::exp),
                slope: [3.0 + s, 2.0 * s],
                log_slope: [f64::NAN; 2],
            }
        };
        let node = |j: usize| 0.1 + (1.0 + (std::f64::consts::PI * (j as f64 + 0.5) / NODES as f64).cos()).powf(1.2);
        Panel::new((0.1, 2.5), NonIntegerPower::Nowhere, &std::array::from_fn(|j| sample(node(j))), |sample| {
            sample.separation
        })
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
    fn a_panel_has_the_values_and_slopes_it_is_made_from_and_says_how_far_others_lie() {
        let panel = parabola();
        let unknown = f64::NAN;
        let exact = Sample {
            separation: -0.2,
            log_excess: 2.4,
            s: 1.2,
            log_value: [6.32, 1.44],
            value: [unknown; 2],
            slope: [4.2, 2.4],
            log_slope: [unknown; 2],
        };
        assert!(near(panel.position_at(1.2), -0.2, 1e-13));
        for (quantity, expected) in [(Quantity::Friction, (6.32, 4.2)), (Quantity::Radius, (1.44, 2.4))] {
            let [(value, slope)] = panel.log_value_at(quantity, [1.2]);
            assert!(near(value, expected.0, 1e-13) && near(slope, expected.1, 1e-11), "{value}, {slope}");
            let mut missed = panel.clone();
            assert_eq!(missed.keep_good(|_, of| if of == quantity { 2.0 } else { 0.5 }), 2.0);
            assert!(Quantity::ALL.iter().all(|&of| missed.log_value_at(of, [1.2])[0].0.is_nan() == (of == quantity)));
        }
        let gaps: Vec<[f64; 2]> =
            panel.nodes.windows(2).map(|pair| [pair[0] - pair[1], 0.5 * (pair[0] + pair[1])]).collect();
        let widest = gaps.iter().fold([0.0; 2], |widest, &gap| if gap[0] > widest[0] { gap } else { widest });
        assert!(near(panel.sparsest(), widest[1], 1e-15), "{}, not {widest:?} of {gaps:?}", panel.sparsest());
        for quantity in Quantity::ALL {
            let off = |value: f64, slope: f64| {
                let mut off = exact;
                off.log_value[quantity as usize] += value;
                off.slope[quantity as usize] *= 1.0 + 5.0 * slope;
                panel.excess(quantity, &off, 5.0)
            };
            for sign in [1.0, -1.0] {
                assert!(
                    near(off(sign * 20.0 * VALUE_TOLERANCE, 0.0), 20.0, 0.1),
                    "{}",
                    off(20.0 * VALUE_TOLERANCE, 0.0)
                );
                assert!(
                    near(off(0.0, sign * 20.0 * SLOPE_TOLERANCE), 20.0, 0.1),
                    "{}",
                    off(0.0, 20.0 * SLOPE_TOLERANCE)
                );
            }
            assert!(off(0.0, 0.0) < 0.1);
            assert_eq!(off(f64::NAN, 0.0), f64::INFINITY);
        }
        // At pull-off itself there is no slope; a value that is none is as far as can be.
        let log_value = exact.log_value.map(|value| value + 5.0 * VALUE_TOLERANCE);
        let at_pull_off = Sample { slope: [f64::NAN; 2], log_value, ..exact };
        assert!(near(panel.excess(Quantity::Friction, &at_pull_off, 1.0), 5.0, 0.1));
        assert_eq!(largest(1.0, f64::NAN), f64::INFINITY);
        assert_eq!(largest(f64::NAN, 1.0), f64::INFINITY);
        assert_eq!(largest(1.0, 2.0), 2.0);
    }
}
