"""The figure of a fit: measured and fitted friction over the load, the residuals below."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from .model import Model

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from .fit import Fit

Array = npt.NDArray[np.float64]

_LABELS = {"mu": "friction coefficient $F/P$", "force": "friction force $F$, in the unit of the data"}


def draw(fit: Fit, file: str | os.PathLike[str] | None) -> Figure:
    """Draws it, and writes it if a file is named."""
    try:
        from matplotlib.figure import Figure
    except ImportError as error:
        raise ImportError(f"drawing needs matplotlib ({error}): pip install matplotlib") from None

    figure = Figure(figsize=(7.5, 6), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, gridspec_kw={"height_ratios": (3, 1)})
    linear_to = _linear_to(fit.load)
    if (fit.load > 0).all():
        above.set_xscale("log")
    else:
        above.set_xscale("symlog", linthresh=linear_to)
    if (fit.fitted > 0).all() and (fit.measured > 0).all():
        above.set_yscale("log" if fit.quantity == "force" else "linear")
    above.errorbar(fit.load, fit.measured, yerr=fit.sigma, fmt="o", ms=4, mfc="none", color="black", label="measured")
    load = _loads(fit.load, linear_to)
    with Model(fit.params) as model:
        force = model.friction_force_at_load(load)
        pressing = load[load > 0]
        if pressing.size:
            model.warn(float(pressing.min()), float(pressing.max()))
    named = "\n".join(f"  {name} = {fit.values[name]:.4g} ± {fit.errors[name]:.1g}" for name in fit.free)
    above.plot(load, force / load if fit.quantity == "mu" else force, color="C0", label=f"fitted\n{named}")
    above.set_ylabel(_LABELS[fit.quantity])
    above.legend()

    below.axhline(0, color="C0")
    below.plot(fit.load, fit.residuals, "o", ms=4, mfc="none", color="black")
    below.set(xlabel="normal load $P$, in the unit of the data", ylabel="residual" if fit.sigma is None else r"residual/$\sigma$")
    for axes in (above, below):
        axes.grid(True, alpha=0.3)
    if file is not None:
        figure.savefig(file)
    return figure


def _linear_to(load: Array) -> float:
    """Up to which magnitude the axis of loads is linear where some of them are <= 0."""
    positive = load[load > 0]
    return max(-float(load.min()), float(positive.min()) if positive.size else 0.0) or 1.0


def _loads(measured: Array, linear_to: float) -> Array:
    """Where to draw the curve."""
    lowest, highest = float(measured.min()), float(measured.max())
    if lowest > 0:
        return np.geomspace(lowest, highest, 200)
    light = np.linspace(lowest, min(linear_to, highest), 200)
    return np.concatenate([light, np.geomspace(linear_to, highest, 200)]) if highest > linear_to else light
