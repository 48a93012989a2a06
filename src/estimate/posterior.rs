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

    /// The same with another kernel, of points at the reference, where none matters.
    pub fn with(&self, kernel: Kernel) -> Self {
        Self { kernel, ..self.clone() }
    }

    /// The same of points that were measured on one specimen, of so many that it may be: `means` has what y would be at each point, on each of
    /// them, or on the mean alone where it has none, with a rise.
    pub fn on_one_of(mut self, count: usize, means: &[(&[f64], f64)], measured: &[f64]) -> Self {
        let log_root = -self.log_probability - 0.5 * self.misfit;
        let n = measured.len();
        let (mut off, mut pull) = (vec![0.0; n], vec![0.0; n]);
        self.pulls.reserve(n * count);
        self.devices.reserve(count);
        let mut least = f64::INFINITY;
        for one in 0..count {
            for (i, off) in off.iter_mut().enumerate() {
                let (specimens, rise) = means[i];
                *off = measured[i] - specimens.get(one).map_or(self.seen[i].mean, |mean| mean + rise);
            }
            pull.copy_from_slice(&off);
            solve(&self.factor, &mut pull);
            let misfit: f64 = pull.iter().zip(&off).map(|(a, b)| a * b).sum();
            least = least.min(misfit);
            self.devices.push(misfit);
            self.pulls.extend_from_slice(&pull);
        }
        self.devices.iter_mut().for_each(|one| *one = exp(0.5 * (least - *one)));
        let all: f64 = self.devices.iter().sum();
        self.misfit = least - 2.0 * log(all / count as f64);
        self.log_probability = -0.5 * self.misfit - log_root;
        self.pull.fill(0.0);
        for (weight, pull) in self.devices.iter_mut().zip(self.pulls.chunks_exact(n)) {
            *weight /= all;
            self.pull.iter_mut().zip(pull).for_each(|(sum, pull)| *sum += *weight * *pull);
        }
        self
    }

    /// The probabilities of the specimens that may be the one that was measured; none where the points are not of one.
    pub fn devices(&self) -> &[f64] {
        &self.devices
    }

    /// What the points add to y, of each specimen that may be the one that was measured.
    pub fn pulled(&self, at: &Seen, found: &mut Vec<f64>) {
        let with = self.with_points(at);
        found.clear();
        match with[..] {
            [with] => found.extend(self.pulls.iter().map(|pull| with * pull)),
            _ => {
                let by = |pull: &[f64]| with.iter().zip(pull).map(|(a, b)| a * b).sum::<f64>();
                found.extend(self.pulls.chunks_exact(with.len().max(1)).map(by));
            }
        }
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

/// Many of them, of which those that are nearly alike are one with their mean and variance.
#[derive(Debug, Default)]
pub struct Gathered {
    kinds: Vec<Kind>,
    /// What is gathered with nothing.
    alone: Vec<Normal>,
}

/// Those whose deviations and parts in doubt are nearly the same.
#[derive(Debug)]
struct Kind {
    alike: [u64; 2],
    /// A mean among them, in the middle of cells, which are so wide.
    from: f64,
    width: f64,
    cells: Box<[Cell; CELLS]>,
    /// Sums of the weight, and of that times the part in doubt.
    sums: [f64; 2],
}

const CELLS: usize = 512;
/// Sums over those whose means are as near: of the weight, of that times how far the mean is off the middle of the cell, the square, and the variance.
type Cell = [f64; 4];

impl Gathered {
    /// Adds some of one deviation, with their weights, of which the sum is 1, and means.
    pub fn add(&mut self, of: Normal, means: &[(f64, f64)]) {
        // Deviations whose logarithms differ by less are alike, and parts in doubt; and means, in deviations.
        const FINENESS: f64 = 0.1;
        const CELL: f64 = 0.3;
        // The last bits of what is added to it are those of an integer.
        const ROUNDING: f64 = 1.5 * (1_u64 << 52) as f64;
        const MIDDLE: f64 = (CELLS / 2) as f64;
        let rounded = |x: f64| (x / FINENESS).floor();
        let width = rounded(log(of.deviation.max(SHARPEST)));
        let alike = [width, rounded(of.part)].map(f64::to_bits);
        let known = self.kinds.iter().position(|kind| kind.alike == alike);
        let kind = known.unwrap_or_else(|| {
            let (from, width) = (means.first().map_or(0.0, |first| first.1), CELL * exp(FINENESS * width));
            self.kinds.push(Kind { alike, from, width, cells: Box::new([[0.0; 4]; CELLS]), sums: [0.0; 2] });
            self.kinds.len() - 1
        });
        let kind = &mut self.kinds[kind];
        // Quantiles of numbers are between them, so that these stay apart.
        let (cells, variance) = (1.0 / kind.width, of.deviation * of.deviation);
        let most = if of.deviation > SHARPEST { MIDDLE - 1.0 } else { -1.0 };
        for &(weight, mean) in means {
            let (weight, place) = (of.weight * weight, (mean - kind.from) * cells);
            if place.abs() >= most || place.is_nan() {
                self.alone.push(Normal { weight, mean, ..of });
                continue;
            }
            let cell = place + ROUNDING;
            let off = place - (cell - ROUNDING);
            let [all, offs, squares, variances] =
                &mut kind.cells[(cell.to_bits() as usize).wrapping_add(CELLS / 2) % CELLS];
            *all += weight;
            *offs += weight * off;
            *squares += weight * off * off;
            *variances += weight * variance;
        }
        kind.sums = [kind.sums[0] + of.weight, kind.sums[1] + of.weight * of.part];
    }

    pub fn mixture(self) -> Mixture {
        let mut all = self.alone;
        for Kind { from, width, cells, sums: [of_kind, parts], .. } in &self.kinds {
            for (i, &[weight, offs, squares, variances]) in cells.iter().enumerate().filter(|(_, cell)| cell[0] > 0.0) {
                let (off, square) = (offs / weight, squares / weight);
                let deviation = (variances / weight + width * width * (square - off * off).max(0.0)).sqrt();
                let place = i as f64 - (CELLS / 2) as f64 + off;
                all.push(Normal { weight, mean: from + width * place, deviation, part: parts / of_kind });
            }
        }
        Mixture(all)
    }
}

/// No deviation is smaller.
const SHARPEST: f64 = 1e-12;
/// What is left out of the probability.
const UNLIKELY: f64 = 1e-7;

impl Mixture {
    fn likely(&self) -> impl Iterator<Item = &Normal> {
        self.0.iter().filter(|one| one.weight > UNLIKELY)
    }

    pub fn moments(&self) -> (f64, f64) {
        let mean = self.0.iter().map(|one| one.weight * one.mean).sum::<f64>();
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
