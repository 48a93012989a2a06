//! What came of each surface of the box: counts, worst errors, the slowest call, as a table.

use crate::common::second_evaluation::heights::Heights;
use crate::common::second_evaluation::Surface;
use asperity::Error;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::time::Duration;

/// What a surface that is answered shows.
#[derive(Debug, Default)]
pub struct Answer {
    /// The worst error of each quantity, with the load it is at.
    errors: BTreeMap<&'static str, (f64, f64)>,
    pub slowest: Duration,
    pub create: Duration,
    /// A state that was refused though its load is on the branch.
    pub complaint: Option<String>,
    /// States for which the second evaluation did not converge.
    pub unresolved: u32,
    /// What the compiled law tells of its own error.
    pub table_error: f64,
}

impl Answer {
    pub fn note(&mut self, name: &'static str, load: f64, error: f64) {
        let worst = self.errors.entry(name).or_insert((0.0, load));
        if error.is_nan() || error > worst.0 {
            *worst = (if error.is_nan() { f64::INFINITY } else { error }, load);
        }
    }
}

pub enum Outcome {
    Answered(Answer),
    /// `founded` says that the second evaluation bears the reason out.
    Refused {
        error: Error,
        after: Duration,
        founded: bool,
    },
}

#[derive(Default)]
pub struct Map {
    sets: Vec<(Surface, Outcome)>,
}

impl Map {
    pub fn add(&mut self, surface: &Surface, outcome: Outcome) {
        self.sets.push((surface.clone(), outcome));
    }

    fn answers(&self) -> impl Iterator<Item = (&Surface, &Answer)> {
        self.sets.iter().filter_map(|(surface, outcome)| match outcome {
            Outcome::Answered(answer) => Some((surface, answer)),
            Outcome::Refused { .. } => None,
        })
    }

    /// The largest error that a compiled law tells of.
    pub fn table_error(&self) -> f64 {
        self.answers().fold(0.0, |worst: f64, (_, answer)| worst.max(answer.table_error))
    }

    /// What is not as promised.
    pub fn failures(&self, accuracy: f64, longest: Duration) -> Vec<String> {
        let mut failures = Vec::new();
        for (surface, outcome) in &self.sets {
            if let Outcome::Refused { error, founded: false, .. } = outcome {
                failures.push(format!("refused without need, {error}: {}", describe(surface)));
            }
        }
        for (surface, answer) in self.answers() {
            let at = describe(surface);
            for (name, (error, load)) in &answer.errors {
                if *error > accuracy {
                    failures.push(format!("{name} off by {error:.1e} at load {load:e}: {at}"));
                }
            }
            if let Some(complaint) = &answer.complaint {
                failures.push(format!("{complaint}: {at}"));
            }
            if answer.slowest > longest && !cfg!(debug_assertions) {
                failures.push(format!("a call took {:?}: {at}", answer.slowest));
            }
        }
        failures
    }

    /// The table, in Markdown.
    pub fn report(&self, took: Duration) -> String {
        let mut text = String::new();
        let mut refused = BTreeMap::<&str, (usize, Duration, &Surface)>::new();
        for (surface, outcome) in &self.sets {
            if let Outcome::Refused { error, after, .. } = outcome {
                let reason = match error {
                    Error::OutOfRange { name, .. } | Error::InvalidParameter { name, .. } => name,
                    Error::NotConverged { what, .. } => what,
                    _ => "another reason",
                };
                let entry = refused.entry(reason).or_insert((0, Duration::ZERO, surface));
                *entry = (entry.0 + 1, entry.1.max(*after), surface);
            }
        }
        let count = self.sets.len();
        let answered = self.answers().count();
        let share = |part: usize| 100.0 * part as f64 / count as f64;
        let _ = writeln!(text, "{count} surfaces in {:.0} s.\n", took.as_secs_f64());
        let _ = writeln!(text, "| | surfaces | share |\n|---|---|---|");
        let _ = writeln!(text, "| answered | {answered} | {:.2} % |", share(answered));
        for (reason, (number, after, _)) in &refused {
            let _ = writeln!(
                text,
                "| refused: {reason} (after {after:.0?} at most) | {number} | {:.2} % |",
                share(*number)
            );
        }
        let unresolved: u32 = self.answers().map(|(_, answer)| answer.unresolved).sum();
        let _ = writeln!(text, "| states that the second evaluation did not resolve | {unresolved} | |");
        let _ = writeln!(text, "\n| quantity | median | 99 % | worst error | of the surface |\n|---|---|---|---|---|");
        let mut names: Vec<&str> = self.answers().flat_map(|(_, answer)| answer.errors.keys().copied()).collect();
        names.sort_unstable();
        names.dedup();
        for name in names {
            let mut errors: Vec<(f64, &Surface)> =
                self.answers().filter_map(|(s, answer)| Some((answer.errors.get(name)?.0, s))).collect();
            errors.sort_by(|a, b| a.0.total_cmp(&b.0));
            let at = |part: f64| errors[((errors.len() - 1) as f64 * part) as usize].0;
            let (worst, surface) = errors[errors.len() - 1];
            let _ =
                writeln!(text, "| {name} | {:.1e} | {:.1e} | {worst:.1e} | {} |", at(0.5), at(0.99), describe(surface));
        }
        let mut slowest: Vec<(Duration, Duration, &Surface)> =
            self.answers().map(|(s, answer)| (answer.slowest, answer.create, s)).collect();
        slowest.sort_by_key(|entry| entry.0);
        for (reason, (_, _, surface)) in &refused {
            let _ = writeln!(text, "\nRefused for {reason}: {}.", describe(surface));
        }
        if let Some((longest, _, surface)) = slowest.last() {
            let _ = writeln!(text, "\nThe slowest call took {longest:.0?}: {}.", describe(surface));
        }
        let mut creations: Vec<Duration> = slowest.iter().map(|entry| entry.1).collect();
        creations.sort_unstable();
        if let Some(last) = creations.last() {
            let at = |part: f64| creations[((creations.len() - 1) as f64 * part) as usize];
            let _ =
                writeln!(text, "Making a model: median {:.1?}, 99 % {:.0?}, longest {last:.0?}.", at(0.5), at(0.99));
        }
        text
    }
}

/// A surface as a person reads it, with all digits.
fn describe(s: &Surface) -> String {
    let heights = match &s.heights {
        Heights::Gaussian => "Gaussian".to_string(),
        Heights::Weibull { shape, .. } => format!("omega {shape}"),
        Heights::Johnson(curve) => format!("skew {}, kurtosis {}", curve.skew, curve.kurtosis),
        Heights::Table(table) => format!("table {:?} {:?}", table.height, table.density),
        Heights::Scores(table) => format!("at scores {:?} {:?}", table.height, table.slope),
    };
    let lambda = (4.5 / std::f64::consts::PI * s.beta * s.gamma * s.gamma * s.b_over_h.powi(3) / s.alpha).cbrt();
    format!(
        "alpha {:e}, beta {:e}, gamma {:e}, b/h {:e} (lambda {lambda:.3}), {heights}, epsilon {}, rho {:e}, attraction {}",
        s.alpha, s.beta, s.gamma, s.b_over_h, s.epsilon, s.rho, s.attraction
    )
}
