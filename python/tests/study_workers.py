"""What the tests of studies send to workers: it must be in a module that workers can import."""

from __future__ import annotations

import itertools
import os
import signal
import sys
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np

from asperity import Params
from asperity.study import study

PARAMS = Params.paper()
LOADS = np.geomspace(1e-2, 1e2, 4)
# A small study with all that can vary: a spread, a list, and what the library refuses.
SMALL: dict[str, Any] = {
    "vary": {"height_std": 0.3, "slip_stress": [0.01, 0.02], "radius_amplitude": 0.9},
    "loads": LOADS,
    "samples": 16,
    "seed": 5,
    "block": 4,
    "progress": False,
}


def twice(task: int) -> int:
    return 2 * task


def process(task: int) -> int:
    return os.getpid()


def twice_or_die(task: tuple[str, int]) -> int:
    """Kills its process once for each folder, at the number 3; `always` does so each time."""
    folder, number = task
    if number == 3 and not (Path(folder) / "died").exists():
        (Path(folder) / "died").touch()
        os.kill(os.getpid(), signal.SIGKILL)
    return 2 * number


def die(task: Any) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def twice_at_the_third_time(task: tuple[str, int]) -> int:
    """Fails twice for each number."""
    folder, number = task
    tries = Path(folder) / str(number)
    tries.write_text(tries.read_text() + "x" if tries.exists() else "x")
    if len(tries.read_text()) < 3:
        raise OSError("not yet")
    return 2 * number


def fail(task: Any) -> None:
    raise OSError("never")


def stand_at(flushes: int) -> None:
    """At that flush of a file to the disk, this process says so on its output, and waits for a line of its input."""
    flush, count = os.fsync, itertools.count(1)

    def flush_or_stand(descriptor: int) -> None:
        if next(count) == flushes:
            print("standing", flush=True)
            sys.stdin.readline()
        flush(descriptor)

    mock.patch.object(os, "fsync", flush_or_stand).start()


if __name__ == "__main__":
    # A study in a process of its own, which stands still in the middle of a block: python study_workers.py FILE.nc FLUSHES
    stand_at(int(sys.argv[2]))
    study(PARAMS, **SMALL, checkpoint=sys.argv[1]).close()
