//! Sensitivities at constant load against whole models of changed parameters, and against what units demand.

use crate::common::number_from_environment;
use crate::common::processor_time::processor_time;
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{dimensionless, johnson, model, table};
use asperity::{ContactLawKind, Error, HeightFamily, Model, Params, Sensitivities};
use std::time::Duration;

/// What is promised, relative to 1 or to a sensitivity that is larger.
const ACCURACY: f64 = 1e-7;
const SEED: u64 = 0x5e45_1715;
/// The longest processor time of a call, which is ten times what it takes: a few sums, not a new model.
const LONGEST: Duration = Duration::from_millis(20);

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

fn parameters() -> [Parameter; 18] {
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
        scaled!(hardness),
    ]
}

/// The steps of central differences, of which each halves the one before.
const STEPS: [f64; 3] = [0.02, 0.01, 0.005];

/// d ln F/d(step) at loads by whole models, with what each is known to: Richardson's extrapolation of central differences.
/// `None` where a model is refused.
fn by_whole_models(params: &Params, change: fn(&mut Params, f64), loads: &[f64]) -> Option<Vec<(f64, f64)>> {
    let log_forces = |step: f64| -> Option<Vec<f64>> {
        let mut params = params.clone();
        change(&mut params, step);
        let model = Model::new(&params).ok()?;
        // A load at which they part tells nothing.
        let log_force = |&load| model.state_at_load(load).map_or(f64::NAN, |state| state.friction_force.ln());
        Some(loads.iter().map(log_force).collect())
    };
    let mut slopes = Vec::new();
    for step in STEPS {
        let (below, above) = (log_forces(-step)?, log_forces(step)?);
        slopes.push(below.iter().zip(&above).map(|(below, above)| (above - below) / (2.0 * step)).collect::<Vec<_>>());
    }
    let extrapolated = (0..loads.len()).map(|i| {
        let [first, second] = [0, 1].map(|k| (4.0 * slopes[k + 1][i] - slopes[k][i]) / 3.0);
        let best = (16.0 * second - first) / 15.0;
        (best, (best - second).abs())
    });
    Some(extrapolated.collect())
}

/// The sensitivities at loads against differences of whole models; how many were compared. A parameter that has nothing to
/// change has none.
fn compare(params: &Params, loads: &[f64]) -> usize {
    let model = model(params);
    let all = loads
        .iter()
        .map(|&load| model.sensitivities_at_load(load).unwrap_or_else(|error| panic!("{params:?} at {load}: {error}")));
    let all: Vec<_> = all.collect();
    let mut compared = 0;
    for Parameter { name, of, change } in parameters() {
        let mut changed = params.clone();
        change(&mut changed, STEPS[0]);
        if changed == *params {
            assert!(all.iter().all(|all| of(all) == 0.0), "{name} of {params:?}");
            continue;
        }
        let Some(differences) = by_whole_models(params, change, loads) else { continue };
        for ((all, &load), (expected, known)) in all.iter().zip(loads).zip(differences) {
            let (found, scale) = (of(all), 1.0_f64.max(expected.abs()));
            // What a difference is not known to says nothing.
            if known < ACCURACY * scale {
                compared += 1;
                let off = (found - expected).abs();
                assert!(
                    off < ACCURACY * scale,
                    "{name} at {load:e} of {params:?}: {found}, not {expected} +- {known:e}"
                );
            }
        }
    }
    compared
}

/// Loads from near pull-off, or from light ones, to heavy ones.
fn loads_of(model: &Model) -> [f64; 4] {
    let asperity::Summary { pull_off_load, max_table_load, .. } = model.summary();
    let params = model.params();
    let unit =
        params.composite_modulus * params.height_std.powf(1.5) * params.summit_radius.sqrt() * params.asperity_count;
    let light = if pull_off_load < 0.0 { 0.5 * pull_off_load } else { 1e-12 * unit };
    [light, 1e-5 * unit, 0.03 * unit, (100.0 * unit).min(0.1 * max_table_load)]
}

#[test]
fn sensitivities_are_differences_of_whole_models() {
    let surface = |alpha: f64, gamma: f64, heights: HeightFamily, [amplitude, rate]: [f64; 2]| Params {
        heights,
        radius_amplitude: amplitude,
        radius_rate: rate,
        ..dimensionless(alpha, 1000.0, gamma, 0.8)
    };
    let weibull = |shape: f64| HeightFamily::Weibull { shape };
    let histogram = table(&[-3.0, -1.0, 0.0, 1.0, 1.5], &[0.0, 1.0, 0.1, 1.0, 0.0]);
    let folded = surface(0.01, 0.02, HeightFamily::Gaussian, [0.0, 0.5]);
    for params in [
        surface(0.01, 0.001, HeightFamily::Gaussian, [0.0, 0.5]),
        surface(0.02, 0.0, HeightFamily::Gaussian, [0.6, 0.8]),
        Params { attraction: false, ..surface(0.01, 0.001, HeightFamily::Gaussian, [-0.4, 0.5]) },
        folded.clone(),
        Params { heights: weibull(2.2), ..folded },
        surface(0.05, 0.002, weibull(1.3), [0.0, 3.0]),
        surface(0.01, 0.0, weibull(40.0), [0.3, 0.5]),
        surface(0.01, 0.001, johnson(0.5, 3.3), [0.5, 0.5]),
        surface(0.01, 0.0, johnson(-0.8, 3.2), [0.4, 0.5]),
        surface(0.03, 0.003, johnson(-0.5, 6.0), [0.0, 0.5]),
        surface(0.01, 0.001, histogram, [0.0, 0.5]),
        yielding(surface(0.03, 0.0, HeightFamily::Gaussian, [0.0, 0.5])),
        yielding(surface(0.01, 0.0, johnson(-0.5, 6.0), [0.6, 0.8])),
    ] {
        let compared = compare(&params, &loads_of(&model(&params)));
        assert!(compared > 40, "{compared} of {params:?}");
    }
}

/// With summits that yield, at a plasticity index of 50 alpha.
fn yielding(params: Params) -> Params {
    Params { contact_law: ContactLawKind::ElasticPlastic, hardness: 0.02 * params.composite_modulus, ..params }
}

/// Where all summits flow the real area is P/H: mu = tau/H with one shear strength.
#[test]
fn summits_that_flow_have_the_sensitivities_of_abbott_and_firestone() {
    let mut params = yielding(dimensionless(0.5, 1000.0, 0.0, 1.0));
    params.hardness *= 1e-3;
    (params.slip.radius_1, params.slip.radius_2) = (1e8, 1e9);
    let found = model(&params).sensitivities_at_load(3.0).expect("sensitivities");
    for (name, found, expected) in [
        ("E*", found.composite_modulus, 0.0),
        ("sigma", found.height_std, 0.0),
        ("R", found.summit_radius, 0.0),
        ("N", found.asperity_count, 0.0),
        ("b", found.burgers_vector, 0.0),
        ("H", found.hardness, -1.0),
        ("tau_1", found.slip_stress_1, 1.0),
    ] {
        assert!((found - expected).abs() < 1e-5, "{name}: {found}, not {expected}");
    }
}

/// Surfaces drawn at random, as many as ASPERITY_SENSITIVITY_SETS says.
#[test]
fn sensitivities_of_random_surfaces_are_differences_of_whole_models() {
    let mut random = SplitMix(SEED);
    let (mut compared, mut least) = (0, 0);
    for _ in 0..number_from_environment("ASPERITY_SENSITIVITY_SETS", 5) {
        let params = random_params(&mut random);
        let Ok(model) = Model::new(&params) else { continue };
        compared += compare(&params, &loads_of(&model));
        // Of 12 parameters or more at 4 loads most can be told.
        least += 36;
    }
    assert!(compared >= least, "{compared}, not {least}");
}

fn random_params(random: &mut SplitMix) -> Params {
    let (alpha, beta) = (random.log_between(1e-3, 0.1), random.log_between(50.0, 1e5));
    let gamma = if random.chance(0.2) { 0.0 } else { random.log_between(1e-5, 0.02) };
    let mut params = dimensionless(alpha, beta, gamma, random.between(0.3, 1.5));
    let skew = random.between(-1.5, 1.5);
    params.heights = match random.below(3) {
        0 => HeightFamily::Gaussian,
        1 => HeightFamily::Weibull { shape: random.log_between(1.1, 60.0) },
        _ => johnson(skew, 1.95 + 1.25 * skew * skew + random.log_between(0.05, 10.0)),
    };
    params.radius_amplitude = if random.chance(0.5) { random.between(-0.95, 0.95) } else { 0.0 };
    params.radius_rate = random.log_between(0.1, 5.0);
    params
}

/// At the ends of the domain, where there are surfaces on one side alone: by one-sided differences of whole models.
#[test]
fn sensitivities_at_the_ends_of_the_domain_are_the_limits_from_within() {
    // Of the fifth order.
    const ONE_SIDED: [f64; 6] = [-137.0 / 60.0, 5.0, -5.0, 10.0 / 3.0, -1.25, 0.2];
    let all = parameters();
    let parameter = |name: &str| all.iter().find(|parameter| parameter.name == name).expect("a parameter");
    let params = dimensionless(0.01, 1000.0, 0.001, 1.0);
    let radii = |radius_amplitude: f64| Params { radius_amplitude, ..params.clone() };
    let heights = |heights: HeightFamily| Params { heights, ..params.clone() };
    for (params, name, step) in [
        (heights(HeightFamily::Weibull { shape: 1.0 }), "weibull_shape", 0.004),
        (heights(HeightFamily::Weibull { shape: 200.0 }), "weibull_shape", -0.004),
        (heights(johnson(0.4, 1.87 + 1.25 * 0.16)), "kurtosis", 0.002),
        (radii(1.0), "radius_amplitude", -1e-4),
        (radii(-1.0), "radius_amplitude", 1e-4),
        (dimensionless(0.01, 1000.0, 1e-9, 1.0), "work_of_adhesion", 0.01),
    ] {
        let Parameter { of, change, .. } = parameter(name);
        for load in [3.0, 300.0] {
            let log_force = |i: usize| {
                let mut params = params.clone();
                change(&mut params, step * i as f64);
                model(&params).state_at_load(load).expect("a state").friction_force.ln()
            };
            let expected = (0..6).map(|i| ONE_SIDED[i] * log_force(i)).sum::<f64>() / step;
            let found = of(&model(&params).sensitivities_at_load(load).expect("sensitivities"));
            let off = (found - expected).abs() / 1.0_f64.max(expected.abs());
            assert!(off < ACCURACY, "{name} at {load}: {found}, not {expected}, of {params:?}");
        }
    }
}

/// Exponential heights without adhesion: mu = tau (pi R/sigma)^(1/2)/E* at all loads that leave the lowest summits free.
#[test]
fn exponential_heights_have_the_sensitivities_of_their_closed_form() {
    let mut params = Params { heights: HeightFamily::Weibull { shape: 1.0 }, ..dimensionless(0.01, 1000.0, 0.0, 1.0) };
    (params.slip.radius_1, params.slip.radius_2) = (1e6, 1e7);
    for load in [1e-6, 1.0, 1e3] {
        let found = model(&params).sensitivities_at_load(load).expect("sensitivities");
        for (name, found, expected) in [
            ("E*", found.composite_modulus, -1.0),
            ("G*", found.effective_shear_modulus, 1.0),
            ("w", found.work_of_adhesion, 0.0),
            ("h", found.adhesion_range, 0.0),
            ("b", found.burgers_vector, 0.0),
            ("sigma", found.height_std, -0.5),
            ("R", found.summit_radius, 0.5),
            ("N", found.asperity_count, 0.0),
            ("a_1", found.slip_radius_1, 0.0),
            ("tau_1", found.slip_stress_1, 1.0),
        ] {
            assert!((found - expected).abs() < 1e-11, "{name} at {load:e}: {found}, not {expected}");
        }
    }
}

/// Next to the pull-off load F is F_0 + A x^(1/2), x = load - pull-off: sensitivities grow as x^(-1/2) and are infinite there.
#[test]
fn sensitivities_grow_without_limit_towards_pull_off() {
    let model = model(&dimensionless(0.01, 1000.0, 0.02, 1.0));
    let pull_off = model.summary().pull_off_load;
    let at = |part: f64| model.sensitivities_at_load(pull_off * (1.0 - part)).expect("sensitivities").work_of_adhesion;
    for part in [1e-6, 1e-8, 1e-10] {
        let ratio = at(0.01 * part) / at(part);
        assert!((ratio - 10.0).abs() < 0.1, "{part:e}: {ratio}");
    }
    let refused = model.sensitivities_at_load(pull_off);
    assert!(matches!(refused, Err(Error::OutOfRange { name: "load", .. })), "{refused:?}");
}

#[test]
fn what_has_no_friction_has_no_sensitivities() {
    let [adhesive, hertz] = [0.02, 0.0].map(|gamma| model(&dimensionless(0.01, 1000.0, gamma, 1.0)));
    let pull_off = adhesive.summary().pull_off_load;
    for (refused, expected) in [
        (adhesive.sensitivities_at_load(f64::NAN), "load = NaN: must be finite"),
        (adhesive.sensitivities_at_load(1.01 * pull_off), "below the pull-off load"),
        (adhesive.sensitivities_at_load(1e300), "must be below 1e80"),
        (hertz.sensitivities_at_load(0.0), "must be > 0"),
        (hertz.sensitivities_at_load(-1.0), "below the pull-off load"),
    ] {
        let message = refused.expect_err("no sensitivities").to_string();
        assert!(message.contains(expected), "{message}");
    }
    assert!(adhesive.sensitivities_at_load(0.0).is_ok());
}

/// A rate that radii could not have is not read where they are equal; nor has then the amplitude one.
#[test]
fn equal_radii_have_no_rate() {
    let params = dimensionless(0.01, 1000.0, 0.001, 1.0);
    let at = |radius_rate: f64| {
        let params = Params { radius_rate, ..params.clone() };
        model(&params).sensitivities_at_load(1.0).expect("sensitivities")
    };
    let (ordinary, steep) = (at(0.5), at(1e300));
    assert!(ordinary.radius_amplitude > 0.1 && ordinary.radius_rate == 0.0);
    assert_eq!((steep.radius_amplitude, steep.radius_rate), (0.0, 0.0));
    assert!((steep.height_std - ordinary.height_std).abs() < 1e-11);
}

#[test]
fn sensitivities_take_milliseconds() {
    for (heights, amplitude) in [
        (HeightFamily::Gaussian, 0.0),
        (HeightFamily::Weibull { shape: 2.2 }, 0.5),
        (johnson(0.5, 3.3), -0.95),
        (johnson(-0.5, 6.0), 0.6),
        (table(&[-3.0, -1.0, 0.0, 1.0, 1.5], &[0.0, 1.0, 0.1, 1.0, 0.0]), 0.5),
    ] {
        for gamma in [0.0, 0.001, 0.02] {
            let params = Params {
                heights: heights.clone(),
                radius_amplitude: amplitude,
                ..dimensionless(0.01, 1000.0, gamma, 1.0)
            };
            let model = model(&params);
            for load in [1e-3, 1.0, 1e4] {
                // The least of a few: others use the processor's caches too.
                let time = |_| {
                    let start = processor_time();
                    model.sensitivities_at_load(load).expect("sensitivities");
                    processor_time() - start
                };
                let least = (0..5).map(time).min().unwrap_or_default();
                assert!(cfg!(debug_assertions) || least < LONGEST, "{least:?} at {load} of {params:?}");
            }
        }
    }
}
