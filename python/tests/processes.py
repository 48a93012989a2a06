"""The command in this process, and fresh virtual environments for other ones, as cheap as they can be."""

from __future__ import annotations

import contextlib
import io
import os
import subprocess
import sys
import venv
import warnings
from pathlib import Path
from unittest import mock

from asperity.__main__ import main


def run_main(*arguments: object, text: str = "") -> subprocess.CompletedProcess[str]:
    """`python -m asperity` in this process, which need not import all anew; `text` is its standard input."""
    words = [str(argument) for argument in arguments]
    with contextlib.redirect_stdout(io.StringIO()) as output, contextlib.redirect_stderr(io.StringIO()) as errors:
        with warnings.catch_warnings(), mock.patch.object(sys, "stdin", io.StringIO(text)):
            warnings.simplefilter("default")  # as in a process of its own
            try:
                status = main(words)
            except SystemExit as end:
                status = int(end.code or 0)
    return subprocess.CompletedProcess(words, status, output.getvalue(), errors.getvalue())


def outside(**changes: str) -> dict[str, str]:
    """The variables of a process that knows nothing of this checkout.

    What modules it imports are compiled into the cache that the tests share, and pip compiles no others: that takes
    longer than all the rest of an installation.
    """
    kept = {
        name: value
        for name, value in os.environ.items()
        if name == "PYTHONPYCACHEPREFIX" or not name.startswith(("PYTHON", "ASPERITY"))
    }
    return {**kept, "PIP_COMPILE": "0", **changes}


def fresh_environment(directory: Path) -> dict[str, str]:
    """Makes a virtual environment with nothing but pip, and returns the variables of a process in which it is active."""
    venv.create(directory)
    # What venv itself would do compiles all of pip.
    pip = [sys.executable, "-m", "pip", "--python", str(directory / "bin" / "python"), "install", "pip"]
    done = subprocess.run(pip, env=outside(), capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    path = f"{directory / 'bin'}{os.pathsep}{os.environ['PATH']}"
    return outside(VIRTUAL_ENV=str(directory), PATH=path)
