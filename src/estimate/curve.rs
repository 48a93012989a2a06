//! The one law of a surface that a solver gets from a text, beside what is estimated.

use super::cases::{Law, OfLaw, Terms, HERTZ};
use super::posterior::Mixture;
use super::strength::Rests;
use super::{Answer, Estimate, Node, SIZE_RATIO};
use crate::asperity::slip::SlipConstants;
use crate::error::Error;
use crate::model::Surfaces;
use crate::numerics::elementary::{exp, log};
use crate::params::{Params, OF_OTHER_MATERIALS};

/// What a solver gets: one law.
pub struct Curve {
    pub params: Params,
    /// With a pressure coefficient of 0.
    pub surfaces: Surfaces,
    pub failure: Option<Error>,
}

impl Estimate {
    /// What a model of the parameters has.
    pub(super) fn add_curve(&self, at: &[OfLaw], answer: &mut Answer) -> Result<(), Error> {
        let Curve { params, surfaces, failure } = &self.curve;
        let load = answer.load;
        let borne = match surfaces.borne_near(load, self.separation(at)) {
            // Apart, or no number is small enough for what the mean of so rough surfaces has without a load.
            Err(_) if load <= 0.0 => None,
            borne => Some(borne?),
        };
        answer.contacts = match self.is_of_pressures() {
            true => f64::NAN,
            false => borne.map_or(0.0, |borne| borne.contacting),
        };
        let force = borne
            .map_or(0.0, |borne| self.factor() * borne.friction_force + params.pressure_coefficient * borne.hertz_load);
        answer.curve = match failure {
            Some(_) => f64::NAN,
            None if load > 0.0 => force / load,
            None => force,
        };
        Ok(())
    }

    /// The separation that the law of the curve has, of what the laws made of a load.
    pub(super) fn separation(&self, at: &[OfLaw]) -> Option<f64> {
        let is_like = |law: &Law| law.middle().params().contact_law == self.curve.params.contact_law;
        self.laws.iter().zip(at).find(|(law, _)| is_like(law)).and_then(|(_, of)| of.separation())
    }

    /// The same of a load that was asked before.
    pub(super) fn separation_at(&self, load: f64) -> Option<f64> {
        let kept = self.kept.borrow();
        kept.iter().find(|one| one.load == load && !one.is_there).and_then(|one| self.separation(&one.of))
    }

    /// The strength of the curve, over that of its surfaces.
    pub(super) fn factor(&self) -> f64 {
        self.curve.params.slip.stress_1.max(self.curve.params.slip.stress_2)
            / self.curve.surfaces.params().slip.stress_1.max(self.curve.surfaces.params().slip.stress_2)
    }

    /// The law that a solver gets: the mean size effect and pressure coefficient, the most probable law and work of adhesion, and the
    /// strength that gives the median at the load of the reference.
    pub(super) fn find_curve(&self) -> Result<Curve, Error> {
        let mut params = self.described.with_law(self.described.params.clone())?;
        let size = self.mean_of(|node| node.size);
        if self.size.is_none() {
            params.slip.stress_2 = params.slip.stress_1 / exp(size * log(SIZE_RATIO));
        }
        // Where the text has a strength that nothing tells of, it has the law and the adhesion of a model too.
        if params.work_of_adhesion > 0.0 && self.described.tells_strength() {
            params.work_of_adhesion = self.likely_work().unwrap_or(params.work_of_adhesion);
        }
        let surfaces = |params: &Params| {
            let params = Params { pressure_coefficient: 0.0, ..params.clone() };
            self.laws.iter().find_map(|law| law.like(&params)).map_or_else(|| Surfaces::new(&params), Ok)
        };
        let found = surfaces(&params)?;
        // The strength is that of the specimen that was measured, in Pa.
        let mut measured = match &self.described.measured_on {
            Some(there) => {
                let work_of_adhesion = there.params.work_of_adhesion.min(params.work_of_adhesion);
                let there = Params { slip: params.slip, work_of_adhesion, ..there.params.clone() };
                self.described.with_law(there)?
            }
            None => params.clone(),
        };
        let there = if self.laws_there.is_some() { surfaces(&measured)? } else { found.clone() };
        // Where few summits touch at the reference, the mean of their specimens has the friction that was measured.
        let alone = Law::alone(&there, &self.laws_there.as_ref().unwrap_or(&self.laws)[0]);
        let is_few = !self.strength.is_stress && self.at(self.strength.load, true)?.iter().any(OfLaw::has_specimens);
        let reference = || alone.at(self.strength.load, !is_few, false, &[]).map(|at| at.terms(&alone.works[0]));
        let specimens = if is_few { Some(reference()?) } else { None };
        // What other materials have is told of all of the friction: none is by pressure, which would be taken for known.
        if self.described.pressure_is_free && !self.strength.is_stress && !self.is_of_other_materials() {
            // The same part of the force, also where adhesion presses more or less than in the nodes.
            let hertz = specimens.map_or_else(reference, Ok)?.logs[HERTZ];
            measured.pressure_coefficient = self.mean_of(|node| node.pressed) * exp(self.strength.log_force() - hertz);
            params.pressure_coefficient = measured.pressure_coefficient;
        }
        if self.strength.is_stress && !self.described.has_stress {
            let unit = params.slip.stress_1.max(params.slip.stress_2) * params.effective_shear_modulus;
            multiply(&mut params.slip, exp(self.strength.mean) / unit);
        }
        if self.strength.is_stress {
            self.mark(&mut params);
            return Ok(Curve { surfaces: found, params, failure: None });
        }
        let unit = measured.slip.stress_1;
        let failure = match self.strengthen(&mut measured, &alone, specimens) {
            Err(error) if !matches!(error, Error::Uncalibrated { .. }) => return Err(error),
            strengthened => strengthened.err(),
        };
        if failure.is_none() {
            let factor =
                measured.slip.stress_1 / unit * measured.effective_shear_modulus / params.effective_shear_modulus;
            match self.described.measured_on {
                Some(_) => multiply(&mut params.slip, factor),
                None => params = measured,
            }
            self.mark(&mut params);
        }
        Ok(Curve { params, surfaces: found, failure })
    }

    /// Gives parameters the strength of the median at the reference, or that of the only point: of the mean of specimens where there are
    /// any.
    pub(super) fn strengthen(&self, params: &mut Params, law: &Law, specimens: Option<Terms>) -> Result<(), Error> {
        let points = &self.described.points[..];
        if let ([point], None) = (points, &specimens) {
            params.calibration_error = point.error;
            return params.strengthen(law.middle(), point.load, point.force);
        }
        let mut load = self.strength.load;
        let mixture = Mixture(self.nodes_at(&self.at(load, true)?, 0.0));
        let mut force = exp(mixture.quantile(0.5));
        if let Some(specimens) = specimens {
            (load, force) = law.calibrated(params, &specimens, load, force)?;
        }
        params.strengthen(law.middle(), load, force)?;
        params.calibration_error = if let [point] = points { point.error } else { mixture.moments().1.sqrt().min(1.0) };
        Ok(())
    }

    pub(super) fn mean_of(&self, of: impl Fn(&Node) -> f64) -> f64 {
        self.nodes.iter().map(|node| node.weight * of(node)).sum()
    }

    /// Nothing was measured on these surfaces: parameters say whether their strength is that of other materials.
    pub(super) fn mark(&self, params: &mut Params) {
        if !self.strength.is_measured {
            (params.calibration_load, params.calibration_friction_force) = (0.0, 0.0);
            if self.is_of_other_materials() {
                params.calibration_error = OF_OTHER_MATERIALS;
            }
        }
    }

    pub(super) fn is_of_other_materials(&self) -> bool {
        !self.strength.is_measured && matches!(self.strength.rests, Rests::Metals | Rests::Others)
    }

    /// The work of adhesion that a solver takes: none where that is clearly more probable than any.
    pub(super) fn likely_work(&self) -> Option<f64> {
        const CLEARLY: f64 = 0.6;
        // Rounding of what the points say nothing of.
        const SAME: f64 = 1e-3;
        let of = |adheres: bool| self.nodes.iter().filter(move |node| (node.work.work > 0.0) == adheres);
        let weight = |adheres| of(adheres).map(|node| node.weight).sum::<f64>();
        let (none, some) = (weight(false), weight(true));
        let sum: f64 = of(true).map(|node| node.weight * log(node.work.work)).sum();
        let before = self.laws.iter().any(|law| law.works.iter().any(|work| work.work == 0.0));
        let given = self.described.params.work_of_adhesion;
        match before && none > CLEARLY * (none + some) {
            true => Some(0.0),
            false => Some(exp(sum / some)).filter(|work| (work / given - 1.0).abs() > SAME),
        }
    }
}

fn multiply(slip: &mut SlipConstants, factor: f64) {
    (slip.stress_1, slip.stress_2) = (slip.stress_1 * factor, slip.stress_2 * factor);
}
