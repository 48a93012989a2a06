//! Pull-off points and states of given loads, on surfaces with one minimum of the load and with two.

use super::*;
use crate::numerics::quadrature::integrate_short;
use crate::params::{HeightFamily, Params};
use crate::population::tests::{of, surface, table, FOLD, HERTZ, WEAK};

fn surfaces() -> Vec<Params> {
    vec![
        surface(WEAK, HeightFamily::Gaussian, [0.0, 1.0]),
        surface(FOLD, HeightFamily::Weibull { shape: 2.2 }, [0.0, 1.0]),
        surface(FOLD, HeightFamily::Gaussian, [0.6, 0.8]),
        // The lower summits part first, then the taller ones.
        surface(FOLD, table(), [0.0, 1.0]),
        surface(WEAK, table(), [0.3, 1.0]),
    ]
}

#[test]
fn the_branch_ends_at_the_first_minimum_of_the_load() {
    for params in surfaces() {
        let branch = Branch::new(of(&params)).expect("a branch");
        let end = branch.farthest();
        let load = |separation: f64| branch.population().at_separation(separation).load();
        let point = branch.pull_off().expect("a pull-off point");
        assert_eq!((point.separation, point.load), (end, load(end)), "{params:?}");
        assert!(load(end - 1e-3) > point.load && load(end + 1e-3) > point.load, "{params:?}: {point:?}");
        let before: Vec<f64> = (0..800).map(|i| load(end - 0.01 * f64::from(i))).collect();
        assert!(before.windows(2).all(|pair| pair[1] > pair[0]), "{params:?}: the load has a minimum before {end}");
    }
}

#[test]
fn a_load_has_its_separation_from_any_guess_and_from_none() {
    for params in surfaces() {
        let branch = Branch::new(of(&params)).expect("a branch");
        for above in [-9.0, -2.0, 3.0] {
            let target = log(-branch.pull_off_load()) + above;
            for guess in [None, Some(branch.farthest() + 1.0), Some(branch.farthest() - 0.1), Some(-30.0)] {
                let (separation, sums) = branch.at_log_excess(target, guess).expect("a state");
                let load = branch.pull_off_load() * (1.0 - above.exp());
                let off = (sums.load() - load).abs() / (sums.load() - branch.pull_off_load());
                assert!(off < 1e-7 && separation <= branch.farthest(), "{params:?}, {above}, {guess:?}: {off:e}");
            }
        }
    }
}

/// Where the load is a difference, where it is integrated from its slope, and where one follows the other.
#[test]
fn the_load_above_pull_off_changes_as_its_slope_says_however_near() {
    for params in surfaces() {
        let branch = Branch::new(of(&params)).expect("a branch");
        let end = branch.farthest();
        let (mut integrated, mut compared) = (0, 0);
        for halvings in 0..20 {
            let distance = 0.5_f64.powi(halvings);
            let (from, to) = (end - 1.2 * distance, end - distance);
            integrated +=
                usize::from(branch.fall.as_ref().is_some_and(|fall| fall.from(branch.population(), from).is_some()));
            // Next to a kink the slope is a root.
            if branch.kinks().iter().any(|&kink| kink > from - distance && kink < end) {
                continue;
            }
            let [above, below] = [from, to].map(|d| branch.log_excess(d).log_excess);
            let change = integrate_short(from, to, |d| branch.log_excess(d).rate);
            let off = (below - above - change).abs();
            compared += 1;
            assert!(off < 1e-9, "{params:?}, {distance:e} from pull-off: {off:e}");
        }
        assert!((8..=14).contains(&integrated) && compared > 15, "{params:?}: {integrated} of {compared}");
    }
}

/// Of summits that do not adhere, down to loads that are no numbers.
#[test]
fn without_adhesion_the_lightest_contacts_are_alike() {
    let branch = Branch::new(of(&surface(HERTZ, HeightFamily::Gaussian, [0.0, 1.0]))).expect("a branch");
    for target in [-690.0_f64, -600.0, -30.0, 0.0] {
        let (separation, sums) = branch.at_log_excess(target, None).expect("a state");
        let off = log(sums.load()) - target;
        assert!(off.abs() < 1e-11 * (1.0 + target.abs()), "{target}: {off:e}");
        assert_eq!(sums.friction, branch.population().at_separation(separation).friction);
    }
    let (farthest, lightest) = branch.at_log_excess(-690.0, None).expect("a state");
    let (separation, sums) = branch.at_log_excess(-700.0, None).expect("a state");
    assert_eq!(separation, farthest);
    let factor = exp(-10.0);
    for (of, of_lightest) in [
        (sums.load_contacting, lightest.load_contacting),
        (sums.friction, lightest.friction),
        (sums.hertz_load, lightest.hertz_load),
        (sums.area, lightest.area),
        (sums.radius, lightest.radius),
        (sums.contacting, lightest.contacting),
        (sums.load_slope, lightest.load_slope),
        (sums.friction_slope, lightest.friction_slope),
        (sums.radius_slope, lightest.radius_slope),
    ] {
        assert!((of / (factor * of_lightest) - 1.0).abs() < 1e-12, "{of:e} and {of_lightest:e}");
    }
}

#[test]
fn a_branch_that_is_told_where_the_load_rises_ends_at_the_minimum_before() {
    for params in surfaces() {
        let branch = Branch::new(of(&params)).expect("a branch");
        let (end, point) = (branch.farthest(), branch.pull_off().expect("a pull-off point"));
        for past in [1e-7, 1e-3, 0.02] {
            let told = branch.clone().ending_near(end + past).expect("a branch");
            let off = (told.farthest() - end).abs();
            let found = told.pull_off().expect("a pull-off point");
            assert!(off < 1e-7 && found.load <= point.load * (1.0 - 1e-12), "{params:?}, {past}: {off:e}");
            // Also one that was thought to end elsewhere.
            let elsewhere = End { farthest: end + 1.0, pull_off: None };
            let mended = Branch { end: elsewhere, ..branch.clone() }.ending_near(end + past).expect("a branch");
            assert_eq!(mended.farthest(), told.farthest());
        }
    }
}

/// A place at which the load falls still, or falls again, says that the minimum is near and not on which side.
#[test]
fn a_branch_that_is_told_of_a_place_just_before_the_minimum_ends_there_too() {
    let branch = Branch::new(of(&surface(WEAK, HeightFamily::Gaussian, [0.0, 1.0]))).expect("a branch");
    let told = branch.clone().ending_near(branch.farthest() - 1e-4).expect("a branch");
    assert!((told.farthest() - branch.farthest()).abs() < 1e-7);
    // Without adhesion there is none.
    let hertz = Branch::new(of(&surface(HERTZ, HeightFamily::Gaussian, [0.0, 1.0]))).expect("a branch");
    assert!(matches!(hertz.ending_near(0.0), Err(Error::NotConverged { .. })));
}

/// Where heights end the load may fall up to the last contact, and there is no pull-off without adhesion; where summits adhere
/// so strongly that all of them part at once, it is next to where the highest does.
#[test]
fn the_branch_of_heights_that_end_ends_with_the_last_contact_or_before() {
    let triangle = HeightFamily::Tabulated { height: [-1.0, 0.0, 1.0].into(), density: [0.0, 1.0, 0.0].into() };
    let uniform = HeightFamily::Tabulated { height: [-1.0, 0.0, 1.0].into(), density: [1.0, 1.0, 1.0].into() };
    for heights in [triangle, uniform, HeightFamily::Weibull { shape: 20.0 }] {
        for (groups, adheres) in [(HERTZ, false), (WEAK, true), (FOLD, true)] {
            let branch = Branch::new(of(&surface(groups, heights.clone(), [0.0, 1.0]))).expect("a branch");
            assert_eq!(branch.pull_off().is_some(), adheres, "{heights:?}");
            let (end, last) = (branch.farthest(), branch.population().farthest());
            assert!(end <= last && (adheres || end == last), "{heights:?}: {end}, {last}");
            if adheres {
                let load = |separation: f64| branch.population().at_separation(separation).load();
                let least = (0..2000).map(|i| load(last - 2e-3 * f64::from(i))).fold(f64::MAX, f64::min);
                let pull_off = branch.pull_off_load();
                assert!(pull_off <= least * (1.0 - 1e-12), "{heights:?}: {pull_off:e}, {least:e}");
            }
        }
    }
}

/// Down to an adhesion of which the pull-off load is no number.
#[test]
fn pull_off_is_found_however_weakly_surfaces_adhere() {
    for heights in [HeightFamily::Gaussian, HeightFamily::Weibull { shape: 3.6 }, HeightFamily::Weibull { shape: 1.0 }]
    {
        let (mut found, mut none) = (0, 0);
        for half_decade in 0..17 {
            // Ever rougher too.
            let gamma = 0.1 * 10_f64.powf(-0.5 * f64::from(half_decade));
            let alpha = 0.01 * 10_f64.powf(0.1 * f64::from(half_decade));
            let branch = Branch::new(of(&surface([alpha, 1000.0, gamma, 1.0], heights.clone(), [0.0, 1.0])));
            let branch = branch.expect("a branch");
            let load = |separation: f64| branch.population().at_separation(separation).load();
            match branch.pull_off() {
                Some(point) => {
                    found += 1;
                    let (end, least) = (point.separation, point.load);
                    assert!(least < 0.0 && log(-least) > -641.0, "{heights:?}, {gamma:e}: {least:e}");
                    // The load falls up to there, and rises beyond.
                    let before: Vec<f64> = (1..60).map(|i| load(end - 0.4 * f64::from(i))).collect();
                    assert!(
                        before[0] > least && before.windows(2).all(|pair| pair[1] > pair[0]),
                        "{heights:?}, {gamma:e}"
                    );
                    assert!(load(end - 1e-3) > least && load(end + 1e-3) > least, "{heights:?}, {gamma:e}");
                }
                None => {
                    none += 1;
                    // Nowhere does it pull by what is a number.
                    let pulls = (0..200).map(|i| load(0.2 * f64::from(i))).any(|load| load < -1e-277);
                    assert!(!pulls, "{heights:?}, {gamma:e}");
                }
            }
        }
        assert!(found > 0 && none > 0 && found + none == 17, "{heights:?}: {found} of 17");
    }
}
