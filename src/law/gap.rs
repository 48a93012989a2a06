//! Load against separation, compiled: the curve read the other way, as a table of the distance x = anchor - separation.
//!
//! The anchor lies beyond the end of the branch by a whole binade of x, in which the load is not yet 0: rows begin there. Where there is
//! a pull-off load, they begin at pull-off. Without one the load decays without end: from the lightest load that is compiled,
//! it is taken to 0 at the anchor as the seventh power of x, with its value and slope.

use super::curve::Curve;
use super::fill::{Filling, Source};
use super::panel::Sample;
use super::row::relative_error;
use super::table::Table;
use super::{LOG_RANGE_WITHOUT_PULL_OFF, MOST_ROWS, MOST_ROWS_AND_PARTS};
use crate::elementary::{exp, log};
use crate::equilibrium::Branch;
use crate::neighbours::Neighbours;

/// Rows per binade of x, as a power of two: the fewest of which nearly all are good.
const FRACTIONS: [u32; 3] = [3, 4, 5];
/// No more than this part of the rows may be left out of the fewest.
const MOST_LEFT_OUT: usize = 4;
/// The largest relative error of the load of a row, and of its slope, against an exact state.
const VALUE_TOLERANCE: f64 = 4e-10;
const SLOPE_TOLERANCE: f64 = 4e-8;
/// Rows reach from the end of the branch over this many standard deviations of heights, or lengths in which the load rises from pull-off to 0.
const REACH: f64 = 1e4;
/// Without a pull-off load, rows end this far from the highest summit, in sigma: nearer, the separation has few digits of the distance.
const NEAREST_TO_HIGHEST: f64 = 1e-5;
/// The power by which the load goes to 0 beyond the lightest that is compiled.
const TAIL_POWER: f64 = 7.0;

/// Load against separation, in the caller's units.
#[derive(Debug, Clone)]
pub struct Gap {
    /// Rows of x; its "pull-off load" is minus the anchor.
    table: Table,
    tail: Option<Tail>,
    lengths: Lengths,
    unit_load: f64,
    /// The load from which on the error is relative to the load itself.
    least: f64,
    error: f64,
}

/// The caller's units of length: a separation of the model is `unit` times the separation of the means plus `origin`.
#[derive(Debug, Clone, Copy)]
pub struct Lengths {
    pub unit: f64,
    pub origin: f64,
}

/// Load beyond the lightest that is compiled, at x from 0 to the first row's.
#[derive(Debug, Clone, Copy)]
struct Tail {
    begin: f64,
    load: f64,
    /// What the slope by ln x is less than 7.
    bend: f64,
}

impl Tail {
    /// load q^7 (1 + bend (1 - q)), q = x/begin, and its slope by x.
    fn at(&self, x: f64) -> (f64, f64) {
        let q = x / self.begin;
        let cube = q * q * q;
        let sixth = self.load * cube * cube;
        let (factor, bend) = (1.0 + self.bend * (1.0 - q), self.bend);
        (sixth * q * factor, sixth * (TAIL_POWER * factor - bend * q) / self.begin)
    }
}

impl Lengths {
    fn separation(&self, dimensionless: f64) -> f64 {
        (dimensionless + self.origin) * self.unit
    }

    pub fn dimensionless(&self, separation: f64) -> f64 {
        separation / self.unit - self.origin
    }
}

impl Gap {
    /// Fills the table from the curve, in units of load and length.
    pub fn new(branch: &Branch, curve: &Curve, lengths: Lengths, unit_load: f64, samples: &[Sample]) -> Self {
        let (begin, end) = curve.separation_range();
        let pull_off = branch.pull_off().filter(|point| point.separation == end);
        let first = match pull_off {
            Some(_) => end,
            None => lightest(branch, curve),
        };
        // A length over which the load changes by its own size there.
        let scale = match pull_off {
            Some(point) => end - zero_load(curve, point.separation),
            None => {
                let (load, slope) = curve.load_at(first);
                -TAIL_POWER * load / slope
            }
        };
        let margin = binade_below(scale * lengths.unit);
        let mut anchor = lengths.separation(first) + margin;
        if pull_off.is_some() {
            // At pull-off's separation itself the surfaces are apart, whatever rounding did to the sum.
            while anchor - lengths.separation(first) >= margin {
                anchor = anchor.below();
            }
        }
        let farthest = (REACH * scale.max(1.0)).min(first - begin);
        let tail = pull_off.is_none().then(|| {
            let (load, slope) = curve.load_at(lengths.dimensionless(anchor - margin));
            let load = load * unit_load;
            let rise = -slope * unit_load / lengths.unit * margin / load;
            Tail { begin: margin, load, bend: TAIL_POWER - rise }
        });
        let least = -branch.pull_off_load() * unit_load;
        let source = Distances { curve, lengths, unit_load, anchor: anchor / lengths.unit, end: first, least };
        let mut gap = Self { table: Table::new(0, 0, 0.0), tail, lengths, unit_load, least, error: 0.0 };
        for fraction in FRACTIONS {
            let shift = Table::shift_of(fraction);
            let base = margin.to_bits() >> shift;
            let last = (margin + farthest * lengths.unit).min(f64::MAX).to_bits() >> shift;
            let count = (last - base) as usize;
            if count > MOST_ROWS && gap.table.row_count > 0 {
                break;
            }
            let mut table = Table::new(fraction, base, -anchor);
            let filling = Filling::new(&source, lengths.unit, fraction);
            let error = filling.rows(&mut table, count.min(MOST_ROWS));
            let left_out = table.rows.iter().filter(|row| row.is_left_out()).count();
            (gap.table, gap.error) = (table, error);
            if left_out * MOST_LEFT_OUT <= count {
                break;
            }
        }
        let fraction = Table::shift_of(0) - gap.table.shift;
        let filling = Filling::new(&source, lengths.unit, fraction);
        gap.error = gap.error.max(filling.divide_left_out(&mut gap.table, MOST_ROWS_AND_PARTS));
        gap.table.rows.shrink_to_fit();
        gap.certify(samples);
        gap
    }

    /// The table: its argument is minus the separation, its slope by that.
    #[inline]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// The separation from which on the load is 0.
    pub fn end(&self) -> f64 {
        let anchor = -self.table.pull_off;
        anchor - if self.tail.is_some() { 0.0 } else { self.table.begin_of(0) }
    }

    /// Whether the surfaces are apart at a separation.
    #[inline]
    pub fn is_open(&self, separation: f64) -> bool {
        let x = -self.table.pull_off - separation;
        x <= 0.0 || self.tail.is_none() && x < self.table.begin_of(0)
    }

    /// The load and its slope by minus the separation, where the table does not answer; `None` where the curve does not know them
    /// either.
    pub fn interpolated(&self, curve: &Curve, separation: f64) -> Option<(f64, f64)> {
        let x = -self.table.pull_off - separation;
        if let Some(tail) = self.tail.filter(|tail| x < tail.begin) {
            return Some(tail.at(x));
        }
        let (load, slope) = curve.load_at(self.lengths.dimensionless(separation));
        (!load.is_nan()).then(|| (load * self.unit_load, -slope * self.unit_load / self.lengths.unit))
    }

    /// The largest error found when it was built, relative to the load or the pull-off load, whichever is larger.
    #[cfg(test)]
    pub fn error(&self) -> f64 {
        self.error
    }

    /// Measures the table against the exact states that did not make it; leaves a row out that misses one.
    fn certify(&mut self, samples: &[Sample]) {
        for sample in samples {
            let x = -self.table.pull_off - self.lengths.separation(sample.separation);
            let (Some(row), Some((load, slope))) = (self.table.index_of(x), self.table.at_excess(x)) else { continue };
            let exact = sample.load.0 * self.unit_load;
            let exact_slope = -sample.load.1 * self.unit_load / self.lengths.unit;
            let error = relative_error(load, exact, self.least);
            if error > VALUE_TOLERANCE || relative_error(slope, exact_slope, self.least / x) > SLOPE_TOLERANCE {
                self.table.rows[row].leave_out();
            } else {
                self.error = self.error.max(error);
            }
        }
    }
}

/// The lightest load that is compiled where the load decays without end, and the separation at which it is carried.
fn lightest(branch: &Branch, curve: &Curve) -> f64 {
    let (begin, end) = curve.separation_range();
    let (lower, upper) = curve.log_range();
    let lightest = curve.separation(lower.max(upper - LOG_RANGE_WITHOUT_PULL_OFF)).unwrap_or(end);
    let highest = branch.farthest() - NEAREST_TO_HIGHEST * (1.0 + branch.farthest().abs());
    lightest.min(highest).max(begin).min(end)
}

/// The separation at which the load is 0, where it pulls at the end.
fn zero_load(curve: &Curve, end: f64) -> f64 {
    // x = |pull-off load|.
    curve.separation_of_zero_load().filter(|&zero| zero < end).unwrap_or(end - 1.0)
}

/// The largest power of two that is not larger.
fn binade_below(x: f64) -> f64 {
    f64::from_bits(x.to_bits() & !Table::MANTISSA)
}

/// The load against ln x, in the caller's units of load; x is in sigma.
struct Distances<'a> {
    curve: &'a Curve,
    lengths: Lengths,
    unit_load: f64,
    anchor: f64,
    /// The end of the branch.
    end: f64,
    least: f64,
}

impl Source for Distances<'_> {
    fn at<const N: usize>(&self, log_x: [f64; N]) -> [(f64, f64); N] {
        log_x.map(|log_x| {
            let x = exp(log_x);
            let separation = (self.anchor - x - self.lengths.origin).min(self.end);
            let (load, slope) = self.curve.load_at(separation);
            (load * self.unit_load, -slope * self.unit_load * x)
        })
    }

    fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        let log_x = |separation: f64| log(self.anchor - self.lengths.origin - separation);
        let joints = self.curve.joints().rev().filter(|&joint| joint < self.end).map(log_x);
        joints.filter(|&joint| joint > lower && joint < upper).collect()
    }

    fn least(&self) -> f64 {
        self.least
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::branch;
    use super::super::Law;
    use super::*;

    #[test]
    fn the_table_is_small_and_nearly_all_of_it_is_whole_rows() {
        for (gamma, most) in [(0.0, 400), (1e-3, 340)] {
            let law = Law::new(&branch(gamma), 3.0, [0.5, 7.0], 3e-9).expect("a law");
            let table = law.load_table();
            let links = table.rows.iter().filter(|row| row.is_link()).count();
            let left_out = table.rows.iter().filter(|row| row.is_left_out()).count();
            println!("{} rows, {} with parts, {links} links", table.row_count, table.rows.len());
            assert!(table.rows.len() <= most && left_out == 0, "{} rows, {left_out} left out", table.rows.len());
            assert!(links * MOST_LEFT_OUT <= table.row_count, "{links} links");
            assert!(law.gap.error() > 1e-17 && law.gap.error() < VALUE_TOLERANCE, "{:e}", law.gap.error());
        }
    }

    #[test]
    fn the_tail_joins_the_lightest_load_with_its_slope_and_ends_at_nothing() {
        let tail = Tail { begin: 2.0, load: 3.0, bend: 1.5 };
        assert_eq!(tail.at(2.0), (3.0, 3.0 * (TAIL_POWER - 1.5) / 2.0));
        assert_eq!(tail.at(0.0), (0.0, 0.0));
        for x in [0.1, 0.7, 1.3, 1.9] {
            let difference = (tail.at(x + 1e-6).0 - tail.at(x - 1e-6).0) / 2e-6;
            let (load, slope) = tail.at(x);
            assert!(load > 0.0 && (difference / slope - 1.0).abs() < 1e-7, "{x}: {slope}, not {difference}");
        }
    }
}
