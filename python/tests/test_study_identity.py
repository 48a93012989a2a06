"""A block goes on only with the study that it names, and whatever is put in its place comes there in one step."""

from __future__ import annotations

import os
import shutil
import warnings
from pathlib import Path

import numpy as np
import pytest
from study_workers import PARAMS, SMALL
from test_study_checkpoint import stop_after
from test_study_engines import bits

from asperity.studies import lock, store
from asperity.study import study


@pytest.mark.parametrize("other", ["other.nc.blocks/block-0000001.nc", "found.nc.blocks/block-0000000.nc"])
def test_a_block_of_another_study_or_of_other_surfaces_is_computed_anew(other: str, tmp_path: Path) -> None:
    # All is alike but for the draws: neither name, nor size, nor the loads tell the blocks apart.
    stop_after(3, tmp_path / "found.nc")
    stop_after(3, tmp_path / "other.nc", seed=6)
    shutil.copyfile(tmp_path / other, tmp_path / "found.nc.blocks/block-0000001.nc")
    told: list[str] = []
    given = {**SMALL, "progress": lambda part, doing: told.append(doing)}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # that the block is not as it was
        found = study(PARAMS, **given, checkpoint=tmp_path / "found.nc")
    with found:
        assert bits(found) == bits(study(PARAMS, **SMALL))
        others = study(PARAMS, **{**SMALL, "seed": 6})
        assert not np.array_equal(found["height_std"], others["height_std"])
    assert told[0] == "8 of 32 surfaces"  # two of the three blocks


def test_what_replaces_a_file_is_what_was_written_and_flushed_not_a_copy(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A copy is there in part while it is made, and is lost with the power where only its source was flushed."""
    file, seen = tmp_path / "found.nc", []
    file.write_text("old")
    os.link(file, tmp_path / "kept")
    fsync = os.fsync

    def flushed(descriptor: int) -> None:
        seen.append((os.fstat(descriptor).st_ino, file.read_text()))
        fsync(descriptor)

    monkeypatch.setattr(os, "fsync", flushed)
    store._replaced(file, lambda part: part.write_text("new"))
    # Until it is on the disk the old one is in its place, and the name then goes to the very file that was flushed.
    assert (file.stat().st_ino, "old") in seen
    # The old one was written over in no part.
    assert file.read_text() == "new" and (tmp_path / "kept").read_text() == "old"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["found.nc", "kept"]


def test_a_lock_is_that_of_the_file_that_is_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Its holder may remove the file just before it is locked: another process would then lock a file of its own."""
    file, take = tmp_path / "found.nc.lock", lock._take
    removed: list[Path] = []

    def late(descriptor: int) -> None:
        take(descriptor)
        if not removed:
            file.unlink()
            removed.append(file)

    monkeypatch.setattr(lock, "_take", late)
    with lock.locked(file, "found.nc"):
        assert removed and file.exists()
