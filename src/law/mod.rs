//! The compiled law: friction force as a function of load, in the caller's units, at the price of one polynomial.
//!
//! In x = load - pull-off the force has its only nearby singularity at x = 0. The table has a row for each fraction
//! of a binade of x, found from the bits of x without log or search; a row is a polynomial in the mantissa. Value and slope
//! agree where rows meet. A row across which the law has a kink is a link to several polynomials. Loads that are lighter
//! than the table's are interpolated by the curve that it was filled from; others are evaluated exactly.

mod curve;
mod exact;
mod fill;
mod row;
mod steps;
mod table;

use crate::elementary::{exp, log};
use crate::equilibrium::Branch;
use curve::{Curve, Sample};
use exact::ExactStates;
use fill::Filling;

pub use curve::Unfollowed;
pub use row::{polynomial, Row, COEFFICIENTS, OFFSET};
pub use table::Table;

/// Interpolation conditions per panel of the curve: value and slope at each of its exact states.
const CONDITIONS: usize = 20;
/// Rows of one table at most, without and with the parts of rows: 80 KiB of the 128 that a model may have.
const MOST_ROWS: usize = 1024;
const MOST_ROWS_AND_PARTS: usize = 1280;
/// Rows per binade, as a power of two: so many that nearly all are good.
const FRACTION: u32 = 2;
/// The table begins at this part of the pull-off load above it, at least: nearer, x has lost its digits.
const NEAREST_TO_PULL_OFF: f64 = 5e-10;
/// The range of ln(load - pull-off) that is compiled: what the rows can hold where that reaches down to the pull-off
/// load, or else what anyone may ask for.
const LOG_RANGE: f64 = (MOST_ROWS - 8) as f64 / (1 << FRACTION) as f64 * std::f64::consts::LN_2;
const LOG_RANGE_WITHOUT_PULL_OFF: f64 = 87.0;
/// What is lighter than the rows reach, but not by more than this in ln(load - pull-off), is left to the curve if that
/// leads it to pull-off.
const LOG_RANGE_OF_CURVE: f64 = 30.0;
/// The largest relative error of the force, and of its slope, of a row against an exact state.
const VALUE_TOLERANCE: f64 = 1e-10;
const SLOPE_TOLERANCE: f64 = 1e-8;

/// Friction force against load.
#[derive(Debug, Clone)]
pub struct Law {
    table: Table,
    scales: Scales,
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
        let reaches_pull_off = |heaviest: f64| heaviest - nearest <= LOG_RANGE + LOG_RANGE_OF_CURVE;
        let log_range = |heaviest: f64| if reaches_pull_off(heaviest) { f64::MAX } else { LOG_RANGE_WITHOUT_PULL_OFF };
        let mut curve = Curve::new(branch, log_range, &mut samples)?;
        let (lower, upper) = curve.log_range();
        let lower = nearest.max(lower).max(upper - log_range(upper).min(LOG_RANGE)) + log(scales.load);
        let upper = upper + log(scales.load);
        let shift = Table::shift_of(FRACTION);
        // The last whole row before the end, and the first.
        let end = exp(upper.min(700.0)).to_bits() >> shift;
        let base = ((exp(lower.max(-700.0)).to_bits() >> shift) + 1).min(end);
        let mut table = Table::new(FRACTION, base, branch.pull_off_load() * scales.load);
        let count = ((end - base) as usize).min(MOST_ROWS);
        let mut error = Filling::new(&mut curve, scales, FRACTION).rows(&mut table, count);
        if curve.is_resolved() {
            error = error.max(divide(&mut curve, scales, &mut table));
        } else {
            error = error.max(divide(&mut ExactStates::new(branch, &curve), scales, &mut table));
        }
        let mut law = Self { table, scales, error, curve };
        law.certify(&samples);
        Ok(law)
    }

    /// Measures the table against the exact states that did not make it; leaves a row out that misses one.
    fn certify(&mut self, samples: &[Sample]) {
        for sample in samples {
            let x = exp(sample.log_excess + log(self.scales.load));
            let (Some(row), Some((force, slope))) = (self.table.index_of(x), self.table.at_excess(x)) else { continue };
            let exact = self.scales.force * self.curve.force_of(sample);
            let error = (force / exact - 1.0).abs();
            let slope_error = (slope / (exact * sample.log_slope / x) - 1.0).abs();
            if error > VALUE_TOLERANCE || slope_error > SLOPE_TOLERANCE {
                self.table.rows[row].leave_out();
            } else {
                self.error = self.error.max(error);
            }
        }
    }

    /// The table.
    #[inline]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// Friction force and dF/d(load) at a load above pull-off that the table does not answer; `None` where the curve
    /// does not know it either.
    pub fn interpolated(&self, load: f64) -> Option<(f64, f64)> {
        let x = load - self.table.pull_off;
        let (force, log_slope) = self.curve.within(log(x) - log(self.scales.load))?;
        let force = self.scales.force * force;
        Some((force, force / x * log_slope))
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

/// Divides the rows that are left out into pieces, as far as there is room; the largest error of these.
fn divide(source: &mut impl fill::Source, scales: Scales, table: &mut Table) -> f64 {
    let mut filling = Filling::new(source, scales, FRACTION);
    let mut worst = 0.0_f64;
    for row in (0..table.row_count).rev() {
        if table.rows[row].is_left_out() {
            let room = MOST_ROWS_AND_PARTS - table.rows.len();
            worst = worst.max(filling.divide(table, row, room));
        }
    }
    worst
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::float_bits::Neighbours;
    use crate::params::Params;

    /// The paper's default case with another surface energy.
    pub(super) fn branch(gamma: f64) -> Branch {
        let mut params = Params::default();
        params.set_dimensionless(0.01, 1000.0, gamma, 1.0, 0.3).expect("a surface");
        Branch::new(crate::population::tests::of(&params)).expect("a branch")
    }

    const SCALES: Scales = Scales { load: 3.0, force: 0.5 };

    #[test]
    fn every_row_of_the_default_case_answers_from_next_to_pull_off_to_any_load_of_a_solver() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let law = Law::new(&branch, SCALES).expect("a law");
            let table = law.table();
            assert!(!table.rows.iter().any(Row::is_left_out) && table.rows.len() > table.row_count);
            assert!(law.error() > 1e-16 && law.error() < 5e-11, "{:e}", law.error());
            for log_excess in [-3.0, 0.0, 4.0, 25.0] {
                let separation = law.separation(log_excess).expect("it is covered");
                let found = branch.log_excess(separation).log_excess;
                assert!((found - log_excess).abs() < 1e-4, "{found}, not {log_excess}");
            }
            let (lightest, heaviest) = table.range();
            let half = branch.population().at_separation(0.0).load() * SCALES.load;
            assert!(heaviest > 1e12 * half, "{heaviest:e}, half the summits touch at {half:e}");
            let pull_off = branch.pull_off_load() * SCALES.load;
            if gamma > 0.0 {
                let nearest = -pull_off * NEAREST_TO_PULL_OFF;
                assert!(lightest - pull_off >= nearest && lightest - pull_off < 1.6 * nearest, "{lightest}");
            } else {
                let range = (heaviest / lightest).ln();
                assert!((range - LOG_RANGE_WITHOUT_PULL_OFF).abs() < 1.0, "{range}");
            }
            for (load, answers) in [
                (lightest, true),
                (pull_off + (lightest - pull_off) * (1.0 - 1e-3), false),
                (heaviest.below(), true),
                (heaviest, false),
            ] {
                assert_eq!(table.at_load(load).is_some(), answers, "{load:e}");
            }
        }
    }

    /// The row in which all summits pass the slip law's second radius, to pieces of a millionth of the load.
    #[test]
    fn rows_with_a_kink_are_answered_in_parts() {
        for beta in [1000.0, 200.0] {
            let mut params = Params::default();
            params.set_dimensionless(0.01, beta, 0.001, 1.0, 0.3).expect("a surface");
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let law = Law::new(&branch, SCALES).expect("a law");
            let kinks = branch.kinks();
            let [.., first, last] = kinks[..] else { panic!("{kinks:?}") };
            let (mut parts, mut misses) = (0, 0);
            for i in 0..200 {
                let separation = first + (last - first) * (f64::from(i) / 180.0 - 0.05);
                let point = branch.log_excess(separation);
                let x = SCALES.load * point.sums.load() - law.table.pull_off;
                let (force, slope) = law.table.at_excess(x).expect("the table answers");
                let exact = SCALES.force * point.sums.friction;
                let exact_slope = SCALES.force * point.sums.friction_slope / (SCALES.load * point.sums.load_slope);
                assert!((force / exact - 1.0).abs() < 1e-10, "{separation}: {force:e}, not {exact:e}");
                misses += usize::from((slope / exact_slope - 1.0).abs() > 1e-8);
                parts += usize::from(law.table.rows[law.table.index_of(x).expect("a row")].is_link());
            }
            // Now and then the exact slope has fewer digits, so far below the heights.
            assert!(parts > 150 && misses <= 4, "{parts} in parts, {misses} missed");
        }
    }

    /// Between pull-off and the first row the curve answers.
    #[test]
    fn loads_next_to_pull_off_are_interpolated() {
        let branch = branch(0.001);
        let law = Law::new(&branch, SCALES).expect("a law");
        let pull_off = law.table.pull_off;
        for part in [1e-10, 1e-12, 1e-14] {
            let load = pull_off * (1.0 - part);
            assert!(law.table.at_load(load).is_none());
            let (force, slope) = law.interpolated(load).expect("the curve covers it");
            let at_pull_off = SCALES.force * branch.pull_off().expect("adhesion").friction;
            // As the root of the distance.
            let rise = 2.0 * slope * (load - pull_off);
            assert!(
                force > at_pull_off && (force - at_pull_off - rise).abs() < 0.01 * rise,
                "{part}: {force}, {slope}"
            );
        }
        assert_eq!(law.interpolated(law.table.range().1 * 1e3), None);
    }

    #[test]
    fn a_row_is_left_out_where_it_misses_an_exact_state_and_only_there() {
        let branch = branch(0.001);
        let law = Law::new(&branch, SCALES).expect("a law");
        let mut states = Vec::new();
        Curve::new(&branch, |_| LOG_RANGE, &mut states).expect("a curve");
        let state = states[states.len() / 2];
        let row = law.table.index_of(state.log_excess.exp() * SCALES.load).expect("a row");
        let certified = |log_force: f64, slope: f64| {
            let mut law = Law { error: 0.0, ..law.clone() };
            law.certify(&[state.moved(log_force, slope)]);
            let left_out: Vec<usize> =
                (0..law.table.row_count).filter(|&row| law.table.rows[row].is_left_out()).collect();
            (left_out, law.error)
        };
        for sign in [1.0, -1.0] {
            assert_eq!(certified(3.0 * sign * VALUE_TOLERANCE, 0.0), (vec![row], 0.0));
            assert_eq!(certified(0.0, 3.0 * sign * SLOPE_TOLERANCE), (vec![row], 0.0));
            let (left_out, error) = certified(0.3 * sign * VALUE_TOLERANCE, 0.3 * sign * SLOPE_TOLERANCE);
            assert!(left_out.is_empty() && (error / (0.3 * VALUE_TOLERANCE) - 1.0).abs() < 0.2, "{error:e}");
        }
    }
}
