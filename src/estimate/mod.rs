//! Friction at loads from what little is known of a surface, as its text says, with the band that this leaves.
//!
//! What is not known is taken as log-normal: the strength of the interface, and the height and slope of a surface of which only the
//! process is known. A model is made for each of a few roughnesses (`cases`), at most five; friction is linear in the strength, so
//! that no more are needed. Measured points narrow the strength in each case, and change the probabilities of the cases, by Bayes'
//! rule (`strength`). `known` has what is usual as data, `words` writes an estimate for people.

mod cases;
pub mod known;
mod normal;
mod strength;
mod words;

use crate::by_name::{describe, of_points, Case, Described};
use crate::error::{Error, LOAD};
use crate::model::calibration::Calibrated;
use crate::model::points::{slice, slices, Seen, Slice};
use crate::model::validity::WARNING_FEW;
use crate::model::Model;
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::params::Params;
pub use strength::Rests;
use strength::Strength;
pub use words::write;

/// An answer for one load.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    /// [N]
    pub load: f64,
    /// F/P: infinite from the pull-off load to 0, 0 below.
    pub friction_coefficient: f64,
    /// Ends of the band.
    pub low: f64,
    pub high: f64,
    /// F [N].
    pub friction_force: f64,
    /// Summits in contact that the model expects, and whether they are too few for one specimen to be like the mean of the model. NaN
    /// where loads are pressures.
    pub contacts: f64,
    pub is_few: bool,
    /// Mean friction force of single specimens [N]. Of less than one contact that of a summit alone, which simulated specimens have once
    /// or twice (python/tests/test_pads.py). NaN where it is not known.
    pub specimen_force: f64,
    /// Standard deviation of the friction force of single specimens over its mean; NaN where it is not known.
    pub specimen_scatter: f64,
    /// Shares of the variance of ln(F/P) that follow from the strength of the interface, the roughness and the measurement.
    pub strength_share: f64,
    pub roughness_share: f64,
    pub measurement_share: f64,
}

/// All that a text tells of friction.
pub struct Estimate {
    described: Described,
    strength: Strength,
    cases: Vec<Likely>,
    /// The middle case with a pressure coefficient of 1, where the load does not say what that makes.
    pressed: Option<Model>,
    /// With the strength that the estimate has.
    params: Params,
    /// Standard deviations to either end of a band.
    reach: f64,
    /// Whether the points set the pressure coefficient.
    tells_pressure: bool,
    /// By how much the points are off the curve, in their errors.
    pub misfit: f64,
}

/// One of the surfaces that may be.
struct Likely {
    model: Model,
    /// What is left open of the strength, with probabilities.
    slices: Vec<(f64, Slice)>,
    probability: f64,
}

impl Estimate {
    /// Reads a text and makes the models of its cases, for these loads.
    ///
    /// # Errors
    /// Those of the text, with line and key, and those of models.
    pub fn new(bytes: &[u8], loads: &[f64]) -> Result<Self, Error> {
        Self::of(bytes, loads, Case::MIDDLE)
    }

    /// The same of another most probable surface. Of one of another hardness it is the only one.
    fn of(bytes: &[u8], loads: &[f64], at: Case) -> Result<Self, Error> {
        let described = describe(bytes, at)?;
        let machined = described.machined.as_ref().filter(|_| at.hardness.is_none());
        let reach = normal::reach(described.coverage);
        if described.params.slip.stress_1 == 0.0 && described.params.slip.stress_2 == 0.0 {
            let says = "slip_stress_1: must be > 0 for an estimate: without slip stresses F/P is pressure_coefficient";
            return Err(Error::Meaningless(says.into()));
        }
        let rests = Rests::of(&described);
        let strength = Strength::new(rests.clone(), &described);
        let prepare = |params: Params| -> Result<Params, Error> {
            let mut params = described.with_law(params)?;
            rests.set(&mut params)?;
            Ok(params)
        };
        let mut params = prepare(described.params.clone())?;
        let points = described.points.iter().map(|point| point.load);
        let range = range(loads.iter().copied().chain(points).chain(strength.loads()), params.work_of_adhesion > 0.0);
        let of_pressure = |params: &Params, pressure_coefficient: f64| {
            Model::between(&Params { pressure_coefficient, ..params.clone() }, range)
        };
        let without_pressure = |params: &Params| of_pressure(params, 0.0);
        let middle = without_pressure(&params)?;
        let given = params.pressure_coefficient;
        let calibrated = match described.points.is_empty() {
            true => {
                strength.take(&mut params, &middle)?;
                Calibrated { seen: Vec::new(), misfit: 0.0, tells_pressure: false }
            }
            false => params
                .calibrate_points(&described.points, described.pressure_is_free, Some(&middle))
                .map_err(|error| of_points(bytes, error))?,
        };
        let Calibrated { mut seen, misfit, tells_pressure } = calibrated;
        // A trend that the law cannot follow is not within the errors that were given.
        seen.iter_mut().for_each(|one| one.error *= misfit.max(1.0));
        let mut found = Vec::new();
        for (at, probability) in cases::of(machined) {
            let model = match found.is_empty() {
                true => middle.clone(),
                false => without_pressure(&prepare(describe(bytes, at)?.params)?)?,
            };
            let prior = strength.prior(&model)?;
            let mut here = Vec::with_capacity(seen.len());
            for (one, point) in seen.iter().zip(&described.points) {
                let force = model.friction_force_at_load(point.load);
                if !finite(force) || force <= 0.0 {
                    return Err(of_points(bytes, Model::not_evaluated(point.load)));
                }
                here.push(Seen { force, ..*one });
            }
            let of_case = match (here.is_empty(), tells_pressure) {
                (true, _) => {
                    vec![Slice { kappa: given, mean: prior.mean, variance: strength.variance(), log_weight: 0.0 }]
                }
                (false, false) => vec![slice(&here, prior, given)],
                (false, true) => slices(&here, prior),
            };
            found.push((model, of_case, probability));
        }
        let pressing = params.pressure_coefficient > 0.0 || tells_pressure;
        let pressed = match pressing && params.work_of_adhesion > 0.0 {
            true => Some(of_pressure(middle.params(), 1.0)?),
            false => None,
        };
        let cases = weighted(found);
        Ok(Self { described, strength, cases, pressed, params, reach, tells_pressure, misfit })
    }

    /// Friction at a load.
    ///
    /// # Errors
    /// [`Error::InvalidLoad`] of one that is not finite, [`Error::OutOfRange`] of one that is too heavy or too light.
    pub fn at_load(&self, load: f64) -> Result<Answer, Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: LOAD, value: load });
        }
        let middle = &self.cases[0].model;
        let (force, pressed) = (self.positive(middle, load)?, self.pressed(load)?);
        let by_pressure = self.params.pressure_coefficient * pressed;
        let friction_force = self.factor() * force + by_pressure;
        let mut answer = Answer {
            load,
            friction_coefficient: friction_force / load,
            friction_force,
            contacts: f64::NAN,
            specimen_force: f64::NAN,
            specimen_scatter: f64::NAN,
            ..Answer::default()
        };
        let is_apart = load <= 0.0 && middle.validate_load(load).is_err();
        if is_apart {
            answer.contacts = 0.0;
        } else if load <= 0.0 && middle.params().work_of_adhesion == 0.0 {
            (answer.contacts, answer.specimen_force) = (0.0, 0.0);
        } else {
            self.add_specimens(&mut answer, by_pressure)?;
        }
        if self.is_of_pressures() {
            (answer.contacts, answer.specimen_force, answer.specimen_scatter) = (f64::NAN, f64::NAN, f64::NAN);
        }
        if load <= 0.0 {
            // What holds the surfaces together gives friction without a load; the ratio has no bound as the load goes to 0.
            answer.friction_coefficient = if is_apart { 0.0 } else { f64::INFINITY };
            (answer.low, answer.high) = (answer.friction_coefficient, answer.friction_coefficient);
            return Ok(answer);
        }
        self.add_band(&mut answer, pressed)?;
        Ok(answer)
    }

    /// What one specimen has, whose summits are not the mean of all.
    fn add_specimens(&self, answer: &mut Answer, by_pressure: f64) -> Result<(), Error> {
        let middle = &self.cases[0].model;
        let state = match middle.state_at_load(answer.load) {
            // No number is small enough for what the mean of so rough surfaces has without a load.
            Err(_) if answer.load == 0.0 => None,
            state => Some(state?),
        };
        answer.contacts = state.map_or(0.0, |state| state.contacting);
        answer.is_few = state.is_none_or(|state| state.warnings & WARNING_FEW != 0);
        if self.params.is_of_many() && answer.contacts < 1.0 && answer.load >= 0.0 {
            answer.specimen_force = self.factor() * middle.one_summit_at_load(answer.load) + by_pressure;
        } else if let Some(state) = state {
            let scattering = answer.friction_force - by_pressure;
            answer.specimen_force = answer.friction_force + state.friction_bias * scattering;
            answer.specimen_scatter = state.friction_scatter * scattering / answer.friction_force;
        }
        Ok(())
    }

    fn add_band(&self, answer: &mut Answer, pressed: f64) -> Result<(), Error> {
        let load = answer.load;
        let (mut mean, mut square) = (0.0, 0.0);
        let (mut by_strength, mut within, mut between) = (0.0, 0.0, 0.0);
        let mut means = Vec::with_capacity(self.cases.len());
        let base = log(answer.friction_coefficient);
        for case in &self.cases {
            let force = self.positive(&case.model, load)?;
            let mut of_case = 0.0;
            for &(weight, Slice { kappa, mean: log_c, variance, .. }) in &case.slices {
                let part = exp(log_c) * force;
                let whole = part + kappa * pressed;
                let slope = part / whole;
                let off = log(whole / load) - base;
                of_case += weight * off;
                square += case.probability * weight * off * off;
                within += case.probability * weight * slope * slope * variance;
                by_strength += case.probability * weight * slope * slope * variance * self.strength.share(variance);
            }
            mean += case.probability * of_case;
            means.push(of_case);
        }
        for (case, of_case) in self.cases.iter().zip(means) {
            between += case.probability * (of_case - mean) * (of_case - mean);
        }
        let variance = within + (square - mean * mean).max(between);
        let reach = self.reach * variance.sqrt();
        (answer.low, answer.high) = (exp(base + mean - reach), exp(base + mean + reach));
        if variance > 0.0 {
            answer.strength_share = by_strength / variance;
            answer.roughness_share = between / variance;
            answer.measurement_share = (1.0 - answer.strength_share - answer.roughness_share).max(0.0);
        } else {
            (answer.low, answer.high) = (answer.friction_coefficient, answer.friction_coefficient);
        }
        Ok(())
    }

    /// The friction coefficient at a load if the bodies were harder or softer; None if that is refused.
    fn with_hardness(bytes: &[u8], load: f64, hardness: f64) -> Option<f64> {
        let at = Case { hardness: Some(hardness), ..Case::MIDDLE };
        Some(Self::of(bytes, &[load], at).ok()?.at_load(load).ok()?.friction_coefficient)
    }

    /// The strength that is estimated, over that of the models.
    fn factor(&self) -> f64 {
        self.params.slip.stress_1 / self.cases[0].model.params().slip.stress_1
    }

    /// Whether the text has no nominal area, so that loads are nominal pressures [Pa] and forces shear stresses.
    pub fn is_of_pressures(&self) -> bool {
        self.described.is_of_pressures
    }

    /// The summits in contact at a load, where they are too few for one specimen to be like the mean of the model.
    fn few_contacts_at(&self, load: f64) -> Option<f64> {
        let state = self.cases[0].model.state_at_load(load).ok()?;
        (state.warnings & WARNING_FEW != 0 && !self.is_of_pressures()).then_some(state.contacting)
    }

    /// The unit of loads and of forces.
    fn unit(&self) -> &'static str {
        match self.is_of_pressures() {
            true => "Pa",
            false => "N",
        }
    }

    /// The surfaces as they are taken: the most probable roughness, its contact law and the strength of the interface.
    pub fn params(&self) -> &Params {
        &self.params
    }

    /// Bits of what the model assumes and a state between these loads lacks: of those that press.
    ///
    /// # Errors
    /// Those of [`Model::check_loads`].
    pub fn warnings(&self, loads: &[f64]) -> Result<u64, Error> {
        let pressing = || loads.iter().copied().filter(|&load| load > 0.0);
        match (pressing().reduce(f64::min), pressing().reduce(f64::max)) {
            (Some(lightest), Some(heaviest)) => {
                let middle = &self.cases[0].model;
                middle.check_loads_with(&self.params, lightest, heaviest)
            }
            _ => Ok(0),
        }
    }

    /// What the strength rests on.
    pub fn rests(&self) -> &Rests {
        &self.strength.rests
    }

    /// Whether friction was measured on these surfaces.
    pub fn is_measured(&self) -> bool {
        self.strength.is_measured
    }

    /// The load of Hertz' contacts, which a pressure coefficient takes its part of.
    fn pressed(&self, load: f64) -> Result<f64, Error> {
        match &self.pressed {
            None => Ok(load.max(0.0)),
            Some(pressed) => {
                let middle = &self.cases[0].model;
                Ok((self.positive(pressed, load)? - self.positive(middle, load)?).max(0.0))
            }
        }
    }

    /// Friction force of a case, which must be a number > 0 where the load presses.
    fn positive(&self, model: &Model, load: f64) -> Result<f64, Error> {
        let force = model.friction_force_at_load(load);
        if !finite(force) || (force <= 0.0 && load > 0.0) {
            model.validate_load(load)?;
            return Err(Error::out_of_range(
                LOAD,
                load,
                "must be heavier: the friction force is too small for a number",
            ));
        }
        Ok(force)
    }
}

/// Gives each case and slice its probability, of the weights of slices and the probabilities before.
fn weighted(found: Vec<(Model, Vec<Slice>, f64)>) -> Vec<Likely> {
    let weights = || found.iter().flat_map(|(_, slices, _)| slices).map(|slice| slice.log_weight);
    let largest = weights().fold(f64::NEG_INFINITY, f64::max);
    let of = |slices: &[Slice]| slices.iter().map(|slice| exp(slice.log_weight - largest)).sum::<f64>();
    // Slices of different cases are differently far apart.
    let apart = |slices: &[Slice]| slices.get(1).map_or(1.0, |second| second.kappa - slices[0].kappa);
    let total: f64 = found.iter().map(|(_, slices, probability)| probability * of(slices) * apart(slices)).sum();
    found
        .into_iter()
        .map(|(model, slices, probability)| {
            let sum = of(&slices);
            let probability = probability * sum * apart(&slices) / total;
            let slices = slices.into_iter().map(|slice| (exp(slice.log_weight - largest) / sum, slice)).collect();
            Likely { model, slices, probability }
        })
        .collect()
}

/// The lightest and the heaviest of loads that press, and of those that adhesion bears.
fn range(loads: impl Iterator<Item = f64>, adheres: bool) -> [f64; 2] {
    let [mut lightest, mut heaviest] = [f64::INFINITY, f64::MIN_POSITIVE];
    for load in loads.filter(|&load| finite(load) && (load > 0.0 || adheres)) {
        (lightest, heaviest) = (lightest.min(load), heaviest.max(load));
    }
    [lightest.min(heaviest), heaviest]
}

#[cfg(test)]
mod tests;
