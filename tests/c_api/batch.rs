//! The batch calls give the bits of the scalar calls for surfaces of every kind, and raise no flag.
//!
//! Batches of fewer than four loads take the scalar path on every processor, longer ones that of its vectors.

use crate::common::neighbours::Neighbours;
use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ptr::null_mut;

const SEED: u64 = 0x5eed_ba7c;

type BatchCall = unsafe extern "C" fn(*const asperity_model, usize, *const f64, *mut f64, *mut f64) -> i32;
type ScalarCall = unsafe extern "C" fn(*const asperity_model, f64) -> f64;

/// The laws: batch and scalar.
const LAWS: [(&str, BatchCall, ScalarCall); 2] = [
    ("coefficient", asperity_friction_at_loads, asperity_friction_at_load),
    ("force", asperity_friction_force_at_loads, asperity_friction_force_at_load),
];

/// Models whose tables differ in kind: adhesion or none, rows left out, caps, units.
fn models() -> Vec<(&'static str, Handle)> {
    let paper = asperity_params::dimensionless(0.01, 1000.0, 0.001, 1.0);
    let mut small_units = paper;
    // SI at the size of atoms.
    let scales = [1e11, 1e11, 10.0, 1e-10, 1e-10, 1e-10, 1e-10, 1e6];
    for (quantity, scale) in small_units.quantities().into_iter().zip(scales) {
        *quantity *= scale;
    }
    vec![
        ("paper", Handle::new(&paper)),
        ("Hertz", Handle::new(&asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0))),
        ("Weibull of negative skew", Handle::new(&paper.weibull(40.0))),
        ("Weibull of positive skew", Handle::new(&paper.weibull(1.2))),
        ("radii that grow with height", Handle::new(&paper.radii(0.9, 2.0))),
        ("a low cap", Handle::new(&paper.cap(1.0))),
        ("no cap", Handle::new(&paper.cap(f64::INFINITY))),
        ("small units", Handle::new(&small_units)),
    ]
}

/// Loads of every kind the model knows: in the table, beyond its ends, around pull-off and zero, invalid.
fn mixed_loads(random: &mut SplitMix, summary: &asperity_summary, count: usize) -> Vec<f64> {
    let invalid = [
        f64::NAN,
        f64::from_bits(0x7ff0_0000_0000_0001),
        f64::from_bits(0xfff4_0000_0000_0000),
        f64::INFINITY,
        f64::NEG_INFINITY,
    ];
    let pull_off = summary.pull_off_load;
    let corners = [
        0.0,
        -0.0,
        f64::from_bits(1),
        -f64::from_bits(1),
        f64::MIN_POSITIVE,
        1e-200,
        pull_off,
        pull_off.above(),
        pull_off.below(),
        2.0 * pull_off - 1e-30,
        -f64::MAX,
        summary.min_table_load,
        summary.min_table_load.below(),
        summary.max_table_load,
        summary.max_table_load.below(),
        2.0 * summary.max_table_load,
        1e300,
    ];
    let nearest = summary.min_table_load - pull_off;
    let farthest = summary.max_table_load - pull_off;
    (0..count)
        .map(|_| match random.below(20) {
            0 => invalid[random.below(invalid.len())],
            1 | 2 => corners[random.below(corners.len())],
            _ => pull_off + random.log_between(nearest, farthest),
        })
        .collect()
}

/// What each load gives alone: value by the scalar call, value and slope by a batch of one.
fn alone(handle: &Handle, batch: BatchCall, scalar: ScalarCall, loads: &[f64]) -> Vec<(u64, u64)> {
    loads
        .iter()
        .map(|load| {
            let (mut value, mut slope) = (0.0_f64, 0.0_f64);
            // SAFETY: one element each.
            unsafe { batch(handle.0, 1, load, &mut value, &mut slope) };
            // SAFETY: the model lives.
            let called = unsafe { scalar(handle.0, *load) };
            assert_eq!(called.to_bits(), value.to_bits(), "load {load:e}: {called:e} by the scalar call, {value:e}");
            (value.to_bits(), slope.to_bits())
        })
        .collect()
}

/// Loads of these tests that no surface of theirs can be evaluated for.
const TOO_HEAVY: f64 = 1e299;

/// Status and index of the first invalid load, by the rule of the header.
fn first_invalid(loads: &[f64], pull_off: f64) -> Option<(i32, usize)> {
    loads.iter().enumerate().find_map(|(i, &load)| {
        let finite = load.to_bits() >> 52 & 0x7ff != 0x7ff;
        if !finite {
            Some((INVALID_LOAD, i))
        } else if load < pull_off {
            Some((SEPARATED, i))
        } else if load >= TOO_HEAVY {
            Some((OUT_OF_RANGE, i))
        } else {
            None
        }
    })
}

fn check_status(status: i32, loads: &[f64], pull_off: f64, context: &str) {
    match first_invalid(loads, pull_off) {
        None => assert_eq!(status, OK, "{context}: {}", message()),
        Some((expected, index)) => {
            assert_eq!(status, expected, "{context}");
            let message = message();
            let names_it = message.starts_with(&format!("element {index}:"));
            assert!(names_it, "{context}: the first invalid load is element {index}, the message: {message}");
        }
    }
}

fn assert_same(found: &[f64], expected: impl Iterator<Item = u64>, loads: &[f64], context: &str) {
    for (i, ((found, expected), load)) in found.iter().zip(expected).zip(loads).enumerate() {
        let value = f64::from_bits(expected);
        assert_eq!(
            found.to_bits(),
            expected,
            "{context}: element {i} of {}, load {load:e}: {found:e} in the batch, {value:e} alone",
            loads.len()
        );
    }
}

/// Runs a claim over every model and law, with its loads and what each gives alone.
fn for_every_law(count: usize, claim: impl Fn(&str, &Handle, BatchCall, f64, &[f64], &[(u64, u64)])) {
    let mut random = SplitMix(SEED);
    for (name, handle) in models() {
        let summary = handle.summary();
        for (quantity, batch, scalar) in LAWS {
            let loads = mixed_loads(&mut random, &summary, count);
            let expected = alone(&handle, batch, scalar, &loads);
            let context = format!("{quantity}, {name}, seed {SEED:#x}");
            claim(&context, &handle, batch, summary.pull_off_load, &loads, &expected);
        }
    }
}

#[test]
fn a_batch_of_any_size_gives_the_bits_of_single_calls() {
    for_every_law(400, |context, handle, batch, pull_off, loads, expected| {
        for n in 0..=40 {
            for start in [0, 1, 5, 40, 123, 200, 360] {
                let (loads, expected) = (&loads[start..start + n], &expected[start..start + n]);
                let (mut value, mut slope) = (vec![7.0; n + 1], vec![7.0; n + 1]);
                // SAFETY: n elements each.
                let status = unsafe { batch(handle.0, n, loads.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
                check_status(status, loads, pull_off, context);
                assert_same(&value[..n], expected.iter().map(|e| e.0), loads, context);
                assert_same(&slope[..n], expected.iter().map(|e| e.1), loads, context);
                assert_eq!((value[n], slope[n]), (7.0, 7.0), "{context}: wrote past {n} elements");
            }
        }
        let n = loads.len();
        let (mut value, mut slope) = (vec![7.0; n], vec![7.0; n]);
        // SAFETY: n elements each.
        let status = unsafe { batch(handle.0, n, loads.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
        check_status(status, loads, pull_off, context);
        assert_same(&value, expected.iter().map(|e| e.0), loads, context);
        assert_same(&slope, expected.iter().map(|e| e.1), loads, context);
    });
}

#[test]
fn the_vector_path_gives_the_bits_of_the_scalar_path() {
    // Valid loads only, many of them: those of the table, where no element falls back to the scalar call.
    let mut random = SplitMix(SEED ^ 2);
    for (name, handle) in models() {
        let summary = handle.summary();
        let nearest = summary.min_table_load - summary.pull_off_load;
        let farthest = summary.max_table_load - summary.pull_off_load;
        for _ in 0..100 {
            let loads: Vec<f64> =
                (0..64).map(|_| summary.pull_off_load + random.log_between(nearest, farthest)).collect();
            for (quantity, batch, _) in LAWS {
                let context = format!("{quantity}, {name}, seed {:#x}", SEED ^ 2);
                let (mut value, mut slope) = ([0.0; 64], [0.0; 64]);
                // SAFETY: 64 elements each.
                unsafe { batch(handle.0, 64, loads.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
                let mut expected = ([0.0_f64; 64], [0.0_f64; 64]);
                for (i, three) in loads.chunks(3).enumerate() {
                    let (value, slope) = (&mut expected.0[3 * i..], &mut expected.1[3 * i..]);
                    // SAFETY: as many elements as the chunk has.
                    unsafe { batch(handle.0, three.len(), three.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
                }
                assert_same(&value, expected.0.iter().map(|x| x.to_bits()), &loads, &context);
                assert_same(&slope, expected.1.iter().map(|x| x.to_bits()), &loads, &context);
            }
        }
    }
}

#[test]
fn a_load_that_is_not_a_number_gives_a_quiet_nan_and_one_below_pull_off_zero() {
    for (name, handle) in models() {
        let pull_off = handle.summary().pull_off_load;
        for (quantity, batch, scalar) in LAWS {
            for bits in [0x7ff8_0000_0000_0000_u64, 0x7ff0_0000_0000_0001, 0xfff0_0000_0000_0000, 0x7ff0_0000_0000_0000]
            {
                for n in [1, 16] {
                    let load = vec![f64::from_bits(bits); n];
                    let (mut value, mut slope) = (vec![0.0_f64; n], vec![0.0_f64; n]);
                    // SAFETY: n elements each.
                    unsafe { batch(handle.0, n, load.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
                    // SAFETY: the model lives.
                    value.push(unsafe { scalar(handle.0, load[0]) });
                    for x in value.iter().chain(&slope) {
                        let quiet = x.is_nan() && x.to_bits() >> 51 & 1 == 1;
                        assert!(quiet, "{quantity}, {name}: load {bits:#x} gives {:#x}", x.to_bits());
                    }
                }
            }
            for n in [1, 16] {
                let load = vec![pull_off.below(); n];
                let (mut value, mut slope) = (vec![1.0_f64; n], vec![1.0_f64; n]);
                // SAFETY: n elements each.
                let status = unsafe { batch(handle.0, n, load.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr()) };
                assert_eq!(status, SEPARATED, "{quantity}, {name}");
                assert_eq!(value, vec![0.0; n], "{quantity}, {name}");
                // Without adhesion the others have there the slope of the lightest load of the table.
                let has_slope = quantity != "coefficient" && pull_off == 0.0;
                assert!(slope.iter().all(|&slope| (slope > 0.0) == has_slope && slope.is_finite()), "{slope:?}");
            }
        }
    }
}

/// Runs a batch with and without slopes, and the scalar call, over loads; says which flags they raise.
fn flags_of(handle: &Handle, batch: BatchCall, scalar: ScalarCall, loads: &[f64]) -> Option<String> {
    let n = loads.len();
    let (mut value, mut slope) = (vec![0.0; n], vec![0.0; n]);
    let (value_at, slope_at) = (value.as_mut_ptr(), slope.as_mut_ptr());
    // SAFETY: n elements each, or NULL.
    unsafe {
        let with_slope = flags::watch(|| batch(handle.0, n, loads.as_ptr(), value_at, slope_at)).1;
        let without = flags::watch(|| batch(handle.0, n, loads.as_ptr(), value_at, null_mut())).1;
        let alone = loads.iter().find_map(|&load| flags::watch(|| scalar(handle.0, load)).1);
        with_slope.or(without).or(alone.map(|raised| format!("scalar call: {raised}")))
    }
}

#[test]
fn no_load_raises_a_floating_point_exception() {
    let mut random = SplitMix(SEED ^ 4);
    let models = models();
    let mut failures = Vec::new();
    for load in (0..60).map(|_| random.any_float()) {
        for (name, handle) in &models {
            for (quantity, batch, scalar) in std::hint::black_box(LAWS) {
                for n in [1, 8] {
                    if let Some(raised) = flags_of(handle, batch, scalar, &vec![load; n]) {
                        failures.push(format!(
                            "{quantity}, {name}: {n} times load {load:e} {:#x} {raised}",
                            load.to_bits()
                        ));
                    }
                }
            }
        }
    }
    let shown = failures.iter().take(8).map(String::as_str).collect::<Vec<_>>().join("\n");
    assert!(failures.is_empty(), "{} failures, seed {:#x}, the first:\n{shown}", failures.len(), SEED ^ 4);
}

#[test]
fn no_load_from_pull_off_to_beyond_the_table_raises_a_floating_point_exception() {
    let mut random = SplitMix(SEED ^ 5);
    let mut models = models();
    // Surfaces whose tables leave rows out.
    let uneven = asperity_params::dimensionless(0.05, 60.0, 0.02, 1.5);
    for (name, params) in [
        ("long tail", uneven.weibull(1.1)),
        ("short tail", uneven.weibull(60.0)),
        ("radii that fall with height", uneven.radii(-1.0, 3.0)),
        ("radii that rise with height", uneven.weibull(20.0).radii(1.0, 5.0)),
    ] {
        models.push((name, Handle::new(&params)));
    }
    let mut failures = Vec::new();
    for (name, handle) in models {
        let summary = handle.summary();
        let (nearest, farthest) = (summary.min_table_load - summary.pull_off_load, 2.0 * summary.max_table_load);
        for (quantity, batch, scalar) in std::hint::black_box(LAWS) {
            for i in 0..120 {
                // Pull-off itself first, which the table does not answer.
                let x = if i == 0 { 0.0 } else { random.log_between(0.5 * nearest, farthest) };
                let load = summary.pull_off_load + x;
                let loads: Vec<f64> = (0..8).map(|i| load * (1.0 + 0.1 * f64::from(i))).collect();
                if let Some(raised) = flags_of(&handle, batch, scalar, &loads) {
                    failures.push(format!("{quantity}, {name}: from load {load:e} on {raised}"));
                }
            }
        }
    }
    let shown = failures.iter().take(8).map(String::as_str).collect::<Vec<_>>().join("\n");
    assert!(failures.is_empty(), "{} failures, seed {:#x}, the first:\n{shown}", failures.len(), SEED ^ 5);
}
