#!/usr/bin/env python3
"""
make release VERSION=x.y.z: whether the tree is ready to be released as this version.

Checks that every file that has the version has this one, that the interface has only grown since the last release, that the compiler is
that of releases and that no crate has a known fault. Then runs all tests, builds dist/ and proves it. It publishes nothing: the steps that are left to a person are printed at the end. With --check it
stops before the tests.
"""

import os
import re
import subprocess
import sys

from dist import demand_clean_tree
from targets import ROOT, Refusal, run

# What programs are compiled against.
ABI = "tests/abi/abi-1.h"

# Each file that has the version, and how.
PLACES = {
    "Cargo.toml": r'^version = "(.+)"',
    "Cargo.lock": r'^name = "asperity"\nversion = "(.+)"',
    "include/asperity.h": r'^#define ASPERITY_VERSION "(.+)"',
    "cbindgen.toml": r'^#define ASPERITY_VERSION "(.+)"',
    "CITATION.cff": r"^version: (.+)",
    "fortran/asperity.f90": r"ASPERITY_HEADER_VERSION = '(.+)'",
    "python/src/asperity/_header.py": r'^ASPERITY_VERSION = "(.+)"',
    "js/package.json": r'^  "version": "(.+)"',
    "docs/javascript.md": r"asperity-(\d+\.\d+\.\d+)\.tgz",
    "packaging/debian/changelog": r"\Aasperity \((.+)-1\)",
    "packaging/spack/spack_repo/asperity/packages/asperity/package.py": r'^    version\("(.+)"\)',
    "packaging/vcpkg/asperity/vcpkg.json": r'^  "version": "(.+)"',
    "docs/install.md": r"^\./lib/libasperity\.so\.(\d+\.\d+\.\d+)$",
}

STEPS = """
What is left to do, by a person who may:
  git tag -a v{version} -m "asperity {version}" && git push origin v{version}
  the release page: a draft with the files of dist/, made by .github/workflows/release.yml when the tag arrives; publish it
  cargo publish --locked
  {venv}/bin/twine upload dist/*.whl dist/asperity-{version}.tar.gz
  then a heading for the next version at the top of CHANGELOG.md"""


def check_versions(version):
    """Refuses the first file that has another version."""
    for file, pattern in PLACES.items():
        found = re.search(pattern, (ROOT / file).read_text(encoding="utf-8"), re.MULTILINE)
        if found is None or found[1] != version:
            raise Refusal(f"{file} has {found[1] if found else 'no version'}, not {version}")
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    if not re.search(rf"^## {re.escape(version)} \(\d{{4}}-\d\d-\d\d\)$", changes, re.MULTILINE):
        raise Refusal(f"CHANGELOG.md has no heading `## {version} (DATE)`")


def check_tag(version):
    """A version is released once: its tag, if there is one, is this commit."""
    tagged = run("git", "tag", "--list", f"v{version}").strip()
    if tagged and run("git", "rev-list", "-n1", tagged) != run("git", "rev-list", "-n1", "HEAD"):
        raise Refusal(f"v{version} is the tag of another commit; a new version needs a new number")


def parts_of_abi(text):
    """The structs of tests/abi/abi-1.h with their fields, and all other declarations."""
    struct = re.compile(r"^typedef struct (\w+) {\n(.*?)^}[^\n]*\n", re.MULTILINE | re.DOTALL)
    comment = re.compile(r"^/\*.*?\*/", re.MULTILINE | re.DOTALL)
    return dict(struct.findall(text)), set(struct.sub("", comment.sub("", text)).splitlines())


def check_abi():
    """A released interface only grows: at the end of structs, by constants and by functions."""
    tags = run("git", "tag", "--list", "v*", "--sort=-version:refname").split()
    if not tags:
        return
    before, others = parts_of_abi(run("git", "show", f"{tags[0]}:{ABI}"))
    now, others_now = parts_of_abi((ROOT / ABI).read_text(encoding="utf-8"))
    changed = sorted(others - others_now) + [name for name in before if not now.get(name, "").startswith(before[name])]
    if changed:
        raise Refusal(f"{ABI} has changed since {tags[0]}, and may only grow: {changed[0]}")


def check_compiler():
    """Files of a release are built by one compiler, so that others can build the same bytes."""
    wanted = re.search(r'^rust = "(.+)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]
    found = run("rustc", "--version").split()[1]
    if found != wanted:
        raise Refusal(f"releases are built by Rust {wanted}, and this is {found}: RUSTUP_TOOLCHAIN={wanted} make release")


def main(arguments):
    """Checks, tests, builds, proves."""
    only_check = "--check" in arguments
    (version,) = [word for word in arguments if word != "--check"] or [""]
    if not version:
        raise Refusal("say which: make release VERSION=x.y.z")
    if not re.fullmatch(r"\d+\.\d+\.\d+", version):
        raise Refusal(f"'{version}' is no version; one looks like 1.2.3")
    demand_clean_tree()
    check_versions(version)
    check_tag(version)
    check_abi()
    print(f"make release: every file has {version}", flush=True)
    if only_check:
        return
    check_compiler()
    for goal in ("supply-chain", "test-all", "dist", "dist-test"):
        if subprocess.run([os.environ.get("MAKE", "make"), goal], cwd=ROOT, check=False).returncode != 0:
            raise Refusal(f"make {goal} fails")
    run("cargo", "publish", "--dry-run", "--locked", show=True)
    print(STEPS.format(version=version, venv="target/dist-venv"))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except Refusal as refusal:
        sys.exit(f"make release: {refusal}")
