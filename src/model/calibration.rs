//! The strength of an interface from measured friction forces.
//!
//! The friction force is linear in the slip stresses: with both times c it is c F0(P) + kappa P_H(P), F0 that of the stresses
//! as they are. A measured force F at the load P gives c = (F - kappa P_H)/F0. All else, how F changes with load, area, roughness
//! and adhesion, is the model's.

use super::points::{misfit, nearest, tell_pressure, MeasuredPoint, Seen};
use super::Model;
use crate::error::{CalibrationFailure as Reason, Error};
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::params::{Params, LARGEST_QUANTITY};
use std::ops::RangeInclusive;

/// Above it surfaces have seized, or a force was given.
const SEIZED_COEFFICIENT: f64 = 20.0;
/// What most coefficients lie between: of a load within beside a coefficient without, the two are swapped.
const USUAL: RangeInclusive<f64> = 1e-3..=10.0;
/// A lighter load looks like a coefficient.
const LARGEST_USUAL_LOAD: f64 = 2.0;
/// Strengths so close to the measured one are it.
const SAME_STRENGTH: f64 = 1e-12;

/// What a calibration found.
#[derive(Debug)]
pub(crate) struct Calibrated {
    /// The points, with the parts of their forces.
    pub seen: Vec<Seen>,
    /// How far off the points are.
    pub misfit: f64,
    /// Whether the points set the pressure coefficient.
    pub tells_pressure: bool,
}

impl Params {
    /// Scales both slip stresses so that the friction coefficient at a load is the one measured there, and keeps the measurement.
    ///
    /// # Errors
    /// [`Error::InvalidParameter`] for a load that does not press, a coefficient that is not above 0 and at most 20, or one below
    /// 0.001 or above 10 with a load that looks like a coefficient; those of
    /// [`Params::calibrate_force`]. The parameters are then as before.
    pub fn calibrate(&mut self, load: f64, friction_coefficient: f64) -> Result<(), Error> {
        self.calibrate_force(load, Self::measured_force(load, friction_coefficient)?)
    }

    /// The force of a measured coefficient.
    pub(crate) fn measured_force(load: f64, friction_coefficient: f64) -> Result<f64, Error> {
        if !finite(load) {
            return Err(Error::InvalidLoad { name: "calibration_load", value: load });
        }
        if load <= 0.0 {
            let allowed = "must be > 0; at zero load, or where the load pulls, calibrate with the friction force";
            return Err(Error::invalid("calibration_load", load, allowed));
        }
        if !finite(friction_coefficient) || friction_coefficient <= 0.0 || friction_coefficient > SEIZED_COEFFICIENT {
            let allowed =
                "must be > 0 and at most 20; is it a force? Calibrate with the friction force then; or is it in per cent? Or is \
                 it the load, which comes first?";
            return Err(Error::invalid("calibration_friction_coefficient", friction_coefficient, allowed));
        }
        if !USUAL.contains(&friction_coefficient) && (*USUAL.start()..=LARGEST_USUAL_LOAD).contains(&load) {
            let allowed =
                "most are between 0.001 and 10, as the load is here: are the two swapped? The load comes first; \
                           where they are not, calibrate with the friction force";
            return Err(Error::invalid("calibration_friction_coefficient", friction_coefficient, allowed));
        }
        Ok(friction_coefficient * load)
    }

    /// Scales both slip stresses so that the friction force at a load is the one measured there, and keeps the measurement: for
    /// loads that are 0 or pull.
    ///
    /// # Errors
    /// [`Error::Uncalibrated`], with the numbers, for a force that no stresses give: not positive, not above what the pressure
    /// coefficient gives alone, or so large that a stress exceeds G*; and those of [`Model::new`] and
    /// [`Model::state_at_load`]. The parameters are then as before.
    pub fn calibrate_force(&mut self, load: f64, friction_force: f64) -> Result<(), Error> {
        let point = MeasuredPoint { load, force: friction_force, error: self.calibration_error };
        self.calibrate_points(&[point], false, None).map(|_| ())
    }

    /// The same from one point or several: the curve nearest to them in their logarithms, each weighted by its error. Where they
    /// tell the pressure coefficient and it is free, it is led by them too. The measurement that is kept is that of the curve at
    /// the mean of the logarithms of the loads.
    ///
    /// A model without a pressure coefficient, where there is one, is not made again.
    pub(crate) fn calibrate_points(
        &mut self,
        points: &[MeasuredPoint],
        pressure_is_free: bool,
        without_pressure: Option<&Model>,
    ) -> Result<Calibrated, Error> {
        let refused = |point: &MeasuredPoint, reason: Reason, number: f64| {
            Err(Error::Uncalibrated { load: point.load, friction_force: point.force, reason, number })
        };
        if let Some(point) = points.iter().find(|point| !finite(point.force) || point.force <= 0.0) {
            return refused(point, Reason::NotPositive, 0.0);
        }
        if self.slip.stress_1 == 0.0 && self.slip.stress_2 == 0.0 {
            return refused(&points[0], Reason::NoStress, 0.0);
        }
        let made;
        let model = match without_pressure {
            Some(model) => model,
            None => {
                made = Model::new(&Self { pressure_coefficient: 0.0, ..self.clone() })?;
                &made
            }
        };
        let mut seen = Vec::with_capacity(points.len());
        for point in points {
            let state = model.state_at_load(point.load)?;
            let of_pressure = self.pressure_coefficient * state.hertz_load;
            if point.force <= of_pressure {
                return refused(point, Reason::Pressure, of_pressure);
            }
            // Where the load hardly presses, the force may be too small for a number.
            if state.friction_force < f64::MIN_POSITIVE {
                return refused(point, Reason::NoFriction, state.friction_force);
            }
            let (force, pressed, measured) = (state.friction_force, state.hertz_load, log(point.force));
            seen.push(Seen { force, pressed, measured, error: point.error });
        }
        let tells_pressure = pressure_is_free && tell_pressure(&seen);
        let (factor, kappa) = match seen[..] {
            [one] => {
                let kappa = self.pressure_coefficient;
                ((points[0].force - kappa * one.pressed) / one.force, kappa)
            }
            _ => {
                let (log_c, kappa) = nearest(&seen, (!tells_pressure).then_some(self.pressure_coefficient));
                (exp(log_c), kappa)
            }
        };
        let [least, most] = [
            1.0 / (LARGEST_QUANTITY * self.slip.stress_1.min(self.slip.stress_2)),
            1.0 / self.slip.stress_1.max(self.slip.stress_2),
        ];
        // The error names the point that is farthest beyond.
        let beyond = |reason: Reason, bound: f64, sign: f64| {
            let allowed = |one: &Seen| bound * one.force + kappa * one.pressed;
            let excess = |(point, one): &(&MeasuredPoint, &Seen)| sign * (log(point.force) - log(allowed(one)));
            let of_all = points.iter().zip(&seen);
            let (point, one) =
                of_all.max_by(|one, other| excess(one).total_cmp(&excess(other))).unwrap_or((&points[0], &seen[0]));
            refused(point, reason, allowed(one))
        };
        if factor > most {
            return beyond(Reason::Strength, most, 1.0);
        }
        if factor < least {
            return beyond(Reason::Weakness, least, -1.0);
        }
        let misfit = misfit(&seen, log(factor), kappa, tells_pressure);
        let MeasuredPoint { mut load, force: mut friction_force, .. } = points[0];
        if points.len() > 1 {
            load = exp(points.iter().map(|point| log(point.load)).sum::<f64>() / points.len() as f64);
            let state = model.state_at_load(load)?;
            friction_force = factor * state.friction_force + kappa * state.hertz_load;
        }
        if (factor - 1.0).abs() > SAME_STRENGTH {
            self.slip.stress_1 *= factor;
            self.slip.stress_2 *= factor;
        }
        self.pressure_coefficient = kappa;
        let precision: f64 = points.iter().map(|point| 1.0 / (point.error * point.error)).sum();
        self.calibration_error = if points.len() > 1 { misfit.max(1.0) / precision.sqrt() } else { points[0].error };
        self.calibration_error = self.calibration_error.min(1.0);
        (self.calibration_load, self.calibration_friction_force) = (load, friction_force);
        Ok(Calibrated { seen, misfit, tells_pressure })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the strength, and 0.02 of Hertz' loads.
    #[test]
    fn several_points_set_strength_and_pressure_coefficient_and_keep_the_point_in_their_middle() {
        let before = Params { work_of_adhesion: 0.0, ..Params::paper() };
        let model = Model::new(&before).expect("a model");
        let points = [(1.0, 1e-3), (10.0, 2e-3), (1000.0, 2e-3), (1e4, 1e-3)].map(|(load, error)| {
            let state = model.state_at_load(load).expect("a state");
            MeasuredPoint { load, force: 2.0 * state.friction_force + 0.02 * state.hertz_load, error }
        });
        for known in [None, Some(&model)] {
            let mut params = before.clone();
            let found = params.calibrate_points(&points, true, known).expect("a strength");
            assert!(found.tells_pressure && found.misfit < 0.1 && found.seen.len() == 4, "{found:?}");
            assert!((params.slip.stress_1 / before.slip.stress_1 - 2.0).abs() < 0.01, "{params:?}");
            assert!((params.slip.stress_2 / before.slip.stress_2 - 2.0).abs() < 0.01, "{params:?}");
            assert!((params.pressure_coefficient - 0.02).abs() < 1e-4, "{params:?}");
            assert!((params.calibration_load / 100.0 - 1.0).abs() < 1e-12);
            let kept = Model::new(&params).expect("a model").state_at_load(100.0).expect("a state").friction_force;
            assert!((params.calibration_friction_force / kept - 1.0).abs() < 1e-9, "{params:?}, {kept}");
            assert!((params.calibration_error / 1e-3 - 0.4_f64.sqrt()).abs() < 1e-9, "{params:?}");
        }
        // Far off, and so no more known than they agree; a coefficient that is not free stays.
        let mut params = Params { pressure_coefficient: 0.01, ..before };
        let off = points
            .map(|point| MeasuredPoint { force: point.force * (1.0 + 0.1 * (point.load.log10() % 2.0)), ..point });
        let found = params.calibrate_points(&off, false, None).expect("a strength");
        assert!(!found.tells_pressure && found.misfit > 2.0 && params.pressure_coefficient == 0.01, "{found:?}");
        let error = 1e-3 * 0.4_f64.sqrt() * found.misfit;
        assert!((params.calibration_error / error - 1.0).abs() < 1e-9, "{params:?}");
        let wild = [1.0, 1e-4].map(|part| MeasuredPoint { force: part * points[1].force, error: 0.9, ..points[1] });
        params.pressure_coefficient = 0.0;
        params.calibrate_points(&wild, false, None).expect("a strength");
        assert_eq!(params.calibration_error, 1.0);
    }

    /// One that is beyond its bound by 1 in its logarithm, and one by 3.
    #[test]
    fn of_several_points_that_which_is_farthest_beyond_is_named() {
        let params = Params { calibration_error: 0.1, ..Params::paper() };
        for (force, sign) in [(1e20, 1.0), (1e-290, -1.0)] {
            let beyond = |load: f64, off: f64| match params.clone().calibrate_force(load, force) {
                Err(Error::Uncalibrated { number, .. }) => {
                    MeasuredPoint { load, force: number * exp(sign * off), error: 0.1 }
                }
                other => panic!("{other:?}"),
            };
            let mut points = [beyond(0.1, 1.0), beyond(1e5, 3.0)];
            for _ in 0..2 {
                let refused = params.clone().calibrate_points(&points, false, None);
                assert!(matches!(refused, Err(Error::Uncalibrated { load: 1e5, .. })), "{refused:?}, {points:?}");
                points.reverse();
            }
        }
    }

    #[test]
    fn friction_that_is_no_number_has_no_strength() {
        let mut params = Params { work_of_adhesion: 0.0, ..Params::paper() };
        let refused = params.calibrate_force(5e-324, 1e-300);
        assert!(matches!(refused, Err(Error::Uncalibrated { reason: Reason::NoFriction, .. })), "{refused:?}");
    }

    #[test]
    fn there_is_a_stress_to_scale() {
        let of = |stress_1: f64, stress_2: f64| {
            let slip = crate::asperity::slip::SlipConstants { stress_1, stress_2, ..Default::default() };
            Params { slip, pressure_coefficient: 0.1, ..Params::paper() }.calibrate_force(10.0, 5.0)
        };
        assert!(matches!(of(0.0, 0.0), Err(Error::Uncalibrated { reason: Reason::NoStress, .. })));
        assert!(matches!(of(0.0, 0.02), Err(Error::InvalidParameter { .. })) && of(0.02, 0.02).is_ok());
    }
}
