//! Load against the gap between mean planes, compiled: the curve read the other way, as a table of the distance x = anchor - gap.
//!
//! The anchor lies beyond the end of the branch by a whole binade of x, in which the load is not yet 0: rows begin there. Where there is
//! a pull-off load, they begin at pull-off. Without one the load decays without end: from the lightest load that is compiled,
//! it is taken to 0 at the anchor as the seventh power of x, with its value and slope.

use super::continuation::Continuation;
use super::curve::Curve;
use super::fill::{Filling, Source};
use super::table::Table;
use super::Reach;
use crate::elementary::{exp, log};
use crate::equilibrium::Branch;
use crate::neighbours::Neighbours;
use crate::numerics::root;

/// Rows per binade of x, as a power of two: the fewest of which nearly all are good.
const FRACTION: u32 = 4;
/// Without a pull-off load, rows end this far from the highest summit, in sigma: nearer, the separation has few digits of the distance.
const NEAREST_TO_HIGHEST: f64 = 1e-5;
/// The power by which the load goes to 0 beyond the lightest that is compiled.
const TAIL_POWER: f64 = 7.0;

/// Load against gap, in the caller's units.
#[derive(Debug, Clone)]
pub struct Gap {
    /// Rows of x; its "pull-off load" is minus the anchor.
    table: Table,
    tail: Option<Tail>,
    /// In heavier compression than the table's, of x.
    heavy: Box<Continuation>,
    lengths: Lengths,
}

/// The caller's units of length: a gap of the caller is `unit` times the sum of that of the model and `origin`, what the zero of the
/// model's heights is above the mean plane.
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
        let pull_off = branch.pull_off().filter(|_| reach.has_pull_off);
        let first = match pull_off {
            Some(_) => end,
            None => lightest(branch, curve),
        };
        // A length over which the load changes by its own size there.
        let scale = match pull_off {
            Some(point) => curve.gap(end) - curve.gap(zero_load(curve, point.separation)),
            None => {
                let (load, slope) = curve.load_at(first);
                -TAIL_POWER * load / slope
            }
        };
        let [begin, first] = [begin, first].map(|separation| curve.gap(separation));
        let margin = binade_below(scale * lengths.unit);
        let mut anchor = lengths.callers(first) + margin;
        if pull_off.is_some() {
            // At pull-off's gap itself the surfaces are apart, whatever rounding did to the sum.
            while anchor - lengths.callers(first) >= margin {
                anchor = anchor.below();
            }
        }
        let tail = pull_off.is_none().then(|| {
            let [(load, slope)] = curve.load_at_gaps([lengths.dimensionless(anchor - margin)]);
            let load = load * unit_load;
            let rise = -slope * unit_load / lengths.unit * margin / load;
            Tail { begin: margin, load, bend: TAIL_POWER - rise }
        });
        let least = -branch.pull_off_load() * unit_load;
        let source = Distances { curve, lengths, unit_load, anchor: anchor / lengths.unit, end: first, least };
        let shift = Table::shift_of(FRACTION);
        let base = margin.to_bits() >> shift;
        let end = (margin + (first - begin) * lengths.unit).min(f64::MAX).to_bits() >> shift;
        let mut table = Table::new(FRACTION, base, -anchor);
        Filling::new(&source, lengths.unit, FRACTION).rows(&mut table, (end - base) as usize, reach.most_rows);
        let last = table.begin_of(table.row_count).below();
        let at_last = table.at_excess(last).unwrap_or((f64::NAN, f64::NAN));
        let heavy = Box::new(Continuation::new(last + table.pull_off, at_last, 0.0, true));
        Self { heavy, table, tail, lengths }
    }

    /// The table: its argument is minus the gap, its slope by that.
    #[inline]
    pub fn table(&self) -> &Table {
        &self.table
    }

    /// The gap from which on the load is 0.
    pub fn end(&self) -> f64 {
        let anchor = -self.table.pull_off;
        anchor - if self.tail.is_some() { 0.0 } else { self.table.begin_of(0) }
    }

    /// Whether the surfaces are apart at a gap.
    #[inline]
    pub fn is_open(&self, gap: f64) -> bool {
        let x = -self.table.pull_off - gap;
        x <= 0.0 || self.tail.is_none() && x < self.table.begin_of(0)
    }

    /// The load and its slope by minus the gap, where the surfaces are not apart and the table does not answer.
    pub fn beyond(&self, gap: f64) -> (f64, f64) {
        let x = -self.table.pull_off - gap;
        match self.tail.filter(|tail| x < tail.begin) {
            Some(tail) => tail.at(x),
            None => self.heavy.at(-gap),
        }
    }

    /// Whether finding them raises no floating-point exception but "inexact".
    pub fn is_moderate_beyond(&self, gap: f64) -> bool {
        let x = -self.table.pull_off - gap;
        !self.tail.is_some_and(|tail| x < tail.begin) && self.heavy.is_moderate(-gap)
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
        if load < begins(row) {
            return None;
        }
        while next - row > 1 {
            let middle = (row + next) / 2;
            *if begins(middle) <= load { &mut row } else { &mut next } = middle;
        }
        let (from, to) = (self.table.begin_of(row), self.table.begin_of(next));
        let excess = |x: f64| self.table.at_excess(x).map_or(f64::INFINITY, |(at, _)| at - load);
        (next < self.table.row_count).then(|| -self.table.pull_off - root::bracketed(excess, from, to))
    }
}

/// The lightest load that is compiled where the load decays without end, and the separation at which it is carried.
fn lightest(branch: &Branch, curve: &Curve) -> f64 {
    let (begin, end) = curve.separation_range();
    let highest = branch.farthest() - NEAREST_TO_HIGHEST * (1.0 + branch.farthest().abs());
    // No farther above the mean height than the heaviest load is below: lengths are resolved in proportion to the distance from here.
    let middle = -branch.population().heights().origin();
    highest.min(2.0 * middle - begin).max(begin).min(end)
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
    /// The gap at the end of the branch.
    end: f64,
    least: f64,
}

impl Source for Distances<'_> {
    fn at<const N: usize>(&self, log_x: [f64; N]) -> [(f64, f64); N] {
        let x = log_x.map(exp);
        let loads = self.curve.load_at_gaps(x.map(|x| (self.anchor - x - self.lengths.origin).min(self.end)));
        std::array::from_fn(|i| {
            let (load, slope) = loads[i];
            (load * self.unit_load, -slope * self.unit_load * x[i])
        })
    }

    fn joints(&self, lower: f64, upper: f64) -> Vec<f64> {
        let log_x = |gap: f64| log(self.anchor - self.lengths.origin - gap);
        let joints = self.curve.joints().rev().map(|joint| self.curve.gap(joint));
        let joints = joints.filter(|&joint| joint < self.end).map(log_x);
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
            let law = Law::new(&branch(gamma), 3.0, [0.5, 7.0], Lengths { unit: 3e-9, origin: 0.0 }).expect("a law");
            let table = law.gap().table();
            let links = table.rows.iter().filter(|row| row.is_link()).count();
            println!("{} rows, {} with parts, {links} links", table.row_count, table.rows.len());
            assert!(table.rows.len() <= most && 4 * links <= table.row_count, "{} rows", table.rows.len());
            let branch = branch(gamma);
            let least = -3.0 * branch.pull_off_load();
            // From next to the end, or from where the load is more than nothing, to far in compression.
            for i in 0..200 {
                let separation = branch.farthest().min(9.0) - 1e-3 * 1.08_f64.powi(i);
                let (load, _) = table.at_load(-law.gap().lengths.callers(separation)).expect("it is tabulated");
                let exact = 3.0 * branch.population().at_separation(separation).load();
                let error = (load - exact).abs() / exact.abs().max(least);
                assert!(error < 1e-9, "{error:e} at {separation}");
            }
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

    /// With a load that decays without end, and with one that pulls at the end of the branch.
    #[test]
    fn beyond_the_table_surfaces_are_apart_or_the_load_goes_on() {
        for gamma in [0.0, 1e-3] {
            let law = Law::new(&branch(gamma), 3.0, [0.5, 7.0], Lengths { unit: 3e-9, origin: 0.0 }).expect("a law");
            let gap = law.gap();
            let [end, step] = [gap.end(), 1e-12];
            assert!(gap.is_open(end + step) && !gap.is_open(end - step), "{gamma}: {end:e}");
            // Far in compression, where the table ends.
            let last = -(gap.table().begin_of(gap.table().row_count).below() + gap.table().pull_off);
            let (load, slope) = gap.beyond(last);
            let known = gap.table().at_load(-last).expect("the table answers");
            assert!(
                (load / known.0 - 1.0).abs() < 1e-12 && (slope / known.1 - 1.0).abs() < 1e-7,
                "{load:e}, {known:?}"
            );
            assert!(!gap.is_open(last) && gap.is_moderate_beyond(2.0 * last));
            let (farther, _) = gap.beyond(2.0 * last);
            assert!(farther > 1.5 * load && farther < 6.0 * load, "{farther:e} from {load:e}");
            match gap.tail {
                Some(tail) => {
                    let (within, x) = (end - 0.5 * tail.begin, 0.5 * tail.begin);
                    let off = gap.beyond(within).0 / tail.at(x).0 - 1.0;
                    assert!(off.abs() < 1e-6 && !gap.is_open(within) && !gap.is_moderate_beyond(within), "{off:e}");
                }
                None => {
                    let (load, _) = gap.table().at_load(-(end - step)).expect("the table answers");
                    assert!((load / (3.0 * branch(gamma).pull_off_load()) - 1.0).abs() < 1e-3, "{load:e}");
                }
            }
        }
    }
}
