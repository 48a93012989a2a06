#!/usr/bin/env python3
"""
How many bytes the shared library may have.

usage: packaging/size.py      checks the library of `cargo build --release`

Of a released library for x86-64, of some 1085 kB on 2026-11-27, 350 kB are the physics and the making of its tables, 180 kB the gaps
between mean planes, the contacts that remember and the estimate of a text, 120 kB the C interface with the vectors for two kinds of
processors, 70 kB the reader of surface files, 120 kB Rust's standard library (numbers as text, panics), the rest tables for unwinding,
addresses and texts. Unloaded joints, and estimates of single specimens, added 110 kB a day
later, contacts that keep their largest load another 21 kB. Smaller code by the compiler (opt-level "s") would save a tenth, and a model would take half as long again to make.
"""

import os
import sys
from pathlib import Path

from targets import ROOT, Refusal, demand_size, run

# A released shared library, stripped: that of Windows has 30 kB more than that of Linux. Who adds a part that is worth its bytes
# raises it.
LIBRARY_LIMIT = 1_455_000
# What gives the functions in the trace of a panic their names: only `make dist` builds Rust's standard library without it. So much
# more than the library for Windows has that of `cargo build` with them.
NAMES_OF_TRACES = 200_000


def main():
    """Checks the library that cargo builds here."""
    run("cargo", "build", "--release", "--locked", "--lib")
    release = Path(os.environ.get("CARGO_TARGET_DIR") or ROOT / "target").resolve() / "release"
    stripped = release / "libasperity.stripped.so"
    run("strip", "-o", stripped, release / "libasperity.so")
    demand_size(stripped, LIBRARY_LIMIT + NAMES_OF_TRACES, "cargo build --release")
    print(f"{stripped.stat().st_size} bytes, of {LIBRARY_LIMIT + NAMES_OF_TRACES} allowed")


if __name__ == "__main__":
    try:
        main()
    except Refusal as refusal:
        sys.exit(f"packaging/size.py: {refusal}")
