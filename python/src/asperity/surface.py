"""From a measured height map to the statistics of its summits, which a friction law is made of.

    from asperity import Params, surface

    print(surface.analyse(surface.read("scan.x3p"), load=1e-3, pair="Si/Si"))    # all in one call, with a verdict

    cleaned = surface.clean(surface.read("scan.x3p"))
    summits = surface.summits(surface.filter(cleaned.map, cutoff=0.2e-6))
    params = Params.from_topography(summits, E1=160e9, ...)

Here are only the names. The search is in `_summit_search`, its statistics in `_summit_statistics`, standard errors in
`_tile_errors`, eq (3) in `_radius_trend`, files in `_instrument_files`, what speaks against a map in `_map_warnings`,
friction against the cutoff in `_map_cutoffs`, the verdict in `_map_analysis`. Needs the extra `topography`, for SciPy and for the files.
"""

from __future__ import annotations

from ._instrument_files import HeightMap, read
from ._map_analysis import Analysis, Finding, analyse
from ._map_cleaning import Cleaned, clean
from ._map_cutoffs import Cutoffs, cutoffs
from ._map_filter import filter
from ._map_steps import Steps
from ._map_warnings import MapWarning
from ._radius_trend import RadiusTrend
from ._summit_statistics import summits
from ._summits import Iso25178, SpectralMoments, Summits
from ._tile_errors import Estimate

__all__ = [
    "Analysis",
    "Cleaned",
    "Cutoffs",
    "Estimate",
    "Finding",
    "HeightMap",
    "Iso25178",
    "MapWarning",
    "RadiusTrend",
    "SpectralMoments",
    "Steps",
    "Summits",
    "analyse",
    "clean",
    "cutoffs",
    "filter",
    "read",
    "summits",
]
