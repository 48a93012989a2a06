"""One summit: the library, with heights that hardly differ, against rows of 50 digits and against the package Adhesion.

Adhesion (Pastewka and others, MIT licence) has Maugis' equations in code of its own. The library has no call for a
single summit; one whose height has the standard deviation sigma answers within (sigma/D)^2, D the overlap, of one that
has none.
"""

from __future__ import annotations

import csv
import math
from functools import lru_cache

import numpy as np
import pytest
from Adhesion.ReferenceSolutions import MaugisDugdale

import one_summit
from asperity import Model, Params

# E* = h = 1. The least sigma/h and (sigma/R)^(1/2) that the library evaluates.
RADIUS, SIGMA, BURGERS_VECTOR = 1e4, 2e-6, 0.01
K = 4 / 3


def frozen() -> list[dict[str, str]]:
    with one_summit.FILE.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


ROWS = frozen()
CONTACTS = [row for row in ROWS if row["a"]]
PULL_OFFS = [row for row in ROWS if not row["a"]]


class Summit:
    """The library's summit of this lambda, and Maugis' units in those of the library."""

    def __init__(self, lam: float) -> None:
        self.work = math.sqrt(lam**3 * math.pi * K**2 / (8 * RADIUS))
        self.load = math.pi * self.work * RADIUS
        self.radius = (self.load * RADIUS / K) ** (1 / 3)
        self.overlap = self.radius**2 / RADIUS
        self.model = Model(
            Params.si(
                composite_modulus=1.0, effective_shear_modulus=1.0, work_of_adhesion=self.work, adhesion_range=1.0,
                burgers_vector=BURGERS_VECTOR, height_std=SIGMA, summit_radius=RADIUS, asperity_count=1.0,
            )
        )  # fmt: skip

    def tolerance(self, overlap: float) -> float:
        return 1e-10 + (SIGMA / (self.overlap * overlap)) ** 2


@lru_cache(maxsize=None)
def summit_of(lam: float) -> Summit:
    return Summit(lam)


def identity(row: dict[str, str]) -> str:
    return f"lambda={row['lambda']}-a={row['a'] or 'pull-off'}"


@pytest.mark.parametrize("row", CONTACTS, ids=identity)
def test_the_library_agrees_with_50_digits(row: dict[str, str]) -> None:
    summit = summit_of(float(row["lambda"]))
    state = summit.model.state_at_load(float(row["load"]) * summit.load)
    tolerance = summit.tolerance(float(row["overlap"]))
    assert math.sqrt(state.real_area / math.pi) / summit.radius == pytest.approx(float(row["a"]), rel=tolerance)
    assert -state.gap / summit.overlap == pytest.approx(float(row["overlap"]), rel=tolerance)


@pytest.mark.parametrize("row", CONTACTS, ids=identity)
def test_the_library_agrees_with_the_package_adhesion(row: dict[str, str]) -> None:
    lam, a = float(row["lambda"]), float(row["a"])
    summit = summit_of(lam)
    stress = summit.work  # over the range h = 1
    load, overlap = MaugisDugdale.load_and_displacement(np.array([a * summit.radius]), RADIUS, 1.0, summit.work, stress)
    tolerance = summit.tolerance(float(row["overlap"]))
    state = summit.model.state_at_load(float(load[0]))
    assert math.sqrt(state.real_area / math.pi) == pytest.approx(a * summit.radius, rel=tolerance)
    assert -state.gap == pytest.approx(float(overlap[0]), rel=tolerance)


@pytest.mark.parametrize("row", PULL_OFFS, ids=identity)
def test_the_pull_off_load_is_that_of_one_summit(row: dict[str, str]) -> None:
    """As lambda goes to 0 the load has a kink where contact begins, and heights count by the first power of sigma/h."""
    lam = float(row["lambda"])
    summit = summit_of(lam)
    tolerance = 1e-9 if lam >= 0.1 else 2 * SIGMA
    assert summit.model.summary().pull_off_load / summit.load == pytest.approx(float(row["load"]), rel=tolerance)


def test_the_rows_are_what_their_script_writes() -> None:
    written = [dict(zip(one_summit.COLUMNS, line)) for line in one_summit.rows()]
    assert written == ROWS
