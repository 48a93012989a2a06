//! A bracketed root of a function of one variable, to the last bit or two.

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
    let resolution = 1e-18 * (upper - lower).abs();
    let mut t = 0.5;
    for _ in 0..200 {
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

    #[test]
    fn a_root_is_found_to_the_last_bits() {
        let root = bracketed(|x| x * x * x - 2.0, 0.0, 2.0);
        assert!((root - 2f64.cbrt()).abs() < 1e-15);
        let steep = bracketed(|x: f64| x.exp() - 1e100, 0.0, 700.0);
        assert!((steep / (100.0 * 10f64.ln()) - 1.0).abs() < 1e-15);
    }
}
