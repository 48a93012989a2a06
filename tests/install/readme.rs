//! The program in README.md prints what README.md says.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};

#[test]
fn the_program_of_the_readme_prints_what_it_says() {
    let readme = std::fs::read_to_string(root().join("README.md")).expect("README.md").replace("\r\n", "\n");
    let program = readme.split("```c\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a program in C");
    let expected = readme.split("It prints `").nth(1).and_then(|rest| rest.split('`').next()).expect("what it prints");
    let source = source("readme.c", program);
    for compiler in Compiler::all(Language::C, "c11") {
        for linking in [Linking::Shared, Linking::Static] {
            let printed = compiler.program(&source, linking).succeeds(&[]);
            assert_eq!(printed.trim_end(), expected, "{compiler:?}, {linking:?}");
        }
    }
}
