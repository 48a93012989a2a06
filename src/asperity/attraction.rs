//! Attraction of an asperity that is not in contact, eqs (9)-(12), corrected: the gap is minus the overlap.
//!
//! A constant stress w/h acts within a circle of radius `c`, where the deformed gap is `h`. The overlap is
//! a quadratic polynomial in `c`, which makes `c` the natural variable of integration.

use crate::asperity::groups::Groups;
use std::f64::consts::PI;

/// lambda_g^3 from which a summit out of contact no longer attracts: (0.655...)^3, exact.
pub const ATTRACTION_LAMBDA_CUBED: f64 = 9.0 / 32.0;

/// The law of attraction, for any local radius factor `g`. Radii in b, overlap in sigma, load in E* b^2.
#[derive(Debug, Clone)]
pub struct Attraction {
    /// R / b.
    radius: f64,
    /// sigma / R.
    sigma_over_radius: f64,
    /// h / sigma: attraction reaches down to this gap.
    pub reach: f64,
    /// 4 sigma_0 / (pi E*), eq (10).
    strain: f64,
    /// sigma / b.
    sigma: f64,
    /// sigma_0 / E*.
    stress: f64,
}

/// One attracted asperity.
#[derive(Debug, Clone, Copy)]
pub struct Attracted {
    /// Load, negative, in E* b^2.
    pub load: f64,
    /// dP/du at fixed g.
    pub load_by_overlap: f64,
    /// du/dc at fixed g.
    pub overlap_rate: f64,
    /// d2u/dc2 at fixed g, the same for all circles.
    pub overlap_bend: f64,
}

impl Attracted {
    /// By how much a circle is larger where the overlap is larger by `rise`. Not as a difference: beside the reach of
    /// attraction the rise may be small.
    #[inline]
    pub fn span(&self, rise: f64) -> f64 {
        let rate = self.overlap_rate;
        2.0 * rise / (rate + (rate * rate + 2.0 * self.overlap_bend * rise).sqrt())
    }

    /// By how much the overlap is larger where the circle is larger by `span`, and du/dc there.
    #[inline]
    pub fn rise(&self, span: f64) -> (f64, f64) {
        (span * (self.overlap_rate + 0.5 * self.overlap_bend * span), self.overlap_rate + self.overlap_bend * span)
    }
}

impl Attraction {
    /// The law of a surface's groups.
    pub fn new(groups: &Groups) -> Self {
        let Groups { alpha, beta, gamma, b_over_h, .. } = *groups;
        Self {
            radius: beta / alpha,
            sigma_over_radius: alpha * alpha,
            reach: groups.reach(),
            strain: 4.0 * gamma * b_over_h / PI,
            sigma: alpha * beta,
            stress: gamma * b_over_h,
        }
    }

    /// The radius of the circle of interaction at an overlap, eq (10), in b.
    #[inline]
    fn circle(&self, overlap: f64, g: f64) -> f64 {
        let height = (2.0 * self.sigma_over_radius * (self.reach + overlap) / g).max(0.0);
        self.radius * g * (self.strain + (self.strain * self.strain + height).sqrt())
    }

    /// The attracted asperity at an overlap, eqs (10) and (11).
    #[inline]
    pub fn at_overlap(&self, overlap: f64, g: f64) -> Attracted {
        let circle = self.circle(overlap, g);
        let relative = circle / (self.radius * g) - self.strain;
        // R' d(c/R')/du = sigma / relative
        let overlap_rate = relative / self.sigma;
        Attracted {
            load: -PI * circle * circle * self.stress,
            load_by_overlap: -2.0 * PI * circle * self.stress / overlap_rate,
            overlap_rate,
            overlap_bend: 1.0 / (self.sigma * self.radius * g),
        }
    }
}
