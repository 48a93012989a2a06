//! What the sums over a surface need of a law of contact. One law is one file.

/// Overlap, contact radius and load of one asperity, or what these change by with something else.
///
/// Lengths: radius in b, overlap in sigma; load in E* b^2.
#[derive(Debug, Clone, Copy, Default)]
pub struct Rates {
    /// The overlap u = z - d, or its change.
    pub overlap: f64,
    /// The contact radius a, or its change.
    pub radius: f64,
    /// The load P, or its change.
    pub load: f64,
    /// The load P_H of Hertz' contact of the same radius, or its change.
    pub hertz_load: f64,
}

/// One asperity in contact, and its derivatives along the branch of states. `g` is the summit's radius over the mean one.
#[derive(Debug, Clone, Copy, Default)]
pub struct Contact {
    /// Where on the branch it is, s; see [`ContactLaw`].
    pub parameter: f64,
    /// Overlap u, in sigma.
    pub overlap: f64,
    /// Contact radius a, in b.
    pub radius: f64,
    /// Load P, in E* b^2.
    pub load: f64,
    /// Load of Hertz' contact of this radius, P_H = 4 E* a^3/(3 g R): the load and what adhesion adds to it. Of summits that
    /// yield the load.
    pub hertz_load: f64,
    /// Derivatives by s at fixed g; that of the overlap is positive, but 0 at break-away.
    pub by_s: Rates,
    /// Derivatives by g at fixed s.
    pub by_g: Rates,
    /// dP/du over a of a contact that springs back as the largest load left it, 2 alpha beta: at a fixed height it changes otherwise
    /// than with s. 0 where it changes with s.
    pub spring_stiffness: f64,
}

impl Contact {
    /// ds/du at fixed g; 0 where the contact just breaks away, and the overlap does not depend on s.
    #[inline]
    pub fn s_by_overlap(&self) -> f64 {
        if self.by_s.overlap > f64::MIN_POSITIVE {
            1.0 / self.by_s.overlap
        } else {
            0.0
        }
    }

    /// What it changes by where the surfaces approach.
    #[inline]
    pub fn by_approach(&self) -> Rates {
        if self.spring_stiffness > 0.0 {
            let load = self.spring_stiffness * self.radius;
            let radius = if self.load > 0.0 { load * self.radius / (3.0 * self.load) } else { 0.0 };
            return Rates { overlap: 1.0, radius, load, hertz_load: load };
        }
        let by = self.s_by_overlap();
        let Rates { overlap, radius, load, hertz_load } = self.by_s;
        Rates { overlap: overlap * by, radius: radius * by, load: load * by, hertz_load: hertz_load * by }
    }

    /// The contact a little farther on: where s grows by `s` and g by `g`, to first order.
    #[inline]
    pub fn moved(self, s: f64, g: f64) -> Self {
        Self {
            parameter: self.parameter + s,
            overlap: self.overlap + s * self.by_s.overlap + g * self.by_g.overlap,
            radius: self.radius + s * self.by_s.radius + g * self.by_g.radius,
            load: self.load + s * self.by_s.load + g * self.by_g.load,
            hertz_load: self.hertz_load + s * self.by_s.hertz_load + g * self.by_g.hertz_load,
            ..self
        }
    }

    /// This contact, with the rates that go on from one contact to another at the same g, where it lies a little beyond.
    #[inline]
    pub fn with_rates_beyond(self, here: &Self, before: &Self) -> Self {
        let way = here.parameter - before.parameter;
        if way == 0.0 {
            return self;
        }
        let part = (self.parameter - here.parameter) / way;
        let onwards = |here: f64, before: f64| here + part * (here - before);
        let all_onwards = |here: Rates, before: Rates| Rates {
            overlap: onwards(here.overlap, before.overlap),
            radius: onwards(here.radius, before.radius),
            load: onwards(here.load, before.load),
            hertz_load: onwards(here.hertz_load, before.hertz_load),
        };
        Self { by_s: all_onwards(here.by_s, before.by_s), by_g: all_onwards(here.by_g, before.by_g), ..self }
    }
}

/// A law of contact: the states of one asperity from break-away to any load, as functions of a parameter s.
///
/// The parameter grows with the load. It is chosen such that the states are analytic in it at break-away, where the
/// overlap is u_0 + O((s - s_0)^2), and grows as a power of s under heavy load: then panels of equal ratio in s serve light
/// and heavy contacts alike.
pub trait ContactLaw: std::fmt::Debug + Send + Sync {
    /// The state at a parameter not below that of break-away.
    fn at(&self, parameter: f64, g: f64) -> Contact;

    /// The state at which the contact breaks when the surfaces are drawn apart.
    fn break_away(&self, g: f64) -> Contact;

    /// The state at an overlap not below that of break-away, from a guess of its parameter.
    fn at_overlap(&self, overlap: f64, g: f64, guess: f64) -> Contact;

    /// A guess of the parameter at an overlap.
    fn guess(&self, overlap: f64, g: f64) -> f64;

    /// Distance from a parameter to the nearest point, real or complex, where the states are not analytic in it, but for
    /// the kinks.
    fn distance_to_singularity(&self, parameter: f64, g: f64) -> f64;

    /// Overlaps over g at which states are continuous and their rates jump, infinite where there are fewer. A summit that
    /// keeps its shape at any scale has them there; most laws have none.
    fn kinks(&self) -> [f64; KINKS] {
        [f64::INFINITY; KINKS]
    }
}

/// The most kinks of a law of contact.
pub const KINKS: usize = 2;

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::asperity::groups::Groups;

    /// The groups of elastic summits.
    pub fn elastic([alpha, beta, gamma, b_over_h]: [f64; 4]) -> Groups {
        Groups { alpha, beta, gamma, b_over_h, hardness: f64::INFINITY, yields: false, nominal_area: 0.0 }
    }

    /// By s and by g, at these parameters and at three radii.
    pub fn assert_rates_are_secants(here: &dyn ContactLaw, parameters: &[f64]) {
        for (s, g) in parameters.iter().flat_map(|&s| [0.3, 1.0, 1.8].map(|g| (s, g))) {
            let step = 1e-5 * s.clamp(0.01, 1.0);
            let contact = here.at(s, g);
            assert_rates([here.at(s - step, g), here.at(s + step, g)], step, contact.by_s, &format!("ds at {s}, {g}"));
            assert_rates([here.at(s, g - step), here.at(s, g + step)], step, contact.by_g, &format!("dg at {s}, {g}"));
        }
    }

    /// From the contacts a step before and a step beyond.
    fn assert_rates([before, after]: [Contact; 2], step: f64, rates: Rates, by: &str) {
        for (name, before, after, rate) in [
            ("du", before.overlap, after.overlap, rates.overlap),
            ("da", before.radius, after.radius, rates.radius),
            ("dP", before.load, after.load, rates.load),
            ("dP_H", before.hertz_load, after.hertz_load, rates.hertz_load),
        ] {
            let secant = (after - before) / (2.0 * step);
            // The Hertz load grows as the cube of s where s is 0.
            let known = 1e-7 * rate.abs() + 1e-15 * after.abs() / step + 1e5 * step * step;
            assert!((secant - rate).abs() <= known, "{name}/{by}: {rate}, not {secant}");
        }
    }
}
