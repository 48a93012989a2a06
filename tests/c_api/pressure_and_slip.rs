//! Friction by pressure, and with a smooth sign of the slip rate: from friction by load, value and slope.

use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ptr::{null, null_mut};

/// Value and slope of a call that takes a place for the slope.
fn both(call: impl FnOnce(*mut f64) -> f64) -> (f64, f64) {
    let mut slope = 7.0;
    let value = call(&mut slope);
    (value, slope)
}

fn is_near(value: f64, expected: f64) -> bool {
    (value - expected).abs() <= 1e-14 * expected.abs()
}

#[test]
fn pressure_is_load_over_the_area_of_all_summits() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    // Powers of two, so that load and pressure are the same to the last bit.
    for area in [0.125, 1.0, 64.0] {
        for load in [-1e-3, 0.0, 1.0, 1e3] {
            // SAFETY: the model lives.
            unsafe {
                let (mu, mu_slope) = both(|slope| asperity_friction_and_slope_at_load(model, load, slope));
                let (force, slope) = both(|slope| asperity_friction_force_and_slope_at_load(model, load, slope));
                let by_pressure = both(|slope| asperity_friction_at_pressure(model, load / area, area, slope));
                assert_eq!(by_pressure, (mu, mu_slope * area), "mu at {load} on {area}");
                let stress = both(|slope| asperity_shear_stress_at_pressure(model, load / area, area, slope));
                assert_eq!(stress, (force / area, slope), "stress at {load} on {area}");
                assert_eq!(asperity_friction_at_pressure(model, load / area, area, null_mut()), mu);
            }
        }
    }
}

#[test]
fn pressures_and_areas_out_of_range_give_nan() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    let allowed = [(1e-59, 1e-60), (1e-61, 1e60), (1.0, 1.0), (-1e119, 1e-10), (1e119, 1e-60)];
    let refused = [(1.0, 0.9e-60), (1.0, 1.1e60), (1.0, 0.0), (1.0, -1.0), (1.1e120, 1e-10), (-1.1e120, 1.0)];
    // SAFETY: the model lives.
    unsafe {
        for (pressure, area) in allowed {
            let value = both(|slope| asperity_shear_stress_at_pressure(model, pressure, area, slope));
            assert!(!value.0.is_nan() && !value.1.is_nan(), "{pressure:e} on {area:e}: {value:?}");
        }
        for (pressure, area) in refused {
            let stress = both(|slope| asperity_shear_stress_at_pressure(model, pressure, area, slope));
            let mu = both(|slope| asperity_friction_at_pressure(model, pressure, area, slope));
            assert!(stress.0.is_nan() && stress.1.is_nan(), "{pressure:e} on {area:e}: {stress:?}");
            assert!(mu.0.is_nan() && mu.1.is_nan(), "{pressure:e} on {area:e}: {mu:?}");
        }
    }
}

#[test]
fn slip_force_is_friction_force_times_a_smooth_sign() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    for load in [0.0, 1.0, 1e3] {
        for (rate, transition) in [(0.5, 1.0), (-0.5, 1.0), (3e-4, 1e-3), (-2.0, 0.5), (0.0, 1.0), (50.0, 1.0)] {
            let (mut by_load, mut by_rate) = (7.0, 7.0);
            // SAFETY: the model lives.
            let (force, slope, slip) = unsafe {
                let (force, slope) = both(|slope| asperity_friction_force_and_slope_at_load(model, load, slope));
                (force, slope, asperity_slip_force(model, load, rate, transition, &mut by_load, &mut by_rate))
            };
            let sign = (rate / transition).tanh();
            let sign_rate = (rate / transition).cosh().powi(-2) / transition;
            assert!(is_near(slip, force * sign), "{load} {rate} {transition}: {slip}");
            assert!(is_near(by_load, slope * sign), "{load} {rate} {transition}: {by_load}");
            assert!((by_rate - force * sign_rate).abs() <= 1e-14 * force / transition, "{rate}: {by_rate}");
        }
        for (rate, transition) in [(f64::NAN, 1.0), (f64::INFINITY, 1.0), (1.0, 0.0), (1.0, -1.0), (1.0, 1.1e60)] {
            let (mut by_load, mut by_rate) = (7.0, 7.0);
            // SAFETY: the model lives.
            let slip = unsafe { asperity_slip_force(model, load, rate, transition, &mut by_load, &mut by_rate) };
            assert!(slip.is_nan() && by_load.is_nan() && by_rate.is_nan(), "{rate} {transition}: {slip}");
        }
    }
}

/// Pressures, or loads, of every kind.
fn mixed(count: usize) -> Vec<f64> {
    let mut random = SplitMix(0x9e55);
    let corners =
        [f64::NAN, f64::INFINITY, f64::from_bits(0xfff4 << 48), 0.0, -0.0, 1e130, 1e90, -1e3, f64::from_bits(1)];
    let one = |random: &mut SplitMix| match random.below(9) {
        0 => corners[random.below(corners.len())],
        1 => -random.log_between(1e-9, 1e3),
        _ => random.log_between(1e-20, 1e8),
    };
    (0..count).map(|_| one(&mut random)).collect()
}

fn assert_same(found: &[f64], expected: &[f64], what: &str) {
    for (i, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert_eq!(found.to_bits(), expected.to_bits(), "{what}, element {i}: {found}, not {expected}");
    }
}

#[test]
fn batches_by_pressure_have_the_bits_of_the_calls_for_one() {
    type Batch = unsafe extern "C" fn(*const asperity_model, usize, *const f64, f64, *mut f64, *mut f64) -> i32;
    type Scalar = unsafe extern "C" fn(*const asperity_model, f64, f64, *mut f64) -> f64;
    let calls: [(Batch, Scalar); 2] = [
        (asperity_friction_at_pressures, asperity_friction_at_pressure),
        (asperity_shear_stresses_at_pressures, asperity_shear_stress_at_pressure),
    ];
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    for (batch, scalar) in calls {
        for (n, area) in
            [(0, 1.0), (1, 0.3), (5, 7.0), (128, 1e-3), (500, 0.3), (500, 1e58), (10, f64::NAN), (10, 1e70)]
        {
            let pressure = mixed(n);
            // SAFETY: arrays of n elements, in place too.
            unsafe {
                let one = pressure.iter().map(|&pressure| both(|slope| scalar(model, pressure, area, slope)));
                let (values, slopes): (Vec<f64>, Vec<f64>) = one.unzip();
                let (mut value, mut slope) = (vec![7.0; n], vec![7.0; n]);
                let status = batch(model, n, pressure.as_ptr(), area, value.as_mut_ptr(), slope.as_mut_ptr());
                assert_same(&value, &values, "value");
                assert_same(&slope, &slopes, "slope");
                let mut place = pressure.clone();
                assert_eq!(batch(model, n, place.as_ptr(), area, null_mut(), place.as_mut_ptr()), status);
                assert_same(&place, &slopes, "in place");
                place.clone_from(&pressure);
                assert_eq!(batch(model, n, place.as_ptr(), area, place.as_mut_ptr(), null_mut()), status);
                assert_same(&place, &values, "in place");
            }
        }
    }
}

#[test]
fn a_batch_of_slip_forces_has_the_bits_of_the_calls_for_one() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    for (n, transition) in [(0, 1.0), (1, 0.5), (7, 0.5), (128, 2.0), (700, 1e-3), (10, f64::NAN), (10, 0.0)] {
        let load = mixed(n);
        let rate: Vec<f64> = mixed(n).into_iter().rev().map(|rate| if rate > 1e3 { 0.0 } else { rate }).collect();
        let mut expected = [vec![0.0; n], vec![0.0; n], vec![0.0; n]];
        let mut found = [vec![7.0; n], vec![7.0; n], vec![7.0; n]];
        // SAFETY: arrays of n elements, in place too.
        unsafe {
            for i in 0..n {
                let (mut by_load, mut by_rate) = (7.0, 7.0);
                expected[0][i] = asperity_slip_force(model, load[i], rate[i], transition, &mut by_load, &mut by_rate);
                (expected[1][i], expected[2][i]) = (by_load, by_rate);
            }
            let [force, by_load, by_rate] = found.each_mut().map(|array| array.as_mut_ptr());
            let (p, v) = (load.as_ptr(), rate.as_ptr());
            let status = asperity_slip_forces(model, n, p, v, transition, force, by_load, by_rate);
            for (found, expected) in found.iter().zip(&expected) {
                assert_same(found, expected, "apart");
            }
            let (mut load, mut rate) = (load.clone(), rate.clone());
            let (p, v) = (load.as_mut_ptr(), rate.as_mut_ptr());
            assert_eq!(asperity_slip_forces(model, n, p, v, transition, v, null_mut(), p), status);
            assert_same(&rate, &expected[0], "in place of the slip rate");
            assert_same(&load, &expected[2], "in place of the load");
        }
    }
}

#[test]
fn inputs_that_are_null_are_refused_and_outputs_are_skipped() {
    let handle = Handle::new(&asperity_params::initial());
    let (model, one, none, no) = (handle.0, &1.0, null(), null_mut());
    let mut out = 7.0;
    // SAFETY: arrays of one element or of none.
    unsafe {
        for (n, status) in [(0, OK), (1, NULL_POINTER)] {
            assert_eq!(asperity_friction_at_pressures(model, n, none, 1.0, &mut out, no), status);
            assert_eq!(asperity_shear_stresses_at_pressures(model, n, none, 1.0, &mut out, no), status);
            assert_eq!(asperity_slip_forces(model, n, none, one, 1.0, &mut out, no, no), status);
            assert_eq!(asperity_slip_forces(model, n, one, none, 1.0, &mut out, no, no), status);
            assert_eq!(out, 7.0);
        }
        assert_eq!(asperity_slip_forces(model, 1, one, one, 1.0, no, no, no), OK);
    }
}

#[test]
fn the_first_element_of_a_batch_that_is_not_in_order_is_named() {
    let handle = Handle::new(&asperity_params::initial());
    let model = handle.0;
    let n = 300;
    let at = 200;
    let by_pressure = |pressure: f64, area: f64| {
        let mut pressures = vec![1.0; n];
        (pressures[at], pressures[at + 5]) = (pressure, f64::NAN);
        // SAFETY: arrays of n elements.
        unsafe { asperity_friction_at_pressures(model, n, pressures.as_ptr(), area, null_mut(), null_mut()) }
    };
    for (pressure, area, status, says) in [
        (f64::INFINITY, 1.0, INVALID_LOAD, "element 200: pressure = inf: must be finite"),
        (1e130, 1.0, OUT_OF_RANGE, "element 200: pressure = 1e130: must be within 1e120 of zero"),
        (-1.0, 1.0, SEPARATED, "element 200: load = -1: below the pull-off load"),
        (1.0, -1.0, INVALID_PARAMETER, "nominal_area = -1: must be from 1e-60 to 1e60"),
    ] {
        assert_eq!(by_pressure(pressure, area), status, "{}", message());
        assert!(message().contains(says), "{}", message());
    }
    let slipping = |load: f64, rate: f64, transition: f64| {
        let (mut loads, mut rates) = (vec![1.0; n], vec![1.0; n]);
        (loads[at], rates[at], loads[at + 5]) = (load, rate, f64::NAN);
        let (p, v) = (loads.as_ptr(), rates.as_ptr());
        // SAFETY: arrays of n elements.
        unsafe { asperity_slip_forces(model, n, p, v, transition, null_mut(), null_mut(), null_mut()) }
    };
    for (load, rate, transition, status, says) in [
        (f64::NAN, 1.0, 1.0, INVALID_LOAD, "element 200: load = NaN"),
        (f64::NAN, f64::NAN, 1.0, INVALID_PARAMETER, "element 200: slip_rate = NaN: must be finite"),
        (-1.0, 1.0, 1.0, SEPARATED, "element 200: load = -1"),
        (1.0, 1.0, 0.0, INVALID_PARAMETER, "transition_rate = 0: must be from 1e-60 to 1e60"),
    ] {
        assert_eq!(slipping(load, rate, transition), status, "{}", message());
        assert!(message().contains(says), "{}", message());
    }
}
