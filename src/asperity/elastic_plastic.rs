//! Elastic-plastic contact of one asperity, without adhesion: Zhao, Maietta and Chang, J. Tribol. 122 (2000) 86-93.
//!
//! A summit is elastic (Hertz) up to the overlap u1 of first yield, flows at the mean pressure H from u2 = 54 u1 on, and
//! goes over from one to the other between. With eta = H/E* and t = (u - u1)/(u2 - u1), for a summit of radius gR:
//!
//! ```text
//! u <= u1   a^2 = beta^2 g u                       P = 4 alpha/(3 beta g) a^3
//! between   a^2 = beta^2 g u (1 + 3 t^2 - 2 t^3)   P = pi a^2 eta (1 - (1 - K) ln(u2/u)/ln 54)
//! u >= u2   a^2 = 2 beta^2 g u                     P = pi a^2 eta
//! ```
//!
//! It is a law of first loading: after a heavier load the summits are flatter than it says.

use super::contact::{Contact, ContactLaw, Rates, KINKS};
use super::hertz::Hertz;
use crate::asperity::groups::Groups;
use crate::numerics::elementary::log;
use std::f64::consts::PI;

/// K: the mean pressure at first yield over the hardness.
const FIRST_YIELD: f64 = 0.4;
/// u2/u1.
const FLOW: f64 = 54.0;
const LOG_FLOW: f64 = 3.988_984_046_564_274_5;
/// ln u in the load is singular at u = 0. From this part of u1 on panels are laid accordingly: rounding may have put the
/// beginning of one just below u1.
const NEXT_TO_YIELD: f64 = 0.5;

/// The law of summits that yield. Its parameter is the square root of the overlap.
#[derive(Debug, Clone)]
pub struct ElasticPlastic {
    elastic: Hertz,
    beta: f64,
    /// eta = H/E*.
    hardness: f64,
    /// u1/g.
    first_yield: f64,
}

/// A quantity and its derivatives by overlap and by g.
type WithRates = [f64; 3];

impl ElasticPlastic {
    /// The law of a surface's groups, of summits that yield.
    pub fn new(groups: &Groups) -> Self {
        Self {
            elastic: Hertz::new(groups),
            beta: groups.beta,
            hardness: groups.hardness,
            first_yield: first_yield(groups),
        }
    }

    /// a^2 and mean pressure above u1.
    fn yielding(&self, overlap: f64, g: f64) -> (WithRates, WithRates) {
        let first = self.first_yield * g;
        if overlap >= FLOW * first {
            let scale = 2.0 * self.beta * self.beta;
            return ([scale * g * overlap, scale * g, scale * overlap], [self.hardness, 0.0, 0.0]);
        }
        let width = (FLOW - 1.0) * first;
        let t = (overlap - first) / width;
        let shape = 1.0 + t * t * (3.0 - 2.0 * t);
        // u d(shape)/du, which is -g d(shape)/dg.
        let bend = 6.0 * t * (1.0 - t) * (overlap / width);
        let scale = self.beta * self.beta;
        let square = [scale * g * overlap * shape, scale * g * (shape + bend), scale * overlap * (shape - bend)];
        let rise = self.hardness * (1.0 - FIRST_YIELD) / LOG_FLOW;
        let pressure = self.hardness - rise * log(FLOW * first / overlap);
        (square, [pressure, rise / overlap, -rise / g])
    }
}

/// u1/g of a surface's groups, at which the mean pressure of a Hertzian contact is K H: (3 pi K eta/4)^2/alpha^2.
pub fn first_yield(groups: &Groups) -> f64 {
    let root = 0.75 * PI * FIRST_YIELD * groups.hardness / groups.alpha;
    root * root
}

impl ContactLaw for ElasticPlastic {
    #[inline]
    fn at(&self, parameter: f64, g: f64) -> Contact {
        let overlap = parameter * parameter;
        if overlap <= self.first_yield * g {
            return self.elastic.at(parameter, g);
        }
        let (square, pressure) = self.yielding(overlap, g);
        let load_by = |i: usize| PI * (square[i] * pressure[0] + square[0] * pressure[i]);
        let (radius, overlap_rate) = (square[0].sqrt(), 2.0 * parameter);
        let load = PI * square[0] * pressure[0];
        let (load_by_s, load_by_g) = (load_by(1) * overlap_rate, load_by(2));
        Contact {
            parameter,
            overlap,
            radius,
            load,
            hertz_load: load,
            by_s: Rates {
                overlap: overlap_rate,
                radius: square[1] * parameter / radius,
                load: load_by_s,
                hertz_load: load_by_s,
            },
            by_g: Rates { overlap: 0.0, radius: 0.5 * square[2] / radius, load: load_by_g, hertz_load: load_by_g },
            spring_stiffness: 0.0,
        }
    }

    fn break_away(&self, g: f64) -> Contact {
        self.elastic.break_away(g)
    }

    fn at_overlap(&self, overlap: f64, g: f64, _guess: f64) -> Contact {
        Contact { overlap, ..self.at(overlap.max(0.0).sqrt(), g) }
    }

    fn guess(&self, overlap: f64, g: f64) -> f64 {
        self.elastic.guess(overlap, g)
    }

    fn distance_to_singularity(&self, parameter: f64, g: f64) -> f64 {
        let (overlap, first) = (parameter * parameter, self.first_yield * g);
        if overlap > NEXT_TO_YIELD * first && overlap < FLOW * first {
            parameter
        } else {
            f64::INFINITY
        }
    }

    fn kinks(&self) -> [f64; KINKS] {
        [self.first_yield, FLOW * self.first_yield]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asperity::contact::tests::assert_rates_are_secants;

    const GROUPS: Groups =
        Groups { alpha: 0.02, beta: 300.0, gamma: 0.0, b_over_h: 1.0, hardness: 0.01, yields: true, nominal_area: 0.0 };

    #[test]
    fn rates_are_slopes_of_secants() {
        let first = first_yield(&GROUPS).sqrt();
        assert_rates_are_secants(&ElasticPlastic::new(&GROUPS), &[0.1, 0.5, 3.0, 6.0, 11.0].map(|part| part * first));
    }

    /// By the roots of 1 + 3 t^2 - 2 t^3 and of u: no singularity of the states lies within three times the distance.
    #[test]
    fn panels_reach_as_far_as_the_law_between_first_yield_and_flow_is_smooth() {
        let law = ElasticPlastic::new(&GROUPS);
        for (ratio, smooth) in [(0.4, true), (0.9, false), (10.0, false), (53.0, false), (54.1, true), (1e4, true)] {
            let parameter = (ratio * law.first_yield * 1.8).sqrt();
            let distance = law.distance_to_singularity(parameter, 1.8);
            assert_eq!(distance, if smooth { f64::INFINITY } else { parameter }, "{ratio}");
        }
    }
}
