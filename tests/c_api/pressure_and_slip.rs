//! Friction by pressure, and with a smooth sign of the slip rate: from friction by load, value and slope.

use crate::interface::*;
use std::ptr::null_mut;

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
