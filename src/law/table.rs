//! The table: rows found from the bits of x = load - pull-off, and the parts of those that need several polynomials.

use super::row::{polynomial, Row};
use crate::numerics::float_bits::MANTISSA_BITS;

/// Rows, one for each fraction of a binade of x, and after them the parts to which links among them lead.
///
/// The row of x is that of index (bits of x >> shift) - base, as unsigned integers; no such row means that the table does
/// not answer. In a row the variable t is the mantissa of x less that at which the row begins, in a part less where the
/// part begins.
#[derive(Debug, Clone)]
pub struct Table {
    pub rows: Vec<Row>,
    /// How many of them are found from x; the others are parts.
    pub row_count: usize,
    /// How far the bits of x are shifted right.
    pub shift: u32,
    /// The shifted bits of the first row.
    pub base: u64,
    /// The pull-off load.
    pub pull_off: f64,
}

impl Table {
    /// The mantissa's bits.
    pub const MANTISSA: u64 = (1 << MANTISSA_BITS) - 1;
    /// The bits of 1.0.
    pub const ONE: u64 = 1023 << MANTISSA_BITS;
    /// 2^-e has these bits less those of 2^e.
    pub const TWICE_BIAS: u64 = 2046 << MANTISSA_BITS;

    /// Without rows, for rows of a fraction 1/2^`fraction` of a binade.
    pub fn new(fraction: u32, base: u64, pull_off: f64) -> Self {
        Self { rows: Vec::new(), row_count: 0, shift: Self::shift_of(fraction), base, pull_off }
    }

    /// How far bits are shifted for such rows.
    pub const fn shift_of(fraction: u32) -> u32 {
        MANTISSA_BITS - fraction
    }

    /// The bits of the mantissa that say where within its row x lies.
    #[inline]
    pub const fn within_row(shift: u32) -> u64 {
        !(u64::MAX << shift)
    }

    #[inline]
    pub fn index_of(&self, x: f64) -> Option<usize> {
        let index = (x.to_bits() >> self.shift).wrapping_sub(self.base);
        (index < self.row_count as u64).then_some(index as usize)
    }

    /// The row of load - pull-off, which may be a link, and where in it that lies; `None` outside the table.
    #[inline]
    fn row_at_excess(&self, x: f64) -> Option<(&Row, f64)> {
        Some((&self.rows[self.index_of(x)?], self.within(x)))
    }

    /// Where in its row x lies.
    #[inline]
    pub fn within(&self, x: f64) -> f64 {
        f64::from_bits(x.to_bits() & Self::within_row(self.shift) | Self::ONE) - 1.0
    }

    /// Friction force and dF/d(load) at a finite load; `None` where the table does not answer.
    #[inline]
    pub fn at_load(&self, load: f64) -> Option<(f64, f64)> {
        self.at_excess(load - self.pull_off)
    }

    /// The same at load - pull-off.
    #[inline]
    pub fn at_excess(&self, x: f64) -> Option<(f64, f64)> {
        let (row, t) = self.row_at_excess(x)?;
        let (force, rate) = self.in_row(row, t);
        Some((force, rate * Self::per_mantissa(x)))
    }

    /// 1/2^exponent of x: dF/dx = dF/d(mantissa) / 2^exponent.
    #[inline]
    pub fn per_mantissa(x: f64) -> f64 {
        f64::from_bits(Self::TWICE_BIAS - (x.to_bits() & !Self::MANTISSA))
    }

    /// The value and its slope by the mantissa at t within a row.
    #[inline]
    fn in_row(&self, row: &Row, t: f64) -> (f64, f64) {
        let (force, rate) = polynomial(&row.0, t);
        if force.is_nan() {
            let (part, t) = self.part_at(row, t);
            return polynomial(&part.0, t);
        }
        (force, rate)
    }

    /// The part of a row that is a link in which t lies, and t in it.
    #[inline]
    pub fn part_at<'a>(&'a self, mut row: &'a Row, t: f64) -> (&'a Row, f64) {
        let mut begin = 0.0;
        while row.is_link() {
            let (part, division) = row.part(t);
            begin = division.unwrap_or(begin);
            row = &self.rows[part];
        }
        (row, t - begin)
    }

    /// x where a row begins.
    pub fn begin_of(&self, row: usize) -> f64 {
        f64::from_bits((self.base + row as u64) << self.shift)
    }

    /// The lightest and heaviest load of the table.
    pub fn range(&self) -> (f64, f64) {
        (self.pull_off + self.begin_of(0), self.pull_off + self.begin_of(self.row_count))
    }
}
