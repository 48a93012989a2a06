//! Few contacts under a constant load: what a state tells of the scatter and the bias of the friction force, against Monte
//! Carlo of contacts that are carried by whatever summits they have.
//!
//! tests/physics/few_contacts.csv has the numbers of Monte Carlo. `ASPERITY_WRITE_FEW_CONTACTS=1 cargo test --release --test physics
//! few_contacts` draws them anew, in minutes, and the same on every machine up to rounding.

use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, model, table};
use asperity::{ContactLawKind, HeightFamily, Model, Params};
use statrs::function::erf::erfc_inv;
use std::f64::consts::SQRT_2;
use std::fmt::Write;

/// Summits on each surface, and surfaces.
const SUMMITS: usize = 3000;
const SURFACES: usize = 600;
/// How many contacts the model has.
const CONTACTS: [f64; 9] = [0.3, 1.0, 2.0, 3.0, 5.0, 8.0, 15.0, 30.0, 60.0];
/// How far both may be from Monte Carlo, relative, and the bias besides.
const SCATTER_ACCURACY: f64 = 0.2;
const BIAS_ACCURACY: f64 = 0.2;
const FILE: &str = "tests/physics/few_contacts.csv";

/// Heights in sigma by the fraction of summits that are higher.
type Quantile = fn(f64) -> f64;

/// Surfaces with their heights.
fn surfaces() -> Vec<(&'static str, Params, Quantile)> {
    let elastic = dimensionless(0.02, 400.0, 0.0, 1.0);
    let yields = |hardness: f64| Params {
        hardness: hardness * elastic.composite_modulus,
        contact_law: ContactLawKind::ElasticPlastic,
        ..elastic.clone()
    };
    let with = |heights: HeightFamily, params: &Params| Params { heights, ..params.clone() };
    let uniform = || table(&[-1.0, 0.0, 1.0], &[1.0; 3]);
    let weibull = |shape: f64| HeightFamily::Weibull { shape };
    let level: Quantile = |taller| 3_f64.sqrt() * (1.0 - 2.0 * taller);
    let normal: Quantile = normal;
    vec![
        ("elastic", elastic.clone(), normal),
        ("elastic blunter high up", Params { radius_amplitude: 0.5, ..elastic.clone() }, normal),
        ("elastic sharper high up", Params { radius_amplitude: -0.5, ..elastic.clone() }, normal),
        ("elastic uniform", with(uniform(), &elastic), level),
        ("elastic exponential", with(weibull(1.0), &elastic), |taller| -taller.ln() - 1.0),
        ("elastic Weibull 8", with(weibull(8.0), &elastic), weibull_8),
        ("yielding", yields(0.01), normal),
        ("flowing", yields(0.001), normal),
        ("yielding uniform", with(uniform(), &yields(0.01)), level),
        ("adhesion", dimensionless(0.03, 300.0, 1e-3, 1.0), normal),
        ("more adhesion", dimensionless(0.03, 300.0, 2e-3, 1.0), normal),
        ("near JKR", dimensionless(0.01, 3000.0, 3e-3, 1.0), normal),
        ("near JKR more adhesion", dimensionless(0.01, 3000.0, 5e-3, 1.0), normal),
    ]
    .into_iter()
    .map(|(name, params, quantile)| (name, Params { asperity_count: SUMMITS as f64, ..params }, quantile))
    .collect()
}

fn normal(taller: f64) -> f64 {
    SQRT_2 * erfc_inv(2.0 * taller)
}

/// Of Weibull heights of shape 8, of which these are mean and standard deviation.
fn weibull_8(taller: f64) -> f64 {
    const MEAN: f64 = 0.941_742_699_849_701_5;
    const DEVIATION: f64 = 0.139_725_317_445_595_2;
    ((-taller.ln()).powf(0.125) - MEAN) / DEVIATION
}

/// The heights of the tallest summits of a surface, falling.
fn heights(random: &mut SplitMix, quantile: Quantile, most: usize) -> Vec<f64> {
    // Order statistics of uniform numbers from the top.
    let mut rest = 1.0;
    (0..most)
        .map(|i| {
            let left = (SUMMITS - i) as f64;
            rest *= (1.0 - random.between(0.0, 1.0)).powf(1.0 / left);
            quantile((1.0 - rest).max(1e-300))
        })
        .collect()
}

/// Load and friction of one surface at a separation in sigma; loads and forces of a summit are over `SUMMITS` of them.
fn sums(model: &Model, heights: &[f64], separation: f64, reach: f64) -> (f64, f64) {
    let sigma = model.params().height_std;
    let touching = heights.iter().take_while(|&&z| z > separation - reach);
    touching.fold((0.0, 0.0), |(load, friction), &z| {
        let summit = model.summit_at_overlap((z - separation) * sigma, z * sigma).expect("a summit");
        (load + summit.load, friction + summit.friction_force)
    })
}

/// Friction force of a surface under a load: of the first separation from heavy load on that carries no more.
fn friction(model: &Model, heights: &[f64], load: f64, from: f64, reach: f64) -> f64 {
    let mut pressed = from;
    while sums(model, heights, pressed, reach).0 < load {
        pressed -= 0.5;
        assert!(pressed > -30.0);
    }
    let mut loose = pressed;
    let step = 0.02;
    loop {
        loose += step;
        if sums(model, heights, loose, reach).0 < load {
            break;
        }
        if loose > heights[0] + reach {
            return 0.0;
        }
        pressed = loose;
    }
    for _ in 0..30 {
        let middle = 0.5 * (loose + pressed);
        if sums(model, heights, middle, reach).0 < load {
            loose = middle;
        } else {
            pressed = middle;
        }
    }
    sums(model, heights, pressed, reach).1
}

/// The separation in sigma at which the model has so many contacts, or next to no more.
fn separation_of(model: &Model, contacts: f64) -> f64 {
    let sigma = model.params().height_std;
    let (mut low, mut high) = (-3.0, 40.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if model.state_at_gap(middle * sigma).expect("a state").contacting > contacts {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The numbers of Monte Carlo, with those of the model that they belong to.
fn monte_carlo() -> String {
    let mut random = SplitMix(20_261_126);
    let mut lines = String::from("summits,contacts,hertz_load over load,scatter,bias,error of the bias\n");
    for (name, params, quantile) in surfaces() {
        let model = model(&params);
        let sigma = params.height_std;
        // How far below summits touch or pull.
        let mut reach = 1e-3;
        while model.summit_at_overlap(-reach * sigma, 0.0).expect("a summit").load != 0.0 {
            reach *= 1.3;
        }
        for contacts in CONTACTS {
            let d = separation_of(&model, contacts);
            let state = model.state_at_gap(d * sigma).expect("a state");
            assert!(state.load > 0.0, "{name}, {contacts}: {}", state.load);
            let most = ((state.contacting + state.attracted) * 8.0 + 60.0).min(SUMMITS as f64) as usize;
            let mut force = || {
                friction(&model, &heights(&mut random, quantile, most), state.load, d - 0.3, reach)
                    / state.friction_force
            };
            let forces: Vec<f64> = (0..SURFACES).map(|_| force()).collect();
            let count = SURFACES as f64;
            let mean = forces.iter().sum::<f64>() / count;
            let deviation = (forces.iter().map(|force| (force - mean).powi(2)).sum::<f64>() / (count - 1.0)).sqrt();
            let (scatter, bias, error) = (deviation / mean, mean - 1.0, deviation / count.sqrt());
            let share = state.hertz_load / state.load;
            println!("{name}, {contacts}");
            writeln!(lines, "{name},{contacts},{share:.2},{scatter:.4},{bias:.4},{error:.4}").expect("a line");
        }
    }
    lines
}

#[test]
fn scatter_and_bias_are_those_of_monte_carlo_or_are_not_told() {
    let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(FILE);
    if std::env::var_os("ASPERITY_WRITE_FEW_CONTACTS").is_some() {
        std::fs::write(&file, monte_carlo()).expect("it can be written");
    }
    let lines = std::fs::read_to_string(&file).expect("the numbers of Monte Carlo");
    let (mut failures, mut told) = (Vec::new(), 0);
    for (name, params, _) in surfaces() {
        let model = model(&params);
        for line in lines.lines().filter(|line| line.split(',').next() == Some(name)) {
            let numbers: Vec<f64> = line.split(',').skip(1).map(|field| field.parse().expect("a number")).collect();
            let [contacts, share, scatter, bias, error] = numbers[..] else { panic!("{line}") };
            let separation = separation_of(&model, contacts) * params.height_std;
            let state = model.state_at_gap(separation).expect("a state");
            assert!((state.hertz_load / state.load - share).abs() < 0.01 * share, "{line}: other surfaces");
            println!("{line}; told {:.4}, {:.4}", state.friction_scatter, state.friction_bias);
            let is_told = contacts >= if name.contains("uniform") { 3.0 } else { 1.0 } && share <= 3.0;
            if !is_told {
                assert!(state.friction_scatter.is_nan() && state.friction_bias.is_nan(), "{line}: {state:?}");
                continue;
            }
            told += 1;
            let scatter_off = (state.friction_scatter / scatter - 1.0).abs();
            let bias_off = ((state.friction_bias - bias).abs() - 3.0 * error).max(0.0) / bias.abs();
            if !(scatter_off <= SCATTER_ACCURACY && bias_off <= BIAS_ACCURACY) {
                failures.push(format!("{line}: told {}, {}", state.friction_scatter, state.friction_bias));
            }
        }
    }
    assert!(failures.is_empty() && told > 90, "{told} told; {failures:#?}");
}

/// Without adhesion what is proportional to the load neither scatters nor has a bias, and neither have the loads of one summit.
#[test]
fn friction_in_proportion_to_the_load_does_not_scatter() {
    let mut params = Params { pressure_coefficient: 0.3, asperity_count: 1e3, ..dimensionless(0.02, 400.0, 0.0, 1.0) };
    (params.slip.stress_1, params.slip.stress_2) = (0.0, 0.0);
    for load in [1e4, 1e6, 1e60] {
        let state = model(&params).state_at_load(load).expect("a state");
        assert!(state.friction_scatter < 1e-9 && state.friction_bias.abs() < 1e-9, "{state:?}");
    }
    let tip = Params { asperity_count: 1.0, ..dimensionless(0.02, 400.0, 1e-3, 1.0) };
    let state = model(&tip).state_at_load(1.0).expect("a state");
    assert_eq!((state.friction_scatter, state.friction_bias), (0.0, 0.0));
    // Nor has what does not touch.
    let apart = model(&params).state_at_gap(60.0 * params.height_std).expect("a state");
    assert_eq!((apart.friction_scatter, apart.friction_bias), (0.0, 0.0));
}
