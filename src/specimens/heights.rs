//! Heights of the tallest of many summits, at random: the same specimens for the same seed, each by itself.
//!
//! By Renyi's representation of order statistics (Acta Math. Acad. Sci. Hung. 4 (1953), 191) the k-th tallest of N summits is the
//! height that the fraction 1 - exp(-H_k) of all summits exceeds, with H_k the sum of E_j/(N - j + 1) over j up to k and E_j
//! exponentially distributed. The first few E_j are those of a rank-one lattice, which makes means over specimens exact to
//! some tenths of a percent for some hundred specimens; the others are independent.

use crate::distribution::panel;
use crate::distribution::HeightDistribution;
use crate::model::Surfaces;
use crate::numerics::elementary::{exp, expm1, log};
use crate::numerics::hermite::Cubic;
use crate::numerics::quadrature;

/// Between two heights of the table the logit of the fraction above and the height itself change by no more, the height over 1 or over its size;
/// where the one is more than its step over `OF_LOGIT` by that part of it. What is read between them is within some 1e-8 sigma.
const STEPS: [f64; 2] = [0.25, 0.125];
const OF_LOGIT: f64 = 0.025;
/// Or they are as close as this.
const CLOSEST: f64 = 1e-12;
/// No specimen has a summit so high that less than this part of all is higher.
const LEAST_FRACTION: f64 = 1e-60;

/// Heights, in sigma, by the fraction of summits above.
#[derive(Debug)]
pub struct Heights {
    /// From the lowest height to the highest.
    rows: Vec<Row>,
}

/// A height z with ln(Q/(1 - Q)) of the fraction Q of summits above, its slope dz/d(that), and the integral of Q from z up.
#[derive(Debug, Clone, Copy)]
struct Row {
    logit: f64,
    z: f64,
    slope: f64,
    area: f64,
}

impl Row {
    fn fraction(&self) -> f64 {
        1.0 / (1.0 + exp(-self.logit))
    }

    /// dQ/dz.
    fn fall(&self) -> f64 {
        let fraction = self.fraction();
        if self.slope < 0.0 {
            fraction * (1.0 - fraction) / self.slope
        } else {
            0.0
        }
    }
}

impl Heights {
    /// The heights of surfaces.
    pub fn of(surfaces: &Surfaces) -> Self {
        let (lowest, highest) = surfaces.population().extent();
        Self::new(surfaces.population().heights(), lowest, highest)
    }

    /// The heights of a distribution between two heights.
    fn new(heights: &dyn HeightDistribution, lowest: f64, highest: f64) -> Self {
        let mut ends: Vec<f64> = panel::panels(heights, lowest, highest).map(|(from, _)| from).collect();
        ends.push(highest);
        let parts: Vec<f64> = ends.windows(2).map(|ends| fraction(heights, ends[0], ends[1])).collect();
        let mut found = Self { rows: Vec::new() };
        let (mut below, all) = (0.0, parts.iter().sum::<f64>());
        let mut above = vec![0.0; parts.len() + 1];
        for i in (0..parts.len()).rev() {
            above[i] = above[i + 1] + parts[i];
        }
        for (i, part) in parts.iter().enumerate() {
            let [from, to] = [(ends[i], above[i], below), (ends[i + 1], above[i + 1], below + part)];
            found.divide(heights, from, to, all);
            below += part;
        }
        let mut above: Option<Row> = None;
        for row in found.rows.iter_mut().rev() {
            if let Some(above) = above {
                let width = above.z - row.z;
                let ends = row.fraction() + above.fraction();
                row.area = above.area + width * (0.5 * ends + width / 12.0 * (row.fall() - above.fall()));
            }
            above = Some(*row);
        }
        found
    }

    /// Rows from one height to another, each with the fractions above and below.
    fn divide(&mut self, heights: &dyn HeightDistribution, from: (f64, f64, f64), to: (f64, f64, f64), all: f64) {
        let least = LEAST_FRACTION * all;
        let logit = |(_, above, below): (f64, f64, f64)| log(above.max(least)) - log(below.max(least));
        if from.1 <= least || to.2 <= least {
            return;
        }
        let (width, size) = (to.0 - from.0, 1.0 + from.0.abs().min(to.0.abs()));
        let (upper, lower) = (logit(from), logit(to));
        let step = STEPS[0].max(OF_LOGIT * upper.abs().min(lower.abs()));
        if width > CLOSEST * size && (upper - lower > step || width > STEPS[1] * size) {
            let middle = 0.5 * (from.0 + to.0);
            // The half with fewer summits is summed, and the other is the rest.
            let (upper, lower) = if from.1 < from.2 {
                let upper = fraction(heights, middle, to.0);
                (upper, from.1 - to.1 - upper)
            } else {
                let lower = fraction(heights, from.0, middle);
                (to.2 - from.2 - lower, lower)
            };
            let at_middle = (middle, to.1 + upper, from.2 + lower);
            self.divide(heights, from, at_middle, all);
            self.divide(heights, at_middle, to, all);
        } else if to.1 > least && from.2 > least {
            let density = exp(heights.log_density(from.0));
            let slope = -from.1 * from.2 / all / density;
            let slope = if slope.is_finite() { slope } else { 0.0 };
            self.rows.push(Row { logit: logit(from), z: from.0, slope, area: 0.0 });
        }
    }

    /// The height that the fraction 1 - exp(-hazard) of all summits exceeds.
    pub fn of_hazard(&self, hazard: f64) -> f64 {
        self.of_logit(log(-expm1(-hazard)) + hazard)
    }

    fn of_logit(&self, logit: f64) -> f64 {
        let (from, to) = self.about(|row| row.logit > logit);
        Cubic::new((from.logit, from.z, from.slope), (to.logit, to.z, to.slope)).at(logit).clamp(from.z, to.z)
    }

    /// The rows before and behind where this ends to hold.
    fn about(&self, is_before: impl Fn(&Row) -> bool) -> (Row, Row) {
        let i = self.rows.partition_point(is_before).clamp(1, self.rows.len() - 1);
        (self.rows[i - 1], self.rows[i])
    }

    /// A summit on a sphere: how far it stands above the lowest point of the mean sphere, and its own height there. So many summits
    /// as `area` times 2 pi R eta sigma stand farther above; of those that stand as far it is higher than the part `share`.
    pub fn on_sphere(&self, area: f64, share: f64) -> (f64, f64) {
        let (from, to) = self.about(|row| row.area > area);
        if area > from.area {
            // Below the lowest summit all are above.
            return (from.z - (area - from.area), self.of_logit(log(share / (1.0 - share))));
        }
        let along = |row: Row| (log(row.area), row.z, -row.area / row.fraction());
        let above =
            if to.area > 0.0 { Cubic::new(along(from), along(to)).at(log(area)).clamp(from.z, to.z) } else { to.z };
        let fraction = from.fraction() + (to.fraction() - from.fraction()) * (above - from.z) / (to.z - from.z);
        let fraction = fraction * share;
        (above, self.of_logit(log(fraction / (1.0 - fraction))).max(above))
    }
}

/// The fraction of summits between two heights.
fn fraction(heights: &dyn HeightDistribution, from: f64, to: f64) -> f64 {
    panel::panels(heights, from, to)
        .map(|(from, to)| {
            quadrature::nodes(from, to).map(|(z, weight)| weight * exp(heights.log_density(z))).sum::<f64>()
        })
        .sum()
}

/// Bits at random of three numbers: those of splitmix64.
pub fn bits(seed: u64, specimen: u64, index: u64) -> u64 {
    let mix = |z: u64| {
        let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    };
    const STEP: u64 = 0x9E37_79B9_7F4A_7C15;
    mix(mix(mix(seed.wrapping_add(STEP)).wrapping_add(specimen)).wrapping_add(STEP.wrapping_mul(index + 1)))
}

/// A number above 0 and below 1 of bits.
pub fn uniform(bits: u64) -> f64 {
    ((bits >> 11) as f64 + 0.5) / (1_u64 << 53) as f64
}

/// The fractions of the square roots of the first primes, times 2^64.
const LATTICE: [u64; 8] = [
    0x6A09_E667_F3BC_C908,
    0xBB67_AE85_84CA_A73B,
    0x3C6E_F372_FE94_F82B,
    0xA54F_F53A_5F1D_36F1,
    0x510E_527F_ADE6_82D1,
    0x9B05_688C_2B3E_6C1F,
    0x1F83_D9AB_FB41_BD6B,
    0x5BE0_CD19_137E_2179,
];

/// The j-th exponentially distributed number of a specimen.
pub fn exponential(seed: u64, specimen: u64, j: usize) -> f64 {
    let bits = match LATTICE.get(j) {
        Some(step) => specimen.wrapping_add(1).wrapping_mul(*step).wrapping_add(bits(seed, u64::MAX, j as u64)),
        None => bits(seed, specimen, j as u64),
    };
    -log(uniform(bits))
}
