//! Strengths that grow with pressure, F = pi a^2 tau(a) + kappa P_H of each contact: against reference values, against what is
//! exact without adhesion, and what one measured point makes of the stresses.
//!
//! `reference/film.json`: 8 surfaces, computed without the library. Units: E* b^2 for load, G* b^2 for friction, sigma for
//! separation, one summit.

use crate::common::surfaces::{dimensionless, johnson, model, table};
use crate::common::{assert_near, reference_rows};
use asperity::{CalibrationFailure, ContactLawKind, Error, HeightFamily, Params, SlipConstants, Specimens};
use serde::Deserialize;

#[derive(Deserialize)]
struct Case {
    params: CaseParams,
    rows: Vec<Row>,
}

#[derive(Debug, Deserialize)]
struct CaseParams {
    kappa: f64,
    e_over_g: f64,
    a1: f64,
    a2: f64,
    t1: f64,
    t2: f64,
    alpha: f64,
    beta: f64,
    gamma: f64,
    eps: f64,
    rho: f64,
    omega: Option<f64>,
}

#[derive(Deserialize)]
struct Row {
    separation: f64,
    load: f64,
    friction: f64,
    dfriction_dload: f64,
}

impl CaseParams {
    /// In units E* = b = N = 1.
    fn params(&self) -> Params {
        Params {
            composite_modulus: 1.0,
            effective_shear_modulus: 1.0 / self.e_over_g,
            work_of_adhesion: self.gamma,
            adhesion_range: 1.0,
            burgers_vector: 1.0,
            height_std: self.alpha * self.beta,
            summit_radius: self.beta / self.alpha,
            heights: self.omega.map_or(HeightFamily::Gaussian, |shape| HeightFamily::Weibull { shape }),
            radius_amplitude: self.eps,
            radius_rate: self.rho,
            slip: SlipConstants { radius_1: self.a1, stress_1: self.t1, radius_2: self.a2, stress_2: self.t2 },
            pressure_coefficient: self.kappa,
            ..Params::paper()
        }
    }
}

fn cases() -> Vec<Case> {
    reference_rows::read("film.json")
}

#[test]
fn reference_values_are_reproduced() {
    let (mut rows, mut on_branch) = (0, 0);
    for case in cases() {
        let params = case.params.params();
        let model = model(&params);
        for row in &case.rows {
            let context = format!("{:?} at {}", case.params, row.separation);
            let state = model.state_at_gap(row.separation * params.height_std).expect("a state");
            let friction = row.friction * params.effective_shear_modulus;
            assert_near(state.load, row.load, 1e-10, &context);
            assert_near(state.friction_force, friction, 1e-10, &context);
            // The rows' slopes are differences.
            let slope = row.dfriction_dload * params.effective_shear_modulus;
            assert_near(state.dforce_dload, slope, 1e-6, &context);
            if state.dload_dgap < 0.0 && state.load > 0.0 {
                let (compiled, compiled_slope) = model.friction_force_and_slope(row.load);
                assert_near(compiled, friction, 1e-6, &context);
                assert_near(compiled_slope, slope, 1e-4, &context);
                on_branch += 1;
            }
            rows += 1;
        }
    }
    assert_eq!(rows, 24);
    assert!(on_branch >= 20, "{on_branch}");
}

/// Surfaces without adhesion, elastic and yielding, of all families and with radii that vary.
fn without_adhesion() -> Vec<Params> {
    let heights = [
        HeightFamily::Gaussian,
        HeightFamily::Weibull { shape: 1.5 },
        johnson(0.5, 4.0),
        table(&[-1.0, 0.0, 0.5, 2.0], &[0.0, 1.0, 0.4, 0.0]),
    ];
    let elastic = heights.into_iter().flat_map(|heights| {
        [0.0, 0.6, -0.4].map(|radius_amplitude| Params {
            heights: heights.clone(),
            radius_amplitude,
            ..dimensionless(0.02, 400.0, 0.0, 1.0)
        })
    });
    let yields = |params: Params| Params {
        hardness: 0.01 * params.composite_modulus,
        contact_law: ContactLawKind::ElasticPlastic,
        ..params
    };
    elastic.flat_map(|params| [params.clone(), yields(params)]).collect()
}

/// F(P) = F0(P) + kappa P, at every load, exact and compiled.
#[test]
fn without_adhesion_the_pressure_coefficient_adds_to_the_coefficient_of_friction() {
    for params in without_adhesion() {
        let bare = model(&params);
        let film = model(&Params { pressure_coefficient: 0.15, ..params.clone() });
        for load in [1e-6, 1e-2, 10.0, 3e3, 1e6] {
            let context = format!("{params:?} at {load}");
            let (state, without) =
                (film.state_at_load(load).expect("a state"), bare.state_at_load(load).expect("a state"));
            assert_near(state.friction_force, without.friction_force + 0.15 * load, 1e-12, &context);
            assert_near(state.hertz_load, load, 1e-12, &context);
            assert_near(state.contact_radius_sum, state.mean_contact_radius * state.contacting, 1e-12, &context);
            let (force, slope) = film.friction_force_and_slope(load);
            let (force_0, slope_0) = bare.friction_force_and_slope(load);
            assert_near(force, force_0 + 0.15 * load, 4e-9, &context);
            assert_near(slope, slope_0 + 0.15, 5e-7, &context);
        }
    }
}

#[test]
fn without_slip_stresses_the_law_is_that_of_amontons() {
    let slip = SlipConstants { stress_1: 0.0, stress_2: 0.0, ..SlipConstants::default() };
    for params in without_adhesion() {
        let model = model(&Params { slip, pressure_coefficient: 0.3, ..params.clone() });
        for load in [1e-20, 1e-6, 1.0, 1e5] {
            assert_near(model.friction_at_load(load), 0.3, 1e-6, &format!("{params:?} at {load}"));
        }
    }
    // Derjaguin's term where surfaces adhere: the load that adhesion adds.
    let adhesive = Params { slip, pressure_coefficient: 0.3, ..dimensionless(0.01, 1000.0, 1e-3, 1.0) };
    let state = model(&adhesive).state_at_load(1.0).expect("a state");
    assert_near(state.friction_force, 0.3 * state.hertz_load, 1e-13, "Derjaguin");
    assert!(state.hertz_load > 1.01 * state.load, "{state:?}");
}

/// DMT's limit: adhesion presses a summit with 2 pi w R beyond its load (Derjaguin, Kolloid-Z. 69 (1934) 155).
#[test]
fn adhesion_of_small_hard_summits_adds_two_pi_w_r() {
    let mut params = dimensionless(1e-3, 10.0, 1e-4, 0.01);
    params.heights = HeightFamily::Gaussian;
    let added = 2.0 * std::f64::consts::PI * params.work_of_adhesion * params.summit_radius;
    let friction = |load: f64, pressure_coefficient: f64| {
        let params = Params { pressure_coefficient, asperity_count: 1.0, ..params.clone() };
        let alone = Specimens { count: 1, ..Specimens::default() };
        model(&params).specimens_at_loads(alone, &[load]).expect("a summit")[0].friction_force
    };
    for load in [0.1 * added, added] {
        let hertz_load = friction(load, 1.0) - friction(load, 0.0);
        assert_near((hertz_load - load) / added, 1.0, 0.02, "DMT");
    }
}

/// Displaced far, a contact resists with its friction force; little, with its stiffness; and strength that grows with pressure
/// changes what slips between.
#[test]
fn contacts_slip_at_their_whole_strength() {
    for (i, params) in without_adhesion().into_iter().enumerate() {
        let params = Params { pressure_coefficient: 0.4, ..params };
        let film = model(&params);
        let state = film.state_at_load(50.0).expect("a state");
        let length = state.friction_force / state.tangential_stiffness;
        let at = |part: f64| film.tangential_at_load(50.0, part * length).expect("a force");
        assert_near(at(100.0).0, state.friction_force, 1e-12, "gross slip");
        assert_near(at(1e-6).0, 1e-6 * state.friction_force, 1e-6, "sticking");
        // The force is the integral of the stiffness, by Simpson's rule.
        let steps = 2000;
        let step = 2.0 / f64::from(steps);
        let integral: f64 = (0..steps)
            .map(|k| {
                let stiffness = |shift: f64| at((f64::from(k) + shift) * step).1;
                (stiffness(0.0) + 4.0 * stiffness(0.5) + stiffness(1.0)) * step * length / 6.0
            })
            .sum();
        assert_near(integral, at(2.0).0, 1e-4, &format!("surface {i}"));
    }
}

#[test]
fn a_calibrated_law_meets_the_measured_point() {
    let surfaces = without_adhesion().into_iter().chain([dimensionless(0.01, 1000.0, 1e-3, 1.0)]);
    for (i, params) in surfaces.enumerate() {
        for (load, force, pressure_coefficient) in [(10.0, 4.0, 0.0), (10.0, 4.0, 0.1), (2e3, 50.0, 0.0)] {
            let mut params = Params { pressure_coefficient, ..params.clone() };
            let slip = params.slip;
            params.calibrate_force(load, force).unwrap_or_else(|error| panic!("surface {i}: {error}"));
            let context = format!("surface {i} at {load}");
            assert_near(model(&params).state_at_load(load).expect("a state").friction_force, force, 1e-12, &context);
            assert_near(model(&params).friction_force_at_load(load), force, 1e-6, &context);
            let mut by_coefficient = Params { slip, ..params.clone() };
            by_coefficient.calibrate(load, force / load).expect("the same point");
            assert_near(by_coefficient.slip.stress_1, params.slip.stress_1, 1e-14, &context);
            assert_near(params.slip.stress_1 / slip.stress_1, params.slip.stress_2 / slip.stress_2, 1e-14, &context);
            assert_eq!((params.slip.radius_1, params.slip.radius_2), (slip.radius_1, slip.radius_2));
        }
    }
}

#[test]
fn a_point_that_no_strength_gives_is_refused_with_the_numbers() {
    let params = Params { pressure_coefficient: 0.2, ..dimensionless(0.02, 400.0, 0.0, 1.0) };
    let refused = |params: &Params, load: f64, force: f64| {
        let mut changed = params.clone();
        let error = changed.calibrate_force(load, force).expect_err("refused");
        // Unset parameters are NaN, which equals nothing.
        assert_eq!(format!("{changed:?}"), format!("{params:?}"), "as before");
        error
    };
    let reason = |error: &Error| match error {
        Error::Uncalibrated { reason, .. } => *reason,
        other => panic!("{other:?}"),
    };
    let message = |load: f64, force: f64| refused(&params, load, force).to_string();
    for force in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert_eq!(reason(&refused(&params, 10.0, force)), CalibrationFailure::NotPositive);
    }
    assert_eq!(reason(&refused(&params, 10.0, 1.9)), CalibrationFailure::Pressure);
    let too_little = message(10.0, 1.9);
    let least = too_little.strip_prefix("friction_force = 1.9 at load = 10: must be above ").expect("the least force");
    let least: f64 = least.split(',').next().and_then(|number| number.parse().ok()).expect("a number");
    assert!((least - 2.0).abs() < 1e-12, "{too_little}");
    assert_eq!(reason(&refused(&params, 10.0, 1e6)), CalibrationFailure::Strength);
    assert!(message(10.0, 1e6).contains("must be at most "), "{}", message(10.0, 1e6));
    assert_eq!(
        reason(&refused(&Params { pressure_coefficient: 0.0, ..params.clone() }, 10.0, 1e-45)),
        CalibrationFailure::Weakness
    );
    let amontons = Params { slip: SlipConstants { stress_1: 0.0, stress_2: 0.0, ..params.slip }, ..params.clone() };
    assert_eq!(reason(&refused(&amontons, 10.0, 5.0)), CalibrationFailure::NoStress);
    assert!(matches!(refused(&params, f64::NAN, 1.0), Error::InvalidLoad { .. }));
    assert!(matches!(refused(&params, -1.0, 1.0), Error::Separated { .. }));
    assert_eq!(refused(&Params::default(), 1.0, 1.0), Error::Unset { name: "composite_modulus" });
    // The largest force that the message tells is met.
    let Error::Uncalibrated { number, .. } = refused(&params, 10.0, 1e6) else { panic!("checked above") };
    params.clone().calibrate_force(10.0, number * (1.0 - 1e-12)).expect("the largest force");
}
