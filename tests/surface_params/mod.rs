//! A surface of the second evaluation as the library's parameters.

use crate::second_evaluation::heights::Heights;
use crate::second_evaluation::Surface;
use asperity::{HeightFamily, Params};

/// The library's parameters of a surface, in units E* = G* = b = N = 1 and sigma in b.
pub fn params(surface: &Surface) -> Params {
    Params {
        composite_modulus: 1.0,
        effective_shear_modulus: 1.0,
        work_of_adhesion: surface.gamma,
        adhesion_range: 1.0 / surface.b_over_h,
        burgers_vector: 1.0,
        height_std: surface.alpha * surface.beta,
        summit_radius: surface.beta / surface.alpha,
        asperity_count: 1.0,
        heights: match &surface.heights {
            Heights::Gaussian => HeightFamily::Gaussian,
            Heights::Weibull { shape, .. } => HeightFamily::Weibull { shape: *shape },
            Heights::Johnson(curve) => HeightFamily::Johnson { skew: curve.skew, kurtosis: curve.kurtosis },
            Heights::Table(table) => {
                HeightFamily::Tabulated { height: table.height.clone().into(), density: table.density.clone().into() }
            }
        },
        attraction: surface.attraction,
        radius_amplitude: surface.epsilon,
        radius_rate: surface.rho,
        ..Params::default()
    }
}
