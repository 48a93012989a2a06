//! The sums over all summits at a given separation, eqs (2), (12), (16), and their slopes.
//!
//! Each sum is an integral over height z of an asperity's law times the height density. The range is cut
//! where the integrand is not smooth: at break-away (square-root edge or jump), at the ends of attraction,
//! at the kinks of the slip law, at the foot of the height distribution. Between the cuts, panels are no
//! longer than the distance to the nearest singularity allows, so that 16 Gauss points each give the
//! integral to rounding; near break-away the variable is theta, in which the edge is smooth.
//!
//! Heights, overlaps and separations are in sigma; sums are per summit, loads in E* b^2, friction in
//! G* b^2, areas in b^2.

mod attracted;
mod break_edges;
mod contacts;
mod cuts;
mod density;
mod ends;
mod nodes;
mod panels;
mod point;
mod sums;
mod table;

pub use contacts::Contacts;
pub use sums::{out_of_panels, Sums};

use crate::asperity::attraction::Attraction;
use crate::asperity::maugis::{Contact, Maugis};
use crate::asperity::slip::{Slip, SlipConstants};
use crate::groups::Groups;
use crate::root;
use crate::surface::heights::{Heights, Steepness, UNDERFLOW};
use crate::surface::radius::RadiusProfile;
use break_edges::{BreakEdges, Edge, Edges};
use density::Density;
use nodes::Nodes;
use panels::{Sink, THETA_SPAN};
use std::f64::consts::PI;
use sums::Summit;

/// Where the logarithm of the density of heights is below this hardly any are...
const LOG_NOTHING: f64 = -19.0;
/// ...and the others pass an overlap as large as this, in sigma, within a small part of it.
const DEEP: f64 = 40.0;

/// The fineness of sums of which the sign is asked: every panel has as few points as there are.
const ROUGH: f64 = 0.05;

/// A population of summits pressed against a flat.
#[derive(Debug, Clone)]
pub struct Population {
    maugis: Maugis,
    attraction: Option<Attraction>,
    slip: Slip,
    heights: Heights,
    radius: RadiusProfile,
    edges: BreakEdges,
    lambda_cubed: f64,
    nodes: Option<Nodes>,
    /// What part a whole panel counts as when its points are chosen.
    fineness: f64,
}

/// Sums the nodes, weighted with the density of heights.
struct Summing<'a> {
    population: &'a Population,
    density: &'a Density<'a>,
    sums: &'a mut Sums,
}

impl Sink for Summing<'_> {
    fn log_scale(&self) -> f64 {
        self.sums.log_scale
    }

    fn node(&mut self, z: f64, weight: f64, contact: &Contact) {
        let density = self.density.at(z, contact.overlap);
        self.sums.add_contact(weight * density, &self.population.summit(contact));
    }

    fn summits(&mut self, _z: f64, mass: f64, contact: &Contact) {
        self.sums.add_contact(mass, &self.population.summit(contact));
    }

    fn out_of_panels(&mut self) {
        *self.sums = Sums::unknown();
    }
}

impl Population {
    /// The population of a surface; `attract` says whether summits out of contact attract.
    pub fn new(groups: &Groups, slip: SlipConstants, heights: Heights, radius: RadiusProfile, attract: bool) -> Self {
        let maugis = Maugis::new(groups);
        let highest = heights.far_tail();
        let edges = BreakEdges::new(&maugis, &radius, heights.far_foot(), highest);
        let mut population = Self {
            maugis,
            attraction: (attract && groups.gamma > 0.0).then(|| Attraction::new(groups)),
            slip: Slip::new(slip),
            heights,
            radius,
            edges,
            lambda_cubed: groups.lambda_cubed(),
            nodes: None,
            fineness: 1.0,
        };
        // Nodes serve every separation where panels do not depend on the heights.
        if radius.is_constant() && population.heights.knots().is_empty() {
            population.nodes = Some(Nodes::new(&population));
        }
        population
    }

    /// The same population, whose loads are good to four digits or more in half the time where radii vary with height.
    pub fn roughly(&self) -> Self {
        Self { fineness: ROUGH, ..self.clone() }
    }

    /// The height distribution.
    pub fn heights(&self) -> &Heights {
        &self.heights
    }

    /// Whether anything attracts.
    pub fn is_adhesive(&self) -> bool {
        self.lambda_cubed > 0.0
    }

    /// Whether load against separation can have but one minimum: the slope of the law of equal summits changes sign once,
    /// and a log-concave density adds no change of sign (it diminishes variation).
    pub fn has_single_minimum(&self) -> bool {
        self.radius.is_constant() && self.heights.is_log_concave()
    }

    /// The heights, in sigma, on whose scale radii change.
    pub fn radius_scale(&self) -> f64 {
        1.0 / self.radius.rate
    }

    /// How far, in sigma, a summit above the flat is pulled, or one in contact holds on.
    pub fn range_of_adhesion(&self) -> f64 {
        self.attraction.as_ref().map_or(0.0, |law| law.reach).max(-self.edges.deepest())
    }

    /// A separation beyond which nothing touches or attracts, in any number that can be represented.
    pub fn farthest(&self) -> f64 {
        self.heights.far_tail() + self.attraction.as_ref().map_or(0.0, |a| a.reach) - self.edges.deepest()
    }

    /// The separations at which summits that gather at the foot of the heights lose contact and, later, attraction.
    pub fn partings(&self) -> Vec<f64> {
        let Heights::Ends(ends) = &self.heights else { return Vec::new() };
        let foot = ends.ends()[0];
        let g = self.radius.factor(foot);
        let attraction = self.attraction_of(g).map(|law| foot + law.reach);
        [Some(foot - self.maugis.break_away(g).overlap), attraction].into_iter().flatten().collect()
    }

    /// The least overlap of which contacts without adhesion are known to enough digits.
    pub fn least_overlap(&self) -> f64 {
        self.maugis.least_overlap()
    }

    /// The separations at which a height where the density has a kink passes an overlap where the law of one summit has
    /// one, in ascending order: there the sums are not smooth.
    pub fn kinks(&self) -> Vec<f64> {
        let mut kinks: Vec<f64> = self.heights.knots().iter().flat_map(|&z| self.passings(z)).collect();
        if let Heights::Ends(ends) = &self.heights {
            // Just before those that gather part: while they do, within last bits, slopes are any numbers.
            kinks.iter_mut().for_each(|kink| *kink -= 8.0 * f64::EPSILON * kink.abs().max(ends.width()));
        }
        kinks.sort_by(f64::total_cmp);
        kinks.dedup();
        kinks
    }

    /// The same for the foot of the heights, where the density is a power: about there the sums may not be smooth.
    pub fn passings_of_foot(&self) -> Vec<f64> {
        let mut passings = match self.heights.power_at_foot() {
            Some(_) => self.passings(self.heights.foot()),
            None => Vec::new(),
        };
        passings.sort_by(f64::total_cmp);
        passings
    }

    /// The same for where nearly all of heights without kinks begin and end, of overlaps that all pass within a small part
    /// of them: there the sums are smooth on the scale of the heights alone.
    pub fn deep_passings(&self) -> Vec<f64> {
        if !self.heights.knots().is_empty() {
            return Vec::new();
        }
        let middle = -self.heights.origin();
        let is_empty = |z: f64| self.heights.log_density(z) < LOG_NOTHING;
        let end = |step: f64| (4..40).map(|k| middle + step * f64::from(k)).find(|&z| is_empty(z));
        let ends = [end(-1.0).map(|z| z.max(self.heights.foot())), end(1.0)];
        ends.into_iter().flatten().flat_map(|z| self.passings(z)).filter(|&passing| passing < middle - DEEP).collect()
    }

    /// The separations at which a height passes the overlaps where the law of one summit has a kink.
    fn passings(&self, z: f64) -> Vec<f64> {
        let g = self.radius.factor(z);
        let edge = self.maugis.break_away(g);
        let mut passings = vec![z - edge.overlap];
        if let Some(law) = &self.attraction {
            passings.push(z + law.reach);
        }
        for radius in self.slip.kinks().into_iter().filter(|&radius| radius > edge.radius) {
            let excess = |theta: f64| self.maugis.at(theta, g).radius - radius;
            let mut lower = edge.theta;
            while excess(lower) < 0.0 {
                lower *= 0.5;
            }
            passings.push(z - self.maugis.at(root::bracketed(excess, lower, edge.theta), g).overlap);
        }
        passings
    }

    /// The sums at a separation.
    pub fn at_separation(&self, separation: f64) -> Sums {
        let edges = self.edges.at_separation(&self.maugis, &self.radius, separation);
        let foot = self.heights.foot();
        let attraction_start = self.attraction.as_ref().map_or(f64::INFINITY, |law| separation - law.reach).max(foot);
        let first_edge = edges.iter().next();
        let mut contact = self.lowest_are_in_contact(&edges, separation);
        let contact_start = if contact { foot } else { first_edge.map_or(f64::INFINITY, |edge| edge.z.max(foot)) };
        // Of the lowest summit that counts, the overlap to all its digits.
        let start = contact_start.min(attraction_start);
        let overlap = match (first_edge, &self.attraction) {
            (Some(edge), _) if edge.z == start => edge.contact.overlap,
            (_, Some(law)) if separation - law.reach == start => -law.reach,
            _ => start - separation,
        };
        let density = Density::above(&self.heights, start, overlap, separation);
        let mut sums = Sums { log_scale: density.log_scale, ..Sums::default() };
        if sums.log_scale < UNDERFLOW {
            return sums;
        }

        // Going up, summits are alternately out of contact and in contact.
        let mut lower_edge: Option<&Edge> = None;
        for upper_edge in edges.iter().map(Some).chain([None]) {
            let lower = lower_edge.map_or(foot, |edge| edge.z.max(foot));
            let upper = upper_edge.map_or(f64::INFINITY, |edge| edge.z);
            if contact {
                let (lower, upper) = self.heights.worth_summing(lower, upper);
                self.add_contacts(&mut sums, &density, separation, (lower, lower_edge), (upper, upper_edge));
            } else {
                let (lower, upper) = self.heights.worth_summing(lower.max(attraction_start), upper);
                self.add_attractions(&mut sums, &density, separation, lower, upper, upper_edge);
            }
            if let Some(edge) = upper_edge {
                self.add_edge(&mut sums, &density, separation, edge);
            }
            contact = !contact;
            lower_edge = upper_edge;
        }
        sums
    }

    /// Whether the lowest summits are in contact at a separation, which has these edges.
    fn lowest_are_in_contact(&self, edges: &Edges, separation: f64) -> bool {
        match edges.iter().next() {
            Some(edge) => edge.rate < 0.0,
            None => self.edges.all_in_contact(&self.maugis, &self.radius, separation),
        }
    }

    /// What a contact contributes, friction included.
    #[inline]
    fn summit(&self, contact: &Contact) -> Summit {
        let (friction, friction_by_radius) = self.slip.force(contact.radius);
        let inv_rate = if contact.overlap_rate < -f64::MIN_POSITIVE { 1.0 / contact.overlap_rate } else { 0.0 };
        Summit {
            load: contact.load,
            friction,
            area: PI * contact.radius * contact.radius,
            load_by_overlap: contact.load_rate * inv_rate,
            friction_by_overlap: friction_by_radius * contact.radius_rate * inv_rate,
        }
    }

    /// The slopes' share of a moving edge: what a summit loses there at once, times how fast heights pass it.
    fn add_edge(&self, sums: &mut Sums, density: &Density, separation: f64, edge: &Edge) {
        let density = density.at(edge.z, edge.contact.overlap);
        if density == 0.0 {
            return;
        }
        let below = self.attraction_at(separation, edge.z).map_or(0.0, |attracted| attracted.load);
        let passing = density / edge.rate.abs();
        sums.load_slope -= passing * (edge.contact.load - below);
        sums.friction_slope -= passing * self.slip.force(edge.contact.radius).0;
    }

    /// Adds the summits in contact between two heights, either of which may be an edge.
    fn add_contacts(
        &self,
        sums: &mut Sums,
        density: &Density,
        separation: f64,
        (lower, lower_edge): (f64, Option<&Edge>),
        (upper, upper_edge): (f64, Option<&Edge>),
    ) {
        if upper <= lower {
            return;
        }
        if let Some(nodes) = &self.nodes {
            return self.add_tabulated(nodes, sums, density, separation, lower, upper);
        }
        let mut sink = Summing { population: self, density, sums };
        self.walk_contacts(separation, (lower, lower_edge), (upper, upper_edge), &mut sink);
    }

    /// Walks the summits in contact between two heights, either of which may be an edge.
    fn walk_contacts(
        &self,
        separation: f64,
        (lower, lower_edge): (f64, Option<&Edge>),
        (upper, upper_edge): (f64, Option<&Edge>),
        sink: &mut impl Sink,
    ) {
        let start = match lower_edge {
            Some(edge) if edge.z == lower => self.edge_point(edge),
            _ => self.point_cold(separation, lower),
        };
        // A second edge above, where a falling radius lets tall summits break first: from both ends.
        let (end, from_above) = match upper_edge {
            Some(edge) if edge.z == upper => (0.5 * (lower + upper), Some(self.edge_point(edge))),
            _ => (upper, None),
        };
        if let Heights::Ends(ends) = &self.heights {
            for start in [start].into_iter().chain(from_above) {
                self.walk_between_ends(ends, start, end, sink);
            }
            return;
        }
        self.march(self.above_foot(start, end, sink), end, sink);
        if let Some(start) = from_above {
            self.march(start, end, sink);
        }
    }

    /// Adds the summits in contact between two heights from nodes that are the same at every separation; only
    /// panels across which the density is not smooth are walked anew.
    fn add_tabulated(
        &self,
        nodes: &Nodes,
        sums: &mut Sums,
        density: &Density,
        separation: f64,
        lower: f64,
        upper: f64,
    ) {
        let mut last_end: Option<Steepness> = None;
        for panel in nodes.panels() {
            let (z_from, z_to) = (separation + panel.from.z, separation + panel.to.z);
            if z_to <= lower {
                continue;
            }
            if z_from >= upper {
                return;
            }
            let from_start = z_from >= lower;
            let roughest = if panel.by_height { 1.0 } else { THETA_SPAN };
            let is_smooth = from_start && {
                let from = last_end.filter(|end| end.is_at(z_from)).unwrap_or_else(|| self.heights.steepness(z_from));
                let to = self.heights.steepness(z_to);
                last_end = Some(to);
                self.heights.roughness(&from, &to, sums.log_scale) <= roughest
            };
            if is_smooth {
                let densities = density.at_each(separation, panel.nodes().map(|node| node.overlap));
                for (node, density) in panel.nodes().iter().zip(densities) {
                    sums.add_contact(node.weight * density, &node.summit);
                }
                continue;
            }
            let mut sink = Summing { population: self, density, sums };
            let end = z_to.min(upper);
            let start = if from_start {
                panel.from.raised(separation)
            } else {
                let start = self.point_cold(separation, lower);
                self.above_foot(start, end, &mut sink)
            };
            self.march(start, end, &mut sink);
        }
        let last = nodes.last_point().raised(separation);
        if last.z >= upper {
            return;
        }
        let mut sink = Summing { population: self, density, sums };
        if last.z >= lower {
            self.march(last, upper, &mut sink);
        } else {
            let start = self.point_cold(separation, lower);
            self.march(self.above_foot(start, upper, &mut sink), upper, &mut sink);
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::point::Point;
    use super::*;
    use crate::asperity::attraction;
    use crate::asperity::maugis::tests::EVALUATIONS;
    use crate::gauss_legendre;
    use crate::params::{HeightFamily, Params};

    /// Takes three panels.
    #[derive(Default)]
    pub struct Few {
        panels: usize,
        out: bool,
    }

    impl Sink for Few {
        const MOST_PANELS: usize = 3;

        fn panel(&mut self, _from: &Point, _to: &Point, _by_height: bool) {
            self.panels += 1;
        }

        fn node(&mut self, _z: f64, _weight: f64, _contact: &Contact) {}

        fn out_of_panels(&mut self) {
            self.out = true;
        }
    }

    /// The population of a surface that is valid.
    pub fn of(params: &Params) -> Population {
        let (groups, heights, radius) = params.surface().expect("a surface");
        Population::new(&groups, params.slip, heights, radius, params.attraction)
    }

    pub fn population(heights: HeightFamily) -> Population {
        of(&Params { heights, ..Params::default() })
    }

    #[test]
    fn a_sum_that_runs_out_of_panels_is_not_known() {
        // The second gathers at two ends.
        for heights in [HeightFamily::Gaussian, HeightFamily::Johnson { skew: 0.5, kurtosis: 1.26 }] {
            let population = population(heights);
            let mut few = Few::default();
            let (foot, head) = (population.heights.foot().max(-1.0), population.heights.head().min(5.0));
            population.walk_contacts(-2.0, (foot, None), (head, None), &mut few);
            assert!(few.out && few.panels <= 3, "{} panels", few.panels);

            let density = Density::above(&population.heights, -1.0, 1.0, -2.0);
            let mut sums = Sums::default();
            assert!(sums.are_known());
            Summing { population: &population, density: &density, sums: &mut sums }.out_of_panels();
            assert!(!sums.are_known() && !sums.unscaled().are_known());
        }
    }

    /// Of unequal radii, which turn the contact radius about.
    pub fn unequal(amplitude: f64, rate: f64) -> Population {
        of(&Params { radius_amplitude: amplitude, radius_rate: rate, ..Params::default() })
    }

    /// Where a contact breaks its slopes by overlap are infinite; what they add is the moving edge's share.
    #[test]
    fn a_summit_that_breaks_away_has_no_slope_of_its_own() {
        let population = population(HeightFamily::Gaussian);
        let contact = population.point_cold(0.5, 0.0).contact;
        let at_rate = |overlap_rate| population.summit(&Contact { overlap_rate, ..contact });
        for rate in [0.0, -0.0, -5e-324, 5e-324, 1e-9] {
            let summit = at_rate(rate);
            assert_eq!((summit.load_by_overlap, summit.friction_by_overlap), (0.0, 0.0), "{rate:e}");
            assert_eq!(summit.load, contact.load);
        }
        assert_eq!(at_rate(-0.5).load_by_overlap, contact.load_rate / -0.5);
    }

    fn sum<const N: usize>(a: [[f64; N]; 2], b: [[f64; N]; 2]) -> [[f64; N]; 2] {
        [0, 1].map(|kind| std::array::from_fn(|i| a[kind][i] + b[kind][i]))
    }

    /// The integrals of several functions, and of their absolute values, over a range in panels that are halved until the
    /// halves agree with the whole.
    fn halved<const N: usize>(f: &impl Fn(f64) -> [f64; N], from: f64, to: f64) -> [[f64; N]; 2] {
        let panel = |from: f64, to: f64| {
            let mut sums = [[0.0; N]; 2];
            for (z, weight) in gauss_legendre::nodes(from, to) {
                let values = f(z).map(|value| weight * value);
                sums = sum(sums, [values, values.map(f64::abs)]);
            }
            sums
        };
        let ends: Vec<f64> = (0..=32).map(|i| from + (to - from) * f64::from(i) / 32.0).collect();
        let mut left: Vec<_> = ends.windows(2).map(|ends| (ends[0], ends[1], panel(ends[0], ends[1]))).collect();
        let size = left.iter().fold([[0.0; N]; 2], |all, &(_, _, part)| sum(all, part))[1];
        let mut done = [[0.0; N]; 2];
        while let Some((from, to, whole)) = left.pop() {
            let middle = 0.5 * (from + to);
            let halves = [panel(from, middle), panel(middle, to)];
            let both = sum(halves[0], halves[1]);
            if (0..N).all(|i| (both[0][i] - whole[0][i]).abs() <= 1e-13 * size[i]) || to - from < 1e-12 {
                done = sum(done, both);
            } else {
                left.extend([(from, middle, halves[0]), (middle, to, halves[1])]);
            }
        }
        done
    }

    impl Population {
        /// By no panels of its own, and with the sums of their absolute values: load, friction, area and number of contacts,
        /// load and number of what attracts; slope of the load, but for what moving edges add.
        fn by_halves(&self, separation: f64, log_scale: f64) -> [[f64; 7]; 2] {
            let density = |z: f64| (self.heights.log_density(z) - log_scale).exp();
            let in_contact = |z: f64| {
                let summit = self.summit(&self.point_cold(separation, z).contact);
                let Summit { load, friction, area, load_by_overlap, .. } = summit;
                [load, friction, area, 1.0, 0.0, 0.0, -load_by_overlap].map(|value| value * density(z))
            };
            let attracted = |z: f64| match self.attraction_at(separation, z) {
                Some(attracted) => {
                    let (load, slope) = (attracted.load, -attracted.load_by_overlap);
                    [0.0, 0.0, 0.0, 0.0, load, 1.0, slope].map(|value| value * density(z))
                }
                None => [0.0; 7],
            };
            let edges = self.edges.at_separation(&self.maugis, &self.radius, separation);
            let mut contact = self.lowest_are_in_contact(&edges, separation);
            let farthest = self.attraction.as_ref().map_or(f64::INFINITY, |law| separation - law.reach);
            let (mut sums, mut lower) = ([[0.0; 7]; 2], self.heights.foot());
            for upper in edges.iter().map(|edge| edge.z).chain([f64::INFINITY]) {
                let start = if contact { lower } else { lower.max(farthest) };
                let (mut from, last) = self.heights.worth_summing(start, upper);
                for to in self.heights.knots().iter().copied().chain([last]).map(|to| to.min(last)) {
                    if from < to {
                        let part = if contact { halved(&in_contact, from, to) } else { halved(&attracted, from, to) };
                        sums = sum(sums, part);
                        from = to;
                    }
                }
                contact = !contact;
                lower = lower.max(upper);
            }
            sums
        }
    }

    /// Where contact ends among the heights or is about to, once or twice; where radii fall or rise steeply, some to nothing;
    /// at the foot of the heights; and where all contacts are as small as a tip.
    #[test]
    fn sums_are_integrals_over_heights_in_few_evaluations() {
        let table = |height: &[f64], density: &[f64]| HeightFamily::Tabulated {
            height: height.to_vec().into(),
            density: density.to_vec().into(),
        };
        let peaks = || table(&[-3.0, -1.0, 0.0, 1.0, 1.5], &[0.0, 1.0, 0.1, 1.0, 0.0]);
        let slope = || table(&[0.0, 1.0, 2.0, 4.0], &[3.0, 1.0, 1.0, 0.5]);
        let weibull = |shape: f64| HeightFamily::Weibull { shape };
        let johnson = |skew: f64, kurtosis: f64| HeightFamily::Johnson { skew, kurtosis };
        let gaussian = || HeightFamily::Gaussian;
        let paper = [28.0, 8e4];
        // Heights; epsilon and rho; alpha, beta, gamma and b/h; the slip law's radii; separations.
        type Case<'a> = (HeightFamily, [f64; 2], [f64; 4], [f64; 2], &'a [f64]);
        let cases: [Case; 24] = [
            (gaussian(), [-1.0, 11.2], [2.35e-3, 4.16, 3.18e-4, 0.0622], [0.0773, 5.3], &[0.3316, 0.3336, 1.2, 4.37]),
            (
                gaussian(),
                [-1.0, 7.18],
                [1.08e-3, 5.275, 4.156e-3, 0.282],
                [98.6, 1.62e4],
                &[1.066312, 1.0673, 3.0, 41.68],
            ),
            (weibull(104.4), [-1.0, 1.2], [2.47e-3, 21.0, 0.944, 0.11], [0.0737, 1.15], &[7.40793, 7.409, 697.1642]),
            (
                weibull(1.837),
                [-1.0, 2.6],
                [1.3e-4, 3.5e4, 2.1e-3, 1.151],
                [16.1, 4.5e4],
                &[-9.0, 1.7, 1.76, 1.8, 2.7, 3.9],
            ),
            (weibull(71.5), [-0.8, 16.0], [2e-3, 3.15, 2.7e-3, 0.075], paper, &[-2.0, 6.126, 6.128]),
            (gaussian(), [0.994, 1.538], [5.3e-4, 39.66, 4.49e-2, 5.19e-2], paper, &[100.0, 209.0, 253.9]),
            (gaussian(), [1.0, 20.0], [5.3e-4, 39.66, 4.49e-2, 5.19e-2], paper, &[100.0, 1.0, -3.0]),
            (gaussian(), [0.79, 3.754], [1.14e-4, 2.679e4, 0.0, 1.389], paper, &[-2.0, 1.0]),
            (johnson(1.12, 3.653), [0.0, 1.0], [0.86, 7.78e4, 3.84e-4, 3.585], [0.0115, 1.458], &[-0.593, -2.0]),
            (johnson(-0.134, 4.431), [1.0, 17.17], [1.5e-4, 9220.0, 0.84, 0.538], [4.0, 6761.0], &[-0.153, -1.8]),
            (johnson(0.875, 63.51), [1.0, 26.8], [3.3e-4, 7263.0, 0.0645, 0.119], [314.0, 2.2e5], &[1.519, 0.2]),
            (johnson(0.5, 1.6), [0.0, 1.0], [0.01, 100.0, 1e-3, 0.2], paper, &[5.5, 4.5]),
            (weibull(1.02), [0.0, 1.0], [1.69e-4, 2408.0, 0.0, 0.25], [1.0, 1006.0], &[-12.2, -2.0, 0.1]),
            (weibull(3.92), [0.0, 1.0], [3.69e-4, 1897.0, 2.56e-6, 0.0555], [78.0, 3.3e4], &[0.78, 5.39, 28.18]),
            (weibull(8.967), [0.263, 0.327], [0.275, 54.07, 1.77e-6, 2.677], [0.035, 4.314], &[9.707, 0.5]),
            (weibull(1.245), [-1.0, 0.042], [0.037, 192.1, 5.4e-5, 0.4279], [40.8, 1301.0], &[0.5, 408.3]),
            (peaks(), [1.0, 0.1], [5.2e-3, 3.358e5, 0.011, 0.816], [1.66, 543.0], &[-3.0, -3.801, -2.0]),
            (peaks(), [0.0, 1.0], [1.78e-4, 1.2e4, 0.0, 0.446], paper, &[-0.469, -2.0]),
            (peaks(), [-1.0, 5.117], [0.0432, 2.468e4, 0.0, 2.387], [35.37, 2.677e4], &[-2.684]),
            (peaks(), [1.0, 0.0025], [3.125e-4, 1439.0, 2.175e-5, 0.067], paper, &[-0.234, 0.5]),
            (slope(), [0.0, 1.0], [0.01, 100.0, 1e-3, 0.2], paper, &[-2.0, 0.5]),
            (slope(), [0.4, 1.0], [0.01, 100.0, 1e-3, 2.0], paper, &[-4.2, -3.6]),
            (gaussian(), [0.6, 1.0], [1e-4, 1.0, 0.0, 1e-3], [0.3, 3.0], &[-2.0, 1.2]),
            (peaks(), [-0.6, 1.0], [1e-4, 1.0, 0.0, 1e-3], [0.3, 3.0], &[-9.0, -2.0, -1e-3]),
        ];
        // Of contacts and of attraction, in sums and in rough ones.
        let mut counts = [0; 4];
        for (heights, [amplitude, rate], [alpha, beta, gamma, b_over_h], [radius_1, radius_2], separations) in cases {
            let mut params = Params { heights, radius_amplitude: amplitude, radius_rate: rate, ..Params::default() };
            (params.slip.radius_1, params.slip.radius_2) = (radius_1, radius_2);
            params.set_dimensionless(alpha, beta, gamma, b_over_h, 0.3).expect("a surface");
            let population = of(&params);
            let rough = population.roughly();
            for &separation in separations {
                let mut counted = |population: &Population, count: usize| {
                    EVALUATIONS.set(0);
                    attraction::tests::EVALUATIONS.set(0);
                    let sums = population.at_separation(separation);
                    counts[count] += EVALUATIONS.get();
                    counts[count + 1] += attraction::tests::EVALUATIONS.get();
                    sums
                };
                let (sums, rough) = (counted(&population, 0), counted(&rough, 2));
                let [expected, mut sizes] = population.by_halves(separation, sums.log_scale);
                let (loads, number) = (sizes[0] + sizes[4], sizes[3] + sizes[5]);
                (sizes[0], sizes[4], sizes[3], sizes[5]) = (loads, loads, number, number);
                let Sums { load_contacting, load_attracted, friction, area, contacting, attracted, .. } = sums;
                let found = [load_contacting, friction, area, contacting, load_attracted, attracted];
                let at = format!("at {separation} of {:?}", params.heights);
                for i in 0..found.len() {
                    let error = (found[i] - expected[i]).abs() / sizes[i].max(f64::MIN_POSITIVE);
                    assert!(error <= 1e-12, "sum {i} {at}: {}, not {}: {error:e}", found[i], expected[i]);
                }
                let edges = population.edges.at_separation(&population.maugis, &population.radius, separation);
                if edges.iter().count() == 0 && load_attracted == 0.0 {
                    let error = (sums.load_slope - expected[6]).abs() / sizes[6];
                    assert!(error <= 2e-12, "slope {at}: {}, not {}: {error:e}", sums.load_slope, expected[6]);
                }
                let error = (rough.load() - expected[0] - expected[4]).abs() / loads.max(f64::MIN_POSITIVE);
                assert!(error <= 1e-4, "rough load {at}: {error:e}");
            }
        }
        let most = [59846, 7666, 30325, 3406];
        assert!((0..4).all(|i| counts[i] <= most[i] + most[i] / 100), "{counts:?} evaluations, not {most:?}");
    }
}
