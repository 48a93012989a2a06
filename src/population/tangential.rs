//! Friction before gross slip: the tangential force of the contacts at a displacement.
//!
//! A contact sticks with the stiffness 8 G^ a (Mindlin), then slips, in part or as a whole (`asperity::slip`), until its force is
//! its strength, the friction force of a contact that slips. Small contacts slip first.

use super::sums::{out_of_panels, Summit};
use super::walk::Visitor;
use super::Population;
use crate::asperity::slip::{SlipOnset, Tangential};
use crate::error::Error;

/// Less than this part of all contacts is none, where four digits are wanted.
const NEGLIGIBLE: f64 = 1e-8;

/// The tangential force of the contacts, and what it is made of, per summit of the surface.
#[derive(Debug, Clone, Copy, Default)]
pub struct Microslip {
    /// In G* b^2.
    pub force: f64,
    /// Sum of the radii of the contacts, in b, each as far as it sticks: what the stiffness is proportional to.
    pub sticking: f64,
    /// Of all contacts.
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
        if strength < NEGLIGIBLE * self.strength && radius < NEGLIGIBLE * self.all {
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
    /// To some four digits, since panels do not end where contacts begin to slip. `None` if there are none, or their sums are
    /// not to be had.
    pub fn lost_to_slip<const N: usize>(&self, separation: f64, force_over_radius: [f64; N]) -> Option<[[f64; 3]; N]> {
        let onset = self.slip.onset;
        let none = [0.0; N];
        let mut lost = Lost { force_over_radius, force: none, radius: none, strength: 0.0, all: 0.0, onset };
        self.visit(separation, &self.edge(separation), &mut lost).ok()?;
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
            self.with_kinks([first, second, a, b, c], self.kinks_of_contact)
        } else {
            self.without_tables()
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

#[cfg(test)]
mod tests {
    use super::super::sums::Sums;
    use super::super::tests::{of, surface, WEAK};
    use super::super::Population;
    use crate::asperity::slip::SlipOnset;
    use crate::params::{HeightFamily, Params};

    /// With friction of all regimes of the slip law, or in proportion to Hertz' load besides.
    fn surfaces() -> [Params; 4] {
        let mut regimes = surface(WEAK, HeightFamily::Weibull { shape: 2.2 }, [0.3, 0.7]);
        (regimes.slip.radius_1, regimes.slip.radius_2, regimes.slip.stress_2) = (20.0, 60.0, 0.007);
        let mut film = surface(WEAK, HeightFamily::Gaussian, [0.0, 1.0]);
        film.pressure_coefficient = 0.1;
        let mut falling = surface(WEAK, HeightFamily::Gaussian, [-0.8, 1.5]);
        falling.pressure_coefficient = 0.1;
        [surface(WEAK, HeightFamily::Gaussian, [0.0, 1.0]), regimes, film, falling]
    }

    /// At several separations, with either way to begin to slip.
    fn each_state(check: impl Fn(&Population, f64, Sums, SlipOnset)) {
        for params in surfaces() {
            for slip_onset in [SlipOnset::Partial, SlipOnset::Whole] {
                let population = of(&Params { slip_onset, ..params.clone() });
                for separation in [-1.0, 0.5, 2.0] {
                    check(&population, separation, population.at_separation(separation), slip_onset);
                }
            }
        }
    }

    #[test]
    fn what_is_lost_to_slip_is_missing_from_the_forces_before_gross_slip() {
        each_state(|population, separation, sums, slip_onset| {
            let places = [1e-3, 0.3, 1.0, 1.5, 4.0, 1e3];
            let ratios = places.map(|place| place * sums.friction / sums.radius);
            let found = population.lost_to_slip(separation, ratios).expect("contacts");
            for (i, ([place, lost, given_up], ratio)) in found.into_iter().zip(ratios).enumerate() {
                assert!((place / places[i] - 1.0).abs() < 1e-9);
                let slipping = population.microslip(separation, ratio).expect("a force");
                let expected = places[i] - slipping.force / sums.friction;
                let error = lost - expected;
                assert!(
                    error.abs() < 4e-3 * expected + 1e-5,
                    "{slip_onset:?}, {ratio} at {separation}: {lost}, {error:e}"
                );
                let sticking = slipping.sticking / sums.radius;
                let error = 1.0 - given_up - sticking;
                // Contacts that slip as a whole are counted by the points of the sum.
                let most = if slip_onset == SlipOnset::Whole { 0.1 } else { 0.01 };
                assert!(error.abs() < most, "{slip_onset:?}, {ratio} at {separation}: {given_up}, not {sticking}");
                assert!((slipping.radius / sums.radius - 1.0).abs() < 1e-9);
            }
        });
    }

    #[test]
    fn what_sticks_is_how_fast_the_force_rises() {
        each_state(|population, separation, sums, slip_onset| {
            for ratio in [0.1, 0.7, 1.2].map(|ratio| ratio * sums.friction / sums.radius) {
                let at = |change: f64| population.microslip(separation, ratio * (1.0 + change)).expect("a force");
                let secant = (at(1e-4).force - at(-1e-4).force) / (2e-4 * ratio);
                let sticking = at(0.0).sticking;
                let error = (sticking - secant).abs() / sums.radius;
                assert!(error < 1e-6, "{slip_onset:?}, {ratio} at {separation}: {sticking}, not {secant}");
            }
        });
    }

    #[test]
    fn where_nothing_touches_nothing_resists() {
        let heights = HeightFamily::Tabulated { height: [-1.0, 0.0, 1.0].into(), density: [0.5, 1.0, 0.5].into() };
        let population = of(&surface([0.01, 1000.0, 0.0, 1.0], heights, [0.0, 1.0]));
        let beyond = population.farthest() + 1.0;
        assert_eq!(population.lost_to_slip(beyond, [1.0]), None);
        assert_eq!(population.microslip(beyond, 1.0).expect("a force").force, 0.0);
    }
}
