//! Levels of stiffness, each with an elastic displacement of its own in the plane: what a contact whose load changes remembers
//! (R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327; J. Jaeger, Arch. Appl. Mech. 65 (1995) 478).
//!
//! The stiffness K of a contact grows with its load, and each level from 0 to K is what touches at the load at which the
//! stiffness is that level. Less load takes the highest levels away, with their force and energy; more load brings levels that
//! have not been displaced. A level follows the surfaces up to its limit, and slips beyond. Cells of levels share one
//! displacement, their mean; a cell that K cuts counts up to K. What the limits are is left to `law`.

use crate::error::Error;
use crate::numerics::elementary::hypot;
use crate::numerics::float_bits::finite;
use crate::numerics::four::Four;

/// How many cells of levels there are.
pub const LEVELS: usize = 20;
/// The state: the displacements of the cells along the first direction, then along the second, then the stiffness up to which
/// the cells reach, and that of the last step.
pub const STATE: usize = 2 * LEVELS + 2;
/// Where in the state the stiffness is up to which the cells reach...
pub const REACH: usize = 2 * LEVELS;
/// ...and that of the last step.
pub const LAST: usize = REACH + 1;

/// The roots of the edges of the cells, over the stiffness up to which they reach. Narrow at the top, where levels slip first,
/// so that small cycles dissipate what they should (`tests/physics/microslip.rs`), and nowhere wider than needed to keep what is
/// held while the load comes and goes.
const ROOTS: PerEdge = [
    0.0, 0.174, 0.2946, 0.4082, 0.5189, 0.6307, 0.6712, 0.7173, 0.7644, 0.8095, 0.8593, 0.9032, 0.9347, 0.9559, 0.9709,
    0.9811, 0.9901, 0.9949, 0.9974, 0.9992, 1.0, 1.0, 1.0, 1.0,
];

/// The edges of the cells.
pub const EDGES: PerEdge = {
    let mut edges = ROOTS;
    let mut j = 0;
    while j < edges.len() {
        edges[j] *= ROOTS[j];
        j += 1;
    }
    edges
};

static WIDTHS: PerLevel = {
    let mut widths = NONE;
    let mut j = 0;
    while j < LEVELS {
        widths[j] = EDGES[j + 1] - EDGES[j];
        j += 1;
    }
    widths
};

/// The cells are laid anew where the stiffness is less than this part of their reach.
const LEAST_OF_REACH: f64 = 0.4;

/// What is narrower than this part of the reach holds nothing: its inverse is a number.
const NARROWEST: f64 = 1e-290;

/// Displacements beyond this many times strength over stiffness are taken as this: all levels then slip.
pub const FARTHEST: f64 = 1e140;
/// Over the strength of all, no slope by load is taken as larger: sums of them are numbers.
const STEEPEST: f64 = 1e290;
/// No slope of a contact without strength is taken as larger, and no displacement whose energy is asked for.
const LARGEST: f64 = 1e150;

/// A number for each cell.
pub type PerLevel = [f64; LEVELS];
/// A number for each edge of a cell, and three more: edges are read by fours.
pub type PerEdge = [f64; LEVELS + 4];
const NO_EDGE: PerEdge = [0.0; LEVELS + 4];
const NONE: PerLevel = [0.0; LEVELS];

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
    /// By load.
    pub share_slopes: PerLevel,
    /// Of each cell what touches [force/length].
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

/// What levels answer to a displacement.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Response {
    /// The force that resists.
    pub force: [f64; 2],
    /// d(force)/d(displacement): of the first by the first, of either by the other, of the second by the second.
    pub stiffness: [f64; 3],
    /// d(force)/d(load).
    pub by_load: [f64; 2],
    /// The work of slip, and the energy that went with levels.
    pub dissipated: f64,
    /// The part of the strength that slips.
    pub slipping: f64,
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
            shares: NONE,
            share_slopes: NONE,
            width: NONE,
            kept: NONE,
            followed: NONE,
            came: [NONE; 2],
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
                self.width = WIDTHS.map(|width| width * now);
            }
            if DETAILS {
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

    /// Of levels that come at the stiffness of the last step: half of the increment follows them in the mean.
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

    /// Displaces all levels; the state becomes what it is after. Without `DETAILS` only force and stiffness are told.
    #[inline(always)]
    pub fn step<V: Four, const DETAILS: bool>(
        &self,
        displacement: [f64; 2],
        cut: Cut,
        state: &mut [f64; STATE],
    ) -> Response {
        let [dx, dy] = displacement;
        // Forces over a power of two next to the strength: their squares are numbers, and nothing is rounded by it.
        let unit = power_of_two_below(self.strength.value);
        let scale = 1.0 / unit;
        let (strength, stiffness) = (self.strength.value * scale, self.stiffness.value * scale);
        let (mut nx, mut ny, mut inverse) = (NONE, NONE, NONE);
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
                let width = V::read(&WIDTHS, j) * V::splat(stiffness);
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
            // Of one that slips a force across its direction turns it.
            let turning = follows * part;
            xx = xx + turning * (one - ux * ux);
            xy = xy + turning * (ux * uy);
            yy = yy + turning * (one - uy * uy);
        }
        // Not by `map`, which is not compiled for the caller's instructions.
        let [fx, fy, xx, xy, yy] = [fx.sum(), fy.sum(), xx.sum(), xy.sum(), yy.sum()];
        let mut response = Response {
            force: [fx * unit, fy * unit],
            stiffness: [xx * unit, -xy * unit, yy * unit],
            ..Response::default()
        };
        if DETAILS {
            let strength_slope = at_most(self.strength.slope * scale, STEEPEST);
            let stiffness_slope = at_most(self.stiffness.slope * scale, STEEPEST);
            let (mut by_x, mut by_y, mut slip, mut slipping) = (NONE, NONE, NONE, NONE);
            for j in 0..LEVELS {
                let share = self.shares[j];
                let limit = share * strength;
                let [gained_x, gained_y] =
                    [0, 1].map(|axis: usize| at_most(self.came[axis][j] * stiffness_slope, STEEPEST));
                let slips = inverse[j] > 0.0;
                let limit_slope = at_most(share * strength_slope + self.share_slopes[j] * strength, STEEPEST);
                let across = (ny[j] * gained_x - nx[j] * gained_y) * limit * inverse[j];
                by_x[j] = if slips { limit_slope * nx[j] + across * ny[j] } else { gained_x };
                by_y[j] = if slips { limit_slope * ny[j] - across * nx[j] } else { gained_y };
                let width = self.width[j] * scale;
                let excess = 1.0 / if slips { inverse[j] } else { 1.0 } - limit;
                slip[j] = if slips && width > 0.0 { limit * (excess / width) } else { 0.0 };
                slipping[j] = if slips { share } else { 0.0 };
            }
            response.by_load = [&by_x, &by_y].map(|slopes| at_most(sum(slopes) * unit, f64::MAX));
            // Rounding errors of what slips by next to nothing are no work.
            response.dissipated = at_most(sum(&slip) * unit + cut.lost, f64::MAX).max(0.0);
            response.slipping = sum(&slipping).min(1.0);
        }
        response
    }

    /// The same of levels without strength or stiffness: their force is 0, and rises with load until they slip.
    #[inline(never)]
    pub fn step_of_none(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> Response {
        let [dx, dy] = within(displacement, LARGEST);
        let size = hypot(dx, dy);
        let strength = at_most(self.strength.slope, LARGEST);
        let stiffness = at_most(self.stiffness.slope, LARGEST);
        let mut rate = 0.0;
        for (width, share) in WIDTHS.iter().zip(self.shares) {
            rate += (stiffness * width * size).min(strength * share);
        }
        let along = if size > 0.0 { rate / size } else { 0.0 };
        let dissipated = energy(state);
        state.fill(0.0);
        Response { by_load: [dx * along, dy * along], dissipated, ..Response::default() }
    }
}

/// The energy that the levels hold.
pub fn energy(state: &[f64; STATE]) -> f64 {
    let (reach, last) = (state[REACH], state[LAST]);
    if last <= 0.0 {
        return 0.0;
    }
    let place = last / reach;
    let held = |j: usize| {
        let (x, y) = (at_most(state[j], LARGEST), at_most(state[LEVELS + j], LARGEST));
        within_cell(j, place) * (x * x + y * y)
    };
    at_most(0.5 * reach * sum(&std::array::from_fn(held)), f64::MAX)
}

/// Turns all displacements by the angle of a cosine and a sine, of any length but 0.
///
/// # Errors
/// [`Error::InvalidParameter`] and [`Error::InvalidEntry`] of what is not finite, or of no angle.
pub fn turn(state: &mut [f64; STATE], cosine: f64, sine: f64) -> Result<(), Error> {
    const ALLOWED: &str = "must be finite";
    for (name, value) in [("cosine", cosine), ("sine", sine)] {
        if !finite(value) {
            return Err(Error::invalid(name, value, ALLOWED));
        }
    }
    if let Some((index, value)) = state.iter().copied().enumerate().find(|(_, value)| !finite(*value)) {
        return Err(Error::InvalidEntry { name: "state", index, value, allowed: ALLOWED });
    }
    let larger = cosine.abs().max(sine.abs());
    if larger == 0.0 {
        return Err(Error::invalid("cosine", cosine, "must not be 0 where the sine is"));
    }
    let (cosine, sine) = (cosine / larger, sine / larger);
    let length = hypot(cosine, sine);
    let (cosine, sine) = (cosine / length, sine / length);
    for j in 0..LEVELS {
        let (x, y) = (state[j], state[LEVELS + j]);
        state[j] = at_most(cosine * x - sine * y, f64::MAX);
        state[LEVELS + j] = at_most(sine * x + cosine * y, f64::MAX);
    }
    Ok(())
}

/// Cells that reach up to a stiffness; the integral of the displacements over levels is as before, and the energy not more. The
/// displacements at the new edges, on their upper side but for the last.
///
/// Within a cell displacements are taken as linear if so asked, so that what is held is not smeared out when this happens in every
/// step; as far as that would add energy, as constant.
#[inline(always)]
fn lay(reach: f64, is_linear: bool, state: &mut [f64; STATE]) -> [PerEdge; 2] {
    let before = *state;
    let place = before[LAST] / before[REACH];
    let stretch = reach / before[REACH];
    let (centers, slopes) = if is_linear { slopes(&before, place) } else { (NONE, [NONE; 2]) };
    let (mut edges, mut bend) = ([NO_EDGE; 2], [NO_EDGE; 2]);
    let mut bends = [NONE; 2];
    let (mut cell, mut at) = (0, 0.0);
    // The energy of constants, that with slopes less that of constants, and that of what slopes add alone, twice over.
    let [mut constant, mut mixed, mut bent] = [0.0; 3];
    for j in 0..LEVELS {
        let (start, end) = (at, EDGES[j + 1] * stretch);
        let to = end.min(place);
        let (mut integral, mut added) = ([0.0; 2], [0.0; 2]);
        // All of the old cells that end before, and a part of the one that does not.
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
        let inverse = if width > NARROWEST { 1.0 / width } else { 0.0 };
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
    let allowed = 2.0 * energy(&before) / before[REACH];
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
    edges
}

/// Takes away what lies above a place; the displacement there.
///
/// Of the cell that is cut the lower part keeps its own mean, as far as no energy comes with it.
#[inline(always)]
fn fall([from, place]: [f64; 2], state: &mut [f64; STATE]) -> [f64; 2] {
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
    for axis in 0..2 {
        let x = &mut state[axis * LEVELS + cut];
        *x = if is_allowed { moved[axis] } else { *x };
        at_cut[axis] = if is_allowed { *x + slope[axis] * 0.5 * lower } else { *x };
        for x in &mut state[axis * LEVELS + cut + 1..(axis + 1) * LEVELS] {
            *x = 0.0;
        }
    }
    at_cut
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
fn slopes(state: &[f64; STATE], place: f64) -> (PerLevel, [PerLevel; 2]) {
    let (mut centers, mut slopes) = (NONE, [NONE; 2]);
    for j in 0..LEVELS {
        if EDGES[j] >= place {
            break;
        }
        centers[j] = center(j, place);
        let slope = slope(state, place, j);
        (slopes[0][j], slopes[1][j]) = (slope[0], slope[1]);
    }
    (centers, slopes)
}

/// The displacements on the upper sides of the edges of cells that all touch, beyond which nothing has come yet.
#[inline(always)]
fn edge_values(state: &[f64; STATE]) -> [PerEdge; 2] {
    [0, 1].map(|axis| std::array::from_fn(|j| if j < LEVELS { state[axis * LEVELS + j] } else { 0.0 }))
}

/// How much of each of four cells lies below a place, over the reach of all.
#[inline(always)]
fn within_cells<V: Four>(j: usize, place: V) -> V {
    (place - V::read(&EDGES, j)).clamp(V::splat(0.0), V::read(&WIDTHS, j))
}

/// The same of one.
#[inline(always)]
fn within_cell(j: usize, place: f64) -> f64 {
    (place - EDGES[j]).clamp(0.0, WIDTHS[j])
}

/// A displacement, in its direction no farther than this.
#[inline(always)]
pub fn within(displacement: [f64; 2], farthest: f64) -> [f64; 2] {
    let [x, y] = displacement;
    let size = x.abs().max(y.abs());
    if size <= farthest {
        return displacement;
    }
    [x / size * farthest, y / size * farthest]
}

/// The largest power of two that is not above a positive number, but not so small that its inverse is no number.
#[inline(always)]
fn power_of_two_below(x: f64) -> f64 {
    const EXPONENT: u64 = 0x7ff << 52;
    f64::from_bits((x.to_bits() & EXPONENT).max(3 << 52))
}

/// A number of the same sign that is no larger.
#[inline(always)]
fn at_most(x: f64, largest: f64) -> f64 {
    x.clamp(-largest, largest)
}

/// In an order that vectors of any width keep.
#[inline(always)]
fn sums<const N: usize>(lanes: [&PerLevel; N]) -> [f64; N] {
    let mut four = [[0.0; 4]; N];
    for n in 0..N {
        for j in 0..LEVELS / 4 {
            for i in 0..4 {
                four[n][i] += lanes[n][4 * j + i];
            }
        }
    }
    four.map(|four| (four[0] + four[2]) + (four[1] + four[3]))
}

#[inline(always)]
fn sum(lanes: &PerLevel) -> f64 {
    sums([lanes])[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::four::Portable;

    type State = [f64; STATE];

    struct Random(u64);

    impl Random {
        fn between(&mut self, from: f64, to: f64) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            from + (to - from) * ((self.0 >> 11) as f64 / (1_u64 << 53) as f64)
        }
    }

    /// Of contacts of one size, each of which slips from its rim inwards, where the cells are cut at a place.
    fn share(j: usize, place: f64) -> f64 {
        let above = |s: f64| 1.0 - s * (1.5 - 0.5 * s * s);
        above((EDGES[j] / place).min(1.0)) - above((EDGES[j + 1] / place).min(1.0))
    }

    /// A step under a strength and a stiffness.
    fn step(strength: f64, stiffness: f64, increment: [f64; 2], state: &mut State) -> Response {
        let sloped = |value: f64| Sloped { value, slope: 0.0 };
        let mut levels = Levels { strength: sloped(strength), stiffness: sloped(stiffness), ..Levels::default() };
        let cut = levels.cut::<Portable, true>(increment, state);
        levels.shares = std::array::from_fn(|j| share(j, cut.place));
        levels.step::<Portable, true>(increment, cut, state)
    }

    fn hypot([x, y]: [f64; 2]) -> f64 {
        x.hypot(y)
    }

    #[test]
    fn cells_fill_what_they_reach() {
        assert!((WIDTHS.iter().sum::<f64>() - 1.0).abs() < 1e-15 && WIDTHS.iter().all(|&width| width > 0.0));
        assert_eq!((EDGES[0], EDGES[LEVELS], LEVELS % 4), (0.0, 1.0, 0));
    }

    /// In the plane, with strength and stiffness that jump over decades: the work of the force after a step is at least what is
    /// gained and what is lost, and a state at rest under a load that changes gains nothing.
    #[test]
    fn no_step_gives_energy() {
        let mut random = Random(7);
        let mut state = [0.0; STATE];
        let (mut slipped, mut laid) = (0, 0);
        for i in 0..20_000 {
            // Now and then by little, so that cells are cut and laid anew at all places.
            let stiffness: f64 = if i % 3 == 0 || state[LAST] == 0.0 {
                10_f64.powf(random.between(-3.0, 3.0))
            } else {
                state[LAST] * random.between(0.9, 1.1)
            };
            let strength = stiffness * random.between(0.5, 1.5);
            let size = if i % 5 == 0 { 0.0 } else { 10_f64.powf(random.between(-2.0, 0.3)) };
            let increment = [0, 1].map(|_| size * random.between(-1.0, 1.0));
            let (before, reach) = (energy(&state), state[REACH]);
            let response = step(strength, stiffness, increment, &mut state);
            let work = response.force[0] * increment[0] + response.force[1] * increment[1];
            let after = energy(&state);
            let scale = before + after + response.dissipated;
            assert!(
                work >= after - before + response.dissipated - 1e-12 * scale,
                "{i}: {work}, {before} to {after}: {response:?}"
            );
            assert!(response.dissipated >= 0.0 && hypot(response.force) <= strength * (1.0 + 1e-14), "{response:?}");
            slipped += usize::from(response.slipping > 0.0);
            laid += usize::from(state[REACH] != reach);
        }
        assert!(slipped > 5000 && laid > 5000, "{slipped}, {laid}");
    }

    /// In small steps: what is put in is held or lost.
    #[test]
    fn work_is_held_or_lost() {
        let mut state = [0.0; STATE];
        let (mut work, mut lost, mut last, mut most) = (0.0, 0.0, [0.0; 2], 0.0_f64);
        const STEPS: u32 = 40_000;
        for i in 0..STEPS {
            let turn = f64::from(i) / f64::from(STEPS) * 20.0;
            let stiffness = 1.0 + 0.7 * (0.7 * turn).sin();
            let speed = [turn.cos(), (1.3 * turn).sin()].map(|x| x * 20.0 / f64::from(STEPS));
            let response = step(stiffness, stiffness, speed, &mut state);
            work += 0.5 * ((last[0] + response.force[0]) * speed[0] + (last[1] + response.force[1]) * speed[1]);
            lost += response.dissipated;
            last = response.force;
            let error = work - lost - energy(&state);
            most = most.max(error.abs() / work.max(0.1));
        }
        assert!(most < 4e-3, "{most}");
    }

    /// The cells keep the integral of displacements over levels.
    #[test]
    fn cells_that_are_laid_anew_hold_the_same_force_and_no_more_energy() {
        let mut random = Random(3);
        for i in 0..4000 {
            let mut state = [0.0; STATE];
            (state[REACH], state[LAST]) = (2.0, 2.0 * random.between(0.05, 1.0));
            let place = state[LAST] / state[REACH];
            for j in 0..LEVELS {
                if EDGES[j] < place {
                    let smooth = [(3.0 * EDGES[j]).sin(), 1.0 - EDGES[j]];
                    for axis in 0..2 {
                        state[axis * LEVELS + j] = if i % 2 == 0 { random.between(-1.0, 1.0) } else { smooth[axis] };
                    }
                }
            }
            let force = |state: &State| {
                let place = state[LAST] / state[REACH];
                [0, 1].map(|axis| {
                    (0..LEVELS).map(|j| within_cell(j, place) * state[REACH] * state[axis * LEVELS + j]).sum::<f64>()
                })
            };
            let (held, before) = (energy(&state), force(&state));
            let reach = state[LAST] * if i % 3 == 0 { 1.0 } else { random.between(1.0, 1.5) };
            lay(reach, true, &mut state);
            let after = force(&state);
            assert!(energy(&state) <= held * (1.0 + 1e-14) && state[REACH] == reach, "{i}: {held}, {}", energy(&state));
            for axis in 0..2 {
                assert!((after[axis] - before[axis]).abs() < 1e-14, "{i}: {before:?} to {after:?}");
            }
            // What is smooth is hardly smeared out.
            assert!(i % 2 == 0 || energy(&state) > 0.99 * held, "{i}: {} of {held}", energy(&state));
        }
    }

    /// Whatever the displacement and the slopes are.
    #[test]
    fn levels_without_strength_answer_with_numbers() {
        for slope in [1e-300, 1.0, 1e200, f64::INFINITY] {
            for displacement in [[1e300, -1e300], [f64::MAX, 0.0], [1e-300, 1e-300]] {
                let sloped = Sloped { value: 0.0, slope };
                let none = Levels {
                    strength: sloped,
                    stiffness: sloped,
                    shares: std::array::from_fn(|j| share(j, 1.0)),
                    ..Levels::default()
                };
                let mut state = [1e150; STATE];
                let response = none.step_of_none(displacement, &mut state);
                let numbers = [response.by_load, [response.dissipated, 0.0]].concat();
                assert!(numbers.iter().all(|x| x.is_finite()), "{slope:e}, {displacement:?}: {response:?}");
                assert_eq!((response.force, state), ([0.0; 2], [0.0; STATE]));
            }
        }
    }

    #[test]
    fn turning_takes_the_direction_alone() {
        let mut state: State = std::array::from_fn(|j| (j as f64 * 0.7).sin());
        let before = state;
        // Of any length, there and back, and over a quarter.
        turn(&mut state, 1.2e200, 0.5e200).expect("an angle");
        turn(&mut state, 12.0, -5.0).expect("an angle");
        for j in 0..STATE {
            assert!((state[j] - before[j]).abs() < 1e-15, "{j}");
        }
        turn(&mut state, 0.0, 3e-310).expect("an angle");
        for j in 0..LEVELS {
            assert!((state[j] + before[LEVELS + j]).abs() < 1e-15 && (state[LEVELS + j] - before[j]).abs() < 1e-15);
        }
        assert_eq!(state[REACH..], before[REACH..]);
        for (cosine, sine) in [(f64::NAN, 0.0), (1.0, f64::INFINITY), (0.0, -0.0)] {
            assert!(turn(&mut state.clone(), cosine, sine).is_err(), "{cosine}, {sine}");
        }
        state[LAST] = f64::NAN;
        assert!(turn(&mut state, 1.0, 0.0).is_err());
    }

    #[test]
    fn powers_of_two_are_not_above_and_their_inverses_are_numbers() {
        for x in [1.0, 1.999, 2.0, 3e-300, 5e-324, f64::MAX] {
            let unit = power_of_two_below(x);
            assert!((unit <= x || x < 1e-306) && unit * 2.0 > x && (1.0 / unit).is_finite(), "{x}: {unit}");
        }
    }
}
