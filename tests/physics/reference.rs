//! The model against reference values that were computed without it.
//!
//! `reference/cases.json`: every curve of the paper's figures 3 to 10, and limits; float64, spot-checked with 20 to 30
//! digits. `reference/wide.json`: surfaces from all over parameter space; 80-bit arithmetic in another formulation and
//! another quadrature (`reference/generate.py`), checked with 40 digits. `reference/heights.json`: the same summation of
//! other heights, written down in another form (`reference/heights.py`). Units: E* b^2 for load, G* b^2 for friction,
//! b^2 for area, sigma for separation, one summit.

use crate::common::reference_rows::{read, Case, CaseParams, Row};
use asperity::asperity::slip::SlipConstants;
use asperity::{HeightFamily, Model, Params, State};

fn heights(p: &CaseParams) -> HeightFamily {
    match (p.weibull_shape, p.skew, p.kurtosis, &p.table_height, &p.table_density) {
        (None, None, None, None, None) => HeightFamily::Gaussian,
        (Some(shape), None, None, None, None) => HeightFamily::Weibull { shape },
        (None, Some(skew), Some(kurtosis), None, None) => HeightFamily::Johnson { skew, kurtosis },
        (None, None, None, Some(height), Some(density)) => {
            HeightFamily::Tabulated { height: height.clone().into(), density: density.clone().into() }
        }
        _ => panic!("{p:?}: more than one family of heights"),
    }
}

fn model(p: &CaseParams) -> Model {
    let params = Params {
        composite_modulus: 1.0,
        effective_shear_modulus: 1.0,
        work_of_adhesion: p.gamma,
        adhesion_range: 1.0 / p.b_over_h,
        burgers_vector: 1.0,
        height_std: p.alpha * p.beta,
        summit_radius: p.beta / p.alpha,
        asperity_count: 1.0,
        heights: heights(p),
        attraction: p.noncontacting,
        radius_amplitude: p.epsilon,
        radius_rate: p.rho,
        slip: SlipConstants { radius_1: p.a1, stress_1: p.tau1, radius_2: p.a2, stress_2: p.tau2 },
        ..Params::paper()
    };
    Model::new(&params).unwrap_or_else(|error| panic!("{p:?}: {error}"))
}

/// Relative errors that rows may have.
struct Tolerance {
    value: f64,
    slope: f64,
}

/// How many rows were compared, and which differ by more than they may.
#[derive(Default)]
struct Comparison {
    rows: usize,
    worst_value: f64,
    worst_slope: f64,
    failures: Vec<String>,
}

impl Comparison {
    fn row(&mut self, case: &Case, row: &Row, state: &State, tolerance: &Tolerance) {
        let sigma = case.params.alpha * case.params.beta;
        // Load is the difference of what presses and what pulls: it is known relative to their sum.
        let load_scale = row.load_absolute.unwrap_or(row.load.abs());
        let values = [
            ("load", state.load, row.load, load_scale),
            ("friction", state.friction_force, row.friction, row.friction),
            ("contacting", state.contacting, row.contacting, row.contacting),
            ("area", state.real_area, row.area, row.area),
            ("load of contacts", state.load - state.attraction_load, row.load_contacting, load_scale),
            ("load of attraction", state.attraction_load, row.load_attracted, load_scale),
        ];
        let slopes = [
            ("dP/dd", state.dload_dgap * sigma, row.dload_dseparation, row.dload_dseparation.abs()),
            ("dF/dP", state.dforce_dload, row.dfriction_dload, row.dfriction_dload.abs()),
        ];
        self.rows += 1;
        for (name, found, expected, scale) in values {
            self.worst_value =
                self.worst_value.max(self.compare(case, row, name, (found, expected), scale, tolerance.value));
        }
        if let Some(attracted) = row.attracted {
            let scale = row.contacting.max(attracted);
            self.compare(case, row, "attracted", (state.attracted, attracted), scale, tolerance.value);
        }
        for (name, found, expected, scale) in slopes {
            self.worst_slope =
                self.worst_slope.max(self.compare(case, row, name, (found, expected), scale, tolerance.slope));
        }
    }

    fn compare(
        &mut self,
        case: &Case,
        row: &Row,
        name: &str,
        (found, expected): (f64, f64),
        scale: f64,
        tolerance: f64,
    ) -> f64 {
        let error = (found - expected).abs() / scale;
        if error.is_nan() || error > tolerance {
            self.failures.push(format!(
                "{}, d = {}: {name} {found:e}, not {expected:e}: error {error:.1e}",
                case.name, row.separation
            ));
        }
        error
    }

    fn finish(&self, expected_rows: usize) {
        println!("{} rows: worst value {:.1e}, worst slope {:.1e}", self.rows, self.worst_value, self.worst_slope);
        assert_eq!(self.rows, expected_rows);
        assert!(self.failures.is_empty(), "{} failures:\n{}", self.failures.len(), self.failures.join("\n"));
    }
}

fn state_of_row(model: &Model, case: &Case, row: &Row) -> State {
    let sigma = case.params.alpha * case.params.beta;
    model.state_at_gap(row.separation * sigma).expect("a state")
}

#[test]
fn figures_3_to_10_and_the_limits_are_reproduced() {
    let mut comparison = Comparison::default();
    for case in read::<Case>("cases.json") {
        let model = model(&case.params);
        for row in &case.rows {
            let state = state_of_row(&model, &case, row);
            comparison.row(&case, row, &state, &Tolerance { value: 1e-10, slope: 1e-6 });
        }
    }
    comparison.finish(226);
}

/// Where float64 cannot reach 1e-10: in the upper tail of a large Weibull shape an error of one unit in the separation is
/// thousands in the load.
fn is_ill_conditioned(case: &Case) -> bool {
    case.params.weibull_shape > Some(50.0)
}

#[test]
fn surfaces_from_all_over_parameter_space_are_reproduced() {
    let (mut ordinary, mut ill_conditioned) = (Comparison::default(), Comparison::default());
    for case in read::<Case>("wide.json") {
        let model = model(&case.params);
        for row in &case.rows {
            let state = state_of_row(&model, &case, row);
            if is_ill_conditioned(&case) {
                ill_conditioned.row(&case, row, &state, &Tolerance { value: 1e-10, slope: 1e-9 });
            } else {
                ordinary.row(&case, row, &state, &Tolerance { value: 1e-10, slope: 1e-10 });
            }
        }
    }
    ordinary.finish(355);
    ill_conditioned.finish(15);
}

#[test]
fn heights_of_johnsons_system_and_of_tables_are_reproduced() {
    let (mut ordinary, mut ill_conditioned) = (Comparison::default(), Comparison::default());
    for case in read::<Case>("heights.json") {
        let model = model(&case.params);
        for row in &case.rows {
            let state = state_of_row(&model, &case, row);
            // Within a thousandth of the last height of a lognormal curve, a unit in the separation is many in the load.
            if row.contacting < 1e-20 && row.contacting > 0.0 {
                ill_conditioned.row(&case, row, &state, &Tolerance { value: 1e-10, slope: 1e-9 });
            } else {
                ordinary.row(&case, row, &state, &Tolerance { value: 1e-10, slope: 1e-10 });
            }
        }
    }
    ordinary.finish(128);
    ill_conditioned.finish(2);
}

#[test]
fn a_load_on_the_branch_gives_the_friction_of_its_separation() {
    let mut rows = 0;
    for case in read::<Case>("cases.json") {
        let model = model(&case.params);
        for row in case.rows.iter().filter(|row| row.load > 0.0 && row.dload_dseparation < 0.0) {
            let exact = model.state_at_load(row.load).expect("a state");
            let compiled = model.friction_force_at_load(row.load);
            // Friction moves with load as dF/dP says: an error of the load counts.
            let of_load = 1.0 + (row.dfriction_dload * row.load / row.friction).abs();
            for (name, friction, known) in [("exact", exact.friction_force, 1e-10), ("compiled", compiled, 1e-6)] {
                let error = (friction / row.friction - 1.0).abs();
                assert!(error <= known * of_load, "{}, P = {}: {name} F off by {error:.1e}", case.name, row.load);
            }
            rows += 1;
        }
    }
    println!("{rows} rows");
    assert!(rows > 180, "only {rows} rows are on the branch");
}
