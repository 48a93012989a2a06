"""The list of targets, packaging/targets.txt, and what every build of a release has in common."""

import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# What is built and what is kept between runs lies here; tests/setup.sh dist puts the tools from PyPI beside it.
WORK = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve() / "dist"
VENV = WORK.parent / "dist-venv"


@dataclass(frozen=True)
class Target:
    """A line of targets.txt; what the target has not is None."""

    name: str
    rust: str
    linker: "str | None"
    archive: str
    wheel: "str | None"
    conda: "str | None"
    tested: str

    @property
    def zig(self):
        """Zig's name of the target where zig links it."""
        return self.linker if self.linker and not self.linker.endswith("-gcc") else None

    @property
    def shared(self):
        """The shared library, in an installation."""
        if "windows" in self.rust:
            return "bin/asperity.dll"
        if "wasm32" in self.rust:
            return "lib/asperity.wasm"
        return "lib/libasperity.dylib" if "apple" in self.rust else "lib/libasperity.so"


def read_targets():
    """Targets by their names."""
    lines = (ROOT / "packaging" / "targets.txt").read_text(encoding="utf-8").splitlines()
    rows = [line.split(maxsplit=6) for line in lines if line and not line.startswith("#")]
    return {row[0]: Target(*(None if word == "-" else word for word in row)) for row in rows}


class Refusal(Exception):
    """Why nothing is built, in a line that says what to do."""


def demand_size(file, limit, of):
    """Refuses a file that is heavier than files of its kind may be."""
    size = file.stat().st_size
    if size > limit:
        raise Refusal(f"{of}: {file.name} has {size} bytes; at most {limit} are allowed")


def run(*command, cwd=ROOT, env=None, show=False):
    """Runs a command and returns what it prints; shows all of its output if it fails."""
    done = subprocess.run(
        list(map(str, command)), cwd=cwd, env=env, encoding="utf-8", errors="replace", check=False,
        stdout=subprocess.PIPE, stderr=None if show else subprocess.PIPE,
    )  # fmt: skip
    if done.returncode != 0:
        sys.stderr.write(done.stdout + (done.stderr or ""))
        raise Refusal(f"failed: {' '.join(map(str, command))}")
    return done.stdout


def version():
    """The version in Cargo.toml."""
    return re.search(r'^version = "(.+)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]


def build_environment():
    """
    The environment of all builds: no path of this machine and no date but that of the commit gets into a file, and
    what the user set for builds of their own does not either.
    """
    dropped = re.compile(r"(CARGO_(?!HOME$)|RUST(?!UP_)|MAKE|MFLAGS|CFLAGS|LDFLAGS|DESTDIR|PREFIX|LIBDIR|ASPERITY_).*")
    env = {name: value for name, value in os.environ.items() if not dropped.fullmatch(name)}
    # Of two that fit the compiler takes the later. The same for all builds, so that what is built once serves them all.
    places = (
        (env.get("CARGO_HOME", Path.home() / ".cargo"), "/cargo"),
        (rust_sources(), "/rust"),
        (ROOT, "/asperity"),
        (WORK, "/built"),
        (WORK / "debian" / "asperity", "/asperity"),
    )
    env["RUSTFLAGS"] = " ".join(f"--remap-path-prefix={place}={name}" for place, name in places)
    env["SOURCE_DATE_EPOCH"] = run("git", "log", "-1", "--format=%ct").strip()
    env["PATH"] = f"{VENV / 'bin'}:{env['PATH']}"
    env["CARGO_TARGET_DIR"] = str(WORK / "cargo")
    env["CARGO_PROFILE_RELEASE_STRIP"] = "symbols"
    env.update(linker_environment(), MACOSX_DEPLOYMENT_TARGET="11.0", LC_ALL="C", TZ="UTC")
    return env


def rust_sources():
    """Where rustup puts the sources of Rust's standard library, its component rust-src."""
    if not shutil.which("rustc"):
        raise Refusal("missing: rustc, the compiler of Rust: https://rustup.rs")
    return Path(run("rustc", "--print", "sysroot").strip()) / "lib" / "rustlib" / "src" / "rust"


def small_std_environment():
    """
    What makes cargo build Rust's standard library along, without the part that gives the addresses in the trace of a panic
    their names. That takes a quarter of the library, and in a stripped one it finds no names. The compiler is the released
    one; that it may do so is what cargo calls unstable.
    """
    return {"RUSTC_BOOTSTRAP": "1", "CARGO_UNSTABLE_BUILD_STD": "std,panic_unwind", "CARGO_UNSTABLE_BUILD_STD_FEATURES": ""}


def linker_environment():
    """
    What makes cargo link by the compiler that zig is, behind scripts as cargo knows only programs. The same for all builds: what
    the compiler runs, and the standard library with it, cargo builds again if this machine's own linker is another one.
    """
    env = {}
    for target in read_targets().values():
        if target.zig:
            script = WORK / "linkers" / target.name
            script.parent.mkdir(parents=True, exist_ok=True)
            script.write_text(f'#!/bin/sh\nexec cargo-zigbuild zig cc -- -target {target.zig} "$@"\n', encoding="utf-8")
            script.chmod(0o755)
            env[f"CARGO_TARGET_{target.rust.upper().replace('-', '_')}_LINKER"] = str(script)
    return env
