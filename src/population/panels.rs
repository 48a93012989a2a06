//! Panels over the summits in contact, from one to a height: as long as the nearest singularity allows, in height or,
//! near break-away, in theta, in which the edge is smooth.

use super::point::{Guess, Point};
use super::Population;
use crate::asperity::maugis::Contact;
use crate::elementary::pow;
use crate::gauss_legendre;
use crate::surface::heights::SHORTEST_PANEL;
use std::f64::consts::FRAC_PI_2;

/// A panel in theta reaches from theta to no less than this fraction of it: u(theta) has its singularity at 0...
const THETA_RATIO: f64 = 0.4;
/// ...and spans no more of the heights than this, in sigma, or this part of where their density is smooth: in theta the
/// density is a steep function of theta^-3.
pub const THETA_SPAN: f64 = 0.15;
/// A panel in height is no longer than this many times the distance to break-away, where theta(u) is singular.
pub const HEIGHT_RATIO: f64 = 2.5;
/// Where contacts above are ever nearer to break-away, which they may touch, a panel takes no more than this part of the way
/// there, or this part of where all else is smooth: what is nearer is nothing.
const APPROACH: f64 = 0.5;
const NEAREST: f64 = 1e-4;
/// Over a panel across which theta changes less than by this factor, it serves as well as the height, and with equal
/// radii its nodes need no solution of their contact's overlap.
const SHORT_RATIO: f64 = 0.8;
/// Panels are tabulated up to this overlap, in sigma: enough for all summits at separations above -8.
pub const LARGEST_OVERLAP: f64 = 18.0;
/// No sum needs as many panels; it bounds the time of a call. A sum that does is no number.
pub const MOST_PANELS: usize = 6000;

/// What walks the panels hands its nodes to.
pub trait Sink {
    /// No more panels than these.
    const MOST_PANELS: usize = MOST_PANELS;
    /// Whether a panel must end where the contact radius has an extremum, though it passes none of the slip law's.
    const EXTREMA: bool = false;
    /// ln phi that is taken as 1.
    fn log_scale(&self) -> f64 {
        f64::NEG_INFINITY
    }
    /// A panel begins, from a point to another, short beside the distance to break-away or not; all its nodes follow.
    fn panel(&mut self, _from: &Point, _to: &Point, _by_height: bool) {}
    /// A node: its height, its weight without the density, and the contact there.
    fn node(&mut self, z: f64, weight: f64, contact: &Contact);
    /// So many summits at a height, and the contact there.
    fn summits(&mut self, _z: f64, _mass: f64, _contact: &Contact) {}
    /// The panels did not suffice.
    fn out_of_panels(&mut self) {}
}

impl Population {
    /// Where the range begins at the foot of the distribution, sums a first panel in which the power law of the
    /// density is smooth; returns where it ends.
    pub(super) fn above_foot(&self, start: Point, upper: f64, sink: &mut impl Sink) -> Point {
        let Some(panel) = self.foot_panel(start.z, upper, || self.clearance(&start)) else {
            return start;
        };
        let mut guess = start.contact.theta;
        for (v, w) in gauss_legendre::nodes(0.0, 1.0) {
            let (rise, rate) = panel.at(v);
            let point = self.point(&start, rise, guess);
            guess = point.contact.theta;
            sink.node(point.z, w * rate, &point.contact);
        }
        self.point(&start, panel.length, guess)
    }

    /// The first panel above the foot, if the range begins there; `clearance` is the distance from the foot to
    /// where the law of one asperity is singular.
    pub(super) fn foot_panel(&self, start: f64, upper: f64, clearance: impl FnOnce() -> f64) -> Option<FootPanel> {
        let (foot, exponent) = (self.heights.foot(), self.heights.power_at_foot()?);
        if start > foot {
            return None;
        }
        // z = foot + length v^p turns phi dz ~ v^(p (exponent + 1) - 1) into at least v^8, and leaves a law
        // that is a power series in z - foot.
        let power = (9.0 / (exponent + 1.0)).max(1.0);
        let length =
            (0.02 * clearance().min(1.0).min(self.radius.smooth_length(foot))).max(SHORTEST_PANEL).min(upper - foot);
        Some(FootPanel { length, power })
    }

    /// How far from z upwards or downwards a panel may reach, as far as heights and radii go, in a sum of this scale.
    pub(super) fn smooth_length(&self, z: f64, upwards: bool, log_scale: f64) -> f64 {
        let above = |z: f64| self.heights.smooth_length(z, log_scale).min(self.radius.smooth_length(z));
        if upwards {
            return above(z);
        }
        // Going down, what lies below is nearer: the distance that z would allow going up, less itself.
        let mut length = self.heights.longest_below(z);
        for _ in 0..60 {
            if above(z - length) >= length {
                break;
            }
            length *= 0.5;
        }
        length
    }

    /// The length of a panel that may have another; what little would be left of the range goes into it, where no knot of
    /// the density lies between.
    pub(super) fn without_remnant(&self, length: f64, remaining: f64) -> f64 {
        let most = if self.heights.knots().is_empty() { 0.8 * remaining } else { remaining };
        if length > most {
            remaining
        } else {
            length
        }
    }

    /// What part a panel is of the longest on which all but the density is smooth; 1 if the density is what limits panels.
    pub(super) fn part_of_smooth(&self, z: f64, length: f64, longest: f64) -> f64 {
        if self.heights.knots().is_empty() {
            1.0
        } else {
            length / longest.min(self.radius.smooth_length(z))
        }
    }

    /// Walks panels from a point to a height, and hands every node to `sink`: height, weight, contact.
    pub(super) fn march(&self, start: Point, end: f64, sink: &mut impl Sink) {
        let upwards = end >= start.z;
        let log_scale = sink.log_scale();
        self.march_by(start, end, |z| self.smooth_length(z, upwards, log_scale), sink);
    }

    /// Walks panels no longer than `smooth_length` of where each begins.
    pub(super) fn march_by<S: Sink>(&self, start: Point, end: f64, smooth_length: impl Fn(f64) -> f64, sink: &mut S) {
        let direction = if end >= start.z { 1.0 } else { -1.0 };
        let constant_radius = self.radius.is_constant();
        let mut here = start;
        for _ in 0..S::MOST_PANELS {
            let remaining = direction * (end - here.z);
            if remaining <= 0.0 {
                return;
            }
            if let Some(there) = self.cell(&here, end, sink) {
                here = there;
                continue;
            }
            let smooth = smooth_length(here.z);
            if remaining <= smooth && self.maugis.is_tip(here.contact.overlap + remaining) {
                return self.walk_tip(&here, remaining, sink);
            }
            let theta_far = self.theta_limit(&here);
            let (clearance, rate) = self.clearance_and_rate(&here);
            let approaches = direction * rate < 0.0;
            let rate = rate.abs().max(1.0);
            let smooth = match approaches {
                true => smooth.min((APPROACH * clearance).max(NEAREST * smooth.min(1.0))),
                false => smooth,
            };
            let curve = (self.maugis.at(theta_far, here.g).overlap - here.contact.overlap) / rate;
            let in_theta = curve.min(THETA_SPAN * smooth.min(1.0));
            let in_height = smooth.min(HEIGHT_RATIO * clearance);
            let by_height = in_height > in_theta;
            let mut length =
                if by_height { self.without_remnant(in_height, remaining) } else { in_theta.min(remaining) };
            let guess = here.guess_towards(theta_far, length / curve);
            let mut there = self.point(&here, direction * length, guess);
            // Load is smooth where only friction has a kink.
            let cut = if self.fineness < 1.0 { None } else { self.first_cut::<S>(&here, &there) };
            if let Some(cut) = cut {
                length = cut.rise_above(&here).abs();
                there = cut;
            }
            sink.panel(&here, &there, by_height);
            let short = there.contact.theta > SHORT_RATIO * here.contact.theta;
            if by_height && !(constant_radius && short && here.contact.overlap < LARGEST_OVERLAP) {
                let rise = direction * length;
                let mut guess = Guess::new(&here, &there, rise);
                let part_of_smooth = self.fineness * self.part_of_smooth(here.z, length, clearance);
                for (part, weight) in gauss_legendre::nodes_of_part(part_of_smooth, 0.0, 1.0) {
                    let point = self.point(&here, part * rise, guess.at(part));
                    guess.learn(part, point.contact.theta);
                    sink.node(point.z, length * weight, &point.contact);
                }
            } else {
                let theta_end = if constant_radius {
                    there.contact.theta
                } else if length == curve && rate == 1.0 {
                    theta_far
                } else {
                    let overlap = here.contact.overlap + length;
                    self.maugis.at_overlap(overlap, here.g, there.contact.theta).theta
                };
                // How the true theta departs, by the end of the panel, from that at the radius of its beginning.
                let drift = (there.contact.theta / theta_end - 1.0) / length;
                let theta = here.contact.theta;
                let part_of_theta = (theta - theta_end) / (theta - theta_far);
                let part = self.fineness * self.part_of_smooth(here.z, length, f64::MAX).max(part_of_theta);
                for (theta, weight) in gauss_legendre::nodes_of_part(part, theta_end, theta) {
                    let reference = self.maugis.at(theta, here.g);
                    let rise = direction * (reference.overlap - here.contact.overlap);
                    let weight = weight * reference.overlap_rate.abs();
                    if constant_radius {
                        sink.node(here.z + rise, weight, &reference);
                    } else {
                        let point = self.point(&here, rise, theta * (1.0 + drift * rise.abs()));
                        sink.node(point.z, weight, &point.contact);
                    }
                }
            }
            here = there;
        }
        sink.out_of_panels();
    }

    /// Walks summits whose contacts are as small as [`Maugis::is_tip`] says: in the square root of the overlap, with a cut
    /// where contact radii pass one of the slip law's.
    fn walk_tip(&self, here: &Point, length: f64, sink: &mut impl Sink) {
        let mut from = *here;
        let at = |overlap: f64| self.point(here, overlap - here.contact.overlap, 0.0);
        let last = here.contact.overlap + length;
        for kink in self.slip.kinks().into_iter().chain([f64::INFINITY]) {
            let overlap = self.maugis.hertz_overlap(kink, here.g).min(last);
            if overlap <= from.contact.overlap {
                continue;
            }
            let to = at(overlap);
            sink.panel(&from, &to, false);
            for (root, weight) in gauss_legendre::nodes(from.contact.overlap.sqrt(), overlap.sqrt()) {
                let point = at(root * root);
                sink.node(point.z, 2.0 * root * weight, &point.contact);
            }
            from = to;
        }
    }

    /// How far down in theta one panel may reach: u(theta) is singular at 0, and between the slip law's radii the
    /// friction force is a fractional power of the radius, singular at theta = pi/2.
    pub(super) fn theta_limit(&self, here: &Point) -> f64 {
        let theta = here.contact.theta;
        let by_curve = THETA_RATIO * theta;
        if here.contact.radius < 0.999_999 * self.slip.kinks()[0] {
            return by_curve;
        }
        // What lies nearer to theta = pi/2 than 1e-4 is negligible.
        by_curve.max(theta - (2.0 * (FRAC_PI_2 - theta)).max(1e-4))
    }

    /// How far in height break-away is at least.
    pub(super) fn clearance(&self, point: &Point) -> f64 {
        self.clearance_and_rate(point).0
    }

    /// The same, and how fast the overlap above that of break-away changes with height: where radii vary, that of break-away
    /// changes too.
    pub(super) fn clearance_and_rate(&self, point: &Point) -> (f64, f64) {
        let edge = self.edges.break_away(&self.maugis, point.g);
        let rate = 1.0 - edge.overlap_by_g * point.g_rate;
        ((point.contact.overlap - edge.overlap) / rate.abs().max(1.0), rate)
    }
}

/// The first panel above the foot of a distribution, in the variable v of z = foot + length v^power.
pub struct FootPanel {
    pub length: f64,
    power: f64,
}

impl FootPanel {
    /// The height above the foot and its derivative by v.
    pub fn at(&self, v: f64) -> (f64, f64) {
        let rise = self.length * pow(v, self.power);
        (rise, self.power * rise / v)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::unequal;

    /// Nor much shorter than it need be.
    #[test]
    fn a_panel_downwards_is_as_long_as_one_upwards_from_its_end() {
        for population in [unequal(0.6, 1.5), unequal(-0.9, 4.0), unequal(0.5, 30.0), unequal(0.0, 1.0)] {
            for z in [-5.0, -0.7, 0.0, 0.3, 2.0, 8.0] {
                let above = |z: f64| population.smooth_length(z, true, f64::NEG_INFINITY);
                let length = population.smooth_length(z, false, f64::NEG_INFINITY);
                assert!(length > 0.0 && length <= above(z - length), "{length} at {z}");
                let longest = population.heights.longest_below(z);
                assert!(length == longest || 2.0 * length > above(z - 2.0 * length), "{length} at {z}");
            }
        }
    }
}
