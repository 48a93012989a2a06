//! Hertz' contact of one asperity: Maugis' law without adhesion, eqs (5) and (6) with gamma = 0.

use super::contact::{Contact, ContactLaw};
use crate::groups::Groups;

/// Hertz' law. Its parameter is the square root of the overlap.
#[derive(Debug, Clone)]
pub struct Hertz {
    /// beta: a = beta (g u)^(1/2).
    beta: f64,
    /// 4 alpha/(3 beta): P = that times a^3/g.
    load: f64,
}

impl Hertz {
    /// The law of a surface's groups.
    pub fn new(groups: &Groups) -> Self {
        Self { beta: groups.beta, load: 4.0 * groups.alpha / (3.0 * groups.beta) }
    }
}

impl ContactLaw for Hertz {
    #[inline]
    fn at(&self, parameter: f64, g: f64) -> Contact {
        let radius_rate = self.beta * g.sqrt();
        let radius = radius_rate * parameter;
        let load_over_radius = self.load * radius * radius / g;
        Contact {
            parameter,
            overlap: parameter * parameter,
            radius,
            load: load_over_radius * radius,
            overlap_rate: 2.0 * parameter,
            radius_rate,
            load_rate: 3.0 * load_over_radius * radius_rate,
            overlap_by_g: 0.0,
            radius_by_g: 0.5 * radius / g,
            load_by_g: 0.5 * load_over_radius * radius / g,
        }
    }

    fn break_away(&self, g: f64) -> Contact {
        self.at(0.0, g)
    }

    fn at_overlap(&self, overlap: f64, g: f64, _guess: f64) -> Contact {
        Contact { overlap, ..self.at(overlap.max(0.0).sqrt(), g) }
    }

    fn guess(&self, overlap: f64, _g: f64) -> f64 {
        overlap.max(0.0).sqrt()
    }

    fn distance_to_singularity(&self, _parameter: f64, _g: f64) -> f64 {
        f64::INFINITY
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::contact::tests::assert_rates_are_secants;

    #[test]
    fn load_and_radius_are_those_of_hertz() {
        let (alpha, beta) = (0.02, 300.0);
        let law =
            Hertz::new(&Groups { alpha, beta, gamma: 0.0, b_over_h: 1.0, hardness: f64::INFINITY, yields: false });
        for g in [0.3, 1.0, 1.8] {
            for overlap in [1e-200, 1e-3, 0.5, 40.0] {
                let contact = law.at_overlap(overlap, g, 0.0);
                // In units of b, E* and sigma: R = g beta/alpha, sigma = alpha beta; a^2 = R u, P = 4/3 R^(1/2) u^(3/2).
                let (summit_radius, depth): (f64, f64) = (g * beta / alpha, overlap * alpha * beta);
                let near = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b.abs();
                assert!(near(contact.radius, (summit_radius * depth).sqrt()), "{contact:?}");
                assert!(near(contact.load, 4.0 / 3.0 * summit_radius.sqrt() * depth.powf(1.5)), "{contact:?}");
                assert!(near(contact.overlap, overlap), "{contact:?}");
            }
        }
    }

    #[test]
    fn rates_are_slopes_of_secants() {
        let law = Hertz::new(&Groups {
            alpha: 0.02,
            beta: 300.0,
            gamma: 0.0,
            b_over_h: 1.0,
            hardness: f64::INFINITY,
            yields: false,
        });
        assert_rates_are_secants(&law, &[0.1, 1.0, 30.0]);
    }
}
