//! Levels of stiffness under one load: those that go and come with the load, and a step of displacement of all.

use super::cells::{edge_values, fall, lay, LEAST_OF_REACH};
use super::{at_most, energy, sum, within, within_cells, MicroslipStep, PerEdge, PerLevel};
use super::{CELL_WIDTHS, EDGES, LARGEST_WITH_SQUARE, LAST, LEVELS, NO_EDGE, NO_LEVEL, REACH, ROOTS, STATE};
use crate::numerics::elementary::hypot;
use crate::numerics::four::Four;

/// Displacements beyond this many times strength over stiffness are taken as this: all levels then slip.
pub const MOST_SLIP_LENGTHS: f64 = 1e140;
/// Slopes by load, over the strength, beyond this are taken as this: sums of them are numbers.
const LARGEST_SLOPE: f64 = 1e290;

/// A quantity and its slope by load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sloped {
    pub value: f64,
    pub slope: f64,
}

/// Levels under one load.
#[derive(Debug, Clone, Copy)]
pub struct Levels {
    /// The strength of all, at least 0.
    pub strength: Sloped,
    /// The stiffness of all, at least 0.
    pub stiffness: Sloped,
    /// What part of the strength what touches of each cell has, 1 together.
    pub shares: PerLevel,
    /// The slopes of the shares by load.
    pub share_slopes: PerLevel,
    /// What touches of each cell [force/length].
    width: PerLevel,
    /// What is left of the mean displacement of what touched before.
    kept: PerLevel,
    /// What part of the increment what touches has followed.
    followed: PerLevel,
    /// d(width times displacement)/d(stiffness) of each cell.
    came: [PerLevel; 2],
    /// What part of the increment the level at each edge has followed, and d(what levels below it have followed)/d(stiffness).
    following: PerEdge,
    gained: PerEdge,
}

/// Where the stiffness cuts the cells.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// The stiffness over the reach of the cells, from 0.4 to 1.
    pub place: f64,
    /// Its slope by load; 0 if the cells reach farther with load.
    pub slope: f64,
    /// Whether levels have gone or come.
    is_moved: bool,
    /// What energy went with levels, or is not held by cells that were laid anew.
    lost: f64,
}

impl Default for Levels {
    fn default() -> Self {
        let none = Sloped::default();
        Self {
            strength: none,
            stiffness: none,
            shares: NO_LEVEL,
            share_slopes: NO_LEVEL,
            width: NO_LEVEL,
            kept: NO_LEVEL,
            followed: NO_LEVEL,
            came: [NO_LEVEL; 2],
            following: NO_EDGE,
            gained: NO_EDGE,
        }
    }
}

impl Levels {
    /// Lets levels go and come, from the stiffness of the last step to this one. The state becomes what it is before the
    /// increment; a step of this increment is to follow, with the limits for this cut.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn cut<V: Four, const DETAILS: bool>(&mut self, increment: [f64; 2], state: &mut [f64; STATE]) -> Cut {
        let now = self.stiffness.value;
        let (reach, last) = (state[REACH], state[LAST]);
        let is_first = last <= 0.0;
        if is_first || (last == now && reach == now) {
            // Levels that touch for the first time follow all of the increment.
            if is_first {
                state.fill(0.0);
                (state[REACH], state[LAST]) = (now, now);
            }
            if DETAILS {
                self.width = CELL_WIDTHS.map(|width| width * now);
                (self.following, self.gained) = ([1.0; LEVELS + 4], NO_EDGE);
                if !is_first {
                    self.follow_half(1.0);
                }
                self.come_at_edges(increment, &edge_values(state));
            }
            return Cut { place: 1.0, slope: 0.0, is_moved: false, lost: 0.0 };
        }
        self.cut_anew::<V, DETAILS>(increment, state)
    }

    #[inline(always)]
    fn cut_anew<V: Four, const DETAILS: bool>(&mut self, increment: [f64; 2], state: &mut [f64; STATE]) -> Cut {
        let now = self.stiffness.value;
        let before = if DETAILS { energy(state) } else { 0.0 };
        let falls = now < state[LAST];
        let mut at_cut = [0.0; 2];
        if falls {
            let (from, place) = (state[LAST] / state[REACH], now / state[REACH]);
            state[LAST] = now;
            at_cut = fall([from, place], state);
            at_cut = [at_cut[0] + increment[0], at_cut[1] + increment[1]];
        }
        let is_laid_anew = now > state[REACH] || now < LEAST_OF_REACH * state[REACH];
        let edges = if is_laid_anew { lay(now, !falls, state) } else { [NO_EDGE; 2] };
        let mut lost = if DETAILS { (before - energy(state)).max(0.0) } else { 0.0 };
        let reach = state[REACH];
        // A root of it is to be more than 0.
        let (first, place) = ((state[LAST] / reach).max(f64::MIN_POSITIVE), now / reach);
        state[LAST] = now;
        for j in (0..LEVELS).step_by(4) {
            (within_cells(j, V::splat(place)) * V::splat(reach)).write(&mut self.width, j);
            V::splat(1.0).write(&mut self.kept, j);
            V::splat(1.0).write(&mut self.followed, j);
        }
        if DETAILS {
            (self.following, self.gained) = ([1.0; LEVELS + 4], NO_EDGE);
        }
        if place > first {
            lost += self.grow::<V, DETAILS>([first, place], increment, state);
        } else if DETAILS && !falls {
            self.follow_half(place);
        }
        if DETAILS {
            if is_laid_anew {
                self.come_at_edges(increment, &edges);
            } else {
                self.come_at_cut(place, increment, at_cut);
            }
        }
        Cut { place, slope: if is_laid_anew { 0.0 } else { self.stiffness.slope / reach }, is_moved: true, lost }
    }

    /// Lets levels come between two stiffnesses, over the reach of the cells; what energy is not held by cells of which a part
    /// touched before.
    ///
    /// On a straight path a level k has followed (K - k)/(K - K_0) (K_0/k)^(1/2) of the increment: what is left of it when the
    /// level comes, if the logarithm of the stiffness falls evenly with separation, to within the third power of its change.
    #[inline(always)]
    fn grow<V: Four, const DETAILS: bool>(
        &mut self,
        places: [f64; 2],
        increment: [f64; 2],
        state: &[f64; STATE],
    ) -> f64 {
        let [first, place] = places;
        let (root, end, change) = (first.sqrt(), place.sqrt(), place - first);
        let by_change = 1.0 / change;
        // The integral of that part from K_0 to each edge.
        let mut integral = NO_EDGE;
        let (firsts, lasts) = (V::splat(first), V::splat(place));
        let (roots, ends) = (V::splat(root), V::splat(end));
        for j in (0..LEVELS + 4).step_by(4) {
            let (edge, root_there) = (V::read(&EDGES, j).clamp(firsts, lasts), V::read(&ROOTS, j).clamp(roots, ends));
            let distance = (edge - firsts) / (root_there + roots);
            let weight = V::splat(2.0 * root) + distance * V::splat(2.0 / 3.0);
            let weighted = V::splat(root * by_change) * distance * distance * weight;
            (V::splat(2.0 * root) * distance - weighted).write(&mut integral, j);
            if DETAILS {
                (weighted * V::splat(by_change)).write(&mut self.gained, j);
                (roots / root_there * ((lasts - edge) * V::splat(by_change))).write(&mut self.following, j);
            }
        }
        let mut lost = V::splat(0.0);
        let (none, one) = (V::splat(0.0), V::splat(1.0));
        for j in (0..LEVELS).step_by(4) {
            let (touched, width) = (within_cells(j, firsts), within_cells(j, lasts));
            let fresh = V::read(&integral, j + 1) - V::read(&integral, j);
            let inverse = one / width.if_greater(none, width, one);
            let kept = touched * inverse;
            kept.write(&mut self.kept, j);
            ((touched + fresh) * inverse).write(&mut self.followed, j);
            if DETAILS {
                // What touched before and what came share one displacement from now on.
                let new = width - touched;
                let part = one - fresh / new.if_greater(none, new, one);
                let x = V::read(state, j) + part * V::splat(increment[0]);
                let y = V::read(state, LEVELS + j) + part * V::splat(increment[1]);
                lost = lost + kept * new * (x * x + y * y);
            }
        }
        0.5 * state[REACH] * lost.sum()
    }

    /// Lets half of the increment follow, in the mean, the levels that come at the stiffness of the last step.
    #[inline(always)]
    fn follow_half(&mut self, place: f64) {
        let edges = self.following.iter_mut().zip(&mut self.gained).zip(EDGES);
        for ((following, gained), _) in edges.filter(|(_, edge)| *edge >= place) {
            (*following, *gained) = (0.0, 0.5);
        }
    }

    /// How fast cells gain with the stiffness that reach farther with it, from displacements at their edges before the increment.
    #[inline(always)]
    fn come_at_edges(&mut self, increment: [f64; 2], edges: &[PerEdge; 2]) {
        for axis in 0..2 {
            let flux = |j: usize| {
                let there = edges[axis][j] + self.following[j] * increment[axis];
                EDGES[j] * there + self.gained[j] * increment[axis]
            };
            let mut below = 0.0;
            for j in 0..LEVELS {
                let above = flux(j + 1);
                self.came[axis][j] = above - below;
                below = above;
            }
        }
    }

    /// How fast the cell gains with the stiffness that is cut by it, from the displacement there.
    #[inline(always)]
    fn come_at_cut(&mut self, place: f64, increment: [f64; 2], at_cut: [f64; 2]) {
        for axis in 0..2 {
            for j in 0..LEVELS {
                let is_cut = EDGES[j] < place && place <= EDGES[j + 1];
                let grown = (self.gained[j + 1] - self.gained[j]) * increment[axis];
                self.came[axis][j] = if is_cut { grown + at_cut[axis] } else { grown };
            }
        }
    }

    /// Displaces all levels; the state becomes what it is after. Without `DETAILS` it tells only force and stiffness.
    #[inline(always)]
    pub fn step<V: Four, const DETAILS: bool>(
        &self,
        displacement: [f64; 2],
        cut: Cut,
        state: &mut [f64; STATE],
    ) -> MicroslipStep {
        let [dx, dy] = displacement;
        // Forces over a power of two next to the strength: their squares are numbers, and nothing is rounded by it.
        let unit = power_of_two_below(self.strength.value);
        let scale = 1.0 / unit;
        let (strength, stiffness) = (self.strength.value * scale, self.stiffness.value * scale);
        let (mut nx, mut ny, mut inverse) = (NO_LEVEL, NO_LEVEL, NO_LEVEL);
        let (none, one) = (V::splat(0.0), V::splat(1.0));
        let [mut fx, mut fy, mut xx, mut xy, mut yy] = [none; 5];
        for j in (0..LEVELS).step_by(4) {
            let limit = V::read(&self.shares, j) * V::splat(strength);
            let (mut x, mut y) = (V::read(state, j), V::read(state, LEVELS + j));
            let (width, follows) = if cut.is_moved {
                let (kept, followed) = (V::read(&self.kept, j), V::read(&self.followed, j));
                x = x * kept + V::splat(dx) * followed;
                y = y * kept + V::splat(dy) * followed;
                let width = V::read(&self.width, j) * V::splat(scale);
                (width, width * followed)
            } else {
                x = x + V::splat(dx);
                y = y + V::splat(dy);
                let width = V::read(&CELL_WIDTHS, j) * V::splat(stiffness);
                (width, width)
            };
            let (tx, ty) = (x * width, y * width);
            let (square, limit_square) = (tx * tx + ty * ty, limit * limit);
            // The direction of the force of one that slips, and what part of its displacement its limit leaves.
            let root = one / square.if_greater(limit_square, square, one).root();
            let inverted = square.if_greater(limit_square, root, none);
            let part = square.if_greater(limit_square, limit * root, one);
            let (ux, uy) = (tx * inverted, ty * inverted);
            (x * part).write(state, j);
            (y * part).write(state, LEVELS + j);
            if DETAILS {
                ux.write(&mut nx, j);
                uy.write(&mut ny, j);
                inverted.write(&mut inverse, j);
            }
            fx = fx + tx * part;
            fy = fy + ty * part;
            // A displacement across the direction of a level that slips turns its force.
            let turning = follows * part;
            xx = xx + turning * (one - ux * ux);
            xy = xy + turning * (ux * uy);
            yy = yy + turning * (one - uy * uy);
        }
        // Not by `map`, which is not compiled for the caller's instructions.
        let [fx, fy, xx, xy, yy] = [fx.sum(), fy.sum(), xx.sum(), xy.sum(), yy.sum()];
        let across = -xy * unit;
        let mut step = MicroslipStep {
            force: [fx * unit, fy * unit],
            stiffness: [xx * unit, across, across, yy * unit],
            ..MicroslipStep::default()
        };
        if DETAILS {
            let strength_slope = at_most(self.strength.slope * scale, LARGEST_SLOPE);
            let stiffness_slope = at_most(self.stiffness.slope * scale, LARGEST_SLOPE);
            let (mut by_x, mut by_y, mut slip, mut slipping) = (NO_LEVEL, NO_LEVEL, NO_LEVEL, NO_LEVEL);
            for j in 0..LEVELS {
                let share = self.shares[j];
                let limit = share * strength;
                let [gained_x, gained_y] =
                    [0, 1].map(|axis: usize| at_most(self.came[axis][j] * stiffness_slope, LARGEST_SLOPE));
                let slips = inverse[j] > 0.0;
                let limit_slope = at_most(share * strength_slope + self.share_slopes[j] * strength, LARGEST_SLOPE);
                let across = (ny[j] * gained_x - nx[j] * gained_y) * limit * inverse[j];
                by_x[j] = if slips { limit_slope * nx[j] + across * ny[j] } else { gained_x };
                by_y[j] = if slips { limit_slope * ny[j] - across * nx[j] } else { gained_y };
                let width = self.width[j] * scale;
                let excess = 1.0 / if slips { inverse[j] } else { 1.0 } - limit;
                slip[j] = if slips && width > 0.0 { limit * (excess / width) } else { 0.0 };
                slipping[j] = if slips { share } else { 0.0 };
            }
            step.dforce_dload = [&by_x, &by_y].map(|slopes| at_most(sum(slopes) * unit, f64::MAX));
            // Rounding errors of what slips by next to nothing are no work.
            step.dissipated = at_most(sum(&slip) * unit + cut.lost, f64::MAX).max(0.0);
            step.slipping = sum(&slipping).min(1.0);
        }
        step
    }

    /// A step of levels without strength or stiffness: their force is 0, and rises with load until they slip.
    #[inline(never)]
    pub fn step_of_none(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> MicroslipStep {
        let [dx, dy] = within(displacement, LARGEST_WITH_SQUARE);
        let size = hypot(dx, dy);
        let strength = at_most(self.strength.slope, LARGEST_WITH_SQUARE);
        let stiffness = at_most(self.stiffness.slope, LARGEST_WITH_SQUARE);
        let mut rate = 0.0;
        for (width, share) in CELL_WIDTHS.iter().zip(self.shares) {
            rate += (stiffness * width * size).min(strength * share);
        }
        let along = if size > 0.0 { rate / size } else { 0.0 };
        let dissipated = energy(state);
        state.fill(0.0);
        MicroslipStep { dforce_dload: [dx * along, dy * along], dissipated, ..MicroslipStep::default() }
    }
}

/// The largest power of two that is not above a positive number, but not so small that its inverse is no number.
#[inline(always)]
fn power_of_two_below(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits((x.to_bits() & EXPONENT).max(3 << 52))
}
