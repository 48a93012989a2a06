//! Making, changing and freeing models.

use super::batch::Quantity;
use super::boundary::{self, not_null, reference, reference_mut, wrong_struct_size, Failure};
use super::params::{asperity_params, checked_size, FIRST_SIZE};
use super::reserve;
use super::scalar::{self, ScalarCall};
use super::status::asperity_status;
use crate::model::Model;

/// A friction law ready for use; opaque.
pub struct asperity_model {
    pub(super) model: Model,
    scalar_calls: [ScalarCall; 4],
    /// Whether its maker's parameters have fields that their `struct_size` does not cover.
    unannounced_fields: bool,
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
pub(super) unsafe fn value_at(model: *const asperity_model, quantity: Quantity, at: f64) -> f64 {
    model.as_ref().map_or(f64::NAN, |handle| (handle.scalar_calls[quantity as usize])(&handle.model, at))
}

impl asperity_model {
    unsafe fn new(params: *const asperity_params) -> Result<Self, Failure> {
        let params = asperity_params::read(params)?;
        let unannounced_fields = params.end_of_heights() > params.struct_size;
        Ok(Self { model: Model::new(&params.to_params()?)?, scalar_calls: scalar::calls(), unannounced_fields })
    }

    /// Writes its parameters to a caller's struct of a size, with room for perhaps more.
    unsafe fn write_params(&self, params: *mut asperity_params, size: u64, room: u64) -> Result<(), Failure> {
        not_null(params, "params")?;
        let whole = asperity_params { struct_size: size, ..asperity_params::from_params(self.model.params()) };
        if whole.end_of_heights() > room {
            return Err(wrong_struct_size(
                size,
                "must reach the fields that the model's heights read: call asperity_get_params_sized",
            ));
        }
        whole.write(params, room);
        Ok(())
    }
}

/// Makes a model: checks the parameters, finds the pull-off load, compiles the law.
///
/// Free it with `asperity_free`. The parameters are copied.
///
/// @param params  the surfaces; must not be NULL
/// @param model   receives the model; must not be NULL; `*model` is untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`,
///         `ASPERITY_NOT_CONVERGED`, `ASPERITY_OUT_OF_MEMORY`
///
/// Threads: any.
#[no_mangle]
pub unsafe extern "C" fn asperity_create(
    params: *const asperity_params,
    model: *mut *mut asperity_model,
) -> asperity_status {
    boundary::status(|| {
        let out = reference_mut(model, "model")?;
        *out = Box::into_raw(reserve::held(|| Ok(Box::new(asperity_model::new(params)?)))?);
        Ok(())
    })
}

/// Gives a model other parameters. On failure the model is as before.
///
/// @param model   must not be NULL
/// @param params  the new parameters; must not be NULL
/// @return as `asperity_create`
///
/// Threads: no other thread may use the model during the call.
#[no_mangle]
pub unsafe extern "C" fn asperity_set_params(
    model: *mut asperity_model,
    params: *const asperity_params,
) -> asperity_status {
    boundary::status(|| {
        let handle = reference_mut(model, "model")?;
        *handle = reserve::held(|| asperity_model::new(params))?;
        Ok(())
    })
}

/// Copies the parameters of a model.
///
/// A table of heights is not copied: the pointers lead to the model's own copy and are valid until
/// `asperity_set_params` or `asperity_free`. They may be passed to `asperity_set_params` of the same model.
///
/// This function sets `struct_size` and the fields of the first version of the struct, as `asperity_params_init` does,
/// and in C and C++ a macro of its name calls `asperity_get_params_sized` instead. It refuses if the heights need later
/// fields, unless the model was made from a struct that had these although its `struct_size` did not say so.
///
/// @param model   must not be NULL
/// @param params  receives the parameters; must not be NULL; its `struct_size` need not be set; untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (the struct lacks fields)
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_params(
    model: *const asperity_model,
    params: *mut asperity_params,
) -> asperity_status {
    boundary::status(|| {
        let handle = reference(model, "model")?;
        let end_of_heights = asperity_params::from_params(handle.model.params()).end_of_heights();
        handle.write_params(params, FIRST_SIZE, if handle.unannounced_fields { end_of_heights } else { FIRST_SIZE })
    })
}

/// Copies the parameters of a model into a struct of this size, as `asperity_get_params` does.
///
/// @param model        must not be NULL
/// @param params       receives the parameters; must not be NULL; untouched on failure
/// @param struct_size  `sizeof(asperity_params)`: no more than that is written, and it becomes `struct_size`
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER` (no size of a version of the struct, or
///         one that lacks fields which the heights read)
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_params_sized(
    model: *const asperity_model,
    params: *mut asperity_params,
    struct_size: u64,
) -> asperity_status {
    boundary::status(|| {
        let size = checked_size(struct_size)?;
        reference(model, "model")?.write_params(params, size, size)
    })
}

/// Frees a model.
///
/// @param model  a model that has not been freed; NULL is allowed and does nothing
///
/// Threads: no other thread may use the model any more.
#[no_mangle]
pub unsafe extern "C" fn asperity_free(model: *mut asperity_model) {
    boundary::status(|| {
        if !model.is_null() {
            drop(Box::from_raw(model));
        }
        Ok(())
    });
}
