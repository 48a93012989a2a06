//! Goes over the summits in contact at a separation, from the lowest up to where the rest is negligible, and hands each to whoever sums.

use super::panels::{Axis, Nodes, SummitPanel};
use super::sums::{out_of_panels, Summit};
use super::{Point, Population};
use crate::distribution::panel::{self, LowerEndPanel, MOST_PANELS_OF_SUM, SHORTEST_PANEL};
use crate::error::Error;
use crate::numerics::elementary::exp;
use crate::numerics::quadrature::POINTS;

/// Where the density has fallen by e-folds since its largest value fewer digits of it count: a panel may be longer by this
/// for each, up to twice as long.
const LONGER_PER_FOLD: f64 = 0.02;
/// What is less than this part of all above the last mode of the heights ends the sum.
const NEGLIGIBLE_REST: f64 = 1e-12;
const NEGLIGIBLE_TO_ROUGH: f64 = 1e-7;
/// A slope of ln phi, per sigma, over which rounding errors of heights change the density by no small part.
const STEEPEST_DENSITY: f64 = 1e9;

/// What the summits in contact are handed to. A walk is compiled once for all: a copy of it takes 8 kB.
pub trait Visitor {
    /// Whether what it makes of a summit is as smooth as the law of contact: then some fractions may be negative, not their sum.
    fn is_smooth(&self) -> bool {
        false
    }
    /// Takes the summits at a height, with their fraction of all.
    fn summits(&mut self, z: f64, fraction: f64, summit: &Summit);
    /// Takes the last summit of a panel.
    fn end_of_panel(&mut self, _end: &Point) {}
}

/// The summits in contact to go over, from the lowest up.
#[derive(Debug, Clone, Copy)]
pub struct Walk {
    pub separation: f64,
    /// The lowest of them.
    pub start: Point,
    /// The height at which summits just break away.
    pub edge_height: f64,
    /// None of them is higher.
    pub end: f64,
}

/// How much has been summed, to know when the rest is negligible.
#[derive(Debug, Default)]
pub struct Progress {
    total: f64,
}

impl Progress {
    /// Takes in summits at an overlap. Load, area and friction grow no faster than the square of the overlap.
    #[inline]
    pub fn add(&mut self, fraction: f64, overlap: f64) {
        self.total += fraction * importance(overlap);
    }
}

/// What a summit counts beside others.
#[inline]
fn importance(overlap: f64) -> f64 {
    let scale = 1.0 + overlap.max(0.0);
    scale * scale
}

impl Population {
    /// What the sums take of a contact.
    pub(super) fn summit(&self, point: &Point) -> Summit {
        Summit::new(&point.contact, self.slip.friction(&point.contact))
    }

    /// Hands summits in contact to a visitor, up to where the rest is negligible.
    pub(super) fn walk(&self, walk: &Walk, progress: &mut Progress, visitor: &mut dyn Visitor) -> Result<(), Error> {
        let &Walk { separation, start, edge_height, end } = walk;
        let mut here = self.above_lower_end(walk, progress, visitor);
        let (mut kink, mut nodes) = (None, Nodes::default());
        let end = end.min(self.highest);
        let largest = self.heights.log_density(start.z.max(self.heights.outline().last_mode));
        for _ in 0..MOST_PANELS_OF_SUM {
            if here.z >= end {
                return Ok(());
            }
            let stop = self.stop_above(here.z).min(end);
            let log_density = self.heights.log_density(here.z);
            if self.is_rest_negligible(progress, here.z, here.contact.overlap, log_density) {
                return Ok(());
            }
            let reach = panel::panel_length(&*self.heights, here.z) * self.panel_factor(largest, here.z, log_density);
            let radii = self.radius.panel_length(here.z);
            let mut reach = reach.min(radii);
            let mut lay = |reach: f64| {
                let panel = self.panel(separation, here, kink, here.z - edge_height, [reach, radii], stop);
                self.nodes(separation, &panel, &mut nodes);
                (nodes.iter().all(|(_, point)| panel.follows(point)), panel)
            };
            let (mut follows, mut panel) = lay(reach);
            // Where radii change so fast that the height does not follow from the parameter, a shorter panel serves.
            while !follows && reach > SHORTEST_PANEL {
                reach *= 0.25;
                (follows, panel) = lay(reach);
            }
            let heights = std::array::from_fn(|i| nodes[i].1.z);
            let overlaps = std::array::from_fn(|i| nodes[i].1.contact.overlap);
            let densities = self.densities::<POINTS>(separation, heights, overlaps);
            for ((weight, point), density) in nodes.iter().zip(densities).take_while(|((weight, _), _)| *weight != 0.0)
            {
                let fraction = weight * density;
                progress.add(fraction, point.contact.overlap);
                visitor.summits(point.z, fraction, &self.summit(point));
            }
            visitor.end_of_panel(&panel.to);
            (here, kink) = (panel.to, panel.kink);
        }
        Err(out_of_panels(separation))
    }

    /// How much longer a panel may be where the density has fallen from its largest value, both given by their logarithms.
    pub(super) fn panel_factor(&self, largest: f64, z: f64, log_density: f64) -> f64 {
        if z < self.heights.outline().last_mode {
            return 1.0;
        }
        // No number where the density is 0.
        let fall = (largest - log_density).max(0.0);
        (1.0 + fall * LONGER_PER_FOLD).min(2.0)
    }

    /// Whether the summits above one add nothing to what has been summed: above the last mode, where the density falls on. Of a table
    /// that may be as slowly as can be, elsewhere its logarithm falls about as fast as there.
    pub(super) fn is_rest_negligible(&self, progress: &Progress, z: f64, overlap: f64, log_density: f64) -> bool {
        if z < self.heights.outline().last_mode {
            return false;
        }
        let density = exp(log_density);
        // Where the density is 0 it has no rate.
        density == 0.0 || {
            let (rate, rise) = match self.heights.outline().is_piecewise_polynomial {
                true => (1.0 / (self.highest - z), self.highest - z),
                false => (-self.heights.log_density_slope(z), 0.0),
            };
            let rest = if self.is_rough { NEGLIGIBLE_TO_ROUGH } else { NEGLIGIBLE_REST };
            density * importance(overlap + rise) <= rest * progress.total * rate
        }
    }

    /// The densities at the N nodes of a panel, given by their heights and overlaps: of small overlaps far out in a steep tail
    /// more digits count than heights have.
    #[inline]
    pub(super) fn densities<const N: usize>(
        &self,
        separation: f64,
        z: [f64; POINTS],
        overlaps: [f64; POINTS],
    ) -> [f64; POINTS] {
        let mut densities = self.heights.densities(z);
        // The slope of the logarithm in the middle, by the series of ln((1 + r)/(1 - r)).
        let (i, j) = (N / 2 - 1, N / 2);
        let r = (densities[j] - densities[i]) / (densities[j] + densities[i]);
        let slope = 2.0 * r * (1.0 + r * r * (1.0 / 3.0 + r * r * (1.0 / 5.0 + r * r / 7.0))) / (z[j] - z[i]);
        // Next to the end of the heights it is no number, or so large that a rounding error is no small change; little lies so near.
        let slope = if slope.abs() < STEEPEST_DENSITY { slope } else { 0.0 };
        for i in 0..N {
            let rounding = overlaps[i] - (z[i] - separation);
            densities[i] += densities[i] * (slope * rounding);
        }
        densities
    }

    /// The first panel where the range begins at a lower end of the distribution at which the density is a power; returns where
    /// it ends.
    fn above_lower_end(&self, walk: &Walk, progress: &mut Progress, visitor: &mut dyn Visitor) -> Point {
        let &Walk { separation, start, edge_height, end } = walk;
        let (lower_end, _) = self.heights.outline().support;
        let smooth = (start.z - edge_height).min(self.radius.panel_length(lower_end));
        let Some(panel) = LowerEndPanel::new(&*self.heights, start.z, end - lower_end, smooth) else { return start };
        // A kink of the slip law within so short a panel ends it.
        let to = self.at_height(separation, lower_end + panel.length, start.contact.parameter);
        let mut cut = SummitPanel { axis: Axis::Height, from: start, to, kink: None, part: 1.0, is_eased: false };
        self.cut_at_kink(separation, &mut cut, None);
        // Its nodes do not gather at its end: where contacts are about to slip is left to another.
        let length = if self.is_onset(cut.kink) { 0.5 } else { 1.0 } * (cut.to.z - lower_end);
        let panel = panel.shortened(length);
        let mut here = start;
        for (rise, fraction) in panel.nodes(&*self.heights) {
            here = self.at_height(separation, lower_end + rise, here.contact.parameter);
            progress.add(fraction, here.contact.overlap);
            visitor.summits(here.z, fraction, &self.summit(&here));
        }
        self.at_height(separation, lower_end + panel.length, here.contact.parameter)
    }
}
