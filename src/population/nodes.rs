//! Quadrature nodes that serve every separation: with equal radii the contacts depend on overlap alone.

use super::panels::{Sink, LARGEST_OVERLAP};
use super::point::Point;
use super::sums::Summit;
use super::Population;
use crate::asperity::maugis::Contact;
use crate::gauss_legendre::POINTS;

/// A tabulated panel takes 0.9 kB; deeper ones are walked when needed.
const MOST_PANELS: usize = 48;

/// A quadrature node without the density of heights.
#[derive(Debug, Clone, Copy)]
pub struct Node {
    pub overlap: f64,
    pub weight: f64,
    pub summit: Summit,
}

/// A range of overlaps with its nodes; heights are those at zero separation.
#[derive(Debug, Clone)]
pub struct Panel<'a> {
    pub from: &'a Point,
    pub to: &'a Point,
    /// Whether it is short beside the distance to break-away, and may be as long as the density is smooth.
    pub by_height: bool,
    nodes: &'a [Node; POINTS],
}

impl<'a> Panel<'a> {
    pub fn nodes(&self) -> &'a [Node; POINTS] {
        self.nodes
    }
}

/// Panels from break-away upwards.
#[derive(Debug, Clone)]
pub struct Nodes {
    start: Point,
    /// Where each panel ends, and whether it is by height.
    ends: Vec<(Point, bool)>,
    nodes: Vec<Node>,
}

impl Nodes {
    /// Tabulates the panels of a population of equal radii.
    pub fn new(population: &Population) -> Self {
        let contact = population.maugis.break_away(1.0);
        let start = Point { z: contact.overlap, g: 1.0, g_rate: 0.0, contact };
        let longest = population.heights.tail_panel();
        let mut collecting = Collecting { population, table: Nodes { start, ends: Vec::new(), nodes: Vec::new() } };
        population.march_by(start, LARGEST_OVERLAP, |_| longest, &mut collecting);
        collecting.table
    }

    pub fn panels(&self) -> impl Iterator<Item = Panel<'_>> {
        let starts = std::iter::once(&self.start).chain(self.ends.iter().map(|(end, _)| end));
        starts.zip(&self.ends).zip(self.nodes.as_chunks().0).map(|((from, (to, by_height)), nodes)| Panel {
            from,
            to,
            by_height: *by_height,
            nodes,
        })
    }

    /// Where the tabulated panels end.
    pub fn last_point(&self) -> Point {
        self.ends.last().map_or(self.start, |&(end, _)| end)
    }
}

/// Fills the table. Panels have all points where heights have no knots.
struct Collecting<'a> {
    population: &'a Population,
    table: Nodes,
}

impl Sink for Collecting<'_> {
    const MOST_PANELS: usize = MOST_PANELS;

    fn panel(&mut self, _from: &Point, to: &Point, by_height: bool) {
        self.table.ends.push((*to, by_height));
    }

    fn node(&mut self, z: f64, weight: f64, contact: &Contact) {
        let summit = self.population.summit(contact);
        self.table.nodes.push(Node { overlap: z, weight, summit });
    }
}
