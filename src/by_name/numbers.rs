//! Numbers by their names, given together: what they make of parameters, in which order.

use super::draft::{Draft, AT_SCORES, JOHNSON, WEIBULL};
use super::fields::FIELDS;
use super::keys::{meant, LISTED};
use crate::error::Error;
use crate::materials::names::{Instead, Unknown};
use crate::materials::{Bodies, Interface};
use crate::numerics::float_bits::nan;
use crate::params::shapes::Heights;
use crate::params::spectrum::SpectralMoments;
use crate::params::{positive, Params};
use std::borrow::Cow;
use std::f64::consts::FRAC_PI_2;

/// Names that are no fields: arguments of setters, which take all of theirs at once.
pub static ARGUMENTS: [&str; 12] = [
    "E1",
    "nu1",
    "E2",
    "nu2",
    "m0",
    "m2",
    "m4",
    "Ra",
    "summit_density",
    "calibration_load",
    "calibration_friction_coefficient",
    "calibration_friction_force",
];

/// All names of numbers.
pub fn names() -> impl Iterator<Item = &'static str> {
    FIELDS.iter().map(|field| field.name).chain(ARGUMENTS)
}

/// What is set together. Of a number that is given twice the last counts.
#[derive(Clone)]
pub struct Numbers {
    values: [Option<f64>; FIELDS.len() + ARGUMENTS.len()],
    /// Two materials by their names.
    pub bodies: Option<Bodies>,
    pub interface: Option<&'static Interface>,
    /// Whether moments stand for McCool's summits.
    pub has_mccool_summits: bool,
    /// Heights and slopes of the surface at normal scores, in place of moments.
    pub at_scores: Option<[Heights; 2]>,
    pub lay: Option<f64>,
}

impl Default for Numbers {
    fn default() -> Self {
        let values = [None; FIELDS.len() + ARGUMENTS.len()];
        Self { values, bodies: None, interface: None, has_mccool_summits: false, at_scores: None, lay: None }
    }
}

fn meaningless(says: &'static str) -> Error {
    Error::Meaningless(Cow::Borrowed(says))
}

impl Numbers {
    /// Which name in turn this is.
    #[inline(never)]
    pub fn position(name: &[u8]) -> Option<usize> {
        names().position(|other| other.as_bytes() == name)
    }

    /// What is said of a name that is none.
    pub fn unknown(name: &[u8]) -> Unknown<'_> {
        let word = std::str::from_utf8(name).ok().and_then(meant);
        let instead = word.map_or_else(|| Instead::of(name, names(), LISTED), Instead::Says);
        Unknown { name, thing: "parameter", instead }
    }

    /// Gives a number by its position.
    pub fn give(&mut self, position: usize, value: f64) {
        self.values[position] = Some(value);
    }

    /// Gives a number by a name that is one, or takes it back.
    pub fn give_named(&mut self, name: &'static str, value: impl Into<Option<f64>>) {
        if let Some(position) = Self::position(name.as_bytes()) {
            self.values[position] = value.into();
        }
    }

    pub fn get(&self, name: &str) -> Option<f64> {
        self.values[Self::position(name.as_bytes())?]
    }

    /// Sets all but the strength from a measurement, which needs all else.
    ///
    /// # Errors
    /// What is refused, by its name; the draft is of no use then.
    pub fn set(&self, draft: &mut Draft) -> Result<(), Error> {
        if let Some(bodies) = &self.bodies {
            draft.params.set_bodies(bodies)?;
        }
        if let Some([young_1, poisson_1, young_2, poisson_2]) =
            self.together(["E1", "nu1", "E2", "nu2"], "must be given too: E1, nu1, E2 and nu2 go together")?
        {
            draft.params.set_materials(young_1, poisson_1, young_2, poisson_2)?;
        }
        self.set_fields(draft)?;
        // As `Params::set_elastic_plastic` does, but a work of adhesion that was given is refused with the parameters.
        let of_bodies = self.bodies.is_some() || nan(draft.params.work_of_adhesion);
        if self.get("contact_law") == Some(1.0) && of_bodies && self.get("work_of_adhesion").is_none() {
            draft.params.work_of_adhesion = 0.0;
        }
        // After `nominal_area`, which they need.
        if let Some(moments) = self.moments()? {
            let area = draft.params.nominal_area;
            match (self.has_mccool_summits, &self.at_scores) {
                (true, _) => draft.params.set_mccool_summits(moments, area)?,
                (false, None) => draft.params.set_spectral_moments(moments, area)?,
                (false, Some(table)) => {
                    draft.params.set_heights_at_scores(table, moments.bandwidth(), area)?;
                    draft.height_distribution = AT_SCORES;
                }
            }
        }
        self.lay.map_or(Ok(()), |lay| draft.params.set_lay(lay))?;
        if let Some(density) = self.get("summit_density") {
            self.set_density(draft, density)?;
        }
        self.interface.map_or(Ok(()), |interface| draft.params.set_interface(interface))
    }

    fn set_fields(&self, draft: &mut Draft) -> Result<(), Error> {
        let (chosen, shape) = (self.get("height_distribution"), self.get("weibull_shape"));
        for (field, value) in FIELDS.iter().zip(self.values) {
            let Some(value) = value else { continue };
            // A skew alone is that of Weibull heights; beside others it is refused with the parameters.
            let is_weibulls = match chosen {
                None => draft.height_distribution != JOHNSON,
                Some(family) => family == f64::from(WEIBULL) && shape.is_none(),
            };
            match field.name {
                "skew" if is_weibulls => draft.set_skew(value)?,
                "weibull_shape" => draft.choose_weibull(value),
                _ => field.set(draft, value)?,
            }
            if field.name == "kurtosis" {
                draft.height_distribution = JOHNSON;
            }
        }
        Ok(())
    }

    /// m0, or Ra in its place, and m2, with m4 or the bandwidth where they are given: of Gaussian heights the mean deviation
    /// is (2/pi)^(1/2) times the standard one.
    fn moments(&self) -> Result<Option<SpectralMoments>, Error> {
        let [m0, m2, m4, ra, bandwidth] = ["m0", "m2", "m4", "Ra", "bandwidth"].map(|name| self.get(name));
        let missing =
            |name| Error::Missing { name, says: "must be given too: m2 goes with m0 or Ra, and m4 with both" };
        let m0 = match (m0, ra) {
            (Some(_), Some(_)) => return Err(meaningless("Ra: must not be given together with m0, which it replaces")),
            (None, Some(ra)) => {
                positive("Ra", ra)?;
                Some(FRAC_PI_2 * (ra * ra))
            }
            (m0, None) => m0,
        };
        let (m0, m2) = match (m0, m2) {
            (Some(m0), Some(m2)) => (m0, m2),
            (None, None) if m4.is_none() => return Ok(None),
            (None, _) => return Err(missing("m0")),
            (_, None) => return Err(missing("m2")),
        };
        let of_bandwidth = |bandwidth: f64| bandwidth * m2 * (m2 / m0);
        Ok(Some(SpectralMoments {
            m0,
            m2,
            m4: m4.filter(|m4| *m4 != 0.0).or(bandwidth.map(of_bandwidth)).unwrap_or(0.0),
        }))
    }

    fn set_density(&self, draft: &mut Draft, density: f64) -> Result<(), Error> {
        if self.get("asperity_count").is_some() {
            let says = "summit_density: must not be given together with asperity_count, which it replaces";
            return Err(meaningless(says));
        }
        positive("summit_density", density)?;
        if draft.params.nominal_area == 0.0 {
            return Err(meaningless("nominal_area: must be set, since summit_density gives the asperities per area"));
        }
        positive("nominal_area", draft.params.nominal_area)?;
        draft.params.asperity_count = density * draft.params.nominal_area;
        Ok(())
    }

    /// The measurement, where one is given: its load and the friction force.
    ///
    /// # Errors
    /// [`Error::Meaningless`] of a part of one, or of two; those of the coefficient in [`Params::calibrate`].
    pub fn measured(&self) -> Result<Option<(f64, f64)>, Error> {
        let [load, coefficient, force] =
            ["calibration_load", "calibration_friction_coefficient", "calibration_friction_force"]
                .map(|name| self.get(name));
        match (load, coefficient, force) {
            (None, None, None) => Ok(None),
            (Some(load), Some(coefficient), None) => Ok(Some((load, Params::measured_force(load, coefficient)?))),
            (Some(load), None, Some(force)) => Ok(Some((load, force))),
            _ => Err(meaningless(
                "calibration_load: must be given together with calibration_friction_coefficient or \
                 calibration_friction_force, and with one of the two alone",
            )),
        }
    }

    /// The arguments of a setter: all or none.
    fn together<const N: usize>(&self, all: [&'static str; N], says: &'static str) -> Result<Option<[f64; N]>, Error> {
        let given = all.map(|name| self.get(name));
        match given.iter().position(Option::is_none) {
            None => Ok(Some(given.map(Option::unwrap_or_default))),
            Some(_) if given.iter().all(Option::is_none) => Ok(None),
            Some(missing) => Err(Error::Missing { name: all[missing], says }),
        }
    }
}
