//! Parameters by their names, for hosts whose input is words and numbers.

use super::boundary::{self, reference, reference_mut, wrong_struct_size, Failure};
use super::params::{asperity_params, checked_size, ASPERITY_HEIGHTS_JOHNSON, ASPERITY_HEIGHTS_WEIBULL};
use super::status::asperity_status;
use crate::error::Error;
use crate::float_bits::finite;
use crate::spectrum::SpectralMoments;
use std::ffi::{c_char, CStr};
use std::mem::{offset_of, size_of};

/// A field of the parameters that is one number.
enum Number {
    Real(fn(&mut asperity_params) -> &mut f64),
    Whole(fn(&mut asperity_params) -> &mut i32),
}

struct Field {
    name: &'static CStr,
    /// Where it ends in the struct: a caller's may be shorter.
    end: u64,
    number: Number,
}

macro_rules! field {
    ($field:ident, $variant:ident, $type:ty) => {
        Field {
            name: match CStr::from_bytes_with_nul(concat!(stringify!($field), "\0").as_bytes()) {
                Ok(name) => name,
                Err(_) => panic!(),
            },
            end: (offset_of!(asperity_params, $field) + size_of::<$type>()) as u64,
            number: Number::$variant(|params| &mut params.$field),
        }
    };
}
macro_rules! real {
    ($field:ident) => {
        field!($field, Real, f64)
    };
}
macro_rules! whole {
    ($field:ident) => {
        field!($field, Whole, i32)
    };
}

/// All fields that are one number. Kurtosis, skew and shape choose the heights; in this order, with the choice itself last,
/// setting one after another what another surface has copies that surface.
static FIELDS: [Field; 24] = [
    real!(composite_modulus),
    real!(effective_shear_modulus),
    real!(work_of_adhesion),
    real!(adhesion_range),
    real!(burgers_vector),
    real!(height_std),
    real!(summit_radius),
    real!(asperity_count),
    whole!(attraction),
    real!(radius_amplitude),
    real!(radius_rate),
    real!(slip_radius_1),
    real!(slip_stress_1),
    real!(slip_radius_2),
    real!(slip_stress_2),
    real!(max_friction_coefficient),
    real!(hardness),
    real!(tangential_modulus),
    real!(nominal_area),
    whole!(contact_law),
    real!(kurtosis),
    real!(skew),
    real!(weibull_shape),
    whole!(height_distribution),
];
const KURTOSIS: usize = 20;
const SKEW: usize = 21;
const WEIBULL_SHAPE: usize = 22;

/// Names that are no fields: arguments of setters, which take all of a group at once.
static ARGUMENTS: [&CStr; 7] = [c"E1", c"nu1", c"E2", c"nu2", c"m0", c"m2", c"m4"];
const MATERIALS: std::ops::Range<usize> = 0..4;
const MOMENTS: std::ops::Range<usize> = 4..7;

/// Longer than every name: of a caller's name no more is read.
const LONGEST: usize = 64;

/// A caller's name, as far as it is read.
#[derive(Clone, Copy)]
pub(super) struct Given {
    bytes: [u8; LONGEST],
    length: usize,
}

impl Given {
    /// # Safety
    /// `name` points to a string that ends in NUL or has `LONGEST` bytes.
    pub(super) unsafe fn read(name: &c_char) -> Self {
        let first = std::ptr::from_ref(name);
        let mut given = Self { bytes: [0; LONGEST], length: 0 };
        while given.length < LONGEST {
            // SAFETY: no byte before it is NUL.
            let byte = first.add(given.length).cast::<u8>().read();
            if byte == 0 {
                break;
            }
            given.bytes[given.length] = byte;
            given.length += 1;
        }
        given
    }

    pub(super) fn text(&self) -> &[u8] {
        &self.bytes[..self.length]
    }

    fn field(&self) -> Option<usize> {
        FIELDS.iter().position(|field| field.name.to_bytes() == self.text())
    }

    fn argument(&self) -> Option<usize> {
        ARGUMENTS.iter().position(|name| name.to_bytes() == self.text())
    }

    /// The refusal of a name that no such thing has, which tells what is meant, or else the nearest of those that are.
    pub(super) fn unknown(
        &self,
        of: &'static str,
        meant: Option<&'static CStr>,
        names: impl Iterator<Item = &'static CStr>,
    ) -> Failure {
        let nearest =
            meant.or_else(|| names.min_by_key(|name| edits(self.text(), name.to_bytes()))).unwrap_or_default();
        let nearest = nearest.to_str().unwrap_or_default();
        Failure::UnknownName { of, name: self.bytes, length: self.length, nearest }
    }

    fn unknown_parameter(&self) -> Failure {
        self.unknown("parameter", None, FIELDS.iter().map(|field| field.name).chain(ARGUMENTS))
    }
}

/// How many letters to insert, remove or replace to make one name of another, capitals or not (Levenshtein's distance).
fn edits(from: &[u8], to: &[u8]) -> usize {
    let mut row: [usize; LONGEST + 1] = std::array::from_fn(|column| column);
    for (i, letter) in from.iter().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (k, other) in to.iter().enumerate() {
            let replaced = diagonal + usize::from(!letter.eq_ignore_ascii_case(other));
            diagonal = row[k + 1];
            row[k + 1] = replaced.min(diagonal + 1).min(row[k] + 1);
        }
    }
    row[to.len()]
}

/// Numbers by name, of which the last counts where one is given twice.
struct Numbers {
    fields: [Option<f64>; FIELDS.len()],
    arguments: [Option<f64>; ARGUMENTS.len()],
}

impl Numbers {
    /// # Safety
    /// `names` and `values` are NULL or have `count` elements; names are NULL or strings.
    unsafe fn read(count: usize, names: *const *const c_char, values: *const f64) -> Result<Self, Failure> {
        let mut numbers = Self { fields: [None; FIELDS.len()], arguments: [None; ARGUMENTS.len()] };
        if count > 0 {
            reference(names, "names")?;
            reference(values, "values")?;
        }
        for i in 0..count {
            let given = Given::read(reference(*names.add(i), "name")?);
            let value = *values.add(i);
            match (given.field(), given.argument()) {
                (Some(field), _) => numbers.fields[field] = Some(value),
                (None, Some(argument)) => numbers.arguments[argument] = Some(value),
                (None, None) => return Err(given.unknown_parameter()),
            }
        }
        Ok(numbers)
    }

    /// Sets them in parameters of which the caller has so many bytes.
    fn set(&self, params: &mut asperity_params, size: u64) -> Result<(), Failure> {
        self.set_materials(params)?;
        for (i, field) in FIELDS.iter().enumerate() {
            let Some(value) = self.fields[i] else { continue };
            if i == SKEW && params.height_distribution != ASPERITY_HEIGHTS_JOHNSON {
                params.set_skew(value)?;
                continue;
            }
            field.set(params, size, value)?;
            match i {
                KURTOSIS => params.height_distribution = ASPERITY_HEIGHTS_JOHNSON,
                WEIBULL_SHAPE => params.height_distribution = ASPERITY_HEIGHTS_WEIBULL,
                _ => {}
            }
        }
        self.set_moments(params)
    }

    fn set_materials(&self, params: &mut asperity_params) -> Result<(), Failure> {
        let together = "must be given too: E1, nu1, E2 and nu2 go together, in one call of asperity_params_set_values";
        let Some(bodies) = self.group(MATERIALS, together)? else { return Ok(()) };
        params.set_materials(bodies)
    }

    /// After `nominal_area`, which they need.
    fn set_moments(&self, params: &mut asperity_params) -> Result<(), Failure> {
        let together = "must be given too: m0, m2 and m4 go together, in one call of asperity_params_set_values";
        let Some([m0, m2, m4]) = self.group(MOMENTS, together)? else { return Ok(()) };
        params.set_spectral_moments(SpectralMoments { m0, m2, m4 }, params.nominal_area)
    }

    /// The arguments of a setter: all or none.
    fn group<const N: usize>(
        &self,
        range: std::ops::Range<usize>,
        together: &'static str,
    ) -> Result<Option<[f64; N]>, Failure> {
        let given = &self.arguments[range.clone()];
        if given.iter().all(Option::is_none) {
            return Ok(None);
        }
        let mut values = [0.0; N];
        for ((value, number), name) in values.iter_mut().zip(given).zip(&ARGUMENTS[range]) {
            *value = number.ok_or(Failure::Name { name: name.to_str().unwrap_or_default(), says: together })?;
        }
        Ok(Some(values))
    }
}

impl Field {
    fn name(&self) -> &'static str {
        self.name.to_str().unwrap_or_default()
    }

    fn set(&self, params: &mut asperity_params, size: u64, value: f64) -> Result<(), Failure> {
        if self.end > size {
            return Err(wrong_struct_size(
                size,
                "the struct ends before the parameter named: compile with today's header",
            ));
        }
        match self.number {
            Number::Real(at) => *at(params) = value,
            Number::Whole(at) => {
                let fits = finite(value) && value.abs() <= f64::from(i32::MAX) && f64::from(value as i32) == value;
                if !fits {
                    let allowed = "must be a whole number, one of the constants that asperity.h lists for it";
                    return Err(Error::InvalidParameter { name: self.name(), value: value.into(), allowed }.into());
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
    boundary::status(|| set_values(params, 1, &name, &value))
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
    boundary::status(|| set_values(params, count, names, values))
}

unsafe fn set_values(
    params: *mut asperity_params,
    count: usize,
    names: *const *const c_char,
    values: *const f64,
) -> Result<(), Failure> {
    let mut whole = asperity_params::read(params)?;
    let size = checked_size(params.cast::<u64>().read())?;
    Numbers::read(count, names, values)?.set(&mut whole, size)?;
    whole.write(params, size);
    Ok(())
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
        let given = Given::read(reference(name, "name")?);
        let value = reference_mut(value, "value")?;
        match (given.field(), given.argument()) {
            (Some(field), _) => *value = FIELDS[field].get(&mut whole),
            (None, Some(argument)) => {
                let says = "is not kept: read the fields that were made of it, as composite_modulus or height_std";
                return Err(Failure::Name { name: ARGUMENTS[argument].to_str().unwrap_or_default(), says });
            }
            (None, None) => return Err(given.unknown_parameter()),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_positions_are_those_of_the_names() {
        for (position, name) in [(KURTOSIS, "kurtosis"), (SKEW, "skew"), (WEIBULL_SHAPE, "weibull_shape")] {
            assert_eq!(FIELDS[position].name(), name);
        }
        assert_eq!(ARGUMENTS[MATERIALS], [c"E1", c"nu1", c"E2", c"nu2"]);
        assert_eq!(ARGUMENTS[MOMENTS], [c"m0", c"m2", c"m4"]);
        assert!(FIELDS.iter().all(|field| field.name().len() < LONGEST));
    }

    #[test]
    fn names_are_as_far_apart_as_their_edits() {
        for (from, to, expected) in [("", "", 0), ("", "skew", 4), ("skew", "", 4), ("SKEW", "skew", 0)] {
            assert_eq!(edits(from.as_bytes(), to.as_bytes()), expected, "{from} {to}");
        }
        for (from, to, expected) in [("kitten", "sitting", 3), ("flaw", "lawn", 2), ("nu3", "nu1", 1)] {
            assert_eq!(edits(from.as_bytes(), to.as_bytes()), expected, "{from} {to}");
        }
    }
}
