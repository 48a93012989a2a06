//! Materials, pairs of them and interfaces, with sources, in SI units: what the contact parameters of a surface are made from.
//!
//! `bodies`, `pairs` and `interfaces` are the tables, the only place of each number. 0 and `NO_RANGE` stand for a number that no source is
//! known for: it is left out, and what needs it says so.

mod bodies;
mod interfaces;
pub(crate) mod names;
mod pairs;
mod unknown;

pub use bodies::MATERIALS;
pub use interfaces::INTERFACES;
pub use pairs::PAIRS;
use std::ffi::CStr;
pub(crate) use unknown::{no_interface, no_material, NoPair};

/// A range for which no source is known.
pub const NO_RANGE: [f64; 2] = [0.0, 0.0];

/// An isotropic elastic body.
#[derive(Debug)]
pub struct Material {
    /// By which it is found.
    pub name: &'static CStr,
    /// Other names by which it is found, capitals or not.
    pub words: &'static [&'static str],
    /// Young's modulus, in Pa.
    pub young: f64,
    /// The range of published values, in Pa.
    pub young_range: [f64; 2],
    /// Poisson's ratio.
    pub poisson: f64,
    /// Indentation hardness, in Pa.
    pub hardness: f64,
    /// The range of published values, in Pa.
    pub hardness_range: [f64; 2],
    /// What it was measured of.
    pub state: &'static str,
    /// Burgers vector, in m; in a glass the distance of like atoms.
    pub burgers_vector: f64,
    /// The metal that it is one of, or an alloy of; empty of what is no metal.
    pub family: &'static str,
    /// Where the numbers are from.
    pub reference: &'static CStr,
}

/// Two bodies and what holds them together.
#[derive(Debug)]
pub struct Pair {
    /// The names of both, with a slash between.
    pub name: &'static CStr,
    /// w [J/m^2].
    pub work_of_adhesion: f64,
    /// The range of measurements and estimates [J/m^2].
    pub work_of_adhesion_range: [f64; 2],
    /// The Hamaker constant A, in J, from which w is estimated, A/(12 pi D^2) with D = 0.165 nm.
    pub hamaker: f64,
    /// Measured shear strength of small contacts over G*.
    pub slip_stress_1: f64,
    /// Where w and the strength are from.
    pub reference: &'static CStr,
}

/// What was measured of the strength of an interface, under its own conditions: a start for one like it.
#[derive(Debug, PartialEq)]
pub struct Interface {
    /// By which it is found: what touches, and the film or the surroundings.
    pub name: &'static CStr,
    /// tau_0, in Pa: what a contact resists over its area, at no pressure.
    pub shear_strength: f64,
    /// kappa: what the strength grows by with the pressure.
    pub pressure_coefficient: f64,
    /// Measured over many contacts, where the strength of one is not known.
    pub friction_coefficient: f64,
    /// The lightest load [N] of that measurement.
    pub load: f64,
    /// Bodies, film, humidity, vacuum, temperature and loads, as far as they are known.
    pub conditions: &'static CStr,
    /// "read": the numbers were seen in the text that the reference names; "quoted": they were not.
    pub source: &'static CStr,
    /// Where the numbers are from.
    pub reference: &'static CStr,
}

impl Interface {
    /// The interface of this name.
    pub fn find(name: impl AsRef<[u8]>) -> Option<&'static Self> {
        INTERFACES.iter().find(|interface| interface.name.to_bytes() == name.as_ref())
    }

    /// Those of two bodies without a lubricant, whatever else is said of them: "steel/steel dry".
    pub fn of_bodies(bodies: &Bodies) -> Vec<&'static Self> {
        Self::dry(bodies, |body| body.name.to_bytes())
    }

    /// Those of metals of the same two families without a lubricant.
    pub fn of_families(bodies: &Bodies) -> Vec<&'static Self> {
        match bodies.are_metals() {
            true => Self::dry(bodies, |body| body.family.as_bytes()),
            false => Vec::new(),
        }
    }

    /// Those without a lubricant of two materials of the table that have something in common with two bodies.
    fn dry(bodies: &Bodies, of: fn(&Material) -> &[u8]) -> Vec<&'static Self> {
        let wanted = [bodies.first, bodies.second].map(of);
        let is_of = |interface: &&Self| {
            let Some((one, other)) = halves(interface.name.to_bytes()) else { return false };
            let mut words = other.split(|&byte| byte == b' ');
            let named = |name: &[u8]| MATERIALS.iter().find(|material| material.name.to_bytes() == name);
            let (Some(one), Some(other)) = (named(one), named(words.next().unwrap_or_default())) else { return false };
            let is_lubricated = words.next().is_some_and(|word| [&b"with"[..], b"greased"].contains(&word));
            !is_lubricated && ([of(one), of(other)] == wanted || [of(other), of(one)] == wanted)
        };
        INTERFACES.iter().filter(is_of).collect()
    }
}

impl Pair {
    /// The pair of this name, or of the same bodies in the other order.
    pub fn find(name: impl AsRef<[u8]>) -> Option<&'static Self> {
        Bodies::find(name)?.pair()
    }
}

/// Two materials by the name of their pair, listed or not, and what follows from both.
#[derive(Debug, Clone, Copy)]
pub struct Bodies {
    /// The one before the slash.
    pub first: &'static Material,
    /// The one behind it.
    pub second: &'static Material,
}

impl Bodies {
    /// Two materials with a slash between, as "steel/mica"; None if one of them is no material.
    pub fn find(name: impl AsRef<[u8]>) -> Option<Self> {
        let (first, second) = halves(name.as_ref())?;
        Some(Self { first: Material::find(first)?, second: Material::find(second)? })
    }

    /// What holds them together, where it is known.
    pub fn pair(&self) -> Option<&'static Pair> {
        let (first, second) = (self.first.name.to_bytes(), self.second.name.to_bytes());
        let is_of = |both| both == (first, second) || both == (second, first);
        PAIRS.iter().find(|pair| halves(pair.name.to_bytes()).is_some_and(is_of))
    }

    /// Whether both are metals.
    pub fn are_metals(&self) -> bool {
        !self.first.family.is_empty() && !self.second.family.is_empty()
    }

    /// The longer Burgers vector; None if one of them has none.
    pub fn burgers_vector(&self) -> Option<f64> {
        let (first, second) = (self.first.burgers_vector, self.second.burgers_vector);
        (first > 0.0 && second > 0.0).then(|| first.max(second))
    }

    /// The hardness of the softer body; 0 if that of one of them is not known.
    pub fn hardness(&self) -> f64 {
        self.softer().hardness
    }

    /// The softer body, or one whose hardness is not known.
    pub fn softer(&self) -> &'static Material {
        match self.first.hardness <= self.second.hardness {
            true => self.first,
            false => self.second,
        }
    }
}

impl Material {
    /// The material of this name or of one of its words, capitals or not: "Au", "gold".
    pub fn find(name: impl AsRef<[u8]>) -> Option<&'static Self> {
        let is_name = |word: &[u8]| name.as_ref().eq_ignore_ascii_case(word);
        MATERIALS.iter().find(|material| {
            is_name(material.name.to_bytes()) || material.words.iter().any(|word| is_name(word.as_bytes()))
        })
    }
}

/// The names on both sides of the slash, without spaces around them.
pub fn halves(name: &[u8]) -> Option<(&[u8], &[u8])> {
    let slash = name.iter().position(|&byte| byte == b'/')?;
    Some((name[..slash].trim_ascii(), name[slash + 1..].trim_ascii()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_means_a_material() {
        for (material, word) in MATERIALS.iter().flat_map(|one| one.words.iter().map(move |word| (one, word))) {
            assert_eq!(Material::find(word).map(|found| found.name), Some(material.name), "{word}");
            assert_eq!(Material::find(word.to_uppercase()).map(|found| found.name), Some(material.name), "{word}");
        }
        assert!(Material::find("unobtainium").is_none());
        assert!(["", "Si", "Si/", "/Si", "Si/Si/Si"].iter().all(|none| Bodies::find(none).is_none()));
    }
}
