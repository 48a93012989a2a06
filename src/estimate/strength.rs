//! How strong an interface is before friction is measured on it, and how well that is known.

use super::known::{deviation, DEFAULT_FACTOR, LARGEST_ROW_PRESSURE, ROW_FACTOR, ROW_PRESSURE};
use crate::by_name::Described;
use crate::error::Error;
use crate::materials::Interface;
use crate::model::points::Prior;
use crate::model::Model;
use crate::numerics::elementary::{exp, log};
use crate::numerics::float_bits::finite;
use crate::params::Params;

/// What is taken for the strength where nothing is measured on these surfaces.
#[derive(Debug, Clone, PartialEq)]
pub enum Rests {
    Default,
    /// Rows of the table of interfaces: the one that is named, or those of these bodies without a lubricant.
    Rows(Vec<&'static Interface>),
    /// A slip stress of the table of pairs.
    Pair,
    Given,
}

impl Rests {
    pub fn of(described: &Described) -> Self {
        if described.has_strength {
            return Self::Given;
        }
        if let Some(interface) = described.interface {
            return Self::Rows(vec![interface]);
        }
        let rows = described.bodies.as_ref().map(Interface::of_bodies).unwrap_or_default();
        match described.params.has_default_strength() {
            _ if !rows.is_empty() && described.points.is_empty() => Self::Rows(rows),
            true => Self::Default,
            false => Self::Pair,
        }
    }

    /// The rows that tell a friction coefficient, or else a shear strength.
    fn alike(&self) -> (Vec<&'static Interface>, bool) {
        let Self::Rows(rows) = self else { return (Vec::new(), false) };
        let of_coefficient = rows.iter().any(|row| row.friction_coefficient > 0.0);
        let is_alike = |row: &&&Interface| (row.friction_coefficient > 0.0) == of_coefficient;
        (rows.iter().filter(is_alike).copied().collect(), of_coefficient)
    }

    /// Sets the slip stresses to the mean of the shear strengths of rows, where they have some.
    pub fn set(&self, params: &mut Params) -> Result<(), Error> {
        let (rows, of_coefficient) = self.alike();
        let [first, others @ ..] = &rows[..] else { return Ok(()) };
        if of_coefficient {
            return Ok(());
        }
        params.set_interface(first)?;
        let off = |row: &&Interface| log(row.shear_strength / first.shear_strength);
        let factor = exp(others.iter().map(off).sum::<f64>() / rows.len() as f64);
        params.slip.stress_1 *= factor;
        params.slip.stress_2 *= factor;
        Ok(())
    }
}

/// What is known of ln c, the factor on the slip stresses of the cases.
pub struct Strength {
    pub rests: Rests,
    pub is_measured: bool,
    deviation: f64,
    /// Friction coefficients of rows, with their loads.
    coefficients: Vec<(f64, f64)>,
}

impl Strength {
    pub fn new(rests: Rests, described: &Described) -> Self {
        let (rows, of_coefficient) = rests.alike();
        let is_measured = !described.points.is_empty();
        let deviation = match rests {
            Rests::Rows(_) => deviation(ROW_FACTOR).max(spread(&rows, of_coefficient)),
            Rests::Pair => deviation(ROW_FACTOR),
            Rests::Given if !is_measured => 0.0,
            Rests::Default | Rests::Given => deviation(DEFAULT_FACTOR),
        };
        let area = described.area();
        let load = |row: &Interface| match row.load > 0.0 {
            true => row.load.min(LARGEST_ROW_PRESSURE * area),
            false => ROW_PRESSURE * area,
        };
        let coefficients = match of_coefficient {
            true => rows.iter().map(|row| (row.friction_coefficient, load(row))).collect(),
            false => Vec::new(),
        };
        Self { rests, is_measured, deviation, coefficients }
    }

    /// The loads of rows.
    pub fn loads(&self) -> impl Iterator<Item = f64> + '_ {
        self.coefficients.iter().map(|(_, load)| *load)
    }

    /// ln c of one of the surfaces before friction is measured on it.
    pub fn prior(&self, model: &Model) -> Result<Prior, Error> {
        let precision = if self.deviation > 0.0 { 1.0 / self.variance() } else { 0.0 };
        let mut sum = 0.0;
        for &(coefficient, load) in &self.coefficients {
            let force = model.friction_force_at_load(load);
            if !(finite(force) && force > 0.0) {
                return Err(Model::not_evaluated(load));
            }
            sum += log(coefficient * load / force);
        }
        Ok(Prior { mean: sum / self.coefficients.len().max(1) as f64, precision })
    }

    pub fn variance(&self) -> f64 {
        self.deviation * self.deviation
    }

    /// How much of a variance of ln c that is left follows from what was known before the measurement.
    pub fn share(&self, variance: f64) -> f64 {
        if self.is_measured {
            variance / self.variance()
        } else {
            1.0
        }
    }

    /// Gives parameters the strength that is most probable on the middle surface.
    pub fn take(&self, params: &mut Params, middle: &Model) -> Result<(), Error> {
        let factor = exp(self.prior(middle)?.mean);
        params.slip.stress_1 *= factor;
        params.slip.stress_2 *= factor;
        Ok(())
    }

    /// 95 % lie within this factor either way, before a measurement.
    pub fn factor(&self) -> f64 {
        exp(super::known::REACH_95 * self.deviation)
    }
}

/// Standard deviation of the logarithms of rows; 0 of one.
fn spread(rows: &[&Interface], of_coefficient: bool) -> f64 {
    let value = |row: &&Interface| log(if of_coefficient { row.friction_coefficient } else { row.shear_strength });
    let count = rows.len() as f64;
    let mean = rows.iter().map(value).sum::<f64>() / count;
    let square: f64 = rows.iter().map(|row| (value(row) - mean) * (value(row) - mean)).sum();
    if rows.len() < 2 {
        0.0
    } else {
        (square / (count - 1.0)).sqrt()
    }
}
