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
    answered: bool,
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

    /// What part of the surfaces has a compiled law that tells of a larger error, and the largest told.
    pub fn table_errors(&self, accuracy: f64) -> (f64, f64) {
        let told: Vec<f64> = self.answers().map(|(_, answer)| answer.table_error).collect();
        let over = told.iter().filter(|&&error| error > accuracy).count();
        (over as f64 / told.len().max(1) as f64, told.iter().fold(0.0, |worst: f64, &error| worst.max(error)))
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

    /// Worst error, refused surfaces, slowest call over alpha and beta, each with its scale and the limit on it.
    pub fn picture(&self, accuracy: f64, longest: Duration) -> String {
        let mut cells = vec![[Cell::default(); CELLS]; CELLS];
        let (mut refused, mut needless) = (Vec::new(), 0);
        for (surface, outcome) in &self.sets {
            let (x, y) = (part_of(surface.alpha, ALPHA), part_of(surface.beta, BETA));
            let index = |part: f64| ((CELLS as f64 * part) as usize).min(CELLS - 1);
            let cell = &mut cells[index(y)][index(x)];
            match outcome {
                Outcome::Answered(answer) => {
                    cell.answered = true;
                    cell.error = cell.error.max(answer.worst());
                    cell.slowest = cell.slowest.max(answer.slowest.as_secs_f64());
                }
                Outcome::Refused { founded, .. } => {
                    refused.push((x, y));
                    needless += u32::from(!founded);
                }
            }
        }
        let limit = longest.as_secs_f64();
        let errors = Scale { from: 1e-16, to: accuracy * 10.0, limit: accuracy, unit: "" };
        let times = Scale { from: 1e-3, to: limit * 10.0, limit, unit: " s" };
        let (width, height) = (2.0 * MARGIN + SIDE, 3.0 * HEIGHT);
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"DejaVu Sans, sans-serif\" \
             font-size=\"11\">\n<rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n"
        );
        // One panel below the other: a telephone shows them with readable letters.
        begin_panel(&mut svg, 0.0, "Largest relative error of any quantity [–]");
        draw_cells(&mut svg, &cells, |cell| errors.colour(cell.error));
        errors.draw(&mut svg);
        end_panel(&mut svg);
        begin_panel(&mut svg, 1.0, "Surfaces refused");
        for (x, y) in &refused {
            let (x, y) = (MARGIN + SIDE * x, TOP + SIDE * (1.0 - y));
            let _ = writeln!(svg, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2.5\" fill=\"{OVER}\"/>");
        }
        let count = format!("{} of {}, {needless} of them without need", refused.len(), self.sets.len());
        write_text(&mut svg, MARGIN, TOP + SIDE + 50.0, "start", &count);
        end_panel(&mut svg);
        begin_panel(&mut svg, 2.0, "Slowest call");
        draw_cells(&mut svg, &cells, |cell| times.colour(cell.slowest));
        times.draw(&mut svg);
        end_panel(&mut svg);
        svg.push_str("</svg>\n");
        svg
    }
}

// ---- The picture ----

const ALPHA: (f64, f64) = (1e-4, 1.0);
const BETA: (f64, f64) = (1.0, 1e7);
const SIDE: f64 = 224.0;
const MARGIN: f64 = 48.0;
const TOP: f64 = 34.0;
const HEIGHT: f64 = 356.0;
/// Of what exceeds its limit, or is refused.
const OVER: &str = "#d55e00";
/// From small to large: light to dark in grey too, and apart for those who do not see all colours.
const COLOURS: [[f64; 3]; 5] =
    [[253.0, 231.0, 37.0], [94.0, 201.0, 98.0], [33.0, 145.0, 140.0], [59.0, 82.0, 139.0], [68.0, 1.0, 84.0]];

/// Where a value lies between two others on a logarithmic axis, 0 to 1.
fn part_of(x: f64, (from, to): (f64, f64)) -> f64 {
    ((x / from).ln() / (to / from).ln()).clamp(0.0, 1.0)
}

/// A logarithmic scale of colours.
struct Scale {
    from: f64,
    to: f64,
    limit: f64,
    unit: &'static str,
}

impl Scale {
    fn colour(&self, x: f64) -> String {
        if x > self.limit {
            return OVER.to_string();
        }
        let at = part_of(x, (self.from, self.limit)) * (COLOURS.len() - 1) as f64;
        let index = (at as usize).min(COLOURS.len() - 2);
        let mix = |i: usize| COLOURS[index][i] + (COLOURS[index + 1][i] - COLOURS[index][i]) * (at - index as f64);
        format!("#{:02x}{:02x}{:02x}", mix(0) as u8, mix(1) as u8, mix(2) as u8)
    }

    /// The scale below a panel, with a tick at every decade or second one, and the limit.
    fn draw(&self, svg: &mut String) {
        const STEPS: usize = 112;
        let (top, width) = (TOP + SIDE + 40.0, SIDE / STEPS as f64);
        for step in 0..STEPS {
            let x = self.from * (self.to / self.from).powf((step as f64 + 0.5) / STEPS as f64);
            let _ = writeln!(
                svg,
                "<rect x=\"{:.1}\" y=\"{top}\" width=\"{:.1}\" height=\"10\" fill=\"{}\"/>",
                MARGIN + width * step as f64,
                width + 0.3,
                self.colour(x)
            );
        }
        let (first, last) = (self.from.log10().round() as i32, self.to.log10().round() as i32);
        for decade in (first..=last).step_by(if last - first > 5 { 2 } else { 1 }) {
            let x = MARGIN + SIDE * part_of(10f64.powi(decade), (self.from, self.to));
            write_text(svg, x, top + 22.0, "middle", &format!("{}{}", power_of_ten(decade), self.unit));
        }
        let x = MARGIN + SIDE * part_of(self.limit, (self.from, self.to));
        let _ = writeln!(
            svg,
            "<line x1=\"{x:.1}\" x2=\"{x:.1}\" y1=\"{}\" y2=\"{}\" stroke=\"black\" stroke-width=\"1.5\"/>",
            top - 3.0,
            top + 13.0
        );
        let promise = format!("promised: at most {}{}", power_of_ten(self.limit.log10().round() as i32), self.unit);
        write_text(svg, MARGIN + SIDE, top + 38.0, "end", &promise);
    }
}

fn power_of_ten(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    match exponent {
        0 => "1".to_string(),
        1 => "10".to_string(),
        _ => {
            let digits = exponent.unsigned_abs().to_string();
            let raised: String = digits.bytes().map(|digit| DIGITS[usize::from(digit - b'0')]).collect();
            format!("10{}{raised}", if exponent < 0 { "⁻" } else { "" })
        }
    }
}

fn write_text(svg: &mut String, x: f64, y: f64, anchor: &str, text: &str) {
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{text}</text>");
}

fn draw_cells(svg: &mut String, cells: &[[Cell; CELLS]], colour: impl Fn(&Cell) -> String) {
    let size = SIDE / CELLS as f64;
    for (row, cells) in cells.iter().enumerate() {
        for (column, cell) in cells.iter().enumerate().filter(|(_, cell)| cell.answered) {
            let (x, y) = (MARGIN + size * column as f64, TOP + SIDE - size * (row + 1) as f64);
            let _ = writeln!(
                svg,
                "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{size}\" height=\"{size}\" fill=\"{}\"/>",
                colour(cell)
            );
        }
    }
}

/// What is drawn until the end of a panel lies below the panels before it.
fn begin_panel(svg: &mut String, panel: f64, title: &str) {
    let _ = writeln!(svg, "<g transform=\"translate(0 {})\">", panel * HEIGHT);
    let _ = writeln!(svg, "<text x=\"{MARGIN}\" y=\"{}\" font-weight=\"bold\">{title}</text>", TOP - 12.0);
}

/// The axes of a panel, over what it shows.
fn end_panel(svg: &mut String) {
    let _ = writeln!(
        svg,
        "<rect x=\"{MARGIN}\" y=\"{TOP}\" width=\"{SIDE}\" height=\"{SIDE}\" fill=\"none\" stroke=\"#333\"/>"
    );
    for decade in (-4..=0).step_by(2) {
        let x = MARGIN + SIDE * part_of(10f64.powi(decade), ALPHA);
        write_text(svg, x, TOP + SIDE + 14.0, "middle", &power_of_ten(decade));
    }
    write_text(svg, MARGIN + SIDE / 2.0, TOP + SIDE + 28.0, "middle", "α = (σ/R)^½ [–]");
    for decade in (0..=6).step_by(2) {
        let y = TOP + SIDE * (1.0 - part_of(10f64.powi(decade), BETA));
        write_text(svg, MARGIN - 5.0, y + 4.0, "end", &power_of_ten(decade));
    }
    let (x, y) = (12.0, TOP + SIDE / 2.0);
    let _ = writeln!(
        svg,
        "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" transform=\"rotate(-90 {x} {y})\">β = (Rσ)^½/b [–]</text>"
    );
    svg.push_str("</g>\n");
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
