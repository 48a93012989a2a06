//! Friction force of one contact, F = pi a^2 tau(a) + kappa P_H.
//!
//! The stress tau is eqs (13)-(15), Hurtado and Kim's three regimes: below the first radius an asperity slips as a whole at a
//! constant stress, above the second by gliding dislocations at a lower one; between them the stress is a power of the radius.
//! The part of the strength that grows with pressure is added (Briscoe and Evans, Proc. R. Soc. A 380 (1982) 389): kappa
//! times the load of Hertz' contact of the same radius, which is the load and what adhesion adds to it.

use super::contact::{Contact, Rates};
use crate::numerics::elementary::{exp, log};
use std::f64::consts::PI;

/// The constants of eq (13): contact radii over b, shear stresses over G*.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SlipConstants {
    /// a_1 / b, the largest radius of concurrent slip.
    pub radius_1: f64,
    /// tau_1 / G*.
    pub stress_1: f64,
    /// a_2 / b, the smallest radius of dislocation-assisted slip at constant stress.
    pub radius_2: f64,
    /// tau_2 / G*.
    pub stress_2: f64,
}

impl Default for SlipConstants {
    /// Hurtado and Kim, Proc. R. Soc. A 455 (1999) 3363-3400: (28, 1/43) and (8e4, 1/1290).
    fn default() -> Self {
        Self { radius_1: 28.0, stress_1: 1.0 / 43.0, radius_2: 8e4, stress_2: 1.0 / 1290.0 }
    }
}

/// How a contact begins to slip.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum SlipOnset {
    /// From its rim inwards (Cattaneo 1938; R. D. Mindlin, J. Appl. Mech. 16 (1949) 259).
    #[default]
    Partial,
    /// As a whole.
    Whole,
}

/// What a contact resists before all of it slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tangential {
    pub force: f64,
    /// Its slope by displacement over that of a contact that sticks.
    pub sticking: f64,
}

impl SlipOnset {
    /// The force of a contact of this strength at a displacement, given by the force that it would have if it stuck.
    #[inline]
    pub fn tangential(self, strength: f64, stuck: f64) -> Tangential {
        let slipped = Tangential { force: strength, sticking: 0.0 };
        match self {
            Self::Whole if stuck < strength => Tangential { force: stuck, sticking: 1.0 },
            Self::Partial if stuck < Self::PARTIAL_REACH * strength => {
                // F (1 - y^3), without cancellation where the displacement is small.
                let y = (1.0 - stuck / (Self::PARTIAL_REACH * strength)).sqrt();
                Tangential { force: stuck / Self::PARTIAL_REACH * (1.0 + y + y * y) / (1.0 + y), sticking: y }
            }
            _ => slipped,
        }
    }

    /// Up to how many times its strength a contact would resist, if it stuck, before all of it slips.
    pub fn reach(self) -> f64 {
        match self {
            Self::Partial => Self::PARTIAL_REACH,
            Self::Whole => 1.0,
        }
    }

    const PARTIAL_REACH: f64 = 1.5;
}

/// Friction force of one asperity, in G* b^2.
#[derive(Debug, Clone)]
pub struct Slip {
    /// How a contact begins to slip.
    pub onset: SlipOnset,
    constants: SlipConstants,
    /// M of eq (14).
    exponent: f64,
    /// kappa E*/G*: friction in G* b^2 of a Hertz load in E* b^2.
    by_hertz_load: f64,
}

/// The friction force of a contact, in G* b^2, with its partial derivatives.
#[derive(Debug, Clone, Copy)]
pub struct Friction {
    /// The force.
    pub force: f64,
    /// Its derivative by the contact radius.
    pub by_radius: f64,
    /// Its derivative by the load of Hertz' contact of that radius.
    pub by_hertz_load: f64,
}

impl Friction {
    /// The rate of the force where contacts change at these rates.
    #[inline]
    pub fn rate(&self, rates: &Rates) -> f64 {
        self.by_radius * rates.radius + self.by_hertz_load * rates.hertz_load
    }
}

impl Slip {
    /// The law with these constants, and kappa E*/G*.
    pub fn new(constants: SlipConstants, by_hertz_load: f64, onset: SlipOnset) -> Self {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = constants;
        // Stresses of 0 go together: without a stress there is no power of the radius either.
        let exponent = if stress_1 > 0.0 { -log(stress_1 / stress_2) / log(radius_2 / radius_1) } else { 0.0 };
        Self { onset, constants, exponent, by_hertz_load }
    }

    /// The two radii at which the stress has a kink.
    pub fn kinks(&self) -> [f64; 2] {
        [self.constants.radius_1, self.constants.radius_2]
    }

    /// Whether the strength depends on the contact radius alone.
    pub fn is_of_radius(&self) -> bool {
        self.by_hertz_load == 0.0
    }

    /// The contact radii at which pi a^2 tau is this times the radius, one in each regime, infinite where there is none.
    pub fn radii_at_force_over_radius(&self, ratio: f64) -> [f64; 3] {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.constants;
        let (below, above) = (ratio / (PI * stress_1), ratio / (PI * stress_2));
        // F/a = pi a_1 tau_1 (a/a_1)^(1 + M)
        let between = radius_1 * exp(log(below / radius_1) / (1.0 + self.exponent));
        let within =
            |radius: f64, from: f64, to: f64| if radius > from && radius < to { radius } else { f64::INFINITY };
        [within(below, 0.0, radius_1), within(between, radius_1, radius_2), within(above, radius_2, f64::INFINITY)]
    }

    /// The friction force of a contact.
    #[inline]
    pub fn friction(&self, contact: &Contact) -> Friction {
        let (force, by_radius) = self.stress_force(contact.radius);
        let by_hertz_load = self.by_hertz_load;
        Friction { force: force + by_hertz_load * contact.hertz_load, by_radius, by_hertz_load }
    }

    /// kappa E*/G*.
    pub fn by_hertz_load(&self) -> f64 {
        self.by_hertz_load
    }

    /// The power of the radius that the stress of contacts of this mean radius goes with, and its slope by the logarithm of the radius:
    /// radii scatter, so that it changes smoothly from one regime to the next.
    pub fn power_of_mean(&self, radius: f64) -> (f64, f64) {
        let [below, above] =
            [self.constants.radius_1 / radius, radius / self.constants.radius_2].map(|ratio| ratio * ratio);
        let power = self.exponent / (1.0 + below) / (1.0 + above);
        (power, 2.0 * power * (below / (1.0 + below) - above / (1.0 + above)))
    }

    /// The shear stress tau over G* at contact radius `a` > 0.
    pub fn stress(&self, a: f64) -> f64 {
        self.stress_force(a).0 / (PI * a * a)
    }

    /// pi a^2 tau at contact radius `a`, and its derivative.
    #[inline]
    fn stress_force(&self, a: f64) -> (f64, f64) {
        let SlipConstants { radius_1, stress_1, radius_2, stress_2 } = self.constants;
        let (stress, power) = if a <= radius_1 {
            (stress_1, 2.0)
        } else if a < radius_2 {
            (stress_1 * exp(self.exponent * log(a / radius_1)), 2.0 + self.exponent)
        } else {
            (stress_2, 2.0)
        };
        let force_over_a = PI * a * stress;
        (force_over_a * a, power * force_over_a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where strength grows with radius faster than stiffness, and where between the two radii it does not.
    #[test]
    fn contacts_whose_force_is_a_given_one_over_the_radius_are_found_in_each_regime() {
        let falling = SlipConstants { radius_1: 10.0, stress_1: 0.1, radius_2: 100.0, stress_2: 0.002 };
        for (constants, ratio, number) in [
            (SlipConstants::default(), 1.0, 1),
            (SlipConstants::default(), 20.0, 1),
            (SlipConstants::default(), 300.0, 1),
            (falling, 0.5, 1),
            (falling, 1.0, 3),
            (falling, 5.0, 1),
        ] {
            let slip = Slip::new(constants, 0.0, SlipOnset::Partial);
            let radii = slip.radii_at_force_over_radius(ratio);
            let found = radii.into_iter().filter(|radius| radius.is_finite());
            assert_eq!(found.clone().count(), number, "{constants:?}, {ratio}: {radii:?}");
            for radius in found {
                let force = slip.friction(&Contact { radius, ..Contact::default() }).force;
                assert!((force / radius / ratio - 1.0).abs() < 1e-13, "{constants:?}, {ratio}: {radii:?}");
            }
        }
    }
}
