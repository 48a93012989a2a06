//! The programs in C of the pages print what stands there.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};

/// Where it is set, pages get what their programs print, in place of a comparison: `make pages`.
const WRITE: &str = "ASPERITY_WRITE_PAGES";

/// Compiles a program of a page with every compiler and linking; it must print this, which stands there.
fn prints(name: &str, page: (&str, &str), program: &str, expected: &str) {
    prints_of(name, page, program, expected, &[]);
}

/// The same of a program with arguments.
fn prints_of(name: &str, (page_name, text): (&str, &str), program: &str, expected: &str, arguments: &[&str]) {
    let source = source(name, program);
    for compiler in Compiler::all(Language::C, "c11") {
        for linking in [Linking::Shared, Linking::Static] {
            let printed = compiler.program(&source, linking).succeeds(arguments);
            let expected = expected.trim_end();
            // A page may have the first lines alone.
            let shown = expected.strip_suffix("\n...").map(|first| {
                let lines: Vec<&str> = printed.lines().take(first.lines().count()).collect();
                lines.join("\n") + "\n..."
            });
            let printed = shown.as_deref().unwrap_or(printed.trim_end());
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

/// With these arguments it fails, prints nothing and says why in one line.
fn refuses(name: &str, program: &str, calls: &[&[&str]]) {
    let program = Compiler::all(Language::C, "c11")[0].program(&source(name, program), Linking::Shared);
    for arguments in calls {
        let output = program.run(arguments);
        assert!(!output.status.success() && output.stdout.is_empty(), "{arguments:?}: {output:?}");
        assert_eq!(output.stderr.iter().filter(|byte| **byte == b'\n').count(), 1, "{arguments:?}: {output:?}");
    }
}

fn page(name: &str) -> String {
    std::fs::read_to_string(root().join(name)).expect(name).replace("\r\n", "\n")
}

/// What stands between two marks, the first time.
fn between<'a>(text: &'a str, start: &str, end: &str) -> &'a str {
    text.split(start).nth(1).and_then(|rest| rest.split(end).next()).expect(start)
}

/// Of normal contact, and of a contact that remembers.
#[test]
fn the_programs_of_contact_stiffness_and_microslip_print_what_stands_below_them() {
    let name = "docs/stiffness-and-microslip.md";
    let guide = page(name);
    for (section, file) in [("## In C", "normal_contact.c"), ("### A program", "microslip.c")] {
        let part = guide.split_once(section).expect(section).1;
        prints(file, (name, &guide), between(part, "```c\n", "```"), between(part, "```text\n", "```"));
    }
}

/// One program reads the surface files of three pages.
#[test]
fn the_programs_of_the_starting_points_print_what_stands_below_them() {
    let start = page("docs/start.md");
    let (devices, maps) = (page("docs/device-or-bead.md"), page("docs/height-maps.md"));
    let program = between(&start, "```c\n", "```");
    let mut surfaces = Vec::new();
    for (name, text) in
        [("docs/start.md", &start), ("docs/device-or-bead.md", &devices), ("docs/height-maps.md", &maps)]
    {
        for rest in text.split("```toml\n").skip(1) {
            let file = source(&format!("start-{}.toml", surfaces.len()), rest.split("```").next().expect("a file"));
            let file = file.to_str().expect("UTF-8").to_string();
            let answer = between(rest, "```text\n", "```");
            prints_of("start.c", (name, text), program, answer, &[&file, between(answer, "mu(", " N)")]);
            surfaces.push(file);
        }
    }
    assert_eq!(surfaces.len(), 5);
    let ground = surfaces[0].as_str();
    refuses(
        "start.c",
        program,
        &[&["none", "10"], &[ground, "ten"], &[ground, "10x"], &[ground, "nan"], &[ground], &[]],
    );
}

#[test]
fn the_program_of_the_page_on_c_refuses_what_is_no_number() {
    let name = "first.c";
    refuses(name, between(&page("docs/c.md"), "```c first.c\n", "```"), &[&["ten"], &["0,25"], &[""], &["0"]]);
}

/// The message that docs/c.md shows of a wrong unit is that of the library.
#[test]
fn a_message_on_a_page_is_the_librarys() {
    let text =
        "pair = \"Si/Si\"\nwork_of_adhesion = 63\nheight_std = 5e-9\nsummit_radius = 1e-6\nasperity_count = 1e5\n";
    let params = asperity::Params::from_toml(text).map(|params| asperity::Model::new(&params));
    let error = params.and_then(|model| model).map(|_| ()).expect_err("refused").to_string();
    let message = &error[error.find("work_of_adhesion").expect("its name")..];
    assert!(page("docs/c.md").contains(&format!("`{message}`")), "{message}");
}
