//! What kind of number a float is, told by its bits: a comparison with a signalling NaN would raise a floating-point
//! exception.

pub fn finite(x: f64) -> bool {
    x.to_bits() << 1 < 0x7ff << 53
}

/// Plus infinity.
pub fn infinite(x: f64) -> bool {
    x.to_bits() == f64::INFINITY.to_bits()
}

pub fn nan(x: f64) -> bool {
    x.to_bits() << 1 > 0x7ff << 53
}

/// The numbers next to a number. The standard library has them from Rust 1.86 on.
pub trait Neighbours {
    /// The next larger one.
    fn above(self) -> Self;
    /// The next smaller one.
    fn below(self) -> Self;
}

impl Neighbours for f64 {
    fn above(self) -> f64 {
        libm::nextafter(self, f64::INFINITY)
    }
    fn below(self) -> f64 {
        libm::nextafter(self, f64::NEG_INFINITY)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
        }
    }
}
