"""Work in blocks on any engine with the interface of `concurrent.futures.Executor`: threads, processes, Dask, MPI.

A block that fails is sent again, and a pool of processes that this module made is made anew when a worker dies. What a block
answers depends on nothing but its task, so that neither the engine nor the number of workers changes a bit of it.
"""

from __future__ import annotations

import os
import threading
from collections import deque
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from typing import Any, Callable, Iterable, Iterator

from .._library import version
from ..errors import Error
from . import checks

Work = Callable[[Any], Any]
# So often a block is sent before its failure is raised, and so often in a row workers may die with no block done between.
_ATTEMPTS = 3
# Blocks under way at a time, which bounds the memory of their answers: for engines that do not say how many workers they have,
# and for each worker of a pool made here.
_IN_FLIGHT, _EACH = 256, 4


def checked_workers(workers: Any) -> int:
    """The number of processes, checked: 1 is this process itself."""
    return checks.whole("workers", 1 if workers is None else workers, 1, 1024)  # for more, an executor of Dask or MPI


def completed(
    work: Work, tasks: Iterable[tuple[int, Any]], executor: Executor | None = None, workers: int | None = None
) -> Iterator[tuple[int, Any]]:
    """What `work` answers to each task, with the number of the task, as they are done.

    Args:
        work: a function of a module, of one task.
        tasks: numbers and tasks; taken as workers become free.
        executor: where the work is done; it is left open.
        workers: without an executor: processes to start; 1 works here.

    Raises:
        TypeError: no executor, or no whole number.
        Error: both, or too many workers.
        ChildProcessError: the executor is broken, or workers die again and again.
    """
    if executor is None and checked_workers(workers) == 1:
        for number, task in tasks:
            yield number, work(task)
        return
    if executor is not None and workers is not None:
        raise Error(f"workers = {workers}: is for pools made here; the executor has its own")
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise TypeError(f"executor = {executor!r}: must have the interface of concurrent.futures.Executor")
    yield from _Engine(work, executor, checked_workers(workers)).answers(iter(tasks))


def _answer(work: Work, task: Any) -> tuple[str, Any]:
    """In the worker: the version of its library, and the answer."""
    return version(), work(task)


def _pool(workers: int) -> Executor:
    # Imported here: importing the package is to take no longer than it must.
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor

    # Not by fork: a process with threads, as of JAX or BLAS, must not be copied.
    method = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
    return ProcessPoolExecutor(workers, multiprocessing.get_context(method), initializer=_end_with_parent)


def _end_with_parent() -> None:
    """In a worker of a pool made here: ends it when its parent is gone, which the pool itself would not notice."""
    from multiprocessing import parent_process

    parent = parent_process()

    def watch() -> None:
        if parent is not None:
            parent.join()
            os._exit(1)

    threading.Thread(target=watch, daemon=True).start()


class _Engine:
    """An executor, given or made here, with the blocks that are under way."""

    def __init__(self, work: Work, executor: Executor | None, workers: int) -> None:
        self._work, self._given, self._workers = work, executor, workers
        self._room = _IN_FLIGHT if executor is not None else _EACH * workers
        self._pool = _pool(workers) if executor is None else executor
        self._sent: dict[Future[Any], tuple[int, Any, int]] = {}
        self._again: deque[tuple[int, Any, int]] = deque()
        self._deaths = 0

    def answers(self, tasks: Iterator[tuple[int, Any]]) -> Iterator[tuple[int, Any]]:
        try:
            while self._fill(tasks):
                for future in wait(self._sent, return_when=FIRST_COMPLETED).done:
                    if future not in self._sent:
                        continue  # of a pool that broke
                    number, task, attempts = self._sent.pop(future)
                    try:
                        found, answer = future.result()
                    except BrokenExecutor as error:
                        self._again.append((number, task, attempts - 1))
                        self._renew(error)
                    except Exception:
                        if attempts == _ATTEMPTS:
                            raise
                        self._again.append((number, task, attempts))
                    else:
                        if found != version():
                            raise ImportError(f"a worker has asperity {found}, this process {version()}: install one version")
                        self._deaths = 0
                        yield number, answer
        finally:
            for future in self._sent:
                future.cancel()
            if self._given is None:  # not waiting for blocks that nobody wants any more
                self._pool.shutdown(wait=not self._sent, cancel_futures=True)

    def _fill(self, tasks: Iterator[tuple[int, Any]]) -> bool:
        """Sends blocks while there is room; whether any is under way."""
        while len(self._sent) < self._room:
            if self._again:
                number, task, attempts = self._again.popleft()
            else:
                try:
                    number, task = next(tasks)
                except StopIteration:
                    break
                attempts = 0
            try:
                self._sent[self._pool.submit(_answer, self._work, task)] = number, task, attempts + 1
            except BrokenExecutor as error:
                self._again.append((number, task, attempts))
                self._renew(error)
        return bool(self._sent)

    def _renew(self, error: BrokenExecutor) -> None:
        """A new pool in place of the one in which a worker died, and what was under way sent again."""
        if self._given is not None:
            raise ChildProcessError(
                f"executor: it is broken and takes no more work ({error}); make a new one and call again, with the same "
                "checkpoint if there is one, which has the blocks that are done"
            ) from error
        self._deaths += 1
        if self._deaths > _ATTEMPTS:
            raise ChildProcessError(
                f"workers: processes died {self._deaths} times in a row and no block was done ({error}); is memory short?"
            ) from error
        # The executor does not tell which block its dead worker had: no block is held to have failed.
        self._again.extend((number, task, attempts - 1) for number, task, attempts in self._sent.values())
        self._sent.clear()
        self._pool.shutdown(wait=False, cancel_futures=True)
        self._pool = _pool(self._workers)
