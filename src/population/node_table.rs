//! Contacts that serve every separation: with equal radii they depend on overlap alone.
//!
//! Panels from break-away upwards keep the contacts at their nodes. Where the density of heights is smooth over a whole panel, it
//! is taken there. Where heights begin, end or are not smooth within it, what contacts contribute is the polynomial through the nodes:
//! the integrals of the density times Legendre polynomials say what each node weighs, and no contact is solved. So it is far below the
//! heights too, where one panel holds them all.

use super::panels::{Axis, Nodes, SummitPanel};
use super::sums::{out_of_panels, Summit};
use super::walk::{Progress, Visitor, Walk};
use super::{Point, Population};
use crate::distribution::panel::{self, LowerEndPanel, SHORTEST_PANEL};
use crate::error::Error;
use crate::numerics::legendre::Moments;
use crate::numerics::quadrature::{self, POINTS};

/// Up to this far above break-away, in sigma, panels are so short that the density is smooth over each, as far as it
/// is; beyond they are as long as the law of contact allows. A panel takes 1 kB.
const LONG_FROM: f64 = 20.0;
const MOST_SHORT: usize = 36;
/// Farther above break-away than this, in sigma or, if that is more, times the overlap there, contacts are walked.
const FARTHEST_NODE: f64 = 1e5;
/// Nearer to break-away than this, in sigma or, where it is farther, parts of its overlap, panels are laid in the parameter of the law, and
/// walked where the density is not smooth.
const NEAR_BREAK_AWAY: f64 = 0.002;
/// Farther away they are laid in the square root of the height above break-away, from 0 of which the law of contact is smooth.
/// It grows by no more than this factor: a polynomial through the nodes then follows slopes to 1e-11 from weak adhesion
/// to JKR's, and values to 1e-13.
const MOST_ROOT_GROWTH: f64 = 2.0;
/// A piece of a polynomial density that is less than these parts of a panel needs 4 nodes, and 6.
const SHORT_PIECES: [f64; 2] = [0.1, 0.3];

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
    to: Point,
    /// The roots of the heights above break-away at both ends, where it is laid in them.
    roots: Option<(f64, f64)>,
    /// The weights without the density of heights.
    weights: [f64; POINTS],
    summits: [Summit; POINTS],
}

/// What part of a panel in height one between two roots may be: towards its end the height changes faster.
fn part_in_roots((from, to): (f64, f64)) -> f64 {
    0.5 * (1.0 + from / to)
}

impl NodeTable {
    /// Tabulates the panels of a population of equal radii.
    pub fn new(population: &Population) -> Self {
        let population = &population.without_tables();
        let edge = population.edge(0.0).point;
        let reach = panel::tail_panel_length(&*population.heights);
        let near = if population.heights.outline().support.0.is_finite() {
            edge.z + NEAR_BREAK_AWAY * (1.0 + edge.z.abs())
        } else {
            f64::INFINITY
        };
        let mut table = NodeTable { edge, panels: Vec::new(), end: edge };
        let (mut kink, mut nodes) = (None, Nodes::default());
        while table.end.z < edge.z + FARTHEST_NODE * (1.0 + edge.z.abs()) {
            let clearance = table.end.z - edge.z;
            let is_short = clearance < LONG_FROM && table.panels.len() < MOST_SHORT;
            let reach = if is_short { reach } else { f64::MAX };
            let is_near = is_short && table.end.z < near;
            let panel = match is_near {
                true => population.panel(0.0, table.end, kink, clearance, [reach, f64::INFINITY], near),
                false => population.panel_in_roots(table.end, kink, edge.z, reach),
            };
            population.nodes(0.0, &panel, &mut nodes);
            table.panels.push(TablePanel {
                to: panel.to,
                roots: (!is_near).then(|| (panel.variable(&panel.from), panel.variable(&panel.to))),
                weights: nodes.map(|(weight, _)| weight),
                summits: nodes.map(|(_, point)| population.summit(&point)),
            });
            (table.end, kink) = (panel.to, panel.kink);
        }
        table.panels.shrink_to_fit();
        table
    }
}

impl Population {
    /// The panel from a summit far enough from break-away, at separation 0.
    fn panel_in_roots(&self, here: Point, kink: Option<usize>, edge: f64, reach: f64) -> SummitPanel {
        let clearance = here.z - edge;
        let longest = (MOST_ROOT_GROWTH * MOST_ROOT_GROWTH - 1.0) * clearance;
        let rise = longest.min(reach);
        let part = part_in_roots((clearance.sqrt(), (clearance + rise).sqrt()));
        let rise = longest.min(part * reach).max(SHORTEST_PANEL);
        let to = self.at_height(0.0, here.z + rise, here.contact.parameter);
        let axis = Axis::Root(edge);
        let mut panel = SummitPanel { axis, from: here, to, kink: None, part: 1.0, is_eased: false };
        self.cut_at_kink(0.0, &mut panel, kink);
        panel
    }

    /// Hands summits in contact to a visitor from the table.
    pub(super) fn walk_table<V: Visitor>(&self, table: &NodeTable, walk: &Walk, visitor: &mut V) -> Result<(), Error> {
        let separation = walk.separation;
        let mut progress = Progress::default();
        let largest = self.heights.log_density(walk.start.z.max(self.heights.outline().last_mode));
        let (_, highest) = self.heights.outline().support;
        let mut start = Some(walk.start);
        let mut from = table.edge.raised(separation);
        for panel in &table.panels {
            let to = separation + panel.to.z;
            let begin = std::mem::replace(&mut from, panel.to.raised(separation));
            if start.is_some_and(|start| start.z >= to) {
                continue;
            }
            let from_start = start.take().unwrap_or(begin);
            let (z, overlap) = (from_start.z, from_start.contact.overlap);
            let log_density = self.heights.log_density(z);
            if self.is_rest_negligible(&progress, z, overlap, log_density) {
                return Ok(());
            }
            let longer = self.panel_factor(largest, z, log_density);
            let as_one = longer * panel.roots.map_or(1.0, part_in_roots);
            if z <= begin.z && to <= highest && panel::is_one_panel(&*self.heights, z, to, as_one) {
                let overlaps = panel.summits.map(|summit| summit.overlap);
                let heights = overlaps.map(|overlap| separation + overlap);
                let densities = self.densities::<POINTS>(separation, heights, overlaps);
                for i in 0..POINTS {
                    let fraction = panel.weights[i] * densities[i];
                    progress.add(fraction, overlaps[i]);
                    visitor.summits(heights[i], fraction, &panel.summits[i]);
                }
                visitor.end_of_panel(&from);
            } else if let Some(roots) = panel.roots.filter(|_| visitor.is_smooth()) {
                let part = Part { separation, break_away: table.edge.z, roots, from: z, to: to.min(highest), longer };
                let weights = self.weights_of(&part, &mut progress)?;
                for (weight, summit) in weights.iter().zip(&panel.summits) {
                    visitor.summits(separation + summit.overlap, *weight, summit);
                }
                visitor.end_of_panel(&from);
            } else {
                self.walk(&Walk { start: from_start, end: to, ..*walk }, &mut progress, visitor)?;
            }
            if to >= highest {
                return Ok(());
            }
        }
        let rest = start.unwrap_or(table.end.raised(separation));
        self.walk(&Walk { start: rest, ..*walk }, &mut progress, visitor)
    }

    /// What the nodes of a panel weigh of which a part holds heights, or over which the density is not smooth.
    fn weights_of(&self, part: &Part, progress: &mut Progress) -> Result<[f64; POINTS], Error> {
        let (heights, mut z) = (&*self.heights, part.from);
        let (clearance, (from, to)) = (z - part.edge(), part.roots);
        let mut moments = Moments::default();
        if let Some(panel) = LowerEndPanel::new(heights, z, part.to - z, clearance) {
            let nodes = panel.nodes(heights);
            nodes.iter().for_each(|(rise, fraction)| progress.add(*fraction, z + rise - part.separation));
            moments.add(&nodes.map(|(rise, _)| part.place(part.root(z + rise))), &nodes.map(|(_, fraction)| fraction));
            z += panel.length;
        }
        for _ in 0..panel::MOST_PANELS_OF_SUM {
            let is_polynomial = heights.outline().is_piecewise_polynomial;
            let is_rest = |z| self.is_rest_negligible(progress, z, z - part.separation, heights.log_density(z));
            if z >= part.to || !is_polynomial && is_rest(z) {
                return Ok(moments.weights());
            }
            let length = panel::panel_length(heights, z);
            let end = match is_polynomial {
                true => z + length,
                false => z + length * part.longer * part_in_roots((part.root(z), part.root(z + length * part.longer))),
            };
            // What little would be left is part of this one.
            let end = if part.to - end <= panel::slack(end) { part.to } else { end };
            let roots = (part.root(z), part.root(end));
            // The difference of the roots, with the digits of heights far above break-away.
            let width = (end - z) / (roots.0 + roots.1);
            let add = match SHORT_PIECES.map(|piece| is_polynomial && width < piece * (to - from)) {
                [true, _] => Self::add_heights::<4>,
                [_, true] => Self::add_heights::<6>,
                _ => Self::add_heights::<POINTS>,
            };
            add(self, part, (z, roots.0), width, &mut moments, progress);
            z = end;
        }
        Err(out_of_panels(part.separation))
    }

    /// Adds what heights from one up contribute to moments, over a stretch in roots.
    fn add_heights<const N: usize>(
        &self,
        part: &Part,
        (from, root): (f64, f64),
        width: f64,
        moments: &mut Moments,
        progress: &mut Progress,
    ) {
        let nodes = quadrature::points::<N>(0.0, width)
            .map(|(wider, weight)| (from + wider * (2.0 * root + wider), root + wider, weight));
        let heights: [f64; POINTS] = std::array::from_fn(|i| nodes[i.min(N - 1)].0);
        let overlaps: [f64; POINTS] = std::array::from_fn(|i| {
            let overlap = part.break_away + nodes[i.min(N - 1)].1.powi(2);
            if overlap.abs() < heights[i].abs() {
                overlap
            } else {
                heights[i] - part.separation
            }
        });
        let densities = self.densities::<N>(part.separation, heights, overlaps);
        let fractions: [f64; N] = std::array::from_fn(|i| {
            let (_, root, weight) = nodes[i];
            let fraction = 2.0 * root * weight * densities[i];
            progress.add(fraction, overlaps[i]);
            fraction
        });
        moments.add(&nodes.map(|(_, root, _)| part.place(root)), &fractions);
    }
}

/// A part of a panel that holds heights, at a separation.
struct Part {
    separation: f64,
    /// The overlap at which contact breaks.
    break_away: f64,
    /// The roots at both ends of the panel.
    roots: (f64, f64),
    from: f64,
    to: f64,
    /// By how much panels of the density may be longer.
    longer: f64,
}

impl Part {
    fn edge(&self) -> f64 {
        self.separation + self.break_away
    }

    fn root(&self, z: f64) -> f64 {
        (z - self.edge()).max(0.0).sqrt()
    }

    /// Where on the panel a root is, from -1 to 1.
    fn place(&self, root: f64) -> f64 {
        let (from, to) = self.roots;
        (2.0 * root - (from + to)) / (to - from)
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{bins, of, surface, table, yielding, FOLD, HERTZ, WEAK};
    use crate::params::HeightFamily;

    /// Where the lower end and breakpoints lie within panels, from the last contacts to far below, and where all heights pass the
    /// slip law's second radius.
    #[test]
    fn the_table_gives_the_sums_of_a_walk() {
        let johnson = |skew, kurtosis| HeightFamily::Johnson { skew, kurtosis };
        let weibull = |shape| HeightFamily::Weibull { shape };
        let families = [
            HeightFamily::Gaussian,
            weibull(1.0),
            weibull(1.1),
            weibull(1.5),
            weibull(3.6),
            weibull(20.0),
            johnson(1.0, 5.0),
            johnson(-1.0, 3.6),
            johnson(0.0, 9.0),
            table(),
            bins(12),
            bins(100),
            bins(250),
        ];
        for heights in &families {
            let mut surfaces = vec![yielding([0.05, 100.0, 0.0, 1.0], heights.clone(), [0.0, 1.0])];
            surfaces.extend([WEAK, FOLD, HERTZ].map(|groups| surface(groups, heights.clone(), [0.0, 1.0])));
            for params in surfaces {
                let population = of(&params);
                let walked = population.without_tables();
                let [_, second] = population.slip.kinks();
                let kink = -population.contact_of_radius(second, 1.0).expect("a contact").overlap;
                for above_mean in [kink, -9e4, -1e3, -60.0, -21.0, -10.0, -3.0, -1.4, -0.2, 0.6, 1.3, 2.0, 3.0, 5.0] {
                    let separation = above_mean - population.heights.outline().origin;
                    let (a, b) = (population.at_separation(separation), walked.at_separation(separation));
                    for (name, a, b, tolerance) in [
                        ("load", a.load_contacting, b.load_contacting, 1e-9),
                        ("friction", a.friction, b.friction, 1e-9),
                        ("area", a.area, b.area, 1e-9),
                        ("contacting", a.contacting, b.contacting, 1e-9),
                        ("dP/dd", a.load_slope, b.load_slope, 1e-9),
                        ("dF/dd", a.friction_slope, b.friction_slope, 1e-9),
                    ] {
                        let error = (a - b).abs();
                        // Where all heights are that far below others overlaps are as much less exact.
                        let tolerance = tolerance + 0.2 * f64::EPSILON * separation.abs();
                        assert!(
                            error <= tolerance * b.abs(),
                            "{name} of {params:?} at {above_mean}: {error:e} of {b:e}"
                        );
                    }
                }
            }
        }
    }
}
