//! Surfaces as users have them, in any units, and at the corners of what is evaluated: each is refused with a reason or answers.

use crate::common::splitmix::SplitMix;
use crate::fuzz_calls::{calls::Calls, Tally};
use crate::interface::*;
use std::ptr::null_mut;

const SEED: u64 = 0x5eed_c0de;

/// An engineering surface in a random system of units, one of whose numbers may be far off.
fn random_real(random: &mut SplitMix) -> asperity_params {
    let mut params = asperity_params::initial();
    let modulus = random.log_between(1e6, 1e12);
    let sigma = random.log_between(1e-10, 1e-5);
    let quantities = [
        modulus,
        modulus * random.between(0.2, 1.0),
        if random.chance(0.1) { 0.0 } else { random.log_between(1e-4, 3.0) },
        random.log_between(1e-10, 3e-9),
        random.log_between(1e-10, 1e-9),
        sigma,
        sigma * random.log_between(1e2, 1e7),
        random.log_between(1.0, 1e15),
    ];
    let (length, force) = (random.log_between(1e-6, 1e6), random.log_between(1e-6, 1e6));
    let stress = force / (length * length);
    let units = [stress, stress, force / length, length, length, length, length, 1.0];
    for (i, quantity) in params.quantities().into_iter().enumerate() {
        *quantity = quantities[i] * units[i];
    }
    if random.chance(0.3) {
        *params.quantities()[random.below(8)] *= random.log_between(1e-6, 1e6);
    }
    params.attraction = random.below(2) as i32;
    if random.chance(0.4) {
        params = params.weibull(random.log_between(0.2, 1e7));
    } else if random.chance(0.4) {
        params = {
            // Not so skewed that heights end hundreds of sigma up: a separation from the mean has too few digits there.
            let skew = random.between(-1.2, 1.2);
            params.johnson(skew, skew * skew + random.log_between(1.05, 10.0))
        };
    }
    if random.chance(0.3) {
        params = params.radii(random.between(-1.0, 1.0), random.log_between(1e-3, 1e3));
    }
    params
}

/// A corner of what the model can be evaluated for: about half of all numbers at an end of their range.
fn random_corner(random: &mut SplitMix) -> asperity_params {
    let mut end = |from: f64, to: f64| match random.below(4) {
        0 => from * (1.0 + 1e-9),
        1 => to * (1.0 - 1e-9),
        _ => random.log_between(from, to),
    };
    let alpha = end(1e-5, 10.0);
    let beta = end(0.1, 1e8);
    let gamma = end(1e-9, 10.0);
    let b_over_h = end(1e-3, 100.0);
    let shape = end(0.3, 300.0);
    let rate = end(1e-3, 1e3);
    let mut params =
        asperity_params::dimensionless(alpha, beta, if random.chance(0.1) { 0.0 } else { gamma }, b_over_h);
    if random.chance(0.6) {
        params = params.weibull(shape);
    }
    if random.chance(0.5) {
        let amplitude = [-1.0, 1.0, random.between(-1.0, 1.0)][random.below(3)];
        params = params.radii(amplitude, rate);
    }
    params.attraction = i32::from(!random.chance(0.2));
    params
}

/// Every surface that is made answers from pull-off to beyond the heaviest load of its table.
fn check_surfaces(seed: u64, count: usize, draw: fn(&mut SplitMix) -> asperity_params) {
    let mut random = SplitMix(seed);
    let mut tally = Tally::default();
    let mut created = 0;
    for _ in 0..count {
        let params = draw(&mut random);
        let mut calls = Calls::new(&mut tally);
        let Some(model) = calls.create(&params) else { continue };
        created += 1;
        let (pull_off, heavy) =
            (model.summary.pull_off_load, model.summary.max_table_load.max(-model.summary.pull_off_load));
        let mut loads = vec![1e-6 * heavy, 1e-3 * heavy, 0.3 * heavy, 3.0 * heavy];
        if pull_off < 0.0 {
            loads.extend([1.0, 0.999, 0.5, 0.0, -1.0, -100.0].map(|part| part * pull_off));
        }
        for load in loads {
            calls.exact(&model, load);
            calls.round_trip(&model, load);
        }
        for _ in 0..2 {
            let any = random.any_float();
            calls.exact(&model, any);
            calls.separation(&model, any);
            calls.at_load(&model, any);
        }
    }
    assert!(tally.too_slow.is_empty(), "seed {seed:#x}: {:?}", tally.too_slow);
    assert_eq!(tally.refused.get(&INVALID_PARAMETER), None, "seed {seed:#x}");
    assert!(3 * created >= count, "only {created} of {count} are created");
}

#[test]
fn realistic_surfaces_in_any_units_are_refused_or_work() {
    check_surfaces(SEED ^ 5, 60, random_real);
}

#[test]
fn degenerate_surfaces_are_refused_or_work() {
    check_surfaces(SEED ^ 6, 60, random_corner);
}

#[test]
fn no_adhesion_has_no_sign() {
    let none = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
    let mut negative = asperity_params::dimensionless(0.01, 1000.0, -0.0, 1.0);
    assert!(negative.work_of_adhesion.is_sign_negative() && negative.work_of_adhesion == 0.0);
    let (none, signed) = (Handle::new(&none), Handle::new(&negative));
    for load in [0.0, 1e-3, 1.0, 1e3] {
        // SAFETY: both models live.
        let forces = unsafe { [none.0, signed.0].map(|model| asperity_friction_force_at_load(model, load)) };
        assert_eq!(forces[0].to_bits(), forces[1].to_bits(), "at {load}");
    }
    negative.work_of_adhesion = -1e-300;
    // SAFETY: the parameters live.
    assert_eq!(unsafe { asperity_create(&negative, &mut null_mut()) }, INVALID_PARAMETER, "{}", message());
}

/// No adhesion, so that there is no pull-off load to be found among hundreds of kinks.
#[test]
fn tables_are_read_from_the_fewest_heights_to_the_most() {
    let height: Vec<f64> = (0..257).map(f64::from).collect();
    let density = vec![1.0; height.len()];
    for (length, expected) in [(2, INVALID_PARAMETER), (3, OK), (256, OK), (257, OUT_OF_RANGE)] {
        let mut params = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
        params.height_distribution = ASPERITY_HEIGHTS_TABULATED;
        (params.table_height, params.table_density) = (height.as_ptr(), density.as_ptr());
        params.table_length = length;
        let mut model = null_mut();
        // SAFETY: the table has so many heights.
        assert_eq!(unsafe { asperity_create(&params, &mut model) }, expected, "{length}: {}", message());
        assert_eq!(expected == OK, !model.is_null());
        // SAFETY: a model, or NULL.
        unsafe { asperity_free(model) };
    }
}
