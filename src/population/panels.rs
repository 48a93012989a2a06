//! Panels of the quadrature over summits in contact: how long each may be, and the summits at its nodes.
//!
//! Near break-away panels are laid in the parameter of the law of contact, in which the edge and the fold are smooth: the
//! height follows; of unloading in the root of the height above it. Far from it they are laid in height, and the contact follows. `cuts` says where one ends before it is as long
//! as it may be, `walk` lays one after the other.

use super::break_away::LEAST_RATE;
use super::{Point, Population};
use crate::distribution::panel::{self, SHORTEST_PANEL};
use crate::numerics::elementary::log;
use crate::numerics::hermite::Cubic;
use crate::numerics::quadrature::{self, POINTS};
use crate::numerics::root::MOST_STEPS;

/// A panel in height is no longer than this many times the distance to break-away, where the law of contact is singular.
const HEIGHT_RATIO: f64 = 3.5;
/// Where radii vary, dz/ds must not change by more than this factor over a panel in the parameter because they do: where the radius
/// of contact falls with height, the parameter does at last.
const MOST_RATE_CHANGE: f64 = 1.2;
/// A panel in the parameter is no longer than this many times the distance to where the law is singular.
const PARAMETER_RATIO: f64 = 3.0;
/// Between the slip law's radii friction is a power of the contact radius of about 3/2, which the rule follows closely: no
/// longer than this many times the parameter, at 0 of which the radius is 0.
const POWER_RATIO: f64 = 7.0;
/// As a function of the parameter the density is steeper than as one of height: of a panel in height this part is taken.
const PART_OF_HEIGHT_PANEL: f64 = 0.5;
/// A panel between two heights of a table at scores counts as this part of what it is: 10 points give 1e-12 of a whole one, and 6
/// of a quarter.
const PART_BETWEEN_SCORES: f64 = 0.08;
/// What grows by fewer e-folds over a panel is summed as closely by 6 points, and by 10.
const FEW_POINTS: f64 = 1.5;
const SOME_POINTS: f64 = 5.0;
/// What is summed roughly has panels that count as this part of what they are.
const PART_OF_ROUGH: f64 = 0.019;
/// A panel that is longer than it should be by no more than this factor is taken.
const LENGTH_SLACK: f64 = 1.05;
/// Twice the 32nd root of 32!, by which e-folds of an exponential are divided; and what may be left of a change of dz/ds.
const EXPONENTIAL: f64 = 25.6;
const EXPONENTIAL_LEFT: f64 = 1e-12;
/// Less than this part of a panel is not left for another.
const REMNANT: f64 = 1e-3;

/// Summits with their weights in height.
pub type Nodes = [(f64, Point); POINTS];

/// The variable in which a panel is laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axis {
    Parameter,
    Height,
    /// The root of the height above this one, where contact breaks.
    Root(f64),
}

/// A panel between two summits.
#[derive(Debug, Clone, Copy)]
pub struct SummitPanel {
    pub axis: Axis,
    pub from: Point,
    pub to: Point,
    /// Which kink it ends at: the radii first, then those of the law of contact, then that of friction over radius.
    pub kink: Option<usize>,
    /// What part it is of one that all points are needed for.
    pub(super) part: f64,
    /// Whether it begins or ends where contacts are about to slip as a whole: what they resist goes as the distance to the power
    /// 3/2 there.
    pub(super) is_eased: bool,
}

impl Population {
    /// The next height at which a panel must end.
    pub(super) fn stop_above(&self, z: f64) -> f64 {
        let next = panel::next_breakpoint(&*self.heights, z);
        // Where radii change fastest.
        self.radius.turn().filter(|&turn| turn > z + panel::slack(z)).map_or(next, |turn| next.min(turn))
    }

    /// The panel from a summit, `clearance` above break-away, no longer than the first `reach` and not beyond the height `stop`; radii
    /// are smooth as far as the second.
    pub(super) fn panel(
        &self,
        separation: f64,
        here: Point,
        kink: Option<usize>,
        clearance: f64,
        [reach, radii]: [f64; 2],
        stop: f64,
    ) -> SummitPanel {
        // Where radii fall so steeply that the parameter turns back, panels in it would become ever shorter; not so at break-away.
        let turns_back = here.height_share() < LEAST_RATE;
        let by_parameter = if self.lost > 0.0 && clearance <= PART_OF_HEIGHT_PANEL * reach / self.height_ratio() {
            Some(self.root_panel_end(separation, &here, clearance, PART_OF_HEIGHT_PANEL * reach, stop))
        } else if turns_back || self.lost > 0.0 || clearance > PART_OF_HEIGHT_PANEL * reach / self.height_ratio() {
            None
        } else {
            let is_polynomial = self.heights.outline().is_piecewise_polynomial;
            let reach = if is_polynomial && here.z + reach >= stop { reach } else { PART_OF_HEIGHT_PANEL * reach };
            self.parameter_panel_end(separation, &here, reach, stop)
        };
        let (axis, to) = match by_parameter {
            Some(to) if self.lost > 0.0 => (Axis::Root(here.z - clearance), to),
            Some(to) => (Axis::Parameter, to),
            None => {
                let ratio = if self.has_onset() { 1.0 } else { self.height_ratio() };
                let z = (here.z + reach.min((ratio * clearance).max(SHORTEST_PANEL))).min(stop);
                (Axis::Height, self.at_height(separation, z, here.contact.parameter))
            }
        };
        let mut panel = SummitPanel { axis, from: here, to, kink: None, part: 1.0, is_eased: false };
        self.cut_at_kink(separation, &mut panel, kink);
        // Between breakpoints a density is smoother than they are near.
        let smooth = || match self.heights.breakpoints() {
            [] => reach,
            _ => panel::smooth_length(&*self.heights, here.z).min(radii),
        };
        // What contacts about to slip resist asks for all points.
        panel.part = match (self.has_onset(), &self.radius.scores) {
            (true, _) => 1.0,
            (false, None) => self.part(&panel, clearance, smooth()),
            // The heights of a table at scores do not end, so that nothing begins as a power between them.
            (false, Some(scores)) => match scores.change(0.5 * (panel.from.z + panel.to.z)) {
                change if change < FEW_POINTS => PART_BETWEEN_SCORES * self.part(&panel, clearance, smooth()),
                change if change < SOME_POINTS => PART_BETWEEN_SCORES,
                _ => 1.0,
            },
        };
        if self.is_rough {
            panel.part *= PART_OF_ROUGH;
        }
        panel.is_eased = self.is_onset(kink) || self.is_onset(panel.kink);
        panel
    }

    /// How long a panel in height may be, in distances to break-away.
    fn height_ratio(&self) -> f64 {
        HEIGHT_RATIO * self.heights.outline().part_of_panel
    }

    /// What part a panel is of the longest over which the law of contact is smooth, and heights and radii as far as `smooth`.
    fn part(&self, panel: &SummitPanel, clearance: f64, smooth: f64) -> f64 {
        let rise = panel.to.z - panel.from.z;
        match panel.axis {
            Axis::Height => rise / smooth.min(self.height_ratio() * clearance),
            // The ends do not tell how dz/ds changes between them.
            Axis::Root(_) => 1.0,
            Axis::Parameter if !self.radius.is_constant() => 1.0,
            Axis::Parameter => {
                let step = panel.to.contact.parameter - panel.from.contact.parameter;
                (step / self.longest_step(&panel.from)).max(rise / (PART_OF_HEIGHT_PANEL * smooth))
            }
        }
    }

    /// How far a panel in the parameter may reach: as far as the law of contact is smooth.
    fn longest_step(&self, from: &Point) -> f64 {
        let (s, g) = (from.contact.parameter, self.radius.factor(from.z));
        let smooth = PARAMETER_RATIO * self.law.distance_to_singularity(s, g);
        // What contacts that slip in part resist is singular where they begin to slip as a whole, at distances like this.
        let smooth = if self.has_onset() { smooth.min(s.max(SHORTEST_PANEL)) } else { smooth };
        // At a parameter of 0 the end of the shortest panel counts.
        let radius = if s > SHORTEST_PANEL { from.contact.radius } else { self.law.at(SHORTEST_PANEL, g).radius };
        if radius > 0.999_999 * self.slip.kinks()[0] {
            smooth.min((POWER_RATIO * s).max(SHORTEST_PANEL))
        } else {
            smooth
        }
    }

    /// Where a panel in the parameter ends: as far as the law of contact is smooth, and no more than `reach` higher. `None`
    /// where the height does not follow from the parameter.
    fn parameter_panel_end(&self, separation: f64, here: &Point, reach: f64, stop: f64) -> Option<Point> {
        let s = here.contact.parameter;
        let mut step = self.longest_step(here);
        let (start_rate, here_g) = (here.z_rate(), self.radius.factor(here.z));
        if step == f64::INFINITY {
            // Hertz: the height is s^2.
            step = reach / (0.5 * start_rate + (0.25 * start_rate * start_rate + reach).sqrt());
        }
        for _ in 0..MOST_STEPS {
            // As if radii went on as they begin to.
            let deeper = self.law.at(s + step, here_g).overlap - here.contact.overlap;
            let there = self.on_branch(separation, s + step, here.z + deeper / here.height_share());
            if !self.ends_panel(&there, here) {
                step *= 0.25;
                continue;
            }
            let rise = there.z - here.z;
            let limit = reach.min(stop - here.z);
            // What would be left of the stretch goes into the panel if it is next to nothing.
            let reaches_stop = there.z + REMNANT * rise >= stop;
            if rise <= reach * LENGTH_SLACK && !reaches_stop {
                return Some(there);
            }
            // As if the rise were quadratic in the step.
            let bend = ((rise - start_rate * step) / (step * step)).max(0.0);
            let shorter = 2.0 * limit / (start_rate + (start_rate * start_rate + 4.0 * bend * limit).sqrt());
            step = if reaches_stop && here.z + limit >= stop {
                // What was tried may lie so far above the stop that radii are level there.
                let there = self.at_height(separation, stop, s + shorter);
                if self.ends_panel(&there, here) {
                    return Some(there);
                }
                0.5 * step
            } else {
                // A rise beyond where radii fall says little of what is near.
                shorter.clamp(0.25 * step, 0.9 * step)
            };
        }
        None
    }

    /// Whether a panel in the parameter may end at a summit. The slope of radii is an exponential on the way to where they change
    /// fastest, of which 16 points miss (n/2)^32/32! over n e-folds.
    fn ends_panel(&self, end: &Point, from: &Point) -> bool {
        let change = (end.height_share() - from.height_share()).abs();
        let folds = log((end.g_rate / from.g_rate).abs());
        // Where radii do not change any more there are none.
        let is_exponential = self.radius.scores.is_none() && folds.is_finite();
        end.follows(from)
            && !(is_exponential && change * (folds / EXPONENTIAL).powi(2 * POINTS as i32) > EXPONENTIAL_LEFT)
    }

    /// Where a panel in the root of the height above break-away ends: contacts are smooth in it as far as from where none has been.
    fn root_panel_end(&self, separation: f64, here: &Point, clearance: f64, reach: f64, stop: f64) -> Point {
        let root = clearance.sqrt();
        let mut step = PARAMETER_RATIO * (here.contact.overlap + self.lost).max(0.0).sqrt();
        if self.has_onset() {
            step = step.min(root);
        } else if here.contact.radius > 0.999_999 * self.slip.kinks()[0] {
            step = step.min(POWER_RATIO * root);
        }
        let rise = (step * (2.0 * root + step)).clamp(SHORTEST_PANEL, reach.max(SHORTEST_PANEL));
        self.at_height(separation, (here.z + rise).min(stop), here.contact.parameter)
    }

    /// The summits at the nodes of a panel, with their weights in height; those beyond the number of points have none.
    pub(super) fn nodes(&self, separation: f64, panel: &SummitPanel, nodes: &mut Nodes) {
        let guess = panel.guess();
        let (from, to) = (panel.variable(&panel.from), panel.variable(&panel.to));
        let (mut places, mut count) = ([(0.0, 0.0); POINTS], 0);
        for (x, weight) in quadrature::nodes_of_part(panel.part, from, to) {
            places[count] = if panel.is_eased { eased(x, weight, from, to) } else { (x, weight) };
            count += 1;
        }
        for (pair, nodes) in places[..count].chunks_exact(2).zip(nodes.chunks_exact_mut(2)) {
            // Radii are worked out two by two.
            let radii = match panel.axis {
                Axis::Height => self.radius.at_each([pair[0].0, pair[1].0]),
                _ => [(0.0, 0.0); 2],
            };
            for ((node, &(x, weight)), radius) in nodes.iter_mut().zip(pair).zip(radii) {
                let guess = guess.at(x);
                (node.0, node.1) = match panel.axis {
                    Axis::Height => (weight, self.of_radius(separation, x, radius, guess)),
                    Axis::Root(edge) => (2.0 * x * weight, self.at_height(separation, edge + x * x, guess)),
                    Axis::Parameter => {
                        let point = self.on_branch(separation, x, guess);
                        (weight * point.z_rate(), point)
                    }
                };
            }
        }
        let middle = nodes[count / 2].1;
        nodes[count..].fill((0.0, middle));
    }

    /// The summit at a value of the variable of a panel, from its guess of the other.
    #[inline]
    pub(super) fn on_panel(&self, separation: f64, panel: &SummitPanel, x: f64, guess: &Cubic) -> Point {
        match panel.axis {
            Axis::Parameter => self.on_branch(separation, x, guess.at(x)),
            Axis::Height => self.at_height(separation, x, guess.at(x)),
            Axis::Root(edge) => self.at_height(separation, edge + x * x, guess.at(x)),
        }
    }
}

impl Point {
    /// Whether heights follow from the parameter between another summit and this one. Not so if this one was not found.
    fn follows(&self, other: &Self) -> bool {
        let (share, other) = (self.height_share(), other.height_share());
        !self.z.is_nan() && share.max(other) <= MOST_RATE_CHANGE * share.min(other)
    }
}

impl SummitPanel {
    /// Whether the panel serves for a summit at one of its nodes.
    pub(super) fn follows(&self, node: &Point) -> bool {
        self.axis != Axis::Parameter || node.follows(&self.from)
    }

    pub(super) fn variable(&self, point: &Point) -> f64 {
        match self.axis {
            Axis::Parameter => point.contact.parameter,
            Axis::Height => point.z,
            Axis::Root(edge) => (point.z - edge).max(0.0).sqrt(),
        }
    }

    /// How the contact radius changes at one of its ends, over the whole panel.
    pub(super) fn radius_change_at(&self, end: &Point) -> f64 {
        let by_variable = match self.axis {
            Axis::Parameter => end.height_share(),
            Axis::Height => end.contact.by_s.overlap,
            Axis::Root(_) => end.contact.by_s.overlap / (2.0 * self.variable(end)),
        };
        end.radius_change() / by_variable * (self.variable(&self.to) - self.variable(&self.from))
    }

    /// Height by parameter, or parameter by height.
    pub(super) fn guess(&self) -> Cubic {
        let ends = [self.from, self.to];
        let [a, b] = match self.axis {
            Axis::Parameter => ends.map(|end| (end.contact.parameter, end.z, end.z_rate())),
            Axis::Height => ends.map(|end| (end.z, end.contact.parameter, 1.0 / end.z_rate())),
            Axis::Root(_) => ends.map(|end| {
                let root = self.variable(&end);
                (root, end.contact.parameter, 2.0 * root / end.z_rate().max(f64::MIN_POSITIVE))
            }),
        };
        Cubic::new(a, b)
    }
}

/// A node of a panel, and its weight, where nodes gather at both ends: a power of 3/2 of the distance from one is a polynomial.
fn eased(x: f64, weight: f64, from: f64, to: f64) -> (f64, f64) {
    let t = (x - from) / (to - from);
    (from + (to - from) * (t * t * (3.0 - 2.0 * t)), weight * (6.0 * t * (1.0 - t)))
}
