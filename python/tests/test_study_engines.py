"""Engines: the same bits on threads, processes, Dask and MPI, whatever the number of workers; workers that die or fail."""

from __future__ import annotations

import itertools
import multiprocessing
import os
import shutil
import signal
import subprocess
import sys
import time
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from pathlib import Path
from typing import Any, Iterator

import numpy as np
import pytest
import study_workers
import xarray
from study_workers import LOADS, PARAMS, SMALL

from asperity import Model, pads, uncertainty
from asperity.study import study
from asperity.tools import blocks

# Other tests of this process may have started threads, which a fork does not copy.
CONTEXT = multiprocessing.get_context("spawn")


@pytest.fixture(scope="module")
def small() -> xarray.Dataset:
    """The study in this process."""
    return study(PARAMS, **SMALL)


@pytest.fixture(scope="module")
def dask() -> Iterator[Any]:
    """Two workers of Dask, processes of their own, which find the module of these tests."""
    import distributed

    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with distributed.Client(cluster) as client:
            client.run(sys.path.append, str(Path(__file__).parent))
            yield client


def bits(found: xarray.Dataset) -> dict[str, bytes]:
    return {str(name): np.ascontiguousarray(found[name].values).tobytes() for name in found.variables}


def test_processes_give_the_same_bits(small: xarray.Dataset) -> None:
    for workers in (2, 3):
        found = study(PARAMS, **SMALL, workers=workers)
        assert bits(found) == bits(small) and found.attrs == small.attrs
    with ProcessPoolExecutor(2, CONTEXT) as executor:
        assert bits(study(PARAMS, **SMALL, executor=executor)) == bits(small)
        assert executor.submit(study_workers.twice, 2).result() == 4  # it is left open


def test_threads_and_other_blocks_give_the_same_bits(small: xarray.Dataset) -> None:
    with ThreadPoolExecutor(3) as executor:
        assert bits(study(PARAMS, **{**SMALL, "block": 5}, executor=executor)) == bits(small)
    assert bits(study(PARAMS, **{**SMALL, "block": None})) == bits(small)


def test_dask_gives_the_same_bits(small: xarray.Dataset, dask: Any) -> None:
    assert bits(study(PARAMS, **SMALL, executor=dask.get_executor())) == bits(small)


def test_a_worker_of_dask_that_dies_is_replaced(dask: Any, tmp_path: Path) -> None:
    tasks = [(i, (str(tmp_path), i)) for i in range(12)]
    found = dict(blocks.completed(study_workers.twice_or_die, tasks, dask.get_executor()))
    assert found == {i: 2 * i for i in range(12)} and (tmp_path / "died").exists()


@pytest.mark.filterwarnings("ignore::asperity.ValidityWarning")
def test_bands_and_pads_are_the_same_on_an_executor() -> None:
    alone = uncertainty(PARAMS, {"height_std": 0.3, "w": 0.5}, LOADS, samples=40)
    few = PARAMS.replace(asperity_count=500.0)
    pads_alone = pads(few, [1.0, 10.0], 120)
    with ProcessPoolExecutor(2, CONTEXT) as executor:
        band = uncertainty(PARAMS, {"height_std": 0.3, "w": 0.5}, LOADS, samples=40, executor=executor)
        pads_there = pads(few, [1.0, 10.0], 120, executor=executor)
        curve = Model(PARAMS).curve(LOADS, spread={"height_std": 0.3, "w": 0.5}, samples=40, executor=executor)
    assert alone.samples is not None and band.samples is not None
    assert band.samples.tobytes() == alone.samples.tobytes() and band.refused == alone.refused
    assert curve.low is not None and np.array_equal(curve.low, alone.low)
    assert pads_there.friction_force.tobytes() == pads_alone.friction_force.tobytes()
    assert np.array_equal(pads_there.contacting, pads_alone.contacting)


def test_a_process_that_dies_is_replaced(tmp_path: Path) -> None:
    tasks = [(i, (str(tmp_path), i)) for i in range(20)]
    found = dict(blocks.completed(study_workers.twice_or_die, tasks, workers=2))
    assert found == {i: 2 * i for i in range(20)} and (tmp_path / "died").exists()


def test_processes_that_die_again_and_again_end_the_work() -> None:
    with pytest.raises(ChildProcessError, match="workers: processes died 4 times in a row and no block was done"):
        list(blocks.completed(study_workers.die, [(0, None)], workers=2))


def test_a_broken_executor_is_named_with_what_to_do() -> None:
    with ProcessPoolExecutor(1, CONTEXT) as executor:
        with pytest.raises(ChildProcessError, match="executor: it is broken .* make a new one and call again, with the same checkp"):
            list(blocks.completed(study_workers.die, [(0, None)], executor))


def test_a_block_that_fails_is_sent_again_three_times_at_most(tmp_path: Path) -> None:
    tasks = [(i, (str(tmp_path), i)) for i in range(6)]
    with ThreadPoolExecutor(2) as executor:
        found = dict(blocks.completed(study_workers.twice_at_the_third_time, tasks, executor))
        assert found == {i: 2 * i for i in range(6)}
        sent: list[int] = []

        def fail(task: int) -> None:
            sent.append(task)
            study_workers.fail(task)

        with pytest.raises(OSError, match="never"):
            list(blocks.completed(fail, [(0, 5)], executor))
        assert sent == [5, 5, 5]


def test_tasks_are_taken_as_workers_become_free() -> None:
    taken = []

    def tasks() -> Iterator[tuple[int, int]]:
        for i in range(10_000):
            taken.append(i)
            yield i, i

    with ThreadPoolExecutor(1) as executor:
        work = blocks.completed(study_workers.twice, tasks(), executor)
        next(work)
        assert len(taken) <= 600  # not all, whose answers would be in memory together
        work.close()  # type: ignore[attr-defined]


def test_a_worker_with_another_version_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    versions = itertools.chain(["0.0.1"], itertools.repeat("0.1"))
    monkeypatch.setattr(blocks, "version", lambda: next(versions))
    with ThreadPoolExecutor(1) as executor, pytest.raises(ImportError, match="a worker has asperity 0.0.1, this process 0.1"):
        list(blocks.completed(study_workers.twice, [(0, 1)], executor))


def test_an_executor_and_workers_exclude_each_other() -> None:
    with ThreadPoolExecutor(1) as executor, pytest.raises(ValueError, match="workers = 2: is for pools made here"):
        study(PARAMS, **SMALL, executor=executor, workers=2)


def test_processes_end_with_the_one_that_started_them() -> None:
    source = (
        "import time\n"
        "import study_workers\n"
        "from asperity.tools import blocks\n"
        "if __name__ == '__main__':\n"
        "    for _, worker in blocks.completed(study_workers.process, [(i, i) for i in range(4)], workers=2):\n"
        "        print(worker, flush=True)\n"
        "        time.sleep(60)\n"
    )
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parent)}
    parent = subprocess.Popen([sys.executable, "-c", source], stdout=subprocess.PIPE, text=True, env=environment)
    assert parent.stdout is not None
    with parent, parent.stdout:
        worker = int(parent.stdout.readline())
        parent.send_signal(signal.SIGKILL)
    for _ in range(200):
        if not running(worker):
            return
        time.sleep(0.1)
    pytest.fail(f"process {worker} outlives its parent")


def running(process: int) -> bool:
    """Whether a process is there and no zombie that nobody has waited for."""
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def mpiexec() -> str:
    """That of the interpreter's environment."""
    found = shutil.which("mpiexec", path=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    if found is None:
        pytest.fail("this test needs mpiexec: pip install mpi4py mpich")
    return found


def test_mpi_gives_the_same_bits(small: xarray.Dataset, tmp_path: Path) -> None:
    program = tmp_path / "program.py"
    program.write_text(
        "import sys\n"
        "from mpi4py.futures import MPIPoolExecutor\n"
        "from study_workers import PARAMS, SMALL\n"
        "from asperity.study import study\n"
        "if __name__ == '__main__':\n"
        "    with MPIPoolExecutor() as executor:\n"
        "        study(PARAMS, **SMALL, executor=executor, checkpoint=sys.argv[1])\n",
        encoding="utf-8",
    )
    command = [mpiexec(), "-n", "3", sys.executable, "-m", "mpi4py.futures", program, tmp_path / "found.nc"]
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parent)}
    done = subprocess.run(list(map(str, command)), env=environment, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    with xarray.open_dataset(tmp_path / "found.nc", engine="netcdf4") as found:
        assert bits(found) == bits(small)
