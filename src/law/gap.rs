//! Load against the gap between mean planes, compiled: the curve read the other way, as a table of the distance x = anchor - gap.
//!
//! Where there is a pull-off load, rows begin at pull-off, and the anchor lies beyond it by a whole binade of x. Without one they begin
//! at the lightest load that is compiled, and from there the load goes to 0 at the anchor as a power of x, with its value and slope.
//! The anchor is then the highest summit; where that is far or the load decays without end, it is nearer, by a whole binade again.
//! Farther in compression than the curve the load is a power of the depth below the mean height; where it begins lies within the last row.

use super::continuation::{Beyond, Continuation};
use super::curve::Curve;
use super::fill::{Filling, Source};
use super::table::Table;
use super::Reach;
use crate::equilibrium::Branch;
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::TAMEST;
use crate::numerics::neighbours::Neighbours;
use crate::numerics::root;

/// Rows per binade of x, as a power of two: the fewest of which nearly all are good.
const GAP_FRACTION: u32 = 3;
/// The largest power by which the load goes to 0 beyond the lightest that is compiled, where the highest summit is far.
const TAIL_POWER: f64 = 7.0;

/// Load against gap, in the caller's units.
#[derive(Debug, Clone)]
pub struct Gap {
    /// Rows of x; its "pull-off load" is minus the anchor.
    table: Table,
    /// Lighter than the table, of x, where there is no pull-off load; in heavier compression, of the depth, which counts from the gap of the
    /// mean of the heights if separations went on to it at the rate of the heaviest load.
    beyond: Box<Beyond>,
    /// The surfaces are apart at a smaller x.
    least: f64,
    lengths: Lengths,
}

/// The caller's units of length: a gap of the caller is `unit` times the sum of that of the model and `origin`, what the zero of the
/// model's heights is above the mean plane.
#[derive(Debug, Clone, Copy)]
pub struct Lengths {
    pub unit: f64,
    pub origin: f64,
}

impl Lengths {
    pub fn callers(&self, dimensionless: f64) -> f64 {
        (dimensionless + self.origin) * self.unit
    }

    pub fn dimensionless(&self, gap: f64) -> f64 {
        gap / self.unit - self.origin
    }
}

impl Gap {
    /// Fills the table from the curve, in units of load and length.
    pub fn new(branch: &Branch, curve: &Curve, reach: Reach, lengths: Lengths, unit_load: f64) -> Self {
        let (begin, end) = curve.separation_range();
        // Next to pull-off the curve may end a few last bits before.
        let pull_off = reach.pull_off;
        let first = match pull_off {
            Some(point) => point.separation,
            None => curve.separation(reach.log_lightest).unwrap_or(end),
        };
        // A length over which the load changes by its own size there.
        let scale = match pull_off {
            Some(point) => curve.gap(end) - curve.gap(zero_load(curve, point.separation)),
            None => {
                let (load, slope) = curve.load_at(first);
                -TAIL_POWER * load / slope
            }
        };
        let highest = curve.gap(branch.farthest());
        // A part of a curve may begin above the mean height.
        let depth = (-branch.population().heights().outline().origin - begin).max(1.0);
        let rise = curve.load_at(begin).1;
        let [begin, first] = [begin, first].map(|separation| curve.gap(separation));
        let to_highest = (highest - first) * lengths.unit;
        let beyond = binade_below(scale * lengths.unit);
        let is_cut = pull_off.is_none() && to_highest < beyond;
        let margin = if is_cut { to_highest } else { beyond };
        let mut anchor = if is_cut { lengths.callers(highest) } else { lengths.callers(first) + margin };
        if pull_off.is_some() {
            // At pull-off's gap itself the surfaces are apart, whatever rounding did to the sum.
            while anchor - lengths.callers(first) >= margin {
                anchor = anchor.below();
            }
        }
        let least = -branch.pull_off_load() * unit_load;
        // Without the rounding of the caller's units, next to which lengths may be small.
        let dimensionless = if is_cut { highest } else { lengths.dimensionless(anchor) };
        let heaviest = curve.load_at_gaps([begin])[0];
        // As where separations go on with gaps at this rate.
        let middle = begin + depth * rise / heaviest.1;
        let deep = Continuation::new(-middle, middle - begin, (heaviest.0, -heaviest.1), 0.0, true);
        let source = Distances { curve, unit_load, anchor: dimensionless, end: first, least, begin, deep };
        let shift = Table::shift_of(GAP_FRACTION);
        // The first row that the curve has whole.
        let base = (margin.below().to_bits() >> shift) + 1;
        // The row in which the curve begins.
        let end = ((margin + (first - begin) * lengths.unit).min(f64::MAX).to_bits() >> shift) + 1;
        let mut table = Table::new(GAP_FRACTION, base, -anchor);
        Filling::new(&source, lengths.unit, GAP_FRACTION).rows(&mut table, (end - base) as usize, reach.most_rows);
        let (at_anchor, least) = if pull_off.is_none() { (Some(0.0), 0.0) } else { (None, table.begin_of(0)) };
        let beyond = Box::new(Beyond::new(&table, at_anchor, -lengths.callers(middle)));
        Self { table, beyond, least: least.max(0.0.above()), lengths }
    }

    /// The table: its argument is minus the gap, its slope by that.
    #[inline]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// The gap from which on the load is 0.
    pub fn end(&self) -> f64 {
        -self.table.pull_off - self.least
    }

    /// Whether the surfaces are apart at a gap.
    #[inline]
    pub fn is_open(&self, gap: f64) -> bool {
        // The difference from the largest number may be infinite.
        if gap.abs() > TAMEST {
            return gap > 0.0;
        }
        -self.table.pull_off - gap < self.least()
    }

    /// The least x of a gap at which the surfaces are not apart.
    #[inline]
    pub fn least(&self) -> f64 {
        self.least
    }

    /// What answers where the table does not, of minus the gap; nothing where the surfaces are apart.
    #[inline]
    pub fn beyond(&self) -> &Beyond {
        &self.beyond
    }

    /// The caller's units of length.
    pub fn lengths(&self) -> Lengths {
        self.lengths
    }

    /// The gap at which a load is carried; `None` beyond the table.
    pub fn of_load(&self, load: f64) -> Option<f64> {
        let begins =
            |row: usize| self.table.at_excess(self.table.begin_of(row)).map_or(f64::INFINITY, |(load, _)| load);
        let (mut row, mut next) = (0, self.table.row_count);
        while next - row > 1 {
            let middle = (row + next) / 2;
            *if begins(middle) <= load { &mut row } else { &mut next } = middle;
        }
        let (from, to) = (self.table.begin_of(row), self.table.begin_of(next).below());
        let excess = |x: f64| self.table.at_excess(x).map_or(f64::NAN, |(at, _)| at - load);
        (excess(from) <= 0.0 && excess(to) >= 0.0).then(|| -self.table.pull_off - root::bracketed(excess, from, to))
    }
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
    unit_load: f64,
    anchor: f64,
    /// The gap at the end of the curve.
    end: f64,
    least: f64,
    /// The gap where the curve begins, and what goes on from there, of minus the gap.
    begin: f64,
    deep: Continuation,
}

impl Source for Distances<'_> {
    fn at<const N: usize>(&self, log_x: [f64; N]) -> [(f64, f64); N] {
        let x = log_x.map(exp);
        let gaps = x.map(|x| (self.anchor - x).min(self.end));
        let loads = self.curve.load_at_gaps(gaps.map(|gap| gap.max(self.begin)));
        std::array::from_fn(|i| {
            let (load, slope) = loads[i];
            let (load, slope) = if gaps[i] < self.begin { self.deep.at(-gaps[i]) } else { (load, -slope) };
            (load * self.unit_load, slope * self.unit_load * x[i])
        })
    }

    fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        let log_x = |gap: f64| log(self.anchor - gap);
        let joints = self.curve.kinks().iter().rev().map(|kink| self.curve.gap(kink.0));
        let joints = joints.filter(|&joint| joint < self.end).chain([self.begin]).map(log_x);
        joints.filter(|&joint| joint > lower && joint < upper).collect()
    }

    fn least(&self) -> f64 {
        self.least
    }
}
