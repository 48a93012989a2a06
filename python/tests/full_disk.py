"""Writes one output of the package where there is no room for it: `full_disk.py OUTPUT FILE ROOM`, in a process of its own.

ROOM is the size of the largest file that this process may write [bytes], or "disk": then the disk of FILE is filled. Ends with
the status of the command, or the error of a function on standard error.
"""

from __future__ import annotations

import contextlib
import resource
import sys
import zipfile
from pathlib import Path
from typing import Any, Callable
from unittest import mock

import matplotlib.font_manager  # noqa: F401  # which writes a cache of its own

from asperity import Params
from asperity.__main__ import main
from asperity.studies import store, study_command

SURFACE = Path(__file__).resolve().parents[2] / "hosts" / "surface.toml"
STUDY = """
[vary]
height_std = {{ distribution = "uniform", loc = 3e-9, scale = 2e-9 }}
summit_radius = {{ distribution = "uniform", loc = 1e-7, scale = 1e-7 }}
[loads]
values = [0.1, 0.2]
[study]
samples = 32
seed = 1
sampling = "{}"
"""


def to_toml(file: str) -> int:
    try:
        Params.from_toml(SURFACE).to_toml(file)
    except OSError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


def study(sampling: str, *options: str) -> int:
    file = Path("study.toml")
    file.write_text(SURFACE.read_text(encoding="utf-8") + STUDY.format(sampling), encoding="utf-8")
    return main(["study", str(file), "--quiet", *options])


# Each with what it calls just before it writes the file, where it writes others before.
OUTPUTS: dict[str, tuple[Callable[[str], int], tuple[Any, str] | None]] = {
    "export": (lambda file: main(["export", str(SURFACE), "--format=csv", "--range=1e5:1e9", "-o", file]), None),
    "curve": (lambda file: main(["curve", "--figure", file]), None),
    "fmu": (lambda file: main(["fmu", str(SURFACE), "-o", file]), (zipfile, "ZipFile")),
    "to_toml": (to_toml, None),
    "block": (lambda file: study("random", "-o", file), (store._Writer, "__init__")),
    "study": (lambda file: study("random", "-o", file), (store.Checkpoint, "dataset")),
    "indices": (lambda file: study("saltelli", "-o", "found.nc", "--indices", file), (study_command, "plot_sobol_indices")),
}


def fill(folder: Path) -> None:
    with contextlib.suppress(OSError), open(folder / "filler", "wb", buffering=0) as filler:
        while True:
            filler.write(bytes(1024))


def run(name: str, file: str, room: str) -> int:
    output, before = OUTPUTS[name]

    def full() -> None:
        if room == "disk":
            fill(Path(file).parent)
        else:
            resource.setrlimit(resource.RLIMIT_FSIZE, (int(room), int(room)))  # Python ignores SIGXFSZ: an error is left

    if before is None:
        full()
        return output(file)
    original = getattr(*before)

    def call(*arguments: Any, **named: Any) -> Any:
        full()
        return original(*arguments, **named)

    with mock.patch.object(*before, call):
        return output(file)


if __name__ == "__main__":
    sys.exit(run(*sys.argv[1:]))
