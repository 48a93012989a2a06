//! The compiled law: friction force as a function of load, in the caller's units, at the price of one polynomial.
//!
//! In x = load - pull-off the force has its only nearby singularity at x = 0. The table has a row for each fraction
//! of a binade of x, found from the bits of x without log or search; a row is a polynomial in the mantissa. Value and slope
//! agree where rows meet. A row that misses the exact curve is left out; its loads, like those outside the table, are
//! evaluated exactly.

mod curve;

use crate::equilibrium::Equilibrium;
use crate::error::Error;
use crate::population::Population;
use curve::{Curve, Sample};

pub use curve::BRANCH;

/// Coefficients per row: a polynomial of degree 7, one cache line.
pub const COEFFICIENTS: usize = 8;
/// Rows of one table at most: 64 KiB.
const MOST_ROWS: usize = 1024;
/// Rows per binade, as powers of two: tried in turn.
const FRACTIONS: [u32; 3] = [2, 3, 4];
/// The table begins at this part of the pull-off load above it, at least.
const NEAREST_TO_PULL_OFF: f64 = 5e-10;
/// Without adhesion it covers this range of ln(load).
const LOG_RANGE: f64 = 60.0;
/// The largest relative error of the force, and of its slope, of a row that is kept.
const VALUE_TOLERANCE: f64 = 5e-11;
const SLOPE_TOLERANCE: f64 = 5e-9;

const MANTISSA_BITS: u32 = 52;

/// One row: coefficients of powers of (mantissa of x - mantissa where the row begins). The first is NaN where the row
/// is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub struct Row(pub [f64; COEFFICIENTS]);

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
    /// Whether no row is left out.
    pub complete: bool,
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
    /// Whether no row is left out.
    complete: bool,
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
    /// [`Error::NotConverged`] where the branch of equilibrium states cannot be followed.
    pub fn new(population: &Population, equilibrium: &Equilibrium, scales: Scales) -> Result<Self, Error> {
        let mut samples = Vec::new();
        let curve = Curve::new(population, equilibrium, LOG_RANGE, &mut samples)?;
        let log_load = scales.load.ln();
        let (lower, upper) = curve.log_range();
        let lower = match equilibrium.pull_off() {
            Some(point) => (-point.load * NEAREST_TO_PULL_OFF).ln().max(lower),
            None => lower,
        } + log_load;
        let upper = upper + log_load;
        let mut law = Self {
            rows: Vec::new(),
            shift: 0,
            base: 0,
            pull_off: equilibrium.pull_off_load() * scales.load,
            error: 0.0,
            complete: false,
            curve,
        };
        for fraction in FRACTIONS {
            law.shift = MANTISSA_BITS - fraction;
            let last = (upper.min(700.0).exp().to_bits() >> law.shift) - 1;
            // What does not fit in the table is left to exact evaluation at the light end.
            let first = (lower.max(-700.0).exp().to_bits() >> law.shift).max(last - MOST_ROWS as u64) + 1;
            law.base = first;
            let worst = law.fill((last + 1 - first) as usize, scales);
            if worst <= 1.0 {
                break;
            }
        }
        law.certify(&samples, scales);
        law.complete = law.rows.iter().all(|row| !row.0[0].is_nan());
        Ok(law)
    }

    /// Fills the table from the curve; returns the largest error over its tolerance.
    fn fill(&mut self, count: usize, scales: Scales) -> f64 {
        let basis = RowBasis::new();
        let width = (2.0_f64).powi(self.shift as i32 - MANTISSA_BITS as i32);
        let at = |row: u64, part: f64| {
            let bits = row << self.shift;
            let start = f64::from_bits(bits);
            let binade = f64::from_bits(bits & !Table::MANTISSA);
            let x = start + part * width * binade;
            let (force, log_slope) = self.curve.at((x / scales.load).ln());
            let force = scales.force * force;
            // The slope by the part of the row.
            (force, force * log_slope / x * width * binade)
        };
        let mut worst = 0.0_f64;
        let mut rows = Vec::with_capacity(count);
        let mut error = 0.0_f64;
        let mut left = at(self.base, 0.0);
        for row in self.base..self.base + count as u64 {
            let right = at(row + 1, 0.0);
            let right_slope = if (row + 1) << self.shift & Table::MANTISSA == 0 { 0.5 * right.1 } else { right.1 };
            let interior = RowBasis::INTERIOR.map(|part| at(row, part).0);
            let coefficients = basis.coefficients(left, (right.0, right_slope), interior);
            // Between the points that determine the row.
            let mut excess = 0.0_f64;
            for part in RowBasis::BETWEEN {
                let (force, slope) = at(row, part);
                let (value, rate) = polynomial(&coefficients, part);
                let value_error = (value / force - 1.0).abs();
                excess = excess.max(value_error / VALUE_TOLERANCE);
                excess = excess.max((rate / slope - 1.0).abs() / SLOPE_TOLERANCE);
                if excess <= 1.0 {
                    error = error.max(value_error);
                }
            }
            worst = worst.max(excess);
            let mut scale = 1.0;
            let mut scaled = coefficients;
            for coefficient in &mut scaled {
                *coefficient *= scale;
                scale /= width;
            }
            if excess > 1.0 || scaled.iter().any(|coefficient| coefficient.is_nan()) {
                scaled[0] = f64::NAN;
            }
            rows.push(Row(scaled));
            left = right;
        }
        self.rows = rows;
        self.error = error;
        worst
    }

    /// Measures the table against the exact states that did not make it; leaves a row out that misses one.
    fn certify(&mut self, samples: &[Sample], scales: Scales) {
        for sample in samples {
            let x = (sample.log_excess + scales.load.ln()).exp();
            let Some((index, force, slope)) = self.row_of(x).and_then(|index| {
                let (force, slope) = self.at_excess(x)?;
                Some((index, force, slope))
            }) else {
                continue;
            };
            let exact = scales.force * self.curve.force_of(sample);
            let error = (force / exact - 1.0).abs();
            let slope_error = (slope / (exact * sample.log_slope / x) - 1.0).abs();
            if error > 2.0 * VALUE_TOLERANCE || slope_error > 2.0 * SLOPE_TOLERANCE {
                self.rows[index].0[0] = f64::NAN;
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

    /// Friction force and dF/d(load) at a finite load from the table; `None` where the table does not answer.
    #[inline]
    pub fn at_load(&self, load: f64) -> Option<(f64, f64)> {
        self.at_excess(load - self.pull_off)
    }

    #[inline]
    fn at_excess(&self, x: f64) -> Option<(f64, f64)> {
        let row = &self.rows[self.row_of(x)?].0;
        let bits = x.to_bits();
        let t = f64::from_bits(bits & within_row(self.shift) | Table::ONE) - 1.0;
        let (force, rate) = polynomial(row, t);
        // 1/2^exponent: dF/dx = dF/d(mantissa) / 2^exponent
        let inverse_binade = f64::from_bits(Table::TWICE_BIAS - (bits & !Table::MANTISSA));
        (!force.is_nan()).then_some((force, rate * inverse_binade))
    }

    /// The table itself.
    pub fn table(&self) -> Table<'_> {
        Table { rows: &self.rows, shift: self.shift, base: self.base, pull_off: self.pull_off, complete: self.complete }
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

/// A polynomial and its derivative. The order of operations is part of the contract: every path gives the same bits.
#[inline]
pub fn polynomial(c: &[f64; COEFFICIENTS], t: f64) -> (f64, f64) {
    let t2 = t * t;
    let t4 = t2 * t2;
    let value = ((c[0] + c[1] * t) + (c[2] + c[3] * t) * t2) + ((c[4] + c[5] * t) + (c[6] + c[7] * t) * t2) * t4;
    let slope = ((c[1] + 2.0 * c[2] * t) + (3.0 * c[3] + 4.0 * c[4] * t) * t2)
        + ((5.0 * c[5] + 6.0 * c[6] * t) + 7.0 * c[7] * t2) * t4;
    (value, slope)
}

/// Turns what determines a row (value and slope at both ends, four values between) into coefficients.
struct RowBasis {
    /// From the four values of q at the interior points to its coefficients, with p = cubic + u^2 (1-u)^2 q(u).
    inverse: [[f64; 4]; 4],
}

impl RowBasis {
    const INTERIOR: [f64; 4] = [0.125, 0.359_375, 0.640_625, 0.875];
    const BETWEEN: [f64; 3] = [0.05, 0.5, 0.95];

    fn new() -> Self {
        // Lagrange's polynomials in power form.
        let mut inverse = [[0.0; 4]; 4];
        for (i, &node) in Self::INTERIOR.iter().enumerate() {
            let mut lagrange = [1.0, 0.0, 0.0, 0.0];
            for (j, &other) in Self::INTERIOR.iter().enumerate() {
                if i == j {
                    continue;
                }
                for k in (0..4).rev() {
                    let lower = if k > 0 { lagrange[k - 1] } else { 0.0 };
                    lagrange[k] = (lower - other * lagrange[k]) / (node - other);
                }
            }
            for k in 0..4 {
                inverse[k][i] = lagrange[k];
            }
        }
        Self { inverse }
    }

    fn coefficients(&self, left: (f64, f64), right: (f64, f64), interior: [f64; 4]) -> [f64; COEFFICIENTS] {
        // The cubic with the ends' values and slopes.
        let rise = right.0 - left.0;
        let cubic = [left.0, left.1, 3.0 * rise - 2.0 * left.1 - right.1, left.1 + right.1 - 2.0 * rise];
        let mut q = [0.0; 4];
        for (i, &u) in Self::INTERIOR.iter().enumerate() {
            let at = cubic[0] + u * (cubic[1] + u * (cubic[2] + u * cubic[3]));
            let value = (interior[i] - at) / (u * u * (1.0 - u) * (1.0 - u));
            for (k, coefficient) in q.iter_mut().enumerate() {
                *coefficient += self.inverse[k][i] * value;
            }
        }
        // u^2 (1 - u)^2 q = (u^2 - 2 u^3 + u^4) q
        let mut c = [cubic[0], cubic[1], cubic[2], cubic[3], 0.0, 0.0, 0.0, 0.0];
        for (k, &coefficient) in q.iter().enumerate() {
            c[k + 2] += coefficient;
            c[k + 3] -= 2.0 * coefficient;
            c[k + 4] += coefficient;
        }
        c
    }
}
