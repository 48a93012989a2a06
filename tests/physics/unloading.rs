//! A model after a largest load: limits in closed form, a sum over heights of the law as docs/model.md has it, work, and calls that
//! agree with each other.

use crate::common::surfaces::{crowded, dimensionless, johnson, model};
use asperity::{ContactLawKind, HeightFamily, Model, Params, MICROSLIP_LENGTH};
use std::f64::consts::PI;

/// E*/H times (sigma/R)^(1/2) is the index.
fn yielding(alpha: f64, beta: f64, index: f64) -> Params {
    let elastic = dimensionless(alpha, beta, 0.0, 1.0);
    let hardness = alpha * elastic.composite_modulus / index;
    Params { hardness, contact_law: ContactLawKind::ElasticPlastic, ..elastic }
}

fn surfaces() -> Vec<Params> {
    let varying = |params: Params| Params { radius_amplitude: -0.61, radius_rate: 0.9, ..params };
    vec![
        yielding(0.02, 2000.0, 1.5),
        crowded(yielding(0.02, 2000.0, 3.0), 0.1),
        crowded(varying(yielding(0.01, 1000.0, 1.5)), 0.05),
        crowded(varying(yielding(0.03, 3e4, 6.0)), 0.05),
        Params { heights: HeightFamily::Weibull { shape: 1.0 }, ..yielding(0.02, 2000.0, 3.0) },
        Params { heights: johnson(-1.0, 8.0), ..varying(yielding(0.01, 1000.0, 3.0)) },
        Params { heights: johnson(-1.0, 4.0), ..crowded(yielding(0.02, 2000.0, 3.0), 0.1) },
    ]
}

/// Parts of the load at which half of the summits touch.
fn largest_loads(first: &Model) -> [f64; 3] {
    let lone = model(&Params { nominal_area: 0.0, summit_mean_height: 0.0, ..first.params().clone() });
    let half = lone.state_at_gap(0.0).expect("a state").load;
    [1e-3, 0.05, 0.6].map(|part| part * half)
}

fn near(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found:e}, not {expected:e}");
}

#[test]
fn hard_summits_unload_as_they_were_loaded() {
    for params in surfaces() {
        let hard = model(&Params { hardness: 90.0 * params.composite_modulus, ..params });
        let largest = largest_loads(&hard)[1];
        let unloaded = hard.unloaded(largest).expect("a model");
        for part in [1e-9, 1e-4, 0.03, 0.5, 0.99, 1.01, 30.0] {
            let [one, other] = [&hard, &unloaded].map(|model| model.state_at_load(part * largest).expect("a state"));
            near("friction", other.friction_force, one.friction_force, 1e-9);
            near("area", other.real_area, one.real_area, 1e-9);
            near("stiffness", other.dload_dgap, one.dload_dgap, 1e-9);
            assert!((other.gap - one.gap).abs() < 1e-6 * hard.params().height_std, "{} {}", other.gap, one.gap);
        }
    }
}

#[test]
fn under_the_largest_load_and_above_it_nothing_has_changed_and_the_slope_there_is_the_unloading_stiffness() {
    for params in surfaces() {
        let first = model(&params);
        for largest in largest_loads(&first) {
            let unloaded = first.unloaded(largest).expect("a model");
            assert_eq!(unloaded.summary().largest_load, largest);
            for part in [1.0 - 1e-9, 1.0 + 1e-9, 1.3, 40.0] {
                let [one, other] =
                    [&first, &unloaded].map(|model| model.state_at_load(part * largest).expect("a state"));
                near("friction", other.friction_force, one.friction_force, 1e-9);
                near("radii", other.contact_radius_sum, one.contact_radius_sum, 1e-9);
                near("K_t", other.tangential_stiffness, one.tangential_stiffness, 1e-9);
                let tolerance = 1e-6 * params.height_std;
                assert!((other.gap - one.gap).abs() < tolerance, "{part}: {} {}", other.gap, one.gap);
                near("K_u", other.unloading_stiffness, one.unloading_stiffness, 1e-9);
                let stiffness = if part < 1.0 { one.unloading_stiffness } else { -one.dload_dgap };
                near("K", -other.dload_dgap, stiffness, 1e-6);
            }
        }
    }
}

/// What is compiled is exact, from the last contacts on, and so is microslip.
#[test]
fn every_call_answers_by_the_states_of_unloading() {
    for params in surfaces() {
        let first = model(&params);
        for largest in largest_loads(&first) {
            let unloaded = first.unloaded(largest).expect("a model");
            let mut nearer = f64::NEG_INFINITY;
            for i in 0..40 {
                let load = largest * 10_f64.powf(0.51 - 0.25 * f64::from(i));
                let state = unloaded.state_at_load(load).expect("a state");
                near("F", unloaded.friction_force_at_load(load), state.friction_force, 2e-6);
                near("K_t", unloaded.tangential_stiffness_at_load(load), state.tangential_stiffness, 2e-6);
                let (again, slope) = unloaded.load_and_slope_at_gap(state.gap);
                near("P", again, load, 3e-6);
                near("dP/du", slope, state.dload_dgap, 2e-4);
                near("again", unloaded.state_at_gap(state.gap).expect("a state").load, load, 3e-6);
                let (force, stiffness) = unloaded.tangential_at_load(load, 0.0).expect("a force");
                near("at once", stiffness, state.tangential_stiffness, 1e-9);
                assert!(force == 0.0 && state.gap > nearer, "{load:e}: {} after {nearer}", state.gap);
                let gross = 100.0 * state.friction_force / state.tangential_stiffness;
                near(
                    "all slips",
                    unloaded.tangential_at_load(load, gross).expect("a force").0,
                    state.friction_force,
                    1e-9,
                );
                nearer = state.gap;
                let [_, alone] = [&first, &unloaded].map(|model| model.friction_force_at_load(load));
                assert!(load > largest || alone >= first.friction_force_at_load(load) * (1.0 - 1e-6));
            }
        }
    }
}

/// By Simpson's rule over heights, in E* = 1 and b = 1.
#[test]
fn sums_are_those_of_hertz_contacts_of_the_radii_that_the_largest_load_left() {
    for params in surfaces().into_iter().filter(|params| params.heights == HeightFamily::Gaussian) {
        let params = Params { nominal_area: 0.0, summit_mean_height: 0.0, ..params };
        let first = model(&params);
        let [sigma, e_star, count] = [params.height_std, params.composite_modulus, params.asperity_count];
        let eta = params.hardness / e_star;
        for (d_m, lost) in [(1.5, 1e-3), (1.5, 0.05), (0.5, 0.02), (0.5, 0.3), (3.0, 0.01)] {
            let largest = first.state_at_gap(d_m * sigma).expect("a state").load;
            let unloaded = first.unloaded(largest).expect("a model");
            let state = unloaded.state_at_gap((d_m + lost) * sigma).expect("a state");
            let (mut load, mut radii, mut area) = (0.0, 0.0, 0.0);
            const STEPS: u32 = 100_000;
            let step = (9.0 - d_m) / f64::from(STEPS);
            for i in 0..STEPS {
                let z = d_m + (f64::from(i) + 0.5) * step;
                let radius = params.summit_radius * (1.0 + params.radius_amplitude * (params.radius_rate * z).tanh());
                let u = (z - d_m) * sigma;
                let first_yield = (0.75 * PI * 0.4 * eta).powi(2) * radius;
                let t = ((u / first_yield - 1.0) / 53.0).clamp(0.0, 1.0);
                let a = (radius * u * (1.0 + 3.0 * t * t - 2.0 * t * t * t)).sqrt();
                let pressure = match u / first_yield {
                    x if x <= 1.0 => 4.0 * a / (3.0 * PI * radius),
                    x if x < 54.0 => eta * (1.0 - 0.6 * (54.0 / x).ln() / 54_f64.ln()),
                    _ => eta,
                };
                let largest = PI * a * a * pressure;
                let x = (1.0 - lost * sigma / (0.75 * largest / a)).max(0.0);
                let weight = count * step * (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
                load += weight * e_star * largest * x.powf(1.5);
                radii += weight * a * x.sqrt();
                area += weight * PI * a * a * x;
            }
            near("load", state.load, load, 1e-5);
            near("radii", state.contact_radius_sum, radii, 1e-5);
            near("area", state.real_area, area, 1e-5);
            near("stiffness", -state.dload_dgap, 2.0 * e_star * radii, 1e-5);
        }
    }
}

/// Exponential heights that all flow: then sum a goes as P^(4/(3 pi)), and A as P^(2/3), where unloading begins.
#[test]
fn exponential_heights_have_the_exponents_of_unloading() {
    let soft = yielding(0.02, 2000.0, 2000.0);
    let first = model(&Params { heights: HeightFamily::Weibull { shape: 1.0 }, ..soft });
    for largest in largest_loads(&first) {
        let unloaded = first.unloaded(largest).expect("a model");
        let [less, more] = [1.0 - 2e-5, 1.0].map(|part| unloaded.state_at_load(part * largest).expect("a state"));
        let exponent = |of: fn(&asperity::State) -> f64| (of(&more) / of(&less)).ln() / (more.load / less.load).ln();
        let radii = exponent(|state| state.contact_radius_sum);
        let area = exponent(|state| state.real_area);
        assert!((radii - 4.0 / (3.0 * PI)).abs() < 2e-3, "{radii}");
        assert!((area - 2.0 / 3.0).abs() < 2e-3, "{area}");
    }
}

/// Of the work of first loading what is left of it comes back.
#[test]
fn a_cycle_of_load_costs_work() {
    for params in surfaces() {
        let first = model(&params);
        for largest in largest_loads(&first) {
            let unloaded = first.unloaded(largest).expect("a model");
            let work = |model: &Model| {
                let gap = |part: f64| model.state_at_load(part * largest).expect("a state").gap;
                let gaps: Vec<f64> = (0..=300).map(|i| gap((f64::from(i) / 300.0).powi(3).max(1e-9))).collect();
                gaps.windows(2)
                    .map(|pair| {
                        let load = |gap: f64| model.load_at_gap(gap);
                        (pair[0] - pair[1]) * 0.5 * (load(pair[0]) + load(pair[1]))
                    })
                    .sum::<f64>()
            };
            let returned = work(&unloaded) / work(&first);
            assert!(returned > 0.05 && returned < 1.0, "{largest:e}: {returned}");
        }
    }
}

#[test]
fn what_is_not_modelled_is_refused_and_said() {
    let first = model(&surfaces()[1]);
    let largest = largest_loads(&first)[1];
    let once = first.unloaded(largest).expect("a model");
    let table = first.summary().max_table_load;
    for (model, load, says) in [
        (&first, 0.0, "largest_load = 0: must be > 0"),
        (&first, -1.0, "largest_load = -1: below the pull-off load"),
        (&first, f64::NAN, "largest_load = NaN: must be finite"),
        (&first, f64::INFINITY, "largest_load = inf: must be finite"),
        (&first, table, "below max_table_load"),
        (&first, 1e300, "largest_load = 1e300: must be below"),
        (&once, 0.9 * largest, "must not be below the largest load that this model has borne"),
        (&model(&Params::paper()), 1.0, "unloading of surfaces with adhesion is not modelled"),
    ] {
        let error = model.unloaded(load).expect_err("refused").to_string();
        assert!(error.contains(says), "{error}");
    }
    // Twice, and from a larger load still, it is as at once.
    for (again, at_once) in [
        (once.unloaded(largest), first.unloaded(largest)),
        (once.unloaded(3.0 * largest), first.unloaded(3.0 * largest)),
    ] {
        let [again, at_once] = [again, at_once].map(|model| model.expect("a model"));
        for part in [0.01, 0.5, 2.0, 5.0] {
            near(
                "again",
                again.friction_force_at_load(part * largest),
                at_once.friction_force_at_load(part * largest),
                1e-6,
            );
            let [a, b] = [&again, &at_once].map(|model| model.state_at_load(part * largest).expect("a state").gap);
            assert!((a - b).abs() < 1e-6 * first.params().height_std, "{a}, {b}");
        }
    }
    // Elastic contacts unload as they were loaded.
    let elastic = model(&dimensionless(0.01, 1000.0, 0.0, 1.0));
    assert_eq!(elastic.unloaded(1.0).expect("a model").friction_at_load(0.5), elastic.friction_at_load(0.5));
}

/// A contact finds its own branch: after a largest load force, stiffness and loops are those of the model that is unloaded from it, to some
/// 2 % where first loading is up to 80 % off.
#[test]
fn microslip_under_a_falling_load_is_that_of_the_model_that_is_unloaded_from_the_largest() {
    for params in surfaces() {
        let first = model(&params);
        let light = largest_loads(&first)[0];
        let joint = first.unloaded(1e-3 * light).expect("a model");
        let tight = first.unloaded(light).expect("a model");
        for largest in largest_loads(&first).into_iter().flat_map(|load| [load, 1.7 * load, 0.013 * load]) {
            let unloaded = first.unloaded(largest).expect("a model");
            for (model, part) in
                [0.999, 0.7, 0.3, 0.05, 1e-3, 1e-6].into_iter().flat_map(|x| [(&joint, x), (&tight, x)])
            {
                let unloaded = if largest < light && std::ptr::eq(model, &tight) { &tight } else { &unloaded };
                let load = part * largest;
                let mut own = [0.0; MICROSLIP_LENGTH];
                let mut step = |load: f64, by: f64| model.microslip_step(load, [by, 0.0], &mut own).expect("a step");
                let most = step(largest, 0.0).stiffness[0];
                near("at first", step(largest * (1.0 - 1e-12), 0.0).stiffness[0], most, 1e-9);
                let stiffness = step(load, 0.0).stiffness[0];
                step(largest, 0.0);
                near("again", step(largest, 0.0).stiffness[0], most, 1e-12);
                step(load, 0.0);
                let length = unloaded.friction_force_at_load(load) / unloaded.tangential_stiffness_at_load(load);
                let partly = step(load, 0.5 * length).force[0];
                let mut other = [0.0; MICROSLIP_LENGTH];
                let expected = unloaded.microslip_step(load, [0.5 * length, 0.0], &mut other).expect("a step").force[0];
                let gross = step(load, 100.0 * length);
                let tolerance = 0.02 * (1.0 - part) + 1e-6;
                near("K_t", stiffness, unloaded.tangential_stiffness_at_load(load), tolerance);
                near("F", gross.force[0], unloaded.friction_force_at_load(load), tolerance);
                // Cells are wide where a falling load has cut them.
                near("T", partly, expected, tolerance + 0.06);
                // Where all slips the slope of T is that of F.
                let less = step(load * (1.0 - 1e-6), length).force[0];
                near("dT/dP", gross.dforce_dload[0], (gross.force[0] - less) / (1e-6 * load), 1e-3);
            }
        }
        for load in [light, 3.0 * light] {
            let mut state = [0.0; MICROSLIP_LENGTH];
            let step = joint.microslip_step(load, [0.0; 2], &mut state).expect("a step");
            near("K_t", step.stiffness[0], joint.tangential_stiffness_at_load(load), 1e-15);
        }
    }
}

/// A host that knows the largest load, or forgets it, says so in the last number of a state. At first loading nothing asks for it.
#[test]
fn the_last_number_of_a_state_is_the_largest_load() {
    let first = model(&surfaces()[1]);
    let [light, largest, _] = largest_loads(&first);
    let [joint, unloaded] = [1e-6 * light, largest].map(|load| first.unloaded(load).expect("a model"));
    let stiffness = |model: &Model, before: f64| {
        let mut state = [0.0; MICROSLIP_LENGTH];
        state[MICROSLIP_LENGTH - 1] = before;
        let step = model.microslip_step(light, [0.0; 2], &mut state).expect("a step");
        assert_eq!(state[MICROSLIP_LENGTH - 1], before.max(light));
        step.stiffness[0]
    };
    near("tightened", stiffness(&joint, largest), unloaded.tangential_stiffness_at_load(light), 0.01);
    near("loosened", stiffness(&joint, 0.0), joint.tangential_stiffness_at_load(light), 1e-15);
    near("first loading", stiffness(&first, largest), first.tangential_stiffness_at_load(light), 1e-15);
    for none in [-1.0, f64::NAN, f64::INFINITY, 1e300] {
        let mut state = [0.0; MICROSLIP_LENGTH];
        state[MICROSLIP_LENGTH - 1] = none;
        let told = joint.microslip_step(light, [0.0; 2], &mut state).expect_err("no state").to_string();
        assert!(told.contains(&format!("[{}]", MICROSLIP_LENGTH - 1)) && told.contains("must be"), "{told}");
    }
}
