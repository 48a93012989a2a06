//! S_B curves of which much lies next to one end or both, down to two heights alone.
//!
//! The density is a spike at an end that no piece of the height axis resolves. Heights are written as logits, x =
//! ln((z - foot)/(head - z)), of which u = (x - median)/epsilon is linear and so the mass in dx smooth and short; a place
//! is known by its distances from both ends, so that nothing is lost next to either. Heights are measured from the head.

use super::fit::EndsFit;

/// Summits beyond this u, and as much beyond where a sum begins, contribute nothing.
const FARTHEST_SCORE: f64 = 12.0;
/// Logits of places nearer to an end than any number tells from it.
const FARTHEST_LOGIT: f64 = 700.0;
/// The longest panel in u, and its largest change of ln phi, on which a normal density is a polynomial to rounding.
const LONGEST_PANEL: f64 = 1.5;
const STEEPEST_PANEL: f64 = 12.0;

const LN_SQRT_2_PI: f64 = 0.918_938_533_204_672_8;

/// A standardised S_B curve about its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Ends {
    skew: f64,
    kurtosis: f64,
    epsilon: f64,
    /// Logit of the median.
    median: f64,
    /// Distance of the ends.
    width: f64,
    /// The head above the mean.
    head: f64,
    /// The ends, from the head.
    ends: [f64; 2],
}

/// A height between the ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// ln(above_foot/below_head).
    pub logit: f64,
    /// Distance from the foot.
    pub above_foot: f64,
    /// Distance from the head.
    pub below_head: f64,
}

impl Place {
    fn of_distances(above_foot: f64, below_head: f64) -> Self {
        let logit = above_foot.max(0.0).ln() - below_head.max(0.0).ln();
        Self { logit, above_foot, below_head }
    }

    /// How far another place is above this one.
    pub fn rise_to(&self, other: &Self) -> f64 {
        if self.above_foot < self.below_head {
            other.above_foot - self.above_foot
        } else {
            self.below_head - other.below_head
        }
    }

    /// The place `rise` higher.
    pub fn raised(&self, rise: f64) -> Self {
        Self::of_distances(self.above_foot + rise, self.below_head - rise)
    }

    /// The distance from the nearer end.
    pub fn from_end(&self) -> f64 {
        self.above_foot.min(self.below_head)
    }
}

impl Ends {
    pub(super) fn new(skew: f64, kurtosis: f64, fit: &EndsFit) -> Self {
        let width = 1.0 / fit.deviation;
        Self {
            skew,
            kurtosis,
            epsilon: fit.epsilon,
            median: -fit.epsilon * fit.step,
            width,
            head: fit.below_head * width,
            ends: [-width, 0.0],
        }
    }

    /// Third standardised moment.
    pub fn skew(&self) -> f64 {
        self.skew
    }

    /// Fourth standardised moment.
    pub fn kurtosis(&self) -> f64 {
        self.kurtosis
    }

    /// The height above the mean from which heights are measured: the head.
    pub fn origin(&self) -> f64 {
        self.head
    }

    /// The ends of the support.
    pub fn ends(&self) -> &[f64; 2] {
        &self.ends
    }

    /// 1/delta.
    pub fn epsilon(&self) -> f64 {
        self.epsilon
    }

    /// Their distance.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// The place of a logit, which may be infinite.
    #[inline]
    pub fn place(&self, logit: f64) -> Place {
        let smaller = (-logit.abs()).exp();
        let (near, far) = (self.width * smaller / (1.0 + smaller), self.width / (1.0 + smaller));
        let (above_foot, below_head) = if logit < 0.0 { (near, far) } else { (far, near) };
        Place { logit, above_foot, below_head }
    }

    /// The place of a height, at an end where it is beyond.
    pub fn place_of(&self, z: f64) -> Place {
        let z = z.clamp(-self.width, 0.0);
        Place::of_distances(z + self.width, -z)
    }

    /// The height of a place.
    #[inline]
    pub fn height(&self, place: &Place) -> f64 {
        if place.above_foot < place.below_head {
            place.above_foot - self.width
        } else {
            -place.below_head
        }
    }

    /// The height of a u.
    pub fn height_of_score(&self, u: f64) -> f64 {
        self.height(&self.place(self.median + self.epsilon * u))
    }

    /// u of a logit.
    #[inline]
    pub fn score(&self, logit: f64) -> f64 {
        (logit - self.median) / self.epsilon
    }

    /// The logit of a u.
    pub fn logit_of_score(&self, u: f64) -> f64 {
        self.median + self.epsilon * u
    }

    /// ln of the normal density at the lowest summit that counts, or of its maximum above.
    pub fn log_scale(&self, z: f64) -> f64 {
        let u = self.score(self.place_of(z).logit).max(0.0);
        -0.5 * u * u
    }

    /// Summits per logit, over exp(log_scale).
    #[inline]
    pub fn mass(&self, logit: f64, log_scale: f64) -> f64 {
        let u = self.score(logit);
        (-0.5 * u * u - LN_SQRT_2_PI - log_scale).exp() / self.epsilon
    }

    /// The density over exp(log_scale) at a place.
    #[inline]
    pub fn density(&self, place: &Place, log_scale: f64) -> f64 {
        let mass = self.mass(place.logit, log_scale);
        if mass > 0.0 {
            mass * self.width / (place.above_foot * place.below_head)
        } else {
            0.0
        }
    }

    /// ln phi.
    pub fn log_density(&self, z: f64) -> f64 {
        if z < -self.width || z > 0.0 {
            return f64::NEG_INFINITY;
        }
        self.density(&self.place_of(z), 0.0).ln()
    }

    /// The height at or above another where most summits are per logit.
    pub fn peak_above(&self, start: f64) -> f64 {
        start.max(self.height_of_score(0.0))
    }

    /// The u between which summits count, of those from u on.
    pub fn worth_summing(&self, from: f64) -> (f64, f64) {
        (-FARTHEST_SCORE, from.max(0.0).hypot(FARTHEST_SCORE))
    }

    /// How far from a logit a panel may reach in the direction +-1, as far as the normal density goes.
    pub fn longest_panel(&self, logit: f64, direction: f64) -> f64 {
        let u = self.score(logit) * direction;
        self.epsilon * LONGEST_PANEL.min(STEEPEST_PANEL / (u.abs() + LONGEST_PANEL))
    }

    /// The same as far as its place goes: to the head and the foot z is singular at the logit 0 +- i pi, and what depends on
    /// the distance from a height beyond an end at its logit +- i pi.
    pub fn longest_smooth(&self, logit: f64, direction: f64, beyond: Option<f64>) -> f64 {
        // A panel as long as the distance to a pole is good; e^x converges on one of 16.
        let length = |pole: f64| {
            let ahead = (pole - logit) * direction;
            if ahead > 0.0 {
                (ahead - 6.0).max(3.0)
            } else {
                3.0 - 2.0 * ahead
            }
        };
        length(0.0).min(beyond.map_or(16.0, length)).min(16.0)
    }

    /// The nearest logit to an end that is told from it.
    pub fn clamped(logit: f64) -> f64 {
        logit.clamp(-FARTHEST_LOGIT, FARTHEST_LOGIT)
    }
}
