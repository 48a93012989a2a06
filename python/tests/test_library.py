"""Which library is loaded, and what happens with one that does not fit."""

from __future__ import annotations

import importlib.metadata
import os
import subprocess
import sys
from pathlib import Path
from typing import Callable

import asperity
from asperity import _library

FUNCTIONS = "unsigned asperity_abi_version(void) { return 999; }\n"


def import_with(library: object) -> subprocess.CompletedProcess[str]:
    """Imports the package with ASPERITY_LIBRARY set."""
    return subprocess.run(
        [sys.executable, "-c", "import asperity._library as library; print(library.PATH)"],
        env={**os.environ, "ASPERITY_LIBRARY": str(library)},
        capture_output=True,
        text=True,
        timeout=600,
        check=False,
    )


def refusal(library: object) -> str:
    done = import_with(library)
    assert done.returncode == 1 and done.stdout == ""
    last = done.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError: asperity: ")
    assert "ASPERITY_LIBRARY" in last
    return last


def test_the_library_is_inside_the_package() -> None:
    assert Path(_library.PATH).parent == Path(asperity.__file__).parent


def test_package_header_and_library_are_of_one_version(root: Path) -> None:
    assert f'\nversion = "{asperity.__version__}"\n' in (root / "Cargo.toml").read_text(encoding="utf-8")
    assert asperity.__version__ == importlib.metadata.version("asperity") == _library.version()


def test_another_library_may_be_named(tmp_path: Path) -> None:
    other = tmp_path / "other.so"
    other.write_bytes(Path(_library.PATH).read_bytes())
    assert import_with(other).stdout.strip() == str(other)
    assert import_with("").stdout.strip() == _library.PATH


def test_a_library_of_another_abi_is_refused(compile_c: Callable[..., None], tmp_path: Path) -> None:
    source, library = tmp_path / "other.c", tmp_path / "libother.so"
    source.write_text(FUNCTIONS)
    compile_c("-shared", "-fPIC", source, "-o", library)
    assert f"{library} has ABI version 999, this package was written for version 1" in refusal(library)


def test_a_library_that_lacks_a_function_is_refused(compile_c: Callable[..., None], tmp_path: Path) -> None:
    source, library = tmp_path / "other.c", tmp_path / "libother.so"
    source.write_text(FUNCTIONS.replace("999", "1"))
    compile_c("-shared", "-fPIC", source, "-o", library)
    message = refusal(library)
    assert f"{library} is not an asperity library" in message and "undefined symbol: asperity_" in message


def test_a_file_that_is_no_library_is_refused(tmp_path: Path) -> None:
    (tmp_path / "text.so").write_text("not a library")
    assert "cannot load the library" in refusal(tmp_path / "text.so")
    assert "cannot load the library" in refusal(tmp_path / "missing.so")


def test_importing_the_package_imports_no_more_than_a_model_needs() -> None:
    """Which takes some 45 ms beside NumPy; height maps and studies would double it."""
    program = "import sys, asperity; print(*sys.modules)"
    found = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=600, check=True).stdout.split()
    assert "asperity.model" in found
    assert not {"asperity.maps.analysis", "asperity.studies.study", "concurrent.futures", "numpy.random", "statistics"} & set(found)
