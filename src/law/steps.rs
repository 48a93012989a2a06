//! How far the next panel of the curve reaches: not beyond a separation about which the curve is not smooth, and half as far
//! where a panel misses the curve. Lengths are of `position`s.

use super::non_integer_power::NonIntegerPower;
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
/// Kinks nearer to each other than this, in sigma, or than this part of what is left of the branch, are bridged by a
/// parabola, where there are more than a few: they are then those of a table of heights, and not the lower end of a density.
const NEAREST_KINKS: f64 = 0.004;
const FEW_KINKS: usize = 12;
const NEAREST_PART: f64 = 0.02;
/// Far below the heights: the part of the separation in which panels between two kinks have no digits left in
/// the load to say how far it is: those loads are evaluated exactly.
const NEAREST_DEEP_KINKS: f64 = 1e-6;
/// The shortest panels, in sigma, and those near pull-off, where load may change steeply: what is then not resolved is
/// evaluated exactly.
const SHORTEST: f64 = 0.02;
const SHORTEST_AT_END: f64 = 5e-4;

/// From one separation to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    from: f64,
    pub to: f64,
    pub non_integer_power: NonIntegerPower,
    /// Whether it lies between kinks so near to each other that no panel is worth its states.
    pub is_bridge: bool,
    /// Whether no shorter one is tried.
    is_shortest: bool,
}

impl Stretch {
    fn bridge(from: f64, to: f64) -> Self {
        Self { from, to, non_integer_power: NonIntegerPower::Nowhere, is_bridge: true, is_shortest: true }
    }
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
    shortest_at_end: f64,
    /// The separations of the kinks at which panels end.
    pub kinks: Vec<f64>,
    /// Those of them, among the heights, about which it is a non-integer power of the distance. Far below them loads do not
    /// tell the distance well enough.
    non_integer_powers: Vec<f64>,
    /// Those before which alone it is.
    powers_before: Vec<f64>,
    /// Where the next panels end, the nearest last: beyond the first are the other halves of those that missed the curve.
    ends: Vec<f64>,
}

impl Steps {
    pub fn new(branch: &Branch) -> Self {
        let population = branch.population();
        let end = match branch.pull_off() {
            Some(point) => point.separation,
            None => branch.farthest() - LEAST_OVERLAP,
        };
        // Where heights end, all that is left of the branch may be as short as adhesion reaches.
        let shortest_at_end = match population.heights().support().1.is_finite() {
            true => SHORTEST_AT_END.min(0.01 * population.range_of_adhesion()),
            false => SHORTEST_AT_END,
        };
        let positions = Positions { middle: -population.heights().origin() };
        let deep = positions.middle + DEEP;
        Self {
            positions,
            deep,
            end,
            at_pull_off: branch.pull_off().is_some(),
            shortest_at_end,
            kinks: population.kinks(),
            non_integer_powers: population.kinks_of_lower_end().into_iter().filter(|&at| at >= deep).collect(),
            // Next to pull-off itself no state is so near to it.
            powers_before: population.kinks_of_break_away().into_iter().filter(|&at| at < end).collect(),
            ends: Vec::new(),
        }
    }

    /// What comes next after a separation, at which the coordinate of the curve is `s`.
    pub fn next(&mut self, from: f64, s: f64) -> Stretch {
        let begins = self.is_non_integer_power(from);
        let to = match self.ends.last() {
            Some(&half) => half,
            None => {
                let kink = self.kink_after(from).filter(|&kink| self.end - kink > AT_END * (self.end - from));
                let ends = kink.is_some_and(|kink| self.is_non_integer_power(kink));
                let is_near = |kink: f64| kink - from < self.nearest_kink(from);
                if let Some(to) = kink.filter(|&kink| is_near(kink) && !(begins || ends)) {
                    return Stretch::bridge(from, to);
                }
                // A panel has room for one non-integer power.
                let halfway = kink.filter(|_| begins && ends).map(|kink| 0.5 * (from + kink));
                let to = self.longest(from, s, halfway.or(kink));
                self.ends.push(to);
                to
            }
        };
        let non_integer_power = match () {
            () if begins => NonIntegerPower::AtBegin,
            () if self.is_non_integer_power(to) || self.powers_before.contains(&to) => NonIntegerPower::AtEnd,
            () => NonIntegerPower::Nowhere,
        };
        let is_shortest = self.positions.distance(from, to) < self.shortest(from, s);
        Stretch { from, to, non_integer_power, is_bridge: false, is_shortest }
    }

    fn is_non_integer_power(&self, separation: f64) -> bool {
        self.non_integer_powers.contains(&separation)
    }

    /// Whether all summits are deep in contact at a separation.
    pub fn is_deep(&self, separation: f64) -> bool {
        separation < self.deep
    }

    /// The rest of what lies far below the heights up to the next kink, left to exact evaluation.
    pub fn skip(&mut self, from: f64) -> Stretch {
        self.ends.clear();
        Stretch::bridge(from, self.kink_after(from).unwrap_or(f64::INFINITY).min(self.deep).min(self.end))
    }

    fn kink_after(&self, from: f64) -> Option<f64> {
        self.kinks.get(self.kinks.partition_point(|&kink| kink <= from)).copied()
    }

    /// A kink that is nearer than this is bridged.
    fn nearest_kink(&self, from: f64) -> f64 {
        let nearest = if self.is_table() { NEAREST_KINKS } else { SHORTEST }.min(NEAREST_PART * (self.end - from));
        nearest.max(NEAREST_DEEP_KINKS * (self.deep - from))
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
        let rest = self.end - from;
        if self.at_pull_off && s <= LONGEST_LAST {
            return 0.1 * rest;
        }
        let shortest = (0.2 * rest).clamp(if self.at_pull_off { self.shortest_at_end } else { 0.0 }, SHORTEST);
        shortest * self.positions.density(from)
    }

    /// Whether a panel that misses the curve by so many times the tolerance is kept, since it is good or cannot be
    /// shorter; if not, the next is its first half.
    pub fn keeps(&mut self, stretch: &Stretch, error: f64) -> bool {
        let is_kept = error <= 1.0 || stretch.is_shortest;
        if !is_kept {
            self.ends.push(self.positions.between(stretch.from, stretch.to, 0.0));
        } else if !stretch.is_bridge {
            self.ends.pop();
        }
        is_kept
    }

    /// Whether a panel was too long, of which not all is followed yet.
    pub fn has_failed(&self) -> bool {
        !self.ends.is_empty()
    }

    /// Whether the kinks are those of a table.
    fn is_table(&self) -> bool {
        self.kinks.len() > FEW_KINKS
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{HeightFamily, Params};

    fn steps(kinks: &[f64]) -> Steps {
        Steps {
            positions: Positions { middle: 0.0 },
            deep: DEEP,
            end: 10.0,
            at_pull_off: true,
            shortest_at_end: SHORTEST_AT_END,
            kinks: kinks.to_vec(),
            non_integer_powers: Vec::new(),
            powers_before: Vec::new(),
            ends: Vec::new(),
        }
    }

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12 * (1.0 + b.abs())
    }

    /// Of a table of so many heights within a few sigma, with adhesion that reaches a small part of it.
    #[test]
    fn panels_at_the_end_of_heights_are_as_short_as_adhesion_reaches() {
        for count in [5, 256] {
            let height: Vec<f64> = (0..count).map(f64::from).collect();
            let density: Vec<f64> = height.iter().map(|h| h * (f64::from(count - 1) - h)).collect();
            let params = Params {
                heights: HeightFamily::Tabulated { height: height.into(), density: density.into() },
                height_std: 1e3,
                summit_radius: 1e6,
                ..Params::default()
            };
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let steps = Steps::new(&branch);
            let shortest = 0.01 * branch.population().range_of_adhesion();
            assert!(steps.shortest_at_end == shortest && shortest < SHORTEST_AT_END, "{shortest}");
        }
    }

    #[test]
    fn a_panel_that_misses_the_curve_is_halved_until_it_is_good_or_the_shortest() {
        let mut steps = steps(&[4.0]);
        let whole = steps.next(-4.0, 10.0);
        assert!(
            near(steps.positions.distance(-4.0, whole.to), LONGEST) && !whole.is_bridge && !steps.keeps(&whole, 1.1)
        );
        let half = steps.next(-4.0, 10.0);
        assert!(near(steps.positions.distance(-4.0, half.to), 0.5 * LONGEST) && steps.has_failed());
        // The other half is one panel, and what comes after is as long as can be again.
        assert!(steps.keeps(&half, 0.9));
        let other = steps.next(half.to, 10.0);
        assert!(other.to == whole.to && steps.keeps(&other, 0.9) && !steps.has_failed());
        let next = steps.next(whole.to, 10.0);
        assert!(near(steps.positions.distance(whole.to, next.to), LONGEST));
        let (mut panel, mut halved) = (next, 0);
        while !steps.keeps(&panel, 1e9) {
            panel = steps.next(whole.to, 10.0);
            halved += 1;
        }
        let length = panel.to - whole.to;
        assert!(halved > 3 && length > 0.5 * SHORTEST && length < SHORTEST, "{halved} times to {length}");
    }

    /// At kinks and at the end, but over kinks next to each other.
    #[test]
    fn panels_end_where_the_curve_is_not_smooth() {
        let kinked = || steps(&[1.0, 1.005, 9.0, 10.0 - 1e-10]);
        let ends = [(0.0, 10.0), (7.5, 10.0), (9.5, 1.0)].map(|(from, s)| kinked().next(from, s).to);
        assert_eq!(ends, [1.0, 9.0, 10.0]);
        let bridge = kinked().next(1.0, 10.0);
        assert!(bridge.is_bridge && bridge.to == 1.005);
    }

    #[test]
    fn panels_begin_and_end_at_non_integer_powers() {
        let mut steps = Steps { non_integer_powers: vec![0.9, 1.0], ..steps(&[0.9, 1.0, 5.0]) };
        let to_lower_end = steps.next(0.0, 10.0);
        assert_eq!((to_lower_end.to, to_lower_end.non_integer_power), (0.9, NonIntegerPower::AtEnd));
        // One that is not good is tried again from halfway.
        assert!(!steps.keeps(&to_lower_end, 1.5));
        let halfway = steps.next(0.0, 10.0);
        let middle = steps.positions.between(0.0, 0.9, 0.0);
        assert!(halfway.to == middle && halfway.non_integer_power == NonIntegerPower::Nowhere);
        assert!(steps.keeps(&halfway, 0.9));
        let to_lower_end = steps.next(halfway.to, 10.0);
        assert_eq!((to_lower_end.to, to_lower_end.non_integer_power), (0.9, NonIntegerPower::AtEnd));
        assert!(steps.keeps(&to_lower_end, 0.9));
        // Between two of them there are two panels, however near they are.
        let first = steps.next(0.9, 10.0);
        assert_eq!((first.to, first.non_integer_power), (0.95, NonIntegerPower::AtBegin));
        assert!(steps.keeps(&first, 0.9));
        let second = steps.next(0.95, 10.0);
        assert_eq!((second.to, second.non_integer_power), (1.0, NonIntegerPower::AtEnd));
        assert!(steps.keeps(&second, 0.9));
        let beyond = steps.next(1.0, 10.0);
        assert!(beyond.to < 5.0 && beyond.non_integer_power == NonIntegerPower::AtBegin);
    }

    /// Where a height of a table breaks away.
    #[test]
    fn panels_end_but_do_not_begin_at_a_non_integer_power_before_a_kink() {
        let mut steps = Steps { powers_before: vec![1.0], ..steps(&[1.0, 1.5]) };
        for (from, expected) in [(0.0, NonIntegerPower::AtEnd), (1.0, NonIntegerPower::Nowhere)] {
            let panel = steps.next(from, 10.0);
            assert_eq!(panel.non_integer_power, expected);
            assert!(steps.keeps(&panel, 0.9));
        }
    }

    #[test]
    fn far_below_the_heights_panels_reach_from_kink_to_kink() {
        let mut steps = steps(&[-6407.0, -6403.0, -4000.0]);
        for kink in [-6407.0, -6403.0] {
            // While all heights pass it, from one to the next.
            let to_kink = steps.next(if kink < -6403.0 { -5e8 } else { -6407.0 }, 30.0);
            assert!(to_kink.to == kink && !to_kink.is_bridge && steps.keeps(&to_kink, 0.9));
        }
        // What is not worth more states is left to exact evaluation up to the next kink.
        let to_kink = steps.next(-6403.0, 20.0);
        assert!(!steps.keeps(&to_kink, 1.1));
        let skipped = steps.skip(-6403.0);
        assert!(skipped.is_bridge && skipped.to == -4000.0 && steps.keeps(&skipped, 0.0) && !steps.has_failed());
        // Where a panel would be so short that loads do not tell where in it they are.
        assert!(Steps { kinks: vec![-5e6, -5e6 + 4.0], ..steps }.next(-5e6, 30.0).is_bridge);
    }
}
