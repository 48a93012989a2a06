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
            // Rounding errors of what slips by next to nothing are no work.
            response.dissipated = at_most(sum(&slip) * length * unit, f64::MAX).max(0.0);
            response.slipping = sum(&slipping).min(1.0);
        }
        response
    }

    /// The same of elements without strength: their force is 0, and rises with load until they slip.
    #[inline(never)]
    fn step_of_none(&self, displacement: [f64; 2], state: &mut [f64; STATE]) -> Response {
        let mut response = Response::default();
        let displacement = within(displacement, LARGEST);
        let (strength_slope, stiffness_slope) =
            (at_most(self.strength.slope, LARGEST), at_most(self.stiffness.slope, LARGEST));
        for j in 0..ELEMENTS {
            let rate = displacement.map(|along| self.shares[j] * stiffness_slope * along);
            let limit = self.shares[j] * KNOTS[j] * strength_slope;
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

#[cfg(test)]
mod tests {
    use super::*;

    fn elements(strength: f64, stiffness: f64) -> Elements {
        // Two shares, and two more that make good what is left of each sum.
        let mut shares = NONE;
        (shares[2], shares[9]) = (0.3, 0.25);
        let (left, strength_left) = (1.0 - 0.3 - 0.25, 1.0 - 0.3 * KNOTS[2] - 0.25 * KNOTS[9]);
        shares[15] = (strength_left - left * KNOTS[11]) / (KNOTS[15] - KNOTS[11]);
        shares[11] = left - shares[15];
        assert!(shares.iter().all(|&share| share >= 0.0));
        let sloped = |value: f64| Sloped { value, slope: 0.1 * value };
        Elements { strength: sloped(strength), stiffness: sloped(stiffness), shares, share_slopes: NONE }
    }

    /// What the springs hold at this stiffness.
    fn stored(elements: &Elements, state: &[f64; STATE]) -> f64 {
        let of = |j: usize| state[j] * state[j] + state[ELEMENTS + j] * state[ELEMENTS + j];
        let held = (0..ELEMENTS).filter(|&j| elements.shares[j] > 0.0);
        held.map(|j| of(j) / (2.0 * elements.shares[j] * elements.stiffness.value)).sum()
    }

    /// In the plane, with strength and stiffness that jump over decades: the force after a step times the displacement is what the
    /// springs gain, what slip dissipates, and the energy of the change of force, which a step counts on top.
    #[test]
    fn work_is_stored_or_dissipated() {
        let mut bits = 7_u64;
        let mut random = || {
            bits = bits.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (bits >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut state = [0.0; STATE];
        let mut slipped = 0;
        for _ in 0..3000 {
            let strength = 10_f64.powf(6.0 * random() - 3.0);
            let now = elements(strength, strength * (1.0 + random()));
            let displacement = [0, 1].map(|_| 4.0 * random() - 2.0);
            let before = state;
            let response = now.step::<true>(displacement, &mut state);
            let work = response.force[0] * displacement[0] + response.force[1] * displacement[1];
            let change: [f64; STATE] = std::array::from_fn(|j| state[j] - before[j]);
            let gained = stored(&now, &state) - stored(&now, &before) + stored(&now, &change);
            let scale = strength + stored(&now, &before) + response.dissipated;
            assert!((work - gained - response.dissipated).abs() < 1e-12 * scale, "{response:?}, {work}, {gained}");
            assert!(response.dissipated >= 0.0 && hypot(response.force) <= strength * (1.0 + 1e-14));
            slipped += usize::from(response.slipping > 0.0);
        }
        assert!(slipped > 1000, "{slipped}");
    }

    fn hypot([x, y]: [f64; 2]) -> f64 {
        x.hypot(y)
    }

    /// Each element has its own limit; nothing is lost that is held.
    #[test]
    fn an_element_sticks_up_to_its_knot() {
        let all = elements(3.0, 6.0);
        for (part, slipping) in [(0.9, 0.0), (1.1, 0.3 * KNOTS[2])] {
            let mut state = [0.0; STATE];
            let response = all.step::<true>([0.0, -0.5 * KNOTS[2] * part], &mut state);
            assert!((response.slipping - slipping).abs() < 1e-15, "{response:?}");
            assert!((response.stiffness[0] - 6.0).abs() < 1e-13 || slipping > 0.0, "{response:?}");
            let held = [0.3 * 6.0 * 0.5 * KNOTS[2] * part, 0.3 * 3.0 * KNOTS[2]];
            assert!((state[ELEMENTS + 2] + held[0].min(held[1])).abs() < 1e-15, "{}", state[ELEMENTS + 2]);
        }
    }

    /// Whatever the displacement and the slopes are.
    #[test]
    fn elements_without_strength_answer_with_numbers() {
        for slope in [1e-300, 1.0, 1e200, f64::INFINITY] {
            for displacement in [[1e300, -1e300], [f64::MAX, 0.0], [1e-300, 1e-300]] {
                let sloped = Sloped { value: 0.0, slope };
                let none = Elements { strength: sloped, stiffness: sloped, ..elements(1.0, 1.0) };
                let mut state = [0.0; STATE];
                let response = none.step::<true>(displacement, &mut state);
                assert!(response.by_load.iter().all(|slope| slope.is_finite()), "{slope:e}, {displacement:?}");
                assert_eq!((response.force, state), ([0.0; 2], [0.0; STATE]));
            }
        }
    }

    #[test]
    fn powers_of_two_are_not_above_and_their_inverses_are_numbers() {
        for x in [1.0, 1.999, 2.0, 3e-300, 5e-324, f64::MAX] {
            let unit = power_of_two_below(x);
            assert!((unit <= x || x < 1e-306) && unit * 2.0 > x && (1.0 / unit).is_finite(), "{x}: {unit}");
        }
    }
}
