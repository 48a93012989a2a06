//! How heights of Johnson's system move as skew and kurtosis change, each at a fixed score u.
//!
//! With v and epsilon of `fit`, all changes of shape of a curve are spanned by
//!
//! ```text
//! S_U:  b_1 = (cosh t - 1)/epsilon^2      b_2 = (t cosh t - sinh t + tau (t sinh t - 2 (cosh t - 1)))/epsilon^3
//! S_B:  b_1 = v^2                         b_2 = dv/du (sinh t - t)/epsilon^3
//! ```
//!
//! combinations of the derivatives of v by its two parameters that do not vanish towards the Gaussian, where they are u^2/2
//! and u^3/3, or u^2 and u^3/6. Less what mean 0 and standard deviation 1 take of them they change skew and kurtosis by the
//! means of 3 z^2 b and 4 z^3 b: two equations for the share of each in what a parameter changes.

use super::super::Motion;
use super::{Johnson, Kind};
use crate::elementary::{exp, expm1, sinh};

/// Scores for means: as far as the fourth power of v counts. Steps as for the moments in `fit`.
const FARTHEST_SCORE: f64 = 10.0;

/// The motion of the heights of a curve.
pub struct JohnsonMotion<'a> {
    curve: &'a Johnson,
    /// For skew and for kurtosis.
    changes: [Change; 2],
    of_origin: [f64; 2],
}

/// What changes per unit of a parameter.
#[derive(Debug, Clone, Copy, Default)]
struct Change {
    /// How much of b_1 and of b_2 there is in dv.
    parts: [f64; 2],
    /// What dv has of a constant and of z.
    mean: f64,
    slope: f64,
}

impl<'a> JohnsonMotion<'a> {
    /// The motion of a curve.
    pub fn new(curve: &'a Johnson) -> Self {
        // Means of 1, z, z^2 and z^3 times each function.
        let (mut weights, mut means) = (0.0, [[0.0; 4]; 2]);
        let step = (0.35 / curve.epsilon).min(0.4);
        let last = FARTHEST_SCORE + (4.0 * curve.epsilon).min(6.0);
        for j in (-last / step) as i32..=(last / step) as i32 {
            let u = step * f64::from(j);
            let z = curve.height(u) + curve.origin;
            let weight = exp(-0.5 * u * u);
            weights += weight;
            for (means, function) in means.iter_mut().zip(curve.shape_changes(u)) {
                let mut term = weight * function;
                for mean in means {
                    *mean += term;
                    term *= z;
                }
            }
        }
        let means = means.map(|means| means.map(|mean| mean / weights));
        // d(skew) and d(kurtosis) for each function, standardised: z has the moments 0, 1, skew and kurtosis.
        let moments = means.map(|[mean, slope, second, third]| {
            let by_skew = 3.0 * (second - mean - slope * curve.skew);
            let by_kurtosis = 4.0 * (third - mean * curve.skew - slope * curve.kurtosis);
            [by_skew / curve.deviation, by_kurtosis / curve.deviation]
        });
        let determinant = moments[0][0] * moments[1][1] - moments[0][1] * moments[1][0];
        let change = |parts: [f64; 2]| {
            let of = |power: usize| parts[0] * means[0][power] + parts[1] * means[1][power];
            Change { parts, mean: of(0), slope: of(1) }
        };
        let changes = [
            change([moments[1][1] / determinant, -moments[0][1] / determinant]),
            change([-moments[1][0] / determinant, moments[0][0] / determinant]),
        ];
        let mut motion = Self { curve, changes, of_origin: [0.0; 2] };
        if curve.origin != 0.0 {
            // At the median, where both functions vanish.
            let from_origin = motion.above_origin(curve.median);
            motion.of_origin = std::array::from_fn(|i| motion.above_mean(&changes[i], 0.0) - from_origin[i]);
        }
        motion
    }

    /// d(z above the mean) at a score.
    fn above_mean(&self, change: &Change, u: f64) -> f64 {
        let functions = self.curve.shape_changes(u);
        let z = self.curve.height(u) + self.curve.origin;
        let shape = change.parts[0] * functions[0] + change.parts[1] * functions[1];
        (shape - change.mean - z * change.slope) / self.curve.deviation
    }

    /// The same above an origin that is not the mean, without the cancellation that the difference of two motions has next to
    /// it: from the changes of the parameters of `fit`.
    fn above_end(&self, change: &Change, z: f64, u: f64) -> f64 {
        let Johnson { epsilon, deviation, kind, rate, .. } = *self.curve;
        let t = epsilon * u;
        let [first, second] = change.parts;
        match kind {
            Kind::Unbounded { below, above } => {
                // epsilon (z - origin) = sinh t + tau cosh t.
                let tau = 0.5 * (above - below);
                let by_epsilon = second / epsilon;
                let by_tau = (first - tau * by_epsilon) / epsilon;
                let (grown, fallen) = (0.5 * exp(t), 0.5 * exp(-t));
                let rise = by_tau * (grown + fallen) + by_epsilon * u * (above * grown + below * fallen);
                rise / rate - z * (by_epsilon / epsilon + change.slope / deviation)
            }
            Kind::Bounded { share, .. } => {
                // epsilon (z - origin) = -1/(share (1 + share (e^t - 1))).
                let by_epsilon = -second / epsilon;
                let by_share = ((0.5 - share) * by_epsilon - first) / epsilon;
                let rise = expm1(t);
                let fall = (rise * by_share + share * (1.0 + rise) * u * by_epsilon) / (1.0 + share * rise);
                -z * (fall + by_share / share + by_epsilon / epsilon + change.slope / deviation)
            }
        }
    }
}

impl Motion for JohnsonMotion<'_> {
    fn of_origin(&self) -> [f64; 2] {
        self.of_origin
    }

    fn above_origin(&self, z: f64) -> [f64; 2] {
        let u = self.curve.at(z).map_or(0.0, |at| at.u);
        self.changes.map(|change| match self.curve.origin == 0.0 {
            true => self.above_mean(&change, u),
            false => self.above_end(&change, z, u),
        })
    }
}

impl Johnson {
    /// b_1 and b_2 at a score.
    fn shape_changes(&self, u: f64) -> [f64; 2] {
        let t = self.epsilon * u;
        match self.kind {
            Kind::Unbounded { below, above } => {
                let tau = 0.5 * (above - below);
                let half = sinh_over(0.5 * t);
                let bent = cosh_less_sinh(0.5 * t) * half;
                [0.5 * (u * half) * (u * half), u * u * u * (cosh_less_sinh(t) + 0.25 * tau * t * bent)]
            }
            Kind::Bounded { share, .. } => {
                let rise = expm1(t);
                let level = 1.0 + share * rise;
                // (e^t - 1)/epsilon
                let v = u * exp(0.5 * t) * sinh_over(0.5 * t) / level;
                [v * v, u * u * u * sinh_less_line(t) * (1.0 + rise) / (level * level)]
            }
        }
    }
}

/// Where series take the place of closed forms that cancel.
const SMALL: f64 = 1.0;

/// sinh(t)/t.
fn sinh_over(t: f64) -> f64 {
    if t.abs() < SMALL {
        series(t, 1.0, [6.0, 20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0])
    } else {
        sinh(t) / t
    }
}

/// (sinh(t) - t)/t^3.
fn sinh_less_line(t: f64) -> f64 {
    if t.abs() < SMALL {
        series(t, 1.0 / 6.0, [20.0, 42.0, 72.0, 110.0, 156.0, 210.0, 272.0, 342.0])
    } else {
        (sinh(t) - t) / (t * t * t)
    }
}

/// (t cosh(t) - sinh(t))/t^3: the sum of 2k t^(2k-2)/(2k + 1)!.
fn cosh_less_sinh(t: f64) -> f64 {
    if t.abs() < SMALL {
        series(t, 1.0 / 3.0, [10.0, 28.0, 54.0, 88.0, 130.0, 180.0, 238.0, 304.0])
    } else {
        (0.5 * t * (exp(t) + exp(-t)) - sinh(t)) / (t * t * t)
    }
}

/// first (1 + t^2/d_1 (1 + t^2/d_2 (...))).
fn series(t: f64, first: f64, divisors: [f64; 8]) -> f64 {
    first * divisors.iter().rev().fold(1.0, |sum, divisor| 1.0 + t * t / divisor * sum)
}

#[cfg(test)]
mod tests {
    use super::super::{fit, heights, Johnson};
    use super::*;

    fn curve(skew: f64, kurtosis: f64) -> Johnson {
        Johnson::new(skew, kurtosis, fit::fit(skew, kurtosis))
    }

    #[test]
    fn series_and_closed_forms_are_one_function() {
        for t in [0.3_f64, 0.999_999_999, 1.000_000_001, -0.999_999_999, -2.0] {
            for (name, found, expected) in [
                ("sinh/t", sinh_over(t), t.sinh() / t),
                ("sinh - t", sinh_less_line(t), (t.sinh() - t) / t.powi(3)),
                ("t cosh - sinh", cosh_less_sinh(t), (t * t.cosh() - t.sinh()) / t.powi(3)),
            ] {
                assert!((found / expected - 1.0).abs() < 2e-14, "{name} at {t}: {found}, not {expected}");
            }
        }
        assert_eq!([sinh_over(0.0), sinh_less_line(0.0), cosh_less_sinh(0.0)], [1.0, 1.0 / 6.0, 1.0 / 3.0]);
    }

    /// Of S_U, S_B, curves next to lognormal ones on either side and next to the Gaussian, with the mean and with their end as
    /// the origin: by the difference of curves of neighbouring moments, heights above the mean and above the origin.
    #[test]
    fn motions_are_differences_of_curves() {
        let lognormal = |skew: f64, part: f64| (skew, (3.0 + fit::excess_of_lognormal(skew)) * (1.0 + part));
        for (skew, kurtosis) in [
            (0.8, 6.0),
            (-0.9, 30.0),
            (3.0, 22.0),
            (0.5, 3.3),
            (-0.8, 3.2),
            (0.2, 2.0),
            (0.0, 4.0),
            (0.0, 2.5),
            (0.02, 3.01),
            (0.02, 2.99),
            lognormal(-1.0, 1e-2),
            lognormal(-1.0, 1e-3),
            lognormal(0.4, -1e-2),
        ] {
            let here = curve(skew, kurtosis);
            let motion = JohnsonMotion::new(&here);
            for u in [-6.0, -2.0, -0.3, 0.0, 0.7, 2.0, 5.0, 9.0] {
                let z = here.height(u);
                let (origin, above) = (motion.of_origin(), motion.above_origin(z));
                for (which, step) in [(0, 1e-4), (1, 1e-4)] {
                    let moved = |part: f64| {
                        let [by_skew, by_kurtosis] = if which == 0 { [step * part, 0.0] } else { [0.0, step * part] };
                        let moved = curve(skew + by_skew, kurtosis + by_kurtosis);
                        moved.height(u) + moved.origin
                    };
                    let [far, near] = [2.0, 1.0].map(|part| (moved(part) - moved(-part)) / (2.0 * step * part));
                    let expected = (4.0 * near - far) / 3.0;
                    let found = origin[which] + above[which];
                    let known = 1e-7 * (1.0 + expected.abs() + z.abs());
                    assert!((found - expected).abs() < known, "{which} at {u} of {here:?}: {found}, not {expected}");
                }
            }
        }
    }

    #[test]
    fn the_gaussian_moves_as_curves_next_to_it() {
        let gaussian = heights(0.0, 3.0).expect("heights");
        let gaussian = gaussian.motion().expect("a motion");
        for next in [3.0 + 1e-9, 3.0 - 1e-9].map(|kurtosis| curve(1e-6, kurtosis)) {
            for z in [-4.0, -0.5, 0.0, 1.0, 3.0] {
                let found = JohnsonMotion::new(&next).above_origin(z).into_iter();
                for (found, expected) in found.zip(gaussian.above_origin(z)) {
                    assert!((found - expected).abs() < 1e-4, "{found}, not {expected} at {z}");
                }
            }
        }
    }
}
