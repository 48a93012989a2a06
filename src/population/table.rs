//! Cells of a table of heights: many pieces of its density at once, where the law of one summit is smooth across them.

use super::panels::Sink;
use super::point::{Guess, Point};
use super::Population;
use crate::elementary::exp;
use crate::gauss_legendre;
use crate::surface::heights::Heights;

/// The length of a cell over its distance to break-away: values at 16 points then fix the law between them.
const CELL_RATIO: f64 = 0.7;
/// The same over the longest panel on which radii are smooth.
const CELL_OF_RADIUS: f64 = 0.3;

impl Population {
    /// Hands on the summits of the cell that begins at a contact, and gives the contact at its end; none where no cell fits.
    #[inline]
    pub(super) fn cell<S: Sink>(&self, here: &Point, end: f64, sink: &mut S) -> Option<Point> {
        let Heights::Tabulated(table) = &self.heights else { return None };
        let mut longest = (end - here.z)
            .min(CELL_RATIO * self.clearance(here))
            .min(CELL_OF_RADIUS * self.radius.smooth_length(here.z));
        loop {
            let (length, weights) = table.cell(here.z, longest)?;
            let theta_far = self.theta_limit(here);
            let curve = self.maugis.at(theta_far, here.g).overlap - here.contact.overlap;
            let there = self.point(here, length, here.guess_towards(theta_far, length / curve));
            if self.first_cut::<S>(here, &there).is_some() {
                longest = 0.75 * length;
                continue;
            }
            sink.panel(here, &there, true);
            let scale = exp(-sink.log_scale());
            let mut guess = Guess::new(here, &there, length);
            for ((part, _), weight) in gauss_legendre::nodes(0.0, 1.0).zip(weights) {
                let point = self.point(here, part * length, guess.at(part));
                guess.learn(part, point.contact.theta);
                sink.summits(point.z, scale * weight, &point.contact);
            }
            return Some(there);
        }
    }
}
