"""Every code block of the guides runs, in the order of the page, in an environment with nothing installed.

A `text` block after a `sh` or `python` block is what the latter prints. A block that names a file is for another test.
"""

from __future__ import annotations

import os
import re
import subprocess
from pathlib import Path

import pytest
from processes import fresh_environment

BLOCK = re.compile(r"^```(\w*(?: \S+)?)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
MARK = "-- end of block {} --"


def blocks(page: Path) -> list[tuple[str, str]]:
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def outputs(text: str, count: int) -> list[str]:
    """What each block printed."""
    found = []
    for i in range(count):
        part, mark, text = text.partition(MARK.format(i) + "\n")
        assert mark, f"block {i} did not end; it printed:\n{part}"
        found.append(part)
    return found


def run(command: list[str], source: str, directory: Path, environment: dict[str, str]) -> str:
    done = subprocess.run(
        command, input=source, cwd=directory, env=environment, capture_output=True, text=True, timeout=600, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


pytestmark = pytest.mark.usefixtures("one_build_at_a_time")


@pytest.fixture(scope="module")
def checkout(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A directory that looks like the checkout to the commands of the guide, and keeps what they write."""
    directory = tmp_path_factory.mktemp("checkout")
    (directory / "python").symlink_to(root / "python")
    return directory


@pytest.fixture(scope="module")
def environment(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """A fresh virtual environment, active."""
    return fresh_environment(tmp_path_factory.mktemp("venv"))


def shows(page: Path, before: int, shown: str, printed: str) -> None:
    """That a block, after so many others, shows what was printed, or its first lines and `...`; with ASPERITY_WRITE_PAGES, `make pages`,
    it does afterwards."""
    if shown.endswith("\n...\n"):
        printed = "".join(printed.splitlines(keepends=True)[: shown.count("\n") - 1]) + "...\n"
    if printed != shown and "ASPERITY_WRITE_PAGES" in os.environ:
        text = page.read_text(encoding="utf-8")
        block = list(BLOCK.finditer(text))[before]
        page.write_text(text[: block.start(2)] + printed + text[block.end(2) :], encoding="utf-8")
    else:
        assert printed == shown


def check_page(page: Path, checkout: Path, environment: dict[str, str]) -> None:
    found = blocks(page)
    assert {kind for kind, _ in found if " " not in kind} <= {"sh", "python", "text", "toml", "bibtex", "c", "fortran"}  # the last two: readme.rs, fortran/test.sh
    # Named in the block's first line, or in that of the file.
    for name, text in ((re.match(r"toml (?:# )?(\S+\.toml)\b", f"{kind} {text}"), text) for kind, text in found):
        if name:
            (checkout / name[1]).write_text(text, encoding="utf-8")
    for kind, command, echo in (("sh", ["bash", "-eu"], "echo '{}'\n"), ("python", ["python", "-"], "print('{}')\n")):
        chosen = [i for i, (name, _) in enumerate(found) if name == kind]
        source = "".join(found[i][1] + echo.format(MARK.format(n)) for n, i in enumerate(chosen))
        printed = outputs(run(command, source, checkout, environment), len(chosen))
        for i, output in zip(chosen, printed):
            if i + 1 < len(found) and found[i + 1][0] == "text":
                shows(page, i + 1, found[i + 1][1], output)


def test_the_guide_runs_and_prints_what_it_says(root: Path, checkout: Path, environment: dict[str, str]) -> None:
    check_page(root / "docs" / "python.md", checkout, environment)
    assert len(list((checkout / "wheels").glob("asperity-*-py3-none-*.whl"))) == 1
    guides = ("roughness", "stiffness-and-microslip")
    for page in ("README.md", "python/README.md", *(f"docs/{guide}.md" for guide in guides)):
        # In what the guide installed.
        check_page(root / page, checkout, environment)
