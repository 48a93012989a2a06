//! The limits of the levels of stiffness at one load, at which contacts begin to slip, and what strength the levels above have.
//!
//! At constant load the contacts resist a displacement x, over strength by stiffness, with the part Phi(x) of their strength, a
//! concave function with slope 1 at 0. The levels below the part s of the stiffness stick up to the displacement X(s) at least,
//! at which Phi has the slope s, and the levels above have the part H(s) of the strength, the integral of X from s to 1:
//!
//! ```text
//! H(s) = Phi(X) - s X, the largest of these values over all X; H(0) = 1, H(1) = 0, and its slope is -X.
//! ```

use super::{PerEdge, PerLevel, EDGES, LEVELS, NO_EDGE};
use crate::equilibrium::Branch;
use crate::numerics::float_bits::{power_of_two, MANTISSA_BITS};
use crate::numerics::four::{Four, Portable};
use crate::numerics::hermite::Cubic;

/// H is tabulated against s, at nodes found from the bits of v = 1/s - 1: at 0, and at powers of two from 2^-7 to 2^5.
const LEAST_EXPONENT: u64 = 1023 - 7;
pub const LEVEL_NODES: usize = 14;

/// Phi is asked for at the limits of the levels at the nodes and between them, about.
const SAMPLES: usize = 2 * LEVEL_NODES - 2;
/// These limits are found from displacements, over strength by stiffness, from about the least on.
const LEAST_DISPLACEMENT: f64 = 0.01;
/// The ratio of one of these displacements to the next, and of limits that are near enough.
const DISPLACEMENT_RATIO: f64 = 1.37;

/// The strength of the levels at one load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strengths {
    /// The share of each cell of which all levels touch; exactly 1 together.
    pub shares: [f32; LEVELS],
    /// H and X at the nodes.
    pub nodes: [[f32; 2]; LEVEL_NODES],
}

impl Strengths {
    /// From H and X at s.
    fn new(levels: impl Fn(f64) -> (f64, f64)) -> Self {
        Self::of_nodes(NODES_AT.map(|s| {
            let (above, limit) = levels(s);
            [above as f32, limit as f32]
        }))
    }

    fn of_nodes(nodes: [[f32; 2]; LEVEL_NODES]) -> Self {
        /// Up to 1, whole numbers of these have few enough digits.
        const UNIT: f64 = 1.0 / (1_u32 << f32::MANTISSA_DIGITS) as f64;
        let (mut above, mut below) = (NO_EDGE, 1.0);
        let numbers = nodes.map(|node| node.map(f64::from));
        at_edges::<Portable, false>(&numbers, &numbers, [1.0, 0.0], &mut above, &mut { NO_EDGE });
        let shares = std::array::from_fn(|j| {
            let above = (above[j + 1] / UNIT).round() * UNIT;
            let share = below - above;
            below = above;
            share as f32
        });
        Self { shares, nodes }
    }

    pub fn mean(&self, other: &Self) -> Self {
        let of = |i: usize, k: usize| 0.5 * (self.nodes[i][k] + other.nodes[i][k]);
        Self::of_nodes(std::array::from_fn(|i| [of(i, 0), of(i, 1)]))
    }

    /// x - Phi and 1 - its slope at a displacement, over strength by stiffness.
    pub fn lost(&self, x: f64) -> [f64; 2] {
        let at = |node: usize| {
            let ([above, limit], given_up) = (self.nodes[node].map(f64::from), 1.0 - NODES_AT[node]);
            [limit, given_up * limit - above, given_up]
        };
        let last = at(LEVEL_NODES - 1);
        // Beyond the last node the slope of Phi falls evenly.
        let end = last[0] + 2.0 * (1.0 - last[0] + last[1]) / (1.0 - last[2]);
        let node = (1..LEVEL_NODES).find(|&node| at(node)[0] > x).unwrap_or(LEVEL_NODES);
        let [from, to] = [at(node - 1), if node < LEVEL_NODES { at(node) } else { [end, end - 1.0, 1.0] }];
        if x >= to[0] || to[0] <= from[0] {
            return [x - 1.0, 1.0];
        }
        let [lost, given_up, _] = Cubic::new(from.into(), to.into()).rates(x);
        [lost.max(x - 1.0), given_up.clamp(0.0, 1.0)]
    }

    /// X at the nodes and between them, about.
    fn places(&self) -> [f64; SAMPLES] {
        let at = |node: usize| f64::from(self.nodes[node][1]);
        let mut places = std::array::from_fn(|k| 0.5 * (at(k.div_ceil(2)) + at((k + 1).div_ceil(2))));
        // The last is then beyond that of strengths which are like these.
        places[SAMPLES - 1] *= 1.1;
        places
    }

    /// The largest difference of H.
    pub fn distance(&self, other: &Self) -> f32 {
        self.nodes.iter().zip(&other.nodes).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
    }
}

/// The strength of the levels of the contacts at a separation, which may be near to this; `None` where they cannot be asked. `unit` is
/// the friction force over the sum of contact radii: it says about how far displacements go.
pub fn of_contacts(branch: &Branch, separation: f64, unit: f64, near: &Strengths) -> Option<Strengths> {
    // The samples at places, ascending, and the places of the limits by what is known then.
    let asked = |samples: &mut Vec<[f64; 3]>, places: [f64; SAMPLES]| {
        let lost = branch.lost_to_slip(separation, places)?;
        let length = places[0] / lost[0][0];
        samples.extend(lost);
        samples.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
        samples.dedup_by(|a, b| a[0] <= b[0] * (1.0 + 1e-9));
        let limit = |k: usize| above_and_limit(samples, 0.5 * (NODES_AT[k / 2] + NODES_AT[k.div_ceil(2)])).1;
        Some(std::array::from_fn::<f64, SAMPLES, _>(|k| limit(k + 1) * length))
    };
    let mut samples = Vec::with_capacity(2 * SAMPLES);
    let alike = near.places().map(|place| place * unit);
    let limits = asked(&mut samples, alike)?;
    let is_alike = |(a, b): (f64, f64)| a < DISPLACEMENT_RATIO * b && b < DISPLACEMENT_RATIO * a;
    if samples[samples.len() - 1][2] < 1.0 - NODES_AT[LEVEL_NODES - 1] {
        // They were not displaced far enough.
        let mut place = unit * LEAST_DISPLACEMENT;
        let evenly = alike.map(|_| {
            place *= DISPLACEMENT_RATIO;
            place
        });
        asked(&mut samples, evenly)?;
    } else if !alike.into_iter().zip(limits).all(is_alike) {
        asked(&mut samples, limits)?;
    }
    let is_sound = samples.iter().all(|&[x, lost, _]| (x - 1.0 - 1e-6..=x).contains(&lost));
    is_sound.then(|| Strengths::new(|s| above_and_limit(&samples, s)))
}

/// H and X at s, from several x, each with x - Phi and 1 - its slope.
fn above_and_limit(samples: &[[f64; 3]], s: f64) -> (f64, f64) {
    let wanted = 1.0 - s;
    let after = samples.partition_point(|&[_, _, given_up]| given_up <= wanted);
    let (limit, lost_there) = if after == 0 {
        // x - Phi is a parabola at first.
        let [x, lost, given_up] = samples[0];
        let limit = x * (wanted / given_up);
        (limit, lost * (limit / x) * (limit / x))
    } else if after == samples.len() {
        (samples[after - 1][0], samples[after - 1][1])
    } else {
        let ([x, lost, low], [x_after, lost_after, high]) = (samples[after - 1], samples[after]);
        let width = x_after - x;
        let t = (wanted - low) / (high - low);
        let (low, high, rise) = (low * width, high * width, lost_after - lost);
        let (c, d) = (3.0 * rise - 2.0 * low - high, low + high - 2.0 * rise);
        (x + t * width, lost + t * (low + t * (c + t * d)))
    };
    ((wanted * limit - lost_there).clamp(0.0, 1.0), limit)
}

/// The strength of the levels of contacts of one size, each of which slips from its rim inwards.
pub fn of_equal_contacts() -> Strengths {
    Strengths::new(|s| (1.0 - s * (1.5 - 0.5 * s * s), 1.5 * (1.0 - s * s)))
}

/// The shares of cells that are cut at a place with a slope by load, from H and X at the nodes and their slopes.
#[inline(always)]
pub fn shares_of_cut<V: Four, const SLOPES: bool>(
    nodes: &[[f64; 2]; LEVEL_NODES],
    node_slopes: &[[f64; 2]; LEVEL_NODES],
    cut: [f64; 2],
    shares: &mut PerLevel,
    slopes: &mut PerLevel,
) {
    let (mut above, mut above_slopes) = (NO_EDGE, NO_EDGE);
    at_edges::<V, SLOPES>(nodes, node_slopes, cut, &mut above, &mut above_slopes);
    above[0] = 1.0;
    for j in (0..LEVELS).step_by(4) {
        (V::read(&above, j) - V::read(&above, j + 1)).write(shares, j);
        if SLOPES {
            (V::read(&above_slopes, j) - V::read(&above_slopes, j + 1)).write(slopes, j);
        }
    }
}

/// H and its slope by load at the edges but for the first.
#[inline(always)]
fn at_edges<V: Four, const SLOPES: bool>(
    nodes: &[[f64; 2]; LEVEL_NODES],
    node_slopes: &[[f64; 2]; LEVEL_NODES],
    [place, place_slope]: [f64; 2],
    above: &mut PerEdge,
    slopes: &mut PerEdge,
) {
    let (none, inverse, by_load) = (V::splat(0.0), V::splat(1.0 / place), V::splat(place_slope / place));
    // Above the place there is nothing.
    for j in (1..LEVELS).step_by(4).take_while(|&j| EDGES[j] < place) {
        let (s, v) = (V::read(&EDGES, j) * inverse, V::splat(place) * V::read(&INVERSE_EDGES, j) - V::splat(1.0));
        let [value, limit] = interpolated(nodes, s, v);
        v.if_greater(none, value, none).write(above, j);
        if SLOPES {
            let [value, _] = interpolated(node_slopes, s, v);
            v.if_greater(none, value + limit * s * by_load, none).write(slopes, j);
        }
    }
}

/// 1/s of the edges, but for the first.
const INVERSE_EDGES: PerEdge = {
    let mut inverses = EDGES;
    let mut j = 1;
    while j < EDGES.len() {
        inverses[j] = 1.0 / EDGES[j];
        j += 1;
    }
    inverses
};

/// s at the nodes.
const NODES_AT: [f64; LEVEL_NODES] = {
    let mut at = [1.0; LEVEL_NODES];
    let mut i = 1;
    while i < LEVEL_NODES {
        at[i] = 1.0 / (1.0 + power_of_two(LEAST_EXPONENT - 1 + i as u64));
        i += 1;
    }
    at
};

/// s at the nodes, the width from one to the next, and 1 over it.
static INTERVALS: [[f64; 4]; LEVEL_NODES] = {
    let mut intervals = [[0.0; 4]; LEVEL_NODES];
    let mut i = 0;
    while i + 1 < LEVEL_NODES {
        let width = NODES_AT[i] - NODES_AT[i + 1];
        intervals[i] = [NODES_AT[i], width, 1.0 / width, 0.0];
        i += 1;
    }
    intervals
};

/// H and X at s < 1: cubics between nodes.
#[inline(always)]
fn interpolated<V: Four>(nodes: &[[f64; 2]; LEVEL_NODES], s: V, v: V) -> [V; 2] {
    let node = v.numbers().map(|v| {
        let exponent = v.to_bits() >> MANTISSA_BITS;
        (exponent + 1).saturating_sub(LEAST_EXPONENT).min(LEVEL_NODES as u64 - 2) as usize
    });
    let [start, width, inverse, _] = V::read_across(INTERVALS.as_flattened(), node.map(|node| 4 * node));
    let [low, low_slope, high, high_slope] = V::read_across(nodes.as_flattened(), node.map(|node| 2 * node));
    let t = (start - s) * inverse;
    let (low_slope, high_slope) = (low_slope * width, high_slope * width);
    let (rise, two, three) = (high - low, V::splat(2.0), V::splat(3.0));
    let (c, d) = (three * rise - two * low_slope - high_slope, low_slope + high_slope - two * rise);
    [low + t * (low_slope + t * (c + t * d)), (low_slope + t * (two * c + three * t * d)) * inverse]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// H and X, and x - Phi with 1 - its slope: of contacts of one size that slip from their rims, and of sizes by which Phi is an
    /// exponential.
    type Levels = (&'static str, fn(f64) -> (f64, f64), fn(f64) -> (f64, f64));
    const LEVELS_OF: [Levels; 2] = [
        (
            "one size",
            |s| (1.0 - s * (1.5 - 0.5 * s * s), 1.5 * (1.0 - s * s)),
            |x| {
                let root = (1.0 - x / 1.5).max(0.0).sqrt();
                (x - 1.0 + root * root * root, 1.0 - root)
            },
        ),
        ("exponential", |s| (1.0 - s + s * s.ln(), -s.ln()), |x| (x - 1.0 + (-x).exp(), 1.0 - (-x).exp())),
    ];

    #[test]
    fn shares_are_1_together_where_one_level_has_most_of_the_strength() {
        for i in 0..100 {
            let row = Strengths::new(|s| (if s < 0.5 { 0.2 + 1e-3 * f64::from(i) } else { 0.0 }, 0.0));
            assert_eq!(row.shares.iter().map(|&share| f64::from(share)).sum::<f64>(), 1.0, "{i}");
        }
    }

    #[test]
    fn cells_have_the_strength_of_their_levels_wherever_they_are_cut() {
        for (name, levels, _) in LEVELS_OF {
            let nodes = Strengths::new(levels).nodes.map(|node| node.map(f64::from));
            for i in 0..200 {
                let place = 1.0 - 0.003 * f64::from(i);
                let (mut shares, mut slopes) = ([f64::NAN; LEVELS], [f64::NAN; LEVELS]);
                shares_of_cut::<Portable, true>(
                    &nodes,
                    &[[0.0; 2]; LEVEL_NODES],
                    [place, 0.3],
                    &mut shares,
                    &mut slopes,
                );
                assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-15, "{name}, {place}: {shares:?}");
                let above = |j: usize| if EDGES[j] == 0.0 { 1.0 } else { levels((EDGES[j] / place).min(1.0)).0 };
                for (j, share) in shares.into_iter().enumerate() {
                    let error = share - (above(j) - above(j + 1));
                    assert!(error.abs() < 2e-4 && share >= 0.0, "{name}, {j} at {place}: {error:e}");
                }
            }
        }
    }

    #[test]
    fn phi_at_a_few_displacements_gives_the_strength_of_levels() {
        for (name, levels, lost) in LEVELS_OF {
            let samples: [_; 26] = std::array::from_fn(|k| {
                let x = LEAST_DISPLACEMENT * 1.35_f64.powi(k as i32);
                [x, lost(x).0, lost(x).1]
            });
            for i in 1..400 {
                let s = 1.0 - (f64::from(i) / 400.0).powi(3);
                let ((above, _), (expected, _)) = (above_and_limit(&samples, s), levels(s));
                let error = (above - expected).abs();
                assert!(error < 2e-2 && error < 0.05 * expected + 1e-14, "{name} at {s}: {above}, not {expected}");
            }
        }
    }
}
