//! The branch of load control as a smooth curve through few exact states, from which the table is filled.
//!
//! In the coordinate s of `coordinate` ln F is smooth between the kinks of the branch, and so is the logarithm of the
//! stiffness. A panel is a polynomial through three exact states with their slopes (`panel`), compared with two more between these,
//! where it is farthest off. If it misses one, all five are its nodes, compared with two more; and then its halves are tried, of which all
//! seven are nodes or compared again.

use super::coordinate::Coordinate;
use super::panel::{CurvePanel, PerQuantity, Sample};
use super::planes::{Planes, PlanesPanel};
use super::position::Positions;
use super::states::{States, Stretch, Unfollowed};
use super::tolerance::larger;
use super::{Quantity, Reach};
use crate::equilibrium::{Branch, Local};
use crate::numerics::elementary::{exp, exp_each, log};

/// Slopes over a panel shorter than this hardly change values: they may be off by more, as the root of how often it is shorter.
const SHORT: f64 = 0.02;
/// A longer panel may meet the states that it is compared with by chance.
const LONGEST: f64 = 5.0;
/// Once so many exact states are spent, and some for each kink, panels are kept as they are.
const MOST_STATES: usize = 2500;
const MOST_STATES_PER_KINK: usize = 50;
/// Slopes of a panel with three nodes are farther off than half-way between these by up to so many times.
const SLOPES_OF_FEW: f64 = 3.0;

/// The curve, from heavy to light load.
#[derive(Debug, Clone)]
pub struct Curve {
    coordinate: Coordinate,
    positions: Positions,
    panels: Vec<CurvePanel>,
    /// Separation and ln x of the kinks, from heavy to light load.
    kinks: Vec<(f64, f64)>,
    /// The largest error of the logarithm of each quantity.
    error: PerQuantity,
    /// The gaps of separations, if neighbours make them other numbers.
    planes: Option<Box<Planes>>,
}

/// The panels of a stretch, and how well they meet the states that they are compared with.
struct Attempt {
    panel: CurvePanel,
    gap: Option<PlanesPanel>,
    /// Of the logarithm of each quantity.
    errors: PerQuantity,
    /// The largest of all, over its tolerance.
    worst: f64,
}

impl Attempt {
    /// With nodes at every so many eighths, compared half-way between the outermost.
    fn new(states: &mut States, stretch: &mut Stretch, reach: &Reach, step: usize) -> Result<Self, Unfollowed> {
        let nodes = states.nodes(stretch, step)?;
        let panel = CurvePanel::new(&nodes);
        let crowding = states.branch.population().crowding();
        let gap = crowding.map(|crowding| {
            PlanesPanel::new(&nodes, &panel, states.coordinate, states.positions, crowding.stiffness_of_radius)
        });
        let mut attempt = Self { panel, gap, errors: [0.0; Quantity::COUNT], worst: 0.0 };
        // Between the lightest load and pull-off nothing but gaps is asked for.
        let is_asked = stretch.from.log_excess > reach.log_lightest;
        let is_compared = is_asked || attempt.gap.is_some();
        for eighth in [step / 2, 8 - step / 2].into_iter().filter(|_| is_compared) {
            let state = states.eighth(stretch, eighth)?;
            attempt.compare(&state, is_asked, (SHORT / stretch.length()).max(1.0).sqrt());
        }
        Ok(attempt)
    }

    fn compare(&mut self, state: &Sample, is_asked: bool, slack: f64) {
        if is_asked {
            let (errors, worst) = self.panel.error_at(state, slack);
            self.worst = larger(self.worst, worst);
            self.errors = std::array::from_fn(|i| larger(self.errors[i], errors[i]));
        }
        self.worst = larger(self.worst, self.gap.as_ref().map_or(0.0, |gap| gap.error_at(state)));
    }
}

impl Curve {
    /// Follows the branch from the heaviest load of a reach to pull-off, or to the lightest load of the reach where there is none. An
    /// anchor is a separation and its gap.
    pub fn new(branch: &Branch, reach: &Reach, anchor: Option<(f64, f64)>) -> Result<Self, Unfollowed> {
        let log_pull_off = reach.pull_off.map(|point| log(-point.load));
        let coordinate = Coordinate { log_pull_off, pull_off: branch.pull_off_load() };
        let positions = Positions::of(branch, reach.pull_off.is_some());
        let mut states = States::new(branch, coordinate, positions);
        let (knots, kinks) = states.knots(reach)?;
        let most_states = MOST_STATES + MOST_STATES_PER_KINK * kinks.len();
        let error = [0.0; Quantity::COUNT];
        let mut curve = Self { coordinate, positions, panels: Vec::new(), kinks, error, planes: None };
        let mut gaps = Vec::new();
        let mut open = Vec::new();
        for ends in knots.windows(2) {
            open.push(Stretch::new(states.beyond(ends[0])?, ends[1]));
        }
        // All of one length before the halves of any, so that what is not resolved where states are spent is short.
        while !open.is_empty() {
            let mut halves = Vec::new();
            for mut stretch in open.into_iter().filter(|stretch| stretch.to.log_excess < reach.log_heaviest) {
                let mut attempt = Attempt::new(&mut states, &mut stretch, reach, 4)?;
                if stretch.length() > LONGEST || SLOPES_OF_FEW * attempt.worst > 1.0 {
                    attempt = Attempt::new(&mut states, &mut stretch, reach, 2)?;
                }
                let is_missed = stretch.length() > LONGEST || attempt.worst > 1.0;
                if is_missed && stretch.length() > 2.0 * states.shortest && states.count < most_states {
                    halves.extend(stretch.halves().into_iter().flatten());
                    continue;
                }
                curve.error = std::array::from_fn(|i| larger(curve.error[i], attempt.errors[i]));
                curve.panels.push(attempt.panel);
                gaps.extend(attempt.gap);
            }
            open = halves;
        }
        curve.panels.sort_by(|a, b| a.begin.total_cmp(&b.begin));
        gaps.sort_by(|a, b| a.begin.total_cmp(&b.begin));
        curve.planes = (!gaps.is_empty()).then(|| {
            let planes = Planes::new(gaps, positions);
            Box::new(match anchor {
                Some(anchor) => planes.anchored(anchor),
                None => planes,
            })
        });
        Ok(curve)
    }

    /// The range of ln(load - pull-off load) it covers; the lower end is minus infinity where it begins at pull-off.
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
        std::array::from_fn(|i| (value[i], logs[i].1 * coordinates[i].1))
    }

    /// The largest relative error of a quantity at states that are no nodes.
    pub fn error(&self, quantity: Quantity) -> f64 {
        self.error[quantity as usize]
    }

    /// The separation at ln x, to a few digits, where the curve covers it.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        let (s, _) = self.coordinate.at(log_excess);
        let panel = self.panel(s);
        panel.holds(s).then(|| self.positions.separation(panel.position_at(s)))
    }

    /// The gap of a separation.
    pub fn gap(&self, separation: f64) -> f64 {
        self.planes.as_ref().map_or(separation, |planes| planes.gap(separation).0)
    }

    /// The load and d(load)/d(gap) at neighbouring gaps, dimensionless.
    pub fn load_at_gaps<const N: usize>(&self, gap: [f64; N]) -> [(f64, f64); N] {
        let places = match &self.planes {
            Some(planes) => planes.places(gap),
            None => gap.map(|gap| (self.positions.position(gap), 1.0 / self.positions.rates(gap).0)),
        };
        places.map(|(position, rate)| {
            let (load, slope) = self.load_at_position(position);
            (load, slope * rate)
        })
    }

    /// How gaps and separations follow from each other, if they differ.
    pub fn into_planes(self) -> Option<Box<Planes>> {
        self.planes
    }

    /// The load and d(load)/d(separation) at a separation, dimensionless.
    pub fn load_at(&self, separation: f64) -> (f64, f64) {
        let (load, slope) = self.load_at_position(self.positions.position(separation));
        (load, slope / self.positions.rates(separation).0)
    }

    fn load_at_position(&self, position: f64) -> (f64, f64) {
        let index = self.panels.partition_point(|panel| panel.end < position);
        let (s, rate) = self.panels[index.min(self.panels.len() - 1)].s_at(position);
        let (load, by_s) = self.coordinate.load(s);
        (load, by_s * rate)
    }

    /// The separations between which it is followed.
    pub fn separation_range(&self) -> (f64, f64) {
        let (Some(first), Some(last)) = (self.panels.first(), self.panels.last()) else {
            return (0.0, 0.0);
        };
        (self.positions.separation(first.begin), self.positions.separation(last.end))
    }

    /// Separation and ln x of the kinks, from heavy to light load.
    pub fn kinks(&self) -> &[(f64, f64)] {
        &self.kinks
    }

    /// The separation at which the load is 0, to a few digits, where adhesion makes it negative at the end.
    pub fn separation_of_zero_load(&self) -> Option<f64> {
        self.separation(self.coordinate.log_pull_off?)
    }

    /// Load and gap at a separation, with their slopes. Beyond the heavy end these, as the next, go on as straight lines.
    pub fn local(&self, separation: f64) -> Local {
        let position = self.positions.position(separation);
        let gap = self.planes.as_ref().map_or((separation, 1.0), |planes| planes.gap_at(separation, position));
        let load = self.at(separation, position, |panel, position| {
            let (s, rate) = panel.s_at(position);
            let (load, by_s) = self.coordinate.load(s);
            (load, by_s * rate)
        });
        Local { separation, gap, load }
    }

    /// The quantities at a separation, with their slopes.
    pub fn quantities(&self, separation: f64) -> [(f64, f64); Quantity::COUNT] {
        let position = self.positions.position(separation);
        Quantity::ALL.map(|quantity| {
            self.at(separation, position, |panel, position| {
                let (s, rate) = panel.s_at(position);
                let [(log_value, slope)] = panel.log_value_at(quantity, [s]);
                let value = exp(log_value);
                (value, value * slope * rate)
            })
        })
    }

    /// What has a value and a slope by position at a separation and its position, with its slope by separation: 0 beyond the light end.
    fn at(&self, separation: f64, position: f64, of: impl Fn(&CurvePanel, f64) -> (f64, f64)) -> (f64, f64) {
        let Some(panel) = self.panels.get(self.panels.partition_point(|panel| panel.end < position)) else {
            return (0.0, 0.0);
        };
        let is_beyond = position < panel.begin;
        let at = if is_beyond { self.positions.separation(panel.begin) } else { separation };
        let (value, by_position) = of(panel, position.max(panel.begin));
        let slope = by_position / self.positions.rates(at).0;
        (value + slope * (separation - at), slope)
    }

    fn panel(&self, s: f64) -> &CurvePanel {
        let index = self.panels.partition_point(|panel| panel.lowest > s);
        &self.panels[index.min(self.panels.len() - 1)]
    }
}
