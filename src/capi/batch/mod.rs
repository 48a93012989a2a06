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
    #[cfg(test)]
    tests::CALLS.set(tests::CALLS.get() + 1);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::params::Params;
    use std::cell::Cell;

    thread_local! {
        /// Elements left to the scalar call.
        pub static CALLS: Cell<usize> = const { Cell::new(0) };
    }

    type Path = unsafe fn(&Model, Quantity, Arrays, &mut Option<(usize, f64)>) -> usize;

    /// The paths of this processor that take whole vectors.
    fn paths() -> Vec<(&'static str, Path)> {
        #[allow(unused_mut)]
        let mut paths: Vec<(_, Path)> = Vec::new();
        #[cfg(target_arch = "x86_64")]
        {
            if is_x86_feature_detected!("avx2") {
                paths.extend([("the one chosen", vectors as Path), ("AVX2", avx2::evaluate)]);
            }
            if is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq") {
                paths.push(("AVX-512", avx512::evaluate));
            }
        }
        paths
    }

    /// Not that one lane which the table does not answer takes others with it: it is answered alone.
    #[test]
    fn loads_that_the_table_answers_are_not_left_to_the_scalar_call() {
        let model = Model::new(&Params::default()).expect("a model");
        let summary = model.summary();
        let pull_off = summary.pull_off_load;
        let part = |i: usize| 1e-3 + 0.998 * i as f64 / 200.0;
        // From where coefficients are not capped.
        let mut loads: Vec<f64> = (0..200).map(|i| summary.max_table_load * 1e-4_f64.powf(1.0 - part(i))).collect();
        let others = [
            f64::NAN,
            f64::INFINITY,
            2.0 * summary.max_table_load,
            1.5 * pull_off,
            pull_off,
            f64::from_bits(0x7ff << 52 | 1),
        ];
        for (i, &other) in others.iter().enumerate() {
            loads[29 * i + 3] = other;
        }
        let (mut value, mut slope) = ([0.0; 200], [0.0; 200]);
        let (load, values, slopes) = (loads.as_ptr(), value.as_mut_ptr(), slope.as_mut_ptr());
        let arrays = Arrays { n: loads.len(), load, value: values, slope: slopes };
        for (name, path) in paths() {
            for quantity in [Quantity::Coefficient, Quantity::Force] {
                for arrays in [arrays, Arrays { slope: std::ptr::null_mut(), ..arrays }] {
                    CALLS.set(0);
                    let mut offence = None;
                    // SAFETY: the arrays have so many elements.
                    let done = unsafe { path(&model, quantity, arrays, &mut offence) };
                    assert_eq!(done, loads.len(), "{name}, {quantity:?}");
                    assert_eq!(CALLS.get(), others.len(), "{name}, {quantity:?}");
                    assert_eq!(offence.map(|(index, _)| index), Some(3), "{name}, {quantity:?}");
                    for (i, &load) in loads.iter().enumerate() {
                        let expected = quantity.at(&model, load);
                        assert_eq!(value[i].to_bits(), expected.0.to_bits(), "{name}, {quantity:?} at {load:e}");
                        assert_eq!(slope[i].to_bits(), expected.1.to_bits(), "{name}, {quantity:?} at {load:e}");
                    }
                }
            }
        }
    }
}
