//! Evaluation over arrays, a vector of contacts at a time where the processor has vectors.
//!
//! Every path does the same operations in the same order, without fused multiply-add, so that an element has the same
//! bits in a batch of any size, on any processor, and asked alone. Elements that the table does not answer, or that
//! need care, are left to the scalar call.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
#[cfg(target_arch = "x86_64")]
mod lanes;

use super::boundary::Failure;
use super::fp_environment;
use crate::model::Model;

/// Which law is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Quantity {
    /// Friction coefficient.
    Coefficient,
    /// Friction force.
    Force,
}

impl Quantity {
    /// The quantity at one load and its slope.
    #[inline]
    pub fn at(self, model: &Model, load: f64) -> (f64, f64) {
        let tabulated = match self {
            Quantity::Coefficient => model.tabulated_coefficient(load),
            Quantity::Force => model.tabulated_force(load),
        };
        tabulated.unwrap_or_else(|| self.exact(model, load))
    }

    #[cold]
    fn exact(self, model: &Model, load: f64) -> (f64, f64) {
        fp_environment::held(|| match self {
            Quantity::Coefficient => model.exact_coefficient(load),
            Quantity::Force => model.exact_force(load),
        })
    }
}

/// The caller's arrays. Raw pointers: outputs may be the input, and need no alignment.
#[derive(Debug, Clone, Copy)]
pub struct Arrays {
    pub n: usize,
    pub load: *const f64,
    /// May be NULL.
    pub value: *mut f64,
    /// May be NULL.
    pub slope: *mut f64,
}

/// Fills all elements, then reports the first offence.
///
/// # Safety
/// The arrays have n elements; `load` is not NULL unless n = 0.
pub unsafe fn evaluate(model: &Model, quantity: Quantity, arrays: Arrays) -> Result<(), Failure> {
    let mut offence = None;
    let done = vectors(model, quantity, arrays, &mut offence);
    for i in done..arrays.n {
        one(model, quantity, arrays, i, arrays.load.add(i).read_unaligned(), &mut offence);
    }
    match offence {
        None => Ok(()),
        Some((index, load)) => Err(model.offence(load).map_or(Failure::Null("load"), |e| Failure::Element(index, e))),
    }
}

/// One element, by the scalar call; `load` is what the input held before any output was written.
#[inline]
unsafe fn one(
    model: &Model,
    quantity: Quantity,
    arrays: Arrays,
    index: usize,
    load: f64,
    offence: &mut Option<(usize, f64)>,
) {
    let (value, slope) = quantity.at(model, load);
    if offence.is_none() && model.offence(load).is_some() {
        *offence = Some((index, load));
    }
    if !arrays.value.is_null() {
        arrays.value.add(index).write_unaligned(value);
    }
    if !arrays.slope.is_null() {
        arrays.slope.add(index).write_unaligned(slope);
    }
}

/// As many elements as fill vectors; how many those are.
#[cfg(target_arch = "x86_64")]
unsafe fn vectors(model: &Model, quantity: Quantity, arrays: Arrays, offence: &mut Option<(usize, f64)>) -> usize {
    if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
        avx512::evaluate(model, quantity, arrays, offence)
    } else if is_x86_feature_detected!("avx2") {
        avx2::evaluate(model, quantity, arrays, offence)
    } else {
        0
    }
}

#[cfg(not(target_arch = "x86_64"))]
unsafe fn vectors(_: &Model, _: Quantity, _: Arrays, _: &mut Option<(usize, f64)>) -> usize {
    0
}
