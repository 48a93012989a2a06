//! The sums at one separation, and what one summit adds to them.

use crate::asperity::contact::Contact;
use crate::asperity::slip::Friction;
use crate::error::Error;
use std::f64::consts::PI;

/// The sums at one separation, per summit of the surface.
#[derive(Debug, Clone, Copy, Default)]
pub struct Sums {
    /// Load of the summits in contact, in E* b^2.
    pub load_contacting: f64,
    /// Load of the summits that attract without contact, <= 0.
    pub load_attracted: f64,
    /// Friction force, in G* b^2.
    pub friction: f64,
    /// Load of Hertz' contacts of the same radii, in E* b^2: the load and what adhesion adds to it.
    pub hertz_load: f64,
    /// Real area of contact, in b^2.
    pub area: f64,
    /// Contact radius, in b.
    pub radius: f64,
    /// Fraction of summits in contact.
    pub contacting: f64,
    /// Fraction of summits that attract without contact.
    pub attracted: f64,
    /// d(load)/d(separation).
    pub load_slope: f64,
    /// d(friction)/d(separation).
    pub friction_slope: f64,
    /// d(load of Hertz' contacts)/d(separation).
    pub hertz_load_slope: f64,
    /// d(contact radius)/d(separation).
    pub radius_slope: f64,
    /// d(real area)/d(separation).
    pub area_slope: f64,
    /// 1 - psi of `crowding`, and its slope by separation; 0 where the nominal area is not known.
    pub crowding: (f64, f64),
    /// What part of their friction contacts have lost since they have merged.
    pub lost_to_merging: f64,
    /// What part of the approach of the summits the mean planes do not follow, since neighbours press the surface down between.
    pub given_way: f64,
}

impl Sums {
    /// The load of all summits.
    pub fn load(&self) -> f64 {
        self.load_contacting + self.load_attracted
    }

    /// What the mean planes approach by where summits do by 1.
    pub fn approach_of_planes(&self) -> f64 {
        1.0 - self.given_way
    }

    /// psi: the part of its elastic compliance that a contact has among its neighbours.
    pub fn psi(&self) -> f64 {
        1.0 - self.crowding.0
    }

    /// The contact radius over psi, to which stiffness and conductance are proportional, and its slope by separation.
    pub fn spread_radius(&self) -> (f64, f64) {
        let spread = self.radius / self.psi();
        (spread, (self.radius_slope + spread * self.crowding.1) / self.psi())
    }

    /// The sums at this separation if they are to be had.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn known(self, separation: f64) -> Result<Self, Error> {
        if self.load().is_nan() {
            Err(out_of_panels(separation))
        } else {
            Ok(self)
        }
    }

    /// The sums of so many times as many contacts.
    pub fn scaled(self, factor: f64) -> Self {
        let mut scaled = Self {
            crowding: self.crowding,
            given_way: self.given_way,
            lost_to_merging: self.lost_to_merging,
            ..Self::default()
        };
        scaled.add(&self, factor, 1.0);
        scaled
    }

    /// Adds the sums of a part of the surface, of which the separation changes by so many times as much.
    pub fn add(&mut self, other: &Self, part: f64, rate: f64) {
        for (sum, more) in [
            (&mut self.load_contacting, other.load_contacting),
            (&mut self.load_attracted, other.load_attracted),
            (&mut self.friction, other.friction),
            (&mut self.hertz_load, other.hertz_load),
            (&mut self.area, other.area),
            (&mut self.radius, other.radius),
            (&mut self.contacting, other.contacting),
            (&mut self.attracted, other.attracted),
            (&mut self.load_slope, rate * other.load_slope),
            (&mut self.friction_slope, rate * other.friction_slope),
            (&mut self.hertz_load_slope, rate * other.hertz_load_slope),
            (&mut self.radius_slope, rate * other.radius_slope),
            (&mut self.area_slope, rate * other.area_slope),
        ] {
            *sum += part * more;
        }
    }

    /// Makes the contact radius over psi this, with its slope.
    pub fn spread_over(&mut self, (spread, slope): (f64, f64)) {
        if spread > 0.0 {
            let psi = self.radius / spread;
            self.crowding = (1.0 - psi, (psi * slope - self.radius_slope) / spread);
        }
    }

    /// What sums are that ran out of panels.
    pub(super) fn unknown() -> Self {
        Self { load_contacting: f64::NAN, ..Self::default() }
    }

    /// Adds one contacting summit, `weight` times.
    #[inline]
    pub(super) fn add_contact(&mut self, weight: f64, summit: &Summit) {
        self.contacting += weight;
        self.load_contacting += weight * summit.load;
        self.friction += weight * summit.friction;
        self.hertz_load += weight * summit.hertz_load;
        self.radius += weight * summit.radius;
        self.area += weight * (PI * summit.radius * summit.radius);
        self.load_slope -= weight * summit.load_by_overlap;
        self.friction_slope -= weight * summit.friction_by_overlap;
        self.hertz_load_slope -= weight * summit.hertz_load_by_overlap;
        self.radius_slope -= weight * summit.radius_by_overlap;
        self.area_slope -= weight * (2.0 * PI * summit.radius * summit.radius_by_overlap);
    }

    /// Adds one attracted summit, `weight` times.
    #[inline]
    pub(super) fn add_attraction(&mut self, weight: f64, load: f64, load_by_overlap: f64) {
        self.attracted += weight;
        self.load_attracted += weight * load;
        self.load_slope -= weight * load_by_overlap;
    }
}

/// Why there are no sums at a separation.
pub(super) fn out_of_panels(separation: f64) -> Error {
    Error::NotConverged { what: "sums over the asperities at separation / height_std", value: separation }
}

/// What one contact contributes.
#[derive(Debug, Clone, Copy, Default)]
pub struct Summit {
    pub overlap: f64,
    pub radius: f64,
    pub load: f64,
    pub friction: f64,
    pub hertz_load: f64,
    pub load_by_overlap: f64,
    pub friction_by_overlap: f64,
    pub hertz_load_by_overlap: f64,
    pub radius_by_overlap: f64,
}

impl Summit {
    /// What the sums take of a contact and its friction force.
    #[inline]
    pub fn new(contact: &Contact, friction: Friction) -> Self {
        let by_approach = contact.by_approach();
        Self {
            overlap: contact.overlap,
            radius: contact.radius,
            load: contact.load,
            friction: friction.force,
            hertz_load: contact.hertz_load,
            load_by_overlap: by_approach.load,
            friction_by_overlap: friction.rate(&by_approach),
            hertz_load_by_overlap: by_approach.hertz_load,
            radius_by_overlap: by_approach.radius,
        }
    }
}
