//! Exact states in place of the curve, where the law has too many kinks for that.
//!
//! Going from load to load the separation of the next state is extrapolated, which leaves one evaluation for each. A state
//! serves all quantities, of which one is filled after the other at much the same loads.

use super::curve::Curve;
use super::fill::Source;
use super::panel::PerQuantity;
use super::Quantity;
use crate::elementary::exp;
use crate::equilibrium::{Branch, BranchPoint};
use std::collections::BTreeMap;

/// A state this near to where it is wanted, in ln(load - pull-off), is carried there by its slope.
const NEAR: f64 = 1e-9;
/// So many evaluations find a state, or it is not found: Newton's method, from a guess of a few digits.
const MOST_STEPS: usize = 8;
/// How far from a state another is evaluated, in sigma, where there is none to extrapolate from.
const BESIDE: f64 = 1e-3;
/// No more evaluations are spent on a law: of the largest tables they take a second. What is then not filled is evaluated
/// when it is asked for.
const MOST_EVALUATIONS: usize = 15_000;

/// An exact state: ln x, separation, d(ln x)/d(separation), the quantities, and the slopes of their logarithms by ln x.
#[derive(Debug, Clone, Copy)]
struct State {
    log_excess: f64,
    separation: f64,
    rate: f64,
    value: PerQuantity,
    slope: PerQuantity,
}

/// The law by exact states.
pub struct ExactStates<'a> {
    branch: &'a Branch,
    curve: &'a Curve,
    kinks: Vec<f64>,
    last: Option<[State; 2]>,
    /// What was found at each ln x, by its bits.
    known: BTreeMap<u64, Option<State>>,
    evaluations: usize,
}

impl<'a> ExactStates<'a> {
    pub fn new(branch: &'a Branch, curve: &'a Curve) -> Self {
        Self { branch, curve, kinks: branch.population().kinks(), last: None, known: BTreeMap::new(), evaluations: 0 }
    }

    fn evaluate(&mut self, separation: f64) -> Option<State> {
        self.evaluations += 1;
        if self.evaluations > MOST_EVALUATIONS {
            return None;
        }
        let BranchPoint { log_excess, rate, sums } = self.branch.log_excess(separation);
        let sums = Quantity::ALL.map(|quantity| quantity.of(&sums));
        let (value, slope) = (sums.map(|(value, _)| value), sums.map(|(value, slope)| slope / value / rate));
        (rate < 0.0 && value[0] > 0.0).then_some(State { log_excess, separation, rate, value, slope })
    }

    /// The state at ln x.
    fn state(&mut self, log_excess: f64) -> Option<State> {
        let mut state = self.evaluate(self.predicted(log_excess)?)?;
        for _ in 0..MOST_STEPS {
            let missing = log_excess - state.log_excess;
            if missing.abs() <= NEAR {
                let carried = State {
                    log_excess,
                    separation: state.separation + missing / state.rate,
                    value: std::array::from_fn(|i| state.value[i] * exp(state.slope[i] * missing)),
                    ..state
                };
                let before = match self.last {
                    Some([_, last]) if last.log_excess != log_excess => Some(last),
                    _ => self.evaluate(carried.separation - BESIDE),
                };
                self.last = before.map(|before| [before, carried]);
                return Some(carried);
            }
            state = self.evaluate(state.separation + missing / state.rate)?;
        }
        None
    }

    /// The same, found once.
    fn known(&mut self, log_excess: f64) -> Option<State> {
        if let Some(known) = self.known.get(&log_excess.to_bits()) {
            return *known;
        }
        let found = self.state(log_excess);
        if found.is_none() {
            self.last = None;
        }
        self.known.insert(log_excess.to_bits(), found);
        found
    }

    /// Where the state at ln x is expected, from the last two or the curve.
    fn predicted(&self, log_excess: f64) -> Option<f64> {
        let Some([a, b]) = self.last.filter(|[_, b]| (b.log_excess - log_excess).abs() < 0.25) else {
            return self.curve.separation(log_excess);
        };
        // The cubic with the values and slopes of both.
        let (width, t) = (b.log_excess - a.log_excess, (log_excess - a.log_excess) / (b.log_excess - a.log_excess));
        let (rise, start, end) = (b.separation - a.separation, width / a.rate, width / b.rate);
        Some(a.separation + t * (start + t * (3.0 * rise - 2.0 * start - end + t * (start + end - 2.0 * rise))))
    }
}

impl Source for ExactStates<'_> {
    // The next is extrapolated from the last.
    const IN_ANY_ORDER: bool = false;

    fn at<const N: usize>(&mut self, quantity: Quantity, log_excess: [f64; N]) -> [(f64, f64); N] {
        let i = quantity as usize;
        log_excess.map(|log_excess| match self.known(log_excess) {
            Some(state) => (state.value[i], state.slope[i]),
            None => (f64::NAN, f64::NAN),
        })
    }

    fn joints(&mut self, lower: f64, upper: f64) -> Vec<f64> {
        let [Some(near), Some(far)] = [upper, lower].map(|log_excess| self.curve.separation(log_excess)) else {
            return Vec::new();
        };
        let within: Vec<f64> = self.kinks.iter().copied().filter(|&kink| kink > near && kink < far).collect();
        let joints = within.into_iter().rev().filter_map(|kink| Some(self.evaluate(kink)?.log_excess));
        joints.filter(|&joint| joint > lower && joint < upper).collect()
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
            let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
            let loads: [f64; 40] = std::array::from_fn(|i| 9.0 + 0.07 * i as f64);
            let mut states = ExactStates::new(&branch, &curve);
            for quantity in Quantity::ALL {
                let (expected, found) = (curve.at_each(quantity, loads), states.at(quantity, loads));
                for ((found, expected), load) in found.into_iter().zip(expected).zip(loads) {
                    assert!((found.0 / expected.0 - 1.0).abs() < 1e-10, "{load}: {found:?}, not {expected:?}");
                    assert!((found.1 / expected.1 - 1.0).abs() < 1e-8, "{load}: {found:?}, not {expected:?}");
                }
            }
            // Beyond the curve nothing is known.
            let beyond = states.at(Quantity::Friction, [curve.log_range().1 + 3.0]);
            assert!(beyond[0].0.is_nan());
        }
    }
}
