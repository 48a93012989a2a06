//! Parameters by their names: numbers one after another, or a whole surface as a text.
//!
//! `fields` names the numbers of a `Draft`, parameters whose heights may still be chosen; `numbers` has what their names mean when
//! some are given together. `toml` reads the form of a text, `keys` which there are, `surface` what they mean; `roughness` is a
//! part of that, and `write` the way back. `units` converts parameters.

mod draft;
mod fields;
mod keys;
mod numbers;
mod roughness;
mod surface;
mod toml;
mod units;
mod write;

pub use draft::Draft;
pub(crate) use fields::with_fields;
pub use fields::{Field, Number, FIELDS};
pub use numbers::{Numbers, ARGUMENTS};
pub use roughness::Machined;
pub use surface::{describe, read, Described};
pub use toml::LONGEST_TEXT;
pub use write::{is_of_these_surfaces, write, Quoted, Real, Written};
