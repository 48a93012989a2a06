"""No call trips over a host that traps floating-point exceptions, in NumPy or in the processor."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

USE_EVERYTHING = """
import math
import numpy as np
from asperity import Error, Model, Params

def use_everything(gamma):
    with Model(Params.dimensionless(alpha=0.01, beta=1000, gamma=gamma)) as model:
        pull_off = model.summary().pull_off_load
        loads = np.array([0.0, -0.0, pull_off, 2 * pull_off, -1e300, 5e-324, 1e-300, 1.0, 1e5, 1e12, 1e40])
        for friction in (model.friction_at_load, model.friction_force_at_load):
            friction(loads, slope=True)
            for load in loads:
                friction(float(load))
            for refused in (math.nan, math.inf, 1e300):
                for shape in (refused, [1.0, refused]):
                    try:
                        friction(shape)
                        raise AssertionError("not refused")
                    except Error:
                        pass
        model.state_at_load(10.0)
        for gap in (-50.0, 0.0, 1e3):
            model.state_at_gap(gap)
"""

# FE_INVALID and the like as numbers: 1, 4 and 8 on x86, 1, 2 and 4 on ARM.
TRAPPED = """
import ctypes, platform, sys
FE_INVALID, FE_DIVBYZERO, FE_OVERFLOW = (0x01, 0x04, 0x08) if platform.machine() == "x86_64" else (0x01, 0x02, 0x04)
libm = ctypes.CDLL("libm.so.6")
assert libm.feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW) != -1
"""


def run(source: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", source], capture_output=True, text=True, timeout=600, check=False)


@pytest.mark.parametrize("gamma", [0.0, 0.001, 0.02])
def test_numpy_sees_no_exception(gamma: float) -> None:
    names: dict[str, object] = {}
    exec(USE_EVERYTHING, names)
    with np.errstate(all="raise"):
        names["use_everything"](gamma)  # type: ignore[operator]


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="feenableexcept is of glibc")
def test_traps_do_not_fire() -> None:
    calls = "".join(f"use_everything({gamma})\n" for gamma in (0.0, 0.001, 0.02))
    done = run(USE_EVERYTHING + TRAPPED + calls + "print('alive')")
    assert (done.returncode, done.stdout) == (0, "alive\n"), done.stderr


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="feenableexcept is of glibc")
def test_the_traps_of_that_test_are_set() -> None:
    done = run(TRAPPED + "libm.log.restype = ctypes.c_double\nlibm.log.argtypes = [ctypes.c_double]\nlibm.log(-1.0)")
    assert done.returncode == -8  # SIGFPE
