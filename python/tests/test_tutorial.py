"""The pages on height maps do what they say, from installing to a program in C; their table is what maps give."""

from __future__ import annotations

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest
from processes import fresh_environment
from test_docs import check_page


pytestmark = pytest.mark.usefixtures("one_build_at_a_time")


@pytest.fixture(scope="module")
def environment(root: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """A fresh virtual environment, active, that finds the dependencies of this one and so need not download them."""
    directory = tmp_path_factory.mktemp("venv")
    active = fresh_environment(directory)
    (packages,) = directory.glob("lib/python*/site-packages")
    (packages / "dependencies.pth").write_text(sysconfig.get_path("purelib") + "\n", encoding="utf-8")
    # A reader has no MPI, and mpi4py looks for its library in this environment.
    (packages / "mpi4py.py").write_text('raise ImportError("no MPI")\n', encoding="utf-8")
    written = {name: value for name, value in os.environ.items() if name == "ASPERITY_WRITE_PAGES"}
    return {**active, "ASPERITY": str(root), **written}


def test_the_tutorial_runs_and_prints_what_it_says(root: Path, environment: dict[str, str], tmp_path: Path) -> None:
    follow, page = root / "tests" / "consumers" / "follow_docs.py", root / "docs" / "height-maps.md"
    command = [sys.executable, str(follow), str(page), str(tmp_path)]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.endswith("3 files, 5 blocks of commands, 3 outputs as written\n")


def test_the_pages_on_height_maps_print_what_they_say(root: Path, environment: dict[str, str], tmp_path: Path) -> None:
    (tmp_path / "python").symlink_to(root / "python")
    check_page(root / "docs" / "height-maps.md", tmp_path, environment)
    check_page(root / "docs" / "height-maps.md", tmp_path, environment)


def test_the_table_of_the_page_is_what_maps_give(root: Path) -> None:
    """Four of the 24 surfaces that the page's row is the mean of: within four standard errors of a mean of four."""
    from sampling_bias import QUANTITIES, compare

    (row,) = (line for line in (root / "docs" / "height-maps.md").read_text("utf-8").splitlines() if line[:5] == "| 4 |")
    told = [[float(number) for number in cell.split("±")] for cell in row.strip("| ").split("|")[1:]]
    found = [compare(kind, 4, seeds=4)[0] for kind in ("narrow", "broad")]
    chosen = [QUANTITIES.index(name) for name in ("density", "height_std", "radius")]
    means = [means[i] for means in found for i in chosen]
    assert len(told) == len(means)
    for mean, (expected, error) in zip(means, told):
        assert abs(mean - expected) < 4 * max(error, 0.0005) * (24 / 4) ** 0.5


def test_the_script_draws_its_figure_and_refuses_what_it_cannot_do(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    import numpy as np
    from sampling_bias import POINTS_PER_WAVE, draw, main

    one = [(np.ones(4), np.full(4, 0.1)) for _ in POINTS_PER_WAVE]
    draw(str(tmp_path / "bias.svg"), {"narrow": one, "broad": one})
    assert "<svg" in (tmp_path / "bias.svg").read_text("utf-8")
    for arguments in (["-", "1"], ["-", "x"], ["-", "2", "3"]):
        assert main(arguments) == 2 and "usage:" in capsys.readouterr().err
