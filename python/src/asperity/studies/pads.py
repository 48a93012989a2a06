"""Single specimens of few contacts: friction, stiffness and pull-off of each, their mean and how they scatter.

    from asperity import Params, pads

    found = pads(params, loads, 400)
    found.plot("pads.svg")

The sums of the model are means over summits at a given separation. At a given load a specimen stands on the summits that it
happens to have: where few touch, its friction differs from that of the model, and from that of the next one.
"""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
import numpy.typing as npt

from ..errors import Error
from ..model import Model
from ..params import Params
from ..tools import checks
from ..tools.progress import Progress, teller
from ..tools.style import saved, style
from ..units import unit

if TYPE_CHECKING:
    from concurrent.futures import Executor

    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

# States of specimens; more take more than some seconds.
_MANY = 100_000
# Specimens that a worker is given at a time.
_BLOCK = 50
# Parts of the specimens below the quantiles.
_QUANTILES = (0.025, 0.5, 0.975)


class _Range(NamedTuple):
    """Specimens of a surface under loads."""

    params: Params
    sphere_radius: float
    first: int
    specimens: int
    seed: int
    loads: Array


@dataclass(frozen=True, eq=False)
class Pads:
    """Specimens of one surface, under load control on the branch of unloading. Arrays have the shape (specimens, loads).

    Attributes:
        params: the surface; `asperity_count` is the number of asperities of each specimen.
        load: the loads [force], as they were given; shape (loads,).
        friction_force: of each specimen at each load [force]; 0 where it is apart.
        tangential_stiffness: tangential force by displacement while all contacts stick [force/length]; 0 likewise.
        normal_stiffness: minus the slope of the load by the gap [force/length]; 0 likewise.
        gap: between the mean planes [length]; NaN where it is apart.
        contacting: summits in contact.
        apart: whether the load is below the pull-off load of the specimen.
        pull_off_force: the largest pull that each specimen withstands [force], >= 0; shape (specimens,).
        model_force: the friction force of the model at the loads [force]; shape (loads,). NaN for spheres.
        seed: of the random numbers.
        sphere_radius: of rough spheres [length]; 0: they are flat.
    """

    params: Params
    load: Array
    friction_force: Array
    tangential_stiffness: Array
    normal_stiffness: Array
    gap: Array
    contacting: npt.NDArray[np.intp]
    apart: npt.NDArray[np.bool_]
    pull_off_force: Array
    model_force: Array
    seed: int
    sphere_radius: float

    @property
    def count(self) -> int:
        """How many specimens there are."""
        return len(self.friction_force)

    @property
    def mean_force(self) -> Array:
        """Mean friction force over the specimens [force], shape (loads,)."""
        return np.asarray(self.friction_force.mean(axis=0))

    @property
    def scatter(self) -> Array:
        """Standard deviation of the friction force from specimen to specimen over its mean, shape (loads,); NaN where that is 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(self.friction_force.std(axis=0, ddof=1) / self.mean_force)

    @property
    def quantiles(self) -> Array:
        """The friction force that 2.5, 50 and 97.5 % of the specimens do not exceed [force], shape (3, loads)."""
        return np.quantile(self.friction_force, _QUANTILES, axis=0)

    @property
    def bias(self) -> Array:
        """Mean friction force over that of the model, shape (loads,); NaN or infinite where that is 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(self.mean_force / self.model_force)

    @property
    def bias_error(self) -> Array:
        """Standard error of `bias` for this number of independent specimens, shape (loads,); it is a third of that, or less."""
        return np.asarray(self.bias * self.scatter / math.sqrt(self.count))

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws the mean of the specimens with their scatter as a band, and the curve of the model.

        The friction coefficient where all loads press, else the friction force.

        Args:
            file: its ending is its format, for example "pads.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        return _draw(self, file)

    @property
    def _kind(self) -> str:
        if self.sphere_radius:
            return f"{self.count} spheres of radius {self.sphere_radius:g}"
        return f"{self.count} specimens of {self.params.asperity_count:.6g} asperities"

    def __str__(self) -> str:
        lines = [
            self._kind,
            "load  contacts  mean force  mean/model  scatter  95 % of the specimens",
        ]
        low, _, high = self.quantiles
        for i, load in enumerate(self.load):
            bias = self.bias[i]
            against = f"{bias:.3g} +- {self.bias_error[i]:.1g}" if math.isfinite(bias) else "-"
            touching, force = self.contacting[:, i].mean(), self.mean_force[i]
            lines.append(f"{load:.3g}  {touching:.3g}  {force:.3g}  {against}  {self.scatter[i]:.0%}  {low[i]:.3g} to {high[i]:.3g}")
        if self.pull_off_force.any():
            low, median, high = np.quantile(self.pull_off_force, _QUANTILES)
            lines.append(f"pull-off force: {median:.3g}, of 95 % of the specimens {low:.3g} to {high:.3g}")
        return "\n".join(lines)


def pads(
    params: Params,
    loads: npt.ArrayLike,
    count: int = 100,
    *,
    sphere_radius: float = 0.0,
    seed: int = 0,
    progress: Progress = None,
    executor: Executor | None = None,
) -> Pads:
    """Single specimens, whose summits are drawn at random from the heights of the surface.

    Each specimen has `asperity_count` summits, of which only the tallest are drawn where there are many; each obeys the exact
    law of one summit, in contact and out of it. A specimen is unloaded from heavy load: at each load it stands at the nearest
    gap at which its load has fallen to that, so that it jumps over states that could not hold. Below its pull-off load it is apart.

    Args:
        params: the surface, with its true number of summits.
        loads: normal loads [force], one or a one-dimensional array, in any order; also 0 and, with adhesion, negative ones.
        count: number of specimens, 2 or more. 400 give means within 1 %.
        sphere_radius: of rough spheres [length], as beads and balls, which bear on the summits about their lowest point; 0: they are
            flat. Refused where the sphere itself flattens, or has fewer than 3 summits there.
        seed: of the random numbers, >= 0: the same specimens for the same seed, whatever their number and the loads.
        progress: whether to tell how far it is, on the error stream, or a function of the part done, 0 to 1, and of what is
            being done; by default for more than 100,000 states.
        executor: where the specimens are unloaded, by default here: anything with the interface of
            `concurrent.futures.Executor`, with the same result (docs/studies.md).

    Raises:
        Error: what loads, count, seed or the number of summits may not be, or what the library refuses: more than 1e7 summits
            that would have to be drawn.
        TypeError: no `Params`, or no whole numbers.
    """
    checks.instance("params", params, Params)
    sphere_radius = checks.real("sphere_radius", sphere_radius, unit("length", params.in_si))
    load = checks.one_or_more("loads", loads, unit("force", params.in_si))
    count, seed = checks.whole("count", count, 2), checks.whole("seed", seed, 0, 2**64 - 1)
    with Model(params) as model:
        model_force = np.full(load.shape, math.nan) if sphere_radius else model.friction_force_at_load(load)
    values = np.empty((6, count, load.size))
    tell = teller(progress, count * load.size > _MANY, "asperity.pads")
    # The last ones first: they are refused if all are too many.
    blocks = ((i, _Range(params, sphere_radius, i, min(_BLOCK, count - i), seed, load)) for i in reversed(range(0, count, _BLOCK)))
    done = 0
    tell(0.0, "specimens")
    from ..tools.blocks import completed

    for first, found in completed(_unloaded, blocks, executor):
        values[:, first : first + found.shape[1]] = found
        done += found.shape[1]
        tell(done / count, "specimens")
    friction, tangential, normal, gap, contacts, pull_off = values
    arrays = (load, friction, tangential, normal, gap, contacts.astype(np.intp), np.isnan(gap), pull_off[:, 0], model_force)
    for array in arrays:
        array.setflags(write=False)
    return Pads(params, *arrays, seed, sphere_radius)


def _unloaded(asked: _Range) -> Array:
    with Model(asked.params) as model:
        return model.each_specimen_at_loads(
            asked.loads, asked.specimens, sphere_radius=asked.sphere_radius, seed=asked.seed, first=asked.first
        )


def _draw(pads: Pads, file: str | os.PathLike[str] | None) -> Figure:
    """Draws it, and writes it if a file is named."""
    with style():
        from matplotlib.figure import Figure

        order = np.argsort(pads.load)
        load = pads.load[order]
        presses = bool((load > 0).all())
        divisor = load if presses else 1.0
        mean, model = pads.mean_force[order] / divisor, pads.model_force[order] / divisor
        low, _, high = pads.quantiles[:, order] / divisor

        figure = Figure(figsize=(7.5, 5), layout="constrained")
        axes = figure.add_subplot()
        axes.fill_between(load, low, high, color="C0", alpha=0.25, lw=0, label="95 % of the specimens")
        axes.plot(load, mean, "o-", ms=4, color="C0", label=f"mean of {pads._kind}")
        axes.plot(load, model, "--", color="black", label="model: sums at fixed separation")
        if presses:
            axes.set_xscale("log")
        quantity = "friction coefficient $F/P$" if presses else "friction force $F$, in the units of the parameters"
        axes.set(xlabel="normal load $P$ of a specimen, in the units of the parameters", ylabel=quantity)
        axes.set_ylim(bottom=0)
        axes.legend()
        return saved(figure, file)
