//! One call answers from a text: the same as its parts, whole or not at all, in text as in numbers.

use crate::interface::*;
use std::ffi::CStr;
use std::ptr::{null, null_mut};

const GROUND: &str =
    "pair = \"steel/steel\"\nnominal_area = 1e-4\nmeasured = [1000, 0.16]\n[roughness]\nprocess = \"ground\"\n\
                      Ra = 0.8e-6\n";

fn blank() -> asperity_estimate {
    // SAFETY: a struct of numbers.
    let mut one: asperity_estimate = unsafe { std::mem::zeroed() };
    one.struct_size = size_of::<asperity_estimate>() as u64;
    one.low = -7.0;
    one
}

fn ask(text: &str, loads: &[f64]) -> (i32, Vec<asperity_estimate>) {
    let mut found = vec![blank(); loads.len()];
    let (text, length) = (text.as_ptr().cast(), text.len());
    // SAFETY: as many bytes and elements as is said.
    let status = unsafe { asperity_estimate_at_loads(text, length, loads.len(), loads.as_ptr(), found.as_mut_ptr()) };
    (status, found)
}

#[track_caller]
fn found(text: &str, loads: &[f64]) -> Vec<asperity_estimate> {
    let (status, found) = ask(text, loads);
    assert_eq!(status, OK, "{}", message());
    found
}

#[test]
fn an_estimate_has_its_number_its_band_and_what_makes_it() {
    let [one] = found(GROUND, &[10.0])[..] else { panic!("one") };
    assert!((one.friction_coefficient - 0.173).abs() < 5e-4 && one.load == 10.0, "{one:?}");
    assert!((one.friction_force / (one.friction_coefficient * one.load) - 1.0).abs() < 4.0 * f64::EPSILON, "{one:?}");
    assert!((one.low - 0.108).abs() < 2e-3 && (one.high - 0.279).abs() < 2e-3, "{one:?}");
    let shares = [
        one.strength_share,
        one.size_share,
        one.pressure_share,
        one.adhesion_share,
        one.hardness_share,
        one.slope_share,
        one.measurement_share,
        one.model_share,
    ];
    assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9 && one.model_share > 0.85, "{one:?}");
    assert!(one.constant_odds > 0.25 && one.constant_odds < 0.4 && one.error_growth == 1.0, "{one:?}");
    for [value, low, high] in [
        [one.tangential_stiffness, one.tangential_stiffness_low, one.tangential_stiffness_high],
        [one.normal_stiffness, one.normal_stiffness_low, one.normal_stiffness_high],
        [one.contact_radius_sum, one.contact_radius_sum_low, one.contact_radius_sum_high],
        [one.unloading_stiffness, one.unloading_stiffness_low, one.unloading_stiffness_high],
    ] {
        assert!(0.0 < low && 1.5 * low < value && 1.5 * value < high, "{one:?}");
    }
    assert_eq!((one.strength_source, one.is_of_pressures), (ASPERITY_STRENGTH_MEASURED, 0));
    let rough = "nominal_area = 1e-8\n[roughness]\nSq = 5e-9\nSdq = 0.08\n";
    for (text, source) in [
        ("pair = \"Si/Si\"\n", ASPERITY_STRENGTH_DEFAULT),
        ("pair = \"steel/steel\"\n", ASPERITY_STRENGTH_TABLE),
        ("pair = \"Al-6061/steel\"\n", ASPERITY_STRENGTH_TABLE),
        ("pair = \"Si/Si\"\nslip_stress_1 = 0.02\n", ASPERITY_STRENGTH_GIVEN),
    ] {
        let [one] = found(&format!("{text}{rough}"), &[1e-3])[..] else { panic!("one") };
        assert_eq!(one.strength_source, source, "{text}");
        assert_eq!(one.warnings & ASPERITY_WARNING_UNCALIBRATED != 0, source == ASPERITY_STRENGTH_DEFAULT, "{text}");
    }
}

/// What a text makes of parameters has the friction that its estimate says, whatever was there before.
#[test]
fn a_model_of_a_text_has_the_friction_of_its_estimate() {
    let unmeasured = GROUND.replace("measured = [1000, 0.16]\n", "");
    let family = unmeasured.replace("steel/steel", "Al-6061/steel");
    for text in [GROUND, &unmeasured, &family] {
        let [one] = found(text, &[10.0])[..] else { panic!("one") };
        assert!(one.contacts > 20.0 && one.is_of_pressures == 0, "{one:?}");
        let mut params = asperity_params::initial();
        params.slip_stress_1 = 0.5;
        // SAFETY: the text has as many bytes as is said.
        let status = unsafe { asperity_params_set_text(&mut params, text.as_ptr().cast(), text.len()) };
        assert_eq!((status, params.contact_law), (OK, ASPERITY_CONTACT_ELASTIC_PLASTIC), "{}", message());
        let model = Handle::new(&params);
        // SAFETY: the model lives.
        let mu = unsafe { asperity_friction_at_load(model.0, 10.0) };
        assert!((mu / one.curve_coefficient - 1.0).abs() < 3e-6, "{mu} {one:?}");
        assert!((mu / one.friction_coefficient - 1.0).abs() < 3e-3, "{mu} {one:?}");
    }
}

/// However many are asked for together, and from as many threads.
#[test]
fn loads_are_answered_by_themselves() {
    let loads = [10.0, 1.0, 1e4, 0.1];
    let together = found(GROUND, &loads);
    std::thread::scope(|scope| {
        for (&load, one) in loads.iter().zip(&together) {
            scope.spawn(move || {
                let [alone] = found(GROUND, &[load])[..] else { panic!("one") };
                for (a, b) in [(alone.friction_coefficient, one.friction_coefficient), (alone.low, one.low)] {
                    assert!((a / b - 1.0).abs() < 1e-12, "{load}: {a} {b}");
                }
            });
        }
    });
    assert_eq!(found(GROUND, &[]).len(), 0);
}

/// Of a part of the law no row of gaps may be whole, and of loads that the law does not reach a whole row of loads still is.
#[test]
fn a_load_is_answered_however_little_of_the_law_is_near_it() {
    let text = "pair = \"Si/Si\"\nnominal_area = 2.6e-11\nheight_std = 3.7e-8\nsummit_radius = 6.7e-7\nsummit_density = 5.3e12\n\
                bandwidth = 71.5\nrms_slope = 0.102\n\
                table_height = [-6.3e-8, -5.2e-8, -3e-8, -8.7e-9, 1.3e-8, 3.4e-8, 5.6e-8, 7.7e-8, 9.9e-8, 1.1e-7]\n\
                table_density = [0, 13, 9.2, 7.9, 7.9, 5.5, 1.7, 0.68, 0.68, 0]\n";
    for load in (0..200).map(|i| 1e-20 * 2_f64.powf(0.5 * f64::from(i))) {
        let [one] = found(text, &[load])[..] else { panic!("one") };
        assert!(one.friction_coefficient > 0.0 && one.low <= one.friction_coefficient, "{one:?}");
    }
}

#[test]
fn nothing_is_written_where_something_is_refused() {
    let wrong = GROUND.replace("ground", "grund");
    for (text, loads, status, says) in [
        (GROUND, [10.0, f64::NAN], INVALID_LOAD, "element 1: load = NaN: must be finite"),
        (GROUND, [f64::INFINITY, 1.0], INVALID_LOAD, "element 0: load = inf: must be finite"),
        (GROUND, [10.0, 1e300], OUT_OF_RANGE, "element 1: load"),
        (&wrong, [10.0, 1.0], INVALID_PARAMETER, "line 5: [roughness] process = \"grund\": must be one of"),
        ("hardness = ", [10.0, 1.0], INVALID_PARAMETER, "line 1: "),
        ("", [10.0, 1.0], INVALID_PARAMETER, "line 1: composite_modulus: must be set"),
    ] {
        let (found, estimates) = ask(text, &loads);
        assert_eq!(found, status, "{}", message());
        assert!(message().starts_with(says), "{}\nnot\n{says}", message());
        assert!(estimates.iter().all(|one| one.low == -7.0), "{text}");
    }
}

#[test]
fn a_text_that_is_refused_has_the_reason() {
    let mut buffer = [1_u8; 64];
    for room in [64, 20] {
        // SAFETY: the text and the buffer have so many bytes.
        let whole =
            unsafe { asperity_estimate_text(c"mu = 1".as_ptr(), 6, 0, null(), buffer.as_mut_ptr().cast(), room) };
        assert_eq!(whole, 0);
        let shown = CStr::from_bytes_until_nul(&buffer).expect("a NUL").to_str().expect("UTF-8");
        assert!(
            message().starts_with(shown) && shown.starts_with("line 1: mu: no such") && shown.len() == room - 1,
            "{shown}"
        );
    }
}

#[test]
fn the_text_has_the_numbers() {
    let loads = [10.0, 1000.0];
    // SAFETY: NULL asks for the length; then the buffer has it.
    let text = unsafe {
        let (text, length) = (GROUND.as_ptr().cast(), GROUND.len());
        let whole = asperity_estimate_text(text, length, 2, loads.as_ptr(), null_mut(), 0);
        let mut buffer = vec![0_u8; whole + 1];
        assert_eq!(
            asperity_estimate_text(text, length, 2, loads.as_ptr(), buffer.as_mut_ptr().cast(), whole + 1),
            whole
        );
        assert_eq!(buffer.pop(), Some(0));
        String::from_utf8(buffer).expect("a text")
    };
    for (one, line) in found(GROUND, &loads).iter().zip(text.lines()) {
        let expected = format!(
            "mu({} N) = {:.3}, 95 % band {:.3} to {:.3}",
            one.load, one.friction_coefficient, one.low, one.high
        );
        let short = |text: &str| text.replace("0 ", " ").replace("0,", ",");
        assert_eq!(short(line), short(&expected));
    }
    assert!(text.contains("\nto narrow it: a second measured point at 10 N ("), "{text}");
}

/// Elements are as far apart as the first says.
#[test]
fn elements_of_other_sizes_are_filled_as_far_as_both_know_them() {
    const BEFORE: u64 = 0x5eed_5eed_5eed_5eed;
    let of_size = |size: usize| {
        let mut words = vec![BEFORE; size / 4];
        words[0] = size as u64;
        let (text, loads) = (GROUND.as_ptr().cast(), [10.0, 20.0]);
        // SAFETY: a text of its length, two loads, two elements of this size.
        let status =
            unsafe { asperity_estimate_at_loads(text, GROUND.len(), 2, loads.as_ptr(), words.as_mut_ptr().cast()) };
        assert_eq!(status, OK, "{size}: {}", message());
        [words[..size / 8].to_vec(), words[size / 8..].to_vec()]
    };
    let whole = size_of::<asperity_estimate>();
    let expected = of_size(whole);
    for size in [16, whole - 8, whole + 8, 4096] {
        for (found, expected) in of_size(size).iter().zip(&expected) {
            let known = size.min(whole) / 8;
            assert_eq!((found[0], &found[1..known]), (size as u64, &expected[1..known]), "{size}");
            assert!(found[known..].iter().all(|&word| word == BEFORE), "{size}");
        }
    }
}
