//! The sums over all summits at a given separation, eqs (2), (12), (16), and their slopes.
//!
//! Each sum is an integral over height z of an asperity's law times the height density. `break_away` tells where contact
//! begins, `walk` goes over the summits in contact in `panels` that end at `cuts`, `attracted` over those that attract below;
//! `node_table` keeps what is the same at every separation. `statistics` tells more of the contacts than their sums, `tangential`
//! what they resist before they slip, `one_summit` gives the law of a single one, `crowding` what neighbours change,
//! `unloading` what a larger load has left.
//!
//! Heights, overlaps and separations are in sigma; sums are per summit, loads in E* b^2, friction in G* b^2, areas in b^2.

mod attracted;
mod break_away;
mod crowding;
mod cuts;
mod kinks;
mod node_table;
mod one_summit;
mod panels;
pub mod radius;
mod statistics;
mod sums;
mod tangential;
mod unloading;
mod walk;

pub use one_summit::{LoadTable, OneSummit, Pressed};
pub use statistics::Statistics;
pub use sums::Sums;
pub use tangential::Microslip;

use crate::asperity::attraction::Attraction;
use crate::asperity::contact::{Contact, ContactLaw, Rates, KINKS};
use crate::asperity::elastic_plastic::{first_yield, ElasticPlastic};
use crate::asperity::groups::Groups;
use crate::asperity::hertz::Hertz;
use crate::asperity::maugis::Maugis;
use crate::asperity::slip::Slip;
use crate::distribution::{panel, HeightDistribution};
use crate::error::Error;
use crate::numerics::root::LAST_STEP;
use break_away::Edge;
use crowding::Crowding;
use node_table::NodeTable;
use radius::RadiusProfile;
use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};
use sums::Summit;
use walk::{Progress, Visitor, Walk};

/// The most contact radii at which what is summed has a kink: two of the slip law, and three where summits begin to slip.
const RADII: usize = 5;
/// The first of those.
const ONSET: usize = 2;

/// A population of summits pressed against a flat.
#[derive(Debug, Clone)]
pub struct Population {
    law: Arc<dyn ContactLaw>,
    attraction: Option<Attraction>,
    slip: Slip,
    heights: Arc<dyn HeightDistribution>,
    radius: RadiusProfile,
    /// How fast radii change, as [`RadiusProfile::steepness`] has it.
    radius_steepness: f64,
    groups: Groups,
    lambda_cubed: f64,
    /// The separation at which the summits stood under the largest load; infinite at first loading.
    largest: f64,
    /// By how much less than then summits overlap; 0 at first loading.
    lost: f64,
    /// The contact radii at which what is summed has a kink, infinite where there are fewer.
    radius_kinks: [f64; RADII],
    /// The overlaps over g at which the law of contact has.
    kinks_of_contact: [f64; KINKS],
    /// The friction force over the contact radius at which it has one too: contacts are about to slip.
    onset_ratio: Option<f64>,
    /// Whether panels end also at extrema of the contact radius that are far from those.
    ends_at_extrema: bool,
    /// The overlaps over g at which summits begin to yield, and to flow, infinite where they do not.
    yields: [f64; KINKS],
    /// No summit in contact has a smaller overlap.
    deepest: f64,
    /// What lies below this height is negligible.
    lower_cut: f64,
    /// What lies above this height is no number.
    highest: f64,
    /// Whether sums are asked for to some 1e-6 only.
    is_rough: bool,
    /// Where radii are equal: contacts at nodes, once sums are asked for.
    nodes: Option<Arc<OnceLock<NodeTable>>>,
}

/// Where Newton's method takes more steps, the height does not follow from the parameter: a shorter panel serves.
const NEWTONS_STEPS: u32 = 10;

/// A summit in contact, at its height.
#[derive(Debug, Clone, Copy, Default)]
pub struct Point {
    pub(crate) z: f64,
    /// Slope of the radius over the mean radius.
    pub(crate) g_rate: f64,
    pub(crate) contact: Contact,
}

impl Point {
    /// dz/ds along the branch of summits at one separation.
    #[inline]
    fn z_rate(&self) -> f64 {
        self.contact.by_s.overlap / self.height_share()
    }

    /// What part of a change of overlap at fixed s remains of a change of height: 1 where radii are equal.
    #[inline]
    fn height_share(&self) -> f64 {
        1.0 - self.contact.by_g.overlap * self.g_rate
    }

    /// How the contact radius changes with height at one separation: da/dz du/ds, which is finite also where s turns back.
    fn radius_change(&self) -> f64 {
        self.change(|rates| rates.radius)
    }

    /// How a quantity with these rates changes with height, likewise.
    fn change(&self, rate: impl Fn(&Rates) -> f64) -> f64 {
        rate(&self.contact.by_s) * self.height_share()
            + rate(&self.contact.by_g) * self.g_rate * self.contact.by_s.overlap
    }

    /// The same contact of a higher summit at a larger separation, where radii are equal.
    fn raised(&self, separation: f64) -> Self {
        Self { z: self.z + separation, ..*self }
    }
}

/// Adds up what summits contribute.
impl Visitor for Sums {
    fn is_smooth(&self) -> bool {
        true
    }

    #[inline]
    fn summits(&mut self, _z: f64, fraction: f64, summit: &Summit) {
        self.add_contact(fraction, summit);
    }
}

impl Population {
    /// The population of a surface; `attract` says whether summits out of contact attract.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if radii vary so steeply that taller summits part before lower ones.
    pub fn new(
        groups: &Groups,
        slip: Slip,
        heights: Arc<dyn HeightDistribution>,
        radius: RadiusProfile,
        attract: bool,
    ) -> Result<Self, Error> {
        let law: Arc<dyn ContactLaw> = match groups {
            _ if groups.yields => Arc::new(ElasticPlastic::new(groups)),
            _ if groups.gamma > 0.0 => Arc::new(Maugis::new(groups)),
            _ => Arc::new(Hertz::new(groups)),
        };
        let lower_cut = panel::lower_cut(&*heights);
        let highest = panel::upper_cut(&*heights);
        let deepest = break_away::deepest(&*law, &radius, lower_cut, highest)?;
        let [first, second] = slip.kinks();
        let kinks_of_contact = law.kinks();
        // Elastic summits are told where they would yield, but not from where they would flow.
        let yields = if groups.yields { kinks_of_contact } else { [first_yield(groups), f64::INFINITY] };
        Ok(Self {
            law,
            attraction: (attract && groups.gamma > 0.0).then(|| Attraction::new(groups)),
            slip,
            heights,
            nodes: radius.is_constant().then(Arc::default),
            radius_steepness: radius.steepness(),
            radius,
            groups: *groups,
            lambda_cubed: groups.lambda_cubed(),
            largest: f64::INFINITY,
            lost: 0.0,
            radius_kinks: [first, second, f64::INFINITY, f64::INFINITY, f64::INFINITY],
            kinks_of_contact,
            onset_ratio: None,
            ends_at_extrema: false,
            yields,
            deepest,
            lower_cut,
            highest,
            is_rough: false,
        })
    }

    /// The same population, of which sums are to all digits, or to some 1e-6 at half the cost.
    pub fn summed(&self, is_rough: bool) -> Self {
        Self { is_rough, ..self.clone() }
    }

    /// Whether sums are rough.
    pub fn is_rough(&self) -> bool {
        self.is_rough
    }

    /// The same summits with other slip stresses at the same radii.
    pub fn with_slip(&self, slip: Slip) -> Self {
        let mut other = Self { slip, ..self.clone() };
        other.forget_table();
        other
    }

    /// What is tabulated of it; `None` where radii vary.
    fn table(&self) -> Option<&NodeTable> {
        Some(self.nodes.as_ref()?.get_or_init(|| NodeTable::new(self)))
    }

    /// Gives the table back, which is made again once sums are asked for: it takes more memory than a compiled law.
    pub fn forget_table(&mut self) {
        self.nodes = self.nodes.take().map(|_| Arc::default());
    }

    /// The mean summit radius in standard deviations of height.
    pub fn mean_radius(&self) -> f64 {
        1.0 / (self.groups.alpha * self.groups.alpha)
    }

    /// The height distribution.
    pub fn heights(&self) -> &dyn HeightDistribution {
        &*self.heights
    }

    /// Between these heights all of it lies but what is negligible.
    pub fn extent(&self) -> (f64, f64) {
        (self.lower_cut, self.highest)
    }

    /// Whether anything attracts.
    pub fn is_adhesive(&self) -> bool {
        self.lambda_cubed > 0.0
    }

    /// Whether load against separation can have but one minimum: the slope of the law of equal summits changes sign once,
    /// and a log-concave density adds no change of sign (it diminishes variation).
    pub fn has_single_minimum(&self) -> bool {
        self.radius.is_constant() && self.heights.outline().is_log_concave
    }

    /// The heights, in sigma, on whose scale radii change.
    pub fn radius_scale(&self) -> f64 {
        1.0 / self.radius.steepness()
    }

    /// How far, in sigma, a summit above the flat is pulled, or one in contact holds on.
    pub fn range_of_adhesion(&self) -> f64 {
        self.attraction.as_ref().map_or(0.0, |law| law.reach).max(-self.deepest)
    }

    /// A separation beyond which nothing touches or attracts, in any number that can be represented.
    pub fn farthest(&self) -> f64 {
        self.parts_at(self.highest) + self.range_of_adhesion()
    }

    /// The sums at a separation; NaN where they take more panels than there may be.
    pub fn at_separation(&self, separation: f64) -> Sums {
        self.among_neighbours(self.as_at(separation).of_lone_summits(separation))
    }

    /// What neighbours change, if the nominal area is known.
    pub fn crowding(&self) -> Option<Crowding> {
        let stiffness_of_radius = self.groups.stiffness_of_radius();
        let Groups { nominal_area, .. } = self.groups;
        (nominal_area > 0.0).then_some(Crowding { nominal_area, stiffness_of_radius })
    }

    fn of_lone_summits(&self, separation: f64) -> Sums {
        let edge = self.edge(separation);
        let mut sums = Sums::default();
        self.add_attractions(&mut sums, separation, &edge);
        if self.visit(separation, &edge, &mut sums).is_err() {
            return Sums::unknown();
        }
        self.add_edge(&mut sums, separation, &edge);
        sums
    }

    /// The same population, of sums to all digits, without what is tabulated of it, which would not follow another law, other radii or
    /// other kinks.
    fn without_tables(&self) -> Self {
        Self { nodes: None, is_rough: false, ..self.clone() }
    }

    /// The same population summed in panels that end at other kinks too.
    fn with_kinks(&self, radius_kinks: [f64; RADII], kinks_of_contact: [f64; KINKS]) -> Self {
        Self { radius_kinks, kinks_of_contact, ..self.without_tables() }
    }

    /// The height at which summits just break away.
    fn edge(&self, separation: f64) -> Edge {
        match self.table() {
            Some(table) => Edge { point: table.edge.raised(separation), rate: 1.0 },
            None if self.lost > 0.0 => Edge::of_unloading(&*self.law, &self.radius, separation, self.highest),
            None => Edge::at_separation(&*self.law, &self.radius, separation, self.deepest),
        }
    }

    /// Hands all summits in contact to a visitor.
    ///
    /// # Errors
    /// [`Error::NotConverged`] if that takes more panels than there may be; the same of all that goes over summits.
    fn visit(&self, separation: f64, edge: &Edge, visitor: &mut impl Visitor) -> Result<(), Error> {
        match (self.contacts(separation, edge), self.table()) {
            (None, _) => Ok(()),
            (Some(walk), Some(table)) => self.walk_table(table, &walk, visitor),
            (Some(walk), None) => self.walk(&walk, &mut Progress::default(), visitor),
        }
    }

    /// All contacts; `None` if there are none.
    fn contacts(&self, separation: f64, edge: &Edge) -> Option<Walk> {
        let (edge_height, lowest) = (edge.point.z, self.lower_cut);
        let start = match edge_height >= lowest {
            true => edge.point,
            false => {
                let guess = self.law.guess(lowest - separation, self.radius.factor(lowest));
                self.at_height(separation, lowest, guess)
            }
        };
        (edge_height < self.highest).then_some(Walk { separation, start, edge_height, end: f64::INFINITY })
    }

    /// Whether there are summits that break away at a separation.
    fn has_summits_at(&self, edge: &Edge) -> bool {
        let (lowest, highest) = self.heights.outline().support;
        (lowest.max(self.lower_cut)..=highest).contains(&edge.point.z)
    }

    /// The slopes' share of a moving edge: what a summit loses there at once, times how fast heights pass it.
    fn add_edge(&self, sums: &mut Sums, separation: f64, edge: &Edge) {
        let z = edge.point.z;
        if !self.has_summits_at(edge) {
            return;
        }
        let density = crate::numerics::elementary::exp(self.heights.log_density(z)) / edge.rate;
        let below = self.attraction_at(z - separation, z).map_or(0.0, |attracted| attracted.load);
        sums.load_slope -= density * (edge.point.contact.load - below);
        sums.friction_slope -= density * self.slip.friction(&edge.point.contact).force;
        sums.hertz_load_slope -= density * edge.point.contact.hertz_load;
        sums.radius_slope -= density * edge.point.contact.radius;
        sums.area_slope -= density * PI * edge.point.contact.radius * edge.point.contact.radius;
    }

    /// The summit of a height, from a guess of its parameter.
    #[inline]
    fn at_height(&self, separation: f64, z: f64, guess: f64) -> Point {
        self.of_radius(separation, z, self.radius.at(z), guess)
    }

    /// The same where its radius is known, with its slope.
    #[inline]
    fn of_radius(&self, separation: f64, z: f64, (g, g_rate): (f64, f64), guess: f64) -> Point {
        Point { z, g_rate, contact: self.law.at_overlap(z - separation, g, guess) }
    }

    /// The summit of a parameter, from a guess of its height: the root of z - d - u(s, g(z)). All of it is NaN, and so are
    /// sums over it, if Newton's method does not find it.
    #[inline]
    fn on_branch(&self, separation: f64, parameter: f64, guess: f64) -> Point {
        if self.radius.is_constant() {
            let contact = self.law.at(parameter, 1.0);
            return Point { z: separation + contact.overlap, g_rate: 0.0, contact };
        }
        let mut z = guess;
        for _ in 0..NEWTONS_STEPS {
            let (g, g_rate) = self.radius.at(z);
            let point = Point { z, g_rate, contact: self.law.at(parameter, g) };
            let share = point.height_share();
            let step = (point.contact.overlap - (z - separation)) / share;
            let rounding = 2.0 * f64::EPSILON * (z.abs() + separation.abs());
            if step.abs() * self.radius_steepness <= LAST_STEP || step.abs() * share.abs().min(1.0) <= rounding {
                return Point { z: z + step, contact: point.contact.moved(0.0, g_rate * step), ..point };
            }
            z += step;
        }
        Point { z: f64::NAN, g_rate: f64::NAN, contact: self.law.at(f64::NAN, 1.0) }
    }
}

#[cfg(test)]
pub(crate) mod tests;
