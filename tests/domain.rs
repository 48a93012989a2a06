//! The whole admitted box of parameters: every surface is answered to 1e-8, against a second evaluation that shares no
//! code with the library (`second_evaluation/`), or refused with a reason; no call takes longer than a second.
//!
//! `cargo test` takes 200 surfaces of a Sobol sequence, `make domain` 20,000 and writes the map of `docs/reliability.md`:
//! ASPERITY_DOMAIN_SETS says how many, ASPERITY_DOMAIN_MAP where the table and the picture go.

mod domain_map;
mod processor_time;
mod second_evaluation;
mod sobol;

use asperity::{Error, HeightFamily, Model, Params, State};
use domain_map::{Answer, Map, Outcome};
use processor_time::processor_time;
use second_evaluation::{Heights, Sums, Surface};
use sobol::Sobol;
use std::time::{Duration, Instant};

/// What the library promises against the second evaluation.
const ACCURACY: f64 = 1e-8;
const LONGEST_CALL: Duration = Duration::from_secs(1);
const SETS: usize = 200;
/// Parameters that a point of the sequence chooses, and the load.
const DIMENSIONS: usize = 9;

/// A surface of the box; its last coordinate is left for the loads.
fn surface(x: &[f64]) -> Surface {
    let log = |x: f64, from: f64, to: f64| from * (to / from).powf(x);
    // A part of an interval of its own for what is a choice: none, or a value.
    let choose = |x: f64, none: f64| (x >= none).then(|| (x - none) / (1.0 - none));
    Surface {
        alpha: log(x[0], 1e-4, 1.0),
        beta: log(x[1], 1.0, 1e7),
        gamma: choose(x[2], 0.1).map_or(0.0, |x| log(x, 1e-7, 1.0)),
        b_over_h: log(x[3], 0.05, 20.0),
        heights: choose(x[4], 0.3).map_or(Heights::Gaussian, |x| Heights::weibull(log(x, 1.01, 200.0))),
        epsilon: choose(x[5], 0.5).map_or(0.0, |x| 2.0 * x - 1.0),
        rho: log(x[6], 1e-3, 100.0),
        attraction: x[7] >= 0.1,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    }
}

/// The library's parameters of a surface, in units E* = G* = b = N = 1 and sigma in b.
fn params(surface: &Surface) -> Params {
    Params {
        composite_modulus: 1.0,
        effective_shear_modulus: 1.0,
        work_of_adhesion: surface.gamma,
        adhesion_range: 1.0 / surface.b_over_h,
        burgers_vector: 1.0,
        height_std: surface.alpha * surface.beta,
        summit_radius: surface.beta / surface.alpha,
        asperity_count: 1.0,
        heights: match surface.heights {
            Heights::Gaussian => HeightFamily::Gaussian,
            Heights::Weibull { shape, .. } => HeightFamily::Weibull { shape },
        },
        attraction: surface.attraction,
        radius_amplitude: surface.epsilon,
        radius_rate: surface.rho,
        ..Params::default()
    }
}

fn timed<T>(answer: &mut Answer, call: impl FnOnce() -> T) -> T {
    let start = processor_time();
    let value = call();
    answer.slowest = answer.slowest.max(processor_time() - start);
    value
}

/// How far a state is from the second evaluation at its separation. A load is the difference of what presses and what
/// pulls: it is known relative to their sum.
fn errors(state: &State, exact: &Sums) -> [(&'static str, f64); 5] {
    let scale = exact.log_scale.exp();
    let load = scale * (exact.load_contacting + exact.load_attracted);
    let load_absolute = scale * exact.load_absolute;
    let friction = scale * exact.friction;
    let count = exact.contacting.max(exact.attracted);
    let relative = |a: f64, b: f64, scale: f64| if scale < 1e-290 { 0.0 } else { (a - b).abs() / scale };
    [
        ("load", relative(state.load, load, load_absolute)),
        ("friction", relative(state.friction_force, friction, friction)),
        ("contacting", relative(state.contacting, scale * exact.contacting, scale * count)),
        ("area", relative(state.real_area, scale * exact.area, scale * exact.area)),
        ("attraction", relative(state.attraction_load, scale * exact.load_attracted, load_absolute)),
    ]
}

/// Everything that is asked of one surface.
fn examine(surface: &Surface, part: f64) -> Outcome {
    let params = params(surface);
    let mut answer = Answer::default();
    let start = processor_time();
    let model = match Model::new(&params) {
        Ok(model) => model,
        Err(error) => {
            let name = match &error {
                Error::InvalidParameter { name, .. } | Error::OutOfRange { name, .. } => name,
                Error::NotConverged { what, .. } => what,
                other => panic!("{params:?}: {other}"),
            };
            return Outcome::Refused { reason: (*name).to_string(), after: processor_time() - start };
        }
    };
    answer.slowest = processor_time() - start;
    answer.create = answer.slowest;
    let summary = model.summary();
    let pull_off = summary.pull_off_load;
    let (nearest, farthest) = (summary.min_table_load - pull_off, summary.max_table_load - pull_off);
    // At pull-off, within the table, above it; the middle of heights.
    let mut loads = vec![
        pull_off + nearest * (farthest / nearest).powf(part),
        pull_off + nearest * (farthest / nearest).powf((part + 0.382) % 1.0),
        pull_off + 30.0 * farthest,
    ];
    if pull_off < 0.0 {
        loads.push(pull_off);
        loads.push(0.0);
    }
    for load in loads {
        let state = match timed(&mut answer, || model.state_at_load(load)) {
            Ok(state) => state,
            Err(error) => {
                answer.complaint = Some(format!("load {load:e}: {error}"));
                continue;
            }
        };
        let exact = surface.at_separation(state.separation / params.height_std);
        if !exact.converged {
            answer.unresolved += 1;
            continue;
        }
        for (name, error) in errors(&state, &exact) {
            answer.note(name, load, error);
        }
        if state.friction_force > 1e-290 {
            let table = timed(&mut answer, || model.friction_force_at_load(load));
            answer.note("table", load, (table / state.friction_force - 1.0).abs());
        }
    }
    if pull_off < 0.0 {
        answer.note("minimum", pull_off, rise_before_pull_off(&model, params.height_std));
    } else if let Some(load) = pulling(&model, params.height_std) {
        answer.complaint = Some(format!("no pull-off point, yet a load of {load:e}"));
    }
    Outcome::Answered(answer)
}

/// A load that pulls, at some separation.
fn pulling(model: &Model, sigma: f64) -> Option<f64> {
    (-40..200)
        .map(|i| 0.25 * f64::from(i) * sigma)
        .filter_map(|separation| Some(model.state_at_separation(separation).ok()?.load))
        .find(|load| *load < -1e-270)
}

/// Down from heavy load the load must fall until pull-off: how far it rises from one separation to the next, relative to
/// the pull-off load.
fn rise_before_pull_off(model: &Model, sigma: f64) -> f64 {
    let pull_off = model.summary().pull_off_load;
    let Ok(end) = model.state_at_load(pull_off) else { return f64::INFINITY };
    let from = end.separation - 8.0 * sigma;
    let mut last = f64::INFINITY;
    let mut rise = 0.0_f64;
    for i in 0..=40 {
        let d = from + (end.separation - from) * f64::from(i) / 40.0;
        let Ok(state) = model.state_at_separation(d) else { return f64::INFINITY };
        rise = rise.max((state.load - last) / -pull_off);
        last = state.load;
    }
    rise.max(0.0)
}

fn number(name: &str, otherwise: usize) -> usize {
    std::env::var(name).map_or(otherwise, |text| text.parse().unwrap_or_else(|_| panic!("{name} = {text}: a number")))
}

#[test]
fn every_surface_of_the_box_is_answered_to_1e_8_or_refused() {
    let sets = number("ASPERITY_DOMAIN_SETS", SETS);
    let mut map = Map::default();
    let mut sobol = Sobol::new(DIMENSIONS);
    let start = Instant::now();
    for _ in 0..sets {
        let point = sobol.next_point();
        let surface = surface(&point);
        let outcome = examine(&surface, point[8]);
        map.add(&surface, outcome);
    }
    let report = map.report(start.elapsed());
    println!("{report}");
    if let Some(folder) = std::env::var_os("ASPERITY_DOMAIN_MAP") {
        let folder = std::path::Path::new(&folder);
        std::fs::write(folder.join("domain.md"), &report).expect("the table is written");
        std::fs::write(folder.join("domain.svg"), map.picture()).expect("the picture is written");
    }
    let failures = map.failures(ACCURACY, LONGEST_CALL);
    assert!(failures.is_empty(), "{} failures:\n{}", failures.len(), failures[..failures.len().min(40)].join("\n"));
}

mod reference {
    //! The second evaluation against the 80-bit rows of `reference/`.
    use super::*;
    use serde::Deserialize;

    #[derive(Deserialize)]
    struct Case {
        name: String,
        params: Groups,
        rows: Vec<Row>,
    }

    #[derive(Deserialize)]
    struct Groups {
        alpha: f64,
        beta: f64,
        gamma: f64,
        b_over_h: f64,
        epsilon: f64,
        rho: f64,
        weibull_shape: Option<f64>,
        noncontacting: bool,
        a1: f64,
        tau1: f64,
        a2: f64,
        tau2: f64,
    }

    #[derive(Deserialize)]
    struct Row {
        separation: f64,
        load: f64,
        friction: f64,
        contacting: f64,
        area: f64,
        load_attracted: f64,
        load_absolute: Option<f64>,
    }

    #[test]
    fn the_second_evaluation_agrees_with_the_80_bit_rows() {
        let (mut rows, mut worst, mut offences) = (0, 0.0_f64, Vec::new());
        for file in ["cases.json", "wide.json"] {
            let path = format!("{}/tests/reference/{file}", env!("CARGO_MANIFEST_DIR"));
            let cases: Vec<Case> = serde_json::from_str(&std::fs::read_to_string(path).expect(file)).expect(file);
            for case in cases {
                let p = &case.params;
                let surface = Surface {
                    alpha: p.alpha,
                    beta: p.beta,
                    gamma: p.gamma,
                    b_over_h: p.b_over_h,
                    heights: p.weibull_shape.map_or(Heights::Gaussian, Heights::weibull),
                    epsilon: p.epsilon,
                    rho: p.rho,
                    attraction: p.noncontacting,
                    slip: [p.a1, p.tau1, p.a2, p.tau2],
                };
                for row in &case.rows {
                    let found = surface.at_separation(row.separation);
                    let scale = found.log_scale.exp();
                    let load_scale = row.load_absolute.unwrap_or(row.load.abs());
                    let errors = [
                        (scale * (found.load_contacting + found.load_attracted) - row.load).abs() / load_scale,
                        (scale * found.load_attracted - row.load_attracted).abs() / load_scale,
                        (scale * found.friction / row.friction - 1.0).abs(),
                        (scale * found.contacting / row.contacting - 1.0).abs(),
                        (scale * found.area / row.area - 1.0).abs(),
                    ];
                    let error = errors.into_iter().fold(0.0, f64::max);
                    rows += 1;
                    worst = worst.max(error);
                    if error > 1e-9 || !found.converged || error.is_nan() {
                        offences.push(format!("{}, d = {}: {errors:?} {}", case.name, row.separation, found.converged));
                    }
                }
            }
        }
        println!("{rows} rows, worst {worst:.1e}");
        assert_eq!(rows, 620);
        assert!(offences.is_empty(), "{} offences:\n{}", offences.len(), offences.join("\n"));
    }
}
