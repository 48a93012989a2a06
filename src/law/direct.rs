//! Rows filled from exact states, where the law has too many kinks for a curve: those that no kink disturbs.
//!
//! A row is the polynomial with the values and slopes of four states, two of them at its ends. Going from row to row the
//! separation of the next state is extrapolated, which leaves one evaluation for each.

use super::row::{error_within_tolerance, polynomial, Filling, Row, COEFFICIENTS};
use super::MANTISSA_BITS;
use crate::elementary::{exp, log, log1p};
use crate::equilibrium::{Branch, BranchPoint};
use std::f64::consts::LN_2;

/// Where a row takes its states from, and where it is compared with one.
const PARTS: [f64; 5] = [0.0, 0.276_393_2, 0.5, 0.723_606_8, 1.0];
const COMPARED: usize = 2;
/// A state this near to where it is wanted, in ln(load - pull-off), is carried there by its slope.
const NEAR: f64 = 1e-9;

/// An exact state: ln x, separation, d(ln x)/d(separation), F, d(ln F)/d(ln x).
#[derive(Debug, Clone, Copy)]
struct State {
    log_excess: f64,
    separation: f64,
    rate: f64,
    force: f64,
    slope: f64,
}

struct Follower<'a> {
    branch: &'a Branch,
    last: Option<[State; 2]>,
}

impl Follower<'_> {
    fn evaluate(&self, separation: f64) -> Option<State> {
        let BranchPoint { log_excess, rate, sums } = self.branch.log_excess(separation);
        (rate < 0.0 && sums.friction > 0.0).then(|| State {
            log_excess,
            separation,
            rate,
            force: sums.friction,
            slope: sums.friction_slope / sums.friction / rate,
        })
    }

    /// The state at ln x, from the last two or a guess.
    fn state(&mut self, log_excess: f64, guess: f64) -> Option<State> {
        let predicted = self.last.map_or(guess, |[a, b]| {
            // The cubic with the values and slopes of both.
            let (width, t) = (b.log_excess - a.log_excess, (log_excess - a.log_excess) / (b.log_excess - a.log_excess));
            let (rise, start, end) = (b.separation - a.separation, width / a.rate, width / b.rate);
            a.separation + t * (start + t * (3.0 * rise - 2.0 * start - end + t * (start + end - 2.0 * rise)))
        });
        let mut state = self.evaluate(predicted)?;
        for _ in 0..8 {
            let missing = log_excess - state.log_excess;
            if missing.abs() <= NEAR {
                let carried = State {
                    log_excess,
                    separation: state.separation + missing / state.rate,
                    force: state.force * exp(state.slope * missing),
                    ..state
                };
                self.last = Some([self.last.map_or(carried, |[_, last]| last), carried]);
                return Some(carried);
            }
            state = self.evaluate(state.separation + missing / state.rate)?;
        }
        None
    }
}

/// Fills the rows that are left out, of which the first has these shifted bits; the largest error of those it keeps.
pub fn fill(filling: &Filling, branch: &Branch, first: u64, rows: &mut [Row]) -> f64 {
    let width = (2.0_f64).powi(filling.shift as i32 - MANTISSA_BITS as i32);
    let per_binade = 1_u64 << (MANTISSA_BITS - filling.shift);
    let log_load = log(filling.scales.load);
    let mut follower = Follower { branch, last: None };
    // Where the row before ends.
    let mut joint: Option<State> = None;
    let mut worst = 0.0_f64;
    for (index, row) in (first..).zip(rows.iter_mut()) {
        if !row.is_left_out() {
            (follower.last, joint) = (None, None);
            continue;
        }
        let within = (index % per_binade) as f64;
        let binade = (index / per_binade) as f64 - 1023.0;
        let mut states = [None; PARTS.len()];
        for (state, part) in states.iter_mut().zip(PARTS) {
            let log_excess = log1p((within + part) * width) + (binade * LN_2 - log_load);
            *state = match joint.filter(|_| part == 0.0) {
                Some(joint) => Some(joint),
                None => match (follower.last, filling.curve.separation(log_excess)) {
                    (None, None) => None,
                    (_, guess) => follower.state(log_excess, guess.unwrap_or(0.0)),
                },
            };
            if let Some([_, only]) = follower.last.filter(|[a, b]| a.log_excess == b.log_excess) {
                // Two states are needed to extrapolate from.
                let beside = follower.evaluate(only.separation - 1e-3);
                follower.last = beside.map(|beside| [beside, only]);
            }
        }
        joint = states[PARTS.len() - 1];
        let [Some(a), Some(b), Some(c), Some(d), Some(e)] = states else {
            follower.last = None;
            continue;
        };
        let points = [a, b, c, d, e].map(|state| filling.scales.force * state.force);
        let slopes: [f64; 5] =
            std::array::from_fn(|i| points[i] * [a, b, c, d, e][i].slope * width / (1.0 + (within + PARTS[i]) * width));
        let coefficients = hermite(&points, &slopes);
        let found = polynomial(&coefficients, PARTS[COMPARED]);
        if let Some(error) = error_within_tolerance(found, (points[COMPARED], slopes[COMPARED])) {
            worst = worst.max(error);
            let mut scale = 1.0;
            *row = Row(coefficients.map(|coefficient| {
                let scaled = coefficient * scale;
                scale /= width;
                scaled
            }));
        }
    }
    worst
}

/// The polynomial with these values and slopes at all parts but the one that is compared.
fn hermite(values: &[f64; PARTS.len()], slopes: &[f64; PARTS.len()]) -> [f64; COEFFICIENTS] {
    const KEPT: [usize; 4] = [0, 1, 3, 4];
    let node = |i: usize| PARTS[KEPT[i / 2]];
    let mut differences: [f64; COEFFICIENTS] = std::array::from_fn(|i| values[KEPT[i / 2]]);
    for order in 1..COEFFICIENTS {
        for i in (order..COEFFICIENTS).rev() {
            differences[i] = if order == 1 && i % 2 == 1 {
                slopes[KEPT[i / 2]]
            } else {
                (differences[i] - differences[i - 1]) / (node(i) - node(i - order))
            };
        }
    }
    let mut coefficients = [0.0; COEFFICIENTS];
    for i in (0..COEFFICIENTS).rev() {
        for k in (0..COEFFICIENTS).rev() {
            let lower = if k > 0 { coefficients[k - 1] } else { 0.0 };
            coefficients[k] = lower - node(i) * coefficients[k];
        }
        coefficients[0] += differences[i];
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use super::super::curve::Curve;
    use super::super::tests::branch;
    use super::super::Scales;
    use super::*;

    #[test]
    fn a_polynomial_of_degree_7_has_the_coefficients_of_its_values_and_slopes() {
        const C: [f64; COEFFICIENTS] = [3.0, -2.0, 0.5, 1.25, -0.75, 2.5, -1.5, 0.375];
        let at = |t: f64| polynomial(&C, t);
        let found = hermite(&PARTS.map(|part| at(part).0), &PARTS.map(|part| at(part).1));
        for (found, expected) in found.into_iter().zip(C) {
            assert!((found - expected).abs() < 1e-11, "{found}, not {expected}");
        }
    }

    /// Where the law is smooth, rows from states are those from the curve; only what is left out is filled.
    #[test]
    fn rows_from_states_are_rows_of_the_curve() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
            let filling = Filling { curve: &curve, shift: MANTISSA_BITS - 6, scales: Scales { load: 3.0, force: 0.5 } };
            let first = f64::to_bits(0.95) >> filling.shift;
            let (expected, _) = filling.rows(first..=first + 23);
            let mut rows = expected.clone();
            for (i, row) in rows.iter_mut().enumerate() {
                if i % 8 > 2 {
                    row.leave_out();
                }
            }
            let error = fill(&filling, &branch, first, &mut rows);
            assert!(error > 1e-16 && error < 5e-11, "{error:e}");
            for (i, (row, expected)) in rows.iter().zip(&expected).enumerate() {
                if i % 8 <= 2 {
                    assert_eq!(row, expected, "row {i}");
                }
                for part in [0.0, 0.2, 0.5, 0.9, 1.0] {
                    let t = part / 64.0;
                    let ((force, slope), (a, b)) = (polynomial(&row.0, t), polynomial(&expected.0, t));
                    assert!((force / a - 1.0).abs() < 1e-10, "row {i} at {part}: {force}, not {a}");
                    assert!((slope / b - 1.0).abs() < 1e-8, "row {i} at {part}: slope {slope}, not {b}");
                }
            }
        }
    }

    #[test]
    fn a_state_next_to_the_one_asked_for_is_carried_there() {
        let branch = branch(0.001);
        let mut follower = Follower { branch: &branch, last: None };
        let beside = follower.evaluate(0.4).expect("a state");
        for missing in [0.9 * NEAR, -0.9 * NEAR] {
            let state = follower.state(beside.log_excess + missing, 0.4).expect("a state");
            let exact = follower.evaluate(beside.separation + missing / beside.rate).expect("a state");
            assert!((state.separation - exact.separation).abs() < 1e-15, "{state:?}, not {exact:?}");
            assert!((state.force / exact.force - 1.0).abs() < 1e-13, "{state:?}, not {exact:?}");
            follower.last = None;
        }
    }

    /// Where the branch ends nothing is filled.
    #[test]
    fn rows_beyond_the_branch_stay_left_out() {
        let branch = branch(0.001);
        let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
        let filling = Filling { curve: &curve, shift: MANTISSA_BITS - 4, scales: Scales { load: 1.0, force: 1.0 } };
        let first = f64::to_bits(10.0 * curve.log_range().1.exp()) >> filling.shift;
        let mut rows = [Row([f64::NAN; COEFFICIENTS]); 3];
        let beyond = Follower { branch: &branch, last: None };
        assert!(beyond.evaluate(branch.farthest() - 0.5).is_some());
        assert!(beyond.evaluate(branch.farthest() + 0.5).is_none(), "the load rises there");
        let error = fill(&filling, &branch, first, &mut rows);
        assert!(error == 0.0 && rows.iter().all(Row::is_left_out), "{error:e}, {rows:?}");
    }
}
