//! What states warn of: each warning at its bound, and the warnings of a range of loads against many states in it.

use crate::common::surfaces::{johnson, model, table};
use asperity::{
    Error, HeightFamily, Model, Params, SlipConstants, SpectralMoments, State, WARNING_ADHESIVE, WARNING_ATOMIC,
    WARNING_BROAD, WARNING_CROWDED, WARNING_FEW, WARNING_FEW_WAVES, WARNING_NOT_GAUSSIAN, WARNING_PLASTIC,
    WARNING_STEEP, WARNING_STRONG, WARNING_UNCALIBRATED,
};

/// Summits of 10 to a radius of 1000, without adhesion, and all in order where 0.6 % of them touch.
fn in_order() -> Params {
    Params {
        composite_modulus: 1.0,
        effective_shear_modulus: 0.8,
        work_of_adhesion: 0.0,
        burgers_vector: 0.1,
        height_std: 1.0,
        summit_radius: 1000.0,
        asperity_count: 1e6,
        hardness: 1.0,
        // A weak interface, which somebody measured.
        slip: SlipConstants { stress_1: 1e-4, stress_2: 1e-5, ..SlipConstants::default() },
        ..Params::paper()
    }
}

fn at(params: &Params, separation: f64) -> State {
    model(params).state_at_gap(separation * params.height_std).expect("a state")
}

/// Where the nominal area counts, for which a gap is another load.
fn under(params: &Params, load: f64) -> State {
    model(params).state_at_load(load).expect("a state")
}

/// Fails unless a warning is all that is set on one side of its bound, and nothing on the other.
fn sets_in(warning: u64, name: &str, fine: &State, bad: &State) {
    assert_eq!((fine.warnings, bad.warnings), (0, warning), "{name}: {fine:?}, {bad:?}");
}

#[test]
fn each_assumption_has_its_warning() {
    let params = in_order();
    let state = at(&params, 2.5);
    assert_eq!(state.warnings, 0, "{state:?}");

    // A tenth of Gaussian heights lies above 1.2815516 sigma (Abramowitz and Stegun, table 26.5).
    sets_in(WARNING_CROWDED, "summits", &at(&params, 1.2816), &at(&params, 1.2815));

    let of_area = |part: f64| Params { nominal_area: state.real_area / part, bandwidth: 2.0, ..in_order() };
    let [fine, bad] = [0.099_999, 0.100_001].map(|part| under(&of_area(part), state.load));
    sets_in(WARNING_CROWDED, "area", &fine, &bad);

    let of_radius = |factor: f64, radius: f64| Params { burgers_vector: radius * factor, ..in_order() };
    let radius = state.mean_contact_radius;
    sets_in(WARNING_ATOMIC, "b", &at(&of_radius(0.999_999, radius), 2.5), &at(&of_radius(1.000_001, radius), 2.5));

    // a/R goes like (sigma/R)^(1/2).
    let of_steepness = |factor: f64| Params {
        summit_radius: 1000.0 * (state.mean_contact_radius / 1000.0 / (0.1 * factor)).powi(2),
        hardness: 0.0,
        ..in_order()
    };
    sets_in(WARNING_STEEP, "a/R", &at(&of_steepness(0.999_999), 2.5), &at(&of_steepness(1.000_001), 2.5));

    let of_number = |number: f64| Params { asperity_count: number / state.fraction_in_contact, ..in_order() };
    sets_in(WARNING_FEW, "20 contacts", &at(&of_number(20.000_01), 2.5), &at(&of_number(19.999_99), 2.5));
    assert_eq!(at(&Params { asperity_count: 1.0, ..in_order() }, 2.5).warnings, 0, "the loads of a mean summit");
    assert_eq!(at(&params, 100.0).warnings, WARNING_FEW, "nothing touches");
    assert_eq!(at(&Params { asperity_count: 1.0, ..in_order() }, 100.0).warnings, 0);

    // The plasticity index; contacts.rs has the pressure.
    let of_hardness = |factor: f64| Params { hardness: (1.0_f64 / 1000.0).sqrt() * factor, ..in_order() };
    sets_in(WARNING_PLASTIC, "psi", &at(&of_hardness(1.000_001), 2.5), &at(&of_hardness(0.999_999), 2.5));
}

#[test]
fn the_strength_of_the_interface_has_its_warnings() {
    let params = in_order();
    let default = Params { slip: SlipConstants::default(), ..in_order() };
    sets_in(WARNING_UNCALIBRATED, "default stresses", &at(&params, 2.5), &at(&default, 2.5));
    for measured in [
        Params { pressure_coefficient: 1e-3, ..default.clone() },
        Params { slip: SlipConstants { stress_2: 1e-3, ..default.slip }, ..default.clone() },
    ] {
        assert_eq!(at(&measured, 2.5).warnings, 0, "{measured:?}");
    }
    for not_measured in [
        Params { slip: SlipConstants { radius_1: 30.0, ..default.slip }, ..default.clone() },
        Params { asperity_count: 1.0, ..default.clone() },
    ] {
        assert_eq!(at(&not_measured, 2.5).warnings, WARNING_UNCALIBRATED, "{not_measured:?}");
    }
    let mut calibrated = default.clone();
    calibrated.calibrate(1.0, 0.02).expect("a strength");
    assert_eq!(model(&calibrated).state_at_load(1.0).expect("a state").warnings & WARNING_UNCALIBRATED, 0);

    // The softer body yields in shear at H/(3 sqrt 3), after von Mises with H three times the yield stress; below a_1 the stress
    // is tau_1.
    let strength = 1.0 / 27.0_f64.sqrt();
    let of_stress = |part: f64| {
        let stress = strength / params.effective_shear_modulus * part;
        Params {
            slip: SlipConstants { radius_1: 1e6, stress_1: stress, radius_2: 1e7, stress_2: stress },
            ..in_order()
        }
    };
    sets_in(WARNING_STRONG, "shear", &at(&of_stress(0.999_999), 2.5), &at(&of_stress(1.000_001), 2.5));
    assert_eq!(at(&Params { hardness: 0.0, ..of_stress(1.1) }, 2.5).warnings, 0, "a hardness that is not known");
}

#[test]
fn broad_surfaces_are_warned_of_by_bandwidth_or_by_their_summits() {
    let of_bandwidth = |bandwidth: f64| Params { bandwidth, ..in_order() };
    sets_in(WARNING_BROAD, "bandwidth", &at(&of_bandwidth(6.0), 2.5), &at(&of_bandwidth(6.000_001), 2.5));
    // 0.8968 + (eta sigma R/0.02036)^2 = 6; the area is large enough not to crowd.
    let density = 0.02036 * (6.0_f64 - 0.8968).sqrt() / 1000.0;
    let of_density = |factor: f64| Params { nominal_area: 1e6 / (density * factor), ..in_order() };
    let bits = |params: &Params| at(params, 3.5).warnings & WARNING_BROAD;
    assert_eq!((bits(&of_density(0.999_999)), bits(&of_density(1.000_001))), (0, WARNING_BROAD));
    // A bandwidth that is given counts.
    assert_eq!(bits(&Params { bandwidth: 2.0, ..of_density(2.0) }), 0);
}

/// A slope that is known says how steep the surface is, and the area how crowded: not the asperities that stand for it.
#[test]
fn where_the_slope_is_known_it_and_the_area_judge() {
    let of_slope = |rms_slope: f64| Params { rms_slope, ..in_order() };
    sets_in(WARNING_STEEP, "slope", &at(&of_slope(0.3), 2.5), &at(&of_slope(0.300_001), 2.5));
    // Half of them touch, and a/R is above a tenth.
    let close = |rms_slope: f64| Params { summit_radius: 10.0, hardness: 0.0, ..of_slope(rms_slope) };
    assert_eq!(at(&close(0.0), 0.0).warnings, WARNING_CROWDED | WARNING_STEEP);
    assert_eq!(at(&close(0.1), 0.0).warnings, 0);
    let state = at(&close(0.1), 0.0);
    let crowded = |share: f64| Params { nominal_area: state.real_area / share, bandwidth: 2.0, ..close(0.1) };
    let [fine, bad] = [0.099_999, 0.100_001].map(|share| under(&crowded(share), state.load));
    sets_in(WARNING_CROWDED, "area", &fine, &bad);
}

/// Eight of the mean length, 2 pi sigma over the slope.
#[test]
fn few_waves_on_the_nominal_area_are_warned_of() {
    let of_waves = |waves: f64| {
        let side = waves * std::f64::consts::TAU / 0.01;
        Params { rms_slope: 0.01, nominal_area: side * side, bandwidth: 2.0, ..in_order() }
    };
    let bits = |params: &Params| at(params, 2.5).warnings & WARNING_FEW_WAVES;
    assert_eq!((bits(&of_waves(8.000_01)), bits(&of_waves(7.999_99))), (0, WARNING_FEW_WAVES));
    // What is not known, and one tip, are not judged.
    assert_eq!(bits(&Params { rms_slope: 0.0, ..of_waves(4.0) }), 0);
    assert_eq!(bits(&Params { nominal_area: 0.0, ..of_waves(4.0) }), 0);
    assert_eq!(bits(&Params { asperity_count: 1.0, ..of_waves(4.0) }), 0);
}

/// Only where Gaussian heights stand for others.
#[test]
fn heights_that_are_taken_as_gaussian_are_warned_of() {
    let taken = Params { taken_as_gaussian: true, ..in_order() };
    sets_in(WARNING_NOT_GAUSSIAN, "taken as Gaussian", &at(&in_order(), 2.5), &at(&taken, 2.5));
    let johnson = Params { heights: HeightFamily::Johnson { skew: -1.0, kurtosis: 5.0 }, ..taken };
    assert_eq!(at(&johnson, 1.0).warnings & WARNING_NOT_GAUSSIAN, 0);
}

/// Never broad, whatever the bandwidth; steep, crowded and of few waves by what moments and area say.
#[test]
fn the_asperities_of_moments_are_warned_of_by_slope_area_and_waves() {
    let of = |m2: f64, bandwidth: f64, area: f64| {
        let mut params = in_order();
        let moments = SpectralMoments { m0: 4.0, m2, m4: bandwidth * m2 * m2 / 4.0 };
        params.set_spectral_moments(moments, area).expect("asperities");
        params.hardness = 0.0;
        params
    };
    for bandwidth in [0.0, 1.5, 10.0, 100.0, 1e5] {
        let model = model(&of(0.005, bandwidth, 1e8));
        let part = |x: f64| x * 0.1 * 1e8;
        assert_eq!(model.check_loads(part(1e-4), part(0.04)), Ok(0), "{bandwidth}");
        assert_eq!(model.check_loads(part(0.06), part(0.07)), Ok(WARNING_CROWDED), "{bandwidth}");
    }
    let steep = model(&of(0.046, 10.0, 1e8)).check_loads(1e4, 1e5).expect("warnings");
    assert_eq!(steep, WARNING_STEEP);
    let few = model(&of(0.005, 10.0, 2e5)).check_loads(800.0, 900.0).expect("warnings");
    assert_eq!(few, WARNING_FEW_WAVES | WARNING_FEW);
}

/// One summit on its own does not crowd.
#[test]
fn a_single_tip_is_not_crowded() {
    let tip = Params { asperity_count: 1.0, ..in_order() };
    assert_eq!(at(&tip, -2.0).warnings & (WARNING_CROWDED | WARNING_FEW | WARNING_ADHESIVE | WARNING_UNCALIBRATED), 0);
}

/// More than one load, and one load alone: Derjaguin's part is as large as the load.
#[test]
fn adhesion_that_exceeds_the_load_is_warned_of() {
    let sticky = Params { work_of_adhesion: 0.02, adhesion_range: 0.1, hardness: 0.0, ..in_order() };
    let model = model(&sticky);
    let pull_off = model.summary().pull_off_load;
    let warnings = |load: f64| model.state_at_load(load).expect("a state").warnings & WARNING_ADHESIVE;
    assert!(pull_off < 0.0);
    for part in [1.0, 0.5, 0.0, -0.5, -0.999_999] {
        assert_eq!(warnings(part * pull_off), WARNING_ADHESIVE, "{part} of {pull_off}");
    }
    // The heaviest load with the warning, well above the pull-off load.
    let (mut heaviest, mut heavier) = (-1.5 * pull_off, -1e3 * pull_off);
    while heavier > (1.0 + 1e-9) * heaviest {
        let middle = (heaviest * heavier).sqrt();
        *if warnings(middle) == 0 { &mut heavier } else { &mut heaviest } = middle;
    }
    let state = model.state_at_load(heaviest).expect("a state");
    assert!((state.hertz_load / (2.0 * heaviest) - 1.0).abs() < 1e-6, "{state:?}");
    let found = model.check_loads(0.9 * heaviest, 2.0 * heaviest).expect("warnings");
    assert_eq!(found & WARNING_ADHESIVE, WARNING_ADHESIVE);
    let tip = Model::new(&Params { asperity_count: 1.0, ..sticky }).expect("a model");
    assert_eq!(tip.state_at_load(0.0).expect("a state").warnings & WARNING_ADHESIVE, 0);
}

/// Where radii change with height, a/R is that of each summit.
#[test]
fn sharp_summits_are_steep_at_their_own_radius() {
    // All that touches is above the bend of g: taller summits have a fifth of the mean radius.
    let sharp = Params { radius_amplitude: -0.8, radius_rate: 8.0, summit_radius: 100.0, ..in_order() };
    let state = at(&sharp, 2.0);
    let own = state.mean_contact_radius / (0.2 * sharp.summit_radius);
    assert!((state.mean_steepness / own - 1.0).abs() < 1e-9, "{}, not {own}", state.mean_steepness);
}

/// All heights in the tests below are in contact at some load; all surfaces differ in what changes with load.
fn surfaces() -> Vec<(&'static str, Params)> {
    let with = |heights: HeightFamily| Params { heights, ..in_order() };
    let two_humped = table(&[-0.4, -0.3, -0.2, 3.0, 3.5, 4.0], &[0.0, 1.0, 0.0, 0.0, 0.004, 0.0]);
    vec![
        ("Gaussian", in_order()),
        ("Weibull", with(HeightFamily::Weibull { shape: 1.5 })),
        ("Johnson", with(johnson(1.0, 6.0))),
        ("two humps", with(two_humped.clone())),
        ("two humps that adhere", Params { work_of_adhesion: 1e-6, ..with(two_humped) }),
        ("sharp tall summits", Params { radius_amplitude: -0.9, ..in_order() }),
        ("sharp low summits", Params { radius_amplitude: 0.999, radius_rate: 3.0, ..in_order() }),
        ("adhesive", Params { work_of_adhesion: 1e-5, adhesion_range: 0.1, ..in_order() }),
    ]
}

/// Loads spaced evenly in separation, from where one summit in 1e4 touches to where all do.
fn states(model: &Model) -> Vec<State> {
    let sigma = model.params().height_std;
    let state = |i: i32| model.state_at_gap((-6.0 + 0.01 * f64::from(i)) * sigma).expect("a state");
    let pull_off = model.summary().pull_off_load;
    let mut states: Vec<State> = (0..1000).map(state).take_while(|s| s.fraction_in_contact > 1e-4).collect();
    states.retain(|state| state.load > pull_off.max(-f64::MAX) && state.dload_dgap < 0.0);
    states.sort_by(|a, b| b.load.total_cmp(&a.load));
    states
}

/// Fails unless the check of all loads of the states finds a warning that is set in one of them alone.
fn finds(name: &str, params: &Params, warning: u64, wanted: bool) {
    let model = model(params);
    let states = states(&model);
    let (heaviest, lightest) = (states[0].load, states[states.len() - 1].load);
    let found = model.check_loads(lightest, heaviest).expect("warnings");
    let seen = states.iter().fold(0, |bits, state| bits | state.warnings);
    assert_eq!(seen & !found, 0, "{name}: states warn of {seen:b}, their range of {found:b}");
    assert_eq!(found & warning != 0, wanted, "{name}: {found:b}, warning {warning:b}");
}

/// Each bound is moved to just below and just above the largest value among many states, wherever that is.
#[test]
fn the_largest_pressure_and_steepness_and_the_smallest_radius_between_two_loads_are_found() {
    let mut inside = 0;
    for (name, params) in surfaces() {
        let states = states(&model(&params));
        let values = |value: fn(&State) -> f64| states.iter().map(value).collect::<Vec<f64>>();
        let pressures = values(|state| state.mean_asperity_pressure);
        let radii = values(|state| state.mean_contact_radius);
        let steepness = values(|state| state.mean_steepness);
        let [pressure, steep] = [&pressures, &steepness].map(|all| all.iter().fold(0.0_f64, |a, &b| a.max(b)));
        let radius = radii.iter().fold(f64::MAX, |a, &b| a.min(b));
        inside += usize::from(radii[radii.len() - 1] > radius) + usize::from(steepness[0] < steep);
        for (factor, wanted) in [(1.0 - 1e-5, true), (1.0 + 1e-3, false)] {
            let hardness = pressure / 0.4 * factor;
            let yields = Params { hardness, ..params.clone() };
            // A rough surface yields at any load, whatever its pressure.
            if params.composite_modulus / hardness * (params.height_std / params.summit_radius).sqrt() < 0.99 {
                finds(name, &yields, WARNING_PLASTIC, wanted);
            }
            if params.work_of_adhesion == 0.0 {
                finds(name, &Params { burgers_vector: radius / factor, ..params.clone() }, WARNING_ATOMIC, wanted);
                let summit_radius = params.summit_radius * (steep * factor / 0.1).powi(2);
                finds(name, &Params { summit_radius, ..params.clone() }, WARNING_STEEP, wanted);
            }
        }
    }
    assert!(inside >= 2, "no more than {inside} of these values lie between the ends of the range");
}

#[test]
fn numbers_of_contacts_are_worst_at_the_ends_of_the_range() {
    for (name, params) in surfaces() {
        let whole = model(&params);
        let states = states(&whole);
        let load = |fraction: f64| {
            let next = states.iter().find(|state| state.fraction_in_contact <= fraction).expect("a state");
            next.load
        };
        let found = whole.check_loads(load(0.05), load(0.099)).expect("warnings");
        assert_eq!(found & (WARNING_CROWDED | WARNING_FEW), 0, "{name}");
        let found = whole.check_loads(load(0.05), load(0.2)).expect("warnings");
        assert_eq!(found & (WARNING_CROWDED | WARNING_FEW), WARNING_CROWDED, "{name}");
        let few = Params { asperity_count: 100.0, ..params.clone() };
        let heavy = load(0.05) * 1e-4;
        let light = model(&few).check_loads(0.1 * heavy, heavy).expect("warnings");
        assert_eq!(light & (WARNING_CROWDED | WARNING_FEW), WARNING_FEW, "{name}");
    }
}

#[test]
fn one_load_has_the_warnings_of_its_state() {
    for (name, params) in surfaces() {
        let model = model(&params);
        for state in states(&model).iter().step_by(97) {
            let exact = model.state_at_load(state.load).expect("a state").warnings;
            assert_eq!(model.check_loads(state.load, state.load), Ok(exact), "{name} at {}", state.load);
        }
    }
    // A load of next to nothing, which the sums have only to rounding: it is the caller's that is compared with Hertz'.
    let barely_adheres = Params {
        composite_modulus: 1.04e22,
        effective_shear_modulus: 7.29e21,
        work_of_adhesion: 6.9e11,
        adhesion_range: 4.9e-9,
        burgers_vector: 2e-9,
        height_std: 5.5e-4,
        summit_radius: 0.31,
        asperity_count: 1.4e11,
        hardness: 0.0,
        heights: johnson(0.248, 17.05),
        ..in_order()
    };
    let lightest = 2.2e-308;
    let model = model(&barely_adheres);
    let exact = model.state_at_load(lightest).expect("a state").warnings;
    assert_eq!(exact & WARNING_ADHESIVE, WARNING_ADHESIVE);
    let found = model.check_loads(lightest, lightest).expect("warnings");
    assert_eq!(found & exact, exact);
}

/// From the pull-off load to the heaviest that can be evaluated.
#[test]
fn the_whole_range_of_loads_can_be_checked() {
    let adhesive = Params { work_of_adhesion: 1e-5, adhesion_range: 0.1, ..in_order() };
    let model = model(&adhesive);
    let all = model.check_loads(model.summary().pull_off_load, 1e84);
    assert_eq!(all, Ok(WARNING_PLASTIC | WARNING_CROWDED | WARNING_STEEP | WARNING_FEW | WARNING_ADHESIVE));
}

#[test]
fn loads_that_have_no_state_cannot_be_checked() {
    let adhesive = model(&Params { work_of_adhesion: 1e-5, adhesion_range: 0.1, ..in_order() });
    let below = 1.1 * adhesive.summary().pull_off_load;
    assert!(matches!(adhesive.check_loads(below, 1.0), Err(Error::Separated { .. })));
    assert!(matches!(adhesive.check_loads(f64::NAN, 1.0), Err(Error::InvalidLoad { .. })));
    assert!(matches!(adhesive.check_loads(1.0, f64::INFINITY), Err(Error::InvalidLoad { .. })));
    assert!(matches!(adhesive.check_loads(1.0, 1e300), Err(Error::OutOfRange { .. })));
    let told =
        |lightest: f64, heaviest: f64| model(&in_order()).check_loads(lightest, heaviest).unwrap_err().to_string();
    assert!(told(-1.0, 1.0).starts_with("lightest = -1: below the pull-off load"), "{}", told(-1.0, 1.0));
    assert!(told(1.0, f64::NAN).starts_with("heaviest = NaN: must be finite"), "{}", told(1.0, f64::NAN));
    let falling = adhesive.check_loads(2.0, 1.0).expect_err("loads that fall");
    assert_eq!(falling.to_string(), "lightest = 2: must not be above heaviest");
    assert!(matches!(model(&in_order()).check_loads(0.0, 1.0), Err(Error::OutOfRange { .. })), "nothing touches");
}
