//! The cubic through two points with given slopes.

/// A cubic in Hermite's form.
#[derive(Debug, Clone, Copy)]
pub struct Cubic {
    start: f64,
    width: f64,
    coefficients: [f64; 4],
}

impl Cubic {
    /// Through two points, each as abscissa, value and slope.
    pub fn new((x0, y0, slope0): (f64, f64, f64), (x1, y1, slope1): (f64, f64, f64)) -> Self {
        let width = x1 - x0;
        let (rise, from, to) = (y1 - y0, slope0 * width, slope1 * width);
        Self { start: x0, width, coefficients: [y0, from, 3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise] }
    }

    /// The value at an abscissa.
    #[inline]
    pub fn at(&self, x: f64) -> f64 {
        let t = (x - self.start) / self.width;
        let [a, b, c, d] = self.coefficients;
        a + t * (b + t * (c + t * d))
    }
}

#[cfg(test)]
mod tests {
    use super::Cubic;

    #[test]
    fn a_cubic_is_found_from_its_values_and_slopes() {
        let cubic = |x: f64| 2.0 - x + 0.5 * x * x - 0.3 * x * x * x;
        let slope = |x: f64| -1.0 + x - 0.9 * x * x;
        let found = Cubic::new((-0.5, cubic(-0.5), slope(-0.5)), (2.0, cubic(2.0), slope(2.0)));
        for x in [-0.5, 0.0, 1.3, 2.0] {
            assert!((found.at(x) - cubic(x)).abs() < 1e-14);
        }
    }
}
