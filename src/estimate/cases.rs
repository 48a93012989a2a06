//! The surfaces that may be, and what they bear at a load: sums over their summits, without a compiled law.

use super::known::deviation;
use super::posterior::INPUTS;
use super::priors::{yields, HARDNESS, MEASURED_SLOPE, SLOPE, WORK, YOUNG};
use crate::by_name::{Described, Machined};
use crate::error::{Error, LOAD};
use crate::model::{Model, Surfaces};
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::params::{ContactLawKind, Params};

/// Where inputs stand among those that are normal.
const SLOPE_INPUT: usize = 0;
const HEIGHT_INPUT: usize = 1;
pub const HARDNESS_INPUT: usize = 2;
pub const YOUNG_INPUT: usize = 3;
/// The slope and the height of the surface that was measured, where it is another.
const THERE: usize = 4;
/// All of the roughness.
pub const SLOPES: [usize; 4] = [SLOPE_INPUT, HEIGHT_INPUT, THERE + SLOPE_INPUT, THERE + HEIGHT_INPUT];

/// Logarithms of what surfaces bear at a load, with a shear strength of 1.
#[derive(Debug, Clone, Copy)]
pub struct Terms {
    /// The friction force of a film, whose strength does not depend on the size of a contact, and with the whole size effect; both the same
    /// where that is given.
    pub film: f64,
    pub slip: f64,
    /// The load of Hertz' contacts, which a pressure coefficient takes its part of.
    pub hertz: f64,
    /// Tangential and normal stiffness, the sum of the contact radii, and the normal stiffness of unloading.
    pub stiffness: [f64; 4],
}

/// One work of adhesion, with its probability among the others.
#[derive(Debug, Clone, Copy)]
pub struct Work {
    pub probability: f64,
    pub work: f64,
    /// Between which of the models it is, and the part of the second.
    models: [usize; 2],
    part: f64,
}

/// Surfaces of one contact law.
#[derive(Debug)]
pub struct Law {
    pub probability: f64,
    pub works: Vec<Work>,
    /// For each work of adhesion that a model is made for, the surfaces as they most probably are; the middle one is compared with others.
    models: Vec<Surfaces>,
    middle: usize,
    /// The same with an input one standard deviation off, and the sign of that.
    changed: [Option<(Surfaces, f64)>; INPUTS],
}

/// What one law makes of a load.
#[derive(Debug)]
pub struct OfLaw {
    models: Vec<Terms>,
    middle: usize,
    changed: [Option<(Terms, f64)>; INPUTS],
}

impl Terms {
    /// The separation becomes that of these surfaces: like ones are near it.
    fn at(surfaces: &Surfaces, load: f64, is_film: bool, separation: &mut Option<f64>) -> Result<Self, Error> {
        let borne = surfaces.borne_near(load, *separation)?;
        *separation = Some(borne.separation);
        let params = surfaces.params();
        let unit = params.slip.stress_1.max(params.slip.stress_2) * params.effective_shear_modulus;
        let slip = log(borne.friction_force) - log(unit);
        let film = if is_film { log(borne.real_area) } else { slip };
        let [tangential, normal, unloading] =
            [borne.tangential_stiffness, borne.normal_stiffness, borne.unloading_stiffness].map(log);
        let stiffness = [tangential, normal, log(borne.contact_radius_sum), unloading];
        let found = Self { film, slip, hertz: log(borne.hertz_load), stiffness };
        match finite(film) && finite(slip) && finite(found.hertz) {
            true => Ok(found),
            false if load > 0.0 => {
                Err(Error::out_of_range(LOAD, load, "must be heavier: the friction force is too small for a number"))
            }
            false => Err(Model::not_evaluated(load)),
        }
    }

    fn mix(&self, other: &Self, part: f64) -> Self {
        let mix = |one: f64, other: f64| one + part * (other - one);
        Self {
            film: mix(self.film, other.film),
            slip: mix(self.slip, other.slip),
            hertz: mix(self.hertz, other.hertz),
            stiffness: std::array::from_fn(|i| mix(self.stiffness[i], other.stiffness[i])),
        }
    }

    pub fn force(&self, size: f64) -> f64 {
        self.film + size * (self.slip - self.film)
    }
}

impl OfLaw {
    pub fn terms(&self, work: &Work) -> Terms {
        let [one, other] = work.models.map(|model| &self.models[model]);
        one.mix(other, work.part)
    }

    /// What a quantity changes by with each input.
    pub fn gains(&self, of: impl Fn(&Terms) -> f64) -> [f64; INPUTS] {
        let middle = of(&self.models[self.middle]);
        self.changed.each_ref().map(|changed| changed.as_ref().map_or(0.0, |(terms, sign)| sign * (of(terms) - middle)))
    }
}

impl Law {
    /// The surfaces as they most probably are.
    pub fn middle(&self) -> &Surfaces {
        &self.models[self.middle]
    }

    pub fn at(&self, load: f64, is_film: bool) -> Result<OfLaw, Error> {
        let mut near = None;
        let models = self.models.iter().map(|surfaces| Terms::at(surfaces, load, is_film, &mut near));
        let models = models.collect::<Result<_, _>>()?;
        let mut changed = [const { None }; INPUTS];
        for (input, found) in changed.iter_mut().enumerate() {
            *found = match &self.changed[input] {
                Some((surfaces, sign)) => Some((Terms::at(surfaces, load, is_film, &mut near)?, *sign)),
                None => None,
            };
        }
        Ok(OfLaw { models, middle: self.middle, changed })
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
    described.known_to.hardness.unwrap_or(if described.has_hardness || described.bodies.is_none() {
        1.0
    } else {
        HARDNESS
    })
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
    let first = if measured_there { THERE } else { 0 };
    // The laws of two specimens are the same: those of the one that is asked for.
    let yielding = match described.law_is_open {
        true => yields(described.params.plasticity_index()),
        false => 0.0,
    };
    let mut laws = Vec::new();
    if yielding < 1.0 {
        laws.push(law(described, &params, machined, first, 1.0 - yielding)?);
    }
    if yielding > 0.0 {
        params.set_elastic_plastic(params.hardness)?;
        laws.push(law(described, &params, machined, first, yielding)?);
    }
    Ok(laws)
}

fn law(
    described: &Described,
    params: &Params,
    machined: Option<&Machined>,
    first: usize,
    probability: f64,
) -> Result<Law, Error> {
    let factor = work_factor(described);
    let is_open =
        factor > 1.0 && params.work_of_adhesion > 0.0 && described.points.iter().all(|point| point.load > 0.0);
    let (works, made) = match is_open {
        true => works(params.work_of_adhesion, deviation(factor), described.known_to.work.is_none()),
        false => {
            let work = params.work_of_adhesion;
            (vec![Work { probability: 1.0, work, models: [0; 2], part: 0.0 }], vec![work])
        }
    };
    let middle = made.len() / 2;
    let of_work = |work: &f64| Surfaces::new(&Params { work_of_adhesion: *work, ..params.clone() });
    let models = made.iter().map(of_work).collect::<Result<Vec<_>, _>>()?;
    let mut changed = [const { None }; INPUTS];
    for Input { at, deviation, change } in inputs(described, params, machined, first) {
        // What is refused to one side is looked at on the other.
        changed[at] = [1.0, -1.0].into_iter().find_map(|sign| {
            let mut other = Params { work_of_adhesion: made[middle], ..params.clone() };
            change(&mut other, exp(sign * deviation));
            Surfaces::new(&other).ok().map(|surfaces| (surfaces, sign))
        });
    }
    Ok(Law { probability, works, models, middle, changed })
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
        works.insert(0, Work { probability: 0.5, work: 0.0, models: [0; 2], part: 0.0 });
    }
    (works, made)
}
