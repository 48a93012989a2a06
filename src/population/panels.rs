//! Quadrature over the summits in contact at a separation, from the lowest up.
//!
//! Near break-away panels are laid in the parameter of the law of contact, in which the edge and the fold are smooth: the
//! height follows. Far from it they are laid in height, and the contact follows. Panels end where the density of heights is
//! not smooth, and at the kinks of the laws: where a contact radius is one of the slip law's, or an overlap one of the law of
//! contact's.

use super::break_away::LEAST_RATE;
use super::sums::{out_of_panels, Summit};
use super::{Point, Population, ONSET, RADII};
use crate::asperity::contact::KINKS;
use crate::asperity::slip::{Slip, SlipOnset};
use crate::distribution::panel::{self, LowerEndPanel, MOST_PANELS, SHORTEST};
use crate::elementary::exp;
use crate::error::Error;
use crate::numerics::hermite::Cubic;
use crate::numerics::quadrature::{self, POINTS};
use crate::numerics::root;

/// A panel in height is no longer than this many times the distance to break-away, where the law of contact is singular.
const HEIGHT_RATIO: f64 = 2.5;
/// Over a panel in which the parameter changes by less than this part of the distance to where the law is singular, it serves
/// as well as the height: with equal radii, and where overlaps are known to enough digits, in sigma, it needs no solution.
const SHORT_RATIO: f64 = 0.5;
const FAR_FROM_BREAK_AWAY: f64 = 6.0;
/// Where radii vary, dz/ds must not change by more than this factor over a panel in the parameter because they do: where the radius
/// of contact falls with height, the parameter does at last.
const MOST_BEND: f64 = 1.5;
/// A panel in the parameter is no longer than this many times the distance to where the law is singular.
const PARAMETER_RATIO: f64 = 3.0;
/// Between the slip law's radii friction is a power of the contact radius of about 3/2, which the rule follows closely: no
/// longer than this many times the parameter, at 0 of which the radius is 0.
const POWER_RATIO: f64 = 5.0;
/// As a function of the parameter the density is steeper than as one of height: of a panel in height this part is taken.
const PART_OF_HEIGHT_PANEL: f64 = 0.5;
/// Where the density has fallen by e-folds since its largest value fewer digits of it count: a panel may be longer by this
/// for each, up to twice as long.
const LONGER_PER_FOLD: f64 = 0.02;
/// Where contacts slip in part no panel is longer than this many times the parameter, or the distance to break-away: what they
/// resist is singular where they begin to slip as a whole.
const ONSET_RATIO: f64 = 1.0;
/// And over none does the distance from there grow by more than this.
const MOST_GROWTH: f64 = 4.0;
/// A panel that is longer than it should be by no more than this factor is taken.
const LENGTH_SLACK: f64 = 1.05;
/// Less than this part of a panel is not left for another.
const REMNANT: f64 = 1e-3;
/// The panel at a lower end of the heights takes this part of where the law of contact is smooth: there a power of its variable
/// is the height.
pub(super) const PART_AT_LOWER_END: f64 = 0.02;
/// What is less than this part of all above the last mode of the heights ends the sum.
const NEGLIGIBLE: f64 = 1e-18;
/// A slope of ln phi, per sigma, over which rounding errors of heights change the density by no small part.
const STEEPEST: f64 = 1e9;
/// Between two extrema of the contact radius friction is hardly changed by passing a kink if they are nearer to each other than a panel
/// halved so often.
const STEPS_TO_TURN: u32 = 9;
/// The end of a panel takes some three steps to find.
const MOST_STEPS: u32 = 60;

/// What the summits in contact are handed to.
pub trait Visitor {
    /// So many summits at a height, as a fraction of all.
    fn summits(&mut self, z: f64, fraction: f64, summit: &Summit);
    /// The last summit of a panel.
    fn end_of_panel(&mut self, _end: &Point) {}
}

/// What the contacts of a walk are handed to, with all that is known of them.
pub trait ContactVisitor {
    /// So many contacts, as a fraction of all summits.
    fn contacts(&mut self, fraction: f64, point: &Point, slip: &Slip);
    /// The last contact of a panel.
    fn last_contact(&mut self, _end: &Point) {}
}

impl<V: Visitor> ContactVisitor for V {
    #[inline]
    fn contacts(&mut self, fraction: f64, point: &Point, slip: &Slip) {
        self.summits(point.z, fraction, &Summit::new(&point.contact, slip.friction(&point.contact)));
    }

    #[inline]
    fn last_contact(&mut self, end: &Point) {
        self.end_of_panel(end);
    }
}

/// The variable in which a panel is laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Axis {
    Parameter,
    Height,
}

/// A panel between two summits.
#[derive(Debug, Clone, Copy)]
pub struct Panel {
    pub axis: Axis,
    pub from: Point,
    pub to: Point,
    /// Which kink it ends at: the radii first, then those of the law of contact, then that of friction over radius.
    pub kink: Option<usize>,
    /// What part it is of one that all points are needed for.
    part: f64,
    /// Whether it begins or ends where contacts are about to slip as a whole: what they resist goes as the distance to the power
    /// 3/2 there.
    is_eased: bool,
}

/// The summits in contact to go over, from the lowest up.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    pub separation: f64,
    /// The lowest of them.
    pub start: Point,
    /// The height at which summits just break away.
    pub edge_height: f64,
    /// None of them is higher.
    pub end: f64,
}

/// How much has been summed, to know when the rest is negligible.
#[derive(Debug, Default)]
pub struct Progress {
    total: f64,
}

impl Progress {
    /// Takes in summits at an overlap. Load, area and friction grow no faster than the square of the overlap.
    #[inline]
    pub fn add(&mut self, fraction: f64, overlap: f64) {
        self.total += fraction * importance(overlap);
    }
}

/// What a summit counts beside others.
#[inline]
fn importance(overlap: f64) -> f64 {
    let scale = 1.0 + overlap.max(0.0);
    scale * scale
}

impl Population {
    /// Hands summits in contact to a visitor, up to where the rest is negligible.
    pub(super) fn walk(
        &self,
        walk: &Walk,
        progress: &mut Progress,
        visitor: &mut impl ContactVisitor,
    ) -> Result<(), Error> {
        let &Walk { separation, start, edge_height, end } = walk;
        let mut here = self.above_lower_end(walk, progress, visitor);
        let mut kink = None;
        let end = end.min(self.highest);
        let largest = self.heights.log_density(start.z.max(self.heights.last_mode()));
        for _ in 0..MOST_PANELS {
            if here.z >= end {
                return Ok(());
            }
            let stop = self.stop_above(here.z).min(end);
            if stop < end && stop - here.z <= panel::slack(here.z) {
                here = self.at_height(separation, stop, here.contact.parameter);
                continue;
            }
            let log_density = self.heights.log_density(here.z);
            if self.is_rest_negligible(progress, &here, log_density) {
                return Ok(());
            }
            let reach = panel::panel_length(&*self.heights, here.z) * self.panel_factor(largest, here.z, log_density);
            let mut reach = reach.min(self.radius.smooth_length(here.z));
            let lay = |reach: f64| {
                let panel = self.panel(separation, here, kink, here.z - edge_height, reach, stop);
                (panel, self.nodes(separation, &panel))
            };
            let (mut panel, mut nodes) = lay(reach);
            // Where radii change so fast that the height does not follow from the parameter, a shorter panel serves.
            while !nodes.iter().all(|(_, point)| panel.follows(point)) && reach > SHORTEST {
                reach *= 0.25;
                (panel, nodes) = lay(reach);
            }
            let overlaps = nodes.map(|(_, point)| point.contact.overlap);
            let densities = self.densities(separation, nodes.map(|(_, point)| point.z), overlaps);
            for ((weight, point), density) in nodes.iter().zip(densities).take_while(|((weight, _), _)| *weight != 0.0)
            {
                let fraction = weight * density;
                progress.add(fraction, point.contact.overlap);
                visitor.contacts(fraction, point, &self.slip);
            }
            visitor.last_contact(&panel.to);
            (here, kink) = (panel.to, panel.kink);
        }
        Err(out_of_panels(separation))
    }

    /// How much longer a panel may be where the density has fallen from its largest value, both given by their logarithms.
    pub(super) fn panel_factor(&self, largest: f64, z: f64, log_density: f64) -> f64 {
        if z < self.heights.last_mode() {
            return 1.0;
        }
        // No number where the density is 0.
        let fall = (largest - log_density).max(0.0);
        (1.0 + fall * LONGER_PER_FOLD).min(2.0)
    }

    /// Whether the summits above one add nothing to what has been summed: above the last mode, where ln of their density
    /// falls about as fast as there.
    pub(super) fn is_rest_negligible(&self, progress: &Progress, from: &Point, log_density: f64) -> bool {
        if from.z < self.heights.last_mode() {
            return false;
        }
        let density = exp(log_density);
        // Where the density is 0 it has no rate.
        density == 0.0 || {
            let rate = -self.heights.log_density_slope(from.z);
            density * importance(from.contact.overlap) <= NEGLIGIBLE * progress.total * rate
        }
    }

    /// The densities at the nodes of a panel, given by their heights and overlaps: of small overlaps far out in a steep tail
    /// more digits count than heights have.
    #[inline]
    pub(super) fn densities(&self, separation: f64, z: [f64; POINTS], overlaps: [f64; POINTS]) -> [f64; POINTS] {
        let slope = self.heights.log_density_slope(z[POINTS / 2]);
        // Next to the end of the heights it is no number, or so large that a rounding error is no small change; little lies so near.
        let slope = if slope.abs() < STEEPEST { slope } else { 0.0 };
        let mut densities = self.heights.densities(z);
        for i in 0..POINTS {
            let rounding = overlaps[i] - (z[i] - separation);
            densities[i] += densities[i] * (slope * rounding);
        }
        densities
    }

    /// The next height at which a panel must end.
    pub(super) fn stop_above(&self, z: f64) -> f64 {
        let breakpoints = self.heights.breakpoints();
        let next = breakpoints.partition_point(|&breakpoint| breakpoint <= z);
        let next = breakpoints.get(next).copied().unwrap_or(f64::INFINITY).min(self.heights.support().1);
        // Where radii change fastest.
        let turn = -self.radius.origin;
        let is_stop = turn > z && !self.radius.is_constant();
        if is_stop {
            next.min(turn)
        } else {
            next
        }
    }

    /// The first panel where the range begins at a lower end of the distribution at which the density is a power; returns where
    /// it ends.
    fn above_lower_end(&self, walk: &Walk, progress: &mut Progress, visitor: &mut impl ContactVisitor) -> Point {
        let &Walk { separation, start, edge_height, end } = walk;
        let (lower_end, _) = self.heights.support();
        let smooth = (start.z - edge_height).min(self.radius.smooth_length(lower_end));
        let longest = (PART_AT_LOWER_END * smooth).min(end - lower_end);
        let Some(panel) = LowerEndPanel::new(&*self.heights, start.z, longest) else { return start };
        // A kink of the slip law within so short a panel ends it.
        let to = self.at_height(separation, lower_end + panel.length, start.contact.parameter);
        let whole = Panel { axis: Axis::Height, from: start, to, kink: None, part: 1.0, is_eased: false };
        let cut = self.cut_at_kink(separation, whole, None);
        // Its nodes do not gather at its end: where contacts are about to slip is left to another.
        let length = if self.is_onset(cut.kink) { 0.5 } else { 1.0 } * (cut.to.z - lower_end);
        let panel = panel.shortened(length);
        let mut here = start;
        for (rise, fraction) in panel.nodes(&*self.heights) {
            here = self.at_height(separation, lower_end + rise, here.contact.parameter);
            progress.add(fraction, here.contact.overlap);
            visitor.contacts(fraction, &here, &self.slip);
        }
        self.at_height(separation, lower_end + panel.length, here.contact.parameter)
    }

    /// The panel from a summit, `clearance` above break-away, no longer than `reach` and not beyond the height `stop`.
    pub(super) fn panel(
        &self,
        separation: f64,
        here: Point,
        kink: Option<usize>,
        clearance: f64,
        reach: f64,
        stop: f64,
    ) -> Panel {
        // Where radii fall so steeply that the parameter turns back, panels in it would become ever shorter; not so at break-away.
        let turns_back = here.height_share() < LEAST_RATE;
        let by_parameter = if turns_back || clearance > PART_OF_HEIGHT_PANEL * reach / HEIGHT_RATIO {
            None
        } else {
            let is_polynomial = self.heights.is_piecewise_polynomial();
            let reach = if is_polynomial && here.z + reach >= stop { reach } else { PART_OF_HEIGHT_PANEL * reach };
            self.parameter_panel_end(separation, &here, reach, stop)
        };
        let (axis, to) = match by_parameter {
            Some(to) => (Axis::Parameter, to),
            None => {
                let ratio = if self.has_onset() { ONSET_RATIO } else { HEIGHT_RATIO };
                let z = (here.z + reach.min((ratio * clearance).max(SHORTEST))).min(stop);
                let to = self.at_height(separation, z, here.contact.parameter);
                let singular = self.law.distance_to_singularity(here.contact.parameter, self.radius.factor(here.z));
                let is_short = to.contact.parameter - here.contact.parameter < SHORT_RATIO * singular;
                let serves = self.radius.is_constant() && is_short && clearance < FAR_FROM_BREAK_AWAY;
                (if serves { Axis::Parameter } else { Axis::Height }, to)
            }
        };
        let panel = Panel { axis, from: here, to, kink: None, part: 1.0, is_eased: false };
        // Load is smooth where friction has a kink.
        let panel = match self.fineness < 1.0 {
            true => self.cut_at_kink_of_contact(separation, panel, kink),
            false => self.cut_at_kink(separation, panel, kink),
        };
        // A polynomial density is smooth up to where it ends.
        let smooth = if self.heights.is_piecewise_polynomial() { self.radius.smooth_length(here.z) } else { reach };
        // What contacts about to slip resist asks for all points.
        let part = if self.has_onset() { 1.0 } else { self.fineness * self.part(&panel, clearance, smooth) };
        Panel { part, is_eased: self.is_onset(kink) || self.is_onset(panel.kink), ..panel }
    }

    /// What part a panel is of the longest over which the law of contact is smooth, and heights and radii as far as `smooth`.
    fn part(&self, panel: &Panel, clearance: f64, smooth: f64) -> f64 {
        let rise = panel.to.z - panel.from.z;
        match panel.axis {
            Axis::Height => rise / smooth.min(HEIGHT_RATIO * clearance),
            // The ends do not tell how dz/ds changes between them.
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
        let smooth = if self.has_onset() { smooth.min((ONSET_RATIO * s).max(SHORTEST)) } else { smooth };
        // Of the shortest panel at a parameter of 0 the end counts.
        let radius = if s > SHORTEST { from.contact.radius } else { self.law.at(SHORTEST, g).radius };
        if radius > 0.999_999 * self.slip.kinks()[0] {
            smooth.min((POWER_RATIO * s).max(SHORTEST))
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
            if !there.follows(here) {
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
                if there.follows(here) {
                    return Some(there);
                }
                let half = 0.5 * (there.contact.parameter - s);
                if half <= 0.0 {
                    return None;
                }
                half
            } else {
                shorter.min(0.9 * step)
            };
        }
        None
    }

    /// The same panel, or its first part up to a kink. Where radii vary with height it ends at an extremum of the contact
    /// radius too, so that each radius within shows at its ends.
    fn cut_at_kink(&self, separation: f64, panel: Panel, start_kink: Option<usize>) -> Panel {
        let mut panel = self.cut_at_kink_of_contact(separation, panel, start_kink);
        if !self.radius.is_constant() {
            if let Some(turn) = self.between_extrema(separation, &panel) {
                panel.to = self.on_panel(separation, &panel, turn);
                panel.kink = None;
            }
            self.cut_where(separation, &mut panel, Point::radius_change, None);
        }
        for (index, kink) in self.radius_kinks.into_iter().enumerate().filter(|&(index, _)| start_kink != Some(index)) {
            self.cut_where(separation, &mut panel, |point| point.contact.radius - kink, Some(index));
        }
        if let Some(ratio) = self.onset_ratio {
            if !self.slip.is_of_radius() {
                self.cut_at_friction_over_radius(separation, &mut panel, ratio, start_kink);
            }
            if self.has_onset() && !self.is_onset(start_kink) {
                self.cut_near_onset(separation, &mut panel, ratio);
            }
        }
        panel
    }

    /// Where within a panel the contact radius falls though it rises at both ends, or the other way: it turns back on either side.
    /// `None` also where it is far from where friction has a kink, and where radii do not fall with height.
    fn between_extrema(&self, separation: f64, panel: &Panel) -> Option<f64> {
        let [start, end] = [panel.from, panel.to].map(|end| panel.radius_change(&end));
        // A panel that begins at an extremum begins with next to no change, of either sign.
        if self.radius.amplitude > 0.0 || start * end < 0.0 {
            return None;
        }
        let (a, b) = (panel.from.contact.radius, panel.to.contact.radius);
        let reach = start.abs() + end.abs();
        let near = a.min(b) - reach..a.max(b) + reach;
        if !self.radius_kinks.iter().any(|kink| near.contains(kink)) {
            return None;
        }
        // The smallest change of the radius is looked for on both sides of the best place so far, ever nearer.
        let change = |x: f64| (start + end).signum() * self.on_panel(separation, panel, x).radius_change();
        let (from, to) = (panel.variable(&panel.from), panel.variable(&panel.to));
        let (mut place, mut step) = (0.5 * (from + to), 0.5 * (to - from));
        let mut least = change(place);
        for _ in 0..STEPS_TO_TURN {
            if least < 0.0 {
                break;
            }
            step *= 0.5;
            for x in [place - step, place + step] {
                let there = change(x);
                if there < least {
                    (place, least) = (x, there);
                }
            }
        }
        (least < 0.0).then_some(place)
    }

    /// Ends a panel where its summits are much farther from the onset of slip, or much nearer, than where it begins: what they
    /// resist is singular there, also where no summit is of that height.
    fn cut_near_onset(&self, separation: f64, panel: &mut Panel, ratio: f64) {
        let left = |point: &Point| 1.0 - ratio * point.contact.radius / self.slip.friction(&point.contact).force;
        let [from, to] = [panel.from, panel.to].map(|point| left(&point));
        if from > 0.0 && !self.is_onset(panel.kink) {
            let limit = if to > from { MOST_GROWTH * from } else { from / MOST_GROWTH };
            self.cut_where(separation, panel, |point| left(point) - limit, None);
        }
    }

    /// Ends a panel where the friction force of its summits is this times the contact radius, and where their ratio turns
    /// back, so that each ratio within shows at the ends.
    fn cut_at_friction_over_radius(&self, separation: f64, panel: &mut Panel, ratio: f64, start_kink: Option<usize>) {
        const KINK: Option<usize> = Some(RADII + KINKS);
        let turn = |point: &Point| {
            let friction = self.slip.friction(&point.contact);
            point.change(|rates| friction.rate(rates)) * point.contact.radius - friction.force * point.radius_change()
        };
        self.cut_where(separation, panel, turn, None);
        if start_kink != KINK {
            let excess = |point: &Point| match point.contact.radius {
                // Force over radius is 0 at 0.
                0.0 => -ratio,
                radius => self.slip.friction(&point.contact).force / radius - ratio,
            };
            self.cut_where(separation, panel, excess, KINK);
        }
    }

    /// The same for the kinks of the law of contact, which move with the radius: where a summit is nearest to or farthest
    /// from one a panel ends too. There is no more than one such place as far as radii change ever faster or ever slower.
    fn cut_at_kink_of_contact(&self, separation: f64, mut panel: Panel, start_kink: Option<usize>) -> Panel {
        for (index, kink) in self.kinks_of_contact.into_iter().enumerate().filter(|(_, kink)| kink.is_finite()) {
            if !self.radius.is_constant() {
                self.cut_where(separation, &mut panel, |point| 1.0 - kink * point.g_rate, None);
            }
            if start_kink != Some(RADII + index) {
                let residual = |point: &Point| point.contact.overlap - kink * self.radius.factor(point.z);
                self.cut_where(separation, &mut panel, residual, Some(RADII + index));
            }
        }
        panel
    }

    /// Whether panels end where contacts are about to slip as a whole, after they have slipped in part.
    fn has_onset(&self) -> bool {
        self.onset_ratio.is_some() && self.slip.onset == SlipOnset::Partial
    }

    /// Whether a kink is where they are.
    fn is_onset(&self, kink: Option<usize>) -> bool {
        let is_one = kink.is_some_and(|kink| (ONSET..RADII).contains(&kink) || kink == RADII + KINKS);
        is_one && self.slip.onset == SlipOnset::Partial
    }

    /// Ends a panel where a function of its summits changes sign: at a kink, or near enough to an extremum.
    fn cut_where(&self, separation: f64, panel: &mut Panel, f: impl Fn(&Point) -> f64, kink: Option<usize>) {
        let ends = [panel.from, panel.to].map(|end| (panel.variable(&end), f(&end)));
        let [(from, at_from), (to, at_to)] = ends;
        // An end that was not found tells nothing: the panel will be tried again shorter.
        if (at_from < 0.0) == (at_to < 0.0) || to.is_nan() {
            return;
        }
        let root = root::between(|x| f(&self.on_panel(separation, panel, x)), ends[0], ends[1]);
        if is_inside(root, from, to) {
            panel.to = self.on_panel(separation, panel, root);
            panel.kink = kink;
        }
    }

    /// The summits at the nodes of a panel, with their weights in height; those beyond the number of points have none.
    pub(super) fn nodes(&self, separation: f64, panel: &Panel) -> [(f64, Point); POINTS] {
        let guess = panel.guess();
        let mut nodes = [(0.0, panel.from); POINTS];
        let (from, to) = (panel.variable(&panel.from), panel.variable(&panel.to));
        let mut count = 0;
        for (x, weight) in quadrature::nodes_of_part(panel.part, from, to) {
            let (x, weight) = if panel.is_eased { eased(x, weight, from, to) } else { (x, weight) };
            let point = self.at_place(separation, panel.axis, x, guess.at(x));
            nodes[count] = match panel.axis {
                Axis::Parameter => (weight * point.z_rate(), point),
                Axis::Height => (weight, point),
            };
            count += 1;
        }
        let middle = nodes[count / 2].1;
        nodes[count..].fill((0.0, middle));
        nodes
    }

    /// The summit at a value of the variable of a panel.
    fn on_panel(&self, separation: f64, panel: &Panel, x: f64) -> Point {
        self.at_place(separation, panel.axis, x, panel.guess().at(x))
    }

    /// The summit of a parameter or of a height, from a guess of the other.
    #[inline]
    fn at_place(&self, separation: f64, axis: Axis, x: f64, guess: f64) -> Point {
        match axis {
            Axis::Parameter => self.on_branch(separation, x, guess),
            Axis::Height => self.at_height(separation, x, guess),
        }
    }
}

impl Point {
    /// Whether heights follow from the parameter between another summit and this one. Not so if this one was not found.
    fn follows(&self, other: &Self) -> bool {
        let (share, other) = (self.height_share(), other.height_share());
        !self.z.is_nan() && share.max(other) <= MOST_BEND * share.min(other)
    }
}

impl Panel {
    /// Whether the panel serves for a summit at one of its nodes.
    fn follows(&self, node: &Point) -> bool {
        self.axis == Axis::Height || node.follows(&self.from)
    }

    fn variable(&self, point: &Point) -> f64 {
        match self.axis {
            Axis::Parameter => point.contact.parameter,
            Axis::Height => point.z,
        }
    }

    /// How the contact radius changes at one of its ends, over the whole panel.
    fn radius_change(&self, end: &Point) -> f64 {
        let by_variable = match self.axis {
            Axis::Parameter => end.height_share(),
            Axis::Height => end.contact.by_s.overlap,
        };
        end.radius_change() / by_variable * (self.variable(&self.to) - self.variable(&self.from))
    }

    /// Height by parameter, or parameter by height.
    fn guess(&self) -> Cubic {
        let ends = [self.from, self.to];
        let [a, b] = match self.axis {
            Axis::Parameter => ends.map(|end| (end.contact.parameter, end.z, end.z_rate())),
            Axis::Height => ends.map(|end| (end.z, end.contact.parameter, 1.0 / end.z_rate())),
        };
        Cubic::new(a, b)
    }
}

/// A node of a panel, and its weight, where nodes gather at both ends: a power of 3/2 of the distance from one is a polynomial.
fn eased(x: f64, weight: f64, from: f64, to: f64) -> (f64, f64) {
    let t = (x - from) / (to - from);
    (from + (to - from) * (t * t * (3.0 - 2.0 * t)), weight * (6.0 * t * (1.0 - t)))
}

/// Whether a cut leaves a panel on both sides, rounding apart.
fn is_inside(x: f64, from: f64, to: f64) -> bool {
    let part = (x - from) / (to - from);
    part > 1e-12 && part < 1.0 - 1e-12
}
