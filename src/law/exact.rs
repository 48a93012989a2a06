//! Exact states in place of the curve, where the law has too many kinks for that.
//!
//! Going from load to load the separation of the next state is extrapolated, which leaves one evaluation for each.

use super::curve::Curve;
use super::fill::Source;
use crate::elementary::exp;
use crate::equilibrium::{Branch, BranchPoint};

/// A state this near to where it is wanted, in ln(load - pull-off), is carried there by its slope, which changes as it does
/// from the last state, if that is not too near to tell...
const NEAR: f64 = 1e-7;
const APART: f64 = 1e-4;
/// ...or else does not change.
const NEAREST: f64 = 1e-9;
/// So many evaluations find a state, or it is not found: Newton's method, from a guess of a few digits.
const MOST_STEPS: usize = 8;
/// The next separation is extrapolated from this many states, no farther than this in ln x and this many times as far as
/// they are apart.
const KNOWN: usize = 3;
const FARTHEST: f64 = 0.25;
const FARTHEST_RATIO: f64 = 3.0;

/// An exact state: ln x, separation, d(ln x)/d(separation), F, d(ln F)/d(ln x).
#[derive(Debug, Clone, Copy)]
struct State {
    log_excess: f64,
    separation: f64,
    rate: f64,
    force: f64,
    slope: f64,
}

/// The law by exact states.
pub struct ExactStates<'a> {
    branch: &'a Branch,
    curve: &'a Curve,
    /// The last states, newest first.
    last: Vec<State>,
}

impl<'a> ExactStates<'a> {
    pub fn new(branch: &'a Branch, curve: &'a Curve) -> Self {
        Self { branch, curve, last: Vec::new() }
    }

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

    /// The state at ln x.
    fn state(&mut self, log_excess: f64) -> Option<State> {
        let mut state = self.evaluate(self.predicted(log_excess)?)?;
        for _ in 0..MOST_STEPS {
            let missing = log_excess - state.log_excess;
            let bend = self.last.first().and_then(|last| {
                let distance = state.log_excess - last.log_excess;
                (distance.abs() > APART && distance.abs() < FARTHEST).then(|| (state.slope - last.slope) / distance)
            });
            if missing.abs() <= if bend.is_some() { NEAR } else { NEAREST } {
                let carried = State {
                    log_excess,
                    separation: state.separation + missing / state.rate,
                    force: state.force * exp(state.slope * missing),
                    slope: state.slope + bend.unwrap_or(0.0) * missing,
                    ..state
                };
                if self.last.iter().all(|last| last.log_excess != log_excess) {
                    self.last.insert(0, carried);
                    self.last.truncate(KNOWN);
                }
                return Some(carried);
            }
            state = self.evaluate(state.separation + missing / state.rate)?;
        }
        None
    }

    /// Where the state at ln x is expected, from the last ones or the curve.
    fn predicted(&self, log_excess: f64) -> Option<f64> {
        let near: Vec<&State> = self.last.iter().filter(|last| (last.log_excess - log_excess).abs() < FARTHEST).collect();
        let [newest, others @ ..] = &near[..] else { return self.curve.separation(log_excess) };
        let distance = log_excess - newest.log_excess;
        let spread = others.iter().map(|other| (other.log_excess - newest.log_excess).abs()).fold(0.0, f64::max);
        let known = if distance.abs() <= FARTHEST_RATIO * spread { &near[..] } else { &near[..1] };
        // The polynomial with their values and slopes, each taken twice, in Newton's form.
        let mut rises: Vec<f64> = known.iter().flat_map(|state| [state.separation; 2]).collect();
        let at = |i: usize| known[i / 2].log_excess;
        for order in 1..rises.len() {
            for i in (order..rises.len()).rev() {
                rises[i] = if order == 1 && i % 2 == 1 {
                    1.0 / known[i / 2].rate
                } else {
                    (rises[i] - rises[i - 1]) / (at(i) - at(i - order))
                };
            }
        }
        Some((0..rises.len()).rev().fold(0.0, |sum, i| sum * (log_excess - at(i)) + rises[i]))
    }
}

impl Source for ExactStates<'_> {
    fn at<const N: usize>(&mut self, log_excess: [f64; N]) -> [(f64, f64); N] {
        // From load to load.
        let mut order: [usize; N] = std::array::from_fn(|i| i);
        order.sort_by(|&a, &b| log_excess[a].total_cmp(&log_excess[b]));
        let mut found = [(f64::NAN, f64::NAN); N];
        for i in order {
            match self.state(log_excess[i]) {
                Some(state) => found[i] = (state.force, state.slope),
                None => self.last.clear(),
            }
        }
        found
    }

    fn joints(&self, _lower: f64, _upper: f64) -> Vec<f64> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::*;

    #[test]
    fn exact_states_are_those_of_the_curve_where_the_law_is_smooth() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let mut curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
            let loads: [f64; 40] = std::array::from_fn(|i| 9.0 + 0.07 * i as f64);
            let expected = curve.at(loads);
            let found = ExactStates::new(&branch, &curve).at(loads);
            for ((found, expected), load) in found.into_iter().zip(expected).zip(loads) {
                assert!((found.0 / expected.0 - 1.0).abs() < 1e-10, "{load}: {found:?}, not {expected:?}");
                assert!((found.1 / expected.1 - 1.0).abs() < 1e-8, "{load}: {found:?}, not {expected:?}");
            }
            // Beyond the curve nothing is known.
            let beyond = ExactStates::new(&branch, &curve).at([curve.log_range().1 + 3.0]);
            assert!(beyond[0].0.is_nan());
        }
    }
}
