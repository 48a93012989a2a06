//! The sums over summits that attract out of contact.
//!
//! Panels are laid in the radius of the circle of interaction, of which the overlap is a quadratic polynomial.

use super::sums::{out_of_panels, Sums};
use super::{Edge, Population};
use crate::asperity::attraction::{Attracted, Attraction, ATTRACTION_LAMBDA_CUBED};
use crate::distribution::panel::{self, LowerEndPanel, MOST_PANELS_OF_SUM, SHORTEST_PANEL};
use crate::error::Error;
use crate::numerics::elementary::exp;
use crate::numerics::quadrature::{self, POINTS};
use crate::numerics::root;

/// One panel of attraction with varying radius spans no more than this ratio of du/dc.
const CIRCLE_RATIO: f64 = 4.0;

/// A range of summits that attract.
pub(super) struct AttractedRange<'a> {
    law: &'a Attraction,
    /// Whether attraction sets in at its lower end, with a jump.
    sets_in: bool,
    /// Its ends, as height and overlap.
    from: (f64, f64),
    to: (f64, f64),
}

impl Population {
    /// The attraction of a summit of height z out of contact, where there is one.
    pub(super) fn attraction_at(&self, overlap: f64, z: f64) -> Option<Attracted> {
        self.attraction_of(overlap, self.radius.factor(z))
    }

    /// The same of a summit whose radius is so many times the mean one.
    pub(super) fn attraction_of(&self, overlap: f64, g: f64) -> Option<Attracted> {
        let law = self.attraction.as_ref().filter(|_| self.lambda_cubed * g < ATTRACTION_LAMBDA_CUBED)?;
        (overlap >= -law.reach).then(|| law.at_overlap(overlap, g))
    }

    /// Adds the summits below the edge of contact that attract.
    pub(super) fn add_attractions(&self, sums: &mut Sums, separation: f64, edge: &Edge) {
        let Some(range) = self.attracted_range(separation, edge) else { return };
        let law = range.law;
        if range.sets_in {
            let (z, overlap) = range.from;
            let g = self.radius.factor(z);
            sums.load_slope -= exp(self.heights.log_density(z)) * law.at_overlap(overlap, g).load;
        }
        let found = self.visit_attracted(&range, separation, |z, overlap, fraction| {
            let g = self.radius.factor(z);
            let attracted = law.at_overlap(overlap, g);
            sums.add_attraction(fraction, attracted.load, attracted.load_by_overlap);
        });
        if found.is_err() {
            *sums = Sums::unknown();
        }
    }

    /// Where summits below the edge of contact attract.
    pub(super) fn attracted_range(&self, separation: f64, edge: &Edge) -> Option<AttractedRange<'_>> {
        let law = self.attraction.as_ref()?;
        let lower = (separation - law.reach).max(self.lower_cut);
        let upper = edge.point.z.min(self.highest);
        let (lower, upper) = self.where_attraction_exists(lower, upper)?;
        // Overlaps are small differences of heights: keep the ends that are known as overlaps.
        let sets_in = lower == separation - law.reach;
        let from = (lower, if sets_in { -law.reach } else { lower - separation });
        let to = (upper, if upper == edge.point.z { edge.point.contact.overlap } else { upper - separation });
        Some(AttractedRange { law, sets_in, from, to })
    }

    /// Hands the summits of a range to a visitor, as height, overlap and fraction of all.
    pub(super) fn visit_attracted(
        &self,
        range: &AttractedRange,
        separation: f64,
        mut visit: impl FnMut(f64, f64, f64),
    ) -> Result<(), Error> {
        let &AttractedRange { law, from, to: (upper, end), .. } = range;
        let (mut z, mut overlap) = self.attractions_at_lower_end(law, from, upper, &mut visit);
        // The smallest summits are attracted within a layer that is thinner than a rounding.
        let shortest = (SHORTEST_PANEL * (end - overlap)).max(4.0 * f64::EPSILON * overlap.abs());
        for _ in 0..MOST_PANELS_OF_SUM {
            if overlap >= end {
                return Ok(());
            }
            let here = law.at_overlap(overlap, self.radius.factor(z));
            let length = self.attraction_panel(&here, z, shortest).min(end - overlap);
            let span = here.span(length);
            let nodes = quadrature::panel(0.0, span).map(|(wider, weight)| {
                let (rise, rate) = here.rise(wider);
                (rise, weight * rate)
            });
            let [heights, overlaps] = [z, overlap].map(|from| nodes.map(|(rise, _)| from + rise));
            let densities = self.densities::<POINTS>(separation, heights, overlaps);
            for ((rise, weight), density) in nodes.into_iter().zip(densities) {
                visit(z + rise, overlap + rise, weight * density);
            }
            z += length;
            overlap += length;
        }
        Err(out_of_panels(separation))
    }

    /// The first panel where the range begins at a lower end at which the density is a power; returns where it ends, as height
    /// and overlap.
    fn attractions_at_lower_end(
        &self,
        law: &Attraction,
        (z, overlap): (f64, f64),
        upper: f64,
        visit: &mut impl FnMut(f64, f64, f64),
    ) -> (f64, f64) {
        let smooth = (overlap + law.reach).min(self.radius.panel_length(z));
        let Some(panel) = LowerEndPanel::new(&*self.heights, z, upper - z, smooth) else { return (z, overlap) };
        for (rise, fraction) in panel.nodes(&*self.heights) {
            visit(z + rise, overlap + rise, fraction);
        }
        (z + panel.length, overlap + panel.length)
    }

    /// How far a panel may reach from a summit of height z.
    fn attraction_panel(&self, here: &Attracted, z: f64, shortest: f64) -> f64 {
        let mut smooth = panel::panel_length(&*self.heights, z);
        if !self.heights.outline().is_piecewise_polynomial {
            // As a function of the circle the density is steepest at the far end, by du/dc there over the mean.
            let span = here.span(smooth);
            smooth *= smooth / (span * here.rise(span).1);
        }
        if self.radius.is_constant() {
            return smooth;
        }
        let (rise, _) = here.rise((CIRCLE_RATIO - 1.0) * here.overlap_rate / here.overlap_bend);
        rise.max(shortest).min(smooth).min(self.radius.panel_length(z))
    }

    /// The part of a range of heights in which summits out of contact attract: lambda_g^3 < 9/32.
    fn where_attraction_exists(&self, lower: f64, upper: f64) -> Option<(f64, f64)> {
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
