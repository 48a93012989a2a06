//! Bayes' rule over nodes: what measured points leave of one Gaussian for each, and the quantiles of their mixture.
//!
//! All is of y = ln F. Of a node y at a load is normal, with a mean, and a covariance between loads that `Seen::covariance` has.

use super::known::REACH_95;
use crate::numerics::ascending;
use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

/// What is normal in its logarithm: the slope and the height of the surface, hardness, E; the slope and the height of the surface that was
/// measured, where it is another; the strength of the interface; and how far the area of the law is off.
pub const INPUTS: usize = 8;
/// What makes a variance: these, the errors of the points, how real interfaces leave the law.
pub const PARTS: usize = INPUTS + 2;

/// Means with their probabilities.
pub type Means = Vec<(f64, f64)>;

/// What one node makes of a load.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    pub mean: f64,
    /// What y changes by with one standard deviation of each input.
    pub gains: [f64; INPUTS],
    /// Decades of load from the reference.
    pub decades: f64,
}

/// How real interfaces leave the law, as variances a decade.
#[derive(Debug, Clone, Copy)]
pub struct Kernel {
    pub drift: f64,
    pub wander: f64,
}

impl Kernel {
    fn leaving(&self, one: &Seen, other: &Seen) -> f64 {
        let (d, e) = (one.decades, other.decades);
        let together = if d * e > 0.0 { d.abs().min(e.abs()) } else { 0.0 };
        self.drift * d * e + self.wander * together
    }

    pub fn covariance(&self, one: &Seen, other: &Seen) -> f64 {
        let of_inputs: f64 = one.gains.iter().zip(&other.gains).map(|(a, b)| a * b).sum();
        of_inputs + self.leaving(one, other)
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
    /// The same for each specimen that may be the one that was measured, one after another, and their probabilities; none where it was not
    /// one.
    pulls: Vec<f64>,
    devices: Vec<f64>,
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
        let mut pull = off.clone();
        solve(&factor, &mut pull);
        let misfit: f64 = pull.iter().zip(&off).map(|(a, b)| a * b).sum();
        let log_root: f64 = (0..n).map(|i| log(factor[i * n + i])).sum();
        let (noise, log_probability) = (noise.to_vec(), -0.5 * misfit - log_root);
        Self { log_probability, noise, seen, kernel, factor, pull, pulls: Vec::new(), devices: Vec::new(), misfit }
    }

    /// The same of points that were measured on one specimen: `means` has what y would be at the points on each of so many that it may be.
    pub fn on_one_of(mut self, count: usize, mean: impl Fn(usize, usize) -> f64, measured: &[f64]) -> Self {
        let log_root = -self.log_probability - 0.5 * self.misfit;
        let n = measured.len();
        let mut off = vec![0.0; n];
        self.pulls.reserve(n * count);
        self.devices = (0..count)
            .map(|one| {
                off.iter_mut().enumerate().for_each(|(i, off)| *off = measured[i] - mean(i, one));
                self.pulls.extend(&off);
                let pull = &mut self.pulls[n * one..];
                solve(&self.factor, pull);
                pull.iter().zip(&off).map(|(a, b)| a * b).sum::<f64>()
            })
            .collect();
        let least = self.devices.iter().copied().fold(f64::INFINITY, f64::min);
        self.devices.iter_mut().for_each(|one| *one = exp(0.5 * (least - *one)));
        let all: f64 = self.devices.iter().sum();
        self.misfit = least - 2.0 * log(all / count as f64);
        self.log_probability = -0.5 * self.misfit - log_root;
        self.pull.fill(0.0);
        for (weight, pull) in self.devices.iter_mut().zip(self.pulls.chunks(n)) {
            *weight /= all;
            self.pull.iter_mut().zip(pull).for_each(|(sum, pull)| *sum += *weight * *pull);
        }
        self
    }

    /// Whether the points are of one specimen.
    pub fn has_devices(&self) -> bool {
        !self.devices.is_empty()
    }

    /// Means of y at a load, with their probabilities: `at` has it of the mean of all specimens, `specimens` of single ones, but for a rise, of
    /// which each is the one that was measured.
    pub fn means(&self, at: &Seen, (specimens, rise): (&[f64], f64)) -> Means {
        let n = self.devices.len();
        if n == 0 {
            let by = self.mean(at) - at.mean;
            let each = 1.0 / specimens.len() as f64;
            return match specimens {
                [] => vec![(1.0, at.mean + by)],
                some => some.iter().map(|mean| (each, mean + rise + by)).collect(),
            };
        }
        let mean = |i: usize| specimens.get(i).map_or(at.mean, |mean| mean + rise);
        self.pulled(at).enumerate().map(|(i, by)| (self.devices[i], mean(i) + by)).collect()
    }

    /// The same of other specimens than the one that was measured, in ascending order: all with all, as few pairs stand for them, those of a
    /// lattice, from the least to the largest of both; `order` is that of what the points add.
    pub fn means_of_others(&self, at: &Seen, (specimens, rise): (&[f64], f64), order: &[usize]) -> Means {
        let (n, by) = (self.devices.len(), self.pulled(at).collect::<Vec<_>>());
        let step = (0.618 * n as f64).round() as usize;
        let mean = |i: usize| specimens.get(i).map_or(at.mean, |mean| mean + rise);
        (0..n).map(|i| (i, order[(i * step + n / 2) % n])).map(|(i, k)| (self.devices[k], mean(i) + by[k])).collect()
    }

    /// What the points add to y, of each specimen that may be the one that was measured.
    pub fn pulled<'a>(&'a self, at: &Seen) -> impl Iterator<Item = f64> + 'a {
        let with = self.with_points(at);
        self.pulls.chunks(with.len().max(1)).map(move |pull| with.iter().zip(pull).map(|(a, b)| a * b).sum())
    }

    /// The covariance of y at a load with that at each point.
    fn with_points(&self, at: &Seen) -> Vec<f64> {
        self.seen.iter().map(|seen| self.kernel.covariance(seen, at)).collect()
    }

    /// How much of each point is taken for y at a load.
    fn shares_of_points(&self, at: &Seen) -> Vec<f64> {
        let mut with = self.with_points(at);
        solve(&self.factor, &mut with);
        with
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
        let rows = shares.iter().zip(self.noise.chunks(shares.len().max(1)));
        let of_row = |row: &[f64]| row.iter().zip(&shares).map(|(noise, share)| noise * share).sum::<f64>();
        parts[INPUTS] = rows.map(|(share, row)| share * of_row(row)).sum();
        let mut leaving = self.kernel.leaving(at, at);
        for (share, seen) in shares.iter().zip(&self.seen) {
            let others: f64 =
                shares.iter().zip(&self.seen).map(|(other, to)| other * self.kernel.leaving(seen, to)).sum();
            leaving += share * (others - 2.0 * self.kernel.leaving(seen, at));
        }
        parts[INPUTS + 1] = leaving.max(0.0);
        parts
    }

    /// The covariance of y at two loads.
    pub fn covariance(&self, one: &Seen, other: &Seen) -> f64 {
        let shares = self.shares_of_points(one);
        let told = shares.iter().zip(&self.seen).map(|(a, b)| a * self.kernel.covariance(b, other));
        self.kernel.covariance(one, other) - told.sum::<f64>()
    }
}

/// The inverse of a matrix, of which this is Cholesky's factor, times a vector, in its place.
fn solve(factor: &[f64], x: &mut [f64]) {
    let n = x.len();
    for i in 0..n {
        let before: f64 = (0..i).map(|k| factor[i * n + k] * x[k]).sum();
        x[i] = (x[i] - before) / factor[i * n + i];
    }
    for i in (0..n).rev() {
        let behind: f64 = (i + 1..n).map(|k| factor[k * n + i] * x[k]).sum();
        x[i] = (x[i] - behind) / factor[i * n + i];
    }
}

/// Distributions with their probabilities: each normal, or, of what is a sum of which only a part is in doubt, normal in the logarithm of
/// that part.
#[derive(Debug, Clone, Default)]
pub struct Mixture(pub Vec<Normal>);

#[derive(Debug, Clone, Copy)]
pub struct Normal {
    pub weight: f64,
    pub mean: f64,
    pub deviation: f64,
    /// The part in doubt, 1 where all is.
    pub part: f64,
}

impl Normal {
    /// How many standard deviations a value is off, and what that changes by with it; `None` below what is not in doubt.
    fn off(&self, y: f64) -> Option<(f64, f64)> {
        let (by, deviation) = (y - self.mean, self.deviation.max(SHARPEST));
        if self.part >= 1.0 {
            return Some((by / deviation, 1.0 / deviation));
        }
        let ratio = (exp(by) - 1.0 + self.part) / self.part;
        (ratio > 0.0)
            .then(|| (log(ratio) * self.part / deviation, (ratio * self.part + 1.0 - self.part) / ratio / deviation))
    }

    /// Where it is so many standard deviations off.
    fn end(&self, off: f64) -> f64 {
        let by = off * self.deviation.max(SHARPEST);
        self.mean + if self.part >= 1.0 { by } else { log(1.0 - self.part + self.part * exp(by / self.part)) }
    }
}

/// No deviation is smaller.
const SHARPEST: f64 = 1e-12;
/// What is left out of the probability.
const UNLIKELY: f64 = 1e-7;

impl Mixture {
    /// Adds some of one deviation, with their weights and means: of many those that are next to each other in an order as one.
    pub fn add(&mut self, means: &[(f64, f64)], of: Normal, most: usize, order: &[usize]) {
        self.0.extend(order.chunks(means.len().div_ceil(most)).map(|alike| {
            let all: f64 = alike.iter().map(|&i| means[i].0).sum();
            let mean = alike.iter().map(|&i| means[i].0 * means[i].1).sum::<f64>() / all;
            Normal { weight: of.weight * all, mean, ..of }
        }));
    }

    /// The same with those as one that are next to each other, where there are many.
    pub fn condensed(self) -> Self {
        const MANY: usize = 128;
        const FINENESS: f64 = 0.1;
        // Within a class, wherever all of it is.
        const BESIDE: f64 = 0.37;
        // Of more classes of means the last is one.
        const MEANS: f64 = 1e6;
        if self.0.len() <= MANY || self.is_sharp() {
            return self;
        }
        let (middle, _) = self.moments();
        let class = |one: &Normal| {
            let width = (log(one.deviation.max(SHARPEST)) / FINENESS).floor();
            let place = (one.mean - middle) / (FINENESS * exp(FINENESS * width)) + BESIDE;
            3.0 * MEANS * width + place.floor().clamp(-MEANS, MEANS)
        };
        let classes: Vec<f64> = self.0.iter().map(class).collect();
        let is_like = |&i: &usize, &k: &usize| classes[i] == classes[k] && self.0[i].part == self.0[k].part;
        let together = |alike: &[usize]| {
            let alike: Vec<Normal> = alike.iter().map(|&i| self.0[i]).collect();
            let weight: f64 = alike.iter().map(|one| one.weight).sum();
            let (mean, variance) = Self::moments_of(&alike, weight);
            Normal { weight, mean, deviation: variance.sqrt(), ..alike[0] }
        };
        Self(ascending(&classes).chunk_by(is_like).map(together).collect())
    }

    fn likely(&self) -> impl Iterator<Item = &Normal> {
        self.0.iter().filter(|one| one.weight > UNLIKELY)
    }

    pub fn moments(&self) -> (f64, f64) {
        Self::moments_of(&self.0, 1.0)
    }

    fn moments_of(some: &[Normal], all: f64) -> (f64, f64) {
        let mean = some.iter().map(|one| one.weight * one.mean).sum::<f64>() / all;
        let square =
            |one: &Normal| one.weight * (one.deviation * one.deviation + (one.mean - mean) * (one.mean - mean));
        (mean, some.iter().map(square).sum::<f64>() / all)
    }

    /// The probability that it is below, to 1e-7, and its density there.
    fn below(&self, y: f64) -> (f64, f64) {
        // Abramowitz and Stegun, Handbook of Mathematical Functions, 26.2.17.
        const OF: [f64; 5] = [0.319_381_530, -0.356_563_782, 1.781_477_937, -1.821_255_978, 1.330_274_429];
        let (mut below, mut density, mut all) = (0.0, 0.0, 0.0);
        for one in self.likely() {
            all += one.weight;
            let Some((off, rate)) = one.off(y) else { continue };
            let bell = exp(-0.5 * off * off) / (2.0 * PI).sqrt();
            let near = 1.0 / (1.0 + 0.231_641_9 * off.abs());
            let outside = bell * OF.iter().rev().fold(0.0, |sum, of| near * (sum + of));
            below += one.weight * if off > 0.0 { 1.0 - outside } else { outside };
            density += one.weight * bell * rate;
        }
        (below / all, density / all)
    }

    pub fn between(&self, low: f64, high: f64) -> f64 {
        self.below(high).0 - self.below(low).0
    }

    fn is_sharp(&self) -> bool {
        self.0.iter().all(|one| one.deviation <= SHARPEST)
    }

    /// The same of numbers without a deviation: between the middles of neighbours on a line, so that it makes no step as they gain weight.
    fn sharp_quantile(&self, probability: f64) -> f64 {
        let all: f64 = self.0.iter().map(|one| one.weight).sum();
        let (mut below, mut last) = (0.0, None);
        for i in ascending(&self.0.iter().map(|one| one.mean).collect::<Vec<_>>()) {
            let Normal { weight, mean, .. } = self.0[i];
            let middle = (below + 0.5 * weight) / all;
            if middle >= probability {
                let of = |(at, before): (f64, f64)| before + (probability - at) / (middle - at) * (mean - before);
                return last.map_or(mean, of);
            }
            (below, last) = (below + weight, Some((middle, mean)));
        }
        last.map_or(f64::NAN, |(_, mean)| mean)
    }

    /// What it is below of with a probability: by Newton's method within a bracket that is halved where it leads outside.
    pub fn quantile(&self, probability: f64) -> f64 {
        if self.is_sharp() {
            return self.sharp_quantile(probability);
        }
        let mut low = self.likely().map(|one| one.end(-40.0)).fold(f64::INFINITY, f64::min);
        let mut high = self.likely().map(|one| one.end(40.0)).fold(f64::NEG_INFINITY, f64::max);
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
