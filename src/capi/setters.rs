//! Functions that set parameters, as C calls them.

use super::boundary::{self, not_null, Failure};
use super::params::{asperity_params, check_size};
use super::status::asperity_status;
use crate::error::Error;
use crate::materials::{Bodies, Interface};
use crate::params::Params;
use crate::spectrum::SpectralMoments;

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

/// Takes fields of the same names.
macro_rules! take {
    ($from:expr => $to:ident; $($field:ident)*) => {{
        let made = $from;
        $($to.$field = made.$field;)*
        Ok(())
    }};
}

/// What a setter of the library makes of the default parameters.
fn made(set: impl FnOnce(&mut Params) -> Result<(), Error>) -> Result<asperity_params, Failure> {
    let mut params = Params::paper();
    set(&mut params)?;
    Ok(asperity_params::from_params(&params))
}

/// What the functions below set, and those of pairs of materials and of interfaces.
impl asperity_params {
    pub(super) fn set_materials(&mut self, [young_1, poisson_1, young_2, poisson_2]: [f64; 4]) -> Result<(), Failure> {
        take! { made(|params| params.set_materials(young_1, poisson_1, young_2, poisson_2))? => self;
            composite_modulus effective_shear_modulus tangential_modulus
        }
    }

    pub(super) fn set_bodies(&mut self, bodies: &Bodies) -> Result<(), Failure> {
        let set = |params: &mut Params| {
            params.slip.stress_1 = self.slip_stress_1;
            params.set_bodies(bodies)
        };
        take! { made(set)? => self;
            composite_modulus effective_shear_modulus tangential_modulus work_of_adhesion adhesion_range burgers_vector
            hardness slip_stress_1
        }
    }

    pub(super) fn set_interface(&mut self, interface: &'static Interface) -> Result<(), Failure> {
        let set = |params: &mut Params| {
            params.effective_shear_modulus = self.effective_shear_modulus;
            params.set_interface(interface)
        };
        take! { made(set)? => self; slip_stress_1 slip_stress_2 pressure_coefficient calibration_load calibration_friction_force }
    }

    /// What one of two ways makes of spectral moments.
    fn set_summits(&mut self, set: impl FnOnce(&mut Params) -> Result<(), Error>) -> Result<(), Failure> {
        take! { made(set)? => self;
            height_std summit_radius asperity_count nominal_area bandwidth radius_amplitude radius_rate summit_mean_height
            rms_slope
        }
    }

    pub(super) fn set_skew(&mut self, skew: f64) -> Result<(), Failure> {
        take! { made(|params| params.set_skew(skew))? => self;
            height_distribution weibull_shape skew kurtosis
        }
    }
}

/// Prepares parameters: defaults for all fields but the eight physical inputs, which are left unset.
///
/// The inputs `composite_modulus` to `asperity_count` become NaN. `asperity_create` then refuses the first that you did not
/// set, with the message "asperity_count: must be set".
///
/// For two bodies of polysilicon, in SI units (Pa, J/m^2, m):
///
/// ```c
/// asperity_params_init(&params, sizeof params);
/// asperity_params_set_materials(&params, 160e9, 0.22, 160e9, 0.22);
/// params.work_of_adhesion = 0.063;
/// params.adhesion_range = params.burgers_vector = 0.384e-9;
/// asperity_params_set_spectral_moments(&params, 2.5e-17, 4e-3, 2e12, 1e-8);
/// ```
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
/// The paper's case is alpha = 0.01, beta = 1000, gamma = 0.001, b/h = 1, nu = 0.3. The units are the paper's, b = 1, G = 1,
/// N = 1: E* = 2/(1 - nu), G* = 2, sigma = alpha beta, R = beta/alpha,
/// w = gamma E*, h = 1/(b/h). Loads are then P/(N G b^2). `tangential_modulus` becomes 0, its default, which is exact for
/// these bodies. The other parameters stay as they are.
///
/// @param params    initialised parameters
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
    boundary::status(|| {
        change(params, |params| {
            take! { made(|changed| changed.set_dimensionless(alpha, beta, gamma, b_over_h, poisson))? => params;
                composite_modulus effective_shear_modulus work_of_adhesion adhesion_range burgers_vector height_std
                summit_radius asperity_count tangential_modulus
            }
        })
    })
}

/// Sets E*, G* and `tangential_modulus` from Young's modulus and Poisson's ratio of the two bodies.
///
/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2, G* = 2 G1 G2/(G1 + G2) and 1/G^ = (2 - nu1)/G1 + (2 - nu2)/G2 with
/// G = E/(2 (1 + nu)). The other parameters stay as they are.
///
/// @param params  initialised parameters
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
    boundary::status(|| change(params, |params| params.set_materials([E1, nu1, E2, nu2])))
}

/// Chooses summits that yield, for metals: sets `contact_law` to `ASPERITY_CONTACT_ELASTIC_PLASTIC`, `hardness`, and
/// `work_of_adhesion` to 0, which this law needs. The other parameters stay as they are.
///
/// @param params    initialised parameters
/// @param hardness  indentation hardness of the softer body [stress] > 0, 1e-5 to 100 E*
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_elastic_plastic(
    params: *mut asperity_params,
    hardness: f64,
) -> asperity_status {
    boundary::status(|| {
        change(params, |params| {
            take! { made(|changed| changed.set_elastic_plastic(hardness))? => params;
                contact_law hardness work_of_adhesion
            }
        })
    })
}

/// Sets the roughness from the spectral moments of an isotropic surface, rough on however many scales.
///
/// m0, m2 and m4 are the variances of height z, slope dz/dx and curvature d2z/dx2 along a profile: m0 = Rq^2 = Sq^2,
/// m2 = Rdq^2 = Sdq^2/2. For two rough surfaces, add their moments. The area of contact, its patches and its stiffness depend
/// on m0 and m2, hardly on m4. The asperities set here follow boundary elements for bandwidths alpha = m0 m4/m2^2 from 1.8 to
/// 1000 (docs/validation.md); docs/roughness.md has the formulas. Sets `height_std`, `summit_radius`, `asperity_count`,
/// `radius_amplitude`, `radius_rate`, `summit_mean_height`, `nominal_area` and `rms_slope` = (2 m2)^(1/2), and `bandwidth` to 0.
///
/// @param params        initialised parameters
/// @param m0            variance of the heights [length^2] > 0
/// @param m2            variance of the slopes [-] > 0
/// @param m4            variance of the curvatures [1/length^2] > 0, alpha at least 1.5; 0: not known, alpha = 10
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
    boundary::status(|| {
        change(params, |params| params.set_summits(|made| made.set_spectral_moments(moments, nominal_area)))
    })
}

/// Sets the roughness to the summits of such a surface, all with one radius, as McCool (1987) does: for comparison with literature.
///
/// Right for narrow spectra alone: at a bandwidth of 27 the real area is 0.6 of that of boundary elements. Sets the parameters
/// that `asperity_params_set_spectral_moments` sets, with height_std = ((1 - 0.8968/alpha) m0)^(1/2), where 0.8968 is
/// 1 + 16/pi - 3^(3/2), summit_radius = 3 pi^(1/2)/(8 m4^(1/2)), asperity_count = m4/(6 pi 3^(1/2) m2) nominal_area,
/// radius_amplitude = 0, summit_mean_height = 4 (m0/(pi alpha))^(1/2) and bandwidth = alpha.
///
/// @param params                 initialised parameters
/// @param m0,m2,m4,nominal_area  as for `asperity_params_set_spectral_moments`; m4 must be known
/// @return as `asperity_params_set_spectral_moments`
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_mccool_summits(
    params: *mut asperity_params,
    m0: f64,
    m2: f64,
    m4: f64,
    nominal_area: f64,
) -> asperity_status {
    let moments = SpectralMoments { m0, m2, m4 };
    boundary::status(|| {
        change(params, |params| params.set_summits(|made| made.set_mccool_summits(moments, nominal_area)))
    })
}

/// Chooses Weibull heights of a given skew: sets `height_distribution` and `weibull_shape`.
///
/// @param params  initialised parameters
/// @param skew    [-], -1.1100 to 2, which are the skews of omega from 200 to 1; 0 gives omega = 3.602
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (skew outside the family),
///         `ASPERITY_OUT_OF_RANGE` (skew of a shape that is not evaluated)
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_skew(params: *mut asperity_params, skew: f64) -> asperity_status {
    boundary::status(|| change(params, |params| params.set_skew(skew)))
}
