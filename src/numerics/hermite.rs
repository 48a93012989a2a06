//! The cubic through two points with given slopes, and slopes with which such cubics are monotone where their points are.

use super::elementary::hypot;

/// A cubic in Hermite's form.
#[derive(Debug, Clone, Copy)]
pub struct Cubic {
    start: f64,
    width: f64,
    per_width: f64,
    coefficients: [f64; 4],
}

impl Cubic {
    /// Through two points, each as abscissa, value and slope.
    pub fn new((x0, y0, slope0): (f64, f64, f64), (x1, y1, slope1): (f64, f64, f64)) -> Self {
        let width = x1 - x0;
        let (rise, from, to) = (y1 - y0, slope0 * width, slope1 * width);
        let coefficients = [y0, from, 3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise];
        Self { start: x0, width, per_width: 1.0 / width, coefficients }
    }

    /// The value at an abscissa.
    #[inline]
    pub fn at(&self, x: f64) -> f64 {
        let t = (x - self.start) * self.per_width;
        let [a, b, c, d] = self.coefficients;
        a + t * (b + t * (c + t * d))
    }

    /// This cubic times a factor, and another on the same interval times another.
    pub fn combined(&self, times: f64, other: &Self, plus: f64) -> Self {
        let pairs = std::array::from_fn(|i| times * self.coefficients[i] + plus * other.coefficients[i]);
        Self { coefficients: pairs, ..*self }
    }

    /// What the value changes by over the interval, one way and back, at most.
    pub fn change(&self) -> f64 {
        self.coefficients[1..].iter().map(|coefficient| coefficient.abs()).sum()
    }

    /// The same, higher by an amount.
    pub fn raised(mut self, by: f64) -> Self {
        self.coefficients[0] += by;
        self
    }

    /// Value, first and second derivative at an abscissa.
    #[inline]
    pub fn rates(&self, x: f64) -> [f64; 3] {
        let t = (x - self.start) * self.per_width;
        let [a, b, c, d] = self.coefficients;
        let value = a + t * (b + t * (c + t * d));
        let slope = (b + t * (2.0 * c + 3.0 * t * d)) * self.per_width;
        [value, slope, (2.0 * c + 6.0 * t * d) * (self.per_width * self.per_width)]
    }

    /// How far an abscissa is from the nearest point, real or complex, at which the slope is 0.
    pub fn distance_to_turn(&self, x: f64) -> f64 {
        let [_, b, c, d] = self.coefficients;
        let t = (x - self.start) * self.per_width;
        // The roots of 3 d t^2 + 2 c t + b, and the one of a parabola where d is next to nothing.
        let discriminant = c * c - 3.0 * d * b;
        let distance = if discriminant < 0.0 {
            hypot(t + c / (3.0 * d), discriminant.abs().sqrt() / (3.0 * d))
        } else {
            // Of a straight line one is no number, and left out.
            let far = -c - discriminant.sqrt().copysign(c);
            (t - far / (3.0 * d)).abs().min((t - b / far).abs())
        };
        self.width * distance
    }
}

/// The slope at a point between two others, from the secants to both and how far they are: a harmonic mean, 0 at an extremum
/// (Fritsch and Butland, SIAM J. Sci. Stat. Comput. 5, 1984, 300-304).
pub fn monotone_slope((left, before): (f64, f64), (right, after): (f64, f64)) -> f64 {
    if before.signum() != after.signum() {
        return 0.0;
    }
    let (w1, w2) = (2.0 * right + left, right + 2.0 * left);
    (w1 + w2) / (w1 / before + w2 / after)
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
