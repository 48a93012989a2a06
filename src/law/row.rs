//! The rows of the compiled law: each a polynomial in the mantissa of x = load - pull-off, filled from the curve.

use super::curve::Curve;
use super::{Scales, MANTISSA_BITS};
use crate::elementary::{log, log1p};
use std::f64::consts::LN_2;
use std::ops::RangeInclusive;

/// Coefficients per row: a polynomial of degree 7, one cache line.
pub const COEFFICIENTS: usize = 8;
/// The largest relative error of the force of a row that is kept.
const VALUE_TOLERANCE: f64 = 5e-11;
/// Of its slope.
const SLOPE_TOLERANCE: f64 = 5e-9;
/// Where within a row the curve determines it, beside its ends; where the two are compared.
const INTERIOR: [f64; 4] = [0.125, 0.359_375, 0.640_625, 0.875];
const BETWEEN: [f64; 3] = [0.05, 0.5, 0.95];
/// Where the curve is asked for a row: there, and at its end.
const PARTS: [f64; 8] = [INTERIOR[0], INTERIOR[1], INTERIOR[2], INTERIOR[3], BETWEEN[0], BETWEEN[1], BETWEEN[2], 1.0];

/// One row: coefficients of powers of (mantissa of x - mantissa where the row begins). The first is NaN where the row
/// is left out.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub struct Row(pub [f64; COEFFICIENTS]);

impl Row {
    /// Whether it does not answer.
    pub fn is_left_out(&self) -> bool {
        self.0[0].is_nan()
    }

    /// Makes it not answer.
    pub fn leave_out(&mut self) {
        self.0[0] = f64::NAN;
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

/// The relative error of a value, if it and its slope are good enough to be kept.
pub fn error_within_tolerance((value, rate): (f64, f64), (exact, slope): (f64, f64)) -> Option<f64> {
    let error = (value / exact - 1.0).abs();
    (error <= VALUE_TOLERANCE && (rate / slope - 1.0).abs() <= SLOPE_TOLERANCE).then_some(error)
}

/// What fills rows: a curve, the size of rows, and the units.
pub struct Filling<'a> {
    pub curve: &'a Curve,
    pub shift: u32,
    pub scales: Scales,
}

impl Filling<'_> {
    /// The rows whose shifted bits are these, and the largest error of those that are kept.
    pub fn rows(&self, range: RangeInclusive<u64>) -> (Vec<Row>, f64) {
        let basis = RowBasis::new();
        let width = (2.0_f64).powi(self.shift as i32 - MANTISSA_BITS as i32);
        let log_load = log(self.scales.load);
        let per_binade = 1_u64 << (MANTISSA_BITS - self.shift);
        // ln(mantissa), the same in every binade.
        let mantissas: Vec<[f64; PARTS.len()]> =
            (0..per_binade).map(|row| PARTS.map(|part| log1p((row as f64 + part) * width))).collect();
        // Force, and its slope by the part of the row, at the parts of a row.
        let at = |row: u64| {
            let within = (row % per_binade) as usize;
            let binade = (row / per_binade) as f64 - 1023.0;
            let log_excess = mantissas[within].map(|log| log + (binade * LN_2 - log_load));
            let mut points = self.curve.at(log_excess);
            for (point, part) in points.iter_mut().zip(PARTS) {
                let force = self.scales.force * point.0;
                *point = (force, force * point.1 * width / (1.0 + (within as f64 + part) * width));
            }
            points
        };
        let mut error = 0.0_f64;
        let mut rows = Vec::with_capacity((range.end() + 1).saturating_sub(*range.start()) as usize);
        let mut left = at(range.start() - 1)[7];
        if range.start().is_multiple_of(per_binade) {
            left.1 *= 2.0;
        }
        for row in range {
            let points = at(row);
            let right = points[7];
            let mut coefficients =
                basis.coefficients(left, right, [points[0].0, points[1].0, points[2].0, points[3].0]);
            // Between the points that determine the row.
            let mut row_error = 0.0_f64;
            let mut good = !coefficients.iter().any(|coefficient| coefficient.is_nan());
            for (part, (force, slope)) in BETWEEN.into_iter().zip(&points[4..]) {
                let (value, rate) = polynomial(&coefficients, part);
                match error_within_tolerance((value, rate), (*force, *slope)) {
                    Some(error) => row_error = row_error.max(error),
                    None => good = false,
                }
            }
            let mut scale = 1.0;
            for coefficient in &mut coefficients {
                *coefficient *= scale;
                scale /= width;
            }
            let mut filled = Row(coefficients);
            if good {
                error = error.max(row_error);
            } else {
                filled.leave_out();
            }
            rows.push(filled);
            // In the next binade the same part of a row is twice as long.
            left = if (row + 1).is_multiple_of(per_binade) { (right.0, 2.0 * right.1) } else { right };
        }
        if rows.is_empty() {
            rows.push(Row([f64::NAN; COEFFICIENTS])); // no table is without a row
        }
        (rows, error)
    }
}

/// Turns what determines a row (value and slope at both ends, four values between) into coefficients.
struct RowBasis {
    /// From the four values of q at the interior points to its coefficients, with p = cubic + u^2 (1-u)^2 q(u).
    inverse: [[f64; 4]; 4],
}

impl RowBasis {
    fn new() -> Self {
        // Lagrange's polynomials in power form.
        let mut inverse = [[0.0; 4]; 4];
        for (i, &node) in INTERIOR.iter().enumerate() {
            let mut lagrange = [1.0, 0.0, 0.0, 0.0];
            for (j, &other) in INTERIOR.iter().enumerate() {
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
        for (i, &u) in INTERIOR.iter().enumerate() {
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

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::*;

    const C: [f64; COEFFICIENTS] = [3.0, -2.0, 0.5, 1.25, -0.75, 2.5, -1.5, 0.375];

    fn horner(t: f64) -> (f64, f64) {
        C.iter().rev().fold((0.0, 0.0), |(value, slope), c| (value * t + c, slope * t + value))
    }

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    #[test]
    fn value_and_slope_are_those_of_horners_scheme() {
        for t in [0.0, 0.125, 0.4, 0.5, 0.99] {
            let ((value, slope), expected) = (polynomial(&C, t), horner(t));
            assert!(near(value, expected.0, 1e-14) && near(slope, expected.1, 1e-14), "{t}: {value}, {slope}");
        }
    }

    #[test]
    fn what_is_kept_is_good_in_value_and_in_slope() {
        let with = |error: f64, slope_error: f64| {
            error_within_tolerance((2.0 * (1.0 + error), -3.0 * (1.0 + slope_error)), (2.0, -3.0))
        };
        for sign in [1.0, -1.0] {
            let error = with(0.9 * sign * VALUE_TOLERANCE, 0.9 * sign * SLOPE_TOLERANCE).expect("it is good");
            assert!(near(error, 0.9 * VALUE_TOLERANCE, 1e-4), "{error:e}");
            assert_eq!(with(1.1 * sign * VALUE_TOLERANCE, 0.0), None);
            assert_eq!(with(0.0, 1.1 * sign * SLOPE_TOLERANCE), None);
        }
        assert_eq!(with(f64::NAN, 0.0), None);
        assert_eq!(with(0.0, f64::NAN), None);
    }

    #[test]
    fn a_row_has_the_coefficients_of_the_polynomial_that_it_is_made_from() {
        let found = RowBasis::new().coefficients(horner(0.0), horner(1.0), INTERIOR.map(|u| horner(u).0));
        for (found, expected) in found.into_iter().zip(C) {
            assert!((found - expected).abs() < 1e-11, "{found}, not {expected}");
        }
    }

    /// Rows of two surfaces against the curve they were filled from, over more than two binades.
    #[test]
    fn rows_lie_on_the_curve_and_their_values_and_slopes_meet() {
        for (gamma, start) in [(0.0, 0.75), (0.001, 1.0)] {
            let branch = branch(gamma);
            let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
            let (shift, scales) = (MANTISSA_BITS - 2, Scales { load: 3.0, force: 0.5 });
            let first = f64::to_bits(start) >> shift;
            let (rows, error) = Filling { curve: &curve, shift, scales }.rows(first..=first + 10);
            assert_eq!(rows.len(), 11);
            let at = |x: f64| {
                let [(force, log_slope)] = curve.at([(x / scales.load).ln()]);
                (scales.force * force, scales.force * force * log_slope / x)
            };
            let mut worst = 0.0_f64;
            for (row, index) in rows.iter().zip(first..) {
                let (begin, end) = (f64::from_bits(index << shift), f64::from_bits((index + 1) << shift));
                let binade = 2.0_f64.powi(begin.log2().floor() as i32);
                for part in [0.0, 0.05, 0.3, 0.5, 0.8, 0.95, 1.0] {
                    let (value, rate) = polynomial(&row.0, part * (end - begin) / binade);
                    let (force, slope) = at(begin + part * (end - begin));
                    let found = (value, rate / binade);
                    let (tolerance, of_slope) = if part % 1.0 == 0.0 { (1e-14, 1e-12) } else { (5e-11, 5e-9) };
                    assert!(near(found.0, force, tolerance), "{index} {part}: {}, not {force}", found.0);
                    assert!(near(found.1, slope, of_slope), "{index} {part}: {}, not {slope}", found.1);
                    if BETWEEN.contains(&part) {
                        worst = worst.max((value / force - 1.0).abs());
                    }
                }
            }
            assert!(near(error, worst, 1e-3) && error > 1e-16, "{error:e}, not {worst:e}");
        }
    }

    #[test]
    fn rows_are_left_out_where_the_curve_is_not_known_and_no_table_is_without_a_row() {
        let branch = branch(0.001);
        let curve = Curve::new(&branch, |_| 60.0, &mut Vec::new()).expect("a curve");
        let filling = Filling { curve: &curve, shift: MANTISSA_BITS - 2, scales: Scales { load: 1.0, force: 1.0 } };
        let beyond = f64::to_bits(10.0 * curve.log_range().1.exp()) >> filling.shift;
        let (rows, error) = filling.rows(beyond..=beyond + 1);
        assert!(rows.len() == 2 && rows.iter().all(Row::is_left_out) && error == 0.0, "{error:e}");
        let (rows, _) = filling.rows(RangeInclusive::new(beyond + 1, beyond));
        assert!(rows.len() == 1 && rows[0].is_left_out());
        let mut row = Row(C);
        assert!(!row.is_left_out());
        row.leave_out();
        assert!(row.is_left_out());
    }
}
