//! Bayes' rule over nodes: what measured points leave of one Gaussian for each, and the quantiles of their mixture.
//!
//! All is of y = ln F. Of a node y at a load is normal, with a mean, and a covariance between loads that `Seen::covariance` has.

use super::known::REACH_95;
use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

/// Inputs that are normal in their logarithms: the slope and the height of the surface, hardness, E; and the slope and the height of
/// the surface that was measured, where it is another.
pub const INPUTS: usize = 6;
/// What makes a variance: these inputs, the strength, the errors of the points, how real interfaces leave the law.
pub const PARTS: usize = INPUTS + 3;

/// What one node makes of a load.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    pub mean: f64,
    /// What y changes by with one standard deviation of each input.
    pub gains: [f64; INPUTS],
    /// Decades of load from the reference.
    pub decades: f64,
}

/// Variances of a node that no input makes.
#[derive(Debug, Clone, Copy)]
pub struct Kernel {
    pub strength: f64,
    pub drift: f64,
    pub wander: f64,
}

impl Kernel {
    /// How real interfaces leave the law.
    fn leaving(&self, one: &Seen, other: &Seen) -> f64 {
        let (d, e) = (one.decades, other.decades);
        let together = if d * e > 0.0 { d.abs().min(e.abs()) } else { 0.0 };
        self.drift * d * e + self.wander * together
    }

    pub fn covariance(&self, one: &Seen, other: &Seen) -> f64 {
        let of_inputs: f64 = one.gains.iter().zip(&other.gains).map(|(a, b)| a * b).sum();
        self.strength + of_inputs + self.leaving(one, other)
    }
}

/// The points as one node sees them, solved for once.
#[derive(Debug, Clone)]
pub struct Solved {
    seen: Vec<Seen>,
    kernel: Kernel,
    /// The covariance of their errors, row by row.
    noise: Vec<f64>,
    /// Cholesky's factor of the covariance of what is measured, row by row.
    factor: Vec<f64>,
    /// The inverse of that covariance times what is measured less the means.
    pull: Vec<f64>,
    /// The same for each specimen that may be the one that was measured, with its probability; none where it was not one.
    devices: Vec<(f64, Vec<f64>)>,
    /// ln of the probability of the points.
    pub log_probability: f64,
    /// What is measured less the means, squared, over that covariance.
    pub misfit: f64,
}

impl Solved {
    pub fn new(seen: Vec<Seen>, kernel: Kernel, measured: &[f64], noise: &[f64]) -> Self {
        let n = seen.len();
        let mut factor = vec![0.0; n * n];
        for i in 0..n {
            for k in 0..=i {
                let before: f64 = (0..k).map(|j| factor[i * n + j] * factor[k * n + j]).sum();
                let rest = kernel.covariance(&seen[i], &seen[k]) + noise[i * n + k] - before;
                factor[i * n + k] = if i == k { rest.max(f64::MIN_POSITIVE).sqrt() } else { rest / factor[k * n + k] };
            }
        }
        let off: Vec<f64> = measured.iter().zip(&seen).map(|(y, seen)| y - seen.mean).collect();
        let pull = solve(&factor, &off);
        let misfit: f64 = pull.iter().zip(&off).map(|(a, b)| a * b).sum();
        let log_root: f64 = (0..n).map(|i| log(factor[i * n + i])).sum();
        let (noise, devices) = (noise.to_vec(), Vec::new());
        Self { log_probability: -0.5 * misfit - log_root, noise, seen, kernel, factor, pull, devices, misfit }
    }

    /// The same of points that were measured on one specimen: `means` has what y would be at the points on each that it may be.
    pub fn on_one_of(mut self, means: impl Iterator<Item = Vec<f64>>, measured: &[f64]) -> Self {
        let log_root = -self.log_probability - 0.5 * self.misfit;
        let of_one = |means: Vec<f64>| {
            let off: Vec<f64> = measured.iter().zip(&means).map(|(y, mean)| y - mean).collect();
            let pull = solve(&self.factor, &off);
            (pull.iter().zip(&off).map(|(a, b)| a * b).sum::<f64>(), pull)
        };
        let mut devices: Vec<_> = means.map(of_one).collect();
        let least = devices.iter().map(|one| one.0).fold(f64::INFINITY, f64::min);
        let all: f64 = devices.iter().map(|one| exp(0.5 * (least - one.0))).sum();
        self.misfit = least - 2.0 * log(all / devices.len() as f64);
        self.log_probability = -0.5 * self.misfit - log_root;
        self.pull.fill(0.0);
        for (weight, pull) in &mut devices {
            *weight = exp(0.5 * (least - *weight)) / all;
            self.pull.iter_mut().zip(pull).for_each(|(sum, pull)| *sum += *weight * *pull);
        }
        self.devices = devices;
        self
    }

    /// Whether the points are of one specimen.
    pub fn has_devices(&self) -> bool {
        !self.devices.is_empty()
    }

    /// Means of y at a load, with their probabilities: `at` has it of the mean of all specimens, `specimens` of single ones, of which each is
    /// the one that was measured, or another.
    pub fn means(&self, at: &Seen, specimens: &[f64], is_another: bool) -> Vec<(f64, f64)> {
        let with: Vec<f64> = self.seen.iter().map(|seen| self.kernel.covariance(seen, at)).collect();
        let pulled = |pull: &[f64]| with.iter().zip(pull).map(|(a, b)| a * b).sum::<f64>();
        let [n, of_devices] = [specimens.len(), self.devices.len()];
        // Another one for each: any order that leaves no specimen where it is.
        let other = |i: usize| if is_another { (37 * i + 11) % of_devices } else { i };
        match (n, of_devices) {
            (0, 0) => vec![(1.0, at.mean + pulled(&self.pull))],
            (_, 0) => specimens.iter().map(|mean| (1.0 / n as f64, mean + pulled(&self.pull))).collect(),
            (0, _) => self.devices.iter().map(|(weight, pull)| (*weight, at.mean + pulled(pull))).collect(),
            _ => (0..n)
                .map(|i| {
                    let (weight, pull) = &self.devices[other(i)];
                    (*weight, specimens[i] + pulled(pull))
                })
                .collect(),
        }
    }

    /// How much of each point is taken for y at a load.
    fn shares_of_points(&self, at: &Seen) -> Vec<f64> {
        let with: Vec<f64> = self.seen.iter().map(|seen| self.kernel.covariance(seen, at)).collect();
        solve(&self.factor, &with)
    }

    pub fn mean(&self, at: &Seen) -> f64 {
        let of_points = self.seen.iter().zip(&self.pull).map(|(seen, pull)| self.kernel.covariance(seen, at) * pull);
        at.mean + of_points.sum::<f64>()
    }

    /// The parts of the variance of y at a load; they add up to it.
    pub fn parts(&self, at: &Seen) -> [f64; PARTS] {
        let shares = self.shares_of_points(at);
        let mut parts = [0.0; PARTS];
        for (input, part) in parts[..INPUTS].iter_mut().enumerate() {
            let told: f64 = shares.iter().zip(&self.seen).map(|(share, seen)| share * seen.gains[input]).sum();
            *part = (at.gains[input] - told) * (at.gains[input] - told);
        }
        let left = 1.0 - shares.iter().sum::<f64>();
        parts[INPUTS] = self.kernel.strength * left * left;
        let rows = shares.iter().zip(self.noise.chunks(shares.len().max(1)));
        let of_row = |row: &[f64]| row.iter().zip(&shares).map(|(noise, share)| noise * share).sum::<f64>();
        parts[INPUTS + 1] = rows.map(|(share, row)| share * of_row(row)).sum();
        let mut leaving = self.kernel.leaving(at, at);
        for (share, seen) in shares.iter().zip(&self.seen) {
            let others: f64 =
                shares.iter().zip(&self.seen).map(|(other, to)| other * self.kernel.leaving(seen, to)).sum();
            leaving += share * (others - 2.0 * self.kernel.leaving(seen, at));
        }
        parts[INPUTS + 2] = leaving.max(0.0);
        parts
    }

    /// The covariance of y at two loads.
    pub fn covariance(&self, one: &Seen, other: &Seen) -> f64 {
        let told = self
            .shares_of_points(one)
            .iter()
            .zip(&self.seen)
            .map(|(a, b)| a * self.kernel.covariance(b, other))
            .sum::<f64>();
        self.kernel.covariance(one, other) - told
    }
}

/// The inverse of a matrix, of which this is Cholesky's factor, times a vector.
fn solve(factor: &[f64], right: &[f64]) -> Vec<f64> {
    let n = right.len();
    let mut x = right.to_vec();
    for i in 0..n {
        let before: f64 = (0..i).map(|k| factor[i * n + k] * x[k]).sum();
        x[i] = (x[i] - before) / factor[i * n + i];
    }
    for i in (0..n).rev() {
        let behind: f64 = (i + 1..n).map(|k| factor[k * n + i] * x[k]).sum();
        x[i] = (x[i] - behind) / factor[i * n + i];
    }
    x
}

/// Normal distributions with their probabilities.
#[derive(Debug, Clone, Default)]
pub struct Mixture(pub Vec<Normal>);

#[derive(Debug, Clone, Copy)]
pub struct Normal {
    pub weight: f64,
    pub mean: f64,
    pub deviation: f64,
}

/// No deviation is smaller.
const SHARPEST: f64 = 1e-12;
/// What is left out of the probability.
const UNLIKELY: f64 = 1e-7;

impl Mixture {
    /// Adds normals of one deviation, with their weights and means: of many those that are next to each other as one.
    pub fn add(&mut self, mut means: Vec<(f64, f64)>, weight: f64, deviation: f64, most: usize) {
        if means.len() > most {
            means.sort_by(|one, other| one.1.total_cmp(&other.1));
        }
        let each = means.len().div_ceil(most);
        self.0.extend(means.chunks(each).map(|alike| {
            let all: f64 = alike.iter().map(|one| one.0).sum();
            let mean = alike.iter().map(|one| one.0 * one.1).sum::<f64>() / all;
            Normal { weight: weight * all, mean, deviation }
        }));
    }

    fn likely(&self) -> impl Iterator<Item = &Normal> {
        self.0.iter().filter(|one| one.weight > UNLIKELY)
    }

    pub fn moments(&self) -> (f64, f64) {
        let mean: f64 = self.0.iter().map(|one| one.weight * one.mean).sum();
        let square =
            |one: &Normal| one.weight * (one.deviation * one.deviation + (one.mean - mean) * (one.mean - mean));
        (mean, self.0.iter().map(square).sum())
    }

    /// The probability that it is below, to 1e-7, and its density there.
    fn below(&self, y: f64) -> (f64, f64) {
        // Abramowitz and Stegun, Handbook of Mathematical Functions, 26.2.17.
        const OF: [f64; 5] = [0.319_381_530, -0.356_563_782, 1.781_477_937, -1.821_255_978, 1.330_274_429];
        let (mut below, mut density, mut all) = (0.0, 0.0, 0.0);
        for one in self.likely() {
            let deviation = one.deviation.max(SHARPEST);
            let off = (y - one.mean) / deviation;
            let bell = exp(-0.5 * off * off) / (2.0 * PI).sqrt();
            let near = 1.0 / (1.0 + 0.231_641_9 * off.abs());
            let outside = bell * OF.iter().rev().fold(0.0, |sum, of| near * (sum + of));
            below += one.weight * if off > 0.0 { 1.0 - outside } else { outside };
            density += one.weight * bell / deviation;
            all += one.weight;
        }
        (below / all, density / all)
    }

    pub fn between(&self, low: f64, high: f64) -> f64 {
        self.below(high).0 - self.below(low).0
    }

    /// What it is below of with a probability: by Newton's method within a bracket that is halved where it leads outside.
    pub fn quantile(&self, probability: f64) -> f64 {
        let ends = |sign: f64| self.likely().map(move |one| one.mean + sign * 40.0 * one.deviation.max(SHARPEST));
        let mut low = ends(-1.0).fold(f64::INFINITY, f64::min);
        let mut high = ends(1.0).fold(f64::NEG_INFINITY, f64::max);
        let (mean, variance) = self.moments();
        let mut y = mean + variance.sqrt() * (probability - 0.5) * 2.0 * REACH_95;
        for _ in 0..200 {
            let (below, density) = self.below(y);
            *(if below > probability { &mut high } else { &mut low }) = y;
            let newton = y - (below - probability) / density;
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - y).abs() <= 1e-12 * (1.0 + y.abs()) {
                return next;
            }
            y = next;
        }
        y
    }
}
