//! The limits of the levels of stiffness of a surface, at which its contacts begin to slip, against load.
//!
//! At constant load the contacts resist a displacement x, over strength by stiffness, with the part Phi(x) of their strength, a
//! concave function with slope 1 at 0. The levels below the part s of the stiffness stick up to the displacement X(s) at least,
//! at which Phi has the slope s, and the levels above have the part H(s) of the strength, the integral of X from s to 1:
//!
//! ```text
//! H(s) = Phi(X) - s X, the largest of these values over all X; H(0) = 1, H(1) = 0, and its slope is -X.
//! ```
//!
//! It hardly changes with load: values at a few loads are blended.

use super::table::MANTISSA_BITS;
use super::{Curve, Quantity, Table};
use crate::equilibrium::Branch;
use crate::levels::{PerEdge, PerLevel, EDGES, LEVELS};
use crate::numerics::elementary::log;
use crate::numerics::four::Four;

/// There is a row at each load that is a power of two; at every so many Phi is asked for in any case, and between them.
const LONGEST: usize = 16;
/// In between it is asked for where H differs by more than this from the mean of its neighbours, or, over more than half as many rows,
/// from either.
const TOLERANCE: f32 = 1e-3;

/// H is tabulated against s, at nodes found from the bits of v = 1/s - 1: at 0 and at powers of two from 2^-7...
const LEAST_EXPONENT: u64 = 1023 - 7;
/// ...to 2^5.
const NODES: usize = 14;

/// Phi is asked for at the limits of the levels at the nodes and between them, about.
const SAMPLES: usize = 2 * NODES - 2;
/// To find these, at displacements over strength by stiffness from about the least, and the ratio of one to the next.
const SHORTEST: f64 = 0.01;
const RATIO: f64 = 1.37;

/// Shares of the strength, and what they are of.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Row {
    /// Of each cell of which all levels touch; exactly 1 together.
    shares: [f32; LEVELS],
    /// H and X at the nodes.
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
        let at = |row: usize, near: &Row| row_at(branch, curve, log(of_exponent(first + row as u64)) - log(load), near);
        let (end, equal) = ((last - first).max(1) as usize - 1, equal_contacts());
        // What is not known is taken from the next lighter load; most likely the lightest is the one that is not.
        let lightest = at(0, &equal).or_else(|| at(LONGEST.min(end), &equal)).unwrap_or(equal);
        let mut rows = vec![lightest; end + 1];
        for from in (0..end).step_by(LONGEST) {
            let to = (from + LONGEST).min(end);
            rows[to] = at(to, &rows[from]).unwrap_or(rows[from]);
            fill_between(&mut rows, (from, to), &at);
        }
        // Beyond the loads at which rows change the last is enough.
        let alike = |row: &Row, other: &Row| row.distance(other) < TOLERANCE;
        let heavy = rows.iter().rev().take_while(|row| alike(row, &rows[rows.len() - 1])).count() - 1;
        rows.truncate(rows.len() - heavy);
        let light = rows.iter().take_while(|row| alike(row, &rows[0])).count() - 1;
        rows.drain(..light);
        rows.shrink_to_fit();
        Self { first: first + light as u64, rows }
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
                let from = V::read_single(&before.shares, j);
                let change = V::read_single(&after.shares, j) - from;
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
        let inverse = 1.0 / place;
        for j in 0..LEVELS {
            let (s, v) = (EDGES[j + 1] * inverse, place * INVERSE_EDGES[j + 1] - 1.0);
            let (mut above, mut above_slope) = (0.0, 0.0);
            if v > 0.0 {
                let limit;
                (above, limit) = interpolated(&nodes, s, v);
                if SLOPES {
                    above_slope = interpolated(&node_slopes, s, v).0 + limit * s * inverse * place_slope;
                }
            }
            shares[j] = below - above;
            below = above;
            if SLOPES {
                slopes[j] = below_slope - above_slope;
                below_slope = above_slope;
            }
        }
    }

    /// The rows around load - pull-off, what part of the way it is from one to the next, and its slope.
    #[inline(always)]
    fn around(&self, x: f64) -> (&Row, &Row, f64, f64) {
        let end = self.rows.len() - 1;
        let binades = (x.max(0.0).to_bits() >> MANTISSA_BITS).saturating_sub(self.first);
        let row = binades as usize;
        if row >= end || x < of_exponent(self.first) {
            let row = &self.rows[row.min(end)];
            return (row, row, 0.0, 0.0);
        }
        let unit = of_exponent(self.first + binades);
        // Close to log2(x), with a slope that does not jump where binades meet.
        let t = x / unit - 1.0;
        let (place, place_slope) = (t * (4.0 - t) / 3.0, (4.0 - 2.0 * t) / (3.0 * unit));
        (&self.rows[row], &self.rows[row + 1], place, place_slope)
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
const NODES_AT: [f64; NODES] = {
    let mut at = [1.0; NODES];
    let mut i = 1;
    while i < NODES {
        at[i] = 1.0 / (1.0 + of_exponent(LEAST_EXPONENT - 1 + i as u64));
        i += 1;
    }
    at
};

/// 1 over the width from a node to the next, in s.
const INVERSE_WIDTHS: [f64; NODES] = {
    let mut inverses = [0.0; NODES];
    let mut i = 0;
    while i + 1 < NODES {
        inverses[i] = 1.0 / (NODES_AT[i] - NODES_AT[i + 1]);
        i += 1;
    }
    inverses
};

/// H and X at s < 1: a cubic between nodes.
#[inline(always)]
fn interpolated(nodes: &[[f64; 2]; NODES], s: f64, v: f64) -> (f64, f64) {
    let exponent = v.to_bits() >> MANTISSA_BITS;
    let node = (exponent + 1).saturating_sub(LEAST_EXPONENT).min(NODES as u64 - 2) as usize;
    let (width, inverse) = (NODES_AT[node] - NODES_AT[node + 1], INVERSE_WIDTHS[node]);
    let t = (NODES_AT[node] - s) * inverse;
    let ([low, low_slope], [high, high_slope]) = (nodes[node], nodes[node + 1]);
    let (low_slope, high_slope) = (low_slope * width, high_slope * width);
    let rise = high - low;
    let (c, d) = (3.0 * rise - 2.0 * low_slope - high_slope, low_slope + high_slope - 2.0 * rise);
    (low + t * (low_slope + t * (c + t * d)), (low_slope + t * (2.0 * c + 3.0 * t * d)) * inverse)
}

/// 2^e of a biased exponent.
#[inline]
const fn of_exponent(exponent: u64) -> f64 {
    f64::from_bits(exponent << MANTISSA_BITS)
}

impl Row {
    /// From H and X at s.
    fn new(levels: impl Fn(f64) -> (f64, f64)) -> Self {
        Self::of_nodes(NODES_AT.map(|s| {
            let (above, limit) = levels(s);
            [above as f32, limit as f32]
        }))
    }

    fn of_nodes(nodes: [[f32; 2]; NODES]) -> Self {
        /// Up to 1, whole numbers of these have few enough digits.
        const UNIT: f64 = 1.0 / (1_u32 << f32::MANTISSA_DIGITS) as f64;
        let numbers = nodes.map(|node| node.map(f64::from));
        let mut below = 1.0;
        let shares = std::array::from_fn(|j| {
            let v = INVERSE_EDGES[j + 1] - 1.0;
            let above = if v > 0.0 { interpolated(&numbers, EDGES[j + 1], v).0 } else { 0.0 };
            let above = (above / UNIT).round() * UNIT;
            let share = below - above;
            below = above;
            share as f32
        });
        Self { shares, nodes }
    }

    fn mean(&self, other: &Self) -> Self {
        let of = |i: usize, k: usize| 0.5 * (self.nodes[i][k] + other.nodes[i][k]);
        Self::of_nodes(std::array::from_fn(|i| [of(i, 0), of(i, 1)]))
    }

    /// X at the nodes and between them, about.
    fn places(&self) -> [f64; SAMPLES] {
        let at = |node: usize| f64::from(self.nodes[node][1]);
        let mut places = std::array::from_fn(|k| 0.5 * (at(k.div_ceil(2)) + at((k + 1).div_ceil(2))));
        // Of a row that is like this one the last is then beyond.
        places[SAMPLES - 1] *= 1.1;
        places
    }

    /// The largest difference of H.
    fn distance(&self, other: &Self) -> f32 {
        self.nodes.iter().zip(&other.nodes).map(|(a, b)| (a[0] - b[0]).abs()).fold(0.0, f32::max)
    }
}

/// Fills the rows between two that are known: with their means, but where H is found to be another.
fn fill_between(rows: &mut [Row], (from, to): (usize, usize), at: &dyn Fn(usize, &Row) -> Option<Row>) {
    if to - from < 2 {
        return;
    }
    let middle = (from + to) / 2;
    let mean = rows[from].mean(&rows[to]);
    rows[middle] = at(middle, &mean).unwrap_or(mean);
    let none = |_: usize, _: &Row| None;
    let is_near = |other: &Row| rows[middle].distance(other) < TOLERANCE;
    let is_known = is_near(&mean) && (2 * (to - from) <= LONGEST || is_near(&rows[from]) && is_near(&rows[to]));
    let at = if is_known { &none } else { at };
    fill_between(rows, (from, middle), at);
    fill_between(rows, (middle, to), at);
}

/// The row at ln(load - pull-off), which may be like this one; `None` where the state is not known.
fn row_at(branch: &Branch, curve: &Curve, log_excess: f64, near: &Row) -> Option<Row> {
    let population = branch.population();
    let separation = curve.separation(log_excess)?;
    // Of the places this only says about how far they go.
    let [[friction], [radius]] =
        Quantity::ALL.map(|quantity| curve.at_each(quantity, [log_excess]).map(|(value, _)| value));
    let unit = friction / radius;
    // The samples at places, ascending, and the places of the limits by what is known then.
    let asked = |samples: &mut Vec<[f64; 3]>, places: [f64; SAMPLES]| {
        let lost = population.lost_to_slip(separation, places)?;
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
    let is_alike = samples[samples.len() - 1][2] >= 1.0 - NODES_AT[NODES - 1]
        && alike.iter().zip(limits).all(|(place, limit)| *place < RATIO * limit && limit < RATIO * place);
    if !is_alike {
        samples.clear();
        let mut place = unit * SHORTEST;
        let first = [(); SAMPLES].map(|()| {
            place *= RATIO;
            place
        });
        let limits = asked(&mut samples, first)?;
        asked(&mut samples, limits)?;
    }
    let is_sound = samples.iter().all(|&[x, lost, _]| (x - 1.0 - 1e-6..=x).contains(&lost));
    is_sound.then(|| Row::new(|s| above_and_limit(&samples, s)))
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

/// Of contacts of one size, each of which slips from its rim inwards.
fn equal_contacts() -> Row {
    Row::new(|s| (1.0 - s * (1.5 - 0.5 * s * s), 1.5 * (1.0 - s * s)))
}

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::super::{Law, Lengths, Reach};
    use super::*;
    use crate::numerics::four::Portable;

    /// H and X of contacts of one size that slip from their rims, and of sizes by which Phi is an exponential.
    type Levels = (&'static str, fn(f64) -> (f64, f64));
    const KINDS: [Levels; 2] = [
        ("one size", |s| (1.0 - s * (1.5 - 0.5 * s * s), 1.5 * (1.0 - s * s))),
        ("exponential", |s| (1.0 - s + s * s.ln(), -s.ln())),
    ];

    #[test]
    fn shares_are_1_together_where_one_level_has_most_of_the_strength() {
        for i in 0..100 {
            let row = Row::new(|s| (if s < 0.5 { 0.2 + 1e-3 * f64::from(i) } else { 0.0 }, 0.0));
            assert_eq!(row.shares.iter().map(|&share| f64::from(share)).sum::<f64>(), 1.0, "{i}");
        }
    }

    #[test]
    fn rows_hold_the_strength_of_levels_wherever_they_are_cut() {
        for (name, levels) in KINDS {
            let limits = Limits { first: 1000, rows: vec![Row::new(levels); 2] };
            for i in 0..200 {
                let place = 1.0 - 0.003 * f64::from(i);
                let (mut shares, mut slopes) = ([f64::NAN; LEVELS], [f64::NAN; LEVELS]);
                limits.at_excess::<Portable, true>(of_exponent(1000), [place, 0.3], &mut shares, &mut slopes);
                let total: f64 = shares.iter().sum();
                assert!((total - 1.0).abs() < 1e-15, "{name}, {place}: {total}");
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
        // x - Phi and 1 - its slope.
        type Lost = (&'static str, fn(f64) -> (f64, f64));
        let losses: [Lost; 2] = [
            ("one size", |x| {
                let root = (1.0 - x / 1.5).max(0.0).sqrt();
                (x - 1.0 + root * root * root, 1.0 - root)
            }),
            ("exponential", |x| (x - 1.0 + (-x).exp(), 1.0 - (-x).exp())),
        ];
        let x: [f64; 26] = std::array::from_fn(|k| SHORTEST * 1.35_f64.powi(k as i32));
        for ((name, levels), (_, loss)) in KINDS.into_iter().zip(losses) {
            let samples = x.map(|x| [x, loss(x).0, loss(x).1]);
            for i in 1..400 {
                let s = 1.0 - (f64::from(i) / 400.0).powi(3);
                let ((above, _), (expected, limit)) = (above_and_limit(&samples, s), levels(s));
                let error = above - expected;
                assert!(
                    error.abs() < 2e-2 && error.abs() < 0.05 * expected + 1e-14,
                    "{name} at {s}: {above}, not {expected}, {limit}"
                );
            }
        }
        assert_eq!(Row::new(KINDS[0].1), equal_contacts());
    }

    /// Of a compiled law, at all loads: at constant load the levels resist what the contacts do.
    #[test]
    fn levels_resist_what_the_contacts_of_their_load_do() {
        let branch = branch(0.001);
        let law = Law::new(&branch, 1.0, [1.0; 2], Lengths { unit: 1.0, origin: 0.0 }).expect("a law");
        for log_excess in [-20.0_f64, -8.3, -3.1, 0.2, 4.9, 9.0] {
            let (separation, sums) = branch.at_log_excess(log_excess, None).expect("a state");
            let (mut shares, mut slopes) = ([0.0; LEVELS], [0.0; LEVELS]);
            law.limits.at_excess::<Portable, false>(log_excess.exp(), [1.0, 0.0], &mut shares, &mut slopes);
            for x in [0.1, 0.5, 1.0, 2.0, 4.0] {
                let ratio = x * sums.friction / sums.radius;
                let slipping = branch.population().microslip(separation, ratio).expect("a force");
                let force: f64 = (0..LEVELS).map(|j| (x * (EDGES[j + 1] - EDGES[j])).min(shares[j])).sum();
                let error = force - slipping.force / sums.friction;
                assert!(error.abs() < 0.009, "{x} at {log_excess}: {force}, {error:+}");
            }
        }
    }

    /// Of a surface whose contacts slip alike from row to row, and of one where they do not.
    #[test]
    fn a_row_is_the_same_whatever_row_it_may_be_like() {
        use crate::population::tests::{of, surface, table, WEAK};
        for branch in [branch(0.001), Branch::new(of(&surface(WEAK, table(), [0.3, 0.7]))).expect("a branch")] {
            let reach =
                Reach { log_lightest: -20.0, log_heaviest: 14.0, has_pull_off: true, most_rows: 0, is_part: false };
            let curve = Curve::new(&branch, reach, &mut Vec::new()).expect("a curve");
            let far = Row::new(|s| (1.0 - s, 1e-3));
            let mut before = equal_contacts();
            for i in 0..16 {
                let at = |near: &Row| row_at(&branch, &curve, -19.0 + 2.0 * f64::from(i), near).expect("a row");
                let row = at(&far);
                let distance = at(&before).distance(&row);
                assert!(distance < TOLERANCE, "{i}: {distance:e}");
                before = row;
            }
        }
    }

    /// Values that rise evenly between two rows and not beyond them.
    #[test]
    fn rows_between_two_that_are_known_are_asked_for_where_their_mean_is_not_good() {
        for (end, rise, asked_for) in [
            (8, [0, 8], vec![4]),
            (8, [0, 2], vec![1, 2, 3, 4, 6]),
            (16, [0, 0], vec![8]),
            // The middle is the mean of the ends, which tells nothing of what lies between.
            (16, [4, 12], vec![2, 4, 6, 8, 10, 12, 14]),
        ] {
            let value = |row: usize| Row::of_nodes([[0.05 * row.clamp(rise[0], rise[1]) as f32, 0.0]; NODES]);
            let mut rows = vec![value(0); end + 1];
            rows[end] = value(end);
            let asked = std::cell::RefCell::new(Vec::new());
            let at = |row: usize, _: &Row| {
                asked.borrow_mut().push(row);
                Some(value(row))
            };
            fill_between(&mut rows, (0, end), &at);
            let mut asked = asked.into_inner();
            asked.sort_unstable();
            assert_eq!(asked, asked_for);
            for (row, found) in rows.iter().enumerate() {
                assert!(found.distance(&value(row)) < 1e-6, "{row}: {found:?}");
            }
        }
        // What is not known is the mean.
        let mut rows = [0.0, 0.0, 0.4].map(|above| Row::of_nodes([[above, 0.0]; NODES])).to_vec();
        fill_between(&mut rows, (0, 2), &|_, _| None);
        assert_eq!(rows[1], Row::of_nodes([[0.2, 0.0]; NODES]));
    }

    #[test]
    fn shares_do_not_jump_and_their_slopes_are_those_of_differences() {
        let rows = KINDS.into_iter().cycle().take(4).map(|(_, levels)| Row::new(levels)).collect();
        let limits = Limits { first: 1000, rows };
        let at = |x: f64, place: f64, slope: f64| {
            let (mut shares, mut slopes) = ([0.0; LEVELS], [0.0; LEVELS]);
            limits.at_excess::<Portable, true>(x, [place, slope], &mut shares, &mut slopes);
            (shares, slopes)
        };
        let first = of_exponent(1000);
        for (place, rate) in [(1.0, 0.0), (0.83, 0.0), (0.61, 0.2), (0.45, -0.3)] {
            for i in 0..300 {
                let x = first * 0.8 * 1.025_f64.powi(i);
                let (_, slopes) = at(x, place, rate / x);
                let moved = |by: f64| at(x * (1.0 + by), place + rate * by, rate / x).0;
                let (less, more) = (moved(-1e-6), moved(1e-6));
                // Slopes jump at rows.
                let is_at_row = (0..8).any(|binade| (x / of_exponent(1000 + binade) - 1.0).abs() < 2e-6);
                for j in (0..LEVELS).filter(|_| !is_at_row) {
                    let slope = (more[j] - less[j]) / (2e-6 * x);
                    assert!((slope - slopes[j]).abs() * x < 3e-5, "{place}, {i}, {j}: {slope:e}, {:e}", slopes[j]);
                }
            }
            // Where binades and rows meet.
            for binade in 0..7 {
                let x = of_exponent(1000 + binade);
                let ((less, _), (more, _)) = (at(x * (1.0 - 1e-12), place, 0.0), at(x, place, 0.0));
                for j in 0..LEVELS {
                    assert!((more[j] - less[j]).abs() < 1e-11, "{binade}, {j}: {} to {}", less[j], more[j]);
                }
            }
        }
        assert_eq!(at(0.0, 1.0, 0.0).0, limits.rows[0].shares.map(f64::from));
        assert_eq!(at(f64::MAX, 1.0, 0.0).0, limits.rows[3].shares.map(f64::from));
    }
}
