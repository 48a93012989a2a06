//! The sums against integrals over heights by another rule, and surfaces for unit tests.

use super::*;
use crate::params::Params;

/// The population of a surface that is valid.
pub fn of(params: &Params) -> Population {
    let (groups, heights, radius) = params.surface().expect("a surface");
    Population::new(&groups, params.slip, heights, radius, params.attraction).expect("a population")
}

#[test]
fn debug_tmp() {
    use crate::params::HeightFamily;
    let mut params = Params::default();
    let (h, d) = (&[0.0, 0.5, 1.5, 2.0, 2.25, 3.0, 3.5, 4.0, 5.0], &[0.25, 1.0, 2.0, 0.5, 0.0, 0.0, 1.5, 1.0, 0.125]);
    for gamma in [0.0, 0.001, 0.003] {
        params.set_dimensionless(0.01, 1000.0, gamma, 1.0, 0.3).unwrap();
        params.heights = HeightFamily::Tabulated { height: h[..].into(), density: d[..].into() };
        for eps in [0.0, 0.6] {
            params.radius_amplitude = eps;
            let p = of(&params);
            for s in [-1e-3, -1e-5, -1.1288905046074461e-7, -1e-9, -1e-12, -3.3e-15, -1e-20, -1e-60] {
                let sums = p.at_separation(s);
                println!("{gamma} {eps} {s:e} {:e} {:e} {:e}", sums.load(), sums.contacting, sums.load_slope);
            }
        }
    }
    let heights = params.surface().unwrap().1;
    println!("0 {:?} {:?} {}", heights.support(), heights.breakpoints(), heights.origin());
}
