//! What the library knows by names: which names there are, and what it knows of each, as a text.

use super::about::STATUSES;
use super::boundary::{self, Failure};
use super::given;
use super::names;
use crate::by_name::{Draft, Quoted, Real, Written, FIELDS};
use crate::materials::names::{text, Instead, Unknown};
use crate::materials::{no_interface, no_material, Interface, Material, NoPair, Pair, INTERFACES, MATERIALS, PAIRS};
use crate::model::validity::WARNING_TEXTS;
use std::ffi::{c_char, CStr};
use std::fmt::{Display, Write};

/// Kind of names: parameters that are one number, in an order in which all can be copied.
pub const ASPERITY_NAMES_PARAMETERS: i32 = 0;
/// Kind of names: materials.
pub const ASPERITY_NAMES_MATERIALS: i32 = 1;
/// Kind of names: pairs of materials whose work of adhesion is known.
pub const ASPERITY_NAMES_PAIRS: i32 = 2;
/// Kind of names: interfaces whose strength or friction was measured.
pub const ASPERITY_NAMES_INTERFACES: i32 = 3;
/// Kind of names: warnings, named as their constants without `ASPERITY_WARNING_`.
pub const ASPERITY_NAMES_WARNINGS: i32 = 4;
/// Kind of names: statuses, named as their constants without `ASPERITY_`.
pub const ASPERITY_NAMES_STATUSES: i32 = 5;

/// Returns the name of a parameter, material, pair, interface, warning or status, by its index.
///
/// @param kind   one of `ASPERITY_NAMES_...`
/// @param index  from 0
/// @return a constant string; NULL after the last, and for an unknown kind
#[no_mangle]
pub extern "C" fn asperity_name(kind: i32, index: usize) -> *const c_char {
    let name = match kind {
        ASPERITY_NAMES_PARAMETERS => FIELDS.get(index).map(|field| field.c_name),
        ASPERITY_NAMES_MATERIALS => MATERIALS.get(index).map(|material| material.name),
        ASPERITY_NAMES_PAIRS => PAIRS.get(index).map(|pair| pair.name),
        ASPERITY_NAMES_INTERFACES => INTERFACES.get(index).map(|interface| interface.name),
        ASPERITY_NAMES_WARNINGS => WARNING_TEXTS.get(index).map(|(name, ..)| *name),
        ASPERITY_NAMES_STATUSES => STATUSES.get(index).map(|(name, ..)| *name),
        _ => None,
    };
    name.map_or(std::ptr::null(), CStr::as_ptr)
}

/// Writes what is known by a name, a line "key = value" for each number or text, in TOML, with the unit of a number in a comment.
///
/// What is not known is left out. Numbers of materials, pairs and interfaces are in SI units, typical, and meant to start from:
/// films, alloys and treatments differ. "_low" and "_high" are the smallest and the largest value published.
///
/// - parameter: `unit`, as "stress" or "1", `default` unless it must be set, and `choices`, the words for 0, 1, ...
/// - material: `young`, `poisson`, `hardness`, `burgers_vector`, `reference`
/// - pair: `work_of_adhesion`, the constant `hamaker` that it is estimated from, `slip_stress_1`, `reference`
/// - interface: `shear_strength` at no pressure and `pressure_coefficient`, or `friction_coefficient` and its lightest `load`;
///   `conditions`; `source`, "read" in the text of the `reference` or "quoted" from another
/// - warning and status: `bit` or `status`, and `text`
///
/// @param kind    one of `ASPERITY_NAMES_...`
/// @param name    one of `asperity_name`; a material also by other words, as "gold", a pair in either order
/// @return the length; 0 for an unknown name, of which `asperity_last_error` says which is nearest
#[no_mangle]
pub unsafe extern "C" fn asperity_describe(
    kind: i32,
    name: *const c_char,
    buffer: *mut c_char,
    length: usize,
) -> usize {
    boundary::written(buffer, length, || {
        let name = given::read(name)?;
        match kind {
            ASPERITY_NAMES_PARAMETERS => parameter(name),
            ASPERITY_NAMES_MATERIALS => Ok(material(Material::find(name).ok_or_else(|| unknown(&no_material(name)))?)),
            ASPERITY_NAMES_PAIRS => Ok(pair(Pair::find(name).ok_or_else(|| unknown(&NoPair(name)))?)),
            ASPERITY_NAMES_INTERFACES => {
                Ok(interface(Interface::find(name).ok_or_else(|| unknown(&no_interface(name)))?))
            }
            ASPERITY_NAMES_WARNINGS => constant(&WARNING_TEXTS, "warning", "bit", name),
            ASPERITY_NAMES_STATUSES => constant(&STATUSES, "status", "status", name),
            _ => Err(Failure::invalid(format_args!("kind = {kind}: must be one of ASPERITY_NAMES_, 0 to 5"))),
        }
    })
}

fn unknown(says: &dyn Display) -> Failure {
    Failure::invalid(format_args!("{says}"))
}

/// The lines of a text.
#[derive(Default)]
struct Lines(String);

impl Lines {
    fn of(name: &CStr) -> Self {
        Self::default().words("name", name)
    }

    fn line(mut self, key: &str, value: impl Display) -> Self {
        // Writing to a string does not fail.
        let _ = writeln!(self.0, "{key} = {value}");
        self
    }

    fn words(self, key: &str, words: &CStr) -> Self {
        self.line(key, Quoted(text(words)))
    }

    /// A number in its unit, unless it is 0, which stands for what is not known.
    fn number(self, key: &str, number: f64, unit: &str) -> Self {
        match number == 0.0 {
            true => self,
            false => self.line(key, format_args!("{}  # [{unit}]", Real(number))),
        }
    }

    /// A number with its range.
    fn ranged(self, key: &str, number: f64, [low, high]: [f64; 2], unit: &str) -> Self {
        let of = |end| format!("{key}_{end}");
        self.number(key, number, unit).number(&of("low"), low, unit).number(&of("high"), high, unit)
    }
}

fn parameter(name: &[u8]) -> Result<String, Failure> {
    let field = names::field(name)?;
    let default = field.get(&mut Draft::default());
    let mut lines = Lines::of(field.c_name).line("unit", Quoted(field.unit));
    if !default.is_nan() {
        lines = lines.line("default", Written(field, default));
    }
    if field.is_choice() {
        let words: Vec<String> = field.words.iter().map(|word| Quoted(word).to_string()).collect();
        lines = lines.line("choices", format_args!("[{}]", words.join(", ")));
    }
    Ok(lines.0)
}

fn material(found: &Material) -> String {
    let lines = Lines::of(found.name)
        .ranged("young", found.young, found.young_range, "Pa")
        .number("poisson", found.poisson, "-")
        .ranged("hardness", found.hardness, found.hardness_range, "Pa")
        .number("burgers_vector", found.burgers_vector, "m");
    lines.words("reference", found.reference).0
}

fn pair(found: &Pair) -> String {
    let lines = Lines::of(found.name)
        .ranged("work_of_adhesion", found.work_of_adhesion, found.work_of_adhesion_range, "J/m^2")
        .number("hamaker", found.hamaker, "J")
        .number("slip_stress_1", found.slip_stress_1, "-");
    lines.words("reference", found.reference).0
}

fn interface(found: &Interface) -> String {
    let lines = Lines::of(found.name)
        .number("shear_strength", found.shear_strength, "Pa")
        .number("pressure_coefficient", found.pressure_coefficient, "-")
        .number("friction_coefficient", found.friction_coefficient, "-")
        .number("load", found.load, "N");
    lines.words("conditions", found.conditions).words("source", found.source).words("reference", found.reference).0
}

/// A constant of the header by its name: its number and what it means.
fn constant(
    all: &[(&'static CStr, impl Display, &'static CStr)],
    thing: &'static str,
    key: &str,
    name: &[u8],
) -> Result<String, Failure> {
    let found = all.iter().find(|(other, ..)| other.to_bytes() == name);
    let (found, number, says) = found.ok_or_else(|| {
        let names = all.iter().map(|(name, ..)| text(name));
        unknown(&Unknown { name, thing, instead: Instead::of(name, names, "asperity.h lists them") })
    })?;
    Ok(Lines::of(found).line(key, number).words("text", says).0)
}
