//! Panels for heights that gather next to two ends: in the logit of a height, in which their spikes are smooth.
//!
//! Next to an end nothing but the density changes, and so its whole spike has one contact. Next to an edge of contact the
//! variable is theta as elsewhere. What panels hand on is the mass of summits, the density itself has no bound.

use super::attracted::CIRCLE_RATIO;
use super::panels::{Sink, HEIGHT_RATIO, MOST_PANELS, THETA_SPAN};
use super::point::{Guess, Point};
use super::sums::Summit;
use super::Population;
use crate::asperity::attraction::Attraction;
use crate::elementary::{log, log1p};
use crate::gauss_legendre;
use crate::surface::heights::johnson::ends::{Ends, Place};

/// Nearer to an end than this part of the distance to where the law of one summit is singular, it does not change.
const SAME: f64 = 1e-17;
/// A panel in logit is no longer than this many times the distance to an edge of contact behind it.
const LOGIT_RATIO: f64 = 2.0;
/// A panel of attraction in the circle's radius spans no more than this part of the distance from the nearest end.
const CIRCLE_SPAN: f64 = 0.3;
/// The shortest distance from an edge that counts.
const SHORTEST: f64 = 1e-290;
/// The part of an overlap to which it is known.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// A walk from a place to a logit.
struct Walk<'a> {
    ends: &'a Ends,
    place: Place,
    last: f64,
    direction: f64,
    /// The logits of the lowest and the highest summit that contribute.
    counted: (f64, f64),
}

impl<'a> Walk<'a> {
    fn new(ends: &'a Ends, from: f64, to: f64) -> Self {
        let (place, last) = (ends.place_of(from), ends.place_of(to).logit);
        let direction = if to >= from { 1.0 } else { -1.0 };
        let (lowest, highest) = ends.worth_summing(ends.score(place.logit.min(last)));
        Self { ends, place, last, direction, counted: (ends.logit_of_score(lowest), ends.logit_of_score(highest)) }
    }

    /// Whether nothing is left.
    fn is_over(&self) -> bool {
        let done = if self.direction > 0.0 { self.counted.1 } else { -self.counted.0 };
        let logit = self.direction * self.place.logit;
        logit >= self.direction * self.last || logit >= done
    }

    /// The mass on the way from here to a logit, over exp(log_scale).
    fn mass_to(&self, logit: f64, log_scale: f64) -> f64 {
        let (lower, upper) =
            (self.place.logit.min(logit).max(self.counted.0), self.place.logit.max(logit).min(self.counted.1));
        let mut mass = 0.0;
        let mut from = lower;
        while from < upper {
            let to = upper.min(from + self.ends.longest_panel(from));
            mass +=
                gauss_legendre::nodes(from, to).map(|(x, weight)| weight * self.ends.mass(x, log_scale)).sum::<f64>();
            from = to;
        }
        mass
    }

    /// What the masses of a panel from here to a place are to be multiplied by to be all of its mass, if they are so much.
    /// Overlaps next to that of an edge differ by few digits, with which summits would be lost or counted twice.
    fn part_counted(&self, there: &Place, log_scale: f64, mass: f64) -> f64 {
        if mass > 0.0 {
            self.mass_to(there.logit, log_scale) / mass
        } else {
            1.0
        }
    }

    /// How far behind one end of the heights is, and how far ahead the other.
    fn distances(&self) -> (f64, f64) {
        if self.direction > 0.0 {
            (self.place.above_foot, self.place.below_head)
        } else {
            (self.place.below_head, self.place.above_foot)
        }
    }

    /// Where a walk that has come to an end of the heights, or begins there, is to go on, if the law of one summit is
    /// singular at this distance behind.
    fn beside_end(&self, clearance: f64) -> Option<f64> {
        let near = SAME * clearance.clamp(SHORTEST, self.ends.width());
        let (behind, ahead) = self.distances();
        if behind <= 0.5 * near {
            let next = Ends::clamped(log(near / self.ends.width()));
            let counted = if self.direction > 0.0 { self.counted.0 } else { -self.counted.1 };
            return Some(self.direction * next.max(counted).min(self.direction * self.last));
        }
        (ahead <= near).then_some(self.last)
    }

    /// How far from here a panel in logit may reach, if the law of one summit is singular at this distance behind.
    fn longest_panel(&self, clearance: f64) -> f64 {
        let (behind, ahead) = self.distances();
        let by_score = self.ends.longest_panel(self.place.logit);
        let smooth = |beyond| self.ends.longest_smooth(self.place.logit, self.direction, beyond);
        let longest = if clearance < behind {
            let logits = log1p(clearance / ahead) - log1p(-clearance / behind);
            smooth(None).min(LOGIT_RATIO * logits)
        } else {
            let beyond = log(((clearance - behind) / self.ends.width()).max(f64::MIN_POSITIVE));
            smooth(Some(self.direction * beyond))
        };
        // The law is singular at complex heights around that edge as well.
        let farthest = self.place.raised(self.direction * HEIGHT_RATIO * clearance).logit;
        let in_height = if farthest.is_finite() { self.direction * (farthest - self.place.logit) } else { f64::MAX };
        longest.min(in_height).min(by_score).max(0.0)
    }

    /// The place a length further on, or the last where that is nearer.
    fn raised(&self, length: f64) -> Place {
        let last = self.ends.place(self.last);
        if length < self.direction * self.place.rise_to(&last) {
            self.place.raised(self.direction * length)
        } else {
            last
        }
    }

    /// The place of a logit, or the last where little is left.
    fn towards(&self, length: f64) -> Place {
        let remaining = self.direction * (self.last - self.place.logit);
        let logit = if length > 0.8 * remaining { self.last } else { self.place.logit + self.direction * length };
        self.ends.place(logit)
    }
}

/// A distance from where the law of one summit is singular, or the least that its overlap tells from none: summits that
/// gather nearer to an end than that are one.
fn told_apart(clearance: f64, overlap: f64) -> f64 {
    clearance.max(ROUNDING * overlap.abs())
}

/// The mass of the summits above a height, over exp(log_scale).
pub(super) fn mass_above(ends: &Ends, z: f64, log_scale: f64) -> f64 {
    Walk::new(ends, z, 0.0).mass_to(f64::INFINITY, log_scale)
}

impl Population {
    /// Walks the summits in contact from one to a height.
    pub(super) fn walk_between_ends<S: Sink>(&self, ends: &Ends, start: Point, end: f64, sink: &mut S) {
        let mut walk = Walk::new(ends, start.z, end);
        let mut here = start;
        let log_scale = sink.log_scale();
        let direction = walk.direction;
        for _ in 0..S::MOST_PANELS {
            if walk.is_over() {
                return;
            }
            let (clearance, rate) = self.clearance_and_rate(&here);
            let clearance = told_apart(clearance, here.contact.overlap);
            if let Some(next) = walk.beside_end(clearance) {
                sink.summits(here.z, walk.mass_to(next, log_scale), &here.contact);
                let place = ends.place(next);
                here = self.point(&here, walk.place.rise_to(&place), here.contact.theta);
                walk.place = place;
                continue;
            }
            let mut there_place = walk.towards(walk.longest_panel(clearance));
            let longest = match self.radius.is_constant() {
                true => f64::MAX,
                false => self.smooth_length(here.z, direction > 0.0, log_scale),
            };
            if direction * walk.place.rise_to(&there_place) > longest {
                there_place = walk.place.raised(direction * longest);
            }
            let in_logit = direction * walk.place.rise_to(&there_place);
            let theta_far = self.theta_limit(&here);
            let curve = (self.maugis.at(theta_far, here.g).overlap - here.contact.overlap) / rate.abs().max(1.0);
            let in_theta = curve.min(THETA_SPAN * walk.place.from_end().min(longest).min(1.0));
            let by_logit = in_logit > in_theta || direction * there_place.logit >= direction * walk.last;
            if !by_logit {
                there_place = walk.raised(in_theta);
            }
            let mut rise = walk.place.rise_to(&there_place);
            let mut there = self.point(&here, rise, here.guess_towards(theta_far, rise.abs() / curve));
            if let Some(cut) = self.first_cut::<S>(&here, &there) {
                rise = cut.rise_above(&here);
                there = cut;
                there_place = walk.place.raised(rise);
            }
            there.z = ends.height(&there_place);
            sink.panel(&here, &there, by_logit);
            if by_logit {
                let guess = Guess::new(&here, &there, rise);
                for (logit, weight) in gauss_legendre::nodes(walk.place.logit, there_place.logit) {
                    let place = ends.place(logit);
                    let above = walk.place.rise_to(&place);
                    let point = self.point(&here, above, guess.at(above / rise));
                    sink.summits(ends.height(&place), weight * ends.mass(logit, log_scale), &point.contact);
                }
            } else if self.maugis.is_tip(there.contact.overlap) {
                let [from, to] = [here, there].map(|point| point.contact.overlap.sqrt());
                for (root, weight) in gauss_legendre::nodes(from, to) {
                    let above = root * root - here.contact.overlap;
                    let place = walk.place.raised(above);
                    let point = self.point(&here, above, 0.0);
                    let mass = 2.0 * root * weight * ends.density(&place, log_scale);
                    sink.summits(ends.height(&place), mass, &point.contact);
                }
            } else {
                let overlap = here.contact.overlap + rise.abs();
                let theta_end = self.maugis.at_overlap(overlap, here.g, there.contact.theta).theta;
                let drift = (there.contact.theta / theta_end - 1.0) / rise.abs();
                let mut panel = [(0.0, 0.0, here.contact); gauss_legendre::POINTS];
                for ((theta, weight), node) in gauss_legendre::nodes(theta_end, here.contact.theta).zip(&mut panel) {
                    let reference = self.maugis.at(theta, here.g);
                    let place = walk.place.raised(direction * (reference.overlap - here.contact.overlap));
                    let mass = weight * reference.overlap_rate.abs() * ends.density(&place, log_scale);
                    *node = (ends.height(&place), mass, reference);
                }
                let part = walk.part_counted(&there_place, log_scale, panel.iter().map(|node| node.1).sum());
                for (z, mass, reference) in panel {
                    let contact = if self.radius.is_constant() {
                        reference
                    } else {
                        let above = reference.overlap - here.contact.overlap;
                        self.point(&here, direction * above, reference.theta * (1.0 + drift * above.abs())).contact
                    };
                    sink.summits(z, part * mass, &contact);
                }
            }
            here = there;
            walk.place = there_place;
        }
        sink.out_of_panels();
    }

    /// Hands on the summits that attract without contact, from one of an overlap to a height: overlap, height, mass. Whether
    /// the panels sufficed.
    pub(super) fn attracted_between_ends(
        &self,
        ends: &Ends,
        law: &Attraction,
        (lower, overlap): (f64, f64),
        upper: f64,
        log_scale: f64,
        mut add: impl FnMut(f64, Summit),
    ) -> bool {
        let mut walk = Walk::new(ends, lower, upper);
        let (mut z, mut overlap) = (lower, overlap);
        let mut add = |place: &Place, overlap: f64, mass: f64| {
            let g = self.radius.factor(ends.height(place));
            let attracted = law.at(law.circle(overlap, g), g);
            add(mass, Summit { load: attracted.load, load_by_overlap: attracted.load_by_overlap, ..Summit::default() });
        };
        for _ in 0..MOST_PANELS {
            if walk.is_over() {
                return true;
            }
            let clearance = told_apart(overlap + law.reach, overlap);
            if let Some(next) = walk.beside_end(clearance) {
                add(&walk.place, overlap, walk.mass_to(next, log_scale));
                let place = ends.place(next);
                overlap += walk.place.rise_to(&place);
                walk.place = place;
                continue;
            }
            let mut there = walk.towards(walk.longest_panel(clearance));
            let longest = self.radius.smooth_length(z);
            if walk.place.rise_to(&there) > longest {
                there = walk.place.raised(longest);
            }
            let g = self.radius.factor(z);
            let here = law.at(law.circle(overlap, g), g);
            let mut length = CIRCLE_SPAN * walk.place.from_end().min(longest).min(1.0);
            if !self.radius.is_constant() {
                let farthest = law.at_rate(CIRCLE_RATIO * here.overlap_rate, g);
                let shortest = (SAME.sqrt() * length).max(ROUNDING * overlap.abs());
                length = length.min((farthest.overlap - here.overlap).max(shortest));
            }
            if walk.place.rise_to(&there) > length || there.logit >= walk.last {
                for (logit, weight) in gauss_legendre::nodes(walk.place.logit, there.logit) {
                    let place = ends.place(logit);
                    add(&place, overlap + walk.place.rise_to(&place), weight * ends.mass(logit, log_scale));
                }
            } else {
                there = walk.raised(length);
                let circle_end = law.circle(overlap + walk.place.rise_to(&there), g);
                let mut panel = [(0.0, 0.0, walk.place); gauss_legendre::POINTS];
                for ((circle, weight), node) in gauss_legendre::nodes(here.circle, circle_end).zip(&mut panel) {
                    let reference = law.at(circle, g);
                    let rise = reference.overlap - here.overlap;
                    let place = walk.place.raised(rise);
                    *node = (rise, weight * reference.overlap_rate * ends.density(&place, log_scale), place);
                }
                let part = walk.part_counted(&there, log_scale, panel.iter().map(|node| node.1).sum());
                for (rise, mass, place) in panel {
                    add(&place, overlap + rise, part * mass);
                }
            }
            overlap += walk.place.rise_to(&there);
            walk.place = there;
            z = ends.height(&there);
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::heights::{johnson, Heights};

    fn curve(skew: f64, above_least: f64) -> Ends {
        match johnson::heights(skew, skew * skew + 1.0 + above_least) {
            Heights::Ends(ends) => *ends,
            other => panic!("{other:?}"),
        }
    }

    fn near(a: f64, b: f64) -> bool {
        a == b || (a - b).abs() <= 1e-12 * b.abs().max(1e-3)
    }

    fn reflected(place: &Place) -> Place {
        Place { logit: -place.logit, above_foot: place.below_head, below_head: place.above_foot }
    }

    fn is_reflected(place: &Place, other: &Place) -> bool {
        near(place.logit, -other.logit)
            && near(place.above_foot, other.below_head)
            && near(place.below_head, other.above_foot)
    }

    /// From places at the foot, next to it and farther up to others, with what clearance behind.
    fn walks(ends: &Ends) -> Vec<(Walk<'_>, f64)> {
        let mut walks = Vec::new();
        let starts = [f64::NEG_INFINITY, -600.0, -38.0, -3.0, -0.5, 2.0, 30.0];
        for place in starts.map(|logit| ends.place(logit)) {
            for last in [-650.0, -37.5, -2.6, 0.3, 3.0, 31.0, f64::INFINITY] {
                for counted in [(-690.0, 40.0), (-1.0, 2.5)] {
                    for clearance in [0.0, 1e-20, 1e-3, 0.3, 1.3, 20.0] {
                        if last > place.logit {
                            walks.push((Walk { ends, place, last, direction: 1.0, counted }, clearance));
                        }
                    }
                }
            }
        }
        walks
    }

    #[test]
    fn a_walk_down_is_the_image_of_a_walk_up() {
        for (skew, above_least) in [(0.7, 0.05), (-1.5, 0.3), (3.0, 0.6)] {
            let (ends, image) = (curve(skew, above_least), curve(-skew, above_least));
            for (up, clearance) in walks(&ends) {
                let counted = (-up.counted.1, -up.counted.0);
                let place = reflected(&up.place);
                let down = Walk { ends: &image, place, last: -up.last, direction: -1.0, counted };
                let what = format!("from {} to {}, {clearance:e}", up.place.logit, up.last);
                assert_eq!(up.is_over(), down.is_over(), "{what}");
                assert_eq!(up.distances(), down.distances(), "{what}");
                match (up.beside_end(clearance), down.beside_end(clearance)) {
                    (Some(up), Some(down)) => assert!(near(up, -down), "{what}: {up} {down}"),
                    (up, down) => assert_eq!(up, down, "{what}"),
                }
                if up.place.above_foot == 0.0 {
                    continue;
                }
                let (longest, other) = (up.longest_panel(clearance), down.longest_panel(clearance));
                assert!(near(longest, other) && longest >= 0.0, "{what}: {longest} {other}");
                for length in [1e-3, 0.9, 1.1, 3.0] {
                    let (there, other) = (up.raised(length), down.raised(length));
                    assert!(is_reflected(&there, &other), "{what}: {there:?} {other:?}");
                    let (there, other) = (up.towards(length), down.towards(length));
                    assert!(is_reflected(&there, &other), "{what}: {there:?} {other:?}");
                }
            }
        }
    }

    #[test]
    fn a_walk_does_not_pass_its_end() {
        let ends = curve(0.7, 0.05);
        for (walk, clearance) in walks(&ends) {
            let what = format!("from {} to {}, {clearance:e}", walk.place.logit, walk.last);
            if let Some(next) = walk.beside_end(clearance) {
                assert!(next <= walk.last && next >= walk.counted.0.min(walk.last), "{what}: {next}");
            }
            if walk.place.above_foot == 0.0 {
                continue;
            }
            let rise = walk.place.rise_to(&ends.place(walk.last));
            for length in [1e-3, 0.9, 1.1, 3.0] {
                let expected = if length < rise { length } else { rise };
                let found = walk.place.rise_to(&walk.raised(length));
                assert!((found - expected).abs() < 1e-14, "{what}: {found}, not {expected}");
                let remaining = walk.last - walk.place.logit;
                let expected = if length > 0.8 * remaining { walk.last } else { walk.place.logit + length };
                assert_eq!(walk.towards(length).logit, expected, "{what}");
            }
        }
    }

    /// In logit and in height, where the law of one summit is singular at a place behind.
    #[test]
    fn a_panel_is_not_much_longer_than_its_distance_from_an_edge_of_contact() {
        let ends = curve(0.7, 0.05);
        for (walk, clearance) in walks(&ends) {
            if clearance > 0.0 && clearance < 0.9 * walk.place.above_foot {
                let edge = walk.place.raised(-clearance).logit;
                let longest = walk.longest_panel(clearance);
                let (by_logit, far) = (2.0 * (walk.place.logit - edge), walk.place.raised(2.5 * clearance).logit);
                let most = by_logit.min(far - walk.place.logit) * (1.0 + 1e-6) + 1e-12;
                assert!(longest <= most, "{} {clearance:e}: {longest}, {most}", walk.place.logit);
            }
        }
    }

    /// What a panel lacks of its summits, or has too many of, is mended; nothing is made of none.
    #[test]
    fn a_panel_counts_as_all_of_its_summits() {
        let ends = curve(0.7, 0.05);
        let (walk, there) = (Walk::new(&ends, -1.0, 0.0), ends.place_of(-0.9));
        let all = mass_above(&ends, -1.0, 0.0) - mass_above(&ends, -0.9, 0.0);
        for part in [0.5, 1.0, 3.0] {
            let found = walk.part_counted(&there, 0.0, part * all);
            assert!((found * part - 1.0).abs() < 1e-12, "{found} of {part}");
        }
        assert_eq!(walk.part_counted(&there, 0.0, 0.0), 1.0);
    }

    #[test]
    fn a_distance_is_told_from_none_by_the_digits_of_an_overlap() {
        for (clearance, overlap, expected) in [
            (0.1, 0.0, 0.1),
            (0.0, 0.0, 0.0),
            (0.1, -450.0, 0.1),
            (0.0, -450.0, 450.0 * ROUNDING),
            (1e-17, 0.25, 0.25 * ROUNDING),
            (1e-17, 1e-3, 1e-3 * ROUNDING),
            (-1e-13, 3.0, 3.0 * ROUNDING),
        ] {
            assert_eq!(told_apart(clearance, overlap), f64::max(clearance, expected), "{clearance:e}, {overlap:e}");
        }
    }
}
