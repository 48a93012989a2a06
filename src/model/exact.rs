//! What is evaluated exactly, by sums over the summits at a separation: states, microslip, warnings.

use super::validity::{warnings_between, Measures, NEAR_STEPS};
use super::{Model, Surfaces};
use crate::error::Error;
use crate::numerics::elementary::log;
use crate::numerics::float_bits::{finite, TAMEST};
use crate::numerics::quadrature;
use crate::population::{Statistics, Sums};

/// Displacements, as force over radius of a contact that sticks, in G* b: from the larger on all contacts slip, below the
/// smaller none does.
const LARGEST_DISPLACEMENT: f64 = 1e200;
const SMALLEST_DISPLACEMENT: f64 = 1e-200;
/// Separations, overlaps and heights beyond this many sigma are out of range.
const FARTHEST_SEPARATION: f64 = 1e50;

/// To this part of the load states are found whose loads are not handed back.
const BORNE: f64 = 1e-9;

/// Why there is no state at zero load where the pull-off load is 0.
const NO_ADHESION: &str = "without adhesion the surfaces part at zero load, at no finite separation; must be > 0";
const PULL_OFF_UNDERFLOWS: &str =
    "the surfaces adhere, but the pull-off load of so rough ones is too small for a number and \
    counts as 0; must be > 0, or ask for single specimens, which hang on their tallest asperities";

/// The exact state of the contact at a load or a gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Normal load [force].
    pub load: f64,
    /// Gap between the mean planes of the surfaces [length]; from the mean of the summits without a `summit_mean_height`.
    pub gap: f64,
    /// Friction force [force].
    pub friction_force: f64,
    /// Friction coefficient, capped; see [`Model::friction_at_load`].
    pub friction_coefficient: f64,
    /// d(friction force)/d(load); infinite at the pull-off load itself.
    pub dforce_dload: f64,
    /// d(friction coefficient)/d(load) [1/force]; 0 where the coefficient is capped.
    pub dmu_dload: f64,
    /// d(load)/d(gap) [force/length].
    pub dload_dgap: f64,
    /// Real area of contact [length^2].
    pub real_area: f64,
    /// Number of summits in contact.
    pub contacting: f64,
    /// Number of summits that attract without contact.
    pub attracted: f64,
    /// Load of the summits that attract without contact, <= 0 [force].
    pub attraction_load: f64,
    /// Mean radius of the contacts [length]; 0 if nothing touches, as the next fields except `plasticity_index`.
    pub mean_contact_radius: f64,
    /// Expected radius of the largest of n = `contacting` contacts [length]: the largest radius up to the height that
    /// 1/(n + 1) of the contacts exceed. At least the mean radius, and equal to it for n <= 1.
    pub max_contact_radius: f64,
    /// Fraction of the contacts up to the first radius of the slip law.
    pub fraction_below_slip_radius_1: f64,
    /// Fraction of the contacts between its radii.
    pub fraction_between_slip_radii: f64,
    /// Fraction of the contacts at or above its second radius.
    pub fraction_above_slip_radius_2: f64,
    /// Fraction of the summits in contact.
    pub fraction_in_contact: f64,
    /// Load of the summits in contact over their real area [stress]; negative where adhesion pulls more than they push.
    pub mean_asperity_pressure: f64,
    /// Greenwood and Williamson's plasticity index E* (sigma/R)^(1/2)/H, the same in every state; 0 without a hardness.
    pub plasticity_index: f64,
    /// Mean of the contact radii over the radii of their summits.
    pub mean_steepness: f64,
    /// Share of the load on flat parts of the surface, where heights change by less than 0.15 Sq a score; 0 without a table of heights
    /// at scores.
    pub load_on_flats: f64,
    /// Bits `WARNING_...`, for example [`WARNING_FEW`](crate::WARNING_FEW): what the model assumes and this state lacks.
    pub warnings: u64,
    /// K_t [force/length]: force by displacement along the surfaces while all contacts stick.
    pub tangential_stiffness: f64,
    /// Fraction of the contacts below first yield; 1 where elastic contacts have no hardness to yield at.
    pub fraction_elastic: f64,
    /// Fraction of the contacts that are fully plastic.
    pub fraction_flowing: f64,
    /// Sum of the radii of all contacts over psi, by which neighbours make it larger [length]: see `Summary::stiffness_per_radius`.
    pub contact_radius_sum: f64,
    /// Sum of the loads of Hertz' contacts of the same radii [force]: the load and what adhesion adds to it.
    pub hertz_load: f64,
    /// -d(load)/d(gap) when the load begins to fall [force/length]: summits that have yielded spring back elastically.
    pub unloading_stiffness: f64,
}

/// What surfaces bear at a load, in the caller's units, as in a [`State`].
#[derive(Debug, Clone, Copy)]
pub(crate) struct Borne {
    /// Of the mean of the summits, in standard deviations of their heights.
    pub separation: f64,
    /// The pressure on the places of waves, as the mean over the load, over the nominal one.
    pub pressing: f64,
    pub friction_force: f64,
    pub real_area: f64,
    pub hertz_load: f64,
    pub tangential_stiffness: f64,
    pub normal_stiffness: f64,
    pub contact_radius_sum: f64,
    pub unloading_stiffness: f64,
    /// Number of summits in contact.
    pub contacting: f64,
}

impl Model {
    /// The exact state at a load, without the compiled law.
    ///
    /// # Errors
    /// [`Error::InvalidLoad`], [`Error::Separated`] below pull-off, [`Error::OutOfRange`].
    pub fn state_at_load(&self, load: f64) -> Result<State, Error> {
        let (separation, sums) = self.equilibrium_at(load)?;
        let mut state = State { gap: self.law.gap_at(separation), ..self.surfaces.state(load, separation, &sums)? };
        if self.branch.pull_off().is_some() && load == self.pull_off_load() {
            state.dforce_dload = f64::INFINITY;
            (state.dload_dgap, state.unloading_stiffness) = (0.0, 0.0);
        }
        Ok(state)
    }

    /// The separation at a load, in sigma, and the sums there.
    pub(super) fn equilibrium_at(&self, load: f64) -> Result<(f64, Sums), Error> {
        self.surfaces.equilibrium_at(load, || self.law.separation_of(load), 0.0)
    }

    /// The tangential force T at a load and a displacement along the surfaces, and dT/d(displacement), without the compiled
    /// law. The force is an odd function of the displacement, from a surface pair that bears none.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a displacement that is not finite, and as [`Model::state_at_load`], but no error at
    /// zero load.
    pub fn tangential_at_load(&self, load: f64, displacement: f64) -> Result<(f64, f64), Error> {
        if !finite(displacement) {
            return Err(Error::invalid("displacement", displacement, "must be finite"));
        }
        if load == 0.0 && self.branch.pull_off().is_none() {
            return Ok((0.0, 0.0));
        }
        let (separation, sums) = self.equilibrium_at(load)?;
        let stiffness = sums.spread_radius().0 * self.units.stiffness;
        let force = sums.friction * self.units.force;
        // 8 G^ delta a over G* b^2 and a/b; a contact is displaced by more than the mean planes are.
        let unit = self.units.stiffness / self.units.force / sums.psi();
        let force_over_radius = displacement.abs().min(LARGEST_DISPLACEMENT / unit) * unit;
        if force_over_radius < SMALLEST_DISPLACEMENT {
            return Ok((stiffness * displacement, stiffness));
        }
        let slipping = self.branch.microslip(separation, &sums, force_over_radius)?;
        if slipping.radius == 0.0 {
            return Ok((0.0, 0.0));
        }
        // Where the load is so light that the state is one of a heavier load, scaled down, this is scaled too.
        let part = sums.radius / slipping.radius;
        let tangential = (slipping.force * part * self.units.force).min(force);
        Ok((tangential.copysign(displacement), slipping.sticking / slipping.radius * stiffness))
    }

    /// The exact state at a gap between the mean planes, in contact or not, on the branch of load control or beyond it.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a gap that is not finite, [`Error::OutOfRange`].
    pub fn state_at_gap(&self, gap: f64) -> Result<State, Error> {
        let separation = self.separation_at(gap)?;
        let sums = self.branch.sums(separation);
        let load = sums.load() * self.units.load;
        Ok(State { gap: self.law.gap_at(separation), ..self.surfaces.state(load, separation, &sums)? })
    }

    /// The separation of the population, in sigma, at a gap.
    pub(super) fn separation_at(&self, gap: f64) -> Result<f64, Error> {
        self.in_sigma("gap", gap).map(|_| self.law.separation_at(gap))
    }
}

impl Surfaces {
    /// What the sums over the summits make of a load, in the caller's units.
    ///
    /// # Errors
    /// As [`Model::state_at_load`].
    pub(crate) fn borne_at_load(&self, load: f64) -> Result<Borne, Error> {
        Ok(self.borne(self.equilibrium_at(load, || None, 0.0)?))
    }

    /// The same, from the separation of surfaces like these under this load, to 1e-9 of the load.
    pub(crate) fn borne_near(&self, load: f64, guess: Option<f64>) -> Result<Borne, Error> {
        Ok(self.borne(self.equilibrium_at(load, || guess, BORNE)?))
    }

    fn borne(&self, (separation, sums): (f64, Sums)) -> Borne {
        let (spread_radius, _) = sums.spread_radius();
        let contact_radius_sum = spread_radius * self.params.burgers_vector * self.units.count;
        let normal_stiffness = self.normal_stiffness(&sums);
        Borne {
            separation,
            pressing: self.branch.pressing(separation),
            friction_force: sums.friction * self.units.force,
            real_area: sums.area * self.units.area,
            hertz_load: sums.hertz_load * self.units.load,
            tangential_stiffness: spread_radius * self.units.stiffness,
            normal_stiffness,
            contact_radius_sum,
            unloading_stiffness: self.unloading_stiffness(contact_radius_sum, normal_stiffness),
            contacting: sums.contacting * self.units.count,
        }
    }

    /// The separation at a load, in sigma, and the sums there, from a guess if there is one, to a part of the load.
    fn equilibrium_at(
        &self,
        load: f64,
        guess: impl FnOnce() -> Option<f64>,
        tolerance: f64,
    ) -> Result<(f64, Sums), Error> {
        self.validate_load(load)?;
        if load <= 0.0 {
            match self.branch.pull_off() {
                Some(point) if load == self.pull_off_load() => {
                    return Ok((point.separation, self.branch.sums(point.separation)));
                }
                None => {
                    let allowed = if self.params.work_of_adhesion > 0.0 { PULL_OFF_UNDERFLOWS } else { NO_ADHESION };
                    return Err(Error::out_of_range("load", load, allowed));
                }
                _ => {}
            }
        }
        // x = load - pull-off; both are the caller's numbers, their difference is exact where it is small.
        let log_excess = log(load - self.branch.least_load() * self.units.load) - log(self.units.load);
        // A guess may lead nowhere where the load hardly changes with separation.
        let at = |guess| self.branch.at_log_excess(log_excess, guess, tolerance);
        at(guess()).or_else(|_| at(None))
    }

    /// -d(load)/d(gap) on the branch of loading.
    fn normal_stiffness(&self, sums: &Sums) -> f64 {
        -sums.load_slope / sums.approach_of_planes() * self.units.load / self.units.length
    }

    /// -d(load)/d(gap) of unloading: 2 E* sum a/psi where summits have yielded; elastic contacts unload as they were loaded.
    pub(crate) fn unloading_stiffness(&self, contact_radius_sum: f64, normal_stiffness: f64) -> f64 {
        match self.groups.yields {
            true => 2.0 * self.params.composite_modulus * contact_radius_sum,
            false => normal_stiffness.max(0.0),
        }
    }

    /// The warnings of all states between two loads, both included.
    ///
    /// # Errors
    /// Those of [`Model::state_at_load`], and [`Error::InvalidParameter`] if `lightest` is above `heaviest`.
    pub fn check_loads(&self, lightest: f64, heaviest: f64) -> Result<u64, Error> {
        self.check_loads_near((lightest, None), (heaviest, None))
    }

    /// The same of loads with guesses of their separations.
    pub(crate) fn check_loads_near(
        &self,
        (lightest, far): (f64, Option<f64>),
        (heaviest, near): (f64, Option<f64>),
    ) -> Result<u64, Error> {
        let (farthest, light) =
            self.equilibrium_at(lightest, || far, BORNE).map_err(|error| error.of_load("lightest"))?;
        if lightest == heaviest {
            return Ok(self.measures_of(lightest, farthest, &light)?.warnings());
        }
        let (nearest, heavy) = self
            .equilibrium_at(heaviest, || near.or(Some(farthest)), BORNE)
            .map_err(|error| error.of_load("heaviest"))?;
        if lightest > heaviest {
            return Err(Error::invalid("lightest", lightest, "must not be above heaviest"));
        }
        let ends = self.measures_of(lightest, farthest, &light)?.warnings()
            | self.measures_of(heaviest, nearest, &heavy)?.warnings();
        let population = self.population();
        let has_one_hump = population.heights().outline().is_log_concave && population.radius_scale() >= 1.0;
        let is_smooth = self.params.waviness.height > 0.0 || has_one_hump;
        let step = NEAR_STEPS[usize::from(is_smooth)];
        Ok(ends | warnings_between((nearest, farthest), step, |d| self.measures_at(d))?)
    }

    /// How far what the model assumes fails under a load, at a separation in sigma, with these sums.
    fn measures_of(&self, load: f64, separation: f64, sums: &Sums) -> Result<Measures, Error> {
        sums.known(separation)?;
        // None looks at the largest contact; where the slope is known, none at more than the mean radius.
        let contacts = match self.params.rms_slope > 0.0 && sums.contacting > 0.0 {
            true => Statistics { mean_radius: sums.radius / sums.contacting, ..Statistics::default() },
            false => self.contacts(separation, sums, sums.contacting)?,
        };
        Ok(self.measures(&self.state_of(load, separation, sums, &contacts)))
    }

    fn measures_at(&self, separation: f64) -> Result<Measures, Error> {
        let sums = self.branch.sums(separation);
        self.measures_of(sums.load() * self.units.load, separation, &sums)
    }

    /// What neighbours add to the gap at a separation, in sigma: the integral of 1 - psi from there on, to some 1e-3 of it.
    pub(crate) fn widening(&self, separation: f64) -> f64 {
        // Beyond it hardly a summit touches.
        const FARTHEST: f64 = 8.0;
        if let Some(gap) = self.branch.gap(separation) {
            return gap - separation;
        }
        let of = |(at, weight): (f64, f64)| weight * self.branch.sums(at).given_way;
        match self.params.nominal_area > 0.0 {
            true => quadrature::nodes_of_part(0.0, separation, FARTHEST.max(separation + 2.0)).map(of).sum(),
            false => 0.0,
        }
    }

    /// The gap at a separation in sigma, with what neighbours add.
    pub(crate) fn gap_of(&self, separation: f64, widening: f64) -> f64 {
        let origin = self.branch.population().heights().outline().origin;
        (separation + widening + origin) * self.units.length + self.params.summit_mean_height
    }

    /// Minus gaps beyond this are out of range.
    pub(crate) fn deepest_compression(&self) -> f64 {
        (FARTHEST_SEPARATION * self.units.length).min(TAMEST)
    }

    /// A length in sigma.
    fn in_sigma(&self, name: &'static str, length: f64) -> Result<f64, Error> {
        self.validate_length(name, length).map(|()| length / self.units.length)
    }

    /// Whether a length is one, without arithmetic: a batch asks in the environment of its caller.
    pub(super) fn validate_length(&self, name: &'static str, length: f64) -> Result<(), Error> {
        if !finite(length) {
            return Err(Error::invalid(name, length, "must be finite"));
        }
        if length.abs() > self.deepest_compression() {
            return Err(Error::out_of_range(name, length, "must be within 1e50 height_std of zero"));
        }
        Ok(())
    }

    /// The slope by load of what has a slope by separation.
    fn slope(&self, separation: f64, by_separation: f64, sums: &Sums) -> f64 {
        if sums.load_slope == 0.0 {
            0.0
        } else if sums.load_slope > 0.0 && self.is_on_branch(separation) {
            // The sign is rounding so near to pull-off.
            f64::MAX
        } else {
            by_separation / self.units.load / sums.load_slope
        }
    }

    fn is_on_branch(&self, separation: f64) -> bool {
        separation <= self.branch.farthest()
    }

    fn state(&self, load: f64, separation: f64, sums: &Sums) -> Result<State, Error> {
        let contacts = self.contacts(separation, sums, sums.contacting * self.units.count)?;
        Ok(self.state_of(load, separation, sums, &contacts))
    }

    /// The contacts behind the sums, and the largest of so many.
    fn contacts(&self, separation: f64, sums: &Sums, number: f64) -> Result<Statistics, Error> {
        sums.known(separation)?;
        match number > 0.0 {
            true => self.branch.statistics(separation, sums, number),
            false => Ok(Statistics::default()),
        }
    }

    fn state_of(&self, load: f64, separation: f64, sums: &Sums, contacts: &Statistics) -> State {
        let units = &self.units;
        let friction_force = sums.friction * units.force;
        let dforce_dload = self.slope(separation, sums.friction_slope * units.force, sums);
        // Beyond pull-off no load is in equilibrium: a pulling one has no coefficient.
        let on_branch = self.is_on_branch(separation);
        let normal_stiffness = self.normal_stiffness(sums);
        let normal_stiffness = if on_branch { normal_stiffness.max(0.0) } else { normal_stiffness };
        let (coefficient, dmu_dload) = if on_branch || load > 0.0 {
            self.coefficient_and_slope(load, friction_force, dforce_dload)
        } else {
            (0.0, 0.0)
        };
        let [below, between, above] = contacts.by_regime;
        let mean_asperity_pressure =
            if sums.area > 0.0 { sums.load_contacting / sums.area * self.params.composite_modulus } else { 0.0 };
        let (spread_radius, _) = sums.spread_radius();
        let contact_radius_sum = spread_radius * self.params.burgers_vector * units.count;
        let mut state = State {
            load,
            gap: f64::NAN,
            friction_force,
            friction_coefficient: coefficient,
            dforce_dload,
            dmu_dload,
            dload_dgap: 0.0 - normal_stiffness,
            real_area: sums.area * units.area,
            contacting: sums.contacting * units.count,
            attracted: sums.attracted * units.count,
            attraction_load: sums.load_attracted * units.load,
            mean_contact_radius: contacts.mean_radius * self.params.burgers_vector,
            max_contact_radius: contacts.largest_radius * self.params.burgers_vector,
            fraction_below_slip_radius_1: below,
            fraction_between_slip_radii: between,
            fraction_above_slip_radius_2: above,
            fraction_in_contact: sums.contacting,
            mean_asperity_pressure,
            plasticity_index: self.plasticity_index(),
            mean_steepness: contacts.mean_steepness * self.params.burgers_vector / self.params.summit_radius,
            load_on_flats: contacts.on_flats,
            warnings: 0,
            tangential_stiffness: spread_radius * units.stiffness,
            fraction_elastic: contacts.elastic,
            fraction_flowing: contacts.flowing,
            contact_radius_sum,
            hertz_load: sums.hertz_load * units.load,
            unloading_stiffness: self.unloading_stiffness(contact_radius_sum, normal_stiffness),
        };
        state.warnings = self.measures(&state).warnings();
        state
    }

    /// How far what the model assumes fails in a state.
    fn measures(&self, state: &State) -> Measures {
        Measures::new(&self.params, state)
    }

    /// E* (sigma/R)^(1/2)/H; 0 where the hardness is not known.
    fn plasticity_index(&self) -> f64 {
        if self.params.hardness > 0.0 {
            self.params.composite_modulus / self.params.hardness * self.groups.alpha
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::HEAVIEST_LOAD;
    use crate::numerics::neighbours::Neighbours;
    use crate::params::Params;

    /// E* b^2 is 2.857, sigma 10.
    #[test]
    fn loads_and_separations_are_taken_up_to_the_limits_and_no_further() {
        let model = Model::new(&Params::paper()).expect("a model");
        let load = HEAVIEST_LOAD * model.units.load;
        let separation = FARTHEST_SEPARATION * model.units.length;
        for (outcome, refused) in [
            (model.state_at_load(load), false),
            (model.state_at_load(load.above()), true),
            (model.state_at_gap(separation), false),
            (model.state_at_gap(separation.above()), true),
            (model.state_at_gap(-separation), false),
            (model.state_at_gap((-separation).below()), true),
        ] {
            assert_eq!(matches!(outcome, Err(Error::OutOfRange { .. })), refused, "{outcome:?}");
        }
        assert!(model.friction_at_load(load).is_finite() && model.friction_force_at_load(load).is_finite());
        assert!(model.load_at_gap(-separation).is_finite() && model.load_at_gap((-separation).below()).is_nan());
    }

    /// There the slope of the load is rounding, of either sign.
    #[test]
    fn force_rises_without_limit_towards_pull_off_and_never_falls() {
        let model = Model::new(&Params::paper()).expect("a model");
        let pull_off = model.branch.farthest();
        for step in 0..300 {
            let separation = pull_off - f64::from(step * step) * f64::EPSILON;
            let state = model.state_at_gap(separation * model.units.length).expect("a state");
            assert!(state.dforce_dload > 1e5 && state.dload_dgap <= 0.0, "{step}: {}", state.dforce_dload);
        }
    }

    #[test]
    fn zero_load_without_a_state_says_whether_the_surfaces_adhere() {
        for (params, reason) in [
            (Params { work_of_adhesion: 0.0, ..Params::paper() }, "without adhesion"),
            (Params { height_std: 40.0 * Params::paper().height_std, ..Params::paper() }, "the surfaces adhere"),
        ] {
            let model = Model::new(&params).expect("a model");
            assert_eq!(model.summary().pull_off_load, 0.0);
            let error = model.state_at_load(0.0).expect_err("no state").to_string();
            assert!(error.starts_with(&format!("load = 0: {reason}")), "{error}");
        }
    }
}
