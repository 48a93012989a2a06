//! Single summits: added up over the heights they give the sums of the model, and their law is continuous where it must be.

use crate::common::assert_near;
use crate::common::surfaces::model;
use asperity::{Error, HeightFamily, Params};
use std::f64::consts::PI;

/// Of uniform heights, in standard deviations.
const HIGHEST: f64 = 1.732_050_807_568_877_2;

/// Without adhesion; with attraction out of contact; with a fold, where contact breaks at a > 0; with radii that vary; those with
/// as many summits at all heights.
fn surfaces() -> [Params; 5] {
    let paper = Params { asperity_count: 40.0, burgers_vector: 0.8, ..Params::paper() };
    let adhesion = |times: f64| Params { work_of_adhesion: times * paper.work_of_adhesion, ..paper.clone() };
    let varying = Params { radius_amplitude: -0.6, radius_rate: 0.8, ..adhesion(0.3) };
    let heights = HeightFamily::Tabulated { height: [0.0, 1.0, 2.0].into(), density: [1.0; 3].into() };
    [adhesion(0.0), adhesion(1.0), adhesion(10.0), varying.clone(), Params { heights, ..varying }]
}

/// The density of heights in standard deviations from their mean.
fn density(params: &Params, z: f64) -> f64 {
    let of_uniform = if z.abs() < HIGHEST { 0.5 / HIGHEST } else { 0.0 };
    if params.heights == HeightFamily::Gaussian {
        (-0.5 * z * z).exp() / (2.0 * PI).sqrt()
    } else {
        of_uniform
    }
}

#[test]
fn single_summits_add_up_to_the_sums_over_all() {
    const STEPS: usize = 200_000;
    for (i, params) in surfaces().iter().enumerate() {
        let model = model(params);
        for d in [-0.5, 1.0, if params.heights == HeightFamily::Gaussian { 2.5 } else { 0.0 }] {
            let step = 16.0 / STEPS as f64;
            let (mut sums, mut magnitude) = ([0.0; 4], 0.0);
            for k in 0..STEPS {
                let z = -8.0 + (k as f64 + 0.5) * step;
                let weight = step * density(params, z) * params.asperity_count;
                let one =
                    model.summit_at_overlap((z - d) * params.height_std, z * params.height_std).expect("a summit");
                let radius = one.contact_radius;
                let touches = f64::from(u8::from(radius > 0.0));
                let area = PI * radius * radius;
                magnitude += weight * one.load.abs();
                for (sum, value) in sums.iter_mut().zip([one.load, one.friction_force, area, touches]) {
                    *sum += weight * value;
                }
            }
            let state = model.state_at_gap(d * params.height_std).expect("a state");
            let expected = [state.load, state.friction_force, state.real_area, state.contacting];
            // Pushing and pulling summits cancel in the load.
            let scales = [magnitude, state.friction_force, state.real_area, state.contacting];
            for (k, name) in ["P", "F", "A", "n"].iter().enumerate() {
                // An edge falls anywhere within a step.
                let error = (sums[k] - expected[k]).abs() / scales[k];
                assert!(error < 3e-4, "{name} of surface {i} at {d}: {}, not {}", sums[k], expected[k]);
            }
        }
    }
}

/// Where lambda is below 0.655 attraction goes over into contact: eq (11) meets eq (5) where a = 0.
#[test]
fn attraction_goes_over_into_contact_without_a_jump() {
    let params = &surfaces()[1];
    let model = model(params);
    assert!(model.summary().lambda < 0.655);
    let at = |overlap: f64| model.summit_at_overlap(overlap, 0.0).expect("a summit");
    let (mut apart, mut touching) = (-params.adhesion_range, 0.0);
    while touching - apart > 1e-14 * params.adhesion_range {
        let middle = 0.5 * (apart + touching);
        *if at(middle).contact_radius > 0.0 { &mut touching } else { &mut apart } = middle;
    }
    assert_near(at(apart).load, at(touching).load, 1e-6, "load at break-away");
    assert!(at(apart).load < 0.0 && at(apart).friction_force == 0.0);
    assert_eq!(at(-1.001 * params.adhesion_range).load, 0.0);
    // Along the branch of unloading the load falls to its minimum.
    assert!(at(0.0).load < at(params.adhesion_range).load);
}

#[test]
fn what_is_no_overlap_or_height_is_refused() {
    let model = model(&surfaces()[1]);
    for (overlap, height, message) in [
        (f64::NAN, 0.0, "overlap = NaN: must be finite"),
        (0.0, f64::INFINITY, "height = inf: must be finite"),
        (1e60, 0.0, "overlap = 1e60: must be within 1e50 height_std of zero"),
    ] {
        let error: Error = model.summit_at_overlap(overlap, height).expect_err("refused");
        assert_eq!(error.to_string(), message);
    }
}

/// PDMS on glass. With one slip stress the Burgers vector is a unit of length and nothing else, and a summit is JKR's.
#[test]
fn an_elastomer_needs_no_burgers_vector() {
    let (radius, work) = (1e-3, 0.045);
    let with = |burgers_vector: f64, height_std: f64, asperity_count: f64| {
        let mut params = Params {
            work_of_adhesion: work,
            adhesion_range: 0.5e-9,
            burgers_vector,
            height_std,
            summit_radius: radius,
            asperity_count,
            ..Params::paper()
        };
        params.set_materials(2e6, 0.5, 72e9, 0.17).expect("materials");
        (params.slip.stress_1, params.slip.stress_2) = (1e-3, 1e-3);
        params
    };
    let loads = [0.0, 1e-6, 1e-4, 1e-2];
    for (height_std, asperity_count) in [(1e-10, 1.0), (1e-6, 100.0)] {
        let [short, long] = [1.8e-9, 49e-9].map(|length| model(&with(length, height_std, asperity_count)));
        for load in loads {
            let [one, other] = [&short, &long].map(|model| model.state_at_load(load).expect("a state"));
            assert_near(one.friction_force, other.friction_force, 1e-10, "friction force");
            assert_near(one.real_area, other.real_area, 1e-10, "real area");
        }
    }
    let params = with(3e-9, 1e-10, 1.0);
    let summit = model(&params);
    let pull = 3.0 * PI * work * radius;
    for load in loads {
        let hertzian = load + pull + (2.0 * pull * load + pull * pull).sqrt();
        let expected = (0.75 * radius / params.composite_modulus * hertzian).cbrt();
        assert_near(summit.state_at_load(load).expect("a state").mean_contact_radius, expected, 1e-6, "JKR's radius");
    }
}
