//! How far the next panel of the curve reaches: not beyond a separation about which the curve is not smooth, and half as far
//! where a panel misses the curve. Lengths are of `position`s.

use super::position::Positions;
use super::tolerance;
use crate::equilibrium::Branch;
use crate::numerics::elementary::log;

/// Without adhesion, how near to the highest summit the branch is followed: loads there are no numbers.
const LEAST_OVERLAP: f64 = 1e-100;
/// Without a pull-off load no panel covers more than this part of what is left of the branch, at whose end load vanishes; nor, beyond a
/// branch, of what is left of 1 - psi.
pub const MOST_OF_THE_REST: f64 = 0.7;
/// A panel that takes more than this part of what is left takes all.
const ALL_THAT_IS_LEFT: f64 = 0.99;
/// A kink nearer to the end than this part of what is left is at the end: contact with the lower end that breaks at once.
const KINK_AT_END: f64 = 1e-9;
/// A shorter stretch hardly changes values: what it misses may be noise.
const SHORT_STRETCH: f64 = 0.02;
/// It may miss by so many times the tolerance, which is then what the compiled law promises.
const MOST_OF_SHORT: f64 = 2.0;
/// It may miss by so many times the tolerance once no more states are to be spent: as many as a model may.
const MOST_WHEN_SPENT: f64 = tolerance::MOST / tolerance::VALUE;
/// The shortest panels, or this part of what is left of the branch, if that is shorter: what is then not resolved is too short to
/// matter.
const SHORTEST_STRETCH: f64 = 1e-6;
const SHORTEST_PART: f64 = 0.01;
/// A panel that misses the curve is halved so often at once, at most, as the error of the last that began there lets expect.
const MOST_HALVINGS: f64 = 4.0;

/// From one separation to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    from: f64,
    pub to: f64,
    /// By how many times the tolerance it may miss the curve.
    most: f64,
    /// How many times their tolerance slopes may miss: over so short a stretch they hardly change values.
    pub slope_slack: f64,
    /// Whether no shorter one is tried.
    pub is_shortest: bool,
}

impl Stretch {
    /// Whether a panel may miss the curve by so many times the tolerance.
    pub fn allows(&self, error: f64) -> bool {
        error <= self.most || self.is_shortest
    }
}

/// Tells how far the next panel may reach.
#[derive(Debug, Clone)]
pub struct Steps {
    pub positions: Positions,
    /// Where the branch ends, and whether that is at pull-off.
    pub end: f64,
    at_pull_off: bool,
    /// The separations of the kinks at which panels end.
    pub kinks: Vec<f64>,
    /// Where the next panels end, the nearest last: beyond the first are the other halves of those that missed the curve.
    ends: Vec<f64>,
    /// The last panel that missed the curve.
    missed: Option<Missed>,
    /// How many panels were kept since.
    kept: u32,
    /// How many others that end there are halved before the next is tried.
    untried: u32,
}

/// A panel that misses the curve.
#[derive(Debug, Clone, Copy)]
struct Missed {
    from: f64,
    to: f64,
    /// ln of its error over the tolerance.
    log_error: f64,
    /// How often it is halved.
    halvings: f64,
    /// How many in turn missed that ended there, before it.
    others: i32,
}

impl Steps {
    pub fn new(branch: &Branch) -> Self {
        let population = branch.population();
        let end = match branch.pull_off() {
            Some(point) => point.separation,
            None => branch.farthest() - LEAST_OVERLAP,
        };
        let positions = Positions { middle: -population.heights().origin() };
        Self {
            positions,
            end,
            at_pull_off: branch.pull_off().is_some(),
            kinks: branch.kinks().to_vec(),
            ends: Vec::new(),
            missed: None,
            kept: 0,
            untried: 0,
        }
    }

    /// What comes next after a separation; if no more states are to be spent, kept where it is not long and not far off.
    pub fn next(&mut self, from: f64, is_spent: bool) -> Stretch {
        let to = match self.ends.last() {
            Some(&to) => self.other_half(from, to),
            None => {
                let kink = self.kink_after(from).filter(|&kink| self.end - kink > KINK_AT_END * (self.end - from));
                let to = self.longest(from, kink);
                self.ends.push(to);
                to
            }
        };
        let length = self.positions.distance(from, to);
        let most = match length < SHORT_STRETCH {
            true if is_spent => MOST_WHEN_SPENT,
            true => MOST_OF_SHORT,
            false => 1.0,
        };
        let is_shortest = length < self.shortest(from);
        Stretch { from, to, most, slope_slack: (SHORT_STRETCH / length).max(1.0).sqrt(), is_shortest }
    }

    /// All that is left of the branch, however well a panel meets it: between pull-off and the lightest load that is asked for.
    pub fn rest(&self, from: f64) -> Stretch {
        Stretch { from, to: self.end, most: f64::INFINITY, slope_slack: 1.0, is_shortest: true }
    }

    /// Where the other half of a panel that missed the curve ends, or its own half if it would miss too.
    fn other_half(&mut self, from: f64, to: f64) -> f64 {
        let is_shortest = self.positions.distance(from, to) < self.shortest(from);
        if is_shortest || self.untried == 0 || self.missed.is_none_or(|missed| missed.to != to) {
            return to;
        }
        self.untried -= 1;
        let half = self.positions.between(from, to, 0.0);
        self.ends.push(half);
        half
    }

    /// No shorter panel is halved.
    fn shortest(&self, from: f64) -> f64 {
        SHORTEST_STRETCH.min(SHORTEST_PART * (self.end - from))
    }

    fn kink_after(&self, from: f64) -> Option<f64> {
        self.kinks.get(self.kinks.partition_point(|&kink| kink <= from)).copied()
    }

    /// Where the longest panel from a separation ends: at a kink at the latest.
    fn longest(&self, from: f64, kink: Option<f64>) -> f64 {
        let stop = kink.unwrap_or(self.end).min(self.end);
        if self.at_pull_off {
            return stop;
        }
        let length = MOST_OF_THE_REST * self.positions.distance(from, self.end);
        // What little would be left is part of this panel.
        match length >= ALL_THAT_IS_LEFT * self.positions.distance(from, stop) {
            true => stop,
            false => self.positions.beyond(from, length),
        }
    }

    /// How often to halve a panel that misses the curve: as often as would do if each time the error falls as it did the last time that
    /// one began there. Where one missed that ended there too, a kink may be near, towards which each half would miss: so many are
    /// halved untried as would do likewise, and no more than twice as many each time.
    fn halvings(&mut self, stretch: &Stretch, log_error: f64) -> f64 {
        let last = self.missed.filter(|last| last.from == stretch.from);
        let expected = last.map_or(1.0, |last| last.halvings * log_error / (last.log_error - log_error));
        let halvings = if expected > 1.0 { expected.ceil().min(MOST_HALVINGS) } else { 1.0 };
        let last = self.missed.filter(|last| last.to == stretch.to);
        let others = last.map_or(0, |last| last.others + 1);
        let expected = last.map_or(0.0, |last| log_error / (last.log_error - log_error));
        let most = 2_f64.powi(others) - 1.0;
        self.untried = if expected > 0.0 { expected.min(most) } else { most } as u32;
        self.kept = 0;
        self.missed = Some(Missed { from: stretch.from, to: stretch.to, log_error, halvings, others });
        halvings
    }

    /// Whether a panel that misses the curve by so many times the tolerance is kept, since it is good or cannot be
    /// shorter; if not, the next is its first half.
    pub fn keeps(&mut self, stretch: &Stretch, error: f64) -> bool {
        if stretch.allows(error) {
            self.ends.pop();
            // Away from a kink halves grow: once two in turn are kept, two are taken at once.
            self.kept += 1;
            if self.kept > 1 && self.ends.len() > 1 {
                self.ends.pop();
            }
            return true;
        }
        let halvings = self.halvings(stretch, log(error));
        let mut to = stretch.to;
        for _ in 0..halvings as u32 {
            to = self.positions.between(stretch.from, to, 0.0);
            self.ends.push(to);
        }
        false
    }
}
