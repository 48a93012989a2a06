//! The compiled law: friction force and tangential stiffness as functions of load, in the caller's units, at the price of
//! one polynomial.
//!
//! In x = load - pull-off each has its only nearby singularity at x = 0. A table has a row for each fraction
//! of a binade of x, found from the bits of x without log or search; a row is a polynomial in the mantissa. Value and slope
//! agree where rows meet. A row across which the law has a kink is a link to several polynomials. Beyond the table the law goes
//! on as a power of x. Within it few loads have no row: they are interpolated by the curve that it was filled from, or evaluated
//! exactly.

mod by_separation;
mod continuation;
mod coordinate;
mod curve;
mod fill;
mod gap;
mod non_integer_power;
mod panel;
mod position;
mod row;
mod shares;
mod steps;
mod table;

use crate::elementary::{exp, log};
use crate::equilibrium::Branch;
use crate::population::Sums;
use curve::Curve;
use fill::{Filling, Source};
use gap::Gap;
use panel::Sample;
use shares::Shares;

pub use continuation::Continuation;
pub use curve::Unfollowed;
pub use gap::Lengths;
pub use row::{polynomial, Row};
#[cfg(target_arch = "x86_64")]
pub use row::{COEFFICIENTS, DIVISIONS, OFFSET};
pub use table::Table;

/// Interpolation conditions per panel of the curve: value and slope at each of its exact states.
const CONDITIONS: usize = 20;
/// Rows of one table at most, without and with the parts of rows: 35 and 80 KiB.
const MOST_ROWS: usize = 560;
const MOST_ROWS_AND_PARTS: usize = 1280;
/// Rows per binade, as a power of two: so many that nearly all are good.
const FRACTION: u32 = 2;
/// The table begins at this part of the pull-off load above it, at least: nearer, x has lost its digits.
const NEAREST_TO_PULL_OFF: f64 = 5e-10;
/// The range of ln(load - pull-off) that is compiled: what the rows can hold where that reaches down to the pull-off
/// load, or else what anyone may ask for.
const LOG_RANGE: f64 = (MOST_ROWS - 8) as f64 / (1 << FRACTION) as f64 * std::f64::consts::LN_2;
const LOG_RANGE_WITHOUT_PULL_OFF: f64 = 87.0;
/// The curve goes on to pull-off if that is no lighter than the rows by more than this in ln(load - pull-off), so that load
/// against separation is known down to it.
const LOG_RANGE_OF_CURVE: f64 = 110.0;
/// The largest relative error of a quantity, and of its slope, of a row against an exact state.
const VALUE_TOLERANCE: f64 = 1e-10;
const SLOPE_TOLERANCE: f64 = 1e-8;

/// What is compiled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// The friction force.
    Friction,
    /// The sum of contact radii, to which the tangential stiffness is proportional.
    Radius,
}

impl Quantity {
    pub const COUNT: usize = 2;
    pub const ALL: [Self; Self::COUNT] = [Self::Friction, Self::Radius];

    /// By how much the slopes of the compiled quantity may miss more than those of friction. Nobody is told the slope of the
    /// stiffness, and next to a kink it is harder to resolve than that of friction: it need only be as good as values ask for.
    fn slope_slack(self) -> f64 {
        match self {
            Self::Friction => 1.0,
            Self::Radius => 20.0,
        }
    }

    /// The quantity of a state, and its slope by separation.
    #[inline]
    pub fn of(self, sums: &Sums) -> (f64, f64) {
        match self {
            Self::Friction => (sums.friction, sums.friction_slope),
            Self::Radius => (sums.radius, sums.radius_slope),
        }
    }
}

/// Friction force and tangential stiffness against load.
#[derive(Debug, Clone)]
pub struct Law {
    compiled: [Compiled; Quantity::COUNT],
    gap: Gap,
    curve: Curve,
    shares: Shares,
}

/// One quantity against load.
#[derive(Debug, Clone)]
struct Compiled {
    table: Table,
    scale: Scale,
    error: f64,
}

/// The caller's units of load and of a quantity.
#[derive(Debug, Clone, Copy)]
pub struct Scale {
    /// The load that is 1 in the dimensionless model.
    pub load: f64,
    /// What the quantity is in the caller's units where it is 1 in the model.
    pub value: f64,
}

impl Law {
    /// Compiles the law in units of load, of each quantity and of length.
    ///
    /// # Errors
    /// [`Unfollowed`] where the load rises with separation already: the branch ends before.
    pub fn new(branch: &Branch, load: f64, units: [f64; Quantity::COUNT], length: f64) -> Result<Self, Unfollowed> {
        let mut samples = Vec::new();
        let nearest = log(-branch.pull_off_load() * NEAREST_TO_PULL_OFF);
        let reaches_pull_off = |heaviest: f64| heaviest - nearest <= LOG_RANGE + LOG_RANGE_OF_CURVE;
        let log_range = |heaviest: f64| if reaches_pull_off(heaviest) { f64::MAX } else { LOG_RANGE_WITHOUT_PULL_OFF };
        let curve = Curve::new(branch, log_range, &mut samples)?;
        let (lower, upper) = curve.log_range();
        let lower = nearest.max(lower).max(upper - log_range(upper).min(LOG_RANGE));
        let compiled = Quantity::ALL.map(|quantity| {
            let scale = Scale { load, value: units[quantity as usize] };
            let mut compiled = Compiled::new(branch.pull_off_load(), &curve, quantity, scale, (lower, upper));
            compiled.certify(&curve, quantity, &samples);
            compiled
        });
        let shares = Shares::new(branch, &curve, &compiled[Quantity::Friction as usize].table, load);
        let lengths = Lengths { unit: length, origin: branch.population().heights().origin() };
        let gap = Gap::new(branch, &curve, lengths, load, &samples);
        Ok(Self { compiled, gap, curve, shares })
    }

    /// The table of a quantity.
    #[inline]
    pub fn table(&self, quantity: Quantity) -> &Table {
        &self.compiled[quantity as usize].table
    }

    /// A quantity and its slope at a load within its table that has no row; `None` where the curve does not know it either.
    pub fn interpolated(&self, quantity: Quantity, load: f64) -> Option<(f64, f64)> {
        let Compiled { table, scale, .. } = &self.compiled[quantity as usize];
        let x = load - table.pull_off;
        let (value, log_slope) = self.curve.within(quantity, log(x) - log(scale.load))?;
        let value = scale.value * value;
        Some((value, value / x * log_slope))
    }

    /// The shares of the elements that follow the contacts before gross slip.
    #[inline]
    pub fn shares(&self) -> &Shares {
        &self.shares
    }

    /// Load against separation: a table of minus the separation.
    #[inline]
    pub fn load_table(&self) -> &Table {
        self.gap.table()
    }

    /// Whether the surfaces are apart at a separation.
    #[inline]
    pub fn is_open(&self, separation: f64) -> bool {
        self.gap.is_open(separation)
    }

    /// The separation from which on the surfaces are apart.
    pub fn end(&self) -> f64 {
        self.gap.end()
    }

    /// The load and its slope by minus the separation, where the table of it does not answer; `None` where the curve does not know
    /// them either.
    pub fn interpolated_load(&self, separation: f64) -> Option<(f64, f64)> {
        self.gap.interpolated(&self.curve, separation)
    }

    /// The largest relative error found when the table of a quantity was built.
    pub fn error(&self, quantity: Quantity) -> f64 {
        self.compiled[quantity as usize].error
    }

    /// The separation at ln(load - pull-off), dimensionless, to a few digits.
    pub fn separation(&self, log_excess: f64) -> Option<f64> {
        self.curve.separation(log_excess)
    }
}

/// A quantity against ln(load - pull-off), in the caller's units.
struct AgainstLoad<'a> {
    curve: &'a Curve,
    quantity: Quantity,
    unit: f64,
}

impl Source for AgainstLoad<'_> {
    fn at<const N: usize>(&self, log_excess: [f64; N]) -> [(f64, f64); N] {
        self.curve.at_each(self.quantity, log_excess).map(|(value, slope)| {
            let value = self.unit * value;
            (value, value * slope)
        })
    }

    fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        self.curve.log_joints(lower, upper)
    }
}

impl Compiled {
    /// Fills the table from the curve, within a range of ln(load - pull-off) in the model's units.
    fn new(pull_off_load: f64, curve: &Curve, quantity: Quantity, scale: Scale, (lower, upper): (f64, f64)) -> Self {
        let (lower, upper) = (lower + log(scale.load), upper + log(scale.load));
        let shift = Table::shift_of(FRACTION);
        // The last whole row before the end, and the first.
        let end = exp(upper.min(700.0)).to_bits() >> shift;
        let base = ((exp(lower.max(-700.0)).to_bits() >> shift) + 1).min(end);
        let mut table = Table::new(FRACTION, base, pull_off_load * scale.load);
        let count = ((end - base) as usize).min(MOST_ROWS);
        table.rows.reserve(count);
        let source = AgainstLoad { curve, quantity, unit: scale.value };
        let filling = Filling::new(&source, scale.load, FRACTION);
        let error = filling.rows(&mut table, count).max(filling.divide_left_out(&mut table, MOST_ROWS_AND_PARTS));
        table.rows.shrink_to_fit();
        Self { table, scale, error }
    }

    /// Measures the table against the exact states that did not make it; leaves a row out that misses one.
    fn certify(&mut self, curve: &Curve, quantity: Quantity, samples: &[Sample]) {
        for sample in samples {
            let x = exp(sample.log_excess + log(self.scale.load));
            let (Some(row), Some((value, slope))) = (self.table.index_of(x), self.table.at_excess(x)) else { continue };
            let (exact, log_slope) = curve.at_sample(quantity, sample);
            let exact = self.scale.value * exact;
            let error = (value / exact - 1.0).abs();
            let slope_error = (slope / (exact * log_slope / x) - 1.0).abs();
            if error > VALUE_TOLERANCE || slope_error > quantity.slope_slack() * SLOPE_TOLERANCE {
                self.table.rows[row].leave_out();
            } else {
                self.error = self.error.max(error);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbours::Neighbours;
    use crate::params::Params;

    /// The paper's default case with another surface energy.
    pub(super) fn branch(gamma: f64) -> Branch {
        let mut params = Params::default();
        params.set_dimensionless(0.01, 1000.0, gamma, 1.0, 0.3).expect("a surface");
        Branch::new(crate::population::tests::of(&params)).expect("a branch")
    }

    const LOAD: f64 = 3.0;
    const UNITS: [f64; 2] = [0.5, 7.0];
    const LENGTH: f64 = 3e-9;

    #[test]
    fn every_row_of_the_default_case_answers_from_next_to_pull_off_to_any_load_of_a_solver() {
        for gamma in [0.0, 0.001] {
            let branch = branch(gamma);
            let law = Law::new(&branch, LOAD, UNITS, LENGTH).expect("a law");
            for quantity in Quantity::ALL {
                let table = law.table(quantity);
                assert!(!table.rows.iter().any(Row::is_left_out), "{quantity:?}");
                let error = law.error(quantity);
                assert!(error > 1e-16 && error < 5e-11, "{quantity:?}: {error:e}");
            }
            // Friction has kinks.
            let table = law.table(Quantity::Friction);
            assert!(table.rows.len() > table.row_count);
            for log_excess in [-3.0, 0.0, 4.0, 25.0] {
                let separation = law.separation(log_excess).expect("it is covered");
                let found = branch.log_excess(separation).log_excess;
                assert!((found - log_excess).abs() < 1e-4, "{found}, not {log_excess}");
            }
            let (lightest, heaviest) = table.range();
            let half = branch.population().at_separation(0.0).load() * LOAD;
            assert!(heaviest > 1e12 * half, "{heaviest:e}, half the summits touch at {half:e}");
            let pull_off = branch.pull_off_load() * LOAD;
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
            let law = Law::new(&branch, LOAD, UNITS, LENGTH).expect("a law");
            let table = law.table(Quantity::Friction);
            let kinks = branch.population().kinks();
            let [.., first, last] = kinks[..] else { panic!("{kinks:?}") };
            let (mut parts, mut misses) = (0, 0);
            for i in 0..200 {
                let separation = first + (last - first) * (f64::from(i) / 180.0 - 0.05);
                let point = branch.log_excess(separation);
                let x = LOAD * point.sums.load() - table.pull_off;
                let (force, slope) = table.at_excess(x).expect("the table answers");
                let exact = UNITS[0] * point.sums.friction;
                let exact_slope = UNITS[0] * point.sums.friction_slope / (LOAD * point.sums.load_slope);
                assert!((force / exact - 1.0).abs() < 1e-10, "{separation}: {force:e}, not {exact:e}");
                misses += usize::from((slope / exact_slope - 1.0).abs() > 1e-8);
                parts += usize::from(table.rows[table.index_of(x).expect("a row")].is_link());
            }
            // Now and then the exact slope has fewer digits, so far below the heights.
            assert!(parts > 150 && misses <= 4, "{parts} in parts, {misses} missed");
        }
    }

    /// Where the lower end of Weibull's density passes an edge of contact, friction is a non-integer power of the distance in load.
    #[test]
    fn rows_with_a_non_integer_power_are_answered_up_to_it() {
        for (shape, adhesion) in [(1.8, 1.0), (2.0, 1.0), (1.8, 0.0), (3.6, 1.0)] {
            let default = Params::default();
            let params = Params {
                heights: crate::params::HeightFamily::Weibull { shape },
                work_of_adhesion: adhesion * default.work_of_adhesion,
                ..default
            };
            let branch = Branch::new(crate::population::tests::of(&params)).expect("a branch");
            let law = Law::new(&branch, LOAD, UNITS, LENGTH).expect("a law");
            let feet: Vec<f64> = branch.population().kinks().into_iter().filter(|&kink| kink > -10.0).collect();
            assert!(feet.len() >= 2, "{feet:?}");
            for quantity in Quantity::ALL {
                let table = law.table(quantity);
                let mut unanswered = 0;
                for i in 0..600 {
                    // On both sides of each, at distances of all sizes.
                    let distance = [1e-1, -1e-1][i % 2] * 10_f64.powf(-7.0 * (i / 6) as f64 / 100.0);
                    let separation = feet[i / 2 % feet.len()] + distance;
                    let point = branch.log_excess(separation);
                    let load = LOAD * point.sums.load();
                    unanswered += usize::from(table.at_load(load).is_none());
                    let found = table.at_load(load).or_else(|| law.interpolated(quantity, load));
                    let (value, slope) = found.unwrap_or_else(|| panic!("{shape}: {separation} is not answered"));
                    let (exact, exact_slope) = quantity.of(&point.sums);
                    let exact = UNITS[quantity as usize] * exact;
                    let exact_slope = UNITS[quantity as usize] * exact_slope / (LOAD * point.sums.load_slope);
                    assert!((value / exact - 1.0).abs() < 1e-10, "{shape}, {quantity:?}, {separation}: {value:e}");
                    let miss = (slope / exact_slope - 1.0).abs();
                    // Next to one the load has lost digits of the distance.
                    let distance = feet.iter().map(|lower_end| (separation - lower_end).abs()).fold(f64::MAX, f64::min);
                    let tolerance = quantity.slope_slack() * 5e-8 * (1e-4 / distance).max(1.0);
                    assert!(miss < tolerance, "{shape}, {quantity:?}, {separation}, {distance:e}: {miss:e}");
                }
                // By the table: but for what is nearer than a millionth of sigma.
                assert!(unanswered < 150, "{shape}, {quantity:?}: {unanswered} of 600");
            }
        }
    }

    #[test]
    fn a_row_is_left_out_where_it_misses_an_exact_state_and_only_there() {
        let branch = branch(0.001);
        let law = Law::new(&branch, LOAD, UNITS, LENGTH).expect("a law");
        let mut states = Vec::new();
        let curve = Curve::new(&branch, |_| LOG_RANGE, &mut states).expect("a curve");
        let compiled = &law.compiled[0];
        let error_at = |state: &Sample| {
            let (value, _) = compiled.table.at_excess(state.log_excess.exp() * LOAD).unwrap_or_default();
            (value / (UNITS[0] * curve.at_sample(Quantity::Friction, state).0) - 1.0).abs()
        };
        let state = states.into_iter().min_by(|a, b| error_at(a).total_cmp(&error_at(b))).expect("a state");
        let row = compiled.table.index_of(state.log_excess.exp() * LOAD).expect("a row");
        let certified = |log_value: f64, slope: f64| {
            let mut compiled = Compiled { error: 0.0, ..compiled.clone() };
            compiled.certify(&curve, Quantity::Friction, &[state.moved(log_value, slope)]);
            let table = compiled.table;
            let left_out: Vec<usize> = (0..table.row_count).filter(|&row| table.rows[row].is_left_out()).collect();
            (left_out, compiled.error)
        };
        for sign in [1.0, -1.0] {
            assert_eq!(certified(3.0 * sign * VALUE_TOLERANCE, 0.0), (vec![row], 0.0));
            assert_eq!(certified(0.0, 3.0 * sign * SLOPE_TOLERANCE), (vec![row], 0.0));
            let (left_out, error) = certified(0.3 * sign * VALUE_TOLERANCE, 0.3 * sign * SLOPE_TOLERANCE);
            assert!(left_out.is_empty() && (error / (0.3 * VALUE_TOLERANCE) - 1.0).abs() < 0.2, "{error:e}");
        }
    }
}
