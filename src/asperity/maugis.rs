//! Maugis' adhesive contact of one asperity with a flat, eqs (4)-(7), in closed form.
//!
//! A contact is given by theta = arccos(a/c) = arcsec m, where `a` is the contact radius and `c = m a` the outer radius of
//! the annulus in which the adhesive stress acts. theta -> 0 is heavy load, theta = pi/2 is a -> 0. Written in `c`, every
//! quantity is finite and smooth up to theta = pi/2, so neither the square-root edge at break-away nor the fold needs
//! special care. The parameter of the branch is s with theta = (pi/2)/(1 + s).
//! Attraction without contact belongs to [`super::attraction`], friction to [`super::slip`].

use super::contact::{Contact, ContactLaw, Rates};
use crate::asperity::groups::Groups;
use crate::numerics::elementary::{cbrt, sincos};
use crate::numerics::root::{self, LAST_STEP, MOST_STEPS};
use std::f64::consts::{FRAC_PI_2, PI};

/// lambda_g^3 above which the overlap has its minimum (the fold) at a > 0: 9 pi/(16 (pi - 1)), from d^2u/dtheta^2 = 0 at
/// theta = pi/2.
pub const FOLD_LAMBDA_CUBED: f64 = 0.825_154_991_394_896_2;

/// Maugis' contact law, by the coefficients of eqs (4)-(6).
#[derive(Debug, Clone)]
pub struct Maugis {
    /// alpha b / (pi beta h): the factor of the first bracket of eq (4), times g.
    bracket_2: f64,
    /// 4 gamma b^2 / (pi h^2): the factor of the second bracket of eq (4).
    bracket_1: f64,
    /// 1 / beta^2, the Hertzian term of eq (6), times g.
    overlap_hertz: f64,
    /// 2 gamma b / (alpha beta h), the adhesive term of eq (6).
    overlap_adhesion: f64,
    /// 4 alpha / (3 beta), the Hertzian term of eq (5), times g.
    load_hertz: f64,
    /// 2 gamma b / h, the adhesive term of eq (5).
    load_adhesion: f64,
    lambda_cubed: f64,
}

impl Maugis {
    /// The contact law of a surface's groups, of which gamma > 0.
    pub fn new(groups: &Groups) -> Self {
        let Groups { alpha, beta, gamma, b_over_h, .. } = *groups;
        Self {
            bracket_2: alpha * b_over_h / (PI * beta),
            bracket_1: 4.0 * gamma * b_over_h * b_over_h / PI,
            overlap_hertz: 1.0 / (beta * beta),
            overlap_adhesion: 2.0 * gamma * b_over_h / (alpha * beta),
            load_hertz: 4.0 * alpha / (3.0 * beta),
            load_adhesion: 2.0 * gamma * b_over_h,
            lambda_cubed: groups.lambda_cubed(),
        }
    }

    /// Whether the contact of a summit breaks at a > 0.
    fn has_fold(&self, g: f64) -> bool {
        self.lambda_cubed * g > FOLD_LAMBDA_CUBED
    }
}

impl ContactLaw for Maugis {
    /// Eqs (4)-(6).
    #[inline]
    fn at(&self, parameter: f64, g: f64) -> Contact {
        let inverse = 1.0 / (1.0 + parameter);
        let theta = FRAC_PI_2 * inverse;
        let theta_rate = -theta * inverse;
        let Angle { sin, cos, bracket_2, bracket_1 } = Angle::new(theta);
        let inv_g = 1.0 / g;
        // Eq (4) as k2 c^2 + k1 c = 1; d(bracket)/dtheta = 2 theta sin 2theta and theta cos theta.
        let factor_2 = self.bracket_2 * inv_g;
        let k2 = factor_2 * bracket_2;
        let k1 = self.bracket_1 * bracket_1;
        let root = (k1 * k1 + 4.0 * k2).sqrt();
        // c = 2/(k1 + root); 2 k2 c + k1 equals the root.
        let c_over_root = 2.0 / ((k1 + root) * root);
        let c = c_over_root * root;
        let k_rate = theta * cos * theta_rate;
        let c_rate = -c_over_root * k_rate * (factor_2 * 4.0 * sin * c + self.bracket_1);
        let c_by_g = c_over_root * k2 * c * inv_g;

        let a = c * cos;
        let a_rate = c_rate * cos - c * sin * theta_rate;
        let a_by_g = c_by_g * cos;
        let hertz = self.overlap_hertz * inv_g;
        let load_hertz = self.load_hertz * inv_g;
        // d(annulus)/dtheta = 2 cos^2.
        let annulus = sin * cos + theta;
        Contact {
            parameter,
            overlap: hertz * a * a - self.overlap_adhesion * sin * c,
            radius: a,
            load: load_hertz * a * a * a - self.load_adhesion * annulus * c * c,
            hertz_load: load_hertz * a * a * a,
            by_s: Rates {
                overlap: 2.0 * hertz * a * a_rate - self.overlap_adhesion * (cos * theta_rate * c + sin * c_rate),
                radius: a_rate,
                load: 3.0 * load_hertz * a * a * a_rate
                    - 2.0 * self.load_adhesion * c * (cos * cos * theta_rate * c + annulus * c_rate),
                hertz_load: 3.0 * load_hertz * a * a * a_rate,
            },
            by_g: Rates {
                overlap: hertz * a * (2.0 * a_by_g - a * inv_g) - self.overlap_adhesion * sin * c_by_g,
                radius: a_by_g,
                load: load_hertz * a * a * (3.0 * a_by_g - a * inv_g) - 2.0 * self.load_adhesion * annulus * c * c_by_g,
                hertz_load: load_hertz * a * a * (3.0 * a_by_g - a * inv_g),
            },
            spring_stiffness: 0.0,
        }
    }

    /// Where a = 0, or at the fold where lambda_g is large.
    fn break_away(&self, g: f64) -> Contact {
        if !self.has_fold(g) {
            return self.at(0.0, g);
        }
        // From heavy load the overlap falls with s down to the fold: its first extremum.
        let mut upper = 1.0;
        while self.at(upper, g).by_s.overlap <= 0.0 {
            upper *= 2.0;
        }
        // At s = 0 the rate is 0 whatever lambda_g is.
        let rate_over_s = |s: f64| self.at(s, g).by_s.overlap / s;
        self.at(root::bracketed(rate_over_s, LEAST_PARAMETER_AT_FOLD * upper, upper), g)
    }

    fn at_overlap(&self, overlap: f64, g: f64, guess: f64) -> Contact {
        let (mut lower, mut upper) = (0.0, f64::INFINITY);
        let mut contact = self.at(guess.max(0.0), g);
        let (mut before, mut last_step) = (contact, f64::INFINITY);
        for _ in 0..MOST_STEPS {
            let s = contact.parameter;
            let missing = overlap - contact.overlap;
            // Past the fold the overlap rises again: that is off the branch.
            if contact.by_s.overlap <= 0.0 || missing > 0.0 {
                lower = s;
            } else {
                upper = s;
            }
            let newton = s + missing / contact.by_s.overlap;
            let step = (newton - s).abs();
            // Next to the fold a step may be large after a small one.
            let converges = step <= last_step && step * last_step <= LAST_STEP * s * s;
            if converges || step <= LAST_STEP * s {
                return Contact { overlap, ..contact.moved(newton - s, 0.0).with_rates_beyond(&contact, &before) };
            }
            let next = if newton > lower && newton < upper && contact.by_s.overlap > 0.0 {
                newton
            } else if upper < f64::INFINITY {
                0.5 * (lower + upper)
            } else {
                2.0 * s + 1.0
            };
            if upper < f64::INFINITY && upper - lower <= f64::EPSILON * (1.0 + upper) {
                break;
            }
            (before, last_step) = (contact, (next - s).abs());
            contact = self.at(next, g);
        }
        Contact { overlap, ..contact }
    }

    /// Eq (4) for heavy load, with Hertz' radius.
    fn guess(&self, overlap: f64, g: f64) -> f64 {
        let hertz_radius_squared = overlap.max(0.0) / self.overlap_hertz; // over g
        let radius = (hertz_radius_squared * g).sqrt();
        // 1/theta by either of the two brackets.
        let by_bracket_2 = cbrt(self.bracket_2 * hertz_radius_squared / 0.75);
        let by_bracket_1 = (0.5 * self.bracket_1 * radius).sqrt();
        (FRAC_PI_2 * by_bracket_2.max(by_bracket_1) - 1.0).max(LEAST_GUESS)
    }

    /// The first bracket of eq (4) vanishes at theta = 2.2467.
    fn distance_to_singularity(&self, parameter: f64, _g: f64) -> f64 {
        SINGULAR_BEFORE + parameter
    }
}

/// The states are singular at s = -0.3008, where the first bracket of eq (4) vanishes.
const SINGULAR_BEFORE: f64 = 0.3;
/// Not 0, where the overlap does not depend on the parameter.
const LEAST_GUESS: f64 = 0.1;
/// A fold nearer to s = 0 than this has an overlap that is that of s = 0 to rounding.
const LEAST_PARAMETER_AT_FOLD: f64 = 1e-6;

/// What eqs (4)-(6) take of theta.
struct Angle {
    sin: f64,
    cos: f64,
    /// sin theta cos theta - theta cos 2theta: the first bracket of eq (4) times cos^2.
    bracket_2: f64,
    /// theta sin theta - (1 - cos theta): the second times cos.
    bracket_1: f64,
}

impl Angle {
    /// By Taylor series where the closed forms cancel.
    #[inline]
    fn new(theta: f64) -> Self {
        if theta >= 0.5 {
            let (sin, cos) = if theta == FRAC_PI_2 { (1.0, 0.0) } else { sincos(theta) };
            let cos_2 = (cos - sin) * (cos + sin);
            return Self { sin, cos, bracket_2: sin * cos - theta * cos_2, bracket_1: theta * sin - (1.0 - cos) };
        }
        let x = theta * theta;
        Self {
            sin: theta - theta * x * even_odd(&SERIES_SIN, x),
            cos: 1.0 - x * even_odd(&SERIES_COS, x),
            bracket_2: even_odd(&SERIES_2, x) * x * theta,
            bracket_1: even_odd(&SERIES_1, x) * x,
        }
    }
}

/// A polynomial by its even and odd parts, whose sums do not wait for each other.
#[inline]
fn even_odd(c: &[f64; SERIES_TERMS], x: f64) -> f64 {
    let y = x * x;
    let even = c[0] + y * (c[2] + y * (c[4] + y * (c[6] + y * c[8])));
    let odd = c[1] + y * (c[3] + y * (c[5] + y * (c[7] + y * c[9])));
    even + x * odd
}

const SERIES_TERMS: usize = 10;
const SERIES_2: [f64; SERIES_TERMS] = series_of_bracket(3);
const SERIES_1: [f64; SERIES_TERMS] = series_of_bracket(2);
const SERIES_SIN: [f64; SERIES_TERMS] = series_of_sine(3);
const SERIES_COS: [f64; SERIES_TERMS] = series_of_sine(2);

/// Coefficients of the powers of theta^2 in (theta - sin theta)/theta^3 and 1 - cos theta over theta^2: (-1)^k/(2k + first)!.
const fn series_of_sine(first: usize) -> [f64; SERIES_TERMS] {
    let mut out = [0.0; SERIES_TERMS];
    let mut term = if first == 3 { 1.0 / 6.0 } else { 0.5 };
    let mut k = 0;
    while k < SERIES_TERMS {
        out[k] = term;
        term /= -(((2 * k + first + 1) * (2 * k + first + 2)) as f64);
        k += 1;
    }
    out
}

/// Coefficients of theta^(2k + power): of the first bracket, from theta^3 on, (-1)^k 2^(2k+2) (2k+2)/(2k+3)!; of the second,
/// from theta^2 on, (-1)^k (2k+1)/(2k+2)!.
const fn series_of_bracket(power: usize) -> [f64; SERIES_TERMS] {
    let square = if power == 3 { 4.0 } else { 1.0 };
    let mut out = [0.0; SERIES_TERMS];
    let mut term = square; // square^(k+1) / (2k + power - 2)! with sign
    let mut k = 0;
    while k < SERIES_TERMS {
        out[k] = term / (2 * k + power) as f64;
        term *= -square / ((2 * k + power - 1) * (2 * k + power)) as f64;
        k += 1;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::contact::tests::{assert_rates_are_secants, elastic};
    use crate::numerics::near;

    /// With little adhesion and with much.
    fn laws() -> [Maugis; 2] {
        [1e-4, 0.02].map(|gamma| Maugis::new(&elastic([0.01, 1e3, gamma, 0.7])))
    }

    #[test]
    fn brackets_are_one_function_by_series_and_in_closed_form() {
        let closed = |theta: f64| {
            let (sin, cos) = theta.sin_cos();
            (sin * cos - theta * (2.0 * theta).cos(), theta * sin - (1.0 - cos))
        };
        for theta in [0.2, 0.3, 0.49, 0.499_999_999_999, 0.5, 0.6, 1.2, FRAC_PI_2] {
            let Angle { sin, cos, bracket_2, bracket_1 } = Angle::new(theta);
            assert!(near(sin, theta.sin(), 3e-16) && near(cos, theta.cos(), 1e-15) || theta == FRAC_PI_2, "{theta}");
            let (found, expected) = ((bracket_2, bracket_1), closed(theta));
            let tolerance = if theta < 0.45 { 1e-12 } else { 2e-14 };
            assert!(near(found.0, expected.0, tolerance), "{theta}: {found:?}, not {expected:?}");
            assert!(near(found.1, expected.1, tolerance), "{theta}: {found:?}, not {expected:?}");
        }
        // 4/3 theta^3 and theta^2/2 at heavy load.
        let heavy = Angle::new(1e-5);
        assert!(near(heavy.bracket_2, 4.0 / 3.0 * 1e-15, 1e-9) && near(heavy.bracket_1, 0.5e-10, 1e-9));
    }

    #[test]
    fn rates_are_slopes_of_secants() {
        for law in laws() {
            assert_rates_are_secants(&law, &[0.0, 0.03, 0.4, 2.0, 50.0, 1e4]);
        }
    }
}
