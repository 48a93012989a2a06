//! The sums over summits that attract out of contact.
//!
//! Panels are laid in the radius of the circle of interaction, of which the overlap is a quadratic polynomial.

use super::sums::{out_of_panels, Sums};
use super::{Edge, Population};
use crate::asperity::attraction::{Attracted, ATTRACTION_LAMBDA_CUBED};
use crate::distribution::panel::{self, LowerEndPanel, MOST_PANELS_OF_SUM, SHORTEST_PANEL};
use crate::error::Error;
use crate::numerics::elementary::exp;
use crate::numerics::quadrature::{self, POINTS};
use crate::numerics::root;

/// One panel of attraction with varying radius spans no more than this ratio of du/dc.
const CIRCLE_RATIO: f64 = 4.0;

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
    ///
    /// # Errors
    /// [`Error::NotConverged`] if that takes more panels than there may be.
    pub(super) fn add_attractions(&self, sums: &mut Sums, separation: f64, edge: &Edge) -> Result<(), Error> {
        let Some(law) = &self.attraction else { return Ok(()) };
        let lowest = (separation - law.reach).max(self.lower_cut);
        let highest = edge.point.z.min(self.highest);
        let Some((lower, upper)) = self.where_attraction_exists(lowest, highest) else { return Ok(()) };
        // Overlaps are small differences of heights: keep the ends that are known as overlaps.
        let sets_in = lower == separation - law.reach;
        let (mut z, mut overlap) = (lower, if sets_in { -law.reach } else { lower - separation });
        let end = if upper == edge.point.z { edge.point.contact.overlap } else { upper - separation };
        let at = |z: f64, overlap: f64| law.at_overlap(overlap, self.radius.factor(z));
        if sets_in {
            sums.load_slope -= exp(self.heights.log_density(z)) * at(z, overlap).load;
        }
        let mut add = |z: f64, overlap: f64, fraction: f64| {
            let attracted = at(z, overlap);
            sums.add_attraction(fraction, attracted.load, attracted.load_by_overlap);
        };
        let smooth = (overlap + law.reach).min(self.radius.panel_length(z));
        if let Some(panel) = LowerEndPanel::new(&*self.heights, z, upper - z, smooth) {
            for (rise, fraction) in panel.nodes(&*self.heights) {
                add(z + rise, overlap + rise, fraction);
            }
            z += panel.length;
            overlap += panel.length;
        }
        // The smallest summits are attracted within a layer that is thinner than a rounding.
        let shortest = (SHORTEST_PANEL * (end - overlap)).max(4.0 * f64::EPSILON * overlap.abs());
        for _ in 0..MOST_PANELS_OF_SUM {
            if overlap >= end {
                return Ok(());
            }
            let here = at(z, overlap);
            let length = self.attraction_panel(&here, z, shortest).min(end - overlap);
            let span = here.span(length);
            let nodes = quadrature::panel(0.0, span).map(|(wider, weight)| {
                let (rise, rate) = here.rise(wider);
                (rise, weight * rate)
            });
            let [heights, overlaps] = [z, overlap].map(|from| nodes.map(|(rise, _)| from + rise));
            let densities = self.densities::<POINTS>(separation, heights, overlaps);
            for ((rise, weight), density) in nodes.into_iter().zip(densities) {
                add(z + rise, overlap + rise, weight * density);
            }
            z += length;
            overlap += length;
        }
        Err(out_of_panels(separation))
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
        let excess = |z: f64| self.lambda_cubed * self.radius.factor(z) - ATTRACTION_LAMBDA_CUBED;
        // g is monotonic in z, so that there is at most one threshold.
        let end = |z: f64| if excess(z) < 0.0 { z } else { root::bracketed(excess, lower, upper) };
        (lower < upper && (excess(lower) < 0.0 || excess(upper) < 0.0)).then(|| (end(lower), end(upper)))
    }
}
