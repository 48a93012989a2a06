"""Stands in for a microscope: writes the scan of a random surface, 10 um x 10 um, as a Gwyddion file.

usage: make_scan.py FILE

The surface is self-affine (Hurst exponent 0.8) with waves from 0.2 to 2 um, 5 nm rms, and lies tilted, as samples do.
Made by the package SurfaceTopography, from a fixed seed.
"""

from __future__ import annotations

import sys

import numpy as np
from SurfaceTopography import Topography
from SurfaceTopography.Generation import fourier_synthesis


def main(arguments: list[str]) -> int:
    if len(arguments) != 1:
        print("usage: make_scan.py FILE", file=sys.stderr)
        return 2
    rough = fourier_synthesis(
        (512, 512), (10.0, 10.0), hurst=0.8, rms_height=5e-3, short_cutoff=0.2, long_cutoff=2.0, unit="µm", rng=1
    )
    tilt = np.add.outer(np.linspace(0, 0.05, 512), np.linspace(0, 0.02, 512))
    Topography(rough.heights() + tilt, (10.0, 10.0), unit="µm").to_gwy(arguments[0])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
