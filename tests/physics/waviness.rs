//! Wavy surfaces: the sum over places of the law without waves, worked out another way from calls on a model without them.

use crate::common::surfaces::{crowded, dimensionless, johnson, model, table};
use asperity::{ContactLawKind, HeightFamily, Model, Params, Waviness, WavinessShape};
use std::f64::consts::{PI, SQRT_2};

fn yielding(index: f64) -> Params {
    let elastic = Params { asperity_count: 1e4, ..dimensionless(0.02, 2000.0, 0.0, 1.0) };
    let hardness = 0.02 * elastic.composite_modulus / index;
    Params { hardness, contact_law: ContactLawKind::ElasticPlastic, ..elastic }
}

fn surfaces() -> Vec<Params> {
    let elastic = Params { contact_law: ContactLawKind::Maugis, hardness: 0.0, ..yielding(1.0) };
    let varying = Params { radius_amplitude: -0.61, radius_rate: 0.9, ..yielding(3.0) };
    vec![
        crowded(elastic, 0.1),
        crowded(varying.clone(), 0.05),
        crowded(Params { heights: johnson(-1.0, 4.0), ..varying.clone() }, 0.05),
        crowded(Params { heights: HeightFamily::Weibull { shape: 2.2 }, ..yielding(1.5) }, 0.1),
    ]
}

/// Heights in `height_std`, and the part of the root of the nominal area that a wave is wide.
fn wavy(params: &Params, shape: WavinessShape, height: f64, part: f64) -> Params {
    let waviness = Waviness { height: height * params.height_std, width: part * params.nominal_area.sqrt(), shape };
    Params { waviness, ..params.clone() }
}

fn near(what: &str, found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{what}: {found:e}, not {expected:e}");
}

/// Heights of places of equal size.
fn heights(Waviness { height, shape, .. }: Waviness) -> Vec<f64> {
    let cosines = |count: usize| (0..count).map(move |i| (PI * (i as f64 + 0.5) / count as f64).cos());
    match shape {
        WavinessShape::Hills => cosines(48).flat_map(|x| cosines(48).map(move |y| height * (x + y))).collect(),
        _ => cosines(300).map(|x| SQRT_2 * height * x).collect(),
    }
}

/// Loads, friction, area, stiffness and gap of a wavy surface by bisection at each of many places.
struct Summed {
    load: f64,
    friction: f64,
    area: f64,
    stiffness: f64,
    tangential: f64,
    gap: f64,
}

fn summed(even: &Model, waviness: Waviness, mean_plane: f64) -> Summed {
    let area = even.params().nominal_area;
    // The compliance per load; that of displacement along the surfaces, per tangential stiffness.
    let c = waviness.width / (PI * even.params().composite_modulus) / area;
    let l = 2.0 * even.params().composite_modulus * c / even.summary().stiffness_per_radius;
    let (mut sum, mut given, mut shared) = ([0.0; 4], 0.0, 0.0);
    let places = heights(waviness);
    for height in &places {
        let off = |gap: f64| gap - c * even.load_at_gap(gap) - (mean_plane - height);
        let (mut low, mut high) = (mean_plane - height, mean_plane - height);
        let mut step = even.params().height_std;
        while off(high) < 0.0 {
            high += step;
            step *= 2.0;
        }
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            *if off(middle) < 0.0 { &mut low } else { &mut high } = middle;
        }
        let (load, slope) = even.load_and_slope_at_gap(high);
        let real_area = if load > 1e-200 { even.state_at_load(load).expect("a state").real_area } else { 0.0 };
        let tangential = even.tangential_stiffness_at_load(load);
        let all = [load, even.friction_force_at_load(load), real_area, high];
        sum = std::array::from_fn(|i| sum[i] + all[i] / places.len() as f64);
        given += -slope / (1.0 - c * slope) / places.len() as f64;
        shared += tangential / (1.0 + l * tangential) / places.len() as f64;
    }
    let [load, friction, area, gap] = sum;
    Summed { load, friction, area, gap, stiffness: given / (1.0 - c * given), tangential: shared / (1.0 - l * shared) }
}

#[test]
fn states_and_what_is_compiled_are_sums_over_places() {
    for (i, params) in surfaces().into_iter().enumerate() {
        let even = model(&params);
        for (shape, height, part) in [
            (WavinessShape::Ridges, 0.5, 0.1),
            (WavinessShape::Ridges, 4.0, 0.3),
            (WavinessShape::Hills, 1.0, 1.0),
            (WavinessShape::Hills, 15.0, 0.1),
            (WavinessShape::Hills, 29.0, 0.1),
        ] {
            let params = wavy(&params, shape, height, part);
            let wavy = model(&params);
            // Of high waves some 5 digits are had by either way, of heights that end some 4 by 24 places.
            let tolerance = if i == 2 {
                5e-4
            } else if height > 20.0 {
                3e-4
            } else if height > 4.0 {
                3e-5
            } else {
                3e-6
            };
            for separation in [-2.0, 0.5, 3.0] {
                let crest = params.summit_mean_height + separation * params.height_std + 1.2 * params.waviness.height;
                let expected = summed(&even, params.waviness, crest);
                if expected.load == 0.0 {
                    continue;
                }
                let state = wavy.state_at_load(expected.load).expect("a state");
                let name = |of: &str| format!("{of} of {i} {shape:?} {height} at {separation}");
                near(&name("F"), state.friction_force, expected.friction, tolerance);
                near(&name("A"), state.real_area, expected.area, tolerance);
                near(&name("K"), -state.dload_dgap, expected.stiffness, 20.0 * tolerance);
                near(&name("K_t"), state.tangential_stiffness, expected.tangential, tolerance);
                assert!(
                    (state.gap - expected.gap).abs() < 3.0 * tolerance * params.height_std,
                    "{} {}",
                    state.gap,
                    expected.gap
                );
                near(&name("compiled F"), wavy.friction_force_at_load(state.load), expected.friction, tolerance);
                near(
                    &name("compiled K_t"),
                    wavy.tangential_stiffness_at_load(state.load),
                    expected.tangential,
                    tolerance,
                );
                near(&name("P"), wavy.load_at_gap(expected.gap), expected.load, 20.0 * tolerance);
            }
        }
    }
}

/// Heights with a density that has kinks, on waves up to the highest.
#[test]
fn what_is_compiled_is_the_state_however_kinked_the_heights_are() {
    let kinked = table(&[-2.0, -1.0, 0.3, 1.0, 3.0], &[0.0, 0.4, 0.3, 0.5, 0.0]);
    let ended = table(&[-1.2, -1.0, -0.8, 0.8, 1.0, 1.2], &[0.0, 2.0, 0.01, 0.01, 2.0, 0.0]);
    for heights in [kinked, ended] {
        let even = crowded(Params { heights, ..yielding(1.5) }, 0.1);
        for (shape, height, part) in
            [(WavinessShape::Ridges, 1.0, 0.3), (WavinessShape::Hills, 5.0, 0.3), (WavinessShape::Hills, 29.0, 0.1)]
        {
            let wavy = model(&wavy(&even, shape, height, part));
            let half = model(&even).state_at_gap(even.summit_mean_height).expect("a state").load;
            for part in [1e-6, 1e-3, 0.1, 1.0, 20.0] {
                let state = wavy.state_at_load(part * half).expect("a state");
                near("F", wavy.friction_force_at_load(part * half), state.friction_force, 1e-5);
                near("K_t", wavy.tangential_stiffness_at_load(part * half), state.tangential_stiffness, 1e-5);
            }
        }
    }
}

#[test]
fn low_waves_change_nothing_and_stiff_ridges_close_at_westergaards_pressure() {
    for params in surfaces() {
        let (even, low) = (model(&params), model(&wavy(&params, WavinessShape::Hills, 0.01, 0.1)));
        let half = even.state_at_gap(params.summit_mean_height).expect("a state").load;
        for part in [1e-3, 0.1, 3.0] {
            let [one, other] = [&even, &low].map(|model| model.state_at_load(part * half).expect("a state"));
            near("F", other.friction_force, one.friction_force, 2e-3);
            near("K", other.dload_dgap, one.dload_dgap, 3e-3);
            near("K_t", other.tangential_stiffness, one.tangential_stiffness, 3e-3);
        }
    }
    // The troughs begin to bear.
    let params = wavy(&crowded(yielding(1.0), 0.1), WavinessShape::Ridges, 25.0, 0.5);
    let wavy = model(&Params { hardness: 0.0, contact_law: ContactLawKind::Maugis, ..params.clone() });
    let closing =
        SQRT_2 * PI * params.composite_modulus * params.waviness.height / params.waviness.width * params.nominal_area;
    let touching = |part: f64| wavy.state_at_load(part * closing).expect("a state").fraction_in_contact;
    assert!(touching(0.5) < 0.75 && touching(1.1) > 0.97, "{} {}", touching(0.5), touching(1.1));
}

/// Loops of microslip begin with the tangential stiffness and end at the friction force, as what is summed exactly does.
#[test]
fn microslip_is_that_of_the_places_together() {
    for params in surfaces() {
        for (shape, height) in [(WavinessShape::Ridges, 3.0), (WavinessShape::Hills, 1.0)] {
            let wavy = model(&wavy(&params, shape, height, 0.2));
            for part in [1e-3, 0.3] {
                let load = part * model(&params).state_at_gap(params.summit_mean_height).expect("a state").load;
                let (force, stiffness) = (wavy.friction_force_at_load(load), wavy.tangential_stiffness_at_load(load));
                for x in [0.05, 0.3, 1.0, 3.0, 30.0] {
                    let displacement = x * force / stiffness;
                    let (exact, _) = wavy.tangential_at_load(load, displacement).expect("a force");
                    let mut state = [0.0; asperity::MICROSLIP_LENGTH];
                    let step = wavy.microslip_step(load, [displacement, 0.0], &mut state).expect("a step");
                    near(&format!("T at {x}"), step.force[0], exact, 0.01);
                }
                let (_, at_first) = wavy.tangential_at_load(load, 1e-9 * force / stiffness).expect("a force");
                near("K_t", at_first, stiffness, 1e-3);
            }
        }
    }
}

/// In N, mm and MPa the answers are the same.
#[test]
fn units_do_not_matter() {
    let si = wavy(&crowded(yielding(1.5), 0.1), WavinessShape::Hills, 2.0, 0.3);
    let mut mm = si.clone();
    mm.set_units(1e-3, 1.0).expect("units");
    let load = 1e-3 * si.composite_modulus * si.nominal_area;
    let [one, other] = [&si, &mm].map(|params| model(params).state_at_load(load).expect("a state"));
    near("F", other.friction_force, one.friction_force, 1e-9);
    near("K", other.dload_dgap * 1e3, one.dload_dgap, 1e-9);
}

#[test]
fn what_no_waves_are_is_refused_at_its_name() {
    let good = wavy(&crowded(yielding(1.5), 0.1), WavinessShape::Ridges, 2.0, 0.3);
    let with = |change: &dyn Fn(&mut Params)| {
        let mut params = good.clone();
        change(&mut params);
        Model::new(&params).map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(with(&|_| ()), Ok(()));
    type Change<'a> = (&'a dyn Fn(&mut Params), &'a str);
    let changes: [Change; 17] = [
        (&|p| p.waviness.height = -1.0, "waviness_height = -1"),
        (&|p| p.waviness.height = f64::NAN, "waviness_height = NaN"),
        (&|p| p.waviness.width = -1.0, "waviness_width = -1"),
        (&|p| p.waviness.width = 0.0, "waviness_width = 0: must be"),
        (&|p| p.waviness.shape = WavinessShape::Unknown, "measure the waves along two directions"),
        (&|p| p.waviness.height *= 1e3, "waviness_height"),
        (&|p| p.waviness.height *= 1e6, "are both in one unit?"),
        (&|p| p.waviness.height *= 1e-3, "lower waves change nothing"),
        (&|p| p.waviness.width *= 1e3, "at least waviness_width^2"),
        (&|p| p.waviness.width *= 1e-3, "waviness_width"),
        (&|p| p.waviness.width *= 0.03, "shorter waves are roughness"),
        (&|p| p.waviness.width *= 4.0, "nominal_area"),
        (&|p| p.nominal_area = 0.0, "nominal_area = 0: must be known"),
        (&|p| p.rms_slope = 1e-6, "waves are roughness"),
        (&|p| (p.contact_law, p.work_of_adhesion) = (ContactLawKind::Maugis, 1e-3), "adhesion of wavy surfaces"),
        (&|p| (p.waviness.width, p.waviness.height) = (p.waviness.height, p.waviness.width), "are both in one unit?"),
        (&|p| p.waviness.height = f64::INFINITY, "waviness_height = inf"),
    ];
    for (i, (change, told)) in changes.into_iter().enumerate() {
        let error = with(change).expect_err("no waves");
        assert!(error.contains(told), "{i}: {error}, not {told}");
    }
    // Without waves nothing else of them is read.
    assert_eq!(with(&|p| (p.waviness.height, p.waviness.width) = (0.0, 1e9)), Ok(()));
}

#[test]
fn unloading_and_single_specimens_of_wavy_surfaces_are_refused() {
    let wavy = model(&wavy(&crowded(yielding(1.5), 0.1), WavinessShape::Ridges, 2.0, 0.3));
    let load = 1e-3 * wavy.params().composite_modulus * wavy.params().nominal_area;
    let told = wavy.unloaded(load).expect_err("waves").to_string();
    for says in ["different pressures", "take unloading_stiffness of the state", "set waviness_height to 0"] {
        assert!(told.contains(says), "{told}");
    }
    let told = wavy.specimens_at_loads(asperity::Specimens { count: 1, ..Default::default() }, &[load]);
    assert!(told.expect_err("waves").to_string().contains("waviness_height"));
}
