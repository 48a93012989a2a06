//! Materials and pairs of them, as C sees them.

use super::boundary::{self, Failure};
use super::given;
use super::output::fill;
use super::params::asperity_params;
use super::setters::change;
use super::status::asperity_status;
use crate::materials::{no_material, Bodies, Material, NoPair, Pair, MATERIALS, PAIRS};
use std::ffi::c_char;
use std::mem::size_of;

/// What is known of a material, in SI units. 0 means that no source is known.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_material_data {
    /// Set it to `sizeof(asperity_material_data)` before the call; the library writes no more than that.
    pub struct_size: u64,
    /// Young's modulus [Pa], > 0.
    pub young: f64,
    /// The smallest published value [Pa]; 0 if no range is known.
    pub young_low: f64,
    /// The largest published value [Pa]; 0 if no range is known.
    pub young_high: f64,
    /// Poisson's ratio [-].
    pub poisson: f64,
    /// Indentation hardness [Pa]; 0 if it is not known.
    pub hardness: f64,
    /// The smallest published value [Pa]; 0 if no range is known.
    pub hardness_low: f64,
    /// The largest published value [Pa]; 0 if no range is known.
    pub hardness_high: f64,
    /// Burgers vector [m]; for a glass the distance of like atoms; 0 if there is none.
    pub burgers_vector: f64,
    /// The name; a constant string.
    pub name: *const c_char,
    /// The source of the numbers; a constant string.
    pub reference: *const c_char,
}

/// What is known of two bodies in contact, in SI units. 0 means that no source is known.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_pair_data {
    /// Set it to `sizeof(asperity_pair_data)` before the call; the library writes no more than that.
    pub struct_size: u64,
    /// Work of adhesion w [J/m^2].
    pub work_of_adhesion: f64,
    /// The smallest measurement or estimate [J/m^2]; 0 if no range is known.
    pub work_of_adhesion_low: f64,
    /// The largest measurement or estimate [J/m^2]; 0 if no range is known.
    pub work_of_adhesion_high: f64,
    /// Hamaker constant A [J] from which w is estimated, w = A/(12 pi D^2) with D = 0.165 nm; 0 if w was measured.
    pub hamaker: f64,
    /// Measured shear strength of small contacts over G* [-]; 0 if none is known.
    pub slip_stress_1: f64,
    /// The name, both materials with a slash between; a constant string.
    pub name: *const c_char,
    /// The source of w and of the strength; a constant string.
    pub reference: *const c_char,
}

/// The failure of the name of a pair that is none.
fn no_pair(name: &[u8]) -> Failure {
    Failure::invalid(format_args!("{}", NoPair(name)))
}

/// Looks a material up by its name, "steel" or "SiO2", and fills its data.
///
/// The values are typical, in SI units, and meant to start from: films, alloys and treatments differ. docs/materials.md lists
/// all materials with their sources.
///
/// @param name      one of `asperity_material_name`
/// @param material  receives the data
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which
///         is nearest; `struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_material(
    name: *const c_char,
    material: *mut asperity_material_data,
) -> asperity_status {
    boundary::status(|| {
        let name = given::read(name)?;
        let found = Material::find(name).ok_or_else(|| Failure::invalid(format_args!("{}", no_material(name))))?;
        let ([young_low, young_high], [hardness_low, hardness_high]) = (found.young_range, found.hardness_range);
        fill(material, "material", || {
            Ok(asperity_material_data {
                struct_size: size_of::<asperity_material_data>() as u64,
                young: found.young,
                young_low,
                young_high,
                poisson: found.poisson,
                hardness: found.hardness,
                hardness_low,
                hardness_high,
                burgers_vector: found.burgers_vector,
                name: found.name.as_ptr(),
                reference: found.reference.as_ptr(),
            })
        })
    })
}

/// Returns the name of a material by its index.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
#[no_mangle]
pub extern "C" fn asperity_material_name(index: usize) -> *const c_char {
    MATERIALS.get(index).map_or(std::ptr::null(), |material| material.name.as_ptr())
}

/// Looks a pair of materials up by its name, "steel/steel" or "mica/Au" in either order, and fills its data.
///
/// The work of adhesion depends on what covers the surfaces more than on the bodies: check its range and reference.
///
/// @param name  one of `asperity_pair_name`
/// @param pair  receives the data
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (two materials without data as a
///         pair: the message says what to give; unknown name: it says which is nearest; `struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_pair(name: *const c_char, pair: *mut asperity_pair_data) -> asperity_status {
    boundary::status(|| {
        let name = given::read(name)?;
        let found = Pair::find(name).ok_or_else(|| no_pair(name))?;
        let [work_of_adhesion_low, work_of_adhesion_high] = found.work_of_adhesion_range;
        fill(pair, "pair", || {
            Ok(asperity_pair_data {
                struct_size: size_of::<asperity_pair_data>() as u64,
                work_of_adhesion: found.work_of_adhesion,
                work_of_adhesion_low,
                work_of_adhesion_high,
                hamaker: found.hamaker,
                slip_stress_1: found.slip_stress_1,
                name: found.name.as_ptr(),
                reference: found.reference.as_ptr(),
            })
        })
    })
}

/// Returns the name of a pair by its index.
///
/// @param index  from 0
/// @return a constant string; NULL after the last
#[no_mangle]
pub extern "C" fn asperity_pair_name(index: usize) -> *const c_char {
    PAIRS.get(index).map_or(std::ptr::null(), |pair| pair.name.as_ptr())
}

/// Sets what is known of two materials in contact, in SI units; you set the roughness.
///
/// It sets
///
/// - E*, G* and `tangential_modulus` as `asperity_params_set_materials`
/// - `work_of_adhesion`
/// - `burgers_vector`, the longer one of both bodies, and `adhesion_range`, equal to it as in the paper
/// - `hardness`, that of the softer body, or 0 if one is not known
/// - `slip_stress_1`, where it is measured
///
/// The other parameters stay as they are. They must be in SI units too: lengths in m, areas in m^2, loads in N.
///
/// You may name any two materials. What is not known of them stays unset, as after `asperity_params_init`: the work of
/// adhesion of a pair that is not one of `asperity_pair_name`, and both lengths where a body has no Burgers vector.
/// `asperity_create` then says what is left to set.
///
/// @param params  initialised parameters
/// @param name    two of `asperity_material_name` with a slash between
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which
///         is nearest)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_pair(
    params: *mut asperity_params,
    name: *const c_char,
) -> asperity_status {
    boundary::status(|| {
        change(params, |params| {
            let name = given::read(name)?;
            params.set_bodies(&Bodies::find(name).ok_or_else(|| no_pair(name))?)
        })
    })
}
