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

mod break_edges;
mod contacts;
mod density;
mod ends;
mod nodes;
mod table;

pub use contacts::Contacts;

use crate::asperity::attraction::{self, Attraction, ATTRACTION_LAMBDA_CUBED};
use crate::asperity::maugis::{Contact, Maugis};
use crate::asperity::slip::{Slip, SlipConstants};
use crate::elementary::{cos, exp, pow};
use crate::error::Error;
use crate::gauss_legendre;
use crate::groups::Groups;
use crate::root;
use crate::surface::heights::{Heights, Steepness, SHORTEST_PANEL, UNDERFLOW};
use crate::surface::radius::RadiusProfile;
use break_edges::{BreakEdges, Edge, Edges};
use density::Density;
use nodes::Nodes;
use std::f64::consts::{FRAC_PI_2, PI};

/// A panel in theta reaches from theta to no less than this fraction of it: u(theta) has its singularity at 0...
const THETA_RATIO: f64 = 0.4;
/// ...and spans no more of the heights than this, in sigma, or this part of where their density is smooth: in theta the
/// density is a steep function of theta^-3.
const THETA_SPAN: f64 = 0.15;
/// A panel in height is no longer than this many times the distance to break-away, where theta(u) is singular.
const HEIGHT_RATIO: f64 = 2.5;
/// Where contacts above are ever nearer to break-away, which they may touch, a panel takes no more than this part of the way
/// there, or this part of where all else is smooth: what is nearer is nothing.
const APPROACH: f64 = 0.5;
const NEAREST: f64 = 1e-4;
/// One panel of attraction with varying radius spans no more than this ratio of sqrt(gap terms).
const CIRCLE_RATIO: f64 = 4.0;
/// Over a panel across which theta changes less than by this factor, it serves as well as the height, and with equal
/// radii its nodes need no solution of their contact's overlap.
const SHORT_RATIO: f64 = 0.8;
/// What part of a radius of the slip law is nothing beside it.
const AT_KINK: f64 = 1e-9;
/// No sum needs as many panels; it bounds the time of a call. A sum that does is no number.
const MOST_PANELS: usize = 6000;
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

/// The sums at one separation, all to be multiplied by exp(`log_scale`).
#[derive(Debug, Clone, Copy, Default)]
pub struct Sums {
    /// Keeps sums of a nearly empty tail from underflowing.
    pub log_scale: f64,
    /// Load of the summits in contact.
    pub load_contacting: f64,
    /// Load of the summits that attract without contact, <= 0.
    pub load_attracted: f64,
    /// Friction force.
    pub friction: f64,
    /// Real area of contact.
    pub area: f64,
    /// Fraction of summits in contact.
    pub contacting: f64,
    /// Fraction of summits that attract without contact.
    pub attracted: f64,
    /// d(load)/d(separation).
    pub load_slope: f64,
    /// d(friction)/d(separation).
    pub friction_slope: f64,
}

impl Sums {
    /// The load of all summits.
    pub fn load(&self) -> f64 {
        self.load_contacting + self.load_attracted
    }

    /// The sums themselves: `log_scale` 0.
    pub fn unscaled(&self) -> Self {
        // In two steps, since what is at the end of all numbers has few digits.
        let root = exp(0.5 * self.log_scale);
        let unscaled = |sum: f64| root * (root * sum);
        Self {
            log_scale: 0.0,
            load_contacting: unscaled(self.load_contacting),
            load_attracted: unscaled(self.load_attracted),
            friction: unscaled(self.friction),
            area: unscaled(self.area),
            contacting: unscaled(self.contacting),
            attracted: unscaled(self.attracted),
            load_slope: unscaled(self.load_slope),
            friction_slope: unscaled(self.friction_slope),
        }
    }

    /// What sums are that ran out of panels.
    fn unknown() -> Self {
        let unknown = f64::NAN;
        Self {
            load_contacting: unknown,
            load_attracted: unknown,
            load_slope: unknown,
            friction: unknown,
            ..Self::default()
        }
    }

    /// Whether the sums are to be had: not where they took more panels than there may be.
    pub fn are_known(&self) -> bool {
        !self.load().is_nan()
    }

    /// The sums at this separation if they are to be had.
    ///
    /// # Errors
    /// [`Error::NotConverged`].
    pub fn known(self, separation: f64) -> Result<Self, Error> {
        if self.are_known() {
            Ok(self)
        } else {
            Err(out_of_panels(separation))
        }
    }

    /// Adds one contacting summit, `weight` times.
    #[inline]
    fn add_contact(&mut self, weight: f64, summit: &Summit) {
        self.contacting += weight;
        self.load_contacting += weight * summit.load;
        self.friction += weight * summit.friction;
        self.area += weight * summit.area;
        self.load_slope -= weight * summit.load_by_overlap;
        self.friction_slope -= weight * summit.friction_by_overlap;
    }

    /// Adds one attracted summit, `weight` times.
    #[inline]
    fn add_attraction(&mut self, weight: f64, summit: &Summit) {
        self.attracted += weight;
        self.load_attracted += weight * summit.load;
        self.load_slope -= weight * summit.load_by_overlap;
    }
}

/// Why there are no sums at a separation.
pub fn out_of_panels(separation: f64) -> Error {
    Error::NotConverged { what: "sums over the summits at separation / height_std", value: separation }
}

/// What one summit contributes.
#[derive(Debug, Clone, Copy, Default)]
struct Summit {
    load: f64,
    friction: f64,
    area: f64,
    load_by_overlap: f64,
    friction_by_overlap: f64,
}

/// Starting values of theta from one point to another, by theta^-2, which is smooth in overlap under load.
///
/// A cubic from values and slopes at both points, corrected by what is known of its error from the values solved for
/// on the way: over part^2 (1 - part)^2 that is smooth.
struct Guess {
    cubic: [f64; 4],
    /// Where the cubic may not leave.
    range: (f64, f64),
    /// The last errors over part^2 (1 - part)^2, at which parts.
    errors: [(f64, f64); 3],
    known: usize,
}

impl Guess {
    /// From values and slopes at two points `rise` apart.
    fn new(from: &Point, to: &Point, rise: f64) -> Self {
        let slope = |point: &Point| {
            -2.0 * rise * point.theta_slope() * inverse_square(point.contact.theta) / point.contact.theta
        };
        let (start, start_slope, end_slope) = (inverse_square(from.contact.theta), slope(from), slope(to));
        let end = inverse_square(to.contact.theta);
        let change = end - start;
        let cubic =
            [start, start_slope, 3.0 * change - 2.0 * start_slope - end_slope, start_slope + end_slope - 2.0 * change];
        Self { cubic, range: (0.5 * start.min(end), 2.0 * start.max(end)), errors: [(0.0, 0.0); 3], known: 0 }
    }

    /// theta where `part` of the rise is done.
    fn at(&self, part: f64) -> f64 {
        let [(a, at_a), (b, at_b), (c, at_c)] = self.errors;
        let error = match self.known {
            0 => 0.0,
            1 => at_a,
            2 => at_a + (at_b - at_a) * (part - a) / (b - a),
            _ => {
                let (ab, bc) = ((at_b - at_a) / (b - a), (at_c - at_b) / (c - b));
                at_a + (part - a) * (ab + (part - b) * (bc - ab) / (c - a))
            }
        };
        let value = self.cubic(part) + error * bubble(part);
        1.0 / value.max(self.range.0).min(self.range.1).sqrt()
    }

    /// Takes in the value found at a part.
    fn learn(&mut self, part: f64, theta: f64) {
        let error = (part, (inverse_square(theta) - self.cubic(part)) / bubble(part));
        if self.known < 3 {
            self.errors[self.known] = error;
            self.known += 1;
        } else {
            self.errors = [self.errors[1], self.errors[2], error];
        }
    }

    fn cubic(&self, part: f64) -> f64 {
        let [a, b, c, d] = self.cubic;
        a + part * (b + part * (c + part * d))
    }
}

fn inverse_square(theta: f64) -> f64 {
    1.0 / (theta * theta)
}

/// part^2 (1 - part)^2.
fn bubble(part: f64) -> f64 {
    let x = part * (1.0 - part);
    x * x
}

/// What walks the panels hands its nodes to.
trait Sink {
    /// No more panels than these.
    const MOST_PANELS: usize = MOST_PANELS;
    /// Whether a panel must end where the contact radius has an extremum, though it passes none of the slip law's.
    const EXTREMA: bool = false;
    /// ln phi that is taken as 1.
    fn log_scale(&self) -> f64 {
        f64::NEG_INFINITY
    }
    /// A panel begins, from a point to another, short beside the distance to break-away or not; all its nodes follow.
    fn panel(&mut self, _from: &Point, _to: &Point, _by_height: bool) {}
    /// A node: its height, its weight without the density, and the contact there.
    fn node(&mut self, z: f64, weight: f64, contact: &Contact);
    /// So many summits at a height, and the contact there.
    fn summits(&mut self, _z: f64, _mass: f64, _contact: &Contact) {}
    /// The panels did not suffice.
    fn out_of_panels(&mut self) {}
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

/// A summit in contact, at its height.
#[derive(Debug, Clone, Copy)]
struct Point {
    z: f64,
    g: f64,
    g_rate: f64,
    contact: Contact,
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

    /// The attraction of summits of a radius factor when they are out of contact, where there is one.
    fn attraction_of(&self, g: f64) -> Option<&Attraction> {
        self.attraction.as_ref().filter(|_| self.lambda_cubed * g < ATTRACTION_LAMBDA_CUBED)
    }

    /// The attraction of a summit out of contact, where there is one.
    fn attraction_at(&self, separation: f64, z: f64) -> Option<attraction::Attracted> {
        let g = self.radius.factor(z);
        let law = self.attraction_of(g)?;
        let overlap = z - separation;
        (overlap >= -law.reach).then(|| law.at(law.circle(overlap, g), g))
    }

    /// The contact of a summit `rise` above another, from a starting theta.
    fn point(&self, from: &Point, rise: f64, guess: f64) -> Point {
        let z = from.z + rise;
        let (g, g_rate) = self.radius.at(z);
        Point { z, g, g_rate, contact: self.maugis.at_overlap(from.contact.overlap + rise, g, guess) }
    }

    /// The contact of a summit of height z, from nothing.
    fn point_cold(&self, separation: f64, z: f64) -> Point {
        let (g, g_rate) = self.radius.at(z);
        let overlap = z - separation;
        Point { z, g, g_rate, contact: self.maugis.at_overlap(overlap, g, self.maugis.guess(overlap, g)) }
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

    fn edge_point(&self, edge: &Edge) -> Point {
        let (g, g_rate) = self.radius.at(edge.z);
        Point { z: edge.z, g, g_rate, contact: edge.contact }
    }

    /// Where the range begins at the foot of the distribution, sums a first panel in which the power law of the
    /// density is smooth; returns where it ends.
    fn above_foot(&self, start: Point, upper: f64, sink: &mut impl Sink) -> Point {
        let Some(panel) = self.foot_panel(start.z, upper, || self.clearance(&start)) else {
            return start;
        };
        let mut guess = start.contact.theta;
        for (v, w) in gauss_legendre::nodes(0.0, 1.0) {
            let (rise, rate) = panel.at(v);
            let point = self.point(&start, rise, guess);
            guess = point.contact.theta;
            sink.node(point.z, w * rate, &point.contact);
        }
        self.point(&start, panel.length, guess)
    }

    /// The first panel above the foot, if the range begins there; `clearance` is the distance from the foot to
    /// where the law of one asperity is singular.
    fn foot_panel(&self, start: f64, upper: f64, clearance: impl FnOnce() -> f64) -> Option<FootPanel> {
        let (foot, exponent) = (self.heights.foot(), self.heights.power_at_foot()?);
        if start > foot {
            return None;
        }
        // z = foot + length v^p turns phi dz ~ v^(p (exponent + 1) - 1) into at least v^8, and leaves a law
        // that is a power series in z - foot.
        let power = (9.0 / (exponent + 1.0)).max(1.0);
        let length =
            (0.02 * clearance().min(1.0).min(self.radius.smooth_length(foot))).max(SHORTEST_PANEL).min(upper - foot);
        Some(FootPanel { length, power })
    }

    /// How far from z upwards or downwards a panel may reach, as far as heights and radii go, in a sum of this scale.
    fn smooth_length(&self, z: f64, upwards: bool, log_scale: f64) -> f64 {
        let above = |z: f64| self.heights.smooth_length(z, log_scale).min(self.radius.smooth_length(z));
        if upwards {
            return above(z);
        }
        // Going down, what lies below is nearer: the distance that z would allow going up, less itself.
        let mut length = self.heights.longest_below(z);
        for _ in 0..60 {
            if above(z - length) >= length {
                break;
            }
            length *= 0.5;
        }
        length
    }

    /// The length of a panel that may have another; what little would be left of the range goes into it, where no knot of
    /// the density lies between.
    fn without_remnant(&self, length: f64, remaining: f64) -> f64 {
        let most = if self.heights.knots().is_empty() { 0.8 * remaining } else { remaining };
        if length > most {
            remaining
        } else {
            length
        }
    }

    /// What part a panel is of the longest on which all but the density is smooth; 1 if the density is what limits panels.
    fn part_of_smooth(&self, z: f64, length: f64, longest: f64) -> f64 {
        if self.heights.knots().is_empty() {
            1.0
        } else {
            length / longest.min(self.radius.smooth_length(z))
        }
    }

    /// Walks panels from a point to a height, and hands every node to `sink`: height, weight, contact.
    fn march(&self, start: Point, end: f64, sink: &mut impl Sink) {
        let upwards = end >= start.z;
        let log_scale = sink.log_scale();
        self.march_by(start, end, |z| self.smooth_length(z, upwards, log_scale), sink);
    }

    /// Walks panels no longer than `smooth_length` of where each begins.
    fn march_by<S: Sink>(&self, start: Point, end: f64, smooth_length: impl Fn(f64) -> f64, sink: &mut S) {
        let direction = if end >= start.z { 1.0 } else { -1.0 };
        let constant_radius = self.radius.is_constant();
        let mut here = start;
        for _ in 0..S::MOST_PANELS {
            let remaining = direction * (end - here.z);
            if remaining <= 0.0 {
                return;
            }
            if let Some(there) = self.cell(&here, end, sink) {
                here = there;
                continue;
            }
            let smooth = smooth_length(here.z);
            if remaining <= smooth && self.maugis.is_tip(here.contact.overlap + remaining) {
                return self.walk_tip(&here, remaining, sink);
            }
            let theta_far = self.theta_limit(&here);
            let (clearance, rate) = self.clearance_and_rate(&here);
            let approaches = direction * rate < 0.0;
            let rate = rate.abs().max(1.0);
            let smooth = match approaches {
                true => smooth.min((APPROACH * clearance).max(NEAREST * smooth.min(1.0))),
                false => smooth,
            };
            let curve = (self.maugis.at(theta_far, here.g).overlap - here.contact.overlap) / rate;
            let in_theta = curve.min(THETA_SPAN * smooth.min(1.0));
            let in_height = smooth.min(HEIGHT_RATIO * clearance);
            let by_height = in_height > in_theta;
            let mut length =
                if by_height { self.without_remnant(in_height, remaining) } else { in_theta.min(remaining) };
            let guess = here.guess_towards(theta_far, length / curve);
            let mut there = self.point(&here, direction * length, guess);
            // Load is smooth where only friction has a kink.
            let cut = if self.fineness < 1.0 { None } else { self.first_cut::<S>(&here, &there) };
            if let Some(cut) = cut {
                length = cut.rise_above(&here).abs();
                there = cut;
            }
            sink.panel(&here, &there, by_height);
            let short = there.contact.theta > SHORT_RATIO * here.contact.theta;
            if by_height && !(constant_radius && short && here.contact.overlap < nodes::LARGEST_OVERLAP) {
                let rise = direction * length;
                let mut guess = Guess::new(&here, &there, rise);
                let part_of_smooth = self.fineness * self.part_of_smooth(here.z, length, clearance);
                for (part, weight) in gauss_legendre::nodes_of_part(part_of_smooth, 0.0, 1.0) {
                    let point = self.point(&here, part * rise, guess.at(part));
                    guess.learn(part, point.contact.theta);
                    sink.node(point.z, length * weight, &point.contact);
                }
            } else {
                let theta_end = if constant_radius {
                    there.contact.theta
                } else if length == curve && rate == 1.0 {
                    theta_far
                } else {
                    let overlap = here.contact.overlap + length;
                    self.maugis.at_overlap(overlap, here.g, there.contact.theta).theta
                };
                // How the true theta departs, by the end of the panel, from that at the radius of its beginning.
                let drift = (there.contact.theta / theta_end - 1.0) / length;
                let theta = here.contact.theta;
                let part_of_theta = (theta - theta_end) / (theta - theta_far);
                let part = self.fineness * self.part_of_smooth(here.z, length, f64::MAX).max(part_of_theta);
                for (theta, weight) in gauss_legendre::nodes_of_part(part, theta_end, theta) {
                    let reference = self.maugis.at(theta, here.g);
                    let rise = direction * (reference.overlap - here.contact.overlap);
                    let weight = weight * reference.overlap_rate.abs();
                    if constant_radius {
                        sink.node(here.z + rise, weight, &reference);
                    } else {
                        let point = self.point(&here, rise, theta * (1.0 + drift * rise.abs()));
                        sink.node(point.z, weight, &point.contact);
                    }
                }
            }
            here = there;
        }
        sink.out_of_panels();
    }

    /// Walks summits whose contacts are as small as [`Maugis::is_tip`] says: in the square root of the overlap, with a cut
    /// where contact radii pass one of the slip law's.
    fn walk_tip(&self, here: &Point, length: f64, sink: &mut impl Sink) {
        let mut from = *here;
        let at = |overlap: f64| self.point(here, overlap - here.contact.overlap, 0.0);
        let last = here.contact.overlap + length;
        for kink in self.slip.kinks().into_iter().chain([f64::INFINITY]) {
            let overlap = self.maugis.hertz_overlap(kink, here.g).min(last);
            if overlap <= from.contact.overlap {
                continue;
            }
            let to = at(overlap);
            sink.panel(&from, &to, false);
            for (root, weight) in gauss_legendre::nodes(from.contact.overlap.sqrt(), overlap.sqrt()) {
                let point = at(root * root);
                sink.node(point.z, 2.0 * root * weight, &point.contact);
            }
            from = to;
        }
    }

    /// How far down in theta one panel may reach: u(theta) is singular at 0, and between the slip law's radii the
    /// friction force is a fractional power of the radius, singular at theta = pi/2.
    fn theta_limit(&self, here: &Point) -> f64 {
        let theta = here.contact.theta;
        let by_curve = THETA_RATIO * theta;
        if here.contact.radius < 0.999_999 * self.slip.kinks()[0] {
            return by_curve;
        }
        // What lies nearer to theta = pi/2 than 1e-4 is negligible.
        by_curve.max(theta - (2.0 * (FRAC_PI_2 - theta)).max(1e-4))
    }

    /// How far in height break-away is at least.
    fn clearance(&self, point: &Point) -> f64 {
        self.clearance_and_rate(point).0
    }

    /// The same, and how fast the overlap above that of break-away changes with height: where radii vary, that of break-away
    /// changes too.
    fn clearance_and_rate(&self, point: &Point) -> (f64, f64) {
        let edge = self.edges.break_away(&self.maugis, point.g);
        let rate = 1.0 - edge.overlap_by_g * point.g_rate;
        ((point.contact.overlap - edge.overlap) / rate.abs().max(1.0), rate)
    }

    /// The first summit between two where the integrand has a kink: its contact radius is one of the slip law's
    /// radii. Where the contact radius has an extremum between the two that matters, the summit of that.
    fn first_cut<S: Sink>(&self, here: &Point, end: &Point) -> Option<Point> {
        let mut cut = None;
        let mut there = *end;
        if !self.radius.is_constant() && (S::EXTREMA || self.may_pass_kink(here, &there)) {
            // Between two extrema, so that each is seen.
            if let Some(part) = between_extrema(here, &there) {
                let turn = self.point(here, part * (there.z - here.z), here.guess_towards(there.contact.theta, part));
                if turn.is_on_the_way(here, end) {
                    there = turn;
                    cut = Some(there);
                }
            }
        }
        if !self.radius.is_constant()
            && (here.radius_rise() > 0.0) != (there.radius_rise() > 0.0)
            && (S::EXTREMA || self.may_pass_kink(here, &there))
        {
            let mut theta = there.contact.theta;
            let rate = |rise: f64| {
                let point = self.point(here, rise, theta);
                theta = point.contact.theta;
                point.radius_rise()
            };
            let rise = root::bracketed(rate, 0.0, there.z - here.z);
            if is_inside(rise, there.z - here.z) {
                let turn = self.point(here, rise, theta);
                if turn.is_on_the_way(here, end) {
                    there = turn;
                    cut = Some(there);
                }
            }
        }
        for kink in self.slip.kinks() {
            // Next to theta = pi/2 radii are known to so many digits of that of the annulus.
            let is_at = |point: &Point| {
                let outer_radius = point.contact.radius / cos(point.contact.theta);
                (point.contact.radius - kink).abs() < (AT_KINK * kink).max(1e-14 * outer_radius)
            };
            if (here.contact.radius < kink) != (there.contact.radius < kink) && !is_at(here) && !is_at(&there) {
                let at_kink = self.point_of_radius(here, &there, kink);
                // Next to a fold the radius is so steep that no height tells the two apart.
                if at_kink.is_on_the_way(here, end) {
                    there = at_kink;
                    cut = Some(there);
                }
            }
        }
        cut
    }

    /// Whether contact radii between two summits, where they have an extremum, may pass one of the slip law's. They change by
    /// no more than a few times what their slopes at the two give; in theta these are finite at break-away too.
    fn may_pass_kink(&self, here: &Point, there: &Point) -> bool {
        let change_at = |point: &Point| {
            let by_theta = point.contact.radius_rate * (there.contact.theta - here.contact.theta);
            let by_g = point.contact.radius_by_g * point.g_rate * (there.z - here.z);
            by_theta.abs() + by_g.abs()
        };
        let change = 4.0 * change_at(here).max(change_at(there));
        let (a, b) = (here.contact.radius, there.contact.radius);
        self.slip.kinks().iter().any(|&kink| kink > a.min(b) - change && kink < a.max(b) + change)
    }

    /// The summit between two whose contact radius is `radius`, by Newton's method within the bracket.
    fn point_of_radius(&self, here: &Point, there: &Point, radius: f64) -> Point {
        let rising = there.contact.radius > here.contact.radius;
        let (mut lower, mut upper) = (0.0, 1.0);
        let whole = there.z - here.z;
        let mut part = part_of_radius(here, there, radius);
        let mut point = self.point(here, part * whole, here.guess_towards(there.contact.theta, part));
        for _ in 0..100 {
            let excess = point.contact.radius - radius;
            if (excess > 0.0) == rising {
                upper = part;
            } else {
                lower = part;
            }
            let slope = point.radius_slope() * whole;
            let newton = part - excess / slope;
            let next = if newton > lower && newton < upper { newton } else { 0.5 * (lower + upper) };
            let change = next - part;
            // theta to first order in the step.
            let theta = point.contact.theta;
            let guess = theta + (change * whole * point.theta_slope()).clamp(-0.5 * theta, 0.5 * theta);
            part = next;
            point = self.point(here, part * whole, guess);
            let is_there = (point.contact.radius - radius).abs() <= 1e-2 * AT_KINK * radius;
            if is_there || change.abs() <= 1e-14 * part {
                break;
            }
        }
        point
    }

    /// Adds the summits that attract without contact between two heights.
    fn add_attractions(
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

/// The first panel above the foot of a distribution, in the variable v of z = foot + length v^power.
struct FootPanel {
    length: f64,
    power: f64,
}

impl FootPanel {
    /// The height above the foot and its derivative by v.
    fn at(&self, v: f64) -> (f64, f64) {
        let rise = self.length * pow(v, self.power);
        (rise, self.power * rise / v)
    }
}

impl Point {
    /// The same contact of a higher summit at a larger separation.
    fn raised(&self, separation: f64) -> Self {
        Point { z: self.z + separation, ..*self }
    }

    /// A starting theta on the way to a contact of smaller theta, when `part` of the overlap between is gone.
    fn guess_towards(&self, theta_far: f64, part: f64) -> f64 {
        let (from, to) = (inverse_square(self.contact.theta), inverse_square(theta_far));
        1.0 / (from + part * (to - from)).sqrt()
    }

    /// How much higher it is than another: from overlaps where these are known to more digits.
    fn rise_above(&self, other: &Self) -> f64 {
        if self.contact.overlap.abs() < self.z.abs() {
            self.contact.overlap - other.contact.overlap
        } else {
            self.z - other.z
        }
    }

    /// Whether it is on the way from one to another, beyond rounding.
    fn is_on_the_way(&self, here: &Self, end: &Self) -> bool {
        let known = self.contact.overlap.abs().min(self.z.abs());
        self.rise_above(here) * (end.z - here.z).signum() > 4.0 * f64::EPSILON * known
    }

    /// dtheta/dz at fixed separation.
    fn theta_slope(&self) -> f64 {
        let rate = self.contact.overlap_rate;
        if rate < -f64::MIN_POSITIVE {
            (1.0 - self.contact.overlap_by_g * self.g_rate) / rate
        } else {
            0.0 // at break-away it is infinite
        }
    }

    /// da/dz at fixed separation.
    fn radius_slope(&self) -> f64 {
        self.contact.radius_rate * self.theta_slope() + self.contact.radius_by_g * self.g_rate
    }

    /// da/dz times a positive factor that makes it smooth also at break-away.
    fn radius_rise(&self) -> f64 {
        let c = &self.contact;
        -(c.radius_rate * (1.0 - c.overlap_by_g * self.g_rate) + c.radius_by_g * self.g_rate * c.overlap_rate)
    }
}

/// About which part of the way from one summit to another the contact radius is `radius`: by the cubic that has the height's
/// values and slopes against radius at both, or the straight line where that leaves the way.
fn part_of_radius(here: &Point, there: &Point, radius: f64) -> f64 {
    let change = there.contact.radius - here.contact.radius;
    let line = (radius - here.contact.radius) / change;
    let slope = |point: &Point| change / (point.radius_slope() * (there.z - here.z));
    let (start, end) = (slope(here), slope(there));
    let cubic = line * (start + line * ((3.0 - 2.0 * start - end) + line * (start + end - 2.0)));
    if cubic > 0.0 && cubic < 1.0 {
        cubic
    } else {
        line.clamp(1e-6, 1.0 - 1e-6)
    }
}

/// Where between two summits, as a part of the way, the contact radius turns back from an extremum to another, by the cubic
/// that has its values and slopes at both.
fn between_extrema(here: &Point, there: &Point) -> Option<f64> {
    let whole = there.z - here.z;
    let change = there.contact.radius - here.contact.radius;
    let [start, end] = [here, there].map(|point| point.radius_slope() * whole);
    // Its slope is start + 2 b t + 3 c t^2.
    let (b, c) = (3.0 * change - 2.0 * start - end, start + end - 2.0 * change);
    let part = -b / (3.0 * c);
    let turns = start + b * part;
    (start * end > 0.0 && start * turns < 0.0 && part > 0.1 && part < 0.9).then_some(part)
}

/// Whether a rise ends well inside a range.
fn is_inside(rise: f64, whole: f64) -> bool {
    let part = rise / whole;
    part > 1e-9 && part < 1.0 - 1e-9
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::asperity::maugis::tests::EVALUATIONS;
    use crate::params::{HeightFamily, Params};

    /// Takes three panels.
    #[derive(Default)]
    struct Few {
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

    fn population(heights: HeightFamily) -> Population {
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
    fn unequal(amplitude: f64, rate: f64) -> Population {
        of(&Params { radius_amplitude: amplitude, radius_rate: rate, ..Params::default() })
    }

    #[test]
    fn the_summit_of_a_contact_radius_is_found_in_few_steps() {
        let mut count = 0;
        for (amplitude, rate) in [(0.6, 1.5), (-0.3, 0.8), (0.9, 0.3)] {
            let population = unequal(amplitude, rate);
            for (from, rise) in [(-1.0, 0.7), (0.2, 0.4), (0.6, -0.5), (-0.3, 0.01)] {
                let here = population.point_cold(-2.0, from);
                let there = population.point(&here, rise, here.contact.theta);
                let radii = (here.contact.radius, there.contact.radius);
                for part in [1e-6, 0.1, 0.5, 0.83, 1.0 - 1e-6] {
                    let radius = radii.0 + part * (radii.1 - radii.0);
                    let start = part_of_radius(&here, &there, radius);
                    let guess = here.guess_towards(there.contact.theta, start);
                    let near = population.point(&here, start * rise, guess).contact.radius;
                    assert!((near - radius).abs() < 0.02 * (radii.1 - radii.0).abs(), "{near}, not {radius}");
                    EVALUATIONS.set(0);
                    let found = population.point_of_radius(&here, &there, radius);
                    count += EVALUATIONS.get();
                    assert!((found.contact.radius / radius - 1.0).abs() < 1e-11, "{found:?}, not {radius}");
                    let done = (found.z - from) / rise;
                    assert!(done > 0.0 && done < 1.0, "{done}");
                }
            }
        }
        assert!(count <= 303, "{count} evaluations");
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

    /// A summit at a height, whose contact has a radius with a slope.
    fn summit(z: f64, radius: f64, slope: f64) -> Point {
        let mut point = population(HeightFamily::Gaussian).point_cold(-2.0, 0.0);
        (point.z, point.g_rate) = (z, 1.0);
        (point.contact.radius, point.contact.radius_rate, point.contact.radius_by_g) = (radius, 0.0, slope);
        point
    }

    #[test]
    fn a_contact_radius_turns_between_two_extrema() {
        // The cubic a t + b t^2 + c t^3 over another length, upwards and downwards.
        for (a, b, c, turn) in [
            (1.0, -4.5, 3.0, Some(0.5)),
            (1.0, -5.5, 4.0, Some(5.5 / 12.0)),
            (-1.0, 5.5, -4.0, Some(5.5 / 12.0)),
            (1.0, -12.0, 30.0, Some(2.0 / 15.0)),
            (1.0, -1.132, 0.424, Some(1.132 / 1.272)),
            // Next to an end; no extremum; one; two before the start.
            (1.0, -12.0, 45.0, None),
            (1.0, -1.0545, 0.37, None),
            (1.0, -2.0, 2.0, None),
            (1.0, -2.0, 0.5, None),
            (1.0, 4.5, 3.0, None),
        ] {
            for length in [1.0, 0.2, -3.0] {
                let at = |t: f64| (t * (a + t * (b + t * c)), (a + t * (2.0 * b + t * 3.0 * c)) / length);
                let [(start, start_slope), (end, end_slope)] = [at(0.0), at(1.0)];
                let (here, there) = (summit(0.3, 5.0 + start, start_slope), summit(0.3 + length, 5.0 + end, end_slope));
                match (between_extrema(&here, &there), turn) {
                    (Some(found), Some(turn)) => assert!((found - turn).abs() < 1e-12, "{found}, not {turn}"),
                    (found, turn) => assert_eq!(found, turn, "of {a} t + {b} t^2 + {c} t^3 over {length}"),
                }
            }
        }
    }

    #[test]
    fn a_rise_ends_inside_a_range_beyond_rounding() {
        for (part, inside) in [(1e-10, false), (2e-9, true), (0.5, true), (1.0 - 2e-9, true), (1.0 - 1e-10, false)] {
            for whole in [1.0, -1.0, 20.0, 0.03] {
                assert_eq!(is_inside(part * whole, whole), inside, "{part} of {whole}");
            }
        }
        assert!(!is_inside(-0.5, 1.0) && !is_inside(1.5, 1.0));
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

    /// Nor much shorter than it need be.
    #[test]
    fn a_panel_downwards_is_as_long_as_one_upwards_from_its_end() {
        for population in [unequal(0.6, 1.5), unequal(-0.9, 4.0), unequal(0.5, 30.0), unequal(0.0, 1.0)] {
            for z in [-5.0, -0.7, 0.0, 0.3, 2.0, 8.0] {
                let above = |z: f64| population.smooth_length(z, true, f64::NEG_INFINITY);
                let length = population.smooth_length(z, false, f64::NEG_INFINITY);
                assert!(length > 0.0 && length <= above(z - length), "{length} at {z}");
                let longest = population.heights.longest_below(z);
                assert!(length == longest || 2.0 * length > above(z - 2.0 * length), "{length} at {z}");
            }
        }
    }

    /// The slopes of theta and of the contact radius with height.
    #[test]
    fn slopes_at_a_separation_are_those_of_secants() {
        for population in [unequal(0.6, 1.5), unequal(-0.9, 4.0)] {
            for z in [-1.5, -0.2, 0.1, 0.9] {
                let here = population.point_cold(-2.0, z);
                let step = 1e-5;
                let [before, after] = [-step, step].map(|rise| population.point(&here, rise, here.contact.theta));
                let secant = |of: fn(&Point) -> f64| (of(&after) - of(&before)) / (2.0 * step);
                let (theta, radius) = (secant(|point| point.contact.theta), secant(|point| point.contact.radius));
                assert!((here.theta_slope() / theta - 1.0).abs() < 1e-7, "{} not {theta} at {z}", here.theta_slope());
                assert!(
                    (here.radius_slope() / radius - 1.0).abs() < 1e-7,
                    "{} not {radius} at {z}",
                    here.radius_slope()
                );
                let rise = -radius * here.contact.overlap_rate;
                assert!((here.radius_rise() / rise - 1.0).abs() < 1e-7, "{} not {rise} at {z}", here.radius_rise());
            }
        }
    }

    /// There the radius rises as the square root of the height.
    #[test]
    fn the_summit_of_a_contact_radius_next_to_break_away_is_found_to_all_digits() {
        let mut count = 0;
        for population in [unequal(0.6, 1.5), unequal(-0.3, 0.8)] {
            let edges = population.edges.at_separation(&population.maugis, &population.radius, 0.3);
            let here = population.edge_point(edges.iter().next().expect("an edge"));
            assert!(here.contact.radius < 1e-9, "{}", here.contact.radius);
            let there = population.point(&here, 0.2, 0.3);
            for part in [1e-5, 1e-4, 1e-3, 0.01, 0.1, 0.5] {
                let radius = part * there.contact.radius;
                EVALUATIONS.set(0);
                let found = population.point_of_radius(&here, &there, radius).contact.radius;
                count += EVALUATIONS.get();
                assert!((found / radius - 1.0).abs() < 1e-10, "{found}, not {radius}");
            }
        }
        assert!(count <= 667, "{count} evaluations");
    }

    /// Next to theta = pi/2, where rounding keeps radii from those of the slip law.
    #[test]
    fn where_a_panel_was_cut_it_is_not_cut_again() {
        for part in 0..20 {
            let mut params = Params::default();
            params.slip.radius_1 = 1e-5 * (1.0 + 0.1 * f64::from(part));
            let population = of(&params);
            let edges = population.edges.at_separation(&population.maugis, &population.radius, 0.3);
            let here = population.edge_point(edges.iter().next().expect("an edge"));
            let there = population.point(&here, 0.2, 0.3);
            let cut = population.first_cut::<Few>(&here, &there).expect("a cut");
            EVALUATIONS.set(0);
            assert!(population.first_cut::<Few>(&cut, &there).is_none());
            assert_eq!(EVALUATIONS.get(), 0, "{}", params.slip.radius_1);
        }
    }

    #[test]
    fn nothing_is_on_the_way_to_itself() {
        let mut here = summit(0.3, 5.0, 1.0);
        let there = summit(0.8, 5.0, 1.0);
        for overlap in [0.0, 0.7] {
            here.contact.overlap = overlap;
            let higher = Point { z: 0.5, contact: Contact { overlap: overlap + 0.2, ..here.contact }, ..here };
            assert!(!here.is_on_the_way(&here, &there) && higher.is_on_the_way(&here, &there));
            let lower = Point { z: -0.2, ..there };
            assert!(!here.is_on_the_way(&here, &lower) && !higher.is_on_the_way(&here, &lower));
        }
    }
}
