//! The limits of the levels of stiffness of a surface, at which its contacts begin to slip, against load.
//!
//! At constant load the contacts resist a displacement x, over strength by stiffness, with the part Phi(x) of their strength, a
//! concave function with slope 1 at 0. The levels below the part s of the stiffness stick up to the displacement X(s) at least,
//! at which Phi has the slope s, and the levels above have the part H(s) of the strength, the integral of X from s to 1:
//!
//!     H(s) = Phi(X) - s X, the largest of these values over all X; H(0) = 1, H(1) = 0, and its slope is -X.
//!
//! It hardly changes with load: values at a few loads are blended.

use super::table::MANTISSA_BITS;
use super::{Curve, Table};
use crate::elementary::log;
use crate::equilibrium::Branch;
use crate::four::Four;
use crate::levels::{PerEdge, PerLevel, EDGES, LEVELS};

/// So many binades lie between loads at which there are rows, as a power of two...
const LOG_STRIDE: u32 = 1;
/// ...and so many such steps between those at which Phi is asked for in any case.
const LONGEST: usize = 8;
/// In between it is asked for where it differs by more than this from the mean of its neighbours.
const TOLERANCE: f32 = 1e-3;

/// H is tabulated against v = 1/s - 1: at 0 and at powers of two from 2^-11...
const LEAST_EXPONENT: u64 = 1023 - 11;
/// ...to 2^5.
const NODES: usize = 18;

/// Displacements at which Phi is asked for: the first, and the ratio of one to the next.
const SHORTEST: f64 = 3e-3;
const RATIO: f64 = 1.42;
const SAMPLES: usize = 28;

/// Shares of the strength, and what they are of.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    /// Of each cell of which all levels touch; 1 together.
    shares: PerLevel,
    /// H at the nodes, and its slope by v.
    nodes: [[f32; 2]; NODES],
}

/// H at loads that are powers of two above pull-off.
#[derive(Debug, Clone)]
pub struct Limits {
    /// The biased exponent of the first.
    first: u64,
    rows: Vec<Row>,
}

impl Limits {
    /// H over the range of a table.
    pub fn new(branch: &Branch, curve: &Curve, table: &Table, load: f64) -> Self {
        let exponent = |x: f64| x.to_bits() >> MANTISSA_BITS;
        let (first, last) = (exponent(table.begin_of(0)), exponent(table.begin_of(table.row_count)));
        let steps = ((last - first) >> LOG_STRIDE) as usize + 1;
        let at = |row: usize| {
            let exponent = (first + ((row as u64) << LOG_STRIDE)).min(last - 1);
            row_at(branch, curve, log(of_exponent(exponent)) - log(load))
        };
        let mut rows = vec![Row { shares: [0.0; LEVELS], nodes: [[0.0; 2]; NODES] }; steps.div_ceil(LONGEST) * LONGEST + 1];
        // What is not known is taken from the next lighter load; most likely the lightest is the one that is not.
        rows[0] = at(0).or_else(|| at(LONGEST)).unwrap_or_else(equal_contacts);
        for from in (0..steps).step_by(LONGEST) {
            rows[from + LONGEST] = at(from + LONGEST).unwrap_or(rows[from]);
            fill_between(&mut rows, (from, from + LONGEST), &at);
        }
        Self { first, rows }
    }

    /// The shares of cells that are cut at a place in the strength, at load - pull-off, where they are to be; with `SLOPES` also
    /// by load, at which the place has this slope.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn at_excess<V: Four, const SLOPES: bool>(
        &self,
        x: f64,
        [place, place_slope]: [f64; 2],
        shares: &mut PerLevel,
        slopes: &mut PerLevel,
    ) {
        let (before, after, part, part_slope) = self.around(x);
        if place >= 1.0 && place_slope == 0.0 {
            for j in (0..LEVELS).step_by(4) {
                let from = V::read(&before.shares, j);
                let change = V::read(&after.shares, j) - from;
                (from + V::splat(part) * change).write(shares, j);
                if SLOPES {
                    (V::splat(part_slope) * change).write(slopes, j);
                }
            }
            return;
        }
        let (mut nodes, mut node_slopes) = ([[0.0; 2]; NODES], [[0.0; 2]; NODES]);
        for j in (0..2 * NODES).step_by(4) {
            let from = V::read_single(before.nodes.as_flattened(), j);
            let change = V::read_single(after.nodes.as_flattened(), j) - from;
            (from + V::splat(part) * change).write(nodes.as_flattened_mut(), j);
            if SLOPES {
                (V::splat(part_slope) * change).write(node_slopes.as_flattened_mut(), j);
            }
        }
        let (mut below, mut below_slope) = (1.0, 0.0);
        for j in 0..LEVELS {
            let v = place * INVERSE_EDGES[j + 1] - 1.0;
            let (mut above, mut above_slope) = (0.0, 0.0);
            if v > 0.0 {
                let slope;
                (above, slope) = interpolated(&nodes, v);
                if SLOPES {
                    above_slope = interpolated(&node_slopes, v).0 + slope * place_slope * INVERSE_EDGES[j + 1];
                }
            }
            shares[j] = below - above;
            slopes[j] = below_slope - above_slope;
            (below, below_slope) = (above, above_slope);
        }
    }

    /// The rows around load - pull-off, what part of the way it is from one to the next, and its slope.
    #[inline(always)]
    fn around(&self, x: f64) -> (&Row, &Row, f64, f64) {
        let end = self.rows.len() - 1;
        let binades = (x.max(0.0).to_bits() >> MANTISSA_BITS).saturating_sub(self.first);
        let row = (binades >> LOG_STRIDE) as usize;
        if row >= end || x < of_exponent(self.first) {
            let row = &self.rows[row.min(end)];
            return (row, row, 0.0, 0.0);
        }
        let unit = of_exponent(self.first + binades);
        // Close to log2(x), with a slope that does not jump where binades meet.
        let t = x / unit - 1.0;
        const STRIDE: u64 = 1 << LOG_STRIDE;
        const PER_BINADE: f64 = 1.0 / STRIDE as f64;
        let place = ((binades % STRIDE) as f64 + t * (4.0 - t) / 3.0) * PER_BINADE;
        let place_slope = (4.0 - 2.0 * t) * (PER_BINADE / 3.0) / unit;
        let (part, part_slope) = (place * place * (3.0 - 2.0 * place), 6.0 * place * (1.0 - place) * place_slope);
        (&self.rows[row], &self.rows[row + 1], part, part_slope)
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

/// H and its slope by v, a cubic between nodes.
#[inline(always)]
fn interpolated(nodes: &[[f64; 2]; NODES], v: f64) -> (f64, f64) {
    const FIRST: f64 = of_exponent(LEAST_EXPONENT);
    let exponent = v.max(0.0).to_bits() >> MANTISSA_BITS;
    let node = (exponent + 1).saturating_sub(LEAST_EXPONENT).min(NODES as u64 - 2) as usize;
    let is_first = node == 0;
    let begin = if is_first { 0.0 } else { of_exponent(LEAST_EXPONENT - 1 + node as u64) };
    let width = if is_first { FIRST } else { begin };
    let t = (v - begin) / width;
    let ([low, low_slope], [high, high_slope]) = (nodes[node], nodes[node + 1]);
    let (low_slope, high_slope) = (low_slope * width, high_slope * width);
    let rise = high - low;
    let (c, d) = (3.0 * rise - 2.0 * low_slope - high_slope, low_slope + high_slope - 2.0 * rise);
    (low + t * (low_slope + t * (c + t * d)), (low_slope + t * (2.0 * c + 3.0 * t * d)) / width)
}

/// 2^e of a biased exponent.
#[inline]
const fn of_exponent(exponent: u64) -> f64 {
    f64::from_bits(exponent << MANTISSA_BITS)
}

impl Row {
    /// From H and X at s.
    fn new(levels: impl Fn(f64) -> (f64, f64)) -> Self {
        let nodes: [[f64; 2]; NODES] = std::array::from_fn(|i| {
            let v = if i == 0 { 0.0 } else { of_exponent(LEAST_EXPONENT - 1 + i as u64) };
            let s = 1.0 / (1.0 + v);
            let (above, limit) = levels(s);
            [above, limit * s * s]
        });
        Self::of_nodes(nodes.map(|node| node.map(|x| x as f32)))
    }

    fn of_nodes(nodes: [[f32; 2]; NODES]) -> Self {
        let numbers = nodes.map(|node| node.map(f64::from));
        let mut below = 1.0;
        let shares = std::array::from_fn(|j| {
            let v = INVERSE_EDGES[j + 1] - 1.0;
            let above = if v > 0.0 { interpolated(&numbers, v).0 } else { 0.0 };
            let share = below - above;
            below = above;
            share
        });
        Self { shares, nodes }
    }

    fn mean(&self, other: &Self) -> Self {
        let of = |i: usize, k: usize| 0.5 * (self.nodes[i][k] + other.nodes[i][k]);
        Self::of_nodes(std::array::from_fn(|i| [of(i, 0), of(i, 1)]))
    }

    /// The largest difference of H.
    fn distance(&self, other: &Self) -> f32 {
        self.nodes.iter().zip(&other.nodes).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
    }
}

/// Fills the rows between two that are known: with their means, but where H is found to be another.
fn fill_between(rows: &mut [Row], (from, to): (usize, usize), at: &dyn Fn(usize) -> Option<Row>) {
    if to - from < 2 {
        return;
    }
    let middle = (from + to) / 2;
    let mean = rows[from].mean(&rows[to]);
    rows[middle] = at(middle).unwrap_or(mean);
    let none = |_: usize| None;
    let at = if rows[middle].distance(&mean) < TOLERANCE { &none } else { at };
    fill_between(rows, (from, middle), at);
    fill_between(rows, (middle, to), at);
}

/// The row at ln(load - pull-off); `None` where the state is not known.
fn row_at(branch: &Branch, curve: &Curve, log_excess: f64) -> Option<Row> {
    let population = branch.population();
    let separation = curve.separation(log_excess)?;
    let sums = population.at_separation(separation);
    let length = sums.friction / sums.radius;
    let mut places = [SHORTEST; SAMPLES];
    for k in 1..SAMPLES {
        places[k] = places[k - 1] * RATIO;
    }
    let [lost, given_up] = population.lost_to_slip(separation, places.map(|x| x * length))?;
    let is_sound = lost.iter().zip(places).all(|(lost, x)| (x - 1.0 - 1e-6..=x).contains(lost));
    is_sound.then(|| Row::new(|s| above_and_limit(&places, &lost, &given_up, s)))
}

/// H and X at s, from x - Phi and 1 - its slope at several x.
fn above_and_limit(x: &[f64; SAMPLES], lost: &[f64; SAMPLES], given_up: &[f64; SAMPLES], s: f64) -> (f64, f64) {
    let wanted = 1.0 - s;
    let after = given_up.partition_point(|&given_up| given_up <= wanted);
    let (limit, lost_there) = if after == 0 {
        // x - Phi is a parabola at first.
        let limit = x[0] * (wanted / given_up[0]);
        (limit, lost[0] * (limit / x[0]) * (limit / x[0]))
    } else if after == SAMPLES {
        (x[SAMPLES - 1], lost[SAMPLES - 1])
    } else {
        let before = after - 1;
        let width = x[after] - x[before];
        let t = (wanted - given_up[before]) / (given_up[after] - given_up[before]);
        let (low, high) = (given_up[before] * width, given_up[after] * width);
        let rise = lost[after] - lost[before];
        let (c, d) = (3.0 * rise - 2.0 * low - high, low + high - 2.0 * rise);
        (x[before] + t * width, lost[before] + t * (low + t * (c + t * d)))
    };
    ((wanted * limit - lost_there).clamp(0.0, 1.0), limit)
}

/// Of contacts of one size, each of which slips from its rim inwards.
fn equal_contacts() -> Row {
    Row::new(|s| (1.0 - s * (1.5 - 0.5 * s * s), 1.5 * (1.0 - s * s)))
}
