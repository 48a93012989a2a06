//! Quadrature nodes that serve every separation: with equal radii the contacts depend on overlap alone.

use super::gauss_legendre::POINTS;
use super::{Point, Population, Sink, Summit};
use crate::asperity::maugis::Contact;

/// Panels are tabulated up to this overlap, in sigma: enough for all summits at separations above -8.
pub const LARGEST_OVERLAP: f64 = 18.0;
/// The longest panel, in sigma: short enough for the steep upper tails too.
const LONGEST: f64 = 1.0;
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
    nodes: &'a [Node],
}

impl<'a> Panel<'a> {
    pub fn nodes(&self) -> &'a [Node] {
        self.nodes
    }
}

/// Panels from break-away upwards.
#[derive(Debug, Clone)]
pub struct Nodes {
    ends: Vec<Point>,
    nodes: Vec<Node>,
}

impl Nodes {
    /// Tabulates the panels of a population of equal radii.
    pub fn new(population: &Population) -> Self {
        let contact = population.maugis.break_away(1.0);
        let start = Point { z: contact.overlap, g: 1.0, g_rate: 0.0, contact };
        let mut collecting = Collecting { population, table: Nodes { ends: vec![start], nodes: Vec::new() } };
        population.march_by(start, LARGEST_OVERLAP, |_| LONGEST, &mut collecting);
        collecting.table
    }

    pub fn panels(&self) -> impl Iterator<Item = Panel<'_>> {
        self.ends.windows(2).zip(self.nodes.chunks(POINTS)).map(|(ends, nodes)| Panel {
            from: &ends[0],
            to: &ends[1],
            nodes,
        })
    }

    /// Where the tabulated panels end.
    pub fn last_point(&self) -> Point {
        self.ends[self.ends.len() - 1]
    }
}

struct Collecting<'a> {
    population: &'a Population,
    table: Nodes,
}

impl Sink for Collecting<'_> {
    fn panel(&mut self, _from: &Point, to: &Point) {
        if self.table.ends.len() <= MOST_PANELS {
            self.table.ends.push(*to);
        }
    }

    fn node(&mut self, z: f64, weight: f64, contact: &Contact) {
        if self.table.nodes.len() < MOST_PANELS * POINTS {
            let summit = self.population.summit(contact);
            self.table.nodes.push(Node { overlap: z, weight, summit });
        }
    }
}
