"""The figure of pads: their mean and scatter over the load, and the curve of the model."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np

from ._style import saved, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .pads import Pads


def draw(pads: Pads, file: str | os.PathLike[str] | None) -> Figure:
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
