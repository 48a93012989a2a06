//! Friction at loads from what little is known of a surface, as its text says, with the band that this leaves.
//!
//! Not known are the strength of the interface, its size effect and pressure coefficient, the work of adhesion, the contact law where
//! asperities may yield, slope, hardness and E, and how real interfaces leave the law between loads. `priors` has what is taken of each,
//! `strength` what is known of friction before it is measured, `points` what was measured, `cases` the surfaces that may be. Of what is
//! not normal there are nodes; measured points change their probabilities, and narrow what is normal within each, by Bayes' rule
//! (`posterior`). The value is the median of all nodes, the band their quantiles. `curve` is the one law that a solver gets, `words`
//! writes an estimate for people.

mod cases;
mod curve;
pub mod known;
mod points;
mod posterior;
pub mod priors;
mod strength;
mod words;

use crate::asperity::slip::SlipConstants;
use crate::by_name::{describe, Described};
use crate::error::{CalibrationFailure, Error, LOAD};
use crate::model::calibration::MeasuredPoint;
use crate::numerics::ascending;
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::numerics::quadrature::points;
use crate::params::Params;
use cases::{
    laws, Law, OfLaw, Terms, Work, AREA_INPUT, HARDNESS_INPUT, HERTZ, NOTHING, SLOPES, STIFFNESS, STRENGTH_INPUT,
    YOUNG_INPUT,
};
use curve::Curve;
use known::deviation;
use points::{merged, Point};
use posterior::{Gathered, Kernel, Mixture, Normal, Seen, Solved, INPUTS, PARTS};
use std::cell::RefCell;
use std::f64::consts::LN_10;
use std::rc::Rc;
pub use strength::Rests;
use strength::Strength;
pub use words::write;

/// Slip stresses are this to the power of the size effect apart: Hurtado and Kim's with 1.
const SIZE_RATIO: f64 = 30.0;
const SIZES: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];
/// Pressure coefficients that are looked at, beside 0, up to so many of their deviations.
const PRESSURES: usize = 4;
const MOST_PRESSURE: f64 = 3.0;
/// Of no kind nodes differ in more than so many, works of adhesion included.
const MOST_ALIKE: usize = 8;
/// Points whose misfit over what is left is up to the first of these are as they should be; from the second on their errors grow until it
/// is 1, to this in its logarithm.
const FITTING: [f64; 2] = [2.0, 4.0];
const FITTED: f64 = 1e-3;
/// Times as much as real interfaces usually leave the law, that points which contradict each other are looked at with.
const FASTEST: f64 = 10.0;
/// Loads that are kept.
const MOST_KEPT: usize = 16;
/// What a constant coefficient is asked to be within.
const CONSTANT: f64 = 1.1;
/// A coefficient above it is a slip of units rather than a strength.
const LARGE: f64 = 5.0;
/// Nodes less probable than this do not matter; for a band, less than that.
const UNLIKELY: f64 = 1e-6;
const HARDLY_LIKELY: f64 = 4e-6;
/// No band has a smaller variance.
const CERTAIN: f64 = 1e-20;

/// What makes the variance of ln(F/P).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shares {
    pub strength: f64,
    pub size: f64,
    pub pressure: f64,
    pub adhesion: f64,
    pub hardness: f64,
    pub slope: f64,
    pub measurement: f64,
    pub model: f64,
    pub specimen: f64,
    /// The part of `model` that a table of heights and slopes would take away.
    pub shape: f64,
}

/// A number with its band.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Band {
    pub value: f64,
    pub low: f64,
    pub high: f64,
}

/// An answer for one load: where few summits touch, of one specimen.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Answer {
    /// [N]
    pub load: f64,
    /// F/P: infinite from the pull-off load to 0, 0 below.
    pub friction: Band,
    /// F [N]. Of loads that do not press, that of surfaces which adhere.
    pub force: Band,
    /// F/P of a model of the parameters; NaN where no strength gives the measured friction.
    pub curve: f64,
    /// How probable it is that F/P is within 10 % of what was measured.
    pub constant_odds: f64,
    pub shares: Shares,
    /// Tangential and normal stiffness [N/m], the sum of the contact radii [m], and the normal stiffness of unloading [N/m].
    pub stiffness: [Band; 4],
    /// Between the mean planes [m].
    pub gap: Band,
    /// How hard a specimen can be pulled [N]; NaN where many summits touch.
    pub pull_off: Band,
    /// F [N] of another specimen than the one that was measured.
    pub another: Band,
    /// Summits in contact that the model expects; NaN where loads are pressures.
    pub contacts: f64,
    pub whose: Whose,
}

/// What an answer is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Whose {
    /// Many contacts: specimens hardly differ.
    #[default]
    Many,
    /// One specimen of many.
    Any,
    /// The specimen that was measured.
    Measured,
}

/// All that a text tells of friction.
pub struct Estimate {
    described: Described,
    strength: Strength,
    laws: Vec<Law>,
    /// Those of the surfaces that were measured, where they are others.
    laws_there: Option<Vec<Law>>,
    /// The size effect, where it is not open.
    size: Option<f64>,
    points: Vec<Point>,
    /// What the laws made of the first and of the last loads.
    kept: RefCell<Vec<Kept>>,
    nodes: Vec<Node>,
    curve: Curve,
    /// By how much the errors of the points grew, since the law cannot follow them.
    pub growth: f64,
    /// The probability that real interfaces leave the law more than is usual.
    pub leaves_law: f64,
}

/// What the laws made of a load.
struct Kept {
    load: f64,
    is_there: bool,
    is_of_many: bool,
    of: Rc<Vec<OfLaw>>,
}

/// One set of all that is not normal.
struct Node {
    law: usize,
    work: Work,
    size: f64,
    /// The part of the force at the reference that goes with pressure.
    pressed: f64,
    /// Times as much of how real interfaces leave the law, and its rise a decade.
    more: (f64, f64),
    /// Where it stands among the laws, works, sizes, pressures, and mores.
    place: [usize; 5],
    kernel: Kernel,
    /// ln of the force at the reference, and what makes it there.
    log_force: f64,
    reference: Reference,
    solved: Solved,
    weight: f64,
}

#[derive(Clone, Copy)]
struct Reference {
    force: f64,
    hertz: f64,
    gains: [f64; INPUTS],
    /// The deviation of the strength, and whether that is all of the friction or what is not by pressure.
    strength: f64,
    is_part: bool,
    /// Whether it is of the area of other surfaces, or of none.
    is_elsewhere: bool,
}

impl Estimate {
    /// Reads a text and finds what its points tell.
    ///
    /// # Errors
    /// Those of the text, with line and key, and those of surfaces.
    pub fn new(bytes: &[u8]) -> Result<Self, Error> {
        describe(bytes, Self::of)
    }

    /// The same of what a text says.
    pub fn of(mut described: Described) -> Result<Self, Error> {
        let strength = Strength::new(&described);
        let size = fix_size(&mut described, &strength)?;
        for point in &described.points {
            described.params.check_measured(point.load, point.force)?;
        }
        let laws_here = laws(&described, false)?;
        for point in described.points.iter().filter(|point| point.force > LARGE * point.load) {
            // Beyond any strength it is a slip of units.
            described.params.clone().strengthen(laws_here[0].middle(), point.load, point.force)?;
        }
        let laws_there = described.measured_on.as_ref().map(|_| laws(&described, true)).transpose()?;
        let curve = Curve { params: described.params.clone(), surfaces: laws_here[0].middle().clone(), failure: None };
        let points = merged(&described.points);
        let (laws, kept, nodes, growth, leaves_law) = (laws_here, RefCell::default(), Vec::new(), 1.0, 0.0);
        let mut estimate =
            Self { described, strength, laws, laws_there, size, points, kept, nodes, curve, growth, leaves_law };
        estimate.weigh()?;
        estimate.curve = estimate.find_curve()?;
        Ok(estimate)
    }

    fn is_film(&self) -> bool {
        self.size.is_none()
    }

    /// What the laws make of a load, of the surfaces that are asked for or of those that were measured: where few summits touch, of
    /// specimens, but what other specimens tell is of many.
    fn at(&self, load: f64, where_measured: bool) -> Result<Rc<Vec<OfLaw>>, Error> {
        let there = self.laws_there.as_ref().filter(|_| where_measured);
        let is_told = !where_measured || !self.described.is_of_law && !self.points.is_empty();
        let (is_there, is_of_many) = (there.is_some(), self.is_of_pressures() || !is_told);
        let mut kept = self.kept.borrow_mut();
        let is_same = |one: &&Kept| (one.load, one.is_there, one.is_of_many) == (load, is_there, is_of_many);
        if let Some(one) = kept.iter().find(is_same) {
            return Ok(one.of.clone());
        }
        let near = |law: usize| kept.first().map_or(&[][..], |one| &one.of[law].separations);
        let laws = there.unwrap_or(&self.laws).iter().enumerate();
        let of = laws.map(|(i, law)| law.at(load, is_of_many, self.is_film(), near(i))).collect::<Result<_, _>>()?;
        let of = Rc::new(of);
        if kept.len() == MOST_KEPT {
            kept.remove(1);
        }
        kept.push(Kept { load, is_there, is_of_many, of: Rc::clone(&of) });
        Ok(of)
    }

    /// Makes the nodes, and gives them the probabilities that the points leave them.
    fn weigh(&mut self) -> Result<(), Error> {
        // A stress holds at all loads, but a pressure coefficient has a load at which it is a part.
        let reference = if self.strength.is_stress { self.described.usual_load() } else { self.strength.load };
        let reference = self.at(reference, true)?;
        let of_points = self.points.iter().map(|point| self.at(point.load, true)).collect::<Result<Vec<_>, _>>()?;
        let decades: Vec<f64> =
            self.points.iter().zip(&of_points).map(|(point, at)| self.decades(at, point.load)).collect();
        let all_there = decades.iter().all(|&decades| decades == 0.0);
        let measured: Vec<f64> = self.points.iter().map(|point| point.log_force).collect();
        let noise: Vec<f64> = self.points.iter().map(|point| point.noise).collect();
        let unsolved = self.unsolved_nodes(&reference)?;
        let solved = |noise: &[f64]| {
            let told = if self.measured_specimens() > 0.0 { &of_points[..] } else { &[] };
            let mut on_each: Vec<_> = told.iter().map(|at| OnEach::new(at)).collect();
            // Where all points are at the reference, how interfaces leave the law from there does not matter.
            let is_like = |one: &Node, other: &Node| all_there && one.place[..4] == other.place[..4];
            let mut found: Vec<(Solved, f64)> = Vec::with_capacity(unsolved.len());
            for (i, (node, prior)) in unsolved.iter().enumerate() {
                let solved = match found.last().filter(|_| is_like(node, &unsolved[i - 1].0)) {
                    Some((before, _)) => before.with(node.kernel),
                    None => {
                        on_each.iter_mut().for_each(|at| at.look(node));
                        self.solve(node, &on_each, &of_points, &decades, (&measured, noise))
                    }
                };
                let weight = log(*prior) + solved.log_probability;
                found.push((solved, weight));
            }
            found
        };
        let mut found = solved(&noise);
        // No law that changes so fast that hardly any does makes points at nearly one load agree.
        let misfit_of = |found: &[(Solved, f64)], growth: f64| {
            let usual = unsolved.iter().zip(found).filter(|((node, _), _)| node.more.0 <= FASTEST);
            self.misfit_of_one(usual.map(|(_, (solved, _))| solved.misfit).fold(f64::INFINITY, f64::min), growth)
        };
        let grown = |growth: f64| noise.iter().map(|noise| noise * growth * growth).collect::<Vec<_>>();
        let misfit = misfit_of(&found, 1.0);
        let [from, to] = FITTING;
        let mut growth = 1.0;
        if misfit > from {
            // Until the misfit is 1, by secants in logarithms: errors are a part alone of what points may be off by.
            let (mut off, mut rate) = (log(misfit), 2.0_f64);
            while off.abs() > FITTED {
                let by = off / rate.max(1.0);
                growth *= exp(by);
                let left = log(misfit_of(&solved(&grown(growth)), growth));
                (off, rate) = (left, (off - left) / by);
            }
            growth = 1.0 + ((misfit - from) / (to - from)).min(1.0) * (growth - 1.0);
            found = solved(&grown(growth));
        }
        let best = found.iter().map(|one| one.1).fold(f64::NEG_INFINITY, f64::max);
        found.iter_mut().for_each(|one| one.1 = exp(one.1 - best));
        let all: f64 = found.iter().map(|one| one.1).sum();
        let of = unsolved.into_iter().zip(found).filter(|(_, (_, weight))| weight / all > UNLIKELY);
        self.nodes = of.map(|((node, _), (solved, weight))| Node { weight: weight / all, solved, ..node }).collect();
        self.growth = growth;
        self.leaves_law = self.nodes.iter().filter(|node| node.more.0 > 1.0).map(|node| node.weight).sum();
        Ok(())
    }

    /// What the points tell of a node: those of one specimen whichever it is, and those of some on the mean of them.
    fn solve(
        &self,
        node: &Node,
        on_each: &[OnEach],
        of_points: &[Rc<Vec<OfLaw>>],
        decades: &[f64],
        (measured, noise): (&[f64], &[f64]),
    ) -> Solved {
        let (n, count) = (measured.len(), self.measured_specimens());
        let seen = of_points.iter().zip(decades).map(|(at, &decades)| node.seen(at, decades)).collect();
        let mut errors = vec![0.0; n * n];
        noise.iter().enumerate().for_each(|(i, noise)| errors[i * n + i] = *noise);
        if count > 1.0 {
            for (i, k) in (0..n).flat_map(|i| (0..n).map(move |k| (i, k))) {
                errors[i * n + k] += covariance(&on_each[i].logs, &on_each[k].logs, count);
            }
        }
        let solved = Solved::new(seen, node.kernel, measured, &errors);
        let specimens = on_each.iter().map(|at| at.logs.len()).fold(0, usize::max);
        if count != 1.0 || specimens == 0 {
            return solved;
        }
        let means: Vec<(&[f64], f64)> =
            on_each.iter().zip(decades).map(|(at, decades)| (&at.logs[..], node.more.1 * decades)).collect();
        solved.on_one_of(specimens, &means, measured)
    }

    /// The misfit over what the points leave, 1 where points are as far off as their errors have it, which have grown; 0 of a point alone.
    fn misfit_of_one(&self, misfit: f64, growth: f64) -> f64 {
        let left = self.points.iter().map(|point| point.more + 1).sum::<usize>().saturating_sub(1);
        let scatter = self.points.iter().map(|point| point.scatter).sum::<f64>() / (growth * growth);
        if left > 0 {
            (misfit + scatter) / left as f64
        } else {
            0.0
        }
    }

    /// All nodes with their probabilities before the points.
    fn unsolved_nodes(&self, reference: &[OfLaw]) -> Result<Vec<(Node, f64)>, Error> {
        let Described { class, model_error: error, .. } = self.described;
        let is_stress = self.strength.is_stress;
        let mores = if error > 0.0 && !is_stress { class.more } else { &[(1.0, 0.0, 1.0)] };
        let sizes: Vec<(f64, f64)> = match self.size {
            Some(size) => vec![(size, 1.0)],
            None => SIZES.into_iter().zip(class.size).collect(),
        };
        let mut nodes = Vec::new();
        let laws = self.laws_there.as_ref().unwrap_or(&self.laws);
        let works = |at: usize| laws[at].works.iter().enumerate().map(move |work| (at, work));
        for (at_law, (at_work, work)) in (0..laws.len()).flat_map(works) {
            let (law, of, terms) = (&laws[at_law], &reference[at_law], reference[at_law].terms(work));
            for (at_size, &(size, of_size)) in sizes.iter().enumerate() {
                let force = terms.force(size);
                let gains = if is_stress { [0.0; INPUTS] } else { of.gains(&|terms: &Terms| terms.force(size)) };
                let (strength, is_part) = (self.strength.deviation, self.has_known_pressure());
                let is_elsewhere = is_stress || self.laws_there.is_some();
                let reference = Reference { force, hertz: terms.logs[HERTZ], gains, strength, is_part, is_elsewhere };
                let pressures = self.pressures(force, terms.logs[HERTZ]).into_iter().enumerate();
                let all = pressures.flat_map(|pressure| mores.iter().enumerate().map(move |more| (pressure, more)));
                for ((at_pressure, (pressed, of_pressure, log_force)), (at_more, &(times, rise, of_more))) in all {
                    let leaves = |rate: f64| if is_stress { 0.0 } else { (error * rate).powi(2) };
                    let (drift, wander) = (leaves(times * class.drift), leaves(times * class.wander));
                    // How real surfaces leave the law was measured on such as are told no better.
                    let kernel = Kernel { drift, wander: wander.max(leaves(self.described.shape.wander)) };
                    let (law_at, work, more) = (at_law, *work, (times, rise * error.min(1.0)));
                    let place = [at_law, at_work, at_size, at_pressure, at_more];
                    let (solved, weight) = (Solved::new(Vec::new(), kernel, &[], &[]), 0.0);
                    let node = Node {
                        law: law_at,
                        work,
                        size,
                        pressed,
                        more,
                        place,
                        kernel,
                        log_force,
                        reference,
                        solved,
                        weight,
                    };
                    nodes.push((node, law.probability * work.probability * of_size * of_pressure * of_more));
                }
            }
        }
        match (&self.described.points[..], &nodes[..]) {
            ([MeasuredPoint { load, force, .. }, ..], []) => {
                let (load, friction_force, reason) = (*load, *force, CalibrationFailure::Pressure);
                self.described.params.clone().strengthen(self.laws[0].middle(), load, friction_force)?;
                Err(Error::Uncalibrated { load, friction_force, reason, number: friction_force })
            }
            _ => Ok(nodes),
        }
    }

    /// Whether friction was not measured, but a part of it is given, as a pressure coefficient beside what a table has of the strength.
    fn has_known_pressure(&self) -> bool {
        let is_of_row = self.strength.is_stress && !self.strength.rests.rows().is_empty();
        !self.strength.is_measured && !is_of_row && self.described.params.pressure_coefficient > 0.0
    }

    /// The parts of the force at the reference that pressure coefficients make, their probabilities, and ln of that force.
    fn pressures(&self, force: f64, hertz: f64) -> Vec<(f64, f64, f64)> {
        let given = self.described.params.pressure_coefficient;
        let log_force = match self.strength.is_stress {
            true => log(exp(self.strength.mean + force) + given * exp(hertz)),
            false => self.strength.log_force(),
        };
        let of_hertz = exp(hertz - log_force);
        if !self.described.pressure_is_free || self.strength.is_stress {
            let by_pressure = given * of_hertz;
            return match (by_pressure < 1.0, self.strength.is_measured) {
                (true, _) => vec![(by_pressure, 1.0, log_force)],
                // Strength comes on top of what is given.
                (false, false) => vec![(by_pressure / (1.0 + by_pressure), 1.0, log_force + log(1.0 + by_pressure))],
                // Pressure alone makes more than was measured: it is not so.
                (false, true) => Vec::new(),
            };
        }
        let class = self.described.class;
        let reach = if class.pressure_is_even { class.pressure } else { MOST_PRESSURE * class.pressure };
        let most = (1.0 / of_hertz).min(reach);
        let weight =
            |kappa: f64| if class.pressure_is_even { 1.0 } else { exp(-0.5 * (kappa / class.pressure).powi(2)) };
        let kappas = points::<PRESSURES>(0.0, most).map(|(kappa, part)| (kappa, part * weight(kappa)));
        let all: f64 = kappas.iter().map(|(_, weight)| weight).sum();
        let pressing = kappas.into_iter().map(|(kappa, weight)| (kappa * of_hertz, 0.5 * weight / all, log_force));
        std::iter::once((0.0, 0.5, log_force)).chain(pressing).collect()
    }

    /// Decades of load from the reference, each with what adhesion adds to the load of a specimen.
    fn decades(&self, at: &[OfLaw], load: f64) -> f64 {
        let pull = at.first().map_or(0.0, OfLaw::mean_pull);
        match load + pull > 0.0 && self.strength.load > 0.0 {
            true => (log(load + pull) - log(self.strength.load + pull)) / LN_10,
            false => 0.0,
        }
    }

    /// ln F at a load, as each node has it of the mean of specimens.
    fn nodes_at(&self, at: &[OfLaw], decades: f64) -> Vec<Normal> {
        let of = |node: &Node| {
            let seen = node.seen(at, decades);
            let deviation = node.solved.parts(&seen).iter().sum::<f64>().sqrt();
            Normal { weight: node.weight, mean: node.solved.mean(&seen), deviation, part: node.part(at) }
        };
        self.nodes.iter().map(of).collect()
    }

    /// ln F at a load, with what makes its variance: within nodes its parts, between them each of what they differ in; and ln F of another
    /// specimen than the one that was measured. Of loads that do not press only of surfaces that adhere.
    fn looked(&self, at: &[OfLaw], load: f64) -> (Mixture, Mixture, Shares) {
        let decades = self.decades(at, load);
        let is_device = self.is_device();
        let mut within = [0.0; PARTS];
        let (mut of_specimens, mut of_shape) = (0.0, 0.0);
        // The probability and the mean of all nodes that have one thing alike.
        let mut alike = [[(0.0, 0.0); MOST_ALIKE]; 5];
        let (mut mixture, mut others) = (Gathered::default(), Gathered::default());
        let holding = || self.nodes.iter().filter(|node| load > 0.0 || node.work.work > 0.0);
        let least = HARDLY_LIKELY * holding().map(|node| node.weight).sum::<f64>();
        // Without a step as one begins to matter.
        let likely =
            || holding().map(|node| (node, node.weight - least * least / node.weight)).filter(|one| one.1 > 0.0);
        let all: f64 = likely().map(|one| one.1).sum();
        let (mut on_each, mut pairs) = (OnEach::new(at), Pairs::default());
        let (mut pulled, mut means) = (Vec::new(), Vec::new());
        for (node, weight) in likely() {
            let seen = node.seen(at, decades);
            on_each.look(node);
            node.solved.pulled(&seen, &mut pulled);
            let parts = node.solved.parts(&seen);
            let weight = weight / all;
            within.iter_mut().zip(parts).for_each(|(sum, part)| *sum += weight * part);
            let leaving = node.kernel.covariance(&Seen { gains: [0.0; INPUTS], ..seen }, &seen).max(CERTAIN);
            let own = (self.described.model_error * node.more.0 * self.described.class.wander).powi(2);
            let part = (node.kernel.wander - own).max(0.0) * decades.abs() / leaving;
            of_shape += weight * (parts[AREA_INPUT] + part * parts[INPUTS + 1]);
            let deviation = parts.iter().sum::<f64>().sqrt();
            let of = Normal { weight, mean: 0.0, deviation, part: node.part(at) };
            let rise = node.more.1 * decades;
            let on = |i: usize| on_each.logs.get(i).map_or(seen.mean, |mean| mean + rise);
            let devices = node.solved.devices();
            means.clear();
            if devices.is_empty() {
                let by = node.solved.mean(&seen) - seen.mean;
                let count = on_each.logs.len().max(1);
                means.extend((0..count).map(|i| (1.0 / count as f64, on(i) + by)));
            } else {
                let of_others = pairs.of(node, &on_each.logs, &pulled);
                means.extend(of_others.iter().map(|&(i, k)| (devices[k], on(i) + pulled[k])));
                if is_device {
                    others.add(of, &means);
                    means.clear();
                    means.extend(devices.iter().enumerate().map(|(i, part)| (*part, on(i) + pulled[i])));
                }
            }
            let mean: f64 = means.iter().map(|(part, mean)| part * mean).sum();
            of_specimens += weight * means.iter().map(|(part, one)| part * (one - mean) * (one - mean)).sum::<f64>();
            for (what, &place) in alike.iter_mut().zip(&node.place) {
                what[place] = (what[place].0 + weight, what[place].1 + weight * mean);
            }
            mixture.add(of, &means);
        }
        let [mixture, others] = [mixture, others].map(Gathered::mixture);
        let (mean, variance) = mixture.moments();
        if variance < CERTAIN {
            return (mixture, others, Shares::default());
        }
        let apart = alike.each_ref().map(|what| {
            let known = || what.iter().filter(|(weight, _)| *weight > 0.0);
            // One alone differs from the mean by rounding.
            let apart = |(weight, sum): &(f64, f64)| weight * (sum / weight - mean) * (sum / weight - mean);
            if known().count() > 1 {
                known().map(apart).sum::<f64>()
            } else {
                0.0
            }
        });
        let [inside, all] = [within.iter().sum::<f64>() + of_specimens, apart.iter().sum::<f64>()];
        let between = (variance - inside).max(0.0);
        let [law, adhesion, size, pressure, more] =
            apart.map(|part| if all > 0.0 { part / all * between } else { 0.0 });
        let share = |part: f64| part / variance;
        let shares = Shares {
            strength: share(within[STRENGTH_INPUT]),
            size: share(size),
            pressure: share(pressure),
            adhesion: share(adhesion),
            hardness: share(within[HARDNESS_INPUT] + within[YOUNG_INPUT] + law),
            slope: share(SLOPES.iter().map(|&input| within[input]).sum()),
            measurement: share(within[INPUTS]),
            model: share(within[INPUTS + 1] + within[AREA_INPUT] + more),
            shape: share(of_shape),
            specimen: share(of_specimens),
        };
        (mixture, others, shares)
    }

    /// All that is known at a load.
    ///
    /// # Errors
    /// As [`Estimate::friction_at`].
    pub fn at_load(&self, load: f64) -> Result<Answer, Error> {
        let mut answer = self.friction_at(load)?;
        let Some(at) = self.held_at(load)? else { return Ok(answer) };
        let of_shape = self.described.shape.area;
        let error = self.described.model_error * (deviation(priors::STIFFNESS).powi(2) + of_shape * of_shape).sqrt();
        answer.stiffness =
            std::array::from_fn(|i| self.of_surfaces(&at, error, &|terms| terms.logs[STIFFNESS + i]).map(some_exp));
        // In sigma.
        let length = self.laws[0].middle().units().length;
        let widening = self.widening(&at);
        answer.gap = self.of_surfaces(&at, 0.0, &|terms| terms.gap / length).map(|gap| gap * length + widening);
        answer.pull_off = self.of_surfaces(&at, 0.0, &|terms| terms.pull);
        Ok(answer)
    }

    /// Friction at a load, and no more.
    ///
    /// # Errors
    /// [`Error::InvalidLoad`] of one that is not finite, [`Error::OutOfRange`] of one that is too heavy or too light.
    fn friction_at(&self, load: f64) -> Result<Answer, Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: LOAD, value: load });
        }
        let mut answer = Answer { load, pull_off: UNKNOWN, gap: UNKNOWN, ..Answer::default() };
        let at = self.held_at(load);
        self.add_curve(at.as_ref().map_or(&[], |at| at.as_deref().map_or(&[][..], Vec::as_slice)), &mut answer)?;
        if let Some(at) = at? {
            self.add_friction(&at, &mut answer);
        }
        if load == 0.0 || (load < 0.0 && answer.force.value > 0.0) {
            // What holds the surfaces together gives friction without a load; the ratio has no bound as the load goes to 0.
            answer.friction = Band::exact(f64::INFINITY);
        }
        if load <= 0.0 && answer.curve > 0.0 {
            answer.curve = f64::INFINITY;
        }
        Ok(answer)
    }

    /// What the laws make of a load; `None` where nothing holds the surfaces together.
    fn held_at(&self, load: f64) -> Result<Option<Rc<Vec<OfLaw>>>, Error> {
        let is_held = load > 0.0 || self.nodes.iter().any(|node| node.work.work > 0.0);
        let at = is_held.then(|| self.at(load, false)).transpose();
        if load > 0.0 {
            at
        } else {
            Ok(at.unwrap_or_default())
        }
    }

    /// Whether the surfaces asked for are those of the specimen that was measured.
    fn is_device(&self) -> bool {
        self.laws_there.is_none() && self.nodes.iter().any(|node| !node.solved.devices().is_empty())
    }

    fn add_friction(&self, at: &[OfLaw], answer: &mut Answer) {
        let is_few = at.iter().any(OfLaw::has_specimens);
        let is_device = self.is_device();
        answer.whose = match is_few || is_device && answer.contacts < self.laws[0].alike {
            true if is_device => Whose::Measured,
            true => Whose::Any,
            false => Whose::Many,
        };
        let (mixture, others, shares) = self.looked(at, answer.load);
        answer.shares = shares;
        if answer.load > 0.0 {
            let constant = self.strength.mean + log(answer.load);
            let near = log(CONSTANT);
            answer.constant_odds = mixture.between(constant - near, constant + near);
        }
        answer.force = self.force_of(mixture);
        answer.another = if answer.whose == Whose::Measured { self.force_of(others) } else { answer.force };
        if answer.load > 0.0 {
            answer.friction = answer.force.map(|force| force / answer.load);
        }
    }

    fn force_of(&self, mixture: Mixture) -> Band {
        self.band_of(mixture).map(some_exp)
    }

    /// What neighbours add to the gap, on the mean of the laws.
    fn widening(&self, at: &[OfLaw]) -> f64 {
        let of_law = |(i, (law, of)): (usize, (&Law, &OfLaw))| {
            let weight: f64 = self.nodes.iter().filter(|node| node.law == i).map(|node| node.weight).sum();
            let widening = |separation| law.middle().widening(separation) * law.middle().units().length;
            weight * of.separation().map_or(0.0, widening)
        };
        self.laws.iter().zip(at).enumerate().map(of_law).sum()
    }

    /// The laws and works of adhesion with their probabilities, each with a node of it.
    fn surfaces(&self) -> Vec<(f64, &Node)> {
        let mut alike: Vec<(f64, &Node)> = Vec::new();
        for node in &self.nodes {
            match alike.iter_mut().find(|(_, other)| other.place[..2] == node.place[..2]) {
                Some((weight, _)) => *weight += node.weight,
                None => alike.push((node.weight, node)),
            }
        }
        alike
    }

    /// A quantity of which nothing was measured, to an error beside that of the inputs.
    fn of_surfaces(&self, at: &[OfLaw], error: f64, quantity: &dyn Fn(&Terms) -> f64) -> Band {
        let mut all = Gathered::default();
        for (weight, node) in self.surfaces() {
            let of = &at[node.law];
            let inputs: f64 = of.gains(quantity).iter().map(|gain| gain * gain).sum();
            let mut means: Vec<_> = of.specimens(&node.work).map(|terms| (1.0, quantity(&terms))).collect();
            if means.is_empty() {
                means.push((1.0, quantity(&of.terms(&node.work))));
            }
            means.retain(|(_, mean)| !mean.is_nan());
            let alike = 1.0 / means.len() as f64;
            means.iter_mut().for_each(|mean| mean.0 = alike);
            let of = Normal { weight, mean: 0.0, deviation: (inputs + error * error).sqrt(), part: 1.0 };
            all.add(of, &means);
        }
        self.band_of(all.mixture())
    }

    /// The median, and the quantiles of either end of a band.
    fn band_of(&self, mixture: Mixture) -> Band {
        if mixture.0.is_empty() {
            return UNKNOWN;
        }
        let value = mixture.quantile(0.5);
        let coverage = self.described.coverage;
        let [low, high] = [0.5 * (1.0 - coverage), 0.5 * (1.0 + coverage)].map(|part| mixture.quantile(part));
        match mixture.moments().1 < CERTAIN {
            true => Band::exact(value),
            false => Band { value, low: low.min(value), high: high.max(value) },
        }
    }

    /// Whether the text has no nominal area, so that loads are nominal pressures [Pa] and forces shear stresses.
    pub fn is_of_pressures(&self) -> bool {
        self.described.is_of_pressures
    }

    /// On how many specimens friction was measured; 0 where the text does not say.
    pub fn measured_specimens(&self) -> f64 {
        self.described.specimens.unwrap_or(0.0)
    }

    /// The unit of loads and of forces.
    fn unit(&self) -> &'static str {
        ["N", "Pa"][usize::from(self.is_of_pressures())]
    }

    /// At which of these loads a measured point is worth most, and what part of the variance at all of them it would take away.
    fn next_point(&self, loads: &[f64]) -> Result<Option<(f64, f64)>, Error> {
        let error = self.described.params.error_of_point();
        let at = loads.iter().map(|&load| self.at(load, false)).collect::<Result<Vec<_>, _>>()?;
        let decades: Vec<f64> = at.iter().zip(loads).map(|(at, &load)| self.decades(at, load)).collect();
        let n = loads.len();
        let mixtures: Vec<Mixture> =
            at.iter().zip(&decades).map(|(at, &decades)| Mixture(self.nodes_at(at, decades))).collect();
        let means: Vec<f64> = mixtures.iter().map(|mixture| mixture.moments().0).collect();
        let mut covariance = vec![0.0; n * n];
        for (k, node) in self.nodes.iter().enumerate() {
            let seen: Vec<Seen> = at.iter().zip(&decades).map(|(at, &decades)| node.seen(at, decades)).collect();
            let off: Vec<f64> = mixtures.iter().zip(&means).map(|(mixture, mean)| mixture.0[k].mean - mean).collect();
            for i in 0..n {
                for j in 0..n {
                    covariance[i * n + j] +=
                        node.weight * (node.solved.covariance(&seen[i], &seen[j]) + off[i] * off[j]);
                }
            }
        }
        let all: f64 = (0..n).map(|i| covariance[i * n + i]).sum();
        let gain = |c: usize| {
            let told: f64 = (0..n).map(|q| covariance[q * n + c] * covariance[q * n + c]).sum();
            told / (covariance[c * n + c] + error * error) / all
        };
        Ok((0..n).map(|c| (loads[c], gain(c))).max_by(|one, other| one.1.total_cmp(&other.1)))
    }

    /// The parameters that a model of the text has.
    ///
    /// # Errors
    /// [`Error::Uncalibrated`] where no strength below the shear modulus gives the measured friction.
    pub fn params(&self) -> Result<&Params, Error> {
        self.curve.failure.clone().map_or(Ok(&self.curve.params), Err)
    }

    /// Bits of what the model assumes and a state between these loads lacks: of those that press.
    ///
    /// # Errors
    /// Those of [`crate::Model::check_loads`].
    pub fn warnings(&self, loads: &[f64]) -> Result<u64, Error> {
        let pressing = || loads.iter().copied().filter(|&load| load > 0.0);
        match (pressing().reduce(f64::min), pressing().reduce(f64::max)) {
            (Some(lightest), Some(heaviest)) => {
                let [light, heavy] = [lightest, heaviest].map(|load| (load, self.separation_at(load)));
                self.curve.surfaces.judged_as(&self.curve.params).check_loads_near(light, heavy)
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
}

impl Band {
    const fn exact(value: f64) -> Self {
        Self { value, low: value, high: value }
    }

    fn map(self, of: impl Fn(f64) -> f64) -> Self {
        let [value, low, high] = [self.value, self.low, self.high].map(of);
        Self { value, low, high }
    }
}

const UNKNOWN: Band = Band::exact(f64::NAN);

/// What a number is the logarithm of, or 0 where it is that of nothing.
fn some_exp(number: f64) -> f64 {
    if number > 0.5 * NOTHING {
        exp(number)
    } else {
        0.0
    }
}

/// The covariance of means over so many specimens, where their logarithms at two loads are these.
fn covariance(one: &[f64], other: &[f64], count: f64) -> f64 {
    let n = one.len().min(other.len()) as f64;
    if n == 0.0 {
        return 0.0;
    }
    let [a, b] = [one, other].map(|all| all.iter().sum::<f64>() / n);
    one.iter().zip(other).map(|(x, y)| (x - a) * (y - b)).sum::<f64>() / n / count
}

impl Node {
    /// ln F of what bears a load so, and the part of it that the strength makes.
    fn log_force(&self, terms: &Terms) -> (f64, f64) {
        let Reference { force, hertz, .. } = self.reference;
        let of_strength = (1.0 - self.pressed) * exp(terms.force(self.size) - force);
        let all = of_strength + self.pressed * exp(terms.logs[HERTZ] - hertz);
        (self.log_force + log(all), of_strength / all)
    }

    /// The part of friction that is in doubt.
    fn part(&self, at: &[OfLaw]) -> f64 {
        match self.reference.is_part {
            true => self.log_force(&at[self.law].terms(&self.work)).1,
            false => 1.0,
        }
    }

    /// What it makes of a load, of the mean of specimens.
    fn seen(&self, at: &[OfLaw], decades: f64) -> Seen {
        let (of, from) = (&at[self.law], &self.reference);
        let (mean, part) = self.log_force(&of.terms(&self.work));
        let mut gains = of.gains(&|terms: &Terms| terms.force(self.size));
        gains.iter_mut().zip(from.gains).for_each(|(gain, from)| *gain = part * (*gain - from));
        gains[AREA_INPUT] = if from.is_elsewhere { part * of.area } else { 0.0 };
        gains[STRENGTH_INPUT] = if from.is_part { part * from.strength } else { from.strength };
        Seen { mean: mean + self.more.1 * decades, gains, decades }
    }
}

/// ln F of single specimens at a load, but for a rise from decade to decade, node after node: what is the same for the next one is kept.
struct OnEach<'a> {
    at: &'a [OfLaw],
    place: Option<[usize; 5]>,
    terms: Vec<Terms>,
    /// What strength and pressure make of the force, over that at the reference.
    forces: Vec<[f64; 2]>,
    /// None where many summits touch.
    logs: Vec<f64>,
}

impl<'a> OnEach<'a> {
    const fn new(at: &'a [OfLaw]) -> Self {
        Self { at, place: None, terms: Vec::new(), forces: Vec::new(), logs: Vec::new() }
    }

    fn look(&mut self, node: &Node) {
        let Reference { force, hertz, .. } = node.reference;
        let is_like = |places: usize| self.place.is_some_and(|place| place[..places] == node.place[..places]);
        let [same_surfaces, same_size, same_pressure] = [2, 3, 4].map(is_like);
        self.place = Some(node.place);
        if !same_surfaces {
            self.terms.clear();
            self.terms.extend(self.at[node.law].specimens(&node.work));
        }
        if !same_size {
            let of = |terms: &Terms| [terms.force(node.size) - force, terms.logs[HERTZ] - hertz].map(exp);
            self.forces.clear();
            self.forces.extend(self.terms.iter().map(of));
        }
        if !same_pressure {
            let of = |[strength, pressure]: &[f64; 2]| (1.0 - node.pressed) * strength + node.pressed * pressure;
            self.logs.clear();
            self.logs.extend(self.forces.iter().map(|forces| node.log_force + log(of(forces))));
        }
    }
}

/// Specimens beside those that were measured, all with all, as few pairs stand for them: those of a lattice, from the least to the largest
/// of both. Nodes of the same surfaces have nearly the same order.
#[derive(Default)]
struct Pairs {
    place: Option<[usize; 2]>,
    pairs: Vec<(usize, usize)>,
}

impl Pairs {
    /// Which ones, where `logs` has ln F of specimens, if they differ, and `pulled` what is added by those that were measured.
    fn of(&mut self, node: &Node, logs: &[f64], pulled: &[f64]) -> &[(usize, usize)] {
        let place = [node.place[0], node.place[1]];
        if self.place != Some(place) {
            self.place = Some(place);
            let n = pulled.len();
            let step = (0.618 * n as f64).round() as usize;
            let (specimens, devices) = (ascending(logs), ascending(pulled));
            let pair = |i: usize| (specimens.get(i).copied().unwrap_or(i), devices[(i * step + n / 2) % n]);
            self.pairs = (0..n).map(pair).collect();
        }
        &self.pairs
    }
}

/// The size effect where it is not open, with slip stresses that have it.
fn fix_size(described: &mut Described, strength: &Strength) -> Result<Option<f64>, Error> {
    let tells_stress = strength.is_stress || described.interface.is_some();
    let of_stress = strength.rests.rows().iter().find(|row| row.shear_strength > 0.0).filter(|_| tells_stress);
    let there = described.measured_on.as_mut().map(|there| &mut there.params);
    let all = std::iter::once(&mut described.params).chain(there);
    if let Some(row) = of_stress {
        for params in all {
            params.set_interface(row)?;
        }
        described.pressure_is_free &= row.pressure_coefficient == 0.0;
        return Ok(Some(0.0));
    }
    if described.has_stress {
        let SlipConstants { stress_1, stress_2, .. } = described.params.slip;
        if stress_1 == 0.0 && stress_2 == 0.0 {
            let says = "slip_stress_1: must be > 0 for an estimate: without slip stresses F/P is pressure_coefficient";
            return Err(Error::Meaningless(says.into()));
        }
        return Ok(Some(log(stress_1 / stress_2) / log(SIZE_RATIO)));
    }
    let size = described.size_effect.unwrap_or(1.0);
    let SlipConstants { stress_1, stress_2, .. } = SlipConstants::default();
    let stress_2 = if size == 1.0 { stress_2 } else { stress_1 / exp(size * log(SIZE_RATIO)) };
    for params in all {
        (params.slip.stress_1, params.slip.stress_2) = (stress_1, stress_2);
    }
    Ok(described.size_effect)
}

#[cfg(test)]
mod tests;
