//! The example in C: its summary, its table, its figure, its command line. `tests/examples/run.sh` compares other languages.

use crate::common::assert_near;
use crate::common::c_compiler::{root, text, Compiler, Language, Linking, Program};
use std::path::Path;

fn example() -> Vec<Program> {
    let source = root().join("c_examples/friction_curve.c");
    let compilers = Compiler::all(Language::C, "c11");
    compilers.into_iter().map(|compiler| compiler.program(&source, Linking::Shared)).collect()
}

/// Load, mu, the ends of its band, friction force, real area, contacts.
fn rows(table: &str) -> Vec<[f64; 7]> {
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("# load [N], mu, low, high, friction force [N], real area [m^2], contacts"));
    let row = |line: &str| -> [f64; 7] {
        let numbers: Vec<f64> = line.split(' ').map(|field| field.parse().expect(line)).collect();
        numbers.try_into().expect(line)
    };
    lines.map(row).collect()
}

fn check_table(rows: &[[f64; 7]]) {
    assert_eq!(rows.len(), 33);
    assert_near(rows[0][0], 1e-4, 1e-9, "the lightest load");
    assert_near(rows[16][0], 0.01, 1e-9, "the measured load");
    assert_near(rows[16][1], 0.3, 1e-9, "the measured coefficient");
    assert_near(rows[32][0], 1.0, 1e-9, "the heaviest load");
    for &[load, mu, low, high, friction, area, contacts] in rows {
        assert_near(mu * load, friction, 2e-9, "mu P");
        assert_near(low * high, mu * mu, 2e-2, "the band is nearly even in ln mu");
        assert!((1.08..2.5).contains(&(high / mu)), "a band of {low} to {high} at {load}");
        assert!((20.0..1e5).contains(&contacts) && area < 0.1 * 1e-8, "{contacts} contacts on {area} at {load}");
    }
    let width = |row: &[f64; 7]| row[3] / row[2];
    assert!(
        width(&rows[0]) > width(&rows[16]) && width(&rows[32]) > width(&rows[16]),
        "narrowest where it was measured"
    );
    for pair in rows.windows(2) {
        assert!(pair[1][1] < pair[0][1], "mu does not fall with load: {pair:?}");
        assert!([0, 4, 5, 6].iter().all(|&k| pair[1][k] > pair[0][k]), "something falls with load: {pair:?}");
    }
}

/// The curve that is drawn is that of the table.
fn check_figure(path: &Path, rows: &[[f64; 7]]) {
    let figure = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert!(figure.starts_with("<svg ") && figure.trim_end().ends_with("</svg>"), "{}", path.display());
    let law =
        figure.split("<path class=\"law\" d=\"M").nth(1).and_then(|rest| rest.split('"').next()).expect("a curve");
    let number = |text: &str| -> f64 { text.parse().expect("a number") };
    let points: Vec<(f64, f64)> = law
        .split(" L")
        .map(|point| point.split_once(' ').expect("two numbers"))
        .map(|(x, y)| (number(x), number(y)))
        .collect();
    assert_eq!(points.len(), rows.len());
    let steps: Vec<f64> = points.windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
    assert!(steps.iter().all(|step| (step - steps[0]).abs() < 0.02), "the load axis is not logarithmic");
    // y is linear in mu.
    let (first, last) = (points[0].1, points[points.len() - 1].1);
    let slope = (last - first) / (rows[rows.len() - 1][1] - rows[0][1]);
    for (point, row) in points.iter().zip(rows) {
        assert!((point.1 - first - slope * (row[1] - rows[0][1])).abs() < 0.02, "the curve is not the table");
    }
}

#[test]
fn its_table_and_figure_are_sound() {
    let figure = Path::new(env!("CARGO_TARGET_TMPDIR")).join("friction_curve.svg");
    for program in example() {
        let rows = rows(&program.succeeds(&["--table", figure.to_str().expect("a path in UTF-8")]));
        check_table(&rows);
        check_figure(&figure, &rows);
        check_figure(&root().join("docs/friction_curve.svg"), &rows);
    }
}

/// Five loads of the table, rounded, and what they mean; nothing to warn of.
#[test]
fn its_summary_is_that_of_the_table() {
    for program in example() {
        let output = program.run(&[]);
        assert_eq!((output.status.code(), text(&output.stderr).as_str()), (Some(0), ""));
        let summary = text(&output.stdout);
        let rows = rows(&program.succeeds(&["--table"]));
        let expected: Vec<String> = rows
            .iter()
            .step_by(8)
            .map(|[load, mu, low, high, _, _, contacts]| {
                format!("{:>10}  {mu:6.3}  {low:6.3}  {high:6.3}  {contacts:9.0}", (load * 1e6).round() / 1e6)
            })
            .collect();
        assert!(summary.contains(&expected.join("\n")), "{summary}");
        let [first, last] = [rows[0][1], rows[32][1]];
        for words in [
            "0.300 at 0.01 N (assumed; measure yours)".to_string(),
            format!("falls from {first:.3} to {last:.3}"),
            format!(
                "{:.0} % low\nat the lowest load and {:.0} % high",
                100.0 * (1.0 - 0.3 / first),
                100.0 * (0.3 / last - 1.0)
            ),
        ] {
            assert!(summary.contains(&words), "no '{words}' in: {summary}");
        }
    }
}

#[test]
fn its_command_line_is_refused_with_a_reason() {
    let nowhere = Path::new(env!("CARGO_TARGET_TMPDIR")).join("none/curve.svg");
    let nowhere = nowhere.to_str().expect("a path in UTF-8");
    let cannot_write = format!("cannot write {nowhere}: No such file");
    let refusals: [(i32, &str, &[&str]); 13] = [
        (2, "LOADS = 1: must be a whole number", &["-", "1"]),
        (2, "LOADS = 2.5: must be a whole number", &["-", "2.5"]),
        (2, "LOADS = 'many': must be a finite number", &["-", "many"]),
        (2, "LOWEST = 0 N: must be > 0", &["-", "5", "0"]),
        (2, "LOWEST = 'nan': must be a finite number", &["-", "5", "nan"]),
        (2, "HIGHEST = 1 N: must be above LOWEST = 1 N", &["-", "5", "1", "1"]),
        (2, "usage: friction_curve", &["-", "5", "1", "2", "3"]),
        (2, "LOADS = 1: must be a whole number", &["--table", "-", "1"]),
        (1, "load = 1e200", &["-", "2", "1", "1e200"]),
        (1, &cannot_write, &[nowhere]),
        (0, "warning: fewer than 20 asperities touch", &["-", "5", "1e-6", "1e-2"]),
        (0, "warning: asperities do not act independently", &["-", "5", "1e-3", "100"]),
        (0, "warning: asperities yield", &["--table", "-", "5", "1e-3", "100"]),
    ];
    for program in example() {
        for (status, reason, arguments) in refusals {
            let output = program.run(arguments);
            let said = text(&output.stderr);
            assert!(output.status.code() == Some(status) && said.contains(reason), "{arguments:?}: {said}");
        }
    }
}

/// A full disk.
#[test]
#[cfg(target_os = "linux")]
fn a_table_that_cannot_be_written_is_an_error() {
    for program in example() {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
        let output = program.run_into(full);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(1) && said.contains("cannot write the table"), "{said}");
    }
}
