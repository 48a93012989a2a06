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
    /// Whether one of them is greater than the other's.
    fn any_greater(self, other: Self) -> bool;
    fn root(self) -> Self;
    /// The four numbers from each of these indices on: the first of all, the second of all, ...
    fn read_across(from: &[f64], indices: [usize; 4]) -> [Self; 4];

    #[inline(always)]
    fn numbers(self) -> [f64; 4] {
        let mut four = [0.0; 4];
        self.write(&mut four, 0);
        four
    }

    #[inline(always)]
    fn clamp(self, least: Self, most: Self) -> Self {
        let x = least.if_greater(self, least, self);
        x.if_greater(most, most, x)
    }

    /// The sum of all four.
    #[inline(always)]
    fn sum(self) -> f64 {
        let four = self.numbers();
        (four[0] + four[2]) + (four[1] + four[3])
    }
}

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
    fn root(self) -> Self {
        Self::each(|i| self.0[i].sqrt())
    }

    #[inline(always)]
    fn read_across(from: &[f64], indices: [usize; 4]) -> [Self; 4] {
        [0, 1, 2, 3].map(|k| Self::each(|i| from[indices[i] + k]))
    }
}
