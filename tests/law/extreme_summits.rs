//! Summits of hardly any spread and of a large one, stiff and soft, from Bradley's limit to JKR's: the compiled law against exact states
//! over twelve decades of load.

use asperity::{Error, Model, Params};

/// With this Maugis parameter, but for a factor; lengths are in summit radii.
fn summit(lambda: f64, alpha: f64, range_by_spread: f64, burgers_by_range: f64) -> Params {
    let paper = Params::paper();
    let height_std = alpha * alpha;
    let adhesion_range = range_by_spread * height_std;
    Params {
        summit_radius: 1.0,
        height_std,
        adhesion_range,
        work_of_adhesion: paper.composite_modulus * (lambda * adhesion_range).powf(1.5),
        burgers_vector: burgers_by_range * adhesion_range,
        asperity_count: 1.0,
        ..paper
    }
}

#[test]
fn the_law_of_extreme_summits_is_that_of_exact_states() {
    let mut made = 0;
    for exponent in -6..=6 {
        let lambda = 10_f64.powi(exponent);
        for alpha in [1e-5, 1e-3, 0.1, 1.0] {
            for range_by_spread in [1e-2, 1.0, 1e2, 1e4, 1e6] {
                for burgers_by_range in [1e-3, 1.0, 100.0] {
                    let params = summit(lambda, alpha, range_by_spread, burgers_by_range);
                    let model = match Model::new(&params) {
                        Ok(model) => model,
                        // Outside the domain, never without a reason.
                        Err(Error::OutOfRange { .. } | Error::InvalidParameter { .. }) => continue,
                        Err(error) => panic!("{error}: {params:?}"),
                    };
                    made += 1;
                    let summary = model.summary();
                    let half = model.state_at_gap(0.0).map_or(0.0, |state| state.load.abs());
                    let scale = half.max(-summary.pull_off_load);
                    for step in 0..=24 {
                        let load = summary.pull_off_load + scale * 10_f64.powf(f64::from(step) / 2.0 - 9.0);
                        if load < summary.min_table_load || load > summary.max_table_load {
                            continue;
                        }
                        let exact = model.state_at_load(load).expect("a state");
                        let errors = [
                            model.friction_force_at_load(load) / exact.friction_force - 1.0,
                            model.tangential_stiffness_at_load(load) / exact.tangential_stiffness - 1.0,
                            // A gap has few digits of what carries loads near zero.
                            1e-2 * (model.load_at_gap(exact.gap) - load) / load.abs().max(1e-3 * scale),
                        ];
                        for error in errors {
                            assert!(error.abs() < 1e-6, "{errors:?} at {load:e} of {params:?}");
                        }
                    }
                }
            }
        }
    }
    assert!(made > 200, "{made} surfaces");
}
