//! Parameters by their names, for hosts whose input is words and numbers.

use super::boundary::{self, not_null, reference_mut, Failure};
use super::given;
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::by_name::{Field, Numbers, ARGUMENTS, FIELDS};
use std::ffi::c_char;

fn position(name: &[u8]) -> Result<usize, Failure> {
    Numbers::position(name).ok_or_else(|| Failure::invalid(format_args!("{}", Numbers::unknown(name))))
}

/// The field of this name.
pub(super) fn field(name: &[u8]) -> Result<&'static Field, Failure> {
    let position = position(name)?;
    FIELDS.get(position).ok_or_else(|| {
        let says = "is not kept: read the fields that were made of it, as composite_modulus or height_std";
        Failure::invalid(format_args!("{}: {says}", ARGUMENTS[position - FIELDS.len()]))
    })
}

/// What a caller gives by names.
///
/// # Safety
/// `names` and `values` are NULL or have `count` elements; names are NULL or strings.
unsafe fn read(count: usize, names: *const *const c_char, values: *const f64) -> Result<Numbers, Failure> {
    let mut numbers = Numbers::default();
    if count > 0 {
        not_null(names, "names")?;
        not_null(values, "values")?;
    }
    for i in 0..count {
        numbers.give(position(given::read(*names.add(i))?)?, *values.add(i));
    }
    Ok(numbers)
}

impl asperity_params {
    /// # Safety
    /// As that of `to_params`, where a measurement is given.
    unsafe fn set_numbers(&mut self, numbers: &Numbers) -> Result<(), Failure> {
        let mut draft = self.draft()?;
        numbers.set(&mut draft)?;
        self.take(draft);
        match numbers.measured()? {
            Some((load, force)) => self.calibrate(|surfaces| surfaces.calibrate_force(load, force)),
            None => Ok(()),
        }
    }

    /// What is kept of a measurement, by the name of an argument; NaN for a coefficient that there is not.
    fn measured(&self, argument: &[u8]) -> Option<f64> {
        let (load, force) = (self.calibration_load, self.calibration_friction_force);
        match argument {
            b"calibration_load" => Some(load),
            b"calibration_friction_force" => Some(force),
            b"calibration_friction_coefficient" => Some(if load > 0.0 { force / load } else { f64::NAN }),
            _ => None,
        }
    }
}

/// Sets parameters by their names, in any order, all or none: for hosts whose input file has names and numbers.
///
/// A name is that of a field of `asperity_params` that is one number, or one of these arguments of setters:
///
/// - `E1`, `nu1`, `E2` and `nu2` together: `asperity_params_set_materials`
/// - `m0` and `m2` together, with a `nominal_area` given here or earlier: `asperity_params_set_spectral_moments`. `m4` or
///   `bandwidth` may be given too. `Ra` may replace `m0`, which is pi/2 Ra^2 for Gaussian heights
/// - `summit_density`, asperities per area, with a `nominal_area` given here or earlier: replaces `asperity_count`
/// - `calibration_load` with `calibration_friction_coefficient` or `calibration_friction_force`:
///   `asperity_params_calibrate`, which comes last
///
/// Fields are set after materials and before moments. Only choices are checked here: `asperity_create` checks the others.
///
/// Without `height_distribution`, `kurtosis` chooses Johnson's heights, `weibull_shape` without it Weibull's, and `skew` alone the
/// Weibull heights that have it, from -1.1100 to 2.
///
/// ```c
/// const char *const names[] = {"E1", "nu1", "E2", "nu2", "height_std"};
/// const double values[] = {160e9, 0.22, 160e9, 0.22, 5e-9};
/// asperity_params_set_values(&params, 5, names, values);
/// ```
///
/// @param count   number of names
/// @param names   `count` strings; not NULL unless `count` is 0
/// @param values  `count` numbers, of which the last counts where a name is given twice; not NULL unless `count` is 0
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (an unknown name; a number that is no choice;
///         a name that needs others in the same call), `ASPERITY_OUT_OF_RANGE`; with a measured friction also what
///         `asperity_params_calibrate_force` returns
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_values(
    params: *mut asperity_params,
    count: usize,
    names: *const *const c_char,
    values: *const f64,
) -> asperity_status {
    boundary::status(|| change(params, |params| params.set_numbers(&read(count, names, values)?)))
}

/// Reads one parameter by its name.
///
/// @param name    a name of `asperity_name`
/// @param value   receives the number
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name; a name that is not a
///         field, as `E1`: the struct keeps the moduli made from it)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_get_value(
    params: *const asperity_params,
    name: *const c_char,
    value: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let whole = asperity_params::read(params)?;
        let name = given::read(name)?;
        let value = reference_mut(value, "value")?;
        *value = match whole.measured(name) {
            Some(measured) => measured,
            None => field(name)?.get(&mut whole.draft()?),
        };
        Ok(())
    })
}
