"""Rows of one summit after Maugis (J. Colloid Interface Sci. 150 (1992), 243), to 50 digits.

In his units: contact radius a in (pi w R^2/K)^(1/3), load P in pi w R, overlap D in (pi^2 w^2 R/K^2)^(1/3), K = 4 E*/3,
and lambda = 2 (w/h)/(pi w K^2/R)^(1/3). With m = c/a and mu = (m^2 - 1)^(1/2),

    lambda a^2/2 (mu + (m^2 - 2) atan mu) + 4 lambda^2 a/3 (mu atan mu - m + 1) = 1
    P = a^3 - lambda a^2 (mu + m^2 atan mu)          D = a^2 - 4/3 lambda a mu

usage: one_summit.py [FILE.csv]     computes the rows anew and writes one_summit.csv
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

from mpmath import mp, mpf

FILE = Path(__file__).with_name("one_summit.csv")
COLUMNS = ["lambda", "a", "load", "overlap"]
LAMBDAS = ("0.01", "0.1", "0.3", "0.655", "1", "2", "5")
# All on the unloading branch: JKR's summits let go at a = 1.14.
RADII = ("1.5", "2", "3", "5", "10", "30")

# Digits carried: the two brackets lose some ten of them where the load is heavy.
mp.dps = 75


def gap(m: mpf, a: mpf, lam: mpf) -> mpf:
    """The first equation, less its right side: the gap at the edge of the ring, less h."""
    mu = mp.sqrt(m * m - 1)
    angle = mp.atan(mu)
    return lam * a**2 / 2 * (mu + (m * m - 2) * angle) + 4 * lam**2 * a / 3 * (mu * angle - m + 1) - 1


def row(lam: mpf, a: mpf) -> tuple[mpf, mpf]:
    """Load and overlap of a contact radius."""
    above = mpf(2)
    while gap(above, a, lam) < 0:
        above *= 2
    m = mp.findroot(lambda x: gap(x, a, lam), (mpf(1), above), solver="anderson", tol=mpf(10) ** -140)
    mu = mp.sqrt(m * m - 1)
    return a**3 - lam * a**2 * (mu + m * m * mp.atan(mu)), a**2 - mpf(4) / 3 * lam * a * mu


def ring(theta: mpf, lam: mpf) -> mpf:
    """The load in terms of theta = acos(a/c), regular where the contact ends with a = 0 at theta = pi/2."""
    sine, cosine = mp.sin(theta), mp.cos(theta)
    k2 = lam / 2 * (sine * cosine + (1 - 2 * cosine**2) * theta)
    k1 = 4 * lam**2 / 3 * (theta * sine - 1 + cosine)
    c = 2 / (k1 + mp.sqrt(k1**2 + 4 * k2))
    return (c * cosine) ** 3 - lam * c**2 * (sine * cosine + theta)


def pull_off(lam: mpf) -> mpf:
    """The least load: inside, or where the contact has shrunk to a point."""
    steps = [mp.pi / 2 * i / 64 for i in range(4, 65)]
    least = min(range(len(steps)), key=lambda i: ring(steps[i], lam))
    if least + 1 == len(steps):
        return ring(steps[-1], lam)
    low, high = steps[least - 1], steps[least + 1]
    # The error of the least value is the square of that of its place.
    for _ in range(200):
        third = (high - low) / 3
        if ring(low + third, lam) < ring(high - third, lam):
            high -= third
        else:
            low += third
    return ring((low + high) / 2, lam)


def rows() -> list[list[str]]:
    """Lines of the file; the pull-off load is the line with neither radius nor overlap."""
    lines = []
    for lam in LAMBDAS:
        for a in RADII:
            lines.append([lam, a, *(mp.nstr(number, 50) for number in row(mpf(lam), mpf(a)))])
        lines.append([lam, "", mp.nstr(pull_off(mpf(lam)), 50), ""])
    return lines


def main(file: Path) -> None:
    with file.open("w", encoding="utf-8", newline="") as out:
        out.write("# Written by tests/validation/one_summit.py; the line without a radius is the pull-off load.\n")
        table = csv.writer(out, lineterminator="\n")
        table.writerow(COLUMNS)
        table.writerows(rows())


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else FILE)
