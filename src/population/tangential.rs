//! Friction before gross slip: the tangential force of the contacts at a displacement.
//!
//! A contact sticks with the stiffness 8 G^ a (Mindlin), then slips, in part or as a whole (`asperity::slip`), until its force is
//! its strength, the friction force of a contact that slips. Small contacts slip first.

use super::sums::{out_of_panels, Summit};
use super::walk::Visitor;
use super::{Population, RADII};
use crate::asperity::contact::KINKS;
use crate::asperity::slip::{SlipOnset, Tangential};
use crate::error::Error;
use std::borrow::Cow;

/// Less than this part of all contacts is none, where four digits are wanted.
const NEGLIGIBLE_CONTACTS: f64 = 1e-8;

/// The tangential force of the contacts, and what it is made of, per summit of the surface.
#[derive(Debug, Clone, Copy, Default)]
pub struct Microslip {
    /// In G* b^2.
    pub force: f64,
    /// Sum of the radii of the contacts, in b, each as far as it sticks: what the stiffness is proportional to.
    pub sticking: f64,
    /// Sum of the radii of all contacts, in b.
    pub radius: f64,
}

/// Adds up the forces at one displacement.
struct Displaced {
    /// Force over contact radius of a contact that sticks, in G* b.
    force_over_radius: f64,
    onset: SlipOnset,
    sums: Microslip,
}

impl Visitor for Displaced {
    fn summits(&mut self, _z: f64, fraction: f64, summit: &Summit) {
        let Tangential { force, sticking } =
            self.onset.tangential(summit.friction, self.force_over_radius * summit.radius);
        self.sums.radius += fraction * summit.radius;
        self.sums.force += fraction * force;
        self.sums.sticking += fraction * (summit.radius * sticking);
    }
}

/// By how much less than contacts that stick the contacts resist at several displacements, and the radii that they have given up.
struct Lost<const N: usize> {
    /// Force over contact radius of a contact that sticks, in G* b.
    force_over_radius: [f64; N],
    force: [f64; N],
    radius: [f64; N],
    strength: f64,
    all: f64,
    onset: SlipOnset,
}

impl<const N: usize> Visitor for Lost<N> {
    fn summits(&mut self, _z: f64, fraction: f64, summit: &Summit) {
        let (strength, radius) = (fraction * summit.friction, fraction * summit.radius);
        self.strength += strength;
        self.all += radius;
        if strength < NEGLIGIBLE_CONTACTS * self.strength && radius < NEGLIGIBLE_CONTACTS * self.all {
            return;
        }
        let reach = self.onset.reach() * strength;
        let per_reach = 1.0 / reach;
        // Without calls and branches, so that several are worked out side by side.
        match self.onset {
            // From the rim: 3/2 F y - F (1 - (1 - y)^(3/2)), without cancellation where y is small.
            SlipOnset::Partial => {
                for i in 0..N {
                    let stuck = self.force_over_radius[i] * radius;
                    let (y, slipping) = if stuck < reach { (stuck * per_reach, 0.0) } else { (1.0, stuck - reach) };
                    let root = (1.0 - y).sqrt();
                    let gone = y / (1.0 + root);
                    self.force[i] += strength * (gone * gone * (0.5 + root)) + slipping;
                    self.radius[i] += radius * gone;
                }
            }
            SlipOnset::Whole => {
                for i in 0..N {
                    let stuck = self.force_over_radius[i] * radius;
                    let (force, gone) = if stuck < reach { (0.0, 0.0) } else { (stuck - reach, radius) };
                    self.force[i] += force;
                    self.radius[i] += gone;
                }
            }
        }
    }
}

impl Population {
    /// The contacts at a separation, displaced so far that one that sticks bears these forces times its radius: what they would
    /// resist if all stuck, over their strength; how much less they resist; and what part of their stiffness has been given up.
    /// They have some four digits, since panels do not end where contacts begin to slip, or where radii vary at other kinks. `None` if there are none, or their sums are
    /// not to be had.
    pub fn lost_to_slip<const N: usize>(&self, separation: f64, force_over_radius: [f64; N]) -> Option<[[f64; 3]; N]> {
        let onset = self.slip.onset;
        let none = [0.0; N];
        let mut lost = Lost { force_over_radius, force: none, radius: none, strength: 0.0, all: 0.0, onset };
        let mut population = self.as_at(separation);
        if !self.radius.is_constant() {
            let none = f64::INFINITY;
            population = Cow::Owned(population.with_kinks([none; RADII], [none; KINKS]));
        }
        population.visit(separation, &population.edge(separation), &mut lost).ok()?;
        let Lost { force, radius, strength, all, .. } = lost;
        let of = |i: usize| [force_over_radius[i] * all / strength, force[i] / strength, radius[i] / all];
        (strength > 0.0).then(|| std::array::from_fn(of))
    }

    /// The contacts at a separation, displaced so far that one that sticks bears this force times its radius.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if that takes more panels than there may be.
    pub fn microslip(&self, separation: f64, force_over_radius: f64) -> Result<Microslip, Error> {
        let [first, second] = self.slip.kinks();
        let onset = self.slip.onset;
        // Contacts of this strength over radius are about to slip as a whole.
        let strength_over_radius = force_over_radius / onset.reach();
        let population = if self.slip.is_of_radius() {
            let [a, b, c] = self.slip.radii_at_force_over_radius(strength_over_radius);
            self.as_at(separation).with_kinks([first, second, a, b, c], self.kinks_of_contact)
        } else {
            self.as_at(separation).without_tables()
        };
        let population = Self { onset_ratio: Some(strength_over_radius), ..population };
        let mut displaced = Displaced { force_over_radius, onset, sums: Microslip::default() };
        population.visit(separation, &population.edge(separation), &mut displaced)?;
        if displaced.sums.force.is_nan() {
            return Err(out_of_panels(separation));
        }
        Ok(displaced.sums)
    }
}
