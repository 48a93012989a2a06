//! Parameters by their names, for hosts whose input is words and numbers.

use super::boundary::{self, not_null, reference_mut, Failure};
use super::given::{self, nearest, unknown};
use super::params::{asperity_params, ASPERITY_HEIGHTS_GAUSSIAN, ASPERITY_HEIGHTS_JOHNSON, ASPERITY_HEIGHTS_WEIBULL};
use super::setters::change;
use super::status::asperity_status;
use crate::c_string::c_string;
use crate::error::Error;
use crate::params::positive;
use crate::spectrum::SpectralMoments;
use std::f64::consts::FRAC_PI_2;
use std::ffi::{c_char, CStr};

/// A field of the parameters that is one number.
struct Field {
    name: &'static CStr,
    of: fn(&mut asperity_params) -> &mut dyn Number,
}

trait Number {
    fn get(&self) -> f64;
    /// Whether it can have the value, which it then has.
    fn set(&mut self, value: f64) -> bool;
}

impl Number for f64 {
    fn get(&self) -> f64 {
        *self
    }
    fn set(&mut self, value: f64) -> bool {
        *self = value;
        true
    }
}

impl Number for i32 {
    fn get(&self) -> f64 {
        (*self).into()
    }
    fn set(&mut self, value: f64) -> bool {
        *self = value as i32;
        self.get() == value
    }
}

macro_rules! fields {
    ($($field:ident)*) => {
        [$(Field {
            name: c_string!(stringify!($field)),
            of: |params| &mut params.$field,
        }),*]
    };
}

/// All fields that are one number. Shape, kurtosis and skew choose the heights; in this order, with the choice itself last,
/// setting one after another what another surface has copies that surface.
static FIELDS: [Field; 28] = fields! {
    composite_modulus effective_shear_modulus work_of_adhesion adhesion_range burgers_vector height_std summit_radius
    asperity_count attraction radius_amplitude radius_rate slip_radius_1 slip_stress_1 slip_radius_2 slip_stress_2
    max_friction_coefficient hardness tangential_modulus nominal_area pressure_coefficient bandwidth calibration_error
    contact_law slip_onset weibull_shape kurtosis skew height_distribution
};

/// Names that are no fields: arguments of setters, which take all of theirs at once.
static ARGUMENTS: [&CStr; MATERIALS + MOMENTS + 4] = [
    c"E1",
    c"nu1",
    c"E2",
    c"nu2",
    c"m0",
    c"m2",
    c"m4",
    c"Ra",
    c"calibration_load",
    c"calibration_friction_coefficient",
    c"calibration_friction_force",
];
const MATERIALS: usize = 4;
const MOMENTS: usize = 3;
/// Where in them are the roughness that may stand for m0, and the measured point.
const ROUGHNESS: usize = MATERIALS + MOMENTS;
const CALIBRATION: usize = ROUGHNESS + 1;

impl asperity_params {
    /// What is kept of a measured point: the load, the coefficient and the force, NaN or 0 if there was none.
    fn measured(&self, argument: usize) -> Option<f64> {
        let (load, force) = (self.calibration_load, self.calibration_friction_force);
        let coefficient = if load > 0.0 { force / load } else { f64::NAN };
        [load, coefficient, force].get(argument.checked_sub(CALIBRATION)?).copied()
    }
}

/// The names of fields, then those of arguments.
fn names() -> impl Iterator<Item = &'static CStr> {
    FIELDS.iter().map(|field| field.name).chain(ARGUMENTS)
}

/// Which of the names is given.
fn position(name: &[u8]) -> Result<usize, Failure> {
    let found = names().position(|other| other.to_bytes() == name);
    found.ok_or_else(|| unknown(name, "parameter", nearest(name, names())))
}

/// Numbers by name, of which the last counts where one is given twice.
struct Numbers([Option<f64>; FIELDS.len() + ARGUMENTS.len()]);

impl Numbers {
    /// # Safety
    /// `names` and `values` are NULL or have `count` elements; names are NULL or strings.
    unsafe fn read(count: usize, names: *const *const c_char, values: *const f64) -> Result<Self, Failure> {
        let mut numbers = Self([None; FIELDS.len() + ARGUMENTS.len()]);
        if count > 0 {
            not_null(names, "names")?;
            not_null(values, "values")?;
        }
        for i in 0..count {
            numbers.0[position(given::read(*names.add(i))?)?] = Some(*values.add(i));
        }
        Ok(numbers)
    }

    /// # Safety
    /// As that of `asperity_params::to_params`, where a measured point is given.
    unsafe fn set(&self, params: &mut asperity_params) -> Result<(), Failure> {
        if let Some(bodies) = self.arguments::<MATERIALS>(0, "E1, nu1, E2 and nu2")? {
            params.set_materials(bodies)?;
        }
        let chosen = self.0[position(b"height_distribution")?];
        for (field, value) in FIELDS.iter().zip(self.0) {
            let Some(value) = value else { continue };
            let is_johnsons = params.height_distribution == ASPERITY_HEIGHTS_JOHNSON;
            match text(field.name) {
                // Beside Gaussian heights a skew is refused with the parameters.
                "skew" if !is_johnsons && chosen != Some(ASPERITY_HEIGHTS_GAUSSIAN.into()) => params.set_skew(value)?,
                _ => field.set(params, value)?,
            }
            match text(field.name) {
                "kurtosis" => params.height_distribution = ASPERITY_HEIGHTS_JOHNSON,
                "weibull_shape" => {
                    params.height_distribution = ASPERITY_HEIGHTS_WEIBULL;
                    (params.skew, params.kurtosis) = (0.0, 3.0);
                }
                _ => {}
            }
        }
        // After `nominal_area`, which they need.
        if let Some([m0, m2, m4]) = self.with_roughness()?.arguments::<MOMENTS>(MATERIALS, "m0, m2 and m4")? {
            params.set_spectral_moments(SpectralMoments { m0, m2, m4 }, params.nominal_area)?;
        }
        self.calibrate(params)
    }

    /// With m0 from Ra, where that is given: of Gaussian heights the mean deviation is (2/pi)^(1/2) times the standard one.
    fn with_roughness(&self) -> Result<Self, Failure> {
        let mut numbers = Self(self.0);
        let [ra, m0] = [ROUGHNESS, MATERIALS].map(|argument| FIELDS.len() + argument);
        if let Some(roughness) = self.0[ra] {
            if self.0[m0].is_some() {
                return Err(Failure::invalid(format_args!(
                    "Ra: must not be given together with m0, which it replaces"
                )));
            }
            positive("Ra", roughness)?;
            numbers.0[m0] = Some(FRAC_PI_2 * roughness * roughness);
        }
        Ok(numbers)
    }

    /// Scales the slip stresses to the measured point, where one is given.
    unsafe fn calibrate(&self, params: &mut asperity_params) -> Result<(), Failure> {
        let [load, coefficient, force] = std::array::from_fn(|i| self.0[FIELDS.len() + CALIBRATION + i]);
        match (load, coefficient, force) {
            (None, None, None) => Ok(()),
            (Some(load), Some(coefficient), None) => params.calibrate(|surfaces| surfaces.calibrate(load, coefficient)),
            (Some(load), None, Some(force)) => params.calibrate(|surfaces| surfaces.calibrate_force(load, force)),
            _ => Err(Failure::invalid(format_args!(
                "calibration_load: must be given together with calibration_friction_coefficient or \
                 calibration_friction_force, and with one of the two alone, in one call of asperity_params_set_values"
            ))),
        }
    }

    /// The arguments of a setter: all or none.
    fn arguments<const N: usize>(&self, first: usize, all: &str) -> Result<Option<[f64; N]>, Failure> {
        let given = &self.0[FIELDS.len() + first..][..N];
        let Some(missing) = given.iter().position(Option::is_none) else {
            return Ok(Some(std::array::from_fn(|i| given[i].unwrap_or_default())));
        };
        if given.iter().all(Option::is_none) {
            return Ok(None);
        }
        let (name, call) = (text(ARGUMENTS[first + missing]), "asperity_params_set_values");
        Err(Failure::invalid(format_args!("{name}: must be given too: {all} go together, in one call of {call}")))
    }
}

fn text(name: &'static CStr) -> &'static str {
    name.to_str().unwrap_or_default()
}

impl Field {
    fn set(&self, params: &mut asperity_params, value: f64) -> Result<(), Failure> {
        if !(self.of)(params).set(value) {
            let allowed = "must be a whole number, one of the constants that asperity.h lists for it";
            return Err(Error::invalid(text(self.name), value, allowed).into());
        }
        Ok(())
    }
}

/// Sets one parameter by its name, as `asperity_params_set_values` does with one name.
///
/// @param params  initialised parameters
/// @param name    a name of `asperity_params_name`
/// @param value   the number, in the units of the other parameters; an integer for `attraction`, `contact_law` and
///                `height_distribution`
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which
///         is nearest; a number that must be an integer; a name that needs others in the same call),
///         `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_value(
    params: *mut asperity_params,
    name: *const c_char,
    value: f64,
) -> asperity_status {
    asperity_params_set_values(params, 1, &name, &value)
}

/// Sets parameters by their names, in any order, all or none: for hosts whose input file has names and numbers.
///
/// A name is that of a field of `asperity_params` that is one number, or one of these arguments of setters:
///
/// - `E1`, `nu1`, `E2` and `nu2` together: `asperity_params_set_materials`
/// - `m0`, `m2` and `m4` together, with a `nominal_area` given here or earlier: `asperity_params_set_spectral_moments`.
///   `Ra` may replace `m0`, which is pi/2 Ra^2 for Gaussian heights
/// - `calibration_load` with `calibration_friction_coefficient` or `calibration_friction_force`:
///   `asperity_params_calibrate`, which comes last
///
/// Fields are set after materials and before moments, and are not checked here: `asperity_create` checks them.
///
/// Three names choose the heights. `kurtosis` chooses Johnson's. `weibull_shape` without it chooses Weibull's. `skew` is that
/// of Johnson's heights if they are chosen or `kurtosis` is given too; otherwise it is `asperity_params_set_skew`.
/// `height_distribution`, if given, decides; `asperity_create` refuses a skew or kurtosis that these heights do not read.
///
/// ```c
/// const char *const names[] = {"E1", "nu1", "E2", "nu2", "height_std"};
/// const double values[] = {160e9, 0.22, 160e9, 0.22, 5e-9};
/// asperity_params_set_values(&params, 5, names, values);
/// ```
///
/// @param params  initialised parameters
/// @param count   number of names
/// @param names   `count` strings, of which the library reads at most 64 bytes; not NULL unless `count` is 0
/// @param values  `count` numbers; the last counts where a name is given twice; not NULL unless `count` is 0
/// @return as `asperity_params_set_value`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_values(
    params: *mut asperity_params,
    count: usize,
    names: *const *const c_char,
    values: *const f64,
) -> asperity_status {
    boundary::status(|| change(params, |params| Numbers::read(count, names, values)?.set(params)))
}

/// Reads one parameter by its name.
///
/// @param params  initialised parameters
/// @param name    a name of `asperity_params_name`
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
        let mut whole = asperity_params::read(params)?;
        let name = given::read(name)?;
        let value = reference_mut(value, "value")?;
        let position = position(name)?;
        let Some(field) = FIELDS.get(position) else {
            if let Some(measured) = whole.measured(position - FIELDS.len()) {
                *value = measured;
                return Ok(());
            }
            let name = text(ARGUMENTS[position - FIELDS.len()]);
            let says = "is not kept: read the fields that were made of it, as composite_modulus or height_std";
            return Err(Failure::invalid(format_args!("{name}: {says}")));
        };
        *value = (field.of)(&mut whole).get();
        Ok(())
    })
}

/// Returns the name of a parameter that is one number, by its index: for messages, and to copy parameters.
///
/// To copy parameters, read all names with `asperity_params_get_value` and set them one after another in this order. Heights by a
/// table and the measurement of a calibration are not among them: copy the struct, or `asperity_params_text`.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
#[no_mangle]
pub extern "C" fn asperity_params_name(index: usize) -> *const c_char {
    FIELDS.get(index).map_or(std::ptr::null(), |field| field.name.as_ptr())
}
