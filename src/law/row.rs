//! One row of the compiled law: a polynomial in the mantissa of x = load - pull-off, or a link to rows that are parts of
//! it.

use super::newton::newton;
use super::tolerance::{self, larger};
use std::mem::size_of;

/// Coefficients per row: a polynomial of degree 7, one cache line.
pub const COEFFICIENTS: usize = 8;
/// The parts of a row at which values determine it, beside values and slopes at its ends; where it is compared.
pub const ROW_NODES: [f64; 4] = [0.125, 0.359_375, 0.640_625, 0.875];
pub const ROW_CHECKS: [f64; 3] = [0.05, 0.5, 0.95];
/// Where values determine it, and slopes where two are alike.
const CONDITIONS: [f64; COEFFICIENTS] = [0.0, 0.0, ROW_NODES[0], ROW_NODES[1], ROW_NODES[2], ROW_NODES[3], 1.0, 1.0];
/// The places at which a link divides a row: as many as it has room for.
pub const DIVISIONS: usize = COEFFICIENTS - 2;
/// No division: beyond the end of any row.
const NO_DIVISION: f64 = 2.0;
/// The bits of a quiet NaN, and those of it that may be any.
const QUIET_NAN: u64 = 0xfff << 51;
pub const OFFSET: u64 = (1 << 51) - 1;

/// One row: coefficients of powers of (mantissa of x - mantissa where the row begins).
///
/// If the first two are NaN, the row is a link: the last 51 bits of the first tell where its parts begin, as an offset in
/// bytes from the first row of the table, and the other six where they divide it, ascending.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(C, align(64))]
pub struct Row(pub [f64; COEFFICIENTS]);

impl Row {
    /// The row of a polynomial in the part of a length.
    pub fn of_length(coefficients: [f64; COEFFICIENTS], length: f64) -> Self {
        let mut scale = 1.0;
        Self(coefficients.map(|coefficient| {
            let scaled = coefficient * scale;
            scale /= length;
            scaled
        }))
    }

    /// A link to parts, of which the first has this index, between these divisions.
    pub fn link(first: usize, divisions: &[f64]) -> Self {
        let first = f64::from_bits(QUIET_NAN | (first * size_of::<Self>()) as u64);
        let mut row =
            Self([first, f64::NAN, NO_DIVISION, NO_DIVISION, NO_DIVISION, NO_DIVISION, NO_DIVISION, NO_DIVISION]);
        row.0[2..][..divisions.len()].copy_from_slice(divisions);
        row
    }

    /// Whether it is a link.
    #[inline]
    pub fn is_link(&self) -> bool {
        self.0[0].is_nan()
    }

    /// The index of the part in which t lies, and where that begins, if not where this row does.
    #[inline]
    pub fn part(&self, t: f64) -> (usize, Option<f64>) {
        let first = (self.0[0].to_bits() & OFFSET) as usize / size_of::<Self>();
        // Sums of comparisons, which need no branch.
        let before = self.0[2..].iter().map(|&division| usize::from(t >= division)).sum::<usize>();
        (first + before, (before > 0).then(|| self.0[1 + before]))
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

/// The relative error of a value, and that of it or its slope over its tolerance, whichever is larger. Errors of what is less than the
/// least are relative to that.
pub fn compared((value, rate): (f64, f64), (exact, slope): (f64, f64), least: (f64, f64)) -> (f64, f64) {
    let error = relative_error(value, exact, least.0);
    (error, larger(error / tolerance::VALUE, relative_error(rate, slope, least.1) / tolerance::SLOPE))
}

/// The error of a number relative to the exact one, or to the least, if that is larger.
pub fn relative_error(value: f64, exact: f64, least: f64) -> f64 {
    if exact.abs() < least {
        ((value - exact) / least).abs()
    } else {
        (value / exact - 1.0).abs()
    }
}

/// The coefficients of powers of a polynomial with values and slopes at the ends of a row, and with values between.
pub fn coefficients(left: (f64, f64), right: (f64, f64), [a, b, c, d]: [f64; 4]) -> [f64; COEFFICIENTS] {
    let values = [left.0, left.0, a, b, c, d, right.0, right.0];
    let slopes = [left.1, left.1, 0.0, 0.0, 0.0, 0.0, right.1, right.1];
    let mut coefficients = newton(&CONDITIONS, values, &slopes);
    // From Newton's form: brackets are multiplied out, the innermost first.
    for k in (0..COEFFICIENTS - 1).rev() {
        for i in k..COEFFICIENTS - 1 {
            coefficients[i] -= CONDITIONS[k] * coefficients[i + 1];
        }
    }
    coefficients
}

#[cfg(test)]
mod tests {
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
    fn a_row_has_the_coefficients_of_the_polynomial_that_it_is_made_from() {
        let found = coefficients(horner(0.0), horner(1.0), ROW_NODES.map(|u| horner(u).0));
        for (found, expected) in found.into_iter().zip(C) {
            assert!((found - expected).abs() < 1e-11, "{found}, not {expected}");
        }
    }
}
