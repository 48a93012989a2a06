//! Parameters as a text: a text means what an estimate of it takes.

use crate::by_name::{self, is_of_these_surfaces, Draft};
use crate::error::Error;
use crate::estimate::Estimate;
use crate::params::Params;

/// Sets what a text gives; of what it does not, all stays as it is. A whole surface, and one with measured points, has the strength and the
/// contact law that an estimate of the text takes.
///
/// # Errors
/// [`Error::InText`], with the line; [`Error::Meaningless`] of a text that is too long. The draft is of no use then.
pub fn read(bytes: &[u8], draft: &mut Draft) -> Result<(), Error> {
    by_name::read(bytes, draft, |described| Estimate::of(described)?.params().cloned())
}

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
        let _ = by_name::write(&mut Draft::of(self), is_of_these_surfaces(self), &mut text);
        text
    }
}
