"""Pads of few contacts: what was found of them, and its figure."""

from __future__ import annotations

import math
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from ..params import Params
from ..tools.style import saved, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Pads:
    """Pads of one surface, under load control on the branch of unloading. Arrays of pads have the shape (pads, loads).

    Attributes:
        params: the surface; `asperity_count` is the number of summits of each pad.
        load: the loads [force], as they were given.
        friction_force: of each pad at each load [force]; 0 where it is apart.
        contacting: summits in contact.
        apart: whether the load is below the pull-off load of the pad.
        model_force: the friction force of the model at the loads [force].
        seed: of the random numbers.
    """

    params: Params
    load: Array
    friction_force: Array
    contacting: npt.NDArray[np.intp]
    apart: npt.NDArray[np.bool_]
    model_force: Array
    seed: int

    @property
    def count(self) -> int:
        """How many pads there are."""
        return len(self.friction_force)

    @property
    def mean_force(self) -> Array:
        """Mean friction force over the pads [force], shape (loads,)."""
        return np.asarray(self.friction_force.mean(axis=0))

    @property
    def scatter(self) -> Array:
        """Standard deviation of the friction force from pad to pad over its mean, shape (loads,); NaN where that is 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(self.friction_force.std(axis=0, ddof=1) / self.mean_force)

    @property
    def bias(self) -> Array:
        """Mean friction force over that of the model, shape (loads,); NaN or infinite where that is 0."""
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(self.mean_force / self.model_force)

    @property
    def bias_error(self) -> Array:
        """Standard error of `bias` for this number of pads, shape (loads,)."""
        return np.asarray(self.bias * self.scatter / math.sqrt(self.count))

    def plot(self, file: str | os.PathLike[str] | None = None) -> Figure:
        """Draws the mean of the pads with their scatter as a band, and the curve of the model.

        The friction coefficient where all loads press, else the friction force.

        Args:
            file: its ending is its format, for example "pads.svg".

        Raises:
            ImportError: matplotlib is missing.
        """
        return _draw(self, file)

    def __str__(self) -> str:
        lines = [
            f"{self.count} pads of {round(self.params.asperity_count)} summits",
            "load  contacts  mean force  mean/model  scatter",
        ]
        contacts = self.contacting.mean(axis=0)
        for load, touching, force, bias, error, scatter in zip(
            self.load, contacts, self.mean_force, self.bias, self.bias_error, self.scatter
        ):
            against = f"{bias:.3g} +- {error:.1g}" if math.isfinite(bias) else "-"
            lines.append(f"{load:.3g}  {touching:.3g}  {force:.3g}  {against}  {scatter:.0%}")
        return "\n".join(lines)


def _draw(pads: Pads, file: str | os.PathLike[str] | None) -> Figure:
    """Draws it, and writes it if a file is named."""
    with style():
        from matplotlib.figure import Figure

        order = np.argsort(pads.load)
        load = pads.load[order]
        presses = bool((load > 0).all())
        divisor = load if presses else 1.0
        mean, model = pads.mean_force[order] / divisor, pads.model_force[order] / divisor
        deviation = pads.friction_force.std(axis=0, ddof=1)[order] / divisor

        figure = Figure(figsize=(7.5, 5), layout="constrained")
        axes = figure.add_subplot()
        axes.fill_between(load, np.maximum(mean - deviation, 0), mean + deviation, color="C0", alpha=0.25, lw=0,
                          label="standard deviation from pad to pad")  # fmt: skip
        named = f"mean of {pads.count} pads of {round(pads.params.asperity_count)} summits"
        axes.plot(load, mean, "o-", ms=4, color="C0", label=named)
        axes.plot(load, model, "--", color="black", label="model: sums at fixed separation")
        if presses:
            axes.set_xscale("log")
        quantity = "friction coefficient $F/P$" if presses else "friction force $F$, in the units of the parameters"
        axes.set(xlabel="normal load $P$ of a pad, in the units of the parameters", ylabel=quantity)
        axes.set_ylim(bottom=0)
        axes.legend()
        return saved(figure, file)
