"""Loads that the steps before let expect: those of `asperity_loads.h`, and the mean of loads that jitter."""

from __future__ import annotations

import ctypes
import os
import random
import subprocess
from pathlib import Path

import pytest

from asperity.loads import PairLoads

INCLUDE = Path(__file__).resolve().parents[2] / "include"
PLACES = 64
IN_C = f"""
#include <asperity_loads.h>
static asperity_body_pair pairs[{PLACES}];
int add(unsigned a, unsigned b, double load) {{ return asperity_pairs_add(pairs, {PLACES}, a, b, load); }}
void end_step(double time, double constant) {{ asperity_pairs_end_step(pairs, {PLACES}, time, constant); }}
double expected(unsigned a, unsigned b, double time) {{ return asperity_pairs_expected(pairs, {PLACES}, a, b, time); }}
"""


@pytest.fixture
def in_c(tmp_path: Path) -> ctypes.CDLL:
    source, library = tmp_path / "loads.c", tmp_path / "loads.so"
    source.write_text(IN_C)
    compiler = os.environ.get("CC", "cc")
    command = [compiler, "-std=c99", "-O2", "-shared", "-fPIC", f"-I{INCLUDE}", str(source), "-o", str(library)]
    subprocess.run(command, check=True)
    loaded = ctypes.CDLL(str(library))
    loaded.add.argtypes = [ctypes.c_uint, ctypes.c_uint, ctypes.c_double]
    loaded.end_step.argtypes = [ctypes.c_double, ctypes.c_double]
    loaded.end_step.restype = None
    loaded.expected.argtypes = [ctypes.c_uint, ctypes.c_uint, ctypes.c_double]
    loaded.expected.restype = ctypes.c_double
    return loaded


@pytest.mark.parametrize("time_constant", [0.0, 0.05])
def test_python_has_the_bits_of_c(in_c: ctypes.CDLL, time_constant: float) -> None:
    loads, drawn, time, known = PairLoads(time_constant), random.Random(1), 0.0, 0
    for _ in range(1000):
        for _ in range(4):
            a, b, load = drawn.randrange(5), drawn.randrange(5), drawn.choice([0.0, drawn.random()])
            loads.add(a, b, load)
            assert in_c.add(a, b, load) == 1
        time += drawn.random() * 0.02
        loads.end_step(time)
        in_c.end_step(time, time_constant)
        for a in range(5):
            for b in range(5):
                then = time + drawn.random() * 0.02
                assert loads.expected(a, b, then) == in_c.expected(b, a, then)
                known += loads.expected(a, b, then) > 0
    assert known > 1000


def test_loads_that_alternate_have_their_mean() -> None:
    loads = PairLoads(time_constant=0.1)
    for step in range(1000):
        loads.add("box", "floor", 2.0 if step % 2 else 6.0)
        loads.end_step(1e-3 * step)
    assert loads.expected("floor", "box", 1.0) == pytest.approx(4.0, rel=0.01)


def test_a_ramp_is_met() -> None:
    loads = PairLoads()
    for step in range(10):
        loads.add(1, 2, 5.0 + step)
        loads.end_step(0.5 * step)
    assert loads.expected(1, 2, 5.0) == pytest.approx(15.0)


@pytest.mark.parametrize("time_constant", [-1.0, float("nan"), float("inf")])
def test_a_time_constant_that_is_none_is_refused(time_constant: float) -> None:
    with pytest.raises(ValueError, match="time_constant = "):
        PairLoads(time_constant)
