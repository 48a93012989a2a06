//! Asperities of a surface that is given by heights and slopes at 13 normal scores, with everything as a function of the raw height.

use std::f64::consts::PI;

const SCORES: usize = 13;
/// Mean and standard deviation of the scores of asperities.
const MEAN: f64 = 1.23;
const SPREAD: f64 = 0.92;

#[derive(Debug, Clone)]
pub struct Scores {
    pub height: Vec<f64>,
    pub slope: Vec<f64>,
    /// ln t and ln s at the scores.
    log_t: Vec<f64>,
    log_s: Vec<f64>,
    /// Of the surface: Sdq^2/Sq, which radii are multiplied by.
    radius: f64,
    /// Of the asperities: all of them, mean, standard deviation.
    all: f64,
    mean: f64,
    deviation: f64,
}

/// A monotone cubic through points, its ends with these slopes: value and slope (Fritsch and Butland 1984).
fn cubic(x: &[f64], y: &[f64], ends: [f64; 2], at: f64) -> (f64, f64) {
    let last = x.len() - 1;
    let step = |i: usize| x[i + 1] - x[i];
    let secant = |i: usize| (y[i + 1] - y[i]) / step(i);
    let slope = |i: usize| {
        if i == 0 || i == last {
            return ends[usize::from(i == last)];
        }
        if secant(i - 1) * secant(i) <= 0.0 {
            return 0.0;
        }
        let (left, right) = (step(i - 1), step(i));
        3.0 * (left + right) / ((2.0 * right + left) / secant(i - 1) + (right + 2.0 * left) / secant(i))
    };
    if at <= x[0] {
        return (y[0] + ends[0] * (at - x[0]), ends[0]);
    }
    if at >= x[last] {
        return (y[last] + ends[1] * (at - x[last]), ends[1]);
    }
    let i = (0..last).rfind(|&i| x[i] <= at).unwrap_or(0);
    let (h, p) = (step(i), (at - x[i]) / step(i));
    let (m0, m1) = (slope(i) * h, slope(i + 1) * h);
    let (p2, p3) = (p * p, p * p * p);
    let value = (2.0 * p3 - 3.0 * p2 + 1.0) * y[i]
        + (p3 - 2.0 * p2 + p) * m0
        + (3.0 * p2 - 2.0 * p3) * y[i + 1]
        + (p3 - p2) * m1;
    let rate = (6.0 * (p2 - p) * (y[i] - y[i + 1]) + (3.0 * p2 - 4.0 * p + 1.0) * m0 + (3.0 * p2 - 2.0 * p) * m1) / h;
    (value, rate)
}

fn scores() -> Vec<f64> {
    (0..SCORES).map(|i| 0.5 * i as f64 - 3.0).collect()
}

fn normal(u: f64) -> f64 {
    (-0.5 * u * u).exp() / (2.0 * PI).sqrt()
}

impl Scores {
    pub fn new(height: Vec<f64>, slope: Vec<f64>) -> Self {
        let rise = |i: usize| {
            let (from, to) = (i.saturating_sub(1), (i + 1).min(SCORES - 1));
            (height[to] - height[from]) / (0.5 * (to - from) as f64)
        };
        let rises: Vec<f64> = (0..SCORES).map(rise).collect();
        let log_s = slope.iter().map(|s| 2.0 * s.ln()).collect();
        let log_t = rises.iter().map(|t| t.ln()).collect();
        let mut found = Self { height, slope, log_t, log_s, radius: 1.0, all: 1.0, mean: 0.0, deviation: 1.0 };
        let height_of = |found: &Self| {
            let [mean, square, slope] = found.integrals(|x, s, _| [x * s, x * x * s, found.at(x).3.exp() * s]);
            ((square - mean * mean).sqrt(), slope)
        };
        let least = 0.15 * height_of(&found).0;
        found.log_t = rises.iter().map(|t| 0.25 * (t.powi(4) + least.powi(4)).ln()).collect();
        let (deviation, slope) = height_of(&found);
        found.radius = slope / deviation;
        let [all, first, second] = found.integrals(|x, _, a| [a, x * a, x * x * a]);
        (found.all, found.mean) = (all, first / all);
        found.deviation = (second / all - found.mean * found.mean).sqrt();
        found
    }

    /// Score, its slope, ln t and ln s at a raw height.
    fn at(&self, x: f64) -> (f64, f64, f64, f64) {
        let ends = [0, SCORES - 1].map(|i| (-self.log_t[i]).exp());
        let (g, rate) = cubic(&self.height, &scores(), ends, x);
        let level = |values: &[f64]| cubic(&scores(), values, [0.0; 2], g).0;
        (g, rate, level(&self.log_t), level(&self.log_s))
    }

    /// Integrals over raw height of what is made of it, and of the densities of the surface and of the asperities.
    fn integrals(&self, of: impl Fn(f64, f64, f64) -> [f64; 3]) -> [f64; 3] {
        const POINTS: i32 = 400;
        let [below, above] = [0, SCORES - 1].map(|i| self.log_t[i].exp());
        let mut ends = self.height.clone();
        for i in 1..=13 {
            ends.insert(0, self.height[0] - below * f64::from(i));
            ends.push(self.height[SCORES - 1] + above * f64::from(i));
        }
        let mut sums = [0.0; 3];
        for ends in ends.windows(2) {
            // Nodes of tanh-sinh.
            for i in -POINTS..=POINTS {
                let t = 3.2 * f64::from(i) / f64::from(POINTS);
                let y = 0.5 * PI * t.sinh();
                let weight =
                    0.5 * PI * t.cosh() / y.cosh().powi(2) * 3.2 / f64::from(POINTS) * 0.5 * (ends[1] - ends[0]);
                let x = 0.5 * (ends[0] + ends[1]) + 0.5 * (ends[1] - ends[0]) * y.tanh();
                let (g, rate, _, _) = self.at(x);
                let values = of(x, normal(g) * rate, self.asperities(x));
                sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        sums
    }

    /// The density of asperities at a raw height, but for a factor.
    fn asperities(&self, x: f64) -> f64 {
        self.log_asperities(x).exp()
    }

    fn log_asperities(&self, x: f64) -> f64 {
        let (g, rate, log_t, log_s) = self.at(x);
        let u = (g - MEAN) / SPREAD;
        -0.5 * u * u - 0.5 * (2.0 * PI).ln() + (rate / SPREAD).ln() + log_s - 2.0 * log_t
    }

    fn raw(&self, z: f64) -> f64 {
        self.mean + self.deviation * z
    }

    pub fn log_density(&self, z: f64) -> f64 {
        self.log_asperities(self.raw(z)) + (self.deviation / self.all).ln()
    }

    /// The score u of an asperity, and what its radius is multiplied by there.
    pub fn radius(&self, z: f64) -> (f64, f64) {
        let (g, _, log_t, log_s) = self.at(self.raw(z));
        ((g - MEAN) / SPREAD, (log_t - log_s).exp() * self.radius)
    }

    /// The height of a score u beyond all of the table, and the heights of the table.
    pub fn beyond(&self, u: f64) -> f64 {
        let i = if u < 0.0 { 0 } else { SCORES - 1 };
        let g = MEAN + SPREAD * u;
        (self.height[i] + self.log_t[i].exp() * (g - scores()[i]) - self.mean) / self.deviation
    }

    /// The height of a score u.
    pub fn height_of(&self, u: f64) -> f64 {
        let (mut lower, mut upper) = (self.beyond(-14.0), self.beyond(14.0));
        for _ in 0..60 {
            let middle = 0.5 * (lower + upper);
            *(if self.radius(middle).0 < u { &mut lower } else { &mut upper }) = middle;
        }
        upper
    }

    pub fn knots(&self) -> Vec<f64> {
        self.height.iter().map(|x| (x - self.mean) / self.deviation).collect()
    }
}
