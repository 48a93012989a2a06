//! Programs in C and C++: compiled by this system's compilers, linked with the library that cargo built for this test, run.
//!
//! On Linux each program meets GCC and Clang, elsewhere the system's compiler; `CC` and `CXX` name one to be used alone.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Language {
    C,
    Cpp,
}

/// How a program meets the library.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Linking {
    Shared,
    Static,
}

/// A compiler with a standard of the language and options.
#[derive(Debug, Clone)]
pub struct Compiler {
    language: Language,
    standard: &'static str,
    command: Option<&'static str>,
    optimisation: u32,
    options: Vec<&'static str>,
}

impl Compiler {
    /// A named compiler.
    pub fn named(command: &'static str, language: Language, standard: &'static str) -> Self {
        Self { language, standard, command: Some(command), optimisation: 1, options: Vec::new() }
    }

    /// Those that programs of a language and standard are to be compiled by.
    pub fn all(language: Language, standard: &'static str) -> Vec<Self> {
        let (variable, commands) = match language {
            Language::C => ("CC", ["gcc", "clang"]),
            Language::Cpp => ("CXX", ["g++", "clang++"]),
        };
        if cfg!(target_os = "linux") && std::env::var_os(variable).is_none() {
            commands.map(|command| Self::named(command, language, standard)).into()
        } else {
            vec![Self { command: None, ..Self::named("", language, standard) }]
        }
    }

    pub fn optimised(mut self, level: u32) -> Self {
        self.optimisation = level;
        self
    }

    pub fn with(mut self, options: &[&'static str]) -> Self {
        self.options.extend(options);
        self
    }

    fn tool(&self) -> cc::Tool {
        let target = target();
        let mut build = cc::Build::new();
        build
            .cpp(self.language == Language::Cpp)
            .std(self.standard)
            .opt_level(self.optimisation)
            .target(&target)
            .host(&target)
            .debug(false)
            .cargo_output(false)
            .cargo_metadata(false)
            .emit_rerun_if_env_changed(false);
        if let Some(command) = self.command {
            build.compiler(command);
        }
        let tool = build.try_get_compiler().unwrap_or_else(|error| panic!("no compiler: {error}; {}", needed()));
        assert!(
            Command::new(tool.path()).arg("--version").output().is_ok(),
            "{} is missing; {}",
            tool.path().display(),
            needed()
        );
        tool
    }

    /// Whether the compiler takes a source without a warning; nothing is linked.
    pub fn accepts(&self, source: &Path) {
        let folder = folder(source, self);
        let tool = self.tool();
        let mut command = self.command_with(&tool, true);
        command.arg(if tool.is_like_msvc() { "/c" } else { "-c" }).arg(source).current_dir(&folder);
        succeeds(&mut command);
    }

    /// Compiles a program, without a warning.
    pub fn program(&self, source: &Path, linking: Linking) -> Program {
        let folder = folder(source, self);
        let tool = self.tool();
        let mut command = self.command_with(&tool, false);
        let path = folder.join(format!("program-{linking:?}{}", std::env::consts::EXE_SUFFIX));
        let library = library_folder();
        command.arg(source).current_dir(&folder);
        if tool.is_like_msvc() {
            command.arg(format!("/Fe:{}", path.display()));
            match linking {
                Linking::Shared => command.arg(library.join("asperity.dll.lib")),
                Linking::Static => command.arg(library.join("asperity.lib")).args(WINDOWS_LIBRARIES),
            };
        } else {
            command.arg("-o").arg(&path);
            match linking {
                Linking::Shared => {
                    command.arg(format!("-L{}", library.display())).arg("-lasperity");
                    command.arg(format!("-Wl,-rpath,{}", library.display()))
                }
                Linking::Static => command.arg(library.join("libasperity.a")),
            };
            command.args(["-lm", "-lpthread"]);
            if cfg!(target_os = "linux") {
                command.arg("-ldl");
            }
        }
        succeeds(&mut command);
        Program { path, compiler: format!("{self:?}") }
    }

    fn command_with(&self, tool: &cc::Tool, strictest: bool) -> Command {
        let mut command = tool.to_command();
        if tool.is_like_msvc() {
            // Programs use what this compiler calls unsafe.
            command.args(if strictest { ["/W4", "/WX"] } else { ["/W3", "/D_CRT_SECURE_NO_WARNINGS"] });
        } else {
            command.args(["-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
        }
        command.args(&self.options).arg(format!("-I{}", root().join("include").display()));
        command
    }
}

/// What code linked statically needs of Windows.
const WINDOWS_LIBRARIES: [&str; 5] = ["kernel32.lib", "ntdll.lib", "userenv.lib", "ws2_32.lib", "dbghelp.lib"];

/// A compiled program.
pub struct Program {
    path: PathBuf,
    compiler: String,
}

impl Program {
    /// Runs it with arguments.
    pub fn run(&self, arguments: &[&str]) -> Output {
        self.finish(self.command().args(arguments))
    }

    /// Runs it with its standard output into a file.
    pub fn run_into(&self, file: std::fs::File) -> Output {
        self.finish(self.command().stdout(file))
    }

    fn command(&self) -> Command {
        let mut command = Command::new(&self.path);
        // Where Windows looks for the library.
        let mut paths = vec![library_folder()];
        paths.extend(std::env::split_paths(&std::env::var_os("PATH").unwrap_or_default()));
        command.env("PATH", std::env::join_paths(paths).expect("paths")).current_dir(root());
        // cargo names the folder above first, where a library of an earlier build may lie.
        command.env_remove("LD_LIBRARY_PATH").env_remove("DYLD_LIBRARY_PATH");
        command
    }

    fn finish(&self, command: &mut Command) -> Output {
        command.output().unwrap_or_else(|error| panic!("{}: {error}", self.path.display()))
    }

    /// Runs it; fails unless it succeeds. Returns what it printed.
    pub fn succeeds(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        assert!(
            output.status.success(),
            "{} {arguments:?} of {}: {}\n{}",
            self.path.display(),
            self.compiler,
            output.status,
            text(&output.stderr)
        );
        text(&output.stdout)
    }
}

/// The folder of the repository.
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// What a program printed, with the ends of lines of Unix.
pub fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).replace("\r\n", "\n")
}

/// A source that is written for one test.
pub fn source(name: &str, text: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    path
}

/// Where cargo put the library: beside the program of this test.
pub fn library_folder() -> PathBuf {
    let program = std::env::current_exe().expect("the path of this program");
    program.parent().expect("its folder").to_owned()
}

/// A folder for what one compiler makes of one source in one test, so that tests may run beside each other.
fn folder(source: &Path, compiler: &Compiler) -> PathBuf {
    let test = std::thread::current().name().unwrap_or("test").replace("::", "-");
    let name = source.file_name().expect("a file").to_string_lossy().into_owned();
    let optimisation = compiler.optimisation.to_string();
    let how = [compiler.command.unwrap_or("default"), compiler.standard, &optimisation, &compiler.options.concat()];
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test).join(format!("{name}-{}", how.join("-")));
    std::fs::create_dir_all(&folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    folder
}

fn succeeds(command: &mut Command) {
    let output = command.output().unwrap_or_else(|error| panic!("{command:?}: {error}; {}", needed()));
    let (said, complained) = (text(&output.stdout), text(&output.stderr));
    assert!(output.status.success(), "{command:?}: {}\n{said}{complained}", output.status);
}

fn needed() -> &'static str {
    if cfg!(target_os = "linux") {
        "tests/setup.sh core installs what is needed, or set CC and CXX to a compiler that you have"
    } else if cfg!(windows) {
        "install the C++ build tools of Visual Studio"
    } else {
        "install Clang, for macOS with xcode-select --install"
    }
}

/// The name of this system for the compiler.
fn target() -> String {
    let system = if cfg!(all(target_os = "linux", target_env = "musl")) {
        "unknown-linux-musl"
    } else if cfg!(target_os = "linux") {
        "unknown-linux-gnu"
    } else if cfg!(target_os = "macos") {
        "apple-darwin"
    } else if cfg!(all(windows, target_env = "msvc")) {
        "pc-windows-msvc"
    } else if cfg!(windows) {
        "pc-windows-gnu"
    } else {
        panic!("tests/common/c_compiler.rs has no name for this system: add it")
    };
    format!("{}-{system}", std::env::consts::ARCH)
}
