//! The sums at one separation, and what one summit adds to them.

use crate::elementary::exp;
use crate::error::Error;

/// The sums at one separation, all to be multiplied by exp(`log_scale`).
#[derive(Debug, Clone, Copy, Default)]
pub struct Sums {
    /// Keeps sums of a nearly empty tail from underflowing.
    pub log_scale: f64,
    /// Load of the summits in contact.
    pub load_contacting: f64,
    /// Load of the summits that attract without contact, <= 0.
    pub load_attracted: f64,
    /// Friction force.
    pub friction: f64,
    /// Real area of contact.
    pub area: f64,
    /// Fraction of summits in contact.
    pub contacting: f64,
    /// Fraction of summits that attract without contact.
    pub attracted: f64,
    /// d(load)/d(separation).
    pub load_slope: f64,
    /// d(friction)/d(separation).
    pub friction_slope: f64,
}

impl Sums {
    /// The load of all summits.
    pub fn load(&self) -> f64 {
        self.load_contacting + self.load_attracted
    }

    /// The sums themselves: `log_scale` 0.
    pub fn unscaled(&self) -> Self {
        // In two steps, since what is at the end of all numbers has few digits.
        let root = exp(0.5 * self.log_scale);
        let unscaled = |sum: f64| root * (root * sum);
        Self {
            log_scale: 0.0,
            load_contacting: unscaled(self.load_contacting),
            load_attracted: unscaled(self.load_attracted),
            friction: unscaled(self.friction),
            area: unscaled(self.area),
            contacting: unscaled(self.contacting),
            attracted: unscaled(self.attracted),
            load_slope: unscaled(self.load_slope),
            friction_slope: unscaled(self.friction_slope),
        }
    }

    /// What sums are that ran out of panels.
    pub(super) fn unknown() -> Self {
        let unknown = f64::NAN;
        Self {
            load_contacting: unknown,
            load_attracted: unknown,
            load_slope: unknown,
            friction: unknown,
            ..Self::default()
        }
    }

    /// Whether the sums are to be had: not where they took more panels than there may be.
    pub fn are_known(&self) -> bool {
        !self.load().is_nan()
    }

    /// The sums at this separation if they are to be had.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn known(self, separation: f64) -> Result<Self, Error> {
        if self.are_known() {
            Ok(self)
        } else {
            Err(out_of_panels(separation))
        }
    }

    /// Adds one contacting summit, `weight` times.
    #[inline]
    pub(super) fn add_contact(&mut self, weight: f64, summit: &Summit) {
        self.contacting += weight;
        self.load_contacting += weight * summit.load;
        self.friction += weight * summit.friction;
        self.area += weight * summit.area;
        self.load_slope -= weight * summit.load_by_overlap;
        self.friction_slope -= weight * summit.friction_by_overlap;
    }

    /// Adds one attracted summit, `weight` times.
    #[inline]
    pub(super) fn add_attraction(&mut self, weight: f64, summit: &Summit) {
        self.attracted += weight;
        self.load_attracted += weight * summit.load;
        self.load_slope -= weight * summit.load_by_overlap;
    }
}

/// Why there are no sums at a separation.
pub fn out_of_panels(separation: f64) -> Error {
    Error::NotConverged { what: "sums over the summits at separation / height_std", value: separation }
}

/// What one summit contributes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Summit {
    pub load: f64,
    pub friction: f64,
    pub area: f64,
    pub load_by_overlap: f64,
    pub friction_by_overlap: f64,
}
