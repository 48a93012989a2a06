//! Load against the gap between mean planes: what hosts ask that know the gap of a contact and not its load.
//!
//! Inside, the argument is minus the gap, with which the load rises as friction does with load: one table serves both.

use super::Model;
use crate::error::Error;
use crate::law::{Beyond, Table};
use crate::numerics::float_bits::{finite, finite_up_to, nan, tame};

impl Model {
    /// The load at a gap on the branch of load control; 0 where the surfaces are apart: from pull-off's gap on, or
    /// where the load has decayed to nothing. NaN for a gap that is not finite or below -1e50 `height_std`.
    pub fn load_at_gap(&self, gap: f64) -> f64 {
        self.load_and_slope_at_gap(gap).0
    }

    /// That load, and its slope by gap, <= 0.
    pub fn load_and_slope_at_gap(&self, gap: f64) -> (f64, f64) {
        let answer = self.tabulated_load(-gap).or_else(|| self.known_load(-gap));
        let (load, slope) = answer.unwrap_or_else(|| self.load_beyond().at(-gap));
        (load, by_gap(slope))
    }

    /// Load and slope at minus the gap, where the compiled law answers.
    #[inline]
    pub(crate) fn tabulated_load(&self, approach: f64) -> Option<(f64, f64)> {
        // Tested by bits, as loads are.
        if !tame(approach) {
            return None;
        }
        self.law.gap().table().at_load(approach)
    }

    /// The same where they are known without a computation.
    #[inline(always)]
    pub(crate) fn known_load(&self, approach: f64) -> Option<(f64, f64)> {
        if !finite_up_to(approach, self.deepest_compression()) {
            return Some((f64::NAN, f64::NAN));
        }
        self.law.gap().is_open(-approach).then_some((0.0, 0.0))
    }

    /// What answers where the surfaces are not apart and the table does not.
    #[inline]
    pub(crate) fn load_beyond(&self) -> &Beyond {
        self.law.gap().beyond()
    }

    /// The least of minus the gap less the table's origin at which the surfaces are not apart.
    #[cfg(target_arch = "x86_64")]
    pub(crate) fn least_approach(&self) -> f64 {
        self.law.gap().least()
    }

    /// The table of loads by minus the gap.
    #[inline]
    pub(crate) fn load_table(&self) -> &Table {
        self.law.gap().table()
    }

    /// The error of an admissible gap at which there is no load.
    pub(crate) fn no_load_at(gap: f64) -> Error {
        let allowed = "the load at this gap is no number, or cannot be found; please report the parameters";
        Error::out_of_range("gap", gap, allowed)
    }

    /// Whether the surfaces touch or attract at a gap.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] if it is not finite, [`Error::OutOfRange`] below -1e50 `height_std`, [`Error::Open`] where
    /// the surfaces are apart.
    pub fn validate_gap(&self, gap: f64) -> Result<(), Error> {
        if finite(gap) && self.law.gap().is_open(gap) {
            return Err(Error::Open { gap, end: self.law.gap().end() });
        }
        self.validate_length("gap", gap)
    }
}

/// The slope by gap from that by minus the gap, which rounding may have made negative at pull-off itself.
pub fn by_gap(slope: f64) -> f64 {
    if slope.is_sign_negative() && !nan(slope) {
        0.0
    } else {
        0.0 - slope
    }
}
