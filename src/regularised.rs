//! Friction of a sliding contact for solvers that integrate through zero slip rate: the law times a smooth sign.

use crate::elementary::tanh;

/// tanh(v/v0) and its derivative by v: a sign that is smooth on the scale v0 > 0.
///
/// At v = v0 it is 0.76, at 3 v0 0.995. Sticking becomes a creep of about v0 times tangential load over friction force.
pub fn smooth_sign(slip_rate: f64, transition_rate: f64) -> (f64, f64) {
    // Far from the transition tanh is +-1 to the last bit, and the quotient might overflow.
    if slip_rate.abs() >= 20.0 * transition_rate {
        return (1f64.copysign(slip_rate), 0.0);
    }
    let sign = tanh(slip_rate / transition_rate);
    (sign, (1.0 - sign) * (1.0 + sign) / transition_rate)
}

#[cfg(test)]
mod tests {
    use super::smooth_sign;

    #[test]
    fn the_smooth_sign_is_odd_and_its_slope_is_the_secant() {
        for transition in [1e-3, 0.5, 100.0] {
            for ratio in [-100.0, -6.0, -0.2, 0.0, 1.4, 18.0, 19.9, 20.1, 38.0, 42.0] {
                let rate = ratio * transition;
                let (sign, slope) = smooth_sign(rate, transition);
                assert_eq!(smooth_sign(-rate, transition).0, -sign);
                assert!((sign - (1.0 - 2.0 / (1.0 + (2.0 * ratio).exp()))).abs() < 1e-15, "{sign} at {ratio}");
                let step = 2e-5 * transition;
                let secant =
                    (smooth_sign(rate + step, transition).0 - smooth_sign(rate - step, transition).0) / (2.0 * step);
                let error = (slope - secant) * transition;
                assert!(error.abs() < 1e-8, "slope {slope} against {secant} at {rate}");
            }
        }
        assert_eq!(smooth_sign(-f64::MAX, 1e-60), (-1.0, 0.0));
    }

    /// The advice of `asperity_slip_force`: explicit steps of F h/m = 1 stop a mass from any rate without a change of sign where the
    /// transition rate is 1, and go on for ever where it is below 1/2.
    #[test]
    fn explicit_steps_stop_where_the_transition_rate_is_that_of_a_step() {
        let last = |transition: f64, start: f64, steps: u32| {
            (0..steps).fold(start, |rate, _| rate - smooth_sign(rate, transition).0)
        };
        for start in [0.01, 0.3, 1.0, 2.5, 40.0] {
            for steps in 1..200 {
                assert!(last(1.0, start, steps) >= 0.0, "{start} after {steps}");
            }
            assert!(last(1.0, start, 10_000) < 0.02, "{start}");
            assert!(last(0.45, start, 10_000).abs() > 0.1, "{start}");
        }
    }

    #[test]
    fn at_three_transition_rates_the_force_is_half_a_per_cent_low() {
        assert!((0.004..0.006).contains(&(1.0 - smooth_sign(3.0, 1.0).0)));
    }
}
