"""A study: surfaces drawn, answered in blocks, kept. `asperity.study` has the names."""

from __future__ import annotations

import os
import time
from concurrent.futures import Executor
from contextlib import nullcontext
from typing import TYPE_CHECKING, Any, Callable, Iterator, Mapping, Union

import numpy as np
import numpy.typing as npt

from .._library import version
from ..errors import Error
from ..fits.many_surfaces import Block, evaluate, names_of
from ..params import Params
from ..tools import blocks, checks
from ..tools.progress import Progress, teller
from ..units import DIMENSIONS, unit
from . import store as _store
from .draws import Draws, digest, drawn
from .store import Layout, Memory

if TYPE_CHECKING:
    import xarray


Array = npt.NDArray[np.float64]
Vary = Union[Mapping[str, Any], Callable[["np.random.Generator", int], Mapping[str, npt.ArrayLike]]]

# A block of this many surfaces takes some tenths of a second; fewer where a study is small, for all workers to have some, or
# where it has many loads, for the memory of its answers.
_BLOCK, _BLOCKS, _NUMBERS = 256, 64, 100_000
# Progress is told no more often than after so many seconds.
_OFTEN = 0.5
# States of a study, at most: more are terabytes.
_MOST_STATES = 10_000_000_000


def study(
    params: Params,
    vary: Vary,
    loads: npt.ArrayLike,
    samples: int | None = None,
    *,
    seed: int = 0,
    sampling: str = "sobol",
    executor: Executor | None = None,
    workers: int | None = None,
    checkpoint: str | os.PathLike[str] | None = None,
    progress: Progress = True,
    warnings: bool = True,
    block: int | None = None,
) -> xarray.Dataset:
    """Friction of many surfaces at each of many loads.

    The same bits for the same arguments, whatever the executor and the number of workers.

    Args:
        params: the surface that the others are variations of.
        vary: name to how it varies. The names are those of `asperity.fits.names`, and hardness, pressure_coefficient,
            tangential_modulus, nominal_area, bandwidth and max_friction_coefficient. A number is a relative spread: 0.1 is a
            log-normal distribution about the value in `params` whose logarithm has the standard deviation 0.1; of skew and
            radius_amplitude it is the standard deviation of a normal one. A frozen distribution of `scipy.stats` gives values,
            and so does a function of a NumPy `Generator` and of how many to draw. A list is a grid: each of its values, with
            each of all other lists, gets all samples. One function in place of the mapping draws all names together,
            correlated as it likes: of the same two arguments, it returns a mapping of arrays.
        loads: normal loads [force], one-dimensional, for all surfaces.
        samples: surfaces, at each point of the grid if there is one; 1024 by default, powers of 2 are best for "sobol".
        seed: of the random numbers, >= 0.
        sampling: "sobol" for points of low discrepancy, "latin" for a Latin hypercube, "random" for independent ones, or
            "saltelli" for Sobol' indices, which needs `samples` times the number of names plus two surfaces: see
            `sobol_indices`.
        executor: where blocks of surfaces are evaluated: anything with the interface of `concurrent.futures.Executor`. It is
            left open. By default here.
        workers: processes to start here for it, instead of an executor.
        checkpoint: a NetCDF file to be written. While the study runs, its blocks are in a folder beside it, "FILE.blocks"; a
            study that was stopped goes on from them when it is called again with the same arguments. A file with fewer samples
            of the same study is enlarged: only the others are computed. Not of "latin", "saltelli" and grids, whose samples
            depend on their number. The dataset that is returned reads from this file as it is used. Without, all is kept in
            memory.
        progress: whether to tell how far it is, on the error stream, or a function of the part done, 0 to 1, and of what is
            being done.
        warnings: whether to find the warnings of each state. They need an exact state for each load: without them a study of
            many loads takes a fraction of the time.
        block: surfaces in a block, by default up to 256.

    Returns:
        A dataset of (sample, load): friction_coefficient, friction_force, tangential_stiffness, warnings; of each sample status
        and reason; the parameters as coordinates of sample; each with its SI unit if `params` are `in_si`, else its dimension. A surface that the library refuses has NaN, its status and the
        reason; it is counted in the attribute `refused` and never drawn anew. A load that is too heavy for a surface has NaN
        there alone.

    Raises:
        Error: what an argument may not be, or a checkpoint of another study.
        TypeError: no parameters, or no numbers.
        ImportError: a missing package; the message says what to install.
        BlockingIOError: another process is at work on the same checkpoint.
        ChildProcessError: an executor that is broken, or workers that die again and again.
    """
    _require()
    checks.instance("params", params, Params)
    blocks.checked_workers(workers)
    load = checks.one_or_more("loads", loads, unit("force", params.in_si))
    seed = checks.whole("seed", seed, 0, 2**63 - 1)
    draws = drawn(params, vary, samples, seed, sampling)
    surfaces = len(draws.values)
    if surfaces * load.size > _MOST_STATES:
        raise Error(f"loads: {load.size} of them for {surfaces} surfaces; must be at most {_MOST_STATES:g} states together")
    usual = max(1, min(_BLOCK, surfaces // _BLOCKS, _NUMBERS // load.size))
    size = usual if block is None else checks.whole("block", block, 1, surfaces)
    layout = _layout(params, draws, load, seed, sampling, size, bool(warnings))
    with nullcontext(Memory(layout)) if checkpoint is None else _store.checkpoint(checkpoint, layout) as store:
        missing = store.missing()

        def tasks() -> Iterator[tuple[int, Block]]:
            for first in missing:
                yield first, Block(params, draws.names, draws.values[first : first + size], load, bool(warnings))

        told = _Told(surfaces, surfaces - sum(min(size, surfaces - first) for first in missing), progress)
        for first, answers in blocks.completed(evaluate, tasks(), executor, workers):
            store.put(first, answers)
            told.add(len(answers.status))
        found: xarray.Dataset = store.dataset()
    return found


class _Told:
    """Progress, with rate and time left of this run."""

    def __init__(self, surfaces: int, done: int, progress: Progress) -> None:
        self._surfaces, self._done, self._before, self._start = surfaces, done, done, time.monotonic()
        self._next = self._start
        self._tell = teller(progress, True, "asperity.study")
        self._tell(done / surfaces, f"{done} of {surfaces} surfaces")

    def add(self, count: int) -> None:
        self._done += count
        now = time.monotonic()
        if now < self._next and self._done < self._surfaces:
            return
        self._next = now + _OFTEN
        rate = (self._done - self._before) / max(now - self._start, 1e-9)
        left = round((self._surfaces - self._done) / rate)
        self._tell(
            self._done / self._surfaces,
            f"{self._done} of {self._surfaces} surfaces, {rate:.0f}/s, {left // 3600}:{left // 60 % 60:02}:{left % 60:02} left",
        )


def _layout(
    params: Params, draws: Draws, load: Array, seed: int, sampling: str, block: int, warnings: bool
) -> Layout:
    names = names_of(draws.names, params)
    parameters = {
        name.given: (draws.values[:, j], DIMENSIONS.get(name.field, name.dimension)) for j, name in enumerate(names)
    }
    attributes = {
        "title": "friction of surfaces whose parameters vary, by asperity",
        "asperity_version": version(),
        "params": repr(params),
        "parameters": " ".join(draws.names),
        "vary": "; ".join(f"{name}: {told}" for name, told in draws.told.items()),
        "sampling": sampling,
        "samples": draws.base,
        "seed": seed,
    }
    identity = {
        **{name: value for name, value in attributes.items() if name != "title"},
        "loads": f"{load.size} from {load.min():g} to {load.max():g}",
        "warnings": warnings,
        "block": block,
        "bits of the loads": digest(load),
        "bits of the parameters drawn": digest(draws.values),
    }
    return Layout(parameters, load, attributes, identity, block, warnings, params.in_si)


def _require() -> None:
    """`ImportError` that says what to install, before any work."""
    try:
        import netCDF4
        import scipy.stats
        import xarray
    except ImportError as error:
        raise ImportError(f'a study needs xarray, SciPy and netCDF4 ({error}): pip install scipy xarray netCDF4') from None
    del netCDF4, scipy, xarray
