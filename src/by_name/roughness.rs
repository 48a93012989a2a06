//! The roughness of a text: the spectral moments of the two surfaces, from whichever parameters of roughness are given.
//!
//! Isotropic Gaussian surfaces have m0 = Rq^2 = Sq^2 = pi/2 Ra^2. By areal parameters m2 = Sdq^2/2, of a profile m2 = Rdq^2 or
//! m0 (2 pi/RSm)^2. m4, where it is known, is 9 pi/64 Ssc^2 or 6 pi 3^(1/2) m2 Sds, or follows from the bandwidth. Moments of two
//! rough surfaces add.

use super::keys::{Entries, Table};
use super::toml::{Outcome, Problem, Value};
use crate::distribution::at_scores::AtScores;
use crate::estimate::known::{machined_slope, Process, PROCESSES};
use crate::estimate::priors::{self, Shape};
use crate::params::shapes::{self, Heights};
use crate::params::spectrum::SpectralMoments;
use crate::params::{check_lay, positive, HeightFamily, Params, STEEPEST_SURFACE};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2, PI};
use std::fmt::Arguments;
use std::ops::RangeInclusive;

/// No surface that slides has more [m].
const HIGHEST: f64 = 1e-3;
/// The widest elements of a profile that a standard has a cutoff for (8 mm, ISO 4288) [m].
const WIDEST: f64 = 4e-3;

/// No surface that slides was measured to be steeper along a profile: 63 degrees. Beyond it is the slope in another unit.
const STEEPEST_GIVEN: f64 = 2.0;
/// What heights and widths of surfaces that slide usually are [m]: in which unit a number is likely to be.
const HEIGHT_RANGE: RangeInclusive<f64> = 1e-10..=1e-4;
const WIDTH_RANGE: RangeInclusive<f64> = 1e-8..=WIDEST;

/// Heights and root mean square slopes at normal scores.
const HEIGHTS: &str = "heights_at_scores";
const SLOPES: &str = "slopes_at_scores";

/// What a text says of the roughness.
#[derive(Debug, Clone, PartialEq)]
pub struct Roughness {
    /// m4 is 0 where nothing is said of it.
    pub moments: SpectralMoments,
    /// Summits per area, where they were counted beside their curvature.
    pub density: Option<f64>,
    /// Heights and slopes of a surface that is not Gaussian, at normal scores.
    pub at_scores: Option<[Heights; 2]>,
    /// The slope across the lay over that along it.
    pub lay: Option<f64>,
    pub machined: Option<Machined>,
}

/// What of a roughness is that of a process, not measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Machined {
    pub process: &'static Process,
    pub has_height: bool,
    pub has_slope: bool,
    /// Root mean square slope of the profiles of both surfaces.
    pub slope: f64,
    /// Ra that the process does not leave.
    pub unusual: Option<f64>,
}

/// Ways to describe a roughness, by the names that belong to each.
struct Kind {
    /// The name that Ra replaces.
    height: &'static str,
    names: &'static [&'static str],
    /// One of these gives m2.
    slopes: &'static [&'static str],
    /// One of these, or all in turn, gives m4.
    curvatures: &'static [&'static str],
    /// What to give where no slope is known.
    otherwise: &'static str,
    called: &'static str,
}

const MOMENTS: Kind = Kind {
    height: "m0",
    names: &["m0", "m2", "m4"],
    slopes: &["m2"],
    curvatures: &["m4"],
    otherwise: "the mean square slope of a profile; if it is not known, give Rq with RSm or process in place of m0",
    called: "spectral moments",
};
const AREAL: Kind = Kind {
    height: "Sq",
    names: &["Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku", "Spq", "Svq", "Smq", HEIGHTS, SLOPES, "Sdq_top"],
    slopes: &["Sdq"],
    curvatures: &["Ssc", "Sds"],
    otherwise: "the slope of the map; if it is not known, give Rq with RSm or process in place of Sq, or guess it and set slope = 4 in [known_to]",
    called: "areal parameters",
};
const PROFILE: Kind = Kind {
    height: "Rq",
    names: &["Rq", "RSm", "Rdq", "RSm_along", "Rdq_along", "process"],
    slopes: &["RSm", "Rdq"],
    curvatures: &[],
    otherwise: "or Rdq, or process if neither was measured",
    called: "parameters of a profile",
};
const KINDS: [&Kind; 3] = [&MOMENTS, &AREAL, &PROFILE];

/// What a table tells of the shape of heights that parameters were made of.
pub fn shape(entries: &Entries, table: Table, params: &Params, machined: Option<&Machined>) -> &'static Shape {
    let has = |names: &[&str]| names.iter().any(|name| entries.find(table, name).is_some());
    let is_said = entries.find(Table::Top, "height_distribution").is_some();
    match (&params.heights, machined) {
        (HeightFamily::AtScores { .. }, _) if has(&["Sdq_top"]) => &priors::TOP,
        (HeightFamily::AtScores { .. }, _) if has(&["Sdq"]) && !has(&[SLOPES]) => &priors::HEIGHTS,
        (HeightFamily::AtScores { .. }, _) => &priors::TABLE,
        (_, Some(machined)) if !machined.process.leaves_plateaus() => &priors::SUMMITS,
        _ if !is_said && params.rms_slope > 0.0 && params.heights == HeightFamily::Gaussian => &priors::ALONE,
        _ => &priors::SUMMITS,
    }
}

impl Roughness {
    /// What [roughness], or another table like it, gives, which begins at a byte of the text, with the bandwidth that the text gives beside it.
    pub fn of(entries: &Entries, table: Table, begin: usize, bandwidth: Option<f64>) -> Outcome<Self> {
        let mut given = GivenRoughness { entries, table, begin, process: None };
        given.process = given.process()?;
        let is_of = |kind: &&Kind| kind.names.iter().any(|name| given.at(name).is_some());
        let Some(kind) = KINDS.into_iter().find(is_of) else {
            return Err(given.refused("Ra", format_args!("give with it RSm or Rdq, or process, or Sdq, or m2")));
        };
        given.check(kind)?;
        let count = given.surfaces()?;
        given.check_metres()?;
        given.check_alone(count)?;
        let lay = given.lay()?;
        let at_scores = given.at_scores()?;
        let mut moments = SpectralMoments { m0: 0.0, m2: 0.0, m4: 0.0 };
        for surface in 0..count {
            let (m0, m2) = match &at_scores {
                Some(table) => given.moments_of(table)?,
                None => (given.height(kind, surface)?, given.slope(kind, surface)?),
            };
            given.check_slope(kind, m2)?;
            let m4 = given.curvature(m2, surface)?;
            moments = SpectralMoments { m0: moments.m0 + m0, m2: moments.m2 + m2, m4: moments.m4 + m4 };
        }
        if let Some(bandwidth) = bandwidth {
            moments.m4 = bandwidth * moments.m2 * (moments.m2 / moments.m0);
        }
        let is_counted = given.at("Ssc").is_some() && given.at("Sds").is_some();
        let density = is_counted.then(|| given.need("Sds", 0)).transpose()?;
        let machined = given.process.map(|process| {
            let has = |names: &[&str]| names.iter().any(|name| given.at(name).is_some());
            let heights = (0..count).filter_map(|surface| given.height(kind, surface).ok());
            let [least, most] = process.mean_deviation;
            let mean_deviations = heights.map(|m0| (m0 / FRAC_PI_2).sqrt());
            let unusual = |ra: &f64| *ra < least * (1.0 - 1e-9) || *ra > most * (1.0 + 1e-9);
            let has_height = has(&["Ra", kind.height]);
            Machined {
                process,
                has_height,
                has_slope: has(kind.slopes),
                slope: moments.m2.sqrt(),
                unusual: mean_deviations.into_iter().find(unusual).filter(|_| has_height),
            }
        });
        Ok(Self { moments, density, at_scores, lay, machined })
    }

    /// Whether it says m4, so that no bandwidth is to be given beside it.
    pub fn gives_curvature(entries: &Entries, table: Table) -> bool {
        let names = KINDS.into_iter().flat_map(|kind| kind.curvatures);
        names.into_iter().any(|name| entries.find(table, name).is_some())
    }
}

/// The numbers of [roughness].
struct GivenRoughness<'a> {
    entries: &'a Entries<'a>,
    table: Table,
    begin: usize,
    process: Option<&'static Process>,
}

impl GivenRoughness<'_> {
    #[inline(never)]
    fn at(&self, name: &str) -> Option<usize> {
        self.entries.find(self.table, name).map(|entry| entry.at)
    }

    /// A problem of a key, or of the table if it is not there.
    #[cold]
    #[inline(never)]
    fn refused(&self, name: &str, says: Arguments) -> Box<Problem> {
        Problem::new(self.at(name).unwrap_or(self.begin), format_args!("{}{name}: {says}", self.table))
    }

    /// How the surfaces were machined, where that is given.
    fn process(&self) -> Outcome<Option<&'static Process>> {
        let Some(entry) = self.entries.find(self.table, "process") else { return Ok(None) };
        let names = PROCESSES.iter().map(|process| process.name);
        let found = match &entry.value {
            Value::Word(word) => Process::find(word),
            _ => None,
        };
        let process = found.ok_or_else(|| {
            let names = names.collect::<Vec<_>>().join(", ");
            Problem::new(entry.at, format_args!("{}process = {}: must be one of {names}", self.table, entry.value))
        });
        process.map(Some)
    }

    /// Refuses what is not for the kind, and what it lacks.
    fn check(&self, kind: &Kind) -> Outcome<()> {
        let has = |name: &&&str| self.at(name).is_some();
        let first = kind.names.iter().find(has).unwrap_or(&kind.height);
        for name in KINDS.into_iter().flat_map(|other| other.names) {
            if self.at(name).is_some() && !kind.names.contains(name) {
                return Err(self.refused(name, format_args!("is not for {}, as {first} is", kind.called)));
            }
        }
        let (ra, height) = (self.at("Ra"), self.at(kind.height));
        if ra.is_some() && height.is_some() {
            let says = format_args!("must not be given together with {}, which it replaces", kind.height);
            return Err(self.refused("Ra", says));
        }
        if ra.or(height).or(self.at(HEIGHTS)).or(self.at("Spq")).is_none() && self.process.is_none() {
            return Err(self.refused(kind.height, format_args!("must be set, or Ra in its place")));
        }
        let shapes = ["Ssk", "Sku", "Spq", "Svq", "Smq", HEIGHTS];
        let given: Vec<_> = shapes.into_iter().filter(|name| self.at(name).is_some()).collect();
        if let (Some(name), true) = (given.first(), self.at("Ra").is_some()) {
            let says = "it is understood as that of Gaussian heights: give Sq";
            return Err(self.refused("Ra", format_args!("must not be given together with {name}, {says}")));
        }
        let is_whole = |names: &[&str]| given.iter().all(|name| names.contains(name));
        let is_measured = given.iter().any(|name| !["Ssk", "Sku"].contains(name));
        if let (true, Some(name)) = (is_measured, given.first()) {
            if self.at("Sq").is_some() || !(is_whole(&[HEIGHTS]) || is_whole(&["Spq", "Svq", "Smq"])) {
                let all = "heights are given by Sq with Ssk and Sku, by Spq, Svq and Smq, or by heights_at_scores: leave the others out";
                return Err(self.refused(name, format_args!("{all}")));
            }
        }
        match (kind.slopes.iter().filter(|name| self.at(name).is_some()).count(), self.at(SLOPES).is_some()) {
            (0, has_slopes) if self.process.is_some() || has_slopes => Ok(()),
            (1, false) => Ok(()),
            (0, _) => Err(self.refused(kind.slopes[0], format_args!("must be set, {}", kind.otherwise))),
            (1, true) => {
                let says = format_args!("must not be given together with {SLOPES}, which it replaces");
                Err(self.refused(kind.slopes[0], says))
            }
            _ => Err(self.refused("Rdq", format_args!("must not be given together with RSm, which it replaces"))),
        }
    }

    /// Refuses lengths in another unit, where bodies of the tables, a process or the Burgers vector tell that they are to be in m.
    fn check_metres(&self) -> Outcome<()> {
        let given = |table, name| self.entries.find(table, name);
        let of_tables = [(Table::Top, "pair"), (Table::Materials, "first"), (Table::Materials, "second")];
        let is_crystal = given(Table::Top, "burgers_vector")
            .is_some_and(|entry| matches!(entry.value, Value::Number(number) if (1e-10..=1e-9).contains(&number)));
        if !is_crystal && self.process.is_none() && !of_tables.iter().any(|&(table, name)| given(table, name).is_some())
        {
            return Ok(());
        }
        for name in ["Ra", "Rq", "Sq", "Spq", "Svq", HEIGHTS, "RSm"] {
            let (most, likely) = if name == "RSm" { (WIDEST, WIDTH_RANGE) } else { (HIGHEST, HEIGHT_RANGE) };
            if let Some(value) = self.numbers(name).iter().copied().find(|length| length.abs() > most) {
                let units = [("mm", 1e-3), ("um", 1e-6), ("nm", 1e-9)];
                let meant = units.into_iter().filter(|(_, metres)| likely.contains(&(value.abs() * metres)));
                let meant = meant.map(|(unit, _)| unit).collect::<Vec<_>>().join(" or ");
                let asked = if meant.is_empty() { String::new() } else { format!("; is it in {meant}?") };
                let value = Value::Number(value);
                let says = format_args!("{}{name} = {value}: must be in m, and at most {most:e}{asked}", self.table);
                return Err(Problem::new(self.at(name).unwrap_or(self.begin), says));
            }
        }
        Ok(())
    }

    /// Refuses a slope that no surface has, by the name that gives it.
    fn check_slope(&self, kind: &Kind, m2: f64) -> Outcome<()> {
        let given = kind.slopes.iter().chain([&SLOPES]).find(|name| self.at(name).is_some());
        let slope = m2.sqrt();
        if slope <= given.map_or(STEEPEST_SURFACE * FRAC_1_SQRT_2, |_| STEEPEST_GIVEN) {
            return Ok(());
        }
        let (name, says) = match given {
            Some(&"RSm") => ("RSm", "are Ra or Rq and RSm in one unit?"),
            Some(&"m2") => ("m2", "is it the square of a slope, and the slope not in degrees or per cent?"),
            Some(name) => (*name, "is it in degrees or per cent? A slope is the tangent of its angle"),
            None if self.at("Rq").is_some() => ("Rq", "is it in another unit?"),
            None => ("Ra", "is it in another unit?"),
        };
        let slope = Value::Number(slope);
        Err(self.refused(name, format_args!("makes a slope of {slope} along a profile, which no surface has; {says}")))
    }

    /// How many rough surfaces the numbers are of: for each key the same.
    fn surfaces(&self) -> Outcome<usize> {
        let mut first: Option<(&str, usize)> = None;
        for entry in self.entries.of(self.table).filter(|entry| {
            let is_one = KINDS.iter().any(|kind| kind.names.contains(&entry.name)) || entry.name == "Ra";
            is_one && !["process", HEIGHTS, SLOPES].contains(&entry.name)
        }) {
            let one_each = "one, or two in brackets, one of each surface";
            let count = match &entry.value {
                Value::Number(_) => 1,
                Value::Numbers(numbers) if numbers.len() == 2 => 2,
                _ => {
                    let says = "must be a number, or two in brackets, one of each surface";
                    return Err(self.refused(entry.name, format_args!("{says}")));
                }
            };
            let (other, expected) = *first.get_or_insert((entry.name, count));
            if count != expected {
                let says = format_args!("must be as many numbers as {other} has: {one_each}");
                return Err(self.refused(entry.name, says));
            }
        }
        Ok(first.map_or(1, |(_, count)| count))
    }

    /// The numbers of a key, none if it is not there.
    fn numbers(&self, name: &str) -> &[f64] {
        match self.entries.find(self.table, name).map(|entry| &entry.value) {
            Some(Value::Number(number)) => std::slice::from_ref(number),
            Some(Value::Numbers(numbers)) => numbers,
            _ => &[],
        }
    }

    #[inline(never)]
    fn get(&self, name: &str, surface: usize) -> Option<f64> {
        self.numbers(name).get(surface).copied()
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
        if let (None, Some(process)) = (self.at(kind.height), self.process) {
            let mean = process.middle_and_factor().0;
            return Ok(FRAC_PI_2 * (mean * mean));
        }
        let height = self.need(kind.height, surface)?;
        Ok(if kind.height == "m0" { height } else { height * height })
    }

    /// m2 of one surface: that of a profile is measured across a lay.
    fn slope(&self, kind: &Kind, surface: usize) -> Outcome<f64> {
        let m2 = self.slope_across(kind, surface)?;
        let is_profile = kind.slopes.contains(&"Rdq");
        let lay = if is_profile { self.lay()? } else { None };
        Ok(lay.map_or(m2, |lay| 0.5 * m2 * (1.0 + 1.0 / (lay * lay))))
    }

    fn slope_across(&self, kind: &Kind, surface: usize) -> Outcome<f64> {
        let named = kind.slopes.iter().find(|name| self.at(name).is_some());
        if named.is_none() && self.process.is_some() {
            let slope = machined_slope(self.height(kind, surface)?.sqrt());
            return Ok(slope * slope);
        }
        let named = named.unwrap_or(&kind.slopes[0]);
        let number = self.need(named, surface)?;
        Ok(match *named {
            "m2" => number,
            "Sdq" => number * number / 2.0,
            "Rdq" => number * number,
            _ => {
                let wave_number = 2.0 * PI / number;
                self.height(kind, surface)? * (wave_number * wave_number)
            }
        })
    }

    /// m4 of one surface, 0 where nothing is said of it.
    fn curvature(&self, m2: f64, surface: usize) -> Outcome<f64> {
        if self.at("m4").is_some() {
            return self.need("m4", surface);
        }
        if self.at("Ssc").is_some() {
            let curvature = self.need("Ssc", surface)?;
            return Ok(9.0 * PI / 64.0 * (curvature * curvature));
        }
        let density = self.at("Sds").map(|_| self.need("Sds", surface)).transpose()?;
        Ok(6.0 * PI * 3.0_f64.sqrt() * m2 * density.unwrap_or(0.0))
    }

    /// Refuses what describes one rough surface where there are two.
    fn check_alone(&self, surfaces: usize) -> Outcome<()> {
        let alone = ["Ssk", "Sku", "Spq", "Svq", "Smq", HEIGHTS, SLOPES, "lay", "Rdq_along", "RSm_along", "Sds"];
        let is_given = |name: &&str| self.at(name).is_some() && (*name != "Sds" || self.at("Ssc").is_some());
        match alone.into_iter().find(is_given).filter(|_| surfaces > 1) {
            Some(name) => Err(self.refused(name, format_args!("can be given of one rough surface alone"))),
            None => Ok(()),
        }
    }

    /// The ratio of the slopes across and along a lay, where it is given.
    fn lay(&self) -> Outcome<Option<f64>> {
        let mut given = ["lay", "Rdq_along", "RSm_along"].into_iter().filter(|name| self.at(name).is_some());
        let Some(name) = given.next() else { return Ok(None) };
        if let Some(other) = given.next() {
            let says = format_args!("must not be given together with {name}, which says the same");
            return Err(self.refused(other, says));
        }
        let number = self.need(name, 0)?;
        let lay = match name {
            "lay" => number,
            "Rdq_along" => self.need("Rdq", 0)? / number,
            _ => number / self.need("RSm", 0)?,
        };
        check_lay(lay).map_err(|error| self.refused(name, format_args!("{error}")))?;
        Ok(Some(lay))
    }

    /// The heights and slopes of a surface of which more is given than a Gaussian one has.
    fn at_scores(&self) -> Outcome<Option<[Heights; 2]>> {
        let at = |name: &str, error| Problem::of(self.at(name).unwrap_or(self.begin), error);
        let (height, power) = match () {
            () if self.at(HEIGHTS).is_some() => (self.table(HEIGHTS)?, shapes::POWER_OF_HEIGHTS),
            () if self.at("Spq").or(self.at("Svq")).or(self.at("Smq")).is_some() => {
                let [spq, svq, smq] = [self.need("Spq", 0)?, self.need("Svq", 0)?, self.need("Smq", 0)?];
                if smq >= 1.0 {
                    let says = "must be below 1: it is a part of the surface; is it in per cent?";
                    return Err(self.refused("Smq", format_args!("{says}")));
                }
                (shapes::plateau(spq, svq, smq), shapes::POWER_OF_HEIGHTS)
            }
            () if self.at("Ssk").or(self.at("Sku")).is_some() => {
                let shape = ["Ssk", "Sku"].map(|name| self.get(name, 0));
                let [Some(skew), Some(kurtosis)] = shape else {
                    let missing = if shape[0].is_some() { "Sku" } else { "Ssk" };
                    return Err(self.refused(missing, format_args!("must be set: Ssk and Sku go together")));
                };
                let height = self.need("Sq", 0)?;
                let standard = shapes::skewed(skew, kurtosis).map_err(|error| {
                    let key = if error.name() == Some("skew") { "Ssk" } else { "Sku" };
                    self.refused(key, format_args!("{error}"))
                })?;
                (standard.map(|z| height * z), shapes::POWER_OF_SKEW)
            }
            () => return Ok(None),
        };
        let slope = match (self.at(SLOPES), self.at("Sdq_top")) {
            (Some(_), Some(_)) => {
                return Err(self.refused("Sdq_top", format_args!("must not be given together with {SLOPES}")))
            }
            (Some(_), None) => self.table(SLOPES)?,
            (None, Some(_)) => shapes::slopes_of_top(&height, self.need("Sdq", 0)?, self.need("Sdq_top", 0)?)
                .map_err(|error| at("Sdq_top", error))?,
            (None, None) => shapes::slopes(&height, self.need("Sdq", 0)?, power),
        };
        Ok(Some([height, slope]))
    }

    /// The numbers of a key at the scores.
    fn table(&self, name: &'static str) -> Outcome<Heights> {
        let numbers = self.numbers(name);
        numbers.try_into().map_err(|_| {
            let says = "one for each normal score from -3 to 3 in steps of 0.5, in brackets";
            self.refused(name, format_args!("{} numbers for 13: {says}", numbers.len()))
        })
    }

    /// m0 and m2 of a table.
    fn moments_of(&self, [height, slope]: &[Heights; 2]) -> Outcome<(f64, f64)> {
        let whole = AtScores::new(height, slope).map_err(|error| {
            let name = if error.name() == Some(SLOPES) { SLOPES } else { HEIGHTS };
            Problem::of(self.at(name).unwrap_or(self.begin), error)
        });
        whole.map(|(_, whole)| (whole.height * whole.height, 0.5 * whole.slope * whole.slope))
    }
}
