//! How strong an interface is before friction is measured on it, and how well that is known.

use super::known::{deviation, REACH_95};
use super::priors::{FAMILY_FACTOR, LARGEST_ROW_PRESSURE, MEASURED_FACTOR, METALS, OTHERS, PAIR_FACTOR, ROW_PRESSURE};
use crate::by_name::Described;
use crate::materials::Interface;
use crate::numerics::elementary::{exp, log};

/// What is taken for the strength where nothing is measured on these surfaces.
#[derive(Debug, Clone, PartialEq)]
pub enum Rests {
    /// Friction of other materials: of dry metals, or of anything.
    Metals,
    Others,
    /// Rows of the table of interfaces: the one that is named, or those of these bodies without a lubricant.
    Rows(Vec<&'static Interface>),
    /// Those of the metals that these bodies are alloys of.
    Family(Vec<&'static Interface>),
    Given,
    /// Slip stresses that are defaults, or those of other materials, as parameters write them that nobody calibrated.
    GivenByDefault,
}

impl Rests {
    fn of(described: &Described) -> Self {
        if let Some(interface) = described.interface {
            return Self::Rows(vec![interface]);
        }
        if described.has_stress {
            return if described.params.has_default_strength() { Self::GivenByDefault } else { Self::Given };
        }
        let Some(bodies) = &described.bodies else { return Self::Others };
        match (Interface::of_bodies(bodies), Interface::of_families(bodies)) {
            (rows, _) if !rows.is_empty() => Self::Rows(rows),
            (_, rows) if !rows.is_empty() => Self::Family(rows),
            _ if bodies.are_metals() => Self::Metals,
            _ => Self::Others,
        }
    }

    pub fn rows(&self) -> &[&'static Interface] {
        match self {
            Self::Rows(rows) | Self::Family(rows) => rows,
            _ => &[],
        }
    }
}

/// What is known of friction before the points of these surfaces: its logarithm is normal.
#[derive(Debug)]
pub struct Strength {
    pub rests: Rests,
    pub is_measured: bool,
    /// ln of F/P at `load`, or of a shear strength [Pa], which holds at all loads.
    pub mean: f64,
    pub is_stress: bool,
    pub deviation: f64,
    /// The load that it is of; NaN of a stress.
    pub load: f64,
}

impl Strength {
    pub fn new(described: &Described) -> Self {
        let rests = Rests::of(described);
        if let [first, ..] = &described.points[..] {
            return Self::measured(described, rests, first.load);
        }
        let area = described.area();
        let usual = described.usual_load();
        let of = |(median, factor): (f64, f64)| (log(median), deviation(factor), usual, false);
        let (mean, deviation, load, is_stress) = match &rests {
            Rests::Metals => of(METALS),
            Rests::Others => of(OTHERS),
            Rests::Given | Rests::GivenByDefault => {
                let slip = described.params.slip;
                let stress = slip.stress_1.max(slip.stress_2) * described.params.effective_shear_modulus;
                let deviation = if rests == Rests::Given { 0.0 } else { deviation(OTHERS.1) };
                (log(stress), deviation, f64::NAN, true)
            }
            Rests::Rows(rows) => of_rows(rows, PAIR_FACTOR, area),
            Rests::Family(rows) => of_rows(rows, FAMILY_FACTOR, area),
        };
        Self { rests, is_measured: false, mean, is_stress, deviation, load }
    }

    /// About the weighted mean of the points, and hardly known before them.
    fn measured(described: &Described, rests: Rests, first: f64) -> Self {
        let points = &described.points;
        let weight = |error: f64| 1.0 / (error * error);
        let all: f64 = points.iter().map(|point| weight(point.error)).sum();
        let mean_of = |value: &dyn Fn(usize) -> f64| {
            points.iter().enumerate().map(|(i, point)| weight(point.error) * value(i)).sum::<f64>() / all
        };
        let (load, mean) = match points.len() > 1 && points.iter().all(|point| point.load > 0.0) {
            true => (exp(mean_of(&|i| log(points[i].load))), mean_of(&|i| log(points[i].force) - log(points[i].load))),
            false => (first, mean_of(&|i| log(points[i].force)) - log(if first > 0.0 { first } else { 1.0 })),
        };
        Self { rests, is_measured: true, mean, is_stress: false, deviation: deviation(MEASURED_FACTOR), load }
    }

    /// ln of the force at the load that it is of.
    pub fn log_force(&self) -> f64 {
        self.mean + if self.load > 0.0 { log(self.load) } else { 0.0 }
    }

    /// 95 % lie within this factor either way, before a measurement.
    pub fn factor(&self) -> f64 {
        exp(REACH_95 * self.deviation)
    }
}

/// Rows that tell a friction coefficient, or else a shear strength: mean, deviation, load, and whether it is a stress.
fn of_rows(rows: &[&'static Interface], factor: f64, area: f64) -> (f64, f64, f64, bool) {
    let is_stress = rows.iter().all(|row| row.friction_coefficient == 0.0);
    let alike: Vec<_> = rows.iter().filter(|row| is_stress || row.friction_coefficient > 0.0).collect();
    let value = |row: &&&Interface| log(if is_stress { row.shear_strength } else { row.friction_coefficient });
    let load = |row: &&&Interface| match row.load > 0.0 {
        true => log(row.load.min(LARGEST_ROW_PRESSURE * area)),
        false => log(ROW_PRESSURE * area),
    };
    let n = alike.len() as f64;
    let mean = alike.iter().map(value).sum::<f64>() / n;
    let square: f64 = alike.iter().map(|row| (value(row) - mean) * (value(row) - mean)).sum();
    // The spread of so few rows, about a mean that is not known better.
    let spread = if n > 1.0 { (square / (n - 1.0) * (1.0 + 1.0 / n)).sqrt() } else { 0.0 };
    let load = if is_stress { f64::NAN } else { exp(alike.iter().map(load).sum::<f64>() / n) };
    (mean, deviation(factor).max(spread), load, is_stress)
}
