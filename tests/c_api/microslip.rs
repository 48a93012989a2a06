//! Steps of a contact that remembers, through the C functions.

use crate::common::splitmix::SplitMix;
use crate::interface::*;
use std::ptr::{null, null_mut};

const STATE: usize = 43;
const REACH: usize = 40;
const LAST: usize = 41;
const UNTOUCHED: f64 = 77.0;

/// With adhesion and without.
fn handles() -> [Handle; 2] {
    [0.001, 0.0].map(|gamma| Handle::new(&asperity_params::dimensionless(0.01, 1000.0, gamma, 1.0)))
}

/// F and K_t by their own calls.
fn strength_and_stiffness(handle: &Handle, load: f64) -> (f64, f64) {
    // SAFETY: the model lives.
    unsafe { (asperity_friction_force_at_load(handle.0, load), asperity_tangential_stiffness_at_load(handle.0, load)) }
}

fn step(
    handle: &Handle,
    load: f64,
    increment: [f64; 2],
    state: &mut [f64; STATE],
) -> (asperity_status, asperity_microslip) {
    let mut out = asperity_microslip::empty();
    let place = state.as_mut_ptr();
    // SAFETY: arrays of the lengths that are asked for.
    let status = unsafe { asperity_microslip_step(handle.0, load, increment.as_ptr(), place, place, &mut out) };
    (status, out)
}

fn near(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

#[test]
fn a_contact_begins_with_its_stiffness_and_ends_at_its_friction_force() {
    for handle in handles() {
        // SAFETY: the model lives, or there is none.
        unsafe {
            assert_eq!(asperity_microslip_length(handle.0), STATE);
            assert_eq!(asperity_microslip_length(null()), 0);
        }
        for load in [1e-6, 1e-3, 1.0, 1e3, 1e6] {
            let (strength, stiffness) = strength_and_stiffness(&handle, load);
            let length = strength / stiffness;
            for [x, y] in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8]] {
                let mut state = [0.0; STATE];
                let small = 1e-3 * length;
                let (status, begun) = step(&handle, load, [small * x, small * y], &mut state);
                assert_eq!(status, OK, "{}", message());
                let force = stiffness * small;
                assert!(near(begun.force[0], force * x, 1e-14) && near(begun.force[1], force * y, 1e-14), "{begun:?}");
                assert!(near(begun.stiffness[0], stiffness, 1e-14) && near(begun.stiffness[3], stiffness, 1e-14));
                assert_eq!((begun.stiffness[1], begun.stiffness[2]), (0.0, 0.0));
                assert_eq!((begun.dissipated, begun.slipping), (0.0, 0.0));
                let (_, ended) = step(&handle, load, [10.0 * length * x, 10.0 * length * y], &mut state);
                assert!(near(ended.force[0].hypot(ended.force[1]), strength, 1e-14), "{ended:?}, not {strength}");
                assert!(near(ended.slipping, 1.0, 1e-14) && ended.dissipated > 5.0 * strength * length, "{ended:?}");
                // Along the slip nothing more resists.
                let along = ended.stiffness[0] * x * x + 2.0 * ended.stiffness[1] * x * y + ended.stiffness[3] * y * y;
                assert!(along.abs() < 1e-14 * stiffness, "{ended:?}");
            }
        }
    }
}

#[test]
fn a_batch_has_the_bits_of_single_steps() {
    const N: usize = 300;
    let mut random = SplitMix(5);
    for handle in handles() {
        // Of 16 contacts the last three have no load, are apart, and have none that is a number.
        let kind = |i: usize| (i % 16).saturating_sub(12);
        let loads: Vec<f64> =
            (0..N).map(|i| [1e-4 * 1e8_f64.powf(random.between(0.0, 1.0)), 0.0, -1.0, f64::NAN][kind(i)]).collect();
        let mut states = vec![[0.0; STATE]; N];
        for round in 0..6 {
            let increments: Vec<[f64; 2]> = (0..N)
                .map(|i| {
                    let (strength, stiffness) =
                        strength_and_stiffness(&handle, if loads[i] > 0.0 { loads[i] } else { 1.0 });
                    [0, 1].map(|_| (2.0 * random.between(0.0, 1.0) - 1.0) * strength / stiffness)
                })
                .collect();
            let mut singles = states.clone();
            let steps: Vec<_> = (0..N).map(|i| step(&handle, loads[i], increments[i], &mut singles[i])).collect();
            let (mut after, mut force, mut stiffness) =
                (vec![[UNTOUCHED; STATE]; N], vec![[0.0_f64; 2]; N], vec![[0.0_f64; 4]; N]);
            // SAFETY: arrays of as many elements.
            let status = unsafe {
                asperity_microslip_steps(
                    handle.0,
                    N,
                    loads.as_ptr(),
                    increments.as_ptr().cast(),
                    states.as_ptr().cast(),
                    after.as_mut_ptr().cast(),
                    force.as_mut_ptr().cast(),
                    stiffness.as_mut_ptr().cast(),
                )
            };
            let first = steps.iter().position(|(status, _)| *status != OK);
            assert_eq!(status, first.map_or(OK, |first| steps[first].0));
            if let Some(first) = first {
                assert!(message().starts_with(&format!("element {first}: load = ")), "{}", message());
            }
            for i in 0..N {
                let (status, single) = &steps[i];
                assert_eq!(*status, [OK, OK, SEPARATED, INVALID_LOAD][kind(i)], "{i}");
                match *status {
                    OK | SEPARATED => {
                        let is_open = *status == SEPARATED || (kind(i) == 1 && handle.summary().pull_off_load == 0.0);
                        assert!(!is_open || (force[i], stiffness[i], after[i]) == ([0.0; 2], [0.0; 4], [0.0; STATE]));
                        assert_eq!(
                            (bytes(&force[i]), bytes(&stiffness[i])),
                            (bytes(&single.force), bytes(&single.stiffness))
                        );
                        assert_eq!(after[i], singles[i], "{i}, round {round}");
                    }
                    _ => {
                        assert!(force[i].iter().chain(&stiffness[i]).all(|x| x.is_nan()));
                        assert!(after[i].iter().all(|&x| x == UNTOUCHED));
                    }
                }
            }
            // In place.
            let place = states.as_mut_ptr().cast();
            // SAFETY: as above; outputs are not asked for.
            let in_place = unsafe {
                asperity_microslip_steps(
                    handle.0,
                    N,
                    loads.as_ptr(),
                    increments.as_ptr().cast(),
                    place,
                    place,
                    null_mut(),
                    null_mut(),
                )
            };
            assert_eq!((in_place, &states), (status, &singles));
            // From the first load that is no number on: it is the first that is told of.
            let (begin, no) = (15, null_mut());
            // SAFETY: as above.
            let status = unsafe {
                asperity_microslip_steps(
                    handle.0,
                    N - begin,
                    loads[begin..].as_ptr(),
                    increments[begin..].as_ptr().cast(),
                    states[begin..].as_ptr().cast(),
                    no,
                    no,
                    no,
                )
            };
            assert_eq!(status, INVALID_LOAD);
            assert!(message().starts_with("element 0: load = NaN"), "{}", message());
        }
    }
}

#[test]
fn what_is_not_in_order_is_named_and_nothing_is_written() {
    let [handle, hertz] = handles();
    let (strength, stiffness) = strength_and_stiffness(&handle, 1.0);
    let fine = [0.3 * strength / stiffness, 0.0];
    let mut bad_state = [0.0; STATE];
    bad_state[7] = f64::NAN;
    let [less, more] = [[0.0, -1.0], [2.0, 3.0]].map(|[reach, last]| {
        let mut state = [0.0; STATE];
        (state[REACH], state[LAST]) = (reach, last);
        state
    });
    let mut lighter = [0.0; STATE];
    lighter[STATE - 1] = -1.0;
    for (load, increment, before, status, text) in [
        (f64::NAN, fine, [0.0; STATE], INVALID_LOAD, "load = NaN: must be finite"),
        (f64::INFINITY, fine, [0.0; STATE], INVALID_LOAD, "load = inf: must be finite"),
        (1e300, fine, [0.0; STATE], OUT_OF_RANGE, "load = 1e300: must be below"),
        (1.0, [f64::NEG_INFINITY, 0.0], [0.0; STATE], INVALID_PARAMETER, "increment[0] = -inf: must be finite"),
        (1.0, [0.0, f64::NAN], [0.0; STATE], INVALID_PARAMETER, "increment[1] = NaN: must be finite"),
        (1.0, fine, bad_state, INVALID_PARAMETER, "before[7] = NaN: must be finite"),
        (1.0, fine, less, INVALID_PARAMETER, "before[41] = -1: must be from 0 to the number before it"),
        (1.0, fine, more, INVALID_PARAMETER, "before[41] = 3: must be from 0 to the number before it"),
        (1.0, fine, lighter, INVALID_PARAMETER, "before[42] = -1: must be the largest load"),
    ] {
        let mut out = asperity_microslip::empty();
        out.dissipated = UNTOUCHED;
        let mut after = [UNTOUCHED; STATE];
        let call = || {
            // SAFETY: arrays of the lengths that are asked for.
            unsafe {
                asperity_microslip_step(
                    handle.0,
                    load,
                    increment.as_ptr(),
                    before.as_ptr(),
                    after.as_mut_ptr(),
                    &mut out,
                )
            }
        };
        let (found, complaint) = flags::watch(call);
        assert_eq!(found, status, "{text}");
        assert!(message().starts_with(text), "{}, not {text}", message());
        assert_eq!((out.dissipated, after, complaint), (UNTOUCHED, [UNTOUCHED; STATE], None), "{text}");
    }
    // Open, and at zero load.
    for (handle, load, status) in
        [(&handle, -1.0, SEPARATED), (&hertz, -1e-9, SEPARATED), (&hertz, 0.0, OK), (&hertz, -0.0, OK)]
    {
        let mut state = [0.1; STATE];
        let (found, out) = step(handle, load, fine, &mut state);
        assert_eq!((found, state), (status, [0.0; STATE]), "{load}");
        assert_eq!((out.force, out.stiffness, out.slipping), ([0.0; 2], [0.0; 4], 0.0), "{load}");
        // What the contact held is lost.
        assert!(near(out.dissipated, 0.1_f64.powi(3), 1e-14), "{load}: {out:?}");
        assert_eq!(status == SEPARATED, out.dforce_dload == [0.0; 2], "{load}: {out:?}");
    }
    let mut out = asperity_microslip { struct_size: 12, ..asperity_microslip::empty() };
    let (before, mut after) = ([0.0; STATE], [UNTOUCHED; STATE]);
    // SAFETY: what is refused is not read.
    unsafe {
        let (x, s, a) = (fine.as_ptr(), before.as_ptr(), after.as_mut_ptr());
        assert_eq!(asperity_microslip_step(handle.0, 1.0, x, s, a, &mut out), INVALID_PARAMETER);
        out.struct_size = size_of::<asperity_microslip>() as u64;
        assert_eq!(asperity_microslip_step(handle.0, 1.0, x, s, null_mut(), &mut out), OK);
        // Also where the surfaces are apart, which is an answer only if there is a place for it.
        assert_eq!(asperity_microslip_step(handle.0, -1.0, x, s, a, null_mut()), NULL_POINTER);
        let (no, f) = (null_mut(), out.force.as_mut_ptr());
        // Of many, what is not in order by its load, its increment or its state.
        let (infinite, bad) = ([0.0, f64::INFINITY], bad_state.as_ptr());
        assert_eq!(asperity_microslip_steps(handle.0, 1, &f64::NAN, x, s, a, f, no), INVALID_LOAD);
        assert_eq!(asperity_microslip_steps(handle.0, 1, &1.0, infinite.as_ptr(), s, a, f, no), INVALID_PARAMETER);
        assert_eq!(asperity_microslip_steps(handle.0, 1, &1.0, x, bad, a, f, no), INVALID_PARAMETER);
    }
    assert_eq!(after, [UNTOUCHED; STATE]);
}

/// States and displacements as no solver has them: the forces stay within the strength, and everything is a number.
#[test]
fn anything_finite_gives_finite_numbers_within_the_strength() {
    let mut random = SplitMix(11);
    let sizes = [0.0, 5e-324, 1e-308, 1e-200, 1e-150, 1e-20, 1.0, 1e20, 1e150, 1e200, f64::MAX];
    for handle in handles() {
        for i in 0..4000 {
            let mut any = || {
                sizes[(random.between(0.0, 1.0) * sizes.len() as f64) as usize]
                    * if random.between(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 }
            };
            let mut state: [f64; STATE] = std::array::from_fn(|_| any());
            let increment = [any(), any()];
            // Two of the last are stiffnesses, of which the second is the smaller; then there is the largest load.
            let [a, b] = [state[REACH].abs(), state[LAST].abs()];
            (state[REACH], state[LAST]) = (a.max(b), a.min(b));
            state[STATE - 1] = state[STATE - 1].abs().min(1e50);
            let load = [1e-280, 1e-30, 1e-6, 1.0, 1e6, 1e60, 0.0, handle.summary().pull_off_load][i % 8];
            let (strength, stiffness) = strength_and_stiffness(&handle, load);
            let before = state;
            let ((status, out), complaint) = flags::watch(|| step(&handle, load, increment, &mut state));
            assert_eq!((status, complaint), (OK, None), "{load}");
            let force = out.force[0].hypot(out.force[1]);
            assert!(force <= strength * (1.0 + 1e-14), "{load}: {out:?}, {strength}, {increment:?}, {before:?}");
            let numbers = [out.dforce_dload, [out.dissipated, out.slipping]].concat();
            assert!(numbers.iter().chain(&out.stiffness).chain(&state).all(|x| x.is_finite()), "{load}: {out:?}");
            assert!(out.stiffness.iter().all(|x| x.abs() <= stiffness * (1.0 + 1e-13)), "{load}: {out:?}");
            assert!(out.dissipated >= 0.0 && (0.0..=1.0).contains(&out.slipping), "{load}: {out:?}");
        }
    }
}

/// Whether the square of a number of a state overflows or not, to either side and in any units.
#[test]
fn what_is_displaced_too_far_is_displaced_as_far_as_can_be() {
    for (gamma, largest) in [(0.001, 1e18), (0.0, 1e34)] {
        for place in [0, 5, 11] {
            let [forces, small, large] = [1.0, 1.0 / largest, largest].map(|unit| {
                let handle = Handle::new(&in_units(asperity_params::dimensionless(0.01, 1000.0, gamma, 1.0), unit));
                let load = unit * unit * unit;
                let (strength, stiffness) = strength_and_stiffness(&handle, load);
                let displaced = |displacement: f64, side: f64| {
                    let (mut state, far) = ([0.0; STATE], 10.0 * side * strength / stiffness);
                    step(&handle, load, [0.6 * far, 0.8 * far], &mut state);
                    state[place] = side * displacement;
                    let (status, out) = step(&handle, load, [0.0; 2], &mut state);
                    assert_eq!(status, OK, "{}", message());
                    assert!(state[..REACH].iter().all(|x| x.abs() < 100.0 * strength / stiffness), "{state:?}");
                    state[..REACH].iter_mut().for_each(|x| *x *= side);
                    (out.force.map(|x| side * x), out.stiffness, state)
                };
                let far = displaced(f64::MAX, 1.0);
                for (displacement, side) in [(1e190, 1.0), (1e200, 1.0), (1e190, -1.0), (1e200, -1.0)] {
                    assert_eq!(displaced(displacement, side), far, "{unit}, {place}, {displacement}");
                }
                far.0.map(|force| force / strength)
            });
            for other in [small, large] {
                assert!((0..2).all(|axis| (other[axis] - forces[axis]).abs() < 1e-4), "{other:?}, not {forces:?}");
            }
        }
    }
}

/// With other units of length and stress.
fn in_units(params: asperity_params, unit: f64) -> asperity_params {
    asperity_params {
        composite_modulus: params.composite_modulus * unit,
        effective_shear_modulus: params.effective_shear_modulus * unit,
        work_of_adhesion: params.work_of_adhesion * unit * unit,
        adhesion_range: params.adhesion_range * unit,
        burgers_vector: params.burgers_vector * unit,
        summit_radius: params.summit_radius * unit,
        height_std: params.height_std * unit,
        ..params
    }
}

/// Of a load so light that its friction is no number, but its stiffness is.
#[test]
fn a_contact_without_strength_resists_nothing() {
    let mut params = asperity_params::dimensionless(0.01, 1000.0, 0.0, 1.0);
    (params.slip_stress_1, params.slip_stress_2) = (1e-40, 1e-40);
    let handle = Handle::new(&params);
    let load = 1e-290;
    let (strength, stiffness) = strength_and_stiffness(&handle, load);
    assert!(strength == 0.0 && stiffness > 0.0, "{strength:e}, {stiffness:e}");
    for size in [0.0, 1e-300, 1.0, 1e200] {
        let mut state = [size; STATE];
        state[STATE - 1] = 0.0;
        let (status, out) = step(&handle, load, [size, -size], &mut state);
        assert_eq!((status, out.force, out.stiffness), (OK, [0.0; 2], [0.0; 4]), "{}", message());
        assert!(state == [0.0; STATE] && out.dissipated >= 0.0 && out.dissipated.is_finite(), "{out:?}, {state:?}");
    }
}

/// A path that is turned as a whole, or a state that is turned on the way.
#[test]
fn a_state_turns_with_the_contact() {
    let mut random = SplitMix(29);
    for handle in handles() {
        let (mut state, mut turned, mut angle) = ([0.0; STATE], [0.0; STATE], 0.0_f64);
        let mut largest = 0.0_f64;
        for i in 0..500 {
            let load = random.log_between(1e-2, 1e2);
            let (strength, stiffness) = strength_and_stiffness(&handle, load);
            let increment = [0, 1].map(|_| random.between(-1.0, 1.0) * strength / stiffness);
            let by = random.between(-3.0, 3.0);
            angle += by;
            // SAFETY: a state of its length.
            let status = unsafe { asperity_microslip_turn(turned.as_mut_ptr(), by.cos(), by.sin()) };
            assert_eq!(status, OK, "{}", message());
            let (sine, cosine) = angle.sin_cos();
            let turn = |[x, y]: [f64; 2]| [cosine * x - sine * y, sine * x + cosine * y];
            let (_, plain) = step(&handle, load, increment, &mut state);
            let (_, found) = step(&handle, load, turn(increment), &mut turned);
            let expected = turn(plain.force);
            largest = largest.max(plain.force[0].hypot(plain.force[1]));
            for axis in 0..2 {
                let error = (found.force[axis] - expected[axis]).abs();
                assert!(error < 1e-12 * largest, "{i}: {found:?}, not {expected:?}");
            }
            assert!((found.dissipated - plain.dissipated).abs() < 1e-12 * largest * strength / stiffness);
        }
    }
}

#[test]
fn what_is_no_angle_or_no_state_is_refused() {
    let mut state = [1.0; STATE];
    for (cosine, sine, text) in [
        (f64::NAN, 0.0, "cosine = NaN: must be finite"),
        (1.0, f64::INFINITY, "sine = inf: must be finite"),
        (0.0, 0.0, "cosine = 0: must not be 0 where the sine is"),
    ] {
        // SAFETY: a state of its length.
        assert_eq!(unsafe { asperity_microslip_turn(state.as_mut_ptr(), cosine, sine) }, INVALID_PARAMETER);
        assert!(message().starts_with(text), "{}, not {text}", message());
    }
    assert_eq!(state, [1.0; STATE]);
    state[3] = f64::NEG_INFINITY;
    // SAFETY: as above, or NULL.
    unsafe {
        assert_eq!(asperity_microslip_turn(state.as_mut_ptr(), 1.0, 0.0), INVALID_PARAMETER);
        assert_eq!(asperity_microslip_turn(null_mut(), 1.0, 0.0), NULL_POINTER);
    }
}

/// Whatever the load and the largest load, one step and a batch answer alike, within the strength, and raise nothing while a branch is made.
#[test]
fn contacts_of_a_joint_are_stepped_one_by_one_and_together_to_the_same_bits() {
    let hertz = asperity_params::dimensionless(0.02, 1000.0, 0.0, 1.0);
    let hardness = 0.01 * hertz.composite_modulus;
    let first = Handle::new(&asperity_params { contact_law: ASPERITY_CONTACT_ELASTIC_PLASTIC, hardness, ..hertz });
    let mut joint = null_mut();
    // SAFETY: a model and a place for another.
    assert_eq!(unsafe { asperity_unloaded(first.0, 1e-3, &mut joint) }, OK, "{}", message());
    let joint = Handle(joint);
    let mut random = SplitMix(5);
    let mut state = [0.0; STATE];
    for i in 0..600 {
        let load = random.log_between(1e-4, 1e2);
        let (strength, stiffness) = strength_and_stiffness(&first, load);
        let increment = [0, 1].map(|_| random.between(-2.0, 2.0) * strength / stiffness);
        if i % 50 == 0 {
            state[STATE - 1] = random.log_between(1e-5, 1e4);
        }
        let before = state;
        let ((status, out), complaint) = flags::watch(|| step(&joint, load, increment, &mut state));
        assert_eq!((status, complaint), (OK, None), "{load}: {}", message());
        assert_eq!(state[STATE - 1], before[STATE - 1].max(load));
        assert!(out.dissipated >= 0.0 && out.force.iter().chain(&out.stiffness).all(|x| x.is_finite()), "{out:?}");
        let (mut after, mut force, mut tangents) = ([0.0; STATE], [0.0; 2], [0.0; 4]);
        // SAFETY: arrays of one contact.
        let status = unsafe {
            let (x, s, a) = (increment.as_ptr(), before.as_ptr(), after.as_mut_ptr());
            asperity_microslip_steps(joint.0, 1, &load, x, s, a, force.as_mut_ptr(), tangents.as_mut_ptr())
        };
        assert_eq!((status, after, force, tangents), (OK, state, out.force, out.stiffness), "{i}: {load}");
    }
}
