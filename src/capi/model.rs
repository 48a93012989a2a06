//! Making, changing and freeing models.

use super::boundary::{self, reference, reference_mut, Failure};
use super::params::asperity_params;
use super::status::asperity_status;
use crate::model::Model;

/// A friction law ready for use; opaque.
pub struct asperity_model {
    pub(super) model: Model,
}

/// Makes a model: checks the parameters, finds the pull-off load, compiles the law.
///
/// Free it with `asperity_free`. The parameters are copied.
///
/// @param params  the surfaces; must not be NULL
/// @param model   receives the model; must not be NULL; `*model` is untouched on failure
/// @return `ASPERITY_OK`, `ASPERITY_NULL_POINTER`, `ASPERITY_INVALID_PARAMETER`, `ASPERITY_OUT_OF_RANGE`,
///         `ASPERITY_NOT_CONVERGED`
///
/// Threads: any.
#[no_mangle]
pub unsafe extern "C" fn asperity_create(
    params: *const asperity_params,
    model: *mut *mut asperity_model,
) -> asperity_status {
    boundary::status(|| {
        let params = reference(params, "params")?;
        let out = reference_mut(model, "model")?;
        let model = Model::new(&params.to_params()?)?;
        *out = Box::into_raw(Box::new(asperity_model { model }));
        Ok(())
    })
}

/// Gives a model other parameters, all or nothing: on failure it is as before.
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
        let params = reference(params, "params")?;
        handle.model = Model::new(&params.to_params()?)?;
        Ok(())
    })
}

/// Copies the parameters of a model out.
///
/// @param model   must not be NULL
/// @param params  receives the parameters; must not be NULL; its `struct_size` need not be set
/// @return `ASPERITY_OK` or `ASPERITY_NULL_POINTER`
///
/// Threads: may share the model.
#[no_mangle]
pub unsafe extern "C" fn asperity_get_params(
    model: *const asperity_model,
    params: *mut asperity_params,
) -> asperity_status {
    boundary::status(|| {
        let handle = reference(model, "model")?;
        if params.is_null() {
            return Err(Failure::Null("params"));
        }
        // SAFETY: the caller gives memory for the struct, which need not be initialised.
        params.write(asperity_params::from_params(handle.model.params()));
        Ok(())
    })
}

/// Frees a model.
///
/// @param model  a model, once; NULL is fine
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
