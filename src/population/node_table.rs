//! Quadrature nodes that serve every separation: with equal radii the contacts depend on overlap alone.

use super::sums::Summit;
use super::walk::{Progress, Visitor, Walk};
use super::{Point, Population};
use crate::distribution::panel;
use crate::error::Error;
use crate::numerics::quadrature::POINTS;

/// Panels are tabulated up to this overlap, in sigma: as far as the rule for separations far below the heights
/// does not serve Gaussian heights.
const LARGEST_OVERLAP: f64 = 31.0;
/// A tabulated panel takes 1 kB; deeper ones are walked when needed.
const MOST_PANELS: usize = 36;

/// Panels from break-away upwards, at separation 0.
#[derive(Debug, Clone)]
pub struct NodeTable {
    /// Where contact breaks.
    pub edge: Point,
    panels: Vec<TablePanel>,
    end: Point,
}

#[derive(Debug, Clone)]
struct TablePanel {
    from: Point,
    to: Point,
    /// The weights without the density of heights.
    weights: [f64; POINTS],
    summits: [Summit; POINTS],
}

impl NodeTable {
    /// Tabulates the panels of a population of equal radii.
    pub fn new(population: &Population, edge: Point) -> Self {
        let reach = panel::tail_panel_length(&*population.heights);
        let mut table = NodeTable { edge, panels: Vec::new(), end: edge };
        let mut kink = None;
        while table.end.z < LARGEST_OVERLAP && table.panels.len() < MOST_PANELS {
            let clearance = table.end.z - edge.z;
            let panel = population.panel(0.0, table.end, kink, clearance, reach, f64::INFINITY);
            let nodes = population.nodes(0.0, &panel);
            let summit = |point: Point| Summit::new(&point.contact, population.slip.friction(&point.contact));
            table.panels.push(TablePanel {
                from: panel.from,
                to: panel.to,
                weights: nodes.map(|(weight, _)| weight),
                summits: nodes.map(|(_, point)| summit(point)),
            });
            (table.end, kink) = (panel.to, panel.kink);
        }
        table.panels.shrink_to_fit();
        table
    }
}

impl Population {
    /// Hands summits in contact to a visitor from the table; panels across which the density is not smooth are walked anew.
    pub(super) fn walk_table(&self, table: &NodeTable, walk: &Walk, visitor: &mut impl Visitor) -> Result<(), Error> {
        let separation = walk.separation;
        let mut progress = Progress::default();
        let largest = self.heights.log_density(walk.start.z.max(self.heights.last_mode()));
        let (_, highest) = self.heights.support();
        let mut start = Some(walk.start);
        for panel in &table.panels {
            let (from, to) = (separation + panel.from.z, separation + panel.to.z);
            if start.is_some_and(|start| start.z >= to) {
                continue;
            }
            let from_start = start.take().unwrap_or_else(|| panel.from.raised(separation));
            let log_density = self.heights.log_density(from_start.z);
            if self.is_rest_negligible(&progress, &from_start, log_density) {
                return Ok(());
            }
            let longer = self.panel_factor(largest, from, log_density);
            if from_start.z > from || to > highest || !panel::is_one_panel(&*self.heights, from, to, longer) {
                self.walk(&Walk { start: from_start, end: to, ..*walk }, &mut progress, visitor)?;
            } else {
                let overlaps = panel.summits.map(|summit| summit.overlap);
                let heights = overlaps.map(|overlap| separation + overlap);
                let densities = self.densities(separation, heights, overlaps);
                for i in 0..POINTS {
                    let fraction = panel.weights[i] * densities[i];
                    progress.add(fraction, overlaps[i]);
                    visitor.summits(heights[i], fraction, &panel.summits[i]);
                }
                visitor.end_of_panel(&panel.to.raised(separation));
            }
            if to >= highest {
                return Ok(());
            }
        }
        let rest = start.unwrap_or(table.end.raised(separation));
        self.walk(&Walk { start: rest, ..*walk }, &mut progress, visitor)
    }
}
