//! The law beyond its table: a power of x, the distance from an origin, that meets the outermost row with value and slope.
//!
//! Light: F = F_0 + G x^p, with x = load - pull-off and F_0 the value at pull-off, next to which p is 1/2. Heavy: F = G x^p. A
//! power is the same in every binade but for a factor, so rows for one binade and powers of that factor answer for all, without
//! exp or log.

use super::row::{coefficients, polynomial, Row, ROW_NODES};
use super::table::Table;
use super::LOAD_FRACTION;
use crate::numerics::elementary::{exp, log, log1p};
use crate::numerics::float_bits::{moderate, power_of_two, MANTISSA_BITS, MODERATE};
use crate::numerics::neighbours::Neighbours;
use std::f64::consts::{LN_2, LOG2_E};
use std::ops::RangeInclusive;

/// Rows per binade.
const ROWS: usize = 1 << LOAD_FRACTION;
/// The number of binades from a row's end to x has three digits of this base: 4096 binades are more than doubles have.
pub const DIGIT_BITS: u32 = 4;
pub const DIGIT: usize = 1 << DIGIT_BITS;
const DIGITS: usize = 3;
/// No number has these exponent bits.
const NO_EXPONENT: RangeInclusive<u64> = 1 << 12..=1 << 12;

/// A quantity beyond both ends of its table.
#[derive(Debug, Clone)]
pub struct Beyond {
    /// At its light end, and at its heavy one.
    pub ends: [Continuation; 2],
    /// Where the table begins, from the first origin.
    pub begin: f64,
}

impl Beyond {
    /// What continues a table of a quantity that has this value at pull-off, or none for which lighter loads ask; heavier ones
    /// count from an origin.
    pub fn new(table: &Table, at_pull_off: Option<f64>, heavy_origin: f64) -> Self {
        // The next number below: the end is not of the last row.
        let (first, last) = (table.begin_of(0), table.begin_of(table.row_count).below());
        let at = |x: f64| table.at_excess(x).unwrap_or((f64::NAN, f64::NAN));
        let (base, at_first) = at_pull_off.map_or((0.0, (0.0, 0.0)), |base| (base, at(first)));
        let light = Continuation::new(table.pull_off, first, at_first, base, false);
        let heavy = Continuation::new(heavy_origin, last + (table.pull_off - heavy_origin), at(last), 0.0, true);
        Self { ends: [light, heavy], begin: first }
    }

    /// The value and its slope at an argument that the table does not hold.
    pub fn at(&self, argument: f64) -> (f64, f64) {
        self.end(argument).at(argument)
    }

    /// The same where that is moderate.
    #[inline(always)]
    pub fn at_moderate(&self, argument: f64) -> (f64, f64) {
        let end = self.end(argument);
        end.at_normal(argument - end.origin)
    }

    /// Whether finding them there can raise no floating-point exception but "inexact".
    #[inline(always)]
    pub fn is_moderate(&self, argument: f64) -> bool {
        let end = self.end(argument);
        end.moderate.contains(&((argument - end.origin).to_bits() >> MANTISSA_BITS))
    }

    #[inline(always)]
    fn end(&self, argument: f64) -> &Continuation {
        &self.ends[usize::from(argument - self.ends[0].origin >= self.begin)]
    }
}

/// Value and slope of a quantity beyond one end of its table.
#[derive(Debug, Clone)]
pub struct Continuation {
    /// The argument at which x is 0.
    pub origin: f64,
    pub base: f64,
    /// x^p over the first binade beyond, as in a table, over its value at the end of the table.
    pub rows: [Row; ROWS],
    /// The exponent bits of that binade.
    pub binade: u64,
    /// G x^p at the end of the table, times what it changes by over 1, 2, ... binades; what it changes by over DIGIT, 2 DIGIT, ... and
    /// so on.
    pub factors: [[f64; DIGIT]; DIGITS],
    /// The exponent bits of x of which value and slope are moderate.
    pub moderate: RangeInclusive<u64>,
}

impl Continuation {
    /// How far bits of x are shifted for its rows, as in a table.
    #[inline]
    pub const fn shift() -> u32 {
        Table::shift_of(LOAD_FRACTION)
    }

    /// From the end of a table at `x` beyond an origin, where the quantity has this value and slope, to lighter or to heavier loads;
    /// `base` is the value at x = 0 of lighter ones, 0 of heavier ones.
    pub fn new(origin: f64, x: f64, (value, slope): (f64, f64), base: f64, is_heavy: bool) -> Self {
        let gain = value - base;
        let power = if gain > 0.0 { slope * x / gain } else { 0.0 };
        let binade = x.to_bits() >> MANTISSA_BITS;
        let log_mantissa = log(x / power_of_two(binade));
        // (x/end)^p and its slope by the mantissa.
        let at = |mantissa: f64| {
            let value = exp(power * (log1p(mantissa - 1.0) - log_mantissa));
            (value, power * value / mantissa)
        };
        let width = 1.0 / ROWS as f64;
        let rows = std::array::from_fn(|row| {
            let begin = 1.0 + row as f64 * width;
            let end = |mantissa: f64| {
                let (value, slope) = at(mantissa);
                (value, slope * width)
            };
            let interior = ROW_NODES.map(|part| at(begin + part * width).0);
            Row::of_length(coefficients(end(begin), end(begin + width), interior), width)
        });
        let sign = if is_heavy { 1.0 } else { -1.0 };
        // What no load asks for overflows.
        let factor = |binades: usize| exp((sign * power * binades as f64 * LN_2).clamp(-740.0, 700.0));
        let mut factors =
            std::array::from_fn(|digit| std::array::from_fn(|i| factor(i << (DIGIT_BITS as usize * digit))));
        factors[0] = factors[0].map(|factor| gain * factor);
        let moderate = moderate_binades(binade, gain, power, is_heavy);
        Self { origin, base, rows, binade, factors, moderate }
    }

    /// The value and its slope at an argument beyond the origin.
    pub fn at(&self, argument: f64) -> (f64, f64) {
        let x = argument - self.origin;
        if x >= f64::MIN_POSITIVE {
            return self.at_normal(x);
        }
        // To the first number that has all digits, straight.
        let (value, slope) = self.at_normal(f64::MIN_POSITIVE);
        (self.base + x / f64::MIN_POSITIVE * (value - self.base), slope)
    }

    #[inline(always)]
    fn at_normal(&self, x: f64) -> (f64, f64) {
        let mut binades = self.binade.abs_diff(x.to_bits() >> MANTISSA_BITS) as usize;
        let mut factor = 1.0;
        for factors in &self.factors {
            factor *= factors[binades & (DIGIT - 1)];
            binades >>= DIGIT_BITS;
            if binades == 0 {
                break;
            }
        }
        let of_mantissa = x.to_bits() & Table::MANTISSA;
        let t = f64::from_bits(of_mantissa & Table::within_row(Self::shift()) | Table::ONE) - 1.0;
        let (value, rate) = polynomial(&self.rows[(of_mantissa >> Self::shift()) as usize].0, t);
        (self.base + factor * value, factor * rate * Table::per_mantissa(x))
    }
}

/// The exponent bits of x of which x, G x^p and its slope are moderate, or 0: from the binade in which G x^p is `gain`, on to lighter or to
/// heavier loads. None if they are not there.
fn moderate_binades(binade: u64, gain: f64, power: f64, is_heavy: bool) -> RangeInclusive<u64> {
    let log2 = |x: f64| if x > 0.0 { LOG2_E * log(x) } else { 0.0 };
    let (x, log_gain) = (log2(power_of_two(binade)), log2(gain));
    // Each as a logarithm, and what that changes by per binade.
    let numbers = [(x, 1.0), (log_gain, power), (log_gain + log2(power) - x, power - 1.0)];
    let reach = numbers.map(|(log, rate)| (log2(MODERATE[1]) - log.abs()) / rate.abs());
    let binades = reach.into_iter().fold(f64::INFINITY, f64::min);
    match binades >= 0.0 && (power == 0.0 || moderate(power)) {
        false => NO_EXPONENT,
        true if is_heavy => binade..=binade + binades as u64,
        true => binade - binades as u64..=binade,
    }
}
