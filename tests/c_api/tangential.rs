//! Tangential stiffness and microslip, and summits that yield, through the C functions.

use crate::interface::*;
use std::ptr::null_mut;

const UNTOUCHED: f64 = 77.0;

fn yielding() -> asperity_params {
    let mut params = asperity_params::dimensionless(0.02, 1000.0, 0.0, 1.0);
    params.contact_law = ASPERITY_CONTACT_ELASTIC_PLASTIC;
    params.hardness = 0.01 * params.composite_modulus;
    params
}

/// With adhesion, without, and of summits that yield.
fn handles() -> [Handle; 3] {
    [asperity_params::initial(), asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0), yielding()]
        .map(|params| Handle::new(&params))
}

fn state_at_load(handle: &Handle, load: f64) -> asperity_state {
    // SAFETY: zero bits are a value of every field.
    let mut state: asperity_state = unsafe { std::mem::zeroed() };
    state.struct_size = std::mem::size_of::<asperity_state>() as u64;
    // SAFETY: the model lives, the struct has its size set.
    assert_eq!(unsafe { asperity_state_at_load(handle.0, load, &mut state) }, OK, "{}", message());
    state
}

#[test]
fn the_stiffness_is_that_of_the_state_and_of_small_displacements() {
    for handle in handles() {
        for load in [1e-3, 10.0, 1e5] {
            let state = state_at_load(&handle, load);
            // SAFETY: the model lives.
            let stiffness = unsafe { asperity_tangential_stiffness_at_load(handle.0, load) };
            assert!((stiffness / state.tangential_stiffness - 1.0).abs() < 1e-6, "{load}: {stiffness}");
            let (mut force, mut slope) = (UNTOUCHED, UNTOUCHED);
            let length = state.friction_force / stiffness;
            // SAFETY: places to write to.
            let status = unsafe { asperity_tangential_at_load(handle.0, load, 1e-8 * length, &mut force, &mut slope) };
            assert_eq!(status, OK, "{}", message());
            assert!((force / (1e-8 * state.friction_force) - 1.0).abs() < 1e-6, "{load}: {force}");
            assert!((slope / stiffness - 1.0).abs() < 1e-6, "{load}: {slope}");
            // One of the two, or none.
            let mut alone = UNTOUCHED;
            // SAFETY: places to write to, or none.
            unsafe {
                assert_eq!(asperity_tangential_at_load(handle.0, load, length, &mut force, null_mut()), OK);
                assert_eq!(asperity_tangential_at_load(handle.0, load, -length, &mut alone, null_mut()), OK);
                assert_eq!(alone, -force);
                assert_eq!(asperity_tangential_at_load(handle.0, load, length, null_mut(), &mut alone), OK);
                assert!(alone > 0.0 && alone < stiffness);
                assert_eq!(asperity_tangential_at_load(handle.0, load, length, null_mut(), null_mut()), OK);
            }
        }
    }
}

#[test]
fn bad_input_has_a_status_and_a_message_and_touches_no_output() {
    let handle = Handle::new(&asperity_params::initial());
    let pull_off = handle.summary().pull_off_load;
    for (load, displacement, status, says) in [
        (2.0 * pull_off, 1.0, SEPARATED, "below the pull-off load"),
        (f64::NAN, 1.0, INVALID_LOAD, "load = NaN: must be finite"),
        (f64::INFINITY, 1.0, INVALID_LOAD, "load = inf: must be finite"),
        (1e300, 1.0, OUT_OF_RANGE, "load = 1e300: must be below"),
        (1.0, f64::NAN, INVALID_PARAMETER, "displacement = NaN: must be finite"),
        (1.0, f64::NEG_INFINITY, INVALID_PARAMETER, "displacement = -inf: must be finite"),
    ] {
        let (mut force, mut slope) = (UNTOUCHED, UNTOUCHED);
        // SAFETY: places to write to.
        let found = unsafe { asperity_tangential_at_load(handle.0, load, displacement, &mut force, &mut slope) };
        assert_eq!((found, force, slope), (status, UNTOUCHED, UNTOUCHED), "{load}, {displacement}");
        assert!(message().contains(says), "{}", message());
    }
}

#[test]
fn what_summits_cannot_have_is_refused() {
    type Change = fn(&mut asperity_params);
    let changes: [(Change, &str); 8] = [
        (|params| params.hardness = 0.0, "hardness = 0: must be > 0 where contact_law is"),
        (|params| params.hardness = -1.0, "hardness = -1: must be finite and >= 0"),
        (|params| params.hardness = f64::NAN, "hardness = NaN: must be finite and >= 0"),
        (|params| params.work_of_adhesion = 1e-3, "work_of_adhesion = 0.001: must be 0 where contact_law is"),
        (|params| params.tangential_modulus = -1.0, "tangential_modulus = -1: must be finite and >= 0"),
        (|params| params.contact_law = 2, "contact_law = 2: must be one of"),
        (|params| params.slip_onset = 2, "slip_onset = 2: must be one of ASPERITY_SLIP_: PARTIAL (0), WHOLE (1)"),
        (|params| params.slip_onset = -1, "slip_onset = -1: must be one of ASPERITY_SLIP_"),
    ];
    for (change, says) in changes {
        let mut params = yielding();
        change(&mut params);
        let mut model = null_mut();
        // SAFETY: initialised parameters and a place to write to.
        let status = unsafe { asperity_create(&params, &mut model) };
        assert!(status == INVALID_PARAMETER && model.is_null(), "{says}: {status}");
        assert!(message().starts_with(says), "{}", message());
    }
}
