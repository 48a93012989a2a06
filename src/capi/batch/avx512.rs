//! Eight lanes: AVX-512 F and DQ.

use super::lanes::{self, Lanes};
use super::{Arrays, Quantity};
use crate::law::{Row, COEFFICIENTS};
use crate::model::Model;
use std::arch::x86_64::*;
use std::ptr;

/// Evaluates all full vectors; returns how many elements they are.
#[target_feature(enable = "avx512f,avx512dq")]
pub unsafe fn evaluate(model: &Model, quantity: Quantity, arrays: Arrays, offence: &mut Option<(usize, f64)>) -> usize {
    lanes::evaluate::<__m512d>(model, quantity, arrays, offence)
}

/// Coefficients `from` to `from` + 3 of the rows of all lanes.
#[inline(always)]
unsafe fn transposed_half(rows: *const Row, lane: &[u64; 8], from: usize) -> [__m512d; 4] {
    // Half rows of lanes i and i + 2 side by side, which costs no shuffle; then pairs, then quarters.
    let (r0, r1) = (half_rows(rows, lane, 0, from), half_rows(rows, lane, 1, from));
    let (r4, r5) = (half_rows(rows, lane, 4, from), half_rows(rows, lane, 5, from));
    let (a0, a1) = (_mm512_unpacklo_pd(r0, r1), _mm512_unpackhi_pd(r0, r1));
    let (a4, a5) = (_mm512_unpacklo_pd(r4, r5), _mm512_unpackhi_pd(r4, r5));
    [
        _mm512_shuffle_f64x2::<0x88>(a0, a4),
        _mm512_shuffle_f64x2::<0x88>(a1, a5),
        _mm512_shuffle_f64x2::<0xdd>(a0, a4),
        _mm512_shuffle_f64x2::<0xdd>(a1, a5),
    ]
}

#[inline(always)]
unsafe fn half_rows(rows: *const Row, lane: &[u64; 8], i: usize, from: usize) -> __m512d {
    let low = _mm256_load_pd(rows.byte_add(lane[i] as usize).cast::<f64>().add(from));
    let high = _mm256_load_pd(rows.byte_add(lane[i + 2] as usize).cast::<f64>().add(from));
    _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(low), high)
}

unsafe impl Lanes for __m512d {
    const COUNT: usize = 8;
    type Mask = __mmask8;
    type Bits = __m512i;

    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        _mm512_loadu_pd(at)
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut f64) {
        _mm512_storeu_pd(at, self)
    }
    #[inline(always)]
    unsafe fn splat(x: f64) -> Self {
        _mm512_set1_pd(x)
    }
    #[inline(always)]
    unsafe fn add(self, other: Self) -> Self {
        _mm512_add_pd(self, other)
    }
    #[inline(always)]
    unsafe fn sub(self, other: Self) -> Self {
        _mm512_sub_pd(self, other)
    }
    #[inline(always)]
    unsafe fn mul(self, other: Self) -> Self {
        _mm512_mul_pd(self, other)
    }
    #[inline(always)]
    unsafe fn div(self, other: Self) -> Self {
        _mm512_div_pd(self, other)
    }
    #[inline(always)]
    unsafe fn div_where(self, mask: __mmask8, other: Self) -> Self {
        _mm512_mask_div_pd(self, mask, self, other)
    }
    #[inline(always)]
    unsafe fn lt(self, other: Self) -> __mmask8 {
        _mm512_cmp_pd_mask::<_CMP_LT_OQ>(self, other)
    }
    #[inline(always)]
    unsafe fn is_nan(self) -> __mmask8 {
        self.unordered(self)
    }
    #[inline(always)]
    unsafe fn unordered(self, other: Self) -> __mmask8 {
        _mm512_cmp_pd_mask::<_CMP_UNORD_Q>(self, other)
    }
    #[inline(always)]
    unsafe fn not_finite(self) -> __mmask8 {
        // Quiet NaN, +infinity, -infinity, signalling NaN.
        _mm512_fpclass_pd_mask::<0x99>(self)
    }
    #[inline(always)]
    unsafe fn or_where(self, mask: __mmask8, other: Self) -> Self {
        _mm512_mask_blend_pd(mask, self, other)
    }
    #[inline(always)]
    unsafe fn bits(self) -> __m512i {
        _mm512_castpd_si512(self)
    }
    #[inline(always)]
    unsafe fn from_bits(bits: __m512i) -> Self {
        _mm512_castsi512_pd(bits)
    }
    #[inline(always)]
    unsafe fn rows(rows: *const Row, offset: &__m512i) -> [Self; COEFFICIENTS] {
        let lane = &*ptr::from_ref(offset).cast();
        let [c0, c1, c2, c3] = transposed_half(rows, lane, 0);
        let [c4, c5, c6, c7] = transposed_half(rows, lane, 4);
        [c0, c1, c2, c3, c4, c5, c6, c7]
    }
    #[inline(always)]
    unsafe fn splat_bits(x: u64) -> __m512i {
        _mm512_set1_epi64(x as i64)
    }
    #[inline(always)]
    unsafe fn and_bits(a: __m512i, b: __m512i) -> __m512i {
        _mm512_and_si512(a, b)
    }
    #[inline(always)]
    unsafe fn or_bits(a: __m512i, b: __m512i) -> __m512i {
        _mm512_or_si512(a, b)
    }
    #[inline(always)]
    unsafe fn sub_bits(a: __m512i, b: __m512i) -> __m512i {
        _mm512_sub_epi64(a, b)
    }
    #[inline(always)]
    unsafe fn shift_right(a: __m512i, count: u32) -> __m512i {
        _mm512_srl_epi64(a, _mm_cvtsi32_si128(count as i32))
    }
    #[inline(always)]
    unsafe fn sub_bits_where(a: __m512i, mask: __mmask8, b: __m512i) -> __m512i {
        _mm512_mask_sub_epi64(a, mask, a, b)
    }
    #[inline(always)]
    unsafe fn below(a: __m512i, bound: u64) -> __mmask8 {
        _mm512_cmplt_epu64_mask(a, Self::splat_bits(bound))
    }
    #[inline(always)]
    unsafe fn or_bits_where(a: __m512i, mask: __mmask8, b: __m512i) -> __m512i {
        _mm512_mask_blend_epi64(mask, a, b)
    }
    #[inline(always)]
    unsafe fn or_mask(a: __mmask8, b: __mmask8) -> __mmask8 {
        a | b
    }
    #[inline(always)]
    unsafe fn and_mask(a: __mmask8, b: __mmask8) -> __mmask8 {
        a & b
    }
    #[inline(always)]
    unsafe fn not_mask(a: __mmask8) -> __mmask8 {
        !a
    }
    #[inline(always)]
    unsafe fn lanes_of(mask: __mmask8) -> u32 {
        mask.into()
    }
}
