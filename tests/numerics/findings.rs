//! What fuzzing and the sweep over the box of parameters found, each kept as a case.

use crate::common::neighbours::Neighbours;
use crate::common::processor_time::{processor_time, LONGEST_CALL};
use crate::common::surfaces::{dimensionless, johnson, table};
use asperity::{HeightFamily, Model, Params};

fn surface(alpha: f64, beta: f64, gamma: f64, b_over_h: f64, shape: f64) -> Params {
    Params {
        heights: HeightFamily::Weibull { shape },
        attraction: false,
        ..dimensionless(alpha, beta, gamma, b_over_h)
    }
}

/// With attraction, heights, and radii that vary: amplitude and rate.
fn varying([alpha, beta, gamma, b_over_h]: [f64; 4], heights: HeightFamily, radii: [f64; 2]) -> Params {
    let [radius_amplitude, radius_rate] = radii;
    Params { heights, radius_amplitude, radius_rate, ..dimensionless(alpha, beta, gamma, b_over_h) }
}

/// The search for the pull-off point stepped from a falling load to where all contacts are broken.
#[test]
fn the_pull_off_point_is_found_where_contact_reaches_far_beyond_the_heights() {
    let model = Model::new(&surface(6.915821e-4, 9.201681, 9.995e-4, 0.608147, 13.3389)).expect("a model");
    let summary = model.summary();
    let state = model.state_at_gap(0.0).expect("a state");
    assert!(state.load < 0.0 && summary.pull_off_load < state.load, "{summary:?}");
    assert!(summary.min_table_load >= summary.pull_off_load, "{summary:?}");
}

/// Next to pull-off the load was integrated across the separation at which the lowest summits break away.
#[test]
fn a_load_next_to_pull_off_is_that_of_its_separation() {
    let params = Params {
        radius_amplitude: 0.040039,
        radius_rate: 1.335772e-3,
        ..surface(2.635714938e-3, 1.138666346, 8.304721783e-5, 1.2326602839, 1.34723082)
    };
    let model = Model::new(&params).expect("a model");
    let pull_off = model.summary().pull_off_load;
    for x in [1e-7, 1e-6, 3e-6, 1e-5, 3e-5, 9e-5] {
        let load = pull_off * (1.0 - x);
        let state = model.state_at_load(load).expect("a state");
        let there = model.state_at_gap(state.gap).expect("a state");
        assert!((there.load / load - 1.0).abs() < 1e-12, "x {x:e}: load {load:e}, at its separation {:e}", there.load);
    }
}

/// Contact of the highest summits alone was summed beyond their height, or to the few digits that theta has of its
/// distance from pi/2.
#[test]
fn the_tip_of_the_highest_summit_carries_the_lightest_loads() {
    let (height, density) = ([-2.0, -1.0, 1.0, 2.0], [1e-3, 2.0, 2.0, 1e-3]);
    let params = Params { heights: table(&height, &density), ..surface(0.0954, 20.76, 0.0, 5.75, 1.0) };
    let model = Model::new(&params).expect("a model");
    let unit = params.composite_modulus * params.burgers_vector.powi(2) * params.asperity_count;
    // Where the density is even, load goes with the overlap to the power of 5/2, area to that of 2. Below the table the law goes on
    // with the power of its lightest load, where the density is not yet even.
    for power in (-250..=-45).step_by(5) {
        let friction = |power: i32| model.friction_force_at_load(10f64.powi(power) * unit);
        let ratio = friction(power) / friction(power - 5);
        assert!((ratio * 1e-4 - 1.0).abs() < 0.06, "from 1e{power} of the units: {ratio:e}");
    }
    let lightest = model.friction_force_at_load(f64::from_bits(1));
    assert!((0.0..1e-200).contains(&lightest), "{lightest:e}");
}

/// The panel at the tip had none of its ends where contact radii pass one of the slip law's.
#[test]
fn the_slope_at_the_tip_is_that_of_a_secant() {
    let height: Vec<f64> = (-4..=4).map(|i| 0.5 * f64::from(i)).collect();
    let density = vec![1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 9.0, 10.0, 11.0];
    let mut params = surface(1.8608628e-3, 1.1696864e6, 0.0, 0.0617684, 1.0);
    params.heights = table(&height, &density);
    let model = Model::new(&params).expect("a model");
    let middle = model.state_at_load(1e-8 * model.summary().max_table_load).expect("a state");
    let mut kinks = 0;
    // Through loads at which the highest contact has the first radius, and the second.
    for decade in -300..0 {
        let load = middle.load * 10.0_f64.powf(0.1 * f64::from(decade));
        let at = |part: f64| model.state_at_load(load * part).expect("a state");
        let (below, here, above) = (at(1.0 - 1e-5), at(1.0), at(1.0 + 1e-5));
        let secant = (above.friction_force - below.friction_force) / (above.load - below.load);
        assert!((secant / here.dforce_dload - 1.0).abs() < 1e-6, "{load:e}: {secant:e}, not {:e}", here.dforce_dload);
        kinks += usize::from(here.fraction_below_slip_radius_1 > 0.0 && here.fraction_below_slip_radius_1 < 1.0);
    }
    assert!(kinks > 10, "the contacts are of one regime at all but {kinks} loads");
}

/// The slope underflowed on the far side of the bracket, and the search ended where the load was still positive.
#[test]
fn a_pull_off_load_that_is_no_number_is_none() {
    let params = Params { attraction: true, ..surface(2.34e-2, 3.159e5, 1.4726e-4, 0.08055, 128.0) };
    let model = Model::new(&params).expect("a model");
    assert_eq!(model.summary().pull_off_load, 0.0);
    let state = model.state_at_gap(4.0 * params.height_std).expect("a state");
    let exact = model.state_at_load(state.load).expect("a state");
    assert!((exact.friction_force / state.friction_force - 1.0).abs() < 1e-11, "{exact:?}, {state:?}");
}

/// Where radii vanish slowly below, to its last digits, it took 100 s.
#[test]
fn a_model_whose_radii_vanish_slowly_is_made_in_time() {
    let params = Params {
        composite_modulus: 55138.43262183106,
        effective_shear_modulus: 38596.90283528174,
        work_of_adhesion: 4.234924302839713,
        adhesion_range: 0.5837335342803278,
        burgers_vector: 0.07564568844106759,
        height_std: 61.823409756505534,
        summit_radius: 31570600.084798086,
        asperity_count: 4671255193.968686,
        radius_amplitude: 1.0,
        radius_rate: 0.05634686409069578,
        ..Params::paper()
    };
    let start = processor_time();
    let model = Model::new(&params).expect("a model");
    let took = processor_time() - start;
    assert!(took < LONGEST_CALL || cfg!(debug_assertions), "{took:?}, {:?}", model.summary());
}

/// A panel of the branch, three times as long as the one before, was as long as all that was left but for a rounding: the next
/// one had nowhere to go.
#[test]
fn a_panel_that_reaches_pull_off_but_for_a_rounding_ends_there() {
    let groups = [2.329096594957861e-3, 13.638469154519356, 4.6276934687543594e-7, 6.857850478831809e-2];
    let heights = johnson(0.04912994274799331, 2.9070851720296362);
    let model = Model::new(&varying(groups, heights, [0.0, 0.5])).expect("a model");
    assert!(model.summary().pull_off_load < 0.0, "{:?}", model.summary());
}

/// The surfaces part where the lowest summits of a table, which are many, break away at once: the kink that this is lay four
/// last bits before pull-off, and a panel ended there.
#[test]
fn a_kink_that_is_pull_off_but_for_a_rounding_is_pull_off() {
    let height = [-1.4093479261729662, 0.4951633956355579, 1.100103384727512, 2.2195404273845534, 2.8828799061916413];
    let above = [3.743406098657912, 4.131820410609361, 4.920442278118893, 5.274598585586237, 5.751908373880217];
    let density = [1.291737295659562, 0.04486363317469843, 1.1174710905852423, 1.64098619502017, 0.08188832716777573];
    let densities_above =
        [2.5786260480154564, 1.0802024468880105, 0.0330638326119372, 2.3702676917735004, 0.35769355011204895];
    let heights = table(
        &[&height[..], &above, &[5.9960727995793315]].concat(),
        &[&density[..], &densities_above, &[2.5862327845063233]].concat(),
    );
    let groups = [2.5141467600485447e-2, 11.744221120720635, 8.515889855282423e-3, 0.19602471573611835];
    let radii = [0.1855468754656613, 2.99951323003386e-2];
    let params = Params { attraction: false, ..varying(groups, heights, radii) };
    let model = Model::new(&params).expect("a model");
    assert!(model.summary().pull_off_load < 0.0, "{:?}", model.summary());
}

/// Next to a fold the radius of contacts is so steep that the height where it passes one of the slip law's is that of its
/// neighbours, too: panels were cut there without end, for tens of seconds.
#[test]
fn sums_do_not_stop_where_contact_radii_are_steep() {
    let groups = [8.381849222214722e-4, 5152715.137756967, 2.1029807018159652e-4, 0.12704386771093445];
    let radii = [-4.882807843387127e-4, 1.8110672237718294e-2];
    let others = [1.6125735486823817e-4, 4489745.052009353, 3.579252348691782e-5, 0.23586978144945048];
    for params in [
        varying(groups, HeightFamily::Weibull { shape: 13.725755182418508 }, radii),
        varying(groups, johnson(0.30102992992860056, 3.152413671326139), radii),
        varying(others, HeightFamily::Gaussian, [0.8989257817156613, 2.8797221476349354e-2]),
    ] {
        let start = processor_time();
        let model = Model::new(&params).expect("a model");
        let took = processor_time() - start;
        assert!(took < LONGEST_CALL || cfg!(debug_assertions), "{took:?}");
        assert!(
            model.summary().pull_off_load > -1e-100 && model.summary().pull_off_load <= 0.0,
            "{:?}",
            model.summary()
        );
    }
}

/// The search for a light load stepped beyond a pull-off load that is no number, and took that for its end.
#[test]
fn light_loads_are_found_above_a_pull_off_load_that_is_none() {
    let params = dimensionless(0.05752103079734467, 38213.283425671885, 0.07542541357579806, 0.3962289);
    let model = Model::new(&params).expect("a model");
    assert_eq!(model.summary().pull_off_load, 0.0);
    let mut last = 0.0;
    for power in -60..-10 {
        let load = 10f64.powi(power) * model.summary().max_table_load;
        let force = model.state_at_load(load).expect("a state").friction_force;
        assert!(force > last && (last == 0.0 || force < 11.0 * last), "{force:e} after {last:e} at {load:e}");
        last = force;
    }
}

/// What is left of the heights may be the last bit of one: there is nothing to cut there.
#[test]
fn the_last_bit_of_the_heights_is_no_panel_to_cut() {
    let groups = [9.222395660932716e-4, 48152.316878953374, 6.0884284861439574e-5, 1.550888465802803];
    let heights = johnson(2.07757989367654, 7.987927220128025);
    let params = varying(groups, heights, [0.3710937504656613, 6.222219292529092]);
    let model = Model::new(&params).expect("a model");
    let end = model.state_at_load(model.summary().pull_off_load).expect("a state").gap;
    for i in 0..=80 {
        let separation = end - 0.1 * f64::from(i) * params.height_std;
        model.state_at_gap(separation).expect("a state");
    }
}

/// Panels that were cut next to where the contact radius passes one of the slip law's were cut there again, and again.
#[test]
fn sums_do_not_stop_where_contact_radii_pass_the_slip_law() {
    let [first, second] = [
        [3.7180266679e-4, 2.92952275558e6, 6.15880606360e-6, 1.33984238048],
        [4.91367299119e-3, 1.79838558711e6, 2.38206235570e-4, 0.277654520261],
    ];
    for params in [
        varying(first, johnson(-0.197878277, 3.051877402), [-0.42968750, 0.507081919]),
        varying(second, johnson(-0.166818896, 2.362414729), [-0.05859375, 0.642121465]),
    ] {
        let model = Model::new(&params).expect("a model");
        let end = model.state_at_load(model.summary().pull_off_load).expect("a state").gap;
        let load = |steps: i32| {
            let separation = end - 0.01 * f64::from(steps) * params.height_std;
            model.state_at_gap(separation).expect("a state").load
        };
        let mut last = load(0);
        for steps in 1..1200 {
            let here = load(steps);
            assert!(here > last, "{params:?}: {here:e} at {steps} steps, {last:e} at one less");
            last = here;
        }
    }
}

/// Sums were unscaled by a factor of three digits.
#[test]
fn friction_at_the_end_of_all_numbers_does_not_fall() {
    let params = Params {
        composite_modulus: 2430756892940.45,
        effective_shear_modulus: 1701529825058.315,
        work_of_adhesion: 31.253805342421167,
        adhesion_range: 1.2697523183565441e-5,
        burgers_vector: 4.971325136588763e-6,
        height_std: 0.0008173334855205138,
        summit_radius: 0.007384683883457926,
        asperity_count: 6039992188543.237,
        heights: HeightFamily::Johnson { skew: 0.445556640625, kurtosis: 10.133930086050366 },
        ..Params::paper()
    };
    let model = Model::new(&params).expect("a model");
    let force = |load: f64| model.friction_force_at_load(load);
    for i in 0..200 {
        let load = 3.3277767761854135e-289 * (1.0 + 0.01 * f64::from(i));
        let (lighter, heavier) = (force(load), force(load * 1.000_001));
        assert!(heavier >= lighter * (1.0 - 1e-11), "{load:e}: {lighter:e}, then {heavier:e}");
    }
}

/// Within some last bits of the pull-off load the sign of dP/d(separation) is rounding.
#[test]
fn friction_rises_with_load_in_the_last_bits_of_the_pull_off_load() {
    let params = Params {
        composite_modulus: 1162841650019272.3,
        effective_shear_modulus: 813989155013490.5,
        work_of_adhesion: 15869970.544740817,
        adhesion_range: 1.0179551593663152e-6,
        burgers_vector: 1.3772818589253834e-5,
        height_std: 0.0014381573212396688,
        summit_radius: 0.0020458913603796734,
        asperity_count: 208815716.928012,
        heights: HeightFamily::Weibull { shape: 78.11981937629545 },
        ..Params::paper()
    };
    for params in [params, Params::paper()] {
        let model = Model::new(&params).expect("a model");
        let mut load = model.summary().pull_off_load;
        for _ in 0..40 {
            load = load.above();
            let (state, (_, slope)) =
                (model.state_at_load(load).expect("a state"), model.friction_force_and_slope(load));
            assert!(slope > 0.0 && slope.is_finite(), "{slope:e}");
            // Of so large a slope few digits are known; of a surface that hardly adheres the table ends far above.
            let reaches = model.summary().min_table_load < 0.0;
            assert!(!reaches || (slope / state.dforce_dload - 1.0).abs() < 1e-3, "{slope:e}, {state:?}");
            assert!(state.dload_dgap <= 0.0, "{state:?}");
        }
    }
}

/// Adhesion of silicon on glass at a roughness of 20 nm pulls with 6e-305 units per summit, of which rounding gives the sign: a
/// positive one was refused as that of heights with a second maximum.
#[test]
fn a_pull_off_load_too_small_for_a_number_is_none_whatever_its_sign() {
    let mut params = Params {
        work_of_adhesion: 0.1,
        adhesion_range: 0.384e-9,
        burgers_vector: 0.384e-9,
        height_std: 20e-9,
        summit_radius: 1e-6,
        asperity_count: 1e5,
        ..Params::paper()
    };
    params.set_materials(160e9, 0.22, 72e9, 0.17).expect("materials");
    for part in [0.99, 0.995, 1.0, 1.005, 1.01] {
        let model = Model::new(&Params { height_std: part * params.height_std, ..params.clone() }).expect("a model");
        assert_eq!(model.summary().pull_off_load, 0.0, "{part}");
    }
}

/// Overlaps were taken as differences of numbers as large as the reach of attraction, here 1e5 times the roughness: too few
/// digits for the load to be told from that at pull-off.
#[test]
fn adhesion_may_reach_far_beyond_the_roughness() {
    for work_of_adhesion in [3e-7, 1e-6, 1.1e-6, 2e-6] {
        let params = Params {
            composite_modulus: 1.0,
            effective_shear_modulus: 1.0,
            work_of_adhesion,
            adhesion_range: 1.0,
            burgers_vector: 0.1,
            height_std: 1e-5,
            summit_radius: 1e4,
            asperity_count: 1.0,
            ..Params::paper()
        };
        let model = Model::new(&params).expect("a model");
        let pull_off = model.summary().pull_off_load;
        // Bradley: all summits within reach pull with 2 pi w R.
        let bradley = -2.0 * std::f64::consts::PI * work_of_adhesion * params.summit_radius;
        assert!((pull_off / bradley - 1.0).abs() < 1e-3, "{pull_off}, not {bradley}");
        for part in [1e-3, 1e-6, 1e-9, 1e-11] {
            let load = pull_off * (1.0 - part);
            let (force, exact) = (model.friction_force_at_load(load), model.state_at_load(load).expect("a state"));
            // Nearer to pull-off than the table reaches the law goes on as the root of the distance.
            let tolerance = if part < 1e-9 { 1e-4 } else { 1e-6 };
            assert!((force / exact.friction_force - 1.0).abs() < tolerance, "{part}: {force}, not {exact:?}");
        }
    }
}

/// Radii vanish towards an end of the heights at which summits gather: the load falls up to where the last contact ends, and the point
/// that was found lay beyond it by rounding.
#[test]
fn surfaces_that_part_with_their_last_contact_have_friction_until_then() {
    let height: Vec<f64> = (-4..=4).map(|i| 0.5 * f64::from(i)).collect();
    let density = [1e-9, 2e-9, 3e-9, 4e-9, 6e-9, 8e-9, 9e-9, 1e-8, 1.1e-8];
    let params = Params {
        composite_modulus: 31352.790025487546,
        effective_shear_modulus: 21946.953017841282,
        work_of_adhesion: 34.425466303937576,
        adhesion_range: 1.974448970508348e-4,
        burgers_vector: 3.542802347940057e-3,
        height_std: 648.4468570965734,
        summit_radius: 11319.252529521586,
        heights: table(&height, &density),
        radius_amplitude: -1.0,
        radius_rate: 71.70931294931086,
        ..Params::paper()
    };
    let model = Model::new(&params).expect("a model");
    let summary = model.summary();
    assert!(summary.pull_off_load < 0.0 && summary.pull_off_friction_force > 0.0, "{summary:?}");
    assert!(summary.table_error < 1e-6, "{summary:?}");
}
