//! An estimate for people: the number, its band, what it rests on, what would narrow it.

use super::known::SLOPE_FACTOR;
use super::{Answer, Estimate, Rests};
use crate::materials::names::text;
use crate::materials::{Bodies, Interface, Material};
use crate::model::points::MeasuredPoint;
use crate::model::validity::WARNING_TEXTS;
use crate::numerics::elementary::{exp, log};
use crate::params::Params;
use std::fmt::{Display, Formatter, Result, Write};
use std::ops::RangeInclusive;

/// Shares of the variance below this are not worth a measurement.
const WORTHWHILE: f64 = 0.01;
/// Points this many of their errors off the curve, root mean square, are not of its law.
pub const OFF: f64 = 2.0;
/// Clean metals in vacuum and sticky microstructures have friction coefficients of some ones; beyond it is asked for the unit.
const LARGE: f64 = 5.0;
/// Surfaces that slide are less steep: 35 degrees.
const STEEP: f64 = 0.7;
/// Works of adhesion of clean metals are some J/m^2.
const STICKY: f64 = 5.0;
/// The pressure of a steel sheet of 1 mm under its weight [Pa]: where the heaviest load makes less, a unit may be wrong.
const LIGHT: f64 = 77.0;
/// The same of surfaces that adhere, whose friction at lighter loads is asked for [Pa].
const LIGHT_OF_ADHESION: f64 = 1.0;
/// Dry surfaces have more; MoS2 in vacuum and hard carbon may have less.
const SMALL: f64 = 0.01;
/// What looks like a friction coefficient.
const LIKE_A_COEFFICIENT: RangeInclusive<f64> = 1e-3..=2.0;
/// Coefficients that were measured at loads which are less apart are looked at from this ratio on.
const APART: f64 = 3.0;
/// Changes of the friction coefficient below this are not told.
const TOLD: f64 = 0.01;
/// Hardnesses of one material, where no range is known: over that of the table.
const HARDER: [f64; 2] = [0.5, 2.0];
/// With less than one expected contact, the mean friction of specimens over that of a summit that bears the load alone is at most this
/// (python/tests/test_pads.py).
const MOST_OVER_ONE_SUMMIT: f64 = 2.0;
/// More points are told by their number.
const MOST_POINTS_TOLD: usize = 3;

/// Writes it, made of a text, a line for each load and for each thing to know.
pub fn write(estimate: &Estimate, bytes: &[u8], answers: &[Answer], warnings: u64, out: &mut dyn Write) -> Result {
    let of_rows = match estimate.rests() {
        Rests::Rows(rows) if !estimate.strength.is_measured => &rows[..],
        _ => &[],
    };
    if !of_rows.is_empty() {
        writeln!(out, "measured on other specimens: {}", Rows(of_rows))?;
    }
    for answer in answers {
        write_answer(estimate, answer, out)?;
        write_specimens(estimate, answer, out)?;
    }
    write_strength(estimate, out)?;
    if estimate.is_of_pressures() {
        writeln!(out, "rests on: loads are nominal pressures in Pa: no nominal_area was given")?;
    }
    write_roughness(estimate, out)?;
    write_bodies(estimate, bytes, answers, out)?;
    write_points(estimate, out)?;
    write_units(estimate, answers, out)?;
    if estimate.described.yields {
        let index = Figures(estimate.params.plasticity_index());
        writeln!(out, "rests on: asperities yield, plasticity index {index}: elastic-plastic law, without adhesion")?;
    }
    if warnings != 0 {
        let names = WARNING_TEXTS.iter().filter(|(_, bit, _)| warnings & bit != 0).map(|(name, ..)| text(name));
        writeln!(out, "warnings: {}", names.collect::<Vec<_>>().join(", "))?;
    }
    write_remedies(estimate, answers, out)
}

fn write_answer(estimate: &Estimate, answer: &Answer, out: &mut dyn Write) -> Result {
    let Answer { load, friction_coefficient: mu, low, high, friction_force: force, .. } = *answer;
    let [at, mu, low, high] = [load, mu, low, high].map(Figures);
    let unit = estimate.unit();
    if answer.friction_coefficient == 0.0 {
        return writeln!(out, "mu({at} {unit}) = 0: the surfaces are apart");
    }
    if load <= 0.0 {
        write!(out, "mu({at} {unit}) has no limit: ")?;
        return match answer.specimen_force > 0.0 {
            _ if force > 0.0 && !answer.is_few => {
                writeln!(out, "adhesion gives a friction force of {} {unit}", Figures(force))
            }
            true => {
                let [least, most] = [1.0, MOST_OVER_ONE_SUMMIT].map(|times| Figures(times * answer.specimen_force));
                writeln!(
                    out,
                    "a specimen adheres by its tallest summits, with a friction force of {least} to {most} {unit} for this strength"
                )
            }
            false if answer.is_few && estimate.params.work_of_adhesion > 0.0 => {
                writeln!(out, "the tallest summits adhere, how many depends on the nominal area")
            }
            false => writeln!(out, "it grows as the load goes to 0, where friction is 0"),
        };
    }
    if answer.low == answer.high {
        return writeln!(out, "mu({at} {unit}) = {mu}, no band: all inputs count as known");
    }
    match (estimate.rests(), estimate.strength.is_measured) {
        (Rests::Default, false) => writeln!(out, "mu({at} {unit}) = {mu} to an order of magnitude, {low} to {high}"),
        _ => writeln!(out, "mu({at} {unit}) = {mu}, {} % band {low} to {high}", Percent(estimate.described.coverage)),
    }
}

/// What single specimens have where few summits touch, of which a band is that of the mean.
fn write_specimens(estimate: &Estimate, answer: &Answer, out: &mut dyn Write) -> Result {
    if !answer.is_few || answer.load <= 0.0 || answer.contacts.is_nan() {
        return Ok(());
    }
    let Answer { friction_coefficient, low, high, specimen_scatter: scatter, .. } = *answer;
    let mean = answer.specimen_force / answer.load;
    // A band has the strength, all else that is not known, and which specimen it is.
    let of_specimen = |end: f64| (log(end / friction_coefficient).powi(2) + (estimate.reach * scatter).powi(2)).sqrt();
    let [least, most] = match scatter.is_nan() {
        true => [mean * low / friction_coefficient, MOST_OVER_ONE_SUMMIT * mean * high / friction_coefficient],
        false => [mean * exp(-of_specimen(low)), mean * exp(of_specimen(high))],
    };
    let [at, contacts, mean_shown, least, most] = [answer.load, answer.contacts, mean, least, most].map(Figures);
    write!(out, "few contacts: {contacts} summits touch at {at} {}: ", estimate.unit())?;
    if mean.is_nan() {
        writeln!(out, "single specimens differ, by how much is not known: take a heavier load or a larger nominal area")
    } else if scatter.is_nan() {
        writeln!(out, "one specimen stands on one or two, with {least} to {most}: the number above is not its friction")
    } else {
        let scatter = Figures(100.0 * scatter);
        writeln!(
            out,
            "single specimens have {mean_shown} on average, with a standard deviation of {scatter} %: band of one {least} to {most}"
        )
    }
}

fn write_strength(estimate: &Estimate, out: &mut dyn Write) -> Result {
    let (factor, unit) = (Figures(estimate.strength.factor()), estimate.unit());
    write!(out, "rests on: strength of the interface: ")?;
    if !estimate.strength.is_measured {
        return match estimate.rests() {
            Rests::Default => {
                writeln!(out, "a default, not measured: an order of magnitude, a factor of {factor} either way")
            }
            Rests::Rows(rows) => writeln!(out, "from {}, to a factor of {factor} either way", Names(rows)),
            Rests::Pair => writeln!(out, "the slip stress of the table of pairs, to a factor of {factor} either way"),
            Rests::Given => writeln!(out, "as given"),
        };
    }
    let points = &estimate.described.points;
    write!(out, "measured here, ")?;
    match &points[..] {
        _ if points.len() > MOST_POINTS_TOLD => {
            let loads = || points.iter().map(|point| point.load);
            let ends = [loads().fold(f64::INFINITY, f64::min), loads().fold(f64::NEG_INFINITY, f64::max)];
            let [lightest, heaviest] = ends.map(Figures);
            writeln!(out, "{} points from {lightest} {unit} to {heaviest} {unit}", points.len())?;
        }
        some => {
            for (i, point) in some.iter().enumerate() {
                let before = if i > 0 { ", " } else { "" };
                let [load, force, ratio] = [point.load, point.force, point.force / point.load].map(Figures);
                match point.load > 0.0 {
                    true => write!(out, "{before}{ratio} at {load} {unit}")?,
                    false => write!(out, "{before}{force} {unit} at {load} {unit}")?,
                }
                write!(out, " to {} %", Percent(point.error))?;
            }
            writeln!(out)?;
        }
    }
    if points.len() > 1 && estimate.described.pressure_is_free {
        let kappa = estimate.params.pressure_coefficient;
        match estimate.tells_pressure {
            true => writeln!(out, "rests on: pressure coefficient {}, from the measured points", Figures(kappa))?,
            false => writeln!(out, "rests on: pressure coefficient 0: the measured points do not tell it")?,
        }
    }
    if estimate.misfit > OFF {
        writeln!(
            out,
            "check: the measured points are {} of their errors off the law, which cannot follow their trend: the band is wider \
             for it; is the load in N, is there wear or a lubricant?",
            Figures(estimate.misfit)
        )?;
    }
    for point in points {
        if let Some(contacts) = estimate.few_contacts_at(point.load) {
            let [load, contacts] = [point.load, contacts].map(Figures);
            writeln!(
                out,
                "check: {contacts} summits touch at the measured {load} N: the point is of one specimen, and is taken for the mean of \
                 all; measure where 20 or more touch, at a heavier load or on a larger area"
            )?;
        }
    }
    Ok(())
}

/// What is taken of the bodies by their names, and what of it makes the answer.
fn write_bodies(estimate: &Estimate, bytes: &[u8], answers: &[Answer], out: &mut dyn Write) -> Result {
    let described = &estimate.described;
    let write_elastic = |of: &str, out: &mut dyn Write| {
        writeln!(out, "rests on: elastic asperities: the hardness{of} is not known, give it if they yield")
    };
    let Some(bodies) = &described.bodies else {
        let is_known = described.has_hardness || described.params.hardness > 0.0;
        return if is_known { Ok(()) } else { write_elastic("", out) };
    };
    let Bodies { first, second } = *bodies;
    if !described.has_moduli {
        let of = |body: &'static Material| {
            let (young, poisson, name) = (Stress(body.young), body.poisson, text(body.name));
            format!("E = {young} and nu = {poisson} of {name}")
        };
        let other = if std::ptr::eq(first, second) { String::new() } else { format!(", {}", of(second)) };
        writeln!(out, "rests on: {}{other}", of(first))?;
    }
    let work = estimate.params.work_of_adhesion;
    if let Some(pair) = bodies.pair().filter(|_| !described.has_adhesion && work > 0.0) {
        write!(out, "rests on: work of adhesion {} J/m^2 of {}", Figures(work), text(pair.name))?;
        let [least, most] = pair.work_of_adhesion_range;
        match most > least {
            true => writeln!(out, ", measured and estimated {} to {}", Figures(least), Figures(most))?,
            false => writeln!(out)?,
        }
    }
    if described.has_hardness {
        return Ok(());
    }
    let softer = bodies.softer();
    let name = text(softer.name);
    if softer.hardness == 0.0 {
        return write_elastic(&format!(" of {name}"), out);
    }
    let [least, most] = softer.hardness_range;
    let ends = if most > least { [least, most] } else { HARDER.map(|factor| factor * softer.hardness) };
    let mut others = Vec::new();
    if let Some(answer) = answers.iter().find(|answer| answer.load > 0.0 && answer.low > 0.0) {
        for hardness in ends.into_iter().filter(|&hardness| hardness != softer.hardness) {
            let with = Estimate::with_hardness(bytes, answer.load, hardness);
            let changes = |mu: &f64| (mu / answer.friction_coefficient - 1.0).abs() > TOLD;
            others.extend(with.filter(changes).map(|mu| (answer.load, hardness, mu)));
        }
    }
    if others.is_empty() && !described.yields {
        return Ok(());
    }
    write!(out, "rests on: hardness = {} of {name}", Stress(softer.hardness))?;
    if !softer.state.is_empty() {
        write!(out, ", {}", softer.state)?;
    }
    for (i, (load, hardness, mu)) in others.iter().enumerate() {
        let (hardness, mu) = (Stress(*hardness), Figures(*mu));
        match i {
            0 => write!(out, ": with {hardness} mu({} {}) is {mu}", Figures(*load), estimate.unit())?,
            _ => write!(out, ", with {hardness} {mu}")?,
        }
    }
    writeln!(out)
}

/// Measured points that are hardly of dry friction.
fn write_points(estimate: &Estimate, out: &mut dyn Write) -> Result {
    let unit = estimate.unit();
    let ends = |of: fn(&MeasuredPoint) -> f64| {
        let values = || estimate.described.points.iter().filter(|point| point.load > 0.0).map(of);
        [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
    };
    let ([lightest, heaviest], [least, most]) = (ends(|point| point.load), ends(|point| point.force / point.load));
    let is_like = LIKE_A_COEFFICIENT.contains(&lightest) && LIKE_A_COEFFICIENT.contains(&heaviest);
    if most > LARGE {
        let [ratio, part] = [most, 0.01 * most].map(Figures);
        write!(out, "check: the measured friction coefficient is {ratio}: is it in per cent ({part})?")?;
        writeln!(out, "{}", if is_like { " Or is it the load? A point is [load, coefficient]" } else { "" })
    } else if least < SMALL {
        let least = Figures(least);
        writeln!(out, "check: the measured friction coefficient is {least}, dry surfaces have more: is it the load? A point is [load, coefficient]")
    } else if is_like && heaviest > lightest && most / least > APART.max(heaviest / lightest) {
        let [lightest, heaviest, least, most] = [lightest, heaviest, least, most].map(Figures);
        writeln!(
            out,
            "check: friction coefficients of {least} to {most} at {lightest} to {heaviest} {unit}: are the two swapped? A point is [load, coefficient]"
        )
    } else {
        Ok(())
    }
}

/// Slips of units that make numbers which no contact has.
fn write_units(estimate: &Estimate, answers: &[Answer], out: &mut dyn Write) -> Result {
    let points = &estimate.described.points;
    let Params { rms_slope, pressure_coefficient, work_of_adhesion, .. } = estimate.described.params;
    let is_given = estimate.described.machined.as_ref().is_none_or(|machined| machined.has_slope);
    for (name, value, most, says) in [
        (
            "the slope of the surface",
            if is_given { rms_slope } else { 0.0 },
            STEEP,
            "is it in degrees or per cent? It is the tangent of an angle",
        ),
        ("pressure_coefficient", pressure_coefficient, LARGE, "is it in per cent?"),
        ("work_of_adhesion", work_of_adhesion, STICKY, "is it in mJ/m^2?"),
    ] {
        if value > most {
            writeln!(out, "check: {name} is {}: {says}", Figures(value))?;
        }
    }
    let Params { nominal_area, hardness, work_of_adhesion, .. } = estimate.params;
    if !estimate.params.is_of_many() {
        return Ok(());
    }
    let loads = answers.iter().map(|answer| answer.load).chain(points.iter().map(|point| point.load));
    let pressure = loads.fold(0.0, f64::max) / estimate.described.area();
    let units = match (estimate.is_of_pressures(), nominal_area > 0.0) {
        (true, _) => "is load in Pa? Give nominal_area for loads in N",
        (false, true) => "is load in N, and nominal_area in m^2?",
        (false, false) => "is load in N, and asperity_count a number and not a density?",
    };
    let shown = Figures(pressure);
    if pressure > 0.0 && pressure < if work_of_adhesion > 0.0 { LIGHT_OF_ADHESION } else { LIGHT } {
        let light = Figures(LIGHT);
        writeln!(out, "check: the nominal pressure is {shown} Pa, and a steel sheet of 1 mm has {light} Pa: {units}")
    } else if nominal_area > 0.0 && hardness > 0.0 && pressure > hardness {
        writeln!(out, "check: the nominal pressure is {shown} Pa, above the hardness, which no contact bears: {units}")
    } else {
        Ok(())
    }
}

fn write_roughness(estimate: &Estimate, out: &mut dyn Write) -> Result {
    let Some(machined) = &estimate.described.machined else { return Ok(()) };
    let (name, [least, most]) = (machined.process.name, machined.process.mean_deviation.map(|ra| Figures(ra * 1e6)));
    if !machined.has_height {
        writeln!(out, "rests on: Ra of {name} surfaces: {least} to {most} um")?;
    }
    if let Some(ra) = machined.unusual {
        let ra = Figures(ra * 1e6);
        writeln!(
            out,
            "check: Ra = {ra} um: {name} surfaces have {least} to {most} um: is it of this process, and in m?"
        )?;
    }
    if !machined.has_slope {
        let slope = Figures(machined.slope);
        writeln!(
            out,
            "rests on: slope of the profile: {slope} to a factor of {}, assumed of machined surfaces",
            Figures(SLOPE_FACTOR)
        )?;
    }
    Ok(())
}

fn write_remedies(estimate: &Estimate, answers: &[Answer], out: &mut dyn Write) -> Result {
    // Without a band the shares are 0.
    let count = answers.iter().filter(|answer| answer.low < answer.high).count().max(1) as f64;
    let mean = |share: fn(&Answer) -> f64| answers.iter().map(share).sum::<f64>() / count;
    let (strength, roughness, measurement) = (
        mean(|answer| answer.strength_share),
        mean(|answer| answer.roughness_share),
        mean(|answer| answer.measurement_share),
    );
    let mut remedies = Vec::new();
    if !estimate.strength.is_measured {
        remedies.push((strength, "one measured friction coefficient: measured = [[load, coefficient]]"));
    }
    if let Some(machined) = &estimate.described.machined {
        remedies.push((
            roughness,
            match (machined.has_height, machined.has_slope) {
                (true, _) => "the mean width of the elements of the profile: RSm",
                (false, true) => "the height of the profile: Ra or Rq",
                (false, false) => "the profile: Ra or Rq, and RSm",
            },
        ));
    }
    remedies.push((measurement, "more measured points, or more exact ones"));
    remedies.sort_by(|one, other| other.0.total_cmp(&one.0));
    for (share, remedy) in remedies.into_iter().filter(|(share, _)| *share >= WORTHWHILE) {
        writeln!(out, "to narrow it: {remedy} ({:.0} % of the variance)", 100.0 * share)?;
    }
    Ok(())
}

/// What rows tell: "steel/steel dry 0.57 at 12 N".
struct Rows<'a>(&'a [&'static Interface]);

impl Display for Rows<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        for (i, row) in self.0.iter().enumerate() {
            let before = if i > 0 { "; " } else { "" };
            write!(f, "{before}{} ", text(row.name))?;
            match row.friction_coefficient > 0.0 {
                true => write!(f, "{}", Figures(row.friction_coefficient))?,
                false => write!(f, "shear strength {} MPa", Figures(row.shear_strength * 1e-6))?,
            }
            if row.load > 0.0 {
                write!(f, " at {} N", Figures(row.load))?;
            }
        }
        Ok(())
    }
}

/// Which rows.
struct Names<'a>(&'a [&'static Interface]);

impl Display for Names<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let rows = self.0;
        match rows {
            [row] => write!(f, "{} of the table of interfaces", text(row.name)),
            _ => write!(f, "the {} rows of these bodies in the table of interfaces", rows.len()),
        }
    }
}

/// A modulus or a hardness.
struct Stress(f64);

impl Display for Stress {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self.0 < 1e9 {
            true => write!(f, "{} MPa", Figures(self.0 * 1e-6)),
            false => write!(f, "{} GPa", Figures(self.0 * 1e-9)),
        }
    }
}

/// A part of one in per cent.
struct Percent(f64);

impl Display for Percent {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let percent = format!("{:.4}", 100.0 * self.0);
        f.write_str(percent.trim_end_matches('0').trim_end_matches('.'))
    }
}

/// A number in three figures, as people write it.
struct Figures(f64);

impl Display for Figures {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let number = self.0;
        if number == 0.0 || !number.is_finite() {
            return write!(f, "{number}");
        }
        let scientific = format!("{number:.2e}");
        let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let exponent: i32 = exponent.parse().unwrap_or(0);
        let short = |digits: &str| match digits.contains('.') {
            true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
            false => digits.to_owned(),
        };
        match exponent {
            -4..=5 => f.write_str(&short(&format!("{number:.*}", usize::try_from(2 - exponent).unwrap_or(0)))),
            _ => write!(f, "{}e{exponent}", short(digits)),
        }
    }
}
