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
        if let Some(item) = self.items.get_mut(self.length) {
            *item = Some(edge);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::groups::Groups;

    fn maugis(gamma: f64) -> Maugis {
        Maugis::new(&Groups { alpha: 0.01, beta: 100.0, gamma, b_over_h: 1.0 })
    }

    fn radius(amplitude: f64, rate: f64) -> RadiusProfile {
        RadiusProfile { amplitude, rate, origin: 0.0 }
    }

    #[test]
    fn without_adhesion_contact_ends_at_the_separation() {
        let (maugis, radius) = (maugis(0.0), radius(0.5, 1.0));
        let edges = BreakEdges::new(&maugis, &radius, -1e4, 1e4);
        for separation in [0.0, 0.3, -4.0, 5e3, -9e3] {
            let found = edges.at_separation(&maugis, &radius, separation);
            assert_eq!(found.iter().map(|edge| edge.z).collect::<Vec<_>>(), [separation]);
        }
    }

    /// Summits of strong adhesion whose radii fall so fast with height that the lower ones hold on longer.
    #[test]
    fn pieces_end_where_the_order_of_breaking_turns() {
        let maugis = maugis(0.02);
        for (rate, count) in [(0.2, 2), (5.0, 4), (20.0, 4), (80.0, 4)] {
            let radius = radius(-0.9, rate);
            let edges = BreakEdges::new(&maugis, &radius, -5.0, 5.0);
            assert_eq!(edges.knots.len(), count, "{rate}: {:?}", edges.knots);
            for &z in &edges.knots[1..count - 1] {
                assert!(edge(&maugis, &radius, z).rate.abs() < 1e-9 * rate, "{rate}: {z}");
            }
            for separation in (-20..60).map(|step| 0.1 * f64::from(step)) {
                for edge in edges.at_separation(&maugis, &radius, separation).iter() {
                    let overlap = maugis.break_away(radius.factor(edge.z)).overlap;
                    assert!((edge.z - separation - overlap).abs() < 1e-12, "{rate}, {separation}: {}", edge.z);
                }
            }
        }
    }

    #[test]
    fn no_summit_breaks_away_deeper_than_the_deepest() {
        let maugis = maugis(0.1);
        for (amplitude, lowest) in [(-1.0, -0.1), (-1.0, 0.3), (-0.9, -4.0), (1.0, -4.0), (0.5, 1.0)] {
            let radius = radius(amplitude, 2.0);
            let edges = BreakEdges::new(&maugis, &radius, lowest, 4.0);
            for part in 0..=1000 {
                let z = lowest + 0.001 * f64::from(part) * (4.0 - lowest);
                let overlap = maugis.break_away(radius.factor(z)).overlap;
                assert!(overlap < -1.1 || part > 0 || amplitude > 0.0, "{overlap}");
                assert!(overlap >= edges.deepest(), "{amplitude}, {z}: {overlap}, not {}", edges.deepest());
            }
        }
    }

    /// Whether it is the lowest or the highest, and whether those next to it hold on longer or not.
    #[test]
    fn a_summit_that_just_breaks_is_not_in_contact() {
        let maugis = maugis(0.02);
        for (amplitude, [lowest, highest], count) in
            [(0.5, [0.0, 1.0], 1), (0.5, [-1.0, 0.0], 0), (-0.9, [0.0, 0.01], 0), (-0.9, [-0.01, 0.0], 1)]
        {
            let radius = radius(amplitude, 20.0);
            let edges = BreakEdges::new(&maugis, &radius, lowest, highest);
            let separation = -maugis.break_away(1.0).overlap;
            let found = edges.at_separation(&maugis, &radius, separation);
            assert_eq!(found.iter().map(|edge| edge.z).collect::<Vec<_>>(), vec![0.0; count], "{amplitude}, {lowest}");
            assert!(count > 0 || !edges.all_in_contact(&maugis, &radius, separation), "{amplitude}, {lowest}");
        }
    }
}
