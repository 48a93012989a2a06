"""Fixtures that several files use: the repository, its default surfaces, a C compiler."""

from __future__ import annotations

import fcntl
import os
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Callable, Iterator

import pytest

from asperity import Model, Params

ROOT = Path(__file__).resolve().parents[2]
HARD_CARBON = ROOT / "hosts" / "surface.toml"  # the surface of all hosts


@pytest.fixture(scope="session")
def root() -> Path:
    return ROOT


@pytest.fixture(scope="module")
def one_build_at_a_time() -> Iterator[None]:
    """For files whose tests install the package from this tree: pip builds it in a folder of the tree."""
    with open(Path(tempfile.gettempdir()) / f"asperity-build-{os.getuid()}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


@pytest.fixture(scope="session")
def params() -> Params:
    """The paper's default case."""
    return Params.paper()


@pytest.fixture(scope="session")
def sticky() -> Params:
    """Adhesion strong enough to hold a pulling load of the order of the loads that press."""
    return Params.dimensionless(alpha=0.01, beta=1000, gamma=0.02)


@pytest.fixture
def model(params: Params) -> Iterator[Model]:
    with Model(params) as model:
        yield model


@pytest.fixture(scope="session")
def compile_c() -> Callable[..., None]:
    """Runs the C compiler."""

    def compile_c(*arguments: object) -> None:
        if shutil.which("cc") is None:
            pytest.fail("this test needs a C compiler named cc: apt-get install gcc libc6-dev")
        subprocess.run(["cc", *map(str, arguments)], check=True, timeout=600)

    return compile_c
