#!/usr/bin/env python3
"""
make dist: what a release offers for download, in dist/.

usage: packaging/dist.py [NAME ...]

NAME is a target of packaging/targets.txt or one of the packages `sources`, `crate`, `debian`; all of them by default.
Everything is built in a temporary folder and moved to dist/ at the end: after a failure dist/ is as it was before.
"""

import hashlib
import shutil
import sys
import time
from pathlib import Path

from archives import pack
from conda import build_conda
from debian import build_debian
from sources import build_crate, build_source_archive
from stage import build_stage
from targets import ROOT, VENV, WORK, Refusal, build_environment, read_targets, run, rust_sources, version
from wheels import build_sdist, build_wheel

PACKAGES = ("sources", "crate", "debian")
# What each part needs beside cargo and make; tests/setup.sh dist installs all of it.
TOOLS = {
    "x86_64-windows": ("cmake", "x86_64-w64-mingw32-gcc", "llvm-dlltool"),
    "debian": ("dpkg-buildpackage", "dh", "dh_python3", "aarch64-linux-gnu-strip"),
}


def demand_clean_tree():
    """A release is made of a commit."""
    changes = run("git", "status", "--porcelain").splitlines()
    if changes:
        raise Refusal(f"the tree differs from the commit ({changes[0].strip()}, {len(changes)} in all): commit or stash first")


def demand_tools(targets, packages, env):
    """All that is missing, before anything is built."""
    wanted = {"git", "rustc", "llvm-strip", "zstd", "cargo-zigbuild", "python-zig"}
    for name in (*(target.name for target in targets), *packages):
        wanted.update(TOOLS.get(name, ()))
    missing = [tool for tool in sorted(wanted) if not shutil.which(tool, path=env["PATH"])]
    if not (VENV / "packages").is_file():
        missing.append(f"the tools from PyPI in {VENV}")
    if not (rust_sources() / "library" / "Cargo.lock").is_file():
        missing.append("the sources of Rust's standard library (rust-src)")
    for target in targets:
        libraries = run("rustc", "--print", "target-libdir", "--target", target.rust).strip()
        if not any(Path(libraries).glob("libstd-*")):
            missing.append(f"Rust's standard library for {target.rust}")
    if missing:
        raise Refusal(f"missing: {', '.join(missing)}; tests/setup.sh dist installs them")


class Report:
    """What was built, of what size, for what; told as it goes and again as a table."""

    def __init__(self):
        self.rows = []
        self.start = time.monotonic()

    def say(self, what):
        print(f"[{time.monotonic() - self.start:4.0f} s] {what}", flush=True)

    def add(self, file, platform, tested):
        self.rows.append((file.name, f"{file.stat().st_size / 1000:.0f} kB", platform, tested))

    def print(self):
        rows = [("file", "size", "platform", "tested by make dist-test"), *self.rows]
        widths = [max(len(row[column]) for row in rows) for column in range(4)]
        for row in rows:
            print(f"{row[0]:{widths[0]}}  {row[1]:>{widths[1]}}  {row[2]:{widths[2]}}  {row[3]}")


def build_target(target, out, env, report):
    """The archive, the wheel and the conda package for a target."""
    report.say(f"{target.name}: library")
    stage = WORK / "stage" / target.name
    shutil.rmtree(stage, ignore_errors=True)
    stage.parent.mkdir(parents=True, exist_ok=True)
    build_stage(target, stage, env)
    report.say(f"{target.name}: packages")
    name = f"asperity-{version()}-{target.name}"
    archive = out / f"{name}.{target.archive}"
    pack(stage, archive, int(env["SOURCE_DATE_EPOCH"]), name)
    report.add(archive, target.name, target.tested)
    if target.wheel:
        report.add(build_wheel(target, stage, out, env), target.name, target.tested)
    if target.conda:
        report.add(build_conda(target, stage, out, env), target.name, target.tested)


DEBIAN_TESTED = {"amd64": "installed in a system without Rust", "arm64": "unpacked; a C program run in qemu"}


def build_packages(packages, out, env, report):
    """What is of no target of the list."""
    for package in packages:
        report.say(package)
        if package == "sources":
            report.add(build_source_archive(out, env), "any, with Rust", "built without a network")
            report.add(build_sdist(out, env), "any, with Rust", "installed by pip")
        elif package == "crate":
            report.add(build_crate(out, env), "any, with Rust", "built by cargo package")
        else:
            for architecture, tested in DEBIAN_TESTED.items():
                for file in build_debian(architecture, out, env):
                    report.add(file, f"Debian 12, {architecture}", tested)


def write_sums(out):
    """SHA256SUMS, as sha256sum -c reads it."""
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in sorted(out.iterdir())]
    (out / "SHA256SUMS").write_text("".join(lines), encoding="utf-8")


def main(names):
    """Builds the parts that are named."""
    known = read_targets()
    unknown = [name for name in names if name not in known and name not in PACKAGES]
    if unknown:
        raise Refusal(f"no target '{unknown[0]}'; there are {', '.join((*known, *PACKAGES))}")
    targets = [target for name, target in known.items() if not names or name in names]
    packages = [name for name in PACKAGES if not names or name in names]
    demand_clean_tree()
    env = build_environment()
    demand_tools(targets, packages, env)

    out = WORK / "out"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    report = Report()
    for target in targets:
        build_target(target, out, env, report)
    build_packages(packages, out, env, report)
    write_sums(out)
    shutil.rmtree(ROOT / "dist", ignore_errors=True)
    shutil.move(out, ROOT / "dist")
    report.print()
    print(f"in dist/, with SHA256SUMS, built by {run('rustc', '--version').strip()}")


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Refusal as refusal:
        sys.exit(f"make dist: {refusal}")
