//! Names: constant strings that C reads in place, and which of some names a name that is none was meant to be.

use std::ffi::CStr;
use std::fmt::{Display, Formatter};

/// A constant string that ends in NUL.
macro_rules! c_string {
    ($text:expr) => {
        match std::ffi::CStr::from_bytes_with_nul(concat!($text, "\0").as_bytes()) {
            Ok(text) => text,
            Err(_) => panic!("a NUL inside"),
        }
    };
}
pub(crate) use c_string;

/// Longer than every name: no more is read of a name that is given.
pub const LONGEST: usize = 64;

/// What is said of a name that no such thing has.
pub struct Unknown<'a> {
    pub name: &'a [u8],
    /// What has names.
    pub thing: &'static str,
    pub instead: Instead<'a>,
}

impl Display for Unknown<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Self { name, thing, instead } = self;
        let quotes = if name.is_empty() { "\"\"" } else { "" };
        let name = name[..name.len().min(LONGEST)].escape_ascii();
        write!(f, "{quotes}{name}: no {thing} has this name; {instead}")
    }
}

/// What to give instead of a name that is none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Instead<'a> {
    /// A name that it is likely to be a slip of.
    Nearest(&'a str),
    /// An answer of its own, or where the names are.
    Says(&'a str),
}

impl Display for Instead<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Nearest(name) => write!(f, "the nearest is {name}"),
            Self::Says(says) => f.write_str(says),
        }
    }
}

/// Words that people expect to be names, with `|` between them, and what is said of each.
pub type Expected = [(&'static str, &'static str)];

/// What is said of a word that people expect to be a name, capitals or not; of one letter the other case is another symbol.
pub fn expected(words: &Expected, name: &[u8]) -> Option<&'static str> {
    let is_meant =
        |word: &str| word.as_bytes() == name || (word.len() > 1 && word.as_bytes().eq_ignore_ascii_case(name));
    words.iter().find(|(words, _)| words.split('|').any(is_meant)).map(|(_, says)| *says)
}

/// As many letters may be wrong, if they are less than half of the name.
const SLIPS: usize = 2;
/// A word of at least so many letters is looked for within names.
const WORD: usize = 4;

impl<'a> Instead<'a> {
    /// The name that takes the fewest edits to become of another, if they are few; else the first that has it within; or where
    /// the names are.
    pub fn of(name: &[u8], names: impl Iterator<Item = &'a str>, otherwise: &'a str) -> Self {
        let name = &name[..name.len().min(LONGEST)];
        let lower = name.to_ascii_lowercase();
        let rank = |other: &str| match edits(name, other.as_bytes()) {
            edits if edits <= SLIPS && 2 * edits < name.len() => Some(edits),
            _ => {
                let has_it = |other: &[u8]| other.windows(lower.len()).any(|part| part.eq_ignore_ascii_case(&lower));
                (name.len() >= WORD && has_it(other.as_bytes())).then_some(SLIPS + 1)
            }
        };
        let ranked = names.filter_map(|other| Some((rank(other)?, other)));
        ranked.min_by_key(|(rank, _)| *rank).map_or(Self::Says(otherwise), |(_, name)| Self::Nearest(name))
    }
}

/// A constant name as text.
pub fn text(name: &CStr) -> &str {
    name.to_str().unwrap_or_default()
}

/// How many letters to insert, remove or replace to make one name of another, capitals or not (Levenshtein's distance).
fn edits(from: &[u8], to: &[u8]) -> usize {
    let mut row: [usize; LONGEST + 1] = std::array::from_fn(|column| column);
    for (i, letter) in from.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (k, other) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(!letter.eq_ignore_ascii_case(other));
            diagonal = row[k + 1];
            row[k + 1] = replaced.min(diagonal + 1).min(row[k] + 1);
        }
    }
    row[to.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_slips_have_a_nearest_name() {
        let names = ["summit_radius", "work_of_adhesion", "nu1", "Pt", "steel"];
        for (name, expected) in [
            ("sumit_radius", Instead::Nearest("summit_radius")),
            ("summmit_radius", Instead::Nearest("summit_radius")),
            ("STEEL", Instead::Nearest("steel")),
            ("Stell", Instead::Nearest("steel")),
            ("adhesion", Instead::Nearest("work_of_adhesion")),
            ("pt", Instead::Nearest("Pt")),
            ("nu", Instead::Says("none")),
            ("PTFE", Instead::Says("none")),
            ("rubber", Instead::Says("none")),
            ("", Instead::Says("none")),
        ] {
            assert_eq!(Instead::of(name.as_bytes(), names.into_iter(), "none"), expected, "{name}");
        }
    }
}
