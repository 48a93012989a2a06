//! The step controller of the curve: how far the next panel reaches. As far as those before it were good, and not beyond
//! a separation about which the curve is not smooth.
//! Lengths are of `position`s.

use super::non_integer_power::NonIntegerPower;
use super::position::Positions;
use super::CONDITIONS;
use crate::elementary::pow;
use crate::equilibrium::Branch;

/// Without adhesion, how near to the highest summit the branch is followed: loads there are no numbers.
const LEAST_OVERLAP: f64 = 1e-100;
/// Among the heights no panel is longer than this: their density changes on the scale of sigma.
const LONGEST: f64 = 2.2;
/// Below this separation from the mean, in sigma, all summits are deep in contact, and panels are as long as they can be.
const DEEP: f64 = -8.0;
/// The longest panel there, a change of load by a factor of 1e8, and of which part of the way to the heights it takes no more:
/// but the last takes all.
const LONGEST_DEEP: f64 = 45.0;
const PART_OF_DEEP: f64 = 0.75;
const LAST_DEEP: f64 = 10.0;
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
/// How much longer the next panel is tried after an error of less than this part of the tolerance.
const GROWTH: [(f64, f64); 3] = [(0.01, 3.0), (0.03, 2.0), (0.5, 1.5)];
/// How long the first panel after a kink is tried.
const AFTER_KINK: f64 = 0.4;
/// After a panel of about the longest that was too long others are no longer than this part of it.
const BELOW_FAILED: f64 = 0.9;
/// Between more kinks than these hardly a row of the law would be smooth: panels that miss the curve are then kept,
/// serve to find separations, and loads are evaluated exactly.
const MOST_KINKS: usize = 240;
/// Kinks nearer to each other than this, in sigma, or than this part of what is left of the branch, are bridged by a
/// parabola, where there are more than a few: they are then those of a table of heights, and not the lower end of a density.
const NEAREST_KINKS: f64 = 0.01;
const FEW_KINKS: usize = 12;
const NEAREST_PART: f64 = 0.02;
/// Far below the heights: the part of the separation in which panels between two kinks have no digits left in
/// the load to say how far it is: those loads are evaluated exactly.
const NEAREST_DEEP_KINKS: f64 = 1e-6;
/// No panel takes more than this part of the way to where the curve is not smooth: there its error is below the tolerance.
const PART_TO_OBSTACLE: f64 = 0.5;
/// The shortest panels, in sigma, and those near pull-off, where load may change steeply: what is then not resolved is
/// evaluated exactly.
const SHORTEST: f64 = 0.05;
const SHORTEST_AT_END: f64 = 5e-4;

/// From one separation to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    pub to: f64,
    pub non_integer_power: NonIntegerPower,
    /// Whether it lies between kinks so near to each other that no panel is worth its states.
    pub is_bridge: bool,
    length: f64,
    /// No shorter one is tried.
    shortest: f64,
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
    /// The separations of the kinks at which panels end; none where there are too many.
    pub kinks: Vec<f64>,
    /// Whether panels end at all kinks.
    pub resolved: bool,
    /// Those of them, among the heights, about which it is a non-integer power of the distance. Far below them loads do not
    /// tell the distance well enough.
    non_integer_powers: Vec<f64>,
    /// The longest panel: longer than the last that was good by the growth that it allows.
    length: f64,
    /// No panel before the next kink is longer: one that was longer failed.
    limit: f64,
    /// The position at which the curve is found not to be smooth, if that is ahead.
    obstacle: f64,
    /// Whether the last panel was too long.
    pub failed: bool,
}

impl Steps {
    pub fn new(branch: &Branch) -> Self {
        let population = branch.population();
        let mut kinks = population.kinks();
        let resolved = kinks.len() <= MOST_KINKS;
        if !resolved {
            kinks.clear();
        }
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
            kinks,
            resolved,
            non_integer_powers: population.kinks_of_lower_end().into_iter().filter(|&at| at >= deep).collect(),
            length: f64::MAX,
            limit: f64::INFINITY,
            obstacle: f64::INFINITY,
            failed: false,
        }
    }

    /// What comes next after a separation, at which the coordinate of the curve is `s`.
    pub fn next(&self, from: f64, s: f64) -> Stretch {
        let rest = self.end - from;
        let kink = self.kink_after(from).filter(|&kink| self.end - kink > AT_END * rest);
        let start = self.positions.position(from);
        let nearest = if self.is_table() { NEAREST_KINKS } else { SHORTEST }.min(NEAREST_PART * rest);
        let nearest = nearest.max(NEAREST_DEEP_KINKS * (self.deep - from));
        let (begins, ends) =
            (self.is_non_integer_power(from), kink.is_some_and(|kink| self.is_non_integer_power(kink)));
        if let Some(to) = kink.filter(|&kink| kink - from < nearest && !(begins || ends)) {
            return self.bridge(from, to);
        }
        let border = (self.is_deep(from) && self.deep < self.end).then_some(self.deep);
        // A panel has room for one non-integer power.
        let halfway = kink.filter(|_| begins && ends).map(|kink| 0.5 * (from + kink));
        let stop = [kink, border, halfway].into_iter().flatten().fold(self.end, f64::min);
        let shortest = if self.at_pull_off && s <= LONGEST_LAST { 0.1 * rest } else { self.shortest(from, rest) };
        let length = self.longest(from, s).min((PART_TO_OBSTACLE * (self.obstacle - start)).max(shortest));
        let whole = self.positions.distance(from, stop);
        // What little would be left is part of this panel.
        let is_whole = length >= WHOLE * whole;
        let (to, length) = if is_whole { (stop, whole) } else { (self.positions.beyond(from, length), length) };
        let non_integer_power = match () {
            () if begins => NonIntegerPower::AtBegin,
            () if is_whole && self.is_non_integer_power(stop) => NonIntegerPower::AtEnd,
            () => NonIntegerPower::Nowhere,
        };
        Stretch { to, non_integer_power, is_bridge: false, length, shortest }
    }

    fn bridge(&self, from: f64, to: f64) -> Stretch {
        let length = self.positions.distance(from, to);
        Stretch { to, non_integer_power: NonIntegerPower::Nowhere, is_bridge: true, length, shortest: length }
    }

    fn is_non_integer_power(&self, separation: f64) -> bool {
        self.non_integer_powers.contains(&separation)
    }

    /// Whether all summits are deep in contact at a separation.
    pub fn is_deep(&self, separation: f64) -> bool {
        separation < self.deep
    }

    /// The rest of what lies far below the heights up to the next kink, left to exact evaluation.
    pub fn skip(&self, from: f64) -> Stretch {
        self.bridge(from, self.kink_after(from).unwrap_or(f64::INFINITY).min(self.deep).min(self.end))
    }

    fn kink_after(&self, from: f64) -> Option<f64> {
        self.kinks.get(self.kinks.partition_point(|&kink| kink <= from)).copied()
    }

    /// The length of a panel from a separation, were there no obstacle.
    fn longest(&self, from: f64, s: f64) -> f64 {
        let part = match self.at_pull_off {
            false => MOST_OF_THE_REST,
            true if s <= LONGEST_LAST => 1.0,
            true => PART_OF_THE_WAY.min(1.0 - LAST / s),
        };
        let longest = if self.is_deep(from) { self.longest_deep(from) } else { LONGEST };
        (part * self.positions.distance(from, self.end)).min(self.length).min(longest)
    }

    fn longest_deep(&self, from: f64) -> f64 {
        let rest = self.positions.distance(from, self.deep);
        if rest > LAST_DEEP {
            LONGEST_DEEP.min(PART_OF_DEEP * rest)
        } else {
            rest
        }
    }

    /// The shortest panel that is tried after a separation.
    fn shortest(&self, from: f64, rest: f64) -> f64 {
        let shortest = (0.2 * rest).clamp(if self.at_pull_off { self.shortest_at_end } else { 0.0 }, SHORTEST);
        shortest * self.positions.density(from)
    }

    /// Whether a panel that misses the curve by so many times the tolerance is kept, since it is good or cannot be
    /// shorter; if not, the next is shorter.
    pub fn keeps(&mut self, stretch: &Stretch, error: f64) -> bool {
        let Stretch { to, length, shortest, .. } = *stretch;
        let to = self.positions.position(to);
        if error <= 1.0 {
            let growth = GROWTH.iter().find(|&&(part, _)| error < part).map_or(1.0, |&(_, growth)| growth);
            // Also where it was short for another reason.
            self.length = (growth * length).max(self.length).min(self.limit);
        } else if length > shortest && self.resolved {
            // As the error of so many conditions grows with length.
            let shorter = 0.9 * pow(error, -1.0 / CONDITIONS as f64);
            let shorter = shorter.clamp(0.25, 0.8);
            // What is smooth needs no second try: the panel begins or ends where the curve is not.
            let is_deep = stretch.to <= self.deep;
            self.length = (if self.failed && is_deep { 0.25 } else { shorter } * length).max(shortest);
            if stretch.non_integer_power == NonIntegerPower::AtEnd {
                // Half of the way is far enough from it.
                self.length = (0.5 * length).max(shortest);
            } else if self.failed && !is_deep {
                self.obstacle = to;
            } else if length > 0.5 * LONGEST && !is_deep {
                self.limit = BELOW_FAILED * length;
            }
            self.failed = true;
            return false;
        }
        self.failed = false;
        if to >= self.obstacle {
            (self.obstacle, self.limit) = (f64::INFINITY, f64::INFINITY);
        }
        self.begin_anew(stretch.to);
        true
    }

    /// Whether the kinks are those of a table.
    fn is_table(&self) -> bool {
        self.kinks.len() > FEW_KINKS
    }

    /// After a kink panels are short again; far below the heights what comes after has nothing to do with what came before.
    fn begin_anew(&mut self, at: f64) {
        if self.kinks.binary_search_by(|kink| kink.total_cmp(&at)).is_err() {
            return;
        }
        self.limit = f64::INFINITY;
        if at < self.deep {
            self.length = f64::MAX;
        } else if !self.is_table() {
            self.length = AFTER_KINK;
        }
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
            resolved: true,
            non_integer_powers: Vec::new(),
            length: f64::MAX,
            limit: f64::INFINITY,
            obstacle: f64::INFINITY,
            failed: false,
        }
    }

    fn near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-12 * (1.0 + b.abs())
    }

    /// Of a table of so many heights within a few sigma, with adhesion that reaches a small part of it.
    #[test]
    fn kinks_are_kept_unless_they_are_too_many_and_panels_at_the_end_are_as_short_as_adhesion_reaches() {
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
            let kinks = branch.population().kinks();
            assert_eq!(steps.resolved, count == 5, "{} kinks", kinks.len());
            assert_eq!(steps.kinks, if count == 5 { &kinks[..] } else { &[] });
            let shortest = 0.01 * branch.population().range_of_adhesion();
            assert!(steps.shortest_at_end == shortest && shortest < SHORTEST_AT_END, "{shortest}");
        }
    }

    #[test]
    fn panels_are_as_long_as_those_before_were_good() {
        let mut steps = steps(&[]);
        let first = steps.next(0.0, 10.0);
        assert!(near(first.length, LONGEST) && !first.is_bridge);
        // Too long: again and shorter, then no farther than a part of the way to where it failed twice.
        assert!(!steps.keeps(&first, 1e6));
        let second = steps.next(0.0, 10.0);
        assert!(second.length < 0.5 * first.length && !steps.keeps(&second, 1e3));
        let third = steps.next(0.0, 10.0);
        assert!(third.length <= PART_TO_OBSTACLE * second.length * (1.0 + 1e-12));
        assert!(steps.keeps(&third, 0.02));
        assert!(third.to + steps.next(third.to, 10.0).length < second.to, "short of the obstacle");
        // Beyond the obstacle, by the growth alone.
        let beyond = Stretch { to: second.to, ..third };
        assert!(steps.keeps(&beyond, 0.001));
        assert!(near(steps.next(second.to, 10.0).length, LONGEST.min(3.0 * third.length)));
        let shortest = Stretch { length: third.shortest, ..third };
        assert!(steps.keeps(&shortest, 1e9), "cannot be shorter");
    }

    /// At kinks and at the end, but over kinks next to each other; where they are too many, what misses the curve is kept.
    #[test]
    fn panels_end_where_the_curve_is_not_smooth() {
        let kinked = steps(&[1.0, 1.005, 9.0, 10.0 - 1e-10]);
        assert_eq!([kinked.next(0.0, 10.0).to, kinked.next(7.5, 10.0).to, kinked.next(9.5, 1.0).to], [1.0, 9.0, 10.0]);
        let bridge = kinked.next(1.0, 10.0);
        assert!(bridge.is_bridge && bridge.to == 1.005);
        let mut unresolved = Steps { resolved: false, ..steps(&[]) };
        let stretch = unresolved.next(0.0, 10.0);
        assert!(unresolved.keeps(&stretch, 1e9) && !unresolved.resolved);
    }

    #[test]
    fn panels_begin_and_end_at_non_integer_powers() {
        let mut steps = Steps { non_integer_powers: vec![0.9, 1.0], ..steps(&[0.9, 1.0, 5.0]) };
        let to_lower_end = steps.next(0.0, 10.0);
        assert_eq!((to_lower_end.to, to_lower_end.non_integer_power), (0.9, NonIntegerPower::AtEnd));
        // One that is not good is tried again from halfway.
        assert!(!steps.keeps(&to_lower_end, 1.5));
        let halfway = steps.next(0.0, 10.0);
        assert!(
            near(halfway.length, PART_TO_OBSTACLE * to_lower_end.length)
                && halfway.non_integer_power == NonIntegerPower::Nowhere
        );
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
        assert!(near(beyond.length, AFTER_KINK) && beyond.non_integer_power == NonIntegerPower::AtBegin);
    }

    #[test]
    fn far_below_the_heights_panels_reach_from_kink_to_kink() {
        let mut steps = steps(&[-6407.0, -6403.0, -4000.0]);
        assert!(near(steps.next(-5e12, 30.0).length, LONGEST_DEEP));
        let to_kink = steps.next(-5e8, 30.0);
        assert!(steps.keeps(&to_kink, 0.9) && to_kink.to == -6407.0);
        // While all heights pass it, from one to the next.
        let to_kink = steps.next(-6407.0, 20.0);
        assert!(!to_kink.is_bridge && to_kink.to == -6403.0);
        assert!(!steps.keeps(&to_kink, 1.1) && steps.next(-6407.0, 20.0).to < to_kink.to);
        // Where a panel would be so short that loads do not tell where in it they are.
        assert!(Steps { kinks: vec![-5e6, -5e6 + 4.0], ..steps }.next(-5e6, 30.0).is_bridge);
    }

    /// One that is as long as the one that failed would fail again.
    #[test]
    fn after_a_panel_that_was_too_long_others_are_shorter_up_to_the_next_kink() {
        let mut steps = steps(&[4.0, 9.0]);
        let first = steps.next(-4.0, 10.0);
        assert!(near(first.length, LONGEST) && !steps.keeps(&first, 20.0));
        let second = steps.next(-4.0, 10.0);
        assert!(steps.keeps(&second, 1e-3));
        assert!(near(steps.next(second.to, 10.0).length, BELOW_FAILED * LONGEST));
        let to_kink = Stretch { to: 4.0, ..second };
        assert!(steps.keeps(&to_kink, 1e-3) && steps.limit == f64::INFINITY);
    }
}
