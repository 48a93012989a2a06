//! Names that callers give: how much of them is read, and which of the names that are is nearest.

use super::boundary::{not_null, Failure};
use std::ffi::{c_char, CStr};

/// Longer than every name: of a caller's name no more is read.
const LONGEST: usize = 64;

/// A caller's name, as far as it is read.
///
/// # Safety
/// `name` is NULL or points to a string that ends in NUL or has `LONGEST` bytes, and lives as long as the call.
pub unsafe fn read<'a>(name: *const c_char) -> Result<&'a [u8], Failure> {
    not_null(name, "name")?;
    let length = (0..LONGEST).find(|&i| *name.add(i) == 0).unwrap_or(LONGEST);
    Ok(std::slice::from_raw_parts(name.cast(), length))
}

/// What is said of a name that no such thing has.
pub fn unknown(name: &[u8], thing: &str, nearest: &str) -> Failure {
    let name = name.escape_ascii();
    Failure::invalid(format_args!("{name}: no {thing} has this name; the nearest is {nearest}"))
}

/// The name that takes the fewest edits to become of a caller's.
pub fn nearest(to: &[u8], names: impl Iterator<Item = &'static CStr>) -> &'static str {
    let name = names.min_by_key(|name| edits(to, name.to_bytes())).unwrap_or_default();
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
