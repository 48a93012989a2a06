//! Unloading of one asperity that may have yielded: it keeps the contact radius a_m and the load P_m of the largest load, and springs
//! back as Hertz' contact of the radius 4 E* a_m^3/(3 P_m). With the approach d - d_m that all summits have lost since then,
//!
//! ```text
//! e = 3 P_m/(4 E* a_m)      x = 1 - (d - d_m)/e      P = P_m x^(3/2)      a = a_m x^(1/2)      dP/du = 2 E* a
//! ```
//!
//! At one separation this is a law of contact: the overlap then was u + (d - d_m). A summit that has not yielded has e = u.

use super::contact::{Contact, ContactLaw, Rates};
use crate::numerics::root::MOST_STEPS;
use std::sync::Arc;

/// Steps of this part of the overlap are rounding.
const ROUNDING: f64 = 4e-15;

/// The law of all summits at one separation. Its parameter is the square root of e - (d - d_m), the elastic overlap that is left.
#[derive(Debug, Clone)]
pub struct Unloaded {
    /// The law of first loading.
    pub loading: Arc<dyn ContactLaw>,
    /// The overlap over g up to which it is Hertz'.
    pub first_yield: f64,
    /// 2 alpha beta: 2 E* a, in E* b^2 per sigma, of a contact of the radius b.
    pub stiffness_of_radius: f64,
    /// d - d_m >= 0, in sigma.
    pub lost: f64,
}

/// A summit under the largest load.
struct Pressed {
    contact: Contact,
    /// By overlap at fixed g.
    by_overlap: Rates,
    /// By g at fixed overlap.
    by_g: Rates,
    spring: f64,
    spring_by: [f64; 2],
}

impl Unloaded {
    /// e of a summit that overlapped by so much, and its derivatives by that and by g.
    pub fn spring(&self, overlap: f64, g: f64) -> (f64, [f64; 2]) {
        let pressed = self.pressed(overlap, g);
        (pressed.spring, pressed.spring_by)
    }

    fn pressed(&self, overlap: f64, g: f64) -> Pressed {
        let contact = self.loading.at_overlap(overlap.max(0.0), g, self.loading.guess(overlap, g));
        let (by, by_g) = (contact.s_by_overlap(), contact.by_g);
        let by_overlap = Rates {
            overlap: 1.0,
            radius: contact.by_s.radius * by,
            load: contact.by_s.load * by,
            hertz_load: contact.by_s.hertz_load * by,
        };
        if overlap <= self.first_yield * g {
            return Pressed { contact, by_overlap, by_g, spring: overlap.max(0.0), spring_by: [1.0, 0.0] };
        }
        let spring = 1.5 * contact.load / (self.stiffness_of_radius * contact.radius);
        let slope = |by: &Rates| spring * (by.load / contact.load - by.radius / contact.radius);
        let spring_by = [slope(&by_overlap), slope(&by_g)];
        Pressed { contact, by_overlap, by_g, spring, spring_by }
    }

    /// The summit that springs back by so much: by Newton's method within a bracket, since a summit springs back by no more than it
    /// overlapped.
    fn springing(&self, spring: f64, g: f64) -> Pressed {
        let (mut lower, mut upper, mut overlap) = (spring, f64::INFINITY, spring);
        for _ in 0..MOST_STEPS {
            let pressed = self.pressed(overlap, g);
            let excess = pressed.spring - spring;
            *if excess < 0.0 { &mut lower } else { &mut upper } = overlap;
            let next = overlap - excess / pressed.spring_by[0];
            let next = match next >= lower && next <= upper {
                true => next,
                false if upper < f64::INFINITY => 0.5 * (lower + upper),
                false => 2.0 * lower,
            };
            if (next - overlap).abs() <= ROUNDING * overlap || !next.is_finite() {
                return pressed;
            }
            overlap = next;
        }
        self.pressed(f64::NAN, g)
    }

    /// What is left of a summit, of which this is the square root of the elastic overlap.
    fn left(&self, pressed: &Pressed, parameter: f64) -> Contact {
        let Pressed { contact, by_overlap, by_g, spring, spring_by: [by_u, spring_by_g] } = pressed;
        if *spring == 0.0 {
            return *contact;
        }
        let root_rate = self.lost / (spring * spring.sqrt());
        let root = parameter / spring.sqrt();
        let (cube, cube_rate) = (root * root * root, 3.0 * root * root * root_rate);
        let (u_by_s, u_by_g) = (2.0 * parameter / by_u, -spring_by_g / by_u);
        let along = |of: fn(&Rates) -> f64| of(by_g) + of(by_overlap) * u_by_g;
        let (load, load_by_s) = (contact.load * cube, by_overlap.load * u_by_s * cube + contact.load * cube_rate);
        let load_by_g = along(|by| by.load) * cube;
        Contact {
            parameter,
            overlap: contact.overlap - self.lost,
            radius: contact.radius * root,
            load,
            hertz_load: load,
            by_s: Rates {
                overlap: u_by_s,
                radius: by_overlap.radius * u_by_s * root + contact.radius * root_rate,
                load: load_by_s,
                hertz_load: load_by_s,
            },
            by_g: Rates {
                overlap: u_by_g,
                radius: along(|by| by.radius) * root,
                load: load_by_g,
                hertz_load: load_by_g,
            },
            spring_stiffness: self.stiffness_of_radius,
        }
    }
}

impl ContactLaw for Unloaded {
    fn at(&self, parameter: f64, g: f64) -> Contact {
        self.left(&self.springing(self.lost + parameter * parameter, g), parameter)
    }

    fn break_away(&self, g: f64) -> Contact {
        self.at(0.0, g)
    }

    fn at_overlap(&self, overlap: f64, g: f64, _guess: f64) -> Contact {
        let pressed = self.pressed(overlap + self.lost, g);
        let parameter = (pressed.spring - self.lost).max(0.0).sqrt();
        Contact { overlap, ..self.left(&pressed, parameter) }
    }

    fn guess(&self, overlap: f64, g: f64) -> f64 {
        (self.pressed(overlap + self.lost, g).spring - self.lost).max(0.0).sqrt()
    }

    fn distance_to_singularity(&self, parameter: f64, g: f64) -> f64 {
        let spring = self.lost + parameter * parameter;
        match spring < 0.5 * self.first_yield * g {
            true => f64::INFINITY,
            false => spring.sqrt(),
        }
    }

    fn kinks(&self) -> [f64; super::contact::KINKS] {
        self.loading.kinks()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::contact::tests::assert_rates_are_secants;
    use crate::asperity::elastic_plastic::{first_yield, ElasticPlastic};
    use crate::asperity::groups::Groups;

    const GROUPS: Groups =
        Groups { alpha: 0.02, beta: 300.0, gamma: 0.0, b_over_h: 1.0, hardness: 0.01, yields: true, nominal_area: 0.0 };

    fn law(lost: f64) -> Unloaded {
        Unloaded {
            loading: Arc::new(ElasticPlastic::new(&GROUPS)),
            first_yield: first_yield(&GROUPS),
            stiffness_of_radius: 2.0 * GROUPS.alpha * GROUPS.beta,
            lost: lost * first_yield(&GROUPS),
        }
    }

    #[test]
    fn rates_are_slopes_of_secants() {
        for lost in [0.4, 3.0] {
            let root = first_yield(&GROUPS).sqrt();
            assert_rates_are_secants(&law(lost), &[0.1, 0.7, 2.0, 5.0].map(|part| part * root));
        }
    }

    /// I. Etsion, Y. Kligerman and Y. Kadin, Int. J. Solids Struct. 42 (2005) 3716, by finite elements: what is left of the overlap without load.
    #[test]
    fn what_stays_of_the_overlap_is_near_that_of_finite_elements() {
        let law = law(0.0);
        for ratio in [1.5, 3.0, 10.0, 30.0, 60.0, 100.0, 150.0] {
            let overlap = ratio * law.first_yield;
            let stays = 1.0 - law.spring(overlap, 1.0).0 / overlap;
            let published = (1.0 - f64::powf(ratio, -0.28)) * (1.0 - f64::powf(ratio, -0.69));
            println!("{ratio}: {stays} {published}");
            assert!((stays - published).abs() < 0.11, "{ratio}: {stays}, not {published}");
        }
    }

    /// In units of E* b^2 and b: dP/du = 2 E* a, and P = 4/3 E* a^3/R with the radius that the largest load left.
    #[test]
    fn what_is_left_is_a_hertz_contact_of_its_own_radius() {
        for (lost, overlap) in [(0.0, 0.5), (0.3, 0.5), (0.3, 20.0), (2.0, 20.0), (5.0, 400.0)] {
            let law = law(lost);
            let u = overlap * law.first_yield;
            let largest = law.loading.at_overlap(u, 1.0, 0.0);
            let left = law.at_overlap(u - law.lost, 1.0, 0.0);
            let radius = 4.0 * largest.radius.powi(3) / (3.0 * largest.load);
            assert!((left.load / (4.0 / 3.0 * left.radius.powi(3) / radius) - 1.0).abs() < 1e-12, "{lost}, {overlap}");
            let again = law.at(left.parameter, 1.0);
            assert!((again.load / left.load - 1.0).abs() < 1e-11 && (again.overlap / left.overlap - 1.0).abs() < 1e-10);
            // A little more of it lost.
            let step = 1e-6 * law.first_yield;
            let less = Unloaded { lost: law.lost + step, ..law.clone() }.at_overlap(u - law.lost - step, 1.0, 0.0);
            let stiffness = law.stiffness_of_radius * left.radius;
            assert!(((left.load - less.load) / step / stiffness - 1.0).abs() < 1e-4, "{lost}, {overlap}");
        }
    }
}
