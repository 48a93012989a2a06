//! Parameters by their names, for hosts whose input is words and numbers.

use super::boundary::{self, reference, reference_mut, wrong_struct_size, Failure};
use super::given::{nearest, Given};
use super::params::{asperity_params, ASPERITY_HEIGHTS_JOHNSON, ASPERITY_HEIGHTS_WEIBULL};
use super::setters::change;
use super::status::asperity_status;
use crate::c_string::c_string;
use crate::error::Error;
use crate::float_bits::finite;
use crate::spectrum::SpectralMoments;
use std::ffi::{c_char, CStr};
use std::mem::{offset_of, size_of};

/// A field of the parameters that is one number.
struct Field {
    name: &'static CStr,
    offset: usize,
    number: Number,
}

enum Number {
    Real(fn(&mut asperity_params) -> &mut f64),
    Whole(fn(&mut asperity_params) -> &mut i32),
}

macro_rules! fields {
    ($($number:ident $field:ident),*) => {
        [$(Field {
            name: c_string!(stringify!($field)),
            offset: offset_of!(asperity_params, $field),
            number: Number::$number(|params| &mut params.$field),
        }),*]
    };
}

/// All fields that are one number. Kurtosis, skew and shape choose the heights; in this order, with the choice itself last,
/// setting one after another what another surface has copies that surface.
static FIELDS: [Field; 24] = fields! {
    Real composite_modulus, Real effective_shear_modulus, Real work_of_adhesion, Real adhesion_range,
    Real burgers_vector, Real height_std, Real summit_radius, Real asperity_count, Whole attraction,
    Real radius_amplitude, Real radius_rate, Real slip_radius_1, Real slip_stress_1, Real slip_radius_2,
    Real slip_stress_2, Real max_friction_coefficient, Real hardness, Real tangential_modulus, Real nominal_area,
    Whole contact_law, Real kurtosis, Real skew, Real weibull_shape, Whole height_distribution
};

/// Names that are no fields: arguments of two setters, which take all of theirs at once.
static ARGUMENTS: [&CStr; MATERIALS + MOMENTS] = [c"E1", c"nu1", c"E2", c"nu2", c"m0", c"m2", c"m4"];
const MATERIALS: usize = 4;
const MOMENTS: usize = 3;

/// The names of fields, then those of arguments.
fn names() -> impl Iterator<Item = &'static CStr> {
    FIELDS.iter().map(|field| field.name).chain(ARGUMENTS)
}

/// Which of the names is given.
fn position(name: Given) -> Result<usize, Failure> {
    let found = names().position(|other| other.to_bytes() == name.text());
    found.ok_or_else(|| Failure::UnknownName { of: "parameter", name, nearest: nearest(name.text(), names()) })
}

/// Numbers by name, of which the last counts where one is given twice.
struct Numbers([Option<f64>; FIELDS.len() + ARGUMENTS.len()]);

impl Numbers {
    /// # Safety
    /// `names` and `values` are NULL or have `count` elements; names are NULL or strings.
    unsafe fn read(count: usize, names: *const *const c_char, values: *const f64) -> Result<Self, Failure> {
        let mut numbers = Self([None; FIELDS.len() + ARGUMENTS.len()]);
        if count > 0 {
            reference(names, "names")?;
            reference(values, "values")?;
        }
        for i in 0..count {
            numbers.0[position(Given::read(*names.add(i))?)?] = Some(*values.add(i));
        }
        Ok(numbers)
    }

    fn set(&self, params: &mut asperity_params) -> Result<(), Failure> {
        let together = "must be given too: E1, nu1, E2 and nu2 go together, in one call of asperity_params_set_values";
        if let Some(bodies) = self.arguments::<MATERIALS>(0, together)? {
            params.set_materials(bodies)?;
        }
        for (field, value) in FIELDS.iter().zip(self.0) {
            let Some(value) = value else { continue };
            let is_johnsons = params.height_distribution == ASPERITY_HEIGHTS_JOHNSON;
            match field.name() {
                "skew" if !is_johnsons => params.set_skew(value)?,
                _ => field.set(params, value)?,
            }
            match field.name() {
                "kurtosis" => params.height_distribution = ASPERITY_HEIGHTS_JOHNSON,
                "weibull_shape" => params.height_distribution = ASPERITY_HEIGHTS_WEIBULL,
                _ => {}
            }
        }
        // After `nominal_area`, which they need.
        let together = "must be given too: m0, m2 and m4 go together, in one call of asperity_params_set_values";
        if let Some([m0, m2, m4]) = self.arguments::<MOMENTS>(MATERIALS, together)? {
            params.set_spectral_moments(SpectralMoments { m0, m2, m4 }, params.nominal_area)?;
        }
        Ok(())
    }

    /// The arguments of a setter: all or none.
    fn arguments<const N: usize>(&self, first: usize, together: &'static str) -> Result<Option<[f64; N]>, Failure> {
        let given = &self.0[FIELDS.len() + first..][..N];
        if given.iter().all(Option::is_none) {
            return Ok(None);
        }
        let mut values = [0.0; N];
        for ((value, number), name) in values.iter_mut().zip(given).zip(&ARGUMENTS[first..]) {
            *value = number.ok_or(Failure::Name { name: text(name), says: together })?;
        }
        Ok(Some(values))
    }
}

fn text(name: &'static CStr) -> &'static str {
    name.to_str().unwrap_or_default()
}

impl Field {
    fn name(&self) -> &'static str {
        text(self.name)
    }

    fn set(&self, params: &mut asperity_params, value: f64) -> Result<(), Failure> {
        let size = match self.number {
            Number::Real(_) => size_of::<f64>(),
            Number::Whole(_) => size_of::<i32>(),
        };
        if (self.offset + size) as u64 > params.struct_size {
            let allowed = "the struct ends before the parameter named: compile with today's header";
            return Err(wrong_struct_size(params.struct_size, allowed));
        }
        match self.number {
            Number::Real(at) => *at(params) = value,
            Number::Whole(at) => {
                let fits = finite(value) && value.abs() <= f64::from(i32::MAX) && f64::from(value as i32) == value;
                if !fits {
                    let allowed = "must be a whole number, one of the constants that asperity.h lists for it";
                    return Err(Error::invalid(self.name(), value, allowed).into());
                }
                *at(params) = value as i32;
            }
        }
        Ok(())
    }

    fn get(&self, params: &mut asperity_params) -> f64 {
        match self.number {
            Number::Real(at) => *at(params),
            Number::Whole(at) => f64::from(*at(params)),
        }
    }
}

/// Sets one parameter by its name.
///
/// The same as `asperity_params_set_values` with one name: see there. Names that go together need that call.
///
/// @param params  initialised parameters; must not be NULL; untouched on failure
/// @param name    a name of `asperity_params_name`; must not be NULL; at most 64 bytes are read
/// @param value   the number; a whole one for `attraction`, `contact_law` and `height_distribution`
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message tells the
///         nearest; a number that is not whole), `ASPERITY_OUT_OF_RANGE`
///
/// Threads: any, on different structs.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_value(
    params: *mut asperity_params,
    name: *const c_char,
    value: f64,
) -> asperity_status {
    asperity_params_set_values(params, 1, &name, &value)
}

/// Sets parameters by their names, in any order, all or none.
///
/// The names are those of the fields of `asperity_params` that are one number, and of two setters: `E1`, `nu1`, `E2` and
/// `nu2` together are `asperity_params_set_materials`; `m0`, `m2` and `m4` together, with a `nominal_area` that is given
/// here or earlier, are `asperity_params_set_spectral_moments`. A field is set after them and as it is: what it may be is
/// for `asperity_create` to say.
///
/// Three names choose the heights: `weibull_shape` Weibull's, `kurtosis` Johnson's. `skew` is that of Johnson's heights if
/// they are chosen or `kurtosis` is given too, else it is `asperity_params_set_skew`. `height_distribution`, if given,
/// has the last word.
///
/// @param params  initialised parameters; must not be NULL; untouched on failure
/// @param count   how many names; may be 0
/// @param names   so many strings, of which at most 64 bytes are read; not NULL unless `count` is 0
/// @param values  so many numbers; of a name given twice the last counts; not NULL unless `count` is 0
/// @return as `asperity_params_set_value`
///
/// Threads: any, on different structs.
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
/// @param params  initialised parameters; must not be NULL
/// @param name    a name of `asperity_params_name`; must not be NULL; at most 64 bytes are read
/// @param value   receives the number; must not be NULL; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name; a name that is no field,
///         as `E1`: the struct does not keep it)
///
/// Threads: any.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_get_value(
    params: *const asperity_params,
    name: *const c_char,
    value: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let mut whole = asperity_params::read(params)?;
        let name = Given::read(name)?;
        let value = reference_mut(value, "value")?;
        let position = position(name)?;
        let Some(field) = FIELDS.get(position) else {
            let name = text(ARGUMENTS[position - FIELDS.len()]);
            let says = "is not kept: read the fields that were made of it, as composite_modulus or height_std";
            return Err(Failure::Name { name, says });
        };
        *value = field.get(&mut whole);
        Ok(())
    })
}

/// Lists the names of the parameters that are one number, for messages and to copy them.
///
/// To set one after another, in this order, what `asperity_params_get_value` read of other parameters copies those.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_params_name(index: usize) -> *const c_char {
    FIELDS.get(index).map_or(std::ptr::null(), |field| field.name.as_ptr())
}
