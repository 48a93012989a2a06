//! The C interface as programs in C and C++ see it: `tests/c/` and `tests/cpp/`, each a program that checks for itself.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};
use crate::fuzz_calls::table::CALLS;
use std::path::PathBuf;

/// What the library's own headers are free of, besides -Wall, -Wextra and -Wpedantic; not asked of MSVC.
const CONVERSIONS: [&str; 3] = ["-Wconversion", "-Wsign-conversion", "-Wshadow"];

fn c_source(name: &str) -> PathBuf {
    root().join("tests/c").join(name)
}

/// A program in C11 that ends with success, by every compiler.
fn passes(name: &str) {
    for compiler in Compiler::all(Language::C, "c11") {
        print!("{}", compiler.program(&c_source(name), Linking::Shared).succeeds(&[]));
    }
}

#[test]
fn the_contract_holds_clause_by_clause() {
    passes("contract.c");
}

#[test]
fn threads_that_share_a_model_get_its_answers_and_their_own_messages() {
    passes("threads.c");
}

#[test]
fn tables_of_heights_are_copied_and_freed() {
    passes("tables.c");
}

/// Traps are turned on by functions of the GNU C library.
#[test]
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn no_call_raises_a_floating_point_trap_in_any_environment() {
    passes("traps.c");
}

/// By the stacks of threads of the GNU C library.
#[test]
#[cfg(all(target_os = "linux", target_env = "gnu"))]
fn every_call_keeps_to_the_stack_that_is_promised() {
    let program = c_source("stack.c");
    let calls = std::fs::read_to_string(&program).expect("tests/c/stack.c");
    let mut text = String::new();
    for call in CALLS {
        let name = call.name.trim_start_matches("asperity_");
        assert!(calls.contains(&format!("X({name}, , (")), "tests/c/stack.c does not call {}", call.name);
        text += &format!("#define STACK_{} {}\n", call.name, call.needs.stack);
    }
    let source = source("stack_promised.c", &format!("{text}#include \"{}\"\n", program.display()));
    for compiler in Compiler::all(Language::C, "c11") {
        print!("{}", compiler.program(&source, Linking::Shared).succeeds(&["all"]));
    }
}

/// `asperity_loads.h` is for C99 and C++.
#[test]
fn the_loads_of_the_steps_before_let_expect_the_next() {
    let source = c_source("loads.c");
    for compiler in evaluating_compilers() {
        print!("{}", compiler.program(&source, Linking::Shared).succeeds(&[]));
    }
}

/// `asperity_eval.h` says how contraction into fused multiply-adds is prevented: by -std=c99 or -ffp-contract=off in GCC, by
/// the header itself in Clang and MSVC.
#[test]
fn the_header_for_kernels_gives_the_bits_of_the_library() {
    let source = c_source("eval.c");
    for compiler in evaluating_compilers() {
        print!("{}", compiler.program(&source, Linking::Shared).succeeds(&[]));
    }
}

/// The headers that are compiled into the host are right also where its compiler takes it that no number is NaN, sums in any
/// order and, as GCC does, makes the program flush small numbers to zero.
#[test]
#[cfg(target_os = "linux")]
fn the_headers_give_the_numbers_of_the_library_under_fast_math() {
    let native = if cfg!(target_arch = "x86_64") { "-march=native" } else { "-mcpu=native" };
    let compilers = [
        Compiler::named("gcc", Language::C, "c99").with(&["-Ofast"]),
        Compiler::named("gcc", Language::C, "c11").optimised(3).with(&["-ffast-math", native]),
        Compiler::named("gcc", Language::C, "c11").optimised(2).with(&["-ffinite-math-only"]),
        Compiler::named("clang", Language::C, "c99").with(&["-Ofast"]),
        Compiler::named("clang", Language::C, "c11").optimised(3).with(&["-ffast-math", native]),
        Compiler::named("g++", Language::Cpp, "c++17").optimised(3).with(&["-ffast-math", "-x", "c++"]),
        Compiler::named("clang++", Language::Cpp, "c++17").optimised(2).with(&["-ffinite-math-only", "-x", "c++"]),
    ];
    for compiler in compilers.map(|compiler| compiler.with(&CONVERSIONS)) {
        for name in ["eval.c", "loads.c"] {
            print!("{}", compiler.program(&c_source(name), Linking::Shared).succeeds(&[]));
        }
    }
}

#[cfg(target_os = "linux")]
fn evaluating_compilers() -> Vec<Compiler> {
    let native = if cfg!(target_arch = "x86_64") { "-march=native" } else { "-mcpu=native" };
    let (off, as_cpp) = ("-ffp-contract=off", ["-x", "c++"]);
    let compilers = [
        Compiler::named("gcc", Language::C, "c99").optimised(2),
        Compiler::named("gcc", Language::C, "c99").optimised(3).with(&[native]),
        Compiler::named("gcc", Language::C, "c11").optimised(3).with(&[native, off]),
        Compiler::named("clang", Language::C, "c99").optimised(2),
        Compiler::named("clang", Language::C, "c99").optimised(3).with(&[native]),
        Compiler::named("g++", Language::Cpp, "c++17").optimised(3).with(&[native, off]).with(&as_cpp),
        Compiler::named("clang++", Language::Cpp, "c++17").optimised(3).with(&[native]).with(&as_cpp),
    ];
    compilers.map(|compiler| compiler.with(&CONVERSIONS)).into()
}

#[cfg(not(target_os = "linux"))]
fn evaluating_compilers() -> Vec<Compiler> {
    Compiler::all(Language::C, "c11").into_iter().map(|compiler| compiler.optimised(2)).collect()
}

#[test]
fn the_cpp_interface_keeps_its_promises() {
    for standard in ["c++17", "c++20"] {
        for compiler in Compiler::all(Language::Cpp, standard) {
            let compiler = if cfg!(windows) { compiler } else { compiler.with(&CONVERSIONS) };
            print!("{}", compiler.program(&root().join("tests/cpp/wrapper.cpp"), Linking::Shared).succeeds(&[]));
        }
    }
}
