//! Maugis' adhesive contact of one asperity with a flat, eqs (4)-(7), in closed form.
//!
//! The contact is parametrised by theta = arccos(a/c) = arcsec m, where `a` is the contact radius
//! and `c = m a` the outer radius of the annulus in which the adhesive stress acts. theta -> 0 is
//! heavy load, theta = pi/2 is a -> 0. Written in `c`, every quantity is finite and smooth up to
//! theta = pi/2, so neither the square-root edge at break-away nor the fold needs special care.
//! Attraction without contact belongs to [`super::attraction`], friction to [`super::slip`].

use crate::elementary::{cbrt, cos, sincos};
use crate::groups::Groups;
use crate::root;
use std::f64::consts::{FRAC_PI_2, PI};

/// lambda_g^3 above which the overlap has its minimum (the fold) inside (0, pi/2): the contact then
/// breaks with a > 0. It is where d^2u/dtheta^2 = 0 at theta = pi/2.
pub const FOLD_LAMBDA_CUBED: f64 = 0.825_154_991_394_896_2;

/// Within this of pi/2 the distance from there is known to few digits by theta.
const TIP: f64 = 1e-3;
/// A Newton step in theta, over the distance to 0 or pi/2, so small that the derivatives at its beginning carry the
/// contact along: by itself for the contact, and times the step before for the derivatives.
const FIRST_ORDER_STEP: f64 = 1e-8;
const FIRST_ORDER_STEPS: f64 = 1e-13;

/// Maugis' contact law with its coefficients, for any local radius factor `g`.
///
/// Lengths: radii in b, overlap in sigma; load in E* b^2.
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

/// One asperity in contact, and its derivatives along the branch at fixed radius factor g.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    /// arcsec m, in (0, pi/2].
    pub theta: f64,
    /// Overlap u = z - d, eq (6), in sigma.
    pub overlap: f64,
    /// Contact radius a, eq (4), in b.
    pub radius: f64,
    /// Load P, eq (5), in E* b^2.
    pub load: f64,
    /// du/dtheta: negative on the unloading branch, 0 where the contact breaks.
    pub overlap_rate: f64,
    /// da/dtheta.
    pub radius_rate: f64,
    /// dP/dtheta.
    pub load_rate: f64,
    /// du/dg at fixed theta.
    pub overlap_by_g: f64,
    /// da/dg at fixed theta.
    pub radius_by_g: f64,
}

impl Contact {
    /// The contact at a theta so near that first order is exact, where its overlap is known to be `overlap`; the change
    /// of its derivatives is that since `before`.
    #[inline]
    fn moved(self, theta: f64, overlap: f64, before: &Contact) -> Self {
        let step = theta - self.theta;
        let way = self.theta - before.theta;
        let part = if way != 0.0 { step / way } else { 0.0 };
        let onwards = |here: f64, before: f64| here + part * (here - before);
        Self {
            theta,
            overlap,
            radius: self.radius + step * self.radius_rate,
            load: self.load + step * self.load_rate,
            overlap_rate: onwards(self.overlap_rate, before.overlap_rate),
            radius_rate: onwards(self.radius_rate, before.radius_rate),
            load_rate: onwards(self.load_rate, before.load_rate),
            overlap_by_g: onwards(self.overlap_by_g, before.overlap_by_g),
            radius_by_g: onwards(self.radius_by_g, before.radius_by_g),
        }
    }
}

impl Maugis {
    /// The contact law of a surface's groups.
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

    /// The contact at `theta` for a summit of radius g R: eqs (4)-(6).
    #[inline]
    pub fn at(&self, theta: f64, g: f64) -> Contact {
        self.at_angle(theta, sincos(theta), g)
    }

    /// Whether a contact without adhesion is so small that theta has few digits of the distance from pi/2.
    pub fn is_tip(&self, overlap: f64) -> bool {
        self.overlap_adhesion == 0.0 && overlap <= self.overlap_at_complement(TIP)
    }

    /// Without adhesion, the overlap at pi/2 - `complement`, which is small. It is the same for all radii.
    fn overlap_at_complement(&self, complement: f64) -> f64 {
        let annulus_squared = 2.0 / (PI * self.bracket_2);
        complement * complement * annulus_squared * self.overlap_hertz
    }

    /// The contact where [`Maugis::is_tip`], by its distance from pi/2: a = c sin(pi/2 - theta), where c hardly changes, and
    /// a is Hertz'.
    fn at_tip(&self, overlap: f64, g: f64) -> Contact {
        if overlap <= 0.0 {
            return self.break_away(g);
        }
        let radius = (overlap * g / self.overlap_hertz).sqrt();
        let at = |complement: f64| {
            let (cos, sin) = sincos(complement);
            self.at_angle(FRAC_PI_2 - complement, (sin, cos), g)
        };
        let mut complement = (overlap / self.overlap_at_complement(1.0)).sqrt();
        let mut contact = at(complement);
        for _ in 0..2 {
            complement *= radius / contact.radius;
            contact = at(complement);
        }
        contact
    }

    /// The overlap at which a contact without adhesion has this radius.
    pub fn hertz_overlap(&self, radius: f64, g: f64) -> f64 {
        self.overlap_hertz * radius * radius / g
    }

    /// As [`Maugis::at`], from theta's sine and cosine.
    // Within the loop of Newton's method models of unequal radii are made a tenth faster than by calls of it.
    #[inline(always)]
    fn at_angle(&self, theta: f64, (sin, cos): (f64, f64), g: f64) -> Contact {
        #[cfg(test)]
        tests::EVALUATIONS.set(tests::EVALUATIONS.get() + 1);
        let (bracket_2, bracket_1) = brackets(theta, sin, cos);
        let inv_g = 1.0 / g;
        // Eq (4) as k2 c^2 + k1 c = 1; d(bracket)/dtheta = 2 theta sin 2theta and theta cos theta.
        let factor_2 = self.bracket_2 * inv_g;
        let k2 = factor_2 * bracket_2;
        let k1 = self.bracket_1 * bracket_1;
        let root = (k1 * k1 + 4.0 * k2).sqrt();
        // c = 2/(k1 + root); 2 k2 c + k1 equals the root.
        let c_over_root = 2.0 / ((k1 + root) * root);
        let c = c_over_root * root;
        let c_rate = -c_over_root * (factor_2 * 4.0 * theta * sin * cos * c + self.bracket_1 * theta * cos);
        let c_by_g = c_over_root * k2 * c * inv_g;

        let a = c * cos;
        let a_rate = c_rate * cos - c * sin;
        let a_by_g = c_by_g * cos;
        let hertz = self.overlap_hertz * inv_g;
        let load_hertz = self.load_hertz * inv_g;
        let annulus = sin * cos + theta;
        Contact {
            theta,
            overlap: hertz * a * a - self.overlap_adhesion * sin * c,
            radius: a,
            load: load_hertz * a * a * a - self.load_adhesion * annulus * c * c,
            overlap_rate: 2.0 * hertz * a * a_rate - self.overlap_adhesion * (cos * c + sin * c_rate),
            radius_rate: a_rate,
            load_rate: 3.0 * load_hertz * a * a * a_rate
                - 2.0 * self.load_adhesion * c * (cos * cos * c + annulus * c_rate),
            overlap_by_g: hertz * a * (2.0 * a_by_g - a * inv_g) - self.overlap_adhesion * sin * c_by_g,
            radius_by_g: a_by_g,
        }
    }

    /// Where unloading under displacement control ends: a = 0, or the fold where lambda_g is large.
    pub fn break_away(&self, g: f64) -> Contact {
        if self.lambda_cubed * g <= FOLD_LAMBDA_CUBED {
            return self.at_angle(FRAC_PI_2, (1.0, 0.0), g);
        }
        // du/dtheta < 0 for heavy load; the first zero going up in theta is the fold.
        let rate = |theta: f64| self.at(theta, g).overlap_rate / cos(theta);
        let mut upper = FRAC_PI_2;
        let mut lower = 0.5 * upper;
        while rate(lower) >= 0.0 && lower > 1e-12 {
            upper = lower;
            lower *= 0.5;
        }
        self.at(root::bracketed(rate, lower, upper), g)
    }

    /// The contact on the unloading branch at an overlap of at least that of break-away.
    ///
    /// `guess` is a starting theta; [`Maugis::guess`] makes one from nothing, and in place of one that is no angle.
    pub fn at_overlap(&self, overlap: f64, g: f64, guess: f64) -> Contact {
        if self.is_tip(overlap) {
            return self.at_tip(overlap, g);
        }
        let (mut lower, mut upper) = (0.0, FRAC_PI_2);
        let start = if guess > 0.0 { guess.min(FRAC_PI_2) } else { self.guess(overlap, g) };
        let mut angle = sincos(start);
        let mut contact = self.at_angle(start, angle, g);
        let mut before = contact;
        let mut last_step = None;
        for _ in 0..200 {
            let theta = contact.theta;
            let residual = contact.overlap - overlap;
            // Past the fold the overlap rises again: that is off the branch.
            if contact.overlap_rate >= 0.0 || residual < 0.0 {
                upper = theta;
            } else {
                lower = theta;
            }
            let newton = if contact.overlap_rate < 0.0 { theta - residual / contact.overlap_rate } else { 0.0 };
            // A tiny step may leave the bracket by rounding.
            let trusted = (newton - theta).abs() <= 1e-9 * theta
                || newton > lower.max(0.5 * theta) && newton < upper.min(2.0 * theta);
            let next = if trusted { newton } else { (0.5 * (lower + upper)).max(0.5 * theta).min(2.0 * theta) };
            let step = (next - theta).abs();
            let way = last_step.unwrap_or(theta);
            // Next to pi/2 the radius is proportional to the distance from there.
            let scale = theta.min(FRAC_PI_2 - theta);
            if trusted && step <= FIRST_ORDER_STEP * scale && step * way <= FIRST_ORDER_STEPS * scale * scale {
                return contact.moved(next, overlap, &before);
            }
            before = contact;
            angle = turned(angle, theta, next);
            contact = self.at_angle(next, angle, g);
            if !trusted {
                last_step = None;
                if upper - lower <= 4e-16 * upper {
                    break;
                }
                continue;
            }
            // Two Newton steps tell the size of the next; steps that stop shrinking are rounding.
            let ratio = last_step.map_or(1.0, |last: f64| step / last);
            if step * ratio * ratio <= 1e-16 * next || (ratio >= 0.5 && step <= 1e-11 * next) {
                break;
            }
            last_step = Some(step);
        }
        contact
    }

    /// Without adhesion, smaller overlaps have lost digits: so near to pi/2 theta has no more.
    pub fn least_overlap(&self) -> f64 {
        self.overlap_at_complement(1e-5)
    }

    /// A starting theta for [`Maugis::at_overlap`]: eq (4) for heavy load, with Hertz' radius.
    pub fn guess(&self, overlap: f64, g: f64) -> f64 {
        let hertz_radius_squared = overlap.max(1e-100) / self.overlap_hertz; // over g
        let by_bracket_2 = cbrt(0.75 / (self.bracket_2 * hertz_radius_squared));
        let radius = (hertz_radius_squared * g).sqrt();
        let by_bracket_1 = (2.0 / (self.bracket_1 * radius).max(1e-100)).sqrt();
        by_bracket_2.min(by_bracket_1).min(1.0)
    }
}

/// Sine and cosine of an angle from those of another: if it is near, by the addition theorems.
#[inline]
fn turned((sin, cos): (f64, f64), from: f64, to: f64) -> (f64, f64) {
    let step = to - from;
    if step.abs() > 0.01_f64.min(0.25 * sin.min(cos)) {
        return sincos(to);
    }
    let square = step * step;
    let sin_step = step * (1.0 - square / 6.0 * (1.0 - square / 20.0));
    let cos_step_less_1 = -0.5 * square * (1.0 - square / 12.0 * (1.0 - square / 30.0));
    (sin + (sin * cos_step_less_1 + cos * sin_step), cos + (cos * cos_step_less_1 - sin * sin_step))
}

/// The two brackets of eq (4) times cos^2 and cos: sin theta cos theta - theta cos 2theta and
/// theta sin theta - (1 - cos theta), by their Taylor series where the closed forms cancel.
#[inline]
fn brackets(theta: f64, sin: f64, cos: f64) -> (f64, f64) {
    if theta >= 0.5 {
        let cos_2 = (cos - sin) * (cos + sin);
        return (sin * cos - theta * cos_2, theta * sin - (1.0 - cos));
    }
    let x = theta * theta;
    (even_odd(&SERIES_2, x) * x * theta, even_odd(&SERIES_1, x) * x)
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
const SERIES_2: [f64; SERIES_TERMS] = series_2();
const SERIES_1: [f64; SERIES_TERMS] = series_1();

/// Coefficients of theta^(2k+3): (-1)^k 2^(2k+2) (2k+2)/(2k+3)!.
const fn series_2() -> [f64; SERIES_TERMS] {
    let mut out = [0.0; SERIES_TERMS];
    let mut term = 4.0; // 2^(2k+2) / (2k+1)! with sign
    let mut k = 0;
    while k < SERIES_TERMS {
        out[k] = term / (2 * k + 3) as f64;
        term *= -4.0 / ((2 * k + 2) * (2 * k + 3)) as f64;
        k += 1;
    }
    out
}

/// Coefficients of theta^(2k+2): (-1)^k (2k+1)/(2k+2)!.
const fn series_1() -> [f64; SERIES_TERMS] {
    let mut out = [0.0; SERIES_TERMS];
    let mut term = 1.0; // 1 / (2k)! with sign
    let mut k = 0;
    while k < SERIES_TERMS {
        out[k] = term / (2 * k + 2) as f64;
        term *= -1.0 / ((2 * k + 1) * (2 * k + 2)) as f64;
        k += 1;
    }
    out
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use std::cell::Cell;

    thread_local! {
        /// Evaluations of the contact law.
        pub static EVALUATIONS: Cell<u32> = const { Cell::new(0) };
    }

    /// Without adhesion, with little and with much.
    fn laws() -> [Maugis; 3] {
        [0.0, 1e-4, 0.02].map(|gamma| Maugis::new(&Groups { alpha: 0.01, beta: 1e3, gamma, b_over_h: 0.7 }))
    }

    const FACTORS: [f64; 3] = [0.3, 1.0, 1.8];

    fn near(a: f64, b: f64, tolerance: f64) -> bool {
        (a - b).abs() <= tolerance * b.abs()
    }

    #[test]
    fn brackets_are_one_function_by_series_and_in_closed_form() {
        let closed = |theta: f64| {
            let (sin, cos) = theta.sin_cos();
            (sin * cos - theta * (2.0 * theta).cos(), theta * sin - (1.0 - cos))
        };
        for theta in [0.2, 0.3, 0.49, 0.499_999_999_999, 0.5, 0.6, 1.2, FRAC_PI_2] {
            let (found, expected) = (brackets(theta, theta.sin(), theta.cos()), closed(theta));
            let tolerance = if theta < 0.45 { 1e-12 } else { 2e-14 };
            assert!(near(found.0, expected.0, tolerance), "{theta}: {found:?}, not {expected:?}");
            assert!(near(found.1, expected.1, tolerance), "{theta}: {found:?}, not {expected:?}");
        }
        // 4/3 theta^3 and theta^2/2 at heavy load.
        let (second, first) = brackets(1e-5, 1e-5_f64.sin(), 1e-5_f64.cos());
        assert!(near(second, 4.0 / 3.0 * 1e-15, 1e-9) && near(first, 0.5e-10, 1e-9), "{second:e}, {first:e}");
    }

    #[test]
    fn an_angle_is_turned_to_the_sine_and_cosine_of_another() {
        for from in [1e-3_f64, 0.1, 0.8, 1.57] {
            for step in [1e-12, 1e-5, 2e-4, 0.0099, 0.011, 0.3] {
                for to in [from + step, from - step] {
                    let (found, expected) = (turned(from.sin_cos(), from, to), to.sin_cos());
                    let error = (found.0 - expected.0).abs().max((found.1 - expected.1).abs());
                    assert!(error <= 3e-16, "from {from} to {to}: {error:e}");
                }
            }
        }
        // Next to 0 and pi/2 each keeps its own digits.
        for (from, to) in [(1e-2_f64, 1e-5_f64), (1e-3, 1e-6), (2e-9, 5e-3)] {
            for (from, to) in [(from, to), (FRAC_PI_2 - from, FRAC_PI_2 - to)] {
                let (found, expected) = (turned(from.sin_cos(), from, to), to.sin_cos());
                let is_near = near(found.0, expected.0, 4e-16) && near(found.1, expected.1, 4e-16);
                assert!(is_near, "from {from} to {to}: {found:?}, not {expected:?}");
            }
        }
    }

    #[test]
    fn rates_are_those_of_secants() {
        for law in laws() {
            for g in FACTORS {
                for theta in [0.01, 0.3, 0.7, 1.2, 1.5] {
                    let (step, here) = (1e-5, law.at(theta, g));
                    let (before, after) = (law.at(theta * (1.0 - step), g), law.at(theta * (1.0 + step), g));
                    let by_theta = |of: fn(&Contact) -> f64| (of(&after) - of(&before)) / (2.0 * step * theta);
                    let (less, more) = (law.at(theta, g * (1.0 - step)), law.at(theta, g * (1.0 + step)));
                    let by_g = |of: fn(&Contact) -> f64| (of(&more) - of(&less)) / (2.0 * step * g);
                    // Without adhesion the overlap depends on g by rounding alone.
                    for (rate, secant, least) in [
                        (here.overlap_rate, by_theta(|contact| contact.overlap), 0.0),
                        (here.radius_rate, by_theta(|contact| contact.radius), 0.0),
                        (here.load_rate, by_theta(|contact| contact.load), 0.0),
                        (here.overlap_by_g, by_g(|contact| contact.overlap), 1e-10 * here.overlap.abs() / g),
                        (here.radius_by_g, by_g(|contact| contact.radius), 0.0),
                    ] {
                        let off = (rate - secant).abs();
                        assert!(off <= (1e-7 * rate.abs()).max(least), "{rate:e}, not {secant:e} at {theta}, {g}");
                    }
                }
            }
        }
    }

    /// From starting values near and far, and from one that is the answer to all digits that matter.
    #[test]
    fn a_contact_is_found_by_its_overlap() {
        for law in laws() {
            for g in FACTORS {
                let last = law.break_away(g).theta;
                for part in [1e-9, 1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999] {
                    let expected = law.at(part * last, g);
                    let theta = expected.theta;
                    let cold = law.guess(expected.overlap, g);
                    let no_angles = [9.0, 0.0, -0.3 * theta, f64::NAN];
                    let guesses = [cold, 1e-3 * theta, 0.4 * theta, theta * (1.0 + 1e-4), theta * (1.0 + 1e-9)];
                    for guess in guesses.into_iter().chain(no_angles) {
                        let found = law.at_overlap(expected.overlap, g, guess);
                        // Next to break-away the overlap hardly depends on theta.
                        let known = 1e-15 * expected.overlap.abs().max(law.break_away(g).overlap.abs());
                        let known = 1e-10 + 2e3 * known / (expected.overlap_rate * theta).abs();
                        let change = 1e-10 * expected.overlap.abs() / g;
                        for (found, expected, least) in [
                            (found.theta, theta, 0.0),
                            (found.radius, expected.radius, 0.0),
                            (found.overlap_rate, expected.overlap_rate, 0.0),
                            (found.radius_rate, expected.radius_rate, 0.0),
                            (found.load_rate, expected.load_rate, 0.0),
                            (found.overlap_by_g, expected.overlap_by_g, change),
                            (found.radius_by_g, expected.radius_by_g, 0.0),
                        ] {
                            let off = (found - expected).abs();
                            assert!(
                                off <= (known * expected.abs()).max(least),
                                "{found:e}, not {expected:e}, at {part} of {last} from {guess}"
                            );
                        }
                    }
                }
            }
        }
    }

    /// At heavy load, in the middle of the branch, and next to where the contact breaks; each from starting values that
    /// are far off, as far as those of neighbouring nodes, and next to the answer.
    #[test]
    fn a_contact_takes_few_evaluations() {
        let parts: [&[f64]; 3] = [&[1e-6, 1e-3, 0.02, 0.1], &[0.3, 0.5, 0.7, 0.9], &[0.99, 0.999, 0.999_99]];
        let offs = [[1e-3, 20.0], [0.5, 1.6], [0.95, 1.05], [0.9999, 1.0001], [1.0 - 1e-7, 1.0 + 1e-7]];
        let most = [[1408, 540, 360, 216, 144], [1369, 582, 369, 216, 144], [1499, 894, 774, 405, 136]];
        for (parts, most) in parts.into_iter().zip(most) {
            for (offs, most) in offs.into_iter().zip(most) {
                let mut count = 0;
                for law in laws() {
                    for g in FACTORS {
                        let last = law.break_away(g).theta;
                        for (part, off) in parts.iter().flat_map(|part| offs.map(|off| (part, off))) {
                            let overlap = law.at(part * last, g).overlap;
                            EVALUATIONS.set(0);
                            law.at_overlap(overlap, g, off * part * last);
                            count += EVALUATIONS.get();
                        }
                    }
                }
                assert!(count <= most + 2, "{count} evaluations at {parts:?} from {offs:?}, not {most}");
            }
        }
    }

    /// Where the overlap hardly depends on theta any more.
    #[test]
    fn a_contact_that_is_about_to_break_is_found_as_far_as_rounding_tells() {
        let mut count = 0;
        for gamma in [0.003, 0.01, 0.02, 0.3] {
            let law = Maugis::new(&Groups { alpha: 0.01, beta: 1e3, gamma, b_over_h: 0.7 });
            for g in FACTORS {
                let last = law.break_away(g);
                for part in (3..=12).map(|digits| 1.0 - 0.1_f64.powi(digits)) {
                    let expected = law.at(part * last.theta, g);
                    let known = 2e-16 * last.overlap.abs() / (expected.overlap_rate * expected.theta).abs();
                    for off in [0.1, 0.64, 0.99, 1.0 + 1e-6, 1.4, 9.0] {
                        EVALUATIONS.set(0);
                        let found = law.at_overlap(expected.overlap, g, off * expected.theta).theta;
                        count += EVALUATIONS.get();
                        let error = (found / expected.theta - 1.0).abs();
                        assert!(
                            error < 1e-14 + 60.0 * known.min(1e-8),
                            "{error:e} at {part} from {off}, {gamma}, {g}: {known:e}"
                        );
                    }
                }
            }
        }
        assert!(count < 20_600, "{count} evaluations");
    }

    /// Hertz' contact, and the same on both sides of where theta gets enough digits.
    #[test]
    fn the_smallest_contacts_without_adhesion_keep_their_digits() {
        let [law, adhesive, _] = laws();
        assert!(!adhesive.is_tip(1e-100) && !adhesive.is_tip(-1.0));
        let last = law.at(FRAC_PI_2 - TIP, 1.0).overlap;
        assert!(law.is_tip(0.999 * last) && !law.is_tip(1.001 * last), "{last}");
        for g in FACTORS {
            for overlap in [1e-290, 1e-200, 1e-100, 1e-40, 1e-12 * last, last * (1.0 - 1e-5)] {
                let contact = law.at_overlap(overlap, g, 0.3);
                let radius = (g * overlap).sqrt() * 1e3;
                assert!(near(contact.radius, radius, 2e-15), "{} not {radius} at {overlap:e}", contact.radius);
                assert!(near(contact.overlap, overlap, 4e-15), "{} not {overlap}", contact.overlap);
                assert!(near(contact.load, 4.0 / 3.0 * 1e-5 / g * radius.powi(3), 1e-14) || overlap < 1e-190);
            }
            let (below, above) =
                (law.at_overlap(last * (1.0 - 1e-9), g, 0.3), law.at_overlap(last * (1.0 + 1e-9), g, 0.3));
            assert!(near(above.radius / below.radius, 1.0 + 1e-9, 1e-12), "{} {}", below.radius, above.radius);
            for overlap in [0.0, -0.0, -1e-300, -1e-9] {
                let edge = law.at_overlap(overlap, g, 0.3);
                assert_eq!((edge.theta, edge.radius, edge.load), (FRAC_PI_2, 0.0, 0.0));
            }
        }
    }

    #[test]
    fn a_starting_value_is_of_the_right_size_where_a_contact_is_loaded() {
        for law in laws() {
            for g in FACTORS {
                for overlap in [0.1, 1.0, 10.0, 1e6] {
                    let part = law.guess(overlap, g) / law.at_overlap(overlap, g, 0.1).theta;
                    assert!(part > 0.9 && part < 2.2, "{part} at {overlap}, {g}");
                    assert!(overlap < 1e6 || part < 1.15, "{part} at {overlap}, {g}");
                }
            }
        }
    }

    #[test]
    fn contact_breaks_where_the_overlap_is_least() {
        for law in laws() {
            for g in FACTORS {
                let edge = law.break_away(g);
                assert_eq!(edge.theta == FRAC_PI_2, law.lambda_cubed * g <= FOLD_LAMBDA_CUBED, "{g}");
                let scale = law.at(0.5 * edge.theta, g).overlap_rate.abs();
                assert!(edge.theta == FRAC_PI_2 || edge.overlap_rate.abs() < 1e-10 * scale, "{}", edge.overlap_rate);
                for part in 1..100 {
                    let theta = 0.01 * f64::from(part) * FRAC_PI_2;
                    assert!(law.at(theta, g).overlap >= edge.overlap, "{theta} before {}", edge.theta);
                    assert!(
                        theta >= edge.theta || law.at(theta, g).overlap_rate < 0.0,
                        "{theta} before {}",
                        edge.theta
                    );
                }
            }
        }
        // The fold sets in at pi/2.
        let law = &laws()[2];
        let g = FOLD_LAMBDA_CUBED / law.lambda_cubed;
        assert_eq!(law.break_away(g * (1.0 - 1e-12)).theta, FRAC_PI_2);
        let fold = law.break_away(g * (1.0 + 1e-6)).theta;
        assert!(fold < FRAC_PI_2 && fold > FRAC_PI_2 - 0.01, "{fold}");
    }

    /// Hertz: radius^2 is radius of curvature times overlap.
    #[test]
    fn the_tip_of_a_contact_without_adhesion_is_that_of_hertz() {
        let law = &laws()[0];
        for g in FACTORS {
            let edge = law.at(FRAC_PI_2 - TIP, g);
            for part in [1e-30, 1e-8, 0.1, 1.0] {
                let overlap = part * edge.overlap;
                let contact = law.at_tip(overlap, g);
                let radius = (overlap * g).sqrt() * 1e3;
                assert!(near(contact.radius, radius, 1e-14), "{}, not {radius}", contact.radius);
                assert!(near(contact.overlap, overlap, 1e-13), "{}, not {overlap}", contact.overlap);
                assert!(near(law.hertz_overlap(radius, g), overlap, 1e-14));
            }
            assert!(near(law.least_overlap(), law.at(FRAC_PI_2 - 1e-5, g).overlap, 1e-4));
        }
    }
}
