//! A contact that remembers: one step of one contact or of many, with the state in the caller's arrays.

use super::boundary::{self, not_null, write, Failure};
use super::model::{self, asperity_model};
use super::output::{fill, same_fields};
use super::status::asperity_status;
use crate::error::Error;
use crate::jenkins::STATE;
use crate::model::MicroslipStep;

/// What resists a displacement of the surfaces along each other.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct asperity_microslip {
    /// Set by the caller to `sizeof(asperity_microslip)`; the library writes no more than that.
    pub struct_size: u64,
    /// T [force], along both directions: positive where it resists a positive displacement. The surface that moves feels -T,
    /// the other T.
    pub force: [f64; 2],
    /// dT/d(increment) [force/length], row by row: T1 by the first, T1 by the second, T2 by the first, T2 by the second.
    /// Symmetric, with eigenvalues from 0 to K_t.
    pub stiffness: [f64; 4],
    /// dT/d(load), of the same increment.
    pub dforce_dload: [f64; 2],
    /// Work that slip turned into heat in this step, >= 0 [force length].
    pub dissipated: f64,
    /// Fraction of the strength that slips, 0 to 1; 1 is gross slip.
    pub slipping: f64,
}

/// How many doubles the state of one contact takes; today 32, the same for all models.
///
/// @param model  a model
/// @return the number of doubles; 0 for a NULL model
///
/// Threads: may share the model.
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
/// The contacts of the surfaces are represented by springs in series with sliders, whose shares were found when the model
/// was made. The force rises with the stiffness K_t (`asperity_tangential_stiffness_at_load`) and ends at the friction force F
/// (`asperity_friction_force_at_load`), in any direction, after any path. After a reversal it follows Masing's rule. It
/// does not depend on time or on the number of steps in which a straight path is taken.
///
/// The caller owns the state, one for each contact: `asperity_microslip_length` doubles, all 0 for a contact that has just
/// closed. They are the forces of the sliders, first all along the first direction, then all along the second [force]; where the
/// directions turn with the contact, turn each pair with them. An iteration repeats the call with the same `before`; the
/// step that is accepted keeps `after`.
///
/// More load on a contact at rest adds stiffness and no force. Less load lets sliders slip that are no longer held. Below
/// the pull-off load the contact is open: force, stiffness and `after` become 0, and the status is `ASPERITY_SEPARATED`. At
/// zero load without adhesion they are 0 too, with `ASPERITY_OK`. At the pull-off load itself, where F and K_t have no
/// finite slope, `dforce_dload` is that of the next load.
///
/// @param model      must not be NULL
/// @param load       normal load of this step [force]
/// @param increment  2 displacements of one surface along the other since `before` [length]; must not be NULL
/// @param before     the state before the step; must not be NULL
/// @param after      receives the state after the step; NULL to skip; may be `before` itself; untouched on failure
/// @param out        receives force, tangents and work; must not be NULL; its `struct_size` must be set; untouched on
///                   failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`; an increment or a state
///         that is not finite), `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED` (outputs are 0), `ASPERITY_OUT_OF_RANGE`
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
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
        let mut state = read(before);
        let mut separated = None;
        fill(out, "out", || {
            let step = match model.microslip_step(load, read(increment), &mut state) {
                Err(error @ Error::Separated { .. }) => {
                    separated = Some(error);
                    MicroslipStep::default()
                }
                other => other?,
            };
            Ok(same_fields! { asperity_microslip of step;
                force stiffness dforce_dload dissipated slipping
            })
        })?;
        write_all(after, 0, &state);
        separated.map_or(Ok(()), |error| Err(error.into()))
    })
}

/// One step of many contacts, each as `asperity_microslip_step` gives it, to the bit.
///
/// All elements are filled; then the first that is not in order, if any, is reported, and `asperity_last_error` names its index.
/// An element whose load, increment or state cannot be taken gets the force and stiffness NaN, and its `after` is not
/// written.
///
/// @param model      must not be NULL
/// @param n          number of contacts; may be 0
/// @param load       n loads [force]; must not be NULL unless n = 0
/// @param increment  2 n displacements [length], both of a contact together; must not be NULL unless n = 0
/// @param before     n states, that of a contact together; must not be NULL unless n = 0
/// @param after      receives n states; NULL to skip; may be `before` itself
/// @param force      receives 2 n forces T [force], both of a contact together; NULL to skip
/// @param stiffness  receives 4 n tangents dT/d(increment) [force/length], those of a contact together, row by row; NULL
///                   to skip
/// @return as `asperity_microslip_step`
///
/// Threads: may share the model. No allocation, no lock, no system call, no floating-point exception.
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
        let mut first_invalid: Option<(usize, Error)> = None;
        for i in 0..n {
            let mut state: [f64; STATE] = read(before.add(STATE * i));
            let taken = model.microslip_step(load.add(i).read_unaligned(), read(increment.add(2 * i)), &mut state);
            let is_apart = matches!(taken, Err(Error::Separated { .. }));
            if taken.is_ok() || is_apart {
                write_all(after, STATE * i, &state);
            }
            let step = taken.unwrap_or_else(|error| {
                first_invalid.get_or_insert((i, error));
                let number = if is_apart { 0.0 } else { f64::NAN };
                MicroslipStep { force: [number; 2], stiffness: [number; 4], ..MicroslipStep::default() }
            });
            write_all(force, 2 * i, &step.force);
            write_all(stiffness, 4 * i, &step.stiffness);
        }
        first_invalid.map_or(Ok(()), |(index, error)| Err(Failure::of_element(index, &error)))
    })
}

/// Numbers of the caller, which need not be aligned.
unsafe fn read<const N: usize>(from: *const f64) -> [f64; N] {
    from.cast::<[f64; N]>().read_unaligned()
}

unsafe fn write_all(out: *mut f64, index: usize, values: &[f64]) {
    for (i, value) in values.iter().enumerate() {
        write(out, index + i, *value);
    }
}
