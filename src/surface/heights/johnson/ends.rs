//! S_B curves of which much lies next to one end or both, down to two heights alone.
//!
//! The density is a spike at an end that no piece of the height axis resolves. Heights are written as logits, x =
//! ln((z - foot)/(head - z)), of which u = (x - median)/epsilon is linear and so the mass in dx smooth and short; a place
//! is known by its distances from both ends, so that nothing is lost next to either. Heights are measured from the head.

use super::fit::EndsFit;
use crate::elementary::{exp, hypot, log};

/// Summits beyond this u, and as much beyond where a sum begins, contribute nothing.
const FARTHEST_SCORE: f64 = 12.0;
/// Logits of places nearer to an end than any number tells from it.
const FARTHEST_LOGIT: f64 = 700.0;
/// The longest panel in u, and its largest change of ln phi, on which a normal density is a polynomial to rounding.
const LONGEST_PANEL: f64 = 1.5;
const STEEPEST_PANEL: f64 = 12.0;

const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;

/// A standardised S_B curve about its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Ends {
    skew: f64,
    kurtosis: f64,
    epsilon: f64,
    /// Logit of the median.
    median: f64,
    /// Distance of the ends.
    width: f64,
    /// The head above the mean.
    head: f64,
    /// The ends, from the head.
    ends: [f64; 2],
}

/// A height between the ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// ln(above_foot/below_head).
    pub logit: f64,
    /// Distance from the foot.
    pub above_foot: f64,
    /// Distance from the head.
    pub below_head: f64,
}

impl Place {
    fn of_distances(above_foot: f64, below_head: f64) -> Self {
        let logit = log(above_foot.max(0.0)) - log(below_head.max(0.0));
        Self { logit, above_foot, below_head }
    }

    /// How far another place is above this one.
    pub fn rise_to(&self, other: &Self) -> f64 {
        if self.above_foot < self.below_head {
            other.above_foot - self.above_foot
        } else {
            self.below_head - other.below_head
        }
    }

    /// The place `rise` higher.
    pub fn raised(&self, rise: f64) -> Self {
        Self::of_distances(self.above_foot + rise, self.below_head - rise)
    }

    /// The distance from the nearer end.
    pub fn from_end(&self) -> f64 {
        self.above_foot.min(self.below_head)
    }
}

impl Ends {
    pub(super) fn new(skew: f64, kurtosis: f64, fit: &EndsFit) -> Self {
        let width = 1.0 / fit.deviation;
        Self {
            skew,
            kurtosis,
            epsilon: fit.epsilon,
            median: -fit.epsilon * fit.step,
            width,
            head: fit.below_head * width,
            ends: [-width, 0.0],
        }
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        self.skew
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// The height above the mean from which heights are measured: the head.
    pub fn origin(&self) -> f64 {
        self.head
    }

    /// The ends of the support.
    pub fn ends(&self) -> &[f64; 2] {
        &self.ends
    }

    /// 1/delta.
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// Their distance.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The place of a logit, which may be infinite.
    #[inline]
    pub fn place(&self, logit: f64) -> Place {
        let smaller = exp(-logit.abs());
        let (near, far) = (self.width * smaller / (1.0 + smaller), self.width / (1.0 + smaller));
        let (above_foot, below_head) = if logit < 0.0 { (near, far) } else { (far, near) };
        Place { logit, above_foot, below_head }
    }

    /// The place of a height, at an end where it is beyond.
    pub fn place_of(&self, z: f64) -> Place {
        let z = z.clamp(-self.width, 0.0);
        Place::of_distances(z + self.width, -z)
    }

    /// The height of a place.
    #[inline]
    pub fn height(&self, place: &Place) -> f64 {
        -place.below_head
    }

    /// The height of a u.
    pub fn height_of_score(&self, u: f64) -> f64 {
        self.height(&self.place(self.median + self.epsilon * u))
    }

    /// u of a logit.
    #[inline]
    pub fn score(&self, logit: f64) -> f64 {
        (logit - self.median) / self.epsilon
    }

    /// The logit of a u.
    pub fn logit_of_score(&self, u: f64) -> f64 {
        self.median + self.epsilon * u
    }

    /// ln of the normal density at the lowest summit that counts, or of its maximum above.
    pub fn log_scale(&self, z: f64) -> f64 {
        let u = self.score(self.place_of(z).logit).max(0.0);
        -0.5 * u * u
    }

    /// Summits per logit, over exp(log_scale).
    #[inline]
    pub fn mass(&self, logit: f64, log_scale: f64) -> f64 {
        let u = self.score(logit);
        exp(-0.5 * u * u - LN_SQRT_2_PI - log_scale) / self.epsilon
    }

    /// The density over exp(log_scale) at a place.
    #[inline]
    pub fn density(&self, place: &Place, log_scale: f64) -> f64 {
        let mass = self.mass(place.logit, log_scale);
        if mass > 0.0 {
            mass * self.width / (place.above_foot * place.below_head)
        } else {
            0.0
        }
    }

    /// ln phi.
    pub fn log_density(&self, z: f64) -> f64 {
        // At the ends, and so beyond them, no summits are left.
        log(self.density(&self.place_of(z), 0.0))
    }

    /// The height at or above another where most summits are per logit.
    pub fn peak_above(&self, start: f64) -> f64 {
        start.max(self.height_of_score(0.0))
    }

    /// The u between which summits count, of those from u on.
    pub fn worth_summing(&self, from: f64) -> (f64, f64) {
        (-FARTHEST_SCORE, hypot(from.max(0.0), FARTHEST_SCORE))
    }

    /// How far from a logit a panel may reach either way, as far as the normal density goes.
    pub fn longest_panel(&self, logit: f64) -> f64 {
        let u = self.score(logit).abs();
        self.epsilon * LONGEST_PANEL.min(STEEPEST_PANEL / (u + LONGEST_PANEL))
    }

    /// The same in the direction +-1 as far as its place goes: to the head and the foot z is singular at the logit 0 +- i pi,
    /// and what depends on the distance from a height beyond an end at its logit +- i pi.
    pub fn longest_smooth(&self, logit: f64, direction: f64, beyond: Option<f64>) -> f64 {
        // A panel as long as the distance to a pole is good; e^x converges on one of 16.
        let length = |pole: f64| {
            let ahead = (pole - logit) * direction;
            if ahead > 0.0 {
                (ahead - 6.0).max(3.0)
            } else {
                3.0 - 2.0 * ahead
            }
        };
        length(0.0).min(beyond.map_or(16.0, length)).min(16.0)
    }

    /// The nearest logit to an end that is told from it.
    pub fn clamped(logit: f64) -> f64 {
        logit.clamp(-FARTHEST_LOGIT, FARTHEST_LOGIT)
    }
}

#[cfg(test)]
mod tests {
    use super::super::heights;
    use super::*;
    use crate::surface::heights::Heights;

    fn curve(skew: f64, above_least: f64) -> Ends {
        match heights(skew, skew * skew + 1.0 + above_least) {
            Heights::Ends(ends) => *ends,
            other => panic!("{other:?}"),
        }
    }

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    #[test]
    fn places_are_known_by_their_distances_from_both_ends() {
        let ends = curve(0.7, 0.05);
        for logit in [-650.0, -40.0, -1.0, 0.0, 0.5, 40.0, 650.0] {
            let place = ends.place(logit);
            assert!(near(place.above_foot / place.below_head, f64::exp(logit), 1e-12), "{logit}");
            assert!(near(place.above_foot + place.below_head, ends.width(), 1e-15), "{logit}");
            assert_eq!(place.from_end(), place.above_foot.min(place.below_head));
            let z = ends.height(&place);
            assert!((z + place.below_head).abs() < 1e-15 * ends.width() && z >= -ends.width() && z <= 0.0, "{logit}");
            if logit.abs() < 30.0 {
                assert!((ends.place_of(z).logit - logit).abs() < 1e-2, "{logit}");
            }
            for other in [-600.0, -38.0, 0.25, 38.0] {
                let other = ends.place(other);
                let rise = place.rise_to(&other);
                assert!((rise - (ends.height(&other) - z)).abs() <= 2e-15 * ends.width(), "{logit}");
                let there = place.raised(rise);
                assert!((there.above_foot - other.above_foot).abs() <= 4e-16 * ends.width(), "{logit}");
                assert!((there.below_head - other.below_head).abs() <= 4e-16 * ends.width(), "{logit}");
            }
        }
        // Next to an end a rise is known to all digits.
        assert!(near(ends.place(-650.0).rise_to(&ends.place(-640.0)), ends.place(-640.0).above_foot, 1e-4));
        assert!(near(ends.place(640.0).rise_to(&ends.place(650.0)), ends.place(640.0).below_head, 1e-4));
        let (below, above) = (ends.place_of(-2.0 * ends.width()), ends.place_of(1.0));
        assert_eq!([below.above_foot, above.below_head], [0.0; 2]);
        assert_eq!(
            [Ends::clamped(-1e9), Ends::clamped(2.0), Ends::clamped(1e9)],
            [-FARTHEST_LOGIT, 2.0, FARTHEST_LOGIT]
        );
        assert_eq!(*ends.ends(), [-ends.width(), 0.0]);
        assert_eq!((ends.skew(), ends.kurtosis()), (0.7, 0.7 * 0.7 + 1.0 + 0.05));
        // The mean lies skew above the middle: of two heights alone, at the part of the upper.
        let two = curve(0.7, 1e-12);
        let upper = 0.5 * (1.0 - 0.7 / (0.7_f64 * 0.7 + 4.0).sqrt());
        assert!(near(two.origin() / two.width(), 1.0 - upper, 1e-6), "{}", two.origin());
    }

    #[test]
    fn mass_and_density_are_those_of_a_normal_score() {
        let ends = curve(-0.4, 0.2);
        let normal = |u: f64| (-0.5 * u * u).exp() / (2.0 * std::f64::consts::PI).sqrt();
        for u in [-9.0, -2.0, -0.3, 0.0, 1.0, 9.0] {
            let logit = ends.logit_of_score(u);
            assert!((ends.score(logit) - u).abs() < 1e-13 && near(logit, ends.median + ends.epsilon() * u, 1e-15));
            let place = ends.place(logit);
            let z = ends.height(&place);
            assert!((ends.height_of_score(u) - z).abs() < 1e-15);
            for log_scale in [0.0, -3.0, 2.0] {
                let scale = f64::exp(-log_scale);
                assert!(near(ends.mass(logit, log_scale), scale * normal(u) / ends.epsilon(), 1e-12), "{u}");
                // Mass per logit times logits per height.
                let step = 1e-5 * place.from_end();
                let rate = (place.raised(step).logit - place.raised(-step).logit) / (2.0 * step);
                assert!(near(ends.density(&place, log_scale), rate * ends.mass(logit, log_scale), 1e-8), "{u}");
            }
            // Nearer to an end a height does not tell the place.
            if logit.abs() < 30.0 {
                assert!((ends.log_density(z) - ends.density(&place, 0.0).ln()).abs() < 1e-2, "{u}");
                let scale = if u > 0.0 { -0.5 * u * u } else { 0.0 };
                assert!((ends.log_scale(z) - scale).abs() < 1e-2, "{u}: {}", ends.log_scale(z));
            }
            assert!((ends.peak_above(z) - z.max(ends.height_of_score(0.0))).abs() < 1e-15, "{u}");
            let (lowest, highest) = ends.worth_summing(u);
            assert_eq!(lowest, -FARTHEST_SCORE);
            assert!(near(highest, (u.max(0.0).powi(2) + 144.0).sqrt(), 1e-15), "{u}: {highest}");
        }
        for beyond in [-ends.width() * (1.0 + 1e-9), 1e-9] {
            assert_eq!(ends.log_density(beyond), f64::NEG_INFINITY);
        }
        assert_eq!(ends.density(&ends.place(1e6), 0.0), 0.0);
    }

    /// As far as the steepness of the normal density and the distance to where heights are singular allow.
    #[test]
    fn panels_are_as_long_as_what_is_summed_is_smooth() {
        let ends = curve(0.0, 0.2);
        for u in [-8.0, -1.0, 0.0, 3.0] {
            let logit = ends.logit_of_score(u);
            let scores = ends.longest_panel(logit) / ends.epsilon();
            assert!(near(scores, LONGEST_PANEL.min(STEEPEST_PANEL / (u.abs() + LONGEST_PANEL)), 1e-12), "{u}");
        }
        for (logit, direction, beyond, expected) in [
            (0.0, 1.0, None, 3.0),
            (-5.0, 1.0, None, 3.0),
            (-12.0, 1.0, None, 6.0),
            (-50.0, 1.0, None, 16.0),
            (2.0, 1.0, None, 7.0),
            (-2.0, -1.0, None, 7.0),
            (12.0, -1.0, None, 6.0),
            (4.0, 1.0, Some(14.0), 4.0),
            (4.0, 1.0, Some(3.0), 5.0),
            (40.0, 1.0, Some(30.0), 16.0),
        ] {
            assert_eq!(ends.longest_smooth(logit, direction, beyond), expected, "{logit} {direction} {beyond:?}");
        }
    }
}
