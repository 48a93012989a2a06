"""From a measured height map to its heights and slopes, which a friction law is made of.

    from asperity import Params, surface

    print(surface.analyse(surface.read("scan.x3p"), load=1e-3, pair="Si/Si"))    # all in one call, with a verdict

    cleaned = surface.clean(surface.read("scan.x3p"))
    summits = surface.summits(surface.filter(cleaned.map, cutoff=0.2e-6))
    params = Params.from_topography(summits, E1=160e9, ...)

Here are only the names. Heights and slopes at normal scores are in `maps.at_scores`, summits in `maps.summit_search` and `maps.summit_statistics`,
standard errors in `maps.tile_errors`, files in `maps.instrument_files`, what speaks against a map in `maps.map_warnings`, friction against the
cutoff in `maps.cutoffs`, the verdict in `maps.analysis`. Needs the extra `topography`, for SciPy and for the files.
"""

from __future__ import annotations

from .maps.analysis import Analysis, Finding, analyse
from .maps.at_scores import AtScores
from .maps.cleaning import Cleaned, clean
from .maps.cutoffs import Cutoffs, cutoffs
from .maps.filter import filter
from .maps.instrument_files import HeightMap, read
from .maps.map_warnings import MapWarning
from .maps.steps import Steps
from .maps.summit_statistics import summits
from .maps.summits import Iso25178, SpectralMoments, Summits
from .maps.tile_errors import Estimate

__all__ = [
    "Analysis",
    "AtScores",
    "Cleaned",
    "Cutoffs",
    "Estimate",
    "Finding",
    "HeightMap",
    "Iso25178",
    "MapWarning",
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
