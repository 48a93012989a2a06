//! Eight lanes: AVX-512 F and DQ.

use super::lanes::{self, inlined, Lanes, Limits, Other};
use super::{Arrays, FirstInvalid, Quantity};
use crate::law::Row;
use crate::model::Model;
use std::arch::x86_64::*;
use std::mem::MaybeUninit;
use std::ptr;

/// Evaluates all full vectors; returns how many elements they are.
#[target_feature(enable = "avx512f,avx512dq")]
pub unsafe fn evaluate(model: &Model, quantity: Quantity, arrays: Arrays, first_invalid: &mut FirstInvalid) -> usize {
    lanes::evaluate::<__m512d>(model, quantity, arrays, first_invalid)
}

unsafe impl Lanes for __m512d {
    const COUNT: usize = 8;
    type Mask = __mmask8;
    type Bits = __m512i;

    #[target_feature(enable = "avx512f,avx512dq")]
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
        fn read(at: *const f64) -> Self { _mm512_loadu_pd(at) }
        fn write(self, at: *mut f64) { _mm512_storeu_pd(at, self) }
        fn splat(x: f64) -> Self { _mm512_set1_pd(x) }
        fn add(self, other: Self) -> Self { _mm512_add_pd(self, other) }
        fn sub(self, other: Self) -> Self { _mm512_sub_pd(self, other) }
        fn mul(self, other: Self) -> Self { _mm512_mul_pd(self, other) }
        fn div(self, other: Self) -> Self { _mm512_div_pd(self, other) }
        fn lt(self, other: Self) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self, other) }
        fn unordered(self, other: Self) -> __mmask8 { _mm512_cmp_pd_mask::<_CMP_UNORD_Q>(self, other) }
        // Quiet NaN, +infinity, -infinity, signalling NaN.
        fn not_finite(self) -> __mmask8 { _mm512_fpclass_pd_mask::<0x99>(self) }
        fn or_where(self, mask: __mmask8, other: Self) -> Self { _mm512_mask_blend_pd(mask, self, other) }
        fn bits(self) -> __m512i { _mm512_castpd_si512(self) }
        fn from_bits(bits: __m512i) -> Self { _mm512_castsi512_pd(bits) }
        fn half_rows(rows: *const Row, offset: &__m512i, from: usize) -> [Self; 4] {
            let lane: &[u64; 8] = &*ptr::from_ref(offset).cast();
            let half = |i: usize| _mm256_load_pd(rows.byte_add(lane[i] as usize).cast::<f64>().add(from));
            // Half rows of lanes i and i + 2 side by side, which costs no shuffle; then pairs, then quarters.
            let two = |i: usize| _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(half(i)), half(i + 2));
            let (a0, a1) = (_mm512_unpacklo_pd(two(0), two(1)), _mm512_unpackhi_pd(two(0), two(1)));
            let (a4, a5) = (_mm512_unpacklo_pd(two(4), two(5)), _mm512_unpackhi_pd(two(4), two(5)));
            [
                _mm512_shuffle_f64x2::<0x88>(a0, a4),
                _mm512_shuffle_f64x2::<0x88>(a1, a5),
                _mm512_shuffle_f64x2::<0xdd>(a0, a4),
                _mm512_shuffle_f64x2::<0xdd>(a1, a5),
            ]
        }
        fn gather(numbers: *const f64, index: __m512i) -> Self { _mm512_i64gather_pd::<8>(index, numbers) }
        fn and_bits(a: __m512i, b: __m512i) -> __m512i { _mm512_and_si512(a, b) }
        fn add_bits(a: __m512i, b: __m512i) -> __m512i { _mm512_add_epi64(a, b) }
        fn sub_bits(a: __m512i, b: __m512i) -> __m512i { _mm512_sub_epi64(a, b) }
        fn shift_right(a: __m512i, count: u32) -> __m512i { _mm512_srl_epi64(a, _mm_cvtsi32_si128(count as i32)) }
        fn below(a: __m512i, bound: u64) -> __mmask8 { _mm512_cmplt_epu64_mask(a, Self::splat_bits(bound)) }
        fn or_mask(a: __mmask8, b: __mmask8) -> __mmask8 { a | b }
        fn and_mask(a: __mmask8, b: __mmask8) -> __mmask8 { a & b }
        fn not_mask(a: __mmask8) -> __mmask8 { !a }
        fn lanes_of(mask: __mmask8) -> u32 { mask.into() }
    }
}
