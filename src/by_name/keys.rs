//! The keys of a text that describes a surface, where each belongs, and what is said of one that is none.

use super::fields::FIELDS;
use super::toml::{self, Keys, Outcome, Problem, Shown, Value};
use crate::materials::names::{expected, Expected, Instead};
use std::fmt::{Display, Formatter};

/// A table of a text, or the top of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Table {
    Top,
    Materials,
    Roughness,
    /// The roughness of the specimen that was measured, where it is not that which is asked for.
    MeasuredOn,
    /// Factors to which inputs are known.
    KnownTo,
}

const TABLES: [Table; 5] = [Table::Top, Table::Materials, Table::Roughness, Table::MeasuredOn, Table::KnownTo];

impl Table {
    fn name(self) -> &'static str {
        match self {
            Self::Top => "",
            Self::Materials => "materials",
            Self::Roughness => "roughness",
            Self::MeasuredOn => "measured_on",
            Self::KnownTo => "known_to",
        }
    }

    /// Its keys beside the fields of parameters, which are those of the top.
    #[rustfmt::skip]
    pub const fn keys(self) -> &'static [&'static str] {
        match self {
            Self::Top => &[
                "pair", "interface", "summit_density", "table_height", "table_density", "calibration_load",
                "calibration_friction_coefficient", "calibration_friction_force", "measured", "specimens", "coverage",
                "interface_kind", "size_effect", "model_error", "heights",
            ],
            Self::Materials => &["first", "second", "E1", "nu1", "E2", "nu2"],
            Self::Roughness => &[
                "m0", "m2", "m4", "Ra", "Rq", "RSm", "Rdq", "RSm_along", "Rdq_along", "Sq", "Sdq", "Ssc", "Sds", "Ssk", "Sku",
                "Spq", "Svq", "Smq", "heights_at_scores", "slopes_at_scores", "Sdq_top", "lay", "summits", "process",
            ],
            // And those of the roughness.
            Self::MeasuredOn => &["nominal_area", "E1", "nu1", "E2", "nu2", "hardness"],
            Self::KnownTo => &["slope", "hardness", "work_of_adhesion", "E"],
        }
    }

    fn all_keys(self) -> impl Iterator<Item = &'static str> {
        let fields: &[_] = if self == Self::Top { FIELDS } else { &[] };
        let rough = if self == Self::MeasuredOn { Self::Roughness.keys() } else { &[] };
        fields.iter().map(|field| field.name).chain(rough.iter().chain(self.keys()).copied())
    }
}

impl Display for Table {
    /// As it stands before the key in a message.
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Top => Ok(()),
            table => write!(f, "[{}] ", table.name()),
        }
    }
}

/// What is said of words that people expect to be keys.
const EXPECTED: &Expected = &[
    ("Rz|Rt|Rp|Rv|Rmax|Sz|Sp|Sv", "a height from peak to valley, which grows with the length measured: give Ra or Rq"),
    ("Sa", "give it as Ra"),
    (
        "mu|cof|friction|friction_coefficient",
        "give calibration_friction_coefficient with calibration_load, in a text also measured = [[load, coefficient]]",
    ),
    ("machining|finish", "give process in [roughness] of a text"),
    ("sigma", "the standard deviation of the asperities' heights is height_std"),
    ("R|radius", "the radius of the asperities is summit_radius"),
    ("E|nu|young|poisson", "give E1, nu1, E2 and nu2, in a text in [materials]"),
    ("material", "give first and second in [materials] of a text, or pair = \"steel/steel\""),
    ("H|HV|HB|HRC", "give hardness in Pa, of the softer body: HV times 9.81e6"),
    ("w|gamma|adhesion|surface_energy", "give work_of_adhesion in N/m: of like bodies twice the surface energy"),
    ("h", "the range of adhesion is adhesion_range"),
    ("b", "the Burgers vector is burgers_vector"),
    ("A|area", "the nominal area is nominal_area"),
    ("P|load|force|pressure", "a load is given to the call and not with the surface"),
    (
        "speed|velocity|temperature|lubricant|viscosity",
        "it is not in the model: measure friction with it, and calibrate",
    ),
    ("N|count", "the number of asperities is asperity_count, or summit_density with nominal_area"),
];

/// What is said of a word that is no slip of a name.
pub const LISTED: &str = "docs/solvers.md lists them";

/// What to give in place of a word that people expect to be a name.
pub fn meant(name: &str) -> Option<&'static str> {
    expected(EXPECTED, name.as_bytes())
}

/// A key with its value.
#[derive(Debug)]
pub struct Entry<'t> {
    pub table: Table,
    pub name: &'static str,
    /// The byte of the text where it is.
    pub at: usize,
    pub value: Value<'t>,
}

/// What a text gives.
pub struct Entries<'t> {
    pub text: &'t str,
    list: Vec<Entry<'t>>,
    table: Table,
    /// Where each table begins.
    tables: Vec<(Table, usize)>,
}

impl<'t> Entries<'t> {
    /// # Errors
    /// What is no TOML, and keys and tables that are unknown or given twice.
    pub fn read(text: &'t str) -> Outcome<Self> {
        let mut entries = Self { text, list: Vec::new(), table: Table::Top, tables: Vec::new() };
        toml::read(text, &mut entries)?;
        Ok(entries)
    }

    #[inline(never)]
    pub fn find(&self, table: Table, name: &str) -> Option<&Entry<'t>> {
        self.list.iter().find(|entry| entry.table == table && entry.name == name)
    }

    pub fn all(&self) -> impl Iterator<Item = &Entry<'t>> {
        self.list.iter()
    }

    /// The entries of a table, in their order.
    pub fn of(&self, table: Table) -> impl Iterator<Item = &Entry<'t>> {
        self.list.iter().filter(move |entry| entry.table == table)
    }

    /// Where a table begins, if it is there.
    pub fn begin(&self, table: Table) -> Option<usize> {
        self.tables.iter().find(|(other, _)| *other == table).map(|(_, at)| *at)
    }

    /// Where a name is given, or what makes it, in whichever table.
    #[inline(never)]
    pub fn place(&self, name: &str) -> Option<usize> {
        let is_it = |other: &str| other == name || name == "composite_modulus" && ["E1", "E2"].contains(&other);
        let own = |entry: &&Entry| ![Table::MeasuredOn, Table::KnownTo].contains(&entry.table) && is_it(entry.name);
        self.list.iter().find(own).map(|entry| entry.at)
    }

    /// Refuses a key that the table does not have.
    #[cold]
    fn unknown(&self, name: &str, at: usize) -> Box<Problem> {
        let elsewhere = TABLES[..3].iter().copied().find(|table| table.all_keys().any(|key| key == name));
        let (table, shown) = (self.table, Shown(name));
        match (elsewhere, meant(name)) {
            (Some(Table::Top), _) => Problem::new(at, format_args!("{table}{shown}: belongs above the first table")),
            (Some(other), _) => Problem::new(at, format_args!("{table}{shown}: belongs in [{}]", other.name())),
            (_, Some(meant)) => Problem::new(at, format_args!("{table}{shown}: no such key; {meant}")),
            _ => {
                let tables = TABLES[1..].iter().filter(|_| table == Table::Top).map(|table| table.name());
                let is_near = |other: &Table| *other == table || table == Table::Top;
                let keys = TABLES.into_iter().filter(is_near).flat_map(Table::all_keys);
                let instead = Instead::of(name.as_bytes(), keys.chain(tables), LISTED);
                Problem::new(at, format_args!("{table}{shown}: no such key; {instead}"))
            }
        }
    }
}

impl<'t> Keys<'t> for Entries<'t> {
    fn table(&mut self, name: Option<&str>, at: usize) -> Outcome<()> {
        self.table = Table::Top;
        let Some(name) = name else { return Ok(()) };
        let Some(&table) = TABLES[1..].iter().find(|table| table.name() == name) else {
            let says = "no such table; there are [materials], [roughness], [measured_on] and [known_to]";
            return Err(Problem::new(at, format_args!("[{}]: {says}", Shown(name))));
        };
        if let Some(first) = self.begin(table) {
            let line = toml::line(self.text.as_bytes(), first);
            return Err(Problem::new(at, format_args!("[{name}]: given twice, also in line {line}")));
        }
        self.tables.push((table, at));
        self.table = table;
        Ok(())
    }

    fn key(&mut self, name: &str, at: usize, value: Value<'t>) -> Outcome<()> {
        if let (Table::Top, Some(table)) = (self.table, TABLES[1..].iter().find(|table| table.name() == name)) {
            return Err(Problem::new(at, format_args!("{name} = {value}: must be a table, [{}]", table.name())));
        }
        let Some(known) = self.table.all_keys().find(|key| *key == name) else {
            return Err(self.unknown(name, at));
        };
        // The short word of it.
        let name = if known == "heights" { "height_distribution" } else { known };
        if let Some(first) = self.find(self.table, name) {
            let line = toml::line(self.text.as_bytes(), first.at);
            return Err(Problem::new(at, format_args!("{}{known}: given twice, also in line {line}", self.table)));
        }
        self.list.push(Entry { table: self.table, name, at, value });
        Ok(())
    }
}
