//! A contact that remembers: one step of one contact or of many, with the state in the caller's arrays.

use super::batch::{self, Arrays, Asked};
use super::boundary::{self, not_null, Failure};
#[cfg(target_arch = "x86_64")]
use super::four_avx2::Avx2;
use super::model::{self, asperity_model};
use super::output::{fill, same_fields};
use super::status::asperity_status;
use crate::error::Error;
use crate::memory::{self, Cells, MicroslipStep, Sloped, STATE};
use crate::model::Model;
use crate::numerics::float_bits::nan;
use crate::numerics::four::Portable;
use std::ptr;

/// What resists a displacement of the surfaces along each other.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_microslip {
    /// Set it to `sizeof(asperity_microslip)`; no more is written.
    pub struct_size: u64,
    /// T [force], along both directions: positive where it resists a positive displacement. The surface that moves feels -T, the other T.
    pub force: [f64; 2],
    /// dT/d(increment) [force/length], row by row: T1 by the first, T1 by the second, then T2; eigenvalues are 0 to K_t.
    pub stiffness: [f64; 4],
    /// dT/d(load) of the same increment; at the load of the last step, as it rises.
    pub dforce_dload: [f64; 2],
    /// Energy lost in this step, >= 0 [force length]: heat of slip, and what parts held that separated.
    pub dissipated: f64,
    /// Fraction of the strength that slips, 0 to 1; 1 is gross slip.
    pub slipping: f64,
}

/// How many doubles the state of one contact takes; today 43, the same for all models.
///
/// @return the number of doubles; 0 for a NULL model
#[no_mangle]
pub unsafe extern "C" fn asperity_microslip_length(model: *const asperity_model) -> usize {
    if model.is_null() {
        0
    } else {
        STATE
    }
}

/// Displaces a contact under a load: the tangential force with what happened before, its tangents and the work of slip.
///
/// The force rises with K_t and ends at F. More load on a contact at rest adds stiffness and no force. Less takes away what touches no
/// more, with its force and energy. No path gains energy. In a step whose load rises, separation and displacement change together.
///
/// The caller owns the state, one for each contact: `asperity_microslip_length` doubles, all 0 for a contact that has just closed;
/// `asperity_microslip_turn` turns it with the contact. An iteration repeats the call with the same `before`; the step that is accepted
/// keeps `after`. The last double is the largest load since the contact closed, which you may set: on a model of `asperity_unloaded` a
/// contact under a lighter load follows its own unloading from there. Below the pull-off load the contact is open: force, stiffness and
/// `after` become 0, and the status is `ASPERITY_SEPARATED`. At zero load without adhesion they are 0 too, with `ASPERITY_OK`.
///
/// @param load       normal load of this step [force]
/// @param increment  2 displacements of one surface along the other since `before` [length]
/// @param before     the state before the step
/// @param after      receives the state after the step
/// @param out        receives force, tangents and work
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`; an increment that is not finite, a
///         state that is none), `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED` (outputs are 0 but for `dissipated`),
///         `ASPERITY_OUT_OF_RANGE`
#[no_mangle]
pub unsafe extern "C" fn asperity_microslip_step(
    model: *const asperity_model,
    load: f64,
    increment: *const f64,
    before: *const f64,
    after: *mut f64,
    out: *mut asperity_microslip,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        not_null(increment, "increment")?;
        not_null(before, "before")?;
        let mut separated = None;
        fill(out, "out", || {
            let step = match one(model, load, read(increment), before, after) {
                Err(error @ Error::Separated { .. }) => {
                    separated = Some(error);
                    let dissipated = memory::energy(&read(before));
                    write_all(after, 0, &[0.0; STATE]);
                    MicroslipStep { dissipated, ..MicroslipStep::default() }
                }
                other => other?,
            };
            Ok(same_fields! { asperity_microslip of step;
                force stiffness dforce_dload dissipated slipping
            })
        })?;
        separated.map_or(Ok(()), |error| Err(error.into()))
    })
}

/// One step of many contacts, each as `asperity_microslip_step` gives it, to the bit.
///
/// An element whose load, increment or state cannot be taken gets the force and stiffness NaN, and its `after` is not written.
///
/// @param load       n loads [force]
/// @param increment  2 n displacements [length], both of a contact together
/// @param before     n states, that of a contact together
/// @param after      receives n states
/// @param force      receives 2 n forces T [force], both of a contact together
/// @param stiffness  receives 4 n tangents dT/d(increment) [force/length], those of a contact together, row by row
/// @return as `asperity_microslip_step`
#[no_mangle]
pub unsafe extern "C" fn asperity_microslip_steps(
    model: *const asperity_model,
    n: usize,
    load: *const f64,
    increment: *const f64,
    before: *const f64,
    after: *mut f64,
    force: *mut f64,
    stiffness: *mut f64,
) -> asperity_status {
    boundary::status(|| {
        let model = model::of(model)?;
        if n > 0 {
            not_null(load, "load")?;
            not_null(increment, "increment")?;
            not_null(before, "before")?;
        }
        let first_invalid = many(model, StepArrays { n, load, increment, before, after, force, stiffness });
        first_invalid.map_or(Ok(()), |(index, error)| Err(Failure::of_element(index, &error)))
    })
}

/// Turns the state of a contact with its directions, by the angle from the first to the second of a cosine and a sine.
///
/// @param state   `asperity_microslip_length` doubles, changed in place
/// @param cosine  both of any length
/// @param sine    but 0
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (what is not finite; both 0)
#[no_mangle]
pub unsafe extern "C" fn asperity_microslip_turn(state: *mut f64, cosine: f64, sine: f64) -> asperity_status {
    boundary::status(|| {
        not_null(state, "state")?;
        let mut turned = read(state);
        memory::turn(&mut turned, cosine, sine)?;
        write_all(state, 0, &turned);
        Ok(())
    })
}

/// One step by the instructions that this processor has; the state after it is written where there is one.
///
/// # Safety
/// The states have the elements that the entry point asks for.
unsafe fn one(
    model: &Model,
    load: f64,
    increment: [f64; 2],
    before: *const f64,
    after: *mut f64,
) -> Result<MicroslipStep, Error> {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        return one_avx2(model, load, increment, before, after);
    }
    let mut state = read(before);
    let step = model.microslip_step(load, increment, &mut state)?;
    write_all(after, 0, &state);
    Ok(step)
}

/// The caller's arrays of many contacts.
#[derive(Clone, Copy)]
struct StepArrays {
    n: usize,
    load: *const f64,
    increment: *const f64,
    before: *const f64,
    /// May be NULL, as those that follow.
    after: *mut f64,
    force: *mut f64,
    stiffness: *mut f64,
}

/// Steps of all, by the instructions that this processor has; the first that is not in order.
///
/// # Safety
/// The arrays have the elements that the entry point asks for.
unsafe fn many(model: &Model, arrays: StepArrays) -> Option<(usize, Error)> {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") {
        return many_avx2(model, arrays);
    }
    steps::<Portable>(model, arrays)
}

#[inline(always)]
unsafe fn steps<V: Cells>(model: &Model, arrays: StepArrays) -> Option<(usize, Error)> {
    const SOME: usize = 64;
    let mut first_invalid = None;
    let (mut levels, mut state) = (None, [0.0; STATE]);
    let (mut loads, mut strengths, mut stiffnesses) = ([0.0; SOME], [0.0; SOME], [0.0; SOME]);
    for i in 0..arrays.n {
        let k = i % SOME;
        if k == 0 {
            // Force and stiffness of many contacts at once.
            let n = SOME.min(arrays.n - i);
            ptr::copy_nonoverlapping(arrays.load.add(i).cast::<u8>(), loads.as_mut_ptr().cast(), n * size_of::<f64>());
            for (quantity, values) in [(Asked::Force, &mut strengths), (Asked::Stiffness, &mut stiffnesses)] {
                let value = values.as_mut_ptr();
                batch::fill(model, quantity, Arrays { n, load: loads.as_ptr(), value, slope: ptr::null_mut() });
            }
        }
        copy(arrays.before.add(STATE * i), state.as_mut_ptr(), STATE);
        let (load, increment) = (loads[k], read(arrays.increment.add(2 * i)));
        let all = [strengths[k], stiffnesses[k]].map(|value| Sloped { value, slope: 0.0 });
        let step = match model.step::<V, false>(load, all, increment, &mut state, &mut levels) {
            Ok(step) => step,
            Err(error) => {
                let step = of_error(&error);
                first_invalid.get_or_insert((i, error));
                step
            }
        };
        if !nan(step.force[0]) {
            write_all(arrays.after, STATE * i, &state);
        }
        write_all(arrays.force, 2 * i, &step.force);
        write_all(arrays.stiffness, 4 * i, &step.stiffness);
    }
    first_invalid
}

/// What the arrays get where there is no answer: an open contact resists nothing.
#[cold]
fn of_error(error: &Error) -> MicroslipStep {
    let number = if matches!(error, Error::Separated { .. }) { 0.0 } else { f64::NAN };
    MicroslipStep { force: [number; 2], stiffness: [number; 4], ..MicroslipStep::default() }
}

/// # Safety
/// The processor has the instructions; the same of the next.
#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn one_avx2(
    model: &Model,
    load: f64,
    increment: [f64; 2],
    before: *const f64,
    after: *mut f64,
) -> Result<MicroslipStep, Error> {
    let mut state = std::mem::MaybeUninit::<[f64; STATE]>::uninit();
    copy(before, state.as_mut_ptr().cast(), STATE);
    let state = state.assume_init_mut();
    let step = model.step::<Avx2, true>(load, model.strength_and_stiffness(load), increment, state, &mut None)?;
    write_all(after, 0, state);
    Ok(step)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn many_avx2(model: &Model, arrays: StepArrays) -> Option<(usize, Error)> {
    steps::<Avx2>(model, arrays)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
unsafe fn lay_avx2(reach: f64, is_linear: bool, state: &mut [f64; STATE], edges: &mut [memory::PerEdge; 2]) {
    memory::lay::<Avx2>(reach, is_linear, state, edges);
}

#[cfg(target_arch = "x86_64")]
impl Cells for Avx2 {
    #[inline(always)]
    fn lay(reach: f64, is_linear: bool, state: &mut [f64; STATE], edges: &mut [memory::PerEdge; 2]) {
        // SAFETY: where there is one, the processor has the instructions.
        unsafe { lay_avx2(reach, is_linear, state, edges) }
    }
}

/// Numbers of the caller, which need not be aligned. By fours, as the step reads them: what is read otherwise than it was just
/// written has to wait.
#[inline(always)]
unsafe fn read<const N: usize>(from: *const f64) -> [f64; N] {
    let mut numbers = [0.0; N];
    copy(from, numbers.as_mut_ptr(), N);
    numbers
}

#[inline(always)]
unsafe fn write_all<const N: usize>(out: *mut f64, index: usize, values: &[f64; N]) {
    if !out.is_null() {
        copy(values.as_ptr(), out.add(index), N);
    }
}

#[inline(always)]
unsafe fn copy(from: *const f64, to: *mut f64, count: usize) {
    for i in (0..count - count % 4).step_by(4) {
        to.add(i).cast::<[f64; 4]>().write_unaligned(from.add(i).cast::<[f64; 4]>().read_unaligned());
    }
    for i in count - count % 4..count {
        to.add(i).write_unaligned(from.add(i).read_unaligned());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Params;

    fn one(model: &Model, load: f64, by: [f64; 2], state: &mut [f64; STATE]) -> Result<MicroslipStep, Error> {
        // SAFETY: a state.
        unsafe { super::one(model, load, by, state.as_ptr(), state.as_mut_ptr()) }
    }

    /// A contact that sticks is told before its state is looked at whole.
    #[test]
    fn at_the_load_of_the_step_before_a_state_that_is_none_is_refused_and_a_displacement_is_followed() {
        let model = Model::new(&Params::paper()).expect("a model");
        let (load, length) = (10.0, model.friction_force_at_load(10.0) / model.tangential_stiffness_at_load(10.0));
        let mut stuck = [0.0; STATE];
        let by = [1e-4 * length, -2e-4 * length];
        let first = one(&model, load, by, &mut stuck).expect("a step");
        let slope = model.tangential_stiffness_at_load(10.001) - model.tangential_stiffness_at_load(9.999);
        for times in 2..5 {
            let found = one(&model, load, by, &mut stuck).expect("a step");
            for (axis, by) in by.into_iter().enumerate() {
                assert!((found.force[axis] / first.force[axis] - f64::from(times)).abs() < 1e-12);
                assert!((found.dforce_dload[axis] / (0.5 * by * slope / 0.002) - 1.0).abs() < 1e-3);
            }
            assert!(found.slipping == 0.0 && found.dissipated == 0.0);
        }
        for wrong in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
            for place in 0..STATE {
                let mut state = stuck;
                state[place] = wrong;
                let refused = one(&model, load, by, &mut state);
                assert!(matches!(refused, Err(Error::InvalidEntry { name: "before", .. })), "{place}: {refused:?}");
            }
            assert!(one(&model, load, [wrong, 0.0], &mut { stuck }).is_err());
            assert!(one(&model, wrong, by, &mut { stuck }).is_err());
        }
        let far = one(&model, load, [1e200, 0.0], &mut stuck).expect("a step");
        assert!((far.force[0] / model.friction_force_at_load(load) - 1.0).abs() < 1e-12);
    }

    /// The functions of this processor and those of any, over a path that turns while the load changes.
    #[test]
    fn every_processor_gives_the_same_bits() {
        let model = Model::new(&Params::paper()).expect("a model");
        let (mut state, mut portable) = ([0.0; STATE], [0.0; STATE]);
        for i in 0..2000 {
            let load = 1e-3 * 10_f64.powf(f64::from(i * 37 % 60) / 10.0);
            let length = model.friction_force_at_load(load) / model.tangential_stiffness_at_load(load);
            let increment = [7, 11].map(|k| (f64::from(i * k % 23) / 11.0 - 1.0) * length);
            let before = state;
            let found = one(&model, load, increment, &mut state).expect("a step");
            let expected = model.microslip_step(load, increment, &mut portable);
            assert_eq!((Ok(found), state), (expected, portable), "{i}");
            let (mut after, mut force, mut stiffness) = ([0.0; STATE], [0.0; 2], [0.0; 4]);
            let arrays = StepArrays {
                n: 1,
                load: &load,
                increment: increment.as_ptr(),
                before: before.as_ptr(),
                after: after.as_mut_ptr(),
                force: force.as_mut_ptr(),
                stiffness: stiffness.as_mut_ptr(),
            };
            // SAFETY: arrays of one contact.
            assert!(unsafe { many(&model, arrays) }.is_none());
            assert_eq!((after, force, stiffness), (state, found.force, found.stiffness), "{i}");
        }
    }
}
