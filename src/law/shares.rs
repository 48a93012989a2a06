//! The shares of the Jenkins elements that follow the contacts of a surface as they begin to slip, against load.
//!
//! At constant load the contacts resist a displacement x, over strength by stiffness, with the part Phi(x) of their strength. Phi
//! rises from 0 with slope 1 ever more slowly to 1, and so does a polygon through it, whose corners are the sliders of the
//! elements and whose changes of slope are their shares. Phi hardly changes with load: polygons at a few loads are blended.

use super::table::MANTISSA_BITS;
use super::{Curve, Table};
use crate::elementary::log;
use crate::equilibrium::Branch;
use crate::jenkins::{PerElement, ELEMENTS, KNOTS};

/// So many binades lie between loads at which there are polygons, as a power of two...
const LOG_STRIDE: u32 = 1;
/// ...and so many such steps between those at which Phi is asked for in any case.
const LONGEST: usize = 8;
/// In between it is asked for where it differs by more than this from the mean of its neighbours.
const TOLERANCE: f64 = 2e-3;

/// Shares at loads that are powers of two above pull-off.
#[derive(Debug, Clone)]
pub struct Shares {
    /// The biased exponent of the first.
    first: u64,
    rows: Vec<PerElement>,
}

impl Shares {
    /// The shares over the range of a table.
    pub fn new(branch: &Branch, curve: &Curve, table: &Table, load: f64) -> Self {
        let exponent = |x: f64| x.to_bits() >> MANTISSA_BITS;
        let (first, last) = (exponent(table.begin_of(0)), exponent(table.begin_of(table.row_count)));
        let steps = ((last - first) >> LOG_STRIDE) as usize + 1;
        let at = |row: usize| {
            let exponent = (first + ((row as u64) << LOG_STRIDE)).min(last - 1);
            resisted_at(branch, curve, log(of_exponent(exponent)) - log(load))
        };
        let mut rows = vec![[0.0; ELEMENTS]; steps.div_ceil(LONGEST) * LONGEST + 1];
        // What is not known is taken from the next lighter load; most likely the lightest is the one that is not.
        rows[0] = at(0).or_else(|| at(LONGEST)).unwrap_or_else(equal_contacts);
        for from in (0..steps).step_by(LONGEST) {
            rows[from + LONGEST] = at(from + LONGEST).unwrap_or(rows[from]);
            fill_between(&mut rows, (from, from + LONGEST), &at);
        }
        rows.iter_mut().for_each(|row| *row = polygon(*row));
        Self { first, rows }
    }

    /// The shares at load - pull-off and, with `SLOPES`, their slopes, where they are to be.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn at_excess<const SLOPES: bool>(&self, x: f64, shares: &mut PerElement, slopes: &mut PerElement) {
        let end = self.rows.len() - 1;
        if x < of_exponent(self.first) {
            (*shares, *slopes) = (self.rows[0], [0.0; ELEMENTS]);
            return;
        }
        let binades = (x.to_bits() >> MANTISSA_BITS) - self.first;
        let row = (binades >> LOG_STRIDE) as usize;
        if row >= end {
            (*shares, *slopes) = (self.rows[end], [0.0; ELEMENTS]);
            return;
        }
        let unit = of_exponent(self.first + binades);
        // Close to log2(x), with a slope that does not jump where binades meet.
        let t = x / unit - 1.0;
        const STRIDE: u64 = 1 << LOG_STRIDE;
        const PER_BINADE: f64 = 1.0 / STRIDE as f64;
        let place = ((binades % STRIDE) as f64 + t * (4.0 - t) / 3.0) * PER_BINADE;
        let place_slope = (4.0 - 2.0 * t) * (PER_BINADE / 3.0) / unit;
        let (part, part_slope) = (place * place * (3.0 - 2.0 * place), 6.0 * place * (1.0 - place) * place_slope);
        let (before, after) = (&self.rows[row], &self.rows[row + 1]);
        for j in 0..ELEMENTS {
            let change = after[j] - before[j];
            shares[j] = before[j] + part * change;
            if SLOPES {
                slopes[j] = part_slope * change;
            }
        }
    }
}

/// 2^e of a biased exponent.
#[inline]
fn of_exponent(exponent: u64) -> f64 {
    f64::from_bits(exponent << MANTISSA_BITS)
}

/// Fills the rows between two that are known: with their means, but where Phi is found to be another.
fn fill_between(rows: &mut [PerElement], (from, to): (usize, usize), at: &dyn Fn(usize) -> Option<PerElement>) {
    if to - from < 2 {
        return;
    }
    let middle = (from + to) / 2;
    let mean: PerElement = std::array::from_fn(|j| 0.5 * (rows[from][j] + rows[to][j]));
    rows[middle] = at(middle).unwrap_or(mean);
    if rows[middle].iter().zip(mean).all(|(found, mean)| (found - mean).abs() < TOLERANCE) {
        let known = |_: usize| None;
        fill_between(rows, (from, middle), &known);
        fill_between(rows, (middle, to), &known);
    } else {
        fill_between(rows, (from, middle), at);
        fill_between(rows, (middle, to), at);
    }
}

/// Phi at the knots, at ln(load - pull-off); `None` where the state is not known.
fn resisted_at(branch: &Branch, curve: &Curve, log_excess: f64) -> Option<PerElement> {
    let population = branch.population();
    let separation = curve.separation(log_excess)?;
    let sums = population.at_separation(separation);
    let length = sums.friction / sums.radius;
    let curve = population.shares_of_strength(separation, KNOTS.map(|knot| knot * length))?;
    curve.iter().all(|value| (0.0..=1.0 + 1e-6).contains(value)).then_some(curve)
}

/// Phi of contacts of one size, each of which slips from its rim inwards.
fn equal_contacts() -> PerElement {
    KNOTS.map(|knot| {
        let left = (1.0 - knot / 1.5).max(0.0);
        1.0 - left * left.sqrt()
    })
}

/// The shares that are the changes of slope of the polygon through 0, with slope 1 up to the first knot, and the upper hull of
/// these values at the others, of which the last is taken as 1. Between two knots a polygon runs below the curve: it is lifted by
/// half of that, as a parabola through three values tells it.
fn polygon(curve: PerElement) -> PerElement {
    const LAST: usize = ELEMENTS - 1;
    let rate = |a: usize, b: usize| (curve[b] - curve[a]) / (KNOTS[b] - KNOTS[a]);
    let heights: PerElement = std::array::from_fn(|j| match j {
        0 => KNOTS[0],
        LAST => 1.0,
        _ => {
            let bend = rate(j - 1, j) - rate(j, j + 1);
            let lifted = curve[j] + bend * (KNOTS[j + 1] - KNOTS[j - 1]) / 32.0;
            lifted.min(1.0).min(KNOTS[j])
        }
    });
    // The corners of the hull.
    let mut corners = [0; ELEMENTS];
    let mut count = 1;
    let slope = |a: usize, b: usize| (heights[b] - heights[a]) / (KNOTS[b] - KNOTS[a]);
    for j in 1..ELEMENTS {
        while count > 1 && slope(corners[count - 1], j) >= slope(corners[count - 2], corners[count - 1]) {
            count -= 1;
        }
        corners[count] = j;
        count += 1;
    }
    let mut shares = [0.0; ELEMENTS];
    let mut before = 1.0;
    for pair in corners[..count].windows(2) {
        let after = slope(pair[0], pair[1]).clamp(0.0, before);
        shares[pair[0]] = before - after;
        before = after;
    }
    shares[LAST] = before;
    normalised(shares)
}

/// Shares of which all of the stiffness, and times the knots all of the strength, are 1 to rounding.
fn normalised(mut shares: PerElement) -> PerElement {
    // Two of them make good what rounding and hull have left: those at the first and at the last knot.
    const LAST: usize = ELEMENTS - 1;
    for _ in 0..2 {
        let stiffness = 1.0 - shares.iter().sum::<f64>();
        let strength = 1.0 - shares.iter().zip(KNOTS).map(|(share, knot)| share * knot).sum::<f64>();
        let last = (strength - KNOTS[0] * stiffness) / (KNOTS[LAST] - KNOTS[0]);
        shares[LAST] = (shares[LAST] + last).max(0.0);
        shares[0] = (shares[0] + stiffness - last).max(0.0);
    }
    shares
}

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::super::{Law, Lengths};
    use super::*;

    fn force(shares: &PerElement, x: f64) -> f64 {
        shares.iter().zip(KNOTS).map(|(share, knot)| share * x.min(knot)).sum()
    }

    #[test]
    fn shares_are_those_of_a_polygon_through_the_curve() {
        type Named = (&'static str, fn(f64) -> f64);
        let curves: [Named; 4] = [
            ("exponential", |x| 1.0 - (-x).exp()),
            ("one size, in part", |x| 1.0 - (1.0 - x / 1.5).max(0.0).powf(1.5)),
            ("one size, as a whole", |x| x.min(1.0)),
            ("none", |_| 0.0),
        ];
        for (name, curve) in curves {
            let shares = polygon(KNOTS.map(curve));
            assert!(shares.iter().all(|&share| share >= 0.0), "{name}: {shares:?}");
            assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{name}: {shares:?}");
            assert!((force(&shares, 10.0) - 1.0).abs() < 1e-15, "{name}: {shares:?}");
            // The last knot lies where hardly any strength is left.
            for i in (0..160).filter(|_| name != "none") {
                let x = 0.03 * f64::from(i);
                assert!((force(&shares, x) - curve(x)).abs() < 0.017, "{name} at {x}: {}", force(&shares, x));
            }
        }
    }

    /// Values that rise evenly up to a row and not beyond it.
    #[test]
    fn rows_between_two_that_are_known_are_asked_for_where_their_mean_is_not_good() {
        for (bend, asked_for) in [(8, vec![4]), (2, vec![1, 2, 3, 4, 6])] {
            let value = |row: usize| [0.05 * row.min(bend) as f64; ELEMENTS];
            let mut rows = vec![[f64::NAN; ELEMENTS]; 9];
            (rows[0], rows[8]) = (value(0), value(8));
            let asked = std::cell::RefCell::new(Vec::new());
            let at = |row: usize| {
                asked.borrow_mut().push(row);
                Some(value(row))
            };
            fill_between(&mut rows, (0, 8), &at);
            let mut asked = asked.into_inner();
            asked.sort_unstable();
            assert_eq!(asked, asked_for);
            for (row, found) in rows.iter().enumerate() {
                assert!((found[0] - value(row)[0]).abs() < 1e-15, "{row}: {found:?}");
            }
        }
        // What is not known is the mean.
        let mut rows = vec![[0.0; ELEMENTS], [f64::NAN; ELEMENTS], [1.0; ELEMENTS]];
        fill_between(&mut rows, (0, 2), &|_| None);
        assert_eq!(rows[1], [0.5; ELEMENTS]);
    }

    /// Where summits pass from one regime of the slip law to the next the part of their strength changes with load.
    #[test]
    fn rows_are_those_of_loads_that_are_powers_of_two() {
        use crate::population::tests::{of, surface, WEAK};
        let mut params = surface(WEAK, crate::params::HeightFamily::Gaussian, [0.0, 1.0]);
        (params.slip.radius_1, params.slip.radius_2, params.slip.stress_2) = (20.0, 40.0, 0.006);
        let branch = Branch::new(of(&params)).expect("a branch");
        let law = Law::new(&branch, 1.0, [1.0; 2], Lengths { unit: 1.0, origin: 0.0 }).expect("a law");
        let Shares { first, rows } = &law.shares;
        let mut differences = Vec::new();
        for (row, shares) in rows.iter().enumerate().filter(|(row, _)| row % LONGEST == 0).skip(1) {
            let binade = i32::try_from(first + 2 * row as u64).expect("an exponent") - 1023;
            let log_excess = f64::from(binade) * std::f64::consts::LN_2;
            let Ok((separation, sums)) = branch.at_log_excess(log_excess, None) else { continue };
            let length = sums.friction / sums.radius;
            let resisted = branch.population().shares_of_strength(separation, KNOTS.map(|knot| knot * length));
            let expected = polygon(resisted.expect("contacts"));
            let off = shares.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-6, "{row}, at 2^{binade}: {shares:?}, not {expected:?}");
            differences.push((shares[12] - rows[0][12]).abs());
        }
        assert!(differences.len() > 3 && differences.iter().any(|&by| by > 1e-3), "{differences:?}");
    }

    #[test]
    fn contacts_of_one_size_slip_from_their_rims() {
        let resisted = equal_contacts();
        for (knot, resisted) in KNOTS.into_iter().zip(resisted) {
            let expected = if knot < 1.5 { 1.0 - (1.0 - knot / 1.5).powf(1.5) } else { 1.0 };
            assert!((resisted - expected).abs() < 1e-15, "{knot}: {resisted}");
        }
    }

    /// Of a compiled law, at all loads, on what its contacts resist.
    #[test]
    fn elements_resist_what_the_contacts_of_their_load_do() {
        let branch = branch(0.001);
        let law = Law::new(&branch, 1.0, [1.0; 2], Lengths { unit: 1.0, origin: 0.0 }).expect("a law");
        for log_excess in [-20.0_f64, -8.3, -3.1, 0.2, 4.9, 9.0] {
            let (separation, sums) = branch.at_log_excess(log_excess, None).expect("a state");
            let (mut shares, mut slopes) = ([0.0; ELEMENTS], [0.0; ELEMENTS]);
            law.shares.at_excess::<true>(log_excess.exp(), &mut shares, &mut slopes);
            for x in [0.1, 0.5, 1.0, 2.0, 4.0] {
                let ratio = x * sums.friction / sums.radius;
                let slipping = branch.population().microslip(separation, ratio).expect("a force");
                let error = force(&shares, x) - slipping.force / sums.friction;
                assert!(error.abs() < 0.02, "{x} at {log_excess}: {error}");
            }
        }
    }

    /// Whose corners lie above the curve by half of what it rises above its chords, and end at a share of 1.
    #[test]
    fn corners_are_lifted_by_half_of_what_a_chord_is_too_low() {
        const LAST: usize = ELEMENTS - 1;
        let curve = |x: f64| 1.0 - (-x).exp();
        let shares = polygon(KNOTS.map(curve));
        for j in 1..LAST {
            let [before, here, after] = [KNOTS[j - 1], KNOTS[j], KNOTS[j + 1]];
            // Of the parabola through three values.
            let second = 2.0
                * ((curve(after) - curve(here)) / (after - here) - (curve(here) - curve(before)) / (here - before))
                / (after - before);
            let width = 0.5 * (after - before);
            let too_low = -second * width * width / 8.0;
            let lifted = (curve(here) + 0.5 * too_low).min(here);
            let error = force(&shares, here) - lifted;
            // The first and the last share make good what rounding leaves.
            assert!(error.abs() < 2e-3 * (1.0 + f64::from(u8::from(j + 1 == LAST)) * 10.0), "{here}: {error:e}");
        }
        assert!((force(&shares, KNOTS[0]) - KNOTS[0]).abs() < 1e-12);
    }

    #[test]
    fn shares_and_their_slopes_do_not_jump() {
        let rows = (0..4).map(|i| polygon(KNOTS.map(|x| 1.0 - (-x * (1.0 + 0.1 * f64::from(i))).exp()))).collect();
        let shares = Shares { first: 1000, rows };
        let at = |x: f64| {
            let (mut found, mut slopes) = ([0.0; ELEMENTS], [0.0; ELEMENTS]);
            shares.at_excess::<true>(x, &mut found, &mut slopes);
            (found, slopes)
        };
        let first = of_exponent(1000);
        for i in 0..300 {
            let x = first * 0.8 * 1.025_f64.powi(i);
            let (found, slopes) = at(x);
            let ((less, _), (more, _)) = (at(x * (1.0 - 1e-5)), at(x * (1.0 + 1e-5)));
            for j in 0..ELEMENTS {
                let slope = (more[j] - less[j]) / (2e-5 * x);
                assert!((slope - slopes[j]).abs() * x < 3e-6, "{i}, {j}: {slope:e}, {:e}", slopes[j]);
            }
            assert!((found.iter().sum::<f64>() - 1.0).abs() < 1e-14);
        }
        // Where binades and rows meet.
        for binade in 0..7 {
            let x = of_exponent(1000 + binade);
            let ((less, _), (more, _)) = (at(x * (1.0 - 1e-12)), at(x));
            for j in 0..ELEMENTS {
                assert!((more[j] - less[j]).abs() < 1e-11, "{binade}, {j}: {} to {}", less[j], more[j]);
            }
        }
        assert_eq!(at(0.0).0, shares.rows[0]);
        assert_eq!(at(f64::MAX).0, shares.rows[3]);
    }
}
