//! Friction from the text of a surface in one call, with its band, as C asks for it.

use super::boundary::{self, not_null, reference, wrong_struct_size, Failure};
use super::last_error::asperity_last_error;
use super::status::asperity_status;
use super::surface_text::bytes;
use crate::estimate::known::DEFAULT_FACTOR;
use crate::estimate::{write, Answer, Estimate, Rests};
use std::ffi::c_char;
use std::mem::{align_of, size_of};

/// A `strength_source`: the default strength, an order of magnitude.
pub const ASPERITY_STRENGTH_DEFAULT: i32 = 0;
/// A `strength_source`: a row of the table of interfaces, or the rows of these bodies, measured on other specimens.
pub const ASPERITY_STRENGTH_TABLE: i32 = 1;
/// A `strength_source`: the text gives slip stresses or a pressure coefficient, taken as known.
pub const ASPERITY_STRENGTH_GIVEN: i32 = 2;
/// A `strength_source`: measured on these surfaces.
pub const ASPERITY_STRENGTH_MEASURED: i32 = 3;
/// A default strength and a true one are within this factor either way with a probability of 95 %.
pub const ASPERITY_STRENGTH_FACTOR: i32 = 10;
const _: () = assert!(ASPERITY_STRENGTH_FACTOR as f64 == DEFAULT_FACTOR);

/// Friction at one load, with its band. SI units.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_estimate {
    /// Set it to `sizeof(asperity_estimate)` in the first element before the call; the elements are this far apart.
    pub struct_size: u64,
    /// Normal load [N].
    pub load: f64,
    /// F/P; infinite from the pull-off load to 0, where F/P has no limit; 0 below. There is no cap.
    pub friction_coefficient: f64,
    /// Lower end of the band, which is without the scatter of specimens.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// F [N].
    pub friction_force: f64,
    /// Summits in contact, by the mean of the model; NaN if loads are pressures, as the next two.
    pub contacts: f64,
    /// Mean F of single specimens with this strength [N], NaN if not known; if contacts < 1 of one summit, had once or twice.
    pub specimen_force: f64,
    /// Its standard deviation over it, from specimen to specimen; NaN if contacts < 1, or if not known.
    pub specimen_scatter: f64,
    /// Share of the variance of ln(F/P) from the strength of the interface: measure friction. 0 without a band.
    pub strength_share: f64,
    /// Share from the roughness: measure RSm, or Ra.
    pub roughness_share: f64,
    /// Share from the errors of the measured points and what they leave open: measure more.
    pub measurement_share: f64,
    /// How far the measured points are off the law, root mean square in their errors; above 2 it cannot follow them.
    pub misfit: f64,
    /// Bits `ASPERITY_WARNING_...` of states between the lightest and the heaviest load > 0.
    pub warnings: u64,
    /// What the strength of the interface rests on: one of `ASPERITY_STRENGTH_...`.
    pub strength_source: i32,
    /// 1 if the text has no area: loads are pressures [Pa], forces stresses; else 0.
    pub is_of_pressures: i32,
}

/// The text and the loads of a caller, and what the library makes of them.
///
/// # Safety
/// The pointers are NULL or have as many elements as is said.
unsafe fn estimated(
    surface: *const c_char,
    length: usize,
    n: usize,
    load: *const f64,
) -> Result<(Estimate, Vec<Answer>, u64), Failure> {
    not_null(surface, "surface")?;
    if n > 0 {
        not_null(load, "load")?;
    }
    let text = bytes(surface, length);
    let loads: Vec<f64> = (0..n).map(|i| load.add(i).read_unaligned()).collect();
    let estimate = Estimate::new(text, &loads)?;
    let of = |(i, &load): (usize, &f64)| estimate.at_load(load).map_err(|error| Failure::of_element(i, &error));
    let answers = loads.iter().enumerate().map(of).collect::<Result<Vec<_>, _>>()?;
    let warnings = estimate.warnings(&loads)?;
    Ok((estimate, answers, warnings))
}

/// Estimates friction at loads from the text of a surface alone, with bands: what is not measured is assumed, and its doubt is
/// part of the band.
///
/// The text is that of `asperity_params_set_text`; docs/solvers.md has its keys. For an estimate these matter: `process` of
/// `[roughness]`, where the slope is not measured; `measured`, points [load, coefficient, relative error], which narrow the band;
/// `interface`, also one with a friction coefficient alone; `coverage` of the band, 0.95. Give `hardness` if the metal is not as hard
/// as that of the table. It takes tens of milliseconds, and up to one for each load.
///
/// ```c
/// const char surface[] = "pair = \"steel/steel\"\n nominal_area = 1e-4\n measured = [1000, 0.16]\n"
///                        "[roughness]\n Ra = 0.8e-6\n process = \"ground\"\n";
/// double load = 10.0;
/// asperity_estimate found;
/// found.struct_size = sizeof found;
/// if (asperity_estimate_at_loads(surface, sizeof surface - 1, 1, &load, &found) == ASPERITY_OK)
///     printf("%.3f (%.3f to %.3f)\n", found.friction_coefficient, found.low, found.high);
/// ```
///
/// @param surface    UTF-8, as of `asperity_params_set_text`
/// @param length     of the text [bytes], without a NUL
/// @param load       normal loads [N]
/// @param estimates  receives n estimates; unchanged on failure
/// @return as `asperity_params_set_text`, and `ASPERITY_INVALID_LOAD` or `ASPERITY_OUT_OF_RANGE` of an element, which the
///         message names
#[no_mangle]
pub unsafe extern "C" fn asperity_estimate_at_loads(
    surface: *const c_char,
    length: usize,
    n: usize,
    load: *const f64,
    estimates: *mut asperity_estimate,
) -> asperity_status {
    boundary::status(|| {
        let mut step = 0;
        if n > 0 {
            // SAFETY: struct_size is the first field, and the caller has set it.
            step = *reference(estimates.cast::<u64>(), "estimates")?;
            if step < 16 || step % align_of::<asperity_estimate>() as u64 != 0 || step > LARGEST {
                return Err(wrong_struct_size(step, "must be set to sizeof(asperity_estimate) in the first element"));
            }
        }
        let (estimate, answers, warnings) = estimated(surface, length, n, load)?;
        let strength_source = match (estimate.is_measured(), estimate.rests()) {
            (true, _) => ASPERITY_STRENGTH_MEASURED,
            (_, Rests::Default) => ASPERITY_STRENGTH_DEFAULT,
            (_, Rests::Rows(_) | Rests::Pair) => ASPERITY_STRENGTH_TABLE,
            (_, Rests::Given) => ASPERITY_STRENGTH_GIVEN,
        };
        for (i, answer) in answers.iter().enumerate() {
            let one = asperity_estimate {
                struct_size: step,
                load: answer.load,
                friction_coefficient: answer.friction_coefficient,
                low: answer.low,
                high: answer.high,
                friction_force: answer.friction_force,
                contacts: answer.contacts,
                specimen_force: answer.specimen_force,
                specimen_scatter: answer.specimen_scatter,
                strength_share: answer.strength_share,
                roughness_share: answer.roughness_share,
                measurement_share: answer.measurement_share,
                misfit: estimate.misfit,
                warnings,
                strength_source,
                is_of_pressures: estimate.is_of_pressures().into(),
            };
            let count = size_of::<asperity_estimate>().min(step as usize);
            // SAFETY: the caller says that n elements are so far apart.
            let to = estimates.cast::<u8>().add(i * step as usize);
            std::ptr::copy_nonoverlapping((&raw const one).cast::<u8>(), to, count);
        }
        Ok(())
    })
}

/// No struct of a later version is larger [bytes].
const LARGEST: u64 = 4096;

/// Writes what `asperity_estimate_at_loads` finds for people: coefficients with their bands, what they rest on, warnings, and what
/// would narrow the bands.
///
/// @param surface,length,n,load  as of `asperity_estimate_at_loads`
/// @return the length; 0 on failure: the buffer has what `asperity_last_error` has then
#[no_mangle]
pub unsafe extern "C" fn asperity_estimate_text(
    surface: *const c_char,
    length: usize,
    n: usize,
    load: *const f64,
    buffer: *mut c_char,
    buffer_length: usize,
) -> usize {
    let whole = boundary::written(buffer, buffer_length, || {
        let (estimate, answers, warnings) = estimated(surface, length, n, load)?;
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = write(&estimate, bytes(surface, length), &answers, warnings, &mut text);
        Ok(text)
    });
    if whole == 0 {
        let _ = asperity_last_error(buffer, buffer_length);
    }
    whole
}
