"""Speed and memory of studies, against a plain loop of `Model`; and of models made by threads in C.

usage: benches/studies.py CREATION_THREADS [SURFACES ...]
CREATION_THREADS is the program of benches/creation_threads.c. Prints tables of Markdown for docs/dev/performance.md, the last of
studies with so many surfaces each (1000 10000 100000). Each row is measured in a process of its own.
"""

from __future__ import annotations

import datetime
import json
import math
import os
import platform
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

from asperity import Model, Params
from asperity.study import study

PARAMS = Params.dimensionless(alpha=0.01, beta=1000, gamma=0.001)
LOADS = np.geomspace(1e-3, 1e3, 100)
VARY = {"height_std": 0.2, "summit_radius": 0.2, "work_of_adhesion": 0.3, "slip_stress": 0.5}
FEW = 400


def loop(surfaces: int, warnings: bool) -> None:
    """What one would write without studies, with the draws of NumPy."""
    random = np.random.default_rng(1)
    found = np.empty((3, surfaces, LOADS.size))
    bits = np.empty((surfaces, LOADS.size), dtype=np.uint64)
    for i in range(surfaces):
        height, radius, work, strength = np.exp(np.array(list(VARY.values())) * random.standard_normal(4))
        params = PARAMS.replace(
            height_std=PARAMS.height_std * height,
            summit_radius=PARAMS.summit_radius * radius,
            work_of_adhesion=PARAMS.work_of_adhesion * work,
            slip_stress_1=PARAMS.slip_stress_1 * strength,
            slip_stress_2=PARAMS.slip_stress_2 * strength,
        )
        with Model(params) as model:
            found[0, i] = model.friction_at_load(LOADS)
            found[1, i] = model.friction_force_at_load(LOADS)
            found[2, i] = model.tangential_stiffness_at_load(LOADS)
            if warnings:
                bits[i] = model.state_at_load(LOADS).warning_bits


def measured(kind: str, surfaces: int, warnings: bool) -> None:
    """One row, in this process."""
    study(PARAMS, VARY, LOADS, 8, progress=False)  # what is imported once takes seconds
    start, cpu = time.monotonic(), sum(os.times()[:4])
    given = {"vary": VARY, "loads": LOADS, "samples": surfaces, "seed": 1, "warnings": warnings, "progress": False}
    if kind == "loop":
        loop(surfaces, warnings)
    elif kind == "dask":
        import distributed

        with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
            with distributed.Client(cluster) as client:
                client.gather(client.map(abs, range(4)))
                start = time.monotonic()
                study(PARAMS, executor=client.get_executor(), **given)
                seconds = time.monotonic() - start
    elif kind == "file":
        with tempfile.TemporaryDirectory() as folder:
            study(PARAMS, workers=2, checkpoint=Path(folder) / "study.nc", **given).close()
    else:
        study(PARAMS, workers=int(kind), **given)
    if kind != "dask":
        seconds = time.monotonic() - start
    here, there = (resource.getrusage(who).ru_maxrss // 1024 for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    # Starting workers of Dask takes more than their work here, and cannot be told from it.
    used = math.nan if kind == "dask" else sum(os.times()[:4]) - cpu
    print(json.dumps({"rate": surfaces / seconds, "cpu": 1e3 * used / surfaces, "here": here, "there": there}))


def row(kind: str, surfaces: int, warnings: bool = True) -> dict[str, float]:
    command = [sys.executable, __file__, "--one", kind, str(surfaces), str(int(warnings))]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main() -> None:
    program, sizes = sys.argv[1], [int(word) for word in sys.argv[2:]] or [1000, 10_000, 100_000]
    names = [line.partition(":")[2].strip() for line in Path("/proc/cpuinfo").read_text().splitlines() if "model name" in line]
    load = os.getloadavg()[0]
    print(
        f"{datetime.date.today()}, {len(names)} cores of {names[0] if names else platform.processor()}, of which other work "
        f"wanted {load:.0f} at the beginning; {LOADS.size} loads, four parameters.\n"
    )
    print(f"| {FEW} surfaces | surfaces a second | processor time for each [ms] | without warnings | [ms] |\n|---|---|---|---|---|")
    for kind, what in (
        ("loop", "a plain loop of `Model`"),
        ("1", "`study`, in the process itself"),
        ("2", "two processes"),
        ("dask", "two workers of Dask"),
    ):
        with_them, without = row(kind, FEW), row(kind, FEW, False)
        cells = " | ".join(f"{one['rate']:.0f} | {one['cpu']:.1f}".replace("nan", "–") for one in (with_them, without))
        print(f"| {what} | {cells} |", flush=True)
    print("\n| surfaces, two processes, into a file | surfaces a second | peak memory [MB] | of a worker |\n|---|---|---|---|")
    for size in sizes:
        found = row("file", size)
        print(f"| {size} | {found['rate']:.0f} | {found['here']:.0f} | {found['there']:.0f} |", flush=True)
    print("\n| threads in C | models a second | processor time for each [ms] |\n|---|---|---|")
    for threads in (1, 2, 4):
        made = subprocess.run([program, str(threads), "4000"], check=True, capture_output=True, text=True).stdout.split()
        print(f"| {threads} | {made[0]} | {made[1]} |", flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--one"]:
        measured(sys.argv[2], int(sys.argv[3]), bool(int(sys.argv[4])))
    else:
        main()
