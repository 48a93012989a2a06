//! Where the model holds, as C asks: warnings of a range of loads, and what they mean.

use super::boundary::{self, reference_mut};
use super::model::{self, asperity_model};
use super::status::asperity_status;
use super::text::write_text;
use crate::model::validity;
use std::ffi::c_char;

/// Bit of `warnings`: asperities yield, but the contact law is elastic. Set if the mean asperity pressure is above 0.4 of the
/// hardness (yield begins below the surface) or the plasticity index above 1 (contacts flow at any load). Never set without
/// a hardness, nor for `ASPERITY_CONTACT_ELASTIC_PLASTIC`, which models yielding.
pub const ASPERITY_WARNING_PLASTIC: u64 = 1;
/// Bit of `warnings`: asperities do not act independently. Set if the real area is more than 10 % of a known
/// `nominal_area`, or, without `rms_slope`, more than 10 % of the asperities touch. Never set if `asperity_count` is 1.
pub const ASPERITY_WARNING_CROWDED: u64 = 2;
/// Bit of `warnings`: contacts are not small compared with their asperities. Set if `rms_slope` is above 0.3, or, if it is not
/// given, contact radii are more than a tenth of the asperity radii, on average.
pub const ASPERITY_WARNING_STEEP: u64 = 4;
/// Bit of `warnings`: contacts have few atoms. Set if their mean radius is below `burgers_vector`.
pub const ASPERITY_WARNING_ATOMIC: u64 = 8;
/// Bit of `warnings`: averages are not reliable at this load. Set if fewer than 20 asperities touch. Never set if
/// `asperity_count` is 1, where loads are those of a mean asperity.
pub const ASPERITY_WARNING_FEW: u64 = 16;
/// Bit of `warnings`: adhesion presses the surfaces together with more than the load. Set if `hertz_load` is more than twice
/// the load. Never set if `asperity_count` is 1, as for single asperities.
pub const ASPERITY_WARNING_ADHESIVE: u64 = 32;
/// Bit of `warnings`: the strength of the interface is the default, which was not measured on these surfaces. Set while both
/// slip stresses are the defaults, `pressure_coefficient` is 0 and nothing was calibrated. With the default the model predicts
/// up to 14 times too little or 26 times too much friction: call `asperity_params_calibrate`.
pub const ASPERITY_WARNING_UNCALIBRATED: u64 = 64;
/// Bit of `warnings`: summits that were counted stand on summits, as the surface is rough on many scales. Set if Nayak's
/// bandwidth is above 6: the `bandwidth` given, or that of this many summits on `nominal_area`. Never set after
/// `asperity_params_set_spectral_moments`.
pub const ASPERITY_WARNING_BROAD: u64 = 128;
/// Bit of `warnings`: the interface is stronger than the softer body, which shears at H/(3 sqrt 3). Set if the slip stress at
/// the mean contact radius is larger. Never set without a hardness.
pub const ASPERITY_WARNING_STRONG: u64 = 256;
/// Bit of `warnings`: one piece of the surface is not like another. Set if fewer than 8 mean waves, of the length 2 pi
/// `height_std`/`rms_slope`, fit a side of `nominal_area`; never set if one of these is not known.
pub const ASPERITY_WARNING_FEW_WAVES: u64 = 512;
/// Bit of `warnings`: heights at scores do not describe flat tops. Set if more than a quarter of the load is where heights change by
/// less than 0.15 Sq from one score to the next, that is by 1. Never set without a table of them.
pub const ASPERITY_WARNING_FLAT_TOP: u64 = 1024;
/// Bit of `warnings`: heights are known not to be Gaussian, but taken as such. Set by `taken_as_gaussian`.
pub const ASPERITY_WARNING_NOT_GAUSSIAN: u64 = 2048;

/// These bits are those of the model, each once.
const _: () = {
    assert!(
        ASPERITY_WARNING_PLASTIC == validity::WARNING_PLASTIC
            && ASPERITY_WARNING_CROWDED == validity::WARNING_CROWDED
            && ASPERITY_WARNING_STEEP == validity::WARNING_STEEP
            && ASPERITY_WARNING_ATOMIC == validity::WARNING_ATOMIC
            && ASPERITY_WARNING_FEW == validity::WARNING_FEW
            && ASPERITY_WARNING_ADHESIVE == validity::WARNING_ADHESIVE
            && ASPERITY_WARNING_UNCALIBRATED == validity::WARNING_UNCALIBRATED
            && ASPERITY_WARNING_BROAD == validity::WARNING_BROAD
            && ASPERITY_WARNING_STRONG == validity::WARNING_STRONG
            && ASPERITY_WARNING_FEW_WAVES == validity::WARNING_FEW_WAVES
            && ASPERITY_WARNING_FLAT_TOP == validity::WARNING_FLAT_TOP
            && ASPERITY_WARNING_NOT_GAUSSIAN == validity::WARNING_NOT_GAUSSIAN
            && 2 * ASPERITY_WARNING_NOT_GAUSSIAN == validity::EVERY_WARNING + 1
    );
};

/// Computes the warnings of all states from one load to another: whether the model holds for a contact that meets these loads.
///
/// It takes milliseconds: call it at the start of a run.
///
/// ```c
/// uint64_t warnings = 0;
/// char text[2048];
/// if (asperity_check_loads(model, 1e-4, 1e-2, &warnings) == ASPERITY_OK && warnings != 0) {
///     asperity_warnings_text(warnings, text, sizeof text);
///     fprintf(stderr, "%s\n", text);
/// }
/// ```
///
/// @param lightest  normal load [force], from the pull-off load upwards; above 0 without adhesion, where nothing touches at 0
/// @param heaviest  normal load [force], not below `lightest`
/// @param warnings  receives every bit `ASPERITY_WARNING_...` that is set in a state between; 0 if nothing is known to fail
/// @return `ASPERITY_OK`, also with warnings; `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`lightest` is above `heaviest`),
///         `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`, `ASPERITY_OUT_OF_RANGE`, `ASPERITY_NOT_CONVERGED`
#[no_mangle]
pub unsafe extern "C" fn asperity_check_loads(
    model: *const asperity_model,
    lightest: f64,
    heaviest: f64,
    warnings: *mut u64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        let warnings = reference_mut(warnings, "warnings")?;
        *warnings = model.check_loads(lightest, heaviest)?;
        Ok(())
    })
}

/// Copies the texts of several warnings, one line each: what fails and what to do about it.
///
/// @param warnings  bits `ASPERITY_WARNING_...`; a line "unknown warning" stands for all others
/// @return the length of the text, "no warning" for 0
#[no_mangle]
pub unsafe extern "C" fn asperity_warnings_text(warnings: u64, buffer: *mut c_char, length: usize) -> usize {
    let known = validity::WARNING_TEXTS.iter().filter(|(_, bit, _)| warnings & bit != 0).map(|(.., says)| *says);
    let rest = match warnings & !validity::EVERY_WARNING {
        0 if warnings != 0 => None,
        0 => Some(c"no warning"),
        _ => Some(c"unknown warning"),
    };
    let lines = known.chain(rest).enumerate();
    write_text(buffer, length, lines.flat_map(|(i, line)| [if i > 0 { &b"\n"[..] } else { b"" }, line.to_bytes()]))
}
