//! Four lanes: AVX2.

use super::lanes::{self, inlined, Lanes, Limits, Other};
use super::{Arrays, FirstInvalid, Quantity};
use crate::law::Row;
use crate::model::Model;
use std::arch::x86_64::*;
use std::mem::MaybeUninit;
use std::ptr;

/// Evaluates all full vectors; returns how many elements they are.
#[target_feature(enable = "avx2")]
pub unsafe fn evaluate(model: &Model, quantity: Quantity, arrays: Arrays, first_invalid: &mut FirstInvalid) -> usize {
    lanes::evaluate::<__m256d>(model, quantity, arrays, first_invalid)
}

unsafe impl Lanes for __m256d {
    const COUNT: usize = 4;
    /// All bits of a lane set, or none.
    type Mask = __m256d;
    type Bits = __m256i;

    #[target_feature(enable = "avx2")]
    #[inline(never)]
    unsafe fn answer_others<const SLOPE: bool>(
        model: &Model,
        quantity: Quantity,
        limits: &Limits,
        arrays: Arrays,
        others: &mut [MaybeUninit<Other<Self>>],
        first_invalid: &mut FirstInvalid,
    ) {
        lanes::answer_others::<Self, SLOPE>(model, quantity, limits, arrays, others, first_invalid);
    }

    inlined! {
        fn read(at: *const f64) -> Self { _mm256_loadu_pd(at) }
        fn write(self, at: *mut f64) { _mm256_storeu_pd(at, self) }
        fn splat(x: f64) -> Self { _mm256_set1_pd(x) }
        fn add(self, other: Self) -> Self { _mm256_add_pd(self, other) }
        fn sub(self, other: Self) -> Self { _mm256_sub_pd(self, other) }
        fn mul(self, other: Self) -> Self { _mm256_mul_pd(self, other) }
        fn div(self, other: Self) -> Self { _mm256_div_pd(self, other) }
        fn lt(self, other: Self) -> __m256d { _mm256_cmp_pd::<_CMP_LT_OQ>(self, other) }
        fn unordered(self, other: Self) -> __m256d { _mm256_cmp_pd::<_CMP_UNORD_Q>(self, other) }
        fn not_finite(self) -> __m256d {
            let exponent = Self::splat_bits(0x7ff << 52);
            _mm256_castsi256_pd(_mm256_cmpeq_epi64(Self::and_bits(self.bits(), exponent), exponent))
        }
        fn or_where(self, mask: __m256d, other: Self) -> Self { _mm256_blendv_pd(self, other, mask) }
        fn bits(self) -> __m256i { _mm256_castpd_si256(self) }
        fn from_bits(bits: __m256i) -> Self { _mm256_castsi256_pd(bits) }
        fn half_rows(rows: *const Row, offset: &__m256i, from: usize) -> [Self; 4] {
            let lane: &[u64; 4] = &*ptr::from_ref(offset).cast();
            let row = |i: usize| _mm256_load_pd(rows.byte_add(lane[i] as usize).cast::<f64>().add(from));
            let (a0, a1) = (_mm256_unpacklo_pd(row(0), row(1)), _mm256_unpackhi_pd(row(0), row(1)));
            let (a2, a3) = (_mm256_unpacklo_pd(row(2), row(3)), _mm256_unpackhi_pd(row(2), row(3)));
            [
                _mm256_permute2f128_pd::<0x20>(a0, a2),
                _mm256_permute2f128_pd::<0x20>(a1, a3),
                _mm256_permute2f128_pd::<0x31>(a0, a2),
                _mm256_permute2f128_pd::<0x31>(a1, a3),
            ]
        }
        fn gather(numbers: *const f64, index: __m256i) -> Self { _mm256_i64gather_pd::<8>(numbers, index) }
        fn and_bits(a: __m256i, b: __m256i) -> __m256i { _mm256_and_si256(a, b) }
        fn add_bits(a: __m256i, b: __m256i) -> __m256i { _mm256_add_epi64(a, b) }
        fn sub_bits(a: __m256i, b: __m256i) -> __m256i { _mm256_sub_epi64(a, b) }
        fn shift_right(a: __m256i, count: u32) -> __m256i { _mm256_srl_epi64(a, _mm_cvtsi32_si128(count as i32)) }
        fn below(a: __m256i, bound: u64) -> __m256d {
            // The upper halves are 0 as well where nothing is larger than what it is compared with.
            let least = _mm256_min_epu32(a, Self::splat_bits(bound - 1));
            _mm256_castsi256_pd(_mm256_cmpeq_epi64(least, a))
        }
        fn or_mask(a: __m256d, b: __m256d) -> __m256d { _mm256_or_pd(a, b) }
        fn and_mask(a: __m256d, b: __m256d) -> __m256d { _mm256_and_pd(a, b) }
        fn not_mask(a: __m256d) -> __m256d { _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) }
        fn lanes_of(mask: __m256d) -> u32 { _mm256_movemask_pd(mask) as u32 }
    }
}
