//! Parameters of the surfaces that tests use, and their models.

use super::second_evaluation::heights::Heights;
use super::second_evaluation::Surface;
use asperity::{HeightFamily, Model, Params};

/// A surface with the groups of the model, and nu = 0.3.
pub fn dimensionless(alpha: f64, beta: f64, gamma: f64, b_over_h: f64) -> Params {
    let mut params = Params::paper();
    params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("groups within their range");
    params
}

/// Those of the benchmark (`benches/surfaces.hpp`).
pub fn of_the_benchmark() -> Vec<Params> {
    let default = Params::paper();
    let skewed = |skew: f64| {
        let mut params = Params::paper();
        params.set_skew(skew).expect("a skew");
        params
    };
    vec![
        default.clone(),
        dimensionless(0.01, 1000.0, 0.0, 1.0),
        dimensionless(0.006, 5e4, 0.01, 1.0),
        skewed(-1.0),
        skewed(1.0),
        Params { heights: HeightFamily::Weibull { shape: 40.74 }, ..default.clone() },
        Params { radius_amplitude: 0.5, ..default.clone() },
        Params { radius_amplitude: -0.95, ..default },
    ]
}

pub fn johnson(skew: f64, kurtosis: f64) -> HeightFamily {
    HeightFamily::Johnson { skew, kurtosis }
}

pub fn table(height: &[f64], density: &[f64]) -> HeightFamily {
    HeightFamily::Tabulated { height: height.into(), density: density.into() }
}

/// The same on a nominal area of which pi R sigma for each summit is this share, with summits that are higher than the mean plane.
pub fn crowded(params: Params, share: f64) -> Params {
    let touched = std::f64::consts::PI * params.summit_radius * params.height_std * params.asperity_count;
    Params { nominal_area: touched / share, summit_mean_height: 1.3 * params.height_std, ..params }
}

/// Bins of equal width with these densities, next to each other: between two the density changes within a part `step` of one.
pub fn bins(densities: &[f64], step: f64) -> HeightFamily {
    let ends = |bin: usize| [bin as f64 + step, (bin + 1) as f64];
    let height: Vec<f64> = (0..densities.len()).flat_map(ends).collect();
    let density: Vec<f64> = densities.iter().flat_map(|&density| [density; 2]).collect();
    table(&height, &density)
}

/// The model of parameters that have one.
#[track_caller]
pub fn model(params: &Params) -> Model {
    Model::new(params).unwrap_or_else(|error| panic!("{params:?}: {error}"))
}

/// The library's parameters of a surface, in units E* = G* = b = N = 1 and sigma in b.
pub fn params_of(surface: &Surface) -> Params {
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
            Heights::Scores(scores) => {
                HeightFamily::AtScores { height: scores.height.clone().into(), slope: scores.slope.clone().into() }
            }
        },
        attraction: surface.attraction,
        radius_amplitude: surface.epsilon,
        radius_rate: surface.rho,
        pressure_coefficient: surface.pressure,
        ..Params::paper()
    }
}
