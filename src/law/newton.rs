//! Newton's form of polynomials.

/// Its coefficients from values at nodes, in ascending or descending order. A node that is there twice has a slope too.
#[inline(always)] // where nodes are constants, so are their distances
pub fn newton<const N: usize>(nodes: &[f64; N], values: [f64; N], slopes: &[f64; N]) -> [f64; N] {
    let mut coefficients = values;
    for order in 1..N {
        for i in (order..N).rev() {
            let width = nodes[i] - nodes[i - order];
            let rise = coefficients[i] - coefficients[i - 1];
            coefficients[i] = if width != 0.0 { rise / width } else { slopes[i] };
        }
    }
    coefficients
}
