//! Contacts of several pairs in one call: the bits of one call a contact, and what is said of those that have no answer.

use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ptr::{null, null_mut};

const SEED: u64 = 0x9a125;

fn handles(count: usize) -> Vec<Handle> {
    let params = |i: usize| asperity_params::dimensionless(0.01, 1000.0, 1e-3 * (i % 5) as f64, 1.0);
    (0..count).map(|i| Handle::new(&params(i))).collect()
}

fn of(handles: &[Handle]) -> Vec<*const asperity_model> {
    handles.iter().map(|handle| handle.0.cast_const()).collect()
}

/// Few models, as many as are sorted by, and more; also loads and indices that are refused.
#[test]
fn an_element_has_the_bits_of_the_call_for_its_model() {
    let mut random = SplitMix(SEED);
    for (count, n) in [(1, 100), (3, 0), (3, 1), (5, 1024), (16, 3000), (64, 2000), (65, 300)] {
        let handles = handles(count);
        let models = of(&handles);
        for invalid in [0.0, 0.05] {
            let which: Vec<u32> = (0..n)
                .map(|_| if random.chance(invalid) { random.bits() as u32 } else { random.below(count) as u32 })
                .collect();
            let loads: Vec<f64> = (0..n)
                .map(|_| if random.chance(invalid) { random.any_float() } else { random.log_between(1e-30, 1e9) })
                .collect();
            let expected: Vec<(f64, f64)> = (0..n)
                .map(|i| {
                    let mut slope = f64::NAN;
                    let model = models.get(which[i] as usize).copied().unwrap_or(null());
                    // SAFETY: a model or NULL.
                    let force = unsafe { asperity_friction_force_and_slope_at_load(model, loads[i], &mut slope) };
                    (force, if model.is_null() { f64::NAN } else { slope })
                })
                .collect();
            let same = |force: &[f64], slope: &[f64]| {
                for i in 0..n {
                    let is_same = |a: f64, b: f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
                    let (f, s) = expected[i];
                    assert!(is_same(force[i], f), "{count}, {i}: {} at {:e}, not {f}", force[i], loads[i]);
                    assert!(is_same(slope[i], s), "{count}, {i}: {} at {:e}, not {s}", slope[i], loads[i]);
                }
            };
            let (mut force, mut slope) = (vec![0.0; n], vec![0.0; n]);
            let (indices, load) = (which.as_ptr(), loads.as_ptr());
            let (forces, slopes) = (force.as_mut_ptr(), slope.as_mut_ptr());
            let call = |load, force, slope| {
                // SAFETY: arrays of n elements.
                unsafe { asperity_friction_force_at_loads_of(models.as_ptr(), count, n, indices, load, force, slope) }
            };
            let status = call(load, forces, slopes);
            same(&force, &slope);
            if invalid == 0.0 {
                assert_eq!(status, OK, "{}", message());
            }
            let mut place = loads.clone();
            assert_eq!(call(place.as_ptr(), place.as_mut_ptr(), slopes), status);
            same(&place, &slope);
            assert_eq!(call(load, forces, null_mut()), status);
            same(&force, &slope);
            place.clone_from(&loads);
            assert_eq!(call(place.as_ptr(), null_mut(), place.as_mut_ptr()), status);
            same(&force, &place);
        }
    }
}

#[test]
fn the_first_contact_that_is_not_in_order_is_named() {
    let handles = handles(3);
    let models = of(&handles);
    let (n, at) = (2000, 1500);
    // With slopes contacts are sorted by model, without they are not.
    let mut slopes = vec![7.0; n];
    let mut call = |which: &[u32], load: &[f64], with_slopes: bool| {
        let mut force = vec![7.0; n];
        let slopes = if with_slopes { slopes.as_mut_ptr() } else { null_mut() };
        // SAFETY: arrays of n elements.
        let status = unsafe {
            let (models, which, load) = (models.as_ptr(), which.as_ptr(), load.as_ptr());
            asperity_friction_force_at_loads_of(models, 3, n, which, load, force.as_mut_ptr(), slopes)
        };
        (status, force, message())
    };
    let which: Vec<u32> = (0..n as u32).map(|i| i % 3).collect();
    let loads = vec![1.0; n];
    for (index, load, status, says) in [
        (3, 1.0, INVALID_PARAMETER, "element 1500: which = 3: must be below models_length = 3"),
        (u32::MAX, 1.0, INVALID_PARAMETER, "which = 4294967295"),
        (1, f64::NAN, INVALID_LOAD, "element 1500: load = NaN"),
        (0, -1.0, SEPARATED, "element 1500: load = -1: below the pull-off load"),
        (2, 1e300, OUT_OF_RANGE, "element 1500: load = 1e300"),
    ] {
        let (mut which, mut loads) = (which.clone(), loads.clone());
        // Later ones of other models are not what is reported.
        (which[at], loads[at], which[1700], loads[1600]) = (index, load, 5, f64::NAN);
        for with_slopes in [false, true] {
            let (found, force, message) = call(&which, &loads, with_slopes);
            assert!(found == status && message.contains(says), "{found}: {message}");
            assert!(force[at].is_nan() != (status == SEPARATED) && force[1600].is_nan() && force[1700].is_nan());
            assert!(force[1999] > 0.0);
        }
    }
}

#[test]
fn nothing_is_written_where_a_model_is_null() {
    let handles = handles(2);
    let mut models = of(&handles);
    let mut force = [7.0; 2];
    let (forces, out) = (force.as_mut_ptr(), null_mut());
    let (which, load) = ([0_u32, 1], [1.0, 2.0]);
    models[1] = null();
    // SAFETY: arrays of two elements, or NULL.
    unsafe {
        let (w, p) = (which.as_ptr(), load.as_ptr());
        assert_eq!(asperity_friction_force_at_loads_of(models.as_ptr(), 2, 2, w, p, forces, out), NULL_POINTER);
        assert_eq!(message(), "models[1] is NULL: pass a valid pointer");
        assert_eq!(force, [7.0; 2]);
        // No models at all: no contact has one.
        assert_eq!(asperity_friction_force_at_loads_of(null(), 0, 2, w, p, forces, out), INVALID_PARAMETER);
        assert!(message().contains("element 0: which = 0: must be below models_length = 0"), "{}", message());
        assert!(force.iter().all(|force| force.is_nan()));
    }
}
