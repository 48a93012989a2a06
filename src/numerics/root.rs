//! A bracketed root of a function of one variable, to the last bit or two.

/// A step of Newton's method, over the length on which a function bends, after which the next would change what depends on the root
/// to first order, and derivatives of it to second.
pub const LAST_STEP: f64 = 1e-13;
/// No search takes as many steps, Newton's three to five; it bounds the time of a call.
pub const MOST_STEPS: u32 = 1000;
/// To this part of the bracket roots are found, next to 0 too.
const LAST_BITS: f64 = 1e-18;

/// The root of `f` between `lower` and `upper`, by Chandrupatla's method (Adv. Eng. Softw. 28, 1997,
/// 145-149): inverse quadratic interpolation where it is safe, bisection elsewhere.
///
/// `f` must change sign between the ends; where it does not, the end with the smaller |f| is the answer.
pub fn bracketed(mut f: impl FnMut(f64) -> f64, lower: f64, upper: f64) -> f64 {
    let (at_upper, at_lower) = (f(upper), f(lower));
    between(f, (lower, at_lower), (upper, at_upper))
}

/// The same where the values at both ends are known.
pub fn between(mut f: impl FnMut(f64) -> f64, (lower, at_lower): (f64, f64), (upper, at_upper): (f64, f64)) -> f64 {
    let (mut a, mut b) = (upper, lower);
    let (mut fa, mut fb) = (at_upper, at_lower);
    if (fa < 0.0) == (fb < 0.0) {
        return if fa.abs() < fb.abs() { a } else { b };
    }
    // A root at zero has no relative resolution.
    let resolution = LAST_BITS * (upper - lower).abs();
    let mut t = 0.5;
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
    use super::bracketed;

    /// Few where the function is smooth, hardly more than bisection elsewhere: at most a quarter more than these.
    #[test]
    fn a_root_takes_few_evaluations() {
        type Case<'a> = (&'a dyn Fn(f64) -> f64, [f64; 2], f64, u32);
        let cases: [Case; 8] = [
            (&|x| x * x * x - 2.0, [0.0, 2.0], 2f64.cbrt(), 9),
            (&|x| x.exp() - 1e100, [0.0, 700.0], 100.0 * 10f64.ln(), 18),
            (&|x| (50.0 * (x - 0.3)).tanh(), [-1.0, 1.0], 0.3, 14),
            (&|x| 1.0 / x - 3.0, [1e-6, 1e6], 1.0 / 3.0, 30),
            (&|x| (x - 0.7).powi(3), [0.0, 1.0], 0.7, 53),
            (&|x| if x < 0.123 { -1.0 } else { 1.0 }, [0.0, 1.0], 0.123, 55),
            (&|x| x.cbrt(), [-1.0, 2.0], 0.0, 61),
            // Nearer to an end than the next number.
            (&|x| (x - 1.0) - 1e-16, [1.0, 2.0], 1.0, 4),
        ];
        for (f, [lower, upper], exact, most) in cases {
            for sign in [1.0, -1.0] {
                let mut count = 0;
                let counted = |x: f64| {
                    count += 1;
                    sign * f(x)
                };
                let (from, to) = if sign > 0.0 { (lower, upper) } else { (upper, lower) };
                let root = bracketed(counted, from, to);
                // A root at zero has no relative resolution.
                let error = (root - exact).abs() / (1e-18 * (upper - lower)).max(5e-16 * exact);
                assert!(error <= 1.0, "{root}, not {exact}");
                assert!(4 * count <= 5 * most, "{count} evaluations for {exact}, not {most}");
            }
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
