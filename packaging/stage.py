"""The files of a ready library for one target: an installation, with the example, the licences and the notices."""

import re
import shutil

from notices import write_notices
from size import LIBRARY_LIMIT
from targets import ROOT, WORK, demand_size, run, small_std_environment


def build_stage(target, folder, env):
    """Builds the library for a target and fills `folder` with the installation."""
    env = env | {"CARGO_BUILD_TARGET": target.rust}
    if "wasm32" not in target.rust:  # whose library has no traces
        env |= small_std_environment()
    if target.rust.endswith("musl"):
        env["RUSTFLAGS"] += " -C target-feature=-crt-static"  # else there is no shared library
    if "windows" in target.rust:
        install_with_cmake(target, folder, env)
        add_msvc_import_library(folder)
    elif "wasm32" in target.rust:
        install_wasm(target, folder, env)
    else:
        # cargo, not make, knows what is out of date: options of the compiler count too.
        shutil.rmtree(WORK / "cargo" / "install" / f"package-{target.rust}", ignore_errors=True)
        destdir = folder.with_name(folder.name + ".destdir")
        run("make", "-f", "cmake/install.mk", "install", f"DESTDIR={destdir}", "PREFIX=/asperity", env=env)
        (destdir / "asperity").rename(folder)
        destdir.rmdir()
    if "wasm32" not in target.rust:  # llvm-strip refuses static libraries for WebAssembly
        run("llvm-strip", "--strip-debug", folder / "lib" / "libasperity.a")
    add_common_files(target, folder)
    demand_size(folder / target.shared, LIBRARY_LIMIT, target.name)


def install_with_cmake(target, folder, env):
    """For Windows, which `make install` does not know."""
    build = WORK / f"cmake-{target.name}"
    shutil.rmtree(build, ignore_errors=True)
    run(
        "cmake", "-S", ROOT, "-B", build, "-DCMAKE_SYSTEM_NAME=Windows", "-DCMAKE_SYSTEM_PROCESSOR=x86_64",
        f"-DCMAKE_C_COMPILER={target.linker}", f"-DASPERITY_RUST_TARGET={target.rust}",
        "-DCMAKE_INSTALL_PREFIX=/asperity", env=env,
    )  # fmt: skip
    run("cmake", "--build", build, env=env)
    run("cmake", "--install", build, "--prefix", folder, env=env)


def add_msvc_import_library(folder):
    """asperity.dll.lib, with which Microsoft's linker links the DLL; the CMake package finds it."""
    names = sorted(set(re.findall(r"\b(asperity_\w+)\(", (folder / "include" / "asperity.h").read_text("utf-8"))))
    definitions = folder / "asperity.def"
    definitions.write_text("LIBRARY asperity.dll\nEXPORTS\n" + "".join(f"    {name}\n" for name in names), "utf-8")
    run("llvm-dlltool", "-m", "i386:x86-64", "-d", definitions, "-l", folder / "lib" / "asperity.dll.lib")
    definitions.unlink()


def install_wasm(target, folder, env):
    """The module, the library to link with other code for WebAssembly, and the C header."""
    run("cargo", "rustc", "--release", "--locked", "--lib", "--crate-type", "cdylib,staticlib",
        "--target", target.rust, env=env)  # fmt: skip
    built = WORK / "cargo" / target.rust / "release"
    for source, to in (
        (built / "asperity.wasm", folder / "lib"),
        (built / "libasperity.a", folder / "lib"),
        (ROOT / "include" / "asperity.h", folder / "include"),
        (ROOT / "LICENSE-MIT", folder / "share" / "licenses" / "asperity"),
        (ROOT / "LICENSE-APACHE", folder / "share" / "licenses" / "asperity"),
    ):
        to.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, to)


def add_common_files(target, folder):
    """What is the same for all targets."""
    examples = folder / "share" / "asperity" / "examples"
    examples.mkdir(parents=True, exist_ok=True)
    for example in (ROOT / "c_examples").iterdir():
        shutil.copy2(example, examples)
    shutil.copy2(ROOT / "README.md", folder)
    write_notices(target.rust, folder / "share" / "licenses" / "asperity")
