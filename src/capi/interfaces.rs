//! What is known of the strength of interfaces, as C sees it.

use super::boundary::{self, Failure};
use super::given;
use super::output::fill;
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::materials::{no_interface, Interface, INTERFACES};
use std::ffi::c_char;
use std::mem::size_of;

/// The measured strength of an interface, in SI units. 0 means that no source is known.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_interface_data {
    /// Set it to `sizeof(asperity_interface_data)` before the call; the library writes no more than that.
    pub struct_size: u64,
    /// tau_0 [Pa]: friction force of a contact per real area, at no pressure; 0 where only a friction coefficient is
    /// known.
    pub shear_strength: f64,
    /// kappa [-]: increase of the strength per increase of pressure; 0 if it is not known.
    pub pressure_coefficient: f64,
    /// Friction coefficient [-] measured over many contacts, where the strength of one is not known; otherwise 0.
    pub friction_coefficient: f64,
    /// The lightest load [N] of that measurement; 0 if it is not known.
    pub load: f64,
    /// The name; a constant string.
    pub name: *const c_char,
    /// Bodies, film, humidity, vacuum, temperature and loads of the measurement, as far as they are known; a constant
    /// string.
    pub conditions: *const c_char,
    /// "read": the numbers were read in the text that the reference names; "quoted": in another that quotes it. A
    /// constant string.
    pub source: *const c_char,
    /// The source of the numbers; a constant string.
    pub reference: *const c_char,
}

unsafe fn find(name: *const c_char) -> Result<&'static Interface, Failure> {
    let name = given::read(name)?;
    Interface::find(name).ok_or_else(|| Failure::invalid(format_args!("{}", no_interface(name))))
}

/// Looks an interface up by its name, "MoS2 film in dry air", and fills its data.
///
/// The numbers were measured on other specimens. Use them to start from for a similar interface. Films, humidity and wear
/// change the strength many times over: measure yours, and call `asperity_params_calibrate`. docs/materials.md lists all
/// interfaces with their sources.
///
/// @param name  one of `asperity_interface_name`
/// @param data  receives the data
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which
///         is nearest; `struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_interface(
    name: *const c_char,
    data: *mut asperity_interface_data,
) -> asperity_status {
    boundary::status(|| {
        let found = find(name)?;
        fill(data, "data", || {
            Ok(asperity_interface_data {
                struct_size: size_of::<asperity_interface_data>() as u64,
                shear_strength: found.shear_strength,
                pressure_coefficient: found.pressure_coefficient,
                friction_coefficient: found.friction_coefficient,
                load: found.load,
                name: found.name.as_ptr(),
                conditions: found.conditions.as_ptr(),
                source: found.source.as_ptr(),
                reference: found.reference.as_ptr(),
            })
        })
    })
}

/// Returns the name of an interface by its index.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
#[no_mangle]
pub extern "C" fn asperity_interface_name(index: usize) -> *const c_char {
    INTERFACES.get(index).map_or(std::ptr::null(), |interface| interface.name.as_ptr())
}

/// Sets the strength of the interface to one that was measured on other specimens, in SI units.
///
/// It sets `slip_stress_1` and `slip_stress_2` to the shear strength over `effective_shear_modulus`, since this strength does
/// not depend on the size of a contact. It sets `pressure_coefficient`, to 0 if none is known. The other parameters stay as
/// they are. Set the bodies before, in SI units (`asperity_params_set_pair`, `asperity_params_set_materials`): the modulus
/// must be in Pa.
///
/// ```c
/// asperity_params_set_pair(&params, "steel/steel");
/// asperity_params_set_interface(&params, "MoS2 film in dry air");
/// ```
///
/// Of some interfaces only a friction coefficient is known, which depends on the surfaces. The library refuses these; the
/// message says the coefficient, and what to give to `asperity_params_calibrate`.
///
/// @param params  parameters whose bodies are set
/// @param name    one of `asperity_interface_name`
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which
///         is nearest; no strength; a shear modulus that is not set, or below the strength; a struct without
///         `pressure_coefficient`)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_interface(
    params: *mut asperity_params,
    name: *const c_char,
) -> asperity_status {
    boundary::status(|| change(params, |params| params.set_interface(find(name)?)))
}
