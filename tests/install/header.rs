//! The committed header is what the sources generate, and every dialect of C and C++ takes it.

use crate::common::c_compiler::{root, source, Compiler, Language};

/// Set to write the header instead of comparing it: `make header`.
const WRITE: &str = "ASPERITY_WRITE_HEADER";

#[test]
fn committed_header_is_what_the_sources_generate() {
    let root = root();
    let path = root.join("include/asperity.h");
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    // The C interface alone, a file per subject, in the order in which a reader needs them.
    let files = [
        "version",
        "status",
        "last_error",
        "params",
        "setters",
        "names",
        "materials",
        "interfaces",
        "calibration",
        "model",
        "evaluate",
        "slope",
        "pressures",
        "tangential",
        "microslip",
        "gap",
        "pairs",
        "state",
        "validity",
        "summits",
        "table",
        "sensitivities",
    ];
    let builder = files
        .iter()
        .fold(cbindgen::Builder::new(), |builder, file| builder.with_src(root.join(format!("src/capi/{file}.rs"))));
    let bindings = builder.with_config(config).generate().expect("bindings");
    let mut generated = Vec::new();
    bindings.write(&mut generated);
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(&path, &generated).expect("include/asperity.h");
        return;
    }
    let committed = std::fs::read(&path).expect("include/asperity.h");
    assert!(
        committed == generated,
        "include/asperity.h differs from what the sources generate: run `make header` and commit the result"
    );
}

#[test]
fn header_and_citation_have_the_version_of_the_package() {
    let version = env!("CARGO_PKG_VERSION");
    for (file, line) in [
        ("include/asperity.h", format!("#define ASPERITY_VERSION \"{version}\"")),
        ("CITATION.cff", format!("version: {version}")),
    ] {
        let text = std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(text.lines().any(|found| found == line), "{file} does not say {line}");
    }
}

/// The header alone, as the first line of a source in each dialect.
#[test]
fn every_dialect_takes_the_header_without_a_warning() {
    let c = source("header.c", "#include <asperity.h>\n");
    for standard in if cfg!(windows) { &["c11", "c17"][..] } else { &["c99", "c11", "c17"] } {
        Compiler::all(Language::C, standard).iter().for_each(|compiler| compiler.accepts(&c));
    }
    let cpp = source("header.cpp", "#include <asperity.h>\n");
    let standards =
        if cfg!(windows) { &["c++14", "c++17", "c++20"][..] } else { &["c++98", "c++11", "c++17", "c++20"] };
    for standard in standards {
        for compiler in Compiler::all(Language::Cpp, standard) {
            // C++98 has no long long of its own, which the system's stdint.h uses.
            let compiler = if *standard == "c++98" { compiler.with(&["-Wno-long-long"]) } else { compiler };
            compiler.accepts(&cpp);
        }
    }
}
