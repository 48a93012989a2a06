//! Friction from the text of a surface in one call, with its band, as C asks for it.

use super::boundary::{self, not_null, reference, wrong_struct_size, Failure};
use super::last_error::asperity_last_error;
use super::status::asperity_status;
use super::surface_text::bytes;
use crate::estimate::{write, Answer, Estimate, Rests, Whose};
use std::ffi::c_char;
use std::mem::{align_of, size_of};

/// A `strength_source`: of other materials, known to a factor of 5 or 10.
pub const ASPERITY_STRENGTH_DEFAULT: i32 = 0;
/// A `strength_source`: rows of the table of interfaces, measured on other specimens of these bodies or of metals like them.
pub const ASPERITY_STRENGTH_TABLE: i32 = 1;
/// A `strength_source`: the text gives slip stresses, taken as known.
pub const ASPERITY_STRENGTH_GIVEN: i32 = 2;
/// A `strength_source`: measured on these surfaces.
pub const ASPERITY_STRENGTH_MEASURED: i32 = 3;

/// A `specimen`: so many asperities touch that nominally equal specimens hardly differ.
pub const ASPERITY_SPECIMEN_MANY_CONTACTS: i32 = 0;
/// A `specimen`: one specimen, whichever it is, since few asperities touch.
pub const ASPERITY_SPECIMEN_ANY: i32 = 1;
/// A `specimen`: the one that was measured, with `specimens = 1`.
pub const ASPERITY_SPECIMEN_MEASURED: i32 = 2;

/// Friction at one load, with its band, and stiffness with theirs; if few asperities touch, of one specimen. SI units.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_estimate {
    /// Set it to `sizeof(asperity_estimate)` in the first element before the call; the elements are this far apart.
    pub struct_size: u64,
    /// Normal load [N].
    pub load: f64,
    /// F/P, the median; infinite from the pull-off load to 0; 0 below.
    pub friction_coefficient: f64,
    /// Lower end of the band.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// F [N]. If load <= 0, that of surfaces which adhere.
    pub friction_force: f64,
    /// Lower end of its band.
    pub friction_force_low: f64,
    /// Upper end.
    pub friction_force_high: f64,
    /// F/P of a solver's model of the text; NaN if no strength gives what was measured.
    pub curve_coefficient: f64,
    /// Probability that F/P is within 10 % of the measured mean: above 0.8 a constant does.
    pub constant_odds: f64,
    /// Asperities in contact, by the mean of the model; NaN if loads are pressures.
    pub contacts: f64,
    /// F of another specimen than the measured one [N]; else `friction_force`.
    pub another_force: f64,
    /// Lower end of its band.
    pub another_force_low: f64,
    /// Upper end.
    pub another_force_high: f64,
    /// Share of the variance of ln(F/P) from the strength of the interface: measure friction. All shares are 0 without a band.
    pub strength_share: f64,
    /// Share from how the strength depends on the size of a contact.
    pub size_share: f64,
    /// Share from how the strength grows with pressure.
    pub pressure_share: f64,
    /// Share from adhesion: give `work_of_adhesion`.
    pub adhesion_share: f64,
    /// Share from the hardness, and from whether asperities yield.
    pub hardness_share: f64,
    /// Share from the slope and the height of the surface: measure RSm, or Ra.
    pub slope_share: f64,
    /// Share from the errors of the measured points: measure more.
    pub measurement_share: f64,
    /// Share from how real interfaces leave the law between loads: measure at this load.
    pub model_share: f64,
    /// Share from which asperities a specimen happens to have: take a heavier load.
    pub specimen_share: f64,
    /// K_t [N/m] before any contact slips; 0 for loads <= 0, as all stiffness.
    pub tangential_stiffness: f64,
    /// Lower end of its band.
    pub tangential_stiffness_low: f64,
    /// Upper end.
    pub tangential_stiffness_high: f64,
    /// -d(load)/d(gap) [N/m].
    pub normal_stiffness: f64,
    /// Lower end of its band.
    pub normal_stiffness_low: f64,
    /// Upper end.
    pub normal_stiffness_high: f64,
    /// Sum of the radii of all contacts [m]: the conductance is 2 k times it.
    pub contact_radius_sum: f64,
    /// Lower end of its band.
    pub contact_radius_sum_low: f64,
    /// Upper end.
    pub contact_radius_sum_high: f64,
    /// -d(load)/d(gap) when the load begins to fall [N/m].
    pub unloading_stiffness: f64,
    /// Lower end of its band.
    pub unloading_stiffness_low: f64,
    /// Upper end.
    pub unloading_stiffness_high: f64,
    /// Gap between the mean planes of the surfaces [m]; NaN if they are apart.
    pub gap: f64,
    /// Lower end of its band.
    pub gap_low: f64,
    /// Upper end.
    pub gap_high: f64,
    /// The largest pull that a specimen withstands [N]; NaN where specimens are alike.
    pub pull_off_force: f64,
    /// Lower end of its band.
    pub pull_off_force_low: f64,
    /// Upper end.
    pub pull_off_force_high: f64,
    /// How much the errors of points that contradict each other grew; 1: not at all.
    pub error_growth: f64,
    /// Bits `ASPERITY_WARNING_...` of states between the lightest and the heaviest load > 0.
    pub warnings: u64,
    /// What the strength of the interface rests on: one of `ASPERITY_STRENGTH_...`.
    pub strength_source: i32,
    /// 1 if the text has no area: loads are pressures [Pa], forces stresses; else 0.
    pub is_of_pressures: i32,
    /// What friction, stiffness and gap are of: one of `ASPERITY_SPECIMEN_...`.
    pub specimen: i32,
    /// On how many specimens the points were measured; 0: the text does not say.
    pub measured_specimens: i32,
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
    let estimate = Estimate::new(text)?;
    let of = |(i, &load): (usize, &f64)| estimate.at_load(load).map_err(|error| Failure::of_element(i, &error));
    let answers = loads.iter().enumerate().map(of).collect::<Result<Vec<_>, _>>()?;
    let warnings = estimate.warnings(&loads)?;
    Ok((estimate, answers, warnings))
}

/// Estimates friction at loads from the text of a surface alone, with bands: what is not measured is assumed, and its doubt is part of
/// the band.
///
/// The text is that of `asperity_params_set_text`; docs/solvers.md has its keys. For an estimate these matter: `process` of
/// `[roughness]`, where the slope is not measured; `measured`, points [load, coefficient, relative error], which narrow the band;
/// `specimens`, on how many they were measured, where fewer than 20 asperities touch; `interface`, also one with a friction coefficient
/// alone; `interface_kind`, "film", "clean", "dry metal" or "rock"; `coverage` of the band, 0.95. Give `hardness` if the metal is not
/// as hard as that of the table. It takes milliseconds, tens of them where surfaces adhere or few asperities touch, and some for each
/// load.
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
/// @return as `asperity_params_set_text`, and `ASPERITY_INVALID_LOAD` or `ASPERITY_OUT_OF_RANGE` of an element, which the message names
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
            (_, Rests::Metals | Rests::Others | Rests::GivenByDefault) => ASPERITY_STRENGTH_DEFAULT,
            (_, Rests::Rows(_) | Rests::Family(_)) => ASPERITY_STRENGTH_TABLE,
            (_, Rests::Given) => ASPERITY_STRENGTH_GIVEN,
        };
        for (i, answer) in answers.iter().enumerate() {
            let Answer { friction, force, another, gap, pull_off, .. } = *answer;
            let [tangential, normal, radii, unloading] = answer.stiffness;
            let one = asperity_estimate {
                struct_size: step,
                load: answer.load,
                friction_coefficient: friction.value,
                low: friction.low,
                high: friction.high,
                friction_force: force.value,
                friction_force_low: force.low,
                friction_force_high: force.high,
                curve_coefficient: answer.curve,
                constant_odds: answer.constant_odds,
                contacts: answer.contacts,
                another_force: another.value,
                another_force_low: another.low,
                another_force_high: another.high,
                strength_share: answer.shares.strength,
                size_share: answer.shares.size,
                pressure_share: answer.shares.pressure,
                adhesion_share: answer.shares.adhesion,
                hardness_share: answer.shares.hardness,
                slope_share: answer.shares.slope,
                measurement_share: answer.shares.measurement,
                model_share: answer.shares.model,
                specimen_share: answer.shares.specimen,
                tangential_stiffness: tangential.value,
                tangential_stiffness_low: tangential.low,
                tangential_stiffness_high: tangential.high,
                normal_stiffness: normal.value,
                normal_stiffness_low: normal.low,
                normal_stiffness_high: normal.high,
                contact_radius_sum: radii.value,
                contact_radius_sum_low: radii.low,
                contact_radius_sum_high: radii.high,
                unloading_stiffness: unloading.value,
                unloading_stiffness_low: unloading.low,
                unloading_stiffness_high: unloading.high,
                gap: gap.value,
                gap_low: gap.low,
                gap_high: gap.high,
                pull_off_force: pull_off.value,
                pull_off_force_low: pull_off.low,
                pull_off_force_high: pull_off.high,
                error_growth: estimate.growth,
                warnings,
                strength_source,
                is_of_pressures: estimate.is_of_pressures().into(),
                specimen: match answer.whose {
                    Whose::Many => ASPERITY_SPECIMEN_MANY_CONTACTS,
                    Whose::Any => ASPERITY_SPECIMEN_ANY,
                    Whose::Measured => ASPERITY_SPECIMEN_MEASURED,
                },
                measured_specimens: estimate.measured_specimens() as i32,
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

/// Writes what `asperity_estimate_at_loads` finds for people: coefficients with bands, what they rest on, and what would narrow them.
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
        Ok(write(&estimate, &answers, warnings)?)
    });
    if whole == 0 {
        let _ = asperity_last_error(buffer, buffer_length);
    }
    whole
}
