//! What measured points tell of a strength and of a pressure coefficient.
//!
//! Friction is F = c F0 + kappa H, F0 with the slip stresses as they are, H the load of Hertz' contacts. ln c is normal before the
//! measurement, or quite unknown; kappa >= 0 is fixed, or half-normal where the points tell it better than that. The errors of the
//! points are those of ln F.

use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::nan;
use crate::params::LARGEST_PRESSURE_COEFFICIENT;

/// A friction force measured at a load.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeasuredPoint {
    /// [force]
    pub load: f64,
    /// [force]
    pub force: f64,
    /// Relative standard error.
    pub error: f64,
}

/// A point, with the two parts of the model's force there.
#[derive(Debug, Clone, Copy)]
pub struct Seen {
    /// F0 of these surfaces.
    pub force: f64,
    /// H.
    pub pressed: f64,
    /// ln F as it was measured.
    pub measured: f64,
    /// The standard deviation of its error.
    pub error: f64,
}

/// ln c before the points: its mean, and the inverse of its variance, 0 if nothing is known.
#[derive(Debug, Clone, Copy)]
pub struct Prior {
    pub mean: f64,
    pub precision: f64,
}

impl Prior {
    pub const UNKNOWN: Self = Self { mean: 0.0, precision: 0.0 };
}

/// What is left open of the strength at one pressure coefficient: ln c is normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slice {
    pub kappa: f64,
    pub mean: f64,
    pub variance: f64,
    /// Logarithm of the probability, but for a constant.
    pub log_weight: f64,
}

/// Standard deviation of a pressure coefficient (>= 0) that is not known: those of the table of interfaces are 0.001 to 0.14.
const PRESSURE_DEVIATION: f64 = 0.1;
/// Precision of ln c where nothing is known of it but the points: a factor of 10 either way about that of the points without a pressure
/// coefficient.
const SOME_PRECISION: f64 = 0.724_5;
/// Nodes of a pressure coefficient.
const PRESSURE_NODES: u32 = 17;
/// Slices of less than this part of the largest weight are left out.
const LEAST_LOG_WEIGHT: f64 = 10.0;
/// Narrowings of the range of nodes, each to an eighth at most.
const ROUNDS: usize = 6;

/// ln(c F0 + kappa H), and d/d(ln c) of it.
fn model(seen: &Seen, log_c: f64, kappa: f64) -> (f64, f64) {
    let part = exp(log_c) * seen.force;
    let force = part + kappa * seen.pressed;
    (log(force), part / force)
}

/// Minus the logarithm of the probability, but for constants.
fn cost(seen: &[Seen], prior: Prior, log_c: f64, kappa: f64) -> f64 {
    let off = |one: &Seen| (model(one, log_c, kappa).0 - one.measured) / one.error;
    let of_points: f64 = seen.iter().map(|one| off(one) * off(one)).sum();
    let (off, pressure) = (log_c - prior.mean, kappa / PRESSURE_DEVIATION);
    0.5 * (of_points + prior.precision * (off * off) + pressure * pressure)
}

/// The most probable ln c at a pressure coefficient, by Newton's method after Gauss.
pub fn slice(seen: &[Seen], prior: Prior, kappa: f64) -> Slice {
    let start = |one: &Seen| one.measured - log(one.force);
    let mut log_c = if seen.is_empty() { prior.mean } else { seen.iter().map(start).sum::<f64>() / seen.len() as f64 };
    let mut precision = prior.precision;
    for _ in 0..100 {
        let mut slope = prior.precision * (log_c - prior.mean);
        precision = prior.precision;
        for one in seen {
            let (value, by_log_c) = model(one, log_c, kappa);
            let weight = 1.0 / (one.error * one.error);
            slope += weight * by_log_c * (value - one.measured);
            precision += weight * by_log_c * by_log_c;
        }
        let step = slope / precision;
        if nan(step) || step.abs() <= 1e-14 {
            break;
        }
        log_c -= step.clamp(-1.0, 1.0);
        log_c = log_c.clamp(-600.0, 600.0);
    }
    let variance = 1.0 / precision;
    let log_weight = 0.5 * log(variance) - cost(seen, prior, log_c, kappa);
    Slice { kappa, mean: log_c, variance, log_weight }
}

/// Whether the points tell the pressure coefficient better than it is known without: as they do where they reach over loads.
pub fn tell_pressure(seen: &[Seen]) -> bool {
    let log_c = slice(seen, Prior::UNKNOWN, 0.0).mean;
    let by_kappa = |one: &Seen| one.pressed / (exp(log_c) * one.force);
    let weight = |one: &Seen| 1.0 / (one.error * one.error);
    let total: f64 = seen.iter().map(weight).sum();
    let mean = seen.iter().map(|one| weight(one) * by_kappa(one)).sum::<f64>() / total;
    let precision: f64 = seen.iter().map(|one| weight(one) * (by_kappa(one) - mean) * (by_kappa(one) - mean)).sum();
    precision * PRESSURE_DEVIATION * PRESSURE_DEVIATION > 1.0
}

/// The largest pressure coefficient worth a look: that which alone gives some measured force, so many of its errors off.
fn most(seen: &[Seen], errors: f64) -> f64 {
    let of = |one: &Seen| exp(one.measured - log(one.pressed) + errors * one.error);
    seen.iter().map(of).fold(LARGEST_PRESSURE_COEFFICIENT, f64::min)
}

/// Slices at pressure coefficients that are evenly apart, where they have weight.
pub fn slices(seen: &[Seen], prior: Prior) -> Vec<Slice> {
    let [mut low, mut high] = [0.0, most(seen, 4.0)];
    let mut found = Vec::new();
    for _ in 0..ROUNDS {
        let at = |i: u32| low + (high - low) * f64::from(i) / f64::from(PRESSURE_NODES);
        found = (0..=PRESSURE_NODES).map(|i| slice(seen, prior, at(i))).collect();
        let best = found.iter().map(|slice| slice.log_weight).fold(f64::NEG_INFINITY, f64::max);
        let has_weight = |slice: &Slice| slice.log_weight > best - LEAST_LOG_WEIGHT;
        let first = found.iter().position(has_weight).unwrap_or(0);
        let last = found.iter().rposition(has_weight).unwrap_or(0);
        if last - first > PRESSURE_NODES as usize / 2 {
            break;
        }
        [low, high] = [found[first.saturating_sub(1)].kappa, found[(last + 1).min(PRESSURE_NODES as usize)].kappa];
    }
    let last = found.len() - 1;
    for end in [0, last] {
        found[end].log_weight -= log(2.0);
    }
    found
}

/// ln c and kappa of the curve nearest to the points, nothing being known of the strength. A kappa that the points tell is the mean
/// of what they leave open.
pub fn nearest(seen: &[Seen], kappa: Option<f64>) -> (f64, f64) {
    let log_c = |kappa: f64| slice(seen, Prior::UNKNOWN, kappa).mean;
    let kappa = kappa.unwrap_or_else(|| {
        let all = slices(seen, Prior { mean: log_c(0.0), precision: SOME_PRECISION });
        let best = all.iter().map(|slice| slice.log_weight).fold(f64::NEG_INFINITY, f64::max);
        let weight = |slice: &Slice| exp(slice.log_weight - best);
        let mean =
            all.iter().map(|slice| weight(slice) * slice.kappa).sum::<f64>() / all.iter().map(weight).sum::<f64>();
        // Some strength is left.
        mean.min(0.99 * most(seen, 0.0))
    });
    (log_c(kappa), kappa)
}

/// By how much the points are off the curve, root mean square in their errors, for each that the curve was not led through; 0
/// where none is left.
pub fn misfit(seen: &[Seen], log_c: f64, kappa: f64, told_pressure: bool) -> f64 {
    let led = 1 + usize::from(told_pressure && kappa > 0.0);
    let Some(left) = seen.len().checked_sub(led).filter(|&left| left > 0) else { return 0.0 };
    let off = |one: &Seen| (model(one, log_c, kappa).0 - one.measured) / one.error;
    (seen.iter().map(|one| off(one) * off(one)).sum::<f64>() / left as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn seen(force: f64, pressed: f64, measured: f64, error: f64) -> Seen {
        Seen { force, pressed, measured: log(measured), error }
    }

    /// Two points with F = 2 F0, whose H / F are 1/4 and 1/2, weights 100 and 400: the weighted mean is 0.45, and the sum of squares
    /// of what is off it, 100 (0.2)^2 + 400 (0.05)^2 = 5, tells the coefficient better than its deviation of 0.1 does if it exceeds
    /// 100; with errors a fifth as large it is 125.
    #[test]
    fn points_tell_the_pressure_where_they_reach_over_loads() {
        let points = |part: f64| [seen(1.0, 0.5, 2.0, 0.1 * part), seen(3.0, 3.0, 6.0, 0.05 * part)];
        for (part, told) in [(1.0, false), (0.23, false), (0.22, true), (0.2, true)] {
            assert_eq!(tell_pressure(&points(part)), told, "{part}");
        }
    }

    #[test]
    fn a_coefficient_is_looked_for_up_to_where_it_alone_is_too_much() {
        let points = [seen(1.0, 2.0, 6.0, 0.3), seen(1.0, 0.0, 1.0, 0.1), seen(1.0, 5.0, 10.0, 0.2)];
        assert!((most(&points, 0.0) - 2.0).abs() < 1e-12 && (most(&points, 4.0) - 2.0 * exp(0.8)).abs() < 1e-12);
        assert_eq!(most(&points[1..2], 4.0), LARGEST_PRESSURE_COEFFICIENT);
        // Friction by pressure alone, and no strength is left.
        let points = [seen(1e-9, 1.0, 0.5, 1e-3), seen(1e-9, 20.0, 10.0, 1e-3)];
        assert!((nearest(&points, None).1 / (0.99 * 0.5) - 1.0).abs() < 1e-6, "{}", nearest(&points, None).1);
    }

    /// However far off they are.
    #[test]
    fn no_other_curve_is_nearer_to_scattered_points() {
        let points =
            [(1.0, 0.5, 1.2), (3.0, 1.1, 4.6), (9.0, 3.0, 7.8)].map(|(h, f, measured)| seen(f, h, measured, 1e-4));
        let cost = |kappa: f64| cost(&points, Prior::UNKNOWN, slice(&points, Prior::UNKNOWN, kappa).mean, kappa);
        let (_, kappa) = nearest(&points, None);
        assert!(cost(kappa) < cost(0.99 * kappa) && cost(kappa) < cost(1.01 * kappa), "{kappa}");
    }

    /// The most probable one; how sure it is where all of the force is of strength.
    #[test]
    fn a_slice_has_the_least_cost() {
        let points = [seen(1.0, 0.5, 2.0, 0.1), seen(3.0, 3.0, 5.0, 0.2)];
        for (prior, of_prior) in [(Prior::UNKNOWN, 0.0), (Prior { mean: -1.0, precision: 30.0 }, 30.0)] {
            for kappa in [0.0, 0.3] {
                let found = slice(&points, prior, kappa);
                let cost = |step: f64| cost(&points, prior, found.mean + step, kappa);
                assert!(cost(1e-5) > cost(0.0) && cost(-1e-5) > cost(0.0), "{kappa}, {of_prior}");
                assert!((found.log_weight - (0.5 * log(found.variance) - cost(0.0))).abs() < 1e-12);
            }
            let variance = slice(&points, prior, 0.0).variance;
            assert!((variance * (of_prior + 100.0 + 25.0) - 1.0).abs() < 1e-12, "{variance}");
        }
        assert_eq!(slice(&[], Prior { mean: -1.0, precision: 4.0 }, 0.1).mean, -1.0);
        assert_eq!(slice(&[], Prior { mean: -1.0, precision: 0.0 }, 0.1).mean, -1.0);
        // However far from 0 it is.
        let light = [1e-70, 1e-68].map(|force| seen(force, 0.0, 1e65 * force, 0.1));
        assert!((slice(&light, Prior::UNKNOWN, 0.0).mean - log(1e65)).abs() < 1e-12);
    }

    /// It costs half the square of what is off, in the deviations that it has without points.
    #[test]
    fn what_is_known_without_points_costs() {
        let prior = Prior { mean: 1.0, precision: 4.0 };
        assert!((cost(&[], prior, 1.5, 3.0 * PRESSURE_DEVIATION) - 0.5 * (1.0 + 9.0)).abs() < 1e-12);
        // The first and the last of many count half.
        let all = slices(&[seen(1.0, 0.5, 2.0, 0.1)], prior);
        for end in [all[0], all[all.len() - 1]] {
            let whole = slice(&[seen(1.0, 0.5, 2.0, 0.1)], prior, end.kappa);
            assert!((whole.log_weight - end.log_weight - log(2.0)).abs() < 1e-12, "{end:?}");
        }
    }

    /// Off by one and by two errors: over one point that is left sqrt(5), over none nothing.
    #[test]
    fn a_misfit_is_over_the_points_that_are_left() {
        let points = [seen(1.0, 0.0, exp(0.1), 0.1), seen(2.0, 0.0, 2.0 * exp(-0.4), 0.2)];
        assert!((misfit(&points, 0.0, 0.0, true) - 5_f64.sqrt()).abs() < 1e-12);
        assert_eq!(misfit(&points, 0.0, 0.1, true), 0.0);
        assert!((misfit(&points, 0.0, 0.1, false) - 5_f64.sqrt()).abs() < 1e-12);
        assert_eq!(misfit(&points[..1], 0.0, 0.0, false), 0.0);
        let all = [points[0], points[1], seen(1.0, 0.0, exp(0.1), 0.1)];
        assert!((misfit(&all, 0.0, 0.0, false) - 3_f64.sqrt()).abs() < 1e-12);
    }
}
