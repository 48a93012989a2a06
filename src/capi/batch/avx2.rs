//! Four lanes: AVX2.

use super::lanes::{self, Lanes};
use super::{Arrays, Quantity};
use crate::law::{Row, COEFFICIENTS};
use crate::model::Model;
use std::arch::x86_64::*;
use std::ptr;

/// Evaluates all full vectors; returns how many elements they are.
#[target_feature(enable = "avx2")]
pub unsafe fn evaluate(model: &Model, quantity: Quantity, arrays: Arrays, offence: &mut Option<(usize, f64)>) -> usize {
    lanes::evaluate::<__m256d>(model, quantity, arrays, offence)
}

/// Coefficients `from` to `from` + 3 of the rows of all lanes.
#[inline(always)]
unsafe fn transposed_half(rows: *const Row, lane: &[u64; 4], from: usize) -> [__m256d; 4] {
    let (r0, r1) = (half_row(rows, lane[0], from), half_row(rows, lane[1], from));
    let (r2, r3) = (half_row(rows, lane[2], from), half_row(rows, lane[3], from));
    let (a0, a1) = (_mm256_unpacklo_pd(r0, r1), _mm256_unpackhi_pd(r0, r1));
    let (a2, a3) = (_mm256_unpacklo_pd(r2, r3), _mm256_unpackhi_pd(r2, r3));
    [
        _mm256_permute2f128_pd::<0x20>(a0, a2),
        _mm256_permute2f128_pd::<0x20>(a1, a3),
        _mm256_permute2f128_pd::<0x31>(a0, a2),
        _mm256_permute2f128_pd::<0x31>(a1, a3),
    ]
}

#[inline(always)]
unsafe fn half_row(rows: *const Row, offset: u64, from: usize) -> __m256d {
    _mm256_load_pd(rows.byte_add(offset as usize).cast::<f64>().add(from))
}

unsafe impl Lanes for __m256d {
    const COUNT: usize = 4;
    /// All bits of a lane set, or none.
    type Mask = __m256d;
    type Bits = __m256i;

    #[inline(always)]
    unsafe fn read(at: *const f64) -> Self {
        _mm256_loadu_pd(at)
    }
    #[inline(always)]
    unsafe fn write(self, at: *mut f64) {
        _mm256_storeu_pd(at, self)
    }
    #[inline(always)]
    unsafe fn splat(x: f64) -> Self {
        _mm256_set1_pd(x)
    }
    #[inline(always)]
    unsafe fn add(self, other: Self) -> Self {
        _mm256_add_pd(self, other)
    }
    #[inline(always)]
    unsafe fn sub(self, other: Self) -> Self {
        _mm256_sub_pd(self, other)
    }
    #[inline(always)]
    unsafe fn mul(self, other: Self) -> Self {
        _mm256_mul_pd(self, other)
    }
    #[inline(always)]
    unsafe fn div(self, other: Self) -> Self {
        _mm256_div_pd(self, other)
    }
    #[inline(always)]
    unsafe fn div_where(self, mask: __m256d, other: Self) -> Self {
        // Not 1, by which the compiler would choose after dividing all lanes.
        _mm256_div_pd(self, _mm256_blendv_pd(Self::splat(2.0), other, mask))
    }
    #[inline(always)]
    unsafe fn lt(self, other: Self) -> __m256d {
        _mm256_cmp_pd::<_CMP_LT_OQ>(self, other)
    }
    #[inline(always)]
    unsafe fn is_nan(self) -> __m256d {
        self.unordered(self)
    }
    #[inline(always)]
    unsafe fn unordered(self, other: Self) -> __m256d {
        _mm256_cmp_pd::<_CMP_UNORD_Q>(self, other)
    }
    #[inline(always)]
    unsafe fn not_finite(self) -> __m256d {
        let exponent = Self::splat_bits(0x7ff << 52);
        _mm256_castsi256_pd(_mm256_cmpeq_epi64(Self::and_bits(self.bits(), exponent), exponent))
    }
    #[inline(always)]
    unsafe fn or_where(self, mask: __m256d, other: Self) -> Self {
        _mm256_blendv_pd(self, other, mask)
    }
    #[inline(always)]
    unsafe fn bits(self) -> __m256i {
        _mm256_castpd_si256(self)
    }
    #[inline(always)]
    unsafe fn from_bits(bits: __m256i) -> Self {
        _mm256_castsi256_pd(bits)
    }
    #[inline(always)]
    unsafe fn rows(rows: *const Row, offset: &__m256i) -> [Self; COEFFICIENTS] {
        let lane = &*ptr::from_ref(offset).cast();
        let [c0, c1, c2, c3] = transposed_half(rows, lane, 0);
        let [c4, c5, c6, c7] = transposed_half(rows, lane, 4);
        [c0, c1, c2, c3, c4, c5, c6, c7]
    }
    #[inline(always)]
    unsafe fn splat_bits(x: u64) -> __m256i {
        _mm256_set1_epi64x(x as i64)
    }
    #[inline(always)]
    unsafe fn and_bits(a: __m256i, b: __m256i) -> __m256i {
        _mm256_and_si256(a, b)
    }
    #[inline(always)]
    unsafe fn or_bits(a: __m256i, b: __m256i) -> __m256i {
        _mm256_or_si256(a, b)
    }
    #[inline(always)]
    unsafe fn sub_bits(a: __m256i, b: __m256i) -> __m256i {
        _mm256_sub_epi64(a, b)
    }
    #[inline(always)]
    unsafe fn shift_right(a: __m256i, count: u32) -> __m256i {
        _mm256_srl_epi64(a, _mm_cvtsi32_si128(count as i32))
    }
    #[inline(always)]
    unsafe fn sub_bits_where(a: __m256i, mask: __m256d, b: __m256i) -> __m256i {
        _mm256_sub_epi64(a, _mm256_and_si256(_mm256_castpd_si256(mask), b))
    }
    #[inline(always)]
    unsafe fn below(a: __m256i, bound: u64) -> __m256d {
        // The upper halves are 0 as well where nothing is larger than what it is compared with.
        let least = _mm256_min_epu32(a, Self::splat_bits(bound - 1));
        _mm256_castsi256_pd(_mm256_cmpeq_epi64(least, a))
    }
    #[inline(always)]
    unsafe fn or_bits_where(a: __m256i, mask: __m256d, b: __m256i) -> __m256i {
        _mm256_blendv_epi8(a, b, _mm256_castpd_si256(mask))
    }
    #[inline(always)]
    unsafe fn or_mask(a: __m256d, b: __m256d) -> __m256d {
        _mm256_or_pd(a, b)
    }
    #[inline(always)]
    unsafe fn and_mask(a: __m256d, b: __m256d) -> __m256d {
        _mm256_and_pd(a, b)
    }
    #[inline(always)]
    unsafe fn not_mask(a: __m256d) -> __m256d {
        _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))
    }
    #[inline(always)]
    unsafe fn lanes_of(mask: __m256d) -> u32 {
        _mm256_movemask_pd(mask) as u32
    }
}
