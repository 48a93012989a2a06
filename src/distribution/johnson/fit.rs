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

use super::super::moments;
use crate::numerics::elementary::{cbrt, exp, expm1, log1p, pow};
use crate::numerics::root;

/// No S_B curve of the domain has a larger epsilon.
const LARGEST_EPSILON: f64 = 2.0;

/// A curve of the system before it is standardised.
#[derive(Debug, Clone, Copy)]
pub struct Fit {
    /// 1/delta.
    pub epsilon: f64,
    /// Its kind.
    pub kind: CurveKind,
    /// Mean of v.
    pub mean: f64,
    /// Standard deviation of v.
    pub deviation: f64,
}

/// S_U or S_B.
#[derive(Debug, Clone, Copy)]
pub enum CurveKind {
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
            CurveKind::Unbounded { below, above } => CurveKind::Unbounded { below: above, above: below },
            CurveKind::Bounded { share, rest } => CurveKind::Bounded { share: rest, rest: share },
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
        CurveKind::Unbounded { below: 1.0 - tau, above: 1.0 + tau }
    } else {
        CurveKind::Bounded { share: 0.0, rest: 1.0 }
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
        let residual = |log_odds: f64| CurveMoments::of(epsilon, log_odds).skew - skew;
        if skew == 0.0 {
            0.0
        } else {
            root::bracketed(residual, lowest, 0.0)
        }
    };
    let residual = |epsilon: f64| CurveMoments::of(epsilon, log_odds(epsilon)).kurtosis - kurtosis;
    let epsilon = root::bracketed(residual, smallest, LARGEST_EPSILON);
    let log_odds = log_odds(epsilon);
    let CurveMoments { mean, deviation, .. } = CurveMoments::of(epsilon, log_odds);
    let (share, rest) = shares(log_odds);
    Fit { epsilon, kind: CurveKind::Bounded { share, rest }, mean, deviation }
}

fn shares(log_odds: f64) -> (f64, f64) {
    (1.0 / (1.0 + exp(-log_odds)), 1.0 / (1.0 + exp(log_odds)))
}

/// CurveMoments of v on an S_B curve.
struct CurveMoments {
    mean: f64,
    deviation: f64,
    skew: f64,
    kurtosis: f64,
}

impl CurveMoments {
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
        let [variance, skew, kurtosis] = moments(nodes.map(|(w, v)| (w, v - mean)));
        Self { mean, deviation: variance.sqrt(), skew, kurtosis }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::near;

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

    /// Also next to the lognormal curve, from which large skews tell a share that small ones do not.
    #[test]
    fn bounded_curves_have_the_moments_they_were_made_from() {
        for (skew, part) in [(0.3, 1e-3), (0.3, 0.1), (3.0, 1e-9), (3.0, 0.1)] {
            let kurtosis = (3.0 + excess_of_lognormal(skew)) * (1.0 - part);
            let fit = fit(skew, kurtosis);
            let CurveKind::Bounded { share, rest } = fit.kind else { panic!("{fit:?}") };
            let found = CurveMoments::of(fit.epsilon, (share / rest).ln());
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
            assert!(!matches!(fit.kind, CurveKind::Unbounded { below: 0.0, .. }), "{skew}: {fit:?}");
        }
    }
}
