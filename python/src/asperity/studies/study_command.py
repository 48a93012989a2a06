"""`python -m asperity study`: a study from a TOML file into a NetCDF file, here, on Dask, or under mpiexec."""

from __future__ import annotations

import argparse
import sys
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Any, Iterator

import numpy as np

from .sobol import plot_sobol_indices, sobol_indices
from .study import study


def add(commands: Any) -> None:
    """Adds the command to those of the parser."""
    command = commands.add_parser(
        "study",
        help="friction of thousands of surfaces whose parameters vary",
        description="Reads a surface with what varies ([vary]), [loads] and [study] from a TOML file, and writes friction of all "
        "surfaces to a NetCDF file. A study that was stopped goes on when the same command is given again.",
        epilog="docs/studies.md has the keys of the file. Under MPI: mpiexec -n 8 python -m asperity study FILE.toml -o FILE.nc --mpi",
        allow_abbrev=False,
    )
    command.set_defaults(run=_run)
    command.add_argument("file", metavar="FILE.toml", help="the study")
    command.add_argument("-o", "--output", required=True, metavar="FILE.nc", help="file to write; its blocks are kept beside it")
    engines = command.add_mutually_exclusive_group()
    engines.add_argument("--workers", type=int, metavar="N", help="processes on this machine (1)")
    engines.add_argument("--dask", metavar="ADDRESS", help="address of a Dask scheduler, as tcp://10.0.0.1:8786")
    engines.add_argument("--mpi", action="store_true", help="the processes that mpiexec started")
    command.add_argument("--indices", metavar="FILE", help='file to draw Sobol\' indices in, of a study with sampling = "saltelli"')
    command.add_argument("--quiet", action="store_true", help="no progress")


def _run(parser: argparse.ArgumentParser, options: argparse.Namespace) -> None:
    """Runs the study, and says what came of it. Under MPI all processes but the first only work for it."""
    from . import file  # for which Python 3.10 needs a package of the extra "study"

    with _executor(options) as (executor, first):
        if not first:
            return
        told = file.read(options.file)
        if options.indices is not None and told.options.get("sampling") != "saltelli":
            parser.error('--indices: needs sampling = "saltelli" in [study]')
        found = study(
            told.params, told.vary, told.loads, executor=executor, workers=options.workers, checkpoint=options.output,
            progress=False if options.quiet else True, **told.options,
        )  # fmt: skip
        _tell(found, options.output)
        if options.indices is not None:
            plot_sobol_indices(sobol_indices(found), options.indices)
        found.close()


def _tell(found: Any, output: str) -> None:
    refused = int(found.attrs["refused"])
    print(f"{output}: {found.sizes['sample']} surfaces, {found.sizes['load']} loads; {refused} refused")
    if refused:
        reasons = np.unique(found["reason"].values)
        for reason in [str(one) for one in reasons if one][:3]:
            print(f"# refused, for example: {reason}")
    sys.stdout.flush()


@contextmanager
def _executor(options: argparse.Namespace) -> Iterator[tuple[Executor | None, bool]]:
    """The executor that the options name, and whether this process is the one that asks."""
    if options.dask is not None:
        try:
            from distributed import Client
        except ImportError as error:
            raise ImportError(f'--dask needs Dask ({error}): pip install "dask[distributed]"') from None
        with Client(options.dask) as client:
            yield client.get_executor(), True
    elif options.mpi:
        try:
            from mpi4py.futures import MPICommExecutor
        except ImportError as error:
            raise ImportError(f"--mpi needs mpi4py and an MPI library ({error}): pip install mpi4py mpich") from None
        with MPICommExecutor() as executor:
            yield executor, executor is not None  # type: ignore[misc, unused-ignore]  # an Executor in all but its class
    else:
        yield None, True
