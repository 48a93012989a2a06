//! Evaluation over arrays, a vector of contacts at a time where the processor has vectors.
//!
//! Every path does the same operations in the same order, without fused multiply-add, so that an element has the same
//! bits in a batch of any size, on any processor, and asked alone. Elements that the table does not answer, or that
//! need care, are left to the scalar call.

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod lanes;

use super::boundary::{write, Failure};
use super::fp_environment;
use crate::error::Error;
use crate::law::{Beyond, Quantity, Table};
use crate::model::Model;
use crate::numerics::float_bits::{moderate, nan, tame};

/// Which law is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Asked {
    /// Friction coefficient.
    Coefficient,
    /// Friction force.
    Force,
    /// Tangential stiffness.
    Stiffness,
    /// Load; its argument is minus the gap, in place of a load.
    Load,
}

impl Asked {
    /// What its table has, against load.
    #[inline]
    const fn tabulated(self) -> Quantity {
        match self {
            Self::Stiffness => Quantity::Radius,
            _ => Quantity::Friction,
        }
    }

    /// The table that answers.
    #[inline]
    pub fn table(self, model: &Model) -> &Table {
        match self {
            Self::Load => model.load_table(),
            _ => model.table(self.tabulated()),
        }
    }

    /// The quantity at one argument and its slope by that.
    #[inline]
    pub fn at(self, model: &Model, load: f64) -> (f64, f64) {
        let answer = match self {
            Self::Coefficient => model.tabulated_coefficient(load),
            Self::Load => model.tabulated_load(load),
            _ => model.tabulated(self.tabulated(), load),
        };
        answer.unwrap_or_else(|| self.beside_table(model, load))
    }

    /// The same where the table does not answer.
    #[inline(always)]
    pub fn beside_table(self, model: &Model, load: f64) -> (f64, f64) {
        let answer = match self {
            Self::Coefficient => model.known_coefficient(load),
            Self::Load => model.known_load(load),
            _ => model.known_value(self.tabulated(), load),
        };
        answer.unwrap_or_else(|| self.continued(model, load))
    }

    /// What answers beyond the table.
    #[inline(always)]
    fn beyond(self, model: &Model) -> &Beyond {
        match self {
            Self::Load => model.load_beyond(),
            _ => model.beyond(self.tabulated()),
        }
    }

    #[inline(always)]
    fn continued(self, model: &Model, load: f64) -> (f64, f64) {
        let beyond = self.beyond(model);
        if tame(load) && beyond.is_moderate(load) && (self != Self::Coefficient || moderate(load)) {
            self.of_tabulated(model, load, beyond.at_moderate(load))
        } else {
            fp_environment::held(|| self.of_tabulated(model, load, beyond.at(load)))
        }
    }

    /// From what tables have at a load.
    #[inline(always)]
    fn of_tabulated(self, model: &Model, load: f64, (value, slope): (f64, f64)) -> (f64, f64) {
        match self {
            Self::Coefficient => model.coefficient_and_slope(load, value, slope),
            _ => (value, slope),
        }
    }

    /// Whether there is a contact at an argument.
    fn validate(self, model: &Model, load: f64) -> Result<(), Error> {
        match self {
            Self::Load => model.validate_gap(-load),
            _ => model.validate_load(load),
        }
    }

    /// Whether an argument has no answer.
    pub fn is_invalid(self, model: &Model, load: f64) -> bool {
        nan(self.at(model, load).0) || self.validate(model, load).is_err()
    }

    /// What is said of an element without an answer.
    pub fn failure(self, model: &Model, index: usize, load: f64) -> Failure {
        let error = self.validate(model, load).err().unwrap_or_else(|| match self {
            Self::Load => Model::no_load_at(-load),
            _ => Model::not_evaluated(load),
        });
        Failure::of_element(index, &error)
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

/// The first argument of a batch that has no answer, and its index.
pub type FirstInvalid = Option<(usize, f64)>;

/// Fills all elements, then reports the first invalid load.
///
/// # Safety
/// The arrays have n elements; `load` is not NULL unless n = 0.
pub unsafe fn evaluate(model: &Model, quantity: Asked, arrays: Arrays) -> Result<(), Failure> {
    let first_invalid = fill(model, quantity, arrays);
    first_invalid.map_or(Ok(()), |(index, load)| Err(quantity.failure(model, index, load)))
}

/// Fills all elements; the first that is invalid.
///
/// # Safety
/// As [`evaluate`].
pub unsafe fn fill(model: &Model, quantity: Asked, arrays: Arrays) -> FirstInvalid {
    let mut first_invalid = None;
    let done = vectors(model, quantity, arrays, &mut first_invalid);
    for i in done..arrays.n {
        one(model, quantity, arrays, i, arrays.load.add(i).read_unaligned(), &mut first_invalid);
    }
    first_invalid
}

/// One element, by the scalar call; `load` is what the input held before any output was written.
#[inline]
unsafe fn one(
    model: &Model,
    quantity: Asked,
    arrays: Arrays,
    index: usize,
    load: f64,
    first_invalid: &mut FirstInvalid,
) {
    let (value, slope) = quantity.at(model, load);
    if first_invalid.is_none() && (nan(value) || quantity.validate(model, load).is_err()) {
        *first_invalid = Some((index, load));
    }
    write(arrays.value, index, value);
    write(arrays.slope, index, slope);
}

/// As many elements as fill vectors; how many those are.
#[cfg(target_arch = "x86_64")]
unsafe fn vectors(model: &Model, quantity: Asked, arrays: Arrays, first_invalid: &mut FirstInvalid) -> usize {
    if is_x86_feature_detected!("avx2") {
        return lanes::evaluate(model, quantity, arrays, first_invalid);
    }
    0
}

#[cfg(not(target_arch = "x86_64"))]
unsafe fn vectors(_: &Model, _: Asked, _: Arrays, _: &mut FirstInvalid) -> usize {
    0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::by_gap;
    use crate::params::Params;

    /// Scalar and batch calls would have the same bits too if both asked the wrong law.
    #[test]
    fn each_quantity_is_that_of_the_model_within_its_table_and_beyond() {
        let model = Model::new(&Params::paper()).expect("a model");
        for depth in [0.0, 1e3, 1e5, 1e7, 1e12] {
            let gap = -depth * model.params().height_std;
            let (load, slope) = Asked::Load.at(&model, -gap);
            assert_eq!((load, by_gap(slope)), model.load_and_slope_at_gap(gap), "{depth:e}");
        }
        for times in [1e-3, 2.0, 1e6, 1e12] {
            let load = times * model.summary().max_table_load;
            for (quantity, expected) in [
                (Asked::Coefficient, model.friction_at_load(load)),
                (Asked::Force, model.friction_force_at_load(load)),
                (Asked::Stiffness, model.tangential_stiffness_at_load(load)),
            ] {
                assert_eq!(quantity.at(&model, load).0, expected, "{quantity:?}, {times:e}");
            }
        }
    }

    /// All others cost twenty to sixty times as much. A pull-off load of -2.2e-11, none, -4e-50 and -3e-138.
    #[test]
    fn loads_of_a_solver_need_no_environment_of_their_own() {
        let mut surfaces = vec![Params::paper(), Params { work_of_adhesion: 0.0, ..Params::paper() }];
        for skew in [0.8, 1.0] {
            let mut params = Params::paper();
            params.set_skew(skew).expect("a skew");
            surfaces.push(params);
        }
        for params in surfaces {
            let model = Model::new(&params).expect("a model");
            let (summary, sigma) = (model.summary(), params.height_std);
            let (pull_off, half) = (summary.pull_off_load, model.load_at_gap(0.0).abs());
            for i in 1..400 {
                let part = 1e-60_f64.powf(f64::from(i) / 400.0);
                let loads = [0.999 * pull_off, -0.5 * pull_off].map(|load| load * part.max(1e-3));
                for load in loads.into_iter().chain([half * part, half / part, half * (1.0 + part)]) {
                    for quantity in [Asked::Coefficient, Asked::Force, Asked::Stiffness] {
                        let is_known = quantity.table(&model).at_load(load).is_some()
                            || load <= 0.0 && (quantity == Asked::Coefficient || load == 0.0);
                        let is_few = is_known || quantity.beyond(&model).is_moderate(load);
                        assert!(is_few, "{quantity:?} at {load:e} of {pull_off:e}");
                    }
                }
                let gap = -sigma * 1e-12 / part;
                let is_known = Asked::Load.table(&model).at_load(-gap).is_some();
                assert!(is_known || model.load_beyond().is_moderate(-gap), "at {gap:e}");
            }
        }
    }
}
