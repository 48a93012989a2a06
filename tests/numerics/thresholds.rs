//! Where a formula ends: among the heights, so that a sum has to find the place, against the second evaluation state by
//! state; and next to pull-off, where loads differ by less than they are known to.

use crate::common::second_evaluation::heights::{Heights, Table};
use crate::common::second_evaluation::Surface;
use crate::common::surfaces::params_of;
use asperity::asperity::maugis::Maugis;
use asperity::groups::Groups;
use asperity::population::Population;
use asperity::surface::heights::johnson;
use asperity::surface::heights::tabulated::Tabulated;
use asperity::surface::heights::weibull::Weibull;
use asperity::surface::heights::Heights as Family;
use asperity::surface::radius::RadiusProfile;
use asperity::{Error, HeightFamily, Model, Params};

/// Compares states at separations, in sigma; returns the attraction loads relative to all loads.
fn agree(surface: &Surface, separations: &[f64]) -> Vec<f64> {
    let params = params_of(surface);
    let model = Model::new(&params).unwrap_or_else(|error| panic!("{surface:?}: {error}"));
    let compare = |&separation: &f64| {
        let state = model.state_at_separation(separation * params.height_std).expect("a state");
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
        let surface = Surface {
            alpha: 0.01,
            beta: 1000.0,
            gamma: 1.398e-3,
            b_over_h: 1.0,
            heights: Heights::Gaussian,
            epsilon,
            rho: 1.0,
            attraction: true,
            slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
        };
        let shares = agree(&surface, &separations);
        assert!(shares[0] < -1e-6 && shares[2] < 0.0 && shares[5] == 0.0, "{shares:?}");
    }
}

/// Where the foot of a power law attracts: a panel of its own.
#[test]
fn the_foot_of_weibull_heights_attracts() {
    for (shape, epsilon) in [(1.3, 0.0), (1.3, 0.6), (2.2, -0.6)] {
        let surface = Surface {
            alpha: 0.01,
            beta: 1000.0,
            gamma: 1e-3,
            b_over_h: 0.03,
            heights: Heights::weibull(shape),
            epsilon,
            rho: 0.7,
            attraction: true,
            slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
        };
        let shares = agree(&surface, &[-1.2, 0.0, 1.0, 2.0, 2.3]);
        assert!(shares.iter().all(|&share| share < -1e-9), "{shares:?}");
    }
}

/// Where summits gather at both ends of the heights, so that the density is nothing but spikes; and where radii that
/// fall with height let the tallest of them part first.
#[test]
fn sums_over_heights_that_gather_at_two_ends_are_those_of_a_second_evaluation() {
    for (gamma, delta) in [(0.0, 0.45), (0.25, 0.4), (-0.3, 0.45)] {
        for (epsilon, rho) in [(0.0, 1.0), (0.7, 1.0), (-0.95, 3.0)] {
            for (gamma_of_surface, b_over_h) in [(0.0, 1.0), (1e-3, 0.2), (4e-3, 1.0)] {
                let surface = Surface {
                    alpha: 0.01,
                    beta: 1000.0,
                    gamma: gamma_of_surface,
                    b_over_h,
                    heights: Heights::Johnson(Johnson::new(true, gamma, delta)),
                    epsilon,
                    rho,
                    attraction: true,
                    slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
                };
                agree(&surface, &[-1.5, -0.9, 0.0, 0.8]);
            }
        }
    }
}

/// Where radii vary much within a panel between the two ends, and overlaps are so large that heights are lost in them.
#[test]
fn summits_that_gather_and_differ_are_summed_well_under_heavy_load() {
    for (gamma_of_surface, attraction, epsilon, rho) in
        [(1.1e-2, false, -1.0, 26.868597), (7e-6, true, -1.0, 92.0), (3e-2, true, 0.8, 31.134829)]
    {
        let surface = Surface {
            alpha: 3.216060565e-4,
            beta: 1.24561173,
            gamma: gamma_of_surface,
            b_over_h: 0.445873,
            heights: Heights::Johnson(Johnson::new(true, 0.18, 0.3)),
            epsilon,
            rho,
            attraction,
            slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
        };
        agree(&surface, &[-2956616.3, -3e4, -300.0, -20.0]);
    }
}

/// The lightest loads without adhesion, of Hertz' contacts of the summits that gather next to the highest: theta told them
/// from none by few digits.
#[test]
fn the_lightest_loads_of_heights_that_gather_are_those_of_hertz() {
    for (gamma, delta) in [(-0.7, 0.2), (0.4, 0.3)] {
        let surface = Surface {
            alpha: 1.02749516e-4,
            beta: 39377.248,
            gamma: 0.0,
            b_over_h: 0.2,
            heights: Heights::Johnson(Johnson::new(true, gamma, delta)),
            epsilon: 0.0,
            rho: 1.0,
            attraction: true,
            slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
        };
        let normal = |u: f64| (-0.5 * u * u).exp() / std::f64::consts::TAU.sqrt();
        // The part of the heights between foot and head at which a summit is, over normal deviates.
        let moment = |power: i32| -> f64 {
            let part = |u: f64| 1.0 / (1.0 + ((gamma - u) / delta).exp());
            (-40_000..40_000).map(|i| 2.5e-4 * f64::from(i)).map(|u| 2.5e-4 * normal(u) * part(u).powi(power)).sum()
        };
        let width = 1.0 / (moment(2) - moment(1).powi(2)).sqrt();
        // The mean over all summits of (overlap/reach)^power, where the highest is `reach` above the flat: over ln(reach/below
        // head), in whose root it is smooth.
        let mean_power = |reach: f64, power: f64| -> f64 {
            let panels = (0..200).flat_map(|i| nodes(0.25 * f64::from(i), 0.25 * f64::from(i + 1)));
            let at = |root: f64| {
                let (t, below) = (root * root, reach / width * (-root * root).exp());
                let deviate = gamma + delta * ((1.0 - below) / below).ln();
                2.0 * root * normal(deviate) * delta / (1.0 - below) * (-(-t).exp_m1()).powf(power)
            };
            panels.map(|(root, weight)| weight * at(root)).sum()
        };
        let Surface { alpha, beta, .. } = surface;
        let model = Model::new(&params_of(&surface)).expect("a model");
        for power in [10, 15, 20, 30, 40] {
            let reach = 10f64.powi(-power);
            let load = 4.0 * alpha / (3.0 * beta) * (beta * reach.sqrt()).powi(3) * mean_power(reach, 1.5);
            let area = std::f64::consts::PI * beta * beta * reach * mean_power(reach, 1.0);
            let state = model.state_at_load(load).expect("a state");
            for (found, expected) in [(state.real_area, area), (state.contacting, mean_power(reach, 0.0))] {
                assert!((found / expected - 1.0).abs() < 1e-8, "{found:e}, not {expected:e}, at 1e-{power} sigma");
            }
            let strength = state.friction_force / area;
            assert!((strength * 43.0 - 1.0).abs() < 1e-8, "{strength} at 1e-{power} sigma");
        }
    }
}

/// Adhesion reaches over the heights, and the tall half of the summits, which is small, has broken away: contact ends twice.
#[test]
fn contact_that_ends_below_the_tall_summits_is_summed_between_its_ends() {
    let surface = Surface {
        alpha: 0.01,
        beta: 100.0,
        gamma: 0.0934,
        b_over_h: 0.1,
        heights: Heights::Johnson(Johnson::new(true, 0.1, 0.45)),
        epsilon: -0.95,
        rho: 8.0,
        attraction: true,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    };
    agree(&surface, &[1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0]);
}

/// Where radii vary much within adhesion's range, break-away is nearer in height than in overlap.
#[test]
fn contacts_of_small_summits_next_to_break_away_are_summed_well() {
    let surface = Surface {
        alpha: 5.301090698879846e-4,
        beta: 39.65771044724285,
        gamma: 4.490305961462481e-2,
        b_over_h: 5.188126247013423e-2,
        heights: Heights::Gaussian,
        epsilon: 0.9938964848406613,
        rho: 1.537979986789622,
        attraction: true,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    };
    agree(&surface, &[100.0, 122.0, 209.0, 230.0, 253.9]);
}

/// Within one panel the contact radius passes one of the slip law's, turns back below it and passes it again.
#[test]
fn friction_of_contacts_whose_radius_turns_twice_is_summed_well() {
    let surface = Surface {
        alpha: 2.879722146863008e-4,
        beta: 127.6761034470962,
        gamma: 6.260717080148791e-7,
        b_over_h: 5.710840547041712e-2,
        heights: Heights::weibull(2.3229816161803893),
        epsilon: -0.6434326167218387,
        rho: 20.844920576974864,
        attraction: true,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    };
    let separations: Vec<f64> = (-20..=20).map(|i| -0.0391 + 0.004 * f64::from(i)).collect();
    agree(&surface, &separations);
}

/// Between two separations contact parts in the middle of the heights, where radii fall steeply: at the one between, summits
/// there are next to break-away.
#[test]
fn contact_that_is_about_to_part_in_the_middle_is_summed_well() {
    let height = [-5.70889, -5.48528, -3.92065, -3.60677, -3.12969, -2.528, -2.07314, -1.6976, -1.35966, -0.946668];
    let density = [0.0, 0.0322383, 0.443135, 0.0802576, 0.303263, 0.220843, 0.168308, 0.0316203, 0.12996, 0.279431];
    let table = Table::new(
        [&height[..], &[-0.05313, 0.718513, 1.34679]].concat(),
        [&density[..], &[0.0555068, 1.91315, 0.0]].concat(),
    );
    let surface = Surface {
        alpha: 1.0135831344208548e-3,
        beta: 24280.29209569567,
        gamma: 4.458584988914299e-3,
        b_over_h: 4.132477487047875,
        heights: Heights::Table(table),
        epsilon: -0.6230468745343387,
        rho: 90.88581255470717,
        attraction: true,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    };
    let params = params_of(&surface);
    let model = Model::new(&params).expect("a model");
    let parting = model.state_at_load(model.summary().pull_off_load).expect("a state").separation / params.height_std;
    agree(&surface, &[-1e-3, -1e-4, -1e-6, 0.0, 1e-6, 1e-4, 1e-3].map(|offset| parting + offset));
}

#[test]
fn a_first_minimum_that_the_search_steps_over_is_found_by_following_the_branch() {
    let surface = Surface {
        alpha: 0.06043,
        beta: 2167.38,
        gamma: 0.869433,
        b_over_h: 0.340755,
        heights: Heights::weibull(2.3909024),
        epsilon: -0.90625,
        rho: 10.554496,
        attraction: true,
        slip: [28.0, 1.0 / 43.0, 8e4, 1.0 / 1290.0],
    };
    let load = |separation: f64| surface.at_separation(separation).load();
    // Through three loads about the minimum: its height to some 1e-6.
    let [left, middle, right] = [-0.108, -0.105, -0.102].map(load);
    assert!(left > middle && right > middle, "{left:e}, {middle:e}, {right:e}");
    let minimum = middle - (right - left).powi(2) / (8.0 * (right + left - 2.0 * middle));
    let before = [-0.4, -0.3, -0.2, -0.12].map(load);
    assert!(before.windows(2).all(|pair| pair[1] < pair[0]) && before[3] > left, "{before:?}");
    match Model::new(&params_of(&surface)) {
        Err(Error::OutOfRange { name: "pull-off load", value, .. }) => {
            let value: f64 = value.to_string().parse().expect("a number");
            assert!((value / minimum - 1.0).abs() < 1e-5, "{value:e}, not {minimum:e}");
        }
        other => panic!("{:?}", other.map(|model| model.summary())),
    }
}

#[test]
fn separation_nears_that_of_pull_off_as_the_root_of_the_load() {
    for (params, name) in [
        (Params::default(), "the default"),
        (Params { attraction: false, ..Params::default() }, "without attraction"),
        (Params { heights: HeightFamily::Weibull { shape: 6.0 }, ..Params::default() }, "Weibull"),
    ] {
        let model = Model::new(&params).expect("a model");
        let pull_off = model.summary().pull_off_load;
        let end = model.state_at_load(pull_off).expect("a state").separation;
        let quotient = |x: f64| {
            let load = pull_off * (1.0 - x);
            let state = model.state_at_load(load).expect("a state");
            // The difference of loads that are so near is exact.
            (end - state.separation) / ((load - pull_off) / -pull_off).sqrt()
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
fn passings(groups: &Groups, radius: &RadiusProfile, attract: bool, heights: &[f64]) -> Vec<f64> {
    let (slip, maugis) = (Params::default().slip, Maugis::new(groups));
    let mut passings = Vec::new();
    for &z in heights {
        let g = radius.factor(z);
        let edge = maugis.break_away(g);
        passings.push(z - edge.overlap);
        passings.extend(attract.then(|| z + groups.reach()));
        for kink in [slip.radius_1, slip.radius_2].into_iter().filter(|&kink| kink > edge.radius) {
            let (mut lower, mut upper) = (edge.overlap, 1e6);
            for _ in 0..200 {
                let middle = 0.5 * (lower + upper);
                let contact = maugis.at_overlap(middle, g, maugis.guess(middle, g));
                *(if contact.radius < kink { &mut lower } else { &mut upper }) = middle;
            }
            passings.push(z - lower);
        }
    }
    passings.sort_by(f64::total_cmp);
    passings
}

#[track_caller]
fn assert_same(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len(), "{found:?}, not {expected:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-10 * (1.0 + expected.abs()), "{found}, not {expected}");
    }
}

/// Where a knot of the density, or the foot of a power law, passes the end of attraction, of contact, or of a regime of slip.
#[test]
fn the_kinks_of_the_sums_are_where_knots_pass_the_ends_of_laws() {
    let radius = RadiusProfile { amplitude: 0.4, rate: 0.7, origin: 0.0 };
    let table = Tabulated::new(&[-2.0, -1.0, 0.5, 1.0, 3.0], &[0.0, 1.0, 2.0, 1.0, 0.0]).expect("a density");
    let slip = Params::default().slip;
    // The second with a fold beyond the first regime.
    for (gamma, beta) in [(0.002, 2000.0), (0.02, 1e5)] {
        let groups = Groups { alpha: 0.02, beta, gamma, b_over_h: 0.5 };
        for attract in [true, false] {
            let of = |heights: Family| Population::new(&groups, slip, heights, radius, attract);
            let ending = of(Family::Tabulated(Box::new(table.clone())));
            assert_same(&ending.kinks(), &passings(&groups, &radius, attract, table.knots()));
            assert!(ending.passings_of_foot().is_empty() && of(Family::Gaussian).passings_of_foot().is_empty());
            let power = of(Family::Weibull(Box::new(Weibull::new(1.7))));
            assert_same(&power.passings_of_foot(), &passings(&groups, &radius, attract, &[power.heights().foot()]));
            assert!(power.kinks().is_empty());
        }
    }
}

/// Families of heights, with where they end.
fn families() -> Vec<(Family, f64, f64)> {
    let table = Tabulated::new(&[-2.0, -1.0, 0.5, 1.0, 3.0], &[0.0, 1.0, 2.0, 1.0, 0.0]).expect("a density");
    let (first, last) = table.support();
    let weibull = |shape: f64| {
        let weibull = Weibull::new(shape);
        let mean = weibull.mean();
        (Family::Weibull(Box::new(weibull)), -mean, f64::INFINITY)
    };
    let mut families = vec![
        (Family::Gaussian, f64::NEG_INFINITY, f64::INFINITY),
        weibull(1.5),
        weibull(6.0),
        (Family::Tabulated(Box::new(table)), first, last),
    ];
    // S_U; S_B with the mean as the origin and with its end; S_U that nearly ends.
    for (skew, kurtosis) in [(0.8, 6.0), (-0.9, 30.0), (0.5, 3.3), (-0.8, 3.2), (-1.2, 5.8)] {
        let heights = johnson::heights(skew, kurtosis);
        let Family::Johnson(curve) = &heights else { panic!("{heights:?}") };
        let (foot, head) = curve.support();
        families.push((heights, foot, head));
    }
    families
}

#[test]
fn densities_are_positive_between_the_ends_of_heights_and_peak_where_it_is_said() {
    for (heights, foot, head) in families() {
        assert_eq!((heights.foot(), heights.head()), (foot, head), "{heights:?}");
        let (far_foot, far_tail) = (heights.far_foot(), heights.far_tail());
        let [lowest, highest] = [far_foot, far_tail].map(|z| z + heights.origin());
        assert!(lowest < -0.9 && highest > 0.9, "{heights:?}: {lowest} to {highest}");
        // Curves of Johnson's system become too thin before they end.
        let is_thin = matches!(heights, Family::Johnson(_));
        assert!(is_thin || (far_foot == foot) == foot.is_finite(), "{heights:?}");
        assert!(is_thin || (far_tail == head) == head.is_finite(), "{heights:?}");
        for (end, far, outwards) in [(foot, far_foot, -1.0), (head, far_tail, 1.0)] {
            if end.is_finite() {
                assert_eq!(heights.log_density(end + 1e-9 * outwards), f64::NEG_INFINITY, "{heights:?}");
                assert!(heights.log_density(end - 1e-9 * outwards).is_finite(), "{heights:?}");
            }
            if (far - end).abs() > 1e-12 {
                let log_density = heights.log_density(far);
                assert!((-2100.0..-1900.0).contains(&log_density), "{heights:?}: {log_density}");
            }
        }
        for start in [-9.0, -3.0, -1.0, -0.1, 0.0, 0.2, 0.7, 1.5] {
            let start = f64::max(start, foot + 1e-3);
            if start >= head {
                continue;
            }
            let peak = heights.peak_above(start);
            let highest = (0..2000)
                .map(|i| heights.log_density(start + 0.005 * f64::from(i)))
                .fold(heights.log_density(peak), f64::max);
            assert!(peak >= start && highest - heights.log_density(peak) < 1.0, "{heights:?} above {start}: {peak}");
        }
    }
}

/// What is left out of a sum holds less than 1e-17 of it, and what is summed reaches little farther than that.
#[test]
fn sums_reach_as_far_as_heights_count() {
    for (heights, foot, head) in families() {
        for (lower, upper) in [(-20.0, 20.0), (1.0, 30.0), (4.0, 60.0), (-30.0, -0.5), (-0.5, 0.5)] {
            let (lower, upper) = (f64::max(lower, foot), f64::min(upper, head));
            if lower >= upper {
                continue;
            }
            let (first, last) = heights.worth_summing(lower, upper);
            assert!(first >= lower && last <= upper && first < last, "{heights:?} {lower} {upper}: {first} {last}");
            let width = (upper - lower) / 40_000.0;
            let (mut within, mut without) = (0.0, 0.0);
            for i in 0..40_000 {
                let z = lower + width * (f64::from(i) + 0.5);
                let density = heights.log_density(z).exp();
                *(if z > first && z < last { &mut within } else { &mut without }) += density;
            }
            assert!(without <= 1e-17 * within, "{heights:?} {lower} {upper}: {first} {last} leaves {without:e}");
            // A step inside either end lies what counts at the level of exp(-100).
            for (end, bound) in [(first, lower), (last, upper)] {
                let log_density = heights.log_density(end + 1e-6 * (first + last - 2.0 * end));
                let largest = heights.log_density(heights.peak_above(first).min(last));
                assert!(end == bound || log_density > largest - 150.0, "{heights:?} {lower} {upper}: {first} {last}");
            }
        }
    }
}

/// With heights that end, and with those that gather at two ends.
#[test]
fn contact_and_attraction_end_where_it_is_said() {
    let table = Tabulated::new(&[-2.0, -1.0, 0.5, 1.0, 3.0], &[0.0, 1.0, 2.0, 1.0, 0.5]).expect("a density");
    let radius = RadiusProfile { amplitude: 0.0, rate: 0.25, origin: 0.0 };
    let slip = Params::default().slip;
    for (gamma, b_over_h) in [(0.0, 1.0), (1e-3, 0.2), (0.05, 1.0)] {
        let groups = Groups { alpha: 0.02, beta: 2000.0, gamma, b_over_h };
        let maugis = Maugis::new(&groups);
        let holds = -maugis.break_away(1.0).overlap;
        for attract in [true, false] {
            let of = |heights: Family| Population::new(&groups, slip, heights, radius, attract);
            let ending = of(Family::Tabulated(Box::new(table.clone())));
            let attracts = attract && gamma > 0.0;
            let reach = if attracts { groups.reach() } else { 0.0 };
            assert_eq!(ending.is_adhesive(), gamma > 0.0);
            assert_eq!(ending.range_of_adhesion(), reach.max(holds));
            assert_eq!(ending.radius_scale(), 4.0);
            assert_eq!(ending.least_overlap(), maugis.least_overlap());
            assert!(!ending.has_single_minimum() && of(Family::Gaussian).has_single_minimum());
            // The last contact and the last attraction.
            let count = |separation: f64| {
                let sums = ending.at_separation(separation).unscaled();
                (sums.contacting > 0.0, sums.attracted > 0.0)
            };
            for (last, kind) in [(holds, 0), (reach, 1)].into_iter().filter(|&(_, kind)| kind == 0 || attracts) {
                let [before, after] = [last - 1e-6, last + 1e-6].map(|off| count(table.support().1 + off));
                let of_kind = |(contact, attraction): (bool, bool)| if kind == 0 { contact } else { attraction };
                // Where adhesion is strong, nothing out of contact attracts.
                let strong = kind == 1 && groups.lambda_cubed() >= 9.0 / 32.0;
                assert_eq!((of_kind(before), of_kind(after)), (!strong, false), "{kind} {gamma} {attract}");
            }
            let farthest = ending.farthest();
            assert!(farthest >= table.support().1 + reach.max(holds) && count(farthest + 1e-6) == (false, false));
            assert!(farthest <= table.support().1 + reach + holds + 1e-9);
            // A part of all summits parts at once at each.
            let gathered = of(johnson::heights(0.2, 1.05));
            let asperity::surface::heights::Heights::Ends(ends) = gathered.heights() else { panic!("{gathered:?}") };
            let partings = gathered.partings();
            let strong = groups.lambda_cubed() >= 9.0 / 32.0;
            assert_eq!(partings.len(), if attracts && !strong { 2 } else { 1 });
            assert!(ending.partings().is_empty());
            for (parting, kind) in partings.into_iter().zip([0, 1]) {
                // Panels of the law end by some last bits before.
                let kinks = gathered.kinks();
                for parting in [parting, parting + ends.width()] {
                    let before = kinks.iter().map(|kink| parting - kink).filter(|&before| before >= 0.0);
                    let nearest = before.fold(f64::INFINITY, f64::min) / (f64::EPSILON * parting.abs().max(2.0));
                    assert!((2.0..17.0).contains(&nearest), "{kind} {gamma}: {kinks:?}, {parting}");
                }
                let [before, after] = [-1e-9, 1e-9].map(|off| {
                    let sums = gathered.at_separation(parting + off).unscaled();
                    if kind == 0 {
                        sums.contacting
                    } else {
                        sums.attracted
                    }
                });
                assert!(before - after > 0.1, "{kind} {gamma}: {before} and {after}");
            }
        }
    }
}
