//! What a new user gets wrong is refused, or told: a length where a ratio is meant, a force where a coefficient is, an input that
//! was never set, an area in another unit, a strength that nobody measured.

use crate::interface::*;
use std::ptr::null_mut;

/// Ground steel, 1.7e10 summits per m^2 on a square centimetre, without adhesion.
fn steel() -> asperity_params {
    let mut params = asperity_params::unset();
    // SAFETY: an initialised struct, and a name that ends.
    assert_eq!(unsafe { asperity_params_set_pair(&mut params, c"steel/steel".as_ptr()) }, OK);
    (params.height_std, params.summit_radius, params.asperity_count) = (0.3e-6, 1e-5, 1.7e6);
    (params.nominal_area, params.work_of_adhesion) = (1e-4, 0.0);
    params
}

fn refused(params: &asperity_params, part: &str) {
    let mut model = null_mut();
    // SAFETY: initialised parameters.
    assert_ne!(unsafe { asperity_create(params, &mut model) }, OK, "{part}");
    assert!(model.is_null() && message().contains(part), "{}", message());
}

fn warnings(params: &asperity_params, load: f64) -> u64 {
    let handle = Handle::new(params);
    let mut state = asperity_state::empty();
    // SAFETY: a model, and a struct of its size.
    assert_eq!(unsafe { asperity_state_at_load(handle.0, load, &mut state) }, OK, "{}", message());
    state.warnings
}

fn coefficient(params: &asperity_params, load: f64) -> f64 {
    let handle = Handle::new(params);
    // SAFETY: a model.
    unsafe { asperity_friction_at_load(handle.0, load) }
}

#[test]
fn an_input_that_was_never_set_is_named() {
    let mut params = asperity_params::unset();
    refused(&params, "composite_modulus: must be set");
    params = asperity_params { asperity_count: params.asperity_count, ..steel() };
    refused(&params, "asperity_count: must be set");
}

#[test]
fn a_slip_radius_that_is_a_length_is_refused() {
    for length in [10.75e-9, 1.0 - 1e-15] {
        refused(
            &asperity_params { slip_radius_1: length, ..steel() },
            "is it a length? It is a ratio to burgers_vector",
        );
    }
    Handle::new(&asperity_params { slip_radius_1: 1.0, ..steel() });
    refused(&asperity_params { slip_radius_1: 1e-9, slip_radius_2: 3e-9, ..steel() }, "slip_radius_1 = 1e-9");
}

#[test]
fn a_summit_density_that_no_surface_has_is_refused() {
    // In mm^2, and a density in place of a count.
    refused(&asperity_params { nominal_area: 100.0, ..steel() }, "is nominal_area in mm^2");
    refused(
        &asperity_params { asperity_count: 1.7e10, ..steel() },
        "is asperity_count a number of asperities and not a density",
    );
    refused(&asperity_params { asperity_count: 1.7e10, bandwidth: 5.0, ..steel() }, "not a density");
}

#[test]
fn the_measured_coefficient_is_that_of_the_model_and_is_kept() {
    let mut params = steel();
    // SAFETY: initialised parameters.
    assert_eq!(unsafe { asperity_params_calibrate(&mut params, 20.0, 0.16) }, OK, "{}", message());
    assert!((coefficient(&params, 20.0) / 0.16 - 1.0).abs() < 1e-8);
    assert_eq!((params.calibration_load, params.calibration_friction_force), (20.0, 0.16 * 20.0));
    assert_eq!(params.calibration_error, 0.05);
    assert_eq!(warnings(&params, 20.0) & ASPERITY_WARNING_UNCALIBRATED, 0);
    let kept = asperity_params::of(&Handle::new(&params));
    assert_eq!((kept.calibration_load, kept.calibration_friction_force), (20.0, 0.16 * 20.0));
    // By name, as it was given.
    for (name, expected) in [
        (c"calibration_load", 20.0),
        (c"calibration_friction_coefficient", 0.16),
        (c"calibration_friction_force", 3.2),
        (c"calibration_error", 0.05),
    ] {
        let mut value = 0.0;
        // SAFETY: initialised parameters, and a name that ends.
        assert_eq!(unsafe { asperity_params_get_value(&params, name.as_ptr(), &mut value) }, OK, "{}", message());
        assert!((value / expected - 1.0).abs() < 1e-15, "{name:?}: {value}");
    }
    // A force that was measured at zero load has no coefficient.
    let (at_zero, mut value) = (asperity_params { calibration_load: 0.0, ..params }, 0.0);
    let name = c"calibration_friction_coefficient".as_ptr();
    // SAFETY: initialised parameters, and a name that ends.
    assert_eq!(unsafe { asperity_params_get_value(&at_zero, name, &mut value) }, OK, "{}", message());
    assert!(value.is_nan(), "{value}");
    // Again with the same point: not a bit changes.
    let before = params;
    // SAFETY: initialised parameters.
    assert_eq!(unsafe { asperity_params_calibrate(&mut params, 20.0, 0.16) }, OK, "{}", message());
    assert_eq!(bytes(&params), bytes(&before));
    // A strength that was measured elsewhere replaces this measurement.
    let text = "interface = \"graphite layers\"";
    // SAFETY: initialised parameters, and a text of its length.
    assert_eq!(unsafe { asperity_params_set_text(&mut params, text.as_ptr().cast(), text.len()) }, OK);
    assert_eq!((params.calibration_load, params.calibration_friction_force), (0.0, 0.0));
}

#[test]
fn a_measurement_that_cannot_be_meant_is_refused() {
    let before = steel();
    for (load, measured, by_force, told) in [
        (20.0, 47.0, false, "calibration_friction_coefficient = 47: must be > 0 and at most 20; is it a force?"),
        (0.3, 1e-5, false, "calibration_friction_coefficient = 1e-5: most are between 0.001 and 10, as the load is here: are the two swapped?"),
        (0.16, 12.0, false, "calibration_friction_coefficient = 12: most are between 0.001 and 10, as the load is here"),
        (0.16, 1000.0, false, "or is it in per cent? Or is it the load, which comes first?"),
        (20.0, 0.0, false, "must be > 0 and at most 20"),
        (20.0, f64::NAN, false, "must be > 0 and at most 20"),
        (0.0, 0.16, false, "calibration_load = 0: must be > 0; at zero load"),
        (f64::INFINITY, 0.16, false, "calibration_load = inf: must be finite"),
        (20.0, -3.2, true, "must be finite and above 0"),
        (20.0, 3.2e9, true, "must be at most"),
    ] {
        let mut params = before;
        // SAFETY: initialised parameters.
        let status = unsafe {
            match by_force {
                false => asperity_params_calibrate(&mut params, load, measured),
                true => asperity_params_calibrate_force(&mut params, load, measured),
            }
        };
        assert_ne!(status, OK, "{told}");
        assert!(message().contains(told), "{}", message());
        assert_eq!(bytes(&params), bytes(&before), "{told}");
    }
    for (error, told) in [(5.0, "is it in per cent?"), (0.0, "must be finite and > 0"), (f64::NAN, "calibration_error")]
    {
        refused(&asperity_params { calibration_error: error, ..before }, told);
    }
    refused(&asperity_params { calibration_friction_force: -1.0, ..before }, "0 means not calibrated");
    refused(&asperity_params { calibration_load: f64::NAN, ..before }, "calibration_load = NaN");
}

#[test]
fn a_strength_that_nobody_measured_is_told_also_of_one_summit_and_with_other_slip_radii() {
    let uncalibrated = |params: &asperity_params| warnings(params, 1.0) & ASPERITY_WARNING_UNCALIBRATED != 0;
    assert!(uncalibrated(&steel()) && uncalibrated(&asperity_params::initial()));
    let tip = asperity_params { asperity_count: 1.0, nominal_area: 0.0, ..steel() };
    assert!(uncalibrated(&tip));
    assert!(uncalibrated(&asperity_params { slip_radius_1: 20.0, slip_radius_2: 1e5, ..steel() }));
    assert!(!uncalibrated(&asperity_params { slip_stress_1: 0.02, ..steel() }));
    assert!(!uncalibrated(&asperity_params { pressure_coefficient: 0.1, ..steel() }));
    // A measurement that confirms the default is one.
    let mut confirmed = steel();
    let force = coefficient(&confirmed, 1.0);
    // SAFETY: initialised parameters.
    assert_eq!(unsafe { asperity_params_calibrate_force(&mut confirmed, 1.0, force) }, OK, "{}", message());
    assert!(!uncalibrated(&confirmed));
}

#[test]
fn a_struct_of_another_size_is_refused() {
    let mut params = steel();
    let size = params.struct_size;
    for (other, told) in [
        (0, "call asperity_params_init first"),
        (144, "call asperity_params_init first"),
        (size + 4, "call asperity_params_init first"),
        (size + 8, "the header is newer than the library"),
        (2 * size - 8, "the header is newer than the library"),
        (2 * size, "call asperity_params_init first"),
        (u64::MAX, "call asperity_params_init first"),
    ] {
        params.struct_size = other;
        refused(&params, told);
    }
}

#[test]
fn words_that_people_expect_are_answered_with_what_to_give() {
    for (name, told) in [
        (c"Rz", "Rz: no parameter has this name; a height from peak to valley, which grows with the length measured: give Ra or Rq"),
        (c"mu", "give calibration_friction_coefficient with calibration_load"),
        (c"skeww", "skeww: no parameter has this name; the nearest is skew"),
    ] {
        let mut params = steel();
        // SAFETY: initialised parameters, and a name that ends.
        assert_eq!(unsafe { asperity_params_set_values(&mut params, 1, &name.as_ptr(), &1.0) }, INVALID_PARAMETER);
        assert!(message().contains(told), "{}", message());
    }
}

#[test]
fn a_pair_of_metals_that_yields_needs_no_work_of_adhesion() {
    let read = |text: &str| {
        let mut params = asperity_params::unset();
        // SAFETY: an initialised struct, and a text of its length.
        let status = unsafe { asperity_params_set_text(&mut params, text.as_ptr().cast(), text.len()) };
        (status, params)
    };
    let yields = "pair = \"steel/steel\"\ncontact_law = \"elastic-plastic\"\n";
    let (status, params) = read(yields);
    assert_eq!((status, params.work_of_adhesion), (OK, 0.0), "{}", message());
    let (status, _) = read(&format!(
        "{yields}work_of_adhesion = 0.05\nheight_std = 1e-7\nsummit_radius = 1e-5\nasperity_count = 1e5\n"
    ));
    assert_eq!(status, INVALID_PARAMETER);
    assert!(message().contains("work_of_adhesion = 0.05: must be 0 where contact_law"), "{}", message());
}
