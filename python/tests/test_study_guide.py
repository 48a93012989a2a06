"""The blocks of docs/studies.md run in this interpreter, which has what its first one installs, and print what it says."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest
from test_docs import MARK, blocks, outputs, shows


@pytest.fixture(scope="module")
def page(root: Path) -> list[tuple[str, str]]:
    return blocks(root / "docs" / "studies.md")


def test_the_guide_to_studies_prints_what_it_says(root: Path, page: list[tuple[str, str]], tmp_path: Path) -> None:
    assert [text for kind, text in page if kind == "sh" and "pip" in text] == ["pip install './python[study,plot]'\n"]
    (study,) = [text for kind, text in page if kind == "toml"]
    (tmp_path / "study.toml").write_text(study, encoding="utf-8")
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}"
    for name, command, echo in (("sh", ["bash", "-eu"], "echo '{}'\n"), ("python", [sys.executable, "-"], "print('{}')\n")):
        chosen = [i for i, (kind, text) in enumerate(page) if kind == name and "pip" not in text]
        source = "".join(page[i][1] + echo.format(MARK.format(n)) for n, i in enumerate(chosen))
        done = subprocess.run(
            command, input=source, cwd=tmp_path, env={**os.environ, "PATH": path}, capture_output=True, text=True,
            timeout=600, check=False,
        )  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
        for i, output in zip(chosen, outputs(done.stdout, len(chosen))):
            if i + 1 < len(page) and page[i + 1][0] == "text":
                shows(root / "docs" / "studies.md", i + 1, page[i + 1][1], output)
    assert (tmp_path / "indices.svg").read_text(encoding="utf-8").startswith("<?xml")
