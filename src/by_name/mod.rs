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

use crate::error::Error;
use crate::params::Params;

impl Params {
    /// The parameters that a text in TOML describes, in SI units: `docs/solvers.md` lists its keys. What it leaves out has its
    /// default, or is unset; asperities of metal that yield have the elastic-plastic law, unless the text has a law.
    ///
    /// ```
    /// let text = "pair = \"steel/steel\"\nnominal_area = 1e-4\n[roughness]\nRa = 0.8e-6\nRSm = 80e-6\n";
    /// let params = asperity::Params::from_toml(text)?;
    /// assert!(params.hardness > 1e9 && params.asperity_count > 1e4);
    /// # Ok::<(), asperity::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InText`], with the line and the key; those of [`Params::calibrate`].
    pub fn from_toml(text: &str) -> Result<Self, Error> {
        let mut draft = Draft::default();
        read(text.as_bytes(), &mut draft)?;
        draft.into_params()
    }

    /// A text of which [`Params::from_toml`] makes equal parameters. Fields that it makes so anyway are left out.
    pub fn to_toml(&self) -> String {
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = write(&mut Draft::of(self), is_of_these_surfaces(self), &mut text);
        text
    }
}
