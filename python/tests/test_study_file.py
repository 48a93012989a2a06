"""Studies as TOML files, from the command line: what is right gives the same as a call, what is hostile a message."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import xarray
from processes import run_main
from scipy import stats
from test_study_engines import bits, mpiexec

from asperity import Params
from asperity.study import study

SURFACE = """nominal_area = 1e-9
work_of_adhesion = 0.0
adhesion_range = 0.25e-9
burgers_vector = 0.25e-9

[materials]
E1 = 493e9
nu1 = 0.25
E2 = 493e9
nu2 = 0.25

[roughness]
m0 = 9.604e-17
m2 = 1.8e-3
m4 = 3.3736e11
"""
VARY = """
[vary]
height_std = 0.1
summit_radius = [2e-8, 3e-8]
slip_stress = { distribution = "lognorm", s = 0.5, scale = 0.02 }
"""
LOADS = """
[loads]
lowest = 1e-6
highest = 1e-4
count = 3
"""
STUDY = """
[study]
samples = 4
seed = 7
"""
SALTELLI = "\n[vary]\nheight_std = 0.1\nslip_stress = 0.3\n" + LOADS + '[study]\nsamples = 8\nsampling = "saltelli"\nwarnings = false\n'


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "study.toml"
    path.write_text(SURFACE + VARY + LOADS + STUDY, encoding="utf-8")
    return path


def test_the_command_writes_what_a_call_returns(file: Path, tmp_path: Path) -> None:
    done = run_main("study", file, "-o", tmp_path / "found.nc", "--quiet")
    assert done.returncode == 0 and done.stderr == ""
    assert done.stdout == f"{tmp_path / 'found.nc'}: 8 surfaces, 3 loads; 0 refused\n"
    (tmp_path / "surface.toml").write_text(SURFACE, encoding="utf-8")
    called = study(
        Params.from_toml(tmp_path / "surface.toml"),
        {"height_std": 0.1, "summit_radius": [2e-8, 3e-8], "slip_stress": stats.lognorm(s=0.5, scale=0.02)},
        np.geomspace(1e-6, 1e-4, 3),
        4,
        seed=7,
        progress=False,
    )
    with xarray.open_dataset(tmp_path / "found.nc", engine="netcdf4") as found:
        assert bits(found) == bits(called) and found["friction_force"].attrs["units"] == "N"


def test_under_mpiexec_and_on_processes_the_file_is_the_same_to_the_byte(file: Path, tmp_path: Path) -> None:
    assert run_main("study", file, "-o", tmp_path / "here.nc", "--workers", 2, "--quiet").returncode == 0
    words = [mpiexec(), "-n", "3", sys.executable, "-m", "asperity", "study", file, "-o", tmp_path / "mpi.nc", "--mpi", "--quiet"]
    done = subprocess.run(list(map(str, words)), env=os.environ, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0 and done.stdout.count("8 surfaces") == 1, done.stdout + done.stderr
    assert (tmp_path / "mpi.nc").read_bytes() == (tmp_path / "here.nc").read_bytes()


def test_on_dask_the_file_is_the_same_to_the_byte(file: Path, tmp_path: Path) -> None:
    import distributed

    assert run_main("study", file, "-o", tmp_path / "here.nc", "--quiet").returncode == 0
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        done = run_main("study", file, "-o", tmp_path / "dask.nc", "--dask", cluster.scheduler_address, "--quiet")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "dask.nc").read_bytes() == (tmp_path / "here.nc").read_bytes()


def test_indices_are_drawn_and_need_their_sampling(file: Path, tmp_path: Path) -> None:
    wrong = run_main("study", file, "-o", tmp_path / "found.nc", "--indices", tmp_path / "indices.svg")
    assert wrong.returncode == 2 and 'needs sampling = "saltelli"' in wrong.stderr
    file.write_text(SURFACE + SALTELLI, encoding="utf-8")
    done = run_main("study", file, "-o", tmp_path / "found.nc", "--indices", tmp_path / "indices.svg", "--quiet")
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "indices.svg").read_text(encoding="utf-8").startswith("<?xml")


def test_refused_surfaces_are_told(file: Path, tmp_path: Path) -> None:
    file.write_text(SURFACE + "[vary]\nheight_std = [1e-8, -1e-8]\n" + LOADS, encoding="utf-8")
    done = run_main("study", file, "-o", tmp_path / "found.nc", "--quiet")
    assert "2 surfaces, 3 loads; 1 refused" in done.stdout and "# refused, for example: height_std = -1e-" in done.stdout


HOSTILE = [
    (VARY + LOADS + "[stdy]\n", r"line 27: \[stdy\]: no such table"),
    (VARY + LOADS + "[study]\nsample = 3\n", r"\[study\] sample: no such key; the nearest is samples"),
    (VARY + LOADS + "[study]\nsamples = 1.5\n", r"\[study\] samples = 1.5: must be a whole number"),
    (VARY + LOADS + "[study]\nsamples = true\n", r"\[study\] samples = True: must be a whole number"),
    (VARY + LOADS + "[study]\nsamples = 1" + 400 * "0" + "\n", r"\[study\] samples = a number of more than 300 digits: must be from 1"),
    (VARY + LOADS + "[study]\nsamples = 1" + 5000 * "0" + "\n", r"study.toml: .*limit"),
    (VARY + LOADS + "[study]\nsamples = 9000000000000000000\n", r"samples = 9e\+18: must be from 1 to 10000000"),
    (VARY + LOADS + "[study]\nsampling = [1]\n", r"\[study\] sampling = \[1\]: must be one of 'sobol'"),
    (VARY + LOADS + '[study]\nwarnings = "no"\n', r"\[study\] warnings = 'no': must be true or false"),
    (VARY + LOADS + "[study]\nseed = -1\n", r"\[study\] seed = -1: must be from 0"),
    ("study = 3\n" + VARY + LOADS, "line 1: study: no such key"),
    ("vary = 3\n" + VARY + LOADS, "line 1: vary: no such key"),
    (LOADS, r"\[vary\]: must be there"),
    ("[vary]\n" + LOADS, r"\[vary\]: must have one parameter or more"),
    (VARY, r"\[loads\]: must be there"),
    ("[vary]\nheigth_std = 0.1\n" + LOADS, "'heigth_std': no parameter has this name; the nearest is height_std"),
    ('[vary]\n"../../etc/passwd" = 0.1\n' + LOADS, "'../../etc/passwd': no parameter has this name"),
    ('[vary]\nheight_std = "0.1"\n' + LOADS, r"\[vary\] height_std = '0.1': must be a number"),
    ('[vary]\nheight_std = [1, "a"]\n' + LOADS, r"\[vary\] height_std = \[1, 'a'\]: must be a number"),
    ("[vary]\nheight_std = []\n" + LOADS, r"vary height_std: must be a one-dimensional array of one or more real numbers, not of shape \(0,\)"),
    ("[vary]\nheight_std = 10\n" + LOADS, "10 % are 0.1"),
    ("[vary]\nheight_std = 1" + 400 * "0" + "\n" + LOADS, r"\[vary\] height_std = a number of more than 300 digits: must be finite"),
    ("[vary]\nheight_std = {}\n" + LOADS, r"\[vary\] height_std: distribution = None: must be the name of one of scipy.stats"),
    ('[vary]\nheight_std = { distribution = "../norm" }\n' + LOADS, "distribution = '../norm': must be the name"),
    ('[vary]\nheight_std = { distribution = "__doc__" }\n' + LOADS, "distribution = '__doc__': must be the name"),
    ('[vary]\nheight_std = { distribution = "ttest_ind" }\n' + LOADS, "distribution = 'ttest_ind': must be the name"),
    ('[vary]\nheight_std = { distribution = "norm", sigma = 1 }\n' + LOADS, r"\[vary\] height_std: sigma: no such key"),
    ('[vary]\nheight_std = { distribution = "lognorm" }\n' + LOADS, r"\[vary\] height_std: s: must be set for distribution = 'lognorm'"),
    ('[vary]\nheight_std = { distribution = "norm", scale = "1" }\n' + LOADS, r"\[vary\] height_std: scale = '1': must be a number"),
    ('[vary]\nheight_std = { distribution = "norm", scale = -1 }\n' + LOADS, "vary height_std: scipy.stats.norm.* has no values"),
    (VARY + "[loads]\nlowest = 1.0\n", r"\[loads\] highest: must be set, or values"),
    (VARY + "[loads]\nlowest = 2.0\nhighest = 1.0\n", r"\[loads\] lowest = 2 and highest = 1: must be > 0, finite, and ascend"),
    (VARY + "[loads]\nlowest = 1.0\nhighest = inf\n", r"highest = inf: must be > 0, finite"),
    (VARY + "[loads]\nlowest = 1.0\nhighest = 2.0\ncount = 1000000000\n", r"\[loads\] count = 1e\+09: must be from 2 to 100000"),
    (VARY + "[loads]\nvalues = [1.0]\ncount = 3\n", r"\[loads\] values: excludes count"),
    (VARY + "[loads]\nvalues = [[1.0]]\n", r"\[loads\] values = \[\[1.0\]\]: must be a number"),
    (VARY + "[loads]\nvalues = [1.0, nan]\n", r"loads\[1\] = nan: must be finite"),
    (VARY + LOADS + "[vary]\n", "no TOML"),
    (VARY + LOADS + "x = " + 3000 * "[" + "\n", "no TOML|deep inside"),
]  # fmt: skip


@pytest.mark.parametrize("text, message", HOSTILE)
def test_a_hostile_file_gets_a_message_that_names_key_and_value(text: str, message: str, tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    before, after = ("", text) if text.startswith(("[", "\n")) else text.split("\n", 1)  # keys of no table come first
    file.write_text(f"{before}\n{SURFACE}{after}", encoding="utf-8")
    done = run_main("study", file, "-o", tmp_path / "found.nc", "--quiet")
    assert done.returncode == 1 and len(done.stderr.splitlines()) == 1, done.stderr
    assert re.search(message, done.stderr), done.stderr
    assert not (tmp_path / "found.nc").exists()
    assert not (tmp_path / "found.nc.blocks").exists()


def test_a_surface_in_the_file_is_checked_as_in_one_of_its_own(tmp_path: Path) -> None:
    file = tmp_path / "study.toml"
    for change, message in (("E1 = 493e9", "E1"), ("nominal_area = 1e-9", "nominal_area: must be set")):
        file.write_text((SURFACE + VARY + LOADS).replace(change, ""), encoding="utf-8")
        done = run_main("study", file, "-o", tmp_path / "found.nc")
        assert done.returncode == 1 and message in done.stderr


def test_files_that_are_no_text_or_have_no_end_are_refused(tmp_path: Path) -> None:
    (tmp_path / "binary.toml").write_bytes(b"\xff\xfe\x00")
    assert "must be UTF-8" in run_main("study", tmp_path / "binary.toml", "-o", tmp_path / "found.nc").stderr
    done = run_main("study", "/dev/zero", "-o", tmp_path / "found.nc")
    assert done.returncode == 1 and "longer than 1 MiB: must be a study" in done.stderr
    assert run_main("study", tmp_path / "missing.toml", "-o", tmp_path / "found.nc").returncode == 1


def test_engines_exclude_each_other_and_an_output_is_needed(file: Path, tmp_path: Path) -> None:
    assert run_main("study", file).returncode == 2
    assert run_main("study", file, "-o", tmp_path / "x.nc", "--mpi", "--workers", 2).returncode == 2
    done = run_main("study", file, "-o", tmp_path / "x.nc", "--workers", 0)
    assert done.returncode == 1 and "workers = 0: must be from 1 to 1024" in done.stderr
