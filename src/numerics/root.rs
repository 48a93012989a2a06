//! A bracketed root of a function of one variable, to the last bit or two.

/// A step of Newton's method, over the length on which a function bends, after which the next would change what depends on the root
/// to first order, and derivatives of it to second.
pub const LAST_STEP: f64 = 1e-13;
/// No search takes as many steps, Newton's three to five; it bounds the time of a call.
pub const MOST_STEPS: u32 = 1000;
/// Roots are found to this part of the bracket, next to 0 too.
const LAST_BITS: f64 = 1e-18;

/// The root of `f` between `lower` and `upper`, by Chandrupatla's method (Adv. Eng. Softw. 28, 1997,
/// 145-149): inverse quadratic interpolation where it is safe, bisection elsewhere.
///
/// `f` must change sign between the ends; where it does not, the end with the smaller |f| is the answer.
pub fn bracketed(mut f: impl FnMut(f64) -> f64, lower: f64, upper: f64) -> f64 {
    let (at_upper, at_lower) = (f(upper), f(lower));
    from_part(&mut f, (lower, at_lower), (upper, at_upper), 0.5)
}

/// The same where the values at both ends are known, of a function that is nearly straight.
pub fn between(mut f: impl FnMut(f64) -> f64, lower: (f64, f64), upper: (f64, f64)) -> f64 {
    let straight = (upper.1 / (upper.1 - lower.1)).clamp(0.01, 0.99);
    from_part(&mut f, lower, upper, if straight.is_nan() { 0.5 } else { straight })
}

/// The root on one side of `from`, in a bracket whose steps double, and no farther than a limit; without a change of sign the one
/// of both with the smaller |f|.
pub fn beyond(mut f: impl FnMut(f64) -> f64, from: f64, first_step: f64, limit: f64) -> f64 {
    let start = (from, f(from));
    let (mut inner, mut step) = (start, first_step);
    loop {
        let is_last = (from + step - limit) * step >= 0.0;
        let x = if is_last { limit } else { from + step };
        let outer = (x, f(x));
        let is_passed = (outer.1 < 0.0) != (inner.1 < 0.0);
        if is_last || is_passed {
            return from_part(&mut f, if is_passed { inner } else { start }, outer, 0.5);
        }
        (inner, step) = (outer, 2.0 * step);
    }
}

/// The same from a part of the bracket, from its upper end; compiled once for all functions, of which there are some thirty.
fn from_part(
    f: &mut dyn FnMut(f64) -> f64,
    (lower, at_lower): (f64, f64),
    (upper, at_upper): (f64, f64),
    first: f64,
) -> f64 {
    let (mut a, mut b) = (upper, lower);
    let (mut fa, mut fb) = (at_upper, at_lower);
    if (fa < 0.0) == (fb < 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    // A root at zero has no relative resolution.
    let resolution = LAST_BITS * (upper - lower).abs();
    let mut t = first;
    for _ in 0..MOST_STEPS {
        let x = a + t * (b - a);
        let fx = f(x);
        // Keep the root between a and b, with a the newest point and c the one before.
        let (c, fc);
        if (fx < 0.0) == (fa < 0.0) {
            (c, fc) = (a, fa);
        } else {
            (c, fc) = (b, fb);
            (b, fb) = (a, fa);
        }
        (a, fa) = (x, fx);
        let best = if fa.abs() < fb.abs() { a } else { b };
        let smallest = (2.0 * f64::EPSILON * best.abs() + resolution) / (b - a).abs().max(resolution);
        if fa == 0.0 || smallest >= 0.5 {
            return best;
        }
        let xi = (a - b) / (c - b);
        let phi = (fa - fb) / (fc - fb);
        t = if phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi {
            fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        } else {
            0.5
        };
        t = t.clamp(smallest, 1.0 - smallest);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::{beyond, bracketed};

    #[test]
    fn a_root_is_found_on_either_side_and_no_farther_than_the_limit() {
        for (step, root) in [(1.0, 1000.0_f64.sqrt()), (-1.0, -1000.0_f64.sqrt()), (0.01, 1000.0_f64.sqrt())] {
            for limit in [40.0, f64::INFINITY].map(|limit| limit.copysign(step)) {
                let found = beyond(|x| x * x - 1000.0, 0.5, step, limit);
                assert!((found / root - 1.0).abs() < 1e-15, "{found}, not {root}");
            }
            let limit = 7.0_f64.copysign(step);
            assert_eq!(beyond(|x| x * x - 1000.0, 0.5, step, limit), limit);
            // A root where it begins, rounding apart.
            assert_eq!(beyond(|x| step * x + 1e-17, 0.0, step, limit), 0.0);
        }
    }

    #[test]
    fn without_a_change_of_sign_the_end_nearer_to_a_root_is_the_answer() {
        for sign in [1.0, -1.0] {
            assert_eq!(bracketed(|x| sign * (x * x + 1.0), -1.0, 2.0), -1.0);
            assert_eq!(bracketed(|x| sign * (x * x + 1.0), -2.0, 1.0), 1.0);
        }
        // A root at an end is found there.
        assert_eq!(bracketed(|x| x - 1.0, 0.0, 1.0), 1.0);
        assert_eq!(bracketed(|x| x - 1.0, 1.0, 2.0), 1.0);
    }
}
