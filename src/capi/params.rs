//! Parameters, as C sees them.

use super::boundary::{self, reference_mut, wrong_struct_size, Failure};
use super::status::asperity_status;
use crate::asperity::slip::SlipConstants;
use crate::error::Error;
use crate::params::{HeightFamily, Params};
use std::mem::size_of;

/// Gaussian heights, eq (17).
pub const ASPERITY_HEIGHTS_GAUSSIAN: i32 = 0;
/// Weibull heights, eqs (18)-(21): skewed, with `weibull_shape`.
pub const ASPERITY_HEIGHTS_WEIBULL: i32 = 1;

/// Two rough elastic surfaces, as the equivalent rough surface against a flat.
///
/// All quantities are in one consistent system of units of the caller's choice: SI, mm-N-MPa, or the paper's
/// b = G = 1. Loads, forces and areas are totals over `asperity_count` summits. Start from `asperity_params_init`,
/// which also sets `struct_size`; fields that later versions append then have their defaults.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_params {
    /// Size of this struct in bytes, as the caller was compiled; set by `asperity_params_init`.
    pub struct_size: u64,
    /// E* [stress], > 0: 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2.
    pub composite_modulus: f64,
    /// G* [stress], > 0: 2 G1 G2/(G1 + G2).
    pub effective_shear_modulus: f64,
    /// w [force/length], >= 0: work of adhesion; 0 is Hertzian contact.
    pub work_of_adhesion: f64,
    /// h [length], > 0: range of adhesion, within which surfaces attract with the stress w/h.
    pub adhesion_range: f64,
    /// b [length], > 0: Burgers vector, the length that the scale dependence of friction is measured in.
    pub burgers_vector: f64,
    /// sigma [length], > 0: standard deviation of summit heights.
    pub height_std: f64,
    /// R [length], > 0: mean radius of curvature of the summits.
    pub summit_radius: f64,
    /// N, > 0: number of summits, summit density times nominal area; need not be whole.
    pub asperity_count: f64,
    /// `ASPERITY_HEIGHTS_GAUSSIAN` (the default) or `ASPERITY_HEIGHTS_WEIBULL`.
    pub height_distribution: i32,
    /// 1: summits out of contact attract (the default, as in the paper); 0: they do not.
    pub attraction: i32,
    /// omega > 0: shape of the Weibull heights, 3.602 for no skew; read only for `ASPERITY_HEIGHTS_WEIBULL`.
    pub weibull_shape: f64,
    /// epsilon, -1 to 1: how much the radius grows with height, R (1 + epsilon tanh(rho z/sigma)), eq (3); 0 by default.
    pub radius_amplitude: f64,
    /// rho > 0: how fast it does; 0.5 by default.
    pub radius_rate: f64,
    /// a_1/b > 0: up to this contact radius the shear strength is `slip_stress_1`, eq (13); 28 by default.
    pub slip_radius_1: f64,
    /// tau_1/G* > 0; 1/43 by default.
    pub slip_stress_1: f64,
    /// a_2/b > a_1/b: from this contact radius on the shear strength is `slip_stress_2`; 8e4 by default.
    pub slip_radius_2: f64,
    /// tau_2/G* > 0; 1/1290 by default. tau_2 a_2^2 must not be below tau_1 a_1^2.
    pub slip_stress_2: f64,
    /// Cap on every friction coefficient returned, > 0: at and near zero load F/P grows without bound. 1000 by
    /// default, INFINITY allowed.
    pub max_friction_coefficient: f64,
}

/// Size of the first version, below which no caller can be.
const FIRST_SIZE: u64 = size_of::<asperity_params>() as u64;

impl asperity_params {
    /// The C form of parameters.
    pub(super) fn from_params(params: &Params) -> Self {
        let (height_distribution, weibull_shape) = match params.heights {
            HeightFamily::Gaussian => (ASPERITY_HEIGHTS_GAUSSIAN, DEFAULT_SHAPE),
            HeightFamily::Weibull { shape } => (ASPERITY_HEIGHTS_WEIBULL, shape),
            HeightFamily::Johnson { .. } | HeightFamily::Tabulated { .. } => {
                unreachable!("no C caller can make these yet")
            }
        };
        Self {
            struct_size: FIRST_SIZE,
            composite_modulus: params.composite_modulus,
            effective_shear_modulus: params.effective_shear_modulus,
            work_of_adhesion: params.work_of_adhesion,
            adhesion_range: params.adhesion_range,
            burgers_vector: params.burgers_vector,
            height_std: params.height_std,
            summit_radius: params.summit_radius,
            asperity_count: params.asperity_count,
            height_distribution,
            attraction: params.attraction.into(),
            weibull_shape,
            radius_amplitude: params.radius_amplitude,
            radius_rate: params.radius_rate,
            slip_radius_1: params.slip.radius_1,
            slip_stress_1: params.slip.stress_1,
            slip_radius_2: params.slip.radius_2,
            slip_stress_2: params.slip.stress_2,
            max_friction_coefficient: params.max_friction_coefficient,
        }
    }

    /// The library's form; only what is an enum in spirit is checked here, the numbers where they are used.
    pub(super) fn to_params(self) -> Result<Params, Failure> {
        self.check_size()?;
        let heights = match self.height_distribution {
            ASPERITY_HEIGHTS_GAUSSIAN => HeightFamily::Gaussian,
            ASPERITY_HEIGHTS_WEIBULL => HeightFamily::Weibull { shape: self.weibull_shape },
            other => {
                return Err(Failure::Error(Error::InvalidParameter {
                    name: "height_distribution",
                    value: other.into(),
                    allowed: "must be ASPERITY_HEIGHTS_GAUSSIAN (0) or ASPERITY_HEIGHTS_WEIBULL (1)",
                }))
            }
        };
        let attraction = match self.attraction {
            0 => false,
            1 => true,
            other => {
                return Err(Failure::Error(Error::InvalidParameter {
                    name: "attraction",
                    value: other.into(),
                    allowed: "must be 0 or 1",
                }))
            }
        };
        Ok(Params {
            composite_modulus: self.composite_modulus,
            effective_shear_modulus: self.effective_shear_modulus,
            work_of_adhesion: self.work_of_adhesion,
            adhesion_range: self.adhesion_range,
            burgers_vector: self.burgers_vector,
            height_std: self.height_std,
            summit_radius: self.summit_radius,
            asperity_count: self.asperity_count,
            heights,
            attraction,
            radius_amplitude: self.radius_amplitude,
            radius_rate: self.radius_rate,
            slip: SlipConstants {
                radius_1: self.slip_radius_1,
                stress_1: self.slip_stress_1,
                radius_2: self.slip_radius_2,
                stress_2: self.slip_stress_2,
            },
            max_friction_coefficient: self.max_friction_coefficient,
        })
    }

    fn check_size(&self) -> Result<(), Failure> {
        if self.struct_size == FIRST_SIZE {
            return Ok(());
        }
        Err(wrong_struct_size(
            self.struct_size,
            "must be sizeof(asperity_params) of the header of this library; call asperity_params_init first",
        ))
    }
}

/// The shape of Weibull heights without skew (Table 1 of the paper).
const DEFAULT_SHAPE: f64 = 3.602;

/// Lets a setter of the library's parameters change the caller's; what it does not change stays bit for bit.
unsafe fn change(
    params: *mut asperity_params,
    set: impl FnOnce(&mut Params) -> Result<(), Error>,
    take: impl FnOnce(&mut asperity_params, &asperity_params),
) -> Result<(), Failure> {
    let params = reference_mut(params, "params")?;
    params.check_size()?;
    let mut changed = Params::default();
    set(&mut changed)?;
    take(params, &asperity_params::from_params(&changed));
    Ok(())
}

/// Sets all parameters to the paper's default case and `struct_size` to the size of the struct.
///
/// alpha = 0.01, beta = 1000, gamma = 0.001, nu = 0.3 in units b = G = 1, N = 1; Gaussian heights, equal radii
/// (epsilon = 0, rho = 0.5), attraction on, Hurtado and Kim's slip constants.
///
/// @param params  receives the parameters; must not be NULL
/// @return `ASPERITY_OK` or `ASPERITY_NULL_POINTER`
///
/// Threads: any, on different structs.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_init(params: *mut asperity_params) -> asperity_status {
    boundary::status(|| {
        if params.is_null() {
            return Err(Failure::Null("params"));
        }
        // SAFETY: the caller gives memory for the struct, which need not be initialised.
        params.write(asperity_params::from_params(&Params::default()));
        Ok(())
    })
}

/// Sets material, adhesion and roughness from the paper's dimensionless groups, eqs (7) and (8).
///
/// In the paper's units b = 1, G = 1, N = 1: E* = 2/(1 - nu), G* = 2, sigma = alpha beta, R = beta/alpha,
/// w = gamma E*, h = 1/(b/h). Loads are then P/(N G b^2). The other parameters stay as they are.
///
/// @param params    initialised parameters; must not be NULL; untouched on failure
/// @param alpha     (sigma/R)^(1/2) > 0, surface roughness
/// @param beta      (R sigma)^(1/2)/b > 0, friction regime
/// @param gamma     w/(E* b) >= 0, surface energy
/// @param b_over_h  Burgers vector over range of adhesion > 0, typically 1
/// @param poisson   Poisson's ratio, above -1, at most 0.5
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
///
/// Threads: any, on different structs.
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
        change(
            params,
            |changed| changed.set_dimensionless(alpha, beta, gamma, b_over_h, poisson),
            |params, changed| {
                params.composite_modulus = changed.composite_modulus;
                params.effective_shear_modulus = changed.effective_shear_modulus;
                params.work_of_adhesion = changed.work_of_adhesion;
                params.adhesion_range = changed.adhesion_range;
                params.burgers_vector = changed.burgers_vector;
                params.height_std = changed.height_std;
                params.summit_radius = changed.summit_radius;
                params.asperity_count = changed.asperity_count;
            },
        )
    })
}

/// Sets E* and G* from Young's modulus and Poisson's ratio of the two bodies.
///
/// 1/E* = (1 - nu1^2)/E1 + (1 - nu2^2)/E2 and G* = 2 G1 G2/(G1 + G2) with G = E/(2 (1 + nu)).
///
/// @param params  initialised parameters; must not be NULL; untouched on failure
/// @param E1,E2   Young's moduli [stress] > 0; INFINITY is a rigid body, which at most one may be
/// @param nu1,nu2 Poisson's ratios, above -1, at most 0.5
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`
///
/// Threads: any, on different structs.
#[no_mangle]
#[allow(non_snake_case)]
pub unsafe extern "C" fn asperity_params_set_materials(
    params: *mut asperity_params,
    E1: f64,
    nu1: f64,
    E2: f64,
    nu2: f64,
) -> asperity_status {
    boundary::status(|| {
        change(
            params,
            |changed| changed.set_materials(E1, nu1, E2, nu2),
            |params, changed| {
                params.composite_modulus = changed.composite_modulus;
                params.effective_shear_modulus = changed.effective_shear_modulus;
            },
        )
    })
}

/// Chooses Weibull heights with this skew: sets `height_distribution` and `weibull_shape`.
///
/// @param params  initialised parameters; must not be NULL; untouched on failure
/// @param skew    above -1.13955, the limit of the family; 0 gives omega = 3.602
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (skew outside the family),
///         `ASPERITY_OUT_OF_RANGE` (skew of a shape that is not evaluated)
///
/// Threads: any, on different structs.
#[no_mangle]
pub unsafe extern "C" fn asperity_params_set_skew(params: *mut asperity_params, skew: f64) -> asperity_status {
    boundary::status(|| {
        change(
            params,
            |changed| changed.set_skew(skew),
            |params, changed| {
                params.height_distribution = changed.height_distribution;
                params.weibull_shape = changed.weibull_shape;
            },
        )
    })
}
