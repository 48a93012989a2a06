//! Radius of curvature of a summit as a function of its height, eq (3), or of its normal score and the surface there.

use crate::distribution::at_scores::AtScores;
use crate::numerics::elementary::{exp_each, hypot};
use std::sync::Arc;

/// g(z) = 1 + epsilon tanh(rho z), the local radius over the mean one; of a table of the surface at normal scores
/// (1 + epsilon tanh(rho u)) t/s at the score u.
#[derive(Debug, Clone)]
pub struct RadiusProfile {
    /// epsilon, in [-1, 1].
    pub amplitude: f64,
    /// rho > 0, per sigma or per score.
    pub rate: f64,
    /// Where heights are measured from, above their mean.
    pub origin: f64,
    pub scores: Option<Arc<AtScores>>,
}

/// Over one smooth piece the radius changes by no more e-folds.
const MOST_RADIUS_E_FOLDS: f64 = 7.0;
/// A panel resolves so many times as much of eq (3), but not of a table, of which radii are cubics of cubics.
const PANEL_OVER_SMOOTH: f64 = 1.2;
/// How finely heights are looked at, per length in which radii change.
const LOOKS_PER_CHANGE: f64 = 8.0;
/// Smaller radius factors are taken as this: such summits carry nothing, and squares stay in range.
const SMALLEST_FACTOR: f64 = 1e-60;

impl RadiusProfile {
    /// Whether all summits have the same radius.
    pub fn is_constant(&self) -> bool {
        self.amplitude == 0.0 && self.scores.is_none()
    }

    /// Whether some fall with height.
    pub fn may_fall(&self) -> bool {
        self.amplitude < 0.0 || self.scores.is_some()
    }

    /// Whether a table says that the surface is flat at a height.
    pub fn is_flat(&self, z: f64) -> bool {
        self.scores.as_ref().is_some_and(|scores| scores.is_flat(z))
    }

    /// How fast they change with height at most, per sigma, but for a factor.
    pub fn steepness(&self) -> f64 {
        self.scores.as_ref().map_or(self.rate, |scores| scores.steepest() * self.rate.max(1.0))
    }

    /// The height at which radii change fastest.
    pub fn turn(&self) -> Option<f64> {
        (self.scores.is_none() && self.amplitude != 0.0).then_some(-self.origin)
    }

    /// g and dg/dz at height z, without cancellation where g goes to 0 (|epsilon| = 1).
    #[inline]
    pub fn at(&self, z: f64) -> (f64, f64) {
        self.at_each([z])[0]
    }

    /// The same at each of several heights, side by side.
    #[inline]
    pub fn at_each<const N: usize>(&self, z: [f64; N]) -> [(f64, f64); N] {
        match &self.scores {
            None if self.amplitude == 0.0 => [(1.0, 0.0); N],
            None => self.of_heights(z.map(|z| z + self.origin)).map(Self::bounded),
            Some(scores) => {
                let places = z.map(|z| scores.place(z));
                let (ratios, factors) =
                    (exp_each(places.map(|place| place.log_ratio)), self.of_heights(places.map(|place| place.score)));
                std::array::from_fn(|i| {
                    let (place, (g, slope)) = (places[i], factors[i]);
                    Self::bounded((g * ratios[i], (slope * place.rate + g * place.log_ratio_rate) * ratios[i]))
                })
            }
        }
    }

    fn bounded((g, slope): (f64, f64)) -> (f64, f64) {
        if g > SMALLEST_FACTOR {
            (g, slope)
        } else {
            (SMALLEST_FACTOR, 0.0)
        }
    }

    /// Eq (3) and its slope.
    #[inline]
    fn of_heights<const N: usize>(&self, z: [f64; N]) -> [(f64, f64); N] {
        let (size, rate) = (self.amplitude.abs(), self.rate * self.amplitude.signum());
        let y = z.map(|z| rate * z);
        let decay = exp_each(y.map(|y| -2.0 * y.abs()));
        std::array::from_fn(|i| {
            let (share, rest) = (decay[i] / (1.0 + decay[i]), 1.0 / (1.0 + decay[i]));
            let g = if y[i] >= 0.0 { 1.0 + size * (rest - share) } else { (1.0 - size) + size * 2.0 * share };
            (g, size * rate * 4.0 * share * rest)
        })
    }

    /// g at height z.
    #[inline]
    pub fn factor(&self, z: f64) -> f64 {
        self.at(z).0
    }

    /// How far above z one smooth piece may reach: the poles of tanh lie at +-i pi/(2 rho), and where g goes to 0 it is exponential.
    fn smooth_length(&self, z: f64) -> f64 {
        if self.is_constant() {
            return f64::MAX;
        }
        let pole = std::f64::consts::FRAC_PI_2 / self.rate;
        let (g, slope) = self.at(z);
        let place = self.scores.as_ref().map(|scores| scores.place(z));
        let (place, rate) = place.map_or((z + self.origin, 1.0), |place| (place.score, place.rate));
        let smooth = if place < 0.0 { (0.65 * -place).max(1.1 * pole) } else { 1.1 * hypot(place, pole) } / rate;
        smooth.min(MOST_RADIUS_E_FOLDS * g / slope.abs())
    }

    /// How far above z one panel may reach.
    pub fn panel_length(&self, z: f64) -> f64 {
        self.smooth_length(z) * if self.scores.is_some() { 1.0 } else { PANEL_OVER_SMOOTH }
    }

    /// Heights from one up to another, near enough to each other to see how radii change.
    pub fn looks(&self, lowest: f64, highest: f64) -> impl Iterator<Item = f64> + '_ {
        let width = |z: f64| self.scores.as_ref().map_or(f64::INFINITY, |scores| scores.width(z));
        let next = move |&z: &f64| Some(z + self.smooth_length(z).min(width(z)) / LOOKS_PER_CHANGE);
        std::iter::successors(Some(lowest), next).take_while(move |&z| z < highest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_factor_is_eq_3_and_its_slope_that_of_a_secant() {
        for (amplitude, rate, origin) in [(0.0, 0.5, 0.0), (0.6, 0.5, 0.0), (-0.9, 2.0, 1.5), (1.0, 0.3, -2.0)] {
            let radius = RadiusProfile { amplitude, rate, origin, scores: None };
            assert_eq!(radius.is_constant(), amplitude == 0.0);
            for z in [-5.0, -1.0, 0.0, 0.3, 4.0] {
                let (g, slope) = radius.at(z);
                let tanh = (rate * (z + origin)).tanh();
                assert!((g - (1.0 + amplitude * tanh)).abs() < 1e-15, "{radius:?} at {z}: {g}");
                assert!((slope - amplitude * rate * (1.0 - tanh * tanh)).abs() < 1e-15, "{radius:?} at {z}: {slope}");
                assert_eq!(radius.factor(z), g);
            }
        }
        // Where g goes to 0 it is 2 e^(2 rho z), as far as that matters.
        let vanishing = RadiusProfile { amplitude: 1.0, rate: 0.5, origin: 0.0, scores: None };
        for z in [-30.0, -130.0] {
            let (g, slope) = vanishing.at(z);
            assert!((g / (2.0 * f64::exp(z)) - 1.0).abs() < 1e-12 && (slope / g - 1.0).abs() < 1e-12, "{g:e} at {z}");
        }
        assert_eq!(vanishing.at(-140.0), (SMALLEST_FACTOR, 0.0));
    }
}
