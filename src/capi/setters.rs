//! Functions that set parameters, and convert them, as C calls them.

use super::boundary::{self, not_null, Failure};
use super::given;
use super::params::{asperity_params, check_size};
use super::status::asperity_status;
use crate::error::Error;
use crate::materials::{Bodies, NoPair};
use crate::params::spectrum::SpectralMoments;
use crate::params::Params;
use std::ffi::c_char;

/// Changes the caller's parameters; what `set` does not change stays bit for bit, and all of it where it fails.
///
/// # Safety
/// `params` is NULL or of the size that it says.
pub(super) unsafe fn change(
    params: *mut asperity_params,
    set: impl FnOnce(&mut asperity_params) -> Result<(), Failure>,
) -> Result<(), Failure> {
    let mut whole = asperity_params::read(params)?;
    set(&mut whole)?;
    *params = whole;
    Ok(())
}

/// Changes the caller's parameters, all but a table of heights, as the library does.
///
/// # Safety
/// As that of `change`.
unsafe fn change_draft(
    params: *mut asperity_params,
    set: impl FnOnce(&mut Params) -> Result<(), Error>,
) -> Result<(), Failure> {
    change(params, |params| {
        let mut draft = params.draft()?;
        set(&mut draft.params)?;
        params.take(draft);
        Ok(())
    })
}

/// Prepares parameters: defaults for all fields but the eight physical inputs, which are left unset.
///
/// The inputs `composite_modulus` to `asperity_count` become NaN, and `asperity_create` refuses the first that you did not set:
/// "asperity_count: must be set".
///
/// @param params       receives the parameters
/// @param struct_size  `sizeof(asperity_params)` [bytes]
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_init(params: *mut asperity_params, struct_size: usize) -> asperity_status {
    boundary::status(|| {
        not_null(params, "params")?;
        check_size(struct_size as u64)?;
        params.write(asperity_params::from_params(&Params::default()));
        Ok(())
    })
}

/// Sets material, adhesion and roughness from the paper's dimensionless groups, eqs (7) and (8).
///
/// The paper's case is alpha = 0.01, beta = 1000, gamma = 0.001, b/h = 1, nu = 0.3, in units b = G = N = 1: E* = 2/(1 - nu), G* = 2,
/// sigma = alpha beta, R = beta/alpha, w = gamma E*. Loads are then P/(N G b^2).
///
/// @param alpha     (sigma/R)^(1/2) > 0, surface roughness
/// @param beta      (R sigma)^(1/2)/b > 0, friction regime
/// @param gamma     w/(E* b) >= 0, surface energy
/// @param b_over_h  Burgers vector over range of adhesion > 0, typically 1
/// @param poisson   Poisson's ratio, above -1, at most 0.5
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_dimensionless(
    params: *mut asperity_params,
    alpha: f64,
    beta: f64,
    gamma: f64,
    b_over_h: f64,
    poisson: f64,
) -> asperity_status {
    boundary::status(|| change_draft(params, |params| params.set_dimensionless(alpha, beta, gamma, b_over_h, poisson)))
}

/// Sets E*, G* and `tangential_modulus` from Young's modulus and Poisson's ratio of the two bodies.
///
/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, G* = 2 G1 G2/(G1 + G2) and 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2 with G = E/(2 (1 + nu)).
///
/// @param E1,E2   Young's moduli [stress] > 0; INFINITY is a rigid body, which at most one may be
/// @param nu1,nu2 Poisson's ratios, above -1, at most 0.5
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
#[allow(non_snake_case)]
pub unsafe extern "C" fn asperity_params_set_materials(
    params: *mut asperity_params,
    E1: f64,
    nu1: f64,
    E2: f64,
    nu2: f64,
) -> asperity_status {
    boundary::status(|| change_draft(params, |params| params.set_materials(E1, nu1, E2, nu2)))
}

/// Sets the roughness from the spectral moments of an isotropic surface, rough on however many scales.
///
/// m0, m2 and m4 are the variances of height z, slope dz/dx and curvature d2z/dx2 along a profile: m0 = Rq^2 = Sq^2,
/// m2 = Rdq^2 = Sdq^2/2. For two rough surfaces, add their moments. The area of contact, its patches and its stiffness depend
/// on m0 and m2, hardly on m4. docs/roughness.md has the formulas. Sets `height_std`, `summit_radius`, `asperity_count`,
/// `radius_amplitude`, `radius_rate`, `summit_mean_height`, `nominal_area` and `rms_slope` = (2 m2)^(1/2), and `bandwidth` to 0.
///
/// @param m0            variance of the heights [length^2] > 0
/// @param m2            variance of the slopes [-] > 0
/// @param m4            variance of the curvatures [1/length^2] > 0, m0 m4/m2^2 at least 1.5; 0: not known
/// @param nominal_area  [length^2] > 0
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_spectral_moments(
    params: *mut asperity_params,
    m0: f64,
    m2: f64,
    m4: f64,
    nominal_area: f64,
) -> asperity_status {
    let moments = SpectralMoments { m0, m2, m4 };
    boundary::status(|| change_draft(params, |params| params.set_spectral_moments(moments, nominal_area)))
}

/// Sets what is known of two materials in contact, in SI units; you set the roughness.
///
/// It sets the moduli, `work_of_adhesion`, `burgers_vector`, the longer one of both bodies, `adhesion_range`, equal to it as in the
/// paper, `hardness`, that of the softer body, or 0, and `slip_stress_1`, where it is measured.
///
/// You may name any two materials. What is not known of them stays unset, as after `asperity_params_init`.
///
/// @param name    two materials of `asperity_name` with a slash between
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (unknown name: the message says which is nearest)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_pair(
    params: *mut asperity_params,
    name: *const c_char,
) -> asperity_status {
    boundary::status(|| {
        let name = given::read(name)?;
        let bodies = Bodies::find(name).ok_or_else(|| Failure::invalid(format_args!("{}", NoPair(name))))?;
        change_draft(params, |params| params.set_bodies(&bodies))
    })
}

/// Converts all parameters into other units: those of a surface file, which are SI, into the units of a solver.
///
/// Numbers without a unit and tables of heights stay as they are, and so does what is unset. Call it once, after all else that has SI
/// units: `length_unit` and `force_unit` keep the units, and parameters that are not in SI units by them refuse another conversion,
/// names of materials, and texts in SI units. (1e-3, 1.0) converts SI into mm, N and MPa.
///
/// @param length  the new unit of length in the present one, > 0: 1e-3 from m to mm
/// @param force   the new unit of force in the present one, > 0
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (also if they were converted before),
///         `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_units(
    params: *mut asperity_params,
    length: f64,
    force: f64,
) -> asperity_status {
    boundary::status(|| change_draft(params, |params| params.set_units(length, force)))
}
