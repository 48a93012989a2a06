"""Checkpoints: a study that was killed goes on with equal bits, never with half a block, and never with another's."""

from __future__ import annotations

import contextlib
import errno
import os
import signal
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any, Iterator
from unittest import mock

import numpy as np
import pytest
import xarray
from scipy import stats
from study_workers import LOADS, PARAMS, SMALL
from test_study_engines import bits

from asperity.studies import lock, store
from asperity.study import study
from asperity.tools import blocks as _blocks

BLOCKS = 8  # of SMALL


@pytest.fixture(scope="module")
def small() -> xarray.Dataset:
    return study(PARAMS, **SMALL)


def stop_after(blocks: int, file: Path, **changes: Any) -> None:
    """A study that ends with an error once so many blocks are written."""
    told: list[float] = []

    def tell(part: float, doing: str) -> None:
        told.append(part)
        if part * BLOCKS >= blocks:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt), mock.patch("asperity.studies.study._OFTEN", 0.0):
        study(PARAMS, **{**SMALL, **changes, "progress": tell}, checkpoint=file)


def test_a_checkpoint_holds_what_is_in_memory_without(small: xarray.Dataset, tmp_path: Path) -> None:
    with study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc") as found:
        assert bits(found) == bits(small)
        assert {name: found.attrs[name] for name in small.attrs} == small.attrs
        assert all(found[name].attrs.keys() == small[name].attrs.keys() for name in small.variables)
    assert [path.name for path in tmp_path.iterdir()] == ["found.nc"]
    # A study that is whole is read, not computed.
    with mock.patch.object(_blocks, "completed", side_effect=lambda work, tasks, *_: iter([(0, 0)] if list(tasks) else [])):
        with study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc") as again:
            assert bits(again) == bits(small)


def test_a_study_that_was_stopped_computes_the_rest_alone(small: xarray.Dataset, tmp_path: Path) -> None:
    stop_after(3, tmp_path / "found.nc")
    folder = tmp_path / "found.nc.blocks"
    assert sorted(path.name for path in folder.iterdir()) == [*(f"block-000000{i}.nc" for i in range(3)), "study.json"]
    told: list[str] = []
    given = {**SMALL, "progress": lambda part, doing: told.append(doing)}
    with study(PARAMS, **given, checkpoint=tmp_path / "found.nc", workers=2) as found:
        assert bits(found) == bits(small)
    assert told[0] == "12 of 32 surfaces" and not folder.exists()


def worker(file: Path, flushes: int) -> list[str]:
    """The command of a process with a study, which stands still at so many flushes."""
    return [sys.executable, str(Path(__file__).with_name("study_workers.py")), str(file), str(flushes)]


@contextlib.contextmanager
def standing(file: Path, blocks: int) -> Iterator[subprocess.Popen[str]]:
    """A process with a study that has done so many blocks, and stands still while it writes the next; killed at the end."""
    with subprocess.Popen(worker(file, blocks + 2), stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
        try:
            assert running.stdout is not None and running.stdout.readline() == "standing\n"
            yield running
        finally:
            running.kill()


def test_a_study_that_was_killed_goes_on_with_equal_bits(small: xarray.Dataset, tmp_path: Path) -> None:
    file, folder = tmp_path / "found.nc", tmp_path / "found.nc.blocks"
    with standing(file, 5) as running:
        running.kill()
        assert running.wait() == -signal.SIGKILL
    assert not file.exists() and len(list(folder.glob("*.part"))) == 1
    blocks = sorted(folder.glob("block-???????.nc"))
    assert len(blocks) == 5
    for block in blocks:  # each is whole
        with xarray.open_dataset(block, engine="netcdf4") as one:
            assert one.sizes["sample"] == 4
    told: list[str] = []
    given = {**SMALL, "progress": lambda part, doing: told.append(doing)}
    with study(PARAMS, **given, checkpoint=file) as found:
        assert bits(found) == bits(small)
    assert told[0] == "20 of 32 surfaces" and list(tmp_path.iterdir()) == [file]


def test_a_second_process_is_told_of_the_first(small: xarray.Dataset, tmp_path: Path) -> None:
    file = tmp_path / "found.nc"
    with standing(file, 3) as first:
        second = subprocess.run(worker(file, 1000), capture_output=True, text=True, check=False)
        message = f"checkpoint = '{file}': process {first.pid} of {socket.gethostname()} is at work on it; wait until it is done"
        assert second.returncode == 1 and message in second.stderr
        with pytest.raises(BlockingIOError, match="is at work on it"):
            study(PARAMS, **SMALL, checkpoint=file)
        first.communicate("\n")
        assert first.returncode == 0
    with study(PARAMS, **SMALL, checkpoint=file) as found:
        assert bits(found) == bits(small)
    assert list(tmp_path.iterdir()) == [file]


def test_a_disk_without_locks_is_told_of(tmp_path: Path) -> None:
    with mock.patch.object(lock, "_take", side_effect=OSError(errno.ENOLCK, "No locks available")):
        with pytest.warns(RuntimeWarning, match="found.nc': cannot be locked here .*: let no other process work on it"):
            study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc").close()


@pytest.mark.parametrize("damage", ["empty", "shorter", "longer", "zeros", "another block", "flipped"])
def test_a_block_that_is_damaged_is_computed_anew(damage: str, small: xarray.Dataset, tmp_path: Path) -> None:
    stop_after(3, tmp_path / "found.nc")
    folder = tmp_path / "found.nc.blocks"
    block = folder / "block-0000001.nc"
    whole = block.read_bytes()
    flipped = whole.replace(np.float64(0.01).tobytes(), np.float64(0.02).tobytes())
    block.write_bytes({
        "empty": b"", "shorter": whole[:1000], "longer": whole + b"0", "zeros": whole[:600] + bytes(len(whole) - 600),
        "another block": (folder / "block-0000000.nc").read_bytes(), "flipped": flipped,
    }[damage])  # fmt: skip
    with pytest.warns(RuntimeWarning, match="^[^\n]*block-0000001.nc: damaged[^\n]*$"):
        with study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc") as found:
            assert bits(found) == bits(small)


def test_a_block_that_is_damaged_while_the_study_runs_is_named(small: xarray.Dataset, tmp_path: Path) -> None:
    block = tmp_path / "found.nc.blocks" / "block-0000001.nc"
    given = {**SMALL, "progress": lambda part, doing: block.write_bytes(b"") if part == 1 else None}
    with pytest.raises(OSError, match="block-0000001.nc: damaged since the study began; call again"):
        study(PARAMS, **given, checkpoint=tmp_path / "found.nc")
    with pytest.warns(RuntimeWarning, match="block-0000001.nc"):
        with study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc") as found:
            assert bits(found) == bits(small)


def test_a_disk_that_is_full_leaves_no_half_block(tmp_path: Path) -> None:
    with mock.patch.object(os, "fsync", side_effect=OSError(28, "No space left on device")), pytest.raises(OSError):
        study(PARAMS, **SMALL, checkpoint=tmp_path / "found.nc")
    assert list((tmp_path / "found.nc.blocks").iterdir()) == []


def heights(random: np.random.Generator, count: int) -> Any:
    return random.normal(1.0, 0.1, count)


FLAT: dict[str, Any] = {**SMALL, "vary": {"height_std": 0.3, "slip_stress": 0.2}, "samples": 100}


@contextlib.contextmanager
def computed() -> Iterator[list[int]]:
    """The surfaces that are computed meanwhile."""
    found: list[int] = []
    real = _blocks.completed

    def seen(work: Any, tasks: Any, *rest: Any) -> Any:
        def told() -> Iterator[Any]:
            for first, block in tasks:
                found.extend(range(first, first + len(block.values)))
                yield first, block

        return real(work, told(), *rest)

    with mock.patch.object(_blocks, "completed", seen):
        yield found


@pytest.mark.parametrize("changes", [{}, {"sampling": "random"}, {"vary": {"height_std": heights, "slip_stress": 0.2}}])
def test_a_study_is_enlarged_without_computing_its_first_surfaces(changes: dict[str, Any], tmp_path: Path) -> None:
    file, given = tmp_path / "found.nc", {**FLAT, **changes}
    more = {**given, "samples": 200, "block": 3}
    study(PARAMS, **given, checkpoint=file).close()
    stop_after(7, file, **more)  # of 8: at 175 surfaces
    with computed() as rest, study(PARAMS, **given, checkpoint=file) as found:  # what is there is there until all is
        assert found.sizes["sample"] == 100 and rest == []
    with computed() as rest, study(PARAMS, **more, checkpoint=file) as found:
        assert rest == list(range(175, 200))
        assert bits(found) == bits(study(PARAMS, **more))
    assert list(tmp_path.iterdir()) == [file]
    with computed() as rest:
        study(PARAMS, **{**more, "samples": 300}, checkpoint=file).close()
        assert rest == list(range(200, 300))


@pytest.mark.parametrize(
    "changes", [{"sampling": "latin"}, {"sampling": "saltelli"}, {"vary": {"height_std": 0.3, "slip_stress": [0.01, 0.02]}}]
)
def test_samples_that_depend_on_their_number_are_not_enlarged(changes: dict[str, Any], tmp_path: Path) -> None:
    file, given = tmp_path / "found.nc", {**FLAT, **changes, "samples": 4}
    study(PARAMS, **given, checkpoint=file).close()
    before = file.read_bytes()
    with pytest.raises(ValueError, match="found.nc': has 4 samples, which are not the first of 8; a Latin hypercube, Sobol"):
        study(PARAMS, **{**given, "samples": 8}, checkpoint=file)
    with pytest.raises(ValueError, match="with seed = 5 where this one has 1"):
        study(PARAMS, **{**given, "samples": 8, "seed": 1}, checkpoint=file)
    assert file.read_bytes() == before and list(tmp_path.iterdir()) == [file]


def test_a_damaged_study_is_not_enlarged_but_computed_anew(tmp_path: Path) -> None:
    file, more = tmp_path / "found.nc", {**FLAT, "samples": 12}
    study(PARAMS, **{**FLAT, "samples": 8}, checkpoint=file).close()
    whole = file.read_bytes()
    file.write_bytes(whole.replace(np.float64(100).tobytes(), np.float64(101).tobytes()))
    assert file.read_bytes() != whole
    with computed() as done, pytest.warns(RuntimeWarning, match="found.nc: damaged or changed, all of it is computed anew$"):
        with study(PARAMS, **more, checkpoint=file) as found:
            assert done == list(range(12)) and bits(found) == bits(study(PARAMS, **more))


def test_a_finished_study_with_a_damaged_byte_is_computed_anew(tmp_path: Path) -> None:
    """NetCDF finds such a byte as it is read, with an "HDF error", or not at all."""
    file = tmp_path / "found.nc"
    with study(PARAMS, **FLAT, checkpoint=file) as found:
        right = bits(found)
    whole = file.read_bytes()
    at = whole.index(np.float64(100).tobytes())
    for place in (at, at + 7, len(whole) - 40, len(whole) - 1):
        file.write_bytes(whole[:place] + bytes([whole[place] ^ 4]) + whole[place + 1 :])
        with computed() as done, pytest.warns(RuntimeWarning, match="^[^\n]*found.nc: damaged or changed, all of it is computed anew$"):
            with study(PARAMS, **FLAT, checkpoint=file) as found:
                assert done and bits(found) == right
    with computed() as done, study(PARAMS, **FLAT, checkpoint=file) as found:
        assert done == [] and bits(found) == right


OTHERS: list[tuple[dict[str, Any], str]] = [
    ({"seed": 6}, "seed = 5 where this one has 6"),
    ({"samples": 8}, "samples = 16 where this one has 8"),
    ({"loads": 2 * LOADS}, "loads = '4 from 0.01 to 100' where this one has '4 from 0.02 to 200'"),
    ({"loads": LOADS * [1, 1 + 1e-15, 1, 1]}, "bits of the loads = "),
    ({"vary": {**SMALL["vary"], "height_std": 0.2}}, "vary = .*relative spread 0.3.* where this one has"),
    ({"vary": {**SMALL["vary"], "height_std": stats.norm(10, 1)}}, "vary = .*where this one has '.*scipy.stats.norm"),
    ({"params": PARAMS.replace(asperity_count=2.0)}, "params = 'Params.* where this one has 'Params"),
    ({"sampling": "latin"}, "sampling = 'sobol' where this one has 'latin'"),
    ({"warnings": False}, "warnings = True where this one has False"),
    ({"block": 5}, "block = 4 where this one has 5"),
    ({"params": PARAMS.replace(in_si=True)}, "params = 'Params.* where this one has 'Params"),
]


@pytest.fixture(scope="module", params=["blocks", "file"])
def begun(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A study that was stopped, and one that is whole."""
    file = tmp_path_factory.mktemp("begun") / "found.nc"
    if request.param == "blocks":
        stop_after(2, file)
    else:
        study(PARAMS, **SMALL, checkpoint=file).close()
    return file


@pytest.mark.parametrize("changes, message", OTHERS)
def test_another_study_is_refused(begun: Path, changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=f"found.nc.* is of another study, with {message}.*; give another name, or remove it"):
        study(**{"params": PARAMS, **SMALL, **changes}, checkpoint=begun)


def test_another_version_is_refused(begun: Path) -> None:
    with mock.patch("asperity.studies.study.version", lambda: "9.9.9"):
        with pytest.raises(ValueError, match="with asperity_version = '.*' where this one has '9.9.9'"):
            study(PARAMS, **SMALL, checkpoint=begun)


def test_a_file_that_is_no_study_is_left_as_it_is(tmp_path: Path) -> None:
    (tmp_path / "thesis.nc").write_text("years of work", encoding="utf-8")
    with pytest.raises(ValueError, match="thesis.nc is no study, or damaged; give another name, or remove it"):
        study(PARAMS, **SMALL, checkpoint=tmp_path / "thesis.nc")
    assert (tmp_path / "thesis.nc").read_text(encoding="utf-8") == "years of work"
    xarray.Dataset({"x": ("n", np.ones(3))}).to_netcdf(tmp_path / "other.nc", engine="netcdf4")
    with pytest.raises(ValueError, match="other.nc is no study, or damaged"):
        study(PARAMS, **SMALL, checkpoint=tmp_path / "other.nc")
    with mock.patch("netCDF4.Dataset", side_effect=RuntimeError("NetCDF: HDF error")):
        with pytest.raises(ValueError, match="other.nc is no study, or damaged"):
            study(PARAMS, **SMALL, checkpoint=tmp_path / "other.nc")
    (tmp_path / "mine.nc.blocks").mkdir()
    (tmp_path / "mine.nc.blocks" / "study.json").write_text("[1]", encoding="utf-8")
    with pytest.raises(ValueError, match="mine.nc.blocks is no study, or damaged"):
        study(PARAMS, **SMALL, checkpoint=tmp_path / "mine.nc")


def test_a_folder_that_is_not_there_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match="missing"):
        study(PARAMS, **SMALL, checkpoint=tmp_path / "missing" / "found.nc")


def test_names_are_put_in_place_in_one_step(tmp_path: Path) -> None:
    file = tmp_path / "file"
    with pytest.raises(ZeroDivisionError):
        store._replaced(file, lambda part: part.write_text("half") and 1 / 0)
    assert list(tmp_path.iterdir()) == []
