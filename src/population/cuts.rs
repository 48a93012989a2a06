//! Where a panel is cut: at the summits whose contact radius is one of the slip law's, so that it passes none within.

use super::panels::Sink;
use super::point::Point;
use super::Population;
use crate::elementary::cos;
use crate::root;

/// What part of a radius of the slip law is nothing beside it.
const AT_KINK: f64 = 1e-9;

impl Population {
    /// The first summit between two where the integrand has a kink: its contact radius is one of the slip law's
    /// radii. Where the contact radius has an extremum between the two that matters, the summit of that.
    pub(super) fn first_cut<S: Sink>(&self, here: &Point, end: &Point) -> Option<Point> {
        let mut cut = None;
        let mut there = *end;
        if !self.radius.is_constant() && (S::EXTREMA || self.may_pass_kink(here, &there)) {
            // Between two extrema, so that each is seen.
            if let Some(part) = between_extrema(here, &there) {
                let turn = self.point(here, part * (there.z - here.z), here.guess_towards(there.contact.theta, part));
                if turn.is_on_the_way(here, end) {
                    there = turn;
                    cut = Some(there);
                }
            }
        }
        if !self.radius.is_constant()
            && (here.radius_rise() > 0.0) != (there.radius_rise() > 0.0)
            && (S::EXTREMA || self.may_pass_kink(here, &there))
        {
            let mut theta = there.contact.theta;
            let rate = |rise: f64| {
                let point = self.point(here, rise, theta);
                theta = point.contact.theta;
                point.radius_rise()
            };
            let rise = root::bracketed(rate, 0.0, there.z - here.z);
            if is_inside(rise, there.z - here.z) {
                let turn = self.point(here, rise, theta);
                if turn.is_on_the_way(here, end) {
                    there = turn;
                    cut = Some(there);
                }
            }
        }
        for kink in self.slip.kinks() {
            // Next to theta = pi/2 radii are known to so many digits of that of the annulus.
            let is_at = |point: &Point| {
                let outer_radius = point.contact.radius / cos(point.contact.theta);
                (point.contact.radius - kink).abs() < (AT_KINK * kink).max(1e-14 * outer_radius)
            };
            if (here.contact.radius < kink) != (there.contact.radius < kink) && !is_at(here) && !is_at(&there) {
                let at_kink = self.point_of_radius(here, &there, kink);
                // Next to a fold the radius is so steep that no height tells the two apart.
                if at_kink.is_on_the_way(here, end) {
                    there = at_kink;
                    cut = Some(there);
                }
            }
        }
        cut
    }

    /// Whether contact radii between two summits, where they have an extremum, may pass one of the slip law's. They change by
    /// no more than a few times what their slopes at the two give; in theta these are finite at break-away too.
    fn may_pass_kink(&self, here: &Point, there: &Point) -> bool {
        let change_at = |point: &Point| {
            let by_theta = point.contact.radius_rate * (there.contact.theta - here.contact.theta);
            let by_g = point.contact.radius_by_g * point.g_rate * (there.z - here.z);
            by_theta.abs() + by_g.abs()
        };
        let change = 4.0 * change_at(here).max(change_at(there));
        let (a, b) = (here.contact.radius, there.contact.radius);
        self.slip.kinks().iter().any(|&kink| kink > a.min(b) - change && kink < a.max(b) + change)
    }

    /// The summit between two whose contact radius is `radius`, by Newton's method within the bracket.
    fn point_of_radius(&self, here: &Point, there: &Point, radius: f64) -> Point {
        let rising = there.contact.radius > here.contact.radius;
        let (mut lower, mut upper) = (0.0, 1.0);
        let whole = there.z - here.z;
        let mut part = part_of_radius(here, there, radius);
        let mut point = self.point(here, part * whole, here.guess_towards(there.contact.theta, part));
        for _ in 0..100 {
            let excess = point.contact.radius - radius;
            if (excess > 0.0) == rising {
                upper = part;
            } else {
                lower = part;
            }
            let slope = point.radius_slope() * whole;
            let newton = part - excess / slope;
            let next = if newton > lower && newton < upper { newton } else { 0.5 * (lower + upper) };
            let change = next - part;
            // theta to first order in the step.
            let theta = point.contact.theta;
            let guess = theta + (change * whole * point.theta_slope()).clamp(-0.5 * theta, 0.5 * theta);
            part = next;
            point = self.point(here, part * whole, guess);
            let is_there = (point.contact.radius - radius).abs() <= 1e-2 * AT_KINK * radius;
            if is_there || change.abs() <= 1e-14 * part {
                break;
            }
        }
        point
    }
}

/// About which part of the way from one summit to another the contact radius is `radius`: by the cubic that has the height's
/// values and slopes against radius at both, or the straight line where that leaves the way.
fn part_of_radius(here: &Point, there: &Point, radius: f64) -> f64 {
    let change = there.contact.radius - here.contact.radius;
    let line = (radius - here.contact.radius) / change;
    let slope = |point: &Point| change / (point.radius_slope() * (there.z - here.z));
    let (start, end) = (slope(here), slope(there));
    let cubic = line * (start + line * ((3.0 - 2.0 * start - end) + line * (start + end - 2.0)));
    if cubic > 0.0 && cubic < 1.0 {
        cubic
    } else {
        line.clamp(1e-6, 1.0 - 1e-6)
    }
}

/// Where between two summits, as a part of the way, the contact radius turns back from an extremum to another, by the cubic
/// that has its values and slopes at both.
fn between_extrema(here: &Point, there: &Point) -> Option<f64> {
    let whole = there.z - here.z;
    let change = there.contact.radius - here.contact.radius;
    let [start, end] = [here, there].map(|point| point.radius_slope() * whole);
    // Its slope is start + 2 b t + 3 c t^2.
    let (b, c) = (3.0 * change - 2.0 * start - end, start + end - 2.0 * change);
    let part = -b / (3.0 * c);
    let turns = start + b * part;
    (start * end > 0.0 && start * turns < 0.0 && part > 0.1 && part < 0.9).then_some(part)
}

/// Whether a rise ends well inside a range.
fn is_inside(rise: f64, whole: f64) -> bool {
    let part = rise / whole;
    part > 1e-9 && part < 1.0 - 1e-9
}

#[cfg(test)]
mod tests {
    use super::super::point::tests::summit;
    use super::super::tests::{of, unequal, Few};
    use super::*;
    use crate::asperity::maugis::tests::EVALUATIONS;
    use crate::params::Params;

    #[test]
    fn the_summit_of_a_contact_radius_is_found_in_few_steps() {
        let mut count = 0;
        for (amplitude, rate) in [(0.6, 1.5), (-0.3, 0.8), (0.9, 0.3)] {
            let population = unequal(amplitude, rate);
            for (from, rise) in [(-1.0, 0.7), (0.2, 0.4), (0.6, -0.5), (-0.3, 0.01)] {
                let here = population.point_cold(-2.0, from);
                let there = population.point(&here, rise, here.contact.theta);
                let radii = (here.contact.radius, there.contact.radius);
                for part in [1e-6, 0.1, 0.5, 0.83, 1.0 - 1e-6] {
                    let radius = radii.0 + part * (radii.1 - radii.0);
                    let start = part_of_radius(&here, &there, radius);
                    let guess = here.guess_towards(there.contact.theta, start);
                    let near = population.point(&here, start * rise, guess).contact.radius;
                    assert!((near - radius).abs() < 0.02 * (radii.1 - radii.0).abs(), "{near}, not {radius}");
                    EVALUATIONS.set(0);
                    let found = population.point_of_radius(&here, &there, radius);
                    count += EVALUATIONS.get();
                    assert!((found.contact.radius / radius - 1.0).abs() < 1e-11, "{found:?}, not {radius}");
                    let done = (found.z - from) / rise;
                    assert!(done > 0.0 && done < 1.0, "{done}");
                }
            }
        }
        assert!(count <= 303, "{count} evaluations");
    }

    /// There the radius rises as the square root of the height.
    #[test]
    fn the_summit_of_a_contact_radius_next_to_break_away_is_found_to_all_digits() {
        let mut count = 0;
        for population in [unequal(0.6, 1.5), unequal(-0.3, 0.8)] {
            let edges = population.edges.at_separation(&population.maugis, &population.radius, 0.3);
            let here = population.edge_point(edges.iter().next().expect("an edge"));
            assert!(here.contact.radius < 1e-9, "{}", here.contact.radius);
            let there = population.point(&here, 0.2, 0.3);
            for part in [1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5] {
                let radius = part * there.contact.radius;
                EVALUATIONS.set(0);
                let found = population.point_of_radius(&here, &there, radius).contact.radius;
                count += EVALUATIONS.get();
                assert!((found / radius - 1.0).abs() < 1e-10, "{found}, not {radius}");
            }
        }
        assert!(count <= 667, "{count} evaluations");
    }

    #[test]
    fn a_contact_radius_turns_between_two_extrema() {
        // The cubic a t + b t^2 + c t^3 over another length, upwards and downwards.
        for (a, b, c, turn) in [
            (1.0, -4.5, 3.0, Some(0.5)),
            (1.0, -5.5, 4.0, Some(5.5 / 12.0)),
            (-1.0, 5.5, -4.0, Some(5.5 / 12.0)),
            (1.0, -12.0, 30.0, Some(2.0 / 15.0)),
            (1.0, -1.132, 0.424, Some(1.132 / 1.272)),
            // Next to an end; no extremum; one; two before the start.
            (1.0, -12.0, 45.0, None),
            (1.0, -1.0545, 0.37, None),
            (1.0, -2.0, 2.0, None),
            (1.0, -2.0, 0.5, None),
            (1.0, 4.5, 3.0, None),
        ] {
            for length in [1.0, 0.2, -3.0] {
                let at = |t: f64| (t * (a + t * (b + t * c)), (a + t * (2.0 * b + t * 3.0 * c)) / length);
                let [(start, start_slope), (end, end_slope)] = [at(0.0), at(1.0)];
                let (here, there) = (summit(0.3, 5.0 + start, start_slope), summit(0.3 + length, 5.0 + end, end_slope));
                match (between_extrema(&here, &there), turn) {
                    (Some(found), Some(turn)) => assert!((found - turn).abs() < 1e-12, "{found}, not {turn}"),
                    (found, turn) => assert_eq!(found, turn, "of {a} t + {b} t^2 + {c} t^3 over {length}"),
                }
            }
        }
    }

    #[test]
    fn a_rise_ends_inside_a_range_beyond_rounding() {
        for (part, inside) in [(1e-10, false), (2e-9, true), (0.5, true), (1.0 - 2e-9, true), (1.0 - 1e-10, false)] {
            for whole in [1.0, -1.0, 20.0, 0.03] {
                assert_eq!(is_inside(part * whole, whole), inside, "{part} of {whole}");
            }
        }
        assert!(!is_inside(-0.5, 1.0) && !is_inside(1.5, 1.0));
    }

    /// Next to theta = pi/2, where rounding keeps radii from those of the slip law.
    #[test]
    fn where_a_panel_was_cut_it_is_not_cut_again() {
        for part in 0..20 {
            let mut params = Params::default();
            params.slip.radius_1 = 1e-5 * (1.0 + 0.1 * f64::from(part));
            let population = of(&params);
            let edges = population.edges.at_separation(&population.maugis, &population.radius, 0.3);
            let here = population.edge_point(edges.iter().next().expect("an edge"));
            let there = population.point(&here, 0.2, 0.3);
            let cut = population.first_cut::<Few>(&here, &there).expect("a cut");
            EVALUATIONS.set(0);
            assert!(population.first_cut::<Few>(&cut, &there).is_none());
            assert_eq!(EVALUATIONS.get(), 0, "{}", params.slip.radius_1);
        }
    }
}
