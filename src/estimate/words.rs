//! An estimate for people: the number, its band, what it rests on, what would narrow it.

use super::cases::{hardness_factor, slope_factor, work_factor};
use super::priors::{ALONE, MAYBE_LUBRICATED, USUAL_WORK};
use super::{Answer, Band, Estimate, Rests, Whose, LARGE};
use crate::error::{CalibrationFailure, Error};
use crate::materials::names::text;
use crate::materials::{Bodies, Interface, Material};
use crate::model::calibration::MeasuredPoint;
use crate::model::validity::WARNING_TEXTS;
use crate::numerics::ascending;
use crate::numerics::elementary::{exp, log};
use crate::params::Params;
use std::fmt::{Arguments, Display, Formatter, Write};
use std::ops::RangeInclusive;

/// Shares of the variance below this are not worth a measurement.
const WORTHWHILE: f64 = 0.05;
/// Of more loads not each is looked at for what to measure next.
const MOST_LOOKED_AT: usize = 8;
/// Odds from which on a constant does.
const DOES: f64 = 0.8;
/// Loads less than this apart hardly differ.
const AT_ONE_LOAD: f64 = 1.26;
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
/// With fewer contacts it is told that an answer is of one specimen.
const FEW: f64 = 20.0;
/// More points are told by their number.
const MOST_POINTS_TOLD: usize = 3;

/// Adds words to a text, or a line of them.
macro_rules! begin {
    ($out:expr, $($words:tt)*) => { add($out, format_args!($($words)*)) };
}
macro_rules! tell {
    ($out:expr) => { $out.push('\n') };
    ($out:expr, $($words:tt)*) => { add_line($out, format_args!($($words)*)) };
}

#[inline(never)]
fn add(out: &mut String, words: Arguments) {
    // Writing to a string does not fail.
    let _ = out.write_fmt(words);
}

#[inline(never)]
fn add_line(out: &mut String, words: Arguments) {
    add(out, words);
    out.push('\n');
}

/// Writes it, a line for each load and for each thing to know.
///
/// # Errors
/// Those of loads at which a point was measured.
pub fn write(estimate: &Estimate, answers: &[Answer], warnings: u64) -> Result<String, Error> {
    let mut out = String::new();
    write_answers(estimate, answers, &mut out);
    write_next(estimate, answers, &mut out)?;
    let points = &estimate.described.points;
    let at_points = points.iter().map(|point| estimate.friction_at(point.load)).collect::<Result<Vec<_>, _>>()?;
    write_ground(estimate, answers, &at_points, warnings, &mut out);
    write_outside(estimate, &at_points, &mut out);
    Ok(out)
}

fn write_answers(estimate: &Estimate, answers: &[Answer], out: &mut String) {
    match estimate.rests() {
        _ if estimate.is_measured() => {}
        Rests::Rows(rows) => tell!(out, "measured on other specimens: {}", rows_of(rows)),
        Rests::Family(rows) => {
            tell!(out, "measured on other specimens: {}: the alloy itself was not measured", rows_of(rows));
        }
        _ => {}
    }
    for answer in answers {
        write_answer(estimate, answer, out);
        write_specimens(estimate, answer, out);
    }
    write_constant(estimate, answers, out)
}

/// What it rests on, and what is to be checked.
fn write_ground(estimate: &Estimate, answers: &[Answer], at_points: &[Answer], warnings: u64, out: &mut String) {
    write_strength(estimate, at_points, out);
    if estimate.is_of_pressures() {
        tell!(out, "rests on: loads are nominal pressures in Pa: no nominal_area was given");
    }
    write_shape(estimate, answers, out);
    write_roughness(estimate, out);
    write_bodies(estimate, out);
    write_assumed(estimate, out);
    write_points(estimate, out);
    write_units(estimate, answers, out);
    if estimate.described.yields() {
        let index = Figures(estimate.described.params.plasticity_index());
        tell!(out, "rests on: asperities yield, plasticity index {index}: elastic-plastic law, without adhesion");
    }
    match &estimate.curve.failure {
        Some(Error::Uncalibrated { load, number, reason: CalibrationFailure::Strength, .. }) => {
            let [load, most] = [*load, *number / *load].map(Figures);
            tell!(
                out,
                "check: not the shear of contacts: at {load} {} a strength below the shear modulus gives at most {most}; a solver gets no \
                 curve of this",
                estimate.unit()
            );
        }
        Some(error) => tell!(out, "check: a solver gets no curve of this: {error}"),
        None => {}
    }
    for (name, _, says) in WARNING_TEXTS.iter().filter(|(_, bit, _)| warnings & bit != 0) {
        tell!(out, "warning: {}: {}", text(name), text(says));
    }
}

fn write_answer(estimate: &Estimate, answer: &Answer, out: &mut String) {
    let Answer { load, friction, force, curve, .. } = *answer;
    let [at, mu, low, high] = [load, friction.value, friction.low, friction.high].map(Figures);
    let unit = estimate.unit();
    if friction.value == 0.0 {
        return tell!(out, "mu({at} {unit}) = 0: the surfaces are apart");
    }
    if load <= 0.0 {
        begin!(out, "mu({at} {unit}) has no limit: ");
        let adheres = estimate.curve.params.work_of_adhesion > 0.0;
        if force.value == 0.0 && adheres {
            return tell!(out, "the tallest asperities adhere, how many depends on the nominal area");
        }
        if force.value == 0.0 {
            return tell!(out, "it grows as the load goes to 0, where friction is 0");
        }
        let specimen = if is_few(answer) { " one specimen" } else { "" };
        let [value, low, high] = [force.value, force.low, force.high].map(Figures);
        begin!(out, "adhesion gives{specimen} a friction force of {value} {unit}");
        let part = percent(estimate.described.coverage);
        if force.low < force.high {
            begin!(out, ", {part} % band {low} to {high}");
        }
        let may_be_none = estimate.laws.iter().any(|law| law.works.iter().any(|work| work.work == 0.0));
        return tell!(out, "{}", if may_be_none { ", if there is any" } else { "" });
    }
    let part = percent(estimate.described.coverage);
    match (estimate.rests(), estimate.is_measured()) {
        _ if friction.low == friction.high => {
            tell!(out, "mu({at} {unit}) = {mu}, no band: all inputs count as known");
        }
        (Rests::Metals | Rests::Others | Rests::GivenByDefault, false) => {
            tell!(out, "not measured: mu({at} {unit}) about {mu}, {low} to {high}");
        }
        _ => tell!(out, "mu({at} {unit}) = {mu}, {part} % band {low} to {high}"),
    }
    let shown = figures(curve);
    if !curve.is_nan() && shown != figures(friction.value) {
        let off = percent(((curve / friction.value - 1.0) * 1e3).round() * 1e-3);
        let of = if answer.whose == Whose::Many { "" } else { ": it is of the mean of many specimens" };
        tell!(out, "a solver's curve has {shown} at {at} {unit}, {off} % off this{of}");
    }
}

/// How probable it is that a constant coefficient does.
fn write_constant(estimate: &Estimate, answers: &[Answer], out: &mut String) {
    if !estimate.is_measured() || estimate.strength.load <= 0.0 {
        return;
    }
    let (constant, measured, unit) = (Figures(exp(estimate.strength.mean)), estimate.strength.load, estimate.unit());
    let is_apart = |answer: &&Answer| answer.load > 0.0 && (answer.load / measured - 1.0).abs() > 0.01;
    for answer in answers.iter().filter(is_apart).take(MOST_LOOKED_AT) {
        let (load, odds) = (Figures(answer.load), answer.constant_odds);
        match odds > DOES {
            true => tell!(out, "a constant does at {load} {unit}: within 10 % of {constant}, odds {}", odds_of(odds)),
            false => tell!(out, "within 10 % of the constant {constant} at {load} {unit}: odds {}", odds_of(odds)),
        }
    }
}

/// What makes the most of the variance, and what would make it less.
fn write_next(estimate: &Estimate, answers: &[Answer], out: &mut String) -> Result<(), Error> {
    // Without a band the shares are 0.
    let banded: Vec<&Answer> = answers.iter().filter(|answer| answer.friction.low < answer.friction.high).collect();
    let width = |answer: &&&Answer| answer.friction.high / answer.friction.low;
    let Some(widest) = banded.iter().max_by(|one, other| width(one).total_cmp(&width(other))) else { return Ok(()) };
    let of = &widest.shares;
    let shares = [
        (of.strength, "the strength of the interface"),
        (of.size, "how the strength depends on the size of contacts"),
        (of.pressure, "how the strength grows with pressure"),
        (of.adhesion, "adhesion"),
        (of.hardness, "whether and how asperities yield"),
        (of.slope, "the slope of the surface"),
        (of.measurement, "the errors of the measured points"),
        (of.model - of.shape, "how real interfaces leave the law between loads"),
        (of.shape, "what is not told of the shape of the heights"),
        (of.specimen, "which asperities a specimen happens to have"),
    ];
    let (load, unit) = (Figures(widest.load), estimate.unit());
    let order = ascending(&shares.map(|(share, _)| share));
    let (share, what) = shares[order[order.len() - 1]];
    tell!(out, "dominated by: {what} ({:.0} % of the variance at {load} {unit})", 100.0 * share);
    let mut remedies = Vec::new();
    let loads: Vec<f64> = banded.iter().map(|answer| answer.load).take(MOST_LOOKED_AT).collect();
    if let Some((load, gain)) = estimate.next_point(&loads)? {
        let all = ["one measured friction coefficient", "a second measured point", "one more measured point"];
        let count = all[estimate.described.points.len().min(2)];
        remedies.push((gain, format!("{count} at {} {}", Figures(load), estimate.unit())));
    }
    let slope = match &estimate.described.machined {
        Some(machined) if !machined.has_height && !machined.has_slope => "the profile: Ra or Rq, and RSm",
        Some(machined) if !machined.has_height => "the height of the profile: Ra or Rq",
        Some(machined) if !machined.has_slope => "the mean width of the elements of the profile: RSm",
        _ => "the slope of the surface: [known_to] slope, where it is known better than to a factor of 1.5",
    };
    let inputs = [(5, slope), (3, "adhesion: work_of_adhesion"), (4, "the hardness: hardness")];
    remedies.extend(inputs.map(|(i, what)| (shares[i].0, what.to_owned())));
    let order = ascending(&remedies.iter().map(|(share, _)| -share).collect::<Vec<_>>());
    for (share, remedy) in order.into_iter().map(|i| &remedies[i]).filter(|(share, _)| *share >= WORTHWHILE) {
        tell!(out, "to narrow it: {remedy} ({:.0} % of the variance)", 100.0 * share);
    }
    Ok(())
}

/// Measured points outside the band at their loads.
fn write_outside(estimate: &Estimate, at_points: &[Answer], out: &mut String) {
    if estimate.described.measured_on.is_some() {
        return;
    }
    let ratio = |point: &MeasuredPoint| point.force / point.load;
    let is_outside = |(point, answer): &(&MeasuredPoint, &Answer)| {
        point.load > 0.0 && !(answer.friction.low..=answer.friction.high).contains(&ratio(point))
    };
    let outside: Vec<_> = estimate.described.points.iter().zip(at_points).filter(is_outside).collect();
    let unit = estimate.unit();
    for (point, answer) in outside.iter().take(MOST_POINTS_TOLD) {
        let off = (log(ratio(point) / answer.friction.value) / point.error).abs();
        let [ratio, load, off] = [ratio(point), point.load, off].map(Figures);
        let [low, high] = [answer.friction.low, answer.friction.high].map(Figures);
        tell!(
            out,
            "check: the measured {ratio} at {load} {unit} is outside the band {low} to {high}, {off} of its errors from the value: the \
             band is that of the mean, and the points scatter"
        );
    }
    if outside.len() > MOST_POINTS_TOLD {
        tell!(out, "check: so are {} more of the measured points", outside.len() - MOST_POINTS_TOLD);
    }
}

/// The least and the largest of some numbers.
fn ends(numbers: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    [numbers.clone().fold(f64::INFINITY, f64::min), numbers.fold(f64::NEG_INFINITY, f64::max)]
}

fn is_few(answer: &Answer) -> bool {
    answer.whose != Whose::Many && answer.contacts < FEW
}

/// Of which specimen an answer is where they differ.
fn write_specimens(estimate: &Estimate, answer: &Answer, out: &mut String) {
    let Answer { load, another, whose, .. } = *answer;
    let [at, contacts] = [load, answer.contacts].map(Figures);
    let unit = estimate.unit();
    let [value, low, high] = [another.value, another.low, another.high].map(|force| Figures(force / load));
    match whose {
        _ if load <= 0.0 || answer.friction.value == 0.0 => {}
        Whose::Measured => tell!(
            out,
            "few contacts: {contacts} asperities touch at {at} {unit}: this is of the specimen that was measured; another one has {value}, {low} to {high}"
        ),
        Whose::Any if is_few(answer) => {
            tell!(out, "few contacts: {contacts} asperities touch at {at} {unit}: this is of one specimen, whichever it is")
        }
        _ => {}
    }
}

fn write_strength(estimate: &Estimate, at_points: &[Answer], out: &mut String) {
    let (factor, unit) = (Figures(estimate.strength.factor()), estimate.unit());
    let median = Figures(exp(estimate.strength.mean));
    begin!(out, "rests on: strength of the interface: ");
    if !estimate.is_measured() {
        return match estimate.rests() {
            Rests::Metals => {
                tell!(out, "not measured: that of dry metals, {median} to a factor of {factor} either way");
                let (median, factor) = MAYBE_LUBRICATED;
                tell!(out, "check: is it dry? Where a lubricant may be, metals have {median} to a factor of {factor} either way")
            }
            Rests::Others => {
                tell!(out, "not measured: {median} to a factor of {factor} either way, as dry solids have")
            }
            Rests::Rows(rows) | Rests::Family(rows) => {
                let which = match rows[..] {
                    [row] => format!("{} of the table", text(row.name)),
                    _ => format!("the {} rows of these bodies in the table", rows.len()),
                };
                tell!(out, "from {which} of interfaces, to a factor of {factor} either way")
            }
            Rests::Given => tell!(out, "as given"),
            Rests::GivenByDefault => {
                tell!(out, "not measured: slip stresses as given, to a factor of {factor} either way")
            }
        };
    }
    let points = &estimate.described.points;
    let told = |point: &MeasuredPoint| {
        let [load, force, ratio] = [point.load, point.force, point.force / point.load].map(Figures);
        let error = percent(point.error);
        match point.load > 0.0 {
            true => format!("{ratio} at {load} {unit} to {error} %"),
            false => format!("{force} {unit} at {load} {unit} to {error} %"),
        }
    };
    if points.len() > MOST_POINTS_TOLD {
        let [lightest, heaviest] = ends(points.iter().map(|point| point.load)).map(Figures);
        tell!(out, "measured here, {} points from {lightest} {unit} to {heaviest} {unit}", points.len());
    } else {
        tell!(out, "measured here, {}", points.iter().map(told).collect::<Vec<_>>().join(", "));
    }
    if estimate.leaves_law > 0.5 {
        let off = |(point, answer): (&MeasuredPoint, &Answer)| {
            (point.load > 0.0 && answer.curve > 0.0)
                .then(|| (point.load, answer.curve * point.load / point.force - 1.0))
        };
        let misses = points.iter().zip(at_points).filter_map(off);
        if let Some((load, off)) = misses.max_by(|one, other| one.1.abs().total_cmp(&other.1.abs())) {
            let (load, off) = (Figures(load), 100.0 * off.abs());
            tell!(
                out,
                "check: the points change faster than the law; a solver's curve misses them by {off:.0} % at {load} {unit}: is the load in \
                 N, is there wear or a lubricant?"
            );
        }
    }
    if estimate.growth > 1.0 {
        let (apart, times) = (apart_at_one_load(points), Figures(estimate.growth));
        match apart > estimate.growth {
            true => tell!(out, "check: points at one load differ by {} of their errors: the band is wider for it", Figures(apart)),
            false => tell!(out, "check: no law has all points, unless their errors are {times} times as large: the band is wider for it"),
        }
    }
    match estimate.described.specimens {
        Some(1.0) => tell!(out, "rests on: measured on 1 specimen"),
        Some(count) => tell!(
            out,
            "rests on: measured on {} specimens: the scatter between them over its root is in the band",
            Figures(count)
        ),
        None => {}
    }
    let is_asked = |answer: &&Answer| answer.contacts < FEW && estimate.described.specimens.is_none();
    for answer in at_points.iter().filter(is_asked).take(1) {
        let [load, contacts] = [answer.load, answer.contacts].map(Figures);
        let taken = if estimate.described.is_of_law { "a model has" } else { "specimens have on the mean" };
        tell!(
            out,
            "check: {contacts} asperities touch at the measured {load} N: on how many specimens was it measured? Give specimens = 1 if on one; it \
             is taken for what {taken}"
        );
    }
}

/// By how many of their errors points differ whose loads hardly do.
fn apart_at_one_load(points: &[MeasuredPoint]) -> f64 {
    let ratio = |point: &MeasuredPoint| point.force / if point.load > 0.0 { point.load } else { 1.0 };
    let mut most = 0.0_f64;
    for (i, one) in points.iter().enumerate() {
        for other in &points[..i] {
            let is_near = one.load == other.load || (1.0 / AT_ONE_LOAD..AT_ONE_LOAD).contains(&(one.load / other.load));
            if is_near {
                let off = log(ratio(one) / ratio(other)).abs();
                most = most.max(off / (one.error * one.error + other.error * other.error).sqrt());
            }
        }
    }
    most
}

/// What is taken of the bodies by their names.
fn write_bodies(estimate: &Estimate, out: &mut String) {
    let described = &estimate.described;
    let write_elastic = |of: &str, out: &mut String| {
        tell!(out, "rests on: elastic asperities: the hardness{of} is not known, give it if they yield")
    };
    let Some(bodies) = &described.bodies else {
        let is_known = described.has_hardness || described.params.hardness > 0.0;
        return if is_known {
        } else {
            write_elastic("", out)
        };
    };
    let Bodies { first, second } = *bodies;
    if !described.has_moduli {
        let of = |body: &'static Material| {
            let (young, poisson, name) = (stress(body.young), body.poisson, text(body.name));
            format!("E = {young} and nu = {poisson} of {name}")
        };
        let other = if std::ptr::eq(first, second) { String::new() } else { format!(", {}", of(second)) };
        tell!(out, "rests on: {}{other}", of(first));
    }
    if !described.has_adhesion && described.params.work_of_adhesion > 0.0 && !described.yields() {
        match bodies.pair() {
            Some(pair) => {
                let work = Figures(pair.work_of_adhesion);
                begin!(out, "rests on: work of adhesion {work} J/m^2 of {}", text(pair.name));
                let [least, most] = pair.work_of_adhesion_range;
                if most > least {
                    begin!(out, ", measured and estimated {} to {}", Figures(least), Figures(most));
                }
            }
            None => {
                let names = [first.name, second.name].map(text).join("/");
                begin!(out, "rests on: work of adhesion {USUAL_WORK} J/m^2, as of what adsorbs in air: none is known of {names}");
            }
        }
        tell!(out, ", or none");
    }
    if described.has_hardness {
        return;
    }
    let softer = bodies.softer();
    let name = text(softer.name);
    if softer.hardness == 0.0 {
        return write_elastic(&format!(" of {name}"), out);
    }
    if !described.law_is_open || estimate.laws.len() == 1 && !described.yields() {
        return;
    }
    let of = if softer.state.is_empty() { String::new() } else { format!(", {}", softer.state) };
    tell!(out, "rests on: hardness = {} of {name}{of}", stress(softer.hardness))
}

/// What was taken of what is not known, in a line.
fn write_assumed(estimate: &Estimate, out: &mut String) {
    let described = &estimate.described;
    let params = &estimate.curve.params;
    let mut parts = Vec::new();
    let class = described.class.called;
    let size = Figures(estimate.size.unwrap_or_else(|| estimate.mean_of(|node| node.size)));
    parts.push(match estimate.size {
        None => format!("{class} (size effect {size})"),
        Some(_) => format!("{class}, size effect {size} as given"),
    });
    if params.is_of_many() {
        let slope = if described.machined.is_some() { params.rms_slope / 2.0_f64.sqrt() } else { params.rms_slope };
        let factor = Figures(slope_factor(described, described.machined.as_ref()));
        let slope = if slope > 0.0 { format!(" {}", Figures(slope)) } else { String::new() };
        parts.push(format!("slope{slope} to a factor of {factor}"));
    }
    if described.yields() && hardness_factor(described) > 1.0 {
        parts.push(format!("hardness to a factor of {}", Figures(hardness_factor(described))));
    }
    let [work, factor] = [params.work_of_adhesion, work_factor(described)].map(Figures);
    parts.push(match params.work_of_adhesion > 0.0 {
        true if factor.0 > 1.0 => format!("adhesion {work} J/m^2 to a factor of {factor}, or none"),
        true => format!("adhesion {work} J/m^2"),
        false => "no adhesion".to_owned(),
    });
    tell!(out, "assumed: {}", parts.join(", "));
    let is_brittle = |body: &Material| ["glass", "SiO2"].contains(&text(body.name));
    let of_glass = described.bodies.is_some_and(|bodies| is_brittle(bodies.first) || is_brittle(bodies.second));
    if described.measured_on.is_some() && (!described.class.carries_over || of_glass) {
        tell!(
            out,
            "check: of rock, glass and grains a strength does not carry over to another roughness: measured friction rises with roughness \
             there, by interlocking"
        );
    }
    if described.measured_on.is_some() {
        tell!(out, "rests on: the strength in Pa of the specimen of [measured_on]");
    }
}

/// Measured points that are hardly of dry friction.
fn write_points(estimate: &Estimate, out: &mut String) {
    let unit = estimate.unit();
    let points = || estimate.described.points.iter().filter(|point| point.load > 0.0);
    let [lightest, heaviest] = ends(points().map(|point| point.load));
    let [least, most] = ends(points().map(|point| point.force / point.load));
    let is_like = LIKE_A_COEFFICIENT.contains(&lightest) && LIKE_A_COEFFICIENT.contains(&heaviest);
    if most > LARGE {
        let [ratio, part] = [most, 0.01 * most].map(Figures);
        begin!(out, "check: the measured friction coefficient is {ratio}: is it in per cent ({part})?");
        tell!(out, "{}", if is_like { " Or is it the load? A point is [load, coefficient]" } else { "" })
    } else if least < SMALL {
        let least = Figures(least);
        tell!(out, "check: the measured friction coefficient is {least}, dry surfaces have more: is it the load? A point is [load, coefficient]")
    } else if is_like && heaviest > lightest && most / least > APART.max(heaviest / lightest) {
        let [lightest, heaviest, least, most] = [lightest, heaviest, least, most].map(Figures);
        tell!(
            out,
            "check: friction coefficients of {least} to {most} at {lightest} to {heaviest} {unit}: are the two swapped? A point is [load, coefficient]"
        )
    }
}

/// Slips of units that make numbers which no contact has.
fn write_units(estimate: &Estimate, answers: &[Answer], out: &mut String) {
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
            tell!(out, "check: {name} is {}: {says}", Figures(value));
        }
    }
    let Params { nominal_area, hardness, work_of_adhesion, .. } = estimate.curve.params;
    if !estimate.curve.params.is_of_many() {
        return;
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
        tell!(out, "check: the nominal pressure is {shown} Pa, and a steel sheet of 1 mm has {light} Pa: {units}")
    } else if nominal_area > 0.0 && hardness > 0.0 && pressure > hardness {
        tell!(out, "check: the nominal pressure is {shown} Pa, above the hardness, which no contact bears: {units}")
    }
}

/// What is told of the shape of heights, and what a table of it would be worth.
fn write_shape(estimate: &Estimate, answers: &[Answer], out: &mut String) {
    let shape = estimate.described.shape;
    if shape.called.is_empty() {
        return;
    }
    begin!(out, "rests on: roughness: {}", shape.called);
    let worth = |answer: &&Answer| answer.friction.low < answer.friction.high && answer.shares.shape > WORTHWHILE;
    let most = answers.iter().filter(worth).max_by(|one, other| one.shares.shape.total_cmp(&other.shares.shape));
    if let Some(answer) = most.filter(|_| *shape == ALONE) {
        let (Band { value, low, high }, left) = (answer.friction, (1.0 - answer.shares.shape).max(0.0).sqrt());
        let [load, low, high] =
            [answer.load, value * exp(left * log(low / value)), value * exp(left * log(high / value))].map(Figures);
        let unit = estimate.unit();
        begin!(
            out,
            ", as of a Gaussian surface: a table of the height map (heights_at_scores, slopes_at_scores) narrows the band at {load} {unit} to \
             some {low} to {high}"
        );
    }
    tell!(out);
    match &estimate.described.machined {
        Some(machined) if machined.process.leaves_plateaus() => tell!(
            out,
            "check: {} surfaces have plateaus and are not Gaussian: give heights_at_scores, or Spq, Svq and Smq",
            machined.process.name
        ),
        _ => {}
    }
}

fn write_roughness(estimate: &Estimate, out: &mut String) {
    let Some(machined) = &estimate.described.machined else { return };
    let (name, [least, most]) = (machined.process.name, machined.process.mean_deviation.map(|ra| Figures(ra * 1e6)));
    if !machined.has_height {
        tell!(out, "rests on: Ra of {name} surfaces: {least} to {most} um");
    }
    if let Some(ra) = machined.unusual {
        let ra = Figures(ra * 1e6);
        tell!(out, "check: Ra = {ra} um: {name} surfaces have {least} to {most} um: is it of this process, and in m?");
    }
    if !machined.has_slope {
        let (slope, factor) = (Figures(machined.slope), Figures(slope_factor(&estimate.described, Some(machined))));
        tell!(out, "rests on: slope of the profile: {slope} to a factor of {factor}, assumed of machined surfaces");
    }
}

/// Odds as people say them.
fn odds_of(odds: f64) -> String {
    match odds {
        odds if odds < 0.05 => "below 1 in 20".to_owned(),
        odds if odds <= 0.5 => format!("1 in {:.0}", 1.0 / odds),
        odds if odds < 0.95 => format!("{:.0} in 10", 10.0 * odds),
        _ => "above 19 in 20".to_owned(),
    }
}

/// What rows tell: "steel/steel dry 0.57 at 12 N".
fn rows_of(rows: &[&Interface]) -> String {
    let told = |row: &&Interface| {
        let value = match row.friction_coefficient > 0.0 {
            true => figures(row.friction_coefficient),
            false => format!("shear strength {} MPa", figures(row.shear_strength * 1e-6)),
        };
        let at = if row.load > 0.0 { format!(" at {} N", figures(row.load)) } else { String::new() };
        format!("{} {value}{at}", text(row.name))
    };
    rows.iter().map(told).collect::<Vec<_>>().join("; ")
}

/// A modulus or a hardness.
fn stress(pascals: f64) -> String {
    match pascals < 1e9 {
        true => format!("{} MPa", figures(pascals * 1e-6)),
        false => format!("{} GPa", figures(pascals * 1e-9)),
    }
}

/// A part of one in per cent.
fn percent(part: f64) -> String {
    format!("{:.4}", 100.0 * part).trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A number in three figures.
struct Figures(f64);

impl Display for Figures {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        f.write_str(&figures(self.0))
    }
}

/// As people write it.
fn figures(number: f64) -> String {
    if number == 0.0 || !number.is_finite() {
        return number.to_string();
    }
    let scientific = format!("{number:.2e}");
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let short = |digits: &str| match digits.contains('.') {
        true => digits.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => digits.to_owned(),
    };
    match exponent {
        -4..=5 => short(&format!("{number:.*}", usize::try_from(2 - exponent).unwrap_or(0))),
        _ => format!("{}e{exponent}", short(digits)),
    }
}
