//! Levels of stiffness under one load: those that go and come with the load, and a step of displacement of all.

use super::cells::{fall, Cells, LEAST_OF_REACH};
use super::{at_most, energy, energy_by, within, within_cells, Blend, MicroslipStep, PerEdge, PerLevel};
use super::{CELL_WIDTHS, EDGES, LARGEST_WITH_SQUARE, LAST, LEVELS, NO_LEVEL, REACH, ROOTS, STATE};
use crate::numerics::elementary::hypot;
use crate::numerics::float_bits::finite;
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
#[derive(Debug, Clone, Copy, Default)]
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
    /// What part of the increment what touches has followed.
    followed: PerLevel,
    /// What energy each cell does not hold because what touched before and what came share one displacement, if nothing slips.
    mixed: PerLevel,
    /// The displacements at the edges before the increment, on their upper side but for the last.
    edges: [PerEdge; 2],
    /// What part of the increment the level at each edge has followed, and d(what levels below it have followed)/d(stiffness).
    following: PerEdge,
    gained: PerEdge,
}

/// Where the stiffness cuts the cells.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Cut {
    /// The stiffness over the reach of the cells, from 0.4 to 1.
    place: f64,
    /// The same with its slope by load, where the limits are cut; `None` if the cells reach farther with load.
    pub of_limits: Option<[f64; 2]>,
    reaches_farther: bool,
    /// Whether levels have gone, and the stiffness before over that after where some have come.
    falls: bool,
    grown: f64,
    /// The displacement there of what was cut.
    displacement: [f64; 2],
    /// What energy went with levels, or is not held by cells that were laid anew.
    lost: f64,
}

impl Levels {
    /// Lets levels go and come, from the stiffness of the last step to this one. The state becomes what it is before the
    /// increment; a step of this increment is to follow, with the limits for this cut.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn cut<V: Cells, const DETAILS: bool>(&mut self, increment: [f64; 2], state: &mut [f64; STATE]) -> Cut {
        let now = self.stiffness.value;
        let is_first = state[LAST] <= 0.0;
        if is_first {
            state.fill(0.0);
            (state[REACH], state[LAST]) = (now, now);
        }
        let (reach, last) = (state[REACH], state[LAST]);
        let falls = now < last;
        let is_laid_anew = now > reach || now < LEAST_OF_REACH * reach;
        let mut cut =
            Cut { reaches_farther: is_laid_anew || (last == now && reach == now), falls, grown: 1.0, ..Cut::default() };
        if falls {
            let ([x, y], gone) = fall([last / reach, now / reach], state);
            cut.lost = gone;
            cut.displacement = [x + increment[0], y + increment[1]];
            state[LAST] = now;
        }
        if is_laid_anew {
            let before = if DETAILS { energy_by::<V>(state) } else { 0.0 };
            V::lay(now, !falls, state, &mut self.edges);
            if DETAILS {
                cut.lost += (before - energy_by::<V>(state)).max(0.0);
            }
        } else if DETAILS && cut.reaches_farther {
            for axis in 0..2 {
                for j in (0..LEVELS).step_by(4) {
                    V::read(state, axis * LEVELS + j).write(&mut self.edges[axis], j);
                }
                // Beyond the last nothing has come yet.
                V::splat(0.0).write(&mut self.edges[axis], LEVELS);
            }
        }
        let reach = state[REACH];
        // A root of it is to be more than 0.
        let first = (state[LAST] / reach).max(f64::MIN_POSITIVE);
        cut.place = now / reach;
        cut.of_limits = (!cut.reaches_farther).then_some([cut.place, self.stiffness.slope / reach]);
        state[LAST] = now;
        for j in (0..LEVELS).step_by(4) {
            (within_cells(j, V::splat(cut.place)) * V::splat(reach)).write(&mut self.width, j);
            V::splat(1.0).write(&mut self.followed, j);
        }
        if DETAILS {
            self.mixed.fill(0.0);
            for j in (0..EDGES.len()).step_by(4) {
                V::splat(1.0).write(&mut self.following, j);
                V::splat(0.0).write(&mut self.gained, j);
            }
        }
        if cut.place > first {
            cut.grown = first / cut.place;
            self.grow::<DETAILS>([first, cut.place], increment, state);
        } else if DETAILS && !falls && !is_first {
            // Half of the increment is followed, in the mean, by levels that come at the stiffness of the last step.
            self.end_edges(cut.place, 0.5);
        }
        cut
    }

    /// Lets levels come between two stiffnesses, over the reach of the cells: the state becomes what is left of the mean
    /// displacements of what touched before.
    ///
    /// On a straight path a level k has followed (K - k)/(K - K_0) (K_0/k)^(1/2) of the increment: what is left of it when the
    /// level comes, if the logarithm of the stiffness falls evenly with separation, to within the third power of its change.
    #[inline(always)]
    fn grow<const DETAILS: bool>(&mut self, [first, place]: [f64; 2], increment: [f64; 2], state: &mut [f64; STATE]) {
        let (root, by_change) = (first.sqrt(), 1.0 / (place - first));
        let (mut at, mut following, mut below, mut weighted) = (first, 1.0, 0.0, 0.0);
        for j in EDGES[1..LEVELS].partition_point(|&edge| edge <= first)..LEVELS {
            if at >= place {
                break;
            }
            let is_whole = EDGES[j + 1] <= place;
            let (end, root_there) = if is_whole { (EDGES[j + 1], ROOTS[j + 1]) } else { (place, place.sqrt()) };
            // The integral of that part from K_0 to the end of the cell.
            let distance = (end - first) / (root_there + root);
            weighted = root * by_change * distance * distance * (2.0 * root + 2.0 / 3.0 * distance);
            let integral = 2.0 * root * distance - weighted;
            let (touched, new, fresh) = ((first - EDGES[j]).max(0.0), end - at, integral - below);
            let inverse = 1.0 / (touched + new);
            let following_there = root / root_there * (place - end) * by_change;
            if DETAILS {
                // What touched before and what came share one displacement from now on, and what came has another at each level.
                let part = 1.0 - fresh / new;
                let [x, y] =
                    [0, 1].map(|axis| at_most(state[axis * LEVELS + j] + part * increment[axis], LARGEST_WITH_SQUARE));
                let [dx, dy] = within(increment, LARGEST_WITH_SQUARE);
                let bend = (following - following_there) * (following - following_there) / 12.0;
                let apart = touched * inverse * (x * x + y * y) + bend * (dx * dx + dy * dy);
                self.mixed[j] = 0.5 * state[REACH] * new * apart;
                (self.following[j + 1], self.gained[j + 1]) = (following_there, weighted * by_change);
            }
            state[j] *= touched * inverse;
            state[LEVELS + j] *= touched * inverse;
            self.followed[j] = (touched + fresh) * inverse;
            (at, following, below) = (end, following_there, integral);
        }
        if DETAILS {
            self.end_edges(place, weighted * by_change);
        }
    }

    /// What the edges that do not touch yet have.
    #[inline(always)]
    fn end_edges(&mut self, place: f64, gained: f64) {
        for j in (0..EDGES.len()).rev().take_while(|&j| EDGES[j] >= place) {
            (self.following[j], self.gained[j]) = (0.0, gained);
        }
    }

    /// d(width times displacement of all cells below an edge)/d(stiffness), at four edges.
    #[inline(always)]
    fn gain<V: Four>(&self, j: usize, axis: usize, increment: [f64; 2], cut: &Cut) -> V {
        let (edge, by) = (V::read(&EDGES, j), V::splat(increment[axis]));
        let came = if cut.reaches_farther {
            edge * (V::read(&self.edges[axis], j) + V::read(&self.following, j) * by)
        } else {
            V::splat(cut.place).if_greater(edge, V::splat(0.0), V::splat(cut.displacement[axis]))
        };
        came + V::read(&self.gained, j) * by
    }

    /// Displaces all levels; the state becomes what it is after. Without `DETAILS` it tells only force and stiffness.
    #[inline(always)]
    pub fn step<V: Four, const DETAILS: bool>(
        &self,
        increment: [f64; 2],
        cut: Cut,
        state: &mut [f64; STATE],
    ) -> MicroslipStep {
        // Forces over a power of two next to the strength: their squares are numbers, and nothing is rounded by it.
        let unit = power_of_two_below(self.strength.value);
        let scale = V::splat(1.0 / unit);
        let strength = V::splat(self.strength.value) * scale;
        // Nothing by `map` or a closure, which are not compiled for the caller's instructions.
        let (dx, dy) = (V::splat(increment[0]), V::splat(increment[1]));
        let (none, one) = (V::splat(0.0), V::splat(1.0));
        // The squares of the forces before where the limit may be less than they.
        let mut had = NO_LEVEL;
        let [mut fx, mut fy, mut xx, mut mixed] = [none; 4];
        let mut all_stick = true;
        for j in (0..LEVELS).step_by(4) {
            let (followed, width) = (V::read(&self.followed, j), V::read(&self.width, j) * scale);
            let (mut x, mut y) = (V::read(state, j), V::read(state, LEVELS + j));
            if DETAILS && cut.falls {
                let (tx, ty) = (x * width, y * width);
                (tx * tx + ty * ty).write(&mut had, j);
            }
            (x, y) = (x + dx * followed, y + dy * followed);
            x.write(state, j);
            y.write(state, LEVELS + j);
            let (tx, ty, limit) = (x * width, y * width, V::read(&self.shares, j) * strength);
            all_stick &= !(tx * tx + ty * ty).any_greater(limit * limit);
            (fx, fy, xx) = (fx + tx, fy + ty, xx + width * followed);
            if DETAILS {
                mixed = mixed + V::read(&self.mixed, j);
            }
        }
        let mut step = MicroslipStep::default();
        if all_stick {
            step.force = [fx.sum() * unit, fy.sum() * unit];
            step.stiffness = [xx.sum() * unit, 0.0, 0.0, xx.sum() * unit];
            if DETAILS {
                let by_load = at_most(self.stiffness.slope / unit, LARGEST_SLOPE);
                for axis in 0..2 {
                    let gained =
                        at_most(self.gain::<V>(LEVELS, axis, increment, &cut).numbers()[0] * by_load, LARGEST_SLOPE);
                    step.dforce_dload[axis] = at_most(gained * unit, f64::MAX);
                }
                step.dissipated = at_most(mixed.sum() + cut.lost, f64::MAX);
            }
            return step;
        }
        let [mut xy, mut yy, mut by_x, mut by_y, mut slip, mut slipping] = [none; 6];
        [fx, fy, xx, mixed] = [none; 4];
        let most = V::splat(LARGEST_SLOPE);
        let strength_slope = V::splat(at_most(self.strength.slope / unit, LARGEST_SLOPE));
        let stiffness_slope = V::splat(at_most(self.stiffness.slope / unit, LARGEST_SLOPE));
        for j in (0..LEVELS).step_by(4) {
            let share = V::read(&self.shares, j);
            let (followed, width, limit) =
                (V::read(&self.followed, j), V::read(&self.width, j) * scale, share * strength);
            let (x, y) = (V::read(state, j), V::read(state, LEVELS + j));
            let (tx, ty) = (x * width, y * width);
            let (square, limit_square) = (tx * tx + ty * ty, limit * limit);
            let slips = square.any_greater(limit_square);
            let (mut gained_x, mut gained_y) = (none, none);
            if DETAILS {
                let came_x = self.gain::<V>(j + 1, 0, increment, &cut) - self.gain::<V>(j, 0, increment, &cut);
                let came_y = self.gain::<V>(j + 1, 1, increment, &cut) - self.gain::<V>(j, 1, increment, &cut);
                gained_x = (came_x * stiffness_slope).clamp(none - most, most);
                gained_y = (came_y * stiffness_slope).clamp(none - most, most);
            }
            if !slips {
                (fx, fy, xx, yy) = (fx + tx, fy + ty, xx + width * followed, yy + width * followed);
                if DETAILS {
                    (by_x, by_y, mixed) = (by_x + gained_x, by_y + gained_y, mixed + V::read(&self.mixed, j));
                }
                continue;
            }
            // The direction of the force of one that slips, and what part of its displacement its limit leaves.
            let size = square.if_greater(limit_square, square, one).root();
            let root = one / size;
            let inverted = square.if_greater(limit_square, root, none);
            let part = square.if_greater(limit_square, limit * root, one);
            let (ux, uy) = (tx * inverted, ty * inverted);
            (x * part).write(state, j);
            (y * part).write(state, LEVELS + j);
            (fx, fy) = (fx + tx * part, fy + ty * part);
            // A displacement across the direction of a level that slips turns its force.
            let turning = width * followed * part;
            xx = xx + turning * (one - ux * ux);
            xy = xy + turning * (ux * uy);
            yy = yy + turning * (one - uy * uy);
            if DETAILS {
                let limit_slope = share * strength_slope + V::read(&self.share_slopes, j) * strength;
                let limit_slope = limit_slope.clamp(none - most, most);
                let across = (uy * gained_x - ux * gained_y) * part;
                by_x = by_x + square.if_greater(limit_square, limit_slope * ux + across * uy, gained_x);
                by_y = by_y + square.if_greater(limit_square, limit_slope * uy - across * ux, gained_y);
                // The limit grows as the stiffness does while a level slips; where it falls, slip begins at the force that there was.
                let mut begins = limit * V::splat(cut.grown);
                if cut.falls {
                    let had = V::read(&had, j);
                    begins = had.if_greater(square, square, had).if_greater(limit_square, had, limit_square).root();
                }
                let resists = V::splat(0.5) * (limit + begins);
                let slid = (size - limit) / square.if_greater(limit_square, width, one);
                slip = slip + square.if_greater(limit_square, resists * slid, none);
                mixed = mixed + V::read(&self.mixed, j) * part * part;
                slipping = slipping + square.if_greater(limit_square, share, none);
            }
        }
        let across = -xy.sum() * unit;
        step.force = [fx.sum() * unit, fy.sum() * unit];
        step.stiffness = [xx.sum() * unit, across, across, yy.sum() * unit];
        if DETAILS {
            step.dforce_dload = [at_most(by_x.sum() * unit, f64::MAX), at_most(by_y.sum() * unit, f64::MAX)];
            // Rounding errors of what slips by next to nothing are no work.
            step.dissipated = at_most(slip.sum() * unit + mixed.sum() + cut.lost, f64::MAX).max(0.0);
            step.slipping = slipping.sum().min(1.0);
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

/// Displaces levels that reach up to the stiffness, as in the step before; `None`, with the state as it was, if one of them slips.
#[inline(always)]
pub fn stuck<V: Four>(
    [strength, stiffness]: [Sloped; 2],
    blend: &Blend,
    increment: [f64; 2],
    state: &mut [f64; STATE],
) -> Option<MicroslipStep> {
    let unit = power_of_two_below(strength.value);
    let scale = V::splat(1.0 / unit);
    let (reach, strength) = (V::splat(stiffness.value), V::splat(strength.value) * scale);
    let (dx, dy, none) = (V::splat(increment[0]), V::splat(increment[1]), V::splat(0.0));
    let [mut fx, mut fy, mut xx] = [none; 3];
    for j in (0..LEVELS).step_by(4).rev() {
        let width = V::read(&CELL_WIDTHS, j) * reach * scale;
        let (x, y) = (V::read(state, j) + dx, V::read(state, LEVELS + j) + dy);
        let (tx, ty, limit) = (x * width, y * width, blend.shares::<V>(j).0 * strength);
        // The narrow ones at the top slip first.
        if (tx * tx + ty * ty).any_greater(limit * limit) {
            return None;
        }
        (fx, fy, xx) = (fx + tx, fy + ty, xx + width);
    }
    // What is not finite has no finite force.
    let force = [fx.sum() * unit, fy.sum() * unit];
    if !(finite(force[0]) && finite(force[1])) {
        return None;
    }
    for j in (0..LEVELS).step_by(4) {
        (V::read(state, j) + dx).write(state, j);
        (V::read(state, LEVELS + j) + dy).write(state, LEVELS + j);
    }
    // Half of the increment is followed by levels that come with more load.
    let by_load = at_most(stiffness.slope / unit, LARGEST_SLOPE);
    let mut dforce_dload = increment;
    for slope in &mut dforce_dload {
        *slope = at_most(at_most(0.5 * *slope * by_load, LARGEST_SLOPE) * unit, f64::MAX);
    }
    let stiffness = xx.sum() * unit;
    Some(MicroslipStep { force, stiffness: [stiffness, 0.0, 0.0, stiffness], dforce_dload, ..MicroslipStep::default() })
}
