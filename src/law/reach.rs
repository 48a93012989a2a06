//! How far the panels of the curve reach: as far as those before them were good, and not beyond a separation about which the
//! curve is not smooth.

use super::CONDITIONS;
use crate::elementary::pow;
use crate::equilibrium::Branch;

/// No panel is wider than this, in sigma, or than this part of the separation where that is larger.
const WIDEST: f64 = 2.2;
const WIDEST_PART: f64 = 0.6;
/// The panel that ends at pull-off spans no more of s than this; each one before takes this part of the way there.
const LONGEST_LAST: f64 = 2.2;
const PART_OF_THE_WAY: f64 = 0.65;
/// Without a pull-off load no panel covers more than this part of what is left of the branch, at whose end load vanishes.
const MOST_OF_THE_REST: f64 = 0.7;
/// A panel that takes more than this part of what is left takes all.
const WHOLE: f64 = 0.99;
/// A kink nearer to the end than this part of what is left is at the end: contact with the foot that breaks at once.
const AT_END: f64 = 1e-9;
/// How much wider the next panel is tried after an error of less than this part of the tolerance.
const GROWTH: [(f64, f64); 3] = [(0.01, 3.0), (0.03, 2.0), (0.5, 1.5)];
/// Panels end where a table of heights gives the curve a kink. Between more kinks than these hardly a row of the law would
/// be smooth: the curve then serves to find separations, and loads are evaluated exactly.
const MOST_KINKS: usize = 240;
/// What lies between kinks nearer to each other than this, in sigma, or than this part of what is left of the branch, is left
/// out: no row would fit in.
const NEAREST_KINKS: f64 = 0.01;
const NEAREST_PART: f64 = 0.02;
/// The narrowest panels, in sigma, and those near pull-off, where load may change steeply: what is then not resolved (a
/// height density whose foot passes the edge of contact, say) is evaluated exactly.
const NARROWEST: f64 = 0.05;
const NARROWEST_AT_END: f64 = 5e-4;

/// From one separation to another, in sigma.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    from: f64,
    pub to: f64,
    length: f64,
    /// No shorter one is tried.
    narrowest: f64,
}

/// What comes next on the curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Next {
    /// A panel.
    Panel(Stretch),
    /// Kinks so near to each other that no panel fits in before this separation.
    Gap(f64),
}

/// Tells how far the next panel may reach.
#[derive(Debug, Clone)]
pub struct Reach {
    /// Where the branch ends, and whether that is at pull-off.
    end: f64,
    at_pull_off: bool,
    narrowest_at_end: f64,
    /// Where the curve has kinks; none where there are too many.
    kinks: Vec<f64>,
    resolved: bool,
    /// The longest panel, as the last one was.
    width: f64,
    /// Where the curve is found not to be smooth, if that is ahead.
    obstacle: f64,
    /// Whether the last panel was too long.
    failed: bool,
}

impl Reach {
    /// On a branch that ends at this separation.
    pub fn new(branch: &Branch, end: f64) -> Self {
        let mut kinks = branch.kinks();
        let resolved = kinks.len() <= MOST_KINKS;
        if !resolved {
            kinks.clear();
        }
        // Where heights end, all that is left of the branch may be as short as adhesion reaches.
        let narrowest_at_end = match branch.population().heights().support().1.is_finite() {
            true => NARROWEST_AT_END.min(0.01 * branch.population().range_of_adhesion()),
            false => NARROWEST_AT_END,
        };
        Self {
            end,
            at_pull_off: branch.pull_off().is_some(),
            narrowest_at_end,
            kinks,
            resolved,
            width: f64::MAX,
            obstacle: f64::INFINITY,
            failed: false,
        }
    }

    /// Whether panels end at all kinks.
    pub fn is_resolved(&self) -> bool {
        self.resolved
    }

    /// The separations of the kinks at which panels end.
    pub fn kinks(&self) -> &[f64] {
        &self.kinks
    }

    /// What comes next after a separation, at which the coordinate of the curve is `s`.
    pub fn next(&self, from: f64, s: f64) -> Next {
        let remaining = self.end - from;
        let (part, shortest) = match self.at_pull_off {
            false => (MOST_OF_THE_REST, 0.0),
            true if s <= LONGEST_LAST => (1.0, self.narrowest_at_end),
            true => (PART_OF_THE_WAY, self.narrowest_at_end),
        };
        let narrowest = (0.2 * remaining).clamp(shortest, NARROWEST);
        let length = (part * remaining)
            .min(self.width)
            .min((0.5 * (self.obstacle - from)).max(narrowest))
            .min(WIDEST.max(WIDEST_PART * from.abs()));
        // What little would be left is part of this panel.
        let to = if length < WHOLE * remaining { from + length } else { self.end };
        match self.kinks.get(self.kinks.partition_point(|&kink| kink <= from)) {
            Some(&kink) if kink - from < NEAREST_KINKS.min(NEAREST_PART * remaining) && kink < self.end => {
                Next::Gap(kink)
            }
            Some(&kink) if kink < to && self.end - kink > AT_END * remaining => {
                Next::Panel(Stretch { from, to: kink, length: kink - from, narrowest })
            }
            _ => Next::Panel(Stretch { from, to, length, narrowest }),
        }
    }

    /// Whether a panel that misses the curve by so many times the tolerance is kept, since it is good or cannot be shorter; if
    /// not, the next is shorter.
    pub fn keeps(&mut self, stretch: &Stretch, excess: f64) -> bool {
        let Stretch { to, length, narrowest, .. } = *stretch;
        if excess <= 1.0 {
            let growth = GROWTH.iter().find(|&&(part, _)| excess < part).map_or(1.0, |&(_, growth)| growth);
            self.width = growth * length;
        } else if length > narrowest && self.resolved {
            // As the error of so many conditions grows with length.
            let shorter = 0.9 * pow(excess, -1.0 / CONDITIONS as f64);
            self.width = (shorter.clamp(0.25, 0.8) * length).max(narrowest);
            // What is smooth needs no second try.
            if self.failed {
                self.obstacle = to;
            }
            self.failed = true;
            return false;
        }
        self.failed = false;
        if to >= self.obstacle {
            self.obstacle = f64::INFINITY;
        }
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::{HeightFamily, Params};

    fn reach(kinks: &[f64]) -> Reach {
        Reach {
            end: 10.0,
            at_pull_off: true,
            narrowest_at_end: NARROWEST_AT_END,
            kinks: kinks.to_vec(),
            resolved: true,
            width: f64::MAX,
            obstacle: f64::INFINITY,
            failed: false,
        }
    }

    /// The panel after a separation, far from pull-off.
    fn panel(reach: &Reach, from: f64) -> Stretch {
        match reach.next(from, 10.0) {
            Next::Panel(stretch) => stretch,
            gap => panic!("{gap:?}"),
        }
    }

    /// Of a table of so many heights within a few sigma, with adhesion that reaches a small part of it.
    #[test]
    fn kinks_are_kept_unless_they_are_too_many_and_panels_at_the_end_are_as_short_as_adhesion_reaches() {
        for count in [5, 300] {
            let height: Vec<f64> = (0..count).map(f64::from).collect();
            let density: Vec<f64> = height.iter().map(|h| h * (f64::from(count - 1) - h)).collect();
            let params = Params {
                heights: HeightFamily::Tabulated { height: height.into(), density: density.into() },
                height_std: 1e3,
                summit_radius: 1e6,
                ..Params::default()
            };
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let reach = Reach::new(&branch, 1.0);
            let kinks = branch.kinks();
            assert_eq!(reach.is_resolved(), count == 5, "{} kinks", kinks.len());
            assert_eq!(reach.kinks(), if count == 5 { &kinks[..] } else { &[] });
            let shortest = 0.01 * branch.population().range_of_adhesion();
            assert!(reach.narrowest_at_end == shortest && shortest < NARROWEST_AT_END, "{shortest}");
        }
    }

    #[test]
    fn panels_are_as_long_as_those_before_were_good() {
        let mut reach = reach(&[]);
        let first = panel(&reach, 0.0);
        assert_eq!(first.to, WIDEST);
        // Too long: again and shorter, then no farther than halfway to where it failed twice.
        assert!(!reach.keeps(&first, 1e6));
        let second = panel(&reach, 0.0);
        assert!(second.to < 0.5 * first.to && !reach.keeps(&second, 2.0));
        let third = panel(&reach, 0.0);
        assert_eq!(third.to, 0.5 * second.to);
        assert!(reach.keeps(&third, 0.02));
        assert_eq!(panel(&reach, third.to).to, 1.5 * third.to);
        // Beyond the obstacle, by the growth alone.
        let beyond = Stretch { from: third.to, to: second.to, ..third };
        assert!(reach.keeps(&beyond, 0.001));
        assert!((panel(&reach, second.to).length - 3.0 * third.length).abs() < 1e-15);
        let shortest = Stretch { length: third.narrowest, ..third };
        assert!(reach.keeps(&shortest, 1e9), "cannot be shorter");
    }

    #[test]
    fn panels_end_where_the_curve_is_not_smooth() {
        let reach_of_kinks = reach(&[1.0, 1.005, 9.0, 10.0 - 1e-10]);
        assert_eq!(panel(&reach_of_kinks, 0.0).to, 1.0);
        assert_eq!(reach_of_kinks.next(1.0, 10.0), Next::Gap(1.005));
        assert_eq!(panel(&reach_of_kinks, 7.5).to, 9.0);
        assert_eq!(panel(&reach_of_kinks, 9.0).to, 9.0 + PART_OF_THE_WAY);
        // The last panel takes all that is left; a kink that near to the end is at the end.
        assert_eq!(reach_of_kinks.next(9.5, 1.0), Next::Panel(Stretch { to: 10.0, ..panel_at_end(9.5) }));
        // Too many kinks: what misses the curve is kept, and not used.
        let mut unresolved = Reach { resolved: false, ..reach(&[]) };
        let stretch = panel(&unresolved, 0.0);
        assert!(unresolved.keeps(&stretch, 1e9) && !unresolved.is_resolved());
    }

    #[test]
    fn panels_keep_to_the_scale_of_what_is_left() {
        let reach = reach(&[10.0 - 1e-6]);
        assert_eq!(reach.kinks(), [10.0 - 1e-6]);
        // Far from the heights, a part of the separation; near the end, to the last kink before it.
        assert_eq!(panel(&reach, -100.0).to, -100.0 + WIDEST_PART * 100.0);
        assert!((panel(&reach, 9.9).narrowest - 0.02).abs() < 1e-12);
        let Next::Panel(last) = reach.next(10.0 - 1e-4, 1.0) else { panic!("a gap") };
        assert_eq!((last.to, last.length), (10.0 - 1e-6, 10.0 - 1e-6 - (10.0 - 1e-4)));
    }

    fn panel_at_end(from: f64) -> Stretch {
        Stretch { from, to: 10.0, length: 10.0 - from, narrowest: NARROWEST }
    }
}
