//! The surfaces that may be, and what they bear at a load, as a mean or as single specimens, without a compiled law.

use super::known::deviation;
use super::posterior::INPUTS;
use super::priors::{yields, HARDNESS, MEASURED_SLOPE, SLOPE, WORK, YOUNG};
use crate::by_name::{Described, Machined};
use crate::error::{Error, LOAD};
use crate::model::{Borne, Model, Surfaces};
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::params::{ContactLawKind, Params};
use crate::specimens::{Heights, Kept, Specimens, Standing};
use std::cell::{OnceCell, RefCell};
use std::rc::Rc;

/// Where inputs stand among those that are normal.
const SLOPE_INPUT: usize = 0;
const HEIGHT_INPUT: usize = 1;
pub const HARDNESS_INPUT: usize = 2;
pub const YOUNG_INPUT: usize = 3;
/// The slope and the height of the surface that was measured, where it is another.
const THERE: usize = 4;
/// Besides, of which nothing is changed here, the strength.
pub const STRENGTH_INPUT: usize = 6;
/// And how far the area of the law is off, where that of a measured surface is not as far off.
pub const AREA_INPUT: usize = 7;
/// All of the roughness.
pub const SLOPES: [usize; 4] = [SLOPE_INPUT, HEIGHT_INPUT, THERE + SLOPE_INPUT, THERE + HEIGHT_INPUT];

/// What surfaces bear at a load, with a shear strength of 1.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// Logarithms of `FILM`, `SLIP`, `HERTZ` and `STIFFNESS`.
    pub logs: [f64; 7],
    /// The gap itself, without what neighbours add.
    pub gap: f64,
    /// How many summits touch.
    pub contacts: f64,
    /// How hard a specimen can be pulled; NaN of what is none.
    pub pull: f64,
}

/// The friction force of a film, whose strength does not depend on the size of a contact, and with the whole size effect; both the same
/// where that is given.
const FILM: usize = 0;
const SLIP: usize = 1;
/// The load of Hertz' contacts, which a pressure coefficient takes its part of.
pub const HERTZ: usize = 2;
/// From here on tangential and normal stiffness, the sum of the contact radii, and the normal stiffness of unloading.
pub const STIFFNESS: usize = 3;

/// One work of adhesion, with its probability among the others.
#[derive(Debug, Clone, Copy)]
pub struct Work {
    pub probability: f64,
    pub work: f64,
    /// Between which of the models it is, and the part of the second.
    models: [usize; 2],
    part: f64,
}

impl Work {
    /// That of the first model.
    fn alone(work: f64, probability: f64) -> Self {
        Self { probability, work, models: [0; 2], part: 0.0 }
    }
}

/// Surfaces of one contact law.
#[derive(Debug)]
pub struct Law {
    pub probability: f64,
    pub works: Vec<Work>,
    /// For each work of adhesion that a model is made for, the surfaces as they most probably are; the middle one is compared with others.
    models: Vec<Surfaces>,
    middle: usize,
    /// What changed ones are compared with, where these stand on waves: the same without.
    even: Option<Surfaces>,
    /// The same with an input one standard deviation off, and the sign of that.
    changed: Changed<Surfaces>,
    /// How many specimens are drawn, those of each model and of each that is changed, and with how many contacts they are alike.
    specimens: usize,
    drawn: RefCell<Vec<Kept>>,
    pub alike: f64,
    /// The deviation of ln of their area from that of what was measured.
    pub area: f64,
    /// What they are drawn from.
    heights: Rc<OnceCell<Heights>>,
}

/// Of each input that is not known, what it is with that one standard deviation off, and the sign of that.
type Changed<T> = [Option<(T, f64)>; INPUTS];

/// What one law makes of a load.
#[derive(Debug, Clone)]
pub struct OfLaw {
    /// Of all surfaces on the mean, those first that most probably are.
    pub separations: Vec<f64>,
    /// As of the law.
    pub area: f64,
    /// The mean of the model, or where few summits touch that of the specimens.
    models: Vec<Terms>,
    middle: usize,
    /// What the changed ones are compared with.
    unchanged: Terms,
    changed: Changed<Terms>,
    /// Single specimens of each model, none where many summits touch.
    specimens: Vec<Vec<Terms>>,
}

/// Specimens that stand for all, more where one was measured; where much else is not known fewer do; and those that tell what an input
/// changes. Fibonacci's numbers make the best lattices of pairs.
const SPECIMENS: [usize; 2] = [144, 233];
const FEWER_SPECIMENS: usize = 34;
const COMPARED: usize = 16;
/// With fewer contacts specimens are drawn; with more, those of so many come nearer to the mean, and are it from `Law::alike` on: later
/// where one was measured.
const DRAWN: f64 = 20.0;
const ALIKE: [f64; 2] = [64.0, 256.0];
/// Summits that may be drawn for all specimens.
const MOST_DRAWN: f64 = 4e4;
/// The logarithm of nothing.
pub const NOTHING: f64 = -690.0;

impl Terms {
    /// From a separation near which surfaces are.
    fn at(surfaces: &Surfaces, load: f64, is_film: bool, near: Option<f64>) -> Result<(Self, Borne), Error> {
        let borne = surfaces.borne_near(load, near)?;
        let slip = log(borne.friction_force) - log(unit_strength(surfaces));
        let film = if is_film { log(borne.real_area) } else { slip };
        let more = [
            borne.hertz_load,
            borne.tangential_stiffness,
            borne.normal_stiffness,
            borne.contact_radius_sum,
            borne.unloading_stiffness,
        ];
        let [hertz, tangential, normal, radii, unloading] = more.map(log);
        let gap = surfaces.gap_of(borne.separation, 0.0);
        let logs = [film, slip, hertz, tangential, normal, radii, unloading];
        let found = Self { logs, gap, contacts: borne.contacting, pull: f64::NAN };
        match finite(film) && finite(slip) && finite(hertz) {
            true => Ok((found, borne)),
            false if load > 0.0 => {
                Err(Error::out_of_range(LOAD, load, "must be heavier: the friction force is too small for a number"))
            }
            false => Err(Model::not_evaluated(load)),
        }
    }

    /// A specimen; one that is apart has nothing.
    fn of(standing: Option<Standing>, pull: f64, surfaces: &Surfaces, is_film: bool) -> Self {
        let Some(standing) = standing else {
            return Self { logs: [NOTHING; 7], gap: f64::NAN, contacts: 0.0, pull };
        };
        let held = standing.held(surfaces.units(), surfaces.gap_of(standing.separation, 0.0), 0.0);
        let [area, hertz] = standing.area_and_hertz(surfaces.units());
        let slip = held.friction_force / unit_strength(surfaces);
        let radii = standing.contacts.radius / standing.sums.psi() * surfaces.params().burgers_vector;
        let unloading = surfaces.unloading_stiffness(radii, held.normal_stiffness);
        let film = if is_film { area } else { slip };
        let all = [film, slip, hertz, held.tangential_stiffness, held.normal_stiffness, radii, unloading];
        let logs = all.map(|number| if number > 0.0 { log(number).max(NOTHING) } else { NOTHING });
        Self { logs, gap: held.gap, contacts: held.contacts, pull }
    }

    fn mix(&self, other: &Self, part: f64) -> Self {
        self.each(other, |one, other| one + part * (other - one))
    }

    /// What a function makes of the quantities of both.
    fn each(&self, other: &Self, of: impl Fn(f64, f64) -> f64) -> Self {
        let logs = std::array::from_fn(|i| of(self.logs[i], other.logs[i]));
        let [gap, contacts] = [of(self.gap, other.gap), of(self.contacts, other.contacts)];
        Self { logs, gap, contacts, pull: of(self.pull, other.pull) }
    }

    /// The mean of specimens, of what it is the logarithm of.
    fn mean(all: &[Self]) -> Self {
        let mean = |of: &dyn Fn(&Self) -> f64| all.iter().map(of).sum::<f64>() / all.len() as f64;
        let holding = all.iter().filter(|one| !one.gap.is_nan());
        Self {
            logs: std::array::from_fn(|i| log(mean(&|one| exp(one.logs[i])))),
            gap: holding.clone().map(|one| one.gap).sum::<f64>() / holding.count() as f64,
            contacts: mean(&|one| one.contacts),
            pull: f64::NAN,
        }
    }

    pub fn force(&self, size: f64) -> f64 {
        self.logs[FILM] + size * (self.logs[SLIP] - self.logs[FILM])
    }
}

impl OfLaw {
    pub fn terms(&self, work: &Work) -> Terms {
        let [one, other] = work.models.map(|model| &self.models[model]);
        one.mix(other, work.part)
    }

    /// Single specimens with a work of adhesion; none where many summits touch.
    pub fn specimens<'a>(&'a self, work: &'a Work) -> impl ExactSizeIterator<Item = Terms> + 'a {
        let of = |model: usize| self.specimens.get(work.models[model]).map_or(&[][..], |all| &all[..]);
        of(0).iter().zip(of(1)).map(|(one, other)| one.mix(other, work.part))
    }

    /// Of the surfaces as they most probably are, on the mean.
    pub fn separation(&self) -> Option<f64> {
        self.separations.first().copied()
    }

    pub fn has_specimens(&self) -> bool {
        !self.specimens.is_empty()
    }

    /// The mean of what they can be pulled with, as the surfaces most probably are.
    pub fn mean_pull(&self) -> f64 {
        let of = |all: &Vec<Terms>| all.iter().map(|one| one.pull).sum::<f64>() / all.len() as f64;
        self.specimens.get(self.middle).map_or(0.0, of)
    }

    /// What a quantity changes by with each input.
    pub fn gains(&self, of: &dyn Fn(&Terms) -> f64) -> [f64; INPUTS] {
        let middle = of(&self.unchanged);
        // Where specimens are apart with an input changed, or without, there is no telling.
        let gain = |(terms, sign): &(Terms, f64)| sign * (of(terms) - middle);
        let known = |gain: &f64| gain.abs() < 0.1 * NOTHING.abs();
        self.changed.each_ref().map(|changed| changed.as_ref().map(gain).filter(known).unwrap_or(0.0))
    }
}

/// The shear strength of surfaces.
fn unit_strength(surfaces: &Surfaces) -> f64 {
    let params = surfaces.params();
    params.slip.stress_1.max(params.slip.stress_2) * params.effective_shear_modulus
}

impl Law {
    /// Surfaces of which nothing is in doubt.
    pub fn alone(surfaces: &Surfaces, of: &Self) -> Self {
        let works = vec![Work::alone(surfaces.params().work_of_adhesion, 1.0)];
        let (models, changed, heights) = (vec![surfaces.clone()], [const { None }; INPUTS], Rc::clone(&of.heights));
        let drawn = RefCell::default();
        Self { probability: 1.0, works, models, middle: 0, even: None, changed, heights, drawn, ..*of }
    }

    /// A load at which many summits touch, and the friction force of the mean there, of the strength with which specimens have a force
    /// at a load, on the mean.
    pub fn calibrated(&self, params: &Params, specimens: &Terms, load: f64, force: f64) -> Result<(f64, f64), Error> {
        let (surfaces, kappa) = (self.middle(), params.pressure_coefficient);
        let factor =
            (force - kappa * exp(specimens.logs[HERTZ])) / (exp(specimens.logs[SLIP]) * unit_strength(surfaces));
        let contacts = surfaces.borne_at_load(load).map_or(0.0, |borne| borne.contacting).max(1e-9);
        let many = load * (DRAWN / contacts).max(1.0);
        let borne = surfaces.borne_at_load(many)?;
        Ok((many, factor * borne.friction_force + kappa * borne.hertz_load))
    }

    /// The surfaces as they most probably are.
    pub fn middle(&self) -> &Surfaces {
        &self.models[self.middle]
    }

    /// One of its surfaces, where they differ from those of parameters by the strength alone.
    pub fn like(&self, params: &Params) -> Option<Surfaces> {
        let is_like = Params { slip: params.slip, ..self.middle().params().clone() } == *params;
        is_like.then(|| self.middle().summed(false).with_strength_of(params))
    }

    /// What the surfaces bear at a load, from separations at another: where few summits touch, single specimens, if they are not
    /// to be of many.
    pub fn at(&self, load: f64, is_of_many: bool, is_film: bool, near: &[f64]) -> Result<OfLaw, Error> {
        let middle = Terms::at(self.middle(), load, is_film, near.first().copied());
        let contacts = middle.as_ref().map_or(0.0, |(terms, _)| terms.contacts);
        let separations = middle.as_ref().map_or(Vec::new(), |(_, borne)| vec![borne.separation]);
        // Beyond pull-off there are specimens, but not beyond the heaviest load of the mean.
        let is_beyond = middle.is_err() && load > 0.0;
        let mean = || self.mean_at(load, is_film, middle, near);
        if is_of_many || is_beyond || contacts >= self.alike || self.middle().params().asperity_count <= 1.0 {
            return mean();
        }
        let drawn = self.drawn_at(if contacts > DRAWN { load * DRAWN / contacts } else { load }, is_film);
        if contacts <= DRAWN {
            return drawn.map(|drawn| OfLaw { separations, ..drawn }).or_else(|_| mean());
        }
        let mean_there = mean()?;
        // As many more summits touch, specimens are nearer to the mean.
        let there = load * DRAWN / contacts;
        let left = log(self.alike / contacts) / log(self.alike / DRAWN);
        let part = (DRAWN / contacts).sqrt() * left * left * (3.0 - 2.0 * left);
        let to = Terms::at(self.middle(), there, is_film, separations.first().copied());
        let to = self.mean_at(there, is_film, to, &mean_there.separations);
        let Ok((of, to)) = drawn.and_then(|of| Ok((of, to?))) else { return Ok(mean_there) };
        let mut found = mean_there.clone();
        for (k, at) in found.models.iter_mut().enumerate() {
            let nearer = |mean: &Terms, one: &Terms| Terms {
                pull: one.pull,
                ..mean.each(&one.each(&to.models[k], |a, b| a - b), |a, b| a + part * b)
            };
            found.specimens.push(of.specimens[k].iter().map(|one| nearer(at, one)).collect());
            *at = nearer(at, &of.models[k]);
        }
        Ok(found)
    }

    /// What the mean of the model bears at a load, where the surfaces as they most probably are bear this.
    fn mean_at(
        &self,
        load: f64,
        is_film: bool,
        middle: Result<(Terms, Borne), Error>,
        near: &[f64],
    ) -> Result<OfLaw, Error> {
        let (middle, Borne { separation, pressing, .. }) = middle?;
        let mut separations = vec![separation];
        let mut at = |surfaces: &Surfaces, load: f64| {
            // As far from the first as at the other load.
            let guess = match (near.get(separations.len()), separations.first()) {
                (Some(near_it), Some(first)) => Some(first + near_it - near[0]),
                (near_it, _) => near_it.or(separations.last()).copied(),
            };
            let (terms, borne) = Terms::at(surfaces, load, is_film, guess)?;
            separations.push(borne.separation);
            Ok::<_, Error>(terms)
        };
        let mut others = |(k, surfaces)| if k == self.middle { Ok(middle) } else { at(surfaces, load) };
        let models = self.models.iter().enumerate().map(&mut others).collect::<Result<Vec<_>, _>>()?;
        // Surfaces without waves are like those on them where these press.
        let there = load * pressing;
        let unchanged = self.even.as_ref().map_or(Ok(middle), |even| at(even, there))?;
        let changed = self.changed_by(|surfaces| at(surfaces, there))?;
        let (area, middle) = (self.area, self.middle);
        Ok(OfLaw { separations, area, models, middle, unchanged, changed, specimens: Vec::new() })
    }

    /// What is made of the surfaces that are changed.
    fn changed_by(&self, mut of: impl FnMut(&Surfaces) -> Result<Terms, Error>) -> Result<Changed<Terms>, Error> {
        let mut changed = [None; INPUTS];
        for (found, other) in changed.iter_mut().zip(&self.changed) {
            *found = other.as_ref().map(|(surfaces, sign)| of(surfaces).map(|terms| (terms, *sign))).transpose()?;
        }
        Ok(changed)
    }

    /// Single specimens at a load.
    fn drawn_at(&self, load: f64, is_film: bool) -> Result<OfLaw, Error> {
        let heights = self.heights.get_or_init(|| Heights::of(self.middle()));
        let mut drawn = self.drawn.borrow_mut();
        let mut kept = 0;
        let mut draw = |surfaces: &Surfaces, count: usize| {
            if kept == drawn.len() {
                drawn.push(Kept::new(count, DRAWN));
            }
            let mut found = Vec::with_capacity(count);
            let asked = Specimens { count, seed: 1, ..Specimens::default() };
            kept += 1;
            surfaces.stand(
                (asked, MOST_DRAWN),
                heights,
                &[load],
                Some(&mut drawn[kept - 1]),
                &mut |standing, pull| {
                    found.push(Terms::of(standing, pull, surfaces, is_film));
                },
            )?;
            Ok::<_, Error>(found)
        };
        let all = self.models.iter().map(|surfaces| draw(surfaces, self.specimens));
        let specimens = all.collect::<Result<Vec<_>, _>>()?;
        let changed = self.changed_by(|surfaces| draw(surfaces, COMPARED).map(|all| Terms::mean(&all)))?;
        let unchanged = Terms::mean(&specimens[self.middle][..COMPARED]);
        let models = specimens.iter().map(|all| Terms::mean(all)).collect();
        let (area, middle) = (self.area, self.middle);
        Ok(OfLaw { separations: Vec::new(), area, models, middle, unchanged, changed, specimens })
    }
}

/// An input that is not known exactly: its standard deviation, and what it changes of parameters.
struct Input {
    at: usize,
    deviation: f64,
    change: fn(&mut Params, f64),
}

fn change_slope(params: &mut Params, factor: f64) {
    let square = factor * factor;
    params.summit_radius /= square;
    params.asperity_count *= square;
    params.rms_slope *= factor;
}

/// Of a profile whose slope goes with the root of its height, as it is taken of machined surfaces.
fn change_height(params: &mut Params, factor: f64) {
    params.height_std *= factor;
    params.summit_mean_height *= factor;
    params.asperity_count /= factor;
    params.rms_slope *= factor.sqrt();
}

/// Of a profile whose width was measured.
fn change_height_of_width(params: &mut Params, factor: f64) {
    params.height_std *= factor;
    params.summit_mean_height *= factor;
    params.summit_radius /= factor;
    params.rms_slope *= factor;
}

fn change_modulus(params: &mut Params, factor: f64) {
    params.composite_modulus *= factor;
    params.effective_shear_modulus *= factor;
    params.tangential_modulus *= factor;
}

/// To what factor the slope is known.
pub fn slope_factor(described: &Described, machined: Option<&Machined>) -> f64 {
    let is_assumed = machined.is_some_and(|machined| !machined.has_slope);
    described.known_to.slope.unwrap_or(if is_assumed { SLOPE } else { MEASURED_SLOPE })
}

/// To what factor the hardness is known.
pub fn hardness_factor(described: &Described) -> f64 {
    let is_known = described.has_hardness || described.bodies.is_none();
    described.known_to.hardness.unwrap_or(if is_known { 1.0 } else { HARDNESS })
}

/// To what factor the work of adhesion is known, where none is as probable.
pub fn work_factor(described: &Described) -> f64 {
    described.known_to.work.unwrap_or(if described.has_adhesion || described.bodies.is_none() { 1.0 } else { WORK })
}

/// What is not known of surfaces under a law, of which the roughness is that of `machined`.
fn inputs(described: &Described, params: &Params, machined: Option<&Machined>, at: usize) -> Vec<Input> {
    let mut found = Vec::new();
    let mut add = |at: usize, factor: f64, change: fn(&mut Params, f64)| {
        if factor > 1.0 {
            found.push(Input { at, deviation: deviation(factor), change });
        }
    };
    if params.is_of_many() {
        add(at + SLOPE_INPUT, slope_factor(described, machined), change_slope);
        if let Some(machined) = machined.filter(|machined| !machined.has_height) {
            let change = if machined.has_slope { change_height_of_width } else { change_height };
            add(at + HEIGHT_INPUT, machined.process.middle_and_factor().1, change);
        }
    }
    if params.contact_law == ContactLawKind::ElasticPlastic {
        add(HARDNESS_INPUT, hardness_factor(described), |params, factor| params.hardness *= factor);
    }
    add(YOUNG_INPUT, described.known_to.young.unwrap_or(YOUNG), change_modulus);
    found
}

/// The laws that surfaces may have, with their works of adhesion.
///
/// # Errors
/// Those of parameters.
pub fn laws(described: &Described, measured_there: bool) -> Result<Vec<Law>, Error> {
    let (params, machined) = match &described.measured_on {
        Some(there) if measured_there => (&there.params, there.machined.as_ref()),
        _ => (&described.params, described.machined.as_ref()),
    };
    let mut params = params.clone();
    params.pressure_coefficient = 0.0;
    // Only what has a roughness of its own is steeper or less steep by itself.
    let is_other = described.measured_on.as_ref().is_some_and(|there| there.shape.is_some());
    let first = if measured_there && is_other { THERE } else { 0 };
    // The laws of two specimens are the same: those of the one that is asked for.
    let yielding = if described.law_is_open { yields(described.params.plasticity_index()) } else { 0.0 };
    let area = match (&described.measured_on, measured_there) {
        (_, true) => 0.0,
        (None, _) => described.shape.area,
        (Some(there), _) => there.shape.map_or(0.0, |there| (described.shape.area.powi(2) + there.area.powi(2)).sqrt()),
    };
    let area = described.model_error * area;
    let mut laws: Vec<Law> = Vec::new();
    for (probability, yields) in [(1.0 - yielding, false), (yielding, true)].into_iter().filter(|one| one.0 > 0.0) {
        if yields {
            params.set_elastic_plastic(params.hardness)?;
        }
        let heights = laws.first().map(|law| Rc::clone(&law.heights)).unwrap_or_default();
        laws.push(Law { probability, heights, area, ..law(described, &params, machined, first)? });
    }
    Ok(laws)
}

fn law(described: &Described, params: &Params, machined: Option<&Machined>, first: usize) -> Result<Law, Error> {
    let factor = work_factor(described);
    let is_open =
        factor > 1.0 && params.work_of_adhesion > 0.0 && described.points.iter().all(|point| point.load > 0.0);
    let (works, made) = match is_open {
        true => works(params.work_of_adhesion, deviation(factor), described.known_to.work.is_none()),
        false => (vec![Work::alone(params.work_of_adhesion, 1.0)], vec![params.work_of_adhesion]),
    };
    let middle = made.len() / 2;
    let mut params = Params { work_of_adhesion: made[middle], ..params.clone() };
    let most_probable = Surfaces::roughly(&params)?;
    let of = |&work_of_adhesion: &f64| Surfaces::like(&most_probable, &Params { work_of_adhesion, ..params.clone() });
    let mut models = made.iter().map(of).collect::<Result<Vec<_>, _>>()?;
    models[middle] = most_probable;
    let mut changed = [const { None }; INPUTS];
    let is_wavy = params.waviness.height > 0.0;
    params.waviness.height = 0.0;
    let even = is_wavy.then(|| Surfaces::roughly(&params)).transpose()?;
    for Input { at, deviation, change } in inputs(described, &params, machined, first) {
        // What is refused to one side is looked at on the other.
        changed[at] = [1.0, -1.0].into_iter().find_map(|sign| {
            let mut other = params.clone();
            change(&mut other, exp(sign * deviation));
            Surfaces::like(&models[middle], &other).ok().map(|surfaces| (surfaces, sign))
        });
    }
    let is_told = usize::from(described.specimens.is_some());
    let is_known = !is_open && !described.pressure_is_free && described.model_error == 0.0;
    let specimens = if is_known { SPECIMENS[is_told] } else { FEWER_SPECIMENS };
    let (probability, area, alike, heights, drawn) = (1.0, 0.0, ALIKE[is_told], Rc::default(), RefCell::default());
    Ok(Law { probability, works, models, middle, even, changed, specimens, drawn, alike, area, heights })
}

/// Works of adhesion, in standard deviations from the middle, with their probabilities.
const WORKS: [(f64, f64); 6] = [(-2.0, 0.044), (-1.2, 0.158), (-0.4, 0.298), (0.4, 0.298), (1.2, 0.158), (2.0, 0.044)];

/// Works of adhesion about one, with the works that models are made for.
fn works(about: f64, deviation: f64, may_be_none: bool) -> (Vec<Work>, Vec<f64>) {
    let ends = [WORKS[0].0, 0.0, WORKS[5].0];
    let mut made: Vec<f64> = ends.iter().map(|end| about * exp(deviation * end)).collect();
    let first = usize::from(may_be_none);
    let some = if may_be_none { 0.5 } else { 1.0 };
    let mut works: Vec<Work> = WORKS
        .iter()
        .map(|&(off, probability)| {
            let probability = some * probability;
            let models = if off < 0.0 { [first, first + 1] } else { [first + 1, first + 2] };
            let part = if off < 0.0 { 1.0 - off / ends[0] } else { off / ends[2] };
            Work { probability, work: about * exp(deviation * off), models, part }
        })
        .collect();
    if may_be_none {
        made.insert(0, 0.0);
        works.insert(0, Work::alone(0.0, 0.5));
    }
    (works, made)
}
