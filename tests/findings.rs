//! What fuzzing and the sweep over the box of parameters found, each kept as a case.

mod processor_time;

use asperity::{HeightFamily, Model, Params};
use processor_time::processor_time;
use std::time::Duration;

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

/// Contact of the highest summits alone was summed beyond their height, or to the few digits that theta has of its
/// distance from pi/2.
#[test]
fn the_tip_of_the_highest_summit_carries_the_lightest_loads() {
    let (height, density) = ([-2.0, -1.0, 1.0, 2.0], [1e-3, 2.0, 2.0, 1e-3]);
    let params = Params {
        heights: HeightFamily::Tabulated { height: height.to_vec().into(), density: density.to_vec().into() },
        ..surface(0.0954, 20.76, 0.0, 5.75, 1.0)
    };
    let model = Model::new(&params).expect("a model");
    let unit = params.composite_modulus * params.burgers_vector.powi(2) * params.asperity_count;
    // Where the density is even, load goes with the overlap to the power of 5/2, area to that of 2.
    for power in (-250..=-45).step_by(5) {
        let friction = |power: i32| model.friction_force_at_load(10f64.powi(power) * unit);
        let ratio = friction(power) / friction(power - 5);
        assert!((ratio * 1e-4 - 1.0).abs() < 1e-12, "from 1e{power} of the units: {ratio:e}");
    }
}

/// The slope underflowed on the far side of the bracket, and the search ended where the load was still positive.
#[test]
fn a_pull_off_load_that_is_no_number_is_none() {
    let params = Params { attraction: true, ..surface(2.34e-2, 3.159e5, 1.4726e-4, 0.08055, 128.0) };
    let model = Model::new(&params).expect("a model");
    assert_eq!(model.summary().pull_off_load, 0.0);
    let state = model.state_at_separation(4.0 * params.height_std).expect("a state");
    let exact = model.state_at_load(state.load).expect("a state");
    assert!((exact.friction_force / state.friction_force - 1.0).abs() < 1e-11, "{exact:?}, {state:?}");
}

/// Where radii fall with height, sums go down from where contact ends; they did so in steps of one sigma over a thousand.
#[test]
fn heights_with_a_long_lower_tail_take_no_longer_than_others() {
    let params = Params {
        heights: HeightFamily::Johnson { skew: -0.33831787109375, kurtosis: 13.284959342760148 },
        attraction: true,
        radius_amplitude: -1.0,
        radius_rate: 16.294315938765745,
        ..surface(2.0541023068e-4, 14.6071685326, 0.115624353223, 8.45309277181, 1.0)
    };
    let start = processor_time();
    let model = Model::new(&params).expect("a model");
    let took = processor_time() - start;
    assert!(took < Duration::from_millis(500) || cfg!(debug_assertions), "{took:?}, {:?}", model.summary());
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
