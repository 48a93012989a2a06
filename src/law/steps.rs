//! How far the next panel of the curve reaches: not beyond a separation about which the curve is not smooth, and half as far
//! where a panel misses the curve. Lengths are of `position`s.

use super::position::Positions;
use crate::equilibrium::Branch;

/// Without adhesion, how near to the highest summit the branch is followed: loads there are no numbers.
const LEAST_OVERLAP: f64 = 1e-100;
/// Among the heights no panel is longer than this: their density changes on the scale of sigma.
const LONGEST: f64 = 2.0;
/// Below this separation from the mean, in sigma, all summits are deep in contact, and one panel may span all that is left.
const DEEP: f64 = -8.0;
/// The panel that ends at pull-off spans no more of s than this, and not much less, since slopes there have few digits;
/// each one before takes no more than this part of the way there.
const LONGEST_LAST: f64 = 1.6;
const LAST: f64 = 1.2;
const PART_OF_THE_WAY: f64 = 0.65;
/// Without a pull-off load no panel covers more than this part of what is left of the branch, at whose end load vanishes.
const MOST_OF_THE_REST: f64 = 0.7;
/// A panel that takes more than this part of what is left takes all.
const WHOLE: f64 = 0.99;
/// A kink nearer to the end than this part of what is left is at the end: contact with the lower end that breaks at once.
const AT_END: f64 = 1e-9;
/// A stretch shorter than this is first tried as a cubic, which takes two states in place of thirteen.
const SHORT: f64 = 0.02;
/// And may miss by so many times the tolerance, which is then what the compiled law promises: more may be noise.
const MOST_OF_SHORT: f64 = 10.0;
/// The shortest panels: what is then not resolved is too short to matter. Near pull-off, where slopes have few digits, they are
/// this part of what is left.
const SHORTEST: f64 = 1e-6;
const SHORTEST_PART: f64 = 0.01;

/// A panel that misses the curve by more than this many times the tolerance most likely begins at a singularity: what is tried
/// next is its first eighth.
const FAR_OFF: f64 = 1e4;

/// Kinks nearer to each other than this, relative to 1 or to the separation, are one.
const SAME_KINK: f64 = 1e-8;

/// From one separation to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    from: f64,
    pub to: f64,
    /// Whether it is to be a cubic.
    pub is_bridge: bool,
    is_short: bool,
    /// Whether no shorter one is tried.
    pub is_shortest: bool,
}

/// Tells how far the next panel may reach.
#[derive(Debug, Clone)]
pub struct Steps {
    pub positions: Positions,
    /// The separation below which all summits are deep in contact.
    deep: f64,
    /// Where the branch ends, and whether that is at pull-off.
    pub end: f64,
    at_pull_off: bool,
    /// The separations of the kinks at which panels end.
    pub kinks: Vec<f64>,
    /// Where the next panels end, the nearest last: beyond the first are the other halves of those that missed the curve.
    ends: Vec<f64>,
    /// Where the last stretch ends that is no cubic.
    not_bridged: f64,
}

impl Steps {
    pub fn new(branch: &Branch) -> Self {
        let population = branch.population();
        let end = match branch.pull_off() {
            Some(point) => point.separation,
            None => branch.farthest() - LEAST_OVERLAP,
        };
        let positions = Positions { middle: -population.heights().origin() };
        let deep = positions.middle + DEEP;
        Self {
            positions,
            deep,
            end,
            at_pull_off: branch.pull_off().is_some(),
            kinks: apart(population.kinks()),
            ends: Vec::new(),
            not_bridged: f64::NAN,
        }
    }

    /// What comes next after a separation, at which the coordinate of the curve is `s`; kept as it is if no more states are to be
    /// spent.
    pub fn next(&mut self, from: f64, s: f64, is_spent: bool) -> Stretch {
        let to = match self.ends.last() {
            Some(&half) => half,
            None => {
                let kink = self.kink_after(from).filter(|&kink| self.end - kink > AT_END * (self.end - from));
                let to = self.longest(from, s, kink);
                self.ends.push(to);
                to
            }
        };
        let length = self.positions.distance(from, to);
        let is_at_pull_off = self.at_pull_off && to == self.end;
        let is_short = length < SHORT;
        let is_bridge = !is_at_pull_off && is_short && !is_spent && self.not_bridged != to;
        let is_shortest = is_spent || (!is_bridge && length < self.shortest(from, s));
        Stretch { from, to, is_bridge, is_short, is_shortest }
    }

    /// Whether all summits are deep in contact at a separation.
    fn is_deep(&self, separation: f64) -> bool {
        separation < self.deep
    }

    fn kink_after(&self, from: f64) -> Option<f64> {
        self.kinks.get(self.kinks.partition_point(|&kink| kink <= from)).copied()
    }

    /// Where the longest panel from a separation ends, at a kink at the latest.
    fn longest(&self, from: f64, s: f64, kink: Option<f64>) -> f64 {
        let border = (self.is_deep(from) && self.deep < self.end).then_some(self.deep);
        let stop = [kink, border].into_iter().flatten().fold(self.end, f64::min);
        let part = match self.at_pull_off {
            false => MOST_OF_THE_REST,
            true if s <= LONGEST_LAST => 1.0,
            true => PART_OF_THE_WAY.min(1.0 - LAST / s),
        };
        let longest = if self.is_deep(from) { f64::INFINITY } else { LONGEST };
        let length = (part * self.positions.distance(from, self.end)).min(longest);
        // What little would be left is part of this panel.
        match length >= WHOLE * self.positions.distance(from, stop) {
            true => stop,
            false => self.positions.beyond(from, length),
        }
    }

    /// The shortest panel that is tried after a separation.
    fn shortest(&self, from: f64, s: f64) -> f64 {
        let is_near_pull_off = self.at_pull_off && s <= LONGEST_LAST;
        let rest = self.positions.distance(from, self.end);
        if is_near_pull_off {
            SHORTEST_PART * rest
        } else {
            SHORTEST
        }
    }

    /// Whether a panel that misses the curve by so many times the tolerance is kept, since it is good or cannot be
    /// shorter; if not, the next is no cubic, or its first half.
    pub fn keeps(&mut self, stretch: &Stretch, error: f64) -> bool {
        let most = if stretch.is_short { MOST_OF_SHORT } else { 1.0 };
        if error <= most || stretch.is_shortest {
            self.ends.pop();
            return true;
        }
        if stretch.is_bridge {
            self.not_bridged = stretch.to;
        } else {
            let halvings = if error > FAR_OFF { 3 } else { 1 };
            let mut to = stretch.to;
            for _ in 0..halvings {
                to = self.positions.between(stretch.from, to, 0.0);
                self.ends.push(to);
            }
        }
        false
    }
}

/// Kinks without those next to the one before.
fn apart(mut kinks: Vec<f64>) -> Vec<f64> {
    kinks.sort_by(f64::total_cmp);
    kinks.dedup_by(|next, kink| *next - *kink < SAME_KINK * (1.0 + kink.abs()));
    kinks
}

#[cfg(test)]
mod tests {
    use super::*;

    fn steps(kinks: &[f64]) -> Steps {
        Steps {
            positions: Positions { middle: 0.0 },
            deep: DEEP,
            end: 10.0,
            at_pull_off: true,
            kinks: kinks.to_vec(),
            ends: Vec::new(),
            not_bridged: f64::NAN,
        }
    }

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12 * (1.0 + b.abs())
    }

    #[test]
    fn a_panel_that_misses_the_curve_is_halved_until_it_is_good_or_the_shortest() {
        let mut steps = steps(&[4.0]);
        let whole = steps.next(-4.0, 10.0, false);
        assert!(
            near(steps.positions.distance(-4.0, whole.to), LONGEST) && !whole.is_bridge && !steps.keeps(&whole, 1.1)
        );
        let half = steps.next(-4.0, 10.0, false);
        assert!(near(steps.positions.distance(-4.0, half.to), 0.5 * LONGEST));
        // The other half is one panel, and what comes after is as long as can be again.
        assert!(steps.keeps(&half, 0.9));
        let other = steps.next(half.to, 10.0, false);
        assert!(other.to == whole.to && steps.keeps(&other, 0.9));
        let next = steps.next(whole.to, 10.0, false);
        assert!(near(steps.positions.distance(whole.to, next.to), LONGEST));
        // What misses it by far is tried an eighth as long.
        assert!(!steps.keeps(&next, 1.1 * FAR_OFF));
        let mut panel = steps.next(whole.to, 10.0, false);
        assert!(near(steps.positions.distance(whole.to, panel.to), 0.125 * LONGEST));
        let mut halved = 3;
        while !steps.keeps(&panel, 0.9 * FAR_OFF) {
            panel = steps.next(whole.to, 10.0, false);
            halved += 1;
        }
        let length = steps.positions.distance(whole.to, panel.to);
        assert!(halved > 20 && length > 0.5 * SHORTEST && length < SHORTEST, "{halved} times to {length}");
        // Once no more states are to be spent all is kept.
        let spent = steps.next(panel.to, 10.0, true);
        assert!(!spent.is_bridge && steps.keeps(&spent, 1e9));
    }

    #[test]
    fn a_short_stretch_is_first_a_cubic_and_may_be_noise() {
        let mut steps = steps(&[0.01]);
        let cubic = steps.next(0.0, 10.0, false);
        assert!(cubic.is_bridge && !steps.keeps(&cubic, 1.1 * MOST_OF_SHORT));
        let panel = steps.next(0.0, 10.0, false);
        assert!(!panel.is_bridge && panel.to == cubic.to && steps.keeps(&panel, 0.9 * MOST_OF_SHORT));
        assert_eq!(apart(vec![3.0, -1.0, 3.0 + 1e-9]), [-1.0, 3.0]);
    }

    /// At kinks and at the end, but over kinks next to each other.
    #[test]
    fn panels_end_where_the_curve_is_not_smooth() {
        let kinked = || steps(&[1.0, 1.005, 9.0, 10.0 - 1e-10]);
        let ends = [(0.0, 10.0), (7.5, 10.0), (9.5, 1.0)].map(|(from, s)| kinked().next(from, s, false).to);
        assert_eq!(ends, [1.0, 9.0, 10.0]);
        let bridge = kinked().next(1.0, 10.0, false);
        assert!(bridge.is_bridge && bridge.to == 1.005);
    }
}
