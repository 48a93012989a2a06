//! ABI 1 is a file, `abi-1.h`. It has what the header declares and what the library exports, and the library has every field where
//! it says, as C compilers do.

#![cfg(all(target_os = "linux", target_pointer_width = "64", target_endian = "little"))]
#![allow(unsafe_code)]

#[path = "../common/mod.rs"]
mod common;

use common::c_compiler::{library_folder, root, source, text, Compiler, Language, Linking};
use std::collections::BTreeSet;
use std::process::Command;

const FILE: &str = "tests/abi/abi-1.h";
/// Set to write the file instead of comparing it: `make abi`.
const WRITE: &str = "ASPERITY_WRITE_ABI";

const HEAD: &str = "\
/* ABI 1: every constant, type, field and function of asperity.h. After a field stand its offset and its size [bytes] on systems of 64
 * bits, after a struct its size. `make abi` writes this file, on purpose; once a version is released only additions are allowed: fields
 * at the end of a struct, constants and functions (packaging/release.py). */

#ifndef ASPERITY_H
#define ASPERITY_H

#include <stddef.h>
#include <stdint.h>

";

/// A declaration of the header.
enum Declared {
    /// A name and its value, a typedef.
    Line(String),
    Struct {
        name: String,
        fields: Vec<String>,
    },
    /// What it returns and its name, the types of its parameters.
    Function {
        before: String,
        parameters: Vec<String>,
    },
}

fn read(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// What the header declares to C, in its order, but for the version of the library.
fn declared(header: &str) -> Vec<Declared> {
    let (mut found, mut code, mut of_cpp) = (Vec::new(), String::new(), false);
    let comments = |part: &str| part.split_once("*/").map_or_else(|| part.to_owned(), |(_, code)| code.to_owned());
    for line in header.split("/*").map(comments).collect::<String>().lines() {
        if let Some(constant) = line.strip_prefix("#define ").and_then(|rest| rest.split_once(' ')) {
            let is_version = constant.0.starts_with("ASPERITY_VERSION");
            found.extend((!is_version).then(|| Declared::Line(line.trim().to_owned())));
        } else if line.starts_with('#') {
            of_cpp = line.starts_with("#ifdef __cplusplus");
        } else if !of_cpp {
            code += line;
            code.push('\n');
        }
    }
    // A struct ends with `} name;`: the last of its statements.
    let mut fields: Option<Vec<String>> = None;
    for statement in code.split(';') {
        let statement = statement.split_whitespace().collect::<Vec<_>>().join(" ");
        if let Some((_, first)) = statement.split_once('{') {
            fields = Some(vec![first.trim().to_owned()]);
        } else if let Some(name) = statement.strip_prefix("} ") {
            let fields = fields.take().expect("a struct");
            found.push(Declared::Struct { name: name.to_owned(), fields });
        } else if let Some(fields) = &mut fields {
            fields.push(statement);
        } else if let Some((before, parameters)) = statement.split_once('(') {
            let parameters = parameters.trim_end_matches(')').split(',').map(|parameter| type_of(parameter.trim()));
            found.push(Declared::Function { before: before.to_owned(), parameters: parameters.collect() });
        } else if !statement.is_empty() {
            found.push(Declared::Line(format!("{statement};")));
        }
    }
    found
}

/// Without the name of the parameter.
fn type_of(parameter: &str) -> String {
    let name = parameter.rfind(|letter: char| !letter.is_alphanumeric() && letter != '_').map_or(0, |end| end + 1);
    parameter[..if name > 0 { name } else { parameter.len() }].trim_end().to_owned()
}

/// The name of a field, as `force` of `double force[2]`.
fn name_of(field: &str) -> &str {
    let end = field.find('[').unwrap_or(field.len());
    field[..end].rsplit([' ', '*']).next().expect("a name")
}

/// Offsets and sizes of all fields, and the sizes of the structs, as a compiler has them, in the order of the header.
fn places(declared: &[Declared]) -> Vec<String> {
    let mut program = String::from("#include <asperity.h>\n#include <stdio.h>\n\nint main(void)\n{\n");
    for item in declared {
        if let Declared::Struct { name, fields } = item {
            for field in fields.iter().map(|field| name_of(field)) {
                let size = format!("sizeof (({name} *)NULL)->{field}");
                program += &format!("    printf(\"%zu, %zu\\n\", offsetof({name}, {field}), {size});\n");
            }
            program += &format!("    printf(\"%zu\\n\", sizeof({name}));\n");
        }
    }
    let source = source("places.c", &(program + "    return 0;\n}\n"));
    let found = Compiler::all(Language::C, "c11")
        .into_iter()
        .map(|compiler| compiler.program(&source, Linking::Shared).succeeds(&[]))
        .collect::<BTreeSet<_>>();
    assert_eq!(found.len(), 1, "compilers put fields in different places");
    found.iter().flat_map(|found| found.lines().map(String::from)).collect()
}

fn generated(header: &str) -> String {
    let declared = declared(header);
    let mut places = places(&declared).into_iter();
    let mut place = || places.next().expect("a place");
    let (mut lines, mut structs, mut functions) = (Vec::new(), String::new(), Vec::new());
    for item in &declared {
        match item {
            Declared::Line(line) => lines.push(line.clone()),
            Declared::Struct { name, fields } => {
                structs += &format!("\ntypedef struct {name} {{\n");
                fields.iter().for_each(|field| structs += &format!("  {field}; /* {} */\n", place()));
                structs += &format!("}} {name}; /* {} */\n", place());
            }
            Declared::Function { before, parameters } => {
                functions.push(format!("{before}({});\n", parameters.join(", ")));
            }
        }
    }
    functions.sort_by_key(|line| line.split('(').next().map(|before| name_of(before).to_owned()));
    format!("{HEAD}{}\n{structs}\n{}\n#endif\n", lines.join("\n"), functions.concat())
}

#[test]
fn the_file_has_what_the_header_declares() {
    let generated = generated(&read("include/asperity.h"));
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(root().join(FILE), &generated).expect(FILE);
        return;
    }
    let file = read(FILE);
    let [file, header] = [&file, &generated].map(|text| text.lines().collect::<Vec<_>>());
    let differs = file.iter().zip(&header).find(|(file, header)| file != header);
    assert!(
        file == header,
        "{FILE} differs from include/asperity.h, first in {differs:?}: before the first release `make abi` writes it, after it \
         the header has to keep its declarations"
    );
}

#[test]
fn the_library_exports_the_functions_of_the_file_and_no_other() {
    let functions = declared(&read(FILE)).into_iter().filter_map(|item| match item {
        Declared::Function { before, .. } => Some(name_of(&before).to_owned()),
        _ => None,
    });
    let mut nm = Command::new("nm");
    let output = nm.args(["-D", "--defined-only"]).arg(library_folder().join("libasperity.so")).output().expect("nm");
    assert!(output.status.success(), "{}", text(&output.stderr));
    let exported = text(&output.stdout);
    let exported = exported.lines().map(|line| line.rsplit(' ').next().expect("a name").to_owned());
    assert_eq!(exported.collect::<BTreeSet<_>>(), functions.collect::<BTreeSet<_>>());
}

/// The fields of a struct of the file, each with its declaration, offset and size, and the size of the struct.
fn laid_out(file: &str, name: &str) -> (Vec<(String, usize, usize)>, usize) {
    let (_, rest) = file.split_once(&format!("typedef struct {name} {{\n")).expect(name);
    let (fields, rest) = rest.split_once(&format!("}} {name}; /* ")).expect(name);
    let number = |text: &str| text.trim_end_matches(" */").parse::<usize>().expect("a number");
    let field = |line: &str| {
        let (declared, place) = line.trim().split_once("; /* ").expect("a place");
        let (offset, size) = place.split_once(", ").expect("a size");
        (declared.to_owned(), number(offset), number(size))
    };
    (fields.lines().map(field).collect(), number(rest.lines().next().expect("a size")))
}

/// Bytes that have another number in each field where the file says, and how Rust shows a struct with these numbers.
fn numbered(file: &str, name: &str) -> (Vec<u8>, String) {
    let (fields, size) = laid_out(file, name);
    let (mut bytes, mut shown, mut number) = (vec![0; size], Vec::new(), 1000_u32);
    for (declared, offset, size) in &fields {
        let kind = declared.split(' ').next().expect("a type");
        let width = if kind.ends_with("32_t") { 4 } else { 8 };
        let mut elements = Vec::new();
        for place in (*offset..offset + size).step_by(width) {
            let is_double = kind == "double";
            let bits = if is_double { f64::from(number).to_bits() } else { u64::from(number) };
            bytes[place..place + width].copy_from_slice(&bits.to_le_bytes()[..width]);
            elements.push(match (declared.contains('*'), is_double) {
                (true, _) => format!("{number:#x}"),
                (_, true) => format!("{number}.0"),
                _ => number.to_string(),
            });
            number += 1;
        }
        let elements = elements.join(", ");
        let value = if declared.contains('[') { format!("[{elements}]") } else { elements };
        shown.push(format!("{}: {value}", name_of(declared)));
    }
    (bytes, format!("{name} {{ {} }}", shown.join(", ")))
}

#[test]
fn the_library_has_every_field_where_the_file_says() {
    let file = read(FILE);
    let mut count = 0;
    macro_rules! compare {
        ($($name:ident)*) => {$(
            let (bytes, expected) = numbered(&file, stringify!($name));
            assert_eq!(bytes.len(), size_of::<asperity::capi::$name>());
            // SAFETY: so many bytes, of numbers and of pointers that nothing follows.
            let found = unsafe { bytes.as_ptr().cast::<asperity::capi::$name>().read_unaligned() };
            assert_eq!(format!("{found:?}"), expected);
            count += 1;
        )*};
    }
    compare!(asperity_estimate asperity_microslip asperity_params asperity_specimens asperity_state asperity_summary asperity_table);
    assert_eq!(count, file.matches("\ntypedef struct asperity_").count() - 1, "all but the model, which is opaque");
}
