//! Numerical methods that know nothing of contacts: quadrature, interpolation and roots.

pub mod hermite;
pub mod quadrature;
pub mod root;

/// Whether two numbers are equal to this part of the second.
#[cfg(test)]
pub(crate) fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}
