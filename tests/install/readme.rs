//! The programs in README.md, on the front page of the site, in docs/uncertainty-and-fits.md, docs/stiffness-and-microslip.md, docs/stiffness-and-microslip.md and on
//! the starting points' pages print what stands there.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};

/// Where it is set, pages get what their programs print, in place of a comparison: `make pages`.
const WRITE: &str = "ASPERITY_WRITE_PAGES";

/// Compiles a program of a page with every compiler and linking; it must print this, which stands there.
fn prints(name: &str, (page_name, text): (&str, &str), program: &str, expected: &str) {
    let source = source(name, program);
    for compiler in Compiler::all(Language::C, "c11") {
        for linking in [Linking::Shared, Linking::Static] {
            let printed = compiler.program(&source, linking).succeeds(&[]);
            let (printed, expected) = (printed.trim_end(), expected.trim_end());
            if printed != expected && std::env::var_os(WRITE).is_some() {
                // As it is now, since another program of the page may have been written.
                let now = page(page_name);
                assert_eq!(now.matches(expected).count(), text.matches(expected).count(), "{page_name}: {expected}");
                std::fs::write(root().join(page_name), now.replacen(expected, printed, 1)).expect(page_name);
                return;
            }
            assert_eq!(printed, expected, "{compiler:?}, {linking:?}");
        }
    }
}

fn page(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).expect(name).replace("\r\n", "\n")
}

/// What stands between two marks, the first time.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    text.split(start).nth(1).and_then(|rest| rest.split(end).next()).expect(start)
}

/// The front page of the site has the same program.
#[test]
fn the_program_of_the_readme_prints_what_it_says() {
    let program = |page: &str| between(page, "```c\n", "```").to_string();
    let readme = page("README.md");
    for name in ["README.md", "docs/site/index.md"] {
        let text = page(name);
        assert_eq!(program(&text), program(&readme), "{name}");
        prints("readme.c", (name, &text), &program(&text), between(&text, "```text\n", "```"));
    }
}

/// And the program for an implicit solver.
#[test]
fn the_programs_of_a_contact_that_remembers_print_what_stands_below_them() {
    let guide = page("docs/stiffness-and-microslip.md");
    let program = between(&guide, "```c\n", "```");
    assert!(program.lines().count() <= 20);
    prints("microslip.c", ("docs/stiffness-and-microslip.md", &guide), program, between(&guide, "```text\n", "```"));
    let solver = guide.split("## In an implicit solver").nth(1).expect("the section");
    prints(
        "equilibrium.c",
        ("docs/stiffness-and-microslip.md", &guide),
        between(solver, "```c\n", "```"),
        between(solver, "```text\n", "```"),
    );
}

#[test]
fn the_calibrated_program_prints_what_stands_below_it() {
    let guide = page("docs/uncertainty-and-fits.md");
    prints(
        "calibrate.c",
        ("docs/uncertainty-and-fits.md", &guide),
        between(&guide, "```c\n", "```"),
        between(&guide, "```text\n", "```"),
    );
}

#[test]
fn the_programs_of_the_starting_points_print_what_stands_below_them() {
    let mut pages = 0;
    for entry in std::fs::read_dir(root().join("docs")).expect("docs/") {
        let name = entry.expect("docs/").file_name().into_string().expect("a name in UTF-8");
        if let Some(start) = name.strip_prefix("start-").and_then(|rest| rest.strip_suffix(".md")) {
            let name = format!("docs/{name}");
            let text = page(&name);
            assert!(between(&text, "```c\n", "```").lines().count() <= 20, "{name}");
            prints(
                &format!("start-{start}.c"),
                (&name, &text),
                between(&text, "```c\n", "```"),
                between(&text, "```text\n", "```"),
            );
            pages += 1;
        }
    }
    assert_eq!(pages, 5, "starting points");
}

#[test]
fn the_program_of_normal_contact_prints_what_stands_below_it() {
    let guide = page("docs/stiffness-and-microslip.md");
    let (program, printed) =
        guide.split_once("## In C").expect("the part in C").1.split_once("```text\n").expect("text");
    let shown = ("docs/stiffness-and-microslip.md", &guide[..]);
    prints(
        "normal_contact.c",
        shown,
        between(program, "```c\n", "```"),
        printed.split("```").next().expect("what it prints"),
    );
}
