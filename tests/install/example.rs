//! The example: its table, its figure, its command line; in C and C++.

use crate::common::assert_near;
use crate::common::c_compiler::{root, text, Compiler, Language, Linking, Program};
use std::path::Path;

fn example(language: Language) -> Vec<Program> {
    let (standard, name) = match language {
        Language::C => ("c11", "friction_curve.c"),
        Language::Cpp => ("c++17", "friction_curve.cpp"),
    };
    let source = root().join("c_examples").join(name);
    let compilers = Compiler::all(language, standard).into_iter();
    let compilers = compilers.map(|compiler| {
        let conversions = language == Language::Cpp && !cfg!(windows);
        if conversions {
            compiler.with(&["-Wconversion"])
        } else {
            compiler
        }
    });
    compilers.map(|compiler| compiler.program(&source, Linking::Shared)).collect()
}

/// Load, mu, friction force, real area, contacts.
fn rows(table: &str) -> Vec<[f64; 5]> {
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("# load [N], mu, friction force [N], real area [m^2], contacts"));
    let row = |line: &str| -> [f64; 5] {
        let numbers: Vec<f64> = line.split(' ').map(|field| field.parse().expect(line)).collect();
        numbers.try_into().expect(line)
    };
    lines.map(row).collect()
}

fn check_table(rows: &[[f64; 5]]) {
    assert_eq!(rows.len(), 33);
    assert_near(rows[0][0], 2e-4, 1e-9, "the lightest load");
    assert_near(rows[32][0], 0.1, 1e-9, "the heaviest load");
    // Shear strength lies between the two constants of Hurtado and Kim; G* is that of polysilicon.
    let shear_modulus = 160e9 / (2.0 * 1.22);
    for &[load, mu, friction, area, contacts] in rows {
        assert_near(mu * load, friction, 2e-9, "mu P");
        let strength = friction / area;
        assert!(shear_modulus / 1290.0 <= strength && strength <= shear_modulus / 43.0 * (1.0 + 1e-9), "F/A at {load}");
        assert!((20.0..1e4).contains(&contacts), "{contacts} contacts at {load}");
    }
    for pair in rows.windows(2) {
        assert!(pair[1][1] < pair[0][1], "mu does not fall with load: {pair:?}");
        assert!([0, 2, 3, 4].iter().all(|&k| pair[1][k] > pair[0][k]), "something falls with load: {pair:?}");
    }
}

/// The curve that is drawn is that of the table.
fn check_figure(path: &Path, rows: &[[f64; 5]]) {
    let figure = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    assert!(figure.starts_with("<svg ") && figure.trim_end().ends_with("</svg>"), "{}", path.display());
    // Without the marks between words.
    let words: String = figure.split('<').map(|part| part.split_once('>').map_or(part, |(_, words)| words)).collect();
    let words = words.replace("&#956;", "μ");
    for label in [
        "normal load P [N]",
        "friction coefficient μ = F/P",
        "contact physics",
        "constant μ = ",
        "fewer than 20 contacts",
    ] {
        assert!(words.contains(label), "the figure does not say '{label}'");
    }
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
    for program in example(Language::C) {
        let rows = rows(&program.succeeds(&[figure.to_str().expect("a path in UTF-8")]));
        check_table(&rows);
        check_figure(&figure, &rows);
        check_figure(&root().join("docs/friction_curve.svg"), &rows);
    }
}

#[test]
fn in_cpp_it_prints_the_same_table() {
    for arguments in [["33", "2e-4", "0.1"], ["7", "3e-6", "0.2"]] {
        let [count, lowest, highest] = arguments;
        let tables: Vec<String> =
            example(Language::C).iter().map(|program| program.succeeds(&["-", count, lowest, highest])).collect();
        assert_eq!(rows(&tables[0]).len().to_string(), count);
        assert!(tables.iter().all(|table| *table == tables[0]), "compilers differ");
        for program in example(Language::Cpp) {
            assert_eq!(program.succeeds(&arguments), tables[0]);
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
        (1, "asperity_state_at_load: load = 1e200: ", &["-", "2", "1", "1e200"]),
        (1, &cannot_write, &[nowhere]),
        (0, "warning: fewer than 20 summits touch", &["-", "5", "1e-6", "1e-2"]),
        (0, "warning: summits do not act independently", &["-", "5", "1e-3", "1"]),
        (0, "warning: the strength of the interface is the default, not a measured one", &["-", "5", "1e-3", "1e-2"]),
        (0, "warning: the surface is rough on many scales", &["-", "5", "1e-3", "1e-2"]),
    ];
    for program in example(Language::C) {
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
    for program in example(Language::C) {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
        let output = program.run_into(full);
        let said = text(&output.stderr);
        assert!(output.status.code() == Some(1) && said.contains("cannot write the table"), "{said}");
    }
}
