//! Load against gap, compiled, is that of exact states: values, slopes, joints between rows, the ends.

use super::compiled::{random_models, Failures};
use crate::common::neighbours::Neighbours;
use crate::common::splitmix::SplitMix;
use crate::common::surfaces::{bins, crowded, dimensionless, johnson, model, of_the_benchmark, table};
use asperity::{ContactLawKind, Error, HeightFamily, Model, Params};

const SEED: u64 = 0x6a90;
const SETS: usize = 48;
const SEPARATIONS: usize = 40;

/// The surfaces of benches/surfaces.hpp, also where their summits are neighbours, and one in other units.
fn surfaces() -> Vec<Params> {
    let mut polysilicon = Params {
        work_of_adhesion: 0.063,
        adhesion_range: 0.384e-9,
        burgers_vector: 0.384e-9,
        height_std: 5e-9,
        summit_radius: 1e-6,
        asperity_count: 1e5,
        ..Params::paper()
    };
    polysilicon.set_materials(160e9, 0.22, 160e9, 0.22).expect("materials");
    let height: Vec<f64> = (0..=64).map(|i| -3.5 + 7.0 * f64::from(i) / 64.0).collect();
    let density =
        |&z: &f64| if z.abs() == 3.5 { 0.0 } else { (-0.5 * z * z).exp() * (1.0 + 0.3 * (7.0 * z * z * z).sin()) };
    let density: Vec<f64> = height.iter().map(density).collect();
    let others = [
        Params {
            heights: HeightFamily::Tabulated { height: height.into(), density: density.into() },
            ..Params::paper()
        },
        polysilicon,
    ];
    let crowd = of_the_benchmark().into_iter().zip([0.5, 0.1, 0.01, 0.1, 0.5, 2.0, 0.1, 0.5]);
    of_the_benchmark().into_iter().chain(others).chain(crowd.map(|(params, share)| crowded(params, share))).collect()
}

/// The separations between which it is compared: of 1e3 times the load at which half of the summits touch, or 1e4 times that of pull-off,
/// and of pull-off or a load 1e-14 times as large.
fn range(model: &Model) -> (f64, f64) {
    let separation = |load: f64| model.state_at_load(load).expect("a state").gap;
    let pull_off = model.summary().pull_off_load;
    let lone = Params { nominal_area: 0.0, summit_mean_height: 0.0, ..model.params().clone() };
    let half = Model::new(&lone).and_then(|model| model.state_at_gap(0.0)).map_or(0.0, |state| state.load);
    let lightest = 1e-14 * half.max(-pull_off);
    (
        separation((1e3 * half).max(-1e4 * pull_off)),
        separation(if pull_off < -1e-29 * half { pull_off } else { lightest }),
    )
}

fn models() -> Vec<Model> {
    surfaces().iter().map(model).chain(random_models(SEED, SETS)).collect()
}

/// Relative to the load or, where it is smaller, the pull-off load; to the slope or the pull-off load over the distance to pull-off.
#[test]
fn load_and_slope_are_those_of_the_exact_state() {
    let mut random = SplitMix(SEED ^ 1);
    let mut failures = Failures::default();
    let (mut worst, mut worst_slope) = (0.0_f64, 0.0_f64);
    for model in models() {
        let sigma = model.params().height_std;
        let pull_off = model.summary().pull_off_load;
        let (near, far) = range(&model);
        for i in 0..SEPARATIONS {
            let part = (i as f64 + random.between(0.0, 1.0)) / SEPARATIONS as f64;
            // Among the heights, and over all decades of the distance from the end.
            let distance = if i % 2 == 0 { (far - near) * 1e-9_f64.powf(part) } else { 12.0 * sigma * part };
            let separation = (far - distance).max(near);
            let exact = model.state_at_gap(separation).expect("a state");
            let (load, slope) = model.load_and_slope_at_gap(separation);
            let error = (load - exact.load).abs() / exact.load.abs().max(-pull_off);
            let least = -pull_off / (distance + 0.1 * sigma);
            let slope_error = (slope - exact.dload_dgap).abs() / exact.dload_dgap.abs().max(least);
            failures.claim(error <= 1e-6 && slope_error <= 1e-4, || {
                let exact = (exact.load, exact.dload_dgap);
                let found = (load, slope);
                format!("{separation:e}: {found:?}, not {exact:?}: {error:e}, {slope_error:e}; {:?}", model.params())
            });
            (worst, worst_slope) = (worst.max(error), worst_slope.max(slope_error));
        }
    }
    println!("largest error of the load {worst:.1e}, of its slope {worst_slope:.1e}");
    failures.report();
    // Otherwise nothing was compared.
    assert!(worst > 1e-16 && worst_slope > 1e-16);
}

/// A load found at a separation has that separation, and its friction is that of the state there.
#[test]
fn separation_load_and_friction_agree() {
    for params in surfaces() {
        let model = model(&params);
        let (near, far) = range(&model);
        for i in 1..20 {
            let separation = far - (far - near) * 1e-4_f64.powf(f64::from(i) / 20.0);
            let load = model.load_at_gap(separation);
            let state = model.state_at_load(load).expect("a state");
            assert!((state.gap - separation).abs() < 1e-6 * (params.height_std + separation.abs()));
            let force = model.friction_force_at_load(load);
            let expected = model.state_at_gap(separation).expect("a state").friction_force;
            assert!((force / expected - 1.0).abs() < 1e-6, "{separation:e}: {force:e}, not {expected:e}");
        }
    }
}

#[test]
fn load_falls_with_separation_without_jumps() {
    for model in models() {
        let (near, far) = range(&model);
        let pull_off = model.summary().pull_off_load;
        let (mut before, mut last) = ((f64::INFINITY, 0.0), f64::NAN);
        for i in 0..6000 {
            // Neighbours now and then, with ends of rows among them.
            let separation =
                if i % 2 == 0 { far - (far - near) * 1e-7_f64.powf(f64::from(i) / 6e3) } else { last.above() };
            let (load, slope) = model.load_and_slope_at_gap(separation);
            let size = load.abs().max(-pull_off);
            assert!(load <= before.0 + 1e-10 * size, "{separation:e}: {load:e} after {before:?}; {:?}", model.params());
            assert!(
                slope <= 1e-8 * size / model.params().height_std,
                "{separation:e}: {slope:e}; {:?}",
                model.params()
            );
            if i % 2 == 1 {
                let jump = (load - before.0).abs() - 4.0 * slope.abs() * (separation - last);
                assert!(jump <= 2e-10 * size, "{separation:e}: {load:e} next to {before:?}; {:?}", model.params());
            }
            (before, last) = ((load, slope), separation);
        }
    }
}

#[test]
fn surfaces_part_at_the_separation_of_pull_off() {
    for gamma in [5e-4, 1e-3, 0.02] {
        let model = model(&dimensionless(0.01, 1000.0, gamma, 1.0));
        let pull_off = model.summary().pull_off_load;
        let end = model.state_at_load(pull_off).expect("a state").gap;
        for separation in [end, end.above(), end + 1e-3, 2.0 * end, 1e9, f64::MAX] {
            assert_eq!(model.load_and_slope_at_gap(separation), (0.0, 0.0), "{separation:e}");
            assert!(matches!(model.validate_gap(separation), Err(Error::Open { .. })));
        }
        let (load, slope) = model.load_and_slope_at_gap(end - 1e-12 * end);
        assert!((load / pull_off - 1.0).abs() < 1e-10, "{load:e}, not {pull_off:e}");
        assert!(slope <= 0.0 && slope > 1e-6 * pull_off / end, "{slope:e}");
        assert_eq!(model.validate_gap(end - 1e-12 * end), Ok(()));
    }
}

#[test]
fn without_adhesion_the_load_goes_to_zero_smoothly() {
    for params in [
        dimensionless(0.01, 1000.0, 0.0, 1.0),
        Params { heights: HeightFamily::Weibull { shape: 1.6 }, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
        Params { heights: HeightFamily::Weibull { shape: 30.0 }, ..dimensionless(0.01, 1000.0, 0.0, 1.0) },
    ] {
        let model = model(&params);
        let sigma = params.height_std;
        let half = model.load_at_gap(0.0);
        let mut before = f64::INFINITY;
        let mut open = 0;
        for i in 0..100_000 {
            let separation = 80.0 * sigma * f64::from(i) / 1e5;
            let (load, slope) = model.load_and_slope_at_gap(separation);
            assert!(load >= 0.0 && load <= before && slope <= 0.0, "{separation}: {load:e}, {slope:e}");
            // No jump to zero.
            assert!(load > 0.0 || before < 1e-22 * half, "{separation}: {before:e} before");
            open += i32::from(load == 0.0);
            before = load;
        }
        assert!(open > 1000 && open < 99_000, "{open}");
    }
}

#[test]
fn beyond_the_table_and_out_of_range() {
    let model = model(&Params::paper());
    let sigma = model.params().height_std;
    // As a power of the compression.
    for (depth, known) in [(1e4, 1e-3), (1e5, 1e-2), (3e7, 0.1), (4e9, 0.2), (1e12, 0.5)] {
        let exact = model.state_at_gap(-depth * sigma).expect("a state");
        let (load, slope) = model.load_and_slope_at_gap(-depth * sigma);
        assert!((load / exact.load - 1.0).abs() < known, "{depth:e}: {load:e}, not {:e}", exact.load);
        let step = 1e-4 * depth * sigma;
        let beside = [-step, step].map(|step| model.load_at_gap(-depth * sigma + step));
        let secant = (beside[1] - beside[0]) / (2.0 * step);
        assert!((slope / secant - 1.0).abs() < 1e-6, "{depth:e}: {slope:e}, not {secant:e}");
    }
    for separation in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1e300] {
        let (load, slope) = model.load_and_slope_at_gap(separation);
        assert!(load.is_nan() && slope.is_nan(), "{separation}: {load}, {slope}");
        assert!(model.validate_gap(separation).is_err());
    }
}

/// However long or short their tails, from next to where they part to beyond the heaviest load that is compiled, and wherever gaps count
/// from: 0 of either sign lies anywhere between.
#[test]
fn at_every_gap_the_load_is_that_of_the_exact_state_or_goes_on_without_a_jump() {
    let tails = [
        (-1.9908, 18.8205),
        (0.9763, 9.40737),
        (-0.3347, 14.2123),
        (0.0, 5.0),
        (3.0, 60.0),
        (0.0, 95.0),
        (0.25, 17.0),
        (2.0, 40.0),
    ];
    let others = [HeightFamily::Weibull { shape: 1.05 }, HeightFamily::Weibull { shape: 30.0 }];
    let heights = tails.map(|(skew, kurtosis)| johnson(skew, kurtosis)).into_iter().chain(others);
    let (mut failures, mut models) = (Failures::default(), 0);
    for (heights, gamma) in heights
        .chain(families().into_iter().map(|(_, heights)| heights))
        .flat_map(|heights| [(heights.clone(), 0.0), (heights, 1e-3)])
    {
        let lone = Params { heights, ..dimensionless(0.01, 1000.0, gamma, 1.0) };
        let raised = |sigmas: f64| Params { summit_mean_height: sigmas * lone.height_std, ..lone.clone() };
        for params in [lone.clone(), raised(3.0), raised(9e3), crowded(lone.clone(), 0.3)] {
            // Some would part in steps.
            let Ok(model) = Model::new(&params) else { continue };
            models += 1;
            let (sigma, pull_off) = (params.height_std, model.summary().pull_off_load);
            let (heaviest, lightest) = range(&model);
            let zeros = [0.0, -0.0, 5e-324, -5e-324, 1e-300, -1e-300];
            let depths = [-8.0, -3.0, -0.5, 0.0, 1.0, 4.0, 8.0, 11.0, 15.0, 16.0, 20.0, 31.0, 40.0, 57.0, 64.0, 100.0];
            let around = depths.map(|depth| params.summit_mean_height - depth * sigma);
            for gap in zeros.into_iter().chain(around) {
                let (load, slope) = model.load_and_slope_at_gap(gap);
                let beside = model.load_at_gap(gap.above());
                let is_promised = gap <= lightest && model.validate_gap(gap).is_ok();
                let (true, Ok(exact)) = (is_promised, model.state_at_gap(gap)) else { continue };
                let what = || format!("gap {gap:e}: {load:e}, {slope:e}, not {:e}; {params:?}", exact.load);
                let size = exact.load.abs().max(-pull_off).max(1e-300);
                let step = (gap.above() - gap) * exact.dload_dgap.abs();
                failures.claim(load.is_finite() && slope <= 0.0, what);
                failures.claim((load - beside).abs() <= 1e-9 * size + 4.0 * step, what);
                let known = if gap < heaviest { 1e-2 } else { 1e-6 };
                failures.claim((load - exact.load).abs() <= known * size + step, what);
            }
        }
    }
    failures.report();
    assert!(models > 140, "{models} models");
}

/// Heights that end, with a density that jumps to 0 there, is 0 or falls faster; and, last, some that do not.
fn families() -> Vec<(&'static str, HeightFamily)> {
    let bins = |densities: &[f64]| bins(densities, 1e-11);
    vec![
        ("uniform", table(&[-1.0, 0.0, 1.0], &[1.0, 1.0, 1.0])),
        ("falling", table(&[-1.0, 0.0, 1.0], &[2.0, 1.0, 0.3])),
        ("triangle", table(&[-1.0, 0.0, 1.0], &[0.0, 1.0, 0.0])),
        ("histogram", bins(&[1.0, 3.0, 5.0, 4.0, 2.0, 0.5])),
        ("decades", bins(&[1.0, 3.0, 5.0, 4.0, 0.4, 0.04, 0.004])),
        ("a drop", bins(&[1.0, 3.0, 5.0, 4.0, 4e-5])),
        ("two drops", bins(&[1.0, 3.0, 5.0, 4.0, 1e-3, 1e-8])),
        ("far", table(&[-1.0, 1.0, 1.001, 100.0], &[1.0, 1.0, 1e-6, 1e-6])),
        ("bounded", johnson(0.0, 2.0)),
        ("bounded, skewed", johnson(-0.5, 2.2)),
        ("Weibull", HeightFamily::Weibull { shape: 3.0 }),
        ("Gaussian", HeightFamily::Gaussian),
    ]
}

/// Without adhesion, of elastic, yielding and varying summits, in two units: down to 1e-15 of the load at which half of them touch,
/// within 1e-6 or what a rounding of the separation changes the load by. Slopes too, where separations next to each other have digits.
#[test]
fn next_to_the_highest_summit_the_load_has_the_digits_of_the_separation() {
    let elastic = dimensionless(0.01, 1000.0, 0.0, 1.0);
    let yielding = Params {
        hardness: 0.01 * elastic.composite_modulus,
        contact_law: ContactLawKind::ElasticPlastic,
        ..elastic.clone()
    };
    let mut metres = elastic.clone();
    let lengths = [&mut metres.height_std, &mut metres.summit_radius, &mut metres.burgers_vector];
    lengths.into_iter().for_each(|length| *length *= 0.3e-9);
    metres.adhesion_range *= 0.3e-9;
    metres.composite_modulus *= 1e11;
    metres.effective_shear_modulus *= 1e11;
    let varying = Params { radius_amplitude: -0.6, ..elastic.clone() };
    let mut failures = Failures::default();
    for (surface, (name, heights)) in [elastic, yielding, metres, varying]
        .iter()
        .flat_map(|surface| families().into_iter().map(move |of| (surface, of)))
    {
        let model = model(&Params { heights, ..surface.clone() });
        let half = model.state_at_gap(0.0).expect("a state").load;
        for step in 0..60 {
            let Ok(state) = model.state_at_load(half * 10_f64.powf(-0.25 * f64::from(step) - 0.1)) else { continue };
            let exact = model.state_at_gap(state.gap).expect("a state");
            let (load, slope) = model.load_and_slope_at_gap(state.gap);
            let rounding = f64::EPSILON * (state.gap * exact.dload_dgap / exact.load).abs();
            let errors = [load / exact.load - 1.0, slope / exact.dload_dgap - 1.0].map(f64::abs);
            failures.claim(errors[0] <= 1e-6 + rounding && errors[1] <= 1e-4 + 100.0 * rounding, || {
                format!("{name}, {:e} of half contact: {errors:?}, rounding {rounding:e}", exact.load / half)
            });
        }
        // And all the way to where they part.
        let mut before = f64::INFINITY;
        let highest = model.state_at_load(1e-14 * half).expect("a state").gap;
        for i in 0..400 {
            let separation = highest + (f64::from(i) - 200.0) * 1e-14 * highest;
            let (load, slope) = model.load_and_slope_at_gap(separation);
            failures.claim((0.0..=before).contains(&load) && slope <= 0.0, || format!("{name}: {load:e}, {before:e}"));
            before = load;
        }
    }
    failures.report();
}
