//! What the sums over a surface need of a law of contact. One law is one file.

/// One asperity in contact, and its derivatives along the branch of states.
///
/// Lengths: radius in b, overlap in sigma; load in E* b^2. `g` is the summit's radius over the mean one.
#[derive(Debug, Clone, Copy)]
pub struct Contact {
    /// Where on the branch it is; see [`ContactLaw`].
    pub parameter: f64,
    /// Overlap u = z - d.
    pub overlap: f64,
    /// Contact radius a.
    pub radius: f64,
    /// Load P.
    pub load: f64,
    /// du/ds at fixed g: positive, but 0 at break-away.
    pub overlap_rate: f64,
    /// da/ds at fixed g.
    pub radius_rate: f64,
    /// dP/ds at fixed g.
    pub load_rate: f64,
    /// du/dg at fixed s.
    pub overlap_by_g: f64,
    /// da/dg at fixed s.
    pub radius_by_g: f64,
    /// dP/dg at fixed s.
    pub load_by_g: f64,
}

impl Contact {
    /// No contact: all numbers are NaN.
    pub const UNKNOWN: Self = Self {
        parameter: f64::NAN,
        overlap: f64::NAN,
        radius: f64::NAN,
        load: f64::NAN,
        overlap_rate: f64::NAN,
        radius_rate: f64::NAN,
        load_rate: f64::NAN,
        overlap_by_g: f64::NAN,
        radius_by_g: f64::NAN,
        load_by_g: f64::NAN,
    };

    /// The contact a little farther on: where the parameter grows by `parameter` and g by `g`, to first order.
    #[inline]
    pub fn moved(self, parameter: f64, g: f64) -> Self {
        Self {
            parameter: self.parameter + parameter,
            overlap: self.overlap + parameter * self.overlap_rate + g * self.overlap_by_g,
            radius: self.radius + parameter * self.radius_rate + g * self.radius_by_g,
            load: self.load + parameter * self.load_rate + g * self.load_by_g,
            ..self
        }
    }

    /// This contact, with the rates by s that go on from one contact to another at the same g, where it lies a little beyond.
    #[inline]
    pub fn with_rates_beyond(self, here: &Self, before: &Self) -> Self {
        let way = here.parameter - before.parameter;
        if way == 0.0 {
            return self;
        }
        let part = (self.parameter - here.parameter) / way;
        let onwards = |here: f64, before: f64| here + part * (here - before);
        Self {
            overlap_rate: onwards(here.overlap_rate, before.overlap_rate),
            radius_rate: onwards(here.radius_rate, before.radius_rate),
            load_rate: onwards(here.load_rate, before.load_rate),
            overlap_by_g: onwards(here.overlap_by_g, before.overlap_by_g),
            radius_by_g: onwards(here.radius_by_g, before.radius_by_g),
            load_by_g: onwards(here.load_by_g, before.load_by_g),
            ..self
        }
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

    /// At these parameters and at three radii.
    pub fn assert_rates_are_secants(law: &dyn ContactLaw, parameters: &[f64]) {
        for &s in parameters {
            for g in [0.3, 1.0, 1.8] {
                let here = law.at(s, g);
                let along = |step: f64| [law.at(s - step, g), law.at(s + step, g)];
                let across = |step: f64| [law.at(s, g - step), law.at(s, g + step)];
                let step = 1e-5 * s.min(1.0);
                for (name, pair, rate, value) in [
                    ("du/ds", along(step).map(|c| c.overlap), here.overlap_rate, here.overlap),
                    ("da/ds", along(step).map(|c| c.radius), here.radius_rate, here.radius),
                    ("dP/ds", along(step).map(|c| c.load), here.load_rate, here.load),
                    ("du/dg", across(step).map(|c| c.overlap), here.overlap_by_g, here.overlap),
                    ("da/dg", across(step).map(|c| c.radius), here.radius_by_g, here.radius),
                    ("dP/dg", across(step).map(|c| c.load), here.load_by_g, here.load),
                ] {
                    let secant = (pair[1] - pair[0]) / (2.0 * step);
                    let rounding = 1e-15 * value.abs() / step;
                    assert!(
                        (secant - rate).abs() < 1e-7 * rate.abs() + rounding,
                        "{name} at {s}, {g}: {rate}, not {secant}"
                    );
                }
            }
        }
    }
}
