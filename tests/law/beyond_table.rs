//! How far off the law is beyond its table, where it goes on as a power.
//!
//! `cargo test --release --test law -- --nocapture beyond` prints the table of docs/dev/numerics.md.

use crate::common::surfaces::{dimensionless, johnson, model, of_the_benchmark};
use asperity::{ContactLawKind, Model, Params, State};

fn surfaces() -> Vec<Params> {
    let elastic = dimensionless(0.01, 1000.0, 0.0, 1.0);
    let yielding = |hardness: f64, params: &Params| Params {
        hardness: hardness * params.composite_modulus,
        contact_law: ContactLawKind::ElasticPlastic,
        ..params.clone()
    };
    let mut surfaces = of_the_benchmark();
    surfaces.extend([
        yielding(0.01, &elastic),
        yielding(0.01, &dimensionless(0.1, 300.0, 0.0, 1.0)),
        yielding(0.1, &dimensionless(0.03, 1e4, 0.0, 1.0)),
        Params { heights: johnson(1.0, 5.0), ..elastic.clone() },
        Params { pressure_coefficient: 0.1, ..elastic.clone() },
        Params { radius_amplitude: 0.5, ..elastic },
        dimensionless(0.1, 300.0, 0.0, 1.0),
        dimensionless(0.01, 50.0, 0.0, 1.0),
        dimensionless(0.001, 1e5, 1e-4, 1.0),
        dimensionless(0.03, 1e4, 0.0, 1.0),
    ]);
    // Of some of these all contacts pass the second radius of the slip law just there.
    surfaces.extend((0..12).map(|i| dimensionless(0.01, 700.0 * 1.08_f64.powi(i), 0.0, 1.0)));
    surfaces
}

#[test]
fn beyond_the_table_the_law_is_off_by_no_more_than_the_contract_says() {
    type Off = fn(&Model, f64, &State) -> f64;
    let quantities: [(&str, Off, [f64; 4], [f64; 4]); 3] = [
        (
            "friction force",
            |model, load, exact| model.friction_force_at_load(load) / exact.friction_force,
            [11.0, 34.0, 54.0, 90.0],
            [0.1, 0.4, 0.8, 3.0],
        ),
        (
            "tangential stiffness",
            |model, load, exact| model.tangential_stiffness_at_load(load) / exact.tangential_stiffness,
            [4.5, 19.0, 33.0, 62.0],
            [0.13, 0.5, 1.1, 4.0],
        ),
        (
            "load at a separation",
            |model, load, exact| model.load_at_gap(exact.gap) / load,
            [21.0, 70.0, 330.0, 6700.0],
            [66.0, 100.0, 100.0, 100.0],
        ),
    ];
    let models = surfaces().iter().map(model).collect::<Vec<_>>();
    println!("| Load over that of the end | 10 | 100 | 1000 | 10⁶ | 1/10 | 1/100 | 1/1000 | 10⁻⁶ |");
    for (name, off, heavy, light) in quantities {
        print!("| {name} ");
        for (is_heavy, factor, known) in [10.0, 100.0, 1e3, 1e6]
            .into_iter()
            .zip(heavy)
            .map(|(factor, known)| (true, factor, known))
            .chain([0.1, 1e-2, 1e-3, 1e-6].into_iter().zip(light).map(|(factor, known)| (false, factor, known)))
        {
            let mut worst = 0.0_f64;
            for model in &models {
                let summary = model.summary();
                let end = if is_heavy { summary.max_table_load } else { summary.min_table_load };
                let load = summary.pull_off_load + factor * (end - summary.pull_off_load);
                let Ok(exact) = model.state_at_load(load) else { continue };
                let found = 100.0 * (off(model, load, &exact) - 1.0);
                assert!(found.abs() <= known, "{name}, {factor:e}: {found} %, {:?}", model.params());
                worst = if found.abs() > worst.abs() { found } else { worst };
            }
            print!("| {worst:.2} % ");
            // Otherwise more is claimed off than is.
            assert!(worst.abs() > 0.3 * known, "{name}, {factor:e}: {worst} %, not {known} %");
        }
        println!("|");
    }
}
