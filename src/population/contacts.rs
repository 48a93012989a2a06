//! The summits in contact at a separation, told apart by the radius of their contact: its mean, its largest value, and
//! how many there are in each regime of slip.
//!
//! Walked anew with every panel, for exact states only: the sums that a law is compiled from need none of this.

use super::{ends, gauss_legendre, Contact, Density, Edge, Heights, Point, Population, Sink, MOST_PANELS};
use crate::root;
use crate::surface::heights::UNDERFLOW;

/// Contact radii, in b, and their share of the regimes of slip.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Contacts {
    /// Mean contact radius.
    pub mean_radius: f64,
    /// Contact radius of the tallest of so many summits as there are; not below the mean.
    pub largest_radius: f64,
    /// Fractions of the contacts up to the first kink of the slip law, between the two, and from the second on.
    pub by_regime: [f64; 3],
}

/// Heights between which all summits are in contact.
struct Range {
    lower: (f64, Option<Edge>),
    upper: (f64, Option<Edge>),
}

/// Counts contacts, and keeps every contact radius that it sees with its height.
struct Counting<'a> {
    population: &'a Population,
    density: &'a Density<'a>,
    count: f64,
    radius: f64,
    by_regime: [f64; 3],
    seen: Vec<(f64, f64)>,
}

impl Sink for Counting<'_> {
    /// The largest radius may be there.
    const EXTREMA: bool = true;

    fn log_scale(&self) -> f64 {
        self.density.log_scale
    }

    fn panel(&mut self, from: &Point, to: &Point, _by_height: bool) {
        self.seen.extend([from, to].map(|point| (point.z, point.contact.radius)));
    }

    fn node(&mut self, z: f64, weight: f64, contact: &Contact) {
        self.summits(z, weight * self.density.at(z, contact.overlap), contact);
    }

    fn summits(&mut self, z: f64, weight: f64, contact: &Contact) {
        let [first, second] = self.population.slip.kinks();
        let regime = usize::from(contact.radius > first) + usize::from(contact.radius >= second);
        self.count += weight;
        self.radius += weight * contact.radius;
        self.by_regime[regime] += weight;
        self.seen.push((z, contact.radius));
    }

    fn out_of_panels(&mut self) {
        self.count = f64::NAN;
    }
}

impl Population {
    /// The contacts at a separation, of which `number` are expected on the surface; all 0 where there are none. `None` if
    /// they cannot be counted in as many panels as there may be.
    pub fn contacts(&self, separation: f64, number: f64) -> Option<Contacts> {
        let ranges = self.contact_ranges(separation);
        let Some(&Range { lower: (lowest, edge), .. }) = ranges.first() else { return Some(Contacts::default()) };
        let overlap = edge.filter(|edge| edge.z == lowest).map_or(lowest - separation, |edge| edge.contact.overlap);
        let density = &Density::above(&self.heights, lowest, overlap, separation);
        if density.log_scale < UNDERFLOW {
            return Some(Contacts::default());
        }
        let mut counting =
            Counting { population: self, density, count: 0.0, radius: 0.0, by_regime: [0.0; 3], seen: Vec::new() };
        for Range { lower: (lower, lower_edge), upper: (upper, upper_edge) } in &ranges {
            let (lower, upper) = self.heights.worth_summing(*lower, *upper);
            if lower < upper {
                self.walk_contacts(
                    separation,
                    (lower, lower_edge.as_ref()),
                    (upper, upper_edge.as_ref()),
                    &mut counting,
                );
            }
        }
        let Counting { count, radius, by_regime, seen, .. } = counting;
        if count.is_nan() {
            return None;
        }
        if count == 0.0 {
            return Some(Contacts::default());
        }
        let mean_radius = radius / count;
        let mut largest_radius = mean_radius;
        if number > 1.0 {
            let exceeding = count / (number + 1.0);
            let (lower, upper) = self.heights.worth_summing(lowest, f64::INFINITY);
            let excess = |z: f64| (self.exceedance(z, separation, density) / exceeding).max(1e-100).ln();
            let tallest = root::bracketed(excess, lower, upper);
            let is_within = |range: &Range| range.lower.0 <= tallest && tallest <= range.upper.0;
            let there = ranges.iter().any(is_within).then(|| self.point_cold(separation, tallest).contact.radius);
            let below = seen.iter().filter(|(z, _)| *z <= tallest).map(|(_, radius)| *radius);
            largest_radius = below.chain(there).fold(mean_radius, f64::max);
        }
        Some(Contacts { mean_radius, largest_radius, by_regime: by_regime.map(|weight| weight / count) })
    }

    /// Where summits are in contact, from low to high.
    fn contact_ranges(&self, separation: f64) -> Vec<Range> {
        let edges = self.edges.at_separation(&self.maugis, &self.radius, separation);
        let foot = self.heights.foot();
        let mut contact = self.lowest_are_in_contact(&edges, separation);
        let mut ranges = Vec::new();
        let mut lower = (foot, None);
        for edge in edges.iter().map(Some).chain([None]) {
            let upper = (edge.map_or(f64::INFINITY, |edge| edge.z), edge.copied());
            if contact && lower.0 < upper.0 {
                ranges.push(Range { lower, upper });
            }
            contact = !contact;
            lower = (upper.0.max(foot), upper.1);
        }
        ranges
    }

    /// The fraction of all summits that are higher, on the scale of a density.
    fn exceedance(&self, z: f64, separation: f64, density: &Density) -> f64 {
        if let Heights::Ends(ends) = &self.heights {
            return ends::mass_above(ends, z, density.log_scale);
        }
        let (mut z, upper) = self.heights.worth_summing(z, f64::INFINITY);
        let mut fraction = 0.0;
        for _ in 0..MOST_PANELS {
            if z >= upper {
                break;
            }
            let length = self.without_remnant(self.heights.smooth_length(z, density.log_scale), upper - z);
            fraction += gauss_legendre::nodes(0.0, length)
                .map(|(rise, weight)| weight * density.at(z + rise, z + rise - separation))
                .sum::<f64>();
            z += length;
        }
        fraction
    }
}
