//! What came of each surface of the box: counts, worst errors, the slowest call, as a table and as a picture.

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
}

impl Answer {
    pub fn note(&mut self, name: &'static str, load: f64, error: f64) {
        let worst = self.errors.entry(name).or_insert((0.0, load));
        if error.is_nan() || error > worst.0 {
            *worst = (if error.is_nan() { f64::INFINITY } else { error }, load);
        }
    }

    fn worst(&self) -> f64 {
        self.errors.values().map(|worst| worst.0).fold(0.0, f64::max)
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

/// Cells of the picture along an axis.
const CELLS: usize = 28;

#[derive(Clone, Copy, Default)]
struct Cell {
    sets: u32,
    refused: u32,
    error: f64,
    slowest: f64,
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

    /// Worst error, share answered, slowest call over alpha and beta.
    pub fn picture(&self) -> String {
        let mut cells = vec![[Cell::default(); CELLS]; CELLS];
        let place =
            |x: f64, from: f64, to: f64| ((CELLS as f64 * (x / from).ln() / (to / from).ln()) as usize).min(CELLS - 1);
        for (surface, outcome) in &self.sets {
            let cell = &mut cells[place(surface.beta, 1.0, 1e7)][place(surface.alpha, 1e-4, 1.0)];
            cell.sets += 1;
            match outcome {
                Outcome::Answered(answer) => {
                    cell.error = cell.error.max(answer.worst());
                    cell.slowest = cell.slowest.max(answer.slowest.as_secs_f64());
                }
                Outcome::Refused { .. } => cell.refused += 1,
            }
        }
        let (size, margin, gap) = (8, 46, 60);
        let side = size * CELLS;
        let (width, height) = (3 * side + 2 * gap + 2 * margin, side + 2 * margin + 20);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\" \
             font-size=\"11\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
        );
        // Each panel: what it shows, and the shade of a cell between 0 and 1.
        type Shade = fn(&Cell) -> Option<f64>;
        let panels: [(&str, &str, Shade); 3] = [
            ("worst error, any quantity", "white 1e-14, black 1e-8", |cell| {
                (cell.sets > cell.refused).then(|| ((cell.error.max(1e-16).log10() + 14.0) / 6.0).clamp(0.0, 1.0))
            }),
            ("share refused", "white none, black all", |cell| Some(f64::from(cell.refused) / f64::from(cell.sets))),
            ("slowest call", "white 1 ms, black 1 s", |cell| {
                (cell.sets > cell.refused).then(|| ((cell.slowest.max(1e-6).log10() + 3.0) / 3.0).clamp(0.0, 1.0))
            }),
        ];
        for (index, (title, legend, shade)) in panels.into_iter().enumerate() {
            let left = margin + index * (side + gap);
            let top = margin;
            let _ = writeln!(svg, "<text x=\"{left}\" y=\"{}\" font-weight=\"bold\">{title}</text>", top - 20);
            let _ = writeln!(svg, "<text x=\"{left}\" y=\"{}\" fill=\"#555\">{legend}</text>", top - 6);
            for (row, cells) in cells.iter().enumerate() {
                for (column, cell) in cells.iter().enumerate() {
                    let fill = match shade(cell) {
                        _ if cell.sets == 0 => "none".to_string(),
                        None => "#f2d7c9".to_string(),
                        Some(x) => {
                            let tone = |from: f64, to: f64| (from + (to - from) * x) as u8;
                            format!("#{:02x}{:02x}{:02x}", tone(255.0, 10.0), tone(255.0, 30.0), tone(255.0, 60.0))
                        }
                    };
                    let (x, y) = (left + column * size, top + (CELLS - 1 - row) * size);
                    let _ =
                        writeln!(svg, "<rect x=\"{x}\" y=\"{y}\" width=\"{size}\" height=\"{size}\" fill=\"{fill}\"/>");
                }
            }
            let _ = writeln!(
                svg,
                "<rect x=\"{left}\" y=\"{top}\" width=\"{side}\" height=\"{side}\" fill=\"none\" stroke=\"#333\"/>"
            );
            for decade in 0..=4 {
                let x = left + side * decade / 4;
                let label = ["1e-4", "1e-3", "0.01", "0.1", "1"][decade];
                let _ =
                    writeln!(svg, "<text x=\"{x}\" y=\"{}\" text-anchor=\"middle\">{label}</text>", top + side + 14);
            }
            let _ = writeln!(
                svg,
                "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">alpha</text>",
                left + side / 2,
                top + side + 30
            );
            for decade in 0..=7 {
                let y = top + side - side * decade / 7 + 4;
                let _ = writeln!(svg, "<text x=\"{}\" y=\"{y}\" text-anchor=\"end\">1e{decade}</text>", left - 4);
            }
            let _ = writeln!(svg, "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">beta</text>", left - 4, top - 8);
        }
        svg.push_str("</svg>\n");
        svg
    }
}

/// A surface as a person reads it, with all digits.
fn describe(s: &Surface) -> String {
    let heights = match &s.heights {
        Heights::Gaussian => "Gaussian".to_string(),
        Heights::Weibull { shape, .. } => format!("omega {shape}"),
        Heights::Johnson(curve) => format!("skew {}, kurtosis {}", curve.skew, curve.kurtosis),
        Heights::Table(table) => format!("table {:?} {:?}", table.height, table.density),
    };
    let lambda = (4.5 / std::f64::consts::PI * s.beta * s.gamma * s.gamma * s.b_over_h.powi(3) / s.alpha).cbrt();
    format!(
        "alpha {:e}, beta {:e}, gamma {:e}, b/h {:e} (lambda {lambda:.3}), {heights}, epsilon {}, rho {:e}, attraction {}",
        s.alpha, s.beta, s.gamma, s.b_over_h, s.epsilon, s.rho, s.attraction
    )
}
