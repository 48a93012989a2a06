"""What the Python package says to the questions on standard input, one JSON object, as JSON on standard output.

maps: .npy files with a distance of points [m] and a power of ten of the unit of the heights; answered with their moments.
areal: areal parameters; answered with the moments, from the parameters that `Params.from_iso25178` makes.
texts: nothing; answered with loads and what the curve of a solver has at them, for each text of the Python package's test of doors.
"""

import contextlib
import json
import math
import re
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np

import asperity
from asperity import Params, surface
from asperity.estimate import estimate


def moments(file: str, step: float, power: int) -> dict[str, float]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # small maps: what is asked for are the moments
        found = surface.summits(np.load(file).astype(float) * 10.0**power, dx=step)
    of = found.moments
    return {"m0": of.m0, "m2": of.m2, "m4": of.m4, "isotropy": found.isotropy, "area": found.nominal_area}


def areal(given: dict[str, float], nominal_area: float) -> dict[str, float]:
    contact = asperity.materials.PAIRS["Si/Si"].contact
    params = Params.from_iso25178(**given, nominal_area=nominal_area, **contact)
    return {name: getattr(params, name) for name in ("height_std", "summit_radius", "asperity_count")}


def texts() -> dict[str, dict[str, list[float]]]:
    sys.path.insert(0, str(Path(__file__).parents[2] / "python" / "tests"))
    import test_doors

    found = {}
    for text in test_doors.texts():
        load = np.array([1e5, 1e7]) * float(re.findall(r"nominal_area = (\S+)", text)[0])
        with contextlib.suppress(asperity.Error):
            found[text] = {"load": load.tolist(), "curve": estimate(text, load).curve.tolist()}
    return found


def finite(value: Any) -> Any:
    """JSON has no other numbers."""
    if isinstance(value, dict):
        return {name: finite(one) for name, one in value.items()}
    if isinstance(value, list):
        return [finite(one) for one in value]
    assert math.isfinite(value), value
    return float(value)


ANSWERS = {"maps": moments, "areal": areal, "texts": texts}
questions = json.load(sys.stdin)
json.dump({kind: [finite(ANSWERS[kind](*one)) for one in asked] for kind, asked in questions.items()}, sys.stdout)
