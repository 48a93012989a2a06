"""python/examples/friction_curve.py prints what c_examples/friction_curve.c prints, to the last digit."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Callable

import pytest

from asperity import _library


@pytest.fixture(scope="module")
def twin(root: Path, compile_c: Callable[..., None], tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The C example, on the library of the package."""
    library = Path(_library.PATH)
    program = tmp_path_factory.mktemp("c") / "friction_curve"
    source = root / "c_examples" / "friction_curve.c"
    rpath = f"-Wl,-rpath,{library.parent}"
    compile_c(source, "-I", root / "include", "-o", program, library, rpath, "-lm")
    return program


def run(*command: object) -> subprocess.CompletedProcess[str]:
    words = [str(word) for word in command]
    return subprocess.run(words, capture_output=True, text=True, timeout=600, check=False)


@pytest.fixture
def example(root: Path) -> list[object]:
    return [sys.executable, root / "python" / "examples" / "friction_curve.py"]


@pytest.mark.parametrize("arguments", [(), ("-", "7"), ("-", "100", "1e-12", "1e3")])
def test_both_examples_print_the_same_table(example: list[object], twin: Path, arguments: tuple[str, ...]) -> None:
    ours, theirs = run(*example, *arguments), run(twin, *arguments)
    assert (ours.returncode, theirs.returncode) == (0, 0)
    assert ours.stdout == theirs.stdout
    assert ours.stderr == theirs.stderr
    assert ours.stderr.count("friction_curve: warning: ") == len(ours.stderr.splitlines()) == (6 if arguments[2:] else 2)
    assert len(ours.stdout.splitlines()) == 1 + int((*arguments, "-", "33")[1])


def test_the_figure_is_drawn(example: list[object], tmp_path: Path) -> None:
    figure = tmp_path / "curve.png"
    assert run(*example, figure, 5).returncode == 0
    assert figure.read_bytes().startswith(b"\x89PNG")
    assert run(*example, os.devnull + "/curve.png").returncode == 1


@pytest.mark.parametrize(
    "arguments",
    [("-", "1"), ("-", "x"), ("-", "3", "0"), ("-", "3", "2", "1"), ("-", "3", "1", "inf"), ("-", *"12345")],
)
def test_a_wrong_command_line_is_refused(example: list[object], twin: Path, arguments: tuple[str, ...]) -> None:
    ours, theirs = run(*example, *arguments), run(twin, *arguments)
    assert ours.returncode == theirs.returncode == 2
    assert "usage:" in ours.stderr and ours.stdout == ""
