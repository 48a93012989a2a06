"""The guides that start from data print what they say, in an environment with the dependencies of this one; tests/install/readme.rs
and fortran/test.sh have their programs in C and Fortran."""

from __future__ import annotations

import re
import sysconfig
from pathlib import Path

import pytest
from processes import fresh_environment, run_main
from test_docs import blocks, check_page, shows

# And the pictures that each writes.
GUIDES = {"start": (), "device-or-bead": (), "joint": (), "height-maps": ("cutoffs.svg",), "uncertainty-and-fits": ("fit.svg", "fit.png"), "studies": ("indices.svg",)}

pytestmark = pytest.mark.usefixtures("one_build_at_a_time")


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """A fresh virtual environment, active, that finds the dependencies of this one and so need not download them."""
    directory = tmp_path_factory.mktemp("venv")
    active = fresh_environment(directory)
    (packages,) = directory.glob("lib/python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    # A reader has no MPI, and mpi4py looks for its library in this environment.
    (packages / "mpi4py.py").write_text('raise ImportError("no MPI")\n', encoding="utf-8")
    return active


@pytest.mark.parametrize("guide", GUIDES)
def test_a_guide_runs_and_prints_what_it_says(root: Path, environment: dict[str, str], tmp_path: Path, guide: str) -> None:
    (tmp_path / "python").symlink_to(root / "python")
    check_page(root / "docs" / f"{guide}.md", tmp_path, environment)
    assert all((tmp_path / picture).read_bytes().startswith((b"<?xml", b"\x89PNG")) for picture in GUIDES[guide])


@pytest.mark.parametrize("guide, surfaces", (("start", 3), ("device-or-bead", 1), ("height-maps", 1)))
def test_a_surface_file_gives_the_number_below_it(root: Path, tmp_path: Path, guide: str, surfaces: int) -> None:
    page, file = root / "docs" / f"{guide}.md", tmp_path / "surface.toml"
    for i, (kind, text) in enumerate(blocks(page)):
        if kind == "toml":
            file.write_text(text, encoding="utf-8")
            at, shown = next((at, text) for at, (kind, text) in enumerate(blocks(page)) if kind == "text" and at > i)
            ((load, mu, low, high),) = re.findall(r"^mu\((\S+) N\) = (\S+), 95 % band (\S+) to (\S+)$", shown, re.MULTILINE)
            shows(page, at, shown, run_main("friction", "--surface", file, "--load", load).stdout)
            # The table at the top of the first page.
            first = (root / "docs" / "start.md").read_text(encoding="utf-8")
            assert guide == "height-maps" or f"| {mu} ({low} to {high}) at {load} N |" in first
            surfaces -= 1
    assert surfaces == 0
