//! The programs in README.md, on the front page of the site, in docs/fit.md, docs/microslip.md, docs/normal-contact.md and on
//! the starting points' pages print what stands there.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};

/// Compiles a program with every compiler and linking; it must print this.
fn prints(name: &str, program: &str, expected: &str) {
    let source = source(name, program);
    for compiler in Compiler::all(Language::C, "c11") {
        for linking in [Linking::Shared, Linking::Static] {
            let printed = compiler.program(&source, linking).succeeds(&[]);
            assert_eq!(printed.trim_end(), expected.trim_end(), "{compiler:?}, {linking:?}");
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

#[test]
fn the_program_of_the_readme_prints_what_it_says() {
    let readme = page("README.md");
    prints("readme.c", between(&readme, "```c\n", "```"), between(&readme, "It prints `", "`"));
}

#[test]
fn the_front_page_of_the_site_shows_lines_of_that_program_and_what_they_print() {
    let (readme, front) = (page("README.md"), page("docs/site/index.md"));
    let program = between(&readme, "```c\n", "```");
    assert!(program.contains(between(&front, "```c\n", "```")), "the page shows other lines than README.md");
    assert_eq!(between(&front, "```text\n", "```").trim_end(), between(&readme, "It prints `", "`"));
}

/// And the program for an implicit solver.
#[test]
fn the_programs_of_a_contact_that_remembers_print_what_stands_below_them() {
    let guide = page("docs/microslip.md");
    let program = between(&guide, "```c\n", "```");
    assert!(program.lines().count() <= 20);
    prints("microslip.c", program, between(&guide, "```text\n", "```"));
    let solver = guide.split("## In an implicit solver").nth(1).expect("the section");
    prints("equilibrium.c", between(solver, "```c\n", "```"), between(solver, "```text\n", "```"));
}

#[test]
fn the_calibrated_program_prints_what_stands_below_it() {
    let guide = page("docs/fit.md");
    prints("calibrate.c", between(&guide, "```c\n", "```"), between(&guide, "```text\n", "```"));
}

#[test]
fn the_programs_of_the_starting_points_print_what_stands_below_them() {
    let mut pages = 0;
    for entry in std::fs::read_dir(root().join("docs")).expect("docs/") {
        let name = entry.expect("docs/").file_name().into_string().expect("a name in UTF-8");
        if let Some(start) = name.strip_prefix("start-").and_then(|rest| rest.strip_suffix(".md")) {
            let text = page(&format!("docs/{name}"));
            prints(&format!("start-{start}.c"), between(&text, "```c\n", "```"), between(&text, "```text\n", "```"));
            pages += 1;
        }
    }
    assert_eq!(pages, 5, "starting points");
}

#[test]
fn the_program_of_normal_contact_prints_what_stands_below_it() {
    let guide = page("docs/normal-contact.md");
    let (program, printed) =
        guide.split_once("## In C").expect("the part in C").1.split_once("```text\n").expect("text");
    prints("normal_contact.c", between(program, "```c\n", "```"), printed.split("```").next().expect("what it prints"));
}
