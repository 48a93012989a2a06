//! What is known of the strength of interfaces, as C sees it.

use super::boundary::{self, Failure};
use super::given::{self, nearest, unknown};
use super::output::fill;
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::materials::{Interface, INTERFACES};
use std::ffi::c_char;
use std::mem::size_of;

/// What was measured of the strength of an interface, in SI units. 0 stands for what no source is known for.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_interface_data {
    /// Set by the caller to `sizeof(asperity_interface_data)`; the library writes no more than that.
    pub struct_size: u64,
    /// tau_0 [Pa], what a contact resists over its area, at no pressure; 0 where only a friction coefficient is known.
    pub shear_strength: f64,
    /// kappa, what the strength grows by with the pressure; 0 if it is not known.
    pub pressure_coefficient: f64,
    /// Measured over many contacts, where the strength of one is not known; else 0.
    pub friction_coefficient: f64,
    /// The lightest load [N] of that measurement; 0 if it is not known.
    pub load: f64,
    /// The name; a constant string, as the next three.
    pub name: *const c_char,
    /// Bodies, film, humidity, vacuum, temperature and loads of the measurement, as far as they are known.
    pub conditions: *const c_char,
    /// "read": the numbers were seen in the text that the reference names; "quoted": they were not.
    pub source: *const c_char,
    /// Where the numbers are from.
    pub reference: *const c_char,
}

unsafe fn find(name: *const c_char) -> Result<&'static Interface, Failure> {
    let name = given::read(name)?;
    let nearest = || nearest(name, INTERFACES.iter().map(|interface| interface.name));
    Interface::find(name).ok_or_else(|| unknown(name, "interface", nearest()))
}

/// Looks an interface up by its name: "MoS2 film in dry air". docs/materials.md has all of them, with their sources.
///
/// The numbers were measured on other specimens: they are a start for an interface like theirs. Films, humidity and wear change
/// the strength of yours many times over: measure it, and call `asperity_params_calibrate`.
///
/// @param name  one of `asperity_interface_name`; must not be NULL; at most 64 bytes are read
/// @param data  receives the numbers; must not be NULL; its `struct_size` must be set; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message tells the
///         nearest; `struct_size`)
///
/// Threads: any.
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

/// Lists the names of the interfaces.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
///
/// Threads: any.
#[no_mangle]
pub extern "C" fn asperity_interface_name(index: usize) -> *const c_char {
    INTERFACES.get(index).map_or(std::ptr::null(), |interface| interface.name.as_ptr())
}

/// Sets the strength of the interface to one that was measured elsewhere, in SI units.
///
/// Sets `slip_stress_1` and `slip_stress_2` to the shear strength over `effective_shear_modulus`, since it does not depend on the
/// size of a contact, and `pressure_coefficient`, to 0 if none is known. The other parameters stay as they are. Set the bodies
/// before, in SI units (`asperity_params_set_pair`, `asperity_params_set_materials`): the modulus must be in Pa.
///
/// Of some interfaces only a friction coefficient is known, which depends on the surfaces: they are refused, and the message
/// tells it, with what to give to `asperity_params_calibrate`.
///
/// @param params  parameters whose bodies are set; must not be NULL; untouched on failure
/// @param name    one of `asperity_interface_name`; must not be NULL; at most 64 bytes are read
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message tells the nearest; no
///         strength; a shear modulus that is not set, or below the strength; a struct without `pressure_coefficient`)
///
/// Threads: any, on different structs.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_interface(
    params: *mut asperity_params,
    name: *const c_char,
) -> asperity_status {
    boundary::status(|| change(params, |params| params.set_interface(find(name)?)))
}
