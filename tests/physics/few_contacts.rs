//! Few contacts under a constant load: what a state tells of the scatter and the bias of the friction force, against Monte
//! Carlo of contacts that are carried by whatever summits they have.
//!
//! `cargo test --release --test physics -- --nocapture few_contacts` prints the table of docs/domain.md.

use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, model};
use asperity::{ContactLawKind, Model, Params};

/// Summits on each surface, all Gaussian, and surfaces.
const SUMMITS: f64 = 3000.0;
const SURFACES: usize = 500;
/// How far both may be from Monte Carlo, relative, and of the bias besides.
const SCATTER_ACCURACY: f64 = 0.35;
const BIAS_ACCURACY: f64 = 0.35;

fn laws() -> [(&'static str, Params); 4] {
    let elastic = dimensionless(0.02, 400.0, 0.0, 1.0);
    let yields = Params {
        hardness: 0.01 * elastic.composite_modulus,
        contact_law: ContactLawKind::ElasticPlastic,
        ..elastic.clone()
    };
    let varying = Params { radius_amplitude: 0.5, ..elastic.clone() };
    [
        ("elastic", elastic),
        ("elastic, radii vary", varying),
        ("yielding", yields),
        ("adhesive", dimensionless(0.03, 300.0, 1e-3, 1.0)),
    ]
    .map(|(name, params)| (name, Params { asperity_count: SUMMITS, ..params }))
}

/// Standard normal numbers, by Box and Muller.
fn heights(random: &mut SplitMix) -> Vec<f64> {
    let mut uniform = || -> f64 { (random.bits() >> 11) as f64 / 2f64.powi(53) };
    let mut heights: Vec<f64> = (0..SUMMITS as usize)
        .map(|_| (-2.0 * (1.0 - uniform()).ln()).sqrt() * (2.0 * std::f64::consts::PI * uniform()).cos())
        .collect();
    heights.sort_by(|a, b| b.total_cmp(a));
    heights
}

/// Load and friction of one surface at a separation in sigma; loads and forces of a summit are over `SUMMITS` of them.
fn sums(model: &Model, heights: &[f64], separation: f64) -> (f64, f64) {
    let sigma = model.params().height_std;
    let touching = heights.iter().take_while(|&&z| z > separation - 1.0);
    touching.fold((0.0, 0.0), |(load, friction), &z| {
        let summit = model.summit_at_overlap((z - separation) * sigma, z * sigma).expect("a summit");
        (load + summit.load, friction + summit.friction_force)
    })
}

/// Mean and standard deviation of the friction force of surfaces under a load.
fn monte_carlo(model: &Model, load: f64, random: &mut SplitMix) -> (f64, f64) {
    let forces: Vec<f64> = (0..SURFACES)
        .map(|_| {
            let heights = heights(random);
            let (mut loose, mut pressed) = (heights[0] + 1.0, -1.0);
            for _ in 0..45 {
                let middle = 0.5 * (loose + pressed);
                if sums(model, &heights, middle).0 < load {
                    loose = middle;
                } else {
                    pressed = middle;
                }
            }
            sums(model, &heights, pressed).1
        })
        .collect();
    let mean = forces.iter().sum::<f64>() / SURFACES as f64;
    let variance = forces.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / SURFACES as f64;
    (mean, variance.sqrt())
}

#[test]
fn scatter_and_bias_are_those_of_monte_carlo() {
    let mut random = SplitMix(20_261_124);
    println!("| summits | n | scatter | Monte Carlo | bias | Monte Carlo |\n|---|---|---|---|---|---|");
    let mut failures = Vec::new();
    for (name, params) in laws() {
        let model = model(&params);
        for separation in [3.2, 2.7, 2.25, 1.85] {
            let state = model.state_at_gap(separation * params.height_std).expect("a state");
            let (mean, deviation) = monte_carlo(&model, state.load, &mut random);
            let (scatter, bias) = (deviation / mean, mean / state.friction_force - 1.0);
            let n = state.contacting;
            let [told, told_bias] = [state.friction_scatter, state.friction_bias].map(|x| 100.0 * x);
            println!(
                "| {name} | {n:.1} | {told:.1} % | {:.1} % | {told_bias:.1} % | {:.1} % |",
                100.0 * scatter,
                100.0 * bias
            );
            // Of the mean of so many surfaces.
            let noise = 3.0 * scatter / (SURFACES as f64).sqrt();
            if (state.friction_scatter / scatter - 1.0).abs() > SCATTER_ACCURACY {
                failures.push(format!("{name}, n = {n:.1}: scatter {}, not {scatter}", state.friction_scatter));
            }
            if (state.friction_bias - bias).abs() > BIAS_ACCURACY * bias.abs() + noise {
                failures.push(format!("{name}, n = {n:.1}: bias {}, not {bias}", state.friction_bias));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// Without adhesion what is proportional to the load neither scatters nor has a bias, and neither have the loads of one summit.
#[test]
fn friction_in_proportion_to_the_load_does_not_scatter() {
    let mut params = Params { pressure_coefficient: 0.3, asperity_count: 1e3, ..dimensionless(0.02, 400.0, 0.0, 1.0) };
    (params.slip.stress_1, params.slip.stress_2) = (0.0, 0.0);
    for load in [1e-250, 1e-20, 1.0, 1e5, 1e60] {
        let state = model(&params).state_at_load(load).expect("a state");
        assert!(state.friction_scatter < 1e-9 && state.friction_bias < 1e-9, "{state:?}");
    }
    let tip = Params { asperity_count: 1.0, ..dimensionless(0.02, 400.0, 1e-3, 1.0) };
    let state = model(&tip).state_at_load(1.0).expect("a state");
    assert_eq!((state.friction_scatter, state.friction_bias), (0.0, 0.0));
}
