//! A surface as a text, as C asks for it.

use super::boundary::{self, not_null, Failure};
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use super::tables::{keep, Kept};
use crate::by_name::{self, is_of_these_surfaces, Draft, LONGEST_TEXT};
use crate::error::Error;
use crate::params::HeightFamily;
use std::ffi::c_char;
use std::mem::replace;

impl asperity_params {
    /// Sets what a text gives; `refuse` reports what is wrong with it.
    ///
    /// # Safety
    /// As that of `to_params`.
    pub(super) unsafe fn set_text(
        &mut self,
        text: &[u8],
        refuse: impl FnOnce(Error) -> Failure,
    ) -> Result<(), Failure> {
        self.set_draft(|draft| crate::text::read(text, draft).map_err(refuse))
    }

    /// Sets what is changed of a draft.
    ///
    /// # Safety
    /// As that of `to_params`.
    unsafe fn set_draft(&mut self, set: impl FnOnce(&mut Draft) -> Result<(), Failure>) -> Result<(), Failure> {
        let mut draft = self.draft()?;
        // A table that cannot be read is refused unless other heights are chosen.
        draft.params.heights = self.readable_table().unwrap_or(HeightFamily::Gaussian);
        let before = table_at(&draft.params.heights);
        set(&mut draft)?;
        let after = table_at(&draft.params.heights);
        let table = match replace(&mut draft.params.heights, HeightFamily::Gaussian) {
            heights if after != before => {
                heights.table().map(|(height, values)| Kept::new(height.clone(), values.clone()))
            }
            _ => None,
        };
        self.take(draft);
        if let Some(table) = table.map(keep) {
            (self.table_height, self.table_density) = (table.height.as_ptr(), table.density.as_ptr());
            self.table_length = table.height.len() as u64;
        }
        Ok(())
    }
}

/// The bytes of a text; of a longer one than is read, one more.
///
/// # Safety
/// The caller says that there are so many.
pub(super) unsafe fn bytes<'t>(text: *const c_char, length: usize) -> &'t [u8] {
    std::slice::from_raw_parts(text.cast::<u8>(), length.min(LONGEST_TEXT + 1))
}

/// Where the table of heights is, if they are one.
fn table_at(heights: &HeightFamily) -> Option<*const f64> {
    heights.table().map(|(height, _)| height.as_ptr())
}

/// Sets parameters from a text in TOML that describes a surface: all that it gives, or nothing if something is refused.
///
/// What it does not give stays as it is. A whole surface, and one with measured points, has the strength and the contact law that
/// `asperity_estimate_at_loads` takes for the text: a model has its median, or its `curve_coefficient` where they differ. Keys are the
/// names of `asperity_params_set_values`, in SI units, and what docs/solvers.md lists.
///
/// ```c
/// const char surface[] = "pair = \"steel/steel\"\n nominal_area = 1e-4\n measured = [1000, 0.16]\n"
///                        "roughness = {Ra = 0.8e-6, RSm = 80e-6}\n";
/// asperity_params_set_text(&params, surface, sizeof surface - 1);
/// ```
///
/// A message has the line and the key: "line 3: slip_onset = "hole": must be "partial" or "whole"". A table of heights is kept by the
/// library, once for each table, as long as it is loaded: the parameters point to it.
///
/// @param text    UTF-8, with or without a byte order mark; lines end in LF or CRLF
/// @param length  of the text [bytes], without a NUL; at most 1 MiB
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`; with a measured friction also
///         what `asperity_params_calibrate_force` returns
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_text(
    params: *mut asperity_params,
    text: *const c_char,
    length: usize,
) -> asperity_status {
    boundary::status(|| {
        change(params, |params| {
            not_null(text, "text")?;
            params.set_text(bytes(text, length), Failure::from)
        })
    })
}

/// Writes parameters as a text of which `asperity_params_set_text` makes the same in fresh parameters, bit for bit.
///
/// Fields that have their defaults, or are unset, are left out. A calibration that these surfaces no longer meet is a comment.
///
/// @return the length; 0 for choices that are none, a shape that is not of the heights, or no table
#[no_mangle]
pub unsafe extern "C" fn asperity_params_text(
    params: *const asperity_params,
    buffer: *mut c_char,
    length: usize,
) -> usize {
    boundary::written(buffer, length, || {
        let mut draft = asperity_params::read(params)?.whole_draft()?;
        let is_measured = is_of_these_surfaces(&draft.clone().into_params()?);
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = by_name::write(&mut draft, is_measured, &mut text);
        Ok(text)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Params;

    #[test]
    fn tables_of_equal_heights_have_their_own_densities() {
        let set = |density: f64| {
            let text = format!("table_height = [0, 1, 2, 3]\ntable_density = [0, {density}, 1, 0]\n");
            let mut params = asperity_params::from_params(&Params::default());
            // SAFETY: parameters without a table.
            unsafe { params.set_text(text.as_bytes(), Failure::from) }.expect("a table");
            params
        };
        for density in [1.0, 9.0, 1.0] {
            // SAFETY: the library keeps a table of this length.
            let kept = unsafe { std::slice::from_raw_parts(set(density).table_density, 4) };
            assert_eq!(kept, [0.0, density, 1.0, 0.0]);
        }
        assert_eq!(set(9.0).table_density, set(9.0).table_density, "each table is kept once");
    }
}
