//! What a contact whose load changes remembers: levels of stiffness, each with an elastic displacement of its own in the plane
//! (R. D. Mindlin and H. Deresiewicz, J. Appl. Mech. 20 (1953) 327; J. Jaeger, Arch. Appl. Mech. 65 (1995) 478).
//!
//! The stiffness K of a contact grows with its load, and each level from 0 to K is what touches at the load at which the
//! stiffness is that level. Less load takes the highest levels away, with their force and energy; more load brings levels that
//! have not been displaced. A level follows the surfaces up to its limit, and slips beyond. Cells of levels share one
//! displacement, their mean; a cell that K cuts counts up to K.
//!
//! Here is the state; `levels` takes a step of it, `cells` lays it on another stiffness, `strengths` has the limits of the levels at
//! one load and `limits` blends them between loads.

mod cells;
mod levels;
mod limits;
mod strengths;

#[cfg(target_arch = "x86_64")]
pub use cells::lay;
pub use cells::Cells;
pub use levels::{stuck, Levels, Sloped, MOST_SLIP_LENGTHS};
pub use limits::{Blend, Limits};

use crate::error::Error;
use crate::numerics::elementary::hypot;
use crate::numerics::float_bits::finite;
use crate::numerics::four::{Four, Portable};

/// How many cells of levels there are.
const LEVELS: usize = 20;
/// The length of a state: the displacements of the cells along the first direction, then along the second, then the stiffness up
/// to which the cells reach, that of the last step, and the largest load.
pub const STATE: usize = 2 * LEVELS + 3;
/// Where in a state the stiffness is up to which the cells reach.
pub const REACH: usize = 2 * LEVELS;
/// Where in a state the stiffness of the last step is.
pub const LAST: usize = REACH + 1;
/// Where in a state the largest load is that the contact has borne.
pub const LARGEST: usize = LAST + 1;

/// The roots of the edges of the cells, over the stiffness up to which they reach. Narrow at the top, where levels slip first,
/// so that small cycles dissipate what they should (`tests/physics/microslip.rs`), and nowhere wider than needed to keep what is
/// held while the load comes and goes.
const ROOTS: PerEdge = [
    0.0, 0.174, 0.2946, 0.4082, 0.5189, 0.6307, 0.6712, 0.7173, 0.7644, 0.8095, 0.8593, 0.9032, 0.9347, 0.9559, 0.9709,
    0.9811, 0.9901, 0.9949, 0.9974, 0.9992, 1.0, 1.0, 1.0, 1.0,
];

/// The edges of the cells.
const EDGES: PerEdge = {
    let mut edges = ROOTS;
    let mut j = 0;
    while j < edges.len() {
        edges[j] *= ROOTS[j];
        j += 1;
    }
    edges
};

static CELL_WIDTHS: PerLevel = {
    let mut widths = NO_LEVEL;
    let mut j = 0;
    while j < LEVELS {
        widths[j] = EDGES[j + 1] - EDGES[j];
        j += 1;
    }
    widths
};

/// Larger displacements have no energy that is a number, and larger slopes of a contact without strength no sum that is one: they
/// count as this.
const LARGEST_WITH_SQUARE: f64 = 1e150;

/// A number for each cell.
pub type PerLevel = [f64; LEVELS];
/// A number for each edge of a cell, and three more: edges are read by fours.
pub type PerEdge = [f64; LEVELS + 4];
pub const NO_LEVEL: PerLevel = [0.0; LEVELS];
const NO_EDGE: PerEdge = [0.0; LEVELS + 4];

/// What resists a displacement of the surfaces along each other, in the caller's units.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct MicroslipStep {
    /// T, along both directions [force].
    pub force: [f64; 2],
    /// dT/d(increment) [force/length], row by row.
    pub stiffness: [f64; 4],
    /// dT/d(load).
    pub dforce_dload: [f64; 2],
    /// Work of slip in this step, and energy that was held by what touches no more, >= 0 [force length].
    pub dissipated: f64,
    /// Fraction of the strength that slips.
    pub slipping: f64,
}

/// The energy that the levels hold.
pub fn energy(state: &[f64; STATE]) -> f64 {
    energy_by::<Portable>(state)
}

/// The same, by the instructions of the caller.
#[inline(always)]
fn energy_by<V: Four>(state: &[f64; STATE]) -> f64 {
    let (reach, last) = (state[REACH], state[LAST]);
    if last <= 0.0 {
        return 0.0;
    }
    let (least, most) = (V::splat(-LARGEST_WITH_SQUARE), V::splat(LARGEST_WITH_SQUARE));
    let place = V::splat(last / reach);
    let mut held = V::splat(0.0);
    for j in (0..LEVELS).step_by(4) {
        let x = V::read(state, j).clamp(least, most);
        let y = V::read(state, LEVELS + j).clamp(least, most);
        held = held + within_cells(j, place) * (x * x + y * y);
    }
    at_most(0.5 * reach * held.sum(), f64::MAX)
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

/// How much of each of four cells lies below a place, over the reach of all.
#[inline(always)]
fn within_cells<V: Four>(j: usize, place: V) -> V {
    (place - V::read(&EDGES, j)).clamp(V::splat(0.0), V::read(&CELL_WIDTHS, j))
}

/// How much of a cell lies below a place, over the reach of all.
#[inline(always)]
fn within_cell(j: usize, place: f64) -> f64 {
    (place - EDGES[j]).clamp(0.0, CELL_WIDTHS[j])
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

/// A number of the same sign that is no larger.
#[inline(always)]
fn at_most(x: f64, largest: f64) -> f64 {
    x.clamp(-largest, largest)
}
