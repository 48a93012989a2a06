//! Elementary functions whose results have the same bits on every processor and system.
//!
//! Those of a system's own library have other last bits where the processor has no fused multiply-add, or another version
//! of the library is installed; a law compiled from them would too.

pub use libm::{cbrt, expm1, log, log1p, pow, sincos, sinh};
use std::f64::consts::LOG2_E;

/// (x^2 + y^2)^(1/2), where that is a number.
pub fn hypot(x: f64, y: f64) -> f64 {
    let (larger, smaller) = (x.abs().max(y.abs()), x.abs().min(y.abs()));
    if larger == 0.0 {
        return 0.0;
    }
    let ratio = smaller / larger;
    larger * (1.0 + ratio * ratio).sqrt()
}

/// 1/k! from k = 2.
const TAYLOR: [f64; 12] = {
    let mut coefficients = [0.5; 12];
    let mut k = 1;
    while k < 12 {
        coefficients[k] = coefficients[k - 1] / (k + 2) as f64;
        k += 1;
    }
    coefficients
};

/// ln 2 in two parts, of which the first has so many zeros at its end that a whole number times it is exact.
const LN_2: [f64; 2] = [f64::from_bits(0x3FE6_2E42_FEE0_0000), f64::from_bits(0x3DEA_39EF_3579_3C76)];

/// exp(x), within a unit in the last place of `libm`'s.
///
/// Models are made of so many of them that it has to be fast: without a table and, but for the ends of the range, without
/// a branch, so that a compiler works out several side by side.
#[inline]
pub fn exp(x: f64) -> f64 {
    exp_each([x])[0]
}

/// The same of each number, side by side.
#[inline]
pub fn exp_each<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    if numbers.iter().all(|&x| is_ordinary(x)) {
        numbers.map(ordinary_exp)
    } else {
        numbers.map(|x| if is_ordinary(x) { ordinary_exp(x) } else { libm::exp(x) })
    }
}

/// Whether exp(x) is neither 0 nor infinite nor has fewer digits than other numbers.
#[inline]
fn is_ordinary(x: f64) -> bool {
    x.abs() < 708.0
}

#[inline]
fn ordinary_exp(x: f64) -> f64 {
    /// Adding it rounds to a whole number, which is then in the last bits.
    const ROUNDING_SHIFT: f64 = 1.5 * (1u64 << 52) as f64;
    // x = n ln 2 + r
    let shifted = x * LOG2_E + ROUNDING_SHIFT;
    let n = shifted - ROUNDING_SHIFT;
    let r = (x - n * LN_2[0]) - n * LN_2[1];
    let (r2, c) = (r * r, &TAYLOR);
    let r4 = r2 * r2;
    let quartet = |i: usize| (c[i] + r * c[i + 1]) + r2 * (c[i + 2] + r * c[i + 3]);
    let tail = quartet(0) + r4 * (quartet(4) + r4 * quartet(8));
    let power = 1.0 + (r + r2 * tail);
    f64::from_bits(power.to_bits().wrapping_add(shifted.to_bits() << 52))
}

/// ln(1 + x) of each number, within two units in the last place of `libm`'s, side by side as [`exp_each`].
#[inline]
pub fn log1p_each<const N: usize>(numbers: [f64; N]) -> [f64; N] {
    if numbers.iter().all(|&x| x > -1.0 && x < 1e300) {
        numbers.map(ordinary_log1p)
    } else {
        numbers.map(log1p)
    }
}

/// By the series of ln((1 + s)/(1 - s)) in s^2, with the coefficients of Sun's fdlibm (e_log.c).
#[inline]
fn ordinary_log1p(x: f64) -> f64 {
    const ATANH_SERIES: [f64; 7] = [
        6.666_666_666_666_735e-1,
        3.999_999_999_940_942e-1,
        2.857_142_874_366_239e-1,
        2.222_219_843_214_978_4e-1,
        1.818_357_216_161_805e-1,
        1.531_383_769_920_937_3e-1,
        1.479_819_860_511_658_6e-1,
    ];
    /// The bits of 1/2^(1/2), and of 1.
    const LEAST: u64 = 0x3FE6_A09E_667F_3BCD;
    const ONE: u64 = 0x3FF0_0000_0000_0000;
    const MANTISSA: u64 = (1 << 52) - 1;
    /// A whole number in the last bits of this one is the difference to it.
    const WHOLE_NUMBERS: f64 = (1u64 << 52) as f64;
    // 1 + x = u (1 + rounding), u = 2^k (1 + f)
    let u = 1.0 + x;
    let rounding = (x - (u - 1.0)) / u;
    let bits = u.to_bits().wrapping_add(ONE - LEAST);
    let k = f64::from_bits((bits >> 52) | WHOLE_NUMBERS.to_bits()) - (WHOLE_NUMBERS + 1023.0);
    let f = f64::from_bits((bits & MANTISSA) + LEAST) - 1.0;
    let s = f / (2.0 + f);
    let (z, c) = (s * s, &ATANH_SERIES);
    let w = z * z;
    let series = z * (c[0] + w * (c[2] + w * (c[4] + w * c[6]))) + w * (c[1] + w * (c[3] + w * c[5]));
    let half = 0.5 * f * f;
    k * LN_2[0] + (f - (half - (s * (half + series) + (rounding + k * LN_2[1]))))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log1p_is_within_two_units_in_the_last_place_of_that_of_libm() {
        let mut worst = 0;
        for i in 1..400_000 {
            let part = f64::from(i) / 400_000.0;
            for x in [-part, part, 1e3 * part, 1e-9 * part, -1e-4 * part, exp(690.0 * part), exp(-690.0 * part) - 1.0] {
                let [log] = log1p_each([x]);
                worst = worst.max(log.to_bits().abs_diff(log1p(x).to_bits()));
            }
        }
        assert!(worst <= 2, "{worst}");
        let numbers = [0.5, -1.0, f64::INFINITY, -0.0, 1e301, 1e-320];
        assert_eq!(log1p_each(numbers).map(f64::to_bits), numbers.map(|x| log1p(x).to_bits()));
    }

    #[test]
    fn exp_is_within_a_unit_in_the_last_place_of_that_of_libm() {
        let mut worst = 0;
        let count = 400_000;
        for i in 0..=count {
            let x = 1420.0 * (f64::from(i) / f64::from(count) - 0.5);
            for x in [x, x / 1000.0, x / 1e6] {
                worst = worst.max(exp(x).to_bits().abs_diff(libm::exp(x).to_bits()));
            }
        }
        assert_eq!(worst, 1);
        for x in [f64::NEG_INFINITY, -1e300, -745.2, -740.0, -0.0, 0.0, 1e-300, 709.7, 709.8, f64::INFINITY, f64::NAN] {
            assert_eq!(exp(x).to_bits(), libm::exp(x).to_bits(), "{x:e}");
        }
    }

    #[test]
    fn a_hypotenuse_neither_overflows_nor_vanishes() {
        for (x, y) in [(3.0, 4.0), (-4e200, 3e200), (0.0, -2.0), (1e-200, 1e-201), (1e-9, 1.0), (0.0, 0.0)] {
            let found = hypot(x, y);
            assert!((found - f64::hypot(x, y)).abs() <= 2.0 * f64::EPSILON * found, "{x:e}, {y:e}: {found:e}");
            assert_eq!(found, hypot(y, x));
        }
    }

    #[test]
    fn many_at_once_have_the_same_bits() {
        let ordinary: [f64; 16] = std::array::from_fn(|i| 90.0 * (i as f64 - 7.3));
        for last in [1.0, -1e4, f64::NAN] {
            let mut numbers = ordinary;
            numbers[15] = last;
            for (x, power) in numbers.into_iter().zip(exp_each(numbers)) {
                assert_eq!(power.to_bits(), exp(x).to_bits(), "{x:e}");
            }
        }
    }
}
