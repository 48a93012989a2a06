//! Exact states in place of the curve, where the law has too many kinks for that.
//!
//! Going from load to load the separation of the next state is extrapolated, which leaves one evaluation for each.

use super::curve::Curve;
use super::fill::Source;
use super::Quantity;
use crate::elementary::exp;
use crate::equilibrium::{Branch, BranchPoint};

/// A state this near to where it is wanted, in ln(load - pull-off), is carried there by its slope.
const NEAR: f64 = 1e-9;
/// So many evaluations find a state, or it is not found: Newton's method, from a guess of a few digits.
const MOST_STEPS: usize = 8;
/// How far from a state another is evaluated, in sigma, where there is none to extrapolate from.
const BESIDE: f64 = 1e-3;

/// An exact state: ln x, separation, d(ln x)/d(separation), a quantity, and the slope of its logarithm by ln x.
#[derive(Debug, Clone, Copy)]
struct State {
    log_excess: f64,
    separation: f64,
    rate: f64,
    value: f64,
    slope: f64,
}

/// One quantity of the law by exact states.
pub struct ExactStates<'a> {
    branch: &'a Branch,
    curve: &'a Curve,
    quantity: Quantity,
    last: Option<[State; 2]>,
}

impl<'a> ExactStates<'a> {
    pub fn new(branch: &'a Branch, curve: &'a Curve, quantity: Quantity) -> Self {
        Self { branch, curve, quantity, last: None }
    }

    fn evaluate(&self, separation: f64) -> Option<State> {
        let BranchPoint { log_excess, rate, sums } = self.branch.log_excess(separation);
        let (value, slope) = self.quantity.of(&sums);
        (rate < 0.0 && value > 0.0).then(|| State { log_excess, separation, rate, value, slope: slope / value / rate })
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
                    value: state.value * exp(state.slope * missing),
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
    fn at<const N: usize>(&mut self, log_excess: [f64; N]) -> [(f64, f64); N] {
        log_excess.map(|log_excess| match self.state(log_excess) {
            Some(state) => (state.value, state.slope),
            None => {
                self.last = None;
                (f64::NAN, f64::NAN)
            }
        })
    }

    fn joints(&self, _lower: f64, _upper: f64) -> Vec<f64> {
        Vec::new()
    }
}

#[cfg(test)]
mod tests {
    use super::super::curve::Along;
    use super::super::tests::branch;
    use super::*;

    #[test]
    fn exact_states_are_those_of_the_curve_where_the_law_is_smooth() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
            let loads: [f64; 40] = std::array::from_fn(|i| 9.0 + 0.07 * i as f64);
            for quantity in Quantity::ALL {
                let expected = Along(&curve, quantity).at(loads);
                let found = ExactStates::new(&branch, &curve, quantity).at(loads);
                for ((found, expected), load) in found.into_iter().zip(expected).zip(loads) {
                    assert!((found.0 / expected.0 - 1.0).abs() < 1e-10, "{load}: {found:?}, not {expected:?}");
                    assert!((found.1 / expected.1 - 1.0).abs() < 1e-8, "{load}: {found:?}, not {expected:?}");
                }
            }
            // Beyond the curve nothing is known.
            let beyond = ExactStates::new(&branch, &curve, Quantity::Friction).at([curve.log_range().1 + 3.0]);
            assert!(beyond[0].0.is_nan());
        }
    }
}
