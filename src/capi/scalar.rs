//! Friction or stiffness at one load, or the load at one gap, one number: the table's answer in as few instructions as there are, or else
//! the power by which the law goes on.
//!
//! A table cannot panic and its answer needs no stack frame; what lies beside it is out of line, and guarded. A model keeps
//! the addresses of the functions that suit the processor, so that a call does not look for them.

use super::batch::Asked;
use super::boundary::{self, write};
use crate::law::{polynomial, Row, Table};
use crate::model::{by_gap, Model};
use crate::numerics::float_bits::{nan, tame};

/// A quantity at a load, or at minus a gap.
pub type ScalarCall = unsafe extern "C" fn(&Model, f64) -> f64;
/// The same, with its slope, which is written if there is where; of a load by gap.
pub type SlopeCall = unsafe extern "C" fn(&Model, f64, *mut f64) -> f64;

/// The quantities, as constants of functions.
const COEFFICIENT: u8 = Asked::Coefficient as u8;
const FORCE: u8 = Asked::Force as u8;
const STIFFNESS: u8 = Asked::Stiffness as u8;
const LOAD: u8 = Asked::Load as u8;

const fn quantity(of: u8) -> Asked {
    [Asked::Coefficient, Asked::Force, Asked::Stiffness, Asked::Load][of as usize]
}

/// The function of each quantity that suits this processor.
pub fn calls() -> [ScalarCall; 4] {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("bmi2") {
        return [
            avx2::value_at::<COEFFICIENT>,
            avx2::value_at::<FORCE>,
            avx2::value_at::<STIFFNESS>,
            avx2::value_at::<LOAD>,
        ];
    }
    PORTABLE
}

/// The same with slopes.
pub fn slope_calls() -> [SlopeCall; 4] {
    #[cfg(target_arch = "x86_64")]
    if is_x86_feature_detected!("avx2") && is_x86_feature_detected!("bmi2") {
        return [
            avx2::with_slope::<COEFFICIENT>,
            avx2::with_slope::<FORCE>,
            avx2::with_slope::<STIFFNESS>,
            avx2::with_slope::<LOAD>,
        ];
    }
    PORTABLE_SLOPES
}

const PORTABLE_SLOPES: [SlopeCall; 4] =
    [with_slope::<COEFFICIENT>, with_slope::<FORCE>, with_slope::<STIFFNESS>, with_slope::<LOAD>];

/// # Safety
/// There is room for the slope, or it is NULL; the functions of other processors ask for their instructions.
unsafe extern "C" fn with_slope<const QUANTITY: u8>(model: &Model, load: f64, slope: *mut f64) -> f64 {
    tabulated_with_slope::<QUANTITY>(model, load, slope, |row, t| polynomial(&row.0, t))
}

#[inline(always)]
unsafe fn tabulated_with_slope<const QUANTITY: u8>(
    model: &Model,
    load: f64,
    slope: *mut f64,
    force: impl FnOnce(&Row, f64) -> (f64, f64),
) -> f64 {
    let table = quantity(QUANTITY).table(model);
    if !tame(load) {
        return beside_rows::<QUANTITY>(model, load, slope);
    }
    let x = load - table.pull_off;
    let Some(index) = table.index_of(x) else {
        return beside_rows::<QUANTITY>(model, load, slope);
    };
    let (force, rate) = force(table.rows.get_unchecked(index), table.within(x));
    // By bits: faster here than a comparison.
    if nan(force) {
        return beside_rows::<QUANTITY>(model, load, slope);
    }
    let found = (force, rate * Table::per_mantissa(x));
    let (value, by_load) = match QUANTITY {
        COEFFICIENT => model.coefficient_and_slope(load, found.0, found.1),
        LOAD => (found.0, by_gap(found.1)),
        _ => found,
    };
    write(slope, 0, by_load);
    value
}

/// What a link leads to, and what the table does not answer.
#[inline(never)]
unsafe extern "C" fn beside_rows<const QUANTITY: u8>(model: &Model, load: f64, slope: *mut f64) -> f64 {
    boundary::contained_value(|| {
        let (value, by_load) = quantity(QUANTITY).at(model, load);
        write(slope, 0, if QUANTITY == LOAD { by_gap(by_load) } else { by_load });
        value
    })
}

const PORTABLE: [ScalarCall; 4] = [value_at::<COEFFICIENT>, value_at::<FORCE>, value_at::<STIFFNESS>, value_at::<LOAD>];

/// # Safety
/// None is needed; the functions of other processors ask for their instructions.
unsafe extern "C" fn value_at<const QUANTITY: u8>(model: &Model, load: f64) -> f64 {
    tabulated::<QUANTITY>(model, load, |row, t| polynomial(&row.0, t).0)
}

#[inline(always)]
fn tabulated<const QUANTITY: u8>(model: &Model, load: f64, force: impl FnOnce(&Row, f64) -> f64) -> f64 {
    let table = quantity(QUANTITY).table(model);
    // Tested by bits: arithmetic with a signalling NaN, or with the largest number, would raise a floating-point exception.
    if !tame(load) {
        return beside_table::<QUANTITY>(model, load);
    }
    let x = load - table.pull_off;
    let Some(index) = table.index_of(x) else {
        return beside_table::<QUANTITY>(model, load);
    };
    // SAFETY: a table has at least as many rows as are found from x.
    let row = unsafe { table.rows.get_unchecked(index) };
    let t = table.within(x);
    let force = force(row, t);
    if QUANTITY != COEFFICIENT {
        return if force.is_nan() { in_part::<QUANTITY>(model, load, row, t) } else { force };
    }
    // RISC-V raises "invalid" where a NaN is compared.
    if cfg!(target_arch = "riscv64") && force.is_nan() {
        return in_part::<QUANTITY>(model, load, row, t);
    }
    // Not for the NaN of a link either.
    if load > force * model.inverse_cap() {
        return force / load;
    }
    if force.is_nan() {
        return in_part::<QUANTITY>(model, load, row, t);
    }
    model.params().max_friction_coefficient
}

/// What a link leads to.
#[inline(never)]
extern "C" fn in_part<const QUANTITY: u8>(model: &Model, load: f64, row: &Row, t: f64) -> f64 {
    let (part, t) = quantity(QUANTITY).table(model).part_at(row, t);
    let force = polynomial(&part.0, t).0;
    if QUANTITY == COEFFICIENT {
        model.coefficient(load, force)
    } else {
        force
    }
}

/// What the table does not answer.
#[inline(never)]
extern "C" fn beside_table<const QUANTITY: u8>(model: &Model, load: f64) -> f64 {
    boundary::contained_value(|| quantity(QUANTITY).beside_table(model, load).0)
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use crate::law::Row;
    use crate::model::Model;
    use std::arch::x86_64::*;

    /// # Safety
    /// The processor has the instructions.
    #[target_feature(enable = "avx2,bmi2")]
    pub unsafe extern "C" fn value_at<const QUANTITY: u8>(model: &Model, load: f64) -> f64 {
        super::tabulated::<QUANTITY>(model, load, |row, t| unsafe { polynomial(row, t) })
    }

    /// # Safety
    /// The processor has the instructions, and there is room for the slope.
    #[target_feature(enable = "avx2,bmi2")]
    pub unsafe extern "C" fn with_slope<const QUANTITY: u8>(model: &Model, load: f64, slope: *mut f64) -> f64 {
        super::tabulated_with_slope::<QUANTITY>(model, load, slope, |row, t| polynomial_and_slope(row, t))
    }

    /// [`crate::law::polynomial`], its four lines side by side: the same operations in the same order.
    #[inline(always)]
    unsafe fn polynomial(row: &Row, t: f64) -> f64 {
        let (even, odd) = coefficients(row);
        // c0 + c1 t, c4 + c5 t, c2 + c3 t, c6 + c7 t
        let lines = _mm256_add_pd(even, _mm256_mul_pd(odd, _mm256_set1_pd(t)));
        let t2 = t * t;
        let cubics =
            _mm_add_pd(_mm256_castpd256_pd128(lines), _mm_mul_pd(_mm256_extractf128_pd::<1>(lines), _mm_set1_pd(t2)));
        _mm_cvtsd_f64(cubics) + _mm_cvtsd_f64(_mm_unpackhi_pd(cubics, cubics)) * (t2 * t2)
    }

    /// The same with its derivative, of which the lines are c1 + 2 c2 t, 5 c5 + 6 c6 t, 3 c3 + 4 c4 t and 7 c7.
    #[inline(always)]
    unsafe fn polynomial_and_slope(row: &Row, t: f64) -> (f64, f64) {
        let (even, odd) = coefficients(row);
        let (wide, t2) = (_mm256_set1_pd(t), t * t);
        let lines = _mm256_add_pd(even, _mm256_mul_pd(odd, wide));
        let constant = _mm256_mul_pd(odd, _mm256_setr_pd(1.0, 5.0, 3.0, 7.0));
        let linear = _mm256_mul_pd(_mm256_permute4x64_pd::<0b00_01_11_10>(even), _mm256_setr_pd(2.0, 6.0, 4.0, 0.0));
        let slopes = _mm256_add_pd(constant, _mm256_mul_pd(linear, wide));
        let low = _mm256_permute2f128_pd::<0x20>(lines, slopes);
        let high = _mm256_permute2f128_pd::<0x31>(lines, slopes);
        let cubics = _mm256_add_pd(low, _mm256_mul_pd(high, _mm256_set1_pd(t2)));
        let beyond = _mm256_mul_pd(_mm256_unpackhi_pd(cubics, cubics), _mm256_set1_pd(t2 * t2));
        let both = _mm256_add_pd(cubics, beyond);
        (_mm256_cvtsd_f64(both), _mm_cvtsd_f64(_mm256_extractf128_pd::<1>(both)))
    }

    /// c0, c4, c2, c6, and c1, c5, c3, c7.
    #[inline(always)]
    unsafe fn coefficients(row: &Row) -> (__m256d, __m256d) {
        let (low, high) = (_mm256_load_pd(row.0.as_ptr()), _mm256_load_pd(row.0.as_ptr().add(4)));
        (_mm256_unpacklo_pd(low, high), _mm256_unpackhi_pd(low, high))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::neighbours::Neighbours;
    use crate::params::Params;

    /// The function of this processor and that of any, within the table, beyond it, and where friction is capped.
    #[test]
    fn every_processor_gives_the_same_bits() {
        let model = Model::new(&Params::paper()).expect("a model");
        let summary = model.summary();
        for i in 0..400 {
            let excess = 1e-12 * 1e20_f64.powf(f64::from(i) / 400.0);
            let arguments =
                [summary.pull_off_load * (1.0 - excess), excess, -excess, 1e3 * excess, f64::NAN, f64::INFINITY];
            for load in arguments {
                for (of, call) in PORTABLE.into_iter().chain(calls()).enumerate() {
                    // SAFETY: a function of any processor, or of this one.
                    let found = unsafe { call(&model, load) };
                    let expected = quantity(of as u8 % 4).at(&model, load).0;
                    assert_eq!(found.to_bits(), expected.to_bits(), "{of} at {load:e}: {found:e}, not {expected:e}");
                }
                for (of, call) in PORTABLE_SLOPES.into_iter().chain(slope_calls()).enumerate() {
                    let mut slope = 0.0;
                    // SAFETY: as above, and there is room for a slope.
                    let found = unsafe { call(&model, load, &mut slope) };
                    let (value, by_load) = quantity(of as u8 % 4).at(&model, load);
                    let expected = [value, if of % 4 == 3 { by_gap(by_load) } else { by_load }];
                    assert_eq!([found, slope].map(f64::to_bits), expected.map(f64::to_bits), "{of} at {load:e}");
                }
            }
        }
    }

    /// The lightest load that is not capped and the heaviest that is, for caps of many last bits.
    #[test]
    fn the_cap_ends_at_the_same_load_for_every_call() {
        for k in 0..40 {
            let max_friction_coefficient = 0.3 + 0.017 * f64::from(k);
            let model = Model::new(&Params { max_friction_coefficient, ..Params::paper() }).expect("a model");
            let is_capped = |load: f64| load <= model.friction_force_at_load(load) * model.inverse_cap();
            let (mut capped, mut other) = (1e-3, 1e6);
            while other > capped.above() {
                let middle = 0.5 * (capped + other);
                *if is_capped(middle) { &mut capped } else { &mut other } = middle;
            }
            for load in [capped, other] {
                // SAFETY: the function of any processor.
                let found = unsafe { value_at::<COEFFICIENT>(&model, load) };
                assert_eq!(found, model.friction_at_load(load), "{load:e} {max_friction_coefficient}");
            }
        }
    }
}
