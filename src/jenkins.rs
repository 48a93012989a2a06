//! Jenkins elements side by side: springs, each in series with a slider, displaced together in the plane (W. D. Iwan, J. Appl.
//! Mech. 33 (1966) 893).
//!
//! An element has a share of the stiffness and of the strength of all. Its force follows its spring until it is the strength of
//! its slider, which it then has in the direction of the force. What the shares are is left to `law`.

/// How many elements there are.
pub const ELEMENTS: usize = 16;
/// The state of all elements: their forces along the first direction, then along the second.
pub const STATE: usize = 2 * ELEMENTS;

/// The displacements at which the sliders of the elements begin to slip, over the strength of all by the stiffness of all.
pub const KNOTS: [f64; ELEMENTS] =
    [0.0289, 0.0405, 0.0512, 0.0713, 0.102, 0.13, 0.18, 0.246, 0.383, 0.586, 0.808, 1.0, 1.19, 1.5, 2.25, 4.13];

/// Displacements beyond this many times strength over stiffness are taken as this: all elements then slip.
const FARTHEST: f64 = 1e140;
/// Over the strength of all, no component of a force is taken as larger: its square is a number.
const LARGEST: f64 = 1e150;
/// Over the strength of all, no slope by load is taken as larger: sums of them are numbers.
const STEEPEST: f64 = 1e290;

/// A number for each element.
pub type PerElement = [f64; ELEMENTS];
const NONE: PerElement = [0.0; ELEMENTS];

/// A quantity and its slope by load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sloped {
    pub value: f64,
    pub slope: f64,
}

/// Elements under one load.
#[derive(Debug, Clone, Copy, Default)]
pub struct Elements {
    /// The strength of all, at least 0.
    pub strength: Sloped,
    /// The stiffness of all, at least 0.
    pub stiffness: Sloped,
    /// The shares of the elements in the stiffness, at least 0, 1 together; times the knots, in the strength, 1 together.
    pub shares: PerElement,
    /// By load.
    pub share_slopes: PerElement,
}

/// What elements answer to a displacement.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Response {
    /// The force that resists.
    pub force: [f64; 2],
    /// d(force)/d(displacement): of the first by the first, of either by the other, of the second by the second.
    pub stiffness: [f64; 3],
    /// d(force)/d(load).
    pub by_load: [f64; 2],
    /// The work of the sliders.
    pub dissipated: f64,
    /// The part of the strength that slips.
    pub slipping: f64,
}

impl Elements {
    /// Displaces all elements; the state, of finite numbers, becomes what it is after. Without `DETAILS` only force and stiffness
    /// are told.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn step<const DETAILS: bool>(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> Response {
        let (strength, stiffness) = (self.strength.value, self.stiffness.value);
        if strength <= 0.0 || stiffness <= 0.0 {
            return self.step_of_none(displacement, state);
        }
        let length = strength / stiffness;
        let [dx, dy] = within(displacement, FARTHEST * length);
        // Forces over a power of two next to the strength: their squares are numbers, and nothing is rounded by it.
        let unit = power_of_two_below(strength);
        let scale = 1.0 / unit;
        let (strength, stiffness) = (strength * scale, stiffness * scale);
        let (mut fx, mut fy, mut nx, mut ny) = (NONE, NONE, NONE, NONE);
        let (mut part, mut excess) = (NONE, NONE);
        for j in 0..ELEMENTS {
            let k = self.shares[j] * stiffness;
            let limit = self.shares[j] * (KNOTS[j] * strength);
            let x = at_most(state[j] * scale + k * dx, LARGEST);
            let y = at_most(state[ELEMENTS + j] * scale + k * dy, LARGEST);
            let square = x * x + y * y;
            let slips = square > limit * limit;
            // The direction of the force of one that slips, and what part of its force the slider leaves.
            let inverse = 1.0 / if slips { square } else { 1.0 }.sqrt();
            part[j] = if slips { limit * inverse } else { 1.0 };
            nx[j] = if slips { x * inverse } else { 0.0 };
            ny[j] = if slips { y * inverse } else { 0.0 };
            excess[j] = if slips { square * inverse - limit } else { 0.0 };
            fx[j] = x * part[j];
            fy[j] = y * part[j];
            state[j] = fx[j] * unit;
            state[ELEMENTS + j] = fy[j] * unit;
        }
        let (mut xx, mut xy, mut yy) = (NONE, NONE, NONE);
        for j in 0..ELEMENTS {
            // Of one that slips a force across its direction turns it; of one that sticks there is no direction.
            let turning = self.shares[j] * stiffness * part[j];
            let along = nx[j] * nx[j] + ny[j] * ny[j];
            let sticks = if along > 0.5 { 0.0 } else { 1.0 };
            xx[j] = turning * (sticks + ny[j] * ny[j]);
            xy[j] = turning * (nx[j] * ny[j]);
            yy[j] = turning * (sticks + nx[j] * nx[j]);
        }
        let mut response = Response {
            force: [sum(&fx) * unit, sum(&fy) * unit],
            stiffness: [sum(&xx) * unit, -sum(&xy) * unit, sum(&yy) * unit],
            ..Response::default()
        };
        if DETAILS {
            let strength_slope = at_most(self.strength.slope * scale, STEEPEST);
            let stiffness_slope = at_most(self.stiffness.slope * scale, STEEPEST);
            let (mut by_x, mut by_y, mut slip, mut slipping) = (NONE, NONE, NONE, NONE);
            for j in 0..ELEMENTS {
                let (share, share_slope) = (self.shares[j], self.share_slopes[j]);
                let k_slope = share_slope * stiffness + share * stiffness_slope;
                let limit_slope = KNOTS[j] * (share_slope * strength + share * strength_slope);
                let slips = nx[j] != 0.0 || ny[j] != 0.0;
                let across = (ny[j] * dx - nx[j] * dy) * part[j] * k_slope;
                by_x[j] = if slips { limit_slope * nx[j] + across * ny[j] } else { k_slope * dx };
                by_y[j] = if slips { limit_slope * ny[j] - across * nx[j] } else { k_slope * dy };
                slip[j] = KNOTS[j] * excess[j];
                slipping[j] = if slips { share * KNOTS[j] } else { 0.0 };
            }
            response.by_load = [&by_x, &by_y].map(|slopes| at_most(sum(slopes) * unit, f64::MAX));
            response.dissipated = at_most(sum(&slip) * length * unit, f64::MAX);
            response.slipping = sum(&slipping).min(1.0);
        }
        response
    }

    /// The same of elements without strength: their force is 0, and rises with load until they slip.
    #[inline(never)]
    fn step_of_none(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> Response {
        let mut response = Response::default();
        for j in 0..ELEMENTS {
            let rate = displacement.map(|along| self.shares[j] * self.stiffness.slope * along);
            let limit = self.shares[j] * KNOTS[j] * self.strength.slope;
            let (x, y) = (state[j], state[ELEMENTS + j]);
            // A state that is not 0 says which way the slider slips.
            let [x, y] = within(if x == 0.0 && y == 0.0 { rate } else { [x, y] }, LARGEST);
            let size = (x * x + y * y).sqrt();
            let is_less = state[j] == 0.0 && state[ELEMENTS + j] == 0.0 && size <= limit;
            let part = if is_less || size == 0.0 { 1.0 } else { limit / size };
            response.by_load[0] += x * part;
            response.by_load[1] += y * part;
        }
        response.by_load = response.by_load.map(|slope| at_most(slope, f64::MAX));
        state.fill(0.0);
        response
    }
}

/// A displacement, in its direction no farther than this.
#[inline(always)]
fn within(displacement: [f64; 2], farthest: f64) -> [f64; 2] {
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
fn sum(lane: &PerElement) -> f64 {
    let mut four = [lane[0], lane[1], lane[2], lane[3]];
    for more in lane[4..].chunks_exact(4) {
        for i in 0..4 {
            four[i] += more[i];
        }
    }
    (four[0] + four[2]) + (four[1] + four[3])
}
