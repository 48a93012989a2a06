//! The compiled law: friction force as a function of load, in the caller's units, at the price of one polynomial.
//!
//! In x = load - pull-off the force has its only nearby singularity at x = 0. The table has a row for each fraction
//! of a binade of x, found from the bits of x without log or search; a row is a polynomial in the mantissa. Value and slope
//! agree where rows meet. A row that misses the exact curve is left out; its loads, like those outside the table, are
//! evaluated exactly.

mod curve;
mod direct;
mod reach;
mod row;

use crate::elementary::{exp, log};
use crate::equilibrium::Branch;
use curve::{Curve, Sample};
use row::Filling;

pub use curve::Unfollowed;
pub use row::{polynomial, Row, COEFFICIENTS};

/// Interpolation conditions per panel of the curve: value and slope at each of its exact states.
const CONDITIONS: usize = 20;
/// Rows of one table at most: 64 KiB.
const MOST_ROWS: usize = 1024;
/// Rows per binade, as powers of two: tried in turn.
const FRACTIONS: [u32; 3] = [2, 3, 4];
/// The same where the curve has more kinks than panels could avoid, and rows are filled from exact states.
const FRACTION_OF_KINKS: u32 = 6;
/// The table begins at this part of the pull-off load above it, at least.
const NEAREST_TO_PULL_OFF: f64 = 5e-10;
/// The range of ln(load - pull-off) that is compiled: what the rows can hold where that reaches down to the pull-off
/// load, or else what anyone may ask for.
const LOG_RANGE: f64 = MOST_ROWS as f64 / (1 << FRACTIONS[0]) as f64 * std::f64::consts::LN_2;
const LOG_RANGE_WITHOUT_PULL_OFF: f64 = 60.0;
/// The largest relative error of the force, and of its slope, of a row against an exact state.
const VALUE_TOLERANCE: f64 = 1e-10;
const SLOPE_TOLERANCE: f64 = 1e-8;

const MANTISSA_BITS: u32 = 52;

/// What an evaluation of the table needs.
///
/// With x = load - pull_off, the row is that of index (bits of x >> shift) - base, as unsigned integers; no such row means
/// that the table does not answer.
#[derive(Debug, Clone, Copy)]
pub struct Table<'a> {
    /// The rows.
    pub rows: &'a [Row],
    /// How far the bits of x are shifted right.
    pub shift: u32,
    /// The shifted bits of the first row.
    pub base: u64,
    /// The pull-off load.
    pub pull_off: f64,
}

impl Table<'_> {
    /// The mantissa's bits.
    pub const MANTISSA: u64 = (1 << 52) - 1;
    /// The bits of 1.0.
    pub const ONE: u64 = 1023 << 52;
    /// 2^-e has these bits less those of 2^e.
    pub const TWICE_BIAS: u64 = 2046 << 52;
}

/// The bits of the mantissa that say where within its row x lies.
#[inline]
pub fn within_row(shift: u32) -> u64 {
    !(u64::MAX << shift)
}

/// Friction force against load.
#[derive(Debug, Clone)]
pub struct Law {
    rows: Vec<Row>,
    /// Row index = (bits of x >> shift) - base.
    shift: u32,
    base: u64,
    pull_off: f64,
    error: f64,
    curve: Curve,
}

/// The caller's units of load and friction force.
#[derive(Debug, Clone, Copy)]
pub struct Scales {
    /// The load that is 1 in the dimensionless model.
    pub load: f64,
    /// The friction force that is.
    pub force: f64,
}

impl Law {
    /// Compiles the law.
    ///
    /// # Errors
    /// [`Unfollowed`] where the load rises with separation already: the branch ends before.
    pub fn new(branch: &Branch, scales: Scales) -> Result<Self, Unfollowed> {
        let mut samples = Vec::new();
        let nearest = log(-branch.pull_off_load() * NEAREST_TO_PULL_OFF);
        let log_range =
            |heaviest: f64| if heaviest - nearest <= LOG_RANGE { LOG_RANGE } else { LOG_RANGE_WITHOUT_PULL_OFF };
        let curve = Curve::new(branch, log_range, &mut samples)?;
        let log_load = log(scales.load);
        let (lower, upper) = curve.log_range();
        let lower = nearest.max(lower) + log_load;
        let upper = upper + log_load;
        let curve_is_resolved = curve.is_resolved();
        let mut law = Self {
            rows: Vec::new(),
            shift: 0,
            base: 0,
            pull_off: branch.pull_off_load() * scales.load,
            error: 0.0,
            curve,
        };
        let mut best = None;
        let fractions = if curve_is_resolved { &FRACTIONS[..] } else { &[FRACTION_OF_KINKS] };
        for &fraction in fractions {
            let shift = MANTISSA_BITS - fraction;
            let last = (exp(upper.min(700.0)).to_bits() >> shift) - 1;
            // What does not fit in the table is left to exact evaluation at the light end.
            let first = (exp(lower.max(-700.0)).to_bits() >> shift).max(last - MOST_ROWS as u64) + 1;
            let filling = Filling { curve: &law.curve, shift, scales };
            let (mut rows, mut error) = filling.rows(first..=last);
            if !curve_is_resolved {
                error = error.max(direct::fill(&filling, branch, first, &mut rows));
            }
            let missing = rows.iter().filter(|row| row.is_left_out()).count();
            let binades = (rows.len() - missing) as f64 / f64::from(1 << fraction);
            if best.is_none_or(|best| binades > best) {
                best = Some(binades);
                (law.rows, law.shift, law.base, law.error) = (rows, shift, first, error);
            }
            if missing == 0 {
                break;
            }
        }
        law.certify(&samples, scales);
        Ok(law)
    }

    /// Measures the table against the exact states that did not make it; leaves a row out that misses one.
    fn certify(&mut self, samples: &[Sample], scales: Scales) {
        for sample in samples {
            let x = exp(sample.log_excess + log(scales.load));
            let Some((index, force, slope)) = self.row_of(x).and_then(|index| {
                let (force, slope) = self.at_excess(x)?;
                Some((index, force, slope))
            }) else {
                continue;
            };
            let exact = scales.force * self.curve.force_of(sample);
            let error = (force / exact - 1.0).abs();
            let slope_error = (slope / (exact * sample.log_slope / x) - 1.0).abs();
            if error > VALUE_TOLERANCE || slope_error > SLOPE_TOLERANCE {
                self.rows[index].leave_out();
            } else {
                self.error = self.error.max(error);
            }
        }
    }

    #[inline]
    fn row_of(&self, x: f64) -> Option<usize> {
        let index = (x.to_bits() >> self.shift).wrapping_sub(self.base);
        (index < self.rows.len() as u64).then_some(index as usize)
    }

    /// The row of a finite load, which may be left out, and where in it the load lies; `None` outside the table.
    #[inline]
    pub fn row_at(&self, load: f64) -> Option<(&Row, f64)> {
        self.row_at_excess(load - self.pull_off)
    }

    #[inline]
    fn row_at_excess(&self, x: f64) -> Option<(&Row, f64)> {
        let row = &self.rows[self.row_of(x)?];
        Some((row, f64::from_bits(x.to_bits() & within_row(self.shift) | Table::ONE) - 1.0))
    }

    /// Friction force and dF/d(load) at a finite load from the table; `None` where the table does not answer.
    #[inline]
    pub fn at_load(&self, load: f64) -> Option<(f64, f64)> {
        self.at_excess(load - self.pull_off)
    }

    #[inline]
    fn at_excess(&self, x: f64) -> Option<(f64, f64)> {
        let (row, t) = self.row_at_excess(x)?;
        let (force, rate) = polynomial(&row.0, t);
        // 1/2^exponent: dF/dx = dF/d(mantissa) / 2^exponent
        let inverse_binade = f64::from_bits(Table::TWICE_BIAS - (x.to_bits() & !Table::MANTISSA));
        (!force.is_nan()).then_some((force, rate * inverse_binade))
    }

    /// The table itself.
    pub fn table(&self) -> Table<'_> {
        Table { rows: &self.rows, shift: self.shift, base: self.base, pull_off: self.pull_off }
    }

    /// The lightest and heaviest load of the table.
    pub fn range(&self) -> (f64, f64) {
        let edge = |row: u64| self.pull_off + f64::from_bits(row << self.shift);
        (edge(self.base), edge(self.base + self.rows.len() as u64))
    }

    /// The largest relative error of the friction force found when the table was built.
    pub fn error(&self) -> f64 {
        self.error
    }

    /// The separation at ln(load - pull-off), dimensionless, to a few digits.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        self.curve.separation(log_excess)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Params;

    /// The paper's default case with another surface energy.
    pub(super) fn branch(gamma: f64) -> Branch {
        let mut params = Params::default();
        params.set_dimensionless(0.01, 1000.0, gamma, 1.0, 0.3).expect("a surface");
        Branch::new(crate::population::tests::of(&params)).expect("a branch")
    }

    const SCALES: Scales = Scales { load: 3.0, force: 0.5 };

    #[test]
    fn every_row_of_the_default_case_answers_from_next_to_pull_off_to_heavy_load() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let law = Law::new(&branch, SCALES).expect("a law");
            assert!(law.rows.iter().all(|row| !row.is_left_out()));
            assert!(law.error() > 1e-16 && law.error() < 5e-11, "{:e}", law.error());
            for log_excess in [-3.0, 0.0, 4.0] {
                let separation = law.separation(log_excess).expect("it is covered");
                let found = branch.log_excess(separation).log_excess;
                assert!((found - log_excess).abs() < 1e-4, "{found}, not {log_excess}");
            }
            let (lightest, heaviest) = law.range();
            let heaviest_state = branch.log_excess(-12.0).log_excess.exp() * SCALES.load;
            assert!(heaviest > 0.8 * heaviest_state && heaviest <= heaviest_state, "{heaviest}");
            let pull_off = branch.pull_off_load() * SCALES.load;
            if gamma > 0.0 {
                let nearest = -pull_off * NEAREST_TO_PULL_OFF;
                assert!(lightest - pull_off >= nearest && lightest - pull_off < 1.6 * nearest, "{lightest}");
            } else {
                let range = (heaviest / lightest).ln();
                assert!((LOG_RANGE_WITHOUT_PULL_OFF..1.5 * LOG_RANGE_WITHOUT_PULL_OFF).contains(&range), "{range}");
            }
            for (load, answers) in [
                (lightest, true),
                (pull_off + (lightest - pull_off) * (1.0 - 1e-3), false),
                (heaviest.next_down(), true),
                (heaviest, false),
            ] {
                assert_eq!(law.at_load(load).is_some(), answers, "{load:e}");
            }
        }
    }

    #[test]
    fn a_row_is_left_out_where_it_misses_an_exact_state_and_only_there() {
        let branch = branch(0.001);
        let law = Law::new(&branch, SCALES).expect("a law");
        let mut states = Vec::new();
        Curve::new(&branch, |_| LOG_RANGE, &mut states).expect("a curve");
        let state = states[states.len() / 2];
        let x = state.log_excess.exp() * SCALES.load;
        let (row, _) = law.row_at_excess(x).expect("a row");
        let row = law.rows.iter().position(|other| other == row).expect("it is one of them");
        let certified = |log_force: f64, slope: f64| {
            let mut law = Law { error: 0.0, ..law.clone() };
            let mut state = state;
            state.log_force += log_force;
            state.log_slope *= 1.0 + slope;
            law.certify(&[state], SCALES);
            let left_out: Vec<usize> = (0..law.rows.len()).filter(|&row| law.rows[row].is_left_out()).collect();
            (left_out, law.error)
        };
        for sign in [1.0, -1.0] {
            assert_eq!(certified(3.0 * sign * VALUE_TOLERANCE, 0.0), (vec![row], 0.0));
            assert_eq!(certified(0.0, 3.0 * sign * SLOPE_TOLERANCE), (vec![row], 0.0));
            let (left_out, error) = certified(0.3 * sign * VALUE_TOLERANCE, 0.3 * sign * SLOPE_TOLERANCE);
            assert!(left_out.is_empty() && (error / (0.3 * VALUE_TOLERANCE) - 1.0).abs() < 0.1, "{error:e}");
        }
    }
}
