"""A map pressed against a flat by boundary elements, to check the model: by tamaas, which must be installed."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from ..model import Model
from ..params import Params
from .instrument_files import HeightMap
from .summit_statistics import summits

# Of the middle of a map, along a side.
_POINTS = 512
_TOLERANCE, _ITERATIONS = 1e-6, 10_000
# A grid makes an area larger by this times perimeter times spacing (Yastrebov, Anciaux and Molinari, Tribol. Int. 114 (2017), 161).
_OUTLINE = (math.pi - 1 + math.log(2)) / 24


def ready(_: Any = None) -> Any:
    """The package tamaas.

    Raises:
        ImportError: it is not installed.
    """
    try:
        import tamaas
    except ImportError as error:
        raise ImportError(f"boundary elements need tamaas ({error}): pip install tamaas") from None
    return tamaas


def ratio(map_: HeightMap, pressure: float) -> float:
    """Real area of the model over that of the middle of a filtered map, elastic without adhesion.

    Args:
        map_: the map.
        pressure: nominal pressure over E*.
    """
    rows, columns = (slice((length - _POINTS) // 2, (length + _POINTS) // 2) if length > _POINTS else slice(None) for length in map_.height_map.shape)
    middle = HeightMap(np.ascontiguousarray(map_.height_map[rows, columns]), map_.dx, map_.dy, unit=map_.unit, noise=map_.noise)
    found = summits(middle, progress=False)
    # Its unit of length is that of the heights.
    contact: dict[str, Any] = dict.fromkeys(("composite_modulus", "effective_shear_modulus"), 1.0) | {"work_of_adhesion": 0.0}
    contact |= dict.fromkeys(("adhesion_range", "burgers_vector"), found.iso.Sq)
    with Model(Params.from_topography(found, **contact)) as model:
        area = model.state_at_load(pressure * found.nominal_area).real_area / found.nominal_area
    return area / _area(middle, pressure)


def _area(map_: HeightMap, pressure: float) -> float:
    """Real over nominal area of a map and its mirror images, which are periodic."""
    tamaas = ready()
    half = np.concatenate([map_.height_map, map_.height_map[::-1]])
    heights = np.ascontiguousarray(np.concatenate([half, half[:, ::-1]], axis=1)) / map_.dx
    tamaas.set_log_level(tamaas.LogLevel.error)
    sides = [float(heights.shape[0] * map_.dy / map_.dx), float(heights.shape[1])]
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, sides, list(heights.shape))
    model.E, model.nu = 1.0, 0.0
    solver = tamaas.PolonskyKeerRey(model, heights, _TOLERANCE)
    solver.max_iter = _ITERATIONS
    solver.solve(pressure)
    patches = tamaas.FloodFill.getClusters(np.asarray(model.traction) > 0, False)
    return float(sum(one.area - _OUTLINE * one.perimeter for one in patches)) / heights.size
