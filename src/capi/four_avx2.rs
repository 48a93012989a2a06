//! Four numbers in a register of AVX2.

use crate::numerics::four::Four;
use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

/// Four numbers. The processor has the instructions wherever one is made, and the calling function is compiled for them.
#[derive(Clone, Copy)]
pub struct Avx2(__m256d);

macro_rules! operation {
    ($($trait:ident $name:ident $intrinsic:ident)*) => {$(
        impl $trait for Avx2 {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
operation! { Add add _mm256_add_pd Sub sub _mm256_sub_pd Mul mul _mm256_mul_pd Div div _mm256_div_pd }

impl Four for Avx2 {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self(unsafe { _mm256_set1_pd(x) })
    }

    #[inline(always)]
    fn read(from: &[f64], index: usize) -> Self {
        Self(unsafe { _mm256_loadu_pd(from[index..index + 4].as_ptr()) })
    }

    #[inline(always)]
    fn read_single(from: &[f32], index: usize) -> Self {
        Self(unsafe { _mm256_cvtps_pd(_mm_loadu_ps(from[index..index + 4].as_ptr())) })
    }

    #[inline(always)]
    fn write(self, to: &mut [f64], index: usize) {
        unsafe { _mm256_storeu_pd(to[index..index + 4].as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn if_greater(self, other: Self, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, _mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0)) })
    }

    #[inline(always)]
    fn any_greater(self, other: Self) -> bool {
        unsafe { _mm256_movemask_pd(_mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0)) != 0 }
    }

    #[inline(always)]
    fn root(self) -> Self {
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn read_across(from: &[f64], indices: [usize; 4]) -> [Self; 4] {
        let [a, b, c, d] = indices;
        let (a, b) = (Self::read(from, a).0, Self::read(from, b).0);
        let (c, d) = (Self::read(from, c).0, Self::read(from, d).0);
        unsafe {
            let (ab, ab_after) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
            let (cd, cd_after) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
            [
                Self(_mm256_permute2f128_pd::<0x20>(ab, cd)),
                Self(_mm256_permute2f128_pd::<0x20>(ab_after, cd_after)),
                Self(_mm256_permute2f128_pd::<0x31>(ab, cd)),
                Self(_mm256_permute2f128_pd::<0x31>(ab_after, cd_after)),
            ]
        }
    }
}
