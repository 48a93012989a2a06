//! What a text makes of parameters.

use super::draft::{Draft, AT_SCORES, TABULATED};
use super::fields::{FIELDS, FLAG};
use super::keys::{Entries, Entry, Table};
use super::numbers::{names, Numbers};
use super::roughness::{shape, Machined, Roughness};
use super::toml::{text, Outcome, Problem, Value};
use crate::distribution::tabulated;
use crate::error::Error;
use crate::estimate::known::SUMMIT_PRODUCT;
use crate::estimate::priors::{Class, Shape, CLASSES, ROW_PRESSURE, USUAL_WORK};
use crate::materials::{no_interface, no_material, Bodies, Interface, Material, NoPair};
use crate::model::calibration::MeasuredPoint;
use crate::numerics::float_bits::nan;
use crate::params::{positive, ContactLawKind, HeightFamily, Params};
use std::fmt::Arguments;
use std::sync::Arc;

/// The coverage of a band where the text gives none.
const DEFAULT_COVERAGE: f64 = 0.95;
/// More measured points than these need a fit.
const MOST_POINTS: usize = 64;
/// Names of bodies, and the numbers in their place.
const BODIES: [(&str, [&str; 2]); 2] = [("first", ["E1", "nu1"]), ("second", ["E2", "nu2"])];
/// What the bodies set, but for what may be given beside them.
const MODULI: &[&str] = &["composite_modulus", "effective_shear_modulus", "tangential_modulus"];
/// What the roughness sets.
#[rustfmt::skip]
const SUMMITS: &[&str] = &[
    "height_std", "summit_radius", "asperity_count", "summit_density", "radius_amplitude", "radius_rate",
    "summit_mean_height", "rms_slope",
];
/// The words for the summits of a roughness.
const KINDS_OF_SUMMITS: &[&str] = &["moments", "mccool"];
/// What an interface sets.
const STRENGTH: &[&str] = &["slip_stress_1", "slip_stress_2", "pressure_coefficient"];
/// What chooses heights.
const SHAPES: &[&str] = &["weibull_shape", "skew", "kurtosis", "table_height", "table_density"];

/// Sets what a text gives; of what it does not, all stays as it is. `solve` says which strength and contact law an estimate of the
/// text takes, where the text tells a strength.
///
/// # Errors
/// [`Error::InText`], with the line; [`Error::Meaningless`] of a text that is too long. The draft is of no use then.
pub fn read(
    bytes: &[u8],
    draft: &mut Draft,
    solve: impl FnOnce(Described) -> Result<Params, Error>,
) -> Result<(), Error> {
    in_text(bytes, |entries| {
        let described = entries.describe(draft)?;
        let params = match described.tells_strength() {
            true => solve(described),
            false => described.interface_alone().and_then(|()| described.with_law(described.params.clone())),
        };
        let params = params.map_err(|error| entries.problem(error, entries.measured()))?;
        draft.params = Params { heights: draft.params.heights.clone(), ..params };
        Ok(())
    })
}

/// Does something with the entries of a text.
fn in_text<T>(bytes: &[u8], with: impl FnOnce(&Entries) -> Outcome<T>) -> Result<T, Error> {
    let found = Entries::read(text(bytes)?).and_then(|entries| with(&entries));
    found.map_err(|problem| problem.in_text(bytes))
}

/// What a text says of surfaces and of what was measured on them.
pub struct Described {
    /// With the strength as it is before the points.
    pub params: Params,
    /// Those that the points were measured on, where they are others.
    pub measured_on: Option<Measured>,
    pub points: Vec<MeasuredPoint>,
    /// On how many specimens they were measured, where it is said.
    pub specimens: Option<f64>,
    /// Whether they are what a model has rather than what specimens have.
    pub is_of_law: bool,
    /// Whether the points may set the pressure coefficient, since nothing else does.
    pub pressure_is_free: bool,
    /// The size effect, where it is given: slip stresses are 30 to the power of it apart.
    pub size_effect: Option<f64>,
    pub class: &'static Class,
    pub known_to: KnownTo,
    /// What is told of the shape of the heights.
    pub shape: &'static Shape,
    /// How far real interfaces leave the law, over what is usual.
    pub model_error: f64,
    /// Probability of a band.
    pub coverage: f64,
    pub bodies: Option<Bodies>,
    /// What is given in place of what is known of the bodies.
    pub has_moduli: bool,
    pub has_hardness: bool,
    pub has_adhesion: bool,
    /// That which is named; of one without a strength the parameters have nothing.
    pub interface: Option<&'static Interface>,
    /// Whether slip stresses are given, or were set before a text that is a part.
    pub has_stress: bool,
    /// Whether the text describes a surface by itself.
    pub is_whole: bool,
    /// Whether summits may yield, since a text that is whole leaves open the contact law, and adhesion of elastic contacts.
    pub law_is_open: bool,
    /// What of the roughness is that of a process.
    pub machined: Option<Machined>,
    /// Whether the text says neither how large the nominal area is nor how many summits there are: it is of 1 m^2 then.
    pub is_of_pressures: bool,
}

/// The specimen that was measured.
pub struct Measured {
    pub params: Params,
    pub machined: Option<Machined>,
    /// What is told of the shape of its heights, where it has a roughness of its own.
    pub shape: Option<&'static Shape>,
}

/// Factors within which 95 % of the true inputs are, where a text gives them.
#[derive(Debug, Clone, Copy, Default)]
pub struct KnownTo {
    pub slope: Option<f64>,
    pub hardness: Option<f64>,
    pub work: Option<f64>,
    pub young: Option<f64>,
}

/// Above this plasticity index summits yield (Greenwood and Williamson, Proc. R. Soc. A 295, 1966).
const PLASTIC_INDEX: f64 = 1.0;

impl Described {
    /// The nominal area, or that of a surface with so many summits.
    pub fn area(&self) -> f64 {
        let Params { nominal_area, asperity_count, height_std, summit_radius, .. } = self.params;
        match nominal_area > 0.0 {
            true => nominal_area,
            false => asperity_count * height_std * summit_radius / SUMMIT_PRODUCT,
        }
    }

    /// The load of a usual nominal pressure on this area.
    pub fn usual_load(&self) -> f64 {
        let Params { length_unit, force_unit, .. } = self.params;
        ROW_PRESSURE * self.area() * (length_unit * length_unit / force_unit)
    }

    /// Whether the strength follows from the text.
    pub fn tells_strength(&self) -> bool {
        let has_strength = self.has_stress || self.interface.is_some_and(|one| one.shear_strength > 0.0);
        !self.points.is_empty() || (self.is_whole && !has_strength)
    }

    /// Refuses an interface that has no strength for what is not whole.
    fn interface_alone(&self) -> Result<(), Error> {
        match self.interface.filter(|interface| interface.shear_strength == 0.0) {
            Some(interface) if !self.is_whole => Err(Error::NoStrength { interface }),
            _ => Ok(()),
        }
    }

    /// Whether summits more probably yield than not, where the text leaves it open.
    pub fn yields(&self) -> bool {
        self.law_is_open && self.params.plasticity_index() > PLASTIC_INDEX
    }

    /// Parameters with the contact law of the text.
    ///
    /// # Errors
    /// Those of [`Params::set_elastic_plastic`].
    pub fn with_law(&self, mut params: Params) -> Result<Params, Error> {
        if self.yields() {
            params.set_elastic_plastic(params.hardness)?;
        }
        Ok(params)
    }
}

/// Does something with what a text says; an error of it is told where the measured points are, if its parameter is not given.
///
/// # Errors
/// Those of [`read`].
pub fn describe<T>(bytes: &[u8], with: impl FnOnce(Described) -> Result<T, Error>) -> Result<T, Error> {
    in_text(bytes, |entries| {
        let mut draft = Draft::default();
        let is_of_pressures = entries.gives_no_area();
        if is_of_pressures {
            draft.params.nominal_area = 1.0;
        }
        let described = Described { is_of_pressures, ..entries.describe(&mut draft)? };
        let params = &described.params;
        params.check_not_converted().map_err(|error| entries.problem(error, None))?;
        params.surface().map_err(|error| entries.blamed(error))?;
        with(described).map_err(|error| entries.problem(error, entries.measured()))
    })
}

/// Sets what a law without adhesion does not need, where it was not set: metal that yields does not adhere.
fn without_adhesion(params: &mut Params) {
    let yields = params.contact_law == ContactLawKind::ElasticPlastic || params.plasticity_index() > PLASTIC_INDEX;
    if nan(params.work_of_adhesion) && yields {
        params.work_of_adhesion = 0.0;
    }
    if nan(params.adhesion_range) && params.work_of_adhesion == 0.0 {
        params.adhesion_range = params.burgers_vector;
    }
}

impl Entries<'_> {
    fn gives_no_area(&self) -> bool {
        ["nominal_area", "asperity_count"].into_iter().all(|name| self.find(Table::Top, name).is_none())
    }

    /// Sets all but the strength from points.
    fn describe(&self, draft: &mut Draft) -> Outcome<Described> {
        let mut given = GivenSurface { entries: self, numbers: Numbers::default(), interface: None, machined: None };
        given.numbers()?;
        given.bodies()?;
        given.heights(draft)?;
        given.roughness(draft)?;
        given.interface()?;
        let GivenSurface { numbers, interface, machined, .. } = given;
        let begin = [Table::Roughness, Table::Materials].into_iter().find_map(|table| self.begin(table));
        self.units(&numbers, draft)?;
        // A text changes what it gives of the parameters that were there before, and no more, but where it gives all of them.
        let mut alone = Draft::default();
        alone.params.nominal_area = draft.params.nominal_area;
        (alone.params.length_unit, alone.params.force_unit) = (draft.params.length_unit, draft.params.force_unit);
        let is_set = numbers.set(&mut alone).is_ok();
        without_adhesion(&mut alone.params);
        let is_whole = is_set && alone.params.unset().is_none();
        let before = draft.clone();
        if is_whole {
            // The law too is then that of this text.
            draft.params.contact_law = alone.params.contact_law;
        }
        numbers.set(draft).map_err(|error| self.problem(error, begin))?;
        without_adhesion(&mut draft.params);
        let given = |names: &[&str]| names.iter().any(|name| self.find(Table::Top, name).is_some());
        let has_adhesion = given(&["work_of_adhesion"]);
        if draft.params.waviness.height > 0.0 && !has_adhesion && draft.params.plasticity_index() > PLASTIC_INDEX {
            // Metal that more probably yields, on waves, does not adhere by what its pair has.
            draft.params.work_of_adhesion = 0.0;
        }
        let params = draft.clone().into_params().map_err(|error| self.problem(error, None))?;
        let has_law = given(&["contact_law"]) || (has_adhesion && params.work_of_adhesion > 0.0);
        let points = self.points(&numbers, params.error_of_point())?;
        let is_error = |number| (0.0..=100.0).contains(&number);
        let of_part = |number| match number {
            1.0..100.0 => "between 0 and 1: is it in per cent?",
            _ => "between 0 and 1",
        };
        let is_part = |number| number > 0.0 && number < 1.0;
        let described = Described {
            measured_on: self.measured_on(before, numbers.clone(), &points)?,
            specimens: self.specimens(&params)?,
            is_of_law: ["measured", "specimens"].iter().all(|name| self.find(Table::Top, name).is_none()),
            points,
            pressure_is_free: is_whole && !given(&["pressure_coefficient"]) && params.pressure_coefficient == 0.0,
            size_effect: self.size_effect()?,
            class: self.class()?,
            shape: shape(self, Table::Roughness, &params, machined.as_ref()),
            known_to: self.known_to()?,
            model_error: self
                .allowed(Table::Top, "model_error", is_error, |_| "from 0, none, to 100; 1 is what is usual")?
                .unwrap_or(1.0),
            coverage: self.allowed(Table::Top, "coverage", is_part, of_part)?.unwrap_or(DEFAULT_COVERAGE),
            bodies: numbers.bodies,
            has_moduli: self.of(Table::Materials).any(|entry| matches!(entry.value, Value::Number(_))),
            has_hardness: given(&["hardness"]),
            has_adhesion,
            interface,
            has_stress: !is_whole || given(&["slip_stress_1", "slip_stress_2"]),
            is_whole,
            law_is_open: is_whole && !has_law && params.hardness > 0.0,
            machined,
            is_of_pressures: false,
            params,
        };
        let with_law = described.with_law(described.params.clone());
        with_law.and_then(|params| params.check()).map_err(|error| self.blamed(error))?;
        Ok(described)
    }

    /// The units that the text is in, which are those of what was set before.
    fn units(&self, numbers: &Numbers, draft: &mut Draft) -> Outcome<()> {
        let mut fresh = Draft::default();
        let is_fresh = FIELDS.iter().all(|field| field.get(draft).to_bits() == field.get(&mut fresh).to_bits());
        let Params { length_unit, force_unit, .. } = &mut draft.params;
        for (name, before) in [("length_unit", length_unit), ("force_unit", force_unit)] {
            let unit = numbers.get(name).unwrap_or(1.0);
            positive(name, unit).map_err(|error| self.problem(error, None))?;
            if unit != *before && !is_fresh {
                let (unit, before) = (Value::Number(unit), Value::Number(*before));
                let says = "that of the parameters set before: set texts first, then convert all";
                let at = self.place(name).unwrap_or_default();
                return Err(Problem::new(at, format_args!("{name} = {unit}: must be {before}, {says}")));
            }
            *before = unit;
        }
        let Some(entry) = self.find(Table::Roughness, "process") else { return Ok(()) };
        draft.params.check_not_converted().map_err(|error| Problem::of(entry.at, error))
    }

    /// A number of a key, where it is given, that is allowed, or else what it must be.
    fn allowed(
        &self,
        table: Table,
        name: &str,
        is_allowed: fn(f64) -> bool,
        or: fn(f64) -> &'static str,
    ) -> Outcome<Option<f64>> {
        let Some(entry) = self.find(table, name) else { return Ok(None) };
        match entry.number()? {
            number if is_allowed(number) => Ok(Some(number)),
            number => Err(entry.must_be(format_args!("{}", or(number)))),
        }
    }

    /// The size effect in the place of slip stresses.
    fn size_effect(&self) -> Outcome<Option<f64>> {
        if self.find(Table::Top, "size_effect").is_some() {
            self.exclude(&["slip_stress_1", "slip_stress_2", "interface"], "size_effect")?;
        }
        let says = |_| "from 0, a film, to 1, clean crystals";
        self.allowed(Table::Top, "size_effect", |number| (0.0..=1.0).contains(&number), says)
    }

    /// The number of specimens that were measured.
    fn specimens(&self, params: &Params) -> Outcome<Option<f64>> {
        let Some(entry) = self.find(Table::Top, "specimens") else { return Ok(None) };
        if self.measured().is_none() {
            return Err(entry.refused(format_args!("measured must be set, what was measured on them")));
        }
        let has_count = !self.gives_no_area() || params.asperity_count >= 1.0 && params.nominal_area != 1.0;
        if !has_count || params.asperity_count < 1.0 {
            let says = "a specimen needs its number of asperities, 1 or more: give its nominal_area, and loads in N";
            return Err(entry.refused(format_args!("{says}")));
        }
        let is_count = |number: f64| (1.0..=1e6).contains(&number) && number.fract() == 0.0;
        let says = |_| "a whole number, from 1: how many specimens were measured";
        self.allowed(Table::Top, "specimens", is_count, says)
    }

    /// The class of the interface.
    fn class(&self) -> Outcome<&'static Class> {
        let Some(entry) = self.find(Table::Top, "interface_kind") else { return Ok(&CLASSES[0]) };
        let found = match &entry.value {
            Value::Word(word) => Class::find(word),
            _ => None,
        };
        let names = CLASSES.each_ref().map(|class| class.words[0]);
        found.ok_or_else(|| entry.must_be(format_args!("{}", one_of(&names))))
    }

    fn known_to(&self) -> Outcome<KnownTo> {
        let says = |number| match number > 0.0 && number < 1.0 {
            true => "a factor from 1, exact, to 1000: 1.2 is known to 20 %",
            false => "a factor from 1, exact, to 1000",
        };
        let factor = |name| self.allowed(Table::KnownTo, name, |number| (1.0..=1e3).contains(&number), says);
        let [slope, hardness, work, young] = ["slope", "hardness", "work_of_adhesion", "E"].map(factor);
        Ok(KnownTo { slope: slope?, hardness: hardness?, work: work?, young: young? })
    }

    /// The surfaces that were measured, where they are not those that are asked for.
    fn measured_on(
        &self,
        mut draft: Draft,
        mut numbers: Numbers,
        points: &[MeasuredPoint],
    ) -> Outcome<Option<Measured>> {
        let Some(begin) = self.begin(Table::MeasuredOn) else { return Ok(None) };
        if points.is_empty() {
            let says = format_args!("[measured_on]: measured must be set, what was measured there");
            return Err(Problem::new(begin, says));
        }
        let is_own = |entry: &&Entry| Table::MeasuredOn.keys().contains(&entry.name);
        for entry in self.of(Table::MeasuredOn).filter(is_own) {
            numbers.give_named(entry.name, entry.number()?);
        }
        let is_rough = !self.of(Table::MeasuredOn).all(|entry| is_own(&entry));
        let machined = match is_rough {
            true => self.roughness(Table::MeasuredOn, begin, &mut numbers)?,
            false => None,
        };
        let params = numbers.set(&mut draft).map(|()| without_adhesion(&mut draft.params));
        let params = params.and_then(|()| draft.into_params()).and_then(|params| params.surface().map(|_| params));
        let params = params.map_err(|error| Problem::of(begin, error))?;
        let shape = is_rough.then(|| shape(self, Table::MeasuredOn, &params, machined.as_ref()));
        Ok(Some(Measured { params, machined, shape }))
    }

    /// Gives numbers the roughness of a table, which begins at a byte of the text.
    fn roughness(&self, table: Table, begin: usize, numbers: &mut Numbers) -> Outcome<Option<Machined>> {
        let by = table.to_string();
        self.exclude(SUMMITS, by.trim_end())?;
        if Roughness::gives_curvature(self, table) {
            self.exclude(&["bandwidth"], by.trim_end())?;
        }
        let bandwidth = numbers.get("bandwidth");
        let Roughness { moments, density, at_scores, lay, machined } = Roughness::of(self, table, begin, bandwidth)?;
        for (name, moment) in [("m0", moments.m0), ("m2", moments.m2), ("m4", moments.m4)] {
            numbers.give_named(name, moment);
        }
        let summits = self.find(table, "summits");
        let kind = summits.map(|entry| entry.choice(KINDS_OF_SUMMITS)).transpose()?;
        numbers.has_mccool_summits = kind == Some(1.0);
        let at = summits.map_or(begin, |entry| entry.at);
        let refused = |says: &str| Err(Problem::new(at, format_args!("{table}summits: {says}")));
        if numbers.has_mccool_summits && moments.m4 == 0.0 {
            return refused("\"mccool\" needs the curvature of the surface: give m4, Ssc, Sds or bandwidth");
        }
        numbers.give_named("summit_density", density.filter(|_| numbers.has_mccool_summits));
        (numbers.lay, numbers.at_scores) = (lay, at_scores);
        if numbers.at_scores.is_some() {
            self.exclude(SHAPES, by.trim_end())?;
            self.exclude(&["height_distribution"], by.trim_end())?;
            if numbers.has_mccool_summits {
                return refused("\"mccool\" is for Gaussian heights: leave the key out");
            }
        }
        Ok(machined)
    }

    /// The measured points: those of `measured`, or that of the calibration.
    fn points(&self, numbers: &Numbers, error: f64) -> Outcome<Vec<MeasuredPoint>> {
        let one = numbers.measured().map_err(|error| self.problem(error, self.measured()))?;
        let Some(entry) = self.find(Table::Top, "measured") else {
            return Ok(one.map(|(load, force)| MeasuredPoint { load, force, error }).into_iter().collect());
        };
        if one.is_some() {
            return Err(entry.refused(format_args!("calibration_load gives a measured point already, leave one out")));
        }
        let rows = match &entry.value {
            Value::Numbers(numbers) if !numbers.is_empty() => std::slice::from_ref(numbers),
            Value::Rows(rows) => &rows[..],
            _ => &[],
        };
        if rows.is_empty() || rows.len() > MOST_POINTS {
            let says = "points [load, coefficient] or [load, coefficient, error], as [[1000, 0.16], [10, 0.19, 0.03]]";
            return Err(entry.must_be(format_args!("{says}, at most {MOST_POINTS}")));
        }
        let point = |(i, row): (usize, &Vec<f64>)| {
            let refused = |says: Arguments| Err(entry.refused(format_args!("point {}: {says}", i + 1)));
            let (load, coefficient, error) = match row[..] {
                [load, coefficient] => (load, coefficient, error),
                [load, coefficient, error] => (load, coefficient, error),
                _ => return refused(format_args!("must be [load, coefficient] or [load, coefficient, error]")),
            };
            if !(error > 0.0 && error <= 1.0) {
                let says = "must be > 0 and at most 1: it is a fraction of the coefficient";
                return refused(format_args!("error = {}: {says}", Value::Number(error)));
            }
            match Params::measured_force(load, coefficient) {
                Ok(force) => Ok(MeasuredPoint { load, force, error }),
                Err(error) => {
                    let says = error.to_string().replace("calibration_friction_", "").replacen("calibration_", "", 1);
                    refused(format_args!("{says}"))
                }
            }
        };
        rows.iter().enumerate().map(point).collect()
    }
}

impl Entries<'_> {
    /// A problem where its parameter is given, or else at another place, or at the beginning.
    #[cold]
    #[inline(never)]
    fn problem(&self, error: Error, otherwise: Option<usize>) -> Box<Problem> {
        let at = error.name().and_then(|name| self.place(name)).or(otherwise).unwrap_or_default();
        Problem::of(at, error)
    }

    /// What the parameters are refused for, at its key, or with the keys that it follows from.
    #[cold]
    fn blamed(&self, error: Error) -> Box<Problem> {
        let name = error.name().unwrap_or_default();
        let is_number = ["asperity_count", "bandwidth"].iter().any(|count| name.contains(count));
        let is_of_waves = |name: &str| name.starts_with("waviness");
        let makes = |entry: &&Entry| match entry.table {
            _ if is_of_waves(name) => is_of_waves(entry.name),
            Table::Roughness => true,
            _ if is_number => ["nominal_area", "summit_density", "asperity_count"].contains(&entry.name),
            _ => SUMMITS.contains(&entry.name) || name.contains(entry.name),
        };
        let keys: Vec<_> = self.all().filter(makes).collect();
        match keys[..] {
            [first, ..] if self.place(name).is_none() => {
                let keys: Vec<_> = keys.iter().map(|key| format!("{}{}", key.table, key.name)).collect();
                Problem::new(first.at, format_args!("{}: {error}", keys.join(", ")))
            }
            _ => self.problem(error, None),
        }
    }

    /// Where the measurement is.
    fn measured(&self) -> Option<usize> {
        let names = ["measured", "calibration_load", "calibration_friction_coefficient", "calibration_friction_force"];
        names.into_iter().find_map(|name| self.place(name))
    }

    /// Refuses names that something else sets.
    #[inline(never)]
    fn exclude(&self, names: &[&str], by: &str) -> Outcome<()> {
        match names.iter().find_map(|name| self.find(Table::Top, name)) {
            Some(entry) => Err(entry.set_by(by)),
            None => Ok(()),
        }
    }

    /// A word, where the key is given.
    fn word(&self, table: Table, name: &str, of: &str) -> Outcome<Option<(&Entry<'_>, &str)>> {
        match self.find(table, name) {
            None => Ok(None),
            Some(entry) => match &entry.value {
                Value::Word(word) => Ok(Some((entry, word))),
                _ => Err(entry.must_be(format_args!("the name of {of}, in quotes"))),
            },
        }
    }
}

impl Entry<'_> {
    #[cold]
    #[inline(never)]
    fn refused(&self, says: Arguments) -> Box<Problem> {
        Problem::new(self.at, format_args!("{}{}: {says}", self.table, self.name))
    }

    #[cold]
    #[inline(never)]
    fn must_be(&self, what: Arguments) -> Box<Problem> {
        Problem::new(self.at, format_args!("{}{} = {}: must be {what}", self.table, self.name, self.value))
    }

    #[cold]
    #[inline(never)]
    fn set_by(&self, other: &str) -> Box<Problem> {
        self.refused(format_args!("{other} sets it already, leave one out"))
    }

    #[inline(never)]
    fn number(&self) -> Outcome<f64> {
        match &self.value {
            Value::Number(number) => Ok(*number),
            Value::Word(word) if word.trim().parse::<f64>().is_ok() => {
                Err(self.must_be(format_args!("a number, without quotes")))
            }
            _ => Err(self.must_be(format_args!("a number"))),
        }
    }

    /// The number of a word of some.
    #[inline(never)]
    fn choice(&self, words: &[&str]) -> Outcome<f64> {
        let found = match &self.value {
            Value::Word(word) if words != FLAG => words.iter().position(|other| *other == word),
            Value::Flag(flag) if words == FLAG => Some(usize::from(*flag)),
            Value::Number(number) => (0..words.len()).find(|&i| i as f64 == *number),
            _ => None,
        };
        found.map(|number| number as f64).ok_or_else(|| self.must_be(format_args!("{}", one_of(words))))
    }
}

/// Words of which one must be given.
fn one_of(words: &[&str]) -> String {
    let quote = if words == FLAG { "" } else { "\"" };
    let words: Vec<_> = words.iter().map(|word| format!("{quote}{word}{quote}")).collect();
    match &words[..] {
        [others @ .., last] => format!("{} or {last}", others.join(", ")),
        [] => String::new(),
    }
}

/// A text on its way to numbers.
struct GivenSurface<'t> {
    entries: &'t Entries<'t>,
    numbers: Numbers,
    interface: Option<&'static Interface>,
    machined: Option<Machined>,
}

impl GivenSurface<'_> {
    /// Numbers and choices at the top.
    fn numbers(&mut self) -> Outcome<()> {
        for entry in self.entries.of(Table::Top) {
            let Some(position) = names().position(|name| name == entry.name) else { continue };
            let words = FIELDS.get(position).map_or(&[][..], |field| field.words);
            let number = if words.is_empty() { entry.number()? } else { entry.choice(words)? };
            self.numbers.give(position, number);
        }
        Ok(())
    }

    /// The two bodies, by a name for both, a name for each, or numbers.
    fn bodies(&mut self) -> Outcome<()> {
        let entries = self.entries;
        if let Some((entry, name)) = entries.word(Table::Top, "pair", "a pair of materials")? {
            let mut own = entries.of(Table::Materials).peekable();
            let has_own = own.peek().is_some();
            if let Some(twice) = own.find(|entry| BODIES.iter().any(|(name, _)| *name == entry.name)) {
                return Err(twice.set_by("pair"));
            }
            self.exclude_moduli("pair")?;
            let unknown = || Problem::new(entry.at, format_args!("{}", NoPair(name.as_bytes())));
            let bodies = Bodies::find(name).ok_or_else(unknown)?;
            for ((_, numbers), Material { young, poisson, .. }) in BODIES.iter().zip([bodies.first, bodies.second]) {
                for (number, known) in numbers.iter().zip([young, poisson]).filter(|_| has_own) {
                    let given = entries.find(Table::Materials, number).map(Entry::number);
                    self.numbers.give_named(number, given.unwrap_or(Ok(*known))?);
                }
            }
            return self.set_bodies(entry, bodies);
        }
        let Some(begin) = entries.begin(Table::Materials) else { return Ok(()) };
        if entries.of(Table::Materials).next().is_none() {
            return Ok(());
        }
        self.exclude_moduli("[materials]")?;
        let mut named = Vec::new();
        for (name, numbers) in BODIES {
            let Some((entry, word)) = entries.word(Table::Materials, name, "a material")? else {
                for number in numbers {
                    let Some(entry) = entries.find(Table::Materials, number) else {
                        let says = format_args!("[materials] gives no name as {name}, so {number} must be set there");
                        return Err(Problem::new(begin, says));
                    };
                    self.numbers.give_named(number, entry.number()?);
                }
                continue;
            };
            if let Some(twice) = numbers.iter().find_map(|number| entries.find(Table::Materials, number)) {
                return Err(twice.set_by(name));
            }
            let Some(material) = Material::find(word) else {
                let says = no_material(word.as_bytes());
                return Err(Problem::new(entry.at, format_args!("[materials] {name}: {says}")));
            };
            for (number, value) in numbers.into_iter().zip([material.young, material.poisson]) {
                self.numbers.give_named(number, value);
            }
            named.push((entry, material));
        }
        match named[..] {
            [(_, first), (entry, second)] => self.set_bodies(entry, Bodies { first, second }),
            _ => Ok(()),
        }
    }

    fn exclude_moduli(&self, by: &str) -> Outcome<()> {
        let Some(entry) = MODULI.iter().find_map(|name| self.entries.find(Table::Top, name)) else { return Ok(()) };
        let says = "leave one out; E1, nu1, E2 and nu2 replace the moduli of a pair";
        Err(entry.refused(format_args!("{by} sets it already, {says}")))
    }

    /// All that is known of two materials by their names, and what is not known of them from beside it.
    fn set_bodies(&mut self, entry: &Entry, bodies: Bodies) -> Outcome<()> {
        let name = [bodies.first, bodies.second].map(|body| crate::materials::names::text(body.name)).join("/");
        if bodies.pair().is_none() && self.numbers.get("work_of_adhesion").is_none() {
            let yields = self.numbers.get("contact_law") == Some(1.0);
            self.numbers.give_named("work_of_adhesion", if yields { 0.0 } else { USUAL_WORK });
        }
        if bodies.burgers_vector().is_none() {
            let Some(burgers_vector) = self.numbers.get("burgers_vector") else {
                let says = format_args!("burgers_vector: none is known of a body of {name}: give one");
                return Err(Problem::new(entry.at, says));
            };
            if self.numbers.get("adhesion_range").is_none() {
                self.numbers.give_named("adhesion_range", burgers_vector);
            }
        }
        self.numbers.bodies = Some(bodies);
        Ok(())
    }

    /// A table of heights, and heights that are chosen by what is given of them.
    fn heights(&mut self, draft: &mut Draft) -> Outcome<()> {
        let entries = self.entries;
        let given = |name: &str| entries.find(Table::Top, name);
        let (height, density) = (given("table_height"), given("table_density"));
        let family = self.numbers.get("height_distribution");
        if family.is_none() {
            let meant: Vec<_> =
                [given("weibull_shape"), given("kurtosis"), height.or(density)].into_iter().flatten().collect();
            if let [first, other, ..] = meant[..] {
                let says = "give one of them, or height_distribution too";
                return Err(first.refused(format_args!("means other heights than {}: {says}", other.name)));
            }
            let skewed = given("skew").filter(|_| given("kurtosis").is_none());
            if let (Some(skew), Some(other)) = (skewed, meant.first()) {
                return Err(skew.refused(format_args!("chooses the heights by itself: do not give {} too", other.name)));
            }
        }
        let (height, density) = match (height, density) {
            (None, None) => return Ok(()),
            (Some(height), Some(density)) => (height, density),
            (Some(one), None) | (None, Some(one)) => {
                return Err(one.refused(format_args!("table_height and table_density go together")))
            }
        };
        let is_at_scores = family == Some(f64::from(AT_SCORES));
        if !is_at_scores && family.is_some_and(|family| family != f64::from(TABULATED)) {
            return Err(height.refused(format_args!("the heights are of another family: leave the table out")));
        }
        let [heights, densities] = [height, density].map(|entry| match &entry.value {
            Value::Numbers(numbers) => Ok(&numbers[..]),
            _ => Err(entry.must_be(format_args!("an array of numbers"))),
        });
        let (heights, densities) = (heights?, densities?);
        if heights.len() != densities.len() {
            return Err(density.refused(format_args!("{} numbers for {} heights", densities.len(), heights.len())));
        }
        if let Err(error) = tabulated::check_length(heights.len()) {
            return Err(height.refused(format_args!("{error}")));
        }
        draft.params.heights = HeightFamily::of_table(is_at_scores, Arc::from(heights), Arc::from(densities));
        if family.is_none() {
            self.numbers.give_named("height_distribution", f64::from(TABULATED));
        }
        Ok(())
    }

    fn roughness(&mut self, draft: &mut Draft) -> Outcome<()> {
        let entries = self.entries;
        let Some(begin) = entries.begin(Table::Roughness) else { return Ok(()) };
        if entries.of(Table::Roughness).next().is_none() {
            return Ok(());
        }
        if self.numbers.get("nominal_area").is_none() && draft.params.nominal_area == 0.0 {
            let says = "must be set, since [roughness] gives the asperities per area";
            return Err(Problem::new(begin, format_args!("nominal_area: {says}")));
        }
        self.machined = entries.roughness(Table::Roughness, begin, &mut self.numbers)?;
        let leaves_plateaus = |machined: &Machined| machined.process.leaves_plateaus();
        draft.params.taken_as_gaussian = self.machined.as_ref().is_some_and(leaves_plateaus);
        Ok(())
    }

    fn interface(&mut self) -> Outcome<()> {
        let Some((entry, name)) = self.entries.word(Table::Top, "interface", "an interface")? else { return Ok(()) };
        self.entries.exclude(STRENGTH, "interface")?;
        self.interface = Interface::find(name);
        // The friction coefficient of the others is for an estimate.
        self.numbers.interface = self.interface.filter(|interface| interface.shear_strength > 0.0);
        let unknown = || Problem::new(entry.at, format_args!("interface: {}", no_interface(name.as_bytes())));
        self.interface.map(|_| ()).ok_or_else(unknown)
    }
}
