//! The committed header is what the sources generate, and every dialect of C and C++ takes it.

use crate::common::c_compiler::{root, source, Compiler, Language, Linking};
use std::path::{Path, PathBuf};

/// Set to write the header instead of comparing it: `make header`.
const WRITE: &str = "ASPERITY_WRITE_HEADER";

/// The groups of functions in the order in which a reader needs them: a heading, and the files of `src/capi/` whose functions
/// follow.
const GROUPS: [(&str, &[&str]); 8] = [
    ("One call: friction with its band, from a text.", &["estimate"]),
    (
        "Make: parameters from what you know of the surfaces, then a model.",
        &["params", "setters", "names", "calibration", "surface_text", "surface_file", "model"],
    ),
    ("Look up: names, and what is known of each.", &["look_up"]),
    (
        "Ask: friction and stiffness of one contact or of many, for the inner loop of a solver.",
        &["evaluate", "pairs", "tangential", "microslip", "gap"],
    ),
    ("Explain: exact states, single specimens and the constants of a model.", &["state", "specimens"]),
    ("Limits: which assumptions fail at which loads, and the remedy.", &["validity"]),
    ("Errors and versions.", &["last_error", "about"]),
    ("The table: for code that cannot call a library, such as GPU kernels.", &["table"]),
];

/// The columns of a line.
const WIDTH: usize = 118;

/// Files that have constants and types alone, which come before all functions.
const CONSTANTS: [&str; 2] = ["version", "status"];

/// The header of a tree, with a heading before the first function of each group.
pub fn generated(root: &Path) -> String {
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let capi = |file: &str| -> PathBuf { root.join(format!("src/capi/{file}.rs")) };
    let files = CONSTANTS.iter().chain(GROUPS.iter().flat_map(|(_, files)| *files));
    let builder = files.fold(cbindgen::Builder::new(), |builder, file| builder.with_src(capi(file)));
    let mut header = Vec::new();
    builder.with_config(config).generate().expect("bindings").write(&mut header);
    let mut header = String::from_utf8(header).expect("a text");
    for (heading, files) in GROUPS {
        let sources = files.iter().map(|file| std::fs::read_to_string(capi(file)).expect(file)).collect::<String>();
        let name = sources.split("extern \"C\" fn ").nth(1).and_then(|rest| rest.split('(').next()).expect(heading);
        let declares = |line: &&str| !line.starts_with([' ', '/', '#']) && line.contains(&format!("{name}("));
        let declaration = header.lines().find(declares).expect(name);
        let end = declaration.as_ptr() as usize - header.as_ptr() as usize;
        let comment = header[..end].rfind("/**\n").expect("a comment");
        header.insert_str(comment, &format!("/* ---- {heading} ---- */\n\n"));
    }
    in_c89(&header)
}

/// Without comments of later dialects, and in few lines: comments begin and end on lines of their text, those of a field stand
/// before it where there is room, arguments fill lines, constants follow each other.
fn in_c89(header: &str) -> String {
    let mut lines: Vec<String> = Vec::new();
    for line in header.lines() {
        let text = line.trim_start();
        let is_argument = line.starts_with("     ") && !text.starts_with('*');
        match lines.last_mut() {
            Some(last) if last.ends_with("/**") && text.starts_with("* ") => *last += &text[1..],
            Some(last) if text == "*/" => *last = format!("{} */", last.trim_end_matches([' ', '*'])),
            Some(last) if is_whole(last) && text.ends_with(';') && last.len() + 1 + text.len() <= WIDTH => {
                *last = format!("{last} {text}");
            }
            Some(last) if is_argument && last.ends_with(',') => match last.len() + text.len() < WIDTH {
                true => *last = format!("{last} {text}"),
                false => lines.push(format!("    {text}")),
            },
            Some(last) if text.is_empty() && last.starts_with("#define ASPERITY_") => {}
            _ => lines.push(match line.split_once("// ") {
                Some((code, comment)) if code.starts_with(['#', '}']) => format!("{code}/* {comment} */"),
                _ => line.to_owned(),
            }),
        }
    }
    lines.join("\n") + "\n"
}

/// Whether a line is the whole comment of a field.
fn is_whole(line: &str) -> bool {
    line.starts_with("  /** ") && line.ends_with(" */")
}

#[test]
fn committed_header_is_what_the_sources_generate() {
    let path = root().join("include/asperity.h");
    let generated = generated(root());
    if std::env::var_os(WRITE).is_some() {
        std::fs::write(&path, &generated).expect("include/asperity.h");
        return;
    }
    let committed = std::fs::read_to_string(&path).expect("include/asperity.h");
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
    // As strict as C89 is, but for the long long of the system's stdint.h.
    let oldest = |compiler: Compiler| if cfg!(windows) { compiler } else { compiler.with(&["-Wno-long-long"]) };
    for standard in if cfg!(windows) { &["c11", "c17"][..] } else { &["c89", "c99", "c11", "c17"] } {
        for compiler in Compiler::all(Language::C, standard) {
            let compiler = if *standard == "c89" { oldest(compiler) } else { compiler };
            compiler.accepts(&c);
        }
    }
    let cpp = source("header.cpp", "#include <asperity.h>\n");
    let within =
        "#include <cstddef>\n#include <cstdint>\nnamespace host {\nextern \"C\" {\n#include <asperity.h>\n}\n}\n\
                  double force(const host::asperity_model *model) {\n    \
                  return host::asperity_friction_force_at_load(model, 1.0);\n}\n";
    let within = source("header_in_a_namespace.cpp", within);
    let standards =
        if cfg!(windows) { &["c++14", "c++17", "c++20"][..] } else { &["c++98", "c++11", "c++17", "c++20"] };
    for standard in standards {
        for compiler in Compiler::all(Language::Cpp, standard) {
            if *standard == "c++98" {
                oldest(compiler).accepts(&cpp);
            } else {
                compiler.accepts(&cpp);
                compiler.accepts(&within);
            }
        }
    }
}

/// Macros that headers of systems, windows, terminals, mathematics, microcontrollers and other languages have.
const MACROS: [&str; 4] = [
    // <X11/X.h>, <X11/Xlib.h> and the like: values and types.
    "Status=int Bool=int True=1 False=0 None=0L Success=0 Always=2 Above=0 Below=1 Complex=0 Convex=2 Unsorted=0 Nonconvex=1 CurrentTime=0L \
     GrayScale=1 FocusIn=9 KeyPress=2 Expose=12 Opposite=4 ControlMask=4 CursorShape=0 BadValue=2 Button1=1 Error=1 State=1 Table=1",
    // <windows.h>, <sys/sysmacros.h>, <assert.h>, <complex.h>, <math.h>, <sys/param.h>, <termios.h>, what compilers define.
    "near= far= small=char hyper=int interface=struct IN= OUT= OPTIONAL= ERROR=0 DELETE=1 TRUE=1 FALSE=0 pascal= cdecl= STRICT=1 \
     I=(1.0i) complex=_Complex imaginary=_Imaginary DOMAIN=1 OVERFLOW=3 UNDERFLOW=4 HUGE=1e300 PI=3.14 B0=0 ECHO=8 PAGE_SIZE=4096 \
     linux=1 unix=1 i386=1 arm=1 mips=1 sun=1 vax=1 EOF=-1 BUFSIZ=8192 NAN=0 T=int L=0 E=2.7 N=4 M=3 R=1 G=1 _1=1 nil=0 YES=1 NO=0",
    // Functions: those, curses, AssertMacros.h of macOS, Arduino, R, Perl, Unreal.
    "check(x) verify(x) assert(x) ensure(x) require(x,y) check_string(x,y) min(a,b) max(a,b) major(d) minor(d) makedev(a,b) isset(a,b) \
     setbit(a,b) roundup(x,y) MIN(a,b) MAX(a,b) abs(x) round(x) square(x) sq(x) bit(b) radians(d) degrees(r) constrain(a,b,c) F(s) \
     move(y,x) erase() clear() refresh() echo() filter() insert(a) timeout(d) box(a,b,c) border(a) Copy(s,d,n,t) Free(p) Move(s,d,n,t) \
     Zero(d,n,t) open(a,b) read(a,b,c) write(a,b,c) close(f) select(a,b,c,d,e) index(a,b) Error(x) Model(x) Span(x) State(x) Table(x)",
    // Words: Qt, R, and what any program may have.
    "signals=public slots= emit= forever=for(;;) foreach=for length=Rf_length error=Rf_error warning=Rf_warning eval=Rf_eval \
     count=(1) data=(2) size=(3) empty=(4) end=(5) get=(6) set=(7) reset=(8) string=(9) text=(10) version=(11) table=(12) status=(13) \
     describe=(14) copy=(15)",
];

/// A source that has so many macros first, in a dialect.
fn after_macros(macros: &str, language: Language) -> PathBuf {
    let one = |name: &str| match name.split_once('=') {
        Some((name, value)) => format!("#undef {name}\n#define {name} {value}\n"),
        None => format!("#undef {0}\n#define {name} ((void)0)\n", name.split('(').next().unwrap_or_default()),
    };
    // Those who have functions of the C library as macros have the functions before.
    let library = "#include <math.h>\n#include <stdlib.h>\n#include <string.h>\n".to_owned();
    let number = macros.len();
    let macros = library + &macros.split_whitespace().map(one).collect::<String>();
    match language {
        Language::C => source(
            &format!("after_macros_{number}.c"),
            &format!("{macros}#include <asperity.h>\n#include <asperity_eval.h>\n#include <asperity_loads.h>\n"),
        ),
        Language::Cpp => source(&format!("after_macros_{number}.cpp"), &format!("{macros}#include <asperity.hpp>\n")),
    }
}

/// Whatever macros a program has when it includes the headers, it has them afterwards.
#[test]
fn headers_are_taken_after_those_of_others() {
    // Words of the last are names of C structs and arguments: a program with them has no C header.
    for (number, macros) in MACROS.into_iter().enumerate() {
        let languages = if number < 3 {
            &[(Language::Cpp, "c++17"), (Language::C, "c11")][..]
        } else {
            &[(Language::Cpp, "c++17")]
        };
        for &(language, standard) in languages {
            let file = after_macros(macros, language);
            for compiler in Compiler::all(language, standard) {
                compiler.accepts(&file);
            }
        }
    }
    let kept = "#define check(x) x\n#define Status int\n#define min(a, b) 7\n#include <asperity.hpp>\n\
                static_assert(check(true) && min(1, 2) == 7, \"\");\nStatus status = ASPERITY_OK;\n\
                int main() { (asperity::check)(status); return asperity::Params().hardness() > 0.0; }\n";
    for compiler in Compiler::all(Language::Cpp, "c++17") {
        compiler.accepts(&source("macros_are_kept.cpp", kept));
    }
}

/// The examples of the header, as programs: the one at its top whole, and the others with parameters and a model at hand.
#[test]
fn examples_of_the_header_run() {
    let header = std::fs::read_to_string(root().join("include/asperity.h")).expect("include/asperity.h");
    let blocks = header.split("* ```c\n").skip(1).map(|rest| rest.split(" * ```").next().unwrap());
    let lines =
        |block: &str| block.lines().map(|line| line.trim_start_matches(" *").to_owned() + "\n").collect::<String>();
    let blocks: Vec<String> = blocks.map(lines).collect();
    let (first, others) = blocks.split_first().expect("examples");
    assert!(others.len() > 4, "{}", others.len());
    let mut all = String::from("#include <asperity.h>\n#include <stdio.h>\n\n");
    for (i, block) in others.iter().enumerate() {
        let head = format!("static void example_{i}(asperity_params params, asperity_model *model)");
        all += &format!("{head}\n{{\n{block}    (void)params, (void)model;\n}}\n");
    }
    // A model in SI units, and what a failure left.
    all += "int main(void)\n{\n    asperity_params params;\n    asperity_model *model;\n    char message[512];\n    asperity_params_init(&params, sizeof params);\n\
            asperity_params_set_pair(&params, \"Si/Si\");\n    params.height_std = 5e-9;\n    params.summit_radius = 1e-6;\n\
            params.asperity_count = 1e5;\n    if (asperity_create(&params, &model) != ASPERITY_OK) return 1;\n";
    for i in 0..others.len() {
        all += &format!("    example_{i}(params, model);\n");
    }
    all += "    asperity_last_error(message, sizeof message);\n    puts(message);\n\
            asperity_free(model);\n    return 0;\n}\n";
    let first = source("header_first.c", &format!("#include <asperity.h>\n#include <stdio.h>\n\n{first}"));
    let all = source("header_examples.c", &all);
    for compiler in Compiler::all(Language::C, if cfg!(windows) { "c11" } else { "c89" }) {
        // A variable that an example sets for the reader.
        let compiler = if cfg!(windows) {
            compiler
        } else {
            compiler.with(&["-Wno-unused-variable", "-Wno-unused-but-set-variable"])
        };
        let printed = compiler.program(&first, Linking::Shared).succeeds(&[]);
        assert!(printed.starts_with("mu = 0.") && printed.ends_with(" at 1 mN\n"), "{printed}");
        let printed = compiler.program(&all, Linking::Shared).succeeds(&[]);
        assert!(printed.contains(" N, of 95 % of the specimens "), "{printed}");
    }
}
