//! Which curve of Johnson's system has a given skew and kurtosis.
//!
//! With u normal and t = epsilon u, epsilon = 1/delta, both kinds are written about their median with slope 1 there:
//!
//! ```text
//! S_U:  epsilon v = sinh t + tau (cosh t - 1)             -1 < tau < 1
//! S_B:  epsilon v = (e^t - 1)/(1 + share (e^t - 1))        0 <= share <= 1
//! ```
//!
//! tau = +-1, share = 0 or 1 are lognormal and epsilon = 0 is Gaussian, so that nothing is singular there.

use crate::elementary::{cbrt, exp, expm1, log1p, pow};
use crate::numerics::root;

/// No S_B curve of the domain has a larger epsilon.
const LARGEST_EPSILON: f64 = 2.0;

/// A curve of the system before it is standardised.
#[derive(Debug, Clone, Copy)]
pub struct Fit {
    /// 1/delta.
    pub epsilon: f64,
    /// Its kind.
    pub kind: Kind,
    /// Mean of v.
    pub mean: f64,
    /// Standard deviation of v.
    pub deviation: f64,
}

/// S_U or S_B.
#[derive(Debug, Clone, Copy)]
pub enum Kind {
    /// S_U.
    Unbounded {
        /// 1 - tau > 0.
        below: f64,
        /// 1 + tau > 0.
        above: f64,
    },
    /// S_B, and lognormal curves at its limit.
    Bounded {
        /// The share of the support that lies below the median, of which 0 and 1 are lognormal.
        share: f64,
        /// The share above: 1 - share.
        rest: f64,
    },
}

/// The curve of a skew and a kurtosis.
pub fn fit(skew: f64, kurtosis: f64) -> Fit {
    let fit = if kurtosis - 3.0 > excess_of_lognormal(skew.abs()) {
        unbounded(skew.abs(), kurtosis - 3.0)
    } else {
        bounded(skew.abs(), kurtosis)
    };
    if skew < 0.0 {
        fit.reflected()
    } else {
        fit
    }
}

impl Fit {
    fn reflected(self) -> Self {
        let kind = match self.kind {
            Kind::Unbounded { below, above } => Kind::Unbounded { below: above, above: below },
            Kind::Bounded { share, rest } => Kind::Bounded { share: rest, rest: share },
        };
        Self { kind, mean: -self.mean, ..self }
    }
}

/// The kurtosis - 3 of the lognormal curve of a skew: more is S_U, less S_B.
pub fn excess_of_lognormal(skew: f64) -> f64 {
    let p = lognormal_growth(skew);
    p * (16.0 + p * (15.0 + p * (6.0 + p)))
}

/// exp(epsilon^2) - 1 of the lognormal curve of a skew: p (p + 3)^2 = skew^2.
fn lognormal_growth(skew: f64) -> f64 {
    let squared = skew * skew;
    // p (p + 3)^2 lies above both 9 p and p^3.
    let upper = (squared / 9.0).min(cbrt(squared));
    root::bracketed(|p| p * (p + 3.0) * (p + 3.0) - squared, 0.0, upper)
}

/// S_U from its moments (Johnson 1949) in p = exp(epsilon^2) - 1 and q = tau^2, in which every term is positive.
fn unbounded(skew: f64, excess: f64) -> Fit {
    // Kurtosis grows with q, and with p at no less than 4 as where both are 0.
    let largest = 0.25 * excess;
    let growth = |q: f64| root::bracketed(|p| unbounded_excess(p, q) - excess, 0.0, largest);
    let tau = root::bracketed(|tau| unbounded_skew(growth(tau * tau), tau) - skew, 0.0, 1.0);
    let q = tau * tau;
    let p = growth(q);
    let epsilon = log1p(p).sqrt();
    let kind = if tau < 1.0 {
        Kind::Unbounded { below: 1.0 - tau, above: 1.0 + tau }
    } else {
        Kind::Bounded { share: 0.0, rest: 1.0 }
    };
    if epsilon == 0.0 {
        return Fit { epsilon, kind, mean: 0.0, deviation: 1.0 };
    }
    let mean = tau * expm1(0.5 * epsilon * epsilon) / epsilon;
    Fit { epsilon, kind, mean, deviation: (p * unbounded_variance(p, q)).sqrt() / epsilon }
}

/// The variance of epsilon v over p.
fn unbounded_variance(p: f64, q: f64) -> f64 {
    1.0 + 0.5 * p * (1.0 + q)
}

fn unbounded_skew(p: f64, tau: f64) -> f64 {
    let q = tau * tau;
    let third = 3.0 + 0.25 * p * (p + 4.0) * (3.0 + q);
    ((1.0 + p) * p).sqrt() * tau * third / pow(unbounded_variance(p, q), 1.5)
}

fn unbounded_excess(p: f64, q: f64) -> f64 {
    let common = 1.0 + q * (6.0 + q);
    let terms = [
        32.0 + 96.0 * q,
        64.0 + q * (288.0 + 24.0 * q),
        56.0 + q * (312.0 + 48.0 * q),
        28.0 * common,
        8.0 * common,
        common,
    ];
    let sum = terms.iter().rev().fold(0.0, |sum, term| sum * p + term);
    let variance = unbounded_variance(p, q);
    0.125 * p * sum / (variance * variance)
}

/// S_B: epsilon from the kurtosis, and for each epsilon the share from the skew.
fn bounded(skew: f64, kurtosis: f64) -> Fit {
    let smallest = log1p(lognormal_growth(skew)).sqrt();
    // ln(share/rest), from where it cannot be told from lognormal to where there is no skew.
    let log_odds = |epsilon: f64| {
        let lowest = -40.0 - epsilon * (11.0 + 4.0 * epsilon);
        let residual = |log_odds: f64| Moments::of(epsilon, log_odds).skew - skew;
        if skew == 0.0 {
            0.0
        } else {
            root::bracketed(residual, lowest, 0.0)
        }
    };
    let residual = |epsilon: f64| Moments::of(epsilon, log_odds(epsilon)).kurtosis - kurtosis;
    let epsilon = root::bracketed(residual, smallest, LARGEST_EPSILON);
    let log_odds = log_odds(epsilon);
    let Moments { mean, deviation, .. } = Moments::of(epsilon, log_odds);
    let (share, rest) = shares(log_odds);
    Fit { epsilon, kind: Kind::Bounded { share, rest }, mean, deviation }
}

fn shares(log_odds: f64) -> (f64, f64) {
    (1.0 / (1.0 + exp(-log_odds)), 1.0 / (1.0 + exp(log_odds)))
}

/// Moments of v on an S_B curve.
struct Moments {
    mean: f64,
    deviation: f64,
    skew: f64,
    kurtosis: f64,
}

impl Moments {
    /// By the trapezoidal rule in u, whose error falls exponentially with 1/step: v has its poles at Im u = pi/epsilon.
    fn of(epsilon: f64, log_odds: f64) -> Self {
        if epsilon == 0.0 {
            return Self { mean: 0.0, deviation: 1.0, skew: 0.0, kurtosis: 3.0 };
        }
        let step = (0.35 / epsilon).min(0.4);
        let (share, _) = shares(log_odds);
        // The fourth power grows as exp(4 epsilon u) as long as the share is small.
        let (lowest, highest) = (-10.0, 10.0 + (4.0 * epsilon).min(6.0));
        let nodes = ((lowest / step) as i32..=(highest / step) as i32).map(|j| {
            let u = step * f64::from(j);
            let rise = expm1(epsilon * u);
            (exp(-0.5 * u * u), rise / (epsilon * (1.0 + share * rise)))
        });
        let (weight, sum) = nodes.clone().fold((0.0, 0.0), |(weight, sum), (w, v)| (weight + w, sum + w * v));
        let mean = sum / weight;
        let mut central = [0.0; 3];
        for (w, v) in nodes {
            let distance = v - mean;
            let mut term = w * distance;
            for moment in &mut central {
                term *= distance;
                *moment += term;
            }
        }
        let [second, third, fourth] = central.map(|moment| moment / weight);
        let deviation = second.sqrt();
        Self { mean, deviation, skew: third / (second * deviation), kurtosis: fourth / (second * second) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;
    use std::f64::consts::PI;

    #[test]
    fn lognormal_curves_have_the_moments_of_the_closed_form() {
        for growth in [1e-6_f64, 0.01, 0.5, 3.0, 40.0] {
            // w = exp(epsilon^2): skew (w + 2) (w - 1)^(1/2), kurtosis w^4 + 2 w^3 + 3 w^2 - 3.
            let skew = (growth + 3.0) * growth.sqrt();
            let (p, excess) = (lognormal_growth(skew), excess_of_lognormal(skew));
            assert!(near(p, growth, 1e-13), "{p}, not {growth}");
            let w = 1.0 + growth;
            let expected = w.powi(4) + 2.0 * w.powi(3) + 3.0 * w * w - 6.0;
            assert!((excess - expected).abs() < 1e-12 * (1.0 + expected), "{excess}, not {expected}");
        }
        assert_eq!(lognormal_growth(0.0), 0.0);
    }

    /// Johnson (1949), of sinh(epsilon u + shift): epsilon v of this file is that times (1 - tau^2)^(1/2), less tau, with
    /// tau = tanh(shift).
    #[test]
    fn moments_of_unbounded_curves_are_johnsons() {
        for p in [0.05_f64, 0.4, 2.0] {
            for tau in [0.0_f64, 0.2, 0.9] {
                let (w, shift) = (1.0 + p, tau.atanh());
                let variance = 0.5 * p * (w * (2.0 * shift).cosh() + 1.0);
                let third = 0.25 * w.sqrt() * p * p * (w * (w + 2.0) * (3.0 * shift).sinh() + 3.0 * shift.sinh());
                let fourth = 0.125
                    * p
                    * p
                    * (w * w * (w.powi(4) + 2.0 * w.powi(3) + 3.0 * w * w - 3.0) * (4.0 * shift).cosh()
                        + 4.0 * w * w * (w + 2.0) * (2.0 * shift).cosh()
                        + 3.0 * (2.0 * w + 1.0));
                let q = tau * tau;
                assert!(near(p * unbounded_variance(p, q), (1.0 - q) * variance, 1e-13), "{p} {tau}");
                assert!(near(unbounded_skew(p, tau), third / variance.powf(1.5), 1e-12), "{p} {tau}");
                let excess = fourth / (variance * variance) - 3.0;
                assert!(near(unbounded_excess(p, q), excess, 1e-12 / p), "{p} {tau}: {excess}");
                // The curve is found by its moments.
                let fit = unbounded(unbounded_skew(p, tau), excess);
                assert!(near(fit.epsilon, p.ln_1p().sqrt(), 1e-10), "{p} {tau}: {fit:?}");
                assert!(near(fit.deviation * fit.epsilon, ((1.0 - q) * variance).sqrt(), 1e-10), "{p} {tau}: {fit:?}");
                assert!((fit.mean * fit.epsilon - tau * (w.sqrt() - 1.0)).abs() < 1e-9, "{p} {tau}: {fit:?}");
                let Kind::Unbounded { below, above } = fit.kind else { panic!("{fit:?}") };
                assert!((below - (1.0 - tau)).abs() < 1e-9 && (above - (1.0 + tau)).abs() < 1e-9, "{p} {tau}: {fit:?}");
            }
        }
        let gaussian = unbounded(0.0, 0.0);
        assert!(gaussian.epsilon == 0.0 && gaussian.mean == 0.0 && gaussian.deviation == 1.0);
    }

    /// Raw moments by a plain sum over u.
    #[test]
    fn moments_of_bounded_curves_are_those_of_a_sum() {
        for epsilon in [0.05, 0.7, 2.5] {
            for log_odds in [-9.0, -1.5, 0.0] {
                let (share, rest) = shares(log_odds);
                assert!(near(share / rest, f64::exp(log_odds), 1e-14) && near(share + rest, 1.0, 1e-15));
                let mut raw = [0.0; 5];
                for i in -3000..=4000 {
                    let u = 0.005 * f64::from(i);
                    let rise = (epsilon * u).exp_m1();
                    let v = rise / (1.0 + share * rise) / epsilon;
                    let mut term = 0.005 * (-0.5 * u * u).exp() / (2.0 * PI).sqrt();
                    for moment in &mut raw {
                        *moment += term;
                        term *= v;
                    }
                }
                let [_, mean, square, cube, quartic] = raw;
                let variance = square - mean * mean;
                let third = cube - 3.0 * mean * square + 2.0 * mean.powi(3);
                let fourth = quartic - 4.0 * mean * cube + 6.0 * mean * mean * square - 3.0 * mean.powi(4);
                let found = Moments::of(epsilon, log_odds);
                let scale = 1.0 + mean * mean / variance;
                assert!((found.mean - mean).abs() < 1e-12 * (1.0 + mean.abs()), "{epsilon} {log_odds}: {}", found.mean);
                assert!(near(found.deviation, variance.sqrt(), 1e-11 * scale), "{epsilon} {log_odds}");
                let skew = third / variance.powf(1.5);
                assert!((found.skew - skew).abs() < 1e-10 * (1.0 + skew.abs()), "{epsilon} {log_odds}: {}", found.skew);
                assert!(near(found.kurtosis, fourth / (variance * variance), 1e-9), "{epsilon} {log_odds}");
            }
        }
        // Lognormal but for a share that is nothing, of which the last moment lies far out.
        for epsilon in [0.3_f64, 1.0, 2.2] {
            let growth = (epsilon * epsilon).exp_m1();
            let found = Moments::of(epsilon, -90.0);
            assert!(near(found.skew, (growth + 3.0) * growth.sqrt(), 1e-12), "{epsilon}: {}", found.skew);
            let excess = growth * (16.0 + growth * (15.0 + growth * (6.0 + growth)));
            assert!(near(found.kurtosis, 3.0 + excess, 1e-12), "{epsilon}: {}", found.kurtosis);
        }
        let gaussian = Moments::of(0.0, -3.0);
        let moments = [gaussian.mean, gaussian.deviation, gaussian.skew, gaussian.kurtosis];
        assert_eq!(moments, [0.0, 1.0, 0.0, 3.0]);
    }

    /// Also next to the lognormal curve, from which large skews tell a share that small ones do not.
    #[test]
    fn bounded_curves_have_the_moments_they_were_made_from() {
        for (skew, part) in [(0.3, 1e-3), (0.3, 0.1), (3.0, 1e-9), (3.0, 0.1)] {
            let kurtosis = (3.0 + excess_of_lognormal(skew)) * (1.0 - part);
            let fit = fit(skew, kurtosis);
            let Kind::Bounded { share, rest } = fit.kind else { panic!("{fit:?}") };
            let found = Moments::of(fit.epsilon, (share / rest).ln());
            assert!(near(found.skew, skew, 1e-13), "{skew}, {part:e}: {}", found.skew);
            assert!(near(found.kurtosis, kurtosis, 1e-11), "{skew}, {part:e}: {}", found.kurtosis / kurtosis - 1.0);
        }
    }

    /// Where 1 - tau rounds to 0.
    #[test]
    fn unbounded_curves_end_at_the_lognormal_curve() {
        for i in 1..40 {
            let skew = 0.01 * f64::from(i);
            let fit = unbounded(skew, excess_of_lognormal(skew));
            assert!(!matches!(fit.kind, Kind::Unbounded { below: 0.0, .. }), "{skew}: {fit:?}");
        }
    }

    #[test]
    fn curves_of_opposite_skew_are_reflected() {
        let (fit, other) = (fit(0.8, 6.0), super::fit(-0.8, 6.0));
        let (Kind::Unbounded { below, above }, Kind::Unbounded { below: lower, above: upper }) = (fit.kind, other.kind)
        else {
            panic!("{fit:?}, {other:?}")
        };
        assert_eq!((fit.epsilon, fit.mean, fit.deviation), (other.epsilon, -other.mean, other.deviation));
        assert_eq!((below, above), (upper, lower));
    }
}
