//! At which heights contact ends: the heights where an asperity just breaks away.
//!
//! A summit of height z is in contact at separation d where z - u_break(g(z)) > d. The left side does not
//! depend on d, so its extrema, which only a strongly varying radius gives it, are found once.

use crate::asperity::maugis::{Contact, Maugis};
use crate::root;
use crate::surface::radius::RadiusProfile;

/// Summits break away at this height.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    /// Height in sigma.
    pub z: f64,
    /// The contact that is about to break.
    pub contact: Contact,
    /// d(z - u_break)/dz: positive where the summits above are in contact, negative where those below are.
    pub rate: f64,
}

/// No profile of eq (3) gives z - u_break(g(z)) more monotonic pieces than this.
const MOST_EDGES: usize = 8;

/// z - u_break(g(z)) in pieces on which it is monotonic.
#[derive(Debug, Clone)]
pub struct BreakEdges {
    /// The ends of the pieces, over all heights that matter.
    knots: Vec<f64>,
    /// No summit breaks away at a smaller overlap.
    deepest: f64,
    /// The break-away of all summits where their radii are equal.
    common: Option<Contact>,
}

/// The edges at one separation, from low to high.
#[derive(Debug, Default)]
pub struct Edges {
    items: [Option<Edge>; MOST_EDGES],
    length: usize,
}

impl Edges {
    /// From low to high.
    pub fn iter(&self) -> impl Iterator<Item = &Edge> {
        self.items[..self.length].iter().flatten()
    }

    fn push(&mut self, edge: Edge) {
        if self.length < MOST_EDGES {
            self.items[self.length] = Some(edge);
            self.length += 1;
        }
    }
}

impl BreakEdges {
    /// Looks for the extrema between two heights.
    pub fn new(maugis: &Maugis, radius: &RadiusProfile, lowest: f64, highest: f64) -> Self {
        let common = maugis.break_away(1.0);
        let mut edges = Self { knots: vec![lowest], deepest: common.overlap, common: Some(common) };
        if !radius.is_constant() {
            edges.common = None;
            let mut z = lowest;
            let mut here = edge(maugis, radius, z);
            edges.deepest = edges.deepest.min(1.1 * here.contact.overlap);
            while z < highest {
                let next = (z + 0.25 * radius.smooth_length(z)).min(highest);
                let there = edge(maugis, radius, next);
                edges.deepest = edges.deepest.min(1.1 * there.contact.overlap);
                if (here.rate < 0.0) != (there.rate < 0.0) {
                    edges.knots.push(root::bracketed(|z| edge(maugis, radius, z).rate, z, next));
                }
                (z, here) = (next, there);
            }
        }
        edges.knots.push(highest);
        edges
    }

    /// No summit breaks away at a smaller overlap than this.
    pub fn deepest(&self) -> f64 {
        self.deepest
    }

    /// The break-away of a summit of radius factor g.
    pub fn break_away(&self, maugis: &Maugis, g: f64) -> Contact {
        self.common.unwrap_or_else(|| maugis.break_away(g))
    }

    /// The edges at a separation.
    pub fn at_separation(&self, maugis: &Maugis, radius: &RadiusProfile, separation: f64) -> Edges {
        let mut edges = Edges::default();
        if let Some(contact) = self.common {
            edges.push(Edge { z: separation + contact.overlap, contact, rate: 1.0 });
            return edges;
        }
        let excess = |z: f64| (z - separation) - maugis.break_away(radius.factor(z)).overlap;
        for piece in self.knots.windows(2) {
            // An edge lies between d + deepest and d, rounding apart.
            let slack = 1e-9 * (1.0 + separation.abs());
            let lower = (separation + self.deepest - slack).clamp(piece[0], piece[1]);
            let upper = (separation + slack).clamp(piece[0], piece[1]);
            if (excess(lower) > 0.0) != (excess(upper) > 0.0) {
                edges.push(edge(maugis, radius, root::bracketed(excess, lower, upper)));
            }
        }
        edges
    }

    /// Whether, at a separation without edges, all summits are in contact rather than none.
    pub fn all_in_contact(&self, maugis: &Maugis, radius: &RadiusProfile, separation: f64) -> bool {
        let z = self.knots[0];
        z - separation > maugis.break_away(radius.factor(z)).overlap
    }
}

/// The edge at height z, at whatever separation it is one.
fn edge(maugis: &Maugis, radius: &RadiusProfile, z: f64) -> Edge {
    let (g, g_rate) = radius.at(z);
    let contact = maugis.break_away(g);
    // At break-away du/dtheta = 0, so that du_break/dg is the partial derivative.
    Edge { z, contact, rate: 1.0 - contact.overlap_by_g * g_rate }
}
