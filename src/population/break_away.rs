//! The height at which summits just break away at a separation.
//!
//! A summit of height z is in contact at separation d where z - u_break(g(z)) > d. The left side must rise with height, so
//! that all summits above one height are in contact: a surface whose taller summits part first is refused.

use super::radius::RadiusProfile;
use super::Point;
use crate::asperity::contact::ContactLaw;
use crate::error::Error;
use crate::numerics::root;

/// d(z - u_break)/dz must be no less than this: next to 0 the number of contacts jumps with the separation.
pub const LEAST_RATE: f64 = 0.02;

/// Summits break away at this height.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// The summit there.
    pub point: Point,
    /// d(z - u_break)/dz.
    pub rate: f64,
}

impl Edge {
    /// The edge at a height, at whatever separation it is one.
    pub fn at(law: &dyn ContactLaw, radius: &RadiusProfile, z: f64) -> Self {
        let (g, g_rate) = radius.at(z);
        let contact = law.break_away(g);
        // At break-away du/ds = 0, so that du_break/dg is the partial derivative.
        Self { point: Point { z, g_rate, contact }, rate: 1.0 - contact.by_g.overlap * g_rate }
    }

    /// The edge at a separation, where no summit holds on to a smaller overlap than `deepest`.
    pub fn at_separation(law: &dyn ContactLaw, radius: &RadiusProfile, separation: f64, deepest: f64) -> Self {
        if deepest == 0.0 || radius.is_constant() {
            return Self::at(law, radius, separation + deepest);
        }
        let residual = |z: f64| (z - separation) - law.break_away(radius.factor(z)).overlap;
        // An edge lies between d + deepest and d, rounding apart.
        let slack = 1e-9 * (1.0 + separation.abs());
        Self::at(law, radius, root::bracketed(residual, separation + deepest - slack, separation + slack))
    }

    /// The edge at a separation where summits that have yielded part at overlaps above 0; at the highest if nothing touches.
    pub fn of_unloading(law: &dyn ContactLaw, radius: &RadiusProfile, separation: f64, highest: f64) -> Self {
        if radius.is_constant() {
            return Self::at(law, radius, separation + law.break_away(1.0).overlap);
        }
        let residual = |z: f64| (z - separation) - law.break_away(radius.factor(z)).overlap;
        Self::at(law, radius, root::beyond(residual, separation, 0.125, highest.max(separation)))
    }
}

/// The smallest overlap at which any summit between two heights holds on.
///
/// # Errors
/// [`Error::OutOfRange`] if a taller summit parts before a lower one.
pub fn deepest(law: &dyn ContactLaw, radius: &RadiusProfile, lowest: f64, highest: f64) -> Result<f64, Error> {
    let mut deepest = law.break_away(radius.factor(lowest)).overlap.min(law.break_away(radius.factor(highest)).overlap);
    if radius.is_constant() {
        return Ok(deepest);
    }
    for z in radius.looks(lowest, highest) {
        let edge = Edge::at(law, radius, z);
        if edge.rate < LEAST_RATE {
            if let Some(scores) = &radius.scores {
                let allowed = "must not be in a table with this work_of_adhesion: radii fall so steeply there that taller asperities \
                              would part before lower ones; set work_of_adhesion = 0, with which any table is evaluated, or give \
                              a table that is smoother";
                return Err(Error::out_of_range("score", scores.score(z)[0], allowed));
            }
            let allowed = "must be smaller with this radius_amplitude and work_of_adhesion: radii fall so steeply with height \
                          that taller summits would part before lower ones; use a smaller radius_amplitude or radius_rate: 0 for \
                          surfaces so smooth that adhesion outreaches their roughness, which stick all over";
            return Err(Error::out_of_range("radius_rate", radius.rate, allowed));
        }
        deepest = deepest.min(edge.point.contact.overlap);
    }
    // Between the heights looked at it is hardly deeper.
    Ok(1.01 * deepest)
}
