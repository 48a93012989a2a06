//! Cells of levels laid on another stiffness, and cut by a lower one: no energy comes with it.

use super::{energy_by, within_cell, PerEdge, PerLevel, EDGES, LAST, LEVELS, NO_EDGE, NO_LEVEL, REACH, STATE};
use crate::numerics::float_bits::finite;
use crate::numerics::four::{Four, Portable};

/// The cells are laid anew where the stiffness is less than this part of their reach.
pub const LEAST_OF_REACH: f64 = 0.4;

/// What is narrower than this part of the reach holds nothing, so that its inverse is a number.
const NARROWEST_CELL: f64 = 1e-290;

/// Cells that reach up to a stiffness; the integral of the displacements over levels is as before, and the energy not more. The
/// displacements at the new edges, on their upper side but for the last.
///
/// Within a cell displacements are taken as linear if so asked, so that what is held is not smeared out when this happens in every
/// step; as far as that would add energy, as constant.
#[inline(always)]
pub fn lay<V: Four>(reach: f64, is_linear: bool, state: &mut [f64; STATE], edges: &mut [PerEdge; 2]) {
    let before = *state;
    let place = before[LAST] / before[REACH];
    let stretch = reach / before[REACH];
    let (centers, slopes) = if is_linear { slopes::<V>(&before, place) } else { (NO_EDGE, [NO_LEVEL; 2]) };
    let mut bend = [NO_EDGE; 2];
    let mut bends = [NO_LEVEL; 2];
    let (mut cell, mut at) = (0, 0.0);
    // The energy of constants, that with slopes less that of constants, and that of what slopes add alone, twice over.
    let [mut constant, mut mixed, mut bent] = [0.0; 3];
    for j in 0..LEVELS {
        let (start, end) = (at, EDGES[j + 1] * stretch);
        let to = end.min(place);
        let (mut integral, mut added) = ([0.0; 2], [0.0; 2]);
        // All old cells that end before, and a part of the one that does not.
        loop {
            let is_whole = EDGES[cell + 1] <= to && cell + 1 < LEVELS;
            let until = if is_whole { EDGES[cell + 1] } else { to };
            let (width, off) = (until - at, 0.5 * (until + at) - centers[cell]);
            for axis in 0..2 {
                integral[axis] += width * before[axis * LEVELS + cell];
                added[axis] += width * off * slopes[axis][cell];
            }
            at = until;
            if !is_whole {
                break;
            }
            cell += 1;
        }
        let width = to - start;
        let inverse = if width > NARROWEST_CELL { 1.0 / width } else { 0.0 };
        let touches = end < place || (j + 1 == LEVELS && end <= place);
        for axis in 0..2 {
            let (mean, more) = (integral[axis] * inverse, added[axis] * inverse);
            state[axis * LEVELS + j] = mean;
            bends[axis][j] = more;
            constant += width * mean * mean;
            mixed += width * mean * more;
            bent += width * more * more;
            edges[axis][j + 1] = if touches { before[axis * LEVELS + cell] } else { 0.0 };
            bend[axis][j + 1] = if touches { slopes[axis][cell] * (end - centers[cell]) } else { 0.0 };
        }
    }
    let allowed = 2.0 * energy_by::<V>(&before) / before[REACH];
    let part = if constant + 2.0 * mixed + bent <= allowed {
        1.0
    } else {
        // As much of the slopes as the energy allows: the positive root of a quadratic.
        let room = (allowed - constant).max(0.0);
        let root = (mixed * mixed + bent * room).sqrt();
        if mixed > 0.0 {
            room / (mixed + root)
        } else {
            (root - mixed) / bent
        }
    };
    let part = if finite(part) { part.clamp(0.0, 1.0) } else { 0.0 };
    for axis in 0..if part > 0.0 { 2 } else { 0 } {
        for j in 0..LEVELS {
            state[axis * LEVELS + j] += part * bends[axis][j];
            edges[axis][j + 1] += part * bend[axis][j + 1];
        }
    }
    state[REACH] = reach;
}

/// Numbers side by side by whose instructions [`lay`] is compiled once.
pub trait Cells: Four {
    fn lay(reach: f64, is_linear: bool, state: &mut [f64; STATE], edges: &mut [PerEdge; 2]);
}

impl Cells for Portable {
    #[inline(never)]
    fn lay(reach: f64, is_linear: bool, state: &mut [f64; STATE], edges: &mut [PerEdge; 2]) {
        lay::<Self>(reach, is_linear, state, edges);
    }
}

/// Takes away what lies above a place; the displacement there, and the energy that goes with it.
///
/// The lower part of the cell that is cut keeps its own mean, as far as no energy comes with it.
#[inline(always)]
pub fn fall([from, place]: [f64; 2], state: &mut [f64; STATE]) -> ([f64; 2], f64) {
    let cut = EDGES[..LEVELS].iter().filter(|&&edge| edge < place).count().max(1) - 1;
    // Where cells are laid anew, all are constant.
    let slope = if place < LEAST_OF_REACH { [0.0; 2] } else { slope(state, from, cut) };
    let width = within_cell(cut, from);
    let lower = within_cell(cut, place);
    let off = 0.5 * (lower - width);
    let (mut before, mut after) = (0.0, 0.0);
    let mut moved = [0.0; 2];
    for axis in 0..2 {
        let mean = state[axis * LEVELS + cut];
        moved[axis] = mean + slope[axis] * off;
        before += width * mean * mean;
        after += lower * moved[axis] * moved[axis];
    }
    let is_allowed = after <= before;
    let mut at_cut = [0.0; 2];
    let mut gone = if is_allowed { before - after } else { before * (1.0 - lower / width) };
    for axis in 0..2 {
        let x = &mut state[axis * LEVELS + cut];
        *x = if is_allowed { moved[axis] } else { *x };
        at_cut[axis] = if is_allowed { *x + slope[axis] * 0.5 * lower } else { *x };
        let above = &mut state[axis * LEVELS + cut + 1..(axis + 1) * LEVELS];
        for (j, x) in (cut + 1..LEVELS).zip(&*above).take_while(|&(j, _)| EDGES[j] < from) {
            gone += within_cell(j, from) * x * x;
        }
        above.fill(0.0);
    }
    let energy = 0.5 * state[REACH] * gone;
    (at_cut, if finite(energy) { energy.max(0.0) } else { f64::MAX })
}

/// The middle of what touches of a cell, over their reach.
#[inline(always)]
fn center(j: usize, place: f64) -> f64 {
    0.5 * (EDGES[j] + EDGES[j + 1].min(place))
}

/// How fast displacements change from a cell to the next.
#[inline(always)]
fn change(state: &[f64; STATE], place: f64, j: usize) -> [f64; 2] {
    let distance = 1.0 / (center(j + 1, place) - center(j, place));
    [0, LEVELS].map(|axis| (state[axis + j + 1] - state[axis + j]) * distance)
}

/// The harmonic mean of two changes, 0 where they turn.
#[inline(always)]
fn harmonic(below: [f64; 2], above: [f64; 2]) -> [f64; 2] {
    let product = above[0] * below[0] + above[1] * below[1];
    let sum = [above[0] + below[0], above[1] + below[1]];
    let square = sum[0] * sum[0] + sum[1] * sum[1];
    let part = 2.0 * (product / square);
    if product > 0.0 && finite(part) {
        [part * sum[0], part * sum[1]]
    } else {
        [0.0; 2]
    }
}

/// How displacements change within a cell: as from the cell below and to the one above; as from below in the last that touches.
#[inline(always)]
fn slope(state: &[f64; STATE], place: f64, j: usize) -> [f64; 2] {
    if j == 0 {
        return [0.0; 2];
    }
    let below = change(state, place, j - 1);
    if j + 1 < LEVELS && EDGES[j + 1] < place {
        harmonic(below, change(state, place, j))
    } else {
        below
    }
}

/// The middles of what touches of cells, and how displacements change within them.
#[inline(always)]
fn slopes<V: Four>(state: &[f64; STATE], place: f64) -> (PerEdge, [PerLevel; 2]) {
    let (mut centers, mut slopes) = (NO_EDGE, [NO_LEVEL; 2]);
    let (none, half, place) = (V::splat(0.0), V::splat(0.5), V::splat(place));
    for j in (0..LEVELS).step_by(4) {
        let end = V::read(&EDGES, j + 1);
        (half * (V::read(&EDGES, j) + end.if_greater(place, place, end))).write(&mut centers, j);
    }
    // How fast they change from the cell before to each cell; from none to the first.
    let mut changes = [NO_EDGE; 2];
    for j in (0..LEVELS).step_by(4) {
        let distance = V::splat(1.0) / (V::read(&centers, j + 1) - V::read(&centers, j));
        for (at, changes) in [j, LEVELS + j].into_iter().zip(&mut changes) {
            ((V::read(state, at + 1) - V::read(state, at)) * distance).write(changes, j + 1);
        }
    }
    for j in (0..LEVELS).step_by(4) {
        let (start, end) = (V::read(&EDGES, j), V::read(&EDGES, j + 1));
        let (x, x_above) = (V::read(&changes[0], j), V::read(&changes[0], j + 1));
        let (y, y_above) = (V::read(&changes[1], j), V::read(&changes[1], j + 1));
        let (product, sum_x, sum_y) = (x_above * x + y_above * y, x_above + x, y_above + y);
        let part = V::splat(2.0) * (product / (sum_x * sum_x + sum_y * sum_y));
        let part = product.if_greater(none, V::splat(f64::INFINITY).if_greater(part, part, none), none);
        for (axis, below, sum) in [(0, x, sum_x), (1, y, sum_y)] {
            let slope = place.if_greater(end, part * sum, below);
            place.if_greater(start, slope, none).write(&mut slopes[axis], j);
        }
    }
    (centers, slopes)
}

#[cfg(test)]
mod tests {
    use super::super::energy;
    use super::*;
    use crate::numerics::random::Random;

    /// The cells keep the integral of displacements over levels.
    #[test]
    fn cells_that_are_laid_anew_hold_the_same_force_and_no_more_energy() {
        let mut random = Random(3);
        let mut between = |from: f64, to: f64| random.between(from, to);
        for i in 0..4000 {
            let mut state = [0.0; STATE];
            (state[REACH], state[LAST]) = (2.0, 2.0 * between(0.05, 1.0));
            let place = state[LAST] / state[REACH];
            for j in (0..LEVELS).filter(|&j| EDGES[j] < place) {
                let smooth = [(3.0 * EDGES[j]).sin(), 1.0 - EDGES[j]];
                for axis in 0..2 {
                    state[axis * LEVELS + j] = if i % 2 == 0 { between(-1.0, 1.0) } else { smooth[axis] };
                }
            }
            let force = |state: &[f64; STATE]| {
                let width = |j: usize| within_cell(j, state[LAST] / state[REACH]) * state[REACH];
                [0, 1].map(|axis| (0..LEVELS).map(|j| width(j) * state[axis * LEVELS + j]).sum::<f64>())
            };
            let (held, before) = (energy(&state), force(&state));
            let reach = state[LAST] * if i % 3 == 0 { 1.0 } else { between(1.0, 1.5) };
            lay::<Portable>(reach, true, &mut state, &mut [NO_EDGE; 2]);
            let after = force(&state);
            assert!(energy(&state) <= held * (1.0 + 1e-14) && state[REACH] == reach, "{i}: {held}, {}", energy(&state));
            for axis in 0..2 {
                assert!((after[axis] - before[axis]).abs() < 1e-14, "{i}: {before:?} to {after:?}");
            }
            // What is smooth is hardly smeared out.
            assert!(i % 2 == 0 || energy(&state) > 0.99 * held, "{i}: {} of {held}", energy(&state));
        }
    }
}
