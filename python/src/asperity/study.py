"""Studies of thousands of surfaces whose parameters vary, on one core, on many, or on a cluster.

    from asperity import Params
    from asperity.study import study

    found = study(Params.from_toml("surface.toml"), vary={"height_std": 0.1}, loads=[1e-3, 1e-2], samples=1024)

What is drawn is in `studies.draws`, what a block of surfaces answers in `fits.many_surfaces`, how blocks reach workers in `tools.blocks`,
where they are kept in `studies.store`, by one process at a time in `studies.lock`. Needs xarray, SciPy and netCDF4:
pip install scipy xarray netCDF4.
"""

from .studies.sobol import plot_sobol_indices, sobol_indices
from .studies.study import study

__all__ = ["plot_sobol_indices", "sobol_indices", "study"]
