//! What other languages and the pages repeat of the header is written by `packaging/declarations`: what is committed is current,
//! and a parameter that is added to the sources reaches every one of them.

use crate::common::c_compiler::{root, text, Compiler, Language};
use crate::header;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What the program writes, as folders and files of the tree.
const WRITTEN: [&str; 6] =
    ["docs", "fortran/asperity.f90", "fortran/tests/smoke.f90", "include", "js/src", "python/src/asperity"];

fn run(program: &str, arguments: &[&str]) {
    let output = Command::new(program).args(arguments).current_dir(root()).output();
    let output = output.unwrap_or_else(|error| panic!("{program}: {error}: run tests/setup.sh core"));
    assert!(output.status.success(), "{program} {arguments:?}: {}", text(&output.stderr));
}

#[test]
fn committed_declarations_are_what_the_header_says() {
    run("python3", &["packaging/declarations", "--check"]);
}

/// Copies a file, or the files of a folder, to the same place in another tree.
fn copy(path: &str, tree: &Path) {
    let source = root().join(path);
    let files: Vec<PathBuf> = match source.is_dir() {
        true => source.read_dir().unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file()).collect(),
        false => vec![source],
    };
    for file in files {
        let target = tree.join(file.strip_prefix(root()).unwrap());
        std::fs::create_dir_all(target.parent().unwrap()).unwrap();
        std::fs::copy(&file, target).unwrap();
    }
}

fn change(file: &Path, how: impl FnOnce(String) -> String) {
    let changed = how(std::fs::read_to_string(file).unwrap_or_else(|error| panic!("{}: {error}", file.display())));
    std::fs::write(file, changed).unwrap();
}

#[test]
fn a_parameter_and_a_function_that_are_added_reach_every_language_and_the_pages() {
    let tree = Path::new(env!("CARGO_TARGET_TMPDIR")).join("declarations");
    let _ = std::fs::remove_dir_all(&tree);
    WRITTEN.iter().chain(&["cbindgen.toml", "src/capi"]).for_each(|path| copy(path, &tree));
    change(&tree.join("src/capi/params.rs"), |text| {
        let (before, after) = text.split_once("pub struct asperity_params {").expect("the struct");
        let (fields, after) = after.split_once("\n}\n").expect("its end");
        let field = "    /// zeta [stress], 1 to 7: an added parameter; 3 by default.\n    pub added_modulus: f64,";
        let constant = "/// Contacts that slip in an added way.\npub const ASPERITY_SLIP_ADDED: i32 = 2;\n";
        format!("{before}pub struct asperity_params {{{fields}\n{field}\n}}\n{constant}{after}")
    });
    change(&tree.join("src/capi/about.rs"), |text| {
        let function = "asperity_added_answer(load: f64, of: *const asperity_params, answer: *mut f64) -> i32 { 0 }";
        format!("{text}\n/// Answers an added question.\n#[no_mangle]\npub unsafe extern \"C\" fn {function}\n")
    });
    std::fs::write(tree.join("include/asperity.h"), header::generated(&tree)).unwrap();
    run("python3", &["packaging/declarations", "--root", tree.to_str().unwrap()]);

    for (file, said) in [
        ("include/asperity.h", &["double added_modulus;", "asperity_added_answer(double load"][..]),
        ("include/asperity.hpp", &["double added_modulus() const", "added = ASPERITY_SLIP_ADDED,"]),
        (
            "fortran/asperity.f90",
            &["real(c_double) :: added_modulus   ", "function asperity_added_answer(load, of, answer)"],
        ),
        ("fortran/tests/smoke.f90", &["call check('asperity_added_answer', "]),
        ("python/src/asperity/_header.py", &["\"added_modulus\": \"stress\"", "\"asperity_added_answer\": (c_int32"]),
        (
            "python/src/asperity/params.py",
            &["\n    added_modulus: float = ", "zeta [stress], 1 to 7", "\"whole\", \"added\"]"],
        ),
        ("js/src/header.js", &["name: \"added_modulus\", type: \"double\"", "[added_modulus] zeta", "\"added\": 2"]),
        ("docs/keys.md", &["| `added_modulus` | Pa | 1 to 7 |"]),
    ] {
        let text = std::fs::read_to_string(tree.join(file)).expect(file);
        for said in said {
            assert!(text.contains(said), "{file} does not have '{said}'");
        }
    }
    let wrapper = tree.join("added.cpp");
    let include = format!("#include \"{}\"\n", tree.join("include/asperity.hpp").display());
    std::fs::write(
        &wrapper,
        include + "double zeta() { return asperity::Params().added_modulus(2.0).added_modulus(); }\n",
    )
    .unwrap();
    Compiler::all(Language::Cpp, "c++17").iter().for_each(|compiler| compiler.accepts(&wrapper));
    let module = tree.join("fortran/asperity.f90");
    run(
        "gfortran",
        &[
            "-std=f2008",
            "-Wall",
            "-Wextra",
            "-Werror",
            "-fsyntax-only",
            "-J",
            tree.to_str().unwrap(),
            module.to_str().unwrap(),
        ],
    );
    let imported = "import sys, ctypes; sys.path.insert(0, sys.argv[1]); import _header; \
                    assert _header.asperity_params.added_modulus.offset == ctypes.sizeof(_header.asperity_params) - 8";
    run("python3", &["-B", "-c", imported, tree.join("python/src/asperity").to_str().unwrap()]);
}
