//! Where a formula ends: among the heights, so that a sum has to find the place, against the second evaluation state by
//! state; and next to pull-off, where loads differ by less than they are known to.

use crate::common::second_evaluation::heights::{Heights, Table};
use crate::common::second_evaluation::Surface;
use crate::common::surfaces::params_of;
use asperity::asperity::contact::ContactLaw;
use asperity::asperity::groups::Groups;
use asperity::asperity::maugis::Maugis;
use asperity::asperity::slip::{Slip, SlipOnset};
use asperity::distribution::tabulated::Tabulated;
use asperity::distribution::weibull::Weibull;
use asperity::distribution::HeightDistribution;
use asperity::population::radius::RadiusProfile;
use asperity::population::Population;
use asperity::{Error, HeightFamily, Model, Params};
use std::sync::Arc;

/// Compares states at separations, in sigma; returns the attraction loads relative to all loads.
fn agree(surface: &Surface, separations: &[f64]) -> Vec<f64> {
    let params = params_of(surface);
    let model = Model::new(&params).unwrap_or_else(|error| panic!("{surface:?}: {error}"));
    let compare = |&separation: &f64| {
        let state = model.state_at_gap(separation * params.height_std).expect("a state");
        let exact = surface.at_separation(separation);
        assert!(exact.converged, "{surface:?} at {separation}");
        let scale = exact.log_scale.exp();
        let loads = scale * exact.load_absolute;
        let near = |what: &str, value: f64, expected: f64, of: f64| {
            let error = (value - expected).abs() / of;
            assert!(error <= 1e-9, "{what} of {surface:?} at {separation}: {value}, not {expected}: {error:e}");
        };
        near("load", state.load, exact.load(), loads);
        near("attraction", state.attraction_load, scale * exact.load_attracted, loads);
        near("attracted", state.attracted, scale * exact.attracted, scale * exact.attracted.max(exact.contacting));
        near("contacting", state.contacting, scale * exact.contacting, scale * exact.contacting);
        near("friction", state.friction_force, scale * exact.friction, scale * exact.friction);
        near("area", state.real_area, scale * exact.area, scale * exact.area);
        state.attraction_load / loads
    };
    separations.iter().map(compare).collect()
}

#[test]
fn attraction_ends_where_summits_are_too_round_for_it() {
    // lambda^3 g passes 9/32 next to the mean height, on the way up or down.
    for (epsilon, separations) in
        [(0.5, [-1.0, 0.0, 0.04, 0.08, 0.12, 1.0]), (-0.5, [1.0, 0.14, 0.1, 0.08, 0.04, -1.0])]
    {
        let surface = Surface::new([0.01, 1000.0, 1.398e-3, 1.0], Heights::Gaussian, [epsilon, 1.0]);
        let shares = agree(&surface, &separations);
        assert!(shares[0] < -1e-6 && shares[2] < 0.0 && shares[5] == 0.0, "{shares:?}");
    }
}

/// Where the lower end of a power law attracts: a panel of its own.
#[test]
fn the_lower_end_of_weibull_heights_attracts() {
    for (shape, epsilon) in [(1.3, 0.0), (1.3, 0.6), (2.2, -0.6)] {
        let surface = Surface::new([0.01, 1000.0, 1e-3, 0.03], Heights::weibull(shape), [epsilon, 0.7]);
        let shares = agree(&surface, &[-1.2, 0.0, 1.0, 2.0, 2.3]);
        assert!(shares.iter().all(|&share| share < -1e-9), "{shares:?}");
    }
}

/// Where radii vary much within adhesion's range, break-away is nearer in height than in overlap.
#[test]
fn contacts_of_small_summits_next_to_break_away_are_summed_well() {
    let surface = Surface::new(
        [5.301090698879846e-4, 39.65771044724285, 4.490305961462481e-2, 5.188126247013423e-2],
        Heights::Gaussian,
        [0.9938964848406613, 1.537979986789622],
    );
    agree(&surface, &[100.0, 122.0, 209.0, 230.0, 253.9]);
}

/// Within one panel the contact radius passes one of the slip law's, turns back below it and passes it again.
#[test]
fn friction_of_contacts_whose_radius_turns_twice_is_summed_well() {
    let surface = Surface::new(
        [2.879722146863008e-4, 127.6761034470962, 6.260717080148791e-7, 5.710840547041712e-2],
        Heights::weibull(2.3229816161803893),
        [-0.6434326167218387, 20.844920576974864],
    );
    let separations: Vec<f64> = (-20..=20).map(|i| -0.0391 + 0.004 * f64::from(i)).collect();
    agree(&surface, &separations);
}

/// Panels in the parameter of the law of contact, which the height follows: they reached too far where radii fall and then are
/// level, and had too few points where dz/ds changes.
#[test]
fn contacts_whose_radii_fall_with_height_are_summed_well() {
    let table = Table::new(
        vec![0.8895449647088878, 2.773862606380649, 3.1757086378524355, 4.09115422933819, 4.356416397143227],
        vec![0.0, 0.12988249738358382, 0.5576502740440499, 0.04875718654561095, 0.0],
    );
    for (groups, heights, radii, separations) in [
        (
            [2.0305663643510564e-3, 9.36344249608463e4, 2.0507051057689425e-2, 5.229843984166102],
            Heights::Gaussian,
            [-0.9716796870343387, 1.2570867098020932],
            [1.297304, 1.297308, 1.3, 1.4],
        ),
        (
            [0.5376117480320232, 137.92672947357585, 0.28888200323380414, 3.3573944009554624],
            Heights::Table(table),
            [-0.8320312495343387, 0.6278437322850412],
            [-2.6609, -2.6608, -2.6607, -2.66],
        ),
        (
            [0.00901733336306659, 6574.6266312902135, 0.0035518591066308705, 16.15402636252125],
            Heights::weibull(38.73599554004636),
            [-0.2597656245343387, 0.3326386097175347],
            [-3.5925, -3.5921, -3.5919, -3.5],
        ),
    ] {
        agree(&Surface::new(groups, heights, radii), &separations);
    }
}

/// Some 2 % of the way before taller summits part first, and beyond.
#[test]
fn radii_so_steep_that_taller_summits_part_first_are_refused() {
    let surface = |rho: f64| Surface::new([0.002, 300.0, 0.001, 1.0], Heights::Gaussian, [-0.95, rho]);
    let (mut gentle, mut steep) = (0.1, 5.0);
    for _ in 0..40 {
        let middle = 0.5 * (gentle + steep);
        *(if surface(middle).least_break_away_rate() > 0.0 { &mut gentle } else { &mut steep }) = middle;
    }
    agree(&surface(0.97 * gentle), &[-1.0, 0.5, 1.0]);
    for rho in [gentle, 1.1 * gentle, 5.0, 50.0] {
        let error = Model::new(&params_of(&surface(rho))).expect_err("a refusal");
        assert!(matches!(error, Error::OutOfRange { name: "radius_rate", .. }), "{error}");
        let text = error.to_string();
        assert!(text.starts_with(&format!("radius_rate = {rho}: ")), "{text}");
        assert!(
            text.contains("taller summits would part before lower ones") && text.contains("use a smaller"),
            "{text}"
        );
    }
    // Without adhesion all part where they touch.
    agree(&Surface { gamma: 0.0, ..surface(50.0) }, &[-1.0, 0.5, 1.0]);
}

#[test]
fn separation_nears_that_of_pull_off_as_the_root_of_the_load() {
    for (params, name) in [
        (Params::paper(), "the default"),
        (Params { attraction: false, ..Params::paper() }, "without attraction"),
        (Params { heights: HeightFamily::Weibull { shape: 6.0 }, ..Params::paper() }, "Weibull"),
    ] {
        let model = Model::new(&params).expect("a model");
        let pull_off = model.summary().pull_off_load;
        let end = model.state_at_load(pull_off).expect("a state").gap;
        let quotient = |x: f64| {
            let load = pull_off * (1.0 - x);
            let state = model.state_at_load(load).expect("a state");
            // The difference of loads that are so near is exact.
            (end - state.gap) / ((load - pull_off) / -pull_off).sqrt()
        };
        let limit = quotient(1e-9);
        for x in [1e-14, 1e-13, 1e-12, 1e-11, 1e-10] {
            let error = quotient(x) / limit - 1.0;
            assert!(error.abs() < 1e-4, "{name}, {x:e}: {error:e}");
        }
    }
}

/// The separations at which summits of a height lose contact or attraction, and where they pass a regime of slip, by
/// bisection; in ascending order.
fn kinks_of_heights(groups: &Groups, radius: &RadiusProfile, attract: bool, heights: &[f64]) -> Vec<f64> {
    let (slip, maugis) = (Params::paper().slip, Maugis::new(groups));
    let mut kinks = Vec::new();
    for &z in heights {
        let g = radius.factor(z);
        let edge = maugis.break_away(g);
        kinks.push(z - edge.overlap);
        kinks.extend(attract.then(|| z + groups.reach()));
        for kink in [slip.radius_1, slip.radius_2].into_iter().filter(|&kink| kink > edge.radius) {
            let (mut lower, mut upper) = (edge.overlap, 1e6);
            for _ in 0..200 {
                let middle = 0.5 * (lower + upper);
                let contact = maugis.at_overlap(middle, g, maugis.guess(middle, g));
                *(if contact.radius < kink { &mut lower } else { &mut upper }) = middle;
            }
            kinks.push(z - lower);
        }
    }
    kinks.sort_by(f64::total_cmp);
    kinks
}

/// Also where the law is summed far below the heights, where kinks are more.
#[track_caller]
fn assert_has(found: &[f64], expected: &[f64]) {
    for expected in expected {
        let near = |found: &&f64| (*found - expected).abs() <= 1e-10 * (1.0 + expected.abs());
        assert!(found.iter().any(|found| near(&found)), "no {expected} in {found:?}");
    }
}

/// Where a knot of the density, or the lower end of a power law, passes the end of attraction, of contact, or of a regime of slip.
#[test]
fn the_kinks_of_the_sums_are_where_knots_pass_the_ends_of_laws() {
    let radius = RadiusProfile { amplitude: 0.4, rate: 0.7, origin: 0.0, scores: None };
    let table = Tabulated::new(&[-2.0, -1.0, 0.5, 1.0, 3.0], &[0.0, 1.0, 2.0, 1.0, 0.0]).expect("a density");
    let (table, weibull) = (Arc::new(table), Arc::new(Weibull::new(1.7).expect("a shape")));
    let slip = Params::paper().slip;
    // The second with a fold beyond the first regime.
    for (gamma, beta) in [(0.002, 2000.0), (0.02, 1e5)] {
        let groups = Groups {
            alpha: 0.02,
            beta,
            gamma,
            b_over_h: 0.5,
            hardness: f64::INFINITY,
            yields: false,
            nominal_area: 0.0,
        };
        for attract in [true, false] {
            let kinks = |heights: Arc<dyn HeightDistribution>| {
                Population::new(&groups, Slip::new(slip, 0.0, SlipOnset::Partial), heights, radius.clone(), attract)
                    .expect("a population")
                    .kinks()
            };
            assert_has(&kinks(table.clone()), &kinks_of_heights(&groups, &radius, attract, table.breakpoints()));
            let lower_end = weibull.outline().support.0;
            assert_has(&kinks(weibull.clone()), &kinks_of_heights(&groups, &radius, attract, &[lower_end]));
        }
    }
}
