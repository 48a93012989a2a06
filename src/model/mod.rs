//! A surface pair ready for use: friction and stiffness at a load, from the compiled law, in the caller's units.
//!
//! `exact` answers all else that a caller can ask, by sums over the summits.

mod after;
pub(crate) mod calibration;
mod exact;
mod gap;
mod microslip;
pub mod validity;

use crate::asperity::groups::Groups;
use crate::equilibrium::{Branch, Waves};
use crate::error::{Error, LOAD};
use crate::law::tolerance::{self, larger};
use crate::law::{Beyond, Law, Lengths, Quantity, Table, Unfollowed};
use crate::numerics::elementary::cbrt;
use crate::numerics::float_bits::{finite, finite_up_to, tame, TAMEST};
use crate::numerics::neighbours::Neighbours;
use crate::params::Params;
use crate::population::Population;
use after::Unloaded;
pub(crate) use exact::Borne;
pub use exact::State;
pub(crate) use gap::by_gap;
use std::ops::Deref;

/// Heavier loads than this many E* b^2 per summit are out of range: intermediate numbers would overflow.
const HEAVIEST_LOAD: f64 = 1e80;
/// A friction coefficient above this is taken as infinite.
const INFINITE_COEFFICIENT: f64 = 1e140;
/// What the load after which surfaces are unloaded is called.
const LARGEST_LOAD: &str = "largest_load";
/// No load curve has more minima than this.
const MOST_MINIMA: usize = 8;

/// The friction law of a surface pair. Immutable: threads may share it.
#[derive(Debug, Clone)]
pub struct Model {
    surfaces: Surfaces,
    law: Law,
    known: [Known; Quantity::COUNT],
    /// What contacts that have borne a larger load than they bear follow, if that is another law.
    unloaded: Option<Unloaded>,
}

/// A surface pair of which sums over the summits are asked, one load at a time: what a model is without its compiled law.
#[derive(Debug, Clone)]
pub struct Surfaces {
    params: Params,
    groups: Groups,
    branch: Branch,
    units: Units,
    /// 1 / max_friction_coefficient, of a finite one.
    inverse_cap: f64,
    /// The heaviest load that can be evaluated.
    heaviest: f64,
    /// The largest load that the summits have borne; 0 at first loading.
    pub(crate) largest_load: f64,
}

impl Deref for Model {
    type Target = Surfaces;

    #[inline(always)]
    fn deref(&self) -> &Surfaces {
        &self.surfaces
    }
}

/// Friction force or tangential stiffness at loads beside its table, found when the model is made.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Known {
    /// Value and slope at the pull-off load.
    pub at_pull_off: (f64, f64),
    /// Value and slope at zero load.
    pub at_zero: (f64, f64),
    /// Slope below the pull-off load.
    pub apart: f64,
    /// What is gained by load on a straight line from pull-off to the table's first row.
    pub light_slope: f64,
    /// Value at the heavy end of the table.
    pub heavy: f64,
}

/// Factors from sums per summit to the caller's units.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Units {
    /// N E* b^2.
    pub load: f64,
    /// N G* b^2.
    pub force: f64,
    /// 8 G^ N b: stiffness, of a mean contact radius in b.
    pub stiffness: f64,
    /// 8 G^.
    stiffness_per_radius: f64,
    /// N b^2.
    pub area: f64,
    /// sigma.
    pub length: f64,
    /// N.
    pub count: f64,
}

/// Constants of a model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// (sigma/R)^(1/2).
    pub alpha: f64,
    /// (R sigma)^(1/2)/b.
    pub beta: f64,
    /// w/(E* b).
    pub gamma: f64,
    /// Maugis' parameter at the mean radius, eq (7).
    pub lambda: f64,
    /// Skew of the summit heights.
    pub skew: f64,
    /// Kurtosis of the summit heights (3 for Gaussian).
    pub kurtosis: f64,
    /// The pull-off load, the smallest load at which the surfaces hold together, <= 0 [force]. It is that of the mean over many
    /// summits, far below that of one rough specimen, which its few tallest summits hold.
    pub pull_off_load: f64,
    /// Friction force at the pull-off load [force].
    pub pull_off_friction_force: f64,
    /// Friction force at zero load [force].
    pub zero_load_friction_force: f64,
    /// 8 G^ [stress]: tangential stiffness over the sum of the radii of all contacts over psi, which is 1 where the nominal area
    /// is not known. The constriction conductance is 2 k times that sum, k the harmonic mean of the conductivities of the two
    /// bodies.
    pub stiffness_per_radius: f64,
    /// The lightest load the compiled law covers [force].
    pub min_table_load: f64,
    /// The heaviest load the compiled law covers [force].
    pub max_table_load: f64,
    /// Largest relative error of the compiled friction force at the samples that were compared when the model was made;
    /// times what errors between samples are larger by.
    pub table_error: f64,
    /// The largest load that the summits have borne [force]; 0 of a model of first loading.
    pub largest_load: f64,
}

impl Model {
    /// The model of a surface pair.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`] naming the first parameter at fault.
    pub fn new(params: &Params) -> Result<Self, Error> {
        Self::compiled(Surfaces::new(params)?, None, false)
    }

    /// This surface pair after a largest load: summits that yielded spring back elastically from it, and back to it. Above it first
    /// loading goes on. Without a law of contact in which summits yield nothing changes.
    ///
    /// # Errors
    /// As [`Model::state_at_load`]; [`Error::OutOfRange`] for adhesion, for a load beyond the table or below the largest load that this
    /// model has borne, and where radii vary so much that taller summits would part before lower ones.
    pub fn unloaded(&self, largest_load: f64) -> Result<Self, Error> {
        self.unloaded_for(largest_load, false)
    }

    /// The same, if so asked only for lighter loads, which takes half the time.
    fn unloaded_for(&self, largest_load: f64, only_lighter: bool) -> Result<Self, Error> {
        let refused = |allowed| Err(Error::out_of_range(LARGEST_LOAD, largest_load, allowed));
        let of_load = |error: Error| error.of_load(LARGEST_LOAD);
        self.validate_load(largest_load).map_err(of_load)?;
        if self.params.work_of_adhesion > 0.0 {
            return refused("unloading of surfaces with adhesion is not modelled: set work_of_adhesion to 0");
        }
        if self.params.waviness.height > 0.0 {
            return refused(
                "unloading of wavy surfaces is not modelled, since crests and troughs have borne different pressures: take \
                 unloading_stiffness of the state at the largest load for small vibrations, or set waviness_height to 0, give the \
                 waves to the mesh of your solver, and unload each of its contacts",
            );
        }
        if largest_load <= 0.0 || largest_load >= self.law.table(Quantity::Friction).range().1 {
            return refused("must be > 0 and below max_table_load of the summary");
        }
        if largest_load < self.largest_load {
            return refused("must not be below the largest load that this model has borne");
        }
        if !self.groups.yields {
            return Ok(self.clone());
        }
        let (separation, _) = self.equilibrium_at(largest_load).map_err(of_load)?;
        let anchor = self.law.anchor(separation);
        let Some(population) = self.branch.population().unloaded_from(separation) else {
            return refused(
                "must be lighter with this radius_amplitude: nearly all asperities touch, and of those that have yielded taller ones would part \
                 before lower ones",
            );
        };
        Self::compiled(
            Surfaces { branch: Branch::new(population)?, largest_load, ..self.surfaces.clone() },
            Some(anchor),
            only_lighter,
        )
    }

    /// The model of surfaces; an anchor is a separation and its gap, in sigma.
    fn compiled(mut surfaces: Surfaces, anchor: Option<(f64, f64)>, only_lighter: bool) -> Result<Self, Error> {
        let (units, summit_mean_height) = (surfaces.units, surfaces.params.summit_mean_height);
        let compile = |branch: &Branch| {
            // Heights count from the mean of the summits, gaps from the mean plane.
            let origin = branch.population().heights().outline().origin + summit_mean_height / units.length;
            let lengths = Lengths { unit: units.length, origin };
            let quantities = Quantity::ALL.map(|quantity| units.of(quantity));
            Law::new(branch, units.load, quantities, lengths, anchor, only_lighter)
        };
        let mut law = compile(&surfaces.branch);
        for _ in 0..MOST_MINIMA {
            let Err(Unfollowed { separation }) = law else { break };
            // Following the branch found an earlier minimum than the search did.
            surfaces.branch = surfaces.branch.ending_near(separation)?;
            law = compile(&surfaces.branch);
        }
        let law = law?;
        let error = Quantity::ALL.map(|quantity| law.error(quantity)).into_iter().fold(0.0, larger);
        if error > tolerance::MOST {
            return Err(Error::NotConverged { what: "table_error", value: error });
        }
        let remembers = anchor.is_some() && !only_lighter;
        let unloaded = remembers.then(|| Unloaded::of(law.table(Quantity::Friction).range()));
        let mut model = Self { surfaces, law, known: [Known::default(); Quantity::COUNT], unloaded };
        model.known = Quantity::ALL.map(|quantity| model.find_known(quantity));
        // A model of compiled calls alone takes half the memory.
        model.surfaces.branch.forget_table();
        Ok(model)
    }

    /// Finds a quantity at loads beside its table.
    fn find_known(&self, quantity: Quantity) -> Known {
        let at = |load: f64| self.tabulated(quantity, load).unwrap_or_else(|| self.continued(quantity, load));
        let table = self.law.table(quantity);
        let (lightest, end) = table.range();
        let (light, lightest_slope) = at(lightest);
        let (at_pull_off, at_zero, apart) = match self.branch.pull_off() {
            Some(point) => {
                let value = quantity.of(&point.sums).0 * self.units.of(quantity);
                ((value, f64::INFINITY), at(0.0), 0.0)
            }
            // Both vanish with load, and have no slope there but that next to it. An open contact has none.
            None => ((0.0, lightest_slope), (0.0, lightest_slope), 0.0),
        };
        let light_slope = (light - at_pull_off.0) / (lightest - table.pull_off);
        // The next load below: the table's end is not of it.
        let heaviest_tabulated = end.below();
        Known { at_pull_off, at_zero, apart, light_slope, heavy: at(heaviest_tabulated).0 }
    }

    /// Friction coefficient F/P, at most `max_friction_coefficient`; equal to that for pull-off <= load <= 0; 0 below
    /// pull-off; NaN for a load that is not finite or too heavy.
    pub fn friction_at_load(&self, load: f64) -> f64 {
        self.friction_and_slope(load).0
    }

    /// Friction force F; 0 below pull-off; NaN for a load that is not finite or too heavy.
    pub fn friction_force_at_load(&self, load: f64) -> f64 {
        self.friction_force_and_slope(load).0
    }

    /// Friction coefficient, as [`Model::friction_at_load`], and its slope, 0 where it is capped.
    pub fn friction_and_slope(&self, load: f64) -> (f64, f64) {
        let answer = self.tabulated_coefficient(load).or_else(|| self.known_coefficient(load));
        answer.unwrap_or_else(|| {
            let (force, slope) = self.continued(Quantity::Friction, load);
            self.coefficient_and_slope(load, force, slope)
        })
    }

    /// Friction force and its slope dF/dP, which is infinite at the pull-off load itself and 0 below it. Without
    /// adhesion the slope at zero load is that of the lightest load of the table, and 0 below.
    pub fn friction_force_and_slope(&self, load: f64) -> (f64, f64) {
        self.value_and_slope(Quantity::Friction, load)
    }

    /// Tangential stiffness K_t, the force by displacement along the surfaces while all contacts stick [force/length]; 0
    /// below pull-off; NaN for a load that is not finite or too heavy.
    pub fn tangential_stiffness_at_load(&self, load: f64) -> f64 {
        self.value_and_slope(Quantity::Radius, load).0
    }

    /// Friction force or stiffness, and its slope.
    fn value_and_slope(&self, quantity: Quantity, load: f64) -> (f64, f64) {
        let answer = self.tabulated(quantity, load).or_else(|| self.known_value(quantity, load));
        answer.unwrap_or_else(|| self.continued(quantity, load))
    }

    /// The same where the compiled law answers.
    #[inline]
    pub(crate) fn tabulated(&self, quantity: Quantity, load: f64) -> Option<(f64, f64)> {
        // Tested by bits: arithmetic with a signalling NaN, or with the largest number, would raise a floating-point exception.
        if !tame(load) {
            return None;
        }
        self.law.table(quantity).at_load(load)
    }

    /// Friction coefficient and slope where the compiled law answers.
    #[inline]
    pub(crate) fn tabulated_coefficient(&self, load: f64) -> Option<(f64, f64)> {
        let (force, slope) = self.tabulated(Quantity::Friction, load)?;
        Some(self.coefficient_and_slope(load, force, slope))
    }

    /// Friction force or stiffness and slope where they are known without a computation.
    #[inline(always)]
    pub(crate) fn known_value(&self, quantity: Quantity, load: f64) -> Option<(f64, f64)> {
        if !finite_up_to(load, self.heaviest) {
            return Some((f64::NAN, f64::NAN));
        }
        let (known, pull_off) = (&self.known[quantity as usize], self.law.table(quantity).pull_off);
        match load {
            _ if load < pull_off => Some((0.0, known.apart)),
            _ if load == pull_off => Some(known.at_pull_off),
            _ if load == 0.0 => Some(known.at_zero),
            _ => None,
        }
    }

    /// Friction coefficient and slope where they are known without a computation.
    #[inline(always)]
    pub(crate) fn known_coefficient(&self, load: f64) -> Option<(f64, f64)> {
        if !finite_up_to(load, self.heaviest) {
            return Some((f64::NAN, f64::NAN));
        }
        match load {
            _ if load < self.law.table(Quantity::Friction).pull_off => Some((0.0, 0.0)),
            _ if load <= 0.0 => Some((self.params.max_friction_coefficient, 0.0)),
            _ => None,
        }
    }

    /// Friction force or stiffness and slope at a finite load above pull-off that the table does not hold.
    fn continued(&self, quantity: Quantity, load: f64) -> (f64, f64) {
        self.law.beyond(quantity).at(load)
    }

    /// What answers there.
    #[inline]
    pub(crate) fn beyond(&self, quantity: Quantity) -> &Beyond {
        self.law.beyond(quantity)
    }

    /// The gap between the mean planes at a separation in sigma.
    pub(crate) fn gap_at(&self, separation: f64) -> f64 {
        self.law.gap_at(separation)
    }

    /// The same where neighbours change nothing.
    pub(crate) fn gap_of_lone(&self, separation: f64) -> f64 {
        self.law.gap().lengths().callers(separation)
    }

    /// The error of an admissible load whose state could not be found.
    pub(crate) fn not_evaluated(load: f64) -> Error {
        let allowed = "the state at this load cannot be found to full accuracy; please report the parameters";
        Error::out_of_range("load", load, allowed)
    }

    /// Friction force or stiffness at loads beside its table.
    pub(crate) fn known(&self, quantity: Quantity) -> Known {
        self.known[quantity as usize]
    }

    /// The constants of the model.
    pub fn summary(&self) -> Summary {
        let pull_off = self.branch.pull_off();
        Summary {
            alpha: self.groups.alpha,
            beta: self.groups.beta,
            gamma: self.groups.gamma,
            lambda: cbrt(self.groups.lambda_cubed()),
            skew: self.branch.population().heights().outline().skew,
            kurtosis: self.branch.population().heights().outline().kurtosis,
            pull_off_load: self.pull_off_load(),
            pull_off_friction_force: pull_off.map_or(0.0, |point| point.sums.friction * self.units.force),
            zero_load_friction_force: self.friction_force_at_load(0.0),
            stiffness_per_radius: self.units.stiffness_per_radius,
            min_table_load: self.law.table(Quantity::Friction).range().0,
            max_table_load: self.law.table(Quantity::Friction).range().1,
            table_error: self.law.error(Quantity::Friction),
            largest_load: self.largest_load,
        }
    }

    /// The compiled law of a quantity.
    #[inline]
    pub(crate) fn table(&self, quantity: Quantity) -> &Table {
        self.law.table(quantity)
    }
}

impl From<Unfollowed> for Error {
    fn from(Unfollowed { separation }: Unfollowed) -> Self {
        Self::NotConverged { what: "load on the branch at separation", value: separation }
    }
}

impl Surfaces {
    /// A surface pair without a compiled law.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] or [`Error::OutOfRange`] naming the first parameter at fault.
    pub(crate) fn new(params: &Params) -> Result<Self, Error> {
        Self::with_branch(params, Branch::new)
    }

    /// The same, of which sums are rough.
    ///
    /// # Errors
    /// As [`Surfaces::new`].
    pub(crate) fn roughly(params: &Params) -> Result<Self, Error> {
        Self::with_branch(params, |population| Branch::new(population.summed(true)))
    }

    /// The same of surfaces like others, of which hardly any but loads that press are asked.
    ///
    /// # Errors
    /// As [`Surfaces::new`].
    pub(crate) fn like(other: &Self, params: &Params) -> Result<Self, Error> {
        Self::with_branch(params, |population| Branch::like(&other.branch, population))
    }

    fn with_branch(params: &Params, branch: impl Fn(Population) -> Result<Branch, Error>) -> Result<Self, Error> {
        let (groups, heights, radius) = params.surface()?;
        let population = Population::new(&groups, params.slip_law(), heights, radius, params.attraction)?;
        let (units, mut branch) = (Units::new(params), branch(population)?);
        if params.waviness.height > 0.0 {
            let (places, width) = params.waviness.places(units.length);
            let stiffness_of_radius = groups.stiffness_of_radius();
            let even = Law::even(&branch.summed(false), places[0].0)?;
            branch = branch.on_waves(Waves::new(even, places, width / groups.nominal_area, stiffness_of_radius));
        }
        let inverse_cap = 1.0 / params.max_friction_coefficient.min(INFINITE_COEFFICIENT);
        let heaviest = (HEAVIEST_LOAD * units.load).min(TAMEST);
        Ok(Self { params: params.clone(), groups, branch, units, inverse_cap, heaviest, largest_load: 0.0 })
    }

    /// As [`Population::summed`].
    pub(crate) fn summed(&self, is_rough: bool) -> Self {
        Self { branch: self.branch.summed(is_rough), ..self.clone() }
    }

    /// The parameters of the surfaces.
    pub fn params(&self) -> &Params {
        &self.params
    }

    /// What the sums are over.
    pub(crate) fn population(&self) -> &Population {
        self.branch.population()
    }

    pub(crate) fn units(&self) -> &Units {
        &self.units
    }

    /// Whether the surfaces can carry a load.
    ///
    /// # Errors
    /// [`Error::InvalidLoad`] if it is not finite, [`Error::Separated`] below pull-off, [`Error::OutOfRange`] above 1e80 E* b^2
    /// per summit.
    pub fn validate_load(&self, load: f64) -> Result<(), Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: LOAD, value: load });
        }
        if load < 0.0 && load < self.pull_off_load() {
            return Err(Error::Separated { name: LOAD, load, pull_off: self.pull_off_load() });
        }
        if load > self.heaviest {
            let allowed = "must be below 1e80 composite_modulus burgers_vector^2 asperity_count";
            return Err(Error::out_of_range("load", load, allowed));
        }
        Ok(())
    }

    /// These surfaces with the strength that other parameters of them have, where states are judged.
    pub(crate) fn judged_as(&self, params: &Params) -> Self {
        Self { params: params.clone(), ..self.clone() }
    }

    /// These surfaces with the slip stresses that other parameters of them have.
    pub(crate) fn with_strength_of(&self, params: &Params) -> Self {
        Self { params: params.clone(), branch: self.branch.with_slip(params.slip_law()), ..self.clone() }
    }

    fn pull_off_load(&self) -> f64 {
        self.branch.pull_off_load() * self.units.load
    }

    /// The inverse of the cap on friction coefficients: at loads up to this times the force the coefficient is capped.
    pub(crate) fn inverse_cap(&self) -> f64 {
        self.inverse_cap
    }

    /// The heaviest load that is allowed.
    #[cfg(target_arch = "x86_64")]
    pub(crate) fn heaviest_load(&self) -> f64 {
        self.heaviest
    }

    /// F/P from the force at a load not below pull-off, capped.
    #[inline]
    pub(crate) fn coefficient(&self, load: f64, force: f64) -> f64 {
        if load <= force * self.inverse_cap {
            self.params.max_friction_coefficient
        } else {
            force / load
        }
    }

    /// F/P and its slope from the force and its slope at a load not below pull-off.
    #[inline]
    pub(crate) fn coefficient_and_slope(&self, load: f64, force: f64, slope: f64) -> (f64, f64) {
        let mu = self.coefficient(load, force);
        (mu, if load <= force * self.inverse_cap { 0.0 } else { ratio(slope - mu, load) })
    }
}

/// a/b for b > 0, saturating where it would overflow.
fn ratio(a: f64, b: f64) -> f64 {
    const LARGEST_QUOTIENT: f64 = 1e300;
    if a.abs() >= LARGEST_QUOTIENT * b.min(1.0) {
        LARGEST_QUOTIENT.copysign(a)
    } else {
        a / b
    }
}

impl Units {
    fn new(params: &Params) -> Self {
        let area = params.burgers_vector * params.burgers_vector * params.asperity_count;
        let stiffness_per_radius = 8.0 * params.effective_tangential_modulus();
        Self {
            load: params.composite_modulus * area,
            force: params.effective_shear_modulus * area,
            stiffness: stiffness_per_radius * params.burgers_vector * params.asperity_count,
            stiffness_per_radius,
            area,
            length: params.height_std,
            count: params.asperity_count,
        }
    }

    /// That of a quantity.
    fn of(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Friction => self.force,
            Quantity::Radius => self.stiffness,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_saturate_where_they_would_overflow() {
        for (a, b, quotient) in [
            (3.0, 2.0, 1.5),
            (-1e-10, 1e-300, -1e290),
            (-1.0, 1e-301, -1e300),
            (1e299, 0.5, 2e299),
            (1e300, 1e300, 1e300),
            (-2e300, 4.0, -1e300),
            (0.0, 5e-324, 0.0),
        ] {
            let found = ratio(a, b);
            assert!((found - quotient).abs() <= 1e-15 * quotient.abs(), "{a:e}/{b:e}: {found:e}");
        }
        let light =
            Model::new(&Params { work_of_adhesion: 0.0, max_friction_coefficient: f64::INFINITY, ..Params::paper() });
        let (mu, slope) = light.expect("a model").friction_and_slope(1e-305);
        assert!(mu > 0.0 && mu.is_finite() && slope == -1e300, "{mu}, {slope:e}");
    }
}
