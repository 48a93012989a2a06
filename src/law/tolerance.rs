//! How well panels of the curve and rows of the table must meet what they are made from.

/// The largest error of friction, relative, of a logarithm or of the coordinate of loads.
pub const VALUE: f64 = 1.2e-7;
/// The largest relative error of a slope of these.
pub const SLOPE: f64 = 2.5e-5;
/// The largest error of a table that a model may have: what is said of every model.
pub const MOST: f64 = 1e-6;

/// The larger of two errors, infinite if either is no number.
pub fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::INFINITY
    } else {
        a.max(b)
    }
}
