"""Sobol' indices: which part of the variance of friction each parameter causes, at each load.

First order by Saltelli et al. (Comput. Phys. Commun. 181 (2010), 259), table 2 (b), total by Jansen's estimator, (f) there.
`scipy.stats.sobol_indices` has the same ones, but only for numbers of samples that are powers of 2: surfaces that the library
refuses leave others.
"""

from __future__ import annotations

import math
import os
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..tools import checks
from ..tools.style import DASHES, saved, style

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

# Fewer rows say nothing of a variance.
_FEWEST = 8
# Loads at a time, which bounds the memory of samples drawn again.
_LOADS = 16


def sobol_indices(
    found: xarray.Dataset,
    quantity: str = "friction_coefficient",
    *,
    coverage: float = 0.95,
    resamples: int = 200,
    seed: int = 0,
) -> xarray.Dataset:
    """Sobol' indices of a study with `sampling="saltelli"`, of each parameter at each load.

    The first-order index is the part of the variance that is gone once the parameter is known; the total index the part that
    stays while it alone is not. They differ where parameters act together.

    Args:
        found: what `study` returned.
        quantity: "friction_coefficient", "friction_force" or "tangential_stiffness".
        coverage: the probability that the bands are to have, which follow from samples drawn again (bootstrap).
        resamples: how often they are drawn again.
        seed: of the random numbers.

    Returns:
        A dataset of (parameter, load): first_order and total_order, each with _low and _high; and of each load `rows`, the
        samples in which no surface was refused. The others are left out. NaN where nothing varies.

    Raises:
        Error: a study that was sampled otherwise, another quantity, or too few rows.
    """
    if not hasattr(found, "attrs"):
        raise TypeError(f"found = {found!r}: must be what asperity.study.study returns")
    if found.attrs.get("sampling") != "saltelli":
        raise Error(
            f'found: a study with sampling = {found.attrs.get("sampling")!r}; Sobol\' indices need sampling="saltelli"'
        )
    checks.word("quantity", quantity, ("friction_coefficient", "friction_force", "tangential_stiffness"))
    coverage = checks.share("coverage", coverage)
    resamples, seed = checks.whole("resamples", resamples, 2, 100_000), checks.whole("seed", seed, 0)
    import xarray

    rows = int(found.attrs["samples"])
    names = str(found.attrs["parameters"]).split()
    loads, random = found.sizes["load"], np.random.default_rng(seed)
    values = np.full((6, len(names), loads), math.nan)
    kept = np.zeros(loads, dtype=np.int64)
    for first in range(0, loads, _LOADS):
        part = np.asarray(found[quantity][:, first : first + _LOADS].values, dtype=np.float64)
        sheets = part.reshape(len(names) + 2, rows, -1)
        for i in range(sheets.shape[2]):
            whole = sheets[:, np.isfinite(sheets[:, :, i]).all(axis=0), i]
            kept[first + i] = whole.shape[1]
            if whole.shape[1] < _FEWEST:
                raise Error(
                    f"found: only {whole.shape[1]} of {rows} rows are whole at the load {float(found['load'][first + i]):g}; "
                    f"indices need {_FEWEST} or more"
                )
            values[:, :, first + i] = _with_bands(whole, coverage, int(resamples), random)
    data = {
        f"{kind}_order{end}": (("parameter", "load"), values[3 * k + j])
        for k, kind in enumerate(("first", "total"))
        for j, end in enumerate(("", "_low", "_high"))
    }
    coordinates = {"parameter": names, "load": ("load", found["load"].values, found["load"].attrs)}
    about = {"quantity": quantity, "coverage": coverage, **{k: found.attrs[k] for k in ("asperity_version", "seed", "vary")}}
    return xarray.Dataset({**data, "rows": ("load", kept)}, coordinates, about)


def _with_bands(sheets: Array, coverage: float, resamples: int, random: np.random.Generator) -> Array:
    """First-order and total indices, each with the ends of its band: (6, names); rows of sheets are A, B and A with columns of B."""
    a, b, ab = sheets[0], sheets[1], sheets[2:]
    middle = np.mean(sheets[:2])
    a, b, ab = a - middle, b - middle, ab - middle
    # All that the indices are made of are means over rows.
    of_rows = np.vstack([a, b, a**2, b**2, b * (ab - a), (a - ab) ** 2])
    weights = np.vstack([np.ones(a.size), random.multinomial(a.size, np.full(a.size, 1 / a.size), resamples)]) / a.size
    means = weights @ of_rows.T
    variance = ((means[:, 2] + means[:, 3]) / 2 - ((means[:, 0] + means[:, 1]) / 2) ** 2)[:, None]
    # Of numbers that are equal but for rounding there is no variance to divide.
    variance[variance <= (1e-12 * middle) ** 2] = math.nan
    n = len(ab)
    found = np.stack([means[:, 4 : 4 + n], means[:, 4 + n :] / 2]) / variance
    ends = np.quantile(found[:, 1:], [0.5 - 0.5 * coverage, 0.5 + 0.5 * coverage], axis=1)
    return np.concatenate([np.stack([found[k, 0], ends[0, k], ends[1, k]]) for k in range(2)])


def plot_sobol_indices(indices: xarray.Dataset, file: str | os.PathLike[str] | None = None) -> Figure:
    """Draws which input matters at which load: total and first-order indices over the load, with the bands of the total ones.

    Args:
        indices: what `sobol_indices` returned.
        file: its ending is its format, for example "indices.svg".

    Raises:
        ImportError: matplotlib is missing.
    """
    with style():
        from matplotlib.figure import Figure

        figure = Figure(figsize=(5.0, 4.8), layout="constrained")
        axes = figure.add_subplot()
        order = np.argsort(indices["load"].values)
        load = indices["load"].values[order]
        for i, name in enumerate(indices.parameter.values):
            one: Any = indices.sel(parameter=name)
            (line,) = axes.plot(load, one.total_order.values[order], ls=DASHES[i % len(DASHES)], label=str(name))
            colour = line.get_color()
            axes.plot(load, one.first_order.values[order], color=colour, lw=0.8, ls=DASHES[i % len(DASHES)])
            low, high = one.total_order_low.values[order], one.total_order_high.values[order]
            axes.fill_between(load, low, high, color=colour, alpha=0.2, lw=0)
        if (load > 0).all():
            axes.set_xscale("log")
        quantity = str(indices.attrs["quantity"]).replace("_", " ")
        unit = indices["load"].attrs.get("units", "force")
        axes.set(xlabel=f"normal load $P$ [{unit}]", ylabel=f"part of the variance of the {quantity} [–]")
        axes.set_ylim(-0.02, max(1.05, 1.05 * float(indices["total_order"].max())))
        figure.suptitle("Which input matters at which load", x=0.02, ha="left", weight="bold", fontsize=11)
        axes.set_title("thick: total index; thin: first order", loc="left", fontsize=9.5)
        figure.legend(*axes.get_legend_handles_labels(), loc="outside lower left", ncols=2, handlelength=3.5, fontsize=9)
        return saved(figure, file)
