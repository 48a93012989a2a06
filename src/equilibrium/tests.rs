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
fn a_load_has_its_separation_from_any_guess_and_from_none() {
    for params in surfaces() {
        let branch = Branch::new(of(&params)).expect("a branch");
        for above in [-9.0, -2.0, 3.0] {
            let target = log(-branch.pull_off_load()) + above;
            for guess in [None, Some(branch.farthest() + 1.0), Some(branch.farthest() - 0.1), Some(-30.0)] {
                let (separation, sums) = branch.at_log_excess(target, guess, 0.0).expect("a state");
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
                usize::from(branch.fall.get().is_some_and(|fall| fall.from(branch.population(), from).is_some()));
            // Next to a kink the slope is a root.
            if branch.kinks().iter().any(|&kink| kink > from - distance && kink < end) {
                continue;
            }
            let [above, below] = [from, to].map(|d| branch.log_excess(d).log_excess);
            let change = integrate_short(from, to, |d| branch.log_excess(d).rate);
            let off = (below - above - change).abs();
            compared += 1;
            assert!(off < 2e-8, "{params:?}, {distance:e} from pull-off: {off:e}");
        }
        assert!((8..=14).contains(&integrated) && compared > 15, "{params:?}: {integrated} of {compared}");
    }
}

/// Summits that do not adhere, down to loads that are no numbers.
#[test]
fn without_adhesion_the_lightest_contacts_are_alike() {
    let branch = Branch::new(of(&surface(HERTZ, HeightFamily::Gaussian, [0.0, 1.0]))).expect("a branch");
    for target in [-690.0_f64, -600.0, -30.0, 0.0] {
        let (separation, sums) = branch.at_log_excess(target, None, 0.0).expect("a state");
        let off = log(sums.load()) - target;
        assert!(off.abs() < 1e-11 * (1.0 + target.abs()), "{target}: {off:e}");
        assert_eq!(sums.friction, branch.population().at_separation(separation).friction);
    }
    let (farthest, lightest) = branch.at_log_excess(-690.0, None, 0.0).expect("a state");
    let (separation, sums) = branch.at_log_excess(-700.0, None, 0.0).expect("a state");
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
