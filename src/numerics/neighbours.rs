//! The numbers next to a number, which the standard library has from Rust 1.86 on. The tests and the fuzzing include this
//! file too.

/// Steps by one unit in the last place.
pub trait Neighbours {
    /// The next larger number.
    fn above(self) -> Self;
    /// The next smaller number.
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
