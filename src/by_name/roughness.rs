//! The roughness of a text: the spectral moments of the two surfaces, from whichever parameters of roughness are given.
//!
//! Of isotropic Gaussian surfaces m0 = Rq^2 = Sq^2 = pi/2 Ra^2. By areal parameters m2 = Sdq^2/2, and m4 is 9 pi/64 Ssc^2 or
//! 6 pi 3^(1/2) m2 Sds; of a profile m2 = m0 (2 pi/RSm)^2, and m4 follows from the bandwidth. Of two rough surfaces moments add.

use super::keys::{Entries, Table};
use super::toml::{Outcome, Problem, Value};
use crate::params::positive;
use crate::spectrum::SpectralMoments;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Arguments;

/// The bandwidth of a surface of which only Rq and RSm are known: the middle of 3 to 30, the range of most.
const USUAL_BANDWIDTH: f64 = 9.486_832_980_505_138;

/// What a text says of the roughness.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Roughness {
    pub moments: SpectralMoments,
    /// Summits per area, where they were counted beside their curvature.
    pub density: Option<f64>,
    /// Skew and kurtosis of the heights.
    pub shape: Option<[f64; 2]>,
}

/// Ways to describe a roughness, by the names that belong to each.
struct Kind {
    /// The name that Ra replaces.
    height: &'static str,
    names: &'static [&'static str],
    needs: &'static [&'static str],
    called: &'static str,
}

const MOMENTS: Kind =
    Kind { height: "m0", names: &["m0", "m2", "m4"], needs: &["m2", "m4"], called: "spectral moments" };
const AREAL: Kind = Kind {
    height: "Sq",
    names: &["Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku"],
    needs: &["Sdq"],
    called: "areal parameters",
};
const PROFILE: Kind = Kind { height: "Rq", names: &["Rq", "RSm"], needs: &["RSm"], called: "parameters of a profile" };

impl Roughness {
    /// What [roughness] gives, which begins at a byte of the text, with the bandwidth that the text gives beside it.
    pub fn of(entries: &Entries, begin: usize, bandwidth: Option<f64>) -> Outcome<Self> {
        let given = Given { entries, begin };
        let is_of = |kind: &&Kind| kind.names.iter().any(|name| given.at(name).is_some());
        let Some(kind) = [MOMENTS, AREAL, PROFILE].iter().find(is_of) else {
            return Err(
                given.refused("Ra", format_args!("give with it RSm, or Sdq and one of Ssc and Sds, or m2 and m4"))
            );
        };
        given.check(kind)?;
        let count = given.surfaces()?;
        let mut moments = SpectralMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
        for surface in 0..count {
            let [m0, m2, m4] = match kind.height {
                "m0" => [given.height(kind, surface)?, given.need("m2", surface)?, given.need("m4", surface)?],
                "Sq" => given.areal(kind, surface)?,
                _ => {
                    let m0 = given.height(kind, surface)?;
                    let slope = 2.0 * PI / given.need("RSm", surface)?;
                    [m0, m0 * (slope * slope), 0.0]
                }
            };
            moments = SpectralMoments { m0: moments.m0 + m0, m2: moments.m2 + m2, m4: moments.m4 + m4 };
        }
        if kind.height == "Rq" {
            let SpectralMoments { m0, m2, .. } = moments;
            moments.m4 = bandwidth.unwrap_or(USUAL_BANDWIDTH) * m2 * (m2 / m0);
        }
        let is_counted = given.at("Ssc").is_some() && given.at("Sds").is_some();
        let density = is_counted.then(|| given.need("Sds", 0)).transpose()?;
        Ok(Self { moments, density, shape: given.shape(count)? })
    }

    /// Whether the bandwidth is one of its inputs.
    pub fn reads_bandwidth(entries: &Entries) -> bool {
        entries.find(Table::Roughness, "RSm").is_some()
    }
}

/// The numbers of [roughness].
struct Given<'a> {
    entries: &'a Entries<'a>,
    begin: usize,
}

impl Given<'_> {
    #[inline(never)]
    fn at(&self, name: &str) -> Option<usize> {
        self.entries.find(Table::Roughness, name).map(|entry| entry.at)
    }

    /// A problem of a key, or of the table if it is not there.
    #[cold]
    #[inline(never)]
    fn refused(&self, name: &str, says: Arguments) -> Box<Problem> {
        Problem::new(self.at(name).unwrap_or(self.begin), format_args!("{}{name}: {says}", Table::Roughness))
    }

    /// Refuses what is not for the kind, and what it lacks.
    fn check(&self, kind: &Kind) -> Outcome<()> {
        let has = |name: &&&str| self.at(name).is_some();
        let first = kind.names.iter().find(has).unwrap_or(&kind.height);
        for name in [MOMENTS, AREAL, PROFILE].iter().flat_map(|other| other.names) {
            if self.at(name).is_some() && !kind.names.contains(name) {
                return Err(self.refused(name, format_args!("is not for {}, as {first} is", kind.called)));
            }
        }
        match (self.at("Ra"), self.at(kind.height)) {
            (Some(_), Some(_)) => {
                return Err(self.refused(
                    "Ra",
                    format_args!("must not be given together with {}, which it replaces", kind.height),
                ));
            }
            (None, None) => return Err(self.refused(kind.height, format_args!("must be set, or Ra"))),
            _ => {}
        }
        if let Some(name) = ["Ssk", "Sku"].iter().find(|name| self.at("Ra").is_some() && has(name)) {
            return Err(self.refused(
                "Ra",
                format_args!(
                    "must not be given together with {name}, it is understood as that of Gaussian heights: give Sq"
                ),
            ));
        }
        match kind.needs.iter().find(|name| self.at(name).is_none()) {
            Some(missing) => Err(self.refused(missing, format_args!("must be set"))),
            None => Ok(()),
        }
    }

    /// How many rough surfaces the numbers are of: for each key the same.
    fn surfaces(&self) -> Outcome<usize> {
        let mut first: Option<(&str, usize)> = None;
        for entry in self.entries.of(Table::Roughness).filter(|entry| entry.name != "summits") {
            let count = match &entry.value {
                Value::Number(_) => 1,
                Value::Numbers(numbers) if numbers.len() == 2 => 2,
                _ => {
                    return Err(self.refused(
                        entry.name,
                        format_args!("must be a number, or two in brackets, one of each surface"),
                    ))
                }
            };
            let (other, expected) = *first.get_or_insert((entry.name, count));
            if count != expected {
                return Err(self.refused(
                    entry.name,
                    format_args!(
                        "must be as many numbers as {other} has: one, or two in brackets, one of each surface"
                    ),
                ));
            }
        }
        Ok(first.map_or(1, |(_, count)| count))
    }

    #[inline(never)]
    fn get(&self, name: &str, surface: usize) -> Option<f64> {
        match &self.entries.find(Table::Roughness, name)?.value {
            Value::Number(number) => Some(*number),
            Value::Numbers(numbers) => numbers.get(surface).copied(),
            _ => None,
        }
    }

    /// A number > 0 that must be there.
    #[inline(never)]
    fn need(&self, name: &'static str, surface: usize) -> Outcome<f64> {
        let Some(number) = self.get(name, surface) else { return Err(self.refused(name, format_args!("must be set"))) };
        positive(name, number).map_err(|error| Problem::of(self.at(name).unwrap_or(self.begin), error))?;
        Ok(number)
    }

    /// m0 of one surface.
    #[inline(never)]
    fn height(&self, kind: &Kind, surface: usize) -> Outcome<f64> {
        if self.at("Ra").is_some() {
            let mean = self.need("Ra", surface)?;
            let deviation = FRAC_PI_2.sqrt() * mean;
            return Ok(if kind.height == "m0" { FRAC_PI_2 * (mean * mean) } else { deviation * deviation });
        }
        let height = self.need(kind.height, surface)?;
        Ok(if kind.height == "m0" { height } else { height * height })
    }

    fn areal(&self, kind: &Kind, surface: usize) -> Outcome<[f64; 3]> {
        let (m0, slope) = (self.height(kind, surface)?, self.need("Sdq", surface)?);
        let m2 = slope * slope / 2.0;
        let m4 = match (self.at("Ssc"), self.at("Sds")) {
            (Some(_), _) => {
                let curvature = self.need("Ssc", surface)?;
                9.0 * PI / 64.0 * (curvature * curvature)
            }
            (None, Some(_)) => 6.0 * PI * 3.0_f64.sqrt() * m2 * self.need("Sds", surface)?,
            (None, None) => {
                return Err(self.refused(
                    "Ssc",
                    format_args!("must be set, or Sds: Sq and Sdq do not determine how sharp the summits are"),
                ))
            }
        };
        Ok([m0, m2, m4])
    }

    /// Skew and kurtosis, where both are given, of one rough surface.
    fn shape(&self, surfaces: usize) -> Outcome<Option<[f64; 2]>> {
        let names = ["Ssk", "Sku", "Sds"].into_iter().filter(|name| self.at(name).is_some());
        if let Some(name) = names.filter(|name| *name != "Sds" || self.at("Ssc").is_some()).find(|_| surfaces > 1) {
            return Err(self.refused(name, format_args!("can be given of one rough surface alone")));
        }
        match (self.get("Ssk", 0), self.get("Sku", 0)) {
            (Some(skew), Some(kurtosis)) => Ok(Some([skew, kurtosis])),
            (None, None) => Ok(None),
            (skew, _) => {
                let missing = if skew.is_some() { "Sku" } else { "Ssk" };
                Err(self.refused(missing, format_args!("must be set: Ssk and Sku go together")))
            }
        }
    }
}
