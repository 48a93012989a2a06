//! The strength of the levels against load: it hardly changes, and values at a few loads are blended.

use super::strengths::{self, Strengths, LEVEL_NODES};
use super::{PerLevel, LEVELS};
use crate::equilibrium::Branch;
use crate::numerics::float_bits::{power_of_two, MANTISSA_BITS};
use crate::numerics::four::Four;

/// There is a row at each load that is a power of two; the contacts are asked at every so many in any case.
const MOST_BINADES: usize = 16;
/// Beyond the outermost rows H differs from theirs by no more than this. Between them the contacts are asked where H differs by more than
/// twice this from the mean of its neighbours, or, over more than half as many rows, from either.
const ROW_TOLERANCE: f32 = 2e-3;

/// The strength of the levels at a load, between two loads.
#[derive(Debug, Clone, Copy)]
pub struct Blend<'a> {
    before: &'a Strengths,
    after: &'a Strengths,
    /// What part of the way it is from one to the other, and its slope by load.
    part: f64,
    part_slope: f64,
}

impl Blend<'_> {
    /// The shares of four cells where all levels touch, and what has to be added by load.
    #[inline(always)]
    pub fn shares<V: Four>(&self, j: usize) -> (V, V) {
        let from = V::read_single(&self.before.shares, j);
        let change = V::read_single(&self.after.shares, j) - from;
        (from + V::splat(self.part) * change, change)
    }
}

/// The strength of the levels at loads that are powers of two above pull-off.
#[derive(Debug, Clone)]
pub struct Limits {
    /// The biased exponent of the first.
    first: u64,
    rows: Vec<Strengths>,
}

impl Limits {
    /// The limits between two values of load - pull-off. `contacts` gives the separation at such a value, and the friction force over
    /// the sum of contact radii; `None` where they are not known.
    pub fn new(branch: &Branch, ends: [f64; 2], contacts: &dyn Fn(f64) -> Option<[f64; 2]>) -> Self {
        let [first, last] = ends.map(|x| x.to_bits() >> MANTISSA_BITS);
        let at = |row: usize, near: &Strengths| {
            let [separation, unit] = contacts(power_of_two(first + row as u64))?;
            strengths::of_contacts(branch, separation, unit, near)
        };
        let (end, equal) = ((last - first).max(1) as usize - 1, strengths::of_equal_contacts());
        // What is not known is taken from the next lighter load; most likely the lightest is the one that is not.
        let lightest = at(0, &equal).or_else(|| at(MOST_BINADES.min(end), &equal)).unwrap_or(equal);
        let mut rows = vec![lightest; end + 1];
        for from in (0..end).step_by(MOST_BINADES) {
            let to = (from + MOST_BINADES).min(end);
            rows[to] = at(to, &rows[from]).unwrap_or(rows[from]);
            fill_between(&mut rows, (from, to), &at);
        }
        // Beyond the loads at which rows change the last is enough.
        let alike = |row: &Strengths, other: &Strengths| row.distance(other) < ROW_TOLERANCE;
        let heavy = rows.iter().rev().take_while(|row| alike(row, &rows[rows.len() - 1])).count() - 1;
        rows.truncate(rows.len() - heavy);
        let light = rows.iter().take_while(|row| alike(row, &rows[0])).count() - 1;
        rows.drain(..light);
        rows.shrink_to_fit();
        Self { first: first + light as u64, rows }
    }

    /// The shares of cells in the strength, at load - pull-off, where they are to be; with `SLOPES` also by load. Cells that do not reach
    /// farther with load are cut at a place with this slope.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn at_excess<V: Four, const SLOPES: bool>(
        &self,
        x: f64,
        cut: Option<[f64; 2]>,
        shares: &mut PerLevel,
        slopes: &mut PerLevel,
    ) {
        let blend = self.around(x);
        let Blend { before, after, part, part_slope } = blend;
        let Some(cut) = cut else {
            for j in (0..LEVELS).step_by(4) {
                let (share, change) = blend.shares::<V>(j);
                share.write(shares, j);
                if SLOPES {
                    (V::splat(part_slope) * change).write(slopes, j);
                }
            }
            return;
        };
        let (mut nodes, mut node_slopes) = ([[0.0; 2]; LEVEL_NODES], [[0.0; 2]; LEVEL_NODES]);
        for j in (0..2 * LEVEL_NODES).step_by(4) {
            let from = V::read_single(before.nodes.as_flattened(), j);
            let change = V::read_single(after.nodes.as_flattened(), j) - from;
            (from + V::splat(part) * change).write(nodes.as_flattened_mut(), j);
            if SLOPES {
                (V::splat(part_slope) * change).write(node_slopes.as_flattened_mut(), j);
            }
        }
        strengths::shares_of_cut::<V, SLOPES>(&nodes, &node_slopes, cut, shares, slopes);
    }

    /// By how much less than contacts that stick those at load - pull-off resist a displacement, over strength by stiffness: the force
    /// over the strength, and the part of the stiffness.
    pub fn lost(&self, x: f64, displacement: f64) -> [f64; 2] {
        let Blend { before, after, part, .. } = self.around(x);
        let (from, to) = (before.lost(displacement), after.lost(displacement));
        [0, 1].map(|i| from[i] + part * (to[i] - from[i]))
    }

    /// The strength at load - pull-off.
    #[inline(always)]
    pub fn around(&self, x: f64) -> Blend<'_> {
        let end = self.rows.len() - 1;
        let binades = (x.max(0.0).to_bits() >> MANTISSA_BITS).saturating_sub(self.first);
        let row = binades as usize;
        if row >= end || x < power_of_two(self.first) {
            let row = &self.rows[row.min(end)];
            return Blend { before: row, after: row, part: 0.0, part_slope: 0.0 };
        }
        let unit = power_of_two(self.first + binades);
        // Close to log2(x), with a slope that does not jump where binades meet.
        let t = x / unit - 1.0;
        let (part, part_slope) = (t * (4.0 - t) / 3.0, (4.0 - 2.0 * t) / (3.0 * unit));
        Blend { before: &self.rows[row], after: &self.rows[row + 1], part, part_slope }
    }
}

/// Fills the rows between two that are known: with their means, but where H is found to be another.
fn fill_between(
    rows: &mut [Strengths],
    (from, to): (usize, usize),
    at: &dyn Fn(usize, &Strengths) -> Option<Strengths>,
) {
    if to - from < 2 {
        return;
    }
    let middle = (from + to) / 2;
    let mean = rows[from].mean(&rows[to]);
    rows[middle] = at(middle, &mean).unwrap_or(mean);
    let none = |_: usize, _: &Strengths| None;
    // The means of halves are a quarter as far off.
    let is_near = |other: &Strengths| rows[middle].distance(other) < 2.0 * ROW_TOLERANCE;
    let is_known = is_near(&mean) && (2 * (to - from) <= MOST_BINADES || is_near(&rows[from]) && is_near(&rows[to]));
    let at = if is_known { &none } else { at };
    fill_between(rows, (from, middle), at);
    fill_between(rows, (middle, to), at);
}
