//! Load against separation: what hosts ask that know the gap of a contact and not its load.
//!
//! Inside, the argument is minus the separation, with which the load rises as friction does with load: one table serves both.

use super::Model;
use crate::error::Error;
use crate::float_bits::{finite, nan};
use crate::law::Table;

impl Model {
    /// The load at a separation on the branch of load control; 0 where the surfaces are apart: from pull-off's separation on, or
    /// where the load has decayed to nothing. NaN for a separation that is not finite or below -1e50 `height_std`.
    pub fn load_at_separation(&self, separation: f64) -> f64 {
        self.load_and_slope_at(separation).0
    }

    /// That load, and its slope by separation, <= 0.
    pub fn load_and_slope_at(&self, separation: f64) -> (f64, f64) {
        let answer = self.tabulated_load(-separation).or_else(|| self.known_load(-separation));
        let (load, slope) = answer.unwrap_or_else(|| self.continued_load(-separation));
        (load, by_separation(slope))
    }

    /// Load and slope at minus the separation, where the compiled law answers.
    #[inline]
    pub(crate) fn tabulated_load(&self, approach: f64) -> Option<(f64, f64)> {
        // Tested by bits, as loads are.
        if !finite(approach) {
            return None;
        }
        self.law.gap().table().at_load(approach)
    }

    /// The same where they are known without a computation.
    #[inline]
    pub(crate) fn known_load(&self, approach: f64) -> Option<(f64, f64)> {
        if !finite(approach) || approach > self.deepest_compression() {
            return Some((f64::NAN, f64::NAN));
        }
        self.law.gap().is_open(-approach).then_some((0.0, 0.0))
    }

    /// The same where the surfaces are not apart and the table does not answer.
    pub(crate) fn continued_load(&self, approach: f64) -> (f64, f64) {
        self.law.gap().beyond(-approach)
    }

    /// Whether finding that raises no floating-point exception but "inexact".
    pub(crate) fn load_continues_moderately(&self, approach: f64) -> bool {
        self.law.gap().is_moderate_beyond(-approach)
    }

    /// The table of loads by minus the separation.
    #[inline]
    pub(crate) fn load_table(&self) -> &Table {
        self.law.gap().table()
    }

    /// The error of an admissible separation at which there is no load.
    pub(crate) fn no_load_at(separation: f64) -> Error {
        let allowed = "the load at this separation is no number, or cannot be found; please report the parameters";
        Error::out_of_range("separation", separation, allowed)
    }

    /// Whether the surfaces touch or attract at a separation.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] if it is not finite, [`Error::OutOfRange`] below -1e50 `height_std`, [`Error::Open`] where
    /// the surfaces are apart.
    pub fn validate_separation(&self, separation: f64) -> Result<(), Error> {
        if finite(separation) && self.law.gap().is_open(separation) {
            return Err(Error::Open { separation, end: self.law.gap().end() });
        }
        self.dimensionless("separation", separation).map(|_| ())
    }
}

/// The slope by separation from that by minus the separation, which rounding may have made negative at pull-off itself.
pub fn by_separation(slope: f64) -> f64 {
    if slope.is_sign_negative() && !nan(slope) {
        0.0
    } else {
        0.0 - slope
    }
}
