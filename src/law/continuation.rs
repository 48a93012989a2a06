//! The law beyond its table: a power of x = load - pull-off that meets the outermost row with value and slope.
//!
//! Light: F = F_0 + G x^p, with F_0 the value at pull-off, next to which p is 1/2. Heavy: F = G x^p. A power is the same in every
//! binade but for a factor, so rows for one binade and powers of that factor answer for all, without exp or log.

use super::row::{polynomial, Row, RowBasis, INTERIOR};
use super::table::{Table, MANTISSA_BITS};
use super::FRACTION;
use crate::elementary::{exp, log, log1p};
use crate::float_bits::{moderate, MODERATE};
use crate::neighbours::Neighbours;
use std::f64::consts::LN_2;
use std::ops::RangeInclusive;

/// Rows per binade.
const ROWS: usize = 1 << FRACTION;
/// The number of binades from a row's end to x has three digits of this base: 4096 binades are more than doubles have.
pub const DIGIT_BITS: u32 = 4;
pub const DIGIT: usize = 1 << DIGIT_BITS;
const DIGITS: usize = 3;
/// Subnormal numbers are multiplied by 2 to this power.
const SUBNORMAL: u64 = 54;
/// No number has these exponent bits.
const NONE: RangeInclusive<u64> = 1 << 12..=1 << 12;

/// A quantity beyond both ends of its table.
#[derive(Debug, Clone)]
pub struct Beyond {
    /// At its light end, and at its heavy one.
    pub ends: [Continuation; 2],
}

impl Beyond {
    /// Of a table of a quantity that has this value at pull-off.
    pub fn new(table: &Table, at_pull_off: f64) -> Self {
        // The next number below: the end is not of the last row.
        let (first, last) = (table.begin_of(0), table.begin_of(table.row_count).below());
        let at = |x: f64| table.at_excess(x).unwrap_or((f64::NAN, f64::NAN));
        let light = Continuation::new(first, at(first), at_pull_off, false);
        Self { ends: [light, Continuation::new(last, at(last), 0.0, true)] }
    }

    /// The value and its slope at x > 0 that the table does not hold.
    #[inline]
    pub fn at(&self, table: &Table, x: f64) -> (f64, f64) {
        self.end(table, x).at(x)
    }

    /// Whether finding them there can raise no floating-point exception but "inexact".
    #[inline]
    pub fn is_moderate(&self, table: &Table, x: f64) -> bool {
        self.end(table, x).is_moderate(x)
    }

    #[inline]
    fn end(&self, table: &Table, x: f64) -> &Continuation {
        &self.ends[usize::from(x >= table.begin_of(0))]
    }
}

/// Value and slope of a quantity beyond one end of its table.
#[derive(Debug, Clone)]
pub struct Continuation {
    pub base: f64,
    /// G x^p over the first binade beyond, as in a table.
    pub rows: [Row; ROWS],
    /// The exponent bits of that binade.
    pub binade: u64,
    /// What G x^p changes by over 1, 2, ... binades, over DIGIT, 2 DIGIT, ... and so on.
    pub factors: [[f64; DIGIT]; DIGITS],
    /// The exponent bits of x of which value and slope are moderate.
    pub moderate: RangeInclusive<u64>,
}

impl Continuation {
    /// From the end of a table at `x`, where the quantity has this value and slope, to lighter or to heavier loads; `base` is
    /// the value at x = 0 of lighter ones, 0 of heavier ones.
    pub fn new(x: f64, (value, slope): (f64, f64), base: f64, is_heavy: bool) -> Self {
        let gain = value - base;
        let power = if gain > 0.0 { slope * x / gain } else { 0.0 };
        let binade = x.to_bits() >> MANTISSA_BITS;
        let log_mantissa = log(Self::mantissa(x));
        // G x^p and its slope by the mantissa.
        let at = |mantissa: f64| {
            let value = gain * exp(power * (log1p(mantissa - 1.0) - log_mantissa));
            (value, power * value / mantissa)
        };
        let width = 1.0 / ROWS as f64;
        let basis = RowBasis::new();
        let rows = std::array::from_fn(|row| {
            let begin = 1.0 + row as f64 * width;
            let end = |mantissa: f64| {
                let (value, slope) = at(mantissa);
                (value, slope * width)
            };
            let interior = INTERIOR.map(|part| at(begin + part * width).0);
            Row::of_length(basis.coefficients(end(begin), end(begin + width), interior), width)
        });
        let sign = if is_heavy { 1.0 } else { -1.0 };
        // What no load asks for overflows.
        let factor = |binades: usize| exp((sign * power * binades as f64 * LN_2).clamp(-740.0, 700.0));
        let factors = std::array::from_fn(|digit| std::array::from_fn(|i| factor(i << (DIGIT_BITS as usize * digit))));
        Self { base, rows, binade, factors, moderate: moderate_binades(binade, gain, base, power) }
    }

    /// Whether finding the value and slope at x > 0 can raise no floating-point exception but "inexact".
    #[inline]
    pub fn is_moderate(&self, x: f64) -> bool {
        self.moderate.contains(&(x.to_bits() >> MANTISSA_BITS))
    }

    /// The value and its slope by x > 0.
    pub fn at(&self, x: f64) -> (f64, f64) {
        if x >= f64::MIN_POSITIVE {
            return self.at_normal(x, 0);
        }
        let scale = (1_u64 << SUBNORMAL) as f64;
        let (value, slope) = self.at_normal(x * scale, SUBNORMAL);
        (value, slope * scale)
    }

    /// The value and its slope by a normal number, which is 2^`shift` times what is meant.
    #[inline]
    fn at_normal(&self, x: f64, shift: u64) -> (f64, f64) {
        let binades = (self.binade + shift).abs_diff(x.to_bits() >> MANTISSA_BITS) as usize;
        let factor = (0..DIGITS).fold(1.0, |factor, digit| {
            factor * self.factors[digit][binades >> (DIGIT_BITS as usize * digit) & (DIGIT - 1)]
        });
        // As in a table of so many rows per binade.
        let of_mantissa = x.to_bits() & Table::MANTISSA;
        let row_shift = Table::shift_of(FRACTION);
        let within_row = of_mantissa & !(u64::MAX << row_shift);
        let t = f64::from_bits(within_row | Table::ONE) - 1.0;
        let (value, rate) = polynomial(&self.rows[(of_mantissa >> row_shift) as usize].0, t);
        let begin_of_binade = f64::from_bits(x.to_bits() - of_mantissa);
        (self.base + factor * value, factor * rate / begin_of_binade)
    }

    fn mantissa(x: f64) -> f64 {
        f64::from_bits(x.to_bits() & Table::MANTISSA | Table::ONE)
    }
}

/// The exponent bits of x of which base + G x^p and its slope are moderate, from the binade in which G x^p is `gain`; none if the
/// gain, the base or the power is not moderate.
fn moderate_binades(binade: u64, gain: f64, base: f64, power: f64) -> RangeInclusive<u64> {
    let is_zero_or_moderate = |number: f64| number == 0.0 || moderate(number);
    if !moderate(gain) || !is_zero_or_moderate(base) || !is_zero_or_moderate(power) {
        return NONE;
    }
    let [least, most] = MODERATE.map(|end| end.to_bits() >> MANTISSA_BITS);
    let left = log(MODERATE[1]) - log(gain).abs();
    let binades = (left / (power.max(1.0) * LN_2)) as u64;
    let (first, last) = (binade.saturating_sub(binades).max(least), (binade + binades).min(most));
    if first <= last {
        first..=last
    } else {
        NONE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::neighbours::Neighbours;

    #[test]
    fn beyond_its_end_the_law_is_a_power_that_meets_value_and_slope() {
        for (part, binade, power, base) in [
            (1.5, 0, 0.5, 0.0),
            (1.5, -22, 0.5, 2.0),
            (1.5, 665, 0.93, 0.0),
            (1.0, -963, 0.98, 0.0),
            (1.0, 3, 0.0, 1.0),
        ] {
            // Where a row begins, as tables do.
            let x = part * f64::powi(2.0, binade);
            let gain = 3.0;
            let end = (base + gain, power * gain / x);
            for is_heavy in [false, true] {
                let beyond = Continuation::new(x, end, base, is_heavy);
                let (value, slope) = beyond.at(x);
                assert!((value / end.0 - 1.0).abs() < 1e-14, "{x:e}: {value}");
                assert!((slope - end.1).abs() <= 1e-12 * end.1, "{x:e}: {slope:e}, not {:e}", end.1);
                for step in 1..200 {
                    let far = 1.9 * f64::from(step);
                    let ratio = exp(if is_heavy { far } else { -far });
                    let at = x * ratio;
                    if !at.is_normal() {
                        continue;
                    }
                    let (value, slope) = beyond.at(at);
                    let rise = gain * exp(power * log(at / x));
                    assert!(
                        (value / (base + rise) - 1.0).abs() < 2e-9,
                        "{at:e} of {x:e}: {value:e}, not {:e}",
                        base + rise
                    );
                    let exact = power * rise / at;
                    assert!((slope - exact).abs() <= 2e-7 * exact, "{at:e} of {x:e}: slope {slope:e}, not {exact:e}");
                }
            }
        }
    }

    #[test]
    fn the_smallest_numbers_are_told_apart() {
        let beyond = Continuation::new(1e-300, (1e-300, 0.9), 0.0, false);
        let mut last = 0.0;
        for x in [5e-324, 1e-323, 1e-320, f64::MIN_POSITIVE.below(), f64::MIN_POSITIVE, 1e-301] {
            let (value, slope) = beyond.at(x);
            assert!(value > last && slope > 0.0 && slope.is_finite(), "{x:e}: {value:e}, {slope:e}");
            last = value;
        }
    }

    /// As far as the numbers on the way to a value lie between 2^-300 and 2^300.
    #[test]
    fn values_are_moderate_as_far_as_their_power_leads_and_no_further() {
        let binades_of = |end: f64, gain: f64, power: f64, base: f64| {
            let beyond = Continuation::new(end, (base + gain, power * gain / end), base, true);
            let is_moderate = |binade: &i32| beyond.is_moderate(1.5 * f64::powi(2.0, *binade));
            let moderate: Vec<i32> = (-1000..1000).filter(is_moderate).collect();
            assert!(moderate.windows(2).all(|pair| pair[1] == pair[0] + 1), "{moderate:?}");
            moderate.first().copied().zip(moderate.last().copied())
        };
        assert_eq!(binades_of(1.0, 1.0, 0.5, 0.0), Some((-300, 300)));
        assert_eq!(binades_of(1.0, 1.0, 0.0, 1.0), Some((-300, 300)));
        assert_eq!(binades_of(1024.0, 1.0, 0.5, 2.0), Some((-290, 300)));
        assert_eq!(binades_of(1.0, 1025.0, 0.9, 0.0), Some((-289, 289)));
        assert_eq!(binades_of(1.0, 1.0 / 1025.0, 0.9, 0.0), Some((-289, 289)));
        assert_eq!(binades_of(1.0, 1.0, 2.0, 0.0), Some((-150, 150)));
        for (end, gain, power, base) in
            [(1.0, 1e-100, 0.5, 0.0), (1.0, 1.0, 1e-100, 0.0), (1.0, 1.0, 0.5, 1e-100), (1e200, 1.0, 1.0, 0.0)]
        {
            assert_eq!(binades_of(end, gain, power, base), None, "{gain:e} at {end:e}");
        }
    }
}
