//! Hertz' contact of one asperity: Maugis' law without adhesion, eqs (5) and (6) with gamma = 0.

use super::contact::{Contact, ContactLaw, Rates};
use crate::asperity::groups::Groups;

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
        let load = load_over_radius * radius;
        let (load_by_s, load_by_g) = (3.0 * load_over_radius * radius_rate, 0.5 * load_over_radius * radius / g);
        Contact {
            parameter,
            overlap: parameter * parameter,
            radius,
            load,
            hertz_load: load,
            by_s: Rates { overlap: 2.0 * parameter, radius: radius_rate, load: load_by_s, hertz_load: load_by_s },
            by_g: Rates { overlap: 0.0, radius: 0.5 * radius / g, load: load_by_g, hertz_load: load_by_g },
            spring_stiffness: 0.0,
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
    use crate::asperity::contact::tests::{assert_rates_are_secants, elastic};

    #[test]
    fn rates_are_slopes_of_secants() {
        assert_rates_are_secants(&Hertz::new(&elastic([0.02, 300.0, 0.0, 1.0])), &[0.1, 1.0, 30.0]);
    }
}
