//! The sums over summits that attract out of contact.

use super::break_edges::Edge;
use super::density::Density;
use super::panels::MOST_PANELS;
use super::sums::{Summit, Sums};
use super::Population;
use crate::asperity::attraction::{Attracted, Attraction, ATTRACTION_LAMBDA_CUBED};
use crate::gauss_legendre;
use crate::root;
use crate::surface::heights::{Heights, SHORTEST_PANEL};

/// One panel of attraction with varying radius spans no more than this ratio of sqrt(gap terms).
pub const CIRCLE_RATIO: f64 = 4.0;

impl Population {
    /// The attraction of summits of a radius factor when they are out of contact, where there is one.
    pub(super) fn attraction_of(&self, g: f64) -> Option<&Attraction> {
        self.attraction.as_ref().filter(|_| self.lambda_cubed * g < ATTRACTION_LAMBDA_CUBED)
    }

    /// The attraction of a summit out of contact, where there is one.
    pub(super) fn attraction_at(&self, separation: f64, z: f64) -> Option<Attracted> {
        let g = self.radius.factor(z);
        let law = self.attraction_of(g)?;
        let overlap = z - separation;
        (overlap >= -law.reach).then(|| law.at(law.circle(overlap, g), g))
    }

    /// Adds the summits that attract without contact between two heights.
    pub(super) fn add_attractions(
        &self,
        sums: &mut Sums,
        density: &Density,
        separation: f64,
        lower: f64,
        upper: f64,
        upper_edge: Option<&Edge>,
    ) {
        let Some(law) = &self.attraction else { return };
        let Some((lower, upper)) = self.where_attraction_exists(lower, upper) else { return };
        let mut z = lower;
        let mut overlap = lower - separation;
        // Heights at the far end of attraction: there it sets in with a jump.
        if lower == separation - law.reach {
            overlap = -law.reach;
            let g = self.radius.factor(lower);
            sums.load_slope -= density.at(lower, overlap) * law.at(law.circle(overlap, g), g).load;
        }
        if let Heights::Ends(ends) = &self.heights {
            let log_scale = sums.log_scale;
            let add = |mass, summit: Summit| sums.add_attraction(mass, &summit);
            if !self.attracted_between_ends(ends, law, (lower, overlap), upper, log_scale, add) {
                *sums = Sums::unknown();
            }
            return;
        }
        let mut sink = |z: f64, overlap: f64, weight: f64| {
            let g = self.radius.factor(z);
            let attracted = law.at(law.circle(overlap, g), g);
            let summit =
                Summit { load: attracted.load, load_by_overlap: attracted.load_by_overlap, ..Summit::default() };
            sums.add_attraction(weight * density.at(z, overlap), &summit);
        };
        if let Some(panel) = self.foot_panel(z, upper, || overlap + law.reach) {
            for (v, w) in gauss_legendre::nodes(0.0, 1.0) {
                let (rise, rate) = panel.at(v);
                sink(z + rise, overlap + rise, w * rate);
            }
            z += panel.length;
            overlap += panel.length;
        }
        // Overlaps are small differences of heights: keep the ends that are known as overlaps.
        let end = match upper_edge {
            Some(edge) if edge.z == upper => edge.contact.overlap,
            _ => upper - separation,
        };
        // The smallest summits are attracted within a layer that is thinner than a rounding.
        let shortest = (SHORTEST_PANEL * (end - overlap)).max(4.0 * f64::EPSILON * overlap.abs());
        for _ in 0..MOST_PANELS {
            if overlap >= end {
                return;
            }
            let mut length = self.without_remnant(self.smooth_length(z, true, f64::NEG_INFINITY), end - overlap);
            let g = self.radius.factor(z);
            let here = law.at(law.circle(overlap, g), g);
            let mut circle_end = law.circle(overlap + length, g);
            if !self.radius.is_constant() {
                let farthest = law.at_rate(CIRCLE_RATIO * here.overlap_rate, g);
                let rise = farthest.overlap - here.overlap;
                if rise < shortest {
                    length = shortest.min(length);
                    circle_end = law.circle(overlap + length, g);
                } else if rise < length {
                    length = rise;
                    circle_end = farthest.circle;
                }
            }
            let part = self.fineness * self.part_of_smooth(z, length, f64::MAX);
            for (circle, weight) in gauss_legendre::nodes_of_part(part, here.circle, circle_end) {
                let reference = law.at(circle, g);
                let rise = reference.overlap - here.overlap;
                sink(z + rise, overlap + rise, weight * reference.overlap_rate);
            }
            z += length;
            overlap += length;
        }
        *sums = Sums::unknown();
    }

    /// The part of a range of heights in which summits out of contact attract: lambda_g^3 < 9/32.
    pub(super) fn where_attraction_exists(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
        let exists = |z: f64| self.lambda_cubed * self.radius.factor(z) - ATTRACTION_LAMBDA_CUBED;
        if lower >= upper {
            return None;
        }
        // g is monotonic in z, so that there is at most one threshold.
        match (exists(lower) < 0.0, exists(upper) < 0.0) {
            (true, true) => Some((lower, upper)),
            (false, false) => None,
            (true, false) => Some((lower, root::bracketed(exists, lower, upper))),
            (false, true) => Some((root::bracketed(exists, lower, upper), upper)),
        }
    }
}
