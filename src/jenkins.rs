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

/// A quantity and its slope by load.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Sloped {
    pub value: f64,
    pub slope: f64,
}

/// Elements under one load.
#[derive(Debug, Clone, Copy)]
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
    /// Displaces all elements; the state, of finite numbers, becomes what it is after.
    #[inline(always)] // so that it is compiled for the instructions that its caller has
    pub fn step(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> Response {
        let (Sloped { value: strength, slope: strength_slope }, Sloped { value: stiffness, slope: stiffness_slope }) =
            (self.strength, self.stiffness);
        if strength <= 0.0 || stiffness <= 0.0 {
            return self.step_of_none(displacement, state);
        }
        let length = strength / stiffness;
        let [dx, dy] = within(displacement, FARTHEST * length);
        // Forces over a power of two next to the strength: their squares are numbers, and nothing is rounded by it.
        let unit = power_of_two_below(strength);
        let scale = 1.0 / unit;
        let (strength, strength_slope) = (strength * scale, at_most(strength_slope * scale, STEEPEST));
        let (stiffness, stiffness_slope) = (stiffness * scale, at_most(stiffness_slope * scale, STEEPEST));
        let mut lanes = [[0.0; ELEMENTS]; 9];
        let (first, second) = state.split_at_mut(ELEMENTS);
        for j in 0..ELEMENTS {
            let (share, share_slope) = (self.shares[j], self.share_slopes[j]);
            let k = share * stiffness;
            let limit = share * KNOTS[j] * strength;
            let x = at_most(first[j] * scale + k * dx, LARGEST);
            let y = at_most(second[j] * scale + k * dy, LARGEST);
            let square = x * x + y * y;
            let slips = square > limit * limit;
            let (sticks, inverse) = if slips { (0.0, 1.0 / square.sqrt()) } else { (1.0, 0.0) };
            // The direction of the force of one that slips, and what part of its force the slider leaves.
            let (nx, ny) = (x * inverse, y * inverse);
            let part = if slips { limit * inverse } else { 1.0 };
            let (fx, fy) = (x * part, y * part);
            let excess = if slips { square * inverse - limit } else { 0.0 };
            let k_slope = share_slope * stiffness + share * stiffness_slope;
            let limit_slope = KNOTS[j] * (share_slope * strength + share * strength_slope);
            // What a change of the trial force across the direction becomes.
            let across = (ny * dx - nx * dy) * part * k_slope;
            let along = if slips { [0.0; 2] } else { [k_slope * dx, k_slope * dy] };
            let turning = k * part;
            lanes[0][j] = fx;
            lanes[1][j] = fy;
            lanes[2][j] = sticks * k + turning * (ny * ny);
            lanes[3][j] = -turning * (nx * ny);
            lanes[4][j] = sticks * k + turning * (nx * nx);
            lanes[5][j] = along[0] + limit_slope * nx + across * ny;
            lanes[6][j] = along[1] + limit_slope * ny - across * nx;
            lanes[7][j] = KNOTS[j] * excess;
            lanes[8][j] = if slips { share * KNOTS[j] } else { 0.0 };
            first[j] = fx * unit;
            second[j] = fy * unit;
        }
        let [fx, fy, xx, xy, yy, by_x, by_y, excess, slipping] = lanes.map(|lane| sum(&lane));
        Response {
            force: [fx * unit, fy * unit],
            stiffness: [xx * unit, xy * unit, yy * unit],
            by_load: [by_x * unit, by_y * unit].map(|slope| at_most(slope, f64::MAX)),
            dissipated: at_most(excess * length * unit, f64::MAX),
            slipping: slipping.min(1.0),
        }
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
    let four: [f64; 4] = std::array::from_fn(|i| (lane[i] + lane[i + 8]) + (lane[i + 4] + lane[i + 12]));
    (four[0] + four[2]) + (four[1] + four[3])
}
