//! Parameters as a text, of which reading makes equal ones, bit for bit.

use super::draft::{Draft, AT_SCORES, GAUSSIAN, TABULATED, WEIBULL};
use super::fields::{Field, FIELDS};
use crate::params::Params;
use std::fmt::{Display, Formatter, Result, Write};

/// Whether the measurement that is kept was made on these surfaces: calibrating once more then changes nothing.
pub fn is_of_these_surfaces(params: &Params) -> bool {
    let mut again = params.clone();
    let (load, force) = (params.calibration_load, params.calibration_friction_force);
    force > 0.0 && again.calibrate_force(load, force).is_ok() && again.slip == params.slip
}

/// Writes the fields that are not defaults, the table where the heights are one, and the measurement, which is of these surfaces or
/// of others.
pub fn write(draft: &mut Draft, is_of_these: bool, out: &mut dyn Write) -> Result {
    let units = match draft.params.check_not_converted() {
        Ok(()) => "SI units, unless they were set in others",
        Err(_) => "units of length_unit metres and of force_unit newtons",
    };
    writeln!(out, "# Two rough surfaces in contact, for asperity: {units}, names as in asperity_params.")?;
    let mut default = Draft::default();
    let chooses = is_chosen(draft, &mut default);
    let is_whole = draft.params.unset().is_none();
    for field in FIELDS {
        let number = field.get(draft);
        let is_written = match field.name {
            "height_distribution" => chooses,
            // What an estimate would take in their place.
            "contact_law" | "slip_stress_1" | "slip_stress_2" | "pressure_coefficient" if is_whole => true,
            // Beside it a skew is taken as it is.
            "weibull_shape" if draft.height_distribution == WEIBULL => true,
            _ => number.to_bits() != field.get(&mut default).to_bits(),
        };
        if is_written {
            writeln!(out, "{} = {}", field.name, Written(field, number))?;
        }
    }
    if let (TABULATED | AT_SCORES, Some((height, values))) = (draft.height_distribution, draft.params.heights.table()) {
        write_numbers("table_height", height, out)?;
        write_numbers("table_density", values, out)?;
    }
    let (load, force) = (draft.params.calibration_load, draft.params.calibration_friction_force);
    if is_of_these {
        writeln!(out, "calibration_load = {}", Real(load))?;
        writeln!(out, "calibration_friction_force = {}", Real(force))?;
    } else if force != 0.0 {
        let surfaces = match draft.params.unset() {
            Some(name) => format!("on surfaces of which {name} is not set here"),
            None => "on other surfaces".to_owned(),
        };
        let (force, load) = (Real(force), Real(load));
        writeln!(out, "# The strength was calibrated {surfaces}: a friction force of {force} at a load of {load}.")?;
    }
    Ok(())
}

/// Whether the family of heights must be named: where it is not the default, or another number would choose one.
fn is_chosen(draft: &mut Draft, default: &mut Draft) -> bool {
    let names = ["weibull_shape", "skew", "kurtosis"];
    let mut choose = FIELDS.iter().filter(|field| names.contains(&field.name));
    let differs = choose.any(|field| field.get(draft).to_bits() != field.get(default).to_bits());
    draft.height_distribution != GAUSSIAN || differs
}

fn write_numbers(name: &str, numbers: &[f64], out: &mut dyn Write) -> Result {
    write!(out, "{name} = [")?;
    for (i, number) in numbers.iter().enumerate() {
        write!(out, "{}{}", if i == 0 { "" } else { ", " }, Real(*number))?;
    }
    writeln!(out, "]")
}

/// The value of a field: a word where it has one.
pub struct Written<'a>(pub &'a Field, pub f64);

impl Display for Written<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let Self(field, number) = self;
        match field.words.get(*number as usize) {
            Some(word) if field.is_choice() => Quoted(word).fmt(f),
            Some(word) => f.write_str(word),
            None => Real(*number).fmt(f),
        }
    }
}

/// A number as TOML has it, in the fewest digits that read back as itself.
pub struct Real(pub f64);

impl Display for Real {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 {
            number if number.is_nan() => f.write_str("nan"),
            number => write!(f, "{number:?}"),
        }
    }
}

/// Words as TOML has them.
pub struct Quoted<'a>(pub &'a str);

impl Display for Quoted<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "\"{}\"", self.0.replace('\\', "\\\\").replace('"', "\\\""))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::materials::Bodies;
    use crate::params::ContactLawKind;

    /// What a text leaves open of metal is that it yields, so that the elastic law must be written.
    #[test]
    fn contact_laws_of_metal_read_back_as_they_are() {
        let mut elastic = Params { height_std: 1e-6, summit_radius: 1e-5, asperity_count: 1e5, ..Params::default() };
        elastic.set_bodies(&Bodies::find("steel/steel").expect("bodies")).expect("bodies");
        elastic.work_of_adhesion = 0.0;
        let plastic = Params { contact_law: ContactLawKind::ElasticPlastic, ..elastic.clone() };
        assert!(elastic.plasticity_index() > 1.0);
        for params in [elastic, plastic] {
            assert_eq!(Params::from_toml(&params.to_toml()).expect("a surface"), params);
        }
    }
}
