//! Four numbers side by side: what is written once for them is compiled for vectors where a processor has them, with the same
//! bits.

use std::ops::{Add, Div, Mul, Sub};

/// Four numbers. Each operation is that of each number, and nothing is fused or reordered.
pub trait Four: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> {
    fn splat(x: f64) -> Self;
    /// From this index on.
    fn read(from: &[f64], index: usize) -> Self;
    fn read_single(from: &[f32], index: usize) -> Self;
    fn write(self, to: &mut [f64], index: usize);
    /// `yes` where it is greater than the other, else `no`.
    fn if_greater(self, other: Self, yes: Self, no: Self) -> Self;
    /// Whether any is greater than the other.
    fn any_greater(self, other: Self) -> bool;
    /// About 1/x^(1/2) of a positive number, to 4 %, from its exponent.
    fn about_inverse_root(self) -> Self;

    #[inline(always)]
    fn clamp(self, least: Self, most: Self) -> Self {
        let x = least.if_greater(self, least, self);
        x.if_greater(most, most, x)
    }

    /// 1/x^(1/2) of a number from 1e-300 to 1e300, without a division or a root, which take long.
    #[inline(always)]
    fn inverse_root(self) -> Self {
        let (half, most) = (self * Self::splat(0.5), Self::splat(1.5));
        let mut y = self.about_inverse_root();
        // Each of Newton's steps doubles the digits.
        for _ in 0..4 {
            y = y * (most - half * (y * y));
        }
        y
    }

    /// The sum of all four.
    #[inline(always)]
    fn sum(self) -> f64 {
        let mut four = [0.0; 4];
        self.write(&mut four, 0);
        (four[0] + four[2]) + (four[1] + four[3])
    }
}

/// The bits of about 1/x^(1/2) are these less half of those of x.
pub const INVERSE_ROOT: u64 = 0x5fe6_eb50_c7b5_37a9;

/// On any processor.
#[derive(Debug, Clone, Copy)]
pub struct Portable([f64; 4]);

impl Portable {
    #[inline(always)]
    fn each(number: impl Fn(usize) -> f64) -> Self {
        Self([number(0), number(1), number(2), number(3)])
    }
}

macro_rules! operation {
    ($($trait:ident $name:ident $operator:tt)*) => {$(
        impl $trait for Portable {
            type Output = Self;

            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self::each(|i| self.0[i] $operator other.0[i])
            }
        }
    )*};
}
operation! { Add add + Sub sub - Mul mul * Div div / }

impl Four for Portable {
    #[inline(always)]
    fn splat(x: f64) -> Self {
        Self([x; 4])
    }

    #[inline(always)]
    fn read(from: &[f64], index: usize) -> Self {
        Self::each(|i| from[index + i])
    }

    #[inline(always)]
    fn read_single(from: &[f32], index: usize) -> Self {
        Self::each(|i| f64::from(from[index + i]))
    }

    #[inline(always)]
    fn write(self, to: &mut [f64], index: usize) {
        to[index..index + 4].copy_from_slice(&self.0);
    }

    #[inline(always)]
    fn if_greater(self, other: Self, yes: Self, no: Self) -> Self {
        Self::each(|i| if self.0[i] > other.0[i] { yes.0[i] } else { no.0[i] })
    }

    #[inline(always)]
    fn any_greater(self, other: Self) -> bool {
        (0..4).any(|i| self.0[i] > other.0[i])
    }

    #[inline(always)]
    fn about_inverse_root(self) -> Self {
        Self::each(|i| f64::from_bits(INVERSE_ROOT.wrapping_sub(self.0[i].to_bits() >> 1)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverse_roots_have_nearly_all_digits() {
        for i in -290..=290 {
            let x = 1.37_f64.powi(i) * 10_f64.powi(i / 2);
            let found = Portable::splat(x).inverse_root().0[i.unsigned_abs() as usize % 4];
            assert!((found * x.sqrt() - 1.0).abs() < 1e-15, "{x:e}: {found:e}");
        }
    }
}
