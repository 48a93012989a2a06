//! Which of some names a name that is none was meant to be.

use std::ffi::CStr;
use std::fmt::{Display, Formatter};

/// Longer than every name: no more is read of a name that is given.
pub const LONGEST: usize = 64;

/// What is said of a name that no such thing has.
pub struct Unknown<'a> {
    pub name: &'a [u8],
    /// What has names.
    pub thing: &'static str,
    /// The name that is nearest.
    pub nearest: &'a str,
}

impl Display for Unknown<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        let Self { name, thing, nearest } = self;
        let name = name[..name.len().min(LONGEST)].escape_ascii();
        write!(f, "{name}: no {thing} has this name; the nearest is {nearest}")
    }
}

/// The name that takes the fewest edits to become of another.
pub fn nearest<'a>(to: &[u8], names: impl Iterator<Item = &'a str>) -> &'a str {
    let to = &to[..to.len().min(LONGEST)];
    names.min_by_key(|name| edits(to, name.as_bytes())).unwrap_or_default()
}

/// A constant name as text.
pub fn text(name: &'static CStr) -> &'static str {
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
    fn names_are_as_far_apart_as_their_edits() {
        for (from, to, expected) in [
            ("", "", 0),
            ("", "skew", 4),
            ("skew", "", 4),
            ("SKEW", "skew", 0),
            ("kitten", "sitting", 3),
            ("flaw", "lawn", 2),
            ("nu3", "nu1", 1),
        ] {
            assert_eq!(edits(from.as_bytes(), to.as_bytes()), expected, "{from} {to}");
        }
    }
}
