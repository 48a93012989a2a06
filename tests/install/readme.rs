//! The programs in README.md, in docs/fit.md, in docs/microslip.md and on the front page of the site print what stands there.

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
fn the_lines_of_the_front_page_print_what_stands_below_them() {
    let front = page("docs/site/index.md");
    let lines = between(&front, "```c\n", "```");
    assert_eq!(lines.lines().count(), 5, "the page says that there are five");
    let start = "#include <asperity.h>\n#include <stdio.h>\n\
                 int main(void) { asperity_params params; asperity_model *model;\n";
    let program = format!("{start}{lines}asperity_free(model); }}\n");
    prints("front.c", &program, between(&front, "```text\n", "```"));
}

/// And the lines for an implicit solver, as the function that they are.
#[test]
fn the_programs_of_a_contact_that_remembers_print_what_stands_below_them() {
    let guide = page("docs/microslip.md");
    let program = between(&guide, "```c\n", "```");
    assert!(program.lines().count() <= 20);
    prints("microslip.c", program, between(&guide, "```text\n", "```"));
    let solver = guide.split("## In an implicit solver").nth(1).expect("the section");
    let surfaces = between(program, "asperity_params_init_unset(&params);\n", "    for");
    let start = "#include <asperity.h>\n#include <math.h>\n#include <stdio.h>\n";
    let main = format!(
        "int main(void) {{ asperity_params params; asperity_model *model; double state[32] = {{ 0 }};\n\
         asperity_params_init_unset(&params);\n{surfaces}\
         for (int i = 1; i < 4; i++) {{ const double pull[2] = {{ 0.1 * i, 0.05 * (i % 2) }}; double u[2] = {{ 0, 0 }};\n\
         const int steps = equilibrium(model, 10.0, pull, state, u);\n\
         printf(\"%.2f nm, %.2f nm after %d iterations\\n\", 1e9 * u[0], 1e9 * u[1], steps); }}\n\
         asperity_free(model); }}\n"
    );
    let program = format!("{start}{}{main}", between(solver, "```c\n", "```"));
    prints("equilibrium.c", &program, between(solver, "```text\n", "```"));
}

#[test]
fn the_calibrated_program_prints_what_stands_below_it() {
    let guide = page("docs/fit.md");
    prints("calibrate.c", between(&guide, "```c\n", "```"), between(&guide, "```text\n", "```"));
}
