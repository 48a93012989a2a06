//! Four numbers side by side, by the instructions of AVX2.

use crate::law::{Row, COEFFICIENTS};
use std::arch::x86_64::*;
use std::ptr;

/// Four numbers. Every method is one or two instructions; it asks for a processor that has them and for a calling function that
/// is compiled for them.
#[derive(Clone, Copy)]
pub struct Lanes(__m256d);

/// A truth value per lane: all bits set, or none.
pub type Mask = __m256d;
/// A 64-bit integer per lane.
pub type Bits = __m256i;

/// Methods that become part of the calling function.
macro_rules! inlined {
    ($($(#[$doc:meta])* fn $name:ident($($arguments:tt)*) $(-> $returned:ty)? $body:block)*) => {
        $($(#[$doc])* #[inline(always)] pub unsafe fn $name($($arguments)*) $(-> $returned)? $body)*
    };
}

impl Lanes {
    pub const COUNT: usize = 4;
    /// What [`Lanes::lanes_of`] gives where all lanes are set.
    pub const ALL: u32 = (1 << Self::COUNT) - 1;

    inlined! {
        fn read(at: *const f64) -> Self { Self(_mm256_loadu_pd(at)) }
        fn write(self, at: *mut f64) { _mm256_storeu_pd(at, self.0) }
        fn splat(x: f64) -> Self { Self(_mm256_set1_pd(x)) }
        fn add(self, other: Self) -> Self { Self(_mm256_add_pd(self.0, other.0)) }
        fn sub(self, other: Self) -> Self { Self(_mm256_sub_pd(self.0, other.0)) }
        fn mul(self, other: Self) -> Self { Self(_mm256_mul_pd(self.0, other.0)) }
        fn div(self, other: Self) -> Self { Self(_mm256_div_pd(self.0, other.0)) }
        /// self/other where the mask is set, any number elsewhere, without raising a flag there.
        fn div_where(self, mask: Mask, other: Self) -> Self {
            // Not 1, by which the compiler would choose after dividing all lanes.
            self.div(Self::splat(2.0).or_where(mask, other))
        }
        /// self < other, false for NaN, without raising a flag.
        fn lt(self, other: Self) -> Mask { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) }
        /// Whether it or the other is NaN.
        fn unordered(self, other: Self) -> Mask { _mm256_cmp_pd::<_CMP_UNORD_Q>(self.0, other.0) }
        fn is_nan(self) -> Mask { self.unordered(self) }
        /// NaN, signalling or not, or infinite; without raising a flag.
        fn not_finite(self) -> Mask {
            let exponent = Self::splat_bits(0x7ff << 52);
            _mm256_castsi256_pd(_mm256_cmpeq_epi64(Self::and_bits(self.bits(), exponent), exponent))
        }
        /// As `not_finite`, and numbers of size 2^1023 and above: arithmetic with them may overflow.
        fn not_tame(self) -> Mask {
            let exponent = Self::and_bits(self.bits(), Self::splat_bits(0x7ff << 52));
            _mm256_castsi256_pd(_mm256_cmpgt_epi64(exponent, Self::splat_bits(0x7fd << 52)))
        }
        /// By its sign, which is all that is looked at of a mask.
        fn is_negative(self) -> Mask { self.0 }
        /// `other` where the mask is set.
        fn or_where(self, mask: Mask, other: Self) -> Self { Self(_mm256_blendv_pd(self.0, other.0, mask)) }
        /// All coefficients of the row of each lane, at an offset in bytes, transposed: a vector each.
        fn rows(rows: *const Row, offset: &Bits) -> [Self; COEFFICIENTS] {
            let [c0, c1, c2, c3] = Self::half_rows(rows, offset, 0);
            let [c4, c5, c6, c7] = Self::half_rows(rows, offset, 4);
            [c0, c1, c2, c3, c4, c5, c6, c7]
        }
        fn half_rows(rows: *const Row, offset: &Bits, from: usize) -> [Self; 4] {
            let lane: &[u64; 4] = &*ptr::from_ref(offset).cast();
            let row = |i: usize| _mm256_load_pd(rows.byte_add(lane[i] as usize).cast::<f64>().add(from));
            let (a0, a1) = (_mm256_unpacklo_pd(row(0), row(1)), _mm256_unpackhi_pd(row(0), row(1)));
            let (a2, a3) = (_mm256_unpacklo_pd(row(2), row(3)), _mm256_unpackhi_pd(row(2), row(3)));
            [
                Self(_mm256_permute2f128_pd::<0x20>(a0, a2)),
                Self(_mm256_permute2f128_pd::<0x20>(a1, a3)),
                Self(_mm256_permute2f128_pd::<0x31>(a0, a2)),
                Self(_mm256_permute2f128_pd::<0x31>(a1, a3)),
            ]
        }
        /// The number of each lane, by index.
        fn gather(numbers: *const f64, index: Bits) -> Self { Self(_mm256_i64gather_pd::<8>(numbers, index)) }

        fn bits(self) -> Bits { _mm256_castpd_si256(self.0) }
        fn from_bits(bits: Bits) -> Self { Self(_mm256_castsi256_pd(bits)) }
        fn splat_bits(x: u64) -> Bits { Self::splat(f64::from_bits(x)).bits() }
        fn and_bits(a: Bits, b: Bits) -> Bits { _mm256_and_si256(a, b) }
        fn add_bits(a: Bits, b: Bits) -> Bits { _mm256_add_epi64(a, b) }
        fn sub_bits(a: Bits, b: Bits) -> Bits { _mm256_sub_epi64(a, b) }
        fn shift_right(a: Bits, count: u32) -> Bits { _mm256_srl_epi64(a, _mm_cvtsi32_si128(count as i32)) }
        /// `b` where the mask is set.
        fn or_bits_where(a: Bits, mask: Mask, b: Bits) -> Bits {
            Self::from_bits(a).or_where(mask, Self::from_bits(b)).bits()
        }
        /// a < bound, as unsigned integers; the bound is below 2^32 and not 0.
        fn below(a: Bits, bound: u64) -> Mask {
            // The upper halves are 0 as well where nothing is larger than what it is compared with.
            let least = _mm256_min_epu32(a, Self::splat_bits(bound - 1));
            _mm256_castsi256_pd(_mm256_cmpeq_epi64(least, a))
        }

        fn or_mask(a: Mask, b: Mask) -> Mask { _mm256_or_pd(a, b) }
        fn and_mask(a: Mask, b: Mask) -> Mask { _mm256_and_pd(a, b) }
        fn not_mask(a: Mask) -> Mask { _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) }
        /// Bit i for lane i.
        fn lanes_of(mask: Mask) -> u32 { _mm256_movemask_pd(mask) as u32 }
    }
}
