#!/usr/bin/env python3
"""Tries each slip of tests/harden/python_mutants.toml: fails where no test notices one, or its text is not in its file once.

usage: tests/harden/python_mutants.py [--quick] [WORD ...]     --quick: those marked quick; WORD: of files or of tests
The environment of the Python tests is taken (python/environment.sh), with the package in a folder of its own. Without a slip the
tests must pass: run them before.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python/src/asperity"


def noticed(python: Path, tests: str, package: Path) -> str:
    """What pytest says where a test fails; "" where all pass."""
    command = [python, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", "-p", "no:xdist", "--no-header", *tests.split()]
    environment = {**os.environ, "PYTHONPATH": str(package.parent), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        done = subprocess.run(command, cwd=ROOT / "python/tests", env=environment, capture_output=True, text=True, timeout=600)
    except subprocess.TimeoutExpired:
        return "it never ends"
    if done.returncode < 0:
        return f"it dies of signal {-done.returncode}"
    if done.returncode > 1:
        sys.exit(f"pytest {tests}: {done.stdout[-2000:]}{done.stderr[-2000:]}")
    failed = [line for line in done.stdout.splitlines() if line.startswith(("FAILED", "ERROR"))]
    return failed[0] if failed else ""


def main() -> None:
    quick, words = "--quick" in sys.argv, [word for word in sys.argv[1:] if word != "--quick"]
    changes = tomllib.loads((ROOT / "tests/harden/python_mutants.toml").read_text())["change"]
    gone = [change for change in changes if (PACKAGE / change["file"]).read_text().count(change["find"]) != 1]
    for change in gone:
        print(f"{change['file']}: must have once what is changed: {change['find']}", file=sys.stderr)
    chosen = [one for one in changes if not quick or one.get("quick")]
    chosen = [one for one in chosen if one not in gone]
    if words:
        chosen = [one for one in chosen if any(word in one["file"] + " " + one["tests"] for word in words)]
    environment = subprocess.run([ROOT / "python/environment.sh"], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()
    python = Path(environment, "bin/python")
    installed = next(Path(environment).glob("lib/python3*/site-packages/asperity"))
    missed = 0
    with tempfile.TemporaryDirectory() as folder:
        package = Path(folder, "asperity")
        shutil.copytree(installed, package)
        shutil.copytree(PACKAGE, package, dirs_exist_ok=True, ignore=shutil.ignore_patterns("__pycache__"))
        for change in chosen:
            start, file = time.monotonic(), package / change["file"]
            text = file.read_text()
            file.write_text(text.replace(change["find"], change["replace"]))
            found = noticed(python, change["tests"], package)
            file.write_text(text)
            missed += not found
            says = f"{change['file']}: {change['find']!r:.60}: {found or 'MISSED'}"
            print(f"{time.monotonic() - start:5.1f} s  {says}"[:250], flush=True)
    print(f"{len(chosen)} slips, {missed} missed, {len(gone)} whose text is gone")
    sys.exit(bool(missed or gone))


if __name__ == "__main__":
    main()
