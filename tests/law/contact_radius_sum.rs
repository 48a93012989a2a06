//! The compiled sum of contact radii and its slope, against exact states and what they change by.

use super::compiled::{random_models, Failures};
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, model, of_the_benchmark};
use asperity::{ContactLawKind, Model, Params};

const SEED: u64 = 0x5eed_1a57;
const LOADS: usize = 60;
/// What the library promises; next to a kink see `src/law/mod.rs`.
const VALUE: f64 = 1e-8;
const SLOPE: f64 = 1e-6;
/// Loads nearer to pull-off than this part of it are left out: there differences say less than slopes.
const NEAR_PULL_OFF: f64 = 1e-3;
/// Steps in separation over which exact states are compared, in sigma, and in compression relative to a tenth of the separation.
const STEP: f64 = 5e-4;
/// The slopes of two steps that agree so well are those of a smooth curve. No more than this part of the others is next to a kink.
const SMOOTH: f64 = 1e-7;
const MOST_KINKED: f64 = 0.05;

fn models() -> Vec<Model> {
    let yielding = |hardness: f64| {
        let surface = dimensionless(0.02, 1000.0, 0.0, 1.0);
        let hardness = hardness * surface.composite_modulus;
        model(&Params { contact_law: ContactLawKind::ElasticPlastic, hardness, ..surface })
    };
    let mut models: Vec<Model> = of_the_benchmark().iter().map(model).collect();
    models.extend([0.001, 0.01, 0.1].map(yielding));
    models.extend(random_models(SEED, 48));
    models
}

/// The slope by load of the sum of radii at a separation, to the fourth order, from exact states at one and two steps from it, and
/// at two and four.
fn slopes(model: &Model, separation: f64) -> [f64; 2] {
    let step = STEP * model.params().height_std.max(0.1 * separation.abs());
    let at = |steps: f64| {
        let state = model.state_at_gap(separation + steps * step).expect("a state");
        (state.contact_radius_sum, state.load)
    };
    let rise = |steps: f64| {
        let [(more, heavy), (less, light)] = [at(-steps), at(steps)];
        (more - less, heavy - light)
    };
    let [one, two, four] = [1.0, 2.0, 4.0].map(rise);
    [(one, two), (two, four)].map(|(near, far)| (8.0 * near.0 - far.0) / (8.0 * near.1 - far.1))
}

#[test]
fn the_sum_of_contact_radii_and_its_slope_are_those_of_exact_states() {
    let mut random = SplitMix(SEED);
    let mut failures = Failures::default();
    let (mut compared, mut kinked, mut worst, mut worst_slope) = (0, 0, 0.0_f64, 0.0_f64);
    for model in models() {
        let summary = model.summary();
        let pull_off = summary.pull_off_load;
        let [lightest, heaviest] = [summary.min_table_load, summary.max_table_load].map(|load| load - pull_off);
        let lightest = lightest.max(-NEAR_PULL_OFF * pull_off);
        for i in 0..LOADS {
            let part = (i as f64 + random.between(0.0, 1.0)) / LOADS as f64;
            let load = pull_off + lightest * (heaviest / lightest).powf(part);
            let state = model.state_at_load(load).expect("a state");
            let (sum, slope) = model.contact_radius_sum_and_slope(load);
            let error = (sum / state.contact_radius_sum - 1.0).abs();
            failures.claim(error < VALUE, || format!("load {load:e}: off by {error:e}; {:?}", model.params()));
            worst = worst.max(error);
            compared += 1;
            let [exact, coarse] = slopes(&model, state.gap);
            if (coarse / exact - 1.0).abs() > SMOOTH {
                kinked += 1;
                continue;
            }
            let error = (slope / exact - 1.0).abs();
            failures.claim(error < SLOPE, || format!("load {load:e}: slope off by {error:e}; {:?}", model.params()));
            worst_slope = worst_slope.max(error);
        }
    }
    println!("{compared} loads, {kinked} next to a kink; largest error {worst:e}, of the slope {worst_slope:e}");
    assert!(f64::from(kinked) < MOST_KINKED * f64::from(compared), "{kinked} of {compared}");
    failures.report();
}
