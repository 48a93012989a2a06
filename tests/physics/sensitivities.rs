//! Sensitivities at constant load against whole models of changed parameters, and against what units demand.

use crate::common::processor_time::processor_time;
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, johnson, model, table};
use asperity::{Error, HeightFamily, Model, Params, Sensitivities};
use std::time::Duration;

/// What is promised, relative to 1 or to a sensitivity that is larger.
const ACCURACY: f64 = 1e-7;
const SEED: u64 = 0x5e45_1715;

/// A parameter, its sensitivity, and what the parameter is after a change: of its logarithm, but for two.
struct Parameter {
    name: &'static str,
    of: fn(&Sensitivities) -> f64,
    change: fn(&mut Params, f64),
}

/// A parameter of which the logarithm is changed.
macro_rules! scaled {
    ($name:ident) => {
        scaled!($name, $name)
    };
    ($name:ident, $($field:ident).+) => {
        Parameter { name: stringify!($name), of: |all| all.$name, change: |params, step| params.$($field).+ *= step.exp() }
    };
}

fn parameters() -> [Parameter; 17] {
    [
        scaled!(composite_modulus),
        scaled!(effective_shear_modulus),
        scaled!(work_of_adhesion),
        scaled!(adhesion_range),
        scaled!(burgers_vector),
        scaled!(height_std),
        scaled!(summit_radius),
        scaled!(asperity_count),
        Parameter {
            name: "weibull_shape",
            of: |all| all.weibull_shape,
            change: |params, step| {
                if let HeightFamily::Weibull { shape } = &mut params.heights {
                    *shape *= step.exp();
                }
            },
        },
        Parameter {
            name: "radius_amplitude",
            of: |all| all.radius_amplitude,
            change: |params, step| params.radius_amplitude += step,
        },
        scaled!(radius_rate),
        scaled!(slip_radius_1, slip.radius_1),
        scaled!(slip_stress_1, slip.stress_1),
        scaled!(slip_radius_2, slip.radius_2),
        scaled!(slip_stress_2, slip.stress_2),
        Parameter {
            name: "skew",
            of: |all| all.skew,
            change: |params, step| {
                if let HeightFamily::Johnson { skew, .. } = &mut params.heights {
                    *skew += step;
                }
            },
        },
        Parameter {
            name: "kurtosis",
            of: |all| all.kurtosis,
            change: |params, step| {
                if let HeightFamily::Johnson { kurtosis, .. } = &mut params.heights {
                    *kurtosis *= step.exp();
                }
            },
        },
    ]
}

/// d ln F/d(step) at a load by whole models, and what it is known to: Ridders' extrapolation of central differences.
fn by_whole_models(params: &Params, change: fn(&mut Params, f64), load: f64) -> Option<(f64, f64)> {
    const SHRINK: f64 = 1.7;
    let log_force = |step: f64| {
        let mut params = params.clone();
        change(&mut params, step);
        let state = Model::new(&params).ok()?.state_at_load(load).ok()?;
        Some(state.friction_force.ln())
    };
    let mut best: Option<(f64, f64)> = None;
    let mut row: Vec<f64> = Vec::new();
    for k in 0..7 {
        let step = 0.03 / SHRINK.powi(k);
        let mut next = vec![(log_force(step)? - log_force(-step)?) / (2.0 * step)];
        for (order, before) in row.iter().enumerate() {
            let factor = SHRINK.powi(2 * (order as i32 + 1));
            let better = (factor * next[order] - before) / (factor - 1.0);
            let error = (better - next[order]).abs().max((better - before).abs());
            if best.is_none_or(|(_, least)| error < least) {
                best = Some((better, error));
            }
            next.push(better);
        }
        row = next;
    }
    best
}

/// The sensitivities at a load against differences of whole models; how many could be compared.
fn assert_are_differences(params: &Params, load: f64) -> usize {
    let found = model(params).sensitivities_at_load(load).unwrap_or_else(|error| panic!("{params:?} at {load}: {error}"));
    let mut compared = 0;
    for Parameter { name, of, change } in parameters() {
        let Some((expected, known)) = by_whole_models(params, change, load) else { continue };
        let found = of(&found);
        let scale = 1.0_f64.max(expected.abs());
        if std::env::var("SHOW").is_ok() {
            println!("{name} {found} {expected} {:e} {known:e}", found - expected);
        }
        // Differences that are not known well say nothing.
        if known < 0.3 * ACCURACY * scale {
            compared += 1;
            let off = (found - expected).abs();
            assert!(off < ACCURACY * scale, "{name} at {load} of {params:?}: {found}, not {expected} +- {known:e}");
        }
    }
    compared
}

#[test]
fn sensitivities_are_differences_of_whole_models() {
    let mut params = dimensionless(0.01, 1000.0, 0.001, 1.0);
    for load in [0.0, 1.0, 100.0] {
        println!("{}", assert_are_differences(&params, load));
    }
    params.radius_amplitude = 0.5;
    params.heights = johnson(0.5, 3.3);
    for load in [0.0, 1.0, 100.0] {
        println!("{}", assert_are_differences(&params, load));
    }
    params.heights = HeightFamily::Weibull { shape: 2.0};
    for load in [0.0, 1.0, 100.0] {
        println!("{}", assert_are_differences(&params, load));
    }
}
