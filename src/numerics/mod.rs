//! Numerical methods that know nothing of contacts: elementary functions, the bits of numbers, four numbers side by side,
//! quadrature, interpolation and roots.

pub mod elementary;
pub mod float_bits;
pub mod four;
pub mod hermite;
pub mod legendre;
pub mod neighbours;
pub mod quadrature;
#[cfg(test)]
pub mod random;
pub mod root;

/// The indices of numbers in ascending order, equal ones as they were. Sorting is compiled here alone: a copy takes 6 kB.
#[inline(never)]
pub fn ascending(numbers: &[f64]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..numbers.len()).collect();
    order.sort_by(|&a, &b| numbers[a].total_cmp(&numbers[b]));
    order
}

/// Whether two numbers are equal to this part of the second.
#[cfg(test)]
pub(crate) fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}
