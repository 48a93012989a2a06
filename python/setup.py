"""Builds the Rust library with cargo and puts it inside the package. All else about the package is in pyproject.toml.

The crate is the directory above in a checkout, and `rust/` in a source distribution, into which `sdist` copies it.
ASPERITY_PREBUILT names a library that was built for the wheel's platform, to be packed in place of one that cargo builds here;
ASPERITY_NOTICES the folder of the licences of what is in it.
"""

import json
import os
import platform
import re
import shutil
import subprocess
import tempfile
from contextlib import contextmanager
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.bdist_wheel import bdist_wheel
from setuptools.command.build_py import build_py
from setuptools.command.sdist import sdist
from setuptools.errors import ExecError

HERE = Path(__file__).resolve().parent
CRATE = next((d for d in (HERE / "rust", HERE.parent) if (d / "Cargo.toml").is_file()), None)
if CRATE is None:
    raise ExecError(
        f"asperity: no Rust sources beside {HERE}: install from a checkout (pip 21.3 or later), a wheel or an sdist"
    )
# What cargo needs to build the library, and the licences.
CRATE_FILES = ("Cargo.toml", "Cargo.lock", "src", "include", "LICENSE*")
# C that goes into the package: asperity.mujoco compiles its plugin, whose sources are also those of other languages.
PLUGIN_FILES = ("hosts/mujoco/plugin.c", "hosts/mujoco/microslip.h", "hosts/mujoco/asperity_mujoco.h")
PACKAGE_FILES = ("include/asperity.h", "include/asperity_loads.h", *PLUGIN_FILES)


def version():
    """The version of the crate, which is the version of the package."""
    return re.search(r'^version = "(.+)"', (CRATE / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]


def demand_rust(cargo):
    """Says in one line, in the words of cmake/check_rust.sh, that Rust is missing or too old."""
    needed = re.search(r'^rust-version = "(.+)"', (CRATE / "Cargo.toml").read_text(encoding="utf-8"), re.MULTILINE)[1]
    for command in (cargo, os.environ.get("RUSTC", "rustc")):
        try:
            said = subprocess.run([command, "--version"], cwd=CRATE, capture_output=True, encoding="utf-8", check=False)
            found = re.search(r"\d+\.\d+", said.stdout)
        except OSError:
            found = None
        if not found or [int(n) for n in found[0].split(".")] < [int(n) for n in needed.split(".")]:
            raise ExecError(
                f"asperity needs Rust {needed} or later (found {found[0] if found else 'none'}): https://rustup.rs"
            )


def cargo_build():
    """Builds the shared library and returns its path, as cargo tells it: CARGO_TARGET_DIR and the like are cargo's."""
    cargo = os.environ.get("CARGO", "cargo")
    command = [cargo, "build", "--release", "--locked", "--lib", "--message-format=json-render-diagnostics"]
    demand_rust(cargo)
    done = subprocess.run(command, cwd=CRATE, stdout=subprocess.PIPE, encoding="utf-8", check=False)
    if done.returncode != 0:
        raise ExecError(f"asperity: '{' '.join(command)}' failed in {CRATE}; its messages are above")
    messages = [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]
    for message in messages:
        if message["reason"] == "compiler-artifact" and "cdylib" in message["target"]["kind"]:
            for file in map(Path, message["filenames"]):
                if file.suffix in (".so", ".dylib", ".dll"):
                    return file
    raise ExecError(f"asperity: '{' '.join(command)}' made no shared library")


class BuildWithLibrary(build_py):
    """Adds the library and C sources to the modules; an editable install keeps them among the sources."""

    def run(self):
        super().run()
        library = Path(os.environ.get("ASPERITY_PREBUILT") or cargo_build())
        package = HERE / "src" / "asperity" if self.editable_mode else Path(self.build_lib) / "asperity"
        package.mkdir(parents=True, exist_ok=True)
        for file in (library, *(CRATE / name for name in PACKAGE_FILES)):
            shutil.copy2(file, package)


class PlatformWheel(bdist_wheel):
    """Tags the wheel for any Python 3 of one platform: ctypes calls the library, no Python ABI is involved."""

    def get_tag(self):
        tag = super().get_tag()[2]
        # cargo builds for one processor, also where Python itself is built for two.
        return "py3", "none", tag.replace("universal2", platform.machine())


class SourceWithCrate(sdist):
    """Adds the crate, so that the source distribution builds with cargo alone."""

    def make_release_tree(self, base_dir, files):
        super().make_release_tree(base_dir, files)
        rust = Path(base_dir) / "rust"
        rust.mkdir(exist_ok=True)
        for source in (path for pattern in CRATE_FILES for path in CRATE.glob(pattern)):
            if source.is_dir():
                shutil.copytree(source, rust / source.name, dirs_exist_ok=True)
            else:
                shutil.copy2(source, rust)
        for name in PLUGIN_FILES:
            (rust / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(CRATE / name, rust / name)


class BinaryDistribution(Distribution):
    """Tells setuptools that the package is not pure Python."""

    def has_ext_modules(self):
        return True


@contextmanager
def licences():
    """Lays the licences beside pyproject.toml, which can name no others, for as long as setuptools works."""
    folders = [CRATE, *(Path(named) for named in [os.environ.get("ASPERITY_NOTICES")] if named)]
    names = {file.name: file for folder in folders for file in folder.glob("LICENSE*") if not (HERE / file.name).exists()}
    try:
        for name, file in names.items():
            shutil.copyfile(file, HERE / name)
        yield
    finally:
        for name in names:
            (HERE / name).unlink(missing_ok=True)


# A build directory of its own for each run: nothing stale gets into a wheel, nothing is left in the checkout.
with tempfile.TemporaryDirectory(prefix="asperity-build-") as build_base, licences():
    setup(
        version=version(),
        distclass=BinaryDistribution,
        cmdclass={"build_py": BuildWithLibrary, "bdist_wheel": PlatformWheel, "sdist": SourceWithCrate},
        options={"build": {"build_base": build_base}},
    )
