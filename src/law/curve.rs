//! The branch of load control as a smooth curve through exact states, from which the table is filled.
//!
//! In the coordinate s of `coordinate` ln F is smooth between the kinks of the branch, and so is the logarithm of the
//! stiffness. Panels of exact states, each with its slopes, are joined by Hermite interpolation (`panel`); a panel that misses
//! the exact states between its nodes is tried again shorter.

use super::coordinate::Coordinate;
use super::panel::{chebyshev, CurvePanel, PerQuantity, Sample, PANEL_CHECKS, PANEL_NODES};
use super::planes::{self, Planes};
use super::position::Positions;
use super::steps::{Steps, Stretch};
use super::tolerance::{self, larger};
use super::{Quantity, Reach};
use crate::equilibrium::{Branch, BranchPoint};
use crate::numerics::elementary::{exp_each, log};

/// The heaviest load is looked for from this far below the mean height, in sigma, in steps that double.
const FIRST_DEPTH: f64 = 8.0;
/// The heaviest load of a part of the loads is looked for from far separations on, at these, in sigma above the middle of the heights.
const NEARER: [f64; 8] = [5.0, 4.0, 3.0, 2.0, 1.0, 0.0, -2.0, -4.0];
/// Once so many exact states are spent, and some for each kink, panels are kept where they are not long.
const MOST_SAMPLES: usize = 2500;
/// What is nearer to the end of the branch than this, relative to 1 or to the separation, is at it.
const AT_BRANCH_END: f64 = 1e-12;

/// At this separation the load rises already, or cannot be had: the branch ends before.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unfollowed {
    pub separation: f64,
}

/// A panel with its exact states.
struct Attempt {
    panel: CurvePanel,
    nodes: [Sample; PANEL_NODES],
    end: Sample,
    /// Those that it was compared with between its nodes; `None` if it missed one at an end.
    between: Option<[Sample; 2]>,
    /// The largest error over its tolerance.
    error: f64,
}

/// The curve, from heavy to light load.
#[derive(Debug, Clone)]
pub struct Curve {
    coordinate: Coordinate,
    positions: Positions,
    /// What logarithms are taken relative to: the quantities at pull-off, where small changes must be resolved.
    reference: PerQuantity,
    panels: Vec<CurvePanel>,
    /// Exact states spent.
    samples: usize,
    /// The gaps of separations, if neighbours make them other numbers.
    planes: Option<Box<Planes>>,
}

impl Curve {
    /// Follows the branch from the heaviest load of a reach to pull-off, or to the lightest load of the reach where that is heavier.
    /// Hands every exact state that is not a node to `check`.
    pub fn new(branch: &Branch, reach: Reach, check: &mut Vec<Sample>) -> Result<Self, Unfollowed> {
        let log_pull_off = branch.pull_off().map(|point| log(-point.load));
        let reference = Quantity::ALL.map(|quantity| branch.pull_off().map_or(1.0, |point| quantity.of(&point.sums).0));
        let mut steps = Steps::new(branch);
        let positions = steps.positions;
        let coordinate = Coordinate { log_pull_off };
        let mut curve = Self { coordinate, positions, reference, panels: Vec::new(), samples: 0, planes: None };
        let is_crowded = branch.population().is_crowded();
        let (mut gaps, mut ends) = (Vec::new(), Vec::new());
        let mut depth = FIRST_DEPTH.max(positions.middle + FIRST_DEPTH - steps.end);
        let mut from = curve.sample(branch, positions.middle - depth)?;
        if reach.is_part {
            for height in NEARER {
                // Where adhesion holds surfaces together the branch may end before.
                let Ok(nearer) = curve.sample(branch, positions.middle + height) else { continue };
                if nearer.log_excess > reach.log_heaviest && nearer.separation < steps.end {
                    from = nearer;
                    break;
                }
            }
        }
        while from.log_excess < reach.log_heaviest {
            depth *= 2.0;
            from = curve.sample(branch, positions.middle - depth)?;
        }
        check.push(from);
        let lightest = if reach.has_pull_off { f64::NEG_INFINITY } else { reach.log_lightest };
        let most_samples = MOST_SAMPLES + 10 * PANEL_NODES * steps.kinks.len();
        while from.separation < steps.end && from.log_excess > lightest {
            let stretch = match from.log_excess > reach.log_lightest {
                true => steps.next(from.separation, curve.samples > most_samples),
                false => steps.rest(from.separation),
            };
            let attempt = match curve.attempt(branch, from, stretch, &mut ends) {
                Ok(attempt) => attempt,
                // Rounding tells whether the load falls so near to pull-off.
                Err(Unfollowed { separation }) if steps.end - separation < AT_BRANCH_END * (1.0 + separation.abs()) => {
                    break
                }
                Err(unfollowed) => return Err(unfollowed),
            };
            let Attempt { panel, nodes, end, between, mut error } = attempt;
            let Some(between) = between else {
                steps.keeps(&stretch, error);
                continue;
            };
            let crowded = is_crowded.then(|| planes::PlanesPanel::between(&from, &end, &nodes, positions));
            if let Some(panel) = &crowded {
                error = larger(error, panel.error_at(&between) / (stretch.slope_slack * tolerance::SLOPE));
            }
            // Separations so near to the end have no digits left: nodes coincide.
            if end.separation <= from.separation || error.is_infinite() && stretch.is_shortest {
                break;
            }
            if !steps.keeps(&stretch, error) {
                continue;
            }
            curve.panels.push(panel);
            gaps.extend(crowded);
            check.extend(between);
            if end.slope[0].is_finite() {
                check.push(end);
            }
            from = end;
        }
        curve.planes = is_crowded.then(|| Box::new(Planes::new(branch, gaps, positions)));
        Ok(curve)
    }

    /// The exact states at the nodes of a panel, whose separations `at` gives from -1 to 1; `any` is a state.
    fn nodes(
        &self,
        branch: &Branch,
        any: Sample,
        at: impl Fn(f64) -> f64,
    ) -> Result<[Sample; PANEL_NODES], Unfollowed> {
        let mut nodes = [any; PANEL_NODES];
        for (j, node) in nodes.iter_mut().enumerate() {
            *node = self.sample(branch, at(chebyshev(j)))?;
        }
        Ok(nodes)
    }

    /// A panel between two separations, and how well it meets the exact states that are not its nodes. The ends of those that missed
    /// are ends again.
    fn attempt(
        &mut self,
        branch: &Branch,
        from: Sample,
        stretch: Stretch,
        ends: &mut Vec<Sample>,
    ) -> Result<Attempt, Unfollowed> {
        let positions = self.positions;
        // Where on the panel, from -1 to 1.
        let at = |part: f64| positions.between(from.separation, stretch.to, part);
        let nodes = self.nodes(branch, from, at)?;
        let end = match ends.iter().find(|end| end.separation == stretch.to) {
            Some(end) => *end,
            None => {
                ends.push(self.end(branch, stretch.to)?);
                ends[ends.len() - 1]
            }
        };
        self.samples += PANEL_NODES + 1;
        let panel = CurvePanel::new(&from, &end, positions, &nodes);
        let error = panel.error_over_tolerance(stretch.slope_slack, &[&from, &end]);
        if !stretch.allows(error) {
            return Ok(Attempt { panel, nodes, end, between: None, error });
        }
        let between = [self.sample(branch, at(PANEL_CHECKS[0]))?, self.sample(branch, at(PANEL_CHECKS[1]))?];
        self.samples += 2;
        let error = larger(error, panel.error_over_tolerance(stretch.slope_slack, &[&between[0], &between[1]]));
        Ok(Attempt { panel, nodes, end, between: Some(between), error })
    }

    /// The state where a panel ends, which may be pull-off itself.
    fn end(&self, branch: &Branch, to: f64) -> Result<Sample, Unfollowed> {
        let Some(point) = branch.pull_off().filter(|point| point.separation == to) else {
            return self.sample(branch, to);
        };
        let unknown = f64::NAN;
        Ok(Sample {
            separation: to,
            crowding: point.sums.crowding,
            log_excess: f64::NEG_INFINITY,
            s: 0.0,
            s_by_separation: unknown,
            log_value: [0.0; Quantity::COUNT],
            value: self.reference,
            slope: [unknown; Quantity::COUNT],
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
        let crowding = sums.crowding;
        let sums = Quantity::ALL.map(|quantity| quantity.of(&sums));
        Ok(Sample {
            separation,
            crowding,
            log_excess,
            s,
            s_by_separation: s_rate * rate,
            log_value: std::array::from_fn(|i| log(sums[i].0 / self.reference[i])),
            value: sums.map(|(value, _)| value),
            slope: sums.map(|(value, slope)| slope / value / rate / s_rate),
        })
    }

    /// The range of ln(load - pull-off) it covers; the lower end is minus infinity where it begins at pull-off.
    pub fn log_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        (self.coordinate.log_excess(last.lowest), self.coordinate.log_excess(first.highest))
    }

    /// A quantity and the slope of its logarithm by ln x at neighbouring ln x.
    pub fn at_each<const N: usize>(&self, quantity: Quantity, log_excess: [f64; N]) -> [(f64, f64); N] {
        let coordinates = self.coordinate.at_each(log_excess);
        let s = coordinates.map(|(s, _)| s);
        // Mostly one panel holds all: then they are evaluated side by side.
        let panel = self.panel(s[0]);
        let logs = match s.iter().all(|&s| panel.holds(s)) {
            true => panel.log_value_at(quantity, s),
            false => s.map(|s| self.panel(s).log_value_at(quantity, [s])[0]),
        };
        let value = exp_each(logs.map(|(log_value, _)| log_value));
        let reference = self.reference[quantity as usize];
        std::array::from_fn(|i| (reference * value[i], logs[i].1 * coordinates[i].1))
    }

    /// How far a quantity is off at pull-off, relative, if the panel that ends there begins above a load.
    pub fn error_at_pull_off(&self, quantity: Quantity, log_excess: f64) -> f64 {
        let last = self.panels.last().filter(|panel| panel.lowest == 0.0 && self.coordinate.log_pull_off.is_some());
        let last = last.filter(|panel| self.coordinate.log_excess(panel.highest) > log_excess);
        last.map_or(0.0, |panel| panel.log_value_at(quantity, [0.0])[0].0.abs())
    }

    /// The separation at ln x, to a few digits, where the curve covers it.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        let (s, _) = self.coordinate.at(log_excess);
        let panel = self.panel(s);
        panel.holds(s).then(|| panel.separation_at(s))
    }

    /// The gap of a separation.
    pub fn gap(&self, separation: f64) -> f64 {
        self.planes.as_ref().map_or(separation, |planes| planes.gap(separation))
    }

    /// The load and d(load)/d(gap) at neighbouring gaps, dimensionless.
    pub fn load_at_gaps<const N: usize>(&self, gap: [f64; N]) -> [(f64, f64); N] {
        let Some(planes) = &self.planes else { return gap.map(|gap| self.load_at(gap)) };
        let [index, last] = [gap[0], gap[N - 1]].map(|gap| planes.index_of(gap).min(self.panels.len() - 1));
        if index != last {
            return gap.map(|gap| self.load_at_gaps([gap])[0]);
        }
        let panel = &self.panels[index];
        planes.panel(index).places(gap).map(|(place, rate)| {
            let (s, by_place) = panel.s_at_place(place);
            let (load, by_s) = self.coordinate.load(s);
            (load, by_s * by_place * rate)
        })
    }

    /// How gaps and separations follow from each other, if they differ.
    pub fn into_planes(self) -> Option<Box<Planes>> {
        self.planes
    }

    /// The load and d(load)/d(separation) at a separation, dimensionless.
    pub fn load_at(&self, separation: f64) -> (f64, f64) {
        let index = self.panels.partition_point(|panel| panel.end < separation);
        let (s, rate) = self.panels[index.min(self.panels.len() - 1)].s_at(separation);
        let (load, by_s) = self.coordinate.load(s);
        (load, by_s * rate)
    }

    /// The separations between which it is followed.
    pub fn separation_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        (first.begin, last.end)
    }

    /// ln x between two of them where one panel ends and another begins, rising.
    pub fn log_joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        let joints = self.panels.iter().rev().map(|panel| self.coordinate.log_excess(panel.lowest));
        joints.filter(|&joint| joint > lower && joint < upper).collect()
    }

    /// The separations at which one piece of the load ends and another begins, in ascending order.
    pub fn joints(&self) -> impl DoubleEndedIterator<Item = f64> + '_ {
        self.panels.iter().map(|panel| panel.end)
    }

    /// The separation at which the load is 0, to a few digits, where adhesion makes it negative at the end.
    pub fn separation_of_zero_load(&self) -> Option<f64> {
        self.separation(self.coordinate.log_pull_off?)
    }

    fn panel(&self, s: f64) -> &CurvePanel {
        let index = self.panels.partition_point(|panel| panel.lowest > s);
        &self.panels[index.min(self.panels.len() - 1)]
    }
}
