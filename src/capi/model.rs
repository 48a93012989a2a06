//! Making, changing and freeing models.

use super::batch::Asked;
use super::boundary::write;
use super::boundary::{self, reference, reference_mut, Failure};
use super::params::{asperity_params, check_size};
use super::scalar::{self, ScalarCall, SlopeCall};
use super::status::asperity_status;
use crate::model::Model;

/// A friction law ready for use; opaque. `asperity_create` makes it, `asperity_free` frees it.
pub struct asperity_model {
    pub(super) model: Model,
    scalar_calls: [ScalarCall; 4],
    slope_calls: [SlopeCall; 4],
}

/// The model of a caller.
///
/// # Safety
/// `model` is NULL or a model that lives as long as the call.
pub(super) unsafe fn of<'a>(model: *const asperity_model) -> Result<&'a Model, Failure> {
    Ok(&reference(model, "model")?.model)
}

/// A quantity at its argument by a model of a caller; NaN without one.
///
/// # Safety
/// As [`of`].
#[inline(always)]
pub(super) unsafe fn value_at(model: *const asperity_model, quantity: Asked, at: f64) -> f64 {
    model.as_ref().map_or(f64::NAN, |handle| (handle.scalar_calls[quantity as usize])(&handle.model, at))
}

/// The same with its slope, which is written if there is where.
///
/// # Safety
/// As [`of`], and there is room for the slope.
#[inline(always)]
pub(super) unsafe fn with_slope(model: *const asperity_model, quantity: Asked, at: f64, slope: *mut f64) -> f64 {
    match model.as_ref() {
        Some(handle) => (handle.slope_calls[quantity as usize])(&handle.model, at, slope),
        None => {
            write(slope, 0, f64::NAN);
            f64::NAN
        }
    }
}

impl asperity_model {
    unsafe fn new(params: *const asperity_params) -> Result<Self, Failure> {
        let params = asperity_params::read(params)?.to_params()?;
        Ok(Self::of(Model::new(&params)?))
    }

    fn of(model: Model) -> Self {
        Self { model, scalar_calls: scalar::calls(), slope_calls: scalar::slope_calls() }
    }
}

/// Makes a model: checks the parameters, finds the pull-off load, and compiles the law into a table, in milliseconds.
///
/// The library copies the parameters. Free the model with `asperity_free`.
///
/// @param params  the surfaces
/// @param model   receives the model
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`,
///         `ASPERITY_NOT_CONVERGED`; `asperity_last_error` says which parameter and what is allowed
#[no_mangle]
pub unsafe extern "C" fn asperity_create(
    params: *const asperity_params,
    model: *mut *mut asperity_model,
) -> asperity_status {
    boundary::status(|| {
        let out = reference_mut(model, "model")?;
        *out = Box::into_raw(Box::new(asperity_model::new(params)?));
        Ok(())
    })
}

/// Makes the model of the same surfaces after a largest load: of a joint that was tightened, and now vibrates.
///
/// Up to the largest load, asperities that yielded spring back elastically, and every call answers for that: at the same load the gap
/// is smaller and friction, area, stiffness and conductance are larger than at first loading. Above the largest load first loading goes
/// on. Contacts that do not yield are as before. It takes two to three times as long as `asperity_create`. Free the model with
/// `asperity_free`; `asperity_set_params` makes it one of first loading.
///
/// Steps of microslip on this model know the largest load of each contact. Those of a contact that has borne more than `largest_load`
/// unload from there, with a force and a stiffness that are interpolated between two branches, to 2 %. The first such step for each
/// binade of largest loads makes a branch, in some 10 ms and 40 kB, and needs the stack of `asperity_create`; the others allocate
/// nothing. For a joint whose loads are not known yet, pass the smallest.
///
/// @param model         the surfaces, at first loading or after a smaller largest load
/// @param largest_load  the largest load that they have borne [force], > 0 and below `max_table_load` of `asperity_summary_of`
/// @param unloaded      receives the model
/// @return as `asperity_create`, `ASPERITY_INVALID_LOAD`, `ASPERITY_SEPARATED`; `ASPERITY_OUT_OF_RANGE` also with adhesion, of which
///         unloading is not modelled, and for a load below the largest load of the model
#[no_mangle]
pub unsafe extern "C" fn asperity_unloaded(
    model: *const asperity_model,
    largest_load: f64,
    unloaded: *mut *mut asperity_model,
) -> asperity_status {
    boundary::status(|| {
        let (model, out) = (of(model)?, reference_mut(unloaded, "unloaded")?);
        *out = Box::into_raw(Box::new(asperity_model::of(model.unloaded(largest_load)?)));
        Ok(())
    })
}

/// Gives a model other parameters; on failure the model is as before.
///
/// @param params  the new parameters
/// @return as `asperity_create`
///
/// No other thread may use the model during the call.
#[no_mangle]
pub unsafe extern "C" fn asperity_set_params(
    model: *mut asperity_model,
    params: *const asperity_params,
) -> asperity_status {
    boundary::status(|| {
        let handle = reference_mut(model, "model")?;
        *handle = asperity_model::new(params)?;
        Ok(())
    })
}

/// Copies the parameters of a model.
///
/// A table of heights is not copied: the pointers lead to the model's own, until `asperity_set_params` or `asperity_free`.
///
/// @param params  receives the parameters
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (`struct_size`)
#[no_mangle]
pub unsafe extern "C" fn asperity_get_params(
    model: *const asperity_model,
    params: *mut asperity_params,
) -> asperity_status {
    boundary::status(|| {
        let handle = reference(model, "model")?;
        check_size(*reference(params.cast::<u64>(), "params")?)?;
        *params = asperity_params::from_params(handle.model.params());
        Ok(())
    })
}

/// Frees a model.
///
/// @param model  a model that has not been freed; NULL is allowed and does nothing
///
/// No other thread may use the model any more.
#[no_mangle]
pub unsafe extern "C" fn asperity_free(model: *mut asperity_model) {
    boundary::status(|| {
        if !model.is_null() {
            drop(Box::from_raw(model));
        }
        Ok(())
    });
}
