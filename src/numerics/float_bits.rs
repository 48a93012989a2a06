//! What kind of number a float is, told by its bits: a comparison with a signalling NaN would raise a floating-point
//! exception.

/// Bits of a double below its exponent.
pub const MANTISSA_BITS: u32 = f64::MANTISSA_DIGITS - 1;

/// 2^e of a biased exponent.
#[inline]
pub const fn power_of_two(exponent: u64) -> f64 {
    f64::from_bits(exponent << MANTISSA_BITS)
}

pub fn finite(x: f64) -> bool {
    x.to_bits() << 1 < 0x7ff << 53
}

/// Numbers are tame up to this: the difference of two of them is finite, however it is rounded.
pub const TAMEST: f64 = 0.5 * f64::MAX;

/// Whether the size of a number is below 2^1023: by bits, as above.
pub fn tame(x: f64) -> bool {
    x.to_bits() << 1 < 0x7fe << 53
}

/// Whether a number is finite and at most a bound > 0. By bits also for the bound: the compiler may compare numbers ahead of a test
/// whether they are finite, and a signalling NaN would raise a floating-point exception there.
pub fn finite_up_to(x: f64, bound: f64) -> bool {
    finite(x) && x.to_bits() as i64 <= bound.to_bits() as i64
}

/// Positive numbers between these are moderate: 2^-500 and 2^500. Products and quotients of two neither overflow nor underflow.
pub const MODERATE: [f64; 2] = [power_of_two(1023 - 500), power_of_two(1023 + 500)];

pub fn moderate(x: f64) -> bool {
    (MODERATE[0].to_bits()..=MODERATE[1].to_bits()).contains(&x.to_bits())
}

/// Plus infinity.
pub fn infinite(x: f64) -> bool {
    x.to_bits() == f64::INFINITY.to_bits()
}

pub fn nan(x: f64) -> bool {
    x.to_bits() << 1 > 0x7ff << 53
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::neighbours::Neighbours;

    #[test]
    fn moderate_numbers_are_positive_and_far_from_overflow() {
        let [least, most] = [2.0_f64.powi(-500), 2.0_f64.powi(500)];
        for (x, is_moderate) in
            [(least, true), (1.0, true), (most, true), (least.below(), false), (most.above(), false)]
        {
            assert!(moderate(x) == is_moderate && !moderate(-x), "{x:e}");
        }
        assert!(![0.0, -0.0, f64::INFINITY, f64::NAN].into_iter().any(moderate));
    }

    #[test]
    fn neighbours_are_one_bit_away() {
        assert_eq!((1.0.above(), 1.0.below()), (1.0 + f64::EPSILON, 1.0 - 0.5 * f64::EPSILON));
        assert_eq!((0.0.above(), 0.0.below(), f64::MAX.above()), (5e-324, -5e-324, f64::INFINITY));
    }

    #[test]
    fn numbers_are_told_apart_by_their_bits() {
        let signalling = f64::from_bits(0x7ff0_0000_0000_0001);
        for x in [f64::NAN, -f64::NAN, signalling, -signalling] {
            assert!(nan(x) && !finite(x) && !infinite(x), "{:x}", x.to_bits());
        }
        for x in [f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!nan(x) && !finite(x) && infinite(x) == (x > 0.0), "{x}");
        }
        for x in [0.0, -0.0, 5e-324, -1.0, 1.5, f64::MAX, f64::MIN] {
            assert!(!nan(x) && finite(x) && !infinite(x), "{x}");
            assert_eq!(tame(x), x.abs() <= TAMEST, "{x}");
        }
        assert!(tame(TAMEST) && tame(-TAMEST) && !tame(TAMEST.above()) && !tame(f64::NAN));
    }
}
