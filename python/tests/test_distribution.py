"""Wheel and source distribution: the tag, the contents, an installation of each into an empty environment."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import sysconfig
import tarfile
import venv
import zipfile
from pathlib import Path

import pytest
from processes import outside

from asperity import Model, Params, __version__, _library

NUMBER = """
from asperity import Model, Params, _library
print(Model(Params.paper()).friction_at_load(100.0).hex())
print(_library.PATH)
"""


def run(*command: object, **environment: str) -> str:
    words = [str(word) for word in command]
    done = subprocess.run(words, env=outside(**environment), capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def number_from(wheel: Path, directory: Path) -> list[str]:
    """Installs a wheel into a fresh environment, and asks it for a number."""
    venv.create(directory)
    python = directory / "bin" / "python"
    run(sys.executable, "-m", "pip", "--python", python, "install", wheel)
    return run(python, "-c", NUMBER).split()


pytestmark = pytest.mark.usefixtures("one_build_at_a_time")


@pytest.fixture(scope="module")
def wheel(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    directory = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "pip", "wheel", "--no-deps", "--wheel-dir", directory, root / "python")
    (found,) = directory.iterdir()
    return found


def test_the_wheel_is_for_any_python_3_of_this_platform(wheel: Path) -> None:
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    assert wheel.name == f"asperity-{__version__}-py3-none-{platform}.whl"
    with zipfile.ZipFile(wheel) as archive:
        (metadata,) = (name for name in archive.namelist() if name.endswith(".dist-info/WHEEL"))
        lines = archive.read(metadata).decode().splitlines()
    assert f"Tag: py3-none-{platform}" in lines and "Root-Is-Purelib: false" in lines


def test_the_wheel_contains_the_package_and_one_library(root: Path, wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        inside = {name for name in archive.namelist() if ".dist-info/" not in name}
        library = archive.read(f"asperity/{Path(_library.PATH).name}")
    source = root / "python" / "src"
    modules = {file.relative_to(source).as_posix() for file in (source / "asperity").rglob("*.py")}
    units = ("fmu2.c", "fmu3.c", "fmu_unit.h", "fmu_microslip.h", "fmu_saved.h", "fmu_dll.h")
    c_files = (*(f"hosts/{unit}" for unit in units), "asperity.h", "asperity_loads.h", "plugin.c", "microslip.h", "asperity_mujoco.h")
    assert inside == modules | {f"asperity/{name}" for name in ("py.typed", *c_files, Path(_library.PATH).name)}
    assert library[:4] == b"\x7fELF" or sys.platform != "linux"


def test_an_installed_wheel_gives_the_same_number(params: Params, wheel: Path, tmp_path: Path) -> None:
    number, path = number_from(wheel, tmp_path)
    with Model(params) as model:
        assert float.fromhex(number) == model.friction_at_load(100.0)
    assert Path(path).is_relative_to(tmp_path)


def test_a_source_distribution_builds_away_from_the_checkout(params: Params, root: Path, tmp_path: Path) -> None:
    # In this environment, which has what pyproject.toml asks for: that it does so, the wheel above has shown.
    run(sys.executable, "-m", "build", "--sdist", "--no-isolation", "--outdir", tmp_path, root / "python")
    (sdist,) = tmp_path.glob("*.tar.gz")
    with tarfile.open(sdist) as archive:
        names = archive.getnames()
    for name in ("rust/Cargo.toml", "rust/Cargo.lock", "rust/src/lib.rs", "rust/hosts/mujoco/plugin.c", "setup.py"):
        assert f"asperity-{__version__}/{name}" in names
    assert not [name for name in names if name.endswith((".so", ".dylib", ".dll"))]

    # A target directory of its own, kept between runs: cargo would take the crate for another one. Compiled quickly: the
    # bits do not depend on how.
    target = Path(os.environ.get("CARGO_TARGET_DIR", root / "target")) / "python-sdist"
    quickly = {"CARGO_TARGET_DIR": str(target.resolve()), "CARGO_PROFILE_RELEASE_LTO": "off",
               "CARGO_PROFILE_RELEASE_OPT_LEVEL": "1", "CARGO_PROFILE_RELEASE_CODEGEN_UNITS": "16"}  # fmt: skip
    wheels = tmp_path / "wheels"
    run(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "-w", wheels, sdist, **quickly)
    number, _ = number_from(next(wheels.iterdir()), tmp_path / "venv")
    with Model(params) as model:
        assert float.fromhex(number) == model.friction_at_load(100.0)


def test_without_cargo_the_build_says_what_to_install(root: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", root / "python"],
        env={**os.environ, "CARGO": "no-such-cargo"}, capture_output=True, text=True, timeout=600, check=False,
    )  # fmt: skip
    assert done.returncode != 0
    line = r"asperity needs Rust 1\.\d+ or later \(found none\): https://rustup.rs"
    assert re.search(line, done.stdout + done.stderr), done.stderr
