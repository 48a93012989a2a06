//! What fuzzing and the sweep over the box of parameters found, each kept as a case.

use asperity::{HeightFamily, Model, Params};

fn surface(alpha: f64, beta: f64, gamma: f64, b_over_h: f64, shape: f64) -> Params {
    let mut params = Params::default();
    params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("groups within their range");
    params.heights = HeightFamily::Weibull { shape };
    params.attraction = false;
    params
}

/// The search for the pull-off point stepped from a falling load to where all contacts are broken.
#[test]
fn the_pull_off_point_is_found_where_contact_reaches_far_beyond_the_heights() {
    let model = Model::new(&surface(6.915821e-4, 9.201681, 9.995e-4, 0.608147, 13.3389)).expect("a model");
    let summary = model.summary();
    let state = model.state_at_separation(0.0).expect("a state");
    assert!(state.load < 0.0 && summary.pull_off_load < state.load, "{summary:?}");
    assert!(summary.min_table_load >= summary.pull_off_load, "{summary:?}");
}

/// Next to pull-off the load was integrated across the separation at which the lowest summits break away.
#[test]
fn a_load_next_to_pull_off_is_that_of_its_separation() {
    let params = Params {
        radius_amplitude: 0.040039,
        radius_rate: 1.335772e-3,
        ..surface(2.635714938e-3, 1.138666346, 8.304721783e-5, 1.2326602839, 1.34723082)
    };
    let model = Model::new(&params).expect("a model");
    let pull_off = model.summary().pull_off_load;
    for x in [1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 9e-5] {
        let load = pull_off * (1.0 - x);
        let state = model.state_at_load(load).expect("a state");
        let there = model.state_at_separation(state.separation).expect("a state");
        assert!((there.load / load - 1.0).abs() < 1e-12, "x {x:e}: load {load:e}, at its separation {:e}", there.load);
    }
}

/// The search stepped over the first minimum to a later one, where radii fall steeply with height.
#[test]
fn the_branch_ends_at_the_first_minimum_of_the_load() {
    let params = Params {
        heights: HeightFamily::Gaussian,
        attraction: true,
        radius_amplitude: -0.60546875,
        radius_rate: 9.119288,
        ..surface(4.1046984e-4, 6.7468579e6, 0.24253, 0.224919, 1.0)
    };
    let model = Model::new(&params).expect("a model");
    let pull_off = model.summary().pull_off_load;
    let end = model.state_at_load(pull_off).expect("a state").separation;
    let loads: Vec<f64> = (0..=80)
        .map(|i| end - (8.0 - 0.1 * f64::from(i)) * params.height_std)
        .map(|separation| model.state_at_separation(separation).expect("a state").load)
        .collect();
    assert!(loads.windows(2).all(|pair| pair[1] < pair[0]), "pull-off {pull_off:e}, loads {loads:?}");
}
