"""The licences of what the library contains of others: the crates that are linked in, and Rust's standard library."""

import json
import shutil
from pathlib import Path

from targets import Refusal, run

RUST_PAGE = "LICENSE-RUST-LIBRARY.html"


def linked_crates(rust_target):
    """Packages whose code is in the library for a target: neither those of tests nor those that only the compiler runs."""
    data = json.loads(run("cargo", "metadata", "--format-version=1", "--locked", "--filter-platform", rust_target))
    packages = {package["id"]: package for package in data["packages"]}
    nodes = {node["id"]: node for node in data["resolve"]["nodes"]}
    found, waiting = {}, [data["resolve"]["root"]]
    while waiting:
        for dependency in nodes[waiting.pop()]["deps"]:
            package = packages[dependency["pkg"]]
            normal = any(kind["kind"] is None for kind in dependency["dep_kinds"])
            runs_in_compiler = any("proc-macro" in target["kind"] for target in package["targets"])
            if normal and not runs_in_compiler and package["id"] not in found:
                found[package["id"]] = package
                waiting.append(package["id"])
    return sorted(found.values(), key=lambda package: package["name"])


def licence_texts(package):
    """The licence files of a crate."""
    folder = Path(package["manifest_path"]).parent
    files = sorted(file for file in folder.iterdir() if file.name.upper().startswith(("LICENSE", "COPYING", "NOTICE")))
    if not files:
        raise Refusal(f"{package['name']} {package['version']} has no licence file in {folder}")
    return "\n".join(f"--- {file.name} ---\n\n{file.read_text(encoding='utf-8')}" for file in files)


def write_notices(rust_target, folder):
    """Writes LICENSE-THIRD-PARTY.txt and Rust's own page about its standard library into a folder."""
    said = Path(run("rustc", "--print", "sysroot").strip()) / "share" / "doc" / "rust" / "COPYRIGHT-library.html"
    if not said.is_file():
        raise Refusal(f"{said} is missing: the notices of Rust's standard library; install Rust from https://rustup.rs")
    parts = [
        "The asperity library contains the crates below, under the licences printed here, and Rust's standard library,\n"
        f"whose licences and those of what it contains are in {RUST_PAGE}.\n"
    ]
    for package in linked_crates(rust_target):
        title = f"{package['name']} {package['version']}, {package['license']}, {package['repository']}"
        parts.append(f"{'=' * len(title)}\n{title}\n{'=' * len(title)}\n\n{licence_texts(package)}")
    (folder / "LICENSE-THIRD-PARTY.txt").write_text("\n".join(parts), encoding="utf-8")
    shutil.copyfile(said, folder / RUST_PAGE)
