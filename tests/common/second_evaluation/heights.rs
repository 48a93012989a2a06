//! Standardised height distributions a second time. A family that the library gains becomes a variant here: its log
//! density, where it begins, which heights matter, where it is not smooth.

use super::scores::Scores;
use std::f64::consts::PI;

/// Contributions below exp of minus this of the largest are left out.
const NEGLIGIBLE: f64 = 60.0;

#[derive(Debug, Clone)]
pub enum Heights {
    Gaussian,
    /// `rate` is C of eq (20), `mean` z_M.
    Weibull {
        shape: f64,
        rate: f64,
        mean: f64,
    },
    /// A curve of Johnson's system in its classical form.
    Johnson(Johnson),
    /// Heights and densities at them, standardised, with the density between.
    Table(Table),
    /// A surface at normal scores.
    Scores(Scores),
}

/// Heights z of which u = gamma + delta f(mean + deviation z) is normal, with f(y) = arsinh y, or ln(y/(1 - y)) where
/// heights are bounded.
#[derive(Debug, Clone)]
pub struct Johnson {
    bounded: bool,
    gamma: f64,
    delta: f64,
    mean: f64,
    deviation: f64,
    pub skew: f64,
    pub kurtosis: f64,
}

impl Johnson {
    /// The moments of y are sums over u, where the trapezium rule converges exponentially.
    pub fn new(bounded: bool, gamma: f64, delta: f64) -> Self {
        let mut curve = Self { bounded, gamma, delta, mean: 0.0, deviation: 1.0, skew: 0.0, kurtosis: 0.0 };
        let last = (16.0 * (13.0 + 4.0 / delta)) as i32;
        let expectation = |f: &dyn Fn(f64) -> f64| {
            let nodes = (-last..=last).map(|i| f64::from(i) / 16.0);
            let (sum, weights) = nodes.fold((0.0, 0.0), |(sum, weights), u| {
                let weight = (-0.5 * u * u).exp();
                (sum + weight * f(u), weights + weight)
            });
            sum / weights
        };
        let above_median = expectation(&|u| curve.above_median(u));
        let central = |power: i32| expectation(&|u| (curve.above_median(u) - above_median).powi(power));
        let deviation = central(2).sqrt();
        let (skew, kurtosis) = (central(3) / deviation.powi(3), central(4) / deviation.powi(4));
        let mean = curve.y(0.0) + above_median;
        (curve.mean, curve.deviation, curve.skew, curve.kurtosis) = (mean, deviation, skew, kurtosis);
        curve
    }

    /// y of a u less that of 0, to all digits: far tails magnify the last ones of the moments.
    fn above_median(&self, u: f64) -> f64 {
        let (median, half) = (-self.gamma / self.delta, 0.5 * u / self.delta);
        if self.bounded {
            half.sinh() / (2.0 * (0.5 * median).cosh() * (0.5 * median + half).cosh())
        } else {
            2.0 * half.sinh() * (median + half).cosh()
        }
    }

    fn y(&self, u: f64) -> f64 {
        let t = (u - self.gamma) / self.delta;
        if self.bounded {
            1.0 / (1.0 + (-t).exp())
        } else {
            t.sinh()
        }
    }

    /// The height of a u.
    fn height(&self, u: f64) -> f64 {
        (self.y(u) - self.mean) / self.deviation
    }

    /// u at a height and du/dz; infinite beyond the ends.
    fn normal(&self, z: f64) -> (f64, f64) {
        let y = self.mean + self.deviation * z;
        let (f, rate) = if !self.bounded {
            (y.asinh(), 1.0 / y.hypot(1.0))
        } else if y > 0.0 && y < 1.0 {
            ((y / (1.0 - y)).ln(), 1.0 / (y * (1.0 - y)))
        } else {
            (if y > 0.0 { f64::INFINITY } else { f64::NEG_INFINITY }, 0.0)
        };
        (self.gamma + self.delta * f, self.delta * rate * self.deviation)
    }

    fn log_density(&self, z: f64) -> f64 {
        let (u, rate) = self.normal(z);
        if rate == 0.0 {
            return f64::NEG_INFINITY;
        }
        -0.5 * u * u + rate.ln() - 0.5 * (2.0 * PI).ln()
    }
}

/// The cumulative distribution is a cubic between knots, with the densities as slopes: `pieces` are the coefficients of
/// its derivative in the part of the way.
#[derive(Debug, Clone)]
pub struct Table {
    pub height: Vec<f64>,
    pub density: Vec<f64>,
    knots: Vec<f64>,
    pieces: Vec<[f64; 3]>,
}

impl Table {
    /// Of a table whose first and last density but one are not zero.
    pub fn new(height: Vec<f64>, density: Vec<f64>) -> Self {
        let n = height.len() - 1;
        let step = |i: usize| height[i + 1] - height[i];
        let secant = |i: usize| (density[i + 1] - density[i]) / step(i);
        // Weighted harmonic means of the secants beside a knot (Fritsch and Butland 1984).
        let slope = |i: usize| match i {
            0 => secant(0),
            i if i == n => secant(n - 1),
            i if secant(i - 1) * secant(i) <= 0.0 => 0.0,
            i => {
                let (left, right) = (step(i - 1), step(i));
                3.0 * (left + right) / ((2.0 * right + left) / secant(i - 1) + (right + 2.0 * left) / secant(i))
            }
        };
        let mut pieces = Vec::new();
        for i in 0..n {
            let (from, to) = (density[i], density[i + 1]);
            let (mean, third) = (0.5 * (from + to), (to - from).abs() / 6.0);
            let mass = (mean - step(i) * (slope(i + 1) - slope(i)) / 12.0).clamp(mean - third, mean + third);
            pieces.push([from, 6.0 * mass - 4.0 * from - 2.0 * to, 3.0 * (from + to) - 6.0 * mass]);
        }
        // Integrals of density times (height - middle)^0, 1, 2.
        let middle = 0.5 * (height[0] + height[n]);
        let mut moments = [0.0; 3];
        for (i, [a, b, c]) in pieces.iter().enumerate() {
            let (h, x) = (step(i), height[i] - middle);
            let part = [a + b / 2.0 + c / 3.0, a / 2.0 + b / 3.0 + c / 4.0, a / 3.0 + b / 4.0 + c / 5.0];
            moments[0] += h * part[0];
            moments[1] += h * (x * part[0] + h * part[1]);
            moments[2] += h * (x * x * part[0] + 2.0 * x * h * part[1] + h * h * part[2]);
        }
        let mean = moments[1] / moments[0];
        let deviation = (moments[2] / moments[0] - mean * mean).sqrt();
        let knots = height.iter().map(|x| (x - middle - mean) / deviation).collect();
        let scale = deviation / moments[0];
        let pieces = pieces.into_iter().map(|piece| piece.map(|c| c * scale)).collect();
        Self { height, density, knots, pieces }
    }

    fn density(&self, z: f64) -> f64 {
        let above = self.knots.partition_point(|&knot| knot < z);
        if above == 0 || above == self.knots.len() {
            return 0.0;
        }
        let (from, to) = (self.knots[above - 1], self.knots[above]);
        let t = (z - from) / (to - from);
        let [a, b, c] = self.pieces[above - 1];
        a + t * (b + t * c)
    }
}

impl Heights {
    /// Weibull heights of a shape. With x exponentially distributed y = x^(1/omega) has the moments B_n; mean and variance
    /// are sums over t = ln x, where the trapezium rule converges doubly exponentially. Taken about 1, nothing cancels.
    pub fn weibull(shape: f64) -> Self {
        let expectation = |f: &dyn Fn(f64) -> f64| {
            let step = 1.0 / 64.0;
            (-45 * 64..4 * 64).map(|i| f64::from(i) * step).map(|t| step * (t - t.exp()).exp() * f(t)).sum::<f64>()
        };
        let above_one = expectation(&|t| (t / shape).exp_m1());
        let variance = expectation(&|t| ((t / shape).exp_m1() - above_one).powi(2));
        let rate = variance.sqrt();
        Heights::Weibull { shape, rate, mean: (1.0 + above_one) / rate }
    }

    pub fn log_density(&self, z: f64) -> f64 {
        match *self {
            Heights::Gaussian => -0.5 * z * z - 0.5 * (2.0 * PI).ln(),
            Heights::Weibull { shape, rate, mean } => {
                let y = rate * (z + mean);
                if y <= 0.0 {
                    return f64::NEG_INFINITY;
                }
                (shape * rate).ln() + (shape - 1.0) * y.ln() - y.powf(shape)
            }
            Heights::Johnson(ref curve) => curve.log_density(z),
            Heights::Table(ref table) => table.density(z).max(0.0).ln(),
            Heights::Scores(ref scores) => scores.log_density(z),
        }
    }

    /// Where the support begins.
    pub fn foot(&self) -> f64 {
        match *self {
            Heights::Gaussian | Heights::Scores(_) => f64::NEG_INFINITY,
            Heights::Weibull { mean, .. } => -mean,
            Heights::Johnson(ref curve) => curve.height(f64::NEG_INFINITY),
            Heights::Table(ref table) => table.knots[0],
        }
    }

    /// The heights at or above one that are not negligible, and ln of the largest density among them.
    pub fn range(&self, lowest: f64) -> (f64, f64, f64) {
        match *self {
            Heights::Gaussian => {
                let half = (2.0 * NEGLIGIBLE).sqrt();
                let lower = lowest.max(-half);
                (lower, lower.max(0.0).hypot(half), self.log_density(lower.max(0.0)))
            }
            Heights::Weibull { shape, rate, mean } => {
                let lower = lowest.max(-mean);
                let mode = ((shape - 1.0) / shape).powf(1.0 / shape) / rate - mean;
                let hazard = (rate * (lower + mean)).powf(shape);
                let upper = (hazard + NEGLIGIBLE).powf(1.0 / shape) / rate - mean;
                (lower, upper, self.log_density(lower.max(mode)))
            }
            Heights::Johnson(ref curve) => {
                let half = (2.0 * NEGLIGIBLE).sqrt();
                let lower = lowest.max(curve.height(-half));
                // Load grows as height^(3/2): as exp(1.5 u/delta) where there is no end.
                let upper = curve.height(curve.normal(lower).0.max(0.0).hypot(half) + 2.0 / curve.delta);
                let largest = (-80..=80)
                    .map(|i| curve.height(0.05 * f64::from(i)))
                    .filter(|z| *z > lower)
                    .chain([lower])
                    .map(|z| curve.log_density(z))
                    .fold(-1e300, f64::max);
                (lower, upper.max(lower), largest)
            }
            Heights::Table(ref table) => {
                let (foot, head) = (table.knots[0], table.knots[table.knots.len() - 1]);
                let lower = lowest.clamp(foot, head);
                let knots = table.knots.iter().copied().filter(|z| *z > lower);
                let largest = knots.chain([lower, 0.5 * (lower + head)]).map(|z| table.density(z)).fold(0.0, f64::max);
                (lower, head, largest.max(1e-300).ln())
            }
            Heights::Scores(ref scores) => {
                let half = (2.0 * NEGLIGIBLE).sqrt();
                let lower = lowest.max(scores.beyond(-half));
                let upper = scores.beyond(scores.radius(lower).0.max(0.0).hypot(half) + 2.0).max(lower);
                let largest = (0..=400)
                    .map(|i| lower + (upper - lower) * f64::from(i) / 400.0)
                    .chain(scores.knots().into_iter().filter(|z| *z > lower))
                    .map(|z| scores.log_density(z))
                    .fold(-1e300, f64::max);
                (lower, upper, largest)
            }
        }
    }

    /// Heights at which integrals are cut, so that no piece is much longer than what varies in it.
    pub fn cuts(&self) -> Vec<f64> {
        match *self {
            Heights::Gaussian => vec![-4.0, -1.5, 1.5, 4.0],
            Heights::Weibull { shape, rate, mean } => [1e-6, 1e-3, 0.1, 1.0, 5.0, 20.0]
                .iter()
                .map(|hazard: &f64| hazard.powf(1.0 / shape) / rate - mean)
                .collect(),
            Heights::Johnson(ref curve) => {
                [-8.0, -4.0, -1.5, 0.0, 1.5, 4.0, 8.0].iter().map(|&u| curve.height(u)).collect()
            }
            Heights::Table(ref table) => table.knots.clone(),
            Heights::Scores(ref scores) => {
                let beyond = [-12.0, -8.0, -6.0, -5.0, 2.5, 4.0, 6.0, 8.0, 12.0].map(|u| scores.beyond(u));
                scores.knots().into_iter().chain(beyond).collect()
            }
        }
    }
}
